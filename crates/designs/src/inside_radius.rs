//! Inside radii against what a material and a table allow: what is met exactly is met.
//!
//! The numbers of a file are decimals, rounded when they are read, and the radius, the thickness and their ratio are
//! computed from them: `0.6 / 0.4` is below 1.5 in f64. The ratio is known to within that rounding only, and where the
//! limit lies within, the limit is not said to be missed.

use crate::design::Material;
use crate::inspect::number;

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

/// Returns the inside radius as a multiple of the thickness where the designed surface, at this share of the thickness from
/// the inside, has this radius in millimetres. `size` is that of the coordinates which the radius comes from. The least
/// ratio that the material allows is given exactly where it is met.
pub(crate) fn inside_ratio(metal: &Material, radius: f64, share: f64, size: f64) -> f64 {
    let thickness = metal.sheet.thickness();
    let ratio = radius / thickness - share;
    settled(
        ratio,
        metal.least_radius,
        size.max(radius) / thickness + 1.0,
    )
}

/// Returns what is said of an inside radius that is smaller than the material allows; nothing where it is not. `what` names
/// the radius, and the designed surface is at this share of the thickness from the inside.
pub(crate) fn objection(metal: &Material, share: f64, what: &str, ratio: f64) -> Option<String> {
    let least = metal.least_radius;
    if ratio >= least {
        return None;
    }
    if ratio < 0.0 {
        let thickness = metal.sheet.thickness();
        return Some(format!(
            "{what} would be negative, and is to be {least} times the thickness at least: the designed surface has a radius \
             of {} mm, and the inside of the sheet is {} mm nearer to the centre",
            number((ratio + share) * thickness),
            number(share * thickness)
        ));
    }
    // So many digits that it is seen to be smaller.
    let shown = (4..=17)
        .map(|digits| format!("{ratio:.digits$}"))
        .find(|shown| shown.parse::<f64>().is_ok_and(|shown| shown < least))
        .unwrap_or_else(|| format!("{ratio:e}"));
    Some(format!(
        "{what} is {shown} times the thickness, {least} at least"
    ))
}
