//! `torse verify --ids`: a part of a corpus, a line for each claim as soon as it is decided, for `torse merge`.
//!
//! A file of lines begins with its [`ShardHead`] and ends with its [`ShardEnd`], without which it is not whole. Between them
//! each claim has a [`ShardLine`], in the order of the derivation files, whatever the order of the ids.

use crate::derivations::{Derivations, tell_mistakes};
use crate::diagnostics::Diagnostics;
use crate::exit::{Exit, Failure};
use crate::kernel::Kernel;
use crate::run::{Budget, Run};
use crate::version::{VERSION, program};
use crate::{figures, input, terminal, watchdog};
use serde::{Deserialize, Serialize};
use sha2::{Digest as _, Sha256};
use std::collections::{BTreeMap, BTreeSet};
use std::path::Path;
use torse::{ClaimDigest, digests, selection};
use torse_report::{ReportError, finding_json_with_kernel};
use torse_syntax::derivation::{Loaded, Paper};
use torse_verdicts::outcome::Outcome;

/// How many claims are decided before their lines are written: enough for all threads, and few in memory.
const MAX_PENDING: usize = 256;

/// The first line: what all parts of a corpus have in common.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct ShardHead {
    /// The version and the commit of the program.
    pub torse: String,
    /// The SHA-256 of the program, where its commit does not say what it was built from.
    pub program: Option<String>,
    /// The largest work on a claim.
    pub budget: u64,
    /// The SHA-256 of what the kernel of the proof assistant has accepted, if there is such a list.
    pub kernel: Option<String>,
}

impl ShardHead {
    /// The head of what is decided now.
    ///
    /// # Errors
    /// [`Failure::Program`] where the program cannot be read.
    pub fn new(budget: Budget, kernel: &Kernel) -> Result<Self, Failure> {
        Ok(Self {
            torse: VERSION.to_owned(),
            program: program().map_err(Failure::Program)?,
            budget: budget.units(),
            kernel: kernel.digest(),
        })
    }

    /// Prints it: parts with other heads have other verdicts.
    ///
    /// # Errors
    /// As [`ShardHead::new`], and where it cannot be printed.
    pub fn tell(&self) -> Result<Exit, Failure> {
        watchdog::finished();
        terminal::print(&format!("{}\n", json(self)?))?;
        Ok(Exit::AsExpected)
    }
}

/// The line of a claim without its finding, which comes last: `"claim":` and the fields of a claim of
/// `verify --format json`, or null where its formulas make no sense.
#[derive(Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct ShardLine {
    /// The claim.
    pub id: String,
    /// The digest of what it rests on.
    pub digest: String,
    /// The work on it, in the units of the budget.
    #[serde(default)]
    pub work: u64,
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

/// Decides exactly the claims of these ids, one a line of a file or of standard input (`-`), and prints them. Of the folder
/// no more is read than their papers, one after the other, and what these refer to: mistakes of others are those of the list.
pub fn run(
    ids: &Path,
    budget: Budget,
    kernel: &Kernel,
    derivations: &Derivations,
) -> Result<Exit, Failure> {
    let wanted = by_paper(read(ids)?)?;
    let mut papers = derivations.one_by_one()?;
    let unknown = wanted.iter().find(|(slug, _)| !papers.has(slug));
    if let Some(id) = unknown.and_then(|(_, ids)| ids.first()) {
        return Err(Failure::UnknownId { id: id.clone() });
    }
    let mut part = Part {
        budget,
        kernel,
        pending: vec![],
        claims: vec![],
        written: Written::default(),
        mistakes: Diagnostics::default(),
        exit: Exit::AsExpected,
        count: 0,
    };
    for (slug, ids) in wanted {
        part.paper(papers.load(&slug), &ids)?;
    }
    part.end()
}

/// What is decided of a corpus.
struct Part<'k> {
    budget: Budget,
    kernel: &'k Kernel,
    /// What is to be decided next, in the order of the files.
    pending: Vec<Paper>,
    claims: Vec<ClaimDigest>,
    written: Written,
    mistakes: Diagnostics,
    exit: Exit,
    count: usize,
}

