//! What the corrections of the papers taught is what the library demands: the page that lists it, and what it lists and no
//! other test shows.

#![allow(clippy::unwrap_used, clippy::expect_used, reason = "helpers of tests")]

use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};
use torse_geometry::developable::{QuarticData, oblique_image_as_printed};
use torse_geometry::{
    Basis, Bernstein, Continuity, Curve, Gbt, GeometryError, HermiteCone, Plane, PlaneFamily,
    RuledSurface, Surface, join,
};
use torse_syntax::derivation::load;

fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("..")
}

/// The cells of a row, without the empty ones at its ends.
fn cells(line: &str) -> Vec<&str> {
    line.trim_matches('|').split('|').map(str::trim).collect()
}

/// What stands between backticks.
fn quoted(cell: &str) -> impl Iterator<Item = &str> {
    cell.split('`').skip(1).step_by(2)
}

#[test]
fn every_fault_has_a_line_with_tests_that_exist_or_is_of_the_text_alone() {
    let page = fs::read_to_string(root().join("derivations/LESSONS.md")).unwrap();
    let mut listed: BTreeMap<String, usize> = BTreeMap::new();
    let mut paper = "";
    for line in page.lines() {
        if let Some(heading) = line.strip_prefix("## ") {
            paper = heading;
        }
        if !line.starts_with("| ") || line.starts_with("| fault ") {
            continue;
        }
        let cells = cells(line);
        let [fault, done, place, tests] = cells.as_slice() else {
            panic!("{line}")
        };
        *listed
            .entry(format!("{paper}/corrigendum.{fault}"))
            .or_default() += 1;
        let named: Vec<&str> = quoted(tests).collect();
        let alone = done.starts_with("of the text alone: ");
        assert_eq!(alone, named.is_empty() && place.is_empty(), "{line}");
        for file in quoted(place) {
            assert!(root().join(file).is_file(), "{line}");
        }
        let mut source = String::new();
        for name in named {
            match name.ends_with(".rs") {
                true => source = fs::read_to_string(root().join(name)).expect(name),
                false => {
                    let test = format!("fn {name}(");
                    let (before, _) = source.split_once(&test).unwrap_or_else(|| panic!("{name}"));
                    assert!(before.trim_end().ends_with("#[test]"), "{name} is no test");
                }
            }
        }
    }
    let papers = load(&root().join("derivations")).unwrap();
    let faults = papers.iter().flat_map(|paper| &paper.corrigenda);
    let faults: BTreeMap<String, usize> = faults.map(|fault| (fault.id.clone(), 1)).collect();
    assert!(faults.len() > 40);
    assert_eq!(listed, faults);
}

const ARCH: [Plane<f64>; 4] = [
    [0.0, -20.0, 10.0, 400.0],
    [0.0, -10.0, 20.0, 400.0],
    [0.0, 10.0, 20.0, 400.0],
    [0.0, 20.0, 10.0, 400.0],
];

fn arch(mu: f64, nu: f64) -> PlaneFamily<Gbt<f64>, f64> {
    PlaneFamily::new(Gbt::new(mu, nu).unwrap(), ARCH.to_vec()).unwrap()
}

#[test]
fn where_the_middle_function_is_zero_no_curve_is_continued() {
    let basis = Gbt::new(-1.0, -1.0).unwrap();
    for x in [0.0, 0.25, 0.5, 1.0] {
        assert!(basis.row(2, &x).unwrap()[1].abs() < 1e-15);
    }
    let left = Curve::new(Gbt::new(0.0, 0.0).unwrap(), vec![[0.0], [1.0], [3.0]]).unwrap();
    let c1 = Continuity::parametric(1, &0.0);
    let error = join::next_curve(&left, basis, &c1, &[[4.0]]).unwrap_err();
    assert!(
        matches!(error, GeometryError::SingularJoin { .. }),
        "{error}"
    );
    // With any other parameters it is.
    let basis = Gbt::new(-0.5, -1.0).unwrap();
    assert!(join::next_curve(&left, basis, &c1, &[[4.0]]).is_ok());
}

