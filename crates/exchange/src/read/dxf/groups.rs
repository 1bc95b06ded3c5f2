//! The text of a DXF file: pairs of lines, a group code and a value.

use crate::read::decimal::{decimal, double};
use crate::read::error::{FilePlace, ReadError, ReadResult, at, at_line};
use torse_algebra::Rational;

/// The most groups of a file.
const MAX_GROUPS: usize = 40_000_000;

/// A group: what the value means, the value, and its line.
#[derive(Debug, Clone, Copy)]
pub(super) struct Group<'t> {
    pub code: i32,
    pub value: &'t str,
    pub line: usize,
}

/// All groups but comments.
pub(super) fn groups(text: &str) -> ReadResult<Vec<Group<'_>>> {
    let mut groups = Vec::new();
    let mut lines = (1..).zip(text.lines());
    while let Some((line, code)) = lines.next() {
        if code.trim().is_empty() && lines.clone().all(|(_, rest)| rest.trim().is_empty()) {
            break;
        }
        let Ok(code) = code.trim().parse::<i32>() else {
            let shown: String = code.trim().chars().take(40).collect();
            return Err(at_line(line, format!("`{shown}` is no group code")));
        };
        let Some((line, value)) = lines.next() else {
            return Err(at_line(
                line,
                "a group code without a value: the file ends in the middle",
            ));
        };
        if code == 999 {
            continue;
        }
        if groups.len() >= MAX_GROUPS {
            return Err(ReadError::TooMuch {
                place: FilePlace::line(line),
                what: "groups",
                most: MAX_GROUPS,
            });
        }
        let value = value.trim();
        groups.push(Group { code, value, line });
    }
    Ok(groups)
}

/// An entity: its kind and the groups after it.
#[derive(Debug, Clone, Copy)]
pub(super) struct Entity<'t, 'g> {
    pub kind: &'t str,
    pub line: usize,
    pub groups: &'g [Group<'t>],
}

impl<'t> Entity<'t, '_> {
    /// The first value of a code.
    pub(super) fn text(&self, code: i32) -> Option<&'t str> {
        self.groups
            .iter()
            .find(|group| group.code == code)
            .map(|group| group.value)
    }

    pub(super) fn layer(&self) -> &'t str {
        self.text(8).unwrap_or("0")
    }

    /// Where it stands: the line of its kind, with its handle.
    pub(super) fn place(&self) -> FilePlace {
        let kind: String = self.kind.chars().take(30).collect();
        FilePlace::entity(
            self.line,
            match self.text(5) {
                Some(handle) => format!("{kind} {}", handle.chars().take(20).collect::<String>()),
                None => kind,
            },
        )
    }

    /// A whole number; this one where it is not given.
    pub(super) fn whole(&self, code: i32, usual: i64) -> ReadResult<i64> {
        let Some(group) = self.groups.iter().find(|group| group.code == code) else {
            return Ok(usual);
        };
        let number = group.value.parse::<i64>().ok();
        number.ok_or_else(|| self.wrong(group, "no whole number"))
    }

    /// A number rounded to f64; this one where it is not given.
    pub(super) fn number(&self, code: i32, usual: f64) -> ReadResult<f64> {
        let Some(group) = self.groups.iter().find(|group| group.code == code) else {
            return Ok(usual);
        };
        double(group.value).ok_or_else(|| self.wrong(group, "no finite number"))
    }

    /// All numbers of a code, exactly.
    pub(super) fn exacts(&self, code: i32) -> ReadResult<Vec<Rational>> {
        let all = self.groups.iter().filter(|group| group.code == code);
        all.map(|group| decimal(group.value).ok_or_else(|| self.wrong(group, "no finite number")))
            .collect()
    }

    /// The points whose x has this code, y the code plus ten and z, or zero, that plus twenty; each with its line.
    pub(super) fn points(&self, code: i32) -> ReadResult<Vec<[Rational; 3]>> {
        let mut points: Vec<[Rational; 3]> = Vec::new();
        for group in self.groups {
            let axis = match group.code - code {
                0 => 0,
                10 => 1,
                20 => 2,
                _ => continue,
            };
            let value =
                decimal(group.value).ok_or_else(|| self.wrong(group, "no finite number"))?;
            if axis == 0 {
                points.push(std::array::from_fn(|_| Rational::default()));
            }
            if let Some(point) = points.last_mut() {
                point[axis] = value;
            }
        }
        Ok(points)
    }

    /// The first point of a code.
    pub(super) fn point(&self, code: i32) -> ReadResult<[Rational; 3]> {
        let first = self.points(code)?.into_iter().next();
        first.ok_or_else(|| {
            at(
                &self.place(),
                format!("a {} without its point (group {code})", self.kind),
            )
        })
    }

    fn wrong(&self, group: &Group<'_>, what: &str) -> ReadError {
        let place = FilePlace {
            line: Some(group.line),
            ..self.place()
        };
        let shown: String = group.value.chars().take(40).collect();
        at(&place, format!("`{shown}` is {what}"))
    }
}
