//! Joints: how the end of a patch meets the next one.
//!
//! Two things are told apart. The *seam* is what lies there: how far apart the ends of the rulings are, by which angle
//! the sheet is folded. The *contact* is that of what the patches are made from: of families of planes the order to
//! which they agree up to a change of parameter (with its beta values) and a factor, of rails the same. Families that
//! agree to any order touch along the common ruling, but say nothing about the side on which each sheet grows away from
//! it: a sheet that folds back on the other has a fold of 180 degrees, and no contact above position.

use crate::design::{Chain, Design, Patch, Smoothness};
use crate::error::DesignError;
use serde::Serialize;
use torse_geometry::Rails;
use torse_geometry::join::JointMeasure;
use torse_geometry::prelude::{GeometryError, Point, Sheet};
use torse_geometry::vector::{cross, dot, norm, sub};

/// The order up to which contact is measured.
const ORDER: usize = 3;
/// Curvatures across a ruling that differ by less than this share are one.
const CURVATURE: f64 = 1e-6;

/// A sheet that is folded by this angle or more, in degrees, lies on itself.
const BACK: f64 = 179.999;

/// What was measured of a joint.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[non_exhaustive]
pub struct JointReport {
    /// The chain.
    pub chain: String,
    /// The patches.
    pub patches: [String; 2],
    /// The larger distance of corresponding ends of the two rulings.
    pub gap: f64,
    /// The largest angle by which the sheet is folded, in degrees: 0 where it goes on smoothly, 180 where it folds back
    /// on itself.
    pub kink: f64,
    /// The largest difference of the curvatures across the ruling, as a share of the larger one.
    pub curvature: Option<f64>,
    /// The geometric order: 0 where the rulings meet, 1 with the tangent planes, 2 and more with the curvature; `null`
    /// where not even the rulings meet.
    pub geometric: Option<usize>,
    /// The order to which derivatives agree; `null` where the patches are not given in a way that says so.
    pub parametric: Option<usize>,
    /// The beta values of the families of planes, or of the first and the second rails.
    pub betas: Vec<Vec<f64>>,
    /// The factor between the families of planes with its derivatives, where it is not one.
    pub scale: Vec<f64>,
}

/// Measures all joints of all chains.
///
/// # Errors
/// [`DesignError::Patch`] for a patch without a ruling at its end.
pub fn joints(design: &Design, missed: &mut Vec<String>) -> Result<Vec<JointReport>, DesignError> {
    let mut reports = Vec::new();
    for chain in &design.chains {
        for [first, second] in pairs(design, chain) {
            let seam = nearest_ends(first, second).map_err(|reason| DesignError::Patch {
                patch: second.name.clone(),
                reason,
            })?;
            let report = report(design, chain, [first, second], &seam);
            if let Some(reason) = objection(design, chain, &report) {
                missed.push(reason);
            }
            reports.push(report);
        }
    }
    Ok(reports)
}

/// Neighbours of a chain, of a closed one the last and the first too.
fn pairs<'d>(design: &'d Design, chain: &Chain) -> Vec<[&'d Patch; 2]> {
    let at = |index: &usize| design.patches.get(*index);
    let patches: Vec<&Patch> = chain.patches.iter().filter_map(at).collect();
    let mut pairs: Vec<[&Patch; 2]> = patches
        .windows(2)
        .filter_map(|w| w.try_into().ok())
        .collect();
    if let (true, Some(first), Some(last)) = (chain.closed, patches.first(), patches.last()) {
        pairs.push([last, first]);
    }
    pairs
}

/// The end of a patch: which, and what is there.
#[derive(Debug, Clone, Copy)]
struct PatchEnd {
    /// Whether it is the last ruling.
    last: bool,
    /// Its ends.
    points: [Point; 2],
    /// At both, the cross product of the speed of the rail with the ruling, of length one where there is any.
    normals: [Option<Point>; 2],
}

/// Where two patches meet.
#[derive(Debug, Clone, Copy)]
struct FacingEnds {
    /// The end of the first and of the second.
    ends: [PatchEnd; 2],
    /// Whether the first rail of the one meets the second of the other.
    crossed: bool,
    /// The larger distance of ends of rulings.
    gap: f64,
}

impl PatchEnd {
    fn new(sheet: &Sheet, last: bool) -> Result<Self, GeometryError> {
        let x = if last { 1.0 } else { 0.0 };
        let rails = sheet.ends_and_slopes(&x)?;
        let points = rails.map(|[point, _]| point);
        let ruling = sub(&points[1], &points[0]);
        let speeds = rails.map(|[_, slope]| norm(&slope));
        // The slope of an edge that stands still is rounding error.
        let normal = |[_, slope]: [Point; 2]| {
            let moves = norm(&slope) > super::ends::STILL * speeds[0].max(speeds[1]);
            moves.then(|| torse_geometry::vector::unit(&cross(&slope, &ruling)))?
        };
        Ok(Self {
            last,
            points,
            normals: rails.map(normal),
        })
    }

