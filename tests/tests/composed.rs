//! A thousand statements in which everything is composed with everything: what the engine says of them is compared with what
//! an evaluator of the generator's own finds.

#![allow(clippy::print_stderr, reason = "a table is worth a look")]

use torse_tests::composed::tally::{Answer, run_by};
use torse_tests::composed::{Composed, claim};
use torse_tests::random::claim::Truth;

const SEED: u64 = 1;
const CLAIMS: u64 = 1_000;
/// How many in a thousand may be internal contradictions.
const MAX_CONTRADICTIONS: u64 = 1;
/// How many in a hundred of the claims that are not refused may stay open.
const MAX_OPEN: u64 = 12;
/// Of how many in a hundred the semantics alone has to say what is true.
const MIN_SECONDED: u64 = 85;

#[test]
fn composed_statements_are_never_judged_wrongly() {
    let counts = run_by(2, SEED, CLAIMS);
    eprintln!("{counts}");
    let (contradictions, refused) = (counts.of(Answer::Contradiction), counts.of(Answer::Refused));
    let wrong = counts.wrong.join("\n");
    assert_eq!(counts.wrong.len() as u64, contradictions, "{wrong}");
    assert!(
        contradictions * 1_000 <= CLAIMS * MAX_CONTRADICTIONS,
        "{wrong}"
    );
    assert_eq!(counts.contradicted, Vec::<String>::new());
    let open = counts.of(Answer::Open);
    assert!(open * 100 <= (CLAIMS - refused) * MAX_OPEN, "{open} open");
    assert!(refused * 100 <= CLAIMS, "{refused} refused");
    let seconded = counts.seconded;
    assert!(seconded * 100 >= CLAIMS * MIN_SECONDED, "{seconded}");
}

#[test]
fn about_half_of_them_are_true() {
    let all: Vec<Composed> = (0..400).map(|number| claim(SEED, number)).collect();
    let fails = |made: &&Composed| matches!(made.claim.truth, Truth::Fails(_));
    let count = all.iter().filter(fails).count();
    assert!((120..=280).contains(&count), "{count}");
}

#[test]
fn a_composed_claim_is_a_function_of_its_seed() {
    for number in 0..40 {
        let (one, other) = (claim(SEED, number), claim(SEED, number));
        assert_eq!(one.claim.file(), other.claim.file());
        assert_eq!(one.claim.truth, other.claim.truth);
    }
    assert_ne!(claim(1, 7).claim.file(), claim(2, 7).claim.file());
}

/// Deliberate mistakes, without the kernel.
#[cfg(debug_assertions)]
mod mistakes {
    use super::SEED;
    use torse_numbers::fault_injection::{InjectedFault, with};
    use torse_tests::composed::claim;
    use torse_tests::composed::tally::{Answer, answer, semantics_alone};

    /// So many claims are enough to see a mistake.
    const ENOUGH: u64 = 2_000;

    #[test]
    fn mistakes_of_the_engine_are_seen_in_composed_statements() {
        for fault in [
            InjectedFault::CosineRate,
            InjectedFault::AngleSum,
            InjectedFault::LowerEndForgotten,
            InjectedFault::EmptySumHasTerm,
            InjectedFault::SecondHalfIgnored,
            InjectedFault::RootSignIgnored,
            InjectedFault::ConditionDropped,
            InjectedFault::OrdersByMaximum,
            InjectedFault::DefinitionOutsideScope,
            InjectedFault::LeftOutNotMoved,
            InjectedFault::MovedNotSeen,
            InjectedFault::OrderForgotten,
            InjectedFault::EndsExchanged,
            InjectedFault::StepFactorsExchanged,
            InjectedFault::ImplicationReversed,
            InjectedFault::SizeAsItself,
            InjectedFault::PrimesOnce,
            InjectedFault::ProductAsSum,
            InjectedFault::CaseForgotten,
            InjectedFault::StaleMemory,
        ] {
            let is_seen = |number: &u64| {
                let made = claim(SEED, *number);
                let (answer, _) = with(fault, || answer(&made));
                !matches!(answer, Answer::Right | Answer::Open | Answer::Refused)
            };
            assert!((0..ENOUGH).any(|number| is_seen(&number)), "{fault:?}");
        }
    }

    #[test]
    fn a_stream_of_points_that_are_all_alike_is_seen() {
        const CLAIMS: u64 = 120;
        let (clean, wrong) = semantics_alone(SEED, CLAIMS);
        assert_eq!(wrong, Vec::<String>::new());
        let (alike, _) = with(InjectedFault::StreamDegenerate, || {
            semantics_alone(SEED, CLAIMS)
        });
        assert!(alike + CLAIMS / 10 <= clean, "{clean} and {alike}");
    }
}
