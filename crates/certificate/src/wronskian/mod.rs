//! Total positivity of the functions of one degree, by Wronskians.
//!
//! **Operator form.** Let a family have seeds `s_0, ..., s_d` that sum to one and the step `1 - x`, `x`. With the shift
//! E of indices, `P = (1-x) + xE` and `Q = E - 1`, write
//! `s_0 + s_1 E + ... + s_d E^d = P^d + c_1 P^(d-1) Q + ... + c_d Q^d`. A curve of degree k is the operator
//!
//! ```text
//! L[F] = F + c_1 (k-1)!/k! F' + ... + c_d (k-d)!/k! F^(d)
//! ```
//!
//! applied to the Bézier curve F of the same control values, since `P^k` makes F and `k!/(k-i)! P^(k-i) Q^i` makes `F^(i)`.
//! For d = 2 these are `F + (b/k) F' + (c/(k(k-1))) F''` with `b = s_1 + 2 s_2 - 2x` and `c = x^2 - x + x s_0 + (1-x) s_2`.
//!
//! **Determinants.** Put `D_r(x)` for the determinant of the entries, m, j = 1..r,
//! `[m = j] + sum over i of (k-i)! j!/(k! (j-i)!) c_{i,m-j+i}`, with the e-th Taylor coefficient `c_{i,e}` of `c_i` at
//! x. It is, up to a positive number, the Wronskian of `L[1], L[x], ..., L[x^r]`: expand `L[(y-x)^j]` at y = x.
//!
//! **Theorem.** Let `L[x^j]` vanish to the order j at least at 0, the same be true of the mirrored family at its 0, and
//! for all shape parameters in the *open* box let `D_1, ..., D_k` be positive on [0, 1]. Then the functions of degree k
//! are totally positive on [0, 1] for all shape parameters of the closed box, and diminish variation.
//!
//! *Proof.* For parameters in the open box, all Wronskians of the chain are positive on [0, 1], so a combination of the
//! functions that is not zero has at most k zeros there, counted with their order (Pólya 1922). The matrix of `D_r(0)`
//! is triangular, so its positive diagonal has the leading coefficients of `L[x^j]`: function i, `L` of a Bernstein
//! function that begins with `binom(k,i) x^i`, vanishes at 0 to the order i exactly, with a positive coefficient, and
//! by the mirrored family at 1 to the order k - i exactly. Take consecutive functions i to i + r and places
//! `0 < x_0 < ... < x_r < 1`. If their minor vanished, a combination would have the r + 1 places, i zeros at 0 and k -
//! i - r at 1: k + 1, which is too many. So the minor has one sign on this connected set of places; with `x_j = t y_j`,
//! t to 0, it is a positive number times a power of t times the positive generalised Vandermonde minor
//! `det(y_j^(i+l))`. Minors of consecutive columns that are all positive make all minors positive (Fekete 1912). Minors
//! are continuous in parameters and places, which gives the closed box. Totally positive functions that sum to one
//! diminish variation (Schoenberg 1930). ∎
//!
//! **Certificate.** With the parameters mapped to [0, 1], `D_r` is a polynomial in them of total degree at most r times
//! that of the seeds; its Bernstein coefficients `w(x)` in the parameters are entire functions of the *one* variable x.
//! [`cell`] shows them positive on cells that fill [0, 1/2]; the other half is that of the mirrored family, or the same
//! by an exchange of the parameters. Small determinants may be multiplied out, which shows the coefficients that are
//! zero identically.

pub mod cell;
mod certificate;
mod exact;
mod node;
mod operator;
mod orders;
mod remembered;
mod seeds;
mod series;
mod tables;

pub use certificate::{AtDegree, Cell, Exchange, Half, Wronskians};
pub use operator::Operator;
pub use seeds::Seeds;

/// The largest degree that is supported.
pub const MAX_DEGREE: u8 = 12;
/// The largest number of shape parameters.
pub const SHAPES: usize = 2;

/// Why positivity could not be shown.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
pub enum Unfit {
    /// The family does not have the required form.
    #[error("{0}")]
    Make(&'static str),
    /// A function does not vanish at an end to the order of its index.
    #[error("the operator does not keep the order of x^{0} at an end")]
    Order(u8),
    /// A cell has inconsistent data.
    #[error("a cell has impossible data")]
    Cell,
    /// A coefficient could not be shown to be positive on a cell.
    #[error(
        "determinant {rank}: a Bernstein coefficient is not shown to be positive up to {until}"
    )]
    Sign {
        /// The size of the determinant.
        rank: usize,
        /// The end of the cell.
        until: String,
    },
    /// A determinant that is too large (or has size zero) and is not expanded.
    #[error("determinant {0} is not multiplied out")]
    Rank(usize),
}
