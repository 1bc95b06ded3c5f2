//! Positivity on cells of the variable.
//!
//! **A cell** of length h is mapped to [0, 1], and a Bernstein coefficient w is evaluated at the N places `(i +
//! 1/2)/N`, divided by `x^o` on the first cell, where it vanishes at 0 to the order o (computed by `orders`). The
//! polynomial p of degree N - 1 through these values has Bernstein coefficients on the cell, and differs little from
//! `f = w/x^o`: with a disc of radius R about the midpoint of the cell, where R exceeds half of the length,
//!
//! ```text
//! f(x) - p(x) = 1/(2 pi i) integral over the circle of  f(z) g(x)/(g(z) (z - x)) dz,   g(x) = product of (x - x_i)
//! ```
//!
//! (Hermite). Here `abs(g(x)) <= h^N N!/N^N`, since the j-th nearest place has a distance of at most j h/N, and
//! `abs(g(z)) >= (R - h/2)^N`. So the error is at most `M R/(R - h/2) (h/(R - h/2))^N N!/N^N` with a bound M of
//! abs(f) on the circle, and w is positive on the cell (except at x = 0) if all Bernstein coefficients of p exceed
//! this error.
//!
//! **The bound M.** Take the largest Bernstein coefficient in size as norm of a polynomial in the parameters, and for a
//! function at z the sum of the norms of its Taylor coefficients there, the e-th divided by `2^e`; both are at most
//! multiplied in products. With X the largest `abs(z)`, the norm of z is at most `X + 1/2`, and those of sine and
//! cosine are at most `abs(sin) cosh(pi/4) + abs(cos) sinh(pi/4)` and the like, at most `t = cosh(pi/2 R) exp(pi/4)`,
//! for both are at most `cosh(pi/2 abs(Im z))` in size. Multiplying row m of the determinant by `2^-m` and column j by
//! `2^j` leaves it as it is, and it is at most the product of its row sums; so
//! `M = (1 + 2 w_1 |c_1| + ... + 2^d w_d |c_d|)^r` with the weights w of column r, divided by the least `abs(z)^o`,
//! which on the first cell is R minus the middle.

use super::certificate::{Cell, Half};
use super::node::{BITS, Grid, Places};
use super::operator::{Operator, weight};
use super::orders::Orders;
use super::remembered::{Question, answer};
use super::tables::{differences, newton};
use super::{MAX_DEGREE, Unfit};
use std::cmp::Ordering;
use torse_numbers::fault_injection::{InjectedFault, injected};
use torse_numbers::rational::integer;
use torse_numbers::{Ball, Rational};

/// The largest numbers of cells and of places of one half.
const MAX_CELLS: usize = 64;
const MAX_NODES: u16 = 96;
/// The largest radius of a disc.
const MAX_RADIUS: i64 = 8;

/// A family at one degree on [0, 1/2].
pub struct Front<'a> {
    operator: &'a Operator,
    degree: usize,
    exact: Vec<u8>,
    places: Places<'a>,
    orders: Orders,
}

impl<'a> Front<'a> {
    /// Prepares the data that all cells share; the determinants of the sizes `exact` are expanded symbolically.
    ///
    /// # Errors
    /// [`Unfit`].
    pub fn new(operator: &'a Operator, degree: u8, exact: &[u8]) -> Result<Self, Unfit> {
        let own = usize::from(degree);
        if degree > MAX_DEGREE || own < operator.order() || degree == 0 {
            return Err(Unfit::Make("a degree out of reach"));
        }
        Ok(Self {
            operator,
            degree: own,
            exact: exact.to_vec(),
            places: Places::new(operator, own),
            orders: Orders::new(operator, own, exact)?,
        })
    }

    /// Checks that cells fill [0, 1/2] and that all coefficients are positive on them.
    ///
    /// # Errors
    /// [`Unfit`].
    pub fn check(&self, cells: &[Cell]) -> Result<(), Unfit> {
        let half = Rational::new(1.into(), 2.into());
        if cells.len() > MAX_CELLS || cells.last().is_none_or(|last| last.until != half) {
            return Err(Unfit::Cell);
        }
        let mut from = integer(0);
        for cell in cells {
            self.cell(&from, cell)?;
            from = cell.until.clone();
        }
        Ok(())
    }

    /// Checks that all coefficients are positive on one cell, except those that vanish identically, and except at x =
    /// 0.
    ///
    /// # Errors
    /// [`Unfit`].
    pub fn cell(&self, from: &Rational, cell: &Cell) -> Result<(), Unfit> {
        let question = Question {
            parts: self.operator.parts.clone(),
            degree: self.degree,
            exact: self.exact.clone(),
            from: from.clone(),
            cell: cell.clone(),
            mistaken: injected(InjectedFault::CoefficientUnlooked),
        };
        answer(question, || self.evaluated(from, cell))
    }

