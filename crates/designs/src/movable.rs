//! The developables of figures, which pages move by sliders, as CAD patches: the state that a page opens with.
//!
//! A figure gives planes or rails as quotients of polynomials in one running variable, sines and cosines of its angles,
//! and the sliders. Here they are evaluated over any scalar, so that the B-spline of a patch is within a proved
//! distance like that of every other patch.

use std::collections::BTreeMap;
use torse_exchange::{CadModel, ExchangeError, approximate, step};
use torse_geometry::planes::{characteristic_point_of, ruling_of};
use torse_geometry::{Coordinate, GeometryError, Jet, Over, Place, Plane, Rails, Result};
use torse_numbers::Scalar;
use torse_plot::{Monomial, Quotient, Rulings, Torse, TorsePiece};

/// Patches are at most so far from what is meant, in the unit of the figure.
const TOLERANCE: f64 = 1e-3;
/// Edges of neighbours at most so far from each other are one.
const SEWING: f64 = 1e-2;

/// Returns the developable as the page shows it first, as a STEP file; its rulings are whole where a page cuts them.
///
/// # Errors
/// [`ExchangeError`]: a formula that has no value somewhere, rails of which no spline comes near enough, a name that a
/// file cannot hold.
pub fn step_of(name: &str, torse: &Torse) -> Result<String, ExchangeError> {
    let values: Vec<f64> = torse.sliders().iter().map(|slider| slider.start).collect();
    let mut model = CadModel::new(name, SEWING)?;
    for (number, piece) in (1..).zip(torse.pieces()) {
        let sheet = MovableSheet::new(piece, &values);
        model.add(&format!("piece {number}"), approximate(&sheet, TOLERANCE)?)?;
    }
    step(&model)
}

/// A piece of a figure's developable, with values put in for the sliders.
#[derive(Debug, Clone)]
pub struct MovableSheet<S> {
    rulings: Rulings,
    curves: Vec<Vec<Formula<S>>>,
    over: [S; 2],
    along: [S; 2],
}

/// A sum over powers of sums.
#[derive(Debug, Clone)]
struct Formula<S> {
    numerator: Vec<Term<S>>,
    denominator: Vec<(Vec<Term<S>>, u32)>,
}

/// A coefficient times powers of x, sin(pi x/2), cos(pi x/2), sin(x), cos(x).
#[derive(Debug, Clone)]
struct Term<S> {
    coefficient: S,
    atoms: [u32; 5],
}

impl MovableSheet<f64> {
    /// Returns the piece at these values of the sliders.
    #[must_use]
    pub fn new(piece: &TorsePiece, values: &[f64]) -> Self {
        let sum = |terms: &[Monomial]| -> Vec<Term<f64>> {
            let settled = |of: &Monomial| Term {
                coefficient: of.coefficient * product(values, &of.sliders),
                atoms: of.atoms,
            };
            terms.iter().map(settled).collect()
        };
        let formula = |of: &Quotient| Formula {
            numerator: sum(&of.numerator),
            denominator: (of.denominator.iter())
                .map(|(terms, power)| (sum(terms), *power))
                .collect(),
        };
        MovableSheet {
            rulings: piece.rulings,
            curves: (piece.curves.iter())
                .map(|curve| curve.iter().map(formula).collect())
                .collect(),
            over: piece.over,
            along: piece.along,
        }
    }
}

fn product(values: &[f64], powers: &[u32]) -> f64 {
    let power =
        |(value, power): (&f64, &u32)| value.powi(i32::try_from(*power).unwrap_or(i32::MAX));
    values.iter().zip(powers).map(power).product()
}

impl<S: Clone, T> Over<S, T> for MovableSheet<S> {
    type Object = MovableSheet<T>;

