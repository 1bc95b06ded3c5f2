//! Hermite curves of degree 3, 4, 5: given by points and tangent vectors at 0, 1/2 and 1.
//!
//! | degree | data, in this order | source |
//! |---|---|---|
//! | 3 | `p(0), p(1), p'(0), p'(1)` | hermite-developable eq. (2.1) |
//! | 4 | `p(0), p(1/2), p(1), p'(0), p'(1)` | eq. (2.3) |
//! | 5 | `p(0), p(1/2), p(1), p'(0), p'(1/2), p'(1)` | eq. (2.4) |
//!
//! The curves are polynomial, so they are handed on as Bernstein curves: [`cubic`], [`quartic`],
//! [`quintic`] are exact on every scalar with rational constants. [`functions`] gives the basis
//! functions themselves.

use super::Bernstein;
use crate::coordinate::{Coordinate, check_finite};
use crate::curve::Curve;
use crate::error::{GeometryError, Result};
use crate::vector::combine;
use torse_algebra::rational::{Rational, ratio};

/// Rows: Bernstein control points times the common denominator; columns: the Hermite data.
struct Conversion<const N: usize> {
    denominator: i64,
    rows: [[i64; N]; N],
}

// b1 = p0 + p0'/3, b2 = p1 - p1'/3.
const CUBIC: Conversion<4> = Conversion {
    denominator: 3,
    rows: [[3, 0, 0, 0], [3, 0, 1, 0], [0, 3, 0, -1], [0, 3, 0, 0]],
};

// b1 = p0 + p0'/4, b3 = p1 - p1'/4 and b2 from p(1/2) = (b0 + 4 b1 + 6 b2 + 4 b3 + b4)/16.
const QUARTIC: Conversion<5> = Conversion {
    denominator: 12,
    rows: [
        [12, 0, 0, 0, 0],
        [12, 0, 0, 3, 0],
        [-10, 32, -10, -2, 2],
        [0, 0, 12, 0, -3],
        [0, 0, 12, 0, 0],
    ],
};

// b1 = p0 + p0'/5, b4 = p1 - p1'/5; b2 + b3 from p(1/2), b3 - b2 from p'(1/2).
const QUINTIC: Conversion<6> = Conversion {
    denominator: 10,
    rows: [
        [10, 0, 0, 0, 0, 0],
        [10, 0, 0, 2, 0, 0],
        [-13, 16, 7, -2, -8, -1],
        [7, 16, -13, 1, 8, 2],
        [0, 0, 10, 0, 0, -2],
        [0, 0, 10, 0, 0, 0],
    ],
};

/// The cubic with `data = [p(0), p(1), p'(0), p'(1)]` (hermite-developable eq. (2.1)).
///
/// # Errors
/// [`GeometryError::NotFinite`].
///
/// ```
/// use torse_geometry::hermite;
/// let curve = hermite::cubic(&[[0.0, 0.0], [1.0, 0.0], [0.0, 3.0], [0.0, 3.0]])?;
/// let jet = curve.derivatives(&1.0, 1)?;
/// assert_eq!(jet, [[1.0, 0.0], [0.0, 3.0]]);
/// # Ok::<(), torse_geometry::GeometryError>(())
/// ```
pub fn cubic<S: Coordinate, const D: usize>(data: &[[S; D]; 4]) -> Result<Curve<Bernstein, S, D>> {
    convert(&CUBIC, data)
}

/// The quartic with `data = [p(0), p(1/2), p(1), p'(0), p'(1)]` (hermite-developable eq. (2.3)).
///
/// # Errors
/// [`GeometryError::NotFinite`].
///
/// ```
/// use torse_algebra::rational::{integer, ratio};
/// use torse_geometry::hermite;
/// let curve = hermite::quartic(&[1, 5, 2, -3, 4].map(|n| [integer(n)]))?;
/// assert_eq!(curve.point(&ratio(1, 2).unwrap())?, [integer(5)]);
/// assert_eq!(curve.start_jet(1)?, [[integer(1)], [integer(-3)]]);
/// assert_eq!(curve.end_jet(1)?, [[integer(2)], [integer(4)]]);
/// # Ok::<(), torse_geometry::GeometryError>(())
/// ```
pub fn quartic<S: Coordinate, const D: usize>(
    data: &[[S; D]; 5],
) -> Result<Curve<Bernstein, S, D>> {
    convert(&QUARTIC, data)
}

/// The quintic with `data = [p(0), p(1/2), p(1), p'(0), p'(1/2), p'(1)]` (hermite-developable eq. (2.4)).
///
/// # Errors
/// [`GeometryError::NotFinite`].
///
/// ```
/// use torse_geometry::hermite;
/// let data = [[0.0], [5.0], [1.0], [2.0], [-3.0], [4.0]];
/// let curve = hermite::quintic(&data)?;
/// let half = curve.derivatives(&0.5, 1)?;
/// assert!((half[0][0] - 5.0).abs() < 1e-14 && (half[1][0] + 3.0).abs() < 1e-13);
/// # Ok::<(), torse_geometry::GeometryError>(())
/// ```
pub fn quintic<S: Coordinate, const D: usize>(
    data: &[[S; D]; 6],
) -> Result<Curve<Bernstein, S, D>> {
    convert(&QUINTIC, data)
}

