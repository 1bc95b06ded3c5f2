//! The value of a core term: one rule for each construct, as `derivations/SEMANTICS.md` states it.
//!
//! Variables of binders have their values in a [`Scope`]; declared symbols get theirs from the point, through a function
//! from [`Name`]s to numbers. All parts are evaluated before the whole, so that a term with an undefined part is
//! undefined.

use crate::arithmetic::Arithmetic;
use crate::gap::{Gap, Undefined, Unknown};
use crate::name::Name;
use crate::scope::{Expansion, Memory, Scope};
use crate::series::{Series, Turned};
use crate::value::Value;
use std::cell::{Cell, RefCell};
use std::ops::RangeInclusive;
use std::rc::Rc;
use std::sync::Arc;
use torse_core::{BuiltIn, Claim, Family, Node, Points, Term, Variable, stack};
use torse_syntax::formula::Operator;

/// How deep terms may be nested, not counting chains of one operator: 80 definitions in each other of 300 levels each, as deep
/// as can be written. Each definition, and each basis, sees to it that there is a
/// stack for its own.
const MAX_DEPTH: usize = 80 * 300;
/// The longest sum.
const MAX_TERMS: i64 = 4000;
/// The largest exponent, degree of a basis and order of a derivative.
const MAX_EXPONENT: i64 = 2000;
const MAX_DEGREE: i64 = 60;
const MAX_ORDER: i64 = 40;
/// The largest integer that needs no arithmetic to be read.
const SMALL: i64 = 1 << 14;
/// The largest power, in bits.
const MAX_POWER_BITS: u64 = 20_000;

/// The functions of one basis at one degree and one tuple of arguments.
struct Row<N> {
    family: usize,
    degree: i64,
    arguments: Vec<Value<N>>,
    functions: Rc<[Series<N>]>,
}

/// An angle with its sine and cosine.
type Angle<N> = (Series<N>, Turned<N>);

/// Evaluates terms at one point.
pub struct Evaluator<'a, A: Arithmetic> {
    pub(crate) arithmetic: &'a A,
    pub(crate) values: &'a dyn Fn(&Name) -> Option<A::Number>,
    pub(crate) claim: Option<&'a Claim>,
    /// What was evaluated with the values of the point.
    memory: Memory<A::Number>,
    rows: RefCell<Vec<Row<A::Number>>>,
    /// Angles with their sine and cosine.
    pub(crate) turned: RefCell<Vec<Angle<A::Number>>>,
    /// How many terms enclose the one that is evaluated.
    depth: Cell<usize>,
}

pub(crate) type Outcome<A> = Result<Value<<A as Arithmetic>::Number>, Gap>;
pub(crate) type Sc<'s, A> = Scope<'s, <A as Arithmetic>::Number>;

impl<'a, A: Arithmetic> Evaluator<'a, A> {
    /// An evaluator at the point that gives declared symbols these values.
    pub fn new(arithmetic: &'a A, values: &'a dyn Fn(&Name) -> Option<A::Number>) -> Self {
        Self {
            arithmetic,
            values,
            claim: None,
            memory: Memory::default(),
            rows: RefCell::default(),
            turned: RefCell::default(),
            depth: Cell::default(),
        }
    }

    /// The same, where the unknowns of the claim's given equations are functions of the other symbols: that matters to
    /// `coefficients` alone.
    #[must_use]
    pub fn of(self, claim: Option<&'a Claim>) -> Self {
        Self { claim, ..self }
    }

    /// The value of a closed term.
    ///
    /// # Errors
    /// [`Gap`]: the term is undefined here, or its value is not known.
    pub fn value(&self, term: &Term) -> Outcome<A> {
        self.term(term, &Scope::outermost())
    }

    /// The number of this name at the point.
    pub(crate) fn point_value(&self, name: &Name) -> Result<A::Number, Gap> {
        (self.values)(name).ok_or_else(|| no_value(&name.to_string()))
    }

