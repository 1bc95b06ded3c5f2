//! Substitution of symbols in the value and in its recorded divisors.

use super::{Fraction, merged};
use crate::affine::Affine;
use crate::polynomial::Polynomial;
use crate::rational::Rational;
use crate::scalar::{ExactError, Scalar};
use crate::symbol::{Angle, Symbol, Unit};
use std::collections::BTreeMap;

impl Fraction {
    /// Replaces each symbol for which `value` returns a fraction by that fraction.
    ///
    /// # Errors
    /// [`ExactError::DivisionByZero`] when a denominator becomes zero.
    pub fn substituted(
        &self,
        value: impl Fn(&Symbol) -> Option<Fraction>,
    ) -> Result<Self, ExactError> {
        if !self.symbols().iter().any(|s| value(s).is_some()) && self.conditions.is_empty() {
            return Ok(self.clone());
        }
        let replace = |p: &Polynomial| Self::replaced(p, &value);
        let mut result = replace(&self.numerator);
        for (factor, exponent) in &self.denominator {
            result = result.divided(&replace(factor), *exponent)?;
        }
        result = result.cancelled();
        for condition in &self.conditions {
            let replaced = replace(condition);
            let divisor = replaced.numerator.primitive().1;
            if divisor.is_zero() {
                return Err(ExactError::DivisionByZero {
                    divisor: condition.to_string(),
                });
            }
            if divisor.as_constant().is_none() {
                result.conditions = merged(&result.conditions, &[divisor]);
            }
        }
        Ok(result)
    }

    /// Replaces symbols of a polynomial, over the least common multiple of the denominators of all terms; not yet
    /// cancelled.
    fn replaced(p: &Polynomial, value: &impl Fn(&Symbol) -> Option<Self>) -> Self {
        let values: Vec<Option<Self>> = p.symbols().iter().map(value).collect();
        let groups = p.grouped(|symbol| values.get(symbol).is_some_and(Option::is_some));
        let term = |(powers, kept): (Vec<u16>, Polynomial)| {
            let mut term = Self::from(kept);
            for (exponent, value) in powers.iter().zip(&values) {
                let (Some(value), exponent @ 1..) = (value, u32::from(*exponent)) else {
                    continue;
                };
                term.numerator = &term.numerator * &value.numerator.power(exponent);
                for (factor, times) in &value.denominator {
                    *term.denominator.entry(factor.clone()).or_insert(0) += times * exponent;
                }
                term.conditions = merged(&term.conditions, &value.conditions);
            }
            term
        };
        let terms = groups.into_iter().map(term);
        terms.fold(Self::zero(), |sum, term| sum.sum_uncancelled(&term))
    }

    /// Returns the integer-affine form that equals the fraction, such as `m - 2`, or `None` if there is none. Only
    /// such forms can be indices.
    #[must_use]
    pub fn as_affine(&self) -> Option<Affine> {
        let mut total = Affine::number(0);
        for term in self.as_polynomial()?.terms() {
            if !term.coefficient.is_integer() {
                return None;
            }
            let multiple = i64::try_from(term.coefficient.to_integer()).ok()?;
            let form = match term.powers.as_slice() {
                [] => Affine::number(1),
                [(Symbol::Named(name), 1)] => Affine::symbol(name),
                _ => return None,
            };
            total = total + form * multiple;
        }
        Some(total)
    }

    /// Substitutes `value` for the variable `name` everywhere: where it stands alone, under sine, cosine and
    /// exponential, in the indices of members of families, and in the recorded conditions.
    ///
    /// ```
    /// use torse_algebra::{Affine, Fraction, Symbol};
    /// let member = |index| Fraction::symbol(Symbol::indexed("P", vec![index]));
    /// let product = Fraction::named("m") * member(Affine::symbol("m"));
    /// let at_two = product.at("m", &Fraction::integer(2)).unwrap();
    /// assert_eq!(at_two, Fraction::integer(2) * member(Affine::number(2)));
    /// assert!(product.at("m", &Fraction::symbol(Symbol::Pi)).is_err());
    /// ```
    ///
    /// # Errors
    /// [`ExactError::NoExactTurn`] when sine and cosine at `value` are not polynomials; [`ExactError::NoExponential`]
    /// when an exponential at `value` is no quotient of polynomials; [`ExactError::NoIndex`] when the variable stands
    /// in an index and `value` is no integer-affine form; [`ExactError::DivisionByZero`] when a denominator becomes
    /// zero.
    pub fn at(&self, name: &str, value: &Fraction) -> Result<Self, ExactError> {
        let mut present = self.symbols();
        present.extend(self.conditions.iter().flat_map(|p| p.symbols().to_vec()));
        let form = value.as_affine();
        let in_index = |s: &&Symbol| matches!(s, Symbol::Indexed(..)) && s.depends_on(name);
        if form.is_none()
            && let Some(member) = present.iter().find(in_index)
        {
            return Err(ExactError::NoIndex {
                member: member.to_string(),
                value: value.to_string(),
            });
        }
        let mut pairs: BTreeMap<Angle, (Self, Self)> = BTreeMap::new();
        for symbol in &present {
            if let Symbol::Sin(v, angle) | Symbol::Cos(v, angle) = symbol
                && **v == *name
                && !pairs.contains_key(angle)
            {
                let part = value.scaled(&Rational::new(1.into(), angle.parts.into()));
                let pair = match angle.unit {
                    Unit::QuarterTurn => part.quarter_turn()?,
                    Unit::Radian => part.sine_cosine()?,
                };
                pairs.insert(*angle, pair);
            }
        }
        let mut powers: BTreeMap<Symbol, Self> = BTreeMap::new();
        for symbol in present.iter().filter(|s| s.depends_on(name)) {
            if let Symbol::Exp(exponent) = symbol {
                let exponent = Self::from(exponent.polynomial()).at(name, value)?;
                powers.insert(symbol.clone(), exponent.exponential()?);
            }
        }
        self.substituted(|symbol| match symbol {
            Symbol::Named(v) if &**v == name => Some(value.clone()),
            Symbol::Indexed(family, index) if symbol.depends_on(name) => {
                let form = form.as_ref()?;
                let index = index.iter().map(|i| i.substituted(name, form)).collect();
                Some(Self::symbol(Symbol::Indexed(family.clone(), index)))
            }
            Symbol::Sin(v, a) | Symbol::Cos(v, a) if &**v == name => {
                let (sine, cosine) = pairs.get(a)?;
                Some(if matches!(symbol, Symbol::Sin(..)) {
                    sine.clone()
                } else {
                    cosine.clone()
                })
            }
            Symbol::Exp(_) => powers.get(symbol).cloned(),
            _ => None,
        })
    }
}
