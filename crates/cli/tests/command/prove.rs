//! `torse prove`: what it writes, and how it ends where something is missing.

use crate::support::{claim, mini, torse};
use std::fs;
use std::process::Command;

/// A folder with one claim.
fn square() -> tempfile::TempDir {
    mini(&claim("a", "(x + 1)^2 == x^2 + 2*x + 1", ""))
}

/// Runs `torse prove` on a folder of derivations, with these programs on the path.
fn prove(
    derivations: &tempfile::TempDir,
    out: &str,
    path: Option<&str>,
    more: &[&str],
) -> (Option<i32>, String, String) {
    let mut command = Command::new(env!("CARGO_BIN_EXE_torse"));
    command
        .arg("prove")
        .arg("--derivations")
        .arg(derivations.path())
        .arg("--out")
        .arg(out)
        .args(more);
    if let Some(path) = path {
        command.env("PATH", path);
    }
    let output = command.output().unwrap();
    let text = |bytes| String::from_utf8(bytes).unwrap();
    (
        output.status.code(),
        text(output.stdout),
        text(output.stderr),
    )
}

fn has_coqc() -> bool {
    let found = Command::new("coqc").arg("--version").output().is_ok();
    if !found {
        eprintln!("notice: coqc is not installed, the kernel was not asked");
    }
    found
}

#[test]
fn a_missing_coqc_is_told_with_the_way_to_get_it() {
    let (derivations, out) = (square(), tempfile::tempdir().unwrap());
    let folder = out.path().to_str().unwrap();
    let (code, _, err) = prove(&derivations, folder, Some(folder), &["--check"]);
    assert_eq!(code, Some(7), "{err}");
    assert!(
        err.contains("apt-get install coq libcoq-coquelicot"),
        "{err}"
    );
    // Without a check nothing is asked.
    let (code, out, err) = prove(&derivations, folder, Some(folder), &[]);
    assert_eq!(code, Some(0), "{out}{err}");
}

#[test]
fn a_folder_that_cannot_be_written_is_told() {
    let (derivations, out) = (square(), tempfile::tempdir().unwrap());
    let file = out.path().join("file");
    fs::write(&file, "mine").unwrap();
    let (code, _, err) = prove(&derivations, file.to_str().unwrap(), None, &[]);
    assert_eq!(code, Some(5), "{err}");
    assert_eq!(fs::read_to_string(&file).unwrap(), "mine");
}

#[test]
fn a_list_of_unproved_theorems_that_is_none_is_refused() {
    let (derivations, out) = (square(), tempfile::tempdir().unwrap());
    fs::write(out.path().join("unproved.json"), "{").unwrap();
    let (code, _, err) = prove(&derivations, out.path().to_str().unwrap(), None, &[]);
    assert_eq!(code, Some(4), "{err}");
}

#[test]
fn foreign_files_stay_and_the_same_run_writes_the_same_bytes() {
    let (derivations, out) = (square(), tempfile::tempdir().unwrap());
    let folder = out.path().to_str().unwrap();
    fs::write(out.path().join("notes.txt"), "mine").unwrap();
    let statements = out.path().join("Mini/A.v");
    let written = || {
        let (code, _, err) = prove(&derivations, folder, None, &[]);
        assert_eq!(code, Some(0), "{err}");
        let papers = fs::read_dir(out.path())
            .unwrap()
            .flatten()
            .filter(|e| e.path().is_dir());
        let files = papers.flat_map(|e| fs::read_dir(e.path()).unwrap().flatten());
        let mut texts: Vec<_> = files
            .map(|e| (e.path(), fs::read(e.path()).unwrap()))
            .collect();
        texts.sort();
        texts
    };
    let first = written();
    assert!(
        first
            .iter()
            .any(|(path, _)| path.to_string_lossy().ends_with("_proofs.v")),
        "{statements:?}"
    );
    assert_eq!(first, written());
    assert_eq!(
        fs::read_to_string(out.path().join("notes.txt")).unwrap(),
        "mine"
    );
}

#[cfg(unix)]
#[test]
fn a_stale_list_of_accepted_theorems_is_told_and_written_anew() {
    let bin = stand_in(ACCEPTS);
    let path = with(&bin);
    let (derivations, out) = (square(), tempfile::tempdir().unwrap());
    let folder = out.path().to_str().unwrap();
    let accepted = out.path().join("accepted.json");
    fs::write(
        &accepted,
        "{\"coq\": \"0\", \"axioms\": [], \"theorems\": {}}",
    )
    .unwrap();
    let (code, said, err) = prove(&derivations, folder, Some(&path), &["--check"]);
    assert_eq!(code, Some(0), "{said}{err}");
    assert!(
        said.contains("1 accepted, 0 rejected") && said.contains("was stale"),
        "{said}"
    );
    let (_, said, _) = prove(&derivations, folder, Some(&path), &["--check"]);
    assert!(said.contains("accepted.json agrees"), "{said}");
}

