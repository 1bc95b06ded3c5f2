//! Doubles with infinitesimals: a number, or a truncated power series in the variable of one derivative, whose coefficients
//! are of the derivatives around it.

/// A number with infinitesimals.
#[derive(Debug, Clone)]
pub enum Jet {
    /// A number.
    Number(f64),
    /// Coefficients of the powers of the variable of this level; those inside have lower levels.
    Series(u32, Vec<Jet>),
}

use Jet::{Number, Series};

impl Jet {
    /// The variable of this level at a point, up to this power.
    #[must_use]
    pub fn variable(level: u32, point: Self, order: usize) -> Self {
        let mut coefficients = vec![point];
        coefficients.extend((1..=order).map(|k| Number(if k == 1 { 1.0 } else { 0.0 })));
        Series(level, coefficients)
    }

    /// The coefficient of this power of the variable of a level.
    #[must_use]
    pub fn coefficient(self, level: u32, power: usize) -> Self {
        match self {
            Series(own, coefficients) if own == level => {
                coefficients.into_iter().nth(power).unwrap_or(Number(0.0))
            }
            whole if power == 0 => whole,
            _ => Number(0.0),
        }
    }

    /// The number without infinitesimals.
    #[must_use]
    pub fn number(&self) -> f64 {
        match self {
            Number(x) => *x,
            Series(_, coefficients) => coefficients.first().map_or(0.0, Self::number),
        }
    }

    fn level(&self) -> u32 {
        match self {
            Number(_) => 0,
            Series(level, _) => *level,
        }
    }

    /// The sum.
    #[must_use]
    pub fn plus(&self, other: &Self) -> Self {
        match (self, other) {
            (Number(a), Number(b)) => Number(a + b),
            (Series(own, a), Series(level, b)) if own == level => {
                Series(*own, a.iter().zip(b).map(|(a, b)| a.plus(b)).collect())
            }
            (Series(own, a), b) if *own > b.level() => {
                let mut sum = a.clone();
                if let Some(first) = sum.first_mut() {
                    *first = first.plus(b);
                }
                Series(*own, sum)
            }
            _ => other.plus(self),
        }
    }

    /// The product.
    #[must_use]
    pub fn times(&self, other: &Self) -> Self {
        match (self, other) {
            (Number(a), Number(b)) => Number(a * b),
            (Series(own, a), Series(level, b)) if own == level => {
                let product = (0..a.len().min(b.len())).map(|n| {
                    let terms = a.iter().take(n + 1).zip(b.iter().take(n + 1).rev());
                    terms.fold(Number(0.0), |sum, (a, b)| sum.plus(&a.times(b)))
                });
                Series(*own, product.collect())
            }
            (Series(own, a), b) if *own > b.level() => {
                Series(*own, a.iter().map(|a| a.times(b)).collect())
            }
            _ => other.times(self),
        }
    }

    /// The product with a number.
    #[must_use]
    pub fn scaled(&self, factor: f64) -> Self {
        self.times(&Number(factor))
    }

    /// A function at this number, by Taylor's theorem: `rate(k, x)` is its k-th derivative at x, if it has one there.
    #[must_use]
    pub fn through(&self, rate: &dyn Fn(usize, f64) -> Option<f64>) -> Option<Self> {
        self.derived(rate, 0)
    }

    fn derived(&self, rate: &dyn Fn(usize, f64) -> Option<f64>, order: usize) -> Option<Self> {
        match self {
            Number(x) => rate(order, *x).filter(|y| y.is_finite()).map(Number),
            Series(level, coefficients) => {
                let first = coefficients.first()?;
                let mut step = coefficients.clone();
                if let Some(first) = step.first_mut() {
                    *first = Number(0.0);
                }
                let step = Series(*level, step);
                let mut power = Series(*level, {
                    let mut one = vec![Number(0.0); coefficients.len()];
                    if let Some(first) = one.first_mut() {
                        *first = Number(1.0);
                    }
                    one
                });
                let mut sum = power.scaled(0.0);
                let mut factorial = 1.0;
                for k in 0..coefficients.len() {
                    let value = first.derived(rate, order + k)?;
                    sum = sum.plus(&power.times(&value).scaled(1.0 / factorial));
                    power = power.times(&step);
                    factorial *= (k + 1) as f64;
                }
                Some(sum)
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn mixed_derivatives_of_a_product_have_no_confused_variables() {
        // D(x * D(x + y, y), x) is 1, and 2 if the two variables are taken for one.
        let x = Jet::variable(1, Number(3.0), 1);
        let y = Jet::variable(2, Number(5.0), 1);
        let inner = x.plus(&y).coefficient(2, 1);
        let outer = x.times(&inner).coefficient(1, 1);
        assert_eq!(outer.number(), 1.0);
    }

    #[test]
    fn the_third_derivative_of_an_exponential_of_a_square_is_right() {
        let x = Jet::variable(1, Number(0.5), 3);
        let found = x.times(&x).through(&|_, x| Some(x.exp()));
        let third = 6.0 * found.map_or(0.0, |jet| jet.coefficient(1, 3).number());
        // exp(x^2) (12 x + 8 x^3)
        assert!((third - 7.0 * 0.25_f64.exp()).abs() < 1e-12);
    }
}
