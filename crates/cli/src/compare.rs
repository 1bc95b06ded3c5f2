//! `torse compare`: does the code equal the paper?

use crate::derivations::Derivations;
use crate::exit::{Exit, Failure};
use crate::format::{Format, json_line};
use crate::run::Budget;
use crate::standard::is_standard;
use crate::{input, terminal, watchdog};
use clap::{Args, ValueEnum};
use std::path::{Path, PathBuf};
use torse::syntax::derivation::{Claim, Paper};
use torse::{CodeQuestion, CodeVerdict, Comparison, MAX_CODE_BYTES, PrintedSide, selection};

/// Compare code with what a paper prints: are they equal, and if not, which one change makes them equal?
///
/// Pure functions of Python (plain, NumPy, SymPy) and Rust are read as formulas: assignments, loops over constants, branches on
/// constants, and calls of functions of the same file. Numbers are exact: rounding and overflow are out of scope. Parameters
/// stand for the claim's symbols of the same name (Greek letters may be spelled out), or for what `--map` says.
/// Without `--code` the claims that name a function themselves (`code = { file, function }`) are compared.
#[derive(Args)]
#[command(after_help = EXAMPLES)]
pub struct Compare {
    /// The claim's id, or the beginning of ids where claims name their functions
    #[arg(value_name = "CLAIM")]
    name: String,
    /// The function; - as its file is standard input
    #[arg(long, value_name = "FILE:FUNCTION", value_parser = file_and_function, allow_hyphen_values = true)]
    code: Option<(PathBuf, String)>,
    /// What a parameter stands for: a formula of the claim, or a list of such
    #[arg(long, value_name = "NAME=FORMULA", value_parser = name_and_formula, requires = "code")]
    map: Vec<(String, String)>,
    /// Hypotheses besides those of the claim, with semicolons between; `n == 3` fixes an integer
    #[arg(
        long = "where",
        value_name = "HYPOTHESES",
        default_value = "",
        hide_default_value = true,
        requires = "code"
    )]
    setting: String,
    /// The side of the equation [default: the printed one, mostly the right one]
    #[arg(long, requires = "code")]
    side: Option<Side>,
    /// Which equation of a statement with several, counted from one
    #[arg(long, value_name = "N", requires = "code")]
    part: Option<usize>,
    /// The output: a text, or JSON, one object a line
    #[arg(long, value_enum, default_value = "text")]
    format: Format,
    #[command(flatten)]
    budget: Budget,
    #[command(flatten)]
    derivations: Derivations,
}

#[derive(Clone, Copy, ValueEnum)]
enum Side {
    Left,
    Right,
}

const EXAMPLES: &str = "\
Examples:
  torse compare hermite-developable/eq-2.1a --code hermite.py:cubic
  torse compare bezier/curve.casteljau --code casteljau.rs:point --where \"m == 3\" --map t=x --map p=P
  torse compare my-paper                 all claims of a paper with `code = { file, function }`";

fn file_and_function(text: &str) -> Result<(PathBuf, String), String> {
    match text.rsplit_once(':') {
        Some((file, function)) if !file.is_empty() && !function.is_empty() => {
            Ok((PathBuf::from(file), function.to_owned()))
        }
        _ => Err("write FILE:FUNCTION, such as basis.py:bernstein".to_owned()),
    }
}

fn name_and_formula(text: &str) -> Result<(String, String), String> {
    match text.split_once('=') {
        Some((name, formula)) if !name.trim().is_empty() && !formula.trim().is_empty() => {
            Ok((name.trim().to_owned(), formula.trim().to_owned()))
        }
        _ => Err("write NAME=FORMULA, such as b0=P[0]".to_owned()),
    }
}

