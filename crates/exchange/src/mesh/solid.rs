//! From surfaces to solids: welded seams, thickness, and whether a mesh is closed.

use super::{Mesh, check_count, number, place};
use crate::error::{ExchangeError, Result};
use std::collections::HashMap;
use torse_geometry::vector::{add, cross, norm, scale, sub, unit};

impl Mesh {
    /// The mesh with vertices at most `distance` apart made one (chains of vertices likewise follow the first
    /// of them), so that the seams of neighbouring patches close; normals are averaged there.
    ///
    /// # Errors
    /// [`ExchangeError::OutOfRange`] unless the distance is positive and not below the rounding of the
    /// coordinates.
    pub fn welded(&self, distance: f64) -> Result<Self> {
        let largest = self.vertices.iter().flatten();
        let largest = largest.fold(0.0_f64, |m, x| m.max(x.abs()));
        if !(distance.is_finite() && distance > f64::EPSILON * largest) {
            return Err(ExchangeError::OutOfRange {
                name: "welding distance",
                value: distance,
                range: "(2^-52 times the largest coordinate, inf)",
            });
        }
        // Cells as wide as the distance: partners are in the same cell or beside it.
        #[allow(clippy::cast_possible_truncation)]
        let cell = |p: &[f64; 3]| p.map(|x| (x / distance).floor() as i64);
        let mut cells: HashMap<[i64; 3], Vec<usize>> = HashMap::new();
        let (mut vertices, mut normals) = (Vec::<[f64; 3]>::new(), Vec::<[f64; 3]>::new());
        let mut names = Vec::with_capacity(self.vertices.len());
        for (point, normal) in self.vertices.iter().zip(&self.normals) {
            let home = cell(point);
            let near = |&&i: &&usize| {
                let other = vertices.get(i);
                other.is_some_and(|q| norm(&sub(point, q)) <= distance)
            };
            let partner = neighbours(home)
                .filter_map(|c| cells.get(&c))
                .flatten()
                .find(near)
                .copied();
            let index = partner.unwrap_or(vertices.len());
            match normals.get_mut(index) {
                Some(sum) => *sum = add(sum, normal),
                None => {
                    vertices.push(*point);
                    normals.push(*normal);
                    cells.entry(home).or_default().push(index);
                }
            }
            names.push(number(index));
        }
        let name = |i: u32| names.get(place(i)).copied().unwrap_or(u32::MAX);
        let triangles = self.triangles.iter().map(|t| t.map(name)).collect();
        Self::with_normals(vertices, normals, triangles)
    }

    /// The solid sheet of this thickness with the mesh as its middle surface: both faces half the thickness
    /// along the normals, and walls along the free edges. Neighbouring patches should be [welded](Mesh::welded)
    /// before.
    ///
    /// # Errors
    /// [`ExchangeError::OutOfRange`] unless the thickness is positive, [`ExchangeError::TooMany`].
    ///
    /// ```
    /// use torse_exchange::Mesh;
    /// let square = vec![[0.0; 3], [3.0, 0.0, 0.0], [3.0, 2.0, 0.0], [0.0, 2.0, 0.0]];
    /// let sheet = Mesh::new(square, vec![[0, 1, 2], [0, 2, 3]])?;
    /// let solid = sheet.thickened(0.5)?;
    /// assert!(!sheet.is_watertight() && solid.is_watertight());
    /// assert!((solid.volume() - 3.0).abs() < 1e-12 && (solid.area() - 17.0).abs() < 1e-12);
    /// # Ok::<(), torse_exchange::ExchangeError>(())
    /// ```
    pub fn thickened(&self, thickness: f64) -> Result<Self> {
        if !(thickness.is_finite() && thickness > 0.0) {
            return Err(ExchangeError::OutOfRange {
                name: "thickness",
                value: thickness,
                range: "(0, inf)",
            });
        }
        let half = 0.5 * thickness;
        let moved = |by: f64| {
            let along = move |(p, n): (&[f64; 3], &[f64; 3])| add(p, &scale(&by, n));
            self.vertices.iter().zip(&self.normals).map(along)
        };
        let count = number(self.vertices.len());
        let mut vertices: Vec<[f64; 3]> = moved(half).chain(moved(-half)).collect();
        let opposite = self.normals.iter().map(|n| n.map(|x| -x));
        let mut normals: Vec<[f64; 3]> = self.normals.iter().copied().chain(opposite).collect();
        let mut triangles = self.triangles.clone();
        triangles.extend(
            self.triangles
                .iter()
                .map(|&[a, b, c]| [c, b, a].map(|i| i.saturating_add(count))),
        );
        let border = free_edges(&self.triangles);
        check_count(vertices.len().saturating_add(4 * border.len()))?;
        for [a, b] in border {
            let at = |i: u32| vertices.get(place(i)).copied().unwrap_or_default();
            let (low_a, low_b) = (a.saturating_add(count), b.saturating_add(count));
            // Vertices of their own: the wall has other normals than the faces.
            let wall = [at(b), at(a), at(low_a), at(low_b)];
            let normal = unit(&cross(&sub(&wall[2], &wall[0]), &sub(&wall[3], &wall[1])));
            let first = number(vertices.len());
            triangles.extend([[0, 1, 2], [0, 2, 3]].map(|t| t.map(|i| first + i)));
            vertices.extend(wall);
            normals.extend([normal.unwrap_or_default(); 4]);
        }
        Self::with_normals(vertices, normals, triangles)
    }

