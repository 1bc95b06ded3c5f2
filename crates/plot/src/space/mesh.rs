//! Solids prepared for the raster: clipped to the box, projected, in samples.

use crate::colour::{Colour, Line};
use crate::ink::scene::Rect;
use crate::space::camera::Projection;
use crate::space::clip::{BoxBounds, clip_curve, clip_triangle, contains};
use crate::space::corner::Corner;
use crate::space::dash::dashes;
use crate::space::grid::Grid;
use crate::space::raster::{Material, Mesh, Segment, Triangle, Vertex};
use crate::space::shade::Finish;
use crate::space::vector::{V3, add, cross, sub, times, unit};
use crate::space::view::{Border, Paint, Solid, Surface, View};

/// Radius of a marked point and of a vertex of a control net, in pixels.
const POINT: f64 = 3.4;
const KNOT: f64 = 2.3;

/// Builds the [`Mesh`] of a view.
pub(crate) struct Builder<'a> {
    pub projection: &'a Projection,
    pub bounds: &'a BoxBounds,
    /// The part of the page that is rasterised, and samples per pixel.
    pub page: Rect,
    pub fine: f64,
    /// Values at the ends of the colour map.
    pub range: [f64; 2],
}

impl Builder<'_> {
    pub(crate) fn build(&self, view: &View) -> Mesh {
        let mut mesh = Mesh {
            map: view.scale.map.table::<256>(),
            ..Mesh::default()
        };
        for solid in &view.solids {
            match solid {
                Solid::Surface(surface) => self.surface(&mut mesh, surface),
                Solid::Curve { points, line, .. } => self.curve(&mut mesh, points, *line),
                Solid::Net { grid, line, .. } => self.net(&mut mesh, grid, *line),
                Solid::Points { points, colour, .. } => {
                    points
                        .iter()
                        .for_each(|&p| self.point(&mut mesh, p, *colour, POINT));
                }
                Solid::Arrow { from, to, line } => self.arrow(&mut mesh, *from, *to, *line),
                Solid::Note { .. } => {}
            }
        }
        mesh
    }

    fn to_samples(&self, p: V3) -> V3 {
        let [x, y, near] = self.projection.apply(p);
        [
            (x - self.page.x) * self.fine,
            (y - self.page.y) * self.fine,
            near * self.fine,
        ]
    }

    fn surface(&self, mesh: &mut Mesh, surface: &Surface) {
        let grid = &surface.grid;
        let material = mesh.materials.len() as u32;
        let (sides, finish) = match &surface.paint {
            Paint::TwoSided { front, back } => {
                (Some([front.linear(), back.linear()]), Finish::Glossy)
            }
            Paint::Values(_) => (None, Finish::Matt),
        };
        mesh.materials.push(Material {
            sides,
            finish,
            opacity: surface.opacity as f32,
            cells: [surface.lines.u, surface.lines.v].map(|n| if n > 1 { n as f32 } else { 0.0 }),
            border: surface.border == Border::Drawn,
        });
        let corners = self.corners(surface);
        let at = |i: usize, j: usize| corners.get(i * grid.columns() + j).copied();
        for i in 0..grid.rows() - 1 {
            for j in 0..grid.columns() - 1 {
                let (Some(a), Some(b), Some(c), Some(d)) =
                    (at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1))
                else {
                    continue;
                };
                for triangle in [[a, b, c], [a, c, d]] {
                    clip_triangle(triangle, self.bounds, |t| self.triangle(mesh, t, material));
                }
            }
        }
    }

    fn corners(&self, surface: &Surface) -> Vec<Corner> {
        let grid = &surface.grid;
        let normals = surface.normals.clone().unwrap_or_else(|| grid.normals());
        let [low, high] = self.range;
        let value = |index: usize| match &surface.paint {
            Paint::Values(values) => values.get(index).map_or(0.0, |v| (v - low) / (high - low)),
            Paint::TwoSided { .. } => 0.0,
        };
        let (last_row, last_column) = ((grid.rows() - 1) as f64, (grid.columns() - 1) as f64);
        let points = grid.points().iter().zip(normals).enumerate();
        points
            .map(|(index, (&at, normal))| {
                let (i, j) = (index / grid.columns(), index % grid.columns());
                Corner {
                    at,
                    normal: unit(normal).unwrap_or_default(),
                    uv: [i as f64 / last_row, j as f64 / last_column],
                    value: value(index),
                }
            })
            .collect()
    }

    fn triangle(&self, mesh: &mut Mesh, triangle: [Corner; 3], material: u32) {
        let vertices = triangle.map(|c| Vertex {
            at: self.to_samples(c.at),
            normal: self.projection.turn(c.normal).map(|x| x as f32),
            uv: c.uv.map(|x| x as f32),
            value: c.value as f32,
        });
        mesh.triangles.push(Triangle { vertices, material });
    }

    fn chain(&self, points: &[V3]) -> Vec<[V3; 2]> {
        let pieces = clip_curve(points, self.bounds);
        pieces
            .into_iter()
            .map(|ends| ends.map(|p| self.to_samples(p)))
            .collect()
    }

    fn curve(&self, mesh: &mut Mesh, points: &[V3], line: Line) {
        let pattern: Vec<f64> = line
            .dash
            .pattern()
            .iter()
            .map(|d| f64::from(*d) * line.width * self.fine)
            .collect();
        let radius = 0.5 * line.width * self.fine;
        let strokes = dashes(&self.chain(points), &pattern);
        mesh.segments
            .extend(strokes.into_iter().map(|ends| Segment {
                ends,
                radii: [radius; 2],
                colour: line.colour.linear(),
            }));
    }

    fn net(&self, mesh: &mut Mesh, grid: &Grid, line: Line) {
        for i in 0..grid.rows() {
            let row: Vec<V3> = (0..grid.columns()).map(|j| grid.at(i, j)).collect();
            self.curve(mesh, &row, line);
        }
        for j in 0..grid.columns() {
            let column: Vec<V3> = (0..grid.rows()).map(|i| grid.at(i, j)).collect();
            self.curve(mesh, &column, line);
        }
        for &p in grid.points() {
            self.point(mesh, p, line.colour, KNOT);
        }
    }

    fn point(&self, mesh: &mut Mesh, p: V3, colour: Colour, radius: f64) {
        if contains(self.bounds, p) {
            let at = self.to_samples(p);
            mesh.segments.push(Segment {
                ends: [at, at],
                radii: [radius * self.fine; 2],
                colour: colour.linear(),
            });
        }
    }

    /// A shaft and a cone.
    fn arrow(&self, mesh: &mut Mesh, from: V3, to: V3, line: Line) {
        let [a, b] = [from, to].map(|p| self.to_samples(p));
        let length = libm::hypot(b[0] - a[0], b[1] - a[1]);
        let head = ((6.0 + 2.0 * line.width) * self.fine).min(0.6 * length);
        if !(length > 0.0 && contains(self.bounds, from) && contains(self.bounds, to)) {
            return self.curve(mesh, &[from, to], line);
        }
        let neck = add(from, times(sub(to, from), 1.0 - head / length));
        self.curve(mesh, &[from, neck], line);
        mesh.segments.push(Segment {
            ends: [self.to_samples(neck), b],
            radii: [0.34 * head, 0.0],
            colour: line.colour.linear(),
        });
    }
}

/// Area vectors of the cells of all surfaces, for the choice of a view.
pub(crate) fn area_vectors(solids: &[Solid]) -> Vec<V3> {
    let mut areas = Vec::new();
    for solid in solids {
        let Solid::Surface(Surface { grid, opacity, .. }) = solid else {
            continue;
        };
        if *opacity < 1.0 {
            continue;
        }
        for i in 0..grid.rows() - 1 {
            for j in 0..grid.columns() - 1 {
                let across = sub(grid.at(i + 1, j + 1), grid.at(i, j));
                areas.push(cross(across, sub(grid.at(i, j + 1), grid.at(i + 1, j))));
            }
        }
    }
    areas
}
