//! One ruling and its neighbours: everything that is asked of a ruled patch is computed from here.
//!
//! With rails `P, Q` and ruling `R = Q - P` the (unnormalised) normals at the two ends of a ruling are
//! `N0 = P' x R` and `N1 = Q' x R`, and along the ruling `N(v) = (1 - v) N0 + v N1`. Six numbers say
//! everything:
//!
//! ```text
//! D = det(P', Q', R),   a = |N0|^2,   b = |N1|^2,   h = N0 . N1,   r = |R|^2,   c = |N1 - N0|^2
//! ```
//!
//! * The patch is *developable* at `x` when `D = 0`: then `N0` and `N1` are parallel.
//! * It is *regular* on the ruling when `h > 0`: the quadratic `|N(v)|^2` has the Bernstein coefficients
//!   `a, h, b`, and `h > 0` forces the other two, so the normal vanishes nowhere on the ruling and turns by
//!   less than a right angle. A developable with `h <= 0` has its edge of regression (of a cone: the apex) on
//!   the ruling, or a normal that vanishes at an end.
//!
//! The same struct serves f64 (estimates, flat patterns), balls (bounds), exact scalars, and Taylor series
//! over each of them.

use super::extent::Extent;
use crate::coordinate::Coordinate;
use crate::curve::too_short;
use crate::error::{GeometryError, Place, Result};
use crate::surface::Rails;
use crate::vector::{add, cross, det, dot, sub};
use torse_algebra::Jet;

/// A ruling with the first derivatives of both rails and the normals that follow.
///
/// ```
/// use torse_geometry::developable::RulingForms;
/// use torse_geometry::{Bernstein, Curve, RuledSurface};
/// // A quarter of a cone with its apex at (0, 0, 2) and its rails at the heights 0 and 1.
/// let rail = |r: f64, z: f64| Curve::new(Bernstein, vec![[r, 0.0, z], [r, r, z], [0.0, r, z]]);
/// let forms = RulingForms::at(&RuledSurface::new(rail(2.0, 0.0)?, rail(1.0, 1.0)?), &0.5)?;
/// assert!(forms.determinant().abs() < 1e-15);
/// // The normals at both ends are parallel, that of the shorter rail half as long.
/// let [n0, n1] = forms.normals();
/// assert!((0..3).all(|i| (0.5 * n0[i] - n1[i]).abs() < 1e-14));
/// # Ok::<(), torse_geometry::GeometryError>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct RulingForms<S> {
    ends: [[S; 3]; 2],
    slopes: [[S; 3]; 2],
    ruling: [S; 3],
    normals: [[S; 3]; 2],
    determinant: S,
}

impl<S: Coordinate> RulingForms<S> {
    /// The ruling of `x`.
    ///
    /// # Errors
    /// What the rails refuse at `x`, and [`GeometryError::NoValue`] when a number is not finite.
    pub fn at<R: Rails<S> + ?Sized>(rails: &R, x: &S) -> Result<Self> {
        Self::reduced(rails, x, Extent::ONE)
    }

    /// The ruling of `x` in the units of this extent; the points of the rails in those of the derivatives, so
    /// that the ones still belong to the others. Only [`RulingForms::ruling`] knows lengths.
    pub(super) fn reduced<R: Rails<S> + ?Sized>(rails: &R, x: &S, extent: Extent) -> Result<Self> {
        let ends = rails.ends_and_slopes(x)?;
        Self::between(ends, rails.is_developable_by_construction(), extent).checked(x)
    }

    fn between(
        [[p, dp], [q, dq]]: [[[S; 3]; 2]; 2],
        developable: bool,
        Extent { length, speed }: Extent,
    ) -> Self {
        let by = |v: [S; 3], power: i32| match power {
            0 => v,
            _ => v.map(|c| c.times_two_to(-power)),
        };
        let ruling = by(sub(&q, &p), length);
        let (dp, dq) = (by(dp, speed), by(dq, speed));
        let determinant = if developable {
            ruling[0].zero()
        } else {
            det(&dp, &dq, &ruling)
        };
        Self {
            normals: [cross(&dp, &ruling), cross(&dq, &ruling)],
            ends: [by(p, speed), by(q, speed)],
            slopes: [dp, dq],
            ruling,
            determinant,
        }
    }

    fn checked(self, x: &impl Coordinate) -> Result<Self> {
        let pairs = self.ends.iter().chain(&self.slopes).chain(&self.normals);
        let finite = pairs
            .chain([&self.ruling])
            .flatten()
            .all(Coordinate::is_finite);
        if finite && self.determinant.is_finite() {
            return Ok(self);
        }
        Err(GeometryError::NoValue {
            what: "ruling and its normals",
            at: Place::Parameter(x.approximate()),
        })
    }

    /// The points `P` and `Q` of the rails.
    #[must_use]
    pub fn ends(&self) -> &[[S; 3]; 2] {
        &self.ends
    }

