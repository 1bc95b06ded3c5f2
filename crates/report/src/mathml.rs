//! Formulas as MathML, which every browser shows without a script or a font from elsewhere.

use crate::world::refused;
use crate::{ReportError, formula};
use typst_html::{HtmlDocument, HtmlOptions};

/// Formulas as MathML with the rules that the page needs to show them.
pub(crate) struct MathMl {
    /// For each formula its `<math>` element, or none where it cannot be set.
    pub(crate) formulas: Vec<Option<String>>,
    /// The style rules that the elements rely on.
    pub(crate) style: String,
}

/// Sets all formulas in one document and cuts the `<math>` elements out of it.
///
/// # Errors
///
/// [`ReportError::Formulas`] when the number of elements is not the number of formulas.
pub(crate) fn set(formulas: &[String]) -> Result<MathMl, ReportError> {
    const NAME: &str = "the formulas as MathML";
    let usable = formula::usable::<HtmlDocument>(formulas)?;
    let kept: Vec<String> = formulas
        .iter()
        .zip(&usable)
        .filter(|(_, usable)| **usable)
        .map(|(formula, _)| formula.clone())
        .collect();
    let document: HtmlDocument = formula::probe(&kept)?.compile(NAME)?;
    let page = typst_html::html(&document, &HtmlOptions::default())
        .map_err(|diagnostics| refused(NAME, &diagnostics))?;
    let elements = between(&page, "<math", "</math>");
    if elements.len() != kept.len() {
        return Err(ReportError::Formulas {
            given: kept.len(),
            written: elements.len(),
        });
    }
    let mut elements = elements.into_iter();
    Ok(MathMl {
        formulas: usable
            .iter()
            .map(|usable| if *usable { elements.next() } else { None })
            .collect(),
        style: between(&page, "<style>", "</style>")
            .iter()
            .map(|rules| {
                rules
                    .trim_start_matches("<style>")
                    .trim_end_matches("</style>")
            })
            .collect(),
    })
}

/// All stretches of `page` from `start` to the next `end`, both included.
fn between(page: &str, start: &str, end: &str) -> Vec<String> {
    let mut found = Vec::new();
    let mut rest = page;
    while let Some((_, after)) = rest.split_once(start) {
        let Some((inside, next)) = after.split_once(end) else {
            break;
        };
        found.push(format!("{start}{inside}{end}"));
        rest = next;
    }
    found
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn formulas_become_mathml_and_those_that_cannot_be_set_become_none() {
        let formulas = ["frac(1, 2)", "no_such_name", "\"<math>\" < x"].map(str::to_owned);
        let set = set(&formulas).unwrap();
        assert!(set.formulas[0].as_ref().unwrap().contains("<mfrac>"));
        assert_eq!(set.formulas[1], None);
        assert!(set.formulas[2].as_ref().unwrap().contains("&lt;"));
    }

    #[test]
    fn no_formulas_give_no_elements() {
        assert!(set(&[]).unwrap().formulas.is_empty());
    }
}
