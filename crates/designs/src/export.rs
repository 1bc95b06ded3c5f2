//! Files of designs: patterns, meshes, CAD patches, by the ending of the file.

use crate::design::{Design, DesignPiece, FreeSurface, Patch, Tensor};
use crate::error::DesignError;
use crate::inspect::side_changes_at_joint;
use crate::space_openings::{OpenSide, SpaceOpening, openings_in_space};
use crate::unroll::{Demand, drawing, unroll};
use std::path::Path;
use torse_exchange::{
    CadModel, ExchangeError, Mesh, approximate_tensor, convert, dxf, glb, iges, obj, ply, step,
    stl, svg, three_mf,
};
use torse_geometry::Surface;
use torse_geometry::prelude::GeometryError;
use torse_geometry::vector::{norm, sub};

/// The endings of all formats.
pub const ENDINGS: &[&str] = &[
    "dxf", "svg", "stl", "obj", "ply", "3mf", "glb", "step", "stp", "iges", "igs",
];
/// The endings of patterns.
pub const PATTERNS: &[&str] = &["dxf", "svg"];

/// Returns the ending of a file, in small letters, if it is one of these.
///
/// # Errors
/// [`DesignError::Format`].
pub fn ending(path: &Path, known: &'static [&'static str]) -> Result<&'static str, DesignError> {
    let ending = path
        .extension()
        .and_then(|e| e.to_str())
        .map(str::to_ascii_lowercase);
    let found = ending.and_then(|ending| known.iter().find(|known| **known == ending));
    found.copied().ok_or_else(|| DesignError::Format {
        path: path.to_owned(),
        known,
    })
}

/// Returns the bytes of a file with this ending, one of [`ENDINGS`]: of the piece or the surface that `demand` names, or of
/// all. Patterns are made as it says; meshes are solids where the design has a thickness; CAD patches are exact where they can be, else within the tolerance
/// `surface`.
///
/// # Errors
/// As [`unroll`] for patterns, [`DesignError::NoSuch`] for a name that is not there, [`DesignError::Exchange`] for what a format cannot hold.
///
/// ```
/// use torse_designs::export::bytes;
/// use torse_designs::unroll::Demand;
/// let design = torse_designs::read("tube.toml", r#"
///     [sheet]
///     thickness = 1
///     [curves.rim]
///     arc = { centre = [0, 0, 0], from = [20, 0, 0], to = [0, 20, 0] }
///     [patches.tube]
///     cylinder = "rim"
///     direction = [0, 0, 30]
/// "#)?;
/// assert!(bytes(&design, "stl", &Demand::default())?.len() > 84);
/// assert!(bytes(&design, "step", &Demand::default())?.starts_with(b"ISO-10303-21;"));
/// # Ok::<(), torse_designs::DesignError>(())
/// ```
pub fn bytes(design: &Design, ending: &str, demand: &Demand) -> Result<Vec<u8>, DesignError> {
    let mesh = || mesh_of(design, &Chosen::by(design, demand)?);
    let model = || model_of(design, &Chosen::by(design, demand)?);
    Ok(match ending {
        "dxf" | "svg" => {
            let drawing = drawing(design, &unroll(design, demand)?)?;
            let text = if ending == "dxf" {
                dxf(&drawing)?
            } else {
                svg(&drawing)?
            };
            text.into_bytes()
        }
        "stl" => stl(&mesh()?)?,
        "obj" => obj(&mesh()?)?.into_bytes(),
        "ply" => ply(&mesh()?)?,
        "3mf" => three_mf(&mesh()?)?,
        "glb" => glb(&mesh()?)?,
        "step" | "stp" => step(&model()?)?.into_bytes(),
        "iges" | "igs" => iges(&model()?)?.into_bytes(),
        other => {
            return Err(DesignError::Format {
                path: other.into(),
                known: ENDINGS,
            });
        }
    })
}

/// What of a design a file in space has.
#[derive(Debug)]
struct Chosen<'d> {
    pieces: Vec<DesignPiece>,
    surfaces: Vec<&'d FreeSurface>,
}

impl<'d> Chosen<'d> {
    fn all(design: &'d Design) -> Self {
        Self {
            pieces: design.pieces(),
            surfaces: design.surfaces.iter().collect(),
        }
    }

