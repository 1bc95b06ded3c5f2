//! A factor on the wrong side of a relation: `F'(1) == r*G'(0)` for `r*F'(1) == G'(0)`.

use super::edit::text;
use super::target::Target;
use torse_algebra::rational::integer;
use torse_syntax::formula::{Expr, Node, Operator, Relation};

/// An equation with a factor moved, and a description of the move.
#[derive(Debug, Clone)]
pub struct Moved {
    /// The left side.
    pub left: Expr,
    /// The right side.
    pub right: Expr,
    /// The change in words.
    pub change: String,
}

/// The sides of an equation.
#[must_use]
pub fn sides(expr: &Expr) -> Option<(&Expr, &Expr)> {
    let Node::Compare(left, rest) = &expr.node else {
        return None;
    };
    match rest.as_slice() {
        [(Relation::Equal, right)] => Some((left, right)),
        _ => None,
    }
}

/// Returns the equations with one factor of either side moved to the other whose left side agrees with the other side
/// of the target at the sample point.
#[must_use]
pub fn moved(left: &Expr, right: &Expr, target: &Target<'_>) -> Vec<Moved> {
    let change = |factor: &Expr| format!("the factor `{}` moved to the other side", text(factor));
    let times = |a: &Expr, b: &Expr| a.clone().with(Operator::Multiply, b.clone());
    let mut found = vec![];
    for (factor, rest) in factors(right) {
        // left*factor == rest
        let candidate = rest.clone().with(Operator::Divide, factor.clone());
        if target.agrees(&candidate) {
            found.push(Moved {
                left: times(&factor, left),
                right: rest,
                change: change(&factor),
            });
        }
    }
    for (factor, rest) in factors(left) {
        // rest == factor*right, where left is factor*rest
        if target.agrees(&times(&factor, &times(&factor, right))) {
            found.push(Moved {
                left: rest,
                right: times(&factor, right),
                change: change(&factor),
            });
        }
    }
    found
}

/// Returns the factors of a product, each with the rest.
fn factors(expr: &Expr) -> Vec<(Expr, Expr)> {
    let Node::Binary(Operator::Multiply, a, b) = &expr.node else {
        return vec![];
    };
    let mut found = vec![
        ((**a).clone(), (**b).clone()),
        ((**b).clone(), (**a).clone()),
    ];
    let inner = factors(a).into_iter();
    found
        .extend(inner.map(|(factor, rest)| (factor, rest.with(Operator::Multiply, (**b).clone()))));
    let one = Expr::number(&integer(1));
    found.retain(|(factor, _)| factor.node != one.node);
    found
}

#[cfg(test)]
mod tests {
    use super::*;
    use torse_syntax::formula::parse;

    #[test]
    fn each_factor_of_a_product_is_taken_out() {
        let found = factors(&parse("2*r*F'(1)").unwrap());
        let texts: Vec<String> = found
            .iter()
            .map(|(factor, rest)| format!("{} | {}", text(factor), text(rest)))
            .collect();
        assert_eq!(
            texts,
            ["2*r | F'(1)", "F'(1) | 2*r", "2 | r*F'(1)", "r | 2*F'(1)"]
        );
    }
}
