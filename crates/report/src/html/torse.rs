//! Developables that follow sliders as compact JSON for the page's script.
//!
//! A monomial is one row: its coefficient, then the exponents of the running variable and of the sliders. Coefficients
//! keep all their digits, since the page measures and unrolls with them.

use crate::ReportError;
use serde_json::{Value, json};
use torse_plot::{Colour, Monomial, Quotient, Rulings, Slider, Torse, TorsePiece, label_html};

/// The scripts that evaluate, unroll and draw, and those for pictures of nets, which share the stage: one file for each
/// concept, in the order of their dependencies.
pub(super) const SCRIPT: &str = concat!(
    "(() => {\n\"use strict\";\n",
    include_str!("../../assets/torse/series.js"),
    include_str!("../../assets/torse/formula.js"),
    include_str!("../../assets/torse/ruling.js"),
    include_str!("../../assets/torse/develop.js"),
    include_str!("../../assets/torse/pens.js"),
    include_str!("../../assets/torse/stage.js"),
    include_str!("../../assets/torse/scene.js"),
    include_str!("../../assets/torse/save.js"),
    include_str!("../../assets/torse/torse.js"),
    include_str!("../../assets/moving.js"),
    "})();\n",
);

/// Writes the data of the developable, as JSON for a `script` element.
///
/// # Errors
///
/// [`ReportError::Label`] for a label that does not parse, which a checked developable does not have.
pub(super) fn data(torse: &Torse) -> Result<String, ReportError> {
    let sliders = torse.sliders().iter().map(slider);
    let pieces = torse.pieces().iter().map(piece);
    let data = json!({
        "sliders": sliders.collect::<Result<Vec<_>, _>>()?,
        "view": torse.view(),
        "pieces": pieces.collect::<Result<Vec<_>, _>>()?,
    });
    // The only sign that could end the element.
    Ok(data.to_string().replace('<', "\\u003c"))
}

/// A slider of any picture.
pub(super) fn slider(slider: &Slider) -> Result<Value, ReportError> {
    Ok(json!({
        "name": slider.name,
        "label": label_html(&slider.label)?,
        "least": slider.least,
        "greatest": slider.greatest,
        "start": slider.start,
        "step": slider.step,
    }))
}

fn piece(piece: &TorsePiece) -> Result<Value, ReportError> {
    let kind = match piece.rulings {
        Rulings::Envelope => "envelope",
        Rulings::Tangent => "tangent",
        Rulings::Ruled => "ruled",
    };
    let Colour { r, g, b } = piece.colour;
    let curve = |curve: &Vec<Quotient>| curve.iter().map(quotient).collect::<Vec<_>>();
    Ok(json!({
        "kind": kind,
        "curves": piece.curves.iter().map(curve).collect::<Vec<_>>(),
        "over": piece.over,
        "along": piece.along,
        "limit": piece.limit,
        "label": label_html(&piece.label)?,
        "colour": [r, g, b],
    }))
}

fn quotient(quotient: &Quotient) -> Value {
    let numerator = rows(&quotient.numerator);
    let below = quotient.denominator.iter();
    let denominator: Vec<Value> = below
        .map(|(sum, power)| json!([rows(sum), power]))
        .collect();
    match denominator.is_empty() {
        true => json!({ "n": numerator }),
        false => json!({ "n": numerator, "d": denominator }),
    }
}

fn rows(sum: &[Monomial]) -> Vec<Value> {
    let row = |monomial: &Monomial| {
        let exponents = monomial.atoms.iter().chain(&monomial.sliders);
        let mut row = vec![json!(monomial.coefficient)];
        row.extend(exponents.map(|exponent| json!(exponent)));
        Value::Array(row)
    };
    sum.iter().map(row).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use torse_plot::palette;

    #[test]
    fn a_monomial_is_one_row_with_all_digits_and_the_element_cannot_be_left() {
        let monomial = Monomial {
            coefficient: 0.1 + 0.2,
            atoms: [0, 2, 1, 0, 0],
            sliders: vec![3],
        };
        let quotient = Quotient {
            numerator: vec![monomial.clone()],
            denominator: vec![(vec![monomial], 2)],
        };
        let piece = TorsePiece {
            rulings: Rulings::Ruled,
            curves: vec![vec![quotient; 3]; 2],
            over: [0.0, 1.0],
            along: [0.0, 0.5],
            limit: None,
            label: "</script>".to_owned(),
            colour: palette(0),
        };
        let slider = Slider {
            name: "k".to_owned(),
            label: "$k < 2$".to_owned(),
            least: 0.0,
            greatest: 1.0,
            start: 0.5,
            step: 0.1,
        };
        let text = data(&Torse::new(vec![slider], [1.0, 2.0], vec![piece]).unwrap()).unwrap();
        assert!(!text.contains('<'), "{text}");
        let row = "[0.30000000000000004,0,2,1,0,0,3]";
        assert!(
            text.contains(&format!("{{\"d\":[[[{row}],2]],\"n\":[{row}]}}")),
            "{text}"
        );
        let value: Value = serde_json::from_str(&text).unwrap();
        assert_eq!(value["pieces"][0]["label"], "&lt;/script&gt;");
        assert_eq!(value["sliders"][0]["label"], "<i>k</i> &lt; 2");
    }
}
