//! One self-contained page for a browser.
//!
//! It has three depths: what a reader must know in a minute, the corrections, and every claim, closed at first. Style,
//! script and pictures are inside the page, and its content policy forbids any other source. Without the script a
//! reader has the first two and the printed sentences with their verdicts; the script opens the claims, and adds
//! filter, search and keys.

mod claim;
mod colophon;
mod drawing;
mod graph;
mod landing;
mod overview;
mod pack;
mod picture;
mod sliders;
mod text;
mod torse;

use crate::glossary::{self, KINDS, Term};
use crate::model::Report;
use crate::{FigureImage, Image, ReportError};
use base64::Engine as _;
use base64::engine::general_purpose::STANDARD;
use drawing::{Drawing, Files, Shelf};
pub use landing::landing_page;
use pack::Pack;
use std::collections::BTreeMap;
use std::fmt::{self, Write};
use text::{Listed, Sentence, Text, badge};

const STYLE: &str = include_str!("../../assets/page.css");
/// Letters and signs of New Computer Modern Math, so that brackets grow and primes are placed correctly on every
/// machine: made with `pyftsubset --layout-features=ssty,dtls` and renamed, as its licence (GUST) asks.
const FONT: &[u8] = include_bytes!("../../assets/math.woff2");
/// The letters of the text, of Libertinus Serif, with style and weight.
const LETTERS: [(&[u8], &str); 3] = [
    (
        include_bytes!("../../assets/fonts/text-regular.woff2"),
        "font-weight: 400",
    ),
    (
        include_bytes!("../../assets/fonts/text-italic.woff2"),
        "font-style: italic; font-weight: 400",
    ),
    (
        include_bytes!("../../assets/fonts/text-bold.woff2"),
        "font-weight: 700",
    ),
];
const SCRIPT: &str = include_str!("../../assets/page.js");

/// Writes the report of one paper as one HTML file, with its pictures inside.
///
/// Each claim is an `article` with an `id` to link to and with `data-verdict`, `data-kind`, `data-evidence` and
/// `data-section` to filter by. A formula that cannot be parsed is shown as code. `figures` must be those that the
/// report was made with.
///
/// # Errors
///
/// [`ReportError::Label`] for a label of a picture that does not parse; [`ReportError::Typeset`] if writing to a string
/// fails, which does not happen.
pub fn html_page(report: &Report, figures: &[FigureImage]) -> Result<String, ReportError> {
    let (pictures, letters) = pictures(report, figures)?;
    let page = Page {
        report,
        pictures,
        letters,
    };
    let (mut html, mut pack, mut end) = (String::new(), Pack::default(), String::new());
    page.write(&mut html, &mut pack)
        .and_then(|()| page.write_end(&mut end))
        .map_err(|fmt::Error| ReportError::Typeset {
            document: "the HTML page",
            messages: vec!["writing to a string failed".to_owned()],
        })?;
    html.push_str(&pack.written()?);
    html.push_str(&end);
    Ok(html)
}

/// Returns the style of a page, with the fonts of its text and its formulas inside.
fn style() -> String {
    let letters = LETTERS.map(|(font, style)| face("torse text", font, style));
    let formulas = face("torse math", FONT, "font-weight: 400");
    format!("{}{formulas}{STYLE}", letters.concat())
}

/// Returns a rule that makes a font known.
fn face(family: &str, font: &[u8], style: &str) -> String {
    let font = STANDARD.encode(font);
    format!(
        "@font-face {{ font-family: \"{family}\"; {style}; src: url(data:font/woff2;base64,{font}) format(\"woff2\"); }}\n"
    )
}

/// A picture in the form of the page.
struct PagePicture {
    /// The element that shows it.
    element: String,
    /// The data of its version with sliders, JSON.
    moving: Option<String>,
    /// The data of its developable, JSON.
    torse: Option<String>,
    /// The name of the files for download.
    name: String,
    /// The path of a STEP file.
    step: Option<String>,
}

