//! The set of visited terms, so that a traversal visits shared parts once.

use super::Term;
use std::collections::HashSet;
use std::hash::{BuildHasherDefault, Hasher};
use std::sync::Arc;

/// A set of terms, identified by address.
#[derive(Default)]
pub struct Visited(HashSet<usize, BuildHasherDefault<Address>>);

impl Visited {
    /// Adds a term; returns whether it was not in the set before.
    pub fn is_new(&mut self, term: &Term) -> bool {
        self.0.insert(Arc::as_ptr(&term.node).addr())
    }
}

/// A hash of addresses. Addresses are not chosen by an adversary, so one multiplication spreads them well enough.
#[derive(Default)]
struct Address(u64);

impl Hasher for Address {
    fn finish(&self) -> u64 {
        self.0
    }

    fn write(&mut self, bytes: &[u8]) {
        for byte in bytes {
            self.write_usize(usize::from(*byte));
        }
    }

    fn write_usize(&mut self, address: usize) {
        // Fibonacci hashing: multiply by 2^64 divided by the golden ratio. The upper bits are mixed best.
        let mixed = (self.0 ^ address as u64).wrapping_mul(0x9e37_79b9_7f4a_7c15);
        self.0 = mixed.rotate_left(32);
    }
}
