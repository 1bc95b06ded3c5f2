//! Curves of any shape, imported ones too, and patches over several pieces.

use torse_designs::inspect::{Assurance, inspect};
use torse_designs::unroll::{Demand, unroll};
use torse_designs::{Design, DesignError, read, read_with};
use torse_geometry::curve::{Spacing, interpolate_closed};
use torse_geometry::prelude::PiecewiseRail;

fn design(text: &str) -> Design {
    read("part.toml", text).unwrap_or_else(|error| panic!("{error}: {}", mistakes(&error)))
}

fn mistakes(error: &DesignError) -> String {
    match error {
        DesignError::Wrong { mistakes } => mistakes.iter().map(|m| format!("{m}\n")).collect(),
        other => other.to_string(),
    }
}

fn refused(text: &str) -> String {
    mistakes(&read("part.toml", text).unwrap_err())
}

#[test]
fn a_cylinder_over_a_closed_spline_is_one_strip() {
    let part = design(
        r#"
        [curves.rim]
        through = [[30, 0, 0], [0, 20, 0], [-30, 0, 0], [0, -25, 0]]
        ends = "closed"
        [patches.skirt]
        cylinder = "rim"
        direction = [0, 0, 10]
        marks = [{ at = [0.6, 0.5], radius = 1 }, { line = [[0.1, 0.5], [0.9, 0.5]] }]
    "#,
    );
    assert_eq!(part.patches.len(), 4);
    assert_eq!(
        (part.chains[0].name.as_str(), part.chains[0].closed),
        ("skirt", true)
    );
    let points = [
        [30.0, 0.0, 0.0],
        [0.0, 20.0, 0.0],
        [-30.0, 0.0, 0.0],
        [0.0, -25.0, 0.0],
    ];
    let ring = interpolate_closed(&points, Spacing::Chord).unwrap().spline;
    let length = PiecewiseRail::spline(&ring).unwrap().length(1e-9).unwrap();
    let report = inspect(&part).unwrap();
    assert!(report.missed.is_empty(), "{:?}", report.missed);
    // C2 by construction: nothing kinks at the joints, the last one included.
    assert_eq!(report.joints.len(), 4);
    assert!(
        report
            .joints
            .iter()
            .all(|joint| joint.kink < 1e-6 && joint.gap < 1e-9)
    );
    let flat = unroll(&part, &Demand::default()).unwrap();
    assert_eq!(flat.len(), 1);
    assert!(
        (flat[0].flat.area() - 10.0 * length).abs() < 1e-4,
        "{} {length}",
        flat[0].flat.area()
    );
    assert_eq!(
        part.patches
            .iter()
            .map(|patch| patch.marks.len())
            .sum::<usize>(),
        5
    );
}

#[test]
fn a_cone_over_an_arc_of_any_angle_is_a_sector() {
    let part = design(
        r#"
        [curves.rim]
        arc = { centre = [0, 0, 0], axis = [0, 0, 1], from = [30, 0, 0], angle = 250 }
        [patches.cone]
        cone = "rim"
        apex = [0, 0, 40]
        range = [1, 0.5]
    "#,
    );
    let flat = unroll(&part, &Demand::default()).unwrap();
    let exact = 250.0_f64.to_radians() * (30.0 * 50.0 - 15.0 * 25.0) / 2.0;
    assert!(
        (flat[0].flat.area() - exact).abs() < 1e-3,
        "{} {exact}",
        flat[0].flat.area()
    );
    let report = inspect(&part).unwrap();
    assert!(report.missed.is_empty(), "{:?}", report.missed);
}

#[test]
fn a_patch_between_polygons_is_flat_pieces_in_a_row() {
    let part = design(
        r#"
        [curves.low]
        polyline = [[0, 0, 0], [10, 0, 0], [10, 20, 0], [40, 20, 0]]
        [curves.high]
        copy = "low"
        move = [0, 0, 5]
        [patches.wall]
        ruled = ["low", "high"]
        part = [0.0, 0.5]
    "#,
    );
    // 60 mm of wall, cut at 30: on the corner.
    assert_eq!(part.patches.len(), 2);
    let flat = unroll(&part, &Demand::default()).unwrap();
    assert!(
        (flat[0].flat.area() - 150.0).abs() < 1e-6,
        "{}",
        flat[0].flat.area()
    );
    assert_eq!(part.patches[0].name, "wall.1");
}

