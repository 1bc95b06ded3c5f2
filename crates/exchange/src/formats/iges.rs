//! IGES 5.3: ruled surfaces (entity 118) between B-spline curves (126), other patches as B-spline surfaces
//! (128).

use crate::cad::{BsplineCurve, BsplinePatch, CadModel, Face, Knots};
use crate::error::{ExchangeError, Result};
use std::fmt::Write;

/// The model as IGES in millimetres. A patch of degree one in `v` is a ruled surface, entity 118 in form 1 (rulings
/// join equal parameters), with the flag DEVFLG set when the patch is declared developable; a patch with an apex for a
/// rail, and any other, is a B-spline surface, entity 128; with openings it is trimmed, entity 144. IGES as written
/// here has no topology: neighbours touch, but share no edges.
///
/// # Errors
/// [`ExchangeError::Empty`] for a model without patches, [`ExchangeError::TooMany`] for more than ten million
/// lines.
pub fn iges(model: &CadModel) -> Result<String> {
    if model.faces().is_empty() {
        return Err(ExchangeError::Empty { what: "patches" });
    }
    let mut file = Sections::default();
    for face in model.faces() {
        let [first, _, second, _] = face.patch.sides();
        let second = second.reversed();
        let (label, patch) = (label(&face.name), &face.patch);
        let named = file.entity(
            406,
            15,
            DEPENDENT,
            "",
            &format!("406,1,{}", hollerith(&face.name)),
        );
        // No associativities, one property: the name.
        let tail = format!("0,1,{named}");
        if !face.openings.is_empty() {
            trimmed(&mut file, model, face, &label, &tail);
            continue;
        }
        let apex = |rail: &BsplineCurve| rail.is_point(model.sewing());
        if patch.degrees()[1] != 1 || apex(&first) || apex(&second) {
            file.entity(
                128,
                0,
                INDEPENDENT,
                &label,
                &format!("{},{tail}", surface(patch)),
            );
            continue;
        }
        let [first, second] =
            [first, second].map(|rail| file.entity(126, 0, DEPENDENT, &label, &curve(&rail)));
        let flag = u8::from(patch.is_declared_developable());
        file.entity(
            118,
            1,
            INDEPENDENT,
            &label,
            &format!("118,{first},{second},0,{flag},{tail}"),
        );
    }
    file.finish(model)
}

/// A B-spline surface within its own border and without its openings: entity 144, with an entity 142 for each opening that
/// has a curve in space alone.
fn trimmed(file: &mut Sections, model: &CadModel, face: &Face, label: &str, tail: &str) {
    let base = file.entity(128, 0, DEPENDENT, label, &surface(&face.patch));
    let list = |pointers: &[usize]| -> String {
        pointers
            .iter()
            .map(|pointer| format!(",{pointer}"))
            .collect()
    };
    let mut inner = Vec::with_capacity(face.openings.len());
    for opening in &face.openings {
        let mut parts = Vec::with_capacity(opening.len());
        for (index, forwards) in opening {
            let Some(edge) = model.edges().get(*index) else {
                continue;
            };
            let own = if *forwards {
                curve(&edge.curve)
            } else {
                curve(&edge.curve.reversed())
            };
            parts.push(file.entity(126, 0, DEPENDENT, label, &own));
        }
        let (count, parts) = (parts.len(), list(&parts));
        let around = file.entity(102, 0, DEPENDENT, label, &format!("102,{count}{parts}"));
        let on = format!("142,0,{base},0,{around},2");
        inner.push(file.entity(142, 0, DEPENDENT, label, &on));
    }
    let (count, inner) = (inner.len(), list(&inner));
    let data = format!("144,{base},0,{count},0{inner},{tail}");
    file.entity(144, 0, INDEPENDENT, label, &data);
}

/// Status of an entity of its own, and of one that is drawn only through another.
const INDEPENDENT: &str = "00000000";
const DEPENDENT: &str = "00010000";

#[derive(Default)]
struct Sections {
    directory: Vec<String>,
    parameters: Vec<String>,
}

impl Sections {
    /// Adds an entity; gives the number of its first line in the directory.
    fn entity(&mut self, kind: u16, form: u16, status: &str, label: &str, data: &str) -> usize {
        let pointer = self.directory.len() + 1;
        let start = self.parameters.len() + 1;
        for piece in wrapped(data) {
            self.parameters.push(format!("{piece:<64}{pointer:>8}"));
        }
        let count = self.parameters.len() + 1 - start;
        self.directory.push(format!(
            "{kind:>8}{start:>8}{0:>8}{0:>8}{0:>8}{0:>8}{0:>8}{0:>8}{status}",
            0
        ));
        self.directory.push(format!(
            "{kind:>8}{0:>8}{0:>8}{count:>8}{form:>8}{blank:>8}{blank:>8}{label:>8}{0:>8}",
            0,
            blank = ""
        ));
        pointer
    }

