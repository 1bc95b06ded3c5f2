//! `torse explain`.

use crate::support::{claim, mini, on, torse_in};
use std::path::Path;

#[test]
fn a_refuted_claim_is_explained_with_both_sides_at_a_point() {
    let wrong = claim(
        "wrong",
        "(x + 1)^2 == x^2 + 3*x + 1",
        "uses = [\"mini/right\"]",
    );
    let folder = mini(&[claim("right", "x == x", ""), wrong].concat());
    let ran = on(folder.path(), &["explain", "mini/wrong"]);
    assert_eq!(ran.code, Some(0), "{}", ran.err);
    for label in [
        "printed",
        "understood",
        "verdict",
        "evidence",
        "fails at",
        "left side",
        "right side",
        "left - right",
        "uses",
    ] {
        assert!(
            ran.out
                .lines()
                .any(|line| line.trim_start().starts_with(label)),
            "{label}: {}",
            ran.out
        );
    }
    // The answer comes first.
    let first = ran.out.lines().nth(2).unwrap();
    assert!(first.trim_start().starts_with("verdict"), "{}", ran.out);
    assert!(
        ran.out.contains("x»^2« + 3*x") && ran.out.contains("x»*(x - 1)« + 3*x"),
        "{}",
        ran.out
    );
    let used = on(folder.path(), &["explain", "mini/right"]);
    assert!(
        used.out.contains("used by") && used.out.contains("mini/wrong"),
        "{}",
        used.out
    );
}

#[test]
fn the_words_of_a_remark_are_ours_and_not_printed() {
    let remark = claim("ours", "x == x", "").replace("\"identity\"", "\"remark\"");
    let folder = mini(&[claim("theirs", "x == x", ""), remark].concat());
    for (id, label, other) in [("ours", "ours", "printed"), ("theirs", "printed", "ours")] {
        let ran = on(folder.path(), &["explain", &format!("mini/{id}")]);
        let labelled = |label: &str| {
            let mut lines = ran.out.lines();
            lines.any(|line| line.split_whitespace().next() == Some(label))
        };
        assert!(labelled(label) && !labelled(other), "{}", ran.out);
    }
}

#[test]
fn the_whole_of_a_paper_is_told_in_the_words_of_the_glossary() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
    for command in ["explain", "verify"] {
        let ran = torse_in(&root, &[command, "torses"]);
        assert_eq!(ran.code, Some(0), "{}", ran.err);
        assert!(ran.out.lines().count() > 100, "{}", ran.out);
        for word in crate::glossary::ruled_out() {
            assert!(!ran.out.contains(word), "{word}: {}", ran.out);
        }
    }
}

#[test]
fn a_name_of_several_claims_is_refused_with_the_list() {
    let folder = mini(
        &["eq-1.a", "eq-1.b"]
            .map(|name| claim(name, "x == x", ""))
            .concat(),
    );
    let ran = on(folder.path(), &["explain", "mini/eq-1"]);
    assert_eq!((ran.code, ran.out.as_str()), (Some(2), ""));
    assert!(
        ran.err.contains("mini/eq-1.a") && ran.err.contains("mini/eq-1.b"),
        "{}",
        ran.err
    );
    assert_eq!(on(folder.path(), &["explain", "mini/eq-1.a"]).code, Some(0));
}

#[test]
fn an_id_that_others_continue_means_itself() {
    let folder = mini(
        &["eq-1", "eq-1.b"]
            .map(|name| claim(name, "x == x", ""))
            .concat(),
    );
    let ran = on(folder.path(), &["explain", "mini/eq-1"]);
    assert_eq!(ran.code, Some(0), "{}", ran.err);
    assert!(ran.out.starts_with("mini/eq-1\n"), "{}", ran.out);
}

#[test]
fn a_long_formula_is_cut_where_asked() {
    let folder = mini(&claim("long", "sum(i, 0, 9, (x + i)^2) == 0", ""));
    let short = on(folder.path(), &["explain", "mini/long", "--longest", "20"]);
    assert!(short.out.contains("characters: --longest"), "{}", short.out);
    let whole = on(
        folder.path(),
        &["explain", "mini/long", "--longest", "100000"],
    );
    assert!(!whole.out.contains("--longest"), "{}", whole.out);
}

