//! The elements of an SVG file that are drawn, each with its place, its layers and its way to the sheet.

use super::style::Styles;
use crate::read::error::{FilePlace, ReadError, ReadResult, at, at_line};
use crate::read::imported::PassedOver;
use crate::read::unit::LengthUnit;
use roxmltree::{Document, Node, ParsingOptions};
use std::collections::HashMap;
use std::str::FromStr;
use svgtypes::{Length, LengthUnit as Unit, TransformListParser, TransformListToken, ViewBox};
use torse_algebra::Rational;
use torse_geometry::Coordinate;

/// The most elements of a file, those that `use` repeats counted each time.
const MAX_ELEMENTS: usize = 1_000_000;
/// How deep elements are nested, and `use` goes.
const MAX_DEPTH: usize = 128;

/// The longest text that an entity stands for.
const MAX_ENTITY: usize = 128;

/// The most references in a file that has entities of its own.
const MAX_REFERENCES: usize = 500_000;

const INKSCAPE: &str = "http://www.inkscape.org/namespaces/inkscape";
const XLINK: &str = "http://www.w3.org/1999/xlink";

/// The map `[x, y] -> [a x + c y + e, b x + d y + f]`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Matrix(pub [f64; 6]);

impl Matrix {
    pub(crate) const IDENTITY: Self = Self([1.0, 0.0, 0.0, 1.0, 0.0, 0.0]);

    /// This map after another one.
    fn after(self, first: Self) -> Self {
        let ([a, b, c, d, e, f], [p, q, r, s, t, u]) = (self.0, first.0);
        Self([
            a * p + c * q,
            b * p + d * q,
            a * r + c * s,
            b * r + d * s,
            a * t + c * u + e,
            b * t + d * u + f,
        ])
    }

    pub(crate) fn point(self, [x, y]: [f64; 2]) -> [f64; 2] {
        let [a, b, c, d, e, f] = self.0;
        [a * x + c * y + e, b * x + d * y + f]
    }

    pub(crate) fn vector(self, [x, y]: [f64; 2]) -> [f64; 2] {
        let [a, b, c, d, ..] = self.0;
        [a * x + c * y, b * x + d * y]
    }
}

/// An element that is drawn.
pub(crate) struct Element<'d> {
    pub node: Node<'d, 'd>,
    pub place: FilePlace,
    /// The name of the element, without prefix.
    pub tag: &'d str,
    /// The names of the groups about it, the outermost first.
    pub layers: Vec<&'d str>,
    /// From its coordinates to the sheet: millimetres, y up.
    pub matrix: Matrix,
    /// Width and height of the innermost box about it, of which percentages are.
    pub viewport: Option<[f64; 2]>,
}

impl<'d> Element<'d> {
    /// A name: the label that an author gave, the id, that of its innermost group, that of the element.
    pub(crate) fn name(&self) -> &'d str {
        let own = self
            .node
            .attribute((INKSCAPE, "label"))
            .or(self.node.attribute("id"));
        own.or(self.layers.last().copied()).unwrap_or(self.tag)
    }

    /// An attribute that is a length in the coordinates of the element.
    pub(crate) fn length(&self, name: &str) -> ReadResult<Option<f64>> {
        let Some(text) = self.node.attribute(name) else {
            return Ok(None);
        };
        length_within(text, name, self.viewport)
            .map(Some)
            .ok_or_else(|| {
                at(
                    &self.place,
                    format!("`{name}` is no length: `{}`", short(text)),
                )
            })
    }
}

/// A number with its unit; quarters of a millimetre, `Q`, are a unit too.
fn parsed_length(text: &str) -> Option<Length> {
    let text = text.trim();
    if let Some(number) = text.strip_suffix(['Q', 'q']) {
        let number = number.trim().parse::<f64>().ok()?;
        return Some(Length::new(0.25 * number, Unit::Mm));
    }
    Length::from_str(text).ok()
}

/// A length in user units; absolute units are pixels of a 96th of an inch, as SVG has it inside of a drawing.
fn length_of(text: &str) -> Option<f64> {
    let length = parsed_length(text)?;
    let factor = match length.unit {
        Unit::None | Unit::Px => 1.0,
        Unit::In => 96.0,
        Unit::Cm => 96.0 / 2.54,
        Unit::Mm => 96.0 / 25.4,
        Unit::Pt => 96.0 / 72.0,
        Unit::Pc => 16.0,
        Unit::Em | Unit::Ex | Unit::Percent => return None,
    };
    let value = length.number * factor;
    value.is_finite().then_some(value)
}

