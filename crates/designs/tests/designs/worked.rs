//! Every worked design goes the whole way: inspected, unrolled, folded back, exported, drawn.

use std::path::{Path, PathBuf};
use torse_designs::export::{ENDINGS, bytes, mesh};
use torse_designs::fold::fold_text;
use torse_designs::inspect::{inspect, table};
use torse_designs::unroll::{Demand, PartsList, PatternSummary, parts, unroll};
use torse_designs::{Design, draw, load};

fn folder() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../../designs")
}

fn designs() -> Vec<Design> {
    let mut paths: Vec<PathBuf> = std::fs::read_dir(folder())
        .unwrap()
        .map(|entry| entry.unwrap().path())
        .filter(|path| path.extension().is_some_and(|e| e == "toml"))
        .collect();
    paths.sort();
    assert!(paths.len() >= 7, "{paths:?}");
    let design = |path: &PathBuf| load(path).unwrap_or_else(|e| panic!("{}: {e}", path.display()));
    paths.iter().map(design).collect()
}

/// Width, height and bytes of a picture.
fn pixels(png: &[u8]) -> (u32, u32, Vec<u8>) {
    let mut reader = png::Decoder::new(std::io::Cursor::new(png))
        .read_info()
        .unwrap();
    let mut bytes = vec![0; reader.output_buffer_size().unwrap()];
    let frame = reader.next_frame(&mut bytes).unwrap();
    bytes.truncate(frame.buffer_size());
    (frame.width, frame.height, bytes)
}

#[test]
fn worked_designs_meet_their_tolerances_and_the_committed_files_are_theirs() {
    for design in designs() {
        let report = inspect(&design).unwrap();
        assert!(
            report.missed.is_empty(),
            "{}: {:?}",
            design.name,
            report.missed
        );
        let mut text = table(&report);
        assert!(
            text.lines().all(|line| line.chars().count() <= 100),
            "{text}"
        );
        let demand = Demand::default();
        let pieces = unroll(&design, &demand).unwrap();
        for piece in &pieces {
            let errors = piece.flat.errors();
            assert!(errors.outline <= design.tolerances.outline && errors.outline > 0.0);
            let inside = piece.flat.outline().area();
            assert!((inside - piece.flat.area()).abs() <= errors.area);
        }
        text.push('\n');
        let patterns = PatternSummary::new(&design, &pieces);
        let list = PartsList::new(&design, &parts(&design, &pieces).unwrap());
        text.push_str(&list.text(&patterns));
        let committed = |ending: &str| {
            let path = folder().join(&design.name).with_extension(ending);
            std::fs::read(&path).unwrap_or_else(|e| panic!("{}: {e}", path.display()))
        };
        let same = |made: &[u8], ending: &str| {
            assert!(
                made == committed(ending),
                "{}.{ending} is not what the design gives: cargo run -p torse-designs --example worked -- designs",
                design.name
            );
        };
        same(text.as_bytes(), "txt");
        let pattern = bytes(&design, "dxf", &demand).unwrap();
        same(&pattern, "dxf");
        let picture = draw::picture(&design, &demand).unwrap();
        // The same pixels: how well they are packed depends on who else uses the packer.
        assert!(
            pixels(&picture.png().unwrap()) == pixels(&committed("png")),
            "{}.png is another picture: cargo run -p torse-designs --example worked -- designs",
            design.name
        );
        let folded = fold_text(&design, "pattern", std::str::from_utf8(&pattern).unwrap()).unwrap();
        assert!(
            folded.missed.is_empty(),
            "{}: {:?}",
            design.name,
            folded.missed
        );
        assert_eq!(folded.pieces.len(), pieces.len());
    }
}

#[test]
fn the_moving_picture_of_the_first_page_is_that_of_its_design() {
    let path = folder().join("square-to-round");
    let design = load(&path.with_extension("toml")).unwrap();
    let made = draw::bending(&design, &Demand::default()).unwrap();
    assert!(
        made == std::fs::read(path.with_extension("gif")).unwrap(),
        "torse draw designs/square-to-round.toml --to designs/square-to-round.gif"
    );
}

#[test]
fn worked_designs_are_written_in_every_format() {
    for design in designs() {
        for ending in ENDINGS {
            let made = bytes(&design, ending, &Demand::default());
            let made = made.unwrap_or_else(|e| panic!("{}.{ending}: {e}", design.name));
            assert!(made.len() > 400, "{}.{ending}", design.name);
        }
        let html = draw::page(&design, &Demand::default()).unwrap();
        assert!(
            html.contains("id=\"OUTLINE\"") && !html.contains("@@"),
            "{}",
            design.name
        );
        if let Some(metal) = design.metal {
            let mesh = mesh(&design).unwrap();
            assert!(mesh.is_watertight(), "{}", design.name);
            let volume: f64 = inspect(&design)
                .unwrap()
                .patches
                .iter()
                .filter_map(|p| p.area)
                .sum();
            let volume = volume * metal.sheet.thickness();
            // Up to the bends, where the faces are longer outside and shorter inside.
            assert!(
                (mesh.volume().abs() - volume).abs() < 0.02 * volume,
                "{}",
                design.name
            );
        }
    }
}

#[test]
fn patterns_fold_from_svg_as_from_dxf() {
    for name in ["lampshade", "gbt-joins"] {
        let design = load(&folder().join(name).with_extension("toml")).unwrap();
        let fold = |ending: &str| {
            let pattern = bytes(&design, ending, &Demand::default()).unwrap();
            let text = String::from_utf8(pattern).unwrap();
            fold_text(&design, &format!("pattern.{ending}"), &text).unwrap()
        };
        let (from_svg, from_dxf) = (fold("svg"), fold("dxf"));
        assert!(from_svg.missed.is_empty(), "{name}: {:?}", from_svg.missed);
        for (a, b) in from_svg.pieces.iter().zip(&from_dxf.pieces) {
            assert_eq!((a.rulings, a.deviation), (b.rulings, b.deviation), "{name}");
        }
    }
}

#[test]
fn a_pattern_that_was_changed_does_not_fold_to_the_design() {
    let design = load(&folder().join("lampshade.toml")).unwrap();
    let pattern = String::from_utf8(bytes(&design, "dxf", &Demand::default()).unwrap()).unwrap();
    // The second ruling bent by a degree or so more: its angle stands two lines after its name.
    let mut lines: Vec<String> = pattern.lines().map(str::to_owned).collect();
    let mut named = lines.iter().enumerate().filter(|(_, line)| *line == "bend");
    let (at, _) = named.nth(1).unwrap();
    let angle: f64 = lines[at + 2].parse().unwrap();
    lines[at + 2] = (angle + 0.02).to_string();
    let changed = lines.join("\n");
    assert_ne!(changed, pattern);
    let folded = fold_text(&design, "changed", &changed).unwrap();
    assert!(!folded.missed.is_empty(), "{folded:?}");
    // A pattern of another design.
    let other = load(&folder().join("hull-strake.toml")).unwrap();
    assert!(
        fold_text(&other, "pattern", &pattern).is_err()
            || !fold_text(&other, "pattern", &pattern)
                .unwrap()
                .missed
                .is_empty()
    );
}
