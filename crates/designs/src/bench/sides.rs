//! The sides of a part with their labels, and which of them meet in space.

use super::words::length;
use crate::design::Design;
use crate::error::DesignError;
use crate::polygon::chord_points;
use crate::position::position;
use crate::seams::{EdgeName, PatchEdge};
use crate::unroll::{Blank, FlatPiece, Part};
use torse_geometry::pattern::Segment;
use torse_geometry::prelude::Point;
use torse_geometry::vector::{norm, sub};

/// Points along a rail of a patch, in space.
const POINTS: u32 = 64;
/// Points along an arc of the outline.
const ARC_POINTS: u32 = 16;
/// Sides meet in space if they are no farther apart than this share of their length; what chords cost is within it.
const MEETING: f64 = 1e-3;

/// A side of a part: a stretch of its outline that is an edge of the design.
#[derive(Debug, Clone)]
pub(super) struct Side {
    /// The letter of the part and a number: `A1`.
    pub label: String,
    /// What the design calls it.
    pub name: String,
    /// The edges of patches that it consists of, by the index of the patch.
    pub members: Vec<(usize, PatchEdge)>,
    /// Its points on the part, the part being on their left.
    pub points: Vec<[f64; 2]>,
    /// Its points in space, from the same end.
    pub space: Vec<Point>,
    /// Its length on the part.
    pub length: f64,
    /// The labels of the sides that it meets.
    pub meets: Vec<String>,
}

/// Returns the letter of a part by its number, from 0: `A` to `Z`, then `AA`.
pub(super) fn letter(mut number: usize) -> String {
    let mut letters = Vec::new();
    loop {
        #[allow(clippy::cast_possible_truncation, reason = "a remainder by 26")]
        letters.push(char::from(b'A' + (number % 26) as u8));
        match (number / 26).checked_sub(1) {
            Some(rest) => number = rest,
            None => break,
        }
    }
    letters.iter().rev().collect()
}

