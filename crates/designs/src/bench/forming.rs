//! How a part is formed, in tables and sentences: bends over tools, edges to be scored, patches to be rolled.

use super::sides::Side;
use super::words::{degrees, length};
use super::{BenchTable, strings};
use crate::design::Design;
use crate::error::DesignError;
use crate::numbers::number;
use crate::numbers::without_trailing_zeros;
use crate::position::position;
use crate::seams::PatchEdge;
use crate::unroll::{FlatPiece, Part};

/// Rulings at which the radii of a patch are measured.
const RULINGS: u32 = 64;
/// Radii that differ by no more, as a share, are one.
const SAME: f64 = 5e-3;

/// The way in which the sheet is formed, seen on its drawing.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum BendDirection {
    Up,
    Down,
}

impl BendDirection {
    fn by_sign(angle: f64) -> Self {
        if angle > 0.0 { Self::Up } else { Self::Down }
    }

    fn word(self) -> &'static str {
        match self {
            Self::Up => "up",
            Self::Down => "down",
        }
    }
}

/// What is to be done with a part: the tables, and which face the drawing shows.
pub(super) struct Forming {
    pub tables: Vec<BenchTable>,
    pub notes: Vec<String>,
}

/// Returns how a part is formed.
pub(super) fn forming(
    design: &Design,
    piece: &FlatPiece,
    part: &Part,
    sides: &[Side],
) -> Result<Forming, DesignError> {
    let mut ways: Vec<BendDirection> = part
        .bends
        .iter()
        .map(|b| BendDirection::by_sign(b.angle))
        .collect();
    ways.extend(
        part.sharp
            .iter()
            .map(|fold| BendDirection::by_sign(fold.angle)),
    );
    let mut tables = Vec::new();
    let mut notes = Vec::new();
    if !part.bends.is_empty() {
        tables.push(bends(part));
    }
    if !part.sharp.is_empty() {
        let rows = part.sharp.iter().enumerate().map(|(k, fold)| {
            vec![
                format!("S{}", k + 1),
                degrees(fold.angle.abs().to_degrees()),
                BendDirection::by_sign(fold.angle).word().to_owned(),
                place_of(fold.line),
            ]
        });
        tables.push(BenchTable {
            title: "Score and fold".to_owned(),
            head: strings(&["line", "angle", "way", "where"]),
            rows: rows.collect(),
        });
    }
    let (rows, rolled) = rolls(design, piece, part, sides)?;
    ways.extend(rolled);
    if !rows.is_empty() {
        tables.push(BenchTable {
            title: "Roll (radii of the middle of the sheet)".to_owned(),
            head: strings(&["what", "radius", "way"]),
            rows,
        });
        if let Some(metal) = design.metal {
            let half = length(0.5 * metal.sheet.thickness());
            notes.push(format!(
                "Inside radii are {half} mm less than those of the middle."
            ));
        }
    }
    notes.insert(0, face(&ways).to_owned());
    Ok(Forming { tables, notes })
}

/// Returns which face the drawing shows.
fn face(ways: &[BendDirection]) -> &'static str {
    let is = |way: BendDirection| ways.iter().all(|other| *other == way);
    match ways {
        [] => "The part stays flat; the drawing shows the face that is blue in the view.",
        _ if is(BendDirection::Up) => {
            "The drawing shows the INSIDE: all forming goes up, towards the reader."
        }
        _ if is(BendDirection::Down) => {
            "The drawing shows the OUTSIDE: all forming goes down, away from the reader."
        }
        _ => "The drawing shows the face that is blue in the view; up is towards the reader.",
    }
}

fn bends(part: &Part) -> BenchTable {
    let rows = part.bends.iter().enumerate().map(|(k, bend)| {
        vec![
            format!("B{}", k + 1),
            degrees(bend.angle.abs().to_degrees()),
            BendDirection::by_sign(bend.angle).word().to_owned(),
            length(bend.inside_radius),
            place_of(bend.line),
            length(bend.allowance),
            bend.deduction.map_or_else(|| "-".to_owned(), length),
            without_trailing_zeros(&format!("{:.3}", bend.k_factor)),
        ]
    });
    BenchTable {
        title: "Bend over a tool (angle from flat)".to_owned(),
        head: strings(&[
            "bend",
            "angle",
            "way",
            "inside R",
            "line at",
            "allowance",
            "deduction",
            "K",
        ]),
        rows: rows.collect(),
    }
}

