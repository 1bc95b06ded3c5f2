//! The command as its users meet it: the real binary, run on folders of derivations.

mod data;
mod explain;
mod report;
mod support;
mod verify;
