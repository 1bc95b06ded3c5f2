//! Meshes of ruled patches with openings.
//!
//! All corners of the borders of openings lie on rulings of the mesh. Between two neighbouring rulings the borders are lines
//! from one to the other that do not cross, and every second strip between them is open: the patch is a row of bands, from
//! the first rail to the lowest line, from the second line to the third, and so on to the second rail. Each band is a row of
//! triangles between its vertices on both rulings.

use super::grid::ruling_parameters;
use super::{Mesh, check_count, number};
use crate::error::{ExchangeError, Result};
use torse_geometry::Rails;
use torse_geometry::vector::{cross, lerp, sub, unit};

/// Parameters nearer to one another are one ruling.
const SAME_RULING: f64 = 1e-12;

/// A ruling of the mesh with its vertices: share of the ruling and number.
struct Station {
    vertices: Vec<(f64, u32)>,
}

/// Borders between neighbouring rulings, and what stands on each ruling.
struct Strips {
    /// For each two neighbours the shares of both between which a border runs.
    lines: Vec<Vec<[f64; 2]>>,
    /// The shares of each ruling at which borders meet it.
    shares: Vec<Vec<f64>>,
}

impl Mesh {
    /// The mesh of a ruled patch as [`Mesh::ruled`] makes it, without its openings. `borders` are polygons of places: the
    /// parameter of a ruling and the share of it, from 0 to 1. Together they bound what is open: each is closed (its first place
    /// is its last), or begins and ends on the first or the last ruling; none crosses itself or another.
    ///
    /// # Errors
    /// As [`Mesh::ruled`], and [`ExchangeError::OutOfRange`] for an opening that leaves the patch or is not closed.
    ///
    /// ```
    /// use torse_exchange::Mesh;
    /// use torse_geometry::{Bernstein, Curve, RuledSurface};
    /// let rail = |y: f64| Curve::new(Bernstein, vec![[0.0, y, 0.0], [4.0, y, 0.0]]);
    /// let plate = RuledSurface::new(rail(0.0)?, rail(3.0)?);
    /// // A rhombus with diagonals two and one; half of another at the last ruling.
    /// let [low, high] = [1.0 / 3.0, 2.0 / 3.0];
    /// let rhombus = vec![[0.25, 0.5], [0.5, low], [0.75, 0.5], [0.5, high], [0.25, 0.5]];
    /// let half = vec![[1.0, high], [0.875, 0.5], [1.0, low]];
    /// let mesh = Mesh::ruled_with_openings(&plate, 1e-3, &[rhombus, half])?;
    /// assert!((mesh.area() - (12.0 - 1.0 - 0.25)).abs() < 1e-12);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn ruled_with_openings(
        patch: &impl Rails<f64>,
        tolerance: f64,
        borders: &[Vec<[f64; 2]>],
    ) -> Result<Self> {
        let mut places = ruling_parameters(patch, tolerance)?;
        for (name, axis) in [
            ("ruling of an opening", 0),
            ("share of a ruling in an opening", 1),
        ] {
            let mut values = borders.iter().flatten().map(|place| place[axis]);
            if let Some(value) = values.find(|value| !(0.0..=1.0).contains(value)) {
                let range = "[0, 1]";
                return Err(ExchangeError::OutOfRange { name, value, range });
            }
        }
        places.extend(borders.iter().flatten().map(|place| place[0]));
        places.sort_by(f64::total_cmp);
        places.dedup_by(|a, b| (*a - *b).abs() <= SAME_RULING);
        let strips = strips(&places, borders);
        let (mut vertices, mut normals) = (Vec::new(), Vec::new());
        let mut stations: Vec<Station> = Vec::with_capacity(places.len());
        for (x, met) in places.iter().zip(&strips.shares) {
            let [[p, dp], [q, dq]] = patch.ends_and_slopes(x)?;
            let ruling = sub(&q, &p);
            let mut shares = vec![0.0, 1.0];
            shares.extend(met);
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
                vertices: numbered.map(|(v, n)| (v, number(n))).collect(),
            });
        }
        let mut triangles = Vec::new();
        for ((pair, lines), x) in stations.windows(2).zip(&strips.lines).zip(&places) {
            let [left, right] = pair else { continue };
            let mut lines = lines.clone();
            lines.sort_by(|a, b| (a[0] + a[1]).total_cmp(&(b[0] + b[1])));
            if lines.len() % 2 == 1 {
                let (name, range) = ("ruling at which an opening is not closed", "none");
                let value = *x;
                return Err(ExchangeError::OutOfRange { name, value, range });
            }
            let mut low = [0.0; 2];
            for pair in lines.chunks_exact(2) {
                band(&mut triangles, [left, right], low, pair[0]);
                low = pair[1];
            }
            band(&mut triangles, [left, right], low, [1.0; 2]);
        }
        Self::with_normals(vertices, normals, triangles)
    }
}

/// Returns what borders are between rulings at these places, which hold all of their corners.
fn strips(places: &[f64], borders: &[Vec<[f64; 2]>]) -> Strips {
    let mut strips = Strips {
        lines: vec![Vec::new(); places.len().saturating_sub(1)],
        shares: vec![Vec::new(); places.len()],
    };
    let station = |x: f64| places.partition_point(|place| *place < x - SAME_RULING);
    for side in borders.iter().flat_map(|border| border.windows(2)) {
        let [mut a, mut b] = [side[0], side[1]].map(|[x, v]| (station(x), v));
        if a.0 > b.0 {
            (a, b) = (b, a);
        }
        let at = |k: usize| places.get(k).copied().unwrap_or_default();
        let (from, to) = (at(a.0), at(b.0));
        let share = |k: usize| match k {
            k if k == a.0 => a.1,
            k if k == b.0 => b.1,
            k => a.1 + (at(k) - from) / (to - from) * (b.1 - a.1),
        };
        for (k, list) in strips.lines.iter_mut().enumerate().take(b.0).skip(a.0) {
            list.push([share(k), share(k + 1)]);
        }
        for (k, list) in strips.shares.iter_mut().enumerate().take(b.0 + 1).skip(a.0) {
            list.push(share(k));
        }
        if a.0 == b.0 {
            // Along a ruling both ends are corners.
            if let Some(list) = strips.shares.get_mut(a.0) {
                list.push(b.1);
            }
        }
    }
    strips
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