    /// Returns, at both ends of the ruling `r`, the normal `d x r`, where `d` points into the patch (if `into`) or out
    /// of it. An apex takes the normal of the other end.
    fn growth(&self, into: bool) -> [Option<Point>; 2] {
        let forward = into != self.last;
        let [p, q] = self
            .normals
            .map(|n| n.map(|n| if forward { n } else { n.map(|c| -c) }));
        [p.or(q), q.or(p)]
    }
}

/// Returns the nearest ends of two patches: the end of the first and the start of the second before all others.
fn nearest_ends(first: &Patch, second: &Patch) -> Result<FacingEnds, GeometryError> {
    let ends = |patch: &Patch| -> Result<[PatchEnd; 2], GeometryError> {
        Ok([
            PatchEnd::new(&patch.sheet, true)?,
            PatchEnd::new(&patch.sheet, false)?,
        ])
    };
    let [one, other] = ends(first)?;
    let [far, near] = ends(second)?;
    let mut best: Option<FacingEnds> = None;
    for (a, b) in [(one, near), (other, near), (one, far), (other, far)] {
        for crossed in [false, true] {
            let [p, q] = b.points;
            let facing_points = if crossed { [q, p] } else { [p, q] };
            let away = |i: usize| norm(&sub(&a.points[i], &facing_points[i]));
            let gap = away(0).max(away(1));
            // What is as near up to rounding is no better.
            if best.is_none_or(|best| gap < 0.999 * best.gap - 1e-12) {
                let ends = [a, b];
                best = Some(FacingEnds { ends, crossed, gap });
            }
        }
    }
    best.ok_or(GeometryError::NoValue {
        what: "joint",
        at: torse_geometry::Place::Whole,
    })
}

/// Returns whether the side from which a patch is seen changes at the joint with the next: when the same ends meet, or
/// the first rail of the one meets the second of the other, but not both.
pub(crate) fn side_changes_at_joint(first: &Patch, second: &Patch) -> Result<bool, GeometryError> {
    let seam = nearest_ends(first, second)?;
    let [a, b] = seam.ends;
    Ok((a.last == b.last) != seam.crossed)
}

fn report(
    design: &Design,
    chain: &Chain,
    [first, second]: [&Patch; 2],
    seam: &FacingEnds,
) -> JointReport {
    let [a, b] = seam.ends;
    let (own, mut other) = (a.growth(false), b.growth(true));
    if seam.crossed {
        // The same ruling seen the other way.
        other.reverse();
        other = other.map(|m| m.map(|m| m.map(|c| -c)));
    }
    let angle = |(n, m): (&Option<Point>, &Option<Point>)| match (n, m) {
        (Some(n), Some(m)) => libm::atan2(norm(&cross(n, m)), dot(n, m)),
        _ => std::f64::consts::FRAC_PI_2,
    };
    let kink = own
        .iter()
        .zip(&other)
        .map(angle)
        .fold(0.0, f64::max)
        .to_degrees();
    let limits = &design.tolerances;
    // Sheets that fold back have their planes in common and nothing else.
    let contact = if kink > 90.0 {
        Contact::folded()
    } else {
        contact(first, second, seam, limits.continuity)
    };
    let curvature = curvatures([first, second], seam);
    let smooth = seam.gap <= limits.gap && kink <= limits.kink;
    let geometric = if seam.gap > limits.gap {
        None
    } else if !smooth {
        Some(0)
    } else {
        let bent = curvature.is_some_and(|share| share <= CURVATURE);
        Some(contact.geometric.unwrap_or(0).max(if bent { 2 } else { 1 }))
    };
    JointReport {
        chain: chain.name.clone(),
        patches: [first.name.clone(), second.name.clone()],
        gap: seam.gap,
        kink,
        curvature,
        geometric,
        parametric: contact.parametric.filter(|_| seam.gap <= limits.gap),
        betas: contact.betas,
        scale: contact.scale,
    }
}

/// The contact of what two patches are made from.
#[derive(Default)]
struct Contact {
    geometric: Option<usize>,
    parametric: Option<usize>,
    betas: Vec<Vec<f64>>,
    scale: Vec<f64>,
}

impl Contact {
    /// That of sheets that meet in a ruling and lie on the same side of it.
    fn folded() -> Self {
        Self {
            geometric: Some(0),
            parametric: Some(0),
            ..Self::default()
        }
    }
}

