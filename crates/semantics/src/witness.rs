//! Points as texts: reads and checks the counterexamples that are printed.

use crate::domain::Domain;
use crate::domain::point::{Outside, Point, check_hypotheses, check_sets};
use crate::judge::Judge;
use crate::judgement::Judgement;
use crate::name::Name;
use crate::no_value::Work;
use crate::real::{Real, Reals};
use crate::residue::{Residue, Residues};
use crate::tree::{Reading, Values};
use std::collections::BTreeMap;
use std::sync::Arc;
use torse_syntax::derivation::Claim;
use torse_syntax::derivation::declarations::{Declarations, SymbolKind};
use torse_syntax::formula::{Connective, Expr, Node, parse};
use torse_syntax::notation;

/// The budget of one judgement.
const POINT_WORK: u64 = 2_000_000;
/// The precision of inexact numbers, in bits.
const BITS: usize = 1280;
/// The budget for the functions of one degree.
const DEPENDENCE_WORK: u64 = 2_000_000;

/// Why a text is not a point of a claim.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
pub enum Unreadable {
    /// A name that is not a symbol, coordinate or member of the claim.
    #[error("`{name}` is no number of the claim")]
    Name {
        /// The name.
        name: String,
    },
    /// A value that is not a closed formula with a real value.
    #[error("`{value}` is no number")]
    Value {
        /// The value.
        value: String,
    },
}

/// Reads a point: names such as `a`, `p[1]`, `P[0,1]`, `P[0,1][2]`, values such as `3/7`, `pi/2`, `sqrt(2)`.
///
/// # Errors
/// [`Unreadable`] for a name that the claim does not have, or a value that is not a number.
pub fn read<'t>(
    claim: &Claim,
    numbers: impl IntoIterator<Item = (&'t str, &'t str)>,
) -> Result<Point, Unreadable> {
    let mut values = BTreeMap::new();
    for (name, value) in numbers.into_iter().filter(|(name, _)| !is_implicit(name)) {
        let unknown_name = || Unreadable::Name {
            name: name.to_owned(),
        };
        let number = number(claim, value).ok_or_else(|| Unreadable::Value {
            value: value.to_owned(),
        })?;
        let name = parse(name)
            .ok()
            .and_then(|expr| name_of(&claim.declarations, &expr))
            .ok_or_else(unknown_name)?;
        values.insert(name, number);
    }
    Ok(Point {
        values,
        near: false,
    })
}

/// Whether a name is that of a root or a logarithm, whose value the symbols determine.
fn is_implicit(name: &str) -> bool {
    let heads = [
        "sqrt(", "norm(", "abs(", "\u{221a}", "log(", "log#", "atan(", "asin(", "arc#",
    ];
    heads.iter().any(|head| name.starts_with(head))
}

/// The value of a formula without symbols.
fn number(claim: &Claim, text: &str) -> Option<Real> {
    let tree = parse(text).ok()?;
    let nothing = Claim {
        declarations: Arc::new(Declarations::default()),
        ..claim.clone()
    };
    let work = Work::new(10_000);
    let reals = Reals::new(BITS, &work);
    let values = Values {
        number: &|_: &Name| None,
        near: false,
        fails: &|_| false,
    };
    let value = Reading::new(&nothing, &tree, []).value_of(&tree, &reals, values);
    value.ok()?.number().ok()?.as_number().cloned()
}

fn name_of(declarations: &Declarations, expr: &Expr) -> Option<Name> {
    let (mut head, mut indices) = (expr, vec![]);
    while let Node::Index(inner, own) = &head.node {
        indices.splice(0..0, own.iter());
        head = inner;
    }
    let name = match &head.node {
        Node::Name(name) => name.clone(),
        // A derivative of a smooth function at a place.
        Node::Call(..) => notation::text(head),
        _ => return None,
    };
    let indices: Vec<i64> = indices.into_iter().map(integer).collect::<Option<_>>()?;
    let declared = declarations.symbol(&name)?;
    let name: Arc<str> = Arc::from(name.as_str());
    let coordinate = |c: &i64, dimension: &Option<u8>| {
        let c = u8::try_from(*c).ok()?;
        dimension.filter(|d| (1..=*d).contains(&c)).map(|_| c)
    };
    match (declared, indices.as_slice()) {
        (SymbolKind::Real(_) | SymbolKind::Integer { .. } | SymbolKind::Vector(None), []) => {
            Some(Name::Symbol(name))
        }
        (SymbolKind::Vector(dimension), [c]) => {
            Some(Name::Coordinate(name, coordinate(c, dimension)?))
        }
        (SymbolKind::Family { dimension, ranges }, all) => {
            let scalar = matches!(dimension, None | Some(1));
            let count = match (ranges.len(), scalar) {
                (0, true) => all.len(),
                (0, false) => all.len().checked_sub(1)?,
                (count, _) => count,
            };
            let (members, rest) = all.split_at_checked(count)?;
            match rest {
                [] if scalar => Some(Name::Member(name, members.to_vec(), None)),
                [c] if !scalar => {
                    let c = coordinate(c, dimension)?;
                    Some(Name::Member(name, members.to_vec(), Some(c)))
                }
                _ => None,
            }
        }
        _ => None,
    }
}

