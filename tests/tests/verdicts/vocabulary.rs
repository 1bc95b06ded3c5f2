//! The words of the reports: those of the glossary, and none that says a remark of ours were printed.

use super::glossary::ruled_out;
use super::letters::{RESTORED, words_of};
use std::sync::LazyLock;
use torse_report::model::Report;
use torse_report::{Envelope, erratum_markdown, findings_in_words, html_page};

/// The reports of the papers and their pages.
static REPORTS: LazyLock<Vec<(Report, String)>> = LazyLock::new(|| {
    let reports = RESTORED.iter().map(|paper| Report::new(paper, &[]));
    let pages = reports.map(|report| {
        let page = html_page(&report, &[]).unwrap();
        (report, page)
    });
    pages.collect()
});

/// What a reader sees of a page: its text, without styles, scripts and marks.
fn text_of(page: &str) -> String {
    let mut page = page.to_owned();
    for (from, to) in [("<style", "</style>"), ("<script", "</script>"), ("<", ">")] {
        let parts = page.split(from).enumerate();
        let kept = parts.map(|(number, part)| match number {
            0 => part,
            _ => part.split_once(to).map_or("", |(_, rest)| rest),
        });
        page = kept.collect::<Vec<_>>().join(" ");
    }
    page
}

/// The words that are ruled out and stand in a text all the same.
fn found(text: &str) -> Vec<&'static str> {
    let words = ruled_out().into_iter();
    words.filter(|word| text.contains(word)).collect()
}

#[test]
fn no_report_page_or_letter_uses_a_word_that_the_glossary_rules_out() {
    let page = "<style>a</style>b <i title=\"c\">d</i><script>e < f</script>";
    assert_eq!(text_of(page).trim(), "b  d");
    assert_eq!(found("an edit that would repair it"), ["repair"]);
    for (paper, (report, page)) in RESTORED.iter().zip(REPORTS.iter()) {
        let mut words = vec![];
        words_of(&serde_json::to_value(report).unwrap(), &mut words);
        words.push(text_of(page));
        words.push(erratum_markdown(report, &Envelope::default()));
        words.extend(findings_in_words(paper).into_values());
        for text in words {
            assert_eq!(found(&text), [""; 0], "{}: {text}", paper.slug);
        }
    }
}

#[test]
fn a_remark_of_ours_is_labelled_so_and_everything_else_is_printed() {
    let mut remarks = 0;
    for (report, page) in REPORTS.iter() {
        let mut ours = 0;
        for claim in report.claims() {
            let is_remark = claim.kind.key == "remark";
            assert_eq!(claim.words_of == "ours", is_remark, "{}", claim.id);
            assert_eq!(claim.words_of == "printed", !is_remark, "{}", claim.id);
            let start = format!("<article id=\"{}\"", claim.anchor);
            let (_, entry) = page.split_once(&start).unwrap();
            let (entry, _) = entry.split_once("</article>").unwrap();
            let labelled = entry.contains("<span class=\"whose\">ours</span>");
            assert_eq!(labelled, is_remark, "{}: {entry}", claim.id);
            ours += usize::from(is_remark);
        }
        remarks += ours;
    }
    assert!(remarks > 100, "{remarks}");
}
