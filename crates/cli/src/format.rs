//! Formats of answers.

use clap::ValueEnum;

/// The format of an answer.
#[derive(Clone, Copy, ValueEnum)]
pub enum Format {
    Text,
    Json,
}
