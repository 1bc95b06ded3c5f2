//! A picture of a design, as SVG and PNG.

use super::{PatchStyle, lines, solids};
use crate::design::Design;
use crate::error::DesignError;
use crate::space_openings::openings_in_space;
use crate::unroll::{Demand, FlatPiece, drawing, unroll};
use torse_exchange::{Drawing, Layer as Sheet};
use torse_plot::Aspect;
use torse_plot::{
    Axis, Camera, Colour, Content, Figure, Grid, Layer, Legend, Line, Paint, Panel, Picture, Plot,
    Size, Stage, Surface, View,
};

/// Steps of the grid of a patch.
const ALONG: usize = 96;
const ACROSS: usize = 6;
/// Steps of the grid of a surface, each way.
const WAYS: usize = 48;
const PANEL: Size = Size {
    width: 560,
    height: 460,
};

/// Draws the patches and, where the design has one, its pattern.
///
/// # Errors
/// [`DesignError::Patch`], [`DesignError::Figure`]; [`DesignError::NoSuch`] and [`DesignError::LeftOut`] for what is asked
/// for by name and has no piece.
pub fn picture(design: &Design, demand: &Demand) -> Result<Picture, DesignError> {
    let mut panels = vec![Panel {
        content: Content::View(view(design)?),
        caption: "in space (mm)".to_owned(),
    }];
    // What has no pattern is seen all the same.
    let pieces = match unroll(design, demand) {
        Err(unknown @ (DesignError::NoSuch { .. } | DesignError::LeftOut { .. })) => {
            return Err(unknown);
        }
        pieces => pieces,
    };
    if let Ok(pieces) = pieces {
        let drawn = drawing(design, &pieces)?;
        panels.push(Panel {
            content: Content::Plot(pattern(&pieces, &drawn)),
            caption: if design.has_tool_bends() {
                "development, without bend allowance (mm)".to_owned()
            } else {
                "flat pattern (mm)".to_owned()
            },
        });
    }
    let figure = Figure {
        title: design.title.clone(),
        columns: panels.len(),
        panels,
        panel_size: PANEL,
    };
    Ok(figure.draw()?)
}

fn view(design: &Design) -> Result<View, DesignError> {
    let mut view = View::new().legend(Legend::Hidden).stage(Stage::default());
    if let Some([azimuth, elevation]) = design.view.angles {
        view = view.camera(Camera::Angles { azimuth, elevation });
    }
    // An opening that cannot be cut is refused where a pattern is made.
    let openings = openings_in_space(design).unwrap_or_default();
    for (index, patch) in design.patches.iter().enumerate() {
        let own: Vec<_> = openings.iter().filter(|own| own.patch == index).collect();
        let paint = if design.patches.len() == 1 {
            Paint::default()
        } else {
            Paint::nth(index)
        };
        let style = PatchStyle {
            steps: [ALONG, ACROSS],
            lines: lines(design),
            paint,
        };
        for solid in solids(patch, &own, &style)? {
            view = view.solid(solid);
        }
    }
    let colours = design.patches.len()..;
    for (index, surface) in colours.zip(&design.surfaces) {
        for part in &surface.parts {
            let points = super::grid(surface, part, WAYS, WAYS)?;
            let grid = Grid::new(WAYS + 1, WAYS + 1, points)?;
            view = view.surface(Surface::new(grid).paint(Paint::nth(index)).lines(8, 8));
        }
    }
    Ok(view)
}

/// Thin enough for many rulings.
const RULING: Line = Line::solid(Colour::GREY, 0.6);
const UP: Line = Line::solid(Colour::rgb(0x2a, 0x6f, 0xb8), 0.7);
const DOWN: Line = Line::solid(Colour::rgb(0xc2, 0x4a, 0x2e), 0.7);
const EDGE: Line = Line::solid(Colour::rgb(0xa0, 0x2f, 0x8c), 1.0);
const MARK: Line = Line::solid(Colour::rgb(0x1f, 0x7a, 0x4d), 1.1);
const OUTLINE: Line = Line::solid(Colour::INK, 1.5);

fn pattern(pieces: &[FlatPiece], drawing: &Drawing) -> Plot {
    let mut plot = Plot::new(Axis::auto(""), Axis::auto(""))
        .aspect(Aspect::Equal)
        .legend(Legend::Hidden);
    for piece in pieces {
        let [low, high] = piece.flat.outline().bounds();
        let size = (high[0] - low[0]).max(high[1] - low[1]);
        if let Ok(boundary) = piece.flat.outline().polygon(5e-4 * size) {
            plot = plot.layer(Layer::Region {
                boundary,
                colour: Colour::rgb(0x6f, 0xa3, 0xd8),
                opacity: 0.18,
                label: String::new(),
            });
        }
    }
    for path in drawing.paths() {
        let line = match path.layer() {
            Sheet::Outline => OUTLINE,
            Sheet::Rulings => RULING,
            Sheet::BendUp => UP,
            Sheet::BendDown => DOWN,
            Sheet::Regression => EDGE,
            Sheet::Marks => MARK,
        };
        plot = plot.curve(path.polygon(5e-4), line, "");
    }
    for text in drawing.texts() {
        plot = plot.layer(Layer::Lettering {
            at: text.at,
            // Plain text has no mathematics.
            text: text.content.replace('$', "\\$"),
            height: text.height,
            angle: text.angle,
            colour: MARK.colour,
        });
    }
    plot
}
