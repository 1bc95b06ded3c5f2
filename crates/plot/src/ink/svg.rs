//! The SVG writer.
//!
//! Type becomes outlines, each glyph once in `<defs>` and then `<use>`d: the file looks the same in a browser, in
//! a PDF and on a machine without fonts. Images are embedded as PNG.

use std::collections::BTreeMap;
use std::fmt::Write;

use tiny_skia::{Path, PathSegment};

use crate::colour::Colour;
use crate::error::FigureError;
use crate::ink::font::{Fonts, Style};
use crate::ink::scene::{Glyph, Item, Scene, Turn};

/// The scene as one SVG document named `title`.
pub(crate) fn write(scene: &Scene, title: &str) -> Result<String, FigureError> {
    let mut out = String::new();
    let (w, h) = (scene.width, scene.height);
    append(
        &mut out,
        format_args!(
            "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{w}\" height=\"{h}\" viewBox=\"0 0 {w} {h}\" role=\"img\">\n\
             <title>{}</title>\n<rect width=\"{w}\" height=\"{h}\" fill=\"#fff\"/>\n",
            escape(title)
        ),
    );
    let names = glyph_names(scene);
    out.push_str("<defs>\n");
    for ((style, id), name) in &names {
        if let Some(path) = Fonts::get()?.outline(*style, *id) {
            append(
                &mut out,
                format_args!("<path id=\"{name}\" d=\"{}\"/>\n", data(&path, 1.0)),
            );
        }
    }
    out.push_str("</defs>\n");
    for item in &scene.items {
        write_item(&mut out, item, &names)?;
    }
    out.push_str("</svg>\n");
    Ok(out)
}

/// A short name for every glyph with an outline, dealt out in order of first use.
fn glyph_names(scene: &Scene) -> BTreeMap<(Style, u16), String> {
    let mut names = BTreeMap::new();
    for item in &scene.items {
        let Item::Type { glyphs, .. } = item else {
            continue;
        };
        for glyph in glyphs {
            let next = format!("g{}", names.len());
            names.entry((glyph.style, glyph.id)).or_insert(next);
        }
    }
    names
}

fn write_item(
    out: &mut String,
    item: &Item,
    names: &BTreeMap<(Style, u16), String>,
) -> Result<(), FigureError> {
    match item {
        Item::Fill {
            path,
            colour,
            alpha,
        } => {
            let opacity = attribute("fill-opacity", *alpha);
            append(
                out,
                format_args!(
                    "<path fill=\"{}\"{opacity} d=\"{}\"/>\n",
                    hex(*colour),
                    data(path, 100.0)
                ),
            );
        }
        Item::Stroke { path, line, alpha } => {
            let opacity = attribute("stroke-opacity", *alpha);
            let pattern = line.dash.pattern();
            let dashes: Vec<String> = pattern
                .iter()
                .map(|d| num(f64::from(*d) * line.width, 100.0))
                .collect();
            let dashes = if dashes.is_empty() {
                String::new()
            } else {
                format!(" stroke-dasharray=\"{}\"", dashes.join(" "))
            };
            append(
                out,
                format_args!(
                    "<path fill=\"none\" stroke=\"{}\" stroke-width=\"{}\"{dashes}{opacity} stroke-linejoin=\"round\" d=\"{}\"/>\n",
                    hex(line.colour),
                    num(line.width, 100.0),
                    data(path, 100.0)
                ),
            );
        }
        Item::Type {
            glyphs,
            colour,
            rim,
        } => {
            let em = glyphs.iter().map(|g| g.size).fold(1.0, f64::max);
            let rim = if *rim > 0.0 {
                let width = num(rim * 1000.0 / em, 1.0);
                format!(
                    " stroke=\"#fff\" stroke-width=\"{width}\" stroke-linejoin=\"round\" paint-order=\"stroke\""
                )
            } else {
                String::new()
            };
            append(out, format_args!("<g fill=\"{}\"{rim}>", hex(*colour)));
            for glyph in glyphs {
                if let Some(name) = names.get(&(glyph.style, glyph.id)) {
                    append(
                        out,
                        format_args!("<use href=\"#{name}\" transform=\"{}\"/>", transform(glyph)),
                    );
                }
            }
            out.push_str("</g>\n");
        }
        Item::Image { x, y, pixels, png } => {
            append(
                out,
                format_args!(
                    "<image x=\"{x}\" y=\"{y}\" width=\"{}\" height=\"{}\" href=\"data:image/png;base64,{}\"/>\n",
                    num(f64::from(pixels.width) / 2.0, 100.0),
                    num(f64::from(pixels.height) / 2.0, 100.0),
                    base64(png)
                ),
            );
        }
    }
    Ok(())
}

/// Writing to a `String` cannot fail.
fn append(out: &mut String, text: std::fmt::Arguments) {
    let _ = out.write_fmt(text);
}

fn attribute(name: &str, alpha: f64) -> String {
    if alpha < 1.0 {
        format!(" {name}=\"{}\"", num(alpha, 1000.0))
    } else {
        String::new()
    }
}

