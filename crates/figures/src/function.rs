//! Exact formulas as functions of machine numbers.
//!
//! A formula in at most two running variables u, v is a quotient of polynomials in u, v and the sines and cosines
//! of their angles. Each polynomial is written as `sum over a, b of c[a][b] A_a(u) B_b(v)`, where the A and B are
//! monomials in one variable, so that on a grid every power and every sine is computed once a row and once a
//! column. Pi and square roots are constants here and fold into the c.

use crate::PlateError;
use torse_algebra::rational::to_f64;
use torse_algebra::{Angle, Exponent, Fraction, Polynomial, Symbol, Unit};

/// Powers of a variable, then of the sine and cosine of each angle of the formula.
type Monomial = Vec<u16>;

/// A compiled formula.
#[derive(Debug, Clone)]
pub struct Function {
    numerator: Sum,
    denominator: Vec<(Sum, i32)>,
}

/// A polynomial as a bilinear form in the monomials of two variables.
#[derive(Debug, Clone)]
struct Sum {
    /// The angles of both variables.
    angles: Vec<Atom>,
    first: Vec<Monomial>,
    second: Vec<Monomial>,
    /// One row of `second.len()` coefficients for each monomial of `first`.
    coefficients: Vec<f64>,
}

impl Function {
    /// Compiles the formula as a function of at most two `variables`.
    ///
    /// # Errors
    /// [`PlateError::Symbol`] if another symbol occurs.
    ///
    /// ```
    /// use torse_algebra::Fraction;
    /// use torse_figures::Function;
    /// let (u, v) = (Fraction::named("u"), Fraction::named("v"));
    /// let f = Function::new(&(u.clone() * u * v), &["u", "v"])?;
    /// assert_eq!(f.grid(&[2.0, 3.0], &[1.0, 10.0]), [4.0, 40.0, 9.0, 90.0]);
    /// # Ok::<(), torse_figures::PlateError>(())
    /// ```
    pub fn new(formula: &Fraction, variables: &[&str]) -> Result<Self, PlateError> {
        let denominator = formula
            .denominator_factors()
            .map(|(factor, power)| {
                Ok((
                    Sum::new(factor, variables)?,
                    i32::try_from(power).unwrap_or(i32::MAX),
                ))
            })
            .collect::<Result<_, PlateError>>()?;
        Ok(Self {
            numerator: Sum::new(formula.numerator(), variables)?,
            denominator,
        })
    }

    /// Evaluates on a grid: all of the second variable for each value of the first one.
    #[must_use]
    pub fn grid(&self, first: &[f64], second: &[f64]) -> Vec<f64> {
        let mut values = self.numerator.grid(first, second);
        for (factor, power) in &self.denominator {
            for (value, divisor) in values.iter_mut().zip(factor.grid(first, second)) {
                *value /= divisor.powi(*power);
            }
        }
        values
    }

    /// Evaluates along the first variable, with the second one zero.
    #[must_use]
    pub fn line(&self, first: &[f64]) -> Vec<f64> {
        self.grid(first, &[0.0])
    }
}

