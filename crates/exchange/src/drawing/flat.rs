//! Drawings of flat patterns.

use super::{Drawing, Layer, Vertex};
use crate::error::Result;
use torse_geometry::pattern::FlatPattern;

/// A number with two digits that is not below the value: 5 % more is not lost again by rounding.
fn at_most(value: f64) -> String {
    format!("{:.1e}", 1.05 * value)
}

impl Drawing {
    /// The drawing of a flat pattern: the outline with its arcs, every ruling that is no point with its bend angle, the
    /// edge of regression where it comes within `reach` (a length) of the sheet. Notes tell how exact the outline is
    /// and, of a patch that is not developable, how much it is strained.
    ///
    /// # Errors
    /// As [`Drawing::path`].
    ///
    /// ```
    /// use torse_exchange::{Drawing, Layer};
    /// use torse_geometry::{RuledSurface, curve::ellipse_arc, pattern::unroll};
    /// let ring = |r: f64, z: f64| ellipse_arc(&[0.0, 0.0, z], &[r, 0.0, z], &[0.0, r, z]);
    /// let flat = unroll(&RuledSurface::new(ring(3.0, 0.0)?, ring(1.0, 4.0)?), 16, 1e-6)?;
    /// let drawing = Drawing::of_pattern(&flat, 0.0)?;
    /// let outline = &drawing.paths()[0];
    /// assert!(outline.layer() == Layer::Outline && outline.is_closed());
    /// // The quarter of a cone is a sector of an annulus: arcs.
    /// assert!(outline.vertices().iter().any(|vertex| vertex.bulge != 0.0));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn of_pattern(flat: &FlatPattern, reach: f64) -> Result<Self> {
        let mut drawing = Self::default();
        drawing.add_pattern(flat, reach)?;
        Ok(drawing)
    }

    /// Adds a flat pattern to the drawing, as [`Drawing::of_pattern`] draws it: for several on one sheet.
    ///
    /// # Errors
    /// As [`Drawing::path`].
    pub fn add_pattern(&mut self, flat: &FlatPattern, reach: f64) -> Result<()> {
        let vertices = flat.outline().vertices();
        let vertices: Vec<Vertex> = vertices
            .map(|(point, bulge)| Vertex { point, bulge })
            .collect();
        self.path(Layer::Outline, &vertices, true)?;
        // At a tip there is nothing to bend.
        for ruling in flat.rulings().iter().filter(|ruling| !ruling.is_point()) {
            let [from, to] = ruling.ends;
            self.bend(from, to, ruling.bend)?;
        }
        for edge in flat.regression(reach) {
            // A single point is seen by nobody.
            if edge.len() > 1 {
                self.polyline(Layer::Regression, &edge)?;
            }
        }
        self.note(&format!(
            "outline within {} mm of the exact development",
            at_most(flat.errors().outline)
        ))?;
        if flat.is_strained() {
            self.note(&format!(
                "not developable: lines are strained by up to {} of their length",
                at_most(flat.strain())
            ))?;
        }
        Ok(())
    }
}
