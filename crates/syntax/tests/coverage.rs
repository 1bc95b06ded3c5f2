//! The page of what can be stated names claims that there are, with the verdicts that they are to get.

#![allow(clippy::unwrap_used, reason = "helpers of tests")]

use std::collections::BTreeMap;
use std::path::Path;
use torse_syntax::derivation::load;
use torse_syntax::taxonomy::Verdict;

#[test]
fn every_claim_of_the_page_of_coverage_is_there_with_its_verdict() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../derivations");
    let papers = load(&folder).unwrap();
    let claims = papers.iter().flat_map(|paper| &paper.claims);
    let expected: BTreeMap<&str, Option<Verdict>> = claims
        .map(|claim| (claim.entry.id.get_ref().as_str(), claim.entry.expect))
        .collect();
    let page = std::fs::read_to_string(folder.join("COVERAGE.md")).unwrap();
    let mut named = 0;
    for line in page.lines().filter(|line| line.starts_with("| ")) {
        let conditional = line.contains("(`conditional`)");
        let wanted = match conditional {
            true => Verdict::Conditional,
            false => Verdict::Holds,
        };
        // Between backticks is every second piece.
        for id in line.split('`').skip(1).step_by(2) {
            let folder = id.split('/').next().unwrap_or_default();
            let is_id = papers.iter().any(|paper| paper.head.id == folder) && id.contains('/');
            if is_id {
                assert_eq!(expected.get(id), Some(&Some(wanted)), "{id}");
                named += 1;
            }
        }
    }
    assert!(named > 30, "{named}");
}
