//! Code beside the formula.

use crate::error::Error;
use crate::paper::Paper;
use crate::selection;
use crate::verifier::Verifier;
use torse_code::{CodeQuestion, Comparison};
use torse_syntax::derivation::Claim;

/// Compares a function of Python or Rust with the printed side of a claim, named by its id or the beginning of one: are they equal, and
/// if not, where do they differ, and which one change of the code or of the print makes them equal?
///
/// # Errors
/// [`Error::UnknownName`] and [`Error::Ambiguous`] for the claim; [`Error::Formula`] for code that is not read, with its place.
///
/// ```
/// use torse::{CodeQuestion, CodeVerdict};
/// let paper = torse::Paper::read(|name| match name {
///     "paper.toml" => Some("[paper]\nid = 'p'\ntitle = ''\nauthors = ''\nvenue = ''\nclaims = ['c.toml']\n[symbols]\nx = { in = '(-inf, inf)' }".to_owned()),
///     "c.toml" => Some("[[claim]]\nid = 'p/cubes'\nat = 'eq. (1)'\nkind = 'identity'\nprinted = ''\nstates = '(x - 1)^3 == x^3 - 3*x^2 + 3*x - 1'".to_owned()),
///     _ => None,
/// })?;
/// let horner = "def cube(x):\n    return ((x - 3)*x + 3)*x - 1\n";
/// let equal = torse::compare(&paper, "p/cubes", &CodeQuestion::new("cube.py", horner, "cube"))?;
/// assert_eq!(equal.verdict, CodeVerdict::Equal);
///
/// let slip = "fn cube(x: f64) -> f64 {\n    ((x - 3.0) * x + 3.0) * x + 1.0\n}\n";
/// let different = torse::compare(&paper, "p/cubes", &CodeQuestion::new("cube.rs", slip, "cube"))?;
/// assert_eq!(different.verdict, CodeVerdict::Different);
/// let edit = different.code_edit.ok_or("one change of the code is enough")?;
/// assert_eq!(edit.line, 2);
/// assert_eq!(edit.line_then.as_deref(), Some("    ((x - 3.0) * x + 3.0) * x - 1.0"));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn compare(paper: &Paper, claim: &str, question: &CodeQuestion) -> Result<Comparison, Error> {
    let papers = std::slice::from_ref(paper.parts());
    let wanted = selection::select_one(papers, claim)?;
    let found = wanted.claims.first().ok_or_else(|| Error::UnknownName {
        name: claim.to_owned(),
        help: String::new(),
    })?;
    Verifier::new().compare(paper.id(), found, question)
}

impl Verifier<'_> {
    /// Compares a function with a claim of the paper with this id, as [`compare`].
    ///
    /// # Errors
    /// As [`compare`], and [`Error::Cancelled`].
    pub fn compare(
        &self,
        paper: &str,
        claim: &Claim,
        question: &CodeQuestion,
    ) -> Result<Comparison, Error> {
        let budget = self.budget().units();
        Ok(self.work(|| torse_code::compare(budget, paper, claim, question))??)
    }
}
