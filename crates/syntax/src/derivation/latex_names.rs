//! What the letters of formulas in LaTeX stand for, by the declarations of a claim.

use super::declarations::{Declarations, SymbolKind};
use crate::formula::{Expr, Node, Operator};
use crate::latex::{LatexKind, LatexNames};

/// How far definitions are followed to see whether a value is a vector.
const MAX_FOLLOWED: usize = 20;

/// The names of the declarations, with their displays.
#[must_use]
pub fn latex_names(declarations: &Declarations) -> LatexNames {
    let mut names = LatexNames::default();
    for (name, kind) in declarations.symbols() {
        let kind = match kind {
            SymbolKind::Real(_) | SymbolKind::Integer { .. } => LatexKind::Number,
            SymbolKind::Vector(_) => LatexKind::Vector,
            SymbolKind::Family { dimension, ranges } => LatexKind::Family {
                indices: ranges.len().max(1),
                is_vector: *dimension != Some(1),
            },
        };
        names.declare(name, kind);
    }
    for name in declarations.names() {
        if let Some(dimension) = declarations.function(name) {
            let parameters = vec![String::new()];
            let is_vector = dimension != Some(1);
            names.declare(
                name,
                LatexKind::Function {
                    parameters,
                    is_vector,
                },
            );
        }
    }
    for (name, basis) in declarations.bases() {
        let (degree, variable) = (
            basis.is_list.then_some(basis.degree),
            basis.variable.clone(),
        );
        names.declare(name, LatexKind::Basis { degree, variable });
    }
    for (name, definition) in declarations.definitions() {
        let shape = shape(&definition.body.expr, declarations, MAX_FOLLOWED);
        let is_vector = shape == Shape::Vector;
        let parameters = definition.parameters.clone();
        let kind = match (parameters.is_empty(), definition.indexed, shape) {
            (true, _, Shape::Vector) => LatexKind::Vector,
            (true, _, Shape::Matrix) => LatexKind::Matrix,
            (true, _, Shape::Number) => LatexKind::Number,
            (false, true, _) => LatexKind::Family {
                indices: parameters.len(),
                is_vector,
            },
            (false, false, _) => LatexKind::Function {
                parameters,
                is_vector,
            },
        };
        names.declare(name, kind);
    }
    let all: Vec<String> = names.kinds().map(|(name, _)| name.to_owned()).collect();
    for name in all {
        if let Some(display) = declarations.display(&name) {
            names.display(&name, display.trim_matches('$'));
        }
    }
    names
}

#[derive(Clone, Copy, PartialEq, Eq)]
enum Shape {
    Number,
    Vector,
    Matrix,
}

/// The shape of the values of a formula, as far as its outermost operations show it.
fn shape(formula: &Expr, declarations: &Declarations, followed: usize) -> Shape {
    let Some(followed) = followed.checked_sub(1) else {
        return Shape::Number;
    };
    let of = |formula: &Expr| shape(formula, declarations, followed);
    match &formula.node {
        Node::Number { .. } | Node::Compare(..) | Node::Join(..) | Node::Not(_) => Shape::Number,
        Node::Negative(inner) => of(inner),
        Node::List(items) => match items.first().map(|first| &first.node) {
            Some(Node::List(_)) => Shape::Matrix,
            _ => Shape::Vector,
        },
        Node::Binary(Operator::Multiply, a, b) => match (of(a), of(b)) {
            (Shape::Number, other) | (other, Shape::Number) => other,
            (_, last) => last,
        },
        Node::Binary(Operator::Divide | Operator::Power, a, _) => of(a),
        Node::Binary(_, a, b) => match of(a) {
            Shape::Number => of(b),
            other => other,
        },
        Node::Name(name) => of_name(name.trim_end_matches('\''), declarations, followed),
        Node::Index(head, indices) => match (&head.node, indices.len()) {
            (Node::Name(name), count) => match declarations.symbol(name) {
                Some(SymbolKind::Family {
                    dimension: Some(1), ..
                }) => Shape::Number,
                Some(SymbolKind::Family { ranges, .. }) if count <= ranges.len().max(1) => {
                    Shape::Vector
                }
                Some(_) => Shape::Number,
                None => match declarations.definition(name) {
                    Some(definition) if definition.indexed => of(&definition.body.expr),
                    _ => Shape::Number,
                },
            },
            _ => Shape::Number,
        },
        Node::Call(head, arguments) => match (&head.node, arguments.as_slice()) {
            (Node::Name(name), [first, ..]) if matches!(name.as_str(), "D" | "at" | "integral") => {
                of(first)
            }
            (Node::Name(name), [_, _, _, body]) if matches!(name.as_str(), "sum" | "product") => {
                of(body)
            }
            (Node::Name(name), _) if name == "cross" => Shape::Vector,
            (Node::Name(name), [_, b]) if name == "solve" => of(b),
            (Node::Name(name), _)
                if matches!(
                    name.as_str(),
                    "transpose" | "inverse" | "identity" | "coefficients"
                ) =>
            {
                Shape::Matrix
            }
            (Node::Name(name), _) => of_name(name.trim_end_matches('\''), declarations, followed),
            _ => of(head),
        },
    }
}

fn of_name(name: &str, declarations: &Declarations, followed: usize) -> Shape {
    if let Some(definition) = declarations.definition(name) {
        return shape(&definition.body.expr, declarations, followed);
    }
    match (declarations.symbol(name), declarations.function(name)) {
        (Some(SymbolKind::Vector(_)), _) => Shape::Vector,
        (_, Some(dimension)) if dimension != Some(1) => Shape::Vector,
        _ => Shape::Number,
    }
}
