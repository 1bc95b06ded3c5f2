//! Applying functions: parameters bound to values, derivatives taken at fresh variables.

use super::quantity::Quantity;
use super::value::{Function, Value};
use super::{Bindings, Evaluator, Outcome, symbolic_degree, wrong_type};
use torse_algebra::Fraction;
use torse_language::fault::{Fault, Problem};
use torse_language::syntax::Place;

impl Evaluator<'_> {
    /// Applies a function to values.
    pub(super) fn apply(
        &self,
        function: &Function,
        arguments: &[Value],
        place: Place,
    ) -> Outcome<Value> {
        if arguments.len() != function.parameters.len() {
            return Err(Fault::at(
                place,
                Problem::Count {
                    name: function.name.clone(),
                    wanted: format!("{} arguments", function.parameters.len()),
                    found: arguments.len(),
                },
            ));
        }
        let body = |bound: &Bindings| {
            self.deeper(place, || {
                self.value(&function.body, bound)
                    .map_err(|f| f.within(&function.origin))
            })
        };
        if function.derivatives.is_empty() {
            let bound = function
                .parameters
                .iter()
                .cloned()
                .zip(arguments.iter().cloned())
                .collect();
            return body(&bound);
        }
        self.symbolically(|| self.differentiated(function, arguments, place, &body))
    }

    /// The derivatives of a function at values: by fresh variables, then the arguments are put in.
    fn differentiated(
        &self,
        function: &Function,
        arguments: &[Value],
        place: Place,
        body: &dyn Fn(&Bindings) -> Outcome<Value>,
    ) -> Outcome<Value> {
        let fresh = |parameter: &str| format!("{parameter}\u{b0}");
        let bound = function
            .parameters
            .iter()
            .map(|p| (p.clone(), Fraction::named(&fresh(p)).into()))
            .collect();
        let mut value = body(&bound)?;
        for (parameter, order) in &function.derivatives {
            for _ in 0..*order {
                value = value
                    .mapped(&|q: &Quantity| Ok::<_, Fault>(q.derivative(&fresh(parameter))))?;
            }
        }
        for (parameter, argument) in function.parameters.iter().zip(arguments) {
            let Value::Scalar(point) = argument else {
                return Err(wrong_type(place, argument.kind(), "a number"));
            };
            let point = point.as_fraction().ok_or_else(|| symbolic_degree(place))?;
            value = self.placed(&value, &fresh(parameter), point, place)?;
        }
        Ok(value)
    }

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
                .map_err(|e| Fault::exact(place, e))?;
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
