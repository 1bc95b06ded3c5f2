//! Joins: what is constructed is measured back, and equals the papers' corrected formulas.

use proptest::prelude::*;
use torse_algebra::rational::{integer, ratio};
use torse_algebra::{Fraction, Rational, Scalar, Symbol};
use torse_geometry::{
    Basis, Bernstein, Continuity, Curve, Gbt, GeometryError, Over, PlaneFamily, join,
};

fn named(name: &str) -> Fraction {
    Fraction::named(name)
}

fn left(degree: usize) -> Curve<Gbt<Fraction>, Fraction, 1> {
    let basis = Gbt::new(named("mu1"), named("nu1")).unwrap();
    Curve::new(
        basis,
        (0..=degree).map(|i| [named(&format!("Q{i}"))]).collect(),
    )
    .unwrap()
}

#[test]
fn theorem_2_of_gbt_surfaces_gives_the_second_point_for_all_degrees_up_to_six() {
    let like = named("x");
    let number = |n: usize| like.constant(&Rational::from_integer(n.into()));
    let pi = Fraction::symbol(Symbol::Pi);
    let (nu, mu) = (named("nu1"), named("mu2"));
    for m in 2..=6_usize {
        for n in 2..=6_usize {
            let basis = Gbt::new(named("mu2"), named("nu2")).unwrap();
            let free: Vec<[Fraction; 1]> = (2..=n).map(|i| [named(&format!("R{i}"))]).collect();
            let right = join::next_curve(&left(m), basis, &Continuity::parametric(1, &like), &free)
                .unwrap();
            let factor = |k: usize, shape: &Fraction| {
                number(2 * k - 4) + pi.clone() * (number(1) + shape.clone())
            };
            let (q, p) = (named(&format!("Q{m}")), named(&format!("Q{}", m - 1)));
            let printed = q.clone() + factor(m, &nu).over(&factor(n, &mu)).unwrap() * (q - p);
            assert_eq!(
                right.points()[1][0].clone() - printed,
                number(0),
                "degrees {m}, {n}"
            );
        }
    }
}

#[test]
fn the_beta_condition_holds_as_an_identity_in_all_parameters() {
    // gbt-developable Theorem 4 with formal gamma, lambda, degrees three and four.
    let joint = Continuity::beta(vec![named("gamma"), named("lambda")]).unwrap();
    let basis = Gbt::new(named("mu2"), named("nu2")).unwrap();
    let left = left(3);
    let right = join::next_curve(&left, basis, &joint, &[[named("R3")], [named("R4")]]).unwrap();
    let (end, start) = (left.end_jet(2).unwrap(), right.start_jet(2).unwrap());
    let (gamma, lambda) = (named("gamma"), named("lambda"));
    let zero = gamma.zero_like();
    assert_eq!(
        start[1][0].clone() - gamma.clone() * end[1][0].clone(),
        zero
    );
    let bend = gamma.clone() * gamma * end[2][0].clone() + lambda * end[1][0].clone();
    assert_eq!(start[2][0].clone() - bend, zero);
}

/// The right side of gbt-developable Theorem 4, third line, with `weight` times the lambda term; with
/// gamma = 1, lambda = 0 that of Theorem 3. Q names the left planes of degree k, l is the right degree.
fn theorem_4(k: i64, l: i64, gamma: &Fraction, lambda: &Fraction, weight: i64) -> Fraction {
    let number = |n: i64| gamma.constant(&integer(n));
    let pi = Fraction::symbol(Symbol::Pi);
    let pp = pi.clone() * pi.clone();
    let one = number(1);
    let [mu1, nu1, mu2, nu2] = ["mu1", "nu1", "mu2", "nu2"].map(named);
    let q = |back: i64| named(&format!("Q{}", k - back));
    let slope =
        |n: i64, shape: &Fraction| number(2 * (n - 2)) + pi.clone() * (one.clone() + shape.clone());
    let c = slope(k, &nu1).over(&slope(l, &mu2)).unwrap();
    let bend = |n: i64, shape: &Fraction| {
        number(4 * (n - 2)) * (number(n - 3) + pi.clone() * (one.clone() + shape.clone()))
    };
    let (ck, cl) = (bend(k, &nu1), bend(l, &mu2));
    let delta = q(0) - q(1);
    let square = gamma.clone() * gamma.clone();
    let half_slope = slope(k, &nu1).scaled(&ratio(1, 2).unwrap());
    let last = gamma.clone()
        * (number(2) * pp.clone() * nu1 * gamma.clone()
            + c.clone() * cl.clone()
            + number(2) * c.clone() * pp.clone() * mu2)
        + number(weight) * lambda.clone() * half_slope;
    let bracket = ck * square.clone() * (q(0) - number(2) * q(1) + q(2))
        - pp.clone() * square * (one.clone() - mu1) * (q(1) - q(2))
        + last * delta.clone();
    let divisor = cl + pp * (one - nu2);
    q(0) + c * gamma.clone() * delta + bracket.over(&divisor).unwrap()
}

