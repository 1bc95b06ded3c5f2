//! Sheets for the fitter, and parts in true size on pages.

use std::f64::consts::PI;
use std::path::Path;
use torse_designs::bench::{
    BenchSheet, BenchTable, PaperFigure, PaperSize, PaperStyle, TiledPart, bench_sheets,
    tiled_parts,
};
use torse_designs::unroll::{Demand, Part, PartMark, Purpose, parts, unroll};
use torse_designs::{Design, load, read};
use torse_exchange::Layer;

fn worked(name: &str) -> Design {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../designs");
    load(&folder.join(name).with_extension("toml")).unwrap()
}

fn made(design: &Design) -> (Vec<BenchSheet>, Vec<TiledPart>, Vec<Part>) {
    let pieces = unroll(design, &Demand::default()).unwrap();
    let parts = parts(design, &pieces).unwrap();
    let sheets = bench_sheets(design, &pieces, &parts, PaperSize::A4).unwrap();
    let tiled = tiled_parts(design, &pieces, &parts, PaperSize::A4).unwrap();
    (sheets, tiled, parts)
}

fn table<'s>(sheet: &'s BenchSheet, title: &str) -> &'s BenchTable {
    let found = sheet.tables.iter().find(|t| t.title.starts_with(title));
    found.unwrap_or_else(|| panic!("{title}: {:?}", sheet.tables))
}

/// The edges of all sheets: label, name in the design, length, labels that it meets.
fn edges(sheets: &[BenchSheet]) -> Vec<(String, String, f64, String)> {
    let rows = sheets.iter().flat_map(|sheet| &table(sheet, "Edges").rows);
    rows.map(|row| {
        let length = row[2].parse().unwrap();
        (row[0].clone(), row[1].clone(), length, row[4].clone())
    })
    .collect()
}

/// The corners of the box around the lines of a style.
fn bounds(figure: &PaperFigure, style: PaperStyle) -> [f64; 4] {
    let lines = figure.lines.iter().filter(|line| line.style == style);
    let points = lines.flat_map(|line| line.path.iter().map(|step| &step[step.len() - 2..]));
    points.fold(
        [
            f64::INFINITY,
            f64::INFINITY,
            f64::NEG_INFINITY,
            f64::NEG_INFINITY,
        ],
        |[a, b, c, d], p| [a.min(p[0]), b.min(p[1]), c.max(p[0]), d.max(p[1])],
    )
}

#[test]
fn edges_that_meet_in_space_name_each_other_and_are_equally_long() {
    let (sheets, ..) = made(&worked("cone-elbow"));
    let edges = edges(&sheets);
    // A ring of each part is closed by its two straight edges, and both rings meet at the mitre.
    let meets = |label: &str| edges.iter().find(|edge| edge.0 == label).unwrap().3.clone();
    assert_eq!(
        ["A1", "A2", "A3", "A4"].map(meets),
        ["B3", "A4", "free", "A2"]
    );
    assert_eq!(
        ["B1", "B2", "B3", "B4"].map(meets),
        ["free", "B4", "A1", "B2"]
    );
    let length = |label: &str| edges.iter().find(|edge| edge.0 == label).unwrap().2;
    for (a, b) in [("A1", "B3"), ("A2", "A4"), ("B2", "B4")] {
        assert!((length(a) - length(b)).abs() <= 0.011, "{a} {b}");
    }
    // The free rim of the cone is the circle of radius 80 that the design says.
    assert!((length("A3") - 160.0 * std::f64::consts::PI).abs() < 0.01);
}

#[test]
fn the_seams_of_a_design_are_the_edges_that_are_said_to_meet() {
    let design = read(
        "x.toml",
        include_str!("../../../../designs/workshop/gored-elbow.toml"),
    )
    .unwrap();
    let (sheets, ..) = made(&design);
    let edges = edges(&sheets);
    for seam in &design.seams {
        let [one, other] = seam.edges.clone().map(|edge| {
            edges
                .iter()
                .find(|known| known.1 == edge.text)
                .unwrap()
                .clone()
        });
        assert_eq!((&one.3, &other.3), (&other.0, &one.0));
    }
    // Marked on the drawing as well.
    let marks: Vec<&str> = sheets[1]
        .figure
        .texts
        .iter()
        .map(|t| t.text.as_str())
        .collect();
    assert!(
        marks.contains(&"B1 to C3") && marks.contains(&"B3 to A1"),
        "{marks:?}"
    );
}

