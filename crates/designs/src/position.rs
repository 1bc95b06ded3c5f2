//! Where a patch is in a pattern.

use crate::design::Patch;
use torse_geometry::pattern::{FlatPattern, PatternPlace};
use torse_geometry::vector::{norm, sub};

/// Returns the index of a patch in the chain of its pattern, which may be passed the other way round.
pub fn position(flat: &FlatPattern, patch: &Patch) -> Option<usize> {
    let distance = |index: usize| {
        [[0.0, 0.0], [0.5, 1.0], [1.0, 0.0], [1.0, 1.0]]
            .into_iter()
            .map(|[x, v]| {
                let place = PatternPlace { piece: index, x, v };
                let (Some(there), Ok(here)) = (flat.space(place), patch.sheet.point(x, v)) else {
                    return f64::INFINITY;
                };
                norm(&sub(&here, &there))
            })
            .fold(0.0, f64::max)
    };
    let all = (0..flat.pieces()).map(|index| (distance(index), index));
    let nearest = all.min_by(|a, b| a.0.total_cmp(&b.0));
    nearest.map(|(_, index)| index)
}
