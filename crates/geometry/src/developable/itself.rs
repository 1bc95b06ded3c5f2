//! Whether a patch passes through itself in space: found with both parameters, proved not to, or undecided.
//!
//! Two rulings near each other do not meet if the patch moves away from each of them: let `R(x)` be a ruling, `T` a
//! fixed vector and `m(x) = T (R.R) - R (R.T)`, which is orthogonal to `R(x)`. If `P'(y).m(x)` and `Q'(y).m(x)` are
//! positive for all `x, y` of an interval, then `(S(y, w) - P(x)).m(x)` grows with `y` from zero at `y = x`, and no
//! later ruling of the interval meets that of `x`. Where the interval starts or ends in a tip, in which the ruling has no
//! length, `R(x)` is divided by the distance from there: that changes `m(x)` by a positive factor.
//!
//! Two rulings far from each other do not meet if hulls of the strips about them do not: a strip lies within the hull
//! of four points, widened by what the rails differ from their chords. What is neither near nor apart is halved. Where
//! nothing is left to halve, a meeting is looked for by Newton's method and proved by an interval Newton test
//! (Krawczyk).
//!
//! Of a cone that reaches its apex all rulings meet there; the others meet where their directions agree, so the
//! directions take the place of the points.

use super::meeting::{WHOLE_RULING, is_proved, meeting};
use super::strip::{Key, Strip, halves, width};
use crate::coordinate::Coordinate;
use crate::model::ChebyshevModel;
use crate::surface::{Rails, RulingEnd};
use crate::vector::{add, dot, norm, scale, sub};
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
/// First and last ruling are one if they are nearer than this share of the size.
const CLOSED: f64 = 1e-9;

struct Search<'a, M> {
    models: &'a M,
    apexes: [bool; 2],
    /// Whether the first and the last ruling are a point each.
    tips: [bool; 2],
    strips: BTreeMap<Key, Option<Strip>>,
}

impl<M: Rails<ChebyshevModel>> Search<'_, M> {
    fn strip(&mut self, key: Key) -> Option<&Strip> {
        if !self.strips.contains_key(&key) {
            let apex = self.apexes.iter().position(|is_point| *is_point);
            let made = Strip::new(self.models, key, apex);
            self.strips.insert(key, made);
        }
        self.strips.get(&key)?.as_ref()
    }

    /// Whether the patch is proved to move away from each of the rulings of these intervals, which follow each other.
    fn moves_away(&mut self, keys: &[Key]) -> bool {
        let mut strips = Vec::with_capacity(keys.len());
        for key in keys {
            let Some(strip) = self.strip(*key) else {
                return false;
            };
            let (slopes, ruling) = (strip.slopes, strip.ruling);
            let [from, to] = width(*key);
            let at_tip = (from == 0.0 && self.tips[0]) || (to == 1.0 && self.tips[1]);
            // From a point the ruling grows with the speed by which the rails part, coordinate by coordinate: the mean value.
            let direction = if at_tip {
                sub(&slopes[1], &slopes[0])
            } else {
                ruling
            };
            strips.push((slopes, direction));
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
        let Some(first) = self.strip(one).copied() else {
            return false;
        };
        self.strip(other)
            .is_some_and(|second| first.is_apart_from(second))
    }
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
        tips: patch.end_kinds().rulings().map(|end| end == RulingEnd::Tip),
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
            && let Some((places, point)) = meeting([patch, patch], [from, to], &WHOLE_RULING, |places, _| {
                (places[1][0] - places[0][0]).abs() > 1e-5
            })
            // Of a tube the same ruling is both the first and the last.
            && !(closed && (places[1][0] - places[0][0]).abs() > 1.0 - 1e-6)
        {
            let proved = is_proved([models, models], places);
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
