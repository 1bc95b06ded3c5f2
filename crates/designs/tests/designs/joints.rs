//! Joints: a sheet that goes on, one that is bent, and one that folds back on itself.

use torse_designs::inspect::inspect;
use torse_designs::{Design, read};

fn design(text: &str) -> Design {
    read("x.toml", text).unwrap_or_else(|e| panic!("{e:?}"))
}

/// Families of planes that agree to first order at the joint, of which the second sheet grows to the side from which the
/// first one comes.
const FOLDED: &str = r#"
[planes]
back = [1, 0, 0, -20]
front = [1, 0, 0, 20]
[families.e41]
gbt = [[0, -20, 10, 400], [0, -10, 20, 400], [0, 10, 20, 400], [0, 20, 10, 400]]
shape = [1, 1]
[patches.first]
envelope = "e41"
between = ["back", "front"]
[patches.g1]
continues = "first"
join = "G1"
beta = [1]
shape = [1, 1]
free = [[0, 50, 0, 400], [0, 60, -20, 400]]
part = [0, 0.3]
[chains.c]
patches = ["first", "g1"]
continuity = "G1"
"#;

#[test]
fn a_sheet_that_folds_back_is_a_fold_of_half_a_turn_whatever_its_planes_say() {
    for order in ["G0", "G1", "G2", "C1"] {
        let text = FOLDED.replace("continuity = \"G1\"", &format!("continuity = \"{order}\""));
        let report = inspect(&design(&text)).unwrap();
        let joint = &report.joints[0];
        assert!((joint.kink - 180.0).abs() < 1e-6, "{}", joint.kink);
        assert_eq!(
            (joint.geometric, joint.smoothness().as_str()),
            (Some(0), "G0, C0")
        );
        assert_eq!(
            report.missed.len(),
            usize::from(order != "G0"),
            "{:?}",
            report.missed
        );
    }
}

#[test]
fn a_sheet_that_goes_on_has_no_fold_in_whichever_order_and_sense_it_is_given() {
    // A half tube in two quarters, each of them drawn either way, with either rail first.
    let arc = |name: &str, z: u32, from: &str, to: &str| {
        format!(
            "curves.{name} = {{ arc = {{ centre = [0, 0, {z}], from = {from}, to = {to} }} }}\n"
        )
    };
    let (a, b, c) = ("30, 0", "0, 30", "-30, 0");
    for turned in 0..8 {
        let mut text = String::new();
        for (k, (from, to)) in [(a, b), (b, c)].into_iter().enumerate() {
            let (from, to) = if turned >> k & 1 == 1 {
                (to, from)
            } else {
                (from, to)
            };
            for z in [0, 50] {
                text += &arc(
                    &format!("c{k}{z}"),
                    z,
                    &format!("[{from}, {z}]"),
                    &format!("[{to}, {z}]"),
                );
            }
        }
        let second = if turned >> 2 == 1 {
            "\"c150\", \"c10\""
        } else {
            "\"c10\", \"c150\""
        };
        text += "patches.one = { ruled = [\"c00\", \"c050\"] }\n";
        text += &format!("patches.two = {{ ruled = [{second}] }}\n");
        text += "chains.tube = { patches = [\"one\", \"two\"], continuity = \"G1\" }\n";
        let report = inspect(&design(&text)).unwrap();
        assert!(
            report.joints[0].kink < 1e-6,
            "{turned}: {}",
            report.joints[0].kink
        );
        assert!(report.missed.is_empty(), "{turned}: {:?}", report.missed);
    }
}

#[test]
fn a_bend_beyond_a_right_angle_is_told_with_its_angle() {
    let text = r#"
curves.a = { bezier = [[0, 0, 0], [10, 0, 0]] }
curves.b = { bezier = [[0, 0, 30], [10, 0, 30]] }
curves.c = { bezier = [[10, 0, 0], [0, 10, 0]] }
curves.d = { bezier = [[10, 0, 30], [0, 10, 30]] }
patches.one = { ruled = ["a", "b"] }
patches.two = { ruled = ["c", "d"] }
chains.vee = { patches = ["one", "two"] }
"#;
    let report = inspect(&design(text)).unwrap();
    assert!((report.joints[0].kink - 135.0).abs() < 1e-9);
}
