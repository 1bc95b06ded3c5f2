//! Points that an editor may move: where they are, and where their numbers stand in the text.

use std::path::Path;
use torse_designs::{Design, DesignUnit, read};

fn texts() -> Vec<(String, String)> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../designs");
    let mut texts = vec![];
    for folder in [folder.clone(), folder.join("workshop")] {
        for file in std::fs::read_dir(folder).unwrap().flatten() {
            let name = file.file_name().into_string().unwrap();
            if name.ends_with(".toml") {
                texts.push((name, std::fs::read_to_string(file.path()).unwrap()));
            }
        }
    }
    texts.sort();
    texts
}

fn millimetres(unit: DesignUnit) -> f64 {
    match unit {
        DesignUnit::Millimetre => 1.0,
        DesignUnit::Centimetre => 10.0,
        DesignUnit::Metre => 1000.0,
        DesignUnit::Inch => 25.4,
        DesignUnit::Foot => 304.8,
    }
}

#[test]
fn the_numbers_of_each_point_stand_where_it_says() {
    let (mut plain, mut formulas) = (0, 0);
    for (name, text) in texts() {
        // Some take curves from files.
        let Ok(design) = read(&name, &text) else {
            continue;
        };
        for point in &design.points {
            for axis in 0..3 {
                let written = &text[point.places[axis].clone()];
                if !point.plain[axis] {
                    assert!(written.starts_with(['"', '\'']), "{name}: {written}");
                    formulas += 1;
                    continue;
                }
                let value: f64 = written.parse().unwrap();
                let there = value * millimetres(design.unit);
                let away = (there - point.at[axis]).abs();
                assert!(
                    away <= 1e-12 * there.abs(),
                    "{name}, {}: {written}",
                    point.name
                );
                plain += 1;
            }
        }
    }
    assert!(plain > 60 && formulas > 30, "{plain} {formulas}");
}

const TEXT: &str = r#"
[points]
# μ stands before it.
A = [0, 0, 40]
[planes]
cut = { point = [0, 0, 5], normal = [1, 0, 0] }
[curves]
rim = { arc = { centre = [0, 0, 0], from = ["3*10", 0, 0], to = [0, 30, 0] } }
free = { through = [[0, 0, 0], [10, 0, 5], "A"], ends = { start = [1, 0, 0], end = [1, 0, 1] } }
wave = { spline = { degree = 2, points = [[0, 0, 0], [5, 5, 0], [9, 0, 1]] } }
[patches.cone]
cone = "rim"
apex = "A"
[patches.tube]
cylinder = "rim"
direction = [0, 0, 30]
"#;

fn moved(design: &Design, text: &str, name: &str, number: usize) -> String {
    let mut points = design.points.iter();
    let point = points
        .find(|p| p.name == name && p.number == number)
        .unwrap();
    let mut text = text.to_owned();
    text.replace_range(point.places[2].clone(), "7.5");
    text
}

#[test]
fn points_are_listed_with_their_names_and_vectors_are_not() {
    let design = read("points.toml", TEXT).unwrap();
    let names: Vec<(&str, usize)> = design
        .points
        .iter()
        .map(|p| (p.name.as_str(), p.number))
        .collect();
    let expected = [
        ("A", 0),
        ("cut", 1),
        ("rim", 1),
        ("rim", 2),
        ("rim", 3),
        ("free", 1),
        ("free", 2),
        ("wave", 1),
        ("wave", 2),
        ("wave", 3),
    ];
    assert_eq!(names, expected);
    let from = &design.points[3];
    assert_eq!(
        (from.at, from.plain),
        ([30.0, 0.0, 0.0], [false, true, true])
    );
}

#[test]
fn a_point_that_is_moved_in_the_text_moves_in_the_design() {
    let design = read("points.toml", TEXT).unwrap();
    for (name, number) in [("A", 0), ("cut", 1), ("free", 2), ("wave", 2)] {
        let text = moved(&design, TEXT, name, number);
        let after = read("points.toml", &text).unwrap();
        for (old, new) in design.points.iter().zip(&after.points) {
            let is_it = old.name == name && old.number == number;
            assert_eq!(
                new.at[2],
                if is_it { 7.5 } else { old.at[2] },
                "{name} {number}"
            );
            assert_eq!(new.at[..2], old.at[..2]);
        }
    }
}
