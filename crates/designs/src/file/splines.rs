//! Splines, by their control points or through points, and polygons with corners.

use super::keys;
use super::points::{exact_list, point, vector};
use super::reader::{Entries, Named, NumberKind, Reader, Value, accepted};
use std::ops::Range;
use toml::de::DeValue;
use torse_geometry::curve::{
    EndCondition, Interpolation, MAX_SPLINE_POINTS, Spacing, Spline, interpolate,
    interpolate_closed,
};
use torse_geometry::prelude::{PiecewiseRail, Point};
use torse_numbers::rational::{Rational, integer};

fn plain_points(
    reader: &mut Reader,
    value: Value<'_>,
    known: &Named<Point>,
    least: usize,
) -> Option<Vec<Point>> {
    let items = reader.list(value, "points", [least, MAX_SPLINE_POINTS])?;
    let points: Vec<Option<Point>> = items
        .into_iter()
        .map(|item| point(reader, item, known))
        .collect();
    points.into_iter().collect()
}

fn numbers(reader: &mut Reader, value: Value<'_>, what: &str) -> Option<Vec<Rational>> {
    let items = reader.list(value, what, [2, MAX_SPLINE_POINTS + 128])?;
    let all: Vec<_> = items
        .into_iter()
        .map(|item| reader.rational(item, NumberKind::None))
        .collect();
    all.into_iter().collect()
}

/// `spline = { degree, points, knots, weights, closed }`.
pub fn spline(
    reader: &mut Reader,
    value: Value<'_>,
    points: &Named<Point>,
) -> Option<PiecewiseRail> {
    let mut entries = reader.entries(value, "a spline", keys::SPLINE)?;
    let span = entries.span.clone();
    let degree = match entries.take("degree") {
        None => Some(3.0),
        Some(value) => reader.number_in(value, NumberKind::None, "{1, 2, .. 64}", |d| {
            d.fract() == 0.0 && (1.0..=64.0).contains(&d)
        }),
    };
    let closed = entries
        .take("closed")
        .map_or(Some(false), |value| reader.truth(value));
    let Some(control) = entries.take("points") else {
        reader.complain(
            &span,
            "a spline lacks its `points`",
            "`spline = { degree = 3, points = [..], knots = [..] }`",
        );
        return None;
    };
    let control = exact_list(reader, control, points, [2, MAX_SPLINE_POINTS]);
    let knots = entries
        .take("knots")
        .map(|value| numbers(reader, value, "knots"));
    let weights = entries
        .take("weights")
        .map(|value| numbers(reader, value, "weights"));
    #[allow(
        clippy::cast_possible_truncation,
        clippy::cast_sign_loss,
        reason = "between 1 and 64"
    )]
    let degree = degree? as usize;
    let (closed, control) = (closed?, control?);
    let weights = match weights {
        Some(weights) => Some(weights?),
        None => None,
    };
    let knots = match knots {
        Some(knots) => knots?,
        None => uniform(degree, control.len(), closed),
    };
    let made = if closed {
        Spline::periodic(degree, &knots, control, weights)
    } else {
        Spline::new(degree, knots, control, weights)
    };
    accepted(
        reader,
        &span,
        made.and_then(|spline| PiecewiseRail::spline(&spline)),
    )
}

/// Knots one apart: of an open spline with full ends.
fn uniform(degree: usize, points: usize, closed: bool) -> Vec<Rational> {
    let number = |k: usize| integer(i64::try_from(k).unwrap_or(i64::MAX));
    if closed {
        return (0..=points).map(number).collect();
    }
    let last = points.max(degree);
    (0..=points + degree)
        .map(|k| number(k.clamp(degree, last) - degree))
        .collect()
}

/// `through = [..]` with `ends` and `spacing`.
pub fn through(
    reader: &mut Reader,
    entries: &mut Entries<'_>,
    value: Value<'_>,
    points: &Named<Point>,
) -> Option<PiecewiseRail> {
    let place = value.span();
    let through = plain_points(reader, value, points, 2);
    let how = InterpolationConditions::read(reader, entries, points);
    how?.interpolated(reader, &place, &through?)
}

/// How a spline goes through its points.
pub struct InterpolationConditions {
    spacing: Spacing,
    /// None of a closed spline.
    ends: Option<[EndCondition; 2]>,
}

/// What `ends` says in a word.
#[derive(Clone, Copy)]
enum EndWord {
    Natural,
    Closed,
}

impl InterpolationConditions {
    /// Returns the entries `ends` and `spacing`.
    pub fn read(
        reader: &mut Reader,
        entries: &mut Entries<'_>,
        points: &Named<Point>,
    ) -> Option<Self> {
        let spacing = entries
            .take("spacing")
            .map_or(Some(Spacing::Chord), |value| {
                reader.word(value, "spacing", &Spacing::ALL)
            });
        let ends = match entries.take("ends") {
            None => Some(Some([EndCondition::Natural; 2])),
            Some(value) if matches!(value.get_ref(), DeValue::Table(_)) => {
                let mut ends = reader.entries(value, "`ends`", keys::ENDS)?;
                let both = ["start", "end"].map(|key| match ends.take(key) {
                    None => Some(EndCondition::Natural),
                    Some(value) => vector(reader, value, points).map(EndCondition::Tangent),
                });
                match both {
                    [Some(start), Some(end)] => Some(Some([start, end])),
                    _ => None,
                }
            }
            Some(value) => {
                let words = [("natural", EndWord::Natural), ("closed", EndWord::Closed)];
                reader.word(value, "ends", &words).map(|word| match word {
                    EndWord::Natural => Some([EndCondition::Natural; 2]),
                    EndWord::Closed => None,
                })
            }
        };
        Some(Self {
            spacing: spacing?,
            ends: ends?,
        })
    }

    /// Returns the spline.
    pub fn interpolated(
        &self,
        reader: &mut Reader,
        place: &Range<usize>,
        points: &[Point],
    ) -> Option<PiecewiseRail> {
        let made = match self.ends {
            Some(ends) => interpolate(points, self.spacing, ends),
            None => {
                // The first point may be repeated at the end.
                let ring = match points.split_last() {
                    Some((last, rest)) if points.first() == Some(last) => rest,
                    _ => points,
                };
                interpolate_closed(ring, self.spacing)
            }
        };
        let Interpolation { spline, .. } = accepted(reader, place, made)?;
        accepted(reader, place, PiecewiseRail::spline(&spline))
    }
}

/// `polyline = [..]`: straight sides with corners between them.
pub fn polyline(
    reader: &mut Reader,
    value: Value<'_>,
    points: &Named<Point>,
) -> Option<PiecewiseRail> {
    let place = value.span();
    let corners = exact_list(reader, value, points, [2, MAX_SPLINE_POINTS])?;
    accepted(
        reader,
        &place,
        Spline::polyline(corners).and_then(|spline| PiecewiseRail::spline(&spline)),
    )
}
