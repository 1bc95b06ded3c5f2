//! Singular patches are never called regular, and every answer is a number or an error.

use crate::support::{Rail, osculating_planes, rail, unroll};
use proptest::prelude::*;
use proptest::strategy::ValueTree;
use proptest::test_runner::{Config, RngAlgorithm, TestRng, TestRunner};
use torse_algebra::Ball;
use torse_algebra::rational::{Rational, integer};
use torse_geometry::developable::{
    EnclosedCertificate, PatchCertificate, Regularity, Singularity, certify, enclose, prove_regular,
};
use torse_geometry::{
    Bernstein, Continuity, Curve, EnvelopingPatch, Gbt, GeometryError, Over, PatchBounds,
    PlaneFamily, Rails, RuledSurface, TangentPatch, exact, exact_ball, join,
};

fn enclosed(patch: &RuledSurface<Rail, Rail>, cells: usize) -> EnclosedCertificate {
    enclose(
        &patch.over(&|x| exact_ball(*x, 128)).unwrap(),
        128,
        0.1,
        cells,
    )
}

fn proved(patch: &RuledSurface<Rail, Rail>, budget: usize) -> Regularity {
    prove_regular(&patch.over(&|x| exact_ball(*x, 128)).unwrap(), 128, budget)
}

fn all_finite(c: &PatchCertificate) -> bool {
    let worst = [
        Some(c.determinant),
        Some(c.twist),
        c.gaussian,
        c.clearance,
        Some(c.normal),
    ];
    let finite = |x: f64| x.is_finite();
    worst
        .into_iter()
        .flatten()
        .all(|w| finite(w.value) && finite(w.x) && finite(w.v))
}

fn no_empty_interval(e: &EnclosedCertificate) -> bool {
    [
        e.determinant,
        e.twist,
        e.gaussian,
        e.clearance,
        e.normal,
        e.side,
    ]
    .iter()
    .all(|worst| worst.low <= worst.high)
}

#[test]
fn a_cusp_is_not_regular() {
    // The tangent vanishes at x = 1/2, between two of the 64 rulings.
    let cusp = |z: f64| {
        rail(&[
            [1., -1., z],
            [-1. / 3., 1., z],
            [-1. / 3., -1., z],
            [1., 1., z],
        ])
    };
    let patch = RuledSurface::new(cusp(0.0), cusp(1.0));
    for rulings in [8, 9, 64, 65, 1000] {
        let certificate = certify(&patch, rulings).unwrap();
        assert!(
            !certificate.is_regular() && all_finite(&certificate),
            "{certificate:?}"
        );
    }
    assert_ne!(enclosed(&patch, 64).is_regular(), Some(true));
    assert_ne!(proved(&patch, 1024), Regularity::Regular);
}

#[test]
fn a_rail_that_comes_to_rest_without_turning_back_is_not_regular() {
    // (x - 1/3)^3 has a tangent of zero at 1/3 that does not change its sign.
    let rest = |z: f64| rail(&[-1.0, 2.0, -4.0, 8.0].map(|c| [c / 27.0, c / 27.0 * 2.0, z]));
    let certificate = certify(&RuledSurface::new(rest(0.0), rest(1.0)), 65).unwrap();
    assert!(!certificate.is_regular(), "{certificate:?}");
}

#[test]
fn a_patch_through_infinity_is_not_regular() {
    // gbt-developable Example 5.1: a x a' changes its sign at x = 0.857.
    let planes = vec![
        [0., -20., 10., 400.],
        [0., -10., 20., 400.],
        [0., 10., 20., 400.],
        [0., 20., 10., 400.],
    ];
    let left = PlaneFamily::new(Gbt::new(0.5, 0.25).unwrap(), planes).unwrap();
    let right = join::next_family(
        &left,
        Gbt::new(-0.5, 0.75).unwrap(),
        &Continuity::parametric(2, &0.0),
        &[[0., 40., -40., 400.]],
    )
    .unwrap();
    let cut = PatchBounds::Planes([[1., 0., 0., 0.], [1., 0., 0., 10.]]);
    let patch = EnvelopingPatch::new(right, cut).unwrap();
    for rulings in [8, 64, 4096] {
        match certify(&patch, rulings) {
            Ok(certificate) => {
                assert!(!certificate.is_regular(), "{certificate:?}");
                assert!(all_finite(&certificate), "{certificate:?}");
            }
            Err(error) => assert!(matches!(error, GeometryError::NoRuling { .. }), "{error}"),
        }
    }
}

