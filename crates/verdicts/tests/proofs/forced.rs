//! What can be nothing but zero: damaged in each of its parts, and near-misses that are not proved.

use crate::damaged::{ground, more, order, rejected};
use crate::{Found, found, tried};
use torse_certificate::proof::Proof;
use torse_certificate::sign::{Along, Shown, Sign, Squares};
use torse_certificate::zero_by_sign::{Zero, ZeroBySign};
use torse_certificate::{Polynomial, Symbol};
use torse_checker::{CheckError, Wrong};
use torse_verdicts::certificate::DecisionCertificate;

fn forced(found: &mut Found) -> &mut ZeroBySign<Polynomial> {
    match &mut ground(found).proof {
        Proof::ZeroBySign(own) => own,
        other => panic!("{other:?}"),
    }
}

fn along(sign: &mut Sign<Polynomial>) -> &mut Along<Polynomial> {
    match &mut sign.by {
        Shown::Along(own) => own,
        other => panic!("{other:?}"),
    }
}

fn turned(p: &mut Polynomial) {
    *p = p.negated();
}

#[test]
fn two_signs() {
    fn signs(found: &mut Found) -> &mut [Sign<Polynomial>; 2] {
        match &mut forced(found).entries[0] {
            Zero::Between(signs) => signs,
            other => panic!("{other:?}"),
        }
    }
    rejected(
        "assume = ['u + v == 0']\nstates = 'u == 0'",
        &[
            ("one sign twice", &|f| signs(f)[1] = signs(f)[0].clone()),
            ("another difference", &|f| {
                more(&mut signs(f)[0].polynomial);
            }),
            ("no entry", &|f| forced(f).entries.clear()),
            ("an entry that does not vanish", &|f| {
                forced(f).entries[0] = Zero::Identically;
            }),
            ("no equation", &|f| ground(f).constraints.clear()),
        ],
    );
}

#[test]
fn a_square() {
    fn square(found: &mut Found) -> (&mut Polynomial, &mut Sign<Polynomial>) {
        match &mut forced(found).entries[0] {
            Zero::Square { root, sign } => (root, sign),
            other => panic!("{other:?}"),
        }
    }
    rejected(
        "assume = ['a^2 + b^2 == 0']\nstates = 'a == 0'",
        &[
            ("another root", &|f| {
                *square(f).0 = Polynomial::symbol(Symbol::named("b"));
            }),
            ("another square", &|f| turned(&mut square(f).1.polynomial)),
            ("another multiple", &|f| {
                turned(&mut along(square(f).1).multiple);
            }),
            ("another rest", &|f| {
                more(&mut along(square(f).1).rest.polynomial);
            }),
            ("an equation that there is not", &|f| {
                along(square(f).1).equation = 7;
            }),
        ],
    );
}

#[test]
fn factors_that_do_not_vanish() {
    fn lists(found: &mut Found) -> (&mut Vec<Polynomial>, &mut Vec<Polynomial>) {
        match &mut forced(found).entries[0] {
            Zero::Product {
                equations,
                multipliers,
            } => (equations, multipliers),
            other => panic!("{other:?}"),
        }
    }
    rejected(
        "assume = ['a^2 == 4', 'a != 2']\nstates = 'a == -2'",
        &[
            ("an equation that nobody assumes", &|f| {
                more(&mut lists(f).0[0]);
            }),
            ("another multiplier", &|f| {
                lists(f).1[0] = Polynomial::zero();
            }),
            ("a multiplier less", &|f| {
                lists(f).1.pop();
            }),
        ],
    );
}

#[test]
fn a_factor_that_nobody_excludes_is_none() {
    let mut wrong = found("assume = ['a^2 == 4', 'a != 2']\nstates = 'a == -2'");
    assert_eq!(wrong.checked(), Ok(()));
    wrong.core = found("assume = ['a^2 == 4']\nstates = 'a == -2'").core;
    ground(&mut wrong).constraints.truncate(1);
    let said = wrong.checked();
    assert!(matches!(said, Err(CheckError::Wrong(_))), "{said:?}");
}

#[test]
fn a_sign_along_an_inequality_is_none() {
    let mut wrong = found("assume = ['a^2 + b^2 == 1']\nstates = 'a^2 <= 1'");
    assert_eq!(wrong.checked(), Ok(()));
    assert_eq!(along(&mut order(&mut wrong).signs[0]).equation, 0);
    let mut other = found("assume = ['a^2 + b^2 <= 1']\nstates = 'a^2 <= 1'");
    ground(&mut wrong).constraints = ground(&mut other).constraints.clone();
    wrong.core = other.core;
    let said = wrong.checked();
    assert!(
        matches!(said, Err(CheckError::Wrong(Wrong::Kind))),
        "{said:?}"
    );
}

#[test]
fn squares_of_a_difference() {
    fn squares(found: &mut Found) -> &mut Squares<Polynomial> {
        match &mut order(found).signs[0].by {
            Shown::Squares(own) => own,
            other => panic!("{other:?}"),
        }
    }
    rejected(
        "states = 'sqrt(a^2 + 1) > a'",
        &[
            ("another larger one", &|f| {
                more(&mut squares(f).larger.polynomial);
            }),
            ("a larger one that may be negative", &|f| {
                turned(&mut squares(f).larger.polynomial);
            }),
            ("another difference", &|f| {
                more(&mut squares(f).difference.polynomial);
            }),
            ("no strictness", &|f| squares(f).difference.strict = false),
            ("another multiple", &|f| {
                more(&mut along(&mut squares(f).difference).multiple);
            }),
        ],
    );
}

#[test]
fn what_is_almost_forced_is_refuted() {
    for lines in [
        "assume = ['a + b == 0']\nstates = 'a == 0'",
        "assume = ['a^2 - b^2 == 0']\nstates = 'a == 0'",
        "assume = ['a*b == 0', 'a != 0']\nstates = 'a == 0'",
        "assume = ['a^2 + b^2 == 1']\nstates = 'a^2 < 1'",
        "assume = ['u + v == 1']\nstates = 'u == 0'",
        "states = 'a^2 == b^2 implies a == b'",
        "states = 'a^2 == 4 implies a == 2'",
    ] {
        let found = tried(lines).unwrap_or_else(|| panic!("{lines}: open"));
        assert!(
            matches!(found.certificate, DecisionCertificate::Refutation(_)),
            "{lines}"
        );
    }
}
