//! Proofs of equality by signs: a difference is zero because it is neither positive nor negative, because the
//! negative of its square is nonnegative, or because its product with nonvanishing factors is zero.

use crate::evidence::Evidence;
use crate::sign::Sign;
use serde::Serialize;

/// A proof that each entry of a difference is zero.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct ZeroBySign<P> {
    /// The proof for each entry.
    pub entries: Vec<Zero<P>>,
    /// The divisors of the computation.
    pub divisors: Vec<P>,
}

/// Why a difference is zero.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Zero<P> {
    /// It vanishes identically.
    Identically,
    /// Its numerator and the negative of its numerator are nonnegative.
    Between(Box<[Sign<P>; 2]>),
    /// The negative of the square of its numerator is nonnegative.
    Square {
        /// The numerator.
        root: P,
        /// The sign of the negative of the square.
        sign: Box<Sign<P>>,
    },
    /// The product of its numerator with factors that do not vanish by hypothesis is a combination of equations.
    Product {
        /// The expressions that are zero by hypothesis.
        equations: Vec<P>,
        /// The multipliers of the equations.
        multipliers: Vec<P>,
    },
}

impl<P> ZeroBySign<P> {
    /// Converts every polynomial.
    pub fn map<Q>(&self, change: &dyn Fn(&P) -> Q) -> ZeroBySign<Q> {
        ZeroBySign {
            entries: self.entries.iter().map(|zero| zero.map(change)).collect(),
            divisors: self.divisors.iter().map(change).collect(),
        }
    }

    /// All signs on which the proof depends.
    pub fn signs(&self) -> impl Iterator<Item = &Sign<P>> {
        self.entries.iter().flat_map(Zero::signs)
    }

    /// The evidence.
    #[must_use]
    pub fn evidence(&self) -> Evidence {
        match self.signs().next() {
            Some(_) => Evidence::Inequality,
            None => Evidence::Identity,
        }
    }
}

impl<P> Zero<P> {
    fn map<Q>(&self, change: &dyn Fn(&P) -> Q) -> Zero<Q> {
        let all = |list: &[P]| list.iter().map(change).collect();
        match self {
            Self::Identically => Zero::Identically,
            Self::Between(signs) => {
                let [above, below] = &**signs;
                Zero::Between(Box::new([above.map(change), below.map(change)]))
            }
            Self::Square { root, sign } => Zero::Square {
                root: change(root),
                sign: Box::new(sign.map(change)),
            },
            Self::Product {
                equations,
                multipliers,
            } => Zero::Product {
                equations: all(equations),
                multipliers: all(multipliers),
            },
        }
    }

    fn signs(&self) -> &[Sign<P>] {
        match self {
            Self::Between(signs) => &**signs,
            Self::Square { sign, .. } => std::slice::from_ref(sign),
            Self::Identically | Self::Product { .. } => &[],
        }
    }
}
