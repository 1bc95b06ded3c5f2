//! Where the derivation files are.

use crate::exit::Failure;
use std::path::{Path, PathBuf};
use torse_language::derivation;
use torse_language::derivation::Paper;

/// The option that names the folder of derivations.
#[derive(clap::Args)]
pub struct Derivations {
    /// The folder of derivation files [default: `derivations` here or in the nearest folder above]
    #[arg(long = "derivations", value_name = "DIR")]
    folder: Option<PathBuf>,
}

impl Derivations {
    /// The papers of the folder, in the order of their names.
    pub fn load(&self) -> Result<Vec<Paper>, Failure> {
        Ok(derivation::load(&self.find()?)?)
    }

    fn find(&self) -> Result<PathBuf, Failure> {
        match &self.folder {
            Some(path) if path.is_dir() => Ok(path.clone()),
            Some(path) => Err(Failure::NotAFolder { path: path.clone() }),
            None => {
                let here = std::env::current_dir().map_err(|_| Failure::NoDerivations)?;
                let nearest = here.ancestors().map(|folder| folder.join("derivations"));
                let mut folders = nearest.filter(|folder| holds_a_paper(folder));
                folders.next().ok_or(Failure::NoDerivations)
            }
        }
    }
}

/// Whether a folder above is a folder of derivations, and not just called like one.
fn holds_a_paper(folder: &Path) -> bool {
    std::fs::read_dir(folder).is_ok_and(|entries| {
        entries
            .flatten()
            .any(|entry| entry.path().join("paper.toml").is_file())
    })
}
