//! Names of edges.

use super::reader::{Reader, Value};
use crate::seams::PatchEdge;

/// The names that a patch gives its edges.
pub fn names(reader: &mut Reader, value: Value<'_>) -> Option<Vec<(String, PatchEdge)>> {
    let entries = reader.table(value, "edges")?;
    let mut names = Vec::new();
    for (name, span, value) in entries.rest() {
        if name.is_empty() || name.contains('.') || name.chars().any(char::is_control) {
            reader.complain(&span, "the name of an edge has letters and no dot", "");
            return None;
        }
        names.push((name, reader.word(value, "edge", &PatchEdge::ALL)?));
    }
    Some(names)
}
