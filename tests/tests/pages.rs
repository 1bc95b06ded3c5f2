//! Pages name and link what is there.

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

/// The targets of the relative links and pictures of a page, without fragments.
fn links(page: &str) -> Vec<&str> {
    let targets = page.split("](").skip(1);
    let targets = targets.filter_map(|rest| rest.split_once(')').map(|(target, _)| target));
    let relative = targets.filter(|target| !target.contains("://") && !target.starts_with('#'));
    relative
        .map(|target| target.split('#').next().unwrap())
        .collect()
}

#[test]
fn every_link_of_the_readme_and_of_docs_leads_to_a_file() {
    assert_eq!(
        links("[a](b.md#c), ![d](e/f.png), [g](https://h)"),
        ["b.md", "e/f.png"]
    );
    let docs = fs::read_dir(root().join("docs")).unwrap();
    let docs = docs.map(|entry| entry.unwrap().path());
    let pages: Vec<PathBuf> = docs.chain([root().join("README.md")]).collect();
    assert!(pages.len() > 5, "{pages:?}");
    for page in pages {
        let text = fs::read_to_string(&page).unwrap();
        let folder = page.parent().unwrap();
        for link in links(&text) {
            assert!(folder.join(link).exists(), "{}: {link}", page.display());
        }
    }
}

/// The words that the glossary rules out.
fn ruled_out(glossary: &str) -> Vec<&str> {
    let cells = glossary
        .lines()
        .filter_map(|line| line.strip_suffix('|')?.rsplit('|').next());
    cells
        .flat_map(|cell| cell.split('`').skip(1).step_by(2))
        .collect()
}

#[test]
fn the_readme_and_docs_use_the_words_of_the_glossary() {
    let glossary = fs::read_to_string(root().join("docs/glossary.md")).unwrap();
    let words = ruled_out(&glossary);
    assert!(words.len() > 3, "{words:?}");
    let names = [
        "README.md",
        "docs/commands.md",
        "docs/reports.md",
        "docs/verdicts.md",
    ];
    for name in names {
        let page = fs::read_to_string(root().join(name)).unwrap();
        for word in &words {
            assert!(!page.contains(word), "{name}: {word}");
        }
    }
}

#[test]
fn every_page_of_docs_is_linked_from_its_index() {
    let index = fs::read_to_string(root().join("docs/README.md")).unwrap();
    for entry in fs::read_dir(root().join("docs")).unwrap() {
        let name = entry.unwrap().file_name().to_string_lossy().into_owned();
        let is_linked = links(&index).contains(&name.as_str());
        assert!(is_linked || name == "README.md", "{name}");
    }
}
