//! Pictures as their users see them.

#![allow(clippy::unwrap_used, clippy::panic, reason = "helpers of tests")]

use std::io::Cursor;

use torse_plot::*;

fn decode(png: &[u8]) -> (u32, u32, Vec<u8>) {
    let mut reader = png::Decoder::new(Cursor::new(png)).read_info().unwrap();
    let mut samples = vec![0; reader.output_buffer_size().unwrap()];
    let info = reader.next_frame(&mut samples).unwrap();
    assert_eq!(info.color_type, png::ColorType::Rgb);
    (info.width, info.height, samples)
}

fn graph(legend: Legend) -> Plot {
    let sine = |k: f64| {
        (0..=100)
            .map(|i| f64::from(i) / 50.0 - 1.0)
            .map(|t| [t, libm::sin(k * t)])
            .collect()
    };
    Plot::new(Axis::auto("$t$"), Axis::auto("$\\sin kt$"))
        .curve(sine(1.0), Line::nth(0), "$k = 1$")
        .curve(sine(2.0), Line::nth(1), "$k = 2$")
        .control_polygon(vec![[-1.0, 0.0], [0.0, 1.0], [1.0, 0.0]], "polygon")
        .legend(legend)
}

fn saddle() -> Grid {
    Grid::sample(31, 31, |u, v| [2.0 * u, v, (u - 0.5) * (v - 0.5)]).unwrap()
}

fn view() -> View {
    View::new()
        .surface(Surface::new(saddle()).lines(5, 5).label("saddle"))
        .surface(Surface::new(Grid::sample(2, 2, |u, v| [2.0 * u, v, 0.1]).unwrap()).opacity(0.4))
        .curve(vec![[0.0; 3], [2.0, 1.0, 0.3]], Line::nth(1), "chord")
        .net(Grid::sample(3, 3, |u, v| [2.0 * u, v, 0.3]).unwrap(), "net")
        .arrow([0.0; 3], [0.0, 0.0, 0.4], Line::solid(Colour::INK, 1.5))
        .note([0.0; 3], "$\\mathbf{r}_{00}$", Place::Left)
}

#[test]
fn the_same_input_gives_the_same_bytes() {
    let draw = || {
        let panels = vec![
            Panel {
                content: Content::Plot(graph(Legend::Below)),
                caption: "graphs".into(),
            },
            Panel {
                content: Content::View(view()),
                caption: "view".into(),
            },
        ];
        let figure = Figure {
            title: "Both".into(),
            panels,
            columns: 2,
            panel_size: Size::PANEL,
        };
        figure.draw().unwrap()
    };
    let (a, b) = (draw(), draw());
    assert_eq!(a.svg, b.svg);
    assert_eq!(a.png().unwrap(), b.png().unwrap());
}

fn panels(contents: impl IntoIterator<Item = Content>) -> Vec<Panel> {
    let panel = |content| Panel {
        content,
        caption: String::new(),
    };
    contents.into_iter().map(panel).collect()
}

#[test]
fn a_legend_that_panels_share_stands_once_below_them() {
    let height = |contents: [Content; 2]| {
        let figure = Figure {
            title: "Two".into(),
            panels: panels(contents),
            columns: 2,
            panel_size: Size::PANEL,
        };
        figure.draw().unwrap().size().height
    };
    let plot = |legend| Content::Plot(graph(legend));
    let bare = height([plot(Legend::Hidden), plot(Legend::Hidden)]);
    let one_row = height([plot(Legend::Below), plot(Legend::Below)]) - bare;
    assert!((15..40).contains(&one_row), "{one_row} pixels");
    // One has a legend of its own, or stands elsewhere: then it is drawn within the panel.
    let own = Content::View(view().legend(Legend::Below));
    assert_eq!(height([plot(Legend::Below), own]), bare);
    assert_eq!(height([plot(Legend::Below), plot(Legend::Right)]), bare);
}

