//! One claim of the page.

use super::{Page, Prose, Text, badge};
use crate::model::{
    ClaimView, ConsequenceView, CorrectionView, FormulaView, ReadingView, Reference,
};
use crate::rests::Rests;
use crate::{Change, Stretch};
use std::fmt::{self, Write};
use torse_prove::evidence::Witness;

/// The claim as an `article`; `section` is the identifier of the section that it is in.
pub(super) fn write(
    out: &mut String,
    page: &Page<'_>,
    claim: &ClaimView,
    section: &str,
) -> fmt::Result {
    let evidence = claim.evidence.map_or("none", |term| term.key);
    let (anchor, verdict, kind) = (&claim.anchor, claim.verdict.key, claim.kind.key);
    writeln!(
        out,
        "<article id=\"{anchor}\" class=\"v-{verdict}\" tabindex=\"-1\" data-verdict=\"{verdict}\" data-kind=\"{kind}\" data-evidence=\"{evidence}\" data-section=\"{section}\">\n\
         <header><h3><a href=\"#{anchor}\"><code>{}</code></a></h3><span class=\"where\">{} · {}</span><span>{}{}</span></header>\n<dl>",
        Text(&claim.name),
        Text(&claim.at),
        claim.kind.label,
        badge(claim.verdict),
        claim.evidence.map_or(String::new(), |term| format!(
            " <span class=\"evidence\">by {}</span>",
            term.label
        )),
    )?;
    writeln!(
        out,
        "<dt>printed</dt><dd><blockquote class=\"printed\">{}</blockquote></dd>",
        Text(&claim.printed)
    )?;
    if let Some(expected) = claim.expected {
        writeln!(
            out,
            "<dt>expected</dt><dd>the derivation file expects {}</dd>",
            badge(expected)
        )?;
    }
    text(out, "read as", claim.reading.as_deref())?;
    formulas(out, page, "understood", claim.parsed.as_slice())?;
    formulas(out, page, "assuming", &claim.assumed)?;
    formulas(out, page, "condition", &claim.conditions)?;
    readings(out, page, &claim.readings)?;
    if let Some(repair) = &claim.correction {
        correction(out, page, repair)?;
    }
    if !claim.data.is_empty() {
        let data = claim.data.join("; ");
        writeln!(out, "<dt>right if</dt><dd>{}.</dd>", Prose(&data))?;
    }
    formulas(out, page, "derived", claim.derived.as_slice())?;
    formulas(out, page, "difference", claim.difference.as_slice())?;
    if let Some(found) = &claim.witness {
        witness(out, found, claim.denied.as_deref())?;
    }
    if !claim.steps.is_empty() {
        let steps = claim.steps.join("; ");
        writeln!(
            out,
            "<dt>steps</dt><dd class=\"steps\">{}.</dd>",
            Prose(&steps)
        )?;
    }
    text(out, "found", claim.finding.as_deref())?;
    text(out, "copy at hand", claim.garbled.as_deref())?;
    text(out, "note", claim.note.as_deref())?;
    rests(out, &claim.rests)?;
    references(out, "rests on", &claim.uses)?;
    references(out, "used by", &claim.used_by)?;
    consequences(out, &claim.consequences, claim.distant_survivors.as_deref())?;
    if !claim.see_figures.is_empty() {
        out.push_str("<dt>see</dt><dd>");
        for (position, figure) in claim
            .see_figures
            .iter()
            .map(|position| position + 1)
            .enumerate()
        {
            let comma = if position > 0 { ", " } else { "" };
            write!(
                out,
                "{comma}<a href=\"#figure-{figure}\">Figure {figure}</a>"
            )?;
        }
        out.push_str("</dd>\n");
    }
    writeln!(
        out,
        "<dt>reproduce</dt><dd><code>{}</code></dd>\n</dl>",
        Text(&claim.command)
    )?;
    for figure in &claim.figures {
        page.figure(out, *figure)?;
    }
    out.push_str("</article>\n");
    Ok(())
}

fn text(out: &mut String, name: &str, text: Option<&str>) -> fmt::Result {
    match text {
        Some(text) => writeln!(out, "<dt>{name}</dt><dd>{}</dd>", Prose(text)),
        None => Ok(()),
    }
}

fn formulas(
    out: &mut String,
    page: &Page<'_>,
    name: &str,
    formulas: &[FormulaView],
) -> fmt::Result {
    if formulas.is_empty() {
        return Ok(());
    }
    write!(out, "<dt>{name}</dt><dd>")?;
    for formula in formulas {
        page.formula(out, formula)?;
    }
    out.push_str("</dd>\n");
    Ok(())
}

/// What the sentence may mean, and what is true of each.
fn readings(out: &mut String, page: &Page<'_>, readings: &[ReadingView]) -> fmt::Result {
    for reading in readings {
        writeln!(
            out,
            "<dt>read as</dt><dd class=\"reading\"><p><em>{}</em>: {} {}</p>",
            Text(&reading.name),
            Prose(&reading.says),
            badge(reading.verdict)
        )?;
        for formula in reading.parsed.iter() {
            page.formula(out, formula)?;
        }
        for (label, list) in [("assuming", &reading.assumed), ("if", &reading.conditions)] {
            for formula in list {
                write!(out, "{label} ")?;
                page.formula(out, formula)?;
            }
        }
        if let Some(point) = &reading.fails_at {
            write!(out, "<p>{}.</p>", Prose(point))?;
        }
        small_print(out, &reading.rests)?;
        out.push_str("</dd>\n");
    }
    Ok(())
}

