//! `torse new`: a folder of derivation files to start from.

use crate::derivations::Derivations;
use crate::exit::{Exit, Failure};
use crate::terminal;
use clap::Args;
use torse_report::write_file;

/// The files of a new folder; `NAME` stands for its name.
const FILES: [(&str, &str); 2] = [
    ("paper.toml", include_str!("new/paper.toml")),
    ("claims.toml", include_str!("new/claims.toml")),
];

/// Write a folder of derivation files to start from.
///
/// It contains a basis with a shape parameter, two curves, four claims about them and a figure, with comments that say
/// what to change. Existing files are never overwritten.
#[derive(Args)]
#[command(after_help = EXAMPLES)]
pub struct New {
    /// The name of the folder: lower-case letters, digits and hyphens
    #[arg(value_name = "PAPER", value_parser = name)]
    paper: String,
    #[command(flatten)]
    derivations: Derivations,
}

const EXAMPLES: &str = "\
Examples:
  torse new my-paper
  torse new my-paper --derivations my-papers && torse verify my-paper --derivations my-papers";

/// Checks that a name can begin an id and be the name of a report.
fn name(text: &str) -> Result<String, String> {
    let known = |c: char| c.is_ascii_lowercase() || c.is_ascii_digit() || c == '-';
    let hyphen = text.starts_with('-') || text.ends_with('-');
    if text.is_empty() || hyphen || text == "summary" || !text.chars().all(known) {
        return Err("a name is made of small letters, digits and hyphens".to_owned());
    }
    Ok(text.to_owned())
}

impl New {
    /// Writes the files and lists them.
    pub fn run(&self) -> Result<Exit, Failure> {
        let folder = self.derivations.place()?.join(&self.paper);
        if folder.exists() {
            return Err(Failure::Exists { path: folder });
        }
        let mut written = String::new();
        for (file, text) in FILES {
            let path = folder.join(file);
            write_file(&path, text.replace("NAME", &self.paper).as_bytes())?;
            written.push_str(&format!("{}\n", path.display()));
        }
        terminal::print(&written)?;
        Ok(Exit::AsExpected)
    }
}
