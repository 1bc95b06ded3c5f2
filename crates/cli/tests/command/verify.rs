//! `torse verify`: names, exit codes, texts and JSON.

use crate::support::{Ran, claim, copy_of_repository, mini, on, repository, torse};
use serde_json::Value;
use std::fs;

const TRUE: &str = "(x + 1)^2 == x^2 + 2*x + 1";
const WRONG: &str = "(x + 1)^2 == x^2 + 3*x + 1";
/// More than the engine undertakes: the same on both sides, and still not decided.
const TOO_MUCH: &str = "(x + 1)^1000 == (x + 1)^1000";

fn verdict(ran: &Ran, id: &str) -> String {
    let all: Value = serde_json::from_str(&ran.out).unwrap();
    let claims = all["claims"].as_array().unwrap();
    let claim = claims.iter().find(|claim| claim["id"] == id).unwrap();
    claim["verdict"].as_str().unwrap().to_owned()
}

#[test]
fn a_refuted_claim_is_no_failure_unless_another_verdict_is_expected() {
    let folder = mini(&[claim("right", TRUE, ""), claim("wrong", WRONG, "")].concat());
    let ran = on(folder.path(), &["verify"]);
    assert_eq!(ran.code, Some(0), "{}", ran.err);
    let folder = mini(&claim("wrong", WRONG, "expect = \"holds\""));
    let ran = on(folder.path(), &["verify"]);
    assert_eq!(ran.code, Some(1));
    assert!(
        ran.out.contains("1 verdict is not the expected one"),
        "{}",
        ran.out
    );
    assert!(ran.out.contains("expected holds"), "{}", ran.out);
}

#[test]
fn an_undecided_claim_is_a_failure_only_when_named_by_its_id() {
    let folder = mini(&[claim("open", TOO_MUCH, ""), claim("right", TRUE, "")].concat());
    let verdicts = on(folder.path(), &["verify", "--format", "json"]);
    assert_eq!(verdict(&verdicts, "mini/open"), "undecided");
    assert_eq!(verdicts.code, Some(0));
    assert_eq!(on(folder.path(), &["verify", "mini"]).code, Some(0));
    assert_eq!(on(folder.path(), &["verify", "mini/right"]).code, Some(0));
    assert_eq!(
        on(folder.path(), &["verify", "mini/right", "mini/open"]).code,
        Some(3)
    );
}

#[test]
fn a_sentence_that_is_out_of_scope_leaves_the_other_sentences_of_its_paper_decided() {
    let limit = claim("limit", "limit(sin(x)/x, x, 0) == 1", "");
    let integer = claim("integer", "x >= 0 implies floor(x) <= x", "");
    let folder = mini(&[limit, integer, claim("right", TRUE, "")].concat());
    let verdicts = on(folder.path(), &["verify", "--format", "json"]);
    assert_eq!(verdicts.code, Some(0), "{}", verdicts.err);
    assert_eq!(verdict(&verdicts, "mini/limit"), "undecided");
    assert_eq!(verdict(&verdicts, "mini/integer"), "undecided");
    assert_eq!(verdict(&verdicts, "mini/right"), "holds");
    let explained = on(folder.path(), &["explain", "mini/limit"]);
    assert!(
        explained.out.contains("limits are out of scope"),
        "{}",
        explained.out
    );
    // Powers that are no products, ends without a bound, more than two numbers: of each sentence the reason, of the paper the verdicts.
    let beyond = [
        ("x^(1/3)*x^(2/3) == x", "a square root is written `sqrt(x)`"),
        ("x >= 1 implies 2^x > 0", "`exp(b*log(a))`"),
        ("pw(x, x) == 1", "`exp(b*log(a))`"),
        ("integral(1/x^2, x, 1, inf) == 1", "for every finite end"),
        (
            "asinh(x) == log(x + sqrt(x^2 + 1))",
            "`log(x + sqrt(x^2 + 1))`",
        ),
        ("max(x, 0, 1) >= x", "`max(a, max(b, c))`"),
    ];
    let define = "let = { 'pw(a, b)' = 'a^b' }";
    let claims: Vec<String> = (beyond.iter().enumerate())
        .map(|(at, (states, _))| claim(&format!("c{at}"), states, define))
        .collect();
    let folder = mini(&[claims.concat(), claim("right", TRUE, "")].concat());
    let verdicts = on(folder.path(), &["verify", "--format", "json"]);
    assert_eq!(verdicts.code, Some(0), "{}", verdicts.err);
    assert_eq!(verdict(&verdicts, "mini/right"), "holds");
    for (at, (states, why)) in beyond.iter().enumerate() {
        let id = format!("mini/c{at}");
        assert_eq!(verdict(&verdicts, &id), "undecided", "{states}");
        let explained = on(folder.path(), &["explain", &id]);
        let out = explained
            .out
            .split_whitespace()
            .collect::<Vec<_>>()
            .join(" ");
        assert!(out.contains(why), "{states}: {out}");
    }
    // A name that nobody knows is a mistake of the file as before.
    let folder = mini(&claim("typo", "limits(x) == 1", ""));
    assert_eq!(on(folder.path(), &["verify"]).code, Some(4));
}

