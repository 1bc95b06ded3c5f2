//! What has changed, and corpora in parts: `torse list` with digests, `verify --changed-since`, `verify --ids`, `merge`.

use crate::support::{Ran, add_paper, claim, mini, on, torse};
use serde_json::Value;
use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;
use tempfile::TempDir;

const RIGHT: &str = "(x + 1)^2 == x^2 + 2*x + 1";
const WRONG: &str = "(x + 1)^2 == x^2 + 3*x + 1";

/// Two papers: right, wrong, expected otherwise, a remark, a definition that several claims see, values of an example.
fn corpus() -> TempDir {
    let remark = claim("ours", RIGHT, "").replace("\"identity\"", "\"remark\"");
    let value = |name: &str, states: &str| {
        claim(name, states, "").replace("kind = \"identity\"", "kind = \"value\"")
    };
    let first = [
        "[define]\nF = '(x + 1)^2'\n".to_owned(),
        claim("right", RIGHT, "expect = \"holds\""),
        claim("wrong", WRONG, "expect = \"holds\""),
        claim("defined", "F == x^2 + 2*x + 1", ""),
        claim("open", "(x + 1)^1000 == (x + 1)^1000", ""),
        remark,
        value("ex.1", "1/3 == 0.333"),
        value("ex.2", "2/3 == 0.667"),
    ];
    let folder = mini(&first.concat());
    let second = claim("a", "x/x == 1", "").replace("mini/", "other/");
    add_paper(folder.path(), "other", &second);
    folder
}

fn edit(folder: &Path, from: &str, to: &str) {
    let path = folder.join("mini/claims.toml");
    let text = fs::read_to_string(&path).unwrap();
    assert!(text.contains(from), "{from}");
    fs::write(&path, text.replacen(from, to, 1)).unwrap();
}

fn list(folder: &Path) -> String {
    let ran = on(folder, &["list", "--format", "json"]);
    assert_eq!(ran.code, Some(0), "{}", ran.err);
    ran.out
}

fn digests(folder: &Path) -> BTreeMap<String, String> {
    let text = |line: &Value, field: &str| line[field].as_str().unwrap().to_owned();
    let lines = list(folder);
    let lines = lines
        .lines()
        .map(|line| serde_json::from_str(line).unwrap());
    let claims = lines.filter(|line: &Value| line["id"].is_string());
    let pairs = claims.map(|line| (text(&line, "id"), text(&line, "digest")));
    pairs.collect()
}

/// The ids with other digests than before.
fn differing(before: &BTreeMap<String, String>, folder: &Path) -> Vec<String> {
    let now = digests(folder);
    let differs = |id: &&String| before.get(*id) != now.get(*id);
    now.keys().filter(differs).cloned().collect()
}

#[test]
fn a_digest_changes_with_all_that_a_claim_rests_on_and_with_nothing_else() {
    let folder = corpus();
    let before = digests(folder.path());
    assert!(before.values().all(|digest| digest.len() == 64));
    edit(
        folder.path(),
        "[[claim]]",
        "# a remark\n\n[[claim]] # and another",
    );
    assert_eq!(differing(&before, folder.path()), [""; 0]);
    edit(folder.path(), WRONG, "(x + 1)^2 == x^2 + 4*x + 1");
    assert_eq!(differing(&before, folder.path()), ["mini/wrong"]);
    edit(folder.path(), "as printed", "as it is printed");
    assert_eq!(
        differing(&before, folder.path()),
        ["mini/right", "mini/wrong"]
    );
    let before = digests(folder.path());
    // A correction of data looks at the other values of the example.
    edit(folder.path(), "0.667", "0.668");
    assert_eq!(
        differing(&before, folder.path()),
        ["mini/ex.1", "mini/ex.2"]
    );
    // Whoever sees a declaration rests on it; other papers do not.
    edit(folder.path(), "F = '(x + 1)^2'", "F = '(1 + x)^2'");
    let differ = differing(&before, folder.path());
    assert_eq!(differ.len(), 7);
    assert!(differ.iter().all(|id| id.starts_with("mini/")));
    let before = digests(folder.path());
    let path = folder.path().join("other/paper.toml");
    let head = fs::read_to_string(&path).unwrap();
    fs::write(&path, head.replace("[0, 1]", "[0, 2]")).unwrap();
    assert_eq!(differing(&before, folder.path()), ["other/a"]);
}

