//! The vocabulary of sign proofs on boxes: the box, the claim, and how a search for a proof can end.
//!
//! Both provers, [`bernstein`](crate::bernstein) for polynomials and [`branch`](crate::branch) for
//! everything that balls can evaluate, cut a box into pieces small enough for one cheap test. A proof is
//! then a list of pieces, and checking it needs two things only: the test holds on each piece, and the
//! pieces fill the box ([`RationalBox::is_filled_by`]).

use crate::ball::Ball;
use crate::rational::{Integer, Rational, integer};
use crate::scalar::ExactError;
use std::cmp::Ordering;

/// What is claimed about a function on a box.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Positivity {
    /// The function is greater than zero everywhere.
    Strict,
    /// The function is nowhere less than zero.
    Weak,
}

impl Positivity {
    /// Whether a number that compares with zero like this satisfies the claim.
    #[must_use]
    pub fn admits(self, sign: Ordering) -> bool {
        match self {
            Self::Strict => sign.is_gt(),
            Self::Weak => sign.is_ge(),
        }
    }

    /// Whether an exact number satisfies the claim.
    pub(crate) fn admits_number(self, value: &Rational) -> bool {
        self.admits(value.numer().cmp(&Integer::ZERO))
    }
}

/// Why a box could not be made.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
pub enum BoxError {
    /// There are no sides.
    #[error("a box needs at least one side")]
    NoSides,
    /// A side ends before it begins.
    #[error("side {axis} runs from {lower} down to {upper}")]
    Reversed {
        /// The number of the side, from zero.
        axis: usize,
        /// Its lower end.
        lower: Rational,
        /// Its upper end.
        upper: Rational,
    },
}

/// A closed axis-parallel box with rational corners: `lower_i <= x_i <= upper_i`. A side may be a point.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct RationalBox {
    sides: Vec<(Rational, Rational)>,
}

impl RationalBox {
    /// The box with these sides `(lower, upper)`.
    ///
    /// # Errors
    /// [`BoxError::NoSides`] and [`BoxError::Reversed`].
    pub fn new(sides: Vec<(Rational, Rational)>) -> Result<Self, BoxError> {
        if sides.is_empty() {
            return Err(BoxError::NoSides);
        }
        for (axis, (lower, upper)) in sides.iter().enumerate() {
            if lower > upper {
                return Err(BoxError::Reversed {
                    axis,
                    lower: lower.clone(),
                    upper: upper.clone(),
                });
            }
        }
        Ok(Self { sides })
    }

    /// The cube `[0, 1]^dimension`.
    ///
    /// # Errors
    /// [`BoxError::NoSides`] for dimension 0.
    pub fn unit(dimension: usize) -> Result<Self, BoxError> {
        Self::new(vec![(integer(0), integer(1)); dimension])
    }

    /// The sides `(lower, upper)`.
    #[must_use]
    pub fn sides(&self) -> &[(Rational, Rational)] {
        &self.sides
    }

    /// The number of sides.
    #[must_use]
    pub fn dimension(&self) -> usize {
        self.sides.len()
    }

    /// The middle.
    #[must_use]
    pub fn midpoint(&self) -> Vec<Rational> {
        self.sides.iter().map(middle).collect()
    }

    /// One ball for each side.
    #[must_use]
    pub fn balls(&self, bits: usize) -> Vec<Ball> {
        self.sides
            .iter()
            .map(|(lower, upper)| Ball::from_bounds(lower, upper, bits))
            .collect()
    }

    /// The two halves on either side of the middle of one side; `None` if there is no such side or it is
    /// a point.
    #[must_use]
    pub fn halves(&self, axis: usize) -> Option<(Self, Self)> {
        let side = self.sides.get(axis)?;
        if side.0 == side.1 {
            return None;
        }
        let (mut low, mut high) = (self.clone(), self.clone());
        low.sides[axis].1 = middle(side);
        high.sides[axis].0 = middle(side);
        Some((low, high))
    }

    /// Whether the boxes fill this one, overlapping at most along faces.
    ///
    /// They are taken apart along middle planes that cut none of them, until each piece is one of the
    /// boxes. So `true` is a proof; `false` may also mean that they fill it in another way than by repeated
    /// halving.
    #[must_use]
    pub fn is_filled_by(&self, boxes: &[&Self]) -> bool {
        if boxes
            .iter()
            .any(|piece| piece.dimension() != self.dimension())
        {
            return false;
        }
        let mut waiting = vec![(self.clone(), boxes.to_vec())];
        while let Some((region, pieces)) = waiting.pop() {
            if let [piece] = pieces.as_slice()
                && **piece == region
            {
                continue;
            }
            let cut = (0..region.dimension()).find_map(|axis| {
                let (low, high) = region.halves(axis)?;
                let plane = &low.sides[axis].1;
                let (below, rest): (Vec<&Self>, Vec<&Self>) = pieces
                    .iter()
                    .partition(|piece| piece.sides[axis].1 <= *plane);
                let above = |piece: &&Self| piece.sides[axis].0 >= *plane;
                // Pieces on both sides: so each cut leaves fewer to take apart, and none goes on forever.
                let cuts = !below.is_empty() && !rest.is_empty() && rest.iter().all(above);
                cuts.then_some([(low, below), (high, rest)])
            });
            match cut {
                Some(halves) => waiting.extend(halves),
                None => return false,
            }
        }
        true
    }
}

fn middle((lower, upper): &(Rational, Rational)) -> Rational {
    (lower + upper) / integer(2)
}

/// How a search ended. `C` is the certificate of a proof, `V` the kind of values.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Decision<C, V> {
    /// The claim holds, and this proves it.
    Proved(C),
    /// The claim fails at this point of the box.
    Refuted {
        /// The coordinates.
        point: Vec<Rational>,
        /// The value there, which contradicts the claim.
        value: V,
    },
    /// The budget ended first.
    Unknown(Attempt),
}

/// What a search did before its budget ended.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Attempt {
    /// How many boxes were examined.
    pub examined: usize,
    /// How many boxes were left.
    pub open: usize,
    /// One of those left, of the largest there are.
    pub example: RationalBox,
    /// Why the function had no value on some box, if that ever happened.
    pub obstacle: Option<ExactError>,
}

/// Why a polynomial has no Bernstein form here.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
pub enum BernsteinError {
    /// A term has more or fewer exponents than the box has sides.
    #[error("term {term} has {found} exponents, the box has {expected} sides")]
    WrongDimension {
        /// The number of the term, from zero.
        term: usize,
        /// The number of its exponents.
        found: usize,
        /// The number of sides.
        expected: usize,
    },
    /// There are more coefficients than [`MAX_COEFFICIENTS`](crate::bernstein::BernsteinForm::MAX_COEFFICIENTS).
    #[error("the Bernstein form has more than {limit} coefficients")]
    TooLarge {
        /// The largest number of coefficients.
        limit: usize,
    },
}

/// Why a certificate does not prove what it should.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
pub enum CertificateError {
    /// The pieces do not fill the box.
    #[error("the {pieces} pieces do not fill the box")]
    NotFilled {
        /// The number of pieces.
        pieces: usize,
    },
    /// The test of a piece, repeated, does not give what the certificate says or the claim needs.
    #[error("the test of piece {piece} fails")]
    PieceFails {
        /// The number of the piece, from zero.
        piece: usize,
    },
    /// The polynomial of the certificate cannot be read as one on the box.
    #[error(transparent)]
    Polynomial(#[from] BernsteinError),
}
