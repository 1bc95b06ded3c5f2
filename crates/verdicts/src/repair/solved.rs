//! Numbers that are solved for: what has to stand in the place of one number of the print, so that both sides agree.
//!
//! A side depends on one of its numbers x as `(a x + b)/(c x + d)` as long as x stands in no exponent and no power.
//! Such a map keeps cross ratios: its values at three numbers and the value that is wanted tell x. What is found at the
//! sample point is tried like any other edit.

use super::edit::{Change, Edit, exact_numbers, placed};
use super::subject::Subject;
use super::target::Target;
use num_traits::Zero;
use torse_algebra::rational::integer;
use torse_algebra::{Integer, Rational};
use torse_syntax::formula::Expr;

/// The largest numerator and denominator of a number that a print may have meant.
const MAX_PART: i64 = 1_000_000;

/// The formula with one number replaced by the one that makes the sides agree at the sample point, for each of its numbers;
/// integers for integers, where some do.
#[must_use]
pub fn edits(formula: &Expr, subject: &Subject, target: &Target<'_>) -> Vec<Edit> {
    let mut found: Vec<(bool, Edit)> = vec![];
    for (path, part, value) in exact_numbers(formula) {
        let side = |x: &Rational| {
            let number = Expr::number(x);
            placed(formula, &path, number)
        };
        let values = |x: &Rational| target.values(&subject.side(&side(x)));
        let Some(solution) = solution(value, &values, target.wanted()) else {
            continue;
        };
        let range = Integer::from(-MAX_PART)..=Integer::from(MAX_PART);
        let small = |part: &Integer| range.contains(part);
        if solution == -value.clone() || !small(solution.numer()) || !small(solution.denom()) {
            continue;
        }
        let expr = side(&solution);
        if target.agrees(&subject.side(&expr)) {
            let change = Change::replaced(part, &Expr::number(&solution));
            let keeps = solution.is_integer() || !value.is_integer();
            found.push((keeps, Edit { expr, change }));
        }
    }
    let any = found.iter().any(|(keeps, _)| *keeps);
    found.retain(|(keeps, _)| *keeps || !any);
    found.into_iter().map(|(_, edit)| edit).collect()
}

/// The number at which the values are those that are wanted, if they depend on it as they do on a number that is multiplied,
/// added or divided by.
fn solution(
    printed: &Rational,
    values: &dyn Fn(&Rational) -> Option<Vec<Rational>>,
    wanted: Option<Vec<Rational>>,
) -> Option<Rational> {
    let wanted = wanted?;
    let first = values(printed)?;
    let [second, third] = [1, 2].map(|step| values(&(printed + integer(step))));
    let (second, third) = (second?, third?);
    let entry = first
        .iter()
        .zip(&wanted)
        .position(|(own, wanted)| own != wanted)?;
    let at = |all: &[Rational]| all.get(entry).cloned();
    let (wanted, first) = (at(&wanted)?, at(&first)?);
    let (second, third) = (at(&second)?, at(&third)?);
    // The cross ratio of x, v, v + 1, v + 2 is that of the values.
    let below = (&wanted - &third) * (&second - &first);
    if below.is_zero() {
        return None;
    }
    let ratio = (&wanted - &first) * (&second - &third) / below;
    let sum = integer(1) + &ratio;
    (!sum.is_zero()).then(|| (printed + ratio * (printed + integer(2))) / sum)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_number_in_a_product_a_sum_or_a_denominator_is_found() {
        let known = |f: &dyn Fn(&Rational) -> Rational, meant: i64| {
            let values = |x: &Rational| Some(vec![f(x)]);
            let wanted = Some(vec![f(&integer(meant))]);
            solution(&integer(27), &values, wanted)
        };
        let factor = |x: &Rational| x * integer(5) + integer(3);
        let divisor = |x: &Rational| integer(7) / x + integer(1);
        assert_eq!(known(&factor, 21), Some(integer(21)));
        assert_eq!(known(&divisor, 2880), Some(integer(2880)));
    }
}
