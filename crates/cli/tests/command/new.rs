//! `torse new`: the folder that it writes.

use crate::support::{torse, torse_in};
use std::fs;
use tempfile::TempDir;

#[test]
fn a_new_folder_verifies_and_all_its_claims_hold() {
    let folder = TempDir::new().unwrap();
    let ran = torse_in(folder.path(), &["new", "my-paper-2"]);
    assert_eq!(ran.code, Some(0), "{}", ran.err);
    assert_eq!(ran.out.lines().count(), 3, "{}", ran.out);
    for line in ran.out.lines().take(2) {
        let text = fs::read_to_string(folder.path().join(line)).unwrap();
        assert!(
            text.contains("my-paper-2") && !text.contains("NAME"),
            "{text}"
        );
    }
    // The figure is checked as well.
    let ran = torse_in(folder.path(), &["verify", "--format", "json"]);
    assert_eq!((ran.code, ran.err.as_str()), (Some(0), ""), "{}", ran.out);
    let holds = ran.out.matches("\"verdict\": \"holds\"").count();
    assert_eq!(holds, 4, "{}", ran.out);
    let ran = torse_in(folder.path(), &["audit", "my-paper-2"]);
    assert_eq!(ran.code, Some(0), "{}", ran.out);
}

#[test]
fn a_new_folder_names_its_schema_which_is_that_of_the_repository() {
    let folder = TempDir::new().unwrap();
    for name in ["one", "two"] {
        let ran = torse_in(folder.path(), &["new", name]);
        assert_eq!(ran.code, Some(0), "{}", ran.err);
        for line in ran.out.lines().filter(|line| line.ends_with(".toml")) {
            let path = folder.path().join(line);
            let text = fs::read_to_string(&path).unwrap();
            let named = text
                .lines()
                .next()
                .unwrap()
                .strip_prefix("#:schema ")
                .unwrap();
            let schema = path.parent().unwrap().join(named);
            let ours = concat!(env!("CARGO_MANIFEST_DIR"), "/../../derivations/schema.json");
            assert_eq!(
                fs::read_to_string(schema).unwrap(),
                fs::read_to_string(ours).unwrap()
            );
        }
    }
    // One that is there is left as it is.
    let schema = folder.path().join("derivations/schema.json");
    fs::write(&schema, "mine").unwrap();
    assert_eq!(torse_in(folder.path(), &["new", "three"]).code, Some(0));
    assert_eq!(fs::read_to_string(schema).unwrap(), "mine");
}

#[test]
fn a_second_folder_goes_beside_the_first_and_none_is_overwritten() {
    let folder = TempDir::new().unwrap();
    let below = folder.path().join("a/b");
    fs::create_dir_all(&below).unwrap();
    assert_eq!(torse_in(folder.path(), &["new", "one"]).code, Some(0));
    let ran = torse_in(&below, &["new", "two"]);
    assert_eq!(ran.code, Some(0), "{}", ran.err);
    assert!(folder.path().join("derivations/two/paper.toml").is_file());
    let kept = folder.path().join("derivations/one/claims.toml");
    fs::write(&kept, "mine").unwrap();
    let ran = torse_in(&below, &["new", "one"]);
    assert_eq!(ran.code, Some(2), "{}", ran.err);
    assert!(ran.err.contains("exists"), "{}", ran.err);
    assert_eq!(fs::read_to_string(kept).unwrap(), "mine");
}

#[test]
fn a_name_that_cannot_begin_an_id_is_refused() {
    for name in ["", "a/b", "..", "a b", "A", "-a", "a-", "summary"] {
        let ran = torse(&["new", "--", name]);
        assert_eq!(ran.code, Some(2), "{name}: {}", ran.out);
    }
}
