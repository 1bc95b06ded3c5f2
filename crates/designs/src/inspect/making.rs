//! Whether what is cut of a design can be made: patterns, marks, blanks.

use super::PatchReport;
use crate::design::Design;
use crate::error::{DesignError, Ending};
use crate::unroll::{Demand, parts, unroll};
use torse_geometry::pattern::PatternError;

/// Returns whether two patches do not meet: that is said of their joint.
fn is_joint(error: &DesignError) -> bool {
    let DesignError::Unroll { reason, .. } = error else {
        return false;
    };
    matches!(reason, PatternError::NoCommonRuling { .. })
}

/// Returns what is said of pieces that cannot be cut: what `unroll` refuses them with. Of a piece with a patch that is
/// found not to be developable, or to be singular, that is said already.
pub(super) fn unmade(design: &Design, patches: &[PatchReport], demand: &Demand) -> Vec<String> {
    let sound = |index: &usize| {
        let report = patches.get(*index);
        report.is_some_and(|report| {
            (report.developable.holds() || demand.allow_strain > 0.0)
                && report.singularity.is_none()
        })
    };
    let wanted = |name: &str| demand.only.as_deref().is_none_or(|only| only == name);
    let mut missed = Vec::new();
    for piece in design.pieces() {
        if !wanted(&piece.name) || !piece.patches.iter().all(sound) {
            continue;
        }
        let alone = Demand {
            only: Some(piece.name.clone()),
            ..demand.clone()
        };
        let made = unroll(design, &alone).and_then(|pieces| parts(design, &pieces));
        missed.extend(
            made.err()
                .filter(|error| error.ending() == Ending::Missed && !is_joint(error))
                .map(|error| error.to_string()),
        );
    }
    missed
}
