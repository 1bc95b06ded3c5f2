//! What all stages share is judged by programs that share nothing with them: the trees of the parser by Python's own parser,
//! declarations by a second merge of the TOML, enclosures by mpmath.
//!
//! A notice says where Python or mpmath is missing; nothing is judged then.

#![allow(
    clippy::unwrap_used,
    clippy::expect_used,
    clippy::print_stderr,
    reason = "helpers of tests"
)]

use serde_json::json;
use std::io::Write;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};
use torse_numbers::fault_injection::{InjectedFault, with};
use torse_syntax::derivation;
use torse_syntax::formula::parse;
use torse_tests::dump;

const SEED: u64 = 1;

fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("..")
}

/// Whether Python can do it; says so if not.
fn python_has(module: &str) -> bool {
    let tried = Command::new("python3")
        .args([
            "-c",
            &format!("import sys, {module}; assert sys.version_info >= (3, 11)"),
        ])
        .stderr(Stdio::null())
        .status();
    let found = tried.is_ok_and(|status| status.success());
    if !found {
        eprintln!("notice: no python3 with {module}, nothing is judged");
    }
    found
}

/// What a judge says of these lines, and whether it is content.
fn judged(judge: &str, arguments: &[&str], lines: &[String]) -> (bool, String) {
    let mut child = Command::new("python3")
        .arg(Path::new("tests/judges").join(judge))
        .args(arguments)
        .current_dir(root())
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .spawn()
        .unwrap();
    let mut pipe = child.stdin.take().unwrap();
    let text = lines.join("\n");
    let writer = std::thread::spawn(move || {
        // A judge that reads nothing closes the pipe.
        let _ = pipe.write_all(text.as_bytes());
    });
    let output = child.wait_with_output().unwrap();
    writer.join().unwrap();
    (
        output.status.success(),
        String::from_utf8(output.stdout).unwrap(),
    )
}

#[track_caller]
fn content(judge: &str, arguments: &[&str], lines: &[String]) -> String {
    let (content, report) = judged(judge, arguments, lines);
    assert!(content, "{report}");
    report
}

/// The count of this name in the first line of a report.
fn count(report: &str, name: &str) -> u64 {
    let first = report.lines().next().unwrap_or("");
    let counts: serde_json::Value = serde_json::from_str(first).unwrap();
    counts[name].as_u64().unwrap_or(0)
}

/// Texts with their trees: every text of the derivation files, formula or not, and random ones.
fn trees() -> Vec<String> {
    let report = content(
        "trees.py",
        &["texts", "derivations", &SEED.to_string(), "4000"],
        &[],
    );
    let texts = report
        .lines()
        .map(|line| serde_json::from_str::<String>(line).unwrap());
    texts
        .map(|text| {
            let tree = parse(&text).ok().map(|expr| dump::tree(&expr));
            json!([text, tree]).to_string()
        })
        .collect()
}

#[test]
fn trees_are_those_of_another_parser_and_what_is_no_formula_is_none_there() {
    if !python_has("ast") {
        return;
    }
    let lines = trees();
    let report = content("trees.py", &["compare"], &lines);
    assert!(count(&report, "formulas") > 5_000, "{report}");
    assert!(count(&report, "refused") > 3_000, "{report}");
    assert_eq!(count(&report, "long"), 0, "{report}");
}

#[test]
fn another_tree_is_seen() {
    if !python_has("ast") {
        return;
    }
    for (text, tree) in [
        ("a - b - c", "(- a (- b c))"),
        ("-x^2", "(^ (neg x) 2)"),
        ("p implies q implies r", "(implies (implies p q) r)"),
        ("0.10", "1/10@1"),
    ] {
        let (content, _) = judged("trees.py", &["compare"], &[json!([text, tree]).to_string()]);
        assert!(!content, "{text}");
    }
}

/// The claims of all derivation files in their effective form.
fn claims() -> Vec<serde_json::Value> {
    let papers = derivation::load(&root().join("derivations")).unwrap();
    let claims = papers.iter().flat_map(|paper| &paper.claims);
    claims.flat_map(dump::claim::claims).collect()
}

#[test]
fn claims_inherit_what_a_second_merge_says() {
    if !python_has("tomllib") {
        return;
    }
    let mut claims = claims();
    let lines: Vec<String> = claims.iter().map(ToString::to_string).collect();
    let report = content("declarations.py", &["derivations"], &lines);
    assert!(count(&report, "claims") > 1_200, "{report}");
    // One hypothesis, one end and one origin less are seen.
    for field in ["assume", "symbols", "ranges", "definitions"] {
        let before = claims.clone();
        let changed = claims.iter_mut().find_map(|claim| match &mut claim[field] {
            serde_json::Value::Array(list) => list.pop(),
            serde_json::Value::Object(map) => {
                let first = map.keys().next().cloned()?;
                map.remove(&first)
            }
            _ => None,
        });
        assert!(changed.is_some(), "{field}");
        let lines: Vec<String> = claims.iter().map(ToString::to_string).collect();
        assert!(
            !judged("declarations.py", &["derivations"], &lines).0,
            "{field}"
        );
        claims = before;
    }
}

#[test]
fn enclosures_contain_the_values_of_another_library() {
    if !python_has("mpmath") {
        return;
    }
    let lines: Vec<String> = (0..1_200)
        .map(|number| dump::ball::line(SEED, number).to_string())
        .collect();
    let report = content("enclosures.py", &[], &lines);
    for operation in [
        "quotient",
        "root",
        "sine",
        "exponential",
        "logarithm",
        "arc tangent",
        "arc sine",
        "pi",
    ] {
        assert!(count(&report, operation) > 50, "{report}");
    }
    // A value that is moved by one part in a hundred is seen.
    let moved = lines
        .iter()
        .find(|line| line.contains("\"operation\":\"exponential\""))
        .unwrap();
    let mut moved: serde_json::Value = serde_json::from_str(moved).unwrap();
    moved["value"] = json!(["7/100", "8/100"]);
    assert!(!judged("enclosures.py", &[], &[moved.to_string()]).0);
}

#[test]
fn deliberate_mistakes_of_reading_and_rounding_are_seen() {
    if !python_has("mpmath") {
        return;
    }
    let tree = |text: &str| {
        let tree = parse(text).ok().map(|expr| dump::tree(&expr));
        json!([text, tree]).to_string()
    };
    for (fault, text) in [
        (InjectedFault::DifferenceFromTheRight, "a - b - c"),
        (InjectedFault::SignBeforePower, "-x^2"),
        (InjectedFault::DecimalsForgotten, "agrees(x, 0.10)"),
    ] {
        let wrong = with(fault, || tree(text));
        assert!(!judged("trees.py", &["compare"], &[wrong]).0, "{fault:?}");
    }
    for fault in [
        InjectedFault::OuterDeclarationKept,
        InjectedFault::HypothesisLeftOut,
        InjectedFault::OpenEndClosed,
    ] {
        let claims: Vec<String> = with(fault, claims)
            .iter()
            .map(ToString::to_string)
            .collect();
        assert!(
            !judged("declarations.py", &["derivations"], &claims).0,
            "{fault:?}"
        );
    }
    for fault in [
        InjectedFault::RoundedInward,
        InjectedFault::LogarithmRoundedDown,
        InjectedFault::ArcRoundedDown,
    ] {
        let lines: Vec<String> = with(fault, || {
            let lines = (0..400).map(|number| dump::ball::line(SEED, number).to_string());
            lines.collect()
        });
        assert!(!judged("enclosures.py", &[], &lines).0, "{fault:?}");
    }
}
