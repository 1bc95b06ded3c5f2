//! `torse list`: the claims of the derivation files, without deciding any.

use crate::costs::Costs;
use crate::derivations::{Derivations, tell_mistakes};
use crate::diagnostics::Diagnostics;
use crate::exit::{Exit, Failure};
use crate::format::{Format, json_line};
use crate::listing::ListEnd;
use crate::{figures, terminal, watchdog};
use clap::Args;
use serde::Serialize;
use std::path::PathBuf;
use torse::digests;
use torse_report::{ReportError, glossary};
use torse_syntax::derivation::Paper;

/// List papers and claims with their kinds and places, without deciding them.
///
/// Each claim has a line with its id, its kind and its place in the paper. With `--papers`, each paper has a line with
/// the number of its claims. `--format json` prints a JSON object on each line; that of a claim has a digest of its fields
/// and of the declarations that it sees, which `verify --changed-since` and `merge` compare, and what it is expected to cost;
/// the last line has the number of claims and the exit code.
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
    /// Expect a claim that has not changed to cost the work that it has cost in these files, which `torse verify --ids` has
    /// written; lines that say nothing of it are passed over
    #[arg(long, value_name = "FILE", num_args = 1.., conflicts_with = "papers")]
    costs: Vec<PathBuf>,
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
    cost: u64,
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
        if (self.papers, self.format) == (false, Format::Json) {
            return self.claims();
        }
        let (papers, mistakes) = self.derivations.select(&self.names)?;
        watchdog::finished();
        let text = match (self.papers, self.format) {
            (false, _) => claim_table(&papers),
            (true, Format::Text) => paper_table(&papers),
            (true, Format::Json) => {
                let lines = papers.iter().map(paper_line);
                let lines: Result<String, ReportError> =
                    lines.map(|line| json_line(&line)).collect();
                lines?
            }
        };
        terminal::print(&text)?;
        Ok(mistakes.tell(Exit::AsExpected))
    }

    /// Prints a line for each claim, and a last one; all papers are read one after the other, so that a long list takes no
    /// memory.
    fn claims(&self) -> Result<Exit, Failure> {
        let costs = Costs::read(&self.costs)?;
        let mut lines = ClaimLines { costs, count: 0 };
        let mut mistakes = Diagnostics::default();
        if self.names.is_empty() {
            let mut papers = self.derivations.one_by_one()?;
            for slug in papers.slugs().to_vec() {
                let (papers, _) = tell_mistakes(papers.load(&slug), &mut mistakes);
                // No part has a paper without a claim, and none evaluates its figures.
                let bare: Vec<Paper> = papers
                    .iter()
                    .filter(|p| p.claims.is_empty())
                    .cloned()
                    .collect();
                figures::evaluated(&bare, &mut mistakes);
                lines.print(&papers)?;
            }
        } else {
            let (papers, found) = self.derivations.select(&self.names)?;
            mistakes = found;
            lines.print(&papers)?;
        }
        watchdog::finished();
        let exit = mistakes.tell(Exit::AsExpected);
        let end = ListEnd {
            claims: lines.count,
            exit: exit.code(),
        };
        terminal::print(&json_line(&end)?)?;
        Ok(exit)
    }
}

/// The lines of claims, as they are printed.
struct ClaimLines {
    costs: Costs,
    count: usize,
}

impl ClaimLines {
    fn print(&mut self, papers: &[Paper]) -> Result<(), Failure> {
        let claims = papers
            .iter()
            .flat_map(|paper| paper.claims.iter().map(move |claim| (paper, claim)));
        let mut lines = String::new();
        for ((paper, claim), digest) in claims.zip(digests(papers)) {
            lines += &json_line(&ClaimLine {
                id: claim.entry.id.get_ref(),
                paper: &paper.head.id,
                kind: glossary::kind(claim.entry.kind).key,
                at: &claim.entry.at,
                uses: &claim.uses,
                cost: self.costs.expected(claim, &digest),
                digest: digest.digest,
            })?;
            self.count += 1;
        }
        terminal::print(&lines)
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
