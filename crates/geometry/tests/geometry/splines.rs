//! Splines over the rationals, splines through points, arcs of any angle, and curves of several pieces.

use proptest::prelude::*;
use torse_algebra::rational::{integer, ratio};
use torse_algebra::{Ball, Rational};
use torse_geometry::curve::{
    EllipticHelix, EndCondition, Spacing, Spline, interpolate, interpolate_closed,
};
use torse_geometry::prelude::*;
use torse_geometry::vector::{norm, sub};
use torse_geometry::{Coordinate, Over, SpaceCurve, exact_ball};

/// The basis function of Cox and de Boor: another way than knot insertion.
fn basis(knots: &[Rational], i: usize, degree: usize, t: &Rational, last: bool) -> Rational {
    let at = |k: usize| knots[k].clone();
    if degree == 0 {
        // The last value of the parameter belongs to the interval before it, all others to the one after them.
        let inside = if last {
            at(i) < *t && *t <= at(i + 1)
        } else {
            at(i) <= *t && *t < at(i + 1)
        };
        return integer(i64::from(inside));
    }
    let part = |low: usize, high: usize, numerator: Rational, k: usize| {
        let width = at(high) - at(low);
        if width == integer(0) {
            return integer(0);
        }
        numerator / width * basis(knots, k, degree - 1, t, last)
    };
    part(i, i + degree, t.clone() - at(i), i)
        + part(i + 1, i + degree + 1, at(i + degree + 1) - t.clone(), i + 1)
}

fn point(spline: &Spline, t: &Rational) -> [Rational; 3] {
    let last = *t == spline.domain()[1];
    let mut sums: [Rational; 4] = std::array::from_fn(|_| integer(0));
    for (i, point) in spline.points().iter().enumerate() {
        let weight = spline.weights().map_or(integer(1), |w| w[i].clone());
        let share = weight * basis(spline.knots(), i, spline.degree(), t, last);
        let [x, y, z] = point.clone();
        for (sum, c) in sums.iter_mut().zip([x, y, z, integer(1)]) {
            *sum = sum.clone() + share.clone() * c;
        }
    }
    let [x, y, z, w] = sums;
    [x, y, z].map(|c| c / w.clone())
}

/// A spline with knots of random multiplicities, sometimes not clamped, sometimes weighted.
fn splines() -> impl Strategy<Value = Spline> {
    (1_usize..5, 1_usize..6, any::<bool>(), any::<bool>()).prop_flat_map(
        |(degree, extra, clamped, weighted)| {
            let points = degree + extra;
            let steps = proptest::collection::vec(0_i64..4, points + degree);
            let control = proptest::collection::vec(proptest::array::uniform3(-50_i64..50), points);
            let weights = proptest::collection::vec(1_i64..9, points);
            (steps, control, weights).prop_filter_map(
                "no range",
                move |(steps, control, weights)| {
                    let mut knots = vec![integer(0)];
                    for (k, step) in steps.iter().enumerate() {
                        let fixed = clamped && (k < degree || k >= points);
                        let last = knots.last().cloned()?;
                        knots.push(last + if fixed { integer(0) } else { ratio(*step, 3)? });
                    }
                    let control = control.into_iter().map(|p| p.map(integer)).collect();
                    let weights = weighted.then(|| weights.into_iter().map(integer).collect());
                    Spline::new(degree, knots, control, weights).ok()
                },
            )
        },
    )
}