    pub(crate) fn number(&self, term: &Term, scope: &Sc<'_, A>) -> Result<Series<A::Number>, Gap> {
        self.term(term, scope)?.number()
    }

    pub(crate) fn integer_value(&self, n: i64) -> Value<A::Number> {
        Value::Number(Series::integer(n, self.arithmetic))
    }

    /// The integer that a term is worth.
    pub(crate) fn integer(
        &self,
        term: &Term,
        what: &'static str,
        scope: &Sc<'_, A>,
    ) -> Result<i64, Gap> {
        if let Some(small) = self.small(term) {
            return Ok(small);
        }
        let evaluated;
        let value = match self.counted_by(term, scope) {
            Some(value) => value,
            None => {
                evaluated = self.number(term, scope)?;
                &evaluated
            }
        };
        // What varies with the variable of a derivative is no integer near the point.
        let Some(number) = value.as_number() else {
            return Err(Undefined::NotDifferentiable.into());
        };
        let Some(rational) = self.arithmetic.as_rational(number) else {
            return Err(Unknown::Precision.into());
        };
        if !rational.is_integer() {
            return Err(Undefined::NoInteger { what }.into());
        }
        i64::try_from(&rational.to_integer()).map_err(|_| Unknown::Large { what }.into())
    }

    /// The integer that is written here, if it is so small that every arithmetic has it.
    fn small(&self, term: &Term) -> Option<i64> {
        let Node::Number(value) = &*term.node else {
            return None;
        };
        let number = value.is_integer().then(|| i64::try_from(value.numer()))?;
        let known = self.depth.get() < MAX_DEPTH;
        number.ok().filter(|n| known && n.abs() <= SMALL)
    }

    /// The value of the variable of a binder, where it stands alone.
    fn counted_by<'s>(&self, term: &Term, scope: &'s Sc<'_, A>) -> Option<&'s Series<A::Number>> {
        let Node::Variable(variable) = &*term.node else {
            return None;
        };
        match scope.variable(variable.number()) {
            Some(Value::Number(number)) if self.depth.get() < MAX_DEPTH => Some(number),
            _ => None,
        }
    }

    pub(crate) fn term(&self, term: &Term, scope: &Sc<'_, A>) -> Outcome<A> {
        let depth = self.depth.get();
        if depth >= MAX_DEPTH {
            return Err(Unknown::Large {
                what: "the depth of a term",
            }
            .into());
        }
        self.depth.set(depth + 1);
        let value = self.node(term, scope);
        self.depth.set(depth);
        value
    }

