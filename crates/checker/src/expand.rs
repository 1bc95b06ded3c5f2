//! Expands core terms, with the meaning that `derivations/SEMANTICS.md` defines.

use super::gap::{Unsupported, Work};
use super::integral;
use super::quotient::Quotient;
use super::value::Value;
use std::cell::RefCell;
use std::collections::{BTreeMap, BTreeSet};
use std::sync::Arc;
use torse_certificate::polynomial::Polynomial;
use torse_certificate::symbol::Symbol;
use torse_core::{BuiltIn, Family, Node, Points, Term};
use torse_numbers::Affine;
use torse_numbers::fault_injection::{InjectedFault, injected};
use torse_numbers::rational::integer;
use torse_syntax::formula::Operator;

/// The largest number of terms of a sum, the largest exponent and order; and the largest degree above the seeds.
const MAX_STEPS: i64 = 64;
const MAX_DEGREE: i64 = 24;
/// The largest nesting depth of terms.
const MAX_DEPTH: u32 = 400;

/// Expands terms, replacing symbols by their values.
pub struct Expander<'a> {
    pub(super) work: &'a Work,
    /// The values of symbols.
    values: &'a dyn Fn(&Symbol) -> Option<Quotient>,
    /// The divisors that occurred: where one of them vanishes, some term is undefined.
    pub divisors: RefCell<BTreeSet<Polynomial>>,
    /// Whether `coefficients` may differentiate by its symbols: the expanded forms then are functions of these
    /// symbols, because unknowns of given equations have been replaced by their values, and no symbol was replaced by
    /// an assumption.
    pub sees_rates: &'a dyn Fn() -> bool,
    opened: RefCell<BTreeMap<usize, Value>>,
    /// Cached derivatives of formulas in one variable, by formula and order.
    rates: RefCell<BTreeMap<(usize, i64), Rate>>,
    rows: RefCell<Vec<Row>>,
}

/// The functions of a family at a degree and at arguments.
struct Row {
    family: usize,
    degree: i64,
    arguments: Vec<Value>,
    functions: Vec<Quotient>,
}

/// The variables of the enclosing binders.
#[derive(Clone, Copy)]
pub(super) struct Scope<'s> {
    bound: Option<(u32, &'s Value, &'s Scope<'s>)>,
    depth: u32,
}

impl<'s> Scope<'s> {
    const OUTSIDE: Scope<'static> = Scope {
        bound: None,
        depth: 0,
    };

    fn with(&'s self, variable: u32, value: &'s Value) -> Self {
        Self {
            bound: Some((variable, value, self)),
            depth: self.depth,
        }
    }

    fn get(&self, variable: u32) -> Option<&'s Value> {
        let (own, value, outer) = self.bound?;
        if own == variable {
            Some(value)
        } else {
            outer.get(variable)
        }
    }

    fn deeper(self) -> Result<Self, Unsupported> {
        let depth = self.depth + 1;
        if depth > MAX_DEPTH {
            return Err(Unsupported::Large);
        }
        Ok(Self { depth, ..self })
    }
}

/// Whether the function is expanded by minors, whose number grows fast.
fn is_costly(function: BuiltIn) -> bool {
    matches!(
        function,
        BuiltIn::Inverse | BuiltIn::Solve | BuiltIn::Determinant
    )
}

impl<'a> Expander<'a> {
    /// An expander that replaces symbols by these values.
    pub fn new(work: &'a Work, values: &'a dyn Fn(&Symbol) -> Option<Quotient>) -> Self {
        Self {
            work,
            values,
            divisors: RefCell::default(),
            sees_rates: &|| true,
            opened: RefCell::default(),
            rates: RefCell::default(),
            rows: RefCell::default(),
        }
    }

    /// Expands a closed term.
    pub fn value(&self, term: &Term) -> Result<Value, Unsupported> {
        self.term(term, &Scope::OUTSIDE)
    }

    pub(super) fn number(&self, term: &Term, scope: &Scope<'_>) -> Result<Quotient, Unsupported> {
        self.term(term, scope)?.number()
    }

