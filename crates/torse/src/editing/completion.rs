//! What may stand at the cursor.

use super::cursor::{Spot, cursor};
use super::folder::EditedFolder;
use super::hover::{claim_id, meaning};
use super::keys::{TextKind, keys, text_kind, words};
use std::collections::BTreeMap;
use torse_syntax::derivation::declarations::Declarations;
use torse_syntax::formula::functions::{FUNCTIONS, described};

/// What a completion is.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[non_exhaustive]
pub enum CompletionKind {
    /// A function of the language.
    Function,
    /// A declared name.
    Name,
    /// A key of the schema, or the head of a table.
    Key,
    /// A word that a key takes, or the id of a claim.
    Word,
}

/// Something that may stand at the cursor.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct EditorCompletion {
    /// The text that is completed.
    pub label: String,
    /// What it is.
    pub kind: CompletionKind,
    /// What it means, in a line.
    pub detail: String,
}

impl EditedFolder {
    /// Returns what may stand at the byte `place` of the text of a file: in a formula the functions of the language and the
    /// names that are declared there; the keys of a table; the words or ids that a key takes. The text may be newer than the
    /// folder: names are those that were declared when the folder was read.
    ///
    /// ```
    /// # let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/../../derivations");
    /// # let folder = std::path::Path::new(folder);
    /// # if folder.exists() {
    /// let edited = torse::editing::EditedFolder::read(folder, |_| None)?;
    /// let text = "[[claim]]\nid = 'torses/new'\nkind = 'identity'\nstates = 'D(c";
    /// let offered = edited.completions("torses/planes.toml", text, text.len());
    /// let has = |label: &str| offered.iter().any(|offer| offer.label == label);
    /// assert!(has("integral") && has("c") && !has("printed"));
    /// let keys = edited.completions("torses/planes.toml", &text[..10], 10);
    /// assert!(keys.iter().any(|offer| offer.label == "printed"));
    /// # }
    /// # Ok::<(), torse::Error>(())
    /// ```
    #[must_use]
    pub fn completions(&self, file: &str, text: &str, place: usize) -> Vec<EditorCompletion> {
        let at = cursor(text, place);
        match at.spot {
            Spot::Header => offered(keys(&[]), CompletionKind::Key),
            Spot::Key => offered(keys(&at.path), CompletionKind::Key),
            Spot::Value | Spot::Comment => vec![],
            Spot::Text { .. } => {
                let words = words(&at.path);
                if !words.is_empty() {
                    return offered(
                        words.into_iter().map(|word| (word, "")),
                        CompletionKind::Word,
                    );
                }
                match text_kind(&at.path) {
                    TextKind::Words => vec![],
                    TextKind::Id => self.ids(),
                    TextKind::Formula => {
                        let id = claim_id(text, &at);
                        self.names(file, id.as_deref())
                    }
                }
            }
        }
    }

    /// The ids of all claims.
    fn ids(&self) -> Vec<EditorCompletion> {
        let claims = self.papers.iter().flat_map(|paper| &paper.claims);
        let ids = claims.map(|claim| (claim.entry.id.get_ref().as_str(), claim.entry.at.as_str()));
        offered(ids, CompletionKind::Word)
    }

    /// The names that a formula of a file may have, in this claim if it is known.
    fn names(&self, file: &str, claim: Option<&str>) -> Vec<EditorCompletion> {
        let functions = FUNCTIONS.iter().filter_map(|name| {
            let of = described(name)?;
            Some((*name, format!("{}: {}", of.call, of.says)))
        });
        let mut names = offered(functions, CompletionKind::Function);
        let declared: BTreeMap<&str, String> = self
            .declarations(file, claim)
            .into_iter()
            .flat_map(|all| {
                let named = all
                    .names()
                    .map(|name| name.split(['(', '[']).next().unwrap_or(name));
                named.filter_map(|name| Some((name, meaning(all, name)?)))
            })
            .collect();
        names.extend(offered(declared, CompletionKind::Name));
        names
    }

    /// The declarations that a claim sees; where it is not known, those of its file or of its paper.
    pub(super) fn declarations(&self, file: &str, claim: Option<&str>) -> Option<&Declarations> {
        let known = claim.and_then(|id| self.claim(file, id));
        let known = known.or_else(|| self.claims_in(file).next());
        match known {
            Some(claim) => Some(&claim.declarations),
            None => self.paper_of(file).map(|paper| &*paper.declarations),
        }
    }
}

fn offered<L: Into<String>, D: Into<String>>(
    offers: impl IntoIterator<Item = (L, D)>,
    kind: CompletionKind,
) -> Vec<EditorCompletion> {
    let offers = offers.into_iter().map(|(label, detail)| EditorCompletion {
        label: label.into(),
        kind,
        detail: detail.into(),
    });
    offers.collect()
}
