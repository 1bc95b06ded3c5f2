//! Deliberate mistakes of the engine, one at a time, and what catches each.
//!
//! For every [`InjectedFault`] there is a claim whose verdict changes with it: the prover alone says something else. What a
//! user sees is then never the wrong verdict. There are mistakes with debug assertions alone: a release has none to choose.
#![cfg(debug_assertions)]
use crate::common;

use torse_numbers::fault_injection::{InjectedFault, with};
use torse_prove::decide::Decision;
use torse_prove::decide_statement;
use torse_syntax::derivation::Claim;
use torse_syntax::taxonomy::Verdict::{self, Conditional, False, Holds, Undecided, Vacuous};
use torse_verdicts::engine::decide_claim;
use torse_verdicts::words;

const DECLARATIONS: &str = r#"
[symbols]
x = { in = "[0, 1]" }
s = { in = "[3/8, 1]" }
t = { in = "[3/8, 1]" }
a = {}
b = {}
n = { integer = ">= 1" }
P = { family = "any", indices = ["0..n"] }
[basis.B]
variable = "x"
degree = 0
seeds = ['1']
step = ['1 - x', 'x']
[basis.G]
variable = "x"
degree = 2
seeds = ['(1 - x)^2', '2*x*(1 - x)', 'x^2']
step = ['1 - x', 'x']
[basis.H]
variable = "x"
degree = 1
seeds = ['1 - x - 6*x*(1 - x)*(1 - 2*x)', 'x + 6*x*(1 - x)*(1 - 2*x)']
step = ['1 - x', 'x']
"#;

/// What shows that the verdict cannot be.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Caught {
    /// The semantics contradicts it at a point of the domain, or at the witness: "internal contradiction".
    Net,
    /// The checker of certificates refuses the proof.
    Replay,
    /// The semantics decides the statement at no point: the verdict is not shown as netted.
    NotNetted,
}

struct PreparedClaim {
    fault: InjectedFault,
    lines: &'static str,
    /// The verdict without the fault.
    right: Verdict,
    caught: Caught,
}

const fn case(
    fault: InjectedFault,
    lines: &'static str,
    right: Verdict,
    caught: Caught,
) -> PreparedClaim {
    PreparedClaim {
        fault,
        lines,
        right,
        caught,
    }
}

