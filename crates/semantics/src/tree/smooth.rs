//! Arbitrary smooth functions: SEMANTICS.md, "Smooth functions".
//!
//! A declared smooth function is represented by a polynomial. If a point specifies derivatives such as `f'(u) = 3`,
//! the polynomial has these at the values of the *texts* of the places, by Newton interpolation with repeated nodes;
//! two places with equal values are an error. The coefficients of higher orders are random, so that a derivative that
//! the point does not specify has a value of its own, and code that overlooks it is caught.

use super::environment::Environment;
use super::evaluate::{Evaluator, no_value};
use super::jets::Smooth;
use crate::arithmetic::Arithmetic;
use crate::domain::stream::Stream;
use crate::name::Name;
use crate::no_value::{NoValue, Unknown};
use crate::series::Series;
use crate::value::Value;
use std::rc::Rc;
use std::sync::Arc;
use torse_numbers::Rational;
use torse_numbers::rational::integer;

/// The largest number of coefficients of a function.
const MAX_COEFFICIENTS: usize = 40;

impl<'a, A: Arithmetic> Evaluator<'a, '_, A> {
    /// The value of a smooth function.
    pub(super) fn smooth_value(
        &self,
        name: &'a str,
        argument: &Series<A::Number>,
    ) -> Result<Value<A::Number>, NoValue> {
        let a = self.arithmetic;
        let known = self.smooth.borrow().get(name).cloned();
        let function = match known {
            Some(Some(known)) => known,
            // The place of the function depends on the value of the function itself.
            Some(None) => return Err(not_placed()),
            None => {
                self.smooth.borrow_mut().insert(name, None);
                let function = Rc::new(self.interpolated(name)?);
                let mut all = self.smooth.borrow_mut();
                all.insert(name, Some(Rc::clone(&function)));
                function
            }
        };
        let mut values = vec![];
        for coefficients in &function.coefficients {
            // Horner's scheme. The result keeps the infinitesimals of the argument even if the function is constant.
            let mut sum = argument.times(&Series::integer(0, a), a)?;
            for (k, coefficient) in coefficients.iter().enumerate().rev() {
                if let Some(node) = function.nodes.get(k) {
                    sum = sum.times(&argument.minus(node, a)?, a)?;
                }
                sum = sum.plus(coefficient, a)?;
            }
            values.push(sum);
        }
        Ok(match (function.is_vector, values.as_slice()) {
            (false, [value]) => Value::Number(value.clone()),
            _ => Value::vector(values),
        })
    }

    fn interpolated(&self, name: &'a str) -> Result<Smooth<A::Number>, NoValue> {
        let a = self.arithmetic;
        let dimension = self.declarations.function(name).flatten();
        let coordinates: Vec<Option<u8>> = match dimension {
            None | Some(1) => vec![None],
            Some(d) => (1..=d).map(Some).collect(),
        };
        let outermost = Environment::outermost();
        let mut nodes = vec![];
        let mut places = vec![];
        let named = self.jets.places.get(name).map_or(&[][..], |all| all);
        for (text, tree, orders) in named {
            let order = orders.last().copied().unwrap_or(0);
            let value = self.number(tree, &outermost)?;
            for (_, other) in &places {
                let apart = value.minus(other, a)?;
                if apart.is_zero(a) != Some(false) {
                    return Err(not_placed());
                }
            }
            nodes.extend((0..=order).map(|_| value.clone()));
            places.push((text, value));
        }
        if nodes.len() > MAX_COEFFICIENTS {
            let what = "the number of derivatives of a function";
            return Err(Unknown::Large { what }.into());
        }
        let last = nodes.last().cloned().unwrap_or_else(|| {
            let stream = Stream::new(name, 0);
            Series::rational(&drawn(&stream, "center"), a)
        });
        let named_nodes = nodes.len();
        nodes.extend((0..self.jets.drawn).map(|_| last.clone()));
        let mut coefficients = vec![];
        for coordinate in coordinates {
            let mut derivatives: Vec<Vec<Series<A::Number>>> = vec![];
            for ((text, _), (.., orders)) in places.iter().zip(named) {
                let order = orders.last().copied().unwrap_or(0);
                let jet = |n| {
                    if orders.contains(&n) {
                        self.jet(name, n, text, coordinate)
                    } else {
                        Ok(self.drawn_jet(name, n, text, coordinate))
                    }
                };
                derivatives.push((0..=order).map(jet).collect::<Result<_, _>>()?);
            }
            let nodes = nodes.get(..named_nodes).unwrap_or_default();
            let mut all = divided_differences(nodes, &derivatives, a)?;
            let stream = Stream::new(&format!("{name} {coordinate:?}"), 0);
            for k in 0..self.jets.drawn {
                all.push(Series::rational(&drawn(&stream, &k.to_string()), a));
            }
            coefficients.push(all);
        }
        Ok(Smooth {
            nodes,
            coefficients,
            is_vector: dimension.is_some_and(|d| d > 1),
        })
    }

    /// A derivative of a function at a place, as specified by the point.
    fn jet(
        &self,
        function: &str,
        order: usize,
        place: &str,
        coordinate: Option<u8>,
    ) -> Result<Series<A::Number>, NoValue> {
        let text = format!("{function}{}({place})", "'".repeat(order));
        let declared: Arc<str> = Arc::from(text.as_str());
        let name = match coordinate {
            None => Name::Symbol(declared),
            Some(c) => Name::Coordinate(declared, c),
        };
        let number = (self.point.values)(&name);
        let number = number.ok_or_else(|| no_value(&text))?;
        Ok(Series::Number(number))
    }

    /// A random derivative, for one that the point does not specify.
    fn drawn_jet(
        &self,
        function: &str,
        order: usize,
        place: &str,
        coordinate: Option<u8>,
    ) -> Series<A::Number> {
        let stream = Stream::new(&format!("{function} {order} {place} {coordinate:?}"), 0);
        Series::rational(&drawn(&stream, "derivative"), self.arithmetic)
    }
}

