//! Typeset documents.

use crate::paper;
use crate::support::{page, short, summary, typeset};
use torse_report::{FigureImage, Image, ReportError};
use torse_syntax::taxonomy::Verdict;
use torse_verdicts::outcome::PaperOutcome;

#[test]
fn the_pdf_is_pdf_a_2b_and_pdf_ua_1_and_has_the_same_bytes_on_every_run() {
    let document = typeset(&short(), &paper::figures()).unwrap();
    let first = document.pdf().unwrap();
    let second = typeset(&short(), &paper::figures()).unwrap().pdf().unwrap();
    assert!(first.starts_with(b"%PDF-1."));
    assert!(first == second, "two runs gave different bytes");
    let contains = |text: &[u8]| first.windows(text.len()).any(|window| window == text);
    assert!(contains(b"<pdfaid:part>2</") && contains(b"<pdfaid:conformance>B</"));
    assert!(contains(b"<pdfuaid:part>1</"));
}

#[test]
fn formulas_that_cannot_be_set_and_hostile_strings_do_not_keep_a_report_from_being_written() {
    let mut sample = short();
    sample
        .claims
        .retain(|outcome| outcome.claim.printed == paper::HOSTILE);
    assert_eq!(sample.claims.len(), 1);
    sample.title = paper::HOSTILE.to_owned();
    sample.slug = paper::HOSTILE.to_owned();
    typeset(&sample, &[]).unwrap().pdf().unwrap();
    summary(&[sample]).unwrap().pdf().unwrap();
}

#[test]
fn a_paper_without_claims_and_a_summary_without_papers_are_documents_too() {
    let empty = PaperOutcome {
        claims: Vec::new(),
        ..paper::sample()
    };
    typeset(&empty, &[]).unwrap().pdf().unwrap();
    summary(&[]).unwrap().pdf().unwrap();
    assert!(page(&empty, &[]).unwrap().contains("</html>"));
}

#[test]
fn the_summary_has_a_page_for_each_paper() {
    let papers = vec![paper::sample(), paper::sample(), paper::sample()];
    assert_eq!(summary(&papers).unwrap().page_count(), 3);
}

#[test]
fn a_picture_that_is_none_is_an_error_that_names_the_document() {
    let broken = FigureImage {
        name: "broken".to_owned(),
        caption: String::new(),
        alt: String::new(),
        image: Image::Png(b"no picture".to_vec()),
        claims: Vec::new(),
        verdict: Verdict::Reproduced,
        assumes: Vec::new(),
        stand_in: Vec::new(),
        interactive: None,
        torse: None,
        step: None,
    };
    let error = typeset(&short(), &[broken]).unwrap_err();
    assert!(
        matches!(
            error,
            ReportError::Typeset {
                document: "the report of a paper",
                ..
            }
        ),
        "{error}"
    );
}

#[test]
fn pages_are_drawn_as_png_within_bounds_only() {
    let document = summary(&[short()]).unwrap();
    assert!(document.page_png(0, 0.5).unwrap().starts_with(b"\x89PNG"));
    let pages = document.page_count();
    assert!(matches!(
        document.page_png(pages, 1.0),
        Err(ReportError::NoSuchPage { .. })
    ));
    for resolution in [0.0, -1.0, f32::NAN, f32::INFINITY, 21.0] {
        assert!(matches!(
            document.page_png(0, resolution),
            Err(ReportError::Resolution { .. })
        ));
    }
}
