//! Blanks: bends as long as the formulas of the trade say, against numbers worked out by hand.

use std::f64::consts::{FRAC_PI_2, PI};
use torse_designs::unroll::{CutOptions, Demand, Part, parts, parts_with, unroll};
use torse_designs::{DesignError, read};

fn made(text: &str) -> Result<Vec<Part>, DesignError> {
    let design = read("x.toml", text).unwrap_or_else(|e| panic!("{e:?}"));
    parts(&design, &unroll(&design, &Demand::default()).unwrap())
}

/// A bracket of two flanges of 40 and 25 mm outside, 60 mm wide, whose bend is a patch; drawn at a share of the
/// thickness from the inside.
fn bracket(sheet: &str, share: f64, [t, r]: [f64; 2]) -> String {
    let radius = r + share * t;
    let (a, b) = (40.0 - r - t, 25.0 - r - t);
    format!(
        r#"
[curves]
base = {{ bezier = [[0, 0, 0], [{a}, 0, 0]] }}
base2 = {{ bezier = [[0, 60, 0], [{a}, 60, 0]] }}
bend = {{ arc = {{ centre = [{a}, 0, {radius}], from = [{a}, 0, 0], to = [{end}, 0, {radius}] }} }}
wall = {{ bezier = [[{end}, 0, {radius}], [{end}, 0, {top}]] }}
wall2 = {{ bezier = [[{end}, 60, {radius}], [{end}, 60, {top}]] }}
[patches]
p1 = {{ ruled = ["base", "base2"] }}
p2 = {{ cylinder = "bend", direction = [0, 60, 0], bend = true }}
p3 = {{ ruled = ["wall", "wall2"] }}
[chains.bracket]
patches = ["p1", "p2", "p3"]
continuity = "G1"
[sheet]
thickness = {t}
{sheet}
"#,
        end = a + radius,
        top = radius + b,
    )
}

#[test]
fn the_blank_of_a_bracket_depends_on_the_k_factor() {
    for (k, length) in [(0.42, 62.131_194), (0.30, 61.848_451), (0.5, 62.319_690)] {
        let part = made(&bracket(&format!("k-factor = {k}"), 0.5, [1.5, 2.0]))
            .unwrap()
            .remove(0);
        assert!((part.size[0] - length).abs() < 1e-6, "{k}: {:?}", part.size);
        assert!((part.size[1] - 60.0).abs() < 1e-9);
        // A rectangle has four sides.
        assert_eq!(part.outline.len(), 4);
        let [bend] = part.bends.as_slice() else {
            panic!("{:?}", part.bends)
        };
        assert!(
            (bend.angle.abs() - FRAC_PI_2).abs() < 1e-9 && (bend.inside_radius - 2.0).abs() < 1e-9
        );
        // The middle of the bend, across the sheet.
        let from_edge = bend.line.map(|end| end[0].min(part.size[0] - end[0]));
        let expected = 21.5 + 0.5 * bend.allowance;
        assert!(
            from_edge.iter().all(|x| (x - expected).abs() < 1e-9),
            "{from_edge:?}"
        );
        let ends = [
            bend.line[0][1].min(bend.line[1][1]),
            bend.line[0][1].max(bend.line[1][1]),
        ];
        assert!(ends[0].abs() < 1e-9 && (ends[1] - 60.0).abs() < 1e-9);
    }
}

#[test]
fn the_same_part_drawn_by_any_of_its_surfaces_has_the_same_blank() {
    for (share, name) in [(0.0, "inside"), (0.5, "middle"), (1.0, "outside")] {
        let sheet = format!("k-factor = 0.42\nsurface = \"{name}\"");
        let part = made(&bracket(&sheet, share, [1.5, 2.0])).unwrap().remove(0);
        assert!(
            (part.size[0] - 62.131_194).abs() < 1e-6,
            "{name}: {:?}",
            part.size
        );
    }
}

