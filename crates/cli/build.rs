//! Names the commit of the build: that of the repository, or that which an archive of the package was made from, or none.

use std::path::Path;
use std::process::Command;

/// What git says, in the folder of the package.
fn git(arguments: &[&str]) -> Option<String> {
    let output = Command::new("git").args(arguments).output().ok()?;
    let text = String::from_utf8(output.stdout).ok()?;
    output.status.success().then(|| text.trim().to_owned())
}

/// The commit of the repository that has this file; another one above an archive is not meant.
fn repository() -> Option<String> {
    git(&["ls-files", "--error-unmatch", "build.rs"])?;
    for file in ["HEAD", "logs/HEAD"] {
        let path = git(&["rev-parse", "--git-path", file])?;
        if Path::new(&path).exists() {
            println!("cargo::rerun-if-changed={path}");
        }
    }
    let commit = git(&["rev-parse", "--short=12", "HEAD"])?;
    let changed = if is_changed()? { "-dirty" } else { "" };
    Some(format!("{commit}{changed}"))
}

/// Whether sources of the program differ from those of the commit; they are looked at again whenever one of them changes.
fn is_changed() -> Option<bool> {
    let top = git(&["rev-parse", "--show-toplevel"])?;
    let rooms = std::fs::read_dir(Path::new(&top).join("crates")).ok()?;
    let mut rooms: Vec<_> = rooms.flatten().map(|room| room.path()).collect();
    rooms.sort();
    for room in rooms {
        // What is compiled in stands beside the sources, too.
        for part in ["src", "assets", "proofs"].map(|part| room.join(part)) {
            if part.exists() {
                println!("cargo::rerun-if-changed={}", part.display());
            }
        }
    }
    let changed = [
        "-C",
        &top,
        "diff",
        "--name-only",
        "HEAD",
        "--",
        "Cargo.lock",
        ":(glob)crates/*/Cargo.toml",
        ":(glob)crates/*/src/**",
        ":(glob)crates/*/assets/**",
        ":(glob)crates/*/proofs/**",
    ];
    Some(!git(&changed)?.is_empty())
}

/// The commit that cargo writes into an archive.
fn archive() -> Option<String> {
    let text = std::fs::read_to_string(".cargo_vcs_info.json").ok()?;
    let (_, rest) = text.split_once("\"sha1\"")?;
    let commit: String = rest
        .chars()
        .filter(char::is_ascii_hexdigit)
        .take(12)
        .collect();
    (commit.len() == 12).then_some(commit)
}

fn main() {
    println!("cargo::rerun-if-changed=build.rs");
    let (archive, repository) = (archive(), repository());
    // Sources that were taken out of an archive may have been changed since.
    let says_all =
        archive.is_none() && matches!(&repository, Some(commit) if !commit.ends_with("-dirty"));
    let commit = archive.or(repository);
    let shown = commit
        .map(|commit| format!(" ({commit})"))
        .unwrap_or_default();
    println!("cargo::rustc-env=TORSE_COMMIT={shown}");
    println!("cargo::rustc-env=TORSE_COMMIT_SAYS_ALL={says_all}");
}
