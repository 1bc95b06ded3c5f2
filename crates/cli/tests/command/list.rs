//! `torse list` and `torse completions`.

use crate::support::{claim, mini, on, torse};

#[test]
fn claims_and_papers_are_listed_without_deciding_any() {
    let second = claim("b", "x == 2*x", "uses = ['mini/a']");
    let folder = mini(&[claim("a", "x == x", ""), second].concat());
    let list = |arguments: &[&str]| {
        let ran = on(folder.path(), &[&["list"], arguments].concat());
        assert_eq!(ran.code, Some(0), "{}", ran.err);
        ran.out
    };
    let claims = list(&[]);
    let ids: Vec<&str> = claims
        .lines()
        .filter_map(|line| line.split_whitespace().next())
        .collect();
    assert_eq!(ids, ["mini/a", "mini/b"]);
    assert!(list(&["--papers"]).contains("2 claims"));
    let lines = list(&["mini/b", "--format", "json"]);
    let (line, last) = lines.split_once('\n').unwrap();
    assert_eq!(last, "{\"claims\":1,\"exit\":0}\n");
    let line: serde_json::Value = serde_json::from_str(line).unwrap();
    assert_eq!(line["id"], "mini/b");
    assert_eq!(line["uses"][0], "mini/a");
    let lines = list(&["--papers", "--format", "json"]);
    let line: serde_json::Value = serde_json::from_str(&lines).unwrap();
    assert_eq!(
        (&line["paper"], &line["claims"]),
        (&"mini".into(), &2.into())
    );
}

#[test]
fn every_shell_gets_completions_that_name_every_subcommand() {
    for shell in ["bash", "zsh", "fish", "elvish", "powershell"] {
        let ran = torse(&["completions", shell]);
        assert_eq!(ran.code, Some(0), "{shell}: {}", ran.err);
        for command in ["verify", "decide", "unroll", "completions"] {
            assert!(ran.out.contains(command), "{shell}: {command}");
        }
    }
}
