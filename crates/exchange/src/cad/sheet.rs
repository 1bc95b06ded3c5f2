//! Exact forms of sheets, where the way they are made has one.

use super::Converted;
use super::exact::{BezierForm, ExactForm, HomogeneousRail};
use crate::error::{ExchangeError, Result};
use torse_geometry::RuledSurface;
use torse_geometry::sheet::{Construction, Rail, RailCurve, Sheet};

impl HomogeneousRail for Rail {
    fn bernstein_form(&self) -> Result<BezierForm> {
        match self.curve() {
            RailCurve::Plain(curve) => curve.bernstein_form(),
            RailCurve::Weighted(curve) => curve.bernstein_form(),
            RailCurve::Elliptic(_) => Err(ExchangeError::NotRational {
                why: "the weights of an arc of any angle are no numbers that are known exactly",
            }),
        }
    }
}

/// The exact form of the patch between two rails.
fn between([first, second]: [Rail; 2]) -> Result<Converted> {
    RuledSurface::new(first, second).exact_form()
}

/// The exact form of the patch that the sheet is; a developable between two free rails has none.
///
/// ```
/// use torse_exchange::convert;
/// use torse_geometry::prelude::*;
/// let planes = Planes::bernstein(&[[0., 0., 1., 0.], [0., -1., 1., 0.], [1., -2., 1., 0.], [3., -3., 1., 1.]])?;
/// assert!(convert(&Sheet::tangent(&planes, 0.5, 1.0)?, 1e-3)?.error < 1e-13);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
impl ExactForm for Sheet {
    fn exact_form(&self) -> Result<Converted> {
        match self.construction() {
            Construction::Ruled(patch) => patch.exact_form(),
            Construction::Cylinder(patch) => between(patch.rails()?),
            Construction::Cone(patch) => between(patch.rails()?),
            Construction::Envelope(patch) => patch.exact_form(),
            Construction::Tangent(patch) => patch.exact_form(),
            Construction::Connecting(_) => Err(ExchangeError::NotRational {
                why: "the rulings between two free rails follow roots of an equation",
            }),
            Construction::Part(_) => Err(ExchangeError::NotRational {
                why: "parts of patches are approximated",
            }),
        }
    }
}