impl Sum {
    fn new(polynomial: &Polynomial, variables: &[&str]) -> Result<Self, PlateError> {
        let mut angles = vec![];
        for symbol in polynomial.symbols() {
            match symbol {
                Symbol::Sin(_, angle) | Symbol::Cos(_, angle) => {
                    number(&mut angles, Atom::Turn(*angle));
                }
                Symbol::Exp(exponent) if !symbol.is_number() => {
                    number(&mut angles, Atom::Power(single(symbol, exponent)?));
                }
                _ => {}
            }
        }
        let mut sum = Sum {
            angles,
            first: vec![],
            second: vec![],
            coefficients: vec![],
        };
        let mut terms = vec![];
        for term in polynomial.terms() {
            let mut coefficient = to_f64(&term.coefficient);
            let nothing = vec![0; 1 + 2 * sum.angles.len()];
            let mut monomials: [Monomial; 2] = [nothing.clone(), nothing];
            let slot = |angle| 1 + 2 * sum.angles.iter().take_while(|a| **a != angle).count();
            for (symbol, power) in term.powers {
                let (name, slot) = match symbol {
                    Symbol::Pi => {
                        coefficient *= std::f64::consts::PI.powi(i32::from(power));
                        continue;
                    }
                    Symbol::Root(prime) => {
                        coefficient *= f64::from(*prime).sqrt().powi(i32::from(power));
                        continue;
                    }
                    Symbol::Log(prime) => {
                        coefficient *= libm::log(f64::from(*prime)).powi(i32::from(power));
                        continue;
                    }
                    Symbol::Arc(above, below) => {
                        let tangent = f64::from(*above) / f64::from(*below);
                        coefficient *= libm::atan(tangent).powi(i32::from(power));
                        continue;
                    }
                    Symbol::Exp(exponent) if symbol.is_number() => {
                        let root = libm::exp(f64::from(exponent.parts()).recip());
                        coefficient *= root.powi(i32::from(power));
                        continue;
                    }
                    Symbol::Named(name) => (name, 0),
                    Symbol::Sin(name, angle) => (name, slot(Atom::Turn(*angle))),
                    Symbol::Cos(name, angle) => (name, slot(Atom::Turn(*angle)) + 1),
                    Symbol::Exp(exponent) => {
                        let slot = slot(Atom::Power(single(symbol, exponent)?));
                        match exponent.powers() {
                            [(name, _)] => (name, slot),
                            _ => continue,
                        }
                    }
                    Symbol::Indexed(..) => {
                        return Err(PlateError::Symbol {
                            symbol: symbol.to_string(),
                        });
                    }
                };
                let place = variables.iter().position(|v| **v == **name);
                match place
                    .and_then(|p| monomials.get_mut(p))
                    .and_then(|m| m.get_mut(slot))
                {
                    Some(exponent) => *exponent = power,
                    None => {
                        return Err(PlateError::Symbol {
                            symbol: symbol.to_string(),
                        });
                    }
                }
            }
            let [a, b] = monomials;
            terms.push((
                number(&mut sum.first, a),
                number(&mut sum.second, b),
                coefficient,
            ));
        }
        let width = sum.second.len();
        sum.coefficients = vec![0.0; sum.first.len() * width];
        for (a, b, coefficient) in terms {
            if let Some(slot) = sum.coefficients.get_mut(a * width + b) {
                *slot += coefficient;
            }
        }
        Ok(sum)
    }

    fn grid(&self, first: &[f64], second: &[f64]) -> Vec<f64> {
        let columns: Vec<Vec<f64>> = second
            .iter()
            .map(|v| powers(&self.second, &self.angles, *v))
            .collect();
        let mut values = Vec::with_capacity(first.len() * second.len());
        for u in first {
            let mut row = vec![0.0; self.second.len()];
            let coefficients = self.coefficients.chunks(self.second.len().max(1));
            for (power, coefficients) in powers(&self.first, &self.angles, *u)
                .into_iter()
                .zip(coefficients)
            {
                for (sum, coefficient) in row.iter_mut().zip(coefficients) {
                    *sum += power * coefficient;
                }
            }
            let dot = |column: &Vec<f64>| column.iter().zip(&row).map(|(x, y)| x * y).sum::<f64>();
            values.extend(columns.iter().map(dot));
        }
        values
    }
}

/// A function of a variable that is a symbol of polynomials.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Atom {
    /// Sine and cosine.
    Turn(Angle),
    /// The exponential of a power of the variable, divided into parts.
    Power((u16, u16)),
}

/// The power and the parts of an exponent in one variable.
fn single(symbol: &Symbol, exponent: &Exponent) -> Result<(u16, u16), PlateError> {
    match exponent.powers() {
        [(_, power)] => Ok((*power, exponent.parts())),
        _ => Err(PlateError::Symbol {
            symbol: symbol.to_string(),
        }),
    }
}

/// Returns the position of an item in a list; adds it at the end if it is new.
fn number<T: PartialEq>(list: &mut Vec<T>, item: T) -> usize {
    let found = list.iter().position(|own| *own == item);
    found.unwrap_or_else(|| {
        list.push(item);
        list.len() - 1
    })
}

/// Evaluates the monomials at one point.
fn powers(monomials: &[Monomial], angles: &[Atom], at: f64) -> Vec<f64> {
    let mut atoms = vec![at];
    for atom in angles {
        match atom {
            Atom::Turn(angle) => {
                let whole = match angle.unit {
                    Unit::QuarterTurn => std::f64::consts::FRAC_PI_2 * at,
                    Unit::Radian => at,
                };
                let (sin, cos) = libm::sincos(whole / f64::from(angle.parts));
                atoms.extend([sin, cos]);
            }
            Atom::Power((power, parts)) => {
                let power = libm::exp(at.powi(i32::from(*power)) / f64::from(*parts));
                atoms.extend([power, power]);
            }
        }
    }
    let value = |m: &Monomial| {
        m.iter()
            .zip(&atoms)
            .map(|(n, x)| x.powi(i32::from(*n)))
            .product()
    };
    monomials.iter().map(value).collect()
}
