//! Values of a design file, each with its place: what is wrong is kept, and the rest is read on.

use super::formula::{FUNCTIONS, FormulaValue as Number, evaluate};
use super::numerals::{Numerals, decimal, with_unit};
use crate::design::DesignPoint;
use std::collections::BTreeMap;
use std::ops::Range;
use std::sync::Arc;
use toml::Spanned;
use toml::de::{DeTable, DeValue};
use torse_geometry::prelude::GeometryError;
use torse_numbers::rational::Rational;
use torse_syntax::derivation::{DerivationError, Origin, Source};
use torse_syntax::fault::{Fault, Problem};
use torse_syntax::formula::ast::Place;
use torse_syntax::formula::parse;
use torse_syntax::similar::similar;

/// Returns what the geometry made, or its objection at this place.
pub fn accepted<T>(
    reader: &mut Reader,
    span: &Range<usize>,
    made: Result<T, GeometryError>,
) -> Option<T> {
    made.map_err(|error| reader.complain(span, error.to_string(), ""))
        .ok()
}

/// A part of a file as TOML, not yet read.
pub type Value<'s> = Spanned<DeValue<'s>>;

/// Whether a number is a length, in the unit of the file.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum NumberKind {
    /// A plain number.
    None,
    /// A length.
    Length,
}

/// Things of one kind by name, in the order of the file: `None` for those that are wrong and were complained about.
pub type Named<T> = Vec<(String, Option<T>)>;

/// Digits after which no formula refers to another.
const MAX_DEPTH: usize = 64;

/// The text, what is wrong with it, and the constants of `[let]`.
pub struct Reader {
    source: Arc<Source>,
    /// What is wrong, in the order of the file when all is read.
    pub mistakes: Vec<(usize, DerivationError)>,
    /// The formulas of `[let]`.
    constants: BTreeMap<String, (Origin, String)>,
    /// Their values; an error is told where the constant stands, once.
    values: BTreeMap<String, Option<Number>>,
    /// How many millimetres the unit has.
    pub unit: Rational,
    /// Formulas that take the place of those of `[let]`, by name.
    pub settings: Vec<(String, String)>,
    /// The names among them that `[let]` does not have.
    pub unset: Vec<String>,
    /// The points whose coordinates stand in the text.
    pub placed: Vec<DesignPoint>,
    /// The thing that is being read, and how many points of it were read.
    within: (String, usize),
}

/// A table whose entries are taken one by one.
pub struct Entries<'s> {
    /// What the table is, for messages: `[curves.rim]`.
    pub what: String,
    /// Its place.
    pub span: Range<usize>,
    left: Vec<(String, Range<usize>, Value<'s>)>,
}

impl<'s> Entries<'s> {
    /// Returns the value of a key, if it is there.
    pub fn take(&mut self, key: &str) -> Option<Value<'s>> {
        let index = self.left.iter().position(|(name, _, _)| name == key)?;
        Some(self.left.remove(index).2)
    }

    /// Returns whether a key is there.
    pub fn has(&self, key: &str) -> bool {
        self.left.iter().any(|(name, _, _)| name == key)
    }

    /// Returns all that is left, in the order of the file.
    pub fn rest(self) -> Vec<(String, Range<usize>, Value<'s>)> {
        self.left
    }
}

impl Reader {
    /// Returns a reader of this text.
    pub fn new(source: Arc<Source>) -> Self {
        Self {
            source,
            mistakes: Vec::new(),
            constants: BTreeMap::new(),
            values: BTreeMap::new(),
            unit: Rational::from_integer(1.into()),
            settings: Vec::new(),
            unset: Vec::new(),
            placed: Vec::new(),
            within: (String::new(), 0),
        }
    }

    /// A thing with this name is read from now on.
    pub fn begin(&mut self, name: &str) {
        self.within = (name.to_owned(), 0);
    }

    /// Keeps the place of a point of the thing that is read.
    pub fn place_point(&mut self, at: [f64; 3], places: [Range<usize>; 3], plain: [bool; 3]) {
        let (name, count) = &mut self.within;
        *count += 1;
        self.placed.push(DesignPoint {
            name: name.clone(),
            number: *count,
            at,
            places,
            plain,
        });
    }

