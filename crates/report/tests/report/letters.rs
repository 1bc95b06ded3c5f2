//! Letters of corrections.

use crate::paper;
use torse_report::{
    Envelope, Manuscript, Source, erratum_latex, erratum_markdown, html_page, in_words,
    model::Report,
};
use torse_syntax::derivation::LetterPart;
use torse_syntax::taxonomy::Verdict;
use torse_verdicts::outcome::{FaultChange, PaperFault};

fn draft() -> Envelope {
    Envelope::default()
}

fn pdf(report: &Report, envelope: &Envelope) -> Vec<u8> {
    let manuscript = Manuscript::erratum(report, envelope).unwrap();
    manuscript.typeset().unwrap().pdf().unwrap()
}

#[test]
fn a_letter_leaves_no_refuted_statement_out_and_asks_about_slips_of_the_copy() {
    let mut sample = paper::sample();
    let whole = erratum_markdown(&Report::new(&sample, &[]), &draft());
    assert!(whole.contains("We propose 2 corrections"), "{whole}");
    assert!(whole.contains("Theorem 4") && whole.contains("eq. (3.7)"));
    assert!(whole.contains("@misc{torse-sample"));
    for outcome in &mut sample.claims {
        if outcome.claim.id == "sample/eq-3.7" {
            outcome.claim.garbled = Some("f for g".to_owned());
        }
    }
    let report = Report::new(&sample, &[]);
    let (letter, tex) = (
        erratum_markdown(&report, &draft()),
        erratum_latex(&report, &draft()),
    );
    let (corrections, questions) = letter
        .split_once("## Please compare with the printed page")
        .unwrap();
    assert!(
        corrections.contains("We propose one correction") && !corrections.contains("eq. (3.7)")
    );
    assert!(questions.contains("eq. (3.7)"));
    assert!(
        tex.contains("\\item \\textbf{Sect. 3.2, Theorem 4.}")
            && tex.ends_with("\\end{document}\n")
    );
    sample
        .claims
        .retain(|claim| claim.verdict() == Verdict::Holds);
    let report = Report::new(&sample, &[]);
    let none = erratum_markdown(&report, &draft());
    assert!(none.contains("None was found to be false"));
    assert!(pdf(&report, &draft()).starts_with(b"%PDF-1."));
    assert!(pdf(&report, &draft()) == pdf(&report, &draft()));
}

#[test]
fn the_authors_are_addressed_and_a_letter_without_a_sender_is_a_draft() {
    let report = Report::new(&paper::sample(), &[]);
    let letter = erratum_markdown(&report, &draft());
    assert!(letter.contains("**Draft: no sender is named.**"));
    assert!(letter.contains("Dear "), "{letter}");
    assert!(erratum_latex(&report, &draft()).contains("\\markright{Draft: no sender is named}"));
    let sent = Envelope {
        sender: Some("A. Reader".to_owned()),
        date: Some("1 May 2026".to_owned()),
    };
    assert!(!letter.contains("doi:"));
    let report = report.from_source(Source::new("sample", Some("10.1000/1_2"), "00"));
    let letter = erratum_markdown(&report, &sent);
    assert!(letter.contains(", doi:10.1000/1"), "{letter}");
    assert!(letter.contains("doi:10.1000/1\\_2: "), "{letter}");
    assert!(pdf(&report, &sent).starts_with(b"%PDF-1."));
    assert!(!letter.contains("Draft"));
    assert!(letter.contains("From: A. Reader") && letter.contains("Date: 1 May 2026"));
    assert!(letter.contains("Yours sincerely,\n\nA. Reader"));
    let tex = erratum_latex(&report, &sent);
    assert!(tex.contains("\\markright{}") && !tex.contains("\\author"));
}

#[test]
fn a_fault_is_one_item_with_the_words_of_the_paper_and_what_changes_framed() {
    let mut sample = paper::sample();
    let shows = ["sample/thm-4.det", "sample/eq-3.7"].map(str::to_owned);
    let printed = "det(A) = k^4";
    sample.faults = vec![PaperFault {
        id: "sample/corrigendum.one".to_owned(),
        at: None,
        part: None,
        says: "the exponent is wrong".to_owned(),
        shows: shows.to_vec(),
        changes: vec![FaultChange {
            claim: "sample/thm-4.det".to_owned(),
            printed: printed.to_owned(),
            reads: "det(A) = k^3".to_owned(),
            remark: None,
        }],
    }];
    let letter = erratum_markdown(&Report::new(&sample, &[]), &draft());
    assert!(letter.contains("We propose one correction"), "{letter}");
    assert_eq!(letter.matches("\n### ").count(), 1);
    assert!(letter.contains("The exponent is wrong."));
    assert!(letter.contains("^{\\boxed{\\scriptstyle 4}}"), "{letter}");
    assert!(letter.contains("^{\\boxed{\\scriptstyle 3}}"), "{letter}");
    assert!(letter.contains("This also concerns: "), "{letter}");
}

/// What stands between two signs, wherever the first one is.
fn between<'a>(text: &'a str, open: &str, close: &str) -> Vec<&'a str> {
    let parts = text.split(open).skip(1);
    let parts = parts.filter_map(|part| Some(part.split_once(close)?.0));
    parts.collect()
}

