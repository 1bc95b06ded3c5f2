//! The same object over another scalar: f64 data are exact rationals, so any f64 curve, family or
//! patch can be carried to balls (certified) or rationals (exact) without loss.

use crate::basis::{BasisShape, Bernstein, Gbt};
use crate::coordinate::Coordinate;
use crate::curve::{Curve, EllipticHelix, RationalCurve};
use crate::developable::{EnvelopingPatch, HermiteCone, PatchBounds, TangentPatch, unit_plane};
use crate::error::Result;
use crate::over::Over;
use crate::planes::PlaneFamily;
use crate::surface::{PatchPart, RotationSurface, RuledSurface, TensorSurface};

pub use crate::dyadic::{exact, exact_ball};

fn point<S, T, const D: usize>(p: &[S; D], convert: &impl Fn(&S) -> T) -> [T; D] {
    p.each_ref().map(convert)
}

impl<S, T> Over<S, T> for Bernstein {
    type Object = Self;

    fn over(&self, _convert: &impl Fn(&S) -> T) -> Result<Self> {
        Ok(*self)
    }
}

impl<S: Coordinate, T: Coordinate> Over<S, T> for Gbt<S> {
    type Object = Gbt<T>;

    fn over(&self, convert: &impl Fn(&S) -> T) -> Result<Gbt<T>> {
        Gbt::new(convert(self.mu()), convert(self.nu()))
    }
}

impl<S: Coordinate, T: Coordinate> Over<S, T> for BasisShape<S> {
    type Object = BasisShape<T>;

    fn over(&self, convert: &impl Fn(&S) -> T) -> Result<BasisShape<T>> {
        match self {
            Self::Bernstein => Ok(BasisShape::Bernstein),
            Self::Gbt(basis) => basis.over(convert).map(BasisShape::Gbt),
        }
    }
}

impl<S, T, B, const D: usize> Over<S, T> for Curve<B, S, D>
where
    S: Coordinate,
    T: Coordinate,
    B: crate::Basis<S> + Over<S, T, Object: crate::Basis<T>>,
{
    type Object = Curve<B::Object, T, D>;

    fn over(&self, convert: &impl Fn(&S) -> T) -> Result<Self::Object> {
        let points = self.points().iter().map(|p| point(p, convert)).collect();
        Curve::new(self.basis().over(convert)?, points)
    }
}

impl<S, T, B, const D: usize> Over<S, T> for RationalCurve<B, S, D>
where
    S: Coordinate,
    T: Coordinate,
    B: crate::Basis<S> + Over<S, T, Object: crate::Basis<T>>,
{
    type Object = RationalCurve<B::Object, T, D>;

    fn over(&self, convert: &impl Fn(&S) -> T) -> Result<Self::Object> {
        let (points, weights) = self
            .homogeneous()
            .map(|(p, w)| (point(p, convert), convert(w)))
            .unzip();
        RationalCurve::from_homogeneous(self.basis().over(convert)?, points, weights)
    }
}

impl<S: Coordinate, T: Coordinate> Over<S, T> for EllipticHelix<S> {
    type Object = EllipticHelix<T>;

    fn over(&self, convert: &impl Fn(&S) -> T) -> Result<EllipticHelix<T>> {
        let [cosine, sine] = self.axes();
        EllipticHelix::new(
            point(self.centre(), convert),
            point(cosine, convert),
            point(sine, convert),
            point(self.rise(), convert),
            point(self.range(), convert),
        )
    }
}

impl<S, T, U, V> Over<S, T> for TensorSurface<U, V, S>
where
    S: Coordinate,
    T: Coordinate,
    U: crate::Basis<S> + Over<S, T, Object: crate::Basis<T>>,
    V: crate::Basis<S> + Over<S, T, Object: crate::Basis<T>>,
{
    type Object = TensorSurface<U::Object, V::Object, T>;

    fn over(&self, convert: &impl Fn(&S) -> T) -> Result<Self::Object> {
        let (u, v) = self.bases();
        let net = self
            .rows()
            .map(|row| row.iter().map(|p| point(p, convert)).collect())
            .collect();
        TensorSurface::new(u.over(convert)?, v.over(convert)?, net)
    }
}

