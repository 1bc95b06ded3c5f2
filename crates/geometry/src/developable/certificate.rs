//! Certificates for ruled patches: how developable, and regular or not, each with the worst place.
//!
//! With rails `P, Q` and ruling `R = Q - P` the (unnormalised) normals at the two ends of a ruling are
//! `N0 = P' x R` and `N1 = Q' x R`, and along the ruling `N(v) = (1 - v) N0 + v N1`. So
//!
//! * the patch is *developable* at `x` when `N0` and `N1` are parallel, that is
//!   `det(P', Q', R) = 0`; the angle between them is how far the tangent plane turns;
//! * a developable patch is *regular* on the whole ruling when `N0 . N1 > 0`. Otherwise `N(v)` vanishes
//!   inside, at the edge of regression (of a cone: the apex), where neighbouring rulings cross. In
//!   general the rulings come closest at `v* = (P' x R) . (R x R') / |R x R'|^2`.
//!
//! Along a ruling the worst place is known in closed form; from ruling to ruling [`certify`] measures on
//! f64: samples, then a local search. Its numbers are estimates: what it finds bad is bad, and that nothing
//! worse lies between the samples is proved by [`enclose`](super::enclose), which gives bounds for the same
//! quantities, and by [`prove_developable`](super::prove_developable) and
//! [`prove_regular`](super::prove_regular).

use crate::error::Result;
use crate::surface::Rails;
use crate::vector::{cross, det, dot, lerp, norm, sub};
use torse_algebra::Jet;

/// The worst value of a quantity and where it is taken.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Worst {
    /// The value.
    pub value: f64,
    /// The parameter of the ruling.
    pub x: f64,
    /// The position on the ruling in [0, 1]; 0 where the quantity belongs to the whole ruling.
    pub v: f64,
}

/// What [`certify`] measured: estimates, for bounds see [`enclose`](super::enclose).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Certificate {
    /// The largest `|det(P', Q', R)| / (|P'| |Q'| |R|)`.
    pub determinant: Worst,
    /// The largest angle between the tangent planes at the ends of a ruling, in radians (0 to pi/2:
    /// planes, not normals).
    pub twist: Worst,
    /// The largest absolute Gaussian curvature `det(P', Q', R)^2 / |N(v)|^4`, on each ruling where `N(v)` is
    /// shortest; infinite at a singular point.
    pub gaussian: Worst,
    /// The smallest distance, along a ruling and in units of length, from the patch to the point where
    /// the ruling meets its neighbours (the edge of regression, the apex): negative when that point is
    /// inside the patch, infinite when no ruling meets its neighbours (cylinders).
    pub clearance: Worst,
}

impl Certificate {
    /// Whether no ruling meets its neighbours inside the patch, as far as measured.
    #[must_use]
    pub fn is_regular(&self) -> bool {
        self.clearance.value > 0.0
    }
}

/// Rulings sampled by [`certify`] at least.
const LEAST_RULINGS: usize = 8;
/// Rulings sampled at most.
const MOST_RULINGS: usize = 1 << 16;
/// Golden-section steps in the local search: the bracket shrinks by `0.618^40 < 1e-8`.
const SEARCH_STEPS: usize = 40;

/// Measures a ruled patch on `rulings` rulings (8 at least, 65536 at most) and refines every worst place locally.
///
/// # Errors
/// [`GeometryError`](crate::GeometryError) when a ruling of the patch does not exist.
///
/// ```
/// use torse_geometry::developable::certify;
/// use torse_geometry::{Bernstein, Curve, RuledSurface};
/// // A hyperbolic paraboloid is ruled but not developable.
/// let rail = |points: [[f64; 3]; 2]| Curve::new(Bernstein, points.to_vec());
/// let first = rail([[0.0, 0.0, 0.0], [1.0, 0.0, 0.0]])?;
/// let second = rail([[0.0, 1.0, 0.0], [1.0, 1.0, 1.0]])?;
/// let certificate = certify(&RuledSurface::new(first, second), 32)?;
/// assert!((certificate.twist.value.to_degrees() - 45.0).abs() < 1e-6 && certificate.twist.x < 1e-6);
///
/// // A cone whose apex lies halfway between its rails is developable but not regular.
/// let first = rail([[1.0, 0.0, 0.0], [0.0, 1.0, 0.0]])?;
/// let second = rail([[-1.0, 0.0, 2.0], [0.0, -1.0, 2.0]])?;
/// let certificate = certify(&RuledSurface::new(first, second), 32)?;
/// assert!(certificate.determinant.value < 1e-15);
/// assert!(!certificate.is_regular() && (certificate.clearance.v - 0.5).abs() < 1e-9);
/// # Ok::<(), torse_geometry::GeometryError>(())
/// ```
pub fn certify(patch: &impl Rails<f64>, rulings: usize) -> Result<Certificate> {
    let xs = samples(rulings.clamp(LEAST_RULINGS, MOST_RULINGS));
    Ok(Certificate {
        determinant: search(&xs, |x| {
            Ok(Place::whole(Ruling::at(patch, x)?.determinant()))
        })?,
        twist: search(&xs, |x| Ok(Place::whole(Ruling::at(patch, x)?.twist())))?,
        gaussian: search(&xs, |x| Ok(Ruling::at(patch, x)?.curvature()))?,
        clearance: {
            let worst = search(&xs, |x| {
                let Place { value, v } = Ruling::at(patch, x)?.clearance();
                Ok(Place { value: -value, v })
            })?;
            Worst {
                value: -worst.value,
                ..worst
            }
        },
    })
}

