//! Boxes with rational corners, and their bisection.

use crate::rational::{Rational, integer};

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

    /// Splits the box at the middle of one side; `None` if there is no such side or its length is zero.
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

    /// Whether the boxes fill this one and overlap at most along faces.
    ///
    /// The box is split along middle planes that cut none of the boxes, until each piece is one of them. So `true` is
    /// a proof; `false` may also mean that the boxes fill it, but not by repeated bisection.
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
                // There are boxes on both sides, so each split leaves fewer boxes in a piece, and the recursion ends.
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
