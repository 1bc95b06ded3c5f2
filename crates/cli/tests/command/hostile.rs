//! Claims that ask for more than any machine has: each ends within the budget of work, in little memory, with a verdict
//! or a reason.

use crate::support::{claim, measured, mini, timed};
use std::fmt::Write;
use std::fs;
use std::path::Path;

/// What a run may hold in memory, in kilobytes.
const MEMORY: u64 = 1_000_000;
/// Less than a claim gets unless told otherwise: the work grows in proportion, the memory does not.
const BUDGET: &str = "30000000";

/// Decides one claim with these symbols and fields and returns its verdict; a file that is refused has none.
#[track_caller]
fn decided(states: &str, fields: &str) -> Option<String> {
    let folder = mini(&claim("a", states, fields));
    let (ran, kilobytes) = measured(
        folder.path(),
        &["verify", "--format", "json", "--budget", BUDGET],
    );
    let shown: String = states.chars().take(60).collect();
    assert!(
        matches!(ran.code, Some(0 | 3 | 4)),
        "{shown}: {:?} {}",
        ran.code,
        ran.err
    );
    assert!(kilobytes < MEMORY, "{shown}: {kilobytes} kB");
    if ran.code == Some(4) {
        assert!(
            ran.err.contains("mini/claims.toml:"),
            "{shown}: {}",
            ran.err
        );
        return None;
    }
    let all: serde_json::Value = serde_json::from_str(&ran.out).unwrap();
    let verdict = all["claims"][0]["verdict"].as_str().unwrap();
    Some(verdict.to_owned())
}

/// `{ a = {}, b = {}, ... }` for this many symbols.
fn symbols(names: &[String], set: &str) -> String {
    let each: Vec<String> = names.iter().map(|name| format!("{name} = {set}")).collect();
    format!("symbols = {{ {} }}", each.join(", "))
}

fn names(count: usize) -> Vec<String> {
    (0..count).map(|n| format!("v{n}")).collect()
}

#[test]
fn powers_of_powers_end() {
    let y = symbols(&["y".to_owned()], "{}");
    assert_ne!(decided("((y^200)^160) == 0", &y).as_deref(), Some("holds"));
    let tower = decided("((9^200)^200)^200 > 0", "");
    assert_eq!(tower.as_deref(), Some("undecided"));
    decided("((x + 2)^200)^160 > 0", "");
}

#[test]
fn long_sums_and_conjunctions_end() {
    decided(&format!("{}x == 0", "x + ".repeat(10_000)), "");
    decided(&format!("{}x == x", "x == x and ".repeat(5_000)), "");
}

#[test]
fn long_numbers_end() {
    let digits = "3".repeat(70_000);
    decided(&format!("agrees(1/3, 0.{digits})"), "");
    decided(&format!("sqrt({}) > 0", "7".repeat(3_000)), "");
    decided(&format!("{} > 0", "7".repeat(1_000_000)), "");
}

#[test]
fn order_relations_of_many_variables_end() {
    let twelve = names(12);
    let squares: Vec<String> = twelve.iter().map(|v| format!("({v} - 1/3)^2")).collect();
    let fields = symbols(&twelve, "{ in = \"[0, 1]\" }");
    decided(&format!("{} > 0", squares.join(" + ")), &fields);
    decided(&format!("({} + 1)^8 > 1/1000", twelve.join("*")), &fields);
    let two = "symbols = { y = { in = \"[0, 1]\" }, c = { in = \"[0, 1]\" } }";
    decided("(x - 1/3)^60*(y - 1/7)^60 + c > 0", two);
    let mu = "symbols = { mu = { in = \"[-1, 1]\" } }";
    assert_eq!(
        decided("sqrt(2)*(2 + pi*mu) > 0", mu).as_deref(),
        Some("false")
    );
}

