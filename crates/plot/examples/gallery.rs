//! Writes a few pictures into the folder given as argument:
//! `cargo run -p torse-plot --example gallery -- target/gallery`.

use std::error::Error;
use std::f64::consts::{PI, TAU};
use std::fs;
use std::path::PathBuf;

use torse_plot::*;

type Point = [f64; 3];

/// Generalized blended trigonometric basis of degree k: three trigonometric seeds of degree 2, then the
/// Bernstein recursion (gbt-surfaces, Sect. 2).
fn gbt(k: usize, mu: f64, nu: f64, z: f64) -> Vec<f64> {
    let (s, c) = libm::sincos(PI / 2.0 * z);
    let (first, last) = ((1.0 - s) * (1.0 - mu * s), (1.0 - c) * (1.0 - nu * c));
    let mut row = vec![first, 1.0 - first - last, last];
    for degree in 3..=k {
        let blend = |i: usize| {
            let kept = row.get(i).map_or(0.0, |f| (1.0 - z) * f);
            let raised = i
                .checked_sub(1)
                .and_then(|i| row.get(i))
                .map_or(0.0, |f| z * f);
            kept + raised
        };
        row = (0..=degree).map(blend).collect();
    }
    row
}

fn curve<const N: usize>(net: &[[f64; N]], mu: f64, nu: f64, z: f64) -> [f64; N] {
    let basis = gbt(net.len() - 1, mu, nu, z);
    std::array::from_fn(|d| basis.iter().zip(net).map(|(f, p)| f * p[d]).sum())
}

fn steps(n: usize) -> impl Iterator<Item = f64> + Clone {
    (0..=n).map(move |i| i as f64 / n as f64)
}

fn basis_plot(mu: f64, nu: f64, legend: Legend) -> Plot {
    let mut plot = Plot::new(
        Axis::fixed("$z$", 0.0, 1.0),
        Axis::fixed("$f_{i,4}(z)$", 0.0, 1.0),
    )
    .legend(legend);
    for i in 0..=4 {
        let points = steps(200).map(|z| [z, gbt(4, mu, nu, z)[i]]).collect();
        plot = plot.curve(points, Line::nth(i), &format!("$f_{{{i},4}}$"));
    }
    plot
}

fn curve_family() -> Plot {
    let net = [[0.0, 0.0], [0.6, 2.0], [2.6, 2.4], [4.0, 0.9], [3.4, -0.6]];
    let mut plot = Plot::new(Axis::auto("$x$ (mm)"), Axis::auto("$y$ (mm)")).aspect(Aspect::Equal);
    plot = plot.control_polygon(net.to_vec(), "control polygon");
    for (k, mu) in [-1.0, 0.0, 1.0].into_iter().enumerate() {
        let points = steps(200).map(|z| curve(&net, mu, mu, z)).collect();
        plot = plot.curve(points, Line::nth(k), &format!("$\\mu = \\nu = {mu}$"));
    }
    let places = [
        Place::BelowLeft,
        Place::AboveLeft,
        Place::AboveRight,
        Place::Right,
        Place::Below,
    ];
    for (i, (p, place)) in net.into_iter().zip(places).enumerate() {
        plot = plot.note(p, &format!("$\\mathbf{{P}}_{i}$"), place);
    }
    plot
}

/// Tangent surface of a helix: the rulings are the tangents, the helix is the edge of regression.
fn tangent_surface(turns: f64, reach: f64) -> Result<Grid, FigureError> {
    Grid::sample(241, 25, |u, v| {
        let (a, t) = (TAU * turns * u, 0.05 + reach * v);
        [
            libm::cos(a) - t * libm::sin(a),
            libm::sin(a) + t * libm::cos(a),
            0.35 * (a + t),
        ]
    })
}

fn helix(turns: f64) -> Vec<Point> {
    steps(300)
        .map(|u| libm::sincos(TAU * turns * u))
        .zip(steps(300))
        .map(|((s, c), u)| [c, s, 0.35 * TAU * turns * u])
        .collect()
}

/// A generalized cone over a GBT curve: developable, with its apex.
fn cone(net: &[Point; 5], apex: Point, mu: f64) -> Result<Grid, FigureError> {
    Grid::sample(97, 9, |u, v| {
        let p = curve(net, mu, mu, u);
        std::array::from_fn(|k| apex[k] + (0.25 + 0.75 * v) * (p[k] - apex[k]))
    })
}

const ARCH: [Point; 5] = [
    [0.0, -2.0, 0.0],
    [0.0, -1.6, 2.2],
    [0.3, 0.2, 2.6],
    [0.0, 1.4, 1.8],
    [0.0, 2.0, 0.0],
];

