//! Drawings: what DXF and SVG say is what was drawn.

#![allow(clippy::disallowed_methods, reason = "compared within a tolerance")]

use proptest::prelude::*;
use torse_exchange::{Drawing, ExchangeError, Layer, ReadError, Text, Vertex, dxf, svg};

fn vertex(x: f64, y: f64, bulge: f64) -> Vertex {
    let point = [x, y];
    Vertex { point, bulge }
}

#[test]
fn an_arc_reaches_as_far_as_its_circle() {
    let mut drawing = Drawing::default();
    // Three quarters of the unit circle, from the right around to the bottom.
    let bulge = libm::tan(3.0 * std::f64::consts::PI / 8.0);
    let arc = [vertex(1.0, 0.0, bulge), vertex(0.0, -1.0, 0.0)];
    drawing.path(Layer::Outline, &arc, false).unwrap();
    let [low, high] = drawing.bounds().unwrap();
    for (found, exact) in low.into_iter().chain(high).zip([-1.0, -1.0, 1.0, 1.0]) {
        assert!((found - exact).abs() < 1e-15, "{low:?} {high:?}");
    }
    let text = svg(&drawing).unwrap();
    assert!(text.contains(" 0 1 0 0 1\" data-order=\"0\"/>"), "{text}");
}

#[test]
fn the_vertices_of_an_apex_are_one() {
    let mut drawing = Drawing::default();
    let mut points = vec![[3.0, 4.0]; 33];
    points[7][0] += 1e-15;
    points.extend([[0.0, 0.0], [1.0, 0.0], [3.0, 4.0]]);
    drawing.polygon(Layer::Outline, &points).unwrap();
    assert_eq!(drawing.paths()[0].vertices().len(), 3);
    let point = [[3.0, 4.0]; 5];
    assert!(matches!(
        drawing.polygon(Layer::Outline, &point),
        Err(ExchangeError::Empty { .. })
    ));
}

#[test]
fn small_parts_keep_their_size() {
    let mut drawing = Drawing::default();
    let corners = [[0.0, 0.0], [1e-12, 0.0], [0.0, 3e-13]];
    drawing.polygon(Layer::Outline, &corners).unwrap();
    let read = Drawing::from_dxf(&dxf(&drawing).unwrap()).unwrap();
    assert_eq!(read.paths()[0].vertices()[2].point, [0.0, 3e-13]);
    assert!(svg(&drawing).unwrap().contains("L0 -0.0000000000003"));
}

#[test]
fn nothing_and_no_number_are_refused() {
    let mut drawing = Drawing::default();
    assert!(matches!(
        dxf(&drawing),
        Err(ExchangeError::Empty { what: "paths" })
    ));
    assert!(matches!(
        svg(&drawing),
        Err(ExchangeError::Empty { what: "paths" })
    ));
    for bad in [f64::NAN, f64::INFINITY] {
        let refused = [
            drawing.line(Layer::Marks, [0.0, bad], [1.0, 1.0]),
            drawing.bend([0.0, 0.0], [1.0, 1.0], bad),
            drawing.path(
                Layer::Outline,
                &[vertex(0.0, 0.0, bad), vertex(1.0, 0.0, 0.0)],
                true,
            ),
        ];
        for result in refused {
            assert!(matches!(result, Err(ExchangeError::NotFinite { .. })));
        }
    }
    assert!(matches!(
        drawing.note("two\nlines"),
        Err(ExchangeError::BadText { .. })
    ));
    assert_eq!(drawing, Drawing::default());
}

#[test]
fn broken_files_are_refused_with_their_line() {
    let line = |text: &str| match Drawing::from_dxf(text) {
        Err(ExchangeError::Unreadable { line, .. }) => Some(line),
        _ => None,
    };
    assert_eq!(line("0\nSECTION\nx\n2"), Some(3));
    assert_eq!(line("0"), Some(1));
    let entity = "0\nSECTION\n2\nENTITIES\n0\nLWPOLYLINE\n8\nOUTLINE\n10\nsix\n";
    assert_eq!(line(entity), Some(10));
    assert_eq!(
        line("0\nSECTION\n2\nENTITIES\n0\nTEXT\n8\nMARKS\n0\nEOF\n"),
        Some(6)
    );
}

