//! Curves of a family with **symbolic degree**.
//!
//! The functions of degree k of a family with step factors a, b and seeds P are the coefficients of
//! `(a + b E)^n P(E)` with n = k - (degree of the seeds). A [`Series`] is such an expression applied to
//! a family of points (`sum over i of [E^i](...) * R[i]`) or one of its coefficients
//! (`[E^index](...)`). Derivation by the variable stays inside the class:
//!
//! `((a + b E)^n P)' = n (a + b E)^(n-1) (a' + b' E) P + (a + b E)^n P'`
//!
//! and at an end of the interval, where a = 1, b = 0 or a = 0, b = 1, the power collapses to 1 or to the
//! shift E^n, so that end point derivatives of every order come out for every degree at once.
//!
//! **Theorem.** A product of `(a + b E)^n` and P is zero for one n only if P = 0 (no zero divisors), so
//! two series with the same power are equal for every degree if and only if their seeds are: an
//! induction over the degree with the step applied to both sides.

use torse_algebra::{Affine, ExactError, Fraction, Polynomial, Symbol};

/// The index that stands for "here" in the points of a sum.
pub const HERE: &str = "#";

/// What the coefficients are applied to.
#[derive(Debug, Clone)]
pub enum Target {
    /// The coefficient of this power of E.
    Entry(Affine),
    /// The sum over all powers i of the coefficient times this term with [`HERE`] = i.
    Sum(Fraction),
}

/// `factor * (a + b E)^power * (seeds[0] + seeds[1] E + ...) * E^lowest`, applied to a target.
#[derive(Debug, Clone)]
pub struct Series {
    /// The two factors of the step.
    pub operator: (Fraction, Fraction),
    /// The symbolic power of the step.
    pub power: Affine,
    /// Coefficients of E^lowest, E^(lowest+1), ...
    pub seeds: Vec<Fraction>,
    /// The lowest power of E.
    pub lowest: i64,
    /// A factor in front, which may contain points of an enclosing sum.
    pub factor: Fraction,
    /// What it is applied to.
    pub target: Target,
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

/// The fraction with every index `name` replaced by a form, in families and as a number.
///
/// # Errors
/// [`ExactError::DivisionByZero`] when a denominator vanishes.
pub fn with_index(value: &Fraction, name: &str, form: &Affine) -> Result<Fraction, ExactError> {
    value.substituted(|symbol| match symbol {
        Symbol::Indexed(family, index) if symbol.depends_on(name) => {
            let index = index.iter().map(|i| i.substituted(name, form)).collect();
            Some(Fraction::symbol(Symbol::Indexed(family.clone(), index)))
        }
        Symbol::Named(n) if &**n == name => Some(polynomial_of(form).into()),
        _ => None,
    })
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

impl Series {
    /// The step as a polynomial in E.
    fn step(&self) -> [Fraction; 2] {
        [self.operator.0.clone(), self.operator.1.clone()]
    }

    /// The derivative by the variable or parameter `name`: one or more series.
    #[must_use]
    pub fn derivative(&self, name: &str) -> Vec<Self> {
        let mut parts = vec![];
        let rate: Vec<Fraction> = self.step().iter().map(|f| f.derivative(name)).collect();
        if rate.iter().any(|f| !f.is_zero()) {
            let power: Fraction = polynomial_of(&self.power).into();
            let seeds = product(&rate, &self.seeds)
                .into_iter()
                .map(|s| s * power.clone())
                .collect();
            parts.push(Self {
                seeds,
                power: self.power.clone() - Affine::number(1),
                ..self.clone()
            });
        }
        let seeds: Vec<Fraction> = self.seeds.iter().map(|s| s.derivative(name)).collect();
        parts.push(Self {
            seeds,
            ..self.clone()
        });
        parts.push(Self {
            factor: self.factor.derivative(name),
            ..self.clone()
        });
        if let Target::Sum(term) = &self.target {
            parts.push(Self {
                target: Target::Sum(term.derivative(name)),
                ..self.clone()
            });
        }
        parts.retain(|part| !part.is_trivial());
        parts
    }

    /// Whether a factor, all seeds or the points are zero.
    #[must_use]
    pub fn is_trivial(&self) -> bool {
        self.factor.is_zero()
            || self.seeds.iter().all(Fraction::is_zero)
            || matches!(&self.target, Target::Sum(term) if term.is_zero())
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
            operator: (change(&self.operator.0)?, change(&self.operator.1)?),
            seeds: self.seeds.iter().map(&change).collect::<Result<_, _>>()?,
            factor: change(&self.factor)?,
            target: match &self.target {
                Target::Sum(term) => Target::Sum(change(term)?),
                entry @ Target::Entry(_) => entry.clone(),
            },
            power: self.power.clone(),
            lowest: self.lowest,
        })
    }

