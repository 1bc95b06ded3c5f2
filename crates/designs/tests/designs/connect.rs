//! Developables between free curves: drawn either way, one of several, closed.

use torse_designs::inspect::inspect;
use torse_designs::{Design, read};

fn design(text: &str) -> Design {
    read("x.toml", text).unwrap_or_else(|e| panic!("{e:?}"))
}

/// Two loops in planes that lean, of a quarter turn each side in one curve of degree six.
const REDUCER: &str = r#"
[curves]
a = { bezier = [[80, 0, 0], [80, 274.28571428571428, 0], [-93.341692789968619, 98.708463949843249, 0], [-110.98319134239007, 0, 0], [-93.341692789968619, -98.708463949843249, 0], [80, -274.28571428571428, 0], [80, 0, 0]], weights = [1, 0.34999999999999992, 0.7975000000000001, 1.0857499999999998, 0.7975000000000001, 0.34999999999999992, 1] }
b = { bezier = [[70, 12, 105], [70, 183.42857142857142, 139.28571428571428], [-38.33855799373039, 73.692789968652022, 84.836990595611283], [-49.364494588993793, 12, 69.190651623301861], [-38.33855799373039, -49.692789968652029, 60.159874608150474], [70, -159.42857142857142, 70.714285714285722], [70, 12, 105]], weights = [1, 0.34999999999999992, 0.7975000000000001, 1.0857499999999998, 0.7975000000000001, 0.34999999999999992, 1] }
[patches.reducer]
connect = ["a", "b"]
"#;

#[test]
fn two_closed_curves_whose_developable_does_not_close_are_told() {
    let report = inspect(&design(REDUCER)).unwrap();
    assert!(
        report
            .missed
            .iter()
            .any(|reason| reason.contains("does not close")),
        "{:?}",
        report.missed
    );
}

#[test]
fn a_curve_that_is_drawn_from_its_other_end_is_connected_all_the_same() {
    let text = r#"
[curves]
a = { bezier = [[0, 0, 0], [100, 80, 0], [250, 90, 0], [400, 0, 0]] }
b = { bezier = [[400, 0, 60], [250, 90, 60], [100, 80, 60], [0, 0, 60]] }
[patches.p]
connect = ["a", "b"]
"#;
    let report = inspect(&design(text)).unwrap();
    let patch = &report.patches[0];
    assert!(
        (patch.area.unwrap() - 25_590.93).abs() < 0.1,
        "{:?}",
        patch.area
    );
    assert!(
        patch.notes[0].starts_with("curve 2 runs against curve 1"),
        "{:?}",
        patch.notes
    );
}

#[test]
fn each_of_several_developables_can_be_taken() {
    let flare = |branch: &str| {
        format!(
            "[curves]
             a = {{ bezier = [[0, 0, 0], [150, 120, 0], [300, -120, 0], [450, 0, 0]] }}
             b = {{ bezier = [[0, 20, 80], [160, 150, 90], [310, -70, 85], [450, 60, 80]] }}
             [patches.p]
             connect = [\"a\", \"b\"]
             {branch}"
        )
    };
    let areas: Vec<f64> = ["branch = 1", "branch = 2"]
        .map(|branch| {
            inspect(&design(&flare(branch))).unwrap().patches[0]
                .area
                .unwrap()
        })
        .to_vec();
    assert!((areas[0] - areas[1]).abs() > 1.0, "{areas:?}");
    let best = inspect(&design(&flare(""))).unwrap().patches[0]
        .area
        .unwrap();
    assert!(areas.contains(&best), "{best} {areas:?}");
    assert!(read("x.toml", &flare("branch = 99")).is_err());
}
