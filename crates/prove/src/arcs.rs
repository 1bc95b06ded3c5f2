//! Arcs of formulas: symbols w of the interval from `-pi/2` to `pi/2` with `sin(w) == r*cos(w)` or `sin(w) == r`
//! ([`torse_core::Claim::rooted`]).
//!
//! An angle A may be put in the place of w if it has the same tangent or sine and lies in the interval, on the whole domain: the
//! tangent and the sine increase there. The angles that are tried are sums of multiples of those whose sines and cosines the
//! argument is made of, of other arc tangents, and of multiples of `pi/12`. Where they lie is told by the ranges of their parts;
//! those between `-3 pi/2` and `3 pi/2` whose cosine is positive lie in the interval as well.

use crate::decide::domain::Domain;
use crate::decide::interval::{Bound, Interval};
use crate::decide::order::truth;
use crate::decide::sign::{self, Sign};
use torse_algebra::fault_injection::{InjectedFault, injected};
use torse_algebra::rational::{integer, ratio};
use torse_algebra::{Fraction, Polynomial, Rational, Scalar as _, Symbol, Unit};
use torse_certificate::sign::Sign as SignProof;
use torse_core::ArcFunction;
use torse_syntax::formula::Relation;

/// The most terms of an argument that is examined.
const MAX_TERMS: usize = 40;
/// The most angles of which an argument is made.
const MAX_ANGLES: usize = 4;
/// The largest multiple of an angle, and the largest sum of the multiples of several.
const MAX_MULTIPLE: i32 = 4;
const MAX_SUM: i32 = 3;

/// An angle of which arguments are made.
#[derive(Clone)]
struct KnownAngle {
    value: Fraction,
    /// Cosine and sine, both times a positive number.
    pair: Pair,
    range: Interval,
}

/// The real and the imaginary part of a complex number.
type Pair = (Polynomial, Polynomial);

/// The value of an arc in other symbols.
#[derive(Debug, Clone)]
pub struct ArcValue {
    /// The angle.
    pub angle: Fraction,
    /// What shows that it lies where arcs do, if signs do.
    pub signs: Vec<SignProof<Polynomial>>,
}

/// The value of an arc of this argument in other symbols, if it is found.
#[must_use]
pub fn resolved(
    function: ArcFunction,
    argument: &Fraction,
    domain: &Domain<'_>,
) -> Option<ArcValue> {
    let (above, below) = (argument.numerator(), argument.denominator());
    if above.len().max(below.len()) > MAX_TERMS {
        return None;
    }
    if let Some(angle) = opposite_of(function, argument, domain) {
        return Some(ArcValue {
            signs: vec![],
            angle,
        });
    }
    let angles = angles(above, &below, domain);
    if angles.len() > MAX_ANGLES {
        return None;
    }
    let none = KnownAngle {
        value: Fraction::zero(),
        pair: (Polynomial::integer(1), Polynomial::zero()),
        range: point(Fraction::zero()),
    };
    multiples(angles.len()).into_iter().find_map(|multiples| {
        let parts = angles.iter().zip(multiples);
        let sum = parts.fold(none.clone(), |sum, (angle, n)| sum.plus(angle, n));
        let turned = match function {
            ArcFunction::Tangent => of_tangent(&sum, above, &below),
            ArcFunction::Sine => of_sine(&sum, above, &below),
        };
        turned.into_iter().find_map(|angle| {
            let found =
                angle.is_within(function, domain) || injected(InjectedFault::ArcOfAnyBranch);
            found.then(|| ArcValue {
                signs: angle.signs(function, domain).unwrap_or_default(),
                angle: angle.value.without_conditions(),
            })
        })
    })
}

/// The same arc, or that of the opposite argument.
fn opposite_of(
    function: ArcFunction,
    argument: &Fraction,
    domain: &Domain<'_>,
) -> Option<Fraction> {
    let same_kind = domain.arcs.iter().filter(|arc| arc.function == function);
    same_kind.into_iter().find_map(|arc| {
        let own = Fraction::symbol(arc.symbol.clone());
        if (arc.argument.clone() - argument.clone()).is_zero() {
            return Some(own);
        }
        let sum = arc.argument.clone() + argument.clone();
        sum.is_zero().then(|| -own)
    })
}

