//! One file of each kind with what an independent reader should find in it, as `manifest.json`: the areas,
//! proved distances and points by the library itself.
//!
//! ```text
//! cargo run -p torse-exchange --example files -- target/files
//! python3 tests/exchange/check.py target/files
//! ```

use std::error::Error;
use std::path::{Path, PathBuf};
use torse_exchange::{
    CadModel, Converted, Drawing, ExactForm, Layer, Mesh, Text, Vertex, approximate,
    approximate_tensor, dxf, glb, iges, obj, ply, step, stl, svg, three_mf, write_file,
};
use torse_geometry::curve::ellipse_arc;
use torse_geometry::pattern::unroll;
use torse_geometry::{
    Bernstein, Continuity, Curve, EnvelopingPatch, Gbt, PatchBounds, PlaneFamily, RuledSurface,
    Surface, TensorSurface, join,
};

type Outcome<T> = Result<T, Box<dyn Error>>;

/// Millimetres within which edges are one, and within which surfaces are approximated.
const SEWING: f64 = 1e-6;
const TOLERANCE: f64 = 1e-4;

fn main() -> Outcome<()> {
    let folder = std::env::args()
        .nth(1)
        .ok_or("name a folder for the files")?;
    let folder = PathBuf::from(folder);
    std::fs::create_dir_all(&folder)?;
    let lists = [
        ("models", models(&folder)?),
        ("meshes", meshes(&folder)?),
        ("drawings", vec![drawing(&folder)?]),
        ("patterns", vec![pattern(&folder)?]),
    ];
    let lists = lists.map(|(name, entries)| format!("\"{name}\": [\n{}\n]", entries.join(",\n")));
    let manifest = format!("{{\n{}\n}}\n", lists.join(",\n"));
    write_file(&folder.join("manifest.json"), manifest.as_bytes())?;
    Ok(())
}

fn models(folder: &Path) -> Outcome<Vec<String>> {
    // Two pieces of a developable of control planes, joined with the same rulings and points of regression.
    let planes = vec![
        [7.0, -7.0, 5.0, 125.0],
        [-7.0, -7.0, 5.0, 120.0],
        [-7.0, 7.0, 5.0, 130.0],
        [7.0, 7.0, 5.0, 125.0],
    ];
    let first = PlaneFamily::new(Gbt::new(0.5, 0.25)?, planes)?;
    let joint = Continuity::parametric(2, &0.0);
    let more = [[7.0, -7.0, 5.0, 125.0]];
    let second = join::next_family(&first, Gbt::new(0.0, 1.0)?, &joint, &more)?;
    let cuts = || PatchBounds::Planes([[0.0, 0.0, 1.0, 0.0], [0.0, 0.0, 1.0, 3.0]]);
    let pieces = [
        EnvelopingPatch::new(first, cuts())?,
        EnvelopingPatch::new(second, cuts())?,
    ];
    let near = |piece| approximate(piece, TOLERANCE);
    let chain = [near(&pieces[0])?, near(&pieces[1])?];

    // The tangent surface of the twisted cubic: rational, hence exact.
    let osculating = vec![
        [0.0, 0.0, 1.0, 0.0],
        [0.0, -1.0, 1.0, 0.0],
        [1.0, -2.0, 1.0, 0.0],
        [3.0, -3.0, 1.0, 1.0],
    ];
    let family = PlaneFamily::new(Bernstein, osculating)?;
    let cut = PatchBounds::Planes([[1.0, 0.0, 0.0, 2.0], [1.0, 0.0, 0.1, 5.0]]);
    let cubic = EnvelopingPatch::new(family, cut)?;

    let cone = cone()?;
    let net = (0..4)
        .map(|i| (0..3).map(|j| vase(i, j)).collect())
        .collect();
    let vase = TensorSurface::new(Gbt::new(0.5, 0.25)?, Gbt::new(-1.0, 0.0)?, net)?;
    let ring = |n: usize| -> Outcome<_> { Ok(RuledSurface::new(arc(n, 0.0)?, arc(n, 4.0)?)) };
    let tube = [ring(0)?, ring(1)?, ring(2)?, ring(3)?];
    let quarters = tube.iter().map(|quarter| approximate(quarter, TOLERANCE));
    let quarters: Vec<Converted> = quarters.collect::<Result<_, _>>()?;
    let (exact_cubic, exact_cone) = (cubic.exact_form()?, cone.exact_form()?);
    let near_vase = approximate_tensor(&vase, TOLERANCE)?;
    Ok(vec![
        model(folder, "chain", &pieces, chain.to_vec())?,
        model(folder, "cubic", &[cubic], vec![exact_cubic])?,
        model(folder, "cone", &[cone], vec![exact_cone])?,
        model(folder, "vase", &[vase], vec![near_vase])?,
        model(folder, "tube", &tube, quarters)?,
    ])
}

