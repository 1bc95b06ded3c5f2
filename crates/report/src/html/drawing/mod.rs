//! Drawings of the crate `plot` as parts of a page.
//!
//! Separate files repeat outlines of letters, styles of lines and the paper. Here all figures share their letters,
//! lines of one style are one path, coordinates are rounded to the screen, and the style sheet of the page colours
//! paper, ink and walls, so that drawings follow its theme. A drawing of any other form is refused, and stays a
//! picture.

mod path;
mod pixels;

use base64::Engine as _;
use base64::engine::general_purpose::STANDARD;
use path::{rounded, tenths};
use pixels::Pixels;
use rayon::prelude::*;
use std::collections::BTreeMap;
use std::fmt::Write;

/// Maximum number of bytes of all pixels of a page; if the finest do not fit, coarser colours are used.
const MAX_BYTES: usize = 420_000;

/// A drawing that can stand in a page.
pub(super) struct Drawing {
    size: [String; 2],
    elements: Vec<Element>,
}

enum Element {
    /// Paths of one style, by their attributes.
    Path { style: String, data: String },
    /// Letters: attributes of the group, size of a thousandth of an em, and the outline and place of each.
    Type {
        style: String,
        scale: String,
        letters: Vec<(String, [i64; 2])>,
    },
    /// A turned letter: attributes of its group, its outline, its transformation.
    Turned {
        style: String,
        outline: String,
        transform: String,
    },
    /// Pixels with the place of their left upper corner, in halves of a unit.
    Image { place: [u32; 2], pixels: Pixels },
}

/// The shared outlines of letters of a page, each with its number.
#[derive(Default)]
pub(super) struct Shelf {
    outlines: BTreeMap<String, usize>,
}

/// The pixel files of several drawings, in one fineness.
pub(super) struct Files(Vec<Vec<Vec<u8>>>);

impl Files {
    /// Returns the finest files that fit a page.
    pub fn fitting(drawings: &[Option<Drawing>]) -> Self {
        let of = |(share, step): (u32, u8)| {
            let each = drawings.par_iter().map(|drawing| {
                let pixels = drawing.iter().flat_map(Drawing::pixels);
                let file =
                    |pixels: &Pixels| pixels.quartered(share).indexed(step).unwrap_or_default();
                pixels.map(file).collect::<Vec<_>>()
            });
            Files(each.collect())
        };
        let fine = [(4, 4), (3, 6), (2, 8)].into_iter().map(of);
        let fits =
            |files: &Files| files.0.iter().flatten().map(Vec::len).sum::<usize>() <= MAX_BYTES;
        fine.into_iter().find(fits).unwrap_or_else(|| of((2, 14)))
    }

    /// Returns the files of the drawing with this number.
    pub fn pieces(&self, drawing: usize) -> &[Vec<u8>] {
        self.0.get(drawing).map_or(&[], Vec::as_slice)
    }
}

impl Drawing {
    /// Reads a drawing from a file of the crate `plot`.
    pub fn read(svg: &str) -> Option<Self> {
        let mut outlines = BTreeMap::new();
        let mut drawing = Drawing {
            size: Default::default(),
            elements: vec![],
        };
        let (mut inside, mut ended) = (false, false);
        for line in svg.lines() {
            match line {
                _ if ended => return None,
                _ if line.starts_with("<svg ") => {
                    let [w, h] = [attribute(line, "width")?, attribute(line, "height")?];
                    drawing.size = [plain(w)?, plain(h)?];
                }
                _ if line.starts_with("<title>") || line.starts_with("<rect ") => {}
                "<defs>" => inside = true,
                "</defs>" => inside = false,
                "</svg>" => ended = true,
                _ if inside => {
                    let outline = plain(attribute(line, "d")?)?;
                    outlines.insert(attribute(line, "id")?, outline);
                }
                _ if line.starts_with("<path ") => drawing.path(line)?,
                _ if line.starts_with("<g ") => drawing.letters(line, &outlines)?,
                _ if line.starts_with("<image ") => drawing.image(line)?,
                _ => return None,
            }
        }
        ended.then_some(drawing)
    }

    fn path(&mut self, line: &str) -> Option<()> {
        let data = rounded(attribute(line, "d")?)?;
        let style = style(
            line,
            &[
                "fill",
                "fill-opacity",
                "stroke",
                "stroke-width",
                "stroke-dasharray",
                "stroke-opacity",
            ],
        )?;
        // The order of opaque strokes of one colour is not visible.
        let joins = style.starts_with(" fill=\"none\"") && !style.contains("opacity");
        if let Some(Element::Path {
            style: before,
            data: longer,
        }) = self.elements.last_mut()
            && joins
            && *before == style
        {
            longer.push_str(&data);
        } else {
            self.elements.push(Element::Path { style, data });
        }
        Some(())
    }

