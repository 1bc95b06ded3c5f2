//! Patterns against closed forms, joints against what was asked for, refusals.

use std::f64::consts::PI;
use torse_designs::export::{bytes, mesh};
use torse_designs::inspect::{Assurance, inspect};
use torse_designs::unroll::{Demand, PatternSummary, drawing, unroll};
use torse_designs::{Design, DesignError, read};
use torse_exchange::Layer;
use torse_geometry::pattern::PatternError;

fn design(text: &str) -> Design {
    read("x.toml", text).unwrap_or_else(|e| panic!("{e:?}"))
}

#[test]
fn units_are_turned_into_millimetres() {
    for (unit, factor) in [
        ("mm", 1.0),
        ("cm", 10.0),
        ("m", 1000.0),
        ("in", 25.4),
        ("ft", 304.8),
    ] {
        let text = format!(
            "design = {{ unit = \"{unit}\" }}
             curves.rim = {{ arc = {{ centre = [0, 0, 0], from = [2, 0, 0], to = [0, 2, 0] }} }}
             planes = {{ low = [0, 0, 1, 0], high = [0, 0, 2, 6] }}
             patches.tube = {{ cylinder = \"rim\", direction = [0, 0, 1], between = [\"low\", \"high\"] }}
             tolerances = {{ outline = 0.001 }}"
        );
        let pieces = unroll(&design(&text), &Demand::default()).unwrap();
        let exact = 3.0 * PI * factor * factor;
        assert!(
            (pieces[0].flat.area() - exact).abs() < 1e-12 * exact,
            "{unit}"
        );
    }
}

#[test]
fn an_oblique_cone_cut_by_planes_is_developable_and_regular() {
    let design = design(
        "curves.rim = { arc = { centre = [0, 0, 0], from = [30, 0, 0], to = [0, 20, 0] } }
         patches.cone = { cone = \"rim\", apex = [5, 3, 60], between = [[0.1, 0, 1, 2], [0, 0.2, 1, 30]] }",
    );
    let report = inspect(&design).unwrap();
    let cone = &report.patches[0];
    assert!(report.missed.is_empty());
    assert_eq!(
        (cone.developable, cone.regular),
        (Assurance::ByConstruction, Assurance::Proved)
    );
    // The edge of regression is the apex, from which the upper cut stays away by so much at least.
    let clearance = cone.clearance.unwrap();
    assert!(
        clearance.low.unwrap() > 25.0 && clearance.high.unwrap() < 35.0,
        "{clearance:?}"
    );
}

#[test]
fn a_cone_with_its_apex_is_regular_but_there() {
    let design = design(
        "curves.rim = { arc = { centre = [0, 0, 0], from = [30, 0, 0], to = [0, 30, 0] } }
         patches.cone = { cone = \"rim\", apex = [0, 0, 40] }",
    );
    let report = inspect(&design).unwrap();
    let cone = &report.patches[0];
    assert_eq!(
        (cone.regular, cone.apexes.as_slice(), cone.radius),
        (Assurance::Proved, &[2][..], Some(0.0))
    );
    assert!((cone.area.unwrap() - PI * 30.0 * 50.0 / 4.0).abs() < 1e-6);
    let pieces = unroll(&design, &Demand::default()).unwrap();
    assert!((pieces[0].flat.area() - cone.area.unwrap()).abs() < 1e-6);
}

const TWISTED: &str = "
curves.a = { bezier = [[0, 0, 0], [100, 0, 0]] }
curves.b = { bezier = [[0, 10, 0], [100, 10, 5]] }
patches.strip = { ruled = [\"a\", \"b\"] }
";

#[test]
fn what_is_not_developable_is_refused_unless_strain_is_allowed() {
    let design = design(TWISTED);
    let report = inspect(&design).unwrap();
    assert_eq!(report.patches[0].developable, Assurance::No);
    assert!(report.missed[0].starts_with("strip is not developable: the tangent plane turns by"));
    let error = unroll(&design, &Demand::default()).unwrap_err();
    let DesignError::Unroll {
        reason: PatternError::NotDevelopable { strain, .. },
        ..
    } = &error
    else {
        panic!("{error}");
    };
    let help = error.help().unwrap();
    assert!(help.starts_with("`--allow-strain "), "{help}");
    let allowed: f64 = help
        .split(' ')
        .nth(1)
        .unwrap()
        .trim_end_matches('`')
        .parse()
        .unwrap();
    assert!(allowed >= *strain);
    let demand = Demand {
        allow_strain: allowed,
        ..Demand::default()
    };
    let pieces = unroll(&design, &demand).unwrap();
    let drawn = drawing(&design, &pieces).unwrap();
    assert!(
        drawn
            .notes()
            .iter()
            .any(|note| note.starts_with("not developable"))
    );
    assert!(
        drawn
            .texts()
            .iter()
            .any(|text| text.content.contains("strained"))
    );
}

#[test]
fn an_edge_of_regression_inside_is_told_and_refused() {
    let design = design(
        "families.cubic = { bernstein = [[0, 0, 1, 0], [0, -1, 1, 0], [1, -2, 1, 0], [3, -3, 1, 1]] }
         patches.torse = { tangent = \"cubic\", range = [-0.5, 1] }",
    );
    let report = inspect(&design).unwrap();
    assert_eq!(report.patches[0].regular, Assurance::No);
    let error = unroll(&design, &Demand::default()).unwrap_err();
    assert!(
        matches!(
            error,
            DesignError::Unroll {
                reason: PatternError::Regression { .. },
                ..
            }
        ),
        "{error}"
    );
}

#[test]
fn an_outline_that_crosses_itself_is_refused() {
    // Six quarters of a flat ring.
    let arc = |k: usize, r: &str| {
        let way = [[1, 0], [0, 1], [-1, 0], [0, -1]];
        let ([a, b], [c, d]) = (way[k % 4], way[(k + 1) % 4]);
        format!(
            "arc = {{ centre = [0, 0, 0], from = [\"{a}*{r}\", \"{b}*{r}\", 0], to = [\"{c}*{r}\", \"{d}*{r}\", 0] }}"
        )
    };
    let mut text = String::new();
    for k in 0..6 {
        let (inner, outer) = (arc(k, "10"), arc(k, "20"));
        text += &format!(
            "curves.i{k} = {{ {inner} }}\ncurves.o{k} = {{ {outer} }}\npatches.p{k} = {{ ruled = [\"i{k}\", \"o{k}\"] }}\n"
        );
    }
    text += "chains.ring = { patches = [\"p0\", \"p1\", \"p2\", \"p3\", \"p4\", \"p5\"] }\n";
    let error = unroll(&design(&text), &Demand::default()).unwrap_err();
    assert!(
        matches!(
            error,
            DesignError::Unroll {
                reason: PatternError::CrossesItself { .. },
                ..
            }
        ),
        "{error}"
    );
}

#[test]
fn a_continuation_has_the_beta_values_that_were_asked_for() {
    let design = design(
        "planes = { low = [0, 0, 1, 0], high = [0, 0, 1, 3] }
         families.f = { gbt = [[7, -7, 5, 125], [-7, -7, 5, 120], [-7, 7, 5, 130], [7, 7, 5, 125]], shape = [0.5, 0.25] }
         patches.a = { envelope = \"f\", between = [\"low\", \"high\"] }
         patches.b = { continues = \"a\", join = \"G2-beta\", beta = [\"3/2\", 0.3], free = [[7, -7, 5, 125]] }
         patches.c = { continues = \"a\", join = \"C2\", free = [[7, -7, 5, 125]] }
         chains.first = { patches = [\"a\", \"b\"], continuity = \"C1\" }",
    );
    let report = inspect(&design).unwrap();
    let joint = &report.joints[0];
    assert_eq!((joint.geometric, joint.parametric), (Some(2), Some(0)));
    assert!((joint.betas[0][0] - 1.5).abs() < 1e-9 && (joint.betas[0][1] - 0.3).abs() < 1e-9);
    assert!(joint.gap < 1e-9 && joint.kink < 1e-6);
    // C1 was wanted, and is not there.
    // The continuation ends beyond the start.
    assert_eq!(report.missed.len(), 2, "{:?}", report.missed);
    assert!(report.missed[1].starts_with("first passes through itself in space"));
    assert!(
        report.missed[0].starts_with("the joint of a and b is G2, C0, where C1 is wanted"),
        "{:?}",
        report.missed
    );
}

#[test]
fn patches_that_do_not_meet_are_told() {
    let design = design(
        "curves.a = { bezier = [[0, 0, 0], [10, 0, 0]] }
         curves.b = { bezier = [[0, 5, 0], [10, 5, 0]] }
         curves.c = { bezier = [[11, 0, 0], [20, 0, 0]] }
         curves.d = { bezier = [[11, 5, 0], [20, 5, 0]] }
         patches.p = { ruled = [\"a\", \"b\"] }
         patches.q = { ruled = [\"c\", \"d\"] }
         chains.all = { patches = [\"p\", \"q\"] }",
    );
    let report = inspect(&design).unwrap();
    assert_eq!(
        report.missed,
        ["p and q do not meet: 1.000000 mm apart, 0.001 allowed"]
    );
    assert!(unroll(&design, &Demand::default()).is_err());
}

#[test]
fn marks_lie_where_the_development_takes_them() {
    let text = "curves.rim = { arc = { centre = [0, 0, 0], from = [20, 0, 0], to = [0, 20, 0] } }
         patches.tube = { cylinder = \"rim\", direction = [0, 0, 30], marks = [
             { at = [0.5, 0.5], radius = 2 }, { at = [0.25, 0.2], radius = 1, hole = false },
             { line = [[0, 0], [1, 1]] }, { at = [0.5, 0.1], text = \"A\" } ] }";
    let design = design(text);
    let pieces = unroll(&design, &Demand::default()).unwrap();
    let drawn = drawing(&design, &pieces).unwrap();
    let on = |layer| {
        drawn
            .paths()
            .iter()
            .filter(move |path| path.layer() == layer)
    };
    let hole = on(Layer::Outline).nth(1).unwrap();
    // The middle of a sheet of 30 by 10 pi.
    let centre = [15.0, 5.0 * PI];
    for vertex in hole.vertices() {
        let [x, y] = vertex.point;
        assert!((libm::hypot(x - centre[0], y - centre[1]) - 2.0).abs() < 1e-9);
    }
    // A helix is straight.
    let line = on(Layer::Marks).nth(1).unwrap();
    assert_eq!(line.vertices().len(), 2);
    assert!((line.vertices()[1].point[1] - 10.0 * PI).abs() < 1e-9);
    let leaving = text.replace("radius = 2", "radius = 16");
    let design = read("x.toml", &leaving).unwrap();
    let pieces = unroll(&design, &Demand::default()).unwrap();
    assert!(matches!(
        drawing(&design, &pieces),
        Err(DesignError::Mark { .. })
    ));
}

#[test]
fn lines_may_touch_an_edge_of_regression_and_circles_may_not_cross_it() {
    // A tangent surface from its edge of regression, which is the rail at v = 0, to half a unit.
    let marked = |marks: &str| {
        design(&format!(
            "families.cubic = {{ bernstein = [[0, 0, 1, 0], [0, -1, 1, 0], [1, -2, 1, 0], [3, -3, 1, 1]] }}
             patches.tangents = {{ tangent = \"cubic\", range = [0, 0.5], marks = [{marks}] }}
             tolerances = {{ outline = 1e-4 }}"
        ))
    };
    let drawn = |marks: &str| {
        let design = marked(marks);
        let pieces = unroll(&design, &Demand::default()).unwrap();
        let flat = pieces[0].flat.clone();
        drawing(&design, &pieces).map(|drawing| (drawing, flat))
    };
    let lines = "{ line = [[0, 0], [1, 0]] }, { line = [[0.2, 1], [0.5, 0], [0.8, 1]] }";
    let (drawing, flat) = drawn(lines).unwrap();
    let marks = drawing
        .paths()
        .iter()
        .filter(|path| path.layer() == Layer::Marks);
    let marks: Vec<Vec<[f64; 2]>> = marks
        .map(|path| path.vertices().iter().map(|vertex| vertex.point).collect())
        .collect();
    let room = |p: &[f64; 2]| flat.outline().distance(*p);
    assert!(marks[0].len() > 4 && marks[0].iter().all(|p| room(p) < 2e-4));
    // The second begins and ends at the one rail and touches the other, the edge, once.
    let touching = marks[1].iter().map(|p| room(p) < 2e-4);
    let runs = touching.fold((0, false), |(runs, before), now| {
        (runs + u32::from(now && !before), now)
    });
    assert!(marks[1].len() > 4 && runs.0 == 3, "{runs:?}");
    for (what, cut) in [("hole", ""), ("circle", ", hole = false")] {
        let circle = |v: f64| format!("{{ at = [0.5, {v}], radius = 0.02{cut} }}");
        assert!(drawn(&circle(0.5)).is_ok());
        let Err(DesignError::Mark { patch, reason }) = drawn(&circle(0.0)) else {
            panic!("a {what} on the edge of regression")
        };
        assert!(
            patch == "tangents" && reason.contains(what) && reason.contains("leaves the sheet")
        );
    }
}

/// A quarter of a cone with these marks.
fn marked(marks: &str) -> Design {
    let text = format!(
        "[curves.rim]
         arc = {{ centre = [0, 0, 0], from = [60, 0, 0], to = [0, 60, 0] }}
         [patches.cone]
         cone = \"rim\"
         apex = [0, 0, 168]
         range = [1, 0.5]
         marks = [{marks}]"
    );
    read("x.toml", &text).unwrap_or_else(|e| panic!("{e:?}"))
}

#[test]
fn holes_that_overlap_and_lettering_beside_the_sheet_are_refused() {
    let drawn = |marks: &str| {
        let design = marked(marks);
        bytes(&design, "dxf", &Demand::default()).map_err(|e| e.to_string())
    };
    let hole = "{ at = [0.5, 0.5], radius = 8 }";
    assert!(drawn(hole).is_ok());
    assert!(drawn(&format!("{hole}, {{ at = [0.75, 0.5], radius = 2 }}")).is_ok());
    let overlap = drawn(&format!("{hole}, {{ at = [0.52, 0.5], radius = 8 }}")).unwrap_err();
    assert!(
        overlap.contains("overlaps the hole of radius 8 mm at [0.5, 0.5] by"),
        "{overlap}"
    );
    let beside = drawn("{ at = [1, 1], text = \"off the part\", height = 10 }").unwrap_err();
    assert!(beside.contains("leaves the sheet"), "{beside}");
    assert!(drawn("{ at = [0.5, 0.2], text = \"on it\", height = 6 }").is_ok());
}

#[test]
fn a_band_that_passes_through_itself_is_told_with_both_parameters() {
    let text = r#"
[curves.loop]
bezier = [[0, 0, 0], [140, 0, 90], [-40, 0, 90], [100, 0, 0]]
[patches.band]
cylinder = "loop"
direction = [0, 30, 0]
[sheet]
thickness = 1
"#;
    let design = read("x.toml", text).unwrap_or_else(|e| panic!("{e:?}"));
    let report = inspect(&design).unwrap();
    let reason = report
        .missed
        .iter()
        .find(|reason| reason.contains("passes through itself"))
        .unwrap_or_else(|| panic!("{:?}", report.missed));
    assert!(
        reason.contains("0.1938138") && reason.contains("0.8061862") && reason.contains("proved"),
        "{reason}"
    );
}

#[test]
fn a_hole_is_open_in_space_as_on_the_pattern() {
    let text = r#"
[curves.prof]
bezier = [[0, 0, 0], [30, 0, 45], [55, 0, -40], [90, 0, 12]]
[patches.wall]
cylinder = "prof"
direction = [0, 45, 0]
marks = [{ at = [0.5, 0.5], radius = 6 }]
"#;
    let flat = read("x.toml", text).unwrap_or_else(|e| panic!("{e:?}"));
    // By mpmath: the profile times 45, less the circle.
    let exact = 4_688.012_398;
    let summary = PatternSummary::new(&flat, &unroll(&flat, &Demand::default()).unwrap());
    let piece = &summary.pieces[0];
    assert!((piece.area - exact).abs() < 1e-3, "{}", piece.area);
    assert!((piece.cut - (303.38 + 37.70)).abs() < 0.01, "{}", piece.cut);
    let surface = mesh(&flat).unwrap();
    assert!((surface.area() - exact).abs() < 0.5, "{}", surface.area());
    let thick = format!("{text}[sheet]\nthickness = 1.2\n");
    let design = read("x.toml", &thick).unwrap_or_else(|e| panic!("{e:?}"));
    let solid = mesh(&design).unwrap();
    assert!(solid.is_watertight());
    assert!(
        (solid.volume() - 1.2 * exact).abs() < 1.0,
        "{}",
        solid.volume()
    );
    let step = bytes(&design, "step", &Demand::default()).unwrap();
    let step = String::from_utf8(step).unwrap();
    assert_eq!(step.matches("=FACE_BOUND(").count(), 1);
    // Marked near the joint of two patches, it is open in both.
    let halves = r#"
[curves.a]
bezier = [[0, 0, 0], [50, 0, 0]]
[curves.b]
bezier = [[50, 0, 0], [100, 0, 0]]
[patches.one]
cylinder = "a"
direction = [0, 40, 0]
marks = [{ at = [0.96, 0.5], radius = 6 }]
[patches.two]
cylinder = "b"
direction = [0, 40, 0]
[chains.plate]
patches = ["one", "two"]
"#;
    let design = read("x.toml", halves).unwrap_or_else(|e| panic!("{e:?}"));
    let open = mesh(&design).unwrap().area();
    assert!((open - (4_000.0 - 36.0 * PI)).abs() < 0.5, "{open}");
    assert!(bytes(&design, "step", &Demand::default()).is_err());
}
