//! Any surface of the library as a B-spline within a proved distance.

use super::hermite::{BITS, Splines, splines};
use super::patch::{BsplinePatch, Knots};
use super::{Converted, rounded_up};
use crate::error::Result;
use torse_algebra::{Ball, Jet};
use torse_geometry::basis::BasisShape;
use torse_geometry::{
    Basis, Bernstein, Curve, Gbt, Over, Rails, SpaceCurve, TensorSurface, exact_ball,
};

/// A ruled patch as one B-spline of degree 5 along the rails (C2, with threefold knots) and 1 along the
/// rulings, at most `tolerance` away.
///
/// The distance is proved: it is that between points of equal parameters, bounded in ball arithmetic (each rail
/// is approximated by the Hermite spline of its values and two derivatives; a point of a ruling is as near as the
/// ends are). Rulings go to rulings, so the B-spline is as developable as the tolerance lets it be; it is
/// declared developable when the patch is by construction.
///
/// # Errors
/// [`ExchangeError::NotReached`](crate::ExchangeError::NotReached) where 4096 pieces do not suffice, near a
/// singular rail for instance; [`ExchangeError::OutOfRange`](crate::ExchangeError::OutOfRange) unless the
/// tolerance is positive; what the patch refuses.
///
/// ```
/// use torse_exchange::approximate;
/// use torse_geometry::{PatchBounds, EnvelopingPatch, Gbt, PlaneFamily};
/// let planes = vec![[7., -7., 5., 125.], [-7., -7., 5., 120.], [-7., 7., 5., 130.], [7., 7., 5., 125.]];
/// let family = PlaneFamily::new(Gbt::new(0.5, 0.25)?, planes)?;
/// let sheet = EnvelopingPatch::new(family, PatchBounds::Planes([[0., 0., 1., 0.], [0., 0., 1., 3.]]))?;
/// let converted = approximate(&sheet, 1e-3)?;
/// assert!(converted.error <= 1e-3 && converted.patches.len() == 1);
/// assert!(converted.patches[0].is_declared_developable());
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn approximate<P>(patch: &P, tolerance: f64) -> Result<Converted>
where
    P: Over<f64, Ball, Object: Rails<Ball>>,
{
    let patch = patch.over(&|x| exact_ball(*x, BITS))?;
    let rails = splines(
        &|x, order| Ok(patch.rail_jets(x, order)?.to_vec()),
        tolerance,
    )?;
    let [first, second] = rails.points.as_slice() else {
        return Ok(Converted {
            patches: Vec::new(),
            error: 0.0,
        });
    };
    let net = first
        .iter()
        .zip(second)
        .map(|(p, q)| vec![*p, *q])
        .collect();
    let knots = [Knots::clamped(5, rails.breaks, 3), Knots::bezier(1)];
    let converted = Converted {
        patches: vec![BsplinePatch::new([5, 1], knots, net, None)?],
        error: rails.error,
    };
    if patch.is_developable_by_construction() {
        return Ok(converted.declared_developable());
    }
    Ok(converted)
}

/// A tensor product as one B-spline of degree 5 in both directions (C2, with threefold knots), at most
/// `tolerance` away.
///
/// The distance is proved like that of [`approximate`]: first the columns of the net become splines in `u`, and
/// since the basis functions in `v` are nonnegative with sum one no point moves farther than the worst
/// column; then, likewise, the rows in `v`.
///
/// # Errors
/// As [`approximate`].
///
/// ```
/// use torse_exchange::approximate_tensor;
/// use torse_geometry::{Gbt, TensorSurface};
/// let net = (0..4).map(|i| (0..3).map(|j| [f64::from(i), f64::from(j), f64::from(i * j)]).collect()).collect();
/// let surface = TensorSurface::new(Gbt::new(0.5, 0.25)?, Gbt::new(-1.0, 0.0)?, net)?;
/// assert!(approximate_tensor(&surface, 1e-6)?.error <= 1e-6);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn approximate_tensor<U, V>(
    surface: &TensorSurface<U, V, f64>,
    tolerance: f64,
) -> Result<Converted>
where
    U: ConvexBasis,
    V: ConvexBasis,
{
    let (u, v) = surface.bases();
    let rows: Vec<Vec<[f64; 3]>> = surface.rows().map(<[_]>::to_vec).collect();
    let in_u = along(u, transposed(&rows), 0.5 * tolerance)?;
    let in_v = along(v, transposed(&in_u.points), 0.5 * tolerance)?;
    let knots = [
        Knots::clamped(5, in_u.breaks, 3),
        Knots::clamped(5, in_v.breaks, 3),
    ];
    Ok(Converted {
        patches: vec![BsplinePatch::new([5, 5], knots, in_v.points, None)?],
        error: rounded_up(in_u.error + in_v.error),
    })
}

/// A basis whose functions are nonnegative with sum one on [0, 1], which can be carried to balls.
pub trait ConvexBasis: Basis<f64> + Over<f64, Ball, Object: Basis<Ball>> {}

impl ConvexBasis for Bernstein {}

/// The shape parameters lie in [-1, 1], where the functions are nonnegative.
impl ConvexBasis for Gbt<f64> {}

impl ConvexBasis for BasisShape<f64> {}

/// The splines of the curves with these control points.
fn along<B: ConvexBasis>(basis: &B, curves: Vec<Vec<[f64; 3]>>, tolerance: f64) -> Result<Splines> {
    let ball = |x: &f64| exact_ball(*x, BITS);
    let lifted = |points: Vec<[f64; 3]>| {
        let points = points.iter().map(|p| p.each_ref().map(ball)).collect();
        Curve::new(basis.over(&ball)?, points)
    };
    let curves: Vec<Curve<B::Object, Ball, 3>> = curves
        .into_iter()
        .map(lifted)
        .collect::<torse_geometry::Result<_>>()?;
    let series = |x: &Ball, order: usize| -> torse_geometry::Result<Vec<[Jet<Ball>; 3]>> {
        curves.iter().map(|c| c.space_jet(x, order)).collect()
    };
    splines(&series, tolerance)
}

fn transposed(rows: &[Vec<[f64; 3]>]) -> Vec<Vec<[f64; 3]>> {
    let columns = rows.first().map_or(0, Vec::len);
    let column = |j: usize| rows.iter().filter_map(|row| row.get(j).copied()).collect();
    (0..columns).map(column).collect()
}
