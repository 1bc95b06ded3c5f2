//! `torse erratum`: the corrections of a paper, ready to be sent.

use crate::derivations::{Derivations, LoadedDerivations};
use crate::documents::Made;
use crate::exit::{Exit, Failure};
use crate::kernel::Kernel;
use crate::run::{Budget, Run};
use crate::{terminal, watchdog};
use clap::Args;
use std::path::PathBuf;
use torse::selection;
#[cfg(feature = "pdf")]
use torse_report::Manuscript;
use torse_report::model::Report;
use torse_report::{Envelope, ReportError, erratum_latex, erratum_markdown, glossary, write_file};
use torse_syntax::derivation::Paper;
use torse_verdicts::audit::corrected_words;
use torse_verdicts::outcome::Restored;

/// Write the corrections of a paper as TeX, PDF and Markdown, ready to be sent to its authors or journal.
///
/// Each fault has one item: its place, the fault in one sentence, the printed text and what it should say, with changes
/// framed, and an exact counterexample. Conditions that the text should state, and possible faults of our copy, have
/// parts of their own. For a paper without a fault, the letter says so.
#[derive(Args)]
#[command(after_help = EXAMPLES)]
pub struct Erratum {
    /// The paper
    #[arg(value_name = "PAPER")]
    paper: String,
    /// Write to this folder; it is created if necessary
    #[arg(long, value_name = "DIR", default_value = "reports")]
    out: PathBuf,
    /// Decide the statements that the corrections concern and all that rest on them again, with all corrections in force,
    /// and say what holds then
    #[arg(long)]
    verify: bool,
    /// Sign the letter with this name; without it every page says that it is a draft
    #[arg(long, value_name = "NAME")]
    sender: Option<String>,
    /// Date the letter
    #[arg(long, value_name = "DATE")]
    date: Option<String>,
    #[command(flatten)]
    kernel: Kernel,
    #[command(flatten)]
    budget: Budget,
    #[command(flatten)]
    derivations: Derivations,
}

const EXAMPLES: &str = "\
Examples:
  torse erratum gbt-surfaces
  torse erratum gbt-developable --out letters --verify
  torse erratum gbt-surfaces --sender 'A. Reader' --date '1 May 2026'";

/// How a letter is made.
type Letter = fn(&Report, &Envelope) -> Result<Made, ReportError>;

/// The files of a letter: their endings, and what makes them.
pub const LETTERS: &[(&str, Letter)] = &[
    ("tex", |report, envelope| {
        Ok(Made::Bytes(erratum_latex(report, envelope).into_bytes()))
    }),
    #[cfg(feature = "pdf")]
    ("pdf", |report, envelope| {
        Manuscript::erratum(report, envelope).map(Made::Manuscript)
    }),
    ("md", |report, envelope| {
        Ok(Made::Bytes(erratum_markdown(report, envelope).into_bytes()))
    }),
];

/// The name of a file of a paper's letter.
pub fn file(slug: &str, ending: &str) -> String {
    format!("{slug}-erratum.{ending}")
}

impl Erratum {
    /// Decides the paper, writes the letter, and says what was written.
    pub fn run(&self) -> Result<Exit, Failure> {
        let LoadedDerivations {
            papers,
            mut mistakes,
            ..
        } = self.derivations.load()?;
        selection::paper(&papers, &self.paper)?;
        let wanted = |paper: &Paper| paper.head.id == self.paper;
        let papers: Vec<Paper> = papers.into_iter().filter(wanted).collect();
        let mut run = Run::new(&papers, self.budget, &mut mistakes);
        if self.verify {
            run.restore(&papers, self.budget, &mut mistakes);
        }
        watchdog::finished();
        // A letter must not leave out a correction.
        if !mistakes.is_empty() {
            return Ok(mistakes.tell(Exit::BadData));
        }
        if self.verify {
            words_are_decided(&papers, &run)?;
        }
        let accepted = self.kernel.accepted(&papers, &run);
        let envelope = Envelope {
            sender: self.sender.clone(),
            date: self.date.clone(),
        };
        let mut written = String::new();
        for (paper, files) in run.papers.iter().zip(&papers) {
            let source = self.derivations.source(&files.head)?;
            let report = Report::with_kernel(paper, &[], &accepted).from_source(source);
            if report.letter.scope.decided == 0 {
                let paper = paper.slug.clone();
                return Err(torse::Error::NothingDecided { paper }.into());
            }
            for (ending, letter) in LETTERS {
                let file = self.out.join(file(&paper.slug, ending));
                write_file(&file, &letter(&report, &envelope)?.bytes()?)?;
                written.push_str(&format!("{}\n", file.display()));
            }
        }
        for restored in run
            .papers
            .iter()
            .filter_map(|paper| paper.restored.as_ref())
        {
            let label = |of: &Restored| glossary::verdict(of.verdict).label;
            for of in &restored.corrected {
                written.push_str(&format!("{}  {}\n", of.claim, label(of)));
            }
            for of in &restored.dependents {
                written.push_str(&format!(
                    "{}  {}, rests on a corrected statement\n",
                    of.claim,
                    label(of)
                ));
            }
            for id in &restored.reworded {
                written.push_str(&format!("{id}  words alone\n"));
            }
        }
        terminal::print(&written)?;
        Ok(Exit::from_outcomes(run.outcomes(), &[]))
    }
}

/// Compares the words of each correction with what is decided: an author reads the words.
fn words_are_decided(papers: &[Paper], run: &Run) -> Result<(), Failure> {
    for (paper, outcome) in papers.iter().zip(&run.papers) {
        for claim in &paper.claims {
            let id = claim.entry.id.get_ref();
            let Some(found) = outcome
                .claims
                .iter()
                .find(|decided| decided.claim.id == *id)
            else {
                continue;
            };
            let Some(words) = corrected_words(std::slice::from_ref(paper), claim, found) else {
                continue;
            };
            for reads in &words.reads {
                if let Some(formula) = words.compared(reads).otherwise.first() {
                    return Err(Failure::ReadsOtherwise {
                        claim: id.clone(),
                        reads: formula.clone(),
                        states: words.states(),
                    });
                }
            }
        }
    }
    Ok(())
}
