//! Joining pieces: which jet the next piece must start with, the control elements that give it, and
//! the converse, measuring a joint.
//!
//! Everything follows from one triangular system. Basis function `i` vanishes at `x = 0` to order
//! `i`, so the n-th derivative there involves control elements `0..=n` only:
//!
//! ```text
//! H^(n)(0) = r[n][0] Q[0] + .. + r[n][n] Q[n],    r = the derivative rows of the basis at 0.
//! ```
//!
//! Given a start jet, [`from_start_jet`] solves for `Q[0], Q[1], ..` in turn; the diagonal entries
//!
//! ```text
//! r[1][1] = l - 2 + pi/2 (1 + mu),
//! r[2][2] = (l-2)(l-3) + pi (l-2)(1 + mu) + pi^2/4 (1 - nu)
//! ```
//!
//! are the denominators of the papers' conditions (`a1` of gbt-surfaces Theorem 2, `c_l + pi^2 (1 - nu)`
//! of gbt-developable Theorems 3 and 4), and where one vanishes the join is singular. A
//! [`Continuity`] says what the start jet is, given the end jet of the piece before. Nothing is
//! transcribed from print, so its slips do not enter: gbt-developable Theorem 3 holds as printed, but in
//! Theorem 4 the lambda term lacks a factor four, and in gbt-surfaces eq. (5) the factor `a` is missing
//! in `a3` and a sign is wrong.

mod continuity;
mod measure;
mod recover;
mod surface;

pub use continuity::Continuity;
pub use measure::{JointMeasure, measure_curves, measure_families};
pub use recover::{from_end_jet, from_start_jet};
pub use surface::{measure_surfaces, next_surface};

use crate::basis::Basis;
use crate::coordinate::Coordinate;
use crate::curve::Curve;
use crate::error::{GeometryError, Result};
use crate::planes::{Plane, PlaneFamily};

/// The curve that continues `left`: its first control points from the condition, the rest free.
///
/// The degree of the new piece is the order of the continuity plus the number of free points.
///
/// # Errors
/// [`GeometryError::SingularJoin`] when the condition does not determine a control point,
/// [`GeometryError::TooFew`] when fewer than two control points result, [`GeometryError::NotFinite`].
///
/// ```
/// use torse_geometry::{Continuity, Curve, Gbt, join};
/// // gbt-surfaces Theorem 2: C1 between a cubic and a quartic.
/// let left = Curve::new(Gbt::new(0.5, -0.5)?, vec![[0.0, 0.0], [1.0, 1.0], [2.0, 1.0], [3.0, 0.0]])?;
/// let right = join::next_curve(
///     &left, Gbt::new(0.25, 1.0)?, &Continuity::parametric(1, &0.0), &[[5.0, 0.0], [6.0, 1.0], [7.0, 0.0]],
/// )?;
/// assert_eq!(right.degree(), 4);
/// let ratio = (2.0 + std::f64::consts::PI * 0.5) / (4.0 + std::f64::consts::PI * 1.25);
/// assert!((right.points()[1][0] - (3.0 + ratio)).abs() < 1e-14);
///
/// // With mu = -1, nu = 1 the second derivative of a cubic at its start does not depend on Q[2].
/// let error = join::next_curve(
///     &left, Gbt::new(-1.0, 1.0)?, &Continuity::parametric(2, &0.0), &[[5.0, 0.0]],
/// ).unwrap_err();
/// assert!(error.to_string().contains("order-2") && error.to_string().contains("mu: -1.0, nu: 1.0"));
/// # Ok::<(), torse_geometry::GeometryError>(())
/// ```
pub fn next_curve<S: Coordinate, L: Basis<S>, R: Basis<S>, const D: usize>(
    left: &Curve<L, S, D>,
    basis: R,
    continuity: &Continuity<S>,
    free: &[[S; D]],
) -> Result<Curve<R, S, D>> {
    let jet = continuity.start_jet(&left.end_jet(continuity.order())?)?;
    let degree = continuity.order() + free.len();
    let mut points = from_start_jet(&basis, degree, &jet)?;
    points.extend_from_slice(free);
    Curve::new(basis, points)
}

