//! Points, normals and curvatures of patches, and where they lie on the pattern.

use crate::design::{Design, Patch};
use crate::error::DesignError;
use crate::position::position;
use crate::unroll::{Demand, unroll};
use serde::Serialize;
use std::fmt::Write;
use torse_geometry::Surface;
use torse_geometry::pattern::PatternPlace;
use torse_geometry::prelude::{GeometryError, Point};
use torse_geometry::vector::unit;

/// The most points of one call.
pub const MAX_POINTS: usize = 1 << 20;

/// Where a design is evaluated.
#[derive(Debug, Clone, PartialEq)]
pub enum EvalPlaces {
    /// At these places `[u, v]`.
    Places(Vec<[f64; 2]>),
    /// At so many equal steps from ruling to ruling, and along rulings.
    Grid(usize, usize),
}

/// A point of a patch; lengths in millimetres.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[non_exhaustive]
pub struct EvalRow {
    /// The patch.
    pub patch: String,
    /// The parameter of the ruling.
    pub u: f64,
    /// The share of the ruling.
    pub v: f64,
    /// The point.
    pub point: Point,
    /// The unit normal; `null` where there is none.
    pub normal: Option<Point>,
    /// The principal curvatures, the larger first; `null` where there are none.
    pub curvatures: Option<[f64; 2]>,
    /// The place on the pattern; `null` where the piece has none.
    pub flat: Option<[f64; 2]>,
}

/// Evaluates a patch, or all of them.
///
/// # Errors
/// [`DesignError::NoSuch`] for a patch that is not there, [`DesignError::OutOfRange`] for places outside of [0, 1] and
/// for more than [`MAX_POINTS`] points, [`DesignError::Patch`] where a patch has no point.
///
/// ```
/// use torse_designs::eval::{EvalPlaces, eval};
/// let design = torse_designs::read("tube.toml", r#"
///     [curves.rim]
///     arc = { centre = [0, 0, 0], from = [20, 0, 0], to = [0, 20, 0] }
///     [patches.tube]
///     cylinder = "rim"
///     direction = [0, 0, 30]
/// "#)?;
/// let rows = eval(&design, Some("tube"), &EvalPlaces::Places(vec![[0.5, 0.5]]))?;
/// let [x, y, z] = rows[0].point;
/// assert!((x - 200_f64.sqrt()).abs() < 1e-12 && (x - y).abs() < 1e-12 && z == 15.0);
/// let [along, _] = rows[0].flat.unwrap();
/// assert!((along - 15.0).abs() < 1e-9);
/// # Ok::<(), torse_designs::DesignError>(())
/// ```
pub fn eval(
    design: &Design,
    only: Option<&str>,
    at: &EvalPlaces,
) -> Result<Vec<EvalRow>, DesignError> {
    let wanted = |name: &String| only.is_none_or(|only| only == name);
    let patches: Vec<&Patch> = design.patches.iter().filter(|p| wanted(&p.name)).collect();
    let surfaces: Vec<_> = design.surfaces.iter().filter(|s| wanted(&s.name)).collect();
    if let Some(name) = only
        && patches.is_empty()
        && surfaces.is_empty()
    {
        return Err(DesignError::NoSuch {
            what: "patch",
            name: name.to_owned(),
            known: design.names(),
        });
    }
    let places = places(
        at,
        patches.len() + surfaces.iter().map(|s| s.parts.len()).sum::<usize>(),
    )?;
    // A design without a pattern is evaluated all the same.
    let flats = unroll(design, &Demand::default()).unwrap_or_default();
    let mut rows = Vec::with_capacity(patches.len() * places.len());
    for patch in patches {
        let index = design.patches.iter().position(|p| p.name == patch.name);
        let piece = flats
            .iter()
            .find(|flat| index.is_some_and(|i| flat.piece.patches.contains(&i)));
        let flat = piece.and_then(|piece| Some((&piece.flat, position(&piece.flat, patch)?)));
        for [u, v] in &places {
            let failed = |reason: GeometryError| DesignError::Patch {
                patch: patch.name.clone(),
                reason,
            };
            let partials = patch.sheet.partials(u, v, 1).map_err(failed)?;
            let principal = patch.sheet.principal(*u, *v).ok();
            rows.push(EvalRow {
                patch: patch.name.clone(),
                u: *u,
                v: *v,
                point: *partials.point(),
                normal: unit(&partials.normal()),
                curvatures: principal.map(|both| both.map(|p| p.curvature)),
                flat: flat.and_then(|(flat, piece)| {
                    let (x, v) = (*u, *v);
                    flat.flatten(PatternPlace { piece, x, v })
                }),
            });
        }
    }
    for surface in surfaces {
        for (part, [u, v]) in surface
            .parts
            .iter()
            .flat_map(|p| places.iter().map(move |at| (p, at)))
        {
            let failed = |reason: GeometryError| DesignError::Patch {
                patch: surface.name.clone(),
                reason,
            };
            let partials = part.partials(u, v, 1).map_err(failed)?;
            let principal = part.forms(u, v).and_then(|forms| forms.principal()).ok();
            rows.push(EvalRow {
                patch: surface.name.clone(),
                u: *u,
                v: *v,
                point: *partials.point(),
                normal: unit(&partials.normal()),
                curvatures: principal.map(|both| both.map(|p| p.curvature)),
                flat: None,
            });
        }
    }
    Ok(rows)
}

