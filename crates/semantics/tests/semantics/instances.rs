//! Equations at fixed small integers.

use crate::support::claim;
use torse_semantics::{Identity, Work, identity, instances};

fn found(fields: &str, states: &str) -> Vec<(String, Identity)> {
    let claim = claim(fields, states);
    let work = Work::new(500_000);
    let reading = claim.reading();
    instances(&reading)
        .iter()
        .map(|at| (at.to_string(), identity(&reading, at, &work)))
        .collect()
}

fn all_hold(fields: &str, states: &str) {
    let found = found(fields, states);
    assert!(!found.is_empty());
    assert!(
        found.iter().all(|(_, f)| *f == Identity::Holds),
        "{found:?}"
    );
}

fn one_differs(fields: &str, states: &str) {
    let found = found(fields, states);
    assert!(
        found
            .iter()
            .any(|(_, f)| matches!(f, Identity::Differs { .. })),
        "{found:?}"
    );
}

#[test]
fn instances_are_small_and_respect_bounds_that_name_integers() {
    let claim = claim("", "i + m == 0");
    let names: Vec<String> = instances(&claim.reading())
        .iter()
        .map(ToString::to_string)
        .collect();
    assert_eq!(names.first().map(String::as_str), Some("i = 0, m = 1"));
    assert!(
        names.contains(&"i = 3, m = 3".to_owned()) && !names.contains(&"i = 2, m = 1".to_owned())
    );
}

#[test]
fn identities_hold_at_every_small_degree() {
    all_hold("", "sum(j, 0, m, B[j,m](x)) == 1");
    all_hold(
        "",
        "D(sum(j, 0, m, B[j,m](x)*P[j]), x) == m*sum(j, 0, m-1, B[j,m-1](x)*(P[j+1] - P[j]))",
    );
    all_hold(
        "",
        "sin(pi*x) == 2*sin(pi/2*x)*cos(pi/2*x) and D(sin(2*a), a) == 2*cos(a)^2 - 2*sin(a)^2",
    );
    all_hold(
        "",
        "sqrt(2)*sqrt(3) == sqrt(6) and (a^2 - 1)/(a - 1) == a + 1",
    );
    all_hold(
        "",
        "cross(p, q) == -cross(q, p) and det([p, q, p + 2*q]) == 0",
    );
}

#[test]
fn what_is_no_identity_differs() {
    one_differs("", "sum(j, 0, m, B[j,m](j*x)) == 1");
    one_differs("", "D(x^2, x) == x");
    one_differs("", "at(m*P[1], m, 2) == m*P[1]");
}

#[test]
fn hypotheses_about_integers_bound_the_instances() {
    let found = found("assume = ['m >= 2']", "P[2] == P[2]");
    assert_eq!(
        found.first().map(|(_, f)| f.clone()),
        Some(Identity::Outside)
    );
    assert!(
        found.iter().skip(1).all(|(_, f)| *f == Identity::Holds),
        "{found:?}"
    );
}

#[test]
fn undefined_and_open_instances_are_told_apart() {
    assert!(matches!(
        found("", "1/(a - a) == 0").as_slice(),
        [(_, Identity::Undefined(_))]
    ));
    assert!(matches!(
        found("", "a < b").as_slice(),
        [(_, Identity::Open(_))]
    ));
    assert!(matches!(
        found("assume = ['a == b']", "a == b").as_slice(),
        [(_, Identity::Open(_))]
    ));
}
