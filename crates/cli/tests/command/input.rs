//! Files that the command line names: `-` for each of them, those that are missing, and values with names.

use crate::support::{Ran, claim, mini, torse, torse_fed, torse_in};
use std::fs;
use std::path::Path;
use tempfile::TempDir;

const CONE: &str = "
[curves.rim]
arc = { centre = [0, 0, 0], from = [60, 0, 0], to = [0, 60, 0] }
[patches.cone]
cone = \"rim\"
apex = [0, 0, 120]
range = [1, 0.5]
";

/// A folder with a design, and with what torse writes of it.
fn workshop() -> TempDir {
    let folder = TempDir::new().unwrap();
    fs::write(folder.path().join("cone.toml"), CONE).unwrap();
    for arguments in [
        ["export", "cone.toml", "--to", "cone.step"].as_slice(),
        &["unroll", "cone.toml", "--to", "fold.dxf", "--for", "fold"],
        &["unroll", "cone.toml", "--to", "fold.svg", "--for", "fold"],
    ] {
        ended_with(0, &torse_in(folder.path(), arguments));
    }
    folder
}

#[track_caller]
fn ended_with(code: i32, ran: &Ran) {
    assert_eq!(ran.code, Some(code), "{}{}", ran.out, ran.err);
}

/// Asserts that a command says of standard input what it says of a file, but for its name.
#[track_caller]
fn same(folder: &Path, file: &str, arguments: &[&str]) {
    let with = |name: &str| -> Vec<String> {
        let arguments = arguments.iter();
        arguments.map(|word| word.replace('@', name)).collect()
    };
    let named = torse_in(folder, &with(file));
    let words = with("-");
    let words: Vec<&str> = words.iter().map(String::as_str).collect();
    let fed = torse_fed(
        folder,
        &fs::read_to_string(folder.join(file)).unwrap(),
        &words,
    );
    let plain = |text: &str| text.replace(file, "stdin");
    assert_eq!(
        (fed.code, &fed.out),
        (named.code, &plain(&named.out)),
        "{words:?}: {}",
        fed.err
    );
    assert!(!named.out.is_empty(), "{words:?}: {}", named.err);
}

#[test]
fn a_hyphen_is_standard_input_wherever_designs_and_drawings_are_read() {
    let folder = workshop();
    // What it is, its content says: a drawing is listed, a design measured.
    same(folder.path(), "cone.step", &["inspect", "@"]);
    same(folder.path(), "fold.svg", &["inspect", "@"]);
    let measured = torse_fed(folder.path(), CONE, &["inspect", "-"]);
    ended_with(0, &measured);
    assert!(measured.out.contains("cone"), "{}", measured.out);
    same(
        folder.path(),
        "fold.dxf",
        &["fold", "cone.toml", "--pattern", "@"],
    );
    same(
        folder.path(),
        "fold.svg",
        &["fold", "cone.toml", "--pattern", "@"],
    );
    same(folder.path(), "fold.dxf", &["lint", "@"]);
    let drawn = torse_in(
        folder.path(),
        &["draw", "cone.toml", "--to", "-", "--as", "svg"],
    );
    ended_with(0, &drawn);
    assert!(drawn.out.starts_with("<svg"), "{}", &drawn.out[..40]);
    ended_with(
        2,
        &torse_in(folder.path(), &["draw", "cone.toml", "--to", "-"]),
    );
}

