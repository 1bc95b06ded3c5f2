//! Certificates for ruled patches: how developable, and regular or not, each with the worst place.
//!
//! Along a ruling the worst place is known in closed form (modules `forms` and `measures`); from ruling to
//! ruling [`certify`] measures on f64: samples, refined until each follows from its neighbours, then a local
//! search. Its numbers are estimates: what it finds bad is bad, and that nothing worse lies between the samples
//! is proved by [`enclose`](super::enclose), which bounds the same quantities with the same formulas, and by
//! [`prove_developable`](super::prove_developable) and [`prove_regular`](super::prove_regular). A patch that
//! changes on a scale far below the distance of the rulings (a spike between two of them) is not seen here.

use super::extent::Extent;
use super::forms::RulingForms;
use super::measures::{CLEARANCE, DETERMINANT, GAUSSIAN, Intervals, NORMAL, SIDE, TWIST};
use super::resolve::resolved;
use crate::error::{GeometryError, Place, Result};
use crate::parallel::prelude::*;
use crate::surface::Rails;
use std::fmt;

/// The worst value of a quantity and where it is taken.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Worst {
    /// The value.
    pub value: f64,
    /// The parameter of the ruling.
    pub x: f64,
    /// The position on the ruling in [0, 1]; 0 where the quantity belongs to the whole ruling. The place of
    /// the clearance may lie outside of [0, 1]: there the ruling meets its neighbours.
    pub v: f64,
}

/// Why a patch is not regular.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Singularity {
    /// The normal vanishes at this place, or cannot be told from zero: a cusp, a ruling of length zero, an
    /// apex or a point of the edge of regression on the border.
    NormalVanishes(Worst),
    /// On this ruling the normals at the ends point to opposite sides: it crosses the edge of regression (or
    /// the tangent plane of a twisted patch turns by a right angle or more).
    NormalTurns(Worst),
    /// Between these two rulings the patch does not go on as its derivatives say, however closely one looks:
    /// the rails run off to infinity, jump, or turn back in a cusp.
    Unresolved {
        /// The parameter of the one ruling.
        from: f64,
        /// The parameter of the other.
        to: f64,
    },
}

/// What [`certify`] measured: estimates, for bounds see [`enclose`](super::enclose). All numbers are finite.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PatchCertificate {
    /// The largest `|det(P', Q', R)| / (|P'| |Q'| |R|)`. A ruling without a normal counts as zero.
    pub determinant: Worst,
    /// The largest angle between the tangent planes at the ends of a ruling, in radians (0 to pi/2:
    /// planes, not normals).
    pub twist: Worst,
    /// The largest absolute Gaussian curvature `det(P', Q', R)^2 / |N(v)|^4`, on each ruling where `N(v)` is
    /// shortest; `None` when it is unbounded (or beyond f64) because the normal vanishes.
    pub gaussian: Option<Worst>,
    /// The smallest distance, along a ruling and in units of length, from the patch to the point where
    /// the ruling comes closest to its neighbours (of a developable the edge of regression, the apex): negative
    /// when that point is inside the patch, `None` when no ruling meets its neighbours (cylinders).
    pub clearance: Option<Worst>,
    /// The shortest normal `|N(v)|`, relative to the longest ruling times the greatest speed of a rail (within
    /// a factor of two each): zero at a cusp, at an edge of regression and for a patch of width zero.
    pub normal: Worst,
    singularity: Option<Singularity>,
}

impl PatchCertificate {
    /// Whether the patch is regular, as far as measured: on every ruling the normals at both ends are there
    /// and point to the same side. Then the normal vanishes nowhere, and no ruling meets its neighbours inside.
    #[must_use]
    pub fn is_regular(&self) -> bool {
        self.singularity.is_none()
    }

    /// The first reason found why the patch is not regular.
    #[must_use]
    pub fn singularity(&self) -> Option<Singularity> {
        self.singularity
    }

    /// Whether no tangent plane turns by more than `angle` radians along its ruling.
    #[must_use]
    pub fn is_developable_within(&self, angle: f64) -> bool {
        self.twist.value <= angle
    }
}

