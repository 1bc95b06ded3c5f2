//! Texts of files, and places in them for error messages.

use crate::formula::Place;
use miette::{MietteError, NamedSource, SourceCode, SourceSpan, SpanContents};
use std::ops::Range;
use std::sync::Arc;
use toml::Spanned;

/// The name of the text of a single statement.
pub(super) const STATEMENT: &str = "the statement";
/// The name of the text of its setting.
pub(super) const SETTING: &str = "the setting";

/// A derivation file: its displayed name and its text.
#[derive(Debug)]
pub struct Source {
    /// The path relative to the folder of derivations, with `/`.
    pub name: String,
    /// The whole text.
    pub text: String,
    /// What was copied into it, if the text was composed of others; the first that contains a range is its origin.
    copies: Vec<Copied>,
}

/// A range of a composed text that comes from another text: errors in it are shown there.
#[derive(Debug)]
pub(super) struct Copied {
    /// The range in the composed text, with quotation marks.
    pub range: Range<usize>,
    /// The other text.
    pub source: Arc<Source>,
    /// The place in it.
    pub place: Place,
    /// Whether the value of the range is what stands at that place, and not made of it.
    pub is_verbatim: bool,
}

impl Source {
    /// A file with this name and text.
    #[must_use]
    pub fn new(name: impl Into<String>, text: impl Into<String>) -> Self {
        Self::composed(name, text.into(), vec![])
    }

    /// A text that was composed of others.
    pub(super) fn composed(name: impl Into<String>, text: String, copies: Vec<Copied>) -> Self {
        Self {
            name: name.into(),
            text,
            copies,
        }
    }

    /// The other text that a range was copied from.
    fn copied(&self, range: &Range<usize>) -> Option<&Copied> {
        let contains =
            |copy: &&Copied| copy.range.start <= range.start && range.end <= copy.range.end;
        self.copies.iter().find(contains)
    }
}

impl SourceCode for Source {
    fn read_span<'a>(
        &'a self,
        span: &SourceSpan,
        lines_before: usize,
        lines_after: usize,
    ) -> Result<Box<dyn SpanContents<'a> + 'a>, MietteError> {
        self.text.read_span(span, lines_before, lines_after)
    }
}

/// The last column at which a caret is drawn; beyond it the error points at the whole formula.
const MAX_COLUMN: usize = 30_000;

/// Where a formula comes from: a range of a file.
#[derive(Debug, Clone)]
pub struct Origin {
    /// The file.
    pub source: Arc<Source>,
    /// The byte of the file at which the text of the formula starts; `None` if the text is written with escapes, so
    /// that its bytes are not those of the file.
    start: Option<usize>,
    /// The range of the whole TOML value.
    whole: (usize, usize),
}

impl Origin {
    /// The origin of a string value of a file.
    #[must_use]
    pub fn from_spanned(source: &Arc<Source>, text: &Spanned<String>) -> Self {
        let range = text.span();
        if let Some(copied) = source.copied(&range) {
            return Self {
                source: Arc::clone(&copied.source),
                start: copied.is_verbatim.then_some(copied.place.start),
                whole: (copied.place.start, copied.place.end),
            };
        }
        let written = source.text.get(range.clone()).unwrap_or("");
        let inside = written
            .find(text.get_ref().as_str())
            .filter(|_| !text.get_ref().is_empty());
        Self {
            source: Arc::clone(source),
            start: inside.map(|offset| range.start + offset),
            whole: (range.start, range.end),
        }
    }

    /// The origin of a formula that is all of a text.
    #[must_use]
    pub fn all(source: &Arc<Source>) -> Self {
        Self {
            source: Arc::clone(source),
            start: Some(0),
            whole: (0, source.text.len()),
        }
    }

    /// The origin of the rest of the text from byte `offset` on.
    #[must_use]
    pub fn after(mut self, offset: usize) -> Self {
        self.start = self.start.map(|start| start + offset);
        self
    }

    /// The origin of a range of a file that is not a string value.
    #[must_use]
    pub fn range(source: &Arc<Source>, start: usize, end: usize) -> Self {
        let copied = source.copied(&(start..end));
        let (source, place) = match copied {
            Some(copied) => (&copied.source, copied.place),
            None => (source, Place { start, end }),
        };
        Self {
            source: Arc::clone(source),
            start: None,
            whole: (place.start, place.end),
        }
    }

    /// The range in the file that corresponds to a place in the formula.
    #[must_use]
    pub fn span(&self, place: Place) -> SourceSpan {
        match self.start {
            // Terminals do not show carets so far to the right.
            Some(start) if place.start > MAX_COLUMN => (start, 1).into(),
            Some(start) => (start + place.start, place.end.saturating_sub(place.start)).into(),
            None => (self.whole.0, self.whole.1.saturating_sub(self.whole.0)).into(),
        }
    }

    /// The text at a place, where the formula is written as it is read.
    #[must_use]
    pub fn text(&self, place: Place) -> Option<&str> {
        let start = self.start?;
        self.source.text.get(start + place.start..start + place.end)
    }

    /// Whether it was typed as a single statement or its setting, rather than in a file.
    #[must_use]
    pub fn is_typed(&self) -> bool {
        [STATEMENT, SETTING].contains(&self.source.name.as_str())
    }

    /// The file in the form that `miette` needs. The text is shared, since a file may have many mistakes.
    #[must_use]
    pub fn named_source(&self) -> NamedSource<Arc<Source>> {
        NamedSource::new(&self.source.name, Arc::clone(&self.source)).with_language("toml")
    }
}

/// The place that covers a whole text.
pub(super) fn whole(text: &Spanned<String>) -> Place {
    Place {
        start: 0,
        end: text.get_ref().len(),
    }
}
