//! The documents of a report, made in parallel; a PDF is set only if its manuscript changed.
//!
//! A list beside the documents has the fingerprint of the manuscript and the digest of the file for each PDF. A PDF is
//! kept if both agree: equal manuscripts give equal documents, and a file that was changed, truncated or removed has
//! another digest.

use crate::exit::Failure;
use crate::format::pretty_json;
use crate::terminal::Progress;
use rayon::prelude::*;
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;
use std::path::Path;
#[cfg(feature = "pdf")]
use torse_report::{Manuscript, digest};
use torse_report::{ReportError, write_file};

/// The list in the folder of a report.
const LIST: &str = "documents.json";

/// What a document is before it is written.
pub enum Made {
    /// The file itself.
    Bytes(Vec<u8>),
    /// A manuscript, to be set.
    #[cfg(feature = "pdf")]
    Manuscript(Manuscript),
}

impl Made {
    /// The bytes of the file; a manuscript is set for them.
    pub fn bytes(self) -> Result<Vec<u8>, ReportError> {
        match self {
            Made::Bytes(bytes) => Ok(bytes),
            #[cfg(feature = "pdf")]
            Made::Manuscript(manuscript) => manuscript.typeset()?.pdf(),
        }
    }
}

/// A file of a report, and how it is made.
pub struct Document<'a> {
    name: String,
    made: Box<dyn Fn() -> Result<Made, ReportError> + Sync + 'a>,
}

impl<'a> Document<'a> {
    /// The document of that file name.
    pub fn new(
        name: impl Into<String>,
        made: impl Fn() -> Result<Made, ReportError> + Sync + 'a,
    ) -> Self {
        Document {
            name: name.into(),
            made: Box::new(made),
        }
    }
}

/// The entry of a written PDF.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
struct Known {
    /// The fingerprint of its manuscript.
    manuscript: String,
    /// The digest of the file.
    file: String,
}

type List = BTreeMap<String, Known>;

/// Writes the documents into the folder, one step of progress each; returns the names of all its files, those that were
/// left as they are too.
pub fn write(
    folder: &Path,
    documents: &[Document],
    progress: &Progress,
) -> Result<Vec<String>, Failure> {
    let mut list = read_list(folder);
    let written: Vec<Result<Option<Known>, Failure>> = (documents.par_iter())
        .map(|document| {
            progress.doing(&document.name);
            let known = write_unless_kept(folder, document, list.get(&document.name))?;
            progress.step();
            Ok(known)
        })
        .collect();
    // Collected first, so that the first failure shown is always the same.
    for (document, known) in documents.iter().zip(written) {
        if let Some(known) = known? {
            list.insert(document.name.clone(), known);
        }
    }
    write_file(&folder.join(LIST), pretty_json(&list)?.as_bytes())?;
    let names = documents.iter().map(|document| document.name.clone());
    Ok(names.chain([LIST.to_owned()]).collect())
}

/// The list of a folder: empty if there is none, or one that cannot be read.
fn read_list(folder: &Path) -> List {
    let list = std::fs::read(folder.join(LIST)).unwrap_or_default();
    serde_json::from_slice(&list).unwrap_or_default()
}

/// Writes the document unless it is up to date; returns its entry, if it was made from a manuscript.
#[cfg_attr(not(feature = "pdf"), allow(unused_variables))]
fn write_unless_kept(
    folder: &Path,
    document: &Document,
    known: Option<&Known>,
) -> Result<Option<Known>, Failure> {
    let path = folder.join(&document.name);
    match (document.made)()? {
        Made::Bytes(bytes) => {
            write_file(&path, &bytes)?;
            Ok(None)
        }
        #[cfg(feature = "pdf")]
        Made::Manuscript(manuscript) => set_unless_kept(&path, manuscript, known).map(Some),
    }
}

/// Sets a manuscript unless its document is up to date; returns its entry.
#[cfg(feature = "pdf")]
fn set_unless_kept(
    path: &Path,
    manuscript: Manuscript,
    known: Option<&Known>,
) -> Result<Known, Failure> {
    let fingerprint = manuscript.fingerprint();
    let kept =
        known.filter(|known| known.manuscript == fingerprint && known.file == digest_of_file(path));
    if let Some(known) = kept {
        return Ok(known.clone());
    }
    let bytes = manuscript.typeset()?.pdf()?;
    write_file(path, &bytes)?;
    Ok(Known {
        manuscript: fingerprint,
        file: digest::digest([bytes.as_slice()]),
    })
}

/// The digest of a file; that of no bytes at all where there is none, which no PDF has.
#[cfg(feature = "pdf")]
fn digest_of_file(path: &Path) -> String {
    let bytes = std::fs::read(path).unwrap_or_default();
    digest::digest([bytes.as_slice()])
}