/// The angles whose sines and cosines occur, and the arc tangents that are left.
fn angles(above: &Polynomial, below: &Polynomial, domain: &Domain<'_>) -> Vec<KnownAngle> {
    let mut seen = vec![];
    let mut found = vec![];
    for symbol in above.symbols().iter().chain(below.symbols()) {
        let (Symbol::Sin(name, angle) | Symbol::Cos(name, angle)) = symbol else {
            continue;
        };
        if seen.contains(&(name, *angle)) {
            continue;
        }
        seen.push((name, *angle));
        let part = Rational::new(1.into(), angle.parts.into());
        let factor = match angle.unit {
            Unit::Radian => Fraction::from(part),
            Unit::QuarterTurn => Fraction::symbol(Symbol::Pi).scaled(&(part / integer(2))),
        };
        let named = Symbol::Named(name.clone());
        let interval = domain.interval(&named);
        let end = |bound: &Option<Bound>| {
            bound.as_ref().map(|own| Bound {
                value: own.value.clone() * factor.clone(),
                closed: own.closed,
            })
        };
        let range = Interval {
            lower: end(&interval.lower),
            upper: end(&interval.upper),
        };
        found.push(KnownAngle {
            value: Fraction::symbol(named) * factor,
            pair: (
                Polynomial::symbol(Symbol::Cos(name.clone(), *angle)),
                Polynomial::symbol(Symbol::Sin(name.clone(), *angle)),
            ),
            range,
        });
    }
    let tangents = domain
        .arcs
        .iter()
        .filter(|arc| arc.function == ArcFunction::Tangent);
    for arc in tangents {
        let (p, q) = (arc.argument.numerator(), arc.argument.denominator());
        if p.len().max(q.len()) > MAX_TERMS {
            continue;
        }
        // The divisor is not zero: the number with the square of it as real part has the angle of the arc.
        found.push(KnownAngle {
            value: Fraction::symbol(arc.symbol.clone()),
            pair: match q.as_constant() {
                Some(number) => (Polynomial::integer(1), p.scaled(&number.recip())),
                None => (&q * &q, p * &q),
            },
            range: domain.interval(&arc.symbol),
        });
    }
    found
}

/// Multiples of so many angles, those that are all zero first, then those of which few are not.
fn multiples(count: usize) -> Vec<Vec<i32>> {
    let mut all: Vec<Vec<i32>> = vec![vec![]];
    for _ in 0..count {
        let longer = all.iter().flat_map(|own| {
            (-MAX_MULTIPLE..=MAX_MULTIPLE).map(move |n| [own.as_slice(), &[n]].concat())
        });
        let is_small = |own: &Vec<i32>| {
            let several = own.iter().filter(|n| **n != 0).count() > 1;
            !several || own.iter().map(|n| n.abs()).sum::<i32>() <= MAX_SUM
        };
        all = longer.filter(is_small).collect();
    }
    all.sort_by_key(|own| own.iter().map(|n| n.abs()).sum::<i32>());
    all
}

/// The angles with this tangent that differ from a sum by a multiple of `pi/12`.
fn of_tangent(sum: &KnownAngle, above: &Polynomial, below: &Polynomial) -> Vec<KnownAngle> {
    // (below + above i) over the sum of the angles.
    let (c, s) = &sum.pair;
    let real = &(below * c) + &(above * s);
    let imaginary = &(above * c) - &(below * s);
    let turns = match (real.is_zero(), imaginary.is_zero()) {
        (_, true) => Some(Fraction::zero()),
        (true, false) => Some(quarter(1)),
        (false, false) => {
            let ratio = Fraction::from(imaginary).over(&real.into()).ok();
            let ratio = ratio.map(Fraction::without_conditions);
            let number = ratio.filter(|r| r.symbols().iter().all(Symbol::is_number));
            number.and_then(|number| number.arctangent().ok())
        }
    };
    let Some(turns) = turns else {
        return vec![];
    };
    [0, 2, -2, 4, -4]
        .into_iter()
        .filter_map(|quarters| sum.turned(&(turns.clone() + quarter(quarters))))
        .collect()
}

/// The angles with this sine that differ from a sum by a multiple of `pi/12`.
fn of_sine(sum: &KnownAngle, above: &Polynomial, below: &Polynomial) -> Vec<KnownAngle> {
    let turned = (-11..=12).filter_map(|n: i64| {
        let turns = Fraction::symbol(Symbol::Pi).scaled(&ratio(n, 12)?);
        sum.turned(&turns)
    });
    let right = turned.filter(|angle| (above - &(below * &angle.pair.1)).is_zero());
    right
        .flat_map(|angle| {
            let whole = |turns: i64| angle.turned(&quarter(4 * turns));
            [0, 1, -1].into_iter().filter_map(whole).collect::<Vec<_>>()
        })
        .collect()
}

fn quarter(n: i64) -> Fraction {
    Fraction::symbol(Symbol::Pi).scaled(&Rational::new(n.into(), 2.into()))
}

fn point(value: Fraction) -> Interval {
    let end = Some(Bound {
        value,
        closed: true,
    });
    Interval {
        lower: end.clone(),
        upper: end,
    }
}

