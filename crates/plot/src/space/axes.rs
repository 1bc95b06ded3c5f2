//! The stage: rear walls with grid lines, ticks and titles on the edges in front of them.

use crate::colour::{Colour, Line};
use crate::error::FigureError;
use crate::ink::chart::{TEXT_SIZE, TICK_SIZE};
use crate::ink::scene::{Align, Item, Scene, Turn, polygon, polyline};
use crate::ink::ticks::Ticks;
use crate::ink::typeset::typeset;
use crate::space::camera::Projection;
use crate::space::clip::BoxBounds;
use crate::space::vector::V3;

const WALL: Colour = Colour::rgb(0xf5, 0xf6, 0xf8);
const GRID: Line = Line::solid(Colour::rgb(0xd9, 0xdc, 0xe1), 0.7);
const RIM: Line = Line::solid(Colour::rgb(0xb4, 0xb8, 0xbf), 0.8);
const EDGE: Line = Line::solid(Colour::INK, 0.8);
/// One tick per this many pixels.
const PER_TICK: f64 = 36.0;
/// Two labels stand apart if they are this many pixels apart across, or up and down.
const APART: [f64; 2] = [32.0, 15.0];
const TICK: f64 = 4.5;
/// Maximum length, in pixels, of an edge without ticks.
const SHORTEST: f64 = 24.0;

/// The box around the solids and its ticks.
pub(crate) struct StageBox<'a> {
    projection: &'a Projection,
    bounds: &'a BoxBounds,
    /// Index of the far end of each axis: 0 low, 1 high.
    far: [usize; 3],
    ticks: [Ticks; 3],
}

