//! Signs of polynomials of one variable, under comparisons of the same variable: they change at real roots alone.
//!
//! All polynomials at hand are written as products of factors without common or repeated roots. The line is halved until each
//! piece has one root of them at most (Descartes' rule in Vincent's form; it ends by Obreshkoff's two circles theorem), and on
//! each part the signs are known.

use super::Sign;
use super::proof::{Proof, Shown};
use crate::decide::domain::Domain;
use crate::decide::interval::Bound;
use crate::decide::real_symbol::RealSymbol;
use crate::decide::value::{plain, plain_symbol, quotient};
use std::cmp::Ordering;
use torse_algebra::rational::integer;
use torse_algebra::{Polynomial, Rational, Symbol};
use torse_certificate::Polynomial as Plain;
use torse_certificate::line::{self as written, Cell, Product, Span, Within};
use torse_certificate::number::holds;
use torse_certificate::sign::End;
use torse_syntax::formula::Relation;

/// The highest degree, the most constraints, and the most cuts of the line.
const MAX_DEGREE: u16 = 40;
const MAX_CONSTRAINTS: usize = 16;
const MAX_CUTS: usize = 160;

/// A line in the polynomials of this room.
pub(super) type Line = written::Line<Polynomial>;

/// A sign of the polynomial on those points of the domain at which these divisors do not vanish, by the comparisons of its one
/// variable; the constraints are used only where the sign needs them.
pub(super) fn proof(
    polynomial: &Polynomial,
    domain: &Domain<'_>,
    divisors: &[Polynomial],
) -> Option<(Sign, Proof)> {
    let variable = variable(polynomial, domain)?;
    let bounds = bounds(&variable, domain, divisors)?;
    let alone = if bounds.is_empty() {
        None
    } else {
        shown(polynomial, &variable, vec![])
            .filter(|(sign, _)| matches!(sign, Sign::Positive | Sign::Negative))
    };
    alone.or_else(|| shown(polynomial, &variable, bounds))
}

/// A sign that is not zero.
pub(super) fn strict(
    polynomial: &Polynomial,
    domain: &Domain<'_>,
    divisors: &[Polynomial],
) -> Option<(Sign, Proof)> {
    let wanted = |(sign, _): &(Sign, Proof)| matches!(sign, Sign::Positive | Sign::Negative);
    proof(polynomial, domain, divisors).filter(wanted)
}

/// That the polynomial is zero or more.
pub(super) fn not_negative(
    polynomial: &Polynomial,
    domain: &Domain<'_>,
    divisors: &[Polynomial],
) -> Option<(Sign, Proof)> {
    let wanted = |(sign, _): &(Sign, Proof)| matches!(sign, Sign::Positive | Sign::Nonnegative);
    proof(polynomial, domain, divisors).filter(wanted)
}

/// What bounds the line.
pub(super) struct Limit {
    /// What is compared with zero: numerator and denominator.
    pub above: Polynomial,
    pub below: Polynomial,
    pub relation: Relation,
    pub is: Origin,
}

/// Where a bound comes from.
pub(super) enum Origin {
    Constraint(usize),
    End(End<Polynomial>, bool),
    Divisor,
}

/// The only symbol of a polynomial that is no number, if it is a real one.
pub(super) fn variable(polynomial: &Polynomial, domain: &Domain<'_>) -> Option<RealSymbol> {
    let mut symbols = polynomial.symbols().iter().filter(|s| !s.is_number());
    let variable = symbols.next()?;
    let fits = !matches!(variable, Symbol::Exp(_)) && polynomial.degree_in(variable) <= MAX_DEGREE;
    let is_alone = symbols.next().is_none() && fits;
    is_alone
        .then(|| RealSymbol::new(variable, domain))
        .flatten()
}

