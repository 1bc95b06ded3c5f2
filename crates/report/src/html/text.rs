//! Words and formulas as text of the page, never as markup.

use crate::glossary::Term;
use crate::model::{FormulaView, Report};
use std::fmt::{self, Write};
use torse_typography::{Prose, Span};

/// Writes a verdict as a coloured word; its mark is in the style, and the script shows its meaning.
pub(super) fn badge(verdict: Term) -> String {
    format!(
        "<span class=\"badge v-{}\" data-word=\"{}\">{}</span>",
        verdict.key, verdict.key, verdict.label
    )
}

/// Writes a formula on lines of its own, or as code if it cannot be parsed.
pub(super) fn formula(out: &mut String, view: &FormulaView) -> fmt::Result {
    match &view.math {
        Some(math) => {
            write!(
                out,
                "<div class=\"math\" tabindex=\"0\">{}</div>",
                math.mathml.concat()
            )
        }
        None => write!(out, "<code class=\"plain\">{}</code>", Text(&view.text)),
    }
}

/// Writes a sentence with its formulas.
pub(super) struct Sentence<'a>(pub(super) &'a Prose);

impl fmt::Display for Sentence<'_> {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        for span in self.0 {
            match span {
                Span::Words(text) => Text(text).fmt(out)?,
                Span::Strong(text) => write!(out, "<strong>{}</strong>", Text(text))?,
                Span::Code(text) => Code(text).fmt(out)?,
                Span::Math(math) => out.write_str(&math.mathml.concat())?,
            }
        }
        Ok(())
    }
}

/// Joins sentences with semicolons.
pub(super) struct Listed<'a>(pub(super) &'a [Prose]);

impl fmt::Display for Listed<'_> {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        for (number, sentence) in self.0.iter().enumerate() {
            if number > 0 {
                out.write_str("; ")?;
            }
            Sentence(sentence).fmt(out)?;
        }
        Ok(())
    }
}

/// Writes code as it is typed.
pub(super) struct Code<'a>(pub(super) &'a str);

impl fmt::Display for Code<'_> {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(out, "<code>{}</code>", Text(self.0))
    }
}

/// Writes the identifier of a paper, as a link.
pub(super) struct Doi<'a>(pub(super) &'a str);

impl fmt::Display for Doi<'_> {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        let doi = Text(self.0);
        write!(out, "<a href=\"https://doi.org/{doi}\">doi:{doi}</a>")
    }
}

/// Writes a point and the identifier, if the paper has one.
pub(super) fn doi(report: &Report) -> String {
    let source = report.source.as_ref();
    let doi = source.and_then(|source| source.doi.as_ref());
    doi.map_or(String::new(), |doi| format!(" · {}", Doi(doi)))
}

/// Escapes a string for an element or a quoted attribute.
pub(super) struct Text<'a>(pub(super) &'a str);

impl fmt::Display for Text<'_> {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        for character in self.0.chars() {
            match character {
                '&' => out.write_str("&amp;")?,
                '<' => out.write_str("&lt;")?,
                '>' => out.write_str("&gt;")?,
                '"' => out.write_str("&quot;")?,
                '\'' => out.write_str("&#39;")?,
                _ => out.write_char(character)?,
            }
        }
        Ok(())
    }
}
