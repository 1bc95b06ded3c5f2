//! The bends of a piece: how long each is on the blank.

use super::strip::{Side, Taken};
use super::{Rolled, ToolBend};
use crate::design::{Design, Material, Patch};
use crate::rounding::settled;
use torse_geometry::pattern::{BendingSheet, FlatPattern};
use torse_geometry::prelude::Sheet;
use torse_geometry::vector::{norm, sub};

/// What is farther from a circular cylinder, as a share of its radius, is none.
const SAME_RADIUS: f64 = 1e-6;
/// Rulings that turn by no more, in radians, are parallel.
const PARALLEL: f64 = 1e-9;

/// A patch that is bent.
pub(super) struct PatchBend {
    pub tool: ToolBend,
    /// Its first ruling on the pattern.
    pub start: Side,
    /// How wide it is there, and by which factor the blank is wider.
    pub width: f64,
    pub factor: f64,
}

/// A bend at the joint of two flat patches.
pub(super) struct FoldBend {
    pub tool: ToolBend,
    /// Where the patch before it ends on the pattern, and the one behind it starts.
    pub start: Side,
    pub end: Side,
    /// How far they are from the edge.
    pub setback: f64,
}

impl FoldBend {
    /// Returns what it takes of the patch before it.
    pub(super) fn taken_before(&self) -> Taken {
        Taken {
            edge: self.tool.name.clone(),
            side: self.start,
            setback: self.setback,
        }
    }

    /// Returns what it takes of the patch behind it.
    pub(super) fn taken_behind(&self) -> Taken {
        Taken {
            side: self.end.turned(),
            ..self.taken_before()
        }
    }
}

/// The joint behind a patch of the pattern.
pub(super) struct RulingJoint {
    /// The ends of the common ruling, left and right.
    pub ends: [[f64; 2]; 2],
    pub side: Side,
    pub angle: f64,
}

impl RulingJoint {
    pub(super) fn at(flat: &FlatPattern, place: usize) -> Option<Self> {
        let [_, ends] = flat.end_rulings(place)?;
        Some(Self {
            ends,
            side: Side::ahead(ends)?,
            angle: flat.edge_angle(place)?,
        })
    }
}

/// A radius that is so many times as large as a patch is long is none: over the whole patch it rises by less than a millionth
/// of its length.
const FLAT_RADIUS: f64 = 1e6;

/// Returns the smallest and the largest radius on the rulings of a patch of the pattern; infinite where it is flat. They are
/// those of the surface: the pattern knows how its normal turns to within its tolerance only, which is no radius where the
/// edges stand still and rulings crowd.
pub(super) fn radii(patch: &Patch, flat: &FlatPattern, place: usize) -> [f64; 2] {
    let near = patch.sheet.near_origin();
    let sheet = near.as_ref().map_or(&patch.sheet, |(near, _)| near);
    let flat_from = FLAT_RADIUS * size(sheet);
    // The ruling at a joint is one of both patches: it counts where the patch has no other.
    let own = flat.rulings().iter().filter(|ruling| ruling.piece == place);
    // At an end at which both edges stand still there is no normal and nothing to roll.
    let bent = own.filter_map(|ruling| {
        let ends = [0.0, 0.5, 1.0].map(|v| sheet.principal(ruling.x, v).ok());
        let bent = ends.iter().flatten().flatten();
        let most = bent.map(|principal| principal.curvature.abs());
        most.reduce(f64::max)
    });
    let radii = bent.map(|curvature| {
        let radius = 1.0 / curvature;
        if radius < flat_from {
            radius
        } else {
            f64::INFINITY
        }
    });
    radii.fold([f64::INFINITY, 0.0], |[low, high], radius| {
        [low.min(radius), high.max(radius)]
    })
}

/// Returns the largest distance between corners of a sheet.
fn size(sheet: &Sheet) -> f64 {
    let corners: Vec<[f64; 3]> = [0.0, 0.5, 1.0]
        .iter()
        .filter_map(|u| sheet.ruling(*u).ok())
        .flatten()
        .collect();
    let apart = |p: &[f64; 3]| corners.iter().map(|q| norm(&sub(q, p))).fold(0.0, f64::max);
    corners.iter().map(apart).fold(0.0, f64::max)
}

/// Rulings at which the radius of the wide end of a cone is measured.
const RULINGS: u32 = 256;

/// Returns how a patch is rolled that has these radii on its rulings; where it reaches an apex, the radii at its other
/// end.
pub(super) fn rolled(patch: &Patch, radii: [f64; 2]) -> Result<Rolled, String> {
    let name = patch.name.clone();
    let [first, second] = patch.apexes();
    if first == second {
        return Ok(Rolled {
            name,
            radii,
            apex: false,
        });
    }
    let wide = if first { 1.0 } else { 0.0 };
    let mut radii = [f64::INFINITY, 0.0_f64];
    for k in 0..=RULINGS {
        let u = f64::from(k) / f64::from(RULINGS);
        let bent = patch.sheet.principal(u, wide);
        let bent = bent.map_err(|error| error.to_string())?;
        let [a, b] = bent.map(|principal| principal.curvature.abs());
        let radius = 1.0 / a.max(b);
        radii = [radii[0].min(radius), radii[1].max(radius)];
    }
    Ok(Rolled {
        name,
        radii,
        apex: true,
    })
}