#[test]
fn a_run_for_one_claim_keeps_what_the_folder_has_of_the_others() {
    let two = claim("a", "(x + 1)^2 == x^2 + 2*x + 1", "") + &claim("b", "x + x == 2*x", "");
    let (derivations, out) = (mini(&two), tempfile::tempdir().unwrap());
    let folder = out.path().to_str().unwrap();
    let written = || {
        let paths = [
            "Check.v",
            "_CoqProject",
            "not-stated.json",
            "not-printed.json",
        ]
        .map(|path| out.path().join(path));
        let sections = fs::read_dir(out.path().join("Mini")).unwrap().flatten();
        let mut paths: Vec<_> = paths
            .into_iter()
            .chain(sections.map(|e| e.path()))
            .collect();
        paths.sort();
        let text = |path: &std::path::PathBuf| fs::read_to_string(path).unwrap();
        paths
            .iter()
            .map(|path| (path.clone(), text(path)))
            .collect::<Vec<_>>()
    };
    let (code, _, err) = prove(&derivations, folder, None, &[]);
    assert_eq!(code, Some(0), "{err}");
    let all = written();
    let (code, _, err) = prove(&derivations, folder, None, &["mini/b"]);
    assert_eq!(code, Some(0), "{err}");
    assert_eq!(written(), all);
}

#[test]
fn the_commands_of_the_page_about_proofs_compile_them() {
    if !has_coqc() {
        return;
    }
    let (derivations, out) = (square(), tempfile::tempdir().unwrap());
    let folder = out.path().to_str().unwrap();
    let (code, _, err) = prove(&derivations, folder, None, &[]);
    assert_eq!(code, Some(0), "{err}");
    let run = |program: &str, arguments: &[&str]| {
        let mut command = Command::new(program);
        command.args(arguments).current_dir(out.path());
        let done = command.output().unwrap();
        let said = String::from_utf8_lossy(&done.stderr).into_owned();
        assert!(done.status.success(), "{program} {arguments:?}: {said}");
        said
    };
    let said = run("coq_makefile", &["-f", "_CoqProject", "-o", "Makefile"]);
    // Else each folder has two names, and no file finds another.
    assert!(!said.contains("overlap"), "{said}");
    // A file of the library that rests on another, and the statements: the proofs take what `--check` takes.
    run("make", &["Torse/Series.vo", "Mini/Section_1.vo"]);
}

#[test]
fn what_is_no_longer_stated_is_removed_and_what_others_wrote_stays() {
    let one = claim("a", "(x + 1)^2 == x^2 + 2*x + 1", "");
    let other = claim("b", "x + x == 2*x", "").replace("Sect. 1", "Sect. 2");
    let out = tempfile::tempdir().unwrap();
    let folder = out.path().join("proofs");
    let written = |claims: &str| {
        let (code, _, err) = prove(&mini(claims), folder.to_str().unwrap(), None, &[]);
        assert_eq!(code, Some(0), "{err}");
        let all = fs::read_dir(folder.join("Mini")).unwrap().flatten();
        let mut names: Vec<String> = all.map(|e| e.file_name().into_string().unwrap()).collect();
        names.sort();
        names
    };
    let files = |n: u8| {
        let ends = ["", "_printed", "_printed_proofs", "_proofs"];
        ends.map(|end| format!("Section_{n}{end}.v"))
    };
    let (first, second) = (files(1), files(2));
    let list = ["Theorems.v".to_owned()];
    let both = [&first[..], &second, &list].concat();
    assert_eq!(written(&(one.clone() + &other)), both);
    // A list of files that somebody edited names what is not ours.
    let beside = out.path().join("beside.v");
    let project = folder.join("_CoqProject");
    let listed = fs::read_to_string(&project).unwrap() + "../beside.v\n";
    fs::write(&project, listed).unwrap();
    fs::write(&beside, "mine").unwrap();
    fs::write(folder.join("Mini/Mine.v"), "mine").unwrap();
    let mine = ["Mine.v".to_owned()];
    assert_eq!(written(&one), [&mine[..], &first, &list].concat());
    assert_eq!(fs::read_to_string(beside).unwrap(), "mine");
}

/// Runs `torse verify --format json` with this folder of proofs.
fn verified(derivations: &tempfile::TempDir, proofs: &str) -> String {
    let path = derivations.path().to_str().unwrap();
    let ran = torse(&[
        "verify",
        "--format",
        "json",
        "--derivations",
        path,
        "--kernel",
        proofs,
    ]);
    assert_eq!(ran.code, Some(0), "{}", ran.err);
    ran.out
}

