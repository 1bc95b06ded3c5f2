//! Running the binary, and folders of derivations to run it on.

use std::ffi::OsStr;
use std::io::Write as _;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};
use std::sync::mpsc;
use std::time::{Duration, Instant};
use std::{fs, thread};
use tempfile::TempDir;

/// No run of these tests may take longer, whatever it is fed with.
const PATIENCE: Duration = Duration::from_secs(300);

/// How a run ended.
pub struct Ran {
    pub code: Option<i32>,
    pub out: String,
    pub err: String,
}

/// Runs `torse` with these arguments, in a folder that has no derivations above it.
pub fn torse<S: AsRef<OsStr>>(arguments: &[S]) -> Ran {
    let nowhere = TempDir::new().unwrap();
    torse_in(nowhere.path(), arguments)
}

/// Runs `torse` with these arguments in this folder.
pub fn torse_in<S: AsRef<OsStr>>(folder: &Path, arguments: &[S]) -> Ran {
    let mut command = Command::new(env!("CARGO_BIN_EXE_torse"));
    command.args(arguments).current_dir(folder);
    let (sender, receiver) = mpsc::channel();
    thread::spawn(move || sender.send(command.output()));
    let output = receiver
        .recv_timeout(PATIENCE)
        .expect("it did not end")
        .unwrap();
    Ran {
        code: output.status.code(),
        out: String::from_utf8(output.stdout).unwrap(),
        err: String::from_utf8(output.stderr).unwrap(),
    }
}

/// Runs `torse COMMAND.. --derivations FOLDER`, and the most kilobytes that it held at a time, where the system tells.
pub fn measured(folder: &Path, command: &[&str]) -> (Ran, u64) {
    let (ran, kilobytes, _) = timed(folder, command);
    (ran, kilobytes)
}

/// The same with the time of the processor, in seconds.
pub fn timed(folder: &Path, command: &[&str]) -> (Ran, u64, f64) {
    let mut torse = Command::new(env!("CARGO_BIN_EXE_torse"));
    watched(torse.args(command).arg("--derivations").arg(folder))
}

/// Runs `torse` with these arguments in this folder, with this text as its standard input.
pub fn torse_fed(folder: &Path, input: &str, arguments: &[&str]) -> Ran {
    let mut child = Command::new(env!("CARGO_BIN_EXE_torse"))
        .args(arguments)
        .current_dir(folder)
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .unwrap();
    // Whoever needs no input does not read it.
    let _ = child.stdin.take().unwrap().write_all(input.as_bytes());
    let output = child.wait_with_output().unwrap();
    Ran {
        code: output.status.code(),
        out: String::from_utf8(output.stdout).unwrap(),
        err: String::from_utf8(output.stderr).unwrap(),
    }
}

/// Runs `torse` with these arguments in this folder, measured like [`measured`].
pub fn measured_in(folder: &Path, arguments: &[&str]) -> (Ran, u64) {
    let mut torse = Command::new(env!("CARGO_BIN_EXE_torse"));
    let (ran, kilobytes, _) = watched(torse.args(arguments).current_dir(folder));
    (ran, kilobytes)
}

fn watched(torse: &mut Command) -> (Ran, u64, f64) {
    let child = torse
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .unwrap();
    let status = format!("/proc/{}/status", child.id());
    let times = format!("/proc/{}/stat", child.id());
    let (sender, receiver) = mpsc::channel();
    thread::spawn(move || sender.send(child.wait_with_output()));
    let started = Instant::now();
    let (mut most, mut ticks) = (0, 0);
    let output = loop {
        if let Ok(output) = receiver.recv_timeout(Duration::from_millis(10)) {
            break output.unwrap();
        }
        assert!(started.elapsed() < PATIENCE, "it did not end");
        // The high-water mark is gone with the process: it is read while there is one.
        let text = fs::read_to_string(&status).unwrap_or_default();
        let mark = text.lines().find_map(|line| line.strip_prefix("VmHWM:"));
        let kilobytes = mark.and_then(|rest| rest.trim().strip_suffix(" kB")?.parse().ok());
        most = most.max(kilobytes.unwrap_or(0));
        // Behind the name in brackets the twelfth and the next are user and system time, a hundred ticks a second.
        let text = fs::read_to_string(&times).unwrap_or_default();
        let fields = text.rsplit_once(')').map_or("", |(_, rest)| rest);
        let spent = fields.split_whitespace().skip(11).take(2);
        ticks = ticks.max(spent.filter_map(|field| field.parse::<u32>().ok()).sum());
    };
    let ran = Ran {
        code: output.status.code(),
        out: String::from_utf8(output.stdout).unwrap(),
        err: String::from_utf8(output.stderr).unwrap(),
    };
    (ran, most, f64::from(ticks) / 100.0)
}

/// The derivations of the repository.
pub fn repository() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../../derivations")
}

/// A copy of the repository's derivations to change.
pub fn copy_of_repository() -> TempDir {
    let copy = TempDir::new().unwrap();
    for paper in fs::read_dir(repository()).unwrap().flatten() {
        if paper.path().is_dir() {
            let folder = copy.path().join(paper.file_name());
            fs::create_dir(&folder).unwrap();
            for file in fs::read_dir(paper.path()).unwrap().flatten() {
                fs::copy(file.path(), folder.join(file.file_name())).unwrap();
            }
        }
    }
    copy
}

/// A folder of derivations with one paper `mini` and this file of claims, over a symbol `x` in [0, 1].
pub fn mini(claims: &str) -> TempDir {
    let folder = TempDir::new().unwrap();
    add_paper(folder.path(), "mini", claims);
    folder
}

/// Adds a paper with this id and this file of claims, over a symbol `x` in [0, 1].
pub fn add_paper(folder: &Path, id: &str, claims: &str) {
    let paper = folder.join(id);
    fs::create_dir(&paper).unwrap();
    let head = format!(
        r#"
[paper]
id = "{id}"
title = "A small paper whose title is longer than the hundred columns that a line of the table of verdicts may have"
authors = "N. N."
venue = "Nowhere 1"
claims = ["claims.toml"]

[symbols]
x = {{ in = "[0, 1]" }}
P = {{ family = 3, indices = ["0..3"] }}
"#
    );
    fs::write(paper.join("paper.toml"), head).unwrap();
    fs::write(paper.join("claims.toml"), claims).unwrap();
}

/// A claim `mini/NAME` that states a formula, with further fields.
pub fn claim(name: &str, states: &str, fields: &str) -> String {
    format!(
        "[[claim]]\nid = \"mini/{name}\"\nat = \"Sect. 1, eq. ({name})\"\nkind = \"identity\"\nprinted = \"as printed\"\n\
         states = '{states}'\n{fields}\n"
    )
}

/// Runs `torse COMMAND.. --derivations FOLDER`.
pub fn on(folder: &Path, command: &[&str]) -> Ran {
    let mut arguments: Vec<&OsStr> = command.iter().map(OsStr::new).collect();
    arguments.extend([OsStr::new("--derivations"), folder.as_os_str()]);
    torse(&arguments)
}
