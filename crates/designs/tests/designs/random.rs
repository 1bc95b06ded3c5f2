//! Random patches: no NaN, no empty interval, never "regular" where the patch is not.

use proptest::prelude::*;
use std::fmt::Write;
use torse_designs::inspect::{Assurance, PatchReport, ValueBounds, inspect_within};
use torse_designs::unroll::{Demand, unroll};
use torse_designs::{DesignError, read};
use torse_geometry::Surface;
use torse_geometry::prelude::MeasureBudget;
use torse_geometry::vector::norm;

/// Every number of a report is finite, every interval holds something.
fn sound(report: &PatchReport) {
    let finite = |value: f64| assert!(value.is_finite(), "{report:?}");
    report.twist_measured.into_iter().for_each(finite);
    report.rulings.into_iter().for_each(finite);
    [
        report.gaussian,
        report.radius,
        report.inside_radius,
        report.area,
    ]
    .into_iter()
    .flatten()
    .for_each(finite);
    for ValueBounds { low, high, .. } in
        [Some(report.twist), report.clearance].into_iter().flatten()
    {
        if let (Some(low), Some(high)) = (low, high) {
            assert!(low <= high, "{report:?}");
        }
    }
    assert!(report.rulings[0] <= report.rulings[1] && report.area.is_none_or(|a| a >= 0.0));
}

/// Looks on a fine grid for a ruling on which the normals vanish or oppose, and for a place where they turn over however
/// closely one looks.
fn singular_on_a_grid(text: &str) -> bool {
    let design = read("x.toml", text).unwrap();
    let sheet = &design.patches[0].sheet;
    let dot = |a: &[f64; 3], b: &[f64; 3]| a.iter().zip(b).map(|(x, y)| x * y).sum::<f64>();
    let normal = |u: f64, v: f64| sheet.partials(&u, &v, 1).map(|p| p.normal());
    let mut before: Option<[f64; 3]> = None;
    for k in 0..=400 {
        let u = f64::from(k) / 400.0;
        let (Ok(n0), Ok(n1)) = (normal(u, 0.0), normal(u, 1.0)) else {
            return true;
        };
        if norm(&n0) == 0.0 || norm(&n1) == 0.0 || dot(&n0, &n1) < 0.0 {
            return true;
        }
        if let Some(m0) = before {
            let (mut low, mut high) = ((u - 1.0 / 400.0, m0), (u, n0));
            let mut steps = 0;
            while dot(&low.1, &high.1) < 0.0 {
                // A sheet that is bent tightly turns between samples, but not at one place.
                steps += 1;
                let middle = 0.5 * (low.0 + high.0);
                let Ok(n) = normal(middle, 0.0) else {
                    return true;
                };
                if steps > 40 {
                    return true;
                }
                if dot(&low.1, &n) < dot(&n, &high.1) {
                    high = (middle, n);
                } else {
                    low = (middle, n);
                }
            }
        }
        before = Some(n0);
    }
    false
}

fn point() -> impl Strategy<Value = [i32; 3]> {
    prop::array::uniform3(-40..40_i32)
}

fn text_of(kind: u8, points: &[[i32; 3]], shape: [i8; 2]) -> String {
    let list = |points: &[[i32; 3]]| {
        let items: Vec<String> = points.iter().map(|p| format!("{p:?}")).collect();
        format!("[{}]", items.join(", "))
    };
    let shape = format!("[\"{}/8\", \"{}/8\"]", shape[0], shape[1]);
    let mut text = String::new();
    let _ = match kind {
        // Rails with equal directions are developable; the rest mostly is not.
        0 => {
            let moved: Vec<[i32; 3]> = points[..4]
                .iter()
                .map(|[x, y, z]| [2 * x + 3, 2 * y - 5, 2 * z + 50])
                .collect();
            writeln!(
                text,
                "curves.a = {{ gbt = {}, shape = {shape} }}\ncurves.b = {{ gbt = {}, shape = {shape} }}\n\
                 patches.p = {{ ruled = [\"a\", \"b\"] }}",
                list(&points[..4]),
                list(&moved)
            )
        }
        1 => writeln!(
            text,
            "curves.a = {{ bezier = {} }}\ncurves.b = {{ gbt = {}, shape = {shape} }}\npatches.p = {{ ruled = [\"a\", \"b\"] }}",
            list(&points[..3]),
            list(&points[3..6])
        ),
        2 => writeln!(
            text,
            "curves.a = {{ bezier = {} }}\npatches.p = {{ cone = \"a\", apex = {:?}, range = [1, 0.4] }}",
            list(&points[..4]),
            points[4]
        ),
        3 => {
            let planes: Vec<String> = points[..4]
                .iter()
                .zip(points[4..].iter().chain(points))
                .map(|([p, q, r], [s, _, _])| format!("[{p}, {q}, {}, {}]", r.abs() + 1, 3 * s))
                .collect();
            writeln!(
                text,
                "families.f = {{ gbt = [{}], shape = {shape} }}\n\
                 patches.p = {{ envelope = \"f\", between = [[0, 0, 1, 0], [0, 0, 1, 4]] }}",
                planes.join(", ")
            )
        }
        _ => writeln!(
            text,
            "curves.a = {{ bezier = {} }}\npatches.p = {{ cylinder = \"a\", direction = {:?}, part = [0.1, 0.8] }}",
            list(&points[..4]),
            points[4]
        ),
    };
    text
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 500, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn random_patches_are_judged_soundly(
        kind in 0..5_u8,
        points in prop::collection::vec(point(), 6..=6),
        shape in prop::array::uniform2(-8..=8_i8),
    ) {
        let text = text_of(kind, &points, shape);
        let design = match read("x.toml", &text) {
            Ok(design) => design,
            // What the geometry refuses at the door, with its words.
            Err(DesignError::Wrong { mistakes }) => {
                prop_assert!(!mistakes.is_empty());
                return Ok(());
            }
            Err(other) => panic!("{other}"),
        };
        let budget = MeasureBudget { cells: 8, ..MeasureBudget::default() };
        let Ok(report) = inspect_within(&design, budget) else { return Ok(()) };
        let patch = &report.patches[0];
        sound(patch);
        if patch.regular.holds() {
            prop_assert!(!singular_on_a_grid(&text), "{text}\n{patch:?}");
        }
        if let Ok(pieces) = unroll(&design, &Demand::default()) {
            let flat = &pieces[0].flat;
            prop_assert!(flat.errors().outline.is_finite() && flat.area().is_finite());
            let high = patch.clearance.and_then(|bounds| bounds.high);
            // An edge of regression along the border is no obstacle to cutting.
            let inside = high.is_some_and(|high| high < -1e-6 * patch.rulings[1]);
            prop_assert!(!inside, "a pattern of a singular patch\n{text}\n{patch:?}");
            prop_assert!((flat.area() - patch.area.unwrap()).abs() <= 1e-5 * flat.area() + 1e-6, "{text}");
            prop_assert!(patch.developable != Assurance::No, "{text}");
        }
    }
}
