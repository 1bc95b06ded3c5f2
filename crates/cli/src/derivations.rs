//! Finds the derivation files.

use crate::diagnostics::Diagnostics;
use crate::exit::Failure;
use crate::terminal;
use sha2::{Digest as _, Sha256};
use std::path::{Path, PathBuf};
use torse::selection;
use torse_report::Source;
use torse_syntax::derivation;
use torse_syntax::derivation::schema::PaperHead;
use torse_syntax::derivation::{Loaded, OneByOne, Paper};

/// The contents of a folder of derivations.
pub struct LoadedDerivations {
    /// The papers.
    pub papers: Vec<Paper>,
    /// The ids of claims and figures that are wrong, or use something wrong.
    pub left_out: Vec<String>,
    /// The mistakes.
    pub mistakes: Diagnostics,
}

/// The option that names the folder of derivations.
#[derive(clap::Args)]
pub struct Derivations {
    /// Read derivation files from this folder [default: `derivations` here or in the nearest folder above]
    #[arg(long = "derivations", value_name = "DIR")]
    folder: Option<PathBuf>,
}

impl Derivations {
    /// Reads the papers of the folder, in the order of their names, with everything in them that is well formed.
    pub fn load(&self) -> Result<LoadedDerivations, Failure> {
        let mut mistakes = Diagnostics::default();
        let loaded = derivation::load_all(&self.find()?)?;
        let (papers, left_out) = tell_mistakes(loaded, &mut mistakes);
        Ok(LoadedDerivations {
            papers,
            left_out,
            mistakes,
        })
    }

    /// Finds the papers of the folder, to be read one after the other.
    pub fn one_by_one(&self) -> Result<OneByOne, Failure> {
        Ok(OneByOne::find(&self.find()?)?)
    }

    /// Reads the claims that the user names.
    pub fn select(&self, names: &[String]) -> Result<(Vec<Paper>, Diagnostics), Failure> {
        let found = self.load()?;
        let papers = selection::select(found.papers, names, &found.left_out)?;
        Ok((papers, found.mistakes))
    }

    /// Returns the folder for a new paper: the one that is named, or `derivations` here, be it empty, or the one that is found
    /// above; none of them, `derivations` here is made.
    pub fn place(&self) -> Result<PathBuf, Failure> {
        match &self.folder {
            Some(path) if path.exists() => self.find(),
            Some(path) => Ok(path.clone()),
            None if Path::new("derivations").is_dir() => Ok(PathBuf::from("derivations")),
            None => match self.find() {
                Err(Failure::NoDerivations) => Ok(PathBuf::from("derivations")),
                found => found,
            },
        }
    }

    /// Returns the source of a report about a paper of the folder.
    pub fn source(&self, paper: &PaperHead) -> Result<Source, Failure> {
        let folder = self.find()?.join(&paper.id);
        let unread = |path: &Path| {
            let path = path.to_owned();
            move |source| Failure::Unread { path, source }
        };
        let entries = std::fs::read_dir(&folder).map_err(unread(&folder))?;
        let files = entries.flatten().map(|entry| entry.path());
        let mut files: Vec<PathBuf> = files
            .filter(|path| path.extension().is_some_and(|ending| ending == "toml"))
            .collect();
        files.sort();
        let mut digest = Sha256::new();
        for file in &files {
            digest.update(std::fs::read(file).map_err(unread(file))?);
        }
        let digits = |byte: &u8| format!("{byte:02x}");
        let digest: String = digest.finalize().iter().map(digits).collect();
        Ok(Source::new(&paper.id, paper.doi.as_deref(), &digest))
    }

    /// The folder of derivations.
    pub fn find(&self) -> Result<PathBuf, Failure> {
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

/// Adds the mistakes of papers, tells names that look alike, and returns the papers and the ids that are left out.
pub fn tell_mistakes(loaded: Loaded, mistakes: &mut Diagnostics) -> (Vec<Paper>, Vec<String>) {
    loaded
        .errors
        .into_iter()
        .for_each(|error| mistakes.add(error));
    for name in loaded.papers.iter().flat_map(Paper::look_alikes) {
        terminal::remark(&terminal::shown(&name));
    }
    (loaded.papers, loaded.left_out)
}

/// Whether a folder above is a folder of derivations, and does not only have the name.
fn holds_a_paper(folder: &Path) -> bool {
    std::fs::read_dir(folder).is_ok_and(|entries| {
        entries
            .flatten()
            .any(|entry| entry.path().join("paper.toml").is_file())
    })
}
