//! The head of the page, counts and findings, and its end, what the words mean.

use super::{Prose, Text, badge};
use crate::Tally;
use crate::model::Report;
use crate::words::{self, EVIDENCE, RULES, VERDICTS};
use std::fmt::{self, Write};

/// What the report is, the counts, and what was found.
pub(super) fn write(out: &mut String, report: &Report) -> fmt::Result {
    writeln!(
        out,
        "<p>This report says, for each of {} statements taken from the paper, what is true of it as printed (the \
         <em>verdict</em>) and what that answer rests on (the <em>evidence</em>). Verdicts are computed, never typed: \
         equalities are decided by exact algebra, inequalities and decimals by certified enclosures, and a statement is \
         called false only with an exact counterexample. <a href=\"#words\">What the words mean.</a></p>",
        report.tally.total
    )?;
    if report.unexpected > 0 {
        writeln!(
            out,
            "<p><strong>Verdicts that differ from what the derivation file expects: {}.</strong></p>",
            report.unexpected
        )?;
    }
    tally(out, &report.tally)?;
    out.push_str("<h2>Findings</h2>\n");
    if report.findings.is_empty() {
        out.push_str("<p>Nothing was refuted, and nothing was left undecided.</p>\n");
        return Ok(());
    }
    out.push_str("<ul class=\"findings\">\n");
    for finding in &report.findings {
        writeln!(
            out,
            "<li>{}<div><a href=\"#{}\"><code>{}</code></a> <span class=\"meta\">{}</span><br><q>{}</q><br>{}</div></li>",
            badge(finding.verdict),
            finding.anchor,
            Text(&finding.name),
            Text(&finding.at),
            Text(&finding.printed),
            Prose(&finding.text),
        )?;
    }
    out.push_str("</ul>\n");
    Ok(())
}

fn tally(out: &mut String, tally: &Tally) -> fmt::Result {
    out.push_str("<div class=\"bar\" aria-hidden=\"true\">");
    for row in &tally.rows {
        write!(
            out,
            "<span class=\"v-{}\" style=\"flex:{}\"></span>",
            row.verdict.key, row.count
        )?;
    }
    out.push_str("</div>\n<div class=\"scroll\" tabindex=\"0\"><table class=\"counts\">\n<thead><tr><th scope=\"col\">verdict</th>");
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
            "<tr><th scope=\"row\">remarks of ours</th><td colspan=\"{across}\">not counted above; {} of them hold</td><td class=\"number\">{}</td></tr>",
            tally.remarks.proved, tally.remarks.total
        )?;
    }
    out.push_str("</tbody>\n</table></div>\n");
    Ok(())
}

/// What the words mean, and the rules relied on.
pub(super) fn write_glossary(out: &mut String) -> fmt::Result {
    out.push_str("<h2 id=\"words\">What the words mean</h2>\n<h3>Verdicts</h3>\n<div class=\"scroll\" tabindex=\"0\"><table>\n");
    for term in VERDICTS.into_iter().map(words::verdict) {
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
    for term in EVIDENCE.into_iter().map(words::evidence) {
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
