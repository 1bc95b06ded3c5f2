//! The value of a tree at a point: one rule for each construct, in the order of the tables of SEMANTICS.md.
//!
//! All parts are evaluated before the whole, so a formula with an undefined part is undefined. Names are resolved
//! when they are met, in the [`Environment`] of their place; there is no second tree in which they would be resolved
//! before.

use super::environment::{Environment, Part};
use super::jets::{Jets, Smooth};
use super::memory::Memory;
use crate::arithmetic::Arithmetic;
use crate::judgement::Judgement;
use crate::name::Name;
use crate::no_value::{NoValue, Undefined, Unknown};
use crate::series::Series;
use crate::value::Value;
use std::cell::{Cell, RefCell};
use std::collections::BTreeMap;
use std::rc::Rc;
use std::sync::Arc;
use torse_numbers::stack;
use torse_syntax::derivation::declarations::{Declarations, Definition, SymbolKind};
use torse_syntax::formula::functions::FUNCTIONS;
use torse_syntax::formula::{Expr, Node, Operator};

/// The largest nesting depth of formulas including definitions, where a chain of one operator counts once: 80 nested
/// definitions of 300 levels each, which is the deepest that can be written. Each definition and each basis makes
/// sure that the stack is large enough for its own levels.
const MAX_DEPTH: usize = 80 * 300;
/// The largest exponent.
const MAX_EXPONENT: i64 = 2000;
/// The largest power, in bits.
const MAX_POWER_BITS: u64 = 20_000;

/// The meaning of a formula.
pub(super) enum Meaning<N> {
    /// A number, a vector or a matrix.
    Value(Value<N>),
    /// A statement, with the judgement on it here.
    Statement(Judgement),
}

/// The values of a point, and what the evaluator knows about the claim.
pub(crate) struct Point<'e, N> {
    /// The numbers.
    pub values: &'e dyn Fn(&Name) -> Option<N>,
    /// Whether they satisfy the equations of the domain only approximately.
    pub near: bool,
    /// The statements that are known to fail somewhere in the domain.
    pub failing: &'e dyn Fn(&Expr) -> bool,
}

/// A smooth function of the point; `None` while its values are being computed.
pub(super) type Known<N> = Option<Rc<Smooth<N>>>;
/// Divisors, each with the address of the tree node that divides by it.
pub(super) type Divisors<N> = Vec<(usize, N)>;

/// Evaluates trees at one point.
pub(crate) struct Evaluator<'a, 'e, A: Arithmetic> {
    pub declarations: &'a Declarations,
    pub arithmetic: &'e A,
    pub point: Point<'e, A::Number>,
    /// The places at which derivatives of smooth functions are given.
    pub jets: &'a Jets,
    /// The given equations and their unknowns, if `coefficients` is evaluated along their solutions.
    pub given: RefCell<Option<Given<'a>>>,
    pub(super) memory: Memory<'a, A::Number>,
    pub(super) smooth: RefCell<BTreeMap<&'a str, Known<A::Number>>>,
    symbols: RefCell<BTreeMap<&'a str, Series<A::Number>>>,
    /// Records divisors while an integral needs them.
    pub divisors: RefCell<Option<Divisors<A::Number>>>,
    /// The address of the leaf whose value is changed deliberately.
    pub slip: Cell<Option<usize>>,
    /// The highest level of infinitesimals in use.
    pub level: Cell<usize>,
    depth: Rc<Cell<usize>>,
}

/// The given equations of a claim, and their unknowns.
#[derive(Clone)]
pub(crate) struct Given<'a> {
    pub equations: Vec<&'a Expr>,
    pub unknowns: Vec<&'a Expr>,
}

/// Counts one level of nesting until it is dropped.
pub(super) struct Deeper(Rc<Cell<usize>>);

impl Drop for Deeper {
    fn drop(&mut self) {
        self.0.set(self.0.get().saturating_sub(1));
    }
}

pub(super) type Outcome<A> = Result<Value<<A as Arithmetic>::Number>, NoValue>;
type Place<'a, A> = Environment<'a, <A as Arithmetic>::Number>;

impl<'a, 'e, A: Arithmetic> Evaluator<'a, 'e, A> {
    /// An evaluator at a point, without a cache.
    pub fn new(
        declarations: &'a Declarations,
        jets: &'a Jets,
        arithmetic: &'e A,
        point: Point<'e, A::Number>,
    ) -> Self {
        Self {
            declarations,
            arithmetic,
            point,
            jets,
            given: RefCell::default(),
            memory: Memory::none(),
            smooth: RefCell::default(),
            symbols: RefCell::default(),
            divisors: RefCell::default(),
            slip: Cell::default(),
            level: Cell::default(),
            depth: Rc::default(),
        }
    }

