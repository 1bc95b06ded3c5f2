//! Sums, products, quotients and powers of numbers, vectors and matrices, within bounds of work.

use super::quantity::Quantity;
use super::value::{Value, Vector};
use super::{Environment, Evaluator, Outcome, shapes, symbolic_degree, wrong_type};
use std::cell::RefCell;
use torse_algebra::{Fraction, Polynomial, Rational};
use torse_core::Term;
use torse_syntax::fault::{Fault, Problem};
use torse_syntax::formula::{Operator, Place};

/// The most term products one multiplication may cost.
const MAX_PRODUCTS: usize = 4_000_000;
/// The largest exponent.
const MAX_POWER: u64 = 200;

impl Evaluator<'_> {
    pub(super) fn binary(
        &self,
        operator: Operator,
        a: &Term,
        b: &Term,
        bound: &Environment,
    ) -> Outcome<Value> {
        let place = a.place.to(b.place);
        let left = self.value(a, bound)?;
        if operator == Operator::Power {
            return self.power(&left, a, b, bound);
        }
        let right = self.value(b, bound)?;
        numeric(&left, a.place)?;
        numeric(&right, b.place)?;
        match operator {
            Operator::Add | Operator::Subtract => {
                let combine = |x: &Quantity, y: &Quantity| match operator {
                    Operator::Subtract => x.minus(y),
                    _ => x.plus(y),
                };
                if let (Value::Scalar(x), Value::Scalar(y)) = (&left, &right) {
                    return Ok(Value::Scalar(combine(x, y)));
                }
                let (left, right) = fitted(&left, &right, place)?;
                let mut others = right.entries().into_iter();
                let combined =
                    left.mapped(&|_: &Quantity| Ok::<_, Fault>(Fraction::zero().into()))?;
                let sums: Vec<Quantity> = left
                    .entries()
                    .into_iter()
                    .map(|x| {
                        let y = others
                            .next()
                            .cloned()
                            .unwrap_or_else(|| Fraction::zero().into());
                        combine(x, &y)
                    })
                    .collect();
                refilled(&combined, sums)
            }
            Operator::Multiply => self.product(&left, &right, place),
            Operator::Divide => {
                let Value::Scalar(divisor) = &right else {
                    return Err(wrong_type(b.place, right.kind(), "a number"));
                };
                let divisor = divisor
                    .as_fraction()
                    .ok_or_else(|| symbolic_degree(b.place))?;
                let inverse = Fraction::integer(1)
                    .over(divisor)
                    .map_err(|e| Fault::exact(b.place, e))?;
                left.mapped(&|q: &Quantity| Ok(q.times(&inverse)))
            }
            Operator::Power => Err(wrong_type(place, "a power", "a product")),
        }
    }

    pub(super) fn product(&self, left: &Value, right: &Value, place: Place) -> Outcome<Value> {
        match (left, right) {
            (Value::Scalar(x), other) | (other, Value::Scalar(x)) => {
                other.mapped(&|q: &Quantity| multiplied(x, q, place))
            }
            (Value::Matrix(a), Value::Matrix(b)) => Ok(Value::Matrix(matrix_product(a, b, place)?)),
            (Value::Matrix(a), Value::Vector(v)) if !v.generic => {
                let column: Vec<Vec<Quantity>> =
                    v.entries.iter().map(|q| vec![q.clone()]).collect();
                let entries = matrix_product(a, &column, place)?
                    .into_iter()
                    .flatten()
                    .collect();
                Ok(Value::Vector(Vector {
                    entries,
                    generic: false,
                }))
            }
            (Value::Vector(_), Value::Vector(_)) => Err(wrong_type(
                place,
                "a product of vectors",
                "dot(a, b) or cross(a, b)",
            )),
            (a, _) => Err(wrong_type(place, a.kind(), "factors that fit")),
        }
    }

    pub(super) fn power(
        &self,
        base: &Value,
        a: &Term,
        b: &Term,
        bound: &Environment,
    ) -> Outcome<Value> {
        let Value::Scalar(quantity) = base else {
            return Err(wrong_type(a.place, base.kind(), "a number"));
        };
        let exponent = self.index(b, bound).map_err(|fault| match *fault.problem {
            Problem::WrongType { .. } => Fault::exponent(b.place),
            _ => fault,
        })?;
        let Some(n) = exponent.as_number() else {
            let base = quantity.as_fraction();
            let base = base.ok_or_else(|| symbolic_degree(a.place))?;
            return self.symbolic_power(base, &exponent, b.place);
        };
        if n.unsigned_abs() > MAX_POWER {
            return Err(Fault::limit(
                b.place,
                format!("the power {n} is larger than {MAX_POWER}"),
            ));
        }
        // A power has a value where its base has one, that with the exponent zero, too.
        let one = Fraction::integer(1).under(&quantity.conditions());
        let Some(base) = quantity.as_fraction() else {
            // A power of a series is a product of few.
            let factors = u32::try_from(n).map_err(|_| symbolic_degree(a.place))?;
            let power = (0..factors).try_fold(Quantity::from(one), |power, _| {
                multiplied(&power, quantity, a.place)
            });
            return power.map(Value::Scalar);
        };
        let mut result = one;
        for _ in 0..n.unsigned_abs() {
            result = bounded_product(&result, base, a.place)?;
        }
        if n < 0 {
            result = Fraction::integer(1)
                .over(&result)
                .map_err(|e| Fault::exact(a.place, e))?;
        }
        Ok(result.into())
    }
}