#[test]
fn broken_svg_is_refused_with_its_line_and_what_a_program_adds_is_passed_over() {
    let line = |text: &str| match Drawing::from_svg(text) {
        Err(ExchangeError::Read(ReadError::Wrong { place, .. })) => place.line,
        other => panic!("{other:?}"),
    };
    assert!(line("<svg>\n<g id=\"OUTLINE\">\n").is_some());
    assert_eq!(line("<svg>\n</g></svg>"), Some(2));
    let path = |d: &str| format!("<svg>\n<g id=\"OUTLINE\">\n<path d=\"{d}\"/></g></svg>");
    for wrong in [
        "M0 0C1 1 2 2 3 3",
        "0 0L1 1",
        "M0 0L1",
        "M0 0A1 2 0 0 0 1 1",
        "M0 0A1 1 0 2 0 1 1",
    ] {
        assert_eq!(line(&path(wrong)), Some(3), "{wrong}");
    }
    assert_eq!(
        line("<svg><g id=\"MARKS\" transform=\"scale(2\"/></svg>"),
        Some(1)
    );
    assert_eq!(line("<svg><text x=1/></svg>"), Some(1));
    assert_eq!(line("<svg>&nbsp;</svg>"), Some(1));
    // Another program writes relative commands, other layers, other elements, comments.
    let text = "<?xml version=\"1.0\"?><!-- a comment --><svg xmlns:inkscape='http://www.inkscape.org/namespaces/inkscape'><defs id='x'/><g id='layer7' transform='scale(3)'>\
                <path d='M0 0'/></g><g inkscape:label='OUTLINE' id='g12'><path d='m 1,-2 h 3 v-4l-3 0.5.5.5z'/></g></svg>";
    let read = Drawing::from_svg(text).unwrap();
    let corners: Vec<_> = read.paths()[0].vertices().iter().map(|v| v.point).collect();
    assert_eq!(
        corners,
        [[1.0, 2.0], [4.0, 2.0], [4.0, 6.0], [1.0, 5.5], [1.5, 5.0]]
    );
    assert!(read.paths().len() == 1 && read.paths()[0].is_closed());
}

#[test]
fn groups_of_an_svg_may_be_moved_turned_and_scaled_and_paths_have_parts() {
    let text = "<svg width='20cm' height='10cm' viewBox='0 0 400 200'>\
                <g id='OUTLINE' transform='translate(100 0) scale(-2 2)'><path d='M0 0A10 10 0 0 1 20 0zM5 5h10'/></g></svg>";
    let read = Drawing::from_svg(text).unwrap();
    // Half a millimetre for a unit, mirrored: the arc turns the other way, which y up turns back.
    let arc = &read.paths()[0];
    assert_eq!(arc.vertices()[0].point, [50.0, 0.0]);
    assert_eq!(
        (arc.vertices()[1].point, arc.vertices()[0].bulge),
        ([30.0, 0.0], 1.0)
    );
    let line: Vec<_> = read.paths()[1].vertices().iter().map(|v| v.point).collect();
    assert_eq!(line, [[45.0, -5.0], [35.0, -5.0]]);
}

/// The text of a drawing whose entities of a kind are drawn across this direction.
fn drawn_across(drawing: &Drawing, kind: &str, direction: [&str; 3]) -> String {
    let [x, y, z] = direction;
    let text = dxf(drawing).unwrap();
    let across = format!("\n{kind}\n210\n{x}\n220\n{y}\n230\n{z}\n");
    let drawn = text.replace(&format!("\n{kind}\n"), &across);
    assert_ne!(drawn, text);
    drawn
}

