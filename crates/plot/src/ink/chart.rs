//! plotters draws on our page: a [`DrawingBackend`] that records into a [`Scene`].
//!
//! plotters computes in whole pixels. The recorder hands it a page [`FINE`] times finer than ours, so that its
//! rounding is invisible, and typesets its labels with our own type, mathematics included.

use std::convert::Infallible;

use plotters::coord::ranged1d::{DefaultFormatting, KeyPointHint, KeyPointWeight, Ranged};
use plotters::prelude::*;
use plotters::style::text_anchor::{HPos, VPos};
use plotters_backend::{
    BackendColor, BackendCoord, BackendStyle, BackendTextStyle, DrawingErrorKind, FontTransform,
};

use crate::colour::{Colour, Dash, Line};
use crate::error::FigureError;
use crate::ink::scene::{Align, Item, Rect, Scene, Turn, circle, polygon, polyline};
use crate::ink::ticks::Ticks;
use crate::ink::typeset::typeset;

/// plotters' pixels per unit of the page.
const FINE: f64 = 64.0;

/// Height of tick labels and of everything else that is written, in pixels.
pub(crate) const TICK_SIZE: f64 = 11.5;
pub(crate) const TEXT_SIZE: f64 = 13.0;
/// Length of a tick.
const TICK: f64 = 3.5;
const HAIR: f64 = 0.8;
const GRID: Colour = Colour::rgb(0xe8, 0xe9, 0xec);

/// What an axis shows.
pub(crate) struct AxisSpec<'a> {
    pub low: f64,
    pub high: f64,
    pub label: &'a str,
    pub ticks: Ticks,
}

/// Room that the axes need left of and below the plotting area.
pub(crate) fn label_room(x: &AxisSpec, y: &AxisSpec) -> Result<[f64; 2], FigureError> {
    let mut widest = 0.0f64;
    for label in &y.ticks.labels {
        widest = widest.max(typeset(label, TICK_SIZE)?.width);
    }
    let title = |axis: &AxisSpec| -> Result<f64, FigureError> {
        let text = axis.ticks.title(axis.label);
        Ok(if text.is_empty() {
            0.0
        } else {
            typeset(&text, TEXT_SIZE)?.row()
        })
    };
    let left = 2.0 * TICK + widest + title(y)? + 3.0;
    let below = 2.0 * TICK + 1.3 * TICK_SIZE + title(x)?;
    Ok([left, below])
}

/// Draw the axes of a plotting area `inner` whose labels fill the room given by [`label_room`].
pub(crate) fn draw_axes(
    scene: &mut Scene,
    inner: Rect,
    x: &AxisSpec,
    y: &AxisSpec,
) -> Result<(), FigureError> {
    let [left, below] = label_room(x, y)?;
    let outer = Rect {
        x: inner.x - left,
        y: inner.y,
        w: inner.w + left,
        h: inner.h + below,
    };
    let root = Recorder { scene, outer }.into_drawing_area();
    let fine = |v: f64| (v * FINE).round() as i32;
    let fail = |e: DrawingAreaErrorKind<Infallible>| FigureError::Chart(e.to_string());
    let mut chart = ChartBuilder::on(&root)
        .x_label_area_size(fine(below))
        .y_label_area_size(fine(left))
        .build_cartesian_2d(TickAxis::new(x), TickAxis::new(y))
        .map_err(fail)?;
    let name = |axis: &AxisSpec, v: f64| {
        let at = axis.ticks.at.iter().position(|&t| t == v);
        at.and_then(|k| axis.ticks.labels.get(k))
            .cloned()
            .unwrap_or_default()
    };
    let (x_name, y_name) = (|v: &f64| name(x, *v), |v: &f64| name(y, *v));
    let line = |Colour { r, g, b }| ShapeStyle {
        color: RGBColor(r, g, b).to_rgba(),
        filled: false,
        stroke_width: fine(HAIR) as u32,
    };
    chart
        .configure_mesh()
        .bold_line_style(line(GRID))
        .light_line_style(TRANSPARENT)
        .axis_style(line(Colour::INK))
        .set_all_tick_mark_size(fine(TICK))
        .label_style(("serif", TICK_SIZE * FINE))
        .axis_desc_style(("serif", TEXT_SIZE * FINE))
        .x_desc(x.ticks.title(x.label))
        .y_desc(y.ticks.title(y.label))
        .x_label_formatter(&x_name)
        .y_label_formatter(&y_name)
        .draw()
        .map_err(fail)?;
    drop(chart);
    drop(root);
    let corners = [
        [inner.x, inner.y],
        [inner.right(), inner.y],
        [inner.right(), inner.bottom()],
    ];
    scene.stroke(polyline(&corners), Line::solid(Colour::INK, HAIR));
    Ok(())
}

/// A linear axis with ticks at given places.
struct TickAxis {
    low: f64,
    high: f64,
    ticks: Vec<f64>,
}

impl TickAxis {
    fn new(axis: &AxisSpec) -> TickAxis {
        TickAxis {
            low: axis.low,
            high: axis.high,
            ticks: axis.ticks.at.clone(),
        }
    }
}

impl Ranged for TickAxis {
    type FormatOption = DefaultFormatting;
    type ValueType = f64;

    fn map(&self, value: &f64, (from, to): (i32, i32)) -> i32 {
        let part = (value - self.low) / (self.high - self.low);
        (f64::from(from) + part * (f64::from(to) - f64::from(from))).round() as i32
    }

