//! `coefficients`: the derivatives of linear forms by symbols.
//!
//! A form has to be a function of its symbols as the text means it:
//!
//! 1. *Hypotheses move nothing.* Where an equation among the hypotheses says that x is 2y, the coefficient of y in x is 0 all
//!    the same. Such values are put in after the coefficients are taken. Given equations make unknowns functions of the other
//!    symbols, and their solutions are put in before.
//! 2. *Members are told apart.* `V[c]` and `V[7]` are one symbol where c is 7. A form with members of which this is not
//!    excluded is refused.
//! 3. *Nothing hides a symbol.* A root of a formula, or the value of an arbitrary function, is a symbol of the engine's own, on
//!    which no derivative by its argument would be seen. Such a form is refused.

use super::linear::linear_form;
use super::quantity::Quantity;
use super::value::Value;
use super::{Environment, Evaluator, Outcome, symbolic_degree, wrong_type};
use crate::unknown::Unknown;
use std::rc::Rc;
use torse_algebra::{Fraction, Symbol};
use torse_core::Term;
use torse_syntax::fault::Fault;
use torse_syntax::formula::Place;

impl Evaluator<'_> {
    /// One row for each form, one column for each symbol.
    pub(super) fn coefficients(
        &self,
        forms: &Term,
        unknowns: &Term,
        place: Place,
        bound: &Environment,
    ) -> Outcome<Value> {
        if self.assumed.is_empty() {
            let (forms, unknowns) = (self.value(forms, bound)?, self.value(unknowns, bound)?);
            return self.rates(&forms, &unknowns, place);
        }
        // Values of variables may have the values of assumed symbols in them.
        if self.has_given || !bound.is_empty() {
            let what = "coefficients where equations among the hypotheses determine symbols";
            return Err(Fault::limit(place, what.to_owned()));
        }
        let free = self.without_assumed();
        let (forms, unknowns) = (free.value(forms, bound)?, free.value(unknowns, bound)?);
        let rates = free.rates(&forms, &unknowns, place)?;
        rates.mapped(&|quantity: &Quantity| {
            let rate = quantity
                .as_fraction()
                .ok_or_else(|| symbolic_degree(place))?;
            let value = |symbol: &Symbol| match symbol {
                Symbol::Named(name) => self.fixed.get(&**name).cloned(),
                _ => self.solved.get(symbol).cloned(),
            };
            let rate = rate.substituted(value);
            Ok(rate.map_err(|error| Fault::exact(place, error))?.into())
        })
    }

    /// The same without the values that equations among the hypotheses determine.
    fn without_assumed(&self) -> Self {
        let is_free = |symbol: &Symbol| !self.assumed.contains(symbol);
        let fixed = self.fixed.iter();
        let solved = self.solved.iter();
        Self {
            fixed: fixed
                .filter(|(name, _)| is_free(&Symbol::named(name)))
                .map(|(name, value)| (name.clone(), value.clone()))
                .collect(),
            solved: solved
                .filter(|(symbol, _)| is_free(symbol))
                .map(|(symbol, value)| (symbol.clone(), value.clone()))
                .collect(),
            has_given: self.has_given,
            ..Self::with(Rc::clone(&self.elaborator))
        }
    }

    /// The derivatives of these forms.
    fn rates(&self, forms: &Value, unknowns: &Value, place: Place) -> Outcome<Value> {
        let mut symbols = vec![];
        for unknown in unknowns.entries() {
            let symbol = unknown.as_fraction().and_then(Unknown::from_fraction);
            symbols.push(symbol.ok_or_else(|| wrong_type(place, "a formula", "a plain symbol"))?);
        }
        let mut rows = vec![];
        for form in forms.entries() {
            let form = form.as_fraction().ok_or_else(|| symbolic_degree(place))?;
            self.see_symbols(form, &symbols, place)?;
            let (row, _) = linear_form(form, &symbols)
                .ok_or_else(|| wrong_type(place, "a nonlinear formula", "a linear form"))?;
            rows.push(row.into_iter().map(Quantity::from).collect());
        }
        Ok(Value::Matrix(rows))
    }

    /// Refuses a form that is not seen to be a function of these symbols.
    fn see_symbols(&self, form: &Fraction, symbols: &[Unknown], place: Place) -> Outcome<()> {
        let recorded = form
            .conditions()
            .iter()
            .flat_map(|divisor| divisor.symbols());
        for own in form.symbols().into_iter().chain(recorded.cloned()) {
            // The values of arbitrary functions are symbols with a place in their names.
            let is_plain =
                |name: &str| self.declarations.symbol(name).is_some() && !name.contains('(');
            if let Symbol::Named(name) = &own
                && !is_plain(name)
            {
                let what = format!("coefficients of a form in which {name} stands");
                return Err(Fault::limit(place, what));
            }
            let others = symbols
                .iter()
                .map(Unknown::symbol)
                .chain(self.solved.keys());
            for other in others {
                if may_coincide(&own, other) {
                    let what = format!("coefficients where {own} and {other} may be the same");
                    return Err(Fault::limit(place, what));
                }
            }
        }
        Ok(())
    }
}

/// Whether two members of a family with different indices are the same for some values of the integers in these.
fn may_coincide(one: &Symbol, other: &Symbol) -> bool {
    match (one, other) {
        (Symbol::Indexed(name, here), Symbol::Indexed(own, there)) => {
            let mut differences = here.iter().zip(there).map(|(x, y)| x.clone() - y.clone());
            one != other
                && name == own
                && here.len() == there.len()
                && differences.all(|gap| gap.as_number().is_none_or(|gap| gap == 0))
        }
        _ => false,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use torse_algebra::Affine;

    fn member(indices: [Affine; 2]) -> Symbol {
        Symbol::indexed("V", indices.to_vec())
    }

    #[test]
    fn members_coincide_unless_an_index_differs_by_a_number() {
        let (c, d) = (|| Affine::symbol("c"), || Affine::symbol("d"));
        let one = Affine::number(1);
        let here = member([c(), d()]);
        assert!(may_coincide(&here, &member([d(), d()])));
        assert!(may_coincide(&here, &member([c(), Affine::number(7)])));
        assert!(!may_coincide(&here, &here));
        assert!(!may_coincide(
            &here,
            &member([c() + one, Affine::number(7)])
        ));
        assert!(!may_coincide(&here, &Symbol::named("V")));
    }
}
