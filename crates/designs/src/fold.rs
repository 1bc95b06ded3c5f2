//! Folding a pattern file back into space and comparing it with the design.
//!
//! Folding uses the pattern file alone: outline, rulings, bend angles. The sheet between two rulings is taken as flat,
//! so the points miss the design by what falls with the square of the number of rulings. The pattern of the design
//! itself, with as many rulings, misses it by as much: what is judged is how far the two folded patterns are from each
//! other, or, where the file says `fold`, how far the points are from the design.

use crate::design::{Design, DesignPiece};
use crate::error::DesignError;
use crate::lines::wrapped;
use crate::numbers::number;
use crate::unroll::{Demand, unroll};
use serde::Serialize;
use std::path::Path;
use torse_exchange::{Drawing, Layer, Path as DrawnPath, text_of_file};
use torse_geometry::pattern::{FlatPattern, FlatRuling, PatternError, Segment, deviation, fold};

/// The largest pattern file that is read, in bytes.
const MAX_BYTES: u64 = 64 << 20;

/// What folding a pattern came to.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[non_exhaustive]
pub struct FoldReport {
    /// The name of the design.
    pub design: String,
    /// The pieces in the order of the file.
    pub pieces: Vec<FoldedPiece>,
    /// What is missed, in words; empty when the pattern is one of the design.
    pub missed: Vec<String>,
}

/// A piece of a pattern that was folded.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[non_exhaustive]
pub struct FoldedPiece {
    /// The chain or the patch.
    pub name: String,
    /// How many rulings the file shows.
    pub rulings: usize,
    /// The largest distance of the end of a ruling from the outline of the file.
    pub off_outline: f64,
    /// The difference of the area inside the outline of the file from that of the design.
    pub area_difference: f64,
    /// The largest distance of the folded points from the design, after the best rigid motion.
    pub deviation: f64,
    /// The same of the design's own pattern with as many rulings: what flat facets cost.
    pub expected: f64,
    /// The largest distance of the folded points from the design's own pattern, folded.
    pub difference: f64,
}

impl FoldReport {
    /// Returns the report for people.
    #[must_use]
    pub fn text(&self) -> String {
        let mut text = String::new();
        for piece in &self.pieces {
            let words = format!(
                "{} rulings of the file fold to within {} mm of the design ({} mm is what flat facets cost), {} mm from the \
                 design's own pattern; they end {} mm from the outline, whose area differs by {} mm2",
                piece.rulings,
                number(piece.deviation),
                number(piece.expected),
                number(piece.difference),
                number(piece.off_outline),
                number(piece.area_difference)
            );
            text.push_str(&wrapped(&format!("{}: ", piece.name), &words));
        }
        for reason in &self.missed {
            text.push_str(&wrapped("missed: ", reason));
        }
        text
    }
}

/// Reads a pattern of a design, DXF or, by its ending, SVG, folds it and compares it with the design.
///
/// # Errors
/// [`DesignError::Unreadable`] and [`DesignError::Pattern`] for a file that is no pattern of this design, and as
/// [`unroll`] where the design has none.
pub fn fold_back(design: &Design, path: &Path) -> Result<FoldReport, DesignError> {
    let shown = path.display().to_string();
    let unreadable = |reason: String| DesignError::Unreadable {
        path: shown.clone(),
        reason,
    };
    let size = std::fs::metadata(path)
        .map_err(|e| unreadable(e.to_string()))?
        .len();
    if size > MAX_BYTES {
        return Err(unreadable(format!("it is longer than {MAX_BYTES} bytes")));
    }
    let bytes = std::fs::read(path).map_err(|e| unreadable(e.to_string()))?;
    let text = text_of_file(&bytes).map_err(|e| unreadable(e.to_string()))?;
    fold_text(design, &shown, &text)
}

/// As [`fold_back`], of the text of a file with this name: SVG where it ends so, else DXF.
///
/// # Errors
/// As [`fold_back`].
pub fn fold_text(design: &Design, shown: &str, text: &str) -> Result<FoldReport, DesignError> {
    let wrong = |reason: String| DesignError::Pattern {
        path: shown.to_owned(),
        reason,
    };
    let svg = Path::new(shown)
        .extension()
        .is_some_and(|e| e.eq_ignore_ascii_case("svg"));
    let drawing = if svg {
        Drawing::from_svg(text)
    } else {
        Drawing::from_dxf(text)
    };
    let drawing = drawing.map_err(|error| wrong(error.to_string()))?;
    let found = patterns(&drawing);
    let mut wanted = design.pieces();
    wanted.retain(|piece| !design.has_border(piece));
    if found.len() != wanted.len() {
        return Err(wrong(format!(
            "{} outlines with rulings, and the design has {} pieces",
            found.len(),
            wanted.len()
        )));
    }
    let mut report = FoldReport {
        design: design.name.clone(),
        pieces: Vec::new(),
        missed: Vec::new(),
    };
    for (pattern, piece) in found.iter().zip(&wanted) {
        let own = own_pattern(design, piece, pattern.rulings.len())?;
        let Some(own) = own else {
            return Err(wrong(format!(
                "{} rulings are no pattern of the {} patches of `{}`",
                pattern.rulings.len(),
                piece.patches.len(),
                piece.name
            )));
        };
        let failed = |source: PatternError| wrong(source.to_string());
        report
            .pieces
            .push(compared(&piece.name, pattern, &own).map_err(failed)?);
    }
    report.missed = report
        .pieces
        .iter()
        .flat_map(|piece| objections(design, piece))
        .collect();
    Ok(report)
}

