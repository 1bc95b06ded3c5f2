//! Why a figure cannot be made.

use thiserror::Error;
use torse_plot::{FigureError, InteractiveError};

/// Why a figure cannot be sampled or drawn.
#[derive(Debug, Clone, PartialEq, Error)]
pub enum PlateError {
    /// A formula has a symbol that is not a running variable.
    #[error("`{symbol}` has no value")]
    Symbol {
        /// The symbol.
        symbol: String,
    },
    /// A formula is infinite or undefined at a sample.
    #[error("`{formula}` is {value} at sample {index}")]
    NotFinite {
        /// The formula.
        formula: String,
        /// The number of the sample.
        index: usize,
        /// The value.
        value: f64,
    },
    /// Too many samples to be visible.
    #[error("`{formula}` wants {wanted} samples, at most {most} are taken")]
    Samples {
        /// The formula.
        formula: String,
        /// The requested number.
        wanted: u64,
        /// The limit.
        most: u64,
    },
    /// A plane without a box that bounds it, or without a normal.
    #[error("the plane `{formula}` needs a normal, and intervals for all three axes of its panel")]
    Plane {
        /// The formula.
        formula: String,
    },
    /// The data cannot be serialised.
    #[error("the data of the figure cannot be written down: {0}")]
    Data(String),
    /// The drawing was refused.
    #[error(transparent)]
    Figure(#[from] FigureError),
    /// The interactive picture was refused.
    #[error(transparent)]
    Interactive(#[from] InteractiveError),
}