    fn over(&self, convert: &impl Fn(&S) -> T) -> Result<MovableSheet<T>> {
        let sum = |terms: &[Term<S>]| -> Vec<Term<T>> {
            let carried = |of: &Term<S>| Term {
                coefficient: convert(&of.coefficient),
                atoms: of.atoms,
            };
            terms.iter().map(carried).collect()
        };
        let formula = |of: &Formula<S>| Formula {
            numerator: sum(&of.numerator),
            denominator: (of.denominator.iter())
                .map(|(terms, power)| (sum(terms), *power))
                .collect(),
        };
        Ok(MovableSheet {
            rulings: self.rulings,
            curves: (self.curves.iter())
                .map(|curve| curve.iter().map(formula).collect())
                .collect(),
            over: self.over.each_ref().map(convert),
            along: self.along.each_ref().map(convert),
        })
    }
}

impl<S: Coordinate> Rails<S> for MovableSheet<S> {
    fn rail_jets(&self, x: &S, order: usize) -> Result<[[Jet<S>; 3]; 2]> {
        let none = || GeometryError::NoValue {
            what: "rail of a movable sheet",
            at: Place::Parameter(x.approximate()),
        };
        // Each derivative that the rulings ask for takes one order.
        let taken = match self.rulings {
            Rulings::Envelope => 1,
            Rulings::Tangent => 3,
            Rulings::Ruled => 0,
        };
        let [from, to] = &self.over;
        let width = to.clone() - from.clone();
        let place = from.clone() + width.clone() * x.clone();
        let x = Jet::variable(place, order.saturating_add(taken));
        let mut products = Products::new(atoms(&x)?);
        let mut curves = Vec::with_capacity(self.curves.len());
        for curve in &self.curves {
            let values = curve.iter().map(|formula| formula.value(&mut products));
            curves.push(values.collect::<Result<Vec<_>>>()?);
        }
        let at = |base: &[Jet<S>; 3], way: &[Jet<S>; 3], share: &S| -> [Jet<S>; 3] {
            std::array::from_fn(|k| {
                base[k].clone() + way[k].constant_like(share.clone()) * way[k].clone()
            })
        };
        let ends = match (self.rulings, curves.as_slice()) {
            (Rulings::Envelope, [plane]) => {
                let plane = plane_of(plane).ok_or_else(none)?;
                let ruling = ruling_of(&plane, &slope_of(&plane).ok_or_else(none)?)?;
                let end = |share| at(&ruling.foot, &ruling.direction, share);
                self.along.each_ref().map(end)
            }
            (Rulings::Tangent, [plane]) => {
                let plane = plane_of(plane).ok_or_else(none)?;
                let slope = slope_of(&plane).ok_or_else(none)?;
                let bend = slope_of(&slope).ok_or_else(none)?;
                let edge = characteristic_point_of([&plane, &slope, &bend])?;
                let way = slope_of(&edge).ok_or_else(none)?;
                self.along.each_ref().map(|share| at(&edge, &way, share))
            }
            (Rulings::Ruled, [first, last]) => {
                let first: [Jet<S>; 3] = first.clone().try_into().map_err(|_| none())?;
                let last: [Jet<S>; 3] = last.clone().try_into().map_err(|_| none())?;
                let way = std::array::from_fn(|k| last[k].clone() - first[k].clone());
                self.along.each_ref().map(|share| at(&first, &way, share))
            }
            _ => return Err(none()),
        };
        Ok(ends.map(|end| end.map(|series| stretched(&series, &width, order))))
    }

    /// Envelopes and tangents of an edge are; a sheet between two rails has to be measured.
    fn is_developable_by_construction(&self) -> bool {
        matches!(self.rulings, Rulings::Envelope | Rulings::Tangent)
    }
}

impl<S: Coordinate> Formula<S> {
    fn value(&self, products: &mut Products<S>) -> Result<Jet<S>> {
        let mut value = products.sum(&self.numerator);
        for (terms, power) in &self.denominator {
            value = value.divided_by(&products.sum(terms).powi(*power))?;
        }
        Ok(value)
    }
}

/// Products of powers of the atoms: the coordinates of a curve have most of them in common, so each is found once.
struct Products<S> {
    atoms: [Jet<S>; 5],
    known: BTreeMap<[u32; 5], Jet<S>>,
}

impl<S: Coordinate> Products<S> {
    fn new(atoms: [Jet<S>; 5]) -> Self {
        let known = BTreeMap::new();
        Self { atoms, known }
    }

