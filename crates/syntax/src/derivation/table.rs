//! Reads TOML tables entry by entry, so that an invalid entry does not hide others.

use super::error::{DerivationError, LoadError};
use super::source::{Origin, Source};
use crate::formula::Place;
use serde::Deserialize;
use std::collections::BTreeMap;
use std::ops::Range;
use std::sync::Arc;
use toml::Spanned;
use toml::de::{DeTable, DeValue, Error, ValueDeserializer};

/// All mistakes in the order in which they are found.
#[derive(Debug, Default)]
pub struct Errors(pub Vec<LoadError>);

impl Errors {
    /// Returns the value, or records the error and returns `None`.
    pub fn keep<T>(&mut self, result: Result<T, LoadError>) -> Option<T> {
        result.map_err(|error| self.0.push(error)).ok()
    }
}

/// A part of a file as TOML, not yet deserialized.
type Value<'s> = Spanned<DeValue<'s>>;

/// The sections of a file, by name.
pub fn sections(source: &Arc<Source>) -> Result<BTreeMap<String, Value<'_>>, LoadError> {
    let table = DeTable::parse(&source.text).map_err(|error| wrong(source, &error, 0..0))?;
    Ok(entries(table.into_inner()))
}

fn entries(table: DeTable<'_>) -> BTreeMap<String, Value<'_>> {
    let named = table.into_iter();
    named
        .map(|(key, value)| (key.into_inner().into_owned(), value))
        .collect()
}

/// Deserializes a value.
pub fn entry<'s, T: Deserialize<'s>>(
    source: &Arc<Source>,
    value: Value<'s>,
) -> Result<T, LoadError> {
    let range = value.span();
    T::deserialize(ValueDeserializer::from(value)).map_err(|error| wrong(source, &error, range))
}

/// Deserializes a table of entries of one kind. Returns the valid ones, and the names of the invalid ones.
pub fn table<'s, T: Deserialize<'s>>(
    source: &Arc<Source>,
    value: Option<Value<'s>>,
    errors: &mut Errors,
) -> (BTreeMap<String, T>, Vec<String>) {
    let (mut read, mut unread) = (BTreeMap::new(), vec![]);
    let Some(value) = value else {
        return (read, unread);
    };
    let range = value.span();
    let DeValue::Table(table) = value.into_inner() else {
        errors.0.push(kind(source, range, "a table"));
        return (read, unread);
    };
    for (name, value) in entries(table) {
        match errors.keep(entry(source, value)) {
            Some(value) => {
                read.insert(name, value);
            }
            None => unread.push(name),
        }
    }
    (read, unread)
}

/// Deserializes a list of tables of one kind; invalid ones are reported and left out.
pub fn list<'s, T: Deserialize<'s>>(
    source: &Arc<Source>,
    value: Option<Value<'s>>,
    errors: &mut Errors,
) -> Vec<T> {
    let Some(value) = value else {
        return vec![];
    };
    let range = value.span();
    match value.into_inner() {
        DeValue::Array(items) => items
            .into_iter()
            .filter_map(|item| errors.keep(entry(source, item)))
            .collect(),
        _ => {
            errors.0.push(kind(source, range, "a list of tables"));
            vec![]
        }
    }
}

/// Reports remaining sections, which are unknown.
pub fn nothing_else(
    source: &Arc<Source>,
    left: BTreeMap<String, Value<'_>>,
    known: &[&str],
    errors: &mut Errors,
) {
    for (name, value) in left {
        let message = format!(
            "unknown section `{name}`, expected one of `{}`",
            known.join("`, `")
        );
        errors.0.push(complaint(source, value.span(), message));
    }
}

fn kind(source: &Arc<Source>, range: Range<usize>, wanted: &str) -> LoadError {
    complaint(source, range, format!("expected {wanted}"))
}

fn wrong(source: &Arc<Source>, error: &Error, default_range: Range<usize>) -> LoadError {
    let range = error.span().unwrap_or(default_range);
    let twice = match error.message() {
        "duplicate key" => source.text.get(range.clone()),
        _ => None,
    };
    let message = match twice {
        Some(name) => format!("`{name}` is there twice"),
        None => error.message().to_owned(),
    };
    complaint(source, range, message)
}

/// Makes an error about a range of a file; at least one character is shown.
pub fn complaint(source: &Arc<Source>, range: Range<usize>, message: String) -> LoadError {
    let end = range.end.max(range.start + 1).min(source.text.len());
    let origin = Origin::range(source, range.start.min(end), end);
    let error = DerivationError::at(&origin, Place::default(), message);
    LoadError::Derivation(Box::new(error))
}
