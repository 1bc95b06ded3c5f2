//! The claims of the papers, as a whole: complete, audited, reviewed as a diff when a verdict changes.

#![allow(clippy::unwrap_used, clippy::expect_used, reason = "helpers of tests")]

// One process decides the papers once, for both.
#[path = "../support/glossary.rs"]
mod glossary;
#[path = "verdicts/letters.rs"]
mod letters;
#[path = "../support/printed.rs"]
mod printed;
#[path = "verdicts/vocabulary.rs"]
mod vocabulary;
#[path = "verdicts/words.rs"]
mod words_of_corrections;

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use std::sync::LazyLock;
use torse_prove::Evidence;
use torse_syntax::derivation::{Claim, Paper, load};
use torse_syntax::taxonomy::{Kind, Verdict};
use torse_verdicts::Outcome;
use torse_verdicts::PaperOutcome;
use torse_verdicts::audit::audit;
use torse_verdicts::consequences::{Fate, consequences};
use torse_verdicts::words;

fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("..")
}

static LOADED: LazyLock<Vec<Paper>> =
    LazyLock::new(|| load(&root().join("derivations")).expect("the derivations load"));

static CLAIMS: LazyLock<Vec<&'static Claim>> =
    LazyLock::new(|| LOADED.iter().flat_map(|paper| &paper.claims).collect());

static PAPERS: LazyLock<Vec<PaperOutcome>> = LazyLock::new(|| {
    LOADED
        .iter()
        .map(|paper| torse_verdicts::engine::run(paper, &|| ()).expect("every formula makes sense"))
        .collect()
});

#[test]
fn every_statement_of_the_inventory_is_stated_and_nothing_else() {
    for slug in ["gbt-developable", "gbt-surfaces", "hermite-developable"] {
        let inventory =
            std::fs::read_to_string(root().join(format!("tests/inventory/{slug}.txt"))).unwrap();
        let mut wanted: Vec<&str> = inventory.lines().collect();
        let claims = CLAIMS.iter().filter(|c| c.entry.kind != Kind::Remark);
        let sentence =
            |c: &&'static Claim| c.sentence_id().unwrap_or(c.entry.id.get_ref()).as_str();
        let of_paper = claims.filter(|c| c.entry.id.get_ref().starts_with(slug));
        let mut found: Vec<&str> = of_paper.map(sentence).collect();
        wanted.sort_unstable();
        found.sort_unstable();
        found.dedup();
        assert_eq!(found, wanted, "{slug}");
    }
}

#[test]
fn every_verdict_is_the_expected_one() {
    let unexpected: Vec<String> = PAPERS
        .iter()
        .flat_map(|p| &p.claims)
        .filter(|c| !c.as_expected())
        .map(|c| {
            format!(
                "{}: expected {:?}, computed {:?}",
                c.claim.id,
                c.claim.expect,
                c.verdict()
            )
        })
        .collect();
    assert_eq!(unexpected, Vec::<String>::new());
}

#[test]
fn the_papers_are_pinned_by_the_snapshot_and_expect_nothing() {
    let ours = ["bezier", "hyperbolic", "splines", "torses", "trigonometric"];
    let papers = PAPERS
        .iter()
        .filter(|paper| !ours.contains(&paper.slug.as_str()));
    for outcome in papers.flat_map(|paper| &paper.claims) {
        assert_eq!(outcome.claim.expect, None, "{}", outcome.claim.id);
    }
}

#[test]
fn no_flag_of_the_audit_is_open_and_every_answer_answers_one() {
    let outcomes = PAPERS.iter().flat_map(|paper| &paper.claims);
    let pairs: Vec<(&Claim, &Outcome)> = CLAIMS.iter().copied().zip(outcomes).collect();
    let mut found = vec![];
    for audited in audit(&LOADED, &pairs, || ()) {
        let id = audited.claim.entry.id.get_ref();
        found.extend(
            audited
                .open
                .iter()
                .map(|raised| format!("{id}: {}", raised.evidence)),
        );
        let stale = audited.stale.iter();
        found.extend(stale.map(|answer| format!("{id}: an answer to no {:?}", answer.flag)));
    }
    assert_eq!(found, Vec::<String>::new());
}

