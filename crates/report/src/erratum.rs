//! Corrections ready to be sent: to the authors, or to the journal.
//!
//! Only what is false under every honest reading, and is no confusion of the copy at hand, goes into a letter: where it
//! stands, what is printed, what is to be read instead, and why, with the point at which the print fails.

use crate::corrections::Corrected;
use crate::gallery::escaped;
use crate::math::{Mathematics, Prose, Span, latex_words};
use crate::model::{FormulaView, Report};
use std::fmt::{self, Write};

/// The corrections of a paper that can be sent.
pub(crate) fn certain(report: &Report) -> impl Iterator<Item = &Corrected> {
    let list = report.corrections.iter();
    list.filter(|one| one.garbled.is_none())
}

/// What the letter says first.
pub(crate) fn opening(report: &Report) -> String {
    let count = certain(report).count();
    match count {
        0 => format!(
            "No statement of this paper was found to be false as printed: {}",
            report.short.counts
        ),
        1 => "One statement of this paper is false as printed, in every reading that its words allow.".to_owned(),
        _ => format!("{count} statements of this paper are false as printed, in every reading that their words allow. What most rests on comes first."),
    }
}

/// How the corrections were found, for the end of the letter.
pub(crate) const CLOSING: &str = "Each statement was refuted by an exact counterexample, computed and not typed. Where a formula is said to be read differently, the new one is proved. The report of the paper has the proofs, and every other statement.";

/// The verification as an entry of a bibliography.
fn bibliography(report: &Report) -> String {
    format!(
        "@misc{{torse-{slug},\n  author = {{{{torse {version}}}}},\n  title = {{Verification of ``{title}''}},\n  note = {{{authors}, {venue}: every statement decided by exact computation}},\n}}\n",
        slug = report.slug,
        version = env!("CARGO_PKG_VERSION"),
        title = line(&report.title),
        authors = line(&report.authors),
        venue = line(&report.venue),
    )
}

/// Text on one line, without what could end a block of code.
fn line(text: &str) -> String {
    latex_words(&text.replace('\n', " ").replace('`', "'"))
}

/// The corrections as Markdown, with mathematics as repositories' pages set it.
#[must_use]
pub fn erratum_markdown(report: &Report) -> String {
    let mut out = String::new();
    // A string does not refuse to be written to.
    let _ = markdown(&mut out, report);
    out
}

fn markdown(out: &mut String, report: &Report) -> fmt::Result {
    write!(
        out,
        "# Corrections to “{}”\n\n{}, *{}*\n\n{}\n",
        escaped(&report.title),
        escaped(&report.authors),
        escaped(&report.venue),
        opening(report)
    )?;
    for (number, one) in (1..).zip(certain(report)) {
        let finding = &one.finding;
        write!(out, "\n## {number}. {}\n\n", escaped(&finding.at))?;
        match &one.correction {
            Some(repair) => {
                out.push_str("Printed:\n\n");
                match &repair.printed {
                    Some(view) => markdown_display(out, view)?,
                    None => write!(out, "> {}\n\n", Markdown(&finding.printed))?,
                }
                out.push_str("To be read:\n\n");
                markdown_display(out, &repair.statement)?;
            }
            None => write!(out, "Printed:\n\n> {}\n\n", Markdown(&finding.printed))?,
        }
        if one.is_told() {
            writeln!(out, "{}", Markdown(&finding.text))?;
        }
        if let Some(why) = &one.why_in_full {
            write!(out, "\n*Why:* {}.\n", Markdown(why))?;
        }
        if let Some(level) = one.level {
            write!(
                out,
                "\n*Level of assurance:* {}. {}\n",
                level.label, level.meaning
            )?;
        }
    }
    if certain(report).next().is_some() {
        write!(out, "\n{CLOSING}\n")?;
    }
    write!(out, "\n```bibtex\n{}```\n", bibliography(report))
}

fn markdown_display(out: &mut String, view: &FormulaView) -> fmt::Result {
    match &view.math {
        Some(math) => write!(out, "```math\n{}\n```\n\n", math.latex),
        None => write!(out, "    {}\n\n", view.text.replace('\n', " ")),
    }
}

/// A sentence as Markdown.
struct Markdown<'a>(&'a Prose);

impl fmt::Display for Markdown<'_> {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        for span in self.0 {
            match span {
                Span::Words(text) => out.write_str(&escaped(text))?,
                Span::Code(text) => write!(out, "`{}`", text.replace('`', ""))?,
                Span::Math(math) => write!(out, "$`{}`$", math.latex)?,
            }
        }
        Ok(())
    }
}

