//! Whether a patch passes through itself in space: found with both parameters, proved not to, or undecided.
//!
//! Two rulings near each other do not meet if the patch moves away from each of them: let `R(x)` be a ruling, `T` a
//! fixed vector and `m(x) = T (R.R) - R (R.T)`, which is orthogonal to `R(x)`. If `P'(y).m(x)` and `Q'(y).m(x)` are
//! positive for all `x, y` of an interval, then `(S(y, w) - P(x)).m(x)` grows with `y` from zero at `y = x`, and no
//! later ruling of the interval meets that of `x`.
//!
//! Two rulings far from each other do not meet if hulls of the strips about them do not: a strip lies within the hull
//! of four points, widened by what the rails differ from their chords. What is neither near nor apart is halved. Where
//! nothing is left to halve, a meeting is looked for by Newton's method and proved by an interval Newton test
//! (Krawczyk).
//!
//! Of a cone that reaches its apex all rulings meet there; the others meet where their directions agree, so the
//! directions take the place of the points.

use crate::coordinate::Coordinate;
use crate::model::ChebyshevModel;
use crate::surface::Rails;
use crate::vector::{add, cross, dot, norm, scale, sub};
use std::collections::BTreeMap;

/// What is known of a patch in space.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum SelfIntersection {
    /// No two rulings meet: proved.
    Free,
    /// Two places `[u, v]` are the same point.
    Found {
        /// Both places.
        places: [[f64; 2]; 2],
        /// The point.
        point: [f64; 3],
        /// Whether it is proved that there is one within a millionth of these parameters.
        proved: bool,
    },
    /// Rulings of these two ranges of the parameter may meet.
    Undecided {
        /// The ranges.
        ranges: [[f64; 2]; 2],
    },
}

impl SelfIntersection {
    /// The same of a patch that is moved by this vector.
    pub(crate) fn moved(self, by: [f64; 3]) -> Self {
        match self {
            Self::Found {
                places,
                point,
                proved,
            } => Self::Found {
                places,
                point: add(&point, &by),
                proved,
            },
            other => other,
        }
    }
}

/// The shortest intervals, as a number of halvings.
const MAX_DEPTH: u32 = 12;
/// Intervals shorter than this many halvings are looked at for a meeting.
const MEETING_DEPTH: u32 = 6;
/// The most pairs of intervals.
const MAX_PAIRS: usize = 40_000;
/// Steps of the search for the distance of two hulls.
const HULL_STEPS: usize = 24;
/// First and last ruling are one if they are nearer than this share of the size.
const CLOSED: f64 = 1e-9;

/// An interval `[index, index + 1]/2^depth`.
type Key = (u32, u32);

/// What is known of the rulings of an interval.
struct Strip {
    /// The ends of the chords of both rails.
    corners: [[f64; 3]; 4],
    /// How far the rails are from their chords, at most.
    room: f64,
    /// Intervals of the speeds of the rails, and of the ruling.
    slopes: [[ChebyshevModel; 3]; 2],
    ruling: [ChebyshevModel; 3],
}

struct Search<'a, M> {
    models: &'a M,
    apexes: [bool; 2],
    strips: BTreeMap<Key, Option<Strip>>,
}

/// A constant that stands for all values of a model.
fn constant(model: &ChebyshevModel) -> ChebyshevModel {
    let [low, high] = model.range();
    let middle = 0.5 * (low + high);
    ChebyshevModel::exact(middle)
        .widened((high - middle).max(middle - low) * (1.0 + 4.0 * f64::EPSILON))
}

fn width((depth, index): Key) -> [f64; 2] {
    let count = f64::from(1_u32 << depth);
    [f64::from(index) / count, f64::from(index + 1) / count]
}

fn halves((depth, index): Key) -> [Key; 2] {
    [(depth + 1, 2 * index), (depth + 1, 2 * index + 1)]
}