#[test]
fn compared_views_have_the_box_around_all_and_compared_plots_the_same_axes() {
    let surface = |size: f64| {
        let grid = Grid::sample(3, 3, |u, v| [size * u, v, size * u * v]).unwrap();
        Content::View(View::new().surface(Surface::new(grid)))
    };
    let fixed = [[0.0, 1.0]; 3];
    let own = Content::View(view().bounds(Bounds::Fixed(fixed)));
    let line = |top: f64, x: Axis| {
        Content::Plot(Plot::new(x, Axis::auto("y")).curve(
            vec![[0.0, 0.0], [1.0, top]],
            Line::nth(0),
            "",
        ))
    };
    let plots = [
        line(1.0, Axis::auto("x")),
        line(5.0, Axis::fixed("x", 0.0, 1.0)),
    ];
    let mut all = panels([surface(1.0), surface(4.0), own].into_iter().chain(plots));
    same_scales(&mut all).unwrap();
    let mut boxes = vec![];
    let mut ranges = vec![];
    for panel in &all {
        match &panel.content {
            Content::View(view) => boxes.push(view.bounds),
            Content::Plot(plot) => ranges.push((plot.x.range, plot.y.range)),
        }
    }
    assert_eq!(boxes[0], boxes[1]);
    let Bounds::Fixed([[low, high], ..]) = boxes[0] else {
        panic!("no box");
    };
    assert!(low < 0.0 && high > 4.0 && high < 4.5);
    assert_eq!(boxes[2], Bounds::Fixed(fixed), "bounds that are given stay");
    assert_eq!(ranges[0].1, ranges[1].1);
    assert!(ranges[0].1.unwrap()[1] > 5.0);
    assert_eq!(ranges[1].0, Some([0.0, 1.0]));
}

#[test]
fn a_png_has_twice_the_pixels_of_the_page_and_is_not_blank() {
    let size = Size {
        width: 200,
        height: 150,
    };
    for picture in [
        graph(Legend::Hidden).draw("g", size).unwrap(),
        view().legend(Legend::Hidden).draw("v", size).unwrap(),
    ] {
        let (w, h, samples) = decode(&picture.png().unwrap());
        assert_eq!((w, h), (400, 300));
        let inked = samples
            .chunks_exact(3)
            .filter(|p| p.iter().any(|c| *c < 128))
            .count();
        assert!(inked > 300, "{inked} dark pixels");
        assert!(samples.iter().filter(|c| **c == 255).count() > samples.len() / 4);
    }
}

#[test]
fn an_svg_is_well_formed_enough_and_carries_no_outside_reference() {
    let svg = view().draw("A <view> & more", Size::VIEW).unwrap().svg;
    assert!(svg.contains("<title>A &lt;view&gt; &amp; more</title>"));
    assert_eq!(svg.matches("data:image/png;base64,").count(), 1);
    assert_eq!(svg.matches("http").count(), 1, "the name space only");
    assert!(!svg.contains("<text") && !svg.contains("NaN") && !svg.contains("inf"));
    assert!(svg.trim_end().ends_with("</svg>"));
}

#[test]
fn default_sizes_stay_below_300_kib() {
    // The worst of views: filled by a coloured surface with many lines.
    let n = 121;
    let wave = Grid::sample(n, n, |u, v| {
        [u, v, 0.1 * libm::sin(9.0 * u) * libm::cos(7.0 * v)]
    })
    .unwrap();
    let values = (0..n * n)
        .map(|k| libm::sin((k / n) as f64 * 0.11) * libm::cos((k % n) as f64 * 0.09))
        .collect();
    let surface = Surface::new(wave)
        .paint(Paint::Values(values))
        .lines(24, 24);
    let full = View::new().surface(surface).stage(Stage::Bare);
    let pictures = [
        graph(Legend::Right).draw("graph", Size::COLUMN),
        view().draw("view", Size::VIEW),
        full.draw("full", Size::VIEW),
    ];
    for picture in pictures {
        let picture = picture.unwrap();
        let sizes = [picture.svg.len(), picture.png().unwrap().len()];
        assert!(sizes.iter().all(|s| *s < 300 * 1024), "{sizes:?}");
    }
}