    /// Whether the mesh bounds a solid: each edge belongs to two triangles, which run through it in opposite
    /// directions. Vertices at one place are one.
    #[must_use]
    pub fn is_watertight(&self) -> bool {
        let (_, triangles) = self.merged();
        let mut edges: HashMap<[u32; 2], usize> = HashMap::new();
        for edge in triangles.iter().flat_map(sides) {
            *edges.entry(edge).or_default() += 1;
        }
        let paired =
            |([a, b], count): (&[u32; 2], &usize)| *count == 1 && edges.get(&[*b, *a]) == Some(&1);
        !edges.is_empty() && edges.iter().all(paired)
    }

    /// Vertices at the same place made one (normals are lost), for formats whose meshes are closed by index.
    pub(crate) fn merged(&self) -> (Vec<[f64; 3]>, Vec<[u32; 3]>) {
        let mut places: HashMap<[u64; 3], u32> = HashMap::new();
        let mut vertices = Vec::new();
        let mut names = Vec::with_capacity(self.vertices.len());
        for point in &self.vertices {
            // Plus zero: a negative zero is the same place.
            let fresh = number(vertices.len());
            let index = *places
                .entry(point.map(|x| (x + 0.0).to_bits()))
                .or_insert(fresh);
            if index == fresh {
                vertices.push(*point);
            }
            names.push(index);
        }
        let name = |i: u32| names.get(place(i)).copied().unwrap_or(u32::MAX);
        let distinct = |t: &[u32; 3]| t[0] != t[1] && t[1] != t[2] && t[2] != t[0];
        let triangles = self.triangles.iter().map(|t| t.map(name));
        (vertices, triangles.filter(distinct).collect())
    }
}

fn sides(&[a, b, c]: &[u32; 3]) -> [[u32; 2]; 3] {
    [[a, b], [b, c], [c, a]]
}

/// The edges of one triangle only, in the order of the triangles.
fn free_edges(triangles: &[[u32; 3]]) -> Vec<[u32; 2]> {
    let all: std::collections::HashSet<[u32; 2]> = triangles.iter().flat_map(sides).collect();
    let free = |&[a, b]: &[u32; 2]| !all.contains(&[b, a]);
    triangles.iter().flat_map(sides).filter(free).collect()
}

/// A cell and the cells around it.
fn neighbours(home: [i64; 3]) -> impl Iterator<Item = [i64; 3]> {
    let near = move |axis: usize| {
        let centre = home[axis];
        (-1..=1).map(move |step: i64| centre.saturating_add(step))
    };
    near(0).flat_map(move |x| near(1).flat_map(move |y| near(2).map(move |z| [x, y, z])))
}
