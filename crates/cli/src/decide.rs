//! `torse decide`: one statement from the command line, or many from standard input.

use crate::exit::{Exit, Failure};
use crate::explain::text;
use crate::format::{Format, json_line};
use crate::run::Budget;
use crate::{input, terminal, watchdog};
use clap::Args;
use serde::{Deserialize, Serialize};
use std::path::Path;
use torse::{Decided, ErrorMessage, ErrorPlace, Verdict};
use torse_syntax::derivation::question;

/// Decide one statement: is it true, where is it false, what would be right?
///
/// Undeclared names are real numbers. `--where` declares other symbols, defines functions and adds hypotheses,
/// separated by semicolons or commas: `x in [0, 1]`, `n in 0..`, `p: vector 3`, `f: function 1`, `H(t) := t^2`, `a > 0`.
///
/// `--latex` reads the statement as a paper prints it. A formula with two readings is an error that shows both.
///
/// If the statement is `-`, each line of standard input is a statement, or a JSON object with `states` and, in place of
/// `--where`, `where`. For each line torse prints a line of JSON with the `number` of the line: the fields of `verify
/// --format json`, or an `error` with its `mistakes`, their places and lengths. The exit code is 0 for a statement that is
/// true, if need be under the condition that is shown, 1 for a false one, 3 for one that is not decided, 4 for one that
/// makes no sense; for several, the gravest.
#[derive(Args)]
#[command(after_help = EXAMPLES)]
pub struct Decide {
    /// The statement, or - to read statements from standard input
    #[arg(value_name = "STATEMENT", allow_hyphen_values = true)]
    statement: String,
    /// Read the statement as LaTeX, without dollar signs
    #[arg(long)]
    latex: bool,
    /// Add declarations, definitions and hypotheses
    #[arg(
        long = "where",
        value_name = "SETTING",
        default_value = "",
        allow_hyphen_values = true
    )]
    setting: String,
    /// Print text, or JSON for programs
    #[arg(long, value_name = "FORMAT", default_value = "text")]
    format: Format,
    #[command(flatten)]
    budget: Budget,
}

const EXAMPLES: &str = "\
Examples:
  torse decide \"sin(x)^2 + cos(x)^2 == 1\"
  torse decide \"(a + b)^2 == a^2 + b^2\"
  torse decide \"sum(i, 0, n, binom(n, i)*x^i*(1 - x)^(n - i)) == 1\" --where \"n in 0..\"
  torse decide --latex '\\sin^2 x + \\cos^2 x = 1'
  torse decide \"x^2 > 0\" --where \"x != 0\"
  torse decide - < statements.txt";

/// A statement of a line of standard input.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Question {
    states: String,
    /// What `--where` says, if the line says nothing else.
    #[serde(rename = "where")]
    setting: Option<String>,
}

impl Decide {
    /// Decides and prints.
    pub fn run(&self) -> Result<Exit, Failure> {
        if self.statement == "-" {
            return self.lines();
        }
        let verifier = self.budget.verifier();
        let decided = match self.latex {
            true => verifier.decide_latex(&self.statement, &self.setting)?,
            false => verifier.decide(&self.statement, &self.setting)?,
        };
        watchdog::finished();
        if !self.latex
            && let Ok(read) = question(&self.statement, &self.setting)
        {
            for name in read.look_alikes() {
                terminal::remark(&terminal::shown(&name));
            }
        }
        terminal::print(&match self.format {
            Format::Text => text(&decided.explanation()),
            Format::Json => decided.json()?,
        })?;
        Ok(exit(&decided))
    }

    /// Decides every line of standard input.
    fn lines(&self) -> Result<Exit, Failure> {
        let mut gravest = Exit::AsExpected;
        for (index, line) in input::lines(Path::new("-"))?.enumerate() {
            let line = line?;
            if line.trim().is_empty() {
                continue;
            }
            let (text, exit) = self.line(index + 1, &line)?;
            terminal::print(&text)?;
            gravest = gravest.max(exit);
        }
        Ok(gravest)
    }

    fn line(&self, number: usize, line: &str) -> Result<(String, Exit), Failure> {
        let question = match line.trim_start().starts_with('{') {
            true => serde_json::from_str(line).map_err(|error| Wrong::no_question(&error)),
            false => Ok(Question {
                states: line.trim().to_owned(),
                setting: None,
            }),
        };
        let decided = question.and_then(|question| {
            let verifier = self.budget.verifier();
            let setting = question.setting.as_ref().unwrap_or(&self.setting);
            let decided = match self.latex {
                true => verifier.decide_latex(&question.states, setting),
                false => verifier.decide(&question.states, setting),
            };
            decided.map_err(|error| Wrong::statement(&error))
        });
        match decided {
            Ok(decided) => {
                let json = decided.json()?;
                let fields = json.strip_prefix('{').unwrap_or(&json);
                Ok((format!("{{\"number\":{number},{fields}"), exit(&decided)))
            }
            Err(Wrong { error, mistakes }) => {
                let answer = WrongLine {
                    number,
                    line,
                    error,
                    mistakes,
                };
                Ok((json_line(&answer)?, Exit::BadData))
            }
        }
    }
}

/// Why a line has no verdict.
struct Wrong {
    error: String,
    mistakes: Vec<ErrorMessage>,
}

impl Wrong {
    /// A line that begins as JSON and is no question.
    fn no_question(error: &serde_json::Error) -> Self {
        let place = ErrorPlace::new("the line", error.line(), error.column());
        let error = error.to_string();
        let mistakes = vec![ErrorMessage::new(Some(place), &error)];
        Self { error, mistakes }
    }

    /// A statement that cannot be read, or makes no sense.
    fn statement(error: &torse::Error) -> Self {
        Self {
            error: error.to_string(),
            mistakes: error.messages(),
        }
    }
}

/// The answer to a line that has no verdict.
#[derive(Serialize)]
struct WrongLine<'a> {
    number: usize,
    line: &'a str,
    error: String,
    mistakes: Vec<ErrorMessage>,
}

/// The exit code of an answer.
fn exit(decided: &Decided) -> Exit {
    match decided.verdict() {
        _ if decided.outcome().contradiction().is_some() => Exit::Contradiction,
        Verdict::False | Verdict::Misprint => Exit::Differs,
        Verdict::Undecided | Verdict::Vacuous => Exit::Undecided,
        _ => Exit::AsExpected,
    }
}
