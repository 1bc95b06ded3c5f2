//! Calls: operations of programs, functions of formulas, and functions of the file.

use super::value::{Shape, Term, Value};
use super::{Frame, Runner};
use crate::grammar::Read;
use crate::program::{CodeLanguage, Kind, operation};
use torse_numbers::rational::integer;
use torse_syntax::formula::{Expr, Node, Place};

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
            (own, []) if own.starts_with(operation::SYMBOL) => {
                self.symbol(own.trim_start_matches(operation::SYMBOL), place)
            }
            (operation::INTEGER, [Value::Term(term)]) if term.kind.is_integer() => {
                Ok(Value::Term(term.clone()))
            }
            (operation::INTEGER, [other]) => {
                let message = format!("{} with a point has no `pow`", other.kind());
                Err(self.refused(
                    place,
                    message,
                    "`powi` is the power of numbers with a point",
                ))
            }
            _ => {
                if let Some(kind) = name.strip_prefix(operation::WHOLE) {
                    return self.integer(kind.trim_start_matches(':'), &values, place);
                }
                if let Some(own) = name.strip_prefix(operation::REAL) {
                    return self.real(own, values, place);
                }
                if let Some(own) = name.strip_prefix(operation::NATURAL) {
                    let is_natural = |value: &Value| match value {
                        Value::Term(term) => self.is_natural(term),
                        _ => false,
                    };
                    if !values.iter().all(is_natural) {
                        let message = format!("SciPy's `{own}` is zero for negative integers");
                        let help = "declare the integers such that they are not negative: `{ integer = \">= 0\" }`";
                        return Err(self.refused(place, message, help));
                    }
                    return self.function(own, values, place);
                }
                self.function(name.strip_prefix("##").unwrap_or(name), values, place)
            }
        }
    }
}
