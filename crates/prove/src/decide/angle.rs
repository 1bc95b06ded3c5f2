//! Where the angles of sines and cosines run, and the tangent of their half.
//!
//! Angles are counted in quarter turns, where ends that are multiples of pi, or of a variable under `pi/2*x`, are
//! rational numbers; other ends are moved outward to rational ones, which makes the domain larger and proves more than
//! is asked. About the multiple m of a quarter turn that is nearest to the middle, `t = tan((angle - m)/2)` increases,
//! and sine and cosine are rational functions of it. An angle that runs too far for that is cut in [`Domain::parts`].

use super::domain::Domain;
use super::interval::{Bound, Interval, Part};
use super::order::enclosure;
use num_traits::Signed;
use std::cmp::Ordering;
use torse_algebra::rational::{integer, ratio};
use torse_algebra::{
    Angle, Ball, Finest, Fraction, Integer, Polynomial, Rational, Scalar as _, Symbol, Unit,
};

/// Bits of the enclosures of ends.
const BITS: usize = 128;
/// Ends that are moved become multiples of a 2^-20th.
const GRAIN: i64 = 1 << 20;
/// The most parts into which the angles of a polynomial cut the domain.
const MAX_PARTS: usize = 16;

/// An end of an angle: quarter turns, and whether it belongs to the domain.
type End = (Rational, bool);

/// The interval of an angle in quarter turns; a missing end is infinite.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct Turning {
    /// Where it begins.
    pub lower: Option<End>,
    /// Where it ends.
    pub upper: Option<End>,
}

/// An angle by the tangent of half its distance from a multiple of a quarter turn.
#[derive(Debug, Clone)]
pub struct Half {
    /// The multiple of a quarter turn that the angle is measured from.
    pub from: Integer,
    /// The range of the tangent.
    pub tangent: Interval,
}

impl Half {
    /// The tangent as a formula: `tan(pi/4*x)`, `tan(t/2 - 1/4*pi)`.
    #[must_use]
    pub fn text(&self, name: &str, angle: Angle) -> String {
        let parts = u32::from(angle.parts);
        let half = match angle.unit {
            Unit::QuarterTurn => format!("pi/{}*{name}", 4 * parts),
            Unit::Radian => format!("{name}/{}", 2 * parts),
        };
        let from = Rational::new(self.from.clone(), 4.into());
        match from.cmp(&Rational::default()) {
            Ordering::Equal => format!("tan({half})"),
            Ordering::Greater => format!("tan({half} - {from}*pi)"),
            Ordering::Less => format!("tan({half} + {}*pi)", -from),
        }
    }

    /// Sine and cosine of the angle, where the tangent is t.
    #[must_use]
    pub fn sine_cosine(&self, t: &Fraction) -> Option<(Fraction, Fraction)> {
        let one = Fraction::integer(1);
        let below = one.clone() + t.clone() * t.clone();
        let sine = t.scaled(&integer(2)).over(&below).ok()?;
        let cosine = (one - t.clone() * t.clone()).over(&below).ok()?;
        let quarters = torse_algebra::rational::remainder(&self.from, &Integer::from(4));
        Some(match i64::try_from(quarters).ok()? {
            0 => (sine, cosine),
            1 => (cosine, -sine),
            2 => (-sine, -cosine),
            _ => (-cosine, sine),
        })
    }
}

