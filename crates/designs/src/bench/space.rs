//! A part in space, with the labels of its sides, among the others.

use super::sides::Side;
use crate::design::Design;
use crate::draw::{PatchStyle, lines, solids};
use crate::error::DesignError;
use crate::position::position;
use crate::space_openings::openings_in_space;
use crate::unroll::{FlatPiece, Part};
use torse_geometry::pattern::PatternPlace;
use torse_geometry::prelude::Point;
use torse_geometry::vector::{norm, sub};
use torse_plot::{Camera, Colour, Legend, Paint, Picture, Place, Size, Solid, Stage, View};

/// Steps of the grid of a patch.
const ALONG: usize = 64;
const ACROSS: usize = 4;
const SIZE: Size = Size {
    width: 380,
    height: 270,
};
/// The face that the drawing of the part shows, and the other.
const SEEN: Colour = Colour::rgb(0x6f, 0xa3, 0xd8);
const UNSEEN: Colour = Colour::rgb(0xe6, 0xbd, 0x7a);
/// The other parts.
const OTHERS: Colour = Colour::rgb(0xd4, 0xd4, 0xd4);

/// Returns the view of a design with one of its parts in colour: blue is the face that the drawing shows.
pub(super) fn view(
    design: &Design,
    piece: &FlatPiece,
    part: &Part,
    sides: &[Side],
) -> Result<Picture, DesignError> {
    let mut view = View::new().legend(Legend::Hidden).stage(Stage::Bare);
    if let Some([azimuth, elevation]) = design.view.angles {
        view = view.camera(Camera::Angles { azimuth, elevation });
    }
    let openings = openings_in_space(design)?;
    for (index, patch) in design.patches.iter().enumerate() {
        let own = piece.piece.patches.contains(&index);
        let place = position(&piece.flat, patch).filter(|_| own);
        let paint = match place.map(|place| shows_front(piece, part, place)) {
            Some(true) => Paint::TwoSided {
                front: SEEN,
                back: UNSEEN,
            },
            Some(false) => Paint::TwoSided {
                front: UNSEEN,
                back: SEEN,
            },
            None => Paint::plain(OTHERS),
        };
        let style = PatchStyle {
            steps: [ALONG, ACROSS],
            lines: if own { lines(design).min(8) } else { 0 },
            paint,
        };
        let open: Vec<_> = openings.iter().filter(|on| on.patch == index).collect();
        for solid in solids(patch, &open, &style)? {
            view = view.solid(solid);
        }
    }
    for side in sides {
        if let Some(at) = middle(&side.space) {
            view = view.solid(Solid::Note {
                at,
                text: side.label.clone(),
                place: Place::Above,
            });
        }
    }
    Ok(view.draw(&format!("{} in space", part.name), SIZE)?)
}

/// Returns whether the drawing of a patch shows the side to which its normal `r_u x r_v` points.
fn shows_front(piece: &FlatPiece, part: &Part, place: usize) -> bool {
    let at = |x: f64, v: f64| {
        let place = PatternPlace { piece: place, x, v };
        let flat = piece.flat.flatten(place).unwrap_or_default();
        part.placement.point(flat)
    };
    let (o, u, v) = (at(0.45, 0.45), at(0.55, 0.45), at(0.45, 0.55));
    (u[0] - o[0]) * (v[1] - o[1]) - (u[1] - o[1]) * (v[0] - o[0]) > 0.0
}

/// Returns the point at half of the length of a polygon.
fn middle(points: &[Point]) -> Option<Point> {
    let step = |pair: &[Point]| norm(&sub(&pair[1], &pair[0]));
    let whole: f64 = points.windows(2).map(step).sum();
    let mut left = 0.5 * whole;
    for pair in points.windows(2) {
        let length = step(pair);
        if length > 0.0 && left <= length {
            return Some(std::array::from_fn(|i| {
                pair[0][i] + left / length * (pair[1][i] - pair[0][i])
            }));
        }
        left -= length;
    }
    points.first().copied()
}
