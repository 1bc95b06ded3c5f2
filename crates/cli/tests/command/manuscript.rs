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
fn the_page_about_manuscripts_mends_what_is_not_understood() {
    let block = |language: &str| {
        let rest = PAGE.split_once(&format!("```{language}\n")).unwrap().1;
        rest.split_once("```").unwrap().0
    };
    let folder = TempDir::new().unwrap();
    fs::write(folder.path().join("quadratic.tex"), block("latex")).unwrap();
    let ran = run(
        folder.path(),
        &["new", "quadratic", "--from", "quadratic.tex"],
    );
    assert_eq!(ran.code, Some(0), "{}", ran.err);
    assert!(
        ran.out
            .contains("`g`: it is a function of 2 variables that no formula defines"),
        "{}",
        ran.out
    );
    let paper = folder.path().join("derivations/quadratic/paper.toml");
    let before = fs::read_to_string(&paper).unwrap();
    assert!(!before.contains("[define]"), "{before}");
    // A table stands once, and `[display]` before what is added is no hindrance.
    fs::write(&paper, format!("{before}\n{}", block("toml"))).unwrap();
    let claims = folder.path().join("derivations/quadratic/claims.toml");
    let mut states = PAGE
        .split("`states = ")
        .skip(1)
        .map(|rest| rest.split_once('`').unwrap().0);
    let mended: String = fs::read_to_string(&claims)
        .unwrap()
        .lines()
        .map(|line| match line.starts_with("unstated") {
            true => format!("states = {}\n", states.next().unwrap()),
            false => format!("{line}\n"),
        })
        .collect();
    fs::write(&claims, mended).unwrap();
    let ran = run(folder.path(), &["verify", "quadratic", "--format", "json"]);
    assert_eq!(ran.code, Some(0), "{}\n{before}", ran.err);
    assert_eq!(
        ran.out.matches("\"verdict\": \"holds\"").count(),
        2,
        "{}",
        ran.out
    );
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
        ("eq-angle", "undecided"),
        ("eq-limit", "undecided"),
        ("thm-positive", "undecided"),
    ] {
        assert_eq!(of(id), verdict, "{id}");
    }
}

/// The manuscripts of the reader's tests, by their names.
fn manuscripts() -> Vec<(String, String)> {
    let folder = concat!(
        env!("CARGO_MANIFEST_DIR"),
        "/../manuscript/tests/manuscripts"
    );
    let mut all: Vec<(String, String)> = fs::read_dir(folder)
        .unwrap()
        .map(|entry| {
            let path = entry.unwrap().path();
            let name = path.file_stem().unwrap().to_str().unwrap().to_owned();
            (name, fs::read_to_string(&path).unwrap())
        })
        .collect();
    all.sort();
    all
}

#[test]
fn every_proposal_is_read_by_verify_to_its_end() {
    let all = manuscripts();
    assert!(all.len() >= 12);
    let folder = TempDir::new().unwrap();
    for (name, text) in &all {
        let file = format!("{name}.tex");
        fs::write(folder.path().join(&file), text).unwrap();
        let ran = run(folder.path(), &["new", name, "--from", &file]);
        assert_eq!(ran.code, Some(0), "{name}: {}", ran.err);
    }
    let ran = run(folder.path(), &["verify", "--format", "json"]);
    let proposed = || {
        let files = all
            .iter()
            .map(|(name, _)| folder.path().join(format!("derivations/{name}/paper.toml")));
        files
            .map(|file| fs::read_to_string(file).unwrap())
            .collect::<String>()
    };
    assert_eq!(ran.code, Some(0), "{}\n{}", ran.err, proposed());
    let verdicts: serde_json::Value = serde_json::from_str(&ran.out).unwrap();
    let found: Vec<(String, String)> = verdicts["claims"]
        .as_array()
        .unwrap()
        .iter()
        .map(|claim| {
            let text = |key: &str| claim[key].as_str().unwrap().to_owned();
            (text("id"), text("verdict"))
        })
        .collect();
    let of = |id: &str| {
        let claim = found.iter().find(|(own, _)| own == id);
        claim
            .unwrap_or_else(|| panic!("{id} of {found:?}"))
            .1
            .as_str()
    };
    for (id, verdict) in [
        ("strip/eq-unity", "holds"),
        ("strip/eq-middle", "misprint"),
        ("strip/eq-tangent", "misprint"),
        ("strip-cases/eq-unity", "holds"),
        ("strip-aligned/eq-unity", "holds"),
        ("strip-inline/eq-unity", "holds"),
        ("bernstein-slips/eq-3", "false"),
        ("bernstein-slips/eq-5", "misprint"),
        ("elsarticle/eq-3", "holds"),
        ("conversion/eq-1", "holds"),
    ] {
        assert_eq!(of(id), verdict, "{id}");
    }
}

