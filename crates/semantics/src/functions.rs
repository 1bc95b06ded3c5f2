//! The built-in functions.

use crate::arithmetic::Arithmetic;
use crate::evaluate::{Evaluator, Outcome, Sc};
use crate::gap::{Gap, Undefined, Unknown};
use crate::linear;
use crate::series::{Series, Turned};
use crate::value::{Value, dot, transposed};
use torse_core::{BuiltIn, Term};
use torse_numbers::rational::integer;

/// The largest argument of a factorial and lower argument of a binomial coefficient.
const MAX_FACTORIAL: i64 = 400;
/// The most angles whose sine and cosine are remembered.
const MAX_TURNED: usize = 8;
/// The largest unit matrix.
const MAX_IDENTITY: i64 = 16;

impl<A: Arithmetic> Evaluator<'_, A> {
    pub(crate) fn apply(
        &self,
        function: BuiltIn,
        arguments: &[Term],
        scope: &Sc<'_, A>,
    ) -> Outcome<A> {
        let a = self.arithmetic;
        let value = |term: &Term| self.term(term, scope);
        let number = |term: &Term| self.number(term, scope);
        Ok(match (function, arguments) {
            (BuiltIn::Binomial, [n, j]) => Value::Number(self.binomial(
                &number(n)?,
                self.integer(j, "the lower number of a binomial coefficient", scope)?,
            )?),
            (BuiltIn::Factorial, [n]) => {
                let what = "the argument of a factorial";
                let n = self.integer(n, what, scope)?;
                if n < 0 {
                    return Err(Undefined::Negative { what }.into());
                }
                if n > MAX_FACTORIAL {
                    return Err(Unknown::Large { what }.into());
                }
                let product = (1..=n).map(integer).product();
                Value::Number(Series::rational(&product, a))
            }
            (BuiltIn::SquareRoot, [q]) => Value::Number(number(q)?.square_root(a)?),
            (BuiltIn::Sine, [angle]) => Value::Number(self.sine_cosine(number(angle)?)?.0),
            (BuiltIn::Cosine, [angle]) => Value::Number(self.sine_cosine(number(angle)?)?.1),
            (BuiltIn::Exponential, [x]) => Value::Number(number(x)?.exponential(a)?),
            (BuiltIn::Dot, [x, y]) => {
                Value::Number(dot(&value(x)?.entries()?, &value(y)?.entries()?, a)?)
            }
            (BuiltIn::Norm, [v]) => {
                let entries = value(v)?.entries()?;
                Value::Number(dot(&entries, &entries, a)?.square_root(a)?)
            }
            (BuiltIn::Cross, [x, y]) => {
                let (x, y) = (value(x)?.entries()?, value(y)?.entries()?);
                let ([x1, x2, x3], [y1, y2, y3]) = (x.as_slice(), y.as_slice()) else {
                    return Err(Gap::shape("a cross product of vectors of other lengths"));
                };
                let minor = |p: &Series<A::Number>, q: &Series<A::Number>, r, s| {
                    p.times(q, a)?.minus(&Series::times(r, s, a)?, a)
                };
                Value::vector(vec![
                    minor(x2, y3, x3, y2)?,
                    minor(x3, y1, x1, y3)?,
                    minor(x1, y2, x2, y1)?,
                ])
            }
            (BuiltIn::Determinant, [m]) => {
                Value::Number(linear::determinant(&value(m)?.rows()?, a)?)
            }
            (BuiltIn::Transpose, [m]) => Value::matrix(transposed(&value(m)?.rows()?)),
            (BuiltIn::Inverse, [m]) => Value::matrix(linear::inverse(&value(m)?.rows()?, a)?),
            (BuiltIn::Solve, [m, right]) => self.solve(value(m)?, value(right)?)?,
            (BuiltIn::Identity, [n]) => {
                let what = "the size of a unit matrix";
                let n = self.integer(n, what, scope)?;
                if n < 0 {
                    return Err(Undefined::Negative { what }.into());
                }
                if n > MAX_IDENTITY {
                    return Err(Unknown::Large { what }.into());
                }
                Value::matrix(linear::identity(usize::try_from(n).unwrap_or(0), a))
            }
            (BuiltIn::Coefficients, [forms, unknowns]) => {
                self.coefficients(forms, unknowns, scope)?
            }
            _ => return Err(Gap::shape("a number of arguments to the function")),
        })
    }

    /// Sine and cosine of an angle: where one stands, the other is not far.
    fn sine_cosine(&self, angle: Series<A::Number>) -> Result<Turned<A::Number>, Gap> {
        let mut turned = self.turned.borrow_mut();
        if let Some((_, known)) = turned.iter().find(|(own, _)| *own == angle) {
            return Ok(known.clone());
        }
        let both = angle.sine_cosine(self.arithmetic)?;
        if turned.len() >= MAX_TURNED {
            turned.remove(0);
        }
        turned.push((angle, both.clone()));
        Ok(both)
    }

    /// `n (n-1) ... (n-j+1) / j!`, 0 for a negative j.
    fn binomial(&self, n: &Series<A::Number>, j: i64) -> Result<Series<A::Number>, Gap> {
        let a = self.arithmetic;
        if j < 0 {
            return Ok(Series::integer(0, a));
        }
        if j > MAX_FACTORIAL {
            let what = "a binomial coefficient";
            return Err(Unknown::Large { what }.into());
        }
        (0..j).try_fold(Series::integer(1, a), |product, i| {
            let factor = n.minus(&Series::integer(i, a), a)?;
            product
                .times(&factor, a)?
                .over(&Series::integer(i + 1, a), a)
        })
    }

    /// The x with `M x = b`, for a vector or a matrix b.
    fn solve(&self, matrix: Value<A::Number>, right: Value<A::Number>) -> Outcome<A> {
        let a = self.arithmetic;
        let matrix = matrix.rows()?;
        let is_vector = matches!(&right, Value::Many(items)
            if items.iter().all(|item| matches!(item, Value::Number(_))));
        if is_vector {
            let column: Vec<Vec<_>> = right.entries()?.into_iter().map(|x| vec![x]).collect();
            let solution = linear::solution(&matrix, &column, a)?;
            return Ok(Value::vector(solution.into_iter().flatten().collect()));
        }
        Ok(Value::matrix(linear::solution(&matrix, &right.rows()?, a)?))
    }
}
