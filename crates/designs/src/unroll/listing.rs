//! The list of parts: what is cut, how large it is, and how it is formed.

use super::beside::{BesideBend, beside_bends};
use super::part::{Part, kerf_words};
use super::summary::{PatternSummary, PieceSummary};
use crate::design::Design;
use crate::lines::wrapped;
use crate::numbers::{at_most, number};
use serde::Serialize;
use std::fmt::Write;

/// A part in numbers; lengths in millimetres, angles in degrees.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[non_exhaustive]
pub struct PartRow {
    /// The name of the chain or the patch.
    pub name: String,
    /// The file that it was written to, where it was written to one.
    pub file: Option<String>,
    /// How many are needed of it.
    pub count: usize,
    /// Width and height of its smallest box.
    pub size: [f64; 2],
    /// The area without the openings.
    pub area: f64,
    /// The length of the cut, around the openings too.
    pub cut_length: f64,
    /// How many lines and arcs the outline has.
    pub segments: usize,
    /// How many openings there are.
    pub openings: usize,
    /// How many marks the file gives it: lines and circles are drawn for `bend` and `sew`, lettering on paper alone.
    pub marks: usize,
    /// Whether it has allowances, which the outline has and the seam line has not.
    pub allowance: bool,
    /// The width of the cut: the outline is moved outward by half of it, the openings inward, and the sizes are those of
    /// the moved lines.
    pub kerf: f64,
    /// No point of the outline, without allowances and before it was moved for the kerf, nor of an opening is farther from
    /// that of the exact part.
    pub error: f64,
    /// Whether that is proved; it is measured otherwise.
    pub proved: bool,
    /// The bends over tools.
    pub bends: Vec<ToolBendRow>,
    /// The openings that are so near to a bend that it may pull them out of shape.
    pub beside_bends: Vec<BesideBend>,
    /// Edges without a radius.
    pub sharp: Vec<SharpRow>,
    /// Patches that are rolled.
    pub rolled: Vec<RolledRow>,
}

/// A bend over a tool.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[non_exhaustive]
pub struct ToolBendRow {
    /// The patch, or the two patches of an edge.
    pub name: String,
    /// The angle, without a sign.
    pub angle: f64,
    /// `up`, towards the viewer of the drawing, or `down`.
    pub direction: &'static str,
    /// The inside radius.
    pub inside_radius: f64,
    /// Where the neutral line runs, as a share of the thickness from the inside.
    pub k_factor: f64,
    /// The length of the neutral line.
    pub allowance: f64,
    /// What the blank falls short of both outer flanges; `null` from 180 degrees on, where their outer faces do not meet.
    pub deduction: Option<f64>,
    /// The ends of the bend line in the drawing.
    pub line: [[f64; 2]; 2],
}

/// An edge that no radius is given for.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[non_exhaustive]
pub struct SharpRow {
    /// The two patches.
    pub name: String,
    /// The angle, without a sign.
    pub angle: f64,
    /// `up` or `down`.
    pub direction: &'static str,
}

/// A patch that is rolled.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[non_exhaustive]
pub struct RolledRow {
    /// The patch.
    pub name: String,
    /// The smallest of the radii of the rulings, of each where it is tightest; of a cone that reaches its apex, at the
    /// other end.
    pub from: f64,
    /// The largest; `null` where it is flat somewhere.
    pub to: Option<f64>,
    /// Whether it reaches its apex, towards which all radii fall to 0.
    pub apex: bool,
}

/// The parts of a design in numbers.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[non_exhaustive]
pub struct PartsList {
    /// The name of the design.
    pub design: String,
    /// The thickness, where one is known.
    pub thickness: Option<f64>,
    /// The parts.
    pub parts: Vec<PartRow>,
}

fn direction(angle: f64) -> &'static str {
    if angle > 0.0 { "up" } else { "down" }
}

impl PartsList {
    /// Returns the list of these parts, none written yet.
    #[must_use]
    pub fn new(design: &Design, parts: &[Part]) -> Self {
        Self {
            design: design.name.clone(),
            thickness: design.metal.map(|metal| metal.sheet.thickness()),
            parts: parts.iter().map(|part| row(design, part)).collect(),
        }
    }

    /// Returns the list as comma-separated values with a head.
    #[must_use]
    pub fn csv(&self) -> String {
        let mut text = String::from(
            "part,file,count,width mm,height mm,area mm2,cut length mm,openings,thickness mm,bends,error mm,kerf mm\n",
        );
        for part in &self.parts {
            let thickness = self.thickness.map(|t| t.to_string()).unwrap_or_default();
            // Writing to a String cannot fail.
            let _ = writeln!(
                text,
                "{},{},{},{:.4},{:.4},{:.4},{:.4},{},{thickness},{},{},{}",
                field(&part.name),
                field(part.file.as_deref().unwrap_or_default()),
                part.count,
                part.size[0],
                part.size[1],
                part.area,
                part.cut_length,
                part.openings,
                part.bends.len() + part.sharp.len(),
                at_most(part.error),
                part.kerf
            );
        }
        text
    }

    /// Returns the list for people, in lines of at most 100 columns, with what has to be said of the patterns that the parts
    /// are made from: which development, and how far it is strained. Sizes are those of the parts alone.
    #[must_use]
    pub fn text(&self, patterns: &PatternSummary) -> String {
        let of_part = |part: &PartRow| {
            let pattern = patterns.pieces.iter().find(|piece| piece.name == part.name);
            part.text(pattern)
        };
        self.parts.iter().map(of_part).collect()
    }
}