#[test]
fn a_patch_without_width_or_length_is_refused() {
    let line = rail(&[[0.0; 3], [1.0, 2.0, 3.0]]);
    let point = rail(&[[4.0; 3], [4.0; 3]]);
    for patch in [
        RuledSurface::new(line.clone(), line),
        RuledSurface::new(point.clone(), rail(&[[0.0; 3], [0.0; 3]])),
    ] {
        assert!(matches!(
            certify(&patch, 8),
            Err(GeometryError::Degenerate { .. })
        ));
    }
}

#[test]
fn an_apex_as_a_rail_has_a_vanishing_normal_and_no_empty_interval() {
    let apex = rail(&[[0.0; 3]; 3]);
    let arc = rail(&[[1., 0., 1.], [1., 1., 1.2], [0., 1., 1.]]);
    let patch = RuledSurface::new(apex, arc);
    let proof = enclosed(&patch, 16);
    assert!(no_empty_interval(&proof), "{proof:?}");
    assert_eq!(proof.is_regular(), Some(false));
    assert!(matches!(proved(&patch, 16), Regularity::Singular { .. }));
    let certificate = certify(&patch, 16).unwrap();
    assert!(
        matches!(certificate.singularity(), Some(Singularity::NormalVanishes(w)) if w.v == 0.0)
    );
}

#[test]
fn an_edge_on_the_border_and_next_to_it() {
    let family = osculating_planes();
    let at = |from: f64| {
        let patch = TangentPatch::new(family.clone(), [from, 1.0]).unwrap();
        let balls = patch.over(&|x| exact_ball(*x, 128)).unwrap();
        (
            certify(&patch, 33).unwrap(),
            enclose(&balls, 128, 0.1, 64),
            prove_regular(&balls, 128, 64),
        )
    };
    let (sampled, proof, decision) = at(0.0);
    assert!(!sampled.is_regular(), "{sampled:?}");
    assert!(
        no_empty_interval(&proof) && proof.is_regular() != Some(true),
        "{proof:?}"
    );
    assert_ne!(decision, Regularity::Regular);
    let (sampled, _, _) = at(1e-9);
    assert!(sampled.is_regular(), "{sampled:?}");
    let (sampled, proof, decision) = at(-1e-9);
    assert!(!sampled.is_regular());
    assert_eq!(proof.is_regular(), Some(false));
    assert!(matches!(decision, Regularity::Singular { .. }));
}

#[test]
fn a_nearly_planar_saddle_is_regular_in_every_way() {
    for lift in [1e-3, 1e-6, 1e-12] {
        let patch = RuledSurface::new(
            rail(&[[0.0; 3], [1.0, 0.0, 0.0]]),
            rail(&[[0.0, 1.0, 0.0], [1.0, 1.0, lift]]),
        );
        let certificate = certify(&patch, 32).unwrap();
        assert!(certificate.is_regular(), "{certificate:?}");
        assert!((certificate.twist.value / lift - 1.0).abs() < 1e-3);
        assert_eq!(enclosed(&patch, 16).is_regular(), Some(true));
        assert_eq!(proved(&patch, 16), Regularity::Regular);
    }
}