#[test]
fn bends_stand_in_a_table_with_place_angle_radius_and_allowance() {
    let design = read("x.toml", include_str!("../files/bracket.toml")).unwrap();
    let (sheets, _, parts) = made(&design);
    let rows = &table(&sheets[0], "Bend").rows;
    // DIN 6935: K = (0.65 + lg(r/t)/2)/2, and the allowance is angle times (r + K t).
    for (row, (angle, radius)) in rows.iter().zip([(90.0_f64, 4.0_f64), (60.0, 3.0)]) {
        let k = 0.5 * (0.65 + 0.5 * libm::log10(radius / 2.0));
        let allowance = angle.to_radians() * (radius + 2.0 * k);
        assert_eq!(row[1], format!("{angle}°"));
        assert_eq!(row[3], format!("{radius}"));
        assert!(
            (row[5].parse::<f64>().unwrap() - allowance).abs() <= 0.005 + 1e-9,
            "{row:?}"
        );
    }
    let x = parts[0].bends[0].line[0][0];
    assert_eq!(rows[0][4], format!("x = {x:.2}"));
    let openings = &table(&sheets[0], "Openings").rows;
    assert_eq!(openings[0][1], "⌀ 8");
    assert_eq!(openings.len(), 2);
}

#[test]
fn the_face_that_is_drawn_is_named_and_a_mirrored_part_shows_the_other() {
    let tube = |from: &str, to: &str| {
        let text = format!(
            "[curves.rim]\narc = {{ centre = [0, 0, 0], from = {from}, to = {to} }}\n\
             [patches.tube]\ncylinder = \"rim\"\ndirection = [0, 0, 30]\n"
        );
        made(&read("x.toml", &text).unwrap()).0.remove(0)
    };
    let one = tube("[20, 0, 0]", "[0, 20, 0]");
    let other = tube("[0, 20, 0]", "[20, 0, 0]");
    let word = |sheet: &BenchSheet| {
        let note = sheet.notes[0].clone();
        assert!(
            note.contains("INSIDE") != note.contains("OUTSIDE"),
            "{note}"
        );
        (
            note.contains("INSIDE"),
            table(sheet, "Roll").rows[0][2].clone(),
        )
    };
    // Up is towards the reader, who then looks at the inside.
    for sheet in [&one, &other] {
        let (inside, way) = word(sheet);
        assert_eq!(inside, way == "up");
    }
    assert_ne!(word(&one).0, word(&other).0);
    assert_eq!(table(&one, "Roll").rows[0][1], "20");
}

#[test]
fn every_drawing_lies_on_its_paper_and_has_its_scale() {
    for name in [
        "cone-elbow",
        "lampshade",
        "square-to-round",
        "hull-strake",
        "gbt-joins",
    ] {
        let (sheets, _, parts) = made(&worked(name));
        for (sheet, part) in sheets.iter().zip(&parts) {
            let figure = &sheet.figure;
            for line in &figure.lines {
                for step in &line.path {
                    for pair in step.chunks(2) {
                        assert!((0.0..=figure.width).contains(&pair[0]), "{name}");
                        assert!((0.0..=figure.height).contains(&pair[1]), "{name}");
                    }
                }
            }
            assert!(figure.width <= sheet.page[0] && figure.height <= sheet.page[1]);
            let [left, _, right, _] = bounds(figure, PaperStyle::Outline);
            let drawn = (right - left) / sheet.scale.factor;
            // Ends of arcs may lie inside of the box.
            assert!(
                drawn <= part.size[0] + 1e-3 && drawn > 0.9 * part.size[0],
                "{name}"
            );
            let (one, other) = sheet.scale.name.split_once(':').unwrap();
            let named = one.parse::<f64>().unwrap() / other.parse::<f64>().unwrap();
            assert!((sheet.scale.factor - named).abs() < 1e-12, "{name}");
        }
    }
}

