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
use std::rc::Rc;
use torse_numbers::Rational;

/// A value, and how it changes with some numbers. A copy costs little.
#[derive(Debug, Clone, PartialEq)]
pub struct Gradient {
    /// The value.
    pub value: Real,
    /// How it changes; nothing for what is constant.
    change: Option<Rc<Change>>,
}

/// How fast a value changes with each number, and by which numbers a second derivative may not be zero.
#[derive(Debug, Clone, PartialEq, Default)]
struct Change {
    /// The rates that are not zero, in the order of the numbers.
    rates: Vec<(Variable, Real)>,
    /// The numbers that do not occur linearly, in order.
    curved: Vec<Variable>,
}

/// A number of the point, by its position in [`Gradients::names`].
type Variable = u32;

impl From<Real> for Gradient {
    fn from(value: Real) -> Self {
        Self {
            value,
            change: None,
        }
    }
}

impl Gradient {
    fn rates(&self) -> &[(Variable, Real)] {
        self.change.as_ref().map_or(&[], |change| &change.rates)
    }

    fn curved(&self) -> &[Variable] {
        self.change.as_ref().map_or(&[], |change| &change.curved)
    }

    /// The numbers with a rate, in order.
    fn moving(&self) -> Vec<Variable> {
        self.rates().iter().map(|(variable, _)| *variable).collect()
    }

    fn rate(&self, variable: Variable) -> Option<&Real> {
        let rates = self.rates();
        let found = rates.binary_search_by_key(&variable, |(own, _)| *own);
        rates.get(found.ok()?).map(|(_, rate)| rate)
    }

    /// Every number that occurs, in order.
    fn variables(&self) -> Vec<Variable> {
        union(&self.moving(), self.curved())
    }
}

/// All of two ordered lists, in order.
fn union(xs: &[Variable], ys: &[Variable]) -> Vec<Variable> {
    if ys.is_empty() {
        return xs.to_vec();
    }
    let mut all = [xs, ys].concat();
    all.sort_unstable();
    all.dedup();
    all
}

/// The arithmetic of numbers to first order.
pub struct Gradients<'a> {
    reals: Reals<'a>,
    /// The numbers that values change with.
    names: RefCell<Vec<Name>>,
    /// Numbers that an index, a degree or an exponent depends on: they have no rates.
    discrete: RefCell<BTreeSet<Variable>>,
}

impl<'a> Gradients<'a> {
    /// An arithmetic in which nothing changes yet.
    pub fn new(reals: Reals<'a>) -> Self {
        Self {
            reals,
            names: RefCell::default(),
            discrete: RefCell::default(),
        }
    }

    /// The number of this name, which has this value and may change.
    pub fn variable(&self, name: &Name, value: Real) -> Gradient {
        let mut names = self.names.borrow_mut();
        let known = names.iter().position(|other| other == name);
        let position = known.unwrap_or_else(|| {
            names.push(name.clone());
            names.len() - 1
        });
        let variable = Variable::try_from(position).unwrap_or(Variable::MAX);
        let one = Rational::from_integer(1.into());
        Gradient {
            value,
            change: Some(Rc::new(Change {
                rates: vec![(variable, one.into())],
                curved: vec![],
            })),
        }
    }

    fn named(&self, variable: Variable) -> Option<Name> {
        self.names
            .borrow()
            .get(usize::try_from(variable).ok()?)
            .cloned()
    }

    /// The rates of a value that are not zero.
    pub fn rates(&self, of: &Gradient) -> BTreeMap<Name, Real> {
        let rates = of.rates().iter();
        let named =
            rates.filter_map(|(variable, rate)| Some((self.named(*variable)?, rate.clone())));
        named.collect()
    }

    /// The numbers that do not occur linearly in a value.
    pub fn curved(&self, of: &Gradient) -> BTreeSet<Name> {
        of.curved()
            .iter()
            .filter_map(|variable| self.named(*variable))
            .collect()
    }

    /// Numbers that an index, a degree or an exponent depended on.
    pub fn discrete(&self) -> BTreeSet<Name> {
        let discrete = self.discrete.borrow();
        discrete
            .iter()
            .filter_map(|variable| self.named(*variable))
            .collect()
    }

