//! Developables between two free curves: one of several, or a whole panel.

use super::direction::{DirectedSheets, directed};
use super::raw::{MadePatches, UntrimmedSurface, trimmed};
use crate::design::{Mark, Smoothness};
use crate::file::pieces::{PatchIntervals, distributed, is_closed};
use crate::file::reader::Reader;
use crate::numbers::without_trailing_zeros;
use std::ops::Range;
use torse_geometry::developable::Branch;
use torse_geometry::prelude::{
    BranchReason, ConnectedSheets, GeometryError, Panel, PanelKind, PanelPiece, Panels,
    PiecewiseRail, Rail,
};

/// Returns whether both curves are closed, or one of them has several pieces: then a whole panel is meant.
pub(super) fn is_whole(pair: &[PiecewiseRail; 2]) -> Result<bool, GeometryError> {
    if pair.iter().any(|curve| curve.count() > 1) {
        return Ok(true);
    }
    Ok(is_closed(&pair[0])? && is_closed(&pair[1])?)
}

/// Returns the panels that were found, or why there are none.
pub(super) fn paneled<'p>(
    reader: &mut Reader,
    place: &Range<usize>,
    pair: &[PiecewiseRail; 2],
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
            let ranges: Vec<[[f64; 2]; 2]> = cells.iter().map(|c| [c.s, c.t]).take(2).collect();
            let more = match cells.len().saturating_sub(ranges.len()) {
                0 => String::new(),
                count => format!("; and {count} more"),
            };
            let remedy = if meet_at_an_end(pair) {
                "rulings shrink to a point where both curves start or end in one, and whole panels are not decided there: \
                 leave `panel` away, or use `ruled`"
            } else {
                "split both curves where their tangents are parallel, and connect piece by piece"
            };
            let help = format!("{remedy}; undecided are {}{more}", listed(&ranges));
            reader.complain(place, "no whole panel was found between the curves", &help);
        }
    }
    None
}

/// Returns whether two curves start or end in one point.
fn meet_at_an_end([first, second]: &[PiecewiseRail; 2]) -> bool {
    [0.0, 1.0].into_iter().any(|end| {
        let points = (first.point(end), second.point(end));
        matches!(points, (Ok(a), Ok(b)) if a == b)
    })
}

/// Returns the patches of a panel.
pub(super) fn assembled(
    reader: &mut Reader,
    (name, span): (&str, &Range<usize>),
    panel: &Panel,
    all: &[Panel],
    (number, marks): (usize, Vec<Mark>),
) -> Option<MadePatches> {
    let cells = PatchIntervals::of_panel(panel);
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
        let raw = UntrimmedSurface::connecting(piece.sheet.clone(), notes);
        patches.push(trimmed(
            reader,
            span,
            (name, "connect"),
            raw,
            ([0.0, 1.0], marks),
        )?);
    }
    Some(MadePatches {
        patches,
        closed: several && panel.closed,
        continuity: (panel.folds == 0).then_some(Smoothness::G1),
        cut: None,
        cover: None,
    })
}

/// Returns what is said of a panel as a whole.
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
        text.push_str(&format!(
            ", {} folds: for fewer, split both curves where their tangents are parallel, and connect piece by piece",
            panel.folds
        ));
    }
    if panel.turned {
        text.push_str("; curve 2 runs against curve 1: it is passed from its end to its start");
    }
    text
}

/// Returns a parameter with nine decimals at most: typed back, it is less than a micrometre off on a curve of a
/// kilometre.
fn parameter(value: f64) -> String {
    without_trailing_zeros(&format!("{value:.9}"))
}

/// Returns what part of the curves a piece of a panel takes.
pub(super) fn extent(piece: &PanelPiece) -> String {
    let [[s0, s1], [t0, t1]] = piece.ranges.map(|range| range.map(parameter));
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

/// Returns a developable that touches two free curves: the one of this number, or the best.
pub(super) fn connected(
    reader: &mut Reader,
    place: &Range<usize>,
    pair: [&Rail; 2],
    branch: Option<(usize, Range<usize>)>,
) -> Option<UntrimmedSurface> {
    let DirectedSheets {
        taken: found,
        other,
        other_is_regular,
        turned,
    } = directed(reader, place, pair)?;
    let mut notes: Vec<String> = turned.into_iter().collect();
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
    let more = other.as_ref().map_or(0, |other| other.sheets.len());
    if let Some((number, place)) = branch {
        // Behind those of the direction that is taken come those of the other.
        let beyond = other.iter().flat_map(|other| &other.sheets);
        let mut all = found.sheets.iter().chain(beyond);
        let Some(sheet) = number.checked_sub(1).and_then(|index| all.nth(index)) else {
            let message = format!("there is no developable {number} between the curves");
            let help = format!("`branch` is from 1 to {}", count + more);
            reader.complain(&place, message, &help);
            return None;
        };
        if number > count {
            notes.clear();
            notes.push(format!(
                "the developable {number}: one of {more} with curve 2 the other way round"
            ));
            return Some(UntrimmedSurface::connecting(sheet.clone(), notes));
        }
        notes.push(format!(
            "the developable {number} of {count} that touch both curves"
        ));
        notes.extend(others(&found));
        return Some(UntrimmedSurface::connecting(sheet.clone(), notes));
    }
    notes.push(match count {
        1 => "one developable touches both curves".to_owned(),
        _ => format!(
            "of {count} developables that touch both curves: {}",
            reason(&found)
        ),
    });
    notes.extend(others(&found));
    if other_is_regular {
        let first = count + 1;
        notes.push(format!(
            "with curve 2 the other way round there is a regular developable too: `branch = {first}`{}",
            if more > 1 { " and on" } else { "" }
        ));
    }
    if !found.gaps.is_empty() {
        notes.push(
            "`panel = 1` goes on over the rest with fans, where there is a whole panel".to_owned(),
        );
    }
    for gap in &found.gaps {
        notes.push(format!(
            "curve {} from {} to {} is left over: there the best ruling twists by up to {:.3} degrees",
            gap.curve + 1,
            parameter(gap.range[0]),
            parameter(gap.range[1]),
            gap.worst.twist.to_degrees()
        ));
    }
    Some(UntrimmedSurface::connecting(best.clone(), notes))
}

/// Returns why the best was chosen.
fn reason(found: &ConnectedSheets) -> String {
    match found.reason {
        None | Some(BranchReason::Only) => "the only one".to_owned(),
        Some(BranchReason::OnlyRegular) => "the only regular one".to_owned(),
        Some(BranchReason::CoversMost(own, next)) => format!(
            "it uses {:.1} % of the curves, the next best {:.1} %",
            100.0 * own,
            100.0 * next
        ),
        Some(BranchReason::ShorterRulings(own, next)) => {
            format!("its longest ruling is {own:.4} mm, that of the next {next:.4} mm")
        }
    }
}

/// Returns all developables, where there are several, so that each can be asked for.
fn others(found: &ConnectedSheets) -> Option<String> {
    let part = |(number, branch): (usize, &Branch)| {
        let [[s0, s1], [t0, t1]] = branch.ranges().map(|range| range.map(parameter));
        format!("{number}: curve 1 from {s0} to {s1}, curve 2 from {t0} to {t1}")
    };
    let list: Vec<String> = (1..).zip(&found.branches).map(part).collect();
    (list.len() > 1).then(|| format!("take another by `branch`; {}", list.join("; ")))
}
