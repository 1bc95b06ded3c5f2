//! The bar that relates colours to values.

use crate::colour::{Colour, Line};
use crate::error::FigureError;
use crate::ink::chart::{TEXT_SIZE, TICK_SIZE};
use crate::ink::scene::{Align, Rect, Scene, Turn, polygon, polyline};
use crate::ink::ticks::Ticks;
use crate::ink::typeset::typeset;
use crate::space::view::Scale;

const BAR: f64 = 13.0;
const GAP: f64 = 16.0;
const STRIPES: usize = 96;
const MAX_BAR_LENGTH: f64 = 230.0;

/// A measured scale bar.
pub(crate) struct ScaleBar<'a> {
    scale: &'a Scale,
    range: [f64; 2],
    ticks: Ticks,
    /// Height of the bar.
    length: f64,
    labels: f64,
    /// Room it takes, the gap to the view included.
    pub width: f64,
}

impl<'a> ScaleBar<'a> {
    pub(crate) fn new(
        scale: &'a Scale,
        range: [f64; 2],
        room: f64,
    ) -> Result<ScaleBar<'a>, FigureError> {
        let length = (0.8 * room).min(MAX_BAR_LENGTH);
        let ticks = Ticks::new(range[0], range[1], length / 40.0, length / 20.0);
        let mut labels = 0.0f64;
        for label in &ticks.labels {
            labels = labels.max(typeset(label, TICK_SIZE)?.width);
        }
        let title = ticks.title(&scale.label);
        let title = if title.is_empty() {
            0.0
        } else {
            1.6 * TEXT_SIZE
        };
        let width = GAP + BAR + 7.0 + labels + title;
        Ok(ScaleBar {
            scale,
            range,
            ticks,
            length,
            labels,
            width,
        })
    }

    /// Draw at the left of `room`, centred in height.
    pub(crate) fn draw(&self, scene: &mut Scene, room: Rect) -> Result<(), FigureError> {
        let (x, top) = (room.x + GAP, room.y + (room.h - self.length) / 2.0);
        let bottom = top + self.length;
        for k in 0..STRIPES {
            // Each stripe reaches down to the end, so that no seams show between them.
            let y = top + self.length * k as f64 / STRIPES as f64;
            let t = 1.0 - (k as f64 + 0.5) / STRIPES as f64;
            let stripe = Rect {
                x,
                y,
                w: BAR,
                h: bottom - y,
            };
            scene.fill_rect(stripe, self.scale.map.at(t));
        }
        let thin = Line::solid(Colour::INK, 0.7);
        scene.stroke(
            polygon(&[[x, top], [x + BAR, top], [x + BAR, bottom], [x, bottom]]),
            thin,
        );
        let [low, high] = self.range;
        for (value, label) in self.ticks.at.iter().zip(&self.ticks.labels) {
            let y = bottom - self.length * (value - low) / (high - low);
            scene.stroke(polyline(&[[x + BAR, y], [x + BAR + 3.0, y]]), thin);
            scene.text(
                label,
                TICK_SIZE,
                [x + BAR + 6.0, y],
                Align::Left,
                Turn::Across,
            )?;
        }
        let at = [
            x + BAR + 7.0 + self.labels + 0.9 * TEXT_SIZE,
            (top + bottom) / 2.0,
        ];
        scene.text(
            &self.ticks.title(&self.scale.label),
            TEXT_SIZE,
            at,
            Align::Centre,
            Turn::Upwards,
        )?;
        Ok(())
    }
}
