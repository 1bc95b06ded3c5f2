//! Fractions of polynomials that record what they were divided by.
//!
//! The denominator is kept as a product of primitive factors with exponents: sums use the least common
//! multiple of the factor lists, and a factor cancels when it divides the numerator exactly. Every
//! divisor ever used stays in [`Fraction::conditions`], even after it cancels: the value is known only
//! where none of them vanishes, and a verdict must say so.
//!
//! **Theorem.** The polynomial ring modulo its relations is an integral domain, so a fraction is zero
//! wherever it is defined if and only if its numerator has no terms.

use crate::affine::Affine;
use crate::polynomial::Polynomial;
use crate::rational::Rational;
use crate::scalar::{ExactError, Scalar, ZeroTest};
use crate::symbol::Symbol;
use std::collections::BTreeMap;
use std::fmt;
use std::ops::{Add, Mul, Neg, Sub};

/// `numerator / product of factors`, with the conditions under which it is defined.
#[derive(Clone, Debug)]
pub struct Fraction {
    numerator: Polynomial,
    /// Primitive nonconstant factors and their exponents.
    denominator: BTreeMap<Polynomial, u32>,
    /// Everything that was divided by, primitive: each must not vanish.
    conditions: Vec<Polynomial>,
}

impl Fraction {
    /// Zero.
    #[must_use]
    pub fn zero() -> Self {
        Polynomial::zero().into()
    }

    /// An integer.
    #[must_use]
    pub fn integer(value: i64) -> Self {
        Polynomial::integer(value).into()
    }

    /// A single symbol.
    #[must_use]
    pub fn symbol(symbol: Symbol) -> Self {
        Polynomial::symbol(symbol).into()
    }

    /// The symbol with this name.
    #[must_use]
    pub fn named(name: &str) -> Self {
        Polynomial::named(name).into()
    }

    /// The numerator.
    #[must_use]
    pub fn numerator(&self) -> &Polynomial {
        &self.numerator
    }

    /// The factors of the denominator with their exponents; empty for a polynomial.
    pub fn denominator_factors(&self) -> impl Iterator<Item = (&Polynomial, u32)> {
        self.denominator
            .iter()
            .map(|(factor, exponent)| (factor, *exponent))
    }

    /// The denominator multiplied out.
    #[must_use]
    pub fn denominator(&self) -> Polynomial {
        product(&self.denominator)
    }

    /// The divisors that were used on the way here, primitive and in order; none may vanish.
    #[must_use]
    pub fn conditions(&self) -> &[Polynomial] {
        &self.conditions
    }

    /// Whether this is zero wherever it is defined.
    #[must_use]
    pub fn is_zero(&self) -> bool {
        self.numerator.is_zero()
    }

    /// The polynomial, if there is no denominator.
    #[must_use]
    pub fn as_polynomial(&self) -> Option<&Polynomial> {
        self.denominator.is_empty().then_some(&self.numerator)
    }

    /// The rational number, if no symbol occurs.
    #[must_use]
    pub fn as_rational(&self) -> Option<Rational> {
        self.as_polynomial().and_then(Polynomial::as_constant)
    }

    /// The symbols that occur, ascending, without repetition.
    #[must_use]
    pub fn symbols(&self) -> Vec<Symbol> {
        let mut all: Vec<Symbol> = self
            .denominator
            .keys()
            .chain(std::iter::once(&self.numerator))
            .flat_map(|p| p.symbols().iter().cloned())
            .collect();
        all.sort();
        all.dedup();
        all
    }

    /// `self / divisor`, recording the divisor.
    ///
    /// # Errors
    /// [`ExactError::DivisionByZero`] when the divisor is the zero function.
    ///
    /// ```
    /// use torse_algebra::Fraction;
    /// let (x, y) = (Fraction::named("x"), Fraction::named("y"));
    /// let quotient = (x.clone() * y.clone()).over(&y).unwrap();
    /// assert_eq!(quotient.to_string(), "x");
    /// assert_eq!(quotient.conditions()[0].to_string(), "y"); // cancelled, not forgotten
    /// ```
    pub fn over(&self, divisor: &Self) -> Result<Self, ExactError> {
        if divisor.is_zero() {
            return Err(ExactError::DivisionByZero {
                divisor: divisor.to_string(),
            });
        }
        let mut result = self.clone();
        result.conditions = merged(&self.conditions, &divisor.conditions);
        result.numerator = &result.numerator * &divisor.denominator();
        let (content, factors) = self.factors_of(&divisor.numerator);
        result.numerator = result.numerator.scaled(&content.recip());
        for (factor, exponent) in factors {
            result.conditions = merged(&result.conditions, std::slice::from_ref(&factor));
            *result.denominator.entry(factor).or_insert(0) += exponent;
        }
        Ok(result.cancelled())
    }

