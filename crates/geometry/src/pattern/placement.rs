//! Where a flat piece lies: moved, turned, turned over.

use super::segment::Segment;

/// A motion of the plane, with or without turning over: first a mirroring in the first axis (where it turns
/// over), then a rotation about the origin, then a shift.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Placement {
    cosine: f64,
    sine: f64,
    shift: [f64; 2],
    mirrored: bool,
}

impl Default for Placement {
    fn default() -> Self {
        Self::shifted([0.0, 0.0])
    }
}

impl Placement {
    /// A shift.
    #[must_use]
    pub fn shifted(shift: [f64; 2]) -> Self {
        Self {
            cosine: 1.0,
            sine: 0.0,
            shift,
            mirrored: false,
        }
    }

    /// A rotation about the origin by an angle in radians, counterclockwise.
    #[must_use]
    pub fn turned(angle: f64) -> Self {
        let (sine, cosine) = libm::sincos(angle);
        Self {
            cosine,
            sine,
            ..Self::default()
        }
    }

    /// The mirroring that keeps the first coordinate and changes the sign of the second: the sheet turned over.
    #[must_use]
    pub fn mirrored() -> Self {
        Self {
            mirrored: true,
            ..Self::default()
        }
    }

    /// Whether the sheet is turned over.
    #[must_use]
    pub fn is_mirrored(&self) -> bool {
        self.mirrored
    }

    /// The image of a point.
    #[must_use]
    pub fn point(&self, [x, y]: [f64; 2]) -> [f64; 2] {
        let y = if self.mirrored { -y } else { y };
        [
            self.cosine * x - self.sine * y + self.shift[0],
            self.sine * x + self.cosine * y + self.shift[1],
        ]
    }

    /// The point whose image this is.
    #[must_use]
    pub fn point_back(&self, [x, y]: [f64; 2]) -> [f64; 2] {
        let (x, y) = (x - self.shift[0], y - self.shift[1]);
        let (a, b) = (
            self.cosine * x + self.sine * y,
            self.cosine * y - self.sine * x,
        );
        [a, if self.mirrored { -b } else { b }]
    }

    /// First `self`, then `next`.
    ///
    /// ```
    /// use torse_geometry::pattern::Placement;
    /// let both = Placement::mirrored().then(&Placement::turned(0.5)).then(&Placement::shifted([1.0, 2.0]));
    /// let step = Placement::turned(0.5).point(Placement::mirrored().point([3.0, 4.0]));
    /// let point = both.point([3.0, 4.0]);
    /// assert!((point[0] - step[0] - 1.0).abs() < 1e-15 && (point[1] - step[1] - 2.0).abs() < 1e-15);
    /// let back = both.point_back(point);
    /// assert!((back[0] - 3.0).abs() < 1e-15 && (back[1] - 4.0).abs() < 1e-15);
    /// ```
    #[must_use]
    pub fn then(&self, next: &Self) -> Self {
        // A mirroring passes a rotation by changing its sense.
        let sine = if next.mirrored { -self.sine } else { self.sine };
        Self {
            cosine: next.cosine * self.cosine - next.sine * sine,
            sine: next.sine * self.cosine + next.cosine * sine,
            shift: next.point(self.shift),
            mirrored: self.mirrored != next.mirrored,
        }
    }

    /// The motion, turned over or not, that takes the directed line from `from[0]` to `from[1]` onto that from
    /// `to[0]` to `to[1]`, first point onto first point; `None` for points that coincide.
    pub(super) fn taking(from: [[f64; 2]; 2], to: [[f64; 2]; 2], mirrored: bool) -> Option<Self> {
        let start = if mirrored {
            Self::mirrored()
        } else {
            Self::default()
        };
        let from = from.map(|p| start.point(p));
        let a = [from[1][0] - from[0][0], from[1][1] - from[0][1]];
        let b = [to[1][0] - to[0][0], to[1][1] - to[0][1]];
        let (cosine, sine) = (a[0] * b[0] + a[1] * b[1], a[0] * b[1] - a[1] * b[0]);
        let length = libm::hypot(cosine, sine);
        if !(length > 0.0 && length.is_finite()) {
            return None;
        }
        let turn = Self {
            cosine: cosine / length,
            sine: sine / length,
            ..Self::default()
        };
        let moved = turn.point(from[0]);
        let shift = Self::shifted([to[0][0] - moved[0], to[0][1] - moved[1]]);
        Some(start.then(&turn).then(&shift))
    }

    /// The image of a segment.
    #[must_use]
    pub fn segment(&self, segment: &Segment) -> Segment {
        Segment {
            from: self.point(segment.from),
            to: self.point(segment.to),
            bulge: if self.mirrored {
                -segment.bulge
            } else {
                segment.bulge
            },
        }
    }
}
