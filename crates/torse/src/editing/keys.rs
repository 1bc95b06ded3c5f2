//! The keys of derivation files, from their schema.

use serde_json::Value;
use std::sync::LazyLock;
use torse_syntax::derivation::schema::DERIVATION_SCHEMA;

static SCHEMA: LazyLock<Value> =
    LazyLock::new(|| serde_json::from_str(DERIVATION_SCHEMA).unwrap_or_default());

/// Keys whose texts are words, names or LaTeX; all other texts are formulas.
const PROSE: [&str; 34] = [
    "id",
    "title",
    "authors",
    "venue",
    "doi",
    "claims",
    "at",
    "kind",
    "printed",
    "printed_in",
    "ours",
    "part_of",
    "reading",
    "garbled",
    "latex",
    "underspecified",
    "out_of_scope",
    "unstated",
    "uses",
    "expect",
    "finding",
    "note",
    "says",
    "name",
    "flag",
    "quote",
    "file",
    "function",
    "side",
    "caption",
    "alt",
    "label",
    "text",
    "part",
];

/// Keys whose texts are ids of claims.
const IDS: [&str; 4] = ["uses", "part_of", "printed_in", "claims"];

/// What a text is.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum TextKind {
    /// A formula.
    Formula,
    /// The id of a claim.
    Id,
    /// Anything else.
    Words,
}

/// Returns what the text at the end of this path is.
pub fn text_kind(path: &[String]) -> TextKind {
    let names: Vec<&str> = path.iter().map(String::as_str).collect();
    let declares = names.contains(&"symbols");
    match names.as_slice() {
        // The files of a paper, and whether a figure may be drawn at a point.
        ["paper", ..] | ["display", ..] | [_, "display", ..] => TextKind::Words,
        [.., "in"] if !declares => TextKind::Id,
        // Names of definitions and symbols may be those of keys.
        [.., "let" | "define" | "set", _] => TextKind::Formula,
        [.., last] if IDS.contains(last) => TextKind::Id,
        ["corrigendum", ..] => TextKind::Words,
        ["figure", ..] | [_, "figure", ..] => match names.last() {
            Some(last) if PROSE.contains(last) && *last != "at" => TextKind::Words,
            _ => TextKind::Formula,
        },
        [.., last] if PROSE.contains(last) => TextKind::Words,
        [] => TextKind::Words,
        _ => TextKind::Formula,
    }
}

/// Returns the keys that may stand below a path, with what each says.
pub fn keys(path: &[String]) -> Vec<(&'static str, &'static str)> {
    let Some(node) = node(&SCHEMA, path) else {
        return vec![];
    };
    let properties = branches(node).find_map(|node| node.get("properties")?.as_object());
    let described = properties.into_iter().flatten().map(|(key, value)| {
        let own = value.get("description");
        let referred = || resolved(value).get("description");
        (
            key.as_str(),
            own.or_else(referred).and_then(Value::as_str).unwrap_or(""),
        )
    });
    described.collect()
}

/// Returns the words that may stand as the value at a path; none where any text may.
pub fn words(path: &[String]) -> Vec<&'static str> {
    let Some(node) = node(&SCHEMA, path) else {
        return vec![];
    };
    let words = branches(node).find_map(|node| node.get("enum")?.as_array());
    let words = words.into_iter().flatten();
    words.filter_map(Value::as_str).collect()
}

/// Returns what the schema says of the key at the end of a path.
pub fn description(path: &[String]) -> Option<&'static str> {
    let (key, above) = path.split_last()?;
    let found = keys(above).into_iter().find(|(known, _)| known == key);
    found.map(|(_, says)| says).filter(|says| !says.is_empty())
}