#[test]
fn bends_of_the_standard_are_as_long_as_its_formula_says() {
    // DIN 6935: L = a + b + v, with v = pi (180 - beta)/180 (r + k s/2) - 2 (r + s) for right angles; of s = 2, r = 4:
    // k = 0.65 + lg(2)/2.
    let [s, r] = [2.0, 4.0];
    let k = 0.65 + 0.5 * libm::log10(2.0);
    let v = FRAC_PI_2 * (r + 0.5 * k * s) - 2.0 * (r + s);
    let part = made(&bracket("k-factor = \"DIN 6935\"", 0.5, [s, r]))
        .unwrap()
        .remove(0);
    assert!((part.size[0] - (65.0 + v)).abs() < 1e-9, "{:?}", part.size);
    assert!((part.bends[0].deduction.unwrap() + v).abs() < 1e-9);
    // A table between its rows, and beside them.
    let table = "k-factor = [[1, 0.33], [3, 0.43]]";
    let part = made(&bracket(table, 0.5, [2.0, 4.0])).unwrap().remove(0);
    assert!((part.bends[0].k_factor - 0.38).abs() < 1e-12);
    let beside = made(&bracket(table, 0.5, [2.0, 1.0]))
        .unwrap_err()
        .to_string();
    assert!(beside.contains("0.500 times the thickness"), "{beside}");
}

/// A channel: a base of 50 mm and two legs of 20 and 30 mm to the corners, the legs turned by angles in degrees.
fn channel(radius: &str, turns: [f64; 2]) -> String {
    let leg = |turn: f64, length: f64| {
        let (s, c) = libm::sincos(turn.to_radians());
        (c * length, s * length)
    };
    let ((x, z), (u, w)) = (leg(turns[0], 20.0), leg(turns[1], 30.0));
    format!(
        r#"
[curves]
a1 = {{ bezier = [[{x0}, 0, {z}], [0, 0, 0]] }}
a2 = {{ bezier = [[{x0}, 80, {z}], [0, 80, 0]] }}
b1 = {{ bezier = [[0, 0, 0], [50, 0, 0]] }}
b2 = {{ bezier = [[0, 80, 0], [50, 80, 0]] }}
c1 = {{ bezier = [[50, 0, 0], [{x1}, 0, {w}]] }}
c2 = {{ bezier = [[50, 80, 0], [{x1}, 80, {w}]] }}
[patches]
left = {{ ruled = ["a1", "a2"] }}
base = {{ ruled = ["b1", "b2"], marks = [{{ at = [0.5, 0.25], radius = 6 }}] }}
right = {{ ruled = ["c1", "c2"] }}
[sheet]
thickness = 2
k-factor = 0.44
[chains.channel]
patches = ["left", "base", "right"]
{radius}
"#,
        x0 = -x,
        x1 = 50.0 + u,
    )
}

#[test]
fn each_edge_loses_its_setbacks_and_gains_its_allowance() {
    let part = made(&channel("radius = [3, 5]", [90.0, 60.0]))
        .unwrap()
        .remove(0);
    let bend = |r: f64, beta: f64| beta * (r + 0.88) - 2.0 * (r + 1.0) * libm::tan(0.5 * beta);
    let length = 100.0 + bend(3.0, FRAC_PI_2) + bend(5.0, PI / 3.0);
    let long = part.size[0].max(part.size[1]);
    assert!((long - length).abs() < 1e-9, "{long} {length}");
    assert_eq!(part.bends.len(), 2);
    let angles: Vec<f64> = part
        .bends
        .iter()
        .map(|bend| bend.angle.to_degrees().abs())
        .collect();
    assert!((angles[0] - 90.0).abs() < 1e-9 && (angles[1] - 60.0).abs() < 1e-9);
    assert!(part.bends[0].angle * part.bends[1].angle > 0.0);
    // The hole keeps its distance from the bend beside it: half of the base, less its setback, from the end of the strip.
    let hole = part.openings[0].shape.middle();
    let line = |index: usize| part.bends[index].line[0][0];
    let near = (hole[0] - line(0)).abs();
    let expected = 25.0 - 4.0 + 0.5 * FRAC_PI_2 * 3.88;
    assert!((near - expected).abs() < 1e-9, "{near} {expected}");
    let apart = (line(1) - line(0)).abs();
    let base = 50.0 - 4.0 - 6.0 * libm::tan(PI / 6.0) + 0.5 * (FRAC_PI_2 * 3.88 + PI / 3.0 * 5.88);
    assert!((apart - base).abs() < 1e-9, "{apart} {base}");
}

#[test]
fn legs_that_turn_two_ways_bend_up_and_down() {
    let part = made(&channel("radius = 3", [90.0, -90.0]))
        .unwrap()
        .remove(0);
    assert!(part.bends[0].angle * part.bends[1].angle < 0.0);
    let inside =
        channel("radius = 3", [90.0, -90.0]).replace("k-factor", "surface = \"inside\"\nk-factor");
    let refused = made(&inside).unwrap_err().to_string();
    assert!(refused.contains("bends the other way"), "{refused}");
}

