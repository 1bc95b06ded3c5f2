//! Whether patches of one piece pass through each other in space, beyond the rulings and the points in which they are joined.
//!
//! Two strips that are joined do not meet elsewhere if a plane through what they share has them on different sides: along a
//! rail that starts in the plane, and along a ruling that lies in it, the speeds tell. What is joined counts as one: ends of
//! rulings that are no farther apart than is allowed for joints. Patches with a common apex meet elsewhere only where their
//! directions agree. All other strips are apart if their hulls are, as strips of one patch.

use super::meeting::{WHOLE_RULING, is_proved, meeting};
use super::strip::{Key, Strip, halves, separating, width};
use crate::model::ChebyshevModel;
use crate::surface::Rails;
use crate::vector::{dot, norm, scale, sub, unit};
use std::collections::BTreeMap;

/// What is known of the patches of a piece, two at a time.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum PieceIntersection {
    /// No two of them meet but where they are joined: proved.
    Free,
    /// Two places `[u, v]` of two patches are the same point.
    Found {
        /// The indices of the patches.
        patches: [usize; 2],
        /// The place on each.
        places: [[f64; 2]; 2],
        /// The point.
        point: [f64; 3],
        /// Whether it is proved that there is one within a millionth of these parameters.
        proved: bool,
    },
    /// Rulings of these ranges of the parameters of two patches may meet.
    Undecided {
        /// The indices of the patches.
        patches: [usize; 2],
        /// The range of each.
        ranges: [[f64; 2]; 2],
    },
}

/// The shortest intervals, as a number of halvings.
const MAX_DEPTH: u32 = 12;
/// Intervals shorter than this many halvings are looked at for a meeting.
const MEETING_DEPTH: u32 = 3;
/// The most pairs of intervals of two patches.
const MAX_PAIRS: usize = 2_000;
/// The most pairs of intervals of all patches, beyond one for each two of them.
const MAX_ALL_PAIRS: usize = 20_000;
/// Where it is not a proof that is wanted: the most pairs of intervals of two patches, the shortest intervals, those that are
/// looked at for a meeting, and where on their rulings. A piercing lies inside of both patches.
const PIERCING: Limits = Limits {
    depth: 6,
    meeting_depth: 5,
    starts: &[0.5, 0.25, 0.75],
    pairs: 400,
    all: 400 * MAX_PIERCING_PATCHES,
};
/// The most pairs of patches of different pieces that are looked at for that.
const MAX_PIERCING_PATCHES: usize = 2_000;
/// What is nearer to an edge than this share of the parameter may be on it.
const EDGE: f64 = 1e-3;

/// Where a patch is joined.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Touch {
    /// The ruling on which that is: the first (0), the last (1); every one, where a rail is the point.
    end: Option<usize>,
    /// The rails that reach it there.
    rails: [bool; 2],
}

/// What two patches share: a point, or a ruling through it.
#[derive(Debug, Clone, Copy)]
struct Contact {
    point: [f64; 3],
    ruling: Option<[f64; 3]>,
    touches: [Touch; 2],
}

/// The first and the last ruling of a patch, and what of it is a point.
struct Ends {
    corners: [[[f64; 3]; 2]; 2],
    apexes: [bool; 2],
}

impl Ends {
    fn new<P: Rails<f64> + ?Sized>(patch: &P) -> Option<Self> {
        Some(Self {
            corners: [patch.ruling_ends(&0.0).ok()?, patch.ruling_ends(&1.0).ok()?],
            apexes: patch.end_kinds().apexes(),
        })
    }

    /// Where it reaches a point.
    fn touches(&self, point: &[f64; 3], joined: f64) -> Vec<Touch> {
        let is_there =
            |end: usize, rail: usize| norm(&sub(&self.corners[end][rail], point)) <= joined;
        let apex = [0, 1].map(|rail| self.apexes[rail] && is_there(0, rail));
        if apex != [false; 2] {
            return vec![Touch {
                end: None,
                rails: apex,
            }];
        }
        (0..2)
            .map(|end| Touch {
                end: Some(end),
                rails: [0, 1].map(|rail| is_there(end, rail)),
            })
            .filter(|touch| touch.rails != [false; 2])
            .collect()
    }
}

