//! What readers of letters, reports and findings meet: the paper's language, and no sentence of the engine.

use super::{LOADED, PAPERS, root};
use std::process::Command;
use std::sync::LazyLock;
use torse_report::model::Report;
use torse_report::{Envelope, erratum_latex, erratum_markdown, findings_in_words};
use torse_syntax::derivation::{Rewording, load};
use torse_syntax::taxonomy::{Flag, Verdict};
use torse_verdicts::PaperOutcome;
use torse_verdicts::audit::audit;
use torse_verdicts::engine::{STANDARD_WORK, run};
use torse_verdicts::restore::restore;

/// The same, decided again with all corrections in force.
pub static RESTORED: LazyLock<Vec<PaperOutcome>> = LazyLock::new(|| {
    let pairs = LOADED.iter().zip(PAPERS.iter());
    let restored = pairs.map(|(paper, outcome)| PaperOutcome {
        restored: Some(restore(STANDARD_WORK, paper, outcome).expect("every formula makes sense")),
        ..outcome.clone()
    });
    restored.collect()
});

/// What no reader is to meet: names and sentences of the engine, and slips of grammar. The command's tests read it, too.
const PATTERNS: &str = include_str!("../../support/patterns.txt");

/// What a text has of that, with what stands around it.
fn found(text: &str, whose: &str) -> Vec<String> {
    let mut list = vec![];
    for pattern in PATTERNS.lines() {
        for (at, _) in text.match_indices(pattern) {
            let from = text.floor_char_boundary(at.saturating_sub(60));
            let to = text.ceil_char_boundary((at + 60).min(text.len()));
            list.push(format!("{whose}: {pattern:?} in {:?}", &text[from..to]));
        }
    }
    list
}

/// What a reader meets of a value of a report: of mathematics its words, and not what it is set from.
pub fn words_of(value: &serde_json::Value, words: &mut Vec<String>) {
    use serde_json::Value;
    match value {
        Value::String(text) => words.push(text.clone()),
        Value::Array(list) => list.iter().for_each(|value| words_of(value, words)),
        Value::Object(map) => match (map.contains_key("typst"), map.get("math")) {
            (true, _) => words_of(&map["alt"], words),
            // A formula on lines of its own stands in the notation of the files where it has no mathematics.
            (false, Some(math)) if !math.is_null() => words_of(math, words),
            _ => map.values().for_each(|value| words_of(value, words)),
        },
        _ => {}
    }
}

#[test]
fn no_letter_and_no_finding_has_a_sentence_of_the_engine() {
    let mut all = vec![];
    for paper in PAPERS.iter() {
        let report = Report::new(paper, &[]);
        let letter = erratum_markdown(&report, &Envelope::default());
        all.extend(found(&letter, &format!("{}-erratum.md", paper.slug)));
        // What pages and documents are made of.
        let mut words = vec![];
        words_of(&serde_json::to_value(&report).unwrap(), &mut words);
        assert!(words.len() > 500);
        for text in words {
            all.extend(found(&text, &format!("the report of {}", paper.slug)));
        }
        for (id, text) in findings_in_words(paper) {
            all.extend(found(&text, &id));
        }
    }
    assert!(all.is_empty(), "{}", all.join("\n"));
}

#[test]
fn only_authors_are_addressed() {
    for paper in PAPERS.iter() {
        let report = Report::new(paper, &[]);
        let letter = erratum_markdown(&report, &Envelope::default());
        let example = paper.authors == "torse";
        for words in ["Dear ", "To: ", "Draft"] {
            assert_eq!(letter.contains(words), !example, "{}: {words}", paper.slug);
        }
        // Every item says in a sentence what is wrong.
        let items = letter.split("\n### ").skip(1);
        for item in items {
            let says = item.lines().nth(2).unwrap_or_default();
            assert!(says.len() > 20, "{}: {item}", paper.slug);
        }
    }
}

