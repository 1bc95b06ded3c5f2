//! Meshes of ruled patches with openings.
//!
//! An opening is met by each ruling in one interval, so between two neighbouring rulings the patch is a row of bands:
//! from the first rail to the lowest opening, from one opening to the next, from the last to the second rail. Each band
//! is a row of triangles between its vertices on both rulings.

use super::grid::ruling_parameters;
use super::{Mesh, check_count, number};
use crate::error::{ExchangeError, Result};
use torse_geometry::Rails;
use torse_geometry::vector::{cross, lerp, sub, unit};

/// An opening in a ruled patch: the rulings that meet it, and which part of each it takes.
pub struct Opening<'a> {
    /// The parameters of the first and the last ruling that meet it.
    pub range: [f64; 2],
    /// Parameters of rulings between them that are edges of the mesh, so that the opening is as round as is wanted.
    pub rulings: Vec<f64>,
    /// Where it begins and ends on a ruling of the range, as shares of it.
    pub across: &'a dyn Fn(f64) -> [f64; 2],
}

/// Parameters nearer to one another are one ruling.
const SAME_RULING: f64 = 1e-12;

/// A ruling of the mesh with its vertices: share of the ruling and number.
struct Station {
    x: f64,
    vertices: Vec<(f64, u32)>,
}

impl Mesh {
    /// The mesh of a ruled patch as [`Mesh::ruled`] makes it, without the openings, which must not overlap.
    ///
    /// # Errors
    /// As [`Mesh::ruled`], and [`ExchangeError::OutOfRange`] for an opening that leaves the patch.
    ///
    /// ```
    /// use torse_exchange::{Mesh, Opening};
    /// use torse_geometry::{Bernstein, Curve, RuledSurface};
    /// let rail = |y: f64| Curve::new(Bernstein, vec![[0.0, y, 0.0], [4.0, y, 0.0]]);
    /// let plate = RuledSurface::new(rail(0.0)?, rail(3.0)?);
    /// // A rhombus with diagonals two and one.
    /// let across = |x: f64| { let half = (0.5 - (4.0 * x - 2.0).abs() * 0.5) / 3.0; [0.5 - half, 0.5 + half] };
    /// let opening = Opening { range: [0.25, 0.75], rulings: vec![0.5], across: &across };
    /// let mesh = Mesh::ruled_with_openings(&plate, 1e-3, &[opening])?;
    /// assert!((mesh.area() - (12.0 - 1.0)).abs() < 1e-12);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn ruled_with_openings(
        patch: &impl Rails<f64>,
        tolerance: f64,
        openings: &[Opening<'_>],
    ) -> Result<Self> {
        let mut places = ruling_parameters(patch, tolerance)?;
        for opening in openings {
            places.extend(opening.range);
            places.extend(&opening.rulings);
        }
        if let Some(&value) = places.iter().find(|x| !(0.0..=1.0).contains(*x)) {
            let (name, range) = ("ruling of an opening", "[0, 1]");
            return Err(ExchangeError::OutOfRange { name, value, range });
        }
        places.sort_by(f64::total_cmp);
        places.dedup_by(|a, b| (*a - *b).abs() <= SAME_RULING);
        let meets = |opening: &Opening<'_>, x: f64| {
            let [from, to] = opening.range;
            from - SAME_RULING <= x && x <= to + SAME_RULING
        };
        let (mut vertices, mut normals) = (Vec::new(), Vec::new());
        let mut stations: Vec<Station> = Vec::with_capacity(places.len());
        for x in places {
            let [[p, dp], [q, dq]] = patch.ends_and_slopes(&x)?;
            let ruling = sub(&q, &p);
            let mut shares = vec![0.0, 1.0];
            for opening in openings.iter().filter(|opening| meets(opening, x)) {
                let across = (opening.across)(x);
                if let Some(&value) = across.iter().find(|v| !(0.0..=1.0).contains(*v)) {
                    let (name, range) = ("share of a ruling in an opening", "[0, 1]");
                    return Err(ExchangeError::OutOfRange { name, value, range });
                }
                shares.extend(across);
            }
            shares.sort_by(f64::total_cmp);
            shares.dedup();
            check_count(vertices.len() + shares.len())?;
            let first = vertices.len();
            for share in &shares {
                vertices.push(lerp(&p, &q, share));
                let slope = lerp(&dp, &dq, share);
                normals.push(unit(&cross(&slope, &ruling)).unwrap_or_default());
            }
            let numbered = shares.into_iter().zip(first..);
            stations.push(Station {
                x,
                vertices: numbered.map(|(v, n)| (v, number(n))).collect(),
            });
        }
        let mut triangles = Vec::new();
        for pair in stations.windows(2) {
            let [left, right] = pair else { continue };
            let middle = 0.5 * (left.x + right.x);
            let mut between: Vec<&Opening<'_>> = openings
                .iter()
                .filter(|opening| meets(opening, left.x) && meets(opening, right.x))
                .collect();
            between.sort_by(|a, b| (a.across)(middle)[0].total_cmp(&(b.across)(middle)[0]));
            let mut low = [0.0; 2];
            for opening in between {
                let (a, b) = ((opening.across)(left.x), (opening.across)(right.x));
                band(&mut triangles, [left, right], low, [a[0], b[0]]);
                low = [a[1], b[1]];
            }
            band(&mut triangles, [left, right], low, [1.0; 2]);
        }
        Self::with_normals(vertices, normals, triangles)
    }
}

/// The triangles between two rulings from the shares `low` of both to the shares `high`.
fn band(triangles: &mut Vec<[u32; 3]>, sides: [&Station; 2], low: [f64; 2], high: [f64; 2]) {
    let [left, right] = [0, 1].map(|k| -> Vec<(f64, u32)> {
        let inside = |(v, _): &&(f64, u32)| low[k] <= *v && *v <= high[k];
        sides[k].vertices.iter().filter(inside).copied().collect()
    });
    let (mut i, mut j) = (0, 0);
    loop {
        let (Some(a), Some(b)) = (left.get(i), right.get(j)) else {
            return;
        };
        match (left.get(i + 1), right.get(j + 1)) {
            (None, None) => return,
            (Some(up), next) if next.is_none_or(|next| up.0 < next.0) => {
                triangles.push([a.1, b.1, up.1]);
                i += 1;
            }
            (_, Some(up)) => {
                triangles.push([a.1, b.1, up.1]);
                j += 1;
            }
            (Some(_), None) => return,
        }
    }
}