impl<S, T, P, Q> Over<S, T> for RuledSurface<P, Q>
where
    P: Over<S, T>,
    Q: Over<S, T>,
{
    type Object = RuledSurface<P::Object, Q::Object>;

    fn over(&self, convert: &impl Fn(&S) -> T) -> Result<Self::Object> {
        Ok(RuledSurface::new(
            self.first().over(convert)?,
            self.second().over(convert)?,
        ))
    }
}

impl<S, T, B> Over<S, T> for RotationSurface<B, S>
where
    S: Coordinate,
    T: Coordinate,
    B: crate::Basis<S> + Over<S, T, Object: crate::Basis<T>>,
{
    type Object = RotationSurface<B::Object, T>;

    fn over(&self, convert: &impl Fn(&S) -> T) -> Result<Self::Object> {
        let profile = self.profile().over(convert)?;
        match self.range() {
            None => Ok(RotationSurface::half_turn(profile, self.half())),
            Some(range) => RotationSurface::sector(profile, self.half(), point(range, convert)),
        }
    }
}

impl<S, T, B> Over<S, T> for PlaneFamily<B, S>
where
    S: Coordinate,
    T: Coordinate,
    B: crate::Basis<S> + Over<S, T, Object: crate::Basis<T>>,
{
    type Object = PlaneFamily<B::Object, T>;

    fn over(&self, convert: &impl Fn(&S) -> T) -> Result<Self::Object> {
        let (unit, exponent) = self.unit_curve();
        PlaneFamily::of_parts(self.curve().over(convert)?, unit.over(convert)?, exponent)
    }
}

impl<S, T, B> Over<S, T> for EnvelopingPatch<B, S>
where
    S: Coordinate,
    T: Coordinate,
    B: crate::Basis<S> + Over<S, T, Object: crate::Basis<T>>,
{
    type Object = EnvelopingPatch<B::Object, T>;

    fn over(&self, convert: &impl Fn(&S) -> T) -> Result<Self::Object> {
        let bounds = match self.bounds() {
            PatchBounds::Range(range) => PatchBounds::Range(point(range, convert)),
            // The planes themselves, not their factors, which a ball of few bits might not hold.
            PatchBounds::Planes(planes) => {
                PatchBounds::Planes(planes.each_ref().map(|p| point(&unit_plane(p), convert)))
            }
        };
        EnvelopingPatch::new(self.family().over(convert)?, bounds)
    }
}

impl<S, T, B> Over<S, T> for TangentPatch<B, S>
where
    S: Coordinate,
    T: Coordinate,
    B: crate::Basis<S> + Over<S, T, Object: crate::Basis<T>>,
{
    type Object = TangentPatch<B::Object, T>;

    fn over(&self, convert: &impl Fn(&S) -> T) -> Result<Self::Object> {
        TangentPatch::new(self.family().over(convert)?, point(self.range(), convert))
    }
}

impl<S, T: Coordinate> Over<S, T> for HermiteCone<S> {
    type Object = HermiteCone<T>;

    fn over(&self, convert: &impl Fn(&S) -> T) -> Result<Self::Object> {
        let data = |list: &[[S; 3]]| list.iter().map(|p| point(p, convert)).collect();
        Ok(HermiteCone {
            summit: point(&self.summit, convert),
            ratio: convert(&self.ratio),
            p: data(&self.p),
            q: data(&self.q),
        })
    }
}

impl<S: Coordinate, T: Coordinate, P: Over<S, T>> Over<S, T> for PatchPart<P, S> {
    type Object = PatchPart<P::Object, T>;

    fn over(&self, convert: &impl Fn(&S) -> T) -> Result<Self::Object> {
        Ok(PatchPart {
            whole: self.whole.over(convert)?,
            range: self.range.each_ref().map(convert),
        })
    }
}
