//! f64 bases, curves, surfaces and rulings against certified enclosures: the error of each evaluator in units
//! in the last place of its largest term, and that it stays below a bound that is asserted.

use crate::ulps::{BITS, agrees, ball, points, shape, ulps, unit};
use proptest::prelude::*;
use torse_algebra::Ball;
use torse_geometry::{
    Basis, Bernstein, Coordinate, Curve, Gbt, Over, PlaneFamily, Surface, TensorSurface, exact,
};

#[test]
fn basis_rows_lie_within_a_few_ulps_of_the_enclosure() {
    let input = (shape(), shape(), 2..=32_usize, unit());
    agrees("Gbt::row", 4.0, 96, input, |(mu, nu, degree, x)| {
        let gbt = Gbt::new(mu, nu).unwrap();
        let row = gbt.row(degree, &x).unwrap();
        let balls = gbt.over(&ball).unwrap().row(degree, &ball(&x)).unwrap();
        row.iter()
            .zip(&balls)
            .map(|(v, b)| ulps(*v, b, 1.0))
            .fold(0.0, f64::max)
    });
}

#[test]
fn derivative_rows_lie_within_ulps_of_their_size() {
    let input = (shape(), shape(), 2..=32_usize, unit(), 1..=4_usize);
    agrees(
        "Gbt::derivative_rows",
        24.0,
        64,
        input,
        |(mu, nu, degree, x, order)| {
            let gbt = Gbt::new(mu, nu).unwrap();
            let rows = gbt.derivative_rows(degree, &x, order).unwrap();
            let balls = gbt
                .over(&ball)
                .unwrap()
                .derivative_rows(degree, &ball(&x), order)
                .unwrap();
            let mut worst = 0.0_f64;
            for (row, balls) in rows.iter().zip(&balls) {
                let scale = row.iter().fold(0.0_f64, |m, v| m.max(v.abs()));
                worst = row
                    .iter()
                    .zip(balls)
                    .map(|(v, b)| ulps(*v, b, scale))
                    .fold(worst, f64::max);
            }
            worst
        },
    );
}

#[test]
fn curve_points_lie_within_ulps_of_the_control_points() {
    let input = (shape(), shape(), points::<3>(3..=33_usize), unit());
    agrees("Curve::point", 5.0, 96, input, |(mu, nu, points, x)| {
        let curve = Curve::new(Gbt::new(mu, nu).unwrap(), points).unwrap();
        let balls = curve.over(&ball).unwrap().point(&ball(&x)).unwrap();
        curve
            .point(&x)
            .unwrap()
            .iter()
            .zip(&balls)
            .map(|(v, b)| ulps(*v, b, 10.0))
            .fold(0.0, f64::max)
    });
}

#[test]
fn bernstein_curves_agree_with_exact_rational_evaluation() {
    let input = (points::<2>(2..=33_usize), unit());
    agrees("Curve<Bernstein>::point", 5.0, 96, input, |(points, x)| {
        let curve = Curve::new(Bernstein, points).unwrap();
        let values = curve
            .over(&|x| exact(*x))
            .unwrap()
            .point(&exact(x))
            .unwrap();
        let enclosed = values.map(|q| Ball::from_rational(&q, BITS));
        curve
            .point(&x)
            .unwrap()
            .iter()
            .zip(&enclosed)
            .map(|(v, b)| ulps(*v, b, 10.0))
            .fold(0.0, f64::max)
    });
}

#[test]
fn surface_points_lie_within_ulps_of_the_control_net() {
    let net = (2..=9_usize, 2..=9_usize).prop_flat_map(|(m, n)| {
        prop::collection::vec(
            prop::collection::vec(prop::array::uniform3(-10.0..10.0_f64), n),
            m,
        )
    });
    let input = (shape(), shape(), net, unit(), unit());
    agrees(
        "TensorSurface::point",
        3.0,
        48,
        input,
        |(mu, nu, net, u, v)| {
            let surface =
                TensorSurface::new(Gbt::new(mu, nu).unwrap(), Gbt::new(nu, mu).unwrap(), net)
                    .unwrap();
            let balls = surface
                .over(&ball)
                .unwrap()
                .point(&ball(&u), &ball(&v))
                .unwrap();
            surface
                .point(&u, &v)
                .unwrap()
                .iter()
                .zip(&balls)
                .map(|(v, b)| ulps(*v, b, 10.0))
                .fold(0.0, f64::max)
        },
    );
}

#[test]
fn rulings_lie_within_ulps_of_the_size_of_their_products() {
    let input = (shape(), shape(), points::<4>(3..=12_usize), unit());
    agrees(
        "PlaneFamily::ruling",
        6.0,
        48,
        input,
        |(mu, nu, planes, x)| {
            let Ok(family) = PlaneFamily::new(Gbt::new(mu, nu).unwrap(), planes) else {
                return 0.0;
            };
            let Ok(ruling) = family.ruling(&x) else {
                return 0.0;
            };
            let enclosed = family.over(&ball).unwrap().ruling(&ball(&x)).unwrap();
            // phi is a product of a plane (at most 10) and its slope.
            let slope = family.curve().derivatives(&x, 1).unwrap()[1];
            let scale = 10.0 * slope.iter().fold(0.0_f64, |m, v| m.max(v.abs()));
            let pairs = ruling.direction.iter().zip(&enclosed.direction);
            pairs.map(|(v, b)| ulps(*v, b, scale)).fold(0.0, f64::max)
        },
    );
}

#[test]
fn enclosures_contain_the_exact_value_and_curves_end_in_their_control_points() {
    for (mu, nu) in [(0.1, 0.7), (-1.0, 1.0)] {
        let points = vec![[0.1, 2.0], [3.0, -1.0], [0.3, 0.25], [7.5, 0.7]];
        let curve = Curve::new(Gbt::new(mu, nu).unwrap(), points.clone()).unwrap();
        assert_eq!(curve.point(&0.0).unwrap(), points[0]);
        assert_eq!(curve.point(&1.0).unwrap(), points[3]);
        let end = curve.over(&ball).unwrap().point(&ball(&1.0)).unwrap();
        assert!(end[0].contains(&exact(7.5)));
        assert_eq!(end[0].clone().sign(), Coordinate::sign(&7.5));
    }
}