/// For people: what decides whether the patch can be made, with places.
///
/// ```
/// use torse_geometry::{RuledSurface, curve::ellipse_arc, developable::certify};
/// let ring = |r: f64, z: f64| ellipse_arc(&[0.0, 0.0, z], &[r, 0.0, z], &[0.0, r, z]);
/// let cone = certify(&RuledSurface::new(ring(3.0, 0.0)?, ring(1.0, 4.0)?), 32)?;
/// let said = cone.to_string();
/// assert!(said.starts_with("tangent planes turn by at most ") && said.contains("; regular; "));
/// assert!(said.contains(" from the edge of regression at x = "));
/// # Ok::<(), torse_geometry::GeometryError>(())
/// ```
impl fmt::Display for PatchCertificate {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let degrees = self.twist.value.to_degrees();
        write!(
            f,
            "tangent planes turn by at most {degrees:.3e} degrees along a ruling (at x = {}); ",
            self.twist.x
        )?;
        match self.singularity {
            None => write!(f, "regular; ")?,
            Some(reason) => write!(f, "not regular: {reason}; ")?,
        }
        match self.clearance {
            None => write!(f, "no ruling meets its neighbours"),
            Some(Worst { value, x, .. }) => {
                write!(f, "{value:.6e} from the edge of regression at x = {x}")
            }
        }
    }
}

impl fmt::Display for Singularity {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::NormalVanishes(Worst { x, v, .. }) => {
                write!(f, "the normal vanishes at x = {x}, v = {v}")
            }
            Self::NormalTurns(Worst { x, .. }) => {
                write!(
                    f,
                    "the normals at the ends of the ruling at x = {x} oppose each other"
                )
            }
            Self::Unresolved { from, to } => {
                write!(
                    f,
                    "the patch does not go on between x = {from} and x = {to}"
                )
            }
        }
    }
}

/// Rulings sampled by [`certify`] at least.
const LEAST_RULINGS: usize = 8;
/// Rulings sampled at most.
const MAX_RULINGS: usize = 1 << 16;
/// Golden-section steps in the local search: the bracket shrinks by `0.618^40 < 1e-8`.
const SEARCH_STEPS: usize = 40;
/// Normals (relative to the size of the patch) and ratios of normals that f64 cannot tell from zero: the
/// relative rounding of rails and their derivatives, with room for cancellation.
const ROUNDING: f64 = 1e-12;

/// Measures a ruled patch on `rulings` rulings (8 at least, 65536 at most, more where the patch changes fast)
/// and refines every worst place locally.
///
/// # Errors
/// [`GeometryError`] when a ruling of the patch does not exist, [`GeometryError::NoValue`] where it is not
/// finite, [`GeometryError::Degenerate`] when all rulings have length zero or both rails stand still.
///
/// ```
/// use torse_geometry::developable::{Singularity, certify};
/// use torse_geometry::{Bernstein, Curve, RuledSurface};
/// // A hyperbolic paraboloid is ruled but not developable.
/// let rail = |points: [[f64; 3]; 2]| Curve::new(Bernstein, points.to_vec());
/// let first = rail([[0.0, 0.0, 0.0], [1.0, 0.0, 0.0]])?;
/// let second = rail([[0.0, 1.0, 0.0], [1.0, 1.0, 1.0]])?;
/// let certificate = certify(&RuledSurface::new(first, second), 32)?;
/// assert!((certificate.twist.value.to_degrees() - 45.0).abs() < 1e-6 && certificate.twist.x < 1e-6);
/// assert!(certificate.is_regular() && !certificate.is_developable_within(0.1));
///
/// // A cone whose apex lies halfway between its rails is developable but not regular.
/// let first = rail([[1.0, 0.0, 0.0], [0.0, 1.0, 0.0]])?;
/// let second = rail([[-1.0, 0.0, 2.0], [0.0, -1.0, 2.0]])?;
/// let certificate = certify(&RuledSurface::new(first, second), 32)?;
/// assert!(certificate.determinant.value < 1e-15);
/// assert!(matches!(certificate.singularity(), Some(Singularity::NormalTurns(at)) if (at.v - 0.5).abs() < 1e-9));
/// assert!(certificate.clearance.is_some_and(|worst| worst.value < 0.0 && (worst.v - 0.5).abs() < 1e-9));
/// # Ok::<(), torse_geometry::GeometryError>(())
/// ```
pub fn certify<R: Rails<f64> + ?Sized>(patch: &R, rulings: usize) -> Result<PatchCertificate> {
    let count = rulings.clamp(LEAST_RULINGS, MAX_RULINGS);
    let last = crate::error::count(count - 1);
    let xs = (0..count).into_par_iter();
    let xs = xs.map(|i| crate::error::count(i) / last);
    let extent = Extent::measure(patch, |x| x);
    let reduced = |x: f64| {
        let extent = extent.unwrap_or(Extent::ONE);
        Ok((x, RulingForms::reduced(patch, &x, extent)?))
    };
    let samples = in_order(xs.map(reduced).collect())?;
    let extent = extent.ok_or(GeometryError::Degenerate {
        what: "a patch whose rulings or rails have no length",
        at: Place::Whole,
    })?;
    let (samples, gap) = resolved(samples, reduced)?;
    let measured = samples.par_iter().map(|(x, forms)| measure(*x, forms));
    let measured = in_order(measured.collect())?;
    let worst = |quantity| {
        search(&measured, quantity, |x| {
            let (x, forms) = reduced(x)?;
            measure(x, &forms)
        })
    };
    let finite = |worst: Worst| worst.value.is_finite().then_some(worst);
    let wanted = [DETERMINANT, TWIST, GAUSSIAN, CLEARANCE, NORMAL, SIDE];
    let found = in_order(wanted.par_iter().map(|quantity| worst(*quantity)).collect())?;
    let [determinant, twist, gaussian, clearance, normal, side] = found.as_slice() else {
        return Err(GeometryError::TooFew {
            what: "quantities of a certificate",
            needed: wanted.len(),
            given: found.len(),
        });
    };
    let (clearance, normal, side) = (clearance.negated(), normal.negated(), side.negated());
    let singularity = if side.value < -ROUNDING {
        Some(Singularity::NormalTurns(side))
    } else if normal.value <= ROUNDING {
        Some(Singularity::NormalVanishes(normal.within_ruling()))
    } else if side.value <= ROUNDING {
        Some(Singularity::NormalTurns(side))
    } else {
        gap.map(|[from, to]| Singularity::Unresolved { from, to })
    };
    Ok(PatchCertificate {
        determinant: determinant.whole(),
        twist: twist.whole(),
        gaussian: finite(gaussian.with(extent.curvature(gaussian.value))),
        clearance: finite(clearance.with(extent.length(clearance.value))),
        normal: normal.within_ruling(),
        singularity,
    })
}