    fn sum(&mut self, terms: &[Term<S>]) -> Jet<S> {
        let zero = self.atoms[0].zero_like();
        terms.iter().fold(zero, |total, term| {
            let product = self.product(term.atoms);
            let scaled = |c: &S| c.clone() * term.coefficient.clone();
            let rest = product.coefficients().iter().skip(1).map(scaled);
            total + Jet::from_coefficients(scaled(product.value()), rest.collect::<Vec<_>>())
        })
    }

    /// Multiplies by one atom at a time: every product on the way serves others.
    fn product(&mut self, powers: [u32; 5]) -> Jet<S> {
        if let Some(known) = self.known.get(&powers) {
            return known.clone();
        }
        let mut product = self.atoms[0].one_like();
        let mut done = [0; 5];
        for (place, (atom, power)) in self.atoms.iter().zip(powers).enumerate() {
            for exponent in 1..=power {
                done[place] = exponent;
                let next = || match done.iter().sum() {
                    1 => atom.clone(),
                    _ => product.clone() * atom.clone(),
                };
                product = self.known.entry(done).or_insert_with(next).clone();
            }
        }
        product
    }
}

/// Returns the running variable with its sines and cosines.
fn atoms<S: Coordinate>(x: &Jet<S>) -> Result<[Jet<S>; 5]> {
    let (sine, cosine) = x.quarter_turn()?;
    // A quarter turn of 2x/pi is x.
    let half_pi = x.value().half_pi()?;
    let angle = x.divided_by(&x.constant_like(half_pi))?;
    let (sin, cos) = angle.quarter_turn()?;
    Ok([x.clone(), sine, cosine, sin, cos])
}

fn plane_of<S: Clone>(curve: &[Jet<S>]) -> Option<Plane<Jet<S>>> {
    <&Plane<Jet<S>>>::try_from(curve).ok().cloned()
}

fn slope_of<S: Scalar, const N: usize>(curve: &[Jet<S>; N]) -> Option<[Jet<S>; N]> {
    let slopes: Option<Vec<Jet<S>>> = curve.iter().map(Jet::differentiated).collect();
    slopes?.try_into().ok()
}

/// Returns the series in a variable that runs through the unit interval while the old one runs through one of this
/// width.
fn stretched<S: Coordinate>(series: &Jet<S>, width: &S, order: usize) -> Jet<S> {
    let mut factor = width.one_like();
    let rest = series.coefficients().iter().skip(1).take(order).map(|c| {
        factor = factor.clone() * width.clone();
        c.clone() * factor.clone()
    });
    Jet::from_coefficients(series.value().clone(), rest.collect::<Vec<_>>())
}

#[cfg(test)]
mod tests {
    use super::*;
    use torse_geometry::{EnvelopingPatch, Gbt, PatchBounds, PlaneFamily, Surface, TangentPatch};
    use torse_plot::{Colour, Slider};

    /// c x^a s^b c^d times the first slider to a power.
    fn term(coefficient: f64, [x, sine, cosine]: [u32; 3], slider: u32) -> Monomial {
        Monomial {
            coefficient,
            atoms: [x, sine, cosine, 0, 0],
            sliders: vec![slider],
        }
    }

    fn plain(numerator: Vec<Monomial>) -> Quotient {
        Quotient {
            numerator,
            denominator: vec![],
        }
    }

    fn piece(rulings: Rulings, curves: Vec<Vec<Quotient>>, along: [f64; 2]) -> TorsePiece {
        TorsePiece {
            rulings,
            curves,
            over: [0.0, 1.0],
            along,
            limit: None,
            label: String::new(),
            colour: Colour::INK,
        }
    }