/// The plane family that continues `left`; see [`next_curve`]. For developables Farin-Boehm G2 is
/// [`Continuity::parametric`] of order two and G2-beta is [`Continuity::beta`] `[gamma, lambda]`
/// (gbt-developable Theorems 2, 3, 4).
///
/// # Errors
/// As [`next_curve`] and [`PlaneFamily::new`].
///
/// ```
/// use torse_geometry::{Continuity, Gbt, PlaneFamily, join};
/// // gbt-developable Example 5.2: all shape parameters 1, gamma = 1, lambda = 0.
/// let planes = vec![
///     [0.0, -20.0, 10.0, 400.0], [0.0, -10.0, 20.0, 400.0],
///     [0.0, 10.0, 20.0, 400.0], [0.0, 20.0, 10.0, 400.0],
/// ];
/// let left = PlaneFamily::new(Gbt::new(1.0, 1.0)?, planes)?;
/// let condition = Continuity::beta(vec![1.0, 0.0])?;
/// let right = join::next_family(&left, Gbt::new(1.0, 1.0)?, &condition, &[[0.0, 40.0, -40.0, 400.0]])?;
/// let q = right.curve().points();
/// assert_eq!(q[0], [0.0, 20.0, 10.0, 400.0]);
/// assert!((q[1][1] - 30.0).abs() < 1e-12 && q[1][2].abs() < 1e-12);
/// // Printed (45.708, -35.708); exactly 30 + 5 pi and -20 - 5 pi.
/// let five_pi = 5.0 * std::f64::consts::PI;
/// assert!((q[2][1] - (30.0 + five_pi)).abs() < 1e-12 && (q[2][2] + 20.0 + five_pi).abs() < 1e-12);
/// # Ok::<(), torse_geometry::GeometryError>(())
/// ```
///
/// Farin-Boehm G2, with the continuity measured back, also certified on balls:
///
/// ```
/// use torse_geometry::{Continuity, Gbt, Over, PlaneFamily, exact_ball, join};
/// // gbt-developable Example 5.1: the last plane is free, the first three follow.
/// let planes = vec![
///     [0.0, -20.0, 10.0, 400.0], [0.0, -10.0, 20.0, 400.0],
///     [0.0, 10.0, 20.0, 400.0], [0.0, 20.0, 10.0, 400.0],
/// ];
/// let left = PlaneFamily::new(Gbt::new(0.5, 0.25)?, planes)?;
/// let farin_boehm = Continuity::parametric(2, &0.0);
/// let right = join::next_family(&left, Gbt::new(-0.5, 0.75)?, &farin_boehm, &[[0.0, 40.0, -40.0, 400.0]])?;
/// assert_eq!(join::measure_families(&left, &right, 2)?.order_within(1e-13), Some(2));
/// // The exact defect of these f64 planes, enclosed: not zero, but at most rounding.
/// let ball = |x: &f64| exact_ball(*x, 200);
/// let exact = join::measure_families(&left.over(&ball)?, &right.over(&ball)?, 2)?;
/// for value in exact.residuals.iter().flatten() {
///     let (low, high) = value.to_f64_bounds();
///     assert!(low.abs().max(high.abs()) < 1e-9);
/// }
/// # Ok::<(), torse_geometry::GeometryError>(())
/// ```
pub fn next_family<S: Coordinate, L: Basis<S>, R: Basis<S>>(
    left: &PlaneFamily<L, S>,
    basis: R,
    continuity: &Continuity<S>,
    free: &[Plane<S>],
) -> Result<PlaneFamily<R, S>> {
    let curve = next_curve(left.curve(), basis.clone(), continuity, free)?;
    PlaneFamily::new(basis, curve.points().to_vec())
}

/// One more piece of a chain: its basis, how it joins, and its free control elements.
#[derive(Debug, Clone, PartialEq)]
pub struct Link<B, S, const D: usize> {
    /// The basis family of the piece.
    pub basis: B,
    /// The continuity with the piece before.
    pub continuity: Continuity<S>,
    /// The free control elements that follow those determined by the joint.
    pub free: Vec<[S; D]>,
}

/// A chain of curves (or, in dimension four, plane families): `first` and one piece a link.
///
/// # Errors
/// As [`next_curve`].
///
/// ```
/// use torse_geometry::{Continuity, Curve, Gbt, join};
/// let gbt = |mu: f64| Gbt::new(mu, 0.0);
/// let first = Curve::new(gbt(0.0)?, vec![[0.0], [1.0], [1.0], [0.0]])?;
/// let links: Vec<_> = (1..4)
///     .map(|i| Ok(join::Link {
///         basis: gbt(0.1 * f64::from(i))?,
///         continuity: Continuity::parametric(2, &0.0),
///         free: vec![[f64::from(i)]],
///     }))
///     .collect::<Result<_, torse_geometry::GeometryError>>()?;
/// let pieces = join::chain(first, &links)?;
/// assert_eq!(pieces.len(), 4);
/// let (end, start) = (pieces[2].end_jet(2)?, pieces[3].start_jet(2)?);
/// assert!((end[2][0] - start[2][0]).abs() < 1e-9 * end[2][0].abs());
/// # Ok::<(), torse_geometry::GeometryError>(())
/// ```
pub fn chain<S: Coordinate, B: Basis<S>, const D: usize>(
    first: Curve<B, S, D>,
    links: &[Link<B, S, D>],
) -> Result<Vec<Curve<B, S, D>>> {
    let mut pieces = vec![first];
    for link in links {
        let Some(last) = pieces.last() else { break };
        let next = next_curve(last, link.basis.clone(), &link.continuity, &link.free)?;
        pieces.push(next);
    }
    Ok(pieces)
}

/// The error for a control element that the jet does not determine.
fn singular<S: Coordinate, B: Basis<S>>(basis: &B, degree: usize, order: usize) -> GeometryError {
    GeometryError::SingularJoin {
        order,
        degree,
        parameters: format!("{basis:?}"),
    }
}