/// What two patches share at their first and last rulings and their apexes.
fn contacts(one: &Ends, other: &Ends, joined: f64) -> Vec<Contact> {
    let mut found: Vec<Contact> = Vec::new();
    for end in 0..2 {
        let [p, q] = one.corners[end];
        let ruling = sub(&q, &p);
        for there in 0..2 {
            let same = |crossed: usize| {
                (0..2).all(|rail| {
                    norm(&sub(
                        &one.corners[end][rail],
                        &other.corners[there][rail ^ crossed],
                    )) <= joined
                })
            };
            if norm(&ruling) > 2.0 * joined && (same(0) || same(1)) {
                let touch = |end: usize| Touch {
                    end: Some(end),
                    rails: [true; 2],
                };
                found.push(Contact {
                    point: p,
                    ruling: Some(ruling),
                    touches: [touch(end), touch(there)],
                });
            }
        }
    }
    for point in one.corners.iter().flatten() {
        for mine in one.touches(point, joined) {
            for theirs in other.touches(point, joined) {
                let touches = [mine, theirs];
                // A point of a common ruling is no other contact, nor is an apex that both share.
                let at_apex = touches.iter().all(|touch| touch.end.is_none());
                let is_known = |known: &Contact| match known.ruling {
                    Some(_) => (0..2).all(|i| touches[i].end == known.touches[i].end),
                    None => known.touches == touches,
                };
                if at_apex || found.iter().any(is_known) {
                    continue;
                }
                found.push(Contact {
                    point: *point,
                    ruling: None,
                    touches,
                });
            }
        }
    }
    found
}

/// What two intervals share: a common ruling stands for the points at its ends.
fn shared(contacts: &[Contact], keys: [Key; 2], joined: f64) -> Vec<&Contact> {
    let is_in = |contact: &&Contact| (0..2).all(|side| contact.is_in(side, keys[side]));
    let all: Vec<&Contact> = contacts.iter().filter(is_in).collect();
    let on_ruling = |point: &[f64; 3]| {
        all.iter().any(|contact| {
            contact.ruling.is_some_and(|ruling| {
                let from_start = sub(point, &contact.point);
                norm(&from_start).min(norm(&sub(&from_start, &ruling))) <= 2.0 * joined
            })
        })
    };
    let kept = all
        .iter()
        .filter(|contact| contact.ruling.is_some() || !on_ruling(&contact.point));
    kept.copied().collect()
}

impl Contact {
    /// Whether the rulings of an interval of one of the patches reach it.
    fn is_in(&self, side: usize, key: Key) -> bool {
        let [from, to] = width(key);
        match self.touches[side].end {
            None => true,
            Some(0) => from == 0.0,
            Some(_) => to == 1.0,
        }
    }

    /// Whether a point is no farther from it than `near`.
    fn is_near(&self, point: &[f64; 3], near: f64) -> bool {
        let arm = sub(point, &self.point);
        let foot = match self.ruling {
            None => [0.0; 3],
            Some(ruling) => {
                let share = dot(&arm, &ruling) / dot(&ruling, &ruling);
                scale(&share.clamp(0.0, 1.0), &ruling)
            }
        };
        norm(&sub(&arm, &foot)) <= near
    }

    /// Whether a plane through it is proved to have two strips on different sides.
    fn separates(&self, strips: [&Strip; 2], apexes: [[bool; 2]; 2]) -> bool {
        // Vectors that have to go to the side of the second strip, each with the room it needs.
        let mut vectors: Vec<([ChebyshevModel; 3], f64)> = Vec::new();
        for (side, strip) in strips.into_iter().enumerate() {
            let sign = [-1.0, 1.0][side];
            let touch = self.touches[side];
            for (rail, is_apex) in apexes[side].into_iter().enumerate() {
                if touch.rails[rail] && is_apex {
                    continue;
                }
                if touch.rails[rail] {
                    let outwards = if touch.end == Some(1) { -sign } else { sign };
                    let outwards = ChebyshevModel::exact(outwards);
                    vectors.push((scale(&outwards, &strip.slopes[rail]), 0.0));
                    continue;
                }
                for corner in [strip.corners[2 * rail], strip.corners[2 * rail + 1]] {
                    let size = norm(&corner).max(norm(&self.point));
                    let room = strip.room + 16.0 * f64::EPSILON * size;
                    let way = scale(&sign, &sub(&corner, &self.point));
                    vectors.push((way.map(ChebyshevModel::exact), room));
                }
            }
        }
        let middles: Vec<[f64; 3]> = vectors
            .iter()
            .filter_map(|(vector, _)| {
                let vector = vector.each_ref().map(|c| {
                    let [low, high] = c.range();
                    0.5 * (low + high)
                });
                let across = match self.ruling {
                    None => vector,
                    Some(ruling) => {
                        let share = dot(&vector, &ruling) / dot(&ruling, &ruling);
                        sub(&vector, &scale(&share, &ruling))
                    }
                };
                unit(&across)
            })
            .collect();
        if middles.len() < vectors.len() || middles.is_empty() {
            return false;
        }
        let towards = separating(&middles, 0.0);
        let normal = towards.map(ChebyshevModel::exact);
        let normal = match self.ruling {
            None => normal,
            // Enclosed, and exactly orthogonal to the ruling.
            Some(ruling) => {
                let ruling = ruling.map(ChebyshevModel::exact);
                let (square, part) = (dot(&ruling, &ruling), dot(&ruling, &normal));
                sub(&scale(&square, &normal), &scale(&part, &ruling))
            }
        };
        let length = 2.0 * norm(&towards);
        vectors
            .iter()
            .all(|(vector, room)| dot(vector, &normal).range()[0] > room * length)
    }
}

