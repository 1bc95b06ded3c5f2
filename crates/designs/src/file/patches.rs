//! Patches.

use super::edges;
use super::pieces::{Cells, distributed, is_closed};
use super::planes::{continued, pair, plane};
use super::points::{list, point};
use super::reader::{Dimension, Entries, Named, Reader, Value, accepted};
use super::shapes::shape;
use super::{Parts, keys, named};
use crate::design::{Ends, Mark, Patch, Smoothness};
use std::ops::Range;
use torse_geometry::developable::{
    Branch, HermiteCone, QuarticData, QuinticData, oblique_image_as_printed,
};
use torse_geometry::prelude::{
    Connected, Construction, Cut, GeometryError, Panel, PanelKind, PanelPiece, Panels,
    PiecewiseRail, Place, Planes, Point, Rail, Reason, Sheet, SweptEdge,
};

/// The ways to make a patch.
const KINDS: [&str; 8] = [
    "ruled",
    "connect",
    "envelope",
    "tangent",
    "cylinder",
    "cone",
    "hermite",
    "continues",
];
/// The most marks of a patch, and points of a line.
const MOST_MARKS: usize = 256;

/// The patches of an entry, one for each pieces of its curves, and where a continuation would begin.
pub struct Made {
    patches: Vec<Patch>,
    /// Whether the last piece ends where the first begins.
    closed: bool,
    /// What is demanded where they meet.
    continuity: Option<Smoothness>,
    cut: Option<Cutting>,
}

/// The patches that an entry with curves of several pieces became.
pub struct Group {
    /// The name of the entry.
    pub name: String,
    /// The indices of the patches.
    pub patches: Vec<usize>,
    /// Whether the last meets the first.
    pub closed: bool,
    /// What is demanded where they meet.
    pub continuity: Option<Smoothness>,
}

/// What part of the rulings of a family a patch takes.
#[derive(Clone, Copy)]
enum Cutting {
    Between([[f64; 4]; 2]),
    Range([f64; 2]),
    Tangent([f64; 2]),
}

/// The patches, and which of them belong together.
pub fn patches(
    reader: &mut Reader,
    section: Option<Value<'_>>,
    parts: &Parts,
) -> (Named<Patch>, Vec<Group>) {
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
            let mut made = patch(reader, name, &mut entries, parts, known)?;
            let (bend, edges) = (bend?, edges?);
            for patch in &mut made.patches {
                patch.bend = bend;
                patch.edges.clone_from(&edges);
            }
            Some(made)
        },
    );
    let (mut patches, mut groups) = (Named::new(), Vec::new());
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
        if patches.len() > first + 1 {
            groups.push(Group {
                name,
                patches: (first..patches.len()).collect(),
                closed: made.closed,
                continuity: made.continuity,
            });
        }
    }
    (patches, groups)
}

/// A surface before it is trimmed.
struct Raw {
    sheet: Sheet,
    planes: Option<Planes>,
    rails: Option<[Rail; 2]>,
    cut: Option<Cutting>,
    notes: Vec<String>,
}

impl Raw {
    fn between(first: Rail, second: Rail) -> Self {
        let sheet = Sheet::ruled(first.clone(), second.clone());
        Self::with_rails(sheet, [first, second])
    }

    fn connecting(sheet: Sheet, notes: Vec<String>) -> Self {
        Self {
            sheet,
            planes: None,
            rails: None,
            cut: None,
            notes,
        }
    }

    fn with_rails(sheet: Sheet, rails: [Rail; 2]) -> Self {
        Self {
            sheet,
            planes: None,
            rails: Some(rails),
            cut: None,
            notes: Vec::new(),
        }
    }