    /// The powers of E that remain when the step has become 1 or a bare shift, or when the power is a
    /// number: pairs of an exponent and its coefficient.
    fn collapsed(&self) -> Option<(Affine, Vec<Fraction>)> {
        let one = |f: &Fraction| (f.clone() - Fraction::integer(1)).is_zero();
        let (a, b) = &self.operator;
        if one(a) && b.is_zero() {
            return Some((Affine::number(self.lowest), self.seeds.clone()));
        }
        if a.is_zero() && one(b) {
            return Some((
                self.power.clone() + Affine::number(self.lowest),
                self.seeds.clone(),
            ));
        }
        let power = usize::try_from(self.power.as_number()?).ok()?;
        let step = self.step();
        let seeds = (0..power).fold(self.seeds.clone(), |seeds, _| product(&seeds, &step));
        Some((Affine::number(self.lowest), seeds))
    }

    /// The value without any symbolic power, if it has one. `least` and `greatest` bound index forms.
    ///
    /// # Errors
    /// [`ExactError`] when a denominator of the points vanishes.
    pub fn value(
        &self,
        least: impl Fn(&Affine) -> Option<i64>,
        greatest: impl Fn(&Affine) -> Option<i64>,
    ) -> Result<Option<Fraction>, ExactError> {
        if self.is_trivial() {
            return Ok(Some(Fraction::zero()));
        }
        // A sum over constant points is the series at E = 1.
        if let Target::Sum(term) = &self.target
            && !term.symbols().iter().any(|s| s.depends_on(HERE))
        {
            let step = self.operator.0.clone() + self.operator.1.clone();
            if (step - Fraction::integer(1)).is_zero() {
                let total = self
                    .seeds
                    .iter()
                    .cloned()
                    .fold(Fraction::zero(), |sum, s| sum + s);
                return Ok(Some(self.factor.clone() * total * term.clone()));
            }
        }
        // No power of E outside lowest ..= power + lowest + (number of seeds) - 1 occurs.
        if let Target::Entry(index) = &self.target {
            let below = index.clone() - Affine::number(self.lowest);
            let top = self.lowest + i64::try_from(self.seeds.len()).unwrap_or(i64::MAX) - 1;
            let above = index.clone() - (self.power.clone() + Affine::number(top));
            if greatest(&below).is_some_and(|n| n < 0) || least(&above).is_some_and(|n| n > 0) {
                return Ok(Some(Fraction::zero()));
            }
        }
        let Some((start, mut seeds)) = self.collapsed() else {
            return Ok(None);
        };
        while seeds.last().is_some_and(Fraction::is_zero) {
            seeds.pop();
        }
        let leading = seeds.iter().take_while(|s| s.is_zero()).count();
        seeds.drain(..leading);
        let start = start + Affine::number(i64::try_from(leading).unwrap_or(0));
        let top = i64::try_from(seeds.len()).unwrap_or(i64::MAX) - 1;
        match &self.target {
            Target::Entry(index) => {
                let offset = index.clone() - start;
                let entry = match offset.as_number() {
                    Some(n) => usize::try_from(n)
                        .ok()
                        .and_then(|n| seeds.get(n).cloned())
                        .unwrap_or_else(Fraction::zero),
                    None if least(&offset).is_some_and(|n| n > top)
                        || greatest(&offset).is_some_and(|n| n < 0) =>
                    {
                        Fraction::zero()
                    }
                    None => return Ok(None),
                };
                Ok(Some(self.factor.clone() * entry))
            }
            Target::Sum(term) => {
                let mut total = Fraction::zero();
                for (position, seed) in seeds.into_iter().enumerate() {
                    let index =
                        start.clone() + Affine::number(i64::try_from(position).unwrap_or(i64::MAX));
                    total = total + seed * with_index(term, HERE, &index)?;
                }
                Ok(Some(self.factor.clone() * total))
            }
        }
    }