    /// The text.
    pub fn source(&self) -> Arc<Source> {
        Arc::clone(&self.source)
    }

    /// Keeps a mistake at a place of the file.
    pub fn complain(&mut self, span: &Range<usize>, message: impl Into<String>, help: &str) {
        let end = span
            .end
            .max(span.start.saturating_add(1))
            .min(self.source.text.len());
        let start = span.start.min(end);
        let origin = Origin::range(&self.source, start, end);
        let error = DerivationError::at(&origin, Place::default(), message);
        let error = if help.is_empty() {
            error
        } else {
            error.with_help(help)
        };
        self.mistakes.push((start, error));
    }

    /// Returns the entries of a table; keys that are not among the known ones are mistakes.
    pub fn entries<'s>(
        &mut self,
        value: Value<'s>,
        what: &str,
        known: &[&str],
    ) -> Option<Entries<'s>> {
        let entries = self.table(value, what)?;
        let mut left = Vec::new();
        for (name, span, value) in entries.left {
            if known.contains(&name.as_str()) {
                left.push((name, span, value));
            } else {
                let help = match similar(&name, known.iter().copied()) {
                    Some(near) => {
                        format!("did you mean `{near}`? {what} has `{}`", known.join("`, `"))
                    }
                    None => format!("{what} has `{}`", known.join("`, `")),
                };
                self.complain(&span, format!("{what} has no entry `{name}`"), &help);
            }
        }
        Some(Entries { left, ..entries })
    }

    /// Returns the entries of a table with names of the author.
    pub fn table<'s>(&mut self, value: Value<'s>, what: &str) -> Option<Entries<'s>> {
        let span = value.span();
        match value.into_inner() {
            DeValue::Table(table) => Some(Entries {
                what: what.to_owned(),
                span,
                left: ordered(table),
            }),
            other => {
                let found = kind(&other);
                self.complain(&span, format!("{found} where a table is wanted"), what);
                None
            }
        }
    }

    /// Returns the items of a list of at least `least` and at most `most` items.
    pub fn list<'s>(
        &mut self,
        value: Value<'s>,
        what: &str,
        [least, most]: [usize; 2],
    ) -> Option<Vec<Value<'s>>> {
        let span = value.span();
        let items = match value.into_inner() {
            DeValue::Array(items) => items,
            other => {
                let found = kind(&other);
                self.complain(
                    &span,
                    format!("{found} where a list of {what} is wanted"),
                    "",
                );
                return None;
            }
        };
        let given = items.len();
        if (least..=most).contains(&given) {
            return Some(items.into_iter().collect());
        }
        let wanted = match (least, most) {
            (a, b) if a == b => format!("{a} are wanted"),
            (a, b) if given < a => format!("at least {a} are wanted, at most {b}"),
            (_, b) => format!("at most {b} are read"),
        };
        self.complain(&span, format!("{given} {what}: {wanted}"), "");
        None
    }

    /// Returns a string.
    pub fn text(&mut self, value: Value<'_>, what: &str) -> Option<(String, Range<usize>)> {
        let span = value.span();
        match value.into_inner() {
            DeValue::String(text) => Some((text.into_owned(), span)),
            other => {
                let found = kind(&other);
                self.complain(
                    &span,
                    format!("{found} where {what} is wanted"),
                    "a text in quotes",
                );
                None
            }
        }
    }

    /// True or false.
    pub fn truth(&mut self, value: Value<'_>) -> Option<bool> {
        let span = value.span();
        match value.into_inner() {
            DeValue::Boolean(truth) => Some(truth),
            other => {
                let found = kind(&other);
                self.complain(
                    &span,
                    format!("{found} where `true` or `false` is wanted"),
                    "",
                );
                None
            }
        }
    }

    /// Returns one of a few words.
    pub fn word<T: Copy>(
        &mut self,
        value: Value<'_>,
        what: &str,
        words: &[(&'static str, T)],
    ) -> Option<T> {
        let (text, span) = self.text(value, what)?;
        let found = words.iter().find(|(word, _)| *word == text);
        if found.is_none() {
            let all: Vec<&str> = words.iter().map(|(word, _)| *word).collect();
            let help = format!("{what} is one of `{}`", all.join("`, `"));
            self.complain(&span, format!("`{text}` is no {what}"), &help);
        }
        found.map(|(_, meaning)| *meaning)
    }

    /// Complains of a length with a unit where a number without one is wanted.
    fn refuse_unit(&mut self, value: &Value<'_>, dimension: NumberKind) -> Option<()> {
        if let (NumberKind::None, DeValue::String(text)) = (dimension, value.get_ref())
            && with_unit(text, |name| self.constants.contains_key(name)).is_some()
        {
            let message = "a length with a unit where a number without one is wanted";
            self.complain(&value.span(), message, "");
            return None;
        }
        Some(())
    }

    /// Returns a number, or a formula for one.
    pub fn number(&mut self, value: Value<'_>, dimension: NumberKind) -> Option<f64> {
        let span = value.span();
        self.refuse_unit(&value, dimension)?;
        let number = self.exact(value)?;
        let number = match dimension {
            NumberKind::None => number,
            NumberKind::Length => number.times(&self.unit),
        };
        let double = number.to_f64();
        if double.is_none() {
            let message = "this number is too large, or lost all its digits";
            self.complain(&span, message, "numbers of a design are doubles");
        }
        double
    }

    /// Returns a number exactly as it stands in the file; one that is only enclosed is rounded to f64 first.
    pub fn rational(&mut self, value: Value<'_>, dimension: NumberKind) -> Option<Rational> {
        let span = value.span();
        self.refuse_unit(&value, dimension)?;
        let number = self.exact(value)?;
        let number = match dimension {
            NumberKind::None => number,
            NumberKind::Length => number.times(&self.unit),
        };
        let double = number.to_f64();
        if double.is_none() {
            let message = "this number is too large, or lost all its digits";
            self.complain(&span, message, "numbers of a design are doubles");
        }
        match number {
            Number::Exact(exact) => double.map(|_| exact),
            Number::Near(_) => double.map(torse_geometry::exact),
        }
    }

    /// Returns a number in a range, which is told when it is missed.
    pub fn number_in(
        &mut self,
        value: Value<'_>,
        dimension: NumberKind,
        range: &str,
        inside: impl Fn(f64) -> bool,
    ) -> Option<f64> {
        let span = value.span();
        let number = self.number(value, dimension)?;
        if inside(number) {
            return Some(number);
        }
        self.complain(&span, format!("{number} is outside {range}"), "");
        None
    }

    fn exact(&mut self, value: Value<'_>) -> Option<Number> {
        let span = value.span();
        match value.into_inner() {
            DeValue::String(text) => {
                let text = Spanned::new(span, text.into_owned());
                let origin = Origin::from_spanned(&self.source, &text);
                self.formula(&origin, text.get_ref(), text.span().start)
            }
            DeValue::Integer(number) => {
                let radix = number.radix();
                let found = match radix {
                    10 => decimal(number.as_str()),
                    _ => i64::from_str_radix(number.as_str(), radix)
                        .ok()
                        .map(|n| Rational::from_integer(n.into())),
                };
                if found.is_none() {
                    self.complain(&span, "this integer has too many digits", "");
                }
                found.map(Number::Exact)
            }
            DeValue::Float(number) => {
                let found = decimal(number.as_str());
                if found.is_none() {
                    let message = format!("{} is no finite number", number.as_str());
                    self.complain(&span, message, "infinity and NaN mean nothing in a design");
                }
                found.map(Number::Exact)
            }
            other => {
                let found = kind(&other);
                let help = "a number, or a formula in quotes: `\"sqrt(2)/2\"`";
                self.complain(&span, format!("{found} where a number is wanted"), help);
                None
            }
        }
    }

    fn formula(&mut self, origin: &Origin, text: &str, start: usize) -> Option<Number> {
        let result = self.value_of(origin, text, 0);
        result
            .map_err(|error| self.mistakes.extend(error.map(|e| (start, *e))))
            .ok()
    }

    /// Returns the value of a formula; `Err(None)` when it leans on a constant that was complained about.
    fn value_of(
        &mut self,
        origin: &Origin,
        text: &str,
        depth: usize,
    ) -> Result<Number, Option<Box<DerivationError>>> {
        let is_constant = |name: &str| self.constants.contains_key(name);
        // A length with a unit is so many of the unit of the design.
        let (text, factor) = match with_unit(text, is_constant) {
            Some((value, unit)) => (value, Some(unit.millimetres() / self.unit.clone())),
            None => (text, None),
        };
        let Numerals { text, values } = Numerals::new(text, is_constant);
        let tree = parse(&text).map_err(|error| {
            let found = DerivationError::syntax(origin, &error);
            let in_degrees = text.trim_end().ends_with("deg") || text.contains('°');
            Some(Box::new(match in_degrees {
                true => found.with_help("angles of formulas are in radians: `radians(30)`"),
                false => found,
            }))
        })?;
        let owned: Vec<String> = self.constants.keys().cloned().collect();
        let names: Vec<&str> = owned
            .iter()
            .map(String::as_str)
            .chain(["pi"])
            .chain(FUNCTIONS)
            .collect();
        let mut silent = false;
        let mut lookup = |name: &str, place: Place| -> Result<Option<Number>, Fault> {
            if depth >= MAX_DEPTH {
                return Err(Fault::at(place, Problem::Circular { limit: MAX_DEPTH }));
            }
            if let Some((_, value)) = values.iter().find(|(known, _)| known == name) {
                return Ok(Some(Number::Exact(value.clone())));
            }
            let found = self.constant(name, depth);
            silent |= matches!(found, Some(None));
            // Zero keeps the look-up going; the result is thrown away.
            Ok(found.map(|value| value.unwrap_or(Number::Exact(Rational::default()))))
        };
        let result = evaluate(&tree, &mut lookup, &names);
        if silent {
            return Err(None);
        }
        let value = result.map_err(|fault| Some(Box::new(explained(fault, origin))))?;
        Ok(match factor {
            Some(factor) => value.times(&factor),
            None => value,
        })
    }

    /// Returns the value of a constant: `None` when there is none of this name, `Some(None)` when it is wrong.
    fn constant(&mut self, name: &str, depth: usize) -> Option<Option<Number>> {
        if let Some(known) = self.values.get(name) {
            return Some(known.clone());
        }
        let (origin, text) = self.constants.get(name)?.clone();
        let result = self.value_of(&origin, &text, depth + 1);
        let value = match result {
            Ok(value) => Some(value),
            Err(error) => {
                let start = origin.span(Place::default()).offset();
                self.mistakes.extend(error.map(|e| (start, *e)));
                None
            }
        };
        // The innermost of a circle comes first, and is told once.
        let known = self.values.entry(name.to_owned()).or_insert(value);
        Some(known.clone())
    }

    /// Returns the names under `[let]`.
    pub fn names(&self) -> Vec<String> {
        self.constants.keys().cloned().collect()
    }

    /// Reads the section `[let]`.
    pub fn constants(&mut self, value: Value<'_>) {
        let Some(entries) = self.table(value, "[let]") else {
            return;
        };
        let mut plain = Vec::new();
        let settings = self.settings.clone();
        let mut missing: Vec<&(String, String)> = settings.iter().collect();
        for (name, span, mut value) in entries.rest() {
            missing.retain(|(set, _)| *set != name);
            if let Some((_, formula)) = settings.iter().rev().find(|(set, _)| *set == name) {
                value = Spanned::new(value.span(), DeValue::String(formula.clone().into()));
            }
            if !torse_syntax::formula::is_name(&name) || name == "pi" {
                let help =
                    "letters, digits and `_`, a letter first, and none of the language's own";
                self.complain(
                    &span,
                    format!("`{name}` cannot be the name of a number"),
                    help,
                );
                continue;
            }
            let place = value.span();
            if let DeValue::String(text) = value.get_ref() {
                let text = Spanned::new(place, text.clone().into_owned());
                let origin = Origin::from_spanned(&self.source, &text);
                self.constants.insert(name, (origin, text.into_inner()));
            } else {
                plain.push((name, value));
            }
        }
        self.unset = missing.into_iter().map(|(name, _)| name.clone()).collect();
        for (name, value) in plain {
            let number = self.exact(value);
            self.values.insert(name, number);
        }
        let names: Vec<String> = self.constants.keys().cloned().collect();
        for name in names {
            self.constant(&name, 0);
        }
        // Numbers that are written out can be named like the others in suggestions.
        for name in self.values.keys().cloned().collect::<Vec<_>>() {
            let origin = Origin::range(&self.source, 0, 0);
            self.constants
                .entry(name)
                .or_insert((origin, String::new()));
        }
    }

    /// Returns a thing of this name among those read so far; `None` also for one that was complained about.
    pub fn named<'t, T>(
        &mut self,
        value: Value<'_>,
        what: &str,
        things: &'t Named<T>,
    ) -> Option<&'t T> {
        let (name, span) = self.text(value, &format!("the name of a {what}"))?;
        self.find(&name, &span, what, things)
    }

    /// As [`Reader::named`], of a name that was read.
    pub fn find<'t, T>(
        &mut self,
        name: &str,
        span: &Range<usize>,
        what: &str,
        things: &'t Named<T>,
    ) -> Option<&'t T> {
        if let Some((_, thing)) = things.iter().find(|(known, _)| known == name) {
            return thing.as_ref();
        }
        let known: Vec<&str> = things.iter().map(|(name, _)| name.as_str()).collect();
        let help = match (similar(name, known.iter().copied()), known.as_slice()) {
            (Some(near), _) => format!("did you mean `{near}`?"),
            (None, []) => format!("there is no {what} above"),
            (None, known) => format!("above are `{}`", known.join("`, `")),
        };
        self.complain(span, format!("no {what} above is called `{name}`"), &help);
        None
    }

    /// `size` numbers.
    pub fn numbers<const N: usize>(
        &mut self,
        value: Value<'_>,
        dimensions: [NumberKind; N],
    ) -> Option<[f64; N]> {
        let items = self.list(value, "numbers", [N, N])?;
        let mut numbers = [0.0; N];
        let mut whole = true;
        for ((slot, item), dimension) in numbers.iter_mut().zip(items).zip(dimensions) {
            match self.number(item, dimension) {
                Some(number) => *slot = number,
                None => whole = false,
            }
        }
        whole.then_some(numbers)
    }
}