fn transform(glyph: &Glyph) -> String {
    let size = glyph.size / 1000.0;
    let s = num(size, 1e5);
    let (x, y) = (num(glyph.x, 100.0), num(glyph.y, 100.0));
    match glyph.turn {
        Turn::Across => format!("matrix({s} 0 0 {s} {x} {y})"),
        Turn::Upwards => format!("matrix(0 -{s} {s} 0 {x} {y})"),
        Turn::Along(way) => {
            let [cosine, sine] = way.map(|c| num(size * c, 1e5));
            let up = num(-size * way[1], 1e5);
            format!("matrix({cosine} {sine} {up} {cosine} {x} {y})")
        }
    }
}

/// A number rounded to multiples of `1 / grid`, without needless zeros.
fn num(x: f64, grid: f64) -> String {
    let rounded = (x * grid).round() / grid;
    format!("{}", if rounded == 0.0 { 0.0 } else { rounded })
}

/// Path data on a grid of `1 / grid` pixels, relative coordinates on that grid so that no error adds up.
fn data(path: &Path, grid: f64) -> String {
    let mut out = String::new();
    let (mut pen, mut start) = ((0i64, 0i64), (0i64, 0i64));
    let snap = |x: f32, y: f32| {
        (
            (f64::from(x) * grid).round() as i64,
            (f64::from(y) * grid).round() as i64,
        )
    };
    let show = |v: i64| num(v as f64 / grid, grid);
    let mut last = ' ';
    for segment in path.segments() {
        let (letter, points): (char, Vec<tiny_skia::Point>) = match segment {
            PathSegment::MoveTo(a) => ('m', vec![a]),
            PathSegment::LineTo(a) => ('l', vec![a]),
            PathSegment::QuadTo(a, b) => ('q', vec![a, b]),
            PathSegment::CubicTo(a, b, c) => ('c', vec![a, b, c]),
            PathSegment::Close => ('z', vec![]),
        };
        out.push(if letter == last { ' ' } else { letter });
        last = letter;
        let mut to = if letter == 'z' { start } else { pen };
        for (k, p) in points.iter().enumerate() {
            to = snap(p.x, p.y);
            let separator = if k == 0 { "" } else { " " };
            append(
                &mut out,
                format_args!("{separator}{} {}", show(to.0 - pen.0), show(to.1 - pen.1)),
            );
        }
        pen = to;
        if letter == 'm' {
            start = to;
            // A second pair after `m` would mean `l`.
            last = ' ';
        }
    }
    out
}

fn hex(c: Colour) -> String {
    format!("#{:02x}{:02x}{:02x}", c.r, c.g, c.b)
}

fn escape(text: &str) -> String {
    text.replace('&', "&amp;")
        .replace('<', "&lt;")
        .replace('>', "&gt;")
}

/// Base64 of RFC 4648 with padding.
fn base64(bytes: &[u8]) -> String {
    const DIGITS: &[u8; 64] = b"ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    let mut out = String::with_capacity(bytes.len().div_ceil(3) * 4);
    for chunk in bytes.chunks(3) {
        let group = (0..3).fold(0u32, |acc, k| {
            acc << 8 | u32::from(chunk.get(k).copied().unwrap_or(0))
        });
        for k in 0..4 {
            let digit = DIGITS[(group >> (18 - 6 * k) & 63) as usize];
            out.push(if k <= chunk.len() {
                char::from(digit)
            } else {
                '='
            });
        }
    }
    out
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::ink::scene::{Align, polyline};

    #[test]
    fn base64_agrees_with_the_examples_of_rfc_4648() {
        for (plain, coded) in [
            ("", ""),
            ("f", "Zg=="),
            ("fo", "Zm8="),
            ("foo", "Zm9v"),
            ("foobar", "Zm9vYmFy"),
        ] {
            assert_eq!(base64(plain.as_bytes()), coded);
        }
    }

    #[test]
    fn relative_path_data_returns_to_the_absolute_points() {
        let path = polyline(&[[1.0, 2.0], [3.5, 2.0], [3.504, 1.0]]).unwrap();
        assert_eq!(data(&path, 100.0), "m1 2l2.5 0 0 -1");
    }

    #[test]
    fn a_contour_after_a_closed_one_starts_from_where_that_began() {
        let mut two = tiny_skia::PathBuilder::new();
        for x in [1.0, 5.0] {
            two.move_to(x, 1.0);
            two.line_to(x + 2.0, 1.0);
            two.line_to(x, 3.0);
            two.close();
        }
        assert_eq!(
            data(&two.finish().unwrap(), 1.0),
            "m1 1l2 0 -2 2zm4 0l2 0 -2 2z"
        );
    }

    #[test]
    fn a_repeated_letter_is_outlined_once() {
        let mut scene = Scene::new(100, 50);
        scene
            .text("aaa", 12.0, [10.0, 10.0], Align::Left, Turn::Across)
            .unwrap();
        let svg = write(&scene, "a < b").unwrap();
        assert_eq!(
            (svg.matches("<path id").count(), svg.matches("<use").count()),
            (1, 3)
        );
        assert!(svg.contains("<title>a &lt; b</title>"));
    }
}
