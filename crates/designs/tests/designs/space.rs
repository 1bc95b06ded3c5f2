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
