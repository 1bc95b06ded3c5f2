//! The JSON schema of derivation files says what the reader reads.

#![allow(clippy::unwrap_used, clippy::panic, reason = "helpers of tests")]

use serde::Deserialize;
use serde::de::value::Error;
use serde::de::{Deserializer, Error as _, Visitor};
use serde_json::Value;
use std::collections::BTreeSet;
use std::path::PathBuf;
use torse_syntax::derivation::schema::corrigendum::{ChangeEntry, CorrigendumEntry};
use torse_syntax::derivation::schema::figure::{
    Aspect, Border, ColourMap, Dash, FigureEntry, Frame, LayerEntry, Legend, Marker, NamedColour,
    PanelEntry, PieceEntry, Place, Rulings, ScaleEntry, Shape, Style, TorseEntry,
};
use torse_syntax::derivation::schema::{
    AnswerEntry, BasisEntry, ClaimEntry, CodeEntry, PaperHead, ReadingEntry, SideEntry, SymbolEntry,
};
use torse_syntax::taxonomy::{Flag, Kind, Verdict};

fn derivations() -> PathBuf {
    PathBuf::from(concat!(env!("CARGO_MANIFEST_DIR"), "/../../derivations"))
}

fn schema() -> Value {
    let text = std::fs::read_to_string(derivations().join("schema.json")).unwrap();
    serde_json::from_str(&text).unwrap()
}

/// Asks a type for the names of its fields or variants, and reads nothing.
struct Probe<'a>(&'a mut &'static [&'static str]);

impl<'de> Deserializer<'de> for Probe<'_> {
    type Error = Error;

    fn deserialize_any<V: Visitor<'de>>(self, _: V) -> Result<V::Value, Error> {
        Err(Error::custom("neither a table nor a word"))
    }

    fn deserialize_struct<V: Visitor<'de>>(
        self,
        _: &'static str,
        fields: &'static [&'static str],
        visitor: V,
    ) -> Result<V::Value, Error> {
        *self.0 = fields;
        self.deserialize_any(visitor)
    }

    fn deserialize_enum<V: Visitor<'de>>(
        self,
        name: &'static str,
        variants: &'static [&'static str],
        visitor: V,
    ) -> Result<V::Value, Error> {
        self.deserialize_struct(name, variants, visitor)
    }

    serde::forward_to_deserialize_any! {
        bool i8 i16 i32 i64 u8 u16 u32 u64 f32 f64 char str string bytes byte_buf option unit
        unit_struct newtype_struct seq tuple tuple_struct map identifier ignored_any
    }
}

/// The names that a type reads.
fn names<'de, T: Deserialize<'de>>() -> BTreeSet<&'static str> {
    let mut found: &'static [&'static str] = &[];
    assert!(T::deserialize(Probe(&mut found)).is_err());
    assert!(!found.is_empty());
    found.iter().copied().collect()
}

#[test]
fn the_schema_has_the_entries_that_the_reader_knows() {
    let schema = schema();
    let read = [
        ("paper", names::<PaperHead>()),
        ("symbol", names::<SymbolEntry>()),
        ("basis", names::<BasisEntry>()),
        ("claim", names::<ClaimEntry>()),
        ("reading", names::<ReadingEntry>()),
        ("code", names::<CodeEntry>()),
        ("answer", names::<AnswerEntry>()),
        ("corrigendum", names::<CorrigendumEntry>()),
        ("change", names::<ChangeEntry>()),
        ("figure", names::<FigureEntry>()),
        ("torse", names::<TorseEntry>()),
        ("piece", names::<PieceEntry>()),
        ("panel", names::<PanelEntry>()),
        ("layer", names::<LayerEntry>()),
        ("style", names::<Style>()),
        ("scale", names::<ScaleEntry>()),
    ];
    for (section, known) in read {
        let part = &schema["$defs"][section];
        let described = part["properties"].as_object().unwrap();
        let described: BTreeSet<&str> = described.keys().map(String::as_str).collect();
        assert_eq!(described, known, "{section}");
        assert_eq!(part["additionalProperties"], false, "{section}");
    }
}

