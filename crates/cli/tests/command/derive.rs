//! `torse derive` and `torse recheck`.

use crate::support::{claim, mini, on, repository};
use std::fs;
use std::path::Path;
use std::process::Command;
use tempfile::TempDir;

#[test]
fn the_c3_join_of_symbolic_degrees_is_printed_in_every_language() {
    for (language, mark) in [
        ("text", "Q1[3]"),
        ("latex", "\\begin{align*}"),
        ("typst", "frac("),
        ("rust", "fn "),
        ("sympy", "import"),
    ] {
        let command = [
            "derive",
            "gbt-surfaces",
            "f",
            "--join",
            "c",
            "--language",
            language,
        ];
        let ran = on(&repository(), &command);
        assert_eq!(ran.code, Some(0), "{}", ran.err);
        assert!(ran.out.contains(mark), "{language}: {}", ran.out);
        assert_eq!(ran.out, on(&repository(), &command).out, "{language}");
    }
}

#[test]
fn the_geometric_joins_use_their_own_factors() {
    for (join, factors) in [
        ("g1", &["gamma"][..]),
        ("farin-boehm", &[]),
        ("beta", &["gamma", "lambda"]),
    ] {
        let ran = on(
            &repository(),
            &["derive", "gbt-developable", "g", "--join", join],
        );
        assert_eq!(ran.code, Some(0), "{}", ran.err);
        for factor in ["gamma", "lambda"] {
            let used = ran.out.contains(factor);
            assert_eq!(used, factors.contains(&factor), "{join}: {}", ran.out);
        }
    }
}

#[test]
fn an_unknown_basis_or_order_is_a_usage_error_that_names_what_there_is() {
    let ran = on(&repository(), &["derive", "bezier", "b"]);
    assert_eq!(ran.code, Some(2), "{}", ran.err);
    assert!(ran.err.contains("its bases are: B"), "{}", ran.err);
    let ran = on(&repository(), &["derive", "bezier", "B", "--order", "0"]);
    assert_eq!(ran.code, Some(2), "{}", ran.err);
    assert!(ran.err.contains("between 1 and"), "{}", ran.err);
    let ran = on(&repository(), &["derive", "splines", "U"]);
    assert_eq!(ran.code, Some(2), "{}", ran.err);
    assert!(ran.err.contains("`--degree`"), "{}", ran.err);
}

#[test]
fn verdicts_are_judged_again_and_counted() {
    let claims = [
        claim("right", "(x + 1)^2 == x^2 + 2*x + 1", ""),
        claim("wrong", "x^2 == x", ""),
        claim("range", "x >= 0", ""),
        claim("nowhere", "x == 2", "assume = ['x > 3']"),
    ];
    let folder = mini(&claims.concat());
    let ran = on(folder.path(), &["recheck", "--verbose"]);
    assert_eq!(ran.code, Some(0), "{}", ran.err);
    assert!(
        ran.out
            .contains("3 netted, 0 contradicted, 1 decided and not netted, 0 without"),
        "{}",
        ran.out
    );
    let replayed = "3 proofs replayed by the checker, 0 out of its reach";
    assert!(ran.out.contains(replayed), "{}", ran.out);
}

/// Trigonometric in radians, hyperbolic, rational, polynomial, with parameters that are called as the derivation calls its own.
const FAMILIES: &str = r#"
[symbols]
t = { in = "[0, pi/2]" }
lambda = { in = "[0, 1]" }
gamma = { in = "[0, 1]" }
m = { in = "[0, 1]" }
k = { in = "(0, inf)" }
w = { in = "(0, 1)" }
Q = { in = "(0, inf)" }
n = { integer = ">= 2" }

[basis.trigonometric]
variable = "t"
parameters = ["lambda"]
degree = 2
seeds = ['(1 - sin(t))*(1 - lambda*sin(t))', '1 - (1 - sin(t))*(1 - lambda*sin(t)) - (1 - cos(t))', '1 - cos(t)']
step = ['cos(t)^2', 'sin(t)^2']

