//! Proofs about ruled patches: no samples, no tolerance.

use crate::basis::Bernstein;
use crate::curve::Curve;
use crate::error::{GeometryError, Result};
use crate::surface::{Rails, RuledSurface};
use crate::vector::{cross, det, dot, sub};
use std::cmp::Ordering;
use torse_algebra::{Ball, Fraction, Integer, Jet, Rational};

/// The outcome of [`prove_developable`].
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Developability {
    /// Proved: `det(P', Q', Q - P)` is the zero polynomial.
    Developable,
    /// Refuted: the determinant at this parameter is not zero.
    Twisted {
        /// The parameter of the witness ruling.
        x: Rational,
        /// The determinant there.
        determinant: Rational,
    },
}

/// A polynomial rail over the rationals.
type Rail = Curve<Bernstein, Rational, 3>;

/// Decides whether the ruled patch between two polynomial rails is developable: the determinant is a
/// polynomial of degree at most `(m - 1) + (n - 1) + max(m, n)`, so it vanishes identically when it
/// vanishes at one parameter more.
///
/// # Errors
/// None beyond evaluation, which does not fail for polynomials.
///
/// ```
/// use torse_algebra::rational::integer;
/// use torse_geometry::developable::{Developability, prove_developable};
/// use torse_geometry::{HermiteCone, Bernstein, Curve, RuledSurface};
/// let v = |x, y, z| [x, y, z].map(integer);
/// let q = [v(-20, 60, 45), v(-20, -50, 45), v(0, -30, 60), v(0, -50, -60)];
/// let cone = HermiteCone::cubic(v(170, 0, 45), integer(2), q)?;
/// assert_eq!(prove_developable(&cone.patch()?)?, Developability::Developable);
/// let rail = |z| Curve::new(Bernstein, vec![v(0, 0, z), v(1, z, 0), v(2, 0, 1)]);
/// let twisted = RuledSurface::new(rail(0)?, rail(3)?);
/// assert!(matches!(prove_developable(&twisted)?, Developability::Twisted { .. }));
/// # Ok::<(), torse_geometry::GeometryError>(())
/// ```
pub fn prove_developable(patch: &RuledSurface<Rail, Rail>) -> Result<Developability> {
    let (m, n) = (patch.first().degree(), patch.second().degree());
    let bound = (m + n).saturating_sub(2) + m.max(n);
    for i in 0..=bound {
        let x = Rational::new(Integer::from(i), Integer::from(bound.max(1)));
        let [p, q] = patch.rail_jets(&x, 1)?;
        let ([p0, p1], [q0, q1]) = (first_two(&p)?, first_two(&q)?);
        let determinant = det(&p1, &q1, &sub(&q0, &p0));
        if *determinant.numer() != Integer::ZERO {
            return Ok(Developability::Twisted { x, determinant });
        }
    }
    Ok(Developability::Developable)
}

/// `det(P', Q', Q - P)` as a formal function of `x`: a ruled patch is developable exactly when it is zero,
/// whatever the basis, rational or not, and for all values of the symbols in the data at once.
///
/// # Errors
/// What the patch refuses at a formal parameter.
///
/// ```
/// use torse_algebra::Fraction;
/// use torse_geometry::{Coordinate, Curve, Gbt, RuledSurface, developable::twist_determinant};
/// let one = Fraction::named("x").one();
/// let number = |n: usize| one.natural(n);
/// let rail = |lift: Fraction, mu: &str| {
///     let points = [[0, 0], [1, 3], [4, 1], [6, 2]].map(|[x, y]| [number(x), number(y), lift.clone()]);
///     Curve::new(Gbt::new(Fraction::named(mu), one.clone())?, points.to_vec())
/// };
/// // A cylinder of any height over the curve of any shape parameter mu; not so with two of them.
/// let cylinder = RuledSurface::new(rail(one.zero(), "mu")?, rail(Fraction::named("h"), "mu")?);
/// assert!(twist_determinant(&cylinder)?.is_zero());
/// let twisted = RuledSurface::new(rail(one.zero(), "mu")?, rail(Fraction::named("h"), "lambda")?);
/// assert!(!twist_determinant(&twisted)?.is_zero());
/// # Ok::<(), torse_geometry::GeometryError>(())
/// ```
pub fn twist_determinant(patch: &impl Rails<Fraction>) -> Result<Fraction> {
    let x = Fraction::named("x");
    let [p, q] = patch.rail_jets(&x, 1)?;
    let ([p0, p1], [q0, q1]) = (first_two(&p)?, first_two(&q)?);
    Ok(det(&p1, &q1, &sub(&q0, &p0)))
}