#[test]
fn a_common_factor_of_the_planes_changes_nothing() {
    let planes = [
        [7., -7., 5., 125.],
        [-7., -7., 5., 120.],
        [-7., 7., 5., 130.],
        [7., 7., 5., 125.],
    ];
    let cut = |k: f64| PatchBounds::Planes([[0., 0., k, 0.], [0., 0., k, 3. * k]]);
    let patch = |k: f64| {
        let scaled = planes.map(|plane| plane.map(|c| c * k)).to_vec();
        let family = PlaneFamily::new(Gbt::new(0.5, 0.25).unwrap(), scaled).unwrap();
        EnvelopingPatch::new(family, cut(k)).unwrap()
    };
    let one = certify(&patch(1.0), 16).unwrap();
    assert!(one.is_regular());
    for k in [1e-300, 1e-150, 1e-100, 1e-80, 1e80, 1e100, 1e200, 1e300] {
        let scaled = patch(k);
        let certificate = certify(&scaled, 16).unwrap();
        assert!(certificate.is_regular(), "{k:e}: {certificate:?}");
        let near = |a: f64, b: f64| (a - b).abs() <= 1e-9 * b.abs();
        let (a, b) = (certificate.clearance.unwrap(), one.clearance.unwrap());
        assert!(near(a.value, b.value), "{k:e}: {a:?} {b:?}");
        for x in [0.0, 0.3, 1.0] {
            let (here, there) = (
                scaled.ruling_ends(&x).unwrap(),
                patch(1.0).ruling_ends(&x).unwrap(),
            );
            for (p, q) in here.iter().flatten().zip(there.iter().flatten()) {
                assert!((p - q).abs() < 1e-9, "{k:e}: {here:?} {there:?}");
            }
            let spine = scaled.family().characteristic_point(&x).unwrap();
            let other = patch(1.0).family().characteristic_point(&x).unwrap();
            assert!((0..3).all(|i| (spine[i] - other[i]).abs() < 1e-7 * (1.0 + other[i].abs())));
            // The direction a x a' itself may leave the range: then that is said.
            match scaled.family().ruling(&x) {
                Ok(ruling) => assert!(ruling.direction.iter().all(|c| c.is_finite())),
                Err(error) => assert!(matches!(error, GeometryError::NoValue { .. }) && k > 1e100),
            }
        }
        // Exact balls of the scaled planes see the same surface.
        if [1e-300, 1e300].contains(&k) {
            let balls = scaled.over(&|x| exact_ball(*x, 160)).unwrap();
            let proof = enclose(&balls, 160, 0.5, 64);
            assert_eq!(proof.is_regular(), Some(true), "{k:e} {proof:?}");
        }
    }
}

#[test]
fn parts_of_any_size_have_the_same_shape() {
    let arc = |r: f64, z: f64| rail(&[[r, 0.0, z], [r, r, z], [0.0, r, z]]);
    let cone = |k: f64| RuledSurface::new(arc(3.0 * k, 0.0), arc(k, 4.0 * k));
    let one = certify(&cone(1.0), 16).unwrap();
    for k in [1e-140, 1e-100, 1e-20, 1e20, 1e100, 1e140] {
        let certificate = certify(&cone(k), 16).unwrap();
        assert!(
            certificate.is_regular() && all_finite(&certificate),
            "{k:e} {certificate:?}"
        );
        assert!(
            (certificate.clearance.unwrap().value / k / one.clearance.unwrap().value - 1.0).abs()
                < 1e-9
        );
        assert!(certificate.twist.value < 1e-7);
    }
    // Beyond, squares of the numbers leave the range of f64: an error or finite numbers.
    for k in [1e-300, 1e-200, 1e200, 1e300] {
        if let Ok(certificate) = certify(&cone(k), 16) {
            assert!(all_finite(&certificate), "{k:e} {certificate:?}");
        }
    }
}

#[test]
fn patches_of_different_kinds_go_through_one_list() {
    let family = osculating_planes();
    let arc = |r: f64, z: f64| rail(&[[r, 0.0, z], [r, r, z], [0.0, r, z]]);
    let sheets: Vec<Box<dyn Rails<f64>>> = vec![
        Box::new(TangentPatch::new(family, [0.5, 1.0]).unwrap()),
        Box::new(RuledSurface::new(arc(2.0, 0.0), arc(1.0, 1.0))),
    ];
    for sheet in &sheets {
        assert!(certify(sheet.as_ref(), 16).unwrap().is_regular());
        assert!(unroll(sheet.as_ref(), 16, 1e-6).is_ok());
    }
}

