//! Ranges of single symbols as bounded by the hypotheses, and ranges of tangents of half angles.

use super::assumptions::{Compared, Met};
use super::gap::{Unsupported, Work};
use super::quotient::Quotient;
use std::cell::RefCell;
use std::cmp::Ordering;
use std::collections::BTreeMap;
use torse_certificate::number::{enclosed_ratio, order, ratio_order};
use torse_certificate::polynomial::Polynomial;
use torse_certificate::ratio::Ratio;
use torse_certificate::sign::End;
use torse_certificate::symbol::{Angle, Symbol, Unit};
use torse_numbers::rational::{integer, ratio};
use torse_numbers::{Ball, Rational, Scalar as _};
use torse_syntax::formula::Relation;

/// The precision of the enclosures of tangents, in bits.
const BITS: usize = 192;

/// The numbers that bound a symbol.
#[derive(Debug, Default)]
struct Bounds {
    lower: Vec<(End<Polynomial>, Met)>,
    upper: Vec<(End<Polynomial>, Met)>,
}

/// The bounds of each symbol.
#[derive(Debug, Default)]
pub struct Ranges {
    bounds: BTreeMap<Symbol, Bounds>,
    /// The eliminated symbols whose values the used bounds depend on.
    used: RefCell<Met>,
}

impl Ranges {
    /// The ranges from comparisons that are linear in a single symbol.
    pub fn from_comparisons(all: &[Compared], work: &Work) -> Result<Self, Unsupported> {
        let mut ranges = Self::default();
        for compared in all {
            ranges.add(compared, work)?;
        }
        Ok(ranges)
    }

    fn add(&mut self, compared: &Compared, work: &Work) -> Result<(), Unsupported> {
        let Quotient { above, .. } = &compared.difference;
        let below = compared.difference.denominator(work)?;
        let mut symbols = above.symbols().filter(|s| !s.is_number());
        let Some(symbol @ Symbol::Named(_)) = symbols.next().cloned() else {
            return Ok(());
        };
        if !below.is_number() || symbols.any(|s| *s != symbol) {
            return Ok(());
        }
        let [rest, slope] = &above.coefficients_in(&symbol)[..] else {
            return Ok(());
        };
        let rises = match (order(slope), order(&below)) {
            (Some(Ordering::Greater), Some(Ordering::Greater))
            | (Some(Ordering::Less), Some(Ordering::Less)) => true,
            (Some(_), Some(_)) => false,
            _ => return Ok(()),
        };
        let relation = if rises {
            compared.relation
        } else {
            compared.relation.mirrored()
        };
        let value = Ratio {
            above: rest.negated(),
            below: slope.clone(),
        };
        let closed = matches!(relation, Relation::AtLeast | Relation::AtMost);
        let met = compared.met.clone();
        let bounds = self.bounds.entry(symbol).or_default();
        match relation {
            Relation::Greater | Relation::AtLeast => {
                bounds.lower.push((End { value, closed }, met))
            }
            Relation::Less | Relation::AtMost => bounds.upper.push((End { value, closed }, met)),
            Relation::Equal | Relation::Different => {}
        }
        Ok(())
    }

    /// The eliminated symbols whose values the used bounds depend on.
    pub fn used(&self) -> Met {
        self.used.borrow().clone()
    }

    /// Whether one of the ends has a property; records the eliminated symbols on which that end depends.
    fn any(
        &self,
        ends: &[(End<Polynomial>, Met)],
        holds: impl Fn(&End<Polynomial>) -> bool,
    ) -> bool {
        let found = ends.iter().find(|(end, _)| holds(end));
        if let Some((_, met)) = found {
            self.used.borrow_mut().extend(met.iter().cloned());
        }
        found.is_some()
    }

