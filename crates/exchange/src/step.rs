//! STEP (ISO 10303-21, AP214) for patches that are polynomial or rational Bezier surfaces.
//!
//! A GBT patch is not one (its basis is trigonometric), so only what *is* exactly representable can be
//! converted to a [`BezierPatch`]: Bernstein tensor products, ruled patches of Bernstein curves and
//! the exact oblique images of cones.

use std::fmt::Write;
use torse_geometry::basis::Bernstein;
use torse_geometry::curve::{Curve, RationalCurve};
use torse_geometry::surface::{RuledSurface, TensorSurface};
use torse_geometry::{GeometryError, Result};

/// A Bezier patch: control net and, for rational patches, the weights, both row by row.
#[derive(Debug, Clone, PartialEq)]
pub struct BezierPatch {
    points: Vec<Vec<[f64; 3]>>,
    weights: Option<Vec<Vec<f64>>>,
}

impl From<&TensorSurface<Bernstein, Bernstein, f64>> for BezierPatch {
    fn from(surface: &TensorSurface<Bernstein, Bernstein, f64>) -> Self {
        Self {
            points: surface.rows().map(<[_]>::to_vec).collect(),
            weights: None,
        }
    }
}

type Polynomial = Curve<Bernstein, f64, 3>;
type Rational = RationalCurve<Bernstein, f64, 3>;

impl BezierPatch {
    /// The ruled patch between a polynomial and a rational rail of the same degree, such as a Hermite
    /// cone cut by an oblique plane.
    ///
    /// The ruled patch `(1-v) P + v N/w` with polynomial `P` would need the numerator `P w`; the patch
    /// with homogeneous rails `(P, 1)` and `(N, w)` is the same point set with another parameter on each
    /// ruling, which is what is stored.
    ///
    /// # Errors
    /// [`GeometryError::LengthMismatch`] when the degrees differ.
    pub fn between(first: &Polynomial, second: &Rational) -> Result<Self> {
        if first.degree() != second.degree() {
            return Err(GeometryError::LengthMismatch {
                what: "control points of the second rail",
                index: 1,
                expected: first.degree() + 1,
                given: second.degree() + 1,
            });
        }
        let rails = || first.points().iter().zip(second.homogeneous());
        Ok(Self {
            points: rails()
                .map(|(p, (n, w))| vec![*p, n.map(|x| x / w)])
                .collect(),
            weights: Some(rails().map(|(_, (_, w))| vec![1.0, *w]).collect()),
        })
    }

    /// The ruled patch between two polynomial rails of the same degree.
    ///
    /// # Errors
    /// As [`RuledSurface::tensor`].
    pub fn ruled(surface: &RuledSurface<Polynomial, Polynomial>) -> Result<Self> {
        Ok(Self::from(&surface.tensor()?))
    }
}

