//! Surfaces in general: measured, evaluated, drawn and exported, and not unrolled.

use std::f64::consts::PI;
use torse_designs::eval::{EvalPlaces, eval};
use torse_designs::export::{bytes, mesh};
use torse_designs::inspect::{inspect, table};
use torse_designs::unroll::{Demand, unroll};
use torse_designs::{Design, DesignError, draw, read};

const CURVES: &str = "
    tolerances = { surface = 0.05 }
    curves.meridian = { gbt = [[20, 0, 0], [20, 0, 20], [0, 0, 20]], shape = [0, 0] }
    curves.wave = { gbt = [[10, 0, 0], [15, 0, 8], [5, 0, 16], [12, 0, 24]], shape = [0.5, 0] }
    curves.round = { gbt = [[1, 0, 0], [1, 1, 0], [0, 1, 0]], shape = [0, 0] }
";

fn design(text: &str) -> Design {
    read("x.toml", &format!("{CURVES}{text}")).unwrap_or_else(|e| panic!("{e:?}"))
}

#[test]
fn a_quarter_of_an_ellipse_turned_about_its_axis_is_half_a_sphere() {
    // A GBT quadratic with mu = nu = 0 is the quarter of a circle, exactly.
    let design = design("surfaces.dome = { rotation = \"meridian\" }");
    let report = inspect(&design).unwrap();
    let dome = &report.surfaces[0];
    let exact = 2.0 * PI * 400.0;
    assert!((dome.area - exact).abs() < 1e-6 * exact, "{dome:?}");
    // At the pole the parameters are singular; elsewhere the curvature is 1/r^2.
    assert_eq!(dome.gaussian, None);
    let rows = eval(
        &design,
        Some("dome"),
        &EvalPlaces::Places(vec![[0.25, 0.75]]),
    )
    .unwrap();
    assert_eq!(rows.len(), 4);
    for row in &rows {
        let radius = row.point.iter().map(|c| c * c).sum::<f64>().sqrt();
        assert!((radius - 20.0).abs() < 1e-12 && row.flat.is_none());
        let [a, b] = row.curvatures.unwrap();
        assert!((a.abs() - 0.05).abs() < 1e-9 && (b.abs() - 0.05).abs() < 1e-9);
    }
    let mesh = mesh(&design).unwrap();
    assert!((mesh.area() - exact).abs() < 2e-3 * exact && mesh.area() < exact);
}

