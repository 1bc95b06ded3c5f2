//! `torse prove`: statements and proofs for the Rocq kernel.

use crate::derivations::Derivations;
use crate::exit::{Exit, Failure};
use crate::format::pretty_json;
use crate::proof_tasks::proof_tasks;
use crate::run::{Budget, Run};
use crate::terminal::Progress;
use crate::{terminal, watchdog};
use clap::Args;
use std::collections::{BTreeMap, BTreeSet};
use std::path::{Component, Path, PathBuf};
use std::sync::{Mutex, PoisonError};
use std::time::Duration;
use tempfile::TempDir;
use torse_certificate::Evidence;
use torse_report::{ReportError, write_file};
use torse_rocq::accepted::{Accepted, Fingerprints};
use torse_rocq::coqc::{AXIOMS, Answer, Coqc, Limits};
use torse_rocq::folder::{self, ACCEPTED, Folder, Layout, SCRIPTS, UNPROVED};
use torse_rocq::library::LIBRARY;
use torse_rocq::merge;
use torse_rocq::task::ProofTask;
use torse_rocq::theorem::Theorem;
use torse_rocq::{printed, script, script_search};

/// Why theorems have no proof, by name.
type Unproved = BTreeMap<String, String>;
/// The script that proves a theorem, if it is not the first.
type ScriptNumbers = BTreeMap<String, usize>;
/// Stores which theorems of a section were tried, and the failures.
type StoreResults<'a> = &'a (dyn Fn(&[String], &Unproved) -> Result<(), Failure> + Sync);

/// Write statements and proofs of verdicts for the Rocq kernel, and have them checked.
///
/// For each claim with a verdict, torse writes a statement in the order of the print, with the definedness of its terms
/// as premises, and a proof in another file. `--check` runs coqc (Coq 8.16.1: apt-get install coq libcoq-coquelicot)
/// and records accepted proofs in accepted.json. A rejected proof contradicts a verdict: the exit code is 6.
#[derive(Args)]
#[command(after_help = EXAMPLES)]
pub struct Prove {
    /// Papers, claims, or prefixes of ids
    #[arg(value_name = "PAPER|ID")]
    names: Vec<String>,
    /// Write to this folder
    #[arg(long, value_name = "DIR", default_value = "proofs")]
    out: PathBuf,
    /// Run coqc on all files
    #[arg(long)]
    check: bool,
    /// With `--check`: skip theorems that the kernel accepted and that did not change
    #[arg(long, requires = "check")]
    changed: bool,
    /// With `--check`: also run the separate checker coqchk on all compiled files, which takes up to an hour
    #[arg(long, requires = "check", conflicts_with = "changed")]
    thorough: bool,
    /// Search for scripts that prove their theorems, for this many seconds each; the others are left out from then on
    #[arg(long = "try", value_name = "SECONDS", num_args = 0..=1, default_missing_value = "20")]
    attempt: Option<u64>,
    /// Run this many coqc at once
    #[arg(long, value_name = "N", default_value_t = 2, value_parser = clap::value_parser!(u8).range(1..))]
    jobs: u8,
    /// Limit the time for one file, in seconds
    #[arg(long, value_name = "SECONDS", default_value_t = 600)]
    file_limit: u64,
    /// Limit the memory of one coqc, in megabytes
    #[arg(long, value_name = "MB", default_value_t = 4000)]
    memory: u64,
    #[command(flatten)]
    budget: Budget,
    #[command(flatten)]
    derivations: Derivations,
}

const EXAMPLES: &str = "\
Examples:
  torse prove                                     write proofs/
  torse prove --check                             and have the kernel check them
  torse prove gbt-developable/eq-3.11 --out out --check
  torse prove --derivations my-papers --out my-proofs --try --check";

