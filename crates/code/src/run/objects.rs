//! Objects: lists and arrays that have several names, and show each change under all of them.
//!
//! Values are copied here. So each list has a number ([`Object`]) that its copies keep. A change gives it a new number under the name
//! by which it is changed; whoever has the old one has what is out of date, and is refused when it is read. What was made outside of the
//! function that changes it, such as an argument, a default or a constant, has names that are not seen, and is not changed at all.
//! In Rust the compiler sees to all of this.

use super::value::{FOREIGN, List, Object, Shape, Term, Value};
use super::{Frame, Runner, position};
use crate::grammar::Read;
use crate::program::{Assignment, CodeLanguage, Target};
use torse_syntax::derivation::DerivationError;
use torse_syntax::formula::{Expr, Place};

/// The indices of one pair of brackets, with their place.
type Brackets = (Vec<i64>, Place);

/// How many entries that are looked at cost as much as a step.
const LOOKED_THROUGH: usize = 64;

/// How an entry is replaced.
struct Change {
    value: Value,
    /// Whether the object at the entry is changed where it is, as by `+=`.
    is_in_place: bool,
    first: Object,
    place: Place,
}

impl Runner<'_> {
    /// The number of a new object.
    pub(super) fn object(&mut self) -> Object {
        self.objects += 1;
        self.objects
    }

    /// A new list.
    pub(super) fn list(&mut self, shape: Shape, values: Vec<Value>) -> Value {
        Value::List(List {
            values,
            shape,
            object: self.object(),
            sources: vec![],
        })
    }

    /// A new array of the same values, or a new point.
    pub(super) fn copied(&mut self, value: Value) -> Value {
        match value {
            Value::List(list) => {
                let values = list.values.into_iter();
                let values = values.map(|value| self.copied(value)).collect();
                self.list(list.shape, values)
            }
            Value::Term(term) if term.is_point => Value::Term(Term {
                object: self.object(),
                ..term
            }),
            other => other,
        }
    }

    /// Fails for what was changed under another name.
    pub(super) fn is_current(&self, value: &Value, place: Place) -> Read<()> {
        if self.changed.is_empty() {
            return Ok(());
        }
        let mut objects = vec![];
        value.objects(&mut objects);
        match objects.iter().any(|object| self.changed.contains(object)) {
            true => Err(self.stale("this", place)),
            false => Ok(()),
        }
    }

    pub(super) fn stale(&self, name: &str, place: Place) -> Box<DerivationError> {
        let subject = match name {
            "this" => "this list".to_owned(),
            name => format!("`{name}`"),
        };
        let message = format!("{subject} was changed under another name");
        self.refused(
            place,
            message,
            "make a copy before the change: `q = list(p)`, `q = p.copy()`",
        )
    }

    /// Fails for what can be gone through once, where it would get a name.
    pub(super) fn settled(&self, value: Value, place: Place) -> Read<Value> {
        if let Value::List(list) = &value
            && list.shape == Shape::Iterator
        {
            let message = "this can be gone through once";
            return Err(self.refused(place, message, "make a list of it: `q = list(p)`"));
        }
        Ok(value)
    }

    /// Fails unless an object was made in this call; from here on other names of it are out of date.
    fn change(&mut self, object: Object, first: Object, place: Place) -> Read<()> {
        if self.program.language == CodeLanguage::Rust {
            return Ok(());
        }
        if object == FOREIGN || object < first {
            let message = "this was made outside of the function, and is changed here";
            let help = "make a copy of it before: `q = list(p)`, `q = p.copy()`";
            return Err(self.refused(place, message, help));
        }
        self.changed.insert(object);
        Ok(())
    }

    /// Changes an object and all that it consists of: the memory of an array, or the list alone.
    fn change_all(&mut self, value: &Value, first: Object, place: Place) -> Read<()> {
        match value {
            Value::List(list) if matches!(list.shape, Shape::Vector | Shape::Matrix) => {
                self.change(list.object, first, place)?;
                let mut values = list.values.iter();
                values.try_for_each(|value| self.change_all(value, first, place))
            }
            Value::List(list) if list.shape == Shape::List => {
                self.change(list.object, first, place)
            }
            Value::List(_) => self.change(FOREIGN, first, place),
            Value::Term(term) if term.is_point => self.change(term.object, first, place),
            _ => Ok(()),
        }
    }

    pub(super) fn assign(
        &mut self,
        target: &Target,
        value: Value,
        how: Assignment,
        frame: &mut Frame,
    ) -> Read<()> {
        match target {
            Target::Name(name, place) => {
                let value = self.settled(value, *place)?;
                match how {
                    Assignment::Declare => {
                        frame.hide(name, value);
                        return Ok(());
                    }
                    Assignment::Set => {}
                    Assignment::InPlace => {
                        if let Some(old) = frame.variables.get(name).cloned() {
                            self.keeps_floats(&old, &value, *place)?;
                            self.change_all(&old, frame.first, *place)?;
                        }
                    }
                }
                frame.variables.insert(name.clone(), value);
                Ok(())
            }
            Target::Several(targets, place) => {
                let values = match value {
                    Value::List(list) if list.values.len() == targets.len() && !list.has_rows() => {
                        list.values
                    }
                    other => {
                        let message = format!("{} names for {}", targets.len(), other.kind());
                        let help = "there are as many values as names";
                        return Err(self.refused(*place, message, help));
                    }
                };
                for (target, value) in targets.iter().zip(values) {
                    self.is_current(&value, *place)?;
                    self.assign(target, value, how, frame)?;
                }
                Ok(())
            }
            Target::Entry(name, indices, place) => {
                let path = self.places(indices, frame)?;
                let mut list = self.taken(name, *place, frame)?;
                let value = self.settled(value, *place)?;
                let change = Change {
                    value,
                    is_in_place: how == Assignment::InPlace,
                    first: frame.first,
                    place: *place,
                };
                self.replace(&mut list, &path, change)?;
                frame.variables.insert(name.clone(), list);
                Ok(())
            }
        }
    }

    /// A list taken out of its variable, to be changed and put back: it is not copied.
    fn taken(&mut self, name: &str, place: Place, frame: &mut Frame) -> Read<Value> {
        let Some(list) = frame.variables.remove(name) else {
            let message = format!("`{name}` has no value here");
            return Err(self.refused(place, message, "make the list before"));
        };
        self.spend_all(list.entries(super::MAX_CODE_STEPS) / LOOKED_THROUGH, place)?;
        match self.is_current(&list, place) {
            Ok(()) => Ok(list),
            Err(_) => Err(self.stale(name, place)),
        }
    }

    /// `name.append(value)`.
    pub(super) fn append(
        &mut self,
        name: &str,
        value: Value,
        place: Place,
        frame: &mut Frame,
    ) -> Read<()> {
        let value = self.settled(value, place)?;
        let is_rust = self.program.language == CodeLanguage::Rust;
        match self.taken(name, place, frame)? {
            Value::List(mut list) if list.shape == Shape::List || is_rust => {
                self.change(list.object, frame.first, place)?;
                list.values.push(value);
                let grown = self.list(Shape::List, list.values);
                frame.variables.insert(name.to_owned(), grown);
                Ok(())
            }
            other => {
                let message = format!("nothing is put at the end of {}", other.kind());
                Err(self.refused(place, message, "make a list: `q = []`"))
            }
        }
    }

    /// Replaces the entry of a list at the end of a path. Returns whether the memory of an array is changed.
    fn replace(&mut self, list: &mut Value, path: &[Brackets], change: Change) -> Read<bool> {
        let [(indices, at), rest @ ..] = path else {
            return Ok(false);
        };
        let at = *at;
        let kind = list.kind();
        let is_rust = self.program.language == CodeLanguage::Rust;
        let list = match list {
            Value::List(list)
                if is_rust || !matches!(list.shape, Shape::Iterator | Shape::Either) =>
            {
                list
            }
            Value::List(_) => {
                self.change(FOREIGN, change.first, change.place)?;
                return Ok(false);
            }
            _ => {
                let message = format!("{kind} has no entries that can be changed");
                return Err(self.refused(at, message, "make a list: `q = list(p)`"));
            }
        };
        // A matrix has both indices in one pair of brackets, an array may have, and a list never.
        let inner = match (indices.as_slice(), list.shape) {
            ([_], Shape::Matrix) if list.has_rows() => None,
            ([_], _) => Some(rest.to_vec()),
            ([_, more @ ..], Shape::Vector) => {
                let mut path = vec![(more.to_vec(), at)];
                path.extend_from_slice(rest);
                Some(path)
            }
            ([_, second], Shape::Matrix) if list.has_rows() && rest.is_empty() => {
                Some(vec![(vec![*second], at)])
            }
            _ => None,
        };
        let (Some(inner), Some(index)) = (inner, indices.first()) else {
            let message = format!("{kind} has other indices");
            let help = "write `m[i][j]` for lists, and `M[i, j]` for matrices";
            return Err(self.refused(at, message, help));
        };
        let count = list.values.len();
        let position = position(*index, count, !is_rust);
        let Some(position) = position.filter(|position| *position < count) else {
            let message = format!("there is no entry {index} among {count}");
            return Err(self.refused(at, message, "entries are counted from 0"));
        };
        let (first, place) = (change.first, change.place);
        let is_array = matches!(list.shape, Shape::Vector | Shape::Matrix);
        let is_changed = match inner.is_empty() {
            true => {
                let old = list.values.get(position).cloned();
                let value = self.stored(list, old, change)?;
                if let Some(entry) = list.values.get_mut(position) {
                    *entry = value;
                }
                true
            }
            false => match list.values.get_mut(position) {
                Some(entry) => self.replace(entry, &inner, change)? && is_array,
                None => false,
            },
        };
        if is_changed {
            self.change(list.object, first, place)?;
            list.object = self.object();
        }
        Ok(is_changed && is_array)
    }

    /// What becomes of an entry of a list to which something is assigned: the thing itself in a list, a copy in an array.
    fn stored(&mut self, list: &List, old: Option<Value>, change: Change) -> Read<Value> {
        let Change {
            value,
            is_in_place,
            first,
            place,
        } = change;
        if self.program.language == CodeLanguage::Rust {
            return Ok(value);
        }
        let Some(old) = old else {
            return Ok(value);
        };
        let is_array = matches!(list.shape, Shape::Vector | Shape::Matrix);
        if is_in_place {
            self.keeps_floats(&old, &value, place)?;
        }
        if is_in_place || is_array {
            self.change_all(&old, first, place)?;
        }
        if !is_array {
            return Ok(value);
        }
        if !has_the_form(&old, &value) {
            let message = format!("{} is put where an array has {}", value.kind(), old.kind());
            let help = "assign numbers to numbers, and rows to rows of the same length";
            return Err(self.refused(place, message, help));
        }
        let whole = Value::List(list.clone());
        if list.shape == Shape::Vector {
            self.keeps_floats(&whole, &value, place)?;
        }
        Ok(match (self.copied(value), &old) {
            (Value::List(row), Value::List(old)) => Value::List(List {
                shape: old.shape,
                ..row
            }),
            (value, _) => value,
        })
    }

    /// Fails where numbers are put into an array of integers, which cuts them off.
    fn keeps_floats(&self, old: &Value, new: &Value, place: Place) -> Read<()> {
        let is_array = matches!(old, Value::List(list) if list.shape == Shape::Vector);
        let is_python = self.program.language == CodeLanguage::Python;
        if is_python && is_array && old.is_without_floats() && !new.is_whole() {
            let message = "this is an array of integers, in which numbers are cut off";
            let help = "write its entries with a point: `array([0.0, 0.0])`";
            return Err(self.refused(place, message, help));
        }
        Ok(())
    }

    /// Indices that are constants, by their brackets.
    fn places(&mut self, indices: &[Expr], frame: &mut Frame) -> Read<Vec<Brackets>> {
        let mut found = vec![];
        for index in indices {
            let all = match self.value(index, frame)? {
                Value::List(list) => list.values,
                one => vec![one],
            };
            let all = all.iter().map(|value| self.constant(value, index.place));
            found.push((all.collect::<Read<Vec<i64>>>()?, index.place));
        }
        Ok(found)
    }
}

/// Whether both are numbers, both points, or both lists of as many entries.
fn has_the_form(old: &Value, new: &Value) -> bool {
    match (old, new) {
        (Value::Term(old), Value::Term(new)) => old.is_point == new.is_point,
        (Value::List(old), Value::List(new)) => {
            old.values.len() == new.values.len()
                && new.shape != Shape::Iterator
                && old
                    .values
                    .iter()
                    .zip(&new.values)
                    .all(|(old, new)| has_the_form(old, new))
        }
        _ => false,
    }
}
