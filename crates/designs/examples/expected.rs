//! What independent readers should find in the files that the command writes of each design, as `manifest.json`: areas,
//! volumes, proved distances, points of the surface and of the exact outline, all from the library and none from a file.
//!
//! ```text
//! cargo run -p torse-designs --example expected -- designs target/files
//! ```
//!
//! `tests/exchange/check.py` runs it, runs the command beside it, and compares.

use serde_json::{Value, json};
use std::error::Error;
use std::path::PathBuf;
use torse_designs::export::{mesh, model};
use torse_designs::inspect::inspect;
use torse_designs::unroll::{Demand, PatternSummary, unroll};
use torse_designs::{Design, load};
use torse_exchange::write_file;
use torse_geometry::Surface;
use torse_geometry::pattern::PatternPlace;
use torse_geometry::vector::{norm, sub};

type Outcome<T> = Result<T, Box<dyn Error>>;

fn main() -> Outcome<()> {
    let mut arguments = std::env::args().skip(1).map(PathBuf::from);
    let (Some(from), Some(to)) = (arguments.next(), arguments.next()) else {
        return Err("name the folder of the designs and one for the manifest".into());
    };
    std::fs::create_dir_all(&to)?;
    let mut paths: Vec<PathBuf> = std::fs::read_dir(from)?
        .map(|entry| Ok(entry?.path()))
        .collect::<std::io::Result<_>>()?;
    paths.retain(|path| path.extension().is_some_and(|ending| ending == "toml"));
    paths.sort();
    let (mut models, mut meshes, mut outlines) = (Vec::new(), Vec::new(), Vec::new());
    for path in paths {
        let design = load(&path)?;
        models.push(surfaces(&design)?);
        meshes.push(triangles(&design)?);
        outlines.push(cuts(&design)?);
    }
    let manifest = json!({ "models": models, "meshes": meshes, "outlines": outlines });
    let text = serde_json::to_string_pretty(&manifest)?;
    write_file(&to.join("manifest.json"), text.as_bytes())?;
    Ok(())
}

/// The name of the file of this kind.
fn file(design: &Design, ending: &str) -> String {
    format!("{}.{ending}", design.name)
}

fn surfaces(design: &Design) -> Outcome<Value> {
    let model = model(design)?;
    let mut points = Vec::new();
    for patch in &design.patches {
        for (i, j) in (0..=8).flat_map(|i| (0..=3).map(move |j| (i, j))) {
            points.push(patch.sheet.point(f64::from(i) / 8.0, f64::from(j) / 3.0)?);
        }
    }
    let report = inspect(design)?;
    let mut area: f64 = report.patches.iter().filter_map(|p| p.area).sum();
    // A surface that is moved by a distance changes its area at the border and where it is bent.
    let mut border = 0.0;
    for piece in unroll(design, &Demand::default())? {
        border += piece.flat.outline().length();
        for ruling in piece.flat.rulings() {
            let [[x0, y0], [x1, y1]] = ruling.ends;
            border += ruling.bend.abs() * libm::hypot(x1 - x0, y1 - y0);
        }
    }
    for surface in &report.surfaces {
        area += surface.area;
        border += surface
            .radius
            .map_or(0.0, |radius| 2.0 * surface.area / radius);
    }
    let parts = design.surfaces.iter().flat_map(|surface| &surface.parts);
    let mut faces = design.patches.len();
    for part in parts {
        faces += 1;
        let at = |i: u32, j: u32| part.point(&(f64::from(i) / 16.0), &(f64::from(j) / 16.0));
        for k in 0..=16 {
            points.extend([at(k, 0)?, at(k, 16)?, at(0, k)?, at(16, k)?, at(k, 8)?]);
        }
        // About once round it.
        let [a, b, c] = [at(0, 0)?, at(16, 0)?, at(0, 16)?];
        border += 4.0 * (norm(&sub(&b, &a)) + norm(&sub(&c, &a)));
    }
    Ok(json!({
        "step": file(design, "step"),
        "iges": file(design, "igs"),
        "faces": faces,
        "area": area,
        "area_within": border * model.error(),
        "error": model.error(),
        "sewing": model.sewing(),
        "points": points,
    }))
}

fn triangles(design: &Design) -> Outcome<Value> {
    let files = ["stl", "obj", "ply", "3mf", "glb"].map(|ending| file(design, ending));
    let mesh = mesh(design)?;
    Ok(json!({
        "files": files,
        "triangles": mesh.triangles().len(),
        "area": mesh.area(),
        "volume": mesh.volume(),
        "watertight": mesh.is_watertight(),
    }))
}

/// The outlines with points of the exact development.
fn cuts(design: &Design) -> Outcome<Value> {
    let pieces = unroll(design, &Demand::default())?;
    let summary = PatternSummary::new(design, &pieces);
    let mut list = Vec::new();
    for (piece, numbers) in pieces.iter().zip(&summary.pieces) {
        let mut points = Vec::new();
        for index in 0..piece.flat.pieces() {
            for (k, v) in (0..=40).flat_map(|k| [(k, 0.0), (k, 1.0)]) {
                let place = PatternPlace {
                    piece: index,
                    x: f64::from(k) / 40.0,
                    v,
                };
                points.extend(piece.flat.flatten(place));
            }
        }
        list.push(json!({
            "name": numbers.name,
            "length": numbers.cut,
            "area": piece.flat.outline().area(),
            "rulings": piece.flat.rulings().len(),
            "error": numbers.outline_error,
            "points": points,
        }));
    }
    let (dxf, svg) = (file(design, "dxf"), file(design, "svg"));
    Ok(json!({ "dxf": dxf, "svg": svg, "pieces": list }))
}
