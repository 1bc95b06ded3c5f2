//! The `torse` command: arguments in, verdicts, explanations and reports out.
//!
//! Each subcommand has a file; what several of them share has one of its own. There is no mathematics here. Derivation
//! files come from [`derivations`], the claims that the user names from [`torse::selection`], outcomes from
//! [`mod@run`]; [`exit`] says which exit code means what.

mod audit;
mod baseline;
mod changed;
mod compare;
mod completions;
mod costs;
mod decide;
mod derivations;
mod derive;
mod design;
mod diagnostics;
mod documents;
mod erratum;
mod exit;
mod explain;
mod figures;
mod format;
mod input;
mod kernel;
mod lint;
mod list;
mod listing;
mod lsp;
mod merge;
mod new;
mod proof_tasks;
mod proofs;
mod prove;
mod recheck;
mod report;
mod run;
mod shard;
mod standard;
mod studio;
mod terminal;
mod unroll;
mod verdicts;
mod verify;
mod version;
mod watch;
mod watchdog;

use clap::{CommandFactory, Parser, Subcommand};
use exit::{Exit, Failure};
use std::process::ExitCode;
use std::sync::{Arc, Mutex, PoisonError};
use std::time::Duration;
use version::VERSION;

/// Finds and corrects errors in published formulas, with proofs, and unrolls surfaces to patterns.
///
/// A paper is a folder of derivation files, which state each claim as a formula. torse decides claims by exact
/// computation; it computes every verdict anew on every run. A design is a file with control data of developable
/// surfaces, which torse measures, unrolls, exports and draws.
#[derive(Parser)]
#[command(name = "torse", version = VERSION, max_term_width = 100, after_help = EXAMPLES, after_long_help = LONG_EXAMPLES)]
struct Arguments {
    /// End the run after this many seconds, without verdicts (exit code 8)
    #[arg(long, value_name = "SECONDS", global = true, default_value_t = TIME_LIMIT, value_parser = clap::value_parser!(u64).range(1..))]
    time_limit: u64,
    #[command(subcommand)]
    command: Command,
}

const EXAMPLES: &str = "\
Examples:
  torse verify                           all claims of all papers
  torse verify gbt-developable/thm-4     the claims of one theorem
  torse verify my-paper --watch          again after every change of its files
  torse decide \"(a + b)^2 == a^2 + b^2\"  one statement, without any folder
  torse explain gbt-developable/thm-4.c  why a formula is wrong, and what is right
  torse compare CLAIM --code basis.py:f  does this function compute what the paper prints?
  torse report                           verdicts, PDF, HTML and figures into reports/
  torse erratum gbt-surfaces             the corrections, ready to be sent
  torse derive gbt-surfaces f --join c   C1 to C3 conditions of a basis, for every degree
  torse recheck                          every verdict tested again, with more work
  torse prove --check                    proofs of the verdicts, checked by the Rocq kernel
  torse audit gbt-developable            signs that a statement is not what is printed
  torse new my-paper                     a folder that verifies, to begin from
  torse inspect designs/cone-elbow.toml  can it be made? patches and joints, measured
  torse unroll DESIGN.toml --to part.dxf the cut files, one for each part
  torse lint part.dxf --thickness 2      would a cutting service accept this drawing?
  torse studio designs                   the designs of a folder in a browser, on this machine
  torse lsp                              verdicts beside the lines of an editor, which starts it

`torse help COMMAND` says more, `torse --help` lists the exit codes.";

const LONG_EXAMPLES: &str = "\
Examples:
  torse verify                           all claims of all papers
  torse verify gbt-developable/thm-4     the claims of one theorem
  torse verify --format json             the same for programs, byte-identical on every run
  torse decide \"(a + b)^2 == a^2 + b^2\"  one statement, without any folder
  torse explain gbt-developable/thm-4.c  why a formula is wrong, and what is right
  torse compare CLAIM --code basis.py:f  does this function compute what the paper prints?
  torse report                           verdicts, PDF, HTML and figures into reports/
  torse erratum gbt-surfaces             the corrections, ready to be sent
  torse derive gbt-surfaces f --join c   C1 to C3 conditions of a basis, for every degree
  torse recheck                          every verdict tested again, with more work
  torse prove --check                    proofs of the verdicts, checked by the Rocq kernel
  torse audit gbt-developable            signs that a statement is not what is printed
  torse new my-paper                     a folder that verifies, to begin from
  torse inspect designs/cone-elbow.toml  can it be made? patches and joints, measured
  torse unroll DESIGN.toml --to part.dxf the cut files, one for each part
  torse lint part.dxf --thickness 2      would a cutting service accept this drawing?
  torse studio designs                   the designs of a folder in a browser, on this machine
  torse lsp                              verdicts beside the lines of an editor, which starts it

Exit codes (if several apply, the first of this list):
  101  torse itself has failed: an internal error, which is to be reported
  6  two checks of a verdict contradict each other (prover, second evaluator, replay, kernel): the
     claim is `undecided`, with \"internal contradiction\"
  2  the command line is wrong: an unknown name, a file or folder that is missing or cannot be read
  4  what a file says is wrong: all mistakes of derivations and designs are shown with file, line and
     column, and the claims without a mistake are decided all the same
  5  an output could not be made or written
  8  the time limit (`--time-limit SECONDS`) ended the run, without verdicts
  7  a required program is missing (coqc)
  1  a verdict differs from its derivation file or from an earlier run; code differs from the print;
     a flag of the audit is open; a design misses a tolerance; a drawing breaks a rule;
     an editor left `torse lsp` without a word
  3  a claim named by its full id, or whether code equals the print, is undecided
  0  every verdict is as expected, or nothing was expected