proptest! {
    #[test]
    fn pieces_are_the_spline_of_cox_and_de_boor(spline in splines(), numerator in 0_i64..=12) {
        let share = ratio(numerator, 12).unwrap();
        let (pieces, breaks) = (spline.pieces().unwrap(), spline.breaks());
        let [from, to] = spline.domain();
        prop_assert_eq!(pieces.len() + 1, breaks.len());
        for (piece, ends) in pieces.iter().zip(breaks.windows(2)) {
            let x = ends[0].clone() + share.clone() * (ends[1].clone() - ends[0].clone());
            let t = from.clone() + x * (to.clone() - from.clone());
            // At an inner knot of full multiplicity the spline may jump: the sum over basis functions sees the later side.
            if numerator < 12 || ends[1] == integer(1) {
                prop_assert_eq!(piece.point(&share).unwrap(), point(&spline, &t));
            }
        }
    }

    #[test]
    fn a_part_and_its_reverse_are_on_the_spline(spline in splines(), a in 0_i64..10, width in 1_i64..10, x in 0_i64..=8) {
        let [from, to] = spline.domain();
        let at = |share: Rational| from.clone() + share * (to.clone() - from.clone());
        let low = ratio(a, 20).unwrap();
        let high = low.clone() + ratio(width, 20).unwrap();
        let part = spline.part(&at(low.clone()), &at(high.clone())).unwrap();
        let share = low.clone() + ratio(x, 9).unwrap() * (high - low);
        let t = at(share);
        prop_assert_eq!(part.point(&t).unwrap(), spline.point(&t).unwrap());
        let mirrored = from.clone() + to.clone() - t.clone();
        // At a jump the two sides differ: there the reverse takes the other.
        if !spline.knots().contains(&t) {
            prop_assert_eq!(spline.reversed().point(&mirrored).unwrap(), spline.point(&t).unwrap());
        }
    }

    #[test]
    fn splines_through_points_are_c2_and_pass_them(
        points in proptest::collection::vec(proptest::array::uniform3(-100.0_f64..100.0), 3..12),
        closed in any::<bool>(),
        spacing in 0_usize..3,
    ) {
        let (_, spacing) = Spacing::ALL[spacing];
        let made = if closed {
            interpolate_closed(&points, spacing)
        } else {
            interpolate(&points, spacing, [EndCondition::Natural, EndCondition::Tangent([1.0, 2.0, 3.0])])
        };
        let found = made.unwrap();
        prop_assert!(found.distance < 1e-9, "{}", found.distance);
        let rails = PiecewiseRail::spline(&found.spline).unwrap().rails().unwrap();
        let widths: Vec<f64> = found.spline.breaks().windows(2).map(|b| (b[1].clone() - b[0].clone()).approximate()).collect();
        let count = rails.len();
        for i in 0..if closed { count } else { count - 1 } {
            let next = (i + 1) % count;
            let (before, after) = (rails[i].derivatives(1.0, 2).unwrap(), rails[next].derivatives(0.0, 2).unwrap());
            for (power, (a, b)) in (0..).zip(before.iter().zip(&after)) {
                let scaled = |v: &[f64; 3], w: f64| v.map(|c| c / w.powi(power));
                let (a, b) = (scaled(a, widths[i]), scaled(b, widths[next]));
                let size = 1.0 + norm(&a);
                // Derivatives of control points that differ by rounding, over the square of a short step.
                let short = 1.0 / widths[i].min(widths[next]).powi(power);
                prop_assert!(norm(&sub(&a, &b)) < 1e-7 * size * (1.0 + short), "{power}");
            }
        }
        for (point, x) in points.iter().zip(found.spline.breaks()) {
            let there = PiecewiseRail::spline(&found.spline).unwrap().point(x.approximate()).unwrap();
            prop_assert!(norm(&sub(&there, point)) < 1e-9);
        }
    }
}

#[test]
fn a_natural_spline_is_that_of_the_literature() {
    // The natural cubic spline of 0, 1, 0 at 0, 1, 2 has the slopes 3/2, 0, -3/2.
    let points = [[0.0, 0.0, 0.0], [1.0, 1.0, 0.0], [2.0, 0.0, 0.0]];
    let found = interpolate(&points, Spacing::Uniform, [EndCondition::Natural; 2]).unwrap();
    let pieces = PiecewiseRail::spline(&found.spline)
        .unwrap()
        .rails()
        .unwrap();
    for (piece, (start, end)) in pieces.iter().zip([(1.5, 0.0), (0.0, -1.5)]) {
        assert!((piece.derivative(0.0).unwrap()[1] - start).abs() < 1e-15);
        assert!((piece.derivative(1.0).unwrap()[1] - end).abs() < 1e-15);
    }
}

#[test]
fn what_is_no_spline_is_refused() {
    let q = |x: i64| [integer(x), integer(0), integer(0)];
    let points = || vec![q(0), q(1), q(2)];
    let knots = |list: &[i64]| list.iter().copied().map(integer).collect::<Vec<_>>();
    let message = |knots: Vec<Rational>, weights: Option<Vec<Rational>>| {
        Spline::new(2, knots, points(), weights)
            .unwrap_err()
            .to_string()
    };
    assert!(message(knots(&[0, 0, 0, 1, 1]), None).contains("knots of a spline"));
    assert!(message(knots(&[0, 0, 2, 1, 3, 3]), None).contains("knot that falls"));
    assert!(message(knots(&[0, 0, 0, 0, 1, 1]), None).contains("too many copies"));
    assert!(message(knots(&[0, 0, 0, 1, 1, 1]), Some(knots(&[1, 0, 1]))).contains("weight 1 is 0"));
    assert!(
        Spline::new(65, Vec::new(), points(), None)
            .unwrap_err()
            .to_string()
            .contains("degree")
    );
    let many: Vec<[Rational; 3]> = (0..3000).map(q).collect();
    let long: Vec<Rational> = (0..3000 + 33).map(integer).collect();
    let refused = Spline::new(32, long, many, None).unwrap_err().to_string();
    assert!(refused.contains("the work for a spline"), "{refused}");
}

