//! f64 derivatives and constructions against certified enclosures, in units in the last place of the largest
//! product that enters them.

use crate::ulps::{agrees, ball, farthest, points, shape, ulps, unit};
use proptest::prelude::*;
use torse_geometry::vector::norm;
use torse_geometry::{
    Basis, Bernstein, Curve, EnvelopingPatch, Gbt, HalfTurn, Over, PatchBounds, PlaneFamily,
    RationalCurve, RotationSurface, RuledSurface, Surface, TangentPatch, TensorSurface,
};

/// `sum_i |row[i]|` times the bound 10 of the coordinates.
fn size(row: &[f64]) -> f64 {
    10.0 * row.iter().map(|v| v.abs()).sum::<f64>()
}

/// The same for a row of derivatives of this order, at least the terms of the seeds' derivatives, which may
/// cancel: at `mu = -1` all of them vanish at the start.
fn derivative_size(order: i32, row: &[f64]) -> f64 {
    size(row).max(10.0 * std::f64::consts::PI.powi(order))
}

fn net() -> impl Strategy<Value = Vec<Vec<[f64; 3]>>> {
    (3..=12_usize, 3..=12_usize).prop_flat_map(|(m, n)| {
        prop::collection::vec(
            prop::collection::vec(prop::array::uniform3(-10.0..10.0_f64), n),
            m,
        )
    })
}

/// Planes whose normals turn about an axis, so that every neighbouring pair meets.
fn planes() -> impl Strategy<Value = Vec<[f64; 4]>> {
    let noise = prop::array::uniform4(-0.2..0.2_f64);
    prop::collection::vec(noise, 3..=33).prop_map(|noise| {
        let count = noise.len() as f64;
        let plane = |(i, [a, b, c, d]): (usize, [f64; 4])| {
            let angle = 2.0 * i as f64 / count;
            [
                libm::cos(angle) + a,
                libm::sin(angle) + b,
                0.5 + c * angle,
                3.0 + d,
            ]
        };
        noise.into_iter().enumerate().map(plane).collect()
    })
}

#[test]
fn bernstein_rows_lie_within_a_few_ulps_of_the_enclosure() {
    agrees(
        "Bernstein::row",
        3.0,
        96,
        (2..=32_usize, unit()),
        |(degree, x)| {
            let row = Bernstein.row(degree, &x).unwrap();
            let balls = Bernstein.row(degree, &ball(&x)).unwrap();
            row.iter()
                .zip(&balls)
                .map(|(v, b)| ulps(*v, b, 1.0))
                .fold(0.0, f64::max)
        },
    );
}

#[test]
fn curve_derivatives_lie_within_ulps_of_the_terms_of_their_sums() {
    let input = (shape(), shape(), points::<3>(3..=33_usize), unit());
    agrees(
        "Curve::derivatives",
        8.0,
        48,
        input,
        |(mu, nu, points, x)| {
            let curve = Curve::new(Gbt::new(mu, nu).unwrap(), points).unwrap();
            let rows = curve
                .basis()
                .derivative_rows(curve.degree(), &x, 3)
                .unwrap();
            let balls = curve
                .over(&ball)
                .unwrap()
                .derivatives(&ball(&x), 3)
                .unwrap();
            let values = curve.derivatives(&x, 3).unwrap();
            let each = (0..).zip(values.iter().zip(&balls).zip(&rows));
            each.map(|(n, ((v, b), row))| farthest(v, b, derivative_size(n, row)))
                .fold(0.0, f64::max)
        },
    );
}

#[test]
fn shape_derivatives_lie_within_ulps_of_the_control_points() {
    let input = (shape(), shape(), points::<2>(3..=33_usize), unit());
    agrees(
        "Curve::shape_derivatives",
        2.0,
        64,
        input,
        |(mu, nu, points, x)| {
            let curve = Curve::new(Gbt::new(mu, nu).unwrap(), points).unwrap();
            let balls = curve
                .over(&ball)
                .unwrap()
                .shape_derivatives(&ball(&x))
                .unwrap();
            let values = curve.shape_derivatives(&x).unwrap();
            values
                .iter()
                .zip(&balls)
                .map(|(v, b)| farthest(v, b, 10.0))
                .fold(0.0, f64::max)
        },
    );
}

