//! Pieces of several patches in space: through themselves, through each other, folded back.

use torse_designs::inspect::{DesignReport, PieceSpace, inspect, table};
use torse_designs::read;

fn inspected(text: &str) -> DesignReport {
    let design = read("x.toml", text).unwrap_or_else(|e| panic!("{e:?}"));
    inspect(&design).unwrap()
}

fn wall(curve: &str) -> DesignReport {
    inspected(&format!(
        "[curves]\nl = {{ {curve} }}\n[patches.band]\ncylinder = \"l\"\ndirection = [0, 30, 0]\n"
    ))
}

#[test]
fn a_wall_whose_last_side_crosses_its_first_is_told_with_both_places() {
    let corners = "[0, 0, 0], [100, 0, 0], [100, 0, 50], [50, 0, 50]";
    let free = wall(&format!("polyline = [{corners}]"));
    assert_eq!(
        (free.missed.as_slice(), &free.pieces[0].space),
        (&[][..], &PieceSpace::Free)
    );
    let crossing = wall(&format!("polyline = [{corners}, [50, 0, -50]]"));
    assert_eq!(
        crossing.missed,
        [
            "band passes through itself in space: band.1 at u = 0.5000000, v = 0.5000000 and band.4 at u = 0.5000000, v = \
          0.5000000 are one point, proved"
        ]
    );
}

#[test]
fn a_closed_spline_that_crosses_itself_makes_a_band_that_does() {
    let eight = "[0, 0, 0], [50, 0, 50], [100, 0, 0], [100, 0, 50], [50, 0, 0], [0, 0, 50]";
    let report = wall(&format!(
        "spline = {{ degree = 3, closed = true, points = [{eight}] }}"
    ));
    assert!(
        matches!(report.pieces[0].space, PieceSpace::Meets { .. }),
        "{:?}",
        report.pieces
    );
    let ring = "[0, 0, 0], [50, 0, 50], [100, 0, 0], [100, 0, -50], [50, 0, -90], [0, 0, -50]";
    let report = wall(&format!(
        "spline = {{ degree = 3, closed = true, points = [{ring}] }}"
    ));
    assert_eq!(
        (report.missed.as_slice(), &report.pieces[0].space),
        (&[][..], &PieceSpace::Free)
    );
}

#[test]
fn a_rail_that_runs_back_over_itself_is_named() {
    let report = wall("polyline = [[0, 0, 0], [100, 0, 0], [20, 0, 0]]");
    assert!(
        report.missed.iter().any(|reason| reason
            .starts_with("the sheet is folded back on itself where band.1 meets band.2: by 180")),
        "{:?}",
        report.missed
    );
}

#[test]
fn pieces_that_pierce_each_other_are_noted_and_miss_nothing() {
    let report = inspected(
        r#"
[curves]
a = { bezier = [[0, 0, 0], [100, 0, 0]] }
b = { bezier = [[0, 50, 0], [100, 50, 0]] }
c = { bezier = [[50, 10, -30], [50, 10, 30]] }
d = { bezier = [[50, 40, -30], [50, 40, 30]] }
[patches]
p = { ruled = ["a", "b"] }
q = { ruled = ["c", "d"] }
"#,
    );
    assert!(report.missed.is_empty(), "{:?}", report.missed);
    assert_eq!(report.piercings[0].pieces, ["p", "q"]);
    let text = table(&report);
    assert!(
        text.contains("note: p and q pass through each other in space: p at u = 0.5000000"),
        "{text}"
    );
}

/// A pipe along x and one that branches off at 45 degrees, with these marks on the first.
fn branching(marks: &str) -> String {
    format!(
        r#"
[curves]
u = {{ arc = {{ centre = [-150, 0, 0], from = [-150, 0, -50], axis = [1, 0, 0], angle = 360 }} }}
p = {{ arc = {{ centre = [10, 0, 0], from = [10, 25, 0], axis = [0.7071067811865475, 0, 0.7071067811865475], angle = 360 }} }}
q = {{ arc = {{ centre = [116.06601717798212, 0, 106.06601717798212], from = [116.06601717798212, 25, 106.06601717798212], axis = [0.7071067811865475, 0, 0.7071067811865475], angle = 360 }} }}
[patches]
br = {{ ruled = ["p", "q"] }}
main = {{ cylinder = "u", direction = [300, 0, 0], marks = [{marks}] }}
"#
    )
}

#[test]
fn a_pipe_does_not_pass_through_another_where_that_has_an_opening_for_it() {
    let met = |marks: &str| inspected(&branching(marks)).piercings.len();
    assert_eq!(met(""), 1);
    assert_eq!(met(r#"{ passes = "br" }"#), 0);
    // A hole elsewhere changes nothing.
    assert_eq!(met("{ at = [0.1, 0.2], radius = 5 }"), 1);
}

#[test]
fn a_pipe_that_lies_on_itself_is_found_however_little() {
    for angle in [360.1, 361.0, 400.0] {
        let report = inspected(&format!(
            r#"
[curves]
a = {{ arc = {{ centre = [0, 0, 0], from = [50, 0, 0], axis = [0, 0, 1], angle = {angle} }} }}
[patches]
p = {{ cylinder = "a", direction = [0, 0, 50] }}
"#
        ));
        assert!(
            report
                .missed
                .iter()
                .any(|reason| reason.starts_with("p passes through itself in space")),
            "{angle}: {:?}",
            report.missed
        );
    }
}

#[test]
fn sheets_that_start_in_a_tip_are_proved_free_in_space() {
    for rails in [
        ["[[0, 0, 0], [200, 0, 0]]", "[[0, 0, 0], [200, 100, 0]]"],
        // Away from the origin, from tip to tip, and bent.
        [
            "[[7, 3, 0.1], [107, -50, 0.1], [207, 3, 0.1]]",
            "[[7, 3, 0.1], [107, 60, 0.1], [207, 3, 0.1]]",
        ],
        [
            "[[0, 0, 0], [100, 0, 0], [200, 0, 80]]",
            "[[0, 0, 0], [100, 50, 0], [200, 100, 80]]",
        ],
    ] {
        let report = inspected(&format!(
            "[curves]\na = {{ bezier = {} }}\nb = {{ bezier = {} }}\n[patches]\np = {{ ruled = [\"a\", \"b\"] }}\n",
            rails[0], rails[1]
        ));
        assert_eq!(report.notes_on_space(), [""; 0], "{rails:?}");
    }
}
