//! Sheets: ruled patches, most of them developable.

use super::{Planes, Point, Rail};
use crate::basis::Shape;
use crate::coordinate::Coordinate;
use crate::developable::{
    Bounds, Branch, Certificate, ConnectingPatch, EnclosedCertificate, EnvelopingPatch, Gap,
    HermiteCone, Reason, Regularity, TangentPatch, certify, connect, enclose, oblique_image,
    prove_regular,
};
use crate::error::Result;
use crate::model::Model;
use crate::pattern::{FlatPattern, PatternResult, unroll};
use crate::planes::Plane;
use crate::scalars::{Over, exact_ball};
use crate::surface::{Part, Partials, Principal, Rails, RuledSurface, Surface, partials_between};
use torse_algebra::{Ball, Jet};

/// What part of each ruling of an envelope belongs to a sheet.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Cut(Bounds<f64>);

impl Cut {
    /// The part between two planes.
    #[must_use]
    pub fn between(first: Plane<f64>, second: Plane<f64>) -> Self {
        Self(Bounds::Planes([first, second]))
    }

    /// A range of the ruling parameter of gbt-developable eq. (3.7), in units of `a x a'`.
    #[must_use]
    pub fn range(from: f64, to: f64) -> Self {
        Self(Bounds::Range([from, to]))
    }
}

/// How much work bounds and proofs may take, and how close they should come.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Budget {
    /// Bits after the point, for a sheet of the size of one; smaller sheets get more.
    pub bits: usize,
    /// The relative width of bounds at which one is content.
    pub accuracy: f64,
    /// The number of intervals of the parameter.
    pub cells: usize,
}

/// 128 bits, a tenth, 64 intervals: a third of a second or less for the examples of the papers.
impl Default for Budget {
    fn default() -> Self {
        Self {
            bits: 128,
            accuracy: 0.1,
            cells: 64,
        }
    }
}

/// What [`Sheet::between`] found.
#[derive(Debug, Clone, PartialEq)]
pub struct Connected {
    /// The sheet of the chosen branch; `None` when no developable touches both rails.
    pub sheet: Option<Sheet>,
    /// Why it was chosen.
    pub reason: Option<Reason>,
    /// All branches.
    pub branches: Vec<Branch>,
    /// What the chosen branch leaves of the rails, with the twist of the best ruling there.
    pub gaps: Vec<Gap>,
}

/// A surface of straight rulings between two rails with a common parameter `u` in [0, 1]; `v` in [0, 1] runs
/// along the rulings.
///
/// It is one type for all ways to make one; the generic patches are below it, and [`Rails`] is what both
/// share.
#[derive(Debug, Clone, PartialEq)]
pub struct Sheet<S = f64> {
    construction: Construction<S>,
}

/// How a sheet is made: the patch of the generic layer that it is.
#[derive(Debug, Clone, PartialEq)]
pub enum Construction<S = f64> {
    /// Rulings that join points of equal parameter.
    Ruled(Box<RuledSurface<Rail<S>, Rail<S>>>),
    /// The envelope of a family of planes.
    Envelope(Box<EnvelopingPatch<Shape<S>, S>>),
    /// The tangents of an edge of regression.
    Tangent(Box<TangentPatch<Shape<S>, S>>),
    /// A developable that touches two rails.
    Connecting(Box<ConnectingPatch<Rail<S>, Rail<S>>>),
    /// The rulings of another sheet in a parameter interval.
    Part(Box<Part<Sheet<S>, S>>),
}

impl<S> Sheet<S> {
    /// How the sheet is made.
    #[must_use]
    pub fn construction(&self) -> &Construction<S> {
        &self.construction
    }
}

impl Sheet {
    /// The ruled surface whose rulings join points of equal parameter; developable or not, [`Sheet::certify`]
    /// tells.
    #[must_use]
    pub fn ruled(first: Rail, second: Rail) -> Self {
        let construction = Construction::Ruled(Box::new(RuledSurface::new(first, second)));
        Self { construction }
    }

