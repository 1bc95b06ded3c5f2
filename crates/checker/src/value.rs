//! Numbers, vectors and matrices of quotients. The number 0 matches every shape.

use super::gap::{Unsupported, Work};
use super::quotient::Quotient;
use std::collections::{BTreeMap, BTreeSet};

const SHAPE: Unsupported = Unsupported::Construct("values of different shapes");

/// A number, or the entries of a vector or rows of a matrix.
#[derive(Debug, Clone, PartialEq)]
pub enum Value {
    /// A number.
    Number(Quotient),
    /// Entries or rows.
    Many(Vec<Value>),
}

impl Value {
    pub fn number(self) -> Result<Quotient, Unsupported> {
        match self {
            Self::Number(number) => Ok(number),
            Self::Many(_) => Err(SHAPE),
        }
    }

    /// All numbers, in order.
    pub fn numbers(&self) -> Vec<&Quotient> {
        match self {
            Self::Number(number) => vec![number],
            Self::Many(items) => items.iter().flat_map(Self::numbers).collect(),
        }
    }

    pub fn entries(self) -> Result<Vec<Quotient>, Unsupported> {
        match self {
            Self::Many(items) => items.into_iter().map(Self::number).collect(),
            Self::Number(_) => Err(SHAPE),
        }
    }

    /// The rows of a matrix, all of one length.
    pub fn rows(self) -> Result<Vec<Vec<Quotient>>, Unsupported> {
        let Self::Many(rows) = self else {
            return Err(SHAPE);
        };
        let rows: Vec<Vec<Quotient>> = rows
            .into_iter()
            .map(Self::entries)
            .collect::<Result<_, _>>()?;
        let width = rows.first().map_or(0, Vec::len);
        if rows.iter().all(|row| row.len() == width) {
            Ok(rows)
        } else {
            Err(SHAPE)
        }
    }

    pub fn vector(entries: Vec<Quotient>) -> Self {
        Self::Many(entries.into_iter().map(Self::Number).collect())
    }

    pub fn matrix(rows: Vec<Vec<Quotient>>) -> Self {
        Self::Many(rows.into_iter().map(Self::vector).collect())
    }

    pub fn each(
        &self,
        change: &dyn Fn(&Quotient) -> Result<Quotient, Unsupported>,
    ) -> Result<Self, Unsupported> {
        Ok(match self {
            Self::Number(number) => Self::Number(change(number)?),
            Self::Many(items) => {
                let items = items.iter().map(|item| item.each(change));
                Self::Many(items.collect::<Result<_, _>>()?)
            }
        })
    }

    fn is_zero(&self) -> bool {
        matches!(self, Self::Number(number) if number.above.is_zero())
    }

    /// The pairs of corresponding numbers.
    pub fn pairs(&self, other: &Self) -> Result<Vec<(Quotient, Quotient)>, Unsupported> {
        let zero = Quotient::default;
        match (self, other) {
            (Self::Number(x), Self::Number(y)) => Ok(vec![(x.clone(), y.clone())]),
            (x, many) if x.is_zero() => {
                let numbers = many.numbers().into_iter();
                Ok(numbers.map(|y| (zero(), y.clone())).collect())
            }
            (many, y) if y.is_zero() => {
                let numbers = many.numbers().into_iter();
                Ok(numbers.map(|x| (x.clone(), zero())).collect())
            }
            (Self::Many(xs), Self::Many(ys)) if xs.len() == ys.len() => {
                let pairs = xs.iter().zip(ys).map(|(x, y)| x.pairs(y));
                Ok(pairs.collect::<Result<Vec<_>, _>>()?.concat())
            }
            _ => Err(SHAPE),
        }
    }

    pub fn plus(&self, other: &Self, work: &Work) -> Result<Self, Unsupported> {
        match (self, other) {
            (Self::Number(x), Self::Number(y)) => Ok(Self::Number(x.plus(y, work)?)),
            (zero, many) | (many, zero) if zero.is_zero() => Ok(many.clone()),
            (Self::Many(xs), Self::Many(ys)) if xs.len() == ys.len() => {
                let sums = xs.iter().zip(ys).map(|(x, y)| x.plus(y, work));
                Ok(Self::Many(sums.collect::<Result<_, _>>()?))
            }
            _ => Err(SHAPE),
        }
    }

