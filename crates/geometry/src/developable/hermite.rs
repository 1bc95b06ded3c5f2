//! Hermite cones between parallel planes (hermite-developable Sect. 3).
//!
//! The paper asks for boundary curves `p, q` and a summit `o` with
//!
//! ```text
//! q(u) + q'(u) = k (p(u) + p'(u)) + (1 - k) o            (3.3b)
//! ```
//!
//! Comparing coefficients gives a linear system in the unknown Hermite data. On polynomials the map
//! `f -> f + f'` is invertible, so the system says no more and no less than
//!
//! ```text
//! q(u) - o = k (p(u) - o):
//! ```
//!
//! the curves are images of each other in the dilation about `o` with ratio `k`, and the surface is a
//! cone with apex `o`. The systems are set up here from the Hermite functions themselves, not from
//! the print: a misprinted entry of eq. (3.6) makes the paper exclude `k = 135/136`. As the systems are
//! those of a dilation, so are their solutions, which the tests compare point by point.

use super::linear::{singular_for, solve};
use crate::basis::{Bernstein, hermite};
use crate::coordinate::{Coordinate, check_finite, check_positive, is_zero};
use crate::curve::Curve;
use crate::error::{GeometryError, Place, Result};
use crate::surface::RuledSurface;
use crate::vector::{scale, sub};
use torse_algebra::Rational;

/// A cone between two Hermite curves: the data of both (in the order of [`hermite`]), the apex and the
/// ratio `k`.
#[derive(Debug, Clone, PartialEq)]
pub struct HermiteCone<S> {
    /// The apex `o`.
    pub summit: [S; 3],
    /// The ratio `k` in `q - o = k (p - o)`.
    pub ratio: S,
    /// The Hermite data of `p`.
    pub p: Vec<[S; 3]>,
    /// The Hermite data of `q`.
    pub q: Vec<[S; 3]>,
}

/// What determines a quartic cone (hermite-developable eq. (3.6)).
#[derive(Debug, Clone, PartialEq)]
pub struct QuarticData<S> {
    /// `p(0)`.
    pub p_start: [S; 3],
    /// `p(1/2)`.
    pub p_middle: [S; 3],
    /// `q(0), q(1)`.
    pub q_ends: [[S; 3]; 2],
    /// `q'(0), q'(1)`.
    pub q_tangents: [[S; 3]; 2],
}

/// What determines a quintic cone (hermite-developable eq. (3.7)).
#[derive(Debug, Clone, PartialEq)]
pub struct QuinticData<S> {
    /// What the quartic needs as well.
    pub quartic: QuarticData<S>,
    /// `p'(1/2)`.
    pub p_middle_tangent: [S; 3],
}

/// A datum of one of the two curves, or the summit.
#[derive(Clone, Copy)]
enum Unknown {
    P(usize),
    Q(usize),
    Summit,
}

/// The unknowns of the three systems, in the order of the paper's columns.
fn unknowns(degree: usize) -> &'static [Unknown] {
    use Unknown::{P, Q, Summit};
    match degree {
        3 => &[P(1), P(2), P(3), P(0)],
        4 => &[Q(1), P(2), P(3), P(4), Summit],
        5 => &[P(3), Q(4), P(5), Q(1), P(2), Summit],
        _ => &[],
    }
}

/// The coefficient of a datum in the condition for the power `u^m`,
/// `sum_j E[m][j] (q_j - k p_j) - (1 - k) [m = 0] o = 0`, where `E[m][j]` is the coefficient of `u^m` in
/// `H_j + H_j'`.
fn entry<S: Coordinate>(functions: &[Vec<Rational>], k: &S, m: usize, datum: Unknown) -> S {
    let coefficient = |j: usize| -> S {
        let at = |n: usize| {
            functions
                .get(j)
                .and_then(|h| h.get(n))
                .map(|c| k.constant(c))
        };
        let plain = at(m).unwrap_or_else(|| k.zero());
        at(m + 1).map_or(plain.clone(), |c| plain + k.natural(m + 1) * c)
    };
    match datum {
        Unknown::P(j) => -(k.clone() * coefficient(j)),
        Unknown::Q(j) => coefficient(j),
        Unknown::Summit if m == 0 => k.clone() - k.one(),
        Unknown::Summit => k.zero(),
    }
}