/// The polynomial `N0 . N1` of two polynomial rails, multiplied out here from the control points: exact and
/// independent of the library.
mod judge {
    use super::*;

    type Polynomial = Vec<Rational>;

    fn times(a: &Polynomial, b: &Polynomial) -> Polynomial {
        let mut product = vec![integer(0); a.len() + b.len() - 1];
        for (i, x) in a.iter().enumerate() {
            for (j, y) in b.iter().enumerate() {
                product[i + j] = &product[i + j] + x * y;
            }
        }
        product
    }

    fn minus(a: &Polynomial, b: &Polynomial) -> Polynomial {
        let at = |p: &Polynomial, i: usize| p.get(i).cloned().unwrap_or(integer(0));
        (0..a.len().max(b.len()))
            .map(|i| at(a, i) - at(b, i))
            .collect()
    }

    fn slope(p: &Polynomial) -> Polynomial {
        let mut d: Polynomial = p
            .iter()
            .enumerate()
            .skip(1)
            .map(|(i, c)| c * integer(i64::try_from(i).unwrap()))
            .collect();
        d.push(integer(0));
        d
    }

    /// By de Casteljau's scheme on polynomials.
    fn coordinate(rail: &Rail, axis: usize) -> Polynomial {
        let mut row: Vec<Polynomial> = rail.points().iter().map(|p| vec![exact(p[axis])]).collect();
        let (rest, x) = (vec![integer(1), integer(-1)], vec![integer(0), integer(1)]);
        while row.len() > 1 {
            let negative: Polynomial = x.iter().map(|c| -c.clone()).collect();
            row = row
                .windows(2)
                .map(|w| minus(&times(&rest, &w[0]), &times(&negative, &w[1])))
                .collect();
        }
        row.remove(0)
    }

    fn cross(a: &[Polynomial; 3], b: &[Polynomial; 3]) -> [Polynomial; 3] {
        [(1, 2), (2, 0), (0, 1)].map(|(i, j)| minus(&times(&a[i], &b[j]), &times(&a[j], &b[i])))
    }

    pub fn side(patch: &RuledSurface<Rail, Rail>) -> Polynomial {
        let p = [0, 1, 2].map(|axis| coordinate(patch.first(), axis));
        let q = [0, 1, 2].map(|axis| coordinate(patch.second(), axis));
        let r = [0, 1, 2].map(|i| minus(&q[i], &p[i]));
        let (n, m) = (
            cross(&p.each_ref().map(slope), &r),
            cross(&q.each_ref().map(slope), &r),
        );
        let none = vec![integer(0)];
        (0..3).fold(none, |sum, i| {
            let negative: Polynomial = times(&n[i], &m[i]).iter().map(|c| -c.clone()).collect();
            minus(&sum, &negative)
        })
    }

    /// Whether `N0 . N1 > 0` on the whole of [0, 1], by Sturm's theorem.
    pub fn is_regular(patch: &RuledSurface<Rail, Rail>) -> bool {
        let side = side(patch);
        !has_root(&side) && side[0] > integer(0)
    }

    /// Whether a polynomial has a root in [0, 1], by Sturm's theorem: where neither end is one, the number of distinct roots
    /// between them is the number of sign changes that its sequence loses.
    fn has_root(p: &Polynomial) -> bool {
        let p = trimmed(p.clone());
        let value = |p: &Polynomial, at_one: bool| match at_one {
            true => p.iter().fold(integer(0), |sum, c| sum + c),
            false => p.first().cloned().unwrap_or(integer(0)),
        };
        if [false, true].iter().any(|at| value(&p, *at) == integer(0)) {
            return true;
        }
        let mut sequence = vec![p.clone(), trimmed(slope(&p))];
        while let [.., before, last] = sequence.as_slice()
            && !last.is_empty()
        {
            let rest = negated_remainder(before, last);
            sequence.push(rest);
        }
        let changes = |at_one: bool| {
            let values = sequence.iter().map(|member| value(member, at_one));
            let signs: Vec<bool> = values
                .filter(|value| *value != integer(0))
                .map(|value| value > integer(0))
                .collect();
            signs.windows(2).filter(|pair| pair[0] != pair[1]).count()
        };
        changes(false) != changes(true)
    }

