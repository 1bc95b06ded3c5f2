//! Edits that change every occurrence at once: one slip of copying, repeated.

use super::alphabet::Alphabet;
use super::edit::{Change, Edit, placed, text, with_name};
use torse_algebra::Rational;
use torse_algebra::rational::integer;
use torse_syntax::formula::{Expr, Node, Operator};

/// Returns all formulas in which one thing replaces another throughout.
#[must_use]
pub fn edits(expr: &Expr, alphabet: &Alphabet) -> Vec<Edit> {
    let mut result = renamed(expr);
    result.extend(functions_dropped(expr));
    result.extend(factors_kept(expr));
    result.extend(basis_exchanged(expr, alphabet));
    result
}

/// Replaces one name by another throughout a bracket, primes kept: the slip of copying a bracket.
fn renamed(expr: &Expr) -> Vec<Edit> {
    let mut result = vec![];
    let bases = |expr: &Expr| {
        let names: Vec<String> = expr
            .names()
            .into_iter()
            .map(|n| n.trim_end_matches('\'').to_owned())
            .collect();
        names
    };
    let mut all = bases(expr);
    all.sort();
    all.dedup();
    let mut pending: Vec<(Vec<usize>, &Expr)> = vec![(vec![], expr)];
    while let Some((path, part)) = pending.pop() {
        let own = bases(part);
        let sum = matches!(
            &part.node,
            Node::Binary(Operator::Add | Operator::Subtract, ..)
        );
        if sum && part.size() <= MAX_RENAMED {
            let mut repeated: Vec<&String> = own
                .iter()
                .filter(|n| own.iter().filter(|o| o == n).count() > 1)
                .collect();
            repeated.sort();
            repeated.dedup();
            for old in repeated {
                for new in all.iter().filter(|n| *n != old) {
                    let changed = with_name(part, old, new);
                    let names = [&Expr::name(old), &Expr::name(new), part];
                    let change = Change::new("_ replaced by _ in _", names);
                    result.push(Edit {
                        expr: placed(expr, &path, changed),
                        change,
                    });
                }
            }
        }
        for (position, inner) in part.parts().into_iter().enumerate() {
            let mut deeper = path.clone();
            deeper.push(position);
            pending.push((deeper, inner));
        }
    }
    result
}

/// Replaces a sine or cosine that occurs more than once by its variable, throughout.
fn functions_dropped(expr: &Expr) -> Vec<Edit> {
    let calls: Vec<&Expr> = all_parts(expr)
        .into_iter()
        .filter(|p| is_angle(p))
        .collect();
    let mut result = vec![];
    let mut seen: Vec<String> = vec![];
    for call in &calls {
        let old = text(call);
        let repeated = calls.iter().filter(|other| text(other) == old).count() > 1;
        if !repeated || seen.contains(&old) {
            continue;
        }
        for variable in variables(call) {
            let by = Expr::name(variable);
            result.push(Edit {
                expr: with_part(expr, &old, &by),
                change: Change::replaced(call, &by).at(" throughout"),
            });
        }
        seen.push(old);
    }
    result
}

/// Whether a formula is a sine or cosine.
fn is_angle(expr: &Expr) -> bool {
    matches!(&expr.node, Node::Call(head, _)
        if matches!(&head.node, Node::Name(name) if name == "sin" || name == "cos"))
}

/// Returns the variables in the angle of a sine or cosine.
fn variables(call: &Expr) -> impl Iterator<Item = &str> {
    let names = call.names().into_iter();
    names.filter(|n| !["sin", "cos", "exp", "pi"].contains(n))
}

fn with_part(expr: &Expr, old: &str, new: &Expr) -> Expr {
    if matches!(expr.node, Node::Call(..)) && text(expr) == old {
        return new.clone();
    }
    expr.with_parts(|part| with_part(part, old, new))
}

/// Maximum size of a bracket in which names are replaced throughout.
const MAX_RENAMED: usize = 15;

/// The parts of a formula, itself first.
fn all_parts(expr: &Expr) -> Vec<&Expr> {
    let mut found = vec![];
    let mut pending = vec![expr];
    while let Some(part) = pending.pop() {
        found.push(part);
        pending.extend(part.parts());
    }
    found
}

/// Replaces a sine or cosine in powers by its variable, with one factor of each power kept: `s^(i + 1)` becomes
/// `s*x^i`. The slip merges two sequences of factors.
fn factors_kept(expr: &Expr) -> Vec<Edit> {
    let mut result = vec![];
    let mut seen: Vec<String> = vec![];
    for call in all_parts(expr).into_iter().filter(|part| is_angle(part)) {
        let old = text(call);
        if seen.contains(&old) || !all_parts(expr).into_iter().any(|p| is_power_of(p, &old)) {
            continue;
        }
        for variable in variables(call) {
            let by = Expr::name(variable);
            let change = Change::replaced(call, &by);
            result.push(Edit {
                expr: with_factors_kept(expr, &old, &by),
                change: change.at(" in the powers, one factor of each kept"),
            });
        }
        seen.push(old);
    }
    result
}

