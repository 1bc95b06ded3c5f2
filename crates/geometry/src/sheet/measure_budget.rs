//! The work that measures of a sheet may take.

/// How much work bounds and proofs may take, and how close they should come.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct MeasureBudget {
    /// Bits after the point, for a sheet of the size of one; smaller sheets get more.
    pub bits: usize,
    /// The relative width of bounds at which one is content.
    pub accuracy: f64,
    /// The number of intervals of the parameter.
    pub cells: usize,
}

/// 128 bits, a tenth, 64 intervals: a third of a second or less for the examples of the papers.
impl Default for MeasureBudget {
    fn default() -> Self {
        Self {
            bits: 128,
            accuracy: 0.1,
            cells: 64,
        }
    }
}
