//! Layers: their running variables, and their points.

use super::drawing::{Interval, Layer, Running};
use super::environment::{MAX_POINTS, complaint, fraction, wrong};
use super::loops::Round;
use super::panel::{Context, ends};
use super::reader::Reader;
use super::{Faulty, drawing};
use torse_algebra::{Fraction, Symbol};
use torse_prove::decide::interval::exact;
use torse_prove::evaluate::value::Value;
use torse_syntax::derivation::Written;
use torse_syntax::derivation::declarations::SymbolKind;
use torse_syntax::derivation::schema::Text;
use torse_syntax::derivation::schema::figure::{LayerEntry, Shape};

/// An index that runs through a range, both ends included.
pub(super) struct Index {
    name: String,
    low: i64,
    high: i64,
}

impl Context<'_> {
    pub(super) fn layer(
        &self,
        entry: &LayerEntry,
        round: &Round<'_>,
        reader: &Reader<'_>,
    ) -> Faulty<Layer> {
        let (mut indices, mut running) = (vec![], vec![]);
        for text in &entry.over {
            match range(reader, text)? {
                Over::Index(index) => indices.push(index),
                Over::Running(variable) => running.push(*variable),
            }
        }
        for (variable, samples) in running.iter_mut().zip(&entry.samples) {
            variable.samples = Some(*samples.get_ref());
        }
        let (lists, wanted) = match entry.draw.get_ref() {
            Shape::Curve => ((0, 1), "one variable runs along a curve"),
            Shape::Surface => ((0, 2), "two variables run along a surface"),
            Shape::Net => (
                (2, 0),
                "two indices run along a net, such as `over = [\"i in 0..3\", \"j in 0..3\"]`",
            ),
            Shape::Note | Shape::Plane => ((0, 0), "nothing runs along a note or a plane"),
            Shape::Polygon => (
                (indices.len().min(1), 0),
                "at most one index runs along a polygon",
            ),
            Shape::Region => (
                (indices.len().min(1), running.len().min(1)),
                "at most one variable runs around a region",
            ),
            Shape::Points | Shape::Segments | Shape::Arrows => (
                (indices.len().min(1), running.len().min(1)),
                "at most one variable runs along points, segments and arrows",
            ),
        };
        if (indices.len(), running.len()) != lists {
            let text = entry.over.first().unwrap_or(&entry.at);
            let message = format!("{} variables and indices: {wanted}", entry.over.len());
            return Err(Box::new(complaint(reader.source, text, message)));
        }
        let count: i64 = indices.iter().map(|i| i.high - i.low + 1).product();
        if count > MAX_POINTS {
            let message = format!("more than {MAX_POINTS} points");
            return Err(Box::new(complaint(reader.source, &entry.at, message)));
        }
        let formula = torse_syntax::derivation::parsed(reader.source, &entry.at)?;
        let names: Vec<&str> = running.iter().map(|r: &Running| r.name.as_str()).collect();
        let mut points = vec![];
        for assignment in assignments(&indices) {
            let values = assignment.into_iter().map(Fraction::integer);
            let named = indices.iter().map(|index| index.name.clone()).zip(values);
            let here = reader.fixing(&named.collect());
            points.extend(self.positions(&here, &entry.at, &formula, &names)?);
        }
        let shape = *entry.draw.get_ref();
        check_dimension(reader, entry, shape, &points)?;
        let shade = match &entry.shade {
            None => None,
            Some(text) => {
                let value = reader.number(text)?;
                self.check_symbols(reader, text, &value, &names)?;
                Some(value)
            }
        };
        Ok(Layer {
            shape,
            formula: entry.at.get_ref().clone(),
            points,
            columns: indices
                .get(1)
                .map_or(1, |j| usize::try_from(j.high - j.low + 1).unwrap_or(1)),
            running,
            shade,
            label: round.filled(&entry.label),
            text: round.filled(&entry.text),
            round: round.number,
            style: entry.style.clone(),
        })
    }

    /// Returns the points of a value: one for a vector, one for each row of a matrix.
    pub(super) fn positions(
        &self,
        reader: &Reader<'_>,
        text: &Text,
        formula: &Written,
        running: &[&str],
    ) -> Faulty<Vec<Vec<Fraction>>> {
        let value = reader.evaluated(formula)?;
        let rows = match &value {
            Value::Vector(v) if v.generic => {
                let message = "a generic vector where coordinates are needed";
                let error = complaint(reader.source, text, message);
                return Err(Box::new(error.with_help(
                    "give its points with `set`, for instance `set = { P = '[[0, 0], [1, 2]]' }`",
                )));
            }
            Value::Vector(v) => vec![v.entries.as_slice()],
            Value::Matrix(rows) => rows.iter().map(Vec::as_slice).collect(),
            other => {
                return Err(wrong(
                    reader.source,
                    text,
                    other.kind(),
                    "a point or a list of points",
                ));
            }
        };
        let mut points = vec![];
        for row in rows {
            let point = row
                .iter()
                .map(|q| fraction(reader.source, text, q))
                .collect::<Faulty<Vec<_>>>()?;
            for coordinate in &point {
                self.check_symbols(reader, text, coordinate, running)?;
            }
            points.push(point);
        }
        Ok(points)
    }

    /// Refuses symbols that are neither running variables nor sliders.
    fn check_symbols(
        &self,
        reader: &Reader<'_>,
        text: &Text,
        value: &Fraction,
        running: &[&str],
    ) -> Faulty<()> {
        let known = |symbol: &Symbol| match symbol {
            Symbol::Indexed(..) => false,
            _ => symbol.names().all(|name| {
                running.contains(&&**name) || self.free.iter().any(|free| **free == **name)
            }),
        };
        match value.symbols().iter().find(|symbol| !known(symbol)) {
            None => Ok(()),
            Some(symbol) => {
                let message = format!("`{symbol}` has no value here");
                let error = complaint(reader.source, text, message);
                Err(Box::new(error.with_help(
                    "let it run with `over`, or give it a value with `set`, `for` or `sliders`",
                )))
            }
        }
    }
}

