//! `torse verify`: what is true of the claims.

use crate::derivations::Derivations;
use crate::exit::{Exit, Failure};
use crate::run::Run;
use crate::{selection, terminal, verdicts};
use clap::{Args, ValueEnum};
use torse_report::verdicts_json;

/// Decide claims and show their verdicts.
///
/// Without names, all claims of all papers. A name is a paper, a claim's id, or what several ids begin
/// with. The exit code is 0 when every verdict is as expected, 1 when one differs from what its derivation
/// file expects, and 3 when a claim named by its full id is undecided (in a whole paper that is no failure).
#[derive(Args)]
#[command(after_help = EXAMPLES)]
pub struct Verify {
    /// Papers, claims, or beginnings of ids
    #[arg(value_name = "PAPER|ID")]
    names: Vec<String>,
    /// A table for readers, or JSON for programs
    #[arg(long, value_enum, default_value_t = Format::Text)]
    format: Format,
    /// List the ten slowest claims on standard error
    #[arg(long)]
    timings: bool,
    #[command(flatten)]
    derivations: Derivations,
}

const EXAMPLES: &str = "\
Examples:
  torse verify
  torse verify gbt-developable hermite-developable/ex-4
  torse verify --format json > verdicts.json
  torse verify --timings --derivations my-papers";

#[derive(Clone, Copy, ValueEnum)]
enum Format {
    Text,
    Json,
}

impl Verify {
    /// Decides, prints, and says how it went.
    pub fn run(&self) -> Result<Exit, Failure> {
        let papers = selection::select(self.derivations.load()?, &self.names)?;
        let run = Run::of(&papers)?;
        terminal::print(&match self.format {
            Format::Text => verdicts::text(&run.papers),
            Format::Json => verdicts_json(run.outcomes())?,
        })?;
        if self.timings {
            terminal::remark(&slowest(&run));
        }
        Ok(Exit::of(run.outcomes(), &self.names))
    }
}

fn slowest(run: &Run) -> String {
    let mut text = String::from("slowest claims, in milliseconds of wall time:\n");
    for (id, time) in run.slowest(10) {
        text.push_str(&format!("{:>9.1}  {id}\n", 1e3 * time.as_secs_f64()));
    }
    text
}