/// The ids of the claims that a run has decided.
fn decided(ran: &Ran) -> Vec<String> {
    let all: Value = serde_json::from_str(&ran.out).unwrap();
    let claims = all["claims"].as_array().unwrap().iter();
    claims
        .map(|claim| claim["id"].as_str().unwrap().to_owned())
        .collect()
}

#[test]
fn what_has_changed_since_a_list_or_a_revision_is_decided_and_nothing_else() {
    let folder = corpus();
    let derivations = folder.path();
    let git = |arguments: &[&str]| {
        let mut git = Command::new("git");
        git.args(["-c", "user.name=N", "-c", "user.email=n@n.invalid"]);
        let ran = git.args(arguments).current_dir(derivations).output();
        assert!(ran.unwrap().status.success(), "{arguments:?}");
    };
    git(&["init", "--quiet"]);
    git(&["add", "."]);
    git(&["commit", "--quiet", "--message", "all"]);
    let written = TempDir::new().unwrap();
    let before = written.path().join("before.ndjson");
    fs::write(&before, list(derivations)).unwrap();
    for since in [before.to_str().unwrap(), "HEAD"] {
        let table = on(derivations, &["verify", "--changed-since", since]);
        assert_eq!(
            (table.code, table.out.as_str()),
            (Some(0), ""),
            "{}",
            table.err
        );
        let since = |names: &[&str]| {
            let command = ["verify", "--format", "json", "--changed-since", since];
            on(derivations, &[&command, names].concat())
        };
        let same = since(&[]);
        assert_eq!(decided(&same), [""; 0]);
        assert_eq!(same.code, Some(0), "{}", same.err);
        assert!(
            same.err.contains("0 of 8 claims have changed"),
            "{}",
            same.err
        );
        let text = fs::read_to_string(derivations.join("mini/claims.toml")).unwrap();
        edit(derivations, RIGHT, "(x + 1)^2 == 1 + 2*x + x^2");
        let new = claim("new", RIGHT, "");
        let now = fs::read_to_string(derivations.join("mini/claims.toml")).unwrap();
        fs::write(derivations.join("mini/claims.toml"), now + &new).unwrap();
        assert_eq!(decided(&since(&[])), ["mini/right", "mini/new"]);
        assert_eq!(decided(&since(&["mini/new"])), ["mini/new"]);
        fs::write(derivations.join("mini/claims.toml"), text).unwrap();
    }
    // What was wrong at the revision has changed, as has everything where there was nothing.
    edit(derivations, RIGHT, "x + == 1");
    git(&["commit", "--quiet", "--all", "--message", "wrong"]);
    edit(derivations, "x + == 1", RIGHT);
    let command = ["verify", "--format", "json", "--changed-since", "HEAD"];
    assert_eq!(decided(&on(derivations, &command)), ["mini/right"]);
    let no_list = derivations.join("mini/claims.toml");
    for (since, code, reason) in [
        ("no-such-revision", 2, "there is no such file"),
        ("--help", 2, "there is no such file"),
        (no_list.to_str().unwrap(), 4, "line 1"),
    ] {
        let since = format!("--changed-since={since}");
        let ran = on(derivations, &["verify", &since]);
        assert_eq!(
            (ran.code, ran.out.as_str()),
            (Some(code), ""),
            "{}",
            ran.err
        );
        assert!(ran.err.contains(reason), "{}", ran.err);
    }
}

