//! Plane faces of STEP files with any outline: compared with closed formulas, and with the triangles and faces made of them.

use crate::step_text::{StepEdge, StepText};
use std::f64::consts::PI;
use torse_designs::bench::{PaperSize, bench_sheets, tiled_parts};
use torse_designs::export::{bytes, mesh};
use torse_designs::inspect::{Assurance, inspect};
use torse_designs::listing::list;
use torse_designs::unroll::{Demand, Part, parts, unroll};
use torse_designs::{Design, load};

fn design(text: &str) -> Design {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("face.step");
    std::fs::write(&path, text).unwrap();
    load(&path).unwrap()
}

fn part(design: &Design) -> Part {
    assert!(design.left_out.is_empty(), "{:?}", design.left_out);
    let pieces = unroll(design, &Demand::default()).unwrap();
    let mut made = parts(design, &pieces).unwrap();
    assert_eq!(made.len(), 1);
    made.remove(0)
}

/// A turned plane, far from the origin: its origin and two axes.
const ORIGIN: [f64; 3] = [700.0, -300.0, 150.0];
const X: [f64; 3] = [2.0 / 3.0, 2.0 / 3.0, 1.0 / 3.0];
const Y: [f64; 3] = [-2.0 / 3.0, 1.0 / 3.0, 2.0 / 3.0];
const Z: [f64; 3] = [1.0 / 3.0, -2.0 / 3.0, 2.0 / 3.0];

fn at(x: f64, y: f64) -> [f64; 3] {
    [0, 1, 2].map(|i| ORIGIN[i] + x * X[i] + y * Y[i])
}

fn circle(text: &mut StepText, x: f64, y: f64, radius: f64) -> StepEdge {
    let frame = text.frame(at(x, y), Z, X);
    let circle = text.circle(frame, radius);
    (text.ring(circle, at(x + radius, y)), true)
}

fn plane(text: &mut StepText) -> usize {
    let frame = text.frame(ORIGIN, Z, X);
    text.entity(&format!("PLANE('',#{frame})"))
}

fn disc_with_holes() -> String {
    let mut text = StepText::new();
    let plane = plane(&mut text);
    // The inner one comes first: which loop is outside does not hang on the order.
    let hole = circle(&mut text, 10.0, -5.0, 8.0);
    let border = circle(&mut text, 0.0, 0.0, 40.0);
    let other = circle(&mut text, -15.0, 12.0, 3.0);
    text.face("disc", plane, &[vec![hole], vec![border], vec![other]]);
    text.finish()
}

#[test]
fn a_disc_with_round_holes_is_cut_as_it_is() {
    let design = design(&disc_with_holes());
    let part = part(&design);
    assert!(part.proved && part.error < 1e-8, "{}", part.error);
    assert_eq!(part.openings.len(), 2);
    let area = PI * (1600.0 - 64.0 - 9.0);
    assert!((part.area() - area).abs() < 1e-7, "{} {area}", part.area());
    let around = 2.0 * PI * (40.0 + 8.0 + 3.0);
    assert!((part.cut_length() - around).abs() < 1e-8);
    assert!(
        part.size.iter().all(|side| (side - 80.0).abs() < 1e-8),
        "{:?}",
        part.size
    );
    // Arcs of this radius and nothing else.
    let round = |radius: f64| (radius - 40.0).abs() < 1e-8;
    assert!(part.outline.iter().all(|segment| round(segment.radius())));
    let report = inspect(&design).unwrap();
    assert!(report.missed.is_empty(), "{:?}", report.missed);
    let patch = &report.patches[0];
    assert_eq!(patch.developable, Assurance::ByConstruction);
    let found = patch.area.unwrap();
    assert!((found - PI * 1600.0).abs() < 1e-7, "{found}");
}

