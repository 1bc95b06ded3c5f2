//! `torse decide`: one statement, and many from standard input.

use crate::support::torse;
use std::io::Write;
use std::process::{Command, Stdio};

fn decide(arguments: &[&str]) -> crate::support::Ran {
    torse(&[&["decide"], arguments].concat())
}

#[test]
fn a_statement_is_decided_without_a_folder_and_the_exit_code_is_the_answer() {
    for (arguments, code, words) in [
        (
            &["sin(x)^2 + cos(x)^2 == 1"][..],
            0,
            &["holds", "identity"][..],
        ),
        (
            &["(a + b)^2 == a^2 + b^2"],
            1,
            &["false", "fails at", "a = 1, b = 1"],
        ),
        (
            &["x <= 1", "--where", "x in [0, 1]"],
            0,
            &["holds", "x in [0, 1]"],
        ),
        (
            &[
                "sum(i, 0, n, binom(n, i)*x^i*(1 - x)^(n - i)) == 1",
                "--where",
                "n in 0..",
            ],
            0,
            &["holds", "induction", "n >= 0, an integer"],
        ),
        (
            &["H(a) >= 1", "--where", "H(t) := t^2 + 1"],
            0,
            &["holds", "H(t) = t^2 + 1"],
        ),
        (
            &["a >= 2", "--where", "a >= 3"],
            0,
            &["holds", "assuming", "a >= 3"],
        ),
        (
            &["limit(sin(x)/x, x, 0) == 1"],
            3,
            &["undecided", "`limit`", "out of scope"],
        ),
        (&["max(x, y) + min(x, y) == x + y"], 0, &["holds"]),
        (&["1/x*x == 1"], 0, &["conditional", "x != 0"]),
        (&["x == 1", "--where", "x > 1; x < 0"], 3, &["vacuous"]),
    ] {
        let ran = decide(arguments);
        assert_eq!(
            ran.code,
            Some(code),
            "{arguments:?}: {}{}",
            ran.out,
            ran.err
        );
        for word in words {
            assert!(ran.out.contains(word), "{arguments:?}: {word}\n{}", ran.out);
        }
        assert!(
            !ran.out.contains("printed"),
            "nothing is printed: {}",
            ran.out
        );
    }
}

#[test]
fn what_has_no_value_for_an_integer_of_a_short_range_holds_on_a_condition() {
    for (statement, setting, condition) in [
        ("1/x^2 > 0", "x in 0..2", "x != 0"),
        ("1/(n + 1) > 0", "n in -1..3", "n + 1 != 0"),
        (
            "1/(x^2 + y^2) > 0",
            "x in 0..2; y in 0..2",
            "x^2 + y^2 != 0",
        ),
        ("x*(x - 1)/abs(x*(x - 1)) == 1", "x in 0..3", "x - 1 != 0"),
    ] {
        let ran = decide(&[statement, "--where", setting]);
        for words in ["conditional", condition] {
            assert!(ran.out.contains(words), "{statement}: {}", ran.out);
        }
    }
    let ran = decide(&["1/x^2 > 0", "--where", "x in 1..3"]);
    assert!(ran.out.contains("holds"), "{}", ran.out);
}

#[test]
fn a_statement_may_begin_with_a_minus_sign() {
    let ran = decide(&["-x^2 <= 0"]);
    assert_eq!(ran.code, Some(0), "{}", ran.err);
    assert_eq!(decide(&["-x == x"]).code, Some(1));
}

#[test]
fn what_makes_no_sense_is_shown_with_a_caret() {
    for (arguments, words) in [
        (
            &["x =="][..],
            &["the end of the formula", "the statement:"][..],
        ),
        (&["foo(x) == 1"], &["`foo` is not declared", "^^^"]),
        (
            &["x == 1", "--where", "x in [0, 1"],
            &["is not an interval"],
        ),
        (&["x == 1", "--where", "y +"], &["the end of the formula"]),
        (
            &["dot((1, 0), [1, 0]) == 1"],
            &["a vector is written in square brackets"],
        ),
    ] {
        let ran = decide(arguments);
        assert_eq!((ran.code, ran.out.as_str()), (Some(4), ""), "{arguments:?}");
        for word in words {
            assert!(ran.err.contains(word), "{arguments:?}: {word}\n{}", ran.err);
        }
    }
}

#[test]
fn each_line_of_standard_input_gives_a_line_of_json() {
    let lines = "x + 1 > x\n\n{\"states\": \"k >= 2\", \"where\": \"k in 3..\"}\nx ==\n{\"state\": \"x\"}\nx >= y\n";
    let mut child = Command::new(env!("CARGO_BIN_EXE_torse"))
        .args(["decide", "-"])
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .spawn()
        .unwrap();
    child
        .stdin
        .take()
        .unwrap()
        .write_all(lines.as_bytes())
        .unwrap();
    let output = child.wait_with_output().unwrap();
    assert_eq!(output.status.code(), Some(4), "the gravest of all lines");
    let text = String::from_utf8(output.stdout).unwrap();
    let answers: Vec<serde_json::Value> = text
        .lines()
        .map(|line| serde_json::from_str(line).unwrap())
        .collect();
    let verdicts: Vec<Option<&str>> = answers
        .iter()
        .map(|answer| answer["verdict"].as_str())
        .collect();
    assert_eq!(
        verdicts,
        [Some("holds"), Some("holds"), None, None, Some("false")]
    );
    assert_eq!(answers[2]["line"], "x ==");
    let numbers: Vec<u64> = answers
        .iter()
        .map(|answer| answer["number"].as_u64().unwrap())
        .collect();
    assert_eq!(numbers, [1, 3, 4, 5, 6]);
    let mistake = &answers[2]["mistakes"][0];
    assert_eq!(mistake["place"]["column"], 5);
    assert!(answers[3]["mistakes"][0]["place"]["column"].is_u64());
    assert!(
        answers[3]["error"]
            .as_str()
            .unwrap()
            .contains("unknown field `state`")
    );
}

#[test]
fn json_of_one_statement_is_that_of_a_claim() {
    let ran = decide(&["x == 2*x", "--format", "json"]);
    assert_eq!(ran.code, Some(1), "{}", ran.err);
    let answer: serde_json::Value = serde_json::from_str(&ran.out).unwrap();
    assert_eq!(answer["verdict"], "false");
    assert!(answer["witness"]["at"]["x"].is_string());
}

#[test]
fn a_name_that_looks_like_another_is_named_beside_the_verdict() {
    let ran = decide(&["\u{430} == a"]);
    assert_eq!(ran.code, Some(1), "{}", ran.out);
    assert!(ran.err.contains("looks like `a`"), "{}", ran.err);
    assert_eq!(decide(&["b == a"]).err, "");
}

#[test]
fn what_is_out_of_scope_is_undecided_with_what_to_write() {
    for (statement, why) in [
        ("2^x > 0", "`exp(b*log(a))`"),
        ("x^(1/3) == x", "a square root is written `sqrt(x)`"),
        ("infinity > x", "for every finite end"),
        ("max(x, y, z) >= x", "`max(a, max(b, c))`"),
    ] {
        let ran = decide(&[statement]);
        assert_eq!(ran.code, Some(3), "{statement}: {}{}", ran.out, ran.err);
        let out = ran.out.split_whitespace().collect::<Vec<_>>().join(" ");
        assert!(out.contains(why), "{statement}: {out}");
    }
    let ran = decide(&["e^{x+y} = e^x e^y", "--latex"]);
    assert_eq!(ran.code, Some(0), "{}{}", ran.out, ran.err);
}
