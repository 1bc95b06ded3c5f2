//! Calls: operations of programs, functions of formulas, and functions of the file.

use super::value::{Term, Value};
use super::{Frame, Runner, Variable, one};
use crate::grammar::Read;
use crate::program::{CodeLanguage, operation};
use num_traits::Signed;
use std::sync::Arc;
use torse_numbers::rational::integer;
use torse_syntax::formula::functions::{ELEMENTARY, is_function};
use torse_syntax::formula::{Expr, Node, Operator, Place};

impl Runner<'_> {
    /// The value of a call.
    pub(super) fn application(
        &mut self,
        head: &Expr,
        arguments: &[Expr],
        place: Place,
        frame: &mut Frame,
    ) -> Read<Value> {
        let Node::Name(name) = &head.node else {
            let message = "the value of a call is no function";
            return Err(self.refused(place, message, "call a function by its name"));
        };
        let program = self.program;
        if let Some(function) = program.function(name) {
            let mut values = vec![];
            for argument in arguments {
                values.push(Some(self.value(argument, frame)?));
            }
            return self.call(function, values, place);
        }
        match (name.as_str(), arguments) {
            (operation::FOR, [body, variable, values]) => {
                let values = self.value(values, frame)?;
                self.comprehension(body, variable, values, frame)
            }
            (operation::SUM, [list]) => self.folded(Operator::Add, list, place, frame),
            (operation::PRODUCT, [list]) => self.folded(Operator::Multiply, list, place, frame),
            (operation::IF, [condition, value, other]) => {
                let taken = if self.truth(condition, frame)? {
                    value
                } else {
                    other
                };
                self.value(taken, frame)
            }
            (operation::SYMBOL, [name]) => self.symbol(name, place),
            (operation::APPEND, [list, value]) => {
                let list = self.unshared(list, frame)?;
                let value = self.value(value, frame)?;
                let Value::List(mut items) = list else {
                    let message = format!("nothing is put at the end of {}", list.kind());
                    return Err(self.refused(place, message, "make a list: `q = []`"));
                };
                items.push(value);
                Ok(Value::List(items))
            }
            (operation::COPY | operation::VECTOR | operation::LENGTH, [list]) => {
                let list = self.unshared(list, frame)?;
                self.converted(name, list, place)
            }
            (operation::SLICE, [list, low, high]) => {
                let list = self.unshared(list, frame)?;
                let mut ends = vec![];
                for end in [low, high] {
                    let value = self.value(end, frame)?;
                    ends.push(self.constant(&value, end.place)?);
                }
                self.slice(list, &ends, place)
            }
            _ => {
                let mut values = vec![];
                for argument in arguments {
                    values.push(self.value(argument, frame)?);
                }
                self.operation(name, values, place)
            }
        }
    }

    /// The entries of a list between two ends, of which negative ones count from the end of the list.
    fn slice(&mut self, list: Value, ends: &[i64], place: Place) -> Read<Value> {
        let is_vector = matches!(list, Value::Vector(_));
        let items = self.items(list, place)?;
        // A part of an array is the same memory, and lists inside of a list stay the same lists.
        if is_vector || items.iter().any(Value::is_list) {
            self.escapes += 1;
        }
        let count = i64::try_from(items.len()).unwrap_or(i64::MAX);
        let at = |end: &i64| {
            let end = if *end < 0 {
                end.saturating_add(count)
            } else {
                *end
            };
            usize::try_from(end.clamp(0, count)).unwrap_or(0)
        };
        let (low, high) = match ends {
            [low, high] => (at(low), at(high)),
            _ => (0, items.len()),
        };
        let taken = items.into_iter().take(high).skip(low).collect();
        Ok(if is_vector {
            Value::Vector(taken)
        } else {
            Value::List(taken)
        })
    }

    /// The value of an expression of which no second name is made.
    fn unshared(&mut self, list: &Expr, frame: &mut Frame) -> Read<Value> {
        if let Node::Name(name) = &list.node
            && let Some(variable) = frame.variables.get(name)
        {
            return Ok(variable.value.clone());
        }
        self.value(list, frame)
    }

    /// A list of the same values, or their number.
    fn converted(&mut self, name: &str, list: Value, place: Place) -> Read<Value> {
        match (name, list) {
            (operation::LENGTH, Value::List(items) | Value::Vector(items)) => {
                let count = i64::try_from(items.len()).unwrap_or(i64::MAX);
                Ok(Value::Term(Term::number(integer(count), true)))
            }
            (operation::LENGTH, Value::Family(family)) => self.count(&family, place),
            (operation::LENGTH, other) => {
                let message = format!("{} has no length", other.kind());
                Err(self.refused(place, message, "lists have one"))
            }
            (operation::COPY, term @ Value::Term(_)) => Ok(term),
            (operation::COPY, Value::Vector(items)) => Ok(Value::Vector(items)),
            (operation::COPY, list) => {
                let items = self.items(list, place)?;
                // The lists inside of the copy are those of the original.
                let is_python = self.program.language == CodeLanguage::Python;
                if is_python && items.iter().any(Value::is_list) {
                    self.escapes += 1;
                }
                Ok(Value::List(items))
            }
            (_, list) => {
                let items = self.items(list, place)?;
                let vectors = items.into_iter().map(|item| match item {
                    Value::List(_) => self.converted(operation::VECTOR, item, place),
                    other => Ok(other),
                });
                Ok(Value::Vector(vectors.collect::<Read<_>>()?))
            }
        }
    }

    /// The list of the values of a body.
    fn comprehension(
        &mut self,
        body: &Expr,
        variable: &Expr,
        values: Value,
        frame: &mut Frame,
    ) -> Read<Value> {
        let mut found = vec![];
        for value in self.items(values, variable.place)? {
            self.spend(body.place)?;
            let outer = frame.hidden.len();
            self.bind(variable, value, frame)?;
            let value = self.value(body, frame);
            frame.restore(outer);
            found.push(value?);
        }
        Ok(Value::List(found))
    }

    /// Gives the variable of a comprehension its value.
    fn bind(&mut self, variable: &Expr, value: Value, frame: &mut Frame) -> Read<()> {
        let wrong = |runner: &Self| {
            let message = "there are as many values as names";
            runner.refused(variable.place, message, "write `for i, p in enumerate(P)`")
        };
        match (&variable.node, value) {
            (Node::Name(name), value) => {
                let variable = Variable {
                    value,
                    is_fresh: false,
                };
                frame.hide(name, variable);
                Ok(())
            }
            (Node::List(names), Value::List(values)) if names.len() == values.len() => {
                let mut pairs = names.iter().zip(values);
                pairs.try_for_each(|(name, value)| self.bind(name, value, frame))
            }
            _ => Err(wrong(self)),
        }
    }

    /// The sum or the product of a list; of a range whose ends are not fixed, one of the language.
    fn folded(
        &mut self,
        operator: Operator,
        list: &Expr,
        place: Place,
        frame: &mut Frame,
    ) -> Read<Value> {
        if let Some(parts) = series(list) {
            let bounds = [parts.low, parts.high, parts.step];
            let mut values = vec![];
            for bound in bounds {
                values.push(self.value(bound, frame)?);
            }
            let is_fixed =
                |value: &Value| matches!(value, Value::Term(term) if term.constant.is_some());
            if let [Value::Term(low), Value::Term(high), Value::Term(step)] = values.as_slice()
                && !values.iter().all(is_fixed)
                && step.integer() == Some(1)
            {
                let (low, high) = (low.clone(), last(high.clone()));
                return self.series(operator, &parts, [low, high], place, frame);
            }
        }
        let values = self.unshared(list, frame)?;
        let mut items = self.items(values, place)?.into_iter();
        let neutral = i64::from(operator == Operator::Multiply);
        let Some(first) = items.next() else {
            return Ok(Value::Term(Term::number(integer(neutral), true)));
        };
        items.try_fold(first, |sum, item| {
            self.spend(place)?;
            self.combined(operator, sum, item, place)
        })
    }

    /// `sum(i, low, high, body)`.
    fn series(
        &mut self,
        operator: Operator,
        parts: &Series<'_>,
        [low, high]: [Term; 2],
        place: Place,
        frame: &mut Frame,
    ) -> Read<Value> {
        let Node::Name(name) = &parts.variable.node else {
            let message = "a sum has one index";
            return Err(self.refused(parts.variable.place, message, "write `for i in range(n)`"));
        };
        let mut index = name.trim_matches('_').to_owned();
        while index.is_empty()
            || self.setting.is_declared(&index)
            || self.bound.contains(&index)
            || !torse_syntax::formula::is_name(&index)
        {
            index = format!("i{index}");
        }
        let outer = frame.hidden.len();
        let variable = Variable {
            value: Value::Term(Term::formula(Expr::name(&index), true)),
            is_fresh: false,
        };
        frame.hide(name, variable);
        self.bound.push(index.clone());
        let body = self.value(parts.body, frame);
        self.bound.pop();
        frame.restore(outer);
        let Value::Term(body) = body? else {
            let message = "the terms of a sum whose ends are not fixed are numbers or points";
            return Err(self.refused(
                parts.body.place,
                message,
                "fix its ends: `--where 'n == 3'`",
            ));
        };
        let name = if operator == Operator::Add {
            "sum"
        } else {
            "product"
        };
        let index = Term::formula(Expr::name(&index), true);
        let term = Term::call(name, vec![index, low, high, body]);
        self.bounded(term, place)
    }

    /// A new symbol of SymPy.
    fn symbol(&mut self, name: &Expr, place: Place) -> Read<Value> {
        let Node::Name(name) = &name.node else {
            return Err(self.refused(place, "a symbol has a name", "write `symbols('t')`"));
        };
        if let Ok(value) = self.setting.symbol(name) {
            return Ok(value);
        }
        if !torse_syntax::formula::is_name(name) || self.setting.is_declared(name) {
            let message = format!("the symbol `{name}` has another meaning in the claim");
            let help = format!("say what it stands for: `--map '{name}=FORMULA'`");
            return Err(self.refused(place, message, help));
        }
        // The variable of a sum or of an integral: if it stands elsewhere, that is seen in the end.
        Ok(Value::Term(Term::formula(Expr::name(name), false)))
    }

    /// An operation, or a function of formulas, on values.
    fn operation(&mut self, name: &str, values: Vec<Value>, place: Place) -> Read<Value> {
        match (name, values.as_slice()) {
            (operation::RANGE, [low, high, step]) => {
                let mut ends = vec![];
                for end in [low, high, step] {
                    ends.push(self.constant(end, place)?);
                }
                let [low, high, step] = ends.as_slice() else {
                    return Ok(Value::List(vec![]));
                };
                self.range(*low, *high, *step, place)
            }
            (operation::FLOAT | operation::WHOLE, [Value::Term(term)]) => {
                let is_whole = name == operation::WHOLE;
                if is_whole && !term.is_whole && term.integer().is_none() {
                    let message = "this conversion rounds";
                    let help = "code is read as exact mathematics: leave it out";
                    return Err(self.refused(place, message, help));
                }
                Ok(Value::Term(Term {
                    is_whole,
                    ..term.clone()
                }))
            }
            (operation::QUOTIENT | operation::REMAINDER, [Value::Term(a), Value::Term(b)]) => {
                self.whole(name, a, b, place)
            }
            (operation::REPEAT, [value, count]) => {
                let count = self.constant(count, place)?;
                self.repeated(vec![value.clone()], count, place)
            }
            (operation::REVERSED, [list]) => {
                let mut items = self.items(list.clone(), place)?;
                items.reverse();
                Ok(Value::List(items))
            }
            (operation::ENUMERATE, [list]) => {
                let items = self.items(list.clone(), place)?.into_iter();
                let pair = |(position, item): (i64, Value)| {
                    let position = Value::Term(Term::number(integer(position), true));
                    Value::List(vec![position, item])
                };
                Ok(Value::List((0..).zip(items).map(pair).collect()))
            }
            (operation::ZIP, lists @ [_, ..]) => {
                let mut all = vec![];
                for list in lists {
                    all.push(self.items(list.clone(), place)?);
                }
                let count = all.iter().map(Vec::len).min().unwrap_or(0);
                let row = |position: usize| {
                    let row = all.iter().filter_map(|list| list.get(position).cloned());
                    Value::List(row.collect())
                };
                Ok(Value::List((0..count).map(row).collect()))
            }
            _ => self.function(name.trim_start_matches('#'), values, place),
        }
    }

    /// Integers from low to below high.
    fn range(&mut self, low: i64, high: i64, step: i64, place: Place) -> Read<Value> {
        if step == 0 {
            let message = "a range has no step of zero";
            return Err(self.refused(place, message, "leave the step out"));
        }
        let mut all = vec![];
        let mut here = low;
        while (step > 0 && here < high) || (step < 0 && here > high) {
            self.spend(place)?;
            all.push(Value::Term(Term::number(integer(here), true)));
            let Some(next) = here.checked_add(step) else {
                break;
            };
            here = next;
        }
        Ok(Value::List(all))
    }

    /// A quotient or remainder of integers that are constants, which is exact.
    fn whole(&mut self, name: &str, a: &Term, b: &Term, place: Place) -> Read<Value> {
        let help = "fix the integers that it depends on, `--where 'n == 3'`, or divide with `/`";
        let (Some(a), Some(b)) = (a.integer(), b.integer()) else {
            let message = "this division of integers depends on the value of a symbol";
            return Err(self.refused(place, message, help));
        };
        if b == 0 {
            let message = "this divides by zero";
            return Err(self.refused(place, message, "give a divisor that is not zero"));
        }
        let remainder = match self.program.language {
            CodeLanguage::Python => a.wrapping_rem(b).wrapping_add(b).wrapping_rem(b),
            CodeLanguage::Rust => a.wrapping_rem(b),
        };
        if name == operation::REMAINDER {
            return Ok(Value::Term(Term::number(integer(remainder), true)));
        }
        if remainder != 0 {
            let message = format!("this division rounds: {a} is no multiple of {b}");
            return Err(self.refused(place, message, help));
        }
        Ok(Value::Term(Term::number(integer(a.wrapping_div(b)), true)))
    }

    /// A function of formulas.
    fn function(&mut self, name: &str, values: Vec<Value>, place: Place) -> Read<Value> {
        let count = values.len();
        if ELEMENTARY.contains(&name)
            && let [Value::Vector(items)] = values.as_slice()
        {
            let mapped = items
                .iter()
                .map(|item| self.function(name, vec![item.clone()], place));
            return Ok(Value::Vector(mapped.collect::<Read<_>>()?));
        }
        if matches!(name, "min" | "max") {
            return self.extremum(name, values, place);
        }
        let counts: &[usize] = match name {
            "abs" | "factorial" => &[1],
            "dot" | "cross" | "binom" => &[2],
            "at" => &[3],
            "D" => &[2, 3],
            "sum" | "product" | "integral" => &[4],
            _ if ELEMENTARY.contains(&name) => &[1],
            _ => &[],
        };
        if !is_function(name) || !counts.contains(&count) {
            let message = format!("`{name}` of {count} arguments is not read");
            return Err(self.refused(place, message, "give as many arguments as it has"));
        }
        // A list is a point for these alone.
        let takes_lists = matches!(name, "dot" | "cross");
        let mut terms = vec![];
        for value in values {
            let kind = value.kind();
            let term = match value {
                Value::Term(term) => Some(term),
                list if takes_lists => list.formula(),
                _ => None,
            };
            terms.push(term.ok_or_else(|| {
                let message = format!("`{name}` of {kind} is not read");
                self.refused(place, message, "give a number")
            })?);
        }
        let bound = match name {
            "at" | "D" | "integral" => terms.get(1),
            "sum" | "product" => terms.first(),
            _ => None,
        };
        if bound.is_some_and(|bound| !matches!(bound.expr.node, Node::Name(_))) {
            let message = format!("the variable of `{name}` has to be a symbol");
            return Err(self.refused(place, message, "let it stand for a symbol of the claim"));
        }
        if name == "factorial"
            && let Some(n) = terms.first().and_then(Term::integer)
            && (0..=20).contains(&n)
        {
            let product = (1..=n)
                .map(integer)
                .fold(integer(1), |product, n| product * n);
            return Ok(Value::Term(Term::number(product, true)));
        }
        if name == "abs"
            && let Some(value) = terms.first().and_then(|term| term.constant.clone())
        {
            let is_whole = value.is_integer();
            return Ok(Value::Term(Term::number(value.abs(), is_whole)));
        }
        self.bounded(Term::call(name, terms), place)
    }
}

