//! The thread that reads derivation files and decides claims, so that the server answers meanwhile.

use super::messages::{Event, FolderRead, Job};
use crate::exit::Failure;
use std::sync::Arc;
use std::sync::atomic::Ordering;
use std::sync::mpsc::{Receiver, Sender, channel};
use torse::editing::EditedFolder;
use torse::{Verifier, WorkBudget};

/// Starts the thread, and returns where it takes jobs. A job makes those before it void.
pub fn start(units: u64, events: Sender<Event>) -> Result<Sender<Job>, Failure> {
    let (sender, jobs) = channel();
    let thread = std::thread::Builder::new().stack_size(crate::STACK);
    let thread = thread.spawn(move || work(WorkBudget::new(units), &jobs, &events));
    thread.map_err(Failure::Messages)?;
    Ok(sender)
}

/// Does jobs until nobody gives any, or nobody listens.
fn work(budget: WorkBudget, jobs: &Receiver<Job>, events: &Sender<Event>) {
    while let Ok(mut job) = jobs.recv() {
        while let Ok(newer) = jobs.try_recv() {
            job = newer;
        }
        if !done(budget, &job, events) {
            return;
        }
    }
}

/// Does a job. Returns whether anybody listens.
fn done(budget: WorkBudget, job: &Job, events: &Sender<Event>) -> bool {
    let mut read = vec![];
    for folder in &job.folders {
        let unsaved = |name: &str| folder.unsaved.get(name).cloned();
        let edited = EditedFolder::read(&folder.derivations, unsaved).map(Arc::new);
        if let Ok(edited) = &edited {
            read.push((folder, Arc::clone(edited)));
        }
        let derivations = folder.derivations.clone();
        let told = events.send(Event::Read(FolderRead {
            derivations,
            read: edited,
        }));
        if told.is_err() {
            return false;
        }
    }
    let verifier = Verifier::new().with_budget(budget).stopped_by(&job.stop);
    for (folder, edited) in read {
        let progress = || {
            // Where nobody listens, the work ends with the job.
            let _ = events.send(Event::Decided(folder.derivations.clone()));
        };
        let decided = edited.decide(&folder.papers, &folder.known, &verifier, &progress);
        if decided.is_ok() && !job.stop.load(Ordering::Relaxed) {
            folder.known.keep_those_of(&edited);
        }
    }
    true
}
