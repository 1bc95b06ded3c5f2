//! The landing page: a card for each paper, with the worked examples in a section of their own.

use super::style;
use super::text::{Sentence, Text, doi, formula};
use crate::ReportError;
use crate::applicability::Usability;
use crate::model::Report;
use std::fmt::{self, Write};

/// Number of points on a card.
const POINTS: usize = 3;

/// Writes the page that links to the reports of several papers beside it.
///
/// # Errors
///
/// [`ReportError::Typeset`] if writing to a string fails, which does not happen.
pub fn landing_page(reports: &[Report]) -> Result<String, ReportError> {
    let mut page = String::new();
    write(&mut page, reports).map_err(|fmt::Error| ReportError::Typeset {
        document: "the landing page",
        messages: vec!["writing to a string failed".to_owned()],
    })?;
    Ok(page)
}

fn write(out: &mut String, reports: &[Report]) -> fmt::Result {
    let (examples, papers): (Vec<&Report>, Vec<&Report>) =
        reports.iter().partition(|report| report.is_example());
    write!(
        out,
        "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n\
         <meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n\
         <meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; style-src 'unsafe-inline'; font-src data:; img-src 'self' file:\">\n\
         <title>What holds in these papers</title>\n<style>\n{}</style>\n</head>\n<body>\n\
         <header class=\"masthead\">\n<p class=\"kicker\">Verification reports</p>\n<h1>What holds in these papers</h1>\n\
         <p>The statements of these papers were checked by exact computation. A report says which of them hold, what the others should say, \
         and why; letters of corrections are ready to be sent.</p>\n</header>\n<main>\n",
        style()
    )?;
    for report in papers {
        card(out, report)?;
    }
    if !examples.is_empty() {
        out.push_str("<h2>Worked examples</h2>\n<p class=\"meta\">Statements of textbooks, with slips that were planted on purpose.</p>\n");
    }
    for report in examples {
        card(out, report)?;
    }
    out.push_str(
        "</main>\n<footer><p><a href=\"summary.pdf\">Summary of all papers</a> · <a href=\"gallery.md\">all figures</a> · \
         <a href=\"verdicts.json\">verdicts for programs</a></p></footer>\n</body>\n</html>\n",
    );
    Ok(())
}

fn card(out: &mut String, report: &Report) -> fmt::Result {
    let slug = Text(&report.slug);
    write!(
        out,
        "<section class=\"card\" id=\"{slug}\"><h2><a href=\"{slug}.html\">{}</a></h2>\n<p class=\"meta\">{} · <em>{}</em>{}</p>\n\
         {}<p><strong>{}</strong> {}</p>\n<ol>",
        Text(&report.title),
        Text(&report.authors),
        Text(&report.venue),
        doi(report),
        picture(report),
        usable(report),
        Text(&report.short.counts)
    )?;
    for (point, number) in report.short.points.iter().take(POINTS).zip(1..) {
        write!(
            out,
            "<li><a href=\"{slug}.html#correction-{number}\">{}</a>: {}",
            Sentence(&point.heading),
            Sentence(&point.text)
        )?;
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
    write!(
        out,
        "</ol>\n<p><a href=\"{slug}.html\">report</a> · <a href=\"{slug}.pdf\">as PDF</a> · <a href=\"{slug}-erratum.pdf\">letter of corrections</a></p>\n"
    )?;
    if let Some(source) = &report.source {
        writeln!(
            out,
            "<p class=\"meta\">torse {} · derivation files <code>{}</code></p>",
            source.version,
            Text(source.short())
        )?;
    }
    out.push_str("</section>\n");
    Ok(())
}

/// Shows a figure of the paper, from the folder of figures beside the page.
fn picture(report: &Report) -> String {
    report.picture.as_ref().map_or_else(String::new, |picture| {
        let (slug, file, alt) = (Text(&report.slug), Text(&picture.file), Text(&picture.alt));
        format!("<a class=\"picture\" href=\"{slug}.html#moving\"><img src=\"{file}\" alt=\"{alt}\" loading=\"lazy\"></a>\n")
    })
}

/// Says whether the paper can be used, in a sentence.
fn usable(report: &Report) -> String {
    let count = |answers: &[Usability]| {
        let constructions = report.constructions.iter();
        constructions
            .filter(|own| answers.contains(&own.answer))
            .count()
    };
    let all = report.constructions.len();
    let fine = count(&[
        Usability::AsPrinted,
        Usability::UnderCondition,
        Usability::InOneReading,
    ]);
    let corrected = count(&[Usability::Corrected]);
    match (all, all - fine, corrected) {
        (0, ..) if report.corrections.is_empty() => "Usable as printed.".to_owned(),
        (0, ..) => "Usable with corrections.".to_owned(),
        (_, 0, _) => "Usable as printed, under the conditions that the report states.".to_owned(),
        (_, bad, corrected) if bad == corrected => format!(
            "Usable with corrections: {corrected} of {all} theorems, algorithms and examples {} one.",
            if corrected == 1 { "needs" } else { "need" }
        ),
        (_, bad, corrected) => format!(
            "Usable in parts: {corrected} of {all} theorems, algorithms and examples {} a correction, and {} cannot be used as printed.",
            if corrected == 1 { "needs" } else { "need" },
            bad - corrected
        ),
    }
}