#[test]
fn points_in_batches_lie_within_ulps_of_the_control_points() {
    let input = (
        shape(),
        shape(),
        points::<3>(2..=33_usize),
        prop::collection::vec(unit(), 1..100),
    );
    agrees(
        "Curve::points_into",
        6.0,
        24,
        input,
        |(mu, nu, points, xs)| {
            let curve = Curve::new(Gbt::new(mu, nu).unwrap(), points).unwrap();
            let mut out = vec![[0.0; 3]; xs.len()];
            curve.points_into(&xs, &mut out).unwrap();
            let certified = curve.over(&ball).unwrap();
            let error =
                |(x, p): (&f64, &[f64; 3])| farthest(p, &certified.point(&ball(x)).unwrap(), 10.0);
            xs.iter().zip(&out).map(error).fold(0.0, f64::max)
        },
    );
}

#[test]
fn weighted_curves_lie_within_ulps_of_the_control_points() {
    let weighted = points::<3>(2..=33_usize).prop_flat_map(|points| {
        let weights = prop::collection::vec(0.5..2.0_f64, points.len());
        (Just(points), weights)
    });
    let input = (shape(), shape(), weighted, unit());
    agrees(
        "RationalCurve::point",
        5.0,
        64,
        input,
        |(mu, nu, (points, weights), x)| {
            let curve = RationalCurve::new(Gbt::new(mu, nu).unwrap(), &points, weights).unwrap();
            let enclosed = curve.over(&ball).unwrap().point(&ball(&x)).unwrap();
            farthest(&curve.point(&x).unwrap(), &enclosed, 10.0)
        },
    );
}

#[test]
fn partial_derivatives_lie_within_ulps_of_the_terms_of_their_sums() {
    let input = (shape(), shape(), net(), unit(), unit());
    agrees(
        "TensorSurface::partials",
        6.0,
        24,
        input,
        |(mu, nu, net, u, v)| {
            let (first, second) = (Gbt::new(mu, nu).unwrap(), Gbt::new(nu, mu).unwrap());
            let surface = TensorSurface::new(first, second, net).unwrap();
            let (m, n) = surface.degrees();
            let by_u = first.derivative_rows(m, &u, 2).unwrap();
            let by_v = second.derivative_rows(n, &v, 2).unwrap();
            let values = surface.partials(&u, &v, 2).unwrap();
            let balls = surface
                .over(&ball)
                .unwrap()
                .partials(&ball(&u), &ball(&v), 2)
                .unwrap();
            let orders = [(0, 0), (1, 0), (0, 1), (2, 0), (1, 1), (0, 2)];
            let error = |(i, j): (usize, usize)| {
                let scale = size(&by_u[i]) * size(&by_v[j]) / 10.0;
                farthest(values.get(i, j).unwrap(), balls.get(i, j).unwrap(), scale)
            };
            orders.map(error).into_iter().fold(0.0, f64::max)
        },
    );
}

#[test]
fn gaussian_curvatures_lie_within_ulps_of_their_conditioned_size() {
    let input = (shape(), shape(), net(), 0.01..0.99_f64, 0.01..0.99_f64);
    agrees(
        "Surface::gaussian_curvature",
        12.0,
        32,
        input,
        |(mu, nu, net, u, v)| {
            let (first, second) = (Gbt::new(mu, nu).unwrap(), Gbt::new(nu, mu).unwrap());
            let surface = TensorSurface::new(first, second, net).unwrap();
            let partials = surface.partials(&u, &v, 2).unwrap();
            let length = |i, j| norm(partials.get(i, j).unwrap());
            let area = norm(&partials.normal());
            let (tangents, bends) = (
                length(1, 0) * length(0, 1),
                length(2, 0) * length(0, 2) + length(1, 1).powi(2),
            );
            // The numerator's products, and how much of the normal cancels.
            let scale = bends * tangents.powi(2) / area.powi(4) * (tangents / area);
            let enclosed = surface
                .over(&ball)
                .unwrap()
                .gaussian_curvature(&ball(&u), &ball(&v))
                .unwrap();
            ulps(
                surface.gaussian_curvature(&u, &v).unwrap(),
                &enclosed,
                scale,
            )
        },
    );
}

