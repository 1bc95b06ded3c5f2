//! Certificates of sign: the equation multiplied out, the coordinates, the pieces, and every Bernstein coefficient.

use super::gap::{Beyond, Unchecked, Wrong};
use super::ground::{Compared, Domain};
use super::quotient::Quotient;
use super::range::Ranges;
use crate::number::order;
use crate::polynomial::{Monomial, Polynomial};
use crate::ratio::{Constraint, Ratio};
use crate::sign::{Certificate, Coordinate, Factor, Piece, Shown, Sign};
use crate::symbol::Symbol;
use std::cmp::Ordering;
use std::collections::BTreeMap;
use torse_language::syntax::Relation;
use torse_numbers::Rational;
use torse_numbers::rational::integer;

/// What signs are checked against.
pub struct Signs<'a> {
    domain: &'a Domain<'a>,
    constraints: &'a [Constraint<Polynomial>],
    /// What the claim itself says.
    own: Vec<Compared>,
    gap: Option<Beyond>,
    ranges: Ranges,
}

/// A bounded coordinate and which of its ends belong to the domain, or an unbounded one.
struct Sides {
    sides: Vec<(Symbol, bool, bool)>,
    /// Whether no unbounded coordinate is ever zero.
    open: bool,
}

impl<'a> Signs<'a> {
    /// Signs where the symbols of the first groups have their values, with these constraints.
    pub fn new(
        domain: &'a Domain<'a>,
        constraints: &'a [Constraint<Polynomial>],
        groups: usize,
    ) -> Result<Self, Unchecked> {
        let (own, gap) = domain.constraints(groups)?;
        let ranges = Ranges::of(&own, domain.work)?;
        Ok(Self {
            domain,
            constraints,
            own,
            gap,
            ranges,
        })
    }

    /// The constraint in this place, which has to be one of the claim, as a polynomial that is not negative; and whether it
    /// is not zero either. The product with the denominator has the sign of the quotient.
    fn constraint(&self, place: usize) -> Result<(Polynomial, bool), Unchecked> {
        let work = self.domain.work;
        let constraint = self.constraints.get(place).ok_or(Wrong::Kind)?;
        let value = Quotient::of(&constraint.value, work)?;
        let mut known = false;
        for own in &self.own {
            if own.relation == constraint.relation && own.difference.equals(&value, work)? {
                known = true;
                break;
            }
        }
        if !known {
            return Err(match &self.gap {
                Some(gap) => gap.clone().into(),
                None => Wrong::Constraint(constraint.to_string()).into(),
            });
        }
        let Ratio { above, below } = &constraint.value;
        let product = work.times(above, below)?;
        match constraint.relation {
            Relation::Greater => Ok((product, true)),
            Relation::AtLeast => Ok((product, false)),
            Relation::Less => Ok((product.negated(), true)),
            Relation::AtMost => Ok((product.negated(), false)),
            Relation::Equal | Relation::Different => Err(Wrong::Kind.into()),
        }
    }

    /// Checks that the polynomial is not negative, and not zero either if that is said.
    pub fn check(&self, sign: &Sign<Polynomial>) -> Result<(), Unchecked> {
        let work = self.domain.work;
        let same = |p: &Polynomial| Quotient::from(p.minus(&sign.polynomial)).is_zero(work);
        let strict = match &sign.by {
            Shown::Whole(certificate) => {
                if !same(&self.made(certificate)?)? {
                    return Err(Wrong::Equation.into());
                }
                self.certificate(certificate)?
            }
            Shown::Parts(_) => {
                return Err(Beyond::Construct("a domain that angles cut into parts").into());
            }
            Shown::Factors(signs) => {
                let (mut product, mut strict) = (Polynomial::one(), true);
                for factor in signs {
                    self.check(factor)?;
                    strict &= factor.strict;
                    product = work.times(&product, &factor.polynomial)?;
                }
                let (lead, _) = sign.polynomial.monic().ok_or(Wrong::Equation)?;
                let (own, _) = product.monic().ok_or(Wrong::Equation)?;
                let ratio = lead / own;
                if ratio <= integer(0) || !same(&product.scaled(&ratio))? {
                    return Err(Wrong::Equation.into());
                }
                strict
            }
            Shown::Rays(rays) => {
                let (mut sum, mut strict) = (Polynomial::zero(), false);
                for ray in rays {
                    self.check(&ray.coefficient)?;
                    let mut terms = ray.product.terms();
                    let (Some((symbols, number)), None) = (terms.next(), terms.next()) else {
                        return Err(Wrong::Negative.into());
                    };
                    let positive = |(symbol, _): &(Symbol, u32)| self.ranges.is_nonnegative(symbol);
                    if *number <= integer(0) || !symbols.iter().all(positive) {
                        return Err(Wrong::Negative.into());
                    }
                    // Where all symbols of the rays are zero, the terms without them are left.
                    strict |= symbols.is_empty() && ray.coefficient.strict;
                    sum = sum.plus(&work.times(&ray.product, &ray.coefficient.polynomial)?);
                }
                if !same(&sum)? {
                    return Err(Wrong::Equation.into());
                }
                strict
            }
        };
        match sign.strict && !strict {
            true => Err(Wrong::Zero.into()),
            false => Ok(()),
        }
    }

