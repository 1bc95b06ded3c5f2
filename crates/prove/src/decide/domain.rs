//! Where a statement is meant to hold: the declared ranges of its symbols and its assumptions.

use crate::decide::interval::Interval;
use torse_algebra::order::compare;
use torse_algebra::rational::integer;
use torse_algebra::{Affine, Ball, Fraction, Polynomial, Rational, Scalar as _, Symbol};
use torse_language::derivation::declarations::{Declarations, SymbolKind};
use torse_language::syntax::Relation;

/// Bits of the enclosures that decide signs of constants, tried in turn.
const BITS: [usize; 4] = [256, 1024, 4096, 16_384];

/// A condition `value relation 0` from the assumptions.
#[derive(Debug, Clone)]
pub struct Constraint {
    /// The quantity compared with zero.
    pub value: Fraction,
    /// How.
    pub relation: Relation,
}

/// The domain of a statement.
#[derive(Debug, Clone)]
pub struct Domain<'a> {
    /// The ranges.
    pub declarations: &'a Declarations,
    /// The assumptions that are no equalities.
    pub constraints: Vec<Constraint>,
}

impl Domain<'_> {
    /// The interval in which a symbol lives; integers from their bounds, functions of angles from -1
    /// to 1 or, for a variable of `[0, 1]`, from 0 to 1.
    #[must_use]
    pub fn interval(&self, symbol: &Symbol) -> Interval {
        let closed = |n: i64| {
            Some(crate::decide::interval::Bound {
                value: Fraction::integer(n),
                closed: true,
            })
        };
        match symbol {
            Symbol::Named(name) => match self.declarations.symbol(name) {
                Some(SymbolKind::Real(interval)) => Interval::from(&**interval),
                Some(SymbolKind::Integer { .. }) => {
                    let form = Affine::symbol(name);
                    Interval {
                        lower: self.declarations.least(&form).and_then(closed),
                        upper: self.declarations.greatest(&form).and_then(closed),
                    }
                }
                _ => Interval::default(),
            },
            Symbol::Sin(name, torse_algebra::Angle::QuarterTurn)
            | Symbol::Cos(name, torse_algebra::Angle::QuarterTurn) => {
                let of = self.interval(&Symbol::Named(name.clone()));
                let inside = |bound: &Option<crate::decide::interval::Bound>, low: bool| {
                    bound
                        .as_ref()
                        .and_then(|b| b.value.as_rational())
                        .is_some_and(|v| {
                            if low {
                                compare(&v, &integer(0)).is_ge()
                            } else {
                                compare(&v, &integer(1)).is_le()
                            }
                        })
                };
                let unit = inside(&of.lower, true) && inside(&of.upper, false);
                Interval {
                    lower: closed(if unit { 0 } else { -1 }),
                    upper: closed(1),
                }
            }
            Symbol::Sin(..) | Symbol::Cos(..) => Interval {
                lower: closed(-1),
                upper: closed(1),
            },
            Symbol::Indexed(..) | Symbol::Root(_) | Symbol::Pi => Interval::default(),
        }
    }

    /// Whether a symbol is an integer.
    #[must_use]
    pub fn is_integer(&self, symbol: &Symbol) -> bool {
        matches!(symbol, Symbol::Named(name)
            if matches!(self.declarations.symbol(name), Some(SymbolKind::Integer { .. })))
    }

    /// An assumption that no point of the declared ranges satisfies that satisfies the others, if one is
    /// known.
    #[must_use]
    pub fn contradiction(&self) -> Option<String> {
        use super::sign::{Sign, of};
        let fails = |number: usize, c: &Constraint| {
            if c.value.is_zero() {
                return matches!(
                    c.relation,
                    Relation::Different | Relation::Less | Relation::Greater
                );
            }
            let mut others = self.clone();
            others.constraints.remove(number);
            let sign = c.value.as_polynomial().and_then(|p| of(p, &others));
            match c.relation {
                Relation::Less => matches!(sign, Some(Sign::Positive | Sign::Nonnegative)),
                Relation::AtMost => sign == Some(Sign::Positive),
                Relation::Greater => matches!(sign, Some(Sign::Negative | Sign::Nonpositive)),
                Relation::AtLeast => sign == Some(Sign::Negative),
                Relation::Equal | Relation::Different => false,
            }
        };
        let mut numbered = self.constraints.iter().enumerate();
        let (_, failing) = numbered.find(|(number, c)| fails(*number, c))?;
        let others = match self.constraints.len() {
            1 => "on the declared ranges",
            _ => "on the declared ranges where the other assumptions hold",
        };
        let sign = failing.relation.sign();
        Some(format!("{} {sign} 0 holds nowhere {others}", failing.value))
    }

    /// Whether the assumptions imply that this polynomial is not zero: it is, up to a constant, a product
    /// of factors of quantities that are assumed to be different from zero.
    #[must_use]
    pub fn assumes_nonzero(&self, polynomial: &Polynomial) -> bool {
        let mut rest = polynomial.clone();
        for constraint in &self.constraints {
            if !matches!(
                constraint.relation,
                Relation::Different | Relation::Less | Relation::Greater
            ) {
                continue;
            }
            let assumed = constraint.value.numerator();
            if assumed.exact_quotient(&rest).is_some() {
                return true;
            }
            while assumed.as_constant().is_none()
                && let Some(quotient) = rest.exact_quotient(assumed)
            {
                rest = quotient;
            }
        }
        rest.as_constant().is_some()
    }
}

/// The enclosure of a fraction without free symbols: pi and roots only.
#[must_use]
pub fn enclosure(value: &Fraction, bits: usize) -> Option<Ball> {
    let like = Ball::from_rational(&integer(0), bits);
    let part = |p: &Polynomial| {
        p.evaluate(&like, |symbol| match symbol {
            Symbol::Pi => Ok(Ball::pi(bits)),
            Symbol::Root(prime) => {
                Ball::from_rational(&Rational::from_integer((*prime).into()), bits)
                    .sqrt()
                    .map_err(drop)
            }
            _ => Err(()),
        })
        .ok()
    };
    let denominator = part(&value.denominator())?;
    part(value.numerator())?.divided_by(&denominator).ok()
}

/// Whether `value relation 0` holds, for a fraction without free symbols.
#[must_use]
pub fn truth(value: &Fraction, relation: Relation) -> Option<bool> {
    use std::cmp::Ordering;
    // Zero is decided by the normal form, the sign of a nonzero number by an enclosure.
    let order = if value.is_zero() {
        Ordering::Equal
    } else {
        BITS.into_iter()
            .find_map(|bits| enclosure(value, bits).and_then(|ball| ball.sign()))?
    };
    Some(match relation {
        Relation::Equal => order == Ordering::Equal,
        Relation::Different => order != Ordering::Equal,
        Relation::Less => order == Ordering::Less,
        Relation::AtMost => order != Ordering::Greater,
        Relation::Greater => order == Ordering::Greater,
        Relation::AtLeast => order != Ordering::Less,
    })
}
