//! From syntax to exact values.
//!
//! One walk over the tree: [`scope`] says what names mean, [`value`] what comes out, [`series`] carries
//! symbolic degrees, [`sum`] and [`basis`] make them, [`functions`] holds the built-in functions.

pub mod basis;
pub mod fault;
mod functions;
pub mod linear;
pub mod quantity;
pub mod scope;
pub mod series;
mod sum;
pub mod value;

use crate::syntax::{Connective, Expr, Node, Operator, Place};
use fault::{Fault, Problem};
use quantity::Quantity;
use scope::{Declarations, SymbolKind};
use std::cell::{Cell, RefCell};
use std::collections::BTreeMap;
use torse_algebra::{Affine, Fraction, Symbol};
use value::{Function, Statement, Value, Vector};

/// How deep definitions may call each other.
const MAX_DEPTH: usize = 80;
/// How many nodes one formula may visit: formulas of papers stay far below.
const MAX_NODES: u64 = 400_000;
/// The most term products one multiplication may cost.
const MAX_PRODUCTS: usize = 4_000_000;
/// The largest exponent.
const MAX_POWER: u64 = 200;

/// Values of bound names: parameters of functions and indices of sums.
pub type Bindings = BTreeMap<String, Value>;

/// Evaluates formulas under declarations, with some symbols fixed and some unknowns solved for.
pub struct Evaluator<'a> {
    /// What names mean.
    pub declarations: &'a Declarations,
    /// Symbols with a value: instantiated integers, assumed equalities, witness points.
    pub fixed: BTreeMap<String, Fraction>,
    /// Unknowns that the given equations determine.
    pub solved: BTreeMap<Symbol, Fraction>,
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
}

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
        }
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
        let at_sample =
            |f: &Fraction| crate::repair::sample::at_sample(f).unwrap_or_else(|| f.clone());
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
        rest: &[(crate::syntax::Relation, Expr)],
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
                return self.deeper(place, || {
                    self.value(&body.expr, &Bindings::new())
                        .map_err(|f| f.within(&body.origin))
                });
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
            crate::repair::sample::value(&symbol)
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
            return crate::repair::sample::at_sample(&value).unwrap_or(value);
        }
        value
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

    fn indexed(
        &self,
        expr: &Expr,
        head: &Expr,
        indices: &[Expr],
        bound: &Bindings,
    ) -> Outcome<Value> {
        if let Node::Name(name) = &head.node
            && !bound.contains_key(name)
            && self.declarations.definition(name).is_none()
        {
            if let Some(basis) = self.declarations.basis(name) {
                return self.member(name, basis, indices, &[], expr.place, bound);
            }
            if let Some(SymbolKind::Family { dimension, ranges }) = self.declarations.symbol(name) {
                let index = indices
                    .iter()
                    .map(|i| self.index(i, bound))
                    .collect::<Outcome<Vec<_>>>()?;
                self.check_ranges(name, &index, ranges, indices)?;
                return Ok(match dimension {
                    Some(1) => self.leaf(Symbol::indexed(name, index)).into(),
                    None => generic(self.leaf(Symbol::indexed(name, index))),
                    Some(dimension) => {
                        let entry = |c: u8| {
                            let mut full = index.clone();
                            full.push(Affine::number(i64::from(c)));
                            self.leaf(Symbol::indexed(name, full)).into()
                        };
                        Value::Vector(Vector {
                            entries: (1..=*dimension).map(entry).collect(),
                            generic: false,
                        })
                    }
                });
            }
        }
        self.entry(expr, head, indices, bound)
    }

    fn check_ranges(
        &self,
        name: &str,
        index: &[Affine],
        ranges: &[(Affine, Affine)],
        at: &[Expr],
    ) -> Outcome<()> {
        let place = at.first().map_or_else(Place::default, |e| e.place);
        if !ranges.is_empty() && ranges.len() != index.len() {
            return Err(Fault::at(
                place,
                Problem::Count {
                    name: name.to_owned(),
                    wanted: format!("{} indices", ranges.len()),
                    found: index.len(),
                },
            ));
        }
        for ((index, (least, most)), expr) in index.iter().zip(ranges).zip(at) {
            let fix = |form: &Affine| self.affine_fixed(form);
            let (least, most) = (fix(least), fix(most));
            let outside = |gap: Affine| self.declarations.least(&gap).is_some_and(|gap| gap > 0);
            if outside(least.clone() - index.clone()) || outside(index.clone() - most.clone()) {
                return Err(Fault::at(
                    expr.place,
                    Problem::IndexOutside {
                        name: name.to_owned(),
                        index: index.to_string(),
                        range: format!("{least}..{most}"),
                    },
                ));
            }
        }
        Ok(())
    }

    /// An index form with the fixed integers put in.
    fn affine_fixed(&self, form: &Affine) -> Affine {
        self.fixed.iter().fold(form.clone(), |form, (name, value)| {
            match value
                .as_rational()
                .filter(torse_algebra::Rational::is_integer)
            {
                Some(n) => i64::try_from(n.to_integer())
                    .map_or(form.clone(), |n| form.substituted(name, &Affine::number(n))),
                None => form,
            }
        })
    }

    /// The entry of a vector or matrix, counted from 1.
    fn entry(
        &self,
        expr: &Expr,
        head: &Expr,
        indices: &[Expr],
        bound: &Bindings,
    ) -> Outcome<Value> {
        let value = self.value(head, bound)?;
        let position = |expr: &Expr, length: usize, what: &str| -> Outcome<usize> {
            let index = self.index(expr, bound)?;
            let outside = || {
                Fault::at(
                    expr.place,
                    Problem::IndexOutside {
                        name: what.to_owned(),
                        index: index.to_string(),
                        range: format!("1..{length}"),
                    },
                )
            };
            index
                .as_number()
                .and_then(|n| usize::try_from(n).ok())
                .filter(|n| (1..=length).contains(n))
                .map(|n| n - 1)
                .ok_or_else(outside)
        };
        match (value, indices) {
            (Value::Vector(v), [i]) if !v.generic => {
                let i = position(i, v.entries.len(), "the vector")?;
                v.entries.into_iter().nth(i).map(Value::Scalar)
            }
            (Value::Matrix(rows), [i]) => {
                let i = position(i, rows.len(), "the rows")?;
                rows.into_iter().nth(i).map(|entries| {
                    Value::Vector(Vector {
                        entries,
                        generic: false,
                    })
                })
            }
            (Value::Matrix(rows), [i, j]) => {
                let i = position(i, rows.len(), "the rows")?;
                let j = position(j, rows.first().map_or(0, Vec::len), "the columns")?;
                rows.into_iter()
                    .nth(i)
                    .and_then(|row| row.into_iter().nth(j))
                    .map(Value::Scalar)
            }
            (value, _) => {
                return Err(wrong_type(
                    head.place,
                    value.kind(),
                    "something with so many indices",
                ));
            }
        }
        .ok_or_else(|| wrong_type(expr.place, "nothing", "an entry"))
    }

    /// An integer-affine index.
    fn index(&self, expr: &Expr, bound: &Bindings) -> Outcome<Affine> {
        let value = self.value(expr, bound)?;
        let Value::Scalar(quantity) = &value else {
            return Err(wrong_type(expr.place, value.kind(), "an integer"));
        };
        let form = quantity
            .as_fraction()
            .and_then(Fraction::as_polynomial)
            .and_then(|p| {
                p.terms().try_fold(Affine::default(), |form, term| {
                    let n = term
                        .coefficient
                        .is_integer()
                        .then(|| i64::try_from(term.coefficient.to_integer()).ok())??;
                    match term.powers.as_slice() {
                        [] => Some(form + Affine::number(n)),
                        [(Symbol::Named(name), 1)] => Some(form + Affine::symbol(name) * n),
                        _ => None,
                    }
                })
            });
        form.ok_or_else(|| wrong_type(expr.place, "a formula", "an integer such as k - 2"))
    }

    fn binary(&self, operator: Operator, a: &Expr, b: &Expr, bound: &Bindings) -> Outcome<Value> {
        let place = a.place.to(b.place);
        let left = self.value(a, bound)?;
        if operator == Operator::Power {
            return self.power(&left, a, b, bound);
        }
        let right = self.value(b, bound)?;
        numeric(&left, a.place)?;
        numeric(&right, b.place)?;
        match operator {
            Operator::Add | Operator::Subtract => {
                let (left, right) = fitted(&left, &right, place)?;
                let mut others = right.entries().into_iter();
                let combined =
                    left.mapped(&|_: &Quantity| Ok::<_, Fault>(Fraction::zero().into()))?;
                let sums: Vec<Quantity> = left
                    .entries()
                    .into_iter()
                    .map(|x| {
                        let y = others
                            .next()
                            .cloned()
                            .unwrap_or_else(|| Fraction::zero().into());
                        if operator == Operator::Add {
                            x.plus(&y)
                        } else {
                            x.minus(&y)
                        }
                    })
                    .collect();
                refilled(&combined, sums)
            }
            Operator::Multiply => self.product(&left, &right, place),
            Operator::Divide => {
                let Value::Scalar(divisor) = &right else {
                    return Err(wrong_type(b.place, right.kind(), "a number"));
                };
                let divisor = divisor
                    .as_fraction()
                    .ok_or_else(|| symbolic_degree(b.place))?;
                let inverse = Fraction::integer(1)
                    .over(divisor)
                    .map_err(|e| Fault::exact(b.place, e))?;
                left.mapped(&|q: &Quantity| Ok(q.times(&inverse)))
            }
            Operator::Power => Err(wrong_type(place, "a power", "a product")),
        }
    }

    fn product(&self, left: &Value, right: &Value, place: Place) -> Outcome<Value> {
        match (left, right) {
            (Value::Scalar(x), other) | (other, Value::Scalar(x)) => {
                other.mapped(&|q: &Quantity| multiplied(x, q, place))
            }
            (Value::Matrix(a), Value::Matrix(b)) => Ok(Value::Matrix(matrix_product(a, b, place)?)),
            (Value::Matrix(a), Value::Vector(v)) if !v.generic => {
                let column: Vec<Vec<Quantity>> =
                    v.entries.iter().map(|q| vec![q.clone()]).collect();
                let entries = matrix_product(a, &column, place)?
                    .into_iter()
                    .flatten()
                    .collect();
                Ok(Value::Vector(Vector {
                    entries,
                    generic: false,
                }))
            }
            (Value::Vector(_), Value::Vector(_)) => Err(wrong_type(
                place,
                "a product of vectors",
                "dot(a, b) or cross(a, b)",
            )),
            (a, _) => Err(wrong_type(place, a.kind(), "factors that fit")),
        }
    }

    fn power(&self, base: &Value, a: &Expr, b: &Expr, bound: &Bindings) -> Outcome<Value> {
        let Value::Scalar(quantity) = base else {
            return Err(wrong_type(a.place, base.kind(), "a number"));
        };
        let exponent = self.index(b, bound)?;
        let Some(n) = exponent.as_number() else {
            return Err(Fault::limit(
                b.place,
                format!("the symbolic power {exponent}"),
            ));
        };
        if n.unsigned_abs() > MAX_POWER {
            return Err(Fault::limit(
                b.place,
                format!("the power {n} is larger than {MAX_POWER}"),
            ));
        }
        let base = quantity
            .as_fraction()
            .ok_or_else(|| symbolic_degree(a.place))?;
        let mut result = Fraction::integer(1);
        for _ in 0..n.unsigned_abs() {
            result = bounded_product(&result, base, a.place)?;
        }
        if n < 0 {
            result = Fraction::integer(1)
                .over(&result)
                .map_err(|e| Fault::exact(a.place, e))?;
        }
        Ok(result.into())
    }

    /// Applies a function to values.
    fn apply(&self, function: &Function, arguments: &[Value], place: Place) -> Outcome<Value> {
        if arguments.len() != function.parameters.len() {
            return Err(Fault::at(
                place,
                Problem::Count {
                    name: function.name.clone(),
                    wanted: format!("{} arguments", function.parameters.len()),
                    found: arguments.len(),
                },
            ));
        }
        let body = |bound: &Bindings| {
            self.deeper(place, || {
                self.value(&function.body, bound)
                    .map_err(|f| f.within(&function.origin))
            })
        };
        if function.derivatives.is_empty() {
            let bound = function
                .parameters
                .iter()
                .cloned()
                .zip(arguments.iter().cloned())
                .collect();
            return body(&bound);
        }
        // Differentiate by fresh variables, then put the arguments in.
        let fresh = |parameter: &str| format!("{parameter}\u{b0}");
        let bound = function
            .parameters
            .iter()
            .map(|p| (p.clone(), Fraction::named(&fresh(p)).into()))
            .collect();
        let mut value = body(&bound)?;
        for (parameter, order) in &function.derivatives {
            for _ in 0..*order {
                value = value
                    .mapped(&|q: &Quantity| Ok::<_, Fault>(q.derivative(&fresh(parameter))))?;
            }
        }
        for (parameter, argument) in function.parameters.iter().zip(arguments) {
            let Value::Scalar(point) = argument else {
                return Err(wrong_type(place, argument.kind(), "a number"));
            };
            let point = point.as_fraction().ok_or_else(|| symbolic_degree(place))?;
            value = self.placed(&value, &fresh(parameter), point, place)?;
        }
        Ok(value)
    }

    /// The value with a variable at a point; series that collapse there become plain.
    fn placed(
        &self,
        value: &Value,
        variable: &str,
        point: &Fraction,
        place: Place,
    ) -> Outcome<Value> {
        value.mapped(&|q: &Quantity| {
            let moved = q
                .mapped(|f| f.at(variable, point))
                .map_err(|e| Fault::exact(place, e))?;
            self.settled(moved, place)
        })
    }

    /// The quantity with every series that has a plain value replaced by it.
    fn settled(&self, quantity: Quantity, place: Place) -> Outcome<Quantity> {
        let mut plain = quantity.plain;
        let mut series = vec![];
        for part in quantity.series {
            let value = part
                .value(
                    |form| self.declarations.least(form),
                    |form| self.declarations.greatest(form),
                )
                .map_err(|e| Fault::exact(place, e))?;
            match value {
                Some(value) => plain = plain + self.resolved(&value, place)?,
                None => series.push(part),
            }
        }
        Ok(Quantity { plain, series })
    }

    /// A fraction with the solved unknowns put in.
    fn resolved(&self, value: &Fraction, place: Place) -> Outcome<Fraction> {
        if self.solved.is_empty() {
            return Ok(value.clone());
        }
        value
            .substituted(|s| self.solved.get(s).cloned())
            .map_err(|e| Fault::exact(place, e))
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

fn numeric(value: &Value, place: Place) -> Outcome<()> {
    match value {
        Value::Function(_) | Value::Truth(_) => Err(wrong_type(
            place,
            value.kind(),
            "a number, vector or matrix",
        )),
        _ => Ok(()),
    }
}

/// Both values in one shape: zero fits every vector and matrix.
fn fitted(left: &Value, right: &Value, place: Place) -> Outcome<(Value, Value)> {
    let is_zero = |v: &Value| match v {
        Value::Scalar(q) => q.as_fraction().is_some_and(Fraction::is_zero),
        _ => false,
    };
    let zeros =
        |like: &Value| like.mapped(&|_: &Quantity| Ok::<Quantity, Fault>(Fraction::zero().into()));
    match (left, right) {
        (Value::Scalar(_), Value::Scalar(_)) => {}
        (a, b) if is_zero(a) => return Ok((zeros(b)?, b.clone())),
        (a, b) if is_zero(b) => return Ok((a.clone(), zeros(a)?)),
        (Value::Vector(a), Value::Vector(b))
            if a.generic == b.generic && a.entries.len() == b.entries.len() => {}
        (Value::Vector(a), Value::Vector(b)) => {
            let size = |v: &Vector| {
                if v.generic {
                    "a generic vector".to_owned()
                } else {
                    format!("a vector of {}", v.entries.len())
                }
            };
            return Err(shapes(place, &size(a), &size(b)));
        }
        (Value::Matrix(a), Value::Matrix(b))
            if a.len() == b.len() && a.first().map(Vec::len) == b.first().map(Vec::len) => {}
        (a, b) => return Err(shapes(place, a.kind(), b.kind())),
    }
    Ok((left.clone(), right.clone()))
}

/// A value of the same shape with these entries, in order.
fn refilled(shape: &Value, entries: Vec<Quantity>) -> Outcome<Value> {
    let source = RefCell::new(entries.into_iter());
    shape.mapped(&|_: &Quantity| {
        Ok(source
            .borrow_mut()
            .next()
            .unwrap_or_else(|| Fraction::zero().into()))
    })
}

/// The product of two quantities, at most one of which has series.
fn multiplied(x: &Quantity, y: &Quantity, place: Place) -> Outcome<Quantity> {
    match (x.as_fraction(), y.as_fraction()) {
        (Some(a), Some(b)) => Ok(bounded_product(a, b, place)?.into()),
        (Some(a), None) => Ok(y.times(a)),
        (None, Some(b)) => Ok(x.times(b)),
        (None, None) => Err(Fault::limit(
            place,
            "a product of two sums of symbolic degree",
        )),
    }
}

fn bounded_product(a: &Fraction, b: &Fraction, place: Place) -> Outcome<Fraction> {
    if a.numerator().len().saturating_mul(b.numerator().len()) > MAX_PRODUCTS {
        return Err(Fault::limit(
            place,
            "a product of more than four million terms",
        ));
    }
    let degree = a
        .numerator()
        .total_degree()
        .saturating_add(b.numerator().total_degree());
    if degree > u32::from(u16::MAX) / 2 {
        return Err(Fault::limit(place, format!("a product of degree {degree}")));
    }
    Ok(a.clone() * b.clone())
}

fn matrix_product(
    a: &[Vec<Quantity>],
    b: &[Vec<Quantity>],
    place: Place,
) -> Outcome<Vec<Vec<Quantity>>> {
    let inner = a.first().map_or(0, Vec::len);
    if inner != b.len() {
        return Err(shapes(
            place,
            &format!("{inner} columns"),
            &format!("{} rows", b.len()),
        ));
    }
    let columns = b.first().map_or(0, Vec::len);
    a.iter()
        .map(|row| {
            (0..columns)
                .map(|column| {
                    row.iter()
                        .zip(b)
                        .filter_map(|(x, other)| other.get(column).map(|y| (x, y)))
                        .try_fold(Quantity::from(Fraction::zero()), |sum, (x, y)| {
                            Ok(sum.plus(&multiplied(x, y, place)?))
                        })
                })
                .collect()
        })
        .collect()
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