#[test]
fn surfaces_go_into_pictures_meshes_and_cad_files_beside_patches() {
    let design = design(
        "surfaces.sheet = { net = [[[0, 0, 0], [0, 30, 5]], [[20, 0, 9], [20, 30, 0]], [[40, 0, 0], [40, 30, 5]]], shape-u = [0.5, 0.25] }
         surfaces.swung = { swung = [\"wave\", \"round\"], factor = 2 }
         surfaces.swept = { swept = [\"meridian\", \"wave\"] }
         patches.tube = { cylinder = \"round\", direction = [0, 0, 5] }",
    );
    let report = inspect(&design).unwrap();
    assert_eq!((report.patches.len(), report.surfaces.len()), (1, 3));
    let sheet = &report.surfaces[0];
    assert_eq!(sheet.degrees, [2, 1]);
    assert!(
        sheet
            .gaussian
            .is_some_and(|[low, high]| low < 0.0 && low <= high)
            && sheet.area > 1200.0
    );
    let text = table(&report);
    assert!(
        text.contains("swung") && text.lines().all(|line| line.chars().count() <= 100),
        "{text}"
    );
    for ending in ["stl", "glb", "step", "igs", "dxf"] {
        assert!(
            bytes(&design, ending, &Demand::default()).unwrap().len() > 400,
            "{ending}"
        );
    }
    assert_eq!(unroll(&design, &Demand::default()).unwrap().len(), 1);
    assert!(
        draw::picture(&design, &Demand::default())
            .unwrap()
            .svg
            .contains("<svg")
    );
    assert!(
        draw::page(&design, &Demand::default())
            .unwrap()
            .contains("\"name\":\"swung\"")
    );
}

#[test]
fn a_design_of_surfaces_alone_has_no_pattern() {
    let design = design("surfaces.swept = { swept = [\"meridian\", \"wave\"] }");
    let error = unroll(&design, &Demand::default()).unwrap_err();
    assert!(matches!(&error, DesignError::NoPatch { design } if design == "x"));
    assert!(
        error
            .help()
            .is_some_and(|help| help.contains("[patches.NAME]"))
    );
    assert!(bytes(&design, "stl", &Demand::default()).is_ok());
    assert!(draw::picture(&design, &Demand::default()).is_ok());
}

#[test]
fn wrong_surfaces_are_refused_with_their_place() {
    let wrong = |text: &str| match read("x.toml", &format!("{CURVES}{text}")) {
        Err(DesignError::Wrong { mistakes }) => {
            mistakes.iter().map(ToString::to_string).collect::<Vec<_>>()
        }
        other => panic!("{other:?}"),
    };
    assert_eq!(
        wrong("surfaces.a = { swung = [\"wave\", \"round\"], factor = -1 }").len(),
        1
    );
    assert_eq!(
        wrong("surfaces.a = { swept = [\"wave\", \"round\"], shape-u = [0, 0] }"),
        ["`shape-u` means nothing for a surface made by `swept`"]
    );
    assert_eq!(
        wrong("surfaces.a = { net = [[[0, 0, 0], [1, 0, 0]], [[0, 1, 0]]] }").len(),
        1
    );
    assert_eq!(wrong("surfaces.a = { rotation = \"wav\" }").len(), 1);
    assert_eq!(
        wrong("surfaces.a = {}"),
        ["[surfaces.a] is made in one of five ways"]
    );
}

fn plain(text: &str) -> Design {
    read("x.toml", text).unwrap_or_else(|e| panic!("{e:?}"))
}

#[test]
fn what_the_papers_construct_can_be_written() {
    // gbt-surfaces Example 3.5 with a matrix of eq. (28) for each control point, and Example 3.2 with Q31 corrected.
    let design = plain(
        r#"
[curves]
section = { gbt = [[2, 0, 2], [1, 0, 3], [5, 0, 4], [6, 0, 3]], shape = [0.5, 0.5] }
trajectory = { gbt = [[4, 0, 0], [0, 1, 0], [0, 2, 0], [4, 3, 0]], shape = [0.5, 0.5] }
[surfaces.swept]
swept = ["section", "trajectory"]
matrices = [
    [[1, 0, 0], [0, 1, 0], [0, 0, 1]],
    [[0.5, 0, 0], [0, 0.5, 0], [0, 0, 0.5]],
    [[0, 0, 0], [0, 0, 0], [0, 0, 0]],
    [[-0.5, 0, 0], [0, -0.5, 0], [0, 0, -0.5]],
]
[surfaces.net]
bilinear = [[0, 0, 0], [0, 3, 0], [3, 0, 0], [3, 3, 0]]
interior = [[1, 1, 3], [1, 2, 3], [2, 1, 3], [2, 2, 3]]
shape-u = [0.5, 0.5]
shape-v = [0.5, 0.5]
"#,
    );
    let point = |surface: usize, u: f64, v: f64| {
        torse_geometry::Surface::point(&design.surfaces[surface].parts[0], &u, &v).unwrap()
    };
    let near = |a: [f64; 3], b: [f64; 3]| {
        assert!((0..3).all(|k| (a[k] - b[k]).abs() < 1e-12), "{a:?} {b:?}");
    };
    near(point(0, 1.0, 0.0), [10.0, 0.0, 3.0]);
    near(point(0, 1.0, 1.0), [1.0, 3.0, -1.5]);
    let row: Vec<[f64; 3]> = design.surfaces[1].parts[0].rows().nth(3).unwrap().to_vec();
    near(row[1], [3.0, 1.0, 0.0]);
    near(row[2], [3.0, 2.0, 0.0]);
}

#[test]
fn tensions_and_the_oblique_edge_as_printed_are_inputs() {
    // hermite-developable Sect. 3.1 with the tensions 3/2 and 3/4.
    let cone = |data: &str, more: &str| {
        plain(&format!(
            "[patches.cone]
             hermite = {{ degree = 3, ratio = 2, summit = [170, 0, 45], {data} }}
             {more}"
        ))
    };
    let q = "q = [[-20, 60, 45], [-20, -50, 45], [0, -30, 60], [0, -50, -60]]";
    let tensed = cone(&format!("{q}, tension = [1.5, 0.75]"), "");
    let written = cone(
        "q = [[-20, 60, 45], [-20, -50, 45], [0, -45, 90], [0, -37.5, -45]]",
        "",
    );
    for u in [0.0, 0.3, 1.0] {
        let [a, b] = [&tensed, &written].map(|d| d.patches[0].sheet.ruling(u).unwrap());
        assert_eq!(a, b);
    }
    // The polynomial edge of Sect. 4 leaves the cone: what is between it and q is not developable.
    let plane = "between = [20, -3, 0, -580]";
    let exact = inspect(&cone(q, plane)).unwrap();
    let printed = inspect(&cone(&format!("{q}, as-printed = true"), plane)).unwrap();
    assert!(exact.patches[0].developable.holds() && exact.patches[0].twist_measured[0] < 1e-6);
    assert!(
        printed.patches[0].twist_measured[0] > 0.01,
        "{:?}",
        printed.patches[0]
    );
    let mistake = read(
        "x.toml",
        "[patches.cone]\nhermite = { ratio = 2, summit = [170, 0, 45], q = [[-20, 60, 45], [-20, -50, 45], [0, -30, 60], [0, -50, -60]], as-printed = true }",
    );
    assert!(mistake.is_err());
}
