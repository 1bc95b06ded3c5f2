//! What the threads of the server tell one another.

use super::frames::Frame;
use std::collections::{BTreeMap, BTreeSet};
use std::io;
use std::path::PathBuf;
use std::sync::Arc;
use std::sync::atomic::AtomicBool;
use torse::editing::{EditedFolder, KnownFindings};

/// What the server waits for.
pub enum Event {
    /// What was read from the editor: a frame, the end, or why neither.
    Frame(Result<Option<Frame>, io::Error>),
    /// The worker has read a folder.
    Read(FolderRead),
    /// The worker has decided a claim of a folder.
    Decided(PathBuf),
}

/// A folder of derivations that is to be read and decided.
pub struct FolderJob {
    /// The folder.
    pub derivations: PathBuf,
    /// The papers of which a text is open.
    pub papers: BTreeSet<String>,
    /// The open texts.
    pub unsaved: BTreeMap<String, String>,
    /// What is known of its claims.
    pub known: Arc<KnownFindings>,
}

/// Everything that is open, to be read and decided.
pub struct Job {
    /// The folders.
    pub folders: Vec<FolderJob>,
    /// Whether the job is to end, since there is a newer one.
    pub stop: Arc<AtomicBool>,
}

/// What the worker tells of a folder.
pub struct FolderRead {
    /// The folder.
    pub derivations: PathBuf,
    /// What was read, or why nothing was.
    pub read: Result<Arc<EditedFolder>, torse::Error>,
}
