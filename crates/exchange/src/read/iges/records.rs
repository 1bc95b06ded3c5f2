//! The text of an IGES file: lines of 80 columns in five sections, the directory and the parameters of its entities.

use crate::read::decimal::{decimal, double};
use crate::read::error::{FilePlace, ReadError, ReadResult, at, at_line};
use std::collections::HashMap;
use torse_algebra::Rational;

/// The most entities of a file.
const MAX_ENTITIES: usize = 1_000_000;

/// An entity: its entry in the directory, and its parameters as text.
#[derive(Debug, Clone)]
pub(super) struct Entity<'t> {
    /// The number of its entry in the directory.
    pub id: usize,
    pub line: usize,
    pub kind: i64,
    pub form: i64,
    /// The entry of its matrix, zero for none.
    pub matrix: usize,
    /// Not to be shown; part of another entity; not in space.
    pub hidden: bool,
    pub dependent: bool,
    pub label: &'t str,
    values: Vec<String>,
}

impl Entity<'_> {
    pub(super) fn place(&self) -> FilePlace {
        FilePlace::entity(
            self.line,
            format!("entity {} (type {})", self.id, self.kind),
        )
    }

    fn text(&self, index: usize) -> ReadResult<&str> {
        let value = self.values.get(index).map(String::as_str);
        value.ok_or_else(|| at(&self.place(), format!("parameter {} is missing", index + 1)))
    }

    fn wrong(&self, index: usize, what: &str) -> ReadError {
        let shown: String = self
            .values
            .get(index)
            .map(|v| v.chars().take(40).collect())
            .unwrap_or_default();
        at(
            &self.place(),
            format!("parameter {}, `{shown}`, is {what}", index + 1),
        )
    }

    /// A whole number; one that is left out is zero.
    pub(super) fn whole(&self, index: usize) -> ReadResult<i64> {
        let text = self.text(index)?;
        if text.is_empty() {
            return Ok(0);
        }
        text.parse()
            .map_err(|_| self.wrong(index, "no whole number"))
    }

    /// A number of things, not below zero.
    pub(super) fn count(&self, index: usize) -> ReadResult<usize> {
        let number = usize::try_from(self.whole(index)?).ok();
        // A count cannot exceed what follows it.
        number
            .filter(|n| *n <= self.values.len())
            .ok_or_else(|| self.wrong(index, "no count of what follows"))
    }

    pub(super) fn exact(&self, index: usize) -> ReadResult<Rational> {
        let text = self.text(index)?;
        if text.is_empty() {
            return Ok(Rational::default());
        }
        decimal(text).ok_or_else(|| self.wrong(index, "no finite number"))
    }

    pub(super) fn exacts(&self, from: usize, count: usize) -> ReadResult<Vec<Rational>> {
        (from..from + count)
            .map(|index| self.exact(index))
            .collect()
    }

    pub(super) fn number(&self, index: usize) -> ReadResult<f64> {
        let text = self.text(index)?;
        if text.is_empty() {
            return Ok(0.0);
        }
        let text = text.replace(['d', 'D'], "e");
        double(&text).ok_or_else(|| self.wrong(index, "no finite number"))
    }

    pub(super) fn point(&self, index: usize) -> ReadResult<[Rational; 3]> {
        Ok([
            self.exact(index)?,
            self.exact(index + 1)?,
            self.exact(index + 2)?,
        ])
    }
}

/// A file: what its head says, and its entities by their entries in the directory.
pub(super) struct File<'t> {
    /// The parameters of the global section.
    pub global: Vec<String>,
    pub entities: Vec<Entity<'t>>,
    index: HashMap<usize, usize>,
}

impl<'t> File<'t> {
    /// The entity that a parameter points to.
    pub(super) fn pointed(&self, from: &Entity<'_>, index: usize) -> ReadResult<&Entity<'t>> {
        let pointer = from.whole(index)?;
        let found = usize::try_from(pointer.abs())
            .ok()
            .and_then(|id| self.get(id));
        found.ok_or_else(|| at(&from.place(), format!("there is no entity {pointer}")))
    }

    pub(super) fn get(&self, id: usize) -> Option<&Entity<'t>> {
        self.index.get(&id).and_then(|k| self.entities.get(*k))
    }
}

/// The columns of a line; short lines end in blanks, and what is no ASCII has none.
fn columns(line: &str, from: usize, to: usize) -> &str {
    line.get(from..to.min(line.len())).unwrap_or_default()
}

