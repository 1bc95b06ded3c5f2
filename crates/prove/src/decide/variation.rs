//! Variation diminution: a curve crosses no line more often than its control polygon.
//!
//! **Theorem** (Schoenberg 1930). If all minors of the collocation matrices `(f_i(x_j))`, x_0 < x_1 < ...,
//! are nonnegative (the functions are *totally positive*), every combination of the functions has at most
//! as many changes of sign as its coefficients; for functions that sum to one this is variation
//! diminution.
//!
//! **Powers.** Let the seeds be `s_l = c_l s a^(d-l) b^l` with the step factors a, b. Then the functions of
//! degree k are the coefficients of `s a^k C(E) (1 + u E)^(k-d)` with `u = b/a` and E replaced by `u E` in
//! `C(E) = sum c_l E^l`: `s a^k u^i` times positive numbers, if all c_l > 0. Their minors are those of
//! generalised Vandermonde matrices times positive factors, nonnegative if u increases and a, b, s >= 0.
//! So they are totally positive at every degree; if u decreases they are on the reversed curve.
//!
//! **One degree.** Functions that are rational in one variable t with a common positive denominator have
//! minors that are polynomials, divisible by the differences of the places. Total positivity is then the
//! nonnegativity of the quotients on a cube, for which there are certificates ([`super::sign`]).
//!
//! **Some degrees.** Where the statement names degrees, and the step is `1 - x`, `x`, Wronskians decide: [`torse_certificate::wronskian`].
//!
//! **No induction.** The step multiplies the collocation matrix with different bidiagonal matrices at
//! different places, and that need not keep it totally positive: from the rows (1, v) it leads to
//! (1, u + v, u v), totally positive for increasing u and v only if u v is a convex function of u + v. So
//! higher degrees are only searched for pairs of functions whose quotient is not monotone: they give a
//! curve that changes sign twice over control values with one change.

use super::candidates::{Turns, simplest_between};
use super::domain::Domain;
use super::family::{DEGREES, family, functions, nonnegative_part, parameter_points};
use super::order::{enclosure, truth};
use super::sign;
use super::value::{Proof, quotient};
use super::{Decision, Refutation, Unsettled, witness, wronskian};
use crate::evaluate::Evaluator;
use torse_algebra::rational::integer;
use torse_algebra::{Angle, Fraction, Matrix, Polynomial, Rational, Scalar as _, Symbol};
use torse_certificate::Ratio;
use torse_certificate::family::Powers;
use torse_certificate::point::{Counterexample, Failure};
use torse_core::{Degrees, Family};
use torse_syntax::derivation::declarations::{Bound, Interval, SymbolKind};
use torse_syntax::fault::Fault;
use torse_syntax::formula::Relation;

/// The most seeds whose minors are examined.
const MAX_SEEDS: usize = 5;

/// Decides whether the functions of every degree diminish variation.
///
/// # Errors
/// [`Fault`] when the seeds cannot be evaluated.
pub fn diminishing(
    basis: &Family,
    degrees: Option<Degrees>,
    domain: &Domain<'_>,
    evaluator: &Evaluator<'_>,
) -> Result<Decision, Fault> {
    let (step, seeds) = family(basis, evaluator)?;
    let one = Fraction::integer(1);
    let sum_to_one = |parts: &[Fraction]| {
        let total = parts
            .iter()
            .cloned()
            .fold(Fraction::zero(), |sum, f| sum + f);
        (total - one.clone()).is_zero()
    };
    if !sum_to_one(&seeds) || !sum_to_one(&step) {
        return Ok(not_affine(basis, degrees, domain, &step, &seeds));
    }
    if let Some(powers) = powers(&step, &seeds, basis.variable(), domain) {
        return Ok(Decision::Proven(Proof::Powers(powers)));
    }
    let mut tried = vec![];
    let mut reason = "total positivity is not proved for every degree".to_owned();
    if let Some(degrees) = degrees {
        match wronskian::positive(basis, degrees, &step, &seeds, domain) {
            Ok(proof) => return Ok(Decision::Proven(Proof::Wronskians(proof))),
            Err(why) => reason = format!("total positivity is not proved: {why}"),
        }
    } else if let Some(minors) = totally_positive(&seeds, basis.variable(), domain) {
        tried.push(format!(
            "degree {}: totally positive for all shape parameters, by certificates of sign for all {minors} minors",
            basis.degree
        ));
    }
    let variable = Symbol::named(basis.variable());
    let mut places = domain.candidates(&variable, Turns::Quarter(1));
    let is_less =
        |x: &Fraction, y: &Fraction| truth(&(x.clone() - y.clone()), Relation::Less) == Some(true);
    places.sort_by(|x, y| is_less(y, x).cmp(&is_less(x, y)));
    for raise in raises(basis, degrees) {
        let degree = basis.degree + raise;
        let row = functions(&step, &seeds, raise);
        for point in parameter_points(basis, domain) {
            let fixed: Option<Vec<Fraction>> =
                row.iter().map(|f| witness::at_point(f, &point)).collect();
            let Some(fixed) = fixed else { continue };
            let Some(found) = two_changes(&fixed, basis.variable(), &places) else {
                continue;
            };
            let point = Counterexample {
                at: witness::values(&point),
                others: vec![],
                failure: Failure::Turning {
                    degree: u32::from(degree),
                    control: found.control,
                    places: found.places,
                    values: found.values,
                },
            };
            return Ok(Decision::Refuted(Box::new(Refutation::at(point))));
        }
        tried.push(format!(
            "degree {degree}: the quotients of all pairs of functions are monotone at simple places"
        ));
    }
    Ok(Decision::Open(Unsettled {
        reason,
        instances: vec![],
        tried,
    }))
}