/// Returns the pictures, and their shared letters as an element of the page.
fn pictures(
    report: &Report,
    figures: &[FigureImage],
) -> Result<(Vec<PagePicture>, String), ReportError> {
    let read = |figure: &FigureImage| match &figure.image {
        Image::Svg(text) => Drawing::read(text),
        Image::Png(_) => None,
    };
    let drawings: Vec<Option<Drawing>> = figures.iter().map(read).collect();
    let files = Files::fitting(&drawings);
    let mut shelf = Shelf::default();
    let mut pictures = Vec::with_capacity(figures.len());
    for (position, (figure, drawing)) in figures.iter().zip(&drawings).enumerate() {
        let alt = report.figures.get(position).map_or("", |shown| &shown.alt);
        let alt = Text(alt).to_string();
        let element = match drawing {
            Some(drawing) => drawing.written(&mut shelf, files.pieces(position), &alt),
            None => {
                let source = picture::data_uri(&figure.image);
                format!("<img src=\"{source}\" alt=\"{alt}\" loading=\"lazy\">")
            }
        };
        pictures.push(PagePicture {
            element,
            moving: figure.interactive.as_ref().map(sliders::data).transpose()?,
            torse: figure.torse.as_ref().map(torse::data).transpose()?,
            name: figure.name.clone(),
            step: figure.step.clone(),
        });
    }
    Ok((pictures, shelf.written()))
}

/// The report with further data for the page.
struct Page<'a> {
    report: &'a Report,
    pictures: Vec<PagePicture>,
    /// The shared letters of the pictures.
    letters: String,
}