    /// The developables that touch two free rails, and the best of them: see [`connect`].
    ///
    /// # Errors
    /// As [`connect`].
    pub fn between(first: &Rail, second: &Rail) -> Result<Connected> {
        let found = connect(first, second)?;
        Ok(Connected {
            sheet: found.chosen().map(|patch| Self {
                construction: Construction::Connecting(Box::new(patch)),
            }),
            reason: found.choice().map(|(_, reason)| reason),
            branches: found.branches().to_vec(),
            gaps: found.gaps().to_vec(),
        })
    }

    /// The envelope of a family of planes within bounds: developable by construction.
    ///
    /// # Errors
    /// As [`EnvelopingPatch::new`].
    pub fn envelope(planes: &Planes, cut: Cut) -> Result<Self> {
        let patch = EnvelopingPatch::new(planes.family().clone(), cut.0)?;
        let construction = Construction::Envelope(Box::new(patch));
        Ok(Self { construction })
    }

    /// The tangents of the edge of regression of a family of planes, from `from` to `to` times its derivative.
    ///
    /// # Errors
    /// As [`TangentPatch::new`].
    pub fn tangent(planes: &Planes, from: f64, to: f64) -> Result<Self> {
        let patch = TangentPatch::new(planes.family().clone(), [from, to])?;
        let construction = Construction::Tangent(Box::new(patch));
        Ok(Self { construction })
    }

    /// A Hermite cone between parallel planes.
    ///
    /// # Errors
    /// As [`HermiteCone::patch`].
    pub fn cone(cone: &HermiteCone<f64>) -> Result<Self> {
        let patch = cone.patch()?;
        Ok(Self::ruled(
            patch.first().clone().into(),
            patch.second().clone().into(),
        ))
    }

    /// The part of a Hermite cone between its curve `q` and an oblique plane.
    ///
    /// # Errors
    /// As [`oblique_image`].
    pub fn cone_cut(cone: &HermiteCone<f64>, plane: Plane<f64>) -> Result<Self> {
        let image = oblique_image(cone, &plane)?;
        Ok(Self::ruled(Rail::hermite(&cone.q)?, image.into()))
    }

    /// The rulings from `from` to `to`, with a parameter of their own in [0, 1].
    ///
    /// # Errors
    /// As [`Part::new`].
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
        let part = Part::new(self.clone(), from, to)?;
        let construction = Construction::Part(Box::new(part));
        Ok(Self { construction })
    }

    /// The ends of the ruling at `u`.
    ///
    /// # Errors
    /// What the sheet refuses at this parameter: no ruling, or one that is parallel to a cutting plane.
    pub fn ruling(&self, u: f64) -> Result<[Point; 2]> {
        self.ruling_ends(&u)
    }

    /// The point at `(u, v)`.
    ///
    /// # Errors
    /// As [`Sheet::ruling`].
    pub fn point(&self, u: f64, v: f64) -> Result<Point> {
        let [p, q] = self.ruling(u)?;
        Ok(crate::vector::lerp(&p, &q, &v))
    }

    /// The principal curvatures at `(u, v)`, the larger first.
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
    pub fn certify(&self, rulings: usize) -> Result<Certificate> {
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
    /// let proved = sheet.enclose(Budget::default())?;
    /// assert_eq!((proved.is_regular(), proved.twist.high), (Some(true), 0.0));
    /// assert!(proved.clearance.low <= 0.5 && 0.5 <= proved.clearance.high);
    /// # Ok::<(), torse_geometry::GeometryError>(())
    /// ```
    pub fn enclose(&self, budget: Budget) -> Result<EnclosedCertificate> {
        let (sheet, bits) = self.enclosed(budget)?;
        Ok(enclose(&sheet, bits, budget.accuracy, budget.cells))
    }

    /// Proves or refutes that the sheet is regular, for the exact numbers of the control data.
    ///
    /// # Errors
    /// As [`Sheet::enclose`].
    pub fn prove_regular(&self, budget: Budget) -> Result<Regularity> {
        let (sheet, bits) = self.enclosed(budget)?;
        // One evaluation of first derivatives each, where an enclosure takes two of order six.
        Ok(prove_regular(&sheet, bits, budget.cells.saturating_mul(16)))
    }

    /// The flat pattern of the sheet: the outline within `tolerance` (a length), with `rulings` rulings. More can be
    /// asked of it with [`Unrolling`](crate::pattern::Unrolling).
    ///
    /// # Errors
    /// As [`unroll`].
    pub fn unroll(&self, rulings: usize, tolerance: f64) -> PatternResult<FlatPattern> {
        unroll(self, rulings, tolerance)
    }

    /// The sheet over balls, with bits that fit its size.
    fn enclosed(&self, budget: Budget) -> Result<(Sheet<Ball>, usize)> {
        let [p, q] = self.ruling(0.5)?;
        let length = crate::vector::norm(&crate::vector::sub(&q, &p));
        let small = length.exponent().unwrap_or(0).min(0).unsigned_abs();
        let bits = budget
            .bits
            .saturating_add(usize::try_from(small).unwrap_or(0));
        Ok((self.over(&|x| exact_ball(*x, bits))?, bits))
    }
}

