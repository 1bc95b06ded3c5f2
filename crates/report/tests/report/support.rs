//! The made-up paper as documents, and the insides of a page.

use crate::paper;
use std::sync::LazyLock;
use torse_report::{FigureImage, Manuscript, ReportError, Typeset, html_page, model::Report};
use torse_verdicts::outcome::PaperOutcome;

pub static HTML: LazyLock<String> = LazyLock::new(|| {
    page(&paper::sample(), &paper::figures()).unwrap_or_else(|error| error.to_string())
});

pub fn page(paper: &PaperOutcome, figures: &[FigureImage]) -> Result<String, ReportError> {
    html_page(&Report::new(paper, figures), figures).map(|page| unpacked(&page))
}

/// The page with all claims filled, as its script does it.
pub fn unpacked(page: &str) -> String {
    let (before, rest) = page.split_once("id=\"packed\">").unwrap();
    let (packed, after) = rest.split_once('<').unwrap();
    let list = miniz_oxide::inflate::decompress_to_vec(&decoded(packed)).unwrap();
    let list: Vec<String> = serde_json::from_slice(&list).unwrap();
    let mut filled = String::new();
    let mut parts = before.split("</details></article>");
    for inside in list {
        filled.push_str(parts.next().unwrap());
        filled.push_str(&inside);
        filled.push_str("</details></article>");
    }
    filled.extend(parts);
    format!("{filled}id=\"packed\"><{after}")
}

/// The bytes of a text in base 64.
fn decoded(text: &str) -> Vec<u8> {
    const DIGITS: &str = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    let (mut bits, mut count, mut bytes) = (0_u32, 0, vec![]);
    for digit in text.trim_end_matches('=').chars() {
        bits = bits << 6 | u32::try_from(DIGITS.find(digit).unwrap()).unwrap();
        count += 6;
        if count >= 8 {
            count -= 8;
            bytes.push((bits >> count) as u8);
        }
    }
    bytes
}

pub fn typeset(paper: &PaperOutcome, figures: &[FigureImage]) -> Result<Typeset, ReportError> {
    Manuscript::paper(&Report::new(paper, figures), figures)?.typeset()
}

pub fn summary(papers: &[PaperOutcome]) -> Result<Typeset, ReportError> {
    let reports: Vec<Report> = papers.iter().map(|paper| Report::new(paper, &[])).collect();
    Manuscript::summary(&reports)?.typeset()
}

/// The sample without the claims that take long to lay out.
pub fn short() -> PaperOutcome {
    let mut sample = paper::sample();
    sample.claims.retain(|outcome| {
        outcome.claim.id != "sample/thm-4.det" && outcome.claim.id != "sample/eq-3.7"
    });
    sample
}
