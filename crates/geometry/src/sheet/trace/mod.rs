//! Curves on sheets: followed from ruling to ruling, with bounds for what they miss.
//!
//! A curve on a sheet is known by polynomials for its places `[u, v]` ([`SheetArc`]). Three kinds are followed: straight
//! lines of the parameters, curves in space that lie on the sheets, and the curves in which rulings of other sheets pierce
//! them. Of the last two each arc is proved: near the polynomial there is, for each parameter of the arc, exactly one
//! solution of the equations (the test of Krawczyk, with [`ChebyshevModel`]s, for all parameters at once), and none of it
//! is farther from the polynomial than the arc says.
//!
//! That no other curve exists, and that nothing lies in front of the first, is looked at on eight rulings of each arc, not
//! proved.

mod arc;
mod follow;
mod search;
mod source;

pub use arc::SheetArc;

use super::{PiecewiseRail, Point, Sheet};
use crate::error::GeometryError;
use crate::model::ChebyshevModel;
use crate::over::Over;
use source::{Lying, Piercing};

/// Which of the places count at which a ruling pierces sheets.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum PiercingReach {
    /// All between the ends of the ruling.
    Ruling,
    /// The first on the half line that begins at its first end.
    First,
}

/// Why a curve is not followed.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum TraceError {
    /// A sheet has no value.
    #[error(transparent)]
    Geometry(#[from] GeometryError),
    /// What should close does not.
    #[error("it does not close: its ends are {gap:.4} mm apart")]
    NotClosed {
        /// The distance of its ends.
        gap: f64,
    },
    /// A ruling does not reach the sheets.
    #[error("the line through {} meets no point of the sheet", point(from))]
    Misses {
        /// Where the line begins.
        from: Point,
    },
    /// A ruling ends before it reaches the sheets, or behind them.
    #[error("the ruling that meets the sheet at {} ends before", point(at))]
    TooShort {
        /// Where its line meets them.
        at: Point,
    },
    /// Some rulings pierce the sheets more often than others.
    #[error("the sheet is passed {} times at one place and {} times at another, which {} shows", counts[0], counts[1], point(at))]
    Uneven {
        /// How often.
        counts: [usize; 2],
        /// A point of the ruling that differs.
        at: Point,
    },
    /// Another part of the sheets is in front of the curve.
    #[error("another part of the sheet is in front of it at {}", point(at))]
    Hidden {
        /// Where.
        at: Point,
    },
    /// The curve leaves the sheets.
    #[error("it leaves the sheet at {}", point(at))]
    Leaves {
        /// Where.
        at: Point,
    },
    /// A point does not lie on the sheets.
    #[error("its point {} is {distance:.4} mm from the sheet", point(at))]
    NotOnSheet {
        /// The point.
        at: Point,
        /// Its distance.
        distance: f64,
    },
    /// The curve turns back, or touches, where nothing is proved.
    #[error(
        "it was followed as far as {}, where it touches the sheet or turns back",
        point(at)
    )]
    Undecided {
        /// How far it was followed.
        at: Point,
    },
}

fn point(at: &Point) -> String {
    let [x, y, z] = at.map(|c| format!("{:.3}", c + 0.0));
    format!("({x}, {y}, {z})")
}

/// Sheets on which curves are followed.
///
/// ```
/// use torse_geometry::prelude::*;
/// // A pipe of radius 3 in two halves; one of radius 1 comes down on it.
/// let half = |from: [f64; 3]| Rail::from(torse_geometry::curve::EllipticHelix::about(
///     [0.0, 0.0, 0.0], [1.0, 0.0, 0.0], from, 180.0, 0.0).unwrap());
/// let edges = [SweptEdge::Share(-5.0), SweptEdge::Share(5.0)];
/// let pipe = [[0.0, 3.0, 0.0], [0.0, -3.0, 0.0]].map(|from| Sheet::cylinder(&half(from), [1.0, 0.0, 0.0], edges).unwrap());
/// let rim = Rail::from(torse_geometry::curve::EllipticHelix::about(
///     [0.0, 0.0, 6.0], [0.0, 0.0, 1.0], [1.0, 0.0, 6.0], 360.0, 0.0)?);
/// let branch = Sheet::cylinder(&rim, [0.0, 0.0, -6.0], [SweptEdge::Share(0.0), SweptEdge::Share(1.0)])?;
/// let tracer = SheetTracer::new(&[&pipe[0], &pipe[1]])?;
/// let found = tracer.pierced(&[&branch], PiercingReach::Ruling, 1e-3)?;
/// assert_eq!(found.len(), 1);
/// // The saddle: x = cos t, y = sin t, z = sqrt(9 - y^2).
/// for arc in &found[0] {
///     assert!(arc.off() < 1e-8);
///     let [u, v] = arc.place(0.5);
///     let [x, y, z] = pipe[arc.sheet()].point(u, v)?;
///     assert!((x.hypot(y) - 1.0).abs() < 1e-9 && (z - (9.0 - y * y).sqrt()).abs() < 1e-9);
/// }
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub struct SheetTracer<'a> {
    sheets: Vec<&'a Sheet>,
    models: Vec<Sheet<ChebyshevModel>>,
}

