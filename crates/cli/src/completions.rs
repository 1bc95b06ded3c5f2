//! `torse completions`: what a shell needs to complete the command.

use crate::exit::{Exit, Failure};
use crate::terminal;
use clap::{Args, Command};
use clap_complete::{Shell, generate};

/// Print the completions for a shell.
#[derive(Args)]
#[command(after_help = EXAMPLES)]
pub struct Completions {
    /// The shell
    #[arg(value_name = "SHELL")]
    shell: Shell,
}

const EXAMPLES: &str = "\
Examples:
  torse completions bash > ~/.local/share/bash-completion/completions/torse
  torse completions fish > ~/.config/fish/completions/torse.fish";

impl Completions {
    /// Writes those of this command.
    pub fn run(&self, mut command: Command) -> Result<Exit, Failure> {
        let mut script = Vec::new();
        generate(self.shell, &mut command, "torse", &mut script);
        terminal::print(&String::from_utf8_lossy(&script))?;
        Ok(Exit::AsExpected)
    }
}
