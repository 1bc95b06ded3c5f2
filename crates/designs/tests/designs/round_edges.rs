//! Cylinders and cones of STEP files within edges that are no circles around them: conics of oblique planes, the apex, curves
//! in no plane. Areas are compared with closed formulas.

use crate::step_text::{StepEdge, StepText};
use std::f64::consts::{FRAC_PI_2, LN_2, PI};
use torse_designs::unroll::{Demand, parts, unroll};
use torse_designs::{Design, DesignError, load};

const Z: [f64; 3] = [0.0, 0.0, 1.0];
const X: [f64; 3] = [1.0, 0.0, 0.0];

fn load_text(text: &str) -> Result<Design, DesignError> {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("face.step");
    std::fs::write(&path, text).unwrap();
    load(&path)
}

fn design(text: StepText) -> Design {
    let design = load_text(&text.finish()).unwrap();
    assert!(design.left_out.is_empty(), "{:?}", design.left_out);
    design
}

/// The area of the patterns of a piece is the given one, and what is cut is as far from it as its error says.
fn check(design: &Design, name: &str, area: f64) {
    let demand = Demand {
        only: Some(name.to_owned()),
        ..Demand::default()
    };
    let pieces = unroll(design, &demand).unwrap();
    let found = pieces[0].flat.area();
    assert!(
        (found - area).abs() <= 1e-6 * area,
        "{name}: {found} {area}"
    );
    let made = parts(design, &pieces).unwrap();
    let part = &made[0];
    assert!(part.error <= 0.01, "{name}: {}", part.error);
    let room = part.error * part.cut_length();
    assert!(
        (part.area() - area).abs() <= room,
        "{name}: {} {area}",
        part.area()
    );
}

/// The area of a disc of radius 30 on the far side of a line at a distance from its centre.
fn segment(away: f64) -> f64 {
    900.0 * libm::acos(away / 30.0) - away * (900.0 - away * away).sqrt()
}

/// A cone of radius 30 and height 60, and its surface: radii shrink by 1/2 along z.
struct Cone {
    text: StepText,
    surface: usize,
    apex: usize,
    circle: usize,
}

const HALF_ANGLE_SINE: f64 = 0.447_213_595_499_957_9;

impl Cone {
    fn new() -> Self {
        let mut text = StepText::new();
        let frame = text.frame([0.0; 3], [0.0, 0.0, -1.0], X);
        let half = libm::atan(0.5);
        let surface = text.entity(&format!("CONICAL_SURFACE('',#{frame},30.,{half:?})"));
        let apex = text.vertex([0.0, 0.0, 60.0]);
        let flat = text.frame([0.0; 3], Z, X);
        let circle = text.circle(flat, 30.0);
        Self {
            text,
            surface,
            apex,
            circle,
        }
    }
}

#[test]
fn a_cone_cut_by_a_plane_along_its_axis_ends_in_a_hyperbola() {
    let mut cone = Cone::new();
    let text = &mut cone.text;
    // At x = 10: the radius is (60 - z)/2, so that y^2 = (60 - z)^2/4 - 100.
    let y = 800.0_f64.sqrt();
    let corners = [[10.0, 0.0, 40.0], [10.0, y, 0.0], [10.0, -y, 0.0]];
    let [top, left, right] = corners.map(|at| text.vertex(at));
    let frame = text.frame([10.0, 0.0, 60.0], X, [0.0, 0.0, -1.0]);
    let hyperbola = text.hyperbola(frame, [20.0, 10.0]);
    let up = [
        text.edge([top, left], hyperbola),
        text.edge([right, top], hyperbola),
    ];
    let around = text.edge([left, right], cone.circle);
    let seam = text.line([cone.apex, top], [0.0, 0.0, 60.0], corners[0]);
    let chord = text.line([right, left], corners[2], corners[1]);
    let border: Vec<StepEdge> = vec![
        (seam, true),
        (up[0], true),
        (around, true),
        (up[1], true),
        (seam, false),
    ];
    text.face("cone", cone.surface, &[border]);
    let frame = text.frame([10.0, 0.0, 0.0], X, Z);
    let plane = text.entity(&format!("PLANE('',#{frame})"));
    let border = vec![(up[0], false), (up[1], false), (chord, true)];
    text.face("plane", plane, &[border]);
    let design = design(cone.text);
    check(
        &design,
        "cone",
        (900.0 * PI - segment(10.0)) / HALF_ANGLE_SINE,
    );
    let under = 60.0 * y - 200.0 * libm::acosh(3.0);
    let pieces = unroll(&design, &Demand::default()).unwrap();
    let made = parts(&design, &pieces).unwrap();
    let plane = made.iter().find(|part| part.name == "plane").unwrap();
    let room = plane.error * plane.cut_length();
    assert!(plane.error <= 0.01 && (plane.area() - under).abs() <= room);
}

