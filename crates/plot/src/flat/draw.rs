//! Drawing a [`Plot`] into a rectangle of the page.

use crate::colour::{Colour, Line};
use crate::error::FigureError;
use crate::flat::clip::{clip_polygon, clip_polyline};
use crate::flat::plot::{Aspect, Axis, Frame, GuideAxis, Layer, Plot};
use crate::ink::chart::{AxisSpec, TEXT_SIZE, draw_axes, label_room};
use crate::ink::scene::{Rect, Scene, polygon, polyline};
use crate::ink::ticks::Ticks;
use crate::legend::{Entries, Key, Legend, Marker, draw_marker};

/// One tick per this many pixels.
const PER_TICK: [f64; 2] = [62.0, 40.0];
/// A label needs this many pixels along the axes.
const PER_LABEL: [f64; 2] = [36.0, 18.0];

impl Plot {
    pub(crate) fn draw_in(
        &self,
        scene: &mut Scene,
        page: Rect,
        legend: Legend,
    ) -> Result<(), FigureError> {
        self.check()?;
        let entries = Entries::new(legend, &self.legend_entries(), page.w)?;
        let body = match legend {
            Legend::Right => page.inset([0.0, 0.0, entries.width, 0.0]),
            _ => page.inset([0.0, 0.0, 0.0, entries.height]),
        };
        let mut window = self.window()?;
        let inner = match self.frame {
            Frame::Bare => {
                self.widen(&mut window, body);
                body
            }
            Frame::Box => {
                // The tick labels determine the margins, the margins the range of equal units: two passes suffice.
                let mut inner = body.inset([50.0, 8.0, 10.0, 40.0]);
                for _ in 0..2 {
                    let mut shown = window;
                    self.widen(&mut shown, inner);
                    let [x, y] = self.axes(shown, inner);
                    let [left, below] = label_room(&x, &y)?;
                    inner = body.inset([left, 8.0, 10.0, below]);
                }
                self.widen(&mut window, inner);
                let [x, y] = self.axes(window, inner);
                draw_axes(scene, inner, &x, &y)?;
                inner
            }
        };
        let map = Map { window, inner };
        for layer in &self.layers {
            map.layer(scene, layer)?;
        }
        let room = match legend {
            Legend::Right => Rect {
                x: body.right(),
                y: inner.y,
                w: entries.width,
                h: inner.h,
            },
            _ => Rect {
                x: page.x,
                y: body.bottom(),
                w: page.w,
                h: entries.height,
            },
        };
        entries.draw(scene, legend, room);
        Ok(())
    }

    pub(crate) fn legend_entries<'a>(&'a self) -> Vec<(Key, &'a str)> {
        let entry = |layer: &'a Layer| match *layer {
            Layer::Curve {
                line, ref label, ..
            } => Some((Key::Line(line), label)),
            Layer::ControlPolygon {
                line, ref label, ..
            } => Some((Key::Chain(line, Marker::Ring), label)),
            Layer::Points {
                marker,
                colour,
                ref label,
                ..
            } => Some((Key::Marker(marker, colour), label)),
            Layer::Region {
                colour,
                opacity,
                ref label,
                ..
            } => Some((Key::Patch([colour; 2], opacity), label)),
            _ => None,
        };
        let shown = self.layers.iter().filter_map(entry);
        shown
            .filter(|(_, label)| !label.is_empty())
            .map(|(key, label)| (key, label.as_str()))
            .collect()
    }

    /// The data window, x then y, before units are made equal.
    pub(crate) fn window(&self) -> Result<[[f64; 2]; 2], FigureError> {
        let points: Vec<[f64; 2]> = self.layers.iter().flat_map(Layer::extent).collect();
        let side = |axis: &Axis, k: usize| match axis.range {
            Some(range) => Ok(range),
            None => extent(points.iter().map(|p| p[k])).ok_or(FigureError::Empty),
        };
        Ok([side(&self.x, 0)?, side(&self.y, 1)?])
    }

    fn axes(&self, window: [[f64; 2]; 2], inner: Rect) -> [AxisSpec<'_>; 2] {
        // Equal units get equal steps.
        let [per_x, per_y] = match self.aspect {
            Aspect::Free => PER_TICK,
            Aspect::Equal => [PER_TICK[0].min(1.4 * PER_TICK[1]); 2],
        };
        let spec = |axis, [low, high]: [f64; 2], length: f64, per: f64, label: f64| AxisSpec {
            low,
            high,
            label: axis,
            ticks: Ticks::new(low, high, length / per, length / label + 1.0),
        };
        [
            spec(
                self.x.label.as_str(),
                window[0],
                inner.w,
                per_x,
                PER_LABEL[0],
            ),
            spec(
                self.y.label.as_str(),
                window[1],
                inner.h,
                per_y,
                PER_LABEL[1],
            ),
        ]
    }

    /// Make units equal by widening the shorter side, if wanted.
    fn widen(&self, window: &mut [[f64; 2]; 2], inner: Rect) {
        if self.aspect == Aspect::Free {
            return;
        }
        let unit = window
            .iter()
            .zip([inner.w, inner.h])
            .map(|([a, b], px)| (b - a) / px)
            .fold(0.0, f64::max);
        for (side, px) in window.iter_mut().zip([inner.w, inner.h]) {
            let (middle, half) = ((side[0] + side[1]) / 2.0, unit * px / 2.0);
            *side = [middle - half, middle + half];
        }
    }
}

