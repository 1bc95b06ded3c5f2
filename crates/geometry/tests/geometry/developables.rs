//! Developables: exactly developable, tangent to their planes, and unrolled isometrically.

use crate::support::{osculating_planes, saddle};
use nalgebra::{DMatrix, DVector};
use proptest::prelude::*;
use torse_algebra::rational::{integer, ratio};
use torse_algebra::{Fraction, Jet, Rational};
use torse_geometry::developable::{
    QuarticData, certify, cone_system, oblique_image, solve, twist_determinant,
};
use torse_geometry::vector::{det, dot, sub};
use torse_geometry::{
    Bernstein, Curve, EnvelopingPatch, Gbt, HermiteCone, Over, PatchBounds, PlaneFamily, Rails,
    RuledSurface, Surface, TangentPatch, hermite,
};

/// `det(P', Q', Q - P)` at `x`, exactly.
fn determinant(patch: &impl Rails<Rational>, x: &Rational) -> Rational {
    let [p, q] = patch.rail_jets(x, 1).unwrap();
    let part =
        |jets: &[Jet<Rational>; 3], n: usize| jets.each_ref().map(|j| j.coefficients()[n].clone());
    det(&part(&p, 1), &part(&q, 1), &sub(&part(&q, 0), &part(&p, 0)))
}

fn rational() -> impl Strategy<Value = Rational> {
    (-40..40_i64, 1..7_i64).prop_map(|(n, d)| ratio(n, d).unwrap())
}

