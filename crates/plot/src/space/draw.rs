//! Drawing a [`View`] into a rectangle of the page.

use crate::error::{FigureError, range};
use crate::ink::chart::TEXT_SIZE;
use crate::ink::raster::{RESOLUTION, compress};
use crate::ink::scene::{Item, Rect, Scene};
use crate::legend::{Entries, Key, Legend, Marker};
use crate::space::axes::StageBox;
use crate::space::camera::{Axes, Projection};
use crate::space::clip::{BoxBounds, contains};
use crate::space::mesh::{Builder, area_vectors};
use crate::space::raster::{SAMPLES, render};
use crate::space::scalebar::ScaleBar;
use crate::space::vector::V3;
use crate::space::view::{Bounds, Paint, Solid, Stage, Surface, View};

/// First guess of the room for ticks and titles around the box, in pixels: left, top, right, below.
const STAGE_ROOM: [f64; 4] = [50.0, 8.0, 34.0, 40.0];
/// Room for the width of lines around a bare drawing.
const BARE_ROOM: [f64; 4] = [8.0; 4];

impl View {
    pub(crate) fn draw_in(
        &self,
        scene: &mut Scene,
        page: Rect,
        legend: Legend,
        budget: usize,
    ) -> Result<(), FigureError> {
        self.check()?;
        let entries = Entries::new(legend, &self.legend_entries(), page.w)?;
        let body = match legend {
            Legend::Right => page.inset([0.0, 0.0, entries.width, 0.0]),
            _ => page.inset([0.0, 0.0, 0.0, entries.height]),
        };
        let range = self.value_range()?;
        let bar = match self.uses_scale() {
            true => Some(ScaleBar::new(&self.scale, range, body.h)?),
            false => None,
        };
        let body = body.inset([0.0, 0.0, bar.as_ref().map_or(0.0, |b| b.width), 0.0]);
        let body = whole_pixels(body);

        let cloud: Vec<V3> = self.solids.iter().flat_map(Solid::points).collect();
        let bounds = self.box_bounds(&cloud)?;
        let axes = self.camera.resolve(&area_vectors(&self.solids), &cloud);
        let projection = self.fit(axes, &cloud, &bounds, body)?;

        let stage = StageBox::new(&projection, &bounds);
        if let Stage::Box(_) = self.stage {
            stage.draw_walls(scene);
        }
        let builder = Builder {
            projection: &projection,
            bounds: &bounds,
            page: body,
            fine: f64::from(RESOLUTION) * SAMPLES as f64,
            range,
        };
        scene.items.push(self.rasterise(&builder, budget)?);
        if let Stage::Box(titles) = &self.stage {
            stage.draw_ticks(scene, titles)?;
        }
        for solid in &self.solids {
            if let Solid::Note { at, text, place } = solid
                && contains(&bounds, *at)
            {
                let [x, y, _] = projection.apply(*at);
                scene.note(text, TEXT_SIZE, [x, y], *place)?;
            }
        }
        if let Some(bar) = &bar {
            let room = Rect {
                x: body.right(),
                w: bar.width,
                ..body
            };
            bar.draw(scene, room)?;
        }
        let room = match legend {
            Legend::Right => Rect {
                x: page.right() - entries.width,
                w: entries.width,
                ..body
            },
            _ => Rect {
                y: page.bottom() - entries.height,
                h: entries.height,
                ..page
            },
        };
        entries.draw(scene, legend, room);
        Ok(())
    }

    /// The largest projection that leaves room for ticks and titles.
    fn fit(
        &self,
        axes: Axes,
        cloud: &[V3],
        bounds: &BoxBounds,
        body: Rect,
    ) -> Result<Projection, FigureError> {
        let corners = corners(bounds);
        match (&self.stage, self.bounds) {
            (Stage::Box(titles), _) => {
                // Larger boxes have more ticks with other labels: a second look settles it.
                let mut margins = STAGE_ROOM;
                for _ in 0..2 {
                    let projection = Projection::fit(axes, &corners, body.inset(margins));
                    margins = StageBox::new(&projection, bounds).overhang(titles)?;
                }
                Ok(Projection::fit(axes, &corners, body.inset(margins)))
            }
            (Stage::Bare, Bounds::Fixed(_)) => {
                Ok(Projection::fit(axes, &corners, body.inset(BARE_ROOM)))
            }
            (Stage::Bare, Bounds::Data) => Ok(Projection::fit(axes, cloud, body.inset(BARE_ROOM))),
        }
    }