impl KnownAngle {
    /// The angle and n times another one.
    fn plus(self, other: &Self, n: i32) -> Self {
        if n == 0 {
            return self;
        }
        let (c, s) = &other.pair;
        let s = if n < 0 { -s.clone() } else { s.clone() };
        let pair = (0..n.unsigned_abs()).fold(self.pair, |(re, im), _| {
            (&(&re * c) - &(&im * &s), &(&re * &s) + &(&im * c))
        });
        let times = integer(i64::from(n));
        let ends = match n < 0 {
            true => (&other.range.upper, &other.range.lower),
            false => (&other.range.lower, &other.range.upper),
        };
        let end = |own: &Option<Bound>, other: &Option<Bound>| {
            let (own, other) = (own.as_ref()?, other.as_ref()?);
            Some(Bound {
                value: own.value.clone() + other.value.scaled(&times),
                closed: own.closed && other.closed,
            })
        };
        Self {
            value: self.value + other.value.scaled(&times),
            pair,
            range: Interval {
                lower: end(&self.range.lower, ends.0),
                upper: end(&self.range.upper, ends.1),
            },
        }
    }

    /// The angle and a number.
    fn turned(&self, turns: &Fraction) -> Option<Self> {
        let (sine, cosine) = turns.sine_cosine().ok()?;
        let (sine, cosine) = (
            sine.as_polynomial()?.clone(),
            cosine.as_polynomial()?.clone(),
        );
        let other = Self {
            value: turns.clone(),
            pair: (cosine, sine),
            range: point(turns.clone()),
        };
        Some(self.clone().plus(&other, 1))
    }

    /// The signs that show that the angle is a value of the arc.
    fn signs(
        &self,
        function: ArcFunction,
        domain: &Domain<'_>,
    ) -> Option<Vec<SignProof<Polynomial>>> {
        let angle = self.value.as_polynomial()?;
        let shown = |polynomial: &Polynomial, is_strict: bool| {
            let proof = match is_strict {
                true => sign::positive(polynomial, domain),
                false => sign::nonnegative(polynomial, domain),
            };
            proof.filter(|proof| proof.polynomial == *polynomial)
        };
        let within = |quarters: i64, is_strict: bool| {
            let end = quarter(quarters).as_polynomial()?.clone();
            let gaps = [&end + angle, &end - angle];
            let proofs = gaps.iter().map(|gap| shown(gap, is_strict));
            proofs.collect::<Option<Vec<_>>>()
        };
        let is_strict = function == ArcFunction::Tangent;
        within(1, is_strict).or_else(|| {
            let mut all = within(3, true)?;
            all.push(shown(&self.pair.0, is_strict)?);
            Some(all)
        })
    }

    /// Whether the angle is a value of the arc on the whole domain.
    fn is_within(&self, function: ArcFunction, domain: &Domain<'_>) -> bool {
        let closed = function == ArcFunction::Sine;
        let lies = |quarters: i64, closed: bool| {
            let (Some(lower), Some(upper)) = (&self.range.lower, &self.range.upper) else {
                return false;
            };
            let above = |bound: &Bound, gap: Fraction| {
                let relation = match closed || !bound.closed {
                    true => Relation::AtLeast,
                    false => Relation::Greater,
                };
                truth(&gap, relation) == Some(true)
            };
            above(lower, lower.value.clone() + quarter(quarters))
                && above(upper, quarter(quarters) - upper.value.clone())
        };
        if lies(1, closed) {
            return true;
        }
        if !lies(3, false) || self.pair.0.len() > MAX_TERMS {
            return false;
        }
        match sign::sign(&self.pair.0, domain).or_else(|| stated_sign(&self.pair.0, domain)) {
            Some(Sign::Positive) => true,
            Some(Sign::Nonnegative) => closed || domain.assumes_nonzero(&self.pair.0),
            _ => false,
        }
    }
}

/// The sign of a polynomial that is the numerator of a constraint but for a number.
fn stated_sign(polynomial: &Polynomial, domain: &Domain<'_>) -> Option<Sign> {
    domain.constraints.iter().find_map(|constraint| {
        let factor = constraint.value.numerator().exact_quotient(polynomial)?;
        let below = constraint.value.denominator();
        let rest = sign::sign(&(&factor * &below), domain)?;
        let stated = match constraint.relation {
            Relation::Greater => Sign::Positive,
            Relation::AtLeast => Sign::Nonnegative,
            Relation::Less => Sign::Negative,
            Relation::AtMost => Sign::Nonpositive,
            Relation::Equal | Relation::Different => return None,
        };
        match rest {
            Sign::Positive => Some(stated),
            Sign::Negative => Some(stated.negated()),
            Sign::Nonnegative | Sign::Nonpositive => None,
        }
    })
}
