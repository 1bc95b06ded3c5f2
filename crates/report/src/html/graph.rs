//! The graph of dependencies: claims that use each other, with colour and mark of the verdict.
//!
//! The column of a claim is the length of its longest chain of dependencies; within a column, claims have the order of
//! the paper. Every claim is a link, so the keyboard reaches all of them; pointing at one highlights what it depends on
//! and what depends on it.

use super::text::Text;
use crate::model::{ClaimView, Report};
use std::collections::BTreeMap;
use std::fmt::{self, Write};

const WIDTH: usize = 132;
const HEIGHT: usize = 17;
const GAP: usize = 46;

/// A claim with its place in the drawing.
struct Placed<'a> {
    claim: &'a ClaimView,
    column: usize,
    row: usize,
}

/// Writes the graph; empty if no claim of the paper uses another.
pub(super) fn write(out: &mut String, report: &Report) -> fmt::Result {
    let placed = placed(report);
    if placed.len() < 2 {
        return Ok(());
    }
    let columns = placed.values().map(|own| own.column + 1).max().unwrap_or(1);
    let rows = placed.values().map(|own| own.row + 1).max().unwrap_or(1);
    let (width, height) = (columns * (WIDTH + GAP), rows * (HEIGHT + 3) + 4);
    write!(
        out,
        "<details class=\"more\" id=\"graph\"><summary><h2>Dependencies</h2></summary>\n\
         <p class=\"meta\">Each claim stands to the right of the claims that it depends on. A line from a false statement has its colour. Point at a claim to see its own lines alone.</p>\n\
         <div class=\"scroll\" tabindex=\"0\"><svg class=\"graph\" role=\"group\" aria-label=\"The claims, each a link, with lines to those that they depend on\" viewBox=\"0 0 {width} {height}\" width=\"{width}\" height=\"{height}\">\n<g>"
    )?;
    for to in placed.values() {
        for used in &to.claim.uses {
            let Some(from) = used.anchor.as_deref().and_then(|anchor| placed.get(anchor)) else {
                continue;
            };
            let (x0, y0) = (left_edge(from) + WIDTH, vertical_middle(from));
            let (x1, y1) = (left_edge(to), vertical_middle(to));
            let bend = (x0 + x1) / 2;
            let broken = matches!(from.claim.verdict.key, "false" | "misprint");
            let class = if broken { " class=\"broken\"" } else { "" };
            write!(
                out,
                "<path{class} data-a=\"{}\" data-b=\"{}\" d=\"M{x0} {y0}C{bend} {y0} {bend} {y1} {x1} {y1}\"/>",
                from.claim.anchor, to.claim.anchor
            )?;
        }
    }
    out.push_str("</g>\n");
    for of in placed.values() {
        let (x, y) = (left_edge(of), vertical_middle(of) - HEIGHT / 2);
        let claim = of.claim;
        writeln!(
            out,
            "<a href=\"#{anchor}\" data-claim=\"{anchor}\" class=\"v-{verdict}\"><title>{name}: {label}</title>\
             <rect x=\"{x}\" y=\"{y}\" width=\"{WIDTH}\" height=\"{HEIGHT}\" rx=\"3\"/>\
             <text x=\"{}\" y=\"{}\">{} {name}</text></a>",
            x + 5,
            y + 12,
            mark(claim.verdict.key),
            anchor = claim.anchor,
            verdict = claim.verdict.key,
            name = Text(&shortened(&claim.name)),
            label = claim.verdict.label,
        )?;
    }
    out.push_str("</svg></div></details>\n");
    Ok(())
}

fn left_edge(claim: &Placed<'_>) -> usize {
    claim.column * (WIDTH + GAP)
}

fn vertical_middle(claim: &Placed<'_>) -> usize {
    claim.row * (HEIGHT + 3) + HEIGHT / 2 + 3
}

fn shortened(name: &str) -> String {
    const MAX_NAME_CHARS: usize = 19;
    match name.char_indices().nth(MAX_NAME_CHARS) {
        Some((end, _)) => format!("{}…", name.get(..end).unwrap_or(name)),
        None => name.to_owned(),
    }
}

fn mark(verdict: &str) -> &'static str {
    match verdict {
        "holds" | "reproduced" => "✓",
        "conditional" => "∧",
        "misprint" => "≠",
        "false" => "×",
        "depends" | "undecided" => "?",
        _ => "·",
    }
}

/// Returns the claims that use another or are used, by their identifiers for links.
fn placed(report: &Report) -> BTreeMap<&str, Placed<'_>> {
    let uses: BTreeMap<&str, Vec<&str>> = report
        .claims()
        .map(|claim| {
            let anchors = claim.uses.iter().filter_map(|own| own.anchor.as_deref());
            (claim.anchor.as_str(), anchors.collect())
        })
        .collect();
    let mut columns: BTreeMap<&str, usize> = BTreeMap::new();
    // The number of claims bounds the rounds: a cycle of claims would never end.
    for _ in 0..uses.len() {
        let mut changed = false;
        for (claim, used) in &uses {
            let column = used
                .iter()
                .map(|own| columns.get(own).copied().unwrap_or(0) + 1)
                .max();
            let column = column.unwrap_or(0).min(uses.len());
            changed |= columns.insert(claim, column) != Some(column);
        }
        if !changed {
            break;
        }
    }
    let mut rows: BTreeMap<usize, usize> = BTreeMap::new();
    let mut list = BTreeMap::new();
    for claim in report.claims() {
        let anchor = claim.anchor.as_str();
        let alone = uses.get(anchor).is_none_or(Vec::is_empty)
            && !uses.values().flatten().any(|used| *used == anchor);
        if alone {
            continue;
        }
        let column = columns.get(anchor).copied().unwrap_or(0);
        let row = rows.entry(column).or_insert(0);
        list.insert(
            anchor,
            Placed {
                claim,
                column,
                row: *row,
            },
        );
        *row += 1;
    }
    list
}