fn tensor_net() -> Vec<Vec<Point>> {
    let height = [
        [0.0, 0.9, 0.5, -0.2],
        [0.6, 2.1, 1.5, 0.4],
        [0.4, 1.7, 2.2, 0.3],
        [-0.3, 0.2, 0.9, -0.4],
    ];
    let row = |i: usize| (0..4).map(|j| [i as f64, j as f64, height[i][j]]).collect();
    (0..4).map(row).collect()
}

fn tensor(net: &[Vec<Point>], mu: f64, u: f64, v: f64) -> Point {
    let rows: Vec<Point> = net.iter().map(|row| curve(row, mu, mu, v)).collect();
    curve(&rows, mu, mu, u)
}

/// Gaussian curvature by central differences.
fn gauss(surface: impl Fn(f64, f64) -> Point, u: f64, v: f64) -> f64 {
    let h = 1e-3;
    let (u, v) = (u.clamp(h, 1.0 - h), v.clamp(h, 1.0 - h));
    let comb = |terms: &[(f64, f64, f64)]| -> Point {
        let mut sum = [0.0; 3];
        for &(w, a, b) in terms {
            let p = surface(u + a * h, v + b * h);
            sum = std::array::from_fn(|k| sum[k] + w * p[k]);
        }
        sum
    };
    let ru = comb(&[(0.5 / h, 1.0, 0.0), (-0.5 / h, -1.0, 0.0)]);
    let rv = comb(&[(0.5 / h, 0.0, 1.0), (-0.5 / h, 0.0, -1.0)]);
    let square = 1.0 / (h * h);
    let ruu = comb(&[
        (square, 1.0, 0.0),
        (-2.0 * square, 0.0, 0.0),
        (square, -1.0, 0.0),
    ]);
    let rvv = comb(&[
        (square, 0.0, 1.0),
        (-2.0 * square, 0.0, 0.0),
        (square, 0.0, -1.0),
    ]);
    let q = 0.25 * square;
    let ruv = comb(&[
        (q, 1.0, 1.0),
        (-q, 1.0, -1.0),
        (-q, -1.0, 1.0),
        (q, -1.0, -1.0),
    ]);
    let dot = |a: Point, b: Point| a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
    let n = [
        ru[1] * rv[2] - ru[2] * rv[1],
        ru[2] * rv[0] - ru[0] * rv[2],
        ru[0] * rv[1] - ru[1] * rv[0],
    ];
    (dot(ruu, n) * dot(rvv, n) - dot(ruv, n).powi(2)) / dot(n, n).powi(2)
}

fn developable() -> Result<View, FigureError> {
    let surface = Surface::new(tangent_surface(0.62, 2.2)?)
        .lines(24, 0)
        .label("tangent surface");
    let edge = Line::solid(palette(1), 2.4);
    Ok(View::new()
        .surface(surface)
        .curve(helix(0.62), edge, "edge of regression")
        .legend(Legend::Below))
}

fn composite() -> Result<View, FigureError> {
    let apex = [4.5, 0.3, 0.4];
    let first = cone(&ARCH, apex, 0.4)?;
    // The second patch is a cylinder over the same rim: G1 only where the rulings agree, so it shows a crease.
    let second = Grid::sample(97, 9, |u, v| {
        let p = curve(&ARCH, 0.4, 0.4, u);
        [p[0] - 3.0 * v, p[1], p[2]]
    })?;
    let rim: Vec<Point> = steps(200).map(|u| curve(&ARCH, 0.4, 0.4, u)).collect();
    Ok(View::new()
        .surface(
            Surface::new(first)
                .paint(Paint::nth(0))
                .lines(16, 0)
                .label("cone"),
        )
        .surface(
            Surface::new(second)
                .paint(Paint::nth(1))
                .lines(16, 0)
                .label("cylinder"),
        )
        .curve(rim, Line::solid(Colour::INK, 2.2), "common rim")
        .legend(Legend::Below))
}

fn curvature(mu: f64) -> Result<View, FigureError> {
    let net = tensor_net();
    let n = 90;
    let grid = Grid::sample(n + 1, n + 1, |u, v| tensor(&net, mu, u, v))?;
    let values = steps(n)
        .flat_map(|u| steps(n).map(move |v| (u, v)))
        .map(|(u, v)| gauss(|u, v| tensor(&net, mu, u, v), u, v));
    let scale = Scale {
        map: ColourMap::Diverging,
        range: Some([-1.0, 1.0]),
        label: "Gaussian curvature $K$".into(),
    };
    Ok(View::new()
        .surface(
            Surface::new(grid)
                .paint(Paint::Values(values.collect()))
                .lines(8, 8),
        )
        .scale(scale))
}