/// The patches as one STEP file, each the face of an open shell with its four boundary curves.
///
/// ```
/// use torse_exchange::{BezierPatch, step};
/// use torse_geometry::{Bernstein, TensorSurface};
/// let net = (0..4).map(|i| (0..4).map(|j| [f64::from(i), f64::from(j), f64::from(i * j)]).collect()).collect();
/// let surface = TensorSurface::new(Bernstein, Bernstein, net)?;
/// let text = step(&[BezierPatch::from(&surface)]);
/// assert!(text.starts_with("ISO-10303-21;") && text.ends_with("END-ISO-10303-21;\n"));
/// assert_eq!(text.matches("B_SPLINE_SURFACE_WITH_KNOTS('',3,3,").count(), 1);
/// # Ok::<(), torse_geometry::GeometryError>(())
/// ```
#[must_use]
pub fn step(patches: &[BezierPatch]) -> String {
    let mut file = Entities::default();
    let faces: Vec<usize> = patches.iter().map(|patch| face(&mut file, patch)).collect();
    let shell = file.add(format!("OPEN_SHELL('',{})", references(&faces)));
    let model = file.add(format!("SHELL_BASED_SURFACE_MODEL('',(#{shell}))"));
    let length = file.add("(LENGTH_UNIT()NAMED_UNIT(*)SI_UNIT(.MILLI.,.METRE.))".to_owned());
    let angle = file.add("(NAMED_UNIT(*)PLANE_ANGLE_UNIT()SI_UNIT($,.RADIAN.))".to_owned());
    let solid = file.add("(NAMED_UNIT(*)SI_UNIT($,.STERADIAN.)SOLID_ANGLE_UNIT())".to_owned());
    let accuracy = file.add(format!(
        "UNCERTAINTY_MEASURE_WITH_UNIT(LENGTH_MEASURE(1.E-07),#{length},'distance_accuracy_value','')"
    ));
    let context = file.add(format!(
        "(GEOMETRIC_REPRESENTATION_CONTEXT(3)GLOBAL_UNCERTAINTY_ASSIGNED_CONTEXT((#{accuracy}))\
         GLOBAL_UNIT_ASSIGNED_CONTEXT((#{length},#{angle},#{solid}))REPRESENTATION_CONTEXT('',''))"
    ));
    let shape = file.add(format!(
        "MANIFOLD_SURFACE_SHAPE_REPRESENTATION('',(#{model}),#{context})"
    ));
    let application = file.add("APPLICATION_CONTEXT('automotive design')".to_owned());
    file.add(format!(
        "APPLICATION_PROTOCOL_DEFINITION('international standard','automotive_design',2010,#{application})"
    ));
    let market = file.add(format!("PRODUCT_CONTEXT('',#{application},'mechanical')"));
    let product = file.add(format!("PRODUCT('patch','patch','',(#{market}))"));
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
    format!(
        "ISO-10303-21;\nHEADER;\nFILE_DESCRIPTION((''),'2;1');\n\
         FILE_NAME('','1970-01-01T00:00:00',(''),(''),'torse','torse','');\n\
         FILE_SCHEMA(('AUTOMOTIVE_DESIGN {{ 1 0 10303 214 1 1 1 1 }}'));\nENDSEC;\nDATA;\n{}ENDSEC;\n\
         END-ISO-10303-21;\n",
        file.text
    )
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
        let _ = writeln!(self.text, "#{}={entity};", self.count);
        self.count
    }
}

fn face(file: &mut Entities, patch: &BezierPatch) -> usize {
    let ids: Vec<Vec<usize>> = patch
        .points
        .iter()
        .map(|row| {
            row.iter()
                .map(|p| file.add(format!("CARTESIAN_POINT('',{})", numbers(p))))
                .collect()
        })
        .collect();
    let surface = file.add(surface(&ids, patch.weights.as_deref()));
    // Once around: v = 0 forwards, u = 1 forwards, v = 1 backwards, u = 0 backwards.
    let weight = |i: usize, j: usize| {
        patch
            .weights
            .as_ref()
            .and_then(|w| w.get(i)?.get(j).copied())
    };
    let columns = ids.first().map_or(0, Vec::len);
    let side = |places: Vec<(usize, usize)>| -> Side {
        let points = places
            .iter()
            .filter_map(|&(i, j)| ids.get(i)?.get(j).copied())
            .collect();
        Side {
            points,
            weights: places.iter().map(|&(i, j)| weight(i, j)).collect(),
        }
    };
    let (last_row, last_column) = (ids.len().saturating_sub(1), columns.saturating_sub(1));
    let sides = [
        side((0..ids.len()).map(|i| (i, 0)).collect()),
        side((0..columns).map(|j| (last_row, j)).collect()),
        side((0..ids.len()).rev().map(|i| (i, last_column)).collect()),
        side((0..columns).rev().map(|j| (0, j)).collect()),
    ];
    let vertices = sides.each_ref().map(|side| {
        let point = side.points.first().copied().unwrap_or(0);
        file.add(format!("VERTEX_POINT('',#{point})"))
    });
    let mut edges = Vec::with_capacity(4);
    for (index, side) in sides.iter().enumerate() {
        let curve = file.add(side.curve());
        let (from, to) = (vertices[index], vertices[(index + 1) % 4]);
        let edge = file.add(format!("EDGE_CURVE('',#{from},#{to},#{curve},.T.)"));
        edges.push(file.add(format!("ORIENTED_EDGE('',*,*,#{edge},.T.)")));
    }
    let boundary = file.add(format!("EDGE_LOOP('',{})", references(&edges)));
    let bound = file.add(format!("FACE_OUTER_BOUND('',#{boundary},.T.)"));
    file.add(format!("ADVANCED_FACE('',(#{bound}),#{surface},.T.)"))
}

