//! Flat patterns of designs: every piece that is cut, with what is marked on it.

mod allowance;
mod beside;
mod blank;
mod contour;
mod drawing;
mod lettering;
mod listing;
mod marks;
mod notches;
mod offset;
mod part;
mod summary;

pub use beside::BesideBend;
pub(crate) use beside::beside_bends;
pub use blank::{Blank, Rolled, SharpFold, ToolBend, blank};
pub use drawing::{development_note, drawing};
pub use listing::{PartRow, PartsList, RolledRow, SharpRow, ToolBendRow};
pub use part::{CutOptions, Grain, Part, PartMark, Purpose, parts, parts_with};
pub use summary::{BendRow, PatternSummary, PieceSummary};
pub use torse_geometry::pattern::Flattening;

use crate::design::{Design, DesignPiece, NamedCurve, Patch, Tolerances};
use crate::error::DesignError;
use crate::plane_contour::{PlaneFrame, on_pattern};
use torse_geometry::pattern::{FlatPattern, PatternError, Unrolling, side_by_side};

/// A strain that no patch of a sheet has.
const ANY_STRAIN: f64 = 0.9;

/// What is asked of the patterns of a design.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Demand {
    /// The strain that is allowed to patches that are not developable.
    pub allow_strain: f64,
    /// The rulings that are shown of each patch; those of the file where none are given.
    pub rulings: Option<usize>,
    /// The piece that is wanted; all where none is named.
    pub only: Option<String>,
    /// Which development is made of patches that are not exactly developable.
    pub development: Flattening,
}

/// The pattern of a piece.
#[derive(Debug, Clone)]
pub struct FlatPiece {
    /// The chain or the patch.
    pub piece: DesignPiece,
    /// Its pattern, in its place among the others.
    pub flat: FlatPattern,
}

/// Unrolls the pieces of a design and lays them out side by side.
///
/// # Errors
/// [`DesignError::NoSuch`] for a piece that is not there, [`DesignError::LeftOut`] for a face without one,
/// [`DesignError::OutOfRange`] for a strain or a number of rulings that makes no sense, [`DesignError::Unroll`] for a piece that has no pattern.
///
/// ```
/// use torse_designs::unroll::{Demand, unroll};
/// let design = torse_designs::read("cone.toml", r#"
///     [curves.rim]
///     arc = { centre = [0, 0, 0], from = [30, 0, 0], to = [0, 30, 0] }
///     [patches.cone]
///     cone = "rim"
///     apex = [0, 0, 40]
///     range = [1, 0.5]
/// "#)?;
/// let pieces = unroll(&design, &Demand::default())?;
/// // A sector of an annulus of radii 50 and 25.
/// let exact = std::f64::consts::PI * (30.0 * 50.0 - 15.0 * 25.0) / 4.0;
/// assert!((pieces[0].flat.area() - exact).abs() < 1e-9);
/// # Ok::<(), torse_designs::DesignError>(())
/// ```
pub fn unroll(design: &Design, demand: &Demand) -> Result<Vec<FlatPiece>, DesignError> {
    let strain = demand.allow_strain;
    if !(0.0..1.0).contains(&strain) {
        return Err(DesignError::OutOfRange {
            name: "allowed strain",
            value: strain,
            range: "[0, 1)",
        });
    }
    let rulings = demand.rulings.unwrap_or(design.view.rulings);
    if !(2..=4097).contains(&rulings) {
        #[allow(clippy::cast_precision_loss)]
        return Err(DesignError::OutOfRange {
            name: "rulings",
            value: rulings as f64,
            range: "2, 3, .. 4097",
        });
    }
    let mut pieces = design.pieces();
    if pieces.is_empty() {
        let design = design.name.clone();
        return Err(DesignError::NoPatch { design });
    }
    if let Some(name) = &demand.only {
        let known = pieces.iter().map(|piece| piece.name.clone()).collect();
        pieces.retain(|piece| piece.name == *name);
        if pieces.is_empty() {
            return Err(design.without(name, known));
        }
    }
    let limits = &design.tolerances;
    let mut flats = Vec::with_capacity(pieces.len());
    for piece in &pieces {
        let failed = |reason| DesignError::Unroll {
            piece: piece.name.clone(),
            needed: matches!(reason, PatternError::NotDevelopable { .. })
                .then(|| largest_strain(design, &pieces, demand)),
            reason,
        };
        let asked = Unrolling::within(limits.outline)
            .rulings(rulings)
            .developable_within(limits.strain)
            .allow_strain(strain)
            .flattening(demand.development);
        flats.push(flattened(design, piece, asked).map_err(failed)?);
    }
    if flats.len() > 1 {
        let bounds = flats.iter().map(|flat| flat.outline().bounds());
        let size = bounds.fold(0.0_f64, |size, [low, high]| {
            size.max(high[0] - low[0]).max(high[1] - low[1])
        });
        flats = side_by_side(&flats, 0.05 * size).map_err(|reason| DesignError::Unroll {
            piece: design.name.clone(),
            needed: None,
            reason,
        })?;
    }
    let pieces = pieces.into_iter().zip(flats);
    Ok(pieces
        .map(|(piece, flat)| FlatPiece { piece, flat })
        .collect())
}

