//! Developable surfaces that follow sliders, as data for a viewer: nothing is drawn here.
//!
//! A piece is given by formulas of its planes or of its two rails, each a quotient of polynomials in one running
//! variable, sines and cosines of its angles, and the sliders. A viewer that can differentiate such quotients can
//! compute the rulings, where they meet, and how the sheet unrolls.

use crate::interactive::{HIGHEST_EXPONENT, InteractiveError, Slider, check_sliders, count};
use crate::{colour::Colour, ink::label};

/// Maximum number of monomials of all formulas together, so that a page with them stays small.
pub const MAX_MONOMIALS: usize = 20_000;

/// How the rulings of a piece are given.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Rulings {
    /// By a running plane; ends are multiples of the cross product of normal and derivative, from the foot of the
    /// origin.
    Envelope,
    /// By a running plane; ends are multiples of the derivative of the edge of regression, from there.
    Tangent,
    /// By two running points; ends are fractions of the way from the first to the second.
    Ruled,
}

/// A coefficient times powers.
#[derive(Debug, Clone, PartialEq)]
pub struct Monomial {
    /// The coefficient.
    pub coefficient: f64,
    /// Exponents of x, sin(pi x/2), cos(pi x/2), sin(x), cos(x).
    pub atoms: [u32; 5],
    /// Exponents of the sliders, in their order.
    pub sliders: Vec<u32>,
}

/// A sum of monomials over powers of such sums.
#[derive(Debug, Clone, PartialEq)]
pub struct Quotient {
    /// The numerator.
    pub numerator: Vec<Monomial>,
    /// The divisors, each with its multiplicity.
    pub denominator: Vec<(Vec<Monomial>, u32)>,
}

/// A piece of a developable.
#[derive(Debug, Clone, PartialEq)]
pub struct TorsePiece {
    /// How its rulings are given.
    pub rulings: Rulings,
    /// One plane of four coordinates, or two points of three.
    pub curves: Vec<Vec<Quotient>>,
    /// Where x runs, from the lower to the upper end.
    pub over: [f64; 2],
    /// Where each ruling starts and ends.
    pub along: [f64; 2],
    /// How far a ruling is shown in both directions; to its ends if there is no limit.
    pub limit: Option<f64>,
    /// What it is called in the legend, in the [label language](crate#labels); empty for no entry.
    pub label: String,
    /// Its colour.
    pub colour: Colour,
}

/// A developable that follows sliders.
#[derive(Debug, Clone, PartialEq)]
pub struct Torse {
    sliders: Vec<Slider>,
    view: [f64; 2],
    pieces: Vec<TorsePiece>,
}

impl Torse {
    /// A developable from its sliders, the angles of the first view in degrees (azimuth, elevation), and its pieces.
    ///
    /// # Errors
    /// [`InteractiveError`] names the slider or the piece at fault.
    pub fn new(
        sliders: Vec<Slider>,
        view: [f64; 2],
        pieces: Vec<TorsePiece>,
    ) -> Result<Self, InteractiveError> {
        count("sliders", sliders.len(), 1, crate::MAX_SLIDERS)?;
        count("pieces", pieces.len(), 1, 8)?;
        let formulas = pieces
            .iter()
            .flat_map(|piece| piece.curves.iter().flatten());
        let sizes = formulas.flat_map(Quotient::sums).map(<[Monomial]>::len);
        count("monomials", sizes.sum(), 1, MAX_MONOMIALS)?;
        check_sliders(&sliders)?;
        for (number, piece) in pieces.iter().enumerate() {
            label::parse(&piece.label)?;
            piece
                .check(sliders.len())
                .map_err(|problem| InteractiveError::Piece {
                    piece: number,
                    problem,
                })?;
        }
        if view.iter().any(|angle| !angle.is_finite()) {
            let problem = "the angles of the view are not finite";
            return Err(InteractiveError::Piece { piece: 0, problem });
        }
        Ok(Torse {
            sliders,
            view,
            pieces,
        })
    }

    /// Returns the sliders.
    #[must_use]
    pub fn sliders(&self) -> &[Slider] {
        &self.sliders
    }

