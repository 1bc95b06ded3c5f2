//! STEP (ISO 10303-21, application protocol 214): B-spline faces in an open shell.

use crate::cad::{BsplineCurve, BsplinePatch, CadModel, Knots};
use crate::error::{ExchangeError, Result};
use std::fmt::Write;

/// The model as STEP in millimetres: one open shell with a named face for each patch, common edges and
/// vertices shared. The distance from the original surfaces that is proved stands in the description.
///
/// # Errors
/// [`ExchangeError::Empty`] for a model without patches.
pub fn step(model: &CadModel) -> Result<String> {
    if model.faces().is_empty() {
        return Err(ExchangeError::Empty { what: "patches" });
    }
    let mut file = Entities::default();
    let shell = shell(&mut file, model);
    product(&mut file, model, shell);
    let name = quoted(model.name());
    let description = quoted(&format!(
        "B-splines within {:e} mm of the designed surfaces (proved)",
        model.error()
    ));
    Ok(format!(
        "ISO-10303-21;\nHEADER;\nFILE_DESCRIPTION(({description}),'2;1');\n\
         FILE_NAME({name},'1970-01-01T00:00:00',(''),(''),'torse','torse','');\n\
         FILE_SCHEMA(('AUTOMOTIVE_DESIGN {{ 1 0 10303 214 1 1 1 1 }}'));\nENDSEC;\nDATA;\n{}ENDSEC;\n\
         END-ISO-10303-21;\n",
        file.text
    ))
}

/// The entities of the data section, numbered from one.
#[derive(Default)]
struct Entities {
    text: String,
    count: usize,
}

impl Entities {
    fn add(&mut self, entity: String) -> usize {
        self.count += 1;
        // Writing to a String cannot fail.
        let _ = writeln!(self.text, "#{}={entity};", self.count);
        self.count
    }

    fn point(&mut self, point: &[f64; 3]) -> usize {
        self.add(format!("CARTESIAN_POINT('',{})", numbers(point)))
    }
}

fn shell(file: &mut Entities, model: &CadModel) -> usize {
    let vertices: Vec<usize> = model
        .vertices()
        .iter()
        .map(|p| {
            let point = file.point(p);
            file.add(format!("VERTEX_POINT('',#{point})"))
        })
        .collect();
    let vertex = |i: usize| vertices.get(i).copied().unwrap_or(0);
    let edges: Vec<usize> = model
        .edges()
        .iter()
        .map(|edge| {
            let curve = curve(file, &edge.curve);
            let [from, to] = edge.ends.map(vertex);
            file.add(format!("EDGE_CURVE('',#{from},#{to},#{curve},.T.)"))
        })
        .collect();
    let mut faces = Vec::with_capacity(model.faces().len());
    for face in model.faces() {
        let around = |file: &mut Entities, sides: &[(usize, bool)]| {
            let sides: Vec<usize> = sides
                .iter()
                .map(|&(index, forwards)| {
                    let (edge, sense) = (edges.get(index).copied().unwrap_or(0), logical(forwards));
                    file.add(format!("ORIENTED_EDGE('',*,*,#{edge},{sense})"))
                })
                .collect();
            file.add(format!("EDGE_LOOP('',{})", references(&sides)))
        };
        let boundary = around(file, &face.boundary);
        let mut bounds = vec![file.add(format!("FACE_OUTER_BOUND('',#{boundary},.T.)"))];
        for opening in &face.openings {
            let opening = around(file, opening);
            bounds.push(file.add(format!("FACE_BOUND('',#{opening},.T.)")));
        }
        let surface = surface(file, &face.patch);
        let (name, bounds) = (quoted(&face.name), references(&bounds));
        faces.push(file.add(format!("ADVANCED_FACE({name},{bounds},#{surface},.T.)")));
    }
    file.add(format!("OPEN_SHELL('',{})", references(&faces)))
}

/// Everything around the shell that a reader wants: units, uncertainty, product.
fn product(file: &mut Entities, model: &CadModel, shell: usize) {
    let name = quoted(model.name());
    let whole = file.add(format!("SHELL_BASED_SURFACE_MODEL({name},(#{shell}))"));
    let length = file.add("(LENGTH_UNIT()NAMED_UNIT(*)SI_UNIT(.MILLI.,.METRE.))".to_owned());
    let angle = file.add("(NAMED_UNIT(*)PLANE_ANGLE_UNIT()SI_UNIT($,.RADIAN.))".to_owned());
    let solid = file.add("(NAMED_UNIT(*)SI_UNIT($,.STERADIAN.)SOLID_ANGLE_UNIT())".to_owned());
    // Edges of neighbours may be this far apart; below 1e-7 readers have tolerances of their own.
    let sewing = number(model.sewing().max(1e-7));
    let accuracy = file.add(format!(
        "UNCERTAINTY_MEASURE_WITH_UNIT(LENGTH_MEASURE({sewing}),#{length},'distance_accuracy_value','')"
    ));
    let context = file.add(format!(
        "(GEOMETRIC_REPRESENTATION_CONTEXT(3)GLOBAL_UNCERTAINTY_ASSIGNED_CONTEXT((#{accuracy}))\
         GLOBAL_UNIT_ASSIGNED_CONTEXT((#{length},#{angle},#{solid}))REPRESENTATION_CONTEXT('',''))"
    ));
    let shape = file.add(format!(
        "MANIFOLD_SURFACE_SHAPE_REPRESENTATION({name},(#{whole}),#{context})"
    ));
    let application = file.add("APPLICATION_CONTEXT('automotive design')".to_owned());
    file.add(format!(
        "APPLICATION_PROTOCOL_DEFINITION('international standard','automotive_design',2010,#{application})"
    ));
    let market = file.add(format!("PRODUCT_CONTEXT('',#{application},'mechanical')"));
    let product = file.add(format!("PRODUCT({name},{name},'',(#{market}))"));
    let formation = file.add(format!("PRODUCT_DEFINITION_FORMATION('','',#{product})"));
    let stage = file.add(format!(
        "PRODUCT_DEFINITION_CONTEXT('part definition',#{application},'design')"
    ));
    let definition = file.add(format!(
        "PRODUCT_DEFINITION('design','',#{formation},#{stage})"
    ));
    let defined = file.add(format!("PRODUCT_DEFINITION_SHAPE('','',#{definition})"));
    file.add(format!(
        "SHAPE_DEFINITION_REPRESENTATION(#{defined},#{shape})"
    ));
}

