//! Colours, line styles and the palette.
//!
//! The palette is that of Okabe and Ito ("Color Universal Design", 2008) without its yellow, which vanishes on
//! white paper: it stays distinguishable under the common colour deficiencies. In grey print colour is gone
//! altogether, so [`Line::nth`] pairs each colour with its own [`Dash`].
//!
//! Light adds linearly, sRGB values do not: colours are mixed and averaged in the linear intensities of IEC 61966-2-1
//! and converted to sRGB last.

/// An opaque sRGB colour.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Colour {
    /// Red, 0 to 255.
    pub r: u8,
    /// Green, 0 to 255.
    pub g: u8,
    /// Blue, 0 to 255.
    pub b: u8,
}

impl Colour {
    /// Text, axes and control polygons.
    pub const INK: Colour = Colour::rgb(0x1c, 0x1c, 0x1e);
    /// Secondary lines.
    pub const GREY: Colour = Colour::rgb(0x7a, 0x7d, 0x82);
    /// The page.
    pub const PAPER: Colour = Colour::rgb(0xff, 0xff, 0xff);

    /// A colour from its sRGB bytes.
    #[must_use]
    pub const fn rgb(r: u8, g: u8, b: u8) -> Self {
        Colour { r, g, b }
    }

    /// Linear intensities, each in 0..=1.
    #[must_use]
    pub fn linear(self) -> [f32; 3] {
        [self.r, self.g, self.b].map(|byte| {
            let s = f32::from(byte) / 255.0;
            if s <= 0.040_45 {
                s / 12.92
            } else {
                libm::powf((s + 0.055) / 1.055, 2.4)
            }
        })
    }

    /// The nearest colour to linear intensities; they are clamped to 0..=1.
    ///
    /// ```
    /// use torse_plot::Colour;
    /// let teal = Colour::rgb(0, 158, 115);
    /// assert_eq!(Colour::from_linear(teal.linear()), teal);
    /// ```
    #[must_use]
    pub fn from_linear(intensity: [f32; 3]) -> Self {
        let [r, g, b] = intensity.map(|x| {
            let x = x.clamp(0.0, 1.0);
            let s = if x <= 0.003_130_8 {
                12.92 * x
            } else {
                1.055 * libm::powf(x, 1.0 / 2.4) - 0.055
            };
            (s * 255.0).round() as u8
        });
        Colour { r, g, b }
    }

    /// Part `t` in 0..=1 of `other` and the rest of `self`, mixed as light.
    #[must_use]
    pub fn mix(self, other: Colour, t: f32) -> Self {
        let (a, b) = (self.linear(), other.linear());
        Colour::from_linear([0, 1, 2].map(|k| a[k] + (b[k] - a[k]) * t))
    }

    /// Relative luminance in 0..=1: what is left of the colour in grey print.
    #[must_use]
    pub fn luminance(self) -> f32 {
        let [r, g, b] = self.linear();
        0.2126 * r + 0.7152 * g + 0.0722 * b
    }
}

/// The categorical palette: blue, vermilion, green, purple, orange, sky.
pub const PALETTE: [Colour; 6] = [
    Colour::rgb(0x00, 0x72, 0xb2),
    Colour::rgb(0xd5, 0x5e, 0x00),
    Colour::rgb(0x00, 0x9e, 0x73),
    Colour::rgb(0xb4, 0x50, 0x8c),
    Colour::rgb(0xc9, 0x87, 0x00),
    Colour::rgb(0x3f, 0x9f, 0xdc),
];

/// Entry `k` of the palette, which repeats after six.
#[must_use]
pub fn palette(k: usize) -> Colour {
    PALETTE[k % PALETTE.len()]
}

/// A pattern of strokes and gaps.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Dash {
    /// An unbroken line.
    #[default]
    Solid,
    /// Long strokes.
    Dashed,
    /// Stroke and dot.
    DashDot,
    /// Dots.
    Dotted,
    /// Long strokes with wide gaps.
    LongDash,
    /// Stroke and two dots.
    DashDotDot,
}

/// All patterns, in the order in which [`Line::nth`] deals them out.
pub const DASHES: [Dash; 6] = [
    Dash::Solid,
    Dash::Dashed,
    Dash::DashDot,
    Dash::Dotted,
    Dash::LongDash,
    Dash::DashDotDot,
];

impl Dash {
    /// Lengths of strokes and gaps in turn, in line widths; empty for a solid line.
    pub(crate) const fn pattern(self) -> &'static [f32] {
        match self {
            Dash::Solid => &[],
            Dash::Dashed => &[4.5, 2.5],
            Dash::DashDot => &[6.0, 2.2, 1.2, 2.2],
            Dash::Dotted => &[1.2, 2.0],
            Dash::LongDash => &[9.0, 3.0],
            Dash::DashDotDot => &[6.0, 2.0, 1.2, 2.0, 1.2, 2.0],
        }
    }
}

/// How a line is drawn.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Line {
    /// Its colour.
    pub colour: Colour,
    /// Its width in pixels, 0.1 to 20.
    pub width: f64,
    /// Its pattern.
    pub dash: Dash,
}

impl Line {
    /// A solid line.
    #[must_use]
    pub const fn solid(colour: Colour, width: f64) -> Self {
        Line {
            colour,
            width,
            dash: Dash::Solid,
        }
    }

    /// The line of the `k`-th member of a family: own colour and own pattern, both from period six.
    #[must_use]
    pub fn nth(k: usize) -> Self {
        Line {
            colour: palette(k),
            width: 1.8,
            dash: DASHES[k % DASHES.len()],
        }
    }

    /// The same line with another pattern.
    #[must_use]
    pub const fn dashed(self, dash: Dash) -> Self {
        Line { dash, ..self }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn linear_and_back_is_the_identity_on_every_byte() {
        for byte in 0..=255 {
            let grey = Colour::rgb(byte, byte, byte);
            assert_eq!(Colour::from_linear(grey.linear()), grey);
        }
    }

    #[test]
    fn mixing_halfway_is_brighter_than_the_mean_of_the_bytes() {
        let half = Colour::rgb(0, 0, 0).mix(Colour::PAPER, 0.5);
        assert_eq!(half, Colour::rgb(188, 188, 188));
    }

    #[test]
    fn every_palette_colour_is_dark_enough_for_white_paper() {
        for colour in PALETTE {
            let contrast = 1.05 / (colour.luminance() + 0.05);
            assert!(contrast >= 2.8, "{colour:?} has contrast {contrast}");
        }
    }

    #[test]
    fn lines_of_equal_pattern_in_a_family_of_six_do_not_exist() {
        for i in 0..6 {
            for j in 0..i {
                assert_ne!(Line::nth(i).dash, Line::nth(j).dash);
                assert_ne!(Line::nth(i).colour, Line::nth(j).colour);
            }
        }
    }
}