impl Domain<'_> {
    /// Where the angle of a sine or cosine runs.
    #[must_use]
    pub fn turning(&self, name: &str, angle: Angle) -> Turning {
        let own = Symbol::Cos(name.into(), angle);
        let part = self.part.iter().find(|(symbol, _)| *symbol == own);
        let interval = match part {
            Some((_, interval)) => interval.clone(),
            None => self.interval(&Symbol::named(name)),
        };
        let end = |bound: &Option<Bound>, up| {
            let bound = bound.as_ref()?;
            let (quarters, exact) = quarters(&bound.value, angle, up)?;
            Some((quarters, bound.closed || !exact))
        };
        Turning {
            lower: end(&interval.lower, false),
            upper: end(&interval.upper, true),
        }
    }

    /// The range of a sine or cosine.
    #[must_use]
    pub fn range_of_turn(&self, name: &str, angle: Angle, sine: bool) -> Interval {
        let turning = self.turning(name, angle);
        // The sine is the cosine of a quarter turn less.
        turning.shifted(-i64::from(sine)).cosine()
    }

    /// The tangent of half the angle of a sine or cosine, if the angle runs through less than three quarter turns.
    #[must_use]
    pub fn half(&self, name: &str, angle: Angle) -> Option<Half> {
        let turning = self.turning(name, angle);
        let ((low, lower_closed), (high, upper_closed)) = (turning.lower?, turning.upper?);
        let half = ratio(1, 2)?;
        // The nearest integer to the middle, the lower of two.
        let from = ((&low + &high) * &half - &half).ceil();
        let reach = ratio(3, 2)?;
        let (low, high) = (low - &from, high - &from);
        if low > high || low < -reach.clone() || high > reach {
            return None;
        }
        let (lower, lower_exact) = tangent(&low, false)?;
        let (upper, upper_exact) = tangent(&high, true)?;
        Some(Half {
            from: from.to_integer(),
            tangent: Interval {
                lower: Some(Bound {
                    value: lower,
                    closed: lower_closed || !lower_exact,
                }),
                upper: Some(Bound {
                    value: upper,
                    closed: upper_closed || !upper_exact,
                }),
            },
        })
    }

    /// Parts that together are the domain, in each of which the angles of the polynomial run less far; nothing if that
    /// is no help.
    #[must_use]
    pub fn parts(&self, polynomial: &Polynomial) -> Vec<Domain<'_>> {
        let finest = Finest::new(polynomial.symbols().iter());
        let mut cut: Vec<(&str, Angle)> = vec![];
        for symbol in polynomial.symbols() {
            if let Symbol::Sin(name, angle) | Symbol::Cos(name, angle) = symbol
                && finest.value(symbol).is_none()
                && !cut.contains(&(name, *angle))
                && self.half(name, *angle).is_none()
            {
                cut.push((name, *angle));
            }
        }
        let mut parts = vec![self.clone()];
        for (name, angle) in cut {
            let halves = self.halves(name, angle);
            parts = parts
                .into_iter()
                .flat_map(|part| {
                    let with = move |half: &Part| {
                        let mut part = part.clone();
                        part.part.push(half.clone());
                        part
                    };
                    halves.iter().map(with).collect::<Vec<_>>()
                })
                .collect();
            if parts.len() > MAX_PARTS {
                return vec![];
            }
        }
        if parts.len() < 2 {
            return vec![];
        }
        parts
    }

    /// Two intervals in which an angle runs: those of the variable, or of a whole turn where it runs further.
    fn halves(&self, name: &str, angle: Angle) -> [Part; 2] {
        let turning = self.turning(name, angle);
        let bound = |quarters: &Rational| {
            let value = quarters * integer(i64::from(angle.parts));
            let value = match angle.unit {
                Unit::QuarterTurn => Fraction::from(value),
                Unit::Radian => Fraction::symbol(Symbol::Pi).scaled(&(value / integer(2))),
            };
            Some(Bound {
                value,
                closed: true,
            })
        };
        let between = |low: i64, high: i64| {
            let interval = Interval {
                lower: bound(&integer(low)),
                upper: bound(&integer(high)),
            };
            (Symbol::Cos(name.into(), angle), interval)
        };
        let (Some((low, _)), Some((high, _))) = (turning.lower, turning.upper) else {
            return [between(-1, 1), between(1, 3)];
        };
        if &high - &low > integer(4) {
            return [between(-1, 1), between(1, 3)];
        }
        let middle = ((low + high) / integer(2)).round();
        let named = Symbol::named(name);
        let whole = self.interval(&named);
        let first = Interval {
            upper: bound(&middle),
            ..whole.clone()
        };
        let second = Interval {
            lower: bound(&middle),
            ..whole
        };
        [(named.clone(), first), (named, second)]
    }
}

impl Turning {
    /// The same angles and so many quarter turns.
    fn shifted(&self, quarters: i64) -> Self {
        let end = |end: &Option<End>| {
            let (turns, closed) = end.as_ref()?;
            Some((turns + integer(quarters), *closed))
        };
        Self {
            lower: end(&self.lower),
            upper: end(&self.upper),
        }
    }

