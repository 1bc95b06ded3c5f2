//! `torse report`: the files it writes.

use crate::support::{add_paper, claim, mini, on};
use std::collections::BTreeMap;
use std::fs;
use std::path::Path;
use tempfile::TempDir;

/// The files below a folder, by their names relative to it.
fn files(folder: &Path) -> BTreeMap<String, Vec<u8>> {
    let mut files = BTreeMap::new();
    for entry in fs::read_dir(folder).unwrap().flatten() {
        let name = entry.file_name().into_string().unwrap();
        if entry.path().is_dir() {
            let inner = self::files(&entry.path());
            files.extend(
                inner
                    .into_iter()
                    .map(|(inner, bytes)| (format!("{name}/{inner}"), bytes)),
            );
        } else {
            files.insert(name, fs::read(entry.path()).unwrap());
        }
    }
    files
}

#[test]
fn a_report_of_a_paper_is_written_whole_and_the_same_twice() {
    let folder = mini(&[claim("right", "x == x", ""), claim("wrong", "x == 1", "")].concat());
    let report = || {
        let out = TempDir::new().unwrap();
        let ran = on(
            folder.path(),
            &["report", "--out", out.path().to_str().unwrap()],
        );
        assert_eq!(ran.code, Some(0), "{}", ran.err);
        files(out.path())
    };
    let (first, second) = (report(), report());
    assert!(first == second, "the bytes differ");
    let names: Vec<&str> = first.keys().map(String::as_str).collect();
    assert_eq!(
        names,
        [
            "documents.json",
            "gallery.md",
            "index.html",
            "mini-erratum.md",
            "mini-erratum.pdf",
            "mini-erratum.tex",
            "mini.html",
            "mini.pdf",
            "summary.pdf",
            "verdicts.csv",
            "verdicts.json"
        ]
    );
    assert!(first["mini.pdf"].starts_with(b"%PDF-") && first["summary.pdf"].starts_with(b"%PDF-"));
    let verdicts = on(folder.path(), &["verify", "--format", "json"]).out;
    assert_eq!(first["verdicts.json"], verdicts.as_bytes());
    let table = String::from_utf8(first["verdicts.csv"].clone()).unwrap();
    let rows: Vec<&str> = table.lines().collect();
    assert_eq!(
        rows,
        [
            "id,verdict,evidence,replayed,netted,kernel",
            "mini/right,holds,identity,yes,yes,",
            "mini/wrong,false,witness,yes,yes,",
        ]
    );
}

/// A figure of the paper `mini` beside its claim `a`.
const PARABOLA: &str = "
[[figure]]
id = 'mini/parabola'
claims = ['mini/a']
title = 'A parabola'
caption = 'A parabola.'
alt = 'A curve that opens upwards.'
assumes = ['the scale']
[[figure.panel]]
layer = [{ draw = 'curve', at = '[x, x^2]', over = ['x'] }]
";

#[test]
fn figures_belong_to_their_papers_and_come_as_pixels_and_as_drawings() {
    let folder = mini(&claim("a", "x == x", ""));
    for id in ["first", "second"] {
        let claims = claim("a", "x == x", "") + PARABOLA;
        add_paper(
            folder.path(),
            id,
            &claims.replace("mini/", &format!("{id}/")),
        );
    }
    let figures_of = |papers: &[&str]| {
        let out = TempDir::new().unwrap();
        let path = out.path().to_str().unwrap();
        let ran = on(
            folder.path(),
            &[&["report", "--out", path], papers].concat(),
        );
        assert_eq!(ran.code, Some(0), "{}", ran.err);
        let mut files = files(out.path());
        for name in files.keys().filter(|name| !name.starts_with("figures/")) {
            assert!(ran.out.contains(name), "{name}: {}", ran.out);
        }
        let figures = files.keys().filter(|name| name.ends_with(".svg")).count();
        assert!(
            figures == 0 || ran.out.contains(&format!(" and {figures} figure")),
            "{}",
            ran.out
        );
        files.retain(|name, _| name.starts_with("figures/") && !name.ends_with(".json"));
        files
    };
    let names = |files: &BTreeMap<String, Vec<u8>>| files.keys().cloned().collect::<Vec<_>>();
    let all = figures_of(&[]);
    assert_eq!(
        names(&all),
        ["first-parabola", "second-parabola"]
            .iter()
            .flat_map(|name| ["png", "svg"].map(|kind| format!("figures/{name}.{kind}")))
            .collect::<Vec<_>>()
    );
    for (name, bytes) in &all {
        let magic: &[u8] = if name.ends_with("png") {
            b"\x89PNG"
        } else {
            b"<svg"
        };
        assert!(bytes.starts_with(magic), "{name}");
    }
    let own = figures_of(&["second"]);
    assert_eq!(names(&own), names(&all)[2..]);
    assert!(
        own.iter().all(|(name, bytes)| all[name] == *bytes),
        "the bytes differ"
    );
    assert!(figures_of(&["mini"]).is_empty());
}