#[test]
fn at_most_eight_per_cent_of_the_statements_stay_open() {
    let statements: Vec<_> = PAPERS
        .iter()
        .flat_map(|p| &p.claims)
        .filter(|c| c.claim.kind != Kind::Figure)
        .collect();
    let open = statements
        .iter()
        .filter(|c| matches!(c.verdict(), Verdict::Undecided | Verdict::OutOfScope))
        .count();
    assert!(
        open * 100 <= statements.len() * 8,
        "{open} of {}",
        statements.len()
    );
}

#[test]
fn what_holds_rests_on_a_proof_and_what_is_refuted_shows_a_witness() {
    for outcome in PAPERS.iter().flat_map(|p| &p.claims) {
        match outcome.verdict() {
            Verdict::Holds | Verdict::Conditional => assert!(
                matches!(
                    outcome.evidence(),
                    Some(
                        Evidence::Identity
                            | Evidence::Induction
                            | Evidence::Inequality
                            | Evidence::Enclosure
                            | Evidence::Witness
                    )
                ),
                "{}",
                outcome.claim.id
            ),
            Verdict::Misprint => {
                assert!(
                    outcome.witness().is_some() && outcome.correction().is_some(),
                    "{}",
                    outcome.claim.id
                );
            }
            Verdict::False => assert!(outcome.witness().is_some(), "{}", outcome.claim.id),
            Verdict::Undecided | Verdict::OutOfScope | Verdict::Underspecified => {
                assert!(
                    !words::steps(outcome).is_empty(),
                    "{} says no reason",
                    outcome.claim.id
                );
            }
            _ => {}
        }
    }
}

#[test]
fn an_example_survives_a_wrong_theorem_where_its_wrong_term_vanishes() {
    let outcomes: Vec<&Outcome> = PAPERS.iter().flat_map(|p| &p.claims).collect();
    let fate = |wrong: &str, user: &str| {
        let resting = consequences(wrong, &outcomes);
        let found = resting.into_iter().find(|c| c.id == user);
        found.map(|c| c.fate)
    };
    // The scale factor lambda, whose factor 4 is missing in (5.16), is 0 in Example 5.2.
    assert_eq!(
        fate("gbt-developable/thm-4.c", "gbt-developable/ex-5.2.Q22"),
        Some(Fate::Survives)
    );
    assert_eq!(
        fate("gbt-developable/thm-4.c", "gbt-developable/alg-5.4.s4"),
        Some(Fate::SurvivesIf)
    );
    assert_eq!(
        fate("gbt-developable/thm-4.c", "gbt-developable/thm-1.3"),
        None
    );
}

/// A condition, or its beginning and its length.
fn shown(condition: &str) -> String {
    const MAX_CHARS: usize = 120;
    match condition.char_indices().nth(MAX_CHARS) {
        None => condition.to_owned(),
        Some((end, _)) => {
            let start = condition.get(..end).unwrap_or_default();
            format!("{start}... ({} characters)", condition.chars().count())
        }
    }
}

#[test]
fn the_verdicts_evidence_and_conditions_are_these() {
    let mut lines = BTreeMap::new();
    for outcome in PAPERS.iter().flat_map(|p| &p.claims) {
        let word = |text: String| text.to_lowercase();
        let evidence = outcome
            .evidence()
            .map_or_else(|| "-".to_owned(), |e| word(format!("{e:?}")));
        let conditions: Vec<String> = outcome
            .conditions()
            .iter()
            .map(|c| shown(&c.text))
            .collect();
        let conditions = match conditions.is_empty() {
            true => String::new(),
            false => format!(" where {}", conditions.join(" and ")),
        };
        let verdict = word(format!("{:?}", outcome.verdict()));
        lines.insert(
            outcome.claim.id.clone(),
            format!("{verdict} ({evidence}){conditions}"),
        );
    }
    insta::assert_json_snapshot!(lines);
}

