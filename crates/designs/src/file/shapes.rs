//! Shape parameters: two numbers, or the word for none.

use super::reader::{Dimension, Entries, Reader, Value, accepted};
use toml::de::DeValue;
use torse_geometry::basis::Shape;

/// The shape parameters, if any; `None` when they are wrong.
#[allow(clippy::option_option, reason = "wrong is not missing")]
pub fn shape(reader: &mut Reader, entries: &mut Entries<'_>) -> Option<Option<Shape<f64>>> {
    match entries.take("shape") {
        Some(value) => shape_of(reader, value).map(Some),
        None => Some(None),
    }
}

/// Shape parameters, or the word for none.
pub fn shape_of(reader: &mut Reader, value: Value<'_>) -> Option<Shape<f64>> {
    if let DeValue::String(word) = value.get_ref()
        && word == "bernstein"
    {
        return Some(Shape::Bernstein);
    }
    let span = value.span();
    let [mu, nu] = reader.numbers(value, [Dimension::None; 2])?;
    accepted(reader, &span, Shape::gbt(mu, nu))
}