#[test]
fn a_figure_is_drawn_again_only_when_it_changed_or_a_file_is_missing() {
    let folder = mini(&(claim("a", "x == x", "") + PARABOLA));
    let out = TempDir::new().unwrap();
    let report = || {
        let path = out.path().to_str().unwrap();
        let ran = on(folder.path(), &["report", "--out", path]);
        assert_eq!(ran.code, Some(0), "{}", ran.err);
        files(out.path())
    };
    let first = report();
    let drawing = out.path().join("figures/mini-parabola.svg");
    let marked = [
        first["figures/mini-parabola.svg"].as_slice(),
        b"<!-- kept -->",
    ]
    .concat();
    fs::write(&drawing, &marked).unwrap();
    assert!(
        report()["figures/mini-parabola.svg"] == marked,
        "drawn again"
    );
    fs::remove_file(out.path().join("figures/mini-parabola.png")).unwrap();
    assert!(report() == first, "the missing file was not drawn again");
    fs::write(&drawing, &marked).unwrap();
    let claims = folder.path().join("mini/claims.toml");
    let text = fs::read_to_string(&claims).unwrap();
    fs::write(&claims, text.replace("x^2", "x^3")).unwrap();
    let changed = report();
    assert!(
        changed["figures/mini-parabola.svg"] != marked,
        "kept though it changed"
    );
    assert!(changed["figures/fingerprints.json"] != first["figures/fingerprints.json"]);
}

#[test]
fn a_document_is_set_again_only_when_it_changed_or_its_file_did() {
    let folder = mini(&claim("a", "x == x", ""));
    let out = TempDir::new().unwrap();
    let report = || {
        let path = out.path().to_str().unwrap();
        let ran = on(folder.path(), &["report", "--out", path]);
        assert_eq!(ran.code, Some(0), "{}", ran.err);
        files(out.path())
    };
    let first = report();
    let (pdf, list) = (
        out.path().join("mini.pdf"),
        out.path().join("documents.json"),
    );
    // A file that is not what was written is written again, and so is one that is missing.
    fs::write(&pdf, b"%PDF- cut off").unwrap();
    assert!(report() == first, "a damaged file was kept");
    fs::remove_file(&pdf).unwrap();
    assert!(report() == first, "a missing file was not set again");
    // Another file is kept where the list says that it is the one that was written.
    let known: serde_json::Value = serde_json::from_slice(&first["documents.json"]).unwrap();
    let digest = torse_report::digest::digest([b"another".as_slice()]);
    let mut other = known.clone();
    other["mini.pdf"]["file"] = digest.into();
    fs::write(&list, other.to_string()).unwrap();
    fs::write(&pdf, b"another").unwrap();
    let kept = report();
    assert!(kept["mini.pdf"] == b"another", "set again");
    assert!(kept["summary.pdf"] == first["summary.pdf"]);
    // And no longer when the paper changed.
    let claims = folder.path().join("mini/claims.toml");
    let text = fs::read_to_string(&claims).unwrap();
    fs::write(&claims, text.replace("x == x", "x + 0 == x")).unwrap();
    let changed = report();
    assert!(changed["mini.pdf"].starts_with(b"%PDF-") && changed["mini.pdf"] != first["mini.pdf"]);
    // A list that cannot be read is none.
    fs::write(&list, "{").unwrap();
    assert!(report() == changed);
}