#[test]
fn what_cannot_be_bent_has_no_blank() {
    let short = made(&channel("radius = 20", [90.0, 90.0]))
        .unwrap_err()
        .to_string();
    assert!(short.contains("shorter than the setback"), "{short}");
    // 20 mm of flange, and (20 + 1) tan 45 degrees.
    assert!(
        short.contains("`left` is 20.0000 mm wide at an end of the edge left-base")
            && short.contains("21.0000 mm"),
        "{short}"
    );
    let both = made(&channel("radius = [15, 35]", [90.0, 90.0])).unwrap_err();
    // 50 mm of base, and setbacks of 16 and 36 mm.
    assert!(
        both.to_string()
            .contains("`base` is 50.0000 mm wide at an end of the edge base-right, and the setback is 36.0000 mm beside the 16.0000 mm"),
        "{both}"
    );
    let no_sheet = channel("radius = 3", [90.0, 90.0])
        .replace("[sheet]\nthickness = 2\nk-factor = 0.44\n", "");
    let no_sheet = made(&no_sheet).unwrap_err().to_string();
    assert!(no_sheet.contains("`thickness`"), "{no_sheet}");
    let hole = channel("radius = 3", [90.0, 90.0]).replace("at = [0.5, 0.25]", "at = [0.15, 0.25]");
    let hole = made(&hole).unwrap_err().to_string();
    assert!(hole.contains("lies in a bend"), "{hole}");
    let cone = r#"
[curves.rim]
arc = { centre = [0, 0, 0], from = [30, 0, 0], to = [0, 30, 0] }
[patches.cone]
cone = "rim"
apex = [0, 0, 40]
range = [1, 0.5]
bend = true
[sheet]
thickness = 1
"#;
    let cone = made(cone).unwrap_err().to_string();
    assert!(cone.contains("no arc of a circular cylinder"), "{cone}");
}

#[test]
fn large_radii_are_rolled_and_edges_without_a_radius_are_scored() {
    let part = made(&channel("", [90.0, 60.0])).unwrap().remove(0);
    assert!(part.bends.is_empty() && part.sharp.len() == 2);
    assert!((part.size[0].max(part.size[1]) - 100.0).abs() < 1e-9);
    let rolled = made(&bracket("", 0.5, [1.5, 2.0]).replace(", bend = true", ""))
        .unwrap()
        .remove(0);
    assert!(rolled.bends.is_empty() && rolled.rolled.len() == 1);
    assert!(
        rolled.rolled[0]
            .radii
            .iter()
            .all(|radius| (radius - 2.75).abs() < 1e-9)
    );
    let by_face = bracket("surface = \"outside\"", 1.0, [1.5, 2.0]).replace(", bend = true", "");
    assert!(
        made(&by_face)
            .unwrap_err()
            .to_string()
            .contains("is rolled")
    );
}

#[test]
fn a_shelf_bracket_by_its_inside_is_as_long_as_the_standard_says() {
    let part = made(include_str!("../files/bracket.toml"))
        .unwrap()
        .remove(0);
    // 86 + 61 + 20 mm of flat legs, and two bends over 4 and 3 mm.
    assert!(
        (part.size[0] - 178.455_103_6).abs() < 1e-6,
        "{:?}",
        part.size
    );
    assert_eq!((part.bends.len(), part.openings.len()), (2, 2));
}

#[test]
fn no_radius_is_possible_where_bends_meet_in_a_point() {
    let corner = r#"
[curves]
south = { bezier = [[0, 0, 0], [60, 0, 0]] }
east = { bezier = [[60, 0, 0], [60, 60, 0]] }
[patches]
a = { cone = "south", apex = [30, 30, 40] }
b = { cone = "east", apex = [30, 30, 40] }
[chains.hopper]
patches = ["a", "b"]
radius = 2
[sheet]
thickness = 1
"#;
    let refused = made(corner).unwrap_err().to_string();
    assert!(
        refused.contains("comes to a point at an end of the edge")
            && refused.contains("the edges stay scored"),
        "{refused}"
    );
    let scored = made(&corner.replace("radius = 2\n", "")).unwrap();
    assert_eq!(scored[0].sharp.len(), 1);
}

