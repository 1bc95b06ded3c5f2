//! Which edges meet.

use super::MAX_THINGS;
use super::patches::PatchGroup;
use super::reader::{Named, NumberKind, Reader, Value};
use crate::design::Patch;
use crate::seams::{EdgeName, PatchEdge, Seam};

pub fn seams(
    reader: &mut Reader,
    section: Option<Value<'_>>,
    patches: &Named<Patch>,
    groups: &[PatchGroup],
) -> Vec<Seam> {
    let items = section.and_then(|value| reader.list(value, "seams", [0, MAX_THINGS]));
    let mut seams = Vec::new();
    for item in items.unwrap_or_default() {
        let Some(parts) = reader.list(item, "entries of a seam", [2, 3]) else {
            continue;
        };
        let mut parts = parts.into_iter();
        let mut edge = || {
            let value = parts.next()?;
            let span = value.span();
            Some((edge(reader, value, patches, groups)?, span))
        };
        let (Some((first, _)), Some((second, span))) = (edge(), edge()) else {
            continue;
        };
        let joins = |seam: &Seam| {
            let [a, b] = &seam.edges;
            (a.overlaps(&first) && b.overlaps(&second))
                || (a.overlaps(&second) && b.overlaps(&first))
        };
        let wrong = if first.overlaps(&second) {
            Some(format!("`{}` would be sewn to itself", second.text))
        } else if seams.iter().any(joins) {
            let (first, second) = (&first.text, &second.text);
            Some(format!("`{first}` is sewn to `{second}` already"))
        } else {
            None
        };
        if let Some(message) = wrong {
            let help = "a seam has two edges, and each pair of edges one seam";
            reader.complain(&span, message, help);
            continue;
        }
        let ease = parts.next().map_or(Some(0.0), |value| {
            reader.number_in(value, NumberKind::Length, "(-infinity, infinity)", |_| true)
        });
        if let Some(ease) = ease {
            seams.push(Seam {
                edges: [first, second],
                ease,
            });
        }
    }
    seams
}

/// Returns an edge by its name: `patch.first`.
fn edge(
    reader: &mut Reader,
    value: Value<'_>,
    patches: &Named<Patch>,
    groups: &[PatchGroup],
) -> Option<EdgeName> {
    let (text, span) = reader.text(value, "the name of an edge")?;
    let Some((owner, edge)) = text.rsplit_once('.') else {
        let help = "an edge is `PATCH.start`, `.end`, `.first` or `.second`";
        reader.complain(&span, format!("`{text}` is no edge"), help);
        return None;
    };
    let found: Vec<usize> = match groups.iter().find(|group| group.name == owner) {
        Some(group) => group.patches.clone(),
        None => {
            let patch = reader.find(owner, &span, "patch", patches)?;
            let index = patches.iter().position(|(known, _)| *known == patch.name);
            index.into_iter().collect()
        }
    };
    // Names of its own come before the four that every patch has.
    let own = found.first().and_then(|index| patches.get(*index));
    let own = own.and_then(|(_, patch)| patch.as_ref());
    let own = own.map_or(&[] as &[_], |patch| &patch.edges);
    let named = own.iter().find(|(name, _)| name == edge).map(|(_, e)| *e);
    let usual = PatchEdge::ALL.iter().find(|(name, _)| *name == edge);
    let Some(edge) = named.or_else(|| usual.map(|(_, edge)| *edge)) else {
        let names = own.iter().map(|(name, _)| name.as_str());
        let all: Vec<&str> = names.chain(PatchEdge::ALL.map(|(name, _)| name)).collect();
        let help = format!("`{owner}` has `{}`", all.join("`, `"));
        reader.complain(&span, format!("`{owner}` has no edge `{edge}`"), &help);
        return None;
    };
    let patches = match edge {
        PatchEdge::Start => found.first().copied().into_iter().collect(),
        PatchEdge::End => found.last().copied().into_iter().collect(),
        PatchEdge::First | PatchEdge::Second => found,
    };
    Some(EdgeName {
        text,
        patches,
        edge,
    })
}