    /// Returns what a demand names, or everything.
    ///
    /// # Errors
    /// [`DesignError::NoSuch`] for a name that no piece and no surface has, [`DesignError::LeftOut`] for that of a face
    /// without a piece.
    fn by(design: &'d Design, demand: &Demand) -> Result<Self, DesignError> {
        let mut chosen = Self::all(design);
        let Some(name) = &demand.only else {
            return Ok(chosen);
        };
        let pieces = chosen.pieces.iter().map(|piece| piece.name.clone());
        let surfaces = chosen.surfaces.iter().map(|surface| surface.name.clone());
        let known: Vec<String> = pieces.chain(surfaces).collect();
        if !known.contains(name) {
            return Err(design.without(name, known));
        }
        chosen.pieces.retain(|piece| piece.name == *name);
        chosen.surfaces.retain(|surface| surface.name == *name);
        Ok(chosen)
    }

    fn has(&self, patch: usize) -> bool {
        self.pieces
            .iter()
            .any(|piece| piece.patches.contains(&patch))
    }
}

/// Returns the patches as CAD patches with shared edges.
///
/// # Errors
/// [`DesignError::Exchange`].
pub fn model(design: &Design) -> Result<CadModel, DesignError> {
    model_of(design, &Chosen::all(design))
}

fn model_of(design: &Design, chosen: &Chosen<'_>) -> Result<CadModel, DesignError> {
    let limits = &design.tolerances;
    let mut model = CadModel::new(&design.name, limits.gap)?;
    let openings = openings_in_space(design)?;
    let patches = design.patches.iter().enumerate();
    for (index, patch) in patches.filter(|(index, _)| chosen.has(*index)) {
        let converted = convert(&patch.sheet, limits.surface)?;
        let certificate = patch.sheet.certify(64).map_err(ExchangeError::from)?;
        let developable = certificate.is_developable_within(limits.twist.to_radians());
        let converted = if developable {
            converted.declared_developable()
        } else {
            converted
        };
        let several = converted.patches.len() > 1;
        let own = openings.iter().filter(|opening| opening.patch == index);
        let (borders, own): (Vec<_>, Vec<_>) =
            own.partition(|opening| opening.open == OpenSide::Outside);
        match borders.first() {
            Some(border) => {
                model.add_within(&patch.name, converted, &border.around(&patch.sheet)?)?
            }
            None => model.add(&patch.name, converted)?,
        }
        for opening in own {
            if several || opening.is_clipped() {
                return Err(DesignError::Mark {
                    patch: patch.name.clone(),
                    reason: "a hole over a joint of faces has no form in CAD files: export a mesh"
                        .to_owned(),
                });
            }
            model.open(&opening.around(&patch.sheet)?)?;
        }
    }
    for surface in &chosen.surfaces {
        for part in &surface.parts {
            model.add(&surface.name, approximate_tensor(part, limits.surface)?)?;
        }
    }
    Ok(model)
}

/// Returns the design as one mesh: the patches of a piece welded and seen from the same side, thickened where a
/// thickness is known.
///
/// # Errors
/// [`DesignError::Exchange`].
pub fn mesh(design: &Design) -> Result<Mesh, DesignError> {
    mesh_of(design, &Chosen::all(design))
}

fn mesh_of(design: &Design, chosen: &Chosen<'_>) -> Result<Mesh, DesignError> {
    let limits = &design.tolerances;
    let mut whole = Mesh::default();
    let openings = openings_in_space(design)?;
    for piece in &chosen.pieces {
        let sheet = surface(design, piece, &openings)?;
        let part = match design.metal {
            Some(metal) => sheet.thickened(metal.sheet.thickness())?,
            None => sheet,
        };
        whole.append(&part)?;
    }
    for surface in &chosen.surfaces {
        let mut shape = Mesh::default();
        for part in &surface.parts {
            let [rows, columns] =
                steps(part, limits.surface).map_err(|reason| DesignError::Patch {
                    patch: surface.name.clone(),
                    reason,
                })?;
            shape.append(&Mesh::sample(part, rows, columns)?)?;
        }
        let shape = if surface.parts.len() > 1 {
            shape.welded(limits.gap)?
        } else {
            shape
        };
        whole.append(&match design.metal {
            Some(metal) => shape.thickened(metal.sheet.thickness())?,
            None => shape,
        })?;
    }
    Ok(whole)
}