/// A length in user units, or a percentage of a box of this width and height.
fn length_within(text: &str, name: &str, viewport: Option<[f64; 2]>) -> Option<f64> {
    let Some(length) = parsed_length(text).filter(|length| length.unit == Unit::Percent) else {
        return length_of(text);
    };
    let [w, h] = viewport?;
    let whole = match name {
        "x" | "x1" | "x2" | "cx" | "rx" | "width" => w,
        "y" | "y1" | "y2" | "cy" | "ry" | "height" => h,
        // Of a radius: of the diagonal, over the root of two.
        _ => ((w * w + h * h) / 2.0).sqrt(),
    };
    let value = 0.01 * length.number * whole;
    value.is_finite().then_some(value)
}

/// The width and height of the box of an element, of which percentages inside are.
fn viewport(node: Node<'_, '_>, place: &FilePlace) -> ReadResult<Option<[f64; 2]>> {
    Ok(view_box(node, place)?.map(|[_, _, w, h]| [w, h]))
}

fn short(text: &str) -> String {
    text.chars().take(40).collect()
}

/// The tree of an SVG file. A document type may stand in it, with entities of plain text: nothing can grow without bound.
pub(crate) fn parse(text: &str) -> ReadResult<Document<'_>> {
    for (start, _) in text.match_indices("<!ENTITY") {
        let declaration = text.get(start..).unwrap_or_default();
        let value = declaration.split(['"', '\'']).nth(1).unwrap_or("&");
        if value.len() > MAX_ENTITY || value.contains(['&', '%', '<']) {
            let line = text.get(..start).unwrap_or_default().matches('\n').count() + 1;
            return Err(at_line(
                line,
                format!(
                    "an entity that is more than a plain text of {MAX_ENTITY} characters is not read"
                ),
            ));
        }
    }
    if text.contains("<!ENTITY") && text.matches('&').count() > MAX_REFERENCES {
        return Err(ReadError::TooMuch {
            place: FilePlace::default(),
            what: "references to entities",
            most: MAX_REFERENCES,
        });
    }
    let options = ParsingOptions {
        allow_dtd: true,
        nodes_limit: u32::try_from(MAX_ELEMENTS).unwrap_or(u32::MAX),
        ..ParsingOptions::default()
    };
    Document::parse_with_options(text, options).map_err(|error| {
        let line = usize::try_from(error.pos().row).unwrap_or(1);
        at_line(line, format!("no XML: {error}"))
    })
}

/// What is drawn.
pub(crate) struct Drawn<'d> {
    pub elements: Vec<Element<'d>>,
    /// The description of the drawing.
    pub notes: String,
    pub passed: PassedOver,
}

/// The unit that the outermost element states: by a width or height in an absolute unit.
pub(crate) fn stated_unit(root: Node<'_, '_>) -> ReadResult<Option<LengthUnit>> {
    let mut stated = None;
    for name in ["width", "height"] {
        let Some(length) = root.attribute(name).and_then(parsed_length) else {
            continue;
        };
        let unit = match length.unit {
            Unit::None | Unit::Percent | Unit::Em | Unit::Ex => continue,
            Unit::Px => "px",
            Unit::In => "in",
            Unit::Cm => "cm",
            Unit::Mm => "mm",
            Unit::Pt => "pt",
            Unit::Pc => "pc",
        };
        stated = stated.or(LengthUnit::named(unit));
    }
    Ok(stated)
}

