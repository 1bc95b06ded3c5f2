//! Properties of a basis at a point: SEMANTICS.md, "Properties of a basis".
//!
//! The point fixes the shape parameters. The variable ranges over its declared set, and the degree over all degrees
//! from that of the seeds on, or over those that the statement names. Evaluated are the first three degrees, and the
//! variable at the closed bounds and at eleven values between.

use super::environment::Environment;
use super::evaluate::Evaluator;
use super::statement::both;
use crate::arithmetic::{Arithmetic, Comparison};
use crate::domain::stream::Stream;
use crate::judgement::Judgement;
use crate::linear;
use crate::no_value::{NoValue, Unknown};
use crate::series::Series;
use crate::value::Value;
use torse_numbers::Rational;
use torse_numbers::rational::integer;
use torse_syntax::derivation::declarations::{Basis, Bound, Constant, End, SymbolKind};
use torse_syntax::formula::{Expr, Node, Relation};

/// The number of degrees that are evaluated.
const DEGREES: i64 = 3;
/// The number of values of the variable between its bounds.
const BETWEEN: i64 = 11;
/// The number of control polygons that are tried, and of values of the variable for each.
const POLYGONS: u64 = 60;
const ALONG: i64 = 24;
/// The number of trials in which functions must look dependent.
const TRIALS: u64 = 3;
/// Arguments are multiples of one over this number: 2^7 times 3^2 times 7, so that angles have residues.
const ARGUMENT_PARTS: i64 = 8_064;
/// The finite bound that replaces an infinite one.
const FINITE_BOUND: i64 = 4;

type Place<'a, A> = Environment<'a, <A as Arithmetic>::Number>;

/// A basis with the shape parameters of the point.
struct Shaped<'a, 's, A: Arithmetic> {
    name: &'a str,
    basis: &'a Basis,
    parameters: Vec<Value<A::Number>>,
    place: &'s Place<'a, A>,
}

/// The bounds of a set, and whether they belong to it.
type Ends<A> = [(Series<<A as Arithmetic>::Number>, bool); 2];