    fn evaluated(&self, from: &Rational, cell: &Cell) -> Result<(), Unfit> {
        let length = &cell.until - from;
        let half = &length * &Rational::new(1.into(), 2.into());
        let middle = from + &half;
        // On the first cell the circle must enclose zero, at a distance.
        let clear = if from == &integer(0) {
            &cell.radius - &middle
        } else {
            &cell.radius - &half
        };
        let zero = integer(0);
        if length <= zero || clear <= zero || cell.radius > integer(MAX_RADIUS) {
            return Err(Unfit::Cell);
        }
        if !(2..=MAX_NODES).contains(&cell.nodes) {
            return Err(Unfit::Cell);
        }
        let nodes = i64::from(cell.nodes);
        let mut found: Vec<Vec<Grid>> = vec![];
        for i in 0..nodes {
            let share = Rational::new((2 * i + 1).into(), (2 * nodes).into());
            let x = from + &(&length * &share);
            let mut grids = self.places.at(&x)?;
            if *from == zero {
                self.divide(&mut grids, &x);
            }
            found.push(grids);
        }
        let shift = Rational::new((-1).into(), 2.into());
        let table = newton(&integer(nodes), &shift, usize::from(cell.nodes) - 1, BITS);
        for rank in 1..=self.degree {
            let bound = self.bound(rank, &middle, cell)?;
            let error = |order: usize| {
                let far = (0..order).fold(bound.clone(), |bound, _| bound / &clear);
                let ratio = &length / &(&cell.radius - &half);
                let mut error = far * &cell.radius / (&cell.radius - &half);
                for n in 1..=nodes {
                    error = error * &ratio * integer(n) / integer(nodes);
                }
                Ball::from_rational(&error, BITS)
            };
            let Some(first) = found.first().and_then(|grids| grids.get(rank - 1)) else {
                return Err(Unfit::Cell);
            };
            let mut errors: Vec<Option<Ball>> = vec![];
            let mut at_zero = false;
            for (a, row) in first.iter().enumerate() {
                for b in 0..row.len() {
                    let Some(order) = self.orders.get(rank, a, b) else {
                        continue;
                    };
                    let order = if *from == zero { order } else { 0 };
                    at_zero |= order == 0;
                    if errors.len() <= order {
                        errors.resize(order + 1, None);
                    }
                    let error = errors[order].get_or_insert_with(|| error(order)).clone();
                    let mut values: Vec<Ball> = found
                        .iter()
                        .map(|grids| grids[rank - 1][a][b].clone())
                        .collect();
                    differences(&mut values);
                    let positive = |weights: &Vec<Ball>| {
                        let coefficient = Ball::dot(weights.iter().zip(&values), BITS);
                        (&coefficient - &error).sign() == Some(Ordering::Greater)
                    };
                    if !table.iter().all(positive) && !injected(InjectedFault::CoefficientUnlooked)
                    {
                        return Err(self.sign(rank, cell));
                    }
                }
            }
            // At x = 0 some coefficient must be positive.
            if !at_zero {
                return Err(self.sign(rank, cell));
            }
        }
        Ok(())
    }

    fn sign(&self, rank: usize, cell: &Cell) -> Unfit {
        Unfit::Sign {
            rank,
            until: cell.until.to_string(),
        }
    }

    /// Divides every coefficient by the power of x to which it vanishes at 0.
    fn divide(&self, grids: &mut [Grid], x: &Rational) {
        for (rank, grid) in (1..).zip(grids) {
            for (a, row) in grid.iter_mut().enumerate() {
                for (b, value) in row.iter_mut().enumerate() {
                    let order = self.orders.get(rank, a, b);
                    if let Ok(exponent @ 1..) = i32::try_from(order.unwrap_or(0)) {
                        *value = &*value * &Ball::from_rational(&x.recip().pow(exponent), BITS);
                    }
                }
            }
        }
    }

    /// The bound M of the Bernstein coefficients of a determinant on the disc.
    fn bound(&self, rank: usize, middle: &Rational, cell: &Cell) -> Result<Rational, Unfit> {
        let far = &cell.radius + middle + Rational::new(1.into(), 2.into());
        // Simple rational upper bounds: integers, and 22/7 for pi.
        let pi = Rational::new(22.into(), 7.into());
        let exp = |angle: Rational| {
            let turn = Ball::from_rational(&angle, BITS).exp();
            turn.map(|turn| turn.upper()).map_err(|_| Unfit::Cell)
        };
        let quarter = Rational::new(11.into(), 14.into());
        let cosh = exp(&cell.radius * &quarter * integer(2))? + integer(1);
        let turn = cosh * exp(quarter)? * Rational::new(1.into(), 2.into());
        let turn = Rational::from_integer(turn.to_integer()) + integer(1);
        let power = |base: &Rational, exponent: u32| {
            (0..exponent).fold(integer(1), |power, _| power * base)
        };
        let mut row = integer(1);
        for (i, parts) in (1..).zip(&self.operator.parts) {
            let mut norm = integer(0);
            for term in parts.iter().flat_map(|part| &part.terms) {
                let size = num_traits::Signed::abs(&term.coefficient);
                let size = size * power(&far, term.x) * power(&pi, term.pi);
                norm += size * power(&turn, term.sine + term.cosine);
            }
            row += norm * weight(i, rank, self.degree) * integer(1 << i);
        }
        Ok((0..rank).fold(integer(1), |bound, _| bound * &row))
    }
}

/// Checks one half of a certificate.
///
/// # Errors
/// [`Unfit`].
pub fn check(operator: &Operator, degree: u8, half: &Half) -> Result<(), Unfit> {
    Front::new(operator, degree, &half.exact)?.check(&half.cells)
}
