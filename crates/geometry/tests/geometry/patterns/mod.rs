//! Flat patterns.

mod bent;
mod carried;
mod chains;
mod closed_forms;
mod laws;
mod refused;
mod strips;
