//! The search for a certificate: boxes are halved where the coefficients of the whole do not tell.

use super::bernstein::{Shown, Spread};
use super::certificate::{Certificate, Factor, Piece, Reason, assumed};
use super::coordinates::{Coordinates, Region};
use super::farkas;
use super::samples;
use super::squares::squares;
use crate::decide::domain::Domain;
use crate::decide::order::truth;
use crate::formula::factors;
use std::cmp::Ordering;
use torse_algebra::fault_injection::{InjectedFault, injected};
use torse_algebra::rational::integer;
use torse_algebra::{Polynomial, Rational, Symbol};
use torse_syntax::formula::Relation;

/// How often a nonnegative box is halved to prove it positive.
const STRICT_DEPTH: u32 = 3;
/// The same where assumptions cut the box obliquely.
const STRICT_CUT_DEPTH: u32 = 9;
/// The most boxes examined in one search.
const MAX_BOXES: usize = 200;
/// The same where assumptions cut the box obliquely.
const MAX_CUT_BOXES: usize = 1_000;
/// How often a box is halved in one direction of the search: what is not seen on boxes this small is not seen.
const MAX_DEPTH: u32 = 48;
/// The most sides of a box whose corners are examined.
const MAX_CORNER_SIDES: usize = 8;
/// The most multiples of one assumption that are tried.
const MAX_MULTIPLES: usize = 6;

/// A certificate that the polynomial is nowhere negative on the domain, a strict one where that is found.
///
/// What is cheap comes first: the box alone, an assumption split off or subtracted, and only then the box
/// cut by the assumptions.
#[must_use]
pub fn prove(polynomial: &Polynomial, domain: &Domain<'_>) -> Option<Certificate> {
    let assumed = assumed(domain);
    let mut best = direct(polynomial, domain, &[]);
    let strict = |found: &Option<Certificate>| found.as_ref().is_some_and(|c| c.strict);
    let helpful = |(_, (value, _)): &(usize, &(Polynomial, bool))| value.as_constant().is_none();
    for (number, (value, positive)) in assumed.iter().enumerate().filter(helpful) {
        if strict(&best) {
            return best;
        }
        // p = q c
        if let Some(quotient) = polynomial.exact_quotient(value)
            && let Some(mut found) = direct(&quotient, domain, &[])
        {
            found.strict &= *positive;
            found.factors.push(Factor::Assumed(number));
            best = better(best, found);
        }
        // p = m c + rest
        for multiple in multiples(polynomial, value) {
            if strict(&best) {
                return best;
            }
            let mut rest = polynomial - &value.scaled(&multiple);
            if injected(InjectedFault::CertificateSign) {
                rest = polynomial + &value.scaled(&multiple);
            }
            if let Some(mut found) = direct(&rest, domain, &[]) {
                found.strict |= *positive;
                found.multipliers.push((number, multiple));
                best = better(best, found);
            }
        }
    }
    if !strict(&best)
        && let Some(found) = combination(polynomial, &assumed)
    {
        best = better(best, found);
    }
    if !strict(&best)
        && let Some(found) = squares(polynomial, domain)
    {
        best = better(best, found);
    }
    if !strict(&best)
        && !assumed.is_empty()
        && let Some(found) = direct(polynomial, domain, &assumed)
    {
        best = better(best, found);
    }
    if best.as_ref().is_some_and(|c| !c.strict)
        && let Some(found) = with_positive_term(polynomial, domain)
    {
        best = better(best, found);
    }
    let found = best.or_else(|| without_square(polynomial, domain, &assumed));
    if strict(&found) {
        return found;
    }
    match farkas::combination(polynomial, &assumed) {
        Some(sum) => better(found, sum),
        None => found,
    }
}

/// The most assumptions that are combined, of the first so many.
const MAX_COMBINED: usize = 3;
const MAX_COMBINABLE: usize = 8;

/// The polynomial as a constant plus nonnegative multiples of two or three assumptions: what is short is found at once.
/// [`farkas`] looks for all others.
fn combination(polynomial: &Polynomial, assumed: &[(Polynomial, bool)]) -> Option<Certificate> {
    let useful: Vec<usize> = assumed
        .iter()
        .enumerate()
        .filter(|(_, (p, _))| p.as_constant().is_none() && p.len() <= 12)
        .map(|(number, _)| number)
        .take(MAX_COMBINABLE)
        .collect();
    if polynomial.len() > 12 {
        return None;
    }
    let mut found: Option<Certificate> = None;
    let mut chosen: Vec<Vec<usize>> = vec![vec![]];
    for _ in 0..MAX_COMBINED {
        chosen = chosen
            .iter()
            .flat_map(|few| {
                let last = few.last().copied();
                let later = useful
                    .iter()
                    .filter(move |n| last.is_none_or(|last| **n > last));
                later.map(|n| [few.as_slice(), &[*n]].concat())
            })
            .collect();
        for few in chosen.iter().filter(|few| few.len() > 1) {
            if let Some(certificate) = combined(polynomial, assumed, few) {
                found = better(found, certificate);
            }
        }
        if found.as_ref().is_some_and(|c| c.strict) {
            break;
        }
    }
    found
}

