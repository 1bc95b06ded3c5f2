//! Pictures: the patches in space and, beside them, their pattern; the sheet as it bends.

mod bands;
mod bending;
mod page;
mod picture;

pub use bending::{MAX_GIF_BYTES, bending};
pub use page::page;
pub use picture::picture;

pub(crate) use bands::{PatchStyle, grids, solids};

use crate::design::{Design, FreeSurface, Patch, Tensor};
use crate::error::DesignError;
use torse_geometry::batch::GridEvaluator;
use torse_geometry::prelude::Point;

/// The endings of pictures.
pub const ENDINGS: &[&str] = &["png", "svg", "html", "gif"];

/// Returns the points of a patch on equal steps, ruling by ruling.
pub(crate) fn samples(
    patch: &Patch,
    along: usize,
    across: usize,
) -> Result<Vec<Point>, DesignError> {
    #[allow(clippy::cast_precision_loss)]
    let share = |k: usize, of: usize| k as f64 / of as f64;
    let mut points = Vec::with_capacity((along + 1) * (across + 1));
    for i in 0..=along {
        let ends = patch.sheet.ruling(share(i, along));
        let [p, q] = ends.map_err(|reason| DesignError::Patch {
            patch: patch.name.clone(),
            reason,
        })?;
        for j in 0..=across {
            points.push(torse_geometry::vector::lerp(&p, &q, &share(j, across)));
        }
    }
    Ok(points)
}

/// Returns the points of a surface on equal steps.
fn grid(
    surface: &FreeSurface,
    part: &Tensor,
    along: usize,
    across: usize,
) -> Result<Vec<Point>, DesignError> {
    let steps = |count: usize| -> Vec<f64> {
        #[allow(clippy::cast_precision_loss)]
        (0..=count).map(|k| k as f64 / count as f64).collect()
    };
    let failed = |reason| DesignError::Patch {
        patch: surface.name.clone(),
        reason,
    };
    let grid = GridEvaluator::new(part, &steps(along), &steps(across)).map_err(failed)?;
    let mut points = vec![[0.0; 3]; grid.len()];
    grid.fill(&mut points).map_err(failed)?;
    Ok(points)
}

/// Returns how many rulings are drawn on each patch, so that they stay apart.
pub(crate) fn lines(design: &Design) -> usize {
    (64 / design.patches.len().max(1)).clamp(1, design.view.rulings.saturating_sub(1).clamp(1, 32))
}
