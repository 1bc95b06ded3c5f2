//! Which development is made of a sheet that has no exact one.
//!
//! Let `T0, T1` be the parts of the speeds `P', Q'` of the rails across the ruling, `s0, s1` their lengths and `tau`
//! the angle between them, the *twist*. On the surface the speed across the ruling at `v` is `|(1 - v) T0 + v T1|`. In
//! a plane image in which rulings stay straight, keep their length, and every speed keeps its part along the ruling, it
//! is linear in `v`, from `a0` to `a1`. So a development is the choice of these two functions:
//!
//! | name | `a0`, `a1` | keeps | largest strain |
//! |---|---|---|---|
//! | edges | `s0`, `s1` | the lengths of both edges and of all rulings | `1/cos(tau/2) - 1`, halfway |
//! | first edge | `s0`, `s1 cos tau` | length and geodesic curvature of edge 1 | `1 - cos tau`, at edge 2 |
//! | second edge | `s0 cos tau`, `s1` | length and geodesic curvature of edge 2 | `1 - cos tau`, at edge 1 |
//! | between | their projections to the mean of both tangent planes | neither | `1 - cos psi`, `psi` the larger lean |
//!
//! Of an exactly developable sheet all four are the development. Of the others each has a strain of at most
//! `1 - cos tau`, and every development with no more strain than that lies within the *ambiguity* of each of them: with
//! `a_i` known within `w_i`, and the ruling in the middle held fast,
//!
//! ```text
//! |angle(x)| <= integral of (w0 + w1)/L,     |point(x)| <= integral of w0 + |P'| |angle|,     at the other edge L |angle| more.
//! ```

use crate::model::ChebyshevModel;

/// The development of a sheet that is not exactly developable, by what it keeps: see
/// [`Unrolling::flattening`](super::Unrolling::flattening).
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Flattening {
    /// Both edges and all rulings keep their lengths.
    #[default]
    Edges,
    /// The first edge keeps its length and its curvature in the sheet.
    FirstEdge,
    /// The second edge does.
    SecondEdge,
    /// Projected to the plane between the tangent planes at the ends of each ruling.
    Between,
}

impl Flattening {
    /// All of them, with the names of the command line.
    pub const ALL: [(&'static str, Self); 4] = [
        ("edges", Self::Edges),
        ("edge-1", Self::FirstEdge),
        ("edge-2", Self::SecondEdge),
        ("between", Self::Between),
    ];

    /// The name on the command line.
    #[must_use]
    pub fn name(self) -> &'static str {
        let found = Self::ALL.iter().find(|(_, flattening)| *flattening == self);
        found.map_or("edges", |(name, _)| name)
    }

    /// The largest share by which a line is stretched or shortened, of a sheet whose tangent planes turn along a ruling
    /// by an angle of at most this sine.
    pub(super) fn strain(self, sine: f64) -> f64 {
        match self {
            // 1/cos(tau/2) - 1 without cancellation, by (1 - cos tau)/2 = sin(tau/2)^2.
            Self::Edges => {
                let square = 0.5 * lost(sine);
                let cosine = (1.0 - square).max(0.0).sqrt();
                square / (cosine * (1.0 + cosine))
            }
            _ => lost(sine),
        }
    }

    /// How much slower than on the sheet the flat edges run at most, by the sine of the twist and the speeds across.
    pub(super) fn shortened(self, sine: f64, speeds: [f64; 2]) -> [f64; 2] {
        let lost = lost(sine);
        match self {
            Self::Edges => [0.0; 2],
            Self::FirstEdge => [0.0, lost * speeds[1]],
            Self::SecondEdge => [lost * speeds[0], 0.0],
            Self::Between => speeds.map(|speed| lost * speed),
        }
    }
}

/// `1 - cos tau` from `sin tau`, of an angle up to a right one.
pub(super) fn lost(sine: f64) -> f64 {
    let cosine = (1.0 - sine * sine).max(0.0).sqrt();
    sine * sine / (1.0 + cosine)
}

/// What the choice is made from: vectors `N0, N1` of the lengths `s0 L, s1 L`, orthogonal to the ruling, and the unit
/// vector between them.
pub(super) struct Sides<'a> {
    pub normals: [&'a [ChebyshevModel; 3]; 2],
    pub between: &'a [ChebyshevModel; 3],
    /// `N1 - N0`.
    pub change: &'a [ChebyshevModel; 3],
    /// `L`.
    pub length: &'a ChebyshevModel,
    pub exact: bool,
}

/// The speeds across the ruling and `a1 - a0`, as models.
pub(super) struct Across {
    pub speeds: [ChebyshevModel; 2],
    pub change: ChebyshevModel,
    /// The speeds in the mean plane, whose signs say on which side the edge of regression is.
    pub signed: [ChebyshevModel; 2],
}

impl Flattening {
    /// The choice; `None` where the interval is too long for it.
    pub(super) fn across(self, sides: &Sides<'_>) -> Option<Across> {
        use crate::vector::dot;
        let Sides {
            normals,
            between,
            change,
            length,
            exact,
        } = sides;
        let [n0, n1] = normals;
        let over = |value: ChebyshevModel| value.quotient(length);
        let signed = [over(dot(n0, between))?, over(dot(n1, between))?];
        let turned = over(dot(change, between))?;
        let choice = |speeds, change| Across {
            speeds,
            change,
            signed,
        };
        if *exact || self == Self::Between {
            return Some(choice(signed, turned));
        }
        let roots = [dot(n0, n0).root(), dot(n1, n1).root()];
        let [Some(l0), Some(l1)] = roots else {
            // A rail that stands still, or an edge of regression on the border: the speed is that in the mean plane, up
            // to what leans out of it.
            let out = |n: &[ChebyshevModel; 3]| -> f64 {
                let height = dot(n, between);
                let rest: [f64; 3] =
                    std::array::from_fn(|i| (n[i] - height * between[i]).largest());
                rest.iter().sum::<f64>() / length.least()
            };
            let off = [out(n0), out(n1)];
            let speeds = [signed[0].widened(off[0]), signed[1].widened(off[1])];
            return Some(choice(speeds, turned.widened(off[0] + off[1])));
        };
        let mixed = dot(n0, n1);
        let [first, second, grown] = match self {
            Self::Edges | Self::Between => {
                let grown = dot(change, n0) + dot(change, n1);
                [l0, l1, grown.quotient(&(l0 + l1))?]
            }
            Self::FirstEdge => [l0, mixed.quotient(&l0)?, dot(change, n0).quotient(&l0)?],
            Self::SecondEdge => [mixed.quotient(&l1)?, l1, dot(change, n1).quotient(&l1)?],
        };
        Some(choice([over(first)?, over(second)?], over(grown)?))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn strains_are_those_of_the_angle() {
        for angle in [1e-9_f64, 1e-3, 0.3, 1.2] {
            let (sine, cosine) = libm::sincos(angle);
            let edges = Flattening::Edges.strain(sine);
            let first = Flattening::FirstEdge.strain(sine);
            let half = libm::cos(0.5 * angle);
            assert!(
                (edges - (1.0 - half) / half).abs() <= 1e-15_f64.max(1e-12 * edges),
                "{edges:e}"
            );
            assert!((first - (1.0 - cosine)).abs() <= 1e-15_f64.max(1e-12 * first));
            assert!((edges / (angle * angle / 8.0) - 1.0).abs() < 0.5 && edges < first);
        }
    }
}
