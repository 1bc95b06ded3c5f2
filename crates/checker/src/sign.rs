//! Checks certificates of sign: expands the identity, and checks the coordinates, the pieces, and every Bernstein
//! coefficient.

use super::assumptions::{Compared, Domain};
use super::bernstein::{Sides, bernstein, by_rays, every_face, fills};
use super::gap::{CheckError, Unsupported, Wrong};
use super::quotient::Quotient;
use super::range::Ranges;
use std::cmp::Ordering;
use std::collections::{BTreeMap, BTreeSet};
use torse_certificate::number::order;
use torse_certificate::polynomial::Polynomial;
use torse_certificate::ratio::{Constraint, Ratio};
use torse_certificate::sign::{Certificate, Coordinate, Factor, Piece, Shown, Sign};
use torse_certificate::symbol::Symbol;
use torse_core::Set;
use torse_numbers::rational::integer;
use torse_syntax::formula::Relation;

/// The data against which signs are checked.
pub struct Signs<'a> {
    pub(super) domain: &'a Domain<'a>,
    constraints: &'a [Constraint<Polynomial>],
    /// The constraints that the claim itself states.
    own: Vec<Compared>,
    gap: Option<Unsupported>,
    pub(super) ranges: Ranges,
    /// How many groups of symbols have their values.
    pub(super) groups: usize,
}

impl<'a> Signs<'a> {
    /// Prepares checking with the symbols of the first `groups` groups replaced, and with these constraints.
    pub fn new(
        domain: &'a Domain<'a>,
        constraints: &'a [Constraint<Polynomial>],
        groups: usize,
    ) -> Result<Self, CheckError> {
        let (own, mut gap) = domain.constraints(groups)?;
        let ranges = Ranges::from_comparisons(&own, domain.work)?;
        // The signs that make a root positive are checked where all symbols have their values.
        if groups < domain.groups() && domain.has_open_root(constraints, groups)? {
            gap.get_or_insert(Unsupported::Construct(
                "a root that is positive before an elimination",
            ));
        }
        Ok(Self {
            domain,
            constraints,
            own,
            gap,
            ranges,
            groups,
        })
    }

