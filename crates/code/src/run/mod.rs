//! Runs a function on symbols: its value is a formula.
//!
//! Loops over constants are unrolled, branches on constants are taken, functions of the file are called. Whatever depends on the
//! value of a symbol otherwise is refused. Numbers are exact: nothing rounds or overflows.
//!
//! Lists are values here, and shared objects in Python, see [`objects`].

mod arithmetic;
mod bounds;
mod conditions;
mod demands;
mod folds;
mod formulas;
mod functions;
mod integers;
mod lists;
mod objects;
pub(crate) mod setting;
mod symbols;
pub(crate) mod value;

use crate::grammar::{Read, small};
use crate::program::{
    Assignment, CodeLanguage, Function, Kind, Program, Step, Target, operation, refused,
};
use bounds::Index;
use setting::Setting;
use std::collections::{BTreeMap, BTreeSet};
use symbols::{Symbols, free_names};
use torse_numbers::rational::integer;
use torse_numbers::stack;
use torse_syntax::derivation::DerivationError;
use torse_syntax::formula::{Connective, Expr, Node, Place};
use value::{FOREIGN, Object, Shape, Term, Value};

/// The most steps of a run: evaluated parts of formulas, with what loops repeat.
pub const MAX_CODE_STEPS: usize = 200_000;
/// The largest formula that a program may make, in nodes.
pub const MAX_CODE_NODES: usize = 20_000;
/// The most levels of such a formula.
const MAX_LEVELS: usize = 280;
/// The most calls within calls.
const MAX_CALLS: usize = 48;

/// What a function computes, and where it has a value.
pub(crate) struct Computed {
    /// The formula.
    pub(crate) formula: Expr,
    /// What its assertions demand of the symbols.
    pub(crate) demands: Vec<Expr>,
    /// An assertion that is not read.
    pub(crate) unread_demand: Option<Place>,
    /// What must hold for the functions of the program to be those of formulas.
    pub(crate) obligations: Vec<Obligation>,
    /// Symbols of the program that the claim does not declare, and that the formula binds.
    pub(crate) dummies: Vec<String>,
}

/// A program has complex values where this does not hold, and a formula none.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Obligation {
    pub(crate) condition: Expr,
    pub(crate) place: Place,
}

/// The formula that a function computes.
pub(crate) fn formula(
    program: &Program,
    function: &Function,
    setting: Setting<'_>,
) -> Read<Computed> {
    counted(program, function, setting).0
}

/// The formula that a function computes, and the steps that it took.
pub(crate) fn counted(
    program: &Program,
    function: &Function,
    setting: Setting<'_>,
) -> (Read<Computed>, usize) {
    let mut runner = Runner::new(program, setting);
    let value = stack::deep(|| runner.result(function));
    let steps = runner.steps;
    let computed = value.map(|formula| Computed {
        formula,
        demands: runner.demands,
        unread_demand: runner.unread_demand,
        obligations: runner.obligations,
        dummies: runner.symbols.into_dummies(),
    });
    (computed, steps)
}

/// The variables of a call.
#[derive(Debug, Clone, Default)]
struct Frame {
    variables: BTreeMap<String, Value>,
    /// What blocks have hidden, to be restored at their ends.
    hidden: Vec<(String, Option<Value>)>,
    /// The names that the function assigns somewhere.
    locals: BTreeSet<String>,
    /// The first object that is made in this call: only those from here on are changed.
    first: Object,
}

impl Frame {
    fn hide(&mut self, name: &str, value: Value) {
        let outer = self.variables.insert(name.to_owned(), value);
        self.hidden.push((name.to_owned(), outer));
    }

    /// Ends the blocks that were begun after there were so many hidden variables.
    fn restore(&mut self, count: usize) {
        while self.hidden.len() > count {
            let Some((name, outer)) = self.hidden.pop() else {
                return;
            };
            match outer {
                Some(outer) => self.variables.insert(name, outer),
                None => self.variables.remove(&name),
            };
        }
    }
}

struct Runner<'p> {
    program: &'p Program,
    setting: Setting<'p>,
    steps: usize,
    calls: usize,
    /// The objects made so far, and those that were changed under a name: what other names have is out of date.
    objects: Object,
    changed: BTreeSet<Object>,
    /// The indices of sums around, with their ends.
    bound: Vec<Index>,
    symbols: Symbols,
    demands: Vec<Expr>,
    unread_demand: Option<Place>,
    obligations: Vec<Obligation>,
    /// Where the file is that is being carried out: what it binds from there on has no meaning yet.
    until: Option<usize>,
}

