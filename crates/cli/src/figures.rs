//! The figures of the derivation files, drawn in parallel.

use crate::exit::Failure;
use crate::terminal::Progress;
use rayon::prelude::*;
use torse_claims::derivation::Paper;
use torse_plates::Plate;

/// A figure with its files.
pub struct Drawn {
    /// What it is.
    pub plate: Plate,
    /// The picture as SVG.
    pub svg: String,
    /// The picture as PNG.
    pub png: Vec<u8>,
}

/// Draws all figures of a paper, in its order; one step of progress each.
pub fn drawn(paper: &Paper, progress: &Progress) -> Result<Vec<Drawn>, Failure> {
    let figures: Vec<_> = paper.figures().collect();
    let drawn: Vec<Result<Drawn, Failure>> = figures
        .into_par_iter()
        .map(|figure| {
            let plate = Plate::new(figure)?;
            progress.doing(&figure.id);
            let failed = |source| Failure::Figure {
                figure: figure.id.clone(),
                source,
            };
            let picture = plate.draw().map_err(failed)?;
            let png = picture.png().map_err(|error| failed(error.into()))?;
            progress.step();
            let svg = picture.svg;
            Ok(Drawn { plate, svg, png })
        })
        .collect();
    // Collected first, so that the first failure told is always the same.
    drawn.into_iter().collect()
}