    /// The same series in a form that can be compared: an entry whose index counts down is read from
    /// the other end, and points that begin at an offset are shifted.
    fn canonical(&self) -> Result<Self, ExactError> {
        let mut series = self.clone();
        match &self.target {
            Target::Entry(index) => {
                let top = self.power.clone()
                    + Affine::number(
                        self.lowest + i64::try_from(self.seeds.len()).unwrap_or(i64::MAX) - 1,
                    );
                let counts_down = |form: &Affine| {
                    form.multiples()
                        .any(|(name, multiple)| multiple < 0 && self.power.multiple_of(name) == 0)
                };
                if counts_down(index) {
                    // [E^index] F(E) = [E^(top - index)] of F read backwards.
                    series.operator = (self.operator.1.clone(), self.operator.0.clone());
                    series.seeds.reverse();
                    series.lowest = 0;
                    series.target = Target::Entry(top - index.clone());
                }
                if let Target::Entry(index) = &series.target {
                    // [E^(i + c)] F = [E^i] of E^(-c) F.
                    let offset = index.constant();
                    series.lowest -= offset;
                    series.target = Target::Entry(index.clone() - Affine::number(offset));
                }
            }
            Target::Sum(term) => {
                let first = term.symbols().into_iter().find(|s| s.depends_on(HERE));
                if let Some(Symbol::Indexed(_, index)) = first {
                    let offset = index
                        .iter()
                        .find(|i| i.multiple_of(HERE) != 0)
                        .map_or(0, Affine::constant);
                    let back = Affine::symbol(HERE) - Affine::number(offset);
                    series.target = Target::Sum(with_index(term, HERE, &back)?);
                    series.lowest += offset;
                }
            }
        }
        Ok(series)
    }

    /// Whether both have the same step, comparable powers and the same target.
    fn comparable(&self, other: &Self) -> bool {
        let targets = match (&self.target, &other.target) {
            (Target::Entry(a), Target::Entry(b)) => a == b,
            (Target::Sum(a), Target::Sum(b)) => a == b,
            _ => false,
        };
        targets
            && self.operator.0 == other.operator.0
            && self.operator.1 == other.operator.1
            && (self.power.clone() - other.power.clone())
                .as_number()
                .is_some()
    }
}

/// Whether a sum of series is zero for every degree: groups comparable series, brings each group to its
/// smallest power and adds the seeds. `true` is a proof; `false` means that some group did not cancel.
///
/// # Errors
/// [`ExactError`] when a denominator of the points vanishes.
pub fn vanishes(all: &[Series]) -> Result<bool, ExactError> {
    let mut pending: Vec<Series> = all
        .iter()
        .map(Series::canonical)
        .collect::<Result<_, _>>()?;
    while let Some(first) = pending.pop() {
        let (group, rest): (Vec<Series>, Vec<Series>) =
            pending.into_iter().partition(|s| s.comparable(&first));
        pending = rest;
        let excess = |s: &Series| {
            (s.power.clone() - first.power.clone())
                .as_number()
                .unwrap_or(0)
        };
        let group: Vec<Series> = group
            .into_iter()
            .chain(std::iter::once(first.clone()))
            .collect();
        let smallest = group.iter().map(&excess).min().unwrap_or(0);
        let lowest = group.iter().map(|s| s.lowest).min().unwrap_or(0);
        let mut total: Vec<Fraction> = vec![];
        for series in &group {
            let step = series.step();
            let mut seeds = (0..excess(series) - smallest)
                .fold(series.seeds.clone(), |seeds, _| product(&seeds, &step));
            let shift = usize::try_from(series.lowest - lowest).unwrap_or(0);
            seeds.splice(0..0, std::iter::repeat_n(Fraction::zero(), shift));
            if total.len() < seeds.len() {
                total.resize(seeds.len(), Fraction::zero());
            }
            for (slot, seed) in total.iter_mut().zip(seeds) {
                *slot = slot.clone() + series.factor.clone() * seed;
            }
        }
        if total.iter().any(|s| !s.is_zero()) {
            return Ok(false);
        }
    }
    Ok(true)
}
