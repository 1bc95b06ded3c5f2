//! Existential claims: each symbol that a claim says to exist is replaced by a witness.
//!
//! "For all values of the other symbols there is an r in its interval for which p(r) is true" follows from the claim
//! "p(w), and w is in the interval" for any formula w in the other symbols that has a value at every point of the
//! domain and at which the statement is defined. [`instantiate`] makes that claim. It has no `exists` and is decided, checked at
//! points and replayed like any other; if it is false, other witnesses may still exist. Of all parts that a witness may contain, only
//! quotients can be undefined somewhere, and their divisors become conditions of the verdict: see
//! [`may_lack_a_value`]. So do the divisors of the statement; its roots and logarithms have values by the way they are written, or
//! the claim is refused: see [`Signs`].
//!
//! In `q implies p(r)` only the conclusion is instantiated; where q is false every r of the interval works.

use crate::definedness::Signs;
use crate::elaborator::Elaborator;
use num_traits::Signed;
use std::collections::BTreeSet;
use std::sync::Arc;
use torse_core::{BuiltIn, Hypothesis, Node, Statement, Term};
use torse_numbers::fault_injection::{InjectedFault, injected};
use torse_numbers::rational;
use torse_syntax::derivation::declarations::{Bound, Interval, SymbolKind};
use torse_syntax::derivation::{Claim, Existential, Written};
use torse_syntax::fault::Fault;
use torse_syntax::formula::{self, Connective, Operator, Place, Relation};

/// The statement with a witness in the place of each existential symbol.
pub(super) fn instantiate(
    elaborator: &Elaborator<'_>,
    claim: &Claim,
    hypotheses: &[Hypothesis],
    statement: &Written,
) -> Result<Statement, Fault> {
    let mut witnesses = vec![];
    for existential in &claim.existentials {
        let place = Place::default();
        let within = |fault: Fault| fault.within(&existential.origin);
        let Some(witness) = &existential.witness else {
            let what = format!(
                "no witness is given for `{}`, and none was found",
                existential.name
            );
            return Err(within(Fault::limit(place, what)));
        };
        let term = elaborator.term(&witness.expr);
        let term = term.map_err(|f| f.within(&witness.origin))?;
        if let Some(place) = may_lack_a_value(elaborator, &term) {
            let what = "a witness that may be undefined: it may contain only sums, products, powers, quotients, sines, \
                        cosines, exponentials and lengths";
            return Err(Fault::limit(place, what).within(&witness.origin));
        }
        refuse(&claim.existentials, &[&term]).map_err(|f| f.within(&witness.origin))?;
        witnesses.push((existential.name.as_str(), term));
    }
    let within = |fault: Fault| fault.within(&statement.origin);
    let body = elaborator
        .statement_where(&statement.expr, &witnesses)
        .map_err(within)?;
    if denies(&body) {
        let what =
            "`fails`, or a property of a basis, in an existential claim: state it for each point";
        return Err(within(Fault::limit(statement.expr.place, what)));
    }
    let signs = Signs::new(
        elaborator.declarations(),
        hypotheses.iter().map(|own| &own.statement),
    );
    let mut members = vec![];
    let mut inhabited = true;
    for (existential, (_, witness)) in claim.existentials.iter().zip(&witnesses) {
        let Some(SymbolKind::Real(interval)) = claim.declarations.symbol(&existential.name) else {
            continue;
        };
        inhabited &= is_inhabited(interval);
        members.extend(between(interval, witness));
        for relation in interval.relations(&existential.name) {
            let within = |fault: Fault| fault.within(&relation.origin);
            let member = elaborator.statement_where(&relation.expr, &witnesses);
            let member = member.map_err(within)?;
            let mut ends = member.terms().into_iter();
            ends.try_for_each(|end| signs.require_end(end, witnesses.len()))
                .map_err(within)?;
            members.push(member);
        }
    }
    refuse_functions(elaborator, claim, statement).map_err(within)?;
    let premise = free_premise(elaborator, claim, statement).filter(|_| inhabited);
    let signs = match &premise {
        Some(premise) => signs.with(premise),
        None => signs,
    };
    signs
        .require_values(&body, witnesses.len(), premise.is_some())
        .map_err(within)?;
    let both =
        |a: Statement, b: Statement| Statement::Join(Connective::And, Box::new(a), Box::new(b));
    let Some(members) = members.into_iter().reduce(both) else {
        return Ok(body);
    };
    Ok(match body {
        Statement::Join(Connective::Implies, before, conclusion) if premise.is_some() => {
            let conclusion = Box::new(both(members, *conclusion));
            Statement::Join(Connective::Implies, before, conclusion)
        }
        body => both(members, body),
    })
}

/// Fails if one of the existential symbols occurs in the terms.
pub(super) fn refuse(existential: &[Existential], terms: &[&Term]) -> Result<(), Fault> {
    for term in terms {
        let mut found = None;
        term.declared_names(&mut |name: &Arc<str>| {
            if existential.iter().any(|s| *s.name == **name) {
                found.get_or_insert_with(|| name.to_string());
            }
        });
        if let Some(name) = found {
            let what = format!(
                "`{name}` is existential: it cannot occur in hypotheses, other ranges or witnesses"
            );
            return Err(Fault::limit(term.place, what));
        }
    }
    Ok(())
}

