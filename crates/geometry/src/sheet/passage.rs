//! Several sheets in space.

use super::Sheet;
use crate::developable::{PieceIntersection, SheetPiercing, piece_intersection, piercings};
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

    /// For each two pieces, each of several sheets, a point at which two of their sheets are proved to pass through each other,
    /// inside of both; the first that is `wanted`, which knows what is cut out of them. That none is found does not say that
    /// there is none.
    ///
    /// # Errors
    /// As [`Sheet::piece_intersection`].
    pub fn piercings(
        pieces: &[Vec<&Self>],
        wanted: impl Fn(&SheetPiercing) -> bool,
    ) -> Result<Vec<SheetPiercing>> {
        let models = pieces.iter().flatten().map(|sheet| sheet.models());
        let models = models.collect::<Result<Vec<_>>>()?;
        Ok(piercings(pieces, &models, wanted))
    }

    fn models(&self) -> Result<Sheet<ChebyshevModel>> {
        self.over(&|x| ChebyshevModel::exact(*x))
    }
}
