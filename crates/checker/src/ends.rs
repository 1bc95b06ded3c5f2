//! The ends of declared intervals.

use super::quotient::Quotient;
use torse_certificate::polynomial::Polynomial;
use torse_certificate::symbol::Symbol;
use torse_syntax::derivation::declarations::{Bound, Interval};
use torse_syntax::formula::Relation;

/// Returns the ends of an interval, each with the relation of its numbers to it.
pub fn interval_ends(interval: &Interval) -> Vec<(Quotient, Relation)> {
    let end = |bound: &Bound, closed: Relation, open: Relation| {
        let turns = Polynomial::symbol(Symbol::Pi).scaled(&bound.value.turns);
        let value = turns.plus(&Polynomial::constant(bound.value.rational.clone()));
        (
            Quotient::from(value),
            if bound.closed { closed } else { open },
        )
    };
    let lower = interval.lower.iter();
    let lower = lower.map(|bound| end(bound, Relation::AtLeast, Relation::Greater));
    let upper = interval.upper.iter();
    let upper = upper.map(|bound| end(bound, Relation::AtMost, Relation::Less));
    lower.chain(upper).collect()
}
