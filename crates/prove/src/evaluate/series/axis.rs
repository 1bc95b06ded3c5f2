//! One shift operator `(a + b E)^n S(E)` with a symbolic power n.

use super::polynomial_of;
use torse_algebra::fault_injection::{InjectedFault, injected};
use torse_algebra::{Affine, ExactError, Fraction};

/// What the coefficients of an [`Axis`] are applied to.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Target {
    /// The coefficient of this power of E alone.
    Entry(Affine),
    /// The sum over all powers i of the coefficient times the points with the index
    /// [`here`](super::here) = i.
    Sum,
    /// No operator at all: the sum over the points with the index [`here`](super::here) from the first to the second form.
    Each(Affine, Affine),
}

/// `(a + b E)^power (seeds[0] + seeds[1] E + ...) E^lowest`, applied to a target.
#[derive(Debug, Clone)]
pub struct Axis {
    /// The two factors of the step, a and b.
    pub operator: (Fraction, Fraction),
    /// The symbolic power of the step.
    pub power: Affine,
    /// Coefficients of E^lowest, E^(lowest+1), ...
    pub seeds: Vec<Fraction>,
    /// The lowest power of E.
    pub lowest: i64,
    /// What it is applied to.
    pub target: Target,
}

/// The product of two polynomials in E, given by coefficients.
fn product(a: &[Fraction], b: &[Fraction]) -> Vec<Fraction> {
    let mut result = vec![Fraction::zero(); (a.len() + b.len()).saturating_sub(1)];
    for (i, x) in a.iter().enumerate() {
        for (j, y) in b.iter().enumerate() {
            if let Some(slot) = result.get_mut(i + j) {
                *slot = slot.clone() + x.clone() * y.clone();
            }
        }
    }
    result
}

impl Axis {
    /// The step as a polynomial in E.
    fn step(&self) -> [Fraction; 2] {
        [self.operator.0.clone(), self.operator.1.clone()]
    }

    /// `power * rate (a + b E)^(power - 1) seeds`: what the rate of change of the step contributes to a
    /// derivation of the whole.
    fn moved(&self, rate: &[Fraction; 2]) -> Self {
        let power: Fraction = match injected(InjectedFault::PowerWithoutFactor) {
            true => Fraction::integer(1),
            false => polynomial_of(&self.power).into(),
        };
        Self {
            seeds: product(rate, &self.seeds)
                .into_iter()
                .map(|s| s * power.clone())
                .collect(),
            power: self.power.clone() - Affine::number(1),
            ..self.clone()
        }
    }

    /// The derivative by the variable or parameter `name`: a sum of such operators.
    pub(super) fn derivative(&self, name: &str) -> Vec<Self> {
        let seeds = self.seeds.iter().map(|s| s.derivative(name)).collect();
        let rate = self.step().map(|f| f.derivative(name));
        let parts = [
            self.moved(&rate),
            Self {
                seeds,
                ..self.clone()
            },
        ];
        parts.into_iter().filter(|a| !a.is_trivial()).collect()
    }

    /// Every coefficient multiplied with its power of E: the derivation `E d/dE`, which maps
    /// `(a + b E)^n S` to `n b E (a + b E)^(n-1) S + (a + b E)^n E S'`.
    pub(super) fn weighted(&self) -> Vec<Self> {
        let rate = [Fraction::zero(), self.operator.1.clone()];
        let seeds = self
            .seeds
            .iter()
            .zip(self.lowest..)
            .map(|(s, exponent)| s.clone() * Fraction::integer(exponent))
            .collect();
        let parts = [
            self.moved(&rate),
            Self {
                seeds,
                ..self.clone()
            },
        ];
        parts.into_iter().filter(|a| !a.is_trivial()).collect()
    }

    /// Whether the index stands anywhere but in the entry that is taken.
    pub(crate) fn depends_on(&self, index: &str) -> bool {
        let inside = |f: &Fraction| f.symbols().iter().any(|s| s.depends_on(index));
        inside(&self.operator.0)
            || inside(&self.operator.1)
            || self.seeds.iter().any(inside)
            || self.power.multiple_of(index) != 0
            || matches!(&self.target, Target::Each(low, high)
                if low.multiple_of(index) != 0 || high.multiple_of(index) != 0)
    }

    /// Whether this is zero.
    pub(super) fn is_trivial(&self) -> bool {
        self.seeds.iter().all(Fraction::is_zero)
    }

