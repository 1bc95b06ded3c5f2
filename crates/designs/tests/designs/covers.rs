//! Strips that cover a surface: their distances, their pieces, their patterns, and what is refused.

use miette::Diagnostic;
use torse_designs::inspect::{inspect, table};
use torse_designs::unroll::{Demand, unroll};
use torse_designs::{Design, DesignError, read};

/// A dome over a rectangle, a saddle whose curves are no asymptotic ones, and one whose curves are.
const SURFACES: &str = r#"
[surfaces]
dome = { net = [
    [[0, 0, 0], [0, 600, 190], [0, 1200, 200], [0, 1800, 0]],
    [[700, 0, 210], [700, 600, 420], [700, 1200, 430], [700, 1800, 220]],
    [[1400, 0, 200], [1400, 600, 410], [1400, 1200, 400], [1400, 1800, 210]],
    [[2100, 0, 0], [2100, 600, 180], [2100, 1200, 210], [2100, 1800, 0]],
] }
saddle = { net = [
    [[-1000, -1000, 0], [-1000, 0, 500], [-1000, 1000, 0]],
    [[0, -1000, -500], [0, 0, 0], [0, 1000, -500]],
    [[1000, -1000, 0], [1000, 0, 500], [1000, 1000, 0]],
] }
twisted = { net = [
    [[0, 0, 0], [0, 500, 0], [0, 1000, 0]],
    [[500, 0, 0], [500, 500, 250], [500, 1000, 500]],
    [[1000, 0, 0], [1000, 500, 500], [1000, 1000, 1000]],
] }
"#;

fn design(text: &str) -> Design {
    read("x.toml", &format!("{SURFACES}{text}")).unwrap_or_else(|e| panic!("{e:?}"))
}

#[test]
fn strips_of_a_dome_are_parts_with_proved_distances_and_patterns() {
    let design = design(
        r#"
[patches.shell]
strips = { surface = "dome", along = "u", within = 12 }
"#,
    );
    let cover = &design.covers[0];
    assert_eq!(
        (cover.name.as_str(), cover.surface.as_str()),
        ("shell", "dome")
    );
    let count = cover.strips.len();
    assert!((3..=6).contains(&count), "{count}");
    assert!(cover.strips.iter().all(|strip| strip.distance <= 12.0));
    assert_eq!(cover.strips[0].range[0], 0.0);
    assert_eq!(cover.strips[count - 1].range[1], 1.0);
    // Neighbours share an edge, and each patch belongs to one strip.
    for pair in cover.strips.windows(2) {
        assert_eq!(pair[0].range[1], pair[1].range[0]);
        let [least, greatest] = pair[0].fold.unwrap();
        assert!(1.0 < least && least <= greatest && greatest < 15.0);
    }
    let owned: Vec<usize> = cover
        .strips
        .iter()
        .flat_map(|s| s.patches.clone())
        .collect();
    assert_eq!(owned, (0..design.patches.len()).collect::<Vec<_>>());

    let report = inspect(&design).unwrap();
    assert!(report.missed.is_empty(), "{:?}", report.missed);
    assert!(report.patches.iter().all(|patch| patch.developable.holds()));
    let text = table(&report);
    assert!(
        text.contains("from surface") && text.contains("cover `dome` within 12 mm, proved"),
        "{text}"
    );
    assert!(
        text.lines().all(|line| line.chars().count() <= 100),
        "{text}"
    );

    let pieces = unroll(&design, &Demand::default()).unwrap();
    assert_eq!(pieces.len(), count);
}