#[test]
fn a_verdict_other_than_expected_weighs_more_than_an_undecided_one() {
    let expecting = claim("wrong", WRONG, "expect = \"holds\"");
    let folder = mini(&[claim("open", TOO_MUCH, ""), expecting].concat());
    assert_eq!(
        on(folder.path(), &["verify", "mini/open", "mini/wrong"]).code,
        Some(1)
    );
}

#[test]
fn an_unknown_name_is_a_usage_error_with_the_nearest_known_one() {
    let folder = mini(&claim("eq-2.1", TRUE, ""));
    let ran = on(folder.path(), &["verify", "mini/eq-21"]);
    assert_eq!(ran.code, Some(2));
    assert!(
        ran.err.contains("did you mean `mini/eq-2.1`?"),
        "{}",
        ran.err
    );
    let ran = on(folder.path(), &["verify", "quite-another-thing"]);
    assert_eq!(ran.code, Some(2));
    assert!(ran.err.contains("the papers are mini"), "{}", ran.err);
    assert_eq!(ran.out, "");
}

#[test]
fn a_paper_whose_claims_all_have_mistakes_is_known_by_its_name() {
    let folder =
        mini("[[claim]]\nid = 'mini/a'\nkind = 'identity'\nprinted = ''\nstates = 'x = x'\n");
    for command in ["verify", "list", "audit"] {
        let ran = on(folder.path(), &[command, "mini"]);
        assert_eq!(ran.code, Some(4), "{command}: {}", ran.err);
        assert!(ran.err.contains("missing field `at`"), "{}", ran.err);
    }
}

#[test]
fn a_command_line_that_cannot_be_followed_is_a_usage_error() {
    for wrong in [
        &["verify", "--format", "xml"][..],
        &["prove"],
        &["verify"],
        &[],
    ] {
        let ran = torse(wrong);
        assert_eq!((ran.code, ran.out.as_str()), (Some(2), ""), "{wrong:?}");
        assert!(!ran.err.is_empty());
    }
    assert_eq!(
        torse(&["verify", "--derivations", "no-such-folder"]).code,
        Some(2)
    );
}

#[test]
fn the_beginning_of_an_id_means_all_ids_that_continue_it_after_a_word() {
    let names = ["eq-1", "eq-1.a", "eq-1.b", "eq-10"];
    let folder = mini(&names.map(|name| claim(name, TRUE, "")).concat());
    let ran = on(folder.path(), &["verify", "mini/eq-1", "--format", "json"]);
    let all: Value = serde_json::from_str(&ran.out).unwrap();
    let ids: Vec<&str> = all["claims"]
        .as_array()
        .unwrap()
        .iter()
        .map(|c| c["id"].as_str().unwrap())
        .collect();
    assert_eq!(ids, ["mini/eq-1", "mini/eq-1.a", "mini/eq-1.b"]);
}

#[test]
fn the_text_is_plain_where_no_terminal_is_and_no_wider_than_100_columns() {
    let wide = claim(
        "wide",
        "sum(i, 0, 3, (i + x)^9) == 0",
        "note = \"a remark\"",
    );
    let folder = mini(&[wide, claim("right", TRUE, "")].concat());
    let ran = on(folder.path(), &["verify"]);
    assert!(!ran.out.contains('\u{1b}'));
    for line in ran.out.lines() {
        assert!(line.chars().count() <= 100, "{line}");
        assert_eq!(line.trim_end(), line);
    }
    assert!(ran.out.contains("2 claims"), "{}", ran.out);
    assert!(ran.out.contains(" at x = 1, and not 0."), "{}", ran.out);
}

