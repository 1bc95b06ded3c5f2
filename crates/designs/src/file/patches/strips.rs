//! Strips that cover a surface.

use super::connect::extent;
use super::raw::{MadePatches, UntrimmedSurface, trimmed};
use crate::covers::{CoveringStrip, SurfaceCover};
use crate::design::FreeSurface;
use crate::file::keys;
use crate::file::reader::{Named, NumberKind, Reader, Value, accepted};
use std::ops::Range;
use torse_geometry::prelude::{StripCover, StripDirection, StripError};

const DIRECTIONS: [(&str, StripDirection); 2] =
    [("u", StripDirection::U), ("v", StripDirection::V)];

/// Returns the patches of the entry `strips`.
pub(super) fn covered(
    reader: &mut Reader,
    name: &str,
    value: Value<'_>,
    surfaces: &Named<FreeSurface>,
) -> Option<MadePatches> {
    let mut entries = reader.entries(value, "strips", keys::STRIPS)?;
    let span = entries.span.clone();
    let mut missing = |reader: &mut Reader, key: &str, help: &str| {
        let value = entries.take(key);
        if value.is_none() {
            reader.complain(&span, format!("strips lack `{key}`"), help);
        }
        value
    };
    let surface = missing(reader, "surface", "the name of a surface of `[surfaces]`");
    let surface = surface.and_then(|value| {
        let place = value.span();
        reader
            .named(value, "surface", surfaces)
            .map(|found| (found, place))
    });
    let along = missing(reader, "along", "`u` or `v`: what grows along their edges");
    let along = along.and_then(|value| {
        let place = value.span();
        Some((reader.word(value, "along", &DIRECTIONS)?, place))
    });
    let within = missing(reader, "within", "how far strips may be from the surface");
    let within = within.and_then(|value| {
        reader.number_in(value, NumberKind::Length, "(0, infinity)", |d| d > 0.0)
    });
    let ((surface, place), along, within) = (surface?, along?, within?);
    let [part] = surface.parts.as_slice() else {
        let message = format!(
            "`{}` consists of {} surfaces",
            surface.name,
            surface.parts.len()
        );
        let help = "strips cover a surface of one piece: a net, or what is swung or swept";
        reader.complain(&place, message, help);
        return None;
    };
    let (direction, along_place) = along;
    let cover = match StripCover::new(part, direction, within) {
        Ok(cover) => cover,
        Err(error) => {
            complain(reader, [&span, &along_place], direction, &error);
            return None;
        }
    };
    strip_patches(reader, (name, &span), (surface, direction, within), cover)
}

/// Where the curves are the mistake, they are shown, else the entry.
fn complain(
    reader: &mut Reader,
    [span, along]: [&Range<usize>; 2],
    direction: StripDirection,
    error: &StripError,
) {
    let other = match direction {
        StripDirection::U => "v",
        StripDirection::V => "u",
    };
    match error {
        StripError::Asymptotic { point, .. } => {
            let [x, y, z] = point.map(crate::numbers::number);
            let message = format!("{error}; the point is ({x}, {y}, {z})");
            let help = format!(
                "`along = \"{other}\"`, or a net whose curves bend to one side along the surface"
            );
            reader.complain(along, message, &help);
        }
        StripError::Tip { .. } => {
            let help = format!(
                "`along = \"{other}\"`: the strip around a point is a cone; or a surface that ends before it"
            );
            reader.complain(along, error.to_string(), &help);
        }
        _ => reader.complain(span, error.to_string(), &remedy(error, other)),
    }
}

/// Returns what may help against the failure of a strip.
fn remedy(error: &StripError, other: &str) -> String {
    match error {
        StripError::Unbounded { .. } => {
            "bounds are found for polynomial surfaces, those without shape parameters".to_owned()
        }
        StripError::Narrow { reason, .. } if matches!(**reason, StripError::Unbounded { .. }) => {
            remedy(reason, other)
        }
        StripError::Narrow { .. } => {
            format!("`along = \"{other}\"`, or a surface without the part between these curves")
        }
        StripError::NoPanel { .. } => {
            format!("`along = \"{other}\"`, or a surface in parts")
        }
        StripError::TooFar { .. } | StripError::Spent { .. } => {
            format!("a larger `within`, `along = \"{other}\"`, or a surface in parts")
        }
        _ => String::new(),
    }
}

/// Returns the patches of strips, and what is told of them.
fn strip_patches(
    reader: &mut Reader,
    (name, span): (&str, &Range<usize>),
    (surface, direction, within): (&FreeSurface, StripDirection, f64),
    cover: StripCover,
) -> Option<MadePatches> {
    let fewest = cover.fewest;
    let folds = accepted(reader, span, cover.fold_angles())?;
    let mut patches = Vec::new();
    let mut strips = Vec::with_capacity(cover.strips.len());
    for (index, strip) in cover.strips.into_iter().enumerate() {
        let own = format!("{name}.{}", index + 1);
        let several = strip.panel.pieces.len() > 1;
        let first = patches.len();
        for (number, piece) in strip.panel.pieces.iter().enumerate() {
            let name = if several {
                format!("{own}.{}", number + 1)
            } else {
                own.clone()
            };
            let raw = UntrimmedSurface::connecting(piece.sheet.clone(), vec![extent(piece)]);
            let part = ([0.0, 1.0], Vec::new());
            patches.push(trimmed(reader, span, (name, "strips"), raw, part)?);
        }
        let fold = folds.get(index).copied();
        strips.push(CoveringStrip {
            name: own,
            patches: (first..patches.len()).collect(),
            range: strip.range,
            distance: strip.distance,
            fold: fold.map(|angles| angles.map(f64::to_degrees)),
        });
    }
    let along = DIRECTIONS.iter().find(|(_, known)| *known == direction);
    Some(MadePatches {
        patches,
        closed: false,
        continuity: None,
        cut: None,
        cover: Some(SurfaceCover {
            name: name.to_owned(),
            surface: surface.name.clone(),
            along: along.map_or("u", |(word, _)| word),
            within,
            strips,
            fewest,
        }),
    })
}
