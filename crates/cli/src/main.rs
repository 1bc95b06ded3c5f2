//! The `torse` command.
fn main() {}