#[test]
fn pages_in_true_size_cover_the_part_and_share_their_crosses() {
    let (_, tiled, parts) = made(&worked("cone-elbow"));
    for (paper, part) in tiled.iter().zip(&parts) {
        // True size: the corners of the outline are as far apart as on the part.
        let outline = paper
            .figure
            .lines
            .iter()
            .find(|l| l.style == PaperStyle::Outline)
            .unwrap();
        let [a, b] =
            [&outline.path[0], &outline.path[1]].map(|step| step[step.len() - 2..].to_vec());
        let segment = part.outline[0];
        let first = segment.part(0.0, 1.0);
        let share = if first.is_line() {
            1.0
        } else {
            1.0 / (first.angle().abs() / std::f64::consts::FRAC_PI_4).ceil()
        };
        let end = first.point(share);
        let wanted = libm::hypot(end[0] - first.from[0], end[1] - first.from[1]);
        assert!((libm::hypot(a[0] - b[0], a[1] - b[1]) - wanted).abs() < 1e-4);
        // Every point of the outline is on a page.
        let on = |tile: &[f64; 2], x: f64, y: f64| {
            (tile[0]..=tile[0] + paper.window[0]).contains(&x)
                && (tile[1]..=tile[1] + paper.window[1]).contains(&y)
        };
        for step in &outline.path {
            let [x, y] = [step[step.len() - 2], step[step.len() - 1]];
            assert!(paper.tiles.iter().any(|tile| on(&tile.at, x, y)), "{x} {y}");
        }
        // Neighbours overlap, and what lies on the line where they meet is on both.
        let mut neighbours = 0;
        for tile in &paper.tiles {
            let Some(right) = tile.beside[1] else {
                continue;
            };
            neighbours += 1;
            let other = &paper.tiles[right - 1];
            assert_eq!(other.beside[3], Some(tile.number));
            let shared = tile.at[0] + paper.window[0] - other.at[0];
            assert!((shared - paper.overlap).abs() < 1e-9);
            let crosses = paper.figure.lines.iter().filter(|line| {
                line.style == PaperStyle::Mark
                    && line
                        .path
                        .iter()
                        .all(|p| on(&tile.at, p[0], p[1]) && on(&other.at, p[0], p[1]))
            });
            assert_eq!(crosses.count(), 4, "two crosses of two strokes");
        }
        assert!(neighbours > 0);
    }
}

#[test]
fn a_part_that_takes_too_many_pages_is_refused_with_their_number() {
    let text = "[design]\nunit = \"m\"\n[curves]\na = { bezier = [[0, 0, 0], [20, 0, 0]] }\n\
                b = { bezier = [[0, 9, 0], [20, 9, 0]] }\n[patches]\nroof = { ruled = [\"a\", \"b\"] }\n";
    let design = read("x.toml", text).unwrap();
    let pieces = unroll(&design, &Demand::default()).unwrap();
    let parts = parts(&design, &pieces).unwrap();
    let error = tiled_parts(&design, &pieces, &parts, PaperSize::Letter).unwrap_err();
    assert!(error.to_string().contains("pages of Letter"), "{error}");
}

#[test]
fn curved_edges_are_as_long_as_their_arcs() {
    // Half of a cone: rims of radius 150 and 75 in space.
    let design = read(
        "frustum.toml",
        r"
        [curves]
        wide = { arc = { centre = [0, 0, 0], from = [150, 0, 0], axis = [0, 0, 1], angle = 180 } }
        narrow = { arc = { centre = [0, 0, 80], from = [75, 0, 80], axis = [0, 0, 1], angle = 180 } }
        [patches]
        frustum = { ruled = ['wide', 'narrow'] }
        ",
    )
    .unwrap();
    let (sheets, ..) = made(&design);
    let length = |name: &str| edges(&sheets).into_iter().find(|e| e.1 == name).unwrap().2;
    assert!((length("frustum.first") - 150.0 * PI).abs() < 0.005);
    assert!((length("frustum.second") - 75.0 * PI).abs() < 0.005);
}

