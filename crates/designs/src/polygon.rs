//! Points and polygons in the plane.

use torse_geometry::pattern::Segment;

/// Returns the distance of two points.
pub fn distance(a: [f64; 2], b: [f64; 2]) -> f64 {
    libm::hypot(a[0] - b[0], a[1] - b[1])
}

/// Returns the start of a line, or the starts of so many equal parts of an arc: of the segments of a contour in a row, the
/// corners of a polygon in its place.
pub fn chord_points(segment: &Segment, arc_chords: u32) -> impl Iterator<Item = [f64; 2]> + use<> {
    let segment = *segment;
    let steps = if segment.is_line() { 1 } else { arc_chords };
    (0..steps).map(move |k| segment.point(f64::from(k) / f64::from(steps)))
}

/// Returns a closed polygon as a contour.
#[cfg(test)]
pub(crate) fn lines_around(points: &[[f64; 2]]) -> Vec<Segment> {
    let next = points.iter().cycle().skip(1);
    let sides = points.iter().zip(next);
    sides.map(|(a, b)| Segment::line(*a, *b)).collect()
}

/// Returns whether a point is within a closed polygon: a ray from it crosses that an odd number of times.
pub fn is_within(polygon: &[[f64; 2]], [x, y]: [f64; 2]) -> bool {
    let next = polygon.iter().cycle().skip(1);
    let crossed = polygon.iter().zip(next).filter(|(a, b)| {
        (a[1] > y) != (b[1] > y) && x < a[0] + (y - a[1]) / (b[1] - a[1]) * (b[0] - a[0])
    });
    crossed.count() % 2 == 1
}

/// Returns the corners of the convex hull, counterclockwise (Andrew 1979).
pub fn hull(mut points: Vec<[f64; 2]>) -> Vec<[f64; 2]> {
    points.sort_by(|a, b| a[0].total_cmp(&b[0]).then(a[1].total_cmp(&b[1])));
    points.dedup();
    let half = |points: &mut dyn Iterator<Item = [f64; 2]>| {
        let mut chain: Vec<[f64; 2]> = Vec::new();
        for point in points {
            while let [.., a, b] = chain.as_slice() {
                let turn = (b[0] - a[0]) * (point[1] - a[1]) - (b[1] - a[1]) * (point[0] - a[0]);
                if turn > 0.0 {
                    break;
                }
                chain.pop();
            }
            chain.push(point);
        }
        chain.pop();
        chain
    };
    let mut hull = half(&mut points.iter().copied());
    hull.extend(half(&mut points.iter().rev().copied()));
    hull
}
