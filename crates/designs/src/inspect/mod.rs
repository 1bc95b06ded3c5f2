//! Can it be made? Every patch and every joint measured, and held against the tolerances of the file.
//!
//! The patterns, their marks and the blanks are made as well: what is refused there is missed here. Numbers with bounds
//! come from [`Sheet::enclose`](torse_geometry::prelude::Sheet::enclose): they hold for the exact numbers of the
//! control data. The others are estimates of [`Sheet::inspect`](torse_geometry::prelude::Sheet::inspect).

mod contact;
mod demands;
mod ends;
mod joint;
mod making;
mod patch;
mod report;
mod seams;
mod space;
mod surface;
mod text;

pub use contact::{PieceReport, PieceSpace, Piercing, SelfContact};
pub(crate) use joint::side_changes_at_joint;
pub use joint::{JointReport, joints};
pub use report::{Assurance, DesignReport, PatchReport, ValueBounds};
pub(crate) use seams::{SeamPassage, passage};
pub use seams::{SeamReport, seams};
pub use surface::SurfaceReport;
pub use text::{missed_line, overview, table};

use crate::design::{Chain, Design};
use crate::error::DesignError;
use crate::unroll::Demand;
use demands::{judge, left_open, tight_folds};
use making::unmade;
use patch::measured;
use space::{pieces, piercings};
use torse_geometry::prelude::MeasureBudget;

/// Measures a design.
///
/// # Errors
/// [`DesignError::Patch`] for a patch that has no value somewhere.
///
/// ```
/// use torse_designs::inspect::{Assurance, inspect};
/// let design = torse_designs::read("tube.toml", r#"
///     [sheet]
///     thickness = 1
///     [curves.rim]
///     arc = { centre = [0, 0, 0], from = [20, 0, 0], to = [0, 20, 0] }
///     [patches.tube]
///     cylinder = "rim"
///     direction = [0, 0, 30]
/// "#)?;
/// let report = inspect(&design)?;
/// let tube = &report.patches[0];
/// assert!(report.missed.is_empty() && tube.developable.holds() && tube.regular == Assurance::Proved);
/// assert!((tube.area.unwrap() - 300.0 * std::f64::consts::PI).abs() < 1e-6);
/// assert!((tube.inside_radius.unwrap() - 19.5).abs() < 1e-9 && tube.clearance.is_none());
/// # Ok::<(), torse_designs::DesignError>(())
/// ```
pub fn inspect(design: &Design) -> Result<DesignReport, DesignError> {
    inspect_within(design, MeasureBudget::default())
}

/// As [`inspect`], with another budget for bounds and proofs.
///
/// # Errors
/// As [`inspect`].
pub fn inspect_within(design: &Design, budget: MeasureBudget) -> Result<DesignReport, DesignError> {
    inspected_and_made(design, budget, &Demand::default())
}

/// Inspects a design for patterns with these demands: a patch that is not developable passes if its strain is allowed.
///
/// # Errors
/// As [`inspect`].
pub fn inspect_for(design: &Design, demand: &Demand) -> Result<DesignReport, DesignError> {
    inspected_and_made(design, MeasureBudget::default(), demand)
}

/// Inspects like [`inspect_for`], for pieces whose patterns and blanks exist already: does not make them again.
///
/// # Errors
/// As [`inspect`].
pub fn inspect_unrolled(design: &Design, demand: &Demand) -> Result<DesignReport, DesignError> {
    inspected(design, Some(MeasureBudget::default()), demand)
}

fn inspected_and_made(
    design: &Design,
    budget: MeasureBudget,
    demand: &Demand,
) -> Result<DesignReport, DesignError> {
    let mut report = inspected(design, Some(budget), demand)?;
    let unmade = unmade(design, &report.patches, demand);
    report.missed.extend(unmade);
    Ok(report)
}

/// As [`inspect`], without bounds and proofs: everything is measured on some rulings, and says so. Whether a patch
/// passes through itself, and whether its pieces have patterns and blanks, is not asked.
///
/// # Errors
/// As [`inspect`].
///
/// ```
/// use torse_designs::inspect::{Assurance, inspect_quickly};
/// let design = torse_designs::read("tube.toml", r#"
///     [curves.rim]
///     arc = { centre = [0, 0, 0], from = [20, 0, 0], to = [0, 20, 0] }
///     [patches.tube]
///     cylinder = "rim"
///     direction = [0, 0, 30]
/// "#)?;
/// let report = inspect_quickly(&design)?;
/// assert_eq!(report.patches[0].regular, Assurance::Measured);
/// # Ok::<(), torse_designs::DesignError>(())
/// ```
pub fn inspect_quickly(design: &Design) -> Result<DesignReport, DesignError> {
    inspected(design, None, &Demand::default())
}

fn inspected(
    design: &Design,
    budget: Option<MeasureBudget>,
    demand: &Demand,
) -> Result<DesignReport, DesignError> {
    let mut missed = Vec::new();
    let mut patches = Vec::new();
    for (index, patch) in design.patches.iter().enumerate() {
        let report = measured(design, patch, budget).map_err(|reason| DesignError::Patch {
            patch: patch.name.clone(),
            reason,
        })?;
        judge(design, &report, demand, &mut missed);
        let failed = |reason| DesignError::Patch {
            patch: patch.name.clone(),
            reason,
        };
        // In a chain of several patches, the joints report it.
        let in_row = |chain: &Chain| chain.patches.len() > 1 && chain.patches.contains(&index);
        if !design.chains.iter().any(in_row) {
            missed.extend(left_open(design, patch).map_err(failed)?);
        }
        patches.push(report);
    }
    let joints = joints(design, &mut missed)?;
    missed.extend(tight_folds(design));
    let pieces = match budget {
        Some(_) => pieces(design, &patches),
        None => Vec::new(),
    };
    missed.extend(pieces.iter().filter_map(PieceReport::objection));
    let piercings = match budget {
        Some(_) => piercings(design, &patches),
        None => Vec::new(),
    };
    let seams = seams(design, &mut missed).map_err(|reason| DesignError::Patch {
        patch: design.name.clone(),
        reason,
    })?;
    let failed = |name: &String| {
        let patch = name.clone();
        move |reason| DesignError::Patch { patch, reason }
    };
    let measured = design.surfaces.iter();
    let surfaces = measured.map(|s| surface::surface(s).map_err(failed(&s.name)));
    let surfaces = surfaces.collect::<Result<Vec<_>, _>>()?;
    Ok(DesignReport {
        surfaces,
        covers: design.covers.clone(),
        design: design.name.clone(),
        title: design.title.clone(),
        unit: "mm",
        patches,
        pieces,
        piercings,
        joints,
        seams,
        missed,
        notes: design.notes.clone(),
    })
}
