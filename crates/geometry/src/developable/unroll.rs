//! Unrolling a developable patch into the plane.
//!
//! A developable is isometric to its flat pattern, and rulings stay straight. Let `r` be the unit
//! ruling, `n` the unit normal and `w = n x r`. Since `r'` lies in the tangent plane, the angle `theta`
//! of the flat ruling and the flat rail `p` obey
//!
//! ```text
//! theta' = r' . w,     p' = (P' . r) e + (P' . w) e_perp,     e = (cos theta, sin theta),
//! ```
//!
//! and the other rail is `p + |Q - P| e`. The right sides depend on `x` and `theta` only; they are
//! integrated with the classical Runge-Kutta method, halving the step until two successive solutions
//! agree.

use crate::coordinate::check_positive;
use crate::error::{GeometryError, Place, Result};
use crate::surface::Rails;
use crate::vector::{cross, dot, norm, scale, sub, unit};

/// The flat pattern of a developable patch.
#[derive(Debug, Clone, PartialEq)]
pub struct FlatPattern {
    /// The parameters of the rulings, from 0 to 1.
    pub x: Vec<f64>,
    /// The flat images of both rails at these parameters.
    pub rails: [Vec<[f64; 2]>; 2],
    /// Estimated largest error of a point (difference to half the number of steps, over 15).
    pub error: f64,
    /// The largest relative loss of length of a rail in the plane: zero up to rounding when the patch is
    /// developable, since then no part of `P'` or `Q'` points along the normal of the ruling's middle.
    pub strain: f64,
}

impl FlatPattern {
    /// The closed outline: along the first rail, back along the second.
    #[must_use]
    pub fn outline(&self) -> Vec<[f64; 2]> {
        let [first, second] = &self.rails;
        first.iter().chain(second.iter().rev()).copied().collect()
    }

    /// Every ruling whose index is a multiple of `every`; none for zero.
    pub fn rulings(&self, every: usize) -> impl Iterator<Item = [[f64; 2]; 2]> {
        let [first, second] = &self.rails;
        let count = if every == 0 { 0 } else { usize::MAX };
        first
            .iter()
            .zip(second)
            .step_by(every.max(1))
            .take(count)
            .map(|(p, q)| [*p, *q])
    }
}

/// The most rulings that [`unroll`] integrates over.
const MOST_STEPS: usize = 1 << 16;

/// Unrolls a patch with an estimated error of at most `accuracy` (in units of length) on at least
/// `rulings` rulings. The first rail starts at the origin and the first ruling points along x. A patch
/// that crosses its edge of regression ([`certify`](super::certify) tells) unrolls to overlapping sheets.
///
/// # Errors
/// [`GeometryError::OutOfRange`] unless `accuracy > 0` ([`GeometryError::NotFinite`] for NaN),
/// [`GeometryError::Degenerate`] where the patch has
/// no normal or a ruling of length zero, [`GeometryError::NotConverged`] when the accuracy is out of reach.
///
/// ```
/// use torse_geometry::developable::unroll;
/// use torse_geometry::{RuledSurface, curve::ellipse_arc};
/// // A quarter of a circular cylinder of radius 2 and height 3: a rectangle pi x 3.
/// let ring = |z: f64| ellipse_arc(&[0.0, 0.0, z], &[2.0, 0.0, z], &[0.0, 2.0, z]);
/// let flat = unroll(&RuledSurface::new(ring(0.0)?, ring(3.0)?), 16, 1e-10)?;
/// let end = flat.rails[1][flat.rails[1].len() - 1];
/// assert!((end[0] - 3.0).abs() < 1e-9 && (end[1].abs() - std::f64::consts::PI).abs() < 1e-9);
/// assert!(flat.error <= 1e-10 && flat.strain < 1e-15);
/// # Ok::<(), torse_geometry::GeometryError>(())
/// ```
pub fn unroll<R: Rails<f64> + ?Sized>(
    patch: &R,
    rulings: usize,
    accuracy: f64,
) -> Result<FlatPattern> {
    check_positive("accuracy", &accuracy)?;
    let mut steps = rulings.clamp(4, MOST_STEPS);
    let mut coarse = integrate(patch, steps)?;
    loop {
        let fine = integrate(patch, 2 * steps)?;
        // The method has order four: the finer solution is better by 2^4 - 1.
        let error = difference(&coarse, &fine) / 15.0;
        if error <= accuracy {
            return Ok(FlatPattern { error, ..fine });
        }
        steps *= 2;
        if steps > MOST_STEPS {
            return Err(GeometryError::NotConverged {
                what: "unrolling",
                reached: error,
                demanded: accuracy,
            });
        }
        coarse = fine;
    }
}

