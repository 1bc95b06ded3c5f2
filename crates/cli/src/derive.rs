//! `torse derive`: end point derivatives and join conditions of a basis family.

use crate::derivations::Derivations;
use crate::exit::{Exit, Failure};
use crate::{terminal, watchdog};
use clap::{Args, ValueEnum};
use torse::selection;
use torse_syntax::derivation::Paper;
use torse_syntax::derivation::declarations::Declarations;
use torse_verdicts::derive::{
    Derivation, DeriveError, Geometric, Language, Shape, continuity, end_derivatives, geometric,
    print,
};

/// Derive formulas of a basis family for every degree at once.
///
/// The family is any `[basis.NAME]` of a derivation file. Without `--join`, the result is the derivatives at both ends
/// of a curve; with it, the control points of the next curve or plane family. Degrees and shape parameters stay
/// symbols. The result lists the divisors that must not vanish.
#[derive(Args)]
#[command(after_help = EXAMPLES)]
pub struct Derive {
    /// The paper whose file declares the basis
    #[arg(value_name = "PAPER")]
    paper: String,
    /// The basis, NAME in `[basis.NAME]`
    #[arg(value_name = "BASIS")]
    basis: String,
    /// Set the highest derivative; with `--join c`, the order of continuity
    #[arg(long, value_name = "N", default_value_t = 3)]
    order: u8,
    /// Set the degree; required for a basis whose step depends on the index [default: a symbol]
    #[arg(long, value_name = "K")]
    degree: Option<u8>,
    /// Give every point a weight
    #[arg(long)]
    rational: bool,
    /// Solve for the next control points of a join instead
    #[arg(long, value_enum, value_name = "CONDITION")]
    join: Option<Join>,
    /// Set the language of the result
    #[arg(long, value_enum, default_value_t = Output::Text)]
    language: Output,
    #[command(flatten)]
    derivations: Derivations,
}

const EXAMPLES: &str = "\
Examples:
  torse derive gbt-developable g --order 2
  torse derive gbt-surfaces f --join c --order 3
  torse derive gbt-developable g --join beta --language latex
  torse derive bezier B --join c --language sympy > join.py
  torse derive splines U --degree 3 --join c --order 2
  torse derive bezier B --rational --order 2";

#[derive(Clone, Copy, ValueEnum)]
enum Join {
    /// Equal derivatives up to the order (at most 3)
    C,
    /// A common tangent: F1' = gamma F'
    G1,
    /// Farin-Boehm G2: equal first and second derivatives in homogeneous coordinates
    FarinBoehm,
    /// G2 beta constraints: F1' = gamma F', F1'' = gamma^2 F'' + lambda F'
    Beta,
}

#[derive(Clone, Copy, ValueEnum)]
enum Output {
    /// The language of derivation files
    Text,
    /// An align* environment
    Latex,
    /// An aligned equation of Typst
    Typst,
    /// A function on doubles
    Rust,
    /// A module for SymPy
    Sympy,
}

impl Derive {
    /// Derives and prints.
    pub fn run(&self) -> Result<Exit, Failure> {
        let found = self.derivations.load()?;
        let paper = selection::paper(&found.papers, &self.paper).map_err(Failure::from);
        let derivation = match paper.and_then(|paper| self.derive(paper)) {
            // A missing basis may be one with a mistake.
            Err(failure) if !found.mistakes.is_empty() => {
                terminal::complain(&failure);
                return Ok(found.mistakes.tell(failure.exit()));
            }
            derived => derived?,
        };
        watchdog::finished();
        terminal::print(&print(&derivation, self.language.into()))?;
        Ok(found.mistakes.tell(Exit::AsExpected))
    }

    fn derive(&self, paper: &Paper) -> Result<Derivation, Failure> {
        let declarations = declaring(paper, &self.basis).ok_or_else(|| Failure::UnknownBasis {
            paper: self.paper.clone(),
            basis: self.basis.clone(),
            known: bases(paper),
        })?;
        let shape = Shape {
            degree: self.degree,
            rational: self.rational,
        };
        let derived = match self.join {
            None => end_derivatives(declarations, &self.basis, self.order, shape),
            Some(Join::C) => continuity(declarations, &self.basis, self.order, shape),
            Some(Join::G1) => geometric(declarations, &self.basis, Geometric::G1, shape),
            Some(Join::FarinBoehm) => {
                geometric(declarations, &self.basis, Geometric::FarinBoehm, shape)
            }
            Some(Join::Beta) => geometric(declarations, &self.basis, Geometric::Beta, shape),
        };
        derived.map_err(|error: DeriveError| Failure::Derive(Box::new(error)))
    }
}

/// Returns the declarations, of the paper or of a claim file, that contain the basis.
fn declaring<'p>(paper: &'p Paper, basis: &str) -> Option<&'p Declarations> {
    scopes(paper).find(|scope| scope.basis(basis).is_some())
}

fn bases(paper: &Paper) -> Vec<String> {
    let names = scopes(paper).flat_map(|scope| scope.bases().map(|(name, _)| name.to_owned()));
    let mut names: Vec<String> = names.collect();
    names.sort();
    names.dedup();
    names
}

fn scopes(paper: &Paper) -> impl Iterator<Item = &Declarations> {
    let own = paper.claims.iter().map(|claim| &*claim.declarations);
    std::iter::once(&*paper.declarations).chain(own)
}

impl From<Output> for Language {
    fn from(output: Output) -> Self {
        match output {
            Output::Text => Language::Text,
            Output::Latex => Language::Latex,
            Output::Typst => Language::Typst,
            Output::Rust => Language::Rust,
            Output::Sympy => Language::Sympy,
        }
    }
}
