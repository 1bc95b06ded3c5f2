//! Evaluation of many points at once into the caller's buffers, on f64.
//!
//! Basis rows are computed once for each parameter; a grid row then combines the control net in `u` and
//! is a dot product in `v` for each point. Nothing is allocated for a point, the inner loops have
//! constant bounds for the usual degrees and vectorise, and the cost reaches that of storing the
//! points. Functions named `par_` share the rows of large grids among threads; results do not depend
//! on the number of threads, for every point is computed by the same operations.

mod curves;
mod grid;
mod lanes;
mod registers;
mod table;
mod wide;

pub(crate) use wide::widest;

pub use grid::{GridEvaluator, par_ruled_grid_into, ruled_grid_into};
pub use table::BasisTable;

use crate::error::{GeometryError, Result};

fn check_length(what: &'static str, expected: usize, given: usize) -> Result<()> {
    if expected == given {
        return Ok(());
    }
    Err(GeometryError::LengthMismatch {
        what,
        index: 0,
        expected,
        given,
    })
}
