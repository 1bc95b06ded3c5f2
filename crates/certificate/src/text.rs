//! Numbers as texts: exact ones such as `-7/3` in written proofs, and counts in steps.

use serde::{Serialize, Serializer};
use torse_numbers::Rational;

/// A rational number.
pub(crate) fn number<S: Serializer>(value: &Rational, to: S) -> Result<S::Ok, S::Error> {
    to.collect_str(value)
}

/// Rational numbers, one after the other.
pub(crate) fn numbers<S: Serializer>(values: &[Rational], to: S) -> Result<S::Ok, S::Error> {
    to.collect_seq(values.iter().map(ToString::to_string))
}

/// The sides of a box, `[[low, high], ...]`.
pub(crate) fn region<S: Serializer>(
    region: &[(Rational, Rational)],
    to: S,
) -> Result<S::Ok, S::Error> {
    let sides = region.iter().map(|(a, b)| [a.to_string(), b.to_string()]);
    sides.collect::<Vec<_>>().serialize(to)
}