fn net_view() -> Result<View, FigureError> {
    let net = tensor_net();
    let grid = Grid::sample(61, 61, |u, v| tensor(&net, 0.5, u, v))?;
    let control = Grid::new(4, 4, net.concat())?;
    Ok(View::new()
        .surface(Surface::new(grid).lines(10, 10))
        .net(control, "control net")
        .legend(Legend::Below))
}

fn tangent_plane() -> Result<View, FigureError> {
    let grid = cone(&ARCH, [4.5, 0.3, 0.4], 0.4)?;
    let (u, h) = (0.36, 1e-4);
    let apex = [4.5, 0.3, 0.4];
    let p = curve(&ARCH, 0.4, 0.4, u);
    let q = curve(&ARCH, 0.4, 0.4, u + h);
    let (t, r): (Point, Point) = (
        std::array::from_fn(|k| (q[k] - p[k]) / h),
        std::array::from_fn(|k| apex[k] - p[k]),
    );
    let plane = Grid::sample(2, 2, |a, b| {
        std::array::from_fn(|k| p[k] + 0.62 * (a - 0.5) * t[k] + (0.9 * b - 0.1) * r[k])
    })?;
    let foot: Point = std::array::from_fn(|k| p[k] + 0.75 * r[k]);
    Ok(View::new()
        .surface(Surface::new(grid).lines(16, 0))
        .surface(
            Surface::new(plane)
                .paint(Paint::plain(palette(2)))
                .opacity(0.35)
                .label("tangent plane"),
        )
        .curve(vec![p, foot], Line::solid(palette(1), 2.2), "ruling")
        .points(vec![p], Colour::INK, "")
        .note(p, "$\\mathbf{r}(u_0)$", Place::AboveLeft)
        .legend(Legend::Below))
}

/// A vase: GBT profile turned about the z axis, seen with both sides.
fn vase() -> Result<View, FigureError> {
    let profile = [[0.9, 0.0], [2.0, 0.7], [0.2, 2.2], [0.7, 3.0], [1.25, 3.4]];
    let grid = Grid::sample(121, 61, |u, v| {
        let [r, z] = curve(&profile, 0.3, 0.3, v);
        [r * libm::cos(TAU * u), r * libm::sin(TAU * u), z]
    })?;
    Ok(View::new()
        .surface(Surface::new(grid).border(Border::Hidden).lines(24, 12))
        .stage(Stage::Bare))
}

fn panels() -> Result<Figure, FigureError> {
    let panel = |content, caption: &str| Panel {
        content,
        caption: caption.to_owned(),
    };
    Ok(Figure {
        title: "Basis functions and surfaces".into(),
        columns: 2,
        panel_size: Size::PANEL,
        panels: vec![
            panel(
                Content::Plot(basis_plot(0.0, 0.0, Legend::Below)),
                "$\\mu = \\nu = 0$",
            ),
            panel(
                Content::Plot(basis_plot(1.0, -1.0, Legend::Below)),
                "$\\mu = 1$, $\\nu = -1$",
            ),
            panel(Content::View(net_view()?), "patch with its control net"),
            panel(Content::View(vase()?), "surface of revolution"),
        ],
    })
}

fn main() -> Result<(), Box<dyn Error>> {
    let folder = PathBuf::from(std::env::args().nth(1).ok_or("usage: gallery FOLDER")?);
    fs::create_dir_all(&folder)?;
    let pictures = [
        (
            "basis",
            basis_plot(0.5, 0.5, Legend::Right)
                .draw("Basis functions of degree 4", Size::COLUMN)?,
        ),
        (
            "curves",
            curve_family().draw("Curves of one control polygon", Size::COLUMN)?,
        ),
        (
            "developable",
            developable()?.draw("Tangent surface of a helix", Size::VIEW)?,
        ),
        (
            "composite",
            composite()?.draw("A cone and a cylinder", Size::VIEW)?,
        ),
        (
            "curvature",
            curvature(0.5)?.draw("Gaussian curvature of a patch", Size::VIEW)?,
        ),
        (
            "tangent-plane",
            tangent_plane()?.draw("The tangent plane along a ruling", Size::VIEW)?,
        ),
        ("vase", vase()?.draw("A vase", Size::VIEW)?),
        ("panels", panels()?.draw()?),
    ];
    for (name, picture) in pictures {
        let png = picture.png()?;
        println!(
            "{name}: svg {} kB, png {} kB",
            picture.svg.len() / 1000,
            png.len() / 1000
        );
        fs::write(folder.join(format!("{name}.png")), png)?;
        fs::write(folder.join(format!("{name}.svg")), picture.svg)?;
    }
    Ok(())
}
