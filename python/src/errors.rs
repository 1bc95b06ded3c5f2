//! Errors of the library as exceptions that know their place.

use pyo3::create_exception;
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;
use torse::Error;

create_exception!(
    torse,
    TorseError,
    PyValueError,
    "What is wrong with a formula, a paper or a design. Attributes: file, line, column, hint; each may be None."
);
create_exception!(
    torse,
    UndecidedError,
    TorseError,
    "A statement that is neither proved nor refuted was asked whether it is true."
);

/// Adds the exceptions to the module.
pub fn add(module: &Bound<'_, PyModule>) -> PyResult<()> {
    let py = module.py();
    let class = py.get_type::<TorseError>();
    // An error without a place says so.
    for attribute in ["file", "line", "column", "hint"] {
        class.setattr(attribute, py.None())?;
    }
    module.add("TorseError", class)?;
    module.add("UndecidedError", py.get_type::<UndecidedError>())
}

/// An error with its place, if it has one.
pub fn raised(py: Python<'_>, error: &Error) -> PyErr {
    let (place, hint) = (error.place(), error.hint());
    let raised = TorseError::new_err(error.in_full());
    let value = raised.value(py);
    let file = place.as_ref().map(|place| place.file.as_str());
    let set = value
        .setattr("file", file)
        .and_then(|()| value.setattr("line", place.as_ref().map(|place| place.line)))
        .and_then(|()| value.setattr("column", place.as_ref().map(|place| place.column)))
        .and_then(|()| value.setattr("hint", hint));
    match set {
        Ok(()) => raised,
        Err(other) => other,
    }
}