impl Page<'_> {
    fn write(&self, out: &mut String, pack: &mut Pack) -> fmt::Result {
        let title = Text(&self.report.title);
        write!(
            out,
            "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n\
             <meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n\
             <meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; style-src 'unsafe-inline'; script-src 'unsafe-inline'; img-src data:; font-src data:\">\n\
             <title>Verification report: {title}</title>\n<style>\n{}</style>\n</head>\n<body>\n\
             <a class=\"skip\" href=\"#claims\">Skip to the claims</a>\n\
             <header class=\"masthead\">\n<p class=\"kicker\">Verification report</p>\n<h1>{title}</h1>\n\
             <p class=\"meta\">{}</p>\n<p class=\"meta\"><em>{}</em>{}</p>\n",
            style(),
            Text(&self.report.authors),
            Text(&self.report.venue),
            text::doi(self.report),
        )?;
        overview::write_head(out, self.report)?;
        out.push_str("</header>\n<main>\n");
        out.push_str(&self.letters);
        overview::write(out, self.report, &self.moving())?;
        graph::write(out, self.report)?;
        out.push_str("<h2 id=\"every-claim\">Every claim</h2>\n<noscript><p>Without the script, claims show only the printed text. The PDF beside this page has everything: formulas, proofs, figures and consequences.</p></noscript>\n");
        self.tools(out)?;
        out.push_str("<div id=\"claims\">\n<p id=\"nothing\" hidden>No claim matches. <button type=\"button\" id=\"all\">Show all</button></p>\n");
        for section in &self.report.sections {
            let (anchor, heading) = (&section.anchor, Text(&section.title));
            writeln!(
                out,
                "<section id=\"{anchor}\" data-section>\n<h3 class=\"section\">{heading}</h3>"
            )?;
            for claim in &section.claims {
                claim::write(out, self, claim, anchor, pack)?;
            }
            out.push_str("</section>\n");
        }
        out.push_str("</div>\n");
        if !self.report.further_figures.is_empty() {
            out.push_str("<h2>Further figures</h2>\n");
            for position in &self.report.further_figures {
                self.figure(out, *position)?;
            }
        }
        overview::write_appendix(out, self.report, pack)?;
        colophon::write(out, self.report)?;
        out.push_str("</main>\n");
        Ok(())
    }

    /// The positions of the figures that can be moved.
    fn moving(&self) -> Vec<usize> {
        let pictures = self.pictures.iter().enumerate();
        let moving = pictures.filter(|(_, of)| of.torse.is_some() || of.moving.is_some());
        moving.map(|(position, _)| position).collect()
    }

    /// The meanings of the words of claims and figures, once for the page.
    fn meanings(&self) -> BTreeMap<&'static str, &'static str> {
        let claims = self.report.claims();
        let words = claims.flat_map(|claim| {
            let more = [claim.evidence, claim.level, claim.expected];
            more.into_iter().flatten().chain([claim.verdict])
        });
        let figures = self.report.figures.iter().map(|figure| figure.verdict);
        words
            .chain(figures)
            .map(|term| (term.key, term.meaning))
            .collect()
    }

    fn write_end(&self, out: &mut String) -> fmt::Result {
        let meanings = serde_json::to_string(&self.meanings()).unwrap_or_default();
        writeln!(
            out,
            "<script type=\"application/json\" id=\"meanings\">{}</script>",
            meanings.replace('<', "\\u003c")
        )?;
        write!(
            out,
            "<footer><p>Keys: <kbd>/</kbd> search, <kbd>j</kbd> and <kbd>k</kbd> next and previous claim, \
             <kbd>Esc</kbd> clear the search; in a moving figure the arrows turn it, <kbd>+</kbd> and <kbd>-</kbd> scale it, <kbd>Home</kbd> puts it back.</p></footer>\n<script>\n{SCRIPT}{}</script>\n</body>\n</html>\n",
            torse::SCRIPT
        )
    }

    /// The bar with search and filters; the script shows it, since it is useless without.
    fn tools(&self, out: &mut String) -> fmt::Result {
        out.push_str(
            "<div class=\"tools\" id=\"tools\" role=\"search\" aria-label=\"Claims\" hidden>\n<div class=\"line\">\n\
             <input id=\"search\" type=\"search\" placeholder=\"Search the claims\" aria-label=\"Search the claims\">\n\
             <select id=\"kind\" aria-label=\"Kind\"><option value=\"\">every kind</option>",
        );
        for kind in KINDS.into_iter().map(glossary::kind) {
            if self.report.claims().any(|claim| claim.kind == kind) {
                write!(
                    out,
                    "<option value=\"{}\">{}</option>",
                    kind.key, kind.label
                )?;
            }
        }
        out.push_str("</select>\n<select id=\"section\" aria-label=\"Section\"><option value=\"\">every section</option>");
        for section in &self.report.sections {
            write!(
                out,
                "<option value=\"{}\">{}</option>",
                section.anchor,
                Text(&section.title)
            )?;
        }
        out.push_str("</select>\n<button id=\"theme\" type=\"button\">Light/dark</button>\n</div>\n<div class=\"line\">\n");
        for row in &self.report.tally.rows {
            let Term {
                key,
                label,
                meaning,
            } = row.verdict;
            writeln!(
                out,
                "<button class=\"chip v-{key}\" type=\"button\" value=\"{key}\" aria-pressed=\"false\" title=\"{}\">{label} {}</button>",
                Text(meaning),
                row.count
            )?;
        }
        out.push_str(
            "<button id=\"reset\" type=\"button\">Show all</button> <button id=\"open-all\" type=\"button\" aria-pressed=\"false\">Open all</button>\n<span id=\"shown\" role=\"status\"></span>\n</div>\n</div>\n",
        );
        Ok(())
    }

    fn figure(&self, out: &mut String, position: usize) -> fmt::Result {
        let (Some(figure), Some(picture)) = (
            self.report.figures.get(position),
            self.pictures.get(position),
        ) else {
            return Ok(());
        };
        let alt = Text(&figure.alt);
        write!(out, "<figure id=\"{}\">{}", figure.anchor, picture.element,)?;
        // A developable can be moved in more ways, so its nets are not needed.
        if let Some(data) = &picture.torse {
            let step = picture.step.as_deref().unwrap_or_default();
            write!(
                out,
                "<details class=\"moving torse\" data-name=\"{}\" data-step=\"{}\" data-alt=\"{alt}\"><summary>Interactive: change the shape and unroll it</summary>\
                 <script type=\"application/json\">{data}</script></details>",
                Text(&picture.name),
                Text(step),
            )?;
        } else if let Some(data) = &picture.moving {
            write!(
                out,
                "<details class=\"moving\" data-alt=\"{alt}\"><summary>Move it</summary>\
                 <script type=\"application/json\">{data}</script></details>",
            )?;
        }
        write!(
            out,
            "<figcaption>Figure {}. {} <span class=\"provenance\">{}",
            Text(&figure.number),
            Sentence(&figure.caption),
            badge(figure.verdict),
        )?;
        let lists = [
            ("Not printed, replaced by our own", &figure.stand_in),
            ("Assumed", &figure.assumes),
        ];
        for (name, list) in lists {
            if !list.is_empty() {
                write!(out, " <strong>{name}:</strong> {}.", Listed(list))?;
            }
        }
        out.push_str("</span></figcaption></figure>\n");
        Ok(())
    }
}
