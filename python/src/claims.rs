//! Statements and papers.

use crate::errors::{UndecidedError, raised};
use crate::waiting::interruptible;
use pyo3::prelude::*;
use pyo3::types::{PyDict, PyList};
use std::path::PathBuf;
use torse::report::{Envelope, glossary, verdicts_json};
use torse::verdicts::outcome::Outcome;
use torse::{CorrectionLetter, Decided, Paper, Verification, WorkBudget};

/// Adds classes and functions to the module.
pub fn add(module: &Bound<'_, PyModule>) -> PyResult<()> {
    module.add_class::<PyDecided>()?;
    module.add_class::<PyPaper>()?;
    module.add_class::<PyVerification>()?;
    module.add_function(wrap_pyfunction!(decide, module)?)?;
    module.add_function(wrap_pyfunction!(sympy_code, module)?)
}

fn budget(units: Option<u64>) -> WorkBudget {
    units.map_or(WorkBudget::STANDARD, WorkBudget::new)
}

/// What is true of a statement, and why.
#[pyclass(frozen, name = "Decided", module = "torse")]
struct PyDecided(Decided);

/// Decides one statement about real numbers.
#[pyfunction]
#[pyo3(signature = (statement, setting, budget_units))]
fn decide(
    py: Python<'_>,
    statement: &str,
    setting: &str,
    budget_units: Option<u64>,
) -> PyResult<PyDecided> {
    let decided = interruptible(py, None, |verifier| {
        let verifier = verifier.with_budget(budget(budget_units));
        verifier.decide(statement, setting)
    })?;
    Ok(PyDecided(decided))
}

/// A formula as code of SymPy.
#[pyfunction]
fn sympy_code(py: Python<'_>, formula: &str) -> PyResult<String> {
    torse::sympy(formula).map_err(|error| raised(py, &error))
}

#[pymethods]
impl PyDecided {
    #[getter]
    fn verdict(&self) -> &'static str {
        self.0.word()
    }

    #[getter]
    fn is_true(&self) -> Option<bool> {
        self.0.is_true()
    }

    #[getter]
    fn evidence(&self) -> Option<&'static str> {
        self.0.evidence()
    }

    #[getter]
    fn statement(&self) -> Option<&str> {
        self.0.statement()
    }

    #[getter]
    fn corrected(&self) -> Option<&str> {
        self.0.corrected()
    }

    #[getter]
    fn conditions(&self) -> Vec<&str> {
        self.0.conditions()
    }

    #[getter]
    fn replayed(&self) -> Option<bool> {
        self.0.is_replayed()
    }

    #[getter]
    fn steps(&self) -> Vec<String> {
        self.0.steps()
    }

    #[getter]
    fn witness<'py>(&self, py: Python<'py>) -> PyResult<Option<Bound<'py, PyDict>>> {
        let Some(witness) = self.0.witness() else {
            return Ok(None);
        };
        let at = PyDict::new(py);
        for (name, value) in &witness.at {
            at.set_item(name, value)?;
        }
        let found = PyDict::new(py);
        found.set_item("at", at)?;
        found.set_item("left", &witness.left)?;
        found.set_item("right", &witness.right)?;
        Ok(Some(found))
    }

    #[getter]
    fn latex(&self) -> Option<String> {
        self.0.latex()
    }

    #[getter]
    fn mathml(&self) -> Option<String> {
        Some(self.0.mathml()?.concat())
    }

    /// The explanation: groups of labels and texts.
    #[getter]
    fn explanation(&self) -> Vec<Vec<(String, String)>> {
        rows(&self.0.explanation())
    }

    fn json(&self, py: Python<'_>) -> PyResult<String> {
        self.0.json().map_err(|error| raised(py, &error))
    }

    fn __bool__(&self) -> PyResult<bool> {
        self.0.is_true().ok_or_else(|| {
            let verdict = self.0.word();
            UndecidedError::new_err(format!(
                "the statement is neither true nor false as it stands: {verdict}"
            ))
        })
    }
}

fn rows(explanation: &torse::Explanation) -> Vec<Vec<(String, String)>> {
    let groups = explanation.groups.iter();
    let pair = |line: &torse::ExplanationLine| (line.label.clone(), line.text.clone());
    groups
        .map(|group| group.iter().map(pair).collect())
        .collect()
}

/// A paper: a folder of derivation files.
#[pyclass(frozen, name = "Paper", module = "torse")]
struct PyPaper(Paper);

