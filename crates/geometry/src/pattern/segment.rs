//! Lines and circular arcs in the plane, as cutters know them: two ends and a bulge.

use std::f64::consts::PI;

/// A straight line or a circular arc from one point to another.
///
/// The *bulge* is the tangent of a quarter of the angle that the arc sweeps: 0 for a line, 1 for a half circle,
/// positive counterclockwise. That is how DXF polylines hold arcs.
///
/// ```
/// use torse_geometry::pattern::Segment;
/// // A quarter circle about the origin.
/// let arc = Segment { from: [1.0, 0.0], to: [0.0, 1.0], bulge: (std::f64::consts::PI / 8.0).tan() };
/// assert!((arc.length() - std::f64::consts::FRAC_PI_2).abs() < 1e-15);
/// assert!((arc.radius() - 1.0).abs() < 1e-15);
/// let [x, y] = arc.point(0.5);
/// assert!((x - 0.5_f64.sqrt()).abs() < 1e-15 && (y - 0.5_f64.sqrt()).abs() < 1e-15);
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Segment {
    /// Where it starts.
    pub from: [f64; 2],
    /// Where it ends.
    pub to: [f64; 2],
    /// The tangent of a quarter of the swept angle.
    pub bulge: f64,
}

impl Segment {
    /// The straight line between two points.
    #[must_use]
    pub fn line(from: [f64; 2], to: [f64; 2]) -> Self {
        let bulge = 0.0;
        Self { from, to, bulge }
    }

    /// Whether it is straight.
    #[must_use]
    pub fn is_line(&self) -> bool {
        self.bulge == 0.0
    }

    /// The vector from end to end.
    fn chord(&self) -> [f64; 2] {
        [self.to[0] - self.from[0], self.to[1] - self.from[1]]
    }

    /// The distance of the ends.
    #[must_use]
    pub fn chord_length(&self) -> f64 {
        let [x, y] = self.chord();
        libm::hypot(x, y)
    }

    /// The swept angle in radians, positive counterclockwise, 0 for a line.
    #[must_use]
    pub fn angle(&self) -> f64 {
        4.0 * libm::atan(self.bulge)
    }

    /// The radius; infinite for a line.
    #[must_use]
    pub fn radius(&self) -> f64 {
        let b = self.bulge.abs();
        0.25 * self.chord_length() * (b + 1.0 / b)
    }

    /// The length.
    #[must_use]
    pub fn length(&self) -> f64 {
        let half = 2.0 * libm::atan(self.bulge);
        let chord = self.chord_length();
        if half.abs() < 1e-4 {
            // phi / sin phi without dividing zero by zero.
            chord * (1.0 + half * half / 6.0)
        } else {
            chord * half / libm::sin(half)
        }
    }

    /// The largest distance of the arc from its chord.
    #[must_use]
    pub fn sagitta(&self) -> f64 {
        0.5 * self.chord_length() * self.bulge.abs()
    }

    /// The point at a share of the length between 0 and 1.
    #[must_use]
    pub fn point(&self, share: f64) -> [f64; 2] {
        if share >= 1.0 {
            return self.to;
        }
        let [x, y] = self.chord();
        let half = 2.0 * libm::atan(self.bulge);
        // In units of the chord: along it sin(share phi)/sin phi cos((1 - share) phi), below it with the sine.
        let ratio = if half.abs() < 1e-9 {
            share
        } else {
            libm::sin(share * half) / libm::sin(half)
        };
        let lift = (1.0 - share) * half;
        let (along, below) = (ratio * libm::cos(lift), ratio * libm::sin(lift));
        [
            self.from[0] + along * x + below * y,
            self.from[1] + along * y - below * x,
        ]
    }

    /// The area between the segment and the origin, positive when it goes round counterclockwise: the sum over a
    /// closed outline is its area.
    #[must_use]
    pub fn area(&self) -> f64 {
        let triangle = 0.5 * (self.from[0] * self.to[1] - self.from[1] * self.to[0]);
        let half = 2.0 * libm::atan(self.bulge);
        let chord = self.chord_length();
        // (2 phi - sin 2 phi)/(8 sin^2 phi), from its series for flat arcs.
        let cap = if half.abs() < 1e-2 {
            half / 6.0 * (1.0 + 2.0 / 15.0 * half * half)
        } else {
            (2.0 * half - libm::sin(2.0 * half)) / (8.0 * libm::sin(half).powi(2))
        };
        triangle + cap * chord * chord
    }