/// The map from user units of the outermost element to millimetres with y up.
fn outermost(root: Node<'_, '_>, place: &FilePlace, unit: &Rational) -> ReadResult<Matrix> {
    let size = |name: &str| -> ReadResult<Option<f64>> {
        let Some(text) = root.attribute(name) else {
            return Ok(None);
        };
        let wrong = || at(place, format!("`{name}` is no length: `{}`", short(text)));
        let length = parsed_length(text).ok_or_else(wrong)?;
        let millimetres = match length.unit {
            Unit::Percent | Unit::Em | Unit::Ex => return Ok(None),
            Unit::None => unit.approximate(),
            Unit::Px => 25.4 / 96.0,
            Unit::In => 25.4,
            Unit::Cm => 10.0,
            Unit::Mm => 1.0,
            Unit::Pt => 25.4 / 72.0,
            Unit::Pc => 25.4 / 6.0,
        };
        let value = length.number * millimetres;
        if !(value > 0.0 && value.is_finite()) {
            return Err(wrong());
        }
        Ok(Some(value))
    };
    let sizes = [size("width")?, size("height")?];
    let scale = match view_box(root, place)? {
        None => {
            // Without a box a unit is a pixel, whatever the size is given in; without a unit it is what holds instead.
            let pixel = match stated_unit(root)? {
                Some(_) => 25.4 / 96.0,
                None => unit.approximate(),
            };
            [pixel; 2]
        }
        Some([_, _, w, h]) => match sizes {
            [Some(width), Some(height)] => {
                let both = [width / w, height / h];
                let ratio = root.attribute("preserveAspectRatio").unwrap_or_default();
                let says = |word: &str| ratio.split_whitespace().any(|part| part == word);
                if says("none") {
                    both
                } else if says("slice") {
                    [both[0].max(both[1]); 2]
                } else {
                    // `meet`, which holds where nothing is said: all of the box is seen.
                    [both[0].min(both[1]); 2]
                }
            }
            [Some(width), None] => [width / w; 2],
            [None, Some(height)] => [height / h; 2],
            [None, None] => [unit.approximate(); 2],
        },
    };
    Ok(Matrix([scale[0], 0.0, 0.0, -scale[1], 0.0, 0.0]))
}

fn view_box(node: Node<'_, '_>, place: &FilePlace) -> ReadResult<Option<[f64; 4]>> {
    let Some(text) = node.attribute("viewBox") else {
        return Ok(None);
    };
    let wrong = || at(place, format!("`viewBox` is no box: `{}`", short(text)));
    let view = ViewBox::from_str(text.trim()).map_err(|_| wrong())?;
    let all = [view.x, view.y, view.w, view.h];
    if all.iter().any(|c| !c.is_finite()) || view.w <= 0.0 || view.h <= 0.0 {
        return Err(wrong());
    }
    Ok(Some(all))
}

/// Collects what is drawn; `unit` are the millimetres of a file that states no unit.
pub(crate) fn drawn<'d>(document: &'d Document<'d>, unit: &Rational) -> ReadResult<Drawn<'d>> {
    let root = document.root_element();
    let place = place_of(document, root);
    if root.tag_name().name() != "svg" {
        return Err(at(&place, "the outermost element is no `svg`"));
    }
    let mut walk = Walk {
        document,
        ids: HashMap::new(),
        styles: Styles::new(document)?,
        visible: true,
        viewport: viewport(root, &place)?,
        seen: 0,
        found: Drawn {
            elements: Vec::new(),
            notes: String::new(),
            passed: PassedOver::default(),
        },
    };
    for node in root.descendants() {
        if let Some(id) = node.attribute("id") {
            walk.ids.entry(id).or_insert(node);
        }
    }
    let matrix = outermost(root, &place, unit)?;
    for child in root.children() {
        if child.tag_name().name() == "desc" {
            walk.found.notes.push_str(child.text().unwrap_or_default());
        }
    }
    walk.children(root, &mut Vec::new(), matrix, 0)?;
    Ok(walk.found)
}

fn place_of(document: &Document<'_>, node: Node<'_, '_>) -> FilePlace {
    let line = document.text_pos_at(node.range().start).row;
    let name = node.tag_name().name();
    let entity = match node.attribute("id") {
        Some(id) => format!("{name} `{}`", short(id)),
        None => name.to_owned(),
    };
    FilePlace::entity(usize::try_from(line).unwrap_or(1), entity)
}

struct Walk<'d> {
    document: &'d Document<'d>,
    ids: HashMap<&'d str, Node<'d, 'd>>,
    styles: Styles<'d>,
    /// Whether what comes next is seen: `visibility` is handed down.
    visible: bool,
    /// Width and height of the innermost box.
    viewport: Option<[f64; 2]>,
    seen: usize,
    found: Drawn<'d>,
}

impl<'d> Walk<'d> {
    fn children(
        &mut self,
        parent: Node<'d, 'd>,
        layers: &mut Vec<&'d str>,
        matrix: Matrix,
        depth: usize,
    ) -> ReadResult<()> {
        for node in parent.children().filter(Node::is_element) {
            self.element(node, layers, matrix, depth)?;
        }
        Ok(())
    }

