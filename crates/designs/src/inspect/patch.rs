//! What is measured of one patch.

use super::contact::SelfContact;
use super::ends::{EndsJudged, Judged, judged};
use super::report::{Assurance, PatchReport, ValueBounds};
use crate::design::{Design, NamedCurve, Patch};
use crate::inside_radius::inside_ratio;
use crate::numbers::number;
use crate::plane_contour::PlaneFrame;
use torse_geometry::Rails;
use torse_geometry::developable::{EnclosedCertificate, PatchCertificate, Singularity};
use torse_geometry::pattern::Segment;
use torse_geometry::prelude::{Construction, GeometryError, MeasureBudget, Sheet};
use torse_geometry::vector::{norm, sub};

/// Rulings that are measured of every patch at least.
const RULINGS: usize = 64;

/// Returns whether it is not the construction that makes a sheet developable.
fn is_ruled(sheet: &Sheet) -> bool {
    match sheet.construction() {
        Construction::Ruled(_) => true,
        Construction::Part(part) => is_ruled(part.whole()),
        _ => false,
    }
}

pub(super) fn measured(
    design: &Design,
    patch: &Patch,
    budget: Option<MeasureBudget>,
) -> Result<PatchReport, GeometryError> {
    let mut notes = patch.notes.clone();
    // Nothing depends on where in space it lies.
    let near = patch.sheet.near_origin().map(|(near, _)| near);
    let own = near.as_ref().unwrap_or(&patch.sheet);
    let Judged {
        sheet,
        notes: special,
        ends,
    } = judged(own, budget.is_some())?;
    notes.extend(special);
    let checked = match sheet.inspect(RULINGS) {
        Ok(checked) => checked,
        Err(error) => return singular(patch, sheet.certify(RULINGS)?, &error),
    };
    let apexes: Vec<usize> = (1..=2)
        .zip(patch.apexes())
        .filter_map(|(n, apex)| apex.then_some(n))
        .collect();
    let whole = if apexes.is_empty() && matches!(ends, EndsJudged::All) {
        checked
    } else {
        own.inspect(RULINGS)?
    };
    let proved: Option<EnclosedCertificate> = match budget.map(|budget| sheet.enclose(budget)) {
        None => None,
        Some(Ok(proved)) => Some(proved),
        Some(Err(error)) => {
            notes.push(format!("no bounds: {error}"));
            None
        }
    };
    let certificate = checked.certificate;
    let limit = design.tolerances.twist;
    let exact = Rails::<f64>::is_developable_by_construction(&patch.sheet);
    let twist = match (proved, &ends) {
        (Some(p), EndsJudged::All) => {
            ValueBounds::new(p.twist.low.to_degrees(), p.twist.high.to_degrees())
        }
        (Some(p), EndsJudged::Proved(at_ends)) => {
            let high = p.twist.high.max(*at_ends);
            ValueBounds::new(p.twist.low.to_degrees(), high.to_degrees())
        }
        // A sheet that is developable by construction has no twist at the omitted ends either.
        (Some(p), EndsJudged::Open) if exact => {
            ValueBounds::new(p.twist.low.to_degrees(), p.twist.high.to_degrees())
        }
        (Some(p), EndsJudged::Open) => ValueBounds::new(p.twist.low.to_degrees(), 90.0),
        (None, _) => ValueBounds::new(0.0, 90.0),
    };
    let measured_twist = checked.twist_in_degrees();
    let developable = if exact && !is_ruled(&patch.sheet) {
        Assurance::ByConstruction
    } else if exact {
        Assurance::Proved
    } else if twist.high.is_some_and(|high| high <= limit) {
        Assurance::Within
    } else if measured_twist <= limit && twist.low.is_none_or(|low| low <= limit) {
        Assurance::Measured
    } else {
        Assurance::No
    };
    let regular = match proved.and_then(|p| p.is_regular()) {
        // What was left out at an end was not looked at.
        Some(true) if matches!(ends, EndsJudged::Open) => Assurance::Measured,
        Some(true) => Assurance::Proved,
        Some(false) => Assurance::No,
        None if certificate.is_regular() => Assurance::Measured,
        None => Assurance::No,
    };
    let singularity = match (regular, certificate.singularity()) {
        (Assurance::No, Some(found)) => Some(words(&found)),
        (Assurance::No, None) => {
            Some("the normals at the ends of a ruling oppose: proved".to_owned())
        }
        _ => None,
    };
    let clearance = match (proved, certificate.clearance) {
        _ if !apexes.is_empty() => Some(ValueBounds::new(0.0, 0.0)),
        (Some(proved), _) => {
            let bounds = proved.clearance;
            let unbounded = bounds.high == f64::INFINITY && certificate.clearance.is_none();
            // Of an end that was left out it is known at most that the edge does not run through it.
            let low = match ends {
                EndsJudged::All => bounds.low,
                EndsJudged::Proved(_) => bounds.low.min(0.0),
                EndsJudged::Open => f64::NEG_INFINITY,
            };
            (!unbounded).then(|| ValueBounds::new(low, bounds.high))
        }
        (None, Some(_)) => Some(ValueBounds::new(f64::NEG_INFINITY, f64::INFINITY)),
        (None, None) => None,
    };
    // Towards an apex the radius falls to nothing, in proportion to the distance: asked for is the edge of the half
    // that was judged.
    let least = checked.least_radius.map(|worst| worst.value);
    let radius = least.map(|radius| if apexes.is_empty() { radius } else { 0.0 });
    let share = design.bending.surface.share();
    let inside_radius = match (apexes.is_empty(), least, design.metal) {
        (true, Some(radius), Some(metal)) => {
            let size = largest_coordinate(&patch.sheet)?;
            Some(inside_ratio(&metal, radius, share, size))
        }
        (false, Some(_), Some(metal)) => {
            let reach = beyond_apex(own, metal, share)?;
            notes.push(format!(
                "the inside radius is below {} times the thickness within {} mm of the apex",
                number(metal.least_radius),
                number(reach.distance)
            ));
            reach.inside_radius
        }
        _ => None,
    };
    // A singular patch is no sheet, so self-intersection is not tested.
    let space = match budget {
        Some(_) if regular.holds() => SelfContact::inspect(own),
        _ => SelfContact::Unknown,
    };
    let area = match &patch.border {
        Some(border) => area_within(patch, border, design).unwrap_or(whole.area),
        None => whole.area,
    };
    let report = PatchReport {
        name: patch.name.clone(),
        kind: patch.kind,
        developable,
        regular,
        singularity,
        twist,
        twist_measured: [measured_twist, certificate.twist.x],
        clearance,
        rulings: [whole.shortest_ruling.value, whole.longest_ruling.value],
        gaussian: if apexes.is_empty() {
            certificate.gaussian.map(|worst| worst.value)
        } else {
            None
        },
        radius,
        inside_radius,
        area: Some(area),
        apexes,
        space,
        notes,
    };
    let numbers = [
        report.gaussian,
        report.radius,
        report.inside_radius,
        report.area,
    ];
    let numbers = numbers.into_iter().flatten().chain(report.rulings);
    if numbers.chain(report.twist_measured).all(f64::is_finite) {
        return Ok(report);
    }
    Err(GeometryError::NoValue {
        what: "a measure of the patch",
        at: torse_geometry::Place::Whole,
    })
}