/// Returns the pattern of a piece of which so many rulings are drawn: all but those at which it ends in a tip. `None`
/// where no pattern has so many.
fn own_pattern(
    design: &Design,
    piece: &DesignPiece,
    count: usize,
) -> Result<Option<FlatPattern>, DesignError> {
    let patches = piece.patches.len().max(1);
    // A chain has a tip at either end at most.
    for all in count..=count + 2 {
        // Of a chain neighbours share a ruling.
        let each = all.saturating_sub(1) / patches + 1;
        if each < 2 || (each - 1) * patches + 1 != all {
            continue;
        }
        let demand = Demand {
            // What was strained to be cut is compared with the strained pattern of the design.
            allow_strain: 0.5,
            rulings: Some(each),
            only: Some(piece.name.clone()),
            ..Demand::default()
        };
        let own = unroll(design, &demand)?.into_iter().next();
        let own = own.map(|own| own.flat);
        let drawn = |own: &FlatPattern| own.rulings().iter().filter(|r| !r.is_point()).count();
        if let Some(own) = own.filter(|own| drawn(own) == count) {
            return Ok(Some(own));
        }
    }
    Ok(None)
}

/// An outline of a file with the rulings that follow it.
struct Pattern<'d> {
    outline: &'d DrawnPath,
    rulings: Vec<[[f64; 2]; 2]>,
    bends: Vec<f64>,
}

/// Returns the patterns of a drawing: a closed outline, then its rulings; outlines without rulings are holes.
fn patterns(drawing: &Drawing) -> Vec<Pattern<'_>> {
    let mut patterns: Vec<Pattern<'_>> = Vec::new();
    for path in drawing.paths() {
        if path.layer() == Layer::Outline && path.is_closed() {
            patterns.push(Pattern {
                outline: path,
                rulings: Vec::new(),
                bends: Vec::new(),
            });
        } else if let (Some(bend), [from, to], Some(last)) =
            (path.bend(), path.vertices(), patterns.last_mut())
        {
            last.rulings.push([from.point, to.point]);
            last.bends.push(bend);
        }
    }
    patterns.retain(|pattern| !pattern.rulings.is_empty());
    patterns
}

fn compared(
    name: &str,
    pattern: &Pattern<'_>,
    own: &FlatPattern,
) -> Result<FoldedPiece, PatternError> {
    let folded = fold(&pattern.rulings, &pattern.bends)?;
    let folded: Vec<[f64; 3]> = folded.into_iter().flatten().collect();
    let rulings = own.rulings();
    let drawn: Vec<&FlatRuling> = rulings.iter().filter(|r| !r.is_point()).collect();
    let in_space = own.rulings_in_space().into_iter().zip(rulings);
    let in_space = in_space.filter(|(_, ruling)| !ruling.is_point());
    let wanted: Vec<[f64; 3]> = in_space.flat_map(|(ends, _)| ends).collect();
    let reached = deviation(&folded, &wanted)?;
    let expected = own.fold_deviation()?;
    let rulings: Vec<[[f64; 2]; 2]> = drawn.iter().map(|ruling| ruling.ends).collect();
    let bends: Vec<f64> = drawn.iter().map(|ruling| ruling.bend).collect();
    let own_folded: Vec<[f64; 3]> = fold(&rulings, &bends)?.into_iter().flatten().collect();
    let difference = deviation(&folded, &own_folded)?;
    let vertices = pattern.outline.vertices();
    let next = vertices.iter().cycle().skip(1);
    let segments: Vec<Segment> = vertices
        .iter()
        .zip(next)
        .map(|(a, b)| Segment {
            from: a.point,
            to: b.point,
            bulge: a.bulge,
        })
        .collect();
    let distance = |point: &[f64; 2]| {
        let each = segments.iter().map(|segment| segment.distance(*point));
        each.fold(f64::INFINITY, f64::min)
    };
    let off_outline = pattern
        .rulings
        .iter()
        .flatten()
        .map(distance)
        .fold(0.0, f64::max);
    let area: f64 = segments.iter().map(Segment::area).sum();
    Ok(FoldedPiece {
        name: name.to_owned(),
        rulings: pattern.rulings.len(),
        off_outline,
        area_difference: area.abs() - own.outline().area(),
        deviation: reached,
        expected,
        difference,
    })
}

fn objections(design: &Design, piece: &FoldedPiece) -> Vec<String> {
    let mut missed = Vec::new();
    let name = &piece.name;
    let (what, distance, limit) = match design.tolerances.fold {
        Some(limit) => ("design", piece.deviation, limit),
        None => (
            "design's own pattern",
            piece.difference,
            design.tolerances.outline,
        ),
    };
    // NaN is no agreement.
    if distance.is_nan() || distance > limit {
        missed.push(format!(
            "{name}: the folded pattern is {distance:.6} mm from the {what}, {limit} allowed"
        ));
    }
    let outline = 2.0 * design.tolerances.outline;
    if piece.off_outline.is_nan() || piece.off_outline > outline {
        missed.push(format!(
            "{name}: rulings end {:.6} mm from the outline, {outline:.6} allowed",
            piece.off_outline
        ));
    }
    missed
}
