//! Helpers on core terms: occurrence and replacement of variables, and keys that identify terms.

use crate::{Node, Term};
use std::collections::{BTreeMap, BTreeSet};
use std::fmt::Write as _;
use std::sync::Arc;
use torse_numbers::fault_injection::{InjectedFault, injected};

/// The largest length of a key.
const MAX_KEY: usize = 60_000;

/// Whether the variable of this number occurs. Each binder has a variable of its own, so no scopes need be tracked.
pub(super) fn mentions(term: &Term, number: u32) -> bool {
    let mut seen = BTreeSet::new();
    let mut pending = vec![term];
    while let Some(term) = pending.pop() {
        if !seen.insert(Arc::as_ptr(&term.node).addr()) {
            continue;
        }
        if matches!(&*term.node, Node::Variable(variable) if variable.number() == number) {
            return true;
        }
        pending.extend(term.parts());
        if let Node::Basis { family, .. } = &*term.node
            && !injected(InjectedFault::SeedOverlooked)
        {
            pending.extend(family.formulas());
        }
    }
    false
}

/// Whether the term contains nothing whose value may vary.
pub(super) fn is_number(term: &Term) -> bool {
    match &*term.node {
        Node::Symbol(_)
        | Node::Vector(..)
        | Node::Member(..)
        | Node::Variable(_)
        | Node::Basis { .. }
        | Node::Derivative { .. } => false,
        _ => term.parts().into_iter().all(is_number),
    }
}

/// Replaces a variable by a term.
pub(super) fn replaced(term: &Term, number: u32, by: &Term) -> Term {
    let mut cache: BTreeMap<usize, Term> = BTreeMap::new();
    replace(term, number, by, &mut cache)
}

fn replace(term: &Term, number: u32, by: &Term, cache: &mut BTreeMap<usize, Term>) -> Term {
    if matches!(&*term.node, Node::Variable(variable) if variable.number() == number) {
        return by.clone();
    }
    if !mentions(term, number) {
        return term.clone();
    }
    let address = Arc::as_ptr(&term.node).addr();
    if let Some(known) = cache.get(&address) {
        return known.clone();
    }
    let mut parts =
        |part: &Term| Ok::<_, std::convert::Infallible>(replace(part, number, by, cache));
    let changed = match term.with_parts(&mut parts) {
        Ok(changed) => changed,
        Err(impossible) => match impossible {},
    };
    let changed = match &*changed.node {
        Node::Basis {
            family,
            index,
            degree,
            arguments,
        } if family.formulas().any(|formula| mentions(formula, number)) => Term {
            node: Arc::new(Node::Basis {
                family: Arc::new(
                    family.with_formulas(|formula| replace(formula, number, by, cache)),
                ),
                index: index.clone(),
                degree: degree.clone(),
                arguments: arguments.clone(),
            }),
            place: changed.place,
        },
        _ => changed,
    };
    // What was put into the body of a definition is not what its name says, even if nothing of a binder is left.
    let closed = match &*changed.node {
        Node::Opened {
            name, origin, body, ..
        } => Some(Node::Opened {
            name: Arc::clone(name),
            origin: Arc::clone(origin),
            closed: false,
            body: body.clone(),
        }),
        Node::Derivative {
            variable,
            order,
            body,
            at,
            ..
        } => Some(Node::Derivative {
            variable: variable.clone(),
            order: order.clone(),
            closed: body.is_closed_but_for(variable.number()),
            body: body.clone(),
            at: at.clone(),
        }),
        _ => None,
    };
    let changed = match closed {
        Some(node) => Term {
            node: Arc::new(node),
            place: changed.place,
        },
        None => changed,
    };
    cache.insert(address, changed.clone());
    changed
}

/// A text that is equal for terms that are written alike, up to the names of bound variables and definitions; `None`
/// for very large terms.
pub(super) fn key(term: &Term) -> Option<String> {
    let mut text = String::new();
    let mut variables = BTreeMap::new();
    write(term, &mut variables, &mut text)?;
    Some(text)
}

fn write(term: &Term, variables: &mut BTreeMap<u32, usize>, text: &mut String) -> Option<()> {
    if text.len() > MAX_KEY {
        return None;
    }
    let bound = |number: u32, variables: &mut BTreeMap<u32, usize>| {
        let next = variables.len();
        *variables.entry(number).or_insert(next)
    };
    let written = match &*term.node {
        Node::Opened { body, .. } => return write(body, variables, text),
        Node::Number(value) => write!(text, "#{value}"),
        Node::Pi => write!(text, "pi"),
        Node::Symbol(name) => write!(text, "s{{{name}}}"),
        Node::Variable(variable) => write!(text, "v{}", bound(variable.number(), variables)),
        Node::Vector(name, dimension) => write!(text, "w{{{name}}}{dimension:?}"),
        Node::Member(points, _) => write!(text, "m{{{}}}", points.name),
        // The seeds may contain a variable that `at` or `D` puts in the place of a symbol.
        Node::Basis { family, .. } if !family.closed => {
            write!(text, "b{{{}", family.name).ok()?;
            for formula in family.formulas() {
                text.push(',');
                write(formula, variables, text)?;
            }
            write!(text, "}}")
        }
        Node::Basis { family, .. } => write!(text, "b{{{}}}", family.name),
        Node::Negative(_) => write!(text, "-"),
        Node::Binary(operator, ..) => write!(text, "{}", operator.sign()),
        Node::List(_) => write!(text, "list"),
        Node::Entry(..) => write!(text, "entry"),
        Node::Sum { index, .. } => write!(text, "sum v{}", bound(index.number(), variables)),
        Node::Product { index, .. } => {
            write!(text, "product v{}", bound(index.number(), variables))
        }
        Node::Integral { variable, .. } => {
            write!(text, "integral v{}", bound(variable.number(), variables))
        }
        Node::Let { variable, .. } => write!(text, "let v{}", bound(variable.number(), variables)),
        Node::Derivative { variable, .. } => {
            write!(text, "d v{}", bound(variable.number(), variables))
        }
        Node::Apply(function, _) => write!(text, "{function:?}"),
    };
    written.ok()?;
    let parts = term.parts();
    if parts.is_empty() {
        return Some(());
    }
    text.push('(');
    for part in parts {
        write(part, variables, text)?;
        text.push(',');
    }
    text.push(')');
    Some(())
}
