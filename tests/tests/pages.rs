//! The pages for people who work on the code name what is there.

#![allow(clippy::unwrap_used, reason = "helpers of tests")]

use std::fs;
use std::path::{Path, PathBuf};

fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("..")
}

/// The code spans of a page outside of indented blocks.
fn code_spans(page: &str) -> Vec<&str> {
    let lines = page.lines().filter(|line| !line.starts_with("    "));
    let spans = lines.flat_map(|line| line.split('`').skip(1).step_by(2));
    spans.collect()
}

/// The paths of the repository among code spans that do not exist.
fn missing<'a>(spans: &[&'a str]) -> Vec<&'a str> {
    let tops = ["crates/", "tests/", "derivations/", "designs/", ".ci/"];
    let is_path = |span: &&str| tops.iter().any(|top| span.starts_with(top));
    let is_pattern =
        |span: &&str| span.contains(['*', ' ']) || span.contains("PAPER") || span.contains("NAME");
    let paths = spans
        .iter()
        .copied()
        .filter(|span| is_path(span) && !is_pattern(span));
    paths.filter(|path| !root().join(path).exists()).collect()
}

#[test]
fn every_path_that_the_maps_name_exists() {
    assert_eq!(
        missing(&["crates/numbers/src/lib.rs", "crates/none/src"]),
        ["crates/none/src"]
    );
    for name in ["ARCHITECTURE.md", "CONTRIBUTING.md"] {
        let page = fs::read_to_string(root().join(name)).unwrap();
        let spans = code_spans(&page);
        assert!(spans.len() > 20, "{name}: {}", spans.len());
        assert_eq!(missing(&spans), [""; 0], "{name}");
    }
}

#[test]
fn every_room_has_a_row_in_the_architecture() {
    let page = fs::read_to_string(root().join("ARCHITECTURE.md")).unwrap();
    for entry in fs::read_dir(root().join("crates")).unwrap() {
        let folder = entry.unwrap().path();
        if folder.join("Cargo.toml").is_file() {
            let room = folder.file_name().unwrap().to_string_lossy().into_owned();
            assert!(page.contains(&format!("| `{room}` |")), "{room}");
        }
    }
}
