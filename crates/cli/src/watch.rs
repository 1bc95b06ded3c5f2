//! `torse verify --watch`: polls the files and decides changed papers again.
//!
//! Files are compared by their contents, a few times a second: they are small, and this works on every system and file
//! system. A change counts once two polls in a row see the same contents, so that half a file is not read. Papers are
//! independent: only those with a changed file are decided again. The screen is not cleared; Ctrl-C ends the command.

use crate::baseline::{self, Verdicts};
use crate::derivations::Derivations;
use crate::exit::{Exit, Failure};
use crate::run::{Budget, Run};
use crate::{diagnostics::Diagnostics, figures, terminal, verdicts, watchdog};
use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::{Path, PathBuf};
use std::time::Duration;
use torse_report::{ReportError, verdicts_json};
use torse_verdicts::outcome::PaperOutcome;

/// The time between two polls.
const PAUSE: Duration = Duration::from_millis(250);

/// What is watched.
pub struct Watch<'a> {
    pub derivations: &'a Derivations,
    pub names: &'a [String],
    pub budget: Budget,
}

impl Watch<'_> {
    /// Verifies, and again after every change; only a signal or a failed write ends it.
    pub fn run(&self) -> Result<Exit, Failure> {
        let folder = self.derivations.find()?;
        // Taken before the files are read, so that a change meanwhile is noticed.
        let mut files = Files::new(&folder);
        let mut known = vec![];
        self.verify(None, &mut known)?;
        watchdog::finished();
        terminal::print(&verdicts::text(&known))?;
        terminal::remark(&format!("watching {}; Ctrl-C ends\n", folder.display()));
        // Also of papers that could not be read after a change.
        let mut waiting = BTreeSet::new();
        loop {
            let changed = files.next_change(&folder);
            let names: Vec<String> = changed.iter().map(|p| p.display().to_string()).collect();
            terminal::print(&format!("\nchanged: {}\n", names.join(", ")))?;
            let before = verdicts_of(&known)?;
            waiting.extend(slugs(&changed));
            // Errors are shown, and may be gone after the next change.
            if let Err(failure) = self.verify(Some(&waiting), &mut known) {
                terminal::complain(&failure);
                continue;
            }
            waiting.clear();
            let now = verdicts_of(&known)?;
            let found = baseline::text(&baseline::differences(&before, &now));
            let outcomes = known.iter().flat_map(|paper| &paper.claims);
            terminal::print(&format!("{found}{}", verdicts::unexpected(outcomes)))?;
        }
    }

    /// Decides these papers, or all; results of the others are kept.
    fn verify(
        &self,
        changed: Option<&BTreeSet<String>>,
        known: &mut Vec<PaperOutcome>,
    ) -> Result<(), Failure> {
        let (papers, mut mistakes): (_, Diagnostics) = self.derivations.select(self.names)?;
        let order: Vec<String> = papers.iter().map(|paper| paper.head.id.clone()).collect();
        let is_known = |slug: &String| known.iter().any(|paper| paper.slug == *slug);
        let old = |slug: &String| changed.is_some_and(|c| !c.contains(slug)) && is_known(slug);
        let papers: Vec<_> = papers
            .into_iter()
            .filter(|paper| !old(&paper.head.id))
            .collect();
        let run = Run::new(&papers, self.budget, &mut mistakes);
        figures::evaluated(&papers, &mut mistakes);
        let mut all: BTreeMap<String, PaperOutcome> = known
            .drain(..)
            .chain(run.papers)
            .map(|paper| (paper.slug.clone(), paper))
            .collect();
        known.extend(order.iter().filter_map(|slug| all.remove(slug)));
        mistakes.tell(Exit::AsExpected);
        Ok(())
    }
}

fn verdicts_of(known: &[PaperOutcome]) -> Result<Verdicts, Failure> {
    let json = verdicts_json(known.iter().flat_map(|paper| &paper.claims))?;
    Ok(Verdicts::parse(&json).map_err(ReportError::from)?)
}

/// Returns the folders of papers that contain these files.
fn slugs(changed: &[PathBuf]) -> BTreeSet<String> {
    let folders = changed.iter().filter_map(|path| path.iter().next());
    let folders = folders.map(|name| name.to_string_lossy().into_owned());
    folders.collect()
}

/// Reads the derivation files of a folder, by their paths in it.
#[derive(PartialEq)]
struct Files(BTreeMap<PathBuf, Vec<u8>>);

impl Files {
    fn new(folder: &Path) -> Self {
        let mut files = BTreeMap::new();
        let inside = |path: &Path| fs::read_dir(path).into_iter().flatten().flatten();
        for paper in inside(folder).filter(|entry| entry.path().is_dir()) {
            for file in inside(&paper.path()) {
                let path = file.path();
                let is_data = path.extension().is_some_and(|ending| ending == "toml");
                // A file that is being replaced may be missing for a moment: the next poll finds it.
                if let (true, Ok(content)) = (is_data, fs::read(&path)) {
                    let name = Path::new(&paper.file_name()).join(file.file_name());
                    files.insert(name, content);
                }
            }
        }
        Self(files)
    }

    /// Waits until some files changed and are stable; new and removed files count too.
    fn next_change(&mut self, folder: &Path) -> Vec<PathBuf> {
        loop {
            std::thread::sleep(PAUSE);
            let mut now = Self::new(folder);
            if now == *self {
                continue;
            }
            loop {
                std::thread::sleep(PAUSE);
                let later = Self::new(folder);
                if later == now {
                    break;
                }
                now = later;
            }
            let names: BTreeSet<&PathBuf> = self.0.keys().chain(now.0.keys()).collect();
            let differs = |name: &&&PathBuf| self.0.get(**name) != now.0.get(**name);
            let changed: Vec<PathBuf> =
                names.iter().filter(differs).map(|n| (*n).clone()).collect();
            *self = now;
            // Changed and changed back.
            if !changed.is_empty() {
                return changed;
            }
        }
    }
}