impl Prove {
    /// Decides, writes and checks; prints the theorems with a proof, and why others have none.
    pub fn run(&self) -> Result<Exit, Failure> {
        let (papers, mut mistakes) = self.derivations.select(&self.names)?;
        // Fails before minutes are spent on verdicts.
        let coqc = match self.check || self.attempt.is_some() {
            true => Some(Coqc::find()?),
            false => None,
        };
        let run = Run::new(&papers, self.budget, &mut mistakes);
        watchdog::finished();
        let tasks = proof_tasks(&papers, &run);
        let unread = |reason| Failure::ReadProofs {
            path: self.out.join(UNPROVED),
            reason,
        };
        let mut unproved = folder::unproved(&self.out).map_err(unread)?;
        let mut chosen = folder::chosen(&self.out);
        if let (Some(_), Some(coqc)) = (self.attempt, &coqc) {
            (unproved, chosen) = self.search_scripts(coqc, &tasks, unproved, chosen)?;
        }
        let folder = Folder::with_scripts(&tasks, &unproved, &chosen, self.layout());
        let old = merge::ours(&|path| std::fs::read_to_string(self.out.join(path)).ok());
        let files = match self.names.is_empty() {
            true => folder.files.clone(),
            false => merge::merged(&folder, &old),
        };
        for (path, text) in &files {
            self.write(path, text)?;
        }
        for path in old.keys().filter(|path| !files.contains_key(*path)) {
            self.remove(path)?;
        }
        let mut exit = Exit::AsExpected;
        let mut text = describe_files(&folder);
        if let (true, Some(coqc)) = (self.check, &coqc) {
            let (summary, found) = match self.changed {
                true => self.check_changed(coqc, &folder)?,
                false => self.check_all(coqc, &folder, self.compile_library(coqc)?.path())?,
            };
            text.push_str(&summary);
            exit = found;
        }
        terminal::print(&text)?;
        Ok(mistakes.tell(exit))
    }

    fn limits(&self) -> Limits {
        Limits {
            time: Duration::from_secs(self.file_limit),
            memory: self.memory.saturating_mul(1024),
            at_once: self.jobs.into(),
        }
    }

    /// Writes one file, unless it exists with the same text.
    fn write(&self, path: &str, text: &str) -> Result<(), Failure> {
        let path = self.out.join(path);
        if std::fs::read(&path).is_ok_and(|old| old == text.as_bytes()) {
            return Ok(());
        }
        Ok(write_file(&path, text.as_bytes())?)
    }

    /// Removes a file that an earlier run wrote and this one does not.
    fn remove(&self, path: &str) -> Result<(), Failure> {
        // The list of files may have been edited: only files inside the folder are ours.
        let inside = |part| matches!(part, Component::Normal(_));
        if !Path::new(path).components().all(inside) {
            return Ok(());
        }
        let path = self.out.join(path);
        std::fs::remove_file(&path).map_err(|source| ReportError::Write { path, source }.into())
    }

    /// Returns the layout: sections share their definitions for whole papers, and do not for selected claims.
    fn layout(&self) -> Layout {
        match self.names.iter().any(|name| name.contains('/')) {
            false => Layout::Together,
            true => Layout::Apart,
        }
    }

