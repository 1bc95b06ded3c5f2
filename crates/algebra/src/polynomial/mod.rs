//! Sparse multivariate polynomials over the rationals, in normal form.
//!
//! A polynomial consists of a positive denominator, integer coefficients, and a table of exponents in descending
//! lexicographic order. The normal form is unique: only symbols that occur are listed, the denominator and the
//! coefficients have no common factor, every sine has degree at most one (by sin^2 = 1 - cos^2) and every root of a
//! prime has degree at most one. The symbols satisfy no other algebraic relation (see [`crate::symbol`]), hence
//!
//! **Theorem.** A polynomial is the zero function if and only if its normal form has no terms.
//!
//! One operation is one file: [`add`], [`multiply`], `reduce` (the relations), [`divide`], [`gcd`],
//! [`calculus`], [`evaluate`], [`trigonometry`], [`exponential`], [`logarithm`]; `cost` counts their work.

pub mod add;
pub mod angles;
pub mod arc;
mod body;
pub mod calculus;
mod coefficients;
mod cost;
mod dense;
pub mod divide;
pub mod evaluate;
pub mod exponential;
pub mod gcd;
pub mod logarithm;
mod modular;
pub mod multiply;
mod packed;
mod primes;
mod quotients;
mod reduce;
mod sparse;
pub mod trigonometry;

use crate::rational::{Integer, Rational, integer};
use crate::symbol::Symbol;
use body::Body;
use dashu_int::ops::BitTest;
use num_integer::Integer as _;
use num_traits::{One, Signed, Zero};
use std::fmt;
use std::sync::Arc;

/// A polynomial in normal form; see the [module](self). Copies share their terms.
#[derive(Clone, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Polynomial {
    body: Arc<Body>,
}

/// A term of a polynomial, borrowed.
#[derive(Debug, Clone)]
pub struct Term<'a> {
    /// The rational coefficient.
    pub coefficient: Rational,
    /// The symbols with positive exponent.
    pub powers: Vec<(&'a Symbol, u16)>,
}

/// The empty list of symbols. Each thread has its own, since a shared reference count would make all threads wait for
/// each other.
fn no_symbols() -> Arc<[Symbol]> {
    thread_local! {
        static NONE: Arc<[Symbol]> = Arc::new([]);
    }
    NONE.with(Arc::clone)
}

impl Polynomial {
    /// Makes a polynomial of parts that are in normal form.
    fn new(
        symbols: Arc<[Symbol]>,
        exponents: Vec<u16>,
        coefficients: Vec<Integer>,
        denominator: Integer,
    ) -> Self {
        let body = Body {
            symbols,
            exponents,
            coefficients,
            denominator,
        };
        Self {
            body: body.shared(),
        }
    }

    /// A nonzero constant in lowest terms.
    fn number(numerator: Integer, denominator: Integer) -> Self {
        Self::new(no_symbols(), vec![], vec![numerator], denominator)
    }

    /// The zero polynomial.
    #[must_use]
    pub fn zero() -> Self {
        Self::new(no_symbols(), vec![], vec![], Integer::one())
    }

    /// A constant.
    #[must_use]
    pub fn constant(value: &Rational) -> Self {
        if value.is_zero() {
            return Self::zero();
        }
        Self::number(value.numer().clone(), value.denom().clone())
    }

    /// An integer constant.
    #[must_use]
    pub fn integer(value: i64) -> Self {
        Self::constant(&integer(value))
    }

    /// A single symbol.
    #[must_use]
    pub fn symbol(symbol: Symbol) -> Self {
        let symbols = Arc::from([symbol]);
        Self::new(symbols, vec![1], vec![Integer::one()], Integer::one())
    }

    /// The symbol with this name.
    ///
    /// ```
    /// use torse_algebra::Polynomial;
    /// let x = Polynomial::named("x");
    /// assert_eq!((x.clone() * x).to_string(), "x^2");
    /// ```
    #[must_use]
    pub fn named(name: &str) -> Self {
        Self::symbol(Symbol::named(name))
    }