    /// The range of the cosine: sharp signs, and otherwise from -1 to 1.
    fn cosine(&self) -> Interval {
        let end = |value: i64, closed: bool| {
            Some(Bound {
                value: Fraction::integer(value),
                closed,
            })
        };
        let all = Interval {
            lower: end(-1, true),
            upper: end(1, true),
        };
        let (Some((low, low_closed)), Some((high, high_closed))) = (&self.lower, &self.upper)
        else {
            return all;
        };
        // The whole turns before the angle begins, counted from half a turn before zero.
        let turns = ((low + integer(2)) / integer(4)).floor() * integer(4);
        let (low, high) = (low - &turns, high - turns);
        // Whether the angles stay on one side of a multiple of a quarter turn, and do not reach it.
        let after = |n| low >= integer(n);
        let before = |n| high <= integer(n);
        let leaves = |n| low > integer(n) || !low_closed;
        let stops = |n| high < integer(n) || !high_closed;
        match () {
            // Increasing from -1 to 1.
            () if before(0) => Interval {
                lower: if after(-1) {
                    end(0, !leaves(-1))
                } else {
                    end(-1, !leaves(-2))
                },
                upper: if before(-1) {
                    end(0, !stops(-1))
                } else {
                    end(1, !stops(0))
                },
            },
            // Decreasing from 1 to -1.
            () if after(0) && before(2) => Interval {
                lower: if before(1) {
                    end(0, !stops(1))
                } else {
                    end(-1, !stops(2))
                },
                upper: if after(1) {
                    end(0, !leaves(1))
                } else {
                    end(1, !leaves(0))
                },
            },
            () if after(-1) && before(1) => Interval {
                lower: end(0, !(leaves(-1) && stops(1))),
                upper: end(1, true),
            },
            () if after(1) && before(3) => Interval {
                lower: end(-1, true),
                upper: end(0, !(leaves(1) && stops(3))),
            },
            () => all,
        }
    }
}

/// The angle in quarter turns at a value of its variable, moved up or down to a rational number where it is none, and
/// whether it is exact.
fn quarters(value: &Fraction, angle: Angle, up: bool) -> Option<(Rational, bool)> {
    let part = integer(i64::from(angle.parts));
    if angle.unit == Unit::QuarterTurn
        && let Some(exact) = value.as_rational()
    {
        return Some((exact / part, true));
    }
    let pi = Fraction::symbol(Symbol::Pi);
    let turns = match angle.unit {
        Unit::QuarterTurn => value.clone(),
        Unit::Radian => value.scaled(&integer(2)).over(&pi).ok()?,
    }
    .scaled(&part.recip());
    match turns.as_rational() {
        Some(exact) => Some((exact, true)),
        None => Some((moved(&enclosure(&turns, BITS)?, up), false)),
    }
}

/// The multiple of a grain below or above everything in a ball.
fn moved(ball: &Ball, up: bool) -> Rational {
    let grain = integer(GRAIN);
    if up {
        (ball.upper() * &grain).ceil() / grain
    } else {
        (ball.lower() * &grain).floor() / grain
    }
}

/// The tangent of half of an angle between -2 and 2 quarter turns, and whether it is exact; otherwise moved up or down.
fn tangent(quarters: &Rational, up: bool) -> Option<(Fraction, bool)> {
    if quarters.is_negative() {
        let (opposite, exact) = tangent(&-quarters, !up)?;
        return Some((-opposite, exact));
    }
    let root = |prime: u32| Fraction::symbol(Symbol::Root(prime));
    let sixths = quarters * integer(6);
    let known = sixths.is_integer().then(|| sixths.to_integer());
    let known = known.and_then(|n| i64::try_from(n).ok());
    let exact = match known {
        Some(0) => Fraction::zero(),
        Some(2) => Fraction::integer(2) - root(3),
        Some(3) => root(2) - Fraction::integer(1),
        Some(4) => root(3).scaled(&ratio(1, 3)?),
        Some(6) => Fraction::integer(1),
        Some(8) => root(3),
        Some(9) => root(2) + Fraction::integer(1),
        _ => {
            let (sine, cosine) = Ball::from_rational(quarters, BITS).quarter_turn().ok()?;
            let below = cosine.one_like() + cosine;
            let ball = sine.divided_by(&below).ok()?;
            return Some((moved(&ball, up).into(), false));
        }
    };
    Some((exact, true))
}