#[test]
fn a_run_over_the_time_limit_is_ended_without_verdicts_and_names_the_claim() {
    // Half a minute and more: a form of four variables of which no sign is found, many times.
    let form = "(x + y + z + w)^24 - (x - y + z - w)^24 + (x*y - z*w)^11 > -1/10^12";
    let inside = ["y", "z", "w"].map(|name| format!("{name} = {{ in = \"[0, 1]\" }}"));
    let symbols = format!("symbols = {{ {} }}", inside.join(", "));
    let slow = (0..80).map(|n| claim(&format!("slow-{n}"), form, &symbols));
    let folder = mini(&(slow.collect::<String>() + &claim("right", TRUE, "")));
    let patient = ["verify", "--time-limit", "1", "--budget", "1000000000"];
    let ran = on(folder.path(), &patient);
    assert_eq!((ran.code, ran.out.as_str()), (Some(8), ""), "{}", ran.err);
    assert!(ran.err.contains("being decided: mini/slow-"), "{}", ran.err);
    assert_eq!(
        on(folder.path(), &["verify", "--time-limit", "0"]).code,
        Some(2)
    );
}

#[test]
fn timings_go_to_standard_error_and_leave_the_output_as_it_is() {
    let folder = mini(&claim("right", TRUE, ""));
    let plain = on(folder.path(), &["verify"]);
    let timed = on(folder.path(), &["verify", "--timings"]);
    assert_eq!((plain.out, plain.err.as_str()), (timed.out, ""));
    assert!(timed.err.contains("mini/right"));
}

#[test]
fn the_json_has_the_fields_of_the_interface_and_the_same_bytes_twice() {
    let names = [
        "gbt-developable/eq-3.11",
        "gbt-surfaces/eq-33",
        "hermite-developable/eq-3",
    ];
    let run = || {
        on(
            &repository(),
            &[&["verify", "--format", "json"], &names[..]].concat(),
        )
    };
    let (first, second) = (run(), run());
    assert_eq!(first.out, second.out);
    assert_eq!(first.code, Some(0), "{}", first.err);
    let all: Value = serde_json::from_str(&first.out).unwrap();
    let claims = all["claims"].as_array().unwrap();
    let ids: Vec<&str> = claims
        .iter()
        .map(|claim| claim["id"].as_str().unwrap())
        .collect();
    for name in names {
        assert!(ids.iter().any(|id| id.starts_with(name)), "{name}");
    }
    let mut by_paper = ids.clone();
    by_paper.sort_by_key(|id| id.split_once('/').unwrap().0);
    assert_eq!(
        ids, by_paper,
        "papers in the order of their names, claims in that of the files"
    );
    for claim in claims {
        let claim = claim.as_object().unwrap();
        assert_eq!(claim.len(), 24);
        assert!(claim["contradiction"].is_null(), "{claim:?}");
        assert!(claim["verdict"].is_string() && claim["printed"].is_string());
        assert!(claim["witness"].is_object() || claim["witness"].is_null());
        // What is refuted comes with a point at which it fails.
        assert!(
            claim["verdict"] != "false" || claim["witness"].is_object(),
            "{claim:?}"
        );
    }
    assert!(claims.iter().any(|claim| claim["witness"].is_object()));
}

#[test]
fn flipping_one_coefficient_of_a_true_claim_flips_its_verdict() {
    for (id, file, from, to) in [
        (
            "hermite-developable/eq-2.1b.H2",
            "hermite-developable/curves.toml",
            "3*u^2",
            "4*u^2",
        ),
        (
            "gbt-developable/eq-3.11.b",
            "gbt-developable/end-points.toml",
            "1/2*",
            "1/3*",
        ),
    ] {
        let copy = copy_of_repository();
        let verify = || on(copy.path(), &["verify", id, "--format", "json"]);
        assert_eq!(verdict(&verify(), id), "holds");
        let path = copy.path().join(file);
        let text = fs::read_to_string(&path).unwrap();
        let claim = text.find(&format!("id = \"{id}\"")).unwrap();
        let states = claim + text[claim..].find("\nstates =").unwrap() + 1;
        let printed = states + text[states..].find(from).unwrap();
        let line_ends = states + text[states..].find('\n').unwrap();
        assert!(printed < line_ends, "{id} has no `{from}`");
        let flipped = [&text[..printed], to, &text[printed + from.len()..]].concat();
        // What the file expects is still what was true before.
        fs::write(&path, flipped).unwrap();
        let after = verdict(&verify(), id);
        assert!(after == "false" || after == "misprint", "{id}: {after}");
    }
}