pub(super) fn parse(text: &str) -> ReadResult<File<'_>> {
    let mut global = String::new();
    let mut directory: Vec<(usize, &str)> = Vec::new();
    let mut parameters: Vec<&str> = Vec::new();
    let mut ended = false;
    for (line, content) in (1..).zip(text.lines()) {
        if content.trim().is_empty() {
            continue;
        }
        match columns(content, 72, 73) {
            "S" => {}
            "G" => global.push_str(&format!("{:<72}", columns(content, 0, 72))),
            "D" => directory.push((line, content)),
            "P" => parameters.push(columns(content, 0, 64)),
            "T" => ended = true,
            _ => {
                return Err(at_line(
                    line,
                    "no letter of a section (S, G, D, P, T) in column 73",
                ));
            }
        }
    }
    if !ended {
        return Err(at_line(
            text.lines().count().max(1),
            "the file ends in the middle: the terminate section is missing",
        ));
    }
    if directory.len() / 2 > MAX_ENTITIES {
        return Err(ReadError::TooMuch {
            place: FilePlace::default(),
            what: "entities",
            most: MAX_ENTITIES,
        });
    }
    let global = global_parameters(&global)?;
    let delimiter = |k: usize, usual: char| {
        global
            .get(k)
            .and_then(|text| text.chars().next())
            .unwrap_or(usual)
    };
    let delimiters = [delimiter(0, ','), delimiter(1, ';')];
    let mut file = File {
        global,
        entities: Vec::new(),
        index: HashMap::new(),
    };
    for (k, pair) in directory.chunks(2).enumerate() {
        let [(line, first), (_, second)] = pair else {
            return Err(at_line(
                pair[0].0,
                "an entry of the directory has two lines",
            ));
        };
        let field = |content: &'_ str, k: usize| -> ReadResult<i64> {
            let text = columns(content, 8 * k, 8 * k + 8).trim();
            if text.is_empty() {
                return Ok(0);
            }
            text.parse()
                .map_err(|_| at_line(*line, format!("`{text}` is no number of the directory")))
        };
        let (start, count) = (field(first, 1)?, field(second, 3)?);
        let start = usize::try_from(start - 1)
            .map_err(|_| at_line(*line, "an entity without parameters"))?;
        let count = usize::try_from(count.max(1)).unwrap_or(1);
        let lines = start
            .checked_add(count)
            .and_then(|end| parameters.get(start..end));
        let lines = lines
            .ok_or_else(|| at_line(*line, "the parameters of this entity are not in the file"))?;
        let status = format!("{:0>8}", columns(first, 64, 72).trim());
        let mut values = split(&lines.concat(), delimiters, *line)?;
        if values.is_empty() {
            return Err(at_line(*line, "an entity without parameters"));
        }
        // The kind comes first in the parameters as well.
        values.remove(0);
        let id = 2 * k + 1;
        file.index.insert(id, file.entities.len());
        file.entities.push(Entity {
            id,
            line: *line,
            kind: field(first, 0)?,
            form: field(second, 4)?,
            matrix: usize::try_from(field(first, 6)?.max(0)).unwrap_or(0),
            hidden: columns(&status, 0, 2) == "01",
            dependent: matches!(columns(&status, 2, 4), "01" | "03")
                || columns(&status, 4, 6) == "05",
            label: columns(second, 56, 64).trim(),
            values,
        });
    }
    Ok(file)
}

/// The global parameters; the first two are the delimiters themselves, and may be left out.
fn global_parameters(text: &str) -> ReadResult<Vec<String>> {
    let start = text.trim_start();
    let mut chars = start.chars();
    let parameter = match (chars.next(), chars.next(), chars.next()) {
        (Some('1'), Some('H'), Some(c)) => c,
        _ => ',',
    };
    let rest = start.strip_prefix("1H").map_or(start, |rest| {
        rest.get(parameter.len_utf8()..).unwrap_or_default()
    });
    let rest = rest.strip_prefix(parameter).unwrap_or(rest);
    let named = rest.strip_prefix("1H").and_then(|rest| rest.chars().next());
    let record = named.unwrap_or(';');
    split(text, [parameter, record], 1)
}

/// Values between delimiters; `4Habcd` is the text `abcd`, whatever is in it.
fn split(text: &str, [parameter, record]: [char; 2], line: usize) -> ReadResult<Vec<String>> {
    let mut values = Vec::new();
    let mut rest = text;
    loop {
        rest = rest.trim_start_matches(' ');
        let digits = rest.len() - rest.trim_start_matches(|c: char| c.is_ascii_digit()).len();
        let number = rest.get(..digits).unwrap_or_default();
        let after = rest.get(digits..).unwrap_or_default();
        if let (Some(tail), Ok(length)) = (after.strip_prefix('H'), number.parse::<usize>()) {
            let end = tail
                .char_indices()
                .nth(length)
                .map_or(tail.len(), |(at, _)| at);
            values.push(tail.get(..end).unwrap_or_default().to_owned());
            rest = tail.get(end..).unwrap_or_default().trim_start_matches(' ');
            match rest.chars().next() {
                Some(c) if c == parameter => rest = rest.get(c.len_utf8()..).unwrap_or_default(),
                Some(c) if c == record => return Ok(values),
                None => return Ok(values),
                Some(_) => return Err(at_line(line, "a text of another length than it says")),
            }
            continue;
        }
        let Some(end) = rest.find([parameter, record]) else {
            return Err(at_line(line, "parameters without an end"));
        };
        let value: String = rest
            .get(..end)
            .unwrap_or_default()
            .chars()
            .filter(|c| *c != ' ')
            .collect();
        values.push(value);
        let tail = rest.get(end..).unwrap_or_default();
        if tail.starts_with(record) {
            return Ok(values);
        }
        rest = tail.get(parameter.len_utf8()..).unwrap_or_default();
    }
}