#[test]
fn a_sheet_whose_edges_stand_still_has_no_radii_but_its_own() {
    let wall = |points: &str| {
        let text = format!(
            "[curves]\na = {{ bezier = [{points}] }}\n[patches.wall]\ncylinder = \"a\"\ndirection = [0, 0, 70]\n\
             [sheet]\nthickness = 1\n"
        );
        made(&text).unwrap().remove(0)
    };
    // A plane.
    let flat = wall("[0, 0, 0], [0, 0, 0], [0, 0, 0], [100, 50, 0]");
    assert!(flat.rolled.is_empty(), "{:?}", flat.rolled);
    // The parabola 100 y = x^2 with x = 100 u^2: 50 (1 + 4 (x/100)^2)^(3/2).
    let parabola = wall("[0, 0, 0], [0, 0, 0], [\"100/6\", 0, 0], [50, 0, 0], [100, 100, 0]");
    let [low, high] = parabola.rolled[0].radii;
    assert!((50.0..50.1).contains(&low), "{low}");
    assert!((high - 50.0 * 125.0_f64.sqrt()).abs() < 1e-6, "{high}");
}

#[test]
fn a_whole_cone_is_rolled_to_the_radius_of_its_wide_end() {
    let cone = r#"
[curves.rim]
arc = { centre = [0, 0, 0], from = [30, 0, 0], to = [0, 30, 0] }
[patches.cone]
cone = "rim"
apex = [0, 0, 40]
"#;
    let design = read("x.toml", cone).unwrap();
    let pieces = unroll(&design, &Demand::default()).unwrap();
    let made = parts(&design, &pieces).unwrap();
    let rolled = &made[0].rolled[0];
    // The slant is 50 for a radius of 30, and the normal curvature of the rim is (1/30)(40/50).
    assert!(rolled.apex && rolled.radii.iter().all(|r| (r - 37.5).abs() < 1e-9));
    let patterns = torse_designs::unroll::PatternSummary::new(&design, &pieces);
    let text = torse_designs::unroll::PartsList::new(&design, &made).text(&patterns);
    let text = text.split_whitespace().collect::<Vec<_>>().join(" ");
    assert!(
        text.ends_with("roll to radius 37.5 mm at the wide end, towards 0 at the apex"),
        "{text}"
    );
}

#[test]
fn coordinates_of_a_part_have_nine_decimals_at_most() {
    let part = made(&channel("radius = [3, 5]", [90.0, 60.0]))
        .unwrap()
        .remove(0);
    let ends = part.outline.iter().flat_map(|segment| segment.from);
    for length in ends.chain(part.bends.iter().flat_map(|bend| bend.line).flatten()) {
        let text = length.to_string();
        let decimals = text
            .split_once('.')
            .map_or(0, |(_, decimals)| decimals.len());
        assert!(decimals <= 9, "{text}");
    }
}

#[test]
fn the_development_of_what_tools_bend_is_told_not_to_be_the_blank() {
    use torse_designs::unroll::{PatternSummary, development_note, drawing};
    let text =
        channel("radius = 3", [90.0, 60.0]).replace("k-factor", "surface = \"outside\"\nk-factor");
    let bent = read("x.toml", &text).unwrap();
    let pieces = unroll(&bent, &Demand::default()).unwrap();
    let notes = drawing(&bent, &pieces).unwrap().notes().join("\n");
    assert!(
        notes.contains("development of the designed outside surface; not the blank")
            && !notes.contains("K-factor"),
        "{notes}"
    );
    let summary = PatternSummary::new(&bent, &pieces);
    assert!(!summary.pieces[0].is_blank);
    assert!(
        summary
            .text()
            .starts_with("channel, developed surface, not the blank: "),
        "{}",
        summary.text()
    );
    let scored = read("x.toml", &channel("", [90.0, 60.0])).unwrap();
    assert_eq!(development_note(&scored), None);
    let pieces = unroll(&scored, &Demand::default()).unwrap();
    assert!(PatternSummary::new(&scored, &pieces).pieces[0].is_blank);
}

#[test]
fn what_cannot_be_cut_is_missed() {
    let missed = |text: &str| {
        let design = read("x.toml", text).unwrap();
        let refused = unroll(&design, &Demand::default())
            .and_then(|pieces| parts(&design, &pieces))
            .unwrap_err()
            .to_string();
        let report = torse_designs::inspect::inspect(&design).unwrap();
        assert_eq!(report.missed, [refused]);
        let quick = torse_designs::inspect::inspect_quickly(&design).unwrap();
        assert!(quick.missed.is_empty());
    };
    missed(&channel("radius = 20", [90.0, 90.0]));
    let hole = |at: &str| channel("radius = 3", [90.0, 90.0]).replace("[0.5, 0.25]", at);
    missed(&hole("[0.15, 0.25]"));
    missed(&hole("[0.5, 0.01]"));
    let second = ", { at = [0.5, 0.3], radius = 6 }]";
    missed(
        &channel("radius = 3", [90.0, 90.0])
            .replace("radius = 6 }]", &format!("radius = 6 }}{second}")),
    );
    missed(
        &channel("radius = 3", [90.0, -90.0])
            .replace("k-factor", "surface = \"outside\"\nk-factor"),
    );
}

