//! `torse derive` and `torse recheck`.

use crate::support::{claim, mini, on, repository};

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
    let replayed = "3 proofs replayed by a checker without search, 0 out of its reach";
    assert!(ran.out.contains(replayed), "{}", ran.out);
}