    /// Whether the symbol is never below `lower` and never above `upper`.
    pub fn side(
        &self,
        symbol: &Symbol,
        lower: Option<&End<Polynomial>>,
        upper: Option<&End<Polynomial>>,
    ) -> bool {
        match symbol {
            Symbol::Sine(name, angle) => {
                return lower.is_none_or(|end| self.turns(name, *angle, 1, end))
                    && upper.is_none_or(|end| self.turns(name, *angle, 3, &negative(end)));
            }
            Symbol::Cosine(name, angle) => {
                return lower.is_none_or(|end| self.turns(name, *angle, 0, end))
                    && upper.is_none_or(|end| self.turns(name, *angle, 2, &negative(end)));
            }
            Symbol::Named(_) | Symbol::Pi | Symbol::Root(_) | Symbol::Exponential(_) => {}
        }
        let known = self.bounds.get(symbol);
        let beyond = |end: &End<Polynomial>, own: &End<Polynomial>, inward: Ordering| {
            let order = gap(&own.value, &end.value);
            order == Some(inward) || (order == Some(Ordering::Equal) && (end.closed || !own.closed))
        };
        let above = |end: &End<Polynomial>| {
            known.is_some_and(|b| self.any(&b.lower, |own| beyond(end, own, Ordering::Greater)))
        };
        let below = |end: &End<Polynomial>| {
            known.is_some_and(|b| self.any(&b.upper, |own| beyond(end, own, Ordering::Less)))
        };
        lower.is_none_or(above) && upper.is_none_or(below)
    }

    /// Whether the cosine of an angle, minus `less` quarter turns, is never below an end that is -1 or 0: the angle
    /// must stay within two quarter turns, or one, of a multiple of four.
    fn turns(&self, name: &str, angle: Angle, less: i64, end: &End<Polynomial>) -> bool {
        let reach = match rational(&end.value) {
            Some(least) if least == integer(-1) && end.closed => return true,
            Some(least) if least == integer(-1) => 2,
            Some(least) if least == integer(0) => 1,
            _ => return false,
        };
        let Some(bounds) = self.bounds.get(&Symbol::named(name)) else {
            return false;
        };
        let fits = |own: &End<Polynomial>, turns: i64, inward: Ordering| {
            let parts = integer(i64::from(angle.parts));
            let end_value = Ratio::from(Polynomial::constant(integer(turns) * parts));
            let order = gap(&quarter_turns(&own.value, angle), &end_value);
            order == Some(inward) || (order == Some(Ordering::Equal) && (end.closed || !own.closed))
        };
        (-8..=8).map(|k: i64| 4 * k + less).any(|middle| {
            let low = |own: &End<Polynomial>| fits(own, middle - reach, Ordering::Greater);
            let high = |own: &End<Polynomial>| fits(own, middle + reach, Ordering::Less);
            self.any(&bounds.lower, low) && self.any(&bounds.upper, high)
        })
    }

    fn starts_at_zero(&self, symbol: &Symbol, closed: bool) -> bool {
        let value = Ratio::from(Polynomial::zero());
        self.side(symbol, Some(&End { value, closed }), None)
    }

    /// Whether the symbol is never negative.
    pub fn is_nonnegative(&self, symbol: &Symbol) -> bool {
        symbol.is_number() || self.starts_at_zero(symbol, true)
    }

    /// Whether the symbol is always positive.
    pub fn is_positive(&self, symbol: &Symbol) -> bool {
        symbol.is_number() || self.starts_at_zero(symbol, false)
    }

    /// Whether the tangent of half of (the angle of a variable minus `from` quarter turns) stays between two ends.
    /// The tangent increases as long as that angle stays within two quarter turns.
    pub fn tangent(
        &self,
        variable: &str,
        angle: Angle,
        from: i64,
        lower: &End<Polynomial>,
        upper: &End<Polynomial>,
    ) -> bool {
        let Some(bounds) = self.bounds.get(&Symbol::named(variable)) else {
            return false;
        };
        let fits = |own: &End<Polynomial>, end: &End<Polynomial>, inward: Ordering| {
            let order = tangent_order(&own.value, angle, from, &end.value);
            order == Some(inward) || (order == Some(Ordering::Equal) && (end.closed || !own.closed))
        };
        self.any(&bounds.lower, |own| fits(own, lower, Ordering::Greater))
            && self.any(&bounds.upper, |own| fits(own, upper, Ordering::Less))
    }
}

