//! Integer-affine forms such as `k - 2` or `i + 1`: the indices of control points and the degrees of
//! curves whose degree is a symbol.

use std::collections::BTreeMap;
use std::fmt;
use std::sync::Arc;

/// An integer constant plus integer multiples of integer symbols. No multiple is stored as zero; arithmetic
/// saturates.
///
/// ```
/// use torse_numbers::Affine;
/// let k = Affine::symbol("k");
/// assert_eq!((k.clone() - Affine::number(2)).to_string(), "k-2");
/// assert_eq!((k.clone() - k).as_number(), Some(0));
/// ```
#[derive(Debug, Clone, PartialEq, Eq, PartialOrd, Ord, Hash, Default)]
pub struct Affine {
    multiples: BTreeMap<Arc<str>, i64>,
    constant: i64,
}

impl Affine {
    /// The integer `n`.
    #[must_use]
    pub fn number(n: i64) -> Self {
        Self {
            multiples: BTreeMap::new(),
            constant: n,
        }
    }

    /// The integer symbol `name`.
    #[must_use]
    pub fn symbol(name: &str) -> Self {
        Self {
            multiples: BTreeMap::from([(Arc::from(name), 1)]),
            constant: 0,
        }
    }

    /// The integer, if no symbol occurs.
    #[must_use]
    pub fn as_number(&self) -> Option<i64> {
        self.multiples.is_empty().then_some(self.constant)
    }

    /// The constant part.
    #[must_use]
    pub fn constant(&self) -> i64 {
        self.constant
    }

    /// Returns the multiple of the symbol `name`, zero if the symbol does not occur.
    #[must_use]
    pub fn multiple_of(&self, name: &str) -> i64 {
        self.multiples.get(name).copied().unwrap_or(0)
    }

    /// Iterates over the symbols that occur, in alphabetical order, with their multiples.
    pub fn multiples(&self) -> impl Iterator<Item = (&str, i64)> {
        self.multiples
            .iter()
            .map(|(name, multiple)| (&**name, *multiple))
    }

    /// Replaces the symbol `name` by `value`.
    #[must_use]
    pub fn substituted(&self, name: &str, value: &Affine) -> Self {
        let mut result = self.clone();
        match result.multiples.remove(name) {
            None => result,
            Some(multiple) => result + value.clone() * multiple,
        }
    }
}

impl std::ops::Add for Affine {
    type Output = Self;
    fn add(mut self, other: Self) -> Self {
        for (name, multiple) in other.multiples {
            let entry = self.multiples.entry(Arc::clone(&name)).or_insert(0);
            *entry = entry.saturating_add(multiple);
            if *entry == 0 {
                self.multiples.remove(&name);
            }
        }
        self.constant = self.constant.saturating_add(other.constant);
        self
    }
}

impl std::ops::Mul<i64> for Affine {
    type Output = Self;
    fn mul(mut self, factor: i64) -> Self {
        if factor == 0 {
            return Self::default();
        }
        for multiple in self.multiples.values_mut() {
            *multiple = multiple.saturating_mul(factor);
        }
        self.constant = self.constant.saturating_mul(factor);
        self
    }
}

impl std::ops::Sub for Affine {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        self + other * -1
    }
}

impl fmt::Display for Affine {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let mut first = true;
        for (name, multiple) in &self.multiples {
            let sign = if *multiple < 0 {
                "-"
            } else if first {
                ""
            } else {
                "+"
            };
            match multiple.unsigned_abs() {
                1 => write!(f, "{sign}{name}")?,
                size => write!(f, "{sign}{size}*{name}")?,
            }
            first = false;
        }
        match self.constant {
            0 if !first => Ok(()),
            n if first || n < 0 => write!(f, "{n}"),
            n => write!(f, "+{n}"),
        }
    }
}
