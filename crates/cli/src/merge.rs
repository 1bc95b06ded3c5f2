//! `torse merge`: parts of a corpus, decided apart, become what one run would have written.

use crate::exit::{Exit, Failure};
use crate::listing::listed;
use crate::shard::{FINDING, LinesDigest, ShardEnd, ShardHead, ShardLine};
use crate::watchdog;
use clap::Args;
use std::fs::File;
use std::io::{self, BufRead, BufReader, BufWriter};
use std::path::{Path, PathBuf};
use torse::ClaimDigest;
use torse_report::{ReportError, VerdictsWriter};

/// Merge parts of a corpus that were decided apart.
///
/// Each file is the output of `torse verify --ids`; the list is that of `torse list --format json`. If every claim of the
/// list is in one file, with the digest that it has in the list, torse prints what `torse verify --format json` would have
/// printed for all of them, and ends with its exit code. Files of different programs, budgets or lists of what the kernel
/// accepted, a file that is not whole, a claim that is missing, out of date or there twice: nothing is printed, and the exit
/// code is 4.
#[derive(Args)]
#[command(after_help = EXAMPLES)]
pub struct Merge {
    /// Files that `torse verify --ids` has written
    #[arg(value_name = "FILE", required = true)]
    files: Vec<PathBuf>,
    /// All claims in their order, as `torse list --format json` has written them
    #[arg(long, value_name = "FILE")]
    list: PathBuf,
}

const EXAMPLES: &str = "\
Examples:
  torse list --format json > list.ndjson
  torse verify --ids first.txt > first.ndjson
  torse verify --ids second.txt > second.ndjson
  torse merge first.ndjson second.ndjson --list list.ndjson > verdicts.json";

impl Merge {
    /// Checks all files, then goes through them again and prints: nothing is printed of what is no whole.
    pub fn run(&self) -> Result<Exit, Failure> {
        let exit = self.walk(|_| Ok(()))?;
        watchdog::finished();
        let out = BufWriter::new(io::stdout().lock());
        let mut json = VerdictsWriter::new(out).map_err(printing)?;
        self.walk(|claim| Ok(json.add(claim).map_err(printing)?))?;
        json.finish().map_err(printing)?;
        Ok(exit)
    }

    /// Goes through the claims of all files in the order of the list; memory holds a line of each file. Returns the exit
    /// code that they have together.
    fn walk(&self, mut see: impl FnMut(&str) -> Result<(), Failure>) -> Result<Exit, Failure> {
        let opened = self.files.iter().map(|path| Shard::open(path));
        let mut shards = opened.collect::<Result<Vec<Shard>, Failure>>()?;
        if let Some((first, others)) = shards.split_first()
            && let Some(other) = others.iter().find(|other| other.head != first.head)
        {
            let ShardHead { torse, budget, .. } = &first.head;
            let of_kernel = match first.head.kernel == other.head.kernel {
                true => "",
                false => ", and another list of what the kernel accepted",
            };
            let first = first.path.display();
            return Err(other.wrong(format!(
                "{first} was written by torse {torse} with a budget of {budget}{of_kernel}, and this was not"
            )));
        }
        for claim in listed(&self.list)? {
            let ClaimDigest { id, digest } = claim?;
            let mut having = shards.iter_mut().filter(|shard| shard.is_at(&id, &digest));
            let Some(shard) = having.next() else {
                return Err(Failure::Unmerged { id });
            };
            if let Some(other) = having.next() {
                let first = shard.path.display();
                return Err(other.wrong(format!("it has the claim `{id}`, and {first} has it too")));
            }
            if let Some(finding) = shard.step()? {
                see(&finding)?;
            }
        }
        let mut gravest = Exit::AsExpected;
        for shard in shards {
            gravest = gravest.max(shard.end()?);
        }
        Ok(gravest)
    }
}

/// Treats a closed pipe as success.
fn printing(error: ReportError) -> ReportError {
    match error {
        ReportError::Stream(error) if error.kind() == io::ErrorKind::BrokenPipe => {
            std::process::exit(Exit::AsExpected.code().into())
        }
        other => other,
    }
}

/// A file of lines, at one of them.
struct Shard {
    path: PathBuf,
    head: ShardHead,
    lines: Lines,
    next: Next,
    passed: usize,
}

/// The lines of a file, and the digest of those that were read before the last one.
struct Lines {
    lines: io::Lines<BufReader<File>>,
    last: Option<String>,
    digest: LinesDigest,
}