impl Runner<'_> {
    /// The smallest or the greatest of several numbers, or of those of one list.
    fn extremum(&mut self, name: &str, values: Vec<Value>, place: Place) -> Read<Value> {
        let values = match <[Value; 1]>::try_from(values) {
            Ok([Value::List(items) | Value::Vector(items)]) => items,
            Ok([one]) => vec![one],
            Err(several) => several,
        };
        let mut found: Option<Term> = None;
        for value in values {
            let kind = value.kind();
            let Value::Term(next) = value else {
                let message = format!("`{name}` of {kind} is not read");
                return Err(self.refused(place, message, "give numbers"));
            };
            found = Some(match found {
                None => next,
                Some(before) => match (&before.constant, &next.constant) {
                    (Some(a), Some(b)) if (a >= b) == (name == "max") => before,
                    (Some(_), Some(_)) => next,
                    _ => Term::call(name, vec![before, next]),
                },
            });
        }
        match found {
            Some(found) => self.bounded(found, place),
            None => {
                let message = format!("`{name}` of nothing is not read");
                Err(self.refused(place, message, "give numbers"))
            }
        }
    }
}

/// A sum over a range.
struct Series<'e> {
    body: &'e Expr,
    variable: &'e Expr,
    low: &'e Expr,
    high: &'e Expr,
    step: &'e Expr,
}

/// A list made by a comprehension over a range.
fn series(list: &Expr) -> Option<Series<'_>> {
    let Node::Call(head, arguments) = &list.node else {
        return None;
    };
    let is = |head: &Arc<Expr>, name: &str| matches!(&head.node, Node::Name(own) if own == name);
    let [body, variable, values] = arguments.as_slice() else {
        return None;
    };
    let Node::Call(inner, bounds) = &values.node else {
        return None;
    };
    let [low, high, step] = bounds.as_slice() else {
        return None;
    };
    (is(head, operation::FOR) && is(inner, operation::RANGE)).then_some(Series {
        body,
        variable,
        low,
        high,
        step,
    })
}

/// The last integer below an end.
fn last(high: Term) -> Term {
    if let Some(value) = &high.constant {
        return Term::number(value - integer(1), true);
    }
    if let Node::Binary(Operator::Add, below, more) = &high.expr.node
        && matches!(&more.node, Node::Number { value, .. } if *value == integer(1))
    {
        return Term::formula((**below).clone(), true);
    }
    high.joined(Operator::Subtract, one())
}
