//! The embedded typefaces (Libertinus Serif and New Computer Modern Math, both under the SIL Open Font Licence).

use std::sync::OnceLock;

use tiny_skia::{Path, PathBuilder};
use ttf_parser::{Face, GlyphId, OutlineBuilder, name_id};

use crate::error::FigureError;

/// One of the faces a label can use.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) enum Style {
    Upright,
    Italic,
    Bold,
    /// The fallback for signs the text faces lack.
    Symbol,
}

const STYLES: [(Style, &str); 4] = [
    (Style::Upright, "LibertinusSerif-Regular"),
    (Style::Italic, "LibertinusSerif-Italic"),
    (Style::Bold, "LibertinusSerif-Bold"),
    (Style::Symbol, "NewCMMath-Book"),
];

/// The four faces, parsed once.
pub(crate) struct Fonts([Face<'static>; 4]);

/// A glyph of a face and how far it moves the pen, in em.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct GlyphRef {
    pub style: Style,
    pub id: u16,
    pub advance: f64,
}

impl Fonts {
    /// The faces; the same error every time if one is missing.
    pub(crate) fn get() -> Result<&'static Fonts, FigureError> {
        static FONTS: OnceLock<Result<Fonts, FigureError>> = OnceLock::new();
        FONTS
            .get_or_init(Fonts::load)
            .as_ref()
            .map_err(Clone::clone)
    }

    fn load() -> Result<Fonts, FigureError> {
        let find = |wanted: &'static str| {
            typst_assets::fonts()
                .filter_map(|data| Face::parse(data, 0).ok())
                .find(|face| postscript_name(face).as_deref() == Some(wanted))
                .ok_or(FigureError::Font(wanted))
        };
        let [a, b, c, d] = STYLES.map(|(_, name)| find(name));
        Ok(Fonts([a?, b?, c?, d?]))
    }

    fn face(&self, style: Style) -> &Face<'static> {
        let [upright, italic, bold, symbol] = &self.0;
        match style {
            Style::Upright => upright,
            Style::Italic => italic,
            Style::Bold => bold,
            Style::Symbol => symbol,
        }
    }

    /// The glyph of `ch`, from the fallback face if the wanted one has none.
    pub(crate) fn glyph(&self, ch: char, style: Style) -> Option<GlyphRef> {
        [style, Style::Symbol].into_iter().find_map(|style| {
            let face = self.face(style);
            let id = face.glyph_index(ch)?;
            let advance = face.glyph_hor_advance(id)?;
            Some(GlyphRef {
                style,
                id: id.0,
                advance: f64::from(advance) / f64::from(face.units_per_em()),
            })
        })
    }

    /// Outline with the baseline at y = 0, y downwards, one em = 1000 units; `None` for blanks.
    pub(crate) fn outline(&self, style: Style, id: u16) -> Option<Path> {
        let face = self.face(style);
        let scale = 1000.0 / f32::from(face.units_per_em());
        let mut pen = Pen {
            path: PathBuilder::new(),
            scale,
        };
        face.outline_glyph(GlyphId(id), &mut pen)?;
        pen.path.finish()
    }
}

fn postscript_name(face: &Face) -> Option<String> {
    face.names()
        .into_iter()
        .find(|name| name.name_id == name_id::POST_SCRIPT_NAME && name.is_unicode())
        .and_then(|name| name.to_string())
}

struct Pen {
    path: PathBuilder,
    scale: f32,
}

impl OutlineBuilder for Pen {
    fn move_to(&mut self, x: f32, y: f32) {
        self.path.move_to(x * self.scale, -y * self.scale);
    }

    fn line_to(&mut self, x: f32, y: f32) {
        self.path.line_to(x * self.scale, -y * self.scale);
    }

    fn quad_to(&mut self, x1: f32, y1: f32, x: f32, y: f32) {
        let s = self.scale;
        self.path.quad_to(x1 * s, -y1 * s, x * s, -y * s);
    }

    fn curve_to(&mut self, x1: f32, y1: f32, x2: f32, y2: f32, x: f32, y: f32) {
        let s = self.scale;
        self.path
            .cubic_to(x1 * s, -y1 * s, x2 * s, -y2 * s, x * s, -y * s);
    }

    fn close(&mut self) {
        self.path.close();
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn all_four_faces_are_embedded_and_carry_letters() {
        let fonts = Fonts::get().unwrap();
        for (style, name) in STYLES {
            let glyph = fonts.glyph('x', style).unwrap();
            assert_eq!(glyph.style, style, "{name} has its own x");
            assert!(fonts.outline(style, glyph.id).is_some());
        }
    }

    #[test]
    fn an_italic_letter_is_not_the_upright_one() {
        let fonts = Fonts::get().unwrap();
        let outline = |style| {
            let glyph = fonts.glyph('f', style).unwrap();
            fonts.outline(style, glyph.id).unwrap()
        };
        assert_ne!(outline(Style::Upright), outline(Style::Italic));
    }
}
