//! Wrong and hostile derivation files: each ends soon, with a message that shows the place.

use crate::support::{Ran, claim, mini, on};

/// Asserts that a file of claims is refused with a message, a place in the file, and a caret there.
fn refused(claims: &str, message: &str, line: usize) -> Ran {
    let folder = mini(claims);
    let ran = on(folder.path(), &["verify"]);
    assert_eq!(ran.code, Some(4), "{}", ran.err);
    assert!(ran.err.contains(message), "{}", ran.err);
    assert!(
        ran.err.contains(&format!("mini/claims.toml:{line}:")),
        "{}",
        ran.err
    );
    assert!(ran.err.contains('^'), "{}", ran.err);
    ran
}

/// The column at which the caret of a message begins, counted from 0 within the line of the file.
fn caret(ran: &Ran) -> usize {
    let lines: Vec<&str> = ran.err.lines().collect();
    let position = lines.iter().position(|line| line.contains('^')).unwrap();
    let column = |line: &str, of: char| line.chars().position(|c| c == of).unwrap();
    column(lines[position], '^') - column(lines[position - 1], '│') - 2
}

#[test]
fn an_unknown_name_is_shown_at_its_place() {
    let ran = refused(&claim("a", "x + why == 0", ""), "why", 6);
    assert_eq!(caret(&ran), "states = 'x + ".len());
}

#[test]
fn an_unbalanced_bracket_is_shown_at_its_place() {
    refused(&claim("a", "(x + 1 == 2", ""), "", 6);
    let ran = refused(&claim("a", "x + 1) == 2", ""), "", 6);
    assert_eq!(caret(&ran), "states = 'x + 1".len());
}

#[test]
fn an_index_outside_its_family_is_shown_at_its_place() {
    let ran = refused(&claim("a", "P[0] == P[4]", ""), "4", 6);
    assert!(caret(&ran) >= "states = 'P[0] == ".len(), "{}", ran.err);
}

#[test]
fn a_missing_field_is_named() {
    refused(
        "[[claim]]\nid = \"mini/a\"\nat = \"Sect. 1\"\nkind = \"identity\"\nstates = 'x == x'\n",
        "printed",
        1,
    );
}

#[test]
fn a_claim_that_states_nothing_is_shown_with_what_would_help() {
    let silent =
        "[[claim]]\nid = \"mini/a\"\nat = \"Sect. 1\"\nkind = \"identity\"\nprinted = \"x\"\n";
    let ran = refused(silent, "states nothing", 2);
    assert!(ran.err.contains("add `states"), "{}", ran.err);
}

#[test]
fn an_unknown_field_a_repeated_id_and_broken_toml_are_refused() {
    refused(&claim("a", "x == x", "asume = [\"x > 0\"]"), "asume", 7);
    let twice = [claim("a", "x == x", ""), claim("a", "x == 1", "")].concat();
    refused(&twice, "used twice", 9);
    refused(&claim("a", "x == x", "note = \"open"), "", 7);
}

#[test]
fn all_mistakes_are_shown_at_once_and_the_rest_is_decided() {
    let claims = [
        claim("syntax", "x = 1", ""),
        claim("name", "x + why == 0", ""),
        claim("right", "x == x", ""),
        claim("kind", "P[0] + 1 == 0", ""),
        claim("range", "y == y", "symbols = { y = { in = \"[0 1]\" } }"),
        claim("end", "y <= 1", "symbols = { y = { in = \"[0, why]\" } }"),
        claim("half", "y <= 1", "symbols = { y = { in = \"[0, 2*]\" } }"),
    ];
    let folder = mini(&claims.concat());
    let ran = on(folder.path(), &["verify", "--format", "json"]);
    assert_eq!(ran.code, Some(4), "{}", ran.err);
    for (line, message) in [
        (6, "does not belong"),
        (13, "why"),
        (27, ""),
        (35, "not an interval"),
        (42, "`why` is not declared"),
        (49, "expected"),
    ] {
        assert!(ran.err.contains(message), "{message}: {}", ran.err);
        let place = format!("mini/claims.toml:{line}:");
        assert!(ran.err.contains(&place), "{place}: {}", ran.err);
    }
    let all: serde_json::Value = serde_json::from_str(&ran.out).unwrap();
    let decided = all["claims"].as_array().unwrap();
    assert_eq!(decided.len(), 1);
    assert_eq!(decided[0]["id"], "mini/right");
    assert_eq!(decided[0]["verdict"], "holds");
    // Named by its id, what is wrong is wrong and not unknown.
    assert_eq!(on(folder.path(), &["verify", "mini/syntax"]).code, Some(4));
    assert_eq!(on(folder.path(), &["explain", "mini/syntax"]).code, Some(4));
}

