//! Patches with known properties, for all tests of developables and patterns.

use std::f64::consts::PI;
use torse_algebra::{Jet, Scalar};
use torse_geometry::pattern::{FlatPattern, PatternResult, Unrolling};
use torse_geometry::surface::Rails;
use torse_geometry::{Bernstein, Curve, GeometryError, PlaneFamily, RuledSurface, TangentPatch};

/// A Bezier curve.
pub type Rail = Curve<Bernstein, f64, 3>;

/// The Bezier curve with these control points.
pub fn rail(points: &[[f64; 3]]) -> Rail {
    Curve::new(Bernstein, points.to_vec()).unwrap()
}

/// The hyperbolic paraboloid z = x y over the unit square: ruled, regular and not developable.
pub fn saddle() -> RuledSurface<Rail, Rail> {
    RuledSurface::new(
        rail(&[[0.0, 0.0, 0.0], [1.0, 0.0, 0.0]]),
        rail(&[[0.0, 1.0, 0.0], [1.0, 1.0, 1.0]]),
    )
}

/// The pattern of a patch that is known at parameters alone: its bounds are measured.
pub fn unroll(
    patch: &(impl Rails<f64> + ?Sized),
    rulings: usize,
    tolerance: f64,
) -> PatternResult<FlatPattern> {
    Unrolling::within(tolerance)
        .rulings(rulings)
        .measured(patch)
}

/// A patch between two rails given by formulas of the parameter.
pub struct Formula<F>(pub F);

impl<F: Fn(Jet<f64>) -> [[Jet<f64>; 3]; 2] + Sync> Rails<f64> for Formula<F> {
    fn rail_jets(&self, x: &f64, order: usize) -> Result<[[Jet<f64>; 3]; 2], GeometryError> {
        Ok((self.0)(Jet::variable(*x, order)))
    }
}

/// Cosine and sine of an angle in radians.
pub fn turn(angle: &Jet<f64>) -> [Jet<f64>; 2] {
    let quarters = angle.clone() * angle.constant_like(2.0 / PI);
    let (s, c) = quarters.quarter_turn().unwrap();
    [c, s]
}

/// A cone frustum about the z axis: radii, height, swept angle.
pub fn cone(radii: [f64; 2], height: f64, angle: f64) -> impl Rails<f64> {
    Formula(move |x: Jet<f64>| {
        let [c, s] = turn(&(x.clone() * x.constant_like(angle)));
        let ring = |r: f64, z: f64| {
            [
                c.clone() * x.constant_like(r),
                s.clone() * x.constant_like(r),
                x.constant_like(z),
            ]
        };
        [ring(radii[0], 0.0), ring(radii[1], height)]
    })
}

/// The tangent surface of the helix of radius `a` and pitch `2 pi b`, from `from` to `to` along the unit tangents.
pub fn helix(a: f64, b: f64, turns: f64, [from, to]: [f64; 2]) -> impl Rails<f64> {
    let speed = libm::hypot(a, b);
    Formula(move |x: Jet<f64>| {
        let number = |v: f64| x.constant_like(v);
        let angle = x.clone() * number(2.0 * PI * turns);
        let [c, s] = turn(&angle);
        let rail = |t: f64| {
            let t = t / speed;
            [
                c.clone() * number(a) - s.clone() * number(a * t),
                s.clone() * number(a) + c.clone() * number(a * t),
                angle.clone() * number(b) + number(b * t),
            ]
        };
        [rail(from), rail(to)]
    })
}

/// The osculating planes of the twisted cubic.
pub fn osculating_planes() -> PlaneFamily<Bernstein, f64> {
    let planes = vec![
        [0., 0., 1., 0.],
        [0., -1., 1., 0.],
        [1., -2., 1., 0.],
        [3., -3., 1., 1.],
    ];
    PlaneFamily::new(Bernstein, planes).unwrap()
}

/// A general torse: the tangent surface of the twisted cubic.
pub fn cubic() -> TangentPatch<Bernstein, f64> {
    let family = osculating_planes();
    TangentPatch::new(family, [0.5, 1.0]).unwrap()
}
