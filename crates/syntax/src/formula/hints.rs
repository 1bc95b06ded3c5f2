//! Hints for what users of mathematical notation commonly type: the corresponding syntax of the language.

use super::ast::Node;
use super::character::IMPLIES;
use super::functions::{infinite, is_function, out_of_scope};
use super::token::{Token, is_name};
use crate::greek;

/// How what relates statements is written.
const EQUIVALENT: &str =
    "that two statements say the same is written `(p implies q) and (q implies p)`";
const CONDITION: &str = "a condition stands before what it is for: `p implies q`; in a claim it may stand under `assume`, beside a \
                         single statement under `--where`";

/// The hint for two signs side by side that are one sign elsewhere.
fn signs(before: &str, found: &str) -> Option<&'static str> {
    match (before, found) {
        ("-" | "==", ">") => Some(IMPLIES),
        ("<=", ">") => Some(EQUIVALENT),
        ("<", ">") => Some("write `!=`"),
        ("*", "*") => Some("a power is written with `^`"),
        _ => None,
    }
}

/// The hint for a word of mathematical English between formulas.
fn word(word: &str) -> Option<&'static str> {
    Some(match word {
        "iff" => EQUIVALENT,
        "if" | "then" | "for" | "where" | "when" | "with" => CONDITION,
        "in" => {
            "that `x` lies in an interval is written `0 <= x <= 1`, or declared: `x = { in = \"[0, 1]\" }`, or `--where \"x in [0, 1]\"`"
        }
        "mod" => {
            "remainders are out of scope: that `n` is even is stated with an integer `k`, `n == 2*k`"
        }
        _ => return None,
    })
}

/// The hint for a token `found` that cannot follow `before`; `next` stands behind it.
pub fn unexpected(
    before: Option<&Token>,
    found: Option<&Token>,
    next: Option<&Token>,
) -> Option<String> {
    let operand = |token: &Token| match token {
        Token::Number(text) | Token::Name(text) => Some(text.clone()),
        Token::Sign(sign) => (*sign == "(").then(|| "(...)".to_owned()),
    };
    let name = |token: &Token| match token {
        Token::Name(name) => word(name),
        _ => None,
    };
    if let Some(hint) = found.and_then(name).or_else(|| before.and_then(name)) {
        return Some(hint.to_owned());
    }
    if let (Token::Sign(before), Token::Sign(found)) = (before?, found?)
        && let Some(hint) = signs(before, found)
    {
        return Some(hint.to_owned());
    }
    match (before?, found?) {
        (_, Token::Sign(",")) => {
            Some("a vector is written in square brackets: `[a, b]`".to_owned())
        }
        (Token::Name(name), Token::Name(next)) if FUNCTIONS.contains(&name.as_str()) => {
            Some(format!("arguments stand in brackets: `{name}({next})`"))
        }
        (Token::Number(before), Token::Name(name)) => Some(product(before, name, next)),
        (Token::Number(before) | Token::Name(before), found) => {
            let found = operand(found)?;
            Some(format!("a product is written with `*`: `{before}*{found}`"))
        }
        (Token::Sign(")" | "]"), found) => {
            let found = operand(found)?;
            Some(format!("a product is written with `*`: `...*{found}`"))
        }
        _ => None,
    }
}

/// The hint for a number before a name: a name of a few letters may be a product of them, one before brackets a factor.
fn product(number: &str, name: &str, next: Option<&Token>) -> String {
    let written = "a product is written with `*`";
    let is_word = is_function(name) || greek::by_name(name).is_some();
    let letters: Vec<String> = name.chars().map(String::from).collect();
    let is_product = !is_word
        && (2..=3).contains(&letters.len())
        && letters.iter().all(|letter| is_name(letter));
    let factors = match is_product {
        true => format!("{number}*{}", letters.join("*")),
        false => format!("{number}*{name}"),
    };
    match next {
        Some(Token::Sign("(")) if !is_word => {
            format!(
                "{written}: `{factors}*(...)`, or `{number}*{name}(...)` if `{name}` is a function"
            )
        }
        Some(Token::Sign("(")) => format!("{written}: `{number}*{name}(...)`"),
        _ if is_product => {
            format!("{written}: `{factors}`, or `{number}*{name}` if `{name}` is one name")
        }
        _ => format!("{written}: `{factors}`"),
    }
}

/// Functions that papers print without brackets.
const FUNCTIONS: [&str; 13] = [
    "sin", "cos", "tan", "sinh", "cosh", "tanh", "exp", "log", "atan", "asin", "acos", "sqrt",
    "det",
];

/// Describes a formula that can never be a function; `None` if it may be one.
pub fn kind_if_not_function(node: &Node) -> Option<String> {
    Some(match node {
        Node::Name(_) | Node::Call(..) | Node::Index(..) => return None,
        Node::Number { .. } => "a number".to_owned(),
        Node::List(_) => "a list".to_owned(),
        Node::Negative(_) | Node::Binary(..) => "a formula in brackets".to_owned(),
        Node::Compare(..) | Node::Join(..) | Node::Not(_) => "a statement".to_owned(),
    })
}

/// The hint for an undeclared name.
pub fn name(unknown: &str) -> Option<&'static str> {
    Some(match unknown {
        "\u{3c0}" | "Pi" | "PI" => "the number pi is written `pi`",
        "cot" => "`cot` is not in the language: write `cos(x)/sin(x)`",
        "sec" => "`sec` is not in the language: write `1/cos(x)`",
        "csc" => "`csc` is not in the language: write `1/sin(x)`",
        "coth" => "`coth` is not in the language: write `cosh(x)/sinh(x)`",
        "ln" => "the natural logarithm is written `log(x)`",
        "arctan" => "the arc tangent is written `atan(x)`",
        "arcsin" => "the arc sine is written `asin(x)`",
        "arccos" => "the arc cosine is written `acos(x)`",
        "log2" | "log10" => {
            "a logarithm to another base is written as a quotient: `log(x)/log(10)`"
        }
        "gamma" => {
            "this function is not in the language: its functions are rational, sqrt, abs, min, max, sin, cos, tan, exp, log, atan, asin, acos, sinh, cosh and tanh"
        }
        known if out_of_scope(known).is_some() => out_of_scope(known)?,
        "e" => "the base of natural logarithms is written `exp(1)`",
        known if infinite(known).is_some() => infinite(known)?,
        "diff" | "d" => "a derivative is written `D(F, x)`",
        "prod" => "a product over an index is written `product(i, 1, k, ...)`",
        "int" => "an integral is written `integral(f, x, a, b)`",
        "binomial" | "choose" | "comb" | "C" => "a binomial coefficient is written `binom(n, j)`",
        _ => return None,
    })
}