/// How far above the seeds refutations are sought: the first degrees of those that the statement is about.
fn raises(basis: &Family, degrees: Option<Degrees>) -> std::ops::Range<u8> {
    match degrees {
        None => 0..DEGREES,
        Some(degrees) => {
            let first = degrees.least.saturating_sub(basis.degree);
            let last = degrees.most.saturating_sub(basis.degree);
            first..last.saturating_add(1).min(first.saturating_add(DEGREES))
        }
    }
}

/// Functions that do not sum to one move the curve of a constant polygon, or leave the unit interval: where a curve is on
/// both sides of a level beyond all control values, it crosses a line that the polygon does not meet.
fn not_affine(
    basis: &Family,
    degrees: Option<Degrees>,
    domain: &Domain<'_>,
    step: &[Fraction; 2],
    seeds: &[Fraction],
) -> Decision {
    let variable = Symbol::named(basis.variable());
    let places = domain.candidates(&variable, Turns::Quarter(1));
    let (zero, one) = (Fraction::zero(), Fraction::integer(1));
    for raise in raises(basis, degrees) {
        let row = functions(step, seeds, raise);
        let sum = row.iter().cloned().fold(zero.clone(), |sum, f| sum + f);
        let single = row.into_iter().enumerate();
        let single = single.map(|(i, function)| (Some(i), function, &zero));
        let curves: Vec<(Option<usize>, Fraction, &Fraction)> =
            std::iter::once((None, sum, &one)).chain(single).collect();
        for point in parameter_points(basis, domain) {
            for (control, curve, least) in &curves {
                let at = |place: &Fraction| {
                    let mut all = point.clone();
                    all.insert(variable.clone(), place.clone());
                    Some((place.clone(), witness::at_point(curve, &all)?))
                };
                let values: Vec<(Fraction, Fraction)> = places.iter().filter_map(at).collect();
                let Some(crossing) = beyond(&values, least, &one) else {
                    continue;
                };
                let Crossing { low, high, level } = crossing;
                let pair = |(x, value): &(Fraction, Fraction)| (quotient(x), quotient(value));
                return Decision::Refuted(Box::new(Refutation::at(Counterexample {
                    at: witness::values(&point),
                    others: vec![],
                    failure: Failure::Beyond {
                        degree: u32::from(basis.degree + raise),
                        control: *control,
                        low: pair(&low),
                        high: pair(&high),
                        level: quotient(&level),
                    },
                })));
            }
        }
    }
    Decision::open(
        "the functions do not sum to one",
        &["the curves of a constant polygon and of single control values"],
    )
}

/// A level that a curve crosses between two places.
struct Crossing {
    /// A place, and the value below the level there.
    low: (Fraction, Fraction),
    /// A place, and the value above.
    high: (Fraction, Fraction),
    level: Fraction,
}

/// Two of these places and values, with a level between the values that lies above the greatest or below the least control
/// value.
fn beyond(
    values: &[(Fraction, Fraction)],
    least: &Fraction,
    greatest: &Fraction,
) -> Option<Crossing> {
    let exceeds = |x: &Fraction, y: &Fraction| {
        truth(&(x.clone() - y.clone()), Relation::Greater) == Some(true)
    };
    let half = torse_algebra::rational::ratio(1, 2)?;
    let middle = |x: &Fraction, y: &Fraction| (x.clone() + y.clone()).scaled(&half);
    for (x, low) in values {
        for (y, high) in values {
            if !exceeds(high, low) {
                continue;
            }
            let level = if exceeds(high, greatest) {
                middle(
                    high,
                    if exceeds(low, greatest) {
                        low
                    } else {
                        greatest
                    },
                )
            } else if exceeds(least, low) {
                middle(low, if exceeds(least, high) { high } else { least })
            } else {
                continue;
            };
            return Some(Crossing {
                low: (x.clone(), low.clone()),
                high: (y.clone(), high.clone()),
                level,
            });
        }
    }
    None
}

