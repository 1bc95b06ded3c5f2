//! Runs `coqc`, with limits of time and memory, on a scratch copy of a folder of proofs.

use crate::check::{self, CHECK, PROOFS};
use crate::closed::CLOSED;
use crate::digest::Digest;
use crate::folder::{ACCEPTED, Folder};
use crate::library::{self, LIBRARY};
use crate::printed::{self, FOLLOWS, FUNCTIONS, JETS};
use crate::theorem::Theorem;
use crate::{modules, scheduler};
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;
use std::io::{self, Read};
use std::path::Path;
use std::process::{Child, Command, ExitStatus, Stdio};
use std::time::{Duration, Instant};
use thiserror::Error;

/// The axioms that theorems may rest on: those of the real numbers and of classical logic in the standard library.
pub const AXIOMS: [&str; 4] = [
    "ClassicalDedekindReals.sig_not_dec",
    "ClassicalDedekindReals.sig_forall_dec",
    "FunctionalExtensionality.functional_extensionality_dep",
    "Classical_Prop.classic",
];

/// How to get the program.
pub const INSTALL: &str = "apt-get install coq libcoq-coquelicot";

/// Maximum time for the separate checker.
const MAX_RECHECK: Duration = Duration::from_secs(3600);

/// Why nothing could be checked.
#[derive(Debug, Error)]
pub enum CheckError {
    /// The program is not installed.
    #[error("`coqc` was not found")]
    Missing,
    /// The program is installed, but Coquelicot is not, or the library does not compile.
    #[error("the library is not accepted: {0}")]
    Library(String),
    /// The scratch folder, or the program, failed.
    #[error("{what}: {source}")]
    System {
        /// The failed action.
        what: String,
        /// The message of the system.
        source: io::Error,
    },
}

/// Limits of one run of the program.
#[derive(Debug, Clone, Copy)]
pub struct Limits {
    /// Maximum time for a file.
    pub time: Duration,
    /// Maximum memory, in kilobytes.
    pub memory: u64,
    /// How many runs go on at once.
    pub at_once: usize,
}

/// The result for a theorem.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Answer {
    /// The kernel accepted it.
    Accepted,
    /// The kernel did not accept it, for this reason.
    Rejected(String),
    /// A theorem before it in the same file was rejected.
    NotReached,
}

/// The theorems that the kernel accepted, as stored.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
pub struct Accepted {
    /// The version of the program.
    pub coq: String,
    /// The axioms that all of them together rest on.
    pub axioms: Vec<String>,
    /// The answer of the separate checker of compiled files for the same theorems, if it was asked.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub coqchk: Option<Recheck>,
    /// Names of theorems, with the digest of everything that the answer depends on.
    pub theorems: BTreeMap<String, String>,
}

/// The answer of the separate checker, which reads compiled files anew and does not trust tactics or the compiler.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
pub struct Recheck {
    /// Whether it accepted all files and everything that they rest on.
    pub accepted: bool,
    /// The axioms that it lists: those of all loaded files, used or not.
    pub axioms: Vec<String>,
    /// How many theorems were accepted when it was asked.
    pub theorems: usize,
}

impl Accepted {
    /// Reads what a folder stores; empty if nothing can be read.
    #[must_use]
    pub fn read(folder: &Path) -> Option<Self> {
        let text = std::fs::read_to_string(folder.join(ACCEPTED)).ok()?;
        serde_json::from_str(&text).ok()
    }

    /// Returns the digests of its theorems.
    #[must_use]
    pub fn fingerprints(&self) -> Fingerprints {
        Fingerprints::of_version(&self.coq)
    }

    /// Whether a theorem of this section was accepted.
    #[must_use]
    pub fn has_section(&self, section: &str) -> bool {
        let mut names = self.theorems.keys();
        names.any(|name| {
            name.strip_prefix(section)
                .is_some_and(|rest| rest.starts_with('.'))
        })
    }

