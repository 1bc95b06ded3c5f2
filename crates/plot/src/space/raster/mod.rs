//! The z-buffer.
//!
//! Every output pixel holds `SAMPLES * SAMPLES` samples. Triangles carry normals, parameters and values to each sample;
//! lighting and parameter lines are computed there, so that shading is smooth and a line on a surface is hidden
//! exactly where the surface is. Translucent surfaces are kept aside as fragments and laid over the opaque sample
//! from far to near, whatever order they came in. Samples are averaged as light and become sRGB last.
//!
//! The picture is computed in bands, each by itself, in parallel; a band depends on nothing but the mesh, so the
//! result does not depend on the number of threads.

use rayon::prelude::*;

use crate::colour::Colour;
use crate::error::FigureError;
use crate::ink::scene::Pixels;
use crate::space::shade::{Finish, dot, shade};
use crate::space::vector::V3;

/// Samples per output pixel in each direction.
pub(crate) const SAMPLES: usize = 3;

/// Most samples one view may visit: some seconds of work.
pub const WORK_LIMIT: f64 = 2e9;

/// Output rows of a band.
const BAND: usize = 16;
/// Half widths in samples of parameter lines and borders.
const LINE: f32 = 2.6;
const EDGE: f32 = 5.0;
/// Lines take this much of the light of the surface below them.
const LINE_TINT: f32 = 0.36;
const EDGE_TINT: f32 = 0.12;

#[derive(Debug, Clone, Copy)]
pub(crate) struct Vertex {
    /// Samples right and down, nearness in samples.
    pub at: V3,
    /// Right, up, towards the viewer.
    pub normal: [f32; 3],
    pub uv: [f32; 2],
    /// Position in the colour map.
    pub value: f32,
}

#[derive(Debug, Clone, Copy)]
pub(crate) struct Triangle {
    pub vertices: [Vertex; 3],
    pub material: u32,
}

/// A straight stroke between two discs, towards the viewer of what lies at its depth.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Segment {
    pub ends: [V3; 2],
    pub radii: [f64; 2],
    pub colour: [f32; 3],
}

#[derive(Debug, Clone, Copy)]
pub(crate) struct Material {
    /// Linear colours of front and back; `None` takes the colour map.
    pub sides: Option<[[f32; 3]; 2]>,
    pub finish: Finish,
    pub opacity: f32,
    /// Parts into which parameter lines cut u and v; 0 for no lines.
    pub cells: [f32; 2],
    pub border: bool,
}

/// Everything to be rasterised.
#[derive(Debug, Clone, Default)]
pub(crate) struct Mesh {
    pub triangles: Vec<Triangle>,
    pub segments: Vec<Segment>,
    pub materials: Vec<Material>,
    /// The colour map.
    pub map: Vec<[f32; 3]>,
}

/// Rasterise at `width` by `height` output pixels.
pub(crate) fn render(mesh: &Mesh, width: u32, height: u32) -> Result<Pixels, FigureError> {
    let [w, h] = [width as usize * SAMPLES, height as usize * SAMPLES];
    let samples = work(mesh, w as f64, h as f64);
    if samples > WORK_LIMIT || samples.is_nan() {
        let limit = WORK_LIMIT;
        return Err(FigureError::TooMuchWork { samples, limit });
    }
    let bands: Vec<usize> = (0..height as usize).step_by(BAND).collect();
    let rows: Vec<Vec<u8>> = bands
        .into_par_iter()
        .map(|first| {
            let rows = BAND.min(height as usize - first);
            let mut band = Band::new(w, first * SAMPLES, rows * SAMPLES);
            band.draw(mesh);
            band.resolve()
        })
        .collect();
    Ok(Pixels {
        width,
        height,
        rgba: rows.concat(),
    })
}

