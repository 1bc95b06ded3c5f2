//! Chains of patches.

use super::patches::PatchGroup;
use super::reader::{Named, NumberKind, Reader, Value};
use super::{MAX_THINGS, keys, named};
use crate::design::{Chain, ChainLayout, Patch, Smoothness};
use toml::de::DeValue;

const LAYOUTS: [(&str, ChainLayout); 2] = [
    ("attached", ChainLayout::Attached),
    ("apart", ChainLayout::Apart),
];

pub fn chains(
    reader: &mut Reader,
    section: Option<Value<'_>>,
    patches: &Named<Patch>,
    groups: &[PatchGroup],
) -> Vec<Chain> {
    let chains = named(
        reader,
        section,
        "[chains]",
        |reader, name, value, known: &Named<Chain>| {
            let what = format!("[chains.{name}]");
            let mut entries = reader.entries(value, &what, keys::CHAIN)?;
            let span = entries.span.clone();
            let continuity = entries.take("continuity");
            let continuity =
                continuity.and_then(|v| reader.word(v, "continuity", &Smoothness::ALL));
            let closed = entries
                .take("closed")
                .map_or(Some(false), |v| reader.truth(v));
            let layout = entries
                .take("layout")
                .map_or(Some(ChainLayout::Attached), |v| {
                    reader.word(v, "layout", &LAYOUTS)
                });
            let radius = entries.take("radius");
            let Some(value) = entries.take("patches") else {
                reader.complain(
                    &span,
                    format!("{what} lacks `patches`"),
                    "the names of at least two patches",
                );
                return None;
            };
            let items = reader.list(value, "patches", [1, MAX_THINGS])?;
            if items.len() == 1 && groups.is_empty() {
                reader.complain(&span, "1 patches: at least 2 are wanted, at most 512", "");
                return None;
            }
            let mut indices = Vec::new();
            let mut whole = true;
            for item in items {
                let Some((name, place)) = reader.text(item, "the name of a patch") else {
                    whole = false;
                    continue;
                };
                let found: Vec<usize> = match groups.iter().find(|group| group.name == name) {
                    Some(group) => group.patches.clone(),
                    None => {
                        let Some(patch) = reader.find(&name, &place, "patch", patches) else {
                            whole = false;
                            continue;
                        };
                        // The index among the patches that are right: a wrong one makes the design wrong anyway.
                        let index = patches.iter().position(|(known, _)| *known == patch.name);
                        index.into_iter().collect()
                    }
                };
                let elsewhere = known.iter().filter_map(|(_, chain)| chain.as_ref());
                let mut taken = indices
                    .iter()
                    .chain(elsewhere.flat_map(|chain| &chain.patches));
                if taken.any(|i| found.contains(i)) {
                    reader.complain(&place, format!("`{name}` is in a chain already"), "");
                    whole = false;
                }
                indices.extend(found);
            }
            let radii = radii(reader, radius, indices.len().saturating_sub(1))?;
            Some(Chain {
                name: name.to_owned(),
                patches: indices,
                continuity,
                closed: closed?,
                layout: layout?,
                radii,
            })
            .filter(|_| whole)
        },
    );
    for (name, chain) in &chains {
        // Patterns are named after pieces.
        let named = groups.iter().any(|group| group.name == *name)
            || patches.iter().any(|(patch, _)| patch == name);
        if chain.is_some() && named {
            let end = reader.source().text.len();
            let message = format!("a chain and a patch are both called `{name}`");
            reader.complain(&(0..end.min(1)), message, "names of pieces differ");
        }
    }
    let mut chains: Vec<Chain> = chains.into_iter().filter_map(|(_, chain)| chain).collect();
    // The pieces of a patch stay attached where no chain says otherwise.
    for group in groups {
        let taken = |chain: &Chain| {
            chain
                .patches
                .iter()
                .any(|index| group.patches.contains(index))
        };
        if !chains.iter().any(taken) {
            chains.push(Chain {
                name: group.name.clone(),
                patches: group.patches.clone(),
                continuity: group.continuity,
                closed: group.closed,
                layout: ChainLayout::Attached,
                radii: vec![None; group.patches.len().saturating_sub(1)],
            });
        }
    }
    chains
}

/// Returns the inside radii of the joints: one for all, or one for each.
fn radii(reader: &mut Reader, value: Option<Value<'_>>, joints: usize) -> Option<Vec<Option<f64>>> {
    let Some(value) = value else {
        return Some(vec![None; joints]);
    };
    let radius = |reader: &mut Reader, value: Value<'_>| {
        reader.number_in(value, NumberKind::Length, "[0, infinity)", |r| r >= 0.0)
    };
    if !matches!(value.get_ref(), DeValue::Array(_)) {
        return Some(vec![Some(radius(reader, value)?); joints]);
    }
    let items = reader.list(value, "radii of a chain", [joints, joints])?;
    let radii = items.into_iter().map(|item| radius(reader, item).map(Some));
    radii.collect()
}
