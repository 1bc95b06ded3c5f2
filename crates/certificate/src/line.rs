//! The sign of a polynomial of one variable on a part of the line.
//!
//! The line is cut at rational numbers. On each open piece between two cuts every factor has one root at most, and no
//! two of them have one: so the signs of the factors are known at every cut, and on every piece left of the root, at
//! it, and right of it. These are the [`cells`](Line::cells) of the line, finitely many, and each polynomial that is a
//! product of the factors has one sign on each of them.
//!
//! **Theorem** (Descartes, Jacobi). Let p have degree n. If the coefficients of `(1 + t)^n p((a + b t)/(1 + t))` change
//! their sign v times, zeros left out, p has at most v roots between a and b, counted with multiplicity, and v less an
//! even number. So for v = 0 there is none, and for v = 1 one, where p changes its sign. For the pieces without an end,
//! `p(c + t)` and `p(c - t)` say the same.

use crate::number::order;
use crate::polynomial::Polynomial;
use crate::ratio::Ratio;
use crate::symbol::Symbol;
use crate::text;
use serde::Serialize;
use std::cmp::Ordering;
use torse_numbers::Rational;
use torse_numbers::rational::integer;

/// The sign of a polynomial of one variable on those points of the line at which comparisons with zero are true.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct Line<P> {
    /// The variable.
    pub variable: Symbol,
    /// Where the line is cut, ascending; once at least.
    #[serde(serialize_with = "text::numbers")]
    pub cuts: Vec<Rational>,
    /// Polynomials in the variable.
    pub factors: Vec<P>,
    /// The polynomial as a product of the factors.
    pub target: Product<P>,
    /// What is true at the points that are looked at.
    pub within: Vec<Within<P>>,
}

/// A number times powers of the factors of a [`Line`].
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct Product<P> {
    /// The number, which is not zero.
    pub content: P,
    /// The exponents of the factors, in their order.
    pub exponents: Vec<u32>,
}

/// What is true at the points that are looked at.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Within<P> {
    /// A constraint of the proof context, by its place.
    Constraint {
        /// The place.
        constraint: usize,
        /// Its numerator.
        above: Product<P>,
        /// Its denominator.
        below: Product<P>,
    },
    /// The variable is not beyond an end of its range.
    End {
        /// The end.
        value: Ratio<P>,
        /// Whether it belongs to the range.
        closed: bool,
        /// Whether it is the lower one.
        is_lower: bool,
        /// The variable less the end, times the denominator of the end.
        offset: Product<P>,
    },
    /// A divisor does not vanish.
    Nonzero {
        /// The divisor.
        divisor: P,
        /// It as a product.
        product: Product<P>,
    },
}

/// Why a line has no cells.
#[derive(Debug, Clone, Copy, PartialEq, Eq, thiserror::Error)]
pub enum Uncut {
    /// The variable is a number, or a factor has other symbols.
    #[error("a factor is no polynomial of the variable")]
    Variable,
    /// The cuts do not ascend, or there is none.
    #[error("the cuts do not ascend")]
    Cuts,
    /// A factor may have more than one root on a piece, or two factors may have one.
    #[error("a piece of the line has too many roots")]
    Roots,
    /// The sign of a number is not told by enclosures.
    #[error("two numbers are too near to each other")]
    Near,
}

/// The signs of all factors on a part of the line: a point, or an open interval without roots.
pub type Cell = Vec<Ordering>;

/// An open piece of the line.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Span {
    /// All numbers below this one.
    Below(Rational),
    /// The numbers between these two.
    Between(Rational, Rational),
    /// All numbers above this one.
    Above(Rational),
}

/// The signs of a polynomial near the ends of a span, from the left, and how often its coefficients there change their sign.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Changes {
    /// Right of the left end.
    pub left: Ordering,
    /// Left of the right end.
    pub right: Ordering,
    /// A bound for the number of roots, exact if it is 0 or 1.
    pub count: usize,
}

impl Span {
    /// The pieces between cuts, from the left.
    #[must_use]
    pub fn between(cuts: &[Rational]) -> Vec<Self> {
        let (Some(first), Some(last)) = (cuts.first(), cuts.last()) else {
            return vec![];
        };
        let inner = cuts.windows(2).filter_map(|pair| match pair {
            [a, b] => Some(Self::Between(a.clone(), b.clone())),
            _ => None,
        });
        let inner = inner.collect::<Vec<_>>();
        let all = std::iter::once(Self::Below(first.clone())).chain(inner);
        all.chain([Self::Above(last.clone())]).collect()
    }