/// Returns the area of a plane patch within its border; `None` where that is no curve in the plane, as `unroll` says.
fn area_within(patch: &Patch, border: &NamedCurve, design: &Design) -> Option<f64> {
    let limits = &design.tolerances;
    let frame = PlaneFrame::of_sheet(&patch.sheet)?;
    let contour = frame
        .contour(&border.curve, limits.outline, limits.gap)
        .ok()?;
    Some(contour.segments.iter().map(Segment::area).sum())
}

/// How near an apex a sheet of metal is bent too tightly.
struct ApexReach {
    /// The largest distance from the apex at which it is: no more than the length of the ruling.
    distance: f64,
    /// The least inside radius at the far end, as a multiple of the thickness; `None` where it is flat.
    inside_radius: Option<f64>,
}

/// On a ruling through an apex the radius is in proportion to the distance from it: measured on some rulings.
/// The designed surface is at a share of the thickness from the inside.
fn beyond_apex(
    sheet: &Sheet,
    metal: crate::design::Material,
    share: f64,
) -> Result<ApexReach, GeometryError> {
    let apex_first = Rails::<f64>::end_kinds(sheet).apexes()[0];
    let far = if apex_first { 1.0 } else { 0.0 };
    let thickness = metal.sheet.thickness();
    let needed = thickness * (metal.least_radius + share);
    let (mut distance, mut least) = (0.0_f64, f64::INFINITY);
    for k in 0..=4 * RULINGS {
        #[allow(clippy::cast_precision_loss)]
        let u = k as f64 / (4 * RULINGS) as f64;
        let [p, q] = sheet.ruling(u)?;
        let length = norm(&sub(&q, &p));
        let bent = sheet.principal(u, far)?.map(|p| p.curvature.abs());
        let curvature = bent[0].max(bent[1]);
        distance = distance.max((length * needed * curvature).min(length));
        least = least.min(1.0 / curvature);
    }
    let inside = least
        .is_finite()
        .then(|| inside_ratio(&metal, least, share, least));
    Ok(ApexReach {
        distance,
        inside_radius: inside,
    })
}