impl Lines {
    fn next(&mut self) -> Result<Option<&str>, String> {
        if let Some(last) = self.last.take() {
            self.digest.add(&last);
        }
        self.last = self
            .lines
            .next()
            .transpose()
            .map_err(|error| error.to_string())?;
        Ok(self.last.as_deref())
    }
}

/// What comes next in a file.
enum Next {
    /// A claim and its finding; none where its formulas make no sense.
    Claim(ShardLine, Option<String>),
    /// The last line.
    End(ShardEnd),
}

impl Shard {
    fn open(path: &Path) -> Result<Self, Failure> {
        let wrong = |reason: String| Failure::Merge {
            path: path.to_owned(),
            reason,
        };
        let file = File::open(path).map_err(|error| wrong(error.to_string()))?;
        let mut lines = Lines {
            lines: BufReader::new(file).lines(),
            last: None,
            digest: LinesDigest::default(),
        };
        let head = lines.next().map_err(wrong)?;
        let head = head.ok_or_else(|| wrong("it is empty".to_owned()))?;
        let head = serde_json::from_str(head);
        let head =
            head.map_err(|error| wrong(format!("its first line is none of a part: {error}")))?;
        let next = Next::read(&mut lines).map_err(wrong)?;
        Ok(Self {
            path: path.to_owned(),
            head,
            lines,
            next,
            passed: 0,
        })
    }

    fn wrong(&self, reason: String) -> Failure {
        Failure::Merge {
            path: self.path.clone(),
            reason,
        }
    }

    /// Whether its next line is that of this claim as it is now.
    fn is_at(&self, id: &str, digest: &str) -> bool {
        matches!(&self.next, Next::Claim(line, _) if line.id == id && line.digest == digest)
    }

    /// Goes on to the next line, and returns the finding of the one that it was at.
    fn step(&mut self) -> Result<Option<String>, Failure> {
        let next = Next::read(&mut self.lines).map_err(|reason| self.wrong(reason))?;
        self.passed += 1;
        match std::mem::replace(&mut self.next, next) {
            Next::Claim(_, finding) => Ok(finding),
            Next::End(_) => Ok(None),
        }
    }

    /// Its exit code, if all of its claims were passed and nothing comes after them.
    fn end(mut self) -> Result<Exit, Failure> {
        let end = match &self.next {
            Next::End(end) => end,
            Next::Claim(line, _) => {
                let id = &line.id;
                let reason = format!(
                    "it has the claim `{id}`, which the list has not, or not there, or another file has too"
                );
                return Err(self.wrong(reason));
            }
        };
        if end.claims != self.passed {
            let (claims, passed) = (end.claims, self.passed);
            return Err(self.wrong(format!(
                "it has {passed} claims, and says that it has {claims}"
            )));
        }
        if end.sha256 != self.lines.digest.sealed(end.exit) {
            return Err(self.wrong("its lines have changed since they were written".to_owned()));
        }
        let exit = Exit::from_code(end.exit);
        let is_last = matches!(self.lines.next(), Ok(None));
        exit.filter(|_| is_last)
            .ok_or_else(|| self.wrong("its last line is none of a part".to_owned()))
    }
}

impl Next {
    fn read(lines: &mut Lines) -> Result<Self, String> {
        let line = lines.next()?;
        let line = line.ok_or("it has no last line: the run that wrote it has not ended")?;
        let Some((fields, rest)) = line.split_once(FINDING) else {
            let end = serde_json::from_str(line);
            return Ok(Self::End(end.map_err(|error| broken(line, &error))?));
        };
        let claim = serde_json::from_str(&format!("{fields}}}"));
        let claim: ShardLine = claim.map_err(|error| broken(line, &error))?;
        // What is cut off or changed in the middle is no JSON, or another claim.
        let finding = rest.strip_suffix('}').unwrap_or_default();
        let id: Option<FindingId> =
            serde_json::from_str(finding).map_err(|error| broken(line, &error))?;
        match id {
            None => Ok(Self::Claim(claim, None)),
            Some(FindingId { id }) if id == claim.id => {
                Ok(Self::Claim(claim, Some(finding.to_owned())))
            }
            Some(_) => Err(format!(
                "the line of `{}` has another claim in it",
                claim.id
            )),
        }
    }
}

/// The id in a finding.
#[derive(serde::Deserialize)]
struct FindingId {
    id: String,
}

fn broken(line: &str, error: &serde_json::Error) -> String {
    let begin: String = line.chars().take(60).collect();
    format!("a line is broken: {error}: {begin}")
}
