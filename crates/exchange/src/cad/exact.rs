//! Exact rational forms of what is polynomial or rational: tensor products and ruled patches of Bernstein
//! curves, and the developables of Bernstein plane families.
//!
//! For a plane family `H = (a, s)` with polynomial `a(x), s(x)` the ruling has the direction `phi = a x a'` and
//! the moment `theta = s' a - s a' = X x phi`. So its point on a fixed plane `n X = d`, its point at `x1` from
//! the foot, and the point of the edge of regression are quotients of polynomials:
//!
//! ```text
//! plane        (n x theta + d phi) / (n phi)
//! range        (x1 phi (phi phi) + phi x theta) / (phi phi)
//! regression   (s (a' x a'') + s' (a'' x a) + s'' (a x a')) / det(a, a', a'')
//! ```
//!
//! Their Bernstein coefficients are rational numbers, computed exactly and rounded once.

use super::approximate::approximate;
use super::homogeneous::{Polynomial, Rail, Vector, cross, dot, scaled, sum};
use super::patch::{BsplinePatch, Knots};
use super::{Converted, length_bound, rounded_up};
use crate::error::{ExchangeError, Result};
use std::cmp::Ordering;
use torse_algebra::rational::{Rational, to_f64};
use torse_algebra::{Ball, Scalar};
use torse_geometry::basis::BasisShape;
use torse_geometry::{
    Basis, Bernstein, Coordinate, Curve, EnvelopingPatch, Gbt, Over, PatchBounds, PlaneFamily,
    Rails, RationalCurve, RuledSurface, TangentPatch, TensorSurface, exact,
};

/// The degree up to which CAD systems read B-splines.
const MAX_DEGREE: usize = 25;
/// How often a patch is halved until its weights are positive.
const MAX_DEPTH: usize = 6;

/// A surface that is polynomial or rational.
///
/// ```
/// use torse_exchange::ExactForm;
/// use torse_geometry::{Bernstein, PatchBounds, EnvelopingPatch, PlaneFamily};
/// // The tangent surface of the twisted cubic between two planes.
/// let planes = vec![[0., 0., 1., 0.], [0., -1., 1., 0.], [1., -2., 1., 0.], [3., -3., 1., 1.]];
/// let family = PlaneFamily::new(Bernstein, planes)?;
/// let sheet = EnvelopingPatch::new(family, PatchBounds::Planes([[1., 0., 0., 2.], [1., 0., 0., 4.]]))?;
/// let exact = sheet.exact_form()?;
/// assert!(exact.error < 1e-13 && exact.patches[0].is_declared_developable());
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub trait ExactForm {
    /// The surface as Bezier patches: the same point set up to the rounding of control points and weights,
    /// whose effect is [`Converted::error`]. Of a rational ruled patch the parameter on each ruling is
    /// another one.
    ///
    /// # Errors
    /// [`ExchangeError::NotRational`] when the basis is trigonometric, the degree is above 25, when the patch reaches
    /// (or almost reaches) infinity, or has no edge of regression that it should be measured from.
    fn exact_form(&self) -> Result<Converted>;
}

/// The exact form where there is one and its rounding is within `tolerance`, else the approximation.
///
/// # Errors
/// As [`approximate`].
///
/// ```
/// use torse_exchange::convert;
/// use torse_geometry::{Bernstein, PatchBounds, EnvelopingPatch, Gbt, PlaneFamily};
/// let planes = vec![[0., 0., 1., 0.], [0., -1., 1., 0.], [1., -2., 1., 0.], [3., -3., 1., 1.]];
/// let cut = || PatchBounds::Planes([[1., 0., 0., 2.], [1., 0., 0., 4.]]);
/// let rational = EnvelopingPatch::new(PlaneFamily::new(Bernstein, planes.clone())?, cut())?;
/// assert!(convert(&rational, 1e-3)?.error < 1e-13);
/// let trigonometric = EnvelopingPatch::new(PlaneFamily::new(Gbt::new(0.5, 0.5)?, planes)?, cut())?;
/// assert!(convert(&trigonometric, 1e-3)?.error > 1e-6);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn convert<P>(patch: &P, tolerance: f64) -> Result<Converted>
where
    P: ExactForm + Over<f64, Ball, Object: Rails<Ball>>,
{
    match patch.exact_form() {
        Ok(exact) if exact.error <= tolerance => Ok(exact),
        Ok(_) | Err(ExchangeError::NotRational { .. }) => approximate(patch, tolerance),
        Err(error) => Err(error),
    }
}

