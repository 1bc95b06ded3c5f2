//! Labels for pages of a browser.

use crate::error::FigureError;
use crate::ink::font::Style;
use crate::ink::label::{self, Node};

/// Less room than this, in em, is left to the browser.
const VISIBLE_ROOM: f64 = 0.1;

/// The room of a blank; less is a thin space.
const BLANK: f64 = 0.25;

/// A [label](crate#labels) as HTML: letters of formulas in `<i>`, vectors in `<b>`, scripts in `<sub>` and
/// `<sup>`; everything else is escaped text.
///
/// ```
/// assert_eq!(torse_plot::label_html("$\\mu_1 < 2$")?, "<i>μ</i><sub>1</sub> &lt; 2");
/// # Ok::<(), torse_plot::FigureError>(())
/// ```
///
/// # Errors
/// [`FigureError::Label`] for a label that does not parse.
pub fn label_html(label: &str) -> Result<String, FigureError> {
    let mut html = String::new();
    write(&label::parse(label)?, &mut html);
    Ok(html)
}

fn write(nodes: &[Node], html: &mut String) {
    for node in nodes {
        match node {
            Node::Char(character, style) => {
                let element = match style {
                    Style::Italic => Some("i"),
                    Style::Bold => Some("b"),
                    Style::Upright | Style::Symbol => None,
                };
                within(element, html, |html| escape(*character, html));
            }
            Node::Space(room) if *room < VISIBLE_ROOM => {}
            Node::Space(room) if *room < BLANK => html.push('\u{2009}'),
            Node::Space(_) => html.push(' '),
            Node::Scripts { sub, sup } => {
                for (element, script) in [("sub", sub), ("sup", sup)] {
                    if !script.is_empty() {
                        within(Some(element), html, |html| write(script, html));
                    }
                }
            }
        }
    }
}

fn within(element: Option<&str>, html: &mut String, content: impl FnOnce(&mut String)) {
    let Some(element) = element else {
        return content(html);
    };
    html.push_str(&format!("<{element}>"));
    content(html);
    html.push_str(&format!("</{element}>"));
}

fn escape(character: char, html: &mut String) {
    match character {
        '&' => html.push_str("&amp;"),
        '<' => html.push_str("&lt;"),
        '>' => html.push_str("&gt;"),
        '"' => html.push_str("&quot;"),
        '\'' => html.push_str("&#39;"),
        _ => html.push(character),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn formulas_become_elements_and_text_is_escaped() {
        let html = |label| label_html(label).unwrap();
        assert_eq!(html("a <b> & \\$"), "a &lt;b&gt; &amp; $");
        assert_eq!(
            html("$\\mathbf{p}_{i+1}^2$"),
            "<b>p</b><sub><i>i</i>+1</sub><sup>2</sup>"
        );
        assert_eq!(html("$\\sin x$"), "sin\u{2009}<i>x</i>");
        assert!(label_html("$x_").is_err());
    }
}
