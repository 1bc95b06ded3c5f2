//! The outputs as a reader gets them, from a made-up paper with every verdict and hostile strings.

#![allow(clippy::unwrap_used, reason = "helpers of tests")]

#[path = "../examples/sample/paper.rs"]
mod paper;

use std::sync::LazyLock;
use torse_language::words::{Kind, Verdict};
use torse_prove::evidence::Witness;
use torse_report::{
    FigureImage, Image, Prose, ReportError, Span, Typeset, erratum_latex, erratum_markdown,
    gallery, html_page, in_words, model::Report, usable::Answer, verdicts_json,
};
use torse_verdicts::outcome::PaperOutcome;

static HTML: LazyLock<String> = LazyLock::new(|| {
    page(&paper::sample(), &paper::figures()).unwrap_or_else(|error| error.to_string())
});

fn page(paper: &PaperOutcome, figures: &[FigureImage]) -> Result<String, ReportError> {
    html_page(&Report::new(paper, figures), figures).map(|page| unpacked(&page))
}

/// The page with all claims filled, as its script does it.
fn unpacked(page: &str) -> String {
    let (before, rest) = page.split_once("id=\"packed\">").unwrap();
    let (packed, after) = rest.split_once('<').unwrap();
    let list = miniz_oxide::inflate::decompress_to_vec(&decoded(packed)).unwrap();
    let list: Vec<String> = serde_json::from_slice(&list).unwrap();
    let mut filled = String::new();
    let mut parts = before.split("</details></article>");
    for inside in list {
        filled.push_str(parts.next().unwrap());
        filled.push_str(&inside);
        filled.push_str("</details></article>");
    }
    filled.extend(parts);
    format!("{filled}id=\"packed\"><{after}")
}

/// The bytes of a text in base 64.
fn decoded(text: &str) -> Vec<u8> {
    const DIGITS: &str = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    let (mut bits, mut count, mut bytes) = (0_u32, 0, vec![]);
    for digit in text.trim_end_matches('=').chars() {
        bits = bits << 6 | u32::try_from(DIGITS.find(digit).unwrap()).unwrap();
        count += 6;
        if count >= 8 {
            count -= 8;
            bytes.push((bits >> count) as u8);
        }
    }
    bytes
}

fn typeset(paper: &PaperOutcome, figures: &[FigureImage]) -> Result<Typeset, ReportError> {
    Typeset::paper(&Report::new(paper, figures), figures)
}

fn summary(papers: &[PaperOutcome]) -> Result<Typeset, ReportError> {
    let reports: Vec<Report> = papers.iter().map(|paper| Report::new(paper, &[])).collect();
    Typeset::summary(&reports)
}

/// The sample without the claims that take long to lay out.
fn short() -> PaperOutcome {
    let mut sample = paper::sample();
    sample
        .claims
        .retain(|claim| claim.id != "sample/thm-4.det" && claim.id != "sample/eq-3.7");
    sample
}

#[test]
fn the_json_of_a_claim_has_its_fields_in_order_and_null_where_there_is_nothing() {
    let text = verdicts_json(&paper::sample().claims[3..5]).unwrap();
    assert_eq!(
        text,
        r#"{
  "claims": [
    {
      "id": "sample/thm-4.det",
      "kind": "identity",
      "verdict": "false",
      "evidence": "witness",
      "part_of": null,
      "printed": "det H = 0 for every n",
      "reading": null,
      "garbled": null,
      "finding": null,
      "parsed": "det(H) == 0",
      "corrected": null,
      "corrected_condition": null,
      "condition": null,
      "witness": {
        "at": {
          "n": "2"
        },
        "left": "1/12",
        "right": "0",
        "left_decimal": "0.0833[3, 4]",
        "right_decimal": "0"
      },
      "note": null,
      "net": null,
      "replay": null,
      "contradiction": null,
      "hypotheses": [],
      "symbols": [],
      "definitions": [],
      "bases": [],
      "unknowns": [],
      "readings": []
    },
    {
      "id": "sample/eq-5.third",
      "kind": "construction",
      "verdict": "conditional",
      "evidence": "identity",
      "part_of": null,
      "printed": "Q¹_1 = Q_m + (1/α₁)(Q_m − Q_{m−1})",
      "reading": null,
      "garbled": null,
      "finding": null,
      "parsed": "Q1 == Q[m] + ...",
      "corrected": null,
      "corrected_condition": null,
      "condition": "alpha_1 != 0 and mu + nu + 2 != 0",
      "witness": null,
      "note": null,
      "net": null,
      "replay": null,
      "contradiction": null,
      "hypotheses": [],
      "symbols": [],
      "definitions": [],
      "bases": [],
      "unknowns": [],
      "readings": []
    }
  ],
  "totals": {
    "claims": 2,
    "verdicts": {
      "conditional": 1,
      "false": 1
    },
    "remarks": {
      "total": 0,
      "proved": 0
    }
  }
}
"#
    );
}

