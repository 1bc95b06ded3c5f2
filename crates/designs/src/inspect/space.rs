//! Whether a patch passes through itself in space, the patches of a piece through each other, and pieces through pieces.

use super::contact::{PieceReport, PieceSpace, Piercing, SelfContact, one_point};
use super::{DesignReport, PatchReport};
use crate::design::{Design, Patch};
use crate::space_openings::openings_in_space;
use std::cell::OnceCell;
use torse_geometry::prelude::{PieceIntersection, Sheet, SheetPiercing};

/// The patches of a list of indices that are regular, and whether these are all.
fn regular<'d>(
    design: &'d Design,
    reports: &[PatchReport],
    indices: &[usize],
) -> (Vec<&'d Patch>, bool) {
    let is_regular = |index: &&usize| {
        let report = reports.get(**index);
        report.is_some_and(|report| report.regular.holds())
    };
    let kept = indices.iter().filter(is_regular);
    let kept: Vec<&Patch> = kept
        .filter_map(|index| design.patches.get(*index))
        .collect();
    let all = kept.len() == indices.len();
    (kept, all)
}

/// What is known of the pieces of several patches.
pub(super) fn pieces(design: &Design, reports: &[PatchReport]) -> Vec<PieceReport> {
    let several = design
        .pieces()
        .into_iter()
        .filter(|piece| piece.patches.len() > 1);
    several
        .map(|piece| {
            let (patches, all) = regular(design, reports, &piece.patches);
            let sheets: Vec<&Sheet> = patches.iter().map(|patch| &patch.sheet).collect();
            let names = |pair: [usize; 2]| {
                pair.map(|k| {
                    patches
                        .get(k)
                        .map(|patch| patch.name.clone())
                        .unwrap_or_default()
                })
            };
            let space = match Sheet::piece_intersection(&sheets, design.tolerances.gap) {
                Ok(PieceIntersection::Found {
                    patches,
                    places,
                    proved,
                    ..
                }) => PieceSpace::Meets {
                    patches: names(patches),
                    places,
                    proved,
                },
                // Nothing is known of what is left out.
                Err(_) | Ok(_) if !all => PieceSpace::Unknown,
                Ok(PieceIntersection::Free) => PieceSpace::Free,
                Ok(PieceIntersection::Undecided { patches, ranges }) => PieceSpace::Undecided {
                    patches: names(patches),
                    ranges,
                },
                Err(_) => PieceSpace::Unknown,
            };
            PieceReport {
                patches: piece
                    .patches
                    .iter()
                    .filter_map(|index| design.patches.get(*index))
                    .map(|patch| patch.name.clone())
                    .collect(),
                name: piece.name,
                space,
            }
        })
        .collect()
}

/// Two pieces each that are proved to pass through each other, in what is left of them beside their openings. Patches with a
/// border of their own are not asked: their rulings reach beyond it.
pub(super) fn piercings(design: &Design, reports: &[PatchReport]) -> Vec<Piercing> {
    let pieces = design.pieces();
    let patches: Vec<Vec<&Patch>> = pieces
        .iter()
        .map(|piece| {
            let (mut patches, _) = regular(design, reports, &piece.patches);
            patches.retain(|patch| patch.border.is_none());
            patches
        })
        .collect();
    let sheets: Vec<Vec<&Sheet>> = patches
        .iter()
        .map(|patches| patches.iter().map(|patch| &patch.sheet).collect())
        .collect();
    // Only where pieces meet are their openings of interest.
    let openings = OnceCell::new();
    let is_left = |found: &SheetPiercing| {
        let openings = openings.get_or_init(|| openings_in_space(design).ok());
        (0..2).all(|k| {
            let patch = patches[found.pieces[k]][found.sheets[k]];
            match openings {
                Some(all) => !all.iter().any(|opening| {
                    let own = design.patches.get(opening.patch);
                    own.is_some_and(|own| std::ptr::eq(own, patch))
                        && opening.reaches(&patch.sheet, found.places[k])
                }),
                // Where they lie is not known.
                None => patch.marks.iter().all(|mark| !mark.is_opening()),
            }
        })
    };
    let found = Sheet::piercings(&sheets, is_left).unwrap_or_default();
    let named = |found: SheetPiercing| Piercing {
        pieces: found.pieces.map(|piece| pieces[piece].name.clone()),
        patches: [0, 1].map(|k| patches[found.pieces[k]][found.sheets[k]].name.clone()),
        places: found.places,
    };
    found.into_iter().map(named).collect()
}

impl DesignReport {
    /// What is open about patches and pieces in space, and which pieces pass through each other, in words.
    #[must_use]
    pub fn notes_on_space(&self) -> Vec<String> {
        let ranges = |[a, b]: [[f64; 2]; 2]| {
            let words = |[from, to]: [f64; 2]| format!("{from:.6} to {to:.6}");
            [words(a), words(b)]
        };
        let patches = self.patches.iter().filter_map(|patch| {
            let SelfContact::Undecided { ranges: open } = patch.space else {
                return None;
            };
            let [a, b] = ranges(open);
            Some(format!(
                "{}: it is not decided whether rulings from u = {a} meet those from {b} in space",
                patch.name
            ))
        });
        let pieces = self.pieces.iter().filter_map(|piece| {
            let PieceSpace::Undecided {
                patches: [one, other],
                ranges: open,
            } = &piece.space
            else {
                return None;
            };
            let [a, b] = ranges(*open);
            Some(format!(
                "{}: it is not decided whether rulings of {one} from u = {a} meet those of {other} from {b} in space",
                piece.name
            ))
        });
        let piercings = self.piercings.iter().map(|piercing| {
            let ([a, b], [p, q]) = (&piercing.pieces, &piercing.patches);
            format!(
                "{a} and {b} pass through each other in space: {}",
                one_point([p, q], piercing.places, true)
            )
        });
        patches.chain(pieces).chain(piercings).collect()
    }
}
