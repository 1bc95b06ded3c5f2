//! Putting a value in for a variable: everywhere or not at all.

#![allow(clippy::unwrap_used, reason = "helpers of tests")]

use proptest::prelude::*;
use torse_algebra::rational::ratio;
use torse_algebra::{Affine, ExactError, Fraction, Scalar as _, Symbol};

/// The member `P[m + shift]`, if m can stand in an index.
fn member(m: &Fraction, shift: i64) -> Result<Fraction, ExactError> {
    let form = m.as_affine().ok_or_else(|| ExactError::NoIndex {
        member: "P[m]".to_owned(),
        value: m.to_string(),
    })?;
    let index = form + Affine::number(shift);
    Ok(Fraction::symbol(Symbol::indexed("P", vec![index])))
}

/// A formula in m and x: each code adds, subtracts, multiplies with or divides by an atom.
fn formula(codes: &[u8], m: &Fraction, x: &Fraction) -> Result<Fraction, ExactError> {
    codes.iter().try_fold(Fraction::integer(1), |f, code| {
        let atom = match code / 4 % 6 {
            0 => m.clone(),
            1 => x.clone(),
            2 => member(m, 0)?,
            3 => member(m, -1)?,
            4 => x.quarter_turn()?.0,
            _ => x.quarter_turn()?.1,
        };
        Ok(match code % 4 {
            0 => f + atom,
            1 => f - atom,
            2 => f * atom,
            _ => f.over(&atom)?,
        })
    })
}

fn mentions(f: &Fraction, name: &str) -> bool {
    let conditions = f.conditions().iter().flat_map(|p| p.symbols());
    f.symbols()
        .iter()
        .chain(conditions)
        .any(|s| s.depends_on(name))
}

proptest! {
    #[test]
    fn a_value_put_in_afterwards_is_the_value_put_in_before(
        codes in prop::collection::vec(0_u8..24, 1..7),
        index in -1_i64..4,
        (numerator, denominator) in prop::sample::select(vec![(0, 1), (1, 2), (1, 3), (1, 1), (2, 1)]),
    ) {
        let (m, x) = (Fraction::named("m"), Fraction::named("x"));
        let (n, v) = (Fraction::integer(index), Fraction::from(ratio(numerator, denominator).unwrap()));
        let general = formula(&codes, &m, &x).unwrap();
        let after = general.at("m", &n).and_then(|f| f.at("x", &v));
        let before = formula(&codes, &n, &v);
        prop_assert_eq!(after.is_ok(), before.is_ok(), "{:?} {:?}", after, before);
        if let (Ok(after), Ok(before)) = (after, before) {
            prop_assert!(after == before, "{} {}", after, before);
            prop_assert!(!mentions(&after, "m") && !mentions(&after, "x"), "{:?}", after);
        }
    }

    #[test]
    fn names_are_put_in_for_names(codes in prop::collection::vec(0_u8..24, 1..7), shift in -2_i64..3) {
        let (m, x, t) = (Fraction::named("m"), Fraction::named("x"), Fraction::named("t"));
        let next = Fraction::named("n") + Fraction::integer(shift);
        let after = formula(&codes, &m, &x).unwrap().at("m", &next).unwrap().at("x", &t).unwrap();
        let before = formula(&codes, &next, &t).unwrap();
        prop_assert!(after == before, "{} {}", after, before);
        prop_assert_eq!(after.conditions(), before.conditions());
        prop_assert!(!mentions(&after, "m") && !mentions(&after, "x"));
    }
}

#[test]
fn a_divisor_that_left_no_trace_but_its_condition_is_still_looked_at() {
    let x = Fraction::named("x");
    let cosine = x.quarter_turn().unwrap().1;
    let zero = Fraction::zero().over(&cosine).unwrap();
    assert!(zero.is_zero());
    // cos(pi/2) = 0
    assert!(zero.at("x", &Fraction::integer(1)).is_err());
    let at_zero = zero.at("x", &Fraction::zero()).unwrap();
    assert!(at_zero.conditions().is_empty());
    // The cosine at 2/7 is no number of this kind: refused, not forgotten.
    let seventh = Fraction::from(ratio(2, 7).unwrap());
    assert!(matches!(
        zero.at("x", &seventh),
        Err(ExactError::NoExactTurn { .. })
    ));
}

#[test]
fn what_is_no_integer_form_is_refused_in_an_index() {
    let f = member(&Fraction::named("m"), 0).unwrap();
    let product = Fraction::named("m") * Fraction::named("n");
    for value in [
        Fraction::from(ratio(1, 2).unwrap()),
        Fraction::symbol(Symbol::Pi),
        product,
    ] {
        let refused = f.at("m", &value);
        assert!(
            matches!(refused, Err(ExactError::NoIndex { .. })),
            "{value}: {refused:?}"
        );
    }
}
