//! What continuous integration is told: annotations of GitHub, SARIF, versions, the files that call the command there.

use crate::support::{torse, torse_in};
use serde_json::Value;
use std::fs;
use std::path::Path;
use tempfile::TempDir;

/// A repository with a folder of derivations: one claim as expected, one that is not, one that is false, one that is no formula.
fn repository() -> TempDir {
    let repository = TempDir::new().unwrap();
    let paper = repository.path().join("derivations/p");
    fs::create_dir_all(&paper).unwrap();
    let head = "[paper]\nid = 'p'\ntitle = 'T'\nauthors = 'A'\nvenue = 'V'\nclaims = ['c.toml']\n[symbols]\nx = { in = '(-inf, inf)' }\n";
    fs::write(paper.join("paper.toml"), head).unwrap();
    let claim = |name: &str, states: &str, more: &str| {
        format!(
            "[[claim]]\nid = 'p/{name}'\nat = ''\nkind = 'identity'\nprinted = ''\nstates = '{states}'\n{more}\n"
        )
    };
    let claims = [
        claim("right", "x + x == 2*x", "expect = 'holds'"),
        claim("other", "x + x == 3*x", "expect = 'holds'"),
        claim("wrong", "(x + 1)^2 == x^2 + 3*x + 1", ""),
        claim("typo", "x + == 1", ""),
    ];
    fs::write(paper.join("c.toml"), claims.concat()).unwrap();
    repository
}

#[test]
fn a_workflow_is_told_of_what_deserves_a_look_at_its_line() {
    let repository = repository();
    let ran = torse_in(repository.path(), &["verify", "--format", "github"]);
    let lines: Vec<&str> = ran.out.lines().collect();
    assert_eq!(lines.len(), 3, "{}", ran.out);
    let starts = [
        "::error file=derivations/p/c.toml,line=27,col=15,endColumn=17,title=mistake::",
        "::error file=derivations/p/c.toml,line=9,col=7,title=p/other%3A unexpected::",
        "::warning file=derivations/p/c.toml,line=16,col=7,title=p/wrong%3A misprint::",
    ];
    for (line, start) in lines.iter().zip(starts) {
        assert!(line.starts_with(start), "{line}");
    }
    assert_eq!(ran.code, Some(4));
}

#[test]
fn sarif_has_the_same_findings_with_their_places() {
    let repository = repository();
    let ran = torse_in(repository.path(), &["verify", "--format", "sarif"]);
    let log: Value = serde_json::from_str(&ran.out).unwrap();
    assert_eq!(log["version"], "2.1.0");
    let results = log["runs"][0]["results"].as_array().unwrap();
    let rules: Vec<&str> = results
        .iter()
        .map(|r| r["ruleId"].as_str().unwrap())
        .collect();
    assert_eq!(rules, ["mistake", "unexpected", "misprint"]);
    let place = &results[1]["locations"][0]["physicalLocation"];
    assert_eq!(place["artifactLocation"]["uri"], "derivations/p/c.toml");
    assert_eq!(place["region"]["startLine"], 9);
    let known = log["runs"][0]["tool"]["driver"]["rules"]
        .as_array()
        .unwrap();
    assert!(
        rules
            .iter()
            .all(|rule| known.iter().any(|own| own["id"] == *rule))
    );
    // Nothing to be said is a log as well.
    let ran = torse_in(
        repository.path(),
        &["verify", "p/right", "--format", "sarif"],
    );
    let log: Value = serde_json::from_str(&ran.out).unwrap();
    let results = log["runs"][0]["results"].as_array().unwrap();
    assert!(results.iter().all(|result| result["ruleId"] == "mistake"));
}