impl<'a> StageBox<'a> {
    pub(crate) fn new(projection: &'a Projection, bounds: &'a BoxBounds) -> StageBox<'a> {
        let away = projection.axes.away;
        StageBox {
            projection,
            bounds,
            far: away.map(|c| usize::from(c > 0.0)),
            ticks: [0, 1, 2].map(|k| {
                let [low, high] = bounds[k];
                let mut ends = [[0.0; 3]; 2];
                (ends[0][k], ends[1][k]) = (low, high);
                let [a, b] = ends.map(|p| projection.apply(p));
                let run = [0, 1].map(|c| (b[c] - a[c]).abs());
                let wanted = (libm::hypot(run[0], run[1]) / PER_TICK).min(8.0);
                let gaps = (run[0] / APART[0]).max(run[1] / APART[1]);
                Ticks::new(low, high, wanted, gaps + 1.0)
            }),
        }
    }

    fn place(&self, p: V3) -> [f64; 2] {
        let [x, y, _] = self.projection.apply(p);
        [x, y]
    }

    /// The corner of the box with the given ends.
    fn corner(&self, ends: [usize; 3]) -> V3 {
        [0, 1, 2].map(|k| self.bounds[k][ends[k]])
    }

    /// How far ticks and titles reach beyond the box: left, top, right, below.
    pub(crate) fn overhang(&self, titles: &[String; 3]) -> Result<[f64; 4], FigureError> {
        let mut trial = Scene::new(1, 1);
        self.draw_ticks(&mut trial, titles)?;
        let mut page = Extent::default();
        for n in 0..8 {
            page.add(self.place(self.corner([n & 1, n >> 1 & 1, n >> 2])), 1.0);
        }
        let mut all = page;
        for item in &trial.items {
            let Item::Type { glyphs, .. } = item else {
                continue;
            };
            for g in glyphs {
                // A box around any glyph: half an em about the middle of a capital.
                all.add([g.x + 0.3 * g.size, g.y - 0.3 * g.size], 0.5 * g.size);
            }
        }
        let ([left, top], [right, below]) = (
            [0, 1].map(|k| page.low[k] - all.low[k]),
            [0, 1].map(|k| all.high[k] - page.high[k]),
        );
        Ok([left, top, right, below].map(|room| room + 2.0))
    }

    /// Walls and grid lines, behind everything.
    pub(crate) fn draw_walls(&self, scene: &mut Scene) {
        let corner = |ends: [usize; 3]| self.place(self.corner(ends));
        for wall in 0..3 {
            let (i, j) = ((wall + 1) % 3, (wall + 2) % 3);
            let corners = [[0, 0], [1, 0], [1, 1], [0, 1]].map(|[a, b]| {
                let mut ends = self.far;
                (ends[i], ends[j]) = (a, b);
                corner(ends)
            });
            scene.fill(polygon(&corners), WALL, 1.0);
            for (along, across) in [(i, j), (j, i)] {
                for &t in &self.ticks[along].at {
                    let line = [0, 1].map(|end| {
                        let mut p = self.corner(self.far);
                        p[along] = t;
                        p[across] = self.bounds[across][end];
                        self.place(p)
                    });
                    scene.stroke(polyline(&line), GRID);
                }
            }
            scene.stroke(polygon(&corners), RIM);
        }
    }

    /// The ends of the edge that carries the ticks of axis `k`: the near edge of a rear wall. For the vertical
    /// axis, the one further left.
    fn edge(&self, k: usize) -> [usize; 3] {
        let near = self.far.map(|f| 1 - f);
        let mut ends = self.far;
        match k {
            0 => ends[1] = near[1],
            1 => ends[0] = near[0],
            _ => {
                let [a, b] = [[near[0], self.far[1], 0], [self.far[0], near[1], 0]];
                let left = |e| self.place(self.corner(e))[0];
                ends = if left(a) <= left(b) { a } else { b };
            }
        }
        ends
    }

    /// Ticks, their labels and the titles.
    pub(crate) fn draw_ticks(
        &self,
        scene: &mut Scene,
        titles: &[String; 3],
    ) -> Result<(), FigureError> {
        let centre = self.place([0, 1, 2].map(|k| (self.bounds[k][0] + self.bounds[k][1]) / 2.0));
        for (k, title) in titles.iter().enumerate() {
            let ends = self.edge(k);
            let at = |v: f64| {
                let mut p = self.corner(ends);
                p[k] = v;
                self.place(p)
            };
            let [a, b] = self.bounds[k].map(at);
            let run = [b[0] - a[0], b[1] - a[1]];
            let length = libm::hypot(run[0], run[1]);
            if length < SHORTEST {
                continue;
            }
            scene.stroke(polyline(&[a, b]), EDGE);
            // Perpendicular to the edge on the page, away from the box.
            let middle = [(a[0] + b[0]) / 2.0, (a[1] + b[1]) / 2.0];
            let normal = [-run[1] / length, run[0] / length];
            let outward = normal[0] * (middle[0] - centre[0]) + normal[1] * (middle[1] - centre[1]);
            let out = if outward >= 0.0 {
                normal
            } else {
                normal.map(|c| -c)
            };
            let shift = |p: [f64; 2], d: f64| [p[0] + d * out[0], p[1] + d * out[1]];
            let mut widest = 0.0f64;
            for (&value, label) in self.ticks[k].at.iter().zip(&self.ticks[k].labels) {
                let foot = at(value);
                scene.stroke(polyline(&[foot, shift(foot, TICK)]), EDGE);
                let line = typeset(label, TICK_SIZE)?;
                let reach = half_extent(line.width, line.cap_height(), out);
                scene.set(
                    &line,
                    shift(foot, TICK + 3.5 + reach),
                    Align::Centre,
                    Turn::Across,
                    0.0,
                );
                widest = widest.max(2.0 * reach);
            }
            let line = typeset(&self.ticks[k].title(title), TEXT_SIZE)?;
            let reach = half_extent(line.width, line.cap_height(), out);
            let place = shift(middle, TICK + 3.5 + widest + 6.0 + reach);
            scene.set(&line, place, Align::Centre, Turn::Across, 0.0);
        }
        Ok(())
    }
}

/// A growing rectangle.
#[derive(Clone, Copy)]
struct Extent {
    low: [f64; 2],
    high: [f64; 2],
}

impl Default for Extent {
    fn default() -> Self {
        Extent {
            low: [f64::INFINITY; 2],
            high: [f64::NEG_INFINITY; 2],
        }
    }
}

impl Extent {
    fn add(&mut self, at: [f64; 2], reach: f64) {
        for (k, c) in at.into_iter().enumerate() {
            self.low[k] = self.low[k].min(c - reach);
            self.high[k] = self.high[k].max(c + reach);
        }
    }
}

/// How far a box of the given size reaches from its centre in direction `out`.
fn half_extent(width: f64, height: f64, out: [f64; 2]) -> f64 {
    0.5 * (width * out[0].abs() + height * out[1].abs())
}