    /// What the parts of a certificate make.
    fn made(&self, certificate: &Certificate<Polynomial>) -> Result<Polynomial, Unchecked> {
        let work = self.domain.work;
        let (mut sum, mut product) = (Polynomial::zero(), certificate.rest.clone());
        for square in &certificate.squares {
            let root = work.times(&square.root, &square.root)?;
            sum = sum.plus(&root.scaled(&square.multiple));
        }
        for multiple in &certificate.multiples {
            let (value, _) = self.constraint(multiple.constraint)?;
            sum = sum.plus(&value.scaled(&multiple.multiple));
        }
        for factor in &certificate.factors {
            product = work.times(&product, &self.factor(factor)?.0)?;
        }
        Ok(sum.plus(&product))
    }

    /// A factor, and whether it is positive.
    fn factor(&self, factor: &Factor<Polynomial>) -> Result<(Polynomial, bool), Unchecked> {
        match factor {
            Factor::Symbol(symbol) => {
                if !self.ranges.is_nonnegative(symbol) {
                    return Err(Wrong::Negative.into());
                }
                let strict = self.ranges.is_positive(symbol);
                Ok((Polynomial::symbol(symbol.clone()), strict))
            }
            Factor::Constraint(place) => self.constraint(*place),
            Factor::Square(root) => Ok((self.domain.work.times(root, root)?, false)),
        }
    }

    /// Checks that no part is negative; whether the whole is shown to be positive.
    fn certificate(&self, certificate: &Certificate<Polynomial>) -> Result<bool, Unchecked> {
        let (mut sum_positive, mut factors_positive) = (false, true);
        if certificate.squares.iter().any(|s| s.multiple < integer(0)) {
            return Err(Wrong::Negative.into());
        }
        for multiple in &certificate.multiples {
            let (_, strict) = self.constraint(multiple.constraint)?;
            if multiple.multiple < integer(0) {
                return Err(Wrong::Negative.into());
            }
            sum_positive |= strict && multiple.multiple > integer(0);
        }
        for factor in &certificate.factors {
            factors_positive &= self.factor(factor)?.1;
        }
        let rest_positive = self.pieces(certificate)?;
        let strict = sum_positive || (factors_positive && rest_positive);
        match certificate.strict && !strict {
            true => Err(Wrong::Zero.into()),
            false => Ok(strict),
        }
    }

    /// Checks the pieces; whether they show the rest to be positive.
    fn pieces(&self, certificate: &Certificate<Polynomial>) -> Result<bool, Unchecked> {
        let mut moved: BTreeMap<Option<usize>, (Polynomial, bool)> = BTreeMap::new();
        moved.insert(None, (certificate.rest.clone(), false));
        for place in certificate.pieces.iter().filter_map(|piece| piece.outside) {
            let (value, strict) = self.constraint(place)?;
            // It fails where its negative is not negative, or positive if it may be zero.
            moved.insert(Some(place), (value.negated(), strict));
        }
        let mut all: Vec<&mut Polynomial> = moved.values_mut().map(|(p, _)| p).collect();
        let bounds = self.coordinates(&certificate.coordinates, &mut all)?;
        if !fills(&certificate.pieces, bounds.sides.len()) {
            return Err(Wrong::NotFilled(certificate.pieces.len()).into());
        }
        let mut positive = true;
        for (number, piece) in certificate.pieces.iter().enumerate() {
            let wrong = || Unchecked::from(Wrong::Coefficient(number));
            let (polynomial, strict) = moved.get(&piece.outside).ok_or_else(wrong)?;
            let shown = self.positive_on(polynomial, &bounds, piece)?.ok_or_else(wrong)?;
            match piece.outside {
                None => positive &= shown,
                Some(_) if !strict && !shown => return Err(wrong()),
                Some(_) => {}
            }
        }
        Ok(positive)
    }

