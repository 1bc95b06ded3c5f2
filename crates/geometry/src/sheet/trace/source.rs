//! What a curve on sheets comes from: rulings of another sheet that pierce them, or a rail that lies on them.

use super::super::{Point, Rail, Sheet};
use super::search::{Hit, meetings, nearest};
use super::{PiercingReach, SheetTracer, TraceError, Traced};
use crate::chebyshev::Row;
use crate::coordinate::Coordinate;
use crate::curve::SpaceCurve;
use crate::model::ChebyshevModel;
use crate::over::Over;
use crate::surface::Rails;
use crate::vector::{add, cross, dot, lerp, norm, scale, sub};

type Model = ChebyshevModel;

/// Newton's steps.
const STEPS: usize = 40;
/// Steps of the parameters below this are rounding.
const STILL: f64 = 1e-13;
/// The least half width of the box in which a solution is proved.
const LEAST_ROOM: f64 = 1e-15;

/// A family of equations for the place `u, v` on a sheet, with a third unknown, one for each parameter in [0, 1].
pub trait TracedSource {
    /// Returns a point that tells people where the parameter is.
    fn anchor(&self, y: f64) -> Traced<Point>;

    /// Returns the solution near another one.
    fn solved(&self, sheet: &Sheet, y: f64, near: [f64; 3]) -> Option<[f64; 3]>;

    /// Refuses a solution that does not count.
    fn check(&self, sheet: &Sheet, y: f64, at: [f64; 3]) -> Traced<()>;

    /// Refuses a place at which the curves are not those that were found at the start.
    fn confirmed(&self, tracer: &SheetTracer<'_>, y: f64, hit: Hit) -> Traced<()>;

    /// Returns a bound for the distance in space of the exact solutions from those through these values at the nodes of a
    /// range, if it is proved that there is one for each parameter.
    fn proved(&self, sheet: &Sheet<Model>, range: [f64; 2], nodes: &[Row; 3]) -> Option<f64>;
}

/// The rulings of a sheet, which pierce others.
pub struct Piercing<'a> {
    lines: &'a Sheet,
    models: Sheet<Model>,
    reach: PiercingReach,
    joined: f64,
    /// How often each ruling pierces the sheets.
    count: usize,
}

impl<'a> Piercing<'a> {
    pub fn new(lines: &'a Sheet, reach: PiercingReach, joined: f64) -> Traced<Self> {
        Ok(Self {
            lines,
            models: lines.over(&|x| Model::exact(*x))?,
            reach,
            joined,
            count: 0,
        })
    }

    /// Returns the same rulings, each of which pierces the sheets so often.
    pub fn counted(self, count: usize) -> Self {
        Self { count, ..self }
    }

    /// Returns the first end of a ruling.
    pub fn start(&self, y: f64) -> Traced<Point> {
        Ok(self.line(y)?.0)
    }

    fn line(&self, y: f64) -> Traced<(Point, Point)> {
        let [p, q] = self.lines.ruling_ends(&y)?;
        Ok((p, sub(&q, &p)))
    }

    fn reaches(&self, w: f64, way: &Point) -> bool {
        let slack = self.joined / norm(way);
        w >= -slack && (self.reach == PiercingReach::First || w <= 1.0 + slack)
    }

    /// Returns the places at which a ruling pierces the sheets, in its order.
    pub fn hits(&self, tracer: &SheetTracer<'_>, y: f64) -> Traced<Vec<Hit>> {
        let (from, way) = self.line(y)?;
        let on_line = |w: f64| add(&from, &scale(&w, &way));
        let mut found: Vec<Hit> = Vec::new();
        let (mut beyond, mut beside) = (None, None);
        for (sheet, patch) in tracer.sheets.iter().enumerate() {
            for at in meetings(patch, &from, &way) {
                let [_, v, w] = at;
                let slack = 1e-9;
                if !(-slack..=1.0 + slack).contains(&v) {
                    if self.reaches(w, &way) {
                        beside = Some(on_line(w));
                    }
                } else if !self.reaches(w, &way) {
                    beyond = Some(on_line(w));
                } else if found
                    .iter()
                    .all(|known| (known.at[2] - w).abs() * norm(&way) > self.joined)
                {
                    found.push(Hit { sheet, at });
                }
            }
        }
        found.sort_by(|a, b| a.at[2].total_cmp(&b.at[2]));
        if self.reach == PiercingReach::First {
            found.truncate(1);
        }
        match (found.is_empty(), beside, beyond) {
            (false, ..) => Ok(found),
            (true, Some(at), _) => Err(TraceError::Leaves { at }),
            (true, None, Some(at)) if self.reach == PiercingReach::Ruling => {
                Err(TraceError::TooShort { at })
            }
            _ => Err(TraceError::Misses { from }),
        }
    }
}

