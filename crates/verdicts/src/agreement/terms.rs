//! The value of a core term at random residues: one rule for each construct, as `derivations/SEMANTICS.md` states it.
//!
//! A [`Scope`] holds the values of bound variables; the point supplies declared symbols. All parts are evaluated before
//! the whole, so a term with an undefined part is undefined. A definition that depends on no binder is evaluated once,
//! and so is a basis at the same arguments.

use super::scope::Scope;
use std::cell::{Cell, RefCell};
use std::collections::BTreeMap;
use std::ops::RangeInclusive;
use std::rc::Rc;
use std::sync::Arc;
use torse_algebra::rational::integer;
use torse_algebra::{Affine, Rational};
use torse_core::{BuiltIn, Claim, Node, Points, Term, Variable, stack};
use torse_semantics::{
    Arithmetic, Class, Name, NoValue, Scrambled, Series, Undefined, Unknown, Value,
};
use torse_syntax::formula::Operator;

/// Maximum depth of nested terms: as deep as the parser accepts.
const MAX_DEPTH: usize = 80 * 300;
/// Maximum number of terms of a sum.
const MAX_TERMS: i64 = 4000;
/// Maximum exponent, and maximum order of a derivative.
const MAX_EXPONENT: u64 = 2000;
const MAX_ORDER: i64 = 40;
/// Maximum number of cached derivatives.
const MAX_RATES: usize = 48;

pub(super) type Outcome = Result<Value<Class>, NoValue>;
pub(super) type Number = Result<Series<Class>, NoValue>;

/// The functions of one basis at one degree and one tuple of arguments.
pub(super) type Row = (
    ((usize, usize), i64, Vec<Value<Class>>),
    Rc<[Series<Class>]>,
);

/// A derivative: its body, order and place. The body is kept.
type Rate = (((usize, usize), i64, Series<Class>), Term, Value<Class>);

/// A closed term and its value.
type Evaluated = (Term, Value<Class>);

/// Evaluates core terms at one point.
pub(super) struct Terms<'a> {
    pub arithmetic: &'a Scrambled<'a>,
    values: &'a dyn Fn(&Name) -> Option<Class>,
    /// The claim whose given equations `coefficients` uses.
    pub given: Option<&'a Claim>,
    /// The values of closed terms by address. The terms are kept, so that no other term can get the same address.
    closed: RefCell<BTreeMap<(usize, usize), Evaluated>>,
    pub rows: RefCell<Vec<Row>>,
    /// Derivatives of bodies that depend on no other binder, by body, order and point.
    rates: RefCell<Vec<Rate>>,
    depth: Cell<usize>,
    /// How often symbols were moved.
    moves: Cell<usize>,
}

impl<'a> Terms<'a> {
    pub fn new(
        arithmetic: &'a Scrambled<'a>,
        values: &'a dyn Fn(&Name) -> Option<Class>,
        given: Option<&'a Claim>,
    ) -> Self {
        Self {
            arithmetic,
            values,
            given,
            closed: RefCell::default(),
            rows: RefCell::default(),
            rates: RefCell::default(),
            depth: Cell::default(),
            moves: Cell::default(),
        }
    }