    /// `p x + q y` to first order, where p and q are the rates of an operation with this value.
    fn combined(
        &self,
        value: Real,
        (p, x): (&Real, &Gradient),
        (q, y): (&Real, &Gradient),
        curved: Vec<Variable>,
    ) -> Result<Gradient, Gap> {
        let scaled = |factor: &Real, of: &Gradient, variable: Variable| {
            let rate = of.rate(variable)?;
            (self.reals.is_zero(factor) != Some(true)).then(|| self.reals.times(factor, rate))
        };
        let mut rates = vec![];
        for variable in union(&x.moving(), &y.moving()) {
            let (with_x, with_y) = (scaled(p, x, variable), scaled(q, y, variable));
            let rate = match (with_x.transpose()?, with_y.transpose()?) {
                (Some(with_x), Some(with_y)) => self.reals.plus(&with_x, &with_y)?,
                (Some(rate), None) | (None, Some(rate)) => rate,
                (None, None) => continue,
            };
            rates.push((variable, rate));
        }
        Ok(Gradient {
            value,
            change: Some(Rc::new(Change { rates, curved })),
        })
    }

    /// A function with this value and this rate, at x.
    fn chain(&self, value: Real, rate: &Real, x: &Gradient) -> Result<Gradient, Gap> {
        let none = Real::from(Rational::zero());
        let constant = Gradient::from(none.clone());
        self.combined(value, (rate, x), (&none, &constant), x.variables())
    }
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
        if a.change.is_none() && b.change.is_none() {
            return Ok(value.into());
        }
        let one = Real::from(Rational::from_integer(1.into()));
        self.combined(value, (&one, a), (&one, b), union(a.curved(), b.curved()))
    }

    fn negated(&self, a: &Gradient) -> Gradient {
        let negated = |change: &Rc<Change>| {
            let rates = change.rates.iter();
            let rates = rates.map(|(variable, rate)| (*variable, self.reals.negated(rate)));
            Rc::new(Change {
                rates: rates.collect(),
                curved: change.curved.clone(),
            })
        };
        Gradient {
            value: self.reals.negated(&a.value),
            change: a.change.as_ref().map(negated),
        }
    }

    fn times(&self, a: &Gradient, b: &Gradient) -> Result<Gradient, Gap> {
        let value = self.reals.times(&a.value, &b.value)?;
        if a.change.is_none() && b.change.is_none() {
            return Ok(value.into());
        }
        // What occurs on both sides does not occur linearly in the product.
        let (mut shared, right) = (a.variables(), b.variables());
        shared.retain(|variable| right.binary_search(variable).is_ok());
        let curved = union(&union(a.curved(), b.curved()), &shared);
        self.combined(value, (&b.value, a), (&a.value, b), curved)
    }

    fn over(&self, a: &Gradient, b: &Gradient) -> Result<Gradient, Gap> {
        let value = self.reals.over(&a.value, &b.value)?;
        if a.change.is_none() && b.change.is_none() {
            return Ok(value.into());
        }
        // a/b changes by 1/b with a and by -(a/b)/b with b.
        let one = Real::from(Rational::from_integer(1.into()));
        let with_a = self.reals.over(&one, &b.value)?;
        let with_b = self.reals.negated(&self.reals.over(&value, &b.value)?);
        let curved = union(a.curved(), &b.variables());
        self.combined(value, (&with_a, a), (&with_b, b), curved)
    }

    fn square_root(&self, a: &Gradient) -> Result<Gradient, Gap> {
        let root = self.reals.square_root(&a.value)?;
        if a.change.is_none() {
            return Ok(root.into());
        }
        let twice = self.reals.plus(&root, &root)?;
        let one = Real::from(Rational::from_integer(1.into()));
        let rate = self.reals.over(&one, &twice)?;
        self.chain(root, &rate, a)
    }

    fn sine_cosine(&self, a: &Gradient) -> Result<(Gradient, Gradient), Gap> {
        let (sine, cosine) = self.reals.sine_cosine(&a.value)?;
        if a.change.is_none() {
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
            Some(true) if a.change.is_some() => None,
            known => known,
        }
    }

    fn as_rational(&self, a: &Gradient) -> Option<Rational> {
        let rational = self.reals.as_rational(&a.value)?;
        self.discrete.borrow_mut().extend(a.variables());
        Some(rational)
    }

    fn bit_length(&self, a: &Gradient) -> Option<u64> {
        self.reals.bit_length(&a.value)
    }
}
