//! The page for a browser.

use crate::paper;
use crate::support::{HTML, page};
use torse_report::{Manuscript, Source, html_page, landing_page, model::Report};

#[test]
fn the_page_has_an_anchor_and_filter_attributes_for_every_claim() {
    let report = Report::new(&paper::sample(), &paper::figures());
    assert_eq!(report.claims().count(), paper::sample().claims.len());
    for claim in report.claims() {
        let article = format!("<article id=\"{}\"", claim.anchor);
        assert_eq!(HTML.matches(&article).count(), 1, "{article}");
        let (_, after) = HTML.split_once(&article).unwrap();
        let (tag, _) = after.split_once('>').unwrap();
        assert!(
            tag.contains(&format!("data-verdict=\"{}\"", claim.verdict.key)),
            "{tag}"
        );
        assert!(
            tag.contains(&format!("data-kind=\"{}\"", claim.kind.key)),
            "{tag}"
        );
        assert!(
            tag.contains("data-evidence=\"") && tag.contains("data-section=\"section-"),
            "{tag}"
        );
    }
}

#[test]
fn every_link_of_the_page_leads_to_an_anchor_of_it() {
    let mut links = 0;
    for after in HTML.split("href=\"#").skip(1) {
        let (anchor, _) = after.split_once('"').unwrap();
        assert!(HTML.contains(&format!("id=\"{anchor}\"")), "{anchor}");
        links += 1;
    }
    assert!(links > 20, "{links}");
}

#[test]
fn the_page_shows_hostile_strings_as_text_and_asks_for_nothing_from_elsewhere() {
    assert!(!HTML.contains("<script>alert"));
    assert!(HTML.contains("&lt;/article&gt;&lt;script&gt;alert(1)&lt;/script&gt; &amp;"));
    assert!(!HTML.contains('\u{202E}') && !HTML.contains('\u{0}'));
    assert_eq!(
        HTML.matches("url(").count(),
        HTML.matches("url(data:font/woff2;").count()
    );
    for source in ["src=\"http", "href=\"http", "@import"] {
        assert!(!HTML.contains(source), "{source}");
    }
}

#[test]
fn the_page_shows_formulas_as_mathml_and_what_cannot_be_read_as_code() {
    let formula = "<mi>κ</mi>";
    assert!(HTML.contains(formula) || HTML.contains("<mi>x</mi>"));
    // The statement, which is no formula, in the claim and in the list of what it is about.
    assert!(HTML.contains("<code class=\"plain\">#panic(1)"));
}

#[test]
fn page_letter_and_landing_page_say_what_they_were_made_from() {
    let digest = "0123456789abcdef".repeat(4);
    let source = Source::new("sample", Some("10.1000/<1>"), &digest);
    let report = Report::new(&paper::sample(), &[]).from_source(source);
    let page = html_page(&report, &[]).unwrap();
    let landing = landing_page(std::slice::from_ref(&report)).unwrap();
    for text in [&page, &landing] {
        let link = "<a href=\"https://doi.org/10.1000/&lt;1&gt;\">doi:10.1000/&lt;1&gt;</a>";
        assert!(text.contains(link));
        assert!(text.contains(env!("CARGO_PKG_VERSION")));
    }
    assert!(page.contains(&digest) && page.contains("cat derivations/sample/*.toml | sha256sum"));
    assert!(landing.contains("<code>0123456789ab</code>"));
    assert!(page.contains("href=\"sample-erratum.pdf\"") && page.contains("href=\"sample.pdf\""));
    Manuscript::paper(&report, &[])
        .unwrap()
        .typeset()
        .unwrap()
        .pdf()
        .unwrap();
}

#[test]
fn the_page_has_the_same_bytes_on_every_run() {
    assert!(*HTML == page(&paper::sample(), &paper::figures()).unwrap());
}