/// A corpus in three parts, with the list of its claims.
struct Parts {
    folder: TempDir,
    written: TempDir,
}

const PARTS: [&str; 3] = [
    "mini/wrong\nmini/ex.1\n",
    "other/a\n\nmini/right\n",
    "mini/open\nmini/defined\nmini/ours\nmini/ex.2",
];

impl Parts {
    fn new(folder: TempDir) -> Self {
        let written = TempDir::new().unwrap();
        let parts = Self { folder, written };
        fs::write(parts.path("list"), list(parts.folder.path())).unwrap();
        for number in 0..PARTS.len() {
            parts.decide(number, &[]);
        }
        parts
    }

    fn path(&self, name: &str) -> PathBuf {
        self.written.path().join(name)
    }

    fn decide(&self, number: usize, more: &[&str]) -> Ran {
        let ids = self.path("ids");
        fs::write(&ids, PARTS[number]).unwrap();
        let command = [&["verify", "--ids", ids.to_str().unwrap()], more].concat();
        let ran = on(self.folder.path(), &command);
        fs::write(self.path(&number.to_string()), &ran.out).unwrap();
        ran
    }

    fn merge(&self, parts: &[&str]) -> Ran {
        let path = |name: &&str| self.path(name).to_str().unwrap().to_owned();
        let mut arguments = vec!["merge".to_owned(), "--list".to_owned(), path(&"list")];
        arguments.extend(parts.iter().map(path));
        torse(&arguments)
    }

    /// Asserts that nothing is printed, and why.
    fn refused(&self, parts: &[&str], reason: &str) {
        let ran = self.merge(parts);
        assert_eq!(
            (ran.code, ran.out.as_str()),
            (Some(4), ""),
            "{reason}: {}",
            ran.err
        );
        let told = ran.err.split_whitespace().collect::<Vec<_>>().join(" ");
        let told = told.replace("│ ", "");
        assert!(told.contains(reason), "{reason}: {}", ran.err);
    }
}

#[test]
fn merged_parts_have_the_bytes_and_the_exit_code_of_one_run() {
    let parts = Parts::new(corpus());
    let whole = on(parts.folder.path(), &["verify", "--format", "json"]);
    let merged = parts.merge(&["2", "0", "1"]);
    assert_eq!(merged.out, whole.out, "{}", merged.err);
    assert_eq!((merged.code, whole.code), (Some(1), Some(1)));
    assert!(
        whole.out.contains("\"remarks\": {\n      \"total\": 1"),
        "{}",
        whole.out
    );
    // Without the claim that is not as expected; its part ends with another code.
    let text = fs::read_to_string(parts.path("0")).unwrap();
    assert!(
        text.lines().last().unwrap().contains("\"exit\":1"),
        "{text}"
    );
    assert_eq!(parts.decide(1, &[]).code, Some(0));
}