#[test]
fn a_legend_leaves_the_frame_to_the_curves() {
    // Paint the plotting area by a region: the legend's room has none of its colour, and its ink none of its own inside.
    let fill = Colour::rgb(250, 200, 40);
    for legend in [Legend::Right, Legend::Below] {
        let region = Layer::Region {
            boundary: vec![[-9.0, -9.0], [9.0, -9.0], [9.0, 9.0], [-9.0, 9.0]],
            colour: fill,
            opacity: 1.0,
            label: String::new(),
        };
        let odd = Line::solid(Colour::rgb(200, 0, 200), 3.0);
        let plot = Plot::new(Axis::fixed("", 0.0, 1.0), Axis::fixed("", 0.0, 1.0))
            .layer(region)
            .curve(vec![[5.0, 5.0], [6.0, 6.0]], odd, "a label of some length")
            .legend(legend);
        let (w, _, samples) = decode(&plot.draw("p", Size::PANEL).unwrap().png().unwrap());
        let places = |test: &dyn Fn(&[u8]) -> bool| -> Vec<[usize; 2]> {
            let found = samples.chunks_exact(3).enumerate().filter(|(_, p)| test(p));
            found
                .map(|(k, _)| [k % w as usize, k / w as usize])
                .collect()
        };
        let area = places(&|p| p == [fill.r, fill.g, fill.b]);
        let sample = places(&|p| p == [200, 0, 200]);
        let axis = usize::from(legend == Legend::Below);
        let end = area.iter().map(|p| p[axis]).max().unwrap();
        let start = sample.iter().map(|p| p[axis]).min().unwrap();
        assert!(
            start > end + 4,
            "{legend:?}: area ends at {end}, legend starts at {start}"
        );
    }
}

#[test]
fn larger_values_stand_further_right_and_higher() {
    let colour = Colour::rgb(255, 0, 0);
    let place = |x: f64, y: f64| {
        let plot = Plot::new(Axis::fixed("", 0.0, 1.0), Axis::fixed("", 0.0, 1.0));
        let plot = plot.points(vec![[x, y]], Marker::Square, colour, "");
        let (w, _, samples) = decode(&plot.draw("", Size::PANEL).unwrap().png().unwrap());
        let k = samples
            .chunks_exact(3)
            .position(|p| p == [255, 0, 0])
            .unwrap();
        [k % w as usize, k / w as usize]
    };
    let ([a, b], [c, d]) = (place(0.2, 0.3), place(0.7, 0.8));
    assert!(a < c && b > d);
}

#[test]
fn numbers_that_are_not_finite_are_refused_with_their_place() {
    let size = Size::PANEL;
    let refused = |result: Result<Picture, FigureError>| match result {
        Err(FigureError::NonFinite { what, index, .. }) => (what, index),
        other => panic!("{:?}", other.map(|p| p.size())),
    };
    let plot = Plot::new(Axis::auto(""), Axis::auto(""));
    let curve = plot.curve(vec![[0.0, 0.0], [1.0, f64::NAN]], Line::nth(0), "");
    assert_eq!(refused(curve.draw("", size)), ("curve", 1));
    let curve = View::new().curve(
        vec![[0.0; 3], [1.0; 3], [f64::NEG_INFINITY, 0.0, 0.0]],
        Line::nth(0),
        "",
    );
    assert_eq!(refused(curve.draw("", size)), ("space curve", 2));
    let mut values = vec![0.0; 961];
    values[40] = f64::INFINITY;
    let mapped = View::new().surface(Surface::new(saddle()).paint(Paint::Values(values)));
    assert_eq!(refused(mapped.draw("", size)), ("values on a surface", 40));
    let mut surface = Surface::new(saddle());
    surface.normals = Some(vec![[f64::NAN; 3]; 961]);
    assert_eq!(
        refused(View::new().surface(surface).draw("", size)),
        ("normals of a surface", 0)
    );
}