/// The multiples of these assumptions that leave a constant, by elimination.
fn combined(
    polynomial: &Polynomial,
    assumed: &[(Polynomial, bool)],
    numbers: &[usize],
) -> Option<Certificate> {
    let name = |place: usize| Symbol::named(&format!("#{place}"));
    let mut rest = polynomial.clone();
    // Each multiple is carried beside its assumption, so that the elimination can be read off at the end.
    let mut parts: Vec<(Polynomial, Polynomial)> = numbers
        .iter()
        .enumerate()
        .map(|(place, number)| {
            let (part, _) = assumed.get(*number)?;
            Some((part.clone(), Polynomial::symbol(name(place))))
        })
        .collect::<Option<_>>()?;
    let mut goal = Polynomial::zero();
    while let Some((part, own)) = parts.pop() {
        let Some(lead) = part.terms().find(|t| !t.powers.is_empty()) else {
            continue;
        };
        let (powers, below) = (lead.powers.clone(), lead.coefficient.clone());
        let ratio = |p: &Polynomial| {
            let own = p.terms().find(|t| t.powers == powers);
            own.map(|t| t.coefficient / below.clone())
        };
        for (other, of_other) in &mut parts {
            if let Some(factor) = ratio(other) {
                *other = &*other - &part.scaled(&factor);
                *of_other = &*of_other - &own.scaled(&factor);
            }
        }
        if let Some(factor) = ratio(&rest) {
            rest = &rest - &part.scaled(&factor);
            goal = &goal + &own.scaled(&factor);
        }
    }
    let rest = rest.as_constant()?;
    let mut multipliers = vec![];
    let mut strict = rest > integer(0);
    for (place, number) in numbers.iter().enumerate() {
        let name = name(place);
        let own = goal
            .terms()
            .find(|t| matches!(t.powers.as_slice(), [(s, 1)] if **s == name));
        let multiple = own.map_or(integer(0), |t| t.coefficient);
        if multiple < integer(0) {
            return None;
        }
        if multiple > integer(0) {
            strict |= assumed.get(*number)?.1;
            multipliers.push((*number, multiple));
        }
    }
    (rest >= integer(0)).then(|| Certificate {
        strict,
        squares: vec![],
        multipliers,
        factors: vec![],
        rest: Polynomial::constant(&rest),
        pieces: vec![Piece {
            region: vec![],
            reason: Reason::Coefficients,
        }],
    })
}

/// The stronger of two certificates, the first of two equal ones.
fn better(best: Option<Certificate>, found: Certificate) -> Option<Certificate> {
    best.filter(|own| own.strict || !found.strict)
        .or(Some(found))
}

/// The most terms of a sum of which one is sought that is positive.
const MAX_SUM: usize = 8;

/// A certificate that the polynomial is a positive term and a sum of squares.
fn with_positive_term(polynomial: &Polynomial, domain: &Domain<'_>) -> Option<Certificate> {
    if !(2..=MAX_SUM).contains(&polynomial.len()) {
        return None;
    }
    polynomial.terms().find_map(|term| {
        let powers = term.powers.iter();
        let one = powers.fold(
            Polynomial::constant(&term.coefficient),
            |product, (s, e)| &product * &Polynomial::symbol((*s).clone()).power(u32::from(*e)),
        );
        let positive = direct(&one, domain, &[]).filter(|found| found.strict)?;
        let rest = squares(&(polynomial - &one), domain)?;
        let plain = rest.rest.is_zero() && rest.factors.is_empty() && rest.multipliers.is_empty();
        plain.then_some(Certificate {
            squares: rest.squares,
            ..positive
        })
    })
}

/// A certificate with a square split off: where it vanishes inside a box no halving may ever meet.
fn without_square(
    polynomial: &Polynomial,
    domain: &Domain<'_>,
    assumed: &[(Polynomial, bool)],
) -> Option<Certificate> {
    // A factor that is a number, such as a root, would be split off without end.
    let variable = |p: &Polynomial| !p.symbols().iter().all(Symbol::is_number);
    let mut squares = factors(polynomial).into_iter().filter(variable);
    let (root, rest) = squares
        .find_map(|root| Some((root.clone(), polynomial.exact_quotient(&root.power(2))?)))?;
    let mut found =
        direct(&rest, domain, assumed).or_else(|| without_square(&rest, domain, assumed))?;
    found.strict = false;
    found.factors.push(Factor::Square(root));
    Some(found)
}