/// A basis that may be the Bernstein polynomials, whose curves are polynomial.
pub trait PolynomialBasis {
    /// Whether it is.
    fn is_bernstein(&self) -> bool;
}

impl PolynomialBasis for Bernstein {
    fn is_bernstein(&self) -> bool {
        true
    }
}

impl PolynomialBasis for Gbt<f64> {
    fn is_bernstein(&self) -> bool {
        false
    }
}

impl PolynomialBasis for BasisShape<f64> {
    fn is_bernstein(&self) -> bool {
        matches!(self, Self::Bernstein)
    }
}

fn check_bernstein(basis: &impl PolynomialBasis) -> Result<()> {
    if basis.is_bernstein() {
        return Ok(());
    }
    let why = "the basis is trigonometric";
    Err(ExchangeError::NotRational { why })
}

/// A rail in Bernstein form: the numerator and, for a rational curve, the weight.
pub type BezierForm = (Vec<[f64; 3]>, Option<Vec<f64>>);

/// A curve whose homogeneous coordinates may be polynomials.
pub trait HomogeneousRail {
    /// The Bernstein coefficients of the homogeneous coordinates.
    ///
    /// # Errors
    /// [`ExchangeError::NotRational`].
    fn bernstein_form(&self) -> Result<BezierForm>;
}

impl<B: Basis<f64> + PolynomialBasis> HomogeneousRail for Curve<B, f64, 3> {
    fn bernstein_form(&self) -> Result<BezierForm> {
        check_bernstein(self.basis())?;
        Ok((self.points().to_vec(), None))
    }
}

impl<B: Basis<f64> + PolynomialBasis> HomogeneousRail for RationalCurve<B, f64, 3> {
    fn bernstein_form(&self) -> Result<BezierForm> {
        check_bernstein(self.basis())?;
        let (points, weights) = self.homogeneous().map(|(p, w)| (*p, *w)).unzip();
        Ok((points, Some(weights)))
    }
}

impl<U, V> ExactForm for TensorSurface<U, V, f64>
where
    U: Basis<f64> + PolynomialBasis,
    V: Basis<f64> + PolynomialBasis,
{
    fn exact_form(&self) -> Result<Converted> {
        check_bernstein(self.bases().0)?;
        check_bernstein(self.bases().1)?;
        let (m, n) = self.degrees();
        check_degree(m.max(n))?;
        let net = self.rows().map(<[_]>::to_vec).collect();
        let knots = [Knots::bezier(m), Knots::bezier(n)];
        Ok(Converted {
            patches: vec![BsplinePatch::new([m, n], knots, net, None)?],
            error: 0.0,
        })
    }
}

impl<P: HomogeneousRail, Q: HomogeneousRail> ExactForm for RuledSurface<P, Q> {
    fn exact_form(&self) -> Result<Converted> {
        let rail = |(points, weights): BezierForm| Rail {
            numerator: [0, 1, 2].map(|k| Polynomial::of_bernstein(points.iter().map(|p| p[k]))),
            weight: match weights {
                Some(weights) => Polynomial::of_bernstein(weights.into_iter()),
                None => Polynomial::constant(1.0),
            },
        };
        between([
            rail(self.first().bernstein_form()?),
            rail(self.second().bernstein_form()?),
        ])
    }
}