#[cfg(unix)]
#[test]
fn the_level_kernel_is_shown_from_the_kept_answers_while_they_fit() {
    let bin = stand_in(ACCEPTS);
    let (derivations, out) = (square(), tempfile::tempdir().unwrap());
    let folder = out.path().to_str().unwrap();
    let level = "\"kernel\": \"accepted\"";
    assert!(!verified(&derivations, folder).contains(level));
    let (code, said, err) = prove(&derivations, folder, Some(&with(&bin)), &["--check"]);
    assert_eq!(code, Some(0), "{said}{err}");
    assert!(verified(&derivations, folder).contains(level));
    let explained = |derivations: &tempfile::TempDir| {
        let path = derivations.path().to_str().unwrap().to_owned();
        torse(&[
            "explain",
            "mini/a",
            "--derivations",
            &path,
            "--kernel",
            folder,
        ])
        .out
    };
    assert!(explained(&derivations).contains("kernel"));
    // Another statement under the same id: what was accepted is not this.
    let other = mini(&claim("a", "(x + 2)^2 == x^2 + 4*x + 4", ""));
    assert!(!verified(&other, folder).contains(level));
    assert!(!explained(&other).contains("kernel"));
    // Another digest: what was accepted is not known.
    let accepted = out.path().join("accepted.json");
    let text = fs::read_to_string(&accepted).unwrap();
    let stale = text.replacen("8.16", "8.17", 1);
    assert_ne!(stale, text);
    fs::write(&accepted, stale).unwrap();
    assert!(!verified(&derivations, folder).contains(level));
    fs::write(&accepted, "no json").unwrap();
    assert!(!verified(&derivations, folder).contains(level));
}

/// What coqc says where it accepts everything.
#[cfg(unix)]
const ACCEPTS: &str = "*) ;;";

/// A path on which this folder of programs comes first.
#[cfg(unix)]
fn with(bin: &tempfile::TempDir) -> String {
    format!("{}:/usr/bin:/bin", bin.path().display())
}

/// A folder with a program called coqc that says what it is told to.
#[cfg(unix)]
fn stand_in(answer: &str) -> tempfile::TempDir {
    use std::os::unix::fs::PermissionsExt;
    let bin = tempfile::tempdir().unwrap();
    let program = bin.path().join("coqc");
    let script =
        format!("#!/bin/sh\ncase \"$*\" in --print-version) echo 8.16.1;; {answer} esac\n");
    fs::write(&program, script).unwrap();
    fs::set_permissions(&program, fs::Permissions::from_mode(0o755)).unwrap();
    bin
}

/// A coqtop that accepts all that it reads.
#[cfg(unix)]
const SAYS_ALL: &str = r"sed -n 's/^Check \(.*\)\.$/\1\n     : nat/p'";

/// Puts a program called coqtop beside coqc, with this script.
#[cfg(unix)]
fn stand_in_top(bin: &tempfile::TempDir, script: &str) {
    use std::os::unix::fs::PermissionsExt;
    let program = bin.path().join("coqtop");
    fs::write(&program, format!("#!/bin/sh\n{script}\n")).unwrap();
    fs::set_permissions(&program, fs::Permissions::from_mode(0o755)).unwrap();
}

#[cfg(unix)]
#[test]
fn a_proof_that_the_kernel_rejects_contradicts_the_verdict() {
    let (derivations, out) = (square(), tempfile::tempdir().unwrap());
    let bin = stand_in(
        "*_proofs.v) echo 'File \"S.v\", line 8, characters 0-1:\nError: no.'; exit 1;; *) ;;",
    );
    let path = with(&bin);
    let folder = out.path().to_str().unwrap();
    let (code, said, err) = prove(&derivations, folder, Some(&path), &["--check"]);
    assert_eq!(code, Some(6), "{said}{err}");
    assert!(
        said.contains("rejected: mini/a") && said.contains("Error: no."),
        "{said}"
    );
    let kept = fs::read_to_string(out.path().join("accepted.json")).unwrap();
    assert!(kept.contains("\"theorems\": {}"), "{kept}");
}

#[cfg(unix)]
#[test]
fn a_check_of_what_changed_asks_for_changed_theorems_and_keeps_the_other_answers() {
    let one = claim("a", "(x + 1)^2 == x^2 + 2*x + 1", "");
    let other = |states| claim("b", states, "").replace("Sect. 1", "Sect. 2");
    let out = tempfile::tempdir().unwrap();
    let folder = out.path().to_str().unwrap();
    let bin = stand_in(ACCEPTS);
    stand_in_top(&bin, SAYS_ALL);
    let path = with(&bin);
    let checked = |claims: &str, options: &[&str]| {
        let (code, said, err) = prove(&mini(claims), folder, Some(&path), options);
        assert_eq!(code, Some(0), "{said}{err}");
        let kept = fs::read_to_string(out.path().join("accepted.json")).unwrap();
        (said, kept)
    };
    let before = one.clone() + &other("x + x == 2*x");
    let changed = one + &other("x + x + x == 3*x");
    let (said, first) = checked(&before, &["--check"]);
    assert!(said.contains("2 accepted"), "{said}");
    let (said, kept) = checked(&before, &["--check", "--changed"]);
    assert!(said.contains("all was accepted as it stands"), "{said}");
    assert_eq!(kept, first);
    let (said, kept) = checked(&changed, &["--check", "--changed"]);
    assert!(said.contains("Section_2: Coq 8.16.1: 1 accepted"), "{said}");
    assert!(
        said.contains("1 accepted as printed, 0 rejected, 0 not reached"),
        "{said}"
    );
    let (_, whole) = checked(&changed, &["--check"]);
    assert_eq!(kept, whole);
    assert_ne!(kept, first);
}

