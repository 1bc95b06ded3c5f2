//! TRUST.md names what has to be right, with the number of its lines.

#![allow(clippy::unwrap_used, reason = "helpers of tests")]

use std::fs;
use std::path::{Path, PathBuf};

fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("..")
}

/// The lines of Rust of a file, or of all files below a folder.
fn lines(path: &Path) -> usize {
    if path.is_dir() {
        let entries = fs::read_dir(path).unwrap();
        return entries.map(|entry| lines(&entry.unwrap().path())).sum();
    }
    let is_rust = path.extension().is_some_and(|e| e == "rs");
    fs::read_to_string(path)
        .ok()
        .filter(|_| is_rust)
        .map_or(0, |text| text.lines().count())
}

/// The rows of the table of trusted code: what, and how many lines.
fn rows(page: &str) -> Vec<(String, usize)> {
    let row = |line: &str| {
        let cells: Vec<&str> = line.split('|').map(str::trim).collect();
        let path = cells.get(1)?.strip_prefix('`')?.strip_suffix('`')?;
        Some((path.to_owned(), cells.get(2)?.parse().ok()?))
    };
    page.lines().filter_map(row).collect()
}

#[test]
fn the_trusted_code_has_as_many_lines_as_the_page_says() {
    let page = fs::read_to_string(root().join("TRUST.md")).unwrap();
    let stated = rows(&page);
    assert!(stated.len() >= 7, "{stated:?}");
    let counted: Vec<(String, usize)> = stated
        .iter()
        .map(|(path, _)| (path.clone(), lines(&root().join(path))))
        .collect();
    assert_eq!(
        stated, counted,
        "TRUST.md on the left, the sources on the right"
    );
}

#[test]
fn what_the_net_uses_is_among_the_trusted_code() {
    let page = fs::read_to_string(root().join("TRUST.md")).unwrap();
    let stated = rows(&page);
    let trusted = |path: &str| stated.iter().any(|(known, _)| path.starts_with(known));
    for room in ["semantics", "numbers"] {
        assert!(trusted(&format!("crates/{room}/src")), "{room}");
    }
    // The semantics is built on nothing else of ours.
    let manifest = fs::read_to_string(root().join("crates/semantics/Cargo.toml")).unwrap();
    let (_, dependencies) = manifest.split_once("[dependencies]").unwrap();
    let ours: Vec<&str> = dependencies
        .split("[dev-dependencies]")
        .next()
        .unwrap()
        .lines()
        .filter_map(|line| line.strip_prefix("torse-")?.split(['.', ' ']).next())
        .collect();
    assert_eq!(ours, ["numbers", "syntax"]);
}

/// The cells of a row of a table; bars in code do not part cells where they are escaped.
fn cells(line: &str) -> usize {
    line.replace("\\|", "").matches('|').count()
}

/// The rows of tables that have more or fewer cells than the row before.
fn broken_rows(page: &str) -> Vec<&str> {
    let rows: Vec<&str> = page.lines().collect();
    let is_row = |line: &str| line.starts_with('|');
    rows.windows(2)
        .filter(|pair| is_row(pair[0]) && is_row(pair[1]) && cells(pair[0]) != cells(pair[1]))
        .map(|pair| pair[1])
        .collect()
}

#[test]
fn every_row_of_a_table_has_as_many_cells_as_the_others() {
    assert_eq!(broken_rows("| a | b |\n|---|---|\n| c |\n"), ["| c |"]);
    let pages = [
        "README.md",
        "TRUST.md",
        "proofs/README.md",
        "derivations/SEMANTICS.md",
    ];
    let more = [
        "derivations/README.md",
        "derivations/COVERAGE.md",
        "designs/README.md",
        "docs/README.md",
        "docs/commands.md",
        "docs/glossary.md",
        "docs/reports.md",
        "docs/verdicts.md",
    ];
    for page in pages.into_iter().chain(more) {
        let text = fs::read_to_string(root().join(page)).unwrap();
        assert_eq!(broken_rows(&text), Vec::<&str>::new(), "{page}");
    }
}
