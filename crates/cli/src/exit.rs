//! How a run ends: exit codes, and the failures behind them.

use miette::Diagnostic;
use std::path::PathBuf;
use std::process::ExitCode;
use thiserror::Error;
use torse_language::derivation::{DerivationError, LoadError};
use torse_language::words::Verdict;
use torse_plates::PlateError;
use torse_report::ReportError;
use torse_verdicts::derive::DeriveError;
use torse_verdicts::outcome::Outcome;

/// The exit codes of the command.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Exit {
    /// 0: every verdict is the expected one, or none is expected.
    AsExpected,
    /// 1: a verdict differs from what its derivation file expects.
    Differs,
    /// 2: the command line cannot be followed; clap uses the same code.
    Usage,
    /// 3: a claim that was named by its full id is undecided.
    Undecided,
    /// 4: a derivation file is wrong.
    BadData,
    /// 5: an output could not be made or written.
    Output,
}

impl Exit {
    /// The code for these outcomes, of which those with an id among `named` were asked for by that id.
    pub fn of<'a>(outcomes: impl IntoIterator<Item = &'a Outcome>, named: &[String]) -> Self {
        let mut exit = Exit::AsExpected;
        for outcome in outcomes {
            if !outcome.as_expected() {
                return Exit::Differs;
            }
            if outcome.verdict == Verdict::Undecided && named.contains(&outcome.id) {
                exit = Exit::Undecided;
            }
        }
        exit
    }
}

impl From<Exit> for ExitCode {
    fn from(exit: Exit) -> Self {
        ExitCode::from(match exit {
            Exit::AsExpected => 0,
            Exit::Differs => 1,
            Exit::Usage => 2,
            Exit::Undecided => 3,
            Exit::BadData => 4,
            Exit::Output => 5,
        })
    }
}

/// Why a run ended without an answer.
#[derive(Debug, Error, Diagnostic)]
pub enum Failure {
    /// There is no folder of derivations to work on.
    #[error("no folder `derivations` here or in any folder above")]
    #[diagnostic(help("name it with `--derivations DIR`"))]
    NoDerivations,
    /// The folder named by the user is none.
    #[error("{} is not a folder", path.display())]
    #[diagnostic(help("`--derivations` takes the folder that holds one folder a paper"))]
    NotAFolder {
        /// The path as given.
        path: PathBuf,
    },
    /// A name that no paper and no claim has.
    #[error("no paper and no claim is called `{name}`")]
    UnknownName {
        /// The name as given.
        name: String,
        /// What may have been meant.
        #[help]
        help: String,
    },
    /// A name that means several claims, where one is wanted.
    #[error("`{name}` means {} claims; one is wanted", ids.len())]
    #[diagnostic(help("{}", ids.join("\n")))]
    Ambiguous {
        /// The name as given.
        name: String,
        /// The claims it means.
        ids: Vec<String>,
    },
    /// The folder of derivations could not be loaded.
    #[error(transparent)]
    #[diagnostic(transparent)]
    Load(#[from] LoadError),
    /// A formula makes no sense.
    #[error(transparent)]
    #[diagnostic(transparent)]
    Derivation(#[from] Box<DerivationError>),
    /// A basis that the paper does not declare.
    #[error("`{paper}` declares no basis `{basis}`")]
    #[diagnostic(help("its bases are: {}", known.join(", ")))]
    UnknownBasis {
        /// The paper.
        paper: String,
        /// The name as given.
        basis: String,
        /// The bases that it has.
        known: Vec<String>,
    },
    /// Nothing can be derived.
    #[error("nothing can be derived: {0}")]
    Derive(Box<DeriveError>),
    /// The id of a paper would lead a file astray.
    #[error("the paper's id `{slug}` cannot be the name of a report")]
    #[diagnostic(help("an id is made of letters, digits and hyphens, and is not `summary`"))]
    Slug {
        /// The id.
        slug: String,
    },
    /// A report could not be made or written.
    #[error("the report cannot be made")]
    Report(#[from] ReportError),
    /// A figure could not be drawn.
    #[error("the figure `{figure}` cannot be drawn")]
    Figure {
        /// The figure's id.
        figure: String,
        /// Why.
        source: PlateError,
    },
    /// The terminal, or what stands in for it, took no more.
    #[error("cannot write the output")]
    Print(#[source] std::io::Error),
}

impl Failure {
    /// The exit code of the failure.
    pub fn exit(&self) -> Exit {
        match self {
            Failure::NoDerivations
            | Failure::NotAFolder { .. }
            | Failure::UnknownName { .. }
            | Failure::UnknownBasis { .. }
            | Failure::Ambiguous { .. } => Exit::Usage,
            Failure::Derive(error) => match **error {
                DeriveError::UnknownBasis { .. } | DeriveError::Order { .. } => Exit::Usage,
                _ => Exit::BadData,
            },
            Failure::Load(_) | Failure::Derivation(_) | Failure::Slug { .. } => Exit::BadData,
            Failure::Report(_) | Failure::Figure { .. } | Failure::Print(_) => Exit::Output,
        }
    }
}