#[test]
fn shape_parameters_are_those_of_definition_1() {
    for inside in [-1.0, -0.5, 0.0, 1.0] {
        assert!(Gbt::new(inside, inside).is_ok());
    }
    // What C2 between the trajectories of Example 3.5 would need, for every mu of the range.
    let needed = 2.0 + 8.0 / (2.0 + std::f64::consts::PI) - 1.0;
    for outside in [-1.001, needed] {
        let error = Gbt::new(0.0, outside).unwrap_err();
        assert!(matches!(error, GeometryError::OutOfRange { .. }), "{error}");
    }
}

#[test]
fn end_generators_change_with_one_shape_parameter_each_and_stay_where_they_are() {
    let ruling = |mu, nu, x: f64| arch(mu, nu).ruling(&x).unwrap();
    let length = |mu, nu, x| ruling(mu, nu, x).direction[0].abs();
    let near = |a: f64, b: f64| (a - b).abs() < 1e-9 * b.abs().max(1.0);
    for (mu, nu) in [(0.25, 0.75), (-0.5, 0.5), (0.5, 0.0)] {
        let pi = std::f64::consts::PI;
        assert!(near(length(mu, nu, 0.0), 150.0 * (2.0 + pi * (1.0 + mu))));
        assert!(near(length(mu, nu, 1.0), 150.0 * (2.0 + pi * (1.0 + nu))));
        for x in [0.0, 1.0] {
            let (here, there) = (ruling(mu, nu, x), ruling(0.0, 0.0, x));
            assert!((0..3).all(|i| near(here.foot[i], there.foot[i])));
            assert!(here.direction[1].abs() + here.direction[2].abs() < 1e-9);
        }
    }
}

#[test]
fn planes_through_one_line_are_no_family() {
    let side = 5.0 * 2.0_f64.sqrt();
    let planes = [side, -side, -side, side].map(|x| [x, -side, 5.0, 125.0]);
    let error = PlaneFamily::new(Gbt::new(0.5, 0.5).unwrap(), planes.to_vec()).unwrap_err();
    assert!(matches!(error, GeometryError::Pencil { .. }), "{error}");
}

#[test]
fn doubled_planes_join_as_the_planes_themselves() {
    let left = arch(0.5, 0.25);
    let basis = Gbt::new(-0.5, 0.75).unwrap();
    let condition = Continuity::parametric(2, &0.0);
    let right = join::next_family(&left, basis, &condition, &[[0.0, 40.0, -40.0, 400.0]]).unwrap();
    let doubled = right
        .curve()
        .points()
        .iter()
        .map(|plane| plane.map(|c| 2.0 * c));
    let doubled = PlaneFamily::new(basis, doubled.collect()).unwrap();
    let joint = |right| {
        join::measure_families(&left, right, 2)
            .unwrap()
            .order_within(1e-12)
    };
    assert_eq!(joint(&right), Some(2));
    assert_eq!(joint(&doubled), Some(2));
}

#[test]
fn an_end_plane_in_common_is_no_common_generator() {
    let left = arch(0.5, 0.25);
    let order = |second| {
        let planes = [
            ARCH[3],
            second,
            [0.0, 40.0, -30.0, 400.0],
            [0.0, 50.0, -40.0, 400.0],
        ];
        let right = PlaneFamily::new(Gbt::new(0.0, 0.0).unwrap(), planes.to_vec()).unwrap();
        let measure = join::measure_families(&left, &right, 1).unwrap();
        measure.order_within(1e-12)
    };
    assert_eq!(order([10.0, 20.0, 0.0, 300.0]), Some(0));
    // Any plane through the generator, the line of the last two planes, makes it common.
    let through: Vec<f64> = (0..4)
        .map(|i| 3.0 * ARCH[3][i] - 2.0 * ARCH[2][i])
        .collect();
    assert_eq!(order(through.try_into().unwrap()), Some(1));
}

