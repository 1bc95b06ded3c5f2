//! `torse merge`: parts of a corpus, decided apart, become what one run would have written.

use crate::exit::{Exit, Failure};
use crate::input::Lasting;
use crate::listing::{ListEnd, Listed, listed};
use crate::shard::{FINDING, LinesDigest, ShardEnd, ShardHead, ShardLine};
use crate::watchdog;
use clap::Args;
use std::collections::HashMap;
use std::fs::File;
use std::io::{self, BufRead, BufReader, BufWriter, Seek, SeekFrom};
use std::path::PathBuf;
use torse::ClaimDigest;
use torse_report::{ReportError, VerdictsWriter};

/// Merge parts of a corpus that were decided apart.
///
/// Each file is the output of `torse verify --ids`; the list is that of `torse list --format json`, which knows the mistakes of
/// papers that no file has. If every claim of the
/// list is in one file, with the digest that it has in the list, torse prints what `torse verify --format json` would have
/// printed for all of them, and ends with its exit code. Files of different programs, budgets or lists of what the kernel
/// accepted, a file that is not whole, a claim that is missing, out of date or there twice: nothing is printed, and the exit
/// code is 4.
#[derive(Args)]
#[command(after_help = EXAMPLES)]
pub struct Merge {
    /// Files that `torse verify --ids` has written; - for standard input
    #[arg(value_name = "FILE", required = true)]
    files: Vec<PathBuf>,
    /// All claims in their order, as `torse list --format json` has written them; - for standard input
    #[arg(long, value_name = "FILE")]
    list: PathBuf,
}

const EXAMPLES: &str = "\
Examples:
  torse list --format json > list.ndjson
  torse verify --ids first.txt > first.ndjson
  torse verify --ids second.txt > second.ndjson
  torse merge first.ndjson second.ndjson --list list.ndjson > verdicts.json";

/// How many files are open at a time: fewer than any system allows.
const MAX_OPEN: usize = 64;

impl Merge {
    /// Checks all files, then goes through them again and prints: nothing is printed of what is no whole.
    pub fn run(&self) -> Result<Exit, Failure> {
        let files = self.files.iter().map(|path| Lasting::new(path));
        let files = files.collect::<Result<Vec<Lasting>, Failure>>()?;
        let list = Lasting::new(&self.list)?;
        let exit = walk(&files, &list, |_| Ok(()))?;
        watchdog::finished();
        let out = BufWriter::new(io::stdout().lock());
        let mut json = VerdictsWriter::new(out).map_err(printing)?;
        walk(&files, &list, |claim| {
            Ok(json.add(claim).map_err(printing)?)
        })?;
        json.finish().map_err(printing)?;
        Ok(exit)
    }
}

/// Goes through the claims of all files in the order of the list; memory holds a line of each file. Returns the exit code
/// that they have together.
fn walk(
    files: &[Lasting],
    list: &Lasting,
    mut see: impl FnMut(&str) -> Result<(), Failure>,
) -> Result<Exit, Failure> {
    let mut readers = Readers::default();
    let mut shards: Vec<Shard> = vec![];
    for file in files {
        shards.push(Shard::begin(file, shards.len(), &mut readers)?);
    }
    if let Some((first, others)) = shards.split_first()
        && let Some(other) = others.iter().find(|other| other.head != first.head)
    {
        let ShardHead { torse, budget, .. } = &first.head;
        let differs = |same: bool, what| if same { "" } else { what };
        let of_kernel = differs(
            first.head.kernel == other.head.kernel,
            ", and another list of what the kernel accepted",
        );
        let of_program = differs(
            first.head.program == other.head.program,
            " (of another build)",
        );
        let first = first.file.named().display();
        return Err(other.wrong(format!(
            "{first} was written by torse {torse}{of_program} with a budget of {budget}{of_kernel}, and this was not"
        )));
    }
    // The file that has a claim as its next one.
    let mut next: HashMap<String, usize> = HashMap::new();
    for index in 0..shards.len() {
        enter(&shards, index, &mut next)?;
    }
    let mut end: Option<ListEnd> = None;
    let mut count = 0;
    for line in listed(list)? {
        let line = line?;
        if end.is_some() {
            return Err(wrong_list(list, "lines come after its last one"));
        }
        let ClaimDigest { id, digest, .. } = match line {
            Listed::Claim(claim) => claim,
            Listed::End(last) => {
                end = Some(last);
                continue;
            }
        };
        count += 1;
        let found = next.remove(&id);
        let found = found.and_then(|index| Some((index, shards.get_mut(index)?)));
        let Some((index, shard)) = found.filter(|(_, shard)| shard.is_at(&id, &digest)) else {
            return Err(Failure::Unmerged { id });
        };
        let line = shard.step(&mut readers)?;
        match finding(&line) {
            None | Some("null") => {}
            Some(finding) => see(finding)?,
        }
        enter(&shards, index, &mut next)?;
    }
    let end = end.filter(|end| end.claims == count);
    let exit = end.and_then(|end| Exit::from_code(end.exit));
    let mut gravest = exit.ok_or_else(|| wrong_list(list, CUT_OFF))?;
    for shard in shards {
        gravest = gravest.max(shard.end(&mut readers)?);
    }
    Ok(gravest)
}

