//! What a design demands of its patches and edges, and misses.

use super::report::PatchReport;
use crate::design::{Design, Patch};
use crate::inside_radius::{inside_ratio, objection};
use crate::numbers::number;
use crate::unroll::Demand;
use torse_geometry::Rails;
use torse_geometry::prelude::GeometryError;
use torse_geometry::vector::{norm, sub};

/// Returns what is said of a patch between two closed curves that does not close.
pub(super) fn left_open(design: &Design, patch: &Patch) -> Result<Option<String>, GeometryError> {
    if !Rails::<f64>::end_kinds(&patch.sheet).is_closed() {
        return Ok(None);
    }
    let (first, last) = (patch.sheet.ruling(0.0)?, patch.sheet.ruling(1.0)?);
    let apart = first.iter().zip(&last).map(|(p, q)| norm(&sub(p, q)));
    let apart = apart.fold(0.0, f64::max);
    Ok((apart > design.tolerances.gap).then(|| {
        format!(
            "{} does not close, though both of its curves do: its first and its last ruling are {} mm apart",
            patch.name,
            number(apart)
        )
    }))
}

/// Returns what is said of the radii of edges that are smaller than the material allows.
pub(super) fn tight_folds(design: &Design) -> Vec<String> {
    let Some(metal) = design.metal else {
        return Vec::new();
    };
    let mut missed = Vec::new();
    for chain in &design.chains {
        let least = chain
            .radii
            .iter()
            .flatten()
            .fold(f64::INFINITY, |m, r| m.min(*r));
        // It is given as an inside radius.
        let ratio = inside_ratio(&metal, least, 0.0, least);
        let what = format!("{}: the inside radius of its edges", chain.name);
        missed.extend(objection(&metal, 0.0, &what, ratio));
    }
    missed
}

pub(super) fn judge(
    design: &Design,
    report: &PatchReport,
    demand: &Demand,
    missed: &mut Vec<String>,
) {
    let (name, limits) = (&report.name, &design.tolerances);
    if !report.developable.holds() && demand.allow_strain == 0.0 {
        missed.push(format!(
            "{name} is not developable: the tangent plane turns by {:.6} degrees along the ruling at u = {:.6}, {} \
             allowed",
            report.twist_measured[0], report.twist_measured[1], limits.twist
        ));
    }
    if let Some(singularity) = &report.singularity {
        missed.push(format!("{name} is not regular: {singularity}"));
    }
    missed.extend(report.space.objection(name));
    if limits.clearance > 0.0
        && let Some(bounds) = report.clearance
        && bounds.low.is_none_or(|low| low < limits.clearance)
    {
        missed.push(format!(
            "{name}: the edge of regression is not proved to be {} mm away",
            limits.clearance
        ));
    }
    if let (Some(metal), Some(inside)) = (design.metal, report.inside_radius) {
        let share = design.bending.surface.share();
        let what = format!("{name}: the inside radius");
        missed.extend(objection(&metal, share, &what, inside));
    }
}