    /// Whether a theorem was accepted with this digest.
    #[must_use]
    pub fn has(&self, theorem: &Theorem, fingerprint: &str) -> bool {
        let accepted = self.theorems.get(&theorem.name());
        accepted.is_some_and(|accepted| accepted == fingerprint)
    }
}

/// Computes digests of theorems from the version of the program, the library, the statement and the proof. The common
/// part is digested once.
#[derive(Debug, Clone)]
pub struct Fingerprints(Digest);

impl Fingerprints {
    /// Starts digests for a version of the program.
    #[must_use]
    pub fn of_version(version: &str) -> Self {
        let texts = LIBRARY.iter().map(|(_, text)| *text);
        Self(texts.fold(Digest::default().and(version), Digest::and))
    }

    /// Returns the digest of one theorem.
    #[must_use]
    pub fn fingerprint(&self, theorem: &Theorem) -> String {
        let shared = self.0.clone();
        let own = shared.and(&theorem.says).and(&theorem.proof);
        // A statement that follows from another one was accepted together with it, by its own tactic.
        let whole = match &theorem.rests_on {
            Some(core) if printed::uses_jets(&theorem.proof) => {
                let own = own.and(core).and(FOLLOWS.1);
                own.and(JETS.1).and(FUNCTIONS.1)
            }
            Some(core) => own.and(core).and(FOLLOWS.1),
            None => own,
        };
        whole.hexadecimal()
    }
}

/// The program, with its version.
#[derive(Debug, Clone)]
pub struct Coqc {
    /// The version, such as `8.16.1`.
    pub version: String,
}

impl Coqc {
    /// Looks for the program on the path.
    ///
    /// # Errors
    /// [`CheckError::Missing`] if it is not there, [`CheckError::System`] if it cannot be run.
    pub fn find() -> Result<Self, CheckError> {
        let output = Command::new("coqc")
            .arg("--print-version")
            .stdin(Stdio::null())
            .output();
        match output {
            Ok(output) if output.status.success() => {
                let text = String::from_utf8_lossy(&output.stdout);
                let version = text
                    .split_whitespace()
                    .next()
                    .unwrap_or("unknown")
                    .to_owned();
                Ok(Self { version })
            }
            Ok(_) => Err(CheckError::Missing),
            Err(error) if error.kind() == io::ErrorKind::NotFound => Err(CheckError::Missing),
            Err(source) => Err(CheckError::System {
                what: "coqc cannot be run".to_owned(),
                source,
            }),
        }
    }

    /// Checks all theorems of a folder in `scratch`, which contains the compiled [library](Self::library) and nothing
    /// else. Calls `done` once for each section, and at the end.
    ///
    /// # Errors
    /// [`CheckError`] if nothing could be checked.
    pub fn check(
        &self,
        folder: &Folder,
        scratch: &Path,
        limits: Limits,
        done: &(dyn Fn() + Sync),
    ) -> Result<(BTreeMap<String, Answer>, Vec<String>), CheckError> {
        lay_out(folder, scratch)?;
        let of_section = |section: &str| self.section(folder, section, scratch, limits);
        let found = each_section(folder, limits.at_once, done, &of_section)?;
        let mut answers: BTreeMap<String, Answer> = found.into_iter().flatten().collect();
        let lists = self.without_the_rejected(folder, &answers, scratch, limits)?;
        let mut axioms = vec![];
        if answers.values().any(|answer| *answer == Answer::Accepted) {
            for list in lists {
                let run = self.run(scratch, &list, limits)?;
                if run.status.success() {
                    axioms = assumptions(&run.text);
                    continue;
                }
                let reason = first_lines(&run.text);
                let accepted = answers.values_mut().filter(|a| **a == Answer::Accepted);
                for answer in accepted {
                    *answer = Answer::Rejected(format!("{list}: {reason}"));
                }
                break;
            }
        }
        done();
        Ok((answers, axioms))
    }

