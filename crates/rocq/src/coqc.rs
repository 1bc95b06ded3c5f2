//! Runs `coqc`, with limits of time and memory, on a scratch copy of a folder of proofs.

use crate::accepted::CoqchkAnswer;
use crate::check::{self, CHECK, PROOFS};
use crate::closed::CLOSED;
use crate::coqc_output::{assumptions, error_line, first_lines, listed_axioms, module_at};
use crate::folder::Folder;
use crate::kernel_error::KernelError;
use crate::library::{self, LIBRARY};
use crate::printed::{self, FOLLOWS, FUNCTIONS, JETS};
use crate::process::{Run, limited, run};
use crate::theorem::Theorem;
use crate::{modules, scheduler};
use std::collections::BTreeMap;
use std::io;
use std::path::Path;
use std::process::{Command, Stdio};
use std::time::Duration;

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
    /// [`KernelError::Missing`] if it is not there, [`KernelError::System`] if it cannot be run.
    pub fn find() -> Result<Self, KernelError> {
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
            Ok(_) => Err(KernelError::Missing),
            Err(error) if error.kind() == io::ErrorKind::NotFound => Err(KernelError::Missing),
            Err(source) => Err(KernelError::System {
                what: "coqc cannot be run".to_owned(),
                source,
            }),
        }
    }

    /// Checks all theorems of a folder in `scratch`, which contains the compiled [library](Self::library) and nothing
    /// else. Calls `done` once for each section, and at the end.
    ///
    /// # Errors
    /// [`KernelError`] if nothing could be checked.
    pub fn check(
        &self,
        folder: &Folder,
        scratch: &Path,
        limits: Limits,
        done: &(dyn Fn() + Sync),
    ) -> Result<(BTreeMap<String, Answer>, Vec<String>), KernelError> {
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
    ) -> Result<Vec<String>, KernelError> {
        let mut left = BTreeMap::new();
        for (path, text) in &folder.files {
            let Some(section) = path.strip_suffix(PROOFS) else {
                continue;
            };
            let accepted = |module: &str| {
                answers.get(&format!("{section}.{module}")) == Some(&Answer::Accepted)
            };
            let Some(kept) = modules::with_some(text, accepted) else {
                continue;
            };
            if kept != *text {
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
    /// [`KernelError`]; [`KernelError::Library`] if the library is not accepted.
    pub fn library(
        &self,
        scratch: &Path,
        limits: Limits,
        done: &(dyn Fn() + Sync),
    ) -> Result<(), KernelError> {
        for (path, text) in LIBRARY.into_iter().chain([FOLLOWS, FUNCTIONS, JETS]) {
            write(&scratch.join(path), text)?;
        }
        let compile = |path: &str| {
            let run = self.run(scratch, path, limits)?;
            done();
            match run.status.success() {
                true => Ok(()),
                false => Err(KernelError::Library(first_lines(&run.text))),
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
    /// [`KernelError`] if it cannot be run at all.
    pub fn recheck(
        &self,
        scratch: &Path,
        limits: Limits,
        theorems: usize,
    ) -> Result<Option<CoqchkAnswer>, KernelError> {
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
        let answer = CoqchkAnswer {
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
    ) -> Result<Vec<(String, Answer)>, KernelError> {
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
    fn proved(&self, core: &str, scratch: &Path, limits: Limits) -> Result<(), KernelError> {
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
    ) -> Result<Result<(), String>, KernelError> {
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
    /// [`KernelError`] if it cannot be run at all.
    pub fn run(&self, scratch: &Path, file: &str, limits: Limits) -> Result<Run, KernelError> {
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
    work: &(dyn Fn(&str) -> Result<T, KernelError> + Sync),
) -> Result<Vec<T>, KernelError> {
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

/// Writes the files of a folder below a path.
///
/// # Errors
/// [`KernelError::System`].
pub fn lay_out(folder: &Folder, below: &Path) -> Result<(), KernelError> {
    for (path, text) in &folder.files {
        write(&below.join(path), text)?;
    }
    Ok(())
}

fn write(path: &Path, text: &str) -> Result<(), KernelError> {
    let system = |source| KernelError::System {
        what: format!("cannot write {}", path.display()),
        source,
    };
    if let Some(parent) = path.parent() {
        std::fs::create_dir_all(parent).map_err(system)?;
    }
    std::fs::write(path, text).map_err(system)
}

/// Returns the options for the folders of a scratch folder, each a prefix of its own.
pub(crate) fn prefixes(scratch: &Path) -> Result<Vec<String>, KernelError> {
    let system = |source| KernelError::System {
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
