//! PDF, and pages as pictures.

use crate::corrections::Corrected;
use crate::model::{Report, figure_file};
use crate::words::{self, EVIDENCE, RULES, Rule, Term, VERDICTS};
use crate::world::{MemoryWorld, fixed_date, has_glyph, refused};
use crate::{FigureImage, ReportError, erratum, text};
use serde::Serialize;
use serde_json::Value;
use typst::{foundations::Smart, utils::Scalar};
use typst_layout::PagedDocument;
use typst_pdf::{PdfOptions, PdfStandard, PdfStandards, Timestamp};
use typst_render::RenderOptions;

const TEMPLATES: [(&str, &str); 4] = [
    ("theme.typ", include_str!("../assets/theme.typ")),
    ("formula.typ", include_str!("../assets/formula.typ")),
    ("claim.typ", include_str!("../assets/claim.typ")),
    ("overview.typ", include_str!("../assets/overview.typ")),
];
const PAPER: &str = include_str!("../assets/paper.typ");
const ERRATUM: &str = include_str!("../assets/erratum.typ");
const SUMMARY: &str = include_str!("../assets/summary.typ");

/// A document with its pages laid out.
///
/// ```no_run
/// # fn run(paper: &torse_verdicts::outcome::PaperOutcome) -> Result<(), torse_report::ReportError> {
/// let report = torse_report::model::Report::new(paper, &[]);
/// let document = torse_report::Typeset::paper(&report, &[])?;
/// torse_report::write_file("report.pdf".as_ref(), &document.pdf()?)?;
/// torse_report::write_file("first-page.png".as_ref(), &document.page_png(0, 2.0)?)?;
/// # Ok(())
/// # }
/// ```
#[derive(Debug)]
pub struct Typeset {
    document: PagedDocument,
    identifier: String,
}

impl Typeset {
    /// The report of one paper, with the pictures that it was made with.
    ///
    /// A formula that cannot be read is shown as code; a character that no font has is spelled out.
    ///
    /// # Errors
    ///
    /// [`ReportError::Typeset`] when the document cannot be set, for instance because a picture is not what
    /// it is said to be.
    pub fn paper(report: &Report, figures: &[FigureImage]) -> Result<Self, ReportError> {
        let data = Data {
            glossary: Glossary::new(),
            content: report,
        };
        let pictures = figures.iter().enumerate().map(|(position, figure)| {
            (figure_file(position, figure), figure.image.bytes().to_vec())
        });
        Self::set(
            "the report of a paper",
            PAPER,
            &data,
            pictures,
            &report.slug,
        )
    }

    /// The summary of several papers: counts, and of each what a reader must know in a minute. Examples of ours are left
    /// out.
    ///
    /// # Errors
    ///
    /// [`ReportError::Typeset`] when the document cannot be set.
    pub fn summary(reports: &[Report]) -> Result<Self, ReportError> {
        let papers: Vec<&Report> = reports.iter().filter(|of| !of.is_example()).collect();
        let data = Data {
            glossary: Glossary::new(),
            content: papers,
        };
        Self::set("the summary", SUMMARY, &data, [], "summary")
    }

    /// The corrections of a paper, ready to be sent.
    ///
    /// # Errors
    ///
    /// [`ReportError::Typeset`] when the document cannot be set.
    pub fn erratum(report: &Report) -> Result<Self, ReportError> {
        let data = Letter {
            content: report,
            corrections: erratum::certain(report).collect(),
            opening: erratum::opening(report),
            closing: erratum::CLOSING,
        };
        let identifier = format!("{}-erratum", report.slug);
        Self::set(
            "the corrections of a paper",
            ERRATUM,
            &data,
            [],
            &identifier,
        )
    }

