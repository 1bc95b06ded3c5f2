//! `torse verify`: what is true of the claims.

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
/// Without names, all claims of all papers. A name is a paper, a claim's id, or what several ids begin
/// with. The exit code is 0 when every verdict is as expected, 1 when one differs from what its derivation
/// file expects, and 3 when a claim named by its full id is undecided (in a whole paper that is no failure).
/// When files are wrong, all mistakes are shown, those of figures too; the claims that are right are decided all the
/// same, and the exit code is 4.
#[derive(Args)]
#[command(after_help = EXAMPLES)]
pub struct Verify {
    /// Papers, claims, or beginnings of ids
    #[arg(value_name = "PAPER|ID")]
    names: Vec<String>,
    /// A table for readers, or JSON for programs
    #[arg(long, value_enum, default_value_t = Format::Text)]
    format: Format,
    /// Show what differs from this earlier run (its JSON) instead; any difference of a verdict, its evidence or its
    /// conditions makes the exit code 1
    #[arg(long, value_name = "FILE.json")]
    against: Option<PathBuf>,
    /// Write what each verdict rests on into this folder, as JSON: a file a paper, whole or not at all
    #[arg(long, value_name = "DIR")]
    proofs: Option<PathBuf>,
    /// Verify again whenever a derivation file changes, and show what differs; Ctrl-C ends it. Only papers with changed files
    /// are decided again
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
    /// Decides, prints, and says how it went.
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
        // Where nothing is right there is nothing to show.
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
