//! From lines to contours: what is joined end to end, and what stays open.

use super::trace::Traced;
use crate::polygon::{chord_points, distance, hull, is_within};
use std::collections::BTreeMap;
use torse_geometry::pattern::Segment;

/// Points of a contour that stand for one of its arcs.
const ARC_POINTS: u32 = 32;

/// A closed contour.
#[derive(Debug, Clone)]
pub(super) struct Contour {
    /// The curves it is made of.
    pub curves: Vec<usize>,
    pub segments: Vec<Segment>,
    pub nodes: usize,
    /// How many contours it lies in.
    pub depth: usize,
}

/// An end that nothing is joined to, or that several are joined to.
#[derive(Debug, Clone)]
pub(super) struct LooseEnd {
    pub at: [f64; 2],
    /// The curve that ends there.
    pub curve: usize,
    /// How many ends there are at the point, itself included: 1 for an open end.
    pub ends: usize,
    /// How far the nearest other loose end is.
    pub gap: Option<f64>,
}

/// Arcs whose circles differ by no more, as a share of the radius, are of one circle.
const SAME_CIRCLE: f64 = 1e-9;

impl Contour {
    /// Returns the diameter of a contour that is a circle.
    pub(super) fn diameter(&self) -> Option<f64> {
        let mut circles = self.segments.iter().map(Segment::circle);
        let (centre, radius) = circles.next()??;
        let near = SAME_CIRCLE * (radius + libm::hypot(centre[0], centre[1]));
        let same = |circle: Option<([f64; 2], f64)>| {
            circle.is_some_and(|(other, size)| {
                distance(centre, other) <= near && (size - radius).abs() <= near
            })
        };
        circles.all(same).then_some(2.0 * radius)
    }

    /// Returns the contour as a polygon.
    pub(super) fn polygon(&self) -> Vec<[f64; 2]> {
        let each = self.segments.iter();
        each.flat_map(|segment| chord_points(segment, ARC_POINTS))
            .collect()
    }
}

/// Returns the contours of the curves that are cut, and the ends that are left over.
pub(super) fn contours(curves: &[Traced], within: f64) -> (Vec<Contour>, Vec<LooseEnd>) {
    let mut found = Vec::new();
    // Ends of open curves: the curve, and whether it is its last end.
    let mut ends: Vec<([f64; 2], usize, bool)> = Vec::new();
    for (index, curve) in curves.iter().enumerate().filter(|(_, curve)| curve.cut) {
        let Some([from, to]) = curve.ends() else {
            continue;
        };
        if distance(from, to) <= within {
            found.push(Contour {
                curves: vec![index],
                segments: curve.segments.clone(),
                nodes: curve.nodes,
                depth: 0,
            });
        } else {
            ends.push((from, index, false));
            ends.push((to, index, true));
        }
    }
    let points: Vec<[f64; 2]> = ends.iter().map(|(at, _, _)| *at).collect();
    let (groups, count) = grouped(&points, within);
    let mut at_point: Vec<Vec<usize>> = vec![Vec::new(); count];
    for (end, group) in groups.iter().enumerate() {
        if let Some(list) = at_point.get_mut(*group) {
            list.push(end);
        }
    }
    let mut loose: Vec<LooseEnd> = Vec::new();
    for list in at_point.iter().filter(|list| list.len() != 2) {
        if let Some((at, curve, _)) = list.first().and_then(|end| ends.get(*end)) {
            loose.push(LooseEnd {
                at: *at,
                curve: *curve,
                ends: list.len(),
                gap: None,
            });
        }
    }
    let open: Vec<[f64; 2]> = loose
        .iter()
        .filter(|end| end.ends == 1)
        .map(|end| end.at)
        .collect();
    for end in &mut loose {
        let others = open.iter().map(|other| distance(*other, end.at));
        end.gap = others.filter(|gap| *gap > 0.0).min_by(f64::total_cmp);
    }
    // From curve to curve where two ends meet; a chain that comes back to its start is a contour.
    let mut used = vec![false; ends.len() / 2];
    for start in 0..used.len() {
        if used.get(start).copied().unwrap_or(true) {
            continue;
        }
        let (mut chain, mut at) = (Vec::new(), 2 * start);
        let closed = loop {
            let number = at / 2;
            if used.get(number).copied().unwrap_or(true) {
                break number == start && !chain.is_empty() && at == 2 * start;
            }
            if let Some(slot) = used.get_mut(number) {
                *slot = true;
            }
            chain.push(at);
            let out = at ^ 1;
            let group = groups.get(out).and_then(|group| at_point.get(*group));
            match group.map(Vec::as_slice) {
                Some([a, b]) => at = if *a == out { *b } else { *a },
                _ => break false,
            }
        };
        if closed {
            found.push(joined(curves, &ends, &chain));
        }
    }
    let polygons: Vec<Vec<[f64; 2]>> = found.iter().map(Contour::polygon).collect();
    for index in 0..found.len() {
        let point = polygons
            .get(index)
            .and_then(|polygon| polygon.first())
            .copied();
        let around = polygons.iter().enumerate().filter(|(other, polygon)| {
            *other != index && point.is_some_and(|point| is_within(polygon, point))
        });
        let depth = around.count();
        if let Some(contour) = found.get_mut(index) {
            contour.depth = depth;
        }
    }
    (found, loose)
}