/// Value and first derivative.
fn first_two<S: Clone>(jets: &[Jet<S>; 3]) -> Result<[[S; 3]; 2]> {
    let [x, y, z] = jets.each_ref().map(Jet::coefficients);
    match (x, y, z) {
        ([x, dx, ..], [y, dy, ..], [z, dz, ..]) => {
            Ok([[x, y, z], [dx, dy, dz]].map(|vector| vector.map(S::clone)))
        }
        _ => Err(GeometryError::LengthMismatch {
            what: "Taylor coefficients of a rail",
            index: 0,
            expected: 2,
            given: x.len().min(y.len()).min(z.len()),
        }),
    }
}

/// The outcome of [`prove_regular`].
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Regularity {
    /// Proved: on every ruling the end normals point to the same side.
    Regular,
    /// Refuted: at this parameter they point to opposite sides, so the edge of regression lies inside.
    Singular {
        /// The parameter of a witness ruling.
        x: Rational,
    },
    /// Neither within the budget; the first interval left open.
    Undecided {
        /// Its lower end.
        from: Rational,
        /// Its upper end.
        to: Rational,
    },
}

/// Proves or refutes that a developable patch is regular, with interval arithmetic of `bits` bits and at
/// most `budget` intervals.
///
/// # Errors
/// None: where the patch cannot be evaluated on an interval, that interval is divided.
///
/// ```
/// use torse_geometry::developable::{Regularity, prove_regular};
/// use torse_geometry::{Bounds, EnvelopingPatch, Gbt, Over, PlaneFamily, exact_ball};
/// let h = 5.0 * 2_f64.sqrt();
/// let planes = vec![[h, -h, 5.0, 125.0], [-h, -h, 5.0, 125.0], [-h, h, 5.0, 125.0], [h, h, 5.0, 125.0]];
/// let family = PlaneFamily::new(Gbt::new(0.5, 0.5)?, planes)?;
/// let upto = |z: f64| {
///     let patch = EnvelopingPatch::new(family.clone(), Bounds::Planes([[0., 0., 1., 0.], [0., 0., 1., z]]))?;
///     patch.over(&|x| exact_ball(*x, 80)).map(|patch| prove_regular(&patch, 80, 4096))
/// };
/// assert_eq!(upto(5.0)?, Regularity::Regular);
/// // The surface is a cone with its apex at z = 25: above, the patch is not regular.
/// assert!(matches!(upto(30.0)?, Regularity::Singular { .. }));
/// # Ok::<(), torse_geometry::GeometryError>(())
/// ```
#[must_use]
pub fn prove_regular(patch: &impl Rails<Ball>, bits: usize, budget: usize) -> Regularity {
    let number = |n: i64| torse_algebra::rational::integer(n);
    let half = Rational::new(1.into(), 2.into());
    let mut open = vec![(number(0), number(1))];
    let mut visited = 0;
    while let Some((from, to)) = open.pop() {
        visited += 1;
        match same_side(patch, &Ball::from_bounds(&from, &to, bits)) {
            Some(Ordering::Greater) => continue,
            Some(Ordering::Less) => return Regularity::Singular { x: from },
            _ => {}
        }
        let middle = (from.clone() + to.clone()) * half.clone();
        if same_side(patch, &Ball::from_rational(&middle, bits)) == Some(Ordering::Less) {
            return Regularity::Singular { x: middle };
        }
        if visited >= budget {
            return Regularity::Undecided { from, to };
        }
        open.push((middle.clone(), to));
        open.push((from, middle));
    }
    Regularity::Regular
}

/// The sign of `N0 . N1` over an interval of parameters, where it is the same for all.
fn same_side(patch: &impl Rails<Ball>, x: &Ball) -> Option<Ordering> {
    let [p, q] = patch.rail_jets(x, 1).ok()?;
    let ([p0, p1], [q0, q1]) = (first_two(&p).ok()?, first_two(&q).ok()?);
    let r = sub(&q0, &p0);
    dot(&cross(&p1, &r), &cross(&q1, &r)).sign()
}