    /// The evaluator with a cache.
    pub fn remembering(self) -> Self {
        Self {
            memory: Memory::new(),
            ..self
        }
    }

    /// The evaluator with given equations: `coefficients` is evaluated along their solutions.
    pub(crate) fn along(self, given: Option<Given<'a>>) -> Self {
        Self {
            given: RefCell::new(given),
            ..self
        }
    }

    pub(super) fn deeper(&self) -> Result<Deeper, NoValue> {
        let depth = self.depth.get();
        if depth >= MAX_DEPTH {
            let what = "the depth of a formula";
            return Err(Unknown::Large { what }.into());
        }
        self.depth.set(depth + 1);
        Ok(Deeper(Rc::clone(&self.depth)))
    }

    /// The value of a formula: a number, vector or matrix.
    pub(super) fn value(&self, tree: &'a Expr, place: &Place<'a, A>) -> Outcome<A> {
        match self.meaning(tree, place)? {
            Meaning::Value(value) if self.slip.get() == Some(std::ptr::from_ref(tree).addr()) => {
                self.slipped(value)
            }
            Meaning::Value(value) => Ok(value),
            Meaning::Statement(_) => Err(NoValue::shape("a statement where a number is needed")),
        }
    }

    pub(super) fn number(
        &self,
        tree: &'a Expr,
        place: &Place<'a, A>,
    ) -> Result<Series<A::Number>, NoValue> {
        self.value(tree, place)?.number()
    }

    /// The value of a formula that must be an integer and contain no infinitesimal.
    pub(super) fn integer(
        &self,
        tree: &'a Expr,
        what: &'static str,
        place: &Place<'a, A>,
    ) -> Result<i64, NoValue> {
        self.whole(&self.number(tree, place)?, what)
    }

    fn whole(&self, value: &Series<A::Number>, what: &'static str) -> Result<i64, NoValue> {
        // An index that depends on the differentiation variable is not locally constant.
        let number = value.as_number().ok_or(Undefined::NotDifferentiable)?;
        let rational = self.arithmetic.as_rational(number);
        let rational = rational.ok_or(Unknown::Precision)?;
        if !rational.is_integer() {
            return Err(Undefined::NoInteger { what }.into());
        }
        i64::try_from(&rational.to_integer()).map_err(|_| Unknown::Large { what }.into())
    }

    pub(super) fn integer_value(&self, n: i64) -> Value<A::Number> {
        Value::Number(Series::integer(n, self.arithmetic))
    }

    /// The meaning of a formula.
    pub(super) fn meaning(
        &self,
        tree: &'a Expr,
        place: &Place<'a, A>,
    ) -> Result<Meaning<A::Number>, NoValue> {
        let _deeper = self.deeper()?;
        let a = self.arithmetic;
        Ok(Meaning::Value(match &tree.node {
            Node::Number { value, .. } => Value::Number(Series::rational(value, a)),
            Node::Name(name) => return self.named(name, place),
            Node::Call(head, arguments) => return self.call(tree, head, arguments, place),
            Node::Index(head, indices) => self.indexed(head, indices, place)?,
            Node::Negative(inner) => self.value(inner, place)?.negated(a),
            Node::Binary(..) => self.chain(tree, place)?,
            Node::List(items) => {
                let items = items.iter().map(|item| self.value(item, place));
                Value::Many(items.collect::<Result<_, _>>()?)
            }
            Node::Compare(..) | Node::Join(..) | Node::Not(_) => {
                return self.statement(tree, place).map(Meaning::Statement);
            }
        }))
    }

    /// The value of a name.
    pub(super) fn named_value(&self, name: &'a str, place: &Place<'a, A>) -> Outcome<A> {
        match self.named(name, place)? {
            Meaning::Value(value) => Ok(value),
            Meaning::Statement(_) => Err(NoValue::shape("a statement where a number is needed")),
        }
    }