    /// The numbers of the point.
    pub fn point(&self) -> &'a dyn Fn(&Name) -> Option<Class> {
        self.values
    }

    /// Returns the number of a new way to move symbols.
    pub fn next_move(&self) -> usize {
        self.moves.set(self.moves.get() + 1);
        self.moves.get()
    }

    /// The value of a closed term.
    pub fn value(&self, term: &Term) -> Outcome {
        stack::deep(|| self.term(term, &Scope::outermost()))
    }

    pub fn number(&self, term: &Term, scope: &Scope<'_>) -> Number {
        self.term(term, scope)?.number()
    }

    pub fn integer_value(&self, n: i64) -> Value<Class> {
        Value::Number(Series::integer(n, self.arithmetic))
    }

    /// Returns the integer value of a term.
    pub fn integer(
        &self,
        term: &Term,
        what: &'static str,
        scope: &Scope<'_>,
    ) -> Result<i64, NoValue> {
        self.whole(&self.number(term, scope)?, what)
    }

    fn whole(&self, value: &Series<Class>, what: &'static str) -> Result<i64, NoValue> {
        // An index that depends on the differentiation variable is not locally constant.
        let number = value.as_number().ok_or(Undefined::NotDifferentiable)?;
        let rational = self.arithmetic.as_rational(number);
        let rational = rational.ok_or(Undefined::NoInteger { what })?;
        i64::try_from(&rational.to_integer()).map_err(|_| Unknown::Large { what }.into())
    }

    pub fn term(&self, term: &Term, scope: &Scope<'_>) -> Outcome {
        let depth = self.depth.get();
        if depth >= MAX_DEPTH {
            let what = "the depth of a term";
            return Err(Unknown::Large { what }.into());
        }
        self.depth.set(depth + 1);
        let value = self.node(term, scope);
        self.depth.set(depth);
        value
    }

    fn node(&self, term: &Term, scope: &Scope<'_>) -> Outcome {
        let a = self.arithmetic;
        Ok(match &*term.node {
            Node::Number(value) => Value::Number(Series::rational(value, a)),
            Node::Pi => Value::Number(Series::Number(a.pi())),
            Node::Symbol(name) | Node::Vector(name, None) => {
                Value::Number(self.symbol(Name::Symbol(Arc::clone(name)), scope)?)
            }
            Node::Vector(name, Some(dimension)) => {
                let coordinate = |c| self.symbol(Name::Coordinate(Arc::clone(name), c), scope);
                let all = (1..=*dimension).map(coordinate);
                Value::vector(all.collect::<Result<_, _>>()?)
            }
            Node::Variable(variable) => {
                let known = scope.variable(variable.number()).cloned();
                known.ok_or_else(|| no_value(variable.name()))?
            }
            Node::Member(points, indices) => self.member(points, indices, scope)?,
            Node::Basis {
                family,
                index,
                degree,
                arguments,
            } => {
                let index = self.integer(index, "an index", scope)?;
                let degree = self.integer(degree, "a degree", scope)?;
                let arguments = arguments.iter().map(|argument| self.term(argument, scope));
                let row = self.row(family, degree, arguments.collect::<Result<_, _>>()?, scope)?;
                let function = usize::try_from(index).ok().and_then(|i| row.get(i));
                function.map_or_else(|| self.integer_value(0), |f| Value::Number(f.clone()))
            }
            Node::Negative(inner) => self.term(inner, scope)?.negated(a),
            Node::Binary(..) => self.chain(term, scope)?,
            Node::List(items) => {
                let items = items.iter().map(|item| self.term(item, scope));
                Value::Many(items.collect::<Result<_, _>>()?)
            }
            Node::Entry(of, indices) => self.entry(of, indices, scope)?,
            Node::Sum {
                index,
                low,
                high,
                term,
            } => self
                .range(low, high, scope)?
                .try_fold(self.integer_value(0), |total, i| {
                    let inside = scope.with(index, self.integer_value(i));
                    total.plus(&self.term(term, &inside)?, a)
                })?,
            Node::Product {
                index,
                low,
                high,
                term,
            } => self
                .range(low, high, scope)?
                .try_fold(self.integer_value(1), |product, i| {
                    let inside = scope.with(index, self.integer_value(i));
                    product.times(&self.term(term, &inside)?, a)
                })?,
            Node::Integral {
                variable,
                low,
                high,
                body,
            } => self.integral(variable, [low, high], body, scope)?,
            Node::Let {
                variable,
                value,
                body,
            } => {
                let value = self.term(value, scope)?;
                self.term(body, &scope.with(variable, value))?
            }
            Node::Derivative {
                variable,
                order,
                body,
                closed,
                at,
            } => {
                let order = self.integer(order, "the order of a derivative", scope)?;
                let point = self.number(at, scope)?;
                if !*closed {
                    return self.derivative(variable, order, body, point, scope);
                }
                let body_key = (Arc::as_ptr(&body.node).addr(), scope.moved_as);
                let key = (body_key, order, point);
                let rates = self.rates.borrow();
                if let Some((.., known)) = rates.iter().find(|(own, ..)| *own == key) {
                    return Ok(known.clone());
                }
                drop(rates);
                let value = self.derivative(variable, order, body, key.2.clone(), scope)?;
                let mut rates = self.rates.borrow_mut();
                if rates.len() >= MAX_RATES {
                    rates.remove(0);
                }
                rates.push((key, body.clone(), value.clone()));
                value
            }
            Node::Apply(function, arguments) => {
                let evaluate = || self.apply(*function, arguments, scope);
                match function {
                    BuiltIn::Inverse
                    | BuiltIn::Solve
                    | BuiltIn::Determinant
                    | BuiltIn::Coefficients => {
                        self.once(term, &|| term.is_closed(), scope, &evaluate)?
                    }
                    _ => evaluate()?,
                }
            }
            Node::Opened { closed, body, .. } => {
                let evaluate = || stack::deep(|| self.term(body, scope));
                self.once(body, &|| *closed, scope, &evaluate)?
            }
        })
    }

    /// Evaluates a term; the value of a term that depends on no binder is kept.
    fn once(
        &self,
        term: &Term,
        is_closed: &dyn Fn() -> bool,
        scope: &Scope<'_>,
        evaluate: &dyn Fn() -> Outcome,
    ) -> Outcome {
        let key = (Arc::as_ptr(&term.node).addr(), scope.moved_as);
        if let Some((_, known)) = self.closed.borrow().get(&key) {
            return Ok(known.clone());
        }
        let value = evaluate()?;
        if is_closed() {
            let mut all = self.closed.borrow_mut();
            all.insert(key, (term.clone(), value.clone()));
        }
        Ok(value)
    }

    pub fn symbol(&self, name: Name, scope: &Scope<'_>) -> Number {
        if let Some(moved) = scope.symbol(&name) {
            return Ok(moved.clone());
        }
        let value = (self.values)(&name);
        Ok(Series::Number(
            value.ok_or_else(|| no_value(&name.to_string()))?,
        ))
    }

    /// Evaluates a member of a family: undefined outside the declared ranges of its indices.
    fn member(&self, points: &Points, indices: &[Term], scope: &Scope<'_>) -> Outcome {
        let indices = indices.iter().map(|i| self.integer(i, "an index", scope));
        let indices: Vec<i64> = indices.collect::<Result<_, _>>()?;
        for (index, (low, high)) in indices.iter().zip(&points.ranges) {
            let (low, high) = (self.form(low)?, self.form(high)?);
            if !(low..=high).contains(index) {
                return Err(outside(&points.name, *index, low, high));
            }
        }
        let coordinate = |c| {
            self.symbol(
                Name::Member(Arc::clone(&points.name), indices.clone(), c),
                scope,
            )
        };
        Ok(match points.dimension {
            None | Some(1) => Value::Number(coordinate(None)?),
            Some(d) => {
                let all = (1..=d).map(|c| coordinate(Some(c)));
                Value::vector(all.collect::<Result<_, _>>()?)
            }
        })
    }

    /// Evaluates an index form at the point.
    fn form(&self, form: &Affine) -> Result<i64, NoValue> {
        let what = "a bound";
        let mut total = form.constant();
        for (name, multiple) in form.multiples() {
            let value = self.symbol(Name::Symbol(Arc::from(name)), &Scope::outermost())?;
            let product = self.whole(&value, what)?.checked_mul(multiple);
            let sum = product.and_then(|product| total.checked_add(product));
            total = sum.ok_or(Unknown::Large { what })?;
        }
        Ok(total)
    }

    /// Evaluates a chain `a + b - c + ...` without recursion over the left operands, so long sums are not deep.
    fn chain(&self, term: &Term, scope: &Scope<'_>) -> Outcome {
        let mut rights = vec![];
        let mut left = term;
        while let Node::Binary(operator, a, b) = &*left.node {
            rights.push((*operator, b));
            left = a;
        }
        let mut value = self.term(left, scope)?;
        while let Some((operator, right)) = rights.pop() {
            value = self.binary(operator, &value, right, scope)?;
        }
        Ok(value)
    }

    fn binary(
        &self,
        operator: Operator,
        left: &Value<Class>,
        right: &Term,
        scope: &Scope<'_>,
    ) -> Outcome {
        let a = self.arithmetic;
        match operator {
            Operator::Add => left.plus(&self.term(right, scope)?, a),
            Operator::Subtract => left.plus(&self.term(right, scope)?.negated(a), a),
            Operator::Multiply => left.times(&self.term(right, scope)?, a),
            Operator::Divide => {
                let divisor = self.number(right, scope)?;
                left.each(&|x| x.over(&divisor, a))
            }
            Operator::Power => {
                let exponent = self.integer(right, "an exponent", scope)?;
                if exponent.unsigned_abs() > MAX_EXPONENT {
                    let what = "an exponent";
                    return Err(Unknown::Large { what }.into());
                }
                let power = left.clone().number()?.power(exponent.unsigned_abs(), a)?;
                Ok(Value::Number(match exponent < 0 {
                    true => Series::integer(1, a).over(&power, a)?,
                    false => power,
                }))
            }
        }
    }

    /// Entries are counted from 1.
    fn entry(&self, vector: &Term, indices: &[Term], scope: &Scope<'_>) -> Outcome {
        let mut value = self.term(vector, scope)?;
        for index in indices {
            let index = self.integer(index, "an index", scope)?;
            let Value::Many(items) = value else {
                return Err(NoValue::shape("an entry of a number"));
            };
            let position = index.checked_sub(1).and_then(|p| usize::try_from(p).ok());
            let found = position.and_then(|p| items.get(p).cloned());
            let length = i64::try_from(items.len()).unwrap_or(i64::MAX);
            value = found.ok_or_else(|| outside("entry", index, 1, length))?;
        }
        Ok(value)
    }

    fn range(
        &self,
        low: &Term,
        high: &Term,
        scope: &Scope<'_>,
    ) -> Result<RangeInclusive<i64>, NoValue> {
        let low = self.integer(low, "a bound", scope)?;
        let high = self.integer(high, "a bound", scope)?;
        if high.saturating_sub(low) >= MAX_TERMS {
            return Err(Unknown::Large { what: "a sum" }.into());
        }
        Ok(low..=high)
    }

    /// Stands for an integral: a combination of values of the integrand.
    fn integral(
        &self,
        variable: &Variable,
        [low, high]: [&Term; 2],
        body: &Term,
        scope: &Scope<'_>,
    ) -> Outcome {
        let a = self.arithmetic;
        let (low, high) = (self.number(low, scope)?, self.number(high, scope)?);
        let length = high.minus(&low, a)?;
        let mut sum = self.integer_value(0);
        for (share, weight) in a.stands_for_integral().iter().flatten() {
            let place = low.plus(&length.times(&Series::rational(share, a), a)?, a)?;
            let value = self.term(body, &scope.with(variable, Value::Number(place)))?;
            let weight = Series::rational(weight, a).times(&length, a)?;
            sum = sum.plus(&value.each(&|x| x.times(&weight, a))?, a)?;
        }
        Ok(sum)
    }

    /// Returns `order!` times the coefficient of `e^order` of the body at `point + e`.
    fn derivative(
        &self,
        variable: &Variable,
        order: i64,
        body: &Term,
        point: Series<Class>,
        scope: &Scope<'_>,
    ) -> Outcome {
        let a = self.arithmetic;
        let what = "the order of a derivative";
        if order < 0 {
            return Err(Undefined::Negative { what }.into());
        }
        if order > MAX_ORDER {
            return Err(Unknown::Large { what }.into());
        }
        let terms = usize::try_from(order).unwrap_or(0);
        let factorial: Rational = (1..=order).map(integer).product();
        let factorial = Series::rational(&factorial, a);
        let level = scope.level + 1;
        let inside = scope.within(variable, point.shifted(level, terms, a));
        let value = self.term(body, &inside)?;
        value.each(&|series| series.coefficient(level, terms, a).times(&factorial, a))
    }
}

fn outside(name: &str, index: i64, low: i64, high: i64) -> NoValue {
    Undefined::IndexOutside {
        name: name.to_owned(),
        index,
        low,
        high,
    }
    .into()
}

fn no_value(name: &str) -> NoValue {
    Unknown::NoValue {
        name: name.to_owned(),
    }
    .into()
}
