//! Letters of corrections: to the authors of a paper, or to its journal.

use crate::error::Error;
use crate::verifier::Verification;
use torse_report::model::Report;
use torse_report::{Envelope, erratum_latex, erratum_markdown};
use torse_verdicts::outcome::PaperOutcome;

/// The corrections of a paper, one item for each fault: its place, the printed text and what it should say, why, and an
/// exact counterexample. As `torse erratum` writes it, but for the lines about the files and about the kernel.
///
/// ```
/// use torse::{Paper, report::Envelope};
/// let paper = Paper::read(|name| match name {
///     "paper.toml" => Some("[paper]\nid = 'p'\ntitle = 'Squares'\nauthors = 'A. Uthor'\nvenue = ''\nclaims = ['c.toml']\n[symbols]\nx = { in = '(-inf, inf)' }".to_owned()),
///     "c.toml" => Some("[[claim]]\nid = 'p/square'\nat = 'eq. (1)'\nkind = 'identity'\nprinted = '(x + 1)^2 = x^2 + 3x + 1'\nstates = '(x + 1)^2 == x^2 + 3*x + 1'".to_owned()),
///     _ => None,
/// })?;
/// let letters = paper.verify()?.letters(&Envelope::default())?;
/// let text = letters[0].markdown();
/// assert!(text.contains("eq. (1)") && text.contains("Squares"), "{text}");
/// # Ok::<(), torse::Error>(())
/// ```
#[derive(Debug, Clone)]
pub struct CorrectionLetter {
    report: Report,
    envelope: Envelope,
}

impl CorrectionLetter {
    /// Makes the letter about a decided paper. Without a sender it is marked as a draft.
    ///
    /// # Errors
    /// [`Error::NothingDecided`] where the letter would say nothing.
    pub fn new(paper: &PaperOutcome, envelope: Envelope) -> Result<Self, Error> {
        let report = Report::new(paper, &[]);
        match report.letter.scope.decided {
            0 => Err(Error::NothingDecided {
                paper: paper.slug.clone(),
            }),
            _ => Ok(Self { report, envelope }),
        }
    }

    /// Returns the letter as Markdown.
    #[must_use]
    pub fn markdown(&self) -> String {
        erratum_markdown(&self.report, &self.envelope)
    }

    /// Returns the letter as a document of LaTeX.
    #[must_use]
    pub fn latex(&self) -> String {
        erratum_latex(&self.report, &self.envelope)
    }

    /// Returns the letter as PDF.
    ///
    /// # Errors
    /// [`Error::Report`] where it cannot be set.
    #[cfg(feature = "pdf")]
    pub fn pdf(&self) -> Result<Vec<u8>, Error> {
        let manuscript = torse_report::Manuscript::erratum(&self.report, &self.envelope)?;
        Ok(manuscript.typeset()?.pdf()?)
    }
}

impl Verification {
    /// Returns the letter about each paper.
    ///
    /// # Errors
    /// [`Error::Formula`] with the first of the [`mistakes`](Verification::mistakes), since a letter must not leave out a
    /// correction; [`Error::NothingDecided`].
    pub fn letters(&self, envelope: &Envelope) -> Result<Vec<CorrectionLetter>, Error> {
        if let Some(mistake) = self.mistakes.first() {
            return Err(Error::Formula(Box::new(mistake.clone())));
        }
        let papers = self.papers.iter();
        papers
            .map(|paper| CorrectionLetter::new(paper, envelope.clone()))
            .collect()
    }
}
