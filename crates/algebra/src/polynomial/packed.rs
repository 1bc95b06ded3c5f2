//! Rows of exponents packed into words, or as they are.

/// A row of exponents in a form that is compared and added as a whole: the order of the packed forms is the order of
/// the rows, and their sum is the packed sum.
pub(super) trait Row: Ord + Clone {
    /// Packs the row `exponents`; `widths` are the bits of the columns.
    fn pack(exponents: &[u16], widths: &[u32]) -> Self;
    /// Appends the exponents to `into`.
    fn unpack(&self, widths: &[u32], into: &mut Vec<u16>);
    /// The row of the product of two monomials.
    fn plus(&self, other: &Self) -> Self;
    /// A hash whose upper half depends on the whole row.
    fn hash(&self) -> u64;
}

/// Rows that can be subtracted.
pub(super) trait Difference: Row {
    /// The highest bit of each column, for [`Difference::less`].
    fn guards(widths: &[u32]) -> Self;
    /// The difference `self - other`, or `None` if an exponent would be negative. In both rows the highest bit of
    /// each column must be zero; `guards` are these bits.
    fn less(&self, other: &Self, guards: &Self) -> Option<Self>;
}

/// An odd number with irregular bits: 2^64 divided by the golden ratio.
const SPREAD: u64 = 0x9E37_79B9_7F4A_7C15;

/// The upper half of the product with [`SPREAD`], combined with the lower half by exclusive or.
fn spread(word: u64) -> u64 {
    let (low, high) = word.carrying_mul(SPREAD, 0);
    low ^ high
}

/// The number of bits of each column, given its highest exponent.
pub(super) fn widths(highest: &[u16]) -> Vec<u32> {
    highest
        .iter()
        .map(|top| u16::BITS - top.leading_zeros())
        .collect()
}

macro_rules! packed {
    ($word:ty, $hash:expr) => {
        impl Row for $word {
            fn pack(exponents: &[u16], widths: &[u32]) -> Self {
                exponents
                    .iter()
                    .zip(widths)
                    .fold(0, |word, (exponent, width)| {
                        (word << width) | <$word>::from(*exponent)
                    })
            }

            fn unpack(&self, widths: &[u32], into: &mut Vec<u16>) {
                let start = into.len();
                into.resize(start + widths.len(), 0);
                let mut remaining = *self;
                for (slot, width) in into.iter_mut().skip(start).zip(widths).rev() {
                    // A column has at most 16 bits, so the cast is exact.
                    *slot = (remaining & ((1 << width) - 1)) as u16;
                    remaining >>= width;
                }
            }

            fn hash(&self) -> u64 {
                $hash(*self)
            }

            fn plus(&self, other: &Self) -> Self {
                self + other
            }
        }

        impl Difference for $word {
            fn guards(widths: &[u32]) -> Self {
                widths
                    .iter()
                    .fold(0, |word, width| (word << width) | (1 << (width - 1)))
            }

            fn less(&self, other: &Self, guards: &Self) -> Option<Self> {
                // With the guard bit set no column borrows from the next one. The guard bit remains set exactly if
                // the exponent is at least the other one.
                let difference = (self | guards) - other;
                (difference & guards == *guards).then_some(difference & !guards)
            }
        }
    };
}
packed!(u64, spread);
packed!(u128, |row: u128| spread(
    spread((row >> u64::BITS) as u64) ^ row as u64
));

impl Row for Box<[u16]> {
    fn pack(exponents: &[u16], _: &[u32]) -> Self {
        exponents.into()
    }

    fn unpack(&self, _: &[u32], into: &mut Vec<u16>) {
        into.extend_from_slice(self);
    }

    fn hash(&self) -> u64 {
        self.iter()
            .fold(0, |hash, exponent| spread(hash ^ u64::from(*exponent)))
    }

    fn plus(&self, other: &Self) -> Self {
        self.iter().zip(other).map(|(x, y)| x + y).collect()
    }
}

impl Difference for Box<[u16]> {
    fn guards(_: &[u32]) -> Self {
        Self::default()
    }

    fn less(&self, other: &Self, _: &Self) -> Option<Self> {
        self.iter()
            .zip(other)
            .map(|(x, y)| x.checked_sub(*y))
            .collect()
    }
}
