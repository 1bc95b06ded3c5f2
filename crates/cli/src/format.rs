//! Formats of answers.

use clap::ValueEnum;
use torse_report::ReportError;

/// The format of an answer.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub enum Format {
    /// Text
    Text,
    /// JSON, identical bytes on every run
    Json,
}

/// Writes a value as indented JSON that ends with a line break.
pub fn pretty_json(value: &impl serde::Serialize) -> Result<String, ReportError> {
    Ok(serde_json::to_string_pretty(value)? + "\n")
}

/// Writes a value as a line of JSON.
pub fn json_line(value: &impl serde::Serialize) -> Result<String, ReportError> {
    Ok(serde_json::to_string(value)? + "\n")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_json_cannot_write_is_an_error_and_no_empty_text() {
        let keyed_by_lists = std::collections::BTreeMap::from([(vec![1], 2)]);
        assert!(pretty_json(&keyed_by_lists).is_err());
        assert_eq!(pretty_json(&[1]).ok().as_deref(), Some("[\n  1\n]\n"));
    }
}