    /// Splits a nonzero polynomial into its content and primitive factors, by single symbols and by the
    /// factors this fraction's denominator already has.
    fn factors_of(&self, p: &Polynomial) -> (Rational, BTreeMap<Polynomial, u32>) {
        let (content, mut rest) = p.primitive();
        let mut factors = BTreeMap::new();
        let symbols = rest.symbols().to_vec();
        let known = symbols
            .into_iter()
            .map(Polynomial::symbol)
            .chain(self.denominator.keys().cloned());
        for candidate in known.collect::<Vec<_>>() {
            while rest.as_constant().is_none()
                && let Some(quotient) = rest.exact_quotient(&candidate)
            {
                *factors.entry(candidate.clone()).or_insert(0) += 1;
                rest = quotient;
            }
        }
        // A leftover constant can only be a unit of the primitive part.
        let (more, rest) = rest.primitive();
        if rest.as_constant().is_none() {
            *factors.entry(rest).or_insert(0) += 1;
        }
        (content * more, factors)
    }

    /// Cancels denominator factors that divide the numerator, wholly or in part.
    fn cancelled(mut self) -> Self {
        if self.numerator.is_zero() {
            self.denominator.clear();
            return self;
        }
        let mut reduced = BTreeMap::new();
        let mut pending: Vec<(Polynomial, u32)> =
            std::mem::take(&mut self.denominator).into_iter().collect();
        while let Some((factor, mut exponent)) = pending.pop() {
            while exponent > 0
                && let Some(quotient) = self.numerator.exact_quotient(&factor)
            {
                self.numerator = quotient;
                exponent -= 1;
            }
            if exponent == 0 {
                continue;
            }
            let common = factor.gcd(&self.numerator);
            match factor.exact_quotient(&common) {
                Some(rest) if common.as_constant().is_none() && rest.as_constant().is_none() => {
                    pending.push((common, exponent));
                    pending.push((rest.primitive().1, exponent));
                    let content = rest.primitive().0;
                    self.numerator = self
                        .numerator
                        .scaled(&num_traits::pow(content.recip(), exponent as usize));
                }
                _ => *reduced.entry(factor).or_insert(0) += exponent,
            }
        }
        self.denominator = reduced;
        self
    }

    /// The derivative by the variable `name`.
    #[must_use]
    pub fn derivative(&self, name: &str) -> Self {
        // (n / prod f^e)' = n' / prod f^e - sum e n f' / (f prod f^e)
        let part = |numerator: Polynomial, denominator| Self {
            numerator,
            denominator,
            conditions: self.conditions.clone(),
        };
        let mut total = part(self.numerator.derivative(name), self.denominator.clone()).cancelled();
        for (factor, exponent) in &self.denominator {
            let rate = factor.derivative(name);
            if rate.is_zero() {
                continue;
            }
            let mut denominator = self.denominator.clone();
            *denominator.entry(factor.clone()).or_insert(0) += 1;
            let numerator =
                (&self.numerator * &rate).scaled(&crate::rational::integer(i64::from(*exponent)));
            total = total - part(numerator, denominator).cancelled();
        }
        total
    }