impl Compare {
    /// Compares and prints.
    pub fn run(&self) -> Result<Exit, Failure> {
        let found = self.derivations.load()?;
        let mut mistakes = found.mistakes;
        if found.left_out.contains(&self.name) {
            return Ok(mistakes.tell(Exit::BadData));
        }
        let mut gravest = Exit::AsExpected;
        for (paper, claim, question) in self.questions(&found.papers)? {
            match self.budget.verifier().compare(&paper, &claim, &question) {
                Ok(comparison) => {
                    watchdog::finished();
                    gravest = gravest.max(exit(&comparison));
                    terminal::print(&self.text(&comparison)?)?;
                }
                Err(torse::Error::Formula(error)) => mistakes.add(error),
                Err(error) => return Err(error.into()),
            }
        }
        Ok(mistakes.tell(gravest))
    }

    /// What is asked: one function, or those of the claims that name one.
    fn questions(&self, papers: &[Paper]) -> Result<Vec<(String, Claim, CodeQuestion)>, Failure> {
        if let Some((file, function)) = &self.code {
            let paper = selection::select_one(papers, &self.name)?;
            let code = text(file)?;
            let question = CodeQuestion {
                map: self.map.clone(),
                conditions: conditions(&self.setting),
                side: match self.side {
                    None => PrintedSide::Printed,
                    Some(Side::Left) => PrintedSide::Left,
                    Some(Side::Right) => PrintedSide::Right,
                },
                part: self.part,
                ..CodeQuestion::new(code_name(file, &code), code, function)
            };
            let claims = paper.claims.into_iter();
            return Ok(claims
                .map(|claim| (paper.head.id.clone(), claim, question.clone()))
                .collect());
        }
        let named = selection::select(papers.to_vec(), std::slice::from_ref(&self.name), &[])?;
        let folder = self.derivations.find()?;
        let mut all = vec![];
        for paper in named {
            for claim in paper.claims {
                let Some(mut question) = CodeQuestion::declared(&claim) else {
                    continue;
                };
                let path = folder.join(&paper.head.id).join(&question.file);
                question.text = text(&path).map_err(|failure| match failure {
                    Failure::Input { path, source } => Failure::Unread { path, source },
                    other => other,
                })?;
                all.push((paper.head.id.clone(), claim, question));
            }
        }
        if all.is_empty() {
            return Err(Failure::NoCode {
                name: self.name.clone(),
            });
        }
        Ok(all)
    }

    fn text(&self, comparison: &Comparison) -> Result<String, Failure> {
        match self.format {
            Format::Text => Ok(format!(
                "{}: {comparison}",
                terminal::heading(&comparison.claim)
            )),
            Format::Json => Ok(json_line(comparison)?),
        }
    }
}

/// The name of a file of code, whose ending says in which language it is; that of standard input says what a line says
/// with which only a function of Rust begins.
fn code_name(file: &Path, code: &str) -> String {
    let is_rust = |line: &str| line.starts_with("fn ") || line.starts_with("pub fn ");
    match is_standard(file) {
        true if code.lines().any(is_rust) => "stdin.rs".to_owned(),
        true => "stdin.py".to_owned(),
        false => file.display().to_string(),
    }
}

/// The hypotheses of a setting.
fn conditions(setting: &str) -> Vec<String> {
    let all = setting.split(';').map(|text| text.trim().to_owned());
    all.filter(|text| !text.is_empty()).collect()
}

/// The text of a file of code; of one that is too long a beginning that is too long.
fn text(path: &Path) -> Result<String, Failure> {
    let bytes = input::bytes(path, MAX_CODE_BYTES)?;
    // A letter that is cut off at the end is of a file that is too long.
    Ok(String::from_utf8_lossy(&bytes).into_owned())
}

fn exit(comparison: &Comparison) -> Exit {
    match comparison.verdict {
        _ if comparison.outcome.contradiction().is_some() => Exit::Contradiction,
        CodeVerdict::Equal | CodeVerdict::EqualWhere => Exit::AsExpected,
        CodeVerdict::Different => Exit::Differs,
        CodeVerdict::Undecided => Exit::Undecided,
    }
}
