//! `torse report`: verdicts, typeset reports and figures into a folder.

use crate::derivations::{Derivations, LoadedDerivations};
use crate::documents::{Document, Made};
use crate::exit::{Exit, Failure};
use crate::figures::{Evaluated, FOLDER as FIGURES};
use crate::kernel::Kernel;
use crate::run::{Budget, Run};
use crate::terminal::{Progress, counted};
use crate::{documents, erratum, figures, terminal, watchdog};
use clap::Args;
use rayon::prelude::*;
use std::collections::BTreeSet;
use std::path::{Path, PathBuf};
use torse::selection;
#[cfg(feature = "pdf")]
use torse_report::Manuscript;
use torse_report::model::Report as Model;
use torse_report::{
    Envelope, FigureImage, Source, gallery, html_page, landing_page, verdict_lines,
    verdicts_json_with_kernel,
};
use torse_syntax::derivation::Paper;
use torse_syntax::derivation::schema::is_plain;
use torse_verdicts::outcome::PaperOutcome;

/// Decide the claims, draw the figures, and write reports into a folder.
///
/// torse writes `verdicts.json`, `verdicts.csv` (a line for each claim) and `summary.pdf` for all papers; `PAPER.pdf`,
/// `PAPER.html` and a letter of corrections (`PAPER-erratum.tex`, `.pdf`, `.md`) for each paper; `index.html`, which
/// links to them; the figures as PNG and SVG (developable surfaces also as STEP) in `figures/`, and `gallery.md`, which
/// shows all of them. If you name papers, only their claims are decided, and only their reports, letters and figures are
/// written. If a derivation file is wrong, nothing is written. Claims are decided anew; figures and PDFs that did not
/// change are reused. The same input gives the same bytes.
#[derive(Args)]
#[command(after_help = EXAMPLES)]
pub struct Report {
    /// Report on these papers [default: all]
    #[arg(value_name = "PAPER")]
    papers: Vec<String>,
    /// Write to this folder; it is created if necessary
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
  torse report
  torse report gbt-developable --out gbt-report";

impl Report {
    /// Decides, draws, typesets, writes, and says what was written.
    pub fn run(&self) -> Result<Exit, Failure> {
        let LoadedDerivations {
            papers,
            mut mistakes,
            ..
        } = self.derivations.load()?;
        selection::check_papers(&papers, &self.papers)?;
        for paper in &papers {
            check_slug(&paper.head.id)?;
        }
        let papers: Vec<Paper> = (papers.into_iter())
            .filter(|paper| self.wants(&paper.head.id))
            .collect();
        let mut run = Run::new(&papers, self.budget, &mut mistakes);
        run.restore(&papers, self.budget, &mut mistakes);
        let evaluated = figures::evaluated(&papers, &mut mistakes);
        watchdog::finished();
        // A report must not leave out a claim of the paper.
        if !mistakes.is_empty() {
            return Ok(mistakes.tell(Exit::BadData));
        }
        let wanted: Vec<(&[Evaluated], &PaperOutcome)> = (evaluated.iter().zip(&run.papers))
            .map(|(figures, outcome)| (figures.as_slice(), outcome))
            .collect();
        let pictures: usize = wanted.iter().map(|(figures, _)| figures.len()).sum();
        let progress = Progress::new("reporting", pictures + 5 * wanted.len() + 3);
        // The statements for the kernel are written one after the other: beside the figures they take no time of their own.
        let (figures, accepted) = rayon::join(
            || self.figures(&wanted, &progress),
            || self.kernel.accepted(&papers, &run),
        );
        let figures = figures?;
        let shown: Vec<(&PaperOutcome, &[FigureImage])> = (wanted.iter().zip(&figures))
            .map(|((_, outcome), figures)| (*outcome, figures.as_slice()))
            .collect();
        let sources: Vec<Source> = (papers.iter())
            .map(|paper| self.derivations.source(&paper.head))
            .collect::<Result<_, _>>()?;
        let reports: Vec<Model> = (run.papers.par_iter())
            .map(|paper| {
                let figures = shown.iter().find(|(of, _)| of.slug == paper.slug);
                let figures = figures.map_or(&[][..], |(_, figures)| *figures);
                Model::with_kernel(paper, figures, &accepted)
            })
            .zip(sources)
            .map(|(report, source)| {
                let mut report = report.from_source(source);
                report.has_neighbours = self.papers.is_empty();
                report
            })
            .collect();
        let documents = self.documents(&run, &reports, &shown, &accepted);
        let names = documents::write(&self.out, &documents, &progress)?;
        progress.finish();
        let lines: Vec<String> = names.iter().map(|name| self.line(name)).collect();
        let ending = self.ending(&reports, &figures);
        terminal::print(&(lines.concat() + &ending))?;
        Ok(Exit::from_outcomes(run.outcomes(), &[]))
    }