#[test]
fn letter_report_and_first_page_have_the_same_faults_in_the_same_order() {
    let mut sample = paper::sample();
    for (outcome, number) in sample.claims.iter_mut().zip(10..) {
        outcome.finding = paper::refuted(None);
        outcome.claim.at = match number % 3 {
            0 => format!("Theorem {number}"),
            _ => format!("place {number}"),
        };
    }
    let refuted = sample.claims.iter().filter(|outcome| {
        let kind = outcome.claim.kind;
        kind != torse_syntax::taxonomy::Kind::Remark
    });
    let ids: Vec<String> = refuted.map(|outcome| outcome.claim.id.clone()).collect();
    let fault = |id: &str, shows: &[String]| PaperFault {
        id: format!("sample/corrigendum.{id}"),
        at: Some(format!("place of {id}")),
        part: None,
        says: format!("the fault {id}"),
        shows: shows.to_vec(),
        changes: vec![],
    };
    sample.faults = vec![fault("two", &ids[7..9]), fault("three", &ids[2..5])];
    let report = Report::new(&sample, &[]);
    let letter = erratum_markdown(&report, &draft());
    let told = between(&letter, "\n### ", "\n");
    let told = told.iter().map(|line| line.split_once(". ").unwrap().1);
    let told: Vec<&str> = told.collect();
    assert_eq!(told.len(), ids.len() - 3);
    let page = html_page(&report, &[]).unwrap();
    let listed = between(&page, "<li id=\"correction-", "</li>");
    let listed = listed
        .iter()
        .map(|one| between(one, "<strong>", "</strong>")[0]);
    assert_eq!(listed.collect::<Vec<&str>>(), told);
    let points = report.short.points.iter();
    let points: Vec<String> = points.map(|point| in_words(&point.heading)).collect();
    assert_eq!(points, told[..5]);
    assert_eq!(
        report.short.rest.as_deref(),
        Some(format!("{} more corrections are proposed.", told.len() - 5).as_str())
    );
    // A fault says in which statements it shows.
    let sizes = report.corrections.iter().map(|fault| fault.shows.len());
    assert_eq!(sizes.sum::<usize>(), ids.len());
    assert!(pdf(&report, &draft()).starts_with(b"%PDF-1."));
    let document = Manuscript::paper(&report, &[]).unwrap().typeset().unwrap();
    assert!(document.pdf().unwrap().starts_with(b"%PDF-1."));
}

#[test]
fn hostile_strings_do_not_act_in_a_letter() {
    let mut sample = paper::sample();
    sample.title = paper::HOSTILE.to_owned();
    for outcome in &mut sample.claims {
        outcome.finding = paper::refuted(None);
        outcome.claim.at = paper::HOSTILE.to_owned();
        outcome.claim.printed = paper::HOSTILE.to_owned();
        outcome.claim.author_note = Some(paper::HOSTILE.to_owned());
    }
    let hostile = Envelope {
        sender: Some(paper::HOSTILE.to_owned()),
        date: Some(paper::HOSTILE.to_owned()),
    };
    let report = Report::new(&sample, &[]);
    let (letter, tex) = (
        erratum_markdown(&report, &hostile),
        erratum_latex(&report, &hostile),
    );
    // The entry of the bibliography is code in a block of its own, on one line.
    let (text, entry) = letter.split_once("```bibtex").unwrap();
    assert!(!text.contains("<script>"), "{text}");
    assert_eq!(entry.matches("```").count(), 1);
    assert!(!letter.contains("\n#panic"), "{letter}");
    assert!(!tex.contains(" # ") && !tex.contains(" & "));
    pdf(&report, &hostile);
}

#[test]
fn a_fault_is_listed_where_the_files_say_and_those_that_concern_most_statements_come_first() {
    let mut sample = paper::sample();
    let with = |verdicts: &[Verdict]| -> Vec<String> {
        let claims = sample.claims.iter();
        let with = claims.filter(|outcome| verdicts.contains(&outcome.verdict()));
        with.map(|outcome| outcome.claim.id.clone()).collect()
    };
    let refuted = with(&[Verdict::False, Verdict::Misprint]);
    let limited = with(&[Verdict::Conditional, Verdict::Depends, Verdict::OutOfScope]);
    let (rare, common) = (&refuted[..1], [&refuted[1..2], &limited[..1]].concat());
    let fault = |id: &str, part, shows: &[String]| PaperFault {
        id: format!("sample/corrigendum.{id}"),
        at: Some(format!("place of {id}")),
        part,
        says: format!("the fault {id}"),
        shows: shows.to_vec(),
        changes: vec![],
    };
    sample.faults = vec![fault("rare", None, rare), fault("common", None, &common)];
    for outcome in &mut sample.claims {
        outcome.claim.at = outcome.claim.at.replace("Theorem", "Section");
    }
    let letter = erratum_markdown(&Report::new(&sample, &[]), &draft());
    let place = |text: &str| {
        letter
            .find(text)
            .unwrap_or_else(|| panic!("{text}: {letter}"))
    };
    assert!(
        place("place of common") < place("place of rare"),
        "{letter}"
    );
    assert!(!letter.contains("state more exactly"), "{letter}");
    sample.faults[1].part = Some(LetterPart::Condition);
    let letter = erratum_markdown(&Report::new(&sample, &[]), &draft());
    let (corrections, conditions) = letter
        .split_once("## What the text should state more exactly")
        .unwrap();
    assert!(corrections.contains("place of rare") && conditions.contains("place of common"));
}
