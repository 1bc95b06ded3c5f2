//! The built-in functions.

use super::expand::{Expander, Scope};
use super::gap::Unsupported;
use super::quotient::Quotient;
use super::value::{Value, determinant, dot, minor, transposed};
use num_traits::{Signed, Zero};
use torse_certificate::polynomial::Polynomial;
use torse_certificate::symbol::Symbol;
use torse_core::{BuiltIn, Term};
use torse_numbers::rational::integer;
use torse_numbers::{Integer, Rational};

/// The largest argument of a factorial and lower argument of a binomial coefficient; the largest size of a matrix.
const MAX_FACTORIAL: i64 = 64;
const MAX_SIZE: usize = 8;

impl Expander<'_> {
    pub(super) fn apply(
        &self,
        function: BuiltIn,
        arguments: &[Term],
        scope: &Scope<'_>,
    ) -> Result<Value, Unsupported> {
        let work = self.work;
        let value = |term: &Term| self.term(term, scope);
        let number = |term: &Term| self.number(term, scope);
        Ok(match (function, arguments) {
            (BuiltIn::Binomial, [n, j]) => {
                let j = self.integer(j, "a binomial coefficient", scope)?;
                Value::Number(self.binomial(&number(n)?, j)?)
            }
            (BuiltIn::Factorial, [n]) => {
                let n = self.integer(n, "a factorial", scope)?;
                if n < 0 {
                    return Err(Unsupported::Undefined("a factorial of a negative number"));
                }
                if n > MAX_FACTORIAL {
                    return Err(Unsupported::Large);
                }
                Value::Number(Quotient::number((1..=n).map(integer).product()))
            }
            (BuiltIn::SquareRoot, [q]) => Value::Number(root(&number(q)?)?),
            (BuiltIn::Sine, [angle]) => Value::Number(number(angle)?.sine_cosine(work)?.0),
            (BuiltIn::Cosine, [angle]) => Value::Number(number(angle)?.sine_cosine(work)?.1),
            (BuiltIn::Dot, [x, y]) => {
                Value::Number(dot(&value(x)?.entries()?, &value(y)?.entries()?, work)?)
            }
            (BuiltIn::Norm, [v]) => {
                let entries = value(v)?.entries()?;
                Value::Number(root(&dot(&entries, &entries, work)?)?)
            }
            (BuiltIn::Cross, [x, y]) => {
                let (x, y) = (value(x)?.entries()?, value(y)?.entries()?);
                let ([x1, x2, x3], [y1, y2, y3]) = (x.as_slice(), y.as_slice()) else {
                    return Err(Unsupported::Construct("a cross product of other vectors"));
                };
                let part = |a: &Quotient, b: &Quotient, c: &Quotient, d: &Quotient| {
                    a.times(b, work)?.minus(&c.times(d, work)?, work)
                };
                Value::vector(vec![
                    part(x2, y3, x3, y2)?,
                    part(x3, y1, x1, y3)?,
                    part(x1, y2, x2, y1)?,
                ])
            }
            (BuiltIn::Determinant, [m]) => Value::Number(determinant(&sized(value(m)?)?, work)?),
            (BuiltIn::Transpose, [m]) => Value::matrix(transposed(&value(m)?.rows()?)),
            (BuiltIn::Inverse, [m]) => Value::matrix(self.inverse(&sized(value(m)?)?)?),
            (BuiltIn::Solve, [m, right]) => {
                Value::matrix(self.inverse(&sized(value(m)?)?)?).times(&value(right)?, work)?
            }
            (BuiltIn::Identity, [n]) => {
                let n = self.integer(n, "the size of a unit matrix", scope)?;
                let n = usize::try_from(n).ok().filter(|n| *n <= 2 * MAX_SIZE);
                let n = n.ok_or(Unsupported::Large)?;
                let entry = |r, c| Quotient::number(integer(i64::from(r == c)));
                Value::matrix(
                    (0..n)
                        .map(|r| (0..n).map(|c| entry(r, c)).collect())
                        .collect(),
                )
            }
            (BuiltIn::Coefficients, [forms, unknowns]) => {
                let (forms, unknowns) = (value(forms)?, value(unknowns)?);
                if !(self.sees_rates)() {
                    return Err(Unsupported::Construct("coefficients under such equations"));
                }
                self.coefficients(&forms, &unknowns)?
            }
            _ => return Err(Unsupported::Construct("a function of other arguments")),
        })
    }

    /// `n (n-1) ... (n-j+1) / j!`; 0 for negative j.
    fn binomial(&self, n: &Quotient, j: i64) -> Result<Quotient, Unsupported> {
        if j > MAX_FACTORIAL {
            return Err(Unsupported::Large);
        }
        if j < 0 {
            return Ok(Quotient::default());
        }
        (0..j).try_fold(Quotient::number(integer(1)), |product, i| {
            let factor = n.minus(&Quotient::number(integer(i)), self.work)?;
            let part = Quotient::number(integer(i + 1).recip());
            product.times(&factor, self.work)?.times(&part, self.work)
        })
    }

    /// The derivatives of forms by symbols in which the forms are linear.
    fn coefficients(&self, forms: &Value, unknowns: &Value) -> Result<Value, Unsupported> {
        let plain = |unknown: &Quotient| {
            let mut terms = unknown.above.terms();
            match (terms.next(), terms.next()) {
                (Some((monomial, _)), None) => match monomial.as_slice() {
                    [(symbol @ Symbol::Named(_), 1)] => Some(symbol.clone()),
                    _ => None,
                },
                _ => None,
            }
        };
        let strange = || Unsupported::Construct("coefficients of what is no symbol");
        let mut symbols = vec![];
        for unknown in unknowns.numbers() {
            let symbol = plain(unknown).ok_or_else(strange)?;
            if *unknown != Polynomial::symbol(symbol.clone()).into() {
                return Err(strange());
            }
            symbols.push(symbol);
        }
        let mut rows = vec![];
        for form in forms.numbers() {
            let mut row = vec![];
            for symbol in &symbols {
                let rate = form.derivative(symbol, self.work)?;
                let mut again = symbols
                    .iter()
                    .map(|other| rate.derivative(other, self.work));
                if again.any(|second| second.is_ok_and(|second| !second.above.is_zero())) {
                    return Err(Unsupported::Construct(
                        "coefficients of a form that is not linear",
                    ));
                }
                row.push(rate);
            }
            rows.push(row);
        }
        Ok(Value::matrix(rows))
    }

    /// The inverse: the adjugate divided by the determinant.
    fn inverse(&self, rows: &[Vec<Quotient>]) -> Result<Vec<Vec<Quotient>>, Unsupported> {
        let below = determinant(rows, self.work)?;
        let size = rows.len();
        let entry = |r: usize, c: usize| {
            let cofactor = determinant(&minor(rows, c, r), self.work)?;
            let signed = match (r + c) % 2 {
                0 => cofactor,
                _ => cofactor.negated(),
            };
            self.over(&signed, &below)
        };
        (0..size)
            .map(|r| (0..size).map(|c| entry(r, c)).collect())
            .collect()
    }
}