/// Positive multiples of `value` that cancel a term of the polynomial.
fn multiples(polynomial: &Polynomial, value: &Polynomial) -> Vec<Rational> {
    let mut found: Vec<Rational> = vec![];
    for own in value.terms() {
        for term in polynomial.terms().filter(|term| term.powers == own.powers) {
            let multiple = term.coefficient / own.coefficient.clone();
            if multiple > integer(0) && !found.contains(&multiple) {
                found.push(multiple);
            }
        }
    }
    found.truncate(MAX_MULTIPLES);
    found
}

/// A certificate without multipliers.
fn direct(
    polynomial: &Polynomial,
    domain: &Domain<'_>,
    assumed: &[(Polynomial, bool)],
) -> Option<Certificate> {
    // Symbols that are not negative themselves are split off first.
    let (mut rest, mut factors, mut strict) = (polynomial.clone(), vec![], true);
    for symbol in polynomial.symbols() {
        let Some(lower) = domain.interval(symbol).lower else {
            continue;
        };
        if truth(&lower.value, Relation::AtLeast) != Some(true) {
            continue;
        }
        let factor = Polynomial::symbol(symbol.clone());
        while let Some(quotient) = rest.exact_quotient(&factor) {
            strict &= truth(&lower.value, Relation::Greater) == Some(true) || !lower.closed;
            factors.push(Factor::Symbol(symbol.clone()));
            rest = quotient;
        }
    }
    // Assumptions that say something about the symbols of the rest, and only about bounded ones.
    let useful = |value: &Polynomial| {
        let shared = value.symbols().iter().any(|s| rest.symbols().contains(s));
        shared && Coordinates::new(&[value], domain).is_some()
    };
    let numbers: Vec<usize> = assumed
        .iter()
        .enumerate()
        .filter(|(_, (value, _))| useful(value))
        .map(|(number, _)| number)
        .collect();
    let mut all = vec![&rest];
    all.extend(
        numbers
            .iter()
            .filter_map(|n| assumed.get(*n))
            .map(|(value, _)| value),
    );
    let (mut moved, coordinates) = Coordinates::new(&all, domain)?;
    let target = moved.remove(0);
    let bounds = numbers
        .into_iter()
        .zip(moved)
        .filter_map(|(number, value)| Some((number, -value, assumed.get(number)?.1)))
        .collect::<Vec<_>>();
    let cut = !bounds.is_empty();
    let limits = bounds.iter().map(|(_, negative, _)| negative);
    if samples::refute(&target, limits, &coordinates) {
        return None;
    }
    let bounds = bounds.into_iter().map(|(number, negative, strict)| {
        let spread = Spread::new(&negative, &coordinates)?;
        Some(Limit {
            number,
            strict,
            negative: spread,
        })
    });
    let place = Place {
        region: coordinates.whole(),
        target: Spread::new(&target, &coordinates)?,
        limits: bounds.collect::<Option<_>>()?,
    };
    let mut search = Search {
        place,
        coordinates,
        budget: 0,
        strict_depth: 0,
        pieces: vec![],
    };
    let budget = if cut { MAX_CUT_BOXES } else { MAX_BOXES };
    let may_be_strict = !search.vanishes_at_corner();
    let mut found = search.whole(budget, if may_be_strict { STRICT_DEPTH } else { 0 })?;
    // Where an assumption cuts the box, a zero may lie on the wrong side of the cut.
    if cut
        && may_be_strict
        && !found.0
        && let Some(again) = search.whole(budget, STRICT_CUT_DEPTH)
        && again.0
    {
        found = again;
    }
    let (positive, pieces) = found;
    Some(Certificate {
        strict: strict && positive,
        squares: vec![],
        multipliers: vec![],
        factors,
        rest,
        pieces,
    })
}

/// A region with the polynomials on it.
#[derive(Clone)]
struct Place {
    region: Region,
    target: Spread,
    limits: Vec<Limit>,
}

/// An assumption: its number, its negative, and whether it must not be zero.
#[derive(Clone)]
struct Limit {
    number: usize,
    negative: Spread,
    strict: bool,
}