Colours and progress are for terminals only; NO_COLOR=1 turns colours off there too.";

#[derive(Subcommand)]
enum Command {
    Verify(verify::Verify),
    Decide(decide::Decide),
    Compare(compare::Compare),
    List(list::List),
    Merge(merge::Merge),
    Explain(explain::Explain),
    Report(report::Report),
    Erratum(erratum::Erratum),
    Derive(derive::Derive),
    Recheck(recheck::RecheckCommand),
    Prove(prove::Prove),
    Audit(audit::Audit),
    New(new::New),
    Inspect(design::Inspect),
    Unroll(unroll::Unroll),
    Lint(lint::Lint),
    Fold(design::Fold),
    Export(design::Export),
    Eval(design::Eval),
    Draw(design::Draw),
    Studio(studio::Studio),
    Lsp(lsp::Lsp),
    Completions(completions::Completions),
}

impl Command {
    fn run(&self) -> Result<Exit, Failure> {
        match self {
            Command::Verify(command) => command.run(),
            Command::Decide(command) => command.run(),
            Command::Compare(command) => command.run(),
            Command::List(command) => command.run(),
            Command::Merge(command) => command.run(),
            Command::Explain(command) => command.run(),
            Command::Report(command) => command.run(),
            Command::Erratum(command) => command.run(),
            Command::Derive(command) => command.run(),
            Command::Recheck(command) => command.run(),
            Command::Prove(command) => command.run(),
            Command::Audit(command) => command.run(),
            Command::New(command) => command.run(),
            Command::Inspect(command) => command.run(),
            Command::Unroll(command) => command.run(),
            Command::Lint(command) => command.run(),
            Command::Fold(command) => command.run(),
            Command::Export(command) => command.run(),
            Command::Eval(command) => command.run(),
            Command::Draw(command) => command.run(),
            Command::Studio(command) => command.run(),
            Command::Lsp(command) => command.run(),
            Command::Completions(command) => command.run(Arguments::command()),
        }
    }
}

/// Seconds: a hundred times the time for the three papers.
const TIME_LIMIT: u64 = 3600;

/// Bytes of the stack of every computing thread. The height of formulas and the depth of definitions are bounded, and
/// their product fits; memory is used only as far as a stack grows.
const STACK: usize = 256 * 1024 * 1024;

fn run(arguments: &Arguments) -> Exit {
    watchdog::watch(Duration::from_secs(arguments.time_limit));
    arguments.command.run().unwrap_or_else(|failure| {
        watchdog::finished();
        terminal::complain(&failure);
        failure.exit()
    })
}

fn main() -> ExitCode {
    let arguments = match Arguments::try_parse() {
        Ok(arguments) => arguments,
        Err(error) if error.use_stderr() => {
            terminal::remark(&terminal::usage(&error));
            return Exit::Usage.into();
        }
        Err(help) => help.exit(),
    };
    // A claim that panics is undecided and says why; the place in our code is told only where the whole run ends.
    let panicked = Arc::new(Mutex::new(String::new()));
    let last = Arc::clone(&panicked);
    std::panic::set_hook(Box::new(move |panic| {
        *last.lock().unwrap_or_else(PoisonError::into_inner) = panic.to_string();
    }));
    // There is one pool, made here; were there one already, its threads would do.
    let _ = rayon::ThreadPoolBuilder::new()
        .stack_size(STACK)
        .build_global();
    let main = std::thread::Builder::new().stack_size(STACK);
    let exit = match main.spawn(move || run(&arguments)) {
        Ok(thread) => thread.join().map_err(|_| {
            let last = panicked.lock().unwrap_or_else(PoisonError::into_inner);
            internal_error(&last)
        }),
        Err(error) => Err(format!("torse cannot go on: {error}\n")),
    };
    match exit {
        Ok(exit) => exit.into(),
        Err(reason) => {
            terminal::remark(&reason);
            ExitCode::from(101)
        }
    }
}

/// What is said of a fault of our own.
fn internal_error(panicked: &str) -> String {
    format!(
        "internal error: torse {VERSION} has failed, and your files are not to blame\n  {}\n\
         Please report it {} with these lines, the command and the files that it read.\n",
        panicked.replace('\n', "\n  "),
        address(env!("CARGO_PKG_REPOSITORY"))
    )
}

/// Where it is reported: at the repository that the package names, if it names one.
fn address(repository: &str) -> String {
    match repository.trim_end_matches('/') {
        "" => "to those from whom you have torse".to_owned(),
        repository => format!("at {repository}/issues"),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_internal_error_says_what_failed_and_where_to_report_it() {
        let message = internal_error("panicked at src/x.rs:1:2:\nwhy");
        for part in [VERSION, "src/x.rs:1:2", "why", "report it"] {
            assert!(message.contains(part), "{message}");
        }
        let address = address("https://example.org/torse/");
        assert_eq!(address, "at https://example.org/torse/issues");
    }
}
