//! Reads the files of a paper's folder: only regular files inside of it, of limited size.

use super::error::{DerivationError, LoadError};
use super::source::{Origin, Source, whole};
use std::io::Read;
use std::path::{Component, Path, PathBuf};
use std::sync::Arc;
use toml::Spanned;

/// The largest size of a file in bytes, about a hundred times that of the largest file of the three papers.
pub const MAX_BYTES: u64 = 4 * 1024 * 1024;

/// Reads a file in the folder `slug` below `folder`.
///
/// # Errors
/// [`LoadError::Unreadable`] for anything but a regular file (opening a pipe would block, and a device may never
/// end), for a link that leads out of the paper's folder, for a file of more than [`MAX_BYTES`] bytes, and for a file
/// that is not UTF-8.
pub fn read(folder: &Path, slug: &str, name: &str) -> Result<Arc<Source>, LoadError> {
    let home = folder.join(slug);
    let path = home.join(name);
    let refused = |reason: String| LoadError::Unreadable {
        path: path.display().to_string(),
        reason,
    };
    let system = |error: std::io::Error| refused(error.to_string());
    let metadata = std::fs::metadata(&path).map_err(system)?;
    if !metadata.is_file() {
        return Err(refused("it is not a regular file".to_owned()));
    }
    let real = |path: &PathBuf| path.canonicalize().map_err(system);
    if !real(&path)?.starts_with(real(&home)?) {
        return Err(refused("it is a link out of the paper's folder".to_owned()));
    }
    let mut bytes = vec![];
    let file = std::fs::File::open(&path).map_err(system)?;
    // The file may have grown since its size was read, so limit the read as well.
    file.take(MAX_BYTES + 1)
        .read_to_end(&mut bytes)
        .map_err(system)?;
    if bytes.len() as u64 > MAX_BYTES {
        let bytes = metadata.len();
        return Err(refused(format!(
            "it has {bytes} bytes; at most {MAX_BYTES} are read"
        )));
    }
    let text = String::from_utf8(bytes).map_err(|error| refused(error.utf8_error().to_string()))?;
    let name = format!("{slug}/{name}");
    Ok(Arc::new(Source::new(name, text)))
}

/// Takes a text for the file of this name.
///
/// # Errors
/// [`LoadError::Unreadable`] for a text of more than [`MAX_BYTES`] bytes.
pub fn unsaved(name: String, text: String) -> Result<Arc<Source>, LoadError> {
    let bytes = text.len() as u64;
    if bytes > MAX_BYTES {
        let reason = format!("it has {bytes} bytes; at most {MAX_BYTES} are read");
        return Err(LoadError::Unreadable { path: name, reason });
    }
    Ok(Arc::new(Source::new(name, text)))
}

/// Fails unless the name of a file with claims stays within the paper's folder, such as `claims.toml` or
/// `part/one.toml`.
pub fn check_name(source: &Arc<Source>, name: &Spanned<String>) -> Result<(), LoadError> {
    let path = Path::new(name.get_ref());
    let inside = |component: Component<'_>| matches!(component, Component::Normal(_));
    let plain = !name.get_ref().contains(['\\', '\0']);
    if plain && path.components().count() > 0 && path.components().all(inside) {
        return Ok(());
    }
    let origin = Origin::from_spanned(source, name);
    let message = format!("`{}` is not a file in the paper's folder", name.get_ref());
    let error = DerivationError::at(&origin, whole(name), message)
        .with_help("`claims` lists files of this folder, such as `claims.toml`");
    Err(LoadError::Derivation(Box::new(error)))
}

/// Whether a word is allowed in file names on every system.
fn is_plain(word: &str) -> bool {
    let letter = |c: char| c.is_ascii_alphanumeric() || c == '-' || c == '_';
    !word.is_empty() && word.chars().all(letter)
}

/// Fails unless the id is `slug/name`, where the name consists of letters, digits, `-`, `_` and `.`, has no point at
/// either end and no two adjacent points. Output files are named after ids.
pub fn check_id(source: &Arc<Source>, id: &Spanned<String>, slug: &str) -> Result<(), LoadError> {
    let name = id.get_ref().strip_prefix(slug);
    let name = name.and_then(|rest| rest.strip_prefix('/'));
    if name.is_some_and(|name| name.split('.').all(is_plain)) {
        return Ok(());
    }
    let message = match name {
        Some(name) => format!("`{name}` cannot be the name of a claim or figure"),
        None => format!("the id `{}` does not begin with `{slug}/`", id.get_ref()),
    };
    let help = format!(
        "an id is `{slug}/` and words of letters, digits, `-` and `_`, with points between: `{slug}/eq-2.1`"
    );
    let error =
        DerivationError::at(&Origin::from_spanned(source, id), whole(id), message).with_help(help);
    Err(LoadError::Derivation(Box::new(error)))
}
