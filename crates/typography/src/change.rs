//! What a correction changed, on the tree: in the printed formula what goes is marked, in the corrected one what comes.
//!
//! Sums, products, lists and conjunctions are compared part by part, with a longest common subsequence of equal parts
//! kept; all else part against part where the kinds agree. Where more of two parts would be marked than not, they are
//! marked whole: a formula with every second letter marked is not read.

use crate::difference::common;
use crate::layout::{ADDED, REMOVED, SIGN_ADDED, SIGN_REMOVED, layout};
use crate::tidy::{factors, sum, terms, tidy};
use crate::{MathBox as Shown, PrintedNames, expression};
use torse_syntax::formula::{Connective, Expr, Node, Operator};

/// Formulas of more nodes than this are not compared.
const MAX_NODES: usize = 3_000;

/// The printed formula and the corrected one, both in the notation of the files, as boxes with what changed marked; none
/// where one of them cannot be read.
pub fn changed(printed: &str, corrected: &str, names: &PrintedNames) -> Option<[Shown; 2]> {
    let (old, new) = (tidy(&expression(printed)?), tidy(&expression(corrected)?));
    let (old, new) = match old.size().max(new.size()) > MAX_NODES {
        true => (old, new),
        false => {
            let pair = compare(&old, &new);
            (pair.old, pair.new)
        }
    };
    Some([layout(&old, names), layout(&new, names)])
}

/// Two formulas with marks, and how many nodes are marked.
struct Pair {
    old: Expr,
    new: Expr,
    marked: usize,
}

impl Pair {
    fn equal(formula: &Expr) -> Self {
        Pair {
            old: formula.clone(),
            new: formula.clone(),
            marked: 0,
        }
    }

    fn whole(old: &Expr, new: &Expr) -> Self {
        Pair {
            old: mark(REMOVED, old),
            new: mark(ADDED, new),
            marked: old.size() + new.size(),
        }
    }
}

fn mark(name: &str, formula: &Expr) -> Expr {
    Expr::made(Node::Call(Expr::name(name).into(), vec![formula.clone()]))
}

fn compare(old: &Expr, new: &Expr) -> Pair {
    if old == new {
        return Pair::equal(old);
    }
    let pair = parts(old, new).unwrap_or_else(|| Pair::whole(old, new));
    // Of small formulas a part is a letter, and worth marking alone.
    let all = old.size() + new.size();
    match pair.marked * 4 > all * 3 && all < 400 && !relates(old) {
        true => Pair::whole(old, new),
        false => pair,
    }
}

/// Statements are never marked whole.
fn relates(formula: &Expr) -> bool {
    matches!(formula.node, Node::Compare(..) | Node::Join(..))
}

