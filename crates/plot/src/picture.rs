//! Pages: one plot or view alone, or several as panels (a), (b), (c) with captions.

use crate::error::{FigureError, at_least, within};
use crate::flat::Plot;
use crate::ink::chart::TEXT_SIZE;
use crate::ink::scene::{Align, Rect, Scene, Turn};
use crate::ink::typeset::typeset;
use crate::ink::{raster, svg};
use crate::legend::{Entries, Key, Legend};
use crate::space::View;

/// Size of a page in pixels of 1/96 inch. The PNG has twice as many pixels each way.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Size {
    /// Width, 64 to 2048.
    pub width: u32,
    /// Height, 64 to 2048.
    pub height: u32,
}

impl Size {
    /// A figure of its own.
    pub const COLUMN: Size = Size {
        width: 520,
        height: 360,
    };
    /// A nearly square figure, for views of solids.
    pub const VIEW: Size = Size {
        width: 520,
        height: 420,
    };
    /// One of two panels side by side.
    pub const PANEL: Size = Size {
        width: 360,
        height: 300,
    };

    fn check(self) -> Result<(), FigureError> {
        within("page width", f64::from(self.width), 64.0, 2048.0)?;
        within("page height", f64::from(self.height), 64.0, 2048.0)
    }
}

/// A finished picture.
#[derive(Debug, Clone, PartialEq)]
pub struct Picture {
    /// The picture as a self-contained SVG document: no fonts, no scripts, no links.
    pub svg: String,
    scene: Scene,
}

impl Picture {
    /// The picture as a PNG file with `2 * width` by `2 * height` pixels, RGB, at 192 per inch.
    ///
    /// # Errors
    /// [`FigureError::Png`] if the encoder refuses, which no checked size makes it do.
    pub fn png(&self) -> Result<Vec<u8>, FigureError> {
        raster::write(&self.scene)
    }

    /// Size of the page.
    #[must_use]
    pub fn size(&self) -> Size {
        Size {
            width: self.scene.width,
            height: self.scene.height,
        }
    }
}

/// What a panel shows.
#[derive(Debug, Clone, PartialEq)]
pub enum Content {
    /// A plane picture.
    Plot(Plot),
    /// A view of solids.
    View(View),
}

impl Content {
    fn legend(&self) -> Legend {
        match self {
            Content::Plot(plot) => plot.legend,
            Content::View(view) => view.legend,
        }
    }

    fn legend_entries(&self) -> Vec<(Key, &str)> {
        match self {
            Content::Plot(plot) => plot.legend_entries(),
            Content::View(view) => view.legend_entries(),
        }
    }
}

/// One panel of a figure.
#[derive(Debug, Clone, PartialEq)]
pub struct Panel {
    /// What it shows.
    pub content: Content,
    /// Its caption, in the [label language](crate#labels); `(a)`, `(b)`, ... is put before it when there are
    /// several panels. Empty for none.
    pub caption: String,
}

/// One or more panels on a page, row by row. A legend that several panels have below stands once, below all of them.
///
/// ```
/// use torse_plot::{Axis, Content, Figure, Line, Panel, Plot, Size};
/// let panel = |power: i32| {
///     let points = (0..=40).map(|i| { let t = f64::from(i) / 40.0; [t, t.powi(power)] }).collect();
///     let plot = Plot::new(Axis::auto("$t$"), Axis::auto("")).curve(points, Line::nth(0), "");
///     Panel { content: Content::Plot(plot), caption: format!("$t^{power}$") }
/// };
/// let figure = Figure { title: "Powers".into(), panels: vec![panel(2), panel(3)], columns: 2, panel_size: Size::PANEL };
/// let picture = figure.draw()?;
/// assert_eq!(picture.size().width, 720);
/// # Ok::<(), torse_plot::FigureError>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct Figure {
    /// Plain text that names the figure to those who cannot see it.
    pub title: String,
    /// The panels.
    pub panels: Vec<Panel>,
    /// Panels in a row, at least one.
    pub columns: usize,
    /// Size of each panel without its caption.
    pub panel_size: Size,
}

impl Plot {
    /// Draw it alone on a page.
    ///
    /// # Errors
    /// Non-finite coordinates (with the index of the point), lists that are too short, empty ranges, labels that
    /// do not parse, nothing to draw, a page size out of range.
    pub fn draw(self, title: &str, size: Size) -> Result<Picture, FigureError> {
        Figure::single(title, size, Content::Plot(self)).draw()
    }
}

