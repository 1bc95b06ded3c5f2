//! The tree holds sources, and of what commands write only what a page shows or a reader compares.

#![allow(clippy::unwrap_used, clippy::expect_used, reason = "helpers of tests")]

use std::path::Path;
use std::process::Command;

/// The most bytes of all files together.
const MAX_TREE: u64 = 23_500_000;

/// The most bytes of a file.
const MAX_FILE: u64 = 500_000;

/// The files under version control with their sizes; none where there is no repository, as in a packed crate.
fn tracked() -> Vec<(String, u64)> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("..");
    let listed = Command::new("git")
        .args(["ls-files", "-z"])
        .current_dir(&root)
        .output();
    let Ok(listed) = listed else { return vec![] };
    let names = String::from_utf8(listed.stdout).unwrap();
    let names = names.split_terminator('\0');
    let sized = names.filter_map(|name| {
        Some((
            name.to_owned(),
            root.join(name).symlink_metadata().ok()?.len(),
        ))
    });
    sized.collect()
}

#[test]
fn the_tree_is_small_and_so_is_every_file() {
    let files = tracked();
    if files.is_empty() {
        eprintln!("notice: this is no repository, its tree was not measured");
    }
    for (name, size) in &files {
        assert!(*size <= MAX_FILE, "{name} has {size} bytes");
    }
    let all: u64 = files.iter().map(|(_, size)| size).sum();
    assert!(all <= MAX_TREE, "{all} bytes");
}

#[test]
fn of_the_reports_the_letters_the_table_and_the_pictures_of_pages_are_kept() {
    let pages = [
        "README.md",
        "docs/reports.md",
        "reports/README.md",
        "derivations/README.md",
    ];
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("..");
    let pages: Vec<String> = pages
        .iter()
        .map(|page| std::fs::read_to_string(root.join(page)).unwrap())
        .collect();
    for (name, _) in tracked() {
        let Some(name) = name.strip_prefix("reports/") else {
            continue;
        };
        let is_letter = name.contains("-erratum.");
        let is_shown = pages.iter().any(|page| page.contains(name));
        assert!(
            is_letter || is_shown,
            "{name} is written by `torse report` and shown nowhere"
        );
    }
}