/// Returns the largest coordinate of its first, middle and last ruling.
fn largest_coordinate(sheet: &Sheet) -> Result<f64, GeometryError> {
    let mut largest = 0.0_f64;
    for u in [0.0, 0.5, 1.0] {
        let ends = sheet.ruling(u)?;
        largest = ends.iter().flatten().fold(largest, |m, c| m.max(c.abs()));
    }
    Ok(largest)
}

/// Returns the report of a patch that cannot be integrated: it is as good as singular.
fn singular(
    patch: &Patch,
    certificate: PatchCertificate,
    error: &GeometryError,
) -> Result<PatchReport, GeometryError> {
    let mut rulings = [f64::INFINITY, 0.0_f64];
    for k in 0..=64_u32 {
        let [p, q] = patch.sheet.ruling(f64::from(k) / 64.0)?;
        let length = norm(&sub(&q, &p));
        rulings = [rulings[0].min(length), rulings[1].max(length)];
    }
    if !rulings.iter().all(|length| length.is_finite()) {
        return Err(error.clone());
    }
    let reason = certificate.singularity();
    let reason = reason.map_or_else(|| format!("it cannot be measured: {error}"), |s| words(&s));
    Ok(PatchReport {
        name: patch.name.clone(),
        kind: patch.kind,
        developable: Assurance::Measured,
        regular: Assurance::No,
        singularity: Some(reason),
        apexes: Vec::new(),
        twist: ValueBounds::new(0.0, 90.0),
        twist_measured: [certificate.twist.value.to_degrees(), certificate.twist.x],
        clearance: None,
        rulings,
        gaussian: certificate.gaussian.map(|worst| worst.value),
        radius: None,
        inside_radius: None,
        area: None,
        space: SelfContact::Unknown,
        notes: patch.notes.clone(),
    })
}

fn words(singularity: &Singularity) -> String {
    match singularity {
        Singularity::NormalVanishes(at) => {
            format!("the normal vanishes at u = {:.6}, v = {:.6}", at.x, at.v)
        }
        Singularity::NormalTurns(at) => format!(
            "the ruling at u = {:.6} crosses the edge of regression at v = {:.6}",
            at.x, at.v
        ),
        Singularity::Unresolved { from, to } => {
            format!("the patch jumps or turns back between u = {from:.6} and u = {to:.6}")
        }
    }
}