struct Search<'a, P: ?Sized, M> {
    patches: &'a [&'a P],
    models: &'a [M],
    strips: BTreeMap<(usize, Key, Option<usize>), Option<Strip>>,
    looked: usize,
}

/// How far a search goes.
#[derive(Clone, Copy)]
struct Limits {
    depth: u32,
    meeting_depth: u32,
    starts: &'static [f64],
    pairs: usize,
    all: usize,
}

impl<P, M> Search<'_, P, M>
where
    P: Rails<f64> + ?Sized,
    M: Rails<ChebyshevModel>,
{
    fn strip(&mut self, index: usize, key: Key, apex: Option<usize>) -> Option<Strip> {
        let model = self.models.get(index)?;
        *self
            .strips
            .entry((index, key, apex))
            .or_insert_with(|| Strip::new(model, key, apex))
    }

    /// What is known of two patches: the first meeting that is `wanted`, by its places, its point and whether it is proved.
    fn pair(
        &mut self,
        patches: [usize; 2],
        ends: [&Ends; 2],
        joined: f64,
        limits: Limits,
        wanted: impl Fn(&[[f64; 2]; 2], &[f64; 3], bool) -> bool,
    ) -> PieceIntersection {
        let apexes = ends.map(|ends| ends.apexes);
        // The rail of each that is their common apex.
        let common = (0..2).find_map(|rail| {
            let there = (0..2).find(|there| {
                apexes[0][rail]
                    && apexes[1][*there]
                    && norm(&sub(&ends[0].corners[0][rail], &ends[1].corners[0][*there])) <= joined
            })?;
            Some([rail, there])
        });
        let mut contacts = contacts(ends[0], ends[1], joined);
        if common.is_some() {
            // Two rulings through the apex that share another point are one.
            contacts.retain(|contact| contact.ruling.is_some());
        }
        let size = ends
            .iter()
            .flat_map(|ends| ends.corners.iter())
            .map(|[p, q]| norm(&sub(p, q)))
            .fold(0.0, f64::max);
        let near = 2.0 * joined + 1e-6 * size;
        let apex = common.map(|[rail, _]| ends[0].corners[0][rail]);
        let distinct = |_: &[[f64; 2]; 2], point: &[f64; 3]| {
            !contacts.iter().any(|contact| contact.is_near(point, near))
                && apex.is_none_or(|apex| norm(&sub(point, &apex)) > near)
        };
        let mut open: Vec<[Key; 2]> = vec![[(0, 0); 2]];
        let mut undecided: Option<[Key; 2]> = None;
        let mut looked = 0;
        while let Some(keys) = open.pop() {
            looked += 1;
            self.looked += 1;
            if looked > limits.pairs || self.looked > limits.all {
                undecided = Some(keys);
                break;
            }
            let strips = [0, 1].map(|side| {
                let (rail, apex) = (common.map(|rails| rails[side]), patches[side]);
                self.strip(apex, keys[side], rail)
            });
            if let [Some(one), Some(other)] = &strips {
                let decided = match shared(&contacts, keys, joined).as_slice() {
                    [] => one.is_apart_from(other),
                    [contact] => contact.separates([one, other], apexes),
                    // Halves share less.
                    _ => false,
                };
                if decided {
                    continue;
                }
            }
            let [a, b] = keys.map(|key| key.0);
            if a.min(b) >= limits.meeting_depth
                && let [Some(one), Some(other)] = patches.map(|k| self.patches.get(k))
                && let Some((places, point)) =
                    meeting([*one, *other], keys.map(width), limits.starts, distinct)
                && let [Some(m), Some(n)] = patches.map(|k| self.models.get(k))
            {
                let proved = is_proved([m, n], places);
                if wanted(&places, &point, proved) {
                    return PieceIntersection::Found {
                        patches,
                        places,
                        point,
                        proved,
                    };
                }
            }
            if a.max(b) >= limits.depth {
                undecided.get_or_insert(keys);
            } else if a <= b {
                open.extend(halves(keys[0]).map(|half| [half, keys[1]]));
            } else {
                open.extend(halves(keys[1]).map(|half| [keys[0], half]));
            }
        }
        match undecided {
            None => PieceIntersection::Free,
            Some(keys) => PieceIntersection::Undecided {
                patches,
                ranges: keys.map(width),
            },
        }
    }
}