    /// Leaves the accepted theorems in the scratch folder, and recompiles the files that lose others: the axioms are
    /// requested for the accepted theorems alone. Returns the files that request them.
    fn without_the_rejected(
        &self,
        folder: &Folder,
        answers: &BTreeMap<String, Answer>,
        scratch: &Path,
        limits: Limits,
    ) -> Result<Vec<String>, CheckError> {
        let mut left = BTreeMap::new();
        for (path, text) in &folder.files {
            let Some(section) = path.strip_suffix(PROOFS) else {
                continue;
            };
            let parts = modules::split(text);
            let accepted = |module: &str| {
                answers.get(&format!("{section}.{module}")) == Some(&Answer::Accepted)
            };
            let kept: Vec<&str> = parts
                .modules
                .iter()
                .filter(|(module, _)| accepted(module))
                .map(|(_, body)| *body)
                .collect();
            if kept.is_empty() {
                continue;
            }
            let changed = kept.len() < parts.modules.len();
            let kept = modules::join(parts.head, kept);
            if changed {
                write(&scratch.join(path), &kept)?;
                self.run(scratch, path, limits)?;
            }
            left.insert(path.clone(), kept);
        }
        let mut lists = vec![];
        for (path, text) in check::referees(&left) {
            write(&scratch.join(&path), &text)?;
            lists.push(path);
        }
        Ok(lists)
    }

    /// Writes the library into `scratch`, an empty folder, and compiles it once for all later checks. Calls `done` once
    /// for each file.
    ///
    /// # Errors
    /// [`CheckError`]; [`CheckError::Library`] if the library is not accepted.
    pub fn library(
        &self,
        scratch: &Path,
        limits: Limits,
        done: &(dyn Fn() + Sync),
    ) -> Result<(), CheckError> {
        for (path, text) in LIBRARY.into_iter().chain([FOLLOWS, FUNCTIONS, JETS]) {
            write(&scratch.join(path), text)?;
        }
        let compile = |path: &str| {
            let run = self.run(scratch, path, limits)?;
            done();
            match run.status.success() {
                true => Ok(()),
                false => Err(CheckError::Library(first_lines(&run.text))),
            }
        };
        let files = LIBRARY.map(|(path, _)| path).into_iter();
        let jobs: Vec<_> = files.zip(library::needs()).collect();
        scheduler::worked(&jobs, limits.at_once, &|path| compile(path))?;
        compile(FOLLOWS.0)?;
        compile(FUNCTIONS.0)?;
        compile(JETS.0)
    }

    /// Has the separate checker read all files compiled in `scratch` by a [check](Self::check), and everything that
    /// they rest on. `coqchk` must recompute by the same means as the kernel: otherwise conversions by `vm_compute`
    /// take days. Returns `None` if it does not end within its maximum time.
    ///
    /// # Errors
    /// [`CheckError`] if it cannot be run at all.
    pub fn recheck(
        &self,
        scratch: &Path,
        limits: Limits,
        theorems: usize,
    ) -> Result<Option<Recheck>, CheckError> {
        let mut command = limited("coqchk", limits.memory);
        command.args(["-silent", "-o", "-bytecode-compiler", "yes"]);
        for prefix in prefixes(scratch)? {
            command.arg("-Q").arg(&prefix).arg(&prefix);
        }
        // A file that names every theorem rests on all files.
        let checked = CHECK.trim_end_matches(".v");
        command.args(["-Q", ".", ""]).arg(checked);
        command.current_dir(scratch).stdin(Stdio::null());
        let run = run(&mut command, MAX_RECHECK)?;
        let answer = Recheck {
            accepted: run.status.success(),
            axioms: listed_axioms(&run.text),
            theorems,
        };
        Ok((!run.killed).then_some(answer))
    }