/// Returns the solution of `columns . x = right`.
fn solution(columns: &[Point; 3], right: &Point) -> Option<[f64; 3]> {
    let [a, b, c] = columns;
    let whole = dot(a, &cross(b, c));
    let all = [
        dot(right, &cross(b, c)) / whole,
        dot(right, &cross(c, a)) / whole,
        dot(right, &cross(a, b)) / whole,
    ];
    all.iter().all(|x| x.is_finite()).then_some(all)
}

/// Returns the point of a sheet, and its derivatives by `u` and `v`.
fn with_slopes<S: Coordinate>(
    sheet: &impl Rails<S>,
    u: &S,
    v: &S,
) -> Option<([S; 3], [S; 3], [S; 3])> {
    let [[p, dp], [q, dq]] = sheet.ends_and_slopes(u).ok()?;
    Some((lerp(&p, &q, v), lerp(&dp, &dq, v), sub(&q, &p)))
}

impl TracedSource for Piercing<'_> {
    fn anchor(&self, y: f64) -> Traced<Point> {
        self.start(y)
    }

    fn solved(&self, sheet: &Sheet, y: f64, near: [f64; 3]) -> Option<[f64; 3]> {
        let (from, way) = self.line(y).ok()?;
        let mut at = near;
        for _ in 0..STEPS {
            let (point, along, across) = with_slopes(sheet, &at[0], &at[1])?;
            let off = sub(&point, &add(&from, &scale(&at[2], &way)));
            let step = solution(&[along, across, way.map(|c| -c)], &off)?;
            at = [0, 1, 2].map(|i| at[i] - step[i]);
            if step.iter().all(|s| s.abs() < STILL) {
                return Some(at);
            }
            if step.iter().any(|s| s.abs() > 1.0) {
                return None;
            }
        }
        // It stays within rounding of the solution.
        let (point, ..) = with_slopes(sheet, &at[0], &at[1])?;
        let off = norm(&sub(&point, &add(&from, &scale(&at[2], &way))));
        (off <= 1e-9 * norm(&way)).then_some(at)
    }

    fn check(&self, _: &Sheet, y: f64, at: [f64; 3]) -> Traced<()> {
        let (from, way) = self.line(y)?;
        if self.reaches(at[2], &way) {
            return Ok(());
        }
        let at = add(&from, &scale(&at[2], &way));
        Err(TraceError::TooShort { at })
    }

    /// What is followed has to be among what is found again, and the first where the first alone counts: elsewhere another
    /// part of the sheets is in front of it.
    fn confirmed(&self, tracer: &SheetTracer<'_>, y: f64, hit: Hit) -> Traced<()> {
        let (from, way) = self.line(y)?;
        let found = self.hits(tracer, y)?;
        if found.len() != self.count {
            let counts = [self.count, found.len()];
            return Err(TraceError::Uneven { counts, at: from });
        }
        let is_same = |other: &Hit| (other.at[2] - hit.at[2]).abs() * norm(&way) <= self.joined;
        if found.iter().any(is_same) {
            return Ok(());
        }
        let nearest = found.first().map_or(hit.at[2], |first| first.at[2]);
        let at = add(&from, &scale(&nearest, &way));
        Err(TraceError::Hidden { at })
    }

    fn proved(&self, sheet: &Sheet<Model>, range: [f64; 2], nodes: &[Row; 3]) -> Option<f64> {
        let [u, v, w] = nodes.each_ref().map(Model::through);
        let [from, to] = self
            .models
            .ruling_ends(&Model::identity(range[0], range[1]))
            .ok()?;
        let way = sub(&to, &from);
        let (point, along, across) = with_slopes(sheet, &u, &v)?;
        let off = sub(&point, &add(&from, &scale(&w, &way)));
        let columns =
            [along, across, way.map(|c| -c)].map(|column| column.map(|c| c.approximate()));
        let mut inverse = [[0.0; 3]; 3];
        for k in 0..3 {
            let mut unit = [0.0; 3];
            unit[k] = 1.0;
            let column = solution(&columns, &unit)?;
            for (row, value) in inverse.iter_mut().zip(column) {
                row[k] = value;
            }
        }
        let rows = inverse.map(|row| row.map(Model::exact));
        let missed = rows.each_ref().map(|row| dot(row, &off).largest());
        let mut room = missed.map(|m| 4.0 * m + LEAST_ROOM);
        for _ in 0..2 {
            let (wide_u, wide_v) = (u.widened(room[0]), v.widened(room[1]));
            let (_, along, across) = with_slopes(sheet, &wide_u, &wide_v)?;
            let over = [along, across, way.map(|c| -c)];
            // The image of the box, in which the solutions lie if it is within the box.
            let reach: [f64; 3] = std::array::from_fn(|i| {
                let sum = (0..3).fold(missed[i], |sum, j| {
                    let unit = Model::exact(if i == j { 1.0 } else { 0.0 });
                    sum + (unit - dot(&rows[i], &over[j])).largest() * room[j]
                });
                sum * (1.0 + 1e-12)
            });
            if (0..3).all(|i| reach[i] < room[i]) {
                // By the mean value theorem on the box.
                return Some(
                    (length(&along) * reach[0] + length(&across) * reach[1]) * (1.0 + 1e-12),
                );
            }
            let most = missed.into_iter().fold(0.0, f64::max);
            room = [16.0 * most + LEAST_ROOM; 3];
        }
        None
    }
}

