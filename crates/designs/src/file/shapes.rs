//! Shape parameters: two numbers, or the word for none.

use super::reader::{Entries, NumberKind, Reader, Value, accepted};
use toml::de::DeValue;
use torse_geometry::basis::BasisShape;

/// Returns the shape parameters, if any; `None` when they are wrong.
#[allow(clippy::option_option, reason = "wrong is not missing")]
pub fn shape(reader: &mut Reader, entries: &mut Entries<'_>) -> Option<Option<BasisShape<f64>>> {
    match entries.take("shape") {
        Some(value) => shape_of(reader, value).map(Some),
        None => Some(None),
    }
}

/// Shape parameters, or the word for none.
pub fn shape_of(reader: &mut Reader, value: Value<'_>) -> Option<BasisShape<f64>> {
    if let DeValue::String(word) = value.get_ref()
        && word == "bernstein"
    {
        return Some(BasisShape::Bernstein);
    }
    let span = value.span();
    let [mu, nu] = reader.numbers(value, [NumberKind::None; 2])?;
    accepted(reader, &span, BasisShape::gbt(mu, nu))
}