    /// The value of a term that must be an integer constant.
    pub(super) fn integer(
        &self,
        term: &Term,
        what: &'static str,
        scope: &Scope<'_>,
    ) -> Result<i64, Unsupported> {
        let number = self.number(term, scope)?;
        let number = number.as_rational().ok_or(Unsupported::Symbolic(what))?;
        if !number.is_integer() {
            return Err(Unsupported::Undefined(what));
        }
        i64::try_from(&number.to_integer()).map_err(|_| Unsupported::Large)
    }

    pub(super) fn over(&self, a: &Quotient, b: &Quotient) -> Result<Quotient, Unsupported> {
        if let Some((_, factor)) = b.above.monic()
            && factor.as_constant().is_none()
        {
            self.divisors.borrow_mut().insert(factor);
        }
        a.over(b, self.work)
    }

    fn symbol(&self, symbol: Symbol) -> Quotient {
        let own = || Polynomial::symbol(symbol.clone()).into();
        (self.values)(&symbol).unwrap_or_else(own)
    }

    pub(super) fn term(&self, term: &Term, scope: &Scope<'_>) -> Result<Value, Unsupported> {
        let inside = scope.deeper()?;
        let scope = &inside;
        match &*term.node {
            Node::Number(value) => Ok(Value::Number(Quotient::number(value.clone()))),
            Node::Pi => Ok(Value::Number(Polynomial::symbol(Symbol::Pi).into())),
            Node::Symbol(name) => Ok(Value::Number(self.symbol(Symbol::Named(Arc::clone(name))))),
            Node::Variable(variable) => {
                let value = scope.get(variable.number());
                value
                    .cloned()
                    .ok_or(Unsupported::Construct("a free variable"))
            }
            Node::Vector(name, None) => Ok(Value::Number(self.symbol(Symbol::Named(name.clone())))),
            Node::Vector(name, Some(dimension)) => {
                let entry = |c| self.symbol(Symbol::named(&format!("{name}[{c}]")));
                Ok(Value::vector((1..=*dimension).map(entry).collect()))
            }
            Node::Member(points, indices) => self.member(points, indices, scope),
            Node::Basis {
                family,
                index,
                degree,
                arguments,
            } => {
                let index = self.integer(index, "an index", scope)?;
                let degree = self.integer(degree, "a degree", scope)?;
                let arguments = arguments.iter().map(|a| self.term(a, scope));
                let arguments = arguments.collect::<Result<_, _>>()?;
                let functions = self.functions(family, degree, arguments, scope)?;
                let place = usize::try_from(index).ok();
                let function = place.and_then(|place| functions.get(place).cloned());
                Ok(Value::Number(function.unwrap_or_default()))
            }
            Node::Negative(inner) => Ok(self.term(inner, scope)?.negated()),
            Node::Binary(..) => self.chain(term, scope),
            Node::List(items) => {
                let items = items.iter().map(|item| self.term(item, scope));
                Ok(Value::Many(items.collect::<Result<_, _>>()?))
            }
            Node::Entry(of, indices) => self.entry(of, indices, scope),
            Node::Sum {
                index,
                low,
                high,
                term,
            } => {
                let low = self.integer(low, "the bound of a sum", scope)?;
                let high = self.integer(high, "the bound of a sum", scope)?;
                if high.saturating_sub(low) > MAX_STEPS {
                    return Err(Unsupported::Large);
                }
                let zero = Value::Number(Quotient::default());
                (low..=high).try_fold(zero, |total, i| {
                    let i = Value::Number(Quotient::number(integer(i)));
                    let part = self.term(term, &scope.with(index.number(), &i))?;
                    total.plus(&part, self.work)
                })
            }
            Node::Product {
                index,
                low,
                high,
                term,
            } => {
                let low = self.integer(low, "the bound of a product", scope)?;
                let high = self.integer(high, "the bound of a product", scope)?;
                if high.saturating_sub(low) > MAX_STEPS {
                    return Err(Unsupported::Large);
                }
                let one = Value::Number(Quotient::number(integer(1)));
                (low..=high).try_fold(one, |product, i| {
                    let i = Value::Number(Quotient::number(integer(i)));
                    let factor = self.term(term, &scope.with(index.number(), &i))?;
                    product.times(&factor, self.work)
                })
            }
            Node::Integral {
                variable,
                low,
                high,
                body,
            } => {
                // No text can contain this character, so the name is new.
                let own = Symbol::named(&format!("\u{222b}{}", variable.number()));
                let symbol = Value::Number(Polynomial::symbol(own.clone()).into());
                let body = self.term(body, &scope.with(variable.number(), &symbol))?;
                let ends = [self.number(low, scope)?, self.number(high, scope)?];
                body.each(&|f| integral::between(f, &own, &ends, self.work))
            }
            Node::Let {
                variable,
                value,
                body,
            } => {
                let value = self.term(value, scope)?;
                self.term(body, &scope.with(variable.number(), &value))
            }
            Node::Derivative {
                variable,
                order,
                body,
                closed,
                at,
            } => {
                let order = self.integer(order, "the order of a derivative", scope)?;
                let at = self.number(at, scope)?;
                self.derivative(variable.number(), order, (body, *closed), &at, scope)
            }
            Node::Apply(function, arguments) => {
                let apply = || self.apply(*function, arguments, scope);
                if is_costly(*function) && term.is_closed() {
                    self.once(term, apply)
                } else {
                    apply()
                }
            }
            Node::Opened { closed, body, .. } => {
                if *closed {
                    self.once(body, || self.term(body, scope))
                } else {
                    self.term(body, scope)
                }
            }
        }
    }

