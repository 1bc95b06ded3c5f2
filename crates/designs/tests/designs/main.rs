//! Design files from reading to the shop floor.

#![allow(
    clippy::unwrap_used,
    clippy::expect_used,
    clippy::panic,
    reason = "tests"
)]

mod allowances;
mod bench;
mod blanks;
mod connect;
mod covers;
mod ends;
mod faces;
mod hostile;
mod iges_faces;
mod inside_radii;
mod joints;
mod kinds;
mod lint;
mod mistakes;
mod openings;
mod patterns;
mod plane_faces;
mod points;
mod rails;
mod random;
mod round_edges;
mod round_faces;
mod schema;
mod seams;
mod space;
mod step_text;
mod surfaces;
mod worked;
mod workshop;
