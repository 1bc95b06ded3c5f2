//! Values of instances as numbers, points and other instances.

use super::part21::{Data, Instance, Value};
use crate::read::decimal::{decimal, double};
use crate::read::error::{ReadError, ReadResult, at};
use std::cell::Cell;
use torse_algebra::Rational;
use torse_geometry::Coordinate;
use torse_geometry::vector::{cross, dot, scale, sub, unit};

/// The most instances that are looked up while a file is read, in multiples of their number, plus a million: those that
/// are used in several places are read in each.
const MAX_WORK: usize = 50;

/// Looks values up; counts how often, so that no file of many levels takes time without bound.
pub(super) struct Resolver<'t, 'd> {
    pub data: &'d Data<'t>,
    work: Cell<usize>,
}

/// An orthonormal frame: a place and three directions.
#[derive(Debug, Clone)]
pub(super) struct Axes {
    pub origin: [Rational; 3],
    pub x: [f64; 3],
    pub y: [f64; 3],
    pub z: [f64; 3],
}

impl Axes {
    pub(super) fn place(&self) -> [f64; 3] {
        self.origin.each_ref().map(Coordinate::approximate)
    }
}

impl<'t, 'd> Resolver<'t, 'd> {
    pub(super) fn new(data: &'d Data<'t>) -> Self {
        Self {
            data,
            work: Cell::new(0),
        }
    }

    /// The instance that a value refers to.
    pub(super) fn instance(
        &self,
        from: &Instance<'t>,
        value: Option<&Value<'t>>,
    ) -> ReadResult<&'d Instance<'t>> {
        self.work.set(self.work.get() + 1);
        let most = MAX_WORK * self.data.all().len() + 1_000_000;
        if self.work.get() > most {
            return Err(ReadError::TooMuch {
                place: from.place(),
                what: "references to follow",
                most,
            });
        }
        let Some(Value::Reference(id)) = value else {
            return Err(at(&from.place(), "a reference to an instance is missing"));
        };
        self.data
            .get(*id)
            .ok_or_else(|| at(&from.place(), format!("there is no instance #{id}")))
    }

    /// The instances that a list of references names.
    pub(super) fn instances(
        &self,
        from: &Instance<'t>,
        value: Option<&Value<'t>>,
    ) -> ReadResult<Vec<&'d Instance<'t>>> {
        let list = list(from, value)?;
        list.iter()
            .map(|one| self.instance(from, Some(one)))
            .collect()
    }

    /// The values of an entity, which must be one of the instance.
    pub(super) fn part<'i>(
        &self,
        instance: &'i Instance<'t>,
        keyword: &str,
    ) -> ReadResult<&'i [Value<'t>]> {
        instance
            .part(keyword)
            .ok_or_else(|| at(&instance.place(), format!("{keyword} is wanted here")))
    }

    /// A point of the space; one of the plane has z = 0.
    pub(super) fn point(
        &self,
        from: &Instance<'t>,
        value: Option<&Value<'t>>,
    ) -> ReadResult<[Rational; 3]> {
        let instance = self.instance(from, value)?;
        let values = self.part(instance, "CARTESIAN_POINT")?;
        let coordinates = list(instance, values.last())?;
        if !(2..=3).contains(&coordinates.len()) {
            return Err(at(
                &instance.place(),
                "a point has two or three coordinates",
            ));
        }
        let mut point: [Rational; 3] = std::array::from_fn(|_| Rational::default());
        for (slot, value) in point.iter_mut().zip(coordinates) {
            *slot = exact(instance, Some(value))?;
        }
        Ok(point)
    }

    pub(super) fn points(
        &self,
        from: &Instance<'t>,
        value: Option<&Value<'t>>,
    ) -> ReadResult<Vec<[Rational; 3]>> {
        let list = list(from, value)?;
        list.iter().map(|one| self.point(from, Some(one))).collect()
    }

    /// A direction of length one.
    pub(super) fn direction(
        &self,
        from: &Instance<'t>,
        value: Option<&Value<'t>>,
    ) -> ReadResult<[f64; 3]> {
        let instance = self.instance(from, value)?;
        let ratios = list(instance, self.part(instance, "DIRECTION")?.last())?;
        let mut direction = [0.0; 3];
        for (slot, value) in direction.iter_mut().zip(ratios) {
            *slot = number(instance, Some(value))?;
        }
        unit(&direction).ok_or_else(|| at(&instance.place(), "a direction of length zero"))
    }

    /// A vector: direction times length.
    pub(super) fn vector(
        &self,
        from: &Instance<'t>,
        value: Option<&Value<'t>>,
    ) -> ReadResult<[f64; 3]> {
        let instance = self.instance(from, value)?;
        let values = self.part(instance, "VECTOR")?;
        let direction = self.direction(instance, values.get(1))?;
        let vector = scale(&number(instance, values.get(2))?, &direction);
        if vector.iter().any(|c| !c.is_finite()) || vector == [0.0; 3] {
            return Err(at(&instance.place(), "a vector without length"));
        }
        Ok(vector)
    }

    /// A placement by its axis and the direction of reference, made orthogonal as the standard says.
    pub(super) fn axes(&self, from: &Instance<'t>, value: Option<&Value<'t>>) -> ReadResult<Axes> {
        let instance = self.instance(from, value)?;
        if let Some(values) = instance.part("AXIS1_PLACEMENT") {
            let z = self.optional_direction(instance, values.get(2), [0.0, 0.0, 1.0])?;
            return self.frame(instance, values.get(1), z, None);
        }
        let values = self.part(instance, "AXIS2_PLACEMENT_3D")?;
        let z = self.optional_direction(instance, values.get(2), [0.0, 0.0, 1.0])?;
        let x = match values.get(3) {
            None | Some(Value::None) => None,
            value => Some(self.direction(instance, value)?),
        };
        self.frame(instance, values.get(1), z, x)
    }

    fn optional_direction(
        &self,
        from: &Instance<'t>,
        value: Option<&Value<'t>>,
        usual: [f64; 3],
    ) -> ReadResult<[f64; 3]> {
        match value {
            None | Some(Value::None) => Ok(usual),
            value => self.direction(from, value),
        }
    }

    fn frame(
        &self,
        from: &Instance<'t>,
        origin: Option<&Value<'t>>,
        z: [f64; 3],
        x: Option<[f64; 3]>,
    ) -> ReadResult<Axes> {
        let usual = if z[0].abs() == 1.0 {
            [0.0, 1.0, 0.0]
        } else {
            [1.0, 0.0, 0.0]
        };
        let x = x.unwrap_or(usual);
        let across = sub(&x, &scale(&dot(&x, &z), &z));
        let x = unit(&across)
            .ok_or_else(|| at(&from.place(), "an axis along its direction of reference"))?;
        Ok(Axes {
            origin: self.point(from, origin)?,
            y: cross(&z, &x),
            x,
            z,
        })
    }
}

