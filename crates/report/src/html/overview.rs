//! The head of the page, with what a reader must know in a minute and the corrections, and its end: conditions, counts,
//! meanings of words.

use super::claim::correction;
use super::pack::Pack;
use super::text::{Sentence, Text, badge, formula};
use crate::Tally;
use crate::applicability::{NamedResult, Usability};
use crate::corrections::Corrected;
use crate::erratum::PARTS;
use crate::findings::Finding;
use crate::glossary::{self, DECIDED, EVIDENCE, KERNEL, NETTED, RULES, VERDICTS};
use crate::model::Report;
use std::fmt::{self, Write};
use torse_typography::Prose;

/// Writes the other forms of the report, how many statements have which verdict, and the parts of the page.
pub(super) fn write_head(out: &mut String, report: &Report) -> fmt::Result {
    let slug = Text(&report.slug);
    let all = match report.has_neighbours {
        true => {
            " · <a href=\"verdicts.json\">verdicts for programs</a> · <a href=\"index.html\">all papers</a>"
        }
        false => "",
    };
    writeln!(
        out,
        "<p class=\"meta\"><a href=\"{slug}.pdf\">PDF</a> · <a href=\"{slug}-erratum.pdf\">letter of corrections</a> · \
         <a href=\"#colophon\">sources</a>{all}</p>"
    )?;
    bar(out, &report.tally)?;
    out.push_str("<p class=\"legend\">");
    for row in &report.tally.rows {
        write!(out, "<span>{} {}</span> ", badge(row.verdict), row.count)?;
    }
    out.push_str(
        "</p>\n<nav class=\"depths\" aria-label=\"Parts\"><a href=\"#in-short\">In short</a> ",
    );
    if !report.constructions.is_empty() {
        out.push_str("<a href=\"#usable\">Can I use this paper?</a> ");
    }
    out.push_str(
        "<a href=\"#corrections\">Corrections</a> <a href=\"#every-claim\">Every claim</a> \
         <a href=\"#words\">What the words mean</a></nav>\n",
    );
    Ok(())
}

/// Writes the summary, whether the paper can be used, and the corrections; `moving` are the positions of the figures
/// that can be moved.
pub(super) fn write(out: &mut String, report: &Report, moving: &[usize]) -> fmt::Result {
    if report.unexpected > 0 {
        writeln!(
            out,
            "<p><strong>Verdicts that differ from what the derivation file expects: {}.</strong></p>",
            report.unexpected
        )?;
    }
    in_short(out, report)?;
    interactive(out, report, moving)?;
    usable(out, &report.constructions)?;
    corrections(out, report)?;
    // What is false is among the corrections, unless a file has put its fault among the conditions.
    let is_told = |finding: &Finding| {
        let mut faults = report.corrections.iter().chain(&report.questions);
        matches!(finding.verdict.key, "false" | "misprint")
            && faults.any(|fault| fault.shows_at(&finding.anchor))
    };
    let others = report.findings.iter().filter(|finding| !is_told(finding));
    let others: Vec<&Finding> = others.collect();
    findings(out, &others)
}

fn in_short(out: &mut String, report: &Report) -> fmt::Result {
    let short = &report.short;
    writeln!(
        out,
        "<section id=\"in-short\" class=\"short\"><h2>In short</h2>\n<p>{}</p>\n<ol>",
        Text(&short.counts)
    )?;
    for (point, number) in short.points.iter().zip(1..) {
        write!(
            out,
            "<li><a href=\"#correction-{number}\"><strong>{}</strong></a>: {} <span class=\"meta\">{}</span>",
            Sentence(&point.heading),
            Sentence(&point.text),
            Text(&point.consequence),
        )?;
        if let Some(reads) = &point.reads {
            write!(
                out,
                "<p class=\"meta\">should read</p><blockquote>{}</blockquote>",
                Sentence(reads)
            )?;
        }
        if let Some(view) = &point.formula {
            write!(
                out,
                "<div class=\"display\"><span class=\"side\">{}</span>",
                point.label
            )?;
            formula(out, view)?;
            out.push_str("</div>");
        }
        out.push_str("</li>\n");
    }
    out.push_str("</ol>\n");
    if let Some(rest) = &short.rest {
        writeln!(
            out,
            "<p>{rest} All are under <a href=\"#corrections\">Corrections</a>.</p>"
        )?;
    }
    out.push_str("</section>\n");
    Ok(())
}

/// Links to the figures that can be moved, which stand inside of claims.
fn interactive(out: &mut String, report: &Report, moving: &[usize]) -> fmt::Result {
    if moving.is_empty() {
        return Ok(());
    }
    out.push_str("<p id=\"moving\"><strong>Interactive figures</strong>, to turn, to change by sliders, and to unroll where the surface is developable: ");
    let figures = moving
        .iter()
        .filter_map(|position| report.figures.get(*position));
    for (number, figure) in figures.enumerate() {
        let comma = if number > 0 { ", " } else { "" };
        write!(
            out,
            "{comma}<a href=\"#{}\">{}</a>",
            figure.anchor,
            Text(&figure.number)
        )?;
    }
    out.push_str(".</p>\n");
    Ok(())
}