#[test]
fn what_differs_from_an_earlier_run_is_told_and_fails() {
    let folder = mini(&[claim("right", TRUE, ""), claim("gone", TRUE, "")].concat());
    let before = folder.path().join("before.json");
    fs::write(
        &before,
        on(folder.path(), &["verify", "--format", "json"]).out,
    )
    .unwrap();
    let against = |folder: &std::path::Path, names: &[&str]| {
        let command = [&["verify", "--against", before.to_str().unwrap()], names].concat();
        on(folder, &command)
    };
    let same = against(folder.path(), &[]);
    assert_eq!(
        (same.code, same.out.as_str()),
        (Some(0), "no verdict, evidence or condition differs\n")
    );

    let divided = "x/x == 1";
    let changed = mini(&[claim("right", divided, ""), claim("new", TRUE, "")].concat());
    let ran = against(changed.path(), &[]);
    assert_eq!(ran.code, Some(1));
    let row = |id: &str| {
        ran.out
            .lines()
            .find(|line| line.contains(id))
            .unwrap()
            .to_owned()
    };
    for (id, was, is) in [
        (
            "mini/right",
            "holds (identity)",
            "conditional (identity), if x != 0",
        ),
        ("mini/gone", "holds (identity)", "- (gone)"),
        ("mini/new", "- (new)", "holds (identity)"),
    ] {
        assert!(row(id).contains(was) && row(id).contains(is), "{}", ran.out);
    }
    let one = against(changed.path(), &["mini/new"]);
    assert_eq!(one.code, Some(1));
    assert!(!one.out.contains("mini/gone"), "{}", one.out);

    fs::write(&before, "{}").unwrap();
    let none = against(folder.path(), &[]);
    assert_eq!(none.code, Some(4));
    assert!(none.err.contains("holds no verdicts"), "{}", none.err);
}

#[test]
fn proofs_are_written_whole_and_with_the_same_bytes_each_time() {
    let claims = [claim("right", TRUE, ""), claim("wrong", WRONG, "")];
    let (folder, out) = (mini(&claims.concat()), tempfile::tempdir().unwrap());
    let written = |name: &str| {
        let to = out.path().join(name);
        let ran = on(folder.path(), &["verify", "--proofs", to.to_str().unwrap()]);
        assert_eq!(ran.code, Some(0), "{}", ran.err);
        let files: Vec<_> = fs::read_dir(&to)
            .unwrap()
            .map(|e| e.unwrap().path())
            .collect();
        assert_eq!(files, [to.join("mini.json")]);
        fs::read_to_string(to.join("mini.json")).unwrap()
    };
    let text = written("one");
    assert_eq!(text, written("two"));
    let all: Value = serde_json::from_str(&text).unwrap();
    let claims = all["claims"].as_array().unwrap();
    let right = &claims[0];
    assert_eq!(right["id"], "mini/right");
    assert_eq!(right["replayed"], true);
    let by = &right["rests_on"]["proof"]["of"]["on"]["proof"]["identity"]["by"];
    assert_eq!(by, "normal-form");
    let point = &claims[1]["rests_on"]["refutation"]["at"]["at"][0];
    assert_eq!(point["symbol"], "x");
    // A folder that cannot be one.
    let occupied = out.path().join("one/mini.json");
    let ran = on(
        folder.path(),
        &["verify", "--proofs", occupied.to_str().unwrap()],
    );
    assert_eq!(ran.code, Some(5), "{}", ran.err);
    assert_eq!(fs::read_to_string(&occupied).unwrap(), text);
}

#[test]
fn the_remarks_that_hold_are_counted_and_those_that_hold_under_a_condition() {
    let remark =
        |name: &str, states: &str| claim(name, states, "").replace("\"identity\"", "\"remark\"");
    let one = mini(&remark("a", "x == x"));
    let three = mini(
        &[
            remark("a", "x == x"),
            remark("b", "x/x == 1"),
            remark("c", "x == 1"),
        ]
        .concat(),
    );
    for (folder, says) in [
        (one, "not counted: 1 remark of ours; 1 of them holds\n"),
        (
            three,
            "not counted: 3 remarks of ours; 2 of them hold, 1 under a condition\n",
        ),
    ] {
        let ran = on(folder.path(), &["verify"]);
        assert!(ran.out.contains(says), "{}", ran.out);
    }
}
