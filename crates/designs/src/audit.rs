//! Is a face of a file developable? Decided where it can be, measured where not, with the place that says no.

use crate::design::Tolerances;
use crate::inspect::Assurance;
use crate::numbers::{at_most, number};
use serde::Serialize;
use torse_exchange::{CurveShape, ImportedFace, SplineSurface, SurfaceFrame, SurfaceShape};
use torse_geometry::prelude::{GeometryError, MeasureBudget, PiecewiseRail, Point, Sheet};
use torse_geometry::surface::CurvatureProof;
use torse_geometry::vector::{cross, dot, norm, sub};
use torse_geometry::{Coordinate, Over, Rails, Rational};

/// What was found out about a face.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[non_exhaustive]
pub struct FaceAudit {
    /// Whether its surface is developable, and how that is known.
    pub developable: Assurance,
    /// The largest angle between the tangent planes at the ends of a ruling, in degrees, bounds; of ruled surfaces.
    pub twist: Option<[f64; 2]>,
    /// Where it is farthest from developable.
    pub worst: Option<WorstPlace>,
    /// The answer in words.
    pub words: String,
}

/// A place of a surface that is not developable there.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[non_exhaustive]
pub struct WorstPlace {
    /// The point.
    pub point: Point,
    /// The Gaussian curvature, for one over square millimetres, measured; of surfaces that are not ruled.
    pub gaussian: Option<f64>,
    /// The other end of the ruling with the largest twist; of ruled surfaces.
    pub ruling: Option<Point>,
}

/// Exact evaluations that one surface may take.
const EVALUATIONS: usize = 20_000;
/// Steps of the grid on which the curvature of a patch is measured.
const STEPS: u32 = 8;
/// A surface whose Gaussian curvature, times the square of its size, is below this may be a rounded developable.
const ROUNDED: f64 = 1e-9;

impl FaceAudit {
    /// Judges the surface of a face; its edges do not matter.
    ///
    /// # Errors
    /// What the data of the surface refuse.
    pub fn of_surface(face: &ImportedFace) -> Result<Self, GeometryError> {
        match &face.surface {
            SurfaceShape::Plane(_) => Ok(exactly("exactly: a plane")),
            SurfaceShape::Cylinder(..) | SurfaceShape::Extruded(..) => {
                Ok(exactly("exactly: a cylinder"))
            }
            SurfaceShape::Cone(..) => Ok(exactly("exactly: a cone")),
            SurfaceShape::Sphere(frame, radius) => {
                let top: Point = std::array::from_fn(|k| frame.origin[k] + radius * frame.axis[k]);
                Ok(curved(
                    top,
                    1.0 / (radius * radius),
                    CurvatureKnown::Exactly,
                ))
            }
            SurfaceShape::Torus(frame, radius, tube) => {
                let reach = radius + tube;
                let outside: Point =
                    std::array::from_fn(|k| frame.origin[k] + reach * frame.across[k]);
                Ok(curved(
                    outside,
                    1.0 / (tube * reach),
                    CurvatureKnown::Exactly,
                ))
            }
            SurfaceShape::Revolved(curve, frame) => revolved(curve, frame),
            SurfaceShape::Ruled(pair) => {
                let [first, second] = pair.as_ref();
                ruled(&first.rail()?, &second.rail()?)
            }
            SurfaceShape::Spline(surface) => match surface.rails()? {
                Some([first, second]) => ruled(
                    &PiecewiseRail::spline(&first)?,
                    &PiecewiseRail::spline(&second)?,
                ),
                None => nearly_ruled(surface)?.map_or_else(|| tensor(surface), Ok),
            },
        }
    }
}

fn exactly(words: &str) -> FaceAudit {
    FaceAudit {
        developable: Assurance::ByConstruction,
        twist: None,
        worst: None,
        words: words.to_owned(),
    }
}

/// What is known of the Gaussian curvature of a surface that is not developable.
enum CurvatureKnown {
    /// Its value, by what the surface is.
    Exactly,
    /// That it is not zero everywhere; its values are measured.
    NotZero,
    /// Its values are measured.
    Measured,
}