    /// The fraction with each symbol for which `value` answers replaced by that fraction.
    ///
    /// # Errors
    /// [`ExactError::DivisionByZero`] when a denominator vanishes under the replacement.
    pub fn substituted(
        &self,
        value: impl Fn(&Symbol) -> Option<Fraction>,
    ) -> Result<Self, ExactError> {
        if !self.symbols().iter().any(|s| value(s).is_some()) && self.conditions.is_empty() {
            return Ok(self.clone());
        }
        let replace = |p: &Polynomial| -> Self { p.replaced(&Self::zero(), &value) };
        let mut result = replace(&self.numerator);
        for (factor, exponent) in &self.denominator {
            let divisor = replace(factor);
            for _ in 0..*exponent {
                result = result.over(&divisor)?;
            }
        }
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

    /// The integer-affine form that the fraction is, such as `m - 2`: what can stand in an index.
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

    /// The fraction with the variable `name` at `value` wherever it stands: by itself, under sine and cosine, in
    /// the indices of members of families, and in the recorded conditions.
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
    /// [`ExactError::NoExactTurn`] when the sine and cosine at `value` are not exact here;
    /// [`ExactError::NoIndex`] when the variable stands in an index where `value` cannot;
    /// [`ExactError::DivisionByZero`] when a denominator vanishes there.
    pub fn at(&self, name: &str, value: &Fraction) -> Result<Self, ExactError> {
        let mut present = self.symbols();
        present.extend(self.conditions.iter().flat_map(|p| p.symbols().to_vec()));
        let uses_pair = |angle| {
            present.iter().any(|s| matches!(s, Symbol::Sin(v, a) | Symbol::Cos(v, a) if &**v == name && *a == angle))
        };
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
        let turn = if uses_pair(crate::symbol::Angle::QuarterTurn) {
            Some(value.quarter_turn()?)
        } else {
            None
        };
        let radian = if uses_pair(crate::symbol::Angle::Radian) {
            Some(value.sine_cosine()?)
        } else {
            None
        };
        self.substituted(|symbol| match symbol {
            Symbol::Named(v) if &**v == name => Some(value.clone()),
            Symbol::Indexed(family, index) if symbol.depends_on(name) => {
                let form = form.as_ref()?;
                let index = index.iter().map(|i| i.substituted(name, form)).collect();
                Some(Self::symbol(Symbol::Indexed(family.clone(), index)))
            }
            Symbol::Sin(v, a) | Symbol::Cos(v, a) if &**v == name => {
                let (sine, cosine) = match a {
                    crate::symbol::Angle::QuarterTurn => turn.clone()?,
                    crate::symbol::Angle::Radian => radian.clone()?,
                };
                Some(if matches!(symbol, Symbol::Sin(..)) {
                    sine
                } else {
                    cosine
                })
            }
            _ => None,
        })
    }

    /// `(sin(self), cos(self))` with `self` in radians; see [`Polynomial::sine_cosine`].
    ///
    /// # Errors
    /// [`ExactError::NoExactTurn`] when the pair is not exact here.
    pub fn sine_cosine(&self) -> Result<(Self, Self), ExactError> {
        let polynomial = self
            .as_polynomial()
            .ok_or_else(|| ExactError::NoExactTurn {
                argument: self.to_string(),
            })?;
        let (sine, cosine) = polynomial.sine_cosine()?;
        Ok((sine.into(), cosine.into()))
    }

    /// `self` to an integer power.
    ///
    /// # Errors
    /// [`ExactError::DivisionByZero`] for a negative power of zero.
    pub fn power(&self, exponent: i32) -> Result<Self, ExactError> {
        let mut result = Self::integer(1);
        let (mut base, mut rest) = (self.clone(), exponent.unsigned_abs());
        while rest > 0 {
            if rest % 2 == 1 {
                result = result * base.clone();
            }
            rest /= 2;
            if rest > 0 {
                base = base.clone() * base;
            }
        }
        if exponent < 0 {
            Self::integer(1).over(&result)
        } else {
            Ok(result)
        }
    }

    /// The same value with nothing recorded but its denominator: for a value that is known where its divisors vanish, too.
    #[must_use]
    pub fn without_conditions(mut self) -> Self {
        self.conditions = self.denominator.keys().cloned().collect();
        self
    }

    /// The same value with `conditions` recorded as well (primitive, nonconstant ones are kept).
    #[must_use]
    pub fn under(mut self, conditions: &[Polynomial]) -> Self {
        self.conditions = merged(&self.conditions, conditions);
        self
    }
}

/// The product of factors with exponents.
fn product(factors: &BTreeMap<Polynomial, u32>) -> Polynomial {
    factors
        .iter()
        .fold(Polynomial::integer(1), |p, (factor, exponent)| {
            &p * &factor.power(*exponent)
        })
}

/// The union of two sorted lists of conditions.
fn merged(a: &[Polynomial], b: &[Polynomial]) -> Vec<Polynomial> {
    if b.is_empty() {
        return a.to_vec();
    }
    let mut all: Vec<Polynomial> = a
        .iter()
        .chain(b)
        .filter(|p| p.as_constant().is_none())
        .cloned()
        .collect();
    all.sort();
    all.dedup();
    all
}

fn sum(a: &Fraction, b: &Fraction) -> Fraction {
    let conditions = merged(&a.conditions, &b.conditions);
    if a.denominator == b.denominator {
        let numerator = &a.numerator + &b.numerator;
        let result = Fraction {
            numerator,
            denominator: a.denominator.clone(),
            conditions,
        };
        return if result.denominator.is_empty() {
            result
        } else {
            result.cancelled()
        };
    }
    let mut denominator = a.denominator.clone();
    for (factor, exponent) in &b.denominator {
        let entry = denominator.entry(factor.clone()).or_insert(0);
        *entry = (*entry).max(*exponent);
    }
    let missing = |own: &BTreeMap<Polynomial, u32>| {
        denominator
            .iter()
            .fold(Polynomial::integer(1), |p, (factor, exponent)| {
                &p * &factor.power(exponent - own.get(factor).copied().unwrap_or(0))
            })
    };
    let numerator =
        &(&a.numerator * &missing(&a.denominator)) + &(&b.numerator * &missing(&b.denominator));
    Fraction {
        numerator,
        denominator,
        conditions,
    }
    .cancelled()
}

impl Add for Fraction {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        sum(&self, &other)
    }
}

