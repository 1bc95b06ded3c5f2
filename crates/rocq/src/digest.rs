//! SHA-256 (FIPS 180-4): fingerprints of statements and proofs.

use sha2::{Digest as _, Sha256};

/// Digests parts, each with its length before it.
#[derive(Debug, Clone, Default)]
pub struct Digest(Sha256);

impl Digest {
    /// Digests these parts and one more.
    #[must_use]
    pub fn and(mut self, part: &str) -> Self {
        self.0.update((part.len() as u64).to_be_bytes());
        self.0.update(part.as_bytes());
        self
    }

    /// Writes it as hexadecimal digits.
    #[must_use]
    pub fn hexadecimal(self) -> String {
        let digits = |byte: &u8| format!("{byte:02x}");
        self.0.finalize().iter().map(digits).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_digests_are_those_of_the_standard() {
        let hex = |text: &str| Digest(Sha256::new().chain_update(text)).hexadecimal();
        assert_eq!(
            hex("abc"),
            "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad"
        );
        assert_eq!(
            hex("abcdbcdecdefdefgefghfghighijhijkijkljklmklmnlmnomnopnopq"),
            "248d6a61d20638b8e5c026930c3e6039a33ce45964ff2167f6ecedd419db06c1"
        );
    }

    #[test]
    fn parts_are_told_apart() {
        let of = |a, b| Digest::default().and(a).and(b).hexadecimal();
        assert_ne!(of("ab", "c"), of("a", "bc"));
    }
}