pub(super) fn list<'v, 't>(
    from: &Instance<'t>,
    value: Option<&'v Value<'t>>,
) -> ReadResult<&'v [Value<'t>]> {
    match value {
        Some(Value::List(values)) => Ok(values),
        _ => Err(at(&from.place(), "a list is missing")),
    }
}

/// A number, also with its type: `LENGTH_MEASURE(1.)`.
pub(super) fn digits<'t>(from: &Instance<'t>, value: Option<&Value<'t>>) -> ReadResult<&'t str> {
    match value {
        Some(Value::Number(text)) => Ok(text),
        Some(Value::Typed(_, values)) => match values.as_slice() {
            [Value::Number(text)] => Ok(text),
            _ => Err(at(&from.place(), "a number is missing")),
        },
        _ => Err(at(&from.place(), "a number is missing")),
    }
}

pub(super) fn exact<'t>(from: &Instance<'t>, value: Option<&Value<'t>>) -> ReadResult<Rational> {
    let text = digits(from, value)?;
    decimal(text).ok_or_else(|| {
        at(
            &from.place(),
            format!(
                "`{}` is no finite number",
                text.chars().take(40).collect::<String>()
            ),
        )
    })
}

pub(super) fn number<'t>(from: &Instance<'t>, value: Option<&Value<'t>>) -> ReadResult<f64> {
    let text = digits(from, value)?;
    double(text).ok_or_else(|| {
        at(
            &from.place(),
            format!(
                "`{}` is no finite number",
                text.chars().take(40).collect::<String>()
            ),
        )
    })
}

pub(super) fn positive<'t>(
    from: &Instance<'t>,
    value: Option<&Value<'t>>,
    what: &str,
) -> ReadResult<f64> {
    let value = number(from, value)?;
    if value > 0.0 {
        return Ok(value);
    }
    Err(at(&from.place(), format!("{what} of {value}")))
}

pub(super) fn whole<'t>(from: &Instance<'t>, value: Option<&Value<'t>>) -> ReadResult<usize> {
    let text = digits(from, value)?;
    text.trim_end_matches('.')
        .parse()
        .map_err(|_| at(&from.place(), "a whole number is missing"))
}

/// `.T.` or not.
pub(super) fn truth(value: Option<&Value<'_>>) -> bool {
    matches!(value, Some(Value::Word("T")))
}

/// The label of an instance, if somebody gave one.
pub(super) fn label<'t>(value: Option<&Value<'t>>) -> Option<&'t str> {
    match value {
        Some(Value::Text(text)) if !text.trim().is_empty() && *text != "NONE" => Some(text.trim()),
        _ => None,
    }
}

/// The knots of a spline from values and multiplicities.
pub(super) fn knots<'t>(
    from: &Instance<'t>,
    multiplicities: Option<&Value<'t>>,
    values: Option<&Value<'t>>,
    most: usize,
) -> ReadResult<Vec<Rational>> {
    let (counts, values) = (list(from, multiplicities)?, list(from, values)?);
    if counts.len() != values.len() {
        return Err(at(
            &from.place(),
            format!(
                "{} knots with {} multiplicities",
                values.len(),
                counts.len()
            ),
        ));
    }
    let mut knots = Vec::new();
    for (count, value) in counts.iter().zip(values) {
        let (count, value) = (whole(from, Some(count))?, exact(from, Some(value))?);
        if count == 0 || knots.len() + count > most {
            return Err(at(
                &from.place(),
                format!("a knot of multiplicity {count}; there are {most} in all"),
            ));
        }
        knots.extend(std::iter::repeat_n(value, count));
    }
    Ok(knots)
}
