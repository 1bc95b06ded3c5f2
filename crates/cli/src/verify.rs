//! `torse verify`: the verdicts of claims.

use crate::baseline::{self, Verdicts};
use crate::derivations::Derivations;
use crate::exit::{Exit, Failure};
use crate::format::Format;
use crate::kernel::Kernel;
use crate::run::{Budget, Run};
use crate::watch::Watch;
use crate::{figures, proofs, terminal, verdicts, watchdog};
use clap::Args;
use std::path::PathBuf;
use torse_report::{ReportError, verdicts_json_with_kernel};
use torse_syntax::derivation::Paper;

/// Decide claims and show their verdicts.
///
/// Names are papers, ids of claims, or prefixes of ids; without names, torse decides all claims of all papers. The exit
/// code is 0 if every verdict is as expected, 1 if one differs from its derivation file, and 3 if a claim named by its
/// full id is undecided (in a whole paper that is no failure). If files are wrong, torse shows all mistakes, those of
/// figures too, decides the claims without a mistake all the same, and ends with exit code 4.
#[derive(Args)]
#[command(after_help = EXAMPLES)]
pub struct Verify {
    /// Papers, claims, or prefixes of ids
    #[arg(value_name = "PAPER|ID")]
    names: Vec<String>,
    /// Print a table, or JSON for programs
    #[arg(long, value_enum, default_value_t = Format::Text)]
    format: Format,
    /// Show only differences from this earlier run (its JSON); the exit code is 1 if a verdict, its evidence or its
    /// conditions differ
    #[arg(long, value_name = "FILE.json")]
    against: Option<PathBuf>,
    /// Write the proofs of the verdicts to this folder, as JSON, a file for each paper
    #[arg(long, value_name = "DIR")]
    proofs: Option<PathBuf>,
    /// Verify again whenever a derivation file changes, and show the differences; Ctrl-C ends it. Only papers with
    /// changed files are decided again
    #[arg(long, conflicts_with_all = ["format", "against", "proofs", "timings"])]
    watch: bool,
    /// List the ten slowest claims on standard error
    #[arg(long)]
    timings: bool,
    #[command(flatten)]
    kernel: Kernel,
    #[command(flatten)]
    budget: Budget,
    #[command(flatten)]
    derivations: Derivations,
}

const EXAMPLES: &str = "\
Examples:
  torse verify
  torse verify gbt-developable hermite-developable/ex-4
  torse verify --format json > verdicts.json
  torse verify --against verdicts.json
  torse verify my-paper --watch
  torse verify hermite-developable --proofs my-proofs
  torse verify --timings --derivations my-papers";

impl Verify {
    /// Decides, prints, and returns the exit code.
    pub fn run(&self) -> Result<Exit, Failure> {
        if self.watch {
            let watch = Watch {
                derivations: &self.derivations,
                names: &self.names,
                budget: self.budget,
            };
            return watch.run();
        }
        let (papers, mut mistakes) = self.derivations.select(&self.names)?;
        let before = self.against.as_deref().map(Verdicts::read).transpose()?;
        let run = Run::new(&papers, self.budget, &mut mistakes);
        figures::evaluated(&papers, &mut mistakes);
        watchdog::finished();
        let mut exit = Exit::from_outcomes(run.outcomes(), &self.names);
        let json = match (self.format, &before) {
            (Format::Text, None) => String::new(),
            _ => self.json(&papers, &run)?,
        };
        // If no claim is right, there is nothing to show.
        if mistakes.is_empty() || run.outcomes().next().is_some() {
            match self.format {
                Format::Text if before.is_some() => {}
                Format::Text => terminal::print(&verdicts::text(&run.papers))?,
                Format::Json => terminal::print(&json)?,
            }
        }
        if let Some(before) = before {
            let now = Verdicts::parse(&json);
            let now = now.map_err(ReportError::from)?;
            let found = baseline::differences(&before.named(&self.names), &now);
            match self.format {
                Format::Text => terminal::print(&baseline::text(&found))?,
                Format::Json => terminal::remark(&baseline::text(&found)),
            }
            if !found.is_empty() {
                exit = exit.max(Exit::Differs);
            }
        }
        if let Some(folder) = &self.proofs {
            proofs::write(folder, &run.papers)?;
        }
        if self.timings {
            terminal::remark(&slowest(&run));
        }
        Ok(mistakes.tell(exit))
    }

    fn json(&self, papers: &[Paper], run: &Run) -> Result<String, ReportError> {
        verdicts_json_with_kernel(run.outcomes(), &self.kernel.accepted(papers, run))
    }
}

fn slowest(run: &Run) -> String {
    let mut text = String::from("slowest claims, in milliseconds of wall time:\n");
    for (id, time) in run.slowest(10) {
        text.push_str(&format!("{:>9.1}  {id}\n", 1e3 * time.as_secs_f64()));
    }
    text
}
