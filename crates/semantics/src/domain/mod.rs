//! Points of the domain of a claim: numbers in the declared sets that satisfy all hypotheses.
//!
//! Points come as a stream that a text seeds, the claim's id, so that they are the same on every run. [`set`] draws a
//! number of a declared set, which [`narrow`] makes smaller, [`draft`] one number after the other as they are asked for,
//! [`sort`] puts them into the order that is assumed,
//! [`solve`] changes some of them until the assumed and given equations hold, by the steps of [`newton`], and [`point`]
//! checks what came out. [`constraints`] are the hypotheses that can be used so.

pub(crate) mod constraints;
pub(crate) mod draft;
pub(crate) mod narrow;
pub(crate) mod newton;
pub(crate) mod point;
pub(crate) mod set;
pub(crate) mod solve;
pub(crate) mod sort;
pub(crate) mod stream;
