//! Loads the papers of a folder one after the other, so that memory does not grow with their number.

use super::error::LoadError;
use super::folder;
use super::load::{Loaded, Reading, slugs};
use super::paper::Paper;
use super::references::{Known, referred};
use std::collections::{BTreeMap, BTreeSet};
use std::path::{Path, PathBuf};
use std::rc::Rc;

/// How many papers are remembered for the next one that refers to them.
const MAX_KNOWN: usize = 32;

/// A folder of papers that are loaded one by one: each with the mistakes, the claims and the references that
/// [`load_all`](super::load_all) gives it.
///
/// ```
/// use torse_syntax::derivation::{OneByOne, load_all};
/// # let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/../../derivations");
/// # let folder = std::path::Path::new(folder);
/// # if folder.exists() {
/// let mut papers = OneByOne::find(folder)?;
/// let slugs = papers.slugs().to_vec();
/// let claims: usize = slugs
///     .iter()
///     .flat_map(|slug| papers.load(slug).papers)
///     .map(|paper| paper.claims.len())
///     .sum();
/// let all = load_all(folder)?.papers;
/// assert_eq!(claims, all.iter().map(|paper| paper.claims.len()).sum());
/// # }
/// # Ok::<(), torse_syntax::derivation::LoadError>(())
/// ```
#[derive(Debug)]
pub struct OneByOne {
    folder: PathBuf,
    slugs: Vec<String>,
    /// What papers have to which others refer.
    known: BTreeMap<String, Rc<Known>>,
}

impl OneByOne {
    /// Finds the papers of a folder, and reads none.
    ///
    /// # Errors
    /// [`LoadError`] if the folder cannot be read or contains no paper.
    pub fn find(folder: &Path) -> Result<Self, LoadError> {
        Ok(Self {
            folder: folder.to_owned(),
            slugs: slugs(folder)?,
            known: BTreeMap::new(),
        })
    }

    /// The names of the papers, in order.
    #[must_use]
    pub fn slugs(&self) -> &[String] {
        &self.slugs
    }

    /// Whether there is a paper of this name.
    #[must_use]
    pub fn has(&self, slug: &str) -> bool {
        let found = self.slugs.binary_search_by(|own| own.as_str().cmp(slug));
        found.is_ok()
    }

    /// Loads the paper of this name: one or, where its head is wrong, none. Of the papers that it refers to, what they have for
    /// it is read.
    pub fn load(&mut self, slug: &str) -> Loaded {
        let mut reading = Reading::default();
        let paper = reading.paper(Some(slug), |name| folder::read(&self.folder, slug, name));
        let referred = paper.iter().flat_map(referred);
        let others: BTreeSet<String> = referred
            .filter_map(|id| Some(id.split_once('/')?.0.to_owned()))
            .filter(|other| other != slug && self.has(other))
            .collect();
        let others: Vec<Rc<Known>> = others.iter().map(|other| self.known(other)).collect();
        let others: Vec<&Known> = others.iter().map(Rc::as_ref).collect();
        reading.loaded(paper.into_iter().collect(), &others)
    }

    /// What a paper has for those that refer to it.
    fn known(&mut self, slug: &str) -> Rc<Known> {
        if let Some(known) = self.known.get(slug) {
            return Rc::clone(known);
        }
        let mut reading = Reading::default();
        let paper = reading.paper(Some(slug), |name| folder::read(&self.folder, slug, name));
        let papers: Vec<Paper> = paper.into_iter().collect();
        let known = Rc::new(reading.known(&papers));
        if self.known.len() >= MAX_KNOWN {
            self.known.clear();
        }
        self.known.insert(slug.to_owned(), Rc::clone(&known));
        known
    }
}