#[test]
fn the_mesh_and_the_cad_face_of_a_disc_end_at_its_border() {
    let design = design(&disc_with_holes());
    let area = PI * (1600.0 - 64.0 - 9.0);
    let mesh = mesh(&design).unwrap();
    // Chords within 0.01 mm of the circles.
    let off = 0.01 * 2.0 * PI * 51.0;
    assert!((mesh.area() - area).abs() < off, "{} {area}", mesh.area());
    let distance = |p: &[f64; 3]| {
        let square: f64 = (0..3).map(|i| (p[i] - ORIGIN[i]).powi(2)).sum();
        square.sqrt()
    };
    assert!(mesh.vertices().iter().all(|p| distance(p) < 40.0 + 1e-6));
    // A mirrored hole would lie elsewhere.
    let from_hole = |p: &[f64; 3]| {
        let middle = at(10.0, -5.0);
        let square: f64 = (0..3).map(|i| (p[i] - middle[i]).powi(2)).sum();
        square.sqrt()
    };
    assert!(mesh.vertices().iter().all(|p| from_hole(p) > 8.0 - 0.01));
    let step = bytes(&design, "step", &Demand::default()).unwrap();
    let again = self::design(&String::from_utf8(step).unwrap());
    // What was written is a face again, with the same holes; its circles are cubics.
    let again = part(&again);
    assert_eq!(again.openings.len(), 2);
    let room = again.error * again.cut_length();
    assert!(
        again.error <= 0.01 && (again.area() - area).abs() < room,
        "{} {area}",
        again.area()
    );
}

#[test]
fn outlines_that_no_direction_passes_once_are_cut_as_they_are() {
    let mut text = StepText::new();
    let plane = plane(&mut text);
    // A U with legs of 10 by 40 on a base of 50 by 10.
    let corners = [
        [0.0, 0.0],
        [50.0, 0.0],
        [50.0, 50.0],
        [40.0, 50.0],
        [40.0, 10.0],
        [10.0, 10.0],
        [10.0, 50.0],
        [0.0, 50.0],
    ];
    let corners = corners.map(|[x, y]| at(x, y));
    let border = text.polygon(&corners);
    let hole = circle(&mut text, 45.0, 30.0, 2.0);
    text.face("fork", plane, &[border, vec![hole]]);
    let design = design(&text.finish());
    let part = part(&design);
    assert!(part.proved && part.error < 1e-8, "{}", part.error);
    assert!(
        (part.area() - (1300.0 - 4.0 * PI)).abs() < 1e-7,
        "{}",
        part.area()
    );
    assert!((part.cut_length() - (280.0 + 4.0 * PI)).abs() < 1e-7);
    assert_eq!(part.outline.len(), 8);
    let mesh = mesh(&design).unwrap();
    assert!(
        (mesh.area() - (1300.0 - 4.0 * PI)).abs() < 0.2,
        "{}",
        mesh.area()
    );
}

#[test]
fn openings_of_faces_are_counted() {
    let text = disc_with_holes();
    let listing = list("disc.step", text.as_bytes(), None).unwrap();
    assert_eq!(listing.faces[0].openings, Some(2));
}

#[test]
fn a_disc_has_a_sheet_for_the_fitter_pages_and_pictures() {
    let design = design(&disc_with_holes());
    let pieces = unroll(&design, &Demand::default()).unwrap();
    let made = parts(&design, &pieces).unwrap();
    let sheets = bench_sheets(&design, &pieces, &made, PaperSize::A4).unwrap();
    assert_eq!(sheets.len(), 1);
    let tiled = tiled_parts(&design, &pieces, &made, PaperSize::A4).unwrap();
    assert_eq!(tiled.len(), 1);
    let html = torse_designs::draw::page(&design, &Demand::default()).unwrap();
    // No point of the rectangle around the disc is drawn.
    let start = html.find("[{\"name\":\"disc\"").unwrap();
    let end = start + html[start..].find("}]").unwrap();
    let numbers = html[start..end]
        .split("[[")
        .skip(1)
        .flat_map(|shape| shape.split("],["));
    let mut count = 0;
    for triple in numbers {
        let clean = triple.trim_matches(|c: char| !c.is_ascii_digit() && c != '-');
        let clean = clean.split(']').next().unwrap();
        let parsed: Vec<f64> = clean.split(',').map(|c| c.parse().unwrap()).collect();
        let square: f64 = (0..3).map(|i| (parsed[i] - ORIGIN[i]).powi(2)).sum();
        assert!(square.sqrt() < 40.05, "{parsed:?}");
        count += 1;
    }
    assert!(count > 200, "{count}");
}