fn samples(count: usize) -> Vec<f64> {
    #[allow(clippy::cast_precision_loss)]
    let last = (count.max(2) - 1) as f64;
    #[allow(clippy::cast_precision_loss)]
    let at = |i: usize| i as f64 / last;
    (0..count.max(2)).map(at).collect()
}

/// A value on one ruling and where on it.
struct Place {
    value: f64,
    v: f64,
}

impl Place {
    fn whole(value: f64) -> Self {
        Self { value, v: 0.0 }
    }
}

/// The maximum over the samples, refined by golden-section search between its neighbours.
fn search(xs: &[f64], f: impl Fn(f64) -> Result<Place>) -> Result<Worst> {
    let mut best = Worst {
        value: f64::NEG_INFINITY,
        x: 0.0,
        v: 0.0,
    };
    let mut keep = |x: f64| -> Result<f64> {
        let Place { value, v } = f(x)?;
        if value > best.value {
            best = Worst { value, x, v };
        }
        Ok(value)
    };
    let mut peak = (0, f64::NEG_INFINITY);
    for (i, &x) in xs.iter().enumerate() {
        let value = keep(x)?;
        if value > peak.1 {
            peak = (i, value);
        }
    }
    let around = |i: usize| xs.get(i).copied();
    let mut a = around(peak.0.saturating_sub(1)).unwrap_or(0.0);
    let mut b = around(peak.0 + 1).unwrap_or(1.0);
    let golden = 0.5 * (5.0_f64.sqrt() - 1.0);
    for _ in 0..SEARCH_STEPS {
        let (left, right) = (b - golden * (b - a), a + golden * (b - a));
        if keep(left)? >= keep(right)? {
            b = right;
        } else {
            a = left;
        }
    }
    Ok(best)
}

/// One ruling with the first derivatives of the rails.
struct Ruling {
    p: [f64; 3],
    q: [f64; 3],
    r: [f64; 3],
}

impl Ruling {
    fn at(patch: &impl Rails<f64>, x: f64) -> Result<Self> {
        let [p, q] = patch.rail_jets(&x, 1)?;
        let coefficient = |jets: &[Jet<f64>; 3], n: usize| -> [f64; 3] {
            std::array::from_fn(|axis| jets[axis].coefficients().get(n).copied().unwrap_or(0.0))
        };
        Ok(Self {
            r: sub(&coefficient(&q, 0), &coefficient(&p, 0)),
            p: coefficient(&p, 1),
            q: coefficient(&q, 1),
        })
    }

    fn determinant(&self) -> f64 {
        let volume = norm(&self.p) * norm(&self.q) * norm(&self.r);
        if volume > 0.0 {
            det(&self.p, &self.q, &self.r).abs() / volume
        } else {
            0.0
        }
    }

    fn twist(&self) -> f64 {
        let (n0, n1) = (cross(&self.p, &self.r), cross(&self.q, &self.r));
        norm(&cross(&n0, &n1)).atan2(dot(&n0, &n1).abs())
    }

    /// The largest absolute Gaussian curvature of the ruling, where `N(v)` is shortest.
    fn curvature(&self) -> Place {
        let (n0, n1) = (cross(&self.p, &self.r), cross(&self.q, &self.r));
        let change = sub(&n0, &n1);
        let v = (dot(&n0, &change) / dot(&change, &change)).clamp(0.0, 1.0);
        let v = if v.is_nan() { 0.0 } else { v };
        let normal = lerp(&n0, &n1, &v);
        let (square, volume) = (dot(&normal, &normal), det(&self.p, &self.q, &self.r));
        let value = if square > 0.0 {
            (volume / square).powi(2)
        } else {
            f64::INFINITY
        };
        Place { value, v }
    }

    /// Signed distance from [0, 1] to the closest approach `v*` of the neighbouring ruling.
    fn clearance(&self) -> Place {
        let n0 = cross(&self.p, &self.r);
        let turn = cross(&self.r, &sub(&self.q, &self.p));
        let square = dot(&turn, &turn);
        let v = dot(&n0, &turn) / square;
        // Rulings that turn less than rounding are parallel: they meet nowhere.
        let reach = norm(&self.r) * (norm(&self.p) + norm(&self.q));
        if square.sqrt() <= 4.0 * f64::EPSILON * reach || !v.is_finite() {
            return Place {
                value: f64::INFINITY,
                v: 0.0,
            };
        }
        let outside = (-v).max(v - 1.0);
        Place {
            value: outside * norm(&self.r),
            v,
        }
    }
}
