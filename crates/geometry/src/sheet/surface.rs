//! Sheets: ruled patches, most of them developable.

use super::exact::is_exactly_developable;
use super::{ConePatch, Cut, CylinderPatch, MeasureBudget, Planes, Point, Rail, SweptEdge};
use crate::basis::BasisShape;
use crate::coordinate::Coordinate;
use crate::developable::{
    Branch, BranchReason, ConnectingPatch, EnclosedCertificate, EnvelopingPatch, HermiteCone,
    PatchCertificate, RailGap, Regularity, SelfIntersection, TangentPatch, certify, connect,
    enclose, enclose_by_models, prove_regular, regular_end, self_intersection,
};
use crate::error::Result;
use crate::model::ChebyshevModel;
use crate::over::Over;
use crate::pattern::{FlatPattern, PatternResult, Unrolling};
use crate::planes::Plane;
use crate::scalars::exact_ball;
use crate::surface::{
    Partials, PatchPart, Principal, RailKind, Rails, RuledSurface, Surface, partials_between,
};
use torse_algebra::Ball;

/// What [`Sheet::between`] found.
#[derive(Debug, Clone, PartialEq)]
pub struct ConnectedSheets {
    /// The sheet of the chosen branch; `None` when no developable touches both rails.
    pub sheet: Option<Sheet>,
    /// Why it was chosen.
    pub reason: Option<BranchReason>,
    /// All branches.
    pub branches: Vec<Branch>,
    /// The sheets of all branches, in their order.
    pub sheets: Vec<Sheet>,
    /// What the chosen branch leaves of the rails, with the twist of the best ruling there.
    pub gaps: Vec<RailGap>,
}

/// A surface of straight rulings between two rails with a common parameter `u` in [0, 1]; `v` in [0, 1] runs
/// along the rulings.
///
/// It is one type for all ways to make one; the generic patches are below it, and [`Rails`] is what both
/// share.
#[derive(Debug, Clone, PartialEq)]
pub struct Sheet<S = f64> {
    pub(super) construction: Construction<S>,
    /// Whether `det(P', Q', Q - P)` is proved to be zero on the exact control data, though not by the construction.
    pub(super) exact: bool,
}

/// How a sheet is made: the patch of the generic layer that it is.
#[derive(Debug, Clone, PartialEq)]
pub enum Construction<S = f64> {
    /// Rulings that join points of equal parameter.
    Ruled(Box<RuledSurface<Rail<S>, Rail<S>>>),
    /// Straight lines in one direction.
    Cylinder(Box<CylinderPatch<S>>),
    /// Straight lines through one point.
    Cone(Box<ConePatch<S>>),
    /// The envelope of a family of planes.
    Envelope(Box<EnvelopingPatch<BasisShape<S>, S>>),
    /// The tangents of an edge of regression.
    Tangent(Box<TangentPatch<BasisShape<S>, S>>),
    /// A developable that touches two rails.
    Connecting(Box<ConnectingPatch<Rail<S>, Rail<S>>>),
    /// The rulings of another sheet in a parameter interval.
    Part(Box<PatchPart<Sheet<S>, S>>),
}

impl<S> From<Construction<S>> for Sheet<S> {
    fn from(construction: Construction<S>) -> Self {
        Self {
            construction,
            exact: false,
        }
    }
}

impl<S> Sheet<S> {
    /// Returns how the sheet is made.
    #[must_use]
    pub fn construction(&self) -> &Construction<S> {
        &self.construction
    }
}

impl Sheet {
    /// Returns the ruled surface whose rulings join points of equal parameter; developable or not, [`Sheet::certify`]
    /// tells. A rail that is a point makes it a cone.
    #[must_use]
    pub fn ruled(first: Rail, second: Rail) -> Self {
        let point = |rail: &Rail| {
            let point = rail.end_kinds() == RailKind::Point;
            point.then(|| rail.point(0.0).ok()).flatten()
        };
        let (whole, none) = (SweptEdge::Share(1.0), SweptEdge::Share(0.0));
        let cone = match (point(&first), point(&second)) {
            (Some(apex), None) => ConePatch::new(&second, apex, [none, whole]).ok(),
            (None, Some(apex)) => ConePatch::new(&first, apex, [whole, none]).ok(),
            _ => None,
        };
        if let Some(cone) = cone {
            return Construction::Cone(Box::new(cone)).into();
        }
        let exact = is_exactly_developable(&first, &second);
        let construction = Construction::Ruled(Box::new(RuledSurface::new(first, second)));
        Self {
            construction,
            exact,
        }
    }

