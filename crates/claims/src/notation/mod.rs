//! Formulas written out: the derivation language, Typst, LaTeX, Rust and SymPy.
//!
//! One walk over the tree decides brackets by precedence, a notation only says how each construct
//! looks. What is written in the derivation language is read back as the same tree, so that every
//! formula the engine shows can be put into a file.
//!
//! [`expression`] and [`expression_of`] lead from exact algebra back to a formula that a human would
//! write: factored, with control points collected and differences of neighbours recognised.

mod build;
mod expression;
mod factor;
mod latex;
mod names;
mod points;
mod rust;
mod sympy;
#[cfg(test)]
mod tests;
mod text;
mod typeset;
mod typst;
mod walk;

pub use expression::{expression, expression_of};
pub use latex::latex;
pub use rust::rust;
pub use sympy::sympy;
pub use text::text;
pub use typst::typst;

use crate::outcome::Formula;
use crate::syntax::Expr;
use torse_algebra::Polynomial;

/// Factors of a polynomial, without exponents and constants; not always irreducible ones.
#[must_use]
pub fn factors(polynomial: &Polynomial) -> Vec<Polynomial> {
    let factored = factor::Factored::of(polynomial);
    factored
        .factors
        .into_iter()
        .map(|(factor, _)| factor)
        .collect()
}

/// The formula in the notations of the outputs.
#[must_use]
pub fn formula(expr: &Expr) -> Formula {
    Formula {
        text: text(expr),
        typst: typst(expr),
        latex: latex(expr),
    }
}
