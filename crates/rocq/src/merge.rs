//! Merges a run for some claims into an existing folder: nothing of the other claims is lost.

use crate::check::{self, PROOFS};
use crate::closed::CLOSED;
use crate::folder::{Folder, NOT_PRINTED, NOT_STATED, PROJECT, listed};
use crate::modules::{join, split};
use std::collections::{BTreeMap, BTreeSet};

/// Returns the files of `old` that are ours, by its list of files. `read` returns a file, if it exists.
pub fn ours(read: &dyn Fn(&str) -> Option<String>) -> BTreeMap<String, String> {
    let project = read(PROJECT).unwrap_or_default();
    let named = check::listed(&project).chain([NOT_STATED, NOT_PRINTED]);
    named
        .filter_map(|path| Some((path.to_owned(), read(path)?)))
        .collect()
}

/// Returns the files of a folder for some claims, with the content of `old` for the other claims.
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
        // Modules of claims of this run, written anew or dropped, are not kept.
        let stated = fresh.files.get(&statements).map_or("", String::as_str);
        let rewritten: BTreeSet<&str> = split(stated)
            .modules
            .iter()
            .map(|(name, _)| *name)
            .collect();
        let replaced = replaced(fresh, old.get(&statements).map_or("", String::as_str));
        let kept = split(text);
        let kept_bodies = kept
            .modules
            .iter()
            .filter(|(name, _)| !rewritten.contains(name) && !replaced.contains(name))
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
        all.retain(|id, _| !fresh.requested.contains(id));
        all.extend(fresh_reasons.clone());
        files.insert(path.to_owned(), listed(&all));
    }
    let lists = check::referees(&files);
    files.extend(lists);
    files.insert(PROJECT.to_owned(), check::project(&files));
    files
}

/// The imports of files from the library, and the imports of files with statements about functions.
const FURTHER: [(&str, &str); 2] = [
    ("Import Defs.", "Import Defs Functions."),
    ("Import Defs Follows.", "Import Defs Follows Jets."),
];

/// Returns a head with the lines of the old one by which kept modules use the definitions of their section.
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

/// Returns the modules of an old file of statements that belong to claims of this run.
fn replaced<'a>(fresh: &Folder, old: &'a str) -> BTreeSet<&'a str> {
    let modules = split(old).modules;
    let of_claim = |body: &str| {
        let (_, about) = body.split_once("\n(* ").unwrap_or_default();
        let (id, _) = about.split_once(',').unwrap_or_default();
        fresh
            .requested
            .contains(id.strip_suffix(" (corrected)").unwrap_or(id))
    };
    let requested = modules.into_iter().filter(|(_, body)| of_claim(body));
    requested.map(|(name, _)| name).collect()
}

/// Reads the claims in a list of an old folder, with their reasons; none if it cannot be read.
fn reasons(old: &BTreeMap<String, String>, path: &str) -> BTreeMap<String, String> {
    let text = old.get(path).map_or("", String::as_str);
    serde_json::from_str(text).unwrap_or_default()
}
