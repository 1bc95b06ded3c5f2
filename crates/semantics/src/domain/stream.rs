//! A source of choices without state: each is a function of the seed, the number of the attempt and a label.

/// The choices of one attempt.
#[derive(Debug, Clone)]
pub(crate) struct Stream {
    start: u64,
    /// The number of the attempt.
    pub attempt: u64,
    /// Whether numbers are mostly taken from the edges of their sets: closed ends, and zero.
    pub edges: bool,
}

/// The hash of Fowler, Noll and Vo (FNV-1a, 64 bits).
fn hashed(start: u64, bytes: &[u8]) -> u64 {
    let step = |hash: u64, byte: &u8| (hash ^ u64::from(*byte)).wrapping_mul(0x0100_0000_01b3);
    bytes.iter().fold(start, step)
}

/// The finisher of `SplitMix64`, which spreads every bit of its argument over all bits.
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
        }
    }

    /// The same choices, of which many are at the edges of the declared sets: there conditions fail.
    pub fn at_edges(self) -> Self {
        Self {
            edges: true,
            ..self
        }
    }

    /// A choice from 0 to `count - 1`; 0 if there is nothing to choose from.
    pub fn below(&self, label: &str, count: i64) -> i64 {
        let Ok(modulus @ 1..) = u64::try_from(count) else {
            return 0;
        };
        let choice = mixed(hashed(self.start, label.as_bytes())) % modulus;
        i64::try_from(choice).unwrap_or(0)
    }
}