    fn finish(self, model: &CadModel) -> Result<String> {
        let largest = model.vertices().iter().flatten();
        let largest = largest.fold(0.0_f64, |m, x| m.max(x.abs()));
        let name = hollerith(model.name());
        let global = format!(
            "1H,,1H;,{name},8Htorse.ig,5Htorse,5Htorse,32,38,6,308,15,{name},1.,2,2HMM,1,0.01,\
             15H19700101.000000,{},{},5Htorse,5Htorse,11,0,15H19700101.000000;",
            real(model.sewing()),
            real(largest)
        );
        let note = format!(
            "torse: within {:e} mm of the designed surfaces",
            model.error()
        );
        let sections = [
            ('S', vec![format!("{note:<72}")]),
            ('G', wrapped_to(&global, 72)),
            ('D', self.directory),
            ('P', self.parameters),
        ];
        let mut text = String::new();
        let mut counts = String::new();
        for (letter, lines) in &sections {
            let most = 9_999_999;
            if lines.len() > most {
                return Err(ExchangeError::TooMany {
                    what: "lines",
                    given: lines.len(),
                    most,
                });
            }
            for (line, number) in lines.iter().zip(1..) {
                // Writing to a String cannot fail.
                let _ = writeln!(text, "{line:<72}{letter}{number:>7}");
            }
            let _ = write!(counts, "{letter}{:>7}", lines.len());
        }
        let _ = writeln!(text, "{counts:<72}T{:>7}", 1);
        Ok(text)
    }
}

fn curve(curve: &BsplineCurve) -> String {
    let plain = u8::from(curve.weights.is_none());
    let count = curve.points.len();
    let mut data = format!(
        "126,{},{},0,0,{plain},0",
        count.saturating_sub(1),
        curve.degree
    );
    let (from, to) = knots(&mut data, &curve.knots);
    match &curve.weights {
        Some(weights) => reals(&mut data, weights),
        None => reals(&mut data, &vec![1.0; count]),
    }
    reals(&mut data, curve.points.as_flattened());
    // The unit normal of a plane curve; the flag says that none is meant.
    reals(&mut data, &[from, to, 0.0, 0.0, 1.0]);
    data
}

fn surface(patch: &BsplinePatch) -> String {
    let ([m, n], net) = (patch.degrees(), patch.net());
    let (rows, columns) = (net.len(), net.first().map_or(0, Vec::len));
    let plain = u8::from(patch.weights().is_none());
    let mut data = format!(
        "128,{},{},{m},{n},0,0,{plain},0,0",
        rows.saturating_sub(1),
        columns.saturating_sub(1)
    );
    let [u, v] = patch.knots();
    let ends = [knots(&mut data, u), knots(&mut data, v)];
    // The first index runs fastest.
    for j in 0..columns {
        for i in 0..rows {
            let weight = patch.weights().and_then(|w| w.get(i)?.get(j).copied());
            reals(&mut data, &[weight.unwrap_or(1.0)]);
        }
    }
    for j in 0..columns {
        for row in net {
            reals(&mut data, &row.get(j).copied().unwrap_or_default());
        }
    }
    reals(&mut data, &ends.map(|(from, to)| [from, to]).concat());
    data
}

/// Appends the knots; gives the first and the last.
fn knots(data: &mut String, knots: &Knots) -> (f64, f64) {
    let all: Vec<f64> = knots.repeated().collect();
    reals(data, &all);
    let ends = all.first().copied().zip(all.last().copied());
    ends.unwrap_or((0.0, 1.0))
}

fn reals(data: &mut String, values: &[f64]) {
    for value in values {
        data.push(',');
        data.push_str(&real(*value));
    }
}

/// A double: always with a point, the exponent after a D.
fn real(value: f64) -> String {
    let text = format!("{:?}", value + 0.0);
    match text.split_once('e') {
        None => text,
        Some((digits, exponent)) if digits.contains('.') => format!("{digits}D{exponent}"),
        Some((digits, exponent)) => format!("{digits}.D{exponent}"),
    }
}

/// A string with its length in front. The format has ASCII only; separators would end the string for careless
/// readers, and lines are broken at them.
fn hollerith(text: &str) -> String {
    let text: String = text.chars().map(ascii).collect();
    let text = if text.is_empty() { "-" } else { &text };
    format!("{}H{text}", text.len())
}

/// The first eight characters of a name, for the directory.
fn label(name: &str) -> String {
    name.chars().take(8).map(ascii).collect()
}

fn ascii(c: char) -> char {
    match c {
        ',' | ';' => '_',
        ' '..='~' => c,
        _ => '?',
    }
}

fn wrapped(data: &str) -> Vec<String> {
    wrapped_to(&format!("{data};"), 64)
}

/// Lines of at most this width, broken after commas; only a string longer than a line goes on in the next.
fn wrapped_to(data: &str, width: usize) -> Vec<String> {
    let mut lines = Vec::new();
    let mut line = String::new();
    for item in data.split_inclusive(',') {
        if line.len() + item.len() > width && !line.is_empty() {
            lines.push(std::mem::take(&mut line));
        }
        line.push_str(item);
        while line.len() > width {
            let rest = line.split_off(width);
            lines.push(std::mem::replace(&mut line, rest));
        }
    }
    lines.push(line);
    lines
}
