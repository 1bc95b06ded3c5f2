//! Claims among each other: what rests on what, counts, links.

use crate::paper;
use crate::support::short;
use torse_prove::evidence::Evidence;
use torse_report::{in_words, model::Report};
use torse_syntax::taxonomy::Kind;

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
    assert!(
        sample
            .claims
            .iter()
            .any(|outcome| outcome.claim.kind == Kind::Figure)
    );
    assert_eq!(Report::new(&sample, &[]).unexpected, 1);
}

#[test]
fn claims_whose_ids_differ_in_signs_only_keep_anchors_apart() {
    let mut sample = short();
    let names = ["sample/a.b", "sample/a-b", "sample/a_b"];
    sample.claims.truncate(names.len());
    for (claim, name) in sample.claims.iter_mut().zip(names) {
        claim.claim.id = name.to_owned();
    }
    let report = Report::new(&sample, &[]);
    let mut anchors: Vec<&str> = report.claims().map(|claim| claim.anchor.as_str()).collect();
    anchors.sort_unstable();
    anchors.dedup();
    assert_eq!(anchors.len(), names.len());
}

#[test]
fn what_rests_on_a_refuted_claim_is_listed_with_its_fate() {
    let mut sample = paper::sample();
    let first = sample
        .claims
        .iter_mut()
        .find(|outcome| outcome.claim.id == "sample/def-1.g0")
        .unwrap();
    first.finding = paper::refuted(None);
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
            ("thm-2.b", "survives: still true as printed".to_owned()),
            ("eq-3.7", "survives with a correction of its own".to_owned())
        ]
    );
    assert!(claim.used_by.is_empty());
}

#[test]
fn distant_survivors_of_a_refuted_claim_are_counted_and_not_listed() {
    let mut sample = paper::sample();
    for outcome in &mut sample.claims {
        outcome.claim.uses = match outcome.claim.id.as_str() {
            "sample/thm-2.b" => vec!["sample/def-1.g0".to_owned()],
            "sample/eq-3.7" => vec!["sample/thm-2.b".to_owned()],
            _ => Vec::new(),
        };
        outcome.finding = match outcome.claim.id.as_str() {
            "sample/def-1.g0" => paper::refuted(None),
            _ => paper::proved(Evidence::Identity, vec![], vec![]),
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
        Some("one more depends on it indirectly, and survives")
    );
}