/// The rows of the matrix of the system of degree 3, 4 or 5 (hermite-developable eqs. (3.5) to (3.7)), from
/// the highest power of `u` down, with the paper's columns; empty for other degrees.
///
/// ```
/// use torse_algebra::{Fraction, Matrix, rational::integer};
/// use torse_geometry::{Coordinate, developable::cone_system};
/// let k = Fraction::named("k");
/// let power = |n| k.power(n).unwrap();
/// let det = |degree| Matrix::from_rows(cone_system(degree, &k)).unwrap().determinant().unwrap();
/// assert_eq!(det(3), power(4));
/// // Printed as -16 k^3 (136 k - 135)(k - 1), from a misprinted entry.
/// let less = k.clone() - k.one();
/// assert_eq!(det(4), -(k.natural(16) * power(3) * less.clone()));
/// assert_eq!(det(5), k.natural(256) * power(3) * less);
/// ```
pub fn cone_system<S: Coordinate>(degree: usize, k: &S) -> Vec<Vec<S>> {
    let functions = hermite::functions(degree);
    let row = |m| {
        unknowns(degree)
            .iter()
            .map(|&d| entry(&functions, k, m, d))
            .collect()
    };
    (0..unknowns(degree).len()).rev().map(row).collect()
}

impl<S: Coordinate> HermiteCone<S> {
    /// The cubic cone over the given `q = [q(0), q(1), q'(0), q'(1)]` with the given summit
    /// (hermite-developable eq. (3.5)).
    ///
    /// # Errors
    /// [`GeometryError::OutOfRange`] unless `k > 0`, [`GeometryError::SingularSystem`] for `k = 1`
    /// (both curves coincide), [`GeometryError::NotFinite`].
    ///
    /// ```
    /// use torse_algebra::rational::{Rational, integer};
    /// use torse_geometry::HermiteCone;
    /// // hermite-developable Sect. 3.1. Printed p'(0) = (0, -15, 30) etc.: all four agree.
    /// let v = |x, y, z| [x, y, z].map(integer);
    /// let q = [v(-20, 60, 45), v(-20, -50, 45), v(0, -30, 60), v(0, -50, -60)];
    /// let cone = HermiteCone::cubic(v(170, 0, 45), integer(2), q)?;
    /// assert_eq!(cone.p, [v(75, 30, 45), v(75, -25, 45), v(0, -15, 30), v(0, -25, -30)]);
    /// # Ok::<(), torse_geometry::GeometryError>(())
    /// ```
    pub fn cubic(summit: [S; 3], k: S, q: [[S; 3]; 4]) -> Result<Self> {
        let known = Known {
            p: vec![None; 4],
            q: q.map(Some).to_vec(),
            summit: Some(summit),
        };
        known.solved(k)
    }

    /// The quartic cone; the summit follows (hermite-developable eq. (3.6)).
    ///
    /// # Errors
    /// As [`HermiteCone::cubic`].
    ///
    /// ```
    /// use torse_algebra::rational::{integer, ratio};
    /// use torse_geometry::{HermiteCone, developable::QuarticData};
    /// // hermite-developable Sect. 3.2.
    /// let v = |x, y, z| [x, y, z].map(integer);
    /// let half = |x, y, z| [ratio(x, 2).unwrap(), ratio(y, 2).unwrap(), ratio(z, 2).unwrap()];
    /// let data = QuarticData {
    ///     p_start: v(40, 40, 45),
    ///     p_middle: half(80, 25, 120),
    ///     q_ends: [v(-20, 60, 45), v(-20, -50, 45)],
    ///     q_tangents: [v(0, -30, 60), v(0, -50, -60)],
    /// };
    /// let cone = HermiteCone::quartic(integer(2), data.clone())?;
    /// assert_eq!(cone.summit, v(100, 20, 45));
    /// assert_eq!(cone.q[1], v(-20, 5, 75));
    /// assert_eq!(cone.p[2..], [v(40, -15, 45), v(0, -15, 30), v(0, -25, -30)]);
    /// // k = 135/136, which the paper excludes, is as good as any other.
    /// assert!(HermiteCone::quartic(ratio(135, 136).unwrap(), data).is_ok());
    /// # Ok::<(), torse_geometry::GeometryError>(())
    /// ```
    pub fn quartic(k: S, data: QuarticData<S>) -> Result<Self> {
        let [q0, q1] = data.q_ends.map(Some);
        let [q0u, q1u] = data.q_tangents.map(Some);
        let known = Known {
            p: vec![Some(data.p_start), Some(data.p_middle), None, None, None],
            q: vec![q0, None, q1, q0u, q1u],
            summit: None,
        };
        known.solved(k)
    }