    /// Expands a closed term once and caches the result.
    fn once(
        &self,
        term: &Term,
        expand: impl FnOnce() -> Result<Value, Unsupported>,
    ) -> Result<Value, Unsupported> {
        let key = Arc::as_ptr(&term.node).addr();
        if let Some(known) = self.opened.borrow().get(&key) {
            return Ok(known.clone());
        }
        let value = expand()?;
        self.opened.borrow_mut().insert(key, value.clone());
        Ok(value)
    }

    /// Expands a chain of operators without recursion over the left operands.
    fn chain(&self, term: &Term, scope: &Scope<'_>) -> Result<Value, Unsupported> {
        let (mut rights, mut left) = (vec![], term);
        while let Node::Binary(operator, a, b) = &*left.node {
            rights.push((*operator, b));
            left = a;
        }
        let mut value = self.term(left, scope)?;
        while let Some((operator, right)) = rights.pop() {
            value = match operator {
                Operator::Subtract if injected(InjectedFault::DifferenceReadAsSum) => {
                    value.plus(&self.term(right, scope)?, self.work)?
                }
                Operator::Add => value.plus(&self.term(right, scope)?, self.work)?,
                Operator::Subtract => value.plus(&self.term(right, scope)?.negated(), self.work)?,
                Operator::Multiply => value.times(&self.term(right, scope)?, self.work)?,
                Operator::Divide => {
                    let divisor = self.number(right, scope)?;
                    value.each(&|x| self.over(x, &divisor))?
                }
                Operator::Power => {
                    let exponent = self.integer(right, "an exponent", scope)?;
                    let size = u32::try_from(exponent.unsigned_abs()).ok();
                    let size = size
                        .filter(|n| i64::from(*n) <= MAX_STEPS)
                        .ok_or(Unsupported::Large)?;
                    let power = value.number()?.power(size, self.work)?;
                    let one = Quotient::number(integer(1));
                    Value::Number(if exponent < 0 {
                        self.over(&one, &power)?
                    } else {
                        power
                    })
                }
            };
        }
        Ok(value)
    }