#[test]
fn a_hyphen_is_standard_input_wherever_derivations_are_asked_about() {
    let folder = mini(&[claim("a", "x == x", ""), claim("b", "x == 2*x", "")].concat());
    let work = TempDir::new().unwrap();
    let place = |name: &str| work.path().join(name);
    let at = ["--derivations", folder.path().to_str().unwrap()];
    let run = |name: &str, arguments: &[&str]| {
        let ran = torse_in(work.path(), &[arguments, &at].concat());
        fs::write(place(name), ran.out).unwrap();
    };
    fs::write(place("ids"), "mini/b\nmini/a\n").unwrap();
    run("list", &["list", "--format", "json"]);
    run("b.part", &["verify", "--ids", "ids"]);
    run("verdicts", &["verify", "--format", "json"]);
    same(
        work.path(),
        "ids",
        &[&["verify", "--ids", "@"], &at[..]].concat(),
    );
    same(work.path(), "b.part", &["merge", "@", "--list", "list"]);
    same(work.path(), "list", &["merge", "b.part", "--list", "@"]);
    same(
        work.path(),
        "verdicts",
        &[&["verify", "--against", "@"], &at[..]].concat(),
    );
    let since = ["verify", "--format", "json", "--changed-since", "@"];
    same(work.path(), "list", &[&since, &at[..]].concat());
    for (code, name) in [
        ("def f(x):\n    return x\n", "stdin.py:1"),
        ("pub fn f(x: f64) -> f64 { x }\n", "stdin.rs:1"),
    ] {
        let compare = ["compare", "mini/a", "--code", "-:f"];
        let ran = torse_fed(work.path(), code, &[&compare, &at[..]].concat());
        ended_with(0, &ran);
        assert!(ran.out.contains(name), "{}", ran.out);
    }
    let paper = "\\begin{document}\n\\begin{equation}x = x\\end{equation}\n\\end{document}\n";
    let new = ["new", "other", "--from", "-"];
    ended_with(0, &torse_fed(work.path(), paper, &[&new, &at[..]].concat()));
    assert!(folder.path().join("other/claims.toml").exists());
    // It is read once.
    let twice = torse_fed(work.path(), "", &["merge", "-", "--list", "-"]);
    ended_with(2, &twice);
    assert!(twice.err.contains("twice"), "{}", twice.err);
}

#[test]
fn a_file_that_is_missing_ends_with_two_whoever_names_it() {
    let folder = workshop();
    let derivations = mini(&claim("a", "x == x", ""));
    let at = ["--derivations", derivations.path().to_str().unwrap()];
    fs::write(folder.path().join("ids"), "mini/a").unwrap();
    let part = torse_in(
        folder.path(),
        &[&["verify", "--ids", "ids"], &at[..]].concat(),
    );
    fs::write(folder.path().join("a.part"), part.out).unwrap();
    for arguments in [
        ["inspect", "none.toml"].as_slice(),
        &["inspect", "none.step"],
        &["unroll", "none.toml", "--to", "x.dxf"],
        &["fold", "cone.toml", "--pattern", "none.dxf"],
        &["lint", "none.dxf"],
        &["lint", "fold.dxf", "--rules", "none.toml"],
        &["merge", "a.part", "--list", "none"],
        &["merge", "none", "--list", "none"],
        &[&["verify", "--ids", "none"], &at[..]].concat(),
        &[&["verify", "--against", "none"], &at[..]].concat(),
        &[&["compare", "mini/a", "--code", "none.py:f"], &at[..]].concat(),
        &[&["new", "other", "--from", "none.tex"], &at[..]].concat(),
        // A folder is none either.
        &["inspect", "."],
    ] {
        let ran = torse_in(folder.path(), arguments);
        assert_eq!(
            (ran.code, ran.out.as_str()),
            (Some(2), ""),
            "{arguments:?}: {}",
            ran.err
        );
        assert!(
            ran.err.contains("cannot be read"),
            "{arguments:?}: {}",
            ran.err
        );
    }
    // What is read and is no text is a wrong file.
    fs::write(folder.path().join("bytes"), [0xff, 0xfe, 0x00]).unwrap();
    let ran = torse_in(
        folder.path(),
        &[&["verify", "--against", "bytes"], &at[..]].concat(),
    );
    ended_with(4, &ran);
}

#[test]
fn of_several_designs_those_that_are_there_are_measured() {
    let folder = workshop();
    let ran = torse_in(
        folder.path(),
        &["inspect", "cone.toml", "none.toml", "--quick"],
    );
    ended_with(2, &ran);
    assert!(ran.out.contains("cone"), "{}", ran.out);
    assert!(ran.err.contains("none.toml cannot be read"), "{}", ran.err);
}