    /// Puts the coordinates into the polynomials, each multiplied with what is positive, and checks that they enclose the
    /// ranges of their symbols.
    fn coordinates(
        &self,
        coordinates: &[Coordinate<Polynomial>],
        polynomials: &mut [&mut Polynomial],
    ) -> Result<Sides, Unchecked> {
        let work = self.domain.work;
        let mut bounds = Sides {
            sides: vec![],
            open: true,
        };
        for polynomial in &mut *polynomials {
            **polynomial = polynomial.refined().ok_or(Beyond::Large)?;
        }
        let mut tangents: BTreeMap<Symbol, (String, crate::symbol::Angle, i64)> = BTreeMap::new();
        let put = |polynomials: &mut [&mut Polynomial], value: &dyn Fn(&Symbol) -> Option<Quotient>| {
            for polynomial in polynomials {
                let moved = Quotient::from((**polynomial).clone()).replaced_symbols(value, work)?;
                // The sign stays that of the numerator: 1 + t^2 is positive, and so has to be a number.
                let mut numbers = moved.below.keys().filter(|factor| factor.is_number());
                if !numbers.all(|factor| order(factor) == Some(Ordering::Greater)) {
                    return Err(Beyond::Construct("a coordinate with such a denominator").into());
                }
                **polynomial = moved.above;
            }
            Ok::<(), Unchecked>(())
        };
        for coordinate in coordinates {
            let own = |symbol: &Symbol| Quotient::from(Polynomial::symbol(symbol.clone()));
            match coordinate {
                Coordinate::Tangent {
                    symbol,
                    variable,
                    angle,
                    from,
                } => {
                    let (sine, cosine) = half_angle(symbol, *from, work)?;
                    let value = |s: &Symbol| match s {
                        Symbol::Sine(name, own) if **name == **variable && own == angle => {
                            Some(sine.clone())
                        }
                        Symbol::Cosine(name, own) if **name == **variable && own == angle => {
                            Some(cosine.clone())
                        }
                        _ => None,
                    };
                    put(polynomials, &value)?;
                    tangents.insert(symbol.clone(), (variable.clone(), *angle, *from));
                }
                Coordinate::Side {
                    symbol,
                    lower,
                    upper,
                } => {
                    let enclosed = match tangents.get(symbol) {
                        Some((variable, angle, from)) => {
                            self.ranges.tangent(variable, *angle, *from, lower, upper)
                        }
                        None => self.ranges.side(symbol, Some(lower), Some(upper)),
                    };
                    if !enclosed {
                        return Err(Wrong::Coordinate(symbol.to_string()).into());
                    }
                    let (a, b) = (Quotient::of(&lower.value, work)?, Quotient::of(&upper.value, work)?);
                    let width = b.minus(&a, work)?.times(&own(symbol), work)?;
                    let value = a.plus(&width, work)?;
                    put(polynomials, &|s| (s == symbol).then(|| value.clone()))?;
                    bounds.sides.push((symbol.clone(), lower.closed, upper.closed));
                }
                Coordinate::Ray { symbol, end, up } => {
                    let enclosed = match up {
                        true => self.ranges.side(symbol, Some(end), None),
                        false => self.ranges.side(symbol, None, Some(end)),
                    };
                    if !enclosed || tangents.contains_key(symbol) {
                        return Err(Wrong::Coordinate(symbol.to_string()).into());
                    }
                    let t = match up {
                        true => own(symbol),
                        false => own(symbol).negated(),
                    };
                    let value = Quotient::of(&end.value, work)?.plus(&t, work)?;
                    put(polynomials, &|s| (s == symbol).then(|| value.clone()))?;
                    bounds.open &= !end.closed;
                }
                Coordinate::Squared { symbol } => {
                    for polynomial in &mut *polynomials {
                        **polynomial = halved(polynomial, symbol).ok_or(Wrong::Negative)?;
                    }
                    bounds.open = false;
                }
            }
        }
        Ok(bounds)
    }

