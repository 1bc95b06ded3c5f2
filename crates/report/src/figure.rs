//! Pictures as the report takes them: bytes, a caption, and the claims they illustrate.

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
    /// The usual ending of a file of this format, without the dot.
    #[must_use]
    pub fn extension(&self) -> &'static str {
        match self {
            Image::Svg(_) => "svg",
            Image::Png(_) => "png",
        }
    }

    /// The media type.
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

/// A picture with what a reader needs to know about it.
///
/// A report shows it beside the first claim of [`claims`](Self::claims) that the paper has, and the other
/// claims point there; a picture of no claim stands in the section of further figures.
#[derive(Debug, Clone, PartialEq)]
pub struct FigureImage {
    /// A short name, unique in the report, for instance `basis-functions`: that of its files.
    pub name: String,
    /// The caption, plain text.
    pub caption: String,
    /// What the picture shows, for readers who cannot see it.
    pub alt: String,
    /// The picture.
    pub image: Image,
    /// The ids of the claims that it illustrates.
    pub claims: Vec<String>,
    /// Whether it was redrawn from printed data alone: `reproduced`, `partial` or `underspecified`.
    pub verdict: Verdict,
    /// What is not printed and was filled with a default, such as a view.
    pub assumes: Vec<String>,
    /// Data that are not printed and were replaced by our own.
    pub stand_in: Vec<String>,
    /// The picture with sliders, for pages that can move it.
    pub interactive: Option<Interactive>,
    /// The developable that it shows, for pages that can move and unroll it.
    pub torse: Option<Torse>,
    /// The place, from the folder of the page, of a STEP file of the developable as the page opens with it.
    pub step: Option<String>,
}