impl Neg for Fraction {
    type Output = Self;
    fn neg(mut self) -> Self {
        self.numerator = -self.numerator;
        self
    }
}

impl Sub for Fraction {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        sum(&self, &-other)
    }
}

impl Mul for Fraction {
    type Output = Self;
    fn mul(self, other: Self) -> Self {
        let mut denominator = self.denominator;
        for (factor, exponent) in other.denominator {
            *denominator.entry(factor).or_insert(0) += exponent;
        }
        let conditions = merged(&self.conditions, &other.conditions);
        let result = Self {
            numerator: &self.numerator * &other.numerator,
            denominator,
            conditions,
        };
        if result.denominator.is_empty() {
            result
        } else {
            result.cancelled()
        }
    }
}

/// Equality of values where both are defined; conditions do not count.
impl PartialEq for Fraction {
    fn eq(&self, other: &Self) -> bool {
        (self.clone() - other.clone()).is_zero()
    }
}

impl From<Polynomial> for Fraction {
    fn from(numerator: Polynomial) -> Self {
        Self {
            numerator,
            denominator: BTreeMap::new(),
            conditions: vec![],
        }
    }
}

impl From<Rational> for Fraction {
    fn from(value: Rational) -> Self {
        Polynomial::from(value).into()
    }
}

impl Scalar for Fraction {
    fn constant(&self, q: &Rational) -> Self {
        q.clone().into()
    }

    fn divided_by(&self, divisor: &Self) -> Result<Self, ExactError> {
        self.over(divisor)
    }

    fn quarter_turn(&self) -> Result<(Self, Self), ExactError> {
        let polynomial = self
            .as_polynomial()
            .ok_or_else(|| ExactError::NoExactTurn {
                argument: self.to_string(),
            })?;
        let (sine, cosine) = Scalar::quarter_turn(polynomial)?;
        Ok((sine.into(), cosine.into()))
    }

    fn pi_like(&self) -> Result<Self, ExactError> {
        Ok(Self::symbol(Symbol::Pi))
    }

    fn scaled(&self, q: &Rational) -> Self {
        let numerator = self.numerator.scaled(q);
        Self {
            numerator,
            ..self.clone()
        }
        .cancelled_if_zero()
    }
}

impl Fraction {
    fn cancelled_if_zero(mut self) -> Self {
        if self.numerator.is_zero() {
            self.denominator.clear();
        }
        self
    }
}

impl ZeroTest for Fraction {
    fn is_known_zero(&self) -> bool {
        self.is_zero()
    }

    fn is_known_nonzero(&self) -> bool {
        !self.is_zero()
    }
}

impl fmt::Display for Fraction {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let grouped = |p: &Polynomial| {
            if p.len() > 1 {
                format!("({p})")
            } else {
                p.to_string()
            }
        };
        if self.denominator.is_empty() {
            return write!(f, "{}", self.numerator);
        }
        let factors: Vec<String> = self
            .denominator
            .iter()
            .map(|(factor, exponent)| match exponent {
                1 => grouped(factor),
                _ => format!("{}^{exponent}", grouped(factor)),
            })
            .collect();
        let one_plain = self.denominator.len() == 1
            && self
                .denominator
                .iter()
                .all(|(p, _)| p.len() > 1 || p.total_degree() == 1);
        let below = factors.join("*");
        write!(
            f,
            "{}/{}",
            grouped(&self.numerator),
            if one_plain {
                below
            } else {
                format!("({below})")
            }
        )
    }
}