#[test]
fn what_rests_on_a_refuted_claim_is_told_with_its_fate() {
    let claims = [
        claim("wrong", "x^2 == 2*x", ""),
        claim("survivor", "x + x == 2*x", "uses = [\"mini/wrong\"]"),
        claim("fallen", "x^3 == 8*x", "uses = [\"mini/survivor\"]"),
    ];
    let folder = mini(&claims.concat());
    let ran = on(folder.path(), &["explain", "mini/wrong"]);
    for row in [
        "mini/survivor: survives",
        "mini/fallen: fails too: false as printed (rests on mini/survivor)",
    ] {
        assert!(ran.out.contains(row), "{row}: {}", ran.out);
    }
}

#[test]
fn a_claim_that_rests_on_nothing_stated_is_refused_at_its_place() {
    let folder = mini(&claim("right", "x == x", "uses = [\"mini/wrnog\"]"));
    let ran = on(folder.path(), &["explain", "mini/right"]);
    assert_eq!(ran.code, Some(4), "{}", ran.err);
    assert!(
        ran.err.contains("no claim has the id `mini/wrnog`"),
        "{}",
        ran.err
    );
    assert!(ran.err.contains("mini/claims.toml:"), "{}", ran.err);
}

#[test]
fn all_that_a_verdict_rests_on_is_on_the_table() {
    let claim = r#"
[[claim]]
id = "mini/table"
at = "Sect. 1"
kind = "property"
printed = "for small y, c is positive"
garbled = "y for v"
symbols = { y = { in = "(0, 1]", printed = "for small y" }, r = {} }
let = { c = 'deep + y', deep = 'y^2' }
given = ['r == y']
solve_for = ['r']
assume = [{ states = 'x < 1/2', ours = 'to try it' }]
states = 'c + r > 0'

[[claim]]
id = "mini/readings"
at = "Sect. 1"
kind = "property"
printed = "x is positive"
readings = [
    { name = 'literal', says = 'all x are', states = 'x > 0' },
    { name = 'kind', says = 'x is not negative', states = 'x >= 0' },
]
"#;
    let folder = mini(claim);
    let ran = on(folder.path(), &["explain", "mini/table"]);
    assert_eq!(ran.code, Some(0), "{}", ran.err);
    let plain = ran.out.split_whitespace().collect::<Vec<_>>().join(" ");
    for told in [
        "assuming x < 1/2",
        "given r == y",
        "solved for r",
        "where y in (0, 1]; r, a real number; x in [0, 1]",
        "with c = deep + y deep = y^2",
        "source 0 < y <= 1: the paper, “for small y” (mini/table)",
        "x < 1/2: ours, not needed, to try it",
        "copy at hand y for v",
    ] {
        assert!(plain.contains(told), "{told} is not in {plain}");
    }
    let ran = on(folder.path(), &["explain", "mini/readings"]);
    let plain = ran.out.split_whitespace().collect::<Vec<_>>().join(" ");
    for told in [
        "verdict depends on the reading.",
        "read as literal: all x are verdict false.",
        "read as kind: x is not negative verdict holds.",
        "fails at x = 0",
    ] {
        assert!(plain.contains(told), "{told} is not in {plain}");
    }
    let json = on(folder.path(), &["verify", "--format", "json"]).out;
    let json: serde_json::Value = serde_json::from_str(&json).unwrap();
    let table = &json["claims"][0];
    assert_eq!(table["hypotheses"][0]["quote"], "for small y");
    assert_eq!(table["hypotheses"][1]["role"], "given");
    assert_eq!(table["hypotheses"][2]["needed"], false);
    assert_eq!(table["symbols"][0]["set"], "y in (0, 1]");
    assert_eq!(table["definitions"][0]["head"], "c");
    assert_eq!(table["unknowns"][0], "r");
    let read = &json["claims"][1];
    assert_eq!(read["verdict"], "depends");
    let verdicts = [
        &read["readings"][0]["verdict"],
        &read["readings"][1]["verdict"],
    ];
    assert_eq!(verdicts, ["false", "holds"]);
}

