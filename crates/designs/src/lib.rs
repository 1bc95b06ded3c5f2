//! Design files: from control data to a part that can be cut.
#![warn(missing_docs)]

mod construct;
mod design;
pub mod draw;
mod error;
pub mod eval;
pub mod export;
mod file;
pub mod fold;
pub mod inspect;
mod unit;
pub mod unroll;

pub use design::{
    Chain, Design, Ends, Layout, Mark, Material, Patch, Piece, Smoothness, Tolerances, View,
};
pub use error::{DesignError, Ending};
pub use file::{MOST_BYTES, MOST_CONTROLS, MOST_THINGS, keys, load, read};
pub use unit::Unit;
