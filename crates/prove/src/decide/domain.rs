//! Where a statement is meant to hold: the declared ranges of its symbols and its assumptions.

use crate::decide::interval::{Bound, Interval};
use std::cmp::Ordering;
use torse_algebra::planted::{Planted, planted};
use torse_algebra::rational::integer;
use torse_algebra::{Affine, Angle, Ball, Fraction, Polynomial, Rational, Scalar as _, Symbol};
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

impl Constraint {
    /// The constraint as `symbol relation number`, if it is linear in this symbol and says nothing of another.
    #[must_use]
    pub fn bound_of(&self, symbol: &Symbol) -> Option<(Relation, Rational)> {
        let value = self.value.as_polynomial()?;
        let (mut slope, mut constant) = (integer(0), integer(0));
        for term in value.terms() {
            match term.powers.as_slice() {
                [] => constant = term.coefficient.clone(),
                [(own, 1)] if *own == symbol => slope = term.coefficient.clone(),
                _ => return None,
            }
        }
        let relation = match slope.cmp(&integer(0)) {
            Ordering::Equal => return None,
            Ordering::Greater if planted(Planted::BoundReversed) => self.relation.mirrored(),
            Ordering::Less => self.relation.mirrored(),
            Ordering::Greater => self.relation,
        };
        Some((relation, -constant / slope))
    }
}

/// The domain of a statement.
#[derive(Debug, Clone)]
pub struct Domain<'a> {
    /// The ranges.
    pub declarations: &'a Declarations,
    /// The hypotheses that eliminated no symbol, and what eliminated symbols left behind.
    pub constraints: Vec<Constraint>,
    /// The eliminated symbols with their values.
    pub solved: Vec<(Symbol, Fraction)>,
    /// Divisors of the elimination that may vanish: proofs from constraints say nothing where one does.
    pub pivots: Vec<Polynomial>,
    /// Divisors of the statement: it says nothing where one vanishes, so no point there refutes it.
    pub divisors: Vec<Polynomial>,
}

impl<'a> Domain<'a> {
    /// The declared ranges alone.
    #[must_use]
    pub fn new(declarations: &'a Declarations) -> Self {
        Self {
            declarations,
            constraints: vec![],
            solved: vec![],
            pivots: vec![],
            divisors: vec![],
        }
    }

    /// The same hypotheses on other ranges.
    #[must_use]
    pub fn on<'b>(&self, declarations: &'b Declarations) -> Domain<'b> {
        Domain {
            declarations,
            constraints: self.constraints.clone(),
            solved: self.solved.clone(),
            pivots: self.pivots.clone(),
            divisors: self.divisors.clone(),
        }
    }
}

/// A closed end at an integer.
fn closed(n: i64) -> Option<Bound> {
    Some(Bound {
        value: Fraction::integer(n),
        closed: true,
    })
}

