//! Curves and surfaces of a family with **symbolic degrees**.
//!
//! The functions of degree k of a family with step factors a, b and seeds P are the coefficients of
//! `(a + b E)^n P(E)` with n = k - (degree of the seeds). An [`Axis`] is such an operator, applied to a
//! family of points (`sum over i of [E^i](...) * R[i]`) or one of its coefficients (`[E^index](...)`).
//! A [`Series`] is a product of axes, each with a shift of its own: one for a curve, two for a tensor
//! product surface or a product of two curves. Derivation by the variable stays inside the class:
//!
//! `((a + b E)^n P)' = n (a + b E)^(n-1) (a' + b' E) P + (a + b E)^n P'`
//!
//! and so does the factor i in `[E^i]`, the derivation `E d/dE`. At an end of the interval, where a = 1,
//! b = 0 or a = 0, b = 1, the power collapses to 1 or to the shift E^n, so that end point derivatives of
//! every order come out for every degree at once.
//!
//! **Theorem.** A product of `(a + b E)^n` and P is zero for one n only if P = 0 (no zero divisors, with
//! one shift or several), so series with the same powers are equal for all degrees if and only if their
//! seeds are: an induction over the degrees with the steps applied to both sides.

mod axis;
mod cancel;
mod weight;

pub use axis::{Axis, Target};
pub use cancel::vanishes;
use std::collections::BTreeMap;
use torse_algebra::{Affine, ExactError, Fraction, Polynomial, Symbol};
pub(super) use weight::split;

/// The most axes of one series.
const MAX_AXES: usize = 3;

/// The index that stands for the power of E of an axis in the points of a series.
#[must_use]
pub fn here(axis: usize) -> String {
    format!("#{axis}")
}

/// `factor * (product of the axes)`, applied to points.
#[derive(Debug, Clone)]
pub struct Series {
    /// The operators.
    pub axes: Vec<Axis>,
    /// A factor in front, which may contain points of an enclosing sum.
    pub factor: Fraction,
    /// What the coefficients are applied to: a term in which [`here`] stands for the powers of E of the
    /// axes that are summed over.
    pub points: Fraction,
}

/// The polynomial k for an integer form.
#[must_use]
pub fn polynomial_of(form: &Affine) -> Polynomial {
    form.multiples().fold(
        Polynomial::integer(form.constant()),
        |sum, (name, multiple)| {
            &sum + &Polynomial::named(name).scaled(&torse_algebra::rational::integer(multiple))
        },
    )
}

/// The fraction with indices replaced by forms, all at once, in families and as numbers.
///
/// # Errors
/// [`ExactError::DivisionByZero`] when a denominator vanishes.
pub fn with_indices(
    value: &Fraction,
    forms: &BTreeMap<String, Affine>,
) -> Result<Fraction, ExactError> {
    let replaced = |form: &Affine| {
        form.multiples()
            .fold(Affine::number(form.constant()), |sum, (name, multiple)| {
                let own = || Affine::symbol(name);
                sum + forms.get(name).cloned().unwrap_or_else(own) * multiple
            })
    };
    let depends = |symbol: &Symbol| forms.keys().any(|name| symbol.depends_on(name));
    value.substituted(|symbol| match symbol {
        Symbol::Indexed(family, index) if depends(symbol) => {
            let index = index.iter().map(replaced).collect();
            Some(Fraction::symbol(Symbol::Indexed(family.clone(), index)))
        }
        Symbol::Named(name) => forms.get(&**name).map(|form| polynomial_of(form).into()),
        _ => None,
    })
}

/// The fraction with one index replaced by a form.
///
/// # Errors
/// Those of [`with_indices`].
pub fn with_index(value: &Fraction, name: &str, form: &Affine) -> Result<Fraction, ExactError> {
    with_indices(value, &BTreeMap::from([(name.to_owned(), form.clone())]))
}

impl Series {
    /// One coefficient of an operator.
    #[must_use]
    pub fn entry(axis: Axis) -> Self {
        Self {
            axes: vec![axis],
            factor: Fraction::integer(1),
            points: Fraction::integer(1),
        }
    }

