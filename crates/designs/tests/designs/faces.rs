//! Faces of files of other programs: judged, and unrolled where they have rulings between two edges.

use std::path::{Path, PathBuf};
use torse_designs::audit::FaceAudit;
use torse_designs::inspect::{Assurance, inspect};
use torse_designs::listing::list;
use torse_designs::unroll::{Demand, parts, unroll};
use torse_designs::{DesignError, Ending, load};
use torse_exchange::{FilePlace, ImportedFace, SplineSurface, SurfaceFrame, SurfaceShape};
use torse_numbers::rational::{Rational, integer, ratio};

fn file(name: &str) -> PathBuf {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/files");
    folder.join(name)
}

fn face(surface: SurfaceShape) -> FaceAudit {
    let face = ImportedFace {
        name: "face".to_owned(),
        place: FilePlace::line(1),
        surface,
        loops: Vec::new(),
        forward: true,
    };
    FaceAudit::of_surface(&face).unwrap()
}

/// The B-spline surface of one Bezier patch of degrees 3 and 2 with these heights over a grid of steps 10.
fn spline(height: impl Fn(i64, i64) -> Rational) -> SurfaceShape {
    let row = |i: i64| {
        let point = |j: i64| [integer(10 * i), integer(10 * j), height(i, j)];
        (0..3).map(point).collect::<Vec<_>>()
    };
    let knots = |degree: usize| {
        let (zero, one) = (integer(0), integer(1));
        let ends = [vec![zero; degree + 1], vec![one; degree + 1]];
        ends.concat()
    };
    let net = (0..4).map(row).collect();
    SurfaceShape::Spline(SplineSurface::new([3, 2], [knots(3), knots(2)], net, None).unwrap())
}

#[test]
fn the_conical_face_of_a_step_file_is_unrolled() {
    let design = load(&file("cone_face.step")).unwrap();
    let report = inspect(&design).unwrap();
    assert!(report.missed.is_empty(), "{:?}", report.missed);
    assert_eq!(
        (report.patches[0].developable, report.patches[0].regular),
        (Assurance::ByConstruction, Assurance::Proved)
    );
    let pieces = unroll(&design, &Demand::default()).unwrap();
    // Radii 50 and 25, 80 high: pi (50 + 25) times the slant height.
    let area = std::f64::consts::PI * 75.0 * 7025.0_f64.sqrt();
    let found = pieces[0].flat.area();
    assert!((found - area).abs() < 1e-6 * area, "{found} {area}");
}

#[test]
fn a_ruled_face_that_twists_is_judged_and_refused_with_its_angle() {
    let path = file("ruled_face.step");
    let bytes = std::fs::read(&path).unwrap();
    let listing = list("ruled_face.step", &bytes, None).unwrap();
    let audit = listing.faces[0].audit.clone().unwrap();
    assert_eq!(audit.developable, Assurance::No);
    // By de Boor's algorithm on 40001 rulings in another language: the first of them.
    let [low, high] = audit.twist.unwrap();
    assert!(
        low <= 8.360_165_155_4 && 8.360_165_155_3 <= high,
        "{low} {high}"
    );
    assert!(high - low < 0.5, "{low} {high}");
    let worst = audit.worst.unwrap();
    let end = worst.ruling.unwrap();
    let away = |a: [f64; 3], b: [f64; 3]| (0..3).map(|k| (a[k] - b[k]).abs()).fold(0.0, f64::max);
    assert!(away(worst.point, [0.0; 3]) < 1e-9 && away(end, [0.0, 40.0, 300.0]) < 1e-9);
    assert!(
        listing
            .text()
            .contains("no, proved: tangent planes turn by")
    );
    let design = load(&path).unwrap();
    let refused = unroll(&design, &Demand::default()).unwrap_err();
    assert_eq!(refused.ending(), Ending::Missed);
    assert!(matches!(refused, DesignError::Unroll { .. }), "{refused}");
    let strained = Demand {
        allow_strain: 0.01,
        ..Demand::default()
    };
    assert!(unroll(&design, &strained).unwrap()[0].flat.is_strained());
}

#[test]
fn a_file_without_faces_is_still_named_in_one_line() {
    let refused = load(&file("hopper-inch.dxf")).unwrap_err();
    assert!(
        matches!(refused, DesignError::OtherKind { .. }),
        "{refused}"
    );
}

#[test]
fn spline_faces_are_decided_exactly() {
    // A parabola moved along a line, in both directions of the parameters.
    for along in [true, false] {
        let bent = |i: i64, j: i64| {
            let k = if along { i } else { j };
            integer([0, 5, 7, 4][usize::try_from(k).unwrap()])
        };
        let audit = face(spline(bent));
        assert_eq!(audit.developable, Assurance::Proved, "{}", audit.words);
    }
    // One control point lifted.
    let dented = |i: i64, j: i64| {
        if (i, j) == (1, 1) {
            integer(3)
        } else {
            integer(0)
        }
    };
    let audit = face(spline(dented));
    assert_eq!(audit.developable, Assurance::No, "{}", audit.words);
    assert!(audit.worst.unwrap().gaussian.unwrap().abs() > 1e-6);
    // A cylinder whose numbers lost their last digits is none, but told from what is dented.
    let rounded = |i: i64, j: i64| {
        let height = integer([0, 5, 7, 4][usize::try_from(i).unwrap()]);
        height + ratio(j, 1_000_000_000_000_000).unwrap() * ratio(i, 3).unwrap()
    };
    let audit = face(spline(rounded));
    assert_eq!(audit.developable, Assurance::Measured, "{}", audit.words);
    assert!(
        audit.words.starts_with("not exactly, proved"),
        "{}",
        audit.words
    );
}