#[test]
fn an_opening_beside_a_bend_is_told_with_its_distance() {
    use torse_designs::unroll::{PartsList, PatternSummary};
    // The base is 36.5 mm long to where the bend begins; 2.5 thicknesses and the radius are 5.75 mm.
    let half_bend = 0.25 * PI * (2.0 + 0.42 * 1.5);
    for (mark, distance) in [
        (
            "{ at = [0.85, 0.5], radius = 3 }",
            36.5 * 0.15 - 3.0 + half_bend,
        ),
        (
            "{ opening = [[0.6, 0.2], [0.9, 0.4], [0.6, 0.6]] }",
            3.65 + half_bend,
        ),
        ("{ at = [0.8, 0.5], radius = 3 }", f64::NAN),
    ] {
        let base = r#"p1 = { ruled = ["base", "base2"]"#;
        let marked = bracket("k-factor = 0.42", 0.5, [1.5, 2.0]);
        let marked = marked.replace(base, &format!("{base}, marks = [{mark}]"));
        let design = read("x.toml", &marked).unwrap();
        let pieces = unroll(&design, &Demand::default()).unwrap();
        let list = PartsList::new(&design, &parts(&design, &pieces).unwrap());
        // The hole in the sheet is where it is, whatever the kerf.
        let kerf = CutOptions {
            kerf: 0.8,
            ..CutOptions::default()
        };
        let cut = PartsList::new(&design, &parts_with(&design, &pieces, kerf).unwrap());
        let distances = |list: &PartsList| -> Vec<f64> {
            let all = list.parts[0].beside_bends.iter();
            all.map(|near| near.distance).collect()
        };
        let pairs = distances(&cut).into_iter().zip(distances(&list));
        assert_eq!(distances(&cut).len(), distances(&list).len());
        assert!(pairs.into_iter().all(|(a, b)| (a - b).abs() < 1e-8));
        let text = list.text(&PatternSummary::new(&design, &pieces));
        let text = text.split_whitespace().collect::<Vec<_>>().join(" ");
        let told = &list.parts[0].beside_bends;
        if distance.is_nan() {
            assert!(told.is_empty() && !text.contains("out of shape"), "{text}");
            continue;
        }
        assert_eq!((told.len(), told[0].bend.as_str()), (1, "p2"));
        assert!((told[0].distance - distance).abs() < 1e-6, "{told:?}");
        assert!((told[0].wanted - 5.75).abs() < 1e-9);
        let words = format!(
            "is {distance:.3} mm from the line of bend p2, which may pull it out of shape: 5.750 mm are usual"
        );
        assert!(text.contains(&words), "{text}");
    }
}

#[test]
fn what_is_no_arc_of_a_circle_is_no_bend_however_few_rulings_are_shown() {
    // Its radius is 11.906 mm at both ends and in the middle, and 8.42 mm between.
    let text = |curve: &str, rulings: usize| {
        format!(
            r#"
[sheet]
thickness = 2
k-factor = 0.4
[view]
rulings = {rulings}
[curves]
a = {{ bezier = [[0, 0, 0], [40, 0, 0]] }}
a2 = {{ bezier = [[0, 60, 0], [40, 60, 0]] }}
arc = {{ {curve} }}
[patches]
A = {{ ruled = ["a", "a2"] }}
B = {{ cylinder = "arc", direction = [0, 60, 0], bend = true }}
[chains.ch]
patches = ["A", "B"]
"#
        )
    };
    let x = 52.599_210_498_948_73;
    let cubic = format!("bezier = [[40, 0, 0], [{x}, 0, 0], [{x}, 0, 20], [40, 0, 20]]");
    for rulings in [3, 5, 33] {
        let refused = made(&text(&cubic, rulings)).unwrap_err().to_string();
        assert!(
            refused.contains("no arc of a circular cylinder"),
            "{refused}"
        );
    }
    // A half turn has no corner, and no deduction.
    for (angle, has_deduction) in [(179.0, true), (180.0, false), (200.0, false)] {
        let arc = format!(
            "arc = {{ centre = [40, 0, 5], from = [40, 0, 0], axis = [0, -1, 0], angle = {angle} }}"
        );
        let part = made(&text(&arc, 3)).unwrap().remove(0);
        assert_eq!(part.bends[0].deduction.is_some(), has_deduction, "{angle}");
    }
}