#[test]
fn every_decided_statement_is_netted_or_says_why_not() {
    let decided = |verdict| {
        use Verdict::{Conditional, False, Holds, Misprint, Vacuous};
        matches!(verdict, Holds | Conditional | Misprint | False | Vacuous)
    };
    let (mut count, mut netted) = (0, 0);
    let mut lines = BTreeMap::new();
    for outcome in PAPERS.iter().flat_map(|p| &p.claims) {
        let Some(net) = outcome.net() else {
            assert!(
                !decided(outcome.verdict()),
                "{} has no net",
                outcome.claim.id
            );
            continue;
        };
        count += 1;
        match &net.why {
            None => {
                assert!(net.netted, "{}", outcome.claim.id);
                netted += 1;
            }
            Some(why) => {
                assert!(!net.netted, "{}", outcome.claim.id);
                let points = format!("{} of {} points", net.decided, net.tried);
                lines.insert(outcome.claim.id.clone(), format!("{why} ({points})"));
            }
        }
    }
    assert!(netted * 10 >= count * 8, "{netted} of {count}");
    assert!(lines.len() <= 12, "{lines:?}");
    insta::assert_json_snapshot!(lines);
}

#[test]
fn no_condition_of_the_papers_was_seen_to_be_superfluous() {
    for outcome in PAPERS.iter().flat_map(|p| &p.claims) {
        let correction = outcome
            .net()
            .into_iter()
            .filter_map(|net| net.correction.as_deref());
        for sides in outcome
            .net()
            .into_iter()
            .chain(correction)
            .flat_map(|net| &net.conditions)
        {
            assert!(!sides.is_suspicious(), "{}: {sides:?}", outcome.claim.id);
        }
    }
}

/// The papers of others.
const OF_OTHERS: [&str; 3] = ["gbt-developable", "gbt-surfaces", "hermite-developable"];

fn claims_of(slug: &str) -> impl Iterator<Item = &'static Outcome> {
    let paper = PAPERS.iter().find(|paper| paper.slug == slug).unwrap();
    paper.claims.iter()
}

/// How many claims of a paper have this verdict, our remarks not among them.
fn count(slug: &str, verdict: Verdict) -> usize {
    let claims = claims_of(slug).filter(|c| c.claim.kind != Kind::Remark);
    claims.filter(|c| c.verdict() == verdict).count()
}

/// The rows of the table of `docs/verdicts.md`, from the computed verdicts.
fn status_table() -> String {
    const ORDER: [(Verdict, &str); 12] = [
        (Verdict::Holds, "holds"),
        (Verdict::Conditional, "conditional"),
        (Verdict::Misprint, "misprint"),
        (Verdict::False, "false"),
        (Verdict::Depends, "depends"),
        (Verdict::Undecided, "undecided"),
        (Verdict::Definition, "definition"),
        (Verdict::Underspecified, "underspecified"),
        (Verdict::OutOfScope, "out-of-scope"),
        (Verdict::Vacuous, "vacuous"),
        (Verdict::Reproduced, "reproduced"),
        (Verdict::Partial, "partial"),
    ];
    let papers = OF_OTHERS;
    let uncompared = |slug: &str| {
        let definitions = claims_of(slug).filter(|c| c.verdict() == Verdict::Definition);
        definitions.filter(|c| c.evidence().is_none()).count()
    };
    let remarks = |slug: &str| {
        let remarks = claims_of(slug).filter(|c| c.claim.kind == Kind::Remark);
        remarks.count()
    };
    let mut lines = vec![
        format!(
            "| verdict | {} |",
            papers.map(|p| format!("`{p}`")).join(" | ")
        ),
        format!("|---|{}", "---:|".repeat(papers.len())),
    ];
    for (verdict, word) in ORDER {
        let counts = papers.map(|slug| count(slug, verdict));
        if counts.iter().any(|n| *n > 0) {
            lines.push(format!(
                "| `{word}` | {} |",
                counts.map(|n| n.to_string()).join(" | ")
            ));
        }
        if verdict == Verdict::Definition {
            let counts = papers.map(|slug| uncompared(slug).to_string());
            lines.push(format!(
                "| of these compared with nothing | {} |",
                counts.join(" | ")
            ));
        }
    }
    let counts = papers.map(|slug| remarks(slug).to_string());
    lines.push(format!("| remarks of ours | {} |", counts.join(" | ")));
    lines.join("\n")
}

