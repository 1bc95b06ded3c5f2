//! A derivation written out.

use super::{Derivation, code};
use std::fmt::Write as _;
use torse_syntax::formula::Expr;
use torse_syntax::notation;

/// A notation for a whole derivation.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Language {
    /// The language of derivation files.
    Text,
    /// An `align*` environment of amsmath.
    Latex,
    /// An aligned equation of Typst.
    Typst,
    /// A function on doubles.
    Rust,
    /// A Python module for SymPy.
    Sympy,
}

/// Writes the derivation in a language, under a heading; the text ends with a line break.
///
/// Text, LaTeX and Typst state the equations and then where they hold. Rust is a function from one
/// coordinate of the given points to one coordinate of the results; SymPy is a module with the
/// dictionary `results` and the list `conditions`.
#[must_use]
pub fn print(derivation: &Derivation, language: Language) -> String {
    match language {
        Language::Text => text(derivation),
        Language::Latex => latex(derivation),
        Language::Typst => typst(derivation),
        Language::Rust => code::rust(derivation),
        Language::Sympy => code::sympy(derivation),
    }
}

/// Writes left and right sides.
fn sides(derivation: &Derivation, write: fn(&Expr) -> String) -> Vec<(String, String)> {
    let lines = derivation.lines.iter();
    lines
        .map(|line| (write(&line.left), write(&line.right)))
        .collect()
}

fn conditions(derivation: &Derivation, write: fn(&Expr) -> String) -> Vec<String> {
    derivation.conditions.iter().map(write).collect()
}

fn text(derivation: &Derivation) -> String {
    let lines = sides(derivation, notation::text);
    let width = lines.iter().map(|(left, _)| left.len()).max().unwrap_or(0);
    let mut text = format!("# {}\n", derivation.title);
    for (left, right) in &lines {
        let _ = writeln!(text, "{left:<width$} = {right}");
    }
    let conditions = conditions(derivation, notation::text);
    if !conditions.is_empty() {
        let _ = writeln!(text, "# where {}", conditions.join(", "));
    }
    text
}

fn latex(derivation: &Derivation) -> String {
    let lines = sides(derivation, torse_typography::latex);
    let lines: Vec<String> = lines.iter().map(|(l, r)| format!("  {l} &= {r}")).collect();
    let mut text = format!(
        "% {}\n\\begin{{align*}}\n{}\n\\end{{align*}}\n",
        derivation.title,
        lines.join(" \\\\\n")
    );
    let conditions = conditions(derivation, torse_typography::latex);
    if !conditions.is_empty() {
        let _ = writeln!(text, "where ${}$.", conditions.join("$, $"));
    }
    text
}

fn typst(derivation: &Derivation) -> String {
    let lines = sides(derivation, torse_typography::typst);
    let lines: Vec<String> = lines.iter().map(|(l, r)| format!("  {l} &= {r}")).collect();
    let mut text = format!("// {}\n$\n{}\n$\n", derivation.title, lines.join(" \\\n"));
    let conditions = conditions(derivation, torse_typography::typst);
    if !conditions.is_empty() {
        let _ = writeln!(text, "where ${}$.", conditions.join("$, $"));
    }
    text
}
