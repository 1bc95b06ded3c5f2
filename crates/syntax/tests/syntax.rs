//! The parser on hostile formulas, and on what people type who know the formulas of papers.

#![allow(clippy::unwrap_used)]

use torse_syntax::formula::{SyntaxError, is_name, parse};
use torse_syntax::notation;

/// The stack of a thread that tests and pools get by default is 2 MB; a quarter of it must do.
const SMALL: usize = 512 * 1024;

/// Parses, copies, changes, prints, reads again, compares and drops a formula on a small stack.
fn lives_on_a_small_stack(text: String) {
    let thread = std::thread::Builder::new().stack_size(SMALL);
    let handle = thread.spawn(move || {
        let formula = parse(&text).unwrap().placeless();
        let copy = formula.clone();
        let written = notation::formula(&formula).text;
        assert!(parse(&written).unwrap().placeless() == copy);
        formula.size()
    });
    assert!(handle.unwrap().join().unwrap() > 10_000);
}

#[test]
fn chains_of_ten_thousand_links_live_on_a_small_stack() {
    for (operand, link) in [
        ("x", " + "),
        ("2*x^3", " - y + "),
        ("x", "*"),
        ("x", "/y*"),
        ("x == 1", " and "),
        ("x == 1", " or "),
        ("x < 2 and y < 1", " or "),
    ] {
        lives_on_a_small_stack(vec![operand; 10_000].join(link));
    }
}

#[test]
fn a_long_chain_is_cut_only_where_brackets_change_nothing() {
    let signs = |n: usize| if n % 2 == 1 { " - " } else { " + " };
    let sum = (1..400).fold("0".to_owned(), |text, n| format!("{text}{}{n}", signs(n)));
    let product = ["a"; 400].join("/b*");
    for (text, wrong) in [(sum, "- ("), (product, "/(")] {
        let written = notation::text(&parse(&text).unwrap());
        let flat: String = written.chars().filter(|c| !"()".contains(*c)).collect();
        assert_eq!(flat, text);
        assert!(
            written.contains('(') && !written.contains(wrong),
            "{written}"
        );
    }
}

#[test]
fn what_is_too_deep_or_too_long_is_refused_with_the_limit() {
    let refused = |text: &str, says: &str| {
        let error = parse(text).unwrap_err();
        assert!(error.to_string().contains(says), "{error}");
    };
    for depth in [400, 30_000] {
        refused(&format!("P{}", "[0]".repeat(depth)), "300");
        refused(&format!("f{}", "(0)".repeat(depth)), "300");
        refused(&vec!["x"; depth].join("/"), "300");
        refused(&vec!["x"; depth].join(" - "), "300");
        refused(&format!("{}x", "not ".repeat(depth)), "100");
        refused(&format!("{}x", "x^".repeat(depth)), "100");
        refused(&format!("{}x", "x implies ".repeat(depth)), "100");
        refused(&format!("{}x", "[".repeat(depth)), "100");
    }
    refused(
        &["x"; 100_000].join(" + "),
        "199999 numbers, names and signs; at most 100000",
    );
    refused(&"9".repeat(1_000_000), "1000000 digits; at most 1000");
    refused(&format!("0.{}", "3".repeat(66_000)), "at most 1000");
    assert!(parse(&"9".repeat(1_000)).is_ok());
}

#[test]
fn nested_long_chains_do_not_add_up_beyond_the_limit() {
    let mut text = "x".to_owned();
    for _ in 0..30 {
        text = format!("({text}){}", " + y".repeat(60));
    }
    assert!(matches!(parse(&text), Err(SyntaxError::TooHigh { .. })));
}

#[test]
fn what_people_type_is_answered_with_what_to_write() {
    for (typed, hint) in [
        ("sin^2(x) == 1", "sin(x)^2"),
        ("x = 1", "`==`"),
        ("|x| == 1", "norm(v)"),
        ("x \u{2265} 1", "`>=`"),
        ("x \u{2264} 1", "`<=`"),
        ("x \u{2260} 1", "`!=`"),
        ("2\u{b7}x == 1", "`*`"),
        ("x \u{2212} 1 == 0", "minus sign"),
        ("x\u{b2} == 1", "x^2"),
        ("x**2 == 1", "`^`"),
        ("2x == 1", "`2*x`"),
        ("x y == 1", "`x*y`"),
        ("2(x + 1) == 1", "`*`"),
        ("(x + 1)(x - 1) == 1", "`*`"),
        ("(x + 1) y == 1", "`*`"),
        ("sin x == 1", "`sin(x)`"),
        ("\u{221a}2 == 1", "sqrt(x)"),
        ("n! == 1", "factorial(n)"),
        ("{x} == 1", "round"),
        (".5 == x", "0.5"),
        ("\\mu == 1", "TeX"),
        ("x > 0 iff -x < 0", "(p implies q) and (q implies p)"),
        ("x > 0 <=> -x < 0", "(p implies q) and (q implies p)"),
        ("x > 0 => x^2 > 0", "`p implies q`"),
        ("x > 0 ==> x^2 > 0", "`p implies q`"),
        ("x > 0 -> x^2 > 0", "`p implies q`"),
        ("if x > 0 then x^2 > 0", "`p implies q`"),
        ("x^2 >= 0 for x > 0", "`p implies q`"),
        ("x^2 >= 0 where x > 0", "`p implies q`"),
        ("x in [0,1] implies x <= 1", "0 <= x <= 1"),
        ("x <> 1", "`!=`"),
        ("x =< 1", "`<=`"),
        ("x mod 2 == 0", "remainders"),
        ("for all x: x^2 >= 0", "leave out `for all x:`"),
    ] {
        let error = parse(typed).unwrap_err();
        let help = error.help().unwrap_or_default();
        assert!(help.contains(hint), "{typed}: {error}: {help}");
    }
}

#[test]
fn exponents_are_read_however_they_are_printed() {
    for power in [
        "x^2",
        "x^(4/2)",
        "x^(-3)",
        "x^2.0",
        "x^(k/2)",
        "x^(1/2*k)",
        "x^(1/3)",
        "x^0.5",
    ] {
        assert!(parse(power).is_ok(), "{power}");
    }
}

#[test]
fn no_text_can_write_a_reserved_character() {
    for reserved in [
        '\u{bd}', '\u{b0}', '#', '@', '$', '%', '~', '?', ':', ';', '\u{b2}', '\u{2460}',
        '\u{663}', '\u{a7}', '\u{2192}', '\u{301}', '\u{200b}', '"', '`',
    ] {
        for text in [
            format!("x{reserved}"),
            format!("{reserved}x"),
            format!("{reserved}"),
            format!("x{reserved}y"),
            format!("f(x{reserved})"),
            format!("x'{reserved}"),
        ] {
            assert!(parse(&text).is_err(), "{text}");
            assert!(!is_name(&text), "{text}");
        }
    }
}

#[test]
fn names_are_letters_digits_and_underscores() {
    for name in ["x", "mu_1", "H''", "\u{3bc}", "_y", "P0u", "\u{43f}"] {
        assert!(is_name(name) && parse(name).is_ok(), "{name}");
    }
    for name in [
        "", "'", "1x", "x y", "x-y", "a'b", "and", "or", "not", "implies", "pi", "x[1]",
    ] {
        assert!(!is_name(name), "{name}");
    }
}