/// The corrections as a document of LaTeX, with nothing but amsmath.
#[must_use]
pub fn erratum_latex(report: &Report) -> String {
    let mut out = String::new();
    // A string does not refuse to be written to.
    let _ = latex(&mut out, report);
    out
}

fn latex(out: &mut String, report: &Report) -> fmt::Result {
    write!(
        out,
        "\\documentclass[11pt,a4paper]{{article}}\n\\usepackage[utf8]{{inputenc}}\n\\usepackage[T1]{{fontenc}}\n\\usepackage{{amsmath,amssymb}}\n\
         \\allowdisplaybreaks\n\\setlength{{\\parindent}}{{0pt}}\n\\setlength{{\\parskip}}{{6pt}}\n\\emergencystretch=3em\n\\setlength{{\\textwidth}}{{16cm}}\n\\setlength{{\\oddsidemargin}}{{0pt}}\n\n\
         \\title{{Corrections to ``{}''}}\n\\author{{{}\\\\ \\textit{{{}}}}}\n\\date{{}}\n\n\\begin{{document}}\n\\maketitle\n\n{}\n",
        latex_words(&report.title),
        latex_words(&report.authors),
        latex_words(&report.venue),
        latex_words(&opening(report))
    )?;
    if certain(report).next().is_some() {
        out.push_str("\n\\begin{enumerate}\n");
        for one in certain(report) {
            latex_entry(out, one)?;
        }
        write!(out, "\\end{{enumerate}}\n\n{CLOSING}\n")?;
    }
    let entry = bibliography(report);
    let entry = entry.lines().map(|line| format!("% {line}\n"));
    write!(
        out,
        "\n% The verification in a bibliography:\n{}\\end{{document}}\n",
        entry.collect::<String>()
    )
}

fn latex_entry(out: &mut String, one: &Corrected) -> fmt::Result {
    let finding = &one.finding;
    write!(out, "\\item \\textbf{{{}.}} ", latex_words(&finding.at))?;
    let quotation = Latex(&finding.printed);
    match &one.correction {
        Some(repair) => {
            match &repair.printed {
                Some(view) => latex_display(out, "Printed:", view)?,
                None => write!(out, "Printed: ``{quotation}''.\n\n")?,
            }
            latex_display(out, "To be read:", &repair.statement)?;
        }
        None => write!(out, "Printed: ``{quotation}''.\n\n")?,
    }
    if one.is_told() {
        writeln!(out, "{}", Latex(&finding.text))?;
    }
    if let Some(why) = &one.why_in_full {
        write!(out, "\n\\emph{{Why:}} {}.\n", Latex(why))?;
    }
    if let Some(level) = one.level {
        write!(
            out,
            "\n\\emph{{Level of assurance:}} {}. {}\n",
            level.label,
            latex_words(level.meaning)
        )?;
    }
    out.push('\n');
    Ok(())
}

/// A formula in lines that are broken where its pieces are.
fn latex_display(out: &mut String, label: &str, view: &FormulaView) -> fmt::Result {
    match &view.math {
        Some(math) => writeln!(
            out,
            "{label}\n\\begin{{multline*}}\n{}\n\\end{{multline*}}",
            lines(math)
        ),
        None => writeln!(out, "{label} \\texttt{{{}}}\n", latex_words(&view.text)),
    }
}

/// The formula with a line break before pieces that the line has no room for.
fn lines(math: &Mathematics) -> String {
    /// So many letters fill a line.
    const WIDTH: usize = 64;
    let mut text = String::new();
    let mut used = 0;
    for (piece, width) in &math.latex_pieces {
        if used > 0 && used + width > WIDTH {
            text.push_str(" \\\\\n");
            used = 0;
        }
        text.push_str(piece);
        text.push(' ');
        used += width;
    }
    text.trim_end().to_owned()
}

/// A sentence as LaTeX.
struct Latex<'a>(&'a Prose);

impl fmt::Display for Latex<'_> {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        for span in self.0 {
            match span {
                Span::Words(text) => out.write_str(&latex_words(text))?,
                Span::Code(text) => write!(out, "\\texttt{{{}}}", latex_words(text))?,
                Span::Math(math) => write!(out, "${}$", math.latex)?,
            }
        }
        Ok(())
    }
}
