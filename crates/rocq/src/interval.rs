//! The intervals of symbols, as propositions.

use crate::code::{Code, Level};
use torse_numbers::rational;
use torse_syntax::derivation::declarations::{Bound, Constant, Interval};

/// States that a number is in an interval, if the interval has an end.
pub(crate) fn within(name: &str, interval: &Interval) -> Option<Code> {
    let sign = |bound: &Bound| if bound.closed { "<=" } else { "<" };
    let end = |bound: &Bound| constant(&bound.value);
    let text = match (&interval.lower, &interval.upper) {
        (Some(low), Some(high)) => {
            format!(
                "{} {} {name} {} {}",
                end(low),
                sign(low),
                sign(high),
                end(high)
            )
        }
        (Some(low), None) => format!("{} {} {name}", end(low), sign(low)),
        (None, Some(high)) => format!("{name} {} {}", sign(high), end(high)),
        (None, None) => return None,
    };
    Some(Code::new(text, Level::Relation))
}

/// Writes a number with a multiple of pi.
fn constant(value: &Constant) -> String {
    let zero = rational::integer(0);
    let rational = Code::rational(&value.rational);
    if value.turns == zero {
        return rational.within(Level::Sum);
    }
    let turns = Code::infix(
        &Code::rational(&value.turns),
        "*",
        &Code::atom("PI"),
        Level::Product,
    );
    match value.rational == zero {
        true => turns.within(Level::Sum),
        false => Code::infix(&rational, "+", &turns, Level::Sum).within(Level::Sum),
    }
}