    fn trimmed(mut p: Polynomial) -> Polynomial {
        while p.last().is_some_and(|c| *c == integer(0)) {
            p.pop();
        }
        p
    }

    /// `-(a mod b)`.
    fn negated_remainder(a: &Polynomial, b: &Polynomial) -> Polynomial {
        let mut rest = trimmed(a.clone());
        while rest.len() >= b.len() {
            let factor = rest.last().unwrap() / b.last().unwrap();
            let shift = rest.len() - b.len();
            for (i, c) in b.iter().enumerate() {
                rest[shift + i] = &rest[shift + i] - &factor * c;
            }
            rest.pop();
            rest = trimmed(rest);
        }
        rest.into_iter().map(|c| -c).collect()
    }
}

/// Random patches of every kind: free ones, cones, cylinders, and with cusps.
fn patches() -> impl Strategy<Value = RuledSurface<Rail, Rail>> {
    let grid = (-16..=16_i32).prop_map(|n| f64::from(n) / 4.0);
    let points = move |n| prop::collection::vec(prop::array::uniform3(grid.clone()), n);
    let kind = 0..6_i32;
    (
        points(2..5),
        points(2..5),
        prop::array::uniform3(-4.0..4.0_f64),
        kind,
    )
        .prop_map(|(p, mut q, apex, kind)| {
            let shifted = |p: &[f64; 3], by: &[f64; 3]| [p[0] + by[0], p[1] + by[1], p[2] + by[2]];
            match kind {
                // A cylinder and a cone, developable up to rounding.
                0 => q = p.iter().map(|p| shifted(p, &apex)).collect(),
                1 => {
                    q = p
                        .iter()
                        .map(|p| [0, 1, 2].map(|i| apex[i] + 0.5 * (p[i] - apex[i])))
                        .collect()
                }
                // Two rails far apart, so that many are regular.
                2 | 3 => {
                    q.truncate(p.len());
                    q = p
                        .iter()
                        .map(|p| shifted(p, &[0.0, 0.0, 20.0]))
                        .zip(q)
                        .map(|(p, q)| [0, 1, 2].map(|i| p[i] + 0.1 * q[i]))
                        .collect();
                }
                // A cusp in the middle, or a start that stands still.
                4 => {
                    let cusp = |z: f64| {
                        rail(&[
                            [1., -1., z],
                            [-1. / 3., 1., z],
                            [-1. / 3., -1., z],
                            [1., 1., z],
                        ])
                    };
                    return RuledSurface::new(cusp(apex[0]), cusp(apex[1] + 9.0));
                }
                _ => {
                    let first = p[0];
                    return RuledSurface::new(
                        Curve::new(Bernstein, [vec![first], p].concat()).unwrap(),
                        Curve::new(Bernstein, q).unwrap(),
                    );
                }
            }
            let end = |mut list: Vec<[f64; 3]>| {
                if list.len() < 2 {
                    list.push([5.0, 6.0, 7.0]);
                }
                Curve::new(Bernstein, list).unwrap()
            };
            RuledSurface::new(end(p), end(q))
        })
}

fn runner(cases: u32) -> TestRunner {
    let config = Config {
        cases,
        failure_persistence: None,
        ..Config::default()
    };
    TestRunner::new_with_rng(config, TestRng::deterministic_rng(RngAlgorithm::ChaCha))
}

