//! What is cut beyond the edges, the width of the cut, and how parts lie.

use torse_designs::lint::{LintDemand, LintRules, lint};
use torse_designs::openings::OpeningShape;
use torse_designs::unroll::{CutOptions, Demand, Grain, Part, Purpose, parts, parts_with, unroll};
use torse_designs::{Design, DesignError, read};
use torse_exchange::{Layer, dxf};
use torse_geometry::pattern::Segment;

fn made(text: &str, making: CutOptions) -> Result<Vec<Part>, DesignError> {
    let design = read("x.toml", text).unwrap_or_else(|e| panic!("{e:?}"));
    let pieces = unroll(&design, &Demand::default())?;
    parts_with(&design, &pieces, making)
}

fn area(outline: &[Segment]) -> f64 {
    outline.iter().map(Segment::area).sum()
}

/// A panel of 100 by 50 mm with a hole.
fn panel(design: &str, patch: &str) -> String {
    format!(
        r#"
[design]
{design}
[curves]
a = {{ bezier = [[0, 0, 0], [100, 0, 0]] }}
b = {{ bezier = [[0, 50, 0], [100, 50, 0]] }}
[patches.front]
ruled = ["a", "b"]
edges = {{ hem = "first" }}
marks = [{{ at = [0.5, 0.5], radius = 6 }}]
{patch}
"#
    )
}

#[test]
fn an_allowance_is_cut_beyond_all_edges_or_beyond_each_its_own() {
    for (design, patch, size) in [
        ("", "allowance = 10", [120.0, 70.0]),
        ("allowance = 10", "", [120.0, 70.0]),
        ("allowance = 10", "allowance = 0", [100.0, 50.0]),
        ("", "allowance = { hem = 30 }", [100.0, 80.0]),
        (
            "allowance = 5",
            "allowance = { hem = 30, start = 0 }",
            [105.0, 85.0],
        ),
        (
            "unit = \"cm\"",
            "allowance = { second = 1, end = 2 }",
            [1020.0, 510.0],
        ),
    ] {
        let part = made(&panel(design, patch), CutOptions::default())
            .unwrap()
            .remove(0);
        for (got, wanted) in part.size.iter().zip(size) {
            assert!(
                (got - wanted).abs() < 1e-9,
                "{design} {patch}: {:?}",
                part.size
            );
        }
        assert!((area(&part.outline) - size[0] * size[1]).abs() < 1e-6);
        // The seam line is the panel itself.
        let net = part.seam_line.as_deref().unwrap_or(&part.outline);
        let scale = if design.contains("cm") { 100.0 } else { 1.0 };
        assert!((area(net) - 5000.0 * scale).abs() < 1e-6);
    }
}

#[test]
fn curved_edges_move_along_their_normals() {
    // A sector of an annulus with radii 50 and 25 and an angle of 0.3 pi, 4 mm more on all sides.
    let text = r#"
[curves.rim]
arc = { centre = [0, 0, 0], from = [30, 0, 0], to = [0, 30, 0] }
[patches.cone]
cone = "rim"
apex = [0, 0, 40]
range = [1, 0.5]
allowance = 4
"#;
    let part = made(text, CutOptions::default()).unwrap().remove(0);
    // Beyond either straight side the strip of 4 mm spans asin(4/rho) on the circle of radius rho.
    let (low, high, steps) = (21.0, 54.0, 100_000);
    let step = (high - low) / f64::from(steps);
    let ring = |k: i32| {
        let rho = low + (f64::from(k) + 0.5) * step;
        rho * (0.3 * std::f64::consts::PI + 2.0 * libm::asin(4.0 / rho)) * step
    };
    let wanted: f64 = (0..steps).map(ring).sum();
    assert!(
        (area(&part.outline) - wanted).abs() < 1e-3,
        "{} {wanted}",
        area(&part.outline)
    );
    // Arcs stay arcs.
    assert!(
        part.outline
            .iter()
            .any(|segment| (segment.radius() - 54.0).abs() < 1e-6)
    );
}

