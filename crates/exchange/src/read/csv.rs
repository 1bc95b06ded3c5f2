//! Tables of points, and of offsets.
//!
//! A table has a head, or two or three columns of numbers. In the head `x`, `y`, `z` name coordinates, `chine x` or
//! `chine.x` the coordinate of one of several curves, whose other coordinates may be common ones: that is a table of
//! offsets. A column `curve` (or `name`, `rail`, `line`) says which curve a row belongs to. Other columns are passed over,
//! but not in the place of a coordinate that is missing. A coordinate that no curve has is zero; one that some have, all have.
//! A unit stands in brackets after a name, `x [in]`, or in a comment before the head, `# unit: in`. A curve is left out of a
//! row in which all its own cells are empty; where only some are, the table is refused, as for a row that is longer than the
//! head. Cells are separated by comma, semicolon or tab; with the latter two a comma in a number is
//! its point.

use super::decimal::decimal;
use super::error::{ReadError, ReadResult, at_line};
use super::imported::{Imported, PassedOver};
use super::kind::separator;
use super::{CurveShape, Drafts, FileKind, FilePlace, LengthUnit, UnitSource, check_unit};
use torse_algebra::Rational;

/// The most rows of a table.
const MAX_ROWS: usize = 1_000_000;

/// A column that matters.
struct Column {
    /// The curve; none of a common coordinate.
    curve: Option<String>,
    axis: usize,
    /// Millimetres of its unit, if it has one of its own.
    unit: Option<LengthUnit>,
}

struct Head {
    columns: Vec<Option<Column>>,
    /// The column that names the curve of a row.
    group: Option<usize>,
}

pub(super) fn read(name: &str, text: &str, given: Option<&LengthUnit>) -> ReadResult<Imported> {
    let mut rows: Vec<(usize, Vec<String>)> = Vec::new();
    let mut stated = None;
    for (line, comment) in (1..).zip(text.lines()).take(1000) {
        let Some(comment) = comment.trim().strip_prefix('#') else {
            continue;
        };
        let Some((word, unit)) = comment.split_once([':', '=']) else {
            continue;
        };
        if matches!(word.trim().to_ascii_lowercase().as_str(), "unit" | "units") {
            let known = LengthUnit::named(unit);
            let unknown = || at_line(line, format!("`{}` is no unit of length", unit.trim()));
            stated = Some(known.ok_or_else(unknown)?);
        }
    }
    let first = text
        .lines()
        .find(|l| !l.trim().is_empty() && !l.trim_start().starts_with('#'));
    let delimiter = first.and_then(separator).unwrap_or(',');
    let mut reader = ::csv::ReaderBuilder::new()
        .delimiter(u8::try_from(delimiter).unwrap_or(b','))
        .comment(Some(b'#'))
        .has_headers(false)
        .flexible(true)
        .trim(::csv::Trim::All)
        .from_reader(text.as_bytes());
    for record in reader.records() {
        let record = record.map_err(|error| {
            let line = error
                .position()
                .map_or(1, |p| usize::try_from(p.line()).unwrap_or(1));
            at_line(line, "a row that is no text")
        })?;
        let line = record
            .position()
            .map_or(1, |p| usize::try_from(p.line()).unwrap_or(1));
        if record.iter().all(str::is_empty) {
            continue;
        }
        if rows.len() >= MAX_ROWS {
            return Err(ReadError::TooMuch {
                place: FilePlace::line(line),
                what: "rows",
                most: MAX_ROWS,
            });
        }
        rows.push((line, record.iter().map(str::to_owned).collect()));
    }
    let mut passed = PassedOver::default();
    let (head, rows) = head(&rows, delimiter, &mut passed)?;
    let own = head
        .columns
        .iter()
        .flatten()
        .find_map(|column| column.unit.clone());
    let unit = check_unit(stated.or(own), given)?;
    let mut drafts = Drafts::new(&unit);
    for (curve, place, points) in curves(name, &head, rows, delimiter, &unit)? {
        if points.len() < 2 {
            passed.add("single point");
            continue;
        }
        drafts.curve(&curve, place, CurveShape::Through(points))?;
    }
    drafts.finish(FileKind::Csv, None, passed)
}

type Rows<'r> = &'r [(usize, Vec<String>)];

