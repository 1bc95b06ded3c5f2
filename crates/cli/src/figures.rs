//! Draws the figures of the derivation files in parallel, and only those that changed.
//!
//! A list of fingerprints lies beside the files of the figures. A figure whose fingerprint is in the list and whose
//! files exist is read instead of drawn: equal fingerprints mean equal pictures.

use crate::diagnostics::Diagnostics;
use crate::exit::Failure;
use crate::format::pretty_json;
use crate::terminal::Progress;
use crate::watchdog;
use rayon::prelude::*;
use std::collections::BTreeMap;
use std::path::Path;
use torse_designs::movable::step_of;
use torse_figures::{Plate, PlateError};
use torse_plot::Torse;
use torse_report::{FigureImage, Image, write_file};
use torse_syntax::derivation::{DerivationError, Figure, Paper};

/// The fingerprints of the figures in a folder, by the name of their files.
pub type Fingerprints = BTreeMap<String, String>;

/// The folder of the figures in that of the reports.
pub const FOLDER: &str = "figures";

/// The list of fingerprints in a folder of figures.
const LIST: &str = "fingerprints.json";

/// Reads the fingerprints of a folder of figures; none if it has no list, or one that cannot be read.
pub fn read_fingerprints(folder: &Path) -> Fingerprints {
    let list = std::fs::read(folder.join(LIST)).unwrap_or_default();
    serde_json::from_slice(&list).unwrap_or_default()
}

/// Writes the list of fingerprints.
pub fn remember(folder: &Path, fingerprints: &Fingerprints) -> Result<(), Failure> {
    write_file(&folder.join(LIST), pretty_json(fingerprints)?.as_bytes())?;
    Ok(())
}

/// A figure of a derivation file with its formulas evaluated.
pub struct Evaluated<'a> {
    entry: &'a Figure,
    plate: Plate,
}

/// Evaluates the figures of each paper without drawing them. Errors in their formulas are added to the mistakes, and
/// the figure is left out.
pub fn evaluated<'a>(papers: &'a [Paper], mistakes: &mut Diagnostics) -> Vec<Vec<Evaluated<'a>>> {
    let of_papers: Vec<Vec<&Figure>> = papers.iter().map(|p| p.figures().collect()).collect();
    let evaluate = |entry: &&'a Figure| {
        let plate = watchdog::guarded(&entry.id, || Plate::new(entry))?;
        Ok(Evaluated { entry, plate })
    };
    let evaluated: Vec<Vec<Result<_, Box<DerivationError>>>> = of_papers
        .par_iter()
        .map(|figures| figures.par_iter().map(evaluate).collect())
        .collect();
    // Collected first, so that mistakes are always shown in the same order.
    let mut kept = vec![];
    for figures in evaluated {
        let mut own = vec![];
        for figure in figures {
            match figure {
                Ok(figure) => own.push(figure),
                Err(error) => mistakes.add(error),
            }
        }
        kept.push(own);
    }
    kept
}

/// A figure as the report shows it, with its fingerprint.
pub struct Shown {
    /// The picture with its words.
    pub image: FigureImage,
    /// What determines the picture.
    pub fingerprint: String,
}

/// Returns the figures of a paper, in its order, with their files in `folder`; each is one step of progress.
pub fn shown(
    figures: &[Evaluated],
    folder: &Path,
    known: &Fingerprints,
    progress: &Progress,
) -> Result<Vec<Shown>, Failure> {
    let shown: Vec<Result<Shown, Failure>> = figures
        .par_iter()
        .map(|figure| {
            progress.doing(&figure.entry.id);
            let shown = one(figure, folder, known);
            progress.step();
            shown
        })
        .collect();
    // Collected first, so that the first failure shown is always the same.
    shown.into_iter().collect()
}

/// Returns a figure with its files in `folder`; draws it, unless an equal one was drawn before.
fn one(
    Evaluated { entry, plate }: &Evaluated,
    folder: &Path,
    known: &Fingerprints,
) -> Result<Shown, Failure> {
    let failed = |source| Failure::Figure {
        figure: entry.id.clone(),
        source,
    };
    let name = plate.name();
    let fingerprint = format!("{:016x}", plate.fingerprint().map_err(failed)?);
    let kept = match known.get(&name) == Some(&fingerprint) {
        true => drawn_before(folder, &name),
        false => None,
    };
    let (svg, kept) = match kept {
        Some(svg) => (svg, true),
        None => (draw(plate, folder, &name, failed)?, false),
    };
    let interactive = plate.interactive().map_err(failed)?;
    let torse = plate.torse().map_err(failed)?;
    let step = match &torse {
        Some(torse) => Some(solid(torse, &entry.id, folder, &name, kept)?),
        None => None,
    };
    let drawing = plate.drawing();
    let image = FigureImage {
        name,
        caption: drawing.caption.clone(),
        alt: drawing.alt.clone(),
        image: Image::Svg(svg),
        claims: drawing.claims.clone(),
        verdict: entry.verdict(),
        assumes: drawing.assumes.clone(),
        stand_in: drawing.stand_in.clone(),
        interactive,
        torse,
        step,
    };
    Ok(Shown { image, fingerprint })
}

/// Returns the names of a figure's files in its folder.
fn files(name: &str) -> [String; 2] {
    [format!("{name}.png"), format!("{name}.svg")]
}

/// Returns the name of the CAD file of a figure with a developable surface.
fn cad_file(name: &str) -> String {
    format!("{name}.step")
}

/// Writes the developable surface as a CAD file, unless an equal figure `kept` one; returns its path from the folder
/// above.
fn solid(
    torse: &Torse,
    id: &str,
    folder: &Path,
    name: &str,
    kept: bool,
) -> Result<String, Failure> {
    let file = cad_file(name);
    let path = folder.join(&file);
    if !(kept && path.is_file()) {
        let text = step_of(name, torse).map_err(|source| Failure::Step {
            figure: id.to_owned(),
            source,
        })?;
        write_file(&path, text.as_bytes())?;
    }
    Ok(format!("{FOLDER}/{file}"))
}

/// Reads the drawing from the folder, if both files exist.
fn drawn_before(folder: &Path, name: &str) -> Option<String> {
    let [png, svg] = files(name).map(|file| folder.join(file));
    match png.is_file() {
        true => std::fs::read_to_string(svg).ok(),
        false => None,
    }
}

/// Draws the figure, writes both files, and returns the drawing.
fn draw(
    plate: &Plate,
    folder: &Path,
    name: &str,
    failed: impl Fn(PlateError) -> Failure,
) -> Result<String, Failure> {
    let picture = plate.draw().map_err(&failed)?;
    let pixels = picture.png().map_err(|error| failed(error.into()))?;
    let [png, svg] = files(name).map(|file| folder.join(file));
    write_file(&png, &pixels)?;
    write_file(&svg, picture.svg.as_bytes())?;
    Ok(picture.svg)
}
