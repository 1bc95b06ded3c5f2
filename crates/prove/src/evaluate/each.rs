//! Sums of symbolic length over no basis: of polynomials in the index, and of points with such factors.
//!
//! The sum of a polynomial in the index is a polynomial in the ends ([`power_sum`]). Where points stand beside it, what is left are the sums of
//! `i^k P[i]`, which are carried as they are ([`Target::Each`]): two of them are equal if they are written alike.
//!
//! An inner sum up to the index of the outer one is **swapped** with it: for `lo <= l - c`
//!
//! `sum(i, lo, hi, f(i)*sum(j, l, i + c, p(j))) == sum(j, l, hi + c, sum(i, j - c, hi, f(i))*p(j))`,
//!
//! since both add up `f(i) p(j)` over the same pairs, and for a polynomial f the inner sum is one in j.

use super::Evaluator;
use super::power_sum;
use super::quantity::Quantity;
use super::series::{Axis, Series, Target, here, split, with_index};
use torse_algebra::{Affine, Fraction, Symbol};

/// The sum over the points from one form to another.
fn each(low: &Affine, high: &Affine, factor: Fraction, points: Fraction) -> Series {
    Series {
        axes: vec![Axis {
            operator: (Fraction::zero(), Fraction::zero()),
            power: Affine::default(),
            seeds: vec![Fraction::integer(1)],
            lowest: 0,
            target: Target::Each(low.clone(), high.clone()),
        }],
        factor,
        points,
    }
}

impl Evaluator<'_> {
    /// The sum of a polynomial in the index and in points at it; `None` for anything else.
    pub(super) fn each(
        &self,
        term: &Fraction,
        index: &str,
        low: &Affine,
        high: &Affine,
    ) -> Option<Quantity> {
        let length = high.clone() - low.clone() + Affine::number(1);
        self.least_in_sums(&length).filter(|n| *n >= 0)?;
        let before = low.clone() - Affine::number(1);
        let mut sum = Quantity::from(Fraction::zero());
        for part in split(term, index)? {
            let own = match part.points == Fraction::integer(1) {
                true => {
                    let upper = Fraction::from(power_sum::up_to(part.exponent, high));
                    let lower = Fraction::from(power_sum::up_to(part.exponent, &before));
                    Quantity::from(part.free * (upper - lower))
                }
                false => {
                    let place = Affine::symbol(&here(0));
                    let points = with_index(&part.points, index, &place).ok()?;
                    let power = Fraction::named(&here(0)).power(part.exponent.into()).ok()?;
                    each(low, high, part.free, power * points).into()
                }
            };
            sum = sum.plus(&own);
        }
        self.symbolic_degree.set(true);
        Some(sum)
    }

    /// The sum over `index` of a sum up to it; `None` for any other series.
    pub(super) fn swapped(
        &self,
        series: &Series,
        index: &str,
        low: &Affine,
        high: &Affine,
    ) -> Option<Quantity> {
        let [axis] = series.axes.as_slice() else {
            return None;
        };
        let Target::Each(first, last) = &axis.target else {
            return None;
        };
        let offset = (last.clone() - Affine::symbol(index)).as_number()?;
        let begins = first.clone() - Affine::number(offset) - low.clone();
        if first.multiple_of(index) != 0 || self.least_in_sums(&begins).is_none_or(|n| n < 0) {
            return None;
        }
        let moves = |f: &Fraction| f.symbols().iter().any(|s| s.depends_on(index));
        if moves(&series.points) {
            return None;
        }
        let name = here(0);
        let before = Affine::symbol(&name) - Affine::number(offset + 1);
        let top = high.clone() + Affine::number(offset);
        let mut sum = Quantity::from(Fraction::zero());
        for part in split(&series.factor, index)? {
            if moves(&part.points) {
                return None;
            }
            let upper = power_sum::up_to(part.exponent, high);
            let inner = &upper - &power_sum::up_to(part.exponent, &before);
            let coefficients = inner.coefficients_in(&Symbol::named(&name));
            for (exponent, coefficient) in (0..).zip(coefficients) {
                let power = Fraction::named(&name).power(exponent).ok()?;
                let factor = part.free.clone() * part.points.clone() * Fraction::from(coefficient);
                let points = power * series.points.clone();
                sum = sum.plus(&each(first, &top, factor, points).into());
            }
        }
        Some(sum)
    }

    /// The least value of an index form, where indices of enclosing sums are between the ends of these.
    fn least_in_sums(&self, form: &Affine) -> Option<i64> {
        let sums = self.sums.borrow();
        let least = sums
            .iter()
            .rev()
            .fold(form.clone(), |form, (name, low, high)| {
                match form.multiple_of(name) > 0 {
                    true => form.substituted(name, low),
                    false => form.substituted(name, high),
                }
            });
        self.declarations.least(&least)
    }
}