[basis.hyperbolic]
variable = "x"
parameters = ["k"]
degree = 2
seeds = ['(cosh(k*(1 - x)) - 1)/(cosh(k) - 1)', '1 - (cosh(k*(1 - x)) - 1)/(cosh(k) - 1) - (cosh(k*x) - 1)/(cosh(k) - 1)', '(cosh(k*x) - 1)/(cosh(k) - 1)']
step = ['1 - x', 'x']

[basis.rational]
variable = "x"
parameters = ["Q"]
degree = 2
seeds = ['(1 - x)^2/((1 - x)^2 + 2*Q*x*(1 - x) + x^2)', '2*Q*x*(1 - x)/((1 - x)^2 + 2*Q*x*(1 - x) + x^2)', 'x^2/((1 - x)^2 + 2*Q*x*(1 - x) + x^2)']
step = ['1 - x', 'x']

[basis.named]
variable = "x"
parameters = ["lambda", "gamma", "m"]
degree = 2
seeds = ['(1 - x)^2*(1 + lambda*x)*(1 + gamma*x)', '1 - (1 - x)^2*(1 + lambda*x)*(1 + gamma*x) - x^2*(1 + m*(1 - x))', 'x^2*(1 + m*(1 - x))']
step = ['1 - x', 'x']

[basis.plain]
variable = "x"
degree = 0
seeds = ['1']
step = ['1 - x', 'x']

[basis.uniform]
variable = "x"
degree = 0
seeds = ['1']
index = "i"
order = "k"
step = ['(i + 1 - x)/k', '(x + k - i)/k']

[basis.listed]
variable = "x"
parameters = ["w"]
degree = 2
seeds = ['(1 - x)^2*(1 + w*x)', '1 - (1 - x)^2*(1 + w*x) - x^2*(1 + w*(1 - x))', 'x^2*(1 + w*(1 - x))']
"#;

#[test]
fn what_is_printed_of_other_families_runs_and_agrees() {
    let folder = mini(&(FAMILIES.to_owned() + &claim("one", "x - x == 0", "")));
    let code = TempDir::new().unwrap();
    for (basis, more) in [
        ("trigonometric", &[][..]),
        ("hyperbolic", &[]),
        ("rational", &[]),
        ("named", &[]),
        ("plain", &["--rational"]),
        ("uniform", &["--degree", "3"]),
        ("listed", &["--rational"]),
    ] {
        for join in ["", "c", "g1", "farin-boehm", "beta"] {
            // A step of second order at the ends leaves the third derivative without its point.
            let mut command = vec!["derive", "mini", basis];
            command.extend(more);
            match join {
                "" => command.extend(["--order", "3"]),
                "c" => command.extend(["--join", join, "--order", "2"]),
                _ => command.extend(["--join", join]),
            }
            for (language, ending) in [("sympy", "py"), ("rust", "rs")] {
                command.extend(["--language", language]);
                let ran = on(folder.path(), &command);
                assert_eq!(ran.code, Some(0), "{basis} {join}: {}", ran.err);
                let file = format!("{basis}_{}.{ending}", join.replace('-', "_"));
                fs::write(code.path().join(file), ran.out).unwrap();
                command.truncate(command.len() - 2);
            }
        }
    }
    let script = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/command/derived.py");
    let sympy = Command::new("python3")
        .args(["-c", "import sympy"])
        .output();
    if !sympy.is_ok_and(|found| found.status.success()) {
        eprintln!("not run: there is no SymPy");
        return;
    }
    let run = Command::new("python3")
        .arg(script)
        .arg(code.path())
        .output();
    let run = run.unwrap();
    let said = String::from_utf8_lossy(&run.stdout);
    let errors = String::from_utf8_lossy(&run.stderr);
    assert!(run.status.success(), "{said}{errors}");
    assert!(said.contains("35 derivations agree"), "{said}");
}