    /// Expands a member of a family, which is undefined outside of the declared ranges of its indices.
    fn member(
        &self,
        points: &Points,
        indices: &[Term],
        scope: &Scope<'_>,
    ) -> Result<Value, Unsupported> {
        let indices = indices.iter().map(|i| self.integer(i, "an index", scope));
        let indices: Vec<i64> = indices.collect::<Result<_, _>>()?;
        for (index, (low, high)) in indices.iter().zip(&points.ranges) {
            let (low, high) = match (self.form(low), self.form(high)) {
                (Ok(low), Ok(high)) => (low, high),
                // If the range is symbolic, the member is used outside of it as well: then more is proved than
                // claimed.
                (Err(Unsupported::Symbolic(_)), _) | (_, Err(Unsupported::Symbolic(_))) => continue,
                (Err(gap), _) | (_, Err(gap)) => return Err(gap),
            };
            if !(low..=high).contains(index) {
                return Err(Unsupported::Undefined("a member outside of its range"));
            }
        }
        let text = |all: &[i64]| {
            let all: Vec<String> = all.iter().map(i64::to_string).collect();
            Symbol::named(&format!("{}[{}]", points.name, all.join(",")))
        };
        Ok(match points.dimension {
            None | Some(1) => Value::Number(self.symbol(text(&indices))),
            Some(d) => {
                let entry = |c: u8| text(&[indices.as_slice(), &[i64::from(c)]].concat());
                Value::vector((1..=d).map(|c| self.symbol(entry(c))).collect())
            }
        })
    }

    /// The value of an index form that must be an integer constant.
    pub(super) fn form(&self, form: &Affine) -> Result<i64, Unsupported> {
        let mut total = form.constant();
        for (name, multiple) in form.multiples() {
            let value = self.symbol(Symbol::named(name)).as_rational();
            let value = value.ok_or(Unsupported::Symbolic("the range of an index"))?;
            if !value.is_integer() {
                return Err(Unsupported::Undefined("the range of an index"));
            }
            let value = i64::try_from(&value.to_integer()).map_err(|_| Unsupported::Large)?;
            let product = value.checked_mul(multiple).ok_or(Unsupported::Large)?;
            total = total.checked_add(product).ok_or(Unsupported::Large)?;
        }
        Ok(total)
    }

    /// Computes the functions row by row from the seeds: `g[i,j+1] = a g[i,j] + b g[i-1,j]`.
    pub(super) fn functions(
        &self,
        family: &Arc<Family>,
        degree: i64,
        arguments: Vec<Value>,
        scope: &Scope<'_>,
    ) -> Result<Vec<Quotient>, Unsupported> {
        let steps = degree - i64::from(family.degree);
        if steps < 0 {
            return Err(Unsupported::Undefined(
                "a basis below the degree of its seeds",
            ));
        }
        if degree > MAX_DEGREE {
            return Err(Unsupported::Large);
        }
        let key = Arc::as_ptr(family).addr();
        if family.closed {
            let rows = self.rows.borrow();
            let known = rows.iter().find(|row| {
                row.family == key && row.degree == degree && row.arguments == arguments
            });
            if let Some(known) = known {
                return Ok(known.functions.clone());
            }
        }
        let functions = self.recursion(family, steps, &arguments, 0, scope)?;
        if family.closed {
            self.rows.borrow_mut().push(Row {
                family: key,
                degree,
                arguments,
                functions: functions.clone(),
            });
        }
        Ok(functions)
    }

    /// The two factors of the step and the seeds, at these arguments.
    pub(super) fn factors_and_seeds(
        &self,
        family: &Family,
        arguments: &[Value],
    ) -> Result<([Quotient; 2], Vec<Quotient>), Unsupported> {
        self.opened_family(family, arguments, &Scope::OUTSIDE)
    }

    fn opened_family(
        &self,
        family: &Family,
        arguments: &[Value],
        scope: &Scope<'_>,
    ) -> Result<([Quotient; 2], Vec<Quotient>), Unsupported> {
        let place = family.variables.len().saturating_sub(arguments.len());
        if let (Some(variable), Some((value, rest))) =
            (family.variables.get(place), arguments.split_first())
        {
            let inner = scope.with(variable.number(), value);
            return self.opened_family(family, rest, &inner);
        }
        let seeds = family.seeds.iter().map(|seed| self.number(seed, scope));
        let factors = [
            self.number(&family.step.0, scope)?,
            self.number(&family.step.1, scope)?,
        ];
        Ok((factors, seeds.collect::<Result<_, _>>()?))
    }

