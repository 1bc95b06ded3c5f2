//! Faces of files of other programs: judged, and unrolled where they have rulings between two edges.

use crate::step_text::StepText;
use std::path::{Path, PathBuf};
use torse_designs::audit::FaceAudit;
use torse_designs::inspect::{Assurance, inspect};
use torse_designs::listing::list;
use torse_designs::unroll::{Demand, parts, unroll};
use torse_designs::{DesignError, Ending, export, load, read};
use torse_exchange::{
    FaceBorder, FilePlace, ImportedFace, SplineSurface, SurfaceFrame, SurfaceShape,
};
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
        border: FaceBorder::OwnOfSurface,
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
    assert_eq!(audit.developable, Assurance::Within, "{}", audit.words);
    assert!(
        audit.words.starts_with("not exactly; within"),
        "{}",
        audit.words
    );
}

/// A cylinder over the cubic (0, 0, 0), (30, 0, 40), (70, 0, 40), (100, 0, 0), 75 wide, of degree three in both
/// directions, its lines passed with these shares of the way, and with this much added to each coordinate.
fn raised(shares: [Rational; 4], added: impl Fn(usize, usize, usize) -> Rational) -> SplineSurface {
    let bend = [[0, 0], [30, 40], [70, 40], [100, 0]];
    let point = |i: usize, j: usize| {
        let [x, z] = bend[i].map(integer);
        let y = integer(75) * shares[j].clone();
        [x + added(i, j, 0), y + added(i, j, 1), z + added(i, j, 2)]
    };
    let row = |i: usize| (0..4).map(|j| point(i, j)).collect::<Vec<_>>();
    let ends = [vec![integer(0); 4], vec![integer(1); 4]].concat();
    let net = (0..4).map(row).collect();
    SplineSurface::new([3, 3], [ends.clone(), ends], net, None).unwrap()
}

#[test]
fn a_cylinder_of_degree_three_along_its_rulings_is_ruled_whatever_the_speed_on_them() {
    let third = |n: i64| ratio(n, 3).unwrap();
    let even = [third(0), third(1), third(2), third(3)];
    let slow = [integer(0), integer(0), ratio(1, 7).unwrap(), integer(1)];
    for shares in [even, slow] {
        let surface = raised(shares, |_, _, _| integer(0));
        let straight = surface.straightened().unwrap().unwrap();
        assert_eq!((straight.distance, straight.surface.degrees), (0.0, [3, 1]));
        let audit = face(SurfaceShape::Spline(surface));
        assert_eq!(audit.developable, Assurance::Proved, "{}", audit.words);
    }
    // Back and forth on its rulings it is no part of the ruled surface that is met once.
    let back = raised([integer(0), third(2), third(1), integer(1)], |_, _, _| {
        integer(0)
    });
    assert!(back.straightened().unwrap().is_none());
}

