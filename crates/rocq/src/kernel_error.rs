//! Why the kernel could not be asked.

use std::io;
use thiserror::Error;

/// Why nothing could be checked.
#[derive(Debug, Error)]
pub enum KernelError {
    /// The program is not installed.
    #[error("`coqc` was not found")]
    Missing,
    /// The program is installed, but Coquelicot is not, or the library does not compile.
    #[error("the library is not accepted: {0}")]
    Library(String),
    /// The scratch folder, or the program, failed.
    #[error("{what}: {source}")]
    System {
        /// The failed action.
        what: String,
        /// The message of the system.
        source: io::Error,
    },
}