    fn recursion(
        &self,
        family: &Family,
        steps: i64,
        arguments: &[Value],
        place: usize,
        scope: &Scope<'_>,
    ) -> Result<Vec<Quotient>, Unsupported> {
        if let (Some(variable), Some(value)) = (family.variables.get(place), arguments.get(place)) {
            let inner = scope.with(variable.number(), value);
            return self.recursion(family, steps, arguments, place + 1, &inner);
        }
        let seeds = family.seeds.iter().map(|seed| self.number(seed, scope));
        let mut row: Vec<Quotient> = seeds.collect::<Result<_, _>>()?;
        let keep = self.number(&family.step.0, scope)?;
        let shift = self.number(&family.step.1, scope)?;
        for _ in 0..steps {
            let zero = Quotient::default();
            let same = row.iter().chain([&zero]);
            let before = [&zero].into_iter().chain(&row);
            let next = same.zip(before).map(|(same, before)| {
                let kept = keep.times(same, self.work)?;
                kept.plus(&shift.times(before, self.work)?, self.work)
            });
            row = next.collect::<Result<_, Unsupported>>()?;
        }
        Ok(row)
    }

    /// Expands an entry of a vector or matrix; indices begin at 1.
    fn entry(
        &self,
        vector: &Term,
        indices: &[Term],
        scope: &Scope<'_>,
    ) -> Result<Value, Unsupported> {
        let mut value = self.term(vector, scope)?;
        for index in indices {
            let index = self.integer(index, "an index", scope)?;
            let Value::Many(items) = value else {
                return Err(Unsupported::Construct("an entry of a number"));
            };
            let place = index.checked_sub(1).and_then(|p| usize::try_from(p).ok());
            let found = place.and_then(|place| items.get(place).cloned());
            value = found.ok_or(Unsupported::Undefined("an entry that there is not"))?;
        }
        Ok(value)
    }

    /// Expands a derivative: the body is expanded with a new symbol for the variable, differentiated by that symbol,
    /// and only then evaluated at the point.
    fn derivative(
        &self,
        variable: u32,
        order: i64,
        (body, closed): (&Term, bool),
        at: &Quotient,
        scope: &Scope<'_>,
    ) -> Result<Value, Unsupported> {
        if order < 0 {
            return Err(Unsupported::Undefined("a derivative of negative order"));
        }
        if order > MAX_STEPS {
            return Err(Unsupported::Large);
        }
        // No text can contain this character, so the name is new.
        let own = Symbol::named(&format!("\u{2202}{variable}"));
        let rate = || {
            let symbol = Value::Number(Polynomial::symbol(own.clone()).into());
            let outside = self.divisors.take();
            let value = self.term(body, &scope.with(variable, &symbol));
            let divisors = self.divisors.replace(outside);
            let value = (0..order).try_fold(value?, |value, _| {
                value.each(&|x| x.derivative(&own, self.work))
            })?;
            Ok(Rate { value, divisors })
        };
        let rate = if closed {
            self.known_rate(body, order, rate)?
        } else {
            rate()?
        };
        let value_of = |symbol: &Symbol| (*symbol == own).then(|| at.clone());
        // What the body divides by does not vanish at the point.
        for divisor in rate.divisors {
            let there = Quotient::from(divisor).replaced(&value_of, self.work)?;
            let factor = there.above.monic().map(|(_, factor)| factor);
            let factor = factor.filter(|factor| factor.as_constant().is_none());
            self.divisors.borrow_mut().extend(factor);
        }
        rate.value.each(&|x| x.replaced(&value_of, self.work))
    }

    /// The derivative of a body without other variables, computed once and cached.
    fn known_rate(
        &self,
        body: &Term,
        order: i64,
        rate: impl FnOnce() -> Result<Rate, Unsupported>,
    ) -> Result<Rate, Unsupported> {
        let key = (Arc::as_ptr(&body.node).addr(), order);
        if let Some(known) = self.rates.borrow().get(&key) {
            return Ok(known.clone());
        }
        let rate = rate()?;
        self.rates.borrow_mut().insert(key, rate.clone());
        Ok(rate)
    }
}

/// A derivative as a function of the symbol for its variable.
#[derive(Debug, Clone)]
struct Rate {
    value: Value,
    /// What the body was divided by.
    divisors: BTreeSet<Polynomial>,
}