    fn letters(&mut self, line: &str, outlines: &BTreeMap<&str, String>) -> Option<()> {
        let style = style(
            line.split_once('>')?.0,
            &[
                "fill",
                "stroke",
                "stroke-width",
                "stroke-linejoin",
                "paint-order",
            ],
        )?;
        for letter in line.split("<use ").skip(1) {
            let letter = format!("<use {letter}");
            let outline = outlines
                .get(attribute(&letter, "href")?.strip_prefix('#')?)?
                .clone();
            let transform = plain(attribute(&letter, "transform")?)?;
            let matrix = transform.strip_prefix("matrix(")?.strip_suffix(')')?;
            let parts: Vec<&str> = matrix.split(' ').collect();
            let &[a, b, c, d, x, y] = parts.as_slice() else {
                return None;
            };
            if (b, c) != ("0", "0") || a != d {
                self.elements.push(Element::Turned {
                    style: style.clone(),
                    outline,
                    transform,
                });
                continue;
            }
            let unit: f64 = a.parse().ok().filter(|unit| *unit > 0.0)?;
            let in_units = |text: &str| Some((text.parse::<f64>().ok()? / unit).round() as i64);
            let place = [in_units(x)?, in_units(y)?];
            match self.elements.last_mut() {
                Some(Element::Type {
                    style: before,
                    scale,
                    letters,
                }) if *before == style && *scale == a => {
                    letters.push((outline, place));
                }
                _ => self.elements.push(Element::Type {
                    style: style.clone(),
                    scale: a.to_owned(),
                    letters: vec![(outline, place)],
                }),
            }
        }
        Some(())
    }

    fn image(&mut self, line: &str) -> Option<()> {
        let file = attribute(line, "href")?.strip_prefix("data:image/png;base64,")?;
        let corner = |name| attribute(line, name)?.parse::<u32>().ok()?.checked_mul(2);
        let [x, y] = [corner("x")?, corner("y")?];
        if let Some(([left, top], pixels)) = Pixels::read(&STANDARD.decode(file).ok()?)?.cropped() {
            let place = [x.checked_add(left)?, y.checked_add(top)?];
            self.elements.push(Element::Image { place, pixels });
        }
        Some(())
    }

    fn pixels(&self) -> impl Iterator<Item = &Pixels> {
        self.elements.iter().filter_map(|element| match element {
            Element::Image { pixels, .. } => Some(pixels),
            _ => None,
        })
    }

    /// Writes the drawing as an element of a page that has the outlines; `label` is already escaped.
    pub fn written(&self, shelf: &mut Shelf, files: &[Vec<u8>], label: &str) -> String {
        let [width, height] = &self.size;
        let mut out = format!(
            "<svg class=\"drawing\" width=\"{width}\" height=\"{height}\" viewBox=\"0 0 {width} {height}\" role=\"img\" aria-label=\"{label}\">"
        );
        let mut files = files.iter();
        for element in &self.elements {
            // Writing to a string cannot fail.
            let _ = match element {
                Element::Path { style, data } => write!(out, "<path{style} d=\"{data}\"/>"),
                Element::Type {
                    style,
                    scale,
                    letters,
                } => {
                    let _ = write!(out, "<g{style} transform=\"scale({scale})\">");
                    for (outline, [x, y]) in letters {
                        let number = shelf.number(outline);
                        let _ = write!(out, "<use href=\"#g{number}\" x=\"{x}\" y=\"{y}\"/>");
                    }
                    write!(out, "</g>")
                }
                Element::Turned {
                    style,
                    outline,
                    transform,
                } => {
                    let number = shelf.number(outline);
                    write!(
                        out,
                        "<g{style}><use href=\"#g{number}\" transform=\"{transform}\"/></g>"
                    )
                }
                Element::Image { place, pixels } => {
                    let [x, y] = place.map(|c| tenths(i64::from(c) * 5));
                    let [w, h] = pixels.size().map(|c| tenths(i64::from(c) * 5));
                    let file = files
                        .next()
                        .map(|file| STANDARD.encode(file))
                        .unwrap_or_default();
                    write!(
                        out,
                        "<image x=\"{x}\" y=\"{y}\" width=\"{w}\" height=\"{h}\" preserveAspectRatio=\"none\" href=\"data:image/png;base64,{file}\"/>"
                    )
                }
            };
        }
        out.push_str("</svg>");
        out
    }
}

impl Shelf {
    fn number(&mut self, outline: &str) -> usize {
        let next = self.outlines.len();
        *self.outlines.entry(outline.to_owned()).or_insert(next)
    }

