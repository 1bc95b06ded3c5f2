//! Properties of a basis family at one point: at its shape parameters, and at small degrees.
//!
//! A property speaks about every degree and all values of the variables; a point has one value of each. At a point are
//! judged, for the degree of the seeds and the next ones, or for one of the degrees that the statement names, drawn by the
//! values of the point:
//!
//! - *nonnegative*: the signs of all functions at the value of the variable;
//! - *independent*: functions are independent if the determinant of their values at as many arguments is not zero
//!   (if it is zero nothing follows);
//! - *variation diminishing*: for control values and a line made from the value of the variable, changes of sign are
//!   counted along arguments of the interval. More than the polygon has disprove the property; that no more are seen
//!   is one more trial that it stood.

use crate::arithmetic::Arithmetic;
use crate::domain::set;
use crate::domain::stream::Stream;
use crate::evaluate::Evaluator;
use crate::gap::{Gap, Unknown, Work};
use crate::judgement::Judgement;
use crate::linear;
use crate::name::Name;

use crate::real::{Real, Reals};
use crate::residue::{Residue, Residues};
use crate::scope::Scope;
use crate::series::Series;
use crate::value::Value;
use std::cmp::Ordering;
use std::sync::Arc;
use torse_core::{Claim, Family, FamilyProperty};
use torse_numbers::Rational;
use torse_numbers::rational::integer;

/// How many degrees are looked at.
const DEGREES: i64 = 3;
/// How many polygons are tried at a point, and at how many arguments.
const POLYGONS: u64 = 6;
const ARGUMENTS: i64 = 24;
/// How often functions have to look dependent to be so.
const TRIALS: u64 = 3;
/// Into how many parts the unit is divided for their arguments: 2^7 times 3^2 and 7, so that angles have residues.
const ARGUMENT_PARTS: i64 = 8_064;

type At<'a, 'b> = Evaluator<'a, Reals<'b>>;

/// Judges a property.
pub(crate) fn judge(
    property: FamilyProperty,
    family: &Arc<Family>,
    claim: &Claim,
    at: &At<'_, '_>,
) -> Result<Judgement, Gap> {
    let values: Vec<Real> = family
        .variables
        .iter()
        .map(|v| at.point_value(&Name::Symbol(Arc::from(v.name()))))
        .collect::<Result<_, _>>()?;
    let least = i64::from(family.degree);
    let degrees = match property {
        FamilyProperty::VariationDiminishing(Some(degrees)) => {
            let (least, most) = (i64::from(degrees.least), i64::from(degrees.most));
            let drawn = least + stream_of(&values, 0).below("degree", most - least + 1);
            drawn..=drawn
        }
        _ => least..=least + DEGREES - 1,
    };
    let mut all = Judgement::True;
    for degree in degrees {
        let found = match property {
            FamilyProperty::Nonnegative => nonnegative(family, degree, &values, at)?,
            FamilyProperty::Independent => independent(family, degree, &values, claim, at)?,
            FamilyProperty::VariationDiminishing(_) => {
                diminishing(family, degree, &values, claim, at)?
            }
        };
        match found {
            Some(false) => return Ok(Judgement::False),
            Some(true) => {}
            None => all = Judgement::Undecided,
        }
    }
    Ok(all)
}

fn functions(
    family: &Arc<Family>,
    degree: i64,
    values: &[Real],
    at: &At<'_, '_>,
) -> Result<Vec<Series<Real>>, Gap> {
    let arguments = values
        .iter()
        .map(|v| Value::Number(Series::Number(v.clone())))
        .collect();
    let functions = at.functions(family, degree, arguments, &Scope::outermost())?;
    Ok(functions.to_vec())
}

fn nonnegative(
    family: &Arc<Family>,
    degree: i64,
    values: &[Real],
    at: &At<'_, '_>,
) -> Result<Option<bool>, Gap> {
    let mut all = Some(true);
    for function in functions(family, degree, values, at)? {
        match function.as_number().and_then(Real::sign) {
            Some(Ordering::Less) => return Ok(Some(false)),
            Some(_) => {}
            None => all = None,
        }
    }
    Ok(all)
}

/// The functions at arguments of the interval of the variable, in increasing order.
fn sampled(
    family: &Arc<Family>,
    degree: i64,
    values: &[Real],
    count: i64,
    claim: &Claim,
    at: &At<'_, '_>,
) -> Result<Vec<Vec<Series<Real>>>, Gap> {
    let variable = family.variables.first().ok_or(Unknown::Precision)?;
    let interval = claim.symbols.get(variable.name());
    let mut rows = vec![];
    for step in 1..=count {
        let share = Rational::new(step.into(), (count + 1).into());
        let argument = set::between(interval, &share);
        let mut arguments = values.to_vec();
        if let Some(slot) = arguments.first_mut() {
            *slot = argument;
        }
        rows.push(functions(family, degree, &arguments, at)?);
    }
    Ok(rows)
}

