//! A stateless source of random choices: each is a function of the seed, the number of the attempt and a label.

use crate::name::Name;
use torse_numbers::fault_injection::{InjectedFault, injected};

/// The random choices of one attempt.
#[derive(Debug, Clone)]
pub(crate) struct Stream {
    start: u64,
    /// The number of the attempt.
    pub attempt: u64,
    /// Whether many numbers are taken from the edges of their sets: closed bounds, and zero.
    pub edges: bool,
    /// Whether all numbers are.
    pub corner: bool,
    /// The number of groups of numbers with equal values; `None` if all are drawn independently.
    groups: Option<i64>,
}

/// The hash of Fowler, Noll and Vo (FNV-1a, 64 bits).
fn hashed(start: u64, bytes: &[u8]) -> u64 {
    let step = |hash: u64, byte: &u8| (hash ^ u64::from(*byte)).wrapping_mul(0x0100_0000_01b3);
    bytes.iter().fold(start, step)
}

/// The final mixing step of `SplitMix64`: every bit of the argument affects all bits of the result.
fn mixed(mut x: u64) -> u64 {
    x = (x ^ (x >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    x = (x ^ (x >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
    x ^ (x >> 31)
}

impl Stream {
    pub fn new(seed: &str, attempt: u64) -> Self {
        let seeded = hashed(0xcbf2_9ce4_8422_2325, seed.as_bytes());
        Self {
            start: hashed(seeded, &attempt.to_le_bytes()),
            attempt,
            edges: false,
            corner: false,
            groups: None,
        }
    }

    /// The same choices, but all numbers are at the edges of their sets.
    pub fn at_corner(self) -> Self {
        Self {
            edges: true,
            corner: true,
            ..self
        }
    }

    /// The same choices, but many numbers of one kind are equal.
    pub fn with_coincidences(self) -> Self {
        Self {
            groups: Some(2),
            ..self
        }
    }

    /// The label by which a number is drawn. With coincidences, it is the label of the number's group.
    pub fn label(&self, name: &Name) -> String {
        let own = name.to_string();
        let (Some(groups), false) = (self.groups, own.contains('(')) else {
            return own;
        };
        // Vectors coincide in all coordinates.
        let (whole, coordinate) = match name {
            Name::Symbol(_) | Name::Member(_, _, None) => (own, 0),
            Name::Coordinate(name, c) => (name.to_string(), *c),
            Name::Member(name, indices, Some(c)) => (format!("{name}{indices:?}"), *c),
        };
        let group = self.below(&format!("{whole} group"), groups);
        format!("group {group}[{coordinate}]")
    }

    /// The same choices, but many numbers are at the edges of their sets, where conditions tend to fail.
    pub fn at_edges(self) -> Self {
        Self {
            edges: true,
            ..self
        }
    }

    /// A choice from 0 to `count - 1`; 0 if `count` is not positive.
    pub fn below(&self, label: &str, count: i64) -> i64 {
        let Ok(modulus @ 1..) = u64::try_from(count) else {
            return 0;
        };
        if injected(InjectedFault::StreamDegenerate) {
            return 0;
        }
        let choice = mixed(hashed(self.start, label.as_bytes())) % modulus;
        i64::try_from(choice).unwrap_or(0)
    }
}
