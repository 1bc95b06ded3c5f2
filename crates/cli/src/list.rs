//! `torse list`: the claims of the derivation files, without deciding any.

use crate::derivations::Derivations;
use crate::exit::{Exit, Failure};
use crate::format::{Format, json_line};
use crate::{terminal, watchdog};
use clap::Args;
use serde::Serialize;
use torse::digests;
use torse_report::{ReportError, glossary};
use torse_syntax::derivation::Paper;

/// List papers and claims with their kinds and places, without deciding them.
///
/// Each claim has a line with its id, its kind and its place in the paper. With `--papers`, each paper has a line with
/// the number of its claims. `--format json` prints a JSON object on each line; that of a claim has a digest of its fields
/// and of the declarations that it sees, which `verify --changed-since` and `merge` compare.
#[derive(Args)]
#[command(after_help = EXAMPLES)]
pub struct List {
    /// Papers, claims, or beginnings of ids [default: all]
    #[arg(value_name = "PAPER|ID")]
    names: Vec<String>,
    /// Print a line for each paper
    #[arg(long)]
    papers: bool,
    /// Print text, or JSON for programs
    #[arg(long, value_name = "FORMAT", default_value = "text")]
    format: Format,
    #[command(flatten)]
    derivations: Derivations,
}

const EXAMPLES: &str = "\
Examples:
  torse list --papers
  torse list gbt-surfaces/thm-2
  torse list --format json";

/// A line of JSON about a claim.
#[derive(Serialize)]
struct ClaimLine<'a> {
    id: &'a str,
    paper: &'a str,
    kind: &'static str,
    at: &'a str,
    uses: &'a [String],
    digest: String,
}

/// A line of JSON about a paper.
#[derive(Serialize)]
struct PaperLine<'a> {
    paper: &'a str,
    claims: usize,
    title: &'a str,
    authors: &'a str,
    venue: &'a str,
}

impl List {
    /// Prints the list.
    pub fn run(&self) -> Result<Exit, Failure> {
        let (papers, mistakes) = self.derivations.select(&self.names)?;
        watchdog::finished();
        let text = match (self.papers, self.format) {
            (true, Format::Text) => paper_table(&papers),
            (false, Format::Text) => claim_table(&papers),
            (true, Format::Json) => lines(papers.iter().map(paper_line))?,
            (false, Format::Json) => lines(claim_lines(&papers))?,
        };
        terminal::print(&text)?;
        Ok(mistakes.tell(Exit::AsExpected))
    }
}

fn paper_line(paper: &Paper) -> PaperLine<'_> {
    PaperLine {
        paper: &paper.head.id,
        claims: paper.claims.len(),
        title: &paper.head.title,
        authors: &paper.head.authors,
        venue: &paper.head.venue,
    }
}

fn claim_lines(papers: &[Paper]) -> impl Iterator<Item = ClaimLine<'_>> {
    let claims = papers
        .iter()
        .flat_map(|paper| paper.claims.iter().map(move |claim| (paper, claim)));
    let digests = digests(papers).into_iter();
    claims
        .zip(digests)
        .map(|((paper, claim), digest)| ClaimLine {
            id: claim.entry.id.get_ref(),
            paper: &paper.head.id,
            kind: glossary::kind(claim.entry.kind).key,
            at: &claim.entry.at,
            uses: &claim.uses,
            digest: digest.digest,
        })
}

fn lines(items: impl Iterator<Item = impl Serialize>) -> Result<String, ReportError> {
    items.map(|item| json_line(&item)).collect()
}

fn paper_table(papers: &[Paper]) -> String {
    let mut table = terminal::table();
    for paper in papers.iter().map(paper_line) {
        table.add_row([
            paper.paper.to_owned(),
            format!("{} claims", paper.claims),
            paper.title.to_owned(),
        ]);
    }
    terminal::lines(&table)
}

fn claim_table(papers: &[Paper]) -> String {
    let mut table = terminal::table();
    for claim in papers.iter().flat_map(|paper| &paper.claims) {
        let kind = glossary::kind(claim.entry.kind).key;
        table.add_row([claim.entry.id.get_ref().as_str(), kind, &claim.entry.at]);
    }
    terminal::lines(&table)
}
