//! Sheets of paper for who makes a part: the drawing for the fitter, and the part in true size on pages.
//!
//! Both are values: what stands where, in millimetres on paper and in words. A typesetter draws them.

mod figure;
mod forming;
mod layout;
mod sides;
mod space;
mod tiles;
mod words;

pub use figure::{PaperFigure, PaperLine, PaperStyle, PaperText};
pub use layout::{BenchLayout, PaperScale, PaperSize};
pub use tiles::{PaperTile, TiledPart};

use crate::design::Design;
use crate::error::DesignError;
use crate::numbers::at_most;
use crate::openings::OpeningShape;
use crate::unroll::{Blank, FlatPiece, Part, beside_bends, blank};
use forming::forming;
use layout::{Drawn, drawing, layout};
use serde::Serialize;
use sides::{Side, letter, pair, sides};
use words::length;

/// A table of a sheet.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[non_exhaustive]
pub struct BenchTable {
    /// What it is about.
    pub title: String,
    /// The names of its columns.
    pub head: Vec<String>,
    /// Its rows.
    pub rows: Vec<Vec<String>>,
}

/// An entry of the legend.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[non_exhaustive]
pub struct BenchLegend {
    /// How the line is drawn.
    pub style: PaperStyle,
    /// What it is.
    pub words: &'static str,
}

/// The sheet of a part for the fitter.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[non_exhaustive]
pub struct BenchSheet {
    /// The design.
    pub design: String,
    /// Its title.
    pub title: String,
    /// The part.
    pub part: String,
    /// The letter with which the labels of its sides begin.
    pub letter: String,
    /// Which of the parts it is, from 1, and how many there are.
    pub number: [usize; 2],
    /// The material, where the design names one.
    pub material: Option<String>,
    /// The thickness in millimetres, where it is known.
    pub thickness: Option<String>,
    /// The name of the paper, and its width and height in millimetres, across.
    pub paper: &'static str,
    /// Width and height of the page.
    pub page: [f64; 2],
    /// The white edge about it.
    pub edge: f64,
    /// The height of the title block at its lower edge.
    pub title_block: f64,
    /// Where the drawing stands.
    pub layout: BenchLayout,
    /// The scale of the drawing.
    pub scale: PaperScale,
    /// The drawing.
    pub figure: PaperFigure,
    /// The part in space among the others, as SVG.
    pub view: String,
    /// Names and values: size, area, length of the cut.
    pub facts: Vec<[String; 2]>,
    /// What the fitter has to know, in sentences.
    pub notes: Vec<String>,
    /// How it is formed, which sides meet, where openings are.
    pub tables: Vec<BenchTable>,
    /// The lines that occur in the drawing.
    pub legend: Vec<BenchLegend>,
}

/// White edges of the page of a sheet for the fitter.
const EDGE: f64 = 8.0;
/// The height of the title block, and the room above it.
const TITLE_BLOCK: f64 = 21.0;
/// What is less than this, in millimetres, is not told apart at a bench.
const LEAST: f64 = 1e-3;

fn strings(words: &[&str]) -> Vec<String> {
    words.iter().map(|word| (*word).to_owned()).collect()
}

/// The parts with what sheets are made from.
struct Prepared {
    blanks: Vec<Blank>,
    sides: Vec<Vec<Side>>,
}

fn prepared(
    design: &Design,
    pieces: &[FlatPiece],
    parts: &[Part],
) -> Result<Prepared, DesignError> {
    let blanks: Vec<Blank> = pieces
        .iter()
        .map(|piece| blank(design, piece))
        .collect::<Result<_, _>>()?;
    let mut all = Vec::new();
    for (k, ((piece, part), blank)) in pieces.iter().zip(parts).zip(&blanks).enumerate() {
        all.push(sides(design, piece, part, blank, &letter(k))?);
    }
    pair(design, &mut all);
    Ok(Prepared { blanks, sides: all })
}