/// Everything that the domain says of the variable alone.
pub(super) fn bounds(
    variable: &RealSymbol,
    domain: &Domain<'_>,
    divisors: &[Polynomial],
) -> Option<Vec<Limit>> {
    let variable = variable.symbol();
    if !domain.part.is_empty() {
        return None;
    }
    let own = |p: &Polynomial| {
        let alone = p.symbols().iter().all(|s| s == variable || s.is_number());
        alone && p.degree_in(variable) <= MAX_DEGREE
    };
    let mut all = vec![];
    let interval = domain.interval(variable);
    for (bound, is_lower) in [(&interval.lower, true), (&interval.upper, false)] {
        let Some(Bound { value, closed }) = bound else {
            continue;
        };
        let end = End {
            value: quotient(value),
            closed: *closed,
        };
        let offset = &(&Polynomial::symbol(variable.clone()) * &end.value.below) - &end.value.above;
        let relation = match (is_lower, closed) {
            (true, true) => Relation::AtLeast,
            (true, false) => Relation::Greater,
            (false, true) => Relation::AtMost,
            (false, false) => Relation::Less,
        };
        if own(&offset) && own(&end.value.below) && end.value.below.degree_in(variable) == 0 {
            all.push(Limit {
                above: offset,
                below: end.value.below.clone(),
                relation,
                is: Origin::End(end, is_lower),
            });
        }
    }
    for (place, constraint) in domain.constraints.iter().enumerate() {
        let (above, below) = (constraint.value.numerator(), constraint.value.denominator());
        let says = above.degree_in(variable) > 0 || below.degree_in(variable) > 0;
        // What differs from zero may be a divisor of a hypothesis, which is none itself.
        let is_divisor = constraint.relation == Relation::Different && below.is_constant();
        if says && own(above) && own(&below) {
            all.push(Limit {
                above: above.clone(),
                below,
                relation: constraint.relation,
                is: match is_divisor {
                    true => Origin::Divisor,
                    false => Origin::Constraint(place),
                },
            });
        }
    }
    for divisor in divisors {
        if divisor.degree_in(variable) > 0 && own(divisor) {
            all.push(Limit {
                above: divisor.clone(),
                below: Polynomial::integer(1),
                relation: Relation::Different,
                is: Origin::Divisor,
            });
        }
    }
    all.truncate(MAX_CONSTRAINTS);
    Some(all)
}

/// A line, and how its bounds compare with zero.
pub(super) struct Made {
    pub line: Line,
    pub relations: Vec<(Relation, Product<Plain>, Product<Plain>)>,
}

/// The line with all these bounds.
pub(super) fn made(
    polynomial: &Polynomial,
    variable: &RealSymbol,
    bounds: Vec<Limit>,
) -> Option<Made> {
    let variable = variable.symbol();
    let limits = bounds.iter().flat_map(|limit| [&limit.above, &limit.below]);
    let all: Vec<&Polynomial> = std::iter::once(polynomial).chain(limits).collect();
    let factors = basis(&all, variable)?;
    let product = |p: &Polynomial| product(p, &factors, variable);
    let symbol = plain_symbol(variable);
    let plains: Vec<Plain> = factors.iter().map(plain).collect();
    let (mut within, mut relations) = (vec![], vec![]);
    for limit in bounds {
        let (above, below) = (product(&limit.above)?, product(&limit.below)?);
        relations.push((limit.relation, above.map(&plain), below.map(&plain)));
        within.push(match limit.is {
            Origin::Constraint(constraint) => Within::Constraint {
                constraint,
                above,
                below,
            },
            Origin::End(end, is_lower) => Within::End {
                value: end.value,
                closed: end.closed,
                is_lower,
                offset: above,
            },
            Origin::Divisor => Within::Nonzero {
                divisor: limit.above,
                product: above,
            },
        });
    }
    let line = Line {
        variable: symbol.clone(),
        cuts: cuts(&plains, &symbol)?,
        target: product(polynomial)?,
        factors,
        within,
    };
    Some(Made { line, relations })
}

/// The sign of the polynomial on the line with all these bounds.
fn shown(
    polynomial: &Polynomial,
    variable: &RealSymbol,
    bounds: Vec<Limit>,
) -> Option<(Sign, Proof)> {
    let Made {
        mut line,
        relations,
    } = made(polynomial, variable, bounds)?;
    let plain_line = line.map(&plain);
    let (mut less, mut equal, mut greater) = (false, false, false);
    for cell in plain_line.cells().ok()? {
        if !is_inside(&relations, &cell)? {
            continue;
        }
        match plain_line.target.sign_on(&cell)? {
            Ordering::Less => less = true,
            Ordering::Equal => equal = true,
            Ordering::Greater => greater = true,
        }
    }
    let sign = match (less, equal, greater) {
        (true, _, true) => return None,
        (false, false, _) => Sign::Positive,
        (false, true, _) => Sign::Nonnegative,
        (true, false, false) => Sign::Negative,
        (true, true, false) => Sign::Nonpositive,
    };
    let mut own = polynomial.clone();
    if less {
        own = -&own;
        line.target.content = -&line.target.content;
    }
    let strict = matches!(sign, Sign::Positive | Sign::Negative);
    let proof = Proof {
        polynomial: own,
        shown: Shown::Line(Box::new(line), strict),
    };
    Some((sign, proof))
}

/// Whether the points of a cell are looked at.
pub(super) fn is_inside(
    bounds: &[(Relation, Product<Plain>, Product<Plain>)],
    cell: &Cell,
) -> Option<bool> {
    for (relation, above, below) in bounds {
        let (above, below) = (above.sign_on(cell)?, below.sign_on(cell)?);
        let sign = match below {
            Ordering::Equal => return Some(false),
            Ordering::Greater => above,
            Ordering::Less => above.reverse(),
        };
        if !holds(sign, *relation) {
            return Some(false);
        }
    }
    Some(true)
}

