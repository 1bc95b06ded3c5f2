//! The files of the page, which `web/build` makes.

use crate::exit::Failure;
use std::fs;
use std::path::{Path, PathBuf};

/// The folder with the page's files.
pub struct PageFolder(PathBuf);

/// The page as it is served: its policy lets it load from where it comes.
const PAGE: &str = "studio.html";

/// The files, with their types: nothing else of the folder is served.
const FILES: [(&str, &str); 3] = [
    (PAGE, "text/html; charset=utf-8"),
    ("designs.wasm", "application/wasm"),
    ("formulas.wasm", "application/wasm"),
];

impl PageFolder {
    /// Takes the folder that is named, or else the first of those beside the command that has the page: `torse-page`, and
    /// `../web/site`, where a build in the repository puts it.
    pub fn find(named: Option<&Path>) -> Result<Self, Failure> {
        let beside = || {
            let command = std::env::current_exe().and_then(fs::canonicalize).ok();
            let folder = command.as_deref().and_then(Path::parent);
            let places =
                folder.map(|folder| [folder.join("torse-page"), folder.join("../web/site")]);
            places.map(Vec::from).unwrap_or_default()
        };
        let looked = named.map_or_else(beside, |named| vec![named.to_owned()]);
        let found = looked.iter().find(|folder| folder.join(PAGE).is_file());
        match found {
            Some(folder) => Ok(Self(folder.clone())),
            None => Err(Failure::NoPage { looked }),
        }
    }

    /// Returns a file of the page with its type; the empty name is that of the page itself.
    pub fn read(&self, name: &str) -> Option<(Vec<u8>, &'static str)> {
        let name = if name.is_empty() { PAGE } else { name };
        let (file, kind) = FILES.iter().find(|(file, _)| *file == name)?;
        Some((fs::read(self.0.join(file)).ok()?, kind))
    }
}
