//! Random claims whose truth is known by construction.
//!
//! Every kind has a generator. It makes a statement that is true because of how it was made (a product and its
//! expansion, a combination of the hypotheses, an enumeration of all integers), and half of the time slips: one
//! coefficient, sign, index or reading is changed so that the statement fails at a known place. The engine is not
//! asked; numbers and polynomials are the generator's own ([`number`], [`polynomial`]). A claim is a derivation file
//! ([`claim::Claim::file`]), so that a failure can be pasted. [`variants`] are claims that say the same in other words, and
//! [`judge`] compares the engine's verdicts with the truth.
//!
//! Everything is a function of a seed: no clock, no order of threads.

pub mod claim;
pub mod corrected;
pub mod domain;
pub mod judge;
mod kinds;
pub mod number;
pub mod polynomial;
pub mod seed;
pub mod variants;

use claim::{Claim, States};
use seed::Stream;

/// The kinds of random claims.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Kind {
    /// Products and their expansions.
    Polynomial,
    /// Order relations on boxes.
    Inequality,
    /// Quotients.
    Division,
    /// Vectors and matrices.
    Vectors,
    /// Derivatives and `at`, also where the variable is bound or assumed.
    Calculus,
    /// Linear equations and what follows.
    Given,
    /// Bases and sums of symbolic degree.
    Degree,
    /// Assumptions with fractional coefficients.
    Assumptions,
    /// Integers, also of ranges that depend on one another.
    Integers,
    /// And, or, not, chains.
    Logic,
    /// Printed decimals.
    Decimals,
    /// Properties of a whole basis.
    Properties,
    /// Sines, cosines and tangents of parts and multiples of an angle, and their signs.
    Angles,
    /// Exponentials and hyperbolic functions of parts and multiples of an exponent, and their order.
    Exponentials,
    /// Splines, by a basis whose step depends on index and degree.
    Splines,
    /// Arbitrary smooth functions and their derivatives.
    Functions,
    /// Integrals of polynomials and of products with sines, cosines and exponentials.
    Integrals,
    /// Numbers that there are, and that there are not.
    Exists,
    /// Symbolic powers, sums and products over an index without a basis.
    Powers,
    /// Everything composed with everything: these claims are made by [`crate::composed`].
    Composed,
}

impl Kind {
    /// All kinds that keep to one subject.
    pub const ALL: [Self; 19] = [
        Self::Polynomial,
        Self::Inequality,
        Self::Division,
        Self::Vectors,
        Self::Calculus,
        Self::Given,
        Self::Degree,
        Self::Assumptions,
        Self::Integers,
        Self::Logic,
        Self::Decimals,
        Self::Properties,
        Self::Angles,
        Self::Exponentials,
        Self::Splines,
        Self::Functions,
        Self::Integrals,
        Self::Exists,
        Self::Powers,
    ];

    /// Its name.
    #[must_use]
    pub fn word(self) -> &'static str {
        match self {
            Self::Polynomial => "polynomial",
            Self::Inequality => "inequality",
            Self::Division => "division",
            Self::Vectors => "vectors",
            Self::Calculus => "calculus",
            Self::Given => "given",
            Self::Degree => "degree",
            Self::Assumptions => "assumptions",
            Self::Integers => "integers",
            Self::Logic => "logic",
            Self::Decimals => "decimals",
            Self::Properties => "properties",
            Self::Angles => "angles",
            Self::Exponentials => "exponentials",
            Self::Splines => "splines",
            Self::Functions => "functions",
            Self::Integrals => "integrals",
            Self::Exists => "exists",
            Self::Powers => "powers",
            Self::Composed => "composed",
        }
    }

    /// The claim of this kind with this number.
    #[must_use]
    pub fn claim(self, seed: u64, number: u64) -> Claim {
        let mut stream = Stream::new(seed, self as u64 + 1, number);
        let make = match self {
            Self::Polynomial => kinds::polynomial::claim,
            Self::Inequality => kinds::inequality::claim,
            Self::Division => kinds::division::claim,
            Self::Vectors => kinds::vectors::claim,
            Self::Calculus => kinds::calculus::claim,
            Self::Given => kinds::given::claim,
            Self::Degree => kinds::degree::claim,
            Self::Assumptions => kinds::assumptions::claim,
            Self::Integers => kinds::integers::claim,
            Self::Logic => kinds::logic::claim,
            Self::Decimals => kinds::decimals::claim,
            Self::Properties => kinds::properties::claim,
            Self::Angles => kinds::angles::claim,
            Self::Exponentials => kinds::exponentials::claim,
            Self::Splines => kinds::splines::claim,
            Self::Functions => kinds::functions::claim,
            Self::Integrals => kinds::integrals::claim,
            Self::Exists => kinds::exists::claim,
            Self::Powers => kinds::powers::claim,
            Self::Composed => return crate::composed::claim(seed, number).claim,
        };
        let mut claim = make(&mut stream);
        claim.number = number;
        // A few equations are the paper's own, so that corrections are sought.
        if matches!(claim.states, States::Compare(_, "==", _)) && stream.once_in(25) {
            claim.word = "identity";
        }
        claim
    }
}
