//! Exit codes, and the failures behind them.

use crate::standard::{is_standard, name};
use miette::Diagnostic;
use std::path::PathBuf;
use std::process::ExitCode;
use thiserror::Error;
use torse_designs::{DesignError, Ending};
use torse_exchange::ExchangeError;
use torse_figures::PlateError;
use torse_report::ReportError;
use torse_rocq::coqc::INSTALL;
use torse_rocq::kernel_error::KernelError;
use torse_syntax::derivation::{DerivationError, LoadError};
use torse_syntax::taxonomy::Verdict;
use torse_verdicts::derive::DeriveError;
use torse_verdicts::outcome::Outcome;

/// The exit codes of the command, the least grave first; if several apply, the gravest is returned.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum Exit {
    /// 0: every verdict is the expected one, or none is expected.
    AsExpected,
    /// 3: a claim that was named by its full id is undecided.
    Undecided,
    /// 1: a verdict differs from what its derivation file expects or from an earlier run, a design misses a tolerance
    /// of its file, a drawing breaks a rule, an editor left without a word.
    Differs,
    /// 7: a program that was asked for is missing.
    Missing,
    /// 8: the time limit ended the run.
    TimeLimit,
    /// 5: an output could not be made or written.
    Output,
    /// 4: a file is wrong.
    BadData,
    /// 2: the command line cannot be followed, or a file that it names cannot be read; clap uses the same code.
    Usage,
    /// 6: levels of assurance contradict each other: the prover and the second evaluator, the checker, or the kernel.
    Contradiction,
}

impl Exit {
    /// The code for these outcomes, of which those with an id among `named` were asked for by that id.
    pub fn from_outcomes<'a>(
        outcomes: impl IntoIterator<Item = &'a Outcome>,
        named: &[String],
    ) -> Self {
        let of = |outcome: &Outcome| match outcome.verdict() {
            _ if outcome.contradiction().is_some() => Exit::Contradiction,
            _ if !outcome.as_expected() => Exit::Differs,
            Verdict::Undecided if named.contains(&outcome.claim.id) => Exit::Undecided,
            _ => Exit::AsExpected,
        };
        outcomes
            .into_iter()
            .map(of)
            .max()
            .unwrap_or(Exit::AsExpected)
    }

    /// All exit codes, the least grave first.
    pub const ALL: [Self; 9] = [
        Self::AsExpected,
        Self::Undecided,
        Self::Differs,
        Self::Missing,
        Self::TimeLimit,
        Self::Output,
        Self::BadData,
        Self::Usage,
        Self::Contradiction,
    ];

    /// The exit with this number.
    pub fn from_code(code: u8) -> Option<Self> {
        Self::ALL.into_iter().find(|exit| exit.code() == code)
    }

    /// The number.
    pub fn code(self) -> u8 {
        match self {
            Exit::AsExpected => 0,
            Exit::Differs => 1,
            Exit::Usage => 2,
            Exit::Undecided => 3,
            Exit::BadData => 4,
            Exit::Output => 5,
            Exit::Contradiction => 6,
            Exit::Missing => 7,
            Exit::TimeLimit => 8,
        }
    }
}