/// Returns a surface with this Gaussian curvature at a point.
fn curved(point: Point, gaussian: f64, known: CurvatureKnown) -> FaceAudit {
    let [x, y, z] = point.map(number);
    let words = match known {
        CurvatureKnown::Exactly => format!(
            "no, by construction: at ({x}, {y}, {z}) the Gaussian curvature is {gaussian:.3e} /mm2"
        ),
        CurvatureKnown::NotZero => format!(
            "no, proved: the Gaussian curvature does not vanish; at ({x}, {y}, {z}) it is {gaussian:.3e} /mm2, measured"
        ),
        CurvatureKnown::Measured => format!(
            "no, measured: at ({x}, {y}, {z}) the Gaussian curvature is {gaussian:.3e} /mm2"
        ),
    };
    FaceAudit {
        developable: Assurance::No,
        twist: None,
        words,
        worst: Some(WorstPlace {
            point,
            gaussian: Some(gaussian),
            ruling: None,
        }),
    }
}

/// Straight lines between points of two curves with equal parameters.
fn ruled(first: &PiecewiseRail, second: &PiecewiseRail) -> Result<FaceAudit, GeometryError> {
    let [first, second] = first.common_refinement(second)?;
    let (mut exact, mut bounds) = (true, [0.0_f64; 2]);
    let mut worst: Option<(f64, [Point; 2])> = None;
    for (p, q) in first.rails()?.into_iter().zip(second.rails()?) {
        let sheet = Sheet::ruled(p, q);
        if Rails::<f64>::is_developable_by_construction(&sheet) {
            continue;
        }
        exact = false;
        // Nothing depends on where in space it lies.
        let near = sheet.near_origin().map(|(near, _)| near);
        let twist = near
            .as_ref()
            .unwrap_or(&sheet)
            .enclose(MeasureBudget::default())?
            .twist;
        bounds = [bounds[0].max(twist.low), bounds[1].max(twist.high)];
        if worst.as_ref().is_none_or(|(known, _)| twist.low > *known) {
            worst = Some((twist.low, sheet.ruling(twist.x)?));
        }
    }
    if exact {
        return Ok(FaceAudit {
            developable: Assurance::Proved,
            twist: Some([0.0; 2]),
            worst: None,
            words: "exactly, proved: one plane touches along each ruling".to_owned(),
        });
    }
    let twist = bounds.map(f64::to_degrees);
    let [low, high] = twist;
    let limit = Tolerances::USUAL.twist;
    let place = worst.map(|(_, [point, end])| WorstPlace {
        point,
        gaussian: None,
        ruling: Some(end),
    });
    let at = place.as_ref().map_or(String::new(), |place| {
        let shown = |p: &Point| {
            let [x, y, z] = p.map(number);
            format!("({x}, {y}, {z})")
        };
        let end = place.ruling.as_ref().map_or(String::new(), shown);
        format!(" along the ruling from {} to {end}", shown(&place.point))
    });
    let (developable, words) = if high <= limit {
        let words = format!(
            "not exactly; within {} degrees, proved: that much tangent planes turn along a ruling at most",
            at_most(high)
        );
        (Assurance::Within, words)
    } else if low > limit {
        let words = format!("no, proved: tangent planes turn by {low:.4} degrees{at}");
        (Assurance::No, words)
    } else {
        let words =
            format!("not decided: tangent planes turn by {low:.3e} to {high:.3e} degrees{at}");
        (Assurance::Measured, words)
    };
    Ok(FaceAudit {
        developable,
        twist: Some(twist),
        worst: place,
        words,
    })
}

/// Returns what is known of a B-spline surface that is straight in one direction whatever its degree there, or the
/// rounding of such a surface; `None` where that shows no developable.
fn nearly_ruled(surface: &SplineSurface) -> Result<Option<FaceAudit>, GeometryError> {
    let Some(straight) = surface.straightened()? else {
        return Ok(None);
    };
    let Some([first, second]) = straight.surface.rails()? else {
        return Ok(None);
    };
    let (first, second) = (
        PiecewiseRail::spline(&first)?,
        PiecewiseRail::spline(&second)?,
    );
    let found = ruled(&first, &second)?;
    if straight.distance == 0.0 {
        return Ok(Some(found));
    }
    let away = at_most(straight.distance);
    let words = match found.developable {
        Assurance::Proved => {
            format!("within {away} mm of a developable between two of its edges, proved")
        }
        Assurance::Within => {
            let turn = found.twist.map_or(f64::NAN, |[_, high]| high);
            format!(
                "within {away} mm, proved, of a ruled surface between two of its edges, along a ruling of which tangent planes turn by at most {} degrees, proved",
                at_most(turn)
            )
        }
        _ => return Ok(None),
    };
    Ok(Some(FaceAudit {
        developable: Assurance::Within,
        words,
        ..found
    }))
}