impl<'a, A: Arithmetic> Evaluator<'a, '_, A> {
    /// Judges a property here.
    pub(super) fn property(
        &self,
        property: &str,
        family: &'a Expr,
        degrees: &'a [Expr],
        place: &Place<'a, A>,
    ) -> Result<Judgement, NoValue> {
        let Node::Name(name) = &family.node else {
            return Err(NoValue::shape(
                "a formula where the name of a basis is needed",
            ));
        };
        let basis = self.declarations.basis(name);
        let basis = &**basis.ok_or_else(|| NoValue::shape("a name that is no basis"))?;
        if !place.moved.is_empty() && place.moved.iter().any(|m| m.symbol == basis.variable) {
            return Err(NoValue::shape("a value for the variable of a basis"));
        }
        let shaped = Shaped {
            name,
            basis,
            parameters: self.left_out(basis, 1, place)?,
            place,
        };
        let least = i64::from(basis.degree);
        let degrees = match degrees {
            [] if basis.is_list => least..=least,
            [] => least..=least + DEGREES - 1,
            [from, to] => {
                let what = "a degree";
                let from = self.integer(from, what, place)?;
                let to = self.integer(to, what, place)?;
                from..=to.min(from + 2 * DEGREES)
            }
            _ => return Err(NoValue::shape("a number of arguments")),
        };
        let mut all = Some(true);
        for degree in degrees {
            let found = match property {
                "nonnegative" => self.is_nonnegative(&shaped, degree)?,
                "independent" => self.is_independent(&shaped, degree)?,
                _ => self.is_diminishing(&shaped, degree)?,
            };
            all = both(all, found);
        }
        Ok(Judgement::from_truth(all))
    }

    /// The functions at a value of the variable.
    fn functions_at(
        &self,
        shaped: &Shaped<'a, '_, A>,
        degree: i64,
        variable: Series<A::Number>,
    ) -> Result<Vec<Series<A::Number>>, NoValue> {
        let mut arguments = vec![Value::Number(variable)];
        arguments.extend(shaped.parameters.iter().cloned());
        let row = self.row(shaped.name, shaped.basis, degree, arguments, shaped.place)?;
        Ok(row.to_vec())
    }

    /// The bounds of the declared set of the variable, and whether they belong to it.
    fn ends(&self, basis: &'a Basis) -> Result<Ends<A>, NoValue> {
        let a = self.arithmetic;
        let interval = match self.declarations.symbol(&basis.variable) {
            Some(SymbolKind::Real(interval)) => Some(interval),
            _ => None,
        };
        let end = |number: Option<&'a Bound>, formula: Option<&'a End>| {
            Ok::<_, NoValue>(match (number, formula) {
                (Some(bound), _) => Some((self.constant(&bound.value)?, bound.closed)),
                (None, Some(end)) => {
                    let value = self.number(&end.formula.expr, &Environment::outermost())?;
                    Some((value, end.closed))
                }
                (None, None) => None,
            })
        };
        let lower = end(
            interval.and_then(|i| i.lower.as_ref()),
            interval.and_then(|i| i.above.as_ref()),
        )?;
        let upper = end(
            interval.and_then(|i| i.upper.as_ref()),
            interval.and_then(|i| i.below.as_ref()),
        )?;
        let far = |n: i64| Series::integer(n, a);
        Ok(match (lower, upper) {
            (Some(lower), Some(upper)) => [lower, upper],
            (Some(lower), None) => {
                let upper = lower.0.plus(&far(FINITE_BOUND), a)?;
                [lower, (upper, false)]
            }
            (None, Some(upper)) => {
                let lower = upper.0.minus(&far(FINITE_BOUND), a)?;
                [(lower, false), upper]
            }
            (None, None) => [(far(-FINITE_BOUND), false), (far(FINITE_BOUND), false)],
        })
    }

    fn constant(&self, constant: &Constant) -> Result<Series<A::Number>, NoValue> {
        let a = self.arithmetic;
        let turns = Series::Number(a.pi()).times(&Series::rational(&constant.turns, a), a)?;
        Series::rational(&constant.rational, a).plus(&turns, a)
    }

    /// The value of the variable at a fraction of the way from one bound to the other.
    fn between(
        &self,
        [(low, _), (high, _)]: &[(Series<A::Number>, bool); 2],
        share: &Rational,
    ) -> Result<Series<A::Number>, NoValue> {
        let a = self.arithmetic;
        let way = high.minus(low, a)?.times(&Series::rational(share, a), a)?;
        low.plus(&way, a)
    }

    fn is_nonnegative(
        &self,
        shaped: &Shaped<'a, '_, A>,
        degree: i64,
    ) -> Result<Option<bool>, NoValue> {
        let ends = self.ends(shaped.basis)?;
        let closed = ends.iter().filter(|(_, closed)| *closed);
        let mut values: Vec<_> = closed.map(|(value, _)| value.clone()).collect();
        for step in 1..=BETWEEN {
            let share = Rational::new(step.into(), (BETWEEN + 1).into());
            values.push(self.between(&ends, &share)?);
        }
        // The symbol of this name has one of these values; a witness gives it that at which a function is negative.
        let own = self.left_out(shaped.basis, 0, shaped.place);
        if let Some(Value::Number(own)) = own.ok().and_then(|all| all.into_iter().next()) {
            values.push(own);
        }
        let zero = self.integer_value(0);
        let mut all = Some(true);
        for value in values {
            for function in self.functions_at(shaped, degree, value)? {
                let sign = self.related(Relation::AtLeast, &Value::Number(function), &zero)?;
                all = both(all, sign);
            }
        }
        Ok(all)
    }

    /// Functions are independent if the determinant of their values at as many arguments is nonzero.
    fn is_independent(
        &self,
        shaped: &Shaped<'a, '_, A>,
        degree: i64,
    ) -> Result<Option<bool>, NoValue> {
        let ends = self.ends(shaped.basis)?;
        let mut all = Some(false);
        for trial in 0..3 {
            let mut rows = vec![];
            for step in 1..=degree + 1 {
                let share = Rational::new((7 * step + trial).into(), (7 * degree + 17).into());
                let value = self.between(&ends, &share)?;
                rows.push(self.functions_at(shaped, degree, value)?);
            }
            let determinant = linear::determinant(&rows, self.arithmetic)?;
            match determinant.is_zero(self.arithmetic) {
                Some(false) => return Ok(Some(true)),
                Some(true) => {}
                None => all = None,
            }
        }
        Ok(all)
    }

    /// Whether the functions of one degree are dependent at the shape parameters of a point: the determinant of their
    /// values at as many random arguments as there are functions is zero in each trial. For independent functions the
    /// probability of this is about the degree of the functions divided by the number of possible arguments, to the
    /// power of the number of trials.
    pub(crate) fn are_dependent(&self, family: &'a Expr, degree: i64) -> Result<bool, NoValue> {
        let Node::Name(name) = &family.node else {
            return Err(NoValue::shape(
                "a formula where the name of a basis is needed",
            ));
        };
        let basis = self.declarations.basis(name);
        let basis = &**basis.ok_or_else(|| NoValue::shape("a name that is no basis"))?;
        let place = Environment::outermost();
        let shaped = Shaped {
            name,
            basis,
            parameters: self.left_out(basis, 1, &place)?,
            place: &place,
        };
        for trial in 0..TRIALS {
            let stream = Stream::new(name, trial);
            let mut rows = vec![];
            for row in 0..=degree {
                // With such arguments the sine and cosine of quarter turns have residues.
                let parts = ARGUMENT_PARTS;
                let share = 1 + stream.below(&format!("argument {row}"), parts - 1);
                let share = Rational::new(share.into(), parts.unsigned_abs().into());
                let variable = Series::rational(&share, self.arithmetic);
                rows.push(self.functions_at(&shaped, degree, variable)?);
            }
            let determinant = linear::determinant(&rows, self.arithmetic)?;
            if determinant.is_zero(self.arithmetic) != Some(true) {
                return Ok(false);
            }
        }
        Ok(true)
    }

    fn is_diminishing(
        &self,
        shaped: &Shaped<'a, '_, A>,
        degree: i64,
    ) -> Result<Option<bool>, NoValue> {
        let a = self.arithmetic;
        let ends = self.ends(shaped.basis)?;
        let mut rows = vec![];
        for step in 1..=ALONG {
            let share = Rational::new(step.into(), (ALONG + 1).into());
            let value = self.between(&ends, &share)?;
            rows.push(self.functions_at(shaped, degree, value)?);
        }
        for polygon in 0..POLYGONS {
            let stream = Stream::new(shaped.name, polygon);
            // Functions with a sum below zero carry curves to the other side of all control values.
            let side = if polygon % 4 == 3 { -1 } else { 1 };
            let line = Rational::new((side * (2 * stream.below("line", 4) + 1)).into(), 2.into());
            let controls: Vec<Rational> = (0..=degree)
                .map(|i| integer(stream.below(&format!("control {i}"), 4)))
                .collect();
            let line_here = a.rational(&line);
            let mut along = vec![];
            for row in &rows {
                let mut height = Series::integer(0, a);
                for (function, control) in row.iter().zip(&controls) {
                    let control = Series::rational(control, a);
                    height = height.plus(&function.times(&control, a)?, a)?;
                }
                let height = height.as_number().ok_or(Unknown::Precision)?;
                match a.compare(height, &line_here)? {
                    Comparison::Less => along.push(false),
                    Comparison::Greater => along.push(true),
                    // Unknown signs can only lower the number of sign changes.
                    _ => {}
                }
            }
            let polygon: Vec<bool> = controls.iter().map(|c| *c > line).collect();
            if changes(&along) > changes(&polygon) {
                return Ok(Some(false));
            }
        }
        Ok(Some(true))
    }
}

/// The number of sign changes.
fn changes(signs: &[bool]) -> usize {
    let pairs = signs.windows(2);
    pairs.filter(|pair| pair.first() != pair.last()).count()
}