#[test]
fn curves_are_placed_in_the_stated_order() {
    let ends = |placed: &str| {
        let part = design(&format!(
            "[curves.a]\nbezier = [[1, 0, 0], [2, 0, 0]]\n{placed}\n[curves.b]\nbezier = [[0, 0, 50], [0, 9, 50]]\n[patches.p]\nruled = [\"a\", \"b\"]\n"
        ));
        [0.0, 1.0].map(|u| part.patches[0].sheet.point(u, 0.0).unwrap())
    };
    assert_eq!(
        ends("reversed = true\nscale = 3"),
        [[6.0, 0.0, 0.0], [3.0, 0.0, 0.0]]
    );
    assert_eq!(
        ends("rotate = { angle = 90 }\nmove = [0, 0, 1]"),
        [[0.0, 1.0, 1.0], [0.0, 2.0, 1.0]]
    );
    assert_eq!(
        ends("mirror = [1, 0, 0, 5]"),
        [[9.0, 0.0, 0.0], [8.0, 0.0, 0.0]]
    );
    assert_eq!(
        ends("section = [0.5, 1]\nscale = { about = [2, 0, 0], by = 2 }"),
        [[1.0, 0.0, 0.0], [2.0, 0.0, 0.0]]
    );
}

#[test]
fn a_spline_keeps_its_decimals_and_its_pieces_are_exact() {
    let part = design(
        r#"
        [curves.low]
        spline = { degree = 2, points = [[0, 0, 0], [0.1, 1, 0], [2, 1, 0], [3, 0, 0]], knots = [0, 0, 0, 0.3, 1, 1, 1] }
        [curves.high]
        spline = { degree = 2, points = [[0, 0, 1], [0.1, 1, 1], [2, 1, 1], [3, 0, 1]], knots = [0, 0, 0, 0.3, 1, 1, 1] }
        [patches.wall]
        ruled = ["low", "high"]
    "#,
    );
    assert_eq!(part.patches.len(), 2);
    // The joint is 0.7 of the way back from the second to the third control point: 0.1 + 0.3 1.9, with one rounding.
    assert_eq!(
        part.patches[0].sheet.point(1.0, 0.0).unwrap(),
        [0.67, 1.0, 0.0]
    );
    assert_eq!(
        part.patches[1].sheet.point(0.0, 0.0).unwrap(),
        [0.67, 1.0, 0.0]
    );
}

#[test]
fn imported_rails_make_a_part() {
    let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/../exchange/tests/files");
    let mut files =
        |name: &str| std::fs::read(format!("{folder}/{name}")).map_err(|e| e.to_string());
    let text = |low: &str, high: &str| {
        format!(
            "[curves.low]\nimport = \"{low}\"\n[curves.high]\nimport = \"{high}\"\n[patches.side]\nruled = [\"low\", \"high\"]\n[tolerances]\ntwist = 30\nstrain = 0.1\n"
        )
    };
    for (low, high, pieces) in [
        ("rails_spline.dxf#CHINE", "rails_spline.dxf#SHEER", 5),
        ("rails.step#38", "rails.step#68", 5),
        ("rails.svg#path", "rails.svg#path.2", 1),
        ("offsets.csv", "rails_poly.dxf#polyline.2", 5),
    ] {
        let part = read_with("side.toml", &text(low, high), &mut files);
        let part = part.unwrap_or_else(|error| panic!("{low}: {}", mistakes(&error)));
        assert_eq!(part.patches.len(), pieces, "{low}");
        let demand = Demand {
            allow_strain: 0.2,
            ..Demand::default()
        };
        let flat = unroll(&part, &demand).unwrap();
        assert_eq!(flat.len(), 1, "{low}: one pattern of several pieces");
    }
    let mut message = |low: &str| {
        mistakes(&read_with("side.toml", &text(low, "offsets.csv"), &mut files).unwrap_err())
    };
    assert!(message("rails_spline.dxf#KEEL").contains("rails_spline.dxf has no curve `KEEL`"));
    assert!(message("rails_spline.dxf").contains("rails_spline.dxf has 2 curves: which one?"));
    assert!(message("cone.obj").contains("cone.obj has 0 curves"));
    assert!(message("nothing.dxf").contains("nothing.dxf: "));
    let inches = text("rails.step#38", "rails.step#68").replace("#38\"", "#38\"\nunit = \"in\"");
    let error = mistakes(&read_with("side.toml", &inches, &mut files).unwrap_err());
    assert!(
        error.contains("the file states mm as its unit of length, and in was given"),
        "{error}"
    );
    let spaced =
        text("rails.step#38", "offsets.csv").replace("#38\"", "#38\"\nspacing = \"uniform\"");
    let error = mistakes(&read_with("side.toml", &spaced, &mut files).unwrap_err());
    assert!(error.contains("has its own ends and spacing"), "{error}");
}

