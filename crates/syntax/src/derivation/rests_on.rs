//! What each claim of a paper rests on, as text: what it states and the declarations that it sees, without comments, layout
//! and places.
//!
//! Two claims with equal texts have equal findings: a claim is decided from its own entry, the declarations of its paper and
//! its file, and, where it belongs to an example with printed values, the other values of that example.

use super::paper::Paper;
use super::source::Source;
use std::collections::BTreeMap;
use std::fmt::Write;
use std::sync::Arc;
use toml::de::{DeTable, DeValue};

/// The sections whose entries all claims below them see.
const SHARED: [&str; 4] = ["symbols", "basis", "define", "display"];

/// What a claim rests on.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct RestsOn {
    /// The claim.
    pub id: String,
    /// The declarations that it sees; the same text for all claims of a file.
    pub shared: Arc<str>,
    /// Its own fields, those of the other values of its example, and the ids of the claims that it uses.
    pub own: String,
}

impl Paper {
    /// What each claim rests on, in the order of the claims.
    ///
    /// All declarations of a file count for each of its claims, used or not: a text that differs may mean the same, and never
    /// the other way round.
    #[must_use]
    pub fn rests_on(&self) -> Vec<RestsOn> {
        let head = format!("{}\n{}", self.head.id, File::read(&self.source).shared);
        let mut files: BTreeMap<&str, (File, Arc<str>)> = BTreeMap::new();
        let claims = self.claims.iter().map(|claim| {
            let source = &claim.origin.source;
            let (file, shared) = files.entry(&source.name).or_insert_with(|| {
                let file = File::read(source);
                let shared = format!("{head}\n{}", file.shared).into();
                (file, shared)
            });
            let values = claim.example.iter();
            let values = values.map(|value| value.entry.id.get_ref().as_str());
            let own = std::iter::once(claim.entry.id.get_ref().as_str()).chain(values);
            let entries: Vec<&str> = own
                .filter_map(|id| file.claims.get(id).map(String::as_str))
                .collect();
            RestsOn {
                id: claim.entry.id.get_ref().clone(),
                shared: Arc::clone(shared),
                own: format!("{}\nuses {}", entries.join("\n"), claim.uses.join(" ")),
            }
        });
        claims.collect()
    }
}

/// A file as plain text.
#[derive(Debug, Default)]
struct File {
    shared: String,
    claims: BTreeMap<String, String>,
}

impl File {
    /// Reads a file that was read before; one that is no TOML has no claims.
    fn read(source: &Source) -> Self {
        let mut file = Self::default();
        let Ok(table) = DeTable::parse(&source.text) else {
            return file;
        };
        for (name, value) in table.get_ref().iter() {
            let name: &str = name.get_ref();
            match value.get_ref() {
                DeValue::Array(claims) if name == "claim" => {
                    for claim in claims.iter() {
                        let id = claim.get_ref().get("id");
                        let id = id.and_then(|id| id.get_ref().as_str()).unwrap_or_default();
                        file.claims.insert(id.to_owned(), plain(claim.get_ref()));
                    }
                }
                value if SHARED.contains(&name) => {
                    file.shared += &format!("{name} {}\n", plain(value));
                }
                _ => {}
            }
        }
        file
    }
}

fn plain(value: &DeValue<'_>) -> String {
    let mut text = String::new();
    add(value, &mut text);
    text
}

/// Adds a value. Each begins with a letter for its type, and texts have their lengths before them, so that different values
/// have different texts.
fn add(value: &DeValue<'_>, text: &mut String) {
    match value {
        DeValue::String(string) => add_text('s', string, text),
        DeValue::Integer(integer) => add_text('i', &integer.to_string(), text),
        DeValue::Float(float) => add_text('f', float.as_str(), text),
        DeValue::Boolean(truth) => add_text('b', &truth.to_string(), text),
        DeValue::Datetime(time) => add_text('d', &time.to_string(), text),
        DeValue::Array(values) => {
            text.push('[');
            values.iter().for_each(|value| add(value.get_ref(), text));
            text.push(']');
        }
        DeValue::Table(table) => {
            text.push('{');
            for (name, value) in table.iter() {
                add_text('s', name.get_ref(), text);
                add(value.get_ref(), text);
            }
            text.push('}');
        }
    }
}

fn add_text(kind: char, string: &str, text: &mut String) {
    // A string takes all that is written.
    let _ = write!(text, "{kind}{}:{string}", string.len());
}
