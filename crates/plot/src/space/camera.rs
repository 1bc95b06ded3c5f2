//! The direction of the view, and the projection onto the page.
//!
//! The projection is that of plotters (`ProjectionMatrixBuilder`: a rotation by yaw and pitch), with sines that have the same
//! bits on every platform. plotters' vertical axis is its second one, so our (x, y, z) is its (x, z, -y), a rotation, which
//! keeps right-handed frames right-handed; its third coordinate is then the distance from the viewer.

use crate::ink::scene::Rect;
use crate::space::vector::{V3, dot, sub};

/// Direction of the view.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub enum Camera {
    /// Chosen from the solids: the usual direction in which most of the surfaces, or else the largest
    /// outline of the points, is seen.
    #[default]
    Auto,
    /// From the direction `(cos e cos a, cos e sin a, sin e)` towards the object.
    Angles {
        /// The angle `a` in degrees, from the x axis towards the y axis, -360 to 360.
        azimuth: f64,
        /// The angle `e` in degrees, above the horizon, -90 to 90.
        elevation: f64,
    },
}

/// Directions tried by [`Camera::Auto`], the most usual first: (azimuth, elevation) in degrees.
const CANDIDATES: [(f64, f64); 12] = [
    (-60.0, 25.0),
    (-35.0, 25.0),
    (-60.0, 40.0),
    (-120.0, 25.0),
    (30.0, 25.0),
    (60.0, 25.0),
    (120.0, 25.0),
    (150.0, 25.0),
    (-35.0, 40.0),
    (-120.0, 40.0),
    (30.0, 40.0),
    (120.0, 40.0),
];

/// Penalty for each step down the list of candidates, as a fraction of the best score: usual directions are preferred.
const HABIT: f64 = 0.012;

impl Camera {
    /// The axes of the view for area vectors of the surfaces and, without any, for a cloud of points.
    pub(crate) fn resolve(self, areas: &[V3], cloud: &[V3]) -> Axes {
        match self {
            Camera::Angles { azimuth, elevation } => Axes::new(azimuth, elevation),
            Camera::Auto => {
                let score = |axes: &Axes| {
                    if areas.is_empty() {
                        let w = width(cloud, axes.right);
                        return w * width(cloud, axes.down);
                    }
                    // A view onto the front is worth a little more than one onto the back.
                    areas
                        .iter()
                        .map(|a| -dot(*a, axes.away))
                        .map(|facing| facing.abs() * if facing > 0.0 { 1.15 } else { 1.0 })
                        .sum()
                };
                let mut best: Option<(f64, Axes)> = None;
                for (k, (azimuth, elevation)) in CANDIDATES.into_iter().enumerate() {
                    let axes = Axes::new(azimuth, elevation);
                    let value = score(&axes) * (1.0 - HABIT * k as f64);
                    if best.is_none_or(|(top, _)| value > top) {
                        best = Some((value, axes));
                    }
                }
                best.map_or_else(|| Axes::new(-60.0, 25.0), |(_, axes)| axes)
            }
        }
    }
}

fn width(cloud: &[V3], direction: V3) -> f64 {
    let along = cloud.iter().map(|p| dot(*p, direction));
    let [low, high] = along.fold([f64::INFINITY, f64::NEG_INFINITY], |[l, h], v| {
        [l.min(v), h.max(v)]
    });
    (high - low).max(0.0)
}

/// Unit vectors of space that point right, down and away on the page.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Axes {
    pub right: V3,
    pub down: V3,
    pub away: V3,
}

impl Axes {
    /// From angles in degrees.
    pub(crate) fn new(azimuth: f64, elevation: f64) -> Axes {
        let (a, e) = (azimuth.to_radians(), elevation.to_radians());
        let ([sa, ca], [se, ce]) = ([libm::sin(a), libm::cos(a)], [libm::sin(e), libm::cos(e)]);
        Axes {
            right: [-sa, ca, 0.0],
            down: [se * ca, se * sa, -ce],
            away: [-ce * ca, -ce * sa, -se],
        }
    }
}

/// Parallel projection onto the page.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Projection {
    pub axes: Axes,
    /// Point of space in the middle of the picture.
    centre: V3,
    /// Its place on the page.
    middle: [f64; 2],
    /// Pixels per unit.
    pub scale: f64,
}

impl Projection {
    /// The largest projection that shows all of `points` in `room`.
    pub(crate) fn fit(axes: Axes, points: &[V3], room: Rect) -> Projection {
        let side = |direction: V3| {
            let along = points.iter().map(|p| dot(*p, direction));
            along.fold([f64::INFINITY, f64::NEG_INFINITY], |[l, h], v| {
                [l.min(v), h.max(v)]
            })
        };
        let ([x0, x1], [y0, y1], [z0, z1]) = (side(axes.right), side(axes.down), side(axes.away));
        let scale = (room.w / (x1 - x0).max(1e-300)).min(room.h / (y1 - y0).max(1e-300));
        let (a, b, c) = ((x0 + x1) / 2.0, (y0 + y1) / 2.0, (z0 + z1) / 2.0);
        Projection {
            axes,
            centre: [0, 1, 2].map(|k| a * axes.right[k] + b * axes.down[k] + c * axes.away[k]),
            middle: [room.x + room.w / 2.0, room.y + room.h / 2.0],
            scale,
        }
    }

