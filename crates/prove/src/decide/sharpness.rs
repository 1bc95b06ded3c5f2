//! Whether the ranges of a proved order relation are the largest possible.
//!
//! A symbol leaves its range by small steps at each end. If the relation then fails at an exact point,
//! the range cannot be widened so far; if it is proved on the wider range, the range says too much. The
//! points are sought in the coordinates of the proof of sign, where a variable under a quarter turn is
//! given by the tangent of half its angle, so that sine and cosine are exact.

use super::domain::Domain;
use super::order::truth;
use super::sign::coordinates::Coordinates;
use super::sign::prove;
use super::value::quotient;
use crate::evaluate::value::Statement;
use std::sync::Arc;
use torse_algebra::rational::{integer, ratio};
use torse_algebra::{Fraction, Polynomial, Rational, Symbol};
use torse_certificate::Ratio;
use torse_certificate::proof::assumptions::Sharpness;
use torse_syntax::derivation::declarations::{Bound, Interval, SymbolKind};
use torse_syntax::formula::{Connective, Relation};

/// How far a range is left, one after the other.
const STEPS: [(i64, i64); 3] = [(1, 1024), (1, 16), (1, 1)];
/// The most points tried for one step.
const MAX_POINTS: usize = 1_200;
/// Longer polynomials are not examined.
const MAX_TERMS: usize = 120;

/// A polynomial that is shown to be zero or more, or more than zero.
#[derive(Debug, Clone)]
pub struct Bounded {
    /// The polynomial.
    pub polynomial: Polynomial,
    /// Whether zero is excluded.
    pub strict: bool,
}

/// What is shown of polynomials where a statement is proved.
#[derive(Debug, Clone)]
pub struct Bounds {
    /// The statement fails where one of these does.
    pub needed: Vec<Bounded>,
    /// The statement is true where all of `needed` and all of these hold; none if that is not known.
    pub besides: Option<Vec<Bounded>>,
}

impl Bounds {
    /// All that a proof has to show, if it is known.
    fn sufficient(&self) -> Option<Vec<&Bounded>> {
        let besides = self.besides.as_ref()?;
        Some(self.needed.iter().chain(besides).collect())
    }
}

/// What a conjunction of order relations bounds; nothing for other statements.
#[must_use]
pub fn bounds(statement: &Statement) -> Bounds {
    let bounded = bounded(statement);
    Bounds {
        besides: bounded.is_some().then(Vec::new),
        needed: bounded.unwrap_or_default(),
    }
}

/// What a conjunction of order relations between polynomials bounds; none for other statements.
fn bounded(statement: &Statement) -> Option<Vec<Bounded>> {
    match statement {
        Statement::Join(Connective::And, a, b) => Some([bounded(a)?, bounded(b)?].concat()),
        Statement::Compare {
            relation,
            left,
            right,
        } => {
            let (strict, negative) = match relation {
                Relation::Less => (true, true),
                Relation::AtMost => (false, true),
                Relation::Greater => (true, false),
                Relation::AtLeast => (false, false),
                Relation::Equal | Relation::Different => return None,
            };
            let (lefts, rights) = (left.entries(), right.entries());
            let pairs = lefts.into_iter().zip(rights);
            let bounded = pairs.map(|(x, y)| {
                let difference = x.as_fraction()?.clone() - y.as_fraction()?.clone();
                let polynomial = difference.as_polynomial()?.clone();
                let polynomial = if negative { -polynomial } else { polynomial };
                Some(Bounded { polynomial, strict })
            });
            bounded.collect()
        }
        _ => None,
    }
}

/// What leaving the ranges of the parameters at each end leads to.
#[must_use]
pub fn all(bounds: &Bounds, domain: &Domain<'_>) -> Vec<Sharpness<Polynomial>> {
    let all: Vec<&Bounded> = bounds
        .needed
        .iter()
        .chain(bounds.besides.iter().flatten())
        .collect();
    if all.iter().any(|b| b.polynomial.len() > MAX_TERMS) {
        return vec![];
    }
    // Without any bound a symbol stands for its square in the proof of sign: its values could not be told.
    let unbounded = |s: &Symbol| {
        let interval = domain.interval(s);
        let number = s.is_number();
        !number && interval.lower.is_none() && interval.upper.is_none()
    };
    if all
        .iter()
        .any(|b| b.polynomial.symbols().iter().any(unbounded))
    {
        return vec![];
    }
    let mut names: Vec<&str> = vec![];
    for symbol in all.iter().flat_map(|b| b.polynomial.symbols()) {
        // What stands for a root has no range of its own.
        if let Symbol::Named(name) = symbol
            && !name.contains('(')
            && !names.contains(&&**name)
        {
            names.push(name);
        }
    }
    // A variable under a turn has the range of its angle, which is no range of a parameter.
    let turns = |name: &str| {
        let mut symbols = all.iter().flat_map(|b| b.polynomial.symbols());
        symbols.any(|s| !matches!(s, Symbol::Named(_)) && s.depends_on(name))
    };
    let mut found = vec![];
    for name in names.into_iter().filter(|name| !turns(name)) {
        let Some(SymbolKind::Real(interval)) = domain.declarations.symbol(name) else {
            continue;
        };
        for upper in [false, true] {
            let end = if upper {
                &interval.upper
            } else {
                &interval.lower
            };
            let end = end.as_ref().and_then(|b| b.value.as_rational());
            found.extend(end.and_then(|end| beyond(bounds, domain, name, interval, end, upper)));
        }
    }
    found
}

