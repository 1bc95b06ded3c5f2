//! Measuring a joint: which continuity it has, with which beta values, to which order.

use super::continuity::transform;
use crate::basis::Basis;
use crate::coordinate::{Coordinate, is_zero};
use crate::curve::Curve;
use crate::error::{GeometryError, Place, Result};
use crate::planes::PlaneFamily;
use crate::vector::{scale, sub};
use std::cmp::Ordering;
use torse_algebra::Ball;

/// What a joint satisfies: best-fitting beta (and scale) values and what is left over, order by order.
///
/// On exact scalars the residuals are exactly zero or not; on balls they are enclosures, with
/// [`residual_bounds`](JointMeasure::residual_bounds); on f64 judge them with
/// [`order_within`](JointMeasure::order_within) and a tolerance that fits the data.
#[derive(Debug, Clone, PartialEq)]
pub struct JointMeasure<S, const D: usize> {
    /// The beta values `b1, b2, ..` that fit best, one for each order measured.
    pub betas: Vec<S>,
    /// The factor's derivatives `rho, rho', ..` (for curves `1, 0, ..`).
    pub scale: Vec<S>,
    /// Right minus transformed left jet, from order zero.
    pub residuals: Vec<[S; D]>,
    /// The right jet, to compare the residuals with.
    right: Vec<[S; D]>,
}

impl<S: Coordinate, const D: usize> JointMeasure<S, D> {
    /// The highest order up to which all residuals are known to be zero, and zero when the pieces turn back
    /// in a cusp (`b1 <= 0`); `None` when even the ends differ (or, for enclosures, when nothing is known).
    #[must_use]
    pub fn geometric_order(&self) -> Option<usize> {
        let agree = self
            .residuals
            .iter()
            .take_while(|r| r.iter().all(is_zero))
            .count();
        self.without_cusp(agree.checked_sub(1))
    }

    /// Pieces that turn back at the joint (`b1 <= 0`) meet there and no more.
    fn without_cusp(&self, order: Option<usize>) -> Option<usize> {
        let back = self.betas.first().and_then(Coordinate::sign);
        match back {
            Some(Ordering::Less | Ordering::Equal) => order.map(|_| 0),
            _ => order,
        }
    }

    /// The highest order up to which the derivatives themselves are known to agree: C^order.
    #[must_use]
    pub fn parametric_order(&self) -> Option<usize> {
        let geometric = self.geometric_order()?;
        let equal = |a: &S, b: S| is_zero(&(a.clone() - b));
        let unit = |(n, v): &(usize, &S)| equal(v, if *n == 0 { v.one() } else { v.zero() });
        let betas = self.betas.iter().enumerate().take_while(unit).count();
        let scale = self.scale.iter().enumerate().take_while(unit).count();
        if scale == 0 {
            return None;
        }
        Some(geometric.min(betas).min(scale - 1))
    }
}

impl<const D: usize> JointMeasure<f64, D> {
    /// The highest order up to which the derivatives themselves agree within `tolerance`: C^order. As
    /// [`order_within`](JointMeasure::order_within), and each beta value (and factor) is within `tolerance` of
    /// that of equal parameters, `1, 0, 0, ..`.
    ///
    /// ```
    /// use torse_geometry::{Continuity, Curve, Gbt, join};
    /// let left = Curve::new(Gbt::new(0.5, -0.5)?, vec![[0.0, 0.0], [1.0, 1.0], [2.0, 1.0], [3.0, 0.0]])?;
    /// let c2 = Continuity::parametric(2, &0.0);
    /// let right = join::next_curve(&left, Gbt::new(0.25, 1.0)?, &c2, &[[7.0, 0.0]])?;
    /// let measure = join::measure_curves(&left, &right, 3)?;
    /// assert_eq!(measure.parametric_order_within(1e-9), Some(2));
    /// let faster = join::next_curve(&left, Gbt::new(0.25, 1.0)?, &Continuity::beta(vec![1.1])?, &[[7.0, 0.0]])?;
    /// let measure = join::measure_curves(&left, &faster, 1)?;
    /// assert_eq!((measure.order_within(1e-9), measure.parametric_order_within(1e-9)), (Some(1), Some(0)));
    /// # Ok::<(), torse_geometry::GeometryError>(())
    /// ```
    #[must_use]
    pub fn parametric_order_within(&self, tolerance: f64) -> Option<usize> {
        let near = |list: &[f64], first: f64| {
            let wanted = std::iter::once(first).chain(std::iter::repeat(0.0));
            let agree = list.iter().zip(wanted);
            agree
                .take_while(|(value, wanted)| (*value - wanted).abs() <= tolerance)
                .count()
        };
        let scale = near(&self.scale, 1.0).checked_sub(1)?;
        let betas = near(&self.betas, 1.0);
        Some(self.order_within(tolerance)?.min(betas).min(scale))
    }