/// What shows that the seeds are positive multiples of `s a^(d-l) b^l`, all of them nonnegative, with b/a
/// monotone.
fn powers(
    step: &[Fraction; 2],
    seeds: &[Fraction],
    variable: &str,
    domain: &Domain<'_>,
) -> Option<Powers<Polynomial>> {
    let [a, b] = step;
    let proportional = seeds.windows(2).all(|pair| {
        let [low, high] = pair else { return false };
        let Ok(ratio) = (high.clone() * a.clone()).over(&(low.clone() * b.clone())) else {
            return false;
        };
        truth(&ratio, Relation::Greater) == Some(true)
    });
    if !proportional {
        return None;
    }
    let slope = b.derivative(variable) * a.clone() - b.clone() * a.derivative(variable);
    let monotone = |slope: &Fraction| nonnegative_part(slope, false, domain);
    let slope = monotone(&slope).or_else(|| monotone(&-slope))?;
    let factors = [a, b].into_iter().map(|p| (false, p));
    let all = factors.chain(seeds.iter().map(|p| (true, p)));
    let parts = all.map(|(is_seed, p)| nonnegative_part(p, is_seed, domain));
    Some(Powers {
        parts: parts.collect::<Option<_>>()?,
        slope: Box::new(slope),
    })
}

/// The number of minors, if certificates of sign show all of them to be nonnegative.
fn totally_positive(seeds: &[Fraction], variable: &str, domain: &Domain<'_>) -> Option<usize> {
    let turn = Symbol::Cos(variable.into(), Angle::QUARTER_TURN);
    let quarter = domain.interval(&turn).lower?.value.is_zero();
    if !quarter || seeds.len() > MAX_SEEDS {
        return None;
    }
    let seeds = over_common_denominator(seeds, variable)?;
    let places: Vec<String> = (0..seeds.len())
        .map(|i| format!("{variable}{i}\u{bd}"))
        .collect();
    let unit = |value| {
        Some(Bound {
            value: integer(value).into(),
            closed: true,
        })
    };
    let unit = SymbolKind::Real(Box::new(Interval {
        lower: unit(0),
        upper: unit(1),
        ..Interval::default()
    }));
    let declarations = places
        .iter()
        .fold(domain.declarations.clone(), |all, place| {
            all.with_symbol(place, unit.clone())
        });
    let cube = domain.on(&declarations);
    let half = Symbol::named(&format!("{variable}\u{bd}"));
    let mut count = 0;
    for chosen in subsets(seeds.len()) {
        let rows = places.iter().take(chosen.len()).map(|place| {
            let t = Polynomial::named(place);
            let at = |p: &Polynomial| p.substituted(|s| (*s == half).then(|| t.clone()));
            let row = chosen.iter().filter_map(|i| seeds.get(*i));
            row.map(|p| Fraction::from(at(p))).collect()
        });
        let determinant = Matrix::from_rows(rows.collect()).ok()?.determinant().ok()?;
        let mut quotient = determinant.as_polynomial()?.clone();
        for (j, later) in places.iter().enumerate().take(chosen.len()) {
            for earlier in places.iter().take(j) {
                let gap = &Polynomial::named(later) - &Polynomial::named(earlier);
                quotient = quotient.exact_quotient(&gap)?;
            }
        }
        let certificate = sign::prove(&quotient, &cube)?;
        sign::certificate::check(&quotient, &cube, &certificate).ok()?;
        count += 1;
    }
    Some(count)
}

/// The functions in the tangent of half the angle, times their common denominator: polynomials in the
/// symbol `variable\u{bd}`.
fn over_common_denominator(seeds: &[Fraction], variable: &str) -> Option<Vec<Polynomial>> {
    let t = Fraction::named(&format!("{variable}\u{bd}"));
    let one = Fraction::integer(1);
    let below = one.clone() + t.clone() * t.clone();
    let sine = t.scaled(&integer(2)).over(&below).ok()?;
    let cosine = (one - t.clone() * t).over(&below).ok()?;
    let moved: Vec<Fraction> = seeds
        .iter()
        .map(|seed| {
            let moved = seed.substituted(|s| match s {
                Symbol::Sin(n, Angle::QUARTER_TURN) if **n == *variable => Some(sine.clone()),
                Symbol::Cos(n, Angle::QUARTER_TURN) if **n == *variable => Some(cosine.clone()),
                _ => None,
            });
            moved.ok()
        })
        .collect::<Option<_>>()?;
    // A variable that stands outside of the turn as well is no function of the tangent here.
    if moved
        .iter()
        .any(|f| f.symbols().iter().any(|s| s.depends_on(variable)))
    {
        return None;
    }
    let factors = moved.iter().flat_map(Fraction::denominator_factors);
    let exponent = factors.map(|(_, n)| n).max().unwrap_or(0);
    let common = (0..exponent).fold(Fraction::integer(1), |p, _| p * below.clone());
    let cleared = moved
        .into_iter()
        .map(|f| (f * common.clone()).as_polynomial().cloned());
    cleared.collect()
}

