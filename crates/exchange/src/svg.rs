//! SVG of flat patterns.

use crate::decimal;
use std::fmt::Write;
use torse_geometry::pattern::FlatPattern;

/// The flat pattern as SVG in true size (one unit is one millimetre): the outline as a path, every ruling
/// whose index is a multiple of `every` as a thin line (none for `every = 0`).
///
/// ```
/// use torse_geometry::{Bernstein, Curve, RuledSurface, pattern::unroll};
/// let rail = |x: f64| Curve::new(Bernstein, vec![[x, 0.0, 0.0], [x, 2.0, 0.0]]);
/// let flat = unroll(&RuledSurface::new(rail(0.0)?, rail(1.0)?), 2, 1e-6)?;
/// let text = torse_exchange::svg(&flat, 1);
/// // A margin of a fiftieth of the larger side; y points up in the pattern and down in SVG.
/// assert!(text.contains(r#"viewBox="-0.04 -2.04 1.08 2.08""#));
/// assert!(text.contains(r#"d="M1 0L1 -2L0 -2L0 0Z""#));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[must_use]
pub fn svg(flat: &FlatPattern, every: usize) -> String {
    let outline = flat.outline().polygon(flat.tolerance()).unwrap_or_default();
    let bound = |axis: usize, start: f64, pick: fn(f64, f64) -> f64| {
        outline.iter().map(|p| p[axis]).fold(start, pick)
    };
    let (x0, x1) = (
        bound(0, f64::INFINITY, f64::min),
        bound(0, f64::NEG_INFINITY, f64::max),
    );
    let (y0, y1) = (
        bound(1, f64::INFINITY, f64::min),
        bound(1, f64::NEG_INFINITY, f64::max),
    );
    let (mut width, mut height) = (x1 - x0, y1 - y0);
    if !(width.is_finite() && height.is_finite()) {
        (width, height) = (0.0, 0.0);
    }
    let margin = 0.02 * width.max(height);
    let (w, h) = (
        decimal(width + 2.0 * margin),
        decimal(height + 2.0 * margin),
    );
    let (left, top) = (decimal(x0 - margin), decimal(-y1 - margin));
    let stroke = decimal(0.1 * margin);
    let mut text = format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{w}mm\" height=\"{h}mm\" \
         viewBox=\"{left} {top} {w} {h}\" fill=\"none\" stroke=\"black\" stroke-width=\"{stroke}\">\n"
    );
    let point = |[x, y]: [f64; 2]| format!("{} {}", decimal(x), decimal(-y));
    let path: Vec<String> = outline.iter().map(|p| point(*p)).collect();
    let _ = writeln!(text, "<path d=\"M{}Z\"/>", path.join("L"));
    for [a, b] in super::every(flat, every) {
        let _ = writeln!(
            text,
            "<path d=\"M{}L{}\" stroke=\"gray\"/>",
            point(a),
            point(b)
        );
    }
    text.push_str("</svg>\n");
    text
}
