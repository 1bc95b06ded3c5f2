//! Kinds of ends: apexes, tips, rails that stand still; and parts that lie far from the origin.

use torse_designs::eval::{EvalPlaces, eval};
use torse_designs::fold::fold_text;
use torse_designs::inspect::{Assurance, inspect};
use torse_designs::unroll::{Demand, drawing, unroll};
use torse_designs::{Design, read};
use torse_exchange::dxf;

fn design(text: &str) -> Design {
    read("x.toml", text).unwrap_or_else(|e| panic!("{e:?}"))
}

/// The pattern of the only piece, or of the one of this name.
fn area(text: &str, only: Option<&str>) -> (f64, Vec<[f64; 2]>) {
    let demand = Demand {
        only: only.map(str::to_owned),
        ..Demand::default()
    };
    let pieces = unroll(&design(text), &demand).unwrap_or_else(|e| panic!("{e}"));
    let flat = &pieces[0].flat;
    assert!(flat.errors().outline <= 0.011, "{:?}", flat.errors());
    let lengths = (0..flat.pieces()).filter_map(|k| flat.rail_lengths(k));
    (flat.area(), lengths.collect())
}

/// Half of the bow of a hull: a cone over a long curve with its apex beside it.
const FAN: &str = r#"
[design]
unit = "m"
[curves]
sheer = { bezier = [[0.000000, 0.030000, 0.980000], [0.721306, 0.412239, 0.853930], [1.502345, 0.703615, 0.749532], [2.360928, 0.785548, 0.714084], [3.185804, 0.740305, 0.748121], [4.000000, 0.610000, 0.825000]] }
[patches.bow]
cone = "sheer"
apex = [0.08, 0.05, 0.5]
part = [0, 0.2]
"#;

#[test]
fn a_fan_is_cut_whose_outline_meets_its_apex_once() {
    let (area, _) = area(FAN, None);
    // Half the integral of |p x p'|, by mpmath.
    assert!((area - 190_623.874).abs() < 1e-3, "{area}");
    let report = inspect(&design(FAN)).unwrap();
    assert_eq!(report.patches[0].developable, Assurance::ByConstruction);
    let edges = unroll(&design(FAN), &Demand::default()).unwrap();
    let [from, to] = [0.0, 1.0].map(|x| {
        let place = |v| torse_geometry::pattern::PatternPlace { piece: 0, x, v };
        let [a, b] = [0.0, 1.0].map(|v| edges[0].flat.flatten(place(v)).unwrap());
        torse_geometry::vector::norm(&torse_geometry::vector::sub(&a, &b))
    });
    assert!(
        (from - 487.031_826_5).abs() < 1e-6 && (to - 823.513_260_3).abs() < 1e-6,
        "{from} {to}"
    );
}

#[test]
fn an_apex_has_no_normal_and_no_curvature() {
    let text = r#"
[curves.rim]
arc = { centre = [0, 0, 0], from = [30.1, 0, 0], to = [0, 30.1, 0] }
[patches.tip]
cone = "rim"
apex = [0.1, 0.2, 55.3]
part = [0, 0.5]
"#;
    let at = [0.25, 0.5, 0.75].map(|u| [u, 1.0]);
    for row in eval(&design(text), None, &EvalPlaces::Places(at.to_vec())).unwrap() {
        assert_eq!(
            (row.point, row.normal, row.curvatures),
            ([0.1, 0.2, 55.3], None, None)
        );
    }
}

/// A panel between two curves with fans from the corners of the one over the rest of the other.
const PANEL: &str = r#"
[curves]
lower = { bezier = [[0, 0, 0], [800, -250, 60], [1900, -320, 90], [3000, -150, 40]] }
upper = { bezier = [[0, 120, 620], [900, -280, 560], [2000, -420, 590], [3000, -260, 700]] }
[patches.plate]
connect = ["lower", "upper"]
[patches.bow]
cone = "upper"
apex = [0, 0, 0]
part = [0, 0.16153591508932078]
[patches.stern]
cone = "upper"
apex = [3000, -150, 40]
part = [0.9510948599767973, 1]
[chains.panel]
patches = ["bow", "plate", "stern"]
continuity = "G1"
[sheet]
thickness = 4
least-radius = 20
"#;

#[test]
fn fans_join_their_panel_smoothly_and_the_radius_is_asked_for_away_from_the_apex() {
    let report = inspect(&design(PANEL)).unwrap();
    for joint in &report.joints {
        assert!(joint.kink < 1e-6 && joint.geometric >= Some(1), "{joint:?}");
    }
    assert!(report.missed.is_empty(), "{:?}", report.missed);
    let reach = |name: &str| {
        let patch = report
            .patches
            .iter()
            .find(|patch| patch.name == name)
            .unwrap();
        let note = patch
            .notes
            .iter()
            .find(|note| note.contains("of the apex"))
            .unwrap();
        let words: Vec<&str> = note.split(' ').collect();
        let at = words.iter().position(|word| *word == "mm").unwrap();
        words[at - 1].parse::<f64>().unwrap()
    };
    // Inside radii below 80 mm, by numpy.
    assert!((reach("bow") - 16.9).abs() < 0.2 && (reach("stern") - 11.4).abs() < 0.2);
}

