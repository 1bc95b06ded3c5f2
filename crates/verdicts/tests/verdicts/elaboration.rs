//! Deliberate mistakes of the elaborator, one for each construct, and the judge that sees them: core terms and trees are compared
//! by their values. There are mistakes with debug assertions alone: a release has none to choose.
#![cfg(debug_assertions)]

use crate::common;

use torse_elaborate::elaborate;
use torse_numbers::fault_injection::{InjectedFault, with};
use torse_syntax::derivation::Claim;
use torse_syntax::taxonomy::Verdict;
use torse_verdicts::agreement::{Agreement, agreement};
use torse_verdicts::engine::decide_claim;
use torse_verdicts::words;

const DECLARATIONS: &str = r#"
[symbols]
x = { in = "[0, 1]" }
u = {}
v = {}
a = {}
b = {}
c = { in = "[0, 2]" }
m = { in = "[1, 3]" }
r = { in = "[0, 1)" }
f = { function = 1 }
[define]
G = 'a*x'
"F(s, t)" = 's^2*t'
[basis.A]
variable = "x"
degree = 1
seeds = ['1 - c*x', 'c*x']
step = ['1 - x', 'x']
[basis.B]
variable = "x"
degree = 1
seeds = ['1 - x/m', 'x/m']
step = ['1 - x', 'x']
"#;

/// A fault, the fields of a claim that uses the construct, and a part of what is said of it.
const CASES: [(InjectedFault, &str, &str); 14] = [
    (
        InjectedFault::OrdersByMaximum,
        "states = 'D(D(f(u*v), v), u) == 0'",
        "`D(D(f(u*v), v), u)`",
    ),
    (
        InjectedFault::PropertyOutsideScope,
        "states = 'at(nonnegative(A), c, 1/2)'",
        "a side of `nonnegative",
    ),
    (
        InjectedFault::DefinitionOutsideScope,
        "states = 'b + D(G, x) == b'",
        "`D(G, x)`",
    ),
    (
        InjectedFault::IndexCaptured,
        "states = 'sum(a, 1, 2, G) == 3*x'",
        "`sum(a, 1, 2, G)`",
    ),
    (
        InjectedFault::LeftOutNotMoved,
        "states = 'at(B[0,1], x, 1/2) == B[0,1]'",
        "`at(B[0,1], x, 1/2)`",
    ),
    (
        InjectedFault::SeedOverlooked,
        "states = 'sqrt(B[0,1](x)) == at(sqrt(B[0,1](x)), m, 2)'",
        "one reading has no value",
    ),
    (
        InjectedFault::LogarithmWithoutEarlier,
        "states = 'D(log(b), b, 2) == 0'",
        "`D(log(b), b, 2)`",
    ),
    (
        InjectedFault::ArcWithoutEarlier,
        "states = 'D(atan(b), b, 2) == 0'",
        "`D(atan(b), b, 2)`",
    ),
    (
        InjectedFault::DenialOfBoth,
        "states = 'not (a == 0 and b == 0) implies a*b != 0'",
        "state something else than the text",
    ),
    (
        InjectedFault::ChainFromFirst,
        "assume = ['a < b < c']\nstates = 'a < c'",
        "in hypothesis 1, `b`",
    ),
    (
        InjectedFault::PrimesOnce,
        "states = \"F''(a, b) == 2*a*b\"",
        "`F''(a, b)`",
    ),
    (
        InjectedFault::EndsExchanged,
        "states = 'integral(x, x, 0, 1) == -1/2'",
        "`integral(x, x, 0, 1)`",
    ),
    (
        InjectedFault::FirstParameter,
        "states = 'D(F, t)(a, b) == 2*a*b'",
        "`D(F, t)(a, b)`",
    ),
    (
        InjectedFault::OpenEndIncluded,
        "exists = ['r == 1']\nstates = 'r == 1'",
        "state something else than the text",
    ),
];

fn claim(lines: &str) -> Claim {
    let paper = common::loaded("elaboration", DECLARATIONS, &[lines]).unwrap();
    paper.claims.into_iter().next().unwrap()
}

fn compared(claim: &Claim, fault: Option<InjectedFault>) -> Agreement {
    let statement = claim.statement.as_ref().unwrap();
    let elaborated = || elaborate(claim, statement).unwrap();
    // The root of a formula becomes a symbol where it is compared.
    match fault {
        None => agreement(claim, statement, &elaborated()),
        Some(fault) => with(fault, || agreement(claim, statement, &elaborated())),
    }
}

#[test]
fn every_fault_of_the_elaborator_is_seen_and_named() {
    let mut wrong = vec![];
    for (fault, lines, named) in CASES {
        let claim = claim(lines);
        let clean = compared(&claim, None);
        let faulty = compared(&claim, Some(fault));
        let seen = matches!(&faulty, Agreement::Differs(found) if found.contains(named));
        if clean != Agreement::Same || !seen {
            wrong.push(format!("{fault:?}: {clean:?}, then {faulty:?}"));
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

#[test]
fn no_verdict_is_shown_that_rests_on_a_fault_of_the_elaborator() {
    let mut wrong = vec![];
    for (fault, lines, _) in CASES {
        let claim = claim(lines);
        // A formula that makes no sense any more has no verdict either.
        let Ok(outcome) = with(fault, || decide_claim("elaboration", &claim)) else {
            continue;
        };
        if outcome.verdict() != Verdict::Undecided {
            wrong.push(format!(
                "{fault:?}: {:?} {:?}",
                outcome.verdict(),
                words::steps(&outcome)
            ));
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}
