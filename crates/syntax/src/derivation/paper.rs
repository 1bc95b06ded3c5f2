//! A paper: its head, what it declares, its claims and figures.

use super::claim::Claim;
use super::corrigendum::Corrigendum;
use super::declarations::Declarations;
use super::error::LookAlike;
use super::figure::Figure;
use super::look_alikes::look_alikes;
use super::schema::PaperHead;
use std::sync::Arc;

/// A paper with its claims in order.
#[derive(Debug, Clone)]
pub struct Paper {
    /// Who and what.
    pub head: PaperHead,
    /// What `paper.toml` declares.
    pub declarations: Arc<Declarations>,
    /// The claims.
    pub claims: Vec<Claim>,
    /// The faults of which its authors are told.
    pub corrigenda: Vec<Corrigendum>,
    /// Figures that are not the paper's.
    pub own_figures: Vec<Figure>,
}

impl Paper {
    /// The names of its formulas that a reader takes for others, each once a file.
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
