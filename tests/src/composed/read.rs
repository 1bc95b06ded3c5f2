//! Printed conditions as statements of the evaluator, so that it can judge them at points.

use super::statement::Statement;
use super::term::{Function, Operation, Part, Term};
use std::sync::Arc;
use torse_syntax::formula::{Connective, Expr, Node, Operator, Relation, parse};

/// A printed statement; nothing where it has what composed statements have not.
#[must_use]
pub fn statement(text: &str) -> Option<Statement> {
    read(&parse(text).ok()?)
}

fn read(expr: &Expr) -> Option<Statement> {
    match &expr.node {
        Node::Join(connective, p, q) => {
            let (p, q) = (Arc::new(read(p)?), Arc::new(read(q)?));
            Some(match connective {
                Connective::And => Statement::And(p, q),
                Connective::Or => Statement::Or(p, q),
                Connective::Implies => Statement::Implies(p, q),
            })
        }
        Node::Compare(first, rest) => match rest.as_slice() {
            [(relation, second)] => {
                let relation = match relation {
                    Relation::Equal => "==",
                    Relation::Different => "!=",
                    Relation::Less => "<",
                    Relation::AtMost => "<=",
                    Relation::Greater => ">",
                    Relation::AtLeast => ">=",
                };
                Some(Statement::Compare(term(first)?, relation, term(second)?))
            }
            _ => None,
        },
        _ => None,
    }
}

fn term(expr: &Expr) -> Option<Part> {
    Some(match &expr.node {
        Node::Number { value, .. } => {
            let [above, below] = [value.numer(), value.denom()].map(|n| i64::try_from(n).ok());
            Arc::new(Term::Number(above?, below?))
        }
        Node::Name(name) => Term::name(name),
        Node::Negative(a) => Term::minus(&term(a)?),
        Node::Binary(operator, a, b) => {
            let (a, b) = (term(a)?, term(b)?);
            let operation = match operator {
                Operator::Add => Operation::Add,
                Operator::Subtract => Operation::Subtract,
                Operator::Multiply => Operation::Multiply,
                Operator::Divide => Operation::Divide,
                Operator::Power => return Some(Arc::new(Term::Power(a, b))),
            };
            Term::binary(operation, &a, &b)
        }
        Node::Call(head, arguments) => {
            if let (Node::Name(name), [a, b]) = (&head.node, arguments.as_slice()) {
                let operation = match name.as_str() {
                    "min" => Operation::Least,
                    "max" => Operation::Greatest,
                    _ => return None,
                };
                return Some(Term::binary(operation, &term(a)?, &term(b)?));
            }
            let (Node::Name(name), [argument]) = (&head.node, arguments.as_slice()) else {
                return None;
            };
            let argument = term(argument)?;
            let function = match name.as_str() {
                "sin" => Function::Sine,
                "cos" => Function::Cosine,
                "exp" => Function::Exponential,
                "log" => Function::Logarithm,
                "sqrt" => Function::Root,
                "abs" => Function::Size,
                smooth => {
                    let stem = smooth.trim_end_matches('\'');
                    let order = smooth.len() - stem.len();
                    return Some(Arc::new(Term::Smooth(stem.to_owned(), order, argument)));
                }
            };
            Arc::new(Term::Apply(function, argument))
        }
        Node::Index(head, indices) => match (&head.node, indices.as_slice()) {
            (Node::Name(name), [index]) => Arc::new(Term::Member(name.clone(), term(index)?)),
            _ => return None,
        },
        _ => return None,
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_condition_is_written_as_it_was_read() {
        for text in [
            "a - 1 != 0",
            "x^2 - 2*f''(x*y)/3 + P[m - 1] != 0",
            "sqrt(x) > 0",
            "max(x, y) - min(2*x, a)^2 != 0",
        ] {
            let written = statement(text).map(|read| read.to_string());
            assert_eq!(written.as_deref(), Some(text));
        }
        assert_eq!(statement("f(x, y) != 0"), None);
    }
}