/// All values, or the first error: the same on every run, whichever thread came first.
fn in_order<T>(all: Vec<Result<T>>) -> Result<Vec<T>> {
    all.into_iter().collect()
}

impl Worst {
    fn with(self, value: f64) -> Self {
        Self { value, ..self }
    }

    fn negated(self) -> Self {
        self.with(0.0 - self.value)
    }

    fn whole(self) -> Self {
        Self { v: 0.0, ..self }
    }

    fn within_ruling(self) -> Self {
        Self {
            v: self.v.clamp(0.0, 1.0),
            ..self
        }
    }
}

/// The quantities on one ruling, and the place on it where the normal is shortest.
struct Measured {
    x: f64,
    v: f64,
    values: Intervals,
}

fn measure(x: f64, forms: &RulingForms<f64>) -> Result<Measured> {
    let squares = forms.squares();
    let values = squares.intervals().ok_or(GeometryError::NoValue {
        what: "certificate of a ruling",
        at: Place::Parameter(x),
    })?;
    // Parallel normals of equal length are shortest everywhere.
    let v = if squares.parallel || squares.bend == 0.0 {
        0.0
    } else {
        squares.approach / squares.bend
    };
    Ok(Measured { x, v, values })
}

/// The maximum over the samples, refined by golden-section search between the neighbours of the best.
fn search(
    samples: &[Measured],
    quantity: usize,
    measure: impl Fn(f64) -> Result<Measured>,
) -> Result<Worst> {
    let value = |m: &Measured| m.values[quantity][0];
    let found = |m: &Measured| Worst {
        value: value(m),
        x: m.x,
        v: m.v,
    };
    let mut peak = 0;
    for (i, sample) in samples.iter().enumerate() {
        if samples
            .get(peak)
            .is_some_and(|best| value(sample) > value(best))
        {
            peak = i;
        }
    }
    let Some(best) = samples.get(peak) else {
        return Err(GeometryError::TooFew {
            what: "rulings",
            needed: 1,
            given: 0,
        });
    };
    let mut best = found(best);
    let around = |i: usize| samples.get(i).map_or(best.x, |m| m.x);
    let (mut a, mut b) = (around(peak.saturating_sub(1)), around(peak + 1));
    let golden = 0.5 * (5.0_f64.sqrt() - 1.0);
    let mut at = |x: f64| -> Result<f64> {
        let measured = found(&measure(x)?);
        if measured.value > best.value {
            best = measured;
        }
        Ok(measured.value)
    };
    let inner = |a: f64, b: f64| [b - golden * (b - a), a + golden * (b - a)];
    let [mut left, mut right] = inner(a, b);
    let (mut on_left, mut on_right) = (at(left)?, at(right)?);
    for _ in 0..SEARCH_STEPS {
        if on_left >= on_right {
            (b, right, on_right) = (right, left, on_left);
            left = inner(a, b)[0];
            on_left = at(left)?;
        } else {
            (a, left, on_left) = (left, right, on_right);
            right = inner(a, b)[1];
            on_right = at(right)?;
        }
    }
    Ok(best)
}