/// Samples that will be visited, about.
fn work(mesh: &Mesh, w: f64, h: f64) -> f64 {
    let extent = |a: f64, b: f64, most: f64| (b.min(most) - a.max(0.0)).max(0.0);
    let triangles = mesh.triangles.iter().map(|t| {
        let [x, y] = [0, 1].map(|k| span(t.vertices.iter().map(|v| v.at[k])));
        8.0 + 0.6 * extent(x[0], x[1], w) * extent(y[0], y[1], h)
    });
    let segments = mesh.segments.iter().map(|s| {
        let [a, b] = s.ends;
        let r = s.radii[0].max(s.radii[1]);
        8.0 + 2.0 * (r + 1.0) * (libm::hypot(b[0] - a[0], b[1] - a[1]).min(w + h) + 2.0 * r)
    });
    triangles.sum::<f64>() + segments.sum::<f64>()
}

fn span(values: impl Iterator<Item = f64>) -> [f64; 2] {
    values.fold([f64::INFINITY, f64::NEG_INFINITY], |[l, h], v| {
        [l.min(v), h.max(v)]
    })
}

/// A translucent sample.
struct Fragment {
    index: usize,
    near: f32,
    colour: [f32; 3],
    opacity: f32,
}

#[derive(Clone, Copy)]
struct Sample {
    near: f32,
    colour: [f32; 3],
    opacity: f32,
}

const NOTHING: Sample = Sample {
    near: f32::NEG_INFINITY,
    colour: [0.0; 3],
    opacity: 0.0,
};

struct Band {
    width: usize,
    top: usize,
    height: usize,
    samples: Vec<Sample>,
    fragments: Vec<Fragment>,
}

impl Band {
    fn new(width: usize, top: usize, height: usize) -> Band {
        Band {
            width,
            top,
            height,
            samples: vec![NOTHING; width * height],
            fragments: Vec::new(),
        }
    }

    fn draw(&mut self, mesh: &Mesh) {
        for triangle in &mesh.triangles {
            if let Some(material) = mesh.materials.get(triangle.material as usize) {
                self.triangle(&triangle.vertices, material, &mesh.map);
            }
        }
        for segment in &mesh.segments {
            self.segment(segment);
        }
        self.blend();
    }

    /// Rows of the band between two heights; empty if they miss it or are not numbers.
    fn rows(&self, low: f64, high: f64) -> std::ops::Range<usize> {
        let top = self.top as f64;
        clamp_range(low - top, high - top, self.height)
    }