impl Domain<'_> {
    /// The interval in which a symbol is declared to live, whatever is assumed; integers from their bounds.
    #[must_use]
    pub fn declared(&self, name: &str) -> Interval {
        match self.declarations.symbol(name) {
            Some(SymbolKind::Real(interval)) => Interval::from(&**interval),
            Some(SymbolKind::Integer { .. }) => {
                let form = Affine::symbol(name);
                Interval {
                    lower: self.declarations.least(&form).and_then(closed),
                    upper: self.declarations.greatest(&form).and_then(closed),
                }
            }
            _ => Interval::default(),
        }
    }

    /// The interval in which a symbol lives: the declared one, narrowed by what is assumed of the symbol alone
    /// (`2*a - 2 > 0` says that a > 1). Functions of angles live from -1 to 1 or, for a variable of `[0, 1]`, from 0
    /// to 1.
    #[must_use]
    pub fn interval(&self, symbol: &Symbol) -> Interval {
        match symbol {
            Symbol::Named(name) => {
                let mut interval = self.declared(name);
                for constraint in &self.constraints {
                    if let Some((relation, number)) = constraint.bound_of(symbol) {
                        interval.narrow(relation, number);
                    }
                }
                interval
            }
            Symbol::Sin(name, Angle::QuarterTurn) | Symbol::Cos(name, Angle::QuarterTurn) => {
                let of = self.interval(&Symbol::Named(name.clone()));
                let inside = |bound: &Option<Bound>, low: bool| {
                    bound
                        .as_ref()
                        .and_then(|b| b.value.as_rational())
                        .is_some_and(|v| {
                            if low {
                                v >= integer(0)
                            } else {
                                v <= integer(1)
                            }
                        })
                };
                let unit = inside(&of.lower, true) && inside(&of.upper, false);
                Interval {
                    lower: closed(if unit { 0 } else { -1 }),
                    upper: closed(1),
                }
            }
            Symbol::Sin(name, _) | Symbol::Cos(name, _) => {
                let of = self.interval(&Symbol::Named(name.clone()));
                turned(&of, matches!(symbol, Symbol::Sin(..)))
            }
            Symbol::Indexed(..) | Symbol::Root(_) | Symbol::Pi => Interval::default(),
        }
    }

    /// The range of the tangent of half the angle of a sine or cosine, if the angle is from 0 to pi.
    #[must_use]
    pub fn half_tangent(&self, symbol: &Symbol) -> Option<Interval> {
        let (Symbol::Sin(name, angle) | Symbol::Cos(name, angle)) = symbol else {
            return None;
        };
        let end = |value: i64, closed: bool| {
            Some(Bound {
                value: Fraction::integer(value),
                closed,
            })
        };
        if *angle == Angle::QuarterTurn {
            let unit = self.interval(symbol);
            let quarter = unit.lower.as_ref().is_some_and(|b| b.value.is_zero());
            return quarter.then_some(Interval {
                lower: end(0, true),
                upper: end(1, true),
            });
        }
        // The cosine decreases from 0 to pi: its range says how far the angle goes.
        let sine = self.interval(&Symbol::Sin(name.clone(), *angle));
        let cosine = self.interval(&Symbol::Cos(name.clone(), *angle));
        let (low, high) = (cosine.lower?, cosine.upper?);
        if !sine.lower.is_some_and(|b| b.value.is_zero()) {
            return None;
        }
        match (low.value.is_zero(), low.closed) {
            (true, closed) => Some(Interval {
                lower: end(0, high.closed),
                upper: end(1, closed),
            }),
            // An angle of pi has no tangent of its half.
            (false, true) => None,
            (false, false) => Some(Interval {
                lower: end(0, high.closed),
                upper: None,
            }),
        }
    }

    /// Whether a symbol is an integer.
    #[must_use]
    pub fn is_integer(&self, symbol: &Symbol) -> bool {
        matches!(symbol, Symbol::Named(name)
            if matches!(self.declarations.symbol(name), Some(SymbolKind::Integer { .. })))
    }

    /// Whether the assumptions imply that this polynomial is not zero: it is, up to a constant, a product
    /// of factors of quantities that are assumed to be different from zero.
    #[must_use]
    pub fn assumes_nonzero(&self, polynomial: &Polynomial) -> bool {
        if polynomial.is_zero() {
            return false;
        }
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

/// The range of the sine or cosine of an angle in radians; sharper where the angle is from 0 to pi.
fn turned(angle: &Interval, sine: bool) -> Interval {
    let end = |value: i64, closed: bool| {
        Some(Bound {
            value: Fraction::integer(value),
            closed,
        })
    };
    let pi = Fraction::symbol(Symbol::Pi);
    let gap = |bound: &Bound, end: &Fraction| bound.value.clone() - end.clone();
    let (Some(low), Some(high)) = (&angle.lower, &angle.upper) else {
        return Interval {
            lower: end(-1, true),
            upper: end(1, true),
        };
    };
    let from_zero = truth(&low.value, Relation::AtLeast) == Some(true);
    let to_pi = truth(&gap(high, &pi), Relation::AtMost) == Some(true);
    if !from_zero || !to_pi {
        return Interval {
            lower: end(-1, true),
            upper: end(1, true),
        };
    }
    // Whether the angle stays away from 0 and from pi.
    let above = !low.closed || truth(&low.value, Relation::Greater) == Some(true);
    let below = !high.closed || truth(&gap(high, &pi), Relation::Less) == Some(true);
    if sine {
        return Interval {
            lower: end(0, !(above && below)),
            upper: end(1, true),
        };
    }
    let right = pi.scaled(&torse_algebra::rational::ratio(1, 2).unwrap_or_default());
    let acute = truth(&gap(high, &right), Relation::AtMost) == Some(true);
    let short = !high.closed || truth(&gap(high, &right), Relation::Less) == Some(true);
    Interval {
        lower: match acute {
            true => end(0, !short),
            false => end(-1, !below),
        },
        upper: end(1, !above),
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

/// How a fraction without free symbols compares with zero: zero is decided by the normal form, the sign of a nonzero number
/// by an enclosure.
#[must_use]
pub fn order(value: &Fraction) -> Option<Ordering> {
    if value.is_zero() {
        return Some(Ordering::Equal);
    }
    match value.as_rational() {
        Some(number) => Some(number.cmp(&Rational::default())),
        None => BITS
            .into_iter()
            .find_map(|bits| enclosure(value, bits).and_then(|ball| ball.sign())),
    }
}

/// Whether `value relation 0` holds, for a fraction without free symbols.
#[must_use]
pub fn truth(value: &Fraction, relation: Relation) -> Option<bool> {
    let order = order(value)?;
    Some(match relation {
        Relation::Equal => order == Ordering::Equal,
        Relation::Different => order != Ordering::Equal,
        Relation::Less => order == Ordering::Less,
        Relation::AtMost => order != Ordering::Greater,
        Relation::Greater => order == Ordering::Greater,
        Relation::AtLeast => order != Ordering::Less,
    })
}
