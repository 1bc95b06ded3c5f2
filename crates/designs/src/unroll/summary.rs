//! What a pattern promises, in numbers.

use super::FlatPiece;
use crate::design::Design;
use crate::lines::wrapped;
use crate::numbers::{at_most, number};
use crate::openings::{Opening, OpeningShape, openings};
use serde::Serialize;
use std::f64::consts::PI;
use torse_geometry::pattern::{Flattening, PatternEvidence, bends};

/// The patterns of a design in numbers; lengths in millimetres, angles in degrees.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[non_exhaustive]
pub struct PatternSummary {
    /// The name of the design.
    pub design: String,
    /// The pieces.
    pub pieces: Vec<PieceSummary>,
}

/// A pattern in numbers.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[non_exhaustive]
pub struct PieceSummary {
    /// The name of the chain or the patch.
    pub name: String,
    /// The patches that are attached.
    pub patches: Vec<String>,
    /// Whether the pattern is what is cut: no bend of a tool has an allowance.
    pub is_blank: bool,
    /// Width and height of the box around it.
    pub size: [f64; 2],
    /// The area inside the outline, without the openings.
    pub area: f64,
    /// The length of the cut, around the openings too.
    pub cut: f64,
    /// How many lines and arcs the outline has.
    pub segments: usize,
    /// No point of the outline is farther from the exact one; of a piece that is not exactly developable, from any
    /// development of no greater strain, after a motion.
    pub outline_error: f64,
    /// The part of it that is due to the choice of the development: 0 for what is exactly developable.
    pub ambiguity: f64,
    /// Which development of a piece that is not exactly developable it is: `edges`, `edge-1`, `edge-2`, `between`.
    pub development: Option<&'static str>,
    /// Whether the bounds are proved; they are measured otherwise.
    pub proved: bool,
    /// By how much the edges of each patch are longer in space than on the pattern, at most.
    pub shortened: Vec<[f64; 2]>,
    /// No mark is farther from its exact place.
    pub point_error: f64,
    /// No angle between rulings is off by more, in degrees.
    pub angle_error: f64,
    /// The length of the outline is not off by more; for that around openings which are not round no bound is known.
    pub length_error: f64,
    /// The area is not off by more, that of openings included.
    pub area_error: f64,
    /// No line is stretched or shortened by a larger share of its length.
    pub strain: f64,
    /// Whether that is more than counts as developable.
    pub strained: bool,
    /// The smallest radius of bending; `null` for a flat pattern.
    pub radius: Option<f64>,
    /// The bends; with allowances where the thickness is known.
    pub bends: Vec<BendRow>,
    /// By how much the neutral axis is longer than the pattern, summed up over all bends, where a thickness is known
    /// and no edge lacks a radius. What tools bend is in the list of parts.
    pub growth: Option<f64>,
}

/// A line at which a pattern is bent.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[non_exhaustive]
pub struct BendRow {
    /// The number of the ruling, from 0.
    pub ruling: usize,
    /// The angle in degrees, positive towards the viewer.
    pub angle: f64,
    /// The smallest radius of the middle of the sheet; `null` where it is flat on both sides of an edge.
    pub radius: Option<f64>,
    /// The length of the neutral axis in the bend.
    pub allowance: Option<f64>,
}

impl PatternSummary {
    /// Returns the numbers of these patterns.
    #[must_use]
    pub fn new(design: &Design, pieces: &[FlatPiece]) -> Self {
        Self {
            design: design.name.clone(),
            pieces: pieces.iter().map(|piece| summary(design, piece)).collect(),
        }
    }

    /// Returns the numbers for people, in lines of at most 100 columns.
    #[must_use]
    pub fn text(&self) -> String {
        let mut text = String::new();
        for piece in &self.pieces {
            let [width, height] = piece.size.map(number);
            let mut words = format!(
                "{width} x {height} mm, area {} mm2 (within {}), cut {} mm of {} lines and arcs, nowhere farther than \
                 {} mm from {}",
                number(piece.area),
                at_most(piece.area_error),
                number(piece.cut),
                piece.segments,
                at_most(piece.outline_error - piece.ambiguity),
                piece.exact_outline()
            );
            words += &piece.beside_others(piece.outline_error);
            if let Some(radius) = piece.radius {
                words += &format!("; smallest radius {} mm", number(radius));
            }
            words += &piece.strain_told();
            let label = if piece.is_blank {
                format!("{}: ", piece.name)
            } else {
                format!("{}, developed surface, not the blank: ", piece.name)
            };
            text.push_str(&wrapped(&label, &words));
        }
        text
    }
}

