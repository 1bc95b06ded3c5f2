//! Panels that are compared share one box, so that what looks larger is larger.

use crate::error::FigureError;
use crate::flat::Plot;
use crate::picture::{Content, Panel};
use crate::space::{Bounds, View};

/// Gives all views among the panels the smallest box that holds each of them, and all plots the same axes. Given bounds
/// and ranges stay as they are.
///
/// # Errors
/// [`FigureError::Empty`] for a panel with nothing in it; and any error of its extent.
pub fn same_scales(panels: &mut [Panel]) -> Result<(), FigureError> {
    let mut views: Vec<&mut View> = vec![];
    let mut plots: Vec<&mut Plot> = vec![];
    for panel in panels {
        match &mut panel.content {
            Content::View(view) => views.push(view),
            Content::Plot(plot) => plots.push(plot),
        }
    }
    let boxes = views.iter().map(|view| view.shown());
    let boxes = boxes.collect::<Result<Vec<_>, FigureError>>()?;
    if let Some(common) = boxes.into_iter().reduce(around) {
        for view in views.iter_mut().filter(|v| v.bounds == Bounds::Data) {
            view.bounds = Bounds::Fixed(common);
        }
    }
    let windows = plots.iter().map(|plot| plot.window());
    let windows = windows.collect::<Result<Vec<_>, FigureError>>()?;
    if let Some([x, y]) = windows.into_iter().reduce(around) {
        for plot in plots {
            plot.x.range.get_or_insert(x);
            plot.y.range.get_or_insert(y);
        }
    }
    Ok(())
}

/// The box around two boxes.
fn around<const N: usize>(a: [[f64; 2]; N], b: [[f64; 2]; N]) -> [[f64; 2]; N] {
    std::array::from_fn(|k| {
        let ([low, high], [other_low, other_high]) = (a[k], b[k]);
        [low.min(other_low), high.max(other_high)]
    })
}
