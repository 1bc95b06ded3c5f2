//! The program, and folders with the compiled library, which is compiled once for all tests.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use std::sync::OnceLock;
use std::time::Duration;
use tempfile::TempDir;
use torse_rocq::coqc::{AXIOMS, Answer, Coqc, Limits};
use torse_rocq::folder::Folder;
use torse_rocq::printed::PRINTED;

pub const LIMITS: Limits = Limits {
    time: Duration::from_secs(300),
    memory: 4_000_000,
    at_once: 1,
};

pub fn coqc() -> Option<Coqc> {
    let found = Coqc::find().ok();
    if found.is_none() {
        eprintln!("notice: coqc is not installed, the kernel was not asked");
    }
    found
}

/// A folder with the compiled library and nothing else.
pub fn with_library(coqc: &Coqc) -> TempDir {
    static COMPILED: OnceLock<PathBuf> = OnceLock::new();
    let compiled = COMPILED.get_or_init(|| {
        let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("library");
        // What an earlier run left may be another library.
        let _ = std::fs::remove_dir_all(&folder);
        std::fs::create_dir_all(&folder).unwrap();
        let limits = Limits {
            at_once: 2,
            ..LIMITS
        };
        coqc.library(&folder, limits, &|| ()).unwrap();
        folder
    });
    let scratch = tempfile::tempdir().unwrap();
    std::fs::create_dir(scratch.path().join("Torse")).unwrap();
    for entry in std::fs::read_dir(compiled.join("Torse")).unwrap() {
        let path = entry.unwrap().path();
        let name = path.strip_prefix(compiled).unwrap();
        std::fs::copy(&path, scratch.path().join(name)).unwrap();
    }
    scratch
}

/// The kernel accepts so many theorems of a folder, all there are, and each as it is printed, on no other axioms than those of the classical reals; those
/// that they rest on.
pub fn accepts_all(coqc: &Coqc, folder: &Folder, count: usize) -> Vec<String> {
    let scratch = with_library(coqc);
    let (answers, axioms) = coqc.check(folder, scratch.path(), LIMITS, &|| ()).unwrap();
    let wrong: BTreeMap<_, _> = answers
        .iter()
        .filter(|(_, a)| **a != Answer::Accepted)
        .collect();
    assert!(wrong.is_empty(), "{wrong:#?}");
    let printed = |name: &&String| name.contains(&format!("{PRINTED}."));
    assert_eq!(answers.keys().filter(printed).count(), count);
    assert_eq!(answers.len(), 2 * count);
    assert!(
        axioms.iter().all(|a| AXIOMS.contains(&a.as_str())),
        "{axioms:?}"
    );
    axioms
}
