//! Signs on the line, roots along equations, and partial sums: damaged in each of their parts; near-misses that are not proved.

use crate::damaged::{ground, more, order, rejected};
use crate::{Found, found, tried};
use torse_certificate::Polynomial;
use torse_certificate::line::{Line, Within};
use torse_certificate::proof::assumptions::{Determining, RootAlong};
use torse_certificate::sign::{Certificate, Even, Piece, Shown, Sign, Square, Taylor};
use torse_numbers::rational::integer;
use torse_verdicts::certificate::DecisionCertificate;

fn line(found: &mut Found) -> &mut Line<Polynomial> {
    match &mut order(found).signs[0].by {
        Shown::Line(own) => own,
        other => panic!("{other:?}"),
    }
}

fn taylor(found: &mut Found) -> &mut Taylor<Polynomial> {
    match &mut order(found).signs[0].by {
        Shown::Taylor(own) => own,
        other => panic!("{other:?}"),
    }
}

#[test]
fn a_sign_on_the_line() {
    rejected(
        "assume = ['a^2 > 4', 'a >= -2']\nstates = 'a > 2 - 1/100'",
        &[
            ("no cuts", &|f| line(f).cuts.clear()),
            ("cuts that do not separate the roots", &|f| {
                line(f).cuts = vec![integer(100)]
            }),
            ("cuts that do not ascend", &|f| line(f).cuts.reverse()),
            ("another factor", &|f| more(&mut line(f).factors[0])),
            ("another target", &|f| line(f).target.exponents[0] += 1),
            ("the other sign", &|f| {
                let content = &mut line(f).target.content;
                *content = content.negated();
            }),
            ("nothing that bounds the line", &|f| line(f).within.clear()),
            ("a constraint that there is not", &|f| {
                for within in &mut line(f).within {
                    if let Within::Constraint { constraint, .. } = within {
                        *constraint += 7;
                    }
                }
            }),
            ("another constraint", &|f| {
                for within in &mut line(f).within {
                    if let Within::Constraint { above, .. } = within {
                        above.content = above.content.negated();
                    }
                }
            }),
            ("an end that there is not", &|f| {
                for within in &mut line(f).within {
                    if let Within::End { value, .. } = within {
                        value.above = Polynomial::constant(integer(3));
                    }
                }
                let own = line(f);
                own.within
                    .retain(|within| matches!(within, Within::End { .. }));
                own.within.push(Within::Nonzero {
                    divisor: own.factors[0].clone(),
                    product: own.target.clone(),
                });
            }),
        ],
    );
}

#[test]
fn a_divisor_that_may_vanish_bounds_no_line() {
    let mut own = found("states = '1/a^2 > 0'");
    assert!(line_of_divisor(&mut own).is_some());
    rejected(
        "states = '1/a^2 > 0'",
        &[("a divisor that is none", &|f| {
            if let Some(Within::Nonzero { divisor, .. }) = line_of_divisor(f) {
                more(divisor);
            }
        })],
    );
}

fn line_of_divisor(found: &mut Found) -> Option<&mut Within<Polynomial>> {
    let mut signs = order(found).signs.iter_mut();
    signs.find_map(|sign| match &mut sign.by {
        Shown::Line(own) => own
            .within
            .iter_mut()
            .find(|within| matches!(within, Within::Nonzero { .. })),
        _ => None,
    })
}

#[test]
fn a_root_along_equations() {
    fn along(found: &mut Found) -> &mut RootAlong<Polynomial> {
        let mut all = ground(found).eliminated.iter_mut();
        let own = all.find_map(|elimination| match &mut elimination.by {
            Determining::RootAlong(own) => Some(own),
            _ => None,
        });
        own.expect("a root")
    }
    rejected(
        "assume = ['a^2 + b^2 == 9']\nstates = 'sqrt(a^2 + b^2) == 3'",
        &[
            ("no equation", &|f| along(f).multiples.clear()),
            ("another multiple", &|f| {
                more(&mut along(f).multiples[0].multiple)
            }),
            ("an equation that there is not", &|f| {
                along(f).multiples[0].equation += 9;
            }),
            ("no constraints", &|f| along(f).root.constraints.clear()),
            ("the sign of something else", &|f| {
                more(&mut along(f).root.sign.polynomial);
            }),
        ],
    );
}