    /// What the coefficients of a polynomial say on this piece; `None` for the zero polynomial, and where the sign of a
    /// number is not told. The coefficients, which are numbers, ascend.
    #[must_use]
    pub fn changes(&self, coefficients: &[Polynomial]) -> Option<Changes> {
        let mut own = coefficients.to_vec();
        match self {
            Self::Above(from) => shift(&mut own, from),
            Self::Below(to) => {
                shift(&mut own, to);
                for odd in own.iter_mut().skip(1).step_by(2) {
                    *odd = odd.negated();
                }
                own.reverse();
            }
            Self::Between(from, to) => {
                shift(&mut own, from);
                let (width, mut power) = (to - from, integer(1));
                for coefficient in &mut own {
                    *coefficient = coefficient.scaled(&power);
                    power *= width.clone();
                }
                own.reverse();
                shift(&mut own, &integer(1));
                own.reverse();
            }
        }
        let signs: Vec<Ordering> = own.iter().map(order).collect::<Option<_>>()?;
        let mut signs = signs.into_iter().filter(|sign| sign.is_ne());
        let left = signs.next()?;
        let (mut right, mut count) = (left, 0);
        for sign in signs {
            count += usize::from(sign != right);
            right = sign;
        }
        Some(Changes { left, right, count })
    }
}

/// The coefficients of `p(x + by)`.
fn shift(coefficients: &mut [Polynomial], by: &Rational) {
    if *by == integer(0) {
        return;
    }
    for start in (1..coefficients.len()).rev() {
        for place in (start - 1)..(coefficients.len() - 1) {
            let Some([low, high]) = coefficients.get_mut(place..=place + 1) else {
                continue;
            };
            low.add(&high.scaled(by));
        }
    }
}

/// The value of a polynomial, by its coefficients.
#[must_use]
pub fn value_at(coefficients: &[Polynomial], at: &Rational) -> Polynomial {
    let mut value = Polynomial::zero();
    for coefficient in coefficients.iter().rev() {
        value = value.scaled(at).plus(coefficient);
    }
    value
}

/// The coefficients of a polynomial in the variable, ascending; `None` if one of them is no number.
#[must_use]
pub fn coefficients(polynomial: &Polynomial, variable: &Symbol) -> Option<Vec<Polynomial>> {
    let all = polynomial.coefficients_in(variable);
    let numbers = all.iter().all(Polynomial::is_number);
    (numbers && !variable.is_number()).then_some(all)
}

impl Line<Polynomial> {
    /// The signs of the factors on all parts of the line, from the left.
    ///
    /// # Errors
    /// [`Uncut`], if the cuts do not separate the roots of the factors.
    pub fn cells(&self) -> Result<Vec<Cell>, Uncut> {
        if !self.cuts.is_sorted_by(|a, b| a < b) || self.cuts.is_empty() {
            return Err(Uncut::Cuts);
        }
        let factors: Option<Vec<Vec<Polynomial>>> = self
            .factors
            .iter()
            .map(|factor| coefficients(factor, &self.variable))
            .collect();
        let factors = factors.ok_or(Uncut::Variable)?;
        let mut cells = vec![];
        let mut cuts = self.cuts.iter();
        for span in Span::between(&self.cuts) {
            let changes = factors.iter().map(|factor| span.changes(factor));
            let changes: Vec<Changes> = changes.collect::<Option<_>>().ok_or(Uncut::Near)?;
            let mut rooted = changes.iter().enumerate().filter(|(_, own)| own.count > 0);
            let root = rooted.next();
            if rooted.next().is_some() || root.is_some_and(|(_, own)| own.count > 1) {
                return Err(Uncut::Roots);
            }
            let left: Cell = changes.iter().map(|own| own.left).collect();
            if let Some((place, own)) = root {
                let with = |sign| {
                    let mut cell = left.clone();
                    if let Some(slot) = cell.get_mut(place) {
                        *slot = sign;
                    }
                    cell
                };
                cells.extend([left.clone(), with(Ordering::Equal), with(own.right)]);
            } else {
                cells.push(left);
            }
            if let Some(cut) = cuts.next() {
                let signs = factors.iter().map(|factor| order(&value_at(factor, cut)));
                cells.push(signs.collect::<Option<_>>().ok_or(Uncut::Near)?);
            }
        }
        Ok(cells)
    }
}

impl Product<Polynomial> {
    /// It multiplied out; `None` if the exponents are not as many as the factors.
    #[must_use]
    pub fn polynomial(&self, factors: &[Polynomial]) -> Option<Polynomial> {
        if self.exponents.len() != factors.len() || !self.content.is_number() {
            return None;
        }
        let powers = factors.iter().zip(&self.exponents);
        Some(
            powers.fold(self.content.clone(), |product, (factor, exponent)| {
                product.times(&factor.power(*exponent))
            }),
        )
    }