fn is_power_of(expr: &Expr, call: &str) -> bool {
    matches!(&expr.node, Node::Binary(Operator::Power, base, _)
        if all_parts(base).into_iter().any(|p| is_angle(p) && text(p) == call))
}

fn with_factors_kept(expr: &Expr, call: &str, variable: &Expr) -> Expr {
    if let Node::Binary(Operator::Power, base, exponent) = &expr.node
        && is_power_of(expr, call)
    {
        let rest = with_part(base, call, variable).with(Operator::Power, one_less(exponent));
        return (**base).clone().with(Operator::Multiply, rest);
    }
    expr.with_parts(|part| with_factors_kept(part, call, variable))
}

/// Returns the formula minus one, written as a human would.
fn one_less(expr: &Expr) -> Expr {
    let number = |e: &Expr| match &e.node {
        Node::Number { value, .. } => Some(value.clone()),
        _ => None,
    };
    let one = integer(1);
    match &expr.node {
        Node::Number { value, .. } => Expr::number(&(value - &one)),
        Node::Binary(Operator::Add, a, b) => match number(b) {
            Some(value) if value == one => (**a).clone(),
            Some(value) => (**a)
                .clone()
                .with(Operator::Add, Expr::number(&(value - one))),
            None => one_less(a).with(Operator::Add, (**b).clone()),
        },
        Node::Binary(Operator::Subtract, a, b) => match number(b) {
            Some(value) => (**a)
                .clone()
                .with(Operator::Subtract, Expr::number(&(value + one))),
            None => one_less(a).with(Operator::Subtract, (**b).clone()),
        },
        _ => expr.clone().with(Operator::Subtract, Expr::number(&one)),
    }
}

/// Replaces the functions of a basis by those of another of its lowest degree: `f[i,n](z, mu, nu)` by `b[i,1](z)`, for
/// every i.
fn basis_exchanged(expr: &Expr, alphabet: &Alphabet) -> Vec<Edit> {
    let mut result: Vec<Edit> = vec![];
    let mut seen: Vec<String> = vec![];
    for member in all_parts(expr).into_iter().filter_map(Member::from_expr) {
        let known = alphabet.bases.iter().any(|(name, ..)| name == member.basis);
        let family = member.family();
        if !known || seen.contains(&family) {
            continue;
        }
        for (other, degree, arguments) in &alphabet.bases {
            if other == member.basis || *arguments > member.arguments.len() {
                continue;
            }
            let rest = member.arguments.get(..*arguments).unwrap_or(&[]);
            let by = |index: &Expr| {
                let degree = Expr::number(&Rational::from_integer((*degree).into()));
                let head = Node::Index(Expr::name(other).into(), vec![index.clone(), degree]);
                Expr::made(Node::Call(Expr::made(head).into(), rest.to_vec()))
            };
            let index = Expr::name("i");
            let change = Change::new(
                "the functions _ replaced by _",
                [&member.with_index(&index), &by(&index)],
            );
            result.push(Edit {
                expr: with_members(expr, &family, &by),
                change,
            });
        }
        seen.push(family);
    }
    result
}

/// A function of a basis, `basis[index,degree](arguments)`.
struct Member<'e> {
    basis: &'e str,
    index: &'e Expr,
    degree: &'e Expr,
    arguments: &'e [Expr],
}

impl<'e> Member<'e> {
    fn from_expr(expr: &'e Expr) -> Option<Self> {
        let Node::Call(head, arguments) = &expr.node else {
            return None;
        };
        let Node::Index(basis, indices) = &head.node else {
            return None;
        };
        match (&basis.node, indices.as_slice()) {
            (Node::Name(basis), [index, degree]) => Some(Self {
                basis,
                index,
                degree,
                arguments,
            }),
            _ => None,
        }
    }

    /// The function for any index, as text.
    fn family(&self) -> String {
        text(&self.with_index(&Expr::name("i")))
    }

    /// Returns the function of another index.
    fn with_index(&self, index: &Expr) -> Expr {
        let indices = vec![index.clone(), self.degree.clone()];
        let head = Node::Index(Expr::name(self.basis).into(), indices);
        Expr::made(Node::Call(Expr::made(head).into(), self.arguments.to_vec()))
    }
}

fn with_members(expr: &Expr, family: &str, by: &impl Fn(&Expr) -> Expr) -> Expr {
    if let Some(member) = Member::from_expr(expr)
        && member.family() == family
    {
        return by(member.index);
    }
    expr.with_parts(|part| with_members(part, family, by))
}
