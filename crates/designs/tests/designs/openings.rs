//! Openings of any closed curve: on the sheet, in space, and where another patch passes through.

use std::f64::consts::PI;
use torse_designs::export::{mesh, model};
use torse_designs::lint::{LintDemand, LintRules, lint};
use torse_designs::openings::{Opening, OpeningShape, openings};
use torse_designs::unroll::{
    CutOptions, Demand, Part, PartsList, PatternSummary, Purpose, parts, parts_with, unroll,
};
use torse_designs::{Design, DesignError, read};
use torse_exchange::{dxf, step};

/// A pipe of radius 50 along x in two halves, seams at the sides; curves, marks of its upper half, and patches.
fn pipe(curves: &str, marks: &str, patches: &str) -> Design {
    let text = format!(
        r#"
        [curves]
        upper = {{ arc = {{ centre = [-100, 0, 0], from = [-100, -50, 0], axis = [-1, 0, 0], angle = 180 }} }}
        lower = {{ arc = {{ centre = [-100, 0, 0], from = [-100, 50, 0], axis = [-1, 0, 0], angle = 180 }} }}
        {curves}
        [patches]
        upper = {{ cylinder = "upper", direction = [200, 0, 0], marks = [{marks}] }}
        lower = {{ cylinder = "lower", direction = [200, 0, 0] }}
        {patches}
        [chains]
        pipe = {{ patches = ["upper", "lower"], closed = true }}
        "#
    );
    read("pipe.toml", &text).unwrap_or_else(|e| panic!("{e:?}"))
}

const BRANCH: &str = r#"rim = { arc = { centre = [10, 0, 90], from = [30, 0, 90], axis = [0, 0, 1], angle = 360 } }"#;
const PASSING: &str = r#"branch = { cylinder = "rim", direction = [0, 0, -80] }"#;

fn found(design: &Design) -> Result<Vec<Opening>, DesignError> {
    let demand = Demand {
        only: Some("pipe".to_owned()),
        ..Demand::default()
    };
    let pieces = unroll(design, &demand)?;
    openings(design, &pieces[0].piece, &pieces[0].flat)
}

fn made(design: &Design, making: CutOptions) -> Result<Part, DesignError> {
    let demand = Demand {
        only: Some("pipe".to_owned()),
        ..Demand::default()
    };
    Ok(parts_with(design, &unroll(design, &demand)?, making)?.remove(0))
}

fn refusal(design: &Design) -> String {
    made(design, CutOptions::default()).unwrap_err().to_string()
}

/// The mean of a periodic function times its period: exact but for rounding.
fn around(f: impl Fn(f64) -> f64) -> f64 {
    let steps = 256;
    let sum: f64 = (0..steps)
        .map(|k| f(2.0 * PI * f64::from(k) / f64::from(steps)))
        .sum();
    sum * 2.0 * PI / f64::from(steps)
}

