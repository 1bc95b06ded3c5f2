//! Truncated power series in infinitesimals, one infinitesimal for each derivative that encloses the term.
//!
//! To differentiate `body` n times by x at p, x gets the value `p + e`, the body is evaluated with `e^(n+1) = 0`, and
//! the derivative is n! times the coefficient of `e^n` (Taylor). The product, quotient and chain rules follow from
//! the arithmetic of series. A derivative inside of a derivative has an infinitesimal of its own, one level higher:
//! its coefficients are series in the outer infinitesimals.

use crate::arithmetic::{Arithmetic, Comparison};
use crate::no_value::{NoValue, Undefined, Unknown};
use std::rc::Rc;
use torse_numbers::Rational;

/// A number, or a series in the infinitesimal of its level. Clones share the coefficients.
#[derive(Debug, Clone, PartialEq)]
pub enum Series<N> {
    /// A number.
    Number(N),
    /// `terms[0] + terms[1] e + terms[2] e^2 + ...`, truncated: all series of one level have the same number of
    /// terms.
    Powers {
        /// The level of the infinitesimal; the coefficients contain only lower ones.
        level: usize,
        /// The coefficients, at least one.
        terms: Rc<[Series<N>]>,
    },
}

type Outcome<N> = Result<Series<N>, NoValue>;

impl<N: Clone + PartialEq + std::fmt::Debug> Series<N> {
    /// The rational number q.
    pub fn rational<A: Arithmetic<Number = N>>(q: &Rational, a: &A) -> Self {
        Self::Number(a.rational(q))
    }

    /// The integer n.
    pub fn integer<A: Arithmetic<Number = N>>(n: i64, a: &A) -> Self {
        Self::Number(a.integer(n))
    }

    /// `self + e`, truncated after `e^order`, where `e` has a higher level than all infinitesimals in `self`.
    pub fn shifted<A: Arithmetic<Number = N>>(self, level: usize, order: usize, a: &A) -> Self {
        let mut terms = vec![Self::integer(0, a); order + 1];
        if let Some(slot) = terms.get_mut(1) {
            *slot = Self::integer(1, a);
        }
        if let Some(slot) = terms.get_mut(0) {
            *slot = self;
        }
        Self::powers(level, terms)
    }

    /// The coefficient of `e^order` of the infinitesimal of this level, which is the highest.
    pub fn coefficient<A: Arithmetic<Number = N>>(
        &self,
        level: usize,
        order: usize,
        a: &A,
    ) -> Self {
        match self {
            Self::Powers { level: own, terms } if *own == level => terms
                .get(order)
                .cloned()
                .unwrap_or_else(|| Self::integer(0, a)),
            _ if order == 0 => self.clone(),
            _ => Self::integer(0, a),
        }
    }

    /// The number, if no infinitesimal occurs in it.
    pub fn as_number(&self) -> Option<&N> {
        match self {
            Self::Number(number) => Some(number),
            Self::Powers { .. } => None,
        }
    }

    /// Whether all numbers in it satisfy a predicate.
    pub fn all(&self, predicate: &dyn Fn(&N) -> bool) -> bool {
        match self {
            Self::Number(number) => predicate(number),
            Self::Powers { terms, .. } => terms.iter().all(|term| term.all(predicate)),
        }
    }

    /// The level of the highest infinitesimal in it; 0 for numbers.
    pub(crate) fn level(&self) -> usize {
        match self {
            Self::Number(_) => 0,
            Self::Powers { level, .. } => *level,
        }
    }

    fn powers(level: usize, terms: Vec<Self>) -> Self {
        Self::Powers {
            level,
            terms: terms.into(),
        }
    }

