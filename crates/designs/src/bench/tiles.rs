//! Parts in true size on several pages: what overlaps, where pages meet, and what is on which.

use super::figure::{PaperFigure, PaperStyle, ToPaper};
use super::layout::{Drawn, PaperSize, labels, part_lines};
use super::words::length;
use crate::error::DesignError;
use crate::polygon::is_within;
use serde::Serialize;
use torse_geometry::pattern::Segment;

/// White edges of a page: left, top, right and, with a line of text, bottom.
const EDGES: [f64; 4] = [9.0, 9.0, 9.0, 19.0];
/// By how much neighbouring pages overlap.
const OVERLAP: f64 = 12.0;
/// Room about a part for its labels.
const ROOM: f64 = 8.0;
/// The most pages of a part.
const MAX_PAGES: usize = 400;
/// The size of the map of the pages.
const MAP: [f64; 2] = [120.0, 120.0];
/// The arms of the marks at which pages are laid on one another.
const ARM: f64 = 4.0;

/// A page of a part.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[non_exhaustive]
pub struct PaperTile {
    /// Its number among those of the part, from 1, row by row.
    pub number: usize,
    /// Its upper left corner on the drawing of the part.
    pub at: [f64; 2],
    /// The numbers of the pages above, to the right, below and to the left, where there are some.
    pub beside: [Option<usize>; 4],
}

/// A part in true size on pages.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[non_exhaustive]
pub struct TiledPart {
    /// The design.
    pub design: String,
    /// The title of the design.
    pub title: String,
    /// The part.
    pub part: String,
    /// Its letter.
    pub letter: String,
    /// Width and height of the part as it is written.
    pub size: [String; 2],
    /// The name of the paper.
    pub paper: &'static str,
    /// Width and height of a page, turned so that few are needed.
    pub page: [f64; 2],
    /// Where the drawing starts on a page.
    pub corner: [f64; 2],
    /// How much of the drawing a page shows.
    pub window: [f64; 2],
    /// By how much neighbouring pages overlap.
    pub overlap: f64,
    /// The whole drawing in true size.
    pub figure: PaperFigure,
    /// The pages with something of the part on them, row by row.
    pub tiles: Vec<PaperTile>,
    /// The drawing with all pages, small.
    pub map: PaperFigure,
}

/// How a page is laid on a part: columns, rows and the steps between pages.
struct Raster {
    page: [f64; 2],
    window: [f64; 2],
    step: [f64; 2],
    count: [usize; 2],
}

impl Raster {
    fn new(page: [f64; 2], size: [f64; 2]) -> Self {
        let window = [page[0] - EDGES[0] - EDGES[2], page[1] - EDGES[1] - EDGES[3]];
        let step = window.map(|w| w - OVERLAP);
        #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)]
        let count = [0, 1].map(|i| {
            let pages = ((size[i] + 2.0 * ROOM - OVERLAP) / step[i]).ceil();
            pages.clamp(1.0, 1e6) as usize
        });
        Self {
            page,
            window,
            step,
            count,
        }
    }

    fn pages(&self) -> usize {
        self.count[0].saturating_mul(self.count[1])
    }

    /// Returns the width and height of all pages laid together.
    fn whole(&self) -> [f64; 2] {
        #[allow(clippy::cast_precision_loss)]
        [0, 1].map(|i| self.count[i] as f64 * self.step[i] + OVERLAP)
    }
}

/// Returns the pages of a part.
pub(super) fn tiled(
    drawn: &Drawn<'_>,
    [design, title, letter]: [&str; 3],
    paper: PaperSize,
) -> Result<TiledPart, DesignError> {
    let part = drawn.part;
    let [w, h] = paper.millimetres();
    let (upright, across) = (
        Raster::new([w, h], part.size),
        Raster::new([h, w], part.size),
    );
    let raster = if across.pages() < upright.pages() {
        across
    } else {
        upright
    };
    if raster.pages() > MAX_PAGES {
        return Err(DesignError::Parts {
            design: design.to_owned(),
            reason: format!(
                "`{}` takes {} pages of {}, and at most {MAX_PAGES} are printed",
                part.name,
                raster.pages(),
                paper.name()
            ),
        });
    }
    let whole = raster.whole();
    let to = ToPaper {
        scale: 1.0,
        origin: [
            0.5 * (whole[0] - part.size[0]),
            0.5 * (whole[1] + part.size[1]),
        ],
    };
    let mut figure = PaperFigure {
        width: whole[0],
        height: whole[1],
        ..PaperFigure::default()
    };
    part_lines(&mut figure, drawn, to);
    labels(&mut figure, drawn, to);
    joins(&mut figure, &raster);
    let tiles = tiles(part.outline.as_slice(), to, &raster);
    let map = map(drawn, &raster, &tiles, to);
    Ok(TiledPart {
        design: design.to_owned(),
        title: title.to_owned(),
        part: part.name.clone(),
        letter: letter.to_owned(),
        size: part.size.map(length),
        paper: paper.name(),
        page: raster.page,
        corner: [EDGES[0], EDGES[1]],
        window: raster.window,
        overlap: OVERLAP,
        figure,
        tiles,
        map,
    })
}

