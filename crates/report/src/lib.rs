//! Reports on the verdicts of a paper: PDF, HTML and JSON from one document model.
//!
//! The engine hands over [`PaperOutcome`](torse_verdicts::outcome::PaperOutcome)s and pictures
//! ([`FigureImage`]); this crate decides nothing and computes nothing, it lays out.
//!
//! - [`Manuscript`] is a document before typesetting: [`Manuscript::paper`] for one paper, [`Manuscript::summary`] for
//!   several, with a fingerprint that shows whether it was set before;
//! - [`Typeset`] is the document with its pages laid out, written with [`Typeset::pdf`], viewed with
//!   [`Typeset::page_png`];
//! - [`html_page`] is one self-contained page for a browser, formulas as MathML; [`landing_page`] links to several;
//! - [`erratum_latex`], [`erratum_markdown`] and [`Manuscript::erratum`] are corrections ready to be sent;
//! - [`gallery`] shows all figures of all papers, in Markdown;
//! - [`verdicts_json`] is the interface for other programs;
//! - [`write_file`] replaces a file whole or not at all.
//!
//! The first two need the feature `pdf`, which brings the typesetter; everything else does without.
//!
//! Every output is a function of its arguments alone: the same bytes on every run.

pub mod applicability;
pub mod corrections;
mod dependencies;
#[cfg(all(test, feature = "pdf"))]
mod derivation_tests;
pub mod digest;
mod erratum;
mod error;
mod faults;
mod figure;
mod findings;
mod gallery;
pub mod glossary;
mod html;
mod json;
mod json_stream;
mod letter;
#[cfg(feature = "pdf")]
mod manuscript;
pub mod model;
mod names;
mod sentence;
mod source;
mod statements;
pub mod summary_page;
mod tally;
mod text;
#[cfg(feature = "pdf")]
mod typeset;
mod verdict_lines;
mod view;
#[cfg(feature = "pdf")]
mod world;
mod write;

pub use dependencies::{DependencyGroup, dependency_groups};
pub use erratum::{erratum_latex, erratum_markdown};
pub use error::ReportError;
pub use figure::{FigureImage, Image};
pub use findings::{Finding, finding_in_words, findings_in_words};
pub use gallery::gallery;
pub use html::{html_page, landing_page};
pub use json::{finding_json, finding_json_with_kernel, verdicts_json, verdicts_json_with_kernel};
pub use json_stream::VerdictsWriter;
pub use letter::{Envelope, Item, ItemChange, Letter};
#[cfg(feature = "pdf")]
pub use manuscript::Manuscript;
pub use sentence::{failure_in_full, own_steps, point, sentence_in_short};
pub use source::Source;
pub use tally::{Remarks, Row, Tally};
pub use text::counted;
pub use torse_typography::{MathPiece, Mathematics, Prose, Span, difference, in_words, plain};
#[cfg(feature = "pdf")]
pub use typeset::Typeset;
pub use verdict_lines::verdict_lines;
pub use write::write_file;

/// Whether a paper is a worked example of ours rather than a publication.
#[must_use]
pub fn is_worked_example(paper: &torse_verdicts::outcome::PaperOutcome) -> bool {
    torse_syntax::derivation::schema::is_worked(&paper.authors)
}
