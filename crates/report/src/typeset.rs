//! PDF, and pages as pictures.

use crate::ReportError;
use crate::world::{fixed_date, refused};
use typst::{foundations::Smart, utils::Scalar};
use typst_layout::PagedDocument;
use typst_pdf::{PdfOptions, PdfStandard, PdfStandards, Timestamp};
use typst_render::RenderOptions;
use typst_svg::SvgOptions;

/// A document with its pages laid out.
///
/// ```no_run
/// # fn run(paper: &torse_verdicts::outcome::PaperOutcome) -> Result<(), torse_report::ReportError> {
/// let report = torse_report::model::Report::new(paper, &[]);
/// let document = torse_report::Manuscript::paper(&report, &[])?.typeset()?;
/// torse_report::write_file("report.pdf".as_ref(), &document.pdf()?)?;
/// torse_report::write_file("first-page.png".as_ref(), &document.page_png(0, 2.0)?)?;
/// # Ok(())
/// # }
/// ```
#[derive(Debug)]
pub struct Typeset {
    pub(crate) document: PagedDocument,
    pub(crate) identifier: String,
}

impl Typeset {
    /// Returns the number of pages.
    #[must_use]
    pub fn page_count(&self) -> usize {
        self.document.pages().len()
    }

    /// Writes the document as PDF/A-2b and PDF/UA-1: fonts embedded, with outline and links, tagged, with alternative
    /// texts for every formula and picture; the same bytes on every run.
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

    /// Draws a page, counted from 0, as SVG in true size, its letters as outlines.
    ///
    /// # Errors
    ///
    /// [`ReportError::NoSuchPage`].
    pub fn page_svg(&self, page: usize) -> Result<String, ReportError> {
        let pages = self.page_count();
        let laid_out = self.document.pages().get(page);
        let laid_out = laid_out.ok_or(ReportError::NoSuchPage { page, pages })?;
        Ok(typst_svg::svg(laid_out, &SvgOptions::default()))
    }

    /// Draws a page, counted from 0, as PNG.
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
