//! What core terms mean, written to be read.
#![warn(missing_docs)]

mod arithmetic;
mod domain;
mod evaluate;
mod family;
mod functions;
mod gap;
mod judge;
mod linear;
mod name;
mod net;
mod real;
mod series;
mod value;
mod witness;

pub use arithmetic::Arithmetic;
pub use domain::point::{Outside, Point};
pub use evaluate::Evaluator;
pub use gap::{Gap, Undefined, Unknown, Work};
pub use judge::Judgement;
pub use name::Name;
pub use net::{Tally, check, excepting, judge, tally};
pub use real::{Real, Reals};
pub use series::Series;
pub use value::Value;
pub use witness::{Unreadable, Witness, check_witness, read};