/// What the columns are, and the rows after the head.
fn head<'r>(
    rows: Rows<'r>,
    delimiter: char,
    passed: &mut PassedOver,
) -> ReadResult<(Head, Rows<'r>)> {
    let Some(((line, cells), rest)) = rows.split_first() else {
        return Err(ReadError::Nothing {
            passed_over: String::new(),
        });
    };
    if cells.iter().all(|cell| number(cell, delimiter).is_some()) {
        if !(2..=3).contains(&cells.len()) {
            let reason = format!(
                "{} columns without a head: two or three are coordinates, more need names (`x`, `y`, `z`)",
                cells.len()
            );
            return Err(at_line(*line, reason));
        }
        let column = |axis| {
            Some(Column {
                curve: None,
                axis,
                unit: None,
            })
        };
        let columns = (0..cells.len()).map(column).collect();
        return Ok((
            Head {
                columns,
                group: None,
            },
            rows,
        ));
    }
    let mut head = Head {
        columns: Vec::new(),
        group: None,
    };
    for (index, cell) in cells.iter().enumerate() {
        let (title, unit) = bracketed(cell, *line)?;
        let lower = title.to_ascii_lowercase();
        let (curve, last) = match lower.rsplit_once([' ', '.', '_', '-']) {
            Some((_, last)) => (title.get(..title.len() - last.len() - 1), last),
            None => (None, lower.as_str()),
        };
        let axis = ["x", "y", "z"].iter().position(|axis| *axis == last);
        let column = axis.map(|axis| Column {
            curve: curve.map(|c| c.trim().to_owned()),
            axis,
            unit,
        });
        if column.is_none() {
            match lower.as_str() {
                "curve" | "name" | "rail" | "line" if head.group.is_none() => {
                    head.group = Some(index)
                }
                _ => passed.add(&format!("column `{title}`")),
            }
        }
        head.columns.push(column);
    }
    if head.columns.iter().all(Option::is_none) {
        return Err(at_line(*line, "no column is called `x`, `y` or `z`"));
    }
    check_axes(&head, cells, rest, delimiter, *line)?;
    for (index, column) in head.columns.iter().enumerate() {
        let same = |other: &Option<Column>| matches!((column, other), (Some(a), Some(b)) if a.curve == b.curve && a.axis == b.axis);
        if head.columns.iter().take(index).any(same) {
            let title = cells.get(index).cloned().unwrap_or_default();
            return Err(at_line(*line, format!("two columns for `{title}`")));
        }
    }
    Ok((head, rest))
}

/// Whether every curve has the coordinates that the others have, and no other column of numbers stands for one that is
/// missing.
fn check_axes(
    head: &Head,
    titles: &[String],
    rows: Rows<'_>,
    delimiter: char,
    line: usize,
) -> ReadResult<()> {
    let columns = || head.columns.iter().flatten();
    let has = |curve: Option<&str>, axis: usize| {
        columns().any(|c| c.axis == axis && (c.curve.is_none() || c.curve.as_deref() == curve))
    };
    for (axis, name) in ["x", "y", "z"].into_iter().enumerate() {
        let mut curves = columns().filter_map(|c| c.curve.as_deref());
        let lacking = curves.find(|curve| !has(Some(*curve), axis));
        if let Some(curve) = lacking
            && columns().any(|c| c.axis == axis)
        {
            return Err(at_line(
                line,
                format!("no column is called `{curve} {name}`, and other curves have their {name}"),
            ));
        }
        if name == "z" || columns().any(|c| c.axis == axis) {
            continue;
        }
        // A station, say, may be meant for it.
        for (index, title) in titles.iter().enumerate() {
            let other =
                head.columns.get(index).is_some_and(Option::is_none) && head.group != Some(index);
            let mut cells = rows.iter().filter_map(|(_, cells)| cells.get(index));
            if other && !rows.is_empty() && cells.all(|cell| number(cell, delimiter).is_some()) {
                return Err(at_line(
                    line,
                    format!(
                        "no column is called `{name}`, and column {} has numbers: if `{title}` is that coordinate, call it `{name}`",
                        index + 1
                    ),
                ));
            }
        }
    }
    Ok(())
}

