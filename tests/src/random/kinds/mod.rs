//! One generator a kind.

pub mod angles;
pub mod assumptions;
pub mod calculus;
pub mod decimals;
pub mod degree;
pub mod division;
pub mod exists;
pub mod exponentials;
pub mod functions;
pub mod given;
pub mod inequality;
pub mod integers;
pub mod integrals;
pub mod logic;
pub mod polynomial;
pub mod powers;
pub mod properties;
pub mod splines;
pub mod vectors;

use super::Kind;
use super::claim::{Claim, States, Truth};
use super::domain::{Domain, where_not_zero};
use super::polynomial::Polynomial;
use super::seed::Stream;

/// `left == right` where `left` is printed and `right` given as a polynomial, slipped half of the time; the symbols
/// are declared.
fn equation(
    stream: &mut Stream,
    kind: Kind,
    (names, domains): (&[&str], &[Domain]),
    left: &str,
    right: &Polynomial,
) -> Claim {
    let mut truth = Truth::Holds;
    let mut printed = right.clone();
    if stream.once_in(2) {
        printed = right.slipped(stream);
        let difference = right - &printed;
        truth = Truth::Fails(where_not_zero(&difference, names, domains));
    }
    let states = States::Compare(left.to_owned(), "==", printed.text(stream, names));
    declared(
        Claim::new(kind, states, truth).wanting(names, right),
        names,
        domains,
    )
}

/// With these symbols.
fn declared(claim: Claim, names: &[&str], domains: &[Domain]) -> Claim {
    names
        .iter()
        .zip(domains)
        .fold(claim, |claim, (name, domain)| {
            claim.symbol(name, domain.declaration)
        })
}
