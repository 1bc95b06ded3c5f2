//! Can it be made? Every patch and every joint measured, and held against the tolerances of the file.
//!
//! Numbers with bounds come from [`Sheet::enclose`]: they hold for the exact numbers of the control data. The others are
//! estimates of [`Sheet::inspect`].

mod joint;
mod surface;
mod text;

pub(crate) use joint::joint_of;
pub use joint::{JointReport, joints};
pub use surface::SurfaceReport;
pub(crate) use text::columns;
pub use text::table;
pub(crate) use text::{number, wrapped};

use crate::construct;
use crate::design::{Design, Patch};
use crate::error::DesignError;
use serde::Serialize;
use torse_geometry::developable::{Certificate, EnclosedCertificate, Singularity};
use torse_geometry::prelude::{Budget, GeometryError, Sheet};
use torse_geometry::vector::{norm, sub};

/// Rulings that are measured of every patch at least.
const RULINGS: usize = 64;

/// What was measured.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Report {
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
    /// What is demanded and missed, in words; empty when the design is as wanted.
    pub missed: Vec<String>,
    /// The surfaces in the order of the file.
    pub surfaces: Vec<SurfaceReport>,
    /// The files that curves were taken from, with their units, in words.
    pub notes: Vec<String>,
}

/// Whether something is so, and how that is known.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Known {
    /// By the way it is made.
    ByConstruction,
    /// Proved for the exact control data.
    Proved,
    /// Measured; neither proved nor disproved.
    Measured,
    /// It is not so.
    No,
}

impl Known {
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
            Self::Measured => "measured",
            Self::No => "no",
        }
    }
}

/// Bounds of a number; `null` in JSON for an end that is infinite.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct Bounds {
    /// It is at least this.
    pub low: Option<f64>,
    /// It is at most this.
    pub high: Option<f64>,
}