/// What the statement rests on.
fn rests(out: &mut String, groups: &[Rests]) -> fmt::Result {
    if groups.is_empty() {
        return Ok(());
    }
    out.push_str("<dt>understood with</dt><dd>");
    small_print(out, groups)?;
    out.push_str("</dd>\n");
    Ok(())
}

fn small_print(out: &mut String, groups: &[Rests]) -> fmt::Result {
    if groups.is_empty() {
        return Ok(());
    }
    out.push_str("<div class=\"rests\">");
    for Rests { label, lines } in groups {
        write!(out, "<p>{label} ")?;
        for (position, line) in lines.iter().enumerate() {
            let separator = if position > 0 { "; " } else { "" };
            write!(out, "{separator}<code>{}</code>", Text(line))?;
        }
        out.push_str("</p>");
    }
    out.push_str("</div>");
    Ok(())
}

fn correction(out: &mut String, page: &Page<'_>, repair: &CorrectionView) -> fmt::Result {
    out.push_str("<dt>corrected</dt><dd class=\"corrected\">");
    page.formula(out, &repair.statement)?;
    out.push_str("<p class=\"marked\"><code>");
    for Stretch { change, text } in &repair.marked {
        match change {
            Change::Kept => write!(out, "{}", Text(text))?,
            Change::Removed => write!(out, "<del>{}</del>", Text(text))?,
            Change::Added => write!(out, "<ins>{}</ins>", Text(text))?,
        }
    }
    let others = if repair.unique {
        "No other repair as small was found."
    } else {
        "Other repairs as small exist."
    };
    writeln!(
        out,
        "</code></p><p><strong>Changed:</strong> {}. {others}</p></dd>",
        Prose(&repair.edits.join("; "))
    )
}

fn witness(out: &mut String, witness: &Witness, denied: Option<&str>) -> fmt::Result {
    out.push_str("<dt>witness</dt><dd class=\"scroll\" tabindex=\"0\">");
    if let Some(denied) = denied {
        write!(out, "<p>{}, for instance:</p>", Text(denied))?;
    }
    out.push_str("<table class=\"witness\"><thead><tr><td></td><th scope=\"col\">exact</th><th scope=\"col\">enclosed by</th></tr></thead><tbody>");
    for (name, value) in &witness.at {
        write!(
            out,
            "<tr><th scope=\"row\"><code>{}</code></th><td><code>{}</code></td><td></td></tr>",
            Text(name),
            Text(value)
        )?;
    }
    let left = (&witness.left, &witness.left_decimal);
    let right = (&witness.right, &witness.right_decimal);
    let sides = match left == right {
        true => vec![("equal sides", left)],
        false => vec![("left side", left), ("right side", right)],
    };
    for (name, (exact, decimal)) in sides {
        write!(
            out,
            "<tr><th scope=\"row\">{name}</th><td><code>{}</code></td><td><code>{}</code></td></tr>",
            Text(exact),
            Text(decimal)
        )?;
    }
    out.push_str("</tbody></table></dd>\n");
    Ok(())
}

/// What rests on a refuted claim, and whether it survives.
fn consequences(
    out: &mut String,
    consequences: &[ConsequenceView],
    distant_survivors: Option<&str>,
) -> fmt::Result {
    if consequences.is_empty() {
        return Ok(());
    }
    out.push_str("<dt>rests on it</dt><dd><ul class=\"consequences\">");
    for consequence in consequences {
        out.push_str("<li>");
        mention(out, &consequence.claim)?;
        write!(out, " {}", consequence.fate)?;
        if let Some(through) = &consequence.through {
            out.push_str(" (rests on ");
            mention(out, through)?;
            out.push(')');
        }
        out.push_str("</li>");
    }
    if let Some(words) = distant_survivors {
        write!(out, "<li>{words}</li>")?;
    }
    out.push_str("</ul></dd>\n");
    Ok(())
}

fn references(out: &mut String, name: &str, references: &[Reference]) -> fmt::Result {
    if references.is_empty() {
        return Ok(());
    }
    write!(out, "<dt>{name}</dt><dd>")?;
    for (position, reference) in references.iter().enumerate() {
        if position > 0 {
            out.push_str(", ");
        }
        mention(out, reference)?;
    }
    out.push_str("</dd>\n");
    Ok(())
}

/// The name of a claim, a link where the page has it.
fn mention(out: &mut String, reference: &Reference) -> fmt::Result {
    let shown = Text(&reference.shown);
    match &reference.anchor {
        Some(anchor) => write!(out, "<a href=\"#{anchor}\"><code>{shown}</code></a>"),
        None => write!(out, "<code>{shown}</code>"),
    }
}