    /// Returns the answers for one section: its statements, then its proofs.
    fn section(
        &self,
        folder: &Folder,
        section: &str,
        scratch: &Path,
        limits: Limits,
    ) -> Result<Vec<(String, Answer)>, CheckError> {
        let theorems = folder.theorems_of(section);
        if let Some(core) = printed::proved(section) {
            self.proved(core, scratch, limits)?;
        }
        let statements = self.run(scratch, &format!("{section}.v"), limits)?;
        if !statements.status.success() {
            let reason = Answer::Rejected(first_lines(&statements.text));
            return Ok(theorems
                .iter()
                .map(|t| (t.name(), reason.clone()))
                .collect());
        }
        if let Err(reason) = self.closed_forms(folder, section, scratch, limits)? {
            let rejected = |t: &&Theorem| (t.name(), Answer::Rejected(reason.clone()));
            return Ok(theorems.iter().map(rejected).collect());
        }
        let path = format!("{section}{PROOFS}");
        let mut text = folder.files.get(&path).cloned().unwrap_or_default();
        let mut rejected: BTreeMap<String, String> = BTreeMap::new();
        loop {
            let proofs = self.run(scratch, &path, limits)?;
            if proofs.status.success() {
                break;
            }
            // The line of the error identifies the theorem; the others are checked again without it.
            let reason = first_lines(&proofs.text);
            let module = error_line(&proofs.text).and_then(|line| module_at(&text, line));
            let Some(module) = module.filter(|module| !rejected.contains_key(module)) else {
                let all = |t: &&Theorem| (t.name(), Answer::NotReached);
                let mut answers: Vec<(String, Answer)> = theorems.iter().map(all).collect();
                if let Some((_, first)) = answers.first_mut() {
                    *first = Answer::Rejected(reason);
                }
                return Ok(answers);
            };
            let parts = modules::split(&text);
            let kept = parts.modules.iter().filter(|(name, _)| *name != module);
            let kept = modules::join(parts.head, kept.map(|(_, body)| *body));
            rejected.insert(module, reason);
            write(&scratch.join(&path), &kept)?;
            text = kept;
        }
        let answer = |t: &&Theorem| match rejected.get(&t.module) {
            Some(reason) => (t.name(), Answer::Rejected(reason.clone())),
            None => (t.name(), Answer::Accepted),
        };
        Ok(theorems.iter().map(answer).collect())
    }

    /// Compiles the section that printed statements follow from, unless it was compiled. Its errors are reported by the
    /// theorems that follow from it.
    fn proved(&self, core: &str, scratch: &Path, limits: Limits) -> Result<(), CheckError> {
        for end in [".v", CLOSED, PROOFS] {
            let path = scratch.join(format!("{core}{end}"));
            if path.exists() && !path.with_extension("vo").exists() {
                self.run(scratch, &format!("{core}{end}"), limits)?;
            }
        }
        Ok(())
    }

    /// Compiles the closed forms of the definitions of a section, if there are any; returns their error.
    pub(crate) fn closed_forms(
        &self,
        folder: &Folder,
        section: &str,
        scratch: &Path,
        limits: Limits,
    ) -> Result<Result<(), String>, CheckError> {
        let path = format!("{section}{CLOSED}");
        if !folder.files.contains_key(&path) {
            return Ok(Ok(()));
        }
        let run = self.run(scratch, &path, limits)?;
        Ok(match run.status.success() {
            true => Ok(()),
            false => Err(first_lines(&run.text)),
        })
    }

    /// Runs the program on one file of the scratch folder.
    ///
    /// # Errors
    /// [`CheckError`] if it cannot be run at all.
    pub fn run(&self, scratch: &Path, file: &str, limits: Limits) -> Result<Run, CheckError> {
        let mut command = limited("coqc", limits.memory);
        command.args(["-q", "-w", "none"]);
        for prefix in prefixes(scratch)? {
            command.arg("-Q").arg(&prefix).arg(&prefix);
        }
        command.arg(file).current_dir(scratch).stdin(Stdio::null());
        run(&mut command, limits.time)
    }
}

