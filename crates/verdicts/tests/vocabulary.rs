//! Truths about functions of the language that were written down before the engine was asked, those of degenerate statements and
//! slips among them: none is judged wrongly, and most are decided. A program that shares nothing with the engine judges the
//! truths.

#![allow(
    clippy::unwrap_used,
    clippy::print_stderr,
    reason = "a table is worth a look"
)]

use std::path::{Path, PathBuf};
use std::process::Command;
use torse_syntax::derivation::question;
use torse_syntax::taxonomy::Verdict;
use torse_verdicts::engine::decide_claim;

fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../..")
}

/// A statement with its truth.
struct Stated {
    truth: String,
    statement: String,
    setting: String,
}

/// The lines of a file of `tests/vocabulary`.
fn stated(name: &str) -> Vec<Stated> {
    let path = root().join("tests/vocabulary").join(name);
    let text = std::fs::read_to_string(path).unwrap();
    let lines = text
        .lines()
        .filter(|line| !line.is_empty() && !line.starts_with('#'));
    lines
        .map(|line| {
            let mut parts = line.split('|').map(|part| part.trim().to_owned());
            let mut next = || parts.next().unwrap();
            Stated {
                truth: next(),
                statement: next(),
                setting: next(),
            }
        })
        .collect()
}

/// How many true and false statements are decided; fails for one that is judged wrongly.
#[track_caller]
fn decided(name: &str) -> [usize; 2] {
    let (mut counts, mut wrong) = ([0, 0], vec![]);
    for own in stated(name) {
        let paper = question(&own.statement, &own.setting).unwrap();
        let found = decide_claim("vocabulary", paper.claims.first().unwrap());
        let verdict = match &found {
            Ok(found) => found.verdict(),
            // What has a value nowhere may be refused.
            Err(_) if own.truth == "silent" => continue,
            Err(error) => {
                wrong.push(format!("{}: {error:?}", own.statement));
                continue;
            }
        };
        let holds = matches!(verdict, Verdict::Holds | Verdict::Conditional);
        let fails = matches!(verdict, Verdict::False | Verdict::Misprint);
        match own.truth.as_str() {
            "true" if holds => counts[0] += 1,
            "false" if fails => counts[1] += 1,
            "true" | "false" | "silent" if !holds && !fails => {
                eprintln!("{verdict:?}: {} | {}", own.statement, own.setting);
            }
            truth => wrong.push(format!("{truth}: {} is {verdict:?}", own.statement)),
        }
        if let Ok(found) = &found
            && let Some(why) = found.contradiction()
        {
            wrong.push(format!("{}: {why}", own.statement));
        }
    }
    eprintln!("{name}: {counts:?}");
    assert_eq!(wrong, Vec::<String>::new());
    counts
}

#[test]
fn statements_about_logarithms_are_never_judged_wrongly() {
    let [holds, fails] = decided("logarithm.txt");
    assert!(holds >= 94 && fails >= 45, "{holds} and {fails}");
}

#[test]
fn statements_about_roots_are_never_judged_wrongly() {
    let [holds, fails] = decided("root.txt");
    assert!(holds >= 16 && fails >= 4, "{holds} and {fails}");
}

#[test]
fn statements_about_the_smaller_and_the_greater_number_are_never_judged_wrongly() {
    let [holds, fails] = decided("extremum.txt");
    assert!(holds >= 93 && fails >= 55, "{holds} and {fails}");
}

#[test]
fn statements_about_arcs_are_never_judged_wrongly() {
    let [holds, fails] = decided("arc.txt");
    assert!(holds >= 170 && fails >= 91, "{holds} and {fails}");
}

#[test]
fn the_truths_are_those_of_another_library() {
    let has = Command::new("python3")
        .args([
            "-c",
            "import sys, mpmath; assert sys.version_info >= (3, 11)",
        ])
        .status();
    if !has.is_ok_and(|status| status.success()) {
        eprintln!("notice: no python3 with mpmath, nothing is judged");
        return;
    }
    let files = ["logarithm.txt", "root.txt", "extremum.txt", "arc.txt"]
        .map(|name| format!("tests/vocabulary/{name}"));
    let judged = Command::new("python3")
        .arg("tests/judges/vocabulary.py")
        .args(files)
        .current_dir(root())
        .output()
        .unwrap();
    let report = String::from_utf8_lossy(&judged.stdout);
    assert!(judged.status.success(), "{report}");
}
