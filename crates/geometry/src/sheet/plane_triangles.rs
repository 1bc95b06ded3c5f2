//! Plane triangles of panels: fans over a straight piece of a rail, in the plane of a tangent of the other rail.
//!
//! On a straight piece of one rail `F` does not depend on its parameter, so that its zeros are lines: all rulings from one point
//! of the other rail to the piece are solutions. They are a triangle, which neighbours touch smoothly at both of its sides.

use super::Rail;
use super::pieces::{Pieces, corner};
use crate::developable::{Connections, Node};

/// A triangle: the rail that stands still, and its first and its last ruling.
pub(super) type PlaneTriangle = (usize, [Node; 2]);

/// Parameters that count as one.
const SAME: f64 = 1e-8;

/// Finds all plane triangles over whole straight pieces, each once.
pub(super) fn plane_triangles(
    rails: &[Pieces; 2],
    squares: &[([usize; 2], Connections<Rail, Rail>)],
) -> Vec<PlaneTriangle> {
    let mut found: Vec<PlaneTriangle> = Vec::new();
    for (square, between) in squares {
        let offset = corner(*square);
        for moving in 0..2 {
            if !rails[moving].is_straight(square[moving]) {
                continue;
            }
            let still = 1 - moving;
            // The panel lies on one side of the triangle, from end to end.
            let [start, middle, end] = [0.0, 0.5, 1.0].map(|at| between.on_line(moving, at));
            let has =
                |list: &[Node], at: f64| list.iter().any(|node| (node[still] - at).abs() <= SAME);
            for place in middle {
                let at = place[still];
                if !has(&start, at) || !has(&end, at) {
                    continue;
                }
                let ends = [0.0, 1.0].map(|x| {
                    let mut node = [0.0; 2];
                    node[moving] = offset[moving] + x;
                    node[still] = offset[still] + at;
                    node
                });
                let known = found.iter().any(|(other, [first, _])| {
                    *other == still && (0..2).all(|i| (first[i] - ends[0][i]).abs() <= SAME)
                });
                if !known {
                    found.push((still, ends));
                }
            }
        }
    }
    found
}