#[test]
fn theorem_3_holds_as_printed_and_theorem_4_lacks_a_factor_four_at_lambda() {
    let (gamma, lambda) = (named("gamma"), named("lambda"));
    let (zero, one) = (gamma.zero_like(), gamma.one_like());
    for (k, l) in [(3, 3), (2, 4), (4, 3), (5, 4)] {
        let basis = Gbt::new(named("mu2"), named("nu2")).unwrap();
        let (m, free) = (
            usize::try_from(k).unwrap(),
            vec![[zero.clone()]; usize::try_from(l - 2).unwrap()],
        );
        let third = |joint: Continuity<Fraction>| {
            let right = join::next_curve(&left(m), basis.clone(), &joint, &free).unwrap();
            right.points()[2][0].clone()
        };
        let farin_boehm = third(Continuity::parametric(2, &one));
        assert_eq!(
            farin_boehm - theorem_4(k, l, &one, &zero, 1),
            zero,
            "Theorem 3, degrees {k}, {l}"
        );
        let beta = third(Continuity::beta(vec![gamma.clone(), lambda.clone()]).unwrap());
        assert_eq!(
            beta.clone() - theorem_4(k, l, &gamma, &lambda, 4),
            zero,
            "degrees {k}, {l}"
        );
        assert_ne!(
            beta - theorem_4(k, l, &gamma, &lambda, 1),
            zero,
            "as printed, degrees {k}, {l}"
        );
    }
}

#[test]
fn third_order_contact_holds_as_an_identity_in_all_parameters() {
    let basis = Gbt::new(named("mu2"), named("nu2")).unwrap();
    let left = left(3);
    let c3 = Continuity::parametric(3, &named("x"));
    let right = join::next_curve(&left, basis, &c3, &[[named("R4")]]).unwrap();
    let (end, start) = (left.end_jet(3).unwrap(), right.start_jet(3).unwrap());
    for (a, b) in end.iter().zip(&start) {
        assert_eq!(a[0].clone() - b[0].clone(), named("x").zero_like());
    }
}

#[test]
fn the_singular_coefficient_of_second_order_is_the_derived_one() {
    // (l-2)(l-3) + pi (l-2)(1 + mu) + pi^2/4 (1 - nu), which vanishes for l = 2, nu = 1 and for l = 3,
    // mu = -1, nu = 1 only.
    let like = named("x");
    let pi = Fraction::symbol(Symbol::Pi);
    for l in 2..=7_i64 {
        let basis = Gbt::new(named("mu"), named("nu")).unwrap();
        let rows = basis
            .derivative_rows(usize::try_from(l).unwrap(), &like.zero_like(), 2)
            .unwrap();
        let number = |n: i64| like.constant(&integer(n));
        let expected = number((l - 2) * (l - 3))
            + number(l - 2) * pi.clone() * (number(1) + named("mu"))
            + pi.clone() * pi.clone() * (number(1) - named("nu")).scaled(&ratio(1, 4).unwrap());
        assert_eq!(rows[2][2].clone() - expected, number(0), "degree {l}");
    }
    let left = Curve::new(Bernstein, vec![[0.0], [1.0], [3.0]]).unwrap();
    let singular = |mu, nu, free: &[[f64; 1]]| {
        let basis = Gbt::new(mu, nu).unwrap();
        join::next_curve(&left, basis, &Continuity::parametric(2, &0.0), free)
    };
    assert!(matches!(
        singular(0.3, 1.0, &[]),
        Err(GeometryError::SingularJoin {
            order: 2,
            degree: 2,
            ..
        })
    ));
    assert!(matches!(
        singular(-1.0, 1.0, &[[0.0]]),
        Err(GeometryError::SingularJoin {
            order: 2,
            degree: 3,
            ..
        })
    ));
    assert!(singular(-1.0, 0.5, &[[0.0]]).is_ok());
    assert!(matches!(
        join::next_curve(
            &left,
            Gbt::new(-1.0, 0.0).unwrap(),
            &Continuity::parametric(1, &0.0),
            &[[0.0]]
        ),
        Err(GeometryError::SingularJoin {
            order: 1,
            degree: 2,
            ..
        })
    ));
}

fn rational() -> impl Strategy<Value = Rational> {
    (-60..60_i64, 1..12_i64).prop_map(|(n, d)| ratio(n, d).unwrap())
}

fn positive() -> impl Strategy<Value = Rational> {
    (1..60_i64, 1..12_i64).prop_map(|(n, d)| ratio(n, d).unwrap())
}