fn vase(i: i32, j: i32) -> [f64; 3] {
    let (x, y) = (f64::from(i), f64::from(j));
    [10.0 * x, 15.0 * y, 4.0 * x * y - x * x]
}

fn cone() -> Outcome<RuledSurface<Curve<Bernstein, f64, 3>, Curve<Bernstein, f64, 3>>> {
    let apex = Curve::new(Bernstein, vec![[0.0, 0.0, 20.0]; 3])?;
    let base = vec![[10.0, 0.0, 0.0], [10.0, 10.0, 0.0], [0.0, 10.0, 0.0]];
    Ok(RuledSurface::new(apex, Curve::new(Bernstein, base)?))
}

/// A quarter of a circle of radius 5.
fn arc(n: usize, z: f64) -> Outcome<Curve<Gbt<f64>, f64, 3>> {
    let corner = |n: usize| match n % 4 {
        0 => [5.0, 0.0, z],
        1 => [0.0, 5.0, z],
        2 => [-5.0, 0.0, z],
        _ => [0.0, -5.0, z],
    };
    Ok(ellipse_arc(&[0.0, 0.0, z], &corner(n), &corner(n + 1))?)
}

fn model(
    folder: &Path,
    name: &str,
    surfaces: &[impl Surface<f64>],
    converted: Vec<Converted>,
) -> Outcome<String> {
    let mut model = CadModel::new(name, SEWING)?;
    let mut faces = 0;
    for (part, converted) in converted.into_iter().enumerate() {
        faces += converted.patches.len();
        model.add(&format!("{name} {part}"), converted)?;
    }
    let (step_name, iges_name) = (format!("{name}.step"), format!("{name}.igs"));
    write_file(&folder.join(&step_name), step(&model)?.as_bytes())?;
    write_file(&folder.join(&iges_name), iges(&model)?.as_bytes())?;
    let (mut area, mut points) = (0.0, Vec::new());
    for surface in surfaces {
        area += Mesh::sample(surface, 400, 100)?.area();
        for (i, j) in (0..=12).flat_map(|i| (0..=3).map(move |j| (i, j))) {
            let [x, y, z] = surface.point(&(f64::from(i) / 12.0), &(f64::from(j) / 3.0))?;
            points.push(format!("[{x:?}, {y:?}, {z:?}]"));
        }
    }
    Ok(format!(
        "{{\"step\": \"{step_name}\", \"iges\": \"{iges_name}\", \"faces\": {faces}, \"area\": {area:?}, \
         \"area_within\": {:?}, \"error\": {:?}, \"sewing\": {SEWING:?}, \"points\": [{}]}}",
        // The area of a mesh is less by what its chords cut off.
        2e-5 * area,
        model.error(),
        points.join(", ")
    ))
}

fn meshes(folder: &Path) -> Outcome<Vec<String>> {
    let mut tube = Mesh::default();
    for n in 0..4 {
        let quarter = RuledSurface::new(arc(n, 0.0)?, arc(n, 4.0)?);
        tube.append(&Mesh::ruled(&quarter, 1e-3)?)?;
    }
    let solid = tube.welded(1e-9)?.thickened(0.5)?;
    let cone = Mesh::sample(&cone()?, 24, 6)?;
    Ok(vec![
        mesh(folder, "tube", &solid)?,
        mesh(folder, "cone", &cone)?,
    ])
}

