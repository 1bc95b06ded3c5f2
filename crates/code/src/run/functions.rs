//! Calls: operations of programs, functions of formulas, and functions of the file.

use super::value::{FOREIGN, List, Shape, Term, Value};
use super::{Frame, Runner, one};
use crate::grammar::{Read, small};
use crate::program::{CodeLanguage, Kind, operation};
use num_traits::Signed;
use std::sync::Arc;
use torse_numbers::rational::integer;
use torse_numbers::{Affine, Rational};
use torse_syntax::derivation::DerivationError;
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
                let value = self.value(argument, frame)?;
                values.push(Some(self.settled(value, argument.place)?));
            }
            return self.call(function, values, place);
        }
        match (name.as_str(), arguments) {
            (operation::FOR | operation::GENERATE, [body, variable, values]) => {
                let values = self.value(values, frame)?;
                let shape = match name == operation::GENERATE {
                    true => Shape::Iterator,
                    false => Shape::List,
                };
                self.comprehension(body, variable, values, shape, frame)
            }
            (
                operation::SUM | operation::PRODUCT | operation::TOTAL | operation::TOTAL_PRODUCT,
                [list],
            ) => self.folded(name, list, place, frame),
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
                let list = self.value(list, frame)?;
                let value = self.value(value, frame)?;
                let value = self.settled(value, place)?;
                match list {
                    Value::List(mut list)
                        if list.shape == Shape::List
                            || self.program.language == CodeLanguage::Rust =>
                    {
                        list.values.push(value);
                        Ok(self.list(Shape::List, list.values))
                    }
                    other => {
                        let message = format!("nothing is put at the end of {}", other.kind());
                        Err(self.refused(place, message, "make a list: `q = []`"))
                    }
                }
            }
            (operation::SLICE, [list, low, high]) => {
                let list = self.value(list, frame)?;
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
        let (shape, object) = match &list {
            Value::List(list) if matches!(list.shape, Shape::Iterator | Shape::Matrix) => {
                let message = "a part of this is not read";
                return Err(self.refused(place, message, "make a list of it: `q = list(p)`"));
            }
            // A part of an array is the same memory.
            Value::List(list) if list.shape != Shape::List => (list.shape, Some(list.object)),
            Value::List(_) => (Shape::List, None),
            _ => (Shape::Either, Some(FOREIGN)),
        };
        let items = self.items(list, place)?;
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
        let values = items.into_iter().take(high).skip(low).collect();
        let object = object.unwrap_or_else(|| self.object());
        Ok(Value::List(List {
            values,
            shape,
            object,
            sources: vec![],
        }))
    }

    /// The number of values of a list.
    fn length(&mut self, list: Value, place: Place) -> Read<Value> {
        match list {
            Value::List(list) if list.shape != Shape::Iterator && !list.has_rows() => {
                let count = i64::try_from(list.values.len()).unwrap_or(i64::MAX);
                Ok(Value::Term(Term::number(integer(count), true)))
            }
            Value::Family(family) => self.count(&family, place),
            other => {
                let message = format!("the length of {} is not read", other.kind());
                Err(self.refused(place, message, "lists and arrays have one"))
            }
        }
    }

    /// A copy, or a list or an array of the same values.
    fn converted(&mut self, name: &str, value: Value, place: Place) -> Read<Value> {
        let is_rust = self.program.language == CodeLanguage::Rust;
        let unread = |runner: &Self, value: &Value| {
            let message = format!(
                "this makes something else of {}, and is not read",
                value.kind()
            );
            runner.refused(place, message, "write its entries down")
        };
        match (name, value) {
            (operation::COPY, value) if is_rust => match value {
                list @ Value::List(_) => Ok(list),
                term @ Value::Term(_) => Ok(term),
                other => {
                    let items = self.items(other, place)?;
                    Ok(self.list(Shape::List, items))
                }
            },
            (operation::AS_VECTOR, same @ Value::Term(_)) => match &same {
                Value::Term(term) if term.is_point => Ok(same),
                _ => Err(unread(self, &same)),
            },
            (operation::AS_VECTOR, Value::List(list)) if list.shape == Shape::Vector => {
                Ok(Value::List(list))
            }
            (operation::AS_VECTOR, Value::List(list)) if list.shape == Shape::Either => {
                let message = "this is a copy of a list, and no copy of an array";
                Err(self.refused(place, message, "make an array: `array(p)`"))
            }
            // Whether it is an array or a list of points is not known: what it becomes was made outside.
            (operation::AS_VECTOR, family @ Value::Family(_)) => {
                let made = self.converted(operation::VECTOR, family, place)?;
                Ok(made.foreign())
            }
            (operation::COPY | operation::VECTOR, Value::Term(term)) if term.is_point => {
                Ok(self.copied(Value::Term(term)))
            }
            (operation::COPY, Value::List(list)) => match list.shape {
                Shape::Vector | Shape::Matrix => Ok(self.copied(Value::List(list))),
                Shape::List => Ok(self.list(Shape::List, list.values)),
                // The entries of a copy are shared if it is a list.
                Shape::Either => Ok(Value::List(list).foreign()),
                Shape::Iterator => Err(unread(self, &Value::List(list))),
            },
            (operation::COPY, family @ Value::Family(_)) => {
                let values = self.items(family, place)?;
                Ok(self.list(Shape::Either, values).foreign())
            }
            (operation::LIST, Value::Term(term)) if term.is_point => {
                let Some(dimension) = self.setting.dimension(&term.expr) else {
                    return Err(unread(self, &Value::Term(term)));
                };
                let mut values = vec![];
                for index in 0..i64::from(dimension) {
                    let index = Value::Term(Term::number(integer(index), true));
                    values.push(self.entry(Value::Term(term.clone()), index, place)?);
                }
                Ok(self.list(Shape::List, values))
            }
            // The rows of an array stay parts of it.
            (operation::LIST, list @ (Value::List(_) | Value::Family(_))) => {
                let values = self.items(list, place)?;
                Ok(self.list(Shape::List, values))
            }
            (operation::MATRIX, Value::List(list)) => self.matrix(list, place),
            (operation::VECTOR | operation::AS_VECTOR, Value::List(list))
                if !matches!(list.shape, Shape::Iterator | Shape::Matrix) =>
            {
                self.array(list, place)
            }
            (operation::VECTOR, family @ Value::Family(_)) => {
                let values = self.items(family, place)?;
                let values = values.into_iter().map(|value| self.copied(value)).collect();
                Ok(self.list(Shape::Vector, values))
            }
            (_, other) => Err(unread(self, &other)),
        }
    }

    /// An array of the values of lists, with memory of its own.
    fn array(&mut self, list: List, place: Place) -> Read<Value> {
        let mut values = vec![];
        let mut size = None;
        for value in list.values {
            let value = match value {
                inner @ Value::List(_) => self.converted(operation::VECTOR, inner, place)?,
                term @ Value::Term(_) => self.copied(term),
                other => {
                    let message = format!("an array of {} is not read", other.kind());
                    return Err(self.refused(place, message, "give numbers and points"));
                }
            };
            let own = match &value {
                Value::List(row) => Some(row.values.len()),
                Value::Term(term) if term.is_point => Some(usize::MAX),
                _ => None,
            };
            if *size.get_or_insert(own) != own {
                let message = "the rows of this array have different lengths";
                return Err(self.refused(place, message, "give rows of one length"));
            }
            values.push(value);
        }
        Ok(self.list(Shape::Vector, values))
    }

    /// A matrix of SymPy: of a list of numbers, or of rows of one length.
    fn matrix(&mut self, list: List, place: Place) -> Read<Value> {
        let is_row = |value: &Value| match value {
            Value::List(row) => row.shape == Shape::List && !row.is_nested(),
            _ => false,
        };
        let lengths: Vec<usize> = list
            .values
            .iter()
            .map(|value| match value {
                Value::List(row) => row.values.len(),
                _ => 0,
            })
            .collect();
        let is_column = !list.is_nested();
        let has_rows = list.values.iter().all(is_row) && lengths.windows(2).all(|w| w[0] == w[1]);
        if list.shape != Shape::List || list.values.is_empty() || !(is_column || has_rows) {
            let message = "this matrix is not read";
            return Err(self.refused(place, message, "give a list of numbers, or of rows"));
        }
        let mut values = vec![];
        for value in list.values {
            values.push(match value {
                Value::List(row) => self.list(Shape::Matrix, row.values),
                other => other,
            });
        }
        Ok(self.list(Shape::Matrix, values))
    }

    /// The list of the values of a body.
    fn comprehension(
        &mut self,
        body: &Expr,
        variable: &Expr,
        values: Value,
        shape: Shape,
        frame: &mut Frame,
    ) -> Read<Value> {
        let mut found = vec![];
        for value in self.items(values, variable.place)? {
            self.spend(body.place)?;
            let outer = frame.hidden.len();
            self.bind(variable, value, frame)?;
            let value = self.value(body, frame);
            frame.restore(outer);
            found.push(self.settled(value?, body.place)?);
        }
        Ok(self.list(shape, found))
    }

    /// Gives the variable of a comprehension its value.
    fn bind(&mut self, variable: &Expr, value: Value, frame: &mut Frame) -> Read<()> {
        let wrong = |runner: &Self| {
            let message = "there are as many values as names";
            runner.refused(variable.place, message, "write `for i, p in enumerate(P)`")
        };
        match (&variable.node, value) {
            (Node::Name(name), value) => {
                frame.hide(name, value);
                Ok(())
            }
            (Node::List(names), Value::List(list))
                if names.len() == list.values.len() && !list.has_rows() =>
            {
                let mut pairs = names.iter().zip(list.values);
                pairs.try_for_each(|(name, value)| self.bind(name, value, frame))
            }
            _ => Err(wrong(self)),
        }
    }

    /// The sum or the product of a list; of a range whose ends are not fixed, one of the language.
    fn folded(&mut self, name: &str, list: &Expr, place: Place, frame: &mut Frame) -> Read<Value> {
        let operator = match name {
            operation::SUM | operation::TOTAL => Operator::Add,
            _ => Operator::Multiply,
        };
        let is_total = matches!(name, operation::TOTAL | operation::TOTAL_PRODUCT);
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
                let value = self.series(operator, &parts, [low, high], place, frame)?;
                return match &value {
                    Value::Term(term) if term.is_point && is_total => Err(self.total(place)),
                    _ => Ok(value),
                };
            }
        }
        let values = self.value(list, frame)?;
        let is_iterator = matches!(&values, Value::List(list) if list.shape == Shape::Iterator);
        if name == operation::TOTAL_PRODUCT && is_iterator {
            let message = "NumPy makes no product of what is gone through once";
            return Err(self.refused(place, message, "give it a list"));
        }
        let mut all = self.items(values, place)?;
        if is_total {
            all = self.numbers(all, place)?;
        }
        let is_python = self.program.language == CodeLanguage::Python;
        let is_added =
            |value: &Value| !matches!(value, Value::List(list) if list.shape != Shape::Vector);
        if is_python && !all.iter().all(is_added) {
            let message = "a sum of lists is not read";
            return Err(self.refused(place, message, "numbers and arrays are added"));
        }
        let mut items = all.into_iter();
        let neutral = i64::from(operator == Operator::Multiply);
        let Some(first) = items.next() else {
            return Ok(Value::Term(Term::number(integer(neutral), true)));
        };
        let first = self.copied(first);
        items.try_fold(first, |sum, item| {
            self.spend(place)?;
            self.combined(operator, sum, item, place)
        })
    }

    /// All numbers of nested lists.
    fn numbers(&mut self, values: Vec<Value>, place: Place) -> Read<Vec<Value>> {
        let mut found = vec![];
        for value in values {
            self.spend(place)?;
            match value {
                Value::Term(term) if !term.is_point => found.push(Value::Term(term)),
                Value::List(list) if !matches!(list.shape, Shape::Iterator | Shape::Matrix) => {
                    found.extend(self.numbers(list.values, place)?);
                }
                _ => return Err(self.total(place)),
            }
        }
        Ok(found)
    }

    /// Refuses the sum of the coordinates of points.
    fn total(&self, place: Place) -> Box<DerivationError> {
        let message = "NumPy adds up all coordinates of points here";
        self.refused(place, message, "Python's own `sum` adds points")
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
        // A name that a change of the program has put in may be none of the language.
        let mut index = name.trim_matches('_').to_owned();
        if !torse_syntax::formula::is_name(&index) {
            index = "i".to_owned();
        }
        while self.setting.is_declared(&index) || self.bound.contains(&index) {
            index = format!("i{index}");
        }
        let outer = frame.hidden.len();
        let variable = Term::formula(Expr::name(&index), Kind::Whole);
        frame.hide(name, Value::Term(variable));
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
        let index = Term::formula(Expr::name(&index), Kind::Whole);
        let (kind, is_point) = (body.kind, body.is_point);
        if is_point && operator == Operator::Multiply {
            let message = "a product of points is not read";
            return Err(self.refused(place, message, "points are added"));
        }
        let term = Term {
            kind,
            is_point,
            ..Term::call(name, vec![index, low, high, body])
        };
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
        Ok(Value::Term(Term::formula(Expr::name(name), Kind::Float)))
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
                    return Ok(self.list(Shape::List, vec![]));
                };
                self.range(*low, *high, *step, place)
            }
            (operation::FLOAT, [Value::Term(term)]) => Ok(Value::Term(Term {
                kind: Kind::Float,
                ..term.clone()
            })),
            (operation::LENGTH, [list]) => self.length(list.clone(), place),
            (
                operation::COPY
                | operation::LIST
                | operation::VECTOR
                | operation::AS_VECTOR
                | operation::MATRIX,
                [value],
            ) => self.converted(name, value.clone(), place),
            (
                operation::SUMMED | operation::MULTIPLIED,
                [_, Value::Term(low), Value::Term(high), _],
            ) => {
                if !self.runs_upwards(low, high) {
                    let message = "this may run from a greater end to a smaller one, where SymPy gives it a value of its own";
                    let help = "declare the integers of its ends such that it has terms, or fix them: `--where 'n == 3'`";
                    return Err(self.refused(place, message, help));
                }
                let own = match name == operation::SUMMED {
                    true => "sum",
                    false => "product",
                };
                self.function(own, values, place)
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
                Ok(self.iterator(items, &values))
            }
            (operation::ENUMERATE, [list]) => {
                let items = self.items(list.clone(), place)?;
                let mut pairs = vec![];
                for (position, item) in (0..).zip(items) {
                    let position = Value::Term(Term::number(integer(position), true));
                    pairs.push(self.list(Shape::List, vec![position, item]));
                }
                Ok(self.iterator(pairs, &values))
            }
            (operation::ZIP, lists @ [_, ..]) => {
                let mut all = vec![];
                for list in lists {
                    all.push(self.items(list.clone(), place)?);
                }
                let count = all.iter().map(Vec::len).min().unwrap_or(0);
                let mut rows = vec![];
                for position in 0..count {
                    let row = all.iter().filter_map(|list| list.get(position).cloned());
                    let row = row.collect();
                    rows.push(self.list(Shape::List, row));
                }
                Ok(self.iterator(rows, &values))
            }
            _ => match (name.strip_prefix(operation::WHOLE), name.strip_prefix("##")) {
                (Some(kind), _) => self.integer(kind.trim_start_matches(':'), &values, place),
                (None, Some(own)) => self.function(own, values, place),
                (None, None) => self.function(name, values, place),
            },
        }
    }

    /// What goes through lists when it is gone through.
    fn iterator(&mut self, values: Vec<Value>, lists: &[Value]) -> Value {
        let mut sources = vec![];
        for list in lists {
            if let Value::List(list) = list {
                sources.push(list.object);
                sources.extend(&list.sources);
            }
        }
        let shape = match self.program.language {
            CodeLanguage::Python => Shape::Iterator,
            CodeLanguage::Rust => Shape::List,
        };
        let object = self.object();
        Value::List(List {
            values,
            shape,
            object,
            sources,
        })
    }

    /// A number as an integer of a type.
    fn integer(&mut self, kind: &str, values: &[Value], place: Place) -> Read<Value> {
        let [Value::Term(term)] = values else {
            let message = "the conversion of this into an integer is not read";
            return Err(self.refused(place, message, "numbers are converted"));
        };
        let bits = |kind: &str| match kind {
            "size" => Some(64),
            other => other.parse::<u32>().ok().filter(|bits| *bits <= 128),
        };
        let ends = match kind.split_at_checked(1) {
            Some(("u", size)) => bits(size).map(|bits| (integer(0), integer(2).pow(bits as i32))),
            Some(("i", size)) => bits(size).map(|bits| {
                let end = integer(2).pow(bits as i32 - 1);
                (-end.clone(), end)
            }),
            _ => None,
        };
        let fits = |value: &Rational| {
            let ends = ends.as_ref();
            value.is_integer() && ends.is_none_or(|(low, end)| low <= value && value < end)
        };
        let is_exact = match &term.constant {
            Some(value) => fits(value),
            None => term.kind == Kind::Whole,
        };
        if !is_exact || term.is_point {
            let message = match &term.constant {
                Some(value) if value.is_integer() => format!("{value} is no value of `{kind}`"),
                _ => "this conversion rounds".to_owned(),
            };
            let help = "code is read as exact mathematics: leave it out";
            return Err(self.refused(place, message, help));
        }
        Ok(Value::Term(Term {
            kind: Kind::Whole,
            ..term.clone()
        }))
    }

    /// Whether a sum has terms, or just none, for all values of the symbols.
    fn runs_upwards(&self, low: &Term, high: &Term) -> bool {
        let (Some(low), Some(high)) = (affine(&low.expr), affine(&high.expr)) else {
            return false;
        };
        let count = high - low + Affine::number(1);
        let least = self.setting.declarations.least(&count);
        least.is_some_and(|least| least >= 0)
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
        Ok(self.list(Shape::List, all))
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
        let (above, below) = (i128::from(a), i128::from(b));
        let remainder = match self.program.language {
            CodeLanguage::Python => (above % below + below) % below,
            CodeLanguage::Rust => above % below,
        };
        let remainder = i64::try_from(remainder).unwrap_or(0);
        if name == operation::REMAINDER {
            return Ok(Value::Term(Term::number(integer(remainder), true)));
        }
        if remainder != 0 {
            let message = format!("this division rounds: {a} is no multiple of {b}");
            return Err(self.refused(place, message, help));
        }
        let Some(quotient) = a.checked_div(b) else {
            let message = "this division overflows";
            return Err(self.refused(place, message, help));
        };
        Ok(Value::Term(Term::number(integer(quotient), true)))
    }

    /// A function of formulas.
    fn function(&mut self, name: &str, values: Vec<Value>, place: Place) -> Read<Value> {
        let count = values.len();
        if ELEMENTARY.contains(&name)
            && let [Value::List(list)] = values.as_slice()
            && list.shape == Shape::Vector
        {
            let list = list.clone();
            return self.each(list, |runner, item| {
                runner.function(name, vec![item], place)
            });
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
        if matches!(name, "dot" | "cross") {
            self.are_points(name, &values, place)?;
        }
        // A list is a point for these alone, and a point may stand in them.
        let takes_lists = matches!(name, "dot" | "cross");
        let takes_points = takes_lists || matches!(name, "D" | "at" | "integral" | "sum");
        let is_python = self.program.language == CodeLanguage::Python;
        let mut terms = vec![];
        for value in values {
            let kind = value.kind();
            let term = match value {
                Value::Term(term) if takes_points || !term.is_point => Some(term),
                list if takes_lists => list.formula(),
                _ => None,
            };
            terms.push(term.ok_or_else(|| {
                let message = format!("`{name}` of {kind} is not read");
                self.refused(place, message, "give a number")
            })?);
        }
        if name == "D"
            && let [_, _, times] = terms.as_slice()
            && times.integer().is_none()
        {
            let message = "how many times this is differentiated is a constant";
            let help = "differentiate by one symbol after the other: `diff(diff(f, x), y)`";
            return Err(self.refused(place, message, help));
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
            let kind = terms.first().map_or(Kind::Unknown, |term| term.kind);
            return Ok(Value::Term(Term {
                kind,
                ..Term::number(value.abs(), false)
            }));
        }
        let kind = match name {
            "abs" => terms.first().map_or(Kind::Unknown, |term| term.kind),
            "binom" | "factorial" => Kind::Whole,
            // The functions of the language of a program are those of floating-point numbers.
            _ if ELEMENTARY.contains(&name) => Kind::Float,
            _ if is_python => Kind::Float,
            _ => Kind::Unknown,
        };
        let is_point = match name {
            "dot" => false,
            "cross" => true,
            _ => terms.iter().any(|term| term.is_point),
        };
        let term = Term {
            kind,
            is_point,
            ..Term::call(name, terms)
        };
        self.bounded(term, place)
    }

    /// Fails unless both are points, or lists of numbers that are as long.
    fn are_points(&self, name: &str, values: &[Value], place: Place) -> Read<()> {
        let mut lengths = vec![];
        for value in values {
            lengths.push(match value {
                Value::Term(term) if term.is_point => {
                    let dimension = self.setting.dimension(&term.expr);
                    Some(dimension.map(usize::from))
                }
                Value::List(list) if list.shape != Shape::Iterator && !list.is_nested() => {
                    Some(Some(list.values.len()))
                }
                _ => None,
            });
        }
        let (known, all) = match lengths.as_slice() {
            [Some(one), Some(other)] => (
                one.or(*other),
                one.is_none_or(|one| other.is_none_or(|o| o == one)),
            ),
            _ => (None, false),
        };
        if !all || (name == "cross" && known.is_some_and(|length| length != 3)) {
            let message = format!("this `{name}` is not read");
            let help = "it is read of two points, or of two lists of numbers of one length";
            return Err(self.refused(place, message, help));
        }
        Ok(())
    }
}