/// The lines at which pages meet, in the middle of their overlap, with marks that both pages show.
fn joins(figure: &mut PaperFigure, raster: &Raster) {
    let mut number = 0;
    for axis in 0..2 {
        let other = 1 - axis;
        for k in 1..raster.count[axis] {
            #[allow(clippy::cast_precision_loss)]
            let at = k as f64 * raster.step[axis] + 0.5 * OVERLAP;
            let point = |along: f64, off: f64| {
                let mut point = [0.0; 2];
                point[axis] = at + off;
                point[other] = along;
                point
            };
            let end = raster.whole()[other];
            figure.polygon(
                PaperStyle::Frame,
                &[point(0.0, 0.0), point(end, 0.0)],
                false,
            );
            for row in 0..raster.count[other] {
                for share in [0.2, 0.8] {
                    #[allow(clippy::cast_precision_loss)]
                    let along = (row as f64 + share) * raster.step[other] + 0.5 * OVERLAP;
                    let cross = |by: f64| [point(along + by, -by), point(along - by, by)];
                    let cross_back = |by: f64| [point(along + by, by), point(along - by, -by)];
                    figure.polygon(PaperStyle::Mark, &cross(0.7 * ARM), false);
                    figure.polygon(PaperStyle::Mark, &cross_back(0.7 * ARM), false);
                    number += 1;
                    figure.text(
                        point(along + 1.1 * ARM, 0.0),
                        [1.0, 0.0],
                        2.4,
                        &number.to_string(),
                    );
                }
            }
        }
    }
}

/// Returns the pages on which something of the part is.
fn tiles(outline: &[Segment], to: ToPaper, raster: &Raster) -> Vec<PaperTile> {
    const POINTS: u32 = 64;
    let points: Vec<[f64; 2]> = outline
        .iter()
        .flat_map(|segment| {
            (0..POINTS).map(|k| to.point(segment.point(f64::from(k) / f64::from(POINTS))))
        })
        .collect();
    let corner = |column: usize, row: usize| {
        #[allow(clippy::cast_precision_loss)]
        [column as f64 * raster.step[0], row as f64 * raster.step[1]]
    };
    let used = |column: usize, row: usize| {
        let [x, y] = corner(column, row);
        let centre = [x + 0.5 * raster.window[0], y + 0.5 * raster.window[1]];
        let crossed = points
            .iter()
            .zip(points.iter().cycle().skip(1))
            .any(|(a, b)| {
                let low = [a[0].min(b[0]), a[1].min(b[1])];
                let high = [a[0].max(b[0]), a[1].max(b[1])];
                high[0] >= x
                    && low[0] <= x + raster.window[0]
                    && high[1] >= y
                    && low[1] <= y + raster.window[1]
            });
        crossed || is_within(&points, centre)
    };
    let all =
        (0..raster.count[1]).flat_map(|row| (0..raster.count[0]).map(move |column| [column, row]));
    let places: Vec<[usize; 2]> = all.filter(|[column, row]| used(*column, *row)).collect();
    let number = |column: Option<usize>, row: Option<usize>| {
        let place = [column?, row?];
        Some(places.iter().position(|other| *other == place)? + 1)
    };
    let tiles = places
        .iter()
        .enumerate()
        .map(|(k, &[column, row])| PaperTile {
            number: k + 1,
            at: corner(column, row),
            beside: [
                number(Some(column), row.checked_sub(1)),
                number(Some(column + 1), Some(row)),
                number(Some(column), Some(row + 1)),
                number(column.checked_sub(1), Some(row)),
            ],
        });
    tiles.collect()
}

/// Returns the part with the pages laid on it, small.
fn map(drawn: &Drawn<'_>, raster: &Raster, tiles: &[PaperTile], to: ToPaper) -> PaperFigure {
    let whole = raster.whole();
    let scale = (MAP[0] / whole[0]).min(MAP[1] / whole[1]);
    let mut map = PaperFigure {
        width: whole[0] * scale,
        height: whole[1] * scale,
        ..PaperFigure::default()
    };
    let small = ToPaper {
        scale,
        origin: to.origin.map(|c| c * scale),
    };
    map.chain(PaperStyle::Outline, &drawn.part.outline, true, small);
    for tile in tiles {
        let [x, y] = tile.at.map(|c| (c + 0.5 * OVERLAP) * scale);
        let [w, h] = raster.step.map(|c| c * scale);
        let corners = [[x, y], [x + w, y], [x + w, y + h], [x, y + h]];
        map.polygon(PaperStyle::Frame, &corners, true);
        let size = (0.35 * w.min(h)).min(6.0);
        map.bold(
            [x + 0.5 * w, y + 0.5 * h],
            [1.0, 0.0],
            size,
            &tile.number.to_string(),
        );
    }
    map
}