#[test]
fn a_washer_is_one_part_with_an_opening() {
    let mut text = StepText::new();
    let plane = plane(&mut text);
    let loops = [30.0, 12.0].map(|radius| vec![circle(&mut text, 0.0, 0.0, radius)]);
    text.face("washer", plane, &loops);
    let part = part(&design(&text.finish()));
    assert_eq!(part.openings.len(), 1);
    assert!((part.area() - PI * (900.0 - 144.0)).abs() < 1e-7);
}

#[test]
fn an_elliptic_cap_is_cut_within_the_tolerance_and_its_length_is_measured() {
    let mut text = StepText::new();
    let plane = plane(&mut text);
    let frame = text.frame(ORIGIN, Z, X);
    let ellipse = text.ellipse(frame, [50.0, 30.0]);
    let ring = text.ring(ellipse, at(50.0, 0.0));
    text.face("cap", plane, &[vec![(ring, true)]]);
    let part = part(&design(&text.finish()));
    assert!(!part.proved && part.error <= 0.01, "{}", part.error);
    // The perimeter by the series in the parameter of Ivory.
    let h = (20.0_f64 / 80.0).powi(2);
    let series = 1.0 + h / 4.0 + h * h / 64.0 + h.powi(3) / 256.0 + 25.0 * h.powi(4) / 16384.0;
    let around = PI * 80.0 * series;
    assert!(
        (part.cut_length() - around).abs() < 1e-3,
        "{} {around}",
        part.cut_length()
    );
    assert!((part.area() - PI * 1500.0).abs() < 0.01 * around);
    // On the ellipse, corner by corner.
    let [low, high] = [
        part.size[0].min(part.size[1]),
        part.size[0].max(part.size[1]),
    ];
    assert!(
        (high - 100.0).abs() < 0.02 && (low - 60.0).abs() < 0.02,
        "{:?}",
        part.size
    );
}

#[test]
fn a_hole_over_the_border_of_a_disc_is_refused() {
    let mut text = StepText::new();
    let plane = plane(&mut text);
    let border = circle(&mut text, 0.0, 0.0, 40.0);
    // It lies within the rectangle around the disc, and not within the disc.
    let hole = circle(&mut text, 36.0, 0.0, 6.0);
    text.face("disc", plane, &[vec![border], vec![hole]]);
    let design = design(&text.finish());
    let pieces = unroll(&design, &Demand::default()).unwrap();
    let error = parts(&design, &pieces).unwrap_err().to_string();
    assert!(error.contains("leaves the sheet"), "{error}");
}

#[test]
fn a_border_that_leaves_its_plane_has_no_pattern() {
    let mut text = StepText::new();
    let plane = plane(&mut text);
    let frame = text.frame(at(0.0, 0.0), X, Y);
    // Across the plane.
    let upright = text.circle(frame, 40.0);
    let ring = text.ring(upright, at(0.0, 40.0));
    text.face("disc", plane, &[vec![(ring, true)]]);
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("face.step");
    std::fs::write(&path, text.finish()).unwrap();
    let error = load(&path).unwrap_err();
    let torse_designs::DesignError::NoFace { reasons, .. } = &error else {
        panic!("{error}")
    };
    assert!(reasons[0].contains("from the plane"), "{reasons:?}");
}