/// Returns the sheets of these parts for the fitter, a page each; `parts` are those of `pieces`.
///
/// # Errors
/// As [`blank`], [`DesignError::Patch`] and [`DesignError::Figure`].
///
/// ```
/// use torse_designs::bench::{PaperSize, bench_sheets};
/// use torse_designs::unroll::{Demand, parts, unroll};
/// let design = torse_designs::read("tube.toml", r#"
///     [curves.rim]
///     arc = { centre = [0, 0, 0], from = [20, 0, 0], to = [0, 20, 0] }
///     [patches.tube]
///     cylinder = "rim"
///     direction = [0, 0, 30]
/// "#)?;
/// let pieces = unroll(&design, &Demand::default())?;
/// let sheets = bench_sheets(&design, &pieces, &parts(&design, &pieces)?, PaperSize::A4)?;
/// // A quarter of a tube, 31.4 mm by 30 mm, drawn larger than it is.
/// assert_eq!((sheets[0].scale.name.as_str(), sheets[0].tables[0].rows[0][1].as_str()), ("2:1", "20"));
/// # Ok::<(), torse_designs::DesignError>(())
/// ```
pub fn bench_sheets(
    design: &Design,
    pieces: &[FlatPiece],
    parts: &[Part],
    paper: PaperSize,
) -> Result<Vec<BenchSheet>, DesignError> {
    let Prepared { blanks, sides } = prepared(design, pieces, parts)?;
    let mut sheets = Vec::new();
    for (k, (piece, part)) in pieces.iter().zip(parts).enumerate() {
        let (Some(blank), Some(sides)) = (blanks.get(k), sides.get(k)) else {
            continue;
        };
        let drawn = Drawn {
            piece,
            part,
            blank,
            sides,
        };
        sheets.push(sheet(design, &drawn, [k, parts.len()], paper)?);
    }
    Ok(sheets)
}

/// These parts in true size on pages; `parts` are those of `pieces`.
///
/// # Errors
/// As [`bench_sheets`], and [`DesignError::Parts`] for a part that takes too many pages.
pub fn tiled_parts(
    design: &Design,
    pieces: &[FlatPiece],
    parts: &[Part],
    paper: PaperSize,
) -> Result<Vec<TiledPart>, DesignError> {
    let Prepared { blanks, sides } = prepared(design, pieces, parts)?;
    let all = pieces.iter().zip(parts).zip(blanks.iter().zip(&sides));
    all.enumerate()
        .map(|(k, ((piece, part), (blank, sides)))| {
            let drawn = Drawn {
                piece,
                part,
                blank,
                sides,
            };
            tiles::tiled(&drawn, [&design.name, &design.title, &letter(k)], paper)
        })
        .collect()
}

