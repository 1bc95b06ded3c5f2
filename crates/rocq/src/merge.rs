//! A folder that is there, with what a run for some claims says anew: nothing of the other claims is lost.

use crate::check::{self, PROOFS};
use crate::closed::CLOSED;
use crate::folder::{Folder, NOT_PRINTED, NOT_STATED, PROJECT, listed};
use crate::modules::{join, split};
use std::collections::{BTreeMap, BTreeSet};

/// The files of `old` that are ours, by its list of files. `read` gives a file of it, if it is there.
pub fn ours(read: &dyn Fn(&str) -> Option<String>) -> BTreeMap<String, String> {
    let project = read(PROJECT).unwrap_or_default();
    let named = check::listed(&project).chain([NOT_STATED, NOT_PRINTED]);
    named
        .filter_map(|path| Some((path.to_owned(), read(path)?)))
        .collect()
}

/// The files of a folder for some claims, and of the other claims what `old` has of them.
#[must_use]
pub fn merged(fresh: &Folder, old: &BTreeMap<String, String>) -> BTreeMap<String, String> {
    let mut files = fresh.files.clone();
    for (path, text) in old.iter().filter(|(path, _)| path.contains('/')) {
        if path.ends_with(CLOSED) {
            files.entry(path.clone()).or_insert_with(|| text.clone());
            continue;
        }
        let statements = match path.strip_suffix(PROOFS) {
            Some(section) => format!("{section}.v"),
            None => path.clone(),
        };
        if statements.starts_with("Torse/") || check::is_list(path) {
            continue;
        }
        // What the run states anew has no old text, and neither has what it no longer states.
        let stated = fresh.files.get(&statements).map_or("", String::as_str);
        let anew: BTreeSet<&str> = split(stated)
            .modules
            .iter()
            .map(|(name, _)| *name)
            .collect();
        let gone = gone(fresh, old.get(&statements).map_or("", String::as_str));
        let kept = split(text);
        let kept_bodies = kept
            .modules
            .iter()
            .filter(|(name, _)| !anew.contains(name) && !gone.contains(name))
            .map(|(_, body)| *body);
        let own = files.get(path).cloned();
        let own = own.as_deref().map(split);
        let head = match &own {
            Some(own) => head(own.head, kept.head),
            None => kept.head.to_owned(),
        };
        let own_bodies = own
            .iter()
            .flat_map(|own| own.modules.iter().map(|(_, body)| *body));
        let bodies: Vec<&str> = kept_bodies.chain(own_bodies).collect();
        match bodies.is_empty() {
            true => files.remove(path),
            false => files.insert(path.clone(), join(&head, bodies)),
        };
    }
    for (path, fresh_reasons) in [
        (NOT_STATED, &fresh.not_stated),
        (NOT_PRINTED, &fresh.not_printed),
    ] {
        let mut all = reasons(old, path);
        all.retain(|id, _| !fresh.asked.contains(id));
        all.extend(fresh_reasons.clone());
        files.insert(path.to_owned(), listed(&all));
    }
    let lists = check::referees(&files);
    files.extend(lists);
    files.insert(PROJECT.to_owned(), check::project(&files));
    files
}

/// What files import of the library, and what those import in which a statement is about functions.
const FURTHER: [(&str, &str); 2] = [
    ("Import Defs.", "Import Defs Functions."),
    ("Import Defs Follows.", "Import Defs Follows Jets."),
];

/// A head with the lines of the old one by which kept modules use the definitions of their section.
fn head(fresh: &str, old: &str) -> String {
    let used = old.lines().filter(|line| {
        (line.starts_with("From ") || line.starts_with("Import "))
            && !line.starts_with("From Torse ")
            && !fresh.lines().any(|own| own == *line)
    });
    let further = |mut head: String, (plain, more): (&str, &str)| {
        if old.contains(more) && !head.contains(more) {
            head = head.replace(plain, more);
        }
        head
    };
    let fresh = FURTHER.into_iter().fold(fresh.to_owned(), further);
    used.fold(fresh, |text, line| text + line + "\n")
}

/// The modules of an old file of statements whose claims the run asked for.
fn gone<'a>(fresh: &Folder, old: &'a str) -> BTreeSet<&'a str> {
    let modules = split(old).modules;
    let of_claim = |body: &str| {
        let (_, about) = body.split_once("\n(* ").unwrap_or_default();
        let (id, _) = about.split_once(',').unwrap_or_default();
        fresh
            .asked
            .contains(id.strip_suffix(" (corrected)").unwrap_or(id))
    };
    let asked = modules.into_iter().filter(|(_, body)| of_claim(body));
    asked.map(|(name, _)| name).collect()
}

/// The claims that a list of an old folder names, with the reasons; none where it cannot be read.
fn reasons(old: &BTreeMap<String, String>, path: &str) -> BTreeMap<String, String> {
    let text = old.get(path).map_or("", String::as_str);
    serde_json::from_str(text).unwrap_or_default()
}
