//! Conditions: true or false, or refused where that depends on a symbol or on rounding.

use super::value::Value;
use super::{Frame, Runner};
use crate::grammar::Read;
use num_traits::Signed;
use torse_numbers::Rational;
use torse_numbers::rational::integer;
use torse_syntax::formula::{Expr, Relation};

impl Runner<'_> {
    /// The value of a condition.
    pub(super) fn truth(&mut self, condition: &Expr, frame: &mut Frame) -> Read<bool> {
        match self.value(condition, frame)? {
            Value::Truth(is_true) => Ok(is_true),
            other => {
                let message = format!("a condition is true or false, and this is {}", other.kind());
                Err(self.refused(condition.place, message, "write a comparison: `k == 0`"))
            }
        }
    }

    /// Whether numbers are related so, one to the next.
    pub(super) fn comparison(
        &mut self,
        first: &Expr,
        rest: &[(Relation, Expr)],
        frame: &mut Frame,
    ) -> Read<bool> {
        let mut left = self.value(first, frame)?;
        for (relation, right) in rest {
            let place = first.place.to(right.place);
            let right = self.value(right, frame)?;
            let (Value::Term(a), Value::Term(b)) = (&left, &right) else {
                let message = format!("{} is compared with {}", left.kind(), right.kind());
                return Err(self.refused(place, message, "numbers are compared"));
            };
            let is_rounded = a.is_rounded || b.is_rounded;
            let (Some(a), Some(b)) = (&a.constant, &b.constant) else {
                let message = "this condition depends on the value of a symbol";
                let help = "conditions on constants are read; fix integers with `--where 'k == 2'`, or compare each branch on its own";
                return Err(self.refused(place, message, help));
            };
            if is_rounded && is_near(a, b) {
                let message =
                    "these numbers are equal, or nearly so, up to what rounding makes of them";
                let help = "compare integers, or numbers that are far from each other";
                return Err(self.refused(place, message, help));
            }
            if !holds(*relation, a, b) {
                return Ok(false);
            }
            left = right;
        }
        Ok(true)
    }
}

/// Whether two numbers are related so.
pub(super) fn holds(relation: Relation, a: &Rational, b: &Rational) -> bool {
    match relation {
        Relation::Equal => a == b,
        Relation::Different => a != b,
        Relation::Less => a < b,
        Relation::AtMost => a <= b,
        Relation::Greater => a > b,
        Relation::AtLeast => a >= b,
    }
}

/// Whether rounding may decide how two numbers are related: they differ by less than a part in a thousand million.
fn is_near(a: &Rational, b: &Rational) -> bool {
    let size = a.abs() + b.abs();
    (a - b).abs() * integer(1_000_000_000) <= size
}