    /// Whether the polynomial is positive on a piece, by its Bernstein coefficients; `None` if one may be negative.
    fn positive_on(
        &self,
        polynomial: &Polynomial,
        bounds: &Sides,
        piece: &Piece,
    ) -> Result<Option<bool>, Unchecked> {
        if piece.region.len() < bounds.sides.len() {
            return Ok(None);
        }
        let places: Vec<&Symbol> = bounds.sides.iter().map(|(symbol, ..)| symbol).collect();
        let degrees: Vec<u32> = places.iter().map(|s| polynomial.degree_in(s)).collect();
        // t = low + (high - low)*u on the piece.
        let work = self.domain.work;
        let value = |symbol: &Symbol| {
            let place = places.iter().position(|own| *own == symbol)?;
            let (low, high) = piece.region.get(place)?;
            let u = Polynomial::symbol(symbol.clone()).scaled(&(high - low));
            Some(Quotient::from(u.plus(&Polynomial::constant(low.clone()))))
        };
        let there = Quotient::from(polynomial.clone()).replaced_symbols(&value, work)?.above;
        let Some(forms) = bernstein(&there, &places, &degrees) else {
            return Err(Beyond::Large.into());
        };
        work.spend(forms.len())?;
        let mut positive: Vec<&Vec<u32>> = vec![];
        for (index, coefficient) in &forms {
            let mut excludes_zero = false;
            // By products of unbounded coordinates, which are not negative.
            for (ray, number) in by_rays(coefficient) {
                if ray.iter().any(|(symbol, _)| !matches!(symbol, Symbol::Named(_))) {
                    return Err(Beyond::Construct("a sine without a coordinate").into());
                }
                match order(&number).ok_or(Beyond::Near)? {
                    Ordering::Less => return Ok(None),
                    Ordering::Equal => {}
                    Ordering::Greater => excludes_zero |= ray.is_empty() || bounds.open,
                }
            }
            if excludes_zero {
                positive.push(index);
            }
        }
        Ok(Some(every_face(&positive, &degrees, bounds, piece)))
    }
}

/// Whether each face of the piece that belongs to the domain has a positive coefficient. Inside of the box all ends do.
fn every_face(positive: &[&Vec<u32>], degrees: &[u32], bounds: &Sides, piece: &Piece) -> bool {
    let mut faces: Vec<Vec<Option<u32>>> = vec![vec![]];
    for ((side, degree), (low, high)) in bounds.sides.iter().zip(degrees).zip(&piece.region) {
        let (_, lower_closed, upper_closed) = side;
        let lower = *lower_closed || *low != integer(0);
        let upper = *upper_closed || *high != integer(1);
        let choices = [
            Some(None),
            lower.then_some(Some(0)),
            upper.then_some(Some(*degree)),
        ];
        let longer = |face: &Vec<Option<u32>>| -> Vec<Vec<Option<u32>>> {
            let choices = choices.iter().flatten();
            choices.map(|c| [face.as_slice(), &[*c]].concat()).collect()
        };
        faces = faces.iter().flat_map(longer).collect();
    }
    faces.iter().all(|face| {
        positive.iter().any(|index| {
            let mut pairs = index.iter().zip(face);
            pairs.all(|(j, place)| place.is_none_or(|place| *j == place))
        })
    })
}

