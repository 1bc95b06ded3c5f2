//! From syntax to exact values.
//!
//! One walk over the tree: [`scope`] says what names mean, [`value`] what comes out, [`series`] carries
//! symbolic degrees, `sum` and [`basis`] make them, `functions` holds the built-in functions.

mod apply;
mod arithmetic;
pub mod basis;
mod functions;
mod index;
pub mod linear;
pub mod quantity;
pub mod series;
mod sum;
pub mod value;

use quantity::Quantity;
use std::cell::{Cell, RefCell};
use std::collections::BTreeMap;
use torse_algebra::{Affine, Fraction, Symbol};
use torse_language::derivation::declarations::{Declarations, SymbolKind};
use torse_language::fault::{Fault, Problem};
use torse_language::syntax::{Connective, Expr, Node, Place};
use value::{Function, Statement, Value, Vector};

/// How deep definitions may call each other.
const MAX_DEPTH: usize = 80;
/// How many nodes one formula may visit: formulas of papers stay far below.
const MAX_NODES: u64 = 400_000;

/// Values of bound names: parameters of functions and indices of sums.
pub type Bindings = BTreeMap<String, Value>;

/// Evaluates formulas under declarations, with some symbols fixed and some unknowns solved for.
pub struct Evaluator<'a> {
    /// What names mean.
    pub declarations: &'a Declarations,
    /// Symbols with a value: instantiated integers, assumed equalities, witness points.
    fixed: BTreeMap<String, Fraction>,
    /// Unknowns that the given equations determine.
    solved: BTreeMap<Symbol, Fraction>,
    /// Whether leaves are replaced by the numbers of the sample point.
    sampled: bool,
    /// Whether the argument of a sine or cosine is being evaluated: there symbols stay symbols.
    in_angle: Cell<bool>,
    /// Whether a series of symbolic degree was met.
    symbolic_degree: Cell<bool>,
    depth: Cell<usize>,
    nodes: Cell<u64>,
    work: Cell<u64>,
    members: RefCell<BTreeMap<String, Vec<Fraction>>>,
    /// Values of definitions without parameters, in and outside of angles.
    named: RefCell<BTreeMap<(String, bool), Value>>,
}

use arithmetic::{fitted, matrix_product, multiplied, numeric, refilled};

type Outcome<T> = Result<T, Fault>;

impl<'a> Evaluator<'a> {
    /// An evaluator with nothing fixed and nothing solved.
    #[must_use]
    pub fn new(declarations: &'a Declarations) -> Self {
        Self {
            declarations,
            fixed: BTreeMap::new(),
            solved: BTreeMap::new(),
            sampled: false,
            in_angle: Cell::new(false),
            symbolic_degree: Cell::new(false),
            depth: Cell::new(0),
            nodes: Cell::new(0),
            work: Cell::new(0),
            members: RefCell::new(BTreeMap::new()),
            named: RefCell::new(BTreeMap::new()),
        }
    }

    /// Gives a symbol a value from here on.
    pub fn fix(&mut self, name: String, value: Fraction) {
        self.named.borrow_mut().clear();
        self.fixed.insert(name, value);
    }

