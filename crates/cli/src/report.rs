//! `torse report`: verdicts, typeset reports and figures into a folder.

use crate::derivations::Derivations;
use crate::exit::{Exit, Failure};
use crate::figures::{self, Drawn};
use crate::run::Run;
use crate::terminal::Progress;
use crate::{selection, terminal};
use clap::Args;
use std::path::{Path, PathBuf};
use torse_claims::PaperOutcome;
use torse_report::{FigureImage, Image, Typeset, html_page, verdicts_json, write_file};

/// Decide all claims, draw the figures, and write everything into a folder.
///
/// The folder gets `verdicts.json` and `summary.pdf` over all papers, `PAPER.pdf` and `PAPER.html` for each
/// paper, and the figures as PNG and SVG under `figures/`. Naming papers leaves out the reports and figures
/// of the others; verdicts and summary are always of all. The same input gives the same bytes.
#[derive(Args)]
#[command(after_help = EXAMPLES)]
pub struct Report {
    /// The papers to report on [default: all]
    #[arg(value_name = "PAPER")]
    papers: Vec<String>,
    /// The folder to write to; it is made if need be
    #[arg(long, value_name = "DIR", default_value = "reports")]
    out: PathBuf,
    #[command(flatten)]
    derivations: Derivations,
}

const EXAMPLES: &str = "\
Examples:
  torse report
  torse report gbt-developable --out /tmp/gbt";

impl Report {
    /// Decides, draws, typesets, writes, and says how it went.
    pub fn run(&self) -> Result<Exit, Failure> {
        let papers = self.derivations.load()?;
        selection::check_papers(&papers, &self.papers)?;
        for paper in &papers {
            check_slug(&paper.head.id)?;
        }
        let run = Run::of(&papers)?;
        let wanted: Vec<&PaperOutcome> =
            run.papers.iter().filter(|p| self.wants(&p.slug)).collect();
        let sources = papers.iter().filter(|paper| self.wants(&paper.head.id));
        let figures = sources
            .clone()
            .map(|paper| paper.figures().count())
            .sum::<usize>();
        let mut folder = Folder {
            path: &self.out,
            progress: Progress::new("reporting", figures + 2 * wanted.len() + 2),
            written: Vec::new(),
        };
        folder.write("verdicts.json", verdicts_json(run.outcomes())?.as_bytes())?;
        for (paper, source) in wanted.into_iter().zip(sources) {
            let drawn = figures::drawn(source, &folder.progress)?;
            let figures = drawn
                .into_iter()
                .map(|figure| folder.figure(figure))
                .collect::<Result<Vec<_>, _>>()?;
            folder.paper(paper, &figures)?;
        }
        folder.write("summary.pdf", &Typeset::summary(&run.papers)?.pdf()?)?;
        folder.progress.finish();
        terminal::print(&folder.written.concat())?;
        Ok(Exit::of(run.outcomes(), &[]))
    }

    fn wants(&self, slug: &str) -> bool {
        self.papers.is_empty() || self.papers.iter().any(|name| name == slug)
    }
}

/// Fails unless `slug` can be the name of a paper's files: it stays in the folder and takes no other
/// file's name.
fn check_slug(slug: &str) -> Result<(), Failure> {
    let plain = |character: char| character.is_ascii_alphanumeric() || character == '-';
    match !slug.is_empty() && slug.chars().all(plain) && slug != "summary" {
        true => Ok(()),
        false => Err(Failure::Slug {
            slug: slug.to_owned(),
        }),
    }
}

/// The folder being written to, and what was written so far.
struct Folder<'a> {
    path: &'a Path,
    progress: Progress,
    written: Vec<String>,
}

impl Folder<'_> {
    fn write(&mut self, name: &str, bytes: &[u8]) -> Result<(), Failure> {
        self.save(name, bytes)?;
        self.progress.step();
        Ok(())
    }

    fn save(&mut self, name: &str, bytes: &[u8]) -> Result<(), Failure> {
        let path = self.path.join(name);
        write_file(&path, bytes)?;
        self.written.push(format!("{}\n", path.display()));
        Ok(())
    }

    fn figure(&mut self, figure: Drawn) -> Result<FigureImage, Failure> {
        let Drawn { plate, svg, png } = figure;
        let name = plate.name();
        self.save(&format!("figures/{name}.png"), &png)?;
        self.save(&format!("figures/{name}.svg"), svg.as_bytes())?;
        Ok(FigureImage {
            name,
            caption: plate.caption(),
            alt: plate.drawing().alt.clone(),
            image: Image::Svg(svg),
            claims: plate.drawing().claims.clone(),
        })
    }

    fn paper(&mut self, paper: &PaperOutcome, figures: &[FigureImage]) -> Result<(), Failure> {
        self.progress.doing(&paper.slug);
        let pdf = Typeset::paper(paper, figures)?.pdf()?;
        self.write(&format!("{}.pdf", paper.slug), &pdf)?;
        let html = html_page(paper, figures)?;
        self.write(&format!("{}.html", paper.slug), html.as_bytes())
    }
}