fn usable(out: &mut String, constructions: &[NamedResult]) -> fmt::Result {
    if constructions.is_empty() {
        return Ok(());
    }
    out.push_str("<h2 id=\"usable\">Can I use this paper?</h2>\n<table class=\"usable\"><tbody>\n");
    for answer in Usability::ALL {
        let group: Vec<&NamedResult> = constructions
            .iter()
            .filter(|own| own.answer == answer)
            .collect();
        write!(out, "<tr><th scope=\"row\">{}</th><td>", answer.label())?;
        if group.is_empty() {
            out.push_str("<span class=\"meta\">none</span>");
        }
        for (number, of) in group.iter().enumerate() {
            let comma = if number > 0 { ", " } else { "" };
            write!(
                out,
                "{comma}<a href=\"#{}\">{}</a>",
                of.anchor,
                Text(&of.name)
            )?;
            if matches!(answer, Usability::Corrected | Usability::Not) {
                out.push_str(" <span class=\"meta\">(");
                for (number, because) in of.because.iter().enumerate() {
                    let comma = if number > 0 { ", " } else { "" };
                    let (anchor, name) = (&because.anchor, Text(&because.name));
                    write!(out, "{comma}<a href=\"#{anchor}\"><code>{name}</code></a>")?;
                }
                out.push_str(")</span>");
            }
        }
        out.push_str("</td></tr>\n");
    }
    out.push_str("</tbody></table>\n");
    Ok(())
}

fn corrections(out: &mut String, report: &Report) -> fmt::Result {
    out.push_str("<section id=\"corrections\" class=\"corrections\"><h2>Corrections</h2>\n");
    match report.corrections.is_empty() {
        true => out.push_str("<p>No statement was found false as printed.</p>\n"),
        false => {
            out.push_str(
                "<p>The faults of the letter, in its order: the most consequential first. Changes are framed.</p>\n",
            );
            faults(out, "correction", &report.corrections)?;
        }
    }
    if !report.questions.is_empty() {
        writeln!(out, "<h3>{}</h3>", PARTS[2])?;
        faults(out, "question", &report.questions)?;
    }
    out.push_str("</section>\n");
    Ok(())
}

/// Writes faults as a list; an entry has the anchor `kind`, a hyphen and its number.
fn faults(out: &mut String, kind: &str, list: &[Corrected]) -> fmt::Result {
    out.push_str("<ol>");
    for (one, number) in list.iter().zip(1..) {
        let item = &one.item;
        writeln!(
            out,
            "<li id=\"{kind}-{number}\"><p class=\"place\"><strong>{}</strong> {}</p>\n<p>{}</p>",
            Sentence(&item.heading),
            badge(one.verdict),
            Sentence(&item.says),
        )?;
        for change in &item.changes {
            if let Some(at) = &change.at {
                write!(out, "<p class=\"meta\">{}</p>", Sentence(at))?;
            }
            let quote = |out: &mut String, words: &Prose| {
                write!(
                    out,
                    "<blockquote class=\"printed v-{}\">{}</blockquote>",
                    one.verdict.key,
                    Sentence(words)
                )
            };
            quote(out, &change.printed)?;
            if let Some(reads) = &change.reads {
                out.push_str("<p class=\"meta\">should read</p>");
                quote(out, reads)?;
            }
            if let Some(repair) = &change.formula {
                correction(out, repair)?;
            }
        }
        if let Some(why) = &item.why {
            write!(
                out,
                "<p><em>{}:</em> {}.</p>",
                item.why_label(),
                Sentence(why)
            )?;
        }
        if let Some(garbled) = &one.garbled {
            write!(
                out,
                "<p><em>Our copy of the paper may be at fault:</em> {}</p>",
                Sentence(garbled)
            )?;
        }
        out.push_str("<p class=\"meta\">Shows in ");
        for (shown, number) in one.shows.iter().zip(0..) {
            let comma = if number > 0 { ", " } else { "" };
            let name = Text(&shown.name);
            write!(
                out,
                "{comma}<a href=\"#{}\"><code>{name}</code></a>",
                shown.anchor
            )?;
        }
        let resting = glossary::dependents(one.resting, one.falling);
        let resting = resting.unwrap_or_else(|| "Nothing else depends on it.".to_owned());
        let level = one
            .checked_by
            .map_or(String::new(), |by| format!(" Checked {by}."));
        writeln!(out, ". {resting}{level}</p></li>")?;
    }
    out.push_str("</ol>\n");
    Ok(())
}