impl<M: Rails<ChebyshevModel>> Search<'_, M> {
    fn strip(&mut self, key: Key) -> Option<&Strip> {
        if !self.strips.contains_key(&key) {
            let made = self.made(key);
            self.strips.insert(key, made);
        }
        self.strips.get(&key)?.as_ref()
    }

    fn made(&self, key: Key) -> Option<Strip> {
        let [from, to] = width(key);
        let [[p, dp], [q, dq]] = self
            .models
            .ends_and_slopes(&ChebyshevModel::identity(from, to))
            .ok()?;
        let ruling = sub(&q, &p);
        let ends = if self.apexes == [false; 2] {
            [p, q]
        } else {
            // Directions, at the distances one and two.
            let length = dot(&ruling, &ruling).root()?;
            let unit = [
                ruling[0].quotient(&length)?,
                ruling[1].quotient(&length)?,
                ruling[2].quotient(&length)?,
            ];
            [unit, add(&unit, &unit)]
        };
        let mut corners = [[0.0; 3]; 4];
        let mut room = 0.0_f64;
        for (rail, models) in ends.iter().enumerate() {
            let mut off = [0.0; 3];
            for (axis, model) in models.iter().enumerate() {
                let (chord, rest) = model.chord();
                corners[2 * rail][axis] = chord[0];
                corners[2 * rail + 1][axis] = chord[1];
                off[axis] = rest;
            }
            room = room.max(norm(&off) * (1.0 + 4.0 * f64::EPSILON));
        }
        Some(Strip {
            corners,
            room,
            slopes: [dp, dq].map(|slope| slope.each_ref().map(constant)),
            ruling: ruling.each_ref().map(constant),
        })
    }

    /// Whether the patch is proved to move away from each of the rulings of these intervals, which follow each other.
    fn moves_away(&mut self, keys: &[Key]) -> bool {
        let mut strips = Vec::with_capacity(keys.len());
        for key in keys {
            let Some(strip) = self.strip(*key) else {
                return false;
            };
            strips.push((strip.slopes, strip.ruling));
        }
        let mut across = [0.0; 3];
        for (slopes, _) in &strips {
            let mean = slopes.map(|slope| slope.map(|c| c.approximate()));
            for slope in mean {
                let size = norm(&slope);
                if size > 0.0 {
                    across = add(&across, &scale(&(1.0 / size), &slope));
                }
            }
        }
        let across = across.map(ChebyshevModel::exact);
        let apexes = self.apexes;
        strips.iter().all(|(_, ruling)| {
            let square = dot(ruling, ruling);
            let part = dot(ruling, &across);
            let normal = sub(&scale(&square, &across), &scale(&part, ruling));
            strips.iter().all(|(slopes, _)| {
                (0..2).all(|rail| apexes[rail] || dot(&slopes[rail], &normal).range()[0] > 0.0)
            })
        })
    }

    /// Whether the hulls of two strips are proved to be apart.
    fn are_apart(&mut self, one: Key, other: Key) -> bool {
        let Some(first) = self.strip(one) else {
            return false;
        };
        let (a, room_a) = (first.corners, first.room);
        let Some(second) = self.strip(other) else {
            return false;
        };
        let (b, room_b) = (second.corners, second.room);
        let size = a
            .iter()
            .chain(&b)
            .flatten()
            .fold(0.0_f64, |m, c| m.max(c.abs()));
        let needed = room_a + room_b + 64.0 * f64::EPSILON * size;
        are_hulls_apart(&a, &b, needed)
    }
}

/// Whether the hulls of two sets of points are farther apart than `needed`: by Gilbert's iteration for the point of the
/// hull of all differences that is nearest to the origin; each step proves a bound.
fn are_hulls_apart(a: &[[f64; 3]; 4], b: &[[f64; 3]; 4], needed: f64) -> bool {
    let differences: Vec<[f64; 3]> = a
        .iter()
        .flat_map(|p| b.iter().map(move |q| sub(p, q)))
        .collect();
    #[allow(clippy::cast_precision_loss)]
    let share = 1.0 / differences.len() as f64;
    let mut nearest = differences
        .iter()
        .fold([0.0; 3], |sum, d| add(&sum, &scale(&share, d)));
    for _ in 0..HULL_STEPS {
        let length = norm(&nearest);
        if length <= needed {
            return false;
        }
        let support = differences
            .iter()
            .min_by(|x, y| dot(x, &nearest).total_cmp(&dot(y, &nearest)));
        let Some(support) = support else { return false };
        if dot(support, &nearest) / length > needed {
            return true;
        }
        let step = sub(support, &nearest);
        let square = dot(&step, &step);
        if square == 0.0 {
            return false;
        }
        let way = (-dot(&nearest, &step) / square).clamp(0.0, 1.0);
        nearest = add(&nearest, &scale(&way, &step));
    }
    false
}