    /// Writes the outlines as an invisible element.
    pub fn written(&self) -> String {
        let mut order: Vec<(&String, &usize)> = self.outlines.iter().collect();
        order.sort_by_key(|(_, number)| **number);
        let mut out = "<svg width=\"0\" height=\"0\" aria-hidden=\"true\"><defs>".to_owned();
        for (outline, number) in order {
            let _ = write!(out, "<path id=\"g{number}\" d=\"{outline}\"/>");
        }
        out.push_str("</defs></svg>\n");
        out
    }
}

/// Returns the value of an attribute of the first tag of a line.
fn attribute<'a>(line: &'a str, name: &str) -> Option<&'a str> {
    let (_, rest) = line.split_once(&format!(" {name}=\""))?;
    Some(rest.split_once('"')?.0)
}

/// Returns the attributes that a tag has, as text; none if one contains anything but colours, numbers or lists of them.
fn style(tag: &str, names: &[&str]) -> Option<String> {
    let mut style = String::new();
    for name in names {
        if let Some(value) = attribute(tag, name) {
            let _ = write!(style, " {name}=\"{}\"", plain(value)?);
        }
    }
    Some(style)
}

/// Returns a value, if it contains no sign with a meaning in a page.
fn plain(value: &str) -> Option<String> {
    let harmless = |c: char| c.is_ascii_alphanumeric() || " #.,()-".contains(c);
    value.chars().all(harmless).then(|| value.to_owned())
}

#[cfg(test)]
mod tests {
    use super::*;

    const FILE: &str = "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"90\" height=\"60\" viewBox=\"0 0 90 60\" role=\"img\">\n\
        <title>a &lt; b</title>\n<rect width=\"90\" height=\"60\" fill=\"#fff\"/>\n<defs>\n\
        <path id=\"g0\" d=\"m1 2l3 4z\"/>\n</defs>\n\
        <path fill=\"none\" stroke=\"#1c1c1e\" stroke-width=\"0.8\" stroke-linejoin=\"round\" d=\"m1 1l2.04 0\"/>\n\
        <path fill=\"none\" stroke=\"#1c1c1e\" stroke-width=\"0.8\" stroke-linejoin=\"round\" d=\"m5 5l0 -3\"/>\n\
        <g fill=\"#1c1c1e\"><use href=\"#g0\" transform=\"matrix(0.01 0 0 0.01 10 20)\"/></g>\n\
        <g fill=\"#1c1c1e\"><use href=\"#g0\" transform=\"matrix(0.01 0 0 0.01 12.5 20)\"/></g>\n\
        <g fill=\"#1c1c1e\"><use href=\"#g0\" transform=\"matrix(0 -0.01 0.01 0 5 6)\"/></g>\n</svg>\n";

    #[test]
    fn lines_of_one_style_are_one_path_and_letters_stand_on_the_shelf() {
        let mut shelf = Shelf::default();
        let drawing = Drawing::read(FILE).unwrap();
        let found = drawing.written(&mut shelf, &[], "a &lt; b");
        assert_eq!(
            found,
            "<svg class=\"drawing\" width=\"90\" height=\"60\" viewBox=\"0 0 90 60\" role=\"img\" aria-label=\"a &lt; b\">\
             <path fill=\"none\" stroke=\"#1c1c1e\" stroke-width=\"0.8\" d=\"M1 1l2 0M5 5l0-3\"/>\
             <g fill=\"#1c1c1e\" transform=\"scale(0.01)\"><use href=\"#g0\" x=\"1000\" y=\"2000\"/><use href=\"#g0\" x=\"1250\" y=\"2000\"/></g>\
             <g fill=\"#1c1c1e\"><use href=\"#g0\" transform=\"matrix(0 -0.01 0.01 0 5 6)\"/></g></svg>"
        );
        assert!(
            shelf
                .written()
                .contains("<path id=\"g0\" d=\"m1 2l3 4z\"/>")
        );
    }

    #[test]
    fn a_drawing_that_is_written_otherwise_is_refused() {
        assert!(Drawing::read("<svg xmlns=\"x\"><circle r=\"1\"/></svg>").is_none());
        for (old, new) in [
            ("</svg>\n", ""),
            ("</svg>\n", "</svg>\n<script>alert(1)</script>\n"),
            ("stroke=\"#1c1c1e\"", "stroke=\"url(&quot;x&quot;)\""),
            ("<defs>", "<script>alert(1)</script>"),
            ("d=\"m1 2l3 4z\"", "d=\"&quot;\""),
            ("matrix(0.01 0 0 0.01 10 20)", "scale(2)"),
        ] {
            assert!(
                Drawing::read(&FILE.replacen(old, new, 1)).is_none(),
                "{new}"
            );
        }
    }
}
