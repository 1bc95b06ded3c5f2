//! The exact values of this room as parts of proofs, and back; as plain polynomials, when a proof is worded, written or
//! checked.

use torse_algebra::{Angle, Fraction, Polynomial, Symbol, Unit};
use torse_certificate::symbol;
use torse_certificate::{Ratio, symbol::Symbol as Plain};

/// A proof in the polynomials of this room.
pub type Proof = torse_certificate::Proof<Polynomial>;

/// Numerator and denominator.
pub(crate) fn quotient(value: &Fraction) -> Ratio<Polynomial> {
    Ratio {
        above: value.numerator().clone(),
        below: value.denominator(),
    }
}

/// The quotient; `None` for a denominator that is zero, which no value of a proof has.
pub(crate) fn fraction(ratio: &Ratio<Polynomial>) -> Option<Fraction> {
    let below = Fraction::from(ratio.below.clone());
    Fraction::from(ratio.above.clone()).over(&below).ok()
}

/// The symbol of proofs.
pub(crate) fn plain_symbol(symbol: &Symbol) -> Plain {
    match symbol {
        Symbol::Pi => Plain::Pi,
        Symbol::Root(prime) => Plain::Root(*prime),
        Symbol::Sin(name, angle) => Plain::Sine(name.clone(), plain_angle(*angle)),
        Symbol::Cos(name, angle) => Plain::Cosine(name.clone(), plain_angle(*angle)),
        Symbol::Named(name) => Plain::Named(name.clone()),
        // A vector with one generic coordinate.
        Symbol::Indexed(name, index) if index.is_empty() => Plain::Named(name.clone()),
        Symbol::Indexed(..) => Plain::named(&symbol.to_string()),
        Symbol::Exp(_) | Symbol::Log(_) | Symbol::Arc(..) => {
            Plain::Exponential(symbol.to_string().into())
        }
    }
}

/// The angle of proofs.
pub(crate) fn plain_angle(angle: Angle) -> symbol::Angle {
    let unit = match angle.unit {
        Unit::QuarterTurn => symbol::Unit::QuarterTurn,
        Unit::Radian => symbol::Unit::Radian,
    };
    symbol::Angle {
        unit,
        parts: angle.parts,
    }
}

/// The polynomial as a plain one.
#[must_use]
pub fn plain(polynomial: &Polynomial) -> torse_certificate::Polynomial {
    let mut result = torse_certificate::Polynomial::zero();
    for term in polynomial.terms() {
        let powers = term.powers.iter();
        let mut monomial: Vec<(Plain, u32)> = powers
            .map(|(symbol, exponent)| (plain_symbol(symbol), u32::from(*exponent)))
            .collect();
        monomial.sort();
        result.enter(monomial, term.coefficient);
    }
    result
}
