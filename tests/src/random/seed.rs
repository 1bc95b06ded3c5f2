//! A stream of numbers from a seed: splitmix64 (Steele, Lea, Flood, 2014), so that a claim is the same on every machine.

use super::number::Q;

/// A stream of numbers.
#[derive(Debug, Clone)]
pub struct Stream(u64);

impl Stream {
    /// The stream of claim `number` of the kind with this place.
    #[must_use]
    pub fn new(seed: u64, kind: u64, number: u64) -> Self {
        let mut stream = Self(seed ^ kind.wrapping_mul(0x9E37_79B9_7F4A_7C15) ^ (number << 20));
        stream.next();
        stream
    }

    fn next(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9E37_79B9_7F4A_7C15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
        z ^ (z >> 31)
    }

    /// A number from 0 to `bound - 1`.
    pub fn below(&mut self, bound: usize) -> usize {
        let bound = u64::try_from(bound.max(1)).unwrap_or(1);
        usize::try_from(self.next() % bound).unwrap_or(0)
    }

    /// True once in so many times.
    pub fn once_in(&mut self, times: usize) -> bool {
        self.below(times) == 0
    }

    /// An integer of a range, both ends included.
    pub fn integer(&mut self, low: i128, high: i128) -> i128 {
        let width = usize::try_from(high - low + 1).unwrap_or(1);
        low + i128::try_from(self.below(width)).unwrap_or(0)
    }

    /// An integer of -high to high that is not zero.
    pub fn nonzero(&mut self, high: i128) -> i128 {
        let size = self.integer(1, high);
        if self.once_in(2) { -size } else { size }
    }

    /// A fraction with a small denominator, not zero.
    pub fn fraction(&mut self) -> Q {
        let below = [1, 1, 2, 3, 4, 5][self.below(6)];
        Q::new(self.nonzero(7), below)
    }

    /// A positive fraction.
    pub fn positive(&mut self) -> Q {
        let q = self.fraction();
        if q < Q::ZERO { -q } else { q }
    }

    /// One of these.
    pub fn pick<T: Clone>(&mut self, list: &[T]) -> T {
        list[self.below(list.len())].clone()
    }

    /// The list in another order.
    pub fn shuffle<T>(&mut self, list: &mut [T]) {
        for last in (1..list.len()).rev() {
            list.swap(last, self.below(last + 1));
        }
    }
}
