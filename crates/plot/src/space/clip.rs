//! Cutting solids to a box, before anything is projected.

use crate::space::corner::Corner;
use crate::space::vector::{V3, lerp};

/// An interval per axis.
pub(crate) type BoxBounds = [[f64; 2]; 3];

/// Parameters of the part of the segment `a b` inside the box, if any (Liang and Barsky 1984).
pub(crate) fn clip_segment(a: V3, b: V3, bounds: &BoxBounds) -> Option<(f64, f64)> {
    let (mut t0, mut t1) = (0.0f64, 1.0f64);
    for k in 0..3 {
        let [low, high] = bounds[k];
        let d = b[k] - a[k];
        for (toward, room) in [(-d, a[k] - low), (d, high - a[k])] {
            if toward == 0.0 {
                if room < 0.0 {
                    return None;
                }
            } else if toward < 0.0 {
                t0 = t0.max(room / toward);
            } else {
                t1 = t1.min(room / toward);
            }
        }
    }
    (t0 <= t1).then_some((t0, t1))
}

/// The pieces of a polyline inside the box.
pub(crate) fn clip_curve(points: &[V3], bounds: &BoxBounds) -> Vec<[V3; 2]> {
    points
        .windows(2)
        .filter_map(|pair| {
            let &[a, b] = pair else { return None };
            let (t0, t1) = clip_segment(a, b, bounds)?;
            Some([t0, t1].map(|t| onto(lerp(a, b, t), bounds)))
        })
        .collect()
}

/// The nearest point of the box: a cut is off by the rounding of its ends, which may be very far away.
fn onto(p: V3, bounds: &BoxBounds) -> V3 {
    [0, 1, 2].map(|k| p[k].max(bounds[k][0]).min(bounds[k][1]))
}

/// Whether the box contains a point.
pub(crate) fn contains(bounds: &BoxBounds, p: V3) -> bool {
    bounds
        .iter()
        .zip(p)
        .all(|([low, high], c)| (*low..=*high).contains(&c))
}

/// A triangle cut to the box, as triangles (Sutherland and Hodgman 1974, then a fan).
pub(crate) fn clip_triangle(
    triangle: [Corner; 3],
    bounds: &BoxBounds,
    mut emit: impl FnMut([Corner; 3]),
) {
    if triangle.iter().all(|c| contains(bounds, c.at)) {
        return emit(triangle);
    }
    let mut polygon = triangle.to_vec();
    for (k, &[low, high]) in bounds.iter().enumerate() {
        for (bound, sign) in [(low, 1.0), (high, -1.0)] {
            let room = |c: &Corner| (c.at[k] - bound) * sign;
            let mut kept = Vec::with_capacity(polygon.len() + 1);
            for (a, b) in polygon.iter().zip(polygon.iter().cycle().skip(1)) {
                let (ra, rb) = (room(a), room(b));
                if ra >= 0.0 {
                    kept.push(*a);
                }
                if (ra < 0.0) != (rb < 0.0) {
                    kept.push(a.lerp(b, ra / (ra - rb)));
                }
            }
            polygon = kept;
        }
    }
    for corner in &mut polygon {
        corner.at = onto(corner.at, bounds);
    }
    if let Some((first, rest)) = polygon.split_first() {
        for pair in rest.windows(2) {
            if let &[b, c] = pair {
                emit([*first, b, c]);
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::space::vector::{cross, dot, sub};
    use proptest::prelude::*;

    const CUBE: BoxBounds = [[0.0, 1.0]; 3];

    fn corner(at: V3) -> Corner {
        Corner {
            at,
            normal: [0.0, 0.0, 1.0],
            uv: [at[0], at[1]],
            value: at[2],
        }
    }

    #[test]
    fn a_large_triangle_through_the_cube_keeps_its_section() {
        // The plane z = 1/2 cuts the unit cube in a unit square.
        let triangle = [[-9.0, -9.0, 0.5], [20.0, -9.0, 0.5], [-9.0, 20.0, 0.5]].map(corner);
        let mut area = 0.0;
        clip_triangle(triangle, &CUBE, |[a, b, c]| {
            let n = cross(sub(b.at, a.at), sub(c.at, a.at));
            area += 0.5 * dot(n, n).sqrt();
            // Attributes are affine: they follow the points.
            assert!((a.uv[0] - a.at[0]).abs() < 1e-12 && (b.value - 0.5).abs() < 1e-12);
        });
        assert!((area - 1.0).abs() < 1e-12);
    }

    #[test]
    fn a_diagonal_is_cut_at_the_walls() {
        let pieces = clip_curve(&[[-1.0; 3], [2.0; 3]], &CUBE);
        assert!(
            pieces.len() == 1
                && pieces[0][0][0].abs() < 1e-12
                && (pieces[0][1][2] - 1.0).abs() < 1e-12
        );
        assert!(clip_curve(&[[2.0, 0.0, 0.0], [2.0, 1.0, 1.0]], &CUBE).is_empty());
    }

    proptest! {
        #[test]
        fn no_corner_leaves_the_box(p in prop::array::uniform9(-1e200..1e200f64)) {
            let triangle = [[p[0], p[1], p[2]], [p[3], p[4], p[5]], [p[6], p[7], p[8]]].map(corner);
            let large = [[-1e199, 1e199]; 3];
            clip_triangle(triangle, &large, |t| assert!(t.iter().all(|c| contains(&large, c.at))));
        }
    }
}