/// A title without the unit in brackets after it.
fn bracketed(cell: &str, line: usize) -> ReadResult<(String, Option<LengthUnit>)> {
    let cell = cell.trim();
    let inside = cell.strip_suffix(']').and_then(|c| c.rsplit_once('['));
    let inside = inside.or_else(|| cell.strip_suffix(')').and_then(|c| c.rsplit_once('(')));
    let Some((title, unit)) = inside else {
        return Ok((cell.to_owned(), None));
    };
    let known = LengthUnit::named(unit);
    let unknown = || at_line(line, format!("`{}` is no unit of length", unit.trim()));
    Ok((title.trim().to_owned(), Some(known.ok_or_else(unknown)?)))
}

fn number(cell: &str, delimiter: char) -> Option<Rational> {
    if delimiter == ',' {
        return decimal(cell);
    }
    decimal(&cell.replace(',', "."))
}

type Points = Vec<(String, FilePlace, Vec<[Rational; 3]>)>;

/// The points of each curve, in the order of the table, in millimetres.
fn curves(
    name: &str,
    head: &Head,
    rows: Rows<'_>,
    delimiter: char,
    unit: &UnitSource,
) -> ReadResult<Points> {
    let mut names: Vec<&str> = Vec::new();
    for column in head.columns.iter().flatten() {
        if let Some(curve) = &column.curve
            && !names.contains(&curve.as_str())
        {
            names.push(curve);
        }
    }
    let whole = names.is_empty();
    let factor = unit.unit().millimetres().clone();
    let mut all: Points = Vec::new();
    let mut index = std::collections::HashMap::new();
    for (line, cells) in rows {
        if cells
            .iter()
            .skip(head.columns.len())
            .any(|cell| !cell.is_empty())
        {
            let (long, wide) = (cells.len(), head.columns.len());
            return Err(at_line(
                *line,
                format!(
                    "{long} cells, column {} among them, where the table has {wide} columns",
                    wide + 1
                ),
            ));
        }
        let group = head.group.and_then(|k| cells.get(k)).map(String::as_str);
        for curve in if whole { vec![""] } else { names.clone() } {
            let mut point: [Rational; 3] = std::array::from_fn(|_| Rational::default());
            // The columns that are empty, and whether one of the curve's own is not.
            let (mut missing, mut given) = (None, false);
            for ((index, column), cell) in head
                .columns
                .iter()
                .enumerate()
                .zip(cells.iter().map(Some).chain(std::iter::repeat(None)))
            {
                let Some(column) = column else { continue };
                if column.curve.as_deref().is_some_and(|own| own != curve) {
                    continue;
                }
                let text = cell.map_or("", |cell| cell.trim());
                let own = whole || column.curve.is_some();
                if text.is_empty() {
                    missing = missing.or(Some((index, column)));
                    continue;
                }
                given |= own;
                let Some(value) = number(text, delimiter) else {
                    let shown: String = text.chars().take(40).collect();
                    return Err(at_line(*line, format!("`{shown}` is no finite number")));
                };
                let factor = column
                    .unit
                    .as_ref()
                    .map_or(&factor, LengthUnit::millimetres);
                // The curve's own coordinate stands for the common one.
                let own = head.columns.iter().flatten().any(|other| {
                    other.axis == column.axis && other.curve.as_deref() == Some(curve)
                });
                if column.curve.is_some() || !own {
                    point[column.axis] = value * factor.clone();
                }
            }
            match missing {
                Some((index, column)) if given => {
                    let axis = ["x", "y", "z"]
                        .get(column.axis)
                        .copied()
                        .unwrap_or_default();
                    let owner = match (&column.curve, curve) {
                        (None, "") => String::new(),
                        (_, curve) => format!(" of `{curve}`"),
                    };
                    let reason = format!(
                        "column {} is empty: the {axis} of a point{owner} is missing",
                        index + 1
                    );
                    return Err(at_line(*line, reason));
                }
                Some(_) => continue,
                None => {}
            }
            let title = match (group, curve) {
                (Some(group), "") if !group.is_empty() => group.to_owned(),
                (Some(group), curve) if !group.is_empty() => format!("{group} {curve}"),
                (_, "") => name.to_owned(),
                (_, curve) => curve.to_owned(),
            };
            let slot = *index.entry(title.clone()).or_insert_with(|| {
                all.push((
                    title.clone(),
                    FilePlace::entity(*line, format!("curve `{title}`")),
                    Vec::new(),
                ));
                all.len() - 1
            });
            if let Some((_, _, points)) = all.get_mut(slot) {
                points.push(point);
            }
        }
    }
    Ok(all)
}
