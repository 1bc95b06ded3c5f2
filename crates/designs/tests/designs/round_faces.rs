//! Cylinders and cones of STEP files that are closed around: cut obliquely, with openings over their seams, as closed meshes.
//! Areas and lengths are compared with closed formulas.

use crate::step_text::{StepEdge, StepText};
use std::f64::consts::PI;
use torse_designs::export::mesh;
use torse_designs::unroll::{Demand, Part, parts, unroll};
use torse_designs::{Design, load};

const Z: [f64; 3] = [0.0, 0.0, 1.0];
const X: [f64; 3] = [1.0, 0.0, 0.0];

fn design(text: &str) -> Design {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("face.step");
    std::fs::write(&path, text).unwrap();
    let design = load(&path).unwrap();
    assert!(design.left_out.is_empty(), "{:?}", design.left_out);
    design
}

fn part(design: &Design) -> Part {
    let pieces = unroll(design, &Demand::default()).unwrap();
    let mut made = parts(design, &pieces).unwrap();
    assert_eq!(made.len(), 1);
    made.remove(0)
}

/// The perimeter of an ellipse by the series in the parameter of Ivory.
fn perimeter(a: f64, b: f64) -> f64 {
    let h = ((a - b) / (a + b)).powi(2);
    let series = 1.0 + h / 4.0 + h * h / 64.0 + h.powi(3) / 256.0 + 25.0 * h.powi(4) / 16384.0;
    PI * (a + b) * series
}

/// The loop around a face between two rings that begin at vertices on one ruling.
fn closed_loop(
    text: &mut StepText,
    [low, high]: [usize; 2],
    ends: [[f64; 3]; 2],
    vertices: [usize; 2],
) -> Vec<StepEdge> {
    let seam = text.line(vertices, ends[0], ends[1]);
    vec![(low, true), (seam, true), (high, false), (seam, false)]
}

/// A cylinder of radius 20 from z = 0 to the plane z = 50 + x/2.
fn oblique_cylinder() -> String {
    let mut text = StepText::new();
    let frame = text.frame([0.0; 3], Z, X);
    let surface = text.entity(&format!("CYLINDRICAL_SURFACE('',#{frame},20.)"));
    let ends = [[20.0, 0.0, 0.0], [20.0, 0.0, 60.0]];
    let vertices = ends.map(|end| text.vertex(end));
    let circle = text.circle(frame, 20.0);
    let slope = 500.0_f64.sqrt();
    let tilted = text.frame(
        [0.0, 0.0, 50.0],
        [-10.0 / slope, 0.0, 20.0 / slope],
        [20.0 / slope, 0.0, 10.0 / slope],
    );
    let ellipse = text.ellipse(tilted, [slope, 20.0]);
    let low = text.edge([vertices[0]; 2], circle);
    let high = text.edge([vertices[1]; 2], ellipse);
    let border = closed_loop(&mut text, [low, high], ends, vertices);
    text.face("miter", surface, &[border]);
    text.finish()
}

#[test]
fn a_cylinder_cut_obliquely_has_the_area_of_its_mean_height() {
    let part = part(&design(&oblique_cylinder()));
    assert!(part.proved && part.error <= 0.01, "{}", part.error);
    let around = 40.0 * PI + 120.0 + perimeter(500.0_f64.sqrt(), 20.0);
    let off = (part.cut_length() - around).abs();
    assert!(off < 0.01, "{} {around}", part.cut_length());
    let off = (part.area() - 2000.0 * PI).abs();
    assert!(off < part.error * around, "{}", part.area());
}

#[test]
fn a_cone_cut_obliquely_has_the_area_of_its_shadow_over_the_sine_of_its_half_angle() {
    let mut text = StepText::new();
    let frame = text.frame([0.0; 3], Z, X);
    let half = libm::atan(0.5);
    let surface = text.entity(&format!("CONICAL_SURFACE('',#{frame},30.,{half:?})"));
    // At z the radius is 30 + z/2; it is cut at z = -40 and by z = 20 + x/2, where x^2 + y^2 = (40 + x/4)^2.
    let share = 1.0 - 1.0 / 16.0;
    let (middle, a, b) = (10.0 / share, 40.0 / share, 40.0 / f64::sqrt(share));
    let top = [middle + a, 0.0, 20.0 + 0.5 * (middle + a)];
    let ends = [[10.0, 0.0, -40.0], top];
    let vertices = ends.map(|end| text.vertex(end));
    let low = text.frame([0.0, 0.0, -40.0], Z, X);
    let circle = text.circle(low, 10.0);
    let slope = 1.25_f64.sqrt();
    let tilted = text.frame(
        [middle, 0.0, 20.0 + 0.5 * middle],
        [-0.5 / slope, 0.0, 1.0 / slope],
        [1.0 / slope, 0.0, 0.5 / slope],
    );
    let ellipse = text.ellipse(tilted, [a * slope, b]);
    let low = text.edge([vertices[0]; 2], circle);
    let high = text.edge([vertices[1]; 2], ellipse);
    let border = closed_loop(&mut text, [low, high], ends, vertices);
    text.face("cone", surface, &[border]);
    let part = part(&design(&text.finish()));
    let area = PI * (a * b - 100.0) / libm::sin(half);
    let room = part.error * part.cut_length();
    assert!(
        part.error <= 0.01 && (part.area() - area).abs() < room,
        "{} {area}",
        part.area()
    );
    let side = libm::hypot(top[0] - 10.0, top[2] + 40.0);
    let around = 20.0 * PI + 2.0 * side + perimeter(a * slope, b);
    assert!(
        (part.cut_length() - around).abs() < 0.01,
        "{} {around}",
        part.cut_length()
    );
}

