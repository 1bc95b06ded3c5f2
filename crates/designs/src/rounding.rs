//! Limits that are met exactly.
//!
//! The numbers of a file are decimals, rounded when they are read, and radii, thicknesses and their ratios are computed
//! from them: `0.6 / 0.4` is below 1.5 in f64. A ratio is known to within that rounding only, and where the limit lies
//! within, the limit is not said to be missed.

/// How far computed ratios are off at most, as a share of the numbers that they are computed from: some hundred
/// roundings of f64, one thousandth of a nanometre at ten metres.
const ROUNDING: f64 = 1e-13;

/// Returns the value; the limit itself where the two differ by no more than the rounding of numbers of this size.
pub(crate) fn settled(value: f64, limit: f64, size: f64) -> f64 {
    let rounding = ROUNDING * size.abs().max(value.abs()).max(limit.abs());
    if (value - limit).abs() <= rounding {
        limit
    } else {
        value
    }
}
