//! Pictures for the report: bytes, a caption, and the claims they illustrate.

use torse_plot::{Interactive, Torse};
use torse_syntax::taxonomy::Verdict;

/// The bytes of a picture.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Image {
    /// A drawing in SVG.
    Svg(String),
    /// Pixels in PNG.
    Png(Vec<u8>),
}

impl Image {
    /// Returns the usual extension of a file of this format, without the dot.
    #[must_use]
    pub fn extension(&self) -> &'static str {
        match self {
            Image::Svg(_) => "svg",
            Image::Png(_) => "png",
        }
    }

    /// Returns the media type.
    #[must_use]
    pub fn media_type(&self) -> &'static str {
        match self {
            Image::Svg(_) => "image/svg+xml",
            Image::Png(_) => "image/png",
        }
    }

    /// The bytes of the file.
    #[must_use]
    pub fn bytes(&self) -> &[u8] {
        match self {
            Image::Svg(text) => text.as_bytes(),
            Image::Png(bytes) => bytes,
        }
    }
}

/// A picture with its description.
///
/// A report shows it beside the first of its [`claims`](Self::claims) that the paper has; the other claims link to it.
/// A picture without a claim stands in the section of further figures.
#[derive(Debug, Clone, PartialEq)]
pub struct FigureImage {
    /// A short name, unique in the report, for instance `basis-functions`; its files have this name.
    pub name: String,
    /// The caption, plain text.
    pub caption: String,
    /// A description for readers who cannot see the picture.
    pub alt: String,
    /// The picture.
    pub image: Image,
    /// The ids of the claims that it illustrates.
    pub claims: Vec<String>,
    /// Whether it was redrawn from printed data alone: `reproduced`, `partial` or `underspecified`.
    pub verdict: Verdict,
    /// Data that are not printed and have a default, such as a view.
    pub assumes: Vec<String>,
    /// Data that are not printed and were replaced by our own.
    pub stand_in: Vec<String>,
    /// The picture with sliders, for interactive pages.
    pub interactive: Option<Interactive>,
    /// The developable surface that it shows, for pages that move and unroll it.
    pub torse: Option<Torse>,
    /// The path, from the folder of the page, of a STEP file of the surface in its initial state.
    pub step: Option<String>,
}