/// The most steps of a mesh of a surface, each way.
const MAX_STEPS: usize = 512;

/// So many steps each way that triangles stay within a distance, as the second derivatives at samples tell.
fn steps(surface: &Tensor, within: f64) -> Result<[usize; 2], GeometryError> {
    let samples = 16;
    let mut bends = [0.0_f64; 3];
    for (i, j) in (0..=samples).flat_map(|i| (0..=samples).map(move |j| (i, j))) {
        let [u, v] = [i, j].map(|k| f64::from(k) / f64::from(samples));
        let partials = surface.partials(&u, &v, 2)?;
        for (bend, (i, j)) in bends.iter_mut().zip([(2, 0), (1, 1), (0, 2)]) {
            *bend = bend.max(partials.get(i, j).map_or(f64::NAN, norm));
        }
    }
    // A linear interpolant over steps h and k misses by (|S_uu| h^2 + 2 |S_uv| h k + |S_vv| k^2)/8 at most.
    let [uu, uv, vv] = bends;
    let mut count = [1_usize; 2];
    let off = |[m, n]: [usize; 2]| {
        #[allow(clippy::cast_precision_loss)]
        let [h, k] = [m, n].map(|count| 1.0 / count as f64);
        (uu * h * h, 2.0 * uv * h * k, vv * k * k)
    };
    loop {
        let (a, b, c) = off(count);
        if (a + b + c) / 8.0 <= within || count.iter().any(|n| *n >= MAX_STEPS) {
            return Ok(count);
        }
        let finer = usize::from(c > a);
        count[finer] *= 2;
    }
}

fn surface(
    design: &Design,
    piece: &DesignPiece,
    openings: &[SpaceOpening],
) -> Result<Mesh, DesignError> {
    let mut surface = Mesh::default();
    let patches: Vec<_> = piece
        .patches
        .iter()
        .filter_map(|index| design.patches.get(*index))
        .collect();
    let mut over = false;
    let mut before = None;
    for (patch, index) in patches.iter().zip(&piece.patches) {
        if let Some(before) = before {
            let turned =
                side_changes_at_joint(before, patch).map_err(|reason: GeometryError| {
                    DesignError::Patch {
                        patch: patch.name.clone(),
                        reason,
                    }
                })?;
            over = over != turned;
        }
        let within = design.tolerances.surface;
        let own = openings.iter().filter(|opening| opening.patch == *index);
        let borders: Vec<Vec<[f64; 2]>> = own.flat_map(SpaceOpening::bounds).collect();
        let mesh = if borders.is_empty() {
            Mesh::ruled(&patch.sheet, within)?
        } else {
            Mesh::ruled_with_openings(&patch.sheet, within, &borders)?
        };
        surface.append(&if over { flipped(&mesh)? } else { mesh })?;
        before = Some(*patch);
    }
    let is_seamless = match patches.as_slice() {
        [patch] => !is_closed_around(patch, design.tolerances.gap)?,
        all => all.is_empty(),
    };
    if is_seamless {
        return Ok(surface);
    }
    Ok(surface.welded(design.tolerances.gap)?)
}

/// Returns whether the last ruling of a patch is its first one.
fn is_closed_around(patch: &Patch, within: f64) -> Result<bool, DesignError> {
    let ruling = |u: f64| {
        let ends = patch.sheet.ruling(u);
        ends.map_err(|reason| DesignError::Patch {
            patch: patch.name.clone(),
            reason,
        })
    };
    let (first, last) = (ruling(0.0)?, ruling(1.0)?);
    Ok((0..2).all(|i| norm(&sub(&last[i], &first[i])) <= within))
}

/// Returns the mesh seen from its other side.
fn flipped(mesh: &Mesh) -> Result<Mesh, DesignError> {
    let normals = mesh.normals().iter().map(|n| n.map(|c| -c)).collect();
    let triangles = mesh
        .triangles()
        .iter()
        .map(|&[a, b, c]| [a, c, b])
        .collect();
    Ok(Mesh::with_normals(
        mesh.vertices().to_vec(),
        normals,
        triangles,
    )?)
}