impl<'p> Runner<'p> {
    fn new(program: &'p Program, setting: Setting<'p>) -> Self {
        Self {
            program,
            setting,
            steps: 0,
            calls: 0,
            objects: FOREIGN,
            changed: BTreeSet::new(),
            bound: vec![],
            symbols: Symbols::default(),
            demands: vec![],
            unread_demand: None,
            obligations: vec![],
            until: None,
        }
    }
}

impl Runner<'_> {
    /// The formula that the function computes which is compared.
    fn result(&mut self, function: &Function) -> Read<Expr> {
        let arguments = self.setting.arguments(self.program, function)?;
        for value in arguments.iter().flatten() {
            self.symbols.pass(value);
        }
        let value = self.call(function, arguments, function.place)?;
        let kind = value.kind();
        let term = value.formula().ok_or_else(|| {
            let message = format!("the value of `{}` is {kind}", function.name);
            let help =
                "a function whose value is a number, a point or a list of numbers is compared";
            refused(&self.program.source, function.place, message, help)
        })?;
        let undeclared = free_names(&term.expr)
            .into_iter()
            .find(|name| !self.setting.is_declared(name));
        if let Some(name) = undeclared {
            let name = self.symbols.written(&name);
            let message = format!(
                "the value of `{}` contains `{name}`, which the claim does not declare",
                function.name
            );
            let help = format!("say what it stands for: `--map '{name}=FORMULA'`");
            return Err(refused(&self.program.source, function.place, message, help));
        }
        Ok(term.expr)
    }

    fn refused(
        &self,
        place: Place,
        message: impl Into<String>,
        help: impl Into<String>,
    ) -> Box<DerivationError> {
        refused(&self.program.source, place, message, help)
    }

    fn spend(&mut self, place: Place) -> Read<()> {
        self.spend_all(1, place)
    }

    /// Counts what a copy of a value costs.
    fn spend_copy(&mut self, value: &Value, place: Place) -> Read<()> {
        let most = (MAX_CODE_STEPS + 1).saturating_sub(self.steps);
        match value {
            Value::List(_) => self.spend_all(value.entries(most), place),
            _ => Ok(()),
        }
    }

    fn spend_all(&mut self, steps: usize, place: Place) -> Read<()> {
        self.steps = self.steps.saturating_add(steps);
        if self.steps <= MAX_CODE_STEPS {
            return Ok(());
        }
        let message = format!("this function takes more than {MAX_CODE_STEPS} steps");
        let help = "fix smaller integers: `--where 'n == 3'`";
        Err(self.refused(place, message, help))
    }

    /// A new term, unless it is larger than formulas may be.
    fn bounded(&mut self, mut term: Term, place: Place) -> Read<Value> {
        if term.height > MAX_LEVELS && term.size <= MAX_CODE_NODES {
            term = term.balanced();
        }
        if term.size <= MAX_CODE_NODES && term.height <= MAX_LEVELS {
            if term.is_point {
                term.object = self.object();
            }
            return Ok(Value::Term(term));
        }
        let message = format!(
            "the formula of this grows beyond {MAX_CODE_NODES} parts or {MAX_LEVELS} levels"
        );
        let help = "fix smaller integers, `--where 'n == 3'`, or write a sum as `sum(... for i in range(n))`";
        Err(self.refused(place, message, help))
    }

    /// Calls a function; where an argument is missing its default is taken.
    fn call(
        &mut self,
        function: &Function,
        arguments: Vec<Option<Value>>,
        place: Place,
    ) -> Read<Value> {
        self.calls += 1;
        if self.calls > MAX_CALLS {
            let message = format!(
                "`{}` is called more than {MAX_CALLS} times within itself",
                function.name
            );
            let help = "a recursion ends at constants: `if k == 0: return ...`";
            return Err(self.refused(place, message, help));
        }
        if arguments.len() > function.parameters.len() {
            let count = function.parameters.len();
            let message = format!("`{}` has {count} parameters", function.name);
            return Err(self.refused(place, message, "leave the others out"));
        }
        self.is_bound_before(&function.name, function.place.start, place)?;
        let body = function.body.as_ref().map_err(Clone::clone)?;
        let mut frame = Frame {
            locals: function.locals.clone(),
            ..Frame::default()
        };
        let mut arguments = arguments.into_iter();
        for parameter in &function.parameters {
            let value = match (arguments.next().flatten(), &parameter.default) {
                (Some(value), _) => value.typed(&parameter.declared),
                // The same object in each call.
                (None, Some(default)) => self.outside(default, function.place.start)?.foreign(),
                (None, None) => {
                    let message = format!("the argument `{}` is missing", parameter.name);
                    return Err(self.refused(place, message, "give it by its place"));
                }
            };
            frame.variables.insert(parameter.name.clone(), value);
        }
        frame.first = self.object();
        let value = self.run(body, &mut frame)?;
        self.calls -= 1;
        let value = value.ok_or_else(|| {
            let message = format!("`{}` ends without a value", function.name);
            self.refused(function.place, message, "return a value in every case")
        })?;
        let value = value.typed(&function.result);
        Ok(match function.is_cached {
            true => value.foreign(),
            false => value,
        })
    }

    /// The value of what is evaluated outside of functions, at a position of the file.
    fn outside(&mut self, value: &Expr, position: usize) -> Read<Value> {
        let until = match self.program.language {
            CodeLanguage::Python => Some(position),
            CodeLanguage::Rust => None,
        };
        let until = std::mem::replace(&mut self.until, until);
        let value = self.value(value, &mut Frame::default());
        self.until = until;
        value
    }

    /// Fails for what the file binds only after what is being carried out.
    fn is_bound_before(&self, name: &str, position: usize, place: Place) -> Read<()> {
        match self.until {
            Some(until) if position >= until => {
                let message = format!("`{name}` gets its meaning only after this is computed");
                Err(self.refused(place, message, "define it before"))
            }
            _ => Ok(()),
        }
    }

    /// Runs steps until one gives the value of the function.
    fn run(&mut self, steps: &[Step], frame: &mut Frame) -> Read<Option<Value>> {
        for step in steps {
            match step {
                Step::Assign {
                    target: Target::Name(name, place),
                    value,
                    how: Assignment::InPlace,
                } if appended(value, name).is_some_and(|_| frame.variables.contains_key(name)) => {
                    let Some(item) = appended(value, name) else {
                        continue;
                    };
                    self.spend(value.place)?;
                    let item = self.value(item, frame)?;
                    self.append(name, item, *place, frame)?;
                }
                Step::Assign { target, value, how } => {
                    let computed = self.value(value, frame)?;
                    self.assign(target, computed, *how, frame)?;
                }
                Step::Repeat {
                    variable,
                    values,
                    body,
                } => {
                    let all = self.value(values, frame)?;
                    let mut sources = vec![];
                    if let Value::List(list) = &all {
                        sources.push(list.object);
                        sources.extend(&list.sources);
                    }
                    for value in self.items(all, values.place)? {
                        self.spend(values.place)?;
                        self.is_current(&value, values.place)?;
                        let outer = frame.hidden.len();
                        self.assign(variable, value, self.block(), frame)?;
                        let value = self.run(body, frame)?;
                        frame.restore(outer);
                        if value.is_some() {
                            return Ok(value);
                        }
                        // After the last turn too: what grows in it has more of them.
                        if sources.iter().any(|source| self.changed.contains(source)) {
                            let message = "the list is changed while the loop goes through it";
                            let help = "go through a copy of it: `for p in list(P)`";
                            return Err(self.refused(values.place, message, help));
                        }
                    }
                }
                Step::Branch {
                    condition,
                    then,
                    otherwise,
                } => {
                    let steps = if self.truth(condition, frame)? {
                        then
                    } else {
                        otherwise
                    };
                    let outer = frame.hidden.len();
                    let value = self.run(steps, frame)?;
                    frame.restore(outer);
                    if value.is_some() {
                        return Ok(value);
                    }
                }
                Step::Return(expr) => {
                    let value = self.value(expr, frame)?;
                    return self.settled(value, expr.place).map(Some);
                }
                Step::Stop(place) => {
                    let message = "the function ends here without a value";
                    let help = "give it arguments for which it has one";
                    return Err(self.refused(*place, message, help));
                }
                Step::Assert { condition, place } => {
                    self.assert(condition.as_ref(), *place, frame)?;
                }
            }
        }
        Ok(None)
    }

    /// How the variable of a loop is assigned.
    fn block(&self) -> Assignment {
        match self.program.language {
            CodeLanguage::Python => Assignment::Set,
            CodeLanguage::Rust => Assignment::Declare,
        }
    }

    /// An integer that is written down or fixed.
    fn constant(&self, value: &Value, place: Place) -> Read<i64> {
        let number = match value {
            Value::Term(term) => term.constant.as_ref().and_then(small),
            _ => None,
        };
        number.ok_or_else(|| {
            let message = "this has to be a constant integer";
            let help = "fix the integers that it depends on: `--where 'n == 3'`";
            self.refused(place, message, help)
        })
    }

    /// The values that a loop goes through.
    fn items(&mut self, values: Value, place: Place) -> Read<Vec<Value>> {
        match values {
            Value::List(list) if list.has_rows() => {
                let message = "SymPy goes through all entries of a matrix, row by row";
                let help = "write indices: `M[i, j]`";
                Err(self.refused(place, message, help))
            }
            Value::List(list) => Ok(list.values),
            Value::Family(family) => self.members(&family, place),
            other => {
                let message = format!(
                    "a loop goes through a list or a range, and this is {}",
                    other.kind()
                );
                Err(self.refused(place, message, "write `for i in range(n)`"))
            }
        }
    }

    /// The value of an expression.
    fn value(&mut self, expr: &Expr, frame: &mut Frame) -> Read<Value> {
        self.spend(expr.place)?;
        match &expr.node {
            Node::Number { value, .. } => {
                Ok(Value::Term(Term::number(value.clone(), value.is_integer())))
            }
            Node::Name(name) => self.name(name, expr.place, frame),
            Node::Negative(inner) => {
                let value = self.value(inner, frame)?;
                self.negative(value, expr.place)
            }
            Node::Binary(operator, left, right) => {
                let left = self.value(left, frame)?;
                let right = self.value(right, frame)?;
                self.combined(*operator, left, right, expr.place)
            }
            Node::List(items) => {
                let mut values = vec![];
                for item in items {
                    let value = self.value(item, frame)?;
                    values.push(self.settled(value, item.place)?);
                }
                Ok(self.list(Shape::List, values))
            }
            Node::Index(head, indices) => {
                let list = self.value(head, frame)?;
                let mut all = vec![];
                for index in indices {
                    all.push((self.value(index, frame)?, index.place));
                }
                self.entries(list, all, expr.place)
            }
            Node::Compare(first, rest) => self.comparison(first, rest, frame).map(Value::Truth),
            Node::Join(connective, left, right) => {
                let left = self.truth(left, frame)?;
                Ok(Value::Truth(match connective {
                    Connective::And => left && self.truth(right, frame)?,
                    Connective::Or => left || self.truth(right, frame)?,
                    Connective::Implies => !left || self.truth(right, frame)?,
                }))
            }
            Node::Not(inner) => Ok(Value::Truth(!self.truth(inner, frame)?)),
            Node::Call(head, arguments) => self.application(head, arguments, expr.place, frame),
        }
    }

    fn name(&mut self, name: &str, place: Place, frame: &mut Frame) -> Read<Value> {
        if let Some(value) = frame.variables.get(name) {
            if !self.changed.is_empty() && self.is_current(value, place).is_err() {
                return Err(self.stale(name, place));
            }
            let value = value.clone();
            self.spend_copy(&value, place)?;
            return Ok(value);
        }
        match name {
            operation::PI => return Ok(Value::Term(Term::formula(Expr::name("pi"), Kind::Float))),
            operation::E => {
                let one = Term::number(integer(1), false);
                return Ok(Value::Term(Term::call("exp", vec![one])));
            }
            operation::TRUE => return Ok(Value::Truth(true)),
            operation::FALSE => return Ok(Value::Truth(false)),
            _ => {}
        }
        if frame.locals.contains(name) {
            let message = format!("`{name}` has no value here: the function assigns it later");
            return Err(self.refused(place, message, "assign it before"));
        }
        let program = self.program;
        let constant = program.constants.iter().find(|own| own.name == name);
        let Some(constant) = constant else {
            let message = format!("`{name}` has no value here that is read");
            let help = "names are parameters, variables that are assigned before, and constants of this file that are assigned once";
            return Err(self.refused(place, message, help));
        };
        self.calls += 1;
        if self.calls > MAX_CALLS {
            let message = format!("the constant `{name}` depends on itself");
            return Err(self.refused(place, message, "give it a value"));
        }
        self.is_bound_before(name, constant.position, place)?;
        let value = constant.value.as_ref().map_err(Clone::clone)?;
        let value = self.outside(value, constant.position);
        self.calls -= 1;
        let value = value?.foreign();
        if value.is_list() && !constant.is_only_read {
            let message = format!("the list `{name}` may be changed after it was made");
            let help = "what is done with a list outside of functions, or with a list of all functions, has to be the reading of its entries";
            return Err(self.refused(place, message, help));
        }
        self.settled(value, place)
    }
}

/// What `append(list, value)` puts at the end of the list of a name.
fn appended<'e>(value: &'e Expr, name: &str) -> Option<&'e Expr> {
    let Node::Call(head, arguments) = &value.node else {
        return None;
    };
    let is = |expr: &Expr, own: &str| matches!(&expr.node, Node::Name(name) if name == own);
    match arguments.as_slice() {
        [list, item] if is(head, operation::APPEND) && is(list, name) => Some(item),
        _ => None,
    }
}

/// The position of an index among so many entries.
fn position(index: i64, count: usize, counts_from_the_end: bool) -> Option<usize> {
    let count = i64::try_from(count).ok()?;
    let from_the_end = counts_from_the_end && index < 0;
    let index = if from_the_end { index + count } else { index };
    usize::try_from(index)
        .ok()
        .filter(|index| (*index as i64) < count)
}

/// The number one, as an integer.
fn one() -> Term {
    Term::number(integer(1), true)
}