    /// The meaning of a name: a local name, a moved symbol, a definition, a symbol, or `pi`.
    fn named(&self, name: &'a str, place: &Place<'a, A>) -> Result<Meaning<A::Number>, NoValue> {
        if let Some(local) = place.local(name) {
            return Ok(Meaning::Value(local.value.clone()));
        }
        if let Some(definition) = self.declarations.definition(name) {
            if !definition.parameters.is_empty() {
                return Err(NoValue::shape("a function where a number is needed"));
            }
            let body = &definition.body.expr;
            let outside = place.outside();
            let evaluate = || stack::deep(|| self.meaning(body, &outside));
            return self.remembered(body, place, evaluate);
        }
        Ok(Meaning::Value(match self.declarations.symbol(name) {
            Some(SymbolKind::Real(_) | SymbolKind::Integer { .. } | SymbolKind::Vector(None)) => {
                Value::Number(self.symbol(name, &Part::Whole, place)?)
            }
            Some(SymbolKind::Vector(Some(dimension))) => {
                let coordinate = |c| self.symbol(name, &Part::Coordinate(c), place);
                Value::vector((1..=*dimension).map(coordinate).collect::<Result<_, _>>()?)
            }
            Some(SymbolKind::Family { .. }) => {
                return Err(NoValue::shape("a family where a number is needed"));
            }
            None if name == "pi" => Value::Number(Series::Number(self.arithmetic.pi())),
            None => return Err(no_value(name)),
        }))
    }

    /// The value of a number of a declared symbol: its moved value if it has one, otherwise its value at the point.
    pub(super) fn symbol(
        &self,
        name: &'a str,
        part: &Part,
        place: &Place<'a, A>,
    ) -> Result<Series<A::Number>, NoValue> {
        if !place.moved.is_empty()
            && let Some(moved) = place.moved(name, part)
        {
            return Ok(moved.value.clone());
        }
        if *part == Part::Whole
            && let Some(known) = self.symbols.borrow().get(name)
        {
            return Ok(known.clone());
        }
        let declared: Arc<str> = Arc::from(name);
        let asked = match part {
            Part::Whole => Name::Symbol(declared),
            Part::Coordinate(c) => Name::Coordinate(declared, *c),
            Part::Member(indices, c) => Name::Member(declared, indices.clone(), *c),
        };
        let number = (self.point.values)(&asked).ok_or_else(|| no_value(&asked.to_string()))?;
        let value = Series::Number(number);
        if *part == Part::Whole {
            self.symbols.borrow_mut().insert(name, value.clone());
        }
        Ok(value)
    }