#[test]
fn the_saddle_of_two_cylinders_is_the_curve_of_the_textbooks() {
    let design = pipe(BRANCH, "{ passes = \"branch\" }", PASSING);
    let found = found(&design).unwrap();
    let [saddle] = found.as_slice() else {
        panic!("{found:?}")
    };
    let OpeningShape::Contour(segments) = &saddle.shape else {
        panic!()
    };
    assert!(saddle.proved && saddle.error <= 0.01, "{}", saddle.error);
    // Unrolled: x = r cos t along the pipe, y = R asin(r/R sin t) around it, about the middle of the contour.
    let (big, small) = (50.0, 20.0);
    let [mx, my] = saddle.shape.middle();
    let exact = |t: f64| {
        [
            small * libm::cos(t),
            big * libm::asin(small / big * libm::sin(t)),
        ]
    };
    // Which way the pattern lies is found by its box: 40 along the pipe, more around it.
    let [low, high] = saddle.shape.bounds();
    let [width, height] = [high[0] - low[0], high[1] - low[1]];
    let tall = 2.0 * big * libm::asin(small / big);
    let along_x = (width - 2.0 * small).abs() < 0.02;
    assert!(
        along_x && (height - tall).abs() < 0.02
            || (width - tall).abs() < 0.02 && (height - 40.0).abs() < 0.02
    );
    let place = |[a, b]: [f64; 2]| {
        if along_x {
            [mx + a, my + b]
        } else {
            [mx + b, my + a]
        }
    };
    for k in 0..720 {
        let point = place(exact(2.0 * PI * f64::from(k) / 720.0));
        let near = segments.iter().map(|segment| segment.distance(point));
        let near = near.fold(f64::INFINITY, f64::min);
        // The middle of the box is off by as much as the contour is.
        assert!(near <= 2.0 * saddle.error, "{near} {}", saddle.error);
    }
    // And the other way: each point of the contour is on the curve.
    let curve: Vec<[f64; 2]> = (0..20_000)
        .map(|k| place(exact(2.0 * PI * f64::from(k) / 2e4)))
        .collect();
    for segment in segments {
        for k in 0..5 {
            let [x, y] = segment.point(0.2 * f64::from(k));
            let near = curve.iter().map(|[a, b]| libm::hypot(x - a, y - b));
            let near = near.fold(f64::INFINITY, f64::min);
            assert!(near <= 2.0 * saddle.error + 4e-3, "{near}");
        }
    }
    // Its area by the theorem of Green, its length by the speed.
    let k = small / big;
    let root = |t: f64| (1.0 - (k * libm::sin(t)).powi(2)).sqrt();
    let area = around(|t| small * small * libm::cos(t).powi(2) / root(t));
    let length = around(|t| small * libm::hypot(libm::sin(t), libm::cos(t) / root(t)));
    let off = (saddle.shape.area() - area).abs();
    assert!(off <= saddle.error * length, "{off} {area}");
    assert!(
        (saddle.shape.length() - length).abs() < 0.05,
        "{} {length}",
        saddle.shape.length()
    );
    // Few arcs, no fine polygon.
    assert!(segments.len() <= 48, "{}", segments.len());
    let part = made(&design, CutOptions::default()).unwrap();
    assert!((part.area() - (PI * 100.0 * 200.0 - area)).abs() < 1.0);
    assert!((part.cut_length() - (2.0 * (200.0 + PI * 100.0) + length)).abs() < 0.1);
    let summary = PatternSummary::new(&design, &unroll(&design, &Demand::default()).unwrap());
    let pipe = summary
        .pieces
        .iter()
        .find(|piece| piece.name == "pipe")
        .unwrap();
    assert!((pipe.area - part.area()).abs() < 1.0 && (pipe.cut - part.cut_length()).abs() < 0.1);
    // The bound of the area holds with the opening, of which it is the larger part.
    let off = (pipe.area - (PI * 100.0 * 200.0 - area)).abs();
    let room = 2.0 * saddle.error * length;
    assert!(off <= pipe.area_error && pipe.area_error >= room && pipe.area_error < 2.0 * room);
}

#[test]
fn what_is_open_on_the_pattern_is_open_in_cut_files_meshes_and_step() {
    let design = pipe(BRANCH, "{ passes = \"branch\" }", PASSING);
    let whole = pipe(BRANCH, "", PASSING);
    let open = found(&design).unwrap()[0].shape.area();
    let difference = mesh(&whole).unwrap().area() - mesh(&design).unwrap().area();
    assert!((difference - open).abs() < 1.0, "{difference} {open}");
    let part = made(&design, CutOptions::default()).unwrap();
    let cut = dxf(&part.drawing(Purpose::Cut).unwrap()).unwrap();
    let rules = LintRules::published().unwrap();
    let demand = LintDemand {
        thickness: Some(1.0),
        unit: None,
    };
    let judged = lint("pipe.dxf", cut.as_bytes(), &rules, &demand).unwrap();
    assert!(judged.passes(), "{}", judged.text());
    assert_eq!(cut.matches("LWPOLYLINE").count(), 2, "{cut}");
    let text = step(&model(&design).unwrap()).unwrap();
    assert_eq!(text.matches("FACE_BOUND(").count(), 1);
    assert_eq!(
        step(&model(&whole).unwrap())
            .unwrap()
            .matches("FACE_BOUND(")
            .count(),
        0
    );
}

