//! The command as its users meet it: the real binary, run on folders of derivations.

// Helpers of tests fail as tests do.
#![allow(clippy::unwrap_used, clippy::expect_used)]

mod annotations;
mod audit;
mod compare;
mod corpus;
mod data;
mod decide;
mod derive;
mod design;
mod erratum;
mod exit_codes;
mod explain;
#[path = "../../../../tests/support/glossary.rs"]
mod glossary;
mod help;
mod hostile;
mod input;
mod list;
mod lsp;
mod manuscript;
mod new;
mod prove;
mod readme;
mod report;
mod studio;
mod support;
mod verify;
mod watch;