    /// The derivative by the variable or parameter `name`: one or more series.
    #[must_use]
    pub fn derivative(&self, name: &str) -> Vec<Self> {
        let mut parts: Vec<Self> = vec![];
        for (position, axis) in self.axes.iter().enumerate() {
            let moved = axis.derivative(name);
            parts.extend(moved.into_iter().map(|axis| self.with_axis(position, axis)));
        }
        parts.push(Self {
            factor: self.factor.derivative(name),
            ..self.clone()
        });
        parts.push(Self {
            points: self.points.derivative(name),
            ..self.clone()
        });
        parts.retain(|part| !part.is_trivial());
        parts
    }

    /// The same with one axis replaced.
    pub(super) fn with_axis(&self, position: usize, axis: Axis) -> Self {
        let mut series = self.clone();
        if let Some(slot) = series.axes.get_mut(position) {
            *slot = axis;
        }
        series
    }

    /// The product; `None` if it has too many axes.
    ///
    /// # Errors
    /// [`ExactError`] when a denominator of the points vanishes.
    pub fn product(&self, other: &Self) -> Result<Option<Self>, ExactError> {
        let count = self.axes.len();
        if count + other.axes.len() > MAX_AXES {
            return Ok(None);
        }
        if let Some(merged) = self.merged(other) {
            return Ok(Some(merged));
        }
        match (self.is_power(), other.is_power(), other.axes.as_slice()) {
            (true, false, _) => return other.product(self),
            // One power after the other, so that each finds its own.
            (_, true, [first, rest @ ..]) if !rest.is_empty() => {
                let first = Self::entry(first.clone());
                let rest = Self {
                    axes: rest.to_vec(),
                    ..other.clone()
                };
                return match self.product(&first)? {
                    Some(product) => product.product(&rest),
                    None => Ok(None),
                };
            }
            _ => {}
        }
        let behind = (0..other.axes.len())
            .map(|axis| (here(axis), Affine::symbol(&here(axis + count))))
            .collect();
        Ok(Some(Self {
            axes: self.axes.iter().chain(&other.axes).cloned().collect(),
            factor: self.factor.clone() * other.factor.clone(),
            points: self.points.clone() * with_indices(&other.points, &behind)?,
        }))
    }

    /// Whether it is a product of powers of formulas, with a factor.
    fn is_power(&self) -> bool {
        self.points == Fraction::integer(1) && self.axes.iter().all(Axis::is_pure)
    }

    /// The product with the power of a formula of which this series has one already: the exponents are added.
    fn merged(&self, other: &Self) -> Option<Self> {
        let ([own], true) = (other.axes.as_slice(), other.points == Fraction::integer(1)) else {
            return None;
        };
        let same = |axis: &Axis| axis.is_pure() && own.is_pure() && axis.operator == own.operator;
        let position = self.axes.iter().position(same)?;
        let axis = self.axes.get(position)?;
        let seeds = axis.seeds.iter().zip(&own.seeds);
        let merged = Axis {
            power: axis.power.clone() + own.power.clone(),
            seeds: seeds.map(|(a, b)| a.clone() * b.clone()).collect(),
            ..axis.clone()
        };
        Some(Self {
            factor: self.factor.clone() * other.factor.clone(),
            ..self.with_axis(position, merged)
        })
    }