    /// Returns the quadratic planes of the papers' basis with both parameters equal to the slider: (1 - s)(1 - m s),
    /// the rest, (1 - c)(1 - m c).
    fn planes(control: [[f64; 4]; 3]) -> Vec<Quotient> {
        let first = |w: f64| {
            vec![
                term(w, [0, 0, 0], 0),
                term(-w, [0, 1, 0], 0),
                term(-w, [0, 1, 0], 1),
                term(w, [0, 2, 0], 1),
            ]
        };
        let last = |w: f64| {
            vec![
                term(w, [0, 0, 0], 0),
                term(-w, [0, 0, 1], 0),
                term(-w, [0, 0, 1], 1),
                term(w, [0, 0, 2], 1),
            ]
        };
        let coordinate = |k: usize| {
            let [a, b, c] = [control[0][k], control[1][k], control[2][k]];
            plain([first(a - b), vec![term(b, [0, 0, 0], 0)], last(c - b)].concat())
        };
        (0..4).map(coordinate).collect()
    }

    const CONTROL: [[f64; 4]; 3] = [
        [7.0, -7.0, 5.0, 125.0],
        [-7.0, -7.0, 5.0, 120.0],
        [-7.0, 7.0, 5.5, 130.0],
    ];

    #[test]
    fn envelopes_and_tangent_sheets_are_those_of_the_geometry() {
        let family = PlaneFamily::new(Gbt::new(0.5, 0.5).unwrap(), CONTROL.to_vec()).unwrap();
        let along = [-0.25, 0.5];
        let envelope = EnvelopingPatch::new(family.clone(), PatchBounds::Range(along)).unwrap();
        let tangents = TangentPatch::new(family, along).unwrap();
        let sheet =
            |rulings| MovableSheet::new(&piece(rulings, vec![planes(CONTROL)], along), &[0.5]);
        let near = |ours: [[f64; 3]; 2], theirs: [[f64; 3]; 2]| {
            let pairs = ours.iter().flatten().zip(theirs.iter().flatten());
            let mut away = pairs.map(|(a, b)| (a - b).abs() / (1.0 + b.abs()));
            assert!(away.all(|d| d < 1e-9), "{ours:?} {theirs:?}");
        };
        for x in [0.0, 0.3, 0.8] {
            let ours = sheet(Rulings::Envelope).ruling_ends(&x).unwrap();
            near(ours, [0.0, 1.0].map(|v| envelope.point(&x, &v).unwrap()));
            let ours = sheet(Rulings::Tangent).ruling_ends(&x).unwrap();
            near(ours, [0.0, 1.0].map(|v| tangents.point(&x, &v).unwrap()));
        }
    }

    #[test]
    fn a_sheet_over_another_interval_runs_with_its_width() {
        let line = |k: f64| {
            vec![
                plain(vec![term(k, [2, 0, 0], 1)]),
                plain(vec![]),
                plain(vec![]),
            ]
        };
        let mut piece = piece(Rulings::Ruled, vec![line(1.0), line(3.0)], [0.0, 1.0]);
        piece.over = [1.0, 3.0];
        let sheet = MovableSheet::new(&piece, &[2.0]);
        // 2 (1 + 2x)^2 has the value 8, the slope 16 and half the second derivative 8 at 1/2.
        let [first, last] = sheet.rail_jets(&0.5, 2).unwrap();
        assert_eq!(first[0].coefficients(), [8.0, 16.0, 8.0]);
        assert_eq!(last[0].coefficients(), [24.0, 48.0, 24.0]);
    }

    #[test]
    fn the_file_has_a_face_for_each_piece_and_a_pole_is_refused() {
        let slider = Slider {
            name: "mu".to_owned(),
            label: "mu".to_owned(),
            least: -1.0,
            greatest: 1.0,
            start: 0.5,
            step: 0.1,
        };
        let torse = |curves| {
            let piece = piece(Rulings::Envelope, vec![curves], [-0.1, 0.1]);
            Torse::new(vec![slider.clone()], [0.0, 30.0], vec![piece]).unwrap()
        };
        let file = step_of("sheet", &torse(planes(CONTROL))).unwrap();
        assert!(file.starts_with("ISO-10303-21;"));
        assert_eq!(file.matches("=ADVANCED_FACE(").count(), 1);
        assert!(file == step_of("sheet", &torse(planes(CONTROL))).unwrap());
        let mut poles = planes(CONTROL);
        poles[3].denominator = vec![(vec![term(1.0, [1, 0, 0], 0)], 1)];
        assert!(step_of("sheet", &torse(poles)).is_err());
    }
}