/// What the differential equation needs to know at one parameter.
struct Frame {
    /// `theta'`, the turning of the ruling in the tangent plane.
    turn: f64,
    /// The components of `P'` along the ruling and across.
    along: f64,
    across: f64,
    length: f64,
    strain: f64,
}

impl Frame {
    fn at<R: Rails<f64> + ?Sized>(patch: &R, x: f64) -> Result<Self> {
        let degenerate = |what| GeometryError::Degenerate {
            what,
            at: Place::Parameter(x),
        };
        let [p, q] = patch.rail_jets(&x, 1)?;
        let coefficient = |jets: &[torse_algebra::Jet<f64>; 3], n: usize| -> [f64; 3] {
            std::array::from_fn(|axis| jets[axis].coefficients().get(n).copied().unwrap_or(0.0))
        };
        let (dp, dq) = (coefficient(&p, 1), coefficient(&q, 1));
        let ruling = sub(&coefficient(&q, 0), &coefficient(&p, 0));
        let length = norm(&ruling);
        let r = unit(&ruling).ok_or_else(|| degenerate("ruling of length zero"))?;
        let middle = scale(&0.5, &[dp[0] + dq[0], dp[1] + dq[1], dp[2] + dq[2]]);
        let n = unit(&cross(&middle, &r)).ok_or_else(|| degenerate("normal of the patch"))?;
        let w = cross(&n, &r);
        Ok(Self {
            // The component of R' along r changes the length, not the direction.
            turn: dot(&sub(&dq, &dp), &w) / length,
            along: dot(&dp, &r),
            across: dot(&dp, &w),
            length,
            strain: lost(&dp, &n).max(lost(&dq, &n)),
        })
    }

    /// `(theta', p')` at the angle `theta`.
    fn slope(&self, theta: f64) -> [f64; 3] {
        let (s, c) = theta.sin_cos();
        [
            self.turn,
            self.along * c - self.across * s,
            self.along * s + self.across * c,
        ]
    }
}

/// The relative loss of length of `v` projected along the unit vector `n`.
fn lost(v: &[f64; 3], n: &[f64; 3]) -> f64 {
    let length = norm(v);
    if length > 0.0 {
        1.0 - norm(&cross(v, n)) / length
    } else {
        0.0
    }
}

fn integrate<R: Rails<f64> + ?Sized>(patch: &R, steps: usize) -> Result<FlatPattern> {
    #[allow(clippy::cast_precision_loss)]
    let h = 1.0 / steps as f64;
    let mut state = [0.0_f64; 3];
    let mut frame = Frame::at(patch, 0.0)?;
    let mut x = Vec::with_capacity(steps + 1);
    let mut rails = [Vec::with_capacity(steps + 1), Vec::with_capacity(steps + 1)];
    let mut keep = |at: f64, [theta, px, py]: [f64; 3], length: f64| {
        let (s, c) = theta.sin_cos();
        x.push(at);
        rails[0].push([px, py]);
        rails[1].push([px + length * c, py + length * s]);
    };
    keep(0.0, state, frame.length);
    let mut strain = frame.strain;
    for step in 0..steps {
        #[allow(clippy::cast_precision_loss)]
        let (middle_x, end_x) = ((step as f64 + 0.5) * h, ((step + 1) as f64 * h).min(1.0));
        let middle = Frame::at(patch, middle_x)?;
        let end = Frame::at(patch, end_x)?;
        let moved = |k: &[f64; 3], by: f64| state[0] + by * k[0];
        let k1 = frame.slope(state[0]);
        let k2 = middle.slope(moved(&k1, 0.5 * h));
        let k3 = middle.slope(moved(&k2, 0.5 * h));
        let k4 = end.slope(moved(&k3, h));
        state =
            std::array::from_fn(|i| state[i] + h / 6.0 * (k1[i] + 2.0 * (k2[i] + k3[i]) + k4[i]));
        keep(end_x, state, end.length);
        strain = strain.max(middle.strain).max(end.strain);
        frame = end;
    }
    Ok(FlatPattern {
        x,
        rails,
        error: f64::INFINITY,
        strain,
    })
}

/// The largest distance between the points of a pattern and those of the pattern with twice the steps.
fn difference(coarse: &FlatPattern, fine: &FlatPattern) -> f64 {
    let mut largest = 0.0_f64;
    for (a, b) in coarse.rails.iter().zip(&fine.rails) {
        for (p, q) in a.iter().zip(b.iter().step_by(2)) {
            largest = largest.max(norm(&sub(p, q)));
        }
    }
    largest
}
