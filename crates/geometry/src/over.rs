//! Objects carried from one scalar to another.

use crate::error::Result;

/// Carries an object over the scalar `S` to the scalar `T`.
///
/// ```
/// use torse_geometry::{Curve, Gbt, Over, exact_ball};
/// let curve = Curve::new(Gbt::new(0.1, 0.7)?, vec![[0.0], [1.0], [4.0], [2.0]])?;
/// let enclosed = curve.over(&|x| exact_ball(*x, 100))?;
/// let [ball] = enclosed.point(&exact_ball(0.3, 100))?;
/// let (low, high) = ball.to_f64_bounds();
/// let [value] = curve.point(&0.3)?;
/// assert!((value - low).abs() < 1e-14 && high - low < 1e-15);
/// # Ok::<(), torse_geometry::GeometryError>(())
/// ```
pub trait Over<S, T> {
    /// The same kind of object over `T`.
    type Object;

    /// The object with every number converted.
    ///
    /// # Errors
    /// What the constructor of the object refuses.
    fn over(&self, convert: &impl Fn(&S) -> T) -> Result<Self::Object>;
}
