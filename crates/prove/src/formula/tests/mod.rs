//! Exact values written as formulas: what is written has the value it came from.

mod algebra;
mod evaluate;