/// Returns the interval of `values` with a margin, never empty; `None` without values.
fn extent(values: impl Iterator<Item = f64>) -> Option<[f64; 2]> {
    let [low, high] = values.fold([f64::INFINITY, f64::NEG_INFINITY], |[l, h], v| {
        [l.min(v), h.max(v)]
    });
    if low > high {
        return None;
    }
    let air = (0.08 * (high - low))
        .max(1e-6 * low.abs().max(high.abs()))
        .max(1e-300);
    Some([low - air, high + air])
}

/// Maps data to the page.
struct Map {
    window: [[f64; 2]; 2],
    inner: Rect,
}

impl Map {
    fn to_page(&self, p: [f64; 2]) -> [f64; 2] {
        let part = |k: usize| {
            let [low, high] = self.window[k];
            (p[k] - low) / (high - low)
        };
        [
            self.inner.x + part(0) * self.inner.w,
            self.inner.bottom() - part(1) * self.inner.h,
        ]
    }

    fn all(&self, points: &[[f64; 2]]) -> Vec<[f64; 2]> {
        points.iter().map(|&p| self.to_page(p)).collect()
    }

    /// Whether a point of the page lies in the plotting area, border included.
    fn shows(&self, [x, y]: [f64; 2]) -> bool {
        let r = self.inner;
        (r.x - 0.5..=r.right() + 0.5).contains(&x) && (r.y - 0.5..=r.bottom() + 0.5).contains(&y)
    }

    fn line(&self, scene: &mut Scene, points: &[[f64; 2]], line: Line) {
        for part in clip_polyline(points, self.inner) {
            scene.stroke(polyline(&part), line);
        }
    }

    fn markers(&self, scene: &mut Scene, points: &[[f64; 2]], marker: Marker, colour: Colour) {
        for at in self.all(points).into_iter().filter(|&p| self.shows(p)) {
            draw_marker(scene, at, marker, colour);
        }
    }

    fn layer(&self, scene: &mut Scene, layer: &Layer) -> Result<(), FigureError> {
        match layer {
            Layer::Curve { points, line, .. } => self.line(scene, &self.all(points), *line),
            Layer::ControlPolygon { points, line, .. } => {
                self.line(scene, &self.all(points), *line);
                self.markers(scene, points, Marker::Ring, line.colour);
            }
            Layer::Points {
                points,
                marker,
                colour,
                ..
            } => self.markers(scene, points, *marker, *colour),
            Layer::Region {
                boundary,
                colour,
                opacity,
                ..
            } => {
                scene.fill(
                    polygon(&clip_polygon(&self.all(boundary), self.inner)),
                    *colour,
                    *opacity,
                );
            }
            Layer::Arrow { from, to, line } => {
                self.arrow(scene, self.to_page(*from), self.to_page(*to), *line)
            }
            Layer::Guide { across, at, line } => {
                let r = self.inner;
                let [[x0, x1], [y0, y1]] = self.window;
                let ends = match across {
                    GuideAxis::X => [[*at, y0], [*at, y1]],
                    GuideAxis::Y => [[x0, *at], [x1, *at]],
                };
                for part in clip_polyline(&self.all(&ends), r) {
                    scene.stroke(polyline(&part), *line);
                }
            }
            Layer::Lettering {
                at,
                text,
                height,
                angle,
                colour,
            } => {
                // Equal units are meant: a drawing.
                let [foot, top] = [*at, [at[0], at[1] + height]].map(|p| self.to_page(p));
                if self.shows(foot) {
                    scene.letter(text, foot[1] - top[1], foot, *angle, *colour)?;
                }
            }
            Layer::Note { at, text, place } => {
                let at = self.to_page(*at);
                if self.shows(at) {
                    scene.note(text, TEXT_SIZE, at, *place)?;
                }
            }
        }
        Ok(())
    }

    /// Shaft and head; an arrow with an end outside keeps its shaft only.
    fn arrow(&self, scene: &mut Scene, from: [f64; 2], to: [f64; 2], line: Line) {
        let d = [to[0] - from[0], to[1] - from[1]];
        let length = libm::hypot(d[0], d[1]);
        if !(self.shows(from) && self.shows(to)) || length < 1e-9 {
            return self.line(scene, &[from, to], line);
        }
        let u = [d[0] / length, d[1] / length];
        let head = (5.0 + 2.0 * line.width).min(0.6 * length);
        let back = |along: f64, side: f64| {
            [
                to[0] - along * u[0] - side * u[1],
                to[1] - along * u[1] + side * u[0],
            ]
        };
        self.line(scene, &[from, back(0.8 * head, 0.0)], line);
        let tip = [
            to,
            back(head, 0.36 * head),
            back(0.8 * head, 0.0),
            back(head, -0.36 * head),
        ];
        scene.fill(polygon(&tip), line.colour, 1.0);
    }
}
