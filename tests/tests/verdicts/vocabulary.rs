//! The words of the reports: those of the glossary, and none that says a remark of ours were printed.

use super::glossary::ruled_out;
use super::letters::{RESTORED, words_of};
use torse_report::model::Report;
use torse_report::{Envelope, erratum_markdown, findings_in_words, html_page};

/// What a reader sees of a page: its text, without styles, scripts and marks.
fn text_of(page: &str) -> String {
    let mut text = String::new();
    for (number, part) in page.split('<').enumerate() {
        let (mark, words) = match number {
            0 => ("", part),
            _ => part.split_once('>').unwrap_or((part, "")),
        };
        if !mark.starts_with("style") && !mark.starts_with("script") {
            text.push_str(words);
            text.push(' ');
        }
    }
    text
}

/// The words that are ruled out and stand in a text all the same.
fn found(text: &str) -> Vec<&'static str> {
    let words = ruled_out().into_iter();
    words.filter(|word| text.contains(word)).collect()
}

#[test]
fn no_report_page_or_letter_uses_a_word_that_the_glossary_rules_out() {
    assert_eq!(text_of("<style>a</style>b <i title=\"c\">d</i>"), " b  d  ");
    assert_eq!(found("an edit that would repair it"), ["repair"]);
    for paper in RESTORED.iter() {
        let report = Report::new(paper, &[]);
        let mut words = vec![];
        words_of(&serde_json::to_value(&report).unwrap(), &mut words);
        words.push(text_of(&html_page(&report, &[]).unwrap()));
        words.push(erratum_markdown(&report, &Envelope::default()));
        words.extend(findings_in_words(paper).into_iter().map(|(_, text)| text));
        for text in words {
            assert_eq!(found(&text), [""; 0], "{}: {text}", paper.slug);
        }
    }
}

#[test]
fn a_remark_of_ours_is_labelled_so_and_everything_else_is_printed() {
    let mut remarks = 0;
    for paper in RESTORED.iter() {
        let report = Report::new(paper, &[]);
        let page = html_page(&report, &[]).unwrap();
        let mut ours = 0;
        for claim in report.claims() {
            let is_remark = claim.kind.key == "remark";
            assert_eq!(claim.words_of == "ours", is_remark, "{}", claim.id);
            assert_eq!(claim.words_of == "printed", !is_remark, "{}", claim.id);
            let start = format!("<article id=\"{}\"", claim.anchor);
            let entry = page
                .split(&start)
                .last()
                .unwrap()
                .split("</article>")
                .next()
                .unwrap();
            let labelled = entry.contains("<span class=\"whose\">ours</span>");
            assert_eq!(labelled, is_remark, "{}: {entry}", claim.id);
            ours += usize::from(is_remark);
        }
        remarks += ours;
    }
    assert!(remarks > 100, "{remarks}");
}