#[cfg(unix)]
#[test]
fn what_is_printed_is_asked_about_beside_what_was_accepted() {
    let (derivations, out) = (square(), tempfile::tempdir().unwrap());
    let folder = out.path().to_str().unwrap();
    let bin = stand_in(ACCEPTS);
    let path = with(&bin);
    let file = out.path().join("accepted.json");
    let (_, said, _) = prove(&derivations, folder, Some(&path), &["--check"]);
    let first = fs::read_to_string(&file).unwrap();
    assert!(said.contains("1 accepted as printed"), "{said}");
    // As if nobody had asked about what is printed.
    let mut kept: serde_json::Value = serde_json::from_str(&first).unwrap();
    let theorems = kept["theorems"].as_object_mut().unwrap();
    theorems.retain(|name, _| !name.contains("_printed."));
    assert_eq!(theorems.len(), 1);
    let kept = serde_json::to_string_pretty(&kept).unwrap();
    let coqtop = |script: &str| {
        stand_in_top(&bin, script);
        fs::write(&file, &kept).unwrap();
        prove(&derivations, folder, Some(&path), &["--check", "--changed"])
    };
    let (code, said, err) = coqtop(SAYS_ALL);
    assert_eq!(code, Some(0), "{said}{err}");
    assert!(said.contains("1 accepted as printed, 0 rejected"), "{said}");
    assert_eq!(fs::read_to_string(&file).unwrap(), first);
    let (code, said, _) = coqtop("cat >/dev/null");
    assert_eq!(code, Some(6), "{said}");
    assert!(said.contains("rejected: mini/a"), "{said}");
    let text = fs::read_to_string(&file).unwrap();
    assert!(!text.contains("_printed."), "{text}");
}

#[cfg(unix)]
#[test]
fn a_coqc_that_is_killed_is_told_and_nothing_is_kept() {
    let (derivations, out) = (square(), tempfile::tempdir().unwrap());
    let bin = stand_in("*) kill -9 $$;;");
    let path = with(&bin);
    let folder = out.path().to_str().unwrap();
    let (code, said, err) = prove(&derivations, folder, Some(&path), &["--check"]);
    assert!(code.is_some_and(|code| code != 0), "{said}{err}");
    assert!(err.contains("the library is not accepted"), "{err}");
    assert!(!out.path().join("accepted.json").exists());
}

/// The files of a folder, with what is in them.
#[cfg(unix)]
fn contents(folder: &std::path::Path) -> std::collections::BTreeMap<std::path::PathBuf, Vec<u8>> {
    let mut found = std::collections::BTreeMap::new();
    for entry in fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        match path.is_dir() {
            true => found.extend(contents(&path)),
            false => {
                found.insert(path.clone(), fs::read(&path).unwrap());
            }
        }
    }
    found
}

#[cfg(unix)]
#[test]
fn an_interrupted_check_leaves_the_folder_as_it_was() {
    let (derivations, out) = (square(), tempfile::tempdir().unwrap());
    let folder = out.path().to_str().unwrap();
    let (code, _, err) = prove(&derivations, folder, None, &[]);
    assert_eq!(code, Some(0), "{err}");
    fs::write(out.path().join("accepted.json"), "those of before").unwrap();
    let before = contents(out.path());
    // Where coqc is asked for the first file, the run gets what Ctrl-C sends; a shell may have had that ignored in the
    // background, then what `kill` sends.
    let bin = stand_in("*) kill -INT $PPID; kill -TERM $PPID; sleep 1;;");
    let path = with(&bin);
    let (code, said, err) = prove(&derivations, folder, Some(&path), &["--check"]);
    assert_ne!(code, Some(0), "{said}{err}");
    assert!(!said.contains("accepted"), "{said}");
    assert_eq!(contents(out.path()), before);
}

#[test]
fn the_help_says_how_to_get_coqc() {
    let ran = torse(&["prove", "--help"]);
    assert_eq!(ran.code, Some(0));
    assert!(ran.out.contains("apt-get install coq"), "{}", ran.out);
}