#[test]
fn merged_parts_say_what_the_kernel_accepted() {
    let root = concat!(env!("CARGO_MANIFEST_DIR"), "/../..");
    let (derivations, kernel) = (format!("{root}/derivations"), format!("{root}/proofs"));
    let from = ["--derivations", &derivations, "--kernel", &kernel];
    let verify = |arguments: &[&str]| torse(&[&["verify"][..], arguments, &from].concat());
    let whole = verify(&["bezier/circle.kappa", "bezier/join.C1", "--format", "json"]);
    assert!(
        whole.out.contains("\"kernel\": \"accepted\""),
        "{}",
        whole.err
    );
    let claims: Value = serde_json::from_str(&whole.out).unwrap();
    let claims = claims["claims"].as_array().unwrap();
    let ids: Vec<&str> = claims
        .iter()
        .map(|claim| claim["id"].as_str().unwrap())
        .collect();
    let list = ["list", "--format", "json", "--derivations", &derivations];
    let listed = torse(&[&list[..], &ids].concat()).out;
    let folder = TempDir::new().unwrap();
    let path = |name: &str| folder.path().join(name).to_str().unwrap().to_owned();
    fs::write(path("list"), listed).unwrap();
    for (index, id) in ids.iter().enumerate() {
        fs::write(path("ids"), id).unwrap();
        let part = verify(&["--ids", &path("ids")]);
        fs::write(path(&index.to_string()), part.out).unwrap();
    }
    let parts: Vec<String> = (0..ids.len())
        .map(|index| path(&index.to_string()))
        .collect();
    let merge = |parts: &[String]| {
        let parts = parts.iter().map(String::as_str);
        let all: Vec<&str> = ["merge"].into_iter().chain(parts).collect();
        torse(&[&all[..], &["--list", &path("list")]].concat())
    };
    let merged = merge(&parts);
    assert_eq!(
        (merged.out, merged.code),
        (whole.out, whole.code),
        "{}",
        merged.err
    );
    // A part that was decided beside another list is refused.
    fs::write(path("ids"), ids[0]).unwrap();
    let ids = path("ids");
    let other = torse(&[
        "verify",
        "--ids",
        &ids,
        "--derivations",
        &derivations,
        "--kernel",
        &ids,
    ]);
    fs::write(path("0"), other.out).unwrap();
    let merged = merge(&parts);
    assert_eq!((merged.code, merged.out.as_str()), (Some(4), ""));
    assert!(merged.err.contains("another list"), "{}", merged.err);
}

#[test]
fn a_paper_of_which_nothing_can_be_read_is_in_no_part_and_counts_in_the_whole() {
    let parts = Parts::new(corpus());
    assert_eq!(parts.merge(&["0", "1", "2"]).code, Some(1));
    let third = parts.folder.path().join("third");
    fs::create_dir(&third).unwrap();
    fs::write(third.join("paper.toml"), "[paper").unwrap();
    let whole = on(parts.folder.path(), &["verify", "--format", "json"]);
    let listed = on(parts.folder.path(), &["list", "--format", "json"]);
    assert_eq!((whole.code, listed.code), (Some(4), Some(4)));
    // No part knows of it.
    assert_eq!(parts.decide(1, &[]).code, Some(0));
    fs::write(parts.path("list"), &listed.out).unwrap();
    let merged = parts.merge(&["0", "1", "2"]);
    assert_eq!((merged.code, merged.out), (Some(4), whole.out));
    // A list that is not whole does not know.
    let lines: Vec<&str> = listed.out.lines().collect();
    let (last, claims) = lines.split_last().unwrap();
    assert_eq!(*last, "{\"claims\":8,\"exit\":4}");
    for list in [
        claims.join("\n"),
        [&claims[1..], &[*last]].concat().join("\n"),
        [&[*last], claims].concat().join("\n"),
        [claims, &["{\"claims\":8,\"exit\":44}"]]
            .concat()
            .join("\n"),
    ] {
        fs::write(parts.path("list"), list).unwrap();
        let merged = parts.merge(&["0", "1", "2"]);
        assert_eq!((merged.code, merged.out.as_str()), (Some(4), ""));
    }
}

#[test]
fn figures_of_a_paper_without_claims_count_in_the_whole() {
    let parts = Parts::new(corpus());
    let figure = "[[figure]]\nid = 'third/fig-1'\ncaption = ''\nalt = ''\n";
    add_paper(parts.folder.path(), "third", figure);
    let whole = on(parts.folder.path(), &["verify", "--format", "json"]);
    let listed = on(parts.folder.path(), &["list", "--format", "json"]);
    assert_eq!(listed.code, Some(4), "{}", listed.err);
    fs::write(parts.path("list"), &listed.out).unwrap();
    let merged = parts.merge(&["0", "1", "2"]);
    assert_eq!((merged.code, merged.out), (whole.code, whole.out));
}