/// Returns the largest strain of the patches of these pieces, as far as they can be flattened at all: what has to be
/// allowed.
fn largest_strain(design: &Design, pieces: &[DesignPiece], demand: &Demand) -> f64 {
    let asked = Unrolling::within(design.tolerances.outline)
        .developable_within(design.tolerances.strain)
        .allow_strain(ANY_STRAIN)
        .flattening(demand.development);
    let patches = pieces.iter().flat_map(|piece| &piece.patches);
    patches
        .filter_map(|index| design.patches.get(*index))
        .filter_map(|patch| patch.sheet.unroll_with(&asked).ok())
        .map(|flat| flat.strain())
        .fold(0.0, f64::max)
}

/// Returns the pattern of a plane patch, cut along its border.
fn cut_to_border(
    flat: FlatPattern,
    patch: &Patch,
    border: &NamedCurve,
    limits: &Tolerances,
) -> Result<FlatPattern, PatternError> {
    let refused = |what| {
        let at = torse_geometry::Place::Whole;
        PatternError::Geometry(torse_geometry::GeometryError::NoValue { what, at })
    };
    let frame = PlaneFrame::of_sheet(&patch.sheet).ok_or_else(|| refused("plane of a border"))?;
    let contour = frame
        .contour(&border.curve, limits.outline, limits.gap)
        .and_then(|contour| on_pattern(&flat, &contour))
        .map_err(|_| refused("border in a plane"))?;
    flat.cut_to(contour)
}

/// Returns the pattern of a piece, its patches attached.
fn flattened(
    design: &Design,
    piece: &DesignPiece,
    asked: Unrolling,
) -> Result<FlatPattern, PatternError> {
    let limits = &design.tolerances;
    let patches = piece
        .patches
        .iter()
        .filter_map(|index| design.patches.get(*index));
    // The errors of a chain add up: each patch gets its share.
    let count = f64::from(u32::try_from(piece.patches.len()).unwrap_or(u32::MAX));
    let unrolling = asked.within_tolerance(limits.outline / count);
    let mut chain: Option<FlatPattern> = None;
    for patch in patches {
        let mut next = patch.sheet.unroll_with(&unrolling)?;
        if let Some(border) = &patch.border {
            next = cut_to_border(next, patch, border, limits)?;
        }
        chain = Some(match chain {
            None => next,
            Some(chain) => chain.append(&next, limits.gap)?,
        });
    }
    chain.ok_or(PatternError::Count {
        what: "patches of a piece",
        given: 0,
        needed: 1,
    })
}
