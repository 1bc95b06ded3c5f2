//! Combinations of control points: collected by point, or by differences of neighbours where the
//! coefficients sum to zero (a vector) or to a number (a point plus a vector).
//!
//! By Abel summation, coefficients c_0, ..., c_n of sum zero give
//! `sum c_j P_j = sum d_j (P_j - P_(j+1))` with `d_j = c_0 + ... + c_j`.

use super::build::{Summand, positive_first, sum, symbol};
use super::factor::Factored;
use super::shape::ratio;
use num_traits::{One, Signed};
use std::collections::BTreeMap;
use torse_algebra::{Polynomial, Rational, Symbol, rational};
use torse_syntax::formula::{Expr, Operator};

/// A control point and its coefficient.
type Weighted = (Symbol, Polynomial);

/// What a coefficient multiplies.
enum Target {
    Point(Symbol),
    /// The first minus the second; may be turned round.
    Difference(Symbol, Symbol),
    /// The first and the last minus twice the middle one.
    Second([Symbol; 3]),
}

/// The fraction `p / below` as summands over control points; `None` if there is no control point or
/// some term has more than one.
pub(super) fn combination(p: &Polynomial, below: &Factored) -> Option<Vec<Summand>> {
    let (families, rest) = linear(p)?;
    let mut all: Vec<Summand> = families
        .iter()
        .flat_map(|family| best(family, below))
        .collect();
    if !rest.is_zero() {
        all.push(ratio(&Factored::new(&rest), below, None));
    }
    Some(positive_first(all))
}

/// Splits a polynomial that is linear in its control points by families, and into what has none.
fn linear(p: &Polynomial) -> Option<(Vec<Vec<Weighted>>, Polynomial)> {
    let is_point = |symbol: &Symbol| matches!(symbol, Symbol::Indexed(..));
    let degree = |powers: &[(&Symbol, u16)]| {
        let points = powers.iter().filter(|(symbol, _)| is_point(symbol));
        points.map(|(_, n)| u32::from(*n)).sum::<u32>()
    };
    let points: Vec<&Symbol> = p.symbols().iter().filter(|s| is_point(s)).collect();
    if points.is_empty() || p.terms().any(|term| degree(&term.powers) > 1) {
        return None;
    }
    let mut families: Vec<Vec<Weighted>> = vec![];
    let mut rest = p.clone();
    for point in points {
        let mut coefficients = rest.coefficients_in(point).into_iter();
        rest = coefficients.next()?;
        let weighted = (point.clone(), coefficients.next()?);
        match families.last_mut() {
            Some(family) if family.first().is_some_and(|(s, _)| same_family(s, point)) => {
                family.push(weighted);
            }
            _ => families.push(vec![weighted]),
        }
    }
    Some((families, rest))
}

fn same_family(a: &Symbol, b: &Symbol) -> bool {
    matches!((a, b), (Symbol::Indexed(x, _), Symbol::Indexed(y, _)) if x == y)
}

/// The shortest of the ways to write one family.
fn best(family: &[Weighted], below: &Factored) -> Vec<Summand> {
    let size = |terms: &[Summand]| sum(terms.to_vec()).size();
    let points = family
        .iter()
        .map(|(point, c)| (Target::Point(point.clone()), c.clone()));
    let plain = weighted(points.collect(), below);
    let total = family.iter().fold(Polynomial::zero(), |t, (_, c)| &t + c);
    if total.is_zero() {
        let vectors = vectors(family, below);
        return vectors.into_iter().fold(plain, |best, other| {
            if size(&other) < size(&best) {
                other
            } else {
                best
            }
        });
    }
    // With positive coefficients it is a blend of points, else a point and a vector, from either end.
    let blend = family
        .iter()
        .all(|(_, c)| Factored::new(c).content.is_positive());
    let share = total
        .exact_quotient(&below.expanded())
        .and_then(|q| q.as_constant());
    let Some(share) = share.filter(|_| !blend) else {
        return plain;
    };
    [family.len() - 1, 0]
        .into_iter()
        .flat_map(|end| anchored(family, end, &total, &share, below))
        .fold(plain, |best, other| {
            if size(&other) <= size(&best) {
                other
            } else {
                best
            }
        })
}

/// Ways to write a combination whose coefficients sum to zero: by first differences, or by a second
/// difference and first ones.
fn vectors(family: &[Weighted], below: &Factored) -> Vec<Vec<Summand>> {
    let mut all = vec![weighted(differences(family), below)];
    if let [(a, first), (b, _), (c, last)] = family {
        // first (a - b) + last (c - b): what the two have in common belongs to a - 2 b + c.
        let shared = shared_terms(first, last);
        let of = |p: &Symbol, q: &Symbol| Target::Difference(p.clone(), q.clone());
        let parts = vec![
            (
                Target::Second([a.clone(), b.clone(), c.clone()]),
                shared.clone(),
            ),
            (of(a, b), first - &shared),
            (of(c, b), last - &shared),
        ];
        all.push(weighted(parts, below));
    }
    all
}