#[test]
fn panels_that_end_in_a_point_are_cut() {
    let gore = r#"
[planes]
l = ["1/4", 1, 0, 0]
r = ["1/4", -1, 0, 0]
[curves]
prof = { bezier = [[0, 0, 0], [60, 0, 50], [140, 0, 60], [200, 0, 20]] }
[patches.tip]
cylinder = "prof"
direction = [0, 1, 0]
between = ["l", "r"]
"#;
    let (found, _) = area(gore, None);
    // Its file has all rulings but the one that is a point, and folds to the design.
    let made = design(gore);
    let pieces = unroll(&made, &Demand::default()).unwrap();
    let file = dxf(&drawing(&made, &pieces).unwrap()).unwrap();
    let folded = fold_text(&made, "tip.dxf", &file).unwrap();
    assert!(folded.missed.is_empty(), "{:?}", folded.missed);
    let rulings = pieces[0].flat.rulings().len();
    assert_eq!(folded.pieces[0].rulings, rulings - 1);
    assert!((found - 10_593.0).abs() < 0.5, "{found}");
    let report = inspect(&design(gore)).unwrap();
    let patch = &report.patches[0];
    assert!(report.missed.is_empty(), "{:?}", report.missed);
    // Its end is left out of the enclosure, and proved apart by the data without the factor that vanishes there.
    assert_eq!(
        (patch.developable, patch.regular),
        (Assurance::ByConstruction, Assurance::Proved)
    );
    assert!((patch.area.unwrap() - found).abs() < 1e-6 * found);
    assert!(
        patch
            .notes
            .iter()
            .any(|note| note.contains("meet in a point")),
        "{:?}",
        patch.notes
    );
}

#[test]
fn a_sail_is_cut_whose_head_is_a_point_far_from_the_origin() {
    let head = r#"
[curves]
luff = { bezier = [[0, 0, 0], [0, 40, 900], [20, 10, 1700], [0, 0, 2400]] }
[patches.head]
cylinder = "luff"
direction = [1, 0, 0]
between = [[1, 0, 0, 0], ["24/25", 0, "7/25", "672"]]
"#;
    let pieces = unroll(&design(head), &Demand::default()).unwrap();
    let flat = &pieces[0].flat;
    // The integral of the width 700 - 7 z/24 along the profile in the plane across the rulings, by Gauss's rule.
    let mut area = 0.0;
    let steps = 20_000_u32;
    for k in 0..steps {
        for shift in [-0.5 / 3.0_f64.sqrt(), 0.5 / 3.0_f64.sqrt()] {
            let t = (f64::from(k) + 0.5 + shift) / f64::from(steps);
            let b = |c: [f64; 4]| {
                let s = 1.0 - t;
                c[0] * s * s * s
                    + 3.0 * c[1] * s * s * t
                    + 3.0 * c[2] * s * t * t
                    + c[3] * t * t * t
            };
            let d = |c: [f64; 4]| {
                let s = 1.0 - t;
                3.0 * ((c[1] - c[0]) * s * s + 2.0 * (c[2] - c[1]) * s * t + (c[3] - c[2]) * t * t)
            };
            let (y, z) = ([0.0, 40.0, 10.0, 0.0], [0.0, 900.0, 1700.0, 2400.0]);
            area += 0.5 * libm::hypot(d(y), d(z)) * (700.0 - 7.0 * b(z) / 24.0) / f64::from(steps);
        }
    }
    assert!((area - 840_209.0).abs() < 1.0, "{area}");
    let errors = flat.errors();
    assert!(
        (flat.area() - area).abs() <= errors.area + 1e-6,
        "{} {area}",
        flat.area()
    );
    assert!(errors.outline <= 0.01, "{errors:?}");
    assert_eq!(
        inspect(&design(head)).unwrap().patches[0].regular,
        Assurance::Proved
    );
}