#[test]
fn the_rounding_of_a_cylinder_is_within_what_its_control_points_are_moved_by() {
    let third = |n: i64| ratio(n, 3).unwrap();
    let even = || [third(0), third(1), third(2), third(3)];
    // One inner control point lifted by 1e-5 mm, and nothing else: the surface moves by 4/9 of 4/9 of it at most.
    let lifted = raised(even(), |i, j, k| {
        if (i, j, k) == (1, 1, 2) {
            ratio(1, 100_000).unwrap()
        } else {
            integer(0)
        }
    });
    let found = lifted.straightened().unwrap().unwrap();
    assert!(
        (1.97e-6..=1.001e-5).contains(&found.distance),
        "{}",
        found.distance
    );
    let audit = face(SurfaceShape::Spline(lifted));
    assert_eq!(audit.developable, Assurance::Within, "{}", audit.words);
    assert!(audit.words.starts_with("within 1.0"), "{}", audit.words);
    assert!(
        audit.words.contains("mm of a developable"),
        "{}",
        audit.words
    );
    // By a millimetre it is no rounding.
    let dented = raised(even(), |i, j, k| integer(i64::from((i, j, k) == (1, 1, 2))));
    assert!(dented.straightened().unwrap().is_none());
    assert_eq!(
        face(SurfaceShape::Spline(dented)).developable,
        Assurance::No
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

/// The area of the parts of a file with this text.
fn area_of(name: &str, text: &[u8]) -> Result<f64, DesignError> {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join(name);
    std::fs::write(&path, text).unwrap();
    let design = load(&path)?;
    assert!(design.left_out.is_empty(), "{:?}", design.left_out);
    let made = parts(&design, &unroll(&design, &Demand::default())?)?;
    Ok(made.iter().map(|part| part.area()).sum())
}

#[test]
fn a_trimmed_surface_without_an_outer_curve_is_cut_along_its_own_border() {
    // Half a pipe of radius 50 and length 100; a window of 60 degrees by 40.
    let text = std::fs::read(file("half_pipe_inner_border.igs")).unwrap();
    let found = area_of("pipe.igs", &text).unwrap();
    let area = std::f64::consts::PI * 50.0 * (100.0 - 40.0 / 3.0);
    assert!((found - area).abs() < 1e-3, "{found} {area}");
    // A loop of which a curve is not read leaves no part that would do for the face.
    let text = String::from_utf8(text)
        .unwrap()
        .replace("142,0,3,0,15,2;", "142,0,3,0,9,2; ");
    let refused = area_of("pipe.igs", text.as_bytes())
        .unwrap_err()
        .to_string();
    assert!(
        refused.contains("a part of its border is not read"),
        "{refused}"
    );
}

#[test]
fn files_with_openings_are_read_back_with_the_area_of_their_design() {
    let corner = |k: u32, shift: f64| {
        let up = if k.is_multiple_of(2) { 20.0 } else { -20.0 };
        format!("[{}, {}, 0], ", 4.5 * f64::from(k) - 45.0, up + shift)
    };
    let there: String = (0..=20).map(|k| corner(k, 1.0)).collect();
    let back: String = (0..=20).rev().map(|k| corner(k, -1.0)).collect();
    let design = read(
        "parts.toml",
        &format!(
            "[curves]\nrim = {{ arc = {{ centre = [0, 0, 0], from = [60, 0, 0], axis = [0, 0, 1], angle = 120 }} }}\n\
             a = {{ bezier = [[100, 0, 0], [200, 0, 0]] }}\nb = {{ bezier = [[100, 80, 0], [200, 80, 0]] }}\n\
             slot = {{ polyline = [{there}{back}[-45, 21, 0]] }}\n[patches]\n\
             cyl = {{ cylinder = \"rim\", direction = [0, 0, 100], marks = [{{ at = [0.5, 0.5], radius = 5 }}] }}\n\
             plate = {{ ruled = [\"a\", \"b\"], marks = [{{ opening = \"slot\", at = [0.5, 0.5], angle = 90 }}] }}\n"
        ),
    )
    .unwrap();
    let made = parts(&design, &unroll(&design, &Demand::default()).unwrap()).unwrap();
    // The slot is longer around than the plate.
    assert!(made[1].openings[0].shape.length() > 360.0);
    let area: f64 = made.iter().map(|part| part.area()).sum();
    let around: f64 = made.iter().map(|part| part.cut_length()).sum();
    for ending in ["iges", "step"] {
        let bytes = export::bytes(&design, ending, &Demand::default()).unwrap();
        let found = area_of(&format!("parts.{ending}"), &bytes).unwrap();
        // Cubics stand for the openings there.
        assert!(
            (found - area).abs() < 1e-3 * around,
            "{ending}: {found} {area}"
        );
    }
}

#[test]
fn a_face_whose_border_is_not_read_has_no_pattern() {
    let step = std::fs::read_to_string(file("plate_holes.step")).unwrap();
    let bound = step.find("FACE_BOUND").expect("a bound");
    let start = bound + step[bound..].find('#').unwrap() + 1;
    let digits: String = step[start..]
        .chars()
        .take_while(char::is_ascii_digit)
        .collect();
    let text = step.replacen(
        &format!("#{digits} = EDGE_LOOP"),
        &format!("#{digits} = POLY_LOOP"),
        1,
    );
    assert_ne!(text, step);
    let refused = area_of("plate.step", text.as_bytes())
        .unwrap_err()
        .to_string();
    assert!(
        refused.contains("a part of its border is not read"),
        "{refused}"
    );
}

#[test]
fn a_bilinear_face_is_unrolled_whichever_of_its_edges_comes_first() {
    let corners = [
        [0.0, 0.0, 0.0],
        [0.0, 500.0, 1.0],
        [510.0, 500.0, 1.001],
        [500.0, 0.0, 0.0],
    ];
    for first in 0..4 {
        let mut text = StepText::new();
        let points = corners.map(|at| text.point(at));
        let [a, b, d, c] = points;
        let surface = text.entity(&format!(
            "B_SPLINE_SURFACE_WITH_KNOTS('',1,1,((#{a},#{b}),(#{c},#{d})),.UNSPECIFIED.,.F.,.F.,.F.,(2,2),(2,2),(0.,1.),(0.,1.),.UNSPECIFIED.)"
        ));
        let mut turned = corners;
        turned.rotate_left(first);
        let border = text.polygon(&turned);
        text.face("sheet", surface, &[border]);
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("sheet.step");
        std::fs::write(&path, text.finish()).unwrap();
        let design = load(&path).unwrap();
        assert!(design.left_out.is_empty(), "{first}: {:?}", design.left_out);
        let demand = Demand {
            allow_strain: 0.01,
            ..Demand::default()
        };
        let made = parts(&design, &unroll(&design, &demand).unwrap()).unwrap();
        let area: f64 = made.iter().map(|part| part.area()).sum();
        assert!((area - 252_500.505).abs() < 0.01, "{first}: {area}");
    }
}

#[test]
fn a_listing_says_that_its_lengths_are_in_millimetres_whatever_the_file_has() {
    let table = "x [in],y,z\n0,0,0\n3,4,0\n";
    let found = list("sheer.csv", table.as_bytes(), None).unwrap();
    assert_eq!(found.unit, "in, stated by the file");
    let text = found.text();
    assert!(
        text.contains("lengths of the file in inches, stated by the file; lengths below in mm"),
        "{text}"
    );
    assert!(text.contains("127"), "{text}");
}

#[test]
fn faces_of_degree_three_along_their_rulings_are_unrolled_as_ruled_ones() {
    // Areas by OpenCASCADE; of the cone 3 radians of radii 30 to 20 over a height of 50.
    let cone = 3.0 * 25.0 * 2600.0_f64.sqrt();
    let all = [
        ("bicubic_cylinder.step", 9072.53, Assurance::Proved),
        ("bicubic_cylinder_rounded.step", 9072.53, Assurance::Within),
        ("turned_segment.step", cone, Assurance::ByConstruction),
    ];
    for (name, area, developable) in all {
        let design = load(&file(name)).unwrap();
        let rounded = design.patches[0]
            .notes
            .iter()
            .any(|note| note.contains("within 1.38e-5 mm"));
        assert_eq!(
            rounded,
            developable == Assurance::Within,
            "{:?}",
            design.patches[0].notes
        );
        let report = inspect(&design).unwrap();
        assert_eq!(report.patches[0].developable, developable, "{name}");
        let pieces = unroll(&design, &Demand::default()).unwrap();
        let found = pieces[0].flat.area();
        assert!((found - area).abs() < 6e-3, "{name} {found} {area}");
    }
}
