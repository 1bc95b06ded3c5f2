//! `torse erratum`: the corrections of a paper, ready to be sent.

use crate::derivations::{Derivations, Found};
use crate::documents::Made;
use crate::exit::{Exit, Failure};
use crate::kernel::Kernel;
use crate::run::{Budget, Run};
use crate::{guard, selection, terminal};
use clap::Args;
use std::path::PathBuf;
use torse_report::model::Report;
use torse_report::{Manuscript, ReportError, erratum_latex, erratum_markdown, write_file};
use torse_syntax::derivation::Paper;

/// Write the corrections of a paper as TeX, PDF and Markdown, ready to be sent to its authors or journal.
///
/// Each has the place, what is printed, what is to be read instead, and why: the point at which the print
/// fails. Only what is false in every reading that its words allow goes into them, and nothing that may be
/// a slip of the copy at hand; a paper without any such statement gets a letter that says so.
#[derive(Args)]
#[command(after_help = EXAMPLES)]
pub struct Erratum {
    /// The paper
    #[arg(value_name = "PAPER")]
    paper: String,
    /// The folder to write to; it is made if need be
    #[arg(long, value_name = "DIR", default_value = "reports")]
    out: PathBuf,
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
  torse erratum gbt-developable --out letters";

/// How a letter is made.
type Letter = fn(&Report) -> Result<Made, ReportError>;

/// The files of a letter: their endings, and what makes them.
pub const LETTERS: [(&str, Letter); 3] = [
    ("tex", |report| {
        Ok(Made::Bytes(erratum_latex(report).into_bytes()))
    }),
    ("pdf", |report| {
        Manuscript::erratum(report).map(Made::Manuscript)
    }),
    ("md", |report| {
        Ok(Made::Bytes(erratum_markdown(report).into_bytes()))
    }),
];

/// The name of a file of a paper's letter.
pub fn file(slug: &str, ending: &str) -> String {
    format!("{slug}-erratum.{ending}")
}

impl Erratum {
    /// Decides the paper, writes the letter, and says what was written.
    pub fn run(&self) -> Result<Exit, Failure> {
        let Found {
            papers,
            mut mistakes,
            ..
        } = self.derivations.load()?;
        selection::paper(&papers, &self.paper)?;
        let wanted = |paper: &Paper| paper.head.id == self.paper;
        let papers: Vec<Paper> = papers.into_iter().filter(wanted).collect();
        let run = Run::of(&papers, self.budget, &mut mistakes);
        guard::finished();
        // A letter without a correction that belongs into it would not be one.
        if !mistakes.is_empty() {
            return Ok(mistakes.tell(Exit::BadData));
        }
        let accepted = self.kernel.accepted(&papers, &run);
        let mut written = String::new();
        for paper in &run.papers {
            let report = Report::with_kernel(paper, &[], &accepted);
            for (ending, letter) in LETTERS {
                let file = self.out.join(file(&paper.slug, ending));
                write_file(&file, &letter(&report)?.bytes()?)?;
                written.push_str(&format!("{}\n", file.display()));
            }
        }
        terminal::print(&written)?;
        Ok(Exit::of(run.outcomes(), &[]))
    }
}
