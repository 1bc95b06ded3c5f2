//! Inside radii against what a material allows: what is met exactly is met.

use crate::design::Material;
use crate::numbers::number;
use crate::rounding::settled;

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
