//! Two sides of a comparison with the angles of each variable in one unit, and the parts of each exponent.

use super::quantity::Quantity;
use super::series::Series;
use super::value::Value;
use torse_algebra::{ExactError, Finest, Fraction, Symbol};
use torse_syntax::fault::Fault;
use torse_syntax::formula::Place;

/// Both sides in the finest parts of angles and exponents that occur in either, so that a difference is zero in its normal form if it
/// is the zero function.
///
/// # Errors
/// [`Fault`] for a divisor that is the zero function.
pub(super) fn in_finest(left: Value, right: Value, place: Place) -> Result<(Value, Value), Fault> {
    let mut angles: Vec<Symbol> = vec![];
    let mut look = |fraction: &Fraction| {
        let conditions = fraction.conditions().iter().flat_map(|p| p.symbols());
        let all = fraction.symbols().into_iter().chain(conditions.cloned());
        angles.extend(
            all.filter(|s| matches!(s, Symbol::Sin(..) | Symbol::Cos(..) | Symbol::Exp(_))),
        );
    };
    for quantity in left.entries().into_iter().chain(right.entries()) {
        look(&quantity.plain);
        quantity
            .series
            .iter()
            .flat_map(Series::parts)
            .for_each(&mut look);
    }
    let finest = Finest::new(angles.iter());
    if finest.is_empty() {
        return Ok((left, right));
    }
    let write = |fraction: &Fraction| {
        finest
            .write(fraction)
            .ok_or_else(|| ExactError::DivisionByZero {
                divisor: fraction.denominator().to_string(),
            })
    };
    let change = |quantity: &Quantity| quantity.mapped(write).map_err(|e| Fault::exact(place, e));
    Ok((left.mapped(&change)?, right.mapped(&change)?))
}
