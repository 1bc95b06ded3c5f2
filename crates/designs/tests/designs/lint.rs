//! The linter of drawings: a good file, thirty damaged ones, each with the rule that it breaks and the place, and the cut
//! files of all worked designs.

use std::path::Path;
use torse_designs::lint::{Check, LintDemand, LintReport, LintRules, RuleFault, RuleOutcome, lint};
use torse_designs::load;
use torse_designs::unroll::{Demand, Purpose, parts, unroll};
use torse_exchange::{Drawing, Layer, Text, Vertex, dxf, svg};

const THICKNESS: f64 = 2.0;

fn judged_by(rules: &LintRules, name: &str, text: &str, thickness: Option<f64>) -> LintReport {
    let demand = LintDemand {
        thickness,
        unit: None,
    };
    lint(name, text.as_bytes(), rules, &demand).unwrap_or_else(|e| panic!("{name}: {e}"))
}

fn judged(name: &str, text: &str) -> LintReport {
    judged_by(
        &LintRules::published().unwrap(),
        name,
        text,
        Some(THICKNESS),
    )
}

/// A plate of 120 x 80 mm with one round corner, a round hole and a slot.
fn good() -> Drawing {
    let mut drawing = Drawing::default();
    outline(&mut drawing, true);
    drawing.circle(Layer::Outline, [30.0, 40.0], 8.0).unwrap();
    slot(&mut drawing, [70.0, 30.0], 20.0);
    drawing
}

fn corner(x: f64, y: f64, bulge: f64) -> Vertex {
    Vertex {
        point: [x, y],
        bulge,
    }
}

fn outline(drawing: &mut Drawing, closed: bool) {
    let quarter = libm::tan(std::f64::consts::PI / 8.0);
    let vertices = [
        corner(0.0, 0.0, 0.0),
        corner(120.0, 0.0, 0.0),
        corner(120.0, 70.0, quarter),
        corner(110.0, 80.0, 0.0),
        corner(0.0, 80.0, 0.0),
    ];
    drawing.path(Layer::Outline, &vertices, closed).unwrap();
}

/// A slot of 30 mm by so much.
fn slot(drawing: &mut Drawing, [x, y]: [f64; 2], width: f64) {
    let corners = [[x, y], [x + 30.0, y], [x + 30.0, y + width], [x, y + width]];
    drawing.polygon(Layer::Outline, &corners).unwrap();
}

/// The good drawing with something more.
fn with(add: impl FnOnce(&mut Drawing)) -> String {
    let mut drawing = good();
    add(&mut drawing);
    dxf(&drawing).unwrap()
}

fn line(layer: Layer, from: [f64; 2], to: [f64; 2]) -> String {
    with(|drawing| drawing.line(layer, from, to).unwrap())
}

/// The good file with an entity written by hand.
fn with_entity(groups: &str) -> String {
    let text = dxf(&good()).unwrap();
    let (head, tail) = text.split_once("2\nENTITIES\n").unwrap();
    format!("{head}2\nENTITIES\n{groups}{tail}")
}

#[test]
fn the_good_plate_keeps_every_rule() {
    for (name, text) in [
        ("plate.dxf", dxf(&good()).unwrap()),
        ("plate.svg", svg(&good()).unwrap()),
    ] {
        let report = judged(name, &text);
        assert!(
            report.passes() && report.faults.is_empty(),
            "{}",
            report.text()
        );
        assert!(
            report
                .rules
                .iter()
                .all(|rule| rule.outcome == RuleOutcome::Kept)
        );
        assert_eq!(report.contours, 3);
        let [width, height] = report.size.unwrap();
        assert!((width - 120.0).abs() < 1e-9 && (height - 80.0).abs() < 1e-9);
    }
    // The same plate of single lines, in any order and direction.
    let sides = [
        ([0.0, 0.0], [120.0, 0.0]),
        ([0.0, 80.0], [0.0, 0.0]),
        ([120.0, 80.0], [120.0, 0.0]),
        ([120.0, 80.0], [0.0, 80.0]),
    ];
    let mut plate = Drawing::default();
    for (from, to) in sides {
        plate.line(Layer::Outline, from, to).unwrap();
    }
    let report = judged("lines.dxf", &dxf(&plate).unwrap());
    assert!(report.passes() && report.contours == 1, "{}", report.text());
}