#[test]
fn a_mistake_is_told_with_its_end_and_with_what_would_help() {
    let repository = TempDir::new().unwrap();
    let paper = repository.path().join("derivations/p");
    fs::create_dir_all(&paper).unwrap();
    let head = "[paper]\nid = 'p'\ntitle = 'T'\nauthors = 'A'\nvenue = 'V'\nclaims = ['c.toml']\n";
    fs::write(paper.join("paper.toml"), head).unwrap();
    let claim =
        "[[claim]]\nid = 'p/a'\nat = ''\nkind = 'identity'\nprinted = ''\nstates = 'xyz == 1'\n";
    fs::write(paper.join("c.toml"), claim).unwrap();
    let ran = torse_in(repository.path(), &["verify", "--format", "sarif"]);
    let log: Value = serde_json::from_str(&ran.out).unwrap();
    let result = &log["runs"][0]["results"][0];
    let region = &result["locations"][0]["physicalLocation"]["region"];
    assert_eq!(
        (&region["startColumn"], &region["endColumn"]),
        (&11.into(), &14.into())
    );
    let text = result["message"]["text"].as_str().unwrap();
    assert!(text.contains("\nhelp: "), "{text}");
    let mark = result["partialFingerprints"]["mistake/v1"]
        .as_str()
        .unwrap();
    assert!(mark.starts_with("p/c.toml: "), "{mark}");
    let driver = &log["runs"][0]["tool"]["driver"];
    let meaning = driver["rules"][0]["shortDescription"]["text"].as_str();
    assert!(meaning.unwrap().ends_with('.'), "{driver}");
    let version = torse(&["--version"]).out;
    let version = version.trim().strip_prefix("torse ");
    assert_eq!(driver["version"].as_str(), version);
    let ran = torse_in(repository.path(), &["verify", "--format", "github"]);
    assert!(ran.out.contains("%0Ahelp: "), "{}", ran.out);
}

#[test]
fn files_are_named_from_the_top_of_the_repository_wherever_the_command_runs() {
    let repository = repository();
    fs::create_dir(repository.path().join(".git")).unwrap();
    let below = repository.path().join("paper/figures");
    fs::create_dir_all(&below).unwrap();
    for folder in [&[][..], &["--derivations", "../../derivations"]] {
        let ran = torse_in(
            &below,
            &[&["verify", "--format", "github"], folder].concat(),
        );
        assert!(
            ran.out.starts_with("::error file=derivations/p/c.toml,"),
            "{}",
            ran.out
        );
    }
}

#[test]
fn the_version_names_the_commit_where_there_is_one() {
    let version = torse(&["--version"]).out;
    let own = concat!("torse ", env!("CARGO_PKG_VERSION"));
    let rest = version.trim().strip_prefix(own).unwrap();
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
    if root.join(".git").exists() {
        let commit = rest
            .strip_prefix(" (")
            .and_then(|rest| rest.strip_suffix(')'))
            .map(|commit| commit.strip_suffix("-dirty").unwrap_or(commit))
            .unwrap();
        assert!(
            commit.len() == 12 && commit.chars().all(|c| c.is_ascii_hexdigit()),
            "{version}"
        );
    }
}

/// The commands of a file, those that begin with `torse`, with the values that its inputs have where nobody sets them.
fn commands(file: &str) -> Vec<Vec<String>> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
    let text = fs::read_to_string(root.join(file)).unwrap();
    let lines = text.lines().map(str::trim);
    let lines = lines.map(|line| line.trim_start_matches("entry: "));
    let commands = lines.filter(|line| line.starts_with("torse "));
    let words = commands.map(|line| {
        let line = line
            .replace("\"$DERIVATIONS\"", "derivations")
            .replace("$NAMES", "");
        line.split_whitespace().skip(1).map(str::to_owned).collect()
    });
    words.collect()
}

#[test]
fn the_action_and_the_hook_call_the_command_as_it_is() {
    for (file, code) in [("action.yml", 4), (".pre-commit-hooks.yaml", 4)] {
        let commands = commands(file);
        assert!(!commands.is_empty(), "{file}");
        for command in commands {
            let repository = repository();
            let redirected = command.iter().position(|word| word == ">" || word == "||");
            let arguments = &command[..redirected.unwrap_or(command.len())];
            let ran = torse_in(repository.path(), arguments);
            assert_eq!(ran.code, Some(code), "{file}: {command:?}\n{}", ran.err);
            // A line that no command takes would end so.
            assert!(!ran.err.contains("Usage:"), "{file}: {}", ran.err);
        }
    }
}
