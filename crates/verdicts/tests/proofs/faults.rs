//! Deliberate mistakes of the prover are seen by the checker alone, and one of the checker by the prover.

use crate::claim;
use torse_checker::{CheckError, Work};
use torse_numbers::fault_injection::{InjectedFault, with};
use torse_prove::decide_statement;
use torse_syntax::taxonomy::Verdict;
use torse_verdicts::certificate::DecisionCertificate;
use torse_verdicts::engine::decide_claim;

/// What the checker says, without the mistake, of what the prover finds with it.
fn caught(fault: InjectedFault, lines: &str) -> Result<(), CheckError> {
    let claim = claim(lines);
    let statement = claim.statement.clone().unwrap();
    let decision = with(fault, || decide_statement(&claim, &statement)).unwrap();
    let certificate = DecisionCertificate::from_decision(&decision)
        .unwrap_or_else(|| panic!("{fault:?}: {decision:?}"));
    let core = torse_elaborate::elaborate(&claim, &statement).unwrap();
    let work = Work::new(torse_checker::WORK);
    match certificate.plain() {
        DecisionCertificate::Proof { conditions, of } => {
            torse_checker::proves(&core, &statement.origin, &conditions, &of, &work)
        }
        DecisionCertificate::Refutation(of) => {
            torse_checker::refutes(&core, &statement.origin, &of, &work)
        }
    }
}

#[test]
fn the_checker_sees_mistakes_of_the_prover() {
    for (fault, lines) in [
        (
            InjectedFault::RangeForgotten,
            "assume = ['x == a']\nstates = 'a >= 0'",
        ),
        (
            InjectedFault::ConditionDropped,
            "given = ['a*b == a']\nsolve_for = ['b']\nstates = 'b == 1'",
        ),
        (
            InjectedFault::AssumptionReversed,
            "assume = ['a + b >= 1']\nstates = 'a + b <= 1'",
        ),
        (
            InjectedFault::BoundReversed,
            "assume = ['a >= 1']\nstates = 'a - x <= 1'",
        ),
        (
            InjectedFault::WitnessAnywhere,
            "assume = ['a^3 > 1 + x*b^2']\nstates = 'a > 1/2'",
        ),
        (
            InjectedFault::RoundingTooWide,
            "states = 'agrees(pi, 3.15)'",
        ),
        (
            InjectedFault::CosineRate,
            "states = 'D(cos(pi/2*x), x) == pi/2*sin(pi/2*x)'",
        ),
        (
            InjectedFault::SecondHalfIgnored,
            "states = 'a == a and a == b'",
        ),
    ] {
        let said = caught(fault, lines);
        assert!(
            matches!(said, Err(CheckError::Wrong(_))),
            "{fault:?}: {said:?}"
        );
    }
}

#[test]
fn a_mistake_of_the_checker_contradicts_the_prover() {
    let claim = claim("states = '(a - b)*(a + b) == a^2 - b^2'");
    let clean = decide_claim("proofs", &claim).unwrap();
    assert_eq!(clean.verdict(), Verdict::Holds);
    assert!(clean.replay().unwrap().replayed);
    let faulty = with(InjectedFault::DifferenceReadAsSum, || {
        decide_claim("proofs", &claim)
    })
    .unwrap();
    assert_eq!(faulty.verdict(), Verdict::Undecided);
    assert!(faulty.contradiction().unwrap().contains("expanded"));
    // Of what was decided before nothing is left that could be shown.
    assert!(faulty.net().is_none() && faulty.replay().is_none() && faulty.evidence().is_none());
    assert!(faulty.conditions().is_empty() && faulty.correction().is_none());
}

#[test]
fn what_an_equation_does_not_say_of_a_symbol_is_no_hypothesis() {
    // Where x and z are equal the equation leaves r free: x = z = 1/2, b = 0 and r = 1 is a point of the domain.
    let lines = "given = ['(x - z)*r == (x - z)^2*b']\nsolve_for = ['r']\nassume = ['r > 0']\nstates = 'x != z'";
    if let Some(found) = crate::tried(lines)
        && let DecisionCertificate::Proof { .. } = found.certificate
    {
        let said = found.checked();
        assert!(matches!(said, Err(CheckError::Wrong(_))), "{said:?}");
    }
    for lines in [lines.to_owned(), lines.replace("x != z", "r == (x - z)*b")] {
        let outcome = decide_claim("proofs", &claim(&lines)).unwrap();
        assert_eq!(outcome.contradiction(), None, "{lines}");
        assert_ne!(outcome.verdict(), Verdict::Holds, "{lines}");
    }
}
