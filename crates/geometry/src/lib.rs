//! Curves, surfaces and developables with shape parameters, written once for every scalar.
//!
//! Whoever works with f64 alone takes [`prelude`]: rails, families of planes and sheets, plain numbers as
//! arguments, one import. It stands on the generic layer, which the rest of this page is about:
//!
//! ```
//! use torse_geometry::prelude::*;
//! let chine = Rail::bezier(&[[0.0, 0.0, 0.0], [2.0, 3.0, 0.0], [6.0, 0.0, 0.0]])?;
//! let deck = Rail::bezier(&[[0.5, 0.0, 2.0], [3.0, 2.0, 3.0], [6.0, -1.0, 2.0]])?;
//! let plate = Sheet::between(&chine, &deck)?.sheet.ok_or("no developable touches both rails")?;
//! assert!(plate.certify(64)?.is_regular());
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! # Guide
//!
//! Everything is built from control data by named constructors that refuse bad input with a typed
//! [`GeometryError`], and evaluates on `f64`, exact rationals, certified balls, jets and formal
//! fractions, because it is written over one trait, [`Coordinate`].
//!
//! | you want | take |
//! |---|---|
//! | a basis with shape parameters | [`Gbt`], [`Bernstein`], or implement [`Basis`] by its three seeds |
//! | a curve, its derivatives, length, curvature | [`Curve`], [`RationalCurve`], [`hermite`], [`curve`] |
//! | a surface, its partials, normal, curvatures | [`TensorSurface`], [`RuledSurface`], [`RotationSurface`], [`Surface`], [`Forms`], [`Principal`] |
//! | to exchange maps with nalgebra | [`AffineMap`] |
//! | a developable from planes | [`PlaneFamily`], then [`EnvelopingPatch`] or [`TangentPatch`]; [`PlaneFamily::edge_parameter`] says where not to cut |
//! | a developable between two curves | [`developable::connect`] finds all of them |
//! | a developable between two planes | [`HermiteCone`], [`developable::oblique_image`] |
//! | the next piece of a smooth chain | [`Continuity`], [`join::next_curve`], [`join::next_family`], [`join::next_surface`], [`join::chain`] |
//! | to know how smooth a joint is | [`join::measure_curves`], [`join::measure_families`], [`join::measure_surfaces`] |
//! | to know whether a patch can be made | [`developable::certify`] (estimates), [`developable::enclose`] (bounds), [`developable::prove_developable`], [`developable::twist_determinant`], [`developable::prove_regular`] |
//! | the flat pattern | [`pattern::unroll`], [`pattern::FlatPattern`] |
//! | a mesh, a drawing or a CAD file | the crate `torse-exchange` |
//! | a million points | [`batch`] |
//! | the same object exactly or certified | [`Over`], [`exact`], [`exact_ball`] |
//!
//! From planes to a sheet-metal drawing:
//!
//! ```
//! use torse_geometry::developable::certify;
//! use torse_geometry::pattern::unroll;
//! use torse_geometry::{PatchBounds, Continuity, EnvelopingPatch, Gbt, PlaneFamily, join};
//!
//! // Four control planes p X + q Y + r Z = s and two shape parameters.
//! let planes = vec![
//!     [7.0, -7.0, 5.0, 125.0], [-7.0, -7.0, 5.0, 120.0], [-7.0, 7.0, 5.0, 130.0], [7.0, 7.0, 5.0, 125.0],
//! ];
//! let first = PlaneFamily::new(Gbt::new(0.5, 0.25)?, planes)?;
//! // A second piece with the same planes, rulings and points of regression at the joint.
//! let second = join::next_family(
//!     &first, Gbt::new(0.0, 1.0)?, &Continuity::parametric(2, &0.0), &[[7.0, -7.0, 5.0, 125.0]],
//! )?;
//! assert_eq!(join::measure_families(&first, &second, 2)?.order_within(1e-12), Some(2));
//!
//! // The sheet between z = 0 and z = 3: is it developable, is it regular, what is its flat pattern?
//! let sheet = EnvelopingPatch::new(first, PatchBounds::Planes([[0.0, 0.0, 1.0, 0.0], [0.0, 0.0, 1.0, 3.0]]))?;
//! let certificate = certify(&sheet, 64)?;
//! assert!(certificate.is_regular() && certificate.twist.value < 1e-6);
//! let flat = unroll(&sheet, 64, 1e-6)?;
//! assert!(flat.errors().outline <= 1e-6);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! # Conformance
//!
//! What implements each numbered item of the three papers. Where the print is wrong, the item
//! implements the corrected statement and its documentation says so.
//!
//! **gbt-developable** (developable GBT-Bezier surfaces)
//!
//! | item | implemented by |
//! |---|---|
//! | Definition 1, eq. (2.1) | [`Gbt`], [`Basis::row`] |
//! | Theorem 1 (1 to 7) | [`Basis::row`], [`Basis::derivative_rows`], [`Basis::reversed`] |
//! | Definition 2, eq. (2.2) | [`Curve`] |
//! | eqs. (2.3), (2.4), corrected | [`Curve::shape_derivatives`] |
//! | eqs. (3.1) to (3.4) | [`PlaneFamily`] |
//! | eqs. (3.5), (3.6), direction, foot | [`PlaneFamily::ruling`], [`Ruling`] |
//! | eq. (3.7) | [`EnvelopingPatch`], [`Ruling::point`] |
//! | eqs. (3.8), (3.9) | [`PlaneFamily::characteristic_point`] |
//! | eq. (3.10) | [`TangentPatch`] |
//! | eqs. (3.11), (3.12) | [`Curve::start_jet`], [`Curve::end_jet`] |
//! | eq. (3.13), matrices of Sect. 3.4, corrected | [`join::from_start_jet`], [`join::from_end_jet`] |
//! | Examples 4.1, 4.2, Sect. 4.2 | [`PlaneFamily`], [`EnvelopingPatch`], [`TangentPatch`] |
//! | eq. (5.1) | [`RationalCurve`] |
//! | Theorem 2 (G1) | [`Continuity::beta`] with one value |
//! | Theorem 3 (Farin-Boehm G2) | [`Continuity::parametric`] of order two |
//! | Theorem 4 (G2-beta), corrected | [`Continuity::beta`] with two values |
//! | "necessary" in Theorems 2 to 4, corrected | [`Continuity::scaled`] |
//! | Sect. 5.4, steps 1 to 5 | [`join::next_family`], [`join::chain`] |
//! | Examples 5.1, 5.2 | [`join::next_family`] |
//!
//! **gbt-surfaces** (C1, C2 and C3 surfaces)
//!
//! | item | implemented by |
//! |---|---|
//! | Definition 1, eqs. (1), (2); Theorem 1 | [`Gbt`], [`Basis`] |
//! | Definition 2, eq. (3) | [`Curve`] |
//! | Theorem 2, eqs. (4) to (6), corrected | [`Continuity::parametric`], [`join::next_curve`] |
//! | Definition 3, eq. (7) | [`TensorSurface`] |
//! | joined surfaces: Table 1, Propositions 3.4, 3.7, last steps of Algorithms 1, 3, 4, 5 | [`join::next_surface`], [`join::measure_surfaces`] |
//! | eq. (10) | [`Basis::row`] of degree one |
//! | eqs. (8) to (12), Theorem 3, Algorithm 1, Example 3.1 | [`TensorSurface::cylinder`] |
//! | eqs. (14) to (16), Proposition 3.2, Algorithm 2, Example 3.2 | [`TensorSurface::bilinear`] |
//! | eqs. (17) to (19), Propositions 3.3, 3.4, Algorithm 3, Example 3.3 | [`RuledSurface`], [`RuledSurface::tensor`] |
//! | eqs. (20) to (25), Theorem 4, Algorithm 4, Example 3.4 | [`TensorSurface::swung`] |
//! | eqs. (27) to (31), Theorem 5, Algorithm 5, Example 3.5 | [`TensorSurface::swept`]; eq. (28) with its matrix [`TensorSurface::swept_by`] |
//! | Theorem 6, eqs. (33), (34), Algorithm 6 | [`RotationSurface::half_turn`]; as tensor products [`TensorSurface::quarter_turns`] |
//! | Proposition 3.8, corrected; Example 3.6 | [`RotationSurface::turned`], [`surface::rotation_parameter`] |
//!
//! **hermite-developable** (developable Hermite surfaces)
//!
//! | item | implemented by |
//! |---|---|
//! | eqs. (2.1), (2.2) to (2.3), (2.4) | [`hermite::cubic`], [`hermite::quartic`], [`hermite::quintic`], [`hermite::functions`] |
//! | Definitions 3.1, 3.2, eq. (3.1) | [`RuledSurface`], [`developable::certify`], [`developable::enclose`], [`developable::prove_developable`] |
//! | eqs. (3.2) to (3.4) | [`HermiteCone`], [`HermiteCone::patch`] |
//! | matrices and determinants of eqs. (3.5), (3.6), (3.7) | [`developable::cone_system`] |
//! | eq. (3.5), Sect. 3.1 | [`HermiteCone::cubic`] |
//! | eq. (3.6), Sect. 3.2, corrected | [`HermiteCone::quartic`] |
//! | eq. (3.7), Sect. 3.3 | [`HermiteCone::quintic`] |
//! | eqs. (4.1) to (4.4), Sect. 4 as printed | [`developable::oblique_image_as_printed`] |
//! | Sect. 4, what it aims at | [`developable::oblique_image`] |
//!
//! # Limits
//!
//! * Bounds and estimates: [`developable::enclose`] bounds what [`developable::certify`] estimates; values on balls are
//!   enclosures; [`curve::arc_length`] estimates its error from two step sizes. [`pattern::unroll`] of a patch whose
//!   rails can be had as models ([`ChebyshevModel`]) bounds the cut by polynomials that are proved over whole
//!   intervals; of any other it measures.
//! * A determinant that vanishes, but not by construction, is enclosed within a gap that falls with the
//!   budget; that it is zero is proved for polynomial rails over the rationals and for formal functions
//!   (with few symbols: the determinant is expanded).
#![warn(missing_docs)]