    /// The highest order up to which every residual is at most `tolerance` times the length of the
    /// right derivative of that order (or of the longest derivative before, if it is longer).
    #[must_use]
    pub fn order_within(&self, tolerance: f64) -> Option<usize> {
        let length = |v: &[f64; D]| crate::vector::norm(v);
        let mut size: f64 = 0.0;
        let mut reached = None;
        for (n, (residual, right)) in self.residuals.iter().zip(&self.right).enumerate() {
            size = size.max(length(right));
            // A NaN anywhere is no agreement.
            match length(residual).partial_cmp(&(tolerance * size)) {
                Some(Ordering::Less | Ordering::Equal) => reached = Some(n),
                _ => break,
            }
        }
        self.without_cusp(reached)
    }
}

impl<const D: usize> JointMeasure<Ball, D> {
    /// For each order an upper bound of the length of the residual: what the joint of the exact numbers
    /// behind f64 data lacks, at most.
    ///
    /// ```
    /// use torse_geometry::{Continuity, Curve, Gbt, Over, exact_ball, join};
    /// let left = Curve::new(Gbt::new(0.5, -0.5)?, vec![[0.0, 0.0], [1.0, 1.0], [2.0, 1.0], [3.0, 0.0]])?;
    /// let c2 = Continuity::parametric(2, &0.0);
    /// let right = join::next_curve(&left, Gbt::new(0.25, 1.0)?, &c2, &[[7.0, 0.0]])?;
    /// let ball = |x: &f64| exact_ball(*x, 200);
    /// let measure = join::measure_curves(&left.over(&ball)?, &right.over(&ball)?, 3)?;
    /// // Up to order two nothing but the rounding of the control points; of order three a real defect.
    /// let bounds = measure.residual_bounds();
    /// assert!(bounds[..3].iter().all(|bound| *bound < 1e-13) && bounds[3] > 1.0);
    /// let [low, high] = measure.beta_bounds()[0];
    /// assert!(low <= 1.0 + 1e-15 && 1.0 - 1e-15 <= high && high - low < 1e-15);
    /// # Ok::<(), torse_geometry::GeometryError>(())
    /// ```
    #[must_use]
    pub fn residual_bounds(&self) -> Vec<f64> {
        let length = |residual: &[Ball; D]| {
            // |(r1, .., rD)| <= |r1| + .. + |rD|: no root, no rounding but one sum outward.
            let sum = residual.iter().map(Ball::abs).reduce(|a, b| a + b);
            sum.map_or(0.0, |sum| sum.to_f64_bounds().1)
        };
        self.residuals.iter().map(length).collect()
    }

    /// For each order the bounds `[low, high]` of the beta value.
    #[must_use]
    pub fn beta_bounds(&self) -> Vec<[f64; 2]> {
        let bounds = |beta: &Ball| {
            let (low, high) = beta.to_f64_bounds();
            [low, high]
        };
        self.betas.iter().map(bounds).collect()
    }
}

/// Measures the joint between the end of `left` and the start of `right` up to `order`.
///
/// `right' = b1 left'`, `right'' = b1^2 left'' + b2 left'`, ..: each beta is the least-squares solution
/// given the ones before, so it is the true one whenever there is one.
///
/// # Errors
/// [`GeometryError::Degenerate`] when the left end has no tangent.
///
/// ```
/// use torse_algebra::rational::{integer, ratio};
/// use torse_geometry::{Bernstein, Continuity, Curve, join};
/// let q = |x: i64, y: i64| [integer(x), integer(y)];
/// let left = Curve::new(Bernstein, vec![q(0, 0), q(1, 2), q(3, 3)])?;
/// let joint = Continuity::beta(vec![ratio(1, 2).unwrap(), integer(3)])?;
/// let right = join::next_curve(&left, Bernstein, &joint, &[q(9, 9)])?;
/// let measure = join::measure_curves(&left, &right, 3)?;
/// assert_eq!(measure.geometric_order(), Some(2));
/// assert_eq!(measure.parametric_order(), Some(0));
/// assert_eq!(measure.betas[..2], [ratio(1, 2).unwrap(), integer(3)]);
/// # Ok::<(), torse_geometry::GeometryError>(())
/// ```
pub fn measure_curves<S: Coordinate, L: Basis<S>, R: Basis<S>, const D: usize>(
    left: &Curve<L, S, D>,
    right: &Curve<R, S, D>,
    order: usize,
) -> Result<JointMeasure<S, D>> {
    measure_jets(&left.end_jet(order)?, right.start_jet(order)?, Factor::One)
}

