//! Surfaces before they are trimmed, and what becomes of them.

use crate::covers::SurfaceCover;
use crate::design::{Mark, Patch, PatchEnds, Smoothness};
use crate::file::reader::{Reader, accepted};
use std::ops::Range;
use torse_geometry::prelude::{Construction, GeometryError, Place, Planes, Rail, Sheet};

/// The patches of an entry, one for each pieces of its curves, and where a continuation would begin.
pub(super) struct MadePatches {
    pub patches: Vec<Patch>,
    /// Whether the last piece ends where the first begins.
    pub closed: bool,
    /// What is demanded where they meet.
    pub continuity: Option<Smoothness>,
    pub cut: Option<Cutting>,
    /// The strips that they are, if they cover a surface; each is pieces of its own.
    pub cover: Option<SurfaceCover>,
}

/// What part of the rulings of a family a patch takes.
#[derive(Clone, Copy)]
pub(super) enum Cutting {
    Between([[f64; 4]; 2]),
    Range([f64; 2]),
    Tangent([f64; 2]),
}

/// A surface before it is trimmed.
pub(super) struct UntrimmedSurface {
    pub sheet: Sheet,
    pub planes: Option<Planes>,
    pub rails: Option<[Rail; 2]>,
    pub cut: Option<Cutting>,
    pub notes: Vec<String>,
}

impl UntrimmedSurface {
    pub fn between(first: Rail, second: Rail) -> Self {
        let sheet = Sheet::ruled(first.clone(), second.clone());
        Self::with_rails(sheet, [first, second])
    }

    pub fn connecting(sheet: Sheet, notes: Vec<String>) -> Self {
        Self {
            sheet,
            planes: None,
            rails: None,
            cut: None,
            notes,
        }
    }

    pub fn with_rails(sheet: Sheet, rails: [Rail; 2]) -> Self {
        Self {
            sheet,
            planes: None,
            rails: Some(rails),
            cut: None,
            notes: Vec::new(),
        }
    }

    /// Returns a cylinder or a cone, with its edges as rails.
    pub fn swept(sheet: Sheet) -> Result<Self, GeometryError> {
        let rails = match sheet.construction() {
            Construction::Cylinder(patch) => patch.rails()?,
            Construction::Cone(patch) => patch.rails()?,
            _ => {
                return Err(GeometryError::NoValue {
                    what: "edges of a cylinder or cone",
                    at: Place::Whole,
                });
            }
        };
        Ok(Self::with_rails(sheet, rails))
    }
}

/// Returns the patch of a surface: its part, with its marks.
pub(super) fn trimmed(
    reader: &mut Reader,
    span: &Range<usize>,
    (name, kind): (String, &'static str),
    raw: UntrimmedSurface,
    (part, marks): ([f64; 2], Vec<Mark>),
) -> Option<Patch> {
    let sheet = if part == [0.0, 1.0] {
        raw.sheet
    } else {
        accepted(reader, span, raw.sheet.part(part[0], part[1]))?
    };
    // What has no rulings has no place in a design.
    for x in [0.0, 0.5, 1.0] {
        accepted(reader, span, sheet.ruling(x))?;
    }
    Some(Patch {
        name,
        kind,
        sheet,
        border: None,
        ends: PatchEnds {
            planes: raw.planes,
            rails: raw.rails,
            part,
        },
        marks,
        bend: false,
        edges: Vec::new(),
        allowances: Vec::new(),
        notes: raw.notes,
    })
}