    fn element(
        &mut self,
        node: Node<'d, 'd>,
        layers: &mut Vec<&'d str>,
        matrix: Matrix,
        depth: usize,
    ) -> ReadResult<()> {
        self.seen += 1;
        if self.seen > MAX_ELEMENTS || depth > MAX_DEPTH {
            return Err(ReadError::TooMuch {
                place: place_of(self.document, node),
                what: if depth > MAX_DEPTH {
                    "elements inside each other"
                } else {
                    "elements"
                },
                most: if depth > MAX_DEPTH {
                    MAX_DEPTH
                } else {
                    MAX_ELEMENTS
                },
            });
        }
        let tag = node.tag_name().name();
        if self.styles.property(node, "display") == Some("none") {
            self.found.passed.add(&format!("hidden {tag}"));
            return Ok(());
        }
        let outside = self.visible;
        match self.styles.property(node, "visibility") {
            Some("visible") => self.visible = true,
            Some("hidden" | "collapse") => self.visible = false,
            _ => {}
        }
        let matrix = matrix.after(self.transform(node)?);
        let result = self.shown(node, tag, layers, matrix, depth);
        self.visible = outside;
        result
    }

    /// The map of an element's own transform.
    fn transform(&self, node: Node<'d, 'd>) -> ReadResult<Matrix> {
        let Some(text) = self.styles.property(node, "transform") else {
            return Ok(Matrix::IDENTITY);
        };
        let place = place_of(self.document, node);
        for name in ["transform-origin", "transform-box"] {
            if let Some(value) = self.styles.property(node, name) {
                return Err(at(
                    &place,
                    format!("`{name}: {}` is not read", short(value)),
                ));
            }
        }
        if text.trim() == "none" {
            return Ok(Matrix::IDENTITY);
        }
        // Styles write units, which an attribute has not.
        let plain = text.replace("px", "").replace("deg", "");
        let map = transform(&plain);
        map.ok_or_else(|| at(&place, format!("`transform` is none: `{}`", short(text))))
    }

    /// What is in an element with a box of its own.
    fn boxed(
        &mut self,
        node: Node<'d, 'd>,
        layers: &mut Vec<&'d str>,
        matrix: Matrix,
        depth: usize,
    ) -> ReadResult<()> {
        let own = viewport(node, &place_of(self.document, node))?;
        let outside = std::mem::replace(&mut self.viewport, own);
        let result = self.children(node, layers, matrix, depth + 1);
        self.viewport = outside;
        result
    }

    /// An element that is not taken out of the drawing, with its own transform in the matrix.
    fn shown(
        &mut self,
        node: Node<'d, 'd>,
        tag: &'d str,
        layers: &mut Vec<&'d str>,
        matrix: Matrix,
        depth: usize,
    ) -> ReadResult<()> {
        let place = || place_of(self.document, node);
        match tag {
            "g" | "a" | "switch" => {
                let name = node.attribute((INKSCAPE, "label")).or(node.attribute("id"));
                layers.extend(name);
                let result = self.children(node, layers, matrix, depth + 1);
                if name.is_some() {
                    layers.pop();
                }
                result
            }
            "svg" => {
                let place = place();
                let inner = inner(node, node, &place, self.viewport)?;
                self.boxed(node, layers, matrix.after(inner), depth)
            }
            "use" => {
                let place = place();
                let link = node
                    .attribute("href")
                    .or(node.attribute((XLINK, "href")))
                    .unwrap_or_default();
                let target = link
                    .strip_prefix('#')
                    .and_then(|id| self.ids.get(id))
                    .copied();
                let Some(target) = target else {
                    return Err(at(&place, format!("there is no element `{}`", short(link))));
                };
                if target.tag_name().name() == "symbol" {
                    let inner = inner(target, node, &place, self.viewport)?;
                    // The corner is in it.
                    return self.boxed(target, layers, matrix.after(inner), depth);
                }
                let [x, y] = moved_by(node, &place, self.viewport)?;
                let moved = matrix.after(Matrix([1.0, 0.0, 0.0, 1.0, x, y]));
                self.element(target, layers, moved, depth + 1)
            }
            "path" | "line" | "polyline" | "polygon" | "rect" | "circle" | "ellipse" | "text" => {
                let numbers = matrix.0.iter().all(|c| c.is_finite());
                if !numbers {
                    return Err(at(&place(), "a transform that is not finite"));
                }
                if !self.visible {
                    self.found.passed.add(&format!("hidden {tag}"));
                    return Ok(());
                }
                self.found.elements.push(Element {
                    node,
                    place: place(),
                    tag,
                    layers: layers.clone(),
                    matrix,
                    viewport: self.viewport,
                });
                Ok(())
            }
            "defs" | "symbol" | "clipPath" | "mask" | "marker" | "pattern" | "metadata"
            | "title" | "desc" | "style" | "script" | "linearGradient" | "radialGradient"
            | "filter" | "namedview" => Ok(()),
            other => {
                self.found.passed.add_at(other, &place());
                Ok(())
            }
        }
    }
}