#[test]
fn the_head_of_all_parts_is_told_without_deciding_any() {
    let parts = Parts::new(corpus());
    let kernel = TempDir::new().unwrap();
    let head = |more: &[&str]| {
        let ran = torse(&[&["verify", "--head"], more].concat());
        assert_eq!(ran.code, Some(0), "{}", ran.err);
        ran.out
    };
    let part = fs::read_to_string(parts.path("1")).unwrap();
    assert_eq!(part.lines().next(), Some(head(&[]).trim_end()));
    assert!(head(&["--budget", "77"]).contains("\"budget\":77,"));
    // Of what the kernel has accepted each change is seen.
    let own = ["--kernel", kernel.path().to_str().unwrap()];
    let list = concat!(env!("CARGO_MANIFEST_DIR"), "/../../proofs/accepted.json");
    let list = fs::read_to_string(list).unwrap();
    let theorem = list.lines().find(|line| line.contains("Bezier/")).unwrap();
    let fewer = list.replacen(&format!("{theorem}\n"), "", 1);
    let heads = [&list, &fewer].map(|list| {
        fs::write(kernel.path().join("accepted.json"), list).unwrap();
        head(&own)
    });
    assert_ne!(heads[0], heads[1]);
    assert!(
        heads.iter().all(|head| !head.contains("null}")),
        "{heads:?}"
    );
    // A commit says what was built only if nothing was changed since.
    let read: Value = serde_json::from_str(&head(&[])).unwrap();
    let is_named = read["torse"].as_str().unwrap().ends_with(')');
    let is_clean = is_named && !read["torse"].as_str().unwrap().ends_with("-dirty)");
    match read["program"].as_str() {
        Some(digest) => assert_eq!(digest.len(), 64),
        None => assert!(is_clean, "{read}"),
    }
    assert!(is_clean || read["program"].is_string(), "{read}");
    // Parts of another build are refused.
    let mut other = read;
    other["program"] = "0".into();
    let (_, lines) = part.split_once('\n').unwrap();
    fs::write(parts.path("1"), format!("{other}\n{lines}")).unwrap();
    parts.refused(&["0", "1", "2"], "of another build");
}

#[test]
fn work_is_told_with_each_claim_and_is_what_it_is_expected_to_cost_again() {
    let parts = Parts::new(corpus());
    let read = |text: &str| -> Vec<Value> {
        let lines = text.lines().map(|line| serde_json::from_str(line).unwrap());
        lines
            .filter(|line: &Value| line["id"].is_string())
            .collect()
    };
    let part = fs::read_to_string(parts.path("2")).unwrap();
    let work: BTreeMap<String, u64> = read(&part)
        .iter()
        .map(|line| (line["id"].to_string(), line["work"].as_u64().unwrap()))
        .collect();
    assert_eq!(work.len(), 4);
    assert!(work.values().all(|work| *work > 0), "{work:?}");
    // One by one it is the same.
    let ids = parts.path("ids");
    for id in ["mini/open", "mini/defined"] {
        fs::write(&ids, id).unwrap();
        let alone = on(
            parts.folder.path(),
            &["verify", "--ids", ids.to_str().unwrap()],
        );
        let line = read(&alone.out).remove(0);
        assert_eq!(line["work"].as_u64(), Some(work[&line["id"].to_string()]));
    }
    let list = |more: &[&str]| {
        let command = [&["list", "--format", "json"], more].concat();
        let ran = on(parts.folder.path(), &command);
        assert_eq!(ran.code, Some(0), "{}", ran.err);
        read(&ran.out)
    };
    // A part that was cut off says something, too.
    let cut = parts.path("cut");
    fs::write(&cut, &part[..part.len() - 300]).unwrap();
    edit(
        parts.folder.path(),
        "(x + 1)^1000 == (x + 1)^1000",
        "(x + 1)^999 == (x + 1)^999",
    );
    let estimated = list(&[]);
    let costs = list(&["--costs", cut.to_str().unwrap()]);
    let mut known = 0;
    for (before, mut after) in estimated.into_iter().zip(costs) {
        let id = after["id"].to_string();
        let cost = after["cost"].take().as_u64().unwrap();
        let estimate = before["cost"].as_u64().unwrap();
        match work.get(&id).filter(|work| **work == cost) {
            Some(_) => known += 1,
            None => assert_eq!(cost, estimate, "{id}"),
        }
        // The cost changes nothing else.
        after["cost"] = estimate.into();
        assert_eq!(before, after);
    }
    assert!((1..=3).contains(&known), "{known}");
}

