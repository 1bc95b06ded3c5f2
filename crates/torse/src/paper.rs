//! Papers: folders of derivation files, or texts that stand for them.

use crate::error::Error;
use crate::explanation::{Explanation, full};
use crate::selection;
use crate::verifier::{Verification, Verifier};
use std::path::Path;
use std::sync::Arc;
use torse_syntax::derivation::{self, LoadError, Source};

/// A paper that was read: its claims are well formed.
#[derive(Debug, Clone)]
pub struct Paper {
    read: derivation::Paper,
}

impl Paper {
    /// Reads the paper of a folder, that with a `paper.toml`.
    ///
    /// # Errors
    /// [`Error::Load`] with the first mistake of its files.
    ///
    /// ```
    /// # let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/../../derivations/torses");
    /// # if std::path::Path::new(folder).exists() {
    /// let paper = torse::Paper::open(folder)?;
    /// // The claims whose ids begin so: that of the turn, and one with a slip.
    /// let verified = paper.only(&["torses/ruled.turn"])?.verify()?;
    /// assert_eq!(verified.outcomes().count(), 2);
    /// # }
    /// # Ok::<(), torse::Error>(())
    /// ```
    pub fn open(folder: impl AsRef<Path>) -> Result<Self, Error> {
        Ok(Self {
            read: derivation::open(folder.as_ref())?,
        })
    }

    /// Reads a paper from texts: `file` gives the text of a file of its folder, beginning with `paper.toml`.
    ///
    /// # Errors
    /// [`Error::Load`] with the first mistake.
    pub fn read(file: impl Fn(&str) -> Option<String>) -> Result<Self, Error> {
        let read = derivation::paper(|name| match file(name) {
            Some(text) => Ok(Arc::new(Source::new(name, text))),
            None => Err(LoadError::Unreadable {
                path: name.to_owned(),
                reason: "there is no such file".to_owned(),
            }),
        })?;
        Ok(Self { read })
    }

    /// Its id, with which the ids of its claims begin.
    #[must_use]
    pub fn id(&self) -> &str {
        &self.read.head.id
    }

    /// Its title.
    #[must_use]
    pub fn title(&self) -> &str {
        &self.read.head.title
    }

    /// The ids of its claims, in the order of its files.
    pub fn ids(&self) -> impl Iterator<Item = &str> {
        let claims = self.read.claims.iter();
        claims.map(|claim| claim.entry.id.get_ref().as_str())
    }

    /// The same paper with just the claims that these names mean: an id, or the beginning of some. No name means all.
    ///
    /// # Errors
    /// [`Error::UnknownName`].
    pub fn only(&self, names: &[&str]) -> Result<Self, Error> {
        let names: Vec<String> = names.iter().map(|name| (*name).to_owned()).collect();
        let mut kept = selection::select(vec![self.read.clone()], &names, &[])?;
        let read = kept.pop().unwrap_or_else(|| derivation::Paper {
            claims: vec![],
            ..self.read.clone()
        });
        Ok(Self { read })
    }

    /// The paper with all its parts.
    #[must_use]
    pub fn parts(&self) -> &derivation::Paper {
        &self.read
    }

    /// Decides all claims.
    ///
    /// # Errors
    /// None but [`Error::Cancelled`], which nobody asks for here: formulas that make no sense are
    /// [`Verification::mistakes`].
    pub fn verify(&self) -> Result<Verification, Error> {
        self.verify_by(&Verifier::new())
    }

    /// Decides all claims, with a budget and watched as `verifier` says.
    ///
    /// # Errors
    /// [`Error::Cancelled`].
    pub fn verify_by(&self, verifier: &Verifier<'_>) -> Result<Verification, Error> {
        verifier.verify(std::slice::from_ref(&self.read))
    }

    /// Explains one claim of the paper, by its id or the beginning of one: what is printed, what is true, why, and what
    /// rests on it.
    ///
    /// # Errors
    /// [`Error::UnknownName`], [`Error::Ambiguous`], [`Error::Formula`] where it makes no sense.
    ///
    /// ```
    /// let paper = torse::Paper::read(|name| match name {
    ///     "paper.toml" => Some("[paper]\nid = 'p'\ntitle = 'T'\nauthors = ''\nvenue = ''\nclaims = ['c.toml']\n[symbols]\nx = { in = '(-inf, inf)' }".to_owned()),
    ///     "c.toml" => Some("[[claim]]\nid = 'p/square'\nat = 'eq. (1)'\nkind = 'identity'\nprinted = ''\nstates = '(x + 1)^2 == x^2 + 3*x + 1'".to_owned()),
    ///     _ => None,
    /// })?;
    /// let note = paper.explain("p/square")?;
    /// assert!(note.text("verdict").is_some_and(|text| text.starts_with("misprint")));
    /// assert_eq!(note.text("place"), Some("eq. (1)"));
    /// # Ok::<(), torse::Error>(())
    /// ```
    pub fn explain(&self, name: &str) -> Result<Explanation, Error> {
        self.explain_by(name, &Verifier::new())
    }

    /// Explains one claim, decided with a budget and watched as `verifier` says.
    ///
    /// # Errors
    /// As [`Paper::explain`], and [`Error::Cancelled`].
    pub fn explain_by(&self, name: &str, verifier: &Verifier<'_>) -> Result<Explanation, Error> {
        let papers = std::slice::from_ref(&self.read);
        let wanted = selection::select_one(papers, name)?;
        let verified = verifier.verify(&[wanted])?;
        let outcome = verified.outcomes().next();
        match (verified.papers.first(), outcome) {
            (Some(paper), Some(outcome)) => {
                let (resting, _) = crate::explanation::Resting::on(outcome, papers, verifier)?;
                Ok(full(paper, outcome, resting, false, usize::MAX))
            }
            _ => {
                let mistake = verified.mistakes.into_iter().next();
                Err(mistake.map_or(Error::Cancelled, |mistake| Box::new(mistake).into()))
            }
        }
    }
}