pub mod basis;
pub mod batch;
mod chebyshev;
pub mod coordinate;
pub mod curve;
pub mod developable;
mod dual;
mod dyadic;
pub mod error;
pub mod join;
mod model;
mod over;
mod parallel;
pub mod pattern;
pub mod planes;
mod scalars;
pub mod sheet;
pub mod surface;
mod symmetric;
mod turn;
pub mod vector;

/// The scalars and Taylor series of the generic layer.
pub use torse_algebra::{Ball, Fraction, Jet, Rational};

/// Everything of [`sheet`], for one import.
pub mod prelude {
    pub use crate::error::{GeometryError, Place};
    pub use crate::sheet::*;
}

pub use basis::{Basis, Bernstein, Gbt, hermite};
pub use coordinate::Coordinate;
pub use curve::{AffineMap, Curve, RationalCurve, SpaceCurve};
pub use developable::{EnvelopingPatch, HermiteCone, PatchBounds, TangentPatch};
pub use error::{GeometryError, Place, Result};
pub use join::Continuity;
pub use model::ChebyshevModel;
pub use over::Over;
pub use planes::{Plane, PlaneFamily, Ruling};
pub use scalars::{exact, exact_ball};
pub use surface::{
    Forms, HalfTurn, Partials, Principal, Rails, RotationSurface, RuledSurface, Surface,
    TensorSurface,
};
