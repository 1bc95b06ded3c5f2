//! Tests that Typst accepts the output of `torse derive`.

#![allow(clippy::unwrap_used, reason = "helpers of tests")]

#[path = "../../../tests/support/derived.rs"]
mod cases;

use crate::world::MemoryWorld;
use torse_verdicts::derive::{Language, print};
use typst_layout::PagedDocument;

#[test]
fn every_derivation_is_typeset_as_it_is_written_for_typst() {
    for (name, derivation) in cases::derived() {
        let text = print(&derivation, Language::Typst);
        let world = MemoryWorld::new(&text, &[], []).unwrap();
        let document = world.compile::<PagedDocument>("a derivation");
        let refused = document.err();
        assert!(refused.is_none(), "{name}: {refused:?}\n{text}");
    }
}

#[test]
fn what_is_no_typst_is_refused() {
    let world = MemoryWorld::new("$ unknownword $", &[], []).unwrap();
    assert!(world.compile::<PagedDocument>("a derivation").is_err());
}