#[test]
fn what_is_no_curve_is_told() {
    let curve = |text: &str| {
        refused(&format!(
            "[curves.a]\n{text}\n[patches.p]\ncylinder = \"a\"\ndirection = [0, 0, 1]\n"
        ))
    };
    for (text, message) in [
        (
            "spline = { points = [[0, 0, 0], [1, 0, 0]] }",
            "control points of a spline: 2 given, at least 4 needed",
        ),
        (
            "spline = { degree = 1, points = [[0, 0, 0], [1, 0, 0]], weights = [1, 0] }",
            "weight 1 is 0",
        ),
        (
            "through = [[0, 0, 0], [0, 0, 0]]",
            "two neighbours at one place",
        ),
        (
            "through = [[0, 0, 0], [1, 0, 0]]\nends = \"closed\"",
            "at least 3 needed",
        ),
        (
            "polyline = [[0, 0, 0], [1, 0, 0]]\nspacing = \"chord\"",
            "`spacing` means nothing for this curve",
        ),
        ("import = \"a.dxf#b\"", "no files are read here"),
        (
            "arc = { centre = [0, 0, 0], from = [1, 0, 0] }",
            "an arc has a centre and two ends",
        ),
        (
            "arc = { centre = [0, 0, 0], from = [1, 0, 0], axis = [0, 0, 1] }",
            "lacks its `angle`",
        ),
        ("copy = \"b\"", "no curve above is called `b`"),
        (
            "bezier = [[0, 0, 0], [1, 0, 0]]\nscale = -1",
            "-1 is outside",
        ),
    ] {
        let error = curve(text);
        assert!(error.contains(message), "{text}: {error}");
    }
    let row = refused(
        "[curves.a]\nbezier = [[0, 0, 0], [1, 0, 0]]\n[curves.b]\nbezier = [[2, 0, 0], [3, 0, 0]]\n[curves.c]\nrow = [\"a\", \"b\"]\n[patches.p]\ncylinder = \"a\"\ndirection = [0, 0, 1]\n",
    );
    assert!(row.contains("do not meet: 1.000000 mm apart"), "{row}");
}

#[test]
fn fold_reads_patterns_in_the_unit_that_they_state() {
    let hopper = r#"
        [let]
        r = 60
        h = "2*r"
        wall = 80
        [points]
        apex = [0, 0, "h"]
        corner = [0, "r", 0]
        end = ["-wall", "r", 0]
        top = [0, "r/2", "h/2"]
        top-end = ["-wall", "r/2", "h/2"]
        [curves]
        rim = { arc = { centre = [0, 0, 0], from = ["r", 0, 0], to = "corner" } }
        low = { bezier = ["corner", "end"] }
        high = { bezier = ["top", "top-end"] }
        [patches.cone]
        cone = "rim"
        apex = "apex"
        range = [1, 0.5]
        [patches.wall]
        ruled = ["low", "high"]
        [chains.hopper]
        patches = ["cone", "wall"]
    "#;
    let part = design(hopper);
    // Written by another program, in inches.
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/tests/files/hopper-inch.dxf");
    let pattern = std::fs::read_to_string(path).unwrap();
    let folded = torse_designs::fold::fold_text(&part, "hopper-inch.dxf", &pattern).unwrap();
    assert!(folded.missed.is_empty(), "{:?}", folded.missed);
    let own = torse_designs::export::bytes(&part, "svg", &Demand::default()).unwrap();
    let own = String::from_utf8(own).unwrap();
    let folded = |text: &str| torse_designs::fold::fold_text(&part, "hopper.svg", text).unwrap();
    assert!(folded(&own).missed.is_empty());
    let (head, rest) = own.split_once("mm\" viewBox").unwrap();
    let (first, height) = head.split_once("mm\" height").unwrap();
    let inches = format!("{first}in\" height{height}in\" viewBox{rest}");
    assert!(!folded(&inches).missed.is_empty());
}