#[test]
fn what_cannot_be_drawn_is_refused_and_says_why() {
    let size = Size::PANEL;
    let plot = || Plot::new(Axis::auto(""), Axis::auto(""));
    assert_eq!(plot().draw("", size).unwrap_err(), FigureError::Empty);
    assert_eq!(View::new().draw("", size).unwrap_err(), FigureError::Empty);
    let short = plot().curve(vec![[0.0; 2]], Line::nth(0), "");
    assert!(matches!(
        short.draw("", size),
        Err(FigureError::TooFew {
            what: "curve",
            needed: 2,
            got: 1
        })
    ));
    let empty = Plot::new(Axis::fixed("", 1.0, 1.0), Axis::auto(""));
    assert!(matches!(
        empty.draw("", size),
        Err(FigureError::EmptyRange { what: "x axis", .. })
    ));
    let values = View::new().surface(Surface::new(saddle()).paint(Paint::Values(vec![0.0])));
    assert!(matches!(
        values.draw("", size),
        Err(FigureError::Length {
            expected: 961,
            got: 1,
            ..
        })
    ));
    let large = graph(Legend::Right).draw(
        "",
        Size {
            width: 5000,
            height: 10,
        },
    );
    assert!(matches!(
        large,
        Err(FigureError::OutOfRange {
            what: "page width",
            ..
        })
    ));
    let label = graph(Legend::Right).note([0.0; 2], "$x", Place::Above);
    assert!(matches!(
        label.draw("", size),
        Err(FigureError::Label { at: 0, .. })
    ));
}

#[test]
fn extreme_but_finite_input_is_drawn() {
    let size = Size::PANEL;
    let flat = Plot::new(Axis::auto(""), Axis::auto("")).curve(
        vec![[1e-200, 5.0], [2e-200, 5.0]],
        Line::nth(0),
        "",
    );
    flat.draw("", size).unwrap();
    let point = View::new().points(vec![[3.0; 3]], Colour::INK, "");
    point.clone().draw("", size).unwrap();
    point.stage(Stage::Bare).draw("", size).unwrap();
    // A developable that runs far away, cut to a box.
    let far = Grid::sample(40, 12, |u, v| {
        [u, v / (1e-9 + (u - 0.5).abs()), (1e9 * v).powi(9)]
    })
    .unwrap();
    let bounds = Bounds::Fixed([[0.0, 1.0], [0.0, 2.0], [0.0, 1.0]]);
    View::new()
        .surface(Surface::new(far).lines(10, 0))
        .bounds(bounds)
        .draw("", size)
        .unwrap();
}

#[test]
fn bounds_cut_what_sticks_out() {
    // A plane far larger than the box fills the front of the box and nothing else.
    let plane = |half: f64| {
        Grid::sample(2, 2, |u, v| {
            [half * (2.0 * u - 1.0), half * (2.0 * v - 1.0), 0.0]
        })
        .unwrap()
    };
    let camera = Camera::Angles {
        azimuth: -90.0,
        elevation: 90.0,
    };
    let dark = |half: f64| {
        let surface = Surface::new(plane(half))
            .border(Border::Hidden)
            .paint(Paint::plain(Colour::INK));
        let bounds = Bounds::Fixed([[-1.0, 1.0]; 3]);
        let view = View::new()
            .surface(surface)
            .bounds(bounds)
            .camera(camera)
            .stage(Stage::Bare);
        let (_, _, samples) = decode(&view.draw("", Size::PANEL).unwrap().png().unwrap());
        samples.iter().filter(|c| **c < 128).count()
    };
    assert_eq!(dark(1.0), dark(1e6));
    assert!(dark(0.5) < dark(1.0));
}