#[test]
fn a_kerf_widens_outlines_and_narrows_openings() {
    let kerf = |kerf: f64| made(&panel("", ""), CutOptions { kerf, grain: None });
    let part = kerf(0.4).unwrap().remove(0);
    assert!((part.size[0] - 100.4).abs() < 1e-9 && (part.size[1] - 50.4).abs() < 1e-9);
    let OpeningShape::Round(_, radius) = part.openings[0].shape else {
        panic!("{:?}", part.openings)
    };
    assert!((radius - 5.8).abs() < 1e-12);
    assert!(part.seam_line.is_none());
    // The bound is that of the line before it was moved, and the notes say so.
    let notes = part.notes.join("; ");
    assert!(
        notes.contains("outline before it was moved for the kerf within")
            && notes.contains("line moved outward by 0.2 mm, half the kerf"),
        "{notes}"
    );
    assert!(matches!(kerf(13.0), Err(DesignError::Blank { .. })));
    for wrong in [-1.0, f64::NAN, 21.0] {
        assert!(
            matches!(kerf(wrong), Err(DesignError::OutOfRange { .. })),
            "{wrong}"
        );
    }
}

#[test]
fn the_grain_says_how_a_part_lies() {
    // Its rulings run along x and follow one another along y.
    let text = "[curves]\na = { bezier = [[0, 0, 0], [0, 100, 0]] }\nb = { bezier = [[20, 0, 0], [20, 100, 0]] }\n\
                [patches]\nstrip = { ruled = [\"a\", \"b\"] }\n";
    let size = |grain| made(text, CutOptions { kerf: 0.0, grain }).unwrap()[0].size;
    for (grain, wanted) in [
        (None, [100.0, 20.0]),
        (Some(Grain::Along), [100.0, 20.0]),
        (Some(Grain::Across), [20.0, 100.0]),
    ] {
        let got = size(grain);
        assert!(
            (0..2).all(|i| (got[i] - wanted[i]).abs() < 1e-9),
            "{grain:?}: {got:?}"
        );
    }
}

#[test]
fn the_cut_is_the_outside_and_its_notches_go_from_it_to_the_marked_seam() {
    let text = "seams = [[\"front.second\", \"back.first\"]]\n".to_owned()
        + &panel("allowance = 8", "")
        + "[patches.back]\nruled = [\"b\", \"c\"]\n";
    let text = text.replace(
        "[patches.front]",
        "c = { bezier = [[0, 90, 20], [100, 90, 20]] }\n[patches.front]",
    );
    let all = made(&text, CutOptions::default()).unwrap();
    assert_eq!(all.len(), 2);
    for part in &all {
        let cut = part.drawing(Purpose::Cut).unwrap();
        assert!(
            cut.paths()
                .iter()
                .all(|path| path.layer() == Layer::Outline)
        );
        let demand = LintDemand {
            thickness: None,
            unit: None,
        };
        let file = dxf(&cut).unwrap();
        let judged = lint(
            "x.dxf",
            file.as_bytes(),
            &LintRules::published().unwrap(),
            &demand,
        )
        .unwrap();
        assert!(judged.passes(), "{}", judged.text());
        let sewn = part.drawing(Purpose::Sew).unwrap();
        let marks: Vec<_> = sewn
            .paths()
            .iter()
            .filter(|p| p.layer() == Layer::Marks)
            .collect();
        assert!(marks[0].is_closed() && marks.len() == 4);
        let net = part.seam_line.as_ref().unwrap();
        assert_eq!(part.notches.len(), 3);
        for [from, to] in &part.notches {
            let off = |p: [f64; 2], outline: &[Segment]| {
                outline
                    .iter()
                    .map(|s| s.distance(p))
                    .fold(f64::INFINITY, f64::min)
            };
            // Three of the eight millimetres inwards.
            assert!(off(*from, &part.outline) < 1e-8);
            assert!((off(*to, &part.outline) - 3.0).abs() < 1e-8);
            assert!((off(*to, net) - 5.0).abs() < 1e-8);
        }
    }
}