    /// The image of the solids, as a file of about `budget` bytes at most.
    fn rasterise(&self, builder: &Builder, budget: usize) -> Result<Item, FigureError> {
        let body = builder.page;
        let (w, h) = (body.w as u32 * RESOLUTION, body.h as u32 * RESOLUTION);
        let (pixels, png) = compress(render(&builder.build(self), w, h)?, budget)?;
        let (x, y) = (body.x as u32, body.y as u32);
        Ok(Item::Image { x, y, pixels, png })
    }

    pub(crate) fn legend_entries<'a>(&'a self) -> Vec<(Key, &'a str)> {
        let entry = |solid: &'a Solid| match *solid {
            Solid::Surface(Surface {
                paint: Paint::TwoSided { front, back },
                opacity,
                ref label,
                ..
            }) => Some((Key::Patch([front, back], opacity), label)),
            Solid::Curve {
                line, ref label, ..
            } => Some((Key::Line(line), label)),
            Solid::Net {
                line, ref label, ..
            } => Some((Key::Chain(line, Marker::Disc), label)),
            Solid::Points {
                colour, ref label, ..
            } => Some((Key::Marker(Marker::Disc, colour), label)),
            _ => None,
        };
        let shown = self.solids.iter().filter_map(entry);
        shown
            .filter(|(_, label)| !label.is_empty())
            .map(|(key, label)| (key, label.as_str()))
            .collect()
    }

    fn values(&self) -> impl Iterator<Item = f64> {
        self.solids
            .iter()
            .flat_map(|solid| match solid {
                Solid::Surface(Surface {
                    paint: Paint::Values(values),
                    ..
                }) => values.as_slice(),
                _ => &[],
            })
            .copied()
    }

    fn uses_scale(&self) -> bool {
        self.values().next().is_some()
    }

    /// Values at the ends of the colour map; a constant quantity gets an interval around it.
    pub(crate) fn value_range(&self) -> Result<[f64; 2], FigureError> {
        if let Some(range) = self.scale.range {
            return Ok(range);
        }
        let [low, high] = extent(self.values());
        if low > high {
            return Ok([0.0, 1.0]);
        }
        let air = if high > low {
            0.0
        } else {
            low.abs().max(1.0) * 0.5
        };
        let [low, high] = [low - air, high + air];
        range("values on a surface", low, high)?;
        Ok([low, high])
    }

    /// The box that is shown, see [`View::box_bounds`].
    pub(crate) fn shown(&self) -> Result<BoxBounds, FigureError> {
        self.check()?;
        let cloud: Vec<V3> = self.solids.iter().flat_map(Solid::points).collect();
        self.box_bounds(&cloud)
    }

    /// The box that is shown. A flat object gets some depth, every object a little air.
    fn box_bounds(&self, cloud: &[V3]) -> Result<BoxBounds, FigureError> {
        if cloud.is_empty() {
            return Err(FigureError::Empty);
        }
        if let Bounds::Fixed(bounds) = self.bounds {
            return Ok(bounds);
        }
        let sides = [0, 1, 2].map(|k| extent(cloud.iter().map(|p| p[k])));
        let longest = sides.iter().map(|[a, b]| b - a).fold(0.0, f64::max);
        let size = sides.iter().flatten().fold(0.0f64, |m, c| m.max(c.abs()));
        let least = (0.12 * longest).max(1e-9 * size).max(1e-300);
        let bounds = sides.map(|[a, b]| {
            let air = (0.02 * longest).max((least - (b - a)) / 2.0);
            [a - air, b + air]
        });
        for [low, high] in bounds {
            range("extent of the solids", low, high)?;
        }
        Ok(bounds)
    }
}

fn extent(values: impl Iterator<Item = f64>) -> [f64; 2] {
    values.fold([f64::INFINITY, f64::NEG_INFINITY], |[l, h], v| {
        [l.min(v), h.max(v)]
    })
}

fn corners(bounds: &BoxBounds) -> [V3; 8] {
    [0, 1, 2, 3, 4, 5, 6, 7].map(|n: usize| [0, 1, 2].map(|k| bounds[k][n >> k & 1]))
}

/// The largest rectangle of whole pixels inside, so that the image of the solids is not resampled.
fn whole_pixels(r: Rect) -> Rect {
    let (x, y) = (r.x.ceil(), r.y.ceil());
    Rect {
        x,
        y,
        w: (r.right().floor() - x).max(1.0),
        h: (r.bottom().floor() - y).max(1.0),
    }
}