pub(super) fn numeric(value: &Value, place: Place) -> Outcome<()> {
    match value {
        Value::Truth(_) => Err(wrong_type(
            place,
            value.kind(),
            "a number, vector or matrix",
        )),
        _ => Ok(()),
    }
}

/// Both values in one shape: zero fits every vector and matrix.
pub(super) fn fitted(left: &Value, right: &Value, place: Place) -> Outcome<(Value, Value)> {
    let is_zero = |v: &Value| match v {
        Value::Scalar(q) => q.as_fraction().is_some_and(Fraction::is_zero),
        _ => false,
    };
    // They have a value where the zero has one.
    let zeros = |zero: &Value, like: &Value| {
        let quantities = zero.entries().into_iter();
        let conditions: Vec<Polynomial> = quantities.flat_map(|q| q.conditions()).collect();
        let entry: Quantity = Fraction::zero().under(&conditions).into();
        like.mapped(&|_: &Quantity| Ok::<Quantity, Fault>(entry.clone()))
    };
    match (left, right) {
        (Value::Scalar(_), Value::Scalar(_)) => {}
        (a, b) if is_zero(a) => return Ok((zeros(a, b)?, b.clone())),
        (a, b) if is_zero(b) => return Ok((a.clone(), zeros(b, a)?)),
        (Value::Vector(a), Value::Vector(b))
            if a.generic == b.generic && a.entries.len() == b.entries.len() => {}
        (Value::Vector(a), Value::Vector(b)) => {
            let size = |v: &Vector| {
                if v.generic {
                    "a generic vector".to_owned()
                } else {
                    format!("a vector of {}", v.entries.len())
                }
            };
            return Err(shapes(place, &size(a), &size(b)));
        }
        (Value::Matrix(a), Value::Matrix(b))
            if a.len() == b.len() && a.first().map(Vec::len) == b.first().map(Vec::len) => {}
        (a, b) => return Err(shapes(place, a.kind(), b.kind())),
    }
    Ok((left.clone(), right.clone()))
}

/// A value of the same shape with these entries, in order.
pub(super) fn refilled(shape: &Value, entries: Vec<Quantity>) -> Outcome<Value> {
    let source = RefCell::new(entries.into_iter());
    shape.mapped(&|_: &Quantity| {
        Ok(source
            .borrow_mut()
            .next()
            .unwrap_or_else(|| Fraction::zero().into()))
    })
}

/// The product of two quantities, within bounds of work.
pub(super) fn multiplied(x: &Quantity, y: &Quantity, place: Place) -> Outcome<Quantity> {
    match (x.as_fraction(), y.as_fraction()) {
        (Some(a), Some(b)) => Ok(bounded_product(a, b, place)?.into()),
        (Some(a), None) => Ok(y.times(a)),
        (None, Some(b)) => Ok(x.times(b)),
        (None, None) => x
            .product(y)
            .map_err(|e| Fault::exact(place, e))?
            .ok_or_else(|| Fault::limit(place, "a product of many sums of symbolic degree")),
    }
}

pub(super) fn bounded_product(a: &Fraction, b: &Fraction, place: Place) -> Outcome<Fraction> {
    if a.numerator().len().saturating_mul(b.numerator().len()) > MAX_PRODUCTS {
        return Err(Fault::limit(
            place,
            "a product of more than four million terms",
        ));
    }
    let degree = a
        .numerator()
        .total_degree()
        .saturating_add(b.numerator().total_degree());
    if degree > u32::from(u16::MAX) / 2 {
        return Err(Fault::limit(place, format!("a product of degree {degree}")));
    }
    let bits = a.numerator().bits() + b.numerator().bits();
    if bits > Rational::MAX_BITS {
        return Err(Fault::limit(
            place,
            format!("a product with numbers of {bits} binary digits"),
        ));
    }
    Ok(a * b)
}

pub(super) fn matrix_product(
    a: &[Vec<Quantity>],
    b: &[Vec<Quantity>],
    place: Place,
) -> Outcome<Vec<Vec<Quantity>>> {
    let inner = a.first().map_or(0, Vec::len);
    if inner != b.len() {
        return Err(shapes(
            place,
            &format!("{inner} columns"),
            &format!("{} rows", b.len()),
        ));
    }
    let columns = b.first().map_or(0, Vec::len);
    a.iter()
        .map(|row| {
            (0..columns)
                .map(|column| {
                    row.iter()
                        .zip(b)
                        .filter_map(|(x, other)| other.get(column).map(|y| (x, y)))
                        .try_fold(Quantity::from(Fraction::zero()), |sum, (x, y)| {
                            Ok(sum.plus(&multiplied(x, y, place)?))
                        })
                })
                .collect()
        })
        .collect()
}