#[pymethods]
impl PyPaper {
    #[new]
    fn new(py: Python<'_>, folder: PathBuf) -> PyResult<Self> {
        let paper = py.detach(|| Paper::open(&folder));
        Ok(Self(paper.map_err(|error| raised(py, &error))?))
    }

    /// A paper of texts: a dictionary from the names of files, `paper.toml` among them, to their texts.
    #[staticmethod]
    fn read(py: Python<'_>, files: std::collections::HashMap<String, String>) -> PyResult<Self> {
        let paper = py.detach(|| Paper::read(|name| files.get(name).cloned()));
        Ok(Self(paper.map_err(|error| raised(py, &error))?))
    }

    #[getter]
    fn id(&self) -> &str {
        self.0.id()
    }

    #[getter]
    fn title(&self) -> &str {
        self.0.title()
    }

    #[getter]
    fn ids(&self) -> Vec<String> {
        self.0.ids().map(str::to_owned).collect()
    }

    fn __len__(&self) -> usize {
        self.0.ids().count()
    }

    #[pyo3(signature = (*names))]
    fn only(&self, py: Python<'_>, names: Vec<String>) -> PyResult<Self> {
        let names: Vec<&str> = names.iter().map(String::as_str).collect();
        let kept = self.0.only(&names);
        Ok(Self(kept.map_err(|error| raised(py, &error))?))
    }

    #[pyo3(signature = (progress=None, budget=None))]
    fn verify(
        &self,
        py: Python<'_>,
        progress: Option<&Bound<'_, PyAny>>,
        budget: Option<u64>,
    ) -> PyResult<PyVerification> {
        let verified = interruptible(py, progress, |verifier| {
            self.0
                .verify_by(&verifier.with_budget(self::budget(budget)))
        })?;
        Ok(PyVerification(verified))
    }

    fn explain(&self, py: Python<'_>, name: &str) -> PyResult<Vec<Vec<(String, String)>>> {
        let explained = interruptible(py, None, |verifier| self.0.explain_by(name, verifier))?;
        Ok(rows(&explained))
    }
}

/// What was found of a paper.
#[pyclass(frozen, name = "Verification", module = "torse")]
struct PyVerification(Verification);

#[pymethods]
impl PyVerification {
    /// A dictionary for each claim, in the order of the files.
    fn rows<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyList>> {
        let rows = PyList::empty(py);
        for outcome in self.0.outcomes() {
            rows.append(row(py, outcome)?)?;
        }
        Ok(rows)
    }

    #[getter]
    fn mistakes(&self) -> Vec<String> {
        self.0.mistakes.iter().map(ToString::to_string).collect()
    }

    fn __len__(&self) -> usize {
        self.0.outcomes().count()
    }

    /// As `torse verify --format json`.
    fn json(&self, py: Python<'_>) -> PyResult<String> {
        verdicts_json(self.0.outcomes()).map_err(|error| raised(py, &error.into()))
    }

    /// The letter of corrections, as Markdown and as LaTeX.
    #[pyo3(signature = (sender, date))]
    fn letter(
        &self,
        py: Python<'_>,
        sender: Option<String>,
        date: Option<String>,
    ) -> PyResult<(String, String)> {
        let letters = self.0.letters(&Envelope { sender, date });
        let letters = letters.map_err(|error| raised(py, &error))?;
        let texts =
            |written: fn(&CorrectionLetter) -> String| letters.iter().map(written).collect();
        Ok((
            texts(CorrectionLetter::markdown),
            texts(CorrectionLetter::latex),
        ))
    }
}

fn row<'py>(py: Python<'py>, outcome: &Outcome) -> PyResult<Bound<'py, PyDict>> {
    let row = PyDict::new(py);
    row.set_item("id", &outcome.claim.id)?;
    row.set_item("at", &outcome.claim.at)?;
    row.set_item("verdict", glossary::verdict(outcome.verdict()).key)?;
    let evidence = outcome.evidence().map(|of| glossary::evidence(of).key);
    row.set_item("evidence", evidence)?;
    row.set_item("statement", outcome.parsed().map(|formula| &formula.text))?;
    let corrected = outcome.correction().map(|of| &of.statement.text);
    row.set_item("corrected", corrected)?;
    let conditions: Vec<&str> = outcome
        .conditions()
        .iter()
        .map(|of| of.text.as_str())
        .collect();
    row.set_item("conditions", conditions)?;
    row.set_item("replayed", outcome.replay().map(|replay| replay.replayed))?;
    Ok(row)
}