/// Looks for two rulings of a patch that meet.
///
/// The first and the last ruling of a patch may be the same one: a tube.
pub(crate) fn self_intersection<P, M>(patch: &P, models: &M) -> SelfIntersection
where
    P: Rails<f64> + ?Sized,
    M: Rails<ChebyshevModel>,
{
    let whole = SelfIntersection::Undecided {
        ranges: [[0.0, 1.0]; 2],
    };
    let apexes = patch.end_kinds().apexes();
    if apexes == [true; 2] {
        return whole;
    }
    let (Ok(first), Ok(last)) = (patch.ruling_ends(&0.0), patch.ruling_ends(&1.0)) else {
        return whole;
    };
    let size = norm(&sub(&first[0], &first[1])).max(norm(&sub(&last[0], &last[1])));
    let closed = (0..2).all(|i| norm(&sub(&first[i], &last[i])) <= CLOSED * size);
    let mut search = Search {
        models,
        apexes,
        strips: BTreeMap::new(),
    };
    let mut open: Vec<(Key, Key)> = vec![((0, 0), (0, 0))];
    let mut undecided: Option<(Key, Key)> = None;
    let mut looked = 0;
    while let Some((one, other)) = open.pop() {
        looked += 1;
        if looked > MAX_PAIRS {
            undecided = Some((one, other));
            break;
        }
        let [from, to] = [width(one), width(other)];
        let decided = if one == other {
            search.moves_away(&[one])
        } else if from[1] == to[0] {
            search.moves_away(&[one, other])
        } else if closed && from[0] == 0.0 && to[1] == 1.0 {
            search.moves_away(&[other, one])
        } else {
            search.are_apart(one, other)
        };
        if decided {
            continue;
        }
        if one != other
            && one.0.min(other.0) >= MEETING_DEPTH
            && let Some((places, point)) = meeting(patch, from, to)
            // Of a tube the same ruling is both the first and the last.
            && !(closed && (places[1][0] - places[0][0]).abs() > 1.0 - 1e-6)
        {
            let proved = is_proved(models, places);
            return SelfIntersection::Found {
                places,
                point,
                proved,
            };
        }
        if one.0.max(other.0) >= MAX_DEPTH {
            undecided.get_or_insert((one, other));
            continue;
        }
        if one == other {
            let [a, b] = halves(one);
            open.extend([(a, a), (b, b), (a, b)]);
        } else if one.0 <= other.0 {
            open.extend(halves(one).map(|half| (half, other)));
        } else {
            open.extend(halves(other).map(|half| (one, half)));
        }
    }
    match undecided {
        None => SelfIntersection::Free,
        Some((one, other)) => SelfIntersection::Undecided {
            ranges: [width(one), width(other)],
        },
    }
}

type Places = [[f64; 2]; 2];

/// Two places that are the same point, near the middles of two ranges: Newton's method for the parameters of both
/// rulings and the place on the second, with the place on the first held fast.
fn meeting<P: Rails<f64> + ?Sized>(
    patch: &P,
    from: [f64; 2],
    to: [f64; 2],
) -> Option<(Places, [f64; 3])> {
    let room = 4.0 * (from[1] - from[0]).max(to[1] - to[0]);
    for v in [0.5, 0.25, 0.75, 0.125, 0.875, 0.0, 1.0] {
        let [mut x, mut y] = [from, to].map(|range| 0.5 * (range[0] + range[1]));
        let start = [x, y];
        let mut w: Option<f64> = None;
        for _ in 0..16 {
            let (Ok(one), Ok(two)) = (patch.ends_and_slopes(&x), patch.ends_and_slopes(&y)) else {
                break;
            };
            let ruling = sub(&two[1][0], &two[0][0]);
            let point = crate::vector::lerp(&one[0][0], &one[1][0], &v);
            let place =
                w.unwrap_or_else(|| dot(&sub(&point, &two[0][0]), &ruling) / dot(&ruling, &ruling));
            let there = crate::vector::lerp(&two[0][0], &two[1][0], &place);
            let off = sub(&point, &there);
            let columns = [
                crate::vector::lerp(&one[0][1], &one[1][1], &v),
                crate::vector::lerp(&two[0][1], &two[1][1], &place).map(|c| -c),
                ruling.map(|c| -c),
            ];
            let Some(step) = solved(&columns, &off) else {
                break;
            };
            (x, y) = (x - step[0], y - step[1]);
            let next = place - step[2];
            w = Some(next);
            let inside = (0.0..=1.0).contains(&x) && (0.0..=1.0).contains(&y);
            let near = (x - start[0]).abs() <= room && (y - start[1]).abs() <= room;
            if !(inside && near) {
                break;
            }
            if step[0].abs() + step[1].abs() + step[2].abs() < 1e-12 {
                let apart = (y - x).abs() > 1e-5;
                if apart && (0.0..=1.0).contains(&next) {
                    return Some(([[x, v], [y, next]], point));
                }
                break;
            }
        }
    }
    None
}

