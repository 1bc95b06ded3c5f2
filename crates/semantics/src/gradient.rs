//! Numbers to first order: a value with its derivatives by some numbers of the point (forward automatic
//! differentiation).
//!
//! One evaluation of a term yields its value and its gradient, by the rules for sums, products, quotients and the
//! chain rule. Constants have no derivatives and cost as much as in the underlying arithmetic.

use crate::arithmetic::{Arithmetic, Comparison};
use crate::name::Name;
use crate::no_value::{NoValue, Undefined, Unknown, Work};
use std::cell::{Cell, RefCell};
use std::cmp::Ordering;
use std::collections::{BTreeMap, BTreeSet};
use std::rc::Rc;
use torse_numbers::Rational;

type Outcome<A> = Result<Gradient<<A as Arithmetic>::Number>, NoValue>;

/// A value with its derivatives. Cloning is cheap.
#[derive(Debug, Clone, PartialEq)]
pub struct Gradient<N> {
    /// The value.
    pub value: N,
    /// The derivatives; `None` for a constant.
    change: Option<Rc<Change<N>>>,
}

/// The derivatives of a value, and the variables by which a second derivative may be nonzero.
#[derive(Debug, Clone, PartialEq)]
struct Change<N> {
    /// The nonzero derivatives, in the order of the variables.
    rates: Vec<(Variable, N)>,
    /// The variables that occur nonlinearly, in order.
    curved: Vec<Variable>,
}

/// A variable, by its position in [`Gradients::names`].
type Variable = u32;

impl<N> Gradient<N> {
    /// A constant.
    pub fn constant(value: N) -> Self {
        Self {
            value,
            change: None,
        }
    }

    fn rates(&self) -> &[(Variable, N)] {
        self.change.as_ref().map_or(&[], |change| &change.rates)
    }

    fn curved(&self) -> &[Variable] {
        self.change.as_ref().map_or(&[], |change| &change.curved)
    }

    /// The variables by which the derivative is nonzero, in order.
    fn moving(&self) -> Vec<Variable> {
        self.rates().iter().map(|(variable, _)| *variable).collect()
    }

    /// All variables that occur, in order.
    fn variables(&self) -> Vec<Variable> {
        union(&self.moving(), self.curved())
    }
}

/// The union of two ordered lists, in order.
fn union(xs: &[Variable], ys: &[Variable]) -> Vec<Variable> {
    if ys.is_empty() {
        return xs.to_vec();
    }
    if xs.is_empty() {
        return ys.to_vec();
    }
    let mut all = [xs, ys].concat();
    all.sort_unstable();
    all.dedup();
    all
}

/// The arithmetic of numbers to first order over an arithmetic of values.
pub struct Gradients<A> {
    base: A,
    /// The names of the variables.
    names: RefCell<Vec<Name>>,
    /// Variables on which an index, a degree or an exponent depends; they must not be differentiated by.
    discrete: RefCell<BTreeSet<Variable>>,
    /// Whether two values that are not constant were multiplied.
    multiplied: Cell<bool>,
}

impl<A: Arithmetic> Gradients<A> {
    /// An arithmetic without variables.
    pub fn new(base: A) -> Self {
        Self {
            base,
            names: RefCell::default(),
            discrete: RefCell::default(),
            multiplied: Cell::default(),
        }
    }