impl From<Exit> for ExitCode {
    fn from(exit: Exit) -> Self {
        ExitCode::from(exit.code())
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
    /// What a studio serves is no folder.
    #[error("{} is not a folder", path.display())]
    #[diagnostic(help("`torse studio` takes a folder of designs and papers"))]
    NoFolder {
        /// The path as given.
        path: PathBuf,
    },
    /// There is no page to serve.
    #[error("the page is not in {}", looked.iter().map(|path| path.display().to_string()).collect::<Vec<_>>().join(" or "))]
    #[diagnostic(help("`web/build` makes it; `--page FOLDER` says where it is"))]
    NoPage {
        /// Where it was looked for.
        looked: Vec<PathBuf>,
    },
    /// A studio cannot serve.
    #[error("port {port} of 127.0.0.1 cannot be listened on: {reason}")]
    #[diagnostic(help("`--port 0` takes a port that is free"))]
    Listen {
        /// The port as given.
        port: u16,
        /// Why.
        reason: String,
    },
    /// A file or folder already has the name of a new folder.
    #[error("{} exists", path.display())]
    #[diagnostic(help("nothing is overwritten: take another name"))]
    Exists {
        /// The path.
        path: PathBuf,
    },
    /// The library has no answer.
    #[error(transparent)]
    #[diagnostic(transparent)]
    Library(#[from] torse::Error),
    /// A file that the command line names cannot be read.
    #[error("{} cannot be read", if is_standard(path) { "standard input".to_owned() } else { path.display().to_string() })]
    Input {
        /// The path as given.
        path: PathBuf,
        /// Why.
        #[source]
        source: std::io::Error,
    },
    /// What stands in place of verdicts of an earlier run is none.
    #[error("{} holds no verdicts: {reason}", name(path))]
    #[diagnostic(help("`--against` takes what `torse verify --format json` has written"))]
    Against {
        /// The path as given.
        path: PathBuf,
        /// The mistakes.
        reason: String,
    },
    /// An option that changes nothing for the purpose of a file.
    #[error("`{option}` has no effect for `--for {purpose}`")]
    #[diagnostic(help("leave it out, or take one of `--for {}`", purposes.join("`, `--for ")))]
    NoEffect {
        /// The option.
        option: &'static str,
        /// The purpose as given, or the usual one.
        purpose: &'static str,
        /// Those for which it has an effect.
        purposes: &'static [&'static str],
    },
    /// A format that other purposes have.
    #[error("this purpose has files .{}, and not .{ending}", known.join(", ."))]
    #[diagnostic(help("for .{ending} add `--for {}`", purposes.join("` or `--for ")))]
    OtherPurpose {
        /// The ending of the file.
        ending: &'static str,
        /// Those that the purpose has.
        known: &'static [&'static str],
        /// The purposes that have it.
        purposes: Vec<&'static str>,
    },
    /// A file name whose extension is no format of any purpose.
    #[error("unknown file extension: {}", path.display())]
    #[diagnostic(help("the extensions are .{}{}", known.join(", ."), others(elsewhere)))]
    UnknownFormat {
        /// The file.
        path: PathBuf,
        /// The endings that the purpose has.
        known: &'static [&'static str],
        /// Those that other purposes have, and these.
        elsewhere: Vec<(&'static str, Vec<&'static str>)>,
    },
    /// Two answers would go to standard output.
    #[error("standard output cannot be two files")]
    #[diagnostic(help("give `--to` or `--parts` the name of a file"))]
    BothStandard,
    /// A line of a list of claims is none.
    #[error("{} is no list of claims: {reason}", name(path))]
    #[diagnostic(help(
        "`torse list --format json` writes the claims with their digests, a line each"
    ))]
    List {
        /// The path as given.
        path: PathBuf,
        /// Why.
        reason: String,
    },
    /// The words of a correction say something else than what is decided with it.
    #[error("the correction of `{claim}` reads `{reads}`, and what is decided is `{states}`")]
    #[diagnostic(help("a letter prints `reads`: it has to say what `states` says"))]
    ReadsOtherwise {
        /// The id of the claim.
        claim: String,
        /// The formula of the words.
        reads: String,
        /// The corrected statement.
        states: String,
    },
    /// No claim names a function of a program.
    #[error("no claim of `{name}` names a function")]
    #[diagnostic(help(
        "name one with `--code FILE:FUNCTION`, or in the claim: `code = {{ file = \"basis.py\", function = \"f\" }}`"
    ))]
    NoCode {
        /// The name as given.
        name: String,
    },
    /// An id that no claim has.
    #[error("no claim has the id `{id}`")]
    #[diagnostic(help("`--ids` takes full ids, one a line, as `torse list` shows them"))]
    UnknownId {
        /// The id as given.
        id: String,
    },
    /// What claims are compared with is neither a list of claims nor a revision.
    #[error("`{since}` is nothing that claims are compared with: {reason}")]
    #[diagnostic(help(
        "`--changed-since` takes a revision of git, or what `torse list --format json` has written"
    ))]
    Since {
        /// As given.
        since: String,
        /// Why not.
        reason: String,
    },
    /// Parts of a corpus that are no whole.
    #[error("{} cannot be merged: {reason}", name(path))]
    #[diagnostic(help("`torse verify --ids FILE` writes it anew"))]
    Merge {
        /// The file.
        path: PathBuf,
        /// Why.
        reason: String,
    },
    /// Claims that no part of a corpus has.
    #[error("no file has the claim `{id}` as it is now")]
    #[diagnostic(help(
        "it is decided by `torse verify --ids FILE`, of a file with a line that is this id"
    ))]
    Unmerged {
        /// The claim.
        id: String,
    },
    /// What an editor sends makes no sense from there on.
    #[error("standard input cannot be read")]
    Messages(#[source] std::io::Error),
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
    /// The derivation failed.
    #[error("nothing can be derived: {0}")]
    Derive(Box<DeriveError>),
    /// The id of a paper would lead a file astray.
    #[error("the paper's id `{slug}` cannot be the name of a report")]
    #[diagnostic(help(
        "an id is made of letters, digits and hyphens, and is neither `summary` nor `index`, and does not end in `-erratum`"
    ))]
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
    /// The proof assistant is not installed.
    #[error("`coqc` was not found")]
    #[diagnostic(help("Debian 12: `{INSTALL}` (Coq 8.16.1)"))]
    MissingCoqc,
    /// Proofs could not be checked, or not be written.
    #[error("the proofs cannot be checked: {0}")]
    Proofs(KernelError),
    /// A file of the folder of proofs cannot be used.
    #[error("{} cannot be read: {reason}", path.display())]
    #[diagnostic(help("remove it: `torse prove --try` writes it anew"))]
    ReadProofs {
        /// The path.
        path: PathBuf,
        /// Why.
        reason: String,
    },
    /// The developable surface of a figure cannot be written as a CAD file.
    #[error("figure `{figure}`: {source}")]
    Step {
        /// The figure.
        figure: String,
        /// Why.
        #[source]
        source: ExchangeError,
    },
    /// A derivation file disappeared during the run, or a file of code that a claim names is missing.
    #[error("{} cannot be read", path.display())]
    Unread {
        /// The path.
        path: PathBuf,
        /// Why.
        #[source]
        source: std::io::Error,
    },
    /// A manuscript is no text that can be read.
    #[error("{}, line {line}: {reason}", name(path))]
    #[diagnostic(help("a macro that calls itself has no end; give the text that it stands for"))]
    Manuscript {
        /// The path as given.
        path: PathBuf,
        /// The line.
        line: usize,
        /// Why.
        reason: String,
    },
    /// The output could not be written.
    #[error("cannot write the output")]
    Print(#[source] std::io::Error),
    /// The program cannot read itself.
    #[error("the program cannot be read, by which parts of other programs are known")]
    Program(#[source] std::io::Error),
}

/// The extensions that other purposes have, and which ones.
fn others(elsewhere: &[(&str, Vec<&str>)]) -> String {
    let other = |(ending, purposes): &(&str, Vec<&str>)| {
        format!("; .{ending} with `--for {}`", purposes.join("` or `--for "))
    };
    elsewhere.iter().map(other).collect()
}

impl From<KernelError> for Failure {
    fn from(error: KernelError) -> Self {
        match error {
            KernelError::Missing => Self::MissingCoqc,
            other => Self::Proofs(other),
        }
    }
}

impl From<DesignError> for Failure {
    fn from(error: DesignError) -> Self {
        Self::Library(error.into())
    }
}

impl Failure {
    /// The exit code of the failure.
    pub fn exit(&self) -> Exit {
        match self {
            Failure::NoDerivations
            | Failure::NotAFolder { .. }
            | Failure::NoFolder { .. }
            | Failure::NoPage { .. }
            | Failure::Exists { .. }
            | Failure::BothStandard
            | Failure::NoEffect { .. }
            | Failure::OtherPurpose { .. }
            | Failure::UnknownFormat { .. }
            | Failure::UnknownId { .. }
            | Failure::NoCode { .. }
            | Failure::Since { .. }
            | Failure::UnknownBasis { .. } => Exit::Usage,
            Failure::Input { source, .. } => match source.kind() {
                // It was read, and is no text.
                std::io::ErrorKind::InvalidData => Exit::BadData,
                _ => Exit::Usage,
            },
            Failure::Library(error) => exit_of(error),
            Failure::Derive(error) => match **error {
                DeriveError::UnknownBasis { .. }
                | DeriveError::Order { .. }
                | DeriveError::Degree { .. }
                | DeriveError::OneDegree { .. }
                | DeriveError::NeedsDegree { .. } => Exit::Usage,
                _ => Exit::BadData,
            },
            Failure::Load(_)
            | Failure::Derivation(_)
            | Failure::Slug { .. }
            | Failure::Against { .. }
            | Failure::List { .. }
            | Failure::Manuscript { .. } => Exit::BadData,
            Failure::MissingCoqc => Exit::Missing,
            Failure::ReadProofs { .. }
            | Failure::Unread { .. }
            | Failure::Merge { .. }
            | Failure::ReadsOtherwise { .. }
            | Failure::Unmerged { .. } => Exit::BadData,
            Failure::Proofs(_)
            | Failure::Report(_)
            | Failure::Figure { .. }
            | Failure::Step { .. }
            | Failure::Listen { .. }
            | Failure::Print(_)
            | Failure::Program(_)
            | Failure::Messages(_) => Exit::Output,
        }
    }
}

/// The exit code of an error of the library.
fn exit_of(error: &torse::Error) -> Exit {
    match error {
        torse::Error::UnknownName { .. } | torse::Error::Ambiguous { .. } => Exit::Usage,
        torse::Error::Load(_) | torse::Error::Formula(_) | torse::Error::NothingDecided { .. } => {
            Exit::BadData
        }
        torse::Error::Design(failure) => match failure.0.ending() {
            Ending::Usage => Exit::Usage,
            Ending::BadFile => Exit::BadData,
            Ending::Output => Exit::Output,
            Ending::Missed => Exit::Differs,
        },
        _ => Exit::Output,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_gravest_exit_wins_in_the_order_of_the_manual() {
        assert!(Exit::ALL.is_sorted());
        assert_eq!(Exit::ALL.map(Exit::code), [0, 3, 1, 7, 8, 5, 4, 2, 6]);
        assert!(
            Exit::ALL
                .iter()
                .all(|exit| Exit::from_code(exit.code()) == Some(*exit))
        );
    }
}