    /// The corners of the least box with sides along the axes that holds the segment, up to rounding.
    #[must_use]
    pub fn bounds(&self) -> [[f64; 2]; 2] {
        let (a, b) = (self.from, self.to);
        let mut low = [a[0].min(b[0]), a[1].min(b[1])];
        let mut high = [a[0].max(b[0]), a[1].max(b[1])];
        if let Some((centre, radius)) = self.circle() {
            let start = libm::atan2(a[1] - centre[1], a[0] - centre[0]);
            for (quarter, axis, sign) in
                [(0.0, 0, 1.0), (1.0, 1, 1.0), (2.0, 0, -1.0), (3.0, 1, -1.0)]
            {
                // How far it is to this extreme point, the way the arc goes.
                let way = (quarter * 0.5 * PI - start) * self.bulge.signum();
                if way.rem_euclid(2.0 * PI) <= self.angle().abs() {
                    let extreme = centre[axis] + sign * radius;
                    low[axis] = low[axis].min(extreme);
                    high[axis] = high[axis].max(extreme);
                }
            }
        }
        [low, high]
    }

    /// Centre and radius of an arc; `None` for lines.
    #[must_use]
    pub fn circle(&self) -> Option<([f64; 2], f64)> {
        let radius = self.radius();
        let [x, y] = self.chord();
        // From the middle of the chord, to the left of an arc less than a half circle counterclockwise.
        let height = (1.0 - self.bulge * self.bulge) / (4.0 * self.bulge);
        let centre = [
            0.5 * (self.from[0] + self.to[0]) - height * y,
            0.5 * (self.from[1] + self.to[1]) + height * x,
        ];
        (radius.is_finite() && height.is_finite()).then_some((centre, radius))
    }

    /// The distance of a point, up to rounding.
    ///
    /// ```
    /// use torse_geometry::pattern::Segment;
    /// let half = Segment { from: [1.0, 0.0], to: [-1.0, 0.0], bulge: 1.0 };
    /// assert!((half.distance([0.0, 3.0]) - 2.0).abs() < 1e-15);
    /// assert!((half.distance([1.0, -1.0]) - 1.0).abs() < 1e-15);
    /// assert_eq!(Segment::line([0.0, 0.0], [2.0, 0.0]).distance([1.0, 0.5]), 0.5);
    /// ```
    #[must_use]
    pub fn distance(&self, point: [f64; 2]) -> f64 {
        let ends = [self.from, self.to].map(|e| libm::hypot(point[0] - e[0], point[1] - e[1]));
        let to_ends = ends[0].min(ends[1]);
        let ([x, y], chord) = (self.chord(), self.chord_length());
        let from = [point[0] - self.from[0], point[1] - self.from[1]];
        if let Some((centre, radius)) = self.circle() {
            let way = |p: [f64; 2]| libm::atan2(p[1] - centre[1], p[0] - centre[0]);
            let turned = (way(point) - way(self.from)) * self.bulge.signum();
            if turned.rem_euclid(2.0 * PI) <= self.angle().abs() {
                let away = libm::hypot(point[0] - centre[0], point[1] - centre[1]);
                // By the equation of the circle in the frame of the chord, which flat arcs need.
                let (u, v) = (
                    (from[0] * x + from[1] * y) / chord,
                    (from[1] * x - from[0] * y) / chord,
                );
                return to_ends
                    .min(self.off_circle(u, v, chord).abs() * 2.0 * radius / (away + radius));
            }
            return to_ends;
        }
        if chord == 0.0 {
            return to_ends;
        }
        let share = (from[0] * x + from[1] * y) / (chord * chord);
        if (0.0..=1.0).contains(&share) {
            (from[1] * x - from[0] * y).abs() / chord
        } else {
            to_ends
        }
    }

