//! Writes the letter of corrections as Markdown and as LaTeX; its PDF is set from the same [`Letter`].

use crate::letter::{Envelope, Item, ItemChange};
use crate::model::Report;
use crate::text::escape_markdown;
use crate::view::FormulaView;
use std::fmt::{self, Write};
use torse_typography::{Mathematics, Prose, Span, latex_words};

/// Appears on every page of a letter without a sender.
pub(crate) const DRAFT: &str = "Draft: no sender is named";

/// Stands before the other places of a fault.
pub(crate) const ALSO: &str = "This also concerns";

/// The headings of the three parts of a letter.
pub(crate) const PARTS: [&str; 3] = [
    "Corrections",
    "What the text should state more exactly",
    "Please compare with the printed page",
];

/// Whether a letter to authors has no sender.
fn is_draft(report: &Report, envelope: &Envelope) -> bool {
    report.letter.salutation.is_some() && envelope.sender.is_none()
}

/// The digital object identifier of the paper.
fn doi(report: &Report) -> Option<&str> {
    report.source.as_ref()?.doi.as_deref()
}

/// Writes the verification as an entry of a bibliography.
fn bibliography(report: &Report) -> String {
    let doi = doi(report).map(|doi| format!("doi:{doi}"));
    let doi = doi.unwrap_or_default();
    let from = [&report.authors, &report.venue, &doi].map(|text| line(text.trim()));
    let from: Vec<String> = from.into_iter().filter(|text| !text.is_empty()).collect();
    let scope = report.letter.scope;
    format!(
        "@misc{{torse-{slug},\n  author = {{{{torse {version}}}}},\n  title = {{Verification of ``{title}''}},\n  note = {{{from}: {decided} of {total} statements, formulas and figures decided by exact computation}},\n}}\n",
        slug = report.slug,
        version = env!("CARGO_PKG_VERSION"),
        title = line(&report.title),
        from = from.join(", "),
        decided = scope.decided,
        total = scope.total,
    )
}

/// Puts a text on one line, without signs that could end a block of code.
fn line(text: &str) -> String {
    latex_words(&text.replace('\n', " ").replace('`', "'"))
}

/// Writes the items of the three parts.
fn parts(report: &Report) -> [(&'static str, &[Item]); 3] {
    let letter = &report.letter;
    let lists = [&letter.corrections, &letter.conditions, &letter.questions];
    let mut parts = PARTS.into_iter().zip(lists);
    std::array::from_fn(|_| {
        parts
            .next()
            .map_or(("", [].as_slice()), |(name, list)| (name, list.as_slice()))
    })
}

/// Writes the letter as Markdown, with mathematics as repositories show it.
#[must_use]
pub fn erratum_markdown(report: &Report, envelope: &Envelope) -> String {
    let mut out = String::new();
    // Writing to a string cannot fail.
    let _ = markdown(&mut out, report, &envelope.cleared());
    out
}

fn markdown(out: &mut String, report: &Report, envelope: &Envelope) -> fmt::Result {
    write!(out, "# Corrections to “{}”\n\n", escaped(&report.title))?;
    if is_draft(report, envelope) {
        write!(out, "**{DRAFT}.**\n\n")?;
    }
    if report.letter.salutation.is_some() {
        write!(out, "To: {}\n\n", escaped(&report.authors))?;
        if !report.venue.trim().is_empty() {
            let doi = doi(report).map(|doi| format!(", doi:{}", escaped(doi)));
            let doi = doi.unwrap_or_default();
            write!(out, "Paper: *{}*{doi}\n\n", escaped(&report.venue))?;
        }
    }
    if let Some(sender) = &envelope.sender {
        write!(out, "From: {}\n\n", escaped(sender))?;
    }
    if let Some(date) = &envelope.date {
        write!(out, "Date: {}\n\n", escaped(date))?;
    }
    let letter = &report.letter;
    if let Some(salutation) = &letter.salutation {
        write!(out, "{}\n\n", escaped(salutation))?;
    }
    writeln!(out, "{}", escaped(&letter.opening))?;
    for (name, items) in parts(report) {
        if items.is_empty() {
            continue;
        }
        write!(out, "\n## {name}\n")?;
        for (number, item) in (1..).zip(items) {
            markdown_item(out, number, item)?;
        }
    }
    if !letter.closing.is_empty() {
        write!(out, "\n## How this was checked\n")?;
    }
    for text in &letter.closing {
        write!(out, "\n{}\n", escaped(text))?;
    }
    if let Some(sender) = &envelope.sender {
        write!(out, "\nYours sincerely,\n\n{}\n", escaped(sender))?;
    }
    write!(out, "\n```bibtex\n{}```\n", bibliography(report))
}

fn markdown_item(out: &mut String, number: usize, item: &Item) -> fmt::Result {
    write!(
        out,
        "\n### {number}. {}\n\n{}\n",
        Markdown(&item.heading),
        Markdown(&item.says)
    )?;
    for change in &item.changes {
        let at = change.at.as_ref().map(|at| format!(" ({})", Markdown(at)));
        write!(
            out,
            "\nPrinted{}:\n\n> {}\n",
            at.unwrap_or_default(),
            Markdown(&change.printed)
        )?;
        if let Some(reads) = &change.reads {
            write!(out, "\nShould read:\n\n> {}\n", Markdown(reads))?;
        }
        for (label, view) in formulas(change) {
            write!(out, "\n{label}:\n\n")?;
            match &view.math {
                Some(math) => write!(out, "```math\n{}\n```\n", math.latex)?,
                None => writeln!(out, "    {}", view.text.replace('\n', " "))?,
            }
        }
    }
    if let Some(why) = &item.why {
        write!(out, "\n*{}:* {}.\n", item.why_label(), Markdown(why))?;
    }
    if !item.also.is_empty() {
        let also: Vec<String> = (item.also.iter())
            .map(|at| Markdown(at).to_string())
            .collect();
        write!(out, "\n{ALSO}: {}.\n", also.join("; "))?;
    }
    Ok(())
}

/// Writes the formula by which the words were understood, and its correction.
fn formulas(change: &ItemChange) -> Vec<(&'static str, &FormulaView)> {
    let Some(repair) = &change.formula else {
        return vec![];
    };
    let printed = repair.printed.iter().map(|view| ("That is", view));
    printed
        .chain([("Should read", &repair.statement)])
        .collect()
}

/// Writes a sentence as Markdown.
struct Markdown<'a>(&'a Prose);