#[test]
fn a_rail_that_stands_still_at_its_end_is_no_hindrance() {
    let text = r#"
[curves]
a = { bezier = [[0, 0, 0], [0, 0, 0], [60, 40, 0], [100, 0, 0]] }
b = { bezier = [[0, 0, 0], [0, 0, 0], [0, 0, 0], [80, 50, 20]] }
c = { bezier = [[0, 0, 70], [0, 0, 70], [0, 0, 70], [80, 50, 90]] }
[patches]
wall = { cylinder = "a", direction = [0, 0, 70] }
flat = { ruled = ["b", "c"] }
"#;
    let (wall, lengths) = area(text, Some("wall"));
    assert!((wall - 7_577.468_1).abs() < 1e-3, "{wall}");
    assert!((lengths[0][0] - 108.249_544).abs() < 1e-5, "{lengths:?}");
    // A parallelogram: 70 times the distance of the lines.
    let (flat, _) = area(text, Some("flat"));
    assert!((flat - 70.0 * 8_900.0_f64.sqrt()).abs() < 1e-6, "{flat}");
    let report = inspect(&design(text)).unwrap();
    assert_eq!(report.patches[1].developable, Assurance::Proved);
    // Its radius falls to nothing where it stands still: a demanded one is missed.
    let thick = format!("{text}\n[sheet]\nthickness = 1\nleast-radius = 2\n");
    let report = inspect(&design(&thick)).unwrap();
    assert!(
        report
            .missed
            .iter()
            .any(|reason| reason.starts_with("wall: the inside radius")),
        "{:?}",
        report.missed
    );
}

#[test]
fn a_part_is_the_same_far_from_the_origin() {
    let text = r#"
[curves]
a = { bezier = [["3500000020", "5400000000", "312000"], ["10500000160/3", "16200000032/3", "312000"], ["10500000260/3", "5400000048", "312012"], ["3500000120", "5400000112", "312096"]] }
b = { bezier = [["3500000120", "5400000000", "312000"], ["10500000460/3", "5400000064", "312000"], ["10500000560/3", "16200000464/3", "312072"], ["3500000220", "5400000272", "312276"]] }
[patches.t]
ruled = ["a", "b"]
"#;
    let report = inspect(&design(text)).unwrap();
    let patch = &report.patches[0];
    assert!(report.missed.is_empty(), "{:?}", report.missed);
    assert_eq!(patch.regular, Assurance::Proved);
    assert!((patch.area.unwrap() - 19_256.962_93).abs() < 1e-2);
    let clearance = patch.clearance.unwrap();
    assert!(
        clearance.low.unwrap() > 15.0 && clearance.high.unwrap() < 21.0,
        "{clearance:?}"
    );
    let (found, _) = area(text, None);
    assert!((found - 19_256.962_93).abs() < 1e-2, "{found}");
}

#[test]
fn the_outline_of_a_sector_meets_its_apex_once_however_rounding_moves_it() {
    // Half the integral of |p x p'|, by Simpson's rule in another language.
    for (text, exact) in [
        (
            r#"
[curves]
a = { bezier = [[-78, -6, -31], [79, 143, 33], [67, 71, 40], [66, 26, -21]] }
[patches.p]
cone = "a"
apex = [0, 0, 0]
part = [0.08, 0.38]
"#,
            2_725.743_650,
        ),
        (
            r#"
[curves]
a = { bezier = [[4.0375, 15.5486, -5.7969], [19.9413, 18.9356, -6.2575], [30.689, 16.8176, -2.3089], [37.1365, 22.8052, -10.4565], [40.1376, 23.8923, -13.5737], [53.9908, 23.8458, -17.2062], [64.3637, 20.3202, -28.1162]] }
[patches.p]
cone = "a"
apex = [17.158, 26.168, 28.93]
part = [0.41, 1.0]
"#,
            440.584_647,
        ),
    ] {
        let (area, _) = area(text, None);
        assert!((area - exact).abs() < 1e-5, "{area}");
        assert!(inspect(&design(text)).unwrap().missed.is_empty());
    }
}

#[test]
fn a_curve_with_weights_may_begin_with_equal_control_points() {
    // 70 times the length of the curve, by chords in another language.
    for (points, weights, exact) in [
        (
            "[0, 0, 0], [100, 50, 0], [100, 50, 0]",
            "1, 4, 1",
            7_826.237_921,
        ),
        (
            "[0, 0, 0], [0, 0, 0], [0, 0, 0], [60, 40, 0], [100, 0, 0]",
            "1, 4, 1, 3, 1",
            8_044.356_4,
        ),
        (
            "[0, 0, 0], [0, 0, 0], [60, 40, 0], [100, 0, 0]",
            "1, 5, 1, 1",
            7_274.536_3,
        ),
        // Their products with the weights are rounded.
        (
            "[0.1, 0.7, 0], [0.1, 0.7, 0], [60, 40, 0], [100, 0, 0]",
            "3, 1.1, 1, 1",
            7_497.860_9,
        ),
    ] {
        let text = format!(
            "[curves]\na = {{ bezier = [{points}], weights = [{weights}] }}\n[patches.w]\ncylinder = \"a\"\ndirection = [0, 0, 70]\n"
        );
        let (area, _) = area(&text, None);
        assert!((area - exact).abs() < 1e-3, "{area} {exact}");
        let report = inspect(&design(&text)).unwrap();
        assert!(report.missed.is_empty(), "{:?}", report.missed);
        assert_eq!(report.patches[0].regular, Assurance::Proved, "{text}");
    }
}