    /// Finds the theorems that no script proves, and the scripts of the others if they are not the first, for the
    /// theorems of this run. Results are written section by section.
    fn search_scripts(
        &self,
        coqc: &Coqc,
        tasks: &[(String, Vec<ProofTask<'_>>)],
        mut unproved: Unproved,
        mut chosen: ScriptNumbers,
    ) -> Result<(Unproved, ScriptNumbers), Failure> {
        let all = Folder::with_scripts(tasks, &BTreeMap::new(), &BTreeMap::new(), self.layout());
        let own: BTreeSet<String> = all.theorems.iter().map(Theorem::name).collect();
        // Without names this run has all theorems.
        let kept = |name: &String| !self.names.is_empty() || own.contains(name);
        unproved.retain(|name, _| kept(name));
        chosen.retain(|name, _| kept(name));
        if own.is_empty() {
            return Ok((unproved, chosen));
        }
        let mut left = own;
        let scratch = self.compile_library(coqc)?;
        for which in 0..=script::OTHERS.len() {
            if left.is_empty() {
                break;
            }
            // Only the remaining theorems are tried.
            let known = all.theorems.iter().map(Theorem::name);
            let known = known.filter(|name| !left.contains(name));
            let known = known.map(|name| (name, String::new())).collect();
            let scripts = left.iter().map(|name| (name.clone(), which)).collect();
            let folder = Folder::with_scripts(tasks, &known, &scripts, self.layout());
            let found = Mutex::new((unproved, chosen, left));
            self.try_scripts(coqc, &folder, scratch.path(), &|names, failing| {
                let mut found = found.lock().unwrap_or_else(PoisonError::into_inner);
                let (unproved, chosen, left) = &mut *found;
                for name in names {
                    match failing.get(name) {
                        Some(reason) if which == 0 => {
                            unproved.insert(name.clone(), reason.clone());
                            chosen.remove(name);
                        }
                        Some(_) => {}
                        None => {
                            unproved.remove(name);
                            left.remove(name);
                            match which {
                                0 => chosen.remove(name),
                                _ => chosen.insert(name.clone(), which),
                            };
                        }
                    }
                }
                self.write(UNPROVED, &pretty_json(&*unproved)?)?;
                self.write(SCRIPTS, &pretty_json(&*chosen)?)
            })?;
            (unproved, chosen, left) = found.into_inner().unwrap_or_else(PoisonError::into_inner);
        }
        Ok((unproved, chosen))
    }

    /// A scratch folder with the compiled library.
    fn compile_library(&self, coqc: &Coqc) -> Result<TempDir, Failure> {
        let scratch = scratch()?;
        let progress = Progress::new("compiling the library", LIBRARY.len());
        coqc.library(scratch.path(), self.limits(), &|| progress.step())?;
        progress.finish();
        Ok(scratch)
    }

    /// Tries the scripts of a folder, and passes the results of each section to `keep`.
    fn try_scripts(
        &self,
        coqc: &Coqc,
        folder: &Folder,
        scratch: &Path,
        keep: StoreResults<'_>,
    ) -> Result<(), Failure> {
        let progress = Progress::new("trying", folder.sections().len());
        let seconds = self.attempt.unwrap_or(20);
        let found = |names: &[String], failing: &Unproved| {
            progress.step();
            keep(names, failing)
        };
        self.try_scripts_within(coqc, folder, scratch, seconds, &found)?;
        progress.finish();
        Ok(())
    }

    /// Returns the theorems of a folder that find no proof within so many seconds each.
    fn try_scripts_within(
        &self,
        coqc: &Coqc,
        folder: &Folder,
        scratch: &Path,
        seconds: u64,
        keep: StoreResults<'_>,
    ) -> Result<Unproved, Failure> {
        let unkept = Mutex::new(None);
        let found = |names: &[String], failing: &Unproved| {
            if let Err(failure) = keep(names, failing) {
                let mut unkept = unkept.lock().unwrap_or_else(PoisonError::into_inner);
                unkept.get_or_insert(failure);
            }
        };
        let failing =
            script_search::failing(coqc, folder, scratch, seconds, self.limits(), &found)?;
        let unkept = unkept.into_inner().unwrap_or_else(PoisonError::into_inner);
        unkept.map_or(Ok(failing), Err)
    }

    /// Asks the kernel about theorems that it did not accept yet with this library, statement and proof, and about no
    /// others. Answers are stored section by section.
    fn check_changed(&self, coqc: &Coqc, folder: &Folder) -> Result<(String, Exit), Failure> {
        let open = self.open_theorems(coqc, folder);
        if open.is_empty() {
            return Ok((
                "all was accepted as it stands\n".to_owned(),
                Exit::AsExpected,
            ));
        }
        let scratch = self.compile_library(coqc)?;
        let mut text = String::new();
        let mut exit = Exit::AsExpected;
        let is_printed = |theorem: &&Theorem| theorem.rests_on.is_some();
        let proved = open.iter().filter(|theorem| !is_printed(theorem));
        let proved = folder.of_theorems(&proved.map(|theorem| theorem.name()).collect());
        for section in proved.sections() {
            let own = proved.of_sections(&BTreeSet::from([section]));
            let (summary, found) = self.check_all(coqc, &own, scratch.path())?;
            text.push_str(&format!("{section}: {summary}"));
            exit = exit.max(found);
        }
        if open.iter().any(is_printed) {
            let (summary, found) = self.check_printed(coqc, folder, scratch.path())?;
            text.push_str(&summary);
            exit = exit.max(found);
        }
        Ok((text, exit))
    }

    /// The stored answers, if they are of this version of the program.
    fn accepted_before(&self, version: &str) -> Option<Accepted> {
        Accepted::read(&self.out).filter(|old| old.coq == version)
    }

    /// The theorems that were not accepted as they are.
    fn open_theorems<'f>(&self, coqc: &Coqc, folder: &'f Folder) -> Vec<&'f Theorem> {
        let prints = Fingerprints::of_version(&coqc.version);
        let old = self.accepted_before(&coqc.version);
        let is_known = |theorem: &&Theorem| {
            let old = old.as_ref();
            old.is_some_and(|old| old.has(theorem, &prints.fingerprint(theorem)))
        };
        let all = folder.theorems.iter();
        all.filter(|theorem| !is_known(theorem)).collect()
    }

