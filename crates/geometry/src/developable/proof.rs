//! Proofs about ruled patches: no samples, no tolerance.

use super::forms::RulingForms;
use crate::basis::Bernstein;
use crate::curve::Curve;
use crate::error::Result;
use crate::surface::{Rails, RuledSurface};
use crate::vector::dot;
use std::cmp::Ordering;
use torse_algebra::{Ball, Fraction, Integer, Rational};

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
/// The question is about the very numbers of the control points. Of a patch whose points were *computed* on
/// f64 it is almost never developable: rounding twists it by `1e-16`, and `Twisted` says just that. Ask
/// [`certify`](super::certify) or [`enclose`](super::enclose) by how much.
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
        let determinant = RulingForms::at(patch, &x)?.determinant();
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
pub fn twist_determinant<R: Rails<Fraction> + ?Sized>(patch: &R) -> Result<Fraction> {
    let forms = RulingForms::at(patch, &Fraction::named("x"))?;
    Ok(forms.computed_determinant())
}

/// The outcome of [`prove_regular`].
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Regularity {
    /// Proved: on every ruling the normals at both ends are there and point to the same side, `N0 . N1 > 0`,
    /// so the normal vanishes nowhere.
    Regular,
    /// Refuted: at this parameter `N0 . N1 <= 0`. Of a developable the edge of regression lies inside or on the
    /// border, or the normal vanishes; of a twisted patch the tangent plane turns by a right angle or more.
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

/// Proves or refutes that a patch is regular, in the sense of [`PatchCertificate`](super::PatchCertificate), with
/// interval arithmetic of `bits` bits and at most `budget` intervals.
///
/// # Errors
/// None: where the patch cannot be evaluated on an interval, that interval is divided.
///
/// ```
/// use torse_geometry::developable::{Regularity, prove_regular};
/// use torse_geometry::{PatchBounds, EnvelopingPatch, Gbt, Over, PlaneFamily, exact_ball};
/// let h = 5.0 * 2_f64.sqrt();
/// let planes = vec![[h, -h, 5.0, 125.0], [-h, -h, 5.0, 125.0], [-h, h, 5.0, 125.0], [h, h, 5.0, 125.0]];
/// let family = PlaneFamily::new(Gbt::new(0.5, 0.5)?, planes)?;
/// let upto = |z: f64| {
///     let patch = EnvelopingPatch::new(family.clone(), PatchBounds::Planes([[0., 0., 1., 0.], [0., 0., 1., z]]))?;
///     patch.over(&|x| exact_ball(*x, 80)).map(|patch| prove_regular(&patch, 80, 4096))
/// };
/// assert_eq!(upto(5.0)?, Regularity::Regular);
/// // The surface is a cone with its apex at z = 25: above, the patch is not regular.
/// assert!(matches!(upto(30.0)?, Regularity::Singular { .. }));
/// # Ok::<(), torse_geometry::GeometryError>(())
/// ```
#[must_use]
pub fn prove_regular<R: Rails<Ball> + ?Sized>(patch: &R, bits: usize, budget: usize) -> Regularity {
    let number = |n: i64| torse_algebra::rational::integer(n);
    let half = Rational::new(1.into(), 2.into());
    let mut open = vec![(number(0), number(1))];
    let mut visited = 0;
    while let Some((from, to)) = open.pop() {
        visited += 1;
        match same_side(patch, &Ball::from_bounds(&from, &to, bits)) {
            Some(Ordering::Greater) => continue,
            Some(Ordering::Less | Ordering::Equal) => return Regularity::Singular { x: from },
            None => {}
        }
        let middle = (from.clone() + to.clone()) * half.clone();
        for x in [&middle, &from, &to] {
            let side = same_side(patch, &Ball::from_rational(x, bits));
            if matches!(side, Some(Ordering::Less | Ordering::Equal)) {
                return Regularity::Singular { x: x.clone() };
            }
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
fn same_side<R: Rails<Ball> + ?Sized>(patch: &R, x: &Ball) -> Option<Ordering> {
    let forms = RulingForms::at(patch, x).ok()?;
    let [n0, n1] = forms.normals();
    dot(n0, n1).sign()
}