fn surface(ids: &[Vec<usize>], weights: Option<&[Vec<f64>]>) -> String {
    let (m, n) = (
        ids.len().saturating_sub(1),
        ids.first().map_or(0, Vec::len).saturating_sub(1),
    );
    let net = list(ids.iter().map(|row| references(row)));
    let knots = format!(
        "({},{0}),({},{1}),(0.,1.),(0.,1.),.UNSPECIFIED.",
        m + 1,
        n + 1
    );
    match weights {
        None => format!(
            "B_SPLINE_SURFACE_WITH_KNOTS('',{m},{n},{net},.UNSPECIFIED.,.F.,.F.,.F.,{knots})"
        ),
        Some(weights) => format!(
            "(BOUNDED_SURFACE()B_SPLINE_SURFACE({m},{n},{net},.UNSPECIFIED.,.F.,.F.,.F.)\
             B_SPLINE_SURFACE_WITH_KNOTS({knots})GEOMETRIC_REPRESENTATION_ITEM()\
             RATIONAL_B_SPLINE_SURFACE({})REPRESENTATION_ITEM('')SURFACE())",
            list(weights.iter().map(|row| numbers(row)))
        ),
    }
}

/// A boundary curve of a face: control points and, for rational patches, weights.
struct Side {
    points: Vec<usize>,
    weights: Vec<Option<f64>>,
}

impl Side {
    fn curve(&self) -> String {
        let degree = self.points.len().saturating_sub(1);
        let points = references(&self.points);
        let knots = format!("({},{0}),(0.,1.),.UNSPECIFIED.", degree + 1);
        let weights: Option<Vec<f64>> = self.weights.iter().copied().collect();
        match weights {
            None => {
                format!(
                    "B_SPLINE_CURVE_WITH_KNOTS('',{degree},{points},.UNSPECIFIED.,.F.,.F.,{knots})"
                )
            }
            Some(weights) => format!(
                "(BOUNDED_CURVE()B_SPLINE_CURVE({degree},{points},.UNSPECIFIED.,.F.,.F.)\
                 B_SPLINE_CURVE_WITH_KNOTS({knots})CURVE()GEOMETRIC_REPRESENTATION_ITEM()\
                 RATIONAL_B_SPLINE_CURVE({})REPRESENTATION_ITEM(''))",
                numbers(&weights)
            ),
        }
    }
}

fn list(items: impl Iterator<Item = String>) -> String {
    format!("({})", items.collect::<Vec<_>>().join(","))
}

fn references(ids: &[usize]) -> String {
    list(ids.iter().map(|id| format!("#{id}")))
}

/// Real numbers as STEP writes them: always with a point, exponents with a capital E.
fn numbers(values: &[f64]) -> String {
    let real = |x: &f64| match format!("{x:?}").split_once('e') {
        None => format!("{x:?}"),
        Some((digits, exponent)) if digits.contains('.') => format!("{digits}E{exponent}"),
        Some((digits, exponent)) => format!("{digits}.E{exponent}"),
    };
    list(values.iter().map(real))
}
