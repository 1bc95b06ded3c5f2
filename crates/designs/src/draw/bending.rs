//! A moving picture: the sheet bends from flat to its shape and back.

use crate::design::Design;
use crate::error::DesignError;
use crate::unroll::{Demand, FlatPiece, unroll};
use torse_geometry::pattern::{BentSheet, FlatRuling, PatternError};
use torse_plot::{Animation, Camera, FigureError, Grid, Paint, Surface, View};

/// The most bytes of a moving picture.
pub const MAX_GIF_BYTES: usize = 400_000;

/// Sizes in pixels with numbers of states: the first whose file is small enough is taken.
const TRIES: [([u32; 2], usize); 4] = [
    ([480, 360], 22),
    ([400, 300], 18),
    ([320, 240], 14),
    ([240, 180], 10),
];

/// Rulings of each patch along which the sheet bends; few of them are drawn.
const RULINGS: usize = 65;

/// The most lines that are drawn of all patches together, where no patch has less than one.
const MAX_LINES: usize = 40;

/// Hundredths of a second.
const PAUSE: u16 = 120;
const STEP: u16 = 6;

/// Draws the sheet as it bends from its flat pattern to its shape and back, as a GIF of at most [`MAX_GIF_BYTES`]. Each
/// state is isometric to the pattern: the facets between rulings turn about them ([`torse_geometry::pattern::BentSheet`]).
///
/// # Errors
/// As [`unroll`]; [`DesignError::Figure`] for what cannot be drawn.
///
/// ```
/// use torse_designs::{draw::{MAX_GIF_BYTES, bending}, unroll::Demand};
/// let design = torse_designs::read("tube.toml", r#"
///     [curves.rim]
///     arc = { centre = [0, 0, 0], from = [20, 0, 0], to = [0, 20, 0] }
///     [patches.tube]
///     cylinder = "rim"
///     direction = [0, 0, 30]
/// "#)?;
/// let file = bending(&design, &Demand::default())?;
/// assert!(file.starts_with(b"GIF89a") && file.len() <= MAX_GIF_BYTES);
/// # Ok::<(), torse_designs::DesignError>(())
/// ```
pub fn bending(design: &Design, demand: &Demand) -> Result<Vec<u8>, DesignError> {
    let fine = Demand {
        rulings: Some(demand.rulings.unwrap_or(RULINGS)),
        ..demand.clone()
    };
    let pieces = unroll(design, &fine)?;
    let mut file = Vec::new();
    for (size, states) in TRIES {
        let views = (0..states).map(|k| state(design, &pieces, eased(k, states)));
        let animation = Animation {
            views: views.collect::<Result<_, _>>()?,
            pause: PAUSE,
            step: STEP,
        };
        file = animation.gif(size)?;
        if file.len() <= MAX_GIF_BYTES {
            return Ok(file);
        }
    }
    let bytes = file.len();
    let reason =
        format!("the smallest moving picture has {bytes} bytes: draw one piece with `--only`");
    Err(DesignError::Figure(FigureError::Gif(reason)))
}

/// The share of the bends of a state: slow at both ends.
#[allow(clippy::cast_precision_loss, reason = "few states")]
fn eased(k: usize, states: usize) -> f64 {
    let share = k as f64 / (states - 1) as f64;
    share * share * (3.0 - 2.0 * share)
}

fn state(design: &Design, pieces: &[FlatPiece], share: f64) -> Result<View, DesignError> {
    let most = design.view.rulings.saturating_sub(1).max(1);
    let lines = (MAX_LINES / design.patches.len().max(1)).clamp(1, most);
    let mut view = View::new();
    if let Some([azimuth, elevation]) = design.view.angles {
        view = view.camera(Camera::Angles { azimuth, elevation });
    }
    for (number, FlatPiece { piece, flat }) in pieces.iter().enumerate() {
        let paint = match pieces.len() {
            1 => Paint::default(),
            _ => Paint::nth(number),
        };
        let failed = |reason: PatternError| DesignError::Unroll {
            piece: piece.name.clone(),
            reason,
            needed: None,
        };
        let bent = flat.bent(share).map_err(failed)?;
        for rulings in patches(flat.rulings(), &bent) {
            let rows = rulings.len();
            // A patch of one ruling is none.
            let Ok(grid) = Grid::new(rows, 2, rulings.into_flattened()) else {
                continue;
            };
            let surface = Surface::new(grid).paint(paint.clone());
            view = view.surface(surface.lines(lines, 0));
        }
    }
    Ok(view)
}

/// The rulings in space of each patch of a chain. At a joint one ruling stands for both.
fn patches(flat: &[FlatRuling], bent: &BentSheet) -> Vec<Vec<[[f64; 3]; 2]>> {
    let mut patches: Vec<Vec<[[f64; 3]; 2]>> = Vec::new();
    let mut piece = None;
    for (ruling, ends) in flat.iter().zip(bent.rulings()) {
        if piece != Some(ruling.piece) {
            let joint = patches.last().and_then(|patch| patch.last()).copied();
            patches.push(joint.into_iter().collect());
            piece = Some(ruling.piece);
        }
        if let Some(patch) = patches.last_mut() {
            patch.push(ends);
        }
    }
    patches
}