#[test]
fn analytic_faces_are_what_they_are() {
    let frame = SurfaceFrame {
        origin: [1.0, 2.0, 3.0],
        axis: [0.0, 0.0, 1.0],
        across: [1.0, 0.0, 0.0],
    };
    for surface in [
        SurfaceShape::Plane(frame),
        SurfaceShape::Cylinder(frame, 5.0),
        SurfaceShape::Cone(frame, 5.0, 0.3),
    ] {
        assert_eq!(face(surface).developable, Assurance::ByConstruction);
    }
    let gaussian = |surface| face(surface).worst.unwrap().gaussian.unwrap();
    assert_eq!(gaussian(SurfaceShape::Sphere(frame, 5.0)), 0.04);
    // The tube of radius 2 about a circle of 8: greatest on the outside, 1/(2 * 10).
    assert_eq!(gaussian(SurfaceShape::Torus(frame, 8.0, 2.0)), 0.05);
    let line = |from: [i64; 3], to: [i64; 3]| {
        let curve = torse_exchange::CurveShape::line(from.map(integer), to.map(integer));
        SurfaceShape::Revolved(Box::new(curve.unwrap()), frame)
    };
    // A line that meets the axis makes a cone, a skew one a hyperboloid.
    let cone = face(line([6, 2, 3], [4, 2, 8]));
    assert_eq!(cone.developable, Assurance::Measured, "{}", cone.words);
    let skew = face(line([6, 2, 3], [4, 7, 8]));
    assert_eq!(skew.developable, Assurance::No, "{}", skew.words);
    assert!(skew.worst.unwrap().gaussian.unwrap() < 0.0);
}

#[test]
fn faces_without_a_pattern_are_left_out_by_name_and_reason() {
    let step = std::fs::read_to_string(file("cone_face.step")).unwrap();
    // A second face with the same border on a ball, and a third on a surface that is not read.
    let more = step
        .replace("OPEN_SHELL('',(#35))", "OPEN_SHELL('',(#35,#9035,#9036))")
        .replace(
            "#36 = FACE_BOUND",
            "#9035 = ADVANCED_FACE('ball',(#36),#9049,.T.);\n#9049 = SPHERICAL_SURFACE('',#50,50.);\n\
             #9036 = ADVANCED_FACE('odd',(#36),#9050,.T.);\n#9050 = OFFSET_SURFACE('',#49,1.,.F.);\n#36 = FACE_BOUND",
        );
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("parts.step");
    std::fs::write(&path, &more).unwrap();
    let design = load(&path).unwrap();
    assert_eq!(
        design.patches.len(),
        load(&file("cone_face.step")).unwrap().patches.len()
    );
    let names: Vec<&str> = design
        .left_out
        .iter()
        .map(|face| face.name.as_str())
        .collect();
    assert_eq!(names, ["ball", "1 face on OFFSET_SURFACE"]);
    assert!(
        design.left_out[0].reason.contains("no, by construction"),
        "{:?}",
        design.left_out
    );
    // A file that ends in the middle is refused with the line, not as if it were of another kind.
    std::fs::write(&path, &more[..more.len() / 2]).unwrap();
    let error = load(&path).unwrap_err();
    assert!(matches!(error, DesignError::Listing { .. }), "{error}");
    assert!(error.to_string().contains("line "), "{error}");
}

/// OpenCASCADE made the files, and says how large each face is and how long all of its edges are together, the seam twice.
#[test]
fn the_openings_of_the_faces_of_a_step_file_are_cut() {
    for (name, openings, area, around) in [
        ("plate_holes.step", 2, 8_896.433_659_53, 550.247_779_607),
        ("pipe_hole.step", 1, 61_548.352_277_75, 1_155.339_759_319),
        ("cone_hole.step", 1, 29_043.168_838_29, 851.670_770_694),
    ] {
        let design = load(&file(name)).unwrap();
        assert!(design.left_out.is_empty(), "{:?}", design.left_out);
        let pieces = unroll(&design, &Demand::default()).unwrap();
        let made = parts(&design, &pieces).unwrap();
        let [part] = made.as_slice() else {
            panic!("{name}: {} parts", made.len())
        };
        assert_eq!(part.openings.len(), openings, "{name}");
        assert!(part.error <= 0.01, "{name}: {}", part.error);
        let room = part.error * part.cut_length();
        let off = (part.area() - area).abs();
        assert!(off <= room, "{name}: {} {area}", part.area());
        let longer = (part.cut_length() - around).abs();
        assert!(longer < 0.02, "{name}: {} {around}", part.cut_length());
    }
}

#[test]
fn a_loop_beside_its_face_is_refused_with_its_place() {
    let step = std::fs::read_to_string(file("plate_holes.step")).unwrap();
    // The round hole, at (30, 10), goes over the edge of the plate, which ends at x = 60.
    let moved = step.replace("(30.,10.,1.)", "(55.,10.,1.)");
    assert_ne!(step, moved);
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("plate.step");
    std::fs::write(&path, moved).unwrap();
    let design = load(&path).unwrap();
    let pieces = unroll(&design, &Demand::default()).unwrap();
    let error = parts(&design, &pieces).unwrap_err().to_string();
    assert!(error.contains("the opening `loop"), "{error}");
    assert!(error.contains("leaves the sheet"), "{error}");
}
