//! One place of a term changed, as a slip of printing would.

use super::rewrite::at_node;
use super::term::{Function, Operation, Part, Term};
use crate::random::seed::Stream;
use std::sync::Arc;

/// The term with one of its nodes changed; nothing if the node that is drawn has no slip.
pub fn slipped(stream: &mut Stream, term: &Part) -> Option<Part> {
    let place = stream.below(term.size());
    at_node(term, place, &mut |node| slip(stream, node))
}

fn slip(stream: &mut Stream, term: &Part) -> Option<Part> {
    let next = i64::from(stream.once_in(2)) * 2 - 1;
    Some(Arc::new(match &**term {
        Term::Number(above, below) => Term::Number(above + next, *below),
        Term::Name(name) => match name.as_str() {
            "x" => Term::Name("y".to_owned()),
            "y" => Term::Name("x".to_owned()),
            "a" => Term::Name("b".to_owned()),
            "m" => Term::Binary(Operation::Add, Arc::clone(term), Term::int(1)),
            _ => return None,
        },
        Term::Negative(a) => return Some(Arc::clone(a)),
        Term::Binary(operation, a, b) => {
            let other = match operation {
                Operation::Add | Operation::Divide => Operation::Subtract,
                Operation::Subtract | Operation::Multiply => Operation::Add,
                Operation::Least => Operation::Greatest,
                Operation::Greatest => Operation::Least,
            };
            match stream.below(4) {
                0 => return Some(Arc::clone(a)),
                1 if *operation == Operation::Subtract => {
                    Term::Binary(*operation, Arc::clone(b), Arc::clone(a))
                }
                _ => Term::Binary(other, Arc::clone(a), Arc::clone(b)),
            }
        }
        Term::Power(a, n) => match &**n {
            Term::Number(n, 1) => Term::Power(Arc::clone(a), Term::int(n + 1)),
            _ => return Some(Arc::clone(a)),
        },
        Term::Apply(function, a) => {
            let other = match function {
                Function::Sine | Function::Exponential => Function::Cosine,
                Function::Logarithm => Function::Size,
                Function::Cosine => Function::Sine,
                Function::Root => Function::Size,
                Function::Size => return Some(Arc::clone(a)),
            };
            Term::Apply(other, Arc::clone(a))
        }
        Term::Smooth(name, order, a) => Term::Smooth(name.clone(), order + 1, Arc::clone(a)),
        Term::Rate(a, by, order) => match stream.below(3) {
            0 => return Some(Arc::clone(a)),
            1 if by == "x" => Term::Rate(Arc::clone(a), "y".to_owned(), *order),
            _ => Term::Rate(Arc::clone(a), by.clone(), order + 1),
        },
        Term::At(a, by, value) => match stream.below(3) {
            0 => return Some(Arc::clone(a)),
            1 if by == "x" => Term::At(Arc::clone(a), "y".to_owned(), Arc::clone(value)),
            _ => {
                let moved = Term::binary(Operation::Add, value, &Term::int(1));
                Term::At(Arc::clone(a), by.clone(), moved)
            }
        },
        Term::Sum(index, low, high, a) => {
            let high = Term::binary(Operation::Subtract, high, &Term::int(1));
            Term::Sum(index.clone(), Arc::clone(low), high, Arc::clone(a))
        }
        Term::Product(index, low, high, a) => {
            let (low, high) = (Arc::clone(low), Arc::clone(high));
            Term::Sum(index.clone(), low, high, Arc::clone(a))
        }
        Term::Integral(a, by, low, high) => {
            let (low, high) = (Arc::clone(low), Arc::clone(high));
            Term::Integral(Arc::clone(a), by.clone(), high, low)
        }
        Term::Defined(_, arguments) => return arguments.first().cloned(),
        Term::Member(name, _) => Term::Member(name.clone(), Term::int(0)),
        Term::Basis(name, index, degree, all) => {
            let index = Term::binary(Operation::Add, index, &Term::int(next));
            Term::Basis(name.clone(), index, Arc::clone(degree), all.clone())
        }
    }))
}