#[test]
fn the_json_keeps_the_order_of_the_file_and_of_the_witness_and_any_string() {
    let sample = paper::sample();
    let text = verdicts_json(&sample.claims).unwrap();
    let value: serde_json::Value = serde_json::from_str(&text).unwrap();
    let claims = value["claims"].as_array().unwrap();
    let ids: Vec<&str> = claims
        .iter()
        .map(|claim| claim["id"].as_str().unwrap())
        .collect();
    let expected: Vec<&str> = sample
        .claims
        .iter()
        .map(|claim| claim.id.as_str())
        .collect();
    assert_eq!(ids, expected);
    assert_eq!(claims[5]["printed"], paper::HOSTILE);
    let place = |name: &str| text.find(&format!("\"{name}\": ")).unwrap();
    assert!(place("k") < place("mu") && place("mu") < place("nu"));
}

#[test]
fn the_pdf_is_pdf_a_2b_and_has_the_same_bytes_on_every_run() {
    let document = typeset(&short(), &paper::figures()).unwrap();
    let first = document.pdf().unwrap();
    let second = typeset(&short(), &paper::figures()).unwrap().pdf().unwrap();
    assert!(first.starts_with(b"%PDF-1."));
    assert!(first == second, "two runs gave different bytes");
    let contains = |text: &[u8]| first.windows(text.len()).any(|window| window == text);
    assert!(contains(b"<pdfaid:part>2</") && contains(b"<pdfaid:conformance>B</"));
}

#[test]
fn formulas_that_cannot_be_set_and_hostile_strings_do_not_keep_a_report_from_being_written() {
    let mut sample = short();
    sample
        .claims
        .retain(|claim| claim.printed == paper::HOSTILE);
    assert_eq!(sample.claims.len(), 1);
    sample.title = paper::HOSTILE.to_owned();
    sample.slug = paper::HOSTILE.to_owned();
    typeset(&sample, &[]).unwrap().pdf().unwrap();
    summary(&[sample]).unwrap().pdf().unwrap();
}

#[test]
fn a_paper_without_claims_and_a_summary_without_papers_are_documents_too() {
    let empty = PaperOutcome {
        claims: Vec::new(),
        ..paper::sample()
    };
    typeset(&empty, &[]).unwrap().pdf().unwrap();
    summary(&[]).unwrap().pdf().unwrap();
    assert!(page(&empty, &[]).unwrap().contains("</html>"));
}

#[test]
fn a_picture_that_is_none_is_an_error_that_names_the_document() {
    let broken = FigureImage {
        name: "broken".to_owned(),
        caption: String::new(),
        alt: String::new(),
        image: Image::Png(b"no picture".to_vec()),
        claims: Vec::new(),
        verdict: Verdict::Reproduced,
        assumes: Vec::new(),
        stand_in: Vec::new(),
        interactive: None,
        torse: None,
    };
    let error = typeset(&short(), &[broken]).unwrap_err();
    assert!(
        matches!(
            error,
            ReportError::Typeset {
                document: "the report of a paper",
                ..
            }
        ),
        "{error}"
    );
}

#[test]
fn pages_are_drawn_as_png_within_bounds_only() {
    let document = summary(&[short()]).unwrap();
    assert!(document.page_png(0, 0.5).unwrap().starts_with(b"\x89PNG"));
    let pages = document.page_count();
    assert!(matches!(
        document.page_png(pages, 1.0),
        Err(ReportError::NoSuchPage { .. })
    ));
    for resolution in [0.0, -1.0, f32::NAN, f32::INFINITY, 21.0] {
        assert!(matches!(
            document.page_png(0, resolution),
            Err(ReportError::Resolution { .. })
        ));
    }
}

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
fn the_page_has_the_same_bytes_on_every_run() {
    assert!(*HTML == page(&paper::sample(), &paper::figures()).unwrap());
}

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
            "False as printed. It is proved with this change: the factor 2 added before μ; k replaced by k − 2.".to_owned()
        )
    );
    assert_eq!(told[2].1, "True only if α₁ ≠ 0 and μ + ν + 2 ≠ 0.");
    assert!(!told.iter().any(|(id, _)| *id == "sample/thm-2.b"));
}