/// Faults of formulas in the words of designs.
fn explained(fault: Fault, origin: &Origin) -> DerivationError {
    let unknown = match &*fault.problem {
        Problem::UnknownName { name, similar } => Some((name.clone(), similar.clone())),
        _ => None,
    };
    let error = fault.into_error(origin);
    match unknown {
        Some((name, Some(near))) if near == name => error,
        Some((_, Some(near))) => error.with_help(format!("did you mean `{near}`?")),
        Some((_, None)) => error.with_help(
            "numbers with names stand under [let]; the functions are sqrt, exp, log, and sin, cos, tan, asin, acos, atan in radians: `sin(radians(30))`",
        ),
        None => error,
    }
}

/// Returns the entries of a table in the order of the file.
pub fn ordered(table: DeTable<'_>) -> Vec<(String, Range<usize>, Value<'_>)> {
    let mut list: Vec<_> = table
        .into_iter()
        .map(|(key, value)| {
            let span = key.span();
            (key.into_inner().into_owned(), span, value)
        })
        .collect();
    list.sort_by_key(|(_, span, _)| span.start);
    list
}

/// Returns what a value is, with the value itself where it is short.
fn kind(value: &DeValue<'_>) -> String {
    let short = |text: &str| {
        let end = text.char_indices().nth(40).map_or(text.len(), |(i, _)| i);
        text.get(..end).unwrap_or_default().to_owned()
    };
    match value {
        DeValue::String(text) => format!("the text \"{}\"", short(text)),
        DeValue::Integer(number) => format!("the number {}", short(number.as_str())),
        DeValue::Float(number) => format!("the number {}", short(number.as_str())),
        DeValue::Boolean(truth) => format!("`{truth}`"),
        DeValue::Datetime(_) => "a date".to_owned(),
        DeValue::Array(_) => "a list".to_owned(),
        DeValue::Table(_) => "a table".to_owned(),
    }
}
