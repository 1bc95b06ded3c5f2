//! Letters of corrections.

use crate::paper;
use torse_report::{Manuscript, erratum_latex, erratum_markdown, model::Report};
use torse_syntax::words::Verdict;

#[test]
fn a_letter_holds_what_is_false_in_every_reading_and_no_slip_of_the_copy() {
    let mut sample = paper::sample();
    let whole = erratum_markdown(&Report::new(&sample, &[]));
    assert!(whole.contains("2 statements of this paper are false"));
    assert!(whole.contains("Theorem 4") && whole.contains("eq. (3.7)"));
    assert!(whole.contains("@misc{torse-sample"));
    for claim in &mut sample.claims {
        if claim.id == "sample/eq-3.7" {
            claim.garbled = Some("f for g".to_owned());
        }
    }
    let report = Report::new(&sample, &[]);
    let (letter, tex) = (erratum_markdown(&report), erratum_latex(&report));
    assert!(letter.contains("One statement") && !letter.contains("eq. (3.7)"));
    assert!(
        tex.contains("\\item \\textbf{Sect. 3.2, Theorem 4.}")
            && tex.ends_with("\\end{document}\n")
    );
    sample
        .claims
        .retain(|claim| claim.verdict == Verdict::Holds);
    let report = Report::new(&sample, &[]);
    let none = erratum_markdown(&report);
    assert!(none.contains("No statement of this paper was found to be false as printed"));
    let pdf = Manuscript::erratum(&report)
        .unwrap()
        .typeset()
        .unwrap()
        .pdf()
        .unwrap();
    assert!(pdf.starts_with(b"%PDF-1."));
    assert!(
        pdf == Manuscript::erratum(&report)
            .unwrap()
            .typeset()
            .unwrap()
            .pdf()
            .unwrap()
    );
}

#[test]
fn hostile_strings_do_not_act_in_a_letter() {
    let mut sample = paper::sample();
    sample.title = paper::HOSTILE.to_owned();
    for claim in &mut sample.claims {
        claim.verdict = Verdict::False;
        claim.at = paper::HOSTILE.to_owned();
        claim.printed = paper::HOSTILE.to_owned();
        claim.finding = Some(paper::HOSTILE.to_owned());
    }
    let report = Report::new(&sample, &[]);
    let (letter, tex) = (erratum_markdown(&report), erratum_latex(&report));
    // The entry of the bibliography is code in a block of its own, on one line.
    let (text, entry) = letter.split_once("```bibtex").unwrap();
    assert!(!text.contains("<script>"), "{text}");
    assert_eq!(entry.matches("```").count(), 1);
    assert!(!letter.contains("\n#panic"), "{letter}");
    assert!(!tex.contains(" # ") && !tex.contains(" & "));
    Manuscript::erratum(&report)
        .unwrap()
        .typeset()
        .unwrap()
        .pdf()
        .unwrap();
}
