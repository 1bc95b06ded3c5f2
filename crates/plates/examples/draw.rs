//! Draws figures of derivation files into a folder:
//! `cargo run -p torse-plates --example draw -- derivations target/plates gbt-surfaces/fig-13`.
//! The last arguments are beginnings of ids; without any, all figures are drawn.

use std::error::Error;
use std::path::PathBuf;
use std::time::Instant;
use torse_language::derivation::load;
use torse_plates::Plate;

fn main() -> Result<(), Box<dyn Error>> {
    let mut arguments = std::env::args().skip(1);
    let usage = "usage: draw DERIVATIONS FOLDER [ID]...";
    let papers = load(&PathBuf::from(arguments.next().ok_or(usage)?))
        .map_err(|e| format!("{:?}", miette(e)))?;
    let folder = PathBuf::from(arguments.next().ok_or(usage)?);
    let wanted: Vec<String> = arguments.collect();
    std::fs::create_dir_all(&folder)?;
    for figure in papers.iter().flat_map(|paper| paper.figures()) {
        if !wanted.is_empty() && !wanted.iter().any(|id| figure.id.starts_with(id.as_str())) {
            continue;
        }
        let start = Instant::now();
        let plate = Plate::new(figure).map_err(|e| format!("{:?}", miette(*e)))?;
        let evaluated = start.elapsed();
        let picture = plate.draw().map_err(|e| format!("{}: {e}", figure.id))?;
        let png = picture.png()?;
        let interactive = plate.interactive()?;
        println!(
            "{}: evaluated in {evaluated:.2?}, drawn in {:.2?}, svg {} kB, png {} kB, interactive: {}",
            plate.name(),
            start.elapsed() - evaluated,
            picture.svg.len() / 1000,
            png.len() / 1000,
            interactive.map_or("no".to_owned(), |i| format!(
                "{} monomials",
                i.monomials().len()
            )),
        );
        std::fs::write(folder.join(format!("{}.png", plate.name())), png)?;
        std::fs::write(folder.join(format!("{}.svg", plate.name())), picture.svg)?;
    }
    Ok(())
}

fn miette(error: impl Into<miette::Report>) -> miette::Report {
    error.into()
}