    /// Checks the open printed statements with the statements that they follow from as premises, where these were
    /// accepted.
    fn check_printed(
        &self,
        coqc: &Coqc,
        folder: &Folder,
        scratch: &Path,
    ) -> Result<(String, Exit), Failure> {
        let open = self.open_theorems(coqc, folder);
        let (printed, core): (Vec<&Theorem>, Vec<&Theorem>) = open
            .into_iter()
            .partition(|theorem| theorem.rests_on.is_some());
        let core: BTreeSet<String> = core.into_iter().map(Theorem::name).collect();
        let follows = |theorem: &&&Theorem| {
            let section = printed::proved(&theorem.section);
            section.is_some_and(|core_section| {
                !core.contains(&format!("{core_section}.{}", theorem.module))
            })
        };
        let names = printed.iter().filter(follows).map(|theorem| theorem.name());
        let alone = folder.of_theorems(&names.collect());
        let open = printed.len() - alone.theorems.len();
        let prints = Fingerprints::of_version(&coqc.version);
        let Some(mut accepted) = self.accepted_before(&coqc.version) else {
            let all = printed.len();
            return Ok((
                format!("{all} not reached as printed\n"),
                Exit::Contradiction,
            ));
        };
        accepted.coqchk = None;
        let progress = Progress::new("checking what is printed", alone.sections().len());
        let accepted = Mutex::new(accepted);
        let keep = |names: &[String], failing: &Unproved| {
            progress.step();
            let mut accepted = accepted.lock().unwrap_or_else(PoisonError::into_inner);
            for theorem in &alone.theorems {
                let name = theorem.name();
                if names.contains(&name) && !failing.contains_key(&name) {
                    accepted.theorems.insert(name, prints.fingerprint(theorem));
                }
            }
            self.write(ACCEPTED, &pretty_json(&*accepted)?)
        };
        let failing = self.try_scripts_within(coqc, &alone, scratch, self.file_limit, &keep)?;
        progress.finish();
        let mut text = String::new();
        for theorem in &alone.theorems {
            let name = theorem.name();
            if let Some(reason) = failing.get(&name) {
                text.push_str(&format!("rejected: {} ({name})\n{reason}\n", theorem.id));
            }
        }
        text.push_str(&format!(
            "{} accepted as printed, {} rejected, {open} not reached, beside what they follow from\n",
            alone.theorems.len() - failing.len(),
            failing.len()
        ));
        let exit = match failing.len() + open {
            0 => Exit::AsExpected,
            _ => Exit::Contradiction,
        };
        Ok((text, exit))
    }

    /// Asks the kernel, stores the accepted theorems, and describes the result.
    fn check_all(
        &self,
        coqc: &Coqc,
        folder: &Folder,
        scratch: &Path,
    ) -> Result<(String, Exit), Failure> {
        let progress = Progress::new("checking", folder.sections().len() + 1);
        let checked = coqc.check(folder, scratch, self.limits(), &|| progress.step());
        progress.finish();
        let (answers, axioms) = checked?;
        let mut text = String::new();
        let mut counts = [0_usize; 3];
        let mut as_printed = 0_usize;
        let fingerprints = Fingerprints::of_version(&coqc.version);
        let mut accepted = BTreeMap::new();
        for theorem in &folder.theorems {
            let place = match answers.get(&theorem.name()) {
                Some(Answer::Accepted) => {
                    let print = fingerprints.fingerprint(theorem);
                    accepted.insert(theorem.name(), print);
                    // Printed statements are counted separately: they follow from the proved ones.
                    if theorem.rests_on.is_some() {
                        as_printed += 1;
                        continue;
                    }
                    0
                }
                Some(Answer::Rejected(reason)) => {
                    text.push_str(&format!(
                        "rejected: {} ({})\n{reason}\n",
                        theorem.id,
                        theorem.name()
                    ));
                    1
                }
                Some(Answer::NotReached) | None => 2,
            };
            if let Some(count) = counts.get_mut(place) {
                *count += 1;
            }
        }
        let [good, bad, open] = counts;
        let foreign: Vec<&String> = axioms
            .iter()
            .filter(|a| !AXIOMS.contains(&a.as_str()))
            .collect();
        for axiom in &foreign {
            text.push_str(&format!("a proof rests on `{axiom}`\n"));
        }
        text.push_str(&format!(
            "Coq {}: {good} accepted, {bad} rejected, {open} not reached; {as_printed} accepted as printed; axioms: {}\n",
            coqc.version,
            if axioms.is_empty() {
                "none".to_owned()
            } else {
                axioms.join(", ")
            }
        ));
        let rechecked = match self.thorough {
            true => {
                let progress = Progress::new("coqchk", 1);
                let answer = coqc.recheck(scratch, self.limits(), accepted.len())?;
                progress.finish();
                text.push_str(match answer.as_ref().map(|answer| answer.accepted) {
                    Some(true) => "coqchk accepts what was compiled\n",
                    Some(false) => "coqchk does not accept what was compiled\n",
                    None => "coqchk did not end within an hour\n",
                });
                answer
            }
            false => None,
        };
        let doubted = rechecked.as_ref().is_some_and(|answer| !answer.accepted);
        let fresh = Accepted {
            coq: coqc.version.clone(),
            axioms: axioms.clone(),
            coqchk: rechecked,
            theorems: accepted,
        };
        let mut fresh = self.merge_earlier(fresh, folder);
        // The answer of the separate checker is valid while the theorems are the same.
        if fresh.coqchk.is_none()
            && let Some(old) = Accepted::read(&self.out)
            && old.theorems == fresh.theorems
        {
            fresh.coqchk = old.coqchk;
        }
        text.push_str(self.describe_merge(&fresh));
        self.write(ACCEPTED, &pretty_json(&fresh)?)?;
        let exit = match bad + open + foreign.len() + usize::from(doubted) {
            0 => Exit::AsExpected,
            _ => Exit::Contradiction,
        };
        Ok((text, exit))
    }