/// The solution of `columns . x = right`.
fn solved(columns: &[[f64; 3]; 3], right: &[f64; 3]) -> Option<[f64; 3]> {
    let [a, b, c] = columns;
    let whole = dot(a, &cross(b, c));
    let solution = [
        dot(right, &cross(b, c)) / whole,
        dot(right, &cross(c, a)) / whole,
        dot(right, &cross(a, b)) / whole,
    ];
    solution.iter().all(|x| x.is_finite()).then_some(solution)
}

/// Half the width of the box in which a meeting is proved.
const MEETING_ROOM: f64 = 1e-6;

/// Whether a meeting is proved near two places, by the test of Krawczyk: `c - Y f(c) + (1 - Y f'(X))(X - c)` lies in
/// the box `X` about `c`.
fn is_proved(models: &impl Rails<ChebyshevModel>, [[x, v], [y, w]]: Places) -> bool {
    let r = MEETING_ROOM;
    let inside = |x: f64| r <= x && x <= 1.0 - r;
    if !(inside(x) && inside(y) && (0.0..=1.0).contains(&w)) {
        return false;
    }
    let exact = |x: f64| ChebyshevModel::exact(x);
    let around = |x: f64| ChebyshevModel::exact(x).widened(r);
    let at = |x: &ChebyshevModel,
              y: &ChebyshevModel,
              w: &ChebyshevModel|
     -> Option<([ChebyshevModel; 3], [[ChebyshevModel; 3]; 3])> {
        let one = models.ends_and_slopes(x).ok()?;
        let two = models.ends_and_slopes(y).ok()?;
        let between = |p: &[ChebyshevModel; 3], q: &[ChebyshevModel; 3], v: &ChebyshevModel| {
            add(p, &scale(v, &sub(q, p))).each_ref().map(constant)
        };
        let v = ChebyshevModel::exact(v);
        let off = sub(
            &between(&one[0][0], &one[1][0], &v),
            &between(&two[0][0], &two[1][0], w),
        );
        let minus = |vector: [ChebyshevModel; 3]| vector.map(|c| -c);
        let columns = [
            between(&one[0][1], &one[1][1], &v),
            minus(between(&two[0][1], &two[1][1], w)),
            minus(sub(&two[1][0], &two[0][0]).each_ref().map(constant)),
        ];
        Some((off, columns))
    };
    let Some((off, middle)) = at(&exact(x), &exact(y), &exact(w)) else {
        return false;
    };
    // Over the box: each model runs over its own interval, so only its range counts.
    let (over_x, over_y) = (
        ChebyshevModel::identity(x - r, x + r),
        ChebyshevModel::identity(y - r, y + r),
    );
    let Some((_, over)) = at(&over_x, &over_y, &around(w)) else {
        return false;
    };
    let columns = middle.map(|column| column.map(|c| c.approximate()));
    let mut inverse = [[0.0; 3]; 3];
    for k in 0..3 {
        let mut unit = [0.0; 3];
        unit[k] = 1.0;
        let Some(column) = solved(&columns, &unit) else {
            return false;
        };
        for (row, value) in inverse.iter_mut().zip(column) {
            row[k] = value;
        }
    }
    inverse.iter().enumerate().all(|(i, row)| {
        let row = row.map(ChebyshevModel::exact);
        let mut reach = dot(&row, &off).largest();
        for (j, column) in over.iter().enumerate() {
            let unit = ChebyshevModel::exact(if i == j { 1.0 } else { 0.0 });
            reach += (unit - dot(&row, column)).largest() * r;
        }
        reach * (1.0 + 1e-12) < r
    })
}
