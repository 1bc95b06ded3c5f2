//! Fig. 1 of gbt-developable: the basis functions for several degrees and shape parameters.

use super::{Redrawn, Undrawn, parts};
use torse_figures::{Axis, Content, Figure, Legend, Line, Panel, Picture, Plot, Size};
use torse_geometry::{Basis, Gbt};

pub const FIGURE: Redrawn = Redrawn {
    paper: "gbt-developable",
    name: "gbt-developable-fig-1",
    caption: "The basis functions of degrees 2 to 5 for four values of the shape parameters, as in Fig. 1. \
              Printed are the values, read as μ = ν; the degrees are our choice.",
    alt: "Four plots, one for each degree from 2 to 5. In each, the basis functions are bells on the unit \
          interval between a falling first and a rising last function. As the shape parameters grow from \
          −1 to 1, first and last function lie lower and the inner ones higher.",
    claims: &["gbt-developable/fig-1"],
    draw,
};

/// The values of `mu = nu` printed with Fig. 1.
const SHAPES: [f64; 4] = [-1.0, -0.3, 0.3, 1.0];

fn draw() -> Result<Picture, Undrawn> {
    let panel = |degree| {
        Ok(Panel {
            content: Content::Plot(plot(degree)?),
            caption: format!("degree $k = {degree}$"),
        })
    };
    let figure = Figure {
        title: "GBT basis functions of degrees 2 to 5".to_owned(),
        panels: (2..=5).map(panel).collect::<Result<_, Undrawn>>()?,
        columns: 2,
        panel_size: Size {
            width: 400,
            height: 300,
        },
    };
    Ok(figure.draw()?)
}

fn plot(degree: usize) -> Result<Plot, Undrawn> {
    let values = format!("$g_{{i,{degree}}}(x)$");
    let mut plot = Plot::new(Axis::fixed("$x$", 0.0, 1.0), Axis::fixed(&values, 0.0, 1.0))
        .legend(Legend::Below);
    for (number, shape) in SHAPES.into_iter().enumerate() {
        let basis = Gbt::new(shape, shape)?;
        let mut functions = vec![Vec::new(); degree + 1];
        for x in parts(160) {
            for (function, value) in functions.iter_mut().zip(basis.row(degree, &x)?) {
                function.push([x, value]);
            }
        }
        let name = format!("$\\mu = \\nu = {shape}$");
        for (index, function) in functions.into_iter().enumerate() {
            let label = if index == 0 { name.as_str() } else { "" };
            plot = plot.curve(function, Line::nth(number), label);
        }
    }
    Ok(plot)
}