/// How a file writes an opening over a seam.
#[derive(Clone, Copy)]
enum SeamOpening {
    /// As a loop of its own.
    Loop,
    /// The seam ends at it and goes on behind it, and all edges are one loop.
    Interrupted,
}

/// A pipe of radius 20 and length 50 with a window from -0.3 to 0.3 radians and from z = 15 to 30; the seam is at 0.
fn window_over_seam(kind: SeamOpening) -> String {
    let mut text = StepText::new();
    let frame = text.frame([0.0; 3], Z, X);
    let surface = text.entity(&format!("CYLINDRICAL_SURFACE('',#{frame},20.)"));
    let at = |angle: f64, z: f64| [20.0 * libm::cos(angle), 20.0 * libm::sin(angle), z];
    let heights = [0.0, 15.0, 30.0, 50.0];
    let seam = heights.map(|z| text.vertex(at(0.0, z)));
    let circles = heights.map(|z| {
        let frame = text.frame([0.0, 0.0, z], Z, X);
        text.circle(frame, 20.0)
    });
    let low = text.edge([seam[0]; 2], circles[0]);
    let high = text.edge([seam[3]; 2], circles[3]);
    // Of the window: below and above, to the left and to the right.
    let [left, right] = [-0.3, 0.3].map(|angle| [15.0, 30.0].map(|z| text.vertex(at(angle, z))));
    let sides = [(left, -0.3), (right, 0.3)];
    let sides = sides.map(|(ends, angle)| text.line(ends, at(angle, 15.0), at(angle, 30.0)));
    let loops = match kind {
        SeamOpening::Loop => {
            let whole = text.line([seam[0], seam[3]], at(0.0, 0.0), at(0.0, 50.0));
            let below = text.edge([left[0], right[0]], circles[1]);
            let above = text.edge([left[1], right[1]], circles[2]);
            vec![
                vec![(low, true), (whole, true), (high, false), (whole, false)],
                vec![
                    (below, true),
                    (sides[1], true),
                    (above, false),
                    (sides[0], false),
                ],
            ]
        }
        SeamOpening::Interrupted => {
            let before = text.line([seam[0], seam[1]], at(0.0, 0.0), at(0.0, 15.0));
            let behind = text.line([seam[2], seam[3]], at(0.0, 30.0), at(0.0, 50.0));
            let below = [[left[0], seam[1]], [seam[1], right[0]]];
            let below = below.map(|ends| text.edge(ends, circles[1]));
            let above = [[left[1], seam[2]], [seam[2], right[1]]];
            let above = above.map(|ends| text.edge(ends, circles[2]));
            vec![vec![
                (low, true),
                (before, true),
                (below[0], false),
                (sides[0], true),
                (above[0], true),
                (behind, true),
                (high, false),
                (behind, false),
                (above[1], true),
                (sides[1], false),
                (below[1], false),
                (before, false),
            ]]
        }
    };
    text.face("pipe", surface, &loops);
    text.finish()
}

#[test]
fn an_opening_over_the_seam_of_a_pipe_is_whole() {
    for kind in [SeamOpening::Loop, SeamOpening::Interrupted] {
        let part = part(&design(&window_over_seam(kind)));
        assert_eq!(part.openings.len(), 1);
        let opening = &part.openings[0].shape;
        assert!(
            (opening.area() - 180.0).abs() < 0.01 * 54.0,
            "{}",
            opening.area()
        );
        assert!(
            (opening.length() - 54.0).abs() < 0.01,
            "{}",
            opening.length()
        );
        let area = 2000.0 * PI - 180.0;
        assert!(
            (part.area() - area).abs() < 0.01 * 400.0,
            "{} {area}",
            part.area()
        );
        assert!(part.proved && part.error <= 0.01, "{}", part.error);
    }
}

#[test]
fn the_mesh_of_a_closed_patch_has_no_slit() {
    for text in [oblique_cylinder(), window_over_seam(SeamOpening::Loop)] {
        let sheet = mesh(&design(&text)).unwrap();
        assert!(sheet.welded(1e-6).unwrap().vertices().len() == sheet.vertices().len());
        let solid = sheet.thickened(1.0).unwrap();
        assert!(solid.is_watertight() && !sheet.is_watertight());
        // The middle surface times the thickness: the axis is straight, so that what bending adds outside goes inside.
        let volume = sheet.area();
        assert!(
            (solid.volume().abs() - volume).abs() < 0.01 * volume,
            "{}",
            solid.volume()
        );
    }
}