#[test]
fn partial_sums() {
    rejected(
        "states = 'sin(u) <= u'",
        &[
            ("another degree", &|f| taylor(f).bounds[0].degree += 2),
            ("a degree that the series has not", &|f| {
                taylor(f).bounds[0].degree += 1
            }),
            ("no term", &|f| taylor(f).terms.clear()),
            ("other exponents", &|f| {
                for term in &mut taylor(f).terms {
                    term.exponents[0] += 1;
                }
            }),
            ("another function", &|f| {
                let bounds = &mut taylor(f).bounds;
                if let torse_certificate::Symbol::Sine(name, angle) = bounds[0].symbol.clone() {
                    bounds[0].symbol = torse_certificate::Symbol::Cosine(name, angle);
                }
            }),
        ],
    );
}

#[test]
fn what_fails_between_integers_alone_is_not_refuted() {
    let true_of_integers = [
        "states = '(n - 1)*(n - 2) >= 0'",
        "states = '(2*n - 1)*(2*n - 3)*(2*n - 5)^2 != 0'",
        "states = '(2*i - 1)^2 > 0'",
        "states = '2*n != 3'",
        "states = 'n^2 != 2'",
        "assume = ['n == a', 'a > 3/2', 'a < 5/2']\nstates = '(a - 2)*(a - 3) >= 0'",
    ];
    for lines in true_of_integers {
        if let Some(own) = tried(lines) {
            let proof = matches!(own.certificate, DecisionCertificate::Proof { .. });
            assert!(proof, "{lines}: refuted");
            assert_eq!(own.checked(), Ok(()), "{lines}");
        }
    }
    // The same of a real number has its point.
    for lines in [
        "assume = ['a >= 1']\nstates = '(a - 1)*(a - 2) >= 0'",
        "states = '(2*a - 1)*(2*a - 3)*(2*a - 5)^2 != 0'",
        "states = 'a^2 != 2'",
    ] {
        let own = found(lines);
        let proof = matches!(own.certificate, DecisionCertificate::Proof { .. });
        assert!(!proof, "{lines}: proved");
        assert_eq!(own.checked(), Ok(()), "{lines}");
    }
}

/// `1 - r^2*sin(a)^2 > 0` by its values where r is zero and where it is this bound, under the hypotheses of another claim.
fn by_square_of_r(bound: i64, hypotheses: &str) -> Result<(), torse_checker::CheckError> {
    let states = "states = '1 - r^2*sin(a)^2 > 0'";
    let mut own = found(&format!("assume = ['r > -1', 'r < 1']\n{states}"));
    let r = torse_certificate::Symbol::named("r");
    let sign = &mut order(&mut own).signs[0];
    let cosine =
        |s: &&torse_certificate::Symbol| matches!(s, torse_certificate::Symbol::Cosine(..));
    let cosine = Polynomial::symbol(sign.polynomial.symbols().find(cosine).unwrap().clone());
    let [constant, _, square] = &sign.polynomial.coefficients_in(&r)[..] else {
        panic!("{:?}", sign.polynomial);
    };
    let whole = |polynomial: &Polynomial, root: Option<Polynomial>| Sign {
        polynomial: polynomial.clone(),
        strict: root.is_none(),
        by: Shown::Whole(Certificate {
            strict: root.is_none(),
            rest: match &root {
                None => polynomial.clone(),
                Some(_) => Polynomial::zero(),
            },
            squares: root
                .into_iter()
                .map(|root| Square {
                    multiple: integer(1),
                    root,
                })
                .collect(),
            multiples: vec![],
            factors: vec![],
            coordinates: vec![],
            pieces: vec![Piece {
                region: vec![],
                outside: None,
            }],
        }),
    };
    let even = Even {
        symbol: r,
        bound: integer(bound),
        at_zero: whole(constant, None),
        at_bound: whole(&constant.plus(square), Some(cosine)),
    };
    sign.by = Shown::Even(Box::new(even));
    own.core = found(&format!("{hypotheses}\n{states}")).core;
    own.checked()
}

