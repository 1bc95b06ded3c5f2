//! What comes in from outside: its licences, where it comes from, and the compiler it needs.
//!
//! Read off what cargo itself says about the locked packages of this platform, so that it is tested on every
//! machine; `cargo deny` (see `deny.toml`) looks at all platforms, and at advisories.

#![allow(clippy::unwrap_used, reason = "helpers of tests")]

use serde_json::Value;
use std::collections::BTreeSet;
use std::process::Command;

const ROOT: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/..");

/// The packages that are built here, as `cargo metadata` describes them.
fn packages() -> Vec<Value> {
    let version = Command::new(env!("CARGO")).arg("-vV").output().unwrap();
    let version = String::from_utf8(version.stdout).unwrap();
    let host = version.lines().find_map(|line| line.strip_prefix("host: "));
    let described = Command::new(env!("CARGO"))
        .current_dir(ROOT)
        .args(["metadata", "--format-version=1", "--locked", "--offline"])
        .args(["--filter-platform", host.unwrap()])
        .output()
        .unwrap();
    let errors = String::from_utf8_lossy(&described.stderr);
    assert!(described.status.success(), "{errors}");
    let described: Value = serde_json::from_slice(&described.stdout).unwrap();
    let packages = described["packages"].as_array().unwrap();
    assert!(packages.len() > 100, "{} packages", packages.len());
    packages.clone()
}

fn name(package: &Value) -> String {
    let text = |key: &str| package[key].as_str().unwrap().to_owned();
    format!("{} {}", text("name"), text("version"))
}

/// The numbers of a version such as `1.92` or `1.92.0`, which are the same.
fn numbers(version: &str) -> [u32; 3] {
    let mut numbers = [0; 3];
    for (number, text) in numbers.iter_mut().zip(version.split('.')) {
        *number = text.parse().unwrap();
    }
    numbers
}

/// Whether a licence expression can be met with the licences allowed. It is read as a conjunction of
/// alternatives; where it is none, this asks for more than it does.
fn is_met(expression: &str, allowed: &[String]) -> bool {
    let expression = expression.replace(" / ", " OR ").replace('/', " OR ");
    expression.split(" AND ").all(|alternatives| {
        let alternatives = alternatives.split(" OR ");
        let mut licences = alternatives.map(|licence| licence.trim_matches(['(', ')', ' ']));
        licences.any(|licence| allowed.iter().any(|other| other == licence))
    })
}

fn allowed() -> Vec<String> {
    let text = std::fs::read_to_string(format!("{ROOT}/deny.toml")).unwrap();
    let table: toml::Table = text.parse().unwrap();
    let allowed = table["licenses"]["allow"].as_array().unwrap();
    let licences = allowed.iter().map(|licence| licence.as_str().unwrap());
    licences.map(str::to_owned).collect()
}

#[test]
fn no_package_needs_a_newer_compiler_than_the_one_that_is_stated() {
    let packages = packages();
    let needs = |package: &Value| package["rust_version"].as_str().map(numbers);
    let ours = packages
        .iter()
        .filter(|package| package["source"].is_null());
    let stated: Vec<_> = ours.map(|package| needs(package).unwrap()).collect();
    assert!(stated.windows(2).all(|pair| pair[0] == pair[1]));
    let newer = packages.iter().filter(|p| needs(p) > Some(stated[0]));
    assert_eq!(newer.map(name).collect::<Vec<_>>(), [""; 0]);
    assert!(numbers("1.100") > numbers("1.92.1"));
    assert_eq!(numbers("1.92"), numbers("1.92.0"));
}

#[test]
fn every_package_has_a_licence_that_is_allowed() {
    let allowed = allowed();
    let met = |package: &Value| {
        let licence = package["license"].as_str();
        licence.is_some_and(|expression| is_met(expression, &allowed))
    };
    let packages = packages();
    let unmet = packages.iter().filter(|package| !met(package));
    assert_eq!(unmet.map(name).collect::<Vec<_>>(), [""; 0]);
}

#[test]
fn every_package_comes_from_the_registry_or_from_here() {
    let registry = "registry+https://github.com/rust-lang/crates.io-index";
    let elsewhere = |package: &Value| package["source"].as_str().is_some_and(|s| s != registry);
    let packages = packages();
    let wrong = packages.iter().filter(|package| elsewhere(package));
    assert_eq!(wrong.map(name).collect::<Vec<_>>(), [""; 0]);
}

/// The packages of a build with their features.
fn features(options: &[&str]) -> BTreeSet<String> {
    let listed = Command::new(env!("CARGO"))
        .current_dir(ROOT)
        .args(["tree", "--locked", "--offline", "--prefix=none"])
        .arg("--format={p} [{f}]")
        .args(options)
        .output()
        .unwrap();
    let errors = String::from_utf8_lossy(&listed.stderr);
    assert!(listed.status.success(), "{errors}");
    let listed = String::from_utf8(listed.stdout).unwrap();
    // What is listed a second time is marked.
    let listed = listed.lines().map(|line| line.trim_end_matches(" (*)"));
    listed.map(str::to_owned).collect()
}

#[test]
fn what_the_command_is_built_from_is_not_built_again_for_the_tests() {
    let command = features(&["--edges=normal,build"]);
    let tests = features(&["--workspace", "--edges=normal,build,dev"]);
    assert!(command.len() > 100, "{}", command.len());
    let again: Vec<&String> = command.difference(&tests).collect();
    assert_eq!(again, [""; 0]);
}