#[test]
fn the_schema_has_the_words_that_the_reader_knows() {
    let schema = schema();
    let read = [
        ("claim", "kind", names::<Kind>()),
        ("claim", "expect", names::<Verdict>()),
        ("code", "side", names::<SideEntry>()),
        ("answer", "flag", names::<Flag>()),
        ("layer", "draw", names::<Shape>()),
        ("piece", "draw", names::<Rulings>()),
        ("panel", "aspect", names::<Aspect>()),
        ("panel", "frame", names::<Frame>()),
        ("panel", "legend", names::<Legend>()),
        ("style", "dash", names::<Dash>()),
        ("style", "marker", names::<Marker>()),
        ("style", "border", names::<Border>()),
        ("style", "place", names::<Place>()),
        ("scale", "map", names::<ColourMap>()),
    ];
    let words = |entry: &Value| -> BTreeSet<String> {
        let words = entry["enum"].as_array().unwrap().iter();
        words
            .map(|word| word.as_str().unwrap().to_owned())
            .collect()
    };
    for (section, field, known) in read {
        let entry = &schema["$defs"][section]["properties"][field];
        let known: BTreeSet<String> = known.into_iter().map(str::to_owned).collect();
        assert_eq!(words(entry), known, "{section}.{field}");
    }
    let colour = &schema["$defs"]["style"]["properties"]["colour"]["anyOf"][1];
    let known = names::<NamedColour>().into_iter().map(str::to_owned);
    assert_eq!(words(colour), known.collect());
}

/// Where a value is not as the schema has it.
fn faults(schema: &Value, part: &Value, value: &Value, at: &str, found: &mut Vec<String>) {
    if let Some(name) = part["$ref"].as_str() {
        let name = name.trim_start_matches("#/$defs/");
        return faults(schema, &schema["$defs"][name], value, at, found);
    }
    if let Some(choices) = part["anyOf"].as_array() {
        let fits = |choice: &Value| {
            let mut inner = vec![];
            faults(schema, choice, value, at, &mut inner);
            inner.is_empty()
        };
        if !choices.iter().any(fits) {
            found.push(format!("{at}: none of the forms"));
        }
        return;
    }
    let kind = match value {
        Value::Object(_) => "object",
        Value::Array(_) => "array",
        Value::String(_) => "string",
        Value::Number(n) if n.is_f64() => "number",
        Value::Number(_) => "integer",
        _ => "other",
    };
    let wanted = part["type"].as_str().unwrap_or(kind);
    let words = part["enum"]
        .as_array()
        .is_none_or(|words| words.contains(value));
    let only = part.get("const").is_none_or(|only| only == value);
    if !words || !only || (wanted != kind && !(wanted == "number" && kind == "integer")) {
        found.push(format!("{at}: {value}"));
    }
    for (n, item) in value.as_array().into_iter().flatten().enumerate() {
        faults(schema, &part["items"], item, &format!("{at}[{n}]"), found);
    }
    let Some(entries) = value.as_object() else {
        return;
    };
    for name in part["required"].as_array().into_iter().flatten() {
        if !entries.contains_key(name.as_str().unwrap()) {
            found.push(format!("{at}: without {name}"));
        }
    }
    for (name, entry) in entries {
        let known = part["properties"].get(name);
        match known.unwrap_or(&part["additionalProperties"]) {
            Value::Bool(_) | Value::Null => found.push(format!("{at}: {name}")),
            inner => faults(schema, inner, entry, &format!("{at}.{name}"), found),
        }
    }
}

fn faults_of(text: &str) -> Vec<String> {
    let schema = schema();
    let value: toml::Table = toml::from_str(text).unwrap();
    let mut found = vec![];
    let value = serde_json::to_value(value).unwrap();
    faults(&schema, &schema, &value, "", &mut found);
    found
}

#[test]
fn the_derivation_files_are_as_the_schema_has_them() {
    let mut seen = 0;
    for paper in std::fs::read_dir(derivations()).unwrap() {
        let paper = paper.unwrap().path();
        if !paper.is_dir() {
            continue;
        }
        for file in std::fs::read_dir(paper).unwrap() {
            let file = file.unwrap().path();
            if file.extension().is_some_and(|ending| ending == "toml") {
                let text = std::fs::read_to_string(&file).unwrap();
                assert_eq!(faults_of(&text), Vec::<String>::new(), "{}", file.display());
                seen += 1;
            }
        }
    }
    assert!(seen > 10, "{seen} files");
}

#[test]
fn mistakes_are_no_derivation_files_by_the_schema() {
    let right = "[[claim]]\nid = 'a/b'\nat = '1'\nkind = 'identity'\nprinted = 'x'\nstates = 'x'\n";
    assert_eq!(faults_of(right), Vec::<String>::new());
    for (from, to) in [
        ("states", "state"),
        ("'identity'", "'theorem'"),
        ("at = '1'\n", ""),
        ("'a/b'", "3"),
        ("[[claim]]", "[[claims]]"),
    ] {
        assert!(!faults_of(&right.replace(from, to)).is_empty(), "{to}");
    }
}