/// Positions have two or three coordinates, those of some shapes just three; a plane has four.
fn check_dimension(
    reader: &Reader<'_>,
    entry: &LayerEntry,
    shape: Shape,
    points: &[Vec<Fraction>],
) -> Faulty<()> {
    let allowed: &[usize] = match shape {
        Shape::Plane => &[4],
        Shape::Surface | Shape::Net => &[3],
        Shape::Region => &[2],
        _ => &[2, 3],
    };
    let length = points.first().map_or(0, Vec::len);
    if !allowed.contains(&length) || points.iter().any(|p| p.len() != length) {
        let wanted: Vec<String> = allowed.iter().map(ToString::to_string).collect();
        let message = format!(
            "points of {length} coordinates where {} are needed",
            wanted.join(" or ")
        );
        return Err(Box::new(complaint(reader.source, &entry.at, message)));
    }
    let single = matches!(
        shape,
        Shape::Curve | Shape::Surface | Shape::Note | Shape::Plane
    );
    if single && points.len() != 1 {
        return Err(wrong(
            reader.source,
            &entry.at,
            "a list of points",
            "one point",
        ));
    }
    if matches!(shape, Shape::Segments | Shape::Arrows) && !points.len().is_multiple_of(2) {
        return Err(wrong(
            reader.source,
            &entry.at,
            "an odd number of points",
            "a list of pairs",
        ));
    }
    Ok(())
}

impl drawing::Layer {
    /// Returns the number of coordinates of the space it is drawn in.
    pub(super) fn dimension(&self) -> usize {
        match self.shape {
            Shape::Plane => 3,
            _ => self.points.first().map_or(2, Vec::len),
        }
    }
}

/// The meaning of a text of `over`.
pub(super) enum Over {
    Index(Index),
    Running(Box<Running>),
}

/// Parses `x`, `x in [0, 1/2]` or `i in 0..3`.
pub(super) fn range(reader: &Reader<'_>, text: &Text) -> Faulty<Over> {
    let source = reader.source;
    let (name, rest) = match text.get_ref().split_once(" in ") {
        Some((name, rest)) => (name.trim(), Some(rest)),
        None => (text.get_ref().trim(), None),
    };
    let kind = reader.declared(name, text)?;
    let unusable = || {
        Box::new(complaint(
            source,
            text,
            format!(
                "`{}` is no range: write `x`, `x in [0, 1]` or `i in 0..3`",
                text.get_ref()
            ),
        ))
    };
    match (kind, rest) {
        (SymbolKind::Real(_), Some(rest)) => {
            let range = ends(reader, text, &reader.part(text, rest)?)?;
            Ok(Over::Running(Box::new(Running {
                name: name.to_owned(),
                range,
                samples: None,
            })))
        }
        (SymbolKind::Real(declared), None) => match (&declared.lower, &declared.upper) {
            (Some(low), Some(high)) => Ok(Over::Running(Box::new(Running {
                name: name.to_owned(),
                range: Interval {
                    low: exact(&low.value),
                    high: exact(&high.value),
                },
                samples: None,
            }))),
            _ => Err(unusable()),
        },
        (SymbolKind::Integer { .. }, Some(rest)) => {
            let [low, high] = reader.integers(text, rest)?.ok_or_else(unusable)?;
            Ok(Over::Index(Index {
                name: name.to_owned(),
                low,
                high,
            }))
        }
        _ => Err(unusable()),
    }
}

/// Returns all combinations of indices, the last running fastest.
fn assignments(indices: &[Index]) -> Vec<Vec<i64>> {
    indices.iter().fold(vec![vec![]], |rows, index| {
        rows.iter()
            .flat_map(|row| {
                (index.low..=index.high)
                    .map(move |value| row.iter().copied().chain([value]).collect())
            })
            .collect()
    })
}
