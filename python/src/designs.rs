//! Designs and their patterns, numbers as numpy arrays.

use crate::errors::raised;
use numpy::{PyArray1, PyArray2, PyArrayMethods};
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;
use serde::Serialize;
use std::path::PathBuf;
use torse::designs::eval::{EvalPlaces, EvalRow};
use torse::designs::export::{ENDINGS, mesh};
use torse::designs::unroll::Demand;
use torse::{Design, DesignFailure, Error, Pattern, report_text};

/// Adds the classes to the module.
pub fn add(module: &Bound<'_, PyModule>) -> PyResult<()> {
    module.add_class::<PyDesign>()?;
    module.add_class::<PyPattern>()
}

/// An array of points, one a row: the memory of the vector becomes that of the array.
fn array<'py, const N: usize>(
    py: Python<'py>,
    points: Vec<[f64; N]>,
) -> PyResult<Bound<'py, PyArray2<f64>>> {
    let rows = points.len();
    PyArray1::from_vec(py, points.into_flattened()).reshape([rows, N])
}

fn json(value: &impl Serialize) -> PyResult<String> {
    serde_json::to_string(value).map_err(|error| PyValueError::new_err(error.to_string()))
}

/// A design: points, curves, patches, in millimetres.
#[pyclass(frozen, name = "Design", module = "torse")]
struct PyDesign(Design);

#[pymethods]
impl PyDesign {
    /// Reads a design file.
    #[staticmethod]
    fn open(py: Python<'_>, path: PathBuf) -> PyResult<Self> {
        let design = py.detach(|| Design::open(&path));
        Ok(Self(design.map_err(|error| raised(py, &error))?))
    }

    /// Reads the text of a design; `files` is a dictionary from the names of files that it takes curves from to their bytes.
    #[staticmethod]
    #[pyo3(signature = (text, name="design.toml", files=None))]
    fn read(
        py: Python<'_>,
        text: &str,
        name: &str,
        files: Option<std::collections::HashMap<String, Vec<u8>>>,
    ) -> PyResult<Self> {
        let files = files.unwrap_or_default();
        let mut file = |name: &str| {
            let bytes = files.get(name).cloned();
            bytes.ok_or_else(|| format!("`files` has no `{name}`"))
        };
        let design = py.detach(|| Design::read_with(name, text, &mut file));
        Ok(Self(design.map_err(|error| raised(py, &error))?))
    }

    #[getter]
    fn name(&self) -> &str {
        self.0.name()
    }

    #[getter]
    fn names(&self) -> Vec<String> {
        self.0.names()
    }

    /// The report of `torse inspect` as JSON.
    #[pyo3(signature = (quick))]
    fn inspect_json(&self, py: Python<'_>, quick: bool) -> PyResult<String> {
        let report = py.detach(|| match quick {
            true => self.0.inspect_quickly(),
            false => self.0.inspect(),
        });
        json(&report.map_err(|error| raised(py, &error))?)
    }

    /// The report of `torse inspect` as a text.
    fn report(&self, py: Python<'_>) -> PyResult<String> {
        let report = py.detach(|| self.0.inspect());
        Ok(report_text(&report.map_err(|error| raised(py, &error))?))
    }

    #[pyo3(signature = (allow_strain=0.0, only=None, rulings=None))]
    fn unroll(
        &self,
        py: Python<'_>,
        allow_strain: f64,
        only: Option<String>,
        rulings: Option<usize>,
    ) -> PyResult<PyPattern> {
        let demand = Demand {
            allow_strain,
            only,
            rulings,
            ..Demand::default()
        };
        let pattern = py.detach(|| self.0.unroll_as(&demand));
        Ok(PyPattern(pattern.map_err(|error| raised(py, &error))?))
    }

