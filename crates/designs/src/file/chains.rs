//! Chains of patches.

use super::reader::{Named, Reader, Value};
use super::{MOST_THINGS, keys, named};
use crate::design::{Chain, Layout, Patch, Smoothness};

const LAYOUTS: [(&str, Layout); 2] = [("attached", Layout::Attached), ("apart", Layout::Apart)];

pub fn chains(
    reader: &mut Reader,
    section: Option<Value<'_>>,
    patches: &Named<Patch>,
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
            let layout = entries.take("layout").map_or(Some(Layout::Attached), |v| {
                reader.word(v, "layout", &LAYOUTS)
            });
            let Some(value) = entries.take("patches") else {
                reader.complain(
                    &span,
                    format!("{what} lacks `patches`"),
                    "the names of at least two patches",
                );
                return None;
            };
            let items = reader.list(value, "patches", [2, MOST_THINGS])?;
            let mut indices = Vec::new();
            let mut whole = true;
            for item in items {
                let Some((name, place)) = reader.text(item, "the name of a patch") else {
                    whole = false;
                    continue;
                };
                let Some(patch) = reader.find(&name, &place, "patch", patches) else {
                    whole = false;
                    continue;
                };
                // The index among the patches that are right: a wrong one makes the design wrong anyway.
                let index = patches.iter().position(|(known, _)| *known == patch.name);
                let elsewhere = known.iter().filter_map(|(_, chain)| chain.as_ref());
                let taken = indices
                    .iter()
                    .chain(elsewhere.flat_map(|chain| &chain.patches));
                if index.is_some_and(|index| taken.into_iter().any(|i| *i == index)) {
                    reader.complain(&place, format!("`{name}` is in a chain already"), "");
                    whole = false;
                }
                indices.extend(index);
            }
            Some(Chain {
                name: name.to_owned(),
                patches: indices,
                continuity,
                closed: closed?,
                layout: layout?,
            })
            .filter(|_| whole)
        },
    );
    for (name, chain) in &chains {
        // Patterns are named after pieces.
        if chain.is_some() && patches.iter().any(|(patch, _)| patch == name) {
            let end = reader.source().text.len();
            let message = format!("a chain and a patch are both called `{name}`");
            reader.complain(&(0..end.min(1)), message, "names of pieces differ");
        }
    }
    chains.into_iter().filter_map(|(_, chain)| chain).collect()
}
