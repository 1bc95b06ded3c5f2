//! One claim of the page.

use super::Page;
use super::pack::Pack;
use super::text::{Code, Listed, Sentence, Text, badge, formula};
use crate::glossary;
use crate::model::{
    ClaimView, ConsequenceView, CorrectionView, FormulaView, ReadingView, Reference, RestsView,
    WitnessView,
};
use std::fmt::{self, Write};
use torse_typography::Prose;

/// Writes the claim as an `article`, closed at first; `section` is the identifier of its section.
pub(super) fn write(
    out: &mut String,
    page: &Page<'_>,
    claim: &ClaimView,
    section: &str,
    pack: &mut Pack,
) -> fmt::Result {
    let mut inside = String::new();
    write_inside(&mut inside, page, claim)?;
    let number = pack.add(inside);
    let evidence = claim.evidence.map_or("none", |term| term.key);
    let (anchor, verdict, kind) = (&claim.anchor, claim.verdict.key, claim.kind.key);
    writeln!(
        out,
        "<article id=\"{anchor}\" class=\"v-{verdict}\" tabindex=\"-1\" data-verdict=\"{verdict}\" data-kind=\"{kind}\" data-evidence=\"{evidence}\" data-section=\"{section}\">\n\
         <details data-inside=\"{number}\"><summary><h3><code>{}</code></h3><span class=\"where\">{} · {}</span><span class=\"answer\">{}",
        Text(&claim.name),
        Text(&claim.at),
        claim.kind.label,
        badge(claim.verdict),
    )?;
    if let Some(term) = claim.evidence {
        write!(
            out,
            " <span class=\"evidence\" data-word=\"{}\">by {}</span>",
            term.key, term.label
        )?;
    }
    if let Some(term) = claim.level.filter(|level| *level != glossary::DECIDED) {
        write!(
            out,
            " <span class=\"evidence\" data-word=\"{}\">· {}</span>",
            term.key, term.label
        )?;
    }
    out.push_str("</span><span class=\"statement\">");
    // The page shows what is printed; it says of the words that are not.
    if claim.words_of != glossary::PRINTED {
        write!(out, "<span class=\"whose\">{}</span>", claim.words_of)?;
    }
    write!(out, "{}</span>", Sentence(&claim.printed))?;
    let findings = page.report.findings.iter();
    if let Some(finding) = { findings }.find(|finding| finding.anchor == claim.anchor) {
        let text = Sentence(&finding.text);
        write!(out, "<span class=\"finding\">{text}</span>")?;
    }
    writeln!(
        out,
        "</summary>\n<a class=\"permalink\" href=\"#{anchor}\" aria-label=\"Link to {}\">link</a></details></article>",
        Text(&claim.name),
    )
}

/// The parts that the script inserts into an open claim: the rest of the list, then its figures.
fn write_inside(out: &mut String, page: &Page<'_>, claim: &ClaimView) -> fmt::Result {
    out.push_str("<dl>");
    if let Some(expected) = claim.expected {
        writeln!(
            out,
            "<dt>expected</dt><dd>the derivation file expects {}</dd>",
            badge(expected)
        )?;
    }
    text(out, "found", claim.finding.as_ref())?;
    text(out, "read as", claim.reading.as_ref())?;
    formulas(out, "understood", claim.parsed.as_slice())?;
    formulas(out, "assuming", &claim.assumed)?;
    formulas(out, "condition", &claim.conditions)?;
    readings(out, &claim.readings)?;
    if let Some(repair) = &claim.correction {
        out.push_str("<dt>corrected</dt><dd class=\"corrected\">");
        correction(out, repair)?;
        out.push_str("</dd>\n");
    }
    if !claim.data.is_empty() {
        writeln!(out, "<dt>right if</dt><dd>{}.</dd>", Listed(&claim.data))?;
    }
    formulas(out, "derived", claim.derived.as_slice())?;
    formulas(out, "difference", claim.difference.as_slice())?;
    if let Some(found) = &claim.witness {
        witness(out, found, claim.denied.as_ref())?;
    }
    if !claim.steps.is_empty() {
        let steps = Listed(&claim.steps);
        writeln!(out, "<dt>steps</dt><dd class=\"steps\">{steps}.</dd>")?;
    }
    text(out, "copy at hand", claim.garbled.as_ref())?;
    text(out, "note", claim.note.as_ref())?;
    dependency_groups(out, &claim.rests)?;
    references(out, "rests on", &claim.uses)?;
    references(out, "used by", &claim.used_by)?;
    consequences(out, &claim.consequences, claim.distant_survivors.as_deref())?;
    if !claim.see_figures.is_empty() {
        out.push_str("<dt>see</dt><dd>");
        let figures = claim.see_figures.iter();
        let figures = figures.filter_map(|position| page.report.figures.get(*position));
        for (position, figure) in figures.enumerate() {
            let comma = if position > 0 { ", " } else { "" };
            let (anchor, number) = (&figure.anchor, Text(&figure.number));
            write!(out, "{comma}<a href=\"#{anchor}\">Figure {number}</a>")?;
        }
        out.push_str("</dd>\n");
    }
    writeln!(
        out,
        "<dt>reproduce</dt><dd>{}</dd>\n</dl>",
        Code(&claim.command)
    )?;
    for figure in &claim.figures {
        page.figure(out, *figure)?;
    }
    Ok(())
}