/// Returns the sides of a part, against the clock from the right of one who follows the chain; what is a point is no
/// side.
pub(super) fn sides(
    design: &Design,
    piece: &FlatPiece,
    part: &Part,
    blank: &Blank,
    letter: &str,
) -> Result<Vec<Side>, DesignError> {
    let flat = &piece.flat;
    if design.has_border(&piece.piece) {
        return Ok(Vec::new());
    }
    let patches = piece.piece.patches.iter();
    let mut order: Vec<(usize, usize)> = patches
        .filter_map(|index| Some((position(flat, design.patches.get(*index)?)?, *index)))
        .collect();
    order.sort_unstable();
    let on_part = |place: usize, point: [f64; 2]| {
        let point = blank.moved(place, point)?;
        Some(part.placement.point(point))
    };
    // The two rails of each patch: to the left of one who follows the chain, and to the right.
    let mut rails: [Vec<DirectedEdge>; 2] = [Vec::new(), Vec::new()];
    let mut ends: Vec<[DirectedEdge; 2]> = Vec::new();
    for (place, index) in &order {
        let (Some(chains), Some(backward), Some(patch), Some(rulings)) = (
            flat.sides(*place),
            flat.is_backward(*place),
            design.patches.get(*index),
            flat.end_rulings(*place),
        ) else {
            continue;
        };
        let mut first = flat.rail(*place, 0).unwrap_or_default();
        if backward {
            first = first.iter().rev().map(Segment::reversed).collect();
        }
        let left = usize::from(first != chains[0]);
        let space = |u: f64, v: f64| {
            let u = if backward { 1.0 - u } else { u };
            patch
                .sheet
                .point(u, v)
                .map_err(|reason| DesignError::Patch {
                    patch: patch.name.clone(),
                    reason,
                })
        };
        let shares = |rail: usize| if rail == 0 { 0.0 } else { 1.0 };
        for (side, chain) in chains.iter().enumerate() {
            let rail = if side == 0 { left } else { 1 - left };
            // What a bend takes of an edge is on no side of the part.
            let chain = blank.kept(*place, chain);
            let points: Vec<[f64; 2]> = chain
                .iter()
                .flat_map(|segment| chord_points(segment, ARC_POINTS).chain([segment.to]))
                .collect();
            let on_blank: Vec<[f64; 2]> = points
                .iter()
                .filter_map(|point| on_part(*place, *point))
                .collect();
            // What arcs are longer than their chords is the same on the blank.
            let arcs: f64 = chain.iter().map(Segment::length).sum();
            let length = polygon_length(&on_blank) + arcs - polygon_length(&points);
            let steps = (0..=POINTS).map(|k| space(f64::from(k) / f64::from(POINTS), shares(rail)));
            rails[side].push(DirectedEdge {
                member: (*index, [PatchEdge::First, PatchEdge::Second][rail]),
                points: on_blank,
                length,
                space: steps.collect::<Result<_, _>>()?,
            });
        }
        let mut both = Vec::new();
        for (end, ruling) in rulings.iter().enumerate() {
            let edge = if (end == 0) == backward {
                PatchEdge::End
            } else {
                PatchEdge::Start
            };
            let u = if end == 0 { 0.0 } else { 1.0 };
            let points: Vec<[f64; 2]> = ruling
                .iter()
                .filter_map(|point| on_part(*place, *point))
                .collect();
            both.push(DirectedEdge {
                member: (*index, edge),
                length: polygon_length(&points),
                points,
                space: vec![space(u, shares(left))?, space(u, shares(1 - left))?],
            });
        }
        if let Ok(both) = <[DirectedEdge; 2]>::try_from(both) {
            ends.push(both);
        }
    }
    let [left, right] = rails;
    let (Some(start), Some(end)) = (
        ends.first().map(|[start, _]| start.clone()),
        ends.last().map(|[_, end]| end.clone()),
    ) else {
        return Ok(Vec::new());
    };
    let (left, right) = (to_bend_lines(left), to_bend_lines(right));
    let mut groups = grouped(design, right);
    groups.push(vec![end.turned()]);
    let back = left.iter().rev().map(DirectedEdge::turned).collect();
    groups.extend(grouped(design, back));
    groups.push(vec![start]);
    let size: f64 = part.outline.iter().map(Segment::length).sum();
    let mut sides = Vec::new();
    for group in groups {
        let members: Vec<(usize, PatchEdge)> = group.iter().map(|run| run.member).collect();
        let points: Vec<[f64; 2]> = group.iter().flat_map(|run| run.points.clone()).collect();
        let length = group.iter().map(|run| run.length).sum::<f64>();
        if length <= 1e-9 * size {
            continue;
        }
        sides.push(Side {
            label: format!("{letter}{}", sides.len() + 1),
            name: name(design, piece, &members),
            members,
            points,
            space: group.into_iter().flat_map(|run| run.space).collect(),
            length,
            meets: Vec::new(),
        });
    }
    Ok(sides)
}

/// An edge of a patch, passed with the part on the left.
#[derive(Debug, Clone)]
struct DirectedEdge {
    member: (usize, PatchEdge),
    points: Vec<[f64; 2]>,
    length: f64,
    space: Vec<Point>,
}

/// Returns the runs of a rail, each as far as the middle of the bent strip between it and the next: its bend line.
fn to_bend_lines(mut runs: Vec<DirectedEdge>) -> Vec<DirectedEdge> {
    for k in 1..runs.len() {
        let (before, after) = runs.split_at_mut(k);
        let (Some(before), Some(after)) = (before.last_mut(), after.first_mut()) else {
            continue;
        };
        let (Some(end), Some(start)) = (before.points.last(), after.points.first()) else {
            continue;
        };
        let middle = [0, 1].map(|i| 0.5 * (end[i] + start[i]));
        let half = 0.5 * polygon_length(&[*end, *start]);
        before.points.push(middle);
        after.points.insert(0, middle);
        before.length += half;
        after.length += half;
    }
    runs
}