    fn set(
        name: &'static str,
        main: &str,
        data: &impl Serialize,
        pictures: impl IntoIterator<Item = (String, Vec<u8>)>,
        identifier: &str,
    ) -> Result<Self, ReportError> {
        let mut data = serde_json::to_value(data)?;
        spell_out_missing_glyphs(&mut data);
        let files = pictures
            .into_iter()
            .chain([("data.json".to_owned(), serde_json::to_vec(&data)?)]);
        let document = MemoryWorld::new(main, &TEMPLATES, files)?.compile(name)?;
        Ok(Typeset {
            document,
            identifier: format!("torse-{identifier}"),
        })
    }

    /// How many pages the document has.
    #[must_use]
    pub fn page_count(&self) -> usize {
        self.document.pages().len()
    }

    /// The document as PDF/A-2b and PDF/UA-1: fonts embedded, with outline and links, tagged, every formula and picture
    /// with words for those who do not see it; the same bytes on every run.
    ///
    /// # Errors
    ///
    /// [`ReportError::Typeset`] when the document cannot be written.
    pub fn pdf(&self) -> Result<Vec<u8>, ReportError> {
        const NAME: &str = "the PDF";
        let standards =
            PdfStandards::new(&[PdfStandard::A_2b, PdfStandard::Ua_1]).map_err(|reason| {
                ReportError::Typeset {
                    document: NAME,
                    messages: vec![reason.message().to_string()],
                }
            })?;
        let options = PdfOptions {
            ident: Smart::Custom(self.identifier.clone()),
            timestamp: fixed_date().map(Timestamp::new_utc),
            standards,
            ..PdfOptions::default()
        };
        typst_pdf::pdf(&self.document, &options).map_err(|diagnostics| refused(NAME, &diagnostics))
    }

    /// A page, counted from 0, as PNG.
    ///
    /// An A4 page is 595 by 842 points.
    ///
    /// # Errors
    ///
    /// [`ReportError::NoSuchPage`]; [`ReportError::Resolution`] for less than 0.1 or more than 20 pixels a
    /// point, or none; [`ReportError::Png`] when encoding fails.
    pub fn page_png(&self, page: usize, pixels_per_point: f32) -> Result<Vec<u8>, ReportError> {
        if !(0.1..=20.0).contains(&pixels_per_point) {
            return Err(ReportError::Resolution { pixels_per_point });
        }
        let pages = self.page_count();
        let laid_out = self
            .document
            .pages()
            .get(page)
            .ok_or(ReportError::NoSuchPage { page, pages })?;
        let options = RenderOptions {
            pixel_per_pt: Scalar::new(f64::from(pixels_per_point)),
            ..RenderOptions::default()
        };
        typst_render::render(laid_out, &options)
            .encode_png()
            .map_err(|reason| ReportError::Png {
                page,
                reason: reason.to_string(),
            })
    }
}

#[derive(Serialize)]
struct Data<C> {
    content: C,
    glossary: Glossary,
}

#[derive(Serialize)]
struct Letter<'a> {
    content: &'a Report,
    corrections: Vec<&'a Corrected>,
    opening: String,
    closing: &'static str,
}

#[derive(Serialize)]
struct Glossary {
    verdicts: Vec<Term>,
    evidence: Vec<Term>,
    levels: [Term; 3],
    rules: [Rule; 7],
}

impl Glossary {
    fn new() -> Self {
        Glossary {
            verdicts: VERDICTS.into_iter().map(words::verdict).collect(),
            evidence: EVIDENCE.into_iter().map(words::evidence).collect(),
            levels: [words::KERNEL, words::NETTED, words::DECIDED],
            rules: RULES,
        }
    }
}

/// PDF/A allows no glyph that stands for "no such glyph".
fn spell_out_missing_glyphs(data: &mut Value) {
    match data {
        Value::String(string) => {
            if !string.chars().all(has_glyph) {
                *string = text::replace(string, has_glyph);
            }
        }
        Value::Array(values) => values.iter_mut().for_each(spell_out_missing_glyphs),
        Value::Object(members) => members.values_mut().for_each(spell_out_missing_glyphs),
        Value::Null | Value::Bool(_) | Value::Number(_) => {}
    }
}