const CASES: &[PreparedClaim] = &[
    case(
        InjectedFault::LowerEndForgotten,
        "states = 'integral(2*x + 1, x, 1, b) == b^2 + b'",
        False,
        Caught::Net,
    ),
    case(
        InjectedFault::LastFactorForgotten,
        "states = 'product(i, 1, n, (i + 1)/i) == n'",
        False,
        Caught::Net,
    ),
    case(
        InjectedFault::RangeForgotten,
        "assume = ['x == a']\nstates = 'a >= 0'",
        Holds,
        Caught::Net,
    ),
    case(
        InjectedFault::ConditionDropped,
        "given = ['a*b == a']\nsolve_for = ['b']\nstates = 'b == 1'",
        Conditional,
        Caught::Net,
    ),
    case(
        InjectedFault::AssumptionReversed,
        "assume = ['a + b >= 1']\nstates = 'a + b <= 1'",
        False,
        Caught::Net,
    ),
    case(
        InjectedFault::BoundReversed,
        "assume = ['a >= 1']\nstates = 'a - x <= 1'",
        False,
        Caught::Net,
    ),
    case(
        InjectedFault::CertificateSign,
        "assume = ['s + t >= 1/2']\nstates = 's + t >= 1'",
        False,
        Caught::Replay,
    ),
    case(
        InjectedFault::ZeroTakenForPositive,
        "states = '1 - x > 0'",
        False,
        Caught::Replay,
    ),
    case(
        InjectedFault::IndexLeftFree,
        "states = 'sum(i, 0, n, B[i,n](i*x)) == 1'",
        False,
        Caught::Net,
    ),
    case(
        InjectedFault::DegreeBelowSeeds,
        "states = 'G[0,1](x) == (1 - x)^2'",
        Undecided,
        Caught::NotNetted,
    ),
    case(
        InjectedFault::EmptySumHasTerm,
        "states = 'sum(i, 1, 0, a) == a'",
        False,
        Caught::Net,
    ),
    case(
        InjectedFault::ValueBeforeDerivative,
        "let = { \"F(a)\" = 'D(a^2, a)' }\nstates = 'F(3) == 0'",
        False,
        Caught::Net,
    ),
    case(
        InjectedFault::PowerWithoutFactor,
        "states = 'at(D(sum(i, 0, n, B[i,n](x)*P[i]), x), x, 0) == P[1] - P[0]'",
        False,
        Caught::Net,
    ),
    case(
        InjectedFault::CosineRate,
        "states = 'D(cos(x), x) == sin(x)'",
        False,
        Caught::Net,
    ),
    case(
        InjectedFault::AngleSum,
        "states = 'cos(2*x) == 1'",
        False,
        Caught::Net,
    ),
    case(
        InjectedFault::DeterminantWithoutSigns,
        "states = 'det([[a, 1], [1, a]]) == a^2 + 1'",
        False,
        Caught::Net,
    ),
    case(
        InjectedFault::SecondHalfIgnored,
        "states = 'a == a and a == b'",
        False,
        Caught::Net,
    ),
    case(
        InjectedFault::ClosedEndExcluded,
        "assume = ['a <= 0', 'a >= 0']\nstates = 'a == 1'",
        False,
        Caught::Net,
    ),
    case(
        InjectedFault::WitnessAnywhere,
        "assume = ['a*exp(a) > 2']\nstates = 'a > 1/2'",
        Undecided,
        Caught::Net,
    ),
    case(
        InjectedFault::RoundingTooWide,
        "states = 'agrees(pi, 3.15)'",
        False,
        Caught::Net,
    ),
    case(
        InjectedFault::CoefficientUnlooked,
        "states = 'variation_diminishing(H, 1, 2)'",
        False,
        Caught::Net,
    ),
    case(
        InjectedFault::RootSignIgnored,
        "states = 'sqrt(a^2) == a'",
        False,
        Caught::Net,
    ),
    case(
        InjectedFault::CorrectionUnproved,
        "kind = 'identity'\nstates = 'a*b + 1 == a*b + 2*a'",
        False,
        Caught::Net,
    ),
    case(
        InjectedFault::IndexNotSeen,
        "states = 'sum(a, 1, 2, a) == 2*a'",
        False,
        Caught::Net,
    ),
    case(
        InjectedFault::MovedNotSeen,
        "states = 'at(a^2, a, 3) == a^2'",
        False,
        Caught::Net,
    ),
    case(
        InjectedFault::OrderForgotten,
        "states = 'D(a^3, a, 2) == 3*a^2'",
        False,
        Caught::Net,
    ),
    case(
        InjectedFault::StepFactorsExchanged,
        "states = 'B[0,1](x) == x'",
        False,
        Caught::Net,
    ),
    case(
        InjectedFault::ImplicationReversed,
        "states = 'a >= 0 implies a >= 1'",
        False,
        Caught::Net,
    ),
    case(
        InjectedFault::CoshAsDifference,
        "states = 'cosh(a) == sinh(a)'",
        False,
        Caught::Net,
    ),
    case(
        InjectedFault::SizeAsItself,
        "states = 'abs(a) == a'",
        False,
        Caught::Net,
    ),
    case(
        InjectedFault::GreaterAsSmaller,
        "states = 'max(a, b) == min(a, b)'",
        False,
        Caught::Net,
    ),
    case(
        InjectedFault::OtherSideForgotten,
        "assume = ['a^3 == 2']\nstates = 'max(a, b) == a'",
        Undecided,
        Caught::Net,
    ),
    case(
        InjectedFault::ArgumentsExchanged,
        "let = { \"F(u, v)\" = 'u - v' }\nstates = 'F(a, b) == b - a'",
        False,
        Caught::Net,
    ),
    case(
        InjectedFault::ProductAsSum,
        "states = 'product(i, 1, 2, a) == 2*a'",
        False,
        Caught::Net,
    ),
    case(
        InjectedFault::PrintedSignLost,
        "states = 'agrees(pi, -3.14)'",
        False,
        Caught::Net,
    ),
    case(
        InjectedFault::CaseForgotten,
        "assume = ['a*(b^2 - 2) == 0']\nstates = 'cos(a) == 1'",
        Conditional,
        Caught::Net,
    ),
    case(
        InjectedFault::LogarithmFactorForgotten,
        "states = 'log(a) + log(a^2) == log(a)'",
        False,
        Caught::Net,
    ),
    case(
        InjectedFault::ArcOfAnyBranch,
        "states = 'atan(tan(a)) == a'",
        False,
        Caught::Net,
    ),
    case(
        InjectedFault::ArcsReversed,
        "states = 'a < b implies atan(a) > atan(b)'",
        False,
        Caught::Net,
    ),
    case(
        InjectedFault::ExponentsReversed,
        "assume = ['a*b > 2']\nstates = 'log(a) + log(b) < log(2)'",
        False,
        Caught::Net,
    ),
];