    /// Applies a replacement to every fraction inside.
    pub(super) fn mapped(
        &self,
        change: &impl Fn(&Fraction) -> Result<Fraction, ExactError>,
    ) -> Result<Self, ExactError> {
        Ok(Self {
            operator: (change(&self.operator.0)?, change(&self.operator.1)?),
            seeds: self.seeds.iter().map(change).collect::<Result<_, _>>()?,
            power: self.power.clone(),
            lowest: self.lowest,
            target: self.target.clone(),
        })
    }

    /// The highest power of E.
    #[must_use]
    pub fn top(&self) -> Affine {
        let last = i64::try_from(self.seeds.len()).unwrap_or(i64::MAX) - 1;
        self.power.clone() + Affine::number(self.lowest.saturating_add(last))
    }

    /// `E^top F(1/E)`: the coefficients in the opposite order, that of E^i here is that of E^(top - i)
    /// there. The target is read from the other end as well.
    #[must_use]
    pub fn reversed(&self) -> Self {
        let mut seeds = self.seeds.clone();
        seeds.reverse();
        Self {
            operator: (self.operator.1.clone(), self.operator.0.clone()),
            power: self.power.clone(),
            seeds,
            lowest: 0,
            target: match &self.target {
                Target::Entry(index) => Target::Entry(self.top() - index.clone()),
                other => other.clone(),
            },
        }
    }

    /// Whether no coefficient of this power of E can be other than zero. `least` and `greatest` bound
    /// index forms.
    pub(super) fn is_outside(
        &self,
        index: &Affine,
        least: &impl Fn(&Affine) -> Option<i64>,
        greatest: &impl Fn(&Affine) -> Option<i64>,
    ) -> bool {
        let below = index.clone() - Affine::number(self.lowest);
        let above = index.clone() - self.top();
        greatest(&below).is_some_and(|n| n < 0) || least(&above).is_some_and(|n| n > 0)
    }

    /// The value at E = 1 where a + b = 1: what a sum over constant points amounts to.
    pub(super) fn total(&self) -> Option<Fraction> {
        let step = self.operator.0.clone() + self.operator.1.clone();
        let zero = Fraction::zero();
        (step - Fraction::integer(1))
            .is_zero()
            .then(|| self.seeds.iter().fold(zero, |sum, s| sum + s.clone()))
    }

    /// What this is at E = 1: a formula, of which the power of the step is taken, and a factor.
    pub(super) fn at_one(&self) -> (Fraction, Fraction) {
        let zero = Fraction::zero();
        let seed = self.seeds.iter().fold(zero, |sum, s| sum + s.clone());
        let base = self.operator.0.clone() + self.operator.1.clone();
        (base, seed)
    }

    /// What the first or the last coefficient is, where one of these is taken: a formula, of which the power of the step is taken,
    /// and a factor.
    pub(super) fn outermost(&self) -> Option<(Fraction, Fraction)> {
        let Target::Entry(index) = &self.target else {
            return None;
        };
        if self.is_pure() {
            return None;
        }
        let first = *index == Affine::number(self.lowest);
        let (base, seed) = match first {
            true => (&self.operator.0, self.seeds.first()?),
            false if *index == self.top() => (&self.operator.1, self.seeds.last()?),
            false => return None,
        };
        Some((base.clone(), seed.clone()))
    }

    /// The powers of E that remain when the step has become 1 or a bare shift, or when the power is a
    /// number: the lowest exponent, and coefficients of which neither the first nor the last is zero.
    pub(super) fn collapsed(&self) -> Option<(Affine, Vec<Fraction>)> {
        let one = |f: &Fraction| (f.clone() - Fraction::integer(1)).is_zero();
        let (a, b) = &self.operator;
        let (start, mut seeds) = if one(a) && b.is_zero() {
            (Affine::number(self.lowest), self.seeds.clone())
        } else if a.is_zero() && one(b) {
            let start = self.power.clone() + Affine::number(self.lowest);
            (start, self.seeds.clone())
        } else {
            let power = self.power.as_number()?;
            (Affine::number(self.lowest), self.raised(power)?)
        };
        while seeds.last().is_some_and(Fraction::is_zero) {
            seeds.pop();
        }
        let leading = seeds.iter().take_while(|s| s.is_zero()).count();
        seeds.drain(..leading);
        let leading = i64::try_from(leading).unwrap_or(i64::MAX);
        Some((start + Affine::number(leading), seeds))
    }

    /// The seeds times `steps` steps; `None` for a negative number.
    pub(super) fn raised(&self, steps: i64) -> Option<Vec<Fraction>> {
        let step = self.step();
        let steps = usize::try_from(steps).ok()?;
        Some((0..steps).fold(self.seeds.clone(), |seeds, _| product(&seeds, &step)))
    }
}
