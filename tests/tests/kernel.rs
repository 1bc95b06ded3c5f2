//! The kernel judges the engine: changed statements that the engine refutes, with the proofs of the statements that they
//! were, are rejected. Some minutes: `cargo test -p torse-tests --test kernel -- --ignored --nocapture`.

#![allow(clippy::unwrap_used, clippy::print_stderr, reason = "tests")]

use std::collections::{BTreeMap, BTreeSet};
use std::path::Path;
use std::time::Duration;
use torse_prove::evidence::Evidence;
use torse_rocq::accepted::Accepted;
use torse_rocq::coqc::{Coqc, Limits};
use torse_rocq::folder::Folder;
use torse_rocq::script_search;
use torse_rocq::task::ProofTask;
use torse_syntax::derivation::{Claim, load};
use torse_syntax::taxonomy::Verdict;
use torse_verdicts::engine::decide_claim;
use torse_verdicts::mutants::refuted;

/// So many changed statements are put to the kernel.
const WANTED: usize = 200;
/// The most of one claim.
const MAX: usize = 4;
/// The longest time for one script, in seconds: the proofs of the statements as they were take less.
const SECONDS: u64 = 10;

/// A claim that holds, as a theorem of its own.
fn proof_task<'a>(id: String, claim: &'a Claim, evidence: Evidence) -> ProofTask<'a> {
    ProofTask {
        id,
        claim,
        verdict: Verdict::Holds,
        evidence: Some(evidence),
        conditions: vec![],
        correction: None,
        witness: vec![],
        solved: vec![],
    }
}

#[test]
#[ignore = "minutes of coqc"]
fn the_proofs_of_true_statements_do_not_prove_what_the_engine_refutes() {
    let Ok(coqc) = Coqc::find() else {
        eprintln!("notice: coqc is not installed, the kernel was not asked");
        return;
    };
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("..");
    let accepted = Accepted::read(&root.join("proofs")).unwrap().theorems;
    let mut changed: Vec<(String, Claim, Evidence)> = vec![];
    for paper in load(&root.join("derivations")).unwrap() {
        let slug = &paper.head.id;
        for claim in &paper.claims {
            if changed.len() >= WANTED {
                break;
            }
            let id = claim.entry.id.get_ref();
            // The name of the theorem, without a verdict: most claims have no accepted proof.
            let alone = proof_task(id.clone(), claim, Evidence::Identity);
            let folder = Folder::new(&[(slug.clone(), vec![alone])], &BTreeMap::new());
            let mut proved = folder.theorems.iter().filter(|t| t.rests_on.is_none());
            if folder.theorems.is_empty() || !proved.all(|t| accepted.contains_key(&t.name())) {
                continue;
            }
            let Ok(outcome) = decide_claim(slug, claim) else {
                continue;
            };
            // Of these two kinds, the proofs are the same for every statement.
            let evidence = outcome.evidence();
            let Some(evidence @ (Evidence::Identity | Evidence::Induction)) = evidence else {
                continue;
            };
            if outcome.verdict() != Verdict::Holds {
                continue;
            }
            for (place, (claim, _)) in refuted(claim, MAX).enumerate() {
                changed.push((format!("{id}.changed{place}"), claim, evidence));
            }
        }
    }
    changed.truncate(WANTED);
    let findings = changed
        .iter()
        .map(|(id, claim, evidence)| proof_task(id.clone(), claim, *evidence))
        .collect();
    let folder = Folder::new(&[("changed".to_owned(), findings)], &BTreeMap::new());
    let limits = Limits {
        time: Duration::from_secs(600),
        memory: 4_000_000,
        at_once: 1,
    };
    let scratch = tempfile::tempdir().unwrap();
    coqc.library(scratch.path(), limits, &|| ()).unwrap();
    let failing =
        script_search::failing(&coqc, &folder, scratch.path(), SECONDS, limits, &|_, _| ())
            .unwrap();
    let proved = folder.theorems.iter().filter(|t| t.rests_on.is_none());
    let stated: BTreeSet<String> = proved.map(|t| t.name()).collect();
    // That no values meet the premises says nothing of the proof.
    let rejected = |name: &&String| {
        failing
            .get(*name)
            .is_some_and(|why| why.contains("no proof"))
    };
    let proved: Vec<&String> = stated.iter().filter(|name| !rejected(name)).collect();
    eprintln!(
        "{} changed statements, {} of them stated, {} rejected",
        changed.len(),
        stated.len(),
        stated.len() - proved.len()
    );
    assert!(proved.is_empty(), "{proved:#?}");
    assert!(stated.len() >= WANTED * 9 / 10, "{}", stated.len());
}