    /// The constraint in this place, which has to be one of the claim.
    pub(super) fn constraint_of_hypothesis(
        &self,
        place: usize,
    ) -> Result<&Constraint<Polynomial>, CheckError> {
        let work = self.domain.work;
        let constraint = self.constraints.get(place).ok_or(Wrong::Kind)?;
        let value = Quotient::from_ratio(&constraint.value, work)?;
        let mut known = false;
        for own in &self.own {
            if own.relation == constraint.relation && own.difference.equals(&value, work)? {
                self.domain.note(&own.met);
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
        Ok(constraint)
    }

    /// The numerator of the equation in this place: it is zero wherever the quotient is defined.
    pub(super) fn equation(&self, place: usize) -> Result<&Polynomial, CheckError> {
        let constraint = self.constraint_of_hypothesis(place)?;
        match constraint.relation {
            Relation::Equal => Ok(&constraint.value.above),
            _ => Err(Wrong::Kind.into()),
        }
    }

    /// The constraint of this index as a nonnegative polynomial, and whether it is positive. The product of numerator
    /// and denominator has the sign of the quotient.
    fn constraint(&self, place: usize) -> Result<(Polynomial, bool), CheckError> {
        let work = self.domain.work;
        let constraint = self.constraint_of_hypothesis(place)?;
        let Ratio { above, below } = &constraint.value;
        if !below.is_number() && !self.domain.nonzero_at(below, self.groups)? {
            return Err(Unsupported::Divisor(below.to_string()).into());
        }
        let product = work.times(above, below)?;
        match constraint.relation {
            Relation::Greater => Ok((product, true)),
            Relation::AtLeast => Ok((product, false)),
            Relation::Less => Ok((product.negated(), true)),
            Relation::AtMost => Ok((product.negated(), false)),
            Relation::Equal | Relation::Different => Err(Wrong::Kind.into()),
        }
    }

    /// Checks that the polynomial is nonnegative, and positive if the sign is strict.
    pub fn check(&self, sign: &Sign<Polynomial>) -> Result<(), CheckError> {
        let checked = self.sign(sign);
        self.domain.note(&self.ranges.used());
        match (checked, &self.gap) {
            (Err(CheckError::Wrong(_)), Some(gap)) => Err(gap.clone().into()),
            (checked, _) => checked,
        }
    }

    pub(super) fn sign(&self, sign: &Sign<Polynomial>) -> Result<(), CheckError> {
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
                return Err(Unsupported::Construct("a domain that angles cut into parts").into());
            }
            Shown::Factors(signs) => {
                let (mut product, mut strict) = (Polynomial::one(), true);
                for factor in signs {
                    self.sign(factor)?;
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
            Shown::Along(along) => {
                self.sign(&along.rest)?;
                let value = self.equation(along.equation)?;
                let sum = along
                    .rest
                    .polynomial
                    .plus(&work.times(value, &along.multiple)?);
                if !same(&sum)? {
                    return Err(Wrong::Equation.into());
                }
                along.rest.strict
            }
            Shown::Even(even) => self.even(&sign.polynomial, even)?,
            Shown::Increasing(_) => return Err(Unsupported::Construct("an exponential").into()),
            Shown::Taylor(taylor) => self.taylor(&sign.polynomial, taylor)?,
            Shown::Line(line) => {
                let target = self.product(&line.target, line)?;
                if !same(&target)? {
                    return Err(Wrong::Equation.into());
                }
                self.line(line)?
            }
            Shown::Squares(own) => {
                self.sign(&own.larger)?;
                self.sign(&own.difference)?;
                let larger = &own.larger.polynomial;
                let smaller = larger.minus(&sign.polynomial);
                let squares = work
                    .times(larger, larger)?
                    .minus(&work.times(&smaller, &smaller)?);
                let wrong = squares.minus(&own.difference.polynomial);
                if !Quotient::from(wrong).is_zero(work)? {
                    return Err(Wrong::Equation.into());
                }
                own.difference.strict
            }
            Shown::Rays(rays) => {
                let (mut sum, mut strict) = (Polynomial::zero(), false);
                for ray in rays {
                    self.sign(&ray.coefficient)?;
                    let mut terms = ray.product.terms();
                    let (Some((symbols, number)), None) = (terms.next(), terms.next()) else {
                        return Err(Wrong::Negative.into());
                    };
                    let positive = |(symbol, _): &(Symbol, u32)| self.ranges.is_nonnegative(symbol);
                    if *number <= integer(0) || !symbols.iter().all(positive) {
                        return Err(Wrong::Negative.into());
                    }
                    // Where all symbols of the rays are zero, only the terms without them remain.
                    strict |= symbols.is_empty() && ray.coefficient.strict;
                    sum = sum.plus(&work.times(&ray.product, &ray.coefficient.polynomial)?);
                }
                if !same(&sum)? {
                    return Err(Wrong::Equation.into());
                }
                strict
            }
        };
        if sign.strict && !strict {
            Err(Wrong::Zero.into())
        } else {
            Ok(())
        }
    }

    /// The polynomial that the parts of a certificate add up to.
    fn made(&self, certificate: &Certificate<Polynomial>) -> Result<Polynomial, CheckError> {
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
    fn factor(&self, factor: &Factor<Polynomial>) -> Result<(Polynomial, bool), CheckError> {
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

    /// Checks that no part is negative; returns whether the whole is shown to be positive.
    fn certificate(&self, certificate: &Certificate<Polynomial>) -> Result<bool, CheckError> {
        let (mut sum_positive, mut factors_positive) = (false, true);
        for square in &certificate.squares {
            if square.multiple < integer(0) {
                return Err(Wrong::Negative.into());
            }
        }
        if certificate.strict {
            let squared = certificate.squares.iter();
            let squared = squared.filter(|square| square.multiple > integer(0));
            let roots: Vec<&Polynomial> = squared.map(|square| &square.root).collect();
            sum_positive |= self.domain.excludes_common_zero(&roots, self.groups)?;
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
        if certificate.strict && !strict {
            Err(Wrong::Zero.into())
        } else {
            Ok(strict)
        }
    }

    /// Checks the pieces; returns whether they show the remaining polynomial to be positive.
    fn pieces(&self, certificate: &Certificate<Polynomial>) -> Result<bool, CheckError> {
        let mut moved: BTreeMap<Option<usize>, (Polynomial, bool)> = BTreeMap::new();
        moved.insert(None, (certificate.rest.clone(), false));
        for place in certificate.pieces.iter().filter_map(|piece| piece.outside) {
            let (value, strict) = self.constraint(place)?;
            // The constraint fails where its negative is nonnegative (or positive, if the constraint may be zero).
            moved.insert(Some(place), (value.negated(), strict));
        }
        let mut all: Vec<&mut Polynomial> = moved.values_mut().map(|(p, _)| p).collect();
        let bounds = self.coordinates(&certificate.coordinates, &mut all)?;
        if !fills(&certificate.pieces, bounds.sides.len()) {
            return Err(Wrong::NotFilled(certificate.pieces.len()).into());
        }
        let mut positive = true;
        for (number, piece) in certificate.pieces.iter().enumerate() {
            let wrong = || CheckError::from(Wrong::Coefficient(number));
            let (polynomial, strict) = moved.get(&piece.outside).ok_or_else(wrong)?;
            let shown = self
                .positive_on(polynomial, &bounds, piece)?
                .ok_or_else(wrong)?;
            match piece.outside {
                None => positive &= shown,
                Some(_) if !strict && !shown => return Err(wrong()),
                Some(_) => {}
            }
        }
        Ok(positive)
    }

    /// A symbol leaves its coordinate, as far as its bounds tell: of an integer between others they do not tell all.
    pub(super) fn left(&self, symbol: &Symbol) -> CheckError {
        let set = match symbol {
            Symbol::Named(name) => self.domain.claim.symbols.get(name),
            _ => None,
        };
        let dependent = matches!(set, Some(Set::Integer { least, most })
            if least.iter().chain(most).any(|end| end.as_number().is_none()));
        if dependent {
            Unsupported::Construct("an integer between others").into()
        } else {
            Wrong::Coordinate(symbol.to_string()).into()
        }
    }

    /// Substitutes the coordinates in the polynomials, each multiplied by a positive quantity, and checks that they
    /// enclose the ranges of their symbols.
    fn coordinates(
        &self,
        coordinates: &[Coordinate<Polynomial>],
        polynomials: &mut [&mut Polynomial],
    ) -> Result<Sides, CheckError> {
        let work = self.domain.work;
        let mut bounds = Sides {
            sides: vec![],
            rays: BTreeMap::new(),
        };
        let mut placed = BTreeSet::new();
        for polynomial in &mut *polynomials {
            **polynomial = polynomial.refined().ok_or(Unsupported::Large)?;
        }
        let mut tangents: BTreeMap<Symbol, (String, torse_certificate::symbol::Angle, i64)> =
            BTreeMap::new();
        let substitute = |polynomials: &mut [&mut Polynomial],
                          value: &dyn Fn(&Symbol) -> Option<Quotient>| {
            for polynomial in polynomials {
                let moved = Quotient::from((**polynomial).clone()).replaced_symbols(value, work)?;
                // The sign is that of the numerator: 1 + t^2 is positive, and other factors must be positive
                // constants.
                let mut numbers = moved.below.keys().filter(|factor| factor.is_number());
                if !numbers.all(|factor| order(factor) == Some(Ordering::Greater)) {
                    return Err(
                        Unsupported::Construct("a coordinate with such a denominator").into(),
                    );
                }
                **polynomial = moved.above;
            }
            Ok::<(), CheckError>(())
        };
        for coordinate in coordinates {
            // Each symbol may occur once; the tangent is a symbol of its own.
            let (name, is_new) = match coordinate {
                Coordinate::Tangent {
                    symbol,
                    variable,
                    angle,
                    ..
                } => {
                    let mut all = polynomials.iter().flat_map(|p| p.symbols());
                    // The angle of w in radians is not w.
                    let name = format!("the angle {angle}{variable}");
                    (name, all.all(|own| own != symbol))
                }
                Coordinate::Side { symbol, .. }
                | Coordinate::Ray { symbol, .. }
                | Coordinate::Squared { symbol } => (symbol.to_string(), true),
            };
            if !is_new || !placed.insert(name.clone()) {
                return Err(Wrong::Coordinate(name).into());
            }
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
                    substitute(polynomials, &value)?;
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
                        return Err(self.left(symbol));
                    }
                    let (a, b) = (
                        Quotient::from_ratio(&lower.value, work)?,
                        Quotient::from_ratio(&upper.value, work)?,
                    );
                    let width = b.minus(&a, work)?.times(&own(symbol), work)?;
                    let value = a.plus(&width, work)?;
                    substitute(polynomials, &|s| (s == symbol).then(|| value.clone()))?;
                    bounds
                        .sides
                        .push((symbol.clone(), lower.closed, upper.closed));
                }
                Coordinate::Ray { symbol, end, up } => {
                    let enclosed = if *up {
                        self.ranges.side(symbol, Some(end), None)
                    } else {
                        self.ranges.side(symbol, None, Some(end))
                    };
                    if !enclosed || tangents.contains_key(symbol) {
                        return Err(self.left(symbol));
                    }
                    let t = if *up {
                        own(symbol)
                    } else {
                        own(symbol).negated()
                    };
                    let value = Quotient::from_ratio(&end.value, work)?.plus(&t, work)?;
                    substitute(polynomials, &|s| (s == symbol).then(|| value.clone()))?;
                    bounds.rays.insert(symbol.clone(), !end.closed);
                }
                Coordinate::Squared { symbol } => {
                    for polynomial in &mut *polynomials {
                        **polynomial = halved(polynomial, symbol).ok_or(Wrong::Negative)?;
                    }
                    bounds.rays.insert(symbol.clone(), false);
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
    ) -> Result<Option<bool>, CheckError> {
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
        let moved = Quotient::from(polynomial.clone())
            .replaced_symbols(&value, work)?
            .above;
        let Some(forms) = bernstein(&moved, &places, &degrees) else {
            return Err(Unsupported::Large.into());
        };
        work.spend(forms.len())?;
        let mut positive: Vec<&Vec<u32>> = vec![];
        for (index, coefficient) in &forms {
            let mut excludes_zero = false;
            // The coefficients of products of unbounded coordinates, which are nonnegative.
            for (ray, number) in by_rays(coefficient) {
                let mut never_zero = true;
                for (symbol, _) in &ray {
                    let open = bounds.rays.get(symbol);
                    never_zero &= *open.ok_or_else(|| Wrong::Coordinate(symbol.to_string()))?;
                }
                match order(&number).ok_or(Unsupported::Near)? {
                    Ordering::Less => return Ok(None),
                    Ordering::Equal => {}
                    Ordering::Greater => excludes_zero |= never_zero,
                }
            }
            if excludes_zero {
                positive.push(index);
            }
        }
        Ok(Some(every_face(&positive, &degrees, bounds, piece)))
    }
}

/// The polynomial with t in the place of the square of the symbol; the symbol then denotes t.
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

/// Sine and cosine of an angle, in terms of the tangent t of half of (the angle minus `from` quarter turns).
fn half_angle(
    tangent: &Symbol,
    from: i64,
    work: &super::gap::Work,
) -> Result<(Quotient, Quotient), Unsupported> {
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
