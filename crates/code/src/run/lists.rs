//! Lists and arrays: their parts, their lengths, and what is made of them.

use super::value::{FOREIGN, List, Shape, Term, Value};
use super::{Frame, Runner};
use crate::grammar::Read;
use crate::program::{CodeLanguage, Kind, Type, operation};
use torse_numbers::rational::integer;
use torse_syntax::formula::{Expr, Node, Place};

impl Runner<'_> {
    /// The entries of a list between two ends, of which negative ones count from the end of the list.
    pub(super) fn slice(&mut self, list: Value, ends: &[i64], place: Place) -> Read<Value> {
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
    pub(super) fn length(&mut self, list: Value, place: Place) -> Read<Value> {
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
    pub(super) fn converted(&mut self, name: &str, value: Value, place: Place) -> Read<Value> {
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
        // All numbers of an array have one type.
        let array = self.list(Shape::Vector, values);
        Ok(match array.number_kind() {
            Kind::Unknown => array,
            kind => array.typed(&Type::Each(Box::new(Type::Number(kind)))),
        })
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
    pub(super) fn comprehension(
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

    /// What goes through lists when it is gone through.
    pub(super) fn iterator(&mut self, values: Vec<Value>, lists: &[Value]) -> Value {
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
}