    /// `(d^2 - r^2)/(2 r)` for a point at distance `d` from the centre, at `u` along and `v` above the chord:
    /// the distance from the circle to first order, without the cancellation of large circles, and the
    /// distance from the line for a bulge of zero.
    pub(super) fn off_circle(&self, u: f64, v: f64, chord: f64) -> f64 {
        let b = self.bulge;
        (2.0 * b / chord * (u * u + v * v - chord * u) - (1.0 - b * b) * v) / (1.0 + b * b)
    }

    /// The same segment from its end to its start.
    #[must_use]
    pub fn reversed(&self) -> Self {
        Self {
            from: self.to,
            to: self.from,
            bulge: -self.bulge,
        }
    }

    /// The part between two shares of the length, from 0 to 1; the ends are met exactly.
    ///
    /// ```
    /// use torse_geometry::pattern::Segment;
    /// let half = Segment { from: [1.0, 0.0], to: [-1.0, 0.0], bulge: 1.0 };
    /// let part = half.part(0.25, 0.75);
    /// assert!((part.length() - 0.5 * half.length()).abs() < 1e-14);
    /// assert_eq!(part.from, half.point(0.25));
    /// ```
    #[must_use]
    pub fn part(&self, from: f64, to: f64) -> Self {
        Self {
            from: if from <= 0.0 {
                self.from
            } else {
                self.point(from)
            },
            to: self.point(to),
            bulge: libm::tan((to.min(1.0) - from.max(0.0)) * libm::atan(self.bulge)),
        }
    }

    /// Both halves.
    pub(super) fn halves(&self) -> [Self; 2] {
        let middle = self.point(0.5);
        let bulge = libm::tan(0.5 * libm::atan(self.bulge));
        let (from, to) = (self.from, self.to);
        [
            Self {
                from,
                to: middle,
                bulge,
            },
            Self {
                from: middle,
                to,
                bulge,
            },
        ]
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn any() -> impl Strategy<Value = Segment> {
        let point = || prop::array::uniform2(-5.0..5.0_f64);
        (point(), point(), -3.0..3.0_f64)
            .prop_filter("ends apart", |(a, b, _)| {
                libm::hypot(a[0] - b[0], a[1] - b[1]) > 1e-3
            })
            .prop_map(|(from, to, bulge)| Segment { from, to, bulge })
    }

    proptest! {
        #[test]
        fn all_points_are_on_the_circle_and_the_polygon_through_them_has_length_and_area(s in any()) {
            let n = 2000;
            let points: Vec<_> = (0..=n).map(|i| s.point(f64::from(i) / f64::from(n))).collect();
            let (centre, radius) = s.circle().unwrap_or(([0.0; 2], 1.0));
            let [low, high] = s.bounds();
            let (mut length, mut area) = (0.0, 0.0);
            for (a, b) in points.iter().zip(&points[1..]) {
                length += libm::hypot(b[0] - a[0], b[1] - a[1]);
                area += 0.5 * (a[0] * b[1] - a[1] * b[0]);
                let off = libm::hypot(b[0] - centre[0], b[1] - centre[1]) - radius;
                prop_assert!(s.is_line() || off.abs() < 1e-9 * radius.max(1.0));
                let slack = 1e-9 * radius.max(1.0);
                prop_assert!((0..2).all(|k| low[k] - slack <= b[k] && b[k] <= high[k] + slack));
                prop_assert!(s.distance(*b) <= 1e-7);
            }
            prop_assert!((length - s.length()).abs() < 1e-4 * s.length());
            prop_assert!((area - s.area()).abs() < 1e-3 * (1.0 + s.length()).powi(2));
        }

        #[test]
        fn flat_arcs_have_the_length_and_area_of_their_series(bend in -1e-2..1e-2_f64) {
            let s = Segment { from: [0.0, 0.0], to: [2.0, 0.0], bulge: bend };
            let half = 2.0 * libm::atan(bend);
            if half.abs() > 1e-3 {
                let radius = 1.0 / libm::sin(half);
                prop_assert!((s.length() - 2.0 * radius * half).abs() < 1e-12);
                let area = 0.5 * radius * radius * (2.0 * half - libm::sin(2.0 * half));
                prop_assert!((s.area() - area).abs() < 1e-10, "{} {}", s.area(), area);
            }
        }
    }
}