/// What happens beyond one end.
fn beyond(
    bounds: &Bounds,
    domain: &Domain<'_>,
    name: &str,
    interval: &Interval,
    end: &Rational,
    upper: bool,
) -> Option<Sharpness<Polynomial>> {
    for (n, d) in STEPS {
        let step = ratio(n, d)?;
        let there = if upper { end + &step } else { end - &step };
        let mut needed = bounds.needed.iter();
        if let Some(others) = needed.find_map(|b| failure(b, domain, name, &there)) {
            return Some(Sharpness::Fails {
                name: name.to_owned(),
                by: step,
                at: there,
                others,
            });
        }
    }
    let sufficient = bounds.sufficient()?;
    let step = ratio(1, 16)?;
    let there = if upper { end + &step } else { end - &step };
    let bound = Bound {
        value: there.clone().into(),
        closed: true,
    };
    let mut wider = interval.clone();
    *(if upper {
        &mut wider.upper
    } else {
        &mut wider.lower
    }) = Some(bound);
    let declarations = domain
        .declarations
        .with_symbol(name, SymbolKind::Real(Box::new(wider)));
    let wider = domain.on(&declarations);
    let holds = sufficient.iter().all(|b| {
        prove(&b.polynomial, &wider).is_some_and(|certificate| certificate.strict || !b.strict)
    });
    holds.then(|| Sharpness::Wider {
        name: name.to_owned(),
        to: there,
    })
}

/// The other coordinates of a point with this value of the symbol at which the bound fails.
fn failure(
    bounded: &Bounded,
    domain: &Domain<'_>,
    name: &str,
    value: &Rational,
) -> Option<Vec<(String, Ratio<Polynomial>)>> {
    // Points that assumptions exclude are no counterexamples.
    if !domain.constraints.is_empty() {
        return None;
    }
    let at = Fraction::from(bounded.polynomial.clone())
        .at(name, &value.clone().into())
        .ok()?;
    let polynomial = at.as_polynomial()?.clone();
    let (moved, coordinates) = Coordinates::new(&[&polynomial], domain)?;
    let moved = moved.into_iter().next()?;
    let sides: Vec<&Symbol> = coordinates.sides.iter().map(|side| &side.symbol).collect();
    // Only independent real coordinates lead back to a point: no integers, no sine beside its cosine, no exponential, no
    // tangent of a half angle beside the angle itself.
    let torn = |side: &Symbol| {
        let turn = matches!(side, Symbol::Sin(..) | Symbol::Cos(..) | Symbol::Exp(_));
        let mut angles = coordinates.tangents.iter();
        let inside = |(_, name, _): &_| *side == Symbol::Named(Arc::clone(name));
        turn || domain.is_integer(side) || angles.any(inside)
    };
    let free = |s: &Symbol| !s.is_number() && !sides.contains(&s);
    if sides.iter().any(|side| torn(side)) || moved.symbols().iter().any(free) {
        return None;
    }
    let wrong = if bounded.strict {
        Relation::AtMost
    } else {
        Relation::Less
    };
    let parts = match sides.len() {
        0 | 1 => 32_usize,
        2 => 16,
        3 => 8,
        _ => 2,
    };
    let count = (0..sides.len()).try_fold(1_usize, |n, _| n.checked_mul(parts + 1))?;
    for number in 0..count.min(MAX_POINTS) {
        let mut rest = number;
        let mut point = vec![];
        for _ in &sides {
            point.push(ratio(
                i64::try_from(rest % (parts + 1)).ok()?,
                i64::try_from(parts).ok()?,
            )?);
            rest /= parts + 1;
        }
        let place = |s: &Symbol| {
            let position = sides.iter().position(|side| *side == s)?;
            point.get(position).map(Polynomial::constant)
        };
        let open = coordinates.sides.iter().zip(&point).any(|(side, t)| {
            (*t == integer(0) && !side.lower_closed) || (*t == integer(1) && !side.upper_closed)
        });
        if !open && truth(&moved.substituted(place).into(), wrong) == Some(true) {
            let shown = sides.iter().zip(&point);
            let all = shown.filter_map(|(symbol, t)| described(symbol, t, &coordinates, domain));
            return Some(all.collect());
        }
    }
    None
}

/// The name of a coordinate with its value: a symbol, or the tangent of half an angle.
fn described(
    symbol: &Symbol,
    t: &Rational,
    coordinates: &Coordinates,
    domain: &Domain<'_>,
) -> Option<(String, Ratio<Polynomial>)> {
    let own = coordinates.tangents.iter().find(|(own, ..)| own == symbol);
    let (text, interval) = match own {
        None => (symbol.to_string(), domain.interval(symbol)),
        Some((_, name, angle)) => {
            let half = domain.half(name, *angle)?;
            (half.text(name, *angle), half.tangent)
        }
    };
    let (a, b) = interval.lower.zip(interval.upper)?;
    let width = b.value - a.value.clone();
    let value = a.value + width * Fraction::from(t.clone());
    Some((text, quotient(&value)))
}