#[test]
fn a_square_of_a_bounded_symbol() {
    let own = "assume = ['r > -1', 'r < 1']";
    assert_eq!(by_square_of_r(1, own), Ok(()));
    // The bound is a positive number, and the range is within it.
    for (bound, hypotheses) in [
        (-1, own),
        (2, own),
        (1, "assume = ['r > -2', 'r < 1']"),
        (1, "assume = ['r > -1', 'r < 2']"),
        (1, "assume = ['r > -1']"),
        // With its ends the range has points at which the polynomial is zero.
        (1, "assume = ['r >= -1', 'r < 1']"),
        (1, "assume = ['r >= -1', 'r <= 1']"),
    ] {
        let said = by_square_of_r(bound, hypotheses);
        let refused = matches!(said, Err(torse_checker::CheckError::Wrong(_)));
        assert!(refused, "{bound}, {hypotheses}: {said:?}");
    }
}

#[test]
fn proofs_are_accepted_and_near_misses_refuted_or_open() {
    let proved = [
        "assume = ['a != 0']\nstates = 'a^2 > 0'",
        "states = 'a^2 > 4 implies (a < -2 or a > 2)'",
        "states = 'a^6 - 6*a^5 + 15*a^4 - 20*a^3 + 15*a^2 - 6*a + 2 > 0'",
        "states = 'abs(a) <= 1 implies abs(a) < 2'",
        "assume = ['a^2 == 1']\nstates = 'abs(a) == 1'",
        "states = 'cos(a) >= 1 - a^2/2'",
        "states = 'sin(u) >= u - u^3/6'",
        "assume = ['u > 0']\nstates = 'sin(u) < u'",
        "assume = ['u > 0']\nstates = 'cos(u) > 1 - u^2/2'",
        "assume = ['u <= 1']\nstates = '2*sin(u) >= u'",
        "assume = ['r >= -1', 'r < 1', 'r != -1']\nstates = '1 - r^2*sin(a)^2 >= 0'",
        // A variable and its angle are two coordinates.
        "assume = ['u >= 1', 'u <= 2']\nstates = '2*(sin(3*u) + cos(3*u)) <= 2*(1 + 4*u)'",
    ];
    for lines in proved {
        let own = found(lines);
        let DecisionCertificate::Proof { conditions, .. } = &own.certificate else {
            panic!("{lines}: refuted");
        };
        assert!(conditions.is_empty(), "{lines}: {conditions:?}");
        assert_eq!(own.checked(), Ok(()), "{lines}");
    }
    let missed = [
        "states = 'a^2 > 0'",
        "states = 'a^2 >= 4 implies (a < -2 or a > 2)'",
        "states = '(a^2 - 2)^2 > 0'",
        "states = 'a^4 - 5*a^2 + 4 >= -9/4'",
        "assume = ['a^2 == 2']\nstates = 'abs(a) == 1'",
        "states = 'sin(a) <= a'",
        "states = 'sin(u) < u'",
        "states = 'sin(u) >= u'",
        "states = 'cos(a) > 1 - a^2/2'",
        "states = 'cos(u) < 1 or u < 1'",
        "assume = ['r >= -1', 'r <= 1']\nstates = '1 - r^2*sin(a)^2 > 0'",
    ];
    for lines in missed {
        let proof = |own: &Found| matches!(own.certificate, DecisionCertificate::Proof { .. });
        // The fourth is true, with equality at two surds.
        let is_true = lines.contains("-9/4");
        assert_eq!(
            tried(lines).is_some_and(|own| proof(&own)),
            is_true,
            "{lines}"
        );
    }
}
