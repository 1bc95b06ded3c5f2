//! `torse verify --ids`: a part of a corpus, a line for each claim as soon as it is decided, for `torse merge`.
//!
//! A file of lines begins with its [`ShardHead`] and ends with its [`ShardEnd`], without which it is not whole. Between them
//! each claim has a [`ShardLine`], in the order of the derivation files, whatever the order of the ids.

use crate::derivations::Derivations;
use crate::exit::{Exit, Failure};
use crate::kernel::Kernel;
use crate::run::{Budget, Run};
use crate::version::VERSION;
use crate::{figures, input, terminal, watchdog};
use serde::{Deserialize, Serialize};
use sha2::{Digest as _, Sha256};
use std::collections::{BTreeMap, BTreeSet};
use std::path::Path;
use torse::{ClaimDigest, digests, selection};
use torse_report::{ReportError, finding_json_with_kernel};
use torse_syntax::derivation::Paper;
use torse_verdicts::outcome::Outcome;

/// How many claims are decided before their lines are written: enough for all threads, and few in memory.
const MAX_PENDING: usize = 256;

/// The first line: what all parts of a corpus have in common.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct ShardHead {
    /// The version and the commit of the program.
    pub torse: String,
    /// The largest work on a claim.
    pub budget: u64,
    /// The SHA-256 of what the kernel of the proof assistant has accepted, if there is such a list.
    pub kernel: Option<String>,
}

/// The line of a claim without its finding, which comes last: `"claim":` and the fields of a claim of
/// `verify --format json`, or null where its formulas make no sense.
#[derive(Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct ShardLine {
    /// The claim.
    pub id: String,
    /// The digest of what it rests on.
    pub digest: String,
}

/// The last line.
#[derive(Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct ShardEnd {
    /// The number of claims.
    pub claims: usize,
    /// The exit code of the run.
    pub exit: u8,
    /// The SHA-256 of all lines before this one and of the exit code, as hexadecimal digits.
    pub sha256: String,
}

/// What stands between the fields of a [`ShardLine`] and the finding.
pub const FINDING: &str = ",\"claim\":";

/// Decides exactly the claims of these ids, one a line of a file or of standard input (`-`), and prints them.
pub fn run(
    ids: &Path,
    budget: Budget,
    kernel: &Kernel,
    derivations: &Derivations,
) -> Result<Exit, Failure> {
    let found = derivations.load()?;
    let (papers, mut mistakes) = (found.papers, found.mistakes);
    let wanted = read(ids)?;
    let digests = digests(&papers);
    let known: BTreeSet<&str> = digests.iter().map(|claim| claim.id.as_str()).collect();
    // What is left out because it is wrong is told with its mistake.
    let left_out = |id: &String| found.left_out.contains(id);
    let unknown = wanted
        .iter()
        .find(|id| !known.contains(id.as_str()) && !left_out(id));
    if let Some(id) = unknown {
        return Err(Failure::UnknownId { id: id.clone() });
    }
    let mut written = Written::default();
    written.line(&json(&ShardHead {
        torse: VERSION.to_owned(),
        budget: budget.units(),
        kernel: kernel.digest(),
    })?)?;
    let mut exit = Exit::AsExpected;
    let claims: Vec<&ClaimDigest> = digests
        .iter()
        .filter(|claim| wanted.contains(&claim.id))
        .collect();
    for pending in claims.chunks(MAX_PENDING) {
        let ids: Vec<&str> = pending.iter().map(|claim| claim.id.as_str()).collect();
        let chunk: Vec<Paper> = selection::only(&papers, &ids);
        let run = Run::new(&chunk, budget, &mut mistakes);
        figures::evaluated(&chunk, &mut mistakes);
        exit = exit.max(Exit::from_outcomes(run.outcomes(), &[]));
        let accepted = kernel.accepted(&chunk, &run);
        let outcomes: BTreeMap<&str, &Outcome> = run
            .outcomes()
            .map(|outcome| (outcome.claim.id.as_str(), outcome))
            .collect();
        for ClaimDigest { id, digest, .. } in pending {
            let (id, digest) = (id.clone(), digest.clone());
            let finding = match outcomes.get(id.as_str()) {
                Some(outcome) => finding_json_with_kernel(outcome, &accepted)?,
                // Its formulas make no sense, which is told with the mistakes.
                None => "null".to_owned(),
            };
            let line = json(&ShardLine { id, digest })?;
            let fields = line.strip_suffix('}').unwrap_or(&line);
            written.line(&format!("{fields}{FINDING}{}}}", finding.trim_end()))?;
        }
    }
    figures::evaluated(&own_figures(papers, &wanted), &mut mistakes);
    watchdog::finished();
    let exit = mistakes.tell(exit);
    let end = ShardEnd {
        claims: claims.len(),
        exit: exit.code(),
        sha256: written.lines.sealed(exit.code()),
    };
    written.line(&json(&end)?)?;
    Ok(exit)
}

/// The papers whose first claim is wanted, with the figures alone that no claim has: of all parts of a corpus, one evaluates
/// them.
fn own_figures(papers: Vec<Paper>, wanted: &BTreeSet<String>) -> Vec<Paper> {
    let first = |paper: &Paper| {
        let first = paper.claims.first();
        first.is_some_and(|claim| wanted.contains(claim.entry.id.get_ref()))
    };
    let papers = papers.into_iter().filter(first);
    papers
        .map(|paper| Paper {
            claims: vec![],
            ..paper
        })
        .collect()
}

/// The ids of a file, or of standard input; blank lines do not count.
fn read(path: &Path) -> Result<BTreeSet<String>, Failure> {
    let text = input::text(path)?;
    let lines = text.lines().map(str::trim).filter(|line| !line.is_empty());
    Ok(lines.map(str::to_owned).collect())
}

/// What was printed so far.
#[derive(Default)]
struct Written {
    lines: LinesDigest,
}

impl Written {
    fn line(&mut self, line: &str) -> Result<(), Failure> {
        self.lines.add(line);
        terminal::print(&format!("{line}\n"))
    }
}

/// A digest of lines.
#[derive(Debug, Clone, Default)]
pub struct LinesDigest(Sha256);

impl LinesDigest {
    /// Adds a line, given without its end.
    pub fn add(&mut self, line: &str) {
        self.0.update(line.as_bytes());
        self.0.update(b"\n");
    }

    /// The digest of the lines so far and of the exit code of their run, as hexadecimal digits.
    pub fn sealed(&self, exit: u8) -> String {
        let digits = |byte: &u8| format!("{byte:02x}");
        let digest = self.0.clone().chain_update([exit]);
        digest.finalize().iter().map(digits).collect()
    }
}

fn json(line: &impl Serialize) -> Result<String, ReportError> {
    Ok(serde_json::to_string(line)?)
}