fn vectors<const D: usize>(count: usize) -> impl Strategy<Value = Vec<[Rational; D]>> {
    prop::collection::vec(
        prop::collection::vec(rational(), D).prop_map(|v| v.try_into().unwrap()),
        count,
    )
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 32, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn enveloping_patches_are_developable_exactly(planes in vectors::<4>(4)) {
        let Ok(family) = PlaneFamily::new(Bernstein, planes) else { return Ok(()) };
        let x = ratio(2, 7).unwrap();
        let bounds = PatchBounds::Range([integer(-1), integer(2)]);
        let patch = EnvelopingPatch::new(family.clone(), bounds).unwrap();
        if patch.ruling_ends(&x).is_ok() {
            prop_assert_eq!(determinant(&patch, &x), integer(0));
        }
        let cut = PatchBounds::Planes([[1, 2, 3, 4].map(integer), [2, -1, 0, 5].map(integer)]);
        let patch = EnvelopingPatch::new(family.clone(), cut).unwrap();
        if patch.ruling_ends(&x).is_ok() {
            prop_assert_eq!(determinant(&patch, &x), integer(0));
            // Curvature zero, exactly, where the patch is regular.
            if let Ok(k) = patch.gaussian_curvature(&x, &ratio(1, 3).unwrap()) {
                prop_assert_eq!(k, integer(0));
            }
        }
        let patch = TangentPatch::new(family, [integer(1), integer(2)]).unwrap();
        if patch.ruling_ends(&x).is_ok() {
            prop_assert_eq!(determinant(&patch, &x), integer(0));
        }
    }

    #[test]
    fn every_plane_touches_along_its_ruling(planes in vectors::<4>(4)) {
        let Ok(family) = PlaneFamily::new(Bernstein, planes) else { return Ok(()) };
        let x = ratio(3, 5).unwrap();
        let Ok(ruling) = family.ruling(&x) else { return Ok(()) };
        for plane in family.curve().derivatives(&x, 1).unwrap() {
            let [p, q, r, s] = plane;
            let normal = [p, q, r];
            prop_assert_eq!(dot(&normal, &ruling.foot), s);
            prop_assert_eq!(dot(&normal, &ruling.direction), integer(0));
        }
        // The foot is the nearest point, perpendicular to the ruling, and theta the moment of the line.
        prop_assert_eq!(dot(&ruling.foot, &ruling.direction), integer(0));
        prop_assert_eq!(torse_geometry::vector::cross(&ruling.foot, &ruling.direction), ruling.moment);
        if let Ok(point) = family.characteristic_point(&x) {
            for [p, q, r, s] in family.curve().derivatives(&x, 2).unwrap() {
                prop_assert_eq!(dot(&[p, q, r], &point), s);
            }
        }
    }

    #[test]
    fn the_spine_curve_is_tangent_to_its_rulings(planes in vectors::<4>(5)) {
        let Ok(family) = PlaneFamily::new(Bernstein, planes) else { return Ok(()) };
        let x = ratio(1, 4).unwrap();
        let (Ok(ruling), Ok(spine)) = (family.ruling(&x), family.characteristic_jet(&x, 1)) else { return Ok(()) };
        let tangent = spine.each_ref().map(|j| j.coefficients()[1].clone());
        let cross = torse_geometry::vector::cross(&tangent, &ruling.direction);
        prop_assert_eq!(cross, [integer(0), integer(0), integer(0)]);
    }

    #[test]
    fn hermite_cones_are_dilations_about_their_summit(
        data in vectors::<3>(6),
        k in (1..40_i64, 1..7_i64).prop_map(|(n, d)| ratio(n, d).unwrap()),
    ) {
        prop_assume!(k != integer(1));
        let [p_start, p_middle, q0, q1, q0u, q1u] = <[_; 6]>::try_from(data).unwrap();
        let data = QuarticData { p_start, p_middle, q_ends: [q0, q1], q_tangents: [q0u, q1u] };
        let cone = HermiteCone::quartic(k.clone(), data).unwrap();
        let patch = cone.patch().unwrap();
        for x in [ratio(1, 3).unwrap(), ratio(6, 7).unwrap()] {
            let [p, q] = patch.ruling_ends(&x).unwrap();
            for axis in 0..3 {
                let (o, k) = (&cone.summit[axis], &k);
                prop_assert_eq!(&q[axis] - o, k * (&p[axis] - o));
            }
            prop_assert_eq!(determinant(&patch, &x), integer(0));
        }
    }

    #[test]
    fn the_systems_of_the_cones_have_the_solutions_of_an_lu_decomposition(
        degree in 3..=5_usize,
        k in prop_oneof![0.1..0.95_f64, 1.05..8.0_f64],
        right in prop::collection::vec(-100.0..100.0, 6),
    ) {
        let rows: Vec<Vec<f64>> = cone_system(degree, &k);
        let size = rows.len();
        let matrix = DMatrix::from_fn(size, size, |i, j| rows[i][j]);
        let values = matrix.singular_values();
        let condition = values.max() / values.min();
        let lu = matrix.lu();
        let determinant = match degree {
            3 => k.powi(4),
            4 => -16.0 * k.powi(3) * (k - 1.0),
            _ => 256.0 * k.powi(3) * (k - 1.0),
        };
        prop_assert!((lu.determinant() / determinant - 1.0).abs() < 1e-14 * condition);
        let reference = lu.solve(&DVector::from_column_slice(&right[..size])).unwrap();
        let column = right.into_iter().take(size).map(|x| [x]).collect();
        let solution = solve("a test", rows, column).unwrap();
        let error = (DVector::from_iterator(size, solution.into_iter().flatten()) - &reference).norm();
        prop_assert!(error <= 4.0 * f64::EPSILON * condition * reference.norm(), "{error:e} {condition:e}");
    }
}

/// A family of GBT planes over formal functions.
fn formal_family(planes: &[[i64; 4]]) -> PlaneFamily<Gbt<Fraction>, Fraction> {
    let number = |n: i64| Fraction::from(integer(n));
    let planes = planes.iter().map(|plane| plane.map(number)).collect();
    let basis = Gbt::new(number(1), Fraction::from(ratio(1, 2).unwrap())).unwrap();
    PlaneFamily::new(basis, planes).unwrap()
}

#[test]
fn an_enveloping_patch_of_gbt_planes_is_developable_as_an_identity() {
    let family = formal_family(&[[7, -7, 5, 125], [-7, -7, 5, 120], [-7, 7, 5, 130]]);
    // Not parallel: on a cone, parallel cuts have parallel tangents, and the determinant is trivially zero.
    let cut = [[0, 0, 1, 0], [1, 2, 5, 3]].map(|plane| plane.map(|n| Fraction::from(integer(n))));
    let patch = EnvelopingPatch::new(family, PatchBounds::Planes(cut)).unwrap();
    assert!(twist_determinant(&patch).unwrap().is_zero());
}