/// Notes which claim comes next in a file; no other file may be at it.
fn enter(shards: &[Shard], index: usize, next: &mut HashMap<String, usize>) -> Result<(), Failure> {
    let Some((shard, Next::Claim(line))) = shards.get(index).map(|shard| (shard, &shard.next))
    else {
        return Ok(());
    };
    let id = &line.id;
    match next
        .insert(id.clone(), index)
        .and_then(|other| shards.get(other))
    {
        None => Ok(()),
        Some(other) => {
            let (first, second) = if other.index < index {
                (other, shard)
            } else {
                (shard, other)
            };
            let first = first.file.named().display();
            Err(second.wrong(format!("it has the claim `{id}`, and {first} has it too")))
        }
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

/// The files that are open, the one that was read last at the end.
#[derive(Default)]
struct Readers {
    open: Vec<(usize, BufReader<File>)>,
}

impl Readers {
    /// Reads the line of a file at a byte, with its end; none at the end of the file.
    fn line(&mut self, shard: usize, file: &Lasting, at: u64) -> io::Result<Option<String>> {
        let mut reader = match self.open.iter().position(|(open, _)| *open == shard) {
            Some(place) => self.open.remove(place).1,
            None => {
                let mut file = File::open(file.path())?;
                file.seek(SeekFrom::Start(at))?;
                BufReader::new(file)
            }
        };
        let mut line = String::new();
        let read = reader.read_line(&mut line)?;
        if self.open.len() >= MAX_OPEN {
            self.open.remove(0);
        }
        self.open.push((shard, reader));
        Ok((read > 0).then_some(line))
    }
}

/// A file of lines, at one of them.
struct Shard<'f> {
    file: &'f Lasting,
    index: usize,
    head: ShardHead,
    /// The byte at which the line after the one that it is at begins.
    offset: u64,
    /// The lines before the one that it is at.
    digest: LinesDigest,
    line: String,
    next: Next,
    passed: usize,
}

/// What stands in a line.
enum Next {
    /// A claim.
    Claim(ShardLine),
    /// The last line.
    End(ShardEnd),
}

impl<'f> Shard<'f> {
    fn begin(file: &'f Lasting, index: usize, readers: &mut Readers) -> Result<Self, Failure> {
        let wrong = |reason: String| wrong(file, reason);
        let read = readers.line(index, file, 0);
        let line = read.map_err(|source| unread(file, source))?;
        let line = line.ok_or_else(|| wrong("it is empty".to_owned()))?;
        let head = serde_json::from_str(&line);
        let head =
            head.map_err(|error| wrong(format!("its first line is none of a part: {error}")))?;
        let offset = line.len() as u64;
        let mut shard = Self {
            file,
            index,
            head,
            offset,
            digest: LinesDigest::default(),
            line,
            next: Next::End(ShardEnd::default()),
            passed: 0,
        };
        shard.advance(readers)?;
        Ok(shard)
    }

    fn wrong(&self, reason: String) -> Failure {
        wrong(self.file, reason)
    }

    fn read(&mut self, readers: &mut Readers) -> Result<Option<String>, Failure> {
        let read = readers.line(self.index, self.file, self.offset);
        let line = read.map_err(|source| unread(self.file, source))?;
        self.offset += line.as_ref().map_or(0, |line| line.len() as u64);
        Ok(line)
    }

    /// Goes on to the next line, and returns the one that it was at.
    fn advance(&mut self, readers: &mut Readers) -> Result<String, Failure> {
        let line = self.read(readers)?;
        let line = line.ok_or_else(|| {
            self.wrong("it has no last line: the run that wrote it has not ended".to_owned())
        })?;
        let next = Next::read(ended(&line)).map_err(|reason| self.wrong(reason))?;
        self.digest.add(ended(&self.line));
        self.next = next;
        Ok(std::mem::replace(&mut self.line, line))
    }

    /// Whether its next line is that of this claim as it is now.
    fn is_at(&self, id: &str, digest: &str) -> bool {
        matches!(&self.next, Next::Claim(line) if line.id == id && line.digest == digest)
    }

    /// Passes a claim, and returns its line.
    fn step(&mut self, readers: &mut Readers) -> Result<String, Failure> {
        self.passed += 1;
        self.advance(readers)
    }

    /// Its exit code, if all of its claims were passed and nothing comes after them.
    fn end(mut self, readers: &mut Readers) -> Result<Exit, Failure> {
        let end = match &self.next {
            Next::End(end) => end,
            Next::Claim(line) => {
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
        if end.sha256 != self.digest.sealed(end.exit) {
            return Err(self.wrong("its lines have changed since they were written".to_owned()));
        }
        let exit = Exit::from_code(end.exit);
        let is_last = matches!(self.read(readers), Ok(None));
        exit.filter(|_| is_last)
            .ok_or_else(|| self.wrong("its last line is none of a part".to_owned()))
    }
}

/// A line without its end.
fn ended(line: &str) -> &str {
    let line = line.strip_suffix('\n').unwrap_or(line);
    line.strip_suffix('\r').unwrap_or(line)
}

/// The finding in the line of a claim.
fn finding(line: &str) -> Option<&str> {
    let (_, rest) = ended(line).split_once(FINDING)?;
    rest.strip_suffix('}')
}

fn wrong(file: &Lasting, reason: String) -> Failure {
    Failure::Merge {
        path: file.named().to_owned(),
        reason,
    }
}

/// What is wrong with a list that does not end as one does.
const CUT_OFF: &str = "its last line is not that of a list: `torse list --format json` has not ended, or another torse has written it, or lines are missing";

fn wrong_list(list: &Lasting, reason: &str) -> Failure {
    Failure::List {
        path: list.named().to_owned(),
        reason: reason.to_owned(),
    }
}

fn unread(file: &Lasting, source: io::Error) -> Failure {
    Failure::Input {
        path: file.named().to_owned(),
        source,
    }
}

impl Next {
    fn read(line: &str) -> Result<Self, String> {
        let Some((fields, _)) = line.split_once(FINDING) else {
            let end = serde_json::from_str(line);
            return Ok(Self::End(end.map_err(|error| broken(line, &error))?));
        };
        let claim = serde_json::from_str(&format!("{fields}}}"));
        let claim: ShardLine = claim.map_err(|error| broken(line, &error))?;
        // What is cut off or changed in the middle is no JSON, or another claim.
        let id: Option<FindingId> = serde_json::from_str(finding(line).unwrap_or_default())
            .map_err(|error| broken(line, &error))?;
        match id {
            Some(FindingId { id }) if id != claim.id => Err(format!(
                "the line of `{}` has another claim in it",
                claim.id
            )),
            _ => Ok(Self::Claim(claim)),
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
