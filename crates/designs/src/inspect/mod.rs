//! Can it be made? Every patch and every joint measured, and held against the tolerances of the file.
//!
//! The patterns, their marks and the blanks are made as well: what is refused there is missed here.
//! Numbers with bounds come from [`Sheet::enclose`]: they hold for the exact numbers of the control data. The others are
//! estimates of [`Sheet::inspect`].

mod ends;
mod joint;
mod making;
mod numbers;
mod seams;
mod surface;
mod text;

pub(crate) use joint::joint_of;
pub use joint::{JointReport, joints};
pub(crate) use numbers::{at_most, number};
pub(crate) use seams::is_passed_backwards;
pub use seams::{SeamReport, seams};
pub use surface::SurfaceReport;
pub(crate) use text::columns;
pub(crate) use text::wrapped;
pub use text::{missed_line, overview, table};

use crate::covers::SurfaceCover;
use crate::design::{Chain, Design, Patch};
use crate::error::DesignError;
use crate::unroll::Demand;
use ends::{EndsJudged, Judged, judged};
use making::unmade;
use serde::Serialize;
use torse_geometry::Rails;
use torse_geometry::developable::{EnclosedCertificate, PatchCertificate, Singularity};
use torse_geometry::prelude::{
    Construction, GeometryError, MeasureBudget, SelfIntersection, Sheet,
};
use torse_geometry::vector::{norm, sub};

/// Rulings that are measured of every patch at least.
const RULINGS: usize = 64;

/// What was measured.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct DesignReport {
    /// The name of the design.
    pub design: String,
    /// Its title.
    pub title: String,
    /// The unit of all lengths.
    pub unit: &'static str,
    /// The patches in the order of the file.
    pub patches: Vec<PatchReport>,
    /// The joints, chain by chain.
    pub joints: Vec<JointReport>,
    /// The seams in the order of the file.
    pub seams: Vec<SeamReport>,
    /// What is demanded and missed, in words; empty when the design is as wanted.
    pub missed: Vec<String>,
    /// The surfaces in the order of the file.
    pub surfaces: Vec<SurfaceReport>,
    /// The surfaces that strips cover, in the order of the file; not in JSON where there is none.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub covers: Vec<SurfaceCover>,
    /// The files that curves were taken from, with their units, in words.
    pub notes: Vec<String>,
}

/// Whether something is so, and how that is known.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Assurance {
    /// By the way it is made.
    ByConstruction,
    /// Proved for the exact control data: of a developable, that it is one exactly.
    Proved,
    /// Proved within the tolerance: how far it may be from it is told beside.
    Within,
    /// Measured; neither proved nor disproved.
    Measured,
    /// It is not so.
    No,
}

impl Assurance {
    /// Whether it is so, as far as known.
    #[must_use]
    pub fn holds(self) -> bool {
        self != Self::No
    }

    /// In a word or two.
    #[must_use]
    pub fn words(self) -> &'static str {
        match self {
            Self::ByConstruction => "by construction",
            Self::Proved => "proved",
            Self::Within => "within",
            Self::Measured => "measured",
            Self::No => "no",
        }
    }
}

/// Bounds of a number; `null` in JSON for an end that is infinite.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct ValueBounds {
    /// It is at least this.
    pub low: Option<f64>,
    /// It is at most this.
    pub high: Option<f64>,
}

impl ValueBounds {
    fn new(low: f64, high: f64) -> Self {
        let finite = |end: f64| end.is_finite().then_some(end);
        let (low, high) = (finite(low), finite(high));
        Self { low, high }
    }
}

/// What was measured of a patch.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct PatchReport {
    /// Its name.
    pub name: String,
    /// How it is made.
    pub kind: &'static str,
    /// Whether its tangent plane stays the same along every ruling, within the tolerance.
    pub developable: Assurance,
    /// Whether its normal vanishes nowhere, but at an apex.
    pub regular: Assurance,
    /// Why it is not regular.
    pub singularity: Option<String>,
    /// The rails that are a point: 1, 2.
    pub apexes: Vec<usize>,
    /// The largest angle between the tangent planes at the ends of a ruling, in degrees: bounds.
    pub twist: ValueBounds,
    /// The same, measured, and the parameter of the ruling.
    pub twist_measured: [f64; 2],
    /// The smallest distance of the patch from the edge of regression, or where rulings come closest: bounds, and
    /// `null` where rulings do not meet. Negative inside.
    pub clearance: Option<ValueBounds>,
    /// The shortest and the longest ruling.
    pub rulings: [f64; 2],
    /// The largest Gaussian curvature in size, for one over square millimetres; `null` when it is unbounded.
    pub gaussian: Option<f64>,
    /// The smallest radius of bending; `null` for a flat patch.
    pub radius: Option<f64>,
    /// The inside radius of the bent sheet as a multiple of its thickness; `null` where no thickness is given or the
    /// patch is flat.
    pub inside_radius: Option<f64>,
    /// The area; `null` where it has none: the patch runs off to infinity.
    pub area: Option<f64>,
    /// Whether it passes through itself in space.
    pub space: Space,
    /// What else is worth knowing.
    pub notes: Vec<String>,
}