    /// Its sign on a cell; `None` where that of the number is not told.
    #[must_use]
    pub fn sign_on(&self, cell: &[Ordering]) -> Option<Ordering> {
        let mut sign = order(&self.content)?;
        for (own, exponent) in cell.iter().zip(&self.exponents) {
            sign = match (own, exponent) {
                (_, 0) => sign,
                (Ordering::Equal, _) => Ordering::Equal,
                (Ordering::Less, odd) if odd % 2 == 1 => sign.reverse(),
                _ => sign,
            };
            if sign.is_eq() {
                return Some(sign);
            }
        }
        Some(sign)
    }
}

impl<P> Product<P> {
    /// The same in other polynomials.
    pub fn map<Q>(&self, change: &dyn Fn(&P) -> Q) -> Product<Q> {
        Product {
            content: change(&self.content),
            exponents: self.exponents.clone(),
        }
    }
}

impl<P> Line<P> {
    /// The same in other polynomials.
    pub fn map<Q>(&self, change: &dyn Fn(&P) -> Q) -> Line<Q> {
        let within = |within: &Within<P>| match within {
            Within::Constraint {
                constraint,
                above,
                below,
            } => Within::Constraint {
                constraint: *constraint,
                above: above.map(change),
                below: below.map(change),
            },
            Within::End {
                value,
                closed,
                is_lower,
                offset,
            } => Within::End {
                value: value.map(change),
                closed: *closed,
                is_lower: *is_lower,
                offset: offset.map(change),
            },
            Within::Nonzero { divisor, product } => Within::Nonzero {
                divisor: change(divisor),
                product: product.map(change),
            },
        };
        Line {
            variable: self.variable.clone(),
            cuts: self.cuts.clone(),
            factors: self.factors.iter().map(change).collect(),
            target: self.target.map(change),
            within: self.within.iter().map(within).collect(),
        }
    }

    /// The places of the constraints that are used.
    pub fn constraints(&self) -> impl Iterator<Item = usize> {
        self.within.iter().filter_map(|within| match within {
            Within::Constraint { constraint, .. } => Some(*constraint),
            Within::End { .. } | Within::Nonzero { .. } => None,
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn polynomial(coefficients: &[i64]) -> Vec<Polynomial> {
        let numbers = coefficients.iter().map(|n| integer(*n));
        numbers.map(Polynomial::constant).collect()
    }

    #[test]
    fn signs_near_the_ends_of_a_piece_are_those_of_the_polynomial_there() {
        // (x - 1) (x - 3): positive, negative, positive.
        let own = polynomial(&[3, -4, 1]);
        let on = |span: Span| span.changes(&own).unwrap();
        let whole = on(Span::Between(integer(0), integer(2)));
        assert_eq!(whole.count, 1);
        assert_eq!(
            (whole.left, whole.right),
            (Ordering::Greater, Ordering::Less)
        );
        let right = on(Span::Above(integer(2)));
        assert_eq!(
            (right.left, right.right, right.count),
            (Ordering::Less, Ordering::Greater, 1)
        );
        let left = on(Span::Below(integer(0)));
        assert_eq!(
            (left.left, left.right, left.count),
            (Ordering::Greater, Ordering::Greater, 0)
        );
        let left = on(Span::Below(integer(2)));
        assert_eq!(
            (left.left, left.right, left.count),
            (Ordering::Greater, Ordering::Less, 1)
        );
    }

    #[test]
    fn two_roots_in_one_piece_are_no_cells() {
        let x = Polynomial::symbol(Symbol::named("x"));
        let square = x.times(&x).minus(&Polynomial::constant(integer(2)));
        let line = |cuts: &[i64]| Line {
            variable: Symbol::named("x"),
            cuts: cuts.iter().map(|n| integer(*n)).collect(),
            factors: vec![square.clone()],
            target: Product {
                content: Polynomial::one(),
                exponents: vec![1],
            },
            within: vec![],
        };
        assert_eq!(line(&[-5, 5]).cells(), Err(Uncut::Roots));
        assert_eq!(line(&[1, 0]).cells(), Err(Uncut::Cuts));
        assert_eq!(line(&[]).cells(), Err(Uncut::Cuts));
        let signs = line(&[0]).cells().unwrap().concat();
        use Ordering::{Equal, Greater, Less};
        assert_eq!(signs, [Greater, Equal, Less, Less, Less, Equal, Greater]);
    }
}
