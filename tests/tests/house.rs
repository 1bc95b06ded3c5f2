//! The plan of the house: which room may use which.
//!
//! Read off the manifests and the sources of all rooms. A room may use what the table gives it, and what those
//! rooms may use in turn; everything else runs against the direction in which data travels. Inside of a room no files
//! may import one another in a circle, save that a file names what it is a part of.

#![allow(clippy::unwrap_used, clippy::panic, reason = "helpers of tests")]

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::{Path, PathBuf};

/// Each room with the rooms it may use. Rooms that are planned and not built stand here as well.
const ROOMS: [(&str, &[&str]); 22] = [
    ("numbers", &[]),
    ("algebra", &["numbers"]),
    ("syntax", &["numbers"]),
    ("core", &["numbers", "syntax"]),
    ("elaborate", &["numbers", "syntax", "core"]),
    ("semantics", &["numbers", "syntax"]),
    ("certificate", &["numbers", "core"]),
    ("checker", &["numbers", "core", "certificate"]),
    ("prove", &["algebra", "core", "elaborate", "certificate"]),
    ("typography", &["syntax"]),
    ("manuscript", &["syntax"]),
    (
        "verdicts",
        &[
            "core",
            "elaborate",
            "semantics",
            "prove",
            "checker",
            "typography",
        ],
    ),
    ("code", &["verdicts"]),
    ("rocq", &["syntax", "core", "elaborate", "certificate"]),
    ("geometry", &["numbers", "algebra"]),
    ("exchange", &["geometry"]),
    ("plot", &["typography"]),
    ("figures", &["syntax", "prove", "plot"]),
    ("designs", &["syntax", "geometry", "exchange", "plot"]),
    ("report", &["verdicts", "designs", "typography", "plot"]),
    (
        "torse",
        &["manuscript", "report", "code", "figures", "designs", "rocq"],
    ),
    ("cli", &["torse"]),
];