/// Returns the sheet of a design, with the K-factor for this inside radius.
fn sheet(design: &Design, name: &str, inside_radius: f64) -> Result<BendingSheet, String> {
    let metal = metal(design, name)?;
    let thickness = metal.sheet.thickness();
    let ratio = inside_radius / thickness;
    let k = design.bending.neutral.k_factor(ratio).ok_or_else(|| {
        format!("`k-factor` says nothing of `{name}`, whose inside radius is {ratio:.3} times the thickness")
    })?;
    BendingSheet::new(thickness, k).map_err(|error| error.to_string())
}

fn metal(design: &Design, name: &str) -> Result<Material, String> {
    design.metal.ok_or_else(|| {
        format!("`{name}` is bent, and the blank depends on the `thickness` under [sheet]")
    })
}

fn tool(
    sheet: &BendingSheet,
    name: String,
    angle: f64,
    inside_radius: f64,
    designed: f64,
) -> ToolBend {
    let allowance = sheet.bend_allowance(angle, inside_radius);
    ToolBend {
        name,
        line: [[0.0; 2]; 2],
        angle,
        inside_radius,
        k_factor: sheet.k_factor(),
        allowance,
        deduction: sheet.bend_deduction(angle, inside_radius),
        growth: allowance - designed,
    }
}

/// Returns the bend that a patch is: an arc of a circular cylinder.
pub(super) fn patch_bend(
    design: &Design,
    patch: &Patch,
    flat: &FlatPattern,
    place: usize,
) -> Result<PatchBend, String> {
    let name = &patch.name;
    let rulings: Vec<_> = flat
        .rulings()
        .iter()
        .filter(|ruling| ruling.piece == place)
        .collect();
    let no_cylinder =
        || format!("`{name}` is said to be a bend, and is no arc of a circular cylinder");
    // By its control points: rulings may have one radius by chance.
    let cylinder = patch.sheet.circular_cylinder();
    let round = cylinder.filter(|found| found.off <= SAME_RADIUS * found.radius);
    let Some(cylinder) = round else {
        let [low, high] = radii(patch, flat, place);
        let shown = if high.is_finite() && high - low > SAME_RADIUS * low {
            format!("its radius goes from {low:.4} to {high:.4} mm")
        } else {
            match cylinder {
                Some(found) => format!("it may be {:.2e} mm beside one of radius {:.4} mm", found.off, found.radius),
                None => "its edges are neither arcs nor Bezier curves with parallel rulings between them".to_owned(),
            }
        };
        return Err(format!("{}: {shown}", no_cylinder()));
    };
    let [first, last] = flat.end_rulings(place).ok_or_else(no_cylinder)?;
    let start = Side::ahead(first).ok_or_else(no_cylinder)?;
    let heights = last.map(|end| start.height(end));
    let width = 0.5 * (heights[0] + heights[1]);
    let length = libm::hypot(last[1][0] - last[0][0], last[1][1] - last[0][1]);
    if (heights[0] - heights[1]).abs() > PARALLEL * length.max(width.abs()) || width <= 0.0 {
        return Err(format!(
            "{}: its first and last ruling are not parallel",
            no_cylinder()
        ));
    }
    let bends: f64 = rulings
        .iter()
        .filter(|ruling| ruling.x > 0.0 && ruling.x < 1.0)
        .map(|ruling| ruling.bend)
        .sum();
    if bends == 0.0 {
        return Err(format!("`{name}` is a bend: ask for 3 rulings or more"));
    }
    let metal = metal(design, name)?;
    let radius = cylinder.radius;
    let angle = width / radius;
    let between = design.bending.surface.share() * metal.sheet.thickness();
    let inside_radius = settled(radius - between, 0.0, radius);
    if inside_radius < 0.0 {
        return Err(format!(
            "`{name}` has the radius {radius:.4} mm, and the inside of its sheet is {between:.4} mm nearer to the centre: there \
             is no such bend"
        ));
    }
    let sheet = sheet(design, name, inside_radius)?;
    let tool = tool(
        &sheet,
        name.clone(),
        angle.copysign(bends),
        inside_radius,
        width,
    );
    Ok(PatchBend {
        start,
        width,
        factor: tool.allowance / width,
        tool,
    })
}

/// Returns the bend at a joint, over this inside radius.
pub(super) fn joint_bend(
    design: &Design,
    name: String,
    joint: &RulingJoint,
    inside_radius: f64,
) -> Result<FoldBend, String> {
    let sheet = sheet(design, &name, inside_radius)?;
    if sheet.setback(joint.angle, inside_radius).is_none() {
        return Err(format!(
            "{name} folds by 180 degrees: the flanges lie on each other, and from no corner is a setback taken; draw the bend as a \
             patch of its own, a half cylinder with `bend = true`"
        ));
    }
    // From the tangent points to the corner, on the designed surface.
    let radius = inside_radius + design.bending.surface.share() * sheet.thickness();
    let setback = radius * libm::tan(0.5 * joint.angle.abs());
    Ok(FoldBend {
        tool: tool(&sheet, name, joint.angle, inside_radius, 2.0 * setback),
        start: joint.side.moved(-setback),
        end: joint.side.moved(setback),
        setback,
    })
}
