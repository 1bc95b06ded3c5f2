//! From a manuscript in LaTeX to verdicts and a letter: the page of that name, step by step.

use crate::support::{Ran, torse, torse_in};
use std::fs;
use std::path::Path;
use tempfile::TempDir;

const MANUSCRIPT: &str = include_str!("../manuscript/blended.tex");
const PAGE: &str = include_str!("../../../../docs/manuscript.md");

/// The commands of the page with what it shows of their output.
fn steps() -> Vec<(Vec<&'static str>, &'static str)> {
    let blocks = PAGE.split("```text\n").skip(1);
    let steps = blocks.map(|block| {
        let (block, _) = block.split_once("```").unwrap();
        let (command, shown) = block.split_once('\n').unwrap();
        let words = command.strip_prefix("$ torse ").unwrap();
        (words.split(' ').collect(), shown)
    });
    steps.collect()
}

fn run(folder: &Path, words: &[&str]) -> Ran {
    torse_in(folder, words)
}

#[test]
fn the_page_about_manuscripts_shows_what_the_commands_print() {
    let folder = TempDir::new().unwrap();
    fs::write(folder.path().join("blended.tex"), MANUSCRIPT).unwrap();
    let steps = steps();
    assert!(steps.len() >= 3, "{steps:?}");
    for (words, shown) in steps {
        let ran = run(folder.path(), &words);
        assert_eq!(ran.code, Some(0), "{words:?}: {}\n{}", ran.out, ran.err);
        let mut rest = ran.out.as_str();
        for part in shown.split("...\n") {
            let at = rest.find(part);
            assert!(
                at.is_some(),
                "{words:?} does not print\n{part}\nbut\n{}",
                ran.out
            );
            rest = &rest[at.unwrap() + part.len()..];
        }
    }
}

#[test]
fn three_wrong_formulas_of_a_manuscript_are_found_and_the_right_ones_hold() {
    let folder = TempDir::new().unwrap();
    fs::write(folder.path().join("blended.tex"), MANUSCRIPT).unwrap();
    let ran = run(folder.path(), &["new", "blended", "--from", "blended.tex"]);
    assert_eq!(ran.code, Some(0), "{}", ran.err);
    let ran = run(folder.path(), &["verify", "blended", "--format", "json"]);
    assert_eq!(ran.code, Some(0), "{}\n{}", ran.out, ran.err);
    let verdicts: serde_json::Value = serde_json::from_str(&ran.out).unwrap();
    let of = |id: &str| {
        let claims = verdicts["claims"].as_array().unwrap();
        let claim = claims
            .iter()
            .find(|claim| claim["id"] == format!("blended/{id}"))
            .unwrap();
        claim["verdict"].as_str().unwrap().to_owned()
    };
    for (id, verdict) in [
        ("eq-b0", "definition"),
        ("eq-unity", "holds"),
        ("eq-middle", "misprint"),
        ("eq-ends", "holds"),
        ("eq-bound", "holds"),
        ("eq-curve", "definition"),
        ("eq-first", "misprint"),
        ("eq-last", "holds"),
        ("eq-point", "misprint"),
        ("eq-angle", "out-of-scope"),
        ("eq-limit", "out-of-scope"),
        ("thm-positive", "out-of-scope"),
    ] {
        assert_eq!(of(id), verdict, "{id}");
    }
}

#[test]
fn a_statement_in_latex_is_decided_and_one_with_two_readings_is_not() {
    let ran = torse(&["decide", "--latex", r"\sin^2 x + \cos^2 x = 1"]);
    assert_eq!(
        (ran.code, ran.out.contains("holds")),
        (Some(0), true),
        "{}",
        ran.err
    );
    let ran = torse(&["decide", "--latex", r"(a+b)^2 = a^2+b^2"]);
    assert_eq!(ran.code, Some(1), "{}", ran.err);
    let ran = torse(&[
        "decide",
        "--latex",
        r"|\mathbf a\times\mathbf b|^2 = |\mathbf a|^2|\mathbf b|^2 - (\mathbf a\cdot\mathbf b)^2",
    ]);
    assert_eq!(ran.code, Some(0), "{}", ran.err);
    let ran = torse(&["decide", "--latex", r"\frac{x}{2} = 1/2x"]);
    assert_eq!(ran.code, Some(4), "{}", ran.out);
    assert!(
        ran.err.contains("1/2*x") && ran.err.contains("1/(2*x)"),
        "{}",
        ran.err
    );
    let ran = torse(&[
        "decide",
        "--latex",
        r"x^2 \ge 0, \quad x \in [0, 1]",
        "--format",
        "json",
    ]);
    assert_eq!(ran.code, Some(0), "{}", ran.err);
}

#[test]
fn a_claim_may_be_stated_in_latex_and_its_mistakes_have_their_place() {
    let folder = TempDir::new().unwrap();
    let paper = folder.path().join("derivations/mine");
    fs::create_dir_all(&paper).unwrap();
    let head = "[paper]\nid = \"mine\"\ntitle = \"\"\nauthors = \"\"\nvenue = \"\"\nclaims = [\"claims.toml\"]\n[symbols]\nx = {}\n";
    fs::write(paper.join("paper.toml"), head).unwrap();
    let claim = |latex: &str| {
        format!(
            "[[claim]]\nid = \"mine/one\"\nat = \"1\"\nkind = \"identity\"\nprinted = \"\"\nlatex = '{latex}'\n"
        )
    };
    fs::write(paper.join("claims.toml"), claim(r"\cos 2x = 1 - 2\sin^2 x")).unwrap();
    let ran = torse_in(folder.path(), &["explain", "mine/one"]);
    assert!(
        ran.out.contains("holds") && ran.out.contains("cos(2*x) == 1 - 2*sin(x)^2"),
        "{}{}",
        ran.out,
        ran.err
    );
    fs::write(paper.join("claims.toml"), claim(r"\cos 2x = 1 - 2\sin^2 y")).unwrap();
    let ran = torse_in(folder.path(), &["verify", "mine"]);
    assert_eq!(ran.code, Some(4), "{}", ran.out);
    assert!(
        ran.err.contains("`y` is not declared") && ran.err.contains("claims.toml:6:"),
        "{}",
        ran.err
    );
    fs::write(paper.join("claims.toml"), claim("x/2 = 1/2x")).unwrap();
    let ran = torse_in(folder.path(), &["verify", "mine"]);
    assert_eq!(ran.code, Some(4), "{}", ran.out);
    assert!(ran.err.contains("two ways"), "{}", ran.err);
    fs::write(
        paper.join("claims.toml"),
        format!("{}states = 'x == x'\n", claim("x = x")),
    )
    .unwrap();
    let ran = torse_in(folder.path(), &["verify", "mine"]);
    assert_eq!(ran.code, Some(4), "{}", ran.out);
}

#[test]
fn a_manuscript_whose_macros_have_no_end_is_an_error_with_its_line() {
    let folder = TempDir::new().unwrap();
    fs::write(
        folder.path().join("loop.tex"),
        "\\newcommand{\\a}{\\a\\a}\n\nText $\\a$.\n",
    )
    .unwrap();
    let ran = run(folder.path(), &["new", "loop", "--from", "loop.tex"]);
    assert_eq!(ran.code, Some(4), "{}", ran.out);
    assert!(
        ran.err.contains("line 3") && ran.err.contains("`\\a`"),
        "{}",
        ran.err
    );
    assert!(!folder.path().join("derivations").exists());
    let ran = run(folder.path(), &["new", "loop", "--from", "none.tex"]);
    assert_eq!(ran.code, Some(4), "{}", ran.out);
}