/// The formulas compared part by part, where they are of one kind.
fn parts(old: &Expr, new: &Expr) -> Option<Pair> {
    let made = |old: Node, new: Node, marked| Pair {
        old: Expr::made(old),
        new: Expr::made(new),
        marked,
    };
    // Only the sign differs.
    match (&old.node, &new.node) {
        (Node::Negative(term), _) if **term == *new => {
            let old = Node::Negative(mark(SIGN_REMOVED, term).into());
            return Some(made(old, mark(SIGN_ADDED, new).node, 1));
        }
        (_, Node::Negative(term)) if **term == *old => {
            let new = Node::Negative(mark(SIGN_ADDED, term).into());
            return Some(made(mark(SIGN_REMOVED, old).node, new, 1));
        }
        _ => {}
    }
    let is_sum = |e: &Expr| matches!(e.node, Node::Binary(Operator::Add | Operator::Subtract, ..));
    let is_product = |e: &Expr| matches!(e.node, Node::Binary(Operator::Multiply, ..));
    if is_sum(old) || is_sum(new) {
        return Some(sums(old, new));
    }
    if is_product(old) || is_product(new) {
        return Some(products(old, new));
    }
    Some(match (&old.node, &new.node) {
        (Node::Negative(a), Node::Negative(b)) => {
            let pair = compare(a, b);
            made(
                Node::Negative(pair.old.into()),
                Node::Negative(pair.new.into()),
                pair.marked,
            )
        }
        (Node::Binary(one, a, b), Node::Binary(other, c, d)) if one == other => {
            let (left, right) = (compare(a, c), compare(b, d));
            made(
                Node::Binary(*one, left.old.into(), right.old.into()),
                Node::Binary(*one, left.new.into(), right.new.into()),
                left.marked + right.marked,
            )
        }
        (Node::Call(f, a), Node::Call(g, b)) if a.len() == b.len() => {
            // A name that heads a call is replaced with it: functions are not struck out of their brackets.
            if f != g {
                return None;
            }
            let list = pairwise(a, b);
            let (old, new, marked) = split(list);
            made(
                Node::Call(f.clone(), old),
                Node::Call(g.clone(), new),
                marked,
            )
        }
        (Node::Index(f, a), Node::Index(g, b)) if f == g && a.len() == b.len() => {
            let (old, new, marked) = split(pairwise(a, b));
            made(
                Node::Index(f.clone(), old),
                Node::Index(g.clone(), new),
                marked,
            )
        }
        (Node::List(a), Node::List(b)) => {
            let list = match a.len() == b.len() {
                true => split(pairwise(a, b)),
                false => aligned(a, b),
            };
            made(Node::List(list.0), Node::List(list.1), list.2)
        }
        (Node::Compare(a, rest), Node::Compare(b, other))
            if rest.len() == other.len()
                && rest.iter().zip(other).all(|((r, _), (s, _))| r == s) =>
        {
            let first = compare(a, b);
            let mut marked = first.marked;
            let (mut old, mut new) = (Vec::new(), Vec::new());
            for ((relation, a), (_, b)) in rest.iter().zip(other) {
                let pair = compare(a, b);
                marked += pair.marked;
                old.push((*relation, pair.old));
                new.push((*relation, pair.new));
            }
            made(
                Node::Compare(first.old.into(), old),
                Node::Compare(first.new.into(), new),
                marked,
            )
        }
        (Node::Join(one, a, b), Node::Join(other, c, d)) if one == other => {
            let (left, right) = (compare(a, c), compare(b, d));
            let join = |connective: Connective, a: Expr, b: Expr| {
                Node::Join(connective, a.into(), b.into())
            };
            made(
                join(*one, left.old, right.old),
                join(*one, left.new, right.new),
                left.marked + right.marked,
            )
        }
        _ => return None,
    })
}

fn pairwise(a: &[Expr], b: &[Expr]) -> Vec<Pair> {
    a.iter().zip(b).map(|(a, b)| compare(a, b)).collect()
}

fn split(pairs: Vec<Pair>) -> (Vec<Expr>, Vec<Expr>, usize) {
    let (mut old, mut new, mut marked) = (Vec::new(), Vec::new(), 0);
    for pair in pairs {
        old.push(pair.old);
        new.push(pair.new);
        marked += pair.marked;
    }
    (old, new, marked)
}

fn sums(old: &Expr, new: &Expr) -> Pair {
    let signed = |(sign, term): (Operator, Expr)| match sign {
        Operator::Subtract => Expr::made(Node::Negative(term.into())),
        _ => term,
    };
    let list = |formula: &Expr| -> Vec<Expr> { terms(formula).into_iter().map(signed).collect() };
    let (old, new, marked) = aligned(&list(old), &list(new));
    // A mark around a sign and its term goes between them: a sum writes the sign within the mark.
    let whole = |list: Vec<Expr>| sum(list.into_iter().map(unsigned).collect());
    Pair {
        old: whole(old),
        new: whole(new),
        marked,
    }
}

