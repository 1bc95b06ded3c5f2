//! Quadrilateral grids of surfaces with normals.

use torse_geometry::surface::Surface;
use torse_geometry::vector::unit;
use torse_geometry::{GeometryError, Result};

/// A grid mesh: vertices with unit normals, and quadrilaterals, counter-clockwise seen from the tip of
/// the normal `S_u x S_v`.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Mesh {
    /// The vertices.
    pub vertices: Vec<[f64; 3]>,
    /// The unit normals at the vertices; zero where the surface has none (an apex, a pole).
    pub normals: Vec<[f64; 3]>,
    /// Vertex indices of the quadrilaterals.
    pub quads: Vec<[u32; 4]>,
}

impl Mesh {
    /// The mesh of `(u_cells + 1) x (v_cells + 1)` vertices at equal parameter steps.
    ///
    /// # Errors
    /// [`GeometryError::OutOfRange`] for no cells or more vertices than an index can name, and what the
    /// surface refuses.
    ///
    /// ```
    /// use torse_exchange::Mesh;
    /// use torse_geometry::{Curve, Gbt, TensorSurface};
    /// let directrix = Curve::new(Gbt::new(0.0, 0.0)?, vec![[1.0, 0.0, 0.0], [1.0, 1.0, 0.0], [0.0, 1.0, 0.0]])?;
    /// let cylinder = TensorSurface::cylinder(&directrix, &[0.0, 0.0, 1.0], &2.0)?;
    /// let mesh = Mesh::of(&cylinder, 8, 2)?;
    /// assert_eq!((mesh.vertices.len(), mesh.quads.len(), mesh.triangles().count()), (27, 16, 32));
    /// // On the unit cylinder the normal is the direction of the point itself.
    /// let (p, n) = (mesh.vertices[10], mesh.normals[10]);
    /// assert!((p[0] - n[0]).abs() < 1e-14 && (p[1] - n[1]).abs() < 1e-14);
    /// # Ok::<(), torse_geometry::GeometryError>(())
    /// ```
    pub fn of(surface: &impl Surface<f64>, u_cells: usize, v_cells: usize) -> Result<Self> {
        let count = u_cells
            .checked_add(1)
            .zip(v_cells.checked_add(1))
            .and_then(|(m, n)| m.checked_mul(n));
        let fits = count.filter(|&n| u32::try_from(n).is_ok() && u_cells > 0 && v_cells > 0);
        let Some(count) = fits else {
            return Err(GeometryError::OutOfRange {
                name: "cells of a mesh",
                value: crate::error::count(u_cells) * crate::error::count(v_cells),
                range: "at least 1 x 1, below 2^32 vertices",
            });
        };
        let mut mesh = Self {
            vertices: Vec::with_capacity(count),
            normals: Vec::with_capacity(count),
            quads: Vec::with_capacity(u_cells * v_cells),
        };
        #[allow(clippy::cast_precision_loss)]
        let at = |i: usize, cells: usize| i as f64 / cells as f64;
        for i in 0..=u_cells {
            for j in 0..=v_cells {
                let partials = surface.partials(&at(i, u_cells), &at(j, v_cells), 1)?;
                mesh.vertices.push(*partials.point());
                mesh.normals
                    .push(unit(&partials.normal()).unwrap_or_default());
            }
        }
        let index = |i: usize, j: usize| u32::try_from(i * (v_cells + 1) + j).unwrap_or(u32::MAX);
        for i in 0..u_cells {
            for j in 0..v_cells {
                mesh.quads.push([
                    index(i, j),
                    index(i + 1, j),
                    index(i + 1, j + 1),
                    index(i, j + 1),
                ]);
            }
        }
        Ok(mesh)
    }

    /// The triangles: two for each quadrilateral.
    pub fn triangles(&self) -> impl Iterator<Item = [u32; 3]> {
        self.quads
            .iter()
            .flat_map(|&[a, b, c, d]| [[a, b, c], [a, c, d]])
    }

    /// The corners of the triangles, skipping any whose index is out of range.
    pub(crate) fn corners(&self) -> impl Iterator<Item = [[f64; 3]; 3]> {
        self.triangles().filter_map(|t| {
            let at = |i: u32| self.vertices.get(usize::try_from(i).ok()?).copied();
            Some([at(t[0])?, at(t[1])?, at(t[2])?])
        })
    }

    /// Appends another mesh, for chains of patches.
    ///
    /// # Errors
    /// [`GeometryError::OutOfRange`] when the vertices no longer fit 32-bit indices.
    pub fn append(&mut self, other: &Self) -> Result<()> {
        let total = self.vertices.len() + other.vertices.len();
        let (Ok(offset), Ok(_)) = (u32::try_from(self.vertices.len()), u32::try_from(total)) else {
            return Err(GeometryError::OutOfRange {
                name: "vertices of a mesh",
                value: crate::error::count(total),
                range: "below 2^32",
            });
        };
        self.vertices.extend_from_slice(&other.vertices);
        self.normals.extend_from_slice(&other.normals);
        self.quads.extend(
            other
                .quads
                .iter()
                .map(|q| q.map(|i| i.saturating_add(offset))),
        );
        Ok(())
    }
}
