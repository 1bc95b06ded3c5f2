//! Why a drawing is refused.

use thiserror::Error;

/// Why a picture was refused. Every variant names the faulty datum.
#[derive(Debug, Clone, PartialEq, Error)]
pub enum FigureError {
    /// A coordinate, value or normal is NaN or infinite. `index` counts the points of `what`.
    #[error("{what}: entry {index} is {value}, which is not finite")]
    NonFinite {
        /// The list the entry belongs to.
        what: &'static str,
        /// Position of the entry in that list.
        index: usize,
        /// The offending number.
        value: f64,
    },
    /// A list is shorter than the drawing needs.
    #[error("{what}: {got} given, at least {needed} needed")]
    TooFew {
        /// The list.
        what: &'static str,
        /// Smallest length that can be drawn.
        needed: usize,
        /// Length given.
        got: usize,
    },
    /// Two lists that belong together have different lengths.
    #[error("{what}: {got} given, {expected} expected")]
    Length {
        /// The list of the wrong length.
        what: &'static str,
        /// Length of the list it belongs to.
        expected: usize,
        /// Length given.
        got: usize,
    },
    /// A range whose ends are equal or in the wrong order.
    #[error("the range {low}..{high} of {what} is empty")]
    EmptyRange {
        /// The axis or scale.
        what: &'static str,
        /// Lower end.
        low: f64,
        /// Upper end.
        high: f64,
    },
    /// A number outside its permitted interval.
    #[error("{what} is {value}, outside {low}..={high}")]
    OutOfRange {
        /// The quantity.
        what: &'static str,
        /// The value given.
        value: f64,
        /// Smallest permitted value.
        low: f64,
        /// Largest permitted value.
        high: f64,
    },
    /// A label that does not parse.
    #[error("label `{label}`, byte {at}: {problem}")]
    Label {
        /// The whole label.
        label: String,
        /// Byte offset of the fault.
        at: usize,
        /// The fault.
        problem: LabelProblem,
    },
    /// An empty picture, which has no extent.
    #[error("nothing to draw")]
    Empty,
    /// Rasterising would visit more samples than [`crate::WORK_LIMIT`].
    #[error("the drawing needs {samples:.2e} samples, the limit is {limit:.2e}")]
    TooMuchWork {
        /// Estimated number of samples.
        samples: f64,
        /// The limit.
        limit: f64,
    },
    /// A typeface that should be embedded is missing or damaged.
    #[error("the embedded font {0} cannot be read")]
    Font(&'static str),
    /// The chart library refused.
    #[error("chart: {0}")]
    Chart(String),
    /// The PNG encoder refused.
    #[error("png: {0}")]
    Png(String),
    /// The GIF encoder refused.
    #[error("gif: {0}")]
    Gif(String),
}

/// A fault inside a label.
#[derive(Debug, Clone, PartialEq, Eq, Error)]
pub enum LabelProblem {
    /// A `$` without its partner.
    #[error("`$` is never closed")]
    OpenMath,
    /// A `{` without its partner, or a `}` too many.
    #[error("unbalanced brace")]
    Brace,
    /// `_` or `^` with nothing after it.
    #[error("script is empty")]
    EmptyScript,
    /// Two subscripts or two superscripts on one base.
    #[error("double script")]
    DoubleScript,
    /// Scripts nested deeper than two.
    #[error("scripts nest deeper than two")]
    TooDeep,
    /// An unknown `\command`.
    #[error("unknown command `\\{0}`")]
    Command(String),
    /// A character that no embedded font has.
    #[error("no glyph for `{0}`")]
    Glyph(char),
}

/// Reject the first non-finite number among `points`.
pub(crate) fn finite<const N: usize>(
    what: &'static str,
    points: &[[f64; N]],
) -> Result<(), FigureError> {
    for (index, point) in points.iter().enumerate() {
        if let Some(&value) = point.iter().find(|c| !c.is_finite()) {
            return Err(FigureError::NonFinite { what, index, value });
        }
    }
    Ok(())
}

/// Reject lists shorter than `needed`.
pub(crate) fn at_least(what: &'static str, needed: usize, got: usize) -> Result<(), FigureError> {
    if got < needed {
        return Err(FigureError::TooFew { what, needed, got });
    }
    Ok(())
}

/// Reject `value` outside `low..=high` (and NaN).
pub(crate) fn within(
    what: &'static str,
    value: f64,
    low: f64,
    high: f64,
) -> Result<(), FigureError> {
    if !(low..=high).contains(&value) {
        return Err(FigureError::OutOfRange {
            what,
            value,
            low,
            high,
        });
    }
    Ok(())
}

/// Reject a range with non-finite ends or without interior.
pub(crate) fn range(what: &'static str, low: f64, high: f64) -> Result<(), FigureError> {
    finite(what, &[[low], [high]])?;
    if low < high && (high - low).is_finite() {
        return Ok(());
    }
    Err(FigureError::EmptyRange { what, low, high })
}
