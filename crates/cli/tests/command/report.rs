//! `torse report`: the files it writes.

use crate::support::{claim, mini, on, repository};
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
        ["mini.html", "mini.pdf", "summary.pdf", "verdicts.json"]
    );
    assert!(first["mini.pdf"].starts_with(b"%PDF-") && first["summary.pdf"].starts_with(b"%PDF-"));
    let verdicts = on(folder.path(), &["verify", "--format", "json"]).out;
    assert_eq!(first["verdicts.json"], verdicts.as_bytes());
}

#[test]
fn the_reports_of_the_three_papers_come_with_their_figures() {
    let out = TempDir::new().unwrap();
    let path = out.path().to_str().unwrap();
    let ran = on(&repository(), &["report", "--out", path]);
    assert_eq!(ran.code, Some(0), "{}", ran.err);
    let files = files(out.path());
    for paper in ["gbt-developable", "gbt-surfaces", "hermite-developable"] {
        assert!(files[&format!("{paper}.pdf")].starts_with(b"%PDF-"));
        let html = String::from_utf8_lossy(&files[&format!("{paper}.html")]).into_owned();
        assert!(html.contains(&format!("torse explain {paper}/")), "{paper}");
    }
    for figure in [
        "gbt-developable-fig-1",
        "gbt-developable-ex-4.1",
        "hermite-developable-fig-4a",
    ] {
        assert!(files[&format!("figures/{figure}.png")].starts_with(b"\x89PNG"));
        assert!(files[&format!("figures/{figure}.svg")].starts_with(b"<svg"));
    }
    assert!(ran.out.contains("summary.pdf"), "{}", ran.out);
}

#[test]
fn an_id_that_would_lead_a_file_astray_is_refused() {
    let folder = mini(&claim("a", "x == x", ""));
    let file = folder.path().join("mini/paper.toml");
    for id in ["../mini", "summary", ""] {
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
fn only_papers_are_reported_on() {
    let folder = mini(&claim("a", "x == x", ""));
    let ran = on(folder.path(), &["report", "mini/a"]);
    assert_eq!((ran.code, ran.out.as_str()), (Some(2), ""));
    assert!(ran.err.contains("the papers are mini"), "{}", ran.err);
}