/// A connecting patch has rails over these scalars alone, hence no sheet has them over all.
macro_rules! rails_over {
    ($($scalar:ty),*) => {$(
        impl Rails<$scalar> for Sheet<$scalar> {
            fn rail_jets(&self, x: &$scalar, order: usize) -> Result<[[Jet<$scalar>; 3]; 2]> {
                match &self.construction {
                    Construction::Ruled(patch) => patch.rail_jets(x, order),
                    Construction::Envelope(patch) => patch.rail_jets(x, order),
                    Construction::Tangent(patch) => patch.rail_jets(x, order),
                    Construction::Connecting(patch) => patch.rail_jets(x, order),
                    Construction::Part(part) => part.rail_jets(x, order),
                }
            }

            fn ruling_ends(&self, x: &$scalar) -> Result<[[$scalar; 3]; 2]> {
                match &self.construction {
                    Construction::Ruled(patch) => patch.ruling_ends(x),
                    Construction::Envelope(patch) => patch.ruling_ends(x),
                    Construction::Tangent(patch) => patch.ruling_ends(x),
                    Construction::Connecting(patch) => patch.ruling_ends(x),
                    Construction::Part(part) => part.ruling_ends(x),
                }
            }

            fn ends_and_slopes(&self, x: &$scalar) -> Result<[[[$scalar; 3]; 2]; 2]> {
                match &self.construction {
                    Construction::Ruled(patch) => patch.ends_and_slopes(x),
                    Construction::Envelope(patch) => patch.ends_and_slopes(x),
                    Construction::Tangent(patch) => patch.ends_and_slopes(x),
                    Construction::Connecting(patch) => patch.ends_and_slopes(x),
                    Construction::Part(part) => part.ends_and_slopes(x),
                }
            }

            fn is_developable_by_construction(&self) -> bool {
                match &self.construction {
                    Construction::Ruled(_) => false,
                    Construction::Part(part) => part.is_developable_by_construction(),
                    _ => true,
                }
            }
        }
    )*};
}

rails_over!(f64, Ball, Model);

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
            Construction::Envelope(patch) => Construction::Envelope(Box::new(patch.over(convert)?)),
            Construction::Tangent(patch) => Construction::Tangent(Box::new(patch.over(convert)?)),
            Construction::Connecting(patch) => {
                Construction::Connecting(Box::new(patch.over(convert)?))
            }
            Construction::Part(part) => Construction::Part(Box::new(part.over(convert)?)),
        };
        Ok(Sheet { construction })
    }
}
