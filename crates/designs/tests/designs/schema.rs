//! The JSON schema says what the reader reads.

use serde_json::Value;
use std::collections::BTreeSet;
use torse_designs::keys;

fn schema() -> Value {
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/../../designs/schema.json");
    serde_json::from_str(&std::fs::read_to_string(path).unwrap()).unwrap()
}

#[test]
fn the_schema_has_the_entries_that_the_reader_knows() {
    let schema = schema();
    for (section, known) in keys::ALL {
        let part = if *section == "top" {
            &schema
        } else {
            &schema["$defs"][section]
        };
        let described: BTreeSet<&str> = part["properties"]
            .as_object()
            .unwrap_or_else(|| panic!("{section} is not described"))
            .keys()
            .map(String::as_str)
            .collect();
        let known: BTreeSet<&str> = known.iter().copied().collect();
        assert_eq!(described, known, "{section}");
        assert_eq!(
            part["additionalProperties"],
            Value::Bool(false),
            "{section}"
        );
    }
}

#[test]
fn every_entry_is_described_in_words() {
    let schema = schema();
    let parts = schema["$defs"].as_object().unwrap();
    for (name, part) in parts.iter().chain([(&"top".to_owned(), &schema)]) {
        let Some(properties) = part["properties"].as_object() else {
            continue;
        };
        for (key, entry) in properties {
            assert!(entry["description"].is_string(), "{name}.{key}");
        }
    }
}

#[test]
fn the_worked_designs_use_entries_of_the_schema_only() {
    // That they are read at all is the same fact; here the schema is the judge of the names.
    let schema = schema();
    let top = schema["properties"].as_object().unwrap();
    let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/../../designs");
    let mut seen = 0;
    for entry in std::fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        if path.extension().is_none_or(|e| e != "toml") {
            continue;
        }
        let table: toml::Table = toml::from_str(&std::fs::read_to_string(&path).unwrap()).unwrap();
        for key in table.keys() {
            assert!(top.contains_key(key), "{}: {key}", path.display());
        }
        seen += 1;
    }
    assert!(seen >= 7);
}
