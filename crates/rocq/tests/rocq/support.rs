//! The program, and folders with the compiled library, which is compiled once for all tests.

use std::path::{Path, PathBuf};
use std::sync::{LazyLock, Once};
use std::time::Duration;
use tempfile::TempDir;
use torse_rocq::coqc::{Coqc, Limits};

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
    static COMPILED: LazyLock<PathBuf> =
        LazyLock::new(|| Path::new(env!("CARGO_TARGET_TMPDIR")).join("library"));
    static ONCE: Once = Once::new();
    ONCE.call_once(|| {
        // What an earlier run left may be another library.
        let _ = std::fs::remove_dir_all(&*COMPILED);
        std::fs::create_dir_all(&*COMPILED).unwrap();
        coqc.library(&COMPILED, LIMITS, &|| ()).unwrap();
    });
    let scratch = tempfile::tempdir().unwrap();
    std::fs::create_dir(scratch.path().join("Torse")).unwrap();
    for entry in std::fs::read_dir(COMPILED.join("Torse")).unwrap() {
        let path = entry.unwrap().path();
        let name = path.strip_prefix(&*COMPILED).unwrap();
        std::fs::copy(&path, scratch.path().join(name)).unwrap();
    }
    scratch
}