/// Returns a B-spline surface, by the Bezier patches that it consists of.
fn tensor(surface: &SplineSurface) -> Result<FaceAudit, GeometryError> {
    let patches = surface.patches()?;
    let (mut budget, mut open) = (EVALUATIONS, false);
    let mut refuted = false;
    let mut worst: Option<(Point, f64)> = None;
    let mut size = 0.0_f64;
    for patch in &patches {
        let near = patch.over(&|q: &Rational| q.approximate())?;
        size = size.max(near.size()?);
        if let Some(place) = near.most_curved(STEPS)?
            && worst.is_none_or(|(_, known)| place.gaussian.abs() > known.abs())
        {
            worst = Some((place.point, place.gaussian));
        }
        if refuted {
            continue;
        }
        match patch.curvature_proof(budget)? {
            CurvatureProof::Zero => {
                let [m, n] = patch.degrees();
                budget = budget.saturating_sub(64 * m * n);
            }
            CurvatureProof::Nonzero { .. } => refuted = true,
            CurvatureProof::Undecided => open = true,
        }
    }
    let Some((point, gaussian)) = worst else {
        return Err(no_normal());
    };
    // Of numbers that were rounded the curvature is hardly ever zero.
    #[allow(clippy::cast_precision_loss)]
    let count = patches.len() as f64;
    let tiny = gaussian.abs() * size * size * count <= ROUNDED;
    Ok(match (refuted, open, tiny) {
        (false, false, _) => FaceAudit {
            developable: Assurance::Proved,
            twist: None,
            worst: None,
            words: "exactly, proved: the Gaussian curvature is zero".to_owned(),
        },
        (_, _, true) => FaceAudit {
            developable: Assurance::Measured,
            twist: None,
            worst: None,
            words: format!(
                "{}; the Gaussian curvature is {:.1e} /mm2 at most, measured: that of a developable that was rounded",
                if refuted {
                    "not exactly, proved"
                } else {
                    "not decided"
                },
                gaussian.abs()
            ),
        },
        (true, _, false) => curved(point, gaussian, CurvatureKnown::NotZero),
        (false, true, false) => curved(point, gaussian, CurvatureKnown::Measured),
    })
}

/// Returns a curve turned about an axis: measured along the curve.
fn revolved(curve: &CurveShape, frame: &SurfaceFrame) -> Result<FaceAudit, GeometryError> {
    let mut worst: Option<(Point, f64)> = None;
    let mut size = 0.0_f64;
    for rail in curve.rail()?.rails()? {
        for k in 0..=32_u32 {
            let x = f64::from(k) / 32.0;
            let derivatives = rail.derivatives(x, 2)?;
            let [point, first, second] = derivatives.as_slice() else {
                continue;
            };
            let arm = sub(point, &frame.origin);
            size = size.max(norm(&arm));
            // The same surface has the meridian (distance from the axis, height).
            let height = |v: &Point| dot(v, &frame.axis);
            let (h1, h2) = (height(first), height(second));
            let out = |v: &Point| cross(&cross(&frame.axis, v), &frame.axis);
            let (r, r1, r2) = (out(&arm), out(first), out(second));
            let radius = norm(&r);
            if radius == 0.0 {
                continue;
            }
            let slope = dot(&r, &r1) / radius;
            let bend = (dot(&r1, &r1) + dot(&r, &r2) - slope * slope) / radius;
            let speed = slope * slope + h1 * h1;
            let gaussian = h1 * (h2 * slope - h1 * bend) / (radius * speed * speed);
            let larger = worst.is_none_or(|(_, known)| gaussian.abs() > known.abs());
            if gaussian.is_finite() && larger {
                worst = Some((*point, gaussian));
            }
        }
    }
    let Some((point, gaussian)) = worst else {
        return Err(no_normal());
    };
    if gaussian.abs() * size * size <= ROUNDED {
        return Ok(FaceAudit {
            developable: Assurance::Measured,
            twist: None,
            worst: None,
            words: format!(
                "the Gaussian curvature is {:.1e} /mm2 at most, measured: a straight line turned about an axis",
                gaussian.abs()
            ),
        });
    }
    Ok(curved(point, gaussian, CurvatureKnown::Measured))
}

fn no_normal() -> GeometryError {
    GeometryError::Degenerate {
        what: "a surface without a normal",
        at: torse_geometry::Place::Whole,
    }
}