    /// A cylinder or a cone, with its edges as rails.
    fn swept(sheet: Sheet) -> Result<Self, GeometryError> {
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

fn patch(
    reader: &mut Reader,
    name: &str,
    entries: &mut Entries<'_>,
    parts: &Parts,
    known: &Named<Made>,
) -> Option<Made> {
    let (what, span) = (entries.what.clone(), entries.span.clone());
    let part = entries.take("part").map(|value| {
        let place = value.span();
        let [from, to] = reader.numbers(value, [Dimension::None; 2])?;
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
        .map_or(Some(Vec::new()), |value| marks(reader, value));
    let mut given = KINDS.iter().filter(|kind| entries.has(kind));
    let (Some(kind), None) = (given.next().copied(), given.next()) else {
        let help = format!("one of `{}`", KINDS.join("`, `"));
        reader.complain(&span, format!("{what} is made in one of eight ways"), &help);
        return None;
    };
    let value = entries.take(kind)?;
    let place = value.span();
    let part = part.unwrap_or(Some([0.0, 1.0]))?;
    let mut cells = Cells::ONE;
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
                    let panels = paneled(reader, &place, &found)?;
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
            let (found, pairs) = accepted(reader, &place, Cells::between(&pair, part))?;
            cells = found;
            let mut raws = Vec::with_capacity(pairs.len());
            for [first, second] in pairs {
                raws.push(if kind == "ruled" {
                    Raw::between(first, second)
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
            let (found, pieces) = accepted(reader, &place, Cells::of(&curve?, part))?;
            cells = found;
            let swept = swept?;
            let mut raws = Vec::with_capacity(pieces.len());
            for piece in pieces {
                let sheet = (sweep.sheet)(&piece, swept.lines, swept.edges);
                raws.push(accepted(reader, &span, sheet.and_then(Raw::swept))?);
            }
            raws
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
    for key in keys::PATCH {
        if let Some(value) = entries.take(key) {
            let message = format!("`{key}` means nothing for a patch made by `{kind}`");
            reader.complain(&value.span(), message, "");
        }
    }
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
    Some(Made {
        patches,
        closed: several && cells.closed,
        continuity: None,
        cut,
    })
}

/// The patch of a surface: its part, with its marks.
fn trimmed(
    reader: &mut Reader,
    span: &Range<usize>,
    (name, kind): (String, &'static str),
    raw: Raw,
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
        ends: Ends {
            planes: raw.planes,
            rails: raw.rails,
            part,
        },
        marks,
        bend: false,
        edges: Vec::new(),
        notes: raw.notes,
    })
}

/// Whether both curves are closed, or one of them has several pieces: then a whole panel is meant.
fn is_whole(pair: &[PiecewiseRail; 2]) -> Result<bool, GeometryError> {
    if pair.iter().any(|curve| curve.count() > 1) {
        return Ok(true);
    }
    Ok(is_closed(&pair[0])? && is_closed(&pair[1])?)
}

/// The panels that were found, or why there are none.
fn paneled<'p>(
    reader: &mut Reader,
    place: &Range<usize>,
    found: &'p Panels,
) -> Option<&'p [Panel]> {
    let listed = |ranges: &[[[f64; 2]; 2]]| -> String {
        let each = ranges.iter().map(|[[s0, s1], [t0, t1]]| {
            format!("curve 1 from {s0} to {s1} with curve 2 from {t0} to {t1}")
        });
        each.collect::<Vec<_>>().join("; ")
    };
    match found {
        Panels::Found(panels) => return Some(panels),
        Panels::None { ways } => {
            let help = if ways.is_empty() {
                "no ruling touches both: bend the curves, or use `ruled`".to_owned()
            } else {
                format!("the developables between them: {}", listed(ways))
            };
            let message = "there is no whole panel between the curves: proved";
            reader.complain(place, message, &help);
        }
        Panels::Undecided { cells } => {
            let ranges: Vec<[[f64; 2]; 2]> = cells.iter().map(|c| [c.s, c.t]).take(8).collect();
            let help = format!(
                "{} cells of the parameters are undecided: {}",
                cells.len(),
                listed(&ranges)
            );
            reader.complain(place, "no whole panel was found between the curves", &help);
        }
    }
    None
}

/// The patches of a panel.
fn assembled(
    reader: &mut Reader,
    (name, span): (&str, &Range<usize>),
    panel: &Panel,
    all: &[Panel],
    (number, marks): (usize, Vec<Mark>),
) -> Option<Made> {
    let cells = Cells::of_panel(panel);
    let marks = distributed(marks, &cells);
    let several = panel.pieces.len() > 1;
    let mut patches = Vec::with_capacity(panel.pieces.len());
    for (index, (piece, marks)) in panel.pieces.iter().zip(marks).enumerate() {
        let name = if several {
            format!("{name}.{}", index + 1)
        } else {
            name.to_owned()
        };
        let mut notes = Vec::new();
        if index == 0 {
            notes.push(summary(panel, number, all.len()));
        }
        notes.push(extent(piece));
        let raw = Raw::connecting(piece.sheet.clone(), notes);
        patches.push(trimmed(
            reader,
            span,
            (name, "connect"),
            raw,
            ([0.0, 1.0], marks),
        )?);
    }
    Some(Made {
        patches,
        closed: several && panel.closed,
        continuity: (panel.folds == 0).then_some(Smoothness::G1),
        cut: None,
    })
}

/// What is said of a panel as a whole.
fn summary(panel: &Panel, number: usize, count: usize) -> String {
    let mut text = match count {
        1 => "a whole panel, the only one found".to_owned(),
        _ => format!("the whole panel {number} of {count}, the best first: `panel` takes another"),
    };
    text.push_str(&format!(
        "; {:.1} % of the curves in fans",
        100.0 * panel.fans
    ));
    if panel.folds > 0 {
        text.push_str(&format!(", {} folds", panel.folds));
    }
    if panel.turned {
        text.push_str("; curve 2 runs against curve 1: it is passed from its end to its start");
    }
    text
}

/// What part of the curves a piece of a panel takes.
fn extent(piece: &PanelPiece) -> String {
    let [[s0, s1], [t0, t1]] = piece.ranges;
    match piece.kind {
        PanelKind::Arc => {
            format!("touches curve 1 from {s0} to {s1} and curve 2 from {t0} to {t1}")
        }
        PanelKind::Fan(1) => {
            format!("a fan from the point of curve 1 at {s0} over curve 2 from {t0} to {t1}")
        }
        PanelKind::Fan(_) => {
            format!("a fan from the point of curve 2 at {t0} over curve 1 from {s0} to {s1}")
        }
    }
}

/// The number of a developable or a panel, and where it is asked for.
fn number(reader: &mut Reader, value: Value<'_>) -> Option<(usize, Range<usize>)> {
    let place = value.span();
    let whole = |n: f64| n >= 1.0 && n.fract() == 0.0 && n <= 1e6;
    let number = reader.number_in(value, Dimension::None, "{1, 2, ..}", whole)?;
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

/// A developable that touches two free curves: the one of this number, or the best.
fn connected(
    reader: &mut Reader,
    place: &Range<usize>,
    [first, second]: [&Rail; 2],
    branch: Option<(usize, Range<usize>)>,
) -> Option<Raw> {
    let mut notes = Vec::new();
    let mut found = accepted(reader, place, Sheet::between(first, second))?;
    if found.sheet.is_none() {
        // A curve may be drawn from either of its ends.
        let turned = accepted(reader, place, Sheet::between(first, &second.reversed()))?;
        if turned.sheet.is_some() {
            notes.push(
                "curve 2 runs against curve 1: it is passed from its end to its start".to_owned(),
            );
            found = turned;
        }
    }
    let Some(best) = &found.sheet else {
        let twists = found.gaps.iter().map(|gap| gap.worst.twist);
        let worst = twists.fold(0.0, f64::max).to_degrees();
        let help = format!(
            "the best ruling twists by up to {worst:.3} degrees: bend the curves, or use `ruled`"
        );
        reader.complain(place, "no developable touches both curves", &help);
        return None;
    };
    let count = found.branches.len();
    if let Some((number, place)) = branch {
        let Some(sheet) = number
            .checked_sub(1)
            .and_then(|index| found.sheets.get(index))
        else {
            let message = format!("there is no developable {number} between the curves");
            let help = format!("`branch` is from 1 to {count}");
            reader.complain(&place, message, &help);
            return None;
        };
        notes.push(format!(
            "the developable {number} of {count} that touch both curves"
        ));
        notes.extend(others(&found));
        return Some(Raw::connecting(sheet.clone(), notes));
    }
    notes.push(match count {
        1 => "one developable touches both curves".to_owned(),
        _ => format!(
            "of {count} developables that touch both curves: {}",
            reason(&found)
        ),
    });
    notes.extend(others(&found));
    if !found.gaps.is_empty() {
        notes.push(
            "`panel = 1` goes on over the rest with fans, where there is a whole panel".to_owned(),
        );
    }
    for gap in &found.gaps {
        notes.push(format!(
            "curve {} from {} to {} is left over: there the best ruling twists by up to {:.3} degrees",
            gap.curve + 1,
            gap.range[0],
            gap.range[1],
            gap.worst.twist.to_degrees()
        ));
    }
    Some(Raw::connecting(best.clone(), notes))
}

/// Why the best was chosen.
fn reason(found: &Connected) -> String {
    match found.reason {
        None | Some(Reason::Only) => "the only one".to_owned(),
        Some(Reason::OnlyRegular) => "the only regular one".to_owned(),
        Some(Reason::CoversMost(own, next)) => format!(
            "it uses {:.1} % of the curves, the next best {:.1} %",
            100.0 * own,
            100.0 * next
        ),
        Some(Reason::ShorterRulings(own, next)) => {
            format!("its longest ruling is {own:.4} mm, that of the next {next:.4} mm")
        }
    }
}

/// All developables, where there are several, so that each can be asked for.
fn others(found: &Connected) -> Option<String> {
    let part = |(number, branch): (usize, &Branch)| {
        let [[s0, s1], [t0, t1]] = branch.ranges();
        format!("{number}: curve 1 from {s0} to {s1}, curve 2 from {t0} to {t1}")
    };
    let list: Vec<String> = (1..).zip(&found.branches).map(part).collect();
    (list.len() > 1).then(|| format!("take another by `branch`; {}", list.join("; ")))
}

fn stretch(
    reader: &mut Reader,
    entries: &mut Entries<'_>,
    parts: &Parts,
    usual: [f64; 2],
) -> Option<[SweptEdge; 2]> {
    match (entries.take("range"), entries.take("between")) {
        (None, None) => Some(usual.map(SweptEdge::Share)),
        (Some(value), None) => {
            let place = value.span();
            let [from, to] = reader.numbers(value, [Dimension::None; 2])?;
            if from == to {
                reader.complain(
                    &place,
                    format!("[{from}, {to}] is no range"),
                    "its ends differ",
                );
                return None;
            }
            Some([from, to].map(SweptEdge::Share))
        }
        (None, Some(value)) => {
            pair(reader, value, &parts.planes).map(|planes| planes.map(SweptEdge::Cut))
        }
        (Some(value), Some(_)) => {
            reader.complain(
                &value.span(),
                "`range` and `between` exclude each other",
                "",
            );
            None
        }
    }
}

/// A surface of straight lines from a curve to its image: along a direction, or through an apex.
struct Sweep {
    /// What gives the lines: key, what is said without it, and what would be right.
    by: [&'static str; 3],
    /// Where the surface begins and ends unless the file says so.
    whole: [f64; 2],
    /// The sheet between two edges.
    sheet: fn(&Rail, Point, [SweptEdge; 2]) -> Result<Sheet, GeometryError>,
}

const CYLINDER: Sweep = Sweep {
    by: [
        "direction",
        "a cylinder lacks its `direction`",
        "a vector: `direction = [0, 0, 100]`",
    ],
    whole: [0.0, 1.0],
    sheet: Sheet::cylinder,
};

const CONE: Sweep = Sweep {
    by: [
        "apex",
        "a cone lacks its `apex`",
        "a point: `apex = [0, 0, 100]`",
    ],
    whole: [1.0, 0.0],
    sheet: Sheet::swept_cone,
};

/// The lines of a cone or a cylinder, and where they end.
struct Swept {
    lines: Point,
    edges: [SweptEdge; 2],
}

fn swept(
    reader: &mut Reader,
    entries: &mut Entries<'_>,
    parts: &Parts,
    sweep: &Sweep,
) -> Option<Swept> {
    let span = entries.span.clone();
    let [key, lacking, help] = sweep.by;
    let Some(lines) = entries.take(key) else {
        reader.complain(&span, lacking, help);
        return None;
    };
    let lines = point(reader, lines, &parts.points);
    let edges = stretch(reader, entries, parts, sweep.whole);
    Some(Swept {
        lines: lines?,
        edges: edges?,
    })
}

/// A Hermite cone between parallel planes, or cut by an oblique one.
fn hermite(
    reader: &mut Reader,
    entries: &mut Entries<'_>,
    data: &mut Entries<'_>,
    parts: &Parts,
) -> Option<Raw> {
    let span = data.span.clone();
    let degree = data.take("degree").map_or(Some(3.0), |value| {
        reader.number_in(value, Dimension::None, "{3, 4, 5}", |d| {
            [3.0, 4.0, 5.0].contains(&d)
        })
    })?;
    let tension = data.take("tension");
    let printed = data
        .take("as-printed")
        .map_or(Some(false), |value| reader.truth(value))?;
    let mut missing = |reader: &mut Reader, key: &str| {
        let value = data.take(key);
        if value.is_none() {
            let message = format!("a Hermite cone of degree {degree} lacks `{key}`");
            reader.complain(&span, message, "");
        }
        value
    };
    let ratio = missing(reader, "ratio").and_then(|value| reader.number(value, Dimension::None));
    let one = |reader: &mut Reader, value: Option<Value<'_>>| point(reader, value?, &parts.points);
    let two = |reader: &mut Reader, value: Option<Value<'_>>| -> Option<[Point; 2]> {
        let points = list(reader, value?, &parts.points, [2, 2])?;
        points.try_into().ok()
    };
    let tension = match tension {
        Some(value) => reader.numbers(value, [Dimension::None; 2])?,
        None => [1.0; 2],
    };
    let tensed = |tangents: [Point; 2]| {
        let [k1, k2] = tension;
        let [first, last] = tangents;
        [first.map(|c| k1 * c), last.map(|c| k2 * c)]
    };
    let cone = if degree == 3.0 {
        let value = missing(reader, "summit");
        let summit = one(reader, value);
        let q = missing(reader, "q").and_then(|v| list(reader, v, &parts.points, [4, 4]));
        let [from, to, first, last]: [Point; 4] = q?.try_into().ok()?;
        let [first, last] = tensed([first, last]);
        HermiteCone::cubic(summit?, ratio?, [from, to, first, last])
    } else {
        let value = missing(reader, "p-start");
        let p_start = one(reader, value);
        let value = missing(reader, "p-middle");
        let p_middle = one(reader, value);
        let value = missing(reader, "q-ends");
        let q_ends = two(reader, value);
        let value = missing(reader, "q-tangents");
        let q_tangents = two(reader, value);
        let tangent = if degree == 5.0 {
            let value = missing(reader, "p-middle-tangent");
            Some(one(reader, value)?)
        } else {
            None
        };
        let quartic = QuarticData {
            p_start: p_start?,
            p_middle: p_middle?,
            q_ends: q_ends?,
            q_tangents: tensed(q_tangents?),
        };
        match tangent {
            None => HermiteCone::quartic(ratio?, quartic),
            Some(p_middle_tangent) => HermiteCone::quintic(
                ratio?,
                QuinticData {
                    quartic,
                    p_middle_tangent,
                },
            ),
        }
    };
    let cone = accepted(reader, &span, cone)?;
    let q = accepted(reader, &span, Rail::hermite(&cone.q))?;
    if printed {
        let Some(value) = entries.take("between") else {
            reader.complain(&span, "`as-printed` needs a plane `between`", "");
            return None;
        };
        let cut = plane(reader, value, &parts.planes)?;
        let data = accepted(reader, &span, oblique_image_as_printed(&cone, &cut))?;
        let edge = accepted(reader, &span, Rail::hermite(&data))?;
        return Some(Raw::between(edge, q));
    }
    // From the curve p, the image of q in the ratio of the cone, or from the image of q in an oblique plane.
    let other = match entries.take("between") {
        Some(value) => SweptEdge::Cut(plane(reader, value, &parts.planes)?),
        None => SweptEdge::Share(1.0 / cone.ratio),
    };
    let sheet = Sheet::swept_cone(&q, cone.summit, [other, SweptEdge::Share(1.0)]);
    accepted(reader, &span, sheet.and_then(Raw::swept))
}

/// The entries `between` or `range`.
fn cutting(
    reader: &mut Reader,
    entries: &mut Entries<'_>,
    parts: &Parts,
    tangent: bool,
) -> Option<Cutting> {
    let span = entries.span.clone();
    match (entries.take("between"), entries.take("range")) {
        (Some(value), None) if !tangent => pair(reader, value, &parts.planes).map(Cutting::Between),
        (None, Some(value)) if tangent => reader
            .numbers(value, [Dimension::None; 2])
            .map(Cutting::Tangent),
        (None, Some(value)) => {
            // The parameter of eq. (3.7) goes with a x a'; the foot of the ruling is a length.
            reader
                .numbers(value, [Dimension::Length; 2])
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

fn developable(
    reader: &mut Reader,
    span: &Range<usize>,
    planes: Planes,
    cut: Cutting,
) -> Option<Raw> {
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
    Some(Raw {
        sheet,
        planes: Some(planes),
        rails: None,
        cut: Some(cut),
        notes,
    })
}

/// A patch that continues another one.
fn continuation(
    reader: &mut Reader,
    entries: &mut Entries<'_>,
    value: Value<'_>,
    parts: &Parts,
    known: &Named<Made>,
) -> Option<Raw> {
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

fn marks(reader: &mut Reader, value: Value<'_>) -> Option<Vec<Mark>> {
    let items = reader.list(value, "marks", [0, MOST_MARKS])?;
    let marks: Vec<_> = items.into_iter().map(|item| mark(reader, item)).collect();
    marks.into_iter().collect()
}

fn mark(reader: &mut Reader, value: Value<'_>) -> Option<Mark> {
    let mut entries = reader.entries(value, "a mark", keys::MARK)?;
    let span = entries.span.clone();
    if let Some(value) = entries.take("line") {
        let items = reader.list(value, "places", [2, MOST_MARKS])?;
        let places: Vec<_> = items.into_iter().map(|item| place(reader, item)).collect();
        return places.into_iter().collect::<Option<_>>().map(Mark::Line);
    }
    let length = |reader: &mut Reader, value| {
        reader.number_in(value, Dimension::Length, "(0, infinity)", |r| r > 0.0)
    };
    let at = entries.take("at").map(|value| place(reader, value));
    let (Some(at), true) = (at, entries.has("radius") != entries.has("text")) else {
        let help = "`{ line = [[u, v], ..] }`, `{ at = [u, v], radius = r }` for a hole, or \
                    `{ at = [u, v], text = \"..\", height = h }`";
        reader.complain(&span, "a mark is a line, a hole or a text", help);
        return None;
    };
    if let Some(value) = entries.take("radius") {
        let radius = length(reader, value);
        let cut = entries
            .take("hole")
            .map_or(Some(true), |value| reader.truth(value));
        return Some(match cut? {
            true => Mark::Hole(at?, radius?),
            false => Mark::Circle(at?, radius?),
        });
    }
    let (text, place) = reader.text(entries.take("text")?, "a text")?;
    if text.chars().any(char::is_control) || text.is_empty() || text.len() > 200 {
        reader.complain(&place, "a mark is one line of 1 to 200 bytes", "");
        return None;
    }
    let height = entries
        .take("height")
        .map_or(Some(5.0), |value| length(reader, value));
    let angle = entries
        .take("angle")
        .map_or(Some(0.0), |value| reader.number(value, Dimension::None));
    Some(Mark::Text(at?, text, height?, angle?.to_radians()))
}

/// A place `[u, v]` on a patch.
fn place(reader: &mut Reader, value: Value<'_>) -> Option<[f64; 2]> {
    let span = value.span();
    let [u, v] = reader.numbers(value, [Dimension::None; 2])?;
    if [u, v].iter().all(|c| (0.0..=1.0).contains(c)) {
        return Some([u, v]);
    }
    let help = "u goes from ruling to ruling, v along them, both from 0 to 1";
    reader.complain(&span, format!("[{u}, {v}] is outside the patch"), help);
    None
}