fn polygon_length(points: &[[f64; 2]]) -> f64 {
    let pairs = points.windows(2);
    let lengths = pairs.map(|pair| libm::hypot(pair[1][0] - pair[0][0], pair[1][1] - pair[0][1]));
    lengths.sum()
}

impl DirectedEdge {
    fn turned(&self) -> Self {
        Self {
            member: self.member,
            points: self.points.iter().rev().copied().collect(),
            length: self.length,
            space: self.space.iter().rev().copied().collect(),
        }
    }
}

/// Returns the runs of a side of a chain, cut where an edge of a seam starts or ends.
fn grouped(design: &Design, runs: Vec<DirectedEdge>) -> Vec<Vec<DirectedEdge>> {
    let edges = || design.seams.iter().flat_map(|seam| &seam.edges);
    let on = |edge: &EdgeName, run: &DirectedEdge| is_of(edge, run.member);
    let mut groups: Vec<Vec<DirectedEdge>> = Vec::new();
    for run in runs {
        match groups.last_mut() {
            Some(group)
                if group
                    .last()
                    .is_some_and(|last| edges().all(|edge| on(edge, last) == on(edge, &run))) =>
            {
                group.push(run);
            }
            _ => groups.push(vec![run]),
        }
    }
    groups
}

/// Returns whether an edge of a patch is one of those that a seam names.
fn is_of(edge: &EdgeName, (patch, own): (usize, PatchEdge)) -> bool {
    edge.edge == own && edge.patches.contains(&patch)
}

/// Returns what the design calls a side.
fn name(design: &Design, piece: &FlatPiece, members: &[(usize, PatchEdge)]) -> String {
    let mut edges = design.seams.iter().flat_map(|seam| &seam.edges);
    let whole = |edge: &&EdgeName| {
        edge.patches.len() == members.len() && members.iter().all(|member| is_of(edge, *member))
    };
    if let Some(edge) = edges.find(whole) {
        return edge.text.clone();
    }
    let Some((index, edge)) = members.first() else {
        return String::new();
    };
    let patch = design.patches.get(*index);
    let own = patch.and_then(|patch| patch.edges.iter().find(|(_, known)| known == edge));
    let edge = own.map_or(edge.name(), |(name, _)| name.as_str());
    match (members, patch) {
        ([_], Some(patch)) => format!("{}.{edge}", patch.name),
        _ => format!("{}.{edge}", piece.piece.name),
    }
}

/// Tells each side which others it meets: those that a seam names, and those that lie on it in space.
pub(super) fn pair(design: &Design, parts: &mut [Vec<Side>]) {
    let mut all: Vec<&mut Side> = parts.iter_mut().flatten().collect();
    let mut met: Vec<(usize, usize)> = Vec::new();
    for seam in &design.seams {
        let [one, other] = [0, 1].map(|end| {
            let edge = &seam.edges[end];
            let sides = all.iter().enumerate();
            let on = sides.filter(|(_, side)| side.members.iter().all(|m| is_of(edge, *m)));
            on.map(|(k, _)| k).collect::<Vec<_>>()
        });
        met.extend(
            one.iter()
                .flat_map(|a| other.iter().map(|b| (*a.min(b), *a.max(b)))),
        );
    }
    for a in 0..all.len() {
        for b in a + 1..all.len() {
            let (Some(one), Some(other)) = (all.get(a), all.get(b)) else {
                continue;
            };
            if !met.contains(&(a, b)) && is_on(one, other) {
                met.push((a, b));
            }
        }
    }
    met.sort_unstable();
    met.dedup();
    for (a, b) in met {
        let label = |k: usize| {
            all.get(k)
                .map(|side| side.label.clone())
                .unwrap_or_default()
        };
        let (one, other) = (label(a), label(b));
        if let Some(side) = all.get_mut(a) {
            side.meets.push(other);
        }
        if let Some(side) = all.get_mut(b) {
            side.meets.push(one);
        }
    }
}