/// A term with its sign, before its mark if it has one.
fn unsigned(term: Expr) -> (Operator, Expr) {
    if let Node::Call(head, inner) = &term.node
        && let (Node::Name(name), [one]) = (&head.node, inner.as_slice())
        && (name == ADDED || name == REMOVED)
        && let Node::Negative(inner) = &one.node
    {
        return (Operator::Subtract, mark(name, inner));
    }
    match term.node {
        Node::Negative(inner) => (Operator::Subtract, (*inner).clone()),
        _ => (Operator::Add, term),
    }
}

fn products(old: &Expr, new: &Expr) -> Pair {
    let (old, new, marked) = aligned(&factors(old), &factors(new));
    let whole = |list: Vec<Expr>| {
        let product = list
            .into_iter()
            .reduce(|a, b| a.with(Operator::Multiply, b));
        product.unwrap_or_else(|| Expr::number(&1.into()))
    };
    Pair {
        old: whole(old),
        new: whole(new),
        marked,
    }
}

/// Two lists with a longest common subsequence kept; what lies between two kept parts is compared part by part where it
/// is as much on both sides, and marked else.
fn aligned(old: &[Expr], new: &[Expr]) -> (Vec<Expr>, Vec<Expr>, usize) {
    let (mut shown_old, mut shown_new, mut marked) = (Vec::new(), Vec::new(), 0);
    let mut gap = |a: &[Expr], b: &[Expr], kept: Option<&Expr>| {
        if a.len() == b.len() {
            let (old, new, more) = split(pairwise(a, b));
            shown_old.extend(old);
            shown_new.extend(new);
            marked += more;
        } else {
            shown_old.extend(a.iter().map(|part| mark(REMOVED, part)));
            shown_new.extend(b.iter().map(|part| mark(ADDED, part)));
            marked += a.iter().chain(b).map(Expr::size).sum::<usize>();
        }
        shown_old.extend(kept.cloned());
        shown_new.extend(kept.cloned());
    };
    let (mut i, mut j) = (0, 0);
    for (next_i, next_j) in common(old, new, |a, b| a == b) {
        let a = old.get(i..next_i).unwrap_or_default();
        let b = new.get(j..next_j).unwrap_or_default();
        gap(a, b, old.get(next_i));
        (i, j) = (next_i + 1, next_j + 1);
    }
    let a = old.get(i..).unwrap_or_default();
    let b = new.get(j..).unwrap_or_default();
    gap(a, b, None);
    (shown_old, shown_new, marked)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::write::typst;

    fn shown(old: &str, new: &str) -> [String; 2] {
        changed(old, new, &PrintedNames::default())
            .unwrap()
            .map(|node| typst(&node))
    }

    #[test]
    fn an_added_factor_is_marked_alone() {
        assert_eq!(
            shown("x == pi^2*q", "x == 4*pi^2*q"),
            ["x = π^2 q", "x = added(4) π^2 q"]
        );
    }

    #[test]
    fn of_a_changed_sign_the_term_has_no_mark() {
        assert_eq!(
            shown("x == a - b + c", "x == a + b + c"),
            ["x = a removedsign(−) b + c", "x = a addedsign(+) b + c"]
        );
        assert_eq!(
            shown("x == 3*(a - b)", "x == -3*(a - b)"),
            ["x = 3 (a − b)", "x = addedsign(−) 3 (a − b)"]
        );
    }

    #[test]
    fn a_replaced_name_in_a_long_product_is_marked_alone() {
        assert_eq!(
            shown("y == a2*a0' - f(a3)*b", "y == a2*a3' - f(a3)*b"),
            [
                "y = a_2 removed(a'_0) − f (a_3) b",
                "y = a_2 added(a'_3) − f (a_3) b"
            ]
        );
    }

    #[test]
    fn what_is_not_changed_has_no_mark() {
        let [old, new] = shown("f(x) == 1 + x", "f(x) == 1 + x");
        assert_eq!(old, new);
        assert!(!old.contains("added"));
        assert!(changed("f(", "x", &PrintedNames::default()).is_none());
    }
}
