//! From core terms to exact values.
//!
//! One walk over the term: [`value`] says what comes out, [`series`] carries symbolic degrees, `sum` and [`basis`]
//! make them, `functions` holds the built-in functions. A variable of a binder has the value that the
//! [`Environment`] gives it; a derivative gives it a symbol that nothing else has, and puts the value in afterwards.

mod angles;
mod arithmetic;
pub mod basis;
mod coefficients;
mod each;
mod functions;
mod index;
mod indexed_recurrence;
mod integral;
pub mod linear;
mod memory;
mod own_names;
mod place;
mod power_sum;
mod product;
pub mod quantity;
pub mod series;
mod sum;
mod symbolic_power;
pub mod value;

use memory::Memory;
use quantity::Quantity;
use std::cell::{Cell, RefCell};
use std::collections::{BTreeMap, BTreeSet};
use std::rc::Rc;
use std::sync::Arc;
use torse_algebra::{Affine, Fraction, Symbol, work};
use torse_core::{self as core, Node, Term, stack};
use torse_elaborate::{Elaborator, Meaning};
use torse_syntax::derivation::declarations::Declarations;
use torse_syntax::fault::{Fault, Problem};
use torse_syntax::formula::{Expr, Place};
use value::{Statement, Value, Vector};

/// What visiting a node costs, in units of [`work`].
const NODE_WORK: u64 = 8;
/// How many nodes one formula may visit: formulas of papers stay far below.
const MAX_NODES: u64 = 400_000;

/// Values of the variables of enclosing binders, by their numbers.
pub type Environment = BTreeMap<u32, Value>;

/// A family at a degree, and whether in an angle.
type Degree = (Arc<str>, usize, bool);

/// Arguments of a family and its functions there.
type Row = (Vec<Fraction>, Rc<[Fraction]>);

/// Evaluates formulas under declarations, with some symbols fixed and some unknowns solved for.
#[derive(Clone)]
pub struct Evaluator<'a> {
    /// What names mean.
    pub declarations: &'a Declarations,
    /// Opens formulas.
    elaborator: Rc<Elaborator<'a>>,
    /// Symbols with a value: instantiated integers, assumed equalities, witness points.
    fixed: BTreeMap<String, Fraction>,
    /// Unknowns that equations determine.
    solved: BTreeMap<Symbol, Fraction>,
    /// The symbols whose values are those of equations among the hypotheses: no other symbol moves them.
    assumed: BTreeSet<Symbol>,
    /// Whether given equations determine unknowns: these are functions of the other symbols.
    has_given: bool,
    /// Whether leaves are replaced by the numbers of the sample point.
    sampled: bool,
    /// Whether the argument of a sine or cosine is being evaluated: there symbols stay symbols.
    in_angle: Cell<bool>,
    /// Whether a series of symbolic degree was met.
    symbolic_degree: Cell<bool>,
    nodes: Cell<u64>,
    work: Cell<u64>,
    /// How many symbols of the engine's own were made.
    made: Cell<u64>,
    /// The sums of symbolic length that are being evaluated: the symbol of the index, its first and last value.
    sums: RefCell<Vec<(String, Affine, Affine)>>,
    /// The functions of families, by name, steps of the recursion and whether they stand in an angle.
    members: RefCell<BTreeMap<Degree, Vec<Row>>>,
    /// How many derivatives enclose the term that is evaluated.
    derivatives: Cell<u32>,
    memory: Memory,
}

use arithmetic::{fitted, matrix_product, multiplied, numeric, refilled};

type Outcome<T> = Result<T, Fault>;

impl<'a> Evaluator<'a> {
    /// An evaluator with nothing fixed and nothing solved.
    #[must_use]
    pub fn new(declarations: &'a Declarations) -> Self {
        Self::with(Rc::new(Elaborator::new(declarations)))
    }

    /// An evaluator that opens formulas with an elaborator of others, so that definitions are opened once.
    #[must_use]
    pub fn with(elaborator: Rc<Elaborator<'a>>) -> Self {
        Self {
            declarations: elaborator.declarations(),
            elaborator,
            fixed: BTreeMap::new(),
            solved: BTreeMap::new(),
            assumed: BTreeSet::new(),
            has_given: false,
            sampled: false,
            in_angle: Cell::new(false),
            symbolic_degree: Cell::new(false),
            nodes: Cell::new(0),
            work: Cell::new(0),
            made: Cell::new(0),
            sums: RefCell::default(),
            members: RefCell::default(),
            derivatives: Cell::new(0),
            memory: Memory::default(),
        }
    }