/// The schema that a reference stands for.
fn resolved(node: &'static Value) -> &'static Value {
    let name = node.get("$ref").and_then(Value::as_str);
    let name = name.and_then(|name| name.strip_prefix("#/$defs/"));
    let found = name.and_then(|name| SCHEMA.get("$defs")?.get(name));
    found.unwrap_or(node)
}

/// What a value may be: the schema, its alternatives, and the items of a list.
fn branches(node: &'static Value) -> impl Iterator<Item = &'static Value> {
    let node = resolved(node);
    let choices = node.get("anyOf").and_then(Value::as_array);
    let choices = choices.into_iter().flatten().map(resolved);
    let all = std::iter::once(node).chain(choices);
    all.flat_map(|node| std::iter::once(node).chain(node.get("items").map(resolved)))
        .flat_map(|node| {
            let choices = node.get("anyOf").and_then(Value::as_array);
            std::iter::once(node).chain(choices.into_iter().flatten().map(resolved))
        })
}

/// The schema of what stands at a path.
fn node(root: &'static Value, path: &[String]) -> Option<&'static Value> {
    path.iter().try_fold(root, |node, key| {
        branches(node).find_map(|node| {
            let named = node.get("properties").and_then(|all| all.get(key));
            let any = node.get("additionalProperties");
            named.or(any.filter(|any| any.is_object()))
        })
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn path(text: &str) -> Vec<String> {
        text.split('/')
            .filter(|key| !key.is_empty())
            .map(str::to_owned)
            .collect()
    }

    fn names(text: &str) -> Vec<&'static str> {
        keys(&path(text)).into_iter().map(|(key, _)| key).collect()
    }

    #[test]
    fn the_keys_below_a_path_are_those_of_the_schema() {
        assert!(names("").contains(&"claim") && names("").contains(&"symbols"));
        assert!(names("claim").contains(&"states") && names("claim").contains(&"part_of"));
        assert!(names("claim/symbols/x").contains(&"integer"));
        assert!(names("symbols/x").contains(&"in"));
        assert!(names("claim/assume").contains(&"printed"));
        assert!(names("claim/readings").contains(&"says"));
        assert!(names("basis/f").contains(&"seeds"));
        assert_eq!(names("claim/states"), [""; 0]);
        assert_eq!(names("nothing/x"), [""; 0]);
        assert!(words(&path("claim/kind")).contains(&"identity"));
        assert!(words(&path("claim/expect")).contains(&"misprint"));
        assert_eq!(words(&path("claim/states")), [""; 0]);
        assert_eq!(
            description(&path("claim/printed")),
            Some("The statement as printed, verbatim.")
        );
    }

    #[test]
    fn every_key_of_words_is_a_key_of_the_schema() {
        fn collect(node: &'static Value, found: &mut Vec<&'static str>) {
            let properties = node.get("properties").and_then(Value::as_object);
            found.extend(
                properties
                    .into_iter()
                    .flatten()
                    .map(|(key, _)| key.as_str()),
            );
            let below = node
                .as_object()
                .into_iter()
                .flatten()
                .map(|(_, value)| value);
            let items = node.as_array().into_iter().flatten();
            below.chain(items).for_each(|value| collect(value, found));
        }
        let mut known = vec![];
        collect(&SCHEMA, &mut known);
        let strange = PROSE.iter().chain(&IDS).filter(|key| !known.contains(key));
        assert_eq!(strange.collect::<Vec<_>>(), [&""; 0]);
    }

    #[test]
    fn a_text_is_a_formula_unless_its_key_says_words() {
        for (text, wanted) in [
            ("claim/states", TextKind::Formula),
            ("claim/assume", TextKind::Formula),
            ("claim/assume/in", TextKind::Id),
            ("claim/symbols/x/in", TextKind::Formula),
            ("symbols/x/in", TextKind::Formula),
            ("claim/printed", TextKind::Words),
            ("claim/let/kind", TextKind::Formula),
            ("define/F(z)", TextKind::Formula),
            ("claim/uses", TextKind::Id),
            ("paper/title", TextKind::Words),
            ("claim/display/mu", TextKind::Words),
            ("basis/f/seeds", TextKind::Formula),
        ] {
            assert_eq!(text_kind(&path(text)), wanted, "{text}");
        }
    }
}