fn not_placed() -> NoValue {
    let what = "a function at two places that may be one";
    Unknown::NotCovered { what }.into()
}

fn drawn(stream: &Stream, label: &str) -> Rational {
    let numerator = stream.below(label, 41) - 20;
    let denominator = 1 + stream.below(&format!("{label}/"), 5);
    Rational::new(numerator.into(), denominator.into())
}

/// The coefficients of the Newton form. Nodes at one place are adjacent, and `derivatives` contains the derivatives
/// at each place.
///
/// The divided difference of nodes that are all at one place is a derivative over a factorial. Otherwise it is the
/// difference of two divided differences of one node less, divided by the distance of the outer nodes.
fn divided_differences<A: Arithmetic>(
    nodes: &[Series<A::Number>],
    derivatives: &[Vec<Series<A::Number>>],
    a: &A,
) -> Result<Vec<Series<A::Number>>, NoValue> {
    let place_of: Vec<usize> = derivatives
        .iter()
        .enumerate()
        .flat_map(|(place, all)| all.iter().map(move |_| place))
        .collect();
    let derivative = |place: usize, order: usize| -> Result<Series<A::Number>, NoValue> {
        let all = derivatives.get(place);
        let value = all.and_then(|all| all.get(order)).ok_or_else(not_placed)?;
        let factorial: Rational = (1..=order)
            .filter_map(|n| i64::try_from(n).ok())
            .map(integer)
            .product();
        value.over(&Series::rational(&factorial, a), a)
    };
    let mut column = vec![];
    for place in &place_of {
        column.push(derivative(*place, 0)?);
    }
    let mut coefficients: Vec<Series<A::Number>> = column.first().cloned().into_iter().collect();
    for width in 1..nodes.len() {
        let mut next = vec![];
        for low in 0..nodes.len() - width {
            let high = low + width;
            let (Some(p), Some(q)) = (place_of.get(low), place_of.get(high)) else {
                return Err(not_placed());
            };
            if p == q {
                next.push(derivative(*p, width)?);
                continue;
            }
            let (Some(x), Some(y)) = (nodes.get(low), nodes.get(high)) else {
                return Err(not_placed());
            };
            let (Some(before), Some(after)) = (column.get(low), column.get(low + 1)) else {
                return Err(not_placed());
            };
            next.push(after.minus(before, a)?.over(&y.minus(x, a)?, a)?);
        }
        coefficients.extend(next.first().cloned());
        column = next;
    }
    Ok(coefficients)
}