#[test]
fn the_page_of_verdicts_counts_the_computed_ones() {
    let page = std::fs::read_to_string(root().join("docs/verdicts.md")).unwrap();
    let table = status_table();
    assert!(
        page.contains(&table),
        "write into docs/verdicts.md:\n{table}"
    );
}

/// The claims whose refutations the Rocq kernel accepted, by the last table of `torse report`, whose verdicts have to be
/// today's.
fn refutations_accepted_by_the_kernel() -> usize {
    let table = std::fs::read_to_string(root().join("reports/verdicts.csv")).unwrap();
    let rows = table.lines().skip(1).map(|line| line.split(',').collect());
    let rows: BTreeMap<&str, Vec<&str>> = rows.map(|row: Vec<&str>| (row[0], row)).collect();
    let refuted = OF_OTHERS.into_iter().flat_map(claims_of).filter(|outcome| {
        let word = serde_json::to_value(outcome.verdict()).unwrap();
        let row = &rows[outcome.claim.id.as_str()];
        assert_eq!(word, row[1], "reports/verdicts.csv: {}", outcome.claim.id);
        matches!(outcome.verdict(), Verdict::Misprint | Verdict::False) && row[5] == "yes"
    });
    refuted.count()
}

/// The numbers of the README, from the computed verdicts.
fn numbers_of_the_readme() -> String {
    let of = |verdict: Verdict| -> usize {
        let counts = OF_OTHERS.into_iter().map(|slug| count(slug, verdict));
        counts.sum()
    };
    let claims = OF_OTHERS.into_iter().flat_map(claims_of);
    let all = claims.filter(|c| c.claim.kind != Kind::Remark).count();
    let (holds, conditional) = (of(Verdict::Holds), of(Verdict::Conditional));
    let (misprints, wrong) = (of(Verdict::Misprint), of(Verdict::False));
    let refuted = misprints + wrong;
    let kernel = refutations_accepted_by_the_kernel();
    let undecided = of(Verdict::Undecided);
    let others = all - holds - conditional - refuted - undecided;
    [
        "| of these papers | |".to_owned(),
        "|---|---:|".to_owned(),
        format!("| statements, formulas and figures | {all} |"),
        format!("| hold as printed | {holds} |"),
        format!("| hold under a condition that the print leaves out | {conditional} |"),
        format!("| are false as printed; a small correction is proved | {misprints} |"),
        format!("| are false, with an exact counterexample | {wrong} |"),
        format!("| could not be decided | {undecided} |"),
        format!("| are definitions, figures, have readings with different verdicts, or lack data | {others} |"),
        format!(
            "| *not in the sum:* of these {refuted} false statements, refuted with a proof that the Rocq kernel accepts | *{kernel}* |"
        ),
    ]
    .join("\n")
}

#[test]
fn the_numbers_of_the_readme_are_the_computed_ones() {
    let readme = std::fs::read_to_string(root().join("README.md")).unwrap();
    let numbers = numbers_of_the_readme();
    assert!(
        readme.contains(&numbers),
        "write into README.md:\n{numbers}"
    );
}