#[test]
fn rules_that_need_a_thickness_are_not_judged_without_one() {
    let rules = LintRules::published().unwrap();
    let report = judged_by(&rules, "plate.dxf", &dxf(&good()).unwrap(), None);
    assert!(report.passes());
    let open: Vec<Check> = report
        .rules
        .iter()
        .filter(|rule| rule.outcome == RuleOutcome::NotJudged)
        .map(|rule| rule.check)
        .collect();
    assert_eq!(open, [Check::Hole, Check::Web]);
}

/// A damaged file: its name, its text, the rule that it breaks, and where, if that is a point.
type Damaged = (&'static str, String, Check, Option<[f64; 2]>);

fn damaged() -> Vec<Damaged> {
    let text = |at: [f64; 2]| {
        with(|drawing| {
            drawing
                .text(Text {
                    layer: Layer::Marks,
                    at,
                    height: 5.0,
                    angle: 0.0,
                    content: "FRONT".to_owned(),
                })
                .unwrap();
        })
    };
    let open = |closing: &[[f64; 2]]| {
        let mut drawing = Drawing::default();
        outline(&mut drawing, false);
        drawing.polyline(Layer::Outline, closing).unwrap();
        dxf(&drawing).unwrap()
    };
    let mut unclosed = Drawing::default();
    outline(&mut unclosed, false);
    let circle = |at: [f64; 2], radius: f64| {
        with(|drawing| drawing.circle(Layer::Outline, at, radius).unwrap())
    };
    let plate = |add: &dyn Fn(&mut Drawing)| {
        let mut drawing = Drawing::default();
        outline(&mut drawing, true);
        add(&mut drawing);
        dxf(&drawing).unwrap()
    };
    let arc = |points: [[f64; 2]; 2], bulge: f64| {
        with(|drawing| {
            let vertices = [
                Vertex {
                    point: points[0],
                    bulge,
                },
                Vertex {
                    point: points[1],
                    bulge: 0.0,
                },
            ];
            drawing.path(Layer::Outline, &vertices, false).unwrap();
        })
    };
    let quarter = libm::tan(std::f64::consts::PI / 8.0);
    let many: Vec<[f64; 2]> = (0..2500)
        .map(|k| {
            let (s, c) = libm::sincos(f64::from(k) / 2500.0 * std::f64::consts::TAU);
            [60.0 + 100.0 * c, 40.0 + 100.0 * s]
        })
        .collect();
    let mut fine = Drawing::default();
    fine.polygon(Layer::Outline, &many).unwrap();
    let good_dxf = dxf(&good()).unwrap();
    let no_unit = good_dxf.replace("$INSUNITS\n70\n4\n", "$INSUNITS\n70\n0\n");
    let no_header = good_dxf.replace("9\n$INSUNITS\n70\n4\n", "");
    let good_svg = svg(&good()).unwrap();
    let (head, tail) = good_svg.split_once("width=\"").unwrap();
    let (_, tail) = tail.split_once("viewBox").unwrap();
    let svg_no_unit = format!("{head}viewBox{tail}");
    let in_svg = |element: &str| good_svg.replace("</svg>", &format!("{element}</svg>"));
    let entity = |kind: &str, more: &str| {
        with_entity(&format!(
            "0\n{kind}\n5\nFFF\n100\nAcDbEntity\n8\nNOTES\n10\n5.0\n20\n5.0\n{more}"
        ))
    };
    vec![
        // Open contours.
        (
            "unclosed.dxf",
            dxf(&unclosed).unwrap(),
            Check::Closed,
            Some([0.0, 0.0]),
        ),
        (
            "gap.dxf",
            open(&[[0.0, 80.0], [0.0, 0.5]]),
            Check::Closed,
            Some([0.0, 0.5]),
        ),
        (
            "hair-gap.dxf",
            open(&[[0.0, 80.0], [0.0, 0.02]]),
            Check::Closed,
            Some([0.0, 0.02]),
        ),
        (
            "overshoot.dxf",
            open(&[[0.0, 80.0], [0.0, -3.0]]),
            Check::Closed,
            Some([0.0, -3.0]),
        ),
        (
            "stray.dxf",
            line(Layer::Outline, [40.0, 60.0], [60.0, 65.0]),
            Check::Closed,
            Some([40.0, 60.0]),
        ),
        (
            "spur.dxf",
            line(Layer::Outline, [0.0, 0.0], [-20.0, -10.0]),
            Check::Closed,
            Some([-20.0, -10.0]),
        ),
        // Lines in one place.
        (
            "hole-twice.dxf",
            circle([30.0, 40.0], 8.0),
            Check::Doubled,
            None,
        ),
        (
            "outline-twice.dxf",
            with(|drawing| outline(drawing, true)),
            Check::Doubled,
            None,
        ),
        (
            "edge-again.dxf",
            line(Layer::Outline, [0.0, 0.0], [120.0, 0.0]),
            Check::Doubled,
            Some([60.0, 0.0]),
        ),
        (
            "edge-in-part.dxf",
            line(Layer::Outline, [50.0, 0.0], [54.0, 0.0]),
            Check::Doubled,
            Some([52.0, 0.0]),
        ),
        (
            "edge-beyond.dxf",
            line(Layer::Outline, [118.0, 0.0], [150.0, 0.0]),
            Check::Doubled,
            Some([119.0, 0.0]),
        ),
        (
            "edge-beside.dxf",
            line(Layer::Outline, [20.0, 0.005], [60.0, 0.005]),
            Check::Doubled,
            Some([40.0, 0.005]),
        ),
        (
            "ruling-on-edge.dxf",
            line(Layer::Rulings, [0.0, 80.0], [0.0, 0.0]),
            Check::Doubled,
            Some([0.0, 40.0]),
        ),
        (
            "bend-on-edge.dxf",
            with(|drawing| drawing.bend([0.0, 0.0], [0.0, 80.0], 0.5).unwrap()),
            Check::Doubled,
            Some([0.0, 40.0]),
        ),
        (
            "arc-again.dxf",
            arc([[120.0, 70.0], [110.0, 80.0]], quarter),
            Check::Doubled,
            None,
        ),
        (
            "arc-backwards.dxf",
            arc([[110.0, 80.0], [120.0, 70.0]], -quarter),
            Check::Doubled,
            None,
        ),
        // Contours that cross.
        (
            "hole-over-edge.dxf",
            circle([0.0, 40.0], 5.0),
            Check::Crossing,
            Some([0.0, 45.0]),
        ),
        (
            "holes-cross.dxf",
            circle([42.0, 40.0], 8.0),
            Check::Crossing,
            Some([36.0, 40.0 - 28.0_f64.sqrt()]),
        ),
        (
            "bow-tie.dxf",
            {
                let mut drawing = Drawing::default();
                let corners = [[0.0, 0.0], [100.0, 60.0], [100.0, 0.0], [0.0, 60.0]];
                drawing.polygon(Layer::Outline, &corners).unwrap();
                dxf(&drawing).unwrap()
            },
            Check::Crossing,
            Some([50.0, 30.0]),
        ),
        // What is no line.
        ("text.dxf", text([10.0, 10.0]), Check::Text, None),
        (
            "paragraph.dxf",
            entity("MTEXT", "1\nFRONT\n"),
            Check::Text,
            None,
        ),
        (
            "text.svg",
            in_svg("<text x=\"5\" y=\"-5\">FRONT</text>"),
            Check::Text,
            None,
        ),
        (
            "dimension.dxf",
            entity("DIMENSION", ""),
            Check::OnlyLines,
            None,
        ),
        ("hatch.dxf", entity("HATCH", ""), Check::OnlyLines, None),
        ("point.dxf", entity("POINT", ""), Check::OnlyLines, None),
        (
            "picture.svg",
            in_svg("<image width=\"5\" height=\"5\"/>"),
            Check::OnlyLines,
            None,
        ),
        // No unit.
        ("unit-zero.dxf", no_unit, Check::Units, None),
        ("no-unit.dxf", no_header, Check::Units, None),
        ("no-unit.svg", svg_no_unit, Check::Units, None),
        // More than one part.
        (
            "two-parts.dxf",
            with(|drawing| slot(drawing, [200.0, 0.0], 20.0)),
            Check::OnePart,
            Some([200.0, 0.0]),
        ),
        (
            "part-in-slot.dxf",
            with(|drawing| drawing.circle(Layer::Outline, [85.0, 40.0], 5.0).unwrap()),
            Check::OnePart,
            Some([90.0, 40.0]),
        ),
        // Too narrow for the sheet.
        (
            "small-hole.dxf",
            circle([30.0, 60.0], 0.9),
            Check::Hole,
            Some([30.0, 60.0]),
        ),
        (
            "narrow-slot.dxf",
            plate(&|drawing| slot(drawing, [40.0, 40.0], 1.9)),
            Check::Hole,
            Some([55.0, 40.95]),
        ),
        (
            "hole-at-edge.dxf",
            circle([5.0, 20.0], 3.5),
            Check::Web,
            None,
        ),
        (
            "holes-close.dxf",
            circle([30.0, 56.5], 7.0),
            Check::Web,
            None,
        ),
        // Too many points, and too near each other.
        (
            "many-points.dxf",
            dxf(&fine).unwrap(),
            Check::Nodes,
            Some([160.0, 40.0]),
        ),
        (
            "short.dxf",
            plate(&|drawing| {
                let corners = [[40.0, 40.0], [50.0, 40.0], [50.0, 40.001], [50.0, 50.0]];
                drawing.polygon(Layer::Outline, &corners).unwrap();
            }),
            Check::ShortLines,
            Some([50.0, 40.0]),
        ),
    ]
}

#[test]
fn damaged_files_break_their_rule_at_their_place() {
    let all = damaged();
    assert!(all.len() >= 30, "{}", all.len());
    for (name, text, check, at) in &all {
        let report = judged(name, text);
        assert!(!report.passes(), "{name}");
        let own: Vec<&RuleFault> = report
            .faults
            .iter()
            .filter(|fault| fault.check == *check)
            .collect();
        assert!(!own.is_empty(), "{name}: {}", report.text());
        assert!(own.iter().all(|fault| !fault.reason.is_empty()), "{name}");
        if let Some(at) = at {
            let near = |fault: &&RuleFault| {
                fault
                    .at
                    .is_some_and(|[x, y]| libm::hypot(x - at[0], y - at[1]) < 0.02)
            };
            assert!(own.iter().any(near), "{name}: {:?}", own);
        } else {
            // A file, a line or an entity tells where.
            let told = own
                .iter()
                .all(|fault| fault.at.is_some() || fault.place.is_some());
            assert!(told || *check == Check::Units, "{name}: {own:?}");
        }
        assert!(
            report
                .text()
                .lines()
                .all(|line| line.chars().count() <= 160),
            "{}",
            report.text()
        );
    }
}

#[test]
fn damage_of_one_kind_breaks_no_other_rule() {
    for (name, text, check, _) in damaged() {
        let alone = matches!(
            check,
            Check::Text
                | Check::OnlyLines
                | Check::Units
                | Check::Hole
                | Check::Nodes
                | Check::ShortLines
        );
        if alone || name == "bend-on-edge.dxf" || name == "two-parts.dxf" {
            let report = judged(name, &text);
            assert!(
                report.faults.iter().all(|fault| fault.check == check),
                "{name}: {}",
                report.text()
            );
        }
    }
}

#[test]
fn rules_of_a_file_are_used_and_wrong_ones_refused() {
    let rules = "joined-within = 0.05\n[[rules]]\ncheck = \"size\"\nat-most = 100\nsource = \"ours\"\n\
                 [[rules]]\ncheck = \"radius\"\nat-least = 12\nsource = \"a router of 24 mm\"\n";
    let rules = LintRules::parse(rules).unwrap();
    let report = judged_by(&rules, "plate.dxf", &dxf(&good()).unwrap(), None);
    let measured: Vec<f64> = report
        .faults
        .iter()
        .filter_map(|fault| fault.measured)
        .collect();
    assert!(
        (measured[0] - 120.0).abs() < 1e-9 && (measured[1] - 10.0).abs() < 1e-9,
        "{measured:?}"
    );
    // A gap that these rules take for joined.
    let mut drawing = Drawing::default();
    outline(&mut drawing, false);
    drawing
        .polyline(Layer::Outline, &[[0.0, 80.0], [0.0, 0.04]])
        .unwrap();
    assert_eq!(
        judged_by(&rules, "gap.dxf", &dxf(&drawing).unwrap(), None).contours,
        1
    );
    for wrong in [
        "",
        "joined-within = -1\nrules = []",
        "joined-within = 0.01\n[[rules]]\ncheck = \"beauty\"\nsource = \"x\"\n",
        "joined-within = 0.01\n[[rules]]\ncheck = \"hole\"\nsource = \"x\"\n",
        "joined-within = 0.01\n[[rules]]\ncheck = \"closed\"\nat-least = 1\nsource = \"x\"\n",
    ] {
        assert!(LintRules::parse(wrong).is_err(), "{wrong}");
    }
}

#[test]
fn every_published_rule_has_a_source_and_an_address() {
    for rule in LintRules::published().unwrap().rules {
        assert!(!rule.source.is_empty());
        assert!(rule.url.is_some_and(|url| url.starts_with("https://")));
    }
}

#[test]
fn the_cut_files_of_all_worked_designs_pass() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../designs");
    let mut seen = 0;
    for entry in std::fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        if path.extension().is_none_or(|e| e != "toml") {
            continue;
        }
        let design = load(&path).unwrap();
        let thickness = design.metal.map_or(1.0, |metal| metal.sheet.thickness());
        let pieces = unroll(&design, &Demand::default()).unwrap();
        for part in parts(&design, &pieces).unwrap() {
            for purpose in [Purpose::Cut, Purpose::Bend] {
                let drawing = part.drawing(purpose).unwrap();
                let files = [("part.dxf", dxf(&drawing)), ("part.svg", svg(&drawing))];
                for (name, text) in files {
                    let rules = LintRules::published().unwrap();
                    let report = judged_by(&rules, name, &text.unwrap(), Some(thickness));
                    assert!(
                        report.passes(),
                        "{} {}: {}",
                        design.name,
                        part.name,
                        report.text()
                    );
                    seen += 1;
                }
            }
        }
    }
    assert!(seen >= 28, "{seen}");
}

