//! Properties of a basis family at every degree.

use crate::sign::Sign;
use serde::Serialize;

/// Seeds and step factors are not negative: the step adds products of such functions, so by induction the functions of
/// every degree are not negative.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct Nonnegative<P> {
    /// The two factors of the step, then the seeds; of a quotient its numerator, then the factors of its denominator that
    /// change its sign.
    pub parts: Vec<Part<P>>,
}

/// A factor of the step, or a seed.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct Part<P> {
    /// Whether it is a seed.
    pub is_seed: bool,
    /// The function.
    pub function: P,
    /// Why it is not negative; the zero function needs no reason.
    pub sign: Option<Sign<P>>,
}

/// The functions of each degree are one function times powers of the quotient of the step factors, with positive
/// coefficients; the quotient is monotone and no factor is negative. So the minors of the collocation matrices are those of
/// generalised Vandermonde matrices, and the functions, which sum to one, diminish variation (Schoenberg 1930).
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct Powers<P> {
    /// The two factors a, b of the step, then the seeds, none of them negative.
    pub parts: Vec<Part<P>>,
    /// `b'a - ba'`, or its negative where the quotient falls.
    pub slope: Box<Part<P>>,
}

impl<P> Part<P> {
    fn map<Q>(&self, change: &dyn Fn(&P) -> Q) -> Part<Q> {
        Part {
            is_seed: self.is_seed,
            function: change(&self.function),
            sign: self.sign.as_ref().map(|sign| sign.map(change)),
        }
    }
}

impl<P> Nonnegative<P> {
    /// The same in other polynomials.
    pub fn map<Q>(&self, change: &dyn Fn(&P) -> Q) -> Nonnegative<Q> {
        Nonnegative {
            parts: self.parts.iter().map(|part| part.map(change)).collect(),
        }
    }
}

impl<P: std::fmt::Display> Nonnegative<P> {
    /// The steps in words.
    #[must_use]
    pub fn steps(&self) -> Vec<String> {
        let step = |part: &Part<P>| {
            let what = if part.is_seed { "seed" } else { "step factor" };
            let function = &part.function;
            format!(
                "{what} {function} >= 0 by Bernstein coefficients in the tangent of the half angle"
            )
        };
        let end = "the step keeps nonnegative functions nonnegative: induction over the degree";
        let steps = self.parts.iter().map(step);
        steps.chain([end.to_owned()]).collect()
    }
}

impl<P> Powers<P> {
    /// The same in other polynomials.
    pub fn map<Q>(&self, change: &dyn Fn(&P) -> Q) -> Powers<Q> {
        Powers {
            parts: self.parts.iter().map(|part| part.map(change)).collect(),
            slope: Box::new(self.slope.map(change)),
        }
    }

    /// The steps in words.
    #[must_use]
    pub fn steps(&self) -> Vec<String> {
        vec![
            "the functions of each degree are one function times powers of the quotient of the step factors, with positive coefficients".to_owned(),
            "the quotient is monotone: the minors of the collocation matrices are those of generalised Vandermonde matrices, nonnegative at every degree".to_owned(),
        ]
    }
}