    fn triangle(&mut self, v: &[Vertex; 3], material: &Material, map: &[[f32; 3]]) {
        let [a, b, c] = v.map(|v| v.at);
        let area = (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
        if area.is_nan() || area.abs() <= 1e-9 {
            return;
        }
        let face = Face::new(v, area, material, map);
        let [y0, y1] = span([a[1], b[1], c[1]].into_iter());
        for row in self.rows(y0, y1) {
            let y = (self.top + row) as f64 + 0.5;
            for column in crossings([a, b, c], y, self.width) {
                let x = column as f64 + 0.5;
                let w = face.weights.map(|k| (k[0] * x + k[1] * y + k[2]) as f32);
                let near = (0..3).map(|k| f64::from(w[k]) * v[k].at[2]).sum::<f64>() as f32;
                let index = row * self.width + column;
                let Some(sample) = self.samples.get_mut(index) else {
                    continue;
                };
                if near <= sample.near {
                    continue;
                }
                let (colour, opacity) = face.light(v, w);
                if opacity >= 1.0 {
                    *sample = Sample {
                        near,
                        colour,
                        opacity,
                    };
                } else {
                    self.fragments.push(Fragment {
                        index,
                        near,
                        colour,
                        opacity,
                    });
                }
            }
        }
    }

    fn segment(&mut self, s: &Segment) {
        let [a, b] = s.ends;
        let [ra, rb] = s.radii;
        let d = [b[0] - a[0], b[1] - a[1]];
        let square = d[0] * d[0] + d[1] * d[1];
        let most = ra.max(rb);
        // Lies before the surface it runs on even where that is steep.
        let lift = 2.0 * most + SAMPLES as f64;
        let [y0, y1] = span([a[1] - ra, b[1] - rb, a[1] + ra, b[1] + rb].into_iter());
        for row in self.rows(y0, y1) {
            let y = (self.top + row) as f64 + 0.5;
            let [x0, x1] = self.reach(s, y, most);
            for column in clamp_range(x0, x1, self.width) {
                let x = column as f64 + 0.5;
                let t = if square > 0.0 {
                    (((x - a[0]) * d[0] + (y - a[1]) * d[1]) / square).clamp(0.0, 1.0)
                } else {
                    0.0
                };
                let distance = libm::hypot(x - a[0] - t * d[0], y - a[1] - t * d[1]);
                if distance > ra + t * (rb - ra) {
                    continue;
                }
                let near = (a[2] + t * (b[2] - a[2]) + lift) as f32;
                if let Some(sample) = self.samples.get_mut(row * self.width + column)
                    && near > sample.near
                {
                    *sample = Sample {
                        near,
                        colour: s.colour,
                        opacity: 1.0,
                    };
                }
            }
        }
    }

    /// Columns within `r` of the segment on the line at height `y`, or a few more.
    fn reach(&self, s: &Segment, y: f64, r: f64) -> [f64; 2] {
        let [a, b] = s.ends;
        let [low, high] = span([a[0], b[0]].into_iter());
        let rise = b[1] - a[1];
        if rise.abs() < 1e-9 {
            return [low - r, high + r];
        }
        let x_at = |y: f64| a[0] + ((y - a[1]) / rise).clamp(0.0, 1.0) * (b[0] - a[0]);
        let [from, to] = span([x_at(y - r), x_at(y + r)].into_iter());
        [from - r, to + r]
    }

    /// Lay translucent fragments over the opaque samples, far ones first.
    fn blend(&mut self) {
        let mut fragments = std::mem::take(&mut self.fragments);
        fragments.sort_by(|a, b| a.index.cmp(&b.index).then(a.near.total_cmp(&b.near)));
        for f in fragments {
            if let Some(sample) = self.samples.get_mut(f.index)
                && f.near > sample.near
            {
                let rest = 1.0 - f.opacity;
                // Colours in `sample` are weighted with its opacity.
                sample.colour =
                    [0, 1, 2].map(|k| f.opacity * f.colour[k] + rest * sample.colour[k]);
                sample.opacity = f.opacity + rest * sample.opacity;
            }
        }
    }

    /// Average the samples to pixels.
    fn resolve(&self) -> Vec<u8> {
        let (columns, rows) = (self.width / SAMPLES, self.height / SAMPLES);
        let mut rgba = Vec::with_capacity(columns * rows * 4);
        for y in 0..rows {
            for x in 0..columns {
                let (mut colour, mut opacity) = ([0.0f32; 3], 0.0f32);
                for dy in 0..SAMPLES {
                    let start = (y * SAMPLES + dy) * self.width + x * SAMPLES;
                    for sample in self.samples.iter().skip(start).take(SAMPLES) {
                        opacity += sample.opacity;
                        colour = [0, 1, 2].map(|k| colour[k] + sample.colour[k]);
                    }
                }
                let Colour { r, g, b } = Colour::from_linear(colour.map(|c| c / opacity.max(1e-6)));
                let alpha = (255.0 * opacity / (SAMPLES * SAMPLES) as f32).round() as u8;
                let pixel = if alpha == 0 { [0; 4] } else { [r, g, b, alpha] };
                rgba.extend(pixel);
            }
        }
        rgba
    }
}

/// Columns whose centres lie in the triangle on the line at height `y`. An edge is crossed at the same number
/// whichever triangle it belongs to, and intervals are half open: neighbours neither overlap nor leave a seam.
fn crossings(corners: [V3; 3], y: f64, most: usize) -> std::ops::Range<usize> {
    let [a, b, c] = corners;
    let crossed = [[a, b], [b, c], [c, a]].into_iter().filter_map(|[p, q]| {
        let [low, high] = if p[1] < q[1] { [p, q] } else { [q, p] };
        let t = (y - low[1]) / (high[1] - low[1]);
        (low[1] <= y && y < high[1]).then_some(low[0] + t * (high[0] - low[0]))
    });
    let [from, to] = span(crossed);
    let column = |x: f64| (x - 0.5).ceil().clamp(0.0, most as f64) as usize;
    column(from)..column(to)
}

/// Whole numbers k with `low <= k + 1/2 <= high` in `0..most`.
fn clamp_range(low: f64, high: f64, most: usize) -> std::ops::Range<usize> {
    let from = (low - 0.5).ceil().max(0.0);
    let to = ((high - 0.5).floor() + 1.0).min(most as f64);
    if from < to {
        from as usize..to as usize
    } else {
        0..0
    }
}

/// A triangle ready for its samples.
struct Face<'a> {
    /// Barycentric coordinate k at (x, y) is `weights[k] . (x, y, 1)`.
    weights: [[f64; 3]; 3],
    /// 1 if the front is seen, -1 for the back.
    side: f32,
    /// Change of u and of v per sample.
    slopes: [f32; 2],
    material: &'a Material,
    map: &'a [[f32; 3]],
}