#[test]
fn latex_sets_every_letter_without_a_warning() {
    if Command::new("pdflatex").arg("--version").output().is_err() {
        println!(
            "notice: pdflatex is not installed (texlive-latex-recommended), no letter was set"
        );
        return;
    }
    let signed = Envelope {
        sender: Some("A. Reader".to_owned()),
        date: Some("1 May 2026".to_owned()),
    };
    for paper in RESTORED.iter() {
        let report = Report::new(paper, &[]);
        for envelope in [Envelope::default(), signed.clone()] {
            let folder = tempfile::tempdir().unwrap();
            let file = folder.path().join("letter.tex");
            std::fs::write(&file, erratum_latex(&report, &envelope)).unwrap();
            let mut pdflatex = Command::new("pdflatex");
            pdflatex.args(["-interaction=nonstopmode", "-halt-on-error", "letter.tex"]);
            let ran = pdflatex.current_dir(folder.path()).output().unwrap();
            let log = std::fs::read(folder.path().join("letter.log")).unwrap();
            let log = String::from_utf8_lossy(&log);
            let wrong = |line: &&str| {
                let signs = ["Warning", "Overfull", "Underfull", "! "];
                signs.iter().any(|sign| line.contains(sign))
            };
            let wrong: Vec<&str> = log.lines().filter(wrong).collect();
            assert!(
                ran.status.success() && wrong.is_empty(),
                "{}: {wrong:?}",
                paper.slug
            );
        }
    }
}

#[test]
fn every_fault_shows_in_claims_that_do_not_hold_and_no_refuted_claim_of_the_papers_is_left_to_itself()
 {
    for paper in PAPERS.iter() {
        let find = |id: &String| {
            paper
                .claims
                .iter()
                .find(|outcome| outcome.claim.id == *id)
                .unwrap()
        };
        for fault in &paper.faults {
            for id in &fault.shows {
                let verdict = find(id).verdict();
                let faulty = [
                    Verdict::False,
                    Verdict::Misprint,
                    Verdict::Conditional,
                    Verdict::Depends,
                    Verdict::Underspecified,
                    Verdict::OutOfScope,
                ];
                // What the copy at hand may have lost is asked, whatever the rest says.
                assert!(
                    faulty.contains(&verdict) || find(id).claim.garbled.is_some(),
                    "{}: {id} is {verdict:?}",
                    fault.id
                );
            }
        }
        if paper.faults.is_empty() {
            continue;
        }
        let refuted = paper.claims.iter().filter(|outcome| {
            matches!(outcome.verdict(), Verdict::False | Verdict::Misprint)
                && outcome.claim.kind != torse_syntax::taxonomy::Kind::Remark
        });
        let untold: Vec<&str> = refuted
            .filter(|outcome| {
                !paper
                    .faults
                    .iter()
                    .any(|fault| fault.shows.contains(&outcome.claim.id))
            })
            .map(|outcome| outcome.claim.id.as_str())
            .collect();
        assert!(untold.is_empty(), "{untold:?}");
    }
}

#[test]
fn with_all_corrections_in_force_every_claim_in_which_a_fault_shows_is_true_and_the_letter_counts_them()
 {
    let mut left = vec![];
    for outcome in RESTORED.iter().filter(|paper| !paper.faults.is_empty()) {
        let letter = erratum_latex(&Report::new(outcome, &[]), &Envelope::default());
        let checked = letter.split_once("How this was checked").unwrap().1;
        let restored = outcome.restored.as_ref().expect("it was decided again");
        let (all, resting) = (restored.corrected.len(), restored.dependents.len());
        assert!(
            all > 20 && resting > 5,
            "{}: {all}, {resting}",
            outcome.slug
        );
        assert!(
            checked.contains(&format!("the {all} statements that they concern")),
            "{}: {checked}",
            outcome.slug
        );
        assert!(
            checked.contains(&format!("{resting} other statements that rest on these")),
            "{}: {checked}",
            outcome.slug
        );
        // Nothing that rests on a correction is false, and what is not computed at all is said to be words.
        let is_false = |verdict| matches!(verdict, Verdict::False | Verdict::Misprint);
        let broken = restored.dependents.iter().filter(|of| is_false(of.verdict));
        left.extend(broken.map(|of| (of.claim.as_str(), of.verdict)));
        let words = restored.reworded.len();
        assert_eq!(
            words > 0,
            checked.contains("of words alone"),
            "{}",
            outcome.slug
        );
        assert!(!checked.contains("not corrected"), "{}", outcome.slug);
        for claim in &restored.corrected {
            let repaired = [Verdict::Holds, Verdict::Conditional, Verdict::Definition];
            if !repaired.contains(&claim.verdict) {
                left.push((claim.claim.as_str(), claim.verdict));
            }
        }
    }
    assert!(left.is_empty(), "{left:?}");
}