impl Bounds {
    fn of(low: f64, high: f64) -> Self {
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
    pub developable: Known,
    /// Whether its normal vanishes nowhere, but at an apex.
    pub regular: Known,
    /// Why it is not regular.
    pub singularity: Option<String>,
    /// The rails that are a point: 1, 2.
    pub apexes: Vec<usize>,
    /// The largest angle between the tangent planes at the ends of a ruling, in degrees: bounds.
    pub twist: Bounds,
    /// The same, measured, and the parameter of the ruling.
    pub twist_measured: [f64; 2],
    /// The smallest distance of the patch from the edge of regression, or where rulings come closest: bounds, and
    /// `null` where rulings do not meet. Negative inside.
    pub clearance: Option<Bounds>,
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
    /// What else is worth knowing.
    pub notes: Vec<String>,
}

/// Measures a design.
///
/// # Errors
/// [`DesignError::Patch`] for a patch that has no value somewhere.
///
/// ```
/// use torse_designs::inspect::{Known, inspect};
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
/// assert!(report.missed.is_empty() && tube.developable.holds() && tube.regular == Known::Proved);
/// assert!((tube.area.unwrap() - 300.0 * std::f64::consts::PI).abs() < 1e-6);
/// assert!((tube.inside_radius.unwrap() - 19.5).abs() < 1e-9 && tube.clearance.is_none());
/// # Ok::<(), torse_designs::DesignError>(())
/// ```
pub fn inspect(design: &Design) -> Result<Report, DesignError> {
    inspect_within(design, Budget::default())
}

/// As [`inspect`], with another budget for bounds and proofs.
///
/// # Errors
/// As [`inspect`].
pub fn inspect_within(design: &Design, budget: Budget) -> Result<Report, DesignError> {
    let mut missed = Vec::new();
    let mut patches = Vec::new();
    for patch in &design.patches {
        let report = measured(design, patch, budget).map_err(|reason| DesignError::Patch {
            patch: patch.name.clone(),
            reason,
        })?;
        judge(design, &report, &mut missed);
        patches.push(report);
    }
    let joints = joints(design, &mut missed)?;
    let failed = |name: &String| {
        let patch = name.clone();
        move |reason| DesignError::Patch { patch, reason }
    };
    let measured = design.surfaces.iter();
    let surfaces = measured.map(|s| surface::surface(s).map_err(failed(&s.name)));
    let surfaces = surfaces.collect::<Result<Vec<_>, _>>()?;
    Ok(Report {
        surfaces,
        design: design.name.clone(),
        title: design.title.clone(),
        unit: "mm",
        patches,
        joints,
        missed,
        notes: design.notes.clone(),
    })
}

/// The sheet whose regularity is that of a patch without its apex: the half of it that is farther from the apex. On
/// a ruling from an apex the normal grows with the distance, so it vanishes on the half or nowhere.
fn judged(patch: &Patch) -> Result<Sheet, GeometryError> {
    let (Some([first, second]), [from, to]) = (&patch.ends.rails, patch.ends.part) else {
        return Ok(patch.sheet.clone());
    };
    let whole = match patch.apexes {
        [true, false] => {
            let apex = first.point(0.0)?;
            Sheet::ruled(construct::dilated(second, &apex, 0.5)?, second.clone())
        }
        [false, true] => {
            let apex = second.point(0.0)?;
            Sheet::ruled(first.clone(), construct::dilated(first, &apex, 0.5)?)
        }
        _ => return Ok(patch.sheet.clone()),
    };
    if [from, to] == [0.0, 1.0] {
        return Ok(whole);
    }
    whole.part(from, to)
}

fn measured(design: &Design, patch: &Patch, budget: Budget) -> Result<PatchReport, GeometryError> {
    let mut notes = patch.notes.clone();
    let sheet = judged(patch)?;
    let checked = match sheet.inspect(RULINGS) {
        Ok(checked) => checked,
        Err(error) => return singular(patch, sheet.certify(RULINGS)?, &error),
    };
    let apexes: Vec<usize> = (1..=2)
        .zip(patch.apexes)
        .filter_map(|(n, apex)| apex.then_some(n))
        .collect();
    let whole = if apexes.is_empty() {
        checked
    } else {
        patch.sheet.inspect(RULINGS)?
    };
    let proved: Option<EnclosedCertificate> = match sheet.enclose(budget) {
        Ok(proved) => Some(proved),
        Err(error) => {
            notes.push(format!("no bounds: {error}"));
            None
        }
    };
    let certificate = checked.certificate;
    let limit = design.tolerances.twist;
    let twist = proved.map_or(Bounds::of(0.0, 90.0), |p| {
        Bounds::of(p.twist.low.to_degrees(), p.twist.high.to_degrees())
    });
    let measured_twist = checked.twist_in_degrees();
    let by_construction =
        torse_geometry::Rails::<f64>::is_developable_by_construction(&patch.sheet);
    let developable = if by_construction {
        Known::ByConstruction
    } else if twist.high.is_some_and(|high| high <= limit) {
        Known::Proved
    } else if measured_twist <= limit && twist.low.is_none_or(|low| low <= limit) {
        Known::Measured
    } else {
        Known::No
    };
    let regular = match proved.and_then(|p| p.is_regular()) {
        Some(true) => Known::Proved,
        Some(false) => Known::No,
        None if certificate.is_regular() => Known::Measured,
        None => Known::No,
    };
    let singularity = match (regular, certificate.singularity()) {
        (Known::No, Some(found)) => Some(words(&found)),
        (Known::No, None) => Some("the normals at the ends of a ruling oppose: proved".to_owned()),
        _ => None,
    };
    let clearance = match (proved, certificate.clearance) {
        _ if !apexes.is_empty() => Some(Bounds::of(0.0, 0.0)),
        (Some(proved), _) => {
            let bounds = proved.clearance;
            let unbounded = bounds.high == f64::INFINITY && certificate.clearance.is_none();
            (!unbounded).then(|| Bounds::of(bounds.low, bounds.high))
        }
        (None, Some(_)) => Some(Bounds::of(f64::NEG_INFINITY, f64::INFINITY)),
        (None, None) => None,
    };
    let radius = checked.least_radius.map(|worst| {
        // Towards an apex the radius falls to nothing.
        if apexes.is_empty() { worst.value } else { 0.0 }
    });
    let inside_radius = design
        .metal
        .zip(radius)
        .map(|(metal, radius)| metal.sheet.inside_radius(radius) / metal.sheet.thickness());
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

/// The report of a patch that cannot be integrated: it is as good as singular.
fn singular(
    patch: &Patch,
    certificate: Certificate,
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
        developable: Known::Measured,
        regular: Known::No,
        singularity: Some(reason),
        apexes: Vec::new(),
        twist: Bounds::of(0.0, 90.0),
        twist_measured: [certificate.twist.value.to_degrees(), certificate.twist.x],
        clearance: None,
        rulings,
        gaussian: certificate.gaussian.map(|worst| worst.value),
        radius: None,
        inside_radius: None,
        area: None,
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

fn judge(design: &Design, report: &PatchReport, missed: &mut Vec<String>) {
    let (name, limits) = (&report.name, &design.tolerances);
    if !report.developable.holds() {
        missed.push(format!(
            "{name} is not developable: the tangent plane turns by {:.6} degrees along the ruling at u = {:.6}, {} \
             allowed",
            report.twist_measured[0], report.twist_measured[1], limits.twist
        ));
    }
    if let Some(singularity) = &report.singularity {
        missed.push(format!("{name} is not regular: {singularity}"));
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
