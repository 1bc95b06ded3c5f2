//! Formulas of the papers in every notation, and the laws: what is written is read back.

mod papers;
mod round_trip;