impl<B: Basis<f64> + PolynomialBasis> ExactForm for EnvelopingPatch<B, f64> {
    fn exact_form(&self) -> Result<Converted> {
        let (a, s) = family_of(self.family())?;
        let (da, ds) = (a.each_ref().map(Polynomial::derivative), s.derivative());
        let phi = cross(&a, &da);
        let minus = Polynomial::constant(-1.0);
        let theta = sum(&scaled(&a, &ds), &scaled(&da, &s.times(&minus)));
        let rails = match self.bounds() {
            PatchBounds::Planes(planes) => planes.map(|[p, q, r, d]| {
                let n = [p, q, r].map(Polynomial::constant);
                Rail {
                    numerator: sum(&cross(&n, &theta), &scaled(&phi, &Polynomial::constant(d))),
                    weight: dot(&n, &phi),
                }
            }),
            PatchBounds::Range(range) => {
                let square = dot(&phi, &phi);
                let foot = cross(&phi, &theta);
                range.map(|x1| Rail {
                    numerator: sum(
                        &scaled(&phi, &square.times(&Polynomial::constant(x1))),
                        &foot,
                    ),
                    weight: square.clone(),
                })
            }
        };
        Ok(between(rails)?.declared_developable())
    }
}

impl<B: Basis<f64> + PolynomialBasis> ExactForm for TangentPatch<B, f64> {
    fn exact_form(&self) -> Result<Converted> {
        let (a, s) = family_of(self.family())?;
        let (da, ds) = (a.each_ref().map(Polynomial::derivative), s.derivative());
        let (dda, dds) = (da.each_ref().map(Polynomial::derivative), ds.derivative());
        let first = sum(
            &scaled(&cross(&da, &dda), &s),
            &scaled(&cross(&dda, &a), &ds),
        );
        let point = sum(&first, &scaled(&cross(&a, &da), &dds));
        let weight = dot(&a, &cross(&da, &dda));
        // S = N/D, S' = (N' D - N D')/D^2
        let minus = weight.derivative().times(&Polynomial::constant(-1.0));
        let tangent = sum(
            &scaled(&point.each_ref().map(Polynomial::derivative), &weight),
            &scaled(&point, &minus),
        );
        let spine = scaled(&point, &weight);
        let square = weight.times(&weight);
        let rails = self.range().map(|x2| Rail {
            numerator: sum(&spine, &scaled(&tangent, &Polynomial::constant(x2))),
            weight: square.clone(),
        });
        Ok(between(rails)?.declared_developable())
    }
}

/// The normal and the distance of the planes of a family.
fn family_of<B: Basis<f64> + PolynomialBasis>(
    family: &PlaneFamily<B, f64>,
) -> Result<(Vector, Polynomial)> {
    check_bernstein(family.curve().basis())?;
    let planes = family.curve().points();
    let axis = |k: usize| Polynomial::of_bernstein(planes.iter().map(|p| p[k]));
    Ok(([axis(0), axis(1), axis(2)], axis(3)))
}

fn check_degree(degree: usize) -> Result<()> {
    if degree <= MAX_DEGREE {
        return Ok(());
    }
    let why = "the degree is above 25";
    Err(ExchangeError::NotRational { why })
}

/// The ruled patches between two rational rails.
fn between(rails: [Rail; 2]) -> Result<Converted> {
    if rails.iter().any(|rail| rail.weight.is_zero()) {
        let why =
            "the weight vanishes: there is no edge of regression, or no ruling meets the plane";
        return Err(ExchangeError::NotRational { why });
    }
    let degree = rails[0].degree().max(rails[1].degree()).max(1);
    check_degree(degree)?;
    let piece = rails.map(
        |Rail {
             numerator: [x, y, z],
             weight,
         }| { [x, y, z, weight].map(|p| p.bernstein(degree)) },
    );
    let mut patches = Vec::new();
    let mut error = 0.0_f64;
    let mut open = vec![(piece, 0)];
    while let Some((piece, depth)) = open.pop() {
        if piece.iter().all(|rail| one_sign(&rail[3])) {
            let (patch, moved) = rounded(&piece, degree)?;
            patches.push(patch);
            error = error.max(moved);
        } else if depth < MAX_DEPTH {
            let [left, right] = halves(&piece);
            open.extend([(right, depth + 1), (left, depth + 1)]);
        } else {
            let why = "the patch reaches infinity, or almost";
            return Err(ExchangeError::NotRational { why });
        }
    }
    Ok(Converted { patches, error })
}