/// Returns where a line is: its distance from a side of the box if it runs along one, else its ends.
fn place_of([[x, y], [s, t]]: [[f64; 2]; 2]) -> String {
    const ALONG: f64 = 5e-3;
    if (x - s).abs() < ALONG {
        format!("x = {}", length(0.5 * (x + s)))
    } else if (y - t).abs() < ALONG {
        format!("y = {}", length(0.5 * (y + t)))
    } else {
        format!(
            "{}, {} to {}, {}",
            length(x),
            length(y),
            length(s),
            length(t)
        )
    }
}

/// Returns the rows of what is rolled, patches that are rolled alike in one, and the ways.
fn rolls(
    design: &Design,
    piece: &FlatPiece,
    part: &Part,
    sides: &[Side],
) -> Result<(Vec<Vec<String>>, Vec<BendDirection>), DesignError> {
    let mut rows: Vec<(Vec<String>, [String; 2])> = Vec::new();
    let mut ways = Vec::new();
    for rolled in &part.rolled {
        let index = design.patches.iter().position(|p| p.name == rolled.name);
        let Some((index, patch)) = index.and_then(|k| Some((k, design.patches.get(k)?))) else {
            continue;
        };
        let Some(place) = position(&piece.flat, patch) else {
            continue;
        };
        let own = piece.flat.rulings().iter().filter(|r| r.piece == place);
        let way = BendDirection::by_sign(own.map(|ruling| ruling.bend).sum());
        ways.push(way);
        let mut radii = Vec::new();
        for (v, edge) in [(0.0, PatchEdge::First), (1.0, PatchEdge::Second)] {
            let found = along(patch, v)?;
            let side = sides
                .iter()
                .find(|side| side.members.contains(&(index, edge)));
            radii.push((found, side.map(|side| side.label.clone())));
        }
        let words = match radii.as_slice() {
            [(a, _), (b, _)] if a == b => a.clone(),
            all => {
                let ends = all.iter().map(|(radius, side)| match side {
                    Some(side) => format!("{radius} at {side}"),
                    None => format!("{radius} at the point"),
                });
                ends.collect::<Vec<_>>().join(", ")
            }
        };
        let same = [words, way.word().to_owned()];
        match rows.iter_mut().find(|(_, other)| *other == same) {
            Some((names, _)) => names.push(patch.name.clone()),
            None => rows.push((vec![patch.name.clone()], same)),
        }
    }
    let whole = rows.len() == 1
        && rows
            .iter()
            .all(|(names, _)| names.len() == piece.piece.patches.len());
    let rows = rows.into_iter().map(|(names, [radius, way])| {
        let names = if whole {
            "the whole part".to_owned()
        } else {
            names.join(", ")
        };
        vec![names, radius, way]
    });
    Ok((rows.collect(), ways))
}

/// Returns the radii along a rail of a patch in words.
fn along(patch: &crate::design::Patch, v: f64) -> Result<String, DesignError> {
    let apex = patch.apexes()[usize::from(v > 0.5)];
    if apex {
        return Ok("towards 0".to_owned());
    }
    let (mut low, mut high) = (f64::INFINITY, 0.0_f64);
    for k in 0..=RULINGS {
        let u = f64::from(k) / f64::from(RULINGS);
        let bent = match patch.sheet.principal(u, v) {
            Ok(bent) => bent,
            // At a tip there is no curvature.
            Err(_) if k == 0 || k == RULINGS => continue,
            Err(reason) => {
                return Err(DesignError::Patch {
                    patch: patch.name.clone(),
                    reason,
                });
            }
        };
        let [a, b] = bent.map(|principal| principal.curvature.abs());
        let radius = 1.0 / a.max(b);
        low = low.min(radius);
        high = high.max(radius);
    }
    let shown = number;
    Ok(if high - low <= SAME * low {
        shown(0.5 * (low + high))
    } else if high > 1e6 * low || !high.is_finite() {
        format!("{} to flat", shown(low))
    } else {
        format!("{} to {}", shown(low), shown(high))
    })
}