/// Doors that are built apart, by their folders beside the rooms: they see the facade alone.
const DOORS: [&str; 4] = [
    "python",
    "web/modules/border",
    "web/modules/designs",
    "web/modules/formulas",
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

/// The files of `rocq` that the writer of printed statements may use: none of them sees a core term.
const FILES_BESIDE_THE_TREE: [&str; 9] = [
    "binder",
    "code",
    "gap",
    "interval",
    "name",
    "place",
    "proposition",
    "shape",
    "unknowns",
];

#[test]
fn printed_statements_are_written_by_files_that_see_the_syntax_alone() {
    let room = crates().join("rocq/src");
    let mut inside = vec![];
    sources(&room.join("tree"), &mut inside);
    assert!(inside.len() > 5, "{inside:?}");
    let beside = FILES_BESIDE_THE_TREE.map(|file| room.join(file).with_extension("rs"));
    for path in inside.iter().chain(&beside) {
        let text = fs::read_to_string(path).unwrap();
        let rooms: Vec<&str> = named(&text, "torse_").collect();
        let is_allowed = |room: &&str| ["syntax", "numbers"].contains(room);
        assert!(
            rooms.iter().all(is_allowed),
            "{}: {rooms:?}",
            path.display()
        );
    }
    for path in inside.iter().chain(&beside) {
        let text = fs::read_to_string(path).unwrap();
        for (at, found) in text.match_indices("crate::") {
            let rest = &text[at + found.len()..];
            let end = rest.find(|c: char| !c.is_alphanumeric() && c != '_');
            let module = &rest[..end.unwrap_or(rest.len())];
            assert!(
                module == "tree" || FILES_BESIDE_THE_TREE.contains(&module),
                "{}: {module}",
                path.display()
            );
        }
    }
}

/// Whether a text uses the facade, which has the name of the house: in a manifest, or in a source.
fn uses_facade(text: &str) -> bool {
    let line = |line: &str| {
        let line = line.trim_start();
        ["torse.workspace", "torse =", "torse="]
            .iter()
            .any(|start| line.starts_with(start))
            || line.starts_with("use torse::")
            || line.contains(" torse::") && !line.starts_with("//")
    };
    text.lines().any(line)
}

#[test]
fn only_doors_use_the_facade() {
    assert!(uses_facade("[dependencies]\ntorse.workspace = true\n"));
    assert!(uses_facade("    let decided = torse::decide(text)?;"));
    assert!(!uses_facade(
        "use super::torse::Moving;\nuse my_torse::decide;"
    ));
    let mut doors = vec![];
    for room in built() {
        let folder = crates().join(&room);
        let mut files = vec![folder.join("Cargo.toml")];
        sources(&folder.join("src"), &mut files);
        let mut texts = files.iter().map(|file| fs::read_to_string(file).unwrap());
        // A file of a room may have that name, too.
        let own = folder.join("src/torse.rs").is_file() || room == "torse";
        if !own && texts.any(|text| uses_facade(&text)) {
            doors.push(room);
        }
    }
    assert_eq!(doors, ["cli"]);
}

#[test]
fn doors_that_are_built_apart_see_the_facade_alone() {
    for door in DOORS {
        let folder = crates().join("..").join(door);
        let mut files = vec![folder.join("Cargo.toml")];
        sources(&folder.join("src"), &mut files);
        assert!(files.len() > 1, "{door}");
        for file in files {
            let text = fs::read_to_string(&file).unwrap();
            // A profile says how a room is built, and imports nothing.
            let (imports, _) = text.split_once("[profile.").unwrap_or((&text, ""));
            for prefix in ["torse_", "torse-"] {
                let named: Vec<&str> = named(imports, prefix).collect();
                assert_eq!(named, [""; 0], "{}", file.display());
            }
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
            "use {torse_numbers::Ball, torse_syntax::fault};"
        ),
        ["syntax"]
    );
    assert_eq!(wrong("verdicts", "use torse_numbers::Ball;"), [""; 0]);
    assert_eq!(
        wrong("numbers", "use my_torse_algebra::Polynomial;"),
        [""; 0]
    );
    let manifest = "[dependencies]\ntorse-verdicts.workspace = true\n";
    assert_eq!(forbidden("prove", manifest, "torse-"), ["verdicts"]);
}

/// Whether a source names what makes a fault.
fn plants(text: &str) -> bool {
    text.match_indices("fault_injection::").any(|(at, _)| {
        let rest = text.get(at..).unwrap_or("");
        let import = rest.split([';', '(']).next().unwrap_or("");
        let mut names = tokens(import).into_iter();
        names.any(|name| name == "with" || name == "*")
    })
}

#[test]
fn no_limit_is_thrown() {
    // A spent budget is a value: programs that end in a panic can use the library. One file catches what an engine that is
    // wrong throws, so that it takes one claim with it and not the run.
    let mut found = vec![];
    for room in built() {
        sources(&crates().join(room).join("src"), &mut found);
    }
    found.retain(|path| {
        let text = fs::read_to_string(path).unwrap();
        let tests = text.find("#[cfg(test)]").unwrap_or(text.len());
        let words = ["resume_unwind", "panic_any", "catch_unwind"];
        words.iter().any(|word| text[..tests].contains(word))
    });
    assert_eq!(found, [crates().join("verdicts/src/pending_claim.rs")]);
}

#[test]
fn only_tests_can_plant_faults() {
    assert!(plants(
        "use torse_numbers::fault_injection::{InjectedFault, with};"
    ));
    assert!(plants("torse_numbers::fault_injection::with(fault, || ())"));
    assert!(plants("use torse_numbers::fault_injection::*;"));
    assert!(!plants(
        "use torse_numbers::fault_injection::{InjectedFault, injected};"
    ));
    let mut asking = 0;
    for room in built() {
        let mut files = vec![];
        sources(&crates().join(&room).join("src"), &mut files);
        for file in files {
            let text = fs::read_to_string(&file).unwrap();
            assert!(!plants(&text), "{}", file.display());
            asking += usize::from(text.contains("fault_injection::"));
        }
    }
    assert!(asking > 10, "{asking}");
    // There are none in a release, which has no debug assertions.
    let manifest = fs::read_to_string(crates().join("../Cargo.toml")).unwrap();
    let (_, release) = manifest.split_once("[profile.release]").unwrap_or_default();
    assert!(!release.contains("debug-assertions"), "{release}");
}

/// The names of Rust source without comments, strings and tests, and what stands between them.
fn tokens(text: &str) -> Vec<String> {
    let text = text.split("#[cfg(test)]").next().unwrap_or("");
    let mut found: Vec<String> = vec![];
    for line in text.lines() {
        let code = line.split("//").next().unwrap_or("");
        let mut word = String::new();
        for c in code.chars().chain([' ']) {
            if c.is_alphanumeric() || c == '_' {
                word.push(c);
                continue;
            }
            if !word.is_empty() {
                found.push(std::mem::take(&mut word));
            }
            if !c.is_whitespace() {
                found.push(c.to_string());
            }
        }
    }
    found
}

/// All paths of a tree such as `a::{b, c::d}`, of which the part before is known; returns where it ends.
fn paths(
    tokens: &[String],
    mut at: usize,
    before: &[String],
    found: &mut Vec<Vec<String>>,
) -> usize {
    let mut path = before.to_vec();
    loop {
        match tokens.get(at).map(String::as_str) {
            Some("{") => {
                at += 1;
                while tokens.get(at).is_some_and(|t| t != "}") {
                    at = paths(tokens, at, &path, found);
                    // `as` and the comma.
                    while tokens.get(at).is_some_and(|t| t != "," && t != "}") {
                        at += 1;
                    }
                    at += usize::from(tokens.get(at).is_some_and(|t| t == ","));
                }
                return at + 1;
            }
            Some(word) if word.starts_with(|c: char| c.is_alphabetic() || c == '_') => {
                path.push(word.to_owned());
                at += 1;
            }
            _ => break,
        }
        let colons = [tokens.get(at), tokens.get(at + 1)];
        if colons.iter().any(|t| t.is_none_or(|t| t != ":")) {
            break;
        }
        at += 2;
    }
    found.push(path);
    at
}

/// The modules of a room, by their paths, with what they name of it: paths from its root, and those that they make
/// public under another path.
struct Modules {
    named: BTreeMap<Vec<String>, Vec<Vec<String>>>,
    public: BTreeMap<Vec<String>, Vec<String>>,
}

impl Modules {
    /// Reads the files of a folder: a path relative to it, and the text.
    fn new(files: &[(String, String)]) -> Self {
        let module = |file: &str| -> Vec<String> {
            let path = file.trim_end_matches(".rs").trim_end_matches("/mod");
            let parts = path
                .split('/')
                .filter(|part| !["lib", "main", "mod"].contains(part));
            parts.map(str::to_owned).collect()
        };
        let known: BTreeSet<Vec<String>> = files.iter().map(|(file, _)| module(file)).collect();
        let (mut named, mut public) = (BTreeMap::new(), BTreeMap::new());
        for (file, text) in files {
            let own = module(file);
            let tokens = tokens(text);
            let mut all = vec![];
            for (at, token) in tokens.iter().enumerate() {
                let follows = at > 0 && tokens[at - 1] == ":";
                let first = |at: usize| tokens.get(at).is_some_and(|t| t == ":");
                // A child in `pub use child::Item` is named without `self`.
                let uses = at > 0 && tokens[at - 1] == "use";
                let child = || known.contains(&[own.clone(), vec![token.clone()]].concat());
                if follows
                    || !(["crate", "super", "self"].contains(&token.as_str()) && first(at + 1)
                        || uses && child())
                {
                    continue;
                }
                let mut found = vec![];
                paths(&tokens, at, &[], &mut found);
                let found = found.into_iter().map(|path| absolute(&own, &path));
                let start = tokens[..at].iter().rposition(|t| t == ";" || t == "}");
                let is_public =
                    uses && tokens[start.map_or(0, |s| s + 1)..at].contains(&"pub".to_owned());
                for path in found {
                    if let (true, Some(name)) = (is_public, path.last()) {
                        public.insert([own.clone(), vec![name.clone()]].concat(), path.clone());
                    }
                    all.push(path);
                }
            }
            named.insert(own, all);
        }
        Self { named, public }
    }

    /// The module in which something is that a path names.
    fn home(&self, path: &[String]) -> Option<&Vec<String>> {
        let mut path = path.to_vec();
        // Made public elsewhere, perhaps more than once.
        for _ in 0..4 {
            let beginning = (1..=path.len()).rev().find_map(|end| {
                let (start, rest) = path.split_at(end);
                // A module and a function may share a name.
                let other = self
                    .public
                    .get(start)
                    .filter(|_| !self.named.contains_key(start))?;
                Some([other.clone(), rest.to_vec()].concat())
            });
            match beginning {
                Some(other) => path = other,
                None => break,
            }
        }
        let ends = (0..=path.len()).rev();
        ends.filter_map(|end| self.named.get_key_value(path.get(..end)?))
            .map(|(module, _)| module)
            .next()
    }

    /// What each module imports, its own parts and what it is a part of left out.
    fn imports(&self) -> BTreeMap<&Vec<String>, BTreeSet<&Vec<String>>> {
        let of = |(own, paths): (&'_ Vec<String>, &'_ Vec<Vec<String>>)| {
            let homes = paths.iter().filter_map(|path| self.home(path));
            homes.filter(|home| !own.starts_with(home)).collect()
        };
        self.named
            .iter()
            .map(|entry| (entry.0, of(entry)))
            .collect()
    }

    /// The circles of modules that import one another, as text.
    fn circles(&self) -> Vec<String> {
        let imports = self.imports();
        let reach = |from: &Vec<String>| {
            let mut seen: BTreeSet<&Vec<String>> = BTreeSet::new();
            let mut pending: Vec<&Vec<String>> = imports[from].iter().copied().collect();
            while let Some(next) = pending.pop() {
                if seen.insert(next) {
                    pending.extend(&imports[next]);
                }
            }
            seen
        };
        let reached: BTreeMap<&Vec<String>, BTreeSet<&Vec<String>>> = self
            .named
            .keys()
            .map(|module| (module, reach(module)))
            .collect();
        let circle = |module: &&Vec<String>| -> Vec<String> {
            let mutual = reached[*module]
                .iter()
                .filter(|other| reached[**other].contains(*module));
            mutual.map(|other| other.join("::")).collect()
        };
        let circles: BTreeSet<Vec<String>> = self.named.keys().map(|m| circle(&m)).collect();
        circles
            .into_iter()
            .filter(|c| !c.is_empty())
            .map(|c| c.join(", "))
            .collect()
    }
}

/// A path from the root of the room, of one that begins with `crate`, `self`, `super` or a child.
fn absolute(own: &[String], path: &[String]) -> Vec<String> {
    let mut base = own.to_vec();
    let mut rest = path;
    while let Some((first, others)) = rest.split_first() {
        match first.as_str() {
            "crate" => base.clear(),
            "super" => {
                base.pop();
            }
            "self" => {}
            _ => break,
        }
        rest = others;
    }
    [base, rest.to_vec()].concat()
}

/// The sources of a room with their paths below `src`.
fn room(name: &str) -> Vec<(String, String)> {
    let folder = crates().join(name).join("src");
    let mut files = vec![];
    sources(&folder, &mut files);
    let read = |file: &PathBuf| {
        let path = file
            .strip_prefix(&folder)
            .unwrap()
            .to_str()
            .unwrap()
            .replace('\\', "/");
        (path, fs::read_to_string(file).unwrap())
    };
    files.iter().map(read).collect()
}

#[test]
fn no_files_of_a_room_import_one_another_in_a_circle() {
    let circles: Vec<String> = built()
        .iter()
        .flat_map(|name| {
            let circles = Modules::new(&room(name)).circles();
            circles
                .into_iter()
                .map(move |circle| format!("{name}: {circle}"))
        })
        .collect();
    assert!(circles.is_empty(), "{circles:?}");
}

#[test]
fn a_circle_of_files_is_seen_through_what_is_made_public_elsewhere() {
    let files = |texts: &[(&str, &str)]| -> Vec<(String, String)> {
        let owned = texts
            .iter()
            .map(|(a, b)| ((*a).to_owned(), (*b).to_owned()));
        owned.collect()
    };
    let circles = |texts: &[(&str, &str)]| Modules::new(&files(texts)).circles();
    let lib = (
        "lib.rs",
        "mod a;\nmod b;\npub use a::inner::{self, Thing as Other};",
    );
    let a = ("a/mod.rs", "pub mod inner;");
    let inner = (
        "a/inner.rs",
        "use crate::b::{Left, Right};\npub struct Thing;",
    );
    assert_eq!(
        circles(&[lib, a, inner, ("b.rs", "// use crate::a::inner;")]),
        [""; 0]
    );
    for wrong in [
        "use crate::{x, a::inner::Thing};",
        "fn f() -> super::a::inner::Thing {}",
    ] {
        assert_eq!(circles(&[lib, a, inner, ("b.rs", wrong)]), ["a::inner, b"]);
    }
    // What a file is a part of, and its own parts, are no circle.
    let parent = ("c/mod.rs", "mod d;\nuse d::Part;\npub struct Whole;");
    assert_eq!(
        circles(&[
            ("lib.rs", "mod c;"),
            parent,
            ("c/d.rs", "use super::Whole;")
        ]),
        [""; 0]
    );
    let tests = "use crate::x;\n#[cfg(test)]\nmod tests { use crate::a::inner::Thing; }";
    assert_eq!(circles(&[lib, a, inner, ("b.rs", tests)]), [""; 0]);
}

/// Rooms that decide, and the files in them that may use doubles: to skip searches that cannot succeed, to show a number, and in tests.
const DECIDING: [(&str, &[&str]); 6] = [
    ("certificate", &[]),
    ("checker", &[]),
    ("core", &[]),
    ("elaborate", &[]),
    ("prove", &["samples.rs"]),
    ("semantics", &["real.rs", "surd.rs"]),
];

#[test]
fn nothing_is_decided_in_doubles() {
    for (room, allowed) in DECIDING {
        let mut files = vec![];
        sources(&crates().join(room).join("src"), &mut files);
        let uses = |path: &PathBuf| fs::read_to_string(path).unwrap().contains("f64");
        let name = |path: &PathBuf| path.file_name().unwrap().to_string_lossy().into_owned();
        let found: BTreeSet<String> = files.iter().filter(|p| uses(p)).map(name).collect();
        let allowed: BTreeSet<String> = allowed.iter().map(|name| (*name).to_owned()).collect();
        assert_eq!(found, allowed, "{room}");
    }
}