/// The value of an integer literal.
fn integer(expr: &Expr) -> Option<i64> {
    match &expr.node {
        Node::Number { value, .. } if value.is_integer() => i64::try_from(&value.to_integer()).ok(),
        Node::Negative(inner) => integer(inner)?.checked_neg(),
        _ => None,
    }
}

/// The result of checking a counterexample.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Witness {
    /// It lies in every declared set and satisfies every hypothesis, every part of the statement is defined there,
    /// and the statement is false.
    Refutes,
    /// It does not belong to the domain.
    Outside(Outside),
    /// The statement is not false there.
    Stands(Judgement),
    /// It cannot be read.
    Unreadable(Unreadable),
}

/// Checks a counterexample to a statement about the domain of a claim.
///
/// Every number that the hypotheses and the statement need must be named, including bounds of integers. For smooth
/// functions derivatives are named; any function with these derivatives will do. If no symbol is called `degree`,
/// this name gives the degree at which the functions of a basis are claimed to be dependent.
#[must_use]
pub fn check_witness<'t>(
    claim: &Claim,
    statement: &Expr,
    numbers: impl IntoIterator<Item = (&'t str, &'t str)>,
) -> Witness {
    let is_degree = |name: &str| name == "degree" && claim.declarations.symbol(name).is_none();
    let (degrees, numbers): (Vec<_>, Vec<_>) =
        numbers.into_iter().partition(|(name, _)| is_degree(name));
    let point = match read(claim, numbers) {
        Ok(point) => point,
        Err(why) => return Witness::Unreadable(why),
    };
    let names: Vec<&str> = point.values.keys().map(|name| &**name.declared()).collect();
    let reading = Reading::new(claim, statement, names);
    let degree = degrees.first().map(|(_, value)| *value);
    let dependent = || {
        degree
            .and_then(|degree| degree.parse().ok())
            .is_some_and(|degree| is_dependent(&reading, statement, degree, &point))
    };
    match check(&reading, &point) {
        Ok(Judgement::False) => Witness::Refutes,
        Ok(_) if dependent() => Witness::Refutes,
        Ok(other) => Witness::Stands(other),
        Err(outside) => Witness::Outside(outside),
    }
}

/// Checks that a point belongs to the domain of a claim, and judges the statement there.
///
/// # Errors
/// [`Outside`] if a number is not in its declared set, or a hypothesis is not true.
pub fn check(reading: &Reading<'_>, point: &Point) -> Result<Judgement, Outside> {
    let work = Work::new(POINT_WORK);
    let number = |name: &Name| {
        let named = point.values.get(name).cloned();
        named.or_else(|| reading.free(name))
    };
    let judge = Judge {
        reading,
        values: &number,
        near: point.near,
        fails: &|_| false,
        work: &work,
    };
    check_sets(reading.declarations(), &point.values, point.near)?;
    check_hypotheses(&judge, &Domain::new(reading), |_| false)?;
    let grounds = judge.evaluators();
    Ok(grounds.along(&judge, reading.given(), None).statement())
}

/// Whether a statement asserts that the functions of a basis are independent (alone or in a conjunction), and those
/// of this degree are dependent.
fn is_dependent(reading: &Reading<'_>, statement: &Expr, degree: i64, point: &Point) -> bool {
    match &statement.node {
        Node::Join(Connective::And, a, b) => {
            is_dependent(reading, a, degree, point) || is_dependent(reading, b, degree, point)
        }
        Node::Call(head, arguments) => match (&head.node, arguments.as_slice()) {
            (Node::Name(name), [family]) if name == "independent" => {
                let work = Work::new(DEPENDENCE_WORK);
                let residues = Residues { work: &work };
                let number = |name: &Name| point.values.get(name).map(Residue::from);
                let values = Values {
                    number: &number,
                    near: false,
                    fails: &|_| false,
                };
                let at = reading.at(&residues, values);
                at.are_dependent(family, degree).unwrap_or(false)
            }
            _ => false,
        },
        _ => false,
    }
}