    /// Returns the part of a cylinder over a curve between two edges: see [`CylinderPatch`].
    ///
    /// # Errors
    /// As [`CylinderPatch::new`].
    pub fn cylinder(curve: &Rail, direction: Point, edges: [SweptEdge; 2]) -> Result<Self> {
        let patch = CylinderPatch::new(curve, direction, edges)?;
        Ok(Construction::Cylinder(Box::new(patch)).into())
    }

    /// Returns the part of the cone over a curve between two edges: see [`ConePatch`].
    ///
    /// # Errors
    /// As [`ConePatch::new`].
    pub fn cone(curve: &Rail, apex: Point, edges: [SweptEdge; 2]) -> Result<Self> {
        let patch = ConePatch::new(curve, apex, edges)?;
        Ok(Construction::Cone(Box::new(patch)).into())
    }

    /// Returns the developables that touch two free rails, and the best of them: see [`connect`].
    ///
    /// # Errors
    /// As [`connect`].
    pub fn between(first: &Rail, second: &Rail) -> Result<ConnectedSheets> {
        let found = connect(first, second)?;
        Ok(ConnectedSheets {
            sheet: found
                .chosen()
                .map(|patch| Construction::Connecting(Box::new(patch)).into()),
            sheets: (0..found.branches().len())
                .filter_map(|index| found.patch(index))
                .map(|patch| Construction::Connecting(Box::new(patch)).into())
                .collect(),
            reason: found.choice().map(|(_, reason)| reason),
            branches: found.branches().to_vec(),
            gaps: found.gaps().to_vec(),
        })
    }

    /// Returns the envelope of a family of planes within bounds: developable by construction.
    ///
    /// # Errors
    /// As [`EnvelopingPatch::new`].
    pub fn envelope(planes: &Planes, cut: Cut) -> Result<Self> {
        let patch = EnvelopingPatch::new(planes.family().clone(), cut.0)?;
        Ok(Construction::Envelope(Box::new(patch)).into())
    }

    /// Returns the tangents of the edge of regression of a family of planes, from `from` to `to` times its derivative.
    ///
    /// # Errors
    /// As [`TangentPatch::new`].
    pub fn tangent(planes: &Planes, from: f64, to: f64) -> Result<Self> {
        let patch = TangentPatch::new(planes.family().clone(), [from, to])?;
        Ok(Construction::Tangent(Box::new(patch)).into())
    }

    /// Returns a Hermite cone between parallel planes, from its curve `p` to its curve `q`: the cone over `q` with the
    /// summit as its apex, of which `p` is the image in the ratio of the cone.
    ///
    /// # Errors
    /// As [`ConePatch::new`].
    pub fn hermite_cone(cone: &HermiteCone<f64>) -> Result<Self> {
        let edges = [SweptEdge::Share(1.0 / cone.ratio), SweptEdge::Share(1.0)];
        Self::cone(&Rail::hermite(&cone.q)?, cone.summit, edges)
    }

    /// Returns the part of a Hermite cone between its curve `q` and an oblique plane.
    ///
    /// # Errors
    /// As [`ConePatch::new`].
    pub fn cut_hermite_cone(cone: &HermiteCone<f64>, plane: Plane<f64>) -> Result<Self> {
        let edges = [SweptEdge::Share(1.0), SweptEdge::Cut(plane)];
        Self::cone(&Rail::hermite(&cone.q)?, cone.summit, edges)
    }

    /// Of a cone that reaches its apex the half that is farther from it: on a ruling from an apex the normal grows with
    /// the distance, so it vanishes on that half or nowhere but at the apex. `None` of any other sheet.
    #[must_use]
    pub fn away_from_apex(&self) -> Option<Self> {
        match &self.construction {
            Construction::Cone(patch) if patch.end_kinds().apexes().contains(&true) => {
                Some(Construction::Cone(Box::new(patch.away_from_apex())).into())
            }
            Construction::Part(part) => {
                let [from, to] = *part.range();
                part.whole().away_from_apex()?.part(from, to).ok()
            }
            _ => None,
        }
    }