/// Looks for two patches that meet where they are not joined; joined are ends of rulings no farther apart than `joined`.
pub(crate) fn piece_intersection<P, M>(
    patches: &[&P],
    models: &[M],
    joined: f64,
) -> PieceIntersection
where
    P: Rails<f64> + ?Sized,
    M: Rails<ChebyshevModel>,
{
    let count = patches.len();
    let limits = Limits {
        depth: MAX_DEPTH,
        meeting_depth: MEETING_DEPTH,
        starts: &WHOLE_RULING,
        pairs: MAX_PAIRS,
        all: MAX_ALL_PAIRS + count * count,
    };
    let mut search = Search {
        patches,
        models,
        strips: BTreeMap::new(),
        looked: 0,
    };
    let ends: Vec<Option<Ends>> = patches.iter().map(|patch| Ends::new(*patch)).collect();
    let mut open = None;
    for other in 1..count {
        for one in 0..other {
            let (Some(Some(mine)), Some(Some(theirs))) = (ends.get(one), ends.get(other)) else {
                open.get_or_insert(PieceIntersection::Undecided {
                    patches: [one, other],
                    ranges: [[0.0, 1.0]; 2],
                });
                continue;
            };
            match search.pair([one, other], [mine, theirs], joined, limits, |_, _, _| true) {
                PieceIntersection::Free => {}
                found @ PieceIntersection::Found { .. } => return found,
                undecided @ PieceIntersection::Undecided { .. } => {
                    open.get_or_insert(undecided);
                }
            }
        }
    }
    open.unwrap_or(PieceIntersection::Free)
}

/// Two patches of different pieces that pierce each other.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SheetPiercing {
    /// The indices of the pieces.
    pub pieces: [usize; 2],
    /// The index of each patch in its piece.
    pub sheets: [usize; 2],
    /// The place `[u, v]` on each, inside of it.
    pub places: [[f64; 2]; 2],
    /// The point.
    pub point: [f64; 3],
}

/// Looks for a point of each two pieces at which patches of them pierce each other, proved, inside of both patches and `wanted`.
/// Where they touch along edges none is found. All pairs share what was computed of the intervals of a patch.
pub(crate) fn piercings<P, M>(
    pieces: &[Vec<&P>],
    models: &[M],
    wanted: impl Fn(&SheetPiercing) -> bool,
) -> Vec<SheetPiercing>
where
    P: Rails<f64> + ?Sized,
    M: Rails<ChebyshevModel>,
{
    let patches: Vec<&P> = pieces.iter().flatten().copied().collect();
    let ends: Vec<Option<Ends>> = patches.iter().map(|patch| Ends::new(*patch)).collect();
    // The index of the first patch of each piece.
    let firsts: Vec<usize> = pieces
        .iter()
        .scan(0, |next, piece| {
            let first = *next;
            *next += piece.len();
            Some(first)
        })
        .collect();
    let mut search = Search {
        patches: &patches,
        models,
        strips: BTreeMap::new(),
        looked: 0,
    };
    let is_inside = |places: &[[f64; 2]; 2], proved: bool| {
        proved
            && places
                .iter()
                .flatten()
                .all(|x| (EDGE..=1.0 - EDGE).contains(x))
    };
    let mut looked = 0;
    let mut first = |one: usize, other: usize| {
        for mine in 0..pieces[one].len() {
            for theirs in 0..pieces[other].len() {
                looked += 1;
                if looked > MAX_PIERCING_PATCHES {
                    return None;
                }
                let pair = [firsts[one] + mine, firsts[other] + theirs];
                let [Some(Some(a)), Some(Some(b))] = pair.map(|index| ends.get(index)) else {
                    continue;
                };
                let piercing = |places: &[[f64; 2]; 2], point: &[f64; 3]| SheetPiercing {
                    pieces: [one, other],
                    sheets: [mine, theirs],
                    places: *places,
                    point: *point,
                };
                let is_one = |places: &[[f64; 2]; 2], point: &[f64; 3], proved: bool| {
                    is_inside(places, proved) && wanted(&piercing(places, point))
                };
                let found = search.pair(pair, [a, b], 0.0, PIERCING, is_one);
                if let PieceIntersection::Found { places, point, .. } = found {
                    return Some(piercing(&places, &point));
                }
            }
        }
        None
    };
    let mut found = vec![];
    for other in 0..pieces.len() {
        for one in 0..other {
            found.extend(first(one, other));
        }
    }
    found
}
