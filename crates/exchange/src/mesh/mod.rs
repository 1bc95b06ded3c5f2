//! Triangle meshes of surfaces, without triangles of no area and with a unit normal at every vertex.

mod grid;
mod openings;
mod solid;

use crate::error::{ExchangeError, Result};
use std::collections::HashMap;
use torse_geometry::vector::{add, cross, dot, norm, scale, sub, unit};

/// The most vertices of a mesh.
pub const MAX_VERTICES: usize = 1 << 24;

/// A triangle mesh in millimetres: vertices with unit normals, and triangles that run counter-clockwise seen
/// from the tip of the normal.
///
/// What cannot be written to a file is refused or mended where the mesh is made: numbers are finite, every
/// triangle has an area, every vertex belongs to a triangle, every normal has length one.
///
/// ```
/// use torse_exchange::Mesh;
/// use torse_geometry::{Bernstein, Curve, RuledSurface};
/// // A cone with its apex as a rail: half of the triangles at the apex have no area and are left out.
/// let apex = Curve::new(Bernstein, vec![[0.0, 0.0, 2.0]; 3])?;
/// let base = Curve::new(Bernstein, vec![[1.0, 0.0, 0.0], [1.0, 1.0, 0.0], [0.0, 1.0, 0.0]])?;
/// let mesh = Mesh::sample(&RuledSurface::new(apex, base), 8, 3)?;
/// assert_eq!(mesh.triangles().len(), 8 * (1 + 2 + 2));
/// assert!(mesh.normals().iter().all(|n| (n.iter().map(|x| x * x).sum::<f64>() - 1.0).abs() < 1e-14));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Mesh {
    vertices: Vec<[f64; 3]>,
    normals: Vec<[f64; 3]>,
    triangles: Vec<[u32; 3]>,
}

impl Mesh {
    /// The mesh of these vertices and triangles, with the mean normal of the triangles at each vertex.
    ///
    /// # Errors
    /// [`ExchangeError::NotFinite`], [`ExchangeError::NoVertex`], [`ExchangeError::TooMany`].
    pub fn new(vertices: Vec<[f64; 3]>, triangles: Vec<[u32; 3]>) -> Result<Self> {
        let normals = vec![[0.0; 3]; vertices.len()];
        Self::with_normals(vertices, normals, triangles)
    }

    /// The mesh with these normals; one that is zero (where the surface has none: an apex, a pole) is
    /// replaced by the mean normal of the triangles there.
    ///
    /// # Errors
    /// As [`Mesh::new`], and [`ExchangeError::Length`] unless there is a normal for each vertex.
    pub fn with_normals(
        vertices: Vec<[f64; 3]>,
        normals: Vec<[f64; 3]>,
        triangles: Vec<[u32; 3]>,
    ) -> Result<Self> {
        if normals.len() != vertices.len() {
            return Err(ExchangeError::Length {
                what: "normals",
                expected: vertices.len(),
                given: normals.len(),
            });
        }
        check_count(vertices.len())?;
        for (what, list) in [("vertex", &vertices), ("normal", &normals)] {
            for (index, point) in list.iter().enumerate() {
                if let Some(&value) = point.iter().find(|x| !x.is_finite()) {
                    return Err(ExchangeError::NotFinite { what, index, value });
                }
            }
        }
        let mut means = vec![[0.0; 3]; vertices.len()];
        let mut firsts = vec![None; vertices.len()];
        let mut kept = Vec::with_capacity(triangles.len());
        for (triangle, corners) in triangles.into_iter().enumerate() {
            let mut points = [[0.0; 3]; 3];
            for (point, index) in points.iter_mut().zip(corners) {
                let missing = ExchangeError::NoVertex { triangle, index };
                *point = *vertices.get(place(index)).ok_or(missing)?;
            }
            let Some((direction, area)) = area_vector(&points) else {
                continue;
            };
            for index in corners {
                if let Some(mean) = means.get_mut(place(index)) {
                    *mean = add(mean, &scale(&area, &direction));
                }
                if let Some(first) = firsts.get_mut(place(index)) {
                    first.get_or_insert(direction);
                }
            }
            kept.push(corners);
        }
        let mut mesh = Self::default();
        let mut numbers = HashMap::new();
        for corners in kept {
            let mut renamed = [0; 3];
            for (slot, index) in renamed.iter_mut().zip(corners) {
                let fresh = number(mesh.vertices.len());
                *slot = *numbers.entry(index).or_insert(fresh);
                if *slot != fresh {
                    continue;
                }
                let at = |list: &[[f64; 3]]| list.get(place(index)).copied().unwrap_or_default();
                // The triangles of a vertex may cancel, but none of them is zero.
                let spare = firsts.get(place(index)).copied().flatten();
                let normal = unit(&at(&normals)).or_else(|| unit(&at(&means))).or(spare);
                mesh.vertices.push(at(&vertices));
                mesh.normals.push(normal.unwrap_or_default());
            }
            mesh.triangles.push(renamed);
        }
        Ok(mesh)
    }