/// Runs `work` on every section of a folder, several at once, and returns the results in the order of the sections.
/// Calls `done` once for each section.
///
/// # Errors
/// The error of the first section that has one.
pub(crate) fn each_section<T: Send>(
    folder: &Folder,
    at_once: usize,
    done: &(dyn Fn() + Sync),
    work: &(dyn Fn(&str) -> Result<T, CheckError> + Sync),
) -> Result<Vec<T>, CheckError> {
    let sections = folder.sections();
    // A printed statement follows from a proved one.
    let needs = |section: &str| {
        let core = printed::proved(section)?;
        sections.iter().position(|other| *other == core)
    };
    let jobs = sections.iter().map(|section| (*section, needs(section)));
    let jobs: Vec<_> = jobs
        .map(|(section, need)| (section, need.into_iter().collect()))
        .collect();
    scheduler::worked(&jobs, at_once, &|section| {
        let result = work(section);
        done();
        result
    })
}

/// The result of a run.
#[derive(Debug)]
pub struct Run {
    /// How it ended; a run that took too long was killed.
    pub status: ExitStatus,
    /// Whether it was killed.
    pub killed: bool,
    /// Its output.
    pub text: String,
}

/// Makes a command with a limit of memory, which the shell sets.
pub(crate) fn limited(program: &str, kilobytes: u64) -> Command {
    let mut command = Command::new("sh");
    command.args([
        "-c",
        &format!("ulimit -v {kilobytes}; exec nice -n 10 {program} \"$@\""),
        program,
    ]);
    command
}

/// Runs a command until it ends or its time is over.
pub(crate) fn run(command: &mut Command, limit: Duration) -> Result<Run, CheckError> {
    let system = |source| CheckError::System {
        what: "coqc cannot be run".to_owned(),
        source,
    };
    let command = command.stdout(Stdio::piped()).stderr(Stdio::piped());
    let mut child = command.spawn().map_err(system)?;
    let readers = [
        child.stdout.take().map(|pipe| reader(Box::new(pipe))),
        child.stderr.take().map(|pipe| reader(Box::new(pipe))),
    ];
    let (status, killed) = wait(&mut child, limit).map_err(system)?;
    let mut text = String::new();
    for reader in readers.into_iter().flatten() {
        text.push_str(&reader.join().unwrap_or_default());
    }
    if killed {
        text.push_str(&format!("\nError: more than {} s", limit.as_secs()));
    }
    Ok(Run {
        status,
        killed,
        text,
    })
}

fn reader(mut pipe: Box<dyn Read + Send>) -> std::thread::JoinHandle<String> {
    std::thread::spawn(move || {
        let mut bytes = vec![];
        // After an error, the output read so far is shown.
        let _ = pipe.read_to_end(&mut bytes);
        String::from_utf8_lossy(&bytes).into_owned()
    })
}

fn wait(child: &mut Child, limit: Duration) -> io::Result<(ExitStatus, bool)> {
    let start = Instant::now();
    loop {
        if let Some(status) = child.try_wait()? {
            return Ok((status, false));
        }
        if start.elapsed() > limit {
            child.kill()?;
            return Ok((child.wait()?, true));
        }
        std::thread::sleep(Duration::from_millis(20));
    }
}

/// Writes the files of a folder below a path.
///
/// # Errors
/// [`CheckError::System`].
pub fn lay_out(folder: &Folder, below: &Path) -> Result<(), CheckError> {
    for (path, text) in &folder.files {
        write(&below.join(path), text)?;
    }
    Ok(())
}

fn write(path: &Path, text: &str) -> Result<(), CheckError> {
    let system = |source| CheckError::System {
        what: format!("cannot write {}", path.display()),
        source,
    };
    if let Some(parent) = path.parent() {
        std::fs::create_dir_all(parent).map_err(system)?;
    }
    std::fs::write(path, text).map_err(system)
}

