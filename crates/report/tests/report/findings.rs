//! What was found, and what a reader is told first.

use crate::paper;
use crate::support::{HTML, short};
use torse_prove::evidence::Witness;
use torse_report::{applicability::Usability, in_words, model::Report};

#[test]
fn findings_tell_the_refuted_first_and_leave_out_what_holds() {
    let report = Report::new(&paper::sample(), &[]);
    let told: Vec<(&str, String)> = report
        .findings
        .iter()
        .map(|finding| (finding.id.as_str(), in_words(&finding.text)))
        .collect();
    assert_eq!(
        told[0],
        (
            "sample/thm-4.det",
            "det(H) is 1/12 at n = 2, and not 0; the difference is 0.0833."
                .replace("; the difference is 0.0833", "")
        )
    );
    assert_eq!(
        told[1],
        (
            "sample/eq-3.7",
            "Correction, proved: the factor 2 added before μ; k replaced by k − 2.".to_owned()
        )
    );
    assert_eq!(told[2].1, "True if α₁ ≠ 0 and μ + ν + 2 ≠ 0.");
    assert!(!told.iter().any(|(id, _)| *id == "sample/thm-2.b"));
}

#[test]
fn findings_quote_the_beginning_of_what_is_printed_and_leave_long_points_to_the_claim() {
    let mut sample = short();
    sample.claims.truncate(1);
    let claim = &mut sample.claims[0];
    claim.claim.printed = "word ".repeat(100);
    claim.finding = paper::refuted(Some(Witness {
        at: (0..40)
            .map(|n| (format!("b[{n}]"), "0".to_owned()))
            .collect(),
        left: "1".to_owned(),
        right: "2".to_owned(),
        left_decimal: "1".to_owned(),
        right_decimal: "2".to_owned(),
    }));
    let finding = Report::new(&sample, &[]).findings.remove(0);
    assert_eq!(
        in_words(&finding.text),
        "g₀,₂(x) is 1 at the counterexample, and (1 − s)(1 − μs) is 2."
    );
    let printed = in_words(&finding.printed);
    assert!(printed.ends_with("word …") && printed.chars().count() <= 302);
}

/// The findings about one claim over a symbol x in [0, 1], decided by the engine.
fn finding_about(states: &str) -> Result<String, Box<dyn std::error::Error>> {
    let folder = tempfile::tempdir()?;
    let paper = folder.path().join("mini");
    std::fs::create_dir(&paper)?;
    let head = "[paper]\nid = \"mini\"\ntitle = \"T\"\nauthors = \"A\"\nvenue = \"V\"\nclaims = [\"claims.toml\"]\n\n\
                [symbols]\nx = { in = \"[0, 1]\" }\n";
    std::fs::write(paper.join("paper.toml"), head)?;
    let claim = format!(
        "[[claim]]\nid = \"mini/a\"\nat = \"Sect. 1\"\nkind = \"identity\"\nprinted = \"p\"\nstates = '{states}'\n"
    );
    std::fs::write(paper.join("claims.toml"), claim)?;
    let papers = torse_syntax::derivation::load(folder.path())?;
    let outcome = torse_verdicts::engine::run(&papers[0], &|| ())?;
    Ok(in_words(
        &Report::new(&outcome, &[]).findings.remove(0).text,
    ))
}

#[test]
fn findings_name_the_relation_that_fails_and_by_how_much() {
    for (states, told) in [
        (
            "fails((x + 1)^2 == x^2 + 2*x + 1)",
            "(x + 1)² = x² + 2x + 1 everywhere.",
        ),
        (
            "fails(x == x and 2*x == x + x)",
            "x = x and 2x = x + x everywhere.",
        ),
        (
            "(x + 1)^2 != x^2 + 2*x + 1",
            "(x + 1)² is 4 at x = 1, and so is x² + 2x + 1.",
        ),
        ("x > 0", "x is 0, which is not greater than 0."),
        ("x < 1/2 and x >= 0", "x is 1, which is not less than 1/2."),
        (
            "D(x^2, x) > 3",
            "d/(dx)x² is 2 at x = 1, which is not greater than 3.",
        ),
        (
            "sqrt(2) == 1.5",
            "√2 is 1.414213562373…, and not 1.5; the difference is 0.08579.",
        ),
    ] {
        let found = finding_about(states).unwrap();
        assert!(!found.contains("both sides"), "{found}");
        assert_eq!(found, told, "{states}");
    }
}

#[test]
fn the_first_page_tells_the_first_corrections_and_what_can_be_used() {
    let sample = paper::sample();
    let report = Report::new(&sample, &[]);
    let points: Vec<(String, &str)> = (report.short.points.iter())
        .map(|point| (in_words(&point.heading), point.consequence.as_str()))
        .collect();
    // A theorem comes first.
    assert_eq!(
        points,
        [
            ("Sect. 3.2, Theorem 4".to_owned(), ""),
            (
                "Sect. 2.2, eq. (3.7), second line".to_owned(),
                "The one statement that depends on it is false too."
            )
        ]
    );
    assert_eq!(
        report.short.counts,
        "Of 14 statements, 3 hold as printed, one holds under a condition that is not printed, one is false and has a small correction that is proved, one is false and 2 were not decided. The other 6: 1 definition, 1 figure that the printed data give, 1 figure that needs further data, 1 without the data that a decision needs, 1 with hypotheses that exclude each other and 1 that no computation can decide."
    );
    let answers: Vec<(&str, Usability)> = (report.constructions.iter())
        .map(|of| (of.name.as_str(), of.answer))
        .collect();
    assert_eq!(
        answers,
        [
            ("Theorem 2", Usability::AsPrinted),
            ("Theorem 4", Usability::Not),
            ("Equation (5)", Usability::UnderCondition),
            ("Example 2", Usability::AsPrinted),
            ("Theorem 3", Usability::Open),
        ]
    );
    assert!(HTML.find("In short").unwrap() < HTML.find("Every claim").unwrap());
}