/// Measures the joint of two plane families up to `order`, in homogeneous coordinates: planes that
/// differ by a factor are the same plane.
///
/// # Errors
/// [`GeometryError::Degenerate`] when the left family stands still at its end.
///
/// ```
/// use torse_geometry::{Continuity, Gbt, PlaneFamily, join};
/// let planes = vec![[1.0, 0.0, 0.2, 3.0], [0.5, 1.0, 0.1, 2.0], [0.0, 1.0, 0.5, 4.0], [-1.0, 0.3, 0.1, 5.0]];
/// let left = PlaneFamily::new(Gbt::new(0.5, 0.5)?, planes)?;
/// let joint = Continuity::beta(vec![1.5, -0.25])?.scaled(vec![2.0, 0.5, 0.25])?;
/// let right = join::next_family(&left, Gbt::new(0.0, 0.0)?, &joint, &[[0.0, -1.0, 0.0, 2.0]])?;
/// let measure = join::measure_families(&left, &right, 2)?;
/// assert_eq!(measure.order_within(1e-12), Some(2));
/// assert!((measure.betas[0] - 1.5).abs() < 1e-12 && (measure.scale[1] - 0.5).abs() < 1e-12);
/// # Ok::<(), torse_geometry::GeometryError>(())
/// ```
pub fn measure_families<S: Coordinate, L: Basis<S>, R: Basis<S>>(
    left: &PlaneFamily<L, S>,
    right: &PlaneFamily<R, S>,
    order: usize,
) -> Result<JointMeasure<S, 4>> {
    measure_jets(
        &left.curve().end_jet(order)?,
        right.curve().start_jet(order)?,
        Factor::Free,
    )
}

/// Whether the right piece may be a multiple of the left one.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Factor {
    One,
    Free,
}

fn measure_jets<S: Coordinate, const D: usize>(
    left: &[[S; D]],
    right: Vec<[S; D]>,
    factor: Factor,
) -> Result<JointMeasure<S, D>> {
    let degenerate = |what| GeometryError::Degenerate {
        what,
        at: Place::Whole,
    };
    let (Some(l0), Some(r0)) = (left.first(), right.first()) else {
        return Err(degenerate("empty jet"));
    };
    let like = l0
        .first()
        .ok_or_else(|| degenerate("points without coordinates"))?;
    let inner = |a: &[S; D], b: &[S; D]| inner(like, a, b);
    let rho = match factor {
        Factor::One => like.one(),
        Factor::Free => inner(l0, r0)
            .divided_by(&inner(l0, l0))
            .map_err(|_| degenerate("the left end plane vanishes"))?,
    };
    let mut measure = JointMeasure {
        betas: Vec::new(),
        residuals: vec![sub(r0, &scale(&rho, l0))],
        scale: vec![rho.clone()],
        right: Vec::new(),
    };
    for (n, target) in right.iter().enumerate().skip(1) {
        let Some(l1) = left.get(1) else { break };
        // Everything of order n except rho^(n) l0 + rho b_n l1, which the new unknowns multiply.
        let known = transform(left, &measure.betas, &measure.scale, n + 1)?;
        let Some(known) = known.get(n) else { break };
        let rest = sub(target, known);
        let moved = scale(&rho, l1);
        let (extra, beta) = match factor {
            Factor::One => {
                let beta = inner(&moved, &rest).divided_by(&inner(&moved, &moved));
                (
                    like.zero(),
                    beta.map_err(|_| degenerate("the left end has no tangent"))?,
                )
            }
            Factor::Free => least_squares(like, l0, &moved, &rest)
                .ok_or_else(|| degenerate("the left family stands still at its end"))?,
        };
        let fitted: [S; D] = std::array::from_fn(|i| {
            extra.clone() * l0[i].clone() + beta.clone() * moved[i].clone()
        });
        measure.residuals.push(sub(&rest, &fitted));
        measure.betas.push(beta);
        measure.scale.push(extra);
    }
    measure.right = right;
    Ok(measure)
}

/// The `(x, y)` that minimise `|x a + y b - c|`, by Cramer's rule on the normal equations.
fn least_squares<S: Coordinate, const D: usize>(
    like: &S,
    a: &[S; D],
    b: &[S; D],
    c: &[S; D],
) -> Option<(S, S)> {
    let inner = |a: &[S; D], b: &[S; D]| inner(like, a, b);
    let (aa, ab, bb) = (inner(a, a), inner(a, b), inner(b, b));
    let (ac, bc) = (inner(a, c), inner(b, c));
    let det = aa.clone() * bb.clone() - ab.clone() * ab.clone();
    let x = (ac.clone() * bb - bc.clone() * ab.clone())
        .divided_by(&det)
        .ok()?;
    let y = (bc * aa - ac * ab).divided_by(&det).ok()?;
    Some((x, y))
}

fn inner<S: Coordinate, const D: usize>(like: &S, a: &[S; D], b: &[S; D]) -> S {
    a.iter()
        .zip(b)
        .fold(like.zero(), |sum, (x, y)| sum + x.clone() * y.clone())
}
