//! Patches.

mod connect;
mod direction;
mod family;
mod hermite;
mod marks;
mod raw;
mod strips;
mod sweep;

use super::edges;
use super::pieces::{PatchIntervals, distributed};
use super::reader::{Entries, Named, NumberKind, Reader, Value, accepted};
use super::{Parts, keys, named};
use crate::covers::SurfaceCover;
use crate::design::{Patch, Smoothness};
use connect::{assembled, connected, is_whole, paneled};
use family::{continuation, cutting, developable};
use hermite::hermite;
use marks::marks;
use raw::{MadePatches, UntrimmedSurface, trimmed};
use std::ops::Range;
use strips::covered;
use sweep::{CONE, CYLINDER, swept};
use torse_geometry::prelude::{PiecewiseRail, Sheet};

/// The ways to make a patch.
const KINDS: [&str; 9] = [
    "ruled",
    "connect",
    "envelope",
    "tangent",
    "cylinder",
    "cone",
    "hermite",
    "continues",
    "strips",
];

/// The patches that an entry with curves of several pieces became.
pub struct PatchGroup {
    /// The name of the entry.
    pub name: String,
    /// The indices of the patches.
    pub patches: Vec<usize>,
    /// Whether the last meets the first.
    pub closed: bool,
    /// What is demanded where they meet.
    pub continuity: Option<Smoothness>,
}

/// The patches of a file.
pub struct ReadPatches {
    /// The patches, those of an entry in a row.
    pub patches: Named<Patch>,
    /// Which of them belong together.
    pub groups: Vec<PatchGroup>,
    /// The surfaces that some of them cover.
    pub covers: Vec<SurfaceCover>,
}

pub fn patches(reader: &mut Reader, section: Option<Value<'_>>, parts: &Parts) -> ReadPatches {
    let made = named(
        reader,
        section,
        "[patches]",
        |reader, name, value, known| {
            let what = format!("[patches.{name}]");
            let mut entries = reader.entries(value, &what, keys::PATCH)?;
            let bend = entries.take("bend");
            let bend = bend.map_or(Some(false), |value| reader.truth(value));
            let edges = entries.take("edges");
            let edges = edges.map_or(Some(Vec::new()), |value| edges::names(reader, value));
            let allowances = entries.take("allowance");
            let mut made = patch(reader, name, &mut entries, parts, known)?;
            let (bend, edges) = (bend?, edges?);
            let allowances = allowances.map_or(Some(Vec::new()), |value| {
                edges::allowances(reader, value, &edges)
            });
            let allowances = allowances?;
            for patch in &mut made.patches {
                patch.bend = bend;
                patch.edges.clone_from(&edges);
                patch.allowances.clone_from(&allowances);
            }
            Some(made)
        },
    );
    let (mut patches, mut groups, mut covers) = (Named::new(), Vec::new(), Vec::new());
    for (name, made) in made {
        let Some(made) = made else {
            patches.push((name, None));
            continue;
        };
        let first = patches.len();
        patches.extend(
            made.patches
                .into_iter()
                .map(|patch| (patch.name.clone(), Some(patch))),
        );
        if let Some(mut cover) = made.cover {
            let mut from = first;
            for strip in &mut cover.strips {
                // So far they are counted within the entry.
                let to = from + strip.patches.len();
                strip.patches = (from..to).collect();
                if to > from + 1 {
                    groups.push(PatchGroup {
                        name: strip.name.clone(),
                        patches: strip.patches.clone(),
                        closed: false,
                        continuity: Some(Smoothness::G1),
                    });
                }
                from = to;
            }
            covers.push(cover);
        } else if patches.len() > first + 1 {
            groups.push(PatchGroup {
                name,
                patches: (first..patches.len()).collect(),
                closed: made.closed,
                continuity: made.continuity,
            });
        }
    }
    ReadPatches {
        patches,
        groups,
        covers,
    }
}

