//! Fig. 4a of hermite-developable: a quintic Hermite patch between two parallel planes.

use super::{Redrawn, Undrawn, parts, shaded};
use torse_figures::{Camera, Colour, Legend, Line, Picture, Place, Size, View, palette};
use torse_geometry::developable::{QuarticData, QuinticData};
use torse_geometry::{Bernstein, Curve, GeometryError, HermiteCone};

pub const FIGURE: Redrawn = Redrawn {
    paper: "hermite-developable",
    name: "hermite-developable-fig-4a",
    caption: "The quintic patch of Fig. 4a, from the data printed in Sect. 3.3 (k = 2). The boundary curves p \
              and q and the summit o are solved from the conditions themselves, not copied from the printed \
              solution. The rulings, continued as thin lines, meet in o: the patch is a piece of a cone. \
              The view is our choice.",
    alt: "A shaded strip between two wavy curves in parallel planes, crossed by straight rulings; their \
          continuations meet in one point beyond the smaller curve.",
    claims: &["hermite-developable/fig-4a"],
    draw,
};

fn draw() -> Result<Picture, Undrawn> {
    let data = QuinticData {
        quartic: QuarticData {
            p_start: [40.0, 40.0, 45.0],
            p_middle: [40.0, 12.5, 40.0],
            q_ends: [[-20.0, 60.0, 45.0], [-20.0, -50.0, 45.0]],
            q_tangents: [[0.0, -60.0, 90.0], [0.0, -50.0, -30.0]],
        },
        p_middle_tangent: [0.0, -25.0, 35.0],
    };
    let cone = HermiteCone::quintic(2.0, data)?;
    let patch = cone.patch()?;
    let (p, q) = (patch.first(), patch.second());
    let mut view = View::new();
    for u in parts(16) {
        view = view.curve(
            vec![p.point(&u)?, cone.summit],
            Line::solid(Colour::GREY, 0.7),
            "",
        );
    }
    let surface = shaded(&patch, 160, 12)?.lines(16, 0);
    let view = view
        .surface(surface)
        .curve(
            samples(p)?,
            Line::solid(palette(1), 2.4),
            "$\\mathbf{p}(u)$",
        )
        .curve(
            samples(q)?,
            Line::solid(palette(0), 2.4),
            "$\\mathbf{q}(u)$",
        )
        .points(vec![cone.summit], Colour::INK, "")
        .note(cone.summit, "$\\mathbf{o}$", Place::Right)
        .camera(Camera::Angles {
            azimuth: -35.0,
            elevation: 40.0,
        })
        .legend(Legend::Below);
    let size = Size {
        width: 620,
        height: 460,
    };
    Ok(view.draw("Quintic Hermite patch on a cone", size)?)
}

fn samples(curve: &Curve<Bernstein, f64, 3>) -> Result<Vec<[f64; 3]>, GeometryError> {
    parts(160).map(|u| curve.point(&u)).collect()
}