    /// The vertices.
    #[must_use]
    pub fn vertices(&self) -> &[[f64; 3]] {
        &self.vertices
    }

    /// The unit normals at the vertices.
    #[must_use]
    pub fn normals(&self) -> &[[f64; 3]] {
        &self.normals
    }

    /// The vertex indices of the triangles.
    #[must_use]
    pub fn triangles(&self) -> &[[u32; 3]] {
        &self.triangles
    }

    /// The corners of the triangles.
    pub fn corners(&self) -> impl Iterator<Item = [[f64; 3]; 3]> {
        let at = |i: u32| self.vertices.get(place(i)).copied();
        self.triangles
            .iter()
            .filter_map(move |&[a, b, c]| Some([at(a)?, at(b)?, at(c)?]))
    }

    /// The sum of the areas of the triangles, in square millimetres.
    #[must_use]
    pub fn area(&self) -> f64 {
        let area = |t: [[f64; 3]; 3]| area_vector(&t).map_or(0.0, |(_, area)| area);
        self.corners().map(area).sum()
    }

    /// The volume that a closed mesh encloses (negative when it is inside out); of an open one the volume of
    /// the cone from the origin.
    #[must_use]
    pub fn volume(&self) -> f64 {
        self.corners()
            .map(|[a, b, c]| dot(&a, &cross(&b, &c)) / 6.0)
            .sum()
    }

    /// Appends another mesh, for chains of patches.
    ///
    /// # Errors
    /// [`ExchangeError::TooMany`].
    pub fn append(&mut self, other: &Self) -> Result<()> {
        check_count(self.vertices.len().saturating_add(other.vertices.len()))?;
        let offset = number(self.vertices.len());
        self.vertices.extend_from_slice(&other.vertices);
        self.normals.extend_from_slice(&other.normals);
        let moved = |t: &[u32; 3]| t.map(|i| i.saturating_add(offset));
        self.triangles.extend(other.triangles.iter().map(moved));
        Ok(())
    }
}

/// The unit normal and the area of a triangle; `None` when the area is not told from zero by rounding. The
/// largest edge is scaled to one first, so that no square under- or overflows.
fn area_vector([a, b, c]: &[[f64; 3]; 3]) -> Option<([f64; 3], f64)> {
    let half = |p: &[f64; 3]| p.map(|x| 0.5 * x);
    let (a, b, c) = (half(a), half(b), half(c));
    let edges = [sub(&b, &a), sub(&c, &a), sub(&c, &b)];
    let size = edges.iter().flatten().fold(0.0_f64, |m, x| m.max(x.abs()));
    if size == 0.0 {
        return None;
    }
    let [first, second, _] = edges.map(|e| e.map(|x| x / size));
    let normal = cross(&first, &second);
    let length = norm(&normal);
    let direction = unit(&normal).filter(|_| length > 8.0 * f64::EPSILON)?;
    Some((direction, 2.0 * length * size * size))
}

fn check_count(count: usize) -> Result<()> {
    if count <= MAX_VERTICES {
        return Ok(());
    }
    Err(ExchangeError::TooMany {
        what: "vertices",
        given: count,
        most: MAX_VERTICES,
    })
}

fn place(index: u32) -> usize {
    usize::try_from(index).unwrap_or(usize::MAX)
}

fn number(place: usize) -> u32 {
    u32::try_from(place).unwrap_or(u32::MAX)
}
