//! SHA-256 (FIPS 180-4): fingerprints of manuscripts and of files.

use sha2::{Digest as _, Sha256};

/// Digests parts, each with its length before it, as hexadecimal digits.
///
/// ```
/// use torse_report::digest;
///
/// let parts = |parts: &[&'static str]| digest::digest(parts.iter().map(|part| part.as_bytes()));
/// assert_eq!(parts(&["ab", "c"]).len(), 64);
/// assert_ne!(parts(&["ab", "c"]), parts(&["a", "bc"]));
/// ```
#[must_use]
pub fn digest<'a>(parts: impl IntoIterator<Item = &'a [u8]>) -> String {
    let mut digest = Sha256::new();
    for part in parts {
        digest.update((part.len() as u64).to_be_bytes());
        digest.update(part);
    }
    let digits = |byte: &u8| format!("{byte:02x}");
    digest.finalize().iter().map(digits).collect()
}
