//! Polygons of meshes as triangles.

use torse_geometry::vector::{add, cross, sub};

/// The most corners of a polygon that is not convex: the time goes with their square, or worse.
pub(super) const MAX_CONCAVE_CORNERS: usize = 1000;

/// A polygon as triangles.
pub(super) struct Triangulated {
    /// Indices of its corners.
    pub triangles: Vec<[usize; 3]>,
    /// Whether its outline crosses itself: then triangles overlap.
    pub crossed: bool,
}

/// The triangles of a polygon in space, seen along its mean normal: those of a convex one have its first corner in common, from
/// another one ears are cut. `None` for more than [`MAX_CONCAVE_CORNERS`] corners of one that is not convex.
pub(super) fn triangulated(corners: &[[f64; 3]]) -> Option<Triangulated> {
    let flat = flattened(corners);
    let count = corners.len();
    let fan = |left: &[usize]| -> Vec<[usize; 3]> {
        let first = left.first().copied().unwrap_or_default();
        let pairs = left.windows(2).skip(1);
        pairs.map(|pair| [first, pair[0], pair[1]]).collect()
    };
    let all: Vec<usize> = (0..count).collect();
    let at = |k: usize| flat.get(k).copied().unwrap_or_default();
    let turn = |a: usize, b: usize, c: usize| area(at(a), at(b), at(c));
    let convex = (0..count).all(|k| turn(k, (k + 1) % count, (k + 2) % count) >= 0.0)
        && fan(&all).iter().all(|[a, b, c]| turn(*a, *b, *c) >= 0.0);
    if convex {
        return Some(Triangulated {
            triangles: fan(&all),
            crossed: false,
        });
    }
    if count > MAX_CONCAVE_CORNERS {
        return None;
    }
    let (mut left, mut triangles) = (all, Vec::new());
    while left.len() > 3 {
        let n = left.len();
        let is_ear = |k: &usize| {
            let [a, b, c] = [left[(k + n - 1) % n], left[*k], left[(k + 1) % n]];
            let inside = |p: &usize| {
                let p = at(*p);
                ![at(a), at(b), at(c)].contains(&p)
                    && area(at(a), at(b), p) >= 0.0
                    && area(at(b), at(c), p) >= 0.0
                    && area(at(c), at(a), p) >= 0.0
            };
            turn(a, b, c) > 0.0 && !left.iter().any(inside)
        };
        // A corner between two sides of one direction has no ear, and goes first.
        let straight = |k: &usize| turn(left[(k + n - 1) % n], left[*k], left[(k + 1) % n]) == 0.0;
        let Some(ear) = (0..n).find(straight).or_else(|| (0..n).find(is_ear)) else {
            triangles.extend(fan(&left));
            return Some(Triangulated {
                triangles,
                crossed: true,
            });
        };
        triangles.push([left[(ear + n - 1) % n], left[ear], left[(ear + 1) % n]]);
        left.remove(ear);
    }
    triangles.extend(fan(&left));
    let crossed = triangles.iter().any(|[a, b, c]| turn(*a, *b, *c) < 0.0);
    Some(Triangulated { triangles, crossed })
}

/// Twice the area of a triangle of the plane, negative if it runs clockwise.
fn area(a: [f64; 2], b: [f64; 2], c: [f64; 2]) -> f64 {
    (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])
}

/// The corners without the coordinate in which the mean normal (Newell's) is largest, so that they run anticlockwise.
fn flattened(corners: &[[f64; 3]]) -> Vec<[f64; 2]> {
    let first = corners.first().copied().unwrap_or_default();
    let normal = corners.windows(2).fold([0.0; 3], |sum, pair| {
        add(&sum, &cross(&sub(&pair[0], &first), &sub(&pair[1], &first)))
    });
    let largest = (0..3).fold(0, |best, axis| {
        if normal[axis].abs() > normal[best].abs() {
            axis
        } else {
            best
        }
    });
    let (x, y) = ((largest + 1) % 3, (largest + 2) % 3);
    let (x, y) = if normal[largest] < 0.0 {
        (y, x)
    } else {
        (x, y)
    };
    corners
        .iter()
        .map(|corner| [corner[x], corner[y]])
        .collect()
}