    pub fn negated(&self) -> Self {
        match self {
            Self::Number(x) => Self::Number(x.negated()),
            Self::Many(items) => Self::Many(items.iter().map(Self::negated).collect()),
        }
    }

    /// The product of a number and anything, or of a matrix and a vector or a matrix.
    pub fn times(&self, other: &Self, work: &Work) -> Result<Self, Unsupported> {
        match (self, other) {
            (Self::Number(x), many) | (many, Self::Number(x)) => many.each(&|y| x.times(y, work)),
            (matrix, Self::Many(entries)) if matches!(entries.first(), Some(Self::Number(_))) => {
                let vector = other.clone().entries()?;
                let rows = matrix.clone().rows()?;
                let entries = rows.iter().map(|row| dot(row, &vector, work));
                Ok(Self::vector(entries.collect::<Result<_, _>>()?))
            }
            _ => {
                let (rows, columns) = (self.clone().rows()?, transposed(&other.clone().rows()?));
                let row = |row: &Vec<Quotient>| {
                    let entries = columns.iter().map(|column| dot(row, column, work));
                    entries.collect::<Result<Vec<_>, Unsupported>>()
                };
                let rows = rows.iter().map(row).collect::<Result<_, _>>()?;
                Ok(Self::matrix(rows))
            }
        }
    }
}

/// `sum of x_i y_i`.
pub fn dot(xs: &[Quotient], ys: &[Quotient], work: &Work) -> Result<Quotient, Unsupported> {
    if xs.len() != ys.len() {
        return Err(SHAPE);
    }
    let mut pairs = xs.iter().zip(ys);
    pairs.try_fold(Quotient::default(), |sum, (x, y)| {
        sum.plus(&x.times(y, work)?, work)
    })
}

/// The transposed matrix.
pub fn transposed<T: Clone>(rows: &[Vec<T>]) -> Vec<Vec<T>> {
    let width = rows.first().map_or(0, Vec::len);
    let column = |c| rows.iter().filter_map(|row| row.get(c).cloned()).collect();
    (0..width).map(column).collect()
}

/// The matrix without a row and a column.
pub fn minor<T: Clone>(rows: &[Vec<T>], row: usize, column: usize) -> Vec<Vec<T>> {
    let without = |list: &[T]| -> Vec<T> {
        let kept = list
            .iter()
            .enumerate()
            .filter(|(place, _)| *place != column);
        kept.map(|(_, entry)| entry.clone()).collect()
    };
    let kept = rows.iter().enumerate().filter(|(place, _)| *place != row);
    kept.map(|(_, list)| without(list)).collect()
}

/// The determinant, by expansion row by row, keeping one minor for each set of columns.
pub fn determinant(rows: &[Vec<Quotient>], work: &Work) -> Result<Quotient, Unsupported> {
    let one = Quotient::number(torse_numbers::rational::integer(1));
    let mut minors: BTreeMap<BTreeSet<usize>, Quotient> = [(BTreeSet::new(), one)].into();
    for row in rows {
        if row.len() != rows.len() {
            return Err(SHAPE);
        }
        let mut larger: BTreeMap<BTreeSet<usize>, Quotient> = BTreeMap::new();
        for (columns, minor) in &minors {
            let new = row.iter().enumerate();
            let new = new.filter(|(c, entry)| !entry.above.is_zero() && !columns.contains(c));
            for (column, entry) in new {
                // The sign of moving the column to its position.
                let behind = columns.range(column..).count();
                let part = entry.times(minor, work)?;
                let part = match behind % 2 {
                    0 => part,
                    _ => part.negated(),
                };
                let all = columns.iter().copied().chain([column]).collect();
                let sum = larger.entry(all).or_default();
                *sum = sum.plus(&part, work)?;
            }
        }
        minors = larger;
    }
    Ok(minors.into_values().next().unwrap_or_default())
}