/// Returns an upper bound of the length of a vector.
fn length(vector: &[Model; 3]) -> f64 {
    let squares = vector.each_ref().map(|c| c.largest().powi(2));
    squares.iter().sum::<f64>().sqrt() * (1.0 + 1e-12)
}

/// A rail that lies on sheets.
pub struct Lying<'a> {
    rail: &'a Rail,
    model: Rail<Model>,
    within: f64,
}

impl<'a> Lying<'a> {
    pub fn new(rail: &'a Rail, within: f64) -> Traced<Self> {
        Ok(Self {
            rail,
            model: rail.over(&|x| Model::exact(*x))?,
            within,
        })
    }

    /// Returns the place of the sheets nearest to a point of the rail.
    ///
    /// # Errors
    /// [`TraceError::NotOnSheet`] where it is farther than is allowed.
    pub fn nearest(&self, tracer: &SheetTracer<'_>, y: f64) -> Traced<Hit> {
        let at = self.rail.point(y)?;
        let all = tracer.sheets.iter().enumerate();
        let best = all
            .filter_map(|(sheet, patch)| Some((sheet, nearest(patch, &at)?)))
            .min_by(|a, b| a.1.1.total_cmp(&b.1.1));
        match best {
            Some((sheet, ([u, v], distance))) if distance <= self.within => Ok(Hit {
                sheet,
                at: [u, v, 0.0],
            }),
            Some((_, (_, distance))) => Err(TraceError::NotOnSheet { at, distance }),
            None => Err(TraceError::Misses { from: at }),
        }
    }
}

impl TracedSource for Lying<'_> {
    fn anchor(&self, y: f64) -> Traced<Point> {
        Ok(self.rail.point(y)?)
    }

    fn solved(&self, sheet: &Sheet, y: f64, near: [f64; 3]) -> Option<[f64; 3]> {
        let wanted = self.rail.point(y).ok()?;
        let [mut u, mut v, _] = near;
        for _ in 0..STEPS {
            let (point, along, across) = with_slopes(sheet, &u, &v)?;
            let normal = cross(&along, &across);
            // The third unknown takes what is off along the normal.
            let step = solution(&[along, across, normal], &sub(&point, &wanted))?;
            (u, v) = (u - step[0], v - step[1]);
            if step[0].abs() + step[1].abs() < STILL {
                break;
            }
            if step[0].abs().max(step[1].abs()) > 1.0 {
                return None;
            }
        }
        (u.is_finite() && v.is_finite()).then_some([u, v, 0.0])
    }

    fn check(&self, sheet: &Sheet, y: f64, [u, v, _]: [f64; 3]) -> Traced<()> {
        let at = self.rail.point(y)?;
        let distance = norm(&sub(&at, &sheet.point(u, v)?));
        if distance <= self.within {
            return Ok(());
        }
        Err(TraceError::NotOnSheet { at, distance })
    }

    fn confirmed(&self, _: &SheetTracer<'_>, _: f64, _: Hit) -> Traced<()> {
        Ok(())
    }

    fn proved(&self, sheet: &Sheet<Model>, range: [f64; 2], nodes: &[Row; 3]) -> Option<f64> {
        let [u, v, _] = nodes.each_ref().map(Model::through);
        let wanted = self
            .model
            .space_point(&Model::identity(range[0], range[1]))
            .ok()?;
        let [p, q] = sheet.ruling_ends(&u).ok()?;
        let off = length(&sub(&lerp(&p, &q, &v), &wanted));
        (off <= 2.0 * self.within).then_some(off)
    }
}