    /// Azimuth and elevation of the first view, in degrees.
    #[must_use]
    pub fn view(&self) -> [f64; 2] {
        self.view
    }

    /// The pieces, each joined to the one before.
    #[must_use]
    pub fn pieces(&self) -> &[TorsePiece] {
        &self.pieces
    }
}

impl Quotient {
    fn sums(&self) -> impl Iterator<Item = &[Monomial]> {
        let below = self.denominator.iter().map(|(sum, _)| sum.as_slice());
        std::iter::once(self.numerator.as_slice()).chain(below)
    }
}

impl TorsePiece {
    fn check(&self, sliders: usize) -> Result<(), &'static str> {
        let (curves, coordinates) = match self.rulings {
            Rulings::Envelope | Rulings::Tangent => (1, 4),
            Rulings::Ruled => (2, 3),
        };
        let right = |curve: &Vec<Quotient>| curve.len() == coordinates;
        if self.curves.len() != curves || !self.curves.iter().all(right) {
            return Err("it wants one plane of four coordinates or two points of three");
        }
        let proper = |[low, high]: [f64; 2]| (high - low).is_finite() && low < high;
        if !proper(self.over) || !proper(self.along) {
            return Err("an interval is empty or not finite");
        }
        if self
            .limit
            .is_some_and(|limit| !(limit > 0.0 && limit.is_finite()))
        {
            return Err("the limit of its rulings is no positive number");
        }
        let formulas = self.curves.iter().flatten();
        for monomial in formulas.flat_map(Quotient::sums).flatten() {
            let exponents = || monomial.atoms.iter().chain(&monomial.sliders);
            if !monomial.coefficient.is_finite()
                || monomial.sliders.len() != sliders
                || exponents().any(|exponent| *exponent > HIGHEST_EXPONENT)
            {
                return Err(
                    "a monomial is not finite, has too high exponents, or not one for each slider",
                );
            }
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn number(coefficient: f64) -> Quotient {
        let monomial = Monomial {
            coefficient,
            atoms: [1, 0, 0, 0, 0],
            sliders: vec![1],
        };
        Quotient {
            numerator: vec![monomial],
            denominator: vec![],
        }
    }

    fn torse(change: impl FnOnce(&mut TorsePiece)) -> Result<Torse, InteractiveError> {
        let slider = Slider {
            name: "k".to_owned(),
            label: "$k$".to_owned(),
            least: 0.0,
            greatest: 1.0,
            start: 0.5,
            step: 0.1,
        };
        let mut piece = TorsePiece {
            rulings: Rulings::Ruled,
            curves: vec![vec![number(1.0); 3]; 2],
            over: [0.0, 1.0],
            along: [0.0, 1.0],
            limit: None,
            label: String::new(),
            colour: Colour::INK,
        };
        change(&mut piece);
        Torse::new(vec![slider], [0.0, 30.0], vec![piece])
    }

    #[test]
    fn a_piece_has_the_curves_of_its_kind_intervals_and_finite_monomials() {
        assert!(torse(|_| {}).is_ok());
        let refused = |change: fn(&mut TorsePiece)| {
            let error = torse(change).unwrap_err();
            assert!(
                matches!(error, InteractiveError::Piece { piece: 0, .. }),
                "{error}"
            );
        };
        refused(|piece| piece.rulings = Rulings::Envelope);
        refused(|piece| piece.curves.truncate(1));
        refused(|piece| piece.over = [1.0, 1.0]);
        refused(|piece| piece.along = [0.0, f64::INFINITY]);
        refused(|piece| piece.limit = Some(0.0));
        refused(|piece| piece.curves[0][0] = number(f64::NAN));
        refused(|piece| piece.curves[1][2].numerator[0].sliders.clear());
        refused(|piece| piece.curves[1][2].numerator[0].atoms[4] = HIGHEST_EXPONENT + 1);
        let label = torse(|piece| piece.label = "$x_".to_owned());
        assert!(matches!(label, Err(InteractiveError::Label(_))));
    }
}