#[test]
fn strips_of_a_saddle_meet_along_edges_of_one_length() {
    let text = format!(
        "seams = [[\"tent.1.second\", \"tent.2.first\"]]\n{SURFACES}\n[patches.tent]\nstrips = {{ surface = \"saddle\", along = \"v\", within = 20 }}\n"
    );
    let sewn = read("x.toml", &text).unwrap_or_else(|e| panic!("{e:?}"));
    assert_eq!(
        (sewn.covers[0].along, sewn.covers[0].strips.len()),
        ("v", 4)
    );
    let report = inspect(&sewn).unwrap();
    assert!(report.missed.is_empty(), "{:?}", report.missed);
    let seam = &report.seams[0];
    assert!(
        (seam.lengths[0] - seam.lengths[1]).abs() < 1e-3 && seam.apart[0] < 1e-3,
        "{seam:?}"
    );
}

#[test]
fn a_cap_is_covered_around_its_pole_and_its_first_part_is_a_cone() {
    let cap = "cap = { net = [[[0, 0, 600], [0, 0, 600], [0, 0, 600]], [[1000, -300, 600], [1040, 0, 600], [1000, 300, 600]], [[2000, -600, 0], [2100, 0, 0], [2000, 600, 0]]] }";
    let strips = |along: &str| {
        format!(
            "[surfaces]\n{cap}\n[patches.cap]\nstrips = {{ surface = \"cap\", along = \"{along}\", within = 20 }}\n"
        )
    };
    let made = read("x.toml", &strips("v")).unwrap_or_else(|e| panic!("{e:?}"));
    let report = inspect(&made).unwrap();
    assert!(report.missed.is_empty(), "{:?}", report.missed);
    let text = table(&report);
    assert!(text.contains("a fan from the point of curve 1"), "{text}");
    assert!(unroll(&made, &Demand::default()).is_ok());
    let refused = read("x.toml", &strips("u")).unwrap_err();
    let refused = format!("{refused:?}");
    assert!(
        refused.contains("the point (0, 0, 600)") && refused.contains("is a cone"),
        "{refused}"
    );
}

#[test]
fn what_cannot_be_covered_is_refused_with_its_place() {
    let wrong = |entry: &str| {
        let text = format!(
            "{SURFACES}\nsphere = {{ rotation = \"arc\" }}\n[curves.arc]\ngbt = [[20, 0, 0], [20, 0, 20], [0, 0, 20]]\nshape = [0, 0]\n[patches.shell]\n{entry}\n"
        );
        let Err(DesignError::Wrong { mistakes }) = read("x.toml", &text) else {
            panic!("{entry} is read");
        };
        let [only] = mistakes.as_slice() else {
            panic!("{mistakes:?}");
        };
        let label = only.labels().unwrap().next().unwrap();
        let at = label.offset()..label.offset() + label.len();
        (only.to_string(), text[at].to_owned())
    };
    let (message, place) = wrong("strips = { surface = \"twisted\", along = \"u\", within = 5 }");
    assert!(
        message.contains("asymptotic") && message.contains("the point is ("),
        "{message}"
    );
    assert_eq!(place, "\"u\"");
    let (message, place) = wrong("strips = { surface = \"dom\", along = \"u\", within = 5 }");
    assert_eq!(
        (message.as_str(), place.as_str()),
        ("no surface above is called `dom`", "\"dom\"")
    );
    let (message, place) = wrong("strips = { surface = \"dome\", along = \"w\", within = 5 }");
    assert_eq!(
        (message.as_str(), place.as_str()),
        ("`w` is no along", "\"w\"")
    );
    let (_, place) = wrong("strips = { surface = \"dome\", along = \"u\", within = 0 }");
    assert_eq!(place, "0");
    let (message, _) = wrong("strips = { surface = \"dome\", along = \"u\" }");
    assert_eq!(message, "strips lack `within`");
    let (message, place) = wrong("strips = { surface = \"sphere\", along = \"u\", within = 5 }");
    assert_eq!(
        (message.as_str(), place.as_str()),
        ("`sphere` consists of 4 surfaces", "\"sphere\"")
    );
    let (message, _) =
        wrong("part = [0, 0.5]\nstrips = { surface = \"saddle\", along = \"u\", within = 50 }");
    assert_eq!(message, "strips have neither a `part` nor `marks`");
}