fn sheet(
    design: &Design,
    drawn: &Drawn<'_>,
    [k, count]: [usize; 2],
    paper: PaperSize,
) -> Result<BenchSheet, DesignError> {
    let Drawn {
        piece, part, sides, ..
    } = drawn;
    let [height, width] = paper.millimetres();
    let room = [width - 2.0 * EDGE, height - 2.0 * EDGE - TITLE_BLOCK];
    let (layout, size) = layout(part.size, room);
    let (figure, scale) = drawing(drawn, size);
    let forming = forming(design, piece, part, sides)?;
    let mut tables = forming.tables;
    tables.push(BenchTable {
        title: "Edges, against the clock".to_owned(),
        head: strings(&["edge", "in the design", "length", "from x, y", "meets"]),
        rows: sides.iter().map(Side::row).collect(),
    });
    if !part.openings.is_empty() {
        tables.push(openings(part));
    }
    let mut notes = forming.notes;
    notes.push(format!(
        "{} is farther than {} mm from the exact part ({}); {} mm were allowed.",
        match (&part.seam_line, part.kerf > 0.0) {
            (Some(_), _) => "No point of the seam line",
            (None, true) => "No cut line, before it was moved for the kerf,",
            (None, false) => "No cut line",
        },
        at_most(part.error.max(LEAST)),
        if part.proved {
            "proved"
        } else {
            "measured, not proved"
        },
        length(design.tolerances.outline)
    ));
    if let Some(kerf) = part.kerf_words() {
        notes.push(format!("Not the nominal part: {kerf}."));
    }
    if !part.bends.is_empty() {
        notes.push("An edge that meets a bend ends at the bend line.".to_owned());
    }
    if let Some(metal) = design.metal {
        let thickness = metal.sheet.thickness();
        let near = beside_bends(thickness, &part.openings, &part.bends);
        notes.extend(near.iter().map(|near| format!("{}.", near.words())));
    }
    if piece.flat.is_strained() {
        notes.push(format!(
            "The surface is not developable: lines change by up to {} of their length.",
            at_most(piece.flat.strain())
        ));
    }
    notes.push("Lengths in mm; x and y from the lower left corner of the box (0, 0).".to_owned());
    Ok(BenchSheet {
        design: design.name.clone(),
        title: design.title.clone(),
        part: part.name.clone(),
        letter: letter(k),
        number: [k + 1, count],
        material: design.material.clone(),
        thickness: design.metal.map(|metal| length(metal.sheet.thickness())),
        paper: paper.name(),
        page: [width, height],
        edge: EDGE,
        title_block: TITLE_BLOCK,
        layout,
        scale,
        legend: legend(&figure),
        figure,
        view: space::view(design, piece, part, sides)?.svg,
        facts: facts(part),
        notes,
        tables,
    })
}

fn openings(part: &Part) -> BenchTable {
    let all = part.openings.iter().enumerate();
    let rows = all.map(|(k, opening)| {
        let size = match &opening.shape {
            OpeningShape::Round(_, radius) => format!("⌀ {}", length(2.0 * radius)),
            OpeningShape::Contour(_) => {
                let [low, high] = opening.shape.bounds();
                let [width, height] = [0, 1].map(|i| length(high[i] - low[i]));
                format!("{width} × {height}")
            }
        };
        let [x, y] = opening.shape.middle().map(length);
        vec![format!("H{}", k + 1), size, x, y]
    });
    BenchTable {
        title: "Openings".to_owned(),
        head: strings(&["hole", "size", "x", "y"]),
        rows: rows.collect(),
    }
}

fn facts(part: &Part) -> Vec<[String; 2]> {
    let [width, height] = part.size.map(length);
    let area = part.area();
    let area = if area < 1e4 {
        format!("{} mm²", length(area))
    } else if area < 1e6 {
        format!("{} cm²", length(area / 100.0))
    } else {
        format!("{} m²", length(area / 1e6))
    };
    let facts = [
        ("Blank", format!("{width} × {height} mm")),
        ("Area", area),
        ("Cut", format!("{} mm", length(part.cut_length()))),
    ];
    facts.map(|(name, value)| [name.to_owned(), value]).to_vec()
}

/// Returns what the lines that occur in a drawing mean.
fn legend(figure: &PaperFigure) -> Vec<BenchLegend> {
    let all = [
        (PaperStyle::Outline, "cut"),
        (PaperStyle::Seam, "seam, inside of the allowance"),
        (PaperStyle::BendUp, "bend up, towards the reader"),
        (PaperStyle::BendDown, "bend down, away from the reader"),
        (
            PaperStyle::Ruling,
            "straight when rolled: parallel to the rolls",
        ),
        (PaperStyle::Mark, "mark, centre, notch"),
    ];
    let occurs = |style: PaperStyle| figure.lines.iter().any(|line| line.style == style);
    all.into_iter()
        .filter(|(style, _)| occurs(*style))
        .map(|(style, words)| BenchLegend { style, words })
        .collect()
}