#[test]
fn page_and_gallery_show_a_figure_with_its_verdict_and_assumptions() {
    let folder = mini(&(claim("a", "x == x", "") + PARABOLA));
    let out = TempDir::new().unwrap();
    on(
        folder.path(),
        &["report", "--out", out.path().to_str().unwrap()],
    );
    let files = files(out.path());
    // What stands inside of the claims of a page is packed; the page itself has the verdict.
    for (name, parts) in [
        (
            "gallery.md",
            &["A parabola.", "partial", "Assumed:", "the scale"][..],
        ),
        ("mini.html", &["partial", "id=\"packed\">"]),
    ] {
        let text = String::from_utf8(files[name].clone()).unwrap();
        for part in parts {
            assert!(text.contains(part), "{name}: {part}");
        }
    }
}

#[test]
fn an_id_that_would_lead_a_file_astray_is_refused() {
    let folder = mini(&claim("a", "x == x", ""));
    let file = folder.path().join("mini/paper.toml");
    for id in ["../mini", "summary", "index", "mini-erratum", ""] {
        let head = fs::read_to_string(&file).unwrap();
        let start = head.find("id = ").unwrap();
        let end = start + head[start..].find('\n').unwrap();
        fs::write(
            &file,
            format!("{}id = \"{id}\"{}", &head[..start], &head[end..]),
        )
        .unwrap();
        let claims = folder.path().join("mini/claims.toml");
        fs::write(
            &claims,
            claim("a", "x == x", "").replace("mini/a", &format!("{id}/a")),
        )
        .unwrap();
        let out = TempDir::new().unwrap();
        let ran = on(
            folder.path(),
            &["report", "--out", out.path().to_str().unwrap()],
        );
        assert_eq!(ran.code, Some(4), "{id}: {}", ran.err);
        assert!(files(out.path()).is_empty());
    }
}

#[test]
fn a_folder_that_cannot_be_written_to_is_named() {
    let folder = mini(&claim("a", "x == x", ""));
    let occupied = folder.path().join("occupied");
    fs::write(&occupied, "a file").unwrap();
    let ran = on(
        folder.path(),
        &["report", "--out", occupied.to_str().unwrap()],
    );
    assert_eq!(ran.code, Some(5), "{}", ran.err);
    assert!(
        ran.err.contains("cannot write") && ran.err.contains("occupied"),
        "{}",
        ran.err
    );
}

#[test]
fn a_report_of_one_paper_decides_that_paper_alone() {
    let folder = mini(&claim("a", "x == x", "expect = 'false'\n"));
    add_paper(
        folder.path(),
        "other",
        &claim("a", "x == x", "").replace("mini/", "other/"),
    );
    let report = |papers: &[&str]| {
        let out = TempDir::new().unwrap();
        let path = out.path().to_str().unwrap();
        let ran = on(
            folder.path(),
            &[&["report", "--out", path], papers].concat(),
        );
        (ran.code, files(out.path()).into_keys().collect::<Vec<_>>())
    };
    assert_eq!(report(&[]).0, Some(1));
    let (code, names) = report(&["other"]);
    assert_eq!(code, Some(0));
    let letters = ["other-erratum.md", "other-erratum.pdf", "other-erratum.tex"];
    let names: Vec<&str> = names.iter().map(String::as_str).collect();
    assert_eq!(
        names,
        [
            &["documents.json"],
            &letters[..],
            &["other.html", "other.pdf"]
        ]
        .concat()
    );
}

#[test]
fn only_papers_are_reported_on() {
    let folder = mini(&claim("a", "x == x", ""));
    let ran = on(folder.path(), &["report", "mini/a"]);
    assert_eq!((ran.code, ran.out.as_str()), (Some(2), ""));
    assert!(ran.err.contains("the papers are mini"), "{}", ran.err);
}