#[test]
fn the_formulas_of_the_texts_with_the_corrections_of_the_letters_made_hold() {
    let papers = load(&root().join("tests/readers")).unwrap();
    assert_eq!(papers.len(), 3);
    for paper in &papers {
        let outcome = run(paper, &|| ()).expect("every formula makes sense");
        assert!(outcome.claims.len() > 15, "{}", outcome.slug);
        for claim in &outcome.claims {
            let verdict = claim.verdict();
            let holds = matches!(verdict, Verdict::Holds | Verdict::Conditional);
            assert!(holds, "{}: {verdict:?}", claim.claim.id);
        }
    }
}

#[test]
fn a_claim_whose_correction_is_false_is_named_as_not_repaired() {
    let papers = LOADED.iter().zip(PAPERS.iter());
    let mut papers = papers.filter(|(paper, _)| paper.head.id == "gbt-developable");
    let (paper, outcome) = papers.next().unwrap();
    let mut paper = paper.clone();
    let id = "gbt-developable/thm-4.c";
    let mut corrected = paper.corrigenda.iter_mut().flat_map(|of| &mut of.corrected);
    let wrong = corrected.find(|of| of.claim.entry.id.get_ref() == id);
    let printed = paper.claims.iter().find(|c| c.entry.id.get_ref() == id);
    wrong.unwrap().claim.statement = printed.unwrap().statement.clone();
    let outcome = PaperOutcome {
        restored: Some(restore(STANDARD_WORK, &paper, outcome).unwrap()),
        ..outcome.clone()
    };
    let letter = erratum_latex(&Report::new(&outcome, &[]), &Envelope::default());
    let checked = letter.split_once("How this was checked").unwrap().1;
    let says = "1 is not corrected, and cannot stay as printed (Sect. 5.3, Theorem 4, eq. (5.16), third line)";
    assert!(checked.contains(says), "{checked}");
}

/// What the audit sees at a claim of a paper whose corrected words, or those of other claims, were changed by `edit`.
fn seen_at(id: &str, edit: impl Fn(&mut Rewording)) -> Vec<String> {
    let slug = id.split_once('/').unwrap().0;
    let mut papers = LOADED.iter().zip(PAPERS.iter());
    let (paper, outcome) = papers.find(|(paper, _)| paper.head.id == slug).unwrap();
    let mut papers = vec![paper.clone()];
    let changes = papers[0]
        .corrigenda
        .iter_mut()
        .flat_map(|of| &mut of.changes);
    changes.filter(|change| change.claim == id).for_each(edit);
    let claim = paper
        .claims
        .iter()
        .find(|c| c.entry.id.get_ref() == id)
        .unwrap();
    let found = outcome.claims.iter().find(|of| of.claim.id == id).unwrap();
    let audited = audit(&papers, &[(claim, found)], || ()).remove(0);
    let open = audited.open.into_iter();
    let open = open.filter(|raised| raised.flag == Flag::ReadsOtherwise);
    open.map(|raised| raised.evidence).collect()
}