#[test]
fn findings_quote_the_beginning_of_what_is_printed_and_leave_long_points_to_the_claim() {
    let mut sample = short();
    sample.claims.truncate(1);
    let claim = &mut sample.claims[0];
    claim.verdict = Verdict::False;
    claim.printed = "word ".repeat(100);
    claim.witness = Some(Witness {
        at: (0..40)
            .map(|n| (format!("b[{n}]"), "0".to_owned()))
            .collect(),
        left: "1".to_owned(),
        right: "2".to_owned(),
        left_decimal: "1".to_owned(),
        right_decimal: "2".to_owned(),
    });
    let finding = Report::new(&sample, &[]).findings.remove(0);
    assert_eq!(
        in_words(&finding.text),
        "g₀,₂(x) is 1 at the point stated with the claim, and (1 − s)(1 − μs) is 2."
    );
    let printed = in_words(&finding.printed);
    assert!(printed.ends_with("word …") && printed.chars().count() <= 302);
}

#[test]
fn a_claim_knows_what_rests_on_it_and_where_its_figures_are() {
    let report = Report::new(&paper::sample(), &paper::figures());
    let claim = |id: &str| report.claims().find(|claim| claim.id == id).unwrap();
    let users: Vec<&str> = claim("sample/def-1.g0")
        .used_by
        .iter()
        .map(|reference| reference.shown.as_str())
        .collect();
    assert_eq!(users, ["thm-2.b", "eq-3.7"]);
    assert_eq!(claim("sample/eq-3.7").uses[2].anchor, None);
    assert_eq!(
        claim("sample/fig-1").figures,
        [0],
        "shown at the first claim that it names"
    );
    assert_eq!(claim("sample/thm-2.b").see_figures, [0]);
    assert_eq!(report.further_figures, [2]);
}

#[test]
fn counts_add_up_on_both_axes() {
    let sample = paper::sample();
    let tally = Report::new(&sample, &[]).tally;
    assert_eq!(
        tally.rows.iter().map(|row| row.count).sum::<usize>(),
        sample.claims.len()
    );
    for row in &tally.rows {
        assert_eq!(
            row.by_evidence.iter().sum::<usize>() + row.without,
            row.count
        );
    }
    assert!(sample.claims.iter().any(|claim| claim.kind == Kind::Figure));
    assert_eq!(Report::new(&sample, &[]).unexpected, 1);
}

#[test]
fn claims_whose_ids_differ_in_signs_only_keep_anchors_apart() {
    let mut sample = short();
    let names = ["sample/a.b", "sample/a-b", "sample/a_b"];
    sample.claims.truncate(names.len());
    for (claim, name) in sample.claims.iter_mut().zip(names) {
        claim.id = name.to_owned();
    }
    let report = Report::new(&sample, &[]);
    let mut anchors: Vec<&str> = report.claims().map(|claim| claim.anchor.as_str()).collect();
    anchors.sort_unstable();
    anchors.dedup();
    assert_eq!(anchors.len(), names.len());
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
    let papers = torse_language::derivation::load(folder.path())?;
    let outcome = torse_verdicts::engine::run(&papers[0], &|| ())?;
    Ok(in_words(
        &Report::new(&outcome, &[]).findings.remove(0).text,
    ))
}

