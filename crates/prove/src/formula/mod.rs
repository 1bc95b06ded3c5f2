//! From exact algebra back to a formula that a human would write: factored, with control points collected and
//! differences of neighbours recognised.
//!
//! Nothing here decides anything: a shape is only ever another way to write the same value.

mod build;
mod expression;
mod factor;
mod points;
#[cfg(test)]
mod tests;

pub use expression::{expression, expression_of};

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