#[test]
fn a_tangent_patch_of_gbt_planes_is_developable_as_an_identity() {
    let family = formal_family(&[[0, 0, 1, 0], [0, -1, 1, 0], [1, -2, 1, 0], [3, -3, 1, 1]]);
    let range = [0, 1].map(|n| Fraction::from(integer(n)));
    let patch = TangentPatch::new(family, range).unwrap();
    assert!(twist_determinant(&patch).unwrap().is_zero());
}

#[test]
fn the_formal_determinant_has_the_values_of_the_sampled_one() {
    let v = |x, y, z| [x, y, z].map(integer);
    let rail = |z| Curve::new(Bernstein, vec![v(0, 0, z), v(1, z, 0), v(2, 0, 1)]).unwrap();
    let twisted = RuledSurface::new(rail(0), rail(3));
    let formal = twist_determinant(&twisted.over(&|q| Fraction::from(q.clone())).unwrap()).unwrap();
    let x = ratio(2, 7).unwrap();
    let value = formal.at("x", &Fraction::from(x.clone())).unwrap();
    assert_eq!(value, Fraction::from(determinant(&twisted, &x)));
    assert!(!value.is_zero());
}

fn quintic() -> HermiteCone<Rational> {
    let v = |x, y, z| [x, y, z].map(integer);
    let q = vec![
        v(-20, 60, 45),
        v(-20, 5, 35),
        v(-20, -50, 45),
        v(0, -60, 90),
        v(0, -50, 70),
        v(0, -50, -30),
    ];
    HermiteCone {
        summit: v(100, 20, 45),
        ratio: integer(2),
        p: Vec::new(),
        q,
    }
}

#[test]
fn the_exact_oblique_image_lies_in_its_plane_and_on_the_cone() {
    let cone = quintic();
    let plane = [20, -3, 0, -580].map(integer);
    let image = oblique_image(&cone, &plane).unwrap();
    let curve = hermite::curve(&cone.q).unwrap();
    for n in 0..=12 {
        let x = ratio(n, 12).unwrap();
        let r = image.point(&x).unwrap();
        assert_eq!(dot(&[20, -3, 0].map(integer), &r), integer(-580));
        let reach = (
            sub(&r, &cone.summit),
            sub(&curve.point(&x).unwrap(), &cone.summit),
        );
        assert_eq!(
            torse_geometry::vector::cross(&reach.0, &reach.1),
            [integer(0), integer(0), integer(0)]
        );
    }
    assert_eq!(
        determinant(&RuledSurface::new(curve, image), &ratio(2, 5).unwrap()),
        integer(0)
    );
}

#[test]
fn the_printed_oblique_construction_is_not_developable() {
    let cone = quintic();
    let plane = [20, -3, 0, -580].map(integer);
    let data = torse_geometry::developable::oblique_image_as_printed(&cone, &plane).unwrap();
    let patch = RuledSurface::new(
        hermite::curve(&cone.q).unwrap(),
        hermite::curve(&data).unwrap(),
    );
    assert_ne!(determinant(&patch, &ratio(1, 4).unwrap()), integer(0));
}

#[test]
fn a_patch_across_its_edge_of_regression_is_reported_with_the_place() {
    let family = osculating_planes();
    let across = TangentPatch::new(family.clone(), [-1.0, 3.0]).unwrap();
    let certificate = certify(&across, 16).unwrap();
    assert!(!certificate.is_regular());
    assert!(
        (certificate.clearance.unwrap().v - 0.25).abs() < 1e-9,
        "{certificate:?}"
    );
    let beside = TangentPatch::new(family, [0.5, 1.0]).unwrap();
    let certificate = certify(&beside, 16).unwrap();
    // The edge is half a tangent away; |S'| is least at x = 0, where it is one.
    assert!(
        (certificate.clearance.unwrap().value - 0.5).abs() < 1e-9,
        "{certificate:?}"
    );
    // The least value is flat: its place is known to the root of the rounding.
    assert!(certificate.clearance.unwrap().x < 1e-6 && certificate.gaussian.unwrap().value < 1e-12);
}

#[test]
fn a_saddle_is_reported_as_not_developable() {
    let saddle = saddle();
    let certificate = certify(&saddle, 16).unwrap();
    assert!(certificate.determinant.value > 0.5 && certificate.gaussian.unwrap().value > 0.9);
}