/// What the prover alone says.
fn proved(claim: &Claim) -> Verdict {
    match decide_statement(claim, claim.statement.as_ref().unwrap()) {
        Ok(Decision::Proven(proof)) if proof.conditions().is_empty() => Holds,
        Ok(Decision::Proven(_)) => Conditional,
        Ok(Decision::Refuted(_)) => False,
        Ok(Decision::Vacuous(_)) => Vacuous,
        Ok(Decision::Open { .. }) | Err(_) => Undecided,
    }
}

fn claim(lines: &str) -> Claim {
    let paper = common::loaded("planted", DECLARATIONS, &[lines]).unwrap();
    paper.claims.into_iter().next().unwrap()
}

#[test]
fn every_planted_fault_changes_a_verdict_and_is_caught() {
    let mut wrong = vec![];
    for case in CASES {
        let claim = claim(case.lines);
        // A formula that makes sense nowhere has no verdict.
        let clean = decide_claim("planted", &claim).map_or(Undecided, |outcome| outcome.verdict());
        let faulty = with(case.fault, || decide_claim("planted", &claim)).unwrap();
        let alone = (proved(&claim), with(case.fault, || proved(&claim)));
        let caught = match (faulty.contradiction(), faulty.verdict()) {
            (Some(_), Undecided) => Some(Caught::Net),
            (None, Undecided) if words::steps(&faulty).concat().contains("certificate") => {
                Some(Caught::Replay)
            }
            // What has no value anywhere is not shown.
            (None, Undecided)
                if words::steps(&faulty)
                    .concat()
                    .contains("no point was found") =>
            {
                Some(Caught::NotNetted)
            }
            (None, _) if faulty.net().is_some_and(|net| net.decided == 0) => {
                Some(Caught::NotNetted)
            }
            _ => None,
        };
        // A wrong correction leaves the verdict of the prover as it is.
        let changed = alone.0 != alone.1 || case.fault == InjectedFault::CorrectionUnproved;
        if clean != case.right || !changed || caught != Some(case.caught) {
            wrong.push(format!(
                "{:?}: {:?} without, prover {alone:?}, then {:?} {:?} {:?}",
                case.fault,
                clean,
                faulty.verdict(),
                words::steps(&faulty),
                faulty.net()
            ));
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

#[test]
fn a_memory_that_forgets_nothing_contradicts_what_is_right() {
    let claim = claim("let = { F = 'a*x' }\nstates = 'at(F, a, 1) + at(F, a, 2) == 3*x'");
    let clean = decide_claim("planted", &claim).unwrap();
    assert_eq!((clean.verdict(), clean.contradiction()), (Holds, None));
    let faulty = with(InjectedFault::StaleMemory, || {
        decide_claim("planted", &claim)
    })
    .unwrap();
    assert_eq!(faulty.verdict(), Undecided);
    assert!(
        faulty.contradiction().is_some(),
        "{:?}",
        words::steps(&faulty)
    );
}

#[test]
fn there_are_claims_for_more_than_thirty_faults_and_no_fault_has_two() {
    let mut names: Vec<String> = CASES.iter().map(|c| format!("{:?}", c.fault)).collect();
    names.sort();
    names.dedup();
    assert_eq!(names.len(), CASES.len());
    assert!(names.len() > 30);
}

#[test]
fn a_forgotten_condition_that_says_where_terms_are_defined_is_found() {
    for states in [
        "b/(b - a) == 1 + a/(b - a)",
        "a <= 0 or 1/(a - b) > 0 or a > 0",
    ] {
        let claim = claim(&format!("states = '{states}'"));
        let decided = || decide_claim("planted", &claim).unwrap();
        assert_eq!(decided().verdict(), Conditional, "{states}");
        let faulty = with(InjectedFault::ConditionDropped, decided);
        assert_eq!(faulty.verdict(), Undecided, "{states}");
        let steps = words::steps(&faulty).concat();
        assert!(steps.contains("divides by zero at a = "), "{steps}");
    }
}