    /// Returns the rulings from `from` to `to`, with a parameter of their own in [0, 1].
    ///
    /// # Errors
    /// As [`PatchPart::new`].
    ///
    /// ```
    /// use torse_geometry::prelude::*;
    /// let arc = |z: f64| Rail::ellipse_arc([0.0, 0.0, z], [2.0, 0.0, z], [0.0, 2.0, z]);
    /// let half = Sheet::ruled(arc(0.0)?, arc(3.0)?).part(0.0, 0.5)?;
    /// let area = half.inspect(32)?.area;
    /// assert!((area - 1.5 * std::f64::consts::PI).abs() < 1e-9);
    /// # Ok::<(), torse_geometry::GeometryError>(())
    /// ```
    pub fn part(&self, from: f64, to: f64) -> Result<Self> {
        let part = PatchPart::new(self.clone(), from, to)?;
        Ok(Construction::Part(Box::new(part)).into())
    }

    /// Returns the ends of the ruling at `u`.
    ///
    /// # Errors
    /// What the sheet refuses at this parameter: no ruling, or one that is parallel to a cutting plane.
    pub fn ruling(&self, u: f64) -> Result<[Point; 2]> {
        self.ruling_ends(&u)
    }

    /// Returns the point at `(u, v)`.
    ///
    /// # Errors
    /// As [`Sheet::ruling`].
    pub fn point(&self, u: f64, v: f64) -> Result<Point> {
        let [p, q] = self.ruling(u)?;
        Ok(crate::vector::lerp(&p, &q, &v))
    }

    /// Returns the principal curvatures at `(u, v)`, the larger first.
    ///
    /// # Errors
    /// As [`Sheet::ruling`], and [`GeometryError::Degenerate`](crate::GeometryError::Degenerate) where the
    /// normal vanishes.
    pub fn principal(&self, u: f64, v: f64) -> Result<[Principal; 2]> {
        self.forms(&u, &v)?.principal()
    }

    /// Measures how developable and how regular the sheet is: estimates on `rulings` rulings or more.
    ///
    /// # Errors
    /// As [`certify`].
    pub fn certify(&self, rulings: usize) -> Result<PatchCertificate> {
        certify(self, rulings)
    }

    /// Encloses what [`Sheet::certify`] measures: bounds that hold for the exact numbers of the control data.
    ///
    /// # Errors
    /// Where the control data have no enclosure of these bits.
    ///
    /// ```
    /// use torse_geometry::prelude::*;
    /// let planes = Planes::bernstein(&[[0., 0., 1., 0.], [0., -1., 1., 0.], [1., -2., 1., 0.], [3., -3., 1., 1.]])?;
    /// let sheet = Sheet::tangent(&planes, 0.5, 1.0)?;
    /// let proved = sheet.enclose(MeasureBudget::default())?;
    /// assert_eq!((proved.is_regular(), proved.twist.high), (Some(true), 0.0));
    /// assert!(proved.clearance.low <= 0.5 && 0.5 <= proved.clearance.high);
    /// # Ok::<(), torse_geometry::GeometryError>(())
    /// ```
    pub fn enclose(&self, budget: MeasureBudget) -> Result<EnclosedCertificate> {
        if let Some((near, _)) = self.near_origin() {
            return near.enclose(budget);
        }
        let models = self.over(&|x| ChebyshevModel::exact(*x))?;
        // They are cheap: closer than asked for.
        let found = enclose_by_models(&models, 0.05 * budget.accuracy, budget.cells);
        if found.is_regular().is_some() {
            return Ok(found);
        }
        // What f64 does not tell from zero more bits may.
        let (sheet, bits) = self.enclosed(budget)?;
        Ok(enclose(&sheet, bits, budget.accuracy, budget.cells))
    }

    /// Proves or refutes that the sheet is regular, for the exact numbers of the control data.
    ///
    /// # Errors
    /// As [`Sheet::enclose`].
    pub fn prove_regular(&self, budget: MeasureBudget) -> Result<Regularity> {
        let (sheet, bits) = self.enclosed(budget)?;
        // One evaluation of first derivatives each, where an enclosure takes two of order six.
        Ok(prove_regular(&sheet, bits, budget.cells.saturating_mul(16)))
    }