#[test]
fn a_theorem_in_two_parts_of_which_one_has_a_slip_gets_its_correction() {
    let folder = TempDir::new().unwrap();
    let text = r"\begin{document} Let $t\in[0,1]$, and $f(t) = t^2(3-2t)$. \begin{theorem}\label{ends} We have
        \[ f(1-t) = 1 - f(t) \quad\text{and}\quad f'(t) = 6t(1+t). \] \end{theorem} \end{document}";
    fs::write(folder.path().join("ends.tex"), text).unwrap();
    let ran = run(folder.path(), &["new", "ends", "--from", "ends.tex"]);
    assert_eq!(ran.code, Some(0), "{}", ran.err);
    let ran = run(folder.path(), &["verify", "ends"]);
    assert_eq!(ran.code, Some(0), "{}", ran.err);
    assert!(
        ran.out.contains("1 of 1 statement is still to be stated"),
        "{}",
        ran.out
    );
    let file = folder.path().join("derivations/ends/claims.toml");
    let claims = fs::read_to_string(&file).unwrap();
    let proposed = claims
        .lines()
        .find_map(|line| line.strip_prefix("# states = "))
        .unwrap();
    let stated: String = claims
        .lines()
        .map(|line| match line.starts_with("unstated") {
            true => format!("states = {proposed}\n"),
            false => format!("{line}\n"),
        })
        .collect();
    fs::write(&file, stated).unwrap();
    let ran = run(folder.path(), &["explain", "ends"]);
    assert!(
        ran.out.contains("misprint") && ran.out.contains("6*t*(1 - t)"),
        "{}{}",
        ran.out,
        ran.err
    );
}

#[test]
fn a_statement_in_latex_takes_indices_for_integers_and_its_setting_in_latex() {
    let ran = torse(&[
        "decide",
        "--latex",
        r"\sum_{i=0}^{n}\binom{n}{i} t^i (1-t)^{n-i} = 1",
    ]);
    assert_eq!(ran.code, Some(0), "{}", ran.err);
    assert!(ran.out.contains("n >= 0, an integer"), "{}", ran.out);
    let ran = torse(&[
        "decide",
        "--latex",
        r"\alpha^2 \le 4",
        "--where",
        r"\alpha\in[-2,1]",
    ]);
    assert_eq!(ran.code, Some(0), "{}{}", ran.out, ran.err);
    assert!(ran.out.contains("alpha in [-2, 1]"), "{}", ran.out);
    let ran = torse(&[
        "decide",
        "--latex",
        r"B_i^n(t) = B_{n-i}^n(1-t)",
        "--where",
        r"B_i^n(t) := \binom{n}{i} t^i (1-t)^{n-i}; n in 0..; i in 0..n",
    ]);
    assert_ne!(ran.code, Some(4), "{}{}", ran.out, ran.err);
}

#[test]
fn what_is_wrong_in_a_statement_says_what_to_add() {
    for (statement, hint) in [
        ("sum(i, 0, n, i) == n*(n + 1)/2", "--where \"n in 0..\""),
        ("binom(m, 2) >= 0", "--where \"m in 0..\""),
        ("binomial(4, 2) == 6", "`binom(n, j)`"),
        ("2ab == 1", "`2*a*b`"),
        ("2t(1-t) >= 0", "`2*t*(...)`"),
        ("det(a, b, c) == 0", "det([a, b, c])"),
        ("B(i, n, t) == 0", "--where \"B(i, t) := ...\""),
    ] {
        let ran = torse(&["decide", statement]);
        assert_eq!(ran.code, Some(4), "{statement}: {}", ran.out);
        let shown = ran.err.split_whitespace().collect::<Vec<_>>().join(" ");
        assert!(shown.contains(hint), "{statement}: {}", ran.err);
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
    assert_eq!(ran.code, Some(2), "{}", ran.out);
}
