//! The Python door on the library `torse`: values in, values out, no mathematics.

mod claims;
mod designs;
mod errors;
mod waiting;

use pyo3::prelude::*;

#[pymodule]
fn _torse(module: &Bound<'_, PyModule>) -> PyResult<()> {
    module.add("__version__", env!("CARGO_PKG_VERSION"))?;
    errors::add(module)?;
    claims::add(module)?;
    designs::add(module)
}