#[test]
fn five_hundred_random_patches_are_judged_as_by_the_theorem_of_sturm() {
    let mut runner = runner(500);
    let strategy = patches();
    let mut counts = [0; 2];
    for n in 0..500 {
        let patch = strategy.new_tree(&mut runner).unwrap().current();
        let truth = judge::is_regular(&patch);
        counts[usize::from(truth)] += 1;
        match certify(&patch, 24) {
            Ok(certificate) => {
                assert!(all_finite(&certificate), "{n}: {certificate:?}");
                assert!(
                    truth || !certificate.is_regular(),
                    "{n}: {certificate:?} {patch:?}"
                );
                assert!(
                    !truth || certificate.is_regular(),
                    "{n}: {certificate:?} {patch:?}"
                );
            }
            Err(error) => assert!(!truth, "{n}: {error} {patch:?}"),
        }
        // Balls are slow: a part of them.
        if n % 5 == 0 {
            let proof = enclosed(&patch, 12);
            assert!(no_empty_interval(&proof), "{n}: {proof:?}");
            assert!(
                proof.is_regular().is_none_or(|regular| regular == truth),
                "{n}: {proof:?} {patch:?}"
            );
            match proved(&patch, 64) {
                Regularity::Regular => assert!(truth, "{n}: {patch:?}"),
                Regularity::Singular { .. } => assert!(!truth, "{n}: {patch:?}"),
                Regularity::Undecided { .. } => {}
            }
        }
    }
    assert!(counts[0] > 100 && counts[1] > 100, "{counts:?}");
}

#[test]
fn hostile_patches_give_errors_or_finite_numbers() {
    let wild = || {
        prop_oneof![
            prop::num::f64::NORMAL | prop::num::f64::SUBNORMAL | prop::num::f64::ZERO,
            Just(0.0),
            Just(f64::MAX),
            Just(-f64::MAX),
            Just(f64::MIN_POSITIVE),
            Just(5e-324),
            -1.0..1.0_f64,
            -1e-160..1e-160_f64,
            -1e160..1e160_f64,
        ]
    };
    let mut runner = runner(100);
    let rails = prop::array::uniform2(prop::collection::vec(prop::array::uniform3(wild()), 2..5));
    let planes = prop::collection::vec(prop::array::uniform4(wild()), 3..6);
    let mut answered = 0;
    for _ in 0..100 {
        let [p, q] = rails.new_tree(&mut runner).unwrap().current();
        let patch = RuledSurface::new(rail(&p), rail(&q));
        if let Ok(certificate) = certify(&patch, 8) {
            answered += 1;
            assert!(all_finite(&certificate), "{certificate:?} {patch:?}");
            assert!(
                !certificate.is_regular() || judge::is_regular(&patch),
                "{certificate:?} {patch:?}"
            );
        }
        let proof = enclosed(&patch, 4);
        assert!(no_empty_interval(&proof), "{proof:?} {patch:?}");
        let planes = planes.new_tree(&mut runner).unwrap().current();
        let cut = planes
            .iter()
            .take(2)
            .map(|p| [p[1], p[2], p[0], p[3]])
            .collect::<Vec<_>>();
        let Ok(family) = PlaneFamily::new(Bernstein, planes) else {
            continue;
        };
        for bounds in [
            PatchBounds::Range([0.0, 1.0]),
            PatchBounds::Planes([cut[0], cut[1]]),
        ] {
            let Ok(patch) = EnvelopingPatch::new(family.clone(), bounds) else {
                continue;
            };
            if let Ok(certificate) = certify(&patch, 8) {
                answered += 1;
                assert!(all_finite(&certificate), "{certificate:?} {patch:?}");
            }
            let balls = patch.over(&|x: &f64| -> Ball { exact_ball(*x, 64) });
            if let Ok(balls) = balls {
                let proof = enclose(&balls, 64, 0.5, 2);
                assert!(no_empty_interval(&proof), "{proof:?} {patch:?}");
            }
        }
    }
    assert!(answered > 5, "{answered}");
}