#[test]
fn a_quarter_of_an_ellipse_is_cut_exactly() {
    let part = |section: &str| {
        let text = format!(
            "[curves]\nq = {{ arc = {{ centre = [1, 0, 0], from = [31, 0, 0], to = [1, 20, 5] }}, section = {section} }}\n\
             [patches.wall]\ncylinder = \"q\"\ndirection = [0, 0, 40]\n"
        );
        design(&text).patches.remove(0).sheet
    };
    let (whole, middle) = (part("[0, 1]"), part("[0.25, 0.75]"));
    for k in 0..=8 {
        let x = f64::from(k) / 8.0;
        let (here, there) = (middle.point(x, 0.0), whole.point(0.25 + 0.5 * x, 0.0));
        let (here, there) = (here.unwrap(), there.unwrap());
        assert!(here.iter().zip(&there).all(|(a, b)| (a - b).abs() < 1e-13));
    }
    // A row with straight sides is cut where the arc begins and ends.
    let ruled = design(
        "[curves]\nrect = { polyline = [[0, -60, 0], [70, -60, 0], [70, 0, 0]] }\n\
         pipe = { arc = { centre = [0, 0, 80], from = [0, -40, 80], to = [40, 0, 80] } }\n\
         [patches.side]\nruled = [\"rect\", \"pipe\"]\n",
    );
    assert_eq!(ruled.patches.len(), 2);
    let other = "[curves]\ng = { gbt = [[0, 0, 0], [1, 2, 0], [3, 0, 0]], shape = [0.5, 0], section = [0, 0.5] }\n";
    assert!(refused(other).contains("no control points"));
}

#[test]
fn weights_and_points_are_the_decimals_of_the_text() {
    // b = apex + (a - apex)/2 with the same weights: a cone for every weight. No double is 0.7, and no product of one.
    for weight in ["0.75", "0.7", "0.707", "0.1"] {
        let text = format!(
            "[curves]\n\
             a = {{ bezier = [[60, 0, 0], [60, 60, 0], [0, 60, 0]], weights = [1, {weight}, 1] }}\n\
             b = {{ bezier = [[30, 0, 60], [30, 30, 60], [0, 30, 60]], weights = [1, {weight}, 1] }}\n\
             c = {{ spline = {{ degree = 2, points = [[0.1, 0, 0], [0.3, 0.7, 0], [1.1, 0.9, 0.2]], weights = [1, {weight}, 1] }} }}\n\
             d = {{ spline = {{ degree = 2, points = [[0.15, 0.1, 1.1], [0.45, 1.15, 1.1], [1.65, 1.45, 1.4]], weights = [1, {weight}, 1] }} }}\n\
             [patches]\n\
             f = {{ ruled = [\"a\", \"b\"] }}\n\
             g = {{ ruled = [\"c\", \"d\"] }}\n"
        );
        let report = inspect(&design(&text)).unwrap();
        for patch in &report.patches {
            assert_eq!(
                patch.developable,
                Assurance::Proved,
                "{} {weight}",
                patch.name
            );
        }
    }
    // In the last digit it is none.
    let text = "[curves]\n\
         a = { bezier = [[0.1, 0, 0], [0.3, 0.7, 0], [1.1, 0.9, 0.2]] }\n\
         b = { bezier = [[0.15, 0.1, 1.1], [0.45, 1.15, 1.1], [1.65, 1.45, 1.400000000000000001]] }\n\
         [patches.f]\n\
         ruled = [\"a\", \"b\"]\n";
    let report = inspect(&design(text)).unwrap();
    assert_eq!(report.patches[0].developable, Assurance::Within);
}