#[test]
fn the_verdicts_that_a_policy_changed_are_counted() {
    let page = std::fs::read_to_string(root().join("derivations/CHANGES.md")).unwrap();
    let (_, page) = page.split_once("## One policy for every paper").unwrap();
    let mut policies: Vec<(&str, Vec<(String, usize)>)> = vec![];
    let mut rows = 0;
    for line in page.lines().filter(|line| line.starts_with("| ")) {
        let cells: Vec<&str> = line.split('|').map(str::trim).collect();
        let [_, id, then, now, why, ..] = cells.as_slice() else {
            panic!("{line}")
        };
        if *id == "id" {
            continue;
        }
        rows += 1;
        let policy = why.split(':').next().unwrap();
        let known = policies.iter().position(|(name, _)| *name == policy);
        let place = known.unwrap_or_else(|| {
            policies.push((policy, vec![]));
            policies.len() - 1
        });
        let change = format!("from `{then}` to `{now}`");
        let counts = &mut policies[place].1;
        match counts.iter_mut().find(|(name, _)| *name == change) {
            Some((_, count)) => *count += 1,
            None => counts.push((change, 1)),
        }
    }
    let lines = policies.iter().map(|(policy, counts)| {
        let counts = counts
            .iter()
            .map(|(change, count)| format!("{count} {change}"));
        format!("- {policy}: {}\n", counts.collect::<Vec<_>>().join(", "))
    });
    let list = format!(
        "By policy, {rows} verdicts:\n\n{}\n",
        lines.collect::<String>()
    );
    assert!(page.contains(&list), "{list}");
}

#[test]
fn the_verdicts_that_changed_are_listed_as_they_are_now() {
    let page = std::fs::read_to_string(root().join("derivations/CHANGES.md")).unwrap();
    let verdict = |id: &str| {
        let mut claims = PAPERS.iter().flat_map(|paper| &paper.claims);
        let claim = claims.find(|outcome| outcome.claim.id == id);
        claim.map(|claim| serde_json::to_value(claim.verdict()).unwrap())
    };
    // The first table is against the inventories, the others are against the verdicts before a policy.
    let (mut rows, mut tables) = (0, 0);
    for line in page.lines().filter(|line| line.starts_with('|')) {
        let cells: Vec<&str> = line.split('|').map(str::trim).collect();
        let [_, id, before, now, ..] = cells.as_slice() else {
            panic!("{line}")
        };
        if id.starts_with("---") {
            tables += 1;
        }
        if id.starts_with("---") || *id == "id" || tables == 0 {
            continue;
        }
        assert_ne!(before, now, "{id}");
        rows += usize::from(tables == 1);
        match now.strip_prefix("in parts: ") {
            None => assert_eq!(verdict(id), Some((*now).into()), "{id}"),
            Some(parts) => {
                for part in parts.split(", ") {
                    let (letter, now) = part.split_once(' ').unwrap();
                    let id = format!("{id}.{letter}");
                    assert_eq!(verdict(&id), Some(now.into()), "{id}");
                }
            }
        }
    }
    assert!(page.contains(&format!("({rows} of 675)")), "{rows}");
}

#[test]
fn what_is_printed_is_read_back_as_it_is_written() {
    let outcomes = PAPERS.iter().flat_map(|paper| &paper.claims);
    let wrong: Vec<String> = outcomes.flat_map(printed::unreadable).collect();
    assert_eq!(wrong, Vec::<String>::new());
}

#[test]
fn what_is_said_of_a_wider_range_is_true_there() {
    let outcomes = PAPERS.iter().flat_map(|paper| &paper.claims);
    let (mut judged, mut wrong) = (0, vec![]);
    for (claim, outcome) in CLAIMS.iter().zip(outcomes) {
        for (name, end) in printed::widened(outcome) {
            match printed::on_wider_range(claim, &name, &end) {
                None => wrong.push(format!(
                    "{}: `{name}` has no range to widen",
                    outcome.claim.id
                )),
                Some(points) => {
                    judged += 1;
                    let failing = points.failing;
                    wrong.extend(failing.map(|at| format!("{}: false at {at}", outcome.claim.id)));
                }
            }
        }
        for point in printed::beyond(outcome) {
            let Some(points) = printed::at_point_beyond(claim, &point) else {
                continue;
            };
            judged += 1;
            if points.holding > 0 {
                wrong.push(format!("{}: true at {point:?}", outcome.claim.id));
            }
        }
    }
    assert_eq!(wrong, Vec::<String>::new());
    assert!(judged > 20, "{judged}");
}
