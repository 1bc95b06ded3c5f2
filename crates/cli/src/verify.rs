//! `torse verify`: the verdicts of claims.

use crate::baseline::{self, Verdicts};
use crate::changed::changed;
use crate::derivations::Derivations;
use crate::diagnostics::Diagnostics;
use crate::exit::{Exit, Failure};
use crate::kernel::Kernel;
use crate::run::{Budget, Run};
use crate::shard::ShardHead;
use crate::version::VERSION;
use crate::watch::Watch;
use crate::{figures, proofs, shard, terminal, verdicts, watchdog};
use clap::{Args, ValueEnum};
use std::path::{Path, PathBuf};
use std::time::Instant;
use torse::annotations::{annotations, github, sarif};
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
    /// A table for readers, JSON for programs, or what deserves a look with its place in the files: as a log of SARIF, or as
    /// commands of a workflow of GitHub
    #[arg(long, value_enum, default_value_t = VerifyFormat::Text)]
    format: VerifyFormat,
    /// Show only differences from this earlier run (its JSON; - for standard input); the exit code is 1 if a verdict, its evidence or its
    /// conditions differ
    #[arg(long, value_name = "FILE.json")]
    against: Option<PathBuf>,
    /// Decide only the claims that are new or differ from this revision of git, or from this list (of `torse list --format
    /// json`; - for standard input): in their own fields, or in the declarations that they see
    #[arg(long, value_name = "REV|FILE", conflicts_with_all = ["against", "watch"])]
    changed_since: Option<String>,
    /// Decide exactly the claims of these ids, one a line (- reads standard input), and write each as a line of JSON, for
    /// `torse merge`
    #[arg(long, value_name = "FILE", conflicts_with_all = ["names", "format", "against", "changed_since", "proofs", "watch", "timings"])]
    ids: Option<PathBuf>,
    /// Decide nothing, and print the first line that `--ids` would print: program, budget and what the kernel accepted, which
    /// all parts of a corpus have in common
    #[arg(long, conflicts_with_all = ["names", "ids", "format", "against", "changed_since", "proofs", "watch", "timings", "folder"])]
    head: bool,
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

/// The format of verdicts.
#[derive(Clone, Copy, PartialEq, Eq, ValueEnum)]
enum VerifyFormat {
    Text,
    Json,
    Sarif,
    Github,
}

impl VerifyFormat {
    /// Returns whether only contradictions, unexpected and refuted claims are written.
    fn writes_annotations(self) -> bool {
        matches!(self, Self::Sarif | Self::Github)
    }
}

const EXAMPLES: &str = "\
Examples:
  torse verify
  torse verify gbt-developable hermite-developable/ex-4
  torse verify --format json > verdicts.json
  torse verify --format sarif > torse.sarif
  torse verify --against verdicts.json
  torse verify --changed-since origin/main
  torse verify --ids part.txt > part.ndjson
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
        if self.head {
            return ShardHead::new(self.budget, &self.kernel)?.tell();
        }
        if let Some(ids) = &self.ids {
            return shard::run(ids, self.budget, &self.kernel, &self.derivations);
        }
        let begun = Instant::now();
        let (mut papers, mut mistakes) = self.derivations.select(&self.names)?;
        if let Some(since) = &self.changed_since {
            let all = count(&papers);
            papers = changed(&papers, since, &self.derivations.find()?)?;
            terminal::remark(&format!(
                "{} of {all} claims have changed\n",
                count(&papers)
            ));
            if self.format == VerifyFormat::Text && count(&papers) == 0 {
                // A table of nothing says nothing.
                watchdog::finished();
                return Ok(mistakes.tell(Exit::AsExpected));
            }
        }
        let before = self.against.as_deref().map(Verdicts::read).transpose()?;
        let run = Run::new(&papers, self.budget, &mut mistakes);
        figures::evaluated(&papers, &mut mistakes);
        watchdog::finished();
        let mut exit = Exit::from_outcomes(run.outcomes(), &self.names);
        let json = match (self.format, &before) {
            (VerifyFormat::Json, _) | (_, Some(_)) => self.json(&papers, &run)?,
            _ => String::new(),
        };
        if self.format.writes_annotations() {
            terminal::print(&self.annotations(&papers, &run, &mistakes)?)?;
        } else if mistakes.is_empty() || run.outcomes().next().is_some() {
            // Where nothing is right there is nothing to show.
            match self.format {
                VerifyFormat::Text if before.is_none() => {
                    terminal::print(&verdicts::text(&run.papers))?;
                }
                VerifyFormat::Json => terminal::print(&json)?,
                _ => {}
            }
        }
        if let Some(before) = before {
            let now = Verdicts::parse(&json);
            let now = now.map_err(ReportError::from)?;
            let found = baseline::differences(&before.named(&self.names), &now);
            match self.format {
                VerifyFormat::Text => terminal::print(&baseline::text(&found))?,
                _ => terminal::remark(&baseline::text(&found)),
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
        let exit = mistakes.tell(exit);
        terminal::tell_time(begun.elapsed());
        Ok(exit)
    }

    /// What deserves a look.
    fn annotations(
        &self,
        papers: &[Paper],
        run: &Run,
        mistakes: &Diagnostics,
    ) -> Result<String, Failure> {
        let mut found = mistakes.annotations().to_vec();
        found.extend(annotations(papers, run.outcomes()));
        let folder = self.derivations.find()?;
        let folder = folder.canonicalize().unwrap_or(folder);
        let folder = folder.strip_prefix(root(&folder)).unwrap_or(&folder);
        // Separators as in the addresses of a repository.
        let parts = folder.iter().map(|part| part.to_string_lossy());
        let folder = parts.collect::<Vec<_>>().join("/").replacen("//", "/", 1);
        Ok(match self.format {
            VerifyFormat::Sarif => sarif(&found, &folder, VERSION),
            _ => github(&found, &folder),
        })
    }

    fn json(&self, papers: &[Paper], run: &Run) -> Result<String, ReportError> {
        verdicts_json_with_kernel(run.outcomes(), &self.kernel.accepted(papers, run))
    }
}

/// The folder from which a code host names files: that of the repository; without one, where the command runs.
fn root(folder: &Path) -> PathBuf {
    let mut above = folder.ancestors();
    let repository = above.find(|folder| folder.join(".git").exists());
    let here = || std::env::current_dir().and_then(|here| here.canonicalize());
    repository.map_or_else(|| here().unwrap_or_default(), Path::to_owned)
}

fn count(papers: &[Paper]) -> usize {
    papers.iter().map(|paper| paper.claims.len()).sum()
}

fn slowest(run: &Run) -> String {
    let mut text = String::from("slowest claims, in milliseconds of wall time:\n");
    for (id, time) in run.slowest(10) {
        text.push_str(&format!("{:>9.1}  {id}\n", 1e3 * time.as_secs_f64()));
    }
    text
}