#[test]
fn an_allowance_that_does_not_fit_is_refused() {
    // The small rim of the sector has a radius of 25 mm.
    let text = r#"
[curves.rim]
arc = { centre = [0, 0, 0], from = [30, 0, 0], to = [0, 30, 0] }
[patches.cone]
cone = "rim"
apex = [0, 0, 40]
range = [1, 0.5]
allowance = 26
"#;
    let error = made(text, CutOptions::default()).unwrap_err();
    assert!(
        error
            .to_string()
            .contains("its allowance does not fit: an inward curve of radius 25"),
        "{error}"
    );
    // What the file says wrongly is a mistake of the file.
    for (patch, words) in [
        ("allowance = -1", "[0, infinity)"),
        ("allowance = { top = 3 }", "there is no edge `top`"),
    ] {
        let DesignError::Wrong { mistakes } = read("x.toml", &panel("", patch)).unwrap_err() else {
            panic!("{patch}")
        };
        assert!(
            mistakes.iter().any(|m| m.to_string().contains(words)),
            "{mistakes:?}"
        );
    }
}

#[test]
fn parts_without_allowances_are_as_they_were() {
    let design: Design = read("x.toml", &panel("", "")).unwrap();
    let pieces = unroll(&design, &Demand::default()).unwrap();
    let usual = parts(&design, &pieces).unwrap();
    assert_eq!(
        usual,
        parts_with(&design, &pieces, CutOptions::default()).unwrap()
    );
    assert!(usual[0].seam_line.is_none());
}

#[test]
fn edges_of_chains_with_bends_have_their_own_allowances() {
    // Two flanges, 40 and 30 long and 60 wide.
    let chain = |base: &str, wall: &str, more: &str| {
        format!(
            r#"
[sheet]
thickness = 1
[curves]
a = {{ bezier = [[0, 0, 0], [40, 0, 0]] }}
a2 = {{ bezier = [[0, 60, 0], [40, 60, 0]] }}
b = {{ bezier = [[40, 0, 0], [40, 0, 30]] }}
b2 = {{ bezier = [[40, 60, 0], [40, 60, 30]] }}
[patches]
A = {{ ruled = ["a", "a2"], allowance = {{ {base} }} }}
B = {{ ruled = ["b", "b2"], allowance = {{ {wall} }} }}
[chains.ch]
patches = ["A", "B"]
{more}
"#
        )
    };
    for more in ["", "radius = 2"] {
        let size = |base: &str, wall: &str| {
            let made = made(&chain(base, wall, more), CutOptions::default()).unwrap();
            made[0].size
        };
        let plain = size("first = 0", "first = 0");
        for (base, wall, longer, wider) in [
            (
                "first = 10, second = 10",
                "first = 10, second = 10",
                0.0,
                20.0,
            ),
            ("first = 8", "second = 5, end = 3", 3.0, 13.0),
            ("start = 7", "end = 3", 10.0, 0.0),
        ] {
            let [length, width] = size(base, wall);
            let sides = [plain[0] + longer, plain[1] + wider];
            let [long, short] = [sides[0].max(sides[1]), sides[0].min(sides[1])];
            assert!(
                (length - long).abs() < 1e-6 && (width - short).abs() < 1e-6,
                "{more} {base} {wall}: {length} x {width}, {sides:?}"
            );
        }
    }
}

#[test]
fn corners_are_mitred_whatever_the_tolerance_is() {
    let text = panel("", "").replace("[design]", "[tolerances]\noutline = 0.5\n[design]");
    let making = CutOptions {
        kerf: 0.3,
        ..CutOptions::default()
    };
    let part = made(&text, making).unwrap().remove(0);
    assert!((part.size[0] - 100.3).abs() < 1e-8 && (part.size[1] - 50.3).abs() < 1e-8);
    assert!((area(&part.outline) - 100.3 * 50.3).abs() < 1e-6);
}
