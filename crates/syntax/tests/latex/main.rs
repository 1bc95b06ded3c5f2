//! Formulas in LaTeX, as authors of papers write them, and the trees that are meant.

#![allow(clippy::unwrap_used)]

mod formulas;
mod hostile;
mod normal;
mod rules;
