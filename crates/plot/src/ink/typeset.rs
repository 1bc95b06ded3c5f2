//! From a label to placed glyphs.

use crate::error::{FigureError, LabelProblem};
use crate::ink::font::{Fonts, Style};
use crate::ink::label::{self, Node};

/// A glyph at its place relative to the start of the baseline, y downwards, sizes in pixels per em.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Placed {
    pub style: Style,
    pub id: u16,
    pub x: f64,
    pub y: f64,
    pub size: f64,
}

/// A line of type. All lines of one size share ascent and descent, so that rows align.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct TypeLine {
    pub glyphs: Vec<Placed>,
    pub width: f64,
    pub size: f64,
}

impl TypeLine {
    /// Height of a capital above the baseline.
    pub(crate) fn cap_height(&self) -> f64 {
        CAPITALS * self.size
    }

    /// The size of type whose capitals are so high.
    pub(crate) fn size_of_capitals(height: f64) -> f64 {
        height / CAPITALS
    }

    /// Height of the row the line needs, baseline to baseline.
    pub(crate) fn row(&self) -> f64 {
        1.3 * self.size
    }
}

/// Scripts are this much smaller than their base.
const SCRIPT_SIZE: f64 = 0.72;
/// Drop of a subscript and rise of a superscript, in em of the base.
const SUB_DROP: f64 = 0.17;
const SUP_RISE: f64 = 0.36;

/// Height of capitals in em.
const CAPITALS: f64 = 0.645;

/// Typeset `label` at `size` pixels per em.
pub(crate) fn typeset(text: &str, size: f64) -> Result<TypeLine, FigureError> {
    let mut setter = Setter {
        fonts: Fonts::get()?,
        label: text,
        glyphs: Vec::new(),
    };
    let nodes = label::parse(text)?;
    let width = setter.row(&nodes, 0.0, 0.0, size)?;
    Ok(TypeLine {
        glyphs: setter.glyphs,
        width,
        size,
    })
}

struct Setter<'a> {
    fonts: &'static Fonts,
    label: &'a str,
    glyphs: Vec<Placed>,
}

impl Setter<'_> {
    /// Set `nodes` from pen position `x`; returns the pen position after them.
    fn row(&mut self, nodes: &[Node], mut x: f64, y: f64, size: f64) -> Result<f64, FigureError> {
        for node in nodes {
            x = match node {
                Node::Space(em) => x + em * size,
                Node::Char(ch, style) => self.glyph(*ch, *style, x, y, size)?,
                Node::Scripts { sub, sup } => {
                    let small = SCRIPT_SIZE * size;
                    // Superscripts clear the lean of an italic base.
                    let end_sup = self.row(sup, x + 0.05 * size, y - SUP_RISE * size, small)?;
                    let end_sub = self.row(sub, x, y + SUB_DROP * size, small)?;
                    let end_sup = if sup.is_empty() { x } else { end_sup };
                    end_sub.max(end_sup) + 0.04 * size
                }
            };
        }
        Ok(x)
    }

    fn glyph(
        &mut self,
        ch: char,
        style: Style,
        x: f64,
        y: f64,
        size: f64,
    ) -> Result<f64, FigureError> {
        let glyph = self
            .fonts
            .glyph(ch, style)
            .ok_or_else(|| FigureError::Label {
                label: self.label.to_owned(),
                at: self.label.find(ch).unwrap_or(0),
                problem: LabelProblem::Glyph(ch),
            })?;
        self.glyphs.push(Placed {
            style: glyph.style,
            id: glyph.id,
            x,
            y,
            size,
        });
        Ok(x + glyph.advance * size)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use torse_typography::signs::SIGNS;

    #[test]
    fn every_named_sign_has_a_glyph() {
        let letters = torse_syntax::greek::LETTERS.iter();
        let names = letters.flat_map(|letter| [letter.name, letter.latex]);
        for name in SIGNS
            .iter()
            .map(|(name, _)| *name)
            .chain(names)
            .chain(["sqrt"])
        {
            let line = typeset(&format!("$\\{name}$"), 10.0);
            assert_eq!(
                line.unwrap_or_else(|e| panic!("{name}: {e}")).glyphs.len(),
                1
            );
        }
    }

    #[test]
    fn widths_scale_with_the_size_and_grow_with_the_text() {
        let width = |s: &str, size| typeset(s, size).unwrap().width;
        assert!((width("$f_{0,4}(t)$", 20.0) - 2.0 * width("$f_{0,4}(t)$", 10.0)).abs() < 1e-9);
        assert!(width("0.25", 10.0) > width("0.2", 10.0));
    }

    #[test]
    fn a_subscript_is_lower_and_smaller_and_a_superscript_higher() {
        let line = typeset("$x_i^2$", 10.0).unwrap();
        let [base, sup, sub] = line.glyphs[..] else {
            panic!("{line:?}")
        };
        assert!(sub.y > base.y && sup.y < base.y);
        assert!(sub.size < base.size && sub.x >= base.x);
    }

    #[test]
    fn a_sign_no_font_has_is_refused_by_name() {
        let error = typeset("a\u{13080}", 10.0).unwrap_err();
        assert!(matches!(
            error,
            FigureError::Label {
                at: 1,
                problem: LabelProblem::Glyph('\u{13080}'),
                ..
            }
        ));
    }
}
