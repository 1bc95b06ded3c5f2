//! Control elements from end jets: the triangular systems of gbt-developable Sect. 3.4, any order.

use super::singular;
use crate::basis::Basis;
use crate::coordinate::{Coordinate, is_zero};
use crate::error::{GeometryError, Result};
use crate::vector::{combine, sub};

/// The control elements `Q[0], Q[1], ..` of a piece whose derivatives at 0 are `jet = [H, H', ..]`.
///
/// # Errors
/// [`GeometryError::SingularJoin`] when a diagonal coefficient vanishes (or cannot be told from zero),
/// [`GeometryError::TooFew`] for an empty jet or one longer than the control elements.
///
/// ```
/// use torse_geometry::{Curve, Gbt, join};
/// let points = vec![[1.0], [4.0], [-2.0], [3.0], [0.5]];
/// let curve = Curve::new(Gbt::new(0.3, -0.8)?, points)?;
/// let found = join::from_start_jet(curve.basis(), 4, &curve.start_jet(3)?)?;
/// for (q, r) in found.iter().zip(curve.points()) {
///     assert!((q[0] - r[0]).abs() < 1e-12);
/// }
/// # Ok::<(), torse_geometry::GeometryError>(())
/// ```
pub fn from_start_jet<S: Coordinate, B: Basis<S>, const D: usize>(
    basis: &B,
    degree: usize,
    jet: &[[S; D]],
) -> Result<Vec<[S; D]>> {
    let like = jet.iter().flatten().next();
    let (Some(like), true) = (like, jet.len() <= degree + 1) else {
        return Err(GeometryError::TooFew {
            what: "control elements for the jet",
            needed: jet.len().max(1),
            given: if jet.is_empty() { 0 } else { degree + 1 },
        });
    };
    let rows = basis.derivative_rows(degree, &like.zero(), jet.len() - 1)?;
    let mut points: Vec<[S; D]> = Vec::with_capacity(degree + 1);
    for (order, (target, row)) in jet.iter().zip(&rows).enumerate() {
        let rest = match combine(row, &points) {
            Some(known) => sub(target, &known),
            None => target.clone(),
        };
        let pivot = row.get(order).filter(|p| !is_zero(*p));
        let pivot = pivot.ok_or_else(|| singular(basis, degree, order))?;
        let mut point = rest;
        for value in &mut point {
            *value = value
                .divided_by(pivot)
                .map_err(|_| singular(basis, degree, order))?;
        }
        points.push(point);
    }
    Ok(points)
}

/// The control elements `Q[k], Q[k-1], ..` (from the end backwards) of a piece whose derivatives at 1
/// are `jet = [H, H', ..]`.
///
/// # Errors
/// As [`from_start_jet`].
///
/// ```
/// use torse_geometry::{Curve, Gbt, join};
/// let curve = Curve::new(Gbt::new(0.3, -0.8)?, vec![[1.0], [4.0], [-2.0], [3.0]])?;
/// let found = join::from_end_jet(curve.basis(), 3, &curve.end_jet(2)?)?;
/// assert!((found[2][0] - 4.0).abs() < 1e-12);
/// # Ok::<(), torse_geometry::GeometryError>(())
/// ```
pub fn from_end_jet<S: Coordinate, B: Basis<S>, const D: usize>(
    basis: &B,
    degree: usize,
    jet: &[[S; D]],
) -> Result<Vec<[S; D]>> {
    // Traversed backwards the odd derivatives change their sign.
    let backwards: Vec<[S; D]> = jet
        .iter()
        .enumerate()
        .map(|(n, d)| {
            if n % 2 == 1 {
                std::array::from_fn(|i| -d[i].clone())
            } else {
                d.clone()
            }
        })
        .collect();
    from_start_jet(&basis.reversed(), degree, &backwards)
}
