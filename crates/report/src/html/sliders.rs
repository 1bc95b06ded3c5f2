//! Pictures with sliders as compact JSON for the page's script.

use crate::ReportError;
use serde_json::{Map, Number, Value, json};
use torse_plot::{Ambient, Colour, Interactive, Part, Shape, label_html};

/// Number of decimals of a coordinate relative to the largest one: finer than any screen.
const DIGITS: i32 = 4;

/// Writes the data of the picture, as JSON for a `script` element.
///
/// Nets are flat lists of two coordinates a point in a plane and three in space.
///
/// # Errors
///
/// [`ReportError::Label`] for a label that does not parse, which a checked picture does not have.
pub(super) fn data(picture: &Interactive) -> Result<String, ReportError> {
    let sliders = picture.sliders().iter().map(super::torse::slider);
    let sliders: Vec<Value> = sliders.collect::<Result<_, ReportError>>()?;
    let dimension = match picture.ambient() {
        Ambient::Plane => 2,
        Ambient::Space => 3,
    };
    let points = picture
        .parts()
        .iter()
        .flat_map(|part| part.nets.iter().flatten());
    let largest = points.flatten().fold(0.0_f64, |most, x| most.max(x.abs()));
    let decimals =
        (DIGITS - libm::log10(largest.max(f64::MIN_POSITIVE)).ceil() as i32).clamp(0, 17);
    let parts: Vec<Value> = (picture.parts().iter())
        .map(|own| part(own, dimension, decimals as usize))
        .collect::<Result<_, ReportError>>()?;
    let data = json!({
        "dimension": dimension,
        "view": picture.view(),
        "sliders": sliders,
        "monomials": picture.monomials(),
        "parts": parts,
    });
    // The only sign that could end the element.
    Ok(data.to_string().replace('<', "\\u003c"))
}

fn part(part: &Part, dimension: usize, decimals: usize) -> Result<Value, ReportError> {
    let (shape, columns) = match part.shape {
        Shape::Surface { columns, .. } => ("surface", Some(columns)),
        Shape::Net { columns, .. } => ("net", Some(columns)),
        Shape::Curve => ("curve", None),
        Shape::Polygon => ("polygon", None),
        Shape::Points => ("points", None),
    };
    let net = |points: &Vec<[f64; 3]>| -> Vec<Value> {
        let numbers = points.iter().flat_map(|point| point.iter().take(dimension));
        numbers.map(|number| rounded(*number, decimals)).collect()
    };
    let Colour { r, g, b } = part.colour;
    let mut data = Map::new();
    data.insert("shape".to_owned(), shape.into());
    data.insert("label".to_owned(), label_html(&part.label)?.into());
    data.insert("colour".to_owned(), json!([r, g, b]));
    if let Some(columns) = columns {
        data.insert("columns".to_owned(), columns.into());
    }
    let nets: Vec<Vec<Value>> = part.nets.iter().map(net).collect();
    data.insert("nets".to_owned(), json!(nets));
    Ok(Value::Object(data))
}

/// Writes the number with this many decimals; whole numbers without a point.
fn rounded(number: f64, decimals: usize) -> Value {
    let text = format!("{number:.decimals$}");
    let value: f64 = text.parse().unwrap_or(0.0);
    match value.fract() == 0.0 && value.abs() < 1e15 {
        true => (value as i64).into(),
        false => Number::from_f64(value).map_or(Value::Null, Value::Number),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use torse_plot::{Slider, palette};

    fn segment(end: f64) -> Interactive {
        let slider = Slider {
            name: "mu".to_owned(),
            label: "$\\mu < 2$".to_owned(),
            least: -1.0,
            greatest: 1.0,
            start: 0.0,
            step: 0.5,
        };
        let part = Part {
            label: "</script>".to_owned(),
            colour: palette(0),
            shape: Shape::Curve,
            nets: vec![vec![[0.0; 3], [end, -1.0 / 3.0, 0.0]]],
        };
        Interactive::new(vec![slider], vec![vec![0]], Ambient::Plane, vec![part]).unwrap()
    }

    #[test]
    fn numbers_are_rounded_relative_to_the_largest_and_the_element_cannot_be_left() {
        let text = data(&segment(20.0)).unwrap();
        assert!(text.contains("\"nets\":[[0,0,20,-0.33]]"), "{text}");
        assert!(text.contains("\"colour\":[0,114,178]"), "{text}");
        assert!(!text.contains('<'), "{text}");
        let value: Value = serde_json::from_str(&text).unwrap();
        assert_eq!(value["sliders"][0]["label"], "<i>μ</i> &lt; 2");
        assert_eq!(value["parts"][0]["label"], "&lt;/script&gt;");
        for end in [1e300, 1e-300, 0.0] {
            let value: Value = serde_json::from_str(&data(&segment(end)).unwrap()).unwrap();
            assert_eq!(value["parts"][0]["nets"][0][0], 0);
        }
    }
}