/// Returns the options for the folders of a scratch folder, each a prefix of its own.
pub(crate) fn prefixes(scratch: &Path) -> Result<Vec<String>, CheckError> {
    let system = |source| CheckError::System {
        what: "cannot read the scratch folder".to_owned(),
        source,
    };
    let mut names = vec![];
    for entry in std::fs::read_dir(scratch).map_err(system)? {
        let entry = entry.map_err(system)?;
        if entry.path().is_dir() {
            names.push(entry.file_name().to_string_lossy().into_owned());
        }
    }
    names.sort();
    Ok(names)
}

/// Returns the line of the first error: `File "./P/S.v", line 12, characters 0-31:`.
fn error_line(text: &str) -> Option<usize> {
    let (_, rest) = text.split_once(", line ")?;
    let digits: String = rest.chars().take_while(char::is_ascii_digit).collect();
    digits.parse().ok()
}

/// Returns the module in which a line stands, counted from 1.
fn module_at(text: &str, line: usize) -> Option<String> {
    let opened = |line: &str| Some(line.strip_prefix("Module ")?.strip_suffix('.')?.to_owned());
    text.lines().take(line).filter_map(opened).last()
}

/// Returns the axioms of a `Print Assumptions`: the words before the colons of its list.
fn assumptions(text: &str) -> Vec<String> {
    let Some((_, list)) = text.split_once("Axioms:") else {
        return vec![];
    };
    let names = list
        .lines()
        .filter(|line| !line.starts_with(char::is_whitespace));
    let mut names: Vec<String> = names
        .filter_map(|line| Some(line.split([':', ' ']).next()?.to_owned()))
        .filter(|name| !name.is_empty())
        .collect();
    names.sort();
    names
}

/// Returns the axioms of the summary of `coqchk`: the lines indented below `* Axioms:`.
fn listed_axioms(text: &str) -> Vec<String> {
    let Some((_, list)) = text.split_once("* Axioms:") else {
        return vec![];
    };
    let indented = |line: &&str| line.starts_with("    ");
    let names = list.lines().skip(1).take_while(indented);
    let mut names: Vec<String> = names.map(|line| line.trim().to_owned()).collect();
    names.sort();
    names
}

fn first_lines(text: &str) -> String {
    let lines: Vec<&str> = text
        .lines()
        .filter(|line| !line.trim().is_empty())
        .take(12)
        .collect();
    lines.join("\n")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_error_names_its_theorem() {
        let proofs = "From Torse Require Import Defs.\n\nModule one.\nProof.\nEnd one.\n\nModule two.\nProof.\n";
        let error = "File \"./P/S_proofs.v\", line 8, characters 0-6:\nError: no.";
        let module = error_line(error).and_then(|line| module_at(proofs, line));
        assert_eq!(module.as_deref(), Some("two"));
    }

    #[test]
    fn axioms_are_read_off_the_list() {
        let text =
            "x : y\nAxioms:\nB.classic : forall P : Prop, P \\/ ~ P\nA.sig\n  : forall P,\n    P\n";
        assert_eq!(assumptions(text), ["A.sig", "B.classic"]);
        assert_eq!(assumptions("Closed under the global context"), [""; 0]);
    }

    #[test]
    fn axioms_are_read_off_the_summary_of_the_separate_checker() {
        let text = "CONTEXT SUMMARY\n===\n\n* Theory: Set is predicative\n\n* Axioms:\n    B.classic\n    A.sig\n\n* Constants: none\n";
        assert_eq!(listed_axioms(text), ["A.sig", "B.classic"]);
        assert_eq!(listed_axioms("* Axioms: <none>\n"), [""; 0]);
    }

    #[test]
    fn a_run_that_takes_too_long_is_ended() {
        let mut command = Command::new("sleep");
        let run = run(command.arg("30"), Duration::from_millis(50)).unwrap();
        assert!(!run.status.success());
        assert!(run.text.contains("more than 0 s"));
    }
}
