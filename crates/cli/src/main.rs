//! The `torse` command: arguments in, verdicts, explanations and reports out.
//!
//! One file a subcommand; no mathematics. Derivation files come from [`derivations`], the claims that
//! the user names from [`selection`], outcomes from [`run`]; [`exit`] says which exit code means what.

mod derivations;
mod derive;
mod exit;
mod explain;
mod figures;
mod recheck;
mod report;
mod run;
mod selection;
mod terminal;
mod verdicts;
mod verify;

use clap::{Parser, Subcommand};
use exit::{Exit, Failure};
use std::process::ExitCode;

/// Proves, corrects and illustrates the mathematics of developable and shape-adjustable surfaces.
///
/// Papers are folders of derivation files: each claim of a paper is stated there as a formula, and is
/// decided by exact computation. Verdicts are never typed in: they are computed on every run.
#[derive(Parser)]
#[command(name = "torse", version, max_term_width = 100, after_help = EXAMPLES, after_long_help = LONG_EXAMPLES)]
struct Arguments {
    #[command(subcommand)]
    command: Command,
}

const EXAMPLES: &str = "\
Examples:
  torse verify                           all claims of all papers
  torse verify gbt-developable/thm-4     the claims of one theorem
  torse explain gbt-developable/thm-4.c  why a formula is wrong, and what is right
  torse report                           verdicts, PDF, HTML and figures into reports/
  torse derive gbt-surfaces f --join c   C1 to C3 conditions of a basis, for every degree
  torse recheck                          every proof again, by a second evaluator

`torse help COMMAND` says more, `torse --help` lists the exit codes.";

const LONG_EXAMPLES: &str = "\
Examples:
  torse verify                           all claims of all papers
  torse verify gbt-developable/thm-4     the claims of one theorem
  torse verify --format json             the same for programs, byte-identical on every run
  torse explain gbt-developable/thm-4.c  why a formula is wrong, and what is right
  torse report                           verdicts, PDF, HTML and figures into reports/
  torse derive gbt-surfaces f --join c   C1 to C3 conditions of a basis, for every degree
  torse recheck                          every proof again, by a second evaluator

Exit codes:
  0  every verdict is as expected (or nothing is said about it)
  1  a verdict differs from what its derivation file expects, or a replay from the verdict
  2  the command line cannot be followed: an unknown name, a missing folder
  3  a claim named by its full id is undecided
  4  a derivation file is wrong; the message shows file, line and column
  5  an output could not be made or written

Colours and progress are for terminals only; NO_COLOR=1 turns colours off there too.";

#[derive(Subcommand)]
enum Command {
    Verify(verify::Verify),
    Explain(explain::Explain),
    Report(report::Report),
    Derive(derive::Derive),
    Recheck(recheck::Replay),
}

impl Command {
    fn run(&self) -> Result<Exit, Failure> {
        match self {
            Command::Verify(command) => command.run(),
            Command::Explain(command) => command.run(),
            Command::Report(command) => command.run(),
            Command::Derive(command) => command.run(),
            Command::Recheck(command) => command.run(),
        }
    }
}

fn main() -> ExitCode {
    let exit = Arguments::parse().command.run().unwrap_or_else(|failure| {
        terminal::complain(&failure);
        failure.exit()
    });
    exit.into()
}
