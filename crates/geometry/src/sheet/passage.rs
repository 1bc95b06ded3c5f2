//! Several sheets in space.

use super::{Point, Sheet};
use crate::developable::{PieceIntersection, piece_intersection, piercing};
use crate::error::Result;
use crate::model::ChebyshevModel;
use crate::over::Over;

impl Sheet {
    /// Whether sheets that are joined to one piece pass through each other in space. Joined they are where ends of rulings are no
    /// farther apart than `joined`; whether each passes through itself is what [`Sheet::self_intersection`] tells.
    ///
    /// # Errors
    /// Where control data have no models.
    ///
    /// ```
    /// use torse_geometry::prelude::*;
    /// let corners = [[0.0, 0.0, 0.0], [10.0, 0.0, 0.0], [10.0, 5.0, 0.0], [5.0, 5.0, 0.0], [5.0, -5.0, 0.0]];
    /// let walls = corners.windows(2).map(|side| {
    ///     let edges = [SweptEdge::Share(0.0), SweptEdge::Share(1.0)];
    ///     Sheet::cylinder(&Rail::bezier(side)?, [0.0, 0.0, 3.0], edges)
    /// });
    /// let walls = walls.collect::<Result<Vec<_>, _>>()?;
    /// let walls: Vec<&Sheet> = walls.iter().collect();
    /// assert_eq!(Sheet::piece_intersection(&walls[..3], 1e-9)?, PieceIntersection::Free);
    /// // The last wall crosses the first.
    /// let PieceIntersection::Found { patches, places, proved, .. } = Sheet::piece_intersection(&walls, 1e-9)? else {
    ///     return Err("they cross".into());
    /// };
    /// assert!(patches == [0, 3] && proved && (places[0][0] - 0.5).abs() < 1e-9 && (places[1][0] - 0.5).abs() < 1e-9);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn piece_intersection(sheets: &[&Self], joined: f64) -> Result<PieceIntersection> {
        let models = sheets.iter().map(|sheet| sheet.models());
        let models = models.collect::<Result<Vec<_>>>()?;
        Ok(piece_intersection(sheets, &models, joined))
    }

    /// A point at which the sheet and another one are proved to pass through each other, inside of both: the places `[u, v]` on
    /// each, and the point. `None` does not say that there is none.
    ///
    /// # Errors
    /// As [`Sheet::piece_intersection`].
    pub fn piercing(&self, other: &Self) -> Result<Option<([[f64; 2]; 2], Point)>> {
        Ok(piercing([self, other], [self.models()?, other.models()?]))
    }

    fn models(&self) -> Result<Sheet<ChebyshevModel>> {
        self.over(&|x| ChebyshevModel::exact(*x))
    }
}