#[test]
fn findings_name_the_relation_that_fails_and_by_how_much() {
    for (states, told) in [
        (
            "not (x + 1)^2 == x^2 + 2*x + 1",
            "(x + 1)² = x² + 2x + 1 everywhere.",
        ),
        (
            "not (x == x and 2*x == x + x)",
            "x = x and 2x = x + x everywhere.",
        ),
        (
            "(x + 1)^2 != x^2 + 2*x + 1",
            "(x + 1)² is 4 at x = 1, and so is x² + 2x + 1.",
        ),
        ("x > 0", "x is 0 at x = 0, which is not greater than 0."),
        (
            "x < 1/2 and x >= 0",
            "x is 1 at x = 1, which is not less than 1/2.",
        ),
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
    let papers = torse_language::derivation::load(alone.path()).unwrap();
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
    let letter = erratum_markdown(&report);
    let outside: String = letter.split('`').step_by(2).collect();
    assert_eq!(typed(&outside), None);
    let letter = erratum_latex(&report);
    assert!(letter.contains("\\begin{multline*}") && !letter.contains("pi/2"));
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
fn the_first_page_tells_what_most_rests_on_first_and_what_can_be_used() {
    let sample = paper::sample();
    let report = Report::new(&sample, &[]);
    let points: Vec<&str> = (report.short.points.iter())
        .map(|point| point.finding.name.as_str())
        .collect();
    // On the misprint the false theorem rests, which is told with it.
    assert_eq!(points, ["eq-3.7"]);
    assert_eq!(
        report.short.points[0].consequence,
        "The one statement that rests on it is false too (Theorem 4)."
    );
    assert_eq!(
        report.short.counts,
        "Of 14 statements, 3 hold as printed, one holds under a condition that is not printed, one is false and has a small correction that is proved, one is false and 2 were not decided."
    );
    let answers: Vec<(&str, Answer)> = (report.constructions.iter())
        .map(|of| (of.name.as_str(), of.answer))
        .collect();
    assert_eq!(
        answers,
        [
            ("Theorem 2", Answer::AsPrinted),
            ("Theorem 4", Answer::Not),
            ("Equation (5)", Answer::UnderCondition),
            ("Example 2", Answer::AsPrinted),
            ("Theorem 3", Answer::Open),
        ]
    );
    assert!(HTML.find("In short").unwrap() < HTML.find("Every claim").unwrap());
}

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
    let pdf = Typeset::erratum(&report).unwrap().pdf().unwrap();
    assert!(pdf.starts_with(b"%PDF-1."));
    assert!(pdf == Typeset::erratum(&report).unwrap().pdf().unwrap());
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
    Typeset::erratum(&report).unwrap().pdf().unwrap();
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

#[test]
fn what_rests_on_a_refuted_claim_is_listed_with_its_fate() {
    let mut sample = paper::sample();
    let first = sample
        .claims
        .iter_mut()
        .find(|claim| claim.id == "sample/def-1.g0")
        .unwrap();
    first.verdict = Verdict::False;
    let report = Report::new(&sample, &[]);
    let claim = report
        .claims()
        .find(|claim| claim.id == "sample/def-1.g0")
        .unwrap();
    let fates: Vec<(&str, String)> = claim
        .consequences
        .iter()
        .map(|of| (of.claim.shown.as_str(), in_words(&of.fate)))
        .collect();
    assert_eq!(
        fates[..2],
        [
            (
                "thm-2.b",
                "survives: true as printed all the same".to_owned()
            ),
            ("eq-3.7", "survives with a correction of its own".to_owned())
        ]
    );
    assert!(claim.used_by.is_empty());
}

#[test]
fn distant_survivors_of_a_refuted_claim_are_counted_and_not_listed() {
    let mut sample = paper::sample();
    for claim in &mut sample.claims {
        claim.uses = match claim.id.as_str() {
            "sample/thm-2.b" => vec!["sample/def-1.g0".to_owned()],
            "sample/eq-3.7" => vec!["sample/thm-2.b".to_owned()],
            _ => Vec::new(),
        };
        claim.verdict = match claim.id.as_str() {
            "sample/def-1.g0" => Verdict::False,
            _ => Verdict::Holds,
        };
    }
    let report = Report::new(&sample, &[]);
    let claim = report
        .claims()
        .find(|claim| claim.id == "sample/def-1.g0")
        .unwrap();
    let listed: Vec<&str> = claim
        .consequences
        .iter()
        .map(|of| of.claim.shown.as_str())
        .collect();
    assert_eq!(listed, ["thm-2.b"]);
    assert_eq!(
        claim.distant_survivors.as_deref(),
        Some("through these one more rests on it, and survives")
    );
}

#[test]
fn figures_say_what_was_assumed_and_what_replaced_in_page_and_gallery() {
    let sample = paper::sample();
    let figures = paper::figures();
    let gallery = gallery(&[(&sample, &figures)]).unwrap();
    for (what, text) in [("page", HTML.as_str()), ("gallery", gallery.as_str())] {
        for verdict in ["reproduced", "partial", "underspecified"] {
            assert!(text.contains(verdict), "{what}: {verdict}");
        }
        assert!(
            text.contains("Assumed:") && text.contains("the view; the range of"),
            "{what}"
        );
        assert!(text.contains("Not printed, replaced by our own:"), "{what}");
        assert!(!text.contains("<script>alert"), "{what}");
    }
    for figure in &figures {
        let link = format!("<img src=\"figures/{}.png\" width=", figure.name);
        assert!(gallery.contains(&link), "{}", figure.name);
    }
}

#[test]
fn a_figure_with_sliders_carries_its_nets_as_json() {
    let start = "<script type=\"application/json\">";
    assert_eq!(HTML.matches(start).count(), 1);
    let (_, after) = HTML.split_once(start).unwrap();
    let (data, _) = after.split_once("</script>").unwrap();
    let data: serde_json::Value = serde_json::from_str(data).unwrap();
    let arch = paper::arch().unwrap();
    let parts = data["parts"].as_array().unwrap();
    assert_eq!(parts.len(), arch.parts().len());
    for (part, of) in parts.iter().zip(arch.parts()) {
        for (net, points) in part["nets"].as_array().unwrap().iter().zip(&of.nets) {
            let numbers: Vec<f64> = net
                .as_array()
                .unwrap()
                .iter()
                .map(|n| n.as_f64().unwrap())
                .collect();
            let close = numbers
                .iter()
                .zip(points.iter().flatten())
                .all(|(a, b)| (a - b).abs() < 1e-4);
            assert!(numbers.len() == 3 * points.len() && close);
        }
    }
}
