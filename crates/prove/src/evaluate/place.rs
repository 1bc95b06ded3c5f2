//! Putting values in: variables at points, powers of symbolic degree that collapse, solved unknowns.

use super::own_names::in_words;
use super::quantity::Quantity;
use super::value::Value;
use super::{Evaluator, Outcome};
use torse_algebra::{ExactError, Fraction};
use torse_syntax::fault::Fault;
use torse_syntax::formula::Place;

/// The error with the names that the statement has.
fn in_words_of_the_text(error: ExactError) -> ExactError {
    match error {
        ExactError::DivisionByZero { divisor } => ExactError::DivisionByZero {
            divisor: in_words(&divisor),
        },
        other => other,
    }
}

impl Evaluator<'_> {
    /// The value with a variable at a point; series that collapse there become plain.
    pub(super) fn placed(
        &self,
        value: &Value,
        variable: &str,
        point: &Fraction,
        place: Place,
    ) -> Outcome<Value> {
        value.mapped(&|q: &Quantity| {
            let moved = q
                .mapped(|f| f.at(variable, point))
                .map_err(|e| Fault::exact(place, in_words_of_the_text(e)))?;
            self.settled(moved, place)
        })
    }

    /// The quantity with every power that collapses multiplied out.
    pub(super) fn settled(&self, quantity: Quantity, place: Place) -> Outcome<Quantity> {
        let mut plain = quantity.plain;
        let mut series = vec![];
        for part in quantity.series {
            let (value, rest) = part
                .settled(&|form| self.declarations.least(form), &|form| {
                    self.declarations.greatest(form)
                })
                .map_err(|e| Fault::exact(place, e))?;
            plain = plain + self.resolved(&value, place)?;
            series.extend(rest);
        }
        Ok(Quantity { plain, series })
    }

    /// A fraction with the solved unknowns put in.
    pub(super) fn resolved(&self, value: &Fraction, place: Place) -> Outcome<Fraction> {
        if self.solved.is_empty() {
            return Ok(value.clone());
        }
        value
            .substituted(|s| self.solved.get(s).cloned())
            .map_err(|e| Fault::exact(place, e))
    }
}