#[test]
fn a_mistake_of_a_definition_is_told_once() {
    let definition = "[define]\nF = 'x + why'\n\n".to_owned();
    let claims = [claim("a", "F == 1", ""), claim("b", "2*F == 1", "")].concat();
    let folder = mini(&(definition + &claims));
    let ran = on(folder.path(), &["verify"]);
    assert_eq!(ran.code, Some(4));
    assert_eq!(
        ran.err.matches("`why` is not declared").count(),
        1,
        "{}",
        ran.err
    );
}

#[test]
fn mistakes_of_figures_are_told_by_verify() {
    let figure = "[[figure]]\nid = \"mini/fig\"\ntitle = \"t\"\ncaption = \"c\"\nalt = \"a\"\n\
                  [[figure.panel]]\nlayer = [{ curve = '[z, x]', for = [{ x = [] }] }]\n";
    let folder = mini(&(claim("right", "x == x", "") + figure));
    let ran = on(folder.path(), &["verify"]);
    assert_eq!(ran.code, Some(4), "{}", ran.err);
    assert!(ran.err.contains("mini/claims.toml:1"), "{}", ran.err);
    assert!(ran.out.contains("1 claim"), "{}", ran.out);
}

#[test]
fn what_people_type_is_answered_with_what_to_write() {
    for (typed, hint) in [
        ("sin^2(x) == 1", "sin(x)^2"),
        ("x = 1", "`==`"),
        ("\u{3c0} == 3", "`pi`"),
        ("coth(x) == 1", "not in the language"),
        ("sin == 1", "`sin(x)`"),
    ] {
        let folder = mini(&claim("a", typed, ""));
        let ran = on(folder.path(), &["verify"]);
        assert_eq!(ran.code, Some(4), "{typed}: {}", ran.out);
        assert!(ran.err.contains(hint), "{typed}: {}", ran.err);
    }
}

#[test]
fn a_huge_exponent_ends_in_a_verdict_with_a_reason() {
    let powers = [
        "x^999999999 == x",
        "x^99999999999999999999999999 == x",
        "(x + 1)^5000 == 0",
    ];
    for (number, power) in powers.into_iter().enumerate() {
        let folder = mini(&claim("a", power, ""));
        let ran = on(folder.path(), &["verify", "mini/a"]);
        assert!(
            matches!(ran.code, Some(0 | 3 | 4)),
            "{number}: {:?} {}",
            ran.code,
            ran.err
        );
        assert!(!(ran.out.clone() + &ran.err).is_empty());
    }
}

#[test]
fn deep_brackets_are_refused_at_their_place() {
    let depth = 20_000;
    let deep = format!("{}x{} == x", "(".repeat(depth), ")".repeat(depth));
    refused(&claim("a", &deep, ""), "deep", 6);
    refused(
        &claim("a", &format!("{}x == x", "-".repeat(depth)), ""),
        "deep",
        6,
    );
    let long = format!("{}x == x", "-".repeat(10 * depth));
    refused(&claim("a", &long, ""), "are read", 6);
}

#[test]
fn definitions_in_a_circle_end_with_a_message() {
    let definitions = "[define]\na = 'b + 1'\nb = 'a + 1'\n\n";
    let folder = mini(&(definitions.to_owned() + &claim("a", "a == x", "")));
    let ran = on(folder.path(), &["verify", "mini/a"]);
    assert!(
        matches!(ran.code, Some(3 | 4)),
        "{:?} {}",
        ran.code,
        ran.err
    );
    let said = ran.out + &ran.err;
    assert!(said.contains("definitions"), "{said}");
}

#[test]
fn endless_sums_and_towers_of_definitions_end() {
    let tower = (1..40).map(|n| format!("a{n} = 'a{}*a{}'\n", n - 1, n - 1));
    let tower = format!("[define]\na0 = 'x + 1'\n{}\n", tower.collect::<String>());
    for claims in [
        claim("a", "sum(i, 0, 10^12, i) == 0", ""),
        claim(
            "a",
            "sum(i, 0, 300, sum(j, 0, 300, sum(n, 0, 300, x^i*j*n))) == 0",
            "",
        ),
        tower + &claim("a", "a39 == 0", ""),
    ] {
        let folder = mini(&claims);
        let ran = on(folder.path(), &["verify", "mini/a"]);
        assert!(
            matches!(ran.code, Some(0 | 3 | 4)),
            "{:?} {}",
            ran.code,
            ran.err
        );
    }
}