#[test]
fn the_width_of_a_circle_is_its_diameter() {
    let text = with(|drawing| {
        drawing.circle(Layer::Outline, [90.0, 65.0], 0.65).unwrap();
    });
    let report = judged("part.dxf", &text);
    let widths: Vec<f64> = report
        .faults
        .iter()
        .filter(|fault| fault.check == Check::Hole)
        .filter_map(|fault| fault.measured)
        .collect();
    assert!(
        !widths.is_empty() && widths.iter().all(|w| (w - 1.3).abs() < 1e-12),
        "{:?}",
        report.faults
    );
}

#[test]
fn a_curve_that_leaves_the_plane_of_the_drawing_is_refused() {
    let line = |z: f64| {
        format!(
            "0\nSECTION\n2\nENTITIES\n0\nLINE\n8\n0\n10\n0\n20\n0\n30\n7\n11\n10\n21\n0\n31\n{z}\n0\nENDSEC\n0\nEOF\n"
        )
    };
    let rules = LintRules::published().unwrap();
    let judged = |z: f64| lint("z.dxf", line(z).as_bytes(), &rules, &LintDemand::default());
    let error = judged(5.0).unwrap_err().to_string();
    assert!(
        error.contains("line 6") && error.contains("z runs from 5 to 7 mm"),
        "{error}"
    );
    assert!(judged(7.0).is_ok());
}

