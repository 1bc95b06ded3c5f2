//! Identifies edits that are the same correction: their formulas differ only in the order and grouping of factors and
//! terms, and in where a sign stands.

use std::sync::Arc;
use torse_algebra::rational::integer;
use torse_algebra::{Polynomial, Rational};
use torse_syntax::formula::{Expr, Node, Operator};

/// Maximum exponent that is written out.
const MAX_REPEATED: u8 = 4;

/// Returns a text that is equal for formulas that differ only in order, grouping and place of signs.
#[must_use]
pub fn canonical(expr: &Expr) -> String {
    let mut terms = vec![];
    collect_terms(expr, &integer(1), &mut terms);
    let mut texts: Vec<String> = terms
        .iter()
        .map(|(number, rest)| format!("{number} {rest}"))
        .collect();
    texts.sort();
    texts.join(" + ")
}

/// Splits a sum into terms: a number and the rest of the product as text.
fn collect_terms(expr: &Expr, factor: &Rational, into: &mut Vec<(Rational, String)>) {
    match &expr.node {
        Node::Binary(operator @ (Operator::Add | Operator::Subtract), a, b) => {
            collect_terms(a, factor, into);
            let sign = if *operator == Operator::Add {
                factor.clone()
            } else {
                -factor.clone()
            };
            collect_terms(b, &sign, into);
        }
        Node::Negative(inner) => collect_terms(inner, &-factor.clone(), into),
        _ => {
            let mut number = factor.clone();
            let mut factors = vec![];
            collect_factors(expr, false, &mut number, &mut factors);
            factors.sort();
            into.push((number, factors.join(" ")));
        }
    }
}

fn collect_factors(expr: &Expr, inverted: bool, number: &mut Rational, into: &mut Vec<String>) {
    if let Some(value) = nonzero_number(expr) {
        *number = if inverted {
            &*number / &value
        } else {
            &*number * &value
        };
        return;
    }
    let mark = if inverted { "/" } else { "" };
    match &expr.node {
        Node::Binary(Operator::Multiply, a, b) => {
            collect_factors(a, inverted, number, into);
            collect_factors(b, inverted, number, into);
        }
        Node::Binary(Operator::Divide, a, b) => {
            collect_factors(a, inverted, number, into);
            collect_factors(b, !inverted, number, into);
        }
        Node::Negative(inner) => {
            *number = -number.clone();
            collect_factors(inner, inverted, number, into);
        }
        Node::Binary(Operator::Add | Operator::Subtract, ..) => {
            // The sign of a sum that is a factor is pulled out, so that a - b and -(b - a) agree.
            let text = canonical(expr);
            let negated = canonical(&Expr::made(Node::Negative(Arc::new(expr.clone()))));
            if negated < text {
                *number = -number.clone();
                into.push(format!("{mark}({negated})"));
            } else {
                into.push(format!("{mark}({text})"));
            }
        }
        Node::Number { value, .. } => into.push(format!("{mark}{value}")),
        Node::Name(name) => into.push(format!("{mark}{name}")),
        // w^2 and w*w have one form.
        Node::Binary(Operator::Power, base, exponent) if repetitions(exponent).is_some() => {
            for _ in 0..repetitions(exponent).unwrap_or(0) {
                collect_factors(base, inverted, number, into);
            }
        }
        Node::Binary(Operator::Power, base, exponent) => {
            into.push(format!(
                "{mark}({})^({})",
                canonical(base),
                canonical(exponent)
            ));
        }
        _ => {
            let parts: Vec<String> = expr.parts().into_iter().map(canonical).collect();
            into.push(format!("{mark}{}<{}>", kind(&expr.node), parts.join(";")));
        }
    }
}

/// The value of a number that is not zero, or of the root of one if that is rational.
fn nonzero_number(expr: &Expr) -> Option<Rational> {
    let value = match &expr.node {
        Node::Number { value, .. } => value.clone(),
        Node::Call(head, arguments) => match (&head.node, arguments.as_slice()) {
            (Node::Name(name), [argument]) if name == "sqrt" => {
                let Node::Number { value, .. } = &argument.node else {
                    return None;
                };
                Polynomial::square_root(value).ok()?.as_constant()?
            }
            _ => return None,
        },
        _ => return None,
    };
    (!num_traits::Zero::is_zero(&value)).then_some(value)
}

/// A small whole exponent.
fn repetitions(exponent: &Expr) -> Option<u8> {
    let Node::Number { value, .. } = &exponent.node else {
        return None;
    };
    (1..=MAX_REPEATED).find(|n| *value == integer(i64::from(*n)))
}

fn kind(node: &Node) -> &'static str {
    match node {
        Node::Call(..) => "call",
        Node::Index(..) => "index",
        Node::List(_) => "list",
        Node::Compare(..) => "compare",
        Node::Join(..) => "join",
        Node::Not(_) => "not",
        _ => "",
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use torse_syntax::formula::parse;

    #[test]
    fn order_grouping_signs_and_squares_written_out_make_no_difference() {
        let same =
            |a: &str, b: &str| canonical(&parse(a).unwrap()) == canonical(&parse(b).unwrap());
        assert!(same("a - b", "-(b - a)"));
        assert!(same("2*(a*b)/c", "b*2*a/c"));
        assert!(same("w^2*a", "a*w*w"));
        assert!(!same("w^2*a", "w*a"));
        assert!(!same("a/w^2", "a/w"));
        assert!(same("a*sqrt(4)/sqrt(9)", "2*a/3"));
        assert!(same("a*sqrt(1)", "a"));
        assert!(!same("a*sqrt(2)", "a"));
    }
}