    /// The coefficients of both as series of the higher level of the two; a series of lower level has only the first
    /// coefficient.
    fn aligned<'s>(x: &'s Self, y: &'s Self) -> (usize, &'s [Self], &'s [Self]) {
        let level = x.level().max(y.level());
        let terms = |s: &'s Self| match s {
            Self::Powers { level: own, terms } if *own == level => &**terms,
            _ => std::slice::from_ref(s),
        };
        (level, terms(x), terms(y))
    }

    /// `self + other`.
    pub fn plus<A: Arithmetic<Number = N>>(&self, other: &Self, a: &A) -> Outcome<N> {
        if let (Self::Number(x), Self::Number(y)) = (self, other) {
            return Ok(Self::Number(a.plus(x, y)?));
        }
        let (level, xs, ys) = Self::aligned(self, other);
        let (longer, shorter) = if xs.len() < ys.len() {
            (ys, xs)
        } else {
            (xs, ys)
        };
        let mut terms = Vec::with_capacity(longer.len());
        for (x, y) in longer.iter().zip(shorter) {
            terms.push(x.plus(y, a)?);
        }
        terms.extend(longer.iter().skip(shorter.len()).cloned());
        Ok(Self::powers(level, terms))
    }

    /// `-self`.
    pub fn negated<A: Arithmetic<Number = N>>(&self, a: &A) -> Self {
        match self {
            Self::Number(x) => Self::Number(a.negated(x)),
            Self::Powers { level, terms } => {
                Self::powers(*level, terms.iter().map(|t| t.negated(a)).collect())
            }
        }
    }

    /// `self - other`.
    pub fn minus<A: Arithmetic<Number = N>>(&self, other: &Self, a: &A) -> Outcome<N> {
        self.plus(&other.negated(a), a)
    }

    /// `self * other`: `c_k = sum of x_j y_(k-j)`.
    pub fn times<A: Arithmetic<Number = N>>(&self, other: &Self, a: &A) -> Outcome<N> {
        if let (Self::Number(x), Self::Number(y)) = (self, other) {
            return Ok(Self::Number(a.times(x, y)?));
        }
        let (level, xs, ys) = Self::aligned(self, other);
        let length = xs.len().max(ys.len());
        let mut terms = Vec::with_capacity(length);
        for k in 0..length {
            terms.push(Self::convolution(xs, ys, 0, k, a)?);
        }
        Ok(Self::powers(level, terms))
    }

    /// `sum of x_j y_(k-j)` for j from `first` to k; missing coefficients are zero.
    fn convolution<A: Arithmetic<Number = N>>(
        xs: &[Self],
        ys: &[Self],
        first: usize,
        k: usize,
        a: &A,
    ) -> Outcome<N> {
        let pairs = (first..=k).filter_map(|j| Some((xs.get(j)?, ys.get(k - j)?)));
        let mut total: Option<Self> = None;
        for (x, y) in pairs {
            // Most coefficients are zero if a term hardly depends on the variable.
            if x.is_zero(a) == Some(true) || y.is_zero(a) == Some(true) {
                continue;
            }
            let product = x.times(y, a)?;
            total = Some(match total {
                None => product,
                Some(before) => before.plus(&product, a)?,
            });
        }
        Ok(total.unwrap_or_else(|| Self::integer(0, a)))
    }

    /// `self / other`: `q_k = (x_k - sum of y_j q_(k-j) for j >= 1) / y_0`.
    pub fn over<A: Arithmetic<Number = N>>(&self, other: &Self, a: &A) -> Outcome<N> {
        if let (Self::Number(x), Self::Number(y)) = (self, other) {
            return Ok(Self::Number(a.over(x, y)?));
        }
        let (level, xs, ys) = Self::aligned(self, other);
        let (leading, none) = (ys.first().ok_or(Unknown::Precision)?, Self::integer(0, a));
        let length = xs.len().max(ys.len());
        let mut quotient: Vec<Self> = Vec::with_capacity(length);
        for k in 0..length {
            let x = xs.get(k).unwrap_or(&none);
            let known = Self::convolution(ys, &quotient, 1, k, a)?;
            quotient.push(x.minus(&known, a)?.over(leading, a)?);
        }
        Ok(Self::powers(level, quotient))
    }

    /// `self^exponent` by squaring; `x^0` is 1.
    pub fn power<A: Arithmetic<Number = N>>(&self, exponent: u64, a: &A) -> Outcome<N> {
        let mut power = Self::integer(1, a);
        let mut square = self.clone();
        let mut rest = exponent;
        while rest > 0 {
            if rest % 2 == 1 {
                power = power.times(&square, a)?;
            }
            rest /= 2;
            if rest > 0 {
                square = square.times(&square, a)?;
            }
        }
        Ok(power)
    }

    /// The square root: `s^2 = x` gives `s_k = (x_k - sum of s_j s_(k-j) for 0 < j < k) / (2 s_0)`.
    ///
    /// A root of a series that begins with a first power has no derivative.
    pub fn square_root<A: Arithmetic<Number = N>>(&self, a: &A) -> Outcome<N> {
        let (level, terms) = match self {
            Self::Number(x) => return Ok(Self::Number(a.square_root(x)?)),
            Self::Powers { level, terms } => (*level, terms),
        };
        let Some((first, rest)) = terms.split_first() else {
            return Err(Unknown::Precision.into());
        };
        if first.is_zero(a) == Some(true) && !rest.is_empty() {
            return Err(Undefined::NotDifferentiable.into());
        }
        let mut root = vec![first.square_root(a)?];
        let twice = root
            .first()
            .ok_or(Unknown::Precision)?
            .times(&Self::integer(2, a), a)?;
        for (before, x) in rest.iter().enumerate() {
            let k = before + 1;
            let inner = (1..k).filter_map(|j| Some((root.get(j)?, root.get(k - j)?)));
            let mut known = Self::integer(0, a);
            for (s, t) in inner {
                known = known.plus(&s.times(t, a)?, a)?;
            }
            let next = x.minus(&known, a)?.over(&twice, a)?;
            root.push(next);
        }
        Ok(Self::powers(level, root))
    }

    /// The greater one of two: of two numbers by themselves, of two series the one that begins with the greater number.
    ///
    /// Where both begin with the same number there is a corner, and no derivative.
    pub fn greater<A: Arithmetic<Number = N>>(&self, other: &Self, a: &A) -> Outcome<N> {
        if let (Self::Number(x), Self::Number(y)) = (self, other) {
            return Ok(Self::Number(a.greater(x, y)?));
        }
        let (x, y) = (self.start(), other.start());
        match a.compare(x.ok_or(Unknown::Precision)?, y.ok_or(Unknown::Precision)?)? {
            Comparison::Greater => Ok(self.clone()),
            Comparison::Less => Ok(other.clone()),
            Comparison::Equal => Err(Undefined::NotDifferentiable.into()),
            Comparison::Near | Comparison::Open => Err(Unknown::Precision.into()),
            // Without an order it is what a root makes of it.
            Comparison::Apart => {
                let gap = self.minus(other, a)?;
                let size = gap.times(&gap, a)?.square_root(a)?;
                let twice = self.plus(other, a)?.plus(&size, a)?;
                twice.over(&Self::integer(2, a), a)
            }
        }
    }

    /// The number at which all infinitesimals are zero.
    fn start(&self) -> Option<&N> {
        match self {
            Self::Number(number) => Some(number),
            Self::Powers { terms, .. } => terms.first()?.start(),
        }
    }

    /// `(sin f, cos f)`, from `s' = c f'` and `c' = -s f'`.
    pub fn sine_cosine<A: Arithmetic<Number = N>>(&self, a: &A) -> Result<(Self, Self), NoValue> {
        let (level, terms) = match self {
            Self::Number(x) => {
                let (sine, cosine) = a.sine_cosine(x)?;
                return Ok((Self::Number(sine), Self::Number(cosine)));
            }
            Self::Powers { level, terms } => (*level, terms),
        };
        let first = terms.first().ok_or(Unknown::Precision)?;
        let (s, c) = first.sine_cosine(a)?;
        let (mut sines, mut cosines) = (vec![s], vec![c]);
        for k in 1..terms.len() {
            let (mut s, mut c) = (Self::integer(0, a), Self::integer(0, a));
            for j in 1..=k {
                let (Some(f), Some(sine), Some(cosine)) =
                    (terms.get(j), sines.get(k - j), cosines.get(k - j))
                else {
                    continue;
                };
                // The argument of most sines is linear.
                if f.is_zero(a) == Some(true) {
                    continue;
                }
                let share = Rational::new(
                    i64::try_from(j).unwrap_or(i64::MAX).into(),
                    i64::try_from(k).unwrap_or(i64::MAX).into(),
                );
                let rate = f.times(&Self::rational(&share, a), a)?;
                s = s.plus(&rate.times(cosine, a)?, a)?;
                c = c.minus(&rate.times(sine, a)?, a)?;
            }
            sines.push(s);
            cosines.push(c);
        }
        Ok((Self::powers(level, sines), Self::powers(level, cosines)))
    }

    /// The exponential, from `e' = e f'`.
    pub fn exponential<A: Arithmetic<Number = N>>(&self, a: &A) -> Outcome<N> {
        let (level, terms) = match self {
            Self::Number(x) => return Ok(Self::Number(a.exponential(x)?)),
            Self::Powers { level, terms } => (*level, terms),
        };
        let first = terms.first().ok_or(Unknown::Precision)?;
        let mut powers = vec![first.exponential(a)?];
        for k in 1..terms.len() {
            let mut next = Self::integer(0, a);
            for j in 1..=k {
                let (Some(f), Some(power)) = (terms.get(j), powers.get(k - j)) else {
                    continue;
                };
                let share = Rational::new(
                    i64::try_from(j).unwrap_or(i64::MAX).into(),
                    i64::try_from(k).unwrap_or(i64::MAX).into(),
                );
                let rate = f.times(&Self::rational(&share, a), a)?;
                next = next.plus(&rate.times(power, a)?, a)?;
            }
            powers.push(next);
        }
        Ok(Self::powers(level, powers))
    }

    /// The logarithm l of a series f, from `l' f = f'`.
    pub fn logarithm<A: Arithmetic<Number = N>>(&self, a: &A) -> Outcome<N> {
        let (level, terms) = match self {
            Self::Number(x) => return Ok(Self::Number(a.logarithm(x)?)),
            Self::Powers { level, terms } => (*level, terms),
        };
        let first = terms.first().ok_or(Unknown::Precision)?;
        let mut logarithms = vec![first.logarithm(a)?];
        for k in 1..terms.len() {
            // k f_k is the sum of j l_j f_(k-j) for j from 1 to k.
            let mut rest = terms.get(k).ok_or(Unknown::Precision)?.clone();
            for j in 1..k {
                let (Some(own), Some(f)) = (logarithms.get(j), terms.get(k - j)) else {
                    continue;
                };
                let share = Rational::new(
                    i64::try_from(j).unwrap_or(i64::MAX).into(),
                    i64::try_from(k).unwrap_or(i64::MAX).into(),
                );
                let known = own.times(&Self::rational(&share, a), a)?;
                rest = rest.minus(&known.times(f, a)?, a)?;
            }
            logarithms.push(rest.over(first, a)?);
        }
        Ok(Self::powers(level, logarithms))
    }

    /// The arc tangent w of a series f, from `w' (1 + f^2) = f'`.
    pub fn arctangent<A: Arithmetic<Number = N>>(&self, a: &A) -> Outcome<N> {
        let terms = match self {
            Self::Number(x) => return Ok(Self::Number(a.arctangent(x)?)),
            Self::Powers { terms, .. } => terms,
        };
        let first = terms.first().ok_or(Unknown::Precision)?.arctangent(a)?;
        let below = self.times(self, a)?.plus(&Self::integer(1, a), a)?;
        self.integrated(first, a, |_| match &below {
            Self::Powers { terms, .. } => Ok(terms.to_vec()),
            Self::Number(_) => Err(Unknown::Confused.into()),
        })
    }

    /// The arc sine w of a series f, from `w' cos(w) = f'` and `cos(w)' = -f w'`.
    ///
    /// Where f is 1 or -1 and goes on, it is undefined.
    pub fn arcsine<A: Arithmetic<Number = N>>(&self, a: &A) -> Outcome<N> {
        let terms = match self {
            Self::Number(x) => return Ok(Self::Number(a.arcsine(x)?)),
            Self::Powers { terms, .. } => terms,
        };
        let first = terms.first().ok_or(Unknown::Precision)?.arcsine(a)?;
        let cosine = first.sine_cosine(a)?.1;
        self.integrated(first, a, |arcs| {
            let mut cosines = vec![cosine.clone()];
            for k in 1..arcs.len() {
                let mut next = Self::integer(0, a);
                for j in 1..=k {
                    let (Some(own), Some(f)) = (arcs.get(j), terms.get(k - j)) else {
                        continue;
                    };
                    let share = Self::rational(&share(j, k), a);
                    next = next.minus(&own.times(&share, a)?.times(f, a)?, a)?;
                }
                cosines.push(next);
            }
            Ok(cosines)
        })
    }

    /// The series w that begins so, from `w' q = f'`; of the coefficients of q those before the last one of w are asked for.
    fn integrated<A: Arithmetic<Number = N>>(
        &self,
        first: Self,
        a: &A,
        divisor: impl Fn(&[Self]) -> Result<Vec<Self>, NoValue>,
    ) -> Outcome<N> {
        let Self::Powers { level, terms } = self else {
            return Err(Unknown::Confused.into());
        };
        let mut found = vec![first];
        for k in 1..terms.len() {
            let below = divisor(&found)?;
            // k f_k is the sum of j w_j q_(k-j) for j from 1 to k.
            let mut rest = terms.get(k).ok_or(Unknown::Precision)?.clone();
            for j in 1..k {
                let (Some(own), Some(q)) = (found.get(j), below.get(k - j)) else {
                    continue;
                };
                let known = own.times(&Self::rational(&share(j, k), a), a)?;
                rest = rest.minus(&known.times(q, a)?, a)?;
            }
            found.push(rest.over(below.first().ok_or(Unknown::Precision)?, a)?);
        }
        Ok(Self::powers(*level, found))
    }

    /// Whether every coefficient is zero; `None` if that is not known.
    pub fn is_zero<A: Arithmetic<Number = N>>(&self, a: &A) -> Option<bool> {
        match self {
            Self::Number(x) => a.is_zero(x),
            Self::Powers { terms, .. } => {
                let mut all = Some(true);
                for term in terms.iter() {
                    match term.is_zero(a) {
                        Some(false) => return Some(false),
                        Some(true) => {}
                        None => all = None,
                    }
                }
                all
            }
        }
    }
}

/// j over k.
fn share(j: usize, k: usize) -> Rational {
    let whole = |n: usize| i64::try_from(n).unwrap_or(i64::MAX).into();
    Rational::new(whole(j), whole(k))
}
