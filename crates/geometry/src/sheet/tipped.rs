//! Whole panels between rails that start or end in one point, where the rulings join equal parameters.
//!
//! In such a point, a *tip*, `F(s, t) = det(P'(s), Q'(t), Q(t) - P(s))` vanishes to second order, so that no branch of
//! solutions is proved up to it. Where `F(s, s)` is the zero function, decided on the exact control data, the ruled
//! surface between equal parameters is developable from end to end, tips and all. That is so of the gores of cylinders and
//! cones, of rails of one plane, and of rails that mirror each other.

use super::{PiecewiseRail, Rail, Sheet};
use crate::error::Result;
use crate::surface::Rails;
use crate::vector::{cross, dot, sub};

/// Rulings on which both tangent planes have to have the sheet on the same side.
const RULINGS: u32 = 128;

/// Returns the sheet of rulings between equal parameters of rails that meet at an end; `None` where they do not meet, or
/// where these rulings are no developable, or have its sheet on both sides.
pub(super) fn tipped_sheet(first: &PiecewiseRail, second: &PiecewiseRail) -> Result<Option<Sheet>> {
    let (Some(first), Some(second)) = (first.single()?, second.single()?) else {
        return Ok(None);
    };
    if !meet_at_an_end(&first, &second)? || !have_one_side(&first, &second)? {
        return Ok(None);
    }
    let sheet = Sheet::ruled(first, second);
    Ok(Rails::<f64>::is_developable_by_construction(&sheet).then_some(sheet))
}

fn meet_at_an_end(first: &Rail, second: &Rail) -> Result<bool> {
    for end in [0.0, 1.0] {
        if first.point(end)? == second.point(end)? {
            return Ok(true);
        }
    }
    Ok(false)
}

/// Returns whether the normals at both ends point to one side on rulings between the ends, and go on to do so from
/// ruling to ruling: they turn over where the rails cross.
fn have_one_side(first: &Rail, second: &Rail) -> Result<bool> {
    let mut before = None;
    for k in 1..RULINGS {
        let x = f64::from(k) / f64::from(RULINGS);
        let ruling = sub(&second.point(x)?, &first.point(x)?);
        let [one, two] = [first.derivative(x)?, second.derivative(x)?];
        let normals = [cross(&one, &ruling), cross(&two, &ruling)];
        let turns = before.is_some_and(|before| dot(&before, &normals[0]) <= 0.0);
        if turns || dot(&normals[0], &normals[1]) <= 0.0 {
            return Ok(false);
        }
        before = Some(normals[0]);
    }
    Ok(true)
}