/// The curve of 4, 5 or 6 Hermite data: [`cubic`], [`quartic`] or [`quintic`].
///
/// # Errors
/// [`GeometryError::LengthMismatch`] for another number, [`GeometryError::NotFinite`].
///
/// ```
/// use torse_geometry::hermite;
/// assert_eq!(hermite::curve(&[[0.0], [5.0], [1.0], [2.0], [3.0]])?.degree(), 4);
/// let error = hermite::curve(&[[0.0], [5.0], [f64::NAN], [2.0]]).unwrap_err();
/// assert_eq!(error.to_string(), "Hermite datum, entry 2: NaN is not a finite number");
/// let error = hermite::curve(&[[0.0], [5.0]]).unwrap_err();
/// assert_eq!(error.to_string(), "Hermite data (4, 5 or 6 of them): entry 0 has 2 elements, expected 6");
/// # Ok::<(), torse_geometry::GeometryError>(())
/// ```
pub fn curve<S: Coordinate, const D: usize>(data: &[[S; D]]) -> Result<Curve<Bernstein, S, D>> {
    match data.len() {
        4 => convert(&CUBIC, data),
        5 => convert(&QUARTIC, data),
        6 => convert(&QUINTIC, data),
        given => Err(GeometryError::LengthMismatch {
            what: "Hermite data (4, 5 or 6 of them)",
            index: 0,
            expected: 6,
            given,
        }),
    }
}

fn convert<S: Coordinate, const N: usize, const D: usize>(
    conversion: &Conversion<N>,
    data: &[[S; D]],
) -> Result<Curve<Bernstein, S, D>> {
    check_finite("Hermite datum", data.iter().flatten())?;
    let mut points = Vec::with_capacity(N);
    for row in &conversion.rows {
        let weights: Vec<S> = data
            .iter()
            .zip(row)
            .filter_map(|(datum, &n)| {
                Some(datum.first()?.constant(&ratio(n, conversion.denominator)?))
            })
            .collect();
        points.extend(combine(&weights, data));
    }
    Curve::new(Bernstein, points)
}

/// The monomial coefficients (constant term first) of the Hermite basis functions, in the order of
/// the data: degrees 3, 4 and 5 (hermite-developable eqs. (2.1b), (2.3), (2.4)); empty otherwise.
///
/// ```
/// use torse_algebra::rational::integer;
/// use torse_geometry::hermite;
/// // H1 = 2u^3 - 3u^2 + 1
/// assert_eq!(hermite::functions(3)[0], [1, 0, -3, 2].map(integer));
/// ```
#[must_use]
pub fn functions(degree: usize) -> Vec<Vec<Rational>> {
    match degree {
        3 => monomials(&CUBIC),
        4 => monomials(&QUARTIC),
        5 => monomials(&QUINTIC),
        _ => Vec::new(),
    }
}

/// Coefficient m of function j: binomial(n, m) times the m-th forward difference of column j.
fn monomials<const N: usize>(conversion: &Conversion<N>) -> Vec<Vec<Rational>> {
    (0..N)
        .map(|j| {
            let mut column: Vec<Rational> = conversion
                .rows
                .iter()
                .filter_map(|row| ratio(row[j], conversion.denominator))
                .collect();
            let mut binomial = Rational::from_integer(1.into());
            let mut coefficients = Vec::with_capacity(N);
            for m in 0..N {
                coefficients.extend(column.first().map(|c| c * &binomial));
                column = column
                    .iter()
                    .zip(column.iter().skip(1))
                    .map(|(a, b)| b - a)
                    .collect();
                binomial *= Rational::new((N - 1 - m).into(), (m + 1).into());
            }
            coefficients
        })
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use torse_algebra::rational::integer;

    /// p^(n) at a rational point from monomial coefficients.
    fn value(c: &[Rational], at: &Rational) -> Rational {
        c.iter().rev().fold(integer(0), |sum, c| sum * at + c)
    }

    fn slope(c: &[Rational]) -> Vec<Rational> {
        c.iter()
            .enumerate()
            .skip(1)
            .map(|(n, c)| c * Rational::from_integer(n.into()))
            .collect()
    }

    #[test]
    fn each_hermite_function_is_one_at_its_own_datum_and_zero_at_the_others() {
        let (zero, half, one) = (integer(0), ratio(1, 2).unwrap(), integer(1));
        let nodes: [Vec<(&Rational, bool)>; 3] = [
            vec![(&zero, false), (&one, false), (&zero, true), (&one, true)],
            vec![
                (&zero, false),
                (&half, false),
                (&one, false),
                (&zero, true),
                (&one, true),
            ],
            vec![
                (&zero, false),
                (&half, false),
                (&one, false),
                (&zero, true),
                (&half, true),
                (&one, true),
            ],
        ];
        for nodes in nodes {
            let functions = functions(nodes.len() - 1);
            assert_eq!(functions.len(), nodes.len());
            for (i, h) in functions.iter().enumerate() {
                for (j, (at, is_slope)) in nodes.iter().enumerate() {
                    let got = if *is_slope {
                        value(&slope(h), at)
                    } else {
                        value(h, at)
                    };
                    assert_eq!(got, integer(i64::from(i == j)), "function {i} at datum {j}");
                }
            }
        }
    }
}