#[test]
fn evenly_spaced_points_are_not_run_through_at_one_speed() {
    let even = || {
        (0..4)
            .map(|k| [f64::from(k) / 3.0])
            .collect::<Vec<[f64; 1]>>()
    };
    let bezier = Curve::new(Bernstein, even()).unwrap();
    let blended = Curve::new(Gbt::new(0.0, 0.0).unwrap(), even()).unwrap();
    let off = |curve: &dyn Fn(&f64) -> f64| (curve(&0.25) - 0.25).abs();
    assert!(off(&|x| bezier.point(x).unwrap()[0]) < 1e-15);
    assert!(off(&|x| blended.point(x).unwrap()[0]) > 0.01);
}

#[test]
fn a_plane_through_the_summit_or_along_a_ray_takes_no_image() {
    let cone = HermiteCone {
        summit: [100.0, 20.0, 45.0],
        ratio: 2.0,
        p: vec![],
        q: vec![
            [-20.0, 60.0, 45.0],
            [-20.0, 5.0, 35.0],
            [-20.0, -50.0, 45.0],
            [0.0, -60.0, 90.0],
            [0.0, -50.0, 70.0],
            [0.0, -50.0, -30.0],
        ],
    };
    let refused = |plane| oblique_image_as_printed(&cone, &plane).unwrap_err();
    let through = refused([20.0, -3.0, 0.0, 1940.0]);
    assert!(
        matches!(through, GeometryError::Degenerate { .. }),
        "{through}"
    );
    // Along the rays to q_0 and to q_0 + q_0^u.
    for (normal, datum) in [([1.0, 3.0, 0.0], 0), ([0.0, 9.0, 2.0], 3)] {
        let along = refused([normal[0], normal[1], normal[2], 1.0]);
        assert!(
            matches!(along, GeometryError::BehindApex { index, .. } if index == datum),
            "{along}"
        );
    }
}

#[test]
fn a_cylinder_has_no_spine_curve() {
    let error = arch(0.5, 0.25).characteristic_point(&0.5).unwrap_err();
    let none = matches!(error, GeometryError::NoCharacteristicPoint { .. });
    assert!(none, "{error}");
}

#[test]
fn rails_with_shape_parameters_of_their_own_are_both_on_the_ruled_surface() {
    let rail = |mu, nu, y: f64| {
        let points = [[0.0, 4.0], [2.0, 8.0], [4.0, 8.0], [6.0, 4.0], [7.0, 2.0]];
        let points = points.map(|[x, z]| [x, y, z]);
        Curve::new(Gbt::new(mu, nu).unwrap(), points.to_vec()).unwrap()
    };
    let (first, second) = (rail(0.5, -0.25, 0.0), rail(-1.0, 1.0, 6.0));
    let surface = RuledSurface::new(first.clone(), second.clone());
    for z in [0.0, 0.3, 0.5, 1.0] {
        assert_eq!(surface.point(&z, &0.0).unwrap(), first.point(&z).unwrap());
        assert_eq!(surface.point(&z, &1.0).unwrap(), second.point(&z).unwrap());
    }
    assert_ne!(
        first.point(&0.3).unwrap()[2],
        second.point(&0.3).unwrap()[2]
    );
}

#[test]
fn a_quartic_cone_excludes_no_value_but_one() {
    let cone = |k| {
        let data = QuarticData {
            p_start: [40.0, 40.0, 45.0],
            p_middle: [40.0, 12.5, 60.0],
            q_ends: [[-20.0, 60.0, 45.0], [-20.0, -50.0, 45.0]],
            q_tangents: [[0.0, -30.0, 60.0], [0.0, -50.0, -60.0]],
        };
        HermiteCone::quartic(k, data)
    };
    assert!(cone(135.0 / 136.0).is_ok());
    let error = cone(1.0).unwrap_err();
    assert!(
        matches!(error, GeometryError::SingularSystem { .. }),
        "{error}"
    );
}
