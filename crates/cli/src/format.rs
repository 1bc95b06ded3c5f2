//! In what form a command answers.

use clap::ValueEnum;

/// The form of an answer.
#[derive(Clone, Copy, ValueEnum)]
pub enum Format {
    Text,
    Json,
}
