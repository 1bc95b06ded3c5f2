//! From exact algebra back to a formula that a human would write: factored, with control points collected and
//! differences of neighbours recognised.
//!
//! Nothing here decides anything: a shape is only ever another way to write the same value.

mod build;
mod expression;
mod factor;
mod points;
mod shape;
#[cfg(test)]
mod tests;

pub use expression::{expression, expression_of};

use torse_algebra::{Polynomial, Rational};

/// A number and factors with exponents whose product a polynomial is; the factors are not always irreducible.
#[must_use]
pub fn factored(polynomial: &Polynomial) -> (Rational, Vec<(Polynomial, u32)>) {
    let factored = factor::Factored::new(polynomial);
    (factored.content, factored.factors)
}

/// Factors of a polynomial, without exponents and constants; not always irreducible ones.
#[must_use]
pub fn factors(polynomial: &Polynomial) -> Vec<Polynomial> {
    let factored = factor::Factored::new(polynomial);
    factored
        .factors
        .into_iter()
        .map(|(factor, _)| factor)
        .collect()
}