impl View {
    /// Draw it alone on a page.
    ///
    /// # Errors
    /// Non-finite coordinates, normals or values (with the index of the vertex), lists of the wrong length, empty
    /// bounds or scale ranges, an opacity outside 0..=1, a camera beyond the poles, labels that do not parse,
    /// nothing to draw, more than [`WORK_LIMIT`](crate::WORK_LIMIT) samples to visit, a page size out of range.
    pub fn draw(self, title: &str, size: Size) -> Result<Picture, FigureError> {
        Figure::single(title, size, Content::View(self)).draw()
    }
}

const MARGIN: f64 = 10.0;
const CAPTION: f64 = 26.0;
/// Bytes for the images of a figure: a third more as text in an SVG of less than 300 KiB.
const IMAGE_BYTES: usize = 195 * 1024;

impl Figure {
    pub(crate) fn single(title: &str, size: Size, content: Content) -> Figure {
        let caption = String::new();
        Figure {
            title: title.to_owned(),
            panels: vec![Panel { content, caption }],
            columns: 1,
            panel_size: size,
        }
    }

    /// Draw the page.
    ///
    /// # Errors
    /// Those of [`Plot::draw`] and [`View::draw`]; no panels; a page more than 2048 pixels wide or high.
    pub fn draw(&self) -> Result<Picture, FigureError> {
        at_least("panels", 1, self.panels.len())?;
        at_least("columns", 1, self.columns)?;
        self.panel_size.check()?;
        let captioned = self.panels.len() > 1 || self.panels.iter().any(|p| !p.caption.is_empty());
        let caption = if captioned { CAPTION } else { 0.0 };
        let columns = self.columns.min(self.panels.len());
        let rows = self.panels.len().div_ceil(columns);
        let (w, h) = (
            f64::from(self.panel_size.width),
            f64::from(self.panel_size.height),
        );
        let below = self.repeated();
        let below = Entries::new(Legend::Below, &below, w * columns as f64 - 2.0 * MARGIN)?;
        let panels = (h + caption) * rows as f64;
        let page = [w * columns as f64, panels + below.height];
        within("page width", page[0], 64.0, 2048.0)?;
        within("page height", page[1], 64.0, 2048.0)?;
        let views = self
            .panels
            .iter()
            .filter(|p| matches!(p.content, Content::View(_)))
            .count();
        let budget = IMAGE_BYTES / views.max(1);
        let mut scene = Scene::new(page[0] as u32, page[1] as u32);
        for (k, panel) in self.panels.iter().enumerate() {
            let cell = Rect {
                x: w * (k % columns) as f64,
                y: (h + caption) * (k / columns) as f64,
                w,
                h,
            };
            let room = cell.inset([MARGIN; 4]);
            let legend = self.legend(panel);
            match &panel.content {
                Content::Plot(plot) => plot.draw_in(&mut scene, room, legend)?,
                Content::View(view) => view.draw_in(&mut scene, room, legend, budget)?,
            }
            let middle = [cell.x + w / 2.0, cell.bottom() + caption / 2.0 - 4.0];
            scene.set(
                &typeset(&self.caption(k, panel), TEXT_SIZE)?,
                middle,
                Align::Centre,
                Turn::Across,
                0.0,
            );
        }
        let room = Rect {
            x: 0.0,
            y: panels - MARGIN,
            w: page[0],
            h: below.height,
        };
        below.draw(&mut scene, Legend::Below, room);
        Ok(Picture {
            svg: svg::write(&scene, &self.title)?,
            scene,
        })
    }

    /// The entries of legends that several panels have: they stand once, below all panels.
    fn repeated(&self) -> Vec<(Key, &str)> {
        let mut entries: Vec<(Key, &str)> = vec![];
        for panel in self.panels.iter().filter(|panel| self.is_repeated(panel)) {
            for entry in panel.content.legend_entries() {
                if !entries.contains(&entry) {
                    entries.push(entry);
                }
            }
        }
        entries
    }

    fn is_repeated(&self, panel: &Panel) -> bool {
        let own = panel.content.legend_entries();
        let same = |other: &&Panel| {
            other.content.legend() == Legend::Below && other.content.legend_entries() == own
        };
        panel.content.legend() == Legend::Below && self.panels.iter().filter(same).count() > 1
    }

    /// Where the legend of a panel stands in its own room.
    fn legend(&self, panel: &Panel) -> Legend {
        match self.is_repeated(panel) {
            true => Legend::Hidden,
            false => panel.content.legend(),
        }
    }

    fn caption(&self, k: usize, panel: &Panel) -> String {
        let letter = char::from(b'a' + (k % 26) as u8);
        match (self.panels.len(), panel.caption.as_str()) {
            (1, caption) => caption.to_owned(),
            (_, "") => format!("({letter})"),
            (_, caption) => format!("({letter}) {caption}"),
        }
    }
}