impl fmt::Display for Markdown<'_> {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        for span in self.0 {
            match span {
                Span::Words(text) => out.write_str(&escaped(text))?,
                Span::Strong(text) => write!(out, "**{}**", escaped(text))?,
                Span::Code(text) => write!(out, "`{}`", text.replace('`', ""))?,
                Span::Math(math) => write!(out, "$`{}`$", math.latex)?,
            }
        }
        Ok(())
    }
}

/// Writes the letter as a LaTeX document that needs only amsmath.
#[must_use]
pub fn erratum_latex(report: &Report, envelope: &Envelope) -> String {
    let mut out = String::new();
    // Writing to a string cannot fail.
    let _ = latex(&mut out, report, &envelope.cleared());
    out
}

/// The preamble: frames around changes, as large as the script that they stand in.
const PREAMBLE: &str = "\\documentclass[11pt,a4paper]{article}\n\\usepackage[utf8]{inputenc}\n\\usepackage[T1]{fontenc}\n\\usepackage{amsmath,amssymb}\n\
    \\allowdisplaybreaks\n\\setlength{\\parindent}{0pt}\n\\setlength{\\parskip}{6pt}\n\\setlength{\\textwidth}{16cm}\n\\setlength{\\oddsidemargin}{0pt}\n\
    \\raggedright\n\\sloppy\n\\relpenalty=0\n\\binoppenalty=0\n\
    \\newcommand{\\framedin}[2]{\\fbox{$#1#2$}}\n\
    \\renewcommand{\\boxed}[1]{{\\setlength{\\fboxsep}{1.2pt}\\mathpalette\\framedin{#1}}}\n";

