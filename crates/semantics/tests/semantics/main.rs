//! What core terms mean, tested from texts.

mod domain;
mod instances;
mod laws;
mod net;
mod support;
mod values;