#[test]
fn ruled_and_rotation_surfaces_lie_within_ulps_of_the_control_points() {
    let rails = (points::<3>(2..=33_usize), points::<3>(2..=33_usize));
    let input = (shape(), shape(), rails, unit(), unit());
    agrees(
        "RuledSurface::point",
        5.0,
        48,
        input,
        |(mu, nu, (first, second), u, v)| {
            let first = Curve::new(Gbt::new(mu, nu).unwrap(), first).unwrap();
            let surface = RuledSurface::new(first, Curve::new(Bernstein, second).unwrap());
            let enclosed = surface
                .over(&ball)
                .unwrap()
                .point(&ball(&u), &ball(&v))
                .unwrap();
            farthest(&surface.point(&u, &v).unwrap(), &enclosed, 10.0)
        },
    );
    let input = (shape(), shape(), points::<2>(2..=33_usize), unit(), unit());
    agrees(
        "RotationSurface::point",
        7.0,
        48,
        input,
        |(mu, nu, profile, u, v)| {
            let profile = Curve::new(Gbt::new(mu, nu).unwrap(), profile).unwrap();
            let surface = RotationSurface::half_turn(profile, HalfTurn::Upper);
            let enclosed = surface
                .over(&ball)
                .unwrap()
                .point(&ball(&u), &ball(&v))
                .unwrap();
            farthest(&surface.point(&u, &v).unwrap(), &enclosed, 10.0)
        },
    );
}

#[test]
fn feet_and_points_of_rulings_lie_within_ulps_of_their_conditioned_size() {
    let input = (shape(), shape(), planes(), unit());
    agrees(
        "Ruling::foot, EnvelopingPatch::point",
        8.0,
        48,
        input,
        |(mu, nu, planes, x)| {
            let family = PlaneFamily::new(Gbt::new(mu, nu).unwrap(), planes).unwrap();
            let jet = family.curve().derivatives(&x, 1).unwrap();
            // |a| |a'| bounds the products of phi, and with |phi| says how much of them cancels.
            let ruling = family.ruling(&x).unwrap();
            let (products, direction) = (norm(&jet[0]) * norm(&jet[1]), norm(&ruling.direction));
            let scale = (products / direction).powi(2);
            let certified = family.over(&ball).unwrap();
            let foot = farthest(
                &ruling.foot,
                &certified.ruling(&ball(&x)).unwrap().foot,
                scale,
            );
            let patch = EnvelopingPatch::new(family, PatchBounds::Range([-1.0, 2.0])).unwrap();
            let enclosed = patch
                .over(&ball)
                .unwrap()
                .point(&ball(&x), &ball(&0.25))
                .unwrap();
            foot.max(farthest(
                &patch.point(&x, &0.25).unwrap(),
                &enclosed,
                scale + products,
            ))
        },
    );
}

#[test]
fn points_of_regression_lie_within_ulps_of_their_conditioned_size() {
    let input = (shape(), shape(), planes(), unit());
    agrees(
        "PlaneFamily::characteristic_point, TangentPatch",
        6.0,
        48,
        input,
        |(mu, nu, planes, x)| {
            let family = PlaneFamily::new(Gbt::new(mu, nu).unwrap(), planes).unwrap();
            let jet = family.curve().derivatives(&x, 2).unwrap();
            let [a, b, c] = [0, 1, 2].map(|n| [jet[n][0], jet[n][1], jet[n][2]]);
            let products = norm(&jet[0]) * norm(&jet[1]) * norm(&jet[2]);
            let scale = (products / torse_geometry::vector::det(&a, &b, &c).abs()).powi(2);
            let spine = family.characteristic_point(&x).unwrap();
            let certified = family
                .over(&ball)
                .unwrap()
                .characteristic_point(&ball(&x))
                .unwrap();
            let error = farthest(&spine, &certified, scale);
            // At the end of the range that lies on the spine curve.
            let patch = TangentPatch::new(family, [0.0, 1.0]).unwrap();
            let enclosed = patch
                .over(&ball)
                .unwrap()
                .point(&ball(&x), &ball(&0.0))
                .unwrap();
            error.max(farthest(&patch.point(&x, &0.0).unwrap(), &enclosed, scale))
        },
    );
}