/// The nonempty sets of numbers below `count`, ascending.
fn subsets(count: usize) -> Vec<Vec<usize>> {
    (1..1_usize << count)
        .map(|mask| (0..count).filter(|i| mask >> i & 1 == 1).collect())
        .collect()
}

/// Control values with one change of sign, and places between which the curve changes sign twice.
struct Changes {
    control: [(usize, Ratio<Polynomial>); 2],
    places: [Ratio<Polynomial>; 3],
    values: [Ratio<Polynomial>; 3],
}

/// Two functions whose quotient rises and falls: with a number r between its values, `f_j - r f_i` changes
/// sign twice.
fn two_changes(functions: &[Fraction], variable: &str, places: &[Fraction]) -> Option<Changes> {
    let values: Vec<Vec<Fraction>> = functions
        .iter()
        .map(|f| places.iter().map(|x| f.at(variable, x).ok()).collect())
        .collect::<Option<_>>()?;
    for (j, upper) in values.iter().enumerate() {
        for (i, lower) in values.iter().enumerate().take(j) {
            // Where the quotient is defined.
            let both = lower.iter().zip(upper).zip(places);
            let defined: Vec<((&Fraction, &Fraction), &Fraction)> = both
                .filter(|((f, _), _)| truth(f, Relation::Greater) == Some(true))
                .collect();
            for [(a, x), (b, y), (c, z)] in triples(&defined) {
                let Some(between) = turning(&[*a, *b, *c]) else {
                    continue;
                };
                let value = |(f, g): (&Fraction, &Fraction)| g.clone() - f.clone().scaled(&between);
                let one = Fraction::integer(1);
                return Some(Changes {
                    control: [(i, quotient(&(-&between).into())), (j, quotient(&one))],
                    places: [x, y, z].map(|x| quotient(x)),
                    values: [*a, *b, *c].map(|pair| quotient(&value(pair))),
                });
            }
        }
    }
    None
}

/// Three of a list, in its order.
fn triples<T>(all: &[T]) -> impl Iterator<Item = [&T; 3]> {
    all.iter().enumerate().flat_map(move |(k, last)| {
        let before = all.get(..k).unwrap_or_default();
        before.iter().enumerate().flat_map(move |(j, middle)| {
            let first = before.get(..j).unwrap_or_default();
            first.iter().map(move |first| [first, middle, last])
        })
    })
}

/// A simple positive number between the middle one of three quotients g/f and both others, if these lie on
/// one side of it.
fn turning(pairs: &[(&Fraction, &Fraction); 3]) -> Option<Rational> {
    let [a, b, c] = pairs.map(|(f, g)| {
        let quotient = enclosure(g, 128)?.divided_by(&enclosure(f, 128)?).ok()?;
        Some((quotient.lower(), quotient.upper()))
    });
    let ((a, above_a), (b, above_b), (c, above_c)) = (a?, b?, c?);
    let over = simplest_between(&above_a.max(above_c), &b);
    let found = over.or_else(|| simplest_between(&above_b, &a.min(c)));
    found.filter(|r| *r > integer(0))
}

#[cfg(test)]
mod tests {
    use super::*;
    use torse_algebra::rational::ratio;

    #[test]
    fn a_turning_value_is_positive_and_between_the_quotients() {
        let one = Fraction::integer(1);
        let found = |numerators: [i64; 3]| {
            let quotients = numerators.map(|n| Fraction::from(ratio(n, 4).unwrap()));
            turning(&quotients.each_ref().map(|g| (&one, g)))
        };
        assert_eq!(found([1, 3, 1]), ratio(1, 2));
        assert_eq!(found([3, 1, 3]), ratio(1, 2));
        assert_eq!(found([1, 2, 3]), None);
        // They turn, but between negative fractions below one in size.
        assert_eq!(found([-3, -1, -3]), None);
        assert_eq!(found([-1, -3, -1]), None);
    }
}