    /// `R = Q - P`.
    #[must_use]
    pub fn ruling(&self) -> &[S; 3] {
        &self.ruling
    }

    /// `P'` and `Q'`.
    #[must_use]
    pub fn slopes(&self) -> &[[S; 3]; 2] {
        &self.slopes
    }

    /// `N0 = P' x R` and `N1 = Q' x R`.
    #[must_use]
    pub fn normals(&self) -> &[[S; 3]; 2] {
        &self.normals
    }

    /// `D = det(P', Q', R)`; zero, not computed, for a patch that is developable by construction.
    #[must_use]
    pub fn determinant(&self) -> S {
        self.determinant.clone()
    }

    /// `D`, also where it is known to be zero: for formal functions this is the proof.
    #[must_use]
    pub fn computed_determinant(&self) -> S {
        let [dp, dq] = &self.slopes;
        det(dp, dq, &self.ruling)
    }

    /// The scalar products of the module's head.
    pub(super) fn squares(&self) -> Squares<S> {
        let ([n0, n1], [dp, dq]) = (&self.normals, &self.slopes);
        let turn = sub(n1, n0);
        let weight = |i: usize, j: usize| {
            let product = |d: &[S; 3]| {
                d[i].magnitude() * self.ruling[j].magnitude()
                    + d[j].magnitude() * self.ruling[i].magnitude()
            };
            product(dp) + product(dq)
        };
        let rounding = [weight(1, 2), weight(2, 0), weight(0, 1)];
        Squares {
            determinant: self.determinant.clone(),
            first: dot(n0, n0),
            mixed: dot(n0, n1),
            second: dot(n1, n1),
            change: dot(&sub(n0, n1), &add(n0, n1)),
            bend: dot(&turn, &turn),
            approach: dot(n0, &sub(n0, n1)),
            ruling: dot(&self.ruling, &self.ruling),
            slopes: [dot(dp, dp), dot(dq, dq)],
            parallel: turn.iter().zip(&rounding).all(|(t, w)| t.cancels(w)),
        }
    }
}

impl<S: Coordinate> RulingForms<Jet<S>> {
    /// The Taylor series of everything at `x` to this order (over `x`, when that is a wide ball).
    ///
    /// # Errors
    /// As [`RulingForms::at`].
    pub fn series<R: Rails<S> + ?Sized>(rails: &R, x: &S, order: usize) -> Result<Self> {
        Self::reduced_series(rails, x, order, Extent::ONE)
    }

    /// The same in the units of this extent.
    pub(super) fn reduced_series<R: Rails<S> + ?Sized>(
        rails: &R,
        x: &S,
        order: usize,
        extent: Extent,
    ) -> Result<Self> {
        let with_slope = |rail: [Jet<S>; 3]| -> Result<[[Jet<S>; 3]; 2]> {
            let [dx, dy, dz] = rail.each_ref().map(Jet::differentiated);
            match (dx, dy, dz) {
                (Some(dx), Some(dy), Some(dz)) => Ok([rail, [dx, dy, dz]]),
                _ => Err(too_short(&rail)),
            }
        };
        let [p, q] = rails.rail_jets(x, order.saturating_add(1))?;
        let developable = rails.is_developable_by_construction();
        let rails_of = [with_slope(p)?, with_slope(q)?];
        Self::between(rails_of, developable, extent).checked(x)
    }
}

/// The scalar products of [`RulingForms`].
#[derive(Debug, Clone)]
pub(super) struct Squares<S> {
    /// `D`.
    pub determinant: S,
    /// `a`.
    pub first: S,
    /// `h`.
    pub mixed: S,
    /// `b`.
    pub second: S,
    /// `a - b`, of its own, because the ranges of `a` and `b` forget that both grow together.
    pub change: S,
    /// `c`.
    pub bend: S,
    /// `N0 . (N0 - N1)`: over `c` it is the place of the ruling where `|N(v)|` is least.
    pub approach: S,
    /// `r`.
    pub ruling: S,
    /// `|P'|^2` and `|Q'|^2`.
    pub slopes: [S; 2],
    /// Whether `N1 - N0 = R' x R` is zero as far as the scalar knows: neighbouring rulings are parallel.
    pub parallel: bool,
}

impl<S> Squares<S> {
    /// Pairs of products through `f`; parallel where both are.
    pub(super) fn zip<T>(&self, other: &Self, f: impl Fn(&S, &S) -> T) -> Squares<T> {
        let [p, q] = &self.slopes;
        let [s, t] = &other.slopes;
        Squares {
            determinant: f(&self.determinant, &other.determinant),
            first: f(&self.first, &other.first),
            mixed: f(&self.mixed, &other.mixed),
            second: f(&self.second, &other.second),
            change: f(&self.change, &other.change),
            bend: f(&self.bend, &other.bend),
            approach: f(&self.approach, &other.approach),
            ruling: f(&self.ruling, &other.ruling),
            slopes: [f(p, s), f(q, t)],
            parallel: self.parallel && other.parallel,
        }
    }
}
