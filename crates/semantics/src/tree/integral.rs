//! Integrals: SEMANTICS.md, "How it is executed".
//!
//! Uses Taylor's theorem instead of antiderivatives. The integral of f from a to b is `(b - a)` times that of `f(a +
//! (b - a) t)` for t from 0 to 1, and this interval is divided into equal pieces. On a piece with midpoint c and half
//! width r, the expansion `f = c_0 + c_1 e + ... + c_n e^n + R` with `e = t - c` and odd n contributes the sum of `2
//! c_k r^(k+1)/(k+1)` over even k. Since `R = c_(n+1)(t') e^(n+1)` for some t' of the piece (Lagrange), where
//! `e^(n+1)` is nonnegative, the integral of R is `2 r^(n+2)/(n+2)` times a number between the minimum and the
//! maximum of `c_(n+1)` on the piece. So polynomials up to degree n are integrated exactly.
//!
//! First the integrand is tested for points where it has no value, at both ends, the joints of pieces and their
//! midpoints: it may be undefined there; and a divisor with different signs at two of these points vanishes between
//! them, because it is continuous where it is defined.

use super::evaluate::{Evaluator, Outcome};
use crate::arithmetic::{Arithmetic, Comparison};
use crate::no_value::{NoValue, Undefined, Unknown};
use crate::series::Series;
use crate::value::Value;
use torse_numbers::Rational;
use torse_numbers::rational::integer;

/// The number of pieces and the odd order of the expansion on each, for successive attempts.
const PLANS: [(i64, u16); 5] = [(1, 7), (2, 27), (4, 31), (10, 35), (24, 39)];
/// The number of pieces whose ends and midpoints are tested.
const TESTED_PIECES: i64 = 4;

type Number<A> = Series<<A as Arithmetic>::Number>;

impl<'a, A: Arithmetic> Evaluator<'a, '_, A> {
    /// The integral of a body, as a function of its variable, between these limits.
    pub(super) fn integral(
        &self,
        [low, high]: &[Number<A>; 2],
        body: &dyn Fn(Number<A>) -> Outcome<A>,
    ) -> Outcome<A> {
        let a = self.arithmetic;
        if let Some(shares) = a.stands_for_integral() {
            let length = high.minus(low, a)?;
            return shares
                .iter()
                .try_fold(self.integer_value(0), |sum, (share, weight)| {
                    let way = length.times(&Series::rational(share, a), a)?;
                    let value = body(low.plus(&way, a)?)?;
                    let weight = Series::rational(weight, a).times(&length, a)?;
                    sum.plus(&value.each(&|x| x.times(&weight, a))?, a)
                });
        }
        let what = "an integral, in this arithmetic";
        if a.between(&integer(0), &integer(1)).is_none() {
            return Err(Unknown::NotCovered { what }.into());
        }
        let length = high.minus(low, a)?;
        let place = |t: &Number<A>| low.plus(&length.times(t, a)?, a);
        self.check_defined(&|share| body(place(&Series::rational(share, a))?))?;
        for (pieces, order) in PLANS {
            if let Some(mean) = self.mean(pieces, order, &|t| body(place(&t)?))? {
                return mean.each(&|x| x.times(&length, a));
            }
        }
        Err(Unknown::Precision.into())
    }

    /// Fails if the integrand has no value at a tested point, or a divisor changes its sign.
    fn check_defined(&self, at: &dyn Fn(&Rational) -> Outcome<A>) -> Result<(), NoValue> {
        let mut before: Option<Vec<(usize, Option<bool>)>> = None;
        for step in 0..=2 * TESTED_PIECES {
            let share = Rational::new(step.into(), (2 * TESTED_PIECES).into());
            // A nested integral records its own divisors.
            let outer = self.divisors.replace(Some(vec![]));
            let value = at(&share);
            let found = self.divisors.replace(outer).unwrap_or_default();
            match value {
                Ok(_) => {}
                // A root may begin there: its values exist, and only its derivatives by an outer variable are
                // missing.
                Err(NoValue::Undefined(Undefined::NotDifferentiable)) if self.level.get() > 0 => {
                    return Err(Unknown::Precision.into());
                }
                Err(gap) => return Err(gap),
            }
            let signs = found
                .into_iter()
                .map(|(node, number)| (node, self.is_positive(&number)));
            let signs: Vec<_> = signs.collect();
            if let Some(before) = before.filter(|before| before.len() == signs.len()) {
                let changes = before.iter().zip(&signs).any(|((node, x), (other, y))| {
                    node == other && matches!((x, y), (Some(x), Some(y)) if x != y)
                });
                if changes {
                    return Err(Undefined::ZeroDivisor.into());
                }
            }
            before = Some(signs);
        }
        Ok(())
    }

    fn is_positive(&self, number: &A::Number) -> Option<bool> {
        let zero = self.arithmetic.integer(0);
        match self.arithmetic.compare(number, &zero) {
            Ok(Comparison::Less) => Some(false),
            Ok(Comparison::Greater) => Some(true),
            _ => None,
        }
    }

    /// The integral over t from 0 to 1, if it can be enclosed narrowly enough.
    fn mean(
        &self,
        pieces: i64,
        order: u16,
        body: &dyn Fn(Number<A>) -> Outcome<A>,
    ) -> Result<Option<Value<A::Number>>, NoValue> {
        let a = self.arithmetic;
        let part = |n: i64| Rational::new(n.into(), (2 * pieces).into());
        let half = part(1);
        // 2 r^(k+1)/(k+1)
        let weight = |k: u16| {
            let power: Rational = (0..=k).map(|_| half.clone()).product();
            Series::rational(&(power * integer(2) / integer(i64::from(k) + 1)), a)
        };
        // The sum of the weighted coefficients of these orders.
        let share = |t: A::Number, order: u16, orders: &[u16]| {
            self.at_new_level(|level| {
                let t = Series::Number(t).shifted(level, usize::from(order), a);
                let value = body(t)?;
                orders.iter().try_fold(self.integer_value(0), |sum, k| {
                    let term = value.each(&|f| {
                        let coefficient = f.coefficient(level, usize::from(*k), a);
                        coefficient.times(&weight(*k), a)
                    })?;
                    sum.plus(&term, a)
                })
            })
        };
        let even: Vec<u16> = (0..=order).step_by(2).collect();
        let mut total = self.integer_value(0);
        for piece in 0..pieces {
            let Some(somewhere) = a.between(&part(2 * piece), &part(2 * piece + 2)) else {
                return Ok(None);
            };
            let rest = match share(somewhere, order + 1, &[order + 1]) {
                Ok(rest) => rest,
                // The enclosure of the whole piece is too wide.
                Err(NoValue::Unknown(Unknown::Precision)) => return Ok(None),
                // The expression may be undefined for the enclosure of the whole piece, yet defined at every point of
                // it.
                Err(NoValue::Undefined(_)) => return Ok(None),
                Err(gap) => return Err(gap),
            };
            let small = |x: &&Number<A>| x.all(&|number| a.is_negligible(number));
            if !rest.numbers().iter().all(small) {
                return Ok(None);
            }
            let middle = share(a.rational(&part(2 * piece + 1)), order, &even)?;
            total = total.plus(&middle, a)?.plus(&rest, a)?;
        }
        Ok(Some(total))
    }
}
