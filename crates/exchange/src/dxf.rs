//! DXF R12 of flat patterns.

use crate::decimal;
use std::fmt::Write;
use torse_geometry::pattern::FlatPattern;

/// The flat pattern as DXF R12: the outline as one closed polyline on the layer `OUTLINE`, every ruling
/// whose index is a multiple of `every` as a line on the layer `RULINGS` (none for `every = 0`).
///
/// R12 is the dialect that every cutting machine reads.
///
/// ```
/// use torse_geometry::{Bernstein, Curve, RuledSurface, pattern::unroll};
/// let rail = |x: f64| Curve::new(Bernstein, vec![[x, 0.0, 0.0], [x, 2.0, 0.0]]);
/// let flat = unroll(&RuledSurface::new(rail(0.0)?, rail(1.0)?), 2, 1e-6)?;
/// let text = torse_exchange::dxf(&flat, 1);
/// assert!(text.starts_with("0\nSECTION\n") && text.ends_with("0\nEOF\n"));
/// assert_eq!(text.matches("\nVERTEX\n").count(), 4);
/// assert_eq!(text.matches("\nLINE\n").count(), 2);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[must_use]
pub fn dxf(flat: &FlatPattern, every: usize) -> String {
    let mut text = String::from("0\nSECTION\n2\nHEADER\n9\n$ACADVER\n1\nAC1009\n0\nENDSEC\n");
    text.push_str("0\nSECTION\n2\nTABLES\n0\nTABLE\n2\nLAYER\n70\n2\n");
    for (layer, colour) in [("OUTLINE", 7), ("RULINGS", 8)] {
        let _ = write!(
            text,
            "0\nLAYER\n2\n{layer}\n70\n0\n62\n{colour}\n6\nCONTINUOUS\n"
        );
    }
    text.push_str("0\nENDTAB\n0\nENDSEC\n0\nSECTION\n2\nENTITIES\n");
    text.push_str("0\nPOLYLINE\n8\nOUTLINE\n66\n1\n70\n1\n10\n0\n20\n0\n30\n0\n");
    for ([x, y], bulge) in flat.outline().vertices() {
        let (x, y, bulge) = (decimal(x), decimal(y), decimal(bulge));
        let _ = write!(
            text,
            "0\nVERTEX\n8\nOUTLINE\n10\n{x}\n20\n{y}\n30\n0\n42\n{bulge}\n"
        );
    }
    text.push_str("0\nSEQEND\n8\nOUTLINE\n");
    for [[x0, y0], [x1, y1]] in super::every(flat, every) {
        let [x0, y0, x1, y1] = [x0, y0, x1, y1].map(decimal);
        let _ = write!(
            text,
            "0\nLINE\n8\nRULINGS\n10\n{x0}\n20\n{y0}\n30\n0\n11\n{x1}\n21\n{y1}\n31\n0\n"
        );
    }
    text.push_str("0\nENDSEC\n0\nEOF\n");
    text
}
