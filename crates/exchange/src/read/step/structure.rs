//! Representations of STEP: which items are in which, in which units, and where parts are placed in assemblies.

use super::part21::{Instance, Value};
use super::values::{Axes, Resolver, exact, label, list, number};
use crate::read::LengthUnit;
use crate::read::error::{ReadError, ReadResult, at};
use torse_algebra::Rational;
use torse_geometry::{AffineMap, Coordinate};

/// The units and the uncertainty of a representation.
#[derive(Debug, Clone)]
pub(super) struct Context {
    pub unit: Option<LengthUnit>,
    /// Radians of the unit of angles.
    pub angle: f64,
    /// In the unit of length.
    pub uncertainty: Option<f64>,
}

/// A representation placed below another one.
pub(super) struct Placed {
    pub child: u64,
    pub parent: u64,
    /// The placements that come to lie on each other: in the child, in the parent; none where both coincide.
    pub axes: Option<[Axes; 2]>,
}

impl<'t> Resolver<'t, '_> {
    /// The units of the context that a value refers to.
    pub(super) fn context(
        &self,
        from: &Instance<'t>,
        value: Option<&Value<'t>>,
    ) -> ReadResult<Context> {
        let mut context = Context {
            unit: None,
            angle: 1.0,
            uncertainty: None,
        };
        let instance = self.instance(from, value)?;
        if let Some(values) = instance.part("GLOBAL_UNIT_ASSIGNED_CONTEXT") {
            for unit in self.instances(instance, values.first())? {
                if unit.part("LENGTH_UNIT").is_some() {
                    context.unit = Some(self.length(unit, 0)?);
                } else if unit.part("PLANE_ANGLE_UNIT").is_some() {
                    context.angle = self.angle(unit, 0)?;
                }
            }
        }
        if let Some(values) = instance.part("GLOBAL_UNCERTAINTY_ASSIGNED_CONTEXT") {
            for measure in self.instances(instance, values.first())? {
                if let Some(values) = measure.part("UNCERTAINTY_MEASURE_WITH_UNIT") {
                    context.uncertainty = Some(number(measure, values.first())?);
                }
            }
        }
        Ok(context)
    }

    /// A unit of length.
    fn length(&self, unit: &Instance<'t>, depth: usize) -> ReadResult<LengthUnit> {
        let wrong = || at(&unit.place(), "a unit of length that is not read");
        if depth > 8 {
            return Err(at(&unit.place(), "a unit that is defined by itself"));
        }
        if let Some(values) = unit.part("SI_UNIT") {
            // Of a complex instance prefix and name alone.
            let tail = values
                .get(values.len().saturating_sub(2)..)
                .unwrap_or_default();
            let (Some(prefix), Some(Value::Word("METRE"))) = (tail.first(), tail.last()) else {
                return Err(wrong());
            };
            let power = match prefix {
                Value::None => 0,
                Value::Word("KILO") => 3,
                Value::Word("HECTO") => 2,
                Value::Word("DECA") => 1,
                Value::Word("DECI") => -1,
                Value::Word("CENTI") => -2,
                Value::Word("MILLI") => -3,
                Value::Word("MICRO") => -6,
                Value::Word("NANO") => -9,
                _ => return Err(wrong()),
            };
            let name = match power {
                0 => "m",
                3 => "km",
                -1 => "dm",
                -2 => "cm",
                -3 => "mm",
                -6 => "um",
                _ => "SI unit",
            };
            return LengthUnit::new(name, Rational::from(10).pow(power + 3)).ok_or_else(wrong);
        }
        let values = unit.part("CONVERSION_BASED_UNIT").ok_or_else(wrong)?;
        let measure = self.instance(unit, values.get(1))?;
        let with_unit = measure
            .parts
            .iter()
            .find(|(name, _)| name.ends_with("MEASURE_WITH_UNIT"));
        let (_, measured) = with_unit.ok_or_else(wrong)?;
        let base = self.length(self.instance(measure, measured.get(1))?, depth + 1)?;
        let size = exact(measure, measured.first())? * base.millimetres().clone();
        let name = label(values.first())
            .unwrap_or("unit of the file")
            .to_lowercase();
        let known = LengthUnit::named(&name).filter(|known| *known.millimetres() == size);
        known
            .or_else(|| LengthUnit::new(&name, size))
            .ok_or_else(wrong)
    }

    /// The radians of a unit of angles.
    fn angle(&self, unit: &Instance<'t>, depth: usize) -> ReadResult<f64> {
        let wrong = || at(&unit.place(), "a unit of angles that is not read");
        if depth > 8 {
            return Err(at(&unit.place(), "a unit that is defined by itself"));
        }
        if let Some(values) = unit.part("SI_UNIT") {
            return match values.last() {
                Some(Value::Word("RADIAN")) => Ok(1.0),
                _ => Err(wrong()),
            };
        }
        let values = unit.part("CONVERSION_BASED_UNIT").ok_or_else(wrong)?;
        let measure = self.instance(unit, values.get(1))?;
        let with_unit = measure
            .parts
            .iter()
            .find(|(name, _)| name.ends_with("MEASURE_WITH_UNIT"));
        let (_, measured) = with_unit.ok_or_else(wrong)?;
        let base = self.angle(self.instance(measure, measured.get(1))?, depth + 1)?;
        let size = number(measure, measured.first())? * base;
        if size > 0.0 && size.is_finite() {
            return Ok(size);
        }
        Err(wrong())
    }

    /// What is placed below what.
    pub(super) fn placements(&self) -> ReadResult<Vec<Placed>> {
        let mut all = Vec::new();
        for relation in self.data.all() {
            let values = relation.part("REPRESENTATION_RELATIONSHIP").or(relation
                .part("SHAPE_REPRESENTATION_RELATIONSHIP")
                .filter(|v| v.len() >= 4));
            let Some(values) = values else {
                continue;
            };
            let (first, second) = (
                self.instance(relation, values.get(2))?,
                self.instance(relation, values.get(3))?,
            );
            let axes = match relation.part("REPRESENTATION_RELATIONSHIP_WITH_TRANSFORMATION") {
                None => None,
                Some(operator) => {
                    let operator = self.instance(relation, operator.last())?;
                    match operator.part("ITEM_DEFINED_TRANSFORMATION") {
                        Some(items) => Some([
                            self.axes(operator, items.get(2))?,
                            self.axes(operator, items.get(3))?,
                        ]),
                        None => return Err(at(&operator.place(), "a placement that is not read")),
                    }
                }
            };
            let (child, parent) = match axes {
                // Without a transformation the second is the shape of the first: it is seen from there.
                None => (second.id, first.id),
                Some(_) => (first.id, second.id),
            };
            all.push(Placed {
                child,
                parent,
                axes,
            });
        }
        Ok(all)
    }

    /// The items of a representation.
    pub(super) fn items(&self, representation: &Instance<'t>) -> ReadResult<Vec<u64>> {
        let values = self::representation(representation).unwrap_or_default();
        let items = list(representation, values.get(1))?;
        Ok(items
            .iter()
            .filter_map(|item| {
                if let Value::Reference(id) = item {
                    Some(*id)
                } else {
                    None
                }
            })
            .collect())
    }
}

