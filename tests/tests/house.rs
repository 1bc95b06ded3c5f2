//! The plan of the house: which room may use which.
//!
//! Read off the manifests and the sources of all rooms. A room may use what the table gives it, and what those
//! rooms may use in turn; everything else runs against the direction in which data travels.

#![allow(clippy::unwrap_used, clippy::panic, reason = "helpers of tests")]

use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};

/// Each room with the rooms it may use. Rooms that are planned and not built stand here as well.
const ROOMS: [(&str, &[&str]); 15] = [
    ("numbers", &[]),
    ("algebra", &["numbers"]),
    ("language", &["numbers"]),
    ("semantics", &["numbers", "language"]),
    ("proof", &["numbers", "language"]),
    ("prove", &["algebra", "language", "proof"]),
    ("verdicts", &["semantics", "prove"]),
    ("rocq", &["language", "proof"]),
    ("geometry", &["numbers", "algebra"]),
    ("exchange", &["geometry"]),
    ("figures", &[]),
    ("plates", &["language", "prove", "figures"]),
    ("designs", &["language", "geometry", "exchange", "figures"]),
    ("report", &["verdicts", "figures"]),
    ("cli", &["report", "plates", "designs", "rocq"]),
];

/// The rooms that a room may use, directly or through others.
fn within_reach(room: &str) -> BTreeSet<&'static str> {
    let own = ROOMS.iter().find(|(name, _)| *name == room);
    let (_, uses) = own.unwrap_or_else(|| panic!("{room} is not in the table"));
    let through = uses.iter().flat_map(|other| within_reach(other));
    uses.iter().copied().chain(through).collect()
}

/// The rooms that a text names by `prefix`, as in `torse_algebra` or `torse-algebra`.
fn named<'a>(text: &'a str, prefix: &'a str) -> impl Iterator<Item = &'a str> {
    text.match_indices(prefix).filter_map(move |(at, _)| {
        let before = text.get(..at)?.chars().next_back();
        if before.is_some_and(|c| c.is_alphanumeric() || c == '_' || c == '-') {
            return None;
        }
        let rest = text.get(at + prefix.len()..)?;
        let end = rest
            .find(|c: char| !c.is_alphanumeric())
            .unwrap_or(rest.len());
        let name = rest.get(..end)?;
        ROOMS.iter().any(|(room, _)| *room == name).then_some(name)
    })
}

/// What a room names and may not use.
fn forbidden(room: &str, text: &str, prefix: &str) -> Vec<String> {
    let reach = within_reach(room);
    let wrong = named(text, prefix).filter(|name| *name != room && !reach.contains(name));
    wrong.map(str::to_owned).collect()
}

fn crates() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../crates")
}

/// The rooms that are built.
fn built() -> Vec<String> {
    let folders = fs::read_dir(crates()).unwrap().map(|entry| entry.unwrap());
    let rooms = folders.filter(|entry| entry.path().join("Cargo.toml").is_file());
    let mut rooms: Vec<String> = rooms
        .map(|entry| entry.file_name().into_string().unwrap())
        .collect();
    rooms.sort();
    rooms
}

fn sources(folder: &Path, found: &mut Vec<PathBuf>) {
    for entry in fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        if path.is_dir() {
            sources(&path, found);
        } else if path.extension().is_some_and(|e| e == "rs") {
            found.push(path);
        }
    }
}

#[test]
fn the_table_has_one_direction() {
    for (place, (room, uses)) in ROOMS.iter().enumerate() {
        let before: Vec<&str> = ROOMS.iter().take(place).map(|(name, _)| *name).collect();
        assert!(uses.iter().all(|other| before.contains(other)), "{room}");
    }
}

#[test]
fn every_room_is_in_the_table() {
    let rooms = built();
    assert!(rooms.len() > 5, "{rooms:?}");
    for room in rooms {
        within_reach(&room);
    }
}

#[test]
fn no_manifest_depends_against_the_direction() {
    for room in built() {
        let manifest = fs::read_to_string(crates().join(&room).join("Cargo.toml")).unwrap();
        assert_eq!(
            forbidden(&room, &manifest, "torse-"),
            [""; 0],
            "crates/{room}/Cargo.toml"
        );
    }
}

#[test]
fn no_source_imports_against_the_direction() {
    for room in built() {
        let mut files = vec![];
        sources(&crates().join(&room), &mut files);
        assert!(!files.is_empty(), "{room}");
        for file in files {
            let text = fs::read_to_string(&file).unwrap();
            assert_eq!(
                forbidden(&room, &text, "torse_"),
                [""; 0],
                "{}",
                file.display()
            );
        }
    }
}

#[test]
fn an_import_against_the_direction_is_seen() {
    let wrong = |room, text| forbidden(room, text, "torse_");
    assert_eq!(
        wrong("numbers", "use torse_algebra::Polynomial;"),
        ["algebra"]
    );
    assert_eq!(
        wrong("algebra", "let p: torse_prove::decide::Decision;"),
        ["prove"]
    );
    assert_eq!(
        wrong(
            "geometry",
            "use {torse_numbers::Ball, torse_language::fault};"
        ),
        ["language"]
    );
    assert_eq!(wrong("verdicts", "use torse_numbers::Ball;"), [""; 0]);
    assert_eq!(
        wrong("numbers", "use my_torse_algebra::Polynomial;"),
        [""; 0]
    );
    let manifest = "[dependencies]\ntorse-verdicts.workspace = true\n";
    assert_eq!(forbidden("prove", manifest, "torse-"), ["verdicts"]);
}
