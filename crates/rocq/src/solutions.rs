//! The values of unknowns in the proof of a verdict.

use torse_certificate::proof::assumptions::{Assumptions, Determining};
use torse_certificate::{Polynomial, Proof, Symbol};

/// An unknown with its value, a fraction, in the notation of the derivation files.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Solved {
    /// The unknown: `p1`, `p1[2]`, `Q[0]`.
    pub unknown: String,
    /// The numerator.
    pub above: String,
    /// The denominator.
    pub below: String,
}

/// Returns the values that a proof obtains from the `given` equations, in the order in which they are needed; none if
/// the parts of a proof disagree.
#[must_use]
pub fn solutions(proof: &Proof<Polynomial>) -> Vec<Solved> {
    match proof {
        Proof::On(ground) => {
            let own = of_ground(ground);
            if own.is_empty() {
                solutions(&ground.proof)
            } else {
                own
            }
        }
        Proof::Both(a, b) => {
            let first = solutions(a);
            if first.is_empty() {
                solutions(b)
            } else {
                first
            }
        }
        Proof::Parts(parts) | Proof::Clauses(parts) => {
            let mut found = parts.iter().map(solutions);
            found.find(|found| !found.is_empty()).unwrap_or_default()
        }
        Proof::Alternative { proof, .. }
        | Proof::Conclusion(proof)
        | Proof::Defined(proof)
        | Proof::Within { proof, .. } => solutions(proof),
        _ => vec![],
    }
}

fn of_ground(ground: &Assumptions<Polynomial>) -> Vec<Solved> {
    let given = ground
        .eliminated
        .iter()
        .filter(|e| matches!(e.by, Determining::Given { .. }));
    let values = given.flat_map(|elimination| &elimination.values);
    let named = values.filter_map(|value| match &value.symbol {
        Symbol::Named(name) => Some(Solved {
            unknown: name.to_string(),
            above: value.value.above.to_string(),
            below: value.value.below.to_string(),
        }),
        _ => None,
    });
    named.collect()
}
