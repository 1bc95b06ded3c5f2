//! Hypotheses as TOML: a formula, or a table that also states the provenance of the formula.

use super::Text;
use serde::de::value::MapAccessDeserializer;
use serde::de::{MapAccess, Visitor};
use serde::{Deserialize, Deserializer};
use std::fmt;
use toml::Spanned;

/// One entry of `assume` or `given`: `'nu > 0'`, or `{ states = 'nu > 0', printed = 'with nu > 0' }`.
#[derive(Debug, Clone)]
pub struct HypothesisEntry {
    /// The formula.
    pub states: Text,
    /// The provenance; `None` for an entry that is a formula alone.
    pub from: Option<FromEntry>,
}

/// The fields that state the provenance of a hypothesis or a range.
#[derive(Debug, Clone, Default)]
pub struct FromEntry {
    /// The words of the paper.
    pub printed: Option<Text>,
    /// The claim whose printed text contains them; by default the claim itself.
    pub within: Option<Text>,
    /// Why it is assumed although the paper does not state it.
    pub ours: Option<Text>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Table {
    states: Text,
    printed: Option<Text>,
    #[serde(rename = "in")]
    within: Option<Text>,
    ours: Option<Text>,
}

/// An entry without its place.
enum Form {
    Formula(String),
    Table(Box<Table>),
}

impl<'de> Deserialize<'de> for HypothesisEntry {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        let form = Spanned::<Form>::deserialize(deserializer)?;
        let place = form.span();
        Ok(match form.into_inner() {
            Form::Formula(text) => Self {
                states: Spanned::new(place, text),
                from: None,
            },
            Form::Table(table) => Self {
                states: table.states,
                from: Some(FromEntry {
                    printed: table.printed,
                    within: table.within,
                    ours: table.ours,
                }),
            },
        })
    }
}

impl<'de> Deserialize<'de> for Form {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        deserializer.deserialize_any(Entry)
    }
}

struct Entry;

impl<'de> Visitor<'de> for Entry {
    type Value = Form;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("a formula, or a table with `states` and `printed` or `ours`")
    }

    fn visit_str<E>(self, text: &str) -> Result<Form, E> {
        Ok(Form::Formula(text.to_owned()))
    }

    fn visit_string<E>(self, text: String) -> Result<Form, E> {
        Ok(Form::Formula(text))
    }

    fn visit_map<A: MapAccess<'de>>(self, map: A) -> Result<Form, A::Error> {
        Table::deserialize(MapAccessDeserializer::new(map)).map(|table| Form::Table(table.into()))
    }
}