/// The rows of the tables of `docs/dependencies.md`: the names of a row, and the cell beside them.
fn listed() -> Vec<(Vec<String>, String)> {
    let page = std::fs::read_to_string(format!("{ROOT}/docs/dependencies.md")).unwrap();
    let rows = page.lines().filter_map(|line| {
        let (names, beside) = line
            .strip_prefix("| ")?
            .strip_suffix(" |")?
            .split_once(" | ")?;
        let names = names.split('`').skip(1).step_by(2).map(str::to_owned);
        Some((names.collect(), beside.to_owned()))
    });
    rows.filter(|(names, _): &(Vec<String>, _)| !names.is_empty())
        .collect()
}

#[test]
fn the_page_of_dependencies_has_those_of_the_manifests_and_no_others() {
    let read = |name: &str| std::fs::read_to_string(format!("{ROOT}/{name}")).unwrap();
    let workspace: toml::Table = read("Cargo.toml").parse().unwrap();
    let python: toml::Table = read("python/Cargo.toml").parse().unwrap();
    let tables = [
        &workspace["workspace"]["dependencies"],
        &python["dependencies"],
    ];
    let tables = tables.map(|table| table.as_table().unwrap());
    let named = tables.into_iter().flat_map(toml::Table::keys);
    let outside = named.filter(|name| *name != "torse" && !name.starts_with("torse-"));
    let needed: BTreeSet<String> = outside.cloned().collect();
    let listed: Vec<String> = listed()
        .into_iter()
        .filter(|(_, beside)| beside.parse::<usize>().is_err())
        .flat_map(|(names, _)| names)
        .collect();
    assert_eq!(listed.len(), needed.len());
    assert_eq!(listed.into_iter().collect::<BTreeSet<_>>(), needed);
}

#[test]
fn no_set_of_features_takes_more_packages_than_its_page_says() {
    let mut tried = 0;
    for (names, beside) in listed() {
        let Ok(most) = beside.parse::<usize>() else {
            continue;
        };
        let wanted = format!("--features={}", names.join(" "));
        let options = ["--package=torse", "--no-default-features", &wanted];
        let all = features(&[&options[..], &["--edges=normal,build"]].concat());
        let outside = all.iter().filter(|package| !package.contains("(/"));
        let count = outside.count();
        assert!(
            (most / 2..=most).contains(&count),
            "{names:?}: {count} packages"
        );
        tried += 1;
    }
    assert_eq!(tried, 8);
}

#[test]
fn the_table_of_the_features_of_the_library_is_that_of_its_manifest() {
    let read = |name: &str| std::fs::read_to_string(format!("{ROOT}/crates/torse/{name}")).unwrap();
    let manifest: toml::Table = read("Cargo.toml").parse().unwrap();
    let features = manifest["features"].as_table().unwrap();
    let needs = |name: &str| -> Vec<String> {
        let needs = features[name].as_array().unwrap().iter();
        needs
            .map(|need| need.as_str().unwrap().to_owned())
            .collect()
    };
    let default = needs("default");
    let is_default = |name: &str| {
        let by = default
            .iter()
            .find(|own| needs(own).iter().any(|need| need == name));
        match (default.iter().any(|own| own == name), by) {
            (true, _) => "yes".to_owned(),
            (false, Some(by)) => format!("with `{by}`"),
            (false, None) => "no".to_owned(),
        }
    };
    let names = features.keys().filter(|name| *name != "default");
    let expected: BTreeSet<(String, String)> =
        names.map(|name| (name.clone(), is_default(name))).collect();
    let page = read("src/lib.rs");
    let rows = page.lines().filter_map(|line| {
        let row = line.strip_prefix("//! | `")?.strip_suffix(" |")?;
        let (name, _) = row.split_once('`')?;
        let (_, default) = row.rsplit_once(" | ")?;
        Some((name.to_owned(), default.to_owned()))
    });
    assert_eq!(rows.collect::<BTreeSet<_>>(), expected);
}

#[test]
fn alternatives_need_one_licence_and_conjunctions_all() {
    let allowed = ["MIT".to_owned(), "Unicode-3.0".to_owned()];
    assert!(is_met("Apache-2.0 OR MIT", &allowed));
    assert!(is_met("Unlicense/MIT", &allowed));
    assert!(is_met("(MIT OR Apache-2.0) AND Unicode-3.0", &allowed));
    assert!(!is_met("MIT AND GPL-3.0-only", &allowed));
    assert!(!is_met("MITX", &allowed));
    assert!(!is_met("MPL-2.0", &allowed));
}

#[test]
fn the_citation_names_the_version_and_the_licences_of_the_workspace() {
    let read = |name: &str| std::fs::read_to_string(format!("{ROOT}/{name}")).unwrap();
    let workspace: toml::Table = read("Cargo.toml").parse().unwrap();
    let package = &workspace["workspace"]["package"];
    let citation = read("CITATION.cff");
    let field = |line: &str| citation.lines().any(|own| own.trim() == line);
    assert!(field(&format!(
        "version: {}",
        package["version"].as_str().unwrap()
    )));
    let licences = package["license"].as_str().unwrap();
    for licence in licences.split(" OR ") {
        assert!(field(&format!("- {licence}")), "{licence}");
    }
}