impl Place {
    /// The halves across the coordinate in which the polynomials bend most, long sides first.
    fn halves(&self) -> Option<[Self; 2]> {
        let widths = self.region.iter().enumerate();
        let weighted = widths.filter_map(|(side, (low, high))| {
            let limits = self.limits.iter().map(|limit| limit.negative.degree(side));
            let degree = limits
                .max()
                .unwrap_or(0)
                .max(self.target.degree(side).saturating_sub(1));
            let degree = i64::try_from(degree).ok()?;
            (degree > 0).then(|| (side, (high - low) * integer(degree)))
        });
        let (side, _) = weighted.reduce(|a, b| if b.1 > a.1 { b } else { a })?;
        let [mut low, mut high] = self.target.halves(side)?.map(|target| Self {
            region: self.region.clone(),
            target,
            limits: Vec::with_capacity(self.limits.len()),
        });
        for limit in &self.limits {
            let [below, above] = limit.negative.halves(side)?;
            low.limits.push(Limit {
                negative: below,
                ..*limit
            });
            high.limits.push(Limit {
                negative: above,
                ..*limit
            });
        }
        let (from, to) = self.region.get(side)?;
        let middle = (from + to) / integer(2);
        low.region.get_mut(side)?.1 = middle.clone();
        high.region.get_mut(side)?.0 = middle;
        Some([low, high])
    }
}

struct Search {
    /// The whole box.
    place: Place,
    coordinates: Coordinates,
    budget: usize,
    strict_depth: u32,
    pieces: Vec<Piece>,
}

impl Search {
    /// Whether the target is zero at a corner of the box that no assumption excludes: then no parts show it positive.
    fn vanishes_at_corner(&self) -> bool {
        let Place {
            region,
            target,
            limits,
        } = &self.place;
        let ends = self.coordinates.closed_ends(region);
        if ends.len() > MAX_CORNER_SIDES {
            return false;
        }
        (0..1_usize << ends.len()).any(|corner| {
            let upper: Vec<bool> = (0..ends.len())
                .map(|side| corner >> side & 1 == 1)
                .collect();
            let closed =
                |(upper, (low, high)): (&bool, &(bool, bool))| *if *upper { high } else { low };
            let order = |spread: &Spread| spread.order_at_corner(&upper, &self.coordinates);
            upper.iter().zip(&ends).all(closed)
                && order(target) == Some(Ordering::Equal)
                && limits.iter().all(|limit| match order(&limit.negative) {
                    Some(Ordering::Less) => true,
                    Some(Ordering::Equal) => !limit.strict,
                    Some(Ordering::Greater) | None => false,
                })
        })
    }

    /// The sign on the whole box, with the pieces that show it.
    fn whole(&mut self, budget: usize, strict_depth: u32) -> Option<(bool, Vec<Piece>)> {
        self.budget = budget;
        self.strict_depth = strict_depth;
        self.pieces.clear();
        let place = self.place.clone();
        let positive = self.run(place, 0)?;
        Some((positive, std::mem::take(&mut self.pieces)))
    }

    /// Whether the target is positive on a part, `None` if it is not shown to be zero or more; the pieces that show it
    /// are added.
    fn run(&mut self, place: Place, depth: u32) -> Option<bool> {
        self.budget = self.budget.checked_sub(1)?;
        let shown = |spread: &Spread| spread.shown(&self.coordinates, &place.region);
        let outside = place
            .limits
            .iter()
            .find(|limit| match shown(&limit.negative) {
                Shown::Positive => true,
                Shown::Nonnegative => limit.strict,
                Shown::NegativeCorner | Shown::Nothing => false,
            });
        if let Some(limit) = outside {
            let reason = Reason::Outside(limit.number);
            self.pieces.push(Piece {
                region: place.region,
                reason,
            });
            return Some(true);
        }
        let whole = match shown(&place.target) {
            Shown::Positive => Some(true),
            Shown::Nonnegative => Some(false),
            Shown::Nothing => None,
            // Without assumptions the corner belongs to the closure of the domain: nothing is left to be found.
            Shown::NegativeCorner => {
                if place.limits.is_empty() {
                    self.budget = 0;
                }
                None
            }
        };
        let before = self.pieces.len();
        // A region that is known to be nonnegative is halved a few times only in search of strictness: a
        // zero of the polynomial would use up all boxes.
        let done = whole == Some(true)
            || (whole == Some(false) && depth >= self.strict_depth)
            || depth >= MAX_DEPTH;
        if !done && let Some([low, high]) = place.halves() {
            let below = self.run(low, depth + 1);
            if let Some(below) = below
                && let Some(above) = self.run(high, depth + 1)
            {
                return Some(below && above);
            }
            self.pieces.truncate(before);
        }
        let (region, reason) = (place.region, Reason::Coefficients);
        whole.inspect(|_| self.pieces.push(Piece { region, reason }))
    }
}
