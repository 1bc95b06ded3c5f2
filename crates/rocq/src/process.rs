//! Runs a program with limits of time and memory, and keeps what it writes.

use crate::kernel_error::KernelError;
use std::io::{self, Read};
use std::process::{Child, Command, ExitStatus, Stdio};
use std::time::{Duration, Instant};

/// The result of a run.
#[derive(Debug)]
pub struct Run {
    /// How it ended; a run that took too long was killed.
    pub status: ExitStatus,
    /// Whether it was killed.
    pub killed: bool,
    /// Its output.
    pub text: String,
}

/// Makes a command with a limit of memory, which the shell sets.
pub(crate) fn limited(program: &str, kilobytes: u64) -> Command {
    let mut command = Command::new("sh");
    command.args([
        "-c",
        &format!("ulimit -v {kilobytes}; exec nice -n 10 {program} \"$@\""),
        program,
    ]);
    command
}

/// Runs a command until it ends or its time is over.
pub(crate) fn run(command: &mut Command, limit: Duration) -> Result<Run, KernelError> {
    let system = |source| KernelError::System {
        what: "coqc cannot be run".to_owned(),
        source,
    };
    let command = command.stdout(Stdio::piped()).stderr(Stdio::piped());
    let mut child = command.spawn().map_err(system)?;
    let readers = [
        child.stdout.take().map(|pipe| reader(Box::new(pipe))),
        child.stderr.take().map(|pipe| reader(Box::new(pipe))),
    ];
    let (status, killed) = wait(&mut child, limit).map_err(system)?;
    let mut text = String::new();
    for reader in readers.into_iter().flatten() {
        text.push_str(&reader.join().unwrap_or_default());
    }
    if killed {
        text.push_str(&format!("\nError: more than {} s", limit.as_secs()));
    }
    Ok(Run {
        status,
        killed,
        text,
    })
}

fn reader(mut pipe: Box<dyn Read + Send>) -> std::thread::JoinHandle<String> {
    std::thread::spawn(move || {
        let mut bytes = vec![];
        // After an error, the output read so far is shown.
        let _ = pipe.read_to_end(&mut bytes);
        String::from_utf8_lossy(&bytes).into_owned()
    })
}

fn wait(child: &mut Child, limit: Duration) -> io::Result<(ExitStatus, bool)> {
    let start = Instant::now();
    loop {
        if let Some(status) = child.try_wait()? {
            return Ok((status, false));
        }
        if start.elapsed() > limit {
            child.kill()?;
            return Ok((child.wait()?, true));
        }
        std::thread::sleep(Duration::from_millis(20));
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_run_that_takes_too_long_is_ended() {
        let mut command = Command::new("sleep");
        let run = run(command.arg("30"), Duration::from_millis(50)).unwrap();
        assert!(!run.status.success());
        assert!(run.text.contains("more than 0 s"));
    }
}
