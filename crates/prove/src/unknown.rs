//! The unknowns of equations: the symbols for which an equation may be solved.

use torse_algebra::{Fraction, Symbol};

/// A number of a claim's points that may be any number, as far as its declared set goes: a declared symbol, a member of a
/// family, a coordinate, or a derivative of an arbitrary function at a place.
///
/// Sines, cosines, exponentials, square roots, logarithms and arcs of numbers and pi are none: their values are those of what stands in them, so
/// that an equation which says what one of them is says something of that. There is no way to make one of them an unknown.
#[derive(Debug, Clone, PartialEq, Eq, PartialOrd, Ord)]
pub struct Unknown(Symbol);

impl Unknown {
    /// The symbol as an unknown; nothing for a function of others and for a number.
    ///
    /// ```
    /// use torse_algebra::Symbol;
    /// use torse_prove::unknown::Unknown;
    /// assert!(Unknown::new(Symbol::named("x")).is_some());
    /// assert!(Unknown::new(Symbol::Pi).is_none());
    /// ```
    #[must_use]
    pub fn new(symbol: Symbol) -> Option<Self> {
        match symbol {
            Symbol::Named(_) | Symbol::Indexed(..) => Some(Self(symbol)),
            Symbol::Root(_)
            | Symbol::Log(_)
            | Symbol::Arc(..)
            | Symbol::Pi
            | Symbol::Sin(..)
            | Symbol::Cos(..)
            | Symbol::Exp(_) => None,
        }
    }

    /// The unknown that a fraction is, if it is just one.
    #[must_use]
    pub fn from_fraction(value: &Fraction) -> Option<Self> {
        let polynomial = value.as_polynomial()?;
        match (polynomial.symbols(), polynomial.len()) {
            ([symbol], 1) if *value == Fraction::symbol(symbol.clone()) => {
                Self::new(symbol.clone())
            }
            _ => None,
        }
    }

    /// The symbol.
    #[must_use]
    pub fn symbol(&self) -> &Symbol {
        &self.0
    }

    /// Whether it occurs in a value: as itself, under a sine, cosine or exponential, in an index or in a recorded divisor.
    #[must_use]
    pub fn occurs_in(&self, value: &Fraction) -> bool {
        mentions(value, &self.0)
    }

    /// Whether a symbol is this one, or a function of it.
    #[must_use]
    pub fn stands_in(&self, symbol: &Symbol) -> bool {
        involves(symbol, &self.0)
    }
}

/// Whether a symbol occurs in a value: as itself, under a sine, cosine or exponential, in an index or in a recorded divisor.
#[must_use]
pub fn mentions(value: &Fraction, symbol: &Symbol) -> bool {
    let recorded = value.conditions().iter().flat_map(|p| p.symbols());
    let mut all = value.symbols().into_iter().chain(recorded.cloned());
    all.any(|own| involves(&own, symbol))
}

/// Whether a symbol is another one, or a function of it.
fn involves(own: &Symbol, other: &Symbol) -> bool {
    own == other || matches!(other, Symbol::Named(name) if own.depends_on(name))
}