fn mesh(folder: &Path, name: &str, mesh: &Mesh) -> Outcome<String> {
    let files: [(&str, Vec<u8>); 5] = [
        ("stl", stl(mesh)?),
        ("obj", obj(mesh)?.into_bytes()),
        ("ply", ply(mesh)?),
        ("3mf", three_mf(mesh)?),
        ("glb", glb(mesh)?),
    ];
    let mut names = Vec::new();
    for (ending, bytes) in files {
        let file = format!("{name}.{ending}");
        write_file(&folder.join(&file), &bytes)?;
        names.push(format!("\"{file}\""));
    }
    Ok(format!(
        "{{\"files\": [{}], \"triangles\": {}, \"area\": {:?}, \"volume\": {:?}, \"watertight\": {}}}",
        names.join(", "),
        mesh.triangles().len(),
        mesh.area(),
        mesh.volume(),
        mesh.is_watertight()
    ))
}

/// The quarter of a frustum unrolls to a sector of an annulus, whose length and area are known.
fn pattern(folder: &Path) -> Outcome<String> {
    let ring = |r: f64, z: f64| ellipse_arc(&[0.0, 0.0, z], &[r, 0.0, z], &[0.0, r, z]);
    let flat = unroll(
        &RuledSurface::new(ring(30.0, 0.0)?, ring(10.0, 40.0)?),
        16,
        1e-3,
    )?;
    let drawing = Drawing::of_pattern(&flat, 0.0)?;
    write_file(&folder.join("cone.dxf"), dxf(&drawing)?.as_bytes())?;
    write_file(&folder.join("cone.svg"), svg(&drawing)?.as_bytes())?;
    let quarter = std::f64::consts::FRAC_PI_2;
    let slant = libm::hypot(20.0_f64, 40.0);
    Ok(format!(
        "{{\"dxf\": \"cone.dxf\", \"svg\": \"cone.svg\", \"area\": {:?}, \"outline\": {:?}, \
         \"radii\": [{:?}, {:?}], \"error\": {:?}, \"rulings\": {}}}",
        0.5 * quarter * (30.0 + 10.0) * slant,
        quarter * (30.0 + 10.0) + 2.0 * slant,
        0.5 * slant,
        1.5 * slant,
        flat.errors().outline,
        flat.rulings().len()
    ))
}

/// A plate with round corners, a hole, bends and lettering.
fn drawing(folder: &Path) -> Outcome<String> {
    let (width, height, corner, hole) = (80.0, 50.0, 10.0, 6.0);
    let quarter = libm::tan(std::f64::consts::PI / 8.0);
    let vertex = |x: f64, y: f64, bulge: f64| Vertex {
        point: [x, y],
        bulge,
    };
    let outline = [
        vertex(corner, 0.0, 0.0),
        vertex(width - corner, 0.0, quarter),
        vertex(width, corner, 0.0),
        vertex(width, height - corner, quarter),
        vertex(width - corner, height, 0.0),
        vertex(corner, height, quarter),
        vertex(0.0, height - corner, 0.0),
        vertex(0.0, corner, quarter),
    ];
    let mut drawing = Drawing::default();
    drawing.path(Layer::Outline, &outline, true)?;
    drawing.circle(Layer::Outline, [60.0, 25.0], hole)?;
    drawing.line(Layer::Rulings, [20.0, 0.0], [20.0, height])?;
    drawing.bend([30.0, 0.0], [30.0, height], 0.5)?;
    drawing.bend([40.0, 0.0], [40.0, height], -0.25)?;
    drawing.polyline(
        Layer::Regression,
        &[[90.0, 0.0], [95.0, 25.0], [90.0, 50.0]],
    )?;
    drawing.text(Text {
        layer: Layer::Marks,
        at: [5.0, 20.0],
        height: 4.0,
        angle: std::f64::consts::FRAC_PI_2,
        content: "Blech <Nr. 1> & größer".to_owned(),
    })?;
    drawing.note("written by an example")?;
    write_file(&folder.join("plate.dxf"), dxf(&drawing)?.as_bytes())?;
    write_file(&folder.join("plate.svg"), svg(&drawing)?.as_bytes())?;
    let pi = std::f64::consts::PI;
    let straight = 2.0 * (width + height - 4.0 * corner);
    Ok(format!(
        "{{\"dxf\": \"plate.dxf\", \"svg\": \"plate.svg\", \"area\": {:?}, \"outline\": {:?}, \"hole\": {:?}, \
         \"size\": [{:?}, {:?}], \"bends\": [0.5, -0.25]}}",
        width * height - (4.0 - pi) * corner * corner,
        straight + 2.0 * pi * corner,
        2.0 * pi * hole,
        95.0,
        50.0
    ))
}
