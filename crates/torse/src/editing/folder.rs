//! A folder of derivations as it stands in an editor, and what was found of its claims.

use super::notes::{EditorNote, claim_note, mistake_note, name_note, unreadable_note};
use crate::digests::digests;
use crate::error::Error;
use crate::verifier::Verifier;
use rayon::prelude::*;
use std::collections::{BTreeMap, BTreeSet};
use std::path::Path;
use std::sync::{Arc, Mutex, PoisonError};
use torse_syntax::derivation::{Claim, DerivationError, LoadError, Loaded, Paper, load_all_with};
use torse_verdicts::outcome::Outcome;

/// A folder of derivations, read with texts that are not saved.
///
/// ```
/// use std::collections::BTreeSet;
/// use torse::Verifier;
/// use torse::editing::{EditedFolder, EditorNoteLevel, KnownFindings};
/// # let folder = tempfile::TempDir::new()?;
/// # let folder = folder.path();
/// std::fs::create_dir(folder.join("p"))?;
/// std::fs::write(folder.join("p/paper.toml"),
///     "[paper]\nid = 'p'\ntitle = ''\nauthors = ''\nvenue = ''\nclaims = ['c.toml']\n[symbols]\nx = {}")?;
/// // This file is not saved yet.
/// let claims = "[[claim]]\nid = 'p/1'\nat = ''\nkind = 'identity'\nprinted = ''\nstates = '(x + 1)^2 == x^2 + 3*x + 1'";
/// let edited = EditedFolder::read(folder, |name| (name == "p/c.toml").then(|| claims.to_owned()))?;
/// let (papers, known) = (BTreeSet::from(["p".to_owned()]), KnownFindings::default());
/// edited.decide(&papers, &known, &Verifier::new(), &|| ())?;
/// let notes = edited.notes(&papers, &known);
/// assert_eq!((notes.len(), notes[0].level, notes[0].rule), (1, EditorNoteLevel::Warning, "misprint"));
/// assert_eq!(&claims[notes[0].range.clone()], "'(x + 1)^2 == x^2 + 3*x + 1'");
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug)]
pub struct EditedFolder {
    pub(super) papers: Vec<Paper>,
    errors: Vec<LoadError>,
    /// What each claim rests on.
    digests: BTreeMap<String, String>,
    /// Formulas that make no sense, by their claims: found while deciding.
    mistakes: Mutex<BTreeMap<String, Box<DerivationError>>>,
}

/// What was found of claims, by what they rest on; shared between threads.
#[derive(Debug, Default)]
pub struct KnownFindings(Mutex<BTreeMap<String, Arc<Outcome>>>);

impl KnownFindings {
    fn find(&self, digest: &str) -> Option<Arc<Outcome>> {
        let known = self.0.lock().unwrap_or_else(PoisonError::into_inner);
        known.get(digest).cloned()
    }

    fn add(&self, digest: String, outcome: Outcome) {
        let mut known = self.0.lock().unwrap_or_else(PoisonError::into_inner);
        known.insert(digest, Arc::new(outcome));
    }

    /// Forgets all findings but those of claims as they are in this folder; none where the folder has mistakes, since claims
    /// with mistakes are not read and will be back.
    pub fn keep_those_of(&self, folder: &EditedFolder) {
        if !folder.errors.is_empty() {
            return;
        }
        let current: BTreeSet<&String> = folder.digests.values().collect();
        let mut known = self.0.lock().unwrap_or_else(PoisonError::into_inner);
        known.retain(|digest, _| current.contains(digest));
    }
}

impl EditedFolder {
    /// Reads a folder of derivations; `unsaved` gives the text that stands for a file, by its name with that of its
    /// paper's folder, such as `my-paper/claims.toml`. Mistakes in files are [`notes`](Self::notes).
    ///
    /// # Errors
    /// [`Error::Load`] where the folder cannot be read or has no paper.
    pub fn read(folder: &Path, unsaved: impl Fn(&str) -> Option<String>) -> Result<Self, Error> {
        let loaded: Loaded = load_all_with(folder, unsaved)?;
        let digests = digests(&loaded.papers);
        let digests = digests.into_iter().map(|own| (own.id, own.digest));
        Ok(Self {
            digests: digests.collect(),
            papers: loaded.papers,
            errors: loaded.errors,
            mistakes: Mutex::default(),
        })
    }

