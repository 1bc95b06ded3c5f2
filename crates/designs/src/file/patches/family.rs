//! Developables that a family of planes envelops, and those that continue one.

use super::raw::{Cutting, MadePatches, UntrimmedSurface};
use crate::file::Parts;
use crate::file::planes::{continued, pair};
use crate::file::reader::{Entries, Named, NumberKind, Reader, Value, accepted};
use crate::file::shapes::shape;
use std::ops::Range;
use torse_geometry::prelude::{Cut, Planes, Sheet};

/// Returns the entries `between` or `range`.
pub(super) fn cutting(
    reader: &mut Reader,
    entries: &mut Entries<'_>,
    parts: &Parts,
    tangent: bool,
) -> Option<Cutting> {
    let span = entries.span.clone();
    match (entries.take("between"), entries.take("range")) {
        (Some(value), None) if !tangent => pair(reader, value, &parts.planes).map(Cutting::Between),
        (None, Some(value)) if tangent => reader
            .numbers(value, [NumberKind::None; 2])
            .map(Cutting::Tangent),
        (None, Some(value)) => {
            // The parameter of eq. (3.7) goes with a x a'; the foot of the ruling is a length.
            reader
                .numbers(value, [NumberKind::Length; 2])
                .map(Cutting::Range)
        }
        _ => {
            let help = if tangent {
                "`range = [from, to]`, in units of the derivative of the edge of regression"
            } else {
                "`between = [PLANE, PLANE]`, or `range = [from, to]`"
            };
            let message = format!("{} does not say where its rulings end", entries.what);
            reader.complain(&span, message, help);
            None
        }
    }
}

pub(super) fn developable(
    reader: &mut Reader,
    span: &Range<usize>,
    planes: Planes,
    cut: Cutting,
) -> Option<UntrimmedSurface> {
    let sheet = match cut {
        Cutting::Between([first, second]) => Sheet::envelope(&planes, Cut::between(first, second)),
        Cutting::Range([from, to]) => Sheet::envelope(&planes, Cut::range(from, to)),
        Cutting::Tangent([from, to]) => Sheet::tangent(&planes, from, to),
    };
    let sheet = accepted(reader, span, sheet)?;
    let mut notes = Vec::new();
    if let Some(index) = planes.opposing_normals() {
        notes.push(format!(
            "the normals of the control planes {} and {} oppose: was the sign of one lost?",
            index + 1,
            index + 2
        ));
    }
    Some(UntrimmedSurface {
        sheet,
        planes: Some(planes),
        rails: None,
        cut: Some(cut),
        notes,
    })
}

/// Returns a patch that continues another one.
pub(super) fn continuation(
    reader: &mut Reader,
    entries: &mut Entries<'_>,
    value: Value<'_>,
    parts: &Parts,
    known: &Named<MadePatches>,
) -> Option<UntrimmedSurface> {
    let (span, place) = (entries.span.clone(), value.span());
    let first = reader.named(value, "patch", known)?;
    let (Some(planes), Some(cut)) = (
        first
            .patches
            .first()
            .and_then(|patch| patch.ends.planes.as_ref()),
        first.cut,
    ) else {
        let help = "it is made by `envelope` or `tangent`; curves are continued under [curves]";
        reader.complain(&place, "this patch is not given by planes", help);
        return None;
    };
    let shape = shape(reader, entries);
    let own = entries.has("between") || entries.has("range");
    let tangent = matches!(cut, Cutting::Tangent(_));
    let cut = if own {
        cutting(reader, entries, parts, tangent)
    } else {
        Some(cut)
    };
    let next = continued(reader, entries, planes, shape?, &parts.planes)?;
    developable(reader, &span, next, cut?)
}
