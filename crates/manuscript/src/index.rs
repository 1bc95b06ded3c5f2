//! Indices as a symbol and a whole number: `n - 1`, and ranges of them.

use std::fmt;
use torse_syntax::formula::{Expr, Node, Operator};

/// A symbol, if there is one, and a whole number that is added.
#[derive(Debug, Clone, PartialEq, Eq, PartialOrd, Ord)]
pub struct AffineIndex {
    /// The symbol.
    pub symbol: Option<String>,
    /// The number.
    pub constant: i64,
}

/// A first and a last index.
pub type IndexRange = (AffineIndex, AffineIndex);

impl AffineIndex {
    /// Reads `n`, `3`, `n - 1`, `1 + n`; none for anything else.
    pub fn from_formula(formula: &Expr) -> Option<Self> {
        match &formula.node {
            Node::Number { value, .. } => Some(Self {
                symbol: None,
                constant: value.to_string().parse().ok()?,
            }),
            Node::Name(name) => Some(Self {
                symbol: Some(name.clone()),
                constant: 0,
            }),
            Node::Negative(inner) => {
                let inner = Self::from_formula(inner)?;
                inner.symbol.is_none().then(|| inner.negated())
            }
            Node::Binary(Operator::Add, a, b) => {
                let (a, b) = (Self::from_formula(a)?, Self::from_formula(b)?);
                match (&a.symbol, &b.symbol) {
                    (_, None) => Some(a.plus(b.constant)),
                    (None, _) => Some(b.plus(a.constant)),
                    _ => None,
                }
            }
            Node::Binary(Operator::Subtract, a, b) => {
                let (a, b) = (Self::from_formula(a)?, Self::from_formula(b)?);
                b.symbol.is_none().then(|| a.plus(-b.constant))
            }
            _ => None,
        }
    }

    /// This with a number added.
    pub fn plus(&self, number: i64) -> Self {
        Self {
            constant: self.constant.saturating_add(number),
            ..self.clone()
        }
    }

    fn negated(&self) -> Self {
        Self {
            constant: self.constant.saturating_neg(),
            ..self.clone()
        }
    }
}

impl fmt::Display for AffineIndex {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        match (&self.symbol, self.constant) {
            (None, number) => write!(formatter, "{number}"),
            (Some(name), 0) => formatter.write_str(name),
            (Some(name), number) if number > 0 => write!(formatter, "{name}+{number}"),
            (Some(name), number) => write!(formatter, "{name}{number}"),
        }
    }
}

/// The smallest range that contains others: its first index is a number where one is, for symbols are taken to be no smaller, and
/// its last one has a symbol where one has. None for ranges of different symbols.
pub fn hull<'r>(ranges: impl IntoIterator<Item = &'r IndexRange>) -> Option<IndexRange> {
    let ranges: Vec<&IndexRange> = ranges.into_iter().collect();
    let numbers = ranges.iter().flat_map(|(low, high)| [low, high]);
    let lowest_number = numbers
        .filter(|end| end.symbol.is_none())
        .min_by_key(|end| end.constant);
    let symbols: Vec<&AffineIndex> = ranges
        .iter()
        .flat_map(|(low, high)| [low, high])
        .filter(|end| end.symbol.is_some())
        .collect();
    let first = symbols.first();
    if symbols
        .iter()
        .any(|end| Some(&end.symbol) != first.map(|first| &first.symbol))
    {
        return None;
    }
    let low = match lowest_number {
        Some(number) => number.clone(),
        None => (*symbols.iter().min_by_key(|end| end.constant)?).clone(),
    };
    let high = match symbols.iter().max_by_key(|end| end.constant) {
        Some(end) => (*end).clone(),
        None => ranges
            .iter()
            .map(|(_, high)| high)
            .max_by_key(|end| end.constant)?
            .clone(),
    };
    Some((low, high))
}