fn patch(
    reader: &mut Reader,
    name: &str,
    entries: &mut Entries<'_>,
    parts: &Parts,
    known: &Named<MadePatches>,
) -> Option<MadePatches> {
    let (what, span) = (entries.what.clone(), entries.span.clone());
    let part = entries.take("part").map(|value| {
        let place = value.span();
        let [from, to] = reader.numbers(value, [NumberKind::None; 2])?;
        if 0.0 <= from && from < to && to <= 1.0 {
            return Some([from, to]);
        }
        let message = format!("[{from}, {to}] is no part of a patch");
        reader.complain(
            &place,
            message,
            "`part = [from, to]` with 0 <= from < to <= 1",
        );
        None
    });
    let marks = entries
        .take("marks")
        .map_or(Some(Vec::new()), |value| marks(reader, value, parts));
    let mut given = KINDS.iter().filter(|kind| entries.has(kind));
    let (Some(kind), None) = (given.next().copied(), given.next()) else {
        let help = format!("one of `{}`", KINDS.join("`, `"));
        reader.complain(&span, format!("{what} is made in one of nine ways"), &help);
        return None;
    };
    let value = entries.take(kind)?;
    let place = value.span();
    let part = part.unwrap_or(Some([0.0, 1.0]))?;
    let mut cells = PatchIntervals::ONE;
    let raws = match kind {
        "ruled" | "connect" => {
            let pair = rails(reader, value, &parts.curves)?;
            let (mut branch, mut panel) = (None, None);
            if kind == "connect" {
                if let Some(value) = entries.take("branch") {
                    branch = Some(number(reader, value)?);
                }
                if let Some(value) = entries.take("panel") {
                    panel = Some(number(reader, value)?);
                }
                if let (Some(_), Some((_, place))) = (&branch, &panel) {
                    reader.complain(place, "`branch` and `panel` exclude each other", "");
                    return None;
                }
                let usual = branch.is_none() && accepted(reader, &place, is_whole(&pair))?;
                if panel.is_some() || usual {
                    let number = panel.map(|(number, _)| number).unwrap_or(1);
                    let found = accepted(reader, &place, Sheet::panels(&pair[0], &pair[1]))?;
                    let panels = paneled(reader, &place, &pair, &found)?;
                    let whole = match panels.get(number - 1) {
                        Some(panel) => panel,
                        None => {
                            let message = format!("there is no panel {number} between the curves");
                            let help = format!("`panel` is from 1 to {}", panels.len());
                            reader.complain(&place, message, &help);
                            return None;
                        }
                    };
                    if part != [0.0, 1.0] {
                        reader.complain(&place, "a whole panel has no `part`", "");
                        return None;
                    }
                    return assembled(reader, (name, &span), whole, panels, (number, marks?));
                }
            }
            let (found, pairs) = accepted(reader, &place, PatchIntervals::between(&pair, part))?;
            cells = found;
            let mut raws = Vec::with_capacity(pairs.len());
            for [first, second] in pairs {
                raws.push(if kind == "ruled" {
                    UntrimmedSurface::between(first, second)
                } else {
                    connected(reader, &place, [&first, &second], branch.clone())?
                });
            }
            raws
        }
        "cylinder" | "cone" => {
            let sweep = if kind == "cone" { &CONE } else { &CYLINDER };
            let curve = reader.named(value, "curve", &parts.curves).cloned();
            let swept = swept(reader, entries, parts, sweep);
            let (found, pieces) = accepted(reader, &place, PatchIntervals::cut(&curve?, part))?;
            cells = found;
            let swept = swept?;
            let mut raws = Vec::with_capacity(pieces.len());
            for piece in pieces {
                let sheet = (sweep.sheet)(&piece, swept.lines, swept.edges);
                raws.push(accepted(
                    reader,
                    &span,
                    sheet.and_then(UntrimmedSurface::swept),
                )?);
            }
            raws
        }
        "strips" => {
            if part != [0.0, 1.0] || !marks?.is_empty() {
                let message = "strips have neither a `part` nor `marks`";
                reader.complain(&place, message, "");
                return None;
            }
            let made = covered(reader, name, value, &parts.surfaces);
            complain_of_rest(reader, entries, kind);
            return made;
        }
        "hermite" => {
            let mut data = reader.entries(value, "a Hermite cone", keys::HERMITE)?;
            vec![hermite(reader, entries, &mut data, parts)?]
        }
        "continues" => vec![continuation(reader, entries, value, parts, known)?],
        _ => {
            let planes = reader.named(value, "family", &parts.families).cloned();
            let cut = cutting(reader, entries, parts, kind == "tangent");
            vec![developable(reader, &span, planes?, cut?)?]
        }
    };
    complain_of_rest(reader, entries, kind);
    // The curves of several pieces are cut already, and with them the part.
    let part = if cells.trimmed { [0.0, 1.0] } else { part };
    let cut = raws.first().and_then(|raw| raw.cut);
    let several = raws.len() > 1;
    let marks = distributed(marks?, &cells);
    let mut patches = Vec::with_capacity(raws.len());
    for (index, (raw, marks)) in raws.into_iter().zip(marks).enumerate() {
        let name = if several {
            format!("{name}.{}", index + 1)
        } else {
            name.to_owned()
        };
        patches.push(trimmed(reader, &span, (name, kind), raw, (part, marks))?);
    }
    Some(MadePatches {
        patches,
        closed: several && cells.closed,
        continuity: None,
        cut,
        cover: None,
    })
}

/// Entries that were not taken have no meaning.
fn complain_of_rest(reader: &mut Reader, entries: &mut Entries<'_>, kind: &str) {
    for key in keys::PATCH {
        if let Some(value) = entries.take(key) {
            let message = format!("`{key}` means nothing for a patch made by `{kind}`");
            reader.complain(&value.span(), message, "");
        }
    }
}

/// Returns the number of a developable or a panel, and where it is asked for.
fn number(reader: &mut Reader, value: Value<'_>) -> Option<(usize, Range<usize>)> {
    let place = value.span();
    let whole = |n: f64| n >= 1.0 && n.fract() == 0.0 && n <= 1e6;
    let number = reader.number_in(value, NumberKind::None, "{1, 2, ..}", whole)?;
    #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)]
    Some((number as usize, place))
}

fn rails(
    reader: &mut Reader,
    value: Value<'_>,
    curves: &Named<PiecewiseRail>,
) -> Option<[PiecewiseRail; 2]> {
    let items = reader.list(value, "curves", [2, 2])?;
    let both: Vec<_> = items
        .into_iter()
        .map(|item| reader.named(item, "curve", curves).cloned())
        .collect();
    match both.as_slice() {
        [Some(first), Some(second)] => Some([first.clone(), second.clone()]),
        _ => None,
    }
}