fn places(at: &EvalPlaces, patches: usize) -> Result<Vec<[f64; 2]>, DesignError> {
    let outside = |name, value, range| Err(DesignError::OutOfRange { name, value, range });
    #[allow(clippy::cast_precision_loss)]
    let places: Vec<[f64; 2]> = match at {
        EvalPlaces::Places(places) => places.clone(),
        EvalPlaces::Grid(m, n) => {
            let count = m.saturating_add(1).saturating_mul(n.saturating_add(1));
            if *m == 0 || *n == 0 || count.saturating_mul(patches) > MAX_POINTS {
                let range = "1, 2, .. with 2^20 points at most in all";
                let value = if *m.min(n) == 0 {
                    0.0
                } else {
                    *m.max(n) as f64
                };
                return outside("steps of the grid", value, range);
            }
            let share = |k: usize, of: usize| k as f64 / of as f64;
            let row = |i: usize| (0..=*n).map(move |j| [share(i, *m), share(j, *n)]);
            (0..=*m).flat_map(row).collect()
        }
    };
    for value in places.iter().flatten() {
        if !(0.0..=1.0).contains(value) {
            return outside("parameter", *value, "[0, 1]");
        }
    }
    Ok(places)
}

/// Returns the rows as comma-separated values with a head; empty where there is no value.
#[must_use]
pub fn csv(rows: &[EvalRow]) -> String {
    let mut text = String::from("patch,u,v,x,y,z,nx,ny,nz,k1,k2,flat_x,flat_y\n");
    for row in rows {
        let quoted = if row.patch.contains([',', '"']) {
            format!("\"{}\"", row.patch.replace('"', "\"\""))
        } else {
            row.patch.clone()
        };
        text.push_str(&quoted);
        let mut cells = |values: Option<&[f64]>, count: usize| {
            for k in 0..count {
                text.push(',');
                if let Some(value) = values.and_then(|list| list.get(k)) {
                    // Plus zero: no negative zero. Small numbers have an exponent, not a row of zeros.
                    let value = value + 0.0;
                    let _ = if value != 0.0 && value.abs() < 1e-4 {
                        write!(text, "{value:e}")
                    } else {
                        write!(text, "{value}")
                    };
                }
            }
        };
        cells(Some(&[row.u, row.v]), 2);
        cells(Some(&row.point), 3);
        cells(row.normal.as_ref().map(|n| n.as_slice()), 3);
        cells(row.curvatures.as_ref().map(|k| k.as_slice()), 2);
        cells(row.flat.as_ref().map(|f| f.as_slice()), 2);
        text.push('\n');
    }
    text
}