/// Whether a patch passes through itself in space.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Space {
    /// It is proved that it does not.
    Free,
    /// These two places `[u, v]` are one point.
    Meets {
        /// The places.
        places: [[f64; 2]; 2],
        /// Whether that is proved.
        proved: bool,
    },
    /// Rulings of these two ranges of `u` may meet.
    Undecided {
        /// The ranges.
        ranges: [[f64; 2]; 2],
    },
    /// It was not asked: the patch is singular, or it is measured only.
    Unknown,
}

impl Space {
    fn inspect(sheet: &Sheet) -> Self {
        match sheet.self_intersection() {
            Ok(SelfIntersection::Free) => Self::Free,
            Ok(SelfIntersection::Found { places, proved, .. }) => Self::Meets { places, proved },
            Ok(SelfIntersection::Undecided { ranges }) => Self::Undecided { ranges },
            Err(_) => Self::Unknown,
        }
    }
}

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

/// As [`inspect`], for patterns that are made so: with a strain that is allowed, a patch that is not developable misses
/// nothing.
///
/// # Errors
/// As [`inspect`].
pub fn inspect_for(design: &Design, demand: &Demand) -> Result<DesignReport, DesignError> {
    inspected_and_made(design, MeasureBudget::default(), demand)
}

/// As [`inspect_for`], for pieces of which patterns and blanks were made so: these are not made again.
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

/// As [`inspect`], without bounds and proofs: everything is measured on some rulings, and says so. Whether a patch passes
/// through itself, and whether its pieces have patterns and blanks, is not asked.
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
        // Of several patches in a row the joints tell.
        let in_row = |chain: &Chain| chain.patches.len() > 1 && chain.patches.contains(&index);
        if !design.chains.iter().any(in_row) {
            missed.extend(left_open(design, patch).map_err(failed)?);
        }
        patches.push(report);
    }
    let joints = joints(design, &mut missed)?;
    missed.extend(tight_folds(design));
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
        joints,
        seams,
        missed,
        notes: design.notes.clone(),
    })
}

/// Whether it is not the construction that makes a sheet developable.
fn is_ruled(sheet: &Sheet) -> bool {
    match sheet.construction() {
        Construction::Ruled(_) => true,
        Construction::Part(part) => is_ruled(part.whole()),
        _ => false,
    }
}

fn measured(
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
        // Of the ends that were left out it is known all the same where it is none by construction.
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
    // Towards an apex the radius falls to nothing, in proportion to the distance: asked for is the edge of the half that
    // was judged.
    let least = checked.least_radius.map(|worst| worst.value);
    let radius = least.map(|radius| if apexes.is_empty() { radius } else { 0.0 });
    let inside = |radius: f64| {
        let metal = design.metal?;
        Some(radius / metal.sheet.thickness() - design.bending.surface.share())
    };
    let inside_radius = match (apexes.is_empty(), least, design.metal) {
        (true, Some(radius), _) => inside(radius),
        (false, Some(_), Some(metal)) => {
            let reach = beyond_apex(own, metal, design.bending.surface.share())?;
            notes.push(format!(
                "the inside radius is below {} times the thickness within {} mm of the apex",
                number(metal.least_radius),
                number(reach.distance)
            ));
            reach.inside_radius
        }
        _ => None,
    };
    // Through an edge of regression a patch is no sheet anyway.
    let space = match budget {
        Some(_) if regular.holds() => Space::inspect(own),
        _ => Space::Unknown,
    };
    if let Space::Undecided { ranges: [a, b] } = &space {
        notes.push(format!(
            "it is not decided whether rulings from u = {:.6} to {:.6} meet those from {:.6} to {:.6} in space",
            a[0], a[1], b[0], b[1]
        ));
    }
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
        area: Some(whole.area),
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
    let inside = least / thickness - share;
    Ok(ApexReach {
        distance,
        inside_radius: inside.is_finite().then_some(inside),
    })
}

/// The report of a patch that cannot be integrated: it is as good as singular.
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
        space: Space::Unknown,
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

/// What is said of a patch between two closed curves that does not close.
fn left_open(design: &Design, patch: &Patch) -> Result<Option<String>, GeometryError> {
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

/// What is said of the radii of edges that are smaller than the material allows.
fn tight_folds(design: &Design) -> Vec<String> {
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
        let ratio = least / metal.sheet.thickness();
        if ratio < metal.least_radius {
            missed.push(format!(
                "{}: the inside radius of its edges is {ratio:.4} times the thickness, {} at least",
                chain.name, metal.least_radius
            ));
        }
    }
    missed
}

fn judge(design: &Design, report: &PatchReport, demand: &Demand, missed: &mut Vec<String>) {
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
    if let Space::Meets {
        places: [a, b],
        proved,
    } = &report.space
    {
        missed.push(format!(
            "{name} passes through itself in space: u = {:.7}, v = {:.7} and u = {:.7}, v = {:.7} are one point{}",
            a[0],
            a[1],
            b[0],
            b[1],
            if *proved { ", proved" } else { "" }
        ));
    }
    if limits.clearance > 0.0
        && let Some(bounds) = report.clearance
        && bounds.low.is_none_or(|low| low < limits.clearance)
    {
        missed.push(format!(
            "{name}: the edge of regression is not proved to be {} mm away",
            limits.clearance
        ));
    }
    if let (Some(metal), Some(inside)) = (design.metal, report.inside_radius)
        && inside < metal.least_radius
    {
        missed.push(format!(
            "{name}: the inside radius is {inside:.4} times the thickness, {} at least",
            metal.least_radius
        ));
    }
}