#[test]
fn marks_are_drawn_for_bending_and_sewing_and_on_paper_and_a_cut_says_that_it_has_none() {
    let design = read(
        "plate.toml",
        r"
        [curves]
        a = { bezier = [[0, 0, 0], [100, 0, 0]] }
        b = { bezier = [[0, 60, 0], [100, 60, 0]] }
        [patches.plate]
        ruled = ['a', 'b']
        marks = [
            { line = [[0.2, 0.2], [0.8, 0.8]] },
            { at = [0.5, 0.5], radius = 5, hole = false },
            { at = [0.1, 0.1], text = 'TOP', height = 8 },
            { at = [0.1, 0.8], radius = 3 },
        ]
        ",
    )
    .unwrap();
    let (sheets, _, parts) = made(&design);
    let part = &parts[0];
    let left_out = |purpose| part.marks_left_out(purpose);
    assert_eq!(
        [Purpose::Cut, Purpose::Bend, Purpose::Sew].map(left_out),
        [3, 1, 1]
    );
    let on_marks = |purpose| {
        let drawing = part.drawing(purpose).unwrap();
        let paths = drawing.paths().iter();
        paths.filter(|path| path.layer() == Layer::Marks).count()
    };
    assert_eq!(
        [Purpose::Cut, Purpose::Bend, Purpose::Sew].map(on_marks),
        [0, 2, 2]
    );
    // The line is as long as in the design, wherever the part was turned.
    let PartMark::Line(line) = &part.marks[0] else {
        panic!("{:?}", part.marks);
    };
    let [from, to] = [line[0], line[line.len() - 1]];
    let length = libm::hypot(to[0] - from[0], to[1] - from[1]);
    assert!((length - libm::hypot(60.0, 36.0)).abs() < 1e-8, "{length}");
    let texts = &sheets[0].figure.texts;
    assert!(texts.iter().any(|text| text.text == "TOP"), "{texts:?}");
}

#[test]
fn a_closed_flat_ring_is_no_part_with_a_slit() {
    let design = read(
        "ring.toml",
        r"
        [curves]
        inner = { arc = { centre = [0, 0, 0], from = [75, 0, 0], axis = [0, 0, 1], angle = 360 } }
        outer = { arc = { centre = [0, 0, 0], from = [105, 0, 0], axis = [0, 0, 1], angle = 360 } }
        [patches]
        ring = { ruled = ['inner', 'outer'] }
        ",
    )
    .unwrap();
    let pieces = unroll(&design, &Demand::default()).unwrap();
    let refused = parts(&design, &pieces).unwrap_err().to_string();
    assert!(refused.contains("closed flat ring"), "{refused}");
}

#[test]
fn the_edges_of_a_part_with_bends_are_all_listed_and_meet_those_of_its_seams() {
    let design = read(
        "tray.toml",
        r#"
seams = [["back.second", "side.start"]]
[sheet]
thickness = 1.5
k-factor = 0.42
[curves]
a = { bezier = [[0, 0, 60], [0, 0, 0]] }
a2 = { bezier = [[0, 200, 60], [0, 200, 0]] }
b = { bezier = [[0, 0, 0], [80, 0, 0]] }
b2 = { bezier = [[0, 200, 0], [80, 200, 0]] }
d = { bezier = [[0, 200, 60], [80, 200, 25]] }
d2 = { bezier = [[0, 200, 0], [80, 200, 0]] }
[patches]
back = { ruled = ["a", "a2"] }
floor = { ruled = ["b", "b2"] }
side = { ruled = ["d", "d2"] }
[chains.tray]
patches = ["back", "floor"]
radius = 2
"#,
    )
    .unwrap();
    let (sheets, _, parts) = made(&design);
    let all = edges(&sheets);
    let tray: Vec<_> = all.iter().filter(|edge| edge.0.starts_with('A')).collect();
    // Around the part they are as long as its outline.
    let around: f64 = tray.iter().map(|edge| edge.2).sum();
    let outline: f64 = parts[0].outline.iter().map(|side| side.length()).sum();
    assert!(
        (around - outline).abs() < 0.05,
        "{around} {outline} {all:?}"
    );
    let sewn = all.iter().find(|edge| edge.1 == "back.second").unwrap();
    let side = all.iter().find(|edge| edge.1 == "side.start").unwrap();
    assert_eq!((&sewn.3, &side.3), (&side.0, &sewn.0));
}
