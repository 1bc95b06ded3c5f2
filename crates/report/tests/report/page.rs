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

/// The words of a page, without its tags, its style, its scripts and its formulas.
fn words(page: &str) -> String {
    let mut text = page.to_owned();
    for hidden in ["style", "script", "math", "code"] {
        let (open, close) = (format!("<{hidden}"), format!("</{hidden}>"));
        let parts = text.split(&open).enumerate();
        let shown = parts.map(|(number, part)| match number {
            0 => part,
            _ => part.split_once(&close).map_or("", |(_, after)| after),
        });
        text = shown.collect();
    }
    let shown = text
        .split('<')
        .map(|part| part.split_once('>').map_or(part, |(_, text)| text));
    shown.collect::<Vec<_>>().join(" ")
}

#[test]
fn pages_and_letters_use_the_words_of_the_glossary() {
    let glossary = concat!(env!("CARGO_MANIFEST_DIR"), "/../../docs/glossary.md");
    let glossary = std::fs::read_to_string(glossary).unwrap();
    let cells = glossary
        .lines()
        .filter_map(|line| line.strip_suffix('|')?.rsplit('|').next());
    let ruled_out: Vec<&str> = cells
        .flat_map(|cell| cell.split('`').skip(1).step_by(2))
        .collect();
    assert!(ruled_out.len() > 6, "{ruled_out:?}");
    let report = Report::new(&paper::sample(), &paper::figures());
    let landing = landing_page(std::slice::from_ref(&report)).unwrap();
    let letter = torse_report::erratum_markdown(&report, &torse_report::Envelope::default());
    let scripts = concat!(env!("CARGO_MANIFEST_DIR"), "/assets");
    let script = |name: &str| std::fs::read_to_string(format!("{scripts}/{name}")).unwrap();
    let strings = script("moving.js") + &script("torse/torse.js");
    for page in [words(&HTML), words(&landing), letter, strings] {
        assert!(page.len() > 500, "{page}");
        for word in &ruled_out {
            assert!(!page.contains(word), "{word}");
        }
    }
}

#[test]
fn the_page_shows_statement_and_finding_of_a_claim_in_the_list_and_leads_to_its_other_forms() {
    let report = Report::new(&paper::sample(), &paper::figures());
    let lists = HTML.split("<summary>").skip(1);
    let lists: Vec<&str> = lists
        .map(|rest| rest.split("</summary>").next().unwrap())
        .collect();
    let stated = lists
        .iter()
        .filter(|list| list.contains("class=\"statement\""))
        .count();
    assert_eq!(stated, report.claims().count());
    let found = lists
        .iter()
        .filter(|list| list.contains("class=\"finding\""))
        .count();
    assert_eq!(found, report.findings.len());
    let slug = &report.slug;
    for file in [
        format!("{slug}.pdf"),
        format!("{slug}-erratum.pdf"),
        "index.html".to_owned(),
    ] {
        assert!(HTML.contains(&format!("href=\"{file}\"")), "{file}");
    }
    let landing = landing_page(std::slice::from_ref(&report)).unwrap();
    let picture = report.picture.unwrap().file;
    assert!(
        landing.contains(&format!("<img src=\"{picture}\"")),
        "{picture}"
    );
}