    /// Whether a factor or the points are zero.
    #[must_use]
    pub fn is_trivial(&self) -> bool {
        self.factor.is_zero() || self.points.is_zero() || self.axes.iter().any(Axis::is_trivial)
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
            axes: self
                .axes
                .iter()
                .map(|axis| axis.mapped(&change))
                .collect::<Result<_, _>>()?,
            factor: change(&self.factor)?,
            points: change(&self.points)?,
        })
    }

    /// The same without the axes whose power collapses: a plain value, and the series that are left.
    /// `least` and `greatest` bound index forms.
    ///
    /// # Errors
    /// [`ExactError`] when a denominator of the points vanishes.
    pub fn settled(
        self,
        least: &impl Fn(&Affine) -> Option<i64>,
        greatest: &impl Fn(&Affine) -> Option<i64>,
    ) -> Result<(Fraction, Vec<Self>), ExactError> {
        let (mut plain, mut left, mut pending) = (Fraction::zero(), vec![], vec![self]);
        while let Some(series) = pending.pop() {
            if series.is_trivial() {
                plain = plain.under(&series.conditions());
                continue;
            }
            if series.axes.is_empty() {
                plain = plain + series.factor * series.points;
                continue;
            }
            let mut parts = None;
            for position in 0..series.axes.len() {
                parts = series.without(position, least, greatest)?;
                if parts.is_some() {
                    break;
                }
            }
            match parts {
                Some(parts) => pending.extend(parts),
                None => left.push(series),
            }
        }
        Ok((plain, left))
    }

    /// The same without one axis, if its power collapses.
    fn without(
        &self,
        position: usize,
        least: &impl Fn(&Affine) -> Option<i64>,
        greatest: &impl Fn(&Affine) -> Option<i64>,
    ) -> Result<Option<Vec<Self>>, ExactError> {
        let Some(axis) = self.axes.get(position) else {
            return Ok(None);
        };
        let index_here = here(position);
        match &axis.target {
            Target::Sum if !depends(&self.points, &index_here) => {
                if let Some(total) = axis.total() {
                    return Ok(Some(vec![self.cut(position, total, &Affine::default())?]));
                }
                // Over constant points it is the power at E = 1.
                return self.with_power(position, axis.at_one());
            }
            Target::Entry(index) if axis.is_outside(index, least, greatest) => {
                return Ok(Some(vec![]));
            }
            Target::Each(..) => return Ok(None),
            _ => {}
        }
        if axis.is_pure() && axis.operator.0.is_zero() && least(&axis.power).is_some_and(|n| n > 0)
        {
            return Ok(Some(vec![]));
        }
        let Some((start, seeds)) = axis.collapsed() else {
            return match axis.outermost() {
                Some(power) => self.with_power(position, power),
                None => Ok(None),
            };
        };
        let Target::Entry(index) = &axis.target else {
            let terms = seeds.into_iter().zip(0..);
            return terms
                .map(|(seed, i)| self.cut(position, seed, &(start.clone() + Affine::number(i))))
                .collect::<Result<_, _>>()
                .map(Some);
        };
        let count = i64::try_from(seeds.len()).unwrap_or(i64::MAX);
        let offset = index.clone() - start;
        let entry = match offset.as_number() {
            Some(n) => usize::try_from(n).ok().and_then(|n| seeds.get(n).cloned()),
            None if least(&offset).is_some_and(|n| n >= count)
                || greatest(&offset).is_some_and(|n| n < 0) =>
            {
                None
            }
            None => return Ok(None),
        };
        let entry = entry.map(|entry| self.cut(position, entry, &Affine::default()));
        Ok(Some(entry.transpose()?.into_iter().collect()))
    }

    /// The axis replaced by its power of a formula and a factor; nothing if that has too many factors.
    fn with_power(
        &self,
        position: usize,
        (base, factor): (Fraction, Fraction),
    ) -> Result<Option<Vec<Self>>, ExactError> {
        let Some(axis) = self.axes.get(position) else {
            return Ok(None);
        };
        let mut series = self.cut(position, factor, &Affine::default())?;
        if base.is_zero() {
            return Ok(None);
        }
        for own in Axis::powers(&base, &axis.power)? {
            match series.product(&Self::entry(own))? {
                Some(product) => series = product,
                None => return Ok(None),
            }
        }
        Ok(Some(vec![series]))
    }

    /// The axis replaced by a factor, its index by a form.
    fn cut(&self, position: usize, factor: Fraction, index: &Affine) -> Result<Self, ExactError> {
        let mut axes = self.axes.clone();
        axes.remove(position);
        let mut forms = BTreeMap::from([(here(position), index.clone())]);
        for later in position + 1..self.axes.len() {
            forms.insert(here(later), Affine::symbol(&here(later - 1)));
        }
        Ok(Self {
            axes,
            factor: self.factor.clone() * factor,
            points: with_indices(&self.points, &forms)?,
        })
    }

    /// Every fraction inside.
    pub(super) fn parts(&self) -> impl Iterator<Item = &Fraction> {
        let axes = self.axes.iter().flat_map(|axis| {
            let step = [&axis.operator.0, &axis.operator.1];
            step.into_iter().chain(&axis.seeds)
        });
        axes.chain([&self.factor, &self.points])
    }

    /// Everything that was divided by in its parts.
    pub(super) fn conditions(&self) -> Vec<Polynomial> {
        let all = self.parts().flat_map(Fraction::conditions);
        all.cloned().collect()
    }
}

/// Whether the index occurs.
fn depends(value: &Fraction, index: &str) -> bool {
    value.symbols().iter().any(|s| s.depends_on(index))
}
