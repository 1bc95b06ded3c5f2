//! The gallery: a page in Markdown that shows all figures of all papers.
//!
//! It stands beside the folder of figures, where the web page of a repository shows it: pictures that link to the drawings,
//! and to the figure that moves where the report has one, each with its caption, its verdict, and its assumptions.

use crate::text::{escape_markdown, figure_anchor};
use crate::{FigureImage, ReportError, glossary, plain};
use std::fmt::{self, Write};
use torse_verdicts::outcome::PaperOutcome;

/// Width of a picture in pixels: about that of a page of a repository, so that its letters can be read.
const WIDTH: u32 = 800;

/// Writes the gallery of `papers`, each with its figures, whose files are `figures/NAME.png`.
///
/// Text is written as HTML inside Markdown and escaped, so nothing in a caption acts as markup.
///
/// # Errors
///
/// [`ReportError::Typeset`] if writing to a string fails, which does not happen.
pub fn gallery(papers: &[(&PaperOutcome, &[FigureImage])]) -> Result<String, ReportError> {
    let mut page = String::new();
    write(&mut page, papers).map_err(|fmt::Error| ReportError::Typeset {
        document: "the gallery",
        messages: vec!["writing to a string failed".to_owned()],
    })?;
    Ok(page)
}

fn write(page: &mut String, papers: &[(&PaperOutcome, &[FigureImage])]) -> fmt::Result {
    page.push_str(
        "# Figures\n\nThe figures of the papers, redrawn by `torse report` from the formulas that the claims state, and \
         figures of our own beside claims that were refuted. *Reproduced* means: from printed data alone; *partial*: what \
         was assumed is listed; *underspecified*: the paper does not print the data, and the figure shows stand-ins.\n",
    );
    for (paper, figures) in papers {
        if figures.is_empty() {
            continue;
        }
        let (slug, title) = (escaped(&paper.slug), escaped(&paper.title));
        write!(
            page,
            "\n## {title}\n\n`{slug}` · {} figures\n",
            figures.len()
        )?;
        for (number, figure) in (1..).zip(*figures) {
            let moving = figure_anchor(number);
            entry(page, figure, &format!("{slug}.html#{moving}"))?;
        }
    }
    Ok(())
}

/// Writes a figure, which moves at the address `moving` if its shape has parameters or it unrolls.
fn entry(page: &mut String, figure: &FigureImage, moving: &str) -> fmt::Result {
    let (name, alt) = (escaped(&figure.name), escaped(&figure.alt));
    let verdict = glossary::verdict(figure.verdict).label;
    write!(
        page,
        "\n<a href=\"figures/{name}.svg\"><img src=\"figures/{name}.png\" width=\"{WIDTH}\" alt=\"{alt}\"></a>\n\n\
         **{name}** · *{verdict}* · {}\n",
        escaped(&plain(&figure.caption))
    )?;
    let lists = [
        ("Not printed, replaced by our own", &figure.stand_in),
        ("Assumed", &figure.assumes),
    ];
    for (what, list) in lists {
        if !list.is_empty() {
            write!(page, "\n*{what}:* {}.\n", escaped(&plain(&list.join("; "))))?;
        }
    }
    let mut links = vec![format!("<a href=\"figures/{name}.svg\">SVG</a>")];
    if figure.interactive.is_some() || figure.torse.is_some() {
        links.push(format!("<a href=\"{moving}\">move it in the report</a>"));
    }
    if let Some(place) = &figure.step {
        let place = escaped(place);
        links.push(format!("<a href=\"{place}\">STEP of the developable</a>"));
    }
    writeln!(page, "\n{}", links.join(" · "))
}

/// Escapes every sign of HTML and Markdown in a text, and puts it on one line.
fn escaped(text: &str) -> String {
    escape_markdown(text, |character| match character {
        '"' => Some("&quot;".to_owned()),
        '*' | '_' | '`' | '[' | ']' | '\\' | '#' | '|' | '~' | '$' | '!' => {
            Some(format!("&#{};", u32::from(character)))
        }
        _ => None,
    })
}
