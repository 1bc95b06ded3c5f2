//! `torse verify --watch`: a change is seen, decided and told; a mistake does not end it.

use crate::support::{claim, mini};
use std::fs;
use std::io::{BufRead, BufReader, Read};
use std::process::{Child, Command, Stdio};
use std::sync::mpsc::{self, Receiver};
use std::thread;
use std::time::{Duration, Instant};

const PATIENCE: Duration = Duration::from_secs(120);

/// A run that is going on, with the lines that it has written.
struct Watching {
    child: Child,
    lines: Receiver<String>,
}

impl Watching {
    fn start(folder: &std::path::Path) -> Self {
        let mut child = Command::new(env!("CARGO_BIN_EXE_torse"))
            .args(["verify", "--watch", "--derivations"])
            .arg(folder)
            .stdout(Stdio::piped())
            .stderr(Stdio::piped())
            .spawn()
            .unwrap();
        let (sender, lines) = mpsc::channel();
        let out: Box<dyn Read + Send> = Box::new(child.stdout.take().unwrap());
        let err: Box<dyn Read + Send> = Box::new(child.stderr.take().unwrap());
        for output in [out, err] {
            let sender = sender.clone();
            thread::spawn(move || {
                let lines = BufReader::new(output).lines().map_while(Result::ok);
                lines.for_each(|line| drop(sender.send(line)));
            });
        }
        Self { child, lines }
    }

    /// The lines until each of these texts was in one, in any order: output and errors come on ways of their own.
    fn until<const N: usize>(&self, texts: [&str; N]) -> Vec<String> {
        let (mut all, start): (Vec<String>, _) = (vec![], Instant::now());
        let is_told = |all: &[String], text: &str| all.iter().any(|line| line.contains(text));
        while start.elapsed() < PATIENCE {
            if let Ok(line) = self.lines.recv_timeout(Duration::from_secs(1)) {
                all.push(line);
            }
            if texts.iter().all(|text| is_told(&all, text)) {
                return all;
            }
        }
        unreachable!("no lines with {texts:?}: {all:#?}")
    }
}

impl Drop for Watching {
    fn drop(&mut self) {
        let _ = self.child.kill();
        let _ = self.child.wait();
    }
}

#[test]
fn a_changed_file_is_verified_again_and_a_wrong_one_ends_nothing() {
    let one = |states: &str| claim("one", states, "expect = \"holds\"");
    let folder = mini(&one("x - x == 0"));
    let file = folder.path().join("mini/claims.toml");
    let watching = Watching::start(folder.path());
    watching.until(["watching"]);
    fs::write(&file, one("x - x == 1")).unwrap();
    let told = watching.until([
        "changed: mini/claims.toml",
        "1 verdict is not the expected one",
    ]);
    let change = |line: &&String| line.contains("mini/one") && line.contains("misprint");
    let told = told.iter().find(change).unwrap();
    assert!(told.contains("holds (identity)"), "{told}");
    fs::write(&file, one("x -")).unwrap();
    watching.until(["claims.toml:", "(gone)"]);
    fs::write(&file, one("x - x == 0")).unwrap();
    watching.until(["(new)"]);
}

#[test]
fn watching_is_for_readers() {
    let ran = crate::support::torse(&["verify", "--watch", "--format", "json"]);
    assert_eq!(ran.code, Some(2), "{}", ran.err);
}
