//! One figure of a paper, ready to be drawn.

use crate::figure::{self, Drawing};
use crate::{PlateError, plane, space};
use torse_plot::{Content, Figure, Panel, Picture, Size, same_scales};
use torse_syntax::derivation::Figure as Entry;
use torse_syntax::derivation::{DerivationError, Paper};

/// Increase it whenever figures are drawn in another way from the same data, so that every fingerprint changes.
const VERSION: u32 = 2;

/// A figure of a derivation file with all its formulas evaluated.
#[derive(Debug, Clone)]
pub struct Plate {
    pub(crate) drawing: Drawing,
    pub(crate) movable: Option<Drawing>,
    pub(crate) torse: Option<figure::Torse>,
}

/// Evaluates the figures of a paper: its own, then ours.
///
/// # Errors
/// The first formula, in file order, that makes no sense.
pub fn plates(paper: &Paper) -> Result<Vec<Plate>, Box<DerivationError>> {
    paper.figures().map(Plate::new).collect()
}

impl Plate {
    /// Evaluates a figure.
    ///
    /// # Errors
    /// The first formula that makes no sense.
    pub fn new(figure: &Entry) -> Result<Self, Box<DerivationError>> {
        Ok(Self {
            drawing: figure::drawing(figure)?,
            movable: figure::interactive(figure)?,
            torse: figure::torse(figure)?,
        })
    }

    /// The exact data.
    #[must_use]
    pub fn drawing(&self) -> &Drawing {
        &self.drawing
    }

    /// The name of its files: its id with a hyphen for the slash.
    #[must_use]
    pub fn name(&self) -> String {
        self.drawing.id.replace('/', "-")
    }

    /// Returns the caption, and what was assumed or replaced, for the reader of a report.
    #[must_use]
    pub fn caption(&self) -> String {
        let listed = |what: &str, list: &[String]| match list {
            [] => String::new(),
            list => format!(" {what}: {}.", list.join("; ")),
        };
        let Drawing {
            caption,
            stand_in,
            assumes,
            ..
        } = &self.drawing;
        format!(
            "{caption}{}{}",
            listed("Not printed and replaced by our own", stand_in),
            listed("Assumed", assumes)
        )
    }

    /// Draws it.
    ///
    /// # Errors
    /// [`PlateError`]: a formula that is infinite at a sample, and all errors of drawing.
    pub fn draw(&self) -> Result<Picture, PlateError> {
        Ok(self.figure()?.draw()?)
    }

    /// Returns its panels, sampled; those of one entry have the same scales.
    ///
    /// # Errors
    /// [`PlateError`]: a formula that is infinite at a sample, a panel with nothing in it.
    pub fn figure(&self) -> Result<Figure, PlateError> {
        let drawing = &self.drawing;
        let panels = drawing.panels.iter().map(|panel| {
            let content = match panel.dimension {
                3 => Content::View(space::view(panel)?),
                _ => Content::Plot(plane::plot(panel)?),
            };
            let caption = panel.caption.clone();
            Ok(Panel { content, caption })
        });
        let mut panels = panels.collect::<Result<Vec<_>, PlateError>>()?;
        let mut rest = panels.as_mut_slice();
        for compared in drawing.panels.chunk_by(|a, b| a.entry == b.entry) {
            let (own, others) = rest.split_at_mut(compared.len());
            if own.len() > 1 {
                same_scales(own)?;
            }
            rest = others;
        }
        let columns = drawing.columns.unwrap_or(match panels.len() {
            1 => 1,
            2 | 4 => 2,
            _ => 3,
        });
        let size = drawing.size.unwrap_or(match columns {
            1 => [580, 440],
            2 => [400, 320],
            _ => [306, 280],
        });
        let [width, height] = size;
        Ok(Figure {
            title: drawing.title.clone(),
            panels,
            columns,
            panel_size: Size { width, height },
        })
    }

    /// Returns a number that changes with everything that determines the picture and the words around it: the FNV-1a
    /// hash, 64 bits, of the exact data. Equal fingerprints mean equal pictures.
    ///
    /// # Errors
    /// [`PlateError::Data`] if the data cannot be written down, which finite angles of view never cause.
    pub fn fingerprint(&self) -> Result<u64, PlateError> {
        let text = serde_json::to_string(&(VERSION, &self.drawing, &self.movable))
            .map_err(|error| PlateError::Data(error.to_string()))?;
        Ok(fnv1a(text.as_bytes()))
    }
}

/// Fowler, Noll and Vo's hash 1a.
fn fnv1a(bytes: &[u8]) -> u64 {
    bytes.iter().fold(0xcbf2_9ce4_8422_2325, |hash, byte| {
        (hash ^ u64::from(*byte)).wrapping_mul(0x0100_0000_01b3)
    })
}

#[cfg(test)]
mod tests {
    use super::fnv1a;

    #[test]
    fn the_hash_agrees_with_the_published_test_vectors() {
        assert_eq!(fnv1a(b""), 0xcbf2_9ce4_8422_2325);
        assert_eq!(fnv1a(b"a"), 0xaf63_dc4c_8601_ec8c);
        assert_eq!(fnv1a(b"foobar"), 0x8594_4171_f739_67e8);
    }
}
