//! Developables between two curves: the known ones are found, and none is missed.

use proptest::prelude::*;
use torse_geometry::developable::{BranchEnd, BranchReason, NODE_RADIUS, certify, connect};
use torse_geometry::pattern::unroll;
use torse_geometry::vector::{cross, det, dot, norm, sub};
use torse_geometry::{Bernstein, Curve, Gbt, GeometryError, Over, Rails, SpaceCurve, exact_ball};

type Rail = Curve<Bernstein, f64, 3>;

fn rail(points: &[[f64; 3]]) -> Rail {
    Curve::new(Bernstein, points.to_vec()).unwrap()
}

/// `F(s, t)`, its partial derivatives, and the size of what they are differences of.
fn equation(one: &Rail, two: &Rail, s: f64, t: f64) -> [f64; 4] {
    let (p, q) = (
        one.derivatives(&s, 2).unwrap(),
        two.derivatives(&t, 2).unwrap(),
    );
    let r = sub(&q[0], &p[0]);
    let size = |c: &[[f64; 3]]| norm(&c[1]) + norm(&c[2]);
    [
        det(&p[1], &q[1], &r),
        det(&p[2], &q[1], &r),
        det(&p[1], &q[2], &r),
        size(&p) * size(&q) * norm(&r),
    ]
}

#[test]
fn a_curve_and_its_translate_are_joined_by_a_cylinder() {
    let lower = rail(&[[0., 0., 0.], [1., 2., 0.], [3., 2., 1.], [5., 0., 0.]]);
    let upper = lower.mapped(|p| [p[0] + 0.3, p[1] - 0.2, p[2] + 2.0]);
    let found = connect(&lower, &upper).unwrap();
    let patch = found.chosen().unwrap();
    assert_eq!(patch.branch().ends(), [BranchEnd::Border; 2]);
    assert!((patch.branch().coverage() - 1.0).abs() < 1e-9 && found.gaps().is_empty());
    for x in [0.0, 0.2, 0.77, 1.0] {
        let [p, q] = patch.ruling_ends(&x).unwrap();
        let r = sub(&q, &p);
        assert!(norm(&sub(&r, &[0.3, -0.2, 2.0])) < 1e-9, "{r:?}");
    }
    let certificate = certify(&patch, 32).unwrap();
    assert!(certificate.is_regular());
}

/// The twisted cubic's tangents `S + a S'`, and `S(f) + b S'(f)` at `f = (t + t^2)/2`.
fn torse() -> (Rail, Curve<Bernstein, f64, 3>) {
    // Power form to Bernstein form of degree 6, by interpolation at 7 points.
    let fitted = |f: &dyn Fn(f64) -> [f64; 3], degree: usize| {
        use nalgebra::{DMatrix, DVector};
        let at = |i: usize| i as f64 / degree as f64;
        let row = |x: f64| torse_geometry::Basis::row(&Bernstein, degree, &x).unwrap();
        let matrix = DMatrix::from_fn(degree + 1, degree + 1, |i, j| row(at(i))[j]);
        let lu = matrix.lu();
        let axis = |k: usize| {
            lu.solve(&DVector::from_fn(degree + 1, |i, _| f(at(i))[k]))
                .unwrap()
        };
        let axes = [axis(0), axis(1), axis(2)];
        let points = (0..=degree)
            .map(|i| [axes[0][i], axes[1][i], axes[2][i]])
            .collect();
        Curve::new(Bernstein, points).unwrap()
    };
    let tangent = |x: f64, b: f64| [x + b, x * x + 2.0 * b * x, x.powi(3) + 3.0 * b * x * x];
    let first = fitted(&|s| tangent(s, 0.5), 3);
    let second = fitted(&|t| tangent(0.5 * (t + t * t), 1.5), 6);
    (first, second)
}

#[test]
fn the_rulings_of_a_torse_are_found_from_two_curves_on_it() {
    let (first, second) = torse();
    let found = connect(&first, &second).unwrap();
    let patch = found.chosen().unwrap();
    assert!((patch.branch().coverage() - 1.0).abs() < 1e-7);
    for [s, t] in patch.branch().nodes() {
        assert!((s - 0.5 * (t + t * t)).abs() < 1e-9, "{s} {t}");
    }
    let certificate = certify(&patch, 32).unwrap();
    assert!(certificate.is_regular(), "{certificate:?}");
    // Half a tangent from the edge; |S'| is least at the start, where it is one.
    assert!(
        (certificate.clearance.unwrap().value - 0.5).abs() < 1e-9,
        "{certificate:?}"
    );
    assert_eq!(unroll(&patch, 32, 1e-6).unwrap().strain(), 0.0);
}