fn points<const D: usize>(
    counts: std::ops::Range<usize>,
) -> impl Strategy<Value = Vec<[Rational; D]>> {
    prop::collection::vec(
        prop::collection::vec(rational(), D).prop_map(|v| v.try_into().unwrap()),
        counts,
    )
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 48, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn a_joint_is_measured_exactly_as_it_was_made(
        points in points::<3>(4..8),
        free in points::<3>(1..4),
        gamma in positive(),
        lambda in rational(),
        third in rational(),
    ) {
        let left = Curve::new(Bernstein, points).unwrap();
        let betas = vec![gamma, lambda, third];
        let joint = Continuity::beta(betas.clone()).unwrap();
        let right = join::next_curve(&left, Bernstein, &joint, &free).unwrap();
        match join::measure_curves(&left, &right, 3) {
            Ok(measure) => {
                prop_assert!(measure.geometric_order() >= Some(3));
                prop_assert_eq!(measure.betas, betas);
            }
            // The left curve may stand still at its end.
            Err(error) => prop_assert!(matches!(error, GeometryError::Degenerate { .. }), "{}", error),
        }
    }

    #[test]
    fn plane_families_join_up_to_a_factor_exactly(
        planes in points::<4>(4..7),
        gamma in positive(),
        lambda in rational(),
        rho in positive(),
        slope in rational(),
        bend in rational(),
    ) {
        let Ok(left) = PlaneFamily::new(Bernstein, planes) else { return Ok(()) };
        let betas = vec![gamma, lambda];
        let joint = Continuity::beta(betas.clone()).unwrap().scaled(vec![rho.clone(), slope.clone(), bend.clone()]);
        let free = [[1, 2, -1, 3].map(integer)];
        let Ok(right) = join::next_family(&left, Bernstein, &joint.unwrap(), &free) else { return Ok(()) };
        let Ok(measure) = join::measure_families(&left, &right, 2) else { return Ok(()) };
        prop_assert!(measure.geometric_order() >= Some(2));
        prop_assert_eq!(measure.betas, betas);
        prop_assert_eq!(measure.scale, vec![rho, slope, bend]);
    }

    #[test]
    fn control_points_are_recovered_from_either_end(points in points::<2>(3..9)) {
        let curve = Curve::new(Bernstein, points).unwrap();
        let degree = curve.degree();
        let first = join::from_start_jet(&Bernstein, degree, &curve.start_jet(degree).unwrap()).unwrap();
        prop_assert_eq!(first.as_slice(), curve.points());
        let mut last = join::from_end_jet(&Bernstein, degree, &curve.end_jet(degree).unwrap()).unwrap();
        last.reverse();
        prop_assert_eq!(last.as_slice(), curve.points());
    }
}

#[test]
fn a_moved_point_breaks_the_joint_at_its_own_order() {
    let q = |x: i64, y: i64| [integer(x), integer(y)];
    let left = Curve::new(Bernstein, vec![q(0, 0), q(1, 2), q(3, 3), q(5, 1)]).unwrap();
    let c3 = Continuity::parametric(3, &integer(0));
    let right = join::next_curve(&left, Bernstein, &c3, &[q(9, 9)]).unwrap();
    assert_eq!(
        join::measure_curves(&left, &right, 4)
            .unwrap()
            .parametric_order(),
        Some(3)
    );
    for moved in 0..4 {
        let mut points = right.points().to_vec();
        points[moved] = [
            points[moved][0].clone() + integer(1),
            points[moved][1].clone(),
        ];
        let changed = Curve::new(Bernstein, points).unwrap();
        let measure = join::measure_curves(&left, &changed, 3).unwrap();
        assert_eq!(
            measure.geometric_order(),
            moved.checked_sub(1),
            "point {moved}"
        );
    }
}

#[test]
fn a_piece_that_turns_back_has_contact_of_order_zero_only() {
    let q = |x: i64, y: i64| [integer(x), integer(y)];
    let left = Curve::new(Bernstein, vec![q(0, 0), q(1, 2), q(3, 3)]).unwrap();
    let back = measured(&left, &left.reversed());
    assert_eq!(
        (back.geometric_order(), back.betas[0].clone()),
        (Some(0), integer(-1))
    );
    let float = |x: &Rational| torse_algebra::rational::to_f64(x);
    let left = left.over(&float).unwrap();
    assert_eq!(
        measured(&left, &left.reversed()).order_within(1e-12),
        Some(0)
    );
}

fn measured<S: torse_geometry::Coordinate>(
    left: &Curve<Bernstein, S, 2>,
    right: &Curve<Bernstein, S, 2>,
) -> join::JointMeasure<S, 2> {
    join::measure_curves(left, right, 2).unwrap()
}
