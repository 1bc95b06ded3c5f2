//! `torse audit`.

use crate::support::{Ran, claim, mini, on};

/// A claim about `x` with its print; further fields.
fn printed(name: &str, print: &str, states: &str, fields: &str) -> String {
    claim(name, states, fields).replace("as printed", print)
}

fn audit(claims: &str, more: &[&str]) -> Ran {
    // A number of any value needs no source.
    let folder = mini(&format!("[symbols]\nx = {{}}\n{claims}"));
    on(folder.path(), &[&["audit"], more].concat())
}

/// A statement with a number that its print has not.
const ADDS: (&str, &str) = (
    "x times x is never negative",
    "(x + 7)^2 == x^2 + 14*x + 49",
);

#[test]
fn a_statement_that_is_its_print_has_no_flag_and_the_exit_code_is_0() {
    let claims = printed(
        "1",
        "(x + 3)^2 = x^2 + 6x + 9",
        "(x + 3)^2 == x^2 + 6*x + 9",
        "",
    );
    let ran = audit(&claims, &[]);
    assert_eq!(ran.code, Some(0), "{}{}", ran.out, ran.err);
    assert!(ran.out.contains("claims: 1; flags: 0 open"), "{}", ran.out);
}

#[test]
fn an_open_flag_is_shown_and_the_exit_code_is_1() {
    let ran = audit(&printed("1", ADDS.0, ADDS.1, ""), &[]);
    assert_eq!(ran.code, Some(1), "{}{}", ran.out, ran.err);
    assert!(
        ran.out.contains("adds-number") && ran.out.contains("7, 14, 49"),
        "{}",
        ran.out
    );
}

#[test]
fn an_answer_by_a_quote_closes_its_flag_and_equal_answers_are_one_class() {
    let answer = "answers = [{ flag = 'adds-number', quote = 'x times x', in = 'mini/1', says = 'an example' }]";
    let claims = ["1", "2"]
        .map(|name| printed(name, ADDS.0, ADDS.1, answer))
        .concat();
    let ran = audit(&claims, &[]);
    assert_eq!(ran.code, Some(0), "{}{}", ran.out, ran.err);
    assert!(ran.out.contains("2 answered in 1 classes"), "{}", ran.out);
    let json = audit(&claims, &["--format", "json"]);
    let found: serde_json::Value = serde_json::from_str(&json.out).unwrap();
    assert_eq!(found["open"], serde_json::json!([]));
    assert_eq!(
        found["answered"][0]["claims"],
        serde_json::json!(["mini/1", "mini/2"])
    );
}

#[test]
fn an_answer_to_no_flag_is_an_error_at_its_place() {
    let answer = "answers = [{ flag = 'adds-number', quote = 'x^2' }]";
    let claims = printed(
        "1",
        "(x + 3)^2 = x^2 + 6x + 9",
        "(x + 3)^2 == x^2 + 6*x + 9",
        answer,
    );
    let ran = audit(&claims, &[]);
    assert_eq!(ran.code, Some(4), "{}{}", ran.out, ran.err);
    assert!(
        ran.err.contains("nothing is flagged as `adds-number`")
            && ran.err.contains("mini/claims.toml:"),
        "{}",
        ran.err
    );
}

#[test]
fn a_quote_that_is_not_printed_is_no_answer() {
    let answer = "answers = [{ flag = 'adds-number', quote = 'seven' }]";
    let ran = audit(&printed("1", ADDS.0, ADDS.1, answer), &[]);
    assert_eq!(ran.code, Some(4), "{}{}", ran.out, ran.err);
}

#[test]
fn what_a_used_claim_prints_is_no_addition() {
    let uses = printed("1", ADDS.0, ADDS.1, "uses = ['mini/2']");
    let used = printed("2", "(x + 7)^2 = x^2 + 14x + 49", ADDS.1, "");
    let ran = audit(&[uses, used].concat(), &[]);
    assert_eq!(ran.code, Some(0), "{}{}", ran.out, ran.err);
}
