//! Errors while a report is written.

use std::path::PathBuf;
use thiserror::Error;

/// Why a report could not be written.
#[derive(Debug, Error)]
#[non_exhaustive]
pub enum ReportError {
    /// The typesetter refused the document; the first messages are its own.
    #[error("typesetting {document} failed: {}", messages.join("; "))]
    Typeset {
        /// Which document was being set.
        document: &'static str,
        /// The typesetter's messages, in its order.
        messages: Vec<String>,
    },
    /// The data of the report could not be written as JSON.
    #[error("the data of the report cannot be written as JSON")]
    Json(#[from] serde_json::Error),
    /// The table of the verdicts could not be written.
    #[error("the table of the verdicts cannot be written")]
    Table(#[from] csv::Error),
    /// The document does not have the requested page.
    #[error("page {page} does not exist: the document has {pages} (counted from 0)")]
    NoSuchPage {
        /// The requested page, from 0.
        page: usize,
        /// How many pages there are.
        pages: usize,
    },
    /// The resolution gives no usable picture.
    #[error("{pixels_per_point} pixels a point is not between 0.1 and 20")]
    Resolution {
        /// The requested resolution.
        pixels_per_point: f32,
    },
    /// A page could not be encoded as a PNG.
    #[error("page {page} cannot be encoded as PNG: {reason}")]
    Png {
        /// The page, from 0.
        page: usize,
        /// The encoder's message.
        reason: String,
    },
    /// A label of a picture does not parse.
    #[error("a label of a picture cannot be shown")]
    Label(#[from] torse_plot::FigureError),
    /// An output that is written in pieces failed.
    #[error("cannot write the output")]
    Stream(#[from] std::io::Error),
    /// A file could not be written.
    #[error("cannot write {}", path.display())]
    Write {
        /// The file.
        path: PathBuf,
        /// The reason.
        source: std::io::Error,
    },
}