#[test]
fn large_powers_of_sums_end() {
    let six = names(6);
    decided(
        &format!("({})^40 == 0", six.join(" + ")),
        &symbols(&six, "{}"),
    );
}

#[test]
fn large_matrices_end() {
    let rows = |size: usize, entry: &dyn Fn(usize, usize) -> String| {
        let row = |i: usize| {
            let entries: Vec<String> = (0..size).map(|j| entry(i, j)).collect();
            format!("[{}]", entries.join(", "))
        };
        let rows: Vec<String> = (0..size).map(row).collect();
        format!("[{}]", rows.join(", "))
    };
    let power = |i: usize, j: usize| format!("(x + {})^{}", i + 1, j + 1);
    decided(&format!("det({}) == 0", rows(14, &power)), "");
    let all: Vec<String> = (0..64).map(|n| format!("v{n}")).collect();
    let symbol = |i: usize, j: usize| format!("v{}", 8 * i + j);
    let inverse = format!("inverse({})[1,1] == 0", rows(8, &symbol));
    decided(&inverse, &symbols(&all, "{}"));
}

#[test]
fn many_derivatives_end() {
    let body = "D((sin(pi/2*x)*x + cos(pi/2*x))^9, x, 12)";
    decided(&format!("sum(i, 1, 390, i*{body}) == 0"), "");
}

#[test]
fn many_integers_end() {
    let fourteen = names(14);
    let fields = symbols(&fourteen, "{ integer = \">= 0\" }");
    decided(&format!("{} >= 0", fourteen.join(" + ")), &fields);
    let odd = format!("sum(i, 0, {}, i) == x", fourteen.join("*"));
    decided(&odd, &fields);
}

#[test]
fn a_slip_that_no_search_finds_leaves_the_verdict() {
    let mut printed =
        String::from("(cos(r) + 3)*(3*x + y - sin(r)*cos(r))^2 == 9*x^2*cos(r) + 27*x^2");
    let rest = " + 6*x*y*cos(r) + 19*x*y - 6*x*sin(r)*cos(r)^2 - 18*x*sin(r)*cos(r) + y^2*cos(r) + 3*y^2 \
                - 2*y*sin(r)*cos(r)^2 - 6*y*sin(r)*cos(r) + sin(r)^2*cos(r)^3 + 3*sin(r)^2*cos(r)^2";
    write!(printed, "{rest}").unwrap();
    let fields = "symbols = { y = { in = \"[0, 1]\" }, r = {} }";
    let found = decided(&printed, fields);
    assert!(
        matches!(found.as_deref(), Some("false" | "misprint")),
        "{found:?}"
    );
}

#[test]
fn a_small_budget_leaves_claims_undecided_with_the_reason_and_a_large_one_does_not() {
    let folder = mini(&claim("a", "(x + 1)^30 == (x + 1)^15*(1 + x)^15", ""));
    let told = |budget: &str| {
        let words = ["explain", "mini/a", "--budget", budget];
        measured(folder.path(), &words).0.out
    };
    let small = told("10");
    assert!(small.contains("undecided"), "{small}");
    assert!(small.contains("budget of 10 units"), "{small}");
    assert!(told("1000000").contains("holds"));
}

/// What a run may take of the processor, in seconds, with the standard budget.
const SECONDS: f64 = 20.0;

/// Verifies a folder within bounds of memory and time, and returns how it ended and all that was said.
#[track_caller]
fn verified(folder: &Path) -> (Option<i32>, String) {
    let (ran, kilobytes, seconds) = timed(folder, &["verify", "--format", "json"]);
    let said = ran.out + &ran.err;
    let shown: String = said.chars().take(2000).collect();
    assert!(kilobytes < MEMORY, "{kilobytes} kB: {shown}");
    assert!(seconds < SECONDS, "{seconds} s: {shown}");
    (ran.code, said)
}

/// A folder that is kept beside these tests.
fn kept(name: &str) -> std::path::PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR"))
        .join("tests/hostile")
        .join(name)
}

