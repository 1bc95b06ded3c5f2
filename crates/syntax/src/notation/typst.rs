//! Writes formulas as Typst mathematics, for the math mode of Typst 0.15.
//!
//! Uses only functions and symbols of the standard math scope; other names are single letters or quoted text. A space
//! precedes the brackets of an argument list, so that Typst does not read them as part of a subscript or as a
//! function call.

use super::names::Word;
use super::typeset::{Fence, Typeset};
use super::walk::Notation;
use crate::formula::{Connective, Expr, Relation};

struct Typst;

/// Puts brackets, which Typst does not show, around a text of more than one letter or number.
fn script(text: &str) -> String {
    let single = text.chars().count() == 1 || text.chars().all(|c| c.is_ascii_digit());
    if single {
        text.to_owned()
    } else {
        format!("({text})")
    }
}

impl Typeset for Typst {
    const DOT: &'static str = "dot.op";
    const TIMES: &'static str = "times";
    const NOT: &'static str = "not";
    const TRANSPOSED: &'static str = "top";
    const PARTIAL: &'static str = "partial";

    fn word(&self, word: &Word<'_>) -> String {
        match word {
            Word::Plain("_") => "\"_\"".to_owned(),
            Word::Greek(letter) => letter.name.to_owned(),
            Word::Plain(word) | Word::Function(word) => (*word).to_owned(),
            Word::Text(word) => format!("\"{word}\""),
        }
    }

    fn operator(&self, word: &str) -> String {
        format!("op(\"{word}\")")
    }

    fn attached(&self, base: &str, primes: usize, below: &str, above: &str) -> String {
        let mut text = format!("{base}{}", "'".repeat(primes));
        if !below.is_empty() {
            text.extend(["_", &script(below)]);
        }
        if !above.is_empty() {
            text.extend(["^", &script(above)]);
        }
        text
    }

    fn fraction(&self, above: &str, below: &str) -> String {
        format!("frac({above}, {below})")
    }

    fn root(&self, radicand: &str) -> String {
        format!("sqrt({radicand})")
    }

    fn binomial(&self, n: &str, k: &str) -> String {
        format!("binom({n}, {k})")
    }

    fn norm(&self, inner: &str) -> String {
        format!("norm({inner})")
    }

    fn absolute(&self, inner: &str) -> String {
        format!("abs({inner})")
    }

    fn round(&self, inner: &str) -> String {
        format!("({inner})")
    }

    fn matrix(&self, rows: &[Vec<String>], fence: Fence) -> String {
        let delimiter = match fence {
            Fence::Round => "(",
            Fence::Bars => "|",
        };
        let rows: Vec<String> = rows.iter().map(|row| row.join(", ")).collect();
        format!("mat(delim: \"{delimiter}\", {})", rows.join("; "))
    }

    fn sigma(&self, variable: &str, from: &str, to: &str, body: &str) -> String {
        format!("sum_({variable} = {from})^{} {body}", script(to))
    }

    fn product(&self, variable: &str, from: &str, to: &str, body: &str) -> String {
        format!("product_({variable} = {from})^({to}) {body}")
    }

    fn integral(&self, body: &str, variable: &str, from: &str, to: &str) -> String {
        format!("integral_({from})^({to}) {body} thin d {variable}")
    }

    fn restricted(&self, derivative: &str, variable: &str, value: &str) -> String {
        format!("lr({derivative} |)_({variable} = {value})")
    }

    fn juxtaposed(&self, a: &str, b: &str) -> String {
        format!("{a} {b}")
    }

    fn relation_sign(&self, relation: Relation) -> &'static str {
        match relation {
            Relation::Equal => "=",
            other => other.sign(),
        }
    }

    fn connective_sign(&self, connective: Connective) -> &'static str {
        match connective {
            Connective::And => "thick and thick",
            Connective::Or => "thick or thick",
            Connective::Implies => "thick ==> thick",
        }
    }
}

/// The formula as Typst mathematics, without dollar signs.
///
/// ```
/// use torse_syntax::{notation, formula::parse};
/// let formula = parse("H''(0) == 1/4*pi^2*(1 - mu1)*length").unwrap();
/// assert_eq!(
///     notation::typst(&formula),
///     "H'' (0) = frac(1, 4) pi^2 (1 - mu_1) \"length\""
/// );
/// ```
#[must_use]
pub fn typst(formula: &Expr) -> String {
    Typst.write(formula).text
}
