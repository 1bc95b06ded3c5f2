//! The commands of an SVG path: straight sides and circular arcs, as text.

use crate::drawing::{Arc, Path};
use std::fmt::Write;

/// The commands of a path, absolute and in the shortest form that reads back to the same numbers; y points down.
pub(super) fn commands(path: &Path) -> String {
    let point = |[x, y]: [f64; 2]| format!("{} {}", x + 0.0, 0.0 - y);
    let start = path.vertices().first().map(|v| v.point).unwrap_or_default();
    let mut text = format!("M{}", point(start));
    let straight_back = |to: [f64; 2], bulge: f64| path.is_closed() && to == start && bulge == 0.0;
    for (from, to) in path.sides() {
        match Arc::from_bulge(from, to) {
            Some(arc) => {
                // Left in the drawing is against the clock, which SVG, with y down, calls negative.
                let (large, sweep) = (u8::from(from.bulge.abs() > 1.0), u8::from(from.bulge < 0.0));
                let r = arc.radius;
                let _ = write!(text, "A{r} {r} 0 {large} {sweep} {}", point(to));
            }
            None if straight_back(to, from.bulge) => {}
            None => text.push_str(&format!("L{}", point(to))),
        }
    }
    if path.is_closed() {
        text.push('Z');
    }
    text
}