#[test]
fn what_passes_both_walls_opens_both() {
    let through = r#"branch = { cylinder = "rim", direction = [0, 0, -180] }"#;
    let design = pipe(BRANCH, "{ passes = \"branch\" }", through);
    let found = found(&design).unwrap();
    assert_eq!(found.len(), 2);
    assert!((found[0].shape.area() - found[1].shape.area()).abs() < 0.5);
}

#[test]
fn a_curve_on_the_sheet_is_cut_as_it_is_drawn() {
    let slot = "slot = { row = [\"a\", \"b\", \"c\", \"d\"] }";
    let parts = "a = { bezier = [[-10, -4, 0], [10, -4, 0]] }
        b = { arc = { centre = [10, 0, 0], from = [10, -4, 0], axis = [0, 0, 1], angle = 180 } }
        c = { bezier = [[10, 4, 0], [-10, 4, 0]] }
        d = { arc = { centre = [-10, 0, 0], from = [-10, 4, 0], axis = [0, 0, 1], angle = 180 } }";
    let design = pipe(
        &format!("{parts}\n{slot}"),
        "{ opening = \"slot\", at = [0.5, 0.5], angle = 30 }",
        "",
    );
    let found = found(&design).unwrap();
    let shape = &found[0].shape;
    assert!(
        (shape.area() - (160.0 + 16.0 * PI)).abs() < 8e-3 * 66.0,
        "{}",
        shape.area()
    );
    let OpeningShape::Contour(segments) = shape else {
        panic!()
    };
    assert_eq!(segments.len(), 4, "{segments:?}");
    // Turned by 30 degrees against the rulings, which run along the first axis or across it.
    let line = segments.iter().find(|segment| segment.is_line()).unwrap();
    let way = libm::atan2(line.to[1] - line.from[1], line.to[0] - line.from[0]);
    let turned = libm::fmod(way + 4.0 * PI, 0.5 * PI).to_degrees();
    assert!(
        (turned - 30.0).abs() < 0.1 || (turned - 60.0).abs() < 0.1,
        "{turned}"
    );
}

#[test]
fn a_polygon_on_the_parameters_is_straight_where_the_rulings_are() {
    let design = pipe(
        "",
        "{ opening = [[0.4, 0.25], [0.6, 0.25], [0.6, 0.75], [0.4, 0.75]] }",
        "",
    );
    let found = found(&design).unwrap();
    // A fifth of the half circle, half of the length.
    let area = 0.2 * 50.0 * PI * 100.0;
    assert!(
        (found[0].shape.area() - area).abs() < 1e-6,
        "{}",
        found[0].shape.area()
    );
    let OpeningShape::Contour(segments) = &found[0].shape else {
        panic!()
    };
    assert_eq!(segments.len(), 4);
}

