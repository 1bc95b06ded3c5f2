//! `-`: standard input or output in place of a file.

use std::path::Path;

/// Whether a path stands for standard input or output.
pub fn is_standard(path: &Path) -> bool {
    path.as_os_str() == "-"
}

/// What a file is called in answers and messages.
pub fn name(path: &Path) -> String {
    match is_standard(path) {
        true => "stdin".to_owned(),
        false => path.display().to_string(),
    }
}