    fn key_points<Hint: KeyPointHint>(&self, hint: Hint) -> Vec<f64> {
        // plotters asks once for labelled lines and once for the finer ones, of which we draw none.
        match hint.weight() {
            KeyPointWeight::Bold => self.ticks.clone(),
            KeyPointWeight::Any => Vec::new(),
        }
    }

    fn range(&self) -> std::ops::Range<f64> {
        self.low..self.high
    }
}

/// The page as plotters sees it.
struct Recorder<'a> {
    scene: &'a mut Scene,
    outer: Rect,
}

type Recorded = Result<(), DrawingErrorKind<Infallible>>;

impl Recorder<'_> {
    fn place(&self, (x, y): BackendCoord) -> [f64; 2] {
        [
            self.outer.x + f64::from(x) / FINE,
            self.outer.y + f64::from(y) / FINE,
        ]
    }

    fn places<I: IntoIterator<Item = BackendCoord>>(&self, path: I) -> Vec<[f64; 2]> {
        path.into_iter().map(|p| self.place(p)).collect()
    }

    fn outline<S: BackendStyle>(&mut self, path: Option<tiny_skia::Path>, style: &S) {
        let BackendColor {
            alpha,
            rgb: (r, g, b),
        } = style.color();
        let line = Line {
            colour: Colour { r, g, b },
            width: f64::from(style.stroke_width()) / FINE,
            dash: Dash::Solid,
        };
        if alpha > 0.0 {
            self.scene
                .items
                .extend(path.map(|path| Item::Stroke { path, line, alpha }));
        }
    }

    fn flood<S: BackendStyle>(&mut self, path: Option<tiny_skia::Path>, style: &S) {
        let BackendColor {
            alpha,
            rgb: (r, g, b),
        } = style.color();
        if alpha > 0.0 {
            self.scene.fill(path, Colour { r, g, b }, alpha);
        }
    }
}

impl DrawingBackend for Recorder<'_> {
    type ErrorType = Infallible;

    fn get_size(&self) -> (u32, u32) {
        ((self.outer.w * FINE) as u32, (self.outer.h * FINE) as u32)
    }

    fn ensure_prepared(&mut self) -> Recorded {
        Ok(())
    }

    fn present(&mut self) -> Recorded {
        Ok(())
    }

    fn draw_pixel(&mut self, point: BackendCoord, color: BackendColor) -> Recorded {
        self.draw_rect(point, (point.0 + 1, point.1 + 1), &color, true)
    }

    fn draw_line<S: BackendStyle>(
        &mut self,
        from: BackendCoord,
        to: BackendCoord,
        style: &S,
    ) -> Recorded {
        self.draw_path([from, to], style)
    }

    fn draw_rect<S: BackendStyle>(
        &mut self,
        a: BackendCoord,
        b: BackendCoord,
        style: &S,
        fill: bool,
    ) -> Recorded {
        let corners = self.places([a, (b.0, a.1), b, (a.0, b.1)]);
        if fill {
            self.flood(polygon(&corners), style);
        } else {
            self.outline(polygon(&corners), style);
        }
        Ok(())
    }

    fn draw_path<S: BackendStyle, I: IntoIterator<Item = BackendCoord>>(
        &mut self,
        path: I,
        style: &S,
    ) -> Recorded {
        let points = self.places(path);
        self.outline(polyline(&points), style);
        Ok(())
    }

    fn draw_circle<S: BackendStyle>(
        &mut self,
        at: BackendCoord,
        radius: u32,
        style: &S,
        fill: bool,
    ) -> Recorded {
        let path = circle(self.place(at), f64::from(radius) / FINE);
        if fill {
            self.flood(path, style);
        } else {
            self.outline(path, style);
        }
        Ok(())
    }

    fn fill_polygon<S: BackendStyle, I: IntoIterator<Item = BackendCoord>>(
        &mut self,
        path: I,
        style: &S,
    ) -> Recorded {
        let points = self.places(path);
        self.flood(polygon(&points), style);
        Ok(())
    }

    fn draw_text<T: BackendTextStyle>(
        &mut self,
        text: &str,
        style: &T,
        pos: BackendCoord,
    ) -> Recorded {
        let line = typeset(text, style.size() / FINE).map_err(font_error)?;
        let anchor = style.anchor();
        let align = match anchor.h_pos {
            HPos::Left => Align::Left,
            HPos::Center => Align::Centre,
            HPos::Right => Align::Right,
        };
        let down = match anchor.v_pos {
            VPos::Top => line.row() / 2.0,
            VPos::Center => 0.0,
            VPos::Bottom => -line.row() / 2.0,
        };
        let [x, y] = self.place(pos);
        let (at, turn) = match style.transform() {
            FontTransform::Rotate270 => ([x + down, y], Turn::Upwards),
            _ => ([x, y + down], Turn::Across),
        };
        self.scene.set(&line, at, align, turn, 0.0);
        Ok(())
    }

    fn estimate_text_size<T: BackendTextStyle>(
        &self,
        text: &str,
        style: &T,
    ) -> Result<(u32, u32), DrawingErrorKind<Infallible>> {
        let line = typeset(text, style.size()).map_err(font_error)?;
        Ok((line.width.ceil() as u32, line.row().ceil() as u32))
    }
}

fn font_error(error: FigureError) -> DrawingErrorKind<Infallible> {
    DrawingErrorKind::FontError(Box::new(error))
}