/// The Bernstein coefficients by multi-index: a power t^e of degree d is the sum of `C(j,e)/C(d,e)` times the j-th Bernstein
/// polynomial, side after side. Indices without an entry have the coefficient zero.
fn bernstein(
    polynomial: &Polynomial,
    sides: &[&Symbol],
    degrees: &[u32],
) -> Option<BTreeMap<Vec<u32>, Polynomial>> {
    const MOST: usize = 40_000;
    let mut forms: BTreeMap<Vec<u32>, Polynomial> = BTreeMap::new();
    for (monomial, coefficient) in polynomial.terms() {
        let power = |side: &&Symbol| {
            let own = monomial.iter().find(|(symbol, _)| symbol == *side);
            own.map_or(0, |(_, exponent)| *exponent)
        };
        let index = sides.iter().map(power).collect();
        let rest = monomial.iter().filter(|(s, _)| !sides.contains(&s));
        let slot = forms.entry(index).or_default();
        slot.enter(rest.cloned().collect(), coefficient.clone());
    }
    for (side, degree) in degrees.iter().enumerate() {
        let mut next: BTreeMap<Vec<u32>, Polynomial> = BTreeMap::new();
        for (index, coefficient) in &forms {
            let power = *index.get(side)?;
            for j in power..=*degree {
                let mut place = index.clone();
                *place.get_mut(side)? = j;
                let share = binomial(j, power) / binomial(*degree, power);
                let slot = next.entry(place).or_default();
                *slot = slot.plus(&coefficient.scaled(&share));
            }
        }
        if next.len() > MOST {
            return None;
        }
        forms = next;
    }
    Some(forms)
}

fn binomial(n: u32, k: u32) -> Rational {
    let factor = |i: u32| integer(i64::from(n - i)) / integer(i64::from(i + 1));
    (0..k.min(n)).map(factor).product()
}

/// The coefficients, made of pi and roots, by products of the other symbols.
fn by_rays(polynomial: &Polynomial) -> BTreeMap<Monomial, Polynomial> {
    let mut groups: BTreeMap<Monomial, Polynomial> = BTreeMap::new();
    for (monomial, coefficient) in polynomial.terms() {
        let parts = monomial.iter().cloned();
        let (number, ray): (Monomial, Monomial) = parts.partition(|(s, _)| s.is_number());
        groups.entry(ray).or_default().enter(number, coefficient.clone());
    }
    groups
}

/// The polynomial with t for the square of the symbol, which then stands for t.
fn halved(polynomial: &Polynomial, symbol: &Symbol) -> Option<Polynomial> {
    let mut result = Polynomial::zero();
    for (exponent, coefficient) in polynomial.coefficients_in(symbol).iter().enumerate() {
        if coefficient.is_zero() {
            continue;
        }
        if exponent % 2 == 1 {
            return None;
        }
        let power = Polynomial::symbol(symbol.clone()).power(u32::try_from(exponent / 2).ok()?);
        result = result.plus(&coefficient.times(&power));
    }
    Some(result)
}

/// Sine and cosine of an angle by the tangent t of half of what it is beyond so many quarter turns.
fn half_angle(
    tangent: &Symbol,
    from: i64,
    work: &super::gap::Work,
) -> Result<(Quotient, Quotient), Beyond> {
    let t = Polynomial::symbol(tangent.clone());
    let square = t.times(&t);
    let below = Quotient::from(Polynomial::one().plus(&square));
    let sine = Quotient::from(t.scaled(&integer(2))).over(&below, work)?;
    let cosine = Quotient::from(Polynomial::one().minus(&square)).over(&below, work)?;
    Ok(match from.rem_euclid(4) {
        0 => (sine, cosine),
        1 => (cosine, sine.negated()),
        2 => (sine.negated(), cosine.negated()),
        _ => (cosine.negated(), sine),
    })
}

/// Whether the pieces fill the unit box: they lie in it, no two overlap, and their volumes add up to one.
fn fills(pieces: &[Piece], dimension: usize) -> bool {
    if dimension == 0 {
        return pieces.len() == 1;
    }
    let inside = |piece: &Piece| {
        let whole = piece.region.len() == dimension;
        let side = |(a, b): &(Rational, Rational)| *a >= integer(0) && a < b && *b <= integer(1);
        whole && piece.region.iter().all(side)
    };
    let apart = |p: &Piece, q: &Piece| {
        let mut sides = p.region.iter().zip(&q.region);
        sides.any(|((a, b), (c, d))| b <= c || d <= a)
    };
    let mut later = pieces.iter().enumerate();
    let disjoint = later.all(|(place, piece)| {
        let mut earlier = pieces.iter().take(place);
        earlier.all(|other| apart(piece, other))
    });
    let volume = |piece: &Piece| -> Rational { piece.region.iter().map(|(a, b)| b - a).product() };
    let total = pieces.iter().map(volume).fold(integer(0), |sum, v| sum + v);
    pieces.iter().all(inside) && disjoint && total == integer(1)
}
