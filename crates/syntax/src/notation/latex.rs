//! Writes formulas as LaTeX mathematics, with the macros of amsmath.

use super::names::Word;
use super::typeset::{Fence, Typeset};
use super::walk::Notation;
use crate::formula::{Connective, Expr, Relation};

struct Latex;

/// Puts braces around a text of more than one character.
fn script(text: &str) -> String {
    if text.chars().count() == 1 {
        text.to_owned()
    } else {
        format!("{{{text}}}")
    }
}

/// A word set upright by `macro_name`, with underscores escaped.
fn upright(macro_name: &str, word: &str) -> String {
    format!("\\{macro_name}{{{}}}", word.replace('_', "\\_"))
}

impl Latex {
    /// Brackets that grow with tall contents.
    fn fenced(open: &str, inner: &str, close: &str) -> String {
        let tall = ["\\frac", "\\sum", "\\binom", "matrix}", "\\left"];
        if tall.iter().any(|part| inner.contains(part)) {
            format!("\\left{open} {inner} \\right{close}")
        } else {
            format!("{open}{inner}{close}")
        }
    }
}

impl Typeset for Latex {
    const DOT: &'static str = "\\cdot";
    const TIMES: &'static str = "\\times";
    const NOT: &'static str = "\\lnot";
    const TRANSPOSED: &'static str = "\\top";
    const PARTIAL: &'static str = "\\partial";

    fn word(&self, word: &Word<'_>) -> String {
        match word {
            Word::Plain("_") => "\\_".to_owned(),
            Word::Plain(word) => (*word).to_owned(),
            Word::Greek(letter) => format!("\\{}", letter.latex),
            Word::Function(word) => format!("\\{word}"),
            Word::Text(word) => upright("mathrm", word),
        }
    }

    fn operator(&self, word: &str) -> String {
        upright("operatorname", word)
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
        format!("\\frac{{{above}}}{{{below}}}")
    }

    fn root(&self, radicand: &str) -> String {
        format!("\\sqrt{{{radicand}}}")
    }

    fn binomial(&self, n: &str, k: &str) -> String {
        format!("\\binom{{{n}}}{{{k}}}")
    }

    fn norm(&self, inner: &str) -> String {
        Self::fenced("\\lVert", &format!(" {inner} "), "\\rVert")
    }

    fn absolute(&self, inner: &str) -> String {
        Self::fenced("\\lvert", &format!(" {inner} "), "\\rvert")
    }

    fn round(&self, inner: &str) -> String {
        Self::fenced("(", inner, ")")
    }

    fn matrix(&self, rows: &[Vec<String>], fence: Fence) -> String {
        let name = match fence {
            Fence::Round => "pmatrix",
            Fence::Bars => "vmatrix",
        };
        let rows: Vec<String> = rows.iter().map(|row| row.join(" & ")).collect();
        format!("\\begin{{{name}}} {} \\end{{{name}}}", rows.join(" \\\\ "))
    }

    fn sigma(&self, variable: &str, from: &str, to: &str, body: &str) -> String {
        format!("\\sum_{{{variable} = {from}}}^{} {body}", script(to))
    }

    fn product(&self, variable: &str, from: &str, to: &str, body: &str) -> String {
        format!("\\prod_{{{variable} = {from}}}^{{{to}}} {body}")
    }

    fn integral(&self, body: &str, variable: &str, from: &str, to: &str) -> String {
        format!("\\int_{{{from}}}^{{{to}}} {body} \\, d {variable}")
    }

    fn restricted(&self, derivative: &str, variable: &str, value: &str) -> String {
        format!("\\left. {derivative} \\right|_{{{variable} = {value}}}")
    }

    fn juxtaposed(&self, a: &str, b: &str) -> String {
        // Words need a thin space between them and adjacent letters.
        let worded = a.contains("\\mathrm") || b.contains("\\mathrm");
        format!("{a} {}{b}", if worded { "\\, " } else { "" })
    }

    fn relation_sign(&self, relation: Relation) -> &'static str {
        match relation {
            Relation::Equal => "=",
            Relation::Different => "\\ne",
            Relation::Less => "<",
            Relation::AtMost => "\\le",
            Relation::Greater => ">",
            Relation::AtLeast => "\\ge",
        }
    }

    fn connective_sign(&self, connective: Connective) -> &'static str {
        match connective {
            Connective::And => "\\;\\land\\;",
            Connective::Or => "\\;\\lor\\;",
            Connective::Implies => "\\implies",
        }
    }
}

/// The formula as LaTeX mathematics, without dollar signs.
///
/// ```
/// use torse_syntax::{notation, formula::parse};
/// let formula = parse("sum(i, 0, k, binom(k, i)*R[i]) != cross(u, v)").unwrap();
/// assert_eq!(
///     notation::latex(&formula),
///     r"\sum_{i = 0}^k \binom{k}{i} R_i \ne u \times v"
/// );
/// ```
#[must_use]
pub fn latex(formula: &Expr) -> String {
    Latex.write(formula).text
}