fn latex(out: &mut String, report: &Report, envelope: &Envelope) -> fmt::Result {
    out.push_str(PREAMBLE);
    let head = match is_draft(report, envelope) {
        true => DRAFT,
        false => "",
    };
    write!(
        out,
        "\\pagestyle{{myheadings}}\n\\markright{{{head}}}\n\n\\begin{{document}}\n{{\\Large\\bfseries Corrections to ``{}''\\par}}\n\n",
        latex_words(&report.title),
    )?;
    if report.letter.salutation.is_some() {
        write!(out, "To: {}\n\n", latex_words(&report.authors))?;
        if !report.venue.trim().is_empty() {
            let doi = doi(report).map(|doi| format!(", doi:{}", latex_words(doi)));
            let doi = doi.unwrap_or_default();
            let venue = latex_words(&report.venue);
            write!(out, "Paper: \\textit{{{venue}}}{doi}\n\n")?;
        }
    }
    if let Some(sender) = &envelope.sender {
        write!(out, "From: {}\n\n", latex_words(sender))?;
    }
    if let Some(date) = &envelope.date {
        write!(out, "Date: {}\n\n", latex_words(date))?;
    }
    let letter = &report.letter;
    out.push_str("\\bigskip\n");
    if let Some(salutation) = &letter.salutation {
        write!(out, "{}\n\n", latex_words(salutation))?;
    }
    writeln!(out, "{}", latex_words(&letter.opening))?;
    for (name, items) in parts(report) {
        if items.is_empty() {
            continue;
        }
        write!(out, "\n\\subsection*{{{name}}}\n\\begin{{enumerate}}\n")?;
        for item in items {
            latex_item(out, item)?;
        }
        out.push_str("\\end{enumerate}\n");
    }
    if !letter.closing.is_empty() {
        out.push_str("\n\\subsection*{How this was checked}\n");
    }
    for text in &letter.closing {
        write!(out, "\n{}\n", latex_words(text))?;
    }
    if let Some(sender) = &envelope.sender {
        write!(
            out,
            "\n\\bigskip\nYours sincerely,\n\n{}\n",
            latex_words(sender)
        )?;
    }
    let entry = bibliography(report);
    let entry = entry.lines().map(|line| format!("% {line}\n"));
    write!(
        out,
        "\n% The verification in a bibliography:\n{}\\end{{document}}\n",
        entry.collect::<String>()
    )
}

fn latex_item(out: &mut String, item: &Item) -> fmt::Result {
    write!(
        out,
        "\\item \\textbf{{{}.}} {}\n\n",
        Latex(&item.heading),
        Latex(&item.says)
    )?;
    for change in &item.changes {
        let at = change.at.as_ref().map(|at| format!(" ({})", Latex(at)));
        writeln!(
            out,
            "Printed{}:\n\\begin{{quote}}{}\\end{{quote}}",
            at.unwrap_or_default(),
            Latex(&change.printed)
        )?;
        if let Some(reads) = &change.reads {
            writeln!(
                out,
                "Should read:\n\\begin{{quote}}{}\\end{{quote}}",
                Latex(reads)
            )?;
        }
        for (label, view) in formulas(change) {
            latex_display(out, label, view)?;
        }
    }
    if let Some(why) = &item.why {
        write!(out, "\\emph{{{}:}} {}.\n\n", item.why_label(), Latex(why))?;
    }
    if !item.also.is_empty() {
        let also: Vec<String> = (item.also.iter()).map(|at| Latex(at).to_string()).collect();
        write!(out, "{ALSO}: {}.\n\n", also.join("; "))?;
    }
    Ok(())
}

/// Writes a formula in lines, broken between its pieces.
fn latex_display(out: &mut String, label: &str, view: &FormulaView) -> fmt::Result {
    match &view.math {
        Some(math) => {
            let lines = lines(math);
            match lines.contains("\\\\\n") {
                true => writeln!(
                    out,
                    "{label}:\n\\begin{{multline*}}\n{lines}\n\\end{{multline*}}"
                ),
                false => writeln!(out, "{label}:\n\\[\n{lines}\n\\]"),
            }
        }
        None => writeln!(out, "{label}: \\texttt{{{}}}\n", latex_words(&view.text)),
    }
}

/// Breaks the formula before pieces that do not fit into the line.
fn lines(math: &Mathematics) -> String {
    /// Width of a line in letters.
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

/// Writes a sentence as LaTeX.
struct Latex<'a>(&'a Prose);

impl fmt::Display for Latex<'_> {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        for span in self.0 {
            match span {
                Span::Words(text) => out.write_str(&latex_words(text))?,
                Span::Strong(text) => write!(out, "\\textbf{{{}}}", latex_words(text))?,
                Span::Code(text) => write!(out, "\\texttt{{{}}}", latex_words(text))?,
                Span::Math(math) => write!(out, "${}$", math.latex)?,
            }
        }
        Ok(())
    }
}
/// Escapes what Markdown would read as a mark, so that a reader of the source meets as little of it as can be; the text
/// comes onto one line. A dollar sign is an entity: an escaped one still opens a formula where formulas are set.
fn escaped(text: &str) -> String {
    escape_markdown(text, |character| match character {
        '$' => Some("&#36;".to_owned()),
        '*' | '_' | '`' | '[' | ']' | '\\' | '#' | '|' | '~' => Some(format!("\\{character}")),
        _ => None,
    })
}
