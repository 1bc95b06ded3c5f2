//! `torse lsp`: verdicts beside the lines of an editor, by the language server protocol.
//!
//! The editor starts the command and speaks with it over standard input and output. One thread reads messages
//! ([`frames`]), one reads derivation files and decides ([`worker`]), and one answers ([`server`]): it never waits for a
//! decision. What is said of a text comes from [`torse::editing`]; here it is only put into the words of the protocol
//! ([`protocol`]), in which places are lines and UTF-16 units ([`lines`]).

mod documents;
mod frames;
mod lines;
mod messages;
mod protocol;
mod server;
mod worker;

use crate::exit::{Exit, Failure};
use crate::run::Budget;
use crate::watchdog;
use clap::Args;
use messages::Event;
use server::Server;
use std::io::{BufReader, Write};
use std::sync::mpsc;

/// Show verdicts beside the lines of an editor: a language server for derivation files.
///
/// An editor starts this command and speaks with it over standard input and output (docs/editors.md has the settings).
/// Mistakes are shown where they stand, and at each statement its verdict, with the correction where there is one; names
/// show their declarations, and formulas and keys are completed. torse decides again what an edit changes, and answers
/// meanwhile. The exit code is 0 if the editor took its leave, and 1 if it did not.
#[derive(Args)]
#[command(after_help = EXAMPLES)]
pub struct Lsp {
    /// Speak over standard input and output: nothing else is possible, and some editors say so
    #[arg(long)]
    stdio: bool,
    #[command(flatten)]
    budget: Budget,
}

const EXAMPLES: &str = "\
Examples:
  torse lsp                    what an editor runs for files of TOML";

impl Lsp {
    /// Serves until the editor leaves.
    pub fn run(&self) -> Result<Exit, Failure> {
        // An editor is open for days.
        watchdog::finished();
        let (sender, events) = mpsc::channel();
        let frames = sender.clone();
        let reader = std::thread::Builder::new();
        let reading = reader.spawn(move || {
            let mut input = BufReader::new(std::io::stdin());
            loop {
                let frame = frames::read(&mut input);
                let ends = !matches!(frame, Ok(Some(_)));
                if frames.send(Event::Frame(frame)).is_err() || ends {
                    return;
                }
            }
        });
        reading.map_err(Failure::Messages)?;
        let jobs = worker::start(self.budget.units(), sender)?;
        let mut server = Server::new(jobs, |message: &[u8]| {
            let mut output = std::io::stdout().lock();
            output.write_all(message).and_then(|()| output.flush())
        });
        while let Ok(event) = events.recv() {
            server.take(event)?;
            // What has come meanwhile is taken before anything is shown.
            while let Ok(event) = events.try_recv() {
                server.take(event)?;
            }
            server.show()?;
            if let Some(exit) = server.ended() {
                return Ok(exit);
            }
        }
        Ok(Exit::Differs)
    }
}