    /// Decides the claims of these papers that are not known, on all threads, in file order as far as threads are free.
    /// `progress` is called after each.
    ///
    /// # Errors
    /// [`Error::Cancelled`] where the verifier was stopped; what was found until then is known.
    pub fn decide(
        &self,
        papers: &BTreeSet<String>,
        known: &KnownFindings,
        verifier: &Verifier<'_>,
        progress: &(dyn Fn() + Sync),
    ) -> Result<(), Error> {
        let wanted: Vec<(&Paper, &Claim, &String)> = self
            .claims(papers)
            .filter_map(|(paper, claim)| {
                let digest = self.digests.get(claim.entry.id.get_ref())?;
                known
                    .find(digest)
                    .is_none()
                    .then_some((paper, claim, digest))
            })
            .collect();
        let decided = wanted.par_iter().with_max_len(1);
        decided.try_for_each(|(paper, claim, digest)| {
            match verifier.claim(&paper.head.id, claim) {
                Ok(outcome) => known.add((*digest).clone(), outcome),
                Err(Error::Formula(mistake)) => {
                    let mut mistakes = self.mistakes.lock().unwrap_or_else(PoisonError::into_inner);
                    mistakes.insert(claim.entry.id.get_ref().clone(), mistake);
                }
                Err(error) => return Err(error),
            }
            progress();
            Ok(())
        })
    }

    /// Returns what is to be shown beside the texts of these papers: mistakes, names that are taken for others, and what
    /// is known of their claims. A mistake that several claims share is one note.
    #[must_use]
    pub fn notes(&self, papers: &BTreeSet<String>, known: &KnownFindings) -> Vec<EditorNote> {
        let shown = |note: &EditorNote| {
            let folder = note.source.name.split('/').next();
            folder.is_some_and(|folder| papers.contains(folder))
        };
        let mut notes: Vec<EditorNote> = vec![];
        let errors = self.errors.iter().filter_map(|error| match error {
            LoadError::Derivation(error) => Some(mistake_note(error)),
            _ => self.unreadable(error),
        });
        let mistakes = self.mistakes.lock().unwrap_or_else(PoisonError::into_inner);
        let mistakes = errors.chain(mistakes.values().map(|error| mistake_note(error)));
        for note in mistakes.filter(shown) {
            if !notes.contains(&note) {
                notes.push(note);
            }
        }
        let named = self
            .papers
            .iter()
            .filter(|paper| papers.contains(&paper.head.id));
        notes.extend(
            named
                .flat_map(Paper::look_alikes)
                .map(|name| name_note(&name)),
        );
        notes.extend(self.claims(papers).filter_map(|(_, claim)| {
            let outcome = self.outcome(claim, known)?;
            claim_note(claim, &outcome)
        }));
        notes
    }

    /// The note of a file that cannot be read, at the place of `paper.toml` that names it; none where no paper does.
    fn unreadable(&self, error: &LoadError) -> Option<EditorNote> {
        let LoadError::Unreadable { path, .. } = error else {
            return None;
        };
        let path = path.replace('\\', "/");
        self.papers.iter().find_map(|paper| {
            let (folder, _) = paper.source.name.split_once('/')?;
            let mut named = paper.head.claims.iter();
            let named =
                named.find(|name| path.ends_with(&format!("{folder}/{}", name.get_ref())))?;
            Some(unreadable_note(&paper.source, named.span(), error))
        })
    }

    /// What is known of a claim.
    pub(super) fn outcome(&self, claim: &Claim, known: &KnownFindings) -> Option<Arc<Outcome>> {
        known.find(self.digests.get(claim.entry.id.get_ref())?)
    }

    fn claims(&self, papers: &BTreeSet<String>) -> impl Iterator<Item = (&Paper, &Claim)> {
        let named = self
            .papers
            .iter()
            .filter(|paper| papers.contains(&paper.head.id));
        named.flat_map(|paper| paper.claims.iter().map(move |claim| (paper, claim)))
    }

    /// The claim of a file with this id.
    pub(super) fn claim(&self, file: &str, id: &str) -> Option<&Claim> {
        self.claims_in(file)
            .find(|claim| claim.entry.id.get_ref() == id)
    }

    /// The claims of a file, in its order.
    pub(super) fn claims_in(&self, file: &str) -> impl Iterator<Item = &Claim> {
        let claims = self.papers.iter().flat_map(|paper| &paper.claims);
        claims.filter(move |claim| claim.origin.source.name == file)
    }

    /// The paper that a file belongs to.
    pub(super) fn paper_of(&self, file: &str) -> Option<&Paper> {
        let (folder, _) = file.split_once('/')?;
        self.papers
            .iter()
            .find(|paper| paper.source.name.split('/').next() == Some(folder))
    }
}