    /// Returns the theorems accepted before, of claims that are not part of this run.
    fn merge_earlier(&self, mut fresh: Accepted, folder: &Folder) -> Accepted {
        let old = match self.names.is_empty() && !self.changed {
            true => None,
            false => self.accepted_before(&fresh.coq),
        };
        let current: BTreeSet<String> = folder.theorems.iter().map(Theorem::name).collect();
        if let Some(old) = old {
            let others = old.theorems.into_iter();
            fresh
                .theorems
                .extend(others.filter(|(name, _)| !current.contains(name)));
            fresh.axioms.extend(old.axioms);
            fresh.axioms.sort();
            fresh.axioms.dedup();
        }
        fresh
    }

    /// How stored answers are combined with fresh ones.
    fn describe_merge(&self, fresh: &Accepted) -> &'static str {
        let path = self.out.join(ACCEPTED);
        let Ok(text) = std::fs::read_to_string(path) else {
            return "accepted.json is new\n";
        };
        match serde_json::from_str::<Accepted>(&text) {
            Ok(old) if old == *fresh => "accepted.json agrees\n",
            Ok(_) => "accepted.json was stale and is written anew\n",
            Err(_) => "accepted.json could not be read and is written anew\n",
        }
    }
}

/// A folder that is removed when dropped.
fn scratch() -> Result<TempDir, Failure> {
    let made = tempfile::Builder::new().prefix("torse-prove-").tempdir();
    made.map_err(|source| {
        let path = std::env::temp_dir();
        ReportError::Write { path, source }.into()
    })
}

/// Describes what was written, by evidence, and why the rest was not.
fn describe_files(folder: &Folder) -> String {
    let mut rows: BTreeMap<&str, [usize; 2]> = BTreeMap::new();
    for theorem in folder.theorems.iter().filter(|t| t.rests_on.is_none()) {
        rows.entry(theorem.evidence.word()).or_default()[0] += 1;
    }
    let mut reasons: BTreeMap<&str, usize> = BTreeMap::new();
    for missing in &folder.missing {
        let word = missing.evidence.map_or("no evidence", Evidence::word);
        rows.entry(word).or_default()[1] += 1;
        *reasons.entry(&missing.reason).or_default() += 1;
    }
    let mut table = terminal::table();
    table.add_row(["rests on", "proofs", "not generated"]);
    for (word, [proofs, missing]) in rows {
        table.add_row([word.to_owned(), proofs.to_string(), missing.to_string()]);
    }
    let mut text = terminal::lines(&table);
    let mut table = terminal::table();
    for (reason, count) in reasons {
        table.add_row([count.to_string(), reason.to_owned()]);
    }
    text.push_str("\nnot generated:\n");
    text.push_str(&terminal::lines(&table));
    let printed = folder.theorems.iter().filter(|t| t.rests_on.is_some());
    text.push_str(&format!(
        "\n{} of them stated as printed, {} not\n",
        printed.count(),
        folder.not_printed.len()
    ));
    text.push('\n');
    text
}