/// Polynomials without repeated roots and without common ones, of which all these are products, up to numbers.
fn basis(all: &[&Polynomial], variable: &Symbol) -> Option<Vec<Polynomial>> {
    let mut basis: Vec<Polynomial> = vec![];
    let mut pending: Vec<Polynomial> = vec![];
    for p in all {
        pending.push((*p).clone());
        while let Some(p) = pending.pop() {
            let (p, repeated) = squarefree(&primitive(&p, variable), variable)?;
            if p.degree_in(variable) == 0 {
                continue;
            }
            // Roots of different multiplicity stand in different factors.
            pending.extend(repeated);
            let mut rest = p;
            let mut next = vec![];
            for own in &basis {
                let common = primitive(&rest.gcd(own), variable);
                if common.degree_in(variable) == 0 {
                    next.push(own.clone());
                    continue;
                }
                let other = primitive(&own.exact_quotient(&common)?, variable);
                rest = primitive(&rest.exact_quotient(&common)?, variable);
                next.extend(
                    [common, other]
                        .into_iter()
                        .filter(|p| p.degree_in(variable) > 0),
                );
            }
            if rest.degree_in(variable) > 0 {
                next.push(rest);
            }
            basis = next;
        }
    }
    basis.sort();
    Some(basis)
}

/// The polynomial without what its coefficients have in common.
fn primitive(p: &Polynomial, variable: &Symbol) -> Polynomial {
    let (_, primitive) = p.primitive();
    let coefficients = primitive.coefficients_in(variable);
    let content = coefficients
        .iter()
        .fold(Polynomial::zero(), |g, c| g.gcd(c));
    match primitive.exact_quotient(&content) {
        Some(own) if !content.is_constant() => own.primitive().1,
        _ => primitive,
    }
}

/// The polynomial with each root once, and what is left of it if roots are repeated.
fn squarefree(p: &Polynomial, variable: &Symbol) -> Option<(Polynomial, Option<Polynomial>)> {
    if p.degree_in(variable) < 2 {
        return Some((p.clone(), None));
    }
    let common = primitive(&p.gcd(&p.partial(variable)), variable);
    if common.degree_in(variable) == 0 {
        return Some((p.clone(), None));
    }
    let own = p.exact_quotient(&common)?;
    Some((primitive(&own, variable), Some(common)))
}

/// A polynomial as a product of the factors; `None` if it is none, and for zero.
fn product(
    p: &Polynomial,
    factors: &[Polynomial],
    variable: &Symbol,
) -> Option<Product<Polynomial>> {
    if p.is_zero() {
        return None;
    }
    let (mut content, mut exponents) = (p.clone(), vec![]);
    for factor in factors {
        let mut exponent = 0;
        while content.degree_in(variable) > 0
            && let Some(quotient) = content.exact_quotient(factor)
        {
            content = quotient;
            exponent += 1;
        }
        exponents.push(exponent);
    }
    let number = content.symbols().iter().all(Symbol::is_number);
    number.then_some(Product { content, exponents })
}

/// Cuts between which each piece has one root of the factors at most.
fn cuts(factors: &[Plain], variable: &torse_certificate::Symbol) -> Option<Vec<Rational>> {
    let factors: Vec<Vec<Plain>> = factors
        .iter()
        .map(|factor| written::coefficients(factor, variable))
        .collect::<Option<_>>()?;
    let mut cuts = vec![integer(0)];
    let mut pending = vec![Span::Below(integer(0)), Span::Above(integer(0))];
    while let Some(span) = pending.pop() {
        let mut roots = 0;
        for factor in &factors {
            roots += span.changes(factor)?.count;
        }
        if roots <= 1 {
            continue;
        }
        let two = integer(2);
        let (cut, halves) = match span {
            Span::Below(to) => {
                let cut = if to == integer(0) {
                    integer(-1)
                } else {
                    &to * &two
                };
                (
                    cut.clone(),
                    [Span::Below(cut.clone()), Span::Between(cut, to)],
                )
            }
            Span::Above(from) => {
                let cut = if from == integer(0) {
                    integer(1)
                } else {
                    &from * &two
                };
                (
                    cut.clone(),
                    [Span::Between(from, cut.clone()), Span::Above(cut)],
                )
            }
            Span::Between(from, to) => {
                let cut = (&from + &to) / two;
                let halves = [
                    Span::Between(from, cut.clone()),
                    Span::Between(cut.clone(), to),
                ];
                (cut, halves)
            }
        };
        cuts.push(cut);
        pending.extend(halves);
        if cuts.len() > MAX_CUTS {
            return None;
        }
    }
    cuts.sort();
    Some(cuts)
}