#[test]
fn a_neck_of_one_contour_is_too_narrow_a_web_and_corners_and_slits_are_no_necks() {
    let webs = |points: &[[f64; 2]], more: &dyn Fn(&mut Drawing)| {
        let mut drawing = Drawing::default();
        drawing.polygon(Layer::Outline, points).unwrap();
        more(&mut drawing);
        let report = judged("part.dxf", &dxf(&drawing).unwrap());
        let faults = report
            .faults
            .iter()
            .filter(|fault| fault.check == Check::Web);
        let found: Vec<(f64, [f64; 2])> = faults
            .map(|fault| (fault.measured.unwrap(), fault.at.unwrap()))
            .collect();
        (found, report.text())
    };
    // Two plates, held together by a neck of 0.2 x 4 mm: both rules of webs are broken there, in the middle between its sides.
    let neck = [
        [0.0, 0.0],
        [40.0, 0.0],
        [40.0, 19.9],
        [44.0, 19.9],
        [44.0, 0.0],
        [84.0, 0.0],
        [84.0, 40.0],
        [44.0, 40.0],
        [44.0, 20.1],
        [40.0, 20.1],
        [40.0, 40.0],
        [0.0, 40.0],
    ];
    let (found, text) = webs(&neck, &|_| ());
    assert!(found.len() == 2, "{text}");
    for (width, at) in found {
        assert!((width - 0.2).abs() < 1e-9, "{text}");
        assert!(
            (40.0..=44.0).contains(&at[0]) && (at[1] - 20.0).abs() < 1e-9,
            "{text}"
        );
    }
    // The same, as an opening: its narrow part is no material.
    let around = [[-20.0, -20.0], [110.0, -20.0], [110.0, 60.0], [-20.0, 60.0]];
    let (found, text) = webs(&around, &|drawing| {
        drawing.polygon(Layer::Outline, &neck).unwrap()
    });
    assert!(found.is_empty(), "{text}");
    assert!(text.contains("kept; slits not looked at"), "{text}");
    // A sharp corner, and a slit of 0.5 mm.
    let sharp = [
        [0.0, 0.0],
        [80.0, 0.0],
        [80.0, 40.0],
        [30.25, 40.0],
        [30.25, 5.0],
        [29.75, 5.0],
        [29.75, 40.0],
        [5.0, 40.0],
    ];
    let (found, text) = webs(&sharp, &|_| ());
    assert!(found.is_empty(), "{text}");
    let tip = [[0.0, 0.0], [80.0, 0.0], [80.0, 5.0]];
    let (found, text) = webs(&tip, &|_| ());
    assert!(found.is_empty(), "{text}");
    // Necks between arcs, and a finger.
    let mut drawing = Drawing::default();
    let waist = [
        corner(0.0, 0.0, 0.0),
        corner(20.0, 0.0, -1.0),
        corner(40.0, 0.0, 0.0),
        corner(60.0, 0.0, 0.0),
        corner(60.0, 20.6, 0.0),
        corner(40.0, 20.6, -1.0),
        corner(20.0, 20.6, 0.0),
        corner(0.0, 20.6, 0.0),
    ];
    drawing.path(Layer::Outline, &waist, true).unwrap();
    let report = judged("waist.dxf", &dxf(&drawing).unwrap());
    let fault = report
        .faults
        .iter()
        .find(|fault| fault.check == Check::Web)
        .unwrap();
    let at = fault.at.unwrap();
    assert!(
        (at[0] - 30.0).abs() < 0.5 && (at[1] - 10.3).abs() < 0.1,
        "{fault:?}"
    );
    assert!(
        fault
            .measured
            .is_some_and(|width| (0.6..0.7).contains(&width)),
        "{fault:?}"
    );
}

#[test]
fn places_of_an_svg_are_those_of_the_file_where_y_goes_down() {
    let text = "<svg xmlns='http://www.w3.org/2000/svg' width='100mm' height='100mm' viewBox='0 0 100 100'>\
                <rect x='10' y='10' width='80' height='80' fill='none' stroke='black'/>\
                <path d='M30,40 L30.5,40 L30.5,40.5 L30,40.5' fill='none' stroke='black'/></svg>";
    let report = judged("open.svg", text);
    let mut faults = report
        .faults
        .iter()
        .filter(|fault| fault.check == Check::Closed);
    let at = faults.next().expect("the path is open").at.unwrap();
    assert!(
        (at[0] - 30.0).abs() < 1e-6 && (at[1] - 40.25).abs() < 0.3,
        "{at:?}"
    );
}