impl<'a> Face<'a> {
    fn new(v: &[Vertex; 3], area: f64, material: &'a Material, map: &'a [[f32; 3]]) -> Face<'a> {
        let weights = [(1, 2), (2, 0), (0, 1)].map(|(i, j)| {
            let (p, q) = (v[i].at, v[j].at);
            let (dx, dy) = ((p[1] - q[1]) / area, (q[0] - p[0]) / area);
            [dx, dy, (p[0] * q[1] - q[0] * p[1]) / area]
        });
        let slopes = [0, 1].map(|k| {
            let along = |axis: usize| {
                (0..3)
                    .map(|i| f64::from(v[i].uv[k]) * weights[i][axis])
                    .sum::<f64>()
            };
            libm::hypot(along(0), along(1)) as f32
        });
        Face {
            weights,
            // The page is y downwards: a front, counterclockwise to the viewer, has negative area.
            side: if area < 0.0 { 1.0 } else { -1.0 },
            slopes,
            material,
            map,
        }
    }

    /// Light and opacity at barycentric `w`.
    fn light(&self, v: &[Vertex; 3], w: [f32; 3]) -> ([f32; 3], f32) {
        let mix = |f: fn(&Vertex) -> f32| w[0] * f(&v[0]) + w[1] * f(&v[1]) + w[2] * f(&v[2]);
        let mut n = [
            mix(|v| v.normal[0]),
            mix(|v| v.normal[1]),
            mix(|v| v.normal[2]),
        ]
        .map(|c| c * self.side);
        // Interpolation may turn a normal slightly away at the silhouette.
        n[2] = n[2].max(0.0);
        let length = dot(n, n).sqrt();
        let n = if length > 1e-6 {
            n.map(|c| c / length)
        } else {
            [0.0, 0.0, 1.0]
        };
        let albedo = match self.material.sides {
            Some([front, back]) => {
                if self.side > 0.0 {
                    front
                } else {
                    back
                }
            }
            None => {
                let last = self.map.len().saturating_sub(1) as f32;
                let k = (mix(|v| v.value).clamp(0.0, 1.0) * last).round() as usize;
                self.map.get(k).copied().unwrap_or_default()
            }
        };
        let colour = shade(n, albedo, self.material.finish);
        let uv = [mix(|v| v.uv[0]), mix(|v| v.uv[1])];
        let tint = self.tint(uv);
        let opacity = self.material.opacity;
        // Lines on a translucent surface are less translucent than the surface.
        let opacity = if tint < 1.0 { opacity.sqrt() } else { opacity };
        (colour.map(|c| c * tint), opacity)
    }

    /// Part of the light that a parameter line or border leaves at `uv`; 1 off all lines.
    fn tint(&self, uv: [f32; 2]) -> f32 {
        let mut tint = 1.0f32;
        for ((t, slope), cells) in uv.into_iter().zip(self.slopes).zip(self.material.cells) {
            if self.material.border && t.min(1.0 - t) < EDGE * slope {
                return EDGE_TINT;
            }
            let k = (t * cells).round();
            if cells > 0.0 && k > 0.0 && k < cells && (t - k / cells).abs() < LINE * slope {
                tint = LINE_TINT;
            }
        }
        tint
    }
}

#[cfg(test)]
mod tests;
