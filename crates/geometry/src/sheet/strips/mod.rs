//! Strips: developables that cover a tensor-product surface between neighbouring curves on it.
//!
//! The curves are those of constant `v` (or `u`). Between two neighbours runs a whole panel ([`Sheet::panels`]); its
//! distance from the part of the surface between them is bounded, both ways, in the file `distance`. Where the curves
//! are is moved until the bounds of all strips are about equal.
//!
//! Rulings of narrow strips run in the direction that is conjugate to the curves. So there are none along asymptotic
//! curves, whose normal curvature vanishes: on a saddle the curves of constant parameter may be such.

mod cover;
mod distance;
mod folds;
mod rulings;
mod search;
mod slide;
mod spacing;
mod strip;

pub use cover::StripCover;
pub use search::MAX_STRIPS;
pub use strip::{StripDirection, StripError, SurfaceStrip};