    /// Points, normals and curvatures of a patch at a grid or at places `[u, v]`: a tuple of arrays.
    #[pyo3(signature = (patch, grid, places))]
    #[expect(clippy::type_complexity, reason = "a tuple of arrays")]
    fn evaluate<'py>(
        &self,
        py: Python<'py>,
        patch: Option<&str>,
        grid: Option<(usize, usize)>,
        places: Option<Vec<[f64; 2]>>,
    ) -> PyResult<(
        Bound<'py, PyArray2<f64>>,
        Bound<'py, PyArray2<f64>>,
        Bound<'py, PyArray2<f64>>,
        Bound<'py, PyArray2<f64>>,
    )> {
        let at = match (grid, places) {
            (Some((m, n)), None) => EvalPlaces::Grid(m, n),
            (None, Some(places)) => EvalPlaces::Places(places),
            _ => return Err(PyValueError::new_err("either a grid or places")),
        };
        let rows = py.detach(|| self.0.eval(patch, &at));
        let rows = rows.map_err(|error| raised(py, &error))?;
        const NONE: f64 = f64::NAN;
        let column = |value: fn(&EvalRow) -> [f64; 3]| array(py, rows.iter().map(value).collect());
        Ok((
            array(py, rows.iter().map(|row| [row.u, row.v]).collect())?,
            column(|row| row.point)?,
            column(|row| row.normal.unwrap_or([NONE; 3]))?,
            array(
                py,
                rows.iter()
                    .map(|row| row.curvatures.unwrap_or([NONE; 2]))
                    .collect(),
            )?,
        ))
    }

    /// The points of a patch on a grid of so many steps, those along the rulings fastest.
    fn points<'py>(
        &self,
        py: Python<'py>,
        patch: &str,
        grid: [usize; 2],
    ) -> PyResult<Bound<'py, PyArray2<f64>>> {
        let points = py.detach(|| self.0.points(patch, grid));
        array(py, points.map_err(|error| raised(py, &error))?)
    }

    /// How many seconds the library takes for `points`, without Python and numpy.
    fn seconds_of_points(&self, py: Python<'_>, patch: &str, grid: [usize; 2]) -> PyResult<f64> {
        let (points, seconds) = py.detach(|| {
            let start = std::time::Instant::now();
            let points = self.0.points(patch, grid);
            (points, start.elapsed().as_secs_f64())
        });
        points.map_err(|error| raised(py, &error))?;
        Ok(seconds)
    }

    /// The design as one mesh: vertices, normals, triangles.
    #[expect(clippy::type_complexity, reason = "a tuple of arrays")]
    fn mesh<'py>(
        &self,
        py: Python<'py>,
    ) -> PyResult<(
        Bound<'py, PyArray2<f64>>,
        Bound<'py, PyArray2<f64>>,
        Bound<'py, PyArray2<u32>>,
    )> {
        let made = py.detach(|| mesh(self.0.parts()));
        let made = made.map_err(|error| raised(py, &Error::from(DesignFailure::from(error))))?;
        let triangles = made.triangles().to_vec();
        let count = triangles.len();
        Ok((
            array(py, made.vertices().to_vec())?,
            array(py, made.normals().to_vec())?,
            PyArray1::from_vec(py, triangles.into_flattened()).reshape([count, 3])?,
        ))
    }

    /// The bytes of a file with this ending.
    fn export(&self, py: Python<'_>, ending: &str) -> PyResult<Vec<u8>> {
        let known = ENDINGS.iter().find(|known| **known == ending);
        let Some(ending) = known else {
            let all = ENDINGS.join(", ");
            return Err(PyValueError::new_err(format!("the extensions are {all}")));
        };
        let bytes = py.detach(|| self.0.export(ending, &Demand::default()));
        bytes.map_err(|error| raised(py, &error))
    }

    /// A picture of it with its pattern, as SVG.
    fn svg(&self, py: Python<'_>) -> PyResult<String> {
        let picture = py.detach(|| self.0.picture());
        Ok(picture.map_err(|error| raised(py, &error))?.svg)
    }
}

/// The flat pattern of a design.
#[pyclass(frozen, name = "Pattern", module = "torse")]
struct PyPattern(Pattern);

#[pymethods]
impl PyPattern {
    #[getter]
    fn area(&self) -> f64 {
        self.0.area()
    }

    #[getter]
    fn pieces(&self) -> Vec<String> {
        let pieces = self.0.pieces().iter();
        pieces.map(|piece| piece.piece.name.clone()).collect()
    }

    /// The outline of a piece as a polygon, which misses its arcs by at most `chord`.
    #[pyo3(signature = (piece=0, chord=0.01))]
    fn outline<'py>(
        &self,
        py: Python<'py>,
        piece: usize,
        chord: f64,
    ) -> PyResult<Bound<'py, PyArray2<f64>>> {
        let found = self.0.pieces().get(piece);
        let found = found.ok_or_else(|| {
            let count = self.0.pieces().len();
            PyValueError::new_err(format!("there are {count} pieces, counted from 0"))
        })?;
        let polygon = found.flat.outline().polygon(chord);
        array(py, polygon.map_err(|error| raised(py, &error.into()))?)
    }

    /// What the pattern promises, as JSON.
    fn summary_json(&self) -> PyResult<String> {
        json(self.0.summary())
    }

    fn dxf(&self, py: Python<'_>) -> PyResult<String> {
        let text = py.detach(|| self.0.dxf());
        text.map_err(|error| raised(py, &error))
    }

    fn svg(&self, py: Python<'_>) -> PyResult<String> {
        let text = py.detach(|| self.0.svg());
        text.map_err(|error| raised(py, &error))
    }
}
