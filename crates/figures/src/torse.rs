//! Developable surfaces with sliders: their formulas as tables of machine numbers.

use crate::PlateError;
use crate::figure;
use crate::interactive::label;
use crate::plate::Plate;
use crate::sample::{ends, number};
use std::collections::BTreeMap;
use torse_algebra::rational::to_f64;
use torse_algebra::{Angle, Fraction, Polynomial, Symbol};
use torse_plot::{Monomial, Quotient, Rulings, Slider, Torse, TorsePiece, palette};
use torse_syntax::derivation::schema::figure::Rulings as Word;

impl Plate {
    /// Returns the developable surface of the figure, to be moved and unrolled; none if the figure has none.
    ///
    /// # Errors
    /// [`PlateError`]: an end of an interval that is not a finite number, and all errors of drawing.
    pub fn torse(&self) -> Result<Option<Torse>, PlateError> {
        self.torse.as_ref().map(torse).transpose()
    }
}

fn torse(torse: &figure::Torse) -> Result<Torse, PlateError> {
    let names: Vec<&str> = torse.sliders.iter().map(|s| s.name.as_str()).collect();
    let sliders = torse.sliders.iter().map(|slider| {
        let [least, greatest] = ends(&slider.range)?;
        Ok(Slider {
            name: slider.name.clone(),
            label: label(&slider.name),
            least,
            greatest,
            start: number(&slider.start)?,
            step: (greatest - least) / 200.0,
        })
    });
    let pieces = torse.pieces.iter().map(|piece| {
        let curve = |curve: &Vec<Fraction>| {
            let each = curve
                .iter()
                .map(|one| quotient(one, &piece.over.name, &names));
            each.collect::<Result<Vec<_>, _>>()
        };
        Ok(TorsePiece {
            rulings: match piece.rulings {
                Word::Envelope => Rulings::Envelope,
                Word::Tangent => Rulings::Tangent,
                Word::Ruled => Rulings::Ruled,
            },
            curves: piece
                .curves
                .iter()
                .map(curve)
                .collect::<Result<_, PlateError>>()?,
            over: ends(&piece.over.range)?,
            along: ends(&piece.along)?,
            limit: piece.limit.as_ref().map(number).transpose()?,
            label: piece.label.clone(),
            colour: palette(piece.colour),
        })
    });
    let sliders = sliders.collect::<Result<_, PlateError>>()?;
    let pieces = pieces.collect::<Result<_, PlateError>>()?;
    Ok(Torse::new(sliders, torse.view, pieces)?)
}

fn quotient(formula: &Fraction, variable: &str, sliders: &[&str]) -> Result<Quotient, PlateError> {
    let denominator = formula
        .denominator_factors()
        .map(|(factor, power)| Ok((sum(factor, variable, sliders)?, power)));
    Ok(Quotient {
        denominator: denominator.collect::<Result<_, PlateError>>()?,
        numerator: sum(formula.numerator(), variable, sliders)?,
    })
}

/// Converts the polynomial, with pi and roots as machine numbers.
fn sum(
    polynomial: &Polynomial,
    variable: &str,
    sliders: &[&str],
) -> Result<Vec<Monomial>, PlateError> {
    let mut sums: BTreeMap<([u32; 5], Vec<u32>), f64> = BTreeMap::new();
    for term in polynomial.terms() {
        let mut coefficient = to_f64(&term.coefficient);
        let (mut atoms, mut powers) = ([0; 5], vec![0; sliders.len()]);
        for (symbol, power) in term.powers {
            let slot = match symbol {
                Symbol::Pi => {
                    coefficient *= std::f64::consts::PI.powi(i32::from(power));
                    continue;
                }
                Symbol::Root(prime) => {
                    coefficient *= f64::from(*prime).sqrt().powi(i32::from(power));
                    continue;
                }
                Symbol::Named(name) if **name == *variable => atoms.first_mut(),
                Symbol::Sin(name, Angle::QUARTER_TURN) if **name == *variable => atoms.get_mut(1),
                Symbol::Cos(name, Angle::QUARTER_TURN) if **name == *variable => atoms.get_mut(2),
                Symbol::Sin(name, Angle::RADIAN) if **name == *variable => atoms.get_mut(3),
                Symbol::Cos(name, Angle::RADIAN) if **name == *variable => atoms.get_mut(4),
                Symbol::Named(name) => {
                    let place = sliders.iter().position(|slider| **slider == **name);
                    place.and_then(|place| powers.get_mut(place))
                }
                _ => None,
            };
            // Sliders are not angles, and nothing else remains.
            *slot.ok_or_else(|| PlateError::Symbol {
                symbol: symbol.to_string(),
            })? = u32::from(power);
        }
        *sums.entry((atoms, powers)).or_insert(0.0) += coefficient;
    }
    let monomial = |((atoms, sliders), coefficient)| Monomial {
        coefficient,
        atoms,
        sliders,
    };
    Ok(sums.into_iter().map(monomial).collect())
}
