//! `a^n` with a symbolic integer n: the operator `(a + b E)^n` without a shift, b = 0, of which the coefficient of E^0 is taken.
//!
//! So symbolic powers are series like sums over a basis, and what is proved of those holds of them: products with formulas, sums and
//! derivatives stay inside the class, and powers with exponents that differ by a number are compared by their seeds. The powers of a
//! product are the products of powers, `(f g)^n = f^n g^n`, so each factor has an axis of its own, and powers of one factor are one power:
//! `a^m a^n = a^(m+n)`. The exponent has to be at least 0 for all values of the integers, so that the power is defined everywhere.

use super::own_names::in_words;
use super::quantity::Quantity;
use super::series::{Axis, Series, Target};
use super::value::Value;
use super::{Evaluator, Outcome};
use crate::formula::factored;
use torse_algebra::{Affine, ExactError, Fraction, Polynomial};
use torse_syntax::fault::Fault;
use torse_syntax::formula::Place;

impl Evaluator<'_> {
    /// The power with this exponent, which is no number.
    pub(super) fn symbolic_power(
        &self,
        base: &Fraction,
        exponent: &Affine,
        place: Place,
    ) -> Outcome<Value> {
        let refused = |why: &str| {
            let exponent = in_words(&exponent.to_string());
            Fault::limit(place, format!("the symbolic power {exponent}, {why}"))
        };
        if self.declarations.least(exponent).is_none_or(|n| n < 0) {
            return Err(refused("which may be negative or is no declared integer"));
        }
        if base.is_zero() {
            return match self.declarations.least(exponent) {
                Some(1..) => Ok(Fraction::zero().under(base.conditions()).into()),
                _ => Err(refused("of zero")),
            };
        }
        self.symbolic_degree.set(true);
        let axes = Axis::powers(base, exponent).map_err(|e| Fault::exact(place, e))?;
        let mut power: Quantity = Fraction::integer(1).into();
        for axis in axes {
            let own = Quantity::from(Series::entry(axis));
            let product = power.product(&own).map_err(|e| Fault::exact(place, e))?;
            power = product.ok_or_else(|| refused("of more than three factors"))?;
        }
        let conditions: Vec<Polynomial> = base.conditions().to_vec();
        Ok(Value::Scalar(
            power.times(&Fraction::integer(1).under(&conditions)),
        ))
    }
}

impl Axis {
    /// The power of a formula as powers of its factors.
    ///
    /// # Errors
    /// [`ExactError`] for a denominator that is zero, which no formula has.
    pub(super) fn powers(base: &Fraction, power: &Affine) -> Result<Vec<Self>, ExactError> {
        let one = Fraction::integer(1);
        let (content, above) = factored(base.numerator());
        let mut bases: Vec<(Fraction, u32)> = vec![(content.into(), 1)];
        bases.extend(above.into_iter().map(|(p, n)| (Fraction::from(p), n)));
        for (p, n) in base.denominator_factors() {
            bases.push((one.over(&Fraction::from(p.clone()))?, n));
        }
        bases.retain(|(factor, _)| *factor != one);
        let axis = |(factor, n): (Fraction, u32)| Self::pure(factor, power.clone() * i64::from(n));
        Ok(bases.into_iter().map(axis).collect())
    }

    /// The power of a formula.
    fn pure(base: Fraction, power: Affine) -> Self {
        Self {
            operator: (base, Fraction::zero()),
            power,
            seeds: vec![Fraction::integer(1)],
            lowest: 0,
            target: Target::Entry(Affine::default()),
        }
    }

    /// Whether it is the power of a formula.
    pub(super) fn is_pure(&self) -> bool {
        let here = matches!(&self.target, Target::Entry(index) if *index == Affine::default());
        here && self.operator.1.is_zero() && self.lowest == 0 && self.seeds.len() == 1
    }
}
