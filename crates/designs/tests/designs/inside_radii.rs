//! Inside radii: what a material allows exactly is allowed, and what falls short is told with its size.

use torse_designs::inspect::inspect_quickly;
use torse_designs::unroll::{Demand, parts, unroll};
use torse_designs::{Design, read};

fn design(text: &str) -> Design {
    read("x.toml", text).unwrap_or_else(|e| panic!("{e:?}"))
}

fn missed(text: &str) -> Vec<String> {
    inspect_quickly(&design(text)).unwrap().missed
}

/// A cylinder of this radius in millimetres whose sheet is so many tenths thick; the limit is in tenths too.
fn rolled(radius: f64, thickness: u32, least: u32, surface: &str, angle: Option<u32>) -> String {
    let far = [1000.0, 1000.0 + radius];
    let arc = match angle {
        None => format!(
            "centre = [{}, 0, 0], from = [{}, 0, 0], to = [{}, 0, {radius}]",
            far[0], far[1], far[0]
        ),
        Some(angle) => format!(
            "centre = [0, 0, 0], from = [{radius}, 0, 0], axis = [0, 1, 0], angle = {angle}"
        ),
    };
    format!(
        "[curves]\na = {{ arc = {{ {arc} }} }}\n[patches.p]\ncylinder = \"a\"\ndirection = [0, 20, 0]\n[sheet]\n\
         thickness = {}\nleast-radius = {}\nsurface = \"{surface}\"\n",
        f64::from(thickness) / 10.0,
        f64::from(least) / 10.0
    )
}

#[test]
fn a_least_radius_that_is_met_exactly_is_not_missed_and_a_little_less_is() {
    for (share, surface) in [(0, "inside"), (5, "middle"), (10, "outside")] {
        for (thickness, least) in [
            (20, 10),
            (4, 10),
            (12, 15),
            (3, 7),
            (30, 33),
            (10, 0),
            (15, 1),
        ] {
            // In hundredths of a millimetre, a whole number: the decimals of the file meet the limit exactly.
            let exact = f64::from(thickness * (least + share)) / 100.0;
            if exact == 0.0 {
                continue;
            }
            for angle in [None, Some(77), Some(190)] {
                let text = |radius: f64| rolled(radius, thickness, least, surface, angle);
                let found = missed(&text(exact));
                assert!(found.is_empty(), "{surface} {thickness} {least}: {found:?}");
                let found = missed(&text(exact * (1.0 - 1e-9)));
                let below = found
                    .iter()
                    .any(|reason| reason.starts_with("p: the inside radius"));
                assert!(below, "{surface} {thickness} {least} {angle:?}: {found:?}");
            }
        }
    }
}

#[test]
fn a_radius_that_is_missed_is_shown_with_digits_that_are_below_the_limit() {
    let found = missed(&rolled(3.0 * (1.0 - 2e-7), 20, 10, "middle", Some(90)));
    assert_eq!(
        found,
        ["p: the inside radius is 0.9999997 times the thickness, 1 at least"]
    );
    let found = missed(&rolled(0.25, 10, 10, "middle", Some(90)));
    assert_eq!(
        found,
        [
            "p: the inside radius would be negative, and is to be 1 times the thickness at least: the designed surface has a \
          radius of 0.25 mm, and the inside of the sheet is 0.5 mm nearer to the centre"
        ]
    );
}

/// Two flanges with an edge between them that is bent over a radius.
fn angle(corner: [f64; 2], radius: f64, sheet: &str) -> String {
    let [x, z] = corner;
    format!(
        r#"
[curves]
a = {{ bezier = [[0, 0, 0], [40, 0, 0]] }}
b = {{ bezier = [[0, 60, 0], [40, 60, 0]] }}
c = {{ bezier = [[40, 0, 0], [{x}, 0, {z}]] }}
d = {{ bezier = [[40, 60, 0], [{x}, 60, {z}]] }}
[patches]
base = {{ ruled = ["a", "b"] }}
wall = {{ ruled = ["c", "d"] }}
[chains.angle]
patches = ["base", "wall"]
radius = {radius}
[sheet]
{sheet}
"#
    )
}

#[test]
fn the_radius_of_an_edge_is_compared_as_the_decimals_of_the_file() {
    // In f64 0.6 / 0.4 and 0.6 / 0.2 are below 1.5 and 3.
    for (thickness, least) in [("0.4", "1.5"), ("0.2", "3"), ("0.6", "1")] {
        let sheet = format!("thickness = {thickness}\nleast-radius = {least}");
        let text = angle([40.0, 25.0], 0.6, &sheet);
        assert!(missed(&text).is_empty(), "{:?}", missed(&text));
        let tight = angle([40.0, 25.0], 0.599_999_999, &sheet);
        assert_eq!(missed(&tight).len(), 1);
    }
    // So are the rows of a table.
    let table = "thickness = 0.2\nk-factor = [[3, 0.35], [4, 0.4]]";
    let design = design(&angle([40.0, 25.0], 0.6, table));
    let made = parts(&design, &unroll(&design, &Demand::default()).unwrap()).unwrap();
    assert!((made[0].bends[0].k_factor - 0.35).abs() < 1e-12);
}

#[test]
fn an_edge_that_folds_back_is_no_flange_that_comes_to_a_point() {
    let design = design(&angle([15.0, 0.0], 2.0, "thickness = 1.5"));
    let pieces = unroll(&design, &Demand::default()).unwrap();
    let refused = parts(&design, &pieces).unwrap_err().to_string();
    assert!(refused.contains("folds by 180 degrees"), "{refused}");
}
