//! Names of edges, and how much is cut beyond them.

use super::reader::{NumberKind, Reader, Value};
use crate::seams::PatchEdge;
use toml::de::DeValue;

/// Returns the names that a patch gives its edges.
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

/// Returns an allowance, a length that is not negative.
pub fn allowance(reader: &mut Reader, value: Value<'_>) -> Option<f64> {
    reader.number_in(value, NumberKind::Length, "[0, infinity)", |by| by >= 0.0)
}

/// Returns the allowances of a patch: one for all edges, or a table by their names; `own` are names of its own.
pub fn allowances(
    reader: &mut Reader,
    value: Value<'_>,
    own: &[(String, PatchEdge)],
) -> Option<Vec<(PatchEdge, f64)>> {
    if !matches!(value.get_ref(), DeValue::Table(_)) {
        let by = allowance(reader, value)?;
        return Some(PatchEdge::ALL.map(|(_, edge)| (edge, by)).to_vec());
    }
    let entries = reader.table(value, "allowances")?;
    let mut allowances = Vec::new();
    for (name, span, value) in entries.rest() {
        let named = own
            .iter()
            .find(|(known, _)| *known == name)
            .map(|(_, e)| *e);
        let usual = PatchEdge::ALL.iter().find(|(known, _)| *known == name);
        let Some(edge) = named.or_else(|| usual.map(|(_, edge)| *edge)) else {
            let names = own.iter().map(|(name, _)| name.as_str());
            let all: Vec<&str> = names.chain(PatchEdge::ALL.map(|(name, _)| name)).collect();
            let help = format!("the edges are `{}`", all.join("`, `"));
            reader.complain(&span, format!("there is no edge `{name}`"), &help);
            return None;
        };
        allowances.push((edge, allowance(reader, value)?));
    }
    Some(allowances)
}
