//! Joining tensor-product surfaces along a boundary `u = 1`.
//!
//! Each column of the control net is the control polygon of a curve in `u`, and derivatives across the
//! boundary act on columns alone. So surfaces with the same basis and degree in `v` join as their
//! columns do: cylinders, swung, swept and ruled surfaces (gbt-surfaces Propositions 3.4, 3.7 and
//! Algorithms 1, 3, 4, 5) are all of this kind.

use super::measure::{JointMeasure, measure_curves};
use super::{Continuity, next_curve};
use crate::basis::Basis;
use crate::coordinate::Coordinate;
use crate::curve::Curve;
use crate::error::{GeometryError, Result};
use crate::surface::TensorSurface;

/// The surface that continues `left` across its boundary `u = 1`: its first control rows from the
/// condition, the rest free (`free[r]` is a row, as long as those of `left`). The basis in `v` is kept.
///
/// # Errors
/// [`GeometryError::LengthMismatch`] for a free row of another length, and as [`next_curve`].
///
/// ```
/// use torse_geometry::{Continuity, Curve, Gbt, TensorSurface, join};
/// // Two cylinders with C2 contact (gbt-surfaces Table 1 and Figure 6).
/// let points = vec![[5.0, 2.0, 0.0], [0.0, 12.0, 0.0], [10.0, 20.0, 0.0], [20.0, 12.0, 0.0]];
/// let directrix = Curve::new(Gbt::new(0.9, 0.25)?, points)?;
/// let left = TensorSurface::cylinder(&directrix, &[0.0, 0.0, 1.0], &20.0)?;
/// let last = vec![[30.0, 2.0, 0.0], [30.0, 2.0, 20.0]];
/// let c2 = Continuity::parametric(2, &0.0);
/// let right = join::next_surface(&left, Gbt::new(-0.5, 0.5)?, &c2, &[last])?;
/// // The continuation is a cylinder again: its second column is the first, lifted.
/// for row in right.rows() {
///     assert!((row[1][2] - row[0][2] - 20.0).abs() < 1e-9 && (row[1][0] - row[0][0]).abs() < 1e-9);
/// }
/// for column in join::measure_surfaces(&left, &right, 2)? {
///     assert_eq!(column.order_within(1e-12), Some(2));
///     assert!((column.betas[0] - 1.0).abs() < 1e-12);
/// }
/// # Ok::<(), torse_geometry::GeometryError>(())
/// ```
pub fn next_surface<S: Coordinate, L: Basis<S>, R: Basis<S>, V: Basis<S>>(
    left: &TensorSurface<L, V, S>,
    basis: R,
    continuity: &Continuity<S>,
    free: &[Vec<[S; 3]>],
) -> Result<TensorSurface<R, V, S>> {
    let width = left.degrees().1 + 1;
    if let Some((index, row)) = free.iter().enumerate().find(|(_, row)| row.len() != width) {
        let (what, given) = ("free control row", row.len());
        return Err(GeometryError::LengthMismatch {
            what,
            index,
            expected: width,
            given,
        });
    }
    let mut columns: Vec<Curve<R, S, 3>> = Vec::with_capacity(width);
    for index in 0..width {
        let below: Vec<[S; 3]> = free
            .iter()
            .filter_map(|row| row.get(index).cloned())
            .collect();
        columns.push(next_curve(
            &left.column_curve(index)?,
            basis.clone(),
            continuity,
            &below,
        )?);
    }
    let rows = continuity.order() + 1 + free.len();
    let row = |k: usize| {
        columns
            .iter()
            .filter_map(|c| c.points().get(k).cloned())
            .collect()
    };
    TensorSurface::new(basis, left.bases().1.clone(), (0..rows).map(row).collect())
}

/// Measures the joint of `left` (at `u = 1`) and `right` (at `u = 0`) up to `order`, column by column.
///
/// The surfaces have this contact with *one* reparametrization across the boundary when the beta values
/// of all columns agree.
///
/// # Errors
/// [`GeometryError::LengthMismatch`] when the nets have different numbers of columns,
/// [`GeometryError::Degenerate`] when a column stands still at the boundary,
/// [`GeometryError::DifferentBases`] when those in `v` differ.
pub fn measure_surfaces<S: Coordinate, L: Basis<S>, R: Basis<S>, V: Basis<S> + PartialEq>(
    left: &TensorSurface<L, V, S>,
    right: &TensorSurface<R, V, S>,
    order: usize,
) -> Result<Vec<JointMeasure<S, 3>>> {
    let (expected, given) = (left.degrees().1 + 1, right.degrees().1 + 1);
    if expected != given {
        let what = "columns of the control net";
        return Err(GeometryError::LengthMismatch {
            what,
            index: 1,
            expected,
            given,
        });
    }
    if left.bases().1 != right.bases().1 {
        return Err(GeometryError::DifferentBases {
            what: "joint of surfaces with different bases along it",
            first: format!("{:?}", left.bases().1),
            second: format!("{:?}", right.bases().1),
        });
    }
    let column = |i| measure_curves(&left.column_curve(i)?, &right.column_curve(i)?, order);
    (0..expected).map(column).collect()
}
