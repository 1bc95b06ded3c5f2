//! A developable sheet from four planes: certificate, flat pattern and every file format.
//!
//! ```text
//! cargo run -p torse-exchange --example sheet -- target/sheet
//! ```

use std::error::Error;
use std::path::PathBuf;
use torse_algebra::rational::to_f64;
use torse_exchange::{self as export, BezierPatch, Mesh};
use torse_geometry::developable::{QuarticData, certify, oblique_image};
use torse_geometry::pattern::unroll;
use torse_geometry::{
    Bounds, EnvelopingPatch, Gbt, HermiteCone, Over, PlaneFamily, Rails, exact, hermite,
};

fn main() -> Result<(), Box<dyn Error>> {
    let folder = PathBuf::from(
        std::env::args()
            .nth(1)
            .ok_or("name a folder for the files")?,
    );
    std::fs::create_dir_all(&folder)?;

    let planes = vec![
        [7.0, -7.0, 5.0, 125.0],
        [-7.0, -7.0, 5.0, 120.0],
        [-7.0, 7.0, 5.0, 130.0],
        [7.0, 7.0, 5.0, 125.0],
    ];
    let family = PlaneFamily::new(Gbt::new(0.5, 0.25)?, planes)?;
    let cuts = Bounds::Planes([[0.0, 0.0, 1.0, 0.0], [0.0, 0.0, 1.0, 5.0]]);
    let sheet = EnvelopingPatch::new(family, cuts)?;
    println!("{:#?}", certify(&sheet, 64)?);

    let flat = unroll(&sheet, 64, 1e-6)?;
    println!(
        "flat pattern: error {:.1e}, strain {:.1e}",
        flat.errors().outline,
        flat.strain()
    );
    std::fs::write(folder.join("sheet.dxf"), export::dxf(&flat, 16))?;
    std::fs::write(folder.join("sheet.svg"), export::svg(&flat, 16))?;

    let mesh = Mesh::of(&sheet, 64, 4)?;
    std::fs::write(folder.join("sheet.stl"), export::stl(&mesh))?;
    std::fs::write(folder.join("sheet.obj"), export::obj(&mesh))?;
    std::fs::write(folder.join("sheet.glb"), export::glb(&mesh))?;

    // A cone between two parallel planes, and the same cone cut by an oblique plane, exactly.
    let data = QuarticData {
        p_start: [40.0, 40.0, 45.0],
        p_middle: [40.0, 12.5, 60.0],
        q_ends: [[-20.0, 60.0, 45.0], [-20.0, -50.0, 45.0]],
        q_tangents: [[0.0, -30.0, 60.0], [0.0, -50.0, -60.0]],
    };
    let cone = HermiteCone::quartic(2.0, data)?;
    let image = oblique_image(&cone, &[20.0, -3.0, 0.0, -580.0])?;
    let patches = [
        BezierPatch::ruled(&cone.patch()?)?,
        BezierPatch::between(&hermite::curve(&cone.p)?, &image)?,
    ];
    std::fs::write(folder.join("cone.step"), export::step(&patches))?;

    // The same cone over the rationals: the apex without rounding.
    let ends = cone
        .patch()?
        .over(&|x| exact(*x))?
        .ruling_ends(&exact(0.5))?;
    println!("middle ruling: {:?}", ends.map(|p| p.map(|x| to_f64(&x))));
    Ok(())
}
