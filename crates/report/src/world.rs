//! The typesetter's world: templates, data, pictures and fonts, all in memory.
//!
//! It reads nothing from the machine: the fonts come with the typesetter, and the date is fixed, so the same data give
//! the same document everywhere.

use std::{collections::HashMap, path::PathBuf, sync::LazyLock};
use typst::{
    Library, LibraryExt, World,
    diag::{FileError, FileResult, SourceDiagnostic, Warned},
    foundations::{Bytes, Datetime, Duration, Output},
    syntax::{FileId, RootedPath, Source, VirtualPath, VirtualRoot},
    text::{Font, FontBook},
    utils::LazyHash,
};

use crate::ReportError;

/// The fonts and the standard library, made once for all documents.
struct Shared {
    library: LazyHash<Library>,
    book: LazyHash<FontBook>,
    fonts: Vec<Font>,
}

static SHARED: LazyLock<Shared> = LazyLock::new(|| {
    let fonts: Vec<Font> = typst_assets::fonts()
        .flat_map(|data| Font::iter(Bytes::new(data)))
        .collect();
    Shared {
        library: LazyHash::new(Library::builder().build()),
        book: LazyHash::new(FontBook::from_fonts(&fonts)),
        fonts,
    }
});

/// Whether a font at hand has a glyph for the character.
pub(crate) fn has_glyph(character: char) -> bool {
    character == '\n'
        || SHARED
            .fonts
            .iter()
            .any(|font| font.info().coverage.contains(u32::from(character)))
}

/// A main source with the templates and files that it may read.
pub(crate) struct MemoryWorld {
    main: Source,
    sources: HashMap<FileId, Source>,
    files: HashMap<FileId, Bytes>,
}

impl MemoryWorld {
    /// Makes a world whose document is `main`; it may import the `templates` and read the `files`, both given by name
    /// and content.
    pub(crate) fn new(
        main: &str,
        templates: &[(&str, &str)],
        files: impl IntoIterator<Item = (String, Vec<u8>)>,
    ) -> Result<Self, ReportError> {
        let mut sources = HashMap::new();
        for (name, text) in templates {
            let id = file_id(name)?;
            sources.insert(id, Source::new(id, (*text).to_owned()));
        }
        let mut contents = HashMap::new();
        for (name, bytes) in files {
            contents.insert(file_id(&name)?, Bytes::new(bytes));
        }
        Ok(MemoryWorld {
            main: Source::new(file_id("main.typ")?, main.to_owned()),
            sources,
            files: contents,
        })
    }

    /// Compiles the document; `name` names it in errors.
    pub(crate) fn compile<D: Output>(&self, name: &'static str) -> Result<D, ReportError> {
        let Warned {
            output,
            warnings: _,
        } = typst::compile::<D>(self);
        output.map_err(|diagnostics| refused(name, &diagnostics))
    }
}

/// Makes the error for a document that the typesetter refused.
pub(crate) fn refused(document: &'static str, diagnostics: &[SourceDiagnostic]) -> ReportError {
    const SHOWN: usize = 5;
    let messages = diagnostics
        .iter()
        .take(SHOWN)
        .map(|own| own.message.to_string())
        .collect();
    ReportError::Typeset { document, messages }
}

fn file_id(name: &str) -> Result<FileId, ReportError> {
    let path = VirtualPath::new(name).map_err(|reason| ReportError::Typeset {
        document: "a file name",
        messages: vec![format!("{name}: {reason}")],
    })?;
    Ok(RootedPath::new(VirtualRoot::Project, path).intern())
}

impl World for MemoryWorld {
    fn library(&self) -> &LazyHash<Library> {
        &SHARED.library
    }

    fn book(&self) -> &LazyHash<FontBook> {
        &SHARED.book
    }

    fn main(&self) -> FileId {
        self.main.id()
    }

    fn source(&self, id: FileId) -> FileResult<Source> {
        if id == self.main.id() {
            return Ok(self.main.clone());
        }
        self.sources.get(&id).cloned().ok_or_else(|| not_found(id))
    }

    fn file(&self, id: FileId) -> FileResult<Bytes> {
        self.files.get(&id).cloned().ok_or_else(|| not_found(id))
    }

    fn font(&self, index: usize) -> Option<Font> {
        SHARED.fonts.get(index).cloned()
    }

    fn today(&self, _offset: Option<Duration>) -> Option<Datetime> {
        fixed_date()
    }
}

/// The date of every document: no clock is read, so equal data give equal bytes.
pub(crate) fn fixed_date() -> Option<Datetime> {
    Datetime::from_ymd_hms(2026, 1, 1, 0, 0, 0)
}

fn not_found(id: FileId) -> FileError {
    FileError::NotFound(PathBuf::from(id.vpath().get_with_slash()))
}
