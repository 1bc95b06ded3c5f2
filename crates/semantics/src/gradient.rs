//! Numbers to first order: a value together with its rates of change by some numbers of the point.
//!
//! One evaluation of a term gives its value and its gradient, by the rules of the sum, the product, the quotient and
//! the chain. Numbers that nothing changes have no rates and cost what they cost in [`Reals`].

use crate::arithmetic::Arithmetic;
use crate::gap::Gap;
use crate::name::Name;
use crate::real::{Real, Reals};
use num_traits::Zero;
use std::cell::RefCell;
use std::collections::{BTreeMap, BTreeSet};
use torse_numbers::Rational;

/// A value, how fast it changes with each number, and by which numbers a second derivative may not be zero.
#[derive(Debug, Clone, PartialEq)]
pub struct Gradient {
    /// The value.
    pub value: Real,
    /// The rates that are not zero.
    pub rates: BTreeMap<Name, Real>,
    /// The numbers that do not occur linearly.
    pub curved: BTreeSet<Name>,
}

impl From<Real> for Gradient {
    fn from(value: Real) -> Self {
        Self {
            value,
            rates: BTreeMap::new(),
            curved: BTreeSet::new(),
        }
    }
}

impl Gradient {
    /// The number of this name, which has this value.
    pub fn of(name: Name, value: Real) -> Self {
        let one = Rational::from_integer(1.into());
        Self {
            value,
            rates: BTreeMap::from([(name, one.into())]),
            curved: BTreeSet::new(),
        }
    }

    fn is_constant(&self) -> bool {
        self.rates.is_empty() && self.curved.is_empty()
    }
}

/// The arithmetic of numbers to first order.
pub struct Gradients<'a> {
    pub reals: Reals<'a>,
    /// Numbers that an index, a degree or an exponent depends on: they have no rates.
    pub discrete: RefCell<BTreeSet<Name>>,
}

impl Gradients<'_> {
    /// `p x + q y` to first order, where p and q are the rates of an operation with this value.
    fn combined(
        &self,
        value: Real,
        (p, x): (&Real, &Gradient),
        (q, y): (&Real, &Gradient),
        curved: BTreeSet<Name>,
    ) -> Result<Gradient, Gap> {
        let mut rates = BTreeMap::new();
        for (factor, of) in [(p, x), (q, y)] {
            if self.reals.is_zero(factor) == Some(true) {
                continue;
            }
            for (name, rate) in &of.rates {
                let rate = self.reals.times(factor, rate)?;
                let sum = match rates.get(name) {
                    Some(other) => self.reals.plus(other, &rate)?,
                    None => rate,
                };
                rates.insert(name.clone(), sum);
            }
        }
        Ok(Gradient {
            value,
            rates,
            curved,
        })
    }

    /// A function with this value and this rate, at x.
    fn chain(&self, value: Real, rate: &Real, x: &Gradient) -> Result<Gradient, Gap> {
        let none = Real::from(Rational::zero());
        let constant = Gradient::from(none.clone());
        self.combined(value, (rate, x), (&none, &constant), names(x))
    }
}

/// Every number that occurs.
fn names(x: &Gradient) -> BTreeSet<Name> {
    x.rates.keys().chain(&x.curved).cloned().collect()
}

fn both(x: &Gradient, y: &Gradient) -> BTreeSet<Name> {
    x.curved.union(&y.curved).cloned().collect()
}

impl Arithmetic for Gradients<'_> {
    type Number = Gradient;

    fn rational(&self, value: &Rational) -> Gradient {
        self.reals.rational(value).into()
    }

    fn pi(&self) -> Gradient {
        self.reals.pi().into()
    }

    fn plus(&self, a: &Gradient, b: &Gradient) -> Result<Gradient, Gap> {
        let value = self.reals.plus(&a.value, &b.value)?;
        if a.is_constant() && b.is_constant() {
            return Ok(value.into());
        }
        let one = Real::from(Rational::from_integer(1.into()));
        self.combined(value, (&one, a), (&one, b), both(a, b))
    }

    fn negated(&self, a: &Gradient) -> Gradient {
        let negated = |(name, rate): (&Name, &Real)| (name.clone(), self.reals.negated(rate));
        Gradient {
            value: self.reals.negated(&a.value),
            rates: a.rates.iter().map(negated).collect(),
            curved: a.curved.clone(),
        }
    }

    fn times(&self, a: &Gradient, b: &Gradient) -> Result<Gradient, Gap> {
        let value = self.reals.times(&a.value, &b.value)?;
        if a.is_constant() && b.is_constant() {
            return Ok(value.into());
        }
        let (left, right) = (names(a), names(b));
        let mut curved = both(a, b);
        curved.extend(left.intersection(&right).cloned());
        self.combined(value, (&b.value, a), (&a.value, b), curved)
    }

    fn over(&self, a: &Gradient, b: &Gradient) -> Result<Gradient, Gap> {
        let value = self.reals.over(&a.value, &b.value)?;
        if a.is_constant() && b.is_constant() {
            return Ok(value.into());
        }
        // a/b changes by 1/b with a and by -(a/b)/b with b.
        let one = Real::from(Rational::from_integer(1.into()));
        let with_a = self.reals.over(&one, &b.value)?;
        let with_b = self.reals.negated(&self.reals.over(&value, &b.value)?);
        let mut curved = both(a, b);
        curved.extend(names(b));
        self.combined(value, (&with_a, a), (&with_b, b), curved)
    }

    fn square_root(&self, a: &Gradient) -> Result<Gradient, Gap> {
        let root = self.reals.square_root(&a.value)?;
        if a.is_constant() {
            return Ok(root.into());
        }
        let twice = self.reals.plus(&root, &root)?;
        let one = Real::from(Rational::from_integer(1.into()));
        let rate = self.reals.over(&one, &twice)?;
        self.chain(root, &rate, a)
    }

    fn sine_cosine(&self, a: &Gradient) -> Result<(Gradient, Gradient), Gap> {
        let (sine, cosine) = self.reals.sine_cosine(&a.value)?;
        if a.is_constant() {
            return Ok((sine.into(), cosine.into()));
        }
        let falling = self.reals.negated(&sine);
        Ok((
            self.chain(sine.clone(), &cosine, a)?,
            self.chain(cosine.clone(), &falling, a)?,
        ))
    }

    /// Whether the value is zero whatever the numbers are; `None` where it is zero at the point alone.
    fn is_zero(&self, a: &Gradient) -> Option<bool> {
        match self.reals.is_zero(&a.value) {
            Some(true) if !a.is_constant() => None,
            known => known,
        }
    }

    fn as_rational(&self, a: &Gradient) -> Option<Rational> {
        let rational = self.reals.as_rational(&a.value)?;
        self.discrete.borrow_mut().extend(names(a));
        Some(rational)
    }

    fn bit_length(&self, a: &Gradient) -> Option<u64> {
        self.reals.bit_length(&a.value)
    }
}