    /// What opens the formulas.
    #[must_use]
    pub fn elaborator(&self) -> &Rc<Elaborator<'a>> {
        &self.elaborator
    }

    /// Symbols mean something else from here on.
    fn forget(&mut self) {
        self.memory.forget();
        self.members.take();
    }

    /// Gives a symbol a value from here on.
    pub fn fix(&mut self, name: String, value: Fraction) {
        self.forget();
        self.fixed.insert(name, value);
    }

    /// The symbols with a value.
    #[must_use]
    pub fn fixed(&self) -> &BTreeMap<String, Fraction> {
        &self.fixed
    }

    /// Gives unknowns their values from here on.
    pub fn determine(&mut self, solution: impl IntoIterator<Item = (Symbol, Fraction)>) {
        self.forget();
        self.solved.extend(solution);
    }

    /// Records that an equation among the hypotheses says what a symbol is.
    pub fn assume(&mut self, symbol: Symbol) {
        self.assumed.insert(symbol);
    }

    /// Records that given equations determine unknowns as functions of the other symbols.
    pub fn give(&mut self) {
        self.has_given = true;
    }

    /// The same with more symbols fixed.
    #[must_use]
    pub fn fixing(&self, more: &BTreeMap<String, Fraction>) -> Self {
        let mut fixed = self.fixed.clone();
        fixed.extend(
            more.iter()
                .map(|(name, value)| (name.clone(), value.clone())),
        );
        Self {
            fixed,
            solved: self.solved.clone(),
            assumed: self.assumed.clone(),
            has_given: self.has_given,
            ..Self::with(Rc::clone(&self.elaborator))
        }
    }

    /// The same at the sample point of the search for corrections: free symbols are numbers from the
    /// start, except where sines and cosines need them.
    #[must_use]
    pub fn sampling(&self) -> Self {
        let at_sample =
            |f: &Fraction| crate::probabilistic_refuter::at_sample(f).unwrap_or_else(|| f.clone());
        let fixed = self
            .fixed
            .iter()
            .map(|(name, value)| (name.clone(), at_sample(value)))
            .collect();
        let solved = self
            .solved
            .iter()
            .map(|(symbol, value)| (symbol.clone(), at_sample(value)))
            .collect();
        Self {
            fixed,
            solved,
            assumed: self.assumed.clone(),
            has_given: self.has_given,
            sampled: true,
            ..Self::with(Rc::clone(&self.elaborator))
        }
    }

    /// The work done so far, in units of one visited node.
    #[must_use]
    pub fn work(&self) -> u64 {
        self.work.get()
    }

    fn spend(&self, units: u64) {
        self.work.set(self.work.get().saturating_add(units));
    }

    /// Whether any formula so far had a symbolic degree.
    #[must_use]
    pub fn met_symbolic_degree(&self) -> bool {
        self.symbolic_degree.get()
    }

    /// The value of a formula.
    ///
    /// # Errors
    /// [`Fault`]: undeclared names, wrong types, and what the engine cannot carry out.
    pub fn evaluate(&self, expr: &Expr) -> Outcome<Value> {
        match self.elaborator.meaning(expr)? {
            Meaning::Term(term) => self.term(&term),
            Meaning::Statement(statement) => Ok(Value::Truth(Box::new(self.truth(&statement)?))),
            Meaning::Function(_) => Err(wrong_type(
                expr.place,
                "a function",
                "a number, vector, matrix or statement",
            )),
        }
    }

    /// The value of a core term.
    ///
    /// # Errors
    /// [`Fault`]: wrong types, and what the engine cannot carry out.
    pub fn term(&self, term: &Term) -> Outcome<Value> {
        self.nodes.set(0);
        stack::deep(|| self.value(term, &Environment::new()))
    }

    /// The statement that a formula makes.
    ///
    /// # Errors
    /// [`Fault`]; a formula that is no statement is of the wrong type.
    pub fn statement(&self, expr: &Expr) -> Outcome<Statement> {
        self.truth(&self.elaborator.statement(expr)?)
    }

    /// A core statement with its terms evaluated.
    ///
    /// # Errors
    /// [`Fault`]: wrong types, and what the engine cannot carry out.
    pub fn truth(&self, statement: &core::Statement) -> Outcome<Statement> {
        self.nodes.set(0);
        stack::deep(|| self.stated(statement))
    }

    fn stated(&self, statement: &core::Statement) -> Outcome<Statement> {
        let nothing = Environment::new();
        Ok(match statement {
            core::Statement::Compare {
                relation,
                left,
                right,
            } => {
                let place = left.place.to(right.place);
                let (left, right) = (self.value(left, &nothing)?, self.value(right, &nothing)?);
                let (left, right) = fitted(&left, &right, place)?;
                let (left, right) = angles::in_finest(left, right, place)?;
                Statement::Compare {
                    relation: *relation,
                    left: Box::new(left),
                    right: Box::new(right),
                }
            }
            core::Statement::Agrees {
                value,
                printed,
                place,
            } => self.agreement(value, printed, *place, &nothing)?,
            core::Statement::Family(property, family) => Statement::Family {
                property: *property,
                family: Arc::clone(family),
            },
            core::Statement::Join(connective, a, b) => Statement::Join(
                *connective,
                Box::new(self.stated(a)?),
                Box::new(self.stated(b)?),
            ),
            core::Statement::Not(inner) => Statement::Not(Box::new(self.stated(inner)?)),
        })
    }

    fn value(&self, term: &Term, bound: &Environment) -> Outcome<Value> {
        match self.sampled && self.elaborator.is_kept(term) {
            true => self.shared(term, || self.visit(term, bound)),
            false => self.visit(term, bound),
        }
    }

    fn visit(&self, term: &Term, bound: &Environment) -> Outcome<Value> {
        self.nodes.set(self.nodes.get() + 1);
        self.spend(1);
        let place = term.place;
        work::spend(NODE_WORK).map_err(|limit| Fault::limit(place, limit.to_string()))?;
        if self.nodes.get() > MAX_NODES {
            return Err(Fault::limit(
                place,
                format!("the formula takes more than {MAX_NODES} steps"),
            ));
        }
        match &*term.node {
            Node::Number(value) => Ok(Fraction::from(value.clone()).into()),
            Node::Pi => Ok(self.leaf(Symbol::Pi).into()),
            Node::Symbol(name) => match self.fixed.get(&**name) {
                Some(value) => Ok(value.clone().into()),
                None => Ok(self.leaf(Symbol::named(name)).into()),
            },
            Node::Variable(variable) => bound.get(&variable.number()).cloned().ok_or_else(|| {
                wrong_type(
                    place,
                    "a variable of no enclosing binder",
                    "a bound variable",
                )
            }),
            Node::Vector(name, None) => Ok(generic(self.leaf(Symbol::indexed(name, vec![])))),
            Node::Vector(name, Some(dimension)) => {
                let entry = |c| self.leaf(Symbol::indexed(name, vec![Affine::number(c)]));
                Ok(Value::Vector(Vector {
                    entries: (1..=i64::from(*dimension))
                        .map(|c| entry(c).into())
                        .collect(),
                    generic: false,
                }))
            }
            Node::Member(points, indices) => self.point(points, indices, bound),
            Node::Basis {
                family,
                index,
                degree,
                arguments,
            } => self.member(family, index, degree, arguments, place, bound),
            Node::Negative(inner) => {
                let value = self.value(inner, bound)?;
                numeric(&value, inner.place)?;
                value.mapped(&|q: &Quantity| Ok(q.negated()))
            }
            Node::Binary(operator, a, b) => self.binary(*operator, a, b, bound),
            Node::List(items) => self.list(items, bound),
            Node::Entry(of, indices) => self.entry(place, of, indices, bound),
            Node::Sum {
                index,
                low,
                high,
                term,
            } => self.sum(index, low, high, term, place, bound),
            Node::Product {
                index,
                low,
                high,
                term,
            } => self.index_product(index, low, high, term, place, bound),
            Node::Integral {
                variable,
                low,
                high,
                body,
            } => self.remembered(term, bound, || {
                self.symbolically(|| self.integral(variable, [low, high], body, place, bound))
            }),
            Node::Let {
                variable,
                value,
                body,
            } => {
                let value = self.value(value, bound)?;
                let mut inner = bound.clone();
                inner.insert(variable.number(), value);
                self.value(body, &inner)
            }
            Node::Derivative {
                variable,
                order,
                body,
                at,
                ..
            } => self.remembered(term, bound, || {
                self.symbolically(|| self.derivative(variable, order, body, at, place, bound))
            }),
            Node::Apply(function, arguments) => self.apply(*function, arguments, place, bound),
            Node::Opened { origin, body, .. } => self.remembered(body, bound, || {
                self.value(body, bound).map_err(|f| f.within(origin))
            }),
        }
    }

    /// The name of a symbol that nothing else has.
    fn fresh(&self, name: &str) -> String {
        let number = self.made.get();
        self.made.set(number + 1);
        own_names::numbered(name, number)
    }

    /// The name of the variable of a derivative inside so many others. No value outside of the derivative has it, so that
    /// the next one may have the same, and what was evaluated with it serves again.
    fn differential(&self, name: &str, enclosing: u32) -> String {
        own_names::differential(name, enclosing)
    }

    fn list(&self, items: &[Term], bound: &Environment) -> Outcome<Value> {
        let mut entries = vec![];
        let mut rows = vec![];
        for item in items {
            match self.value(item, bound)? {
                Value::Scalar(q) => entries.push(q),
                Value::Vector(v) => rows.push((v, item.place)),
                other => return Err(wrong_type(item.place, other.kind(), "a number or a row")),
            }
        }
        match (entries.is_empty(), rows.is_empty()) {
            (false, true) => Ok(Value::Vector(Vector {
                entries,
                generic: false,
            })),
            (true, false) => {
                let width = rows.first().map_or(0, |(row, _)| row.entries.len());
                for (row, place) in &rows {
                    if row.entries.len() != width {
                        return Err(shapes(
                            *place,
                            &format!("a row of {}", row.entries.len()),
                            &format!("rows of {width}"),
                        ));
                    }
                }
                Ok(Value::Matrix(
                    rows.into_iter().map(|(row, _)| row.entries).collect(),
                ))
            }
            _ => Err(wrong_type(
                items.first().map_or_else(Place::default, |i| i.place),
                "a mixture of numbers and vectors",
                "a vector or a matrix",
            )),
        }
    }

    /// A symbol, or the value that the given equations determine for it.
    fn leaf(&self, symbol: Symbol) -> Fraction {
        if let Some(value) = self.solved.get(&symbol) {
            return value.clone();
        }
        let replaced = self.sampled && !self.in_angle.get();
        let number = if replaced {
            crate::probabilistic_refuter::value(&symbol)
        } else {
            None
        };
        number.unwrap_or_else(|| Fraction::symbol(symbol))
    }

    /// Evaluates an argument of a sine, cosine or basis function, in which symbols stay symbols.
    fn in_angle<T>(&self, inner: impl FnOnce() -> T) -> T {
        let before = self.in_angle.replace(true);
        let result = inner();
        self.in_angle.set(before);
        result
    }

    /// The value at the sample point, when sampling.
    fn at_sample(&self, value: Fraction) -> Fraction {
        if self.sampled && !self.in_angle.get() {
            return crate::probabilistic_refuter::at_sample(&value).unwrap_or(value);
        }
        value
    }

    /// Evaluates what needs symbols, such as a derivative, and takes the sample point afterwards.
    fn symbolically(&self, inner: impl FnOnce() -> Outcome<Value>) -> Outcome<Value> {
        if !self.sampled {
            return inner();
        }
        let value = self.in_angle(inner)?;
        value.mapped(&|q: &Quantity| {
            Ok(match q.as_fraction() {
                Some(plain) => self.at_sample(plain.clone()).into(),
                None => q.clone(),
            })
        })
    }
}

/// One generic coordinate.
fn generic(value: Fraction) -> Value {
    Value::Vector(Vector {
        entries: vec![value.into()],
        generic: true,
    })
}

pub(crate) fn wrong_type(place: Place, what: &'static str, wanted: &'static str) -> Fault {
    Fault::at(place, Problem::WrongType { what, wanted })
}

fn shapes(place: Place, left: &str, right: &str) -> Fault {
    Fault::at(
        place,
        Problem::Shapes {
            left: left.to_owned(),
            right: right.to_owned(),
        },
    )
}

fn symbolic_degree(place: Place) -> Fault {
    Fault::limit(place, "a sum of symbolic degree cannot be used here")
}
