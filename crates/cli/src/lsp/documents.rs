//! The texts that an editor has open.

use super::lines::Lines;
use lsp_types::{TextDocumentContentChangeEvent, Uri};
use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use url::Url;

/// Where a file belongs: the folder of derivations, and its name with that of its paper's folder.
#[derive(Debug, Clone, PartialEq, Eq, PartialOrd, Ord)]
pub struct Membership {
    /// The folder of derivations.
    pub derivations: PathBuf,
    /// The folder of the paper, without the path to it.
    pub paper: String,
    /// The file, `my-paper/claims.toml`.
    pub name: String,
}

/// An open text.
#[derive(Debug, Clone)]
pub struct Document {
    /// Its address, as the editor writes it.
    pub uri: Uri,
    /// Its file; none for an address that is none of a file.
    path: Option<PathBuf>,
    /// The text.
    pub text: String,
}

/// The open texts, by their addresses.
#[derive(Debug, Default)]
pub struct Documents(BTreeMap<String, Document>);

/// Why a change cannot be made.
#[derive(Debug, PartialEq, Eq, thiserror::Error)]
pub enum ChangeError {
    /// The text is not open.
    #[error("{0} is not open")]
    NotOpen(String),
    /// A range ends before it begins.
    #[error("a change of {0} ends before it begins")]
    Reversed(String),
}

impl Documents {
    /// Takes a text that was opened.
    pub fn open(&mut self, uri: Uri, text: String) {
        let path = file_path(&uri);
        self.0
            .insert(uri.as_str().to_owned(), Document { uri, path, text });
    }

    /// Forgets a text that was closed.
    pub fn close(&mut self, uri: &Uri) {
        self.0.remove(uri.as_str());
    }

    /// Changes a text, one edit after the other; all of them or none.
    ///
    /// # Errors
    /// [`ChangeError`].
    pub fn change(
        &mut self,
        uri: &Uri,
        changes: Vec<TextDocumentContentChangeEvent>,
    ) -> Result<(), ChangeError> {
        let name = || uri.as_str().to_owned();
        let document = self.0.get_mut(uri.as_str());
        let document = document.ok_or_else(|| ChangeError::NotOpen(name()))?;
        let mut text = document.text.clone();
        for change in changes {
            match change.range {
                None => text = change.text,
                Some(range) => {
                    let lines = Lines::new(&text);
                    let (start, end) = (lines.byte(range.start), lines.byte(range.end));
                    if end < start {
                        return Err(ChangeError::Reversed(name()));
                    }
                    text.replace_range(start..end, &change.text);
                }
            }
        }
        document.text = text;
        Ok(())
    }

    /// Returns the open text at an address.
    pub fn get(&self, uri: &Uri) -> Option<&Document> {
        self.0.get(uri.as_str())
    }

    /// Returns all of them.
    pub fn all(&self) -> impl Iterator<Item = &Document> {
        self.0.values()
    }

    /// Returns where an open text belongs: to the nearest folder above it with a `paper.toml`, saved or open.
    pub fn membership(&self, document: &Document) -> Option<Membership> {
        let path = document.path.as_deref()?;
        let folder = path.ancestors().skip(1).find(|folder| {
            let head = folder.join("paper.toml");
            head.is_file() || self.all().any(|open| open.path.as_deref() == Some(&head))
        })?;
        let derivations = folder.parent()?;
        let inside = path.strip_prefix(derivations).ok()?;
        let parts: Vec<String> = inside
            .iter()
            .map(|part| part.to_string_lossy().into_owned())
            .collect();
        Some(Membership {
            derivations: derivations.to_owned(),
            paper: parts.first()?.clone(),
            name: parts.join("/"),
        })
    }

    /// Returns the address of a file: that of the open text, as the editor writes it, or one made of the path.
    pub fn address(&self, path: &Path) -> Option<Uri> {
        let mut open = self.all().filter(|open| open.path.as_deref() == Some(path));
        if let Some(document) = open.next() {
            return Some(document.uri.clone());
        }
        Url::from_file_path(path).ok()?.as_str().parse().ok()
    }
}

/// The file of an address.
pub fn file_path(uri: &Uri) -> Option<PathBuf> {
    let url = Url::parse(uri.as_str()).ok()?;
    (url.scheme() == "file").then(|| url.to_file_path().ok())?
}

#[cfg(test)]
mod tests {
    use super::*;
    use lsp_types::{Position, Range};

    fn uri() -> Uri {
        "file:///a%20b/p/c.toml"
            .parse()
            .unwrap_or_else(|_| unreachable!())
    }

    fn change(range: Option<[u32; 4]>, text: &str) -> TextDocumentContentChangeEvent {
        let range = range.map(|[line, character, end_line, end]| Range {
            start: Position { line, character },
            end: Position {
                line: end_line,
                character: end,
            },
        });
        TextDocumentContentChangeEvent {
            range,
            range_length: None,
            text: text.to_owned(),
        }
    }

    #[test]
    fn changes_are_made_one_after_the_other_in_units_of_utf_16() {
        let mut open = Documents::default();
        open.open(uri(), "𝜇 = 1\nb".to_owned());
        let edits = vec![
            change(Some([0, 2, 0, 2]), "a"),
            change(Some([0, 3, 1, 0]), "\n"),
            change(Some([9, 9, 9, 9]), "!"),
        ];
        assert_eq!(open.change(&uri(), edits), Ok(()));
        assert_eq!(
            open.get(&uri()).map(|own| own.text.as_str()),
            Some("𝜇a\nb!")
        );
        assert_eq!(open.change(&uri(), vec![change(None, "new")]), Ok(()));
        assert_eq!(open.get(&uri()).map(|own| own.text.as_str()), Some("new"));
    }

    #[test]
    fn a_change_that_cannot_be_made_changes_nothing() {
        let mut open = Documents::default();
        let edits = || vec![change(None, "x"), change(Some([0, 1, 0, 0]), "y")];
        let name = uri().as_str().to_owned();
        assert_eq!(
            open.change(&uri(), edits()),
            Err(ChangeError::NotOpen(name.clone()))
        );
        open.open(uri(), "abc".to_owned());
        assert_eq!(
            open.change(&uri(), edits()),
            Err(ChangeError::Reversed(name))
        );
        assert_eq!(open.get(&uri()).map(|own| own.text.as_str()), Some("abc"));
    }

    #[test]
    fn a_file_belongs_to_the_folder_with_the_head_of_a_paper() {
        let mut open = Documents::default();
        open.open(uri(), String::new());
        let document = open.get(&uri()).cloned();
        assert_eq!(document.as_ref().and_then(|own| open.membership(own)), None);
        let head = "file:///a%20b/p/paper.toml".parse();
        open.open(head.unwrap_or_else(|_| unreachable!()), String::new());
        let found = document.and_then(|own| open.membership(&own));
        let found = found.map(|own| (own.derivations, own.paper, own.name));
        let wanted = (PathBuf::from("/a b"), "p".to_owned(), "p/c.toml".to_owned());
        assert_eq!(found, Some(wanted));
    }
}