#[test]
fn a_curve_in_space_lies_on_the_sheet_or_is_thrown_on_it() {
    // A helix and back does not close; a circle around the pipe's side does: thrown on it from above.
    let above = "ring = { arc = { centre = [0, 0, 200], from = [20, 0, 200], axis = [0, 0, 1], angle = 360 } }";
    let thrown = pipe(above, "{ opening = \"ring\", along = [0, 0, -3] }", "");
    let passed = pipe(
        &above.replace("200", "90"),
        "{ passes = \"branch\" }",
        r#"branch = { cylinder = "ring", direction = [0, 0, -80] }"#,
    );
    let [one, other] = [&thrown, &passed].map(|design| found(design).unwrap());
    // Of the far wall nothing: it comes second.
    assert_eq!((one.len(), other.len()), (1, 1));
    assert!((one[0].shape.area() - other[0].shape.area()).abs() < 0.1);
    // Four sides on the pipe: two rulings and two quarters of circles.
    let lying = "
        one = { arc = { centre = [-20, 0, 0], from = [-20, -30, 40], axis = [-1, 0, 0], angle = 73.73979529168804 } }
        two = { bezier = [[-20, 30, 40], [20, 30, 40]] }
        three = { arc = { centre = [20, 0, 0], from = [20, 30, 40], axis = [1, 0, 0], angle = 73.73979529168804 } }
        four = { bezier = [[20, -30, 40], [-20, -30, 40]] }
        ring = { row = [\"one\", \"two\", \"three\", \"four\"] }";
    let design = pipe(lying, "{ opening = \"ring\" }", "");
    let found = found(&design).unwrap();
    let area = 40.0 * 50.0 * 2.0 * libm::asin(0.6);
    assert!(
        (found[0].shape.area() - area).abs() < 1e-3,
        "{} {area}",
        found[0].shape.area()
    );
}

#[test]
fn openings_that_leave_the_sheet_or_meet_are_refused_with_place() {
    let square = |at: &str| format!("{{ opening = \"square\", at = {at} }}");
    let curve =
        "square = { polyline = [[-8, -8, 0], [8, -8, 0], [8, 8, 0], [-8, 8, 0], [-8, -8, 0]] }";
    let with = |marks: &str| pipe(curve, marks, "");
    assert!(made(&with(&square("[0.5, 0.5]")), CutOptions::default()).is_ok());
    let edge = refusal(&with(&square("[0.5, 0.97]")));
    assert!(
        edge.contains("the opening `square` at [0.5, 0.97] leaves the sheet near"),
        "{edge}"
    );
    let seam = refusal(&with(&square("[0.02, 0.5]")));
    assert!(seam.contains("leaves the sheet"), "{seam}");
    let both = refusal(&with(&format!(
        "{}, {}",
        square("[0.5, 0.5]"),
        square("[0.55, 0.52]")
    )));
    assert!(
        both.contains("meets the opening `square` at [0.5, 0.5] near ["),
        "{both}"
    );
    let round = refusal(&with(&format!(
        "{}, {{ at = [0.5, 0.54], radius = 5 }}",
        square("[0.5, 0.5]")
    )));
    assert!(round.contains("meets"), "{round}");
    let within = refusal(&with(&format!(
        "{}, {{ at = [0.5, 0.5], radius = 2 }}",
        square("[0.5, 0.5]")
    )));
    assert!(within.contains("lie one within the other"), "{within}");
    let eight = refusal(&pipe(
        "square = { polyline = [[-8, -8, 0], [8, 8, 0], [8, -8, 0], [-8, 12, 0], [-8, -8, 0]] }",
        &square("[0.5, 0.5]"),
        "",
    ));
    assert!(eight.contains("crosses itself at ["), "{eight}");
}

#[test]
fn what_does_not_pass_is_refused_with_its_reason() {
    let passing = |rim: &str, direction: &str| {
        refusal(&pipe(
            rim,
            "{ passes = \"branch\" }",
            &format!("branch = {{ cylinder = \"rim\", direction = {direction} }}"),
        ))
    };
    // Beside the pipe, too short, over its end, wider than it.
    let far = BRANCH.replace(
        "[10, 0, 90], from = [30, 0, 90]",
        "[10, 200, 90], from = [30, 200, 90]",
    );
    assert!(passing(&far, "[0, 0, -80]").contains("meets no point of the sheet"));
    assert!(passing(BRANCH, "[0, 0, -30]").contains("ends before"));
    let over = BRANCH.replace(
        "[10, 0, 90], from = [30, 0, 90]",
        "[90, 0, 90], from = [110, 0, 90]",
    );
    let over = passing(&over, "[0, 0, -80]");
    assert!(over.contains("leaves the sheet at ("), "{over}");
    // One that ends with the pipe, or a hair beyond it, is not cut short.
    for hair in ["", ".00000001", ".0001"] {
        let centre = format!("[80{hair}, 0, 90], from = [100{hair}, 0, 90]");
        let touching = BRANCH.replace("[10, 0, 90], from = [30, 0, 90]", &centre);
        let touching = passing(&touching, "[0, 0, -80]");
        assert!(
            touching.contains("leaves the sheet") || touching.contains("of the edge of the sheet"),
            "{touching}"
        );
    }
    let wide = BRANCH.replace("from = [30, 0, 90]", "from = [70, 0, 90]");
    let wide = passing(&wide, "[0, 0, -80]");
    assert!(wide.contains("cannot be cut"), "{wide}");
    // A half pipe does not close.
    let half = BRANCH.replace("angle = 360", "angle = 90");
    let half = passing(&half, "[0, 0, -80]");
    assert!(half.contains("does not close"), "{half}");
}

#[test]
fn a_kerf_makes_openings_of_any_shape_narrower() {
    let curve =
        "square = { polyline = [[-8, -8, 0], [8, -8, 0], [8, 8, 0], [-8, 8, 0], [-8, -8, 0]] }";
    let design = pipe(curve, "{ opening = \"square\", at = [0.5, 0.5] }", "");
    let making = |kerf: f64| CutOptions { kerf, grain: None };
    let part = made(&design, making(0.4)).unwrap();
    assert!((part.openings[0].shape.area() - 15.6 * 15.6).abs() < 1e-6);
    assert!(
        made(&design, making(16.5))
            .unwrap_err()
            .to_string()
            .contains("kerf")
    );
}

#[test]
fn an_opening_over_the_joint_of_two_patches_is_one_on_the_pattern_and_open_in_the_mesh() {
    // A branch from the side where both halves meet: y = 50.
    let side = "rim = { arc = { centre = [0, 90, 0], from = [15, 90, 0], axis = [0, -1, 0], angle = 360 } }";
    let patches = "branch = { cylinder = \"rim\", direction = [0, -80, 0] }";
    let design = pipe(side, "{ passes = \"branch\" }", patches);
    let found = found(&design).unwrap();
    let k = 15.0 / 50.0;
    let area = around(|t| 225.0 * libm::cos(t).powi(2) / (1.0 - (k * libm::sin(t)).powi(2)).sqrt());
    assert_eq!(found.len(), 1);
    assert!(
        (found[0].shape.area() - area).abs() < 0.5,
        "{} {area}",
        found[0].shape.area()
    );
    let whole = pipe(side, "", patches);
    let difference = mesh(&whole).unwrap().area() - mesh(&design).unwrap().area();
    assert!((difference - area).abs() < 1.0, "{difference} {area}");
    let error = model(&design).unwrap_err().to_string();
    assert!(error.contains("over a joint of faces"), "{error}");
}

#[test]
fn marks_that_make_no_opening_are_refused_where_they_stand() {
    let wrong = |marks: &str| {
        let text = format!(
            "[curves]\na = {{ bezier = [[0, 0, 0], [60, 0, 0]] }}\nb = {{ bezier = [[0, 40, 0], [60, 40, 0]] }}\n\
             bow = {{ polyline = [[0, 0, 0], [5, 0, 0], [5, 5, 0]] }}\n\
             tilted = {{ polyline = [[0, 0, 0], [5, 0, 0], [5, 5, 3], [0, 0, 0]] }}\n\
             [patches.plate]\nruled = [\"a\", \"b\"]\nmarks = [{marks}]\n"
        );
        let Err(DesignError::Wrong { mistakes }) = read("x.toml", &text) else {
            panic!("{marks}")
        };
        mistakes[0].to_string()
    };
    for (marks, message) in [
        ("{ opening = \"bow\", at = [0.5, 0.5] }", "does not close"),
        (
            "{ opening = \"tilted\", at = [0.5, 0.5] }",
            "does not lie in the plane z = 0",
        ),
        (
            "{ opening = \"a\", at = [0.5, 0.5], along = [0, 0, 1] }",
            "placed in one way",
        ),
        ("{ opening = \"none\" }", "no curve above is called `none`"),
        (
            "{ passes = \"plat\" }",
            "no patch and no chain is called `plat`",
        ),
        ("{ passes = \"plate\" }", "does not pass through"),
        ("{ opening = [[0.1, 0.1], [0.2, 0.2]] }", "at least 3"),
        (
            "{ opening = \"a\", radius = 3 }",
            "means nothing for an opening",
        ),
    ] {
        let told = wrong(marks);
        assert!(told.contains(message), "{marks}: {told}");
    }
}

#[test]
fn an_opening_of_lines_and_arcs_is_as_long_as_its_sides() {
    let design = read(
        "plate.toml",
        "[curves]\na = { bezier = [[0, 0, 0], [60, 0, 0]] }\nb = { bezier = [[0, 40, 0], [60, 40, 0]] }\n\
         wave = { spline = { degree = 3, closed = true, points = [[8, 0, 0], [0, 8, 0], [-8, 0, 0], [0, -8, 0]] } }\n\
         [patches.plate]\nruled = [\"a\", \"b\"]\nmarks = [{ opening = \"wave\", at = [0.5, 0.5] }]\n",
    )
    .unwrap();
    let pieces = unroll(&design, &Demand::default()).unwrap();
    let part = parts(&design, &pieces).unwrap().remove(0);
    // The uniform cubic B-spline over a square of half diagonal 8: its area is 8^2 (11/15 + ..) by its pieces.
    let opening = &part.openings[0];
    let point = |k: i32, t: f64| -> [f64; 2] {
        let corner =
            |k: i32| [[8.0, 0.0], [0.0, 8.0], [-8.0, 0.0], [0.0, -8.0]][k.rem_euclid(4) as usize];
        let weights = [
            (1.0 - t).powi(3) / 6.0,
            (3.0 * t.powi(3) - 6.0 * t * t + 4.0) / 6.0,
            (-3.0 * t.powi(3) + 3.0 * t * t + 3.0 * t + 1.0) / 6.0,
            t.powi(3) / 6.0,
        ];
        std::array::from_fn(|i| (0..4).map(|j| weights[j] * corner(k + j as i32)[i]).sum())
    };
    let points: Vec<[f64; 2]> = (0..4)
        .flat_map(|k| (0..2000).map(move |i| (k, f64::from(i) / 2000.0)))
        .map(|(k, t)| point(k, t))
        .collect();
    let next = points.iter().cycle().skip(1);
    let (mut area, mut length) = (0.0, 0.0);
    for (a, b) in points.iter().zip(next) {
        area += 0.5 * (a[0] * b[1] - a[1] * b[0]);
        length += libm::hypot(b[0] - a[0], b[1] - a[1]);
    }
    assert!((opening.shape.area() - area).abs() <= opening.error * length + 1e-4);
    assert!((opening.shape.length() - length).abs() < 0.02);
    assert!(opening.error <= 0.01);
}

#[test]
fn an_opening_of_a_sheet_that_is_only_nearly_developable_is_measured() {
    let plank = |lift: f64| {
        let text = format!(
            r#"
            [curves]
            a = {{ bezier = [[0, 0, 0], [300, 0, 0]] }}
            b = {{ bezier = [[0, 80, 0], [300, 80, {lift}]] }}
            [patches.plank]
            ruled = ["a", "b"]
            marks = [{{ opening = [[0.4, 0.3], [0.6, 0.3], [0.5, 0.7]] }}]
            "#
        );
        let design = read("plank.toml", &text).unwrap();
        let demand = Demand {
            allow_strain: 0.1,
            ..Demand::default()
        };
        let pieces = unroll(&design, &demand).unwrap();
        let parts = parts(&design, &pieces).unwrap();
        let text = PartsList::new(&design, &parts).text(&PatternSummary::new(&design, &pieces));
        let text = text.split_whitespace().collect::<Vec<_>>().join(" ");
        (parts[0].proved, text, parts[0].notes.join("; "))
    };
    let (flat, twisted) = (plank(0.0), plank(1.0));
    assert!(flat.0 && !flat.1.contains("measured") && !flat.2.contains("measured"));
    assert!(!twisted.0 && twisted.1.contains("(measured, not"));
    assert!(
        twisted
            .2
            .contains("of the exact part, measured, not proved")
    );
}
