//! Renders a made-up paper to a folder: PDF, pages as PNG, HTML, JSON, and a summary.
//!
//! `cargo run -p torse-report --example sample -- FOLDER` shows what a report looks like without a run of
//! the engine. The claims are invented, and some of them hostile: they are what the layout is tested with.

mod paper;

use std::{error::Error, path::Path};
use torse_report::model::Report;
use torse_report::{Manuscript, html_page, verdicts_json, write_file};

fn main() -> Result<(), Box<dyn Error>> {
    let folder = std::env::args()
        .nth(1)
        .ok_or("the folder to write to is missing")?;
    let folder = Path::new(&folder);
    let sample = paper::sample();
    let figures = paper::figures();
    let document = Report::new(&sample, &figures);
    let report = Manuscript::paper(&document, &figures)?.typeset()?;
    write_file(&folder.join("sample.pdf"), &report.pdf()?)?;
    for page in 0..report.page_count() {
        write_file(
            &folder.join(format!("page-{:02}.png", page + 1)),
            &report.page_png(page, 1.5)?,
        )?;
    }
    write_file(
        &folder.join("sample.html"),
        html_page(&document, &figures)?.as_bytes(),
    )?;
    write_file(
        &folder.join("verdicts.json"),
        verdicts_json(&sample.claims)?.as_bytes(),
    )?;
    let summary = Manuscript::summary(&[document])?.typeset()?;
    write_file(&folder.join("summary.pdf"), &summary.pdf()?)?;
    for page in 0..summary.page_count() {
        write_file(
            &folder.join(format!("summary-{:02}.png", page + 1)),
            &summary.page_png(page, 1.5)?,
        )?;
    }
    Ok(())
}