    /// Proves that the sheet is regular near a special end: between its first ruling (or its last, if `last`) and the
    /// ruling at parameter distance `width`, without the special ruling itself. An end is special if it is a tip, or if
    /// both edges stand still there.
    ///
    /// Returns a bound, in radians, of the angle between the tangent planes at the two ends of a ruling in that part;
    /// `None` if nothing is proved, and at an ordinary end.
    ///
    /// # Errors
    /// Where the control data have no models.
    ///
    /// ```
    /// use torse_geometry::prelude::*;
    /// // A gore: a cylinder between two planes that meet at its first ruling.
    /// let profile = Rail::bezier(&[[0.0, 0.0, 0.0], [60.0, 0.0, 50.0], [200.0, 0.0, 20.0]])?;
    /// let edges = [0.25, -0.25].map(|slope| SweptEdge::Cut([slope, 1.0, 0.0, 0.0]));
    /// let gore = Sheet::cylinder(&profile, [0.0, 1.0, 0.0], edges)?;
    /// assert_eq!(gore.regular_end(false, 0.001)?, Some(0.0));
    /// assert_eq!(gore.regular_end(true, 0.001)?, None);
    /// # Ok::<(), torse_geometry::GeometryError>(())
    /// ```
    pub fn regular_end(&self, last: bool, width: f64) -> Result<Option<f64>> {
        let models = self.over(&|x| ChebyshevModel::exact(*x))?;
        let kinds = Rails::<f64>::end_kinds(self);
        Ok(regular_end(&models, kinds, last, width))
    }

    /// Returns whether the sheet passes through itself in space.
    ///
    /// # Errors
    /// Where the control data have no models.
    ///
    /// ```
    /// use torse_geometry::prelude::*;
    /// let arc = |z: f64| Rail::ellipse_arc([0.0, 0.0, z], [2.0, 0.0, z], [0.0, 2.0, z]);
    /// let sheet = Sheet::ruled(arc(0.0)?, arc(3.0)?);
    /// assert_eq!(sheet.self_intersection()?, SelfIntersection::Free);
    /// # Ok::<(), torse_geometry::GeometryError>(())
    /// ```
    pub fn self_intersection(&self) -> Result<SelfIntersection> {
        if let Some((near, origin)) = self.near_origin() {
            return Ok(near.self_intersection()?.moved(origin));
        }
        let models = self.over(&|x| ChebyshevModel::exact(*x))?;
        Ok(self_intersection(self, &models))
    }

    /// Returns the flat pattern of the sheet: the outline within `tolerance` (a length), with `rulings` rulings. More
    /// can be asked of it with [`Unrolling`](crate::pattern::Unrolling).
    ///
    /// # Errors
    /// As [`crate::pattern::Unrolling::unroll`].
    pub fn unroll(&self, rulings: usize, tolerance: f64) -> PatternResult<FlatPattern> {
        self.unroll_with(&Unrolling::within(tolerance).rulings(rulings))
    }

    /// Returns the flat pattern that is asked for, wherever in space the sheet lies.
    ///
    /// # Errors
    /// As [`Unrolling::unroll`].
    pub fn unroll_with(&self, unrolling: &Unrolling) -> PatternResult<FlatPattern> {
        match self.near_origin() {
            None => unrolling.unroll(self),
            Some((near, origin)) => Ok(unrolling.unroll(&near)?.moved_in_space(origin)),
        }
    }

    /// Returns the sheet over balls, with bits that fit its size.
    fn enclosed(&self, budget: MeasureBudget) -> Result<(Sheet<Ball>, usize)> {
        let [p, q] = self.ruling(0.5)?;
        let length = crate::vector::norm(&crate::vector::sub(&q, &p));
        let small = length.exponent().unwrap_or(0).min(0).unsigned_abs();
        let bits = budget
            .bits
            .saturating_add(usize::try_from(small).unwrap_or(0));
        Ok((self.over(&|x| exact_ball(*x, bits))?, bits))
    }
}

impl Surface<f64> for Sheet {
    fn partials(&self, u: &f64, v: &f64, order: usize) -> Result<Partials<f64>> {
        partials_between(self, u, v, order)
    }
}

impl<S: Coordinate, T: Coordinate> Over<S, T> for Sheet<S> {
    type Object = Sheet<T>;

    fn over(&self, convert: &impl Fn(&S) -> T) -> Result<Sheet<T>> {
        let construction = match &self.construction {
            Construction::Ruled(patch) => Construction::Ruled(Box::new(patch.over(convert)?)),
            Construction::Cylinder(patch) => Construction::Cylinder(Box::new(patch.over(convert)?)),
            Construction::Cone(patch) => Construction::Cone(Box::new(patch.over(convert)?)),
            Construction::Envelope(patch) => Construction::Envelope(Box::new(patch.over(convert)?)),
            Construction::Tangent(patch) => Construction::Tangent(Box::new(patch.over(convert)?)),
            Construction::Connecting(patch) => {
                Construction::Connecting(Box::new(patch.over(convert)?))
            }
            Construction::Part(part) => Construction::Part(Box::new(part.over(convert)?)),
        };
        let exact = self.exact;
        Ok(Sheet {
            construction,
            exact,
        })
    }
}