    /// The variable of this name, with its value.
    pub fn variable(&self, name: &Name, value: A::Number) -> Gradient<A::Number> {
        let mut names = self.names.borrow_mut();
        let known = names.iter().position(|other| other == name);
        let position = known.unwrap_or_else(|| {
            names.push(name.clone());
            names.len() - 1
        });
        let variable = Variable::try_from(position).unwrap_or(Variable::MAX);
        Gradient {
            value,
            change: Some(Rc::new(Change {
                rates: vec![(variable, self.base.integer(1))],
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

    /// The nonzero derivatives of a value.
    pub fn rates(&self, gradient: &Gradient<A::Number>) -> BTreeMap<Name, A::Number> {
        let rates = gradient.rates().iter();
        let named =
            rates.filter_map(|(variable, rate)| Some((self.named(*variable)?, rate.clone())));
        named.collect()
    }

    /// The variables that occur nonlinearly in a value.
    pub fn curved(&self, gradient: &Gradient<A::Number>) -> BTreeSet<Name> {
        gradient
            .curved()
            .iter()
            .filter_map(|variable| self.named(*variable))
            .collect()
    }

    /// Whether two values that are not constant were multiplied. Then variables that occur linearly may not do so
    /// jointly.
    pub fn multiplied(&self) -> bool {
        self.multiplied.get()
    }

    /// The variables on which an index, a degree or an exponent depended.
    pub fn discrete(&self) -> BTreeSet<Name> {
        let discrete = self.discrete.borrow();
        discrete
            .iter()
            .filter_map(|variable| self.named(*variable))
            .collect()
    }

    /// `p x + q y` to first order, where p and q are the partial derivatives of an operation with this value.
    fn combined(
        &self,
        value: A::Number,
        (p, x): (&A::Number, &Gradient<A::Number>),
        (q, y): (&A::Number, &Gradient<A::Number>),
        curved: Vec<Variable>,
    ) -> Outcome<A> {
        // A zero factor contributes no derivatives.
        let counted = |factor: &A::Number, gradient: &'_ Gradient<A::Number>| {
            let none = self.base.is_zero(factor) == Some(true);
            if none { 0 } else { gradient.rates().len() }
        };
        let mut xs = x.rates().iter().take(counted(p, x)).peekable();
        let mut ys = y.rates().iter().take(counted(q, y)).peekable();
        let mut rates = Vec::with_capacity(xs.len().max(ys.len()));
        loop {
            let next = match (xs.peek(), ys.peek()) {
                (Some((x, _)), Some((y, _))) => x.cmp(y),
                (Some(_), None) => Ordering::Less,
                (None, Some(_)) => Ordering::Greater,
                (None, None) => break,
            };
            let with_x = xs.next_if(|_| next.is_le());
            let with_y = ys.next_if(|_| next.is_ge());
            match (with_x, with_y) {
                (Some((variable, with_x)), Some((_, with_y))) => {
                    let (with_x, with_y) = (self.base.times(p, with_x), self.base.times(q, with_y));
                    rates.push((*variable, self.base.plus(&with_x?, &with_y?)?));
                }
                (Some((variable, rate)), None) => {
                    rates.push((*variable, self.base.times(p, rate)?));
                }
                (None, Some((variable, rate))) => {
                    rates.push((*variable, self.base.times(q, rate)?));
                }
                (None, None) => {}
            }
        }
        Ok(Gradient {
            value,
            change: Some(Rc::new(Change { rates, curved })),
        })
    }

    /// The sum of two ordered lists of derivatives.
    fn sums(
        &self,
        xs: &[(Variable, A::Number)],
        ys: &[(Variable, A::Number)],
    ) -> Result<Vec<(Variable, A::Number)>, NoValue> {
        let mut all = Vec::with_capacity(xs.len().max(ys.len()));
        let (mut xs, mut ys) = (xs.iter().peekable(), ys.iter().peekable());
        loop {
            let next = match (xs.peek(), ys.peek()) {
                (Some((x, _)), Some((y, _))) => x.cmp(y),
                (Some(_), None) => Ordering::Less,
                (None, Some(_)) => Ordering::Greater,
                (None, None) => return Ok(all),
            };
            let x = xs.next_if(|_| next.is_le());
            let y = ys.next_if(|_| next.is_ge());
            match (x, y) {
                (Some((variable, x)), Some((_, y))) => {
                    all.push((*variable, self.base.plus(x, y)?));
                }
                (Some(only), None) | (None, Some(only)) => all.push(only.clone()),
                (None, None) => {}
            }
        }
    }

    /// The product of a constant factor and a number with this change; `value` is the value of the product.
    fn multiple(
        &self,
        value: A::Number,
        factor: &A::Number,
        change: &Change<A::Number>,
    ) -> Outcome<A> {
        let rates = if self.base.is_zero(factor) == Some(true) {
            vec![]
        } else {
            let mut rates = Vec::with_capacity(change.rates.len());
            for (variable, rate) in &change.rates {
                rates.push((*variable, self.base.times(factor, rate)?));
            }
            rates
        };
        let curved = change.curved.clone();
        Ok(Gradient {
            value,
            change: Some(Rc::new(Change { rates, curved })),
        })
    }

    /// The chain rule: a function with this value and this derivative, at x.
    fn chain(&self, value: A::Number, rate: &A::Number, x: &Gradient<A::Number>) -> Outcome<A> {
        let none = self.base.integer(0);
        let constant = Gradient::constant(none.clone());
        self.combined(value, (rate, x), (&none, &constant), x.variables())
    }
}

impl<A: Arithmetic> Arithmetic for Gradients<A> {
    type Number = Gradient<A::Number>;

    fn work(&self) -> &Work {
        self.base.work()
    }

    fn rational(&self, value: &Rational) -> Self::Number {
        Gradient::constant(self.base.rational(value))
    }

    fn integer(&self, n: i64) -> Self::Number {
        Gradient::constant(self.base.integer(n))
    }

    fn pi(&self) -> Self::Number {
        Gradient::constant(self.base.pi())
    }

    fn plus(&self, a: &Self::Number, b: &Self::Number) -> Outcome<A> {
        let value = self.base.plus(&a.value, &b.value)?;
        let change = match (&a.change, &b.change) {
            (Some(x), Some(y)) => Some(Rc::new(Change {
                rates: self.sums(&x.rates, &y.rates)?,
                curved: union(&x.curved, &y.curved),
            })),
            (only, None) | (None, only) => only.clone(),
        };
        Ok(Gradient { value, change })
    }

    fn negated(&self, a: &Self::Number) -> Self::Number {
        let negated = |change: &Rc<Change<A::Number>>| {
            let rates = change.rates.iter();
            let rates = rates.map(|(variable, rate)| (*variable, self.base.negated(rate)));
            Rc::new(Change {
                rates: rates.collect(),
                curved: change.curved.clone(),
            })
        };
        Gradient {
            value: self.base.negated(&a.value),
            change: a.change.as_ref().map(negated),
        }
    }

    fn times(&self, a: &Self::Number, b: &Self::Number) -> Outcome<A> {
        let value = self.base.times(&a.value, &b.value)?;
        match (&a.change, &b.change) {
            (Some(_), Some(_)) => {}
            (Some(change), None) => return self.multiple(value, &b.value, change),
            (None, Some(change)) => return self.multiple(value, &a.value, change),
            (None, None) => return Ok(Gradient::constant(value)),
        }
        self.multiplied.set(true);
        // A variable that occurs in both factors occurs nonlinearly in the product.
        let (mut shared, right) = (a.variables(), b.variables());
        shared.retain(|variable| right.binary_search(variable).is_ok());
        let curved = union(&union(a.curved(), b.curved()), &shared);
        self.combined(value, (&b.value, a), (&a.value, b), curved)
    }

    fn over(&self, a: &Self::Number, b: &Self::Number) -> Outcome<A> {
        let value = self.base.over(&a.value, &b.value)?;
        if a.change.is_none() && b.change.is_none() {
            return Ok(Gradient::constant(value));
        }
        // The derivatives of a/b are 1/b by a, and -(a/b)/b by b.
        let one = self.base.integer(1);
        let with_a = self.base.over(&one, &b.value)?;
        let with_b = self.base.negated(&self.base.over(&value, &b.value)?);
        let curved = union(a.curved(), &b.variables());
        self.combined(value, (&with_a, a), (&with_b, b), curved)
    }

    fn square_root(&self, a: &Self::Number) -> Outcome<A> {
        let root = self.base.square_root(&a.value)?;
        if a.change.is_none() {
            return Ok(Gradient::constant(root));
        }
        let twice = self.base.plus(&root, &root)?;
        let one = self.base.integer(1);
        let rate = self.base.over(&one, &twice)?;
        self.chain(root, &rate, a)
    }

    fn sine_cosine(&self, a: &Self::Number) -> Result<(Self::Number, Self::Number), NoValue> {
        let (sine, cosine) = self.base.sine_cosine(&a.value)?;
        if a.change.is_none() {
            return Ok((Gradient::constant(sine), Gradient::constant(cosine)));
        }
        let falling = self.base.negated(&sine);
        Ok((
            self.chain(sine.clone(), &cosine, a)?,
            self.chain(cosine.clone(), &falling, a)?,
        ))
    }

    fn exponential(&self, a: &Self::Number) -> Outcome<A> {
        let power = self.base.exponential(&a.value)?;
        if a.change.is_none() {
            return Ok(Gradient::constant(power));
        }
        self.chain(power.clone(), &power, a)
    }

    fn logarithm(&self, a: &Self::Number) -> Outcome<A> {
        let logarithm = self.base.logarithm(&a.value)?;
        if a.change.is_none() {
            return Ok(Gradient::constant(logarithm));
        }
        let rate = self.base.over(&self.base.integer(1), &a.value)?;
        self.chain(logarithm, &rate, a)
    }

    fn arctangent(&self, a: &Self::Number) -> Outcome<A> {
        let arc = self.base.arctangent(&a.value)?;
        if a.change.is_none() {
            return Ok(Gradient::constant(arc));
        }
        let one = self.base.integer(1);
        let below = self
            .base
            .plus(&one, &self.base.times(&a.value, &a.value)?)?;
        let rate = self.base.over(&one, &below)?;
        self.chain(arc, &rate, a)
    }

    fn arcsine(&self, a: &Self::Number) -> Outcome<A> {
        let arc = self.base.arcsine(&a.value)?;
        if a.change.is_none() {
            return Ok(Gradient::constant(arc));
        }
        let (_, cosine) = self.base.sine_cosine(&arc)?;
        let rate = self.base.over(&self.base.integer(1), &cosine)?;
        self.chain(arc, &rate, a)
    }

    /// The greater one, with its derivatives. Where both are equal there are none.
    fn greater(&self, a: &Self::Number, b: &Self::Number) -> Outcome<A> {
        let value = self.base.greater(&a.value, &b.value)?;
        if a.change.is_none() && b.change.is_none() {
            return Ok(Gradient::constant(value));
        }
        let taken = match self.base.compare(&a.value, &b.value)? {
            Comparison::Greater => a,
            Comparison::Less => b,
            Comparison::Equal => return Err(Undefined::NotDifferentiable.into()),
            Comparison::Apart | Comparison::Near | Comparison::Open => {
                return Err(Unknown::Precision.into());
            }
        };
        // All variables are where it bends.
        let rates = taken.rates().to_vec();
        let curved = union(&a.variables(), &b.variables());
        Ok(Gradient {
            value,
            change: Some(Rc::new(Change { rates, curved })),
        })
    }

    /// Whether the value is zero for all values of the variables; `None` if it is zero at this point only.
    fn is_zero(&self, a: &Self::Number) -> Option<bool> {
        match self.base.is_zero(&a.value) {
            Some(true) if a.change.is_some() => None,
            known => known,
        }
    }

    fn as_rational(&self, a: &Self::Number) -> Option<Rational> {
        let rational = self.base.as_rational(&a.value)?;
        self.discrete.borrow_mut().extend(a.variables());
        Some(rational)
    }

    fn bit_length(&self, a: &Self::Number) -> Option<u64> {
        self.base.bit_length(&a.value)
    }
}