#[test]
fn series_of_a_connecting_patch_are_its_derivatives_and_lie_in_its_enclosures() {
    let (first, second) = torse();
    let patch = connect(&first, &second).unwrap().chosen().unwrap();
    let (x, h) = (0.4, 1e-4);
    let jets = patch.rail_jets(&x, 3).unwrap();
    let at = |x: f64| patch.ruling_ends(&x).unwrap();
    let (before, here, after) = (at(x - h), at(x), at(x + h));
    let balls = patch.over(&|x| exact_ball(*x, 128)).unwrap();
    let enclosed = balls.rail_jets(&exact_ball(x, 128), 3).unwrap();
    let wide = torse_algebra::Ball::from_bounds(
        &torse_geometry::exact(x - h),
        &torse_geometry::exact(x + h),
        128,
    );
    let over = balls.rail_jets(&wide, 3).unwrap();
    for i in [0, 1] {
        for k in 0..3 {
            let slope = (after[i][k] - before[i][k]) / (2.0 * h);
            let bend = (after[i][k] - 2.0 * here[i][k] + before[i][k]) / (h * h);
            let c = jets[i][k].coefficients();
            assert!((c[1] - slope).abs() < 1e-6 && (2.0 * c[2] - bend).abs() < 1e-5);
            let series = c
                .iter()
                .zip(enclosed[i][k].coefficients())
                .zip(over[i][k].coefficients());
            for ((number, ball), wide) in series {
                let (low, high) = ball.to_f64_bounds();
                assert!(high - low < 1e-15 * (1.0 + high.abs()), "{low} {high}");
                assert!(
                    (number - low).abs() < 1e-9 * (1.0 + low.abs()),
                    "{number} {low}"
                );
                assert!(wide.overlaps(ball));
            }
            let (low, high) = over[i][k].value().to_f64_bounds();
            for end in [before[i][k], here[i][k], after[i][k]] {
                assert!(low - 1e-14 <= end && end <= high + 1e-14 && high - low < 0.01);
            }
        }
    }
}

#[test]
fn skew_lines_have_no_developable_and_the_best_ruling_is_told() {
    // A saddle: through each point of the one line all rulings turn their tangent plane.
    let (one, two) = (
        rail(&[[0.; 3], [1., 0., 0.]]),
        rail(&[[0., 1., 0.], [1., 1., 1.]]),
    );
    let found = connect(&one, &two).unwrap();
    assert!(found.branches().is_empty() && found.chosen().is_none() && found.choice().is_none());
    assert_eq!(found.gaps().len(), 2);
    for gap in found.gaps() {
        assert_eq!(gap.range, [0.0, 1.0]);
        let (s, t) = (gap.worst.s, gap.worst.t);
        let r = [t - s, 1.0, t];
        let (n0, n1) = (cross(&[1., 0., 0.], &r), cross(&[1., 0., 1.], &r));
        let twist = libm::acos((dot(&n0, &n1) / norm(&n0) / norm(&n1)).abs());
        assert!((gap.worst.twist - twist).abs() < 1e-7 && twist > 0.5);
    }
}

#[test]
fn coplanar_curves_are_refused_by_name() {
    let (one, two) = (
        rail(&[[0., 0., 1.], [1., 1., 1.], [2., 0., 1.]]),
        rail(&[[0., 3., 1.], [1., 4., 1.], [2., 3., 1.]]),
    );
    assert!(matches!(
        connect(&one, &two),
        Err(GeometryError::Degenerate { .. })
    ));
    let point = rail(&[[1.; 3], [1.; 3]]);
    assert!(matches!(
        connect(&one, &point),
        Err(GeometryError::Degenerate { .. })
    ));
}

#[test]
fn closed_ends_leave_two_branches_between_two_arches() {
    // Each inflection of an S separates branches: none is lost.
    let wave = |z: f64| rail(&[[0., 0., z], [1., 2., z], [2., -2., z], [3., 0., z]]);
    let found = connect(&wave(0.0), &wave(1.0)).unwrap();
    assert!(found.branches().len() >= 2, "{:?}", found.branches().len());
    let covered: f64 = found
        .branches()
        .iter()
        .map(|branch| branch.coverage())
        .sum();
    assert!(covered > 0.9, "{covered}");
    assert!(matches!(
        found.choice(),
        Some((
            _,
            BranchReason::CoversMost(..)
                | BranchReason::ShorterRulings(..)
                | BranchReason::OnlyRegular
        ))
    ));
}

#[test]
fn curves_of_different_bases_and_sizes_connect() {
    for k in [1e-6, 1.0, 1e6] {
        let points = |z: f64, lift: f64| {
            vec![[0., 0., z], [2., 3., z + lift], [4., 2., z], [6., 0., z]]
                .into_iter()
                .map(|p: [f64; 3]| p.map(|c| c * k))
                .collect::<Vec<_>>()
        };
        let lower = Curve::new(Gbt::new(0.5, 0.25).unwrap(), points(0.0, 0.5)).unwrap();
        let upper = Curve::new(Gbt::new(0.0, -0.5).unwrap(), points(3.0, -0.2)).unwrap();
        let found = connect(&lower, &upper).unwrap();
        let patch = found.chosen().unwrap();
        assert!(patch.branch().coverage() > 0.8, "{k:e}");
        assert!(certify(&patch, 32).unwrap().is_regular());
    }
}