#[test]
fn explanations_of_the_papers_have_no_sentence_and_no_symbol_of_the_engine() {
    const PATTERNS: &str = include_str!("../../../../tests/support/patterns.txt");
    let ruled_out = crate::glossary::ruled_out();
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
    for id in [
        "gbt-developable/thm-4.c",
        "gbt-developable/thm-2.b",
        "gbt-surfaces/eq-6.Q13",
        "hermite-developable/eq-3.3.g",
        "trigonometric/helix.principal.slip",
    ] {
        let ran = torse_in(&root, &["explain", id]);
        assert_eq!(ran.code, Some(0), "{id}: {}", ran.err);
        for pattern in PATTERNS.lines().chain(ruled_out.iter().copied()) {
            assert!(
                !ran.out.contains(pattern),
                "{id} has {pattern:?}:\n{}",
                ran.out
            );
        }
        let point = ran
            .out
            .lines()
            .find(|line| line.trim_start().starts_with("fails at"));
        assert!(
            !point.is_some_and(|line| line.contains('√')),
            "{id}: {point:?}"
        );
        // The answer comes first.
        assert!(
            ran.out
                .lines()
                .nth(2)
                .unwrap()
                .trim_start()
                .starts_with("verdict"),
            "{id}:\n{}",
            ran.out
        );
    }
}

/// One in 25 of the claims of the three papers, by a digest of their ids, so that no claim can be written around the test.
fn sample(root: &Path) -> Vec<String> {
    let table = std::fs::read_to_string(root.join("reports/verdicts.csv")).unwrap();
    let ids = table.lines().filter_map(|line| line.split(',').next());
    let of_papers = ids.filter(|id| {
        let papers = ["gbt-developable/", "gbt-surfaces/", "hermite-developable/"];
        papers.iter().any(|paper| id.starts_with(paper))
    });
    // The digest of Fowler, Noll and Vo.
    let digest = |id: &str| {
        let bytes = id.bytes();
        bytes.fold(0x811c_9dc5_u32, |digest, byte| {
            (digest ^ u32::from(byte)).wrapping_mul(0x0100_0193)
        })
    };
    let sampled = of_papers.filter(|id| digest(id) % 25 == 0);
    sampled.map(str::to_owned).collect()
}

#[test]
fn a_sample_of_all_explanations_begins_with_one_sentence_and_has_none_of_the_engine() {
    const PATTERNS: &str = include_str!("../../../../tests/support/patterns.txt");
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
    let ids = sample(&root);
    assert!(ids.len() > 20, "{}", ids.len());
    let mut wrong = vec![];
    for id in &ids {
        let ran = torse_in(&root, &["explain", id, "--format", "json"]);
        assert_eq!(ran.code, Some(0), "{id}: {}", ran.err);
        let note: serde_json::Value = serde_json::from_str(&ran.out).unwrap();
        let groups = note["groups"].as_array().unwrap().iter();
        let lines: Vec<&serde_json::Value> =
            groups.flat_map(|group| group.as_array().unwrap()).collect();
        let text = |line: &serde_json::Value| line["text"].as_str().unwrap().to_owned();
        let labelled = |label: &str| lines.iter().find(|line| line["label"] == label);
        let verdict = text(labelled("verdict").unwrap());
        let asks = ["misprint", "false", "conditional", "depends"];
        let found = labelled("found").map(|line| text(line));
        if asks.iter().any(|asked| verdict.starts_with(asked)) {
            match found {
                Some(found) if found.chars().count() <= 350 => {}
                other => wrong.push(format!("{id}: found {other:?}")),
            }
        }
        // Names of definitions are those of the files, in which they can be looked up.
        for line in lines {
            let text = text(line);
            let patterns = PATTERNS
                .lines()
                .filter(|pattern| !pattern.starts_with("printed"));
            let found = patterns.filter(|pattern| text.contains(*pattern));
            wrong.extend(found.map(|pattern| format!("{id}: {pattern:?} in {text}")));
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}