/// Where an element stands that has a place of its own: `x` and `y`, or zero.
fn moved_by(
    node: Node<'_, '_>,
    place: &FilePlace,
    outside: Option<[f64; 2]>,
) -> ReadResult<[f64; 2]> {
    let length = |name: &str| match node.attribute(name) {
        None => Ok(0.0),
        Some(text) => length_within(text, name, outside)
            .ok_or_else(|| at(place, format!("`{name}` is no length: `{}`", short(text)))),
    };
    Ok([length("x")?, length("y")?])
}

/// The map from the coordinates inside of an `svg` or a `symbol` to those about it: from its box to the place and size that
/// `placed`, itself or what uses it, gives it; by `preserveAspectRatio` one scale, in the middle, unless it says otherwise.
fn inner(
    node: Node<'_, '_>,
    placed: Node<'_, '_>,
    place: &FilePlace,
    outside: Option<[f64; 2]>,
) -> ReadResult<Matrix> {
    let [x, y] = moved_by(placed, place, outside)?;
    let Some([left, top, w, h]) = view_box(node, place)? else {
        return Ok(Matrix([1.0, 0.0, 0.0, 1.0, x, y]));
    };
    let size = |name: &str, usual: f64| -> ReadResult<f64> {
        let own = placed.attribute(name).or(node.attribute(name));
        let Some(text) = own.filter(|text| text.trim() != "auto") else {
            return Ok(usual);
        };
        let length = length_within(text, name, outside).filter(|length| *length > 0.0);
        length.ok_or_else(|| {
            at(
                place,
                format!("`{name}` is no length that is read: `{}`", short(text)),
            )
        })
    };
    let (width, height) = (size("width", w)?, size("height", h)?);
    let [across, down] = [width / w, height / h];
    let ratio = node.attribute("preserveAspectRatio").unwrap_or_default();
    if ratio.contains("none") {
        return Ok(Matrix([
            across,
            0.0,
            0.0,
            down,
            x - across * left,
            y - down * top,
        ]));
    }
    let scale = if ratio.contains("slice") {
        across.max(down)
    } else {
        across.min(down)
    };
    let share = |axis: char| {
        let says = |word: &str| ratio.contains(&format!("{axis}{word}"));
        if says("Min") {
            0.0
        } else if says("Max") {
            1.0
        } else {
            0.5
        }
    };
    let (right, lower) = (
        share('x') * (width - scale * w),
        share('Y') * (height - scale * h),
    );
    Ok(Matrix([
        scale,
        0.0,
        0.0,
        scale,
        x + right - scale * left,
        y + lower - scale * top,
    ]))
}

/// The map of a list of transforms, with angles in degrees; quarter turns are exact.
fn transform(text: &str) -> Option<Matrix> {
    let mut matrix = Matrix::IDENTITY;
    for (count, token) in TransformListParser::from(text).enumerate() {
        if count > 1000 {
            return None;
        }
        let tangent = |angle: f64| libm::tan(angle.to_radians());
        let next = match token.ok()? {
            TransformListToken::Matrix { a, b, c, d, e, f } => [a, b, c, d, e, f],
            TransformListToken::Translate { tx, ty } => [1.0, 0.0, 0.0, 1.0, tx, ty],
            TransformListToken::Scale { sx, sy } => [sx, 0.0, 0.0, sy, 0.0, 0.0],
            TransformListToken::Rotate { angle } => {
                let (sine, cosine) = turned(angle);
                [cosine, sine, -sine, cosine, 0.0, 0.0]
            }
            TransformListToken::SkewX { angle } => [1.0, 0.0, tangent(angle), 1.0, 0.0, 0.0],
            TransformListToken::SkewY { angle } => [1.0, tangent(angle), 0.0, 1.0, 0.0, 0.0],
        };
        matrix = matrix.after(Matrix(next));
    }
    Some(matrix)
}

/// Sine and cosine of an angle in degrees.
pub(crate) fn turned(degrees: f64) -> (f64, f64) {
    match degrees.rem_euclid(360.0) {
        0.0 => (0.0, 1.0),
        90.0 => (1.0, 0.0),
        180.0 => (0.0, -1.0),
        270.0 => (-1.0, 0.0),
        angle => (libm::sin(angle.to_radians()), libm::cos(angle.to_radians())),
    }
}