#[test]
fn a_pattern_that_is_mirrored_by_its_extrusion_is_read_as_it_is_seen() {
    let mut drawing = Drawing::default();
    let outline = [
        vertex(0.0, 0.0, 0.25),
        vertex(40.0, 0.0, 0.0),
        vertex(30.0, 20.0, 0.0),
    ];
    drawing.path(Layer::Outline, &outline, true).unwrap();
    drawing
        .text(Text {
            layer: Layer::Marks,
            at: [5.0, 6.0],
            height: 2.0,
            angle: 0.25,
            content: "front".to_owned(),
        })
        .unwrap();
    let mirrored = drawn_across(&drawing, "LWPOLYLINE", ["0", "0", "-1"]);
    let read = Drawing::from_dxf(&mirrored).unwrap();
    let found: Vec<_> = read.paths()[0]
        .vertices()
        .iter()
        .map(|v| (v.point, v.bulge))
        .collect();
    assert_eq!(
        found,
        [
            ([0.0, 0.0], -0.25),
            ([-40.0, 0.0], 0.0),
            ([-30.0, 20.0], 0.0)
        ]
    );
    // The reader of drawings of other programs, which has the axes of all directions, agrees.
    let other = torse_exchange::read("x.dxf", mirrored.as_bytes(), None).unwrap();
    let rails = other.curves[0].shape.rail().unwrap().rails().unwrap();
    for ([x, y], _) in &found {
        let near = rails.iter().map(|rail| {
            let found = rail.nearest([*x, *y, 0.0], 1e-9).unwrap();
            found.distance
        });
        assert!(near.fold(f64::INFINITY, f64::min) < 1e-9, "{x} {y}");
    }
    let turned = drawn_across(&drawing, "TEXT", ["0", "0", "-2"]);
    let read = Drawing::from_dxf(&turned).unwrap();
    let text = &read.texts()[0];
    assert_eq!(text.at, [-5.0, 6.0]);
    assert!((text.angle - (std::f64::consts::PI - 0.25)).abs() < 1e-12);
    // Across another direction nothing lies in the plane of the pattern.
    for direction in [["1", "0", "0"], ["0", "0", "0"], ["0", "0.1", "1"]] {
        let tilted = drawn_across(&drawing, "LWPOLYLINE", direction);
        assert!(matches!(
            Drawing::from_dxf(&tilted),
            Err(ExchangeError::Unreadable { what, .. }) if what.contains("plane of x and y")
        ));
    }
}

fn number() -> impl Strategy<Value = f64> {
    prop_oneof![-1e3..1e3_f64, -1e-9..1e-9_f64, Just(0.0)]
}

proptest! {
    #[test]
    fn a_drawing_reads_back_from_dxf_bit_for_bit(
        outline in prop::collection::vec((number(), number(), -2.0..2.0_f64), 3..9),
        bends in prop::collection::vec((number(), number(), -1.0..1.0_f64), 0..4),
        content in "[ -~äλ𝄞]{1,12}", angle in -7.0..7.0_f64,
    ) {
        let mut drawing = Drawing::default();
        let vertices: Vec<Vertex> = outline.iter().map(|&(x, y, b)| vertex(x, y, b)).collect();
        prop_assume!(drawing.path(Layer::Outline, &vertices, true).is_ok());
        for (x, y, angle) in bends {
            drawing.bend([x, y], [x + 1e4, y], angle).unwrap();
        }
        let text = Text { layer: Layer::Marks, at: [1.5, 2.5], height: 3.0, angle, content };
        drawing.text(text.clone()).unwrap();
        drawing.note(&text.content).unwrap();
        prop_assert_eq!(Drawing::from_dxf(&dxf(&drawing).unwrap()).unwrap(), drawing.clone());
        // SVG says radii, not bulges, and angles in degrees; all else comes back bit for bit.
        let read = Drawing::from_svg(&svg(&drawing).unwrap()).unwrap();
        prop_assert_eq!(read.notes(), drawing.notes());
        prop_assert_eq!(&read.texts()[0].content, &drawing.texts()[0].content);
        // The direction of a text, whole turns left out.
        let (x, y) = (read.texts()[0].angle, angle);
        prop_assert!((x.sin() - y.sin()).abs() < 1e-14 && (x.cos() - y.cos()).abs() < 1e-14);
        prop_assert_eq!(read.paths().len(), drawing.paths().len());
        for (read, path) in read.paths().iter().zip(drawing.paths()) {
            prop_assert_eq!((read.layer(), read.is_closed(), read.bend()), (path.layer(), path.is_closed(), path.bend()));
            prop_assert_eq!(read.vertices().len(), path.vertices().len());
            for (a, b) in read.vertices().iter().zip(path.vertices()) {
                prop_assert_eq!(a.point, b.point);
                prop_assert!((a.bulge - b.bulge).abs() < 1e-7 * b.bulge.abs().max(1e-3), "{} {}", a.bulge, b.bulge);
            }
        }
    }
}
