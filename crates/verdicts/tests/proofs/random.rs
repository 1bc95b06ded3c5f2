//! Statements that are true by construction are proved, and their proofs are replayed.

use crate::{found, tried};
use proptest::prelude::*;

/// A formula without divisors.
fn formula() -> impl Strategy<Value = String> {
    let leaf = prop_oneof![
        Just("a".to_owned()),
        Just("b".to_owned()),
        Just("x".to_owned()),
        Just("pi".to_owned()),
        Just("sqrt(2)".to_owned()),
        Just("sin(pi/2*x)".to_owned()),
        Just("cos(pi/4*x)".to_owned()),
        (-5_i64..6).prop_map(|n| format!("({n})")),
    ];
    leaf.prop_recursive(3, 10, 2, |inner| {
        let operator = prop_oneof![Just("+"), Just("-"), Just("*")];
        (inner.clone(), operator, inner).prop_map(|(p, o, q)| format!("({p} {o} {q})"))
    })
}

/// A sum of Bernstein polynomials in x and z with coefficients that are not negative, and a positive number.
fn positive() -> impl Strategy<Value = String> {
    let term = (0_u32..4, 0_u32..3, 0_u32..3, 0_u32..3, 0_u32..3);
    let term = term.prop_map(|(c, i, j, k, l)| format!("{c}*x^{i}*(1 - x)^{j}*z^{k}*(1 - z)^{l}"));
    (proptest::collection::vec(term, 1..4), 1_u32..4)
        .prop_map(|(terms, n)| format!("{} + {n}", terms.join(" + ")))
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(48))]

    #[test]
    fn identities(p in formula(), q in formula()) {
        let found = found(&format!(
            "states = '({p} + {q})^2/(1 + a^2) == ({p}^2 + 2*{p}*{q})/(1 + a^2) + {q}^2/(1 + a^2)'"
        ));
        prop_assert_eq!(found.checked(), Ok(()));
    }

    #[test]
    fn signs(p in positive()) {
        let found = found(&format!("states = '{p} > 0'"));
        prop_assert_eq!(found.checked(), Ok(()));
    }

    #[test]
    fn derivatives(p in formula(), q in formula()) {
        let found = found(&format!(
            "states = 'D({p}*{q}, x) == D({p}, x)*{q} + {p}*D({q}, x)'"
        ));
        prop_assert_eq!(found.checked(), Ok(()));
    }

    #[test]
    fn counterexamples(p in formula()) {
        // Of some cosines no simple point has an exact value.
        if let Some(found) = tried(&format!("states = '{p} == {p} + 1'")) {
            prop_assert_eq!(found.checked(), Ok(()));
        }
    }
}
