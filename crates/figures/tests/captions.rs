//! Captions name what is drawn: a word for a mark stands in a caption only where a layer draws that mark.

#![allow(clippy::unwrap_used, reason = "tests")]

use std::path::Path;
use torse_figures::figure::drawing::{Drawing, Layer};
use torse_figures::plates;
use torse_syntax::derivation::load;
use torse_syntax::derivation::schema::figure::{Marker, Shape};

/// Whether a layer draws something.
type Draws = fn(&Layer) -> bool;

/// Words for marks, and what draws them. Other words speak of the mathematics, not of the picture.
const MARKS: [(&str, Draws); 15] = [
    ("at the ring", |of| {
        of.shape == Shape::Points && of.style.marker == Some(Marker::Ring)
    }),
    ("dot", is_point),
    ("dots", is_point),
    ("marked points", is_point),
    ("arrow", |of| of.shape == Shape::Arrows),
    ("arrows", |of| of.shape == Shape::Arrows),
    ("bar", never),
    ("bars", never),
    ("control net", |of| {
        matches!(of.shape, Shape::Net | Shape::Polygon)
    }),
    ("control polygon", |of| of.shape == Shape::Polygon),
    ("control polygons", |of| of.shape == Shape::Polygon),
    ("tangent planes", |of| {
        matches!(of.shape, Shape::Plane | Shape::Surface) && of.style.opacity.is_some()
    }),
    ("translucent", |of| {
        matches!(of.shape, Shape::Plane | Shape::Surface)
    }),
    ("thin lines", |of| of.shape == Shape::Segments),
    ("coloured by", |of| of.shade.is_some()),
];

fn is_point(layer: &Layer) -> bool {
    layer.shape == Shape::Points
}

fn never(_: &Layer) -> bool {
    false
}

/// The words of a sentence, in small letters, with one blank around each.
fn words(text: &str) -> String {
    let plain = text.to_lowercase();
    let words: Vec<&str> = plain.split(|c: char| !c.is_alphanumeric()).collect();
    format!(" {} ", words.join(" "))
}

/// Words for marks that no layer draws.
fn undrawn(drawing: &Drawing) -> Vec<&'static str> {
    let said = words(&drawing.caption) + &words(&drawing.alt);
    let layers = || drawing.panels.iter().flat_map(|panel| &panel.layers);
    let missing = MARKS
        .iter()
        .filter(|(word, draws)| said.contains(&format!(" {word} ")) && !layers().any(draws));
    missing.map(|(word, _)| *word).collect()
}

fn drawings() -> Vec<Drawing> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../derivations");
    let papers = load(&folder).unwrap();
    let plates = papers.iter().flat_map(|paper| plates(paper).unwrap());
    plates.map(|plate| plate.drawing().clone()).collect()
}

#[test]
fn captions_and_descriptions_name_no_mark_that_is_not_drawn() {
    let all = drawings();
    for drawing in &all {
        assert_eq!(undrawn(drawing), [""; 0], "{}", drawing.id);
    }
    // The words are in use, so that the test sees something.
    let said: String = all
        .iter()
        .map(|of| words(&of.caption) + &words(&of.alt))
        .collect();
    let used = MARKS
        .iter()
        .filter(|(word, _)| said.contains(&format!(" {word} ")));
    assert!(used.count() >= 7);
}

#[test]
fn a_caption_that_names_bars_over_curves_is_seen() {
    let mut drawing = drawings()
        .into_iter()
        .find(|of| of.id == "gbt-developable/fig-9")
        .unwrap();
    assert_eq!(undrawn(&drawing), [""; 0]);
    drawing
        .caption
        .push_str(" The ends of the bars are marked by arrows.");
    assert_eq!(undrawn(&drawing), ["arrows", "bars"]);
}

#[test]
fn what_ends_a_sheet_is_named_in_the_legend_of_every_enveloping_developable() {
    let ends: Vec<Drawing> = drawings()
        .into_iter()
        .filter(|of| {
            ["6", "7", "8"]
                .iter()
                .any(|n| of.id == format!("gbt-developable/fig-{n}"))
        })
        .collect();
    assert_eq!(ends.len(), 3);
    for drawing in ends {
        let panel = drawing.panels.first().unwrap();
        for end in ["ruling $x = 0$", "ruling $x = 1$"] {
            let marked = panel
                .layers
                .iter()
                .any(|of| of.shape == Shape::Segments && of.label == end);
            assert!(marked, "{}: {end}", drawing.id);
        }
    }
}

#[test]
fn no_two_figures_draw_the_same() {
    let mut seen: Vec<(String, String)> = Vec::new();
    for drawing in drawings() {
        let panels = format!("{:?}", drawing.panels);
        if let Some((id, _)) = seen.iter().find(|(_, before)| *before == panels) {
            unreachable!("{} draws what {id} draws", drawing.id);
        }
        seen.push((drawing.id, panels));
    }
}