/// The values of a representation of shapes: name, items, context. Curves in the parameters of surfaces are none.
pub(super) fn representation<'i, 't>(instance: &'i Instance<'t>) -> Option<&'i [Value<'t>]> {
    let found = instance.parts.iter().find(|(keyword, values)| {
        keyword.ends_with("REPRESENTATION")
            && *keyword != "DEFINITIONAL_REPRESENTATION"
            && matches!(values.as_slice(), [_, Value::List(_), Value::Reference(_)])
    });
    found.map(|(_, values)| values.as_slice())
}

/// The motion that brings one placement on another, each with millimetres of its unit, in millimetres.
pub(super) fn motion([from, to]: &[Axes; 2], units: [&Rational; 2]) -> AffineMap<Rational> {
    let rows = |axes: &Axes| [axes.x, axes.y, axes.z];
    let (first, second) = (rows(from), rows(to));
    // The sum over the three directions of second times first transposed.
    let entry = |i: usize, j: usize| (0..3).map(|k| second[k][i] * first[k][j]).sum::<f64>();
    let linear: [[Rational; 3]; 3] =
        std::array::from_fn(|i| std::array::from_fn(|j| torse_geometry::exact(entry(i, j))));
    let place = |axes: &Axes, unit: &Rational| -> [Rational; 3] {
        axes.origin.each_ref().map(|c| c.clone() * unit.clone())
    };
    let turn = AffineMap {
        linear,
        shift: std::array::from_fn(|_| Rational::default()),
    };
    let carried = turn.turn(&place(from, units[0]));
    let target = place(to, units[1]);
    AffineMap {
        shift: std::array::from_fn(|k| target[k].clone() - carried[k].clone()),
        ..turn
    }
}

/// Refuses what is placed too deep, or more often than a file may say.
pub(super) fn too_deep(from: &Instance<'_>, most: usize) -> ReadError {
    ReadError::TooMuch {
        place: from.place(),
        what: "parts inside each other: a circle of references?",
        most,
    }
}

/// How much a map stretches, for lengths that it does not act on.
pub(super) fn stretch(map: &AffineMap<Rational>) -> f64 {
    let row: [f64; 3] = map.linear[0].each_ref().map(Coordinate::approximate);
    torse_geometry::vector::norm(&row)
}