    fn wants(&self, slug: &str) -> bool {
        self.papers.is_empty() || self.papers.iter().any(|name| name == slug)
    }

    /// The figures of each paper, drawn unless they are in the folder already.
    fn figures(
        &self,
        wanted: &[(&[Evaluated], &PaperOutcome)],
        progress: &Progress,
    ) -> Result<Vec<Vec<FigureImage>>, Failure> {
        let folder = self.out.join(FIGURES);
        let mut fingerprints = figures::read_fingerprints(&folder);
        let mut all = Vec::new();
        for (figures, _) in wanted {
            let shown = figures::shown(figures, &folder, &fingerprints, progress)?;
            let mut images = Vec::new();
            for figure in shown {
                fingerprints.insert(figure.image.name.clone(), figure.fingerprint);
                images.push(figure.image);
            }
            all.push(images);
        }
        if all.iter().any(|images| !images.is_empty()) {
            figures::remember(&folder, &fingerprints)?;
        }
        Ok(all)
    }

    /// What is written besides the figures, each document independent of the others.
    fn documents<'a>(
        &self,
        run: &'a Run,
        reports: &'a [Model],
        shown: &'a [(&'a PaperOutcome, &'a [FigureImage])],
        accepted: &'a BTreeSet<String>,
    ) -> Vec<Document<'a>> {
        let mut documents = Vec::new();
        for (paper, figures) in shown {
            let Some(report) = reports.iter().find(|report| report.slug == paper.slug) else {
                continue;
            };
            #[cfg(feature = "pdf")]
            documents.push(Document::new(format!("{}.pdf", paper.slug), || {
                Manuscript::paper(report, figures).map(Made::Manuscript)
            }));
            documents.push(Document::new(format!("{}.html", paper.slug), || {
                Ok(Made::Bytes(html_page(report, figures)?.into_bytes()))
            }));
            for (ending, letter) in erratum::LETTERS {
                let name = erratum::file(&paper.slug, ending);
                documents.push(Document::new(name, move || {
                    letter(report, &Envelope::default())
                }));
            }
        }
        if self.papers.is_empty() {
            #[cfg(feature = "pdf")]
            documents.push(Document::new("summary.pdf", || {
                Manuscript::summary(reports).map(Made::Manuscript)
            }));
            documents.push(Document::new("verdicts.json", || {
                let text = verdicts_json_with_kernel(run.outcomes(), accepted)?;
                Ok(Made::Bytes(text.into_bytes()))
            }));
            documents.push(Document::new("verdicts.csv", || {
                let text = verdict_lines(run.outcomes(), accepted)?;
                Ok(Made::Bytes(text.into_bytes()))
            }));
            documents.push(Document::new("gallery.md", || {
                Ok(Made::Bytes(gallery(shown)?.into_bytes()))
            }));
            documents.push(Document::new("index.html", || {
                Ok(Made::Bytes(landing_page(reports)?.into_bytes()))
            }));
        }
        documents
    }

    /// Counts what was written besides the documents, and says where to begin to read.
    fn ending(&self, reports: &[Model], figures: &[Vec<FigureImage>]) -> String {
        let first = match (self.papers.as_slice(), reports) {
            ([], _) => "index.html".to_owned(),
            (_, [report, ..]) => format!("{}.html", report.slug),
            (_, []) => return String::new(),
        };
        let figures: usize = figures.iter().map(Vec::len).sum();
        let drawn = match figures {
            0 => String::new(),
            _ => format!(
                " and {} in {}",
                counted(figures, "figure"),
                self.out.join(FIGURES).display()
            ),
        };
        let reports = counted(reports.len(), "report");
        let first = self.out.join(first);
        format!(
            "\n{reports}{drawn}\nNext: open {} in a browser\n",
            first.display()
        )
    }

    /// Returns the line for a written file.
    fn line(&self, name: impl AsRef<Path>) -> String {
        format!("{}\n", self.out.join(name).display())
    }
}

/// File names that no paper may have.
const TAKEN: [&str; 2] = ["summary", "index"];

/// Suffix of the name of a paper's letter.
const LETTER: &str = "-erratum";

/// Fails unless `slug` can be the name of a paper's files: it stays in the folder and takes no other
/// file's name.
fn check_slug(slug: &str) -> Result<(), Failure> {
    match is_plain(slug) && !TAKEN.contains(&slug) && !slug.ends_with(LETTER) {
        true => Ok(()),
        false => Err(Failure::Slug {
            slug: slug.to_owned(),
        }),
    }
}