#[test]
fn a_cone_cut_by_a_plane_along_a_ruling_ends_in_a_parabola_on_both_sides() {
    let mut cone = Cone::new();
    let text = &mut cone.text;
    // In the plane z = 40 + 2 x it is y^2 = 100 - 20 x: from x = 5 down to the circle at x = -20.
    let (y, root) = (500.0_f64.sqrt(), 5.0_f64.sqrt());
    let [left, right] = [y, -y].map(|y| text.vertex([-20.0, y, 0.0]));
    let frame = text.frame(
        [5.0, 0.0, 50.0],
        [2.0 / root, 0.0, -1.0 / root],
        [-1.0 / root, 0.0, -2.0 / root],
    );
    let parabola = text.parabola(frame, root);
    let over = text.edge([right, left], parabola);
    // The part with the apex has no seam, and the other one ends in two tips.
    let behind = text.edge([left, right], cone.circle);
    text.face_to_vertex(
        "above",
        cone.surface,
        &[(behind, true), (over, true)],
        cone.apex,
    );
    let front = text.edge([right, left], cone.circle);
    text.face("below", cone.surface, &[vec![(front, true), (over, false)]]);
    let design = design(cone.text);
    // Its shadow on the plane of the circle is a parabola too.
    let shadow = 2.0 / 3.0 * 25.0 * 2.0 * y;
    let behind = shadow + segment(20.0);
    check(&design, "above", behind / HALF_ANGLE_SINE);
    check(&design, "below", (900.0 * PI - behind) / HALF_ANGLE_SINE);
}

#[test]
fn a_cone_with_a_vertex_instead_of_a_seam_goes_to_its_apex() {
    let mut text = StepText::new();
    // It is stated at its apex, where its radius is 0.
    let apex = [3.0, -4.0, 5.0];
    let frame = text.frame(apex, Z, X);
    let half = libm::atan(0.75);
    let surface = text.entity(&format!("CONICAL_SURFACE('',#{frame},0.,{half:?})"));
    let frame = text.frame([3.0, -4.0, 21.0], Z, X);
    let circle = text.circle(frame, 12.0);
    let ring = text.ring(circle, [15.0, -4.0, 21.0]);
    let tip = text.vertex(apex);
    text.face_to_vertex("hat", surface, &[(ring, true)], tip);
    check(&design(text), "hat", PI * 12.0 * 20.0);
}

/// A pipe of radius 20 from z = 0 to the plane z = 10 + x, which leaves it at two tips.
fn hoof() -> StepText {
    let mut text = StepText::new();
    let frame = text.frame([0.0; 3], Z, X);
    let surface = text.entity(&format!("CYLINDRICAL_SURFACE('',#{frame},20.)"));
    let at = |angle: f64, above: bool| {
        let (sine, cosine) = libm::sincos(angle);
        let z = if above { 10.0 + 20.0 * cosine } else { 0.0 };
        [20.0 * cosine, 20.0 * sine, z]
    };
    let tip = 2.0 * PI / 3.0;
    let tips = [-tip, tip].map(|angle| text.vertex(at(angle, false)));
    let [low, high] = [text.vertex(at(0.3, false)), text.vertex(at(-0.5, true))];
    let circle = text.circle(frame, 20.0);
    let root = 2.0_f64.sqrt();
    let tilted = text.frame(
        [0.0, 0.0, 10.0],
        [-1.0 / root, 0.0, 1.0 / root],
        [1.0 / root, 0.0, 1.0 / root],
    );
    let ellipse = text.ellipse(tilted, [20.0 * root, 20.0]);
    let edges = [
        text.edge([tips[0], low], circle),
        text.edge([low, tips[1]], circle),
        text.edge([tips[0], high], ellipse),
        text.edge([high, tips[1]], ellipse),
    ];
    let border = vec![
        (edges[0], true),
        (edges[1], true),
        (edges[3], false),
        (edges[2], false),
    ];
    text.face("hoof", surface, &[border]);
    text
}

#[test]
fn a_pipe_between_arcs_that_meet_in_two_tips_is_cut_at_the_ends_of_both() {
    let tip = 2.0 * PI / 3.0;
    let area = 20.0 * (2.0 * 10.0 * tip + 2.0 * 20.0 * libm::sin(tip));
    check(&design(hoof()), "hoof", area);
}

/// The edge curve over a quarter of a cylinder of radius 20 with `z = start + rise tan(a/2)`, where `a` is the angle from the
/// first axis, or from the second one if it is turned: in no plane, and its parameter `u` is the tangent. As Bezier curve of
/// degree 3 it is `(1 - u^2, 2 u, (1 + u^2)(start + rise u))/(1 + u^2)`.
fn tangent_curve(text: &mut StepText, start: f64, rise: f64, turned: bool) -> usize {
    let weights = [1.0, 1.0, 4.0 / 3.0, 2.0];
    let x = [1.0, 1.0, 2.0 / 3.0, 0.0];
    let y = [0.0, 2.0 / 3.0, 4.0 / 3.0, 2.0];
    let z = [
        start,
        start + rise / 3.0,
        4.0 / 3.0 * start + 2.0 / 3.0 * rise,
        2.0 * (start + rise),
    ];
    let points = [0, 1, 2, 3].map(|k| {
        let [x, y, z] = [20.0 * x[k], 20.0 * y[k], z[k]].map(|c| c / weights[k]);
        text.point(if turned { [y, x, z] } else { [x, y, z] })
    });
    let points = points.map(|point| format!("#{point}")).join(",");
    let weights = weights.map(|w| format!("{w:?}")).join(",");
    text.entity(&format!(
        "(BOUNDED_CURVE() B_SPLINE_CURVE(3,({points}),.UNSPECIFIED.,.F.,.F.) \
         B_SPLINE_CURVE_WITH_KNOTS((4,4),(0.,1.),.UNSPECIFIED.) CURVE() GEOMETRIC_REPRESENTATION_ITEM() \
         RATIONAL_B_SPLINE_CURVE(({weights})) REPRESENTATION_ITEM(''))"
    ))
}

