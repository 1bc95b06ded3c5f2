//! Mathematics is set, and never shown as it is typed.

use crate::paper;
use crate::support::{HTML, unpacked};
use torse_report::{
    Envelope, Prose, Span, erratum_latex, erratum_markdown, html_page, model::Report,
};

/// The words of a report, which are no formulas: sentences, places and titles.
fn words(report: &Report) -> String {
    fn walk(value: &serde_json::Value, out: &mut String) {
        match value {
            serde_json::Value::Object(members) => {
                if members.get("kind").is_some_and(|kind| kind == "words") {
                    out.push_str(members["value"].as_str().unwrap_or_default());
                    out.push('\n');
                }
                for (name, member) in members {
                    let formula = matches!(name.as_str(), "typst" | "breaks" | "math");
                    // The notation of a formula is shown where it has no mathematics.
                    let notation =
                        name == "text" && members.get("math").is_some_and(|math| !math.is_null());
                    if !formula && !notation {
                        walk(member, out);
                    }
                }
            }
            serde_json::Value::Array(items) => items.iter().for_each(|item| walk(item, out)),
            serde_json::Value::String(text) => {
                out.push_str(text);
                out.push('\n');
            }
            _ => {}
        }
    }
    let mut out = String::new();
    walk(&serde_json::to_value(report).unwrap_or_default(), &mut out);
    out
}

/// The first typed mathematics in a text: `mu1`, `x^2`, `Q_{k}`.
fn typed(text: &str) -> Option<&str> {
    const NAMES: [&str; 6] = ["mu", "nu", "pi", "sqrt", "lambda", "gamma"];
    let around = |at: usize| {
        text.get(at.saturating_sub(20)..at + 20)
            .unwrap_or("at a letter of two bytes")
    };
    if let Some(at) = text.find('^').or_else(|| text.find("_{")) {
        return Some(around(at));
    }
    text.split(|c: char| !c.is_alphanumeric()).find(|word| {
        let stem = word.trim_end_matches(|c: char| c.is_ascii_digit());
        NAMES.contains(&stem)
    })
}

#[test]
fn no_typed_mathematics_is_in_the_words_of_a_report_of_the_worked_example() {
    let folder = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("../../derivations/bezier");
    let alone = tempfile::tempdir().unwrap();
    let copy = alone.path().join("bezier");
    std::fs::create_dir(&copy).unwrap();
    for file in std::fs::read_dir(folder).unwrap().flatten() {
        std::fs::copy(file.path(), copy.join(file.file_name())).unwrap();
    }
    let papers = torse_syntax::derivation::load(alone.path()).unwrap();
    let outcome = torse_verdicts::engine::run(&papers[0], &|| ()).unwrap();
    let report = Report::new(&outcome, &[]);
    assert!(report.corrections.len() > 3);
    // One sentence names functions of the language.
    let names = "The examples of sum, binom, factorial, sqrt, sin and cos.";
    let words = words(&report).replace(names, "");
    assert!(words.len() > 2_000);
    assert_eq!(typed(&words), None);
    let page = unpacked(&html_page(&report, &[]).unwrap());
    assert_eq!(typed(&text_of(&page).replace(names, "")), None);
    let letter = erratum_markdown(&report, &Envelope::default());
    let outside: String = letter.split('`').step_by(2).collect();
    assert_eq!(typed(&outside), None);
    let letter = erratum_latex(&report, &Envelope::default());
    assert!(letter.contains("\n\\[\n") && !letter.contains("pi/2"));
}

/// What a reader sees of a page besides formulas and code.
fn text_of(page: &str) -> String {
    let mut out = String::new();
    let body = page.split_once("<main>").map_or(page, |(_, body)| body);
    let body = body.split_once("<script>").map_or(body, |(body, _)| body);
    let mut rest = body;
    let mut hidden = 0;
    while let Some((text, tag)) = rest.split_once('<') {
        if hidden == 0 {
            out.push_str(text);
            out.push(' ');
        }
        let (name, after) = tag.split_once('>').unwrap_or((tag, ""));
        match name.split(' ').next().unwrap_or_default() {
            "math" | "code" => hidden += 1,
            "/math" | "/code" => hidden -= 1,
            _ => {}
        }
        rest = after;
    }
    out
}

#[test]
fn typed_mathematics_is_seen_where_it_is() {
    for text in ["the factor mu1 is", "x^2", "Q_{k}", "sqrt of"] {
        assert!(typed(text).is_some(), "{text}");
    }
    assert_eq!(typed("a number, a municipality and Q_k"), None);
}

#[test]
fn a_correction_marks_what_went_and_what_came() {
    let report = Report::new(&paper::sample(), &[]);
    let claim = report
        .claims()
        .find(|claim| claim.correction.is_some())
        .unwrap();
    let correction = claim.correction.as_ref().unwrap();
    let printed = correction.printed.as_ref().unwrap().math.as_ref().unwrap();
    let statement = correction.statement.math.as_ref().unwrap();
    assert!(printed.typst.contains("removed(") && !printed.typst.contains("added("));
    assert!(statement.typst.contains("added(") && !statement.typst.contains("removed("));
    assert!(HTML.contains("<mrow class=\"removed\">") && HTML.contains("<mrow class=\"added\">"));
}

#[test]
fn sentences_keep_their_words_and_formulas_apart() {
    let report = Report::new(&paper::sample(), &[]);
    let claim = report
        .claims()
        .find(|claim| claim.name == "thm-2.b")
        .unwrap();
    let kinds = |prose: &Prose| -> Vec<bool> {
        prose
            .iter()
            .map(|span| matches!(span, Span::Math(_)))
            .collect()
    };
    assert_eq!(kinds(&claim.printed), [true]);
    assert_eq!(kinds(&claim.steps[0]), [false]);
}
