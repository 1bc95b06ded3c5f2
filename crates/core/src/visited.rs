//! The terms that a walk has been at, so that shared parts are visited once.

use super::Term;
use std::collections::HashSet;
use std::hash::{BuildHasherDefault, Hasher};
use std::sync::Arc;

/// Terms by their addresses.
#[derive(Default)]
pub struct Visited(HashSet<usize, BuildHasherDefault<Address>>);

impl Visited {
    /// Whether the walk was not at this term before. It is now.
    pub fn is_new(&mut self, term: &Term) -> bool {
        self.0.insert(Arc::as_ptr(&term.node).addr())
    }
}

/// The hash of an address: nobody chooses addresses to collide, so one product spreads them well enough.
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
        // Two to the 64 over the golden ratio (Fibonacci hashing); the upper bits are the best mixed ones.
        let mixed = (self.0 ^ address as u64).wrapping_mul(0x9e37_79b9_7f4a_7c15);
        self.0 = mixed.rotate_left(32);
    }
}
