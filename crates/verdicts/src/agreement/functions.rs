//! The built-in functions of core terms.

use super::scope::Scope;
use super::terms::{Number, Outcome, Terms};
use std::sync::Arc;
use torse_algebra::Rational;
use torse_algebra::rational::integer;
use torse_core::{ArcFunction, BuiltIn, Node, Source, Statement, Term};
use torse_semantics::{
    Arithmetic, Class, Name, NoValue, Series, Undefined, Unknown, Value, dot, linear, transposed,
};
use torse_syntax::formula::{Connective, Relation};

/// Maximum argument of a factorial, and maximum lower argument of a binomial coefficient.
const MAX_FACTORIAL: i64 = 400;
/// Maximum size of a unit matrix.
const MAX_IDENTITY: i64 = 16;

type Row = Vec<Series<Class>>;

impl Terms<'_> {
    /// Evaluates a function at its arguments.
    pub fn apply(&self, function: BuiltIn, arguments: &[Term], scope: &Scope<'_>) -> Outcome {
        let a = self.arithmetic;
        let value = |term: &Term| self.term(term, scope);
        let number = |term: &Term| self.number(term, scope);
        let entries = |term: &Term| self.term(term, scope)?.entries();
        let rows = |term: &Term| self.term(term, scope)?.rows();
        Ok(match (function, arguments) {
            (BuiltIn::Binomial, [n, j]) => {
                let what = "the lower number of a binomial coefficient";
                Value::Number(self.binomial(&number(n)?, self.integer(j, what, scope)?)?)
            }
            (BuiltIn::Factorial, [n]) => {
                let what = "the argument of a factorial";
                let n = self.natural(n, what, MAX_FACTORIAL, scope)?;
                let product: Rational = (1..=n).map(integer).product();
                Value::Number(Series::rational(&product, a))
            }
            (BuiltIn::SquareRoot, [q]) => Value::Number(number(q)?.square_root(a)?),
            (BuiltIn::Sine, [angle]) => Value::Number(number(angle)?.sine_cosine(a)?.0),
            (BuiltIn::Cosine, [angle]) => Value::Number(number(angle)?.sine_cosine(a)?.1),
            (BuiltIn::Exponential, [x]) => Value::Number(number(x)?.exponential(a)?),
            (BuiltIn::ArcTangent, [x]) => Value::Number(number(x)?.arctangent(a)?),
            (BuiltIn::ArcSine, [x]) => Value::Number(number(x)?.arcsine(a)?),
            (BuiltIn::Logarithm, [x]) => Value::Number(number(x)?.logarithm(a)?),
            (BuiltIn::Dot, [x, y]) => Value::Number(dot(&entries(x)?, &entries(y)?, a)?),
            (BuiltIn::Norm, [v]) => {
                let entries = entries(v)?;
                Value::Number(dot(&entries, &entries, a)?.square_root(a)?)
            }
            (BuiltIn::Cross, [x, y]) => {
                let (x, y) = (entries(x)?, entries(y)?);
                let ([x1, x2, x3], [y1, y2, y3]) = (x.as_slice(), y.as_slice()) else {
                    return Err(NoValue::shape(
                        "a cross product of vectors of other lengths",
                    ));
                };
                let minor = |p: &Series<Class>, q: &Series<Class>, r: &Series<Class>, s| {
                    p.times(q, a)?.minus(&r.times(s, a)?, a)
                };
                Value::vector(vec![
                    minor(x2, y3, x3, y2)?,
                    minor(x3, y1, x1, y3)?,
                    minor(x1, y2, x2, y1)?,
                ])
            }
            (BuiltIn::Determinant, [m]) => Value::Number(linear::determinant(&rows(m)?, a)?),
            (BuiltIn::Transpose, [m]) => Value::matrix(transposed(&rows(m)?)),
            (BuiltIn::Inverse, [m]) => Value::matrix(linear::inverse(&rows(m)?, a)?),
            (BuiltIn::Solve, [m, right]) => {
                let (matrix, right) = (rows(m)?, value(right)?);
                match right.clone().entries() {
                    Ok(entries) => {
                        let column: Vec<Row> = entries.into_iter().map(|x| vec![x]).collect();
                        let solution = linear::solution(&matrix, &column, a)?;
                        Value::vector(solution.into_iter().flatten().collect())
                    }
                    Err(_) => Value::matrix(linear::solution(&matrix, &right.rows()?, a)?),
                }
            }
            (BuiltIn::Identity, [n]) => {
                let n = self.natural(n, "the size of a unit matrix", MAX_IDENTITY, scope)?;
                Value::matrix(linear::identity(usize::try_from(n).unwrap_or(0), a))
            }
            (BuiltIn::Coefficients, [forms, symbols]) => {
                self.coefficients(forms, symbols, scope)?
            }
            _ => return Err(NoValue::shape("a number of arguments to the function")),
        })
    }

    /// Returns a non-negative integer; fails for anything else.
    fn natural(
        &self,
        term: &Term,
        what: &'static str,
        most: i64,
        scope: &Scope<'_>,
    ) -> Result<i64, NoValue> {
        match self.integer(term, what, scope)? {
            n if n < 0 => Err(Undefined::Negative { what }.into()),
            n if n > most => Err(Unknown::Large { what }.into()),
            n => Ok(n),
        }
    }

    /// `n (n-1) ... (n-j+1) / j!`, 0 for a negative j. Independent of the binomials of `semantics`, on purpose: the falling product
    /// is divided once.
    fn binomial(&self, n: &Series<Class>, j: i64) -> Number {
        let a = self.arithmetic;
        if j < 0 {
            return Ok(Series::integer(0, a));
        }
        if j > MAX_FACTORIAL {
            let what = "a binomial coefficient";
            return Err(Unknown::Large { what }.into());
        }
        let (mut above, mut below) = (Series::integer(1, a), Series::integer(1, a));
        for i in 1..=j {
            above = above.times(&n.minus(&Series::integer(i - 1, a), a)?, a)?;
            below = below.times(&Series::integer(i, a), a)?;
        }
        above.over(&below, a)
    }

    /// Returns a row for each form and a column for each symbol. In a claim with `given` equations, the unknowns U are
    /// functions of the other symbols v: the derivative is `F_v + F_U a` with `G_U a = -G_v`.
    fn coefficients(&self, forms: &Term, symbols: &Term, scope: &Scope<'_>) -> Outcome {
        let a = self.arithmetic;
        let names = self.names(symbols, scope)?;
        let forms = |scope: &Scope<'_>| Ok(numbers(&self.term(forms, scope)?));
        let mut columns = vec![];
        match self.given.filter(|claim| !claim.unknowns.is_empty()) {
            None => {
                for name in &names {
                    let (first, second) = self.rates(name, 2, scope, &forms)?;
                    if second.iter().any(|x| x.is_zero(a) != Some(true)) {
                        return Err(Undefined::NotLinear.into());
                    }
                    columns.push(first);
                }
            }
            Some(claim) => {
                let outermost = Scope::outermost();
                let unknowns = claim.unknowns.iter().map(|u| self.names(u, &outermost));
                let unknowns: Vec<Name> = unknowns.collect::<Result<Vec<_>, _>>()?.concat();
                // Nothing is substituted in the equations themselves.
                let plain = Terms::new(a, self.point(), None);
                let gaps = |scope: &Scope<'_>| plain.gaps(claim, scope);
                let by = |names: &[Name]| -> Result<Vec<Row>, NoValue> {
                    let rates = names.iter().map(|n| plain.rates(n, 1, &outermost, &gaps));
                    rates.map(|rates| Ok(rates?.0)).collect()
                };
                let solved = linear::solved_columns(&by(&unknowns)?, &by(&names)?, a)?;
                let what = "an unknown that the given equations do not determine";
                let solved = solved.ok_or(Unknown::NotCovered { what })?;
                let by_unknown = unknowns.iter().map(|n| self.rates(n, 1, scope, &forms));
                let by_unknown = by_unknown.collect::<Result<Vec<_>, _>>()?;
                for (name, changes) in names.iter().zip(solved) {
                    let mut column = self.rates(name, 1, scope, &forms)?.0;
                    for ((rates, _), change) in by_unknown.iter().zip(&changes) {
                        for (entry, rate) in column.iter_mut().zip(rates) {
                            *entry = entry.plus(&rate.times(change, a)?, a)?;
                        }
                    }
                    columns.push(column);
                }
            }
        }
        Ok(Value::matrix(transposed(&columns)))
    }

    /// Returns first and second coefficients of numbers with respect to a moved symbol.
    fn rates(
        &self,
        name: &Name,
        order: usize,
        scope: &Scope<'_>,
        value: &dyn Fn(&Scope<'_>) -> Result<Row, NoValue>,
    ) -> Result<(Row, Row), NoValue> {
        let a = self.arithmetic;
        let level = scope.level + 1;
        let own = self.symbol(name.clone(), scope)?.shifted(level, order, a);
        let values = value(&scope.moved(name.clone(), own, self.next_move()))?;
        let coefficient = |k| values.iter().map(|v| v.coefficient(level, k, a)).collect();
        Ok((coefficient(1), coefficient(2)))
    }

    /// Returns left minus right side of each given equation.
    fn gaps(&self, claim: &torse_core::Claim, scope: &Scope<'_>) -> Result<Row, NoValue> {
        let given = claim.hypotheses.iter();
        let given = given.filter(|h| h.source == Source::Given);
        let mut pending: Vec<&Statement> = given.rev().map(|h| &h.statement).collect();
        let mut gaps = vec![];
        while let Some(statement) = pending.pop() {
            match statement {
                Statement::Join(Connective::And, a, b) => pending.extend([&**b, &**a]),
                Statement::Compare {
                    relation: Relation::Equal,
                    left,
                    right,
                } => {
                    let (left, right) = (self.term(left, scope)?, self.term(right, scope)?);
                    for (x, y) in left.pairs(&right, self.arithmetic)? {
                        gaps.push(x.minus(&y, self.arithmetic)?);
                    }
                }
                _ => {}
            }
        }
        Ok(gaps)
    }

    /// Returns the numbers of the point for a list of symbols, coordinates and members.
    fn names(&self, term: &Term, scope: &Scope<'_>) -> Result<Vec<Name>, NoValue> {
        let none = || NoValue::shape("a formula where a symbol is needed");
        Ok(match &*term.node {
            Node::List(items) => {
                let names = items.iter().map(|item| self.names(item, scope));
                names.collect::<Result<Vec<_>, _>>()?.concat()
            }
            Node::Opened { body, .. } => self.names(body, scope)?,
            Node::Symbol(name) | Node::Vector(name, None) => vec![Name::Symbol(Arc::clone(name))],
            Node::Vector(name, Some(dimension)) => (1..=*dimension)
                .map(|c| Name::Coordinate(Arc::clone(name), c))
                .collect(),
            Node::Member(points, indices) => {
                let indices = indices.iter().map(|i| self.integer(i, "an index", scope));
                let indices: Vec<i64> = indices.collect::<Result<_, _>>()?;
                let member = |c| Name::Member(Arc::clone(&points.name), indices.clone(), c);
                match points.dimension {
                    None | Some(1) => vec![member(None)],
                    Some(d) => (1..=d).map(|c| member(Some(c))).collect(),
                }
            }
            Node::Entry(of, indices) => {
                let all = self.names(of, scope)?;
                let [index] = indices.as_slice() else {
                    return Err(none());
                };
                let index = self.integer(index, "an index", scope)?;
                let position = index.checked_sub(1).and_then(|p| usize::try_from(p).ok());
                let name = position.and_then(|p| all.get(p).cloned());
                vec![name.ok_or_else(none)?]
            }
            _ => return Err(none()),
        })
    }
}

fn numbers(value: &Value<Class>) -> Row {
    value.numbers().into_iter().cloned().collect()
}

/// The value of an arc at its argument.
pub fn arc_value<A: Arithmetic>(
    function: ArcFunction,
    argument: &Series<A::Number>,
    arithmetic: &A,
) -> Result<Series<A::Number>, NoValue> {
    match function {
        ArcFunction::Tangent => argument.arctangent(arithmetic),
        ArcFunction::Sine => argument.arcsine(arithmetic),
    }
}