    /// The quintic cone; the summit follows (hermite-developable eq. (3.7)).
    ///
    /// # Errors
    /// As [`HermiteCone::cubic`].
    ///
    /// ```
    /// use torse_geometry::{GeometryError, HermiteCone, developable::{QuarticData, QuinticData}};
    /// // hermite-developable Sect. 3.3.
    /// let data = QuinticData {
    ///     quartic: QuarticData {
    ///         p_start: [40.0, 40.0, 45.0],
    ///         p_middle: [40.0, 12.5, 40.0],
    ///         q_ends: [[-20.0, 60.0, 45.0], [-20.0, -50.0, 45.0]],
    ///         q_tangents: [[0.0, -60.0, 90.0], [0.0, -50.0, -30.0]],
    ///     },
    ///     p_middle_tangent: [0.0, -25.0, 35.0],
    /// };
    /// let cone = HermiteCone::quintic(2.0, data.clone())?;
    /// let close = |a: &[f64; 3], b: [f64; 3]| a.iter().zip(b).all(|(a, b)| (a - b).abs() < 1e-9);
    /// assert!(close(&cone.summit, [100.0, 20.0, 45.0]) && close(&cone.p[3], [0.0, -30.0, 45.0]));
    /// assert!(close(&cone.q[1], [-20.0, 5.0, 35.0]) && close(&cone.q[4], [0.0, -50.0, 70.0]));
    /// assert!(close(&cone.p[2], [40.0, -15.0, 45.0]) && close(&cone.p[5], [0.0, -25.0, -15.0]));
    ///
    /// assert_eq!(
    ///     HermiteCone::quintic(0.0, data.clone()).unwrap_err().to_string(),
    ///     "k = 0 is outside (0, infinity)",
    /// );
    /// assert!(matches!(HermiteCone::quintic(1.0, data), Err(GeometryError::SingularSystem { .. })));
    /// # Ok::<(), GeometryError>(())
    /// ```
    pub fn quintic(k: S, data: QuinticData<S>) -> Result<Self> {
        let quartic = data.quartic;
        let [q0, q1] = quartic.q_ends.map(Some);
        let [q0u, q1u] = quartic.q_tangents.map(Some);
        let middle = Some(data.p_middle_tangent);
        let known = Known {
            p: vec![
                Some(quartic.p_start),
                Some(quartic.p_middle),
                None,
                None,
                middle,
                None,
            ],
            q: vec![q0, None, q1, q0u, None, q1u],
            summit: None,
        };
        known.solved(k)
    }

    /// The patch `(1 - v) p(u) + v q(u)` (hermite-developable eq. (3.4)).
    ///
    /// # Errors
    /// [`GeometryError::NotFinite`] for data changed to NaN or infinity,
    /// [`GeometryError::LengthMismatch`] when their number is not 4, 5 or 6.
    pub fn patch(&self) -> Result<RuledSurface<Curve<Bernstein, S, 3>, Curve<Bernstein, S, 3>>> {
        Ok(RuledSurface::new(
            hermite::curve(&self.p)?,
            hermite::curve(&self.q)?,
        ))
    }
}

/// The data that are given.
struct Known<S> {
    p: Vec<Option<[S; 3]>>,
    q: Vec<Option<[S; 3]>>,
    summit: Option<[S; 3]>,
}

impl<S: Coordinate> Known<S> {
    /// Sets up and solves the system of [`cone_system`].
    fn solved(mut self, k: S) -> Result<HermiteCone<S>> {
        const WHAT: &str = "a Hermite cone";
        check_positive("k", &k)?;
        if is_zero(&(k.clone() - k.one())) {
            return Err(singular_for(WHAT, &k));
        }
        let given = self
            .p
            .iter()
            .chain(&self.q)
            .chain([&self.summit])
            .flatten()
            .flatten();
        check_finite("Hermite datum", given)?;
        let degree = self.p.len().saturating_sub(1);
        let functions = hermite::functions(degree);
        let matrix = cone_system(degree, &k);
        let mut right: Vec<[S; 3]> = vec![std::array::from_fn(|_| k.zero()); matrix.len()];
        for (m, target) in right.iter_mut().rev().enumerate() {
            let p = self.p.iter().enumerate().map(|(j, d)| (Unknown::P(j), d));
            let q = self.q.iter().enumerate().map(|(j, d)| (Unknown::Q(j), d));
            for (datum, value) in p.chain(q).chain([(Unknown::Summit, &self.summit)]) {
                if let Some(value) = value {
                    *target = sub(target, &scale(&entry(&functions, &k, m, datum), value));
                }
            }
        }
        let solution = solve(WHAT, matrix, right).map_err(|_| singular_for(WHAT, &k))?;
        for (datum, value) in unknowns(degree).iter().zip(solution) {
            let slot = match *datum {
                Unknown::P(j) => self.p.get_mut(j),
                Unknown::Q(j) => self.q.get_mut(j),
                Unknown::Summit => Some(&mut self.summit),
            };
            if let Some(slot) = slot {
                *slot = Some(value);
            }
        }
        let incomplete = || GeometryError::SingularSystem {
            what: WHAT,
            at: Place::Whole,
        };
        Ok(HermiteCone {
            summit: self.summit.ok_or_else(incomplete)?,
            ratio: k,
            p: self
                .p
                .into_iter()
                .collect::<Option<_>>()
                .ok_or_else(incomplete)?,
            q: self
                .q
                .into_iter()
                .collect::<Option<_>>()
                .ok_or_else(incomplete)?,
        })
    }
}