    /// Place on the page in pixels, and nearness to the viewer in the same unit.
    pub(crate) fn apply(&self, p: V3) -> V3 {
        let d = sub(p, self.centre);
        let Axes { right, down, away } = self.axes;
        [
            self.middle[0] + self.scale * dot(d, right),
            self.middle[1] + self.scale * dot(d, down),
            -self.scale * dot(d, away),
        ]
    }

    /// A direction of space in the frame (right, up, towards the viewer).
    pub(crate) fn turn(&self, v: V3) -> V3 {
        let Axes { right, down, away } = self.axes;
        [dot(v, right), -dot(v, down), -dot(v, away)]
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::space::vector::cross;
    use plotters::coord::CoordTranslate;
    use plotters::coord::cartesian::Cartesian3d;
    use plotters::coord::ranged3d::ProjectionMatrixBuilder;
    use plotters::coord::types::RangedCoordf64;

    #[test]
    fn the_view_is_taken_from_the_stated_direction_with_z_upwards() {
        for (a, e) in [(-60.0, 25.0), (30.0, 60.0), (135.0, -20.0f64), (0.0, 0.0)] {
            let (ar, er): (f64, f64) = (f64::to_radians(a), f64::to_radians(e));
            let axes = Axes::new(a, e);
            let eye = [
                libm::cos(er) * libm::cos(ar),
                libm::cos(er) * libm::sin(ar),
                libm::sin(er),
            ];
            assert!((dot(eye, axes.away) + 1.0).abs() < 1e-12);
            assert!(axes.right[2].abs() < 1e-12 && axes.down[2] < 0.0);
            // Right, up and towards the viewer are a right-handed frame: nothing is mirrored.
            let up = axes.down.map(|c| -c);
            assert!((dot(cross(axes.right, up), axes.away) + 1.0).abs() < 1e-12);
        }
    }

    #[test]
    fn the_axes_are_those_of_plotters_up_to_rounding() {
        for (azimuth, elevation) in [(-60.0, 25.0), (30.0, 60.0), (135.0, -20.0), (0.0, 90.0)] {
            let mut builder = ProjectionMatrixBuilder::new();
            builder.yaw = f64::to_radians(azimuth + 90.0);
            builder.pitch = f64::to_radians(elevation);
            let matrix = builder.into_matrix();
            let [right, down, away, _] = matrix.as_ref().map(|[x, y, z, _]| [x, -z, y]);
            let ours = Axes::new(azimuth, elevation);
            for (theirs, own) in [(right, ours.right), (down, ours.down), (away, ours.away)] {
                assert!(
                    (0..3).all(|k| (theirs[k] - own[k]).abs() < 1e-15),
                    "{theirs:?} {own:?}"
                );
            }
        }
    }

    #[test]
    fn points_fall_where_plotters_puts_them() {
        let (azimuth, elevation) = (-50.0f64, 30.0f64);
        // A cube of 1000 units of plotters' pixels; y enters reversed as the third coordinate.
        let mut chart: Cartesian3d<RangedCoordf64, RangedCoordf64, RangedCoordf64> =
            Cartesian3d::new(0.0..1.0, 0.0..1.0, 1.0..0.0, (0..4000, 0..3000));
        chart.set_coord_pixel_range(0..4000, 0..3000, (1000, 1000, 1000));
        chart.set_projection(0..4000, 0..3000, |mut b| {
            (b.yaw, b.pitch) = ((azimuth + 90.0).to_radians(), elevation.to_radians());
            b.into_matrix()
        });
        let ours = Projection {
            axes: Axes::new(azimuth, elevation),
            centre: [0.5; 3],
            middle: [2000.0, 1500.0],
            scale: 1000.0,
        };
        let mut depths = Vec::new();
        for p in [
            [0.0, 0.0, 0.0],
            [1.0, 0.0, 0.0],
            [0.2, 0.9, 0.4],
            [0.0, 1.0, 0.0],
            [1.0, 1.0, 1.0],
        ] {
            let coord = (p[0], p[2], p[1]);
            let (x, y) = chart.translate(&coord);
            let [ox, oy, near] = ours.apply(p);
            assert!(
                (ox - f64::from(x)).abs() <= 2.0 && (oy - f64::from(y)).abs() <= 2.0,
                "{p:?}"
            );
            depths.push(f64::from(chart.depth(&coord)) + near);
        }
        // plotters counts distance, we count nearness: they add to a constant.
        assert!(
            depths.iter().all(|d| (d - depths[0]).abs() <= 3.0),
            "{depths:?}"
        );
    }

    #[test]
    fn the_chosen_view_looks_at_a_wall_from_its_front() {
        let wall_towards_minus_y = [[0.0, -1.0, 0.0]];
        let axes = Camera::Auto.resolve(&wall_towards_minus_y, &[]);
        assert!(-dot(wall_towards_minus_y[0], axes.away) > 0.75);
        let wall_towards_plus_x = [[1.0, 0.0, 0.0]];
        let axes = Camera::Auto.resolve(&wall_towards_plus_x, &[]);
        assert!(-dot(wall_towards_plus_x[0], axes.away) > 0.7);
    }
}