/// The rows of a matrix, which must not be too large.
fn sized(value: Value) -> Result<Vec<Vec<Quotient>>, Unsupported> {
    let rows = value.rows()?;
    if rows.len() <= MAX_SIZE {
        Ok(rows)
    } else {
        Err(Unsupported::Large)
    }
}

/// The square root of a nonnegative rational number: `sqrt(p/q) = sqrt(p q)/q`, with square factors extracted.
/// Independent of `semantics` on purpose: do not share.
fn root(value: &Quotient) -> Result<Quotient, Unsupported> {
    let number = value.as_rational();
    let number = number.ok_or(Unsupported::Construct("a square root of a formula"))?;
    if number.is_negative() {
        return Err(Unsupported::Undefined("the root of a negative number"));
    }
    if number.is_zero() {
        return Ok(Quotient::default());
    }
    let product: Integer = number.numer() * number.denom();
    let small = i64::try_from(&product).ok().filter(|p| *p < 1 << 36);
    let mut rest = small.ok_or(Unsupported::Large)?;
    let one = Rational::new(1.into(), number.denom().clone());
    let mut result = Polynomial::constant(one);
    let mut prime = 2;
    while rest > 1 {
        if prime * prime > rest {
            prime = rest;
        }
        let mut exponent = 0;
        while rest % prime == 0 {
            rest /= prime;
            exponent += 1;
        }
        let extracted = (0..exponent / 2).map(|_| integer(prime)).product();
        result = result.scaled(&extracted);
        if exponent % 2 == 1 {
            let prime = u32::try_from(prime).map_err(|_| Unsupported::Large)?;
            result = result.times(&Polynomial::symbol(Symbol::Root(prime)));
        }
        prime += 1;
    }
    Ok(result.into())
}