/// Two rails, each the Bernstein coefficients of three numerators and the weight.
type Piece = [[Vec<Rational>; 4]; 2];

fn one_sign(weights: &[Rational]) -> bool {
    let all = |sign: Ordering| weights.iter().all(|w| w.sign() == Some(sign));
    all(Ordering::Greater) || all(Ordering::Less)
}

/// The piece on both halves of its interval (de Casteljau).
fn halves(piece: &Piece) -> [Piece; 2] {
    let half = Rational::new(1.into(), 2.into());
    let split = |list: &Vec<Rational>| {
        let (mut left, mut right) = (Vec::new(), Vec::new());
        let mut row = list.clone();
        while let (Some(first), Some(last)) = (row.first(), row.last()) {
            left.push(first.clone());
            right.push(last.clone());
            row = row
                .windows(2)
                .filter_map(|p| Some((p.first()?.clone() + p.get(1)?.clone()) * half.clone()))
                .collect();
        }
        right.reverse();
        [left, right]
    };
    [0, 1].map(|side| {
        piece
            .each_ref()
            .map(|rail| rail.each_ref().map(|list| split(list)[side].clone()))
    })
}

/// The patch with doubles for control points and weights, and how far that moves it.
///
/// With exact points `R_i` and weights `w_i > 0`, and rounded ones with a tilde, the two surfaces differ at equal
/// parameters by `sum B_i (W_i (R~_i - R_i) + (W_i - w_i)(R_i - S)) / sum B_i W_i` with `W_i = w~_i`: at most
/// the largest `|R~_i - R_i|` plus the largest `|1 - w_i/w~_i|` times the diameter of the net.
fn rounded(piece: &Piece, degree: usize) -> Result<(BsplinePatch, f64)> {
    let size = |q: &Rational| {
        let value = to_f64(q).abs();
        if value.is_nan() { f64::INFINITY } else { value }
    };
    let mut net = vec![Vec::with_capacity(2); degree + 1];
    let mut weights = net
        .iter()
        .map(|_| Vec::with_capacity(2))
        .collect::<Vec<_>>();
    let (mut moved, mut tilted) = (0.0_f64, 0.0_f64);
    let (mut low, mut high) = ([f64::INFINITY; 3], [f64::NEG_INFINITY; 3]);
    for [x, y, z, w] in piece {
        // Any constant factor of a rail is the same rail: the first weight becomes one.
        let Some(unit) = w.first() else { continue };
        let places = net.iter_mut().zip(&mut weights);
        for ((((row, weight_row), x), (y, z)), w) in places.zip(x).zip(y.iter().zip(z)).zip(w) {
            let no_weight = |_| ExchangeError::NotRational {
                why: "a weight vanishes",
            };
            let mut point = [0.0; 3];
            let mut off = [0.0; 3];
            for (axis, n) in [x, y, z].into_iter().enumerate() {
                let value = n.divided_by(w).map_err(no_weight)?;
                point[axis] = to_f64(&value) + 0.0;
                off[axis] = size(&(value - exact(point[axis])));
                low[axis] = low[axis].min(point[axis]);
                high[axis] = high[axis].max(point[axis]);
            }
            moved = moved.max(length_bound(off));
            let ratio = w.divided_by(unit).map_err(no_weight)?;
            let weight = to_f64(&ratio);
            let change = ratio.divided_by(&exact(weight)).map_err(no_weight)?;
            tilted = tilted.max(size(&(change - exact(1.0))));
            row.push(point);
            weight_row.push(weight);
        }
    }
    // The net of the exact points is larger by what rounding moves.
    let sides = [0, 1, 2].map(|axis| high[axis] - low[axis] + 2.0 * moved);
    let error = rounded_up(moved + tilted * length_bound(sides));
    let error = if moved == 0.0 && tilted == 0.0 {
        0.0
    } else {
        error
    };
    let knots = [Knots::bezier(degree), Knots::bezier(1)];
    Ok((
        BsplinePatch::new([degree, 1], knots, net, Some(weights))?,
        error,
    ))
}