impl PieceSummary {
    /// Returns, of a piece that is not exactly developable, how far its pattern is from others that could be made, of which
    /// none is farther than this.
    pub(super) fn beside_others(&self, farthest: f64) -> String {
        if self.development.is_none() {
            return String::new();
        }
        let longest = self.shortened.iter().flatten();
        let longest = longest.fold(0.0_f64, |m, s| m.max(*s));
        format!(
            ", nor than {} mm from any other of no greater strain; lines change by at most {} of their length, edges by \
             {} mm",
            at_most(farthest),
            at_most(self.strain),
            at_most(longest)
        )
    }

    /// Returns the remark on a strain that is more than counts as developable.
    pub(super) fn strain_told(&self) -> String {
        if !self.strained {
            return String::new();
        }
        let strain = at_most(self.strain);
        format!("; STRAINED: lines change by up to {strain} of their length")
    }

    /// Returns what the outline is compared with.
    fn exact_outline(&self) -> String {
        let of = match self.development {
            None => "the exact outline".to_owned(),
            Some(name) => format!("the development that is made (`{name}`)"),
        };
        if self.proved {
            of
        } else {
            format!("{of} (measured, not proved)")
        }
    }
}

/// Returns how far the area of an opening may be from that of the exact one. The exact curve, moved straight onto this one,
/// stays within its error of this one: so only points so near to it can be inside of the one and outside of the other.
/// That is a band of twice the error along it. The centre of a round one is off, and not its radius.
fn area_error(opening: &Opening) -> f64 {
    match &opening.shape {
        OpeningShape::Round(..) => 0.0,
        OpeningShape::Contour(_) => {
            let error = opening.error;
            error * (2.0 * opening.shape.length() + PI * error)
        }
    }
}

fn summary(design: &Design, FlatPiece { piece, flat }: &FlatPiece) -> PieceSummary {
    let [low, high] = flat.outline().bounds();
    let errors = flat.errors();
    let finite = |value: f64| value.is_finite().then_some(value);
    let name = |index: &usize| design.patches.get(*index).map(|patch| patch.name.clone());
    let (rows, growth): (Vec<BendRow>, Option<f64>) = match design.metal {
        Some(metal) => {
            let all = bends(flat, &metal.sheet);
            let rounded = all.iter().all(|bend| bend.radius.is_finite());
            let growth = rounded.then(|| all.iter().map(|bend| bend.growth).sum());
            let rows = all.iter().map(|bend| BendRow {
                ruling: bend.ruling,
                angle: bend.angle.to_degrees(),
                radius: finite(bend.radius),
                allowance: finite(bend.allowance),
            });
            (rows.collect(), growth)
        }
        None => {
            let rulings = flat.rulings().iter().enumerate();
            let bent = rulings.filter(|(_, ruling)| ruling.bend != 0.0);
            let rows = bent.map(|(index, ruling)| BendRow {
                ruling: index,
                angle: ruling.bend.to_degrees(),
                radius: finite(ruling.radius),
                allowance: None,
            });
            (rows.collect(), None)
        }
    };
    // What is refused has no drawing either.
    let openings = openings(design, piece, flat).unwrap_or_default();
    let open: f64 = openings.iter().map(|opening| opening.shape.area()).sum();
    let around: f64 = openings.iter().map(|opening| opening.shape.length()).sum();
    PieceSummary {
        name: piece.name.clone(),
        patches: piece.patches.iter().filter_map(name).collect(),
        is_blank: !piece.has_tool_bends(design),
        size: [high[0] - low[0], high[1] - low[1]],
        area: flat.area() - open,
        cut: flat.outline().length() + around,
        segments: flat.outline().segments().len(),
        outline_error: errors.outline + errors.ambiguity,
        ambiguity: errors.ambiguity,
        development: flat.flattening().map(Flattening::name),
        proved: flat.evidence() == PatternEvidence::Proved,
        shortened: (0..flat.pieces())
            .filter_map(|index| flat.shortened(index))
            .collect(),
        point_error: errors.point,
        angle_error: errors.angle.to_degrees(),
        length_error: errors.length,
        area_error: errors.area + openings.iter().map(area_error).sum::<f64>(),
        strain: flat.strain(),
        strained: flat.is_strained(),
        radius: finite(flat.smallest_radius()),
        bends: rows,
        growth,
    }
}