#[test]
fn a_claim_whose_formula_makes_no_sense_is_in_a_part_and_not_in_the_whole() {
    let folder = corpus();
    edit(folder.path(), RIGHT, "P[0] + x == 0");
    let parts = Parts::new(folder);
    let whole = on(parts.folder.path(), &["verify", "--format", "json"]);
    let merged = parts.merge(&["0", "1", "2"]);
    assert_eq!(whole.code, Some(4));
    assert_eq!(
        (merged.code, merged.out),
        (whole.code, whole.out),
        "{}",
        merged.err
    );
}

#[test]
fn parts_that_are_no_whole_are_refused_and_nothing_is_printed() {
    let parts = Parts::new(corpus());
    parts.refused(&["0", "1"], "no file has the claim");
    parts.refused(&["0", "1", "2", "2"], "has it too");
    let text = fs::read_to_string(parts.path("1")).unwrap();
    let lines: Vec<&str> = text.lines().collect();
    for (broken, reason) in [
        (String::new(), "it is empty"),
        (lines[..lines.len() - 1].join("\n"), "has not ended"),
        (text[..text.len() - 100].to_owned(), ""),
        (
            text.replace("\"as printed\"", "\"as prunted\""),
            "have changed since",
        ),
        (
            text.replace("\"budget\":", "\"budget\":1"),
            "with a budget of",
        ),
        (text.clone() + "\n", "its last line"),
        (
            lines.iter().rev().copied().collect::<Vec<_>>().join("\n"),
            "first line",
        ),
        ("[]".to_owned(), "first line"),
        (
            text.replace(
                "\"claim\":{\"id\":\"other/a\"",
                "\"claim\":{\"id\":\"other/b\"",
            ),
            "another claim",
        ),
    ] {
        assert_ne!(broken, text, "{reason}");
        fs::write(parts.path("1"), broken).unwrap();
        parts.refused(&["0", "1", "2"], reason);
    }
    fs::write(parts.path("1"), &text).unwrap();
    assert_eq!(parts.merge(&["0", "1", "2"]).code, Some(1));
    // Another budget, and a claim that has changed since it was decided.
    parts.decide(1, &["--budget", "1000000"]);
    parts.refused(&["0", "1", "2"], "with a budget of");
    parts.decide(1, &[]);
    edit(parts.folder.path(), RIGHT, "(x + 1)^2 == 1 + 2*x + x^2");
    fs::write(parts.path("list"), list(parts.folder.path())).unwrap();
    parts.refused(
        &["0", "1", "2"],
        "no file has the claim `mini/right` as it is now",
    );
    parts.decide(1, &[]);
    assert_eq!(parts.merge(&["0", "1", "2"]).code, Some(1));
}

#[test]
fn an_id_that_no_claim_has_is_a_usage_error() {
    let folder = corpus();
    let ids = folder.path().join("ids");
    fs::write(&ids, "mini/right\nmini\n").unwrap();
    let ran = on(folder.path(), &["verify", "--ids", ids.to_str().unwrap()]);
    assert_eq!((ran.code, ran.out.as_str()), (Some(2), ""));
    assert!(
        ran.err.contains("no claim has the id `mini`"),
        "{}",
        ran.err
    );
    let ran = on(folder.path(), &["verify", "mini", "--ids", "x"]);
    assert_eq!(ran.code, Some(2));
}