    fn node(&self, term: &Term, scope: &Sc<'_, A>) -> Outcome<A> {
        let a = self.arithmetic;
        match &*term.node {
            Node::Number(value) => Ok(Value::Number(Series::rational(value, a))),
            Node::Pi => Ok(Value::Number(Series::Number(a.pi()))),
            Node::Symbol(name) => Ok(Value::Number(
                self.symbol(Name::Symbol(Arc::clone(name)), scope)?,
            )),
            Node::Variable(variable) => scope
                .variable(variable.number())
                .cloned()
                .ok_or_else(|| no_value(variable.name())),
            Node::Vector(name, dimension) => self.vector(name, *dimension, scope),
            Node::Member(points, indices) => self.member(points, indices, scope),
            Node::Basis {
                family,
                index,
                degree,
                arguments,
            } => self.basis(family, index, degree, arguments, scope),
            Node::Negative(inner) => Ok(self.term(inner, scope)?.negated(a)),
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
            } => self.sum(index.number(), low, high, term, scope),
            Node::Product {
                index,
                low,
                high,
                term,
            } => self.product(index.number(), low, high, term, scope),
            Node::Integral {
                variable,
                low,
                high,
                body,
            } => self.integral(variable.number(), low, high, body, scope),
            Node::Let {
                variable,
                value,
                body,
            } => {
                let value = self.term(value, scope)?;
                self.term(body, &scope.with(variable.number(), value))
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
                self.derivative(variable.number(), order, (body, *closed), point, scope)
            }
            Node::Apply(function, arguments) => {
                // What is costly and depends on no variable of a binder has one value at the point.
                let costly = matches!(
                    function,
                    BuiltIn::Inverse
                        | BuiltIn::Solve
                        | BuiltIn::Determinant
                        | BuiltIn::Coefficients
                );
                if costly && a.work().known().is_closed(term) {
                    self.once(term, scope, || self.apply(*function, arguments, scope))
                } else {
                    self.apply(*function, arguments, scope)
                }
            }
            Node::Opened { closed, body, .. } => {
                let evaluate = || stack::deep(|| self.term(body, scope));
                if *closed {
                    // A closed body has one value at the point, wherever it stands.
                    self.once(body, scope, evaluate)
                } else {
                    evaluate()
                }
            }
        }
    }

    /// The value of a closed term, evaluated when it is asked for first under the values that declared symbols have here.
    fn once(
        &self,
        term: &Term,
        scope: &Sc<'_, A>,
        evaluate: impl FnOnce() -> Outcome<A>,
    ) -> Outcome<A> {
        let key = Arc::as_ptr(&term.node).addr();
        let memory = self.memory_for(term, scope);
        if let Some(known) = memory.closed.borrow().get(&key) {
            return Ok(known.clone());
        }
        let value = evaluate()?;
        memory.closed.borrow_mut().insert(key, value.clone());
        Ok(value)
    }

    /// The memory of the innermost binding that matters to a term.
    fn memory_for<'s>(&'s self, term: &Term, scope: &'s Sc<'_, A>) -> &'s Memory<A::Number> {
        if scope.innermost_symbol().is_none() {
            return &self.memory;
        }
        let names = self.arithmetic.work().known().names(term);
        scope.memory_of(&names).unwrap_or(&self.memory)
    }

    pub(crate) fn symbol(&self, name: Name, scope: &Sc<'_, A>) -> Result<Series<A::Number>, Gap> {
        if let Some(bound) = scope.symbol(&name) {
            return Ok(bound.clone());
        }
        match (self.values)(&name) {
            Some(value) => Ok(Series::Number(value)),
            None => Err(no_value(&name.to_string())),
        }
    }

    fn vector(&self, name: &Arc<str>, dimension: Option<u8>, scope: &Sc<'_, A>) -> Outcome<A> {
        let Some(dimension) = dimension else {
            let generic = self.symbol(Name::Symbol(Arc::clone(name)), scope)?;
            return Ok(Value::Number(generic));
        };
        let coordinates =
            (1..=dimension).map(|c| self.symbol(Name::Coordinate(Arc::clone(name), c), scope));
        Ok(Value::vector(coordinates.collect::<Result<_, _>>()?))
    }

    /// A member of a family: undefined outside of the declared ranges of its indices.
    fn member(&self, points: &Points, indices: &[Term], scope: &Sc<'_, A>) -> Outcome<A> {
        let indices: Vec<i64> = indices
            .iter()
            .map(|i| self.integer(i, "an index", scope))
            .collect::<Result<_, _>>()?;
        for (index, (low, high)) in indices.iter().zip(&points.ranges) {
            let (low, high) = (self.form(low, scope)?, self.form(high, scope)?);
            if !(low..=high).contains(index) {
                return Err(Undefined::IndexOutside {
                    name: points.name.to_string(),
                    index: *index,
                    low,
                    high,
                }
                .into());
            }
        }
        let coordinate = |c: Option<u8>| {
            self.symbol(
                Name::Member(Arc::clone(&points.name), indices.clone(), c),
                scope,
            )
        };
        match points.dimension {
            None | Some(1) => Ok(Value::Number(coordinate(None)?)),
            Some(d) => {
                let all = (1..=d).map(|c| coordinate(Some(c)));
                Ok(Value::vector(all.collect::<Result<_, _>>()?))
            }
        }
    }

    /// The value of an index form: integers of the claim have integer values.
    pub(crate) fn form(&self, form: &torse_numbers::Affine, scope: &Sc<'_, A>) -> Result<i64, Gap> {
        let mut total = form.constant();
        for (name, multiple) in form.multiples() {
            let value = self.symbol(Name::Symbol(Arc::from(name)), scope)?;
            let number = value.as_number().ok_or(Undefined::NotDifferentiable)?;
            let rational = self
                .arithmetic
                .as_rational(number)
                .ok_or(Unknown::Precision)?;
            if !rational.is_integer() {
                return Err(Undefined::NoInteger { what: "a bound" }.into());
            }
            let large = || Unknown::Large { what: "a bound" };
            let value = i64::try_from(&rational.to_integer()).map_err(|_| large())?;
            let product = value.checked_mul(multiple).ok_or_else(large)?;
            total = total.checked_add(product).ok_or_else(large)?;
        }
        Ok(total)
    }

    /// The function of this index: row by row from the seeds, `g[i,j+1] = a g[i,j] + b g[i-1,j]`.
    fn basis(
        &self,
        family: &Arc<Family>,
        index: &Term,
        degree: &Term,
        arguments: &[Term],
        scope: &Sc<'_, A>,
    ) -> Outcome<A> {
        let index = self.integer(index, "an index", scope)?;
        let degree = self.integer(degree, "a degree", scope)?;
        let arguments: Vec<Value<A::Number>> = arguments
            .iter()
            .map(|argument| self.term(argument, scope))
            .collect::<Result<_, _>>()?;
        let functions = self.functions(family, degree, arguments, scope)?;
        let function = usize::try_from(index)
            .ok()
            .and_then(|i| functions.get(i).cloned());
        Ok(function.map_or_else(|| self.integer_value(0), Value::Number))
    }

    /// All functions of a degree at these arguments.
    pub(crate) fn functions(
        &self,
        family: &Arc<Family>,
        degree: i64,
        arguments: Vec<Value<A::Number>>,
        scope: &Sc<'_, A>,
    ) -> Result<Rc<[Series<A::Number>]>, Gap> {
        let steps = degree - i64::from(family.degree);
        if steps < 0 {
            return Err(Undefined::BelowSeeds {
                name: family.name.to_string(),
                degree,
                least: family.degree,
            }
            .into());
        }
        if degree > MAX_DEGREE {
            return Err(Unknown::Large { what: "a degree" }.into());
        }
        let key = Arc::as_ptr(family).addr();
        // Where seeds or step vary with a binder or a bound symbol, the arguments alone do not tell the functions.
        let alike = family.closed && scope.innermost_symbol().is_none();
        if alike {
            let rows = self.rows.borrow();
            let known = rows.iter().find(|row| {
                row.family == key && row.degree == degree && row.arguments == arguments
            });
            if let Some(known) = known {
                return Ok(Rc::clone(&known.functions));
            }
        }
        let variables = &family.variables;
        let recursion = || self.recursion(family, steps, variables, &arguments, scope);
        let functions: Rc<[_]> = stack::deep(recursion)?.into();
        if alike {
            let mut rows = self.rows.borrow_mut();
            if rows.len() >= 24 {
                rows.remove(0);
            }
            rows.push(Row {
                family: key,
                degree,
                arguments,
                functions: Rc::clone(&functions),
            });
        }
        Ok(functions)
    }

    fn recursion(
        &self,
        family: &Family,
        steps: i64,
        variables: &[Variable],
        arguments: &[Value<A::Number>],
        scope: &Sc<'_, A>,
    ) -> Result<Vec<Series<A::Number>>, Gap> {
        let a = self.arithmetic;
        if let (Some((variable, variables)), Some((argument, arguments))) =
            (variables.split_first(), arguments.split_first())
        {
            let inner = scope.with(variable.number(), argument.clone());
            return self.recursion(family, steps, variables, arguments, &inner);
        }
        let mut row: Vec<Series<A::Number>> = family
            .seeds
            .iter()
            .map(|seed| self.number(seed, scope))
            .collect::<Result<_, _>>()?;
        if let Some(counters) = &family.counters {
            for k in i64::from(family.degree)..i64::from(family.degree) + steps {
                row = self.counted(family, counters, &row, k + 1, scope)?;
            }
            return Ok(row);
        }
        // Factors that multiply nothing are not looked at.
        if steps == 0 {
            return Ok(row);
        }
        let (keep, shift) = (
            self.number(&family.step.0, scope)?,
            self.number(&family.step.1, scope)?,
        );
        let zero = Series::integer(0, a);
        for _ in 0..steps {
            let same = row.iter().chain(std::iter::once(&zero));
            let before = std::iter::once(&zero).chain(&row);
            let mut next = Vec::with_capacity(row.len() + 1);
            for (same, before) in same.zip(before) {
                next.push(keep.times(same, a)?.plus(&shift.times(before, a)?, a)?);
            }
            row = next;
        }
        Ok(row)
    }

    /// The functions of degree k from those of one degree less, where the factors depend on the index and on k: each
    /// function that there is counts with its factor, and no other factor is looked at.
    fn counted(
        &self,
        family: &Family,
        (index, order): &(Variable, Variable),
        before: &[Series<A::Number>],
        k: i64,
        scope: &Sc<'_, A>,
    ) -> Result<Vec<Series<A::Number>>, Gap> {
        let a = self.arithmetic;
        let scope = scope.with(order.number(), self.integer_value(k));
        let functions = (0..=k).map(|i| {
            let scope = scope.with(index.number(), self.integer_value(i));
            let at = |place: i64| usize::try_from(place).ok().and_then(|p| before.get(p));
            let mut sum = Series::integer(0, a);
            for (factor, function) in [(&family.step.0, at(i)), (&family.step.1, at(i - 1))] {
                if let Some(function) = function {
                    let factor = self.number(factor, &scope)?;
                    sum = sum.plus(&factor.times(function, a)?, a)?;
                }
            }
            Ok(sum)
        });
        functions.collect()
    }

    /// A chain `a + b - c + ...` or any other operator: the left operands are walked without recursion, so that long
    /// sums are not deep.
    fn chain(&self, term: &Term, scope: &Sc<'_, A>) -> Outcome<A> {
        let mut rights = vec![];
        let mut left = term;
        if let Node::Binary(operator, a, b) = &*term.node
            && !matches!(&*a.node, Node::Binary(..))
        {
            return self.binary(*operator, &self.term(a, scope)?, b, scope);
        }
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
        left: &Value<A::Number>,
        right: &Term,
        scope: &Sc<'_, A>,
    ) -> Outcome<A> {
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
                let base = left.clone().number()?;
                if exponent.abs() > MAX_EXPONENT {
                    return Err(Unknown::Large {
                        what: "an exponent",
                    }
                    .into());
                }
                self.check_power(&base, exponent)?;
                let power = base.power(exponent.unsigned_abs(), a)?;
                Ok(Value::Number(if exponent < 0 {
                    Series::integer(1, a).over(&power, a)?
                } else {
                    power
                }))
            }
        }
    }

    fn check_power(&self, base: &Series<A::Number>, exponent: i64) -> Result<(), Gap> {
        let size = match base {
            Series::Number(n) => self.arithmetic.bit_length(n).unwrap_or(1),
            Series::Powers { terms, .. } => {
                return terms
                    .first()
                    .map_or(Ok(()), |first| self.check_power(first, exponent));
            }
        };
        if size.saturating_mul(exponent.unsigned_abs()) > MAX_POWER_BITS {
            return Err(Unknown::Large { what: "a power" }.into());
        }
        Ok(())
    }

    /// Entries are counted from 1.
    fn entry(&self, of: &Term, indices: &[Term], scope: &Sc<'_, A>) -> Outcome<A> {
        let mut value = self.term(of, scope)?;
        for index in indices {
            let index = self.integer(index, "an index", scope)?;
            let Value::Many(items) = value else {
                return Err(Gap::shape("an entry of a number"));
            };
            let position = index.checked_sub(1).and_then(|p| usize::try_from(p).ok());
            let found = position.and_then(|p| items.get(p).cloned());
            value = found.ok_or_else(|| Undefined::IndexOutside {
                name: "entry".to_owned(),
                index,
                low: 1,
                high: i64::try_from(items.len()).unwrap_or(i64::MAX),
            })?;
        }
        Ok(value)
    }

    /// The values of an index from one bound to the other: of what, and what its bounds are called.
    fn values_of_index(
        &self,
        low: &Term,
        high: &Term,
        [what, bound]: [&'static str; 2],
        scope: &Sc<'_, A>,
    ) -> Result<RangeInclusive<i64>, Gap> {
        let low = self.integer(low, bound, scope)?;
        let high = self.integer(high, bound, scope)?;
        if high.saturating_sub(low) > MAX_TERMS {
            return Err(Unknown::Large { what }.into());
        }
        Ok(low..=high)
    }

    /// Term by term; an empty sum is 0.
    fn sum(
        &self,
        index: u32,
        low: &Term,
        high: &Term,
        term: &Term,
        scope: &Sc<'_, A>,
    ) -> Outcome<A> {
        let mut values = self.values_of_index(low, high, ["a sum", "a bound of a sum"], scope)?;
        values.try_fold(self.integer_value(0), |total, i| {
            let inner = scope.with(index, self.integer_value(i));
            total.plus(&self.term(term, &inner)?, self.arithmetic)
        })
    }

    /// Factor by factor, from the left; an empty product is 1.
    fn product(
        &self,
        index: u32,
        low: &Term,
        high: &Term,
        term: &Term,
        scope: &Sc<'_, A>,
    ) -> Outcome<A> {
        let mut values =
            self.values_of_index(low, high, ["a product", "a bound of a product"], scope)?;
        values.try_fold(self.integer_value(1), |product, i| {
            let inner = scope.with(index, self.integer_value(i));
            product.times(&self.term(term, &inner)?, self.arithmetic)
        })
    }

    /// `order!` times the coefficient of `e^order` of the body at `at + e`.
    fn derivative(
        &self,
        variable: u32,
        order: i64,
        (body, closed): (&Term, bool),
        point: Series<A::Number>,
        scope: &Sc<'_, A>,
    ) -> Outcome<A> {
        let a = self.arithmetic;
        if order < 0 {
            let what = "the order of a derivative";
            return Err(Undefined::Negative { what }.into());
        }
        if order > MAX_ORDER {
            let what = "the order of a derivative";
            return Err(Unknown::Large { what }.into());
        }
        let terms = usize::try_from(order).unwrap_or(0);
        let factorial = (1..=order).map(torse_numbers::rational::integer).product();
        let factorial = Series::rational(&factorial, a);
        let read = |level: usize, value: &Value<A::Number>| {
            value.each(&|s| s.coefficient(level, terms, a).times(&factorial, a))
        };
        let level = scope.level + 1;
        let expanded = || {
            let mut inner = scope.with(
                variable,
                Value::Number(point.clone().shifted(level, terms, a)),
            );
            inner.level = level;
            self.term(body, &inner)
        };
        if !closed {
            return read(level, &expanded()?);
        }
        // An expansion to a higher order at the same point, of a formula that depends on nothing else, has all lower ones.
        let key = Arc::as_ptr(&body.node).addr();
        let memory = self.memory_for(body, scope);
        if let Some(known) = memory.expansions.borrow().get(&key).and_then(|all| {
            all.iter()
                .find(|known| known.order >= terms && known.point == point)
        }) {
            return read(known.level, &known.value);
        }
        let value = expanded()?;
        let derivative = read(level, &value);
        let expansion = Expansion {
            point,
            level,
            order: terms,
            value,
        };
        memory
            .expansions
            .borrow_mut()
            .entry(key)
            .or_default()
            .push(expansion);
        derivative
    }
}

fn no_value(name: &str) -> Gap {
    Unknown::NoValue {
        name: name.to_owned(),
    }
    .into()
}