/// Solutions that rise beyond doubt of rounding, on 39 antidiagonals of the square: by signs of a fine sampling
/// and bisection between them, which is another way to find them.
fn rising_solutions(one: &Rail, two: &Rail) -> Vec<[f64; 2]> {
    let mut found = Vec::new();
    for i in 1..40 {
        let u = 0.05 * f64::from(i);
        let reach = u.min(2.0 - u);
        let at = |k: f64| {
            let w = reach * (k / 200.0 - 1.0);
            [0.5 * (u - w), 0.5 * (u + w)]
        };
        let value = |k: f64| {
            let [s, t] = at(k);
            equation(one, two, s, t)
        };
        for k in 0..400 {
            let (mut a, mut b) = (f64::from(k), f64::from(k + 1));
            let negative = value(a)[0] < 0.0;
            if (value(b)[0] < 0.0) == negative {
                continue;
            }
            for _ in 0..60 {
                let middle = 0.5 * (a + b);
                let same = (value(middle)[0] < 0.0) == negative;
                (a, b) = if same { (middle, b) } else { (a, middle) };
            }
            let [_, by_s, by_t, size] = value(a);
            if by_s * by_t < 0.0 && by_s.abs().min(by_t.abs()) > 1e-9 * size {
                found.push(at(a));
            }
        }
    }
    found
}

/// Every rising solution is on a branch, which is where its links say, or in a cell that is called undecided.
fn assert_none_is_missed(p: &[[f64; 3]], q: &[[f64; 3]]) -> usize {
    let (one, two) = (rail(p), rail(q));
    let found = connect(&one, &two).unwrap();
    let solutions = rising_solutions(&one, &two);
    for solution in &solutions {
        let within = |a: [f64; 2], b: [f64; 2], by: f64| {
            (0..2).all(|i| a[i].min(b[i]) - by <= solution[i] && solution[i] <= a[i].max(b[i]) + by)
        };
        let known = found.branches().iter().any(|branch| {
            let mut links = branch.nodes().windows(2);
            links.any(|link| within(link[0], link[1], 2.0 * NODE_RADIUS))
        });
        let mut cells = found.undecided().iter();
        let open = cells.any(|c| within([c.s[0], c.t[0]], [c.s[1], c.t[1]], 1e-12));
        assert!(known || open, "{solution:?} {:?}", found.branches());
    }
    solutions.len()
}

#[test]
fn a_branch_that_falls_as_slowly_as_can_be_is_none() {
    // Between s = 0.61 and 1 the solutions fall in t from 0.83 to 0.4457, the last third of them by 1e-4; at a
    // distance of 1e-3 from them the derivatives have the signs of a rising branch.
    let p = [
        [0.0, -1.0587966379300993, -1.5727852006793375],
        [-1.1370479528880417, -1.3566742305839086, -1.46630754003673],
        [1.6329577039878196, -1.630410886055638, -1.8318763362454922],
        [
            -1.5645469253472801,
            -1.3364652008348944,
            -1.5250285878738383,
        ],
    ];
    let q = [
        [-1.2052327045813014, 1.0871294811633188, 2.764329815441339],
        [-1.6551091578164057, -1.0346496844427633, 2.6780795534629925],
        [0.7392315580633276, 1.2117817145212253, 1.9673106781361436],
    ];
    assert!(assert_none_is_missed(&p, &q) > 20);
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 6, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn no_rising_solution_lies_off_the_branches(
        p in prop::collection::vec(prop::array::uniform3(-2.0..2.0_f64), 3..5),
        q in prop::collection::vec(prop::array::uniform3(-2.0..2.0_f64), 3..5),
    ) {
        let q: Vec<[f64; 3]> = q.into_iter().map(|[x, y, z]| [x, y, z + 3.0]).collect();
        let (one, two) = (rail(&p), rail(&q));
        let Ok(found) = connect(&one, &two) else { return Ok(()) };
        assert_none_is_missed(&p, &q);
        for (index, branch) in found.branches().iter().enumerate() {
            for pair in branch.nodes().windows(2) {
                prop_assert!(pair[0][0] < pair[1][0] + 1e-12 && pair[0][1] < pair[1][1] + 1e-12);
            }
            let patch = found.patch(index).unwrap();
            for x in [0.0, 0.3, 0.5, 1.0] {
                let [p, q] = patch.rail_jets(&x, 1).unwrap();
                let part = |jets: &[torse_algebra::Jet<f64>; 3], n: usize| jets.each_ref().map(|j| j.coefficients()[n]);
                let (dp, dq, r) = (part(&p, 1), part(&q, 1), sub(&part(&q, 0), &part(&p, 0)));
                let size = norm(&dp) * norm(&dq) * norm(&r);
                prop_assert!(det(&dp, &dq, &r).abs() <= 1e-9 * size, "{}", det(&dp, &dq, &r) / size);
            }
        }
        prop_assert!(one.space_jet(&0.5, 0).is_ok());
    }
}