/// Fails if a smooth function stands at a place with an existential symbol in it: with the witness in place its value is another
/// symbol, of which nothing says that it was chosen.
fn refuse_functions(
    elaborator: &Elaborator<'_>,
    claim: &Claim,
    statement: &Written,
) -> Result<(), Fault> {
    let plain = elaborator.statement(&statement.expr)?;
    let mut found = false;
    plain.declared_names(&mut |name: &Arc<str>| {
        let mut words = name.split(|c: char| !(c.is_alphanumeric() || c == '_'));
        let is_existential = |word: &str| claim.existentials.iter().any(|own| own.name == word);
        found |= name.contains('(') && words.any(is_existential);
    });
    match found {
        true => Err(Fault::limit(
            statement.expr.place,
            "a function at a place with an existential number in it",
        )),
        false => Ok(()),
    }
}

/// The premise of an implication in which no existential symbol occurs.
fn free_premise(
    elaborator: &Elaborator<'_>,
    claim: &Claim,
    statement: &Written,
) -> Option<Statement> {
    let formula::Node::Join(Connective::Implies, premise, _) = &statement.expr.node else {
        return None;
    };
    let premise = elaborator.hypothesis(premise).ok()?;
    refuse(&claim.existentials, &premise.terms()).ok()?;
    Some(premise)
}

fn denies(statement: &Statement) -> bool {
    match statement {
        Statement::Not(_) | Statement::Family(..) => true,
        Statement::Join(_, a, b) => denies(a) || denies(b),
        Statement::Compare { .. } | Statement::Agrees { .. } => false,
    }
}

/// Whether an interval is nonempty for all values of the symbols.
fn is_inhabited(interval: &Interval) -> bool {
    if interval.formulas().next().is_some() {
        return false;
    }
    match (&interval.lower, &interval.upper) {
        (Some(lower), Some(upper)) => {
            match (lower.value.as_rational(), upper.value.as_rational()) {
                (Some(a), Some(b)) => a < b || (a == b && lower.closed && upper.closed),
                _ => false,
            }
        }
        _ => true,
    }
}

/// The statements that the numeric ends of the interval make about a witness.
fn between(interval: &Interval, witness: &Term) -> Vec<Statement> {
    let made = |node| Term {
        node: Arc::new(node),
        place: witness.place,
    };
    let end = |bound: &Bound| {
        let number = |value| made(Node::Number(value));
        let turns = Node::Binary(
            Operator::Multiply,
            number(bound.value.turns.clone()),
            made(Node::Pi),
        );
        match bound.value.as_rational() {
            Some(value) => number(value.clone()),
            None => made(Node::Binary(
                Operator::Add,
                number(bound.value.rational.clone()),
                made(turns),
            )),
        }
    };
    let compared = |closed: bool, left: Term, right: Term| Statement::Compare {
        relation: match closed {
            true => Relation::AtMost,
            false if injected(InjectedFault::OpenEndIncluded) => Relation::AtMost,
            false => Relation::Less,
        },
        left,
        right,
    };
    let lower = (interval.lower.iter()).map(|b| compared(b.closed, end(b), witness.clone()));
    let upper = (interval.upper.iter()).map(|b| compared(b.closed, witness.clone(), end(b)));
    lower.chain(upper).collect()
}

/// Returns a part of the formula that may be undefined for a reason other than a zero divisor.
///
/// A divisor that contains an integer symbol counts too: statements are decided for single values of the integers,
/// and a term that is undefined at one of them would make the statement there vacuous.
fn may_lack_a_value(elaborator: &Elaborator<'_>, term: &Term) -> Option<Place> {
    let mut seen = BTreeSet::new();
    let mut pending = vec![term];
    let declarations = elaborator.declarations();
    let counts = |term: &Term| {
        let mut integer = false;
        term.declared_names(&mut |name: &Arc<str>| {
            let set = declarations.symbol(name);
            integer |= !matches!(set, Some(SymbolKind::Real(_) | SymbolKind::Vector(_)));
        });
        integer
    };
    let number = |term: &Term| matches!(&*term.node, Node::Number(q) if q.is_integer());
    while let Some(term) = pending.pop() {
        if !seen.insert(Arc::as_ptr(&term.node).addr()) {
            continue;
        }
        let total = match &*term.node {
            Node::Number(_)
            | Node::Pi
            | Node::Symbol(_)
            | Node::Variable(_)
            | Node::Vector(..)
            | Node::Negative(_)
            | Node::List(_)
            | Node::Let { .. }
            | Node::Opened { .. } => true,
            Node::Binary(Operator::Divide, _, below) => !counts(below),
            Node::Binary(Operator::Power, base, exponent) => match &*exponent.node {
                Node::Number(q) => q.is_integer() && (!q.is_negative() || !counts(base)),
                _ => false,
            },
            Node::Binary(..) => true,
            Node::Entry(_, indices) | Node::Member(_, indices) => indices.iter().all(number),
            Node::Apply(function, arguments) => match (function, arguments.as_slice()) {
                (
                    BuiltIn::Sine
                    | BuiltIn::Cosine
                    | BuiltIn::Exponential
                    | BuiltIn::Dot
                    | BuiltIn::Cross
                    | BuiltIn::Norm
                    | BuiltIn::Determinant
                    | BuiltIn::Transpose,
                    _,
                ) => true,
                (BuiltIn::SquareRoot, [radicand]) => is_not_negative(radicand),
                _ => false,
            },
            Node::Basis { .. }
            | Node::Sum { .. }
            | Node::Product { .. }
            | Node::Integral { .. }
            | Node::Derivative { .. } => false,
        };
        if !total {
            return Some(term.place);
        }
        pending.extend(term.parts());
    }
    None
}

/// Whether a radicand is a nonnegative number, or the square of a term by the way it is written.
fn is_not_negative(radicand: &Term) -> bool {
    match &*radicand.node {
        Node::Number(q) => *q >= rational::integer(0),
        Node::Binary(Operator::Multiply, a, b) => Arc::ptr_eq(&a.node, &b.node),
        _ => false,
    }
}
