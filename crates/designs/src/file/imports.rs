//! Curves from files of other programs: `import = "FILE#name"`.

use super::reader::{Entries, Named, Reader, Value, accepted};
use super::splines::InterpolationConditions;
use crate::DesignUnit;
use std::collections::BTreeMap;
use torse_exchange::{CurveShape, Imported, LengthUnit, UnitSource};
use torse_geometry::Coordinate;
use torse_geometry::prelude::{PiecewiseRail, Point};
use torse_numbers::rational::Rational;

/// What reads a file that a design names, by the path that stands in the design; an error is told in words.
pub type Files<'f> = &'f mut dyn FnMut(&str) -> Result<Vec<u8>, String>;

/// The files that were read, each once.
pub struct Imports<'f> {
    files: Files<'f>,
    read: BTreeMap<(String, String), Result<Imported, String>>,
    /// What is worth knowing of them.
    pub notes: Vec<String>,
}

impl<'f> Imports<'f> {
    pub fn new(files: Files<'f>) -> Self {
        Self {
            files,
            read: BTreeMap::new(),
            notes: Vec::new(),
        }
    }

    /// Returns the curve that `import = "FILE#name"` names, with the entries `unit`, and `ends` and `spacing` where the
    /// file has points.
    pub fn curve(
        &mut self,
        reader: &mut Reader,
        entries: &mut Entries<'_>,
        value: Value<'_>,
        points: &Named<Point>,
    ) -> Option<PiecewiseRail> {
        let place = value.span();
        let (text, _) = reader.text(value, "the name of a file and of a curve in it")?;
        let (file, name) = match text.split_once('#') {
            Some((file, name)) => (file, Some(name)),
            None => (text.as_str(), None),
        };
        let shaped = entries.has("ends") || entries.has("spacing");
        let how = InterpolationConditions::read(reader, entries, points);
        let unit = match entries.take("unit") {
            None => None,
            Some(value) => Some(reader.word(value, "unit", &DesignUnit::ALL)?),
        };
        let how = how?;
        let found = self.file(file, unit, &reader.unit.clone());
        let imported = match found {
            Ok(imported) => imported,
            Err(reason) => {
                reader.complain(&place, format!("{file}: {reason}"), "");
                return None;
            }
        };
        let curve = match (name, imported.curves.as_slice()) {
            (Some(name), _) => imported.curve(name),
            (None, [only]) => Some(only),
            (None, _) => None,
        };
        let Some(curve) = curve else {
            let names: Vec<&str> = imported.curve_names().take(20).collect();
            let more = if imported.curves.len() > 20 {
                ", .."
            } else {
                ""
            };
            let help = match names.as_slice() {
                [] => format!("{file} has no curves"),
                names => format!("its curves are `{}`{more}", names.join("`, `")),
            };
            let message = match name {
                Some(name) => format!("{file} has no curve `{name}`"),
                None => format!("{file} has {} curves: which one?", imported.curves.len()),
            };
            reader.complain(
                &place,
                message,
                &format!("`import = \"FILE#name\"`; {help}"),
            );
            return None;
        };
        match &curve.shape {
            CurveShape::Through(through) => {
                let through: Vec<Point> = through
                    .iter()
                    .map(|p| p.each_ref().map(Coordinate::approximate))
                    .collect();
                let ring = !shaped && through.len() > 3 && through.first() == through.last();
                if ring {
                    return accepted(reader, &place, curve.shape.rail());
                }
                how.interpolated(reader, &place, &through)
            }
            _ if shaped => {
                let message = format!(
                    "`{}` is a {}, which has its own ends and spacing",
                    curve.name,
                    curve.shape.words()
                );
                reader.complain(&place, message, "");
                None
            }
            shape => accepted(reader, &place, shape.rail()),
        }
    }

    /// Returns a file; its unit is the one that it states, that of the entry, or that of the design.
    fn file(
        &mut self,
        path: &str,
        unit: Option<DesignUnit>,
        design: &Rational,
    ) -> Result<&Imported, String> {
        let word = unit.map_or("", DesignUnit::name);
        let key = (path.to_owned(), word.to_owned());
        if !self.read.contains_key(&key) {
            let read = self.read_file(path, unit, design);
            if let Ok(imported) = &read {
                let passed = imported.passed_over.iter();
                let passed: Vec<String> = passed
                    .map(|(words, count)| format!("{count} {words}"))
                    .collect();
                let passed = match passed.as_slice() {
                    [] => String::new(),
                    words => format!("; passed over: {}", words.join(", ")),
                };
                self.notes.push(format!(
                    "{path}: {}, lengths in {}{passed}",
                    imported.kind,
                    imported.unit.words()
                ));
            }
            self.read.insert(key.clone(), read);
        }
        match self.read.get(&key) {
            Some(Ok(imported)) => Ok(imported),
            Some(Err(reason)) => Err(reason.clone()),
            None => Err("it was not read".to_owned()),
        }
    }

    fn read_file(
        &mut self,
        path: &str,
        unit: Option<DesignUnit>,
        design: &Rational,
    ) -> Result<Imported, String> {
        let bytes = (self.files)(path)?;
        let given = unit.and_then(|unit| LengthUnit::new(unit.name(), unit.millimetres()));
        let read = |given: Option<&LengthUnit>| {
            torse_exchange::read(path, &bytes, given).map_err(|e| e.to_string())
        };
        let imported = read(given.as_ref())?;
        if imported.unit == UnitSource::Assumed {
            let name = DesignUnit::ALL
                .iter()
                .find(|(_, unit)| unit.millimetres() == *design);
            let given = LengthUnit::new(name.map_or("mm", |(name, _)| name), design.clone());
            return read(given.as_ref());
        }
        Ok(imported)
    }
}
