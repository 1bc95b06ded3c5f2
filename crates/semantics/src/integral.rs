//! Integrals, by Taylor's theorem and without any antiderivative.
//!
//! The integral of f from a to b is `(b - a)` times that of `f(a + (b - a) t)` for t from 0 to 1, and this interval is cut into
//! equal pieces. On a piece with the middle c and the half width r the expansion `f = c_0 + c_1 e + ... + c_n e^n + R` with `e = t - c` and n odd
//! gives the sum of `2 c_k r^(k+1)/(k+1)` for even k, and since `R = c_(n+1)(t') e^(n+1)` for some t' of the piece (Lagrange), where
//! `e^(n+1)` is not negative, the integral of R is `2 r^(n+2)/(n+2)` times some number between the least and the greatest value of
//! `c_(n+1)` on the piece: the coefficient of f at a number of which only the piece is known encloses it. So a polynomial of a degree
//! up to n is integrated exactly.
//!
//! That f is evaluated on all of the piece shows that it has a value there. All numbers are series in the infinitesimals of
//! enclosing derivatives, whose coefficients are integrals of coefficients.

use crate::arithmetic::Arithmetic;
use crate::evaluate::{Evaluator, Outcome, Sc};
use crate::gap::{Gap, Unknown};
use crate::series::Series;
use crate::value::Value;
use torse_core::Term;
use torse_numbers::Rational;
use torse_numbers::rational::integer;

/// Into how many pieces the interval is cut, and the odd order to which f is expanded on each.
const PLANS: [(i64, u16); 5] = [(1, 7), (2, 27), (4, 31), (10, 35), (24, 39)];

impl<A: Arithmetic> Evaluator<'_, A> {
    /// The integral of the body by the variable.
    pub(crate) fn integral(
        &self,
        variable: u32,
        low: &Term,
        high: &Term,
        body: &Term,
        scope: &Sc<'_, A>,
    ) -> Outcome<A> {
        let (low, high) = (self.number(low, scope)?, self.number(high, scope)?);
        let length = high.minus(&low, self.arithmetic)?;
        if let Some(shares) = self.arithmetic.stands_for_integral() {
            let a = self.arithmetic;
            return shares
                .iter()
                .try_fold(self.integer_value(0), |sum, (share, weight)| {
                    let way = length.times(&Series::rational(share, a), a)?;
                    let place = Value::Number(low.plus(&way, a)?);
                    let value = self.term(body, &scope.with(variable, place))?;
                    let weight = Series::rational(weight, a).times(&length, a)?;
                    sum.plus(&value.each(&|x| x.times(&weight, a))?, a)
                });
        }
        // The body at `a + (b - a) (t + e)`, up to `e^order`.
        let level = scope.level + 1;
        let expanded = |t: A::Number, order: u16| {
            let t = Series::Number(t).shifted(level, usize::from(order), self.arithmetic);
            let place = low.plus(&length.times(&t, self.arithmetic)?, self.arithmetic)?;
            let mut inner = scope.with(variable, Value::Number(place));
            inner.level = level;
            self.term(body, &inner)
        };
        for (pieces, order) in PLANS {
            if let Some(mean) = self.mean(pieces, order, level, &expanded)? {
                return mean.each(&|x| x.times(&length, self.arithmetic));
            }
        }
        Err(Unknown::Precision.into())
    }

    /// The integral over t from 0 to 1, if it is known well enough.
    fn mean(
        &self,
        pieces: i64,
        order: u16,
        level: usize,
        expanded: &dyn Fn(A::Number, u16) -> Outcome<A>,
    ) -> Result<Option<Value<A::Number>>, Gap> {
        let a = self.arithmetic;
        let part = |n: i64| Rational::new(n.into(), (2 * pieces).into());
        let half = part(1);
        // 2 r^(k+1)/(k+1)
        let weight = |k: u16| {
            let power: Rational = (0..=k).map(|_| half.clone()).product();
            Series::rational(&(power * integer(2) / integer(i64::from(k) + 1)), a)
        };
        let mut total = self.integer_value(0);
        for piece in 0..pieces {
            let what = "an integral, in this arithmetic";
            let somewhere = a.between(&part(2 * piece), &part(2 * piece + 2));
            let somewhere = somewhere.ok_or(Unknown::NotCovered { what })?;
            let rest = match expanded(somewhere, order + 1) {
                Ok(rest) => rest,
                // Too little is known of a number of the whole piece.
                Err(Gap::Unknown(Unknown::Precision)) => return Ok(None),
                Err(gap) => return Err(gap),
            };
            let rest = rest.each(&|f| {
                let last = f.coefficient(level, usize::from(order) + 1, a);
                last.times(&weight(order + 1), a)
            })?;
            let small = |x: &&Series<A::Number>| x.all(&|number| a.is_negligible(number));
            if !rest.numbers().iter().all(small) {
                return Ok(None);
            }
            let middle = expanded(a.rational(&part(2 * piece + 1)), order)?;
            for k in (0..=order).step_by(2) {
                let share = middle.each(&|f| {
                    let coefficient = f.coefficient(level, usize::from(k), a);
                    coefficient.times(&weight(k), a)
                })?;
                total = total.plus(&share, a)?;
            }
            total = total.plus(&rest, a)?;
        }
        Ok(Some(total))
    }
}
