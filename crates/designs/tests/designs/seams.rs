//! Edges that meet: their lengths, where they part, their notches.

use torse_designs::inspect::inspect;
use torse_designs::unroll::{Demand, parts, unroll};
use torse_designs::{DesignError, read};

/// Two panels: a flat one with a straight side of 100 mm, and one whose side has another length.
fn panels(seam: &str, length: f64) -> String {
    format!(
        r#"
seams = [{seam}]
[curves]
a = {{ bezier = [[0, 0, 0], [100, 0, 0]] }}
b = {{ bezier = [[0, 50, 0], [100, 50, 0]] }}
c = {{ bezier = [[0, 50, 0], [{length}, 50, 0]] }}
d = {{ bezier = [[0, 90, 20], [{length}, 90, 20]] }}
[patches.front]
ruled = ["a", "b"]
edges = {{ hem = "first", join = "second" }}
[patches.back]
ruled = ["c", "d"]
"#
    )
}

#[test]
fn edges_of_equal_length_are_a_seam_and_others_are_missed_with_their_difference() {
    let equal = read("x.toml", &panels(r#"["front.join", "back.first"]"#, 100.0)).unwrap();
    let report = inspect(&equal).unwrap();
    assert!(report.missed.is_empty(), "{:?}", report.missed);
    let [seam] = report.seams.as_slice() else {
        panic!("{:?}", report.seams)
    };
    assert!(
        seam.lengths
            .iter()
            .all(|length| (length - 100.0).abs() < 1e-9)
    );
    assert!(seam.apart[0] < 1e-9 && !seam.backwards);
    let longer = read("x.toml", &panels(r#"["front.join", "back.first"]"#, 103.0)).unwrap();
    let report = inspect(&longer).unwrap();
    assert_eq!(report.missed.len(), 1);
    let missed = &report.missed[0];
    assert!(
        missed.contains("differ by -3.0000 mm")
            && missed.contains("3.0000 mm, at 1.000 of their length"),
        "{missed}"
    );
    // On purpose: the first is that much longer.
    for (ease, misses) in [(-3.0, 0), (3.0, 1)] {
        let seam = format!(r#"["front.join", "back.first", {ease}]"#);
        let eased = read("x.toml", &panels(&seam, 103.0)).unwrap();
        assert_eq!(inspect(&eased).unwrap().missed.len(), misses, "{ease}");
    }
}

#[test]
fn curved_edges_are_measured_by_their_arc_lengths() {
    // A quarter of a circle of radius 40, and a straight edge as long.
    let length = 20.0 * std::f64::consts::PI;
    let text = format!(
        r#"
seams = [["collar.first", "band.first"], ["collar.second", "band.first"]]
[curves]
neck = {{ arc = {{ centre = [0, 0, 0], from = [40, 0, 0], to = [0, 40, 0] }} }}
low = {{ bezier = [[0, 0, 100], [{length}, 0, 100]] }}
high = {{ bezier = [[0, 0, 120], [{length}, 0, 120]] }}
[patches.collar]
cone = "neck"
apex = [0, 0, 60]
range = [1, 0.5]
[patches.band]
ruled = ["low", "high"]
"#
    );
    let report = inspect(&read("x.toml", &text).unwrap()).unwrap();
    assert_eq!(report.missed.len(), 1, "{:?}", report.missed);
    assert!(report.missed[0].contains("collar.second"));
    let [one, other] = report.seams[0].lengths;
    assert!(
        (one - length).abs() < 1e-7 && (other - length).abs() < 1e-9,
        "{one} {other}"
    );
}

#[test]
fn edges_that_are_not_there_are_mistakes_of_the_file() {
    for (seam, words) in [
        (
            r#"["front.join", "side.first"]"#,
            "no patch above is called `side`",
        ),
        (r#"["front.join", "back.top"]"#, "`back` has no edge `top`"),
        (r#"["front.join", "back"]"#, "`back` is no edge"),
        (r#"["front.join"]"#, "at least 2 are wanted"),
    ] {
        let DesignError::Wrong { mistakes } = read("x.toml", &panels(seam, 100.0)).unwrap_err()
        else {
            panic!("{seam}")
        };
        let told: Vec<String> = mistakes.iter().map(ToString::to_string).collect();
        assert!(
            told.iter().any(|text| text.contains(words)),
            "{seam}: {told:?}"
        );
    }
}

#[test]
fn notches_of_a_seam_are_at_equal_lengths_on_both_parts() {
    // The second edge runs the other way.
    let text = panels(r#"["front.join", "back.first"]"#, 100.0)
        .replace(
            "[[0, 50, 0], [100, 50, 0]] }\nd",
            "[[100, 50, 0], [0, 50, 0]] }\nd",
        )
        .replace(
            "[[0, 90, 20], [100, 90, 20]]",
            "[[100, 90, 20], [0, 90, 20]]",
        );
    let design = read("x.toml", &text).unwrap();
    let report = inspect(&design).unwrap();
    assert!(
        report.missed.is_empty() && report.seams[0].backwards,
        "{report:?}"
    );
    let parts = parts(&design, &unroll(&design, &Demand::default()).unwrap()).unwrap();
    for part in &parts {
        assert_eq!(part.notches.len(), 3);
        let [width, height] = part.size;
        assert!((width - 100.0).abs() < 1e-9);
        for [from, to] in &part.notches {
            // From the edge inwards, across it.
            let on_edge = from[1].abs() < 1e-9 || (from[1] - height).abs() < 1e-9;
            assert!(on_edge && to[1] > 0.0 && to[1] < height, "{from:?} {to:?}");
            assert!((to[0] - from[0]).abs() < 1e-9);
        }
    }
    // One notch is nearer to one corner, two are nearer to the other, and these corners meet.
    let places = |index: usize| {
        let mut all: Vec<f64> = parts[index]
            .notches
            .iter()
            .map(|[from, _]| from[0])
            .collect();
        all.sort_by(f64::total_cmp);
        all
    };
    for places in [places(0), places(1)] {
        let mirrored: Vec<f64> = places.iter().rev().map(|x| 100.0 - x).collect();
        let wanted = [100.0 / 3.0, 200.0 / 3.0 - 1.5, 200.0 / 3.0 + 1.5];
        let near = |found: &[f64]| found.iter().zip(wanted).all(|(x, y)| (x - y).abs() < 1e-9);
        assert!(near(&places) || near(&mirrored), "{places:?}");
    }
}

#[test]
fn the_gores_of_an_elbow_meet_along_all_their_mitres() {
    let design = read(
        "x.toml",
        include_str!("../../../../designs/workshop/gored-elbow.toml"),
    )
    .unwrap();
    let report = inspect(&design).unwrap();
    assert!(report.missed.is_empty() && report.seams.len() == 4);
    for seam in &report.seams {
        assert!(
            seam.difference.abs() < 1e-6 && seam.apart[0] < 1e-6,
            "{seam:?}"
        );
    }
}

#[test]
fn notches_of_closed_edges_that_begin_at_different_places_meet_in_space() {
    // Two pipes on one another, their seams a quarter of a turn apart.
    let pipes = |from: &str| {
        let text = format!(
            r#"
            seams = [["low.second", "high.first"]]
            [curves]
            r1 = {{ arc = {{ centre = [0, 0, 0], from = [50, 0, 0], axis = [0, 0, 1], angle = 360 }} }}
            r2 = {{ arc = {{ centre = [0, 0, 40], from = {from}, axis = [0, 0, 1], angle = 360 }} }}
            [patches]
            low = {{ cylinder = "r1", direction = [0, 0, 40] }}
            high = {{ cylinder = "r2", direction = [0, 0, 40] }}
            "#
        );
        read("x.toml", &text).unwrap()
    };
    for (from, quarter) in [("[50, 0, 40]", 0.0), ("[0, -50, 40]", 0.25)] {
        let design = pipes(from);
        let report = inspect(&design).unwrap();
        let [seam] = report.seams.as_slice() else {
            panic!("{:?}", report.seams)
        };
        assert!(
            seam.apart[0] < 1e-3 && (seam.offset - quarter).abs() < 1e-6,
            "{seam:?}"
        );
        let pieces = unroll(&design, &Demand::default()).unwrap();
        let made = parts(&design, &pieces).unwrap();
        // Where the notches are around the pipe, as shares of a turn.
        let around = |index: usize, start: f64| {
            let width = made[index].size[0];
            let mut all: Vec<f64> = made[index]
                .notches
                .iter()
                .map(|[from, _]| {
                    let point = made[index].placement.point_back(*from);
                    let at = pieces[index].flat.locate(point).expect("on the pattern");
                    (at.x + start).rem_euclid(1.0)
                })
                .collect();
            assert!(width > 314.0);
            all.sort_by(f64::total_cmp);
            all
        };
        // The second begins three quarters of a turn behind the first.
        let (low, high) = (around(0, 0.0), around(1, -quarter));
        assert_eq!((low.len(), high.len()), (3, 3));
        for (a, b) in low.iter().zip(&high) {
            assert!((a - b).abs() < 1e-4, "{low:?} {high:?}");
        }
    }
}

#[test]
fn notches_within_a_bend_are_on_its_strip() {
    let design = read(
        "x.toml",
        r#"
        seams = [["A.first", "E.second"]]
        [sheet]
        thickness = 1
        [curves]
        a = { bezier = [[0, 0, 0], [12, 0, 0]] }
        a2 = { bezier = [[0, 60, 0], [12, 60, 0]] }
        b = { bezier = [[12, 0, 0], [12, 0, 30]] }
        b2 = { bezier = [[12, 60, 0], [12, 60, 30]] }
        e1 = { bezier = [[0, 0, 0], [12, 0, 0]] }
        e2 = { bezier = [[0, -30, 0], [12, -30, 0]] }
        [patches]
        A = { ruled = ["a", "a2"] }
        B = { ruled = ["b", "b2"] }
        E = { ruled = ["e2", "e1"] }
        [chains.ch]
        patches = ["A", "B"]
        radius = 6
        "#,
    )
    .unwrap();
    let made = parts(&design, &unroll(&design, &Demand::default()).unwrap()).unwrap();
    for part in &made {
        assert_eq!(part.notches.len(), 3, "{}", part.name);
        for [from, _] in &part.notches {
            let off = part.outline.iter().map(|side| side.distance(*from));
            assert!(off.fold(f64::INFINITY, f64::min) < 1e-6, "{from:?}");
        }
    }
}
