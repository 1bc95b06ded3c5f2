//! Attributes of Rust: which leave what they stand at as it is.

use crate::grammar::{CodeNode, Read, Text, children, within};

/// Attributes that leave what is written as it is.
const ATTRIBUTES: [&str; 15] = [
    "allow",
    "cold",
    "deny",
    "deprecated",
    "doc",
    "expect",
    "forbid",
    "inline",
    "must_use",
    "no_mangle",
    "no_std",
    "rustfmt::skip",
    "track_caller",
    "unsafe",
    "warn",
];

/// Fails for an attribute that may leave out or change what it stands at.
pub(super) fn attribute(text: Text<'_>, node: CodeNode<'_>) -> Read<()> {
    let inside = children(node).first().copied().unwrap_or(node);
    let words = text.text(inside);
    let name = words.split(['(', '=', ' ', '[']).next().unwrap_or(words);
    if ATTRIBUTES.contains(&name) || name.starts_with("clippy::") {
        return Ok(());
    }
    let message = format!("the attribute `{name}` may leave this out or change it");
    Err(text.refused(node, message, "leave the attribute out"))
}

/// Fails for such an attribute within a node.
pub(super) fn attributes(text: Text<'_>, node: CodeNode<'_>) -> Read<()> {
    let is_attribute =
        |node: &CodeNode<'_>| matches!(node.kind(), "attribute_item" | "inner_attribute_item");
    let mut all = within(node).filter(is_attribute);
    all.try_for_each(|node| attribute(text, node))
}