fn contact(first: &Patch, second: &Patch, seam: &FacingEnds, tolerance: f64) -> Contact {
    let [a, b] = seam.ends;
    // A trimmed end is not the end of what the patch is made from.
    let untrimmed = |patch: &Patch, end: PatchEnd| {
        let [from, to] = patch.ends.part;
        if end.last { to == 1.0 } else { from == 0.0 }
    };
    if !(untrimmed(first, a) && untrimmed(second, b)) {
        return Contact::default();
    }
    if let (Some(planes), Some(next)) = (&first.ends.planes, &second.ends.planes)
        && a.last
        && !b.last
        && let Ok(measure) = planes.joint_with(next, ORDER)
    {
        let order = measure.order_within(tolerance);
        let kept = |list: &[f64]| list.iter().take(order.unwrap_or(0)).copied().collect();
        let one = measure
            .scale
            .first()
            .is_some_and(|s| (s - 1.0).abs() <= tolerance)
            && measure.scale.iter().skip(1).all(|s| s.abs() <= tolerance);
        return Contact {
            geometric: order,
            parametric: measure.parametric_order_within(tolerance),
            betas: vec![kept(&measure.betas)],
            scale: if one { Vec::new() } else { measure.scale },
        };
    }
    let (Some(rails), Some(next)) = (&first.ends.rails, &second.ends.rails) else {
        return Contact::default();
    };
    let passed = |rails: &[torse_geometry::prelude::Rail; 2], forward: bool| {
        rails.each_ref().map(|rail| {
            if forward {
                rail.clone()
            } else {
                rail.reversed()
            }
        })
    };
    let (own, mut other) = (passed(rails, a.last), passed(next, !b.last));
    if seam.crossed {
        other.reverse();
    }
    let measures: Vec<JointMeasure<f64, 3>> = own
        .iter()
        .zip(&other)
        .filter_map(|(rail, next)| rail.joint_with(next, ORDER).ok())
        .collect();
    let [one, two] = measures.as_slice() else {
        return Contact::default();
    };
    // Of rails with different beta values the surface has no more than their tangent planes in common.
    let agree = one
        .betas
        .iter()
        .zip(&two.betas)
        .take_while(|(x, y)| (*x - *y).abs() <= tolerance * (1.0 + x.abs()))
        .count();
    let least = |f: &dyn Fn(&JointMeasure<f64, 3>) -> Option<usize>| f(one)?.min(f(two)?).into();
    let order: Option<usize> = least(&|m| m.order_within(tolerance));
    let geometric = order.map(|order| order.min(agree));
    let kept = |m: &JointMeasure<f64, 3>| {
        let count = geometric.unwrap_or(0);
        m.betas.iter().take(count).copied().collect::<Vec<f64>>()
    };
    Contact {
        geometric,
        parametric: least(&|m| m.parametric_order_within(tolerance)),
        betas: vec![kept(one), kept(two)],
        scale: Vec::new(),
    }
}

/// Returns the largest difference of curvatures across the ruling, as a share; `None` where there are none.
fn curvatures(patches: [&Patch; 2], seam: &FacingEnds) -> Option<f64> {
    let mut worst = 0.0_f64;
    for v in [0.25, 0.5, 0.75] {
        let at = |k: usize| {
            let (patch, end): (&Patch, PatchEnd) = (patches[k], seam.ends[k]);
            let v = if k == 1 && seam.crossed { 1.0 - v } else { v };
            let principal = patch
                .sheet
                .principal(if end.last { 1.0 } else { 0.0 }, v)
                .ok()?;
            Some(
                principal
                    .iter()
                    .map(|p| p.curvature.abs())
                    .fold(0.0, f64::max),
            )
        };
        let (a, b) = (at(0)?, at(1)?);
        let length = norm(&sub(&seam.ends[0].points[1], &seam.ends[0].points[0]));
        // Flat on both sides, up to rounding.
        if a.max(b) * length > 1e-9 {
            worst = worst.max((a - b).abs() / a.max(b));
        }
    }
    Some(worst)
}

/// Returns what of the demands on a joint is missed.
fn objection(design: &Design, chain: &Chain, report: &JointReport) -> Option<String> {
    let limits = &design.tolerances;
    let [first, second] = &report.patches;
    if report.gap > limits.gap {
        // Developables of pieces of curves end where they must: that of the whole curves goes on.
        let connected = |name: &String| design.patch(name).is_some_and(|p| p.kind == "connect");
        let help = if connected(first) && connected(second) {
            "; if their curves go on in one another, make one of them, `row = [\"a\", \"b\"]`, and connect these: a whole panel"
        } else {
            ""
        };
        return Some(format!(
            "{first} and {second} do not meet: {:.6} mm apart, {} allowed{help}",
            report.gap, limits.gap
        ));
    }
    // Where an edge is asked for, any fold is one.
    if chain.continuity.is_none() && report.kink >= BACK {
        return Some(format!(
            "the sheet is folded back on itself where {first} meets {second}: by {:.6} degrees",
            report.kink
        ));
    }
    let wanted = chain.continuity?;
    let reached = match wanted {
        Smoothness::G0 => true,
        Smoothness::G1 => report.geometric >= Some(1),
        Smoothness::G2 => report.geometric >= Some(2),
        Smoothness::C(order) => report.parametric >= Some(order),
    };
    (!reached).then(|| {
        let fold = match report.geometric {
            Some(0) => format!("; the sheet is folded by {:.6} degrees", report.kink),
            _ => String::new(),
        };
        format!(
            "the joint of {first} and {second} is {}, where {} is wanted{fold}",
            report.smoothness(),
            wanted.name(),
        )
    })
}

impl JointReport {
    /// Returns the continuity in a word or two: `G2, C1`.
    #[must_use]
    pub fn smoothness(&self) -> String {
        match (self.geometric, self.parametric) {
            (None, _) => "open".to_owned(),
            (Some(g), None) => format!("G{g}"),
            (Some(g), Some(c)) => format!("G{g}, C{c}"),
        }
    }
}