fn independent(
    family: &Arc<Family>,
    degree: i64,
    values: &[Real],
    claim: &Claim,
    at: &At<'_, '_>,
) -> Result<Option<bool>, Gap> {
    let rows = sampled(family, degree, values, degree + 1, claim, at)?;
    let determinant = linear::determinant(&rows, at.arithmetic)?;
    Ok(match determinant.is_zero(at.arithmetic) {
        Some(false) => Some(true),
        _ => None,
    })
}

/// Whether the functions of one degree are dependent at the shape parameters of a point: the determinant of their values at as
/// many arguments as there are functions is zero modulo a prime, each time that arguments are drawn. Of independent functions
/// that happens by an accident alone, whose chance is about the degree of the functions divided by the number of arguments
/// that may be drawn, each time.
pub(crate) fn dependent(
    family: &Arc<Family>,
    degree: i64,
    value: &dyn Fn(&Name) -> Option<Real>,
    work: &Work,
) -> Result<bool, Gap> {
    let residues = Residues { work };
    let residue = |name: &Name| value(name).as_ref().map(Residue::from);
    let at = Evaluator::new(&residues, &residue);
    let own: Vec<Residue> = family
        .variables
        .iter()
        .skip(1)
        .map(|v| at.point_value(&Name::Symbol(Arc::from(v.name()))))
        .collect::<Result<_, _>>()?;
    for trial in 0..TRIALS {
        let stream = Stream::new(&family.name, trial);
        let mut rows = vec![];
        for place in 0..=degree {
            // The sine and cosine of a quarter turn times the argument have residues.
            let whole = ARGUMENT_PARTS;
            let share = 1 + stream.below(&format!("argument {place}"), whole - 1);
            let argument =
                residues.rational(&Rational::new(share.into(), whole.unsigned_abs().into()));
            let arguments = std::iter::once(argument).chain(own.iter().copied());
            let arguments = arguments
                .map(|n| Value::Number(Series::Number(n)))
                .collect();
            let functions = at.functions(family, degree, arguments, &Scope::outermost())?;
            rows.push(functions.to_vec());
        }
        let determinant = linear::determinant(&rows, &residues)?;
        if determinant.is_zero(&residues) != Some(true) {
            return Ok(false);
        }
    }
    Ok(true)
}

fn diminishing(
    family: &Arc<Family>,
    degree: i64,
    values: &[Real],
    claim: &Claim,
    at: &At<'_, '_>,
) -> Result<Option<bool>, Gap> {
    let a = at.arithmetic;
    let rows = sampled(family, degree, values, ARGUMENTS, claim, at)?;
    for polygon in 0..POLYGONS {
        let stream = stream_of(values, polygon);
        let line = Rational::new((2 * stream.below("line", 4) + 1).into(), 2.into());
        let controls: Vec<Rational> = (0..=degree)
            .map(|i| integer(stream.below(&format!("control {i}"), 4)) - &line)
            .collect();
        let line = Series::rational(&line, a);
        let mut along = vec![];
        for row in &rows {
            let mut height = line.negated(a);
            for (function, control) in row.iter().zip(&controls) {
                // The control value, not its distance from the line: the functions need not sum to one.
                let control = Series::rational(control, a).plus(&line, a)?;
                height = height.plus(&function.times(&control, a)?, a)?;
            }
            along.extend(height.as_number().and_then(Real::sign));
        }
        let polygon = controls.iter().filter_map(|c| Real::from(c.clone()).sign());
        if changes(along) > changes(polygon) {
            return Ok(Some(false));
        }
    }
    Ok(Some(true))
}

/// Choices that the values of a point determine.
fn stream_of(values: &[Real], number: u64) -> Stream {
    let text: Vec<String> = values.iter().map(ToString::to_string).collect();
    Stream::new(&text.join(","), number)
}

/// Changes of sign, zeros left out.
fn changes(signs: impl IntoIterator<Item = Ordering>) -> usize {
    let signs: Vec<Ordering> = signs.into_iter().filter(|s| s.is_ne()).collect();
    signs
        .windows(2)
        .filter(|pair| pair.first() != pair.last())
        .count()
}