/// Returns whether two sides are one line in space.
fn is_on(one: &Side, other: &Side) -> bool {
    let within = MEETING * one.length.min(other.length);
    let equal = |a: f64, b: f64| (a - b).abs() <= MEETING * a.max(b);
    // A bend makes an edge of the blank shorter than it is in space.
    let lengths =
        equal(one.length, other.length) || equal(one.length_in_space(), other.length_in_space());
    let corner = |side: &Side, far: fn(f64, f64) -> f64| {
        side.space
            .iter()
            .fold(side.space.first().copied().unwrap_or_default(), |c, p| {
                std::array::from_fn(|i| far(c[i], p[i]))
            })
    };
    let near = |far: fn(f64, f64) -> f64| {
        norm(&sub(&corner(one, far), &corner(other, far))) <= 4.0 * within
    };
    let lies = |points: &[Point], line: &[Point]| {
        points.iter().all(|point| {
            let sides = line.windows(2);
            sides
                .map(|pair| distance_to_segment(point, &pair[0], &pair[1]))
                .fold(f64::INFINITY, f64::min)
                <= within
        })
    };
    lengths
        && near(f64::min)
        && near(f64::max)
        && lies(&one.space, &other.space)
        && lies(&other.space, &one.space)
}

/// Returns the distance of a point from a segment.
fn distance_to_segment(point: &Point, from: &Point, to: &Point) -> f64 {
    let (way, arm) = (sub(to, from), sub(point, from));
    let square: f64 = way.iter().map(|c| c * c).sum();
    let along: f64 = way.iter().zip(&arm).map(|(a, b)| a * b).sum();
    let share = if square > 0.0 {
        (along / square).clamp(0.0, 1.0)
    } else {
        0.0
    };
    let foot: Point = std::array::from_fn(|i| from[i] + share * way[i]);
    norm(&sub(point, &foot))
}

impl Side {
    /// Returns the length of the chords between its points in space.
    fn length_in_space(&self) -> f64 {
        let pairs = self.space.windows(2);
        pairs.map(|pair| norm(&sub(&pair[1], &pair[0]))).sum()
    }

    /// Returns the label with those of the sides that it meets: `A1 to B3`.
    pub(super) fn mark(&self) -> String {
        if self.meets.is_empty() {
            return self.label.clone();
        }
        format!("{} to {}", self.label, self.meets.join(", "))
    }

    /// Its row in the table of sides.
    pub(super) fn row(&self) -> Vec<String> {
        let [x, y] = self.points.first().copied().unwrap_or_default();
        vec![
            self.label.clone(),
            self.name.clone(),
            length(self.length),
            format!("{}, {}", length(x), length(y)),
            if self.meets.is_empty() {
                "free".to_owned()
            } else {
                self.meets.join(", ")
            },
        ]
    }

    /// Returns the point at half of its length and the direction there.
    pub(super) fn middle(&self) -> Option<([f64; 2], [f64; 2])> {
        let mut left = 0.5 * self.length;
        for pair in self.points.windows(2) {
            let way = [pair[1][0] - pair[0][0], pair[1][1] - pair[0][1]];
            let step = libm::hypot(way[0], way[1]);
            if step > 0.0 && left <= step {
                let unit = way.map(|c| c / step);
                return Some(([0, 1].map(|i| pair[0][i] + left * unit[i]), unit));
            }
            left -= step;
        }
        None
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn parts_have_letters_and_after_the_last_two() {
        let letters = [0, 1, 25, 26, 27, 51, 52].map(letter);
        assert_eq!(letters, ["A", "B", "Z", "AA", "AB", "AZ", "BA"]);
    }
}
