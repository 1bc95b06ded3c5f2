//! A paper: its bibliographic head, its declarations, its claims and figures.

use super::claim::Claim;
use super::corrigendum::Corrigendum;
use super::declarations::Declarations;
use super::error::LookAlike;
use super::figure::Figure;
use super::look_alikes::look_alikes;
use super::schema::PaperHead;
use super::source::Source;
use std::sync::Arc;

/// A paper with its claims in order.
#[derive(Debug, Clone)]
pub struct Paper {
    /// The file `paper.toml`.
    pub source: Arc<Source>,
    /// The bibliographic head.
    pub head: PaperHead,
    /// The declarations of `paper.toml`.
    pub declarations: Arc<Declarations>,
    /// The claims.
    pub claims: Vec<Claim>,
    /// The errors that are reported to its authors.
    pub corrigenda: Vec<Corrigendum>,
    /// Figures that the paper does not have.
    pub own_figures: Vec<Figure>,
}

impl Paper {
    /// Names in its formulas that a reader would take for others, each once for a file.
    #[must_use]
    pub fn look_alikes(&self) -> Vec<LookAlike> {
        look_alikes(&self.declarations, &self.claims)
    }

    /// All figures: those of claims, then those of our own, each in file order.
    pub fn figures(&self) -> impl Iterator<Item = &Figure> {
        let drawn = self.claims.iter().filter_map(|claim| claim.figure.as_ref());
        drawn.chain(&self.own_figures)
    }
}