type Traced<T> = std::result::Result<T, TraceError>;

impl<'a> SheetTracer<'a> {
    /// Returns what follows curves on these sheets, which may be joined along their first and last rulings.
    ///
    /// # Errors
    /// Where a sheet has no models.
    pub fn new(sheets: &[&'a Sheet]) -> Traced<Self> {
        let models = sheets
            .iter()
            .map(|sheet| sheet.over(&|x| ChebyshevModel::exact(*x)));
        Ok(Self {
            sheets: sheets.to_vec(),
            models: models.collect::<Result<_, _>>()?,
        })
    }

    /// Returns the closed curves in which the rulings of the sheets `through`, one after the other and all the way around,
    /// pierce these sheets. Ends that are no farther apart than `joined` are one point.
    ///
    /// # Errors
    /// [`TraceError`].
    pub fn pierced(
        &self,
        through: &[&Sheet],
        reach: PiercingReach,
        joined: f64,
    ) -> Traced<Vec<Vec<SheetArc>>> {
        let sources = through
            .iter()
            .map(|sheet| Piercing::new(sheet, reach, joined));
        let sources: Vec<Piercing<'_>> = sources.collect::<Traced<_>>()?;
        let first = sources.first().map(|source| source.hits(self, 0.0));
        let starts = first.transpose()?.unwrap_or_default();
        for source in &sources {
            for y in [0.0, 0.25, 0.5, 0.75, 1.0] {
                let met = source.hits(self, y)?.len();
                if met != starts.len() {
                    let counts = [starts.len(), met];
                    let at = source.start(y)?;
                    return Err(TraceError::Uneven { counts, at });
                }
            }
        }
        let sources = sources.into_iter();
        let sources: Vec<Piercing<'_>> = sources.map(|s| s.counted(starts.len())).collect();
        starts
            .into_iter()
            .map(|start| self.around(&sources, start, joined))
            .collect()
    }

    /// Returns a closed curve that lies on these sheets: no point of it is farther from them than `within`.
    ///
    /// # Errors
    /// [`TraceError`].
    pub fn lying(&self, curve: &PiecewiseRail, within: f64) -> Traced<Vec<SheetArc>> {
        let rails = curve.rails()?;
        let sources = rails.iter().map(|rail| Lying::new(rail, within));
        let sources: Vec<Lying<'_>> = sources.collect::<Traced<_>>()?;
        let Some(first) = sources.first() else {
            return Ok(Vec::new());
        };
        let start = first.nearest(self, 0.0)?;
        self.around(&sources, start, within)
    }

    /// Returns the line from one place to another on a sheet that is straight in the parameters.
    ///
    /// # Errors
    /// [`TraceError`].
    pub fn straight(&self, sheet: usize, from: [f64; 2], to: [f64; 2]) -> Traced<Vec<SheetArc>> {
        let Some(model) = self.models.get(sheet) else {
            return Ok(Vec::new());
        };
        let at = |t: f64| [0, 1].map(|i| from[i] + t * (to[i] - from[i]));
        let mut open = vec![[0.0, 1.0]];
        let mut arcs = Vec::new();
        while let Some([low, high]) = open.pop() {
            let (a, b) = (at(low), at(high));
            let place = [0, 1].map(|i| ChebyshevModel::identity(a[i], b[i]).polynomial());
            match SheetArc::new(model, sheet, place, 0.0) {
                Some(arc) => arcs.push(arc),
                None if high - low < LEAST_STEP => {
                    let at = self.sheets[sheet].point(a[0], a[1])?;
                    return Err(TraceError::Undecided { at });
                }
                None => {
                    let middle = 0.5 * (low + high);
                    open.extend([[middle, high], [low, middle]]);
                }
            }
        }
        Ok(arcs)
    }
}

/// The shortest arcs, as shares of a sheet.
const LEAST_STEP: f64 = 1.0 / 65536.0;
