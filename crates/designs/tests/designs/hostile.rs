//! Files that were made to break the reader or to keep it busy.

use std::time::{Duration, Instant};
use torse_designs::eval::{EvalPlaces, eval};
use torse_designs::inspect::{PatchReport, inspect_within};
use torse_designs::unroll::{Demand, unroll};
use torse_designs::{DesignError, MAX_BYTES, load, read};
use torse_geometry::pattern::PatternError;
use torse_geometry::prelude::MeasureBudget;

/// What is known of a class of patches from the way it is made.
#[derive(Debug, Clone, Copy, PartialEq)]
enum Truth {
    /// Never regular.
    Singular,
    /// Flat, and its pattern lies over itself.
    Overlaps,
    /// Regular, or not, with the size.
    Open,
}

/// Patches that are wrong each in its own way: huge, tiny, degenerate, self-crossing, through infinity.
fn patches() -> Vec<(Truth, String)> {
    let sizes = [
        "1e-300", "1e-150", "1e-30", "1e-9", "1", "1e9", "1e30", "1e150", "1e300", "-1",
    ];
    let shapes = [
        // A patch of width zero.
        (Truth::Singular, "curves.a = { bezier = [[0, 0, 0], [S, S, 0], [0, S, S]] }\npatches.p = { ruled = [\"a\", \"a\"] }"),
        // A cusp on both rails.
        (Truth::Singular, "curves.a = { bezier = [[S, -S, 0], [\"-S/3\", S, 0], [\"-S/3\", -S, 0], [S, S, 0]] }
         curves.b = { bezier = [[S, -S, S], [\"-S/3\", S, S], [\"-S/3\", -S, S], [S, S, S]] }
         patches.p = { ruled = [\"a\", \"b\"] }"),
        // An apex in the middle.
        (Truth::Singular, "curves.a = { bezier = [[S, 0, 0], [0, S, 0]] }\ncurves.b = { bezier = [[-S, 0, S], [0, -S, S]] }
         patches.p = { ruled = [\"a\", \"b\"] }"),
        // A point.
        (Truth::Singular, "curves.a = { bezier = [[S, S, S], [S, S, S]] }\npatches.p = { ruled = [\"a\", \"a\"] }"),
        // A cylinder along its own curve.
        (Truth::Singular, "curves.a = { bezier = [[0, 0, 0], [S, 0, 0], [S, S, 0]] }\npatches.p = { cylinder = \"a\", direction = [S, 0, 0] }"),
        // A cone whose curve passes its apex.
        (Truth::Singular, "curves.a = { bezier = [[-S, 0, 0], [0, 0, 0], [S, 0, 0]] }\npatches.p = { cone = \"a\", apex = [0, 0, 0] }"),
        // Planes scaled by anything.
        (Truth::Open, "families.f = { gbt = [[S, 0, S, S], [0, S, S, S], [-S, 0, S, S], [0, -S, S, 0]], shape = [1, -1] }
         patches.p = { envelope = \"f\", between = [[0, 0, S, 0], [0, 0, S, S]] }"),
        // The sign of one plane lost: the surface runs through infinity.
        (Truth::Open, "families.f = { bernstein = [[S, 0, 0, S], [\"-S/2\", \"-S\", 0, S], [0, S, S, S]] }
         patches.p = { envelope = \"f\", range = [-S, S] }"),
        // The edge of regression itself.
        (Truth::Open, "families.f = { bernstein = [[0, 0, S, 0], [0, -S, S, 0], [S, -S, S, 0], [S, -S, 1, S]] }
         patches.p = { tangent = \"f\", range = [0, S] }"),
        // Two free curves in a plane.
        (Truth::Singular, "curves.a = { bezier = [[0, 0, 0], [S, S, 0], [S, 0, 0]] }\ncurves.b = { bezier = [[0, S, 0], [S, S, 0]] }
         patches.p = { connect = [\"a\", \"b\"] }"),
        // All rulings parallel, and one of them along its rail.
        (Truth::Singular, "curves.a = { bezier = [[0, 0, 0], [S, 0, -S], [S, S, 0], [0, S, S]] }\npatches.p = { cylinder = \"a\", direction = [0, S, S] }"),
        // A ring that goes round more than once: in the plane, where it lies on itself.
        (Truth::Overlaps, "curves.a = { bezier = [[S, 0, 0], [S, S, 0], [0, S, 0], [-S, S, 0], [-S, 0, 0], [-S, -S, 0], [0, -S, 0], [S, -S, 0],
             [S, 0, 0], [S, S, 0], [0, S, 0], [-S, S, 0], [-S, 0, 0], [-S, -S, 0], [0, -S, 0]] }
         patches.p = { cone = \"a\", apex = [0, 0, 0], range = [1, 0.5] }"),
        // A needle: one control point of 24 far out.
        (Truth::Open, "curves.a = { bezier = [[0, 0, 0], [S, 0, 0], [S, 0, 0], [S, 0, 0], [S, 0, 0], [S, 0, 0], [S, 0, 0], [S, 0, 0], [S, 0, 0],
             [S, 0, 0], [S, 0, 0], [\"9999*S\", 0, S], [S, 0, 0], [S, 0, 0], [S, 0, 0], [S, 0, 0], [S, 0, 0], [S, 0, 0], [S, 0, 0],
             [S, 0, 0], [S, 0, 0], [S, 0, 0], [S, 0, 0], [0, 0, S]] }\npatches.p = { cylinder = \"a\", direction = [0, S, 0] }"),
    ];
    let mut all = Vec::new();
    for size in sizes {
        for (truth, shape) in shapes {
            let text = shape.replace("\"9999*S\"", &format!("\"9999*({})\"", formula(size)));
            let text = text.replace(
                "\"-S/3\"",
                &format!("\"0 - ({size_f})/3\"", size_f = formula(size)),
            );
            let text = text.replace("\"-S/2\"", &format!("\"0 - ({})/2\"", formula(size)));
            let text = text.replace("\"-S\"", &format!("\"0 - ({})\"", formula(size)));
            let minus = match size.strip_prefix('-') {
                Some(rest) => rest.to_owned(),
                None => format!("-{size}"),
            };
            all.push((truth, text.replace("-S", &minus).replace('S', size)));
        }
    }
    all
}

/// The language has no exponents of ten in numbers.
fn formula(size: &str) -> String {
    match size.split_once('e') {
        Some((digits, exponent)) => format!("{digits}*10^({exponent})"),
        None => size.to_owned(),
    }
}

/// Whether the edge of regression is proved to run inside, and not only along the border.
fn edge_inside(patch: &PatchReport) -> bool {
    let high = patch.clearance.and_then(|bounds| bounds.high);
    high.is_some_and(|high| high < -1e-6 * patch.rulings[1])
}

#[test]
fn a_hundred_and_thirty_hostile_patches_are_refused_or_judged_rightly_with_finite_numbers() {
    let all = patches();
    assert_eq!(all.len(), 130);
    let (mut judged, mut overlapping) = (0, 0);
    let budget = MeasureBudget {
        cells: 8,
        ..MeasureBudget::default()
    };
    for (truth, text) in all {
        let start = Instant::now();
        if let Ok(design) = read("x.toml", &text)
            && let Ok(report) = inspect_within(&design, budget)
        {
            let patch = &report.patches[0];
            assert!(
                patch.area.is_none_or(|a| a.is_finite() && a >= 0.0),
                "{text}\n{patch:?}"
            );
            assert!(
                patch.rulings.iter().all(|r| r.is_finite()),
                "{text}\n{patch:?}"
            );
            assert!(
                patch.twist_measured.iter().all(|t| t.is_finite()),
                "{text}\n{patch:?}"
            );
            assert!(
                !patch.regular.holds() || patch.area.is_some_and(|a| a > 0.0),
                "{text}\n{patch:?}"
            );
            assert!(
                truth != Truth::Singular || !patch.regular.holds(),
                "{text}\n{patch:?}"
            );
            let unrolled = unroll(&design, &Demand::default());
            if truth == Truth::Overlaps {
                let crossed = matches!(
                    unrolled,
                    Err(DesignError::Unroll {
                        reason: PatternError::CrossesItself { .. },
                        ..
                    })
                );
                assert!(unrolled.is_err(), "{text}");
                overlapping += usize::from(crossed);
            }
            if let Ok(pieces) = unrolled {
                assert!(!edge_inside(patch), "{text}\n{patch:?}");
                assert!(pieces[0].flat.outline().area().is_finite());
            }
            judged += 1;
        }
        assert!(start.elapsed() < Duration::from_secs(60), "{text}");
    }
    assert!(judged > 30 && overlapping > 2, "{judged} {overlapping}");
}

#[test]
fn files_that_ask_for_too_much_are_refused_before_any_work() {
    let many: String = (0..1000).map(|k| format!("p{k} = [0, 0, {k}]\n")).collect();
    let points: Vec<String> = (0..4000).map(|k| format!("[{k}, 0, 0]")).collect();
    let cases = [
        format!("[points]\n{many}"),
        format!("[curves]\na = {{ bezier = [{}] }}\n", points.join(", ")),
        format!(
            "[let]\na = \"{}1{}\"\n",
            "(".repeat(100_000),
            ")".repeat(100_000)
        ),
        format!(
            "[let]\na = \"9^9^9^9^9\"\nb = \"{}\"\n",
            "9".repeat(100_000)
        ),
        "[view]\nrulings = 1e300\n".to_owned(),
        format!("x = {}1{}\n", "[".repeat(50_000), "]".repeat(50_000)),
        (0..200)
            .map(|k| format!("a{k} = \"a{} + a{}\"\n", k + 1, k + 1))
            .fold("[let]\n".to_owned(), |t, l| t + &l),
        "\u{feff}\u{0}\u{7f}".to_owned(),
    ];
    for text in cases {
        let start = Instant::now();
        match read("x.toml", &text) {
            // Shown with so much of the file, and no more.
            Err(DesignError::Wrong { mistakes }) => {
                let most = if text.lines().any(|line| line.len() > 32_768) {
                    1
                } else {
                    100
                };
                assert!(!mistakes.is_empty() && mistakes.len() <= most);
            }
            Err(DesignError::Unreadable { reason, .. }) => {
                assert!(reason.ends_with("is longer than 65536 bytes"), "{reason}");
            }
            other => panic!("{other:?}"),
        }
        assert!(
            start.elapsed() < Duration::from_secs(10),
            "{}",
            text.get(..60).unwrap_or(&text)
        );
    }
}

#[test]
fn what_is_no_text_file_is_refused() {
    let folder = tempfile::tempdir().unwrap();
    let path = |name: &str| folder.path().join(name);
    std::fs::write(path("bytes.toml"), [0xff, 0xfe, 0x00]).unwrap();
    std::fs::write(path("long.toml"), vec![b'#'; MAX_BYTES + 1]).unwrap();
    std::fs::create_dir(path("folder.toml")).unwrap();
    for (name, reason) in [
        ("missing.toml", "No such file"),
        ("bytes.toml", "no UTF-8 text (byte 0)"),
        ("long.toml", "longer than"),
        ("folder.toml", "a folder"),
    ] {
        let error = load(&path(name)).unwrap_err();
        assert!(matches!(error, DesignError::Unreadable { .. }));
        assert!(error.to_string().contains(reason), "{error}");
    }
}

#[test]
fn absurd_grids_are_refused() {
    let design = read(
        "x.toml",
        "curves.a = { bezier = [[0, 0, 0], [1, 0, 0]] }\npatches.p = { cylinder = \"a\", direction = [0, 0, 1] }",
    )
    .unwrap();
    for at in [
        EvalPlaces::Grid(usize::MAX, usize::MAX),
        EvalPlaces::Grid(0, 3),
        EvalPlaces::Grid(2000, 2000),
        EvalPlaces::Places(vec![[f64::NAN, 0.0]]),
        EvalPlaces::Places(vec![[0.0, 1.5]]),
    ] {
        assert!(matches!(
            eval(&design, None, &at),
            Err(DesignError::OutOfRange { .. })
        ));
    }
    assert!(matches!(
        eval(&design, Some("q"), &EvalPlaces::Grid(1, 1)),
        Err(DesignError::NoSuch { .. })
    ));
    assert_eq!(
        eval(&design, None, &EvalPlaces::Grid(3, 2)).unwrap().len(),
        12
    );
}