/// Returns a field of a table, in quotes where it needs them.
fn field(text: &str) -> String {
    if text.contains([',', '"', '\n']) {
        return format!("\"{}\"", text.replace('"', "\"\""));
    }
    text.to_owned()
}

impl PartRow {
    fn text(&self, pattern: Option<&PieceSummary>) -> String {
        let exact = match pattern.and_then(|piece| piece.development) {
            Some(name) => format!("the development that is made (`{name}`)"),
            None => "the exact part".to_owned(),
        };
        let [width, height] = self.size.map(|length| format!("{length:.3}"));
        let mut words = format!(
            "{width} x {height} mm, area {} mm2, cut {} mm of {} lines and arcs{}, {} farther than {} mm from {exact}{}",
            number(self.area),
            number(self.cut_length),
            self.segments,
            match self.openings {
                0 => String::new(),
                1 => " and 1 opening".to_owned(),
                count => format!(" and {count} openings"),
            },
            match (kerf_words(self.kerf), self.allowance) {
                (None, false) => "nowhere".to_owned(),
                (None, true) => "with allowances, the seam line nowhere".to_owned(),
                (Some(kerf), false) => format!("{kerf}; before that nowhere"),
                (Some(kerf), true) => format!("with allowances, {kerf}; the seam line nowhere"),
            },
            at_most(self.error),
            if self.proved {
                ""
            } else {
                " (measured, not proved)"
            }
        );
        if let Some(pattern) = pattern {
            words += &pattern.beside_others(self.error + pattern.ambiguity);
            words += &pattern.strain_told();
        }
        for bend in &self.bends {
            let _ = write!(
                words,
                "; bend {} by {} degrees {} over an inside radius of {} mm: {:.3} mm on the blank (K = {})",
                bend.name,
                number(bend.angle),
                bend.direction,
                number(bend.inside_radius),
                bend.allowance,
                number(bend.k_factor)
            );
        }
        for near in &self.beside_bends {
            let _ = write!(words, "; {}", near.words());
        }
        for fold in &self.sharp {
            let _ = write!(
                words,
                "; score {} for {} degrees {}, or give its chain a `radius`",
                fold.name,
                number(fold.angle),
                fold.direction
            );
        }
        let [cones, others]: [Vec<&RolledRow>; 2] =
            [true, false].map(|apex| self.rolled.iter().filter(|row| row.apex == apex).collect());
        if let Some(radii) = radii_of(&others) {
            let _ = write!(words, "; roll to {radii} where each ruling is tightest");
        }
        if let Some(radii) = radii_of(&cones) {
            let _ = write!(
                words,
                "; roll to {radii} at the wide end, towards 0 at the apex"
            );
        }
        wrapped(&format!("cut {}: ", self.name), &words)
    }
}

/// A sheet of a larger radius, in millimetres, is flat.
const MAX_ROLLED_RADIUS: f64 = 1e6;

/// Returns the radii of patches in words; `None` where there are none.
fn radii_of(rows: &[&RolledRow]) -> Option<String> {
    let from = rows.iter().map(|row| row.from).min_by(f64::total_cmp)?;
    let to: Option<Vec<f64>> = rows.iter().map(|row| row.to).collect();
    let to = to.map(|all| all.into_iter().fold(0.0, f64::max));
    let to = to.filter(|radius| *radius < MAX_ROLLED_RADIUS);
    let (from, to) = (number(from), to.map(number));
    Some(match to {
        Some(to) if to == from => format!("radius {from} mm"),
        Some(to) => format!("radii from {from} to {to} mm"),
        None => format!("radii from {from} mm to flat"),
    })
}

fn row(design: &Design, part: &Part) -> PartRow {
    PartRow {
        name: part.name.clone(),
        file: None,
        count: 1,
        size: part.size,
        area: part.area(),
        cut_length: part.cut_length(),
        segments: part.outline.len(),
        openings: part.openings.len(),
        marks: part.marks.len(),
        allowance: part.seam_line.is_some(),
        kerf: part.kerf,
        error: part.error,
        proved: part.proved,
        bends: part
            .bends
            .iter()
            .map(|bend| ToolBendRow {
                name: bend.name.clone(),
                angle: bend.angle.abs().to_degrees(),
                direction: direction(bend.angle),
                inside_radius: bend.inside_radius,
                k_factor: bend.k_factor,
                allowance: bend.allowance,
                deduction: bend.deduction,
                line: bend.line,
            })
            .collect(),
        beside_bends: design.metal.map_or(Vec::new(), |metal| {
            beside_bends(metal.sheet.thickness(), &part.openings, &part.bends)
        }),
        sharp: part
            .sharp
            .iter()
            .map(|fold| SharpRow {
                name: fold.name.clone(),
                angle: fold.angle.abs().to_degrees(),
                direction: direction(fold.angle),
            })
            .collect(),
        rolled: part
            .rolled
            .iter()
            .map(|rolled| RolledRow {
                name: rolled.name.clone(),
                from: rolled.radii[0],
                to: Some(rolled.radii[1]).filter(|radius| radius.is_finite()),
                apex: rolled.apex,
            })
            .collect(),
    }
}
