//! Texts that are no formulas: every one is refused or read, none is a panic, and none takes long.

use proptest::prelude::*;
use torse_syntax::formula::Place;
use torse_syntax::latex::{LatexGuess, LatexKind, LatexNames, layout, read_items, read_latex};

fn names() -> LatexNames {
    let mut names = LatexNames::default();
    for name in ["x", "y", "n", "t", "i"] {
        names.declare(name, LatexKind::Number);
    }
    names.declare(
        "f",
        LatexKind::Function {
            parameters: vec!["t".to_owned()],
            is_vector: false,
        },
    );
    names.declare("v", LatexKind::Vector);
    names.declare(
        "P",
        LatexKind::Family {
            indices: 1,
            is_vector: true,
        },
    );
    names
}

const PARTS: [&str; 44] = [
    "x",
    "y",
    "n",
    "t",
    "f",
    "v",
    "P",
    "1",
    "2.5",
    "+",
    "-",
    "=",
    "^",
    "_",
    "{",
    "}",
    "(",
    ")",
    "[",
    "]",
    "|",
    "'",
    "/",
    ",",
    " ",
    "\\frac",
    "\\sin",
    "\\sum_{i=0}^n",
    "\\int_0^1",
    "dx",
    "\\cdot",
    "\\times",
    "\\left(",
    "\\right)",
    "\\|",
    "\\sqrt",
    "\\begin{pmatrix}",
    "\\end{pmatrix}",
    "&",
    "\\\\",
    "\\le",
    "\\in",
    "\\ldots",
    "\\text{ and }",
];

proptest! {
    #[test]
    fn any_text_is_read_or_refused(text in ".{0,200}") {
        let _ = read_latex(&text, &names());
    }

    #[test]
    fn any_sequence_of_parts_is_read_or_refused(parts in prop::collection::vec(prop::sample::select(&PARTS[..]), 0..60)) {
        let text = parts.join(" ");
        let read = read_latex(&text, &names());
        if let Err(error) = &read {
            prop_assert!(error.place.start <= text.len());
        }
        if let Ok(items) = layout(&text) {
            let mut guess = LatexGuess::default();
            guess.add(&items);
            let _ = read_items(&items, Place::default(), &guess.names());
        }
    }
}

#[test]
fn deep_and_long_texts_are_refused_in_a_moment() {
    for (part, count) in [
        ("(", 100_000),
        ("{", 100_000),
        ("x^{", 50_000),
        ("-", 100_000),
        ("\\sin", 20_000),
        ("\\frac", 50_000),
        ("|", 100_001),
        ("\\|", 10_001),
        ("x", 100_000),
        ("x+", 100_000),
        ("\\sum_{i=0}^n", 5_000),
        ("\\frac{d}{dt}", 5_000),
        ("f(", 20_000),
        ("\\left(", 20_000),
        ("\\begin{pmatrix}", 5_000),
        ("\\sqrt", 50_000),
        ("x/", 50_000),
        ("'", 100_000),
        ("\\not", 10_000),
    ] {
        assert!(read_latex(&part.repeat(count), &names()).is_err(), "{part}");
        let closed = format!("{}x{}", part.repeat(30), ")".repeat(30));
        let _ = read_latex(&closed, &names());
    }
}