#[test]
fn statements_that_double_at_every_definition_are_undecided_and_say_why() {
    let (code, said) = verified(&kept("doubled-statements"));
    assert_eq!(code, Some(0), "{said}");
    assert!(said.contains("\"undecided\""), "{said}");
    let why = timed(&kept("doubled-statements"), &["explain", "z/c"])
        .0
        .out;
    assert!(why.contains("opens to more than"), "{why}");
}

#[test]
fn a_determinant_of_many_symbols_is_undecided_for_want_of_work_or_memory() {
    let (code, said) = verified(&kept("determinant"));
    assert_eq!(code, Some(0), "{said}");
    assert!(said.contains("\"undecided\""), "{said}");
    let why = timed(&kept("determinant"), &["explain", "z/c"]).0.out;
    assert!(
        why.contains("bytes at once") || why.contains("budget of"),
        "{why}"
    );
}

#[test]
fn a_paper_whose_id_is_a_path_is_refused_and_nothing_is_written_outside() {
    let proofs = tempfile::TempDir::new().unwrap();
    let inside = proofs.path().join("a/b");
    let command = ["verify", "--proofs", inside.to_str().unwrap()];
    let (ran, _, _) = timed(&kept("path-escape"), &command);
    assert_eq!(ran.code, Some(4), "{}", ran.err);
    assert!(ran.err.contains("z/paper.toml:"), "{}", ran.err);
    let beside = |folder: &Path| fs::read_dir(folder).map_or(0, Iterator::count);
    assert!(beside(proofs.path()) <= 1 && !proofs.path().join("evil").exists());
}

#[test]
fn thousands_of_readings_are_refused() {
    let mut claims = String::from(
        "[[claim]]\nid = \"mini/c\"\nat = \"a\"\nkind = \"property\"\nprinted = \"p\"\n",
    );
    for n in 0..5000 {
        let reading = "[[claim.readings]]\nname = \"nN\"\nsays = \"s\"\nstates = \"x == x\"\n";
        claims.push_str(&reading.replace("nN", &format!("n{n}")));
    }
    let (code, said) = verified(mini(&claims).path());
    assert_eq!(code, Some(4), "{said}");
    assert!(
        said.contains("16 readings at most, and this has 5000"),
        "{said}"
    );
}

#[test]
fn a_file_of_many_mistakes_holds_its_text_once() {
    let mut claims = String::new();
    for n in 0..2000 {
        claims.push_str(&claim(
            &format!("c{n}"),
            "x + == 2",
            &"# a long line of the file\n".repeat(20),
        ));
    }
    let (code, said) = verified(mini(&claims).path());
    assert_eq!(code, Some(4));
    assert!(said.contains("1900 further mistakes are not shown"));
}

#[test]
fn chains_of_alternatives_end() {
    let links: Vec<String> = (0..3200).map(|n| format!("x == {n}/3200")).collect();
    let (code, said) = verified(mini(&claim("c", &links.join(" or "), "")).path());
    assert!(matches!(code, Some(0)), "{said}");
}

#[test]
fn powers_of_sines_end() {
    let states = "sin(x)^200 + cos(x)^200 <= 1";
    let (code, said) = verified(mini(&claim("c", states, "")).path());
    assert!(matches!(code, Some(0)), "{said}");
}

#[test]
fn hundreds_of_hypotheses_of_ours_end() {
    let each = |n: usize| format!("{{ states = \"x != {n}/201\", ours = \"why\" }}");
    let all: Vec<String> = (1..201).map(each).collect();
    let fields = format!("assume = [{}]", all.join(", "));
    let (code, said) = verified(mini(&claim("c", "(x + 1)^2 == x^2 + 2*x + 1", &fields)).path());
    assert!(matches!(code, Some(0)), "{said}");
    assert!(said.contains("\"holds\""), "{said}");
}