fn findings(out: &mut String, findings: &[&Finding]) -> fmt::Result {
    if findings.is_empty() {
        return Ok(());
    }
    write!(
        out,
        "<details class=\"more\"><summary><h2>Conditions that are not printed, and open points ({})</h2></summary>\n<ul class=\"findings\">\n",
        findings.len()
    )?;
    for finding in findings {
        writeln!(
            out,
            "<li>{}<div><a href=\"#{}\"><code>{}</code></a> <span class=\"meta\">{}</span><br>{}</div></li>",
            badge(finding.verdict),
            finding.anchor,
            Text(&finding.name),
            Text(&finding.at),
            Sentence(&finding.text),
        )?;
    }
    out.push_str("</ul></details>\n");
    Ok(())
}

/// Writes a bar with a stretch for each verdict.
fn bar(out: &mut String, tally: &Tally) -> fmt::Result {
    out.push_str("<div class=\"bar\" aria-hidden=\"true\">");
    for row in &tally.rows {
        write!(
            out,
            "<span class=\"v-{}\" style=\"flex:{}\"></span>",
            row.verdict.key, row.count
        )?;
    }
    out.push_str("</div>\n");
    Ok(())
}

fn tally(out: &mut String, tally: &Tally) -> fmt::Result {
    bar(out, tally)?;
    out.push_str("<div class=\"scroll\" tabindex=\"0\"><table class=\"counts\">\n<thead><tr><th scope=\"col\">verdict</th>");
    for term in &tally.evidence {
        write!(
            out,
            "<th scope=\"col\" class=\"number\">{}</th>",
            term.label
        )?;
    }
    out.push_str("<th scope=\"col\" class=\"number\">no evidence needed</th><th scope=\"col\" class=\"number\">all</th></tr></thead>\n<tbody>\n");
    for row in &tally.rows {
        write!(out, "<tr><th scope=\"row\">{}</th>", badge(row.verdict))?;
        for count in row.by_evidence.iter().chain([&row.without]) {
            match count {
                0 => out.push_str("<td class=\"number\">·</td>"),
                count => write!(out, "<td class=\"number\">{count}</td>")?,
            }
        }
        writeln!(out, "<td class=\"number\">{}</td></tr>", row.count)?;
    }
    if tally.remarks.total > 0 {
        let across = tally.evidence.len() + 1;
        writeln!(
            out,
            "<tr><th scope=\"row\">remarks of ours</th><td colspan=\"{across}\">not counted above; {}</td><td class=\"number\">{}</td></tr>",
            tally.remarks.in_words(),
            tally.remarks.total
        )?;
    }
    out.push_str("</tbody>\n</table></div>\n");
    Ok(())
}

/// Writes the notation, packed like the claims; the counts, the meanings of words, and the rules relied on.
pub(super) fn write_appendix(out: &mut String, report: &Report, pack: &mut Pack) -> fmt::Result {
    if !report.notation.is_empty() {
        let mut inside = String::from("<ul class=\"rests\">\n");
        for line in &report.notation {
            writeln!(inside, "<li>{}</li>", Sentence(line))?;
        }
        inside.push_str("</ul>");
        let number = pack.add(inside);
        writeln!(
            out,
            "<details class=\"more\" data-inside=\"{number}\"><summary><h2 id=\"notation\">Notation that statements share</h2></summary></details>"
        )?;
    }
    out.push_str("<h2>Counts</h2>\n");
    tally(out, &report.tally)?;
    out.push_str("<h2 id=\"words\">What the words mean</h2>\n<h3>Verdicts</h3>\n<div class=\"scroll\" tabindex=\"0\"><table>\n");
    for term in VERDICTS.into_iter().map(glossary::verdict) {
        writeln!(
            out,
            "<tr><th scope=\"row\">{}</th><td>{}</td></tr>",
            badge(term),
            Text(term.meaning)
        )?;
    }
    out.push_str(
        "</table></div>\n<h3>Evidence</h3>\n<div class=\"scroll\" tabindex=\"0\"><table>\n",
    );
    for term in EVIDENCE.into_iter().map(glossary::evidence) {
        writeln!(
            out,
            "<tr><th scope=\"row\"><em>{}</em></th><td>{}</td></tr>",
            term.label,
            Text(term.meaning)
        )?;
    }
    out.push_str("</table></div>\n<h3>Levels of assurance</h3>\n<div class=\"scroll\" tabindex=\"0\"><table>\n");
    for term in [KERNEL, NETTED, DECIDED] {
        writeln!(
            out,
            "<tr><th scope=\"row\"><em>{}</em></th><td>{}</td></tr>",
            term.label,
            Text(term.meaning)
        )?;
    }
    out.push_str("</table></div>\n<h2>The rules relied on</h2>\n");
    for rule in RULES {
        writeln!(
            out,
            "<p><strong>{}.</strong> {}</p>",
            Text(rule.name),
            Text(rule.statement)
        )?;
    }
    Ok(())
}