    /// The built-in function of this name, unless the name has another meaning here.
    pub(super) fn built_in(&self, name: &str, place: &Place<'a, A>) -> Option<&'static str> {
        let own = FUNCTIONS.iter().find(|own| **own == name)?;
        let free = place.local(name).is_none() && self.declarations.definition(name).is_none();
        free.then_some(*own)
    }

    fn call(
        &self,
        tree: &'a Expr,
        head: &'a Expr,
        arguments: &'a [Expr],
        place: &Place<'a, A>,
    ) -> Result<Meaning<A::Number>, NoValue> {
        if let Node::Index(family, indices) = &head.node
            && let Node::Name(name) = &family.node
            && let Some(basis) = self.basis_named(name, place)
        {
            return Ok(Meaning::Value(
                self.basis_function(name, basis, indices, arguments, place)?,
            ));
        }
        if let Node::Name(name) = &head.node
            && let Some(name) = self.built_in(name, place)
        {
            return self.applied(tree, name, arguments, place);
        }
        if let Node::Name(name) = &head.node
            && let Some(definition) = self.definition_named(name, place)
            && definition.indexed
        {
            return Err(NoValue::shape("a family at arguments in round brackets"));
        }
        let function = self.function(head, place)?;
        let function = function.ok_or_else(|| NoValue::shape("a number at arguments"))?;
        let arguments = arguments.iter().map(|argument| self.value(argument, place));
        let arguments = arguments.collect::<Result<_, _>>()?;
        Ok(Meaning::Value(self.apply(&function, arguments)?))
    }

    /// The definition that a name denotes here.
    fn definition_named(&self, name: &str, place: &Place<'a, A>) -> Option<&'a Definition> {
        if place.local(name).is_some() {
            return None;
        }
        self.declarations.definition(name)
    }

    /// The value of the body of a definition with its parameters bound; it sees them and the moved symbols only.
    pub(super) fn called(
        &self,
        definition: &'a Definition,
        moved: &super::environment::Chain<super::environment::Moved<'a, A::Number>>,
        arguments: Vec<Value<A::Number>>,
    ) -> Outcome<A> {
        if arguments.len() != definition.parameters.len() {
            return Err(NoValue::shape("a number of arguments"));
        }
        let outside = Environment {
            local: super::environment::Chain::new(),
            moved: moved.clone(),
        };
        let body = &definition.body.expr;
        self.remembered_call(body, &outside, arguments, |arguments| {
            let bound = definition.parameters.iter().zip(arguments);
            let inside = bound.fold(outside.clone(), |inside, (name, value)| {
                inside.with_local(name, value, definition.indexed)
            });
            stack::deep(|| self.value(body, &inside))
        })
    }

    /// `F[i]` for a definition, `B[i,k]`, `P[i]`, or an entry of a vector or matrix.
    fn indexed(&self, head: &'a Expr, indices: &'a [Expr], place: &Place<'a, A>) -> Outcome<A> {
        if let Node::Name(name) = &head.node
            && place.local(name).is_none()
        {
            match self.declarations.definition(name) {
                Some(definition) if definition.indexed => {
                    let values = indices.iter().map(|index| self.value(index, place));
                    let values = values.collect::<Result<_, _>>()?;
                    return self.called(definition, &place.moved, values);
                }
                Some(_) => {}
                None => {
                    if let Some(basis) = self.declarations.basis(name) {
                        return self.basis_function(name, basis, indices, &[], place);
                    }
                    if let Some(SymbolKind::Family { dimension, ranges }) =
                        self.declarations.symbol(name)
                    {
                        return self.member(name, *dimension, ranges, indices, place);
                    }
                }
            }
        }
        let value = self.value(head, place)?;
        self.entry(value, indices, place)
    }

    /// The entry of a vector or matrix; indices begin at 1.
    pub(super) fn entry(
        &self,
        mut value: Value<A::Number>,
        indices: &'a [Expr],
        place: &Place<'a, A>,
    ) -> Outcome<A> {
        for index in indices {
            let index = self.integer(index, "an index", place)?;
            let Value::Many(items) = value else {
                return Err(NoValue::shape("an entry of a number"));
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

    /// A chain `a + b - c + ...` or any other operator. Left operands are visited without recursion, so that long
    /// sums need no deep stack.
    fn chain(&self, tree: &'a Expr, place: &Place<'a, A>) -> Outcome<A> {
        let mut rights = vec![];
        let mut left = tree;
        while let Node::Binary(operator, a, b) = &left.node {
            rights.push((*operator, b, left));
            left = a;
        }
        let mut value = self.value(left, place)?;
        while let Some((operator, right, whole)) = rights.pop() {
            value = self.binary(operator, value, right, whole, place)?;
        }
        Ok(value)
    }

    fn binary(
        &self,
        operator: Operator,
        left: Value<A::Number>,
        right: &'a Expr,
        node: &'a Expr,
        place: &Place<'a, A>,
    ) -> Outcome<A> {
        let a = self.arithmetic;
        match operator {
            Operator::Add => left.plus(&self.value(right, place)?, a),
            Operator::Subtract => left.plus(&self.value(right, place)?.negated(a), a),
            Operator::Multiply => left.times(&self.value(right, place)?, a),
            Operator::Divide => {
                let divisor = self.number(right, place)?;
                self.divides(node, &divisor);
                left.each(&|x| x.over(&divisor, a))
            }
            Operator::Power => {
                let exponent = self.integer(right, "an exponent", place)?;
                self.power(&left.number()?, exponent, node)
            }
        }
    }

    fn power(&self, base: &Series<A::Number>, exponent: i64, node: &'a Expr) -> Outcome<A> {
        let a = self.arithmetic;
        if exponent.abs() > MAX_EXPONENT {
            let what = "an exponent";
            return Err(Unknown::Large { what }.into());
        }
        let mut first = base;
        while let Series::Powers { terms, .. } = first
            && let Some(term) = terms.first()
        {
            first = term;
        }
        let size = first.as_number().and_then(|number| a.bit_length(number));
        if size.unwrap_or(1).saturating_mul(exponent.unsigned_abs()) > MAX_POWER_BITS {
            return Err(Unknown::Large { what: "a power" }.into());
        }
        let power = base.power(exponent.unsigned_abs(), a)?;
        if exponent >= 0 {
            return Ok(Value::Number(power));
        }
        self.divides(node, base);
        Ok(Value::Number(Series::integer(1, a).over(&power, a)?))
    }

    /// Records a divisor if an integral needs it.
    pub(super) fn divides(&self, node: &'a Expr, divisor: &Series<A::Number>) {
        let mut divisors = self.divisors.borrow_mut();
        if let Some(all) = divisors.as_mut() {
            let mut first = divisor;
            while let Series::Powers { terms, .. } = first
                && let Some(term) = terms.first()
            {
                first = term;
            }
            if let Some(number) = first.as_number() {
                all.push((std::ptr::from_ref(node).addr(), number.clone()));
            }
        }
    }
}

pub(super) fn no_value(name: &str) -> NoValue {
    Unknown::NoValue {
        name: name.to_owned(),
    }
    .into()
}