/// A text with a cylinder of radius 20 about the third axis.
fn cylinder() -> (StepText, usize) {
    let mut text = StepText::new();
    let frame = text.frame([0.0; 3], Z, X);
    let surface = text.entity(&format!("CYLINDRICAL_SURFACE('',#{frame},20.)"));
    (text, surface)
}

#[test]
fn a_cylinder_between_curves_in_no_plane_has_rulings_at_equal_angles() {
    let (mut text, surface) = cylinder();
    // Their parameters run from opposite sides.
    let high = tangent_curve(&mut text, 5.0, 4.0, false);
    let low = tangent_curve(&mut text, -3.0, -6.0, true);
    let corners = [
        [20.0, 0.0, -9.0],
        [0.0, 20.0, -3.0],
        [0.0, 20.0, 9.0],
        [20.0, 0.0, 5.0],
    ];
    let [a, b, c, d] = corners.map(|at| text.vertex(at));
    let edges = vec![
        (text.edge([b, a], low), false),
        (text.line([b, c], corners[1], corners[2]), true),
        (text.edge([d, c], high), false),
        (text.line([d, a], corners[3], corners[0]), true),
    ];
    text.face("wall", surface, &[edges]);
    // The integral of tan(a/2) over a quarter is the logarithm of 2.
    let area = 20.0 * ((5.0 + 3.0) * FRAC_PI_2 + (4.0 + 6.0) * LN_2);
    check(&design(text), "wall", area);
}

#[test]
fn curves_in_no_plane_that_meet_but_for_rounding_are_made_to_meet() {
    let (mut text, surface) = cylinder();
    let high = tangent_curve(&mut text, 0.0, 4.0, false);
    let low = tangent_curve(&mut text, 1e-6, -6.0, false);
    let corners = [[20.0, 0.0, 0.0], [0.0, 20.0, -6.0], [0.0, 20.0, 4.0]];
    let [a, b, c] = corners.map(|at| text.vertex(at));
    let edges = vec![
        (text.edge([a, b], low), true),
        (text.line([b, c], corners[1], corners[2]), true),
        (text.edge([a, c], high), false),
    ];
    text.face("fin", surface, &[edges]);
    check(&design(text), "fin", 20.0 * (4.0 + 6.0) * LN_2);
}

#[test]
fn a_border_that_touches_a_ruling_where_it_turns_back_is_told() {
    let mut text = StepText::new();
    let frame = text.frame([0.0; 3], Z, X);
    let surface = text.entity(&format!("CYLINDRICAL_SURFACE('',#{frame},20.)"));
    // The part of a cylinder within a narrower one across it, of radius 12: y^2 + z^2 = 144 in front.
    let side = [[16.0, 12.0, 0.0], [16.0, -12.0, 0.0]];
    let ends = side.map(|at| text.vertex(at));
    let mut arc = |z: f64| {
        let points = [12.0, 6.0, 0.0, -6.0, -12.0].map(|y: f64| {
            let x = (400.0 - y * y).sqrt();
            text.point([x, y, z * (144.0 - y * y).sqrt()])
        });
        let points = points.map(|point| format!("#{point}")).join(",");
        let curve = text.entity(&format!("POLYLINE('',({points}))"));
        text.edge(ends, curve)
    };
    let (high, low) = (arc(1.0), arc(-1.0));
    text.face("window", surface, &[vec![(high, true), (low, false)]]);
    let error = load_text(&text.finish()).unwrap_err();
    assert!(error.to_string().contains("window: "), "{error}");
}

#[test]
fn a_face_that_is_left_out_is_asked_for_by_its_name() {
    let mut text = hoof();
    let frame = text.frame([0.0; 3], Z, X);
    let ball = text.entity(&format!("SPHERICAL_SURFACE('',#{frame},20.)"));
    let circle = text.circle(frame, 20.0);
    let ring = text.ring(circle, [20.0, 0.0, 0.0]);
    text.face("ball", ball, &[vec![(ring, true)]]);
    let design = load_text(&text.finish()).unwrap();
    let asked = |name: &str| {
        let demand = Demand {
            only: Some(name.to_owned()),
            ..Demand::default()
        };
        unroll(&design, &demand).unwrap_err().to_string()
    };
    let told = asked("ball");
    assert!(told.starts_with("`ball` is left out: "), "{told}");
    assert_eq!(asked("bal"), "no piece of the design is called `bal`");
}
