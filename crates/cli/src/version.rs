//! The version of the command, and what tells two builds apart.

use sha2::{Digest as _, Sha256};
use std::fs::File;
use std::io;

/// The version, and the commit that it was built from where that is known.
pub const VERSION: &str = concat!(env!("CARGO_PKG_VERSION"), env!("TORSE_COMMIT"));

/// The SHA-256 of the program itself, where the commit does not say what it was built from: its sources were changed, or came
/// out of an archive.
///
/// # Errors
/// Where the program cannot be read.
pub fn program() -> io::Result<Option<String>> {
    match env!("TORSE_COMMIT_SAYS_ALL") {
        "true" => Ok(None),
        _ => digest_of(File::open(std::env::current_exe()?)?).map(Some),
    }
}

/// The SHA-256 of a file, as hexadecimal digits.
fn digest_of(mut file: impl io::Read) -> io::Result<String> {
    let mut digest = Sha256::new();
    let mut piece = vec![0; 1 << 16];
    loop {
        match file.read(&mut piece)? {
            0 => break,
            read => digest.update(piece.get(..read).unwrap_or_default()),
        }
    }
    let digits = |byte: &u8| format!("{byte:02x}");
    Ok(digest.finalize().iter().map(digits).collect())
}
