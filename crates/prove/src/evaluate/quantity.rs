//! A scalar quantity: an exact fraction plus series of symbolic degree.

use super::series::{self, Series};
use torse_algebra::{ExactError, Fraction, Polynomial};

/// The most products of series in one multiplication.
const MAX_PRODUCTS: usize = 64;

/// `plain + sum of series`.
#[derive(Debug, Clone)]
pub struct Quantity {
    /// The part without symbolic degree.
    pub plain: Fraction,
    /// The series.
    pub series: Vec<Series>,
}

impl From<Fraction> for Quantity {
    fn from(plain: Fraction) -> Self {
        Self {
            plain,
            series: vec![],
        }
    }
}

impl From<Series> for Quantity {
    fn from(series: Series) -> Self {
        Self {
            plain: Fraction::zero(),
            series: vec![series],
        }
    }
}

impl Quantity {
    /// The fraction, if there is no series.
    #[must_use]
    pub fn as_fraction(&self) -> Option<&Fraction> {
        self.series.is_empty().then_some(&self.plain)
    }

    /// The sum.
    #[must_use]
    pub fn plus(&self, other: &Self) -> Self {
        let series = self.series.iter().chain(&other.series).cloned().collect();
        Self {
            plain: &self.plain + &other.plain,
            series,
        }
    }

    /// The product with a fraction. A product with zero has a value where this has one.
    #[must_use]
    pub fn times(&self, factor: &Fraction) -> Self {
        if factor.is_zero() {
            let zero = Fraction::zero().under(factor.conditions());
            return zero.under(&self.conditions()).into();
        }
        let series = self
            .series
            .iter()
            .map(|s| Series {
                factor: &s.factor * factor,
                ..s.clone()
            })
            .collect();
        Self {
            plain: &self.plain * factor,
            series,
        }
    }

    /// The product; `None` if it has too many sums of symbolic degree.
    ///
    /// # Errors
    /// [`ExactError`] when a denominator vanishes.
    pub fn product(&self, other: &Self) -> Result<Option<Self>, ExactError> {
        if self.series.len() * other.series.len() > MAX_PRODUCTS {
            return Ok(None);
        }
        let own = Self {
            plain: Fraction::zero(),
            series: self.series.clone(),
        };
        let mut result = other.times(&self.plain).plus(&own.times(&other.plain));
        for a in &self.series {
            for b in &other.series {
                match a.product(b)? {
                    Some(series) => result.series.push(series),
                    None => return Ok(None),
                }
            }
        }
        Ok(Some(result))
    }

    /// The negative.
    #[must_use]
    pub fn negated(&self) -> Self {
        let series = self.series.iter().map(|s| Series {
            factor: -s.factor.clone(),
            ..s.clone()
        });
        Self {
            plain: -self.plain.clone(),
            series: series.collect(),
        }
    }

    /// The difference.
    #[must_use]
    pub fn minus(&self, other: &Self) -> Self {
        self.plus(&other.negated())
    }

    /// The derivative by the variable or parameter `name`, where this has a value.
    #[must_use]
    pub fn derivative(&self, name: &str) -> Self {
        let divisors: Vec<Polynomial> = self.series.iter().flat_map(Series::conditions).collect();
        Self {
            plain: self.plain.derivative(name).under(&divisors),
            series: self
                .series
                .iter()
                .flat_map(|s| s.derivative(name))
                .collect(),
        }
    }

    /// Applies a replacement to every fraction inside.
    ///
    /// # Errors
    /// Whatever the replacement returns.
    pub fn mapped(
        &self,
        change: impl Fn(&Fraction) -> Result<Fraction, ExactError>,
    ) -> Result<Self, ExactError> {
        Ok(Self {
            plain: change(&self.plain)?,
            series: self
                .series
                .iter()
                .map(|s| s.mapped(&change))
                .collect::<Result<_, _>>()?,
        })
    }

    /// Whether this is zero for every degree. `true` is a proof; `false` without series is one as well.
    ///
    /// # Errors
    /// [`ExactError`] when a denominator vanishes.
    pub fn vanishes(&self) -> Result<bool, ExactError> {
        Ok(self.plain.is_zero() && series::vanishes(&self.series)?)
    }

    /// Everything that was divided by on the way here.
    #[must_use]
    pub fn conditions(&self) -> Vec<Polynomial> {
        let mut all = self.plain.conditions().to_vec();
        all.extend(self.series.iter().flat_map(Series::conditions));
        all.sort();
        all.dedup();
        all
    }
}