    /// Gives unknowns their values from here on.
    pub fn determine(&mut self, solution: impl IntoIterator<Item = (Symbol, Fraction)>) {
        self.named.borrow_mut().clear();
        self.solved.extend(solution);
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
            ..Self::new(self.declarations)
        }
    }

    /// The same at the sample point of the search for corrections: free symbols are numbers from the
    /// start, except where sines and cosines need them.
    #[must_use]
    pub fn sampling(&self) -> Self {
        let at_sample = |f: &Fraction| crate::sample::at_sample(f).unwrap_or_else(|| f.clone());
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
            sampled: true,
            ..Self::new(self.declarations)
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
        self.nodes.set(0);
        self.value(expr, &Bindings::new())
    }

    /// The statement that a formula makes.
    ///
    /// # Errors
    /// [`Fault`]; a formula that is no statement is of the wrong type.
    pub fn statement(&self, expr: &Expr) -> Outcome<Statement> {
        match self.evaluate(expr)? {
            Value::Truth(statement) => Ok(*statement),
            other => Err(wrong_type(expr.place, other.kind(), "a statement")),
        }
    }

    fn value(&self, expr: &Expr, bound: &Bindings) -> Outcome<Value> {
        self.nodes.set(self.nodes.get() + 1);
        self.spend(1);
        if self.nodes.get() > MAX_NODES {
            return Err(Fault::limit(
                expr.place,
                format!("the formula takes more than {MAX_NODES} steps"),
            ));
        }
        match &expr.node {
            Node::Number { value, .. } => Ok(Fraction::from(value.clone()).into()),
            Node::Name(name) => self.named(name, expr.place, bound),
            Node::Call(head, arguments) => self.call(expr, head, arguments, bound),
            Node::Index(head, indices) => self.indexed(expr, head, indices, bound),
            Node::Negative(inner) => {
                let value = self.value(inner, bound)?;
                numeric(&value, inner.place)?;
                value.mapped(&|q: &Quantity| Ok(q.negated()))
            }
            Node::Binary(operator, a, b) => self.binary(*operator, a, b, bound),
            Node::List(items) => self.list(items, bound),
            Node::Compare(first, rest) => self.comparison(first, rest, bound),
            Node::Join(connective, a, b) => {
                let (a, b) = (self.truth(a, bound)?, self.truth(b, bound)?);
                Ok(Value::Truth(Box::new(Statement::Join(
                    *connective,
                    Box::new(a),
                    Box::new(b),
                ))))
            }
            Node::Not(inner) => {
                let inner = self.truth(inner, bound)?;
                Ok(Value::Truth(Box::new(Statement::Not(Box::new(inner)))))
            }
        }
    }

    fn truth(&self, expr: &Expr, bound: &Bindings) -> Outcome<Statement> {
        match self.value(expr, bound)? {
            Value::Truth(statement) => Ok(*statement),
            other => Err(wrong_type(expr.place, other.kind(), "a statement")),
        }
    }

    fn comparison(
        &self,
        first: &Expr,
        rest: &[(torse_language::syntax::Relation, Expr)],
        bound: &Bindings,
    ) -> Outcome<Value> {
        let mut chain: Option<Statement> = None;
        let mut left_expr = first;
        let mut left = self.value(first, bound)?;
        for (relation, right_expr) in rest {
            let right = self.value(right_expr, bound)?;
            let (fit_left, fit_right) =
                fitted(&left, &right, left_expr.place.to(right_expr.place))?;
            let link = Statement::Compare {
                relation: *relation,
                left: Box::new(fit_left),
                right: Box::new(fit_right),
            };
            chain = Some(match chain {
                None => link,
                Some(before) => Statement::Join(Connective::And, Box::new(before), Box::new(link)),
            });
            left = right;
            left_expr = right_expr;
        }
        chain
            .map(|c| Value::Truth(Box::new(c)))
            .ok_or_else(|| wrong_type(first.place, "nothing", "a comparison"))
    }

    fn list(&self, items: &[Expr], bound: &Bindings) -> Outcome<Value> {
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

    fn named(&self, name: &str, place: Place, bound: &Bindings) -> Outcome<Value> {
        if let Some(value) = bound.get(name) {
            return Ok(value.clone());
        }
        if let Some(value) = self.fixed.get(name) {
            return Ok(value.clone().into());
        }
        if let Some(definition) = self.declarations.definition(name) {
            let body = &definition.body;
            if definition.parameters.is_empty() {
                let key = (name.to_owned(), self.in_angle.get());
                if let Some(value) = self.named.borrow().get(&key) {
                    return Ok(value.clone());
                }
                let value = self.deeper(place, || {
                    self.value(&body.expr, &Bindings::new())
                        .map_err(|f| f.within(&body.origin))
                })?;
                self.named.borrow_mut().insert(key, value.clone());
                return Ok(value);
            }
            return Ok(Value::Function(Box::new(Function {
                name: name.to_owned(),
                parameters: definition.parameters.clone(),
                body: body.expr.clone(),
                origin: body.origin.clone(),
                derivatives: vec![],
            })));
        }
        match self.declarations.symbol(name) {
            Some(SymbolKind::Real(_) | SymbolKind::Integer { .. }) => {
                return Ok(self.leaf(Symbol::named(name)).into());
            }
            Some(SymbolKind::Vector(None)) => {
                return Ok(generic(self.leaf(Symbol::indexed(name, vec![]))));
            }
            Some(SymbolKind::Vector(Some(dimension))) => {
                let entries = (1..=i64::from(*dimension))
                    .map(|c| {
                        self.leaf(Symbol::indexed(name, vec![Affine::number(c)]))
                            .into()
                    })
                    .collect();
                return Ok(Value::Vector(Vector {
                    entries,
                    generic: false,
                }));
            }
            Some(SymbolKind::Family { .. }) => {
                return Err(wrong_type(
                    place,
                    "a family without an index",
                    "one of its members",
                ));
            }
            None => {}
        }
        if name == "pi" {
            return Ok(self.leaf(Symbol::Pi).into());
        }
        // F'' is the second derivative of F by its first parameter.
        let base = name.trim_end_matches('\'');
        if base.len() < name.len()
            && let Ok(Value::Function(mut function)) = self.named(base, place, bound)
            && let Some(parameter) = function.parameters.first().cloned()
        {
            let order = u32::try_from(name.len() - base.len()).unwrap_or(u32::MAX);
            function.derivatives.push((parameter, order));
            return Ok(Value::Function(function));
        }
        Err(self.unknown(name, place, bound))
    }

    fn unknown(&self, name: &str, place: Place, bound: &Bindings) -> Fault {
        let candidates = self
            .declarations
            .names()
            .chain(bound.keys().map(String::as_str))
            .chain(functions::NAMES);
        let similar = candidates
            .map(|candidate| (edit_distance(name, candidate), candidate))
            .filter(|(distance, candidate)| *distance <= 1 + candidate.len() / 4)
            .min()
            .map(|(_, candidate)| candidate.to_owned());
        Fault::at(
            place,
            Problem::UnknownName {
                name: name.to_owned(),
                similar,
            },
        )
    }

    /// A symbol, or the value that the given equations determine for it.
    fn leaf(&self, symbol: Symbol) -> Fraction {
        if let Some(value) = self.solved.get(&symbol) {
            return value.clone();
        }
        let replaced = self.sampled && !self.in_angle.get();
        let number = if replaced {
            crate::sample::value(&symbol)
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
            return crate::sample::at_sample(&value).unwrap_or(value);
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

    fn deeper<T>(&self, place: Place, inner: impl FnOnce() -> Outcome<T>) -> Outcome<T> {
        if self.depth.get() >= MAX_DEPTH {
            return Err(Fault::at(place, Problem::Circular { limit: MAX_DEPTH }));
        }
        self.depth.set(self.depth.get() + 1);
        let result = inner();
        self.depth.set(self.depth.get() - 1);
        result
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

/// The Levenshtein distance, for suggestions.
fn edit_distance(a: &str, b: &str) -> usize {
    let b: Vec<char> = b.chars().collect();
    let mut row: Vec<usize> = (0..=b.len()).collect();
    for (i, x) in a.chars().enumerate() {
        let mut diagonal = i;
        let mut left = i + 1;
        for (y, slot) in b.iter().zip(row.iter_mut().skip(1)) {
            let cost = (diagonal + usize::from(x != *y))
                .min(left + 1)
                .min(*slot + 1);
            diagonal = *slot;
            *slot = cost;
            left = cost;
        }
        if let Some(first) = row.first_mut() {
            *first = i + 1;
        }
    }
    row.last().copied().unwrap_or(0)
}