/// Returns the contour of curves one after the other, each entered at an end.
fn joined(curves: &[Traced], ends: &[([f64; 2], usize, bool)], chain: &[usize]) -> Contour {
    let mut contour = Contour {
        curves: Vec::new(),
        segments: Vec::new(),
        nodes: 0,
        depth: 0,
    };
    for end in chain {
        let Some((_, index, last)) = ends.get(*end) else {
            continue;
        };
        let Some(curve) = curves.get(*index) else {
            continue;
        };
        contour.curves.push(*index);
        contour.nodes += curve.nodes;
        if *last {
            contour
                .segments
                .extend(curve.segments.iter().rev().map(Segment::reversed));
        } else {
            contour.segments.extend(&curve.segments);
        }
    }
    contour
}

/// Returns points by the groups of those that are no farther from one another than this, and how many groups there are.
fn grouped(points: &[[f64; 2]], within: f64) -> (Vec<usize>, usize) {
    #[allow(clippy::cast_possible_truncation)]
    let cell = |c: f64| (c / within).floor().clamp(-9e15, 9e15) as i64;
    let mut cells: BTreeMap<[i64; 2], Vec<usize>> = BTreeMap::new();
    let mut groups: Vec<usize> = Vec::with_capacity(points.len());
    let mut count = 0;
    for (index, point) in points.iter().enumerate() {
        let [x, y] = point.map(cell);
        let around = (-1..=1).flat_map(|dx| (-1..=1).map(move |dy| [x + dx, y + dy]));
        let near = around.filter_map(|key| cells.get(&key)).flatten();
        let mut near = near.filter(|other| {
            points
                .get(**other)
                .is_some_and(|p| distance(*p, *point) <= within)
        });
        let group = near.next().and_then(|other| groups.get(*other)).copied();
        groups.push(group.unwrap_or_else(|| {
            count += 1;
            count - 1
        }));
        cells.entry([x, y]).or_default().push(index);
    }
    (groups, count)
}

/// Returns the smallest distance between two parallel lines with a polygon between them.
pub(super) fn least_width(polygon: &[[f64; 2]]) -> f64 {
    let hull = hull(polygon.to_vec());
    let sides = hull.iter().zip(hull.iter().cycle().skip(1));
    let width = |(a, b): (&[f64; 2], &[f64; 2])| {
        let [x, y] = [b[0] - a[0], b[1] - a[1]];
        let length = libm::hypot(x, y);
        let far = |p: &[f64; 2]| ((p[1] - a[1]) * x - (p[0] - a[0]) * y) / length;
        hull.iter().map(far).fold(0.0, f64::max)
    };
    sides.map(width).fold(f64::INFINITY, f64::min)
}
