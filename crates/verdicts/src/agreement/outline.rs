//! A core statement as a list of words and values, as `torse_semantics` lists the pieces of a tree.

use super::terms::Terms;
use std::sync::Arc;
use torse_algebra::{Rational, rational};
use torse_core::{Family, FamilyProperty, Node, Printed, Statement, Term};
use torse_semantics::tree::{BASIS_AT, BASIS_DEGREES, Outline, Piece, printed_number, word};
use torse_semantics::{Class, NoValue, Series, Value};
use torse_syntax::formula::Place;

/// Words and values of core terms.
pub(super) type CoreOutline<'c> = Outline<&'c Term, Class>;

/// The outline of a core statement.
pub(super) fn outline<'c>(statement: &'c Statement, at: &Terms<'_>) -> CoreOutline<'c> {
    let mut all = vec![];
    let mut pending = vec![statement];
    while let Some(statement) = pending.pop() {
        match statement {
            Statement::Compare {
                relation,
                left,
                right,
            } => {
                all.push(Piece::Word(relation.sign().to_owned()));
                all.extend([left, right].map(|side| Piece::Value(Some(side), at.value(side))));
            }
            Statement::Agrees { value, printed, .. } => {
                let printed: Vec<String> = printed.iter().map(printed_word).collect();
                all.push(Piece::Word(format!("agrees {}", printed.join(", "))));
                all.push(Piece::Value(Some(value), at.value(value)));
            }
            Statement::Join(connective, a, b) => {
                all.push(Piece::Word(word(*connective)));
                pending.extend([&**b, &**a]);
            }
            Statement::Not(inner) => {
                all.push(Piece::Word("fails".to_owned()));
                pending.push(inner);
            }
            Statement::Family(property, family) => {
                let (name, degrees) = match property {
                    FamilyProperty::Nonnegative => ("nonnegative", vec![]),
                    FamilyProperty::Independent => ("independent", vec![]),
                    FamilyProperty::VariationDiminishing(degrees) => {
                        let degrees = degrees.iter().flat_map(|d| [d.least, d.most]);
                        ("variation_diminishing", degrees.collect())
                    }
                };
                all.push(Piece::Word(format!(
                    "{name} {degrees:?} from {}",
                    family.degree
                )));
                let least = i64::from(family.degree);
                for degree in least..least + BASIS_DEGREES {
                    let row = (0..=degree).map(|i| {
                        let term = basis_function(family, i, degree);
                        at.value(&term)?.number()
                    });
                    let row = row.collect::<Result<Vec<Series<Class>>, NoValue>>();
                    all.push(Piece::Value(None, row.map(Value::vector)));
                }
            }
        }
    }
    all
}

fn printed_word(printed: &Printed) -> String {
    let size = match printed.negative {
        true => -printed.value.clone(),
        false => printed.value.clone(),
    };
    printed_number(&size, printed.decimals, printed.negative)
}

/// A function of a basis at one value of its variable, with the shape parameters of the point.
fn basis_function(family: &Arc<Family>, index: i64, degree: i64) -> Term {
    let made = |node| Term {
        node: Arc::new(node),
        place: Place::default(),
    };
    let number = |n: i64| made(Node::Number(rational::integer(n)));
    let (u, v) = BASIS_AT;
    let variable = made(Node::Number(Rational::new(u.into(), v.into())));
    let parameters = family.parameters();
    let parameters = parameters.map(|name| made(Node::Symbol(Arc::from(name))));
    made(Node::Basis {
        family: Arc::clone(family),
        index: number(index),
        degree: number(degree),
        arguments: std::iter::once(variable).chain(parameters).collect(),
    })
}
