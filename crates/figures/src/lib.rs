//! The figures of derivation files, sampled and drawn.
//!
//! A derivation file describes a figure in formulas ([`figure`]); each is evaluated once, exactly. Here the exact
//! formula becomes a [`Function`] of doubles, its samples become layers of a plot or solids of a view, and
//! `torse_plot` draws them. This crate knows no basis and no paper.
//!
//! | wanted | call |
//! |---|---|
//! | all figures of a paper | [`plates`] |
//! | the picture | [`Plate::draw`] |
//! | the picture that follows sliders | [`Plate::interactive`] |
//! | the developable to move and unroll | [`Plate::torse`] |
//! | whether it changed | [`Plate::fingerprint`] |

mod error;
pub mod figure;
mod function;
mod interactive;
mod plane;
mod plate;
mod sample;
mod space;
mod style;
mod torse;

pub use error::PlateError;
pub use function::Function;
pub use plate::{Plate, plates};