fn curve(file: &mut Entities, curve: &BsplineCurve) -> usize {
    let points: Vec<usize> = curve.points.iter().map(|p| file.point(p)).collect();
    let (degree, points) = (curve.degree, references(&points));
    let knots = format!(
        "{},{},.UNSPECIFIED.",
        multiplicities(&curve.knots),
        numbers(curve.knots.values())
    );
    file.add(match &curve.weights {
        None => {
            format!("B_SPLINE_CURVE_WITH_KNOTS('',{degree},{points},.UNSPECIFIED.,.F.,.F.,{knots})")
        }
        Some(weights) => format!(
            "(BOUNDED_CURVE()B_SPLINE_CURVE({degree},{points},.UNSPECIFIED.,.F.,.F.)\
             B_SPLINE_CURVE_WITH_KNOTS({knots})CURVE()GEOMETRIC_REPRESENTATION_ITEM()\
             RATIONAL_B_SPLINE_CURVE({})REPRESENTATION_ITEM(''))",
            numbers(weights)
        ),
    })
}

fn surface(file: &mut Entities, patch: &BsplinePatch) -> usize {
    let mut rows = Vec::with_capacity(patch.net().len());
    for row in patch.net() {
        let points: Vec<usize> = row.iter().map(|p| file.point(p)).collect();
        rows.push(references(&points));
    }
    let ([m, n], net) = (patch.degrees(), list(rows.into_iter()));
    let [u, v] = patch.knots();
    let knots = format!(
        "{},{},{},{},.UNSPECIFIED.",
        multiplicities(u),
        multiplicities(v),
        numbers(u.values()),
        numbers(v.values())
    );
    file.add(match patch.weights() {
        None => format!(
            "B_SPLINE_SURFACE_WITH_KNOTS('',{m},{n},{net},.UNSPECIFIED.,.F.,.F.,.F.,{knots})"
        ),
        Some(weights) => format!(
            "(BOUNDED_SURFACE()B_SPLINE_SURFACE({m},{n},{net},.UNSPECIFIED.,.F.,.F.,.F.)\
             B_SPLINE_SURFACE_WITH_KNOTS({knots})GEOMETRIC_REPRESENTATION_ITEM()\
             RATIONAL_B_SPLINE_SURFACE({})REPRESENTATION_ITEM('')SURFACE())",
            list(weights.iter().map(|row| numbers(row)))
        ),
    })
}

fn list(items: impl Iterator<Item = String>) -> String {
    format!("({})", items.collect::<Vec<_>>().join(","))
}

fn references(ids: &[usize]) -> String {
    list(ids.iter().map(|id| format!("#{id}")))
}

fn multiplicities(knots: &Knots) -> String {
    list(knots.multiplicities().iter().map(ToString::to_string))
}

fn numbers(values: &[f64]) -> String {
    list(values.iter().map(|x| number(*x)))
}

/// A real number as STEP writes it: always with a point, exponents with a capital E.
fn number(value: f64) -> String {
    let text = format!("{:?}", value + 0.0);
    match text.split_once('e') {
        None => text,
        Some((digits, exponent)) if digits.contains('.') => format!("{digits}E{exponent}"),
        Some((digits, exponent)) => format!("{digits}.E{exponent}"),
    }
}

fn logical(value: bool) -> &'static str {
    if value { ".T." } else { ".F." }
}

/// A string: apostrophes and backslashes doubled, what is not ASCII as UTF-16 in hexadecimal.
fn quoted(text: &str) -> String {
    let mut quoted = String::from("'");
    for c in text.chars() {
        match c {
            '\'' => quoted.push_str("''"),
            '\\' => quoted.push_str("\\\\"),
            ' '..='~' => quoted.push(c),
            _ => {
                quoted.push_str("\\X2\\");
                for unit in c.encode_utf16(&mut [0; 2]) {
                    let _ = write!(quoted, "{unit:04X}");
                }
                quoted.push_str("\\X0\\");
            }
        }
    }
    quoted.push('\'');
    quoted
}