/// The terms that two polynomials have in common.
fn shared_terms(a: &Polynomial, b: &Polynomial) -> Polynomial {
    let b: BTreeMap<_, _> = b
        .terms()
        .map(|term| (term.powers, term.coefficient))
        .collect();
    a.terms()
        .filter(|term| b.get(&term.powers) == Some(&term.coefficient))
        .map(|term| {
            let constant = Polynomial::constant(&term.coefficient);
            term.powers.iter().fold(constant, |product, (symbol, n)| {
                &product * &Polynomial::symbol((*symbol).clone()).power(u32::from(*n))
            })
        })
        .fold(Polynomial::zero(), |sum, term| &sum + &term)
}

/// `share * P_end + differences`.
fn anchored(
    family: &[Weighted],
    end: usize,
    total: &Polynomial,
    share: &Rational,
    below: &Factored,
) -> Option<Vec<Summand>> {
    let mut family = family.to_vec();
    let (anchor, coefficient) = family.get_mut(end)?;
    *coefficient = &*coefficient - total;
    let whole = Factored {
        content: share.clone(),
        factors: vec![],
    };
    let one = Factored::product(std::iter::empty());
    let mut terms = vec![ratio(&whole, &one, Some(symbol(anchor)))];
    family.retain(|(_, coefficient)| !coefficient.is_zero());
    let vector = vectors(&family, below);
    terms.extend(
        vector
            .into_iter()
            .min_by_key(|terms| sum(terms.clone()).size())?,
    );
    Some(terms)
}

/// Abel summation; the coefficients sum to zero.
fn differences(family: &[Weighted]) -> Vec<(Target, Polynomial)> {
    let mut running = Polynomial::zero();
    let mut all = vec![];
    for ((point, coefficient), (next, _)) in family.iter().zip(family.iter().skip(1)) {
        running = &running + coefficient;
        let target = Target::Difference(point.clone(), next.clone());
        all.push((target, running.clone()));
    }
    all
}

/// `common / below * (sum of coefficient * target)`.
fn weighted(mut parts: Vec<(Target, Polynomial)>, below: &Factored) -> Vec<Summand> {
    let one = Factored::product(std::iter::empty());
    parts.retain(|(_, c)| !c.is_zero());
    if parts.is_empty() {
        return vec![];
    }
    if let [(target, c)] = parts.as_slice() {
        return vec![placed(&Factored::new(c), below, target)];
    }
    let common = parts.iter().fold(Polynomial::zero(), |g, (_, c)| g.gcd(c));
    let quotients: Option<Vec<Polynomial>> = parts
        .iter()
        .map(|(_, c)| c.exact_quotient(&common))
        .collect();
    let (common, quotients) = match quotients {
        Some(quotients) => (common, quotients),
        None => (
            Polynomial::integer(1),
            parts.iter().map(|(_, c)| c.clone()).collect(),
        ),
    };
    let mut common = Factored::new(&common);
    // The number before the bracket is positive, the signs are inside.
    let content = content(&quotients);
    let sign = common.content.signum() * below.content.signum();
    let inner = content.recip() * sign;
    common.content = common.content.abs() * content * below.content.signum();
    let terms = parts
        .iter()
        .zip(&quotients)
        .map(|((target, _), c)| placed(&Factored::new(&c.scaled(&inner)), &one, target));
    let mut terms = positive_first(terms.collect());
    if common.content.is_one() && common.factors.is_empty() && below.factors.is_empty() {
        return terms;
    }
    if terms.iter().all(|term| term.negative) {
        common.content = -common.content;
        terms.iter_mut().for_each(|term| term.negative = false);
    }
    vec![ratio(&common, below, Some(sum(terms)))]
}

/// The positive rational number that leaves coprime integer coefficients.
fn content(all: &[Polynomial]) -> Rational {
    // All coefficients in one polynomial, kept apart by powers of a symbol of no name.
    let mark = Polynomial::named("");
    let joined = all
        .iter()
        .fold(Polynomial::zero(), |sum, p| &(&sum * &mark) + p);
    joined.primitive().0.abs()
}

/// One coefficient times its target; a difference is turned so that the coefficient is positive.
fn placed(factor: &Factored, below: &Factored, target: &Target) -> Summand {
    let turned = (&factor.content / &below.content).is_negative();
    match target {
        Target::Point(point) => ratio(factor, below, Some(symbol(point))),
        Target::Second([a, b, c]) => {
            let two = Expr::number(&rational::integer(2));
            let middle = two.with(Operator::Multiply, symbol(b));
            let second = symbol(a).with(Operator::Subtract, middle);
            ratio(factor, below, Some(second.with(Operator::Add, symbol(c))))
        }
        Target::Difference(a, b) => {
            let (a, b) = if turned { (b, a) } else { (a, b) };
            let difference = symbol(a).with(Operator::Subtract, symbol(b));
            Summand {
                negative: false,
                ..ratio(factor, below, Some(difference))
            }
        }
    }
}