#[test]
fn arcs_of_any_angle_are_round_on_doubles_and_enclosed_on_balls() {
    let arc = EllipticHelix::about(
        [1.0, 2.0, 3.0],
        [0.0, 0.0, 1.0],
        [5.0, 2.0, 3.0],
        250.0,
        7.0,
    )
    .unwrap();
    let balls = arc.over(&|x: &f64| exact_ball(*x, 100)).unwrap();
    for k in 0..=16 {
        let x = f64::from(k) / 16.0;
        let [px, py, pz] = arc.space_point(&x).unwrap();
        assert!((libm_hypot(px - 1.0, py - 2.0) - 4.0).abs() < 1e-14);
        assert!((pz - 3.0 - 7.0 * x).abs() < 1e-13);
        let jets: [torse_algebra::Jet<Ball>; 3] = balls.space_jet(&exact_ball(x, 100), 3).unwrap();
        let near = arc.space_jet(&x, 3).unwrap();
        for (ball, near) in jets.iter().zip(&near) {
            for (ball, near) in ball.coefficients().iter().zip(near.coefficients()) {
                let (low, high) = ball.to_f64_bounds();
                assert!(
                    low - 1e-12 <= *near && *near <= high + 1e-12,
                    "{low} {near} {high}"
                );
            }
        }
    }
    // Over an interval the enclosure holds what is inside.
    let wide = Ball::from_bounds(&ratio(1, 4).unwrap(), &ratio(3, 8).unwrap(), 100);
    let jets = balls.space_jet(&wide, 1).unwrap();
    for x in [0.25, 0.3, 0.375] {
        for (ball, value) in jets.iter().zip(arc.space_point(&x).unwrap()) {
            let (low, high) = ball.value().to_f64_bounds();
            assert!(low <= value && value <= high);
        }
    }
}

fn libm_hypot(x: f64, y: f64) -> f64 {
    (x * x + y * y).sqrt()
}

#[test]
fn an_arc_has_its_length_its_box_and_its_nearest_point() {
    let arc = Rail::from(
        EllipticHelix::about([0.0; 3], [0.0, 0.0, 1.0], [2.0, 0.0, 0.0], 135.0, 0.0).unwrap(),
    );
    let exact = 2.0 * 135.0_f64.to_radians();
    assert!((arc.length(1e-10).unwrap() - exact).abs() < 1e-9);
    let [low, high] = arc.bounding_box(1e-9).unwrap();
    assert!((high[1] - 2.0).abs() < 1e-8 && (low[0] + 2.0_f64.sqrt()).abs() < 1e-8);
    let nearest = arc.nearest([0.0, 5.0, 1.0], 1e-9).unwrap();
    assert!(
        (nearest.x - 2.0 / 3.0).abs() < 1e-4 && (nearest.distance - 10.0_f64.sqrt()).abs() < 1e-8
    );
    let [first, second] = arc.split(0.25).unwrap();
    assert_eq!(first.point(1.0).unwrap(), second.point(0.0).unwrap());
}

#[test]
fn a_cone_over_an_arc_of_any_angle_unrolls_to_its_sector() {
    let circle = |r: f64, z: f64| {
        Rail::from(
            EllipticHelix::about([0.0, 0.0, z], [0.0, 0.0, 1.0], [r, 0.0, z], 200.0, 0.0).unwrap(),
        )
    };
    let sheet = Sheet::ruled(circle(3.0, 0.0), circle(1.5, 2.0));
    let slant = |r: f64| (r * r + (r * 4.0 / 3.0) * (r * 4.0 / 3.0)).sqrt();
    let exact = 0.5 * 200.0_f64.to_radians() * (3.0 * slant(3.0) - 1.5 * slant(1.5));
    let flat = sheet.unroll(32, 1e-6).unwrap();
    assert!(
        (flat.area() - exact).abs() < 1e-5,
        "{} {exact}",
        flat.area()
    );
}

#[test]
fn curves_in_a_row_share_the_parameter_by_length() {
    let line = |a: [f64; 3], b: [f64; 3]| PiecewiseRail::from(Rail::bezier(&[a, b]).unwrap());
    let row = PiecewiseRail::joined(&[
        line([0.0; 3], [1.0, 0.0, 0.0]),
        line([1.0, 0.0, 0.0], [1.0, 3.0, 0.0]),
    ])
    .unwrap();
    // Lengths are measured.
    let near = |a: [f64; 3], b: [f64; 3]| assert!(norm(&sub(&a, &b)) < 1e-9, "{a:?} {b:?}");
    near(row.point(0.25).unwrap(), [1.0, 0.0, 0.0]);
    near(row.point(0.75).unwrap(), [1.0, 2.0, 0.0]);
    let [a, b] = row
        .common_refinement(&line([0.0, 0.0, 1.0], [4.0, 0.0, 1.0]))
        .unwrap();
    assert_eq!((a.count(), b.count()), (2, 2));
    near(b.rails().unwrap()[0].point(1.0).unwrap(), [1.0, 0.0, 1.0]);
    let back = row.reversed().unwrap();
    near(back.point(0.25).unwrap(), [1.0, 2.0, 0.0]);
    let part = row
        .part(&ratio(1, 8).unwrap(), &ratio(1, 2).unwrap())
        .unwrap();
    near(part.point(0.0).unwrap(), [0.5, 0.0, 0.0]);
    near(part.point(1.0).unwrap(), [1.0, 1.0, 0.0]);
}