fn text(out: &mut String, name: &str, text: Option<&Prose>) -> fmt::Result {
    match text {
        Some(text) => writeln!(out, "<dt>{name}</dt><dd>{}</dd>", Sentence(text)),
        None => Ok(()),
    }
}

fn formulas(out: &mut String, name: &str, formulas: &[FormulaView]) -> fmt::Result {
    if formulas.is_empty() {
        return Ok(());
    }
    write!(out, "<dt>{name}</dt><dd>")?;
    for view in formulas {
        formula(out, view)?;
    }
    out.push_str("</dd>\n");
    Ok(())
}

/// The readings of the sentence, with a verdict each.
fn readings(out: &mut String, readings: &[ReadingView]) -> fmt::Result {
    for reading in readings {
        writeln!(
            out,
            "<dt>read as</dt><dd class=\"reading\"><p><em>{}</em>: {} {}</p>",
            Sentence(&reading.name),
            Sentence(&reading.says),
            badge(reading.verdict)
        )?;
        for view in reading.parsed.iter() {
            formula(out, view)?;
        }
        for (label, list) in [("assuming", &reading.assumed), ("if", &reading.conditions)] {
            for view in list {
                write!(out, "{label} ")?;
                formula(out, view)?;
            }
        }
        if let Some(point) = &reading.fails_at {
            write!(out, "<p>It is refuted: {}.</p>", Sentence(point))?;
        }
        small_print(out, &reading.rests)?;
        out.push_str("</dd>\n");
    }
    Ok(())
}

/// The dependencies of the statement.
fn dependency_groups(out: &mut String, groups: &[RestsView]) -> fmt::Result {
    if groups.is_empty() {
        return Ok(());
    }
    out.push_str("<dt>understood with</dt><dd>");
    small_print(out, groups)?;
    out.push_str("</dd>\n");
    Ok(())
}

fn small_print(out: &mut String, groups: &[RestsView]) -> fmt::Result {
    if groups.is_empty() {
        return Ok(());
    }
    out.push_str("<div class=\"rests\">");
    for RestsView { label, lines } in groups {
        write!(out, "<p>{label} ")?;
        write!(out, "{}</p>", Listed(lines))?;
    }
    out.push_str("</div>");
    Ok(())
}

/// The printed statement beside the corrected one, stacked on a narrow page.
pub(super) fn correction(out: &mut String, repair: &CorrectionView) -> fmt::Result {
    out.push_str("<div class=\"sides\">");
    if let Some(printed) = &repair.printed {
        out.push_str("<div><span class=\"side\">as printed</span>");
        formula(out, printed)?;
        out.push_str("</div>");
    }
    out.push_str("<div><span class=\"side\">should read</span>");
    formula(out, &repair.statement)?;
    let others = match repair.unique {
        true => "No other correction as small was found.",
        false => "Other corrections as small exist.",
    };
    write!(
        out,
        "</div></div><p><strong>Changed:</strong> {}. {others}</p>",
        Listed(&repair.edits)
    )
}

fn witness(out: &mut String, witness: &WitnessView, denied: Option<&Prose>) -> fmt::Result {
    out.push_str("<dt>witness</dt><dd class=\"scroll\" tabindex=\"0\">");
    if let Some(denied) = denied {
        write!(out, "<p>{}, for instance:</p>", Sentence(denied))?;
    }
    if !witness.at.is_empty() {
        out.push_str("<ul class=\"point\">");
        for equation in &witness.at {
            write!(out, "<li>{}</li>", Sentence(equation))?;
        }
        out.push_str("</ul>");
    }
    let decimals = witness.sides.iter().any(|side| !side.decimal.is_empty());
    out.push_str("<table class=\"witness\">");
    if decimals {
        out.push_str("<thead><tr><td></td><th scope=\"col\">exact</th><th scope=\"col\">decimal</th></tr></thead>");
    }
    out.push_str("<tbody>");
    for side in &witness.sides {
        let (label, exact) = (side.label, Sentence(&side.exact));
        write!(out, "<tr><th scope=\"row\">{label}</th><td>{exact}</td>")?;
        if decimals {
            write!(out, "<td>{}</td>", Text(&side.decimal))?;
        }
        out.push_str("</tr>");
    }
    out.push_str("</tbody></table></dd>\n");
    Ok(())
}

/// The dependents of a refuted claim, and whether they survive.
fn consequences(
    out: &mut String,
    consequences: &[ConsequenceView],
    distant_survivors: Option<&str>,
) -> fmt::Result {
    if consequences.is_empty() {
        return Ok(());
    }
    out.push_str("<dt>depends on it</dt><dd><ul class=\"consequences\">");
    for consequence in consequences {
        out.push_str("<li>");
        mention(out, &consequence.claim)?;
        write!(out, " {}", Sentence(&consequence.fate))?;
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

/// The name of a claim, linked if it is on the page.
fn mention(out: &mut String, reference: &Reference) -> fmt::Result {
    let shown = Text(&reference.shown);
    match &reference.anchor {
        Some(anchor) => write!(out, "<a href=\"#{anchor}\"><code>{shown}</code></a>"),
        None => write!(out, "<code>{shown}</code>"),
    }
}