impl Part<'_> {
    /// Takes the claims of these ids of a paper, and decides what is pending if it is enough.
    fn paper(&mut self, loaded: Loaded, ids: &BTreeSet<String>) -> Result<(), Failure> {
        let (papers, left_out) = tell_mistakes(loaded, &mut self.mistakes);
        let claims = digests(&papers);
        // What is left out because it is wrong is told with its mistake.
        let is_known =
            |id: &&String| left_out.contains(id) || claims.iter().any(|claim| claim.id == **id);
        if let Some(id) = ids.iter().find(|id| !is_known(id)) {
            return Err(Failure::UnknownId { id: id.clone() });
        }
        let claims: Vec<ClaimDigest> = claims
            .into_iter()
            .filter(|claim| ids.contains(&claim.id))
            .collect();
        for claims in claims.chunks(MAX_PENDING) {
            let ids: Vec<&str> = claims.iter().map(|claim| claim.id.as_str()).collect();
            self.pending.extend(selection::only(&papers, &ids));
            self.claims.extend_from_slice(claims);
            if self.claims.len() >= MAX_PENDING {
                self.decide()?;
            }
        }
        figures::evaluated(&own_figures(papers, ids), &mut self.mistakes);
        Ok(())
    }

    /// Decides what is pending, and writes it.
    fn decide(&mut self) -> Result<(), Failure> {
        self.head()?;
        let papers = std::mem::take(&mut self.pending);
        let run = Run::new(&papers, self.budget, &mut self.mistakes);
        figures::evaluated(&papers, &mut self.mistakes);
        self.exit = self.exit.max(Exit::from_outcomes(run.outcomes(), &[]));
        let accepted = self.kernel.accepted(&papers, &run);
        let outcomes: BTreeMap<&str, &Outcome> = run
            .outcomes()
            .map(|outcome| (outcome.claim.id.as_str(), outcome))
            .collect();
        for ClaimDigest { id, digest, .. } in std::mem::take(&mut self.claims) {
            let finding = match outcomes.get(id.as_str()) {
                Some(outcome) => finding_json_with_kernel(outcome, &accepted)?,
                // Its formulas make no sense, which is told with the mistakes.
                None => "null".to_owned(),
            };
            let work = run.work(&id);
            let line = json(&ShardLine { id, digest, work })?;
            let fields = line.strip_suffix('}').unwrap_or(&line);
            let line = format!("{fields}{FINDING}{}}}", finding.trim_end());
            self.written.line(&line)?;
            self.count += 1;
        }
        Ok(())
    }

    /// Writes the head, if it is not there yet.
    fn head(&mut self) -> Result<(), Failure> {
        if !self.written.is_begun {
            let head = ShardHead::new(self.budget, self.kernel)?;
            self.written.line(&json(&head)?)?;
        }
        Ok(())
    }

    /// Decides what is left, and writes the last line.
    fn end(mut self) -> Result<Exit, Failure> {
        self.decide()?;
        watchdog::finished();
        let exit = self.mistakes.tell(self.exit);
        let end = ShardEnd {
            claims: self.count,
            exit: exit.code(),
            sha256: self.written.lines.sealed(exit.code()),
        };
        self.written.line(&json(&end)?)?;
        Ok(exit)
    }
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

/// The ids by the folders of their papers, in the order of these.
fn by_paper(ids: BTreeSet<String>) -> Result<BTreeMap<String, BTreeSet<String>>, Failure> {
    let mut papers: BTreeMap<String, BTreeSet<String>> = BTreeMap::new();
    for id in ids {
        let Some((slug, _)) = id.split_once('/') else {
            return Err(Failure::UnknownId { id });
        };
        papers.entry(slug.to_owned()).or_default().insert(id);
    }
    Ok(papers)
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
    is_begun: bool,
}

impl Written {
    fn line(&mut self, line: &str) -> Result<(), Failure> {
        self.is_begun = true;
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
