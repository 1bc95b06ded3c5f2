//! `product(index, low, high, factor)`.
//!
//! A product of a known number of factors is multiplied out. One of symbolic length is carried where it **telescopes**: if the
//! factor is `g(i + s)/g(i)` for an integer s > 0, then by induction over the upper end
//!
//! `product = g(high + 1) ... g(high + s) / (g(low) ... g(low + s - 1))`,
//!
//! and one over that for `g(i)/g(i + s)`. It is wanted that g vanishes at no integer from `low` on, for the factor has to be defined:
//! so g is a product of linear functions of the index with rational coefficients, whose zeros are looked at.

use super::series::{polynomial_of, with_index};
use super::value::Value;
use super::{Environment, Evaluator};
use num_traits::Zero;
use torse_algebra::fault_injection::{InjectedFault, injected};
use torse_algebra::{Affine, Fraction, Polynomial, Symbol};
use torse_core::{Term, Variable};
use torse_syntax::fault::Fault;
use torse_syntax::formula::Place;

/// The most factors that are multiplied one by one.
const MAX_FACTORS: i64 = 100;
/// The largest shift of a telescoping product.
const MAX_SHIFT: i64 = 4;

impl Evaluator<'_> {
    /// The value of `product(index, low, high, term)`.
    pub(super) fn index_product(
        &self,
        index: &Variable,
        low: &Term,
        high: &Term,
        term: &Term,
        place: Place,
        bound: &Environment,
    ) -> Result<Value, Fault> {
        let (low, high) = (self.index(low, bound)?, self.index(high, bound)?);
        let factor = |here: Fraction| {
            let mut inner = bound.clone();
            inner.insert(index.number(), here.into());
            self.value(term, &inner)
        };
        let Some(length) = (high.clone() - low.clone()).as_number() else {
            let name = self.fresh(index.name());
            let what = "a product of symbolic length that does not telescope: its factor is not g(i+s)/g(i)";
            let refused = || Fault::limit(place, what);
            let Value::Scalar(value) = factor(Fraction::named(&name))? else {
                return Err(refused());
            };
            let value = value.as_fraction().ok_or_else(refused)?;
            return self
                .telescoped(value, &name, &low, &high)
                .map(Value::from)
                .ok_or_else(refused);
        };
        if length >= MAX_FACTORS {
            let what = format!("a product of {} factors", length + 1);
            return Err(Fault::limit(place, what));
        }
        let mut product: Value = Fraction::integer(1).into();
        for offset in 0..=length {
            let here = polynomial_of(&(low.clone() + Affine::number(offset)));
            let value = factor(here.into())?;
            product = match offset {
                0 => value,
                _ => self.product(&product, &value, place)?,
            };
        }
        Ok(product)
    }

    /// The closed form of a product of symbolic length, if it telescopes.
    fn telescoped(
        &self,
        factor: &Fraction,
        index: &str,
        low: &Affine,
        high: &Affine,
    ) -> Option<Fraction> {
        // From one below `low` on the closed form is the product.
        let length = high.clone() - low.clone() + Affine::number(1);
        self.declarations.least(&length).filter(|n| *n >= 0)?;
        let least = self.declarations.least(low)?;
        let divisors = factor.denominator_factors().map(|(p, _)| p);
        let mut divisors = divisors.chain(factor.conditions());
        if !divisors.all(|p| never_zero_from(p, index, least)) {
            return None;
        }
        let (above, below) = (
            Fraction::from(factor.numerator().clone()),
            Fraction::from(factor.denominator()),
        );
        let shifted = |g: &Fraction, s: i64| {
            let form = Affine::symbol(index) + Affine::number(s);
            with_index(g, index, &form).ok()
        };
        let at = |g: &Fraction, form: Affine| with_index(g, index, &form).ok();
        let high = match injected(InjectedFault::LastFactorForgotten) {
            true => high.clone() - Affine::number(1),
            false => high.clone(),
        };
        for s in 1..=MAX_SHIFT {
            for rises in [true, false] {
                let (g, other) = match rises {
                    true => (&below, &above),
                    false => (&above, &below),
                };
                if !(shifted(g, s)? - other.clone()).is_zero() {
                    continue;
                }
                // A numerator need not be without zeros, and the ends would then say something else of the empty product.
                if !rises && !never_zero_from(factor.numerator(), index, least) {
                    continue;
                }
                let mut ends = Fraction::integer(1);
                for k in 0..s {
                    let last = at(g, high.clone() + Affine::number(k + 1))?;
                    let first = at(g, low.clone() + Affine::number(k))?;
                    let part = match rises {
                        true => last.over(&first),
                        false => first.over(&last),
                    };
                    ends = ends * part.ok()?;
                }
                self.symbolic_degree.set(true);
                // The divisors vanish nowhere.
                return Some(ends.without_conditions());
            }
        }
        None
    }
}

/// Whether a polynomial is linear in the index with rational coefficients, or free of it, and zero at no integer from `least` on.
fn never_zero_from(p: &Polynomial, index: &str, least: i64) -> bool {
    let coefficients = p.coefficients_in(&Symbol::named(index));
    let numbers: Option<Vec<_>> = coefficients.iter().map(Polynomial::as_constant).collect();
    match numbers.as_deref() {
        Some([constant]) => !constant.is_zero(),
        Some([constant, rate]) => {
            let zero = -(constant / rate);
            !zero.is_integer() || zero < torse_algebra::rational::integer(least)
        }
        _ => false,
    }
}