#[test]
fn a_slip_in_the_words_of_a_correction_alone_is_flagged() {
    let slips = [
        // A sign.
        (
            "gbt-developable/sec-3.2.psi-z",
            "a1 a'_2 − a2 a'_1",
            "a1 a'_2 + a2 a'_1",
            "signs",
        ),
        (
            "gbt-developable/sec-3.4.m0-r3.c2",
            "(1 − ν + 2μ)",
            "(1 − ν − 2μ)",
            "signs",
        ),
        (
            "gbt-surfaces/thm-2.b3",
            "(1 + μ_1 - ν_1)",
            "(1 - μ_1 - ν_1)",
            "signs",
        ),
        // A number, a name, a relation.
        (
            "gbt-developable/sec-3.4.m0-r3.c2",
            "2(8 k_1",
            "2(7 k_1",
            "numbers",
        ),
        (
            "hermite-developable/eq-3.6.det",
            "16 k^3",
            "17 k^3",
            "numbers",
        ),
        ("gbt-developable/eq-2.3", "(R_{i+1}", "λ (R_{i+1}", "names"),
        (
            "gbt-developable/ex-4.1.c1.e",
            "the ending generator",
            "the ending generator ≠ 0",
            "relations",
        ),
    ];
    for (id, words, slip, family) in slips {
        assert_eq!(seen_at(id, |_| ()), Vec::<String>::new(), "{id}");
        let seen = seen_at(id, |change| {
            assert!(change.reads.contains(words), "{id}: {}", change.reads);
            change.reads = change.reads.replacen(words, slip, 1);
        });
        assert!(
            seen.iter().any(|words| words.contains(family)),
            "{id}, {slip}: {seen:?}"
        );
    }
}

#[test]
fn of_the_signs_of_example_4_2_no_single_one_and_eight_pairs_give_four_planes_with_midpoints_in_one_plane()
 {
    // Signs alone: the rows have the same absolute values.
    let printed: [[i64; 3]; 4] = [[1, -1, 1], [-1, -1, 1], [-1, -1, 1], [1, -1, 1]];
    let changed = |signs: &[usize]| {
        let mut planes = printed;
        for sign in signs {
            planes[sign / 3][sign % 3] *= -1;
        }
        planes
    };
    let is_of_four = |planes: &[[i64; 3]; 4]| {
        let distinct = (0..4).all(|i| (0..i).all(|j| planes[i] != planes[j]));
        let [a, b, c] = [1, 2, 3].map(|i| [0, 1, 2].map(|j| planes[i][j] - planes[0][j]));
        let volume = a[0] * (b[1] * c[2] - b[2] * c[1]) - a[1] * (b[0] * c[2] - b[2] * c[0])
            + a[2] * (b[0] * c[1] - b[1] * c[0]);
        distinct && volume == 0
    };
    let found = |choices: Vec<Vec<usize>>| -> (usize, Vec<Vec<usize>>) {
        let all = choices.len();
        let good = choices.into_iter().filter(|of| is_of_four(&changed(of)));
        (all, good.collect())
    };
    let (single, good) = found((0..12).map(|sign| vec![sign]).collect());
    assert_eq!((single, good.len()), (12, 0));
    let pairs = (0..12).flat_map(|i| (0..i).map(move |j| vec![j, i]));
    let (pairs, good) = found(pairs.collect());
    assert_eq!((pairs, good.len()), (66, 8));
    // Those of the letter: the second coordinates of the last two planes, or of the first two.
    let quadrants = |planes: [[i64; 3]; 4]| planes.map(|[x, y, _]| (x, y));
    assert!(good.contains(&vec![7, 10]) && good.contains(&vec![1, 4]));
    let turn = [(1, -1), (-1, -1), (-1, 1), (1, 1)];
    assert_eq!(quadrants(changed(&[7, 10])), turn);
    assert_eq!(quadrants(changed(&[1, 4])), turn.map(|(x, y)| (x, -y)));
}
