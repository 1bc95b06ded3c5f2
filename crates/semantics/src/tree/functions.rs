//! The functions of the language: SEMANTICS.md, "Terms" and "Binders".

use super::environment::Environment;
use super::evaluate::{Evaluator, Meaning, Outcome};
use crate::arithmetic::Arithmetic;
use crate::linear;
use crate::no_value::{NoValue, Undefined, Unknown};
use crate::series::Series;
use crate::value::{Value, dot, transposed};
use std::ops::RangeInclusive;
use torse_numbers::rational::integer;
use torse_syntax::formula::{Expr, Node};

/// The largest number of terms of a sum.
const MAX_TERMS: i64 = 4000;
/// The largest argument of a factorial and lower argument of a binomial coefficient.
const MAX_FACTORIAL: i64 = 400;
/// The largest size of an identity matrix.
const MAX_IDENTITY: i64 = 16;

type Place<'a, A> = Environment<'a, <A as Arithmetic>::Number>;
type Number<A> = Series<<A as Arithmetic>::Number>;

impl<'a, A: Arithmetic> Evaluator<'a, '_, A> {
    /// A built-in function at its arguments.
    pub(super) fn applied(
        &self,
        tree: &'a Expr,
        name: &str,
        arguments: &'a [Expr],
        place: &Place<'a, A>,
    ) -> Result<Meaning<A::Number>, NoValue> {
        let a = self.arithmetic;
        let value = |tree: &'a Expr| self.value(tree, place);
        let number = |tree: &'a Expr| self.number(tree, place);
        Ok(Meaning::Value(match (name, arguments) {
            ("agrees" | "fails" | "nonnegative" | "independent" | "variation_diminishing", _) => {
                return self.stated(name, arguments, place).map(Meaning::Statement);
            }
            ("at", [inner, name, point]) => {
                return self.meaning(inner, &self.bind_at(name, point, place)?);
            }
            ("D", [inner, name, rest @ ..]) if rest.len() <= 1 => {
                let order = match rest.first() {
                    None => 1,
                    Some(order) => self.integer(order, "the order of a derivative", place)?,
                };
                let symbol = self.variable(name, place)?;
                let point = self.named_value(symbol, place)?.number()?;
                self.derivative(order, &point, |moved| {
                    self.value(inner, &self.bound(symbol, moved, place))
                })?
            }
            ("integral", [body, name, low, high]) => {
                let ends = [number(low)?, number(high)?];
                let symbol = self.variable(name, place)?;
                self.integral(&ends, &|moved| {
                    self.value(body, &self.bound(symbol, moved, place))
                })?
            }
            ("sum", [index, low, high, term]) => {
                let bounds = ["a sum", "a bound of a sum"];
                let index = index_name(index)?;
                let mut range = self.range(low, high, bounds, place)?;
                range.try_fold(self.integer_value(0), |total, i| {
                    let inside = place.with_local(index, self.integer_value(i), true);
                    total.plus(&self.value(term, &inside)?, a)
                })?
            }
            ("product", [index, low, high, term]) => {
                let bounds = ["a product", "a bound of a product"];
                let index = index_name(index)?;
                let mut range = self.range(low, high, bounds, place)?;
                range.try_fold(self.integer_value(1), |product, i| {
                    let inside = place.with_local(index, self.integer_value(i), true);
                    product.times(&self.value(term, &inside)?, a)
                })?
            }
            ("sqrt", [q]) => Value::Number(number(q)?.square_root(a)?),
            ("abs", [x]) => {
                let x = number(x)?;
                Value::Number(x.times(&x, a)?.square_root(a)?)
            }
            ("max", [x, y]) => Value::Number(number(x)?.greater(&number(y)?, a)?),
            // The smaller one is the opposite of the greater one of the opposites.
            ("min", [x, y]) => {
                let (x, y) = (number(x)?.negated(a), number(y)?.negated(a));
                Value::Number(x.greater(&y, a)?.negated(a))
            }
            ("sin", [angle]) => Value::Number(number(angle)?.sine_cosine(a)?.0),
            ("cos", [angle]) => Value::Number(number(angle)?.sine_cosine(a)?.1),
            ("tan", [angle]) => {
                let (sine, cosine) = number(angle)?.sine_cosine(a)?;
                self.divides(tree, &cosine);
                Value::Number(sine.over(&cosine, a)?)
            }
            ("exp", [x]) => Value::Number(number(x)?.exponential(a)?),
            ("log", [x]) => Value::Number(number(x)?.logarithm(a)?),
            ("atan", [x]) => Value::Number(number(x)?.arctangent(a)?),
            ("asin", [x]) => Value::Number(number(x)?.arcsine(a)?),
            // The angles of the acute triangle with this cosine add up to a quarter turn.
            ("acos", [x]) => {
                let quarter = Series::Number(a.over(&a.pi(), &a.integer(2))?);
                Value::Number(quarter.minus(&number(x)?.arcsine(a)?, a)?)
            }
            ("cosh" | "sinh" | "tanh", [x]) => Value::Number(self.hyperbolic(name, &number(x)?)?),
            ("binom", [n, j]) => {
                let what = "the lower number of a binomial coefficient";
                Value::Number(self.binomial(&number(n)?, self.integer(j, what, place)?)?)
            }
            ("factorial", [n]) => {
                let what = "the argument of a factorial";
                let n = self.natural(n, what, MAX_FACTORIAL, place)?;
                Value::Number(Series::rational(&(1..=n).map(integer).product(), a))
            }
            ("dot", [x, y]) => Value::Number(dot(&value(x)?.entries()?, &value(y)?.entries()?, a)?),
            ("norm", [v]) => {
                let entries = value(v)?.entries()?;
                Value::Number(dot(&entries, &entries, a)?.square_root(a)?)
            }
            ("cross", [x, y]) => self.cross(&value(x)?.entries()?, &value(y)?.entries()?)?,
            ("det", [m]) => Value::Number(linear::determinant(&value(m)?.rows()?, a)?),
            ("transpose", [m]) => Value::matrix(transposed(&value(m)?.rows()?)),
            ("inverse", [m]) => Value::matrix(linear::inverse(&value(m)?.rows()?, a)?),
            ("solve", [m, right]) => self.solved(&value(m)?.rows()?, value(right)?)?,
            ("identity", [n]) => {
                let n = self.natural(n, "the size of a unit matrix", MAX_IDENTITY, place)?;
                Value::matrix(linear::identity(usize::try_from(n).unwrap_or(0), a))
            }
            ("coefficients", [forms, symbols]) => self.coefficients(forms, symbols, place)?,
            _ => return Err(NoValue::shape("a number of arguments to the function")),
        }))
    }

    /// The values of an index between two bounds.
    fn range(
        &self,
        low: &'a Expr,
        high: &'a Expr,
        [what, bound]: [&'static str; 2],
        place: &Place<'a, A>,
    ) -> Result<RangeInclusive<i64>, NoValue> {
        let low = self.integer(low, bound, place)?;
        let high = self.integer(high, bound, place)?;
        if high.saturating_sub(low) >= MAX_TERMS {
            return Err(Unknown::Large { what }.into());
        }
        Ok(low..=high)
    }

    /// A nonnegative integer that is at most `limit`.
    fn natural(
        &self,
        tree: &'a Expr,
        what: &'static str,
        limit: i64,
        place: &Place<'a, A>,
    ) -> Result<i64, NoValue> {
        match self.integer(tree, what, place)? {
            n if n < 0 => Err(Undefined::Negative { what }.into()),
            n if n > limit => Err(Unknown::Large { what }.into()),
            n => Ok(n),
        }
    }

    /// `(exp(x) + exp(-x))/2`, `(exp(x) - exp(-x))/2`, and their quotient.
    fn hyperbolic(&self, name: &str, x: &Number<A>) -> Result<Number<A>, NoValue> {
        let a = self.arithmetic;
        let (up, down) = (x.exponential(a)?, x.negated(a).exponential(a)?);
        let two = Series::integer(2, a);
        match name {
            "cosh" => up.plus(&down, a)?.over(&two, a),
            "sinh" => up.minus(&down, a)?.over(&two, a),
            _ => up.minus(&down, a)?.over(&up.plus(&down, a)?, a),
        }
    }

    /// `n (n-1) ... (n-j+1) / j!`; 0 for negative j.
    fn binomial(&self, n: &Number<A>, j: i64) -> Result<Number<A>, NoValue> {
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
            let product = product.times(&factor, a)?;
            product.over(&Series::integer(i + 1, a), a)
        })
    }

    fn cross(&self, x: &[Number<A>], y: &[Number<A>]) -> Outcome<A> {
        let a = self.arithmetic;
        let ([x1, x2, x3], [y1, y2, y3]) = (x, y) else {
            return Err(NoValue::shape(
                "a cross product of vectors of other lengths",
            ));
        };
        let minor = |p: &Number<A>, q: &Number<A>, r: &Number<A>, s: &Number<A>| {
            p.times(q, a)?.minus(&r.times(s, a)?, a)
        };
        Ok(Value::vector(vec![
            minor(x2, y3, x3, y2)?,
            minor(x3, y1, x1, y3)?,
            minor(x1, y2, x2, y1)?,
        ]))
    }

    /// Solves `M x = b` for a vector or a matrix b.
    fn solved(&self, matrix: &Vec<Vec<Number<A>>>, right: Value<A::Number>) -> Outcome<A> {
        let a = self.arithmetic;
        let is_vector = matches!(&right, Value::Many(items)
            if items.iter().all(|item| matches!(item, Value::Number(_))));
        if !is_vector {
            return Ok(Value::matrix(linear::solution(matrix, &right.rows()?, a)?));
        }
        let column: Vec<Vec<_>> = right.entries()?.into_iter().map(|x| vec![x]).collect();
        let solution = linear::solution(matrix, &column, a)?;
        Ok(Value::vector(solution.into_iter().flatten().collect()))
    }
}

fn index_name(index: &Expr) -> Result<&str, NoValue> {
    match &index.node {
        Node::Name(name) => Ok(name),
        _ => Err(NoValue::shape(
            "a formula where the name of an index is needed",
        )),
    }
}
