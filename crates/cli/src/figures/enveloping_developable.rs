//! Example 4.1 of gbt-developable: the developable that four planes control, for three shapes.

use super::{Redrawn, Undrawn, parts, shaded};
use torse_figures::{
    Aspect, Axis, Bounds, Camera, Content, Figure, Legend, Line, Paint, Panel, Picture, Plot, Size,
    View,
};
use torse_geometry::Bounds::Range;
use torse_geometry::{EnvelopingPatch, Gbt, PlaneFamily};

pub const FIGURE: Redrawn = Redrawn {
    paper: "gbt-developable",
    name: "gbt-developable-ex-4.1",
    caption: "The enveloping developable of Example 4.1 for three values of the shape parameters, as in Fig. 8, \
              with its section x = 0. The planes are printed; the values of μ = ν, the range of the rulings \
              (|x₁| ≤ 1/60 for all three) and the view are our choice. All planes are parallel to the x axis, \
              so the surface is a cylinder; the end rulings keep their place and grow longer with μ = ν.",
    alt: "Three shaded arches over the same box, each covered with parallel rulings, and a plot of their three \
          sections: the arches share their feet, and the greater the shape parameters, the lower the arch.",
    claims: &["gbt-developable/fig-8"],
    draw,
};

/// The control planes of Example 4.1.
const PLANES: [[f64; 4]; 4] = [
    [0.0, -20.0, 10.0, 400.0],
    [0.0, -10.0, 20.0, 400.0],
    [0.0, 10.0, 20.0, 400.0],
    [0.0, 20.0, 10.0, 400.0],
];

/// The values of `mu = nu`.
const SHAPES: [f64; 3] = [-1.0, 0.0, 1.0];

/// The range of the parameter `x1` on each ruling.
const RULING: [f64; 2] = [-1.0 / 60.0, 1.0 / 60.0];

/// The box that all three views show.
const BOX: [[f64; 2]; 3] = [[-22.0, 22.0], [-15.0, 15.0], [12.0, 28.0]];

fn draw() -> Result<Picture, Undrawn> {
    let mut panels = Vec::new();
    let mut sections = Plot::new(Axis::auto("$y$"), Axis::auto("$z$"))
        .aspect(Aspect::Equal)
        .legend(Legend::Below);
    for (number, shape) in SHAPES.into_iter().enumerate() {
        let family = PlaneFamily::new(Gbt::new(shape, shape)?, PLANES.to_vec())?;
        let mut section = Vec::new();
        for x in parts(160) {
            let [_, y, z] = family.ruling(&x)?.foot;
            section.push([y, z]);
        }
        let name = format!("$\\mu = \\nu = {shape}$");
        sections = sections.curve(section, Line::nth(number), &name);
        let patch = EnvelopingPatch::new(family, Range(RULING))?;
        let surface = shaded(&patch, 160, 8)?
            .paint(Paint::nth(number))
            .lines(20, 0);
        let view = View::new()
            .surface(surface)
            .bounds(Bounds::Fixed(BOX))
            .camera(Camera::Angles {
                azimuth: -60.0,
                elevation: 25.0,
            });
        panels.push(Panel {
            content: Content::View(view),
            caption: name,
        });
    }
    panels.push(Panel {
        content: Content::Plot(sections),
        caption: "section $x = 0$".to_owned(),
    });
    let figure = Figure {
        title: "Example 4.1: an enveloping developable for three shapes".to_owned(),
        panels,
        columns: 2,
        panel_size: Size {
            width: 400,
            height: 290,
        },
    };
    Ok(figure.draw()?)
}