/// Compares two numbers.
fn gap(a: &Ratio<Polynomial>, b: &Ratio<Polynomial>) -> Option<Ordering> {
    let left = a.above.times(&b.below);
    let right = b.above.times(&a.below);
    ratio_order(&Ratio {
        above: left.minus(&right),
        below: a.below.times(&b.below),
    })
}

/// The end with the negated number.
fn negative(end: &End<Polynomial>) -> End<Polynomial> {
    End {
        value: Ratio {
            above: end.value.above.negated(),
            below: end.value.below.clone(),
        },
        closed: end.closed,
    }
}

/// A value of a variable, converted to quarter turns of its undivided angle.
fn quarter_turns(value: &Ratio<Polynomial>, angle: Angle) -> Ratio<Polynomial> {
    match angle.unit {
        Unit::QuarterTurn => value.clone(),
        Unit::Radian => Ratio {
            above: value.above.scaled(&integer(2)),
            below: value.below.times(&Polynomial::symbol(Symbol::Pi)),
        },
    }
}

/// Compares the tangent of half of the angle at this value with a number; `None` beyond two quarter turns.
fn tangent_order(
    value: &Ratio<Polynomial>,
    angle: Angle,
    from: i64,
    end: &Ratio<Polynomial>,
) -> Option<Ordering> {
    let parts = ratio(1, i64::from(angle.parts))?;
    // Exact if the value is a rational number of quarter turns.
    let turns = quarter_turns(value, angle);
    if let Some(turns) = rational(&turns) {
        let beyond = turns * &parts - integer(from);
        if let Some(exact) = exact_tangent(&beyond)
            && let order @ Some(_) = gap(&exact, end)
        {
            return order;
        }
    }
    let beyond = enclosed_ratio(&turns, BITS)? * Ball::from_rational(&parts, BITS)
        - Ball::from_rational(&integer(from), BITS);
    let two = integer(2);
    if beyond.lower() <= -two.clone() || beyond.upper() >= two {
        return None;
    }
    // tan(a/2) = sin(a)/(1 + cos(a))
    let (sine, cosine) = beyond.quarter_turn().ok()?;
    let one = Ball::from_rational(&integer(1), BITS);
    let tangent = sine.divided_by(&(one + cosine)).ok()?;
    (tangent - enclosed_ratio(end, BITS)?).sign()
}

/// The rational value of a quotient, if it has one.
fn rational(value: &Ratio<Polynomial>) -> Option<Rational> {
    match (value.above.as_constant(), value.below.as_constant()) {
        (Some(above), Some(below)) if below != integer(0) => Some(above / below),
        _ => {
            let (a, p) = value.above.monic()?;
            let (b, q) = value.below.monic()?;
            (p == q).then(|| a / b)
        }
    }
}

/// The exact tangent of half of a number of quarter turns, if it is in the table.
fn exact_tangent(turns: &Rational) -> Option<Ratio<Polynomial>> {
    let root = |prime: u32| Polynomial::symbol(Symbol::Root(prime));
    let number = |n: i64| Polynomial::constant(integer(n));
    let sixths = turns * integer(6);
    let n = sixths.is_integer().then(|| sixths.to_integer())?;
    let n = i64::try_from(&n).ok()?;
    let size = match n.abs() {
        0 => Polynomial::zero(),
        2 => number(2).minus(&root(3)),
        3 => root(2).minus(&number(1)),
        4 => root(3).scaled(&ratio(1, 3)?),
        6 => number(1),
        8 => root(3),
        9 => root(2).plus(&number(1)),
        _ => return None,
    };
    Some(Ratio::from(if n < 0 { size.negated() } else { size }))
}