    /// Whether this is the zero polynomial, that is, the zero function.
    #[must_use]
    pub fn is_zero(&self) -> bool {
        self.body.coefficients.is_empty()
    }

    /// Returns the value if no symbol occurs, else `None`.
    #[must_use]
    pub fn as_constant(&self) -> Option<Rational> {
        match (&*self.body.symbols, self.body.coefficients.as_slice()) {
            (_, []) => Some(Rational::zero()),
            ([], [value]) if self.body.denominator.is_one() => {
                Some(Rational::from_integer(value.clone()))
            }
            ([], [value]) => Some(Rational::new(value.clone(), self.body.denominator.clone())),
            _ => None,
        }
    }

    /// Whether no symbol occurs.
    #[must_use]
    pub fn is_constant(&self) -> bool {
        self.body.symbols.is_empty()
    }

    /// The number of terms.
    #[must_use]
    pub fn len(&self) -> usize {
        self.body.coefficients.len()
    }

    /// Whether there are no terms (the same as [`Polynomial::is_zero`]).
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.body.coefficients.is_empty()
    }

    /// The symbols that occur, ascending.
    #[must_use]
    pub fn symbols(&self) -> &[Symbol] {
        &self.body.symbols
    }

    /// The common denominator of the coefficients.
    #[must_use]
    pub fn denominator(&self) -> &Integer {
        &self.body.denominator
    }

    /// The bits of the longest integer of the normal form: of the numerators or the common denominator.
    #[must_use]
    pub fn bits(&self) -> usize {
        let numerators = self.body.coefficients.iter().map(BitTest::bit_len).max();
        numerators.unwrap_or(0).max(self.body.denominator.bit_len())
    }

    /// The terms, in descending lexicographic order.
    pub fn terms(&self) -> impl Iterator<Item = Term<'_>> {
        self.rows()
            .zip(&self.body.coefficients)
            .map(|(row, coefficient)| Term {
                coefficient: Rational::new(coefficient.clone(), self.body.denominator.clone()),
                powers: self
                    .body
                    .symbols
                    .iter()
                    .zip(row.iter().copied())
                    .filter(|(_, exponent)| *exponent > 0)
                    .collect(),
            })
    }

    /// The highest exponent of `symbol`.
    #[must_use]
    pub fn degree_in(&self, symbol: &Symbol) -> u16 {
        match self.body.symbols.binary_search(symbol) {
            Err(_) => 0,
            Ok(column) => self
                .rows()
                .map(|row| row.get(column).copied().unwrap_or(0))
                .max()
                .unwrap_or(0),
        }
    }

    /// The highest total degree of a term.
    #[must_use]
    pub fn total_degree(&self) -> u32 {
        self.rows()
            .map(|row| row.iter().map(|e| u32::from(*e)).sum())
            .max()
            .unwrap_or(0)
    }

    /// The coefficient of the first term; zero for the zero polynomial.
    #[must_use]
    pub fn leading_coefficient(&self) -> Rational {
        self.body
            .coefficients
            .first()
            .map_or_else(Rational::zero, |c| {
                Rational::new(c.clone(), self.body.denominator.clone())
            })
    }

    /// Returns the content and the primitive part: the polynomial divided by the content, with coprime integer
    /// coefficients and a positive leading coefficient. The content of zero is zero.
    #[must_use]
    pub fn primitive(&self) -> (Rational, Self) {
        let common = self
            .body
            .coefficients
            .iter()
            .fold(Integer::zero(), |g, c| g.gcd(c));
        if common.is_zero() {
            return (Rational::zero(), Self::zero());
        }
        let signed = if self
            .body
            .coefficients
            .first()
            .is_some_and(Signed::is_negative)
        {
            -common
        } else {
            common
        };
        let coefficients = self.body.coefficients.iter().map(|c| c / &signed);
        let part = Self::new(
            Arc::clone(&self.body.symbols),
            self.body.exponents.clone(),
            coefficients.collect(),
            Integer::one(),
        );
        (Rational::new(signed, self.body.denominator.clone()), part)
    }

    /// The coefficients of the powers of `symbol`, ascending: `self = sum of coefficient * symbol^power`.
    #[must_use]
    pub fn coefficients_in(&self, symbol: &Symbol) -> Vec<Self> {
        let Ok(column) = self.body.symbols.binary_search(symbol) else {
            return if self.is_zero() {
                vec![]
            } else {
                vec![self.clone()]
            };
        };
        let mut rows = vec![(vec![], vec![]); usize::from(self.degree_in(symbol)) + 1];
        for (row, coefficient) in self.rows().zip(&self.body.coefficients) {
            let power = row.get(column).copied().unwrap_or(0);
            if let Some((exponents, coefficients)) = rows.get_mut(usize::from(power)) {
                exponents.extend(
                    row.iter()
                        .enumerate()
                        .map(|(c, e)| if c == column { 0 } else { *e }),
                );
                coefficients.push(coefficient.clone());
            }
        }
        rows.into_iter()
            .map(|(exponents, coefficients)| {
                Self::normalized(
                    Arc::clone(&self.body.symbols),
                    exponents,
                    coefficients,
                    self.body.denominator.clone(),
                )
            })
            .collect()
    }

    /// The rows of exponents.
    fn rows(&self) -> impl Iterator<Item = &[u16]> {
        self.body.rows()
    }

    /// Brings sorted, merged, nonzero terms to normal form: drops symbols that do not occur and common
    /// factors of the coefficients and the denominator.
    fn normalized(
        symbols: Arc<[Symbol]>,
        exponents: Vec<u16>,
        coefficients: Vec<Integer>,
        denominator: Integer,
    ) -> Self {
        if coefficients.is_empty() {
            return Self::zero();
        }
        let mut body = Body {
            symbols,
            exponents,
            coefficients,
            denominator,
        };
        body.drop_absent_symbols();
        body.cancel_content();
        Self {
            body: body.shared(),
        }
    }

    /// Sorts rows of exponents, merges equal ones and brings the result to normal form.
    fn collected(
        symbols: Arc<[Symbol]>,
        mut terms: Vec<(Vec<u16>, Integer)>,
        denominator: Integer,
    ) -> Self {
        terms.sort_by(|a, b| b.0.cmp(&a.0));
        let mut exponents = Vec::with_capacity(terms.len() * symbols.len());
        let mut coefficients: Vec<Integer> = Vec::with_capacity(terms.len());
        let mut terms = terms.into_iter().peekable();
        while let Some((row, mut coefficient)) = terms.next() {
            while let Some((_, more)) = terms.next_if(|next| next.0 == row) {
                coefficient += more;
            }
            if !coefficient.is_zero() {
                exponents.extend(row);
                coefficients.push(coefficient);
            }
        }
        Self::normalized(symbols, exponents, coefficients, denominator)
    }
}

impl From<Rational> for Polynomial {
    fn from(value: Rational) -> Self {
        Self::constant(&value)
    }
}

impl fmt::Display for Polynomial {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if self.is_zero() {
            return f.write_str("0");
        }
        for (position, term) in self.terms().enumerate() {
            let negative = term.coefficient.is_negative();
            f.write_str(match (position, negative) {
                (0, false) => "",
                (0, true) => "-",
                (_, false) => " + ",
                (_, true) => " - ",
            })?;
            let size = term.coefficient.abs();
            let mut factors = vec![];
            if !size.is_one() || term.powers.is_empty() {
                factors.push(size.to_string());
            }
            factors.extend(term.powers.iter().map(|(symbol, exponent)| match exponent {
                1 => symbol.to_string(),
                _ => format!("{symbol}^{exponent}"),
            }));
            f.write_str(&factors.join("*"))?;
        }
        Ok(())
    }
}

impl fmt::Debug for Polynomial {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        fmt::Display::fmt(self, f)
    }
}
