//! The sizes of the formulas of developables that readers move: how many monomials each piece has.
//! `cargo run -p torse-plates --example torses -- derivations gbt-developable/fig-15`.
//! The last arguments are beginnings of ids; without any, all figures are looked at.

use std::error::Error;
use std::path::PathBuf;
use std::time::Instant;
use torse_figures::{Quotient, TorsePiece};
use torse_language::derivation::load;
use torse_plates::Plate;

fn main() -> Result<(), Box<dyn Error>> {
    let mut arguments = std::env::args().skip(1);
    let folder = arguments
        .next()
        .ok_or("usage: torses DERIVATIONS [ID]...")?;
    let papers = load(&PathBuf::from(folder)).map_err(|e| format!("{:?}", miette(e)))?;
    let wanted: Vec<String> = arguments.collect();
    for figure in papers.iter().flat_map(|paper| paper.figures()) {
        let asked = wanted.iter().any(|id| figure.id.starts_with(id.as_str()));
        if figure.entry.torse.is_none() || !(wanted.is_empty() || asked) {
            continue;
        }
        let start = Instant::now();
        let plate = Plate::new(figure).map_err(|e| format!("{:?}", miette(*e)))?;
        let evaluated = start.elapsed();
        if let Some(torse) = plate.torse()? {
            let sizes: Vec<usize> = torse.pieces().iter().map(monomials).collect();
            println!("{}: evaluated in {evaluated:.2?}, {sizes:?}", plate.name());
        }
    }
    Ok(())
}

fn monomials(piece: &TorsePiece) -> usize {
    let size = |q: &Quotient| {
        q.numerator.len()
            + q.denominator
                .iter()
                .map(|(sum, _)| sum.len())
                .sum::<usize>()
    };
    piece.curves.iter().flatten().map(size).sum()
}

fn miette(error: impl Into<miette::Report>) -> miette::Report {
    error.into()
}