#[test]
fn two_answers_do_not_share_standard_output() {
    let folder = workshop();
    let both = [
        "unroll",
        "cone.toml",
        "--to",
        "-",
        "--as",
        "dxf",
        "--parts",
        "-",
    ];
    let ran = torse_in(folder.path(), &both);
    assert_eq!((ran.code, ran.out.as_str()), (Some(2), ""), "{}", ran.err);
    let ran = torse_in(
        folder.path(),
        &["unroll", "cone.toml", "--to", "x.dxf", "--parts", "-"],
    );
    ended_with(0, &ran);
    let mut lines = ran.out.lines();
    let columns = lines.next().unwrap().split(',').count();
    assert!(
        columns > 3 && lines.all(|line| line.split(',').count() == columns),
        "{}",
        ran.out
    );
}

#[test]
fn names_of_values_are_in_the_help_and_in_the_completions() {
    let completions = torse(&["completions", "zsh"]).out;
    for (command, values) in [
        (
            "unroll",
            &[
                "[possible values: cut, bend, sew, fold, bench, paper]",
                "[possible values: a4, a3, letter]",
            ][..],
        ),
        (
            "export",
            &["[possible values: edges", "[possible values: dxf, svg, stl"],
        ),
        ("draw", &["[possible values: png, svg, html, gif]"]),
    ] {
        let help = torse(&["help", command]).out;
        let help = help.split_whitespace().collect::<Vec<_>>().join(" ");
        for values in values {
            assert!(help.contains(values), "{command}: {values}: {help}");
        }
    }
    for words in [
        "(cut bend sew fold bench paper)",
        "(a4 a3 letter)",
        "(png svg html gif)",
    ] {
        assert!(completions.contains(words), "{words}");
    }
    let ran = torse(&["unroll", "x.toml", "--to", "x.dxf", "--for", "glue"]);
    ended_with(2, &ran);
    assert!(ran.err.contains("bench"), "{}", ran.err);
}

#[test]
fn a_grid_without_steps_is_refused_with_the_number_that_is_wrong() {
    let folder = workshop();
    let ran = torse_in(folder.path(), &["eval", "cone.toml", "--grid", "0x4"]);
    ended_with(2, &ran);
    assert!(
        ran.err.contains("= 0") || ran.err.contains(" 0 "),
        "{}",
        ran.err
    );
}

#[test]
fn what_is_declared_twice_is_told_by_its_name() {
    let declared = "[symbols]\ny = { in = '[0, 1]' }\ny = { in = '[0, 2]' }\n";
    let folder = mini(&(declared.to_owned() + &claim("a", "x == x", "")));
    let ran = torse(&["verify", "--derivations", folder.path().to_str().unwrap()]);
    ended_with(4, &ran);
    assert!(ran.err.contains("`y` is there twice"), "{}", ran.err);
}

#[test]
fn explanations_and_repeated_checks_are_lines_of_json_for_programs() {
    let folder = mini(&[claim("a", "x == x", ""), claim("b", "x == 2*x", "")].concat());
    let lines = |command: &[&str]| -> Vec<serde_json::Value> {
        let at = [
            "--format",
            "json",
            "--derivations",
            folder.path().to_str().unwrap(),
        ];
        let ran = torse(&[command, &at].concat());
        ended_with(0, &ran);
        ran.out
            .lines()
            .map(|line| serde_json::from_str(line).unwrap())
            .collect()
    };
    let explained = lines(&["explain", "mini"]);
    assert_eq!(
        (&explained[0]["id"], &explained[1]["id"]),
        (&"mini/a".into(), &"mini/b".into())
    );
    let first = &explained[1]["groups"][0][0];
    let text = first["text"].as_str().unwrap();
    assert!(
        first["label"] == "verdict" && text.starts_with("false"),
        "{first}"
    );
    let rechecked = lines(&["recheck"]);
    assert_eq!(
        (&rechecked[0]["id"], &rechecked[0]["result"]),
        (&"mini/a".into(), &"netted".into())
    );
}