impl Runner<'_> {
    /// The smallest or the greatest of several numbers, or of those of one list.
    fn extremum(&mut self, name: &str, values: Vec<Value>, place: Place) -> Read<Value> {
        let values = match <[Value; 1]>::try_from(values) {
            Ok([Value::List(list)]) if !list.has_rows() => list.values,
            Ok([one]) => {
                let message = format!("`{name}` of {} is not read", one.kind());
                return Err(self.refused(place, message, "give several numbers, or a list"));
            }
            Err(several) => several,
        };
        let mut found: Option<Term> = None;
        for value in values {
            let kind = value.kind();
            let next = match value {
                Value::Term(next) if !next.is_point => next,
                _ => {
                    let message = format!("`{name}` of {kind} is not read");
                    return Err(self.refused(place, message, "give numbers"));
                }
            };
            found = Some(match found {
                None => next,
                Some(before) => match (&before.constant, &next.constant) {
                    (Some(a), Some(b)) if (a >= b) == (name == "max") => before,
                    (Some(_), Some(_)) => next,
                    _ => Term {
                        kind: before.kind.joined(next.kind),
                        ..Term::call(name, vec![before, next])
                    },
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
    let is_list = is(head, operation::FOR) || is(head, operation::GENERATE);
    (is_list && is(inner, operation::RANGE)).then_some(Series {
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
        return Term::formula((**below).clone(), high.kind);
    }
    high.joined(Operator::Subtract, one())
}

/// A formula as a sum of multiples of integers, if it is one.
fn affine(expr: &Expr) -> Option<Affine> {
    match &expr.node {
        Node::Number { value, .. } => Some(Affine::number(small(value)?)),
        Node::Name(name) => Some(Affine::symbol(name)),
        Node::Negative(inner) => Some(affine(inner)? * -1),
        Node::Binary(Operator::Add, a, b) => Some(affine(a)? + affine(b)?),
        Node::Binary(Operator::Subtract, a, b) => Some(affine(a)? - affine(b)?),
        Node::Binary(Operator::Multiply, a, b) => {
            let (a, b) = (affine(a)?, affine(b)?);
            let scaled = a.as_number().map(|factor| b.clone() * factor);
            scaled.or_else(|| b.as_number().map(|factor| a * factor))
        }
        _ => None,
    }
}
