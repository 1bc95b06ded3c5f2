//! A proof damaged in each of its parts is rejected.

use crate::{Found, found};
use std::str::FromStr;
use torse_certificate::enclosure::Agreement;
use torse_certificate::identity::Combination;
use torse_certificate::order::Order;
use torse_certificate::point::{Counterexample, Failure};
use torse_certificate::proof::Proof;
use torse_certificate::proof::assumptions::{Assumptions, Determining, Signed};
use torse_certificate::proof::refutation::Refuted;
use torse_certificate::sign::{Certificate, Coordinate, Factor, Shown, Sign};
use torse_certificate::wronskian::{Cell, Exchange, Wronskians};
use torse_certificate::{Polynomial, Ratio, Symbol};
use torse_checker::CheckError;
use torse_numbers::Rational;
use torse_numbers::rational::integer;
use torse_syntax::formula::Relation;
use torse_verdicts::certificate::DecisionCertificate;

type P = Polynomial;

/// What is damaged, and how.
type Damage<'a> = (&'a str, &'a dyn Fn(&mut Found));

/// The proof passes, and with each of these damages it is rejected.
#[track_caller]
pub(crate) fn rejected(lines: &str, damages: &[Damage<'_>]) {
    assert_eq!(found(lines).checked(), Ok(()), "{lines}");
    for (what, damage) in damages {
        let mut found = found(lines);
        let before = found.certificate.clone();
        damage(&mut found);
        assert_ne!(
            found.certificate, before,
            "{lines}: nothing damaged by {what}"
        );
        let said = found.checked();
        assert!(
            matches!(said, Err(CheckError::Wrong(_))),
            "{lines}: {what}: {said:?}"
        );
    }
}

fn proof(found: &mut Found) -> &mut Proof<P> {
    match &mut found.certificate {
        DecisionCertificate::Proof { of, .. } => of,
        DecisionCertificate::Refutation(of) => panic!("{of:?}"),
    }
}

pub(crate) fn ground(found: &mut Found) -> &mut Assumptions<P> {
    match proof(found) {
        Proof::On(ground) => ground,
        other => panic!("{other:?}"),
    }
}

pub(crate) fn order(found: &mut Found) -> &mut Order<P> {
    match &mut ground(found).proof {
        Proof::Order(order) => order,
        other => panic!("{other:?}"),
    }
}

fn combination(found: &mut Found) -> &mut Combination<P> {
    match &mut ground(found).proof {
        Proof::Combination(own) => own,
        other => panic!("{other:?}"),
    }
}

fn certificate(sign: &mut Sign<P>) -> &mut Certificate<P> {
    match &mut sign.by {
        Shown::Whole(certificate) => certificate,
        other => panic!("{other:?}"),
    }
}

fn whole(found: &mut Found) -> &mut Certificate<P> {
    certificate(&mut order(found).signs[0])
}

fn refuted(found: &mut Found) -> &mut Refuted<P> {
    match &mut found.certificate {
        DecisionCertificate::Refutation(of) => of,
        DecisionCertificate::Proof { of, .. } => panic!("{of:?}"),
    }
}

fn point(found: &mut Found) -> &mut Counterexample<P> {
    refuted(found).counterexample_mut()
}

pub(crate) fn more(p: &mut P) {
    *p = p.plus(&Polynomial::one());
}

fn number(n: i64) -> Ratio<P> {
    Polynomial::constant(integer(n)).into()
}

#[test]
fn an_identity_that_is_none() {
    // The right proof of another statement.
    let mut wrong = found("states = 'a + b == b'\nassume = ['a == 0']");
    ground(&mut wrong).eliminated.clear();
    assert!(matches!(wrong.checked(), Err(CheckError::Wrong(_))));
    rejected(
        "states = '(a - b)*(a + b) == a^2 - b^2'",
        &[("another kind", &|f| {
            *proof(f) = Proof::Clauses(vec![]);
            let DecisionCertificate::Proof { of, .. } = &mut f.certificate else {
                return;
            };
            *of = Proof::Conclusion(Box::new(of.clone()));
        })],
    );
}

/// What shows the value of a root.
fn rooted(found: &mut Found) -> &mut Signed<P> {
    match &mut ground(found).eliminated[0].by {
        Determining::Root(own) => own,
        other => panic!("{other:?}"),
    }
}

#[test]
fn the_sides_of_an_absolute_value() {
    let sides = |found: &mut Found| match proof(found) {
        Proof::Sides(sides) => sides.clone(),
        other => panic!("{other:?}"),
    };
    let lines = "assume = ['a <= r', 'b <= r']\nstates = 'max(a, b) <= r'";
    // The right proof of another statement.
    let mut wrong = found(lines);
    wrong.core = found("assume = ['a <= r', 'b <= r']\nstates = 'max(a, b) <= b'").core;
    assert!(matches!(wrong.checked(), Err(CheckError::Wrong(_))));
    rejected(
        lines,
        &[
            ("both sides exchanged", &|f| {
                let mut own = sides(f);
                std::mem::swap(&mut own.above, &mut own.below);
                *proof(f) = Proof::Sides(own);
            }),
            ("one side twice", &|f| {
                let mut own = sides(f);
                own.below = own.above.clone();
                *proof(f) = Proof::Sides(own);
            }),
            ("a root that is none", &|f| {
                let mut own = sides(f);
                own.root = "r".to_owned();
                *proof(f) = Proof::Sides(own);
            }),
            ("one side alone", &|f| {
                let own = sides(f);
                *proof(f) = own.above;
            }),
        ],
    );
}

#[test]
fn roots() {
    // The right proof of another statement.
    let mut wrong = found("states = 'sqrt(u^2) == u'");
    wrong.core = found("states = 'sqrt(a^2) == a'").core;
    assert!(matches!(wrong.checked(), Err(CheckError::Wrong(_))));
    rejected(
        "states = 'sqrt(u^2*v^2) == u*v'",
        &[
            ("no value", &|f| ground(f).eliminated.clear()),
            ("another value", &|f| {
                more(&mut ground(f).eliminated[0].values[0].value.above);
            }),
            ("the other sign", &|f| {
                let value = &mut ground(f).eliminated[0].values[0].value.above;
                *value = value.negated();
            }),
            ("another denominator", &|f| {
                more(&mut ground(f).eliminated[0].values[0].value.below);
            }),
            ("the sign of something else", &|f| {
                more(&mut rooted(f).sign.polynomial);
            }),
            ("the value of another symbol", &|f| {
                ground(f).eliminated[0].values[0].symbol = Symbol::named("u");
            }),
            ("an assumed equation", &|f| {
                ground(f).eliminated[0].by = Determining::Assumed { nonzero: vec![] };
            }),
        ],
    );
    rejected(
        "states = 'sqrt(u)^3 == u*sqrt(u)'",
        &[
            ("another multiple", &|f| {
                more(&mut combination(f).multipliers[0][0]);
            }),
            ("another equation", &|f| {
                more(&mut combination(f).equations[0])
            }),
        ],
    );
    rejected(
        "states = 'sqrt(a) == b'",
        &[("another root", &|f| {
            for value in &mut point(f).at {
                if value.symbol == Symbol::named("sqrt(a)") {
                    more(&mut value.value.above);
                }
            }
        })],
    );
}

/// By the equations in these places.
fn given(places: Vec<usize>) -> Determining<P> {
    let nonzero = vec![];
    Determining::Given { places, nonzero }
}

#[test]
fn eliminations() {
    let lines = "given = ['a*r + b*s == 1', 'b*r - a*s == 0']\nsolve_for = ['r', 's']\nstates = '(a^2 + b^2)*r^2 == a*r'";
    rejected(
        lines,
        &[
            ("no elimination", &|f| ground(f).eliminated.clear()),
            ("another value", &|f| {
                more(&mut ground(f).eliminated[0].values[0].value.above);
            }),
            ("another denominator", &|f| {
                more(&mut ground(f).eliminated[0].values[0].value.below);
            }),
            ("an equation twice", &|f| {
                ground(f).eliminated[0].by = given(vec![0, 0]);
            }),
            ("an equation that there is not", &|f| {
                ground(f).eliminated[0].by = given(vec![0, 7]);
            }),
            ("no condition", &|f| {
                let DecisionCertificate::Proof { conditions, .. } = &mut f.certificate else {
                    return;
                };
                conditions.clear();
            }),
        ],
    );
    rejected(
        "assume = ['x*r == a*b', 'x > 0']\nstates = 'r*x^2 == a*b*x'",
        &[
            ("another value", &|f| {
                more(&mut ground(f).eliminated[0].values[0].value.above);
            }),
            ("a hypothesis less", &|f| {
                f.core.hypotheses.truncate(1);
                ground(f).constraints.clear();
                ground(f).apart.clear();
                f.core.symbols.retain(|name, _| &**name != "x");
            }),
        ],
    );
}

#[test]
fn combinations() {
    rejected(
        "given = ['a*r + b*s == 1', 'b*r + a*s == 0']\nsolve_for = ['r', 's']\nstates = '(a + b)*(r + s) == 1'",
        &[
            ("a multiplier", &|f| {
                more(&mut combination(f).multipliers[0][0])
            }),
            ("an equation", &|f| more(&mut combination(f).equations[0])),
            ("both, such that the sum is right", &|f| {
                let own = combination(f);
                let [one, other] = [own.equations[0].clone(), own.equations[1].clone()];
                own.equations = vec![one.plus(&other)];
                own.multipliers = vec![vec![Polynomial::one()]];
                f.core.hypotheses.truncate(1);
            }),
            ("no multipliers", &|f| combination(f).multipliers.clear()),
        ],
    );
}

#[test]
fn orders() {
    rejected(
        "states = 'x/(1 + z) <= 1'",
        &[
            ("the relation", &|f| order(f).relation = Relation::Less),
            ("the numerator", &|f| more(&mut order(f).above)),
            ("a factor of the denominator", &|f| {
                more(&mut order(f).below[0].0)
            }),
            ("an exponent", &|f| order(f).below[0].1 += 1),
            ("no signs", &|f| order(f).signs.clear()),
            ("one sign less", &|f| {
                order(f).signs.pop();
            }),
            ("the polynomial of a sign", &|f| {
                more(&mut order(f).signs[0].polynomial);
            }),
            ("the sign of its negative", &|f| {
                let negative = order(f).above.negated();
                order(f).above = negative;
            }),
            ("strict, where it is not", &|f| {
                order(f).signs[0].strict = true
            }),
            ("an entry that there is not", &|f| order(f).entry = 1),
            ("the statement strict", &|f| {
                let torse_core::Statement::Compare { relation, .. } = &mut f.core.statement else {
                    return;
                };
                *relation = Relation::Less;
                order(f).relation = Relation::Less;
            }),
        ],
    );
}

#[test]
fn certificates() {
    let half = || Rational::from_str("1/2").unwrap();
    let boxes = "states = 'x^3 - x + z/8 + 1/2 > 0'";
    rejected(
        "assume = ['x + z >= 1']\nstates = '2*x + 2*z + x*z > 1'",
        &[("a piece that is not outside", &|f| {
            for piece in &mut whole(f).pieces {
                piece.outside = Some(0);
            }
        })],
    );
    rejected(
        "assume = ['a + b >= 1']\nstates = '2*a + 2*b > 1'",
        &[
            ("a multiple", &|f| {
                whole(f).multiples[0].multiple += integer(1)
            }),
            ("a negative multiple", &|f| {
                let own = whole(f);
                own.multiples[0].multiple = -own.multiples[0].multiple.clone();
            }),
            ("a constraint that there is not", &|f| {
                whole(f).multiples[0].constraint = 9;
            }),
            ("a constraint that is no hypothesis", &|f| {
                more(&mut ground(f).constraints[0].value.above);
            }),
            ("the rest", &|f| more(&mut whole(f).rest)),
            ("no pieces", &|f| whole(f).pieces.clear()),
        ],
    );
    rejected(
        "states = 'a^2 + a*b + b^2 >= 0'",
        &[
            ("the multiple of a square", &|f| {
                whole(f).squares[0].multiple += integer(1)
            }),
            ("a root", &|f| more(&mut whole(f).squares[0].root)),
            ("strict", &|f| {
                whole(f).strict = true;
            }),
        ],
    );
    rejected(
        boxes,
        &[
            ("a piece less", &|f| {
                let own = whole(f);
                own.pieces.pop();
            }),
            ("a piece that is too small", &|f| {
                let own = whole(f);
                own.pieces[0].region[0].1 = Rational::from_str("1/1024").unwrap();
            }),
            ("one piece for all", &|f| {
                let own = whole(f);
                own.pieces.truncate(1);
                for side in &mut own.pieces[0].region {
                    *side = (integer(0), integer(1));
                }
            }),
            ("an end that is too far inside", &|f| {
                for coordinate in &mut whole(f).coordinates {
                    if let Coordinate::Side { lower, .. } = coordinate {
                        lower.value = Polynomial::constant(half()).into();
                    }
                }
            }),
            ("a side that is no side", &|f| {
                whole(f).coordinates.pop();
            }),
            ("a symbol without a coordinate", &|f| {
                let own = whole(f);
                own.coordinates.clear();
                own.pieces.truncate(1);
                own.pieces[0].region.clear();
            }),
            ("a coordinate twice", &|f| {
                let own = whole(f);
                let again = own.coordinates[0].clone();
                own.coordinates.push(again);
            }),
        ],
    );
    rejected(
        "states = 'x*(2 - z) >= 0'",
        &[
            ("a factor less", &|f| {
                whole(f).factors.pop();
            }),
            ("a factor that may be negative", &|f| {
                let own = whole(f);
                own.factors = vec![Factor::Symbol(Symbol::named("a"))];
            }),
            ("a square too many", &|f| {
                whole(f)
                    .factors
                    .push(Factor::Square(Polynomial::symbol(Symbol::named("z"))));
            }),
        ],
    );
    rejected(
        "states = 'sin(pi/2*x) + cos(pi/2*x) >= 1'",
        &[
            ("another angle to begin at", &|f| {
                for coordinate in &mut whole(f).coordinates {
                    if let Coordinate::Tangent { from, .. } = coordinate {
                        *from += 1;
                    }
                }
            }),
            ("the end of a tangent", &|f| {
                for coordinate in &mut whole(f).coordinates {
                    if let Coordinate::Side { upper, .. } = coordinate {
                        upper.value = Polynomial::constant(half()).into();
                    }
                }
            }),
        ],
    );
}

#[test]
fn a_symbol_that_may_be_negative_is_no_ray() {
    // The right certificate of u >= 0, for a.
    let mut wrong = found("states = 'u >= 0'");
    let other = found("assume = ['a >= 0']\nstates = 'a >= 0'");
    let a = || Polynomial::symbol(Symbol::named("a"));
    wrong.core = other.core;
    wrong.core.hypotheses.clear();
    order(&mut wrong).above = a();
    let sign = &mut order(&mut wrong).signs[0];
    sign.polynomial = a();
    let own = certificate(sign);
    own.factors.clear();
    own.rest = a();
    own.coordinates.clear();
    let said = wrong.checked();
    assert!(matches!(said, Err(CheckError::Wrong(_))), "{said:?}");
}

#[test]
fn factors_and_rays_with_their_strictness() {
    rejected(
        "states = '(x + 1)*(a^2 + a + 1) > 0'",
        &[
            ("a factor less", &|f| {
                if let Shown::Factors(signs) = &mut order(f).signs[0].by {
                    signs.pop();
                }
            }),
            ("a factor that is not strict", &|f| {
                if let Shown::Factors(signs) = &mut order(f).signs[0].by {
                    signs[0].strict = false;
                }
            }),
            ("a factor with another sign", &|f| {
                if let Shown::Factors(signs) = &mut order(f).signs[0].by {
                    signs[0].polynomial = signs[0].polynomial.negated();
                }
            }),
        ],
    );
    let lines = "states = 'u*v*(1 + a + a^2) + a^2 - a + 1 > 0'";
    rejected(
        lines,
        &[
            ("no ray without symbols", &|f| {
                if let Shown::Rays(rays) = &mut order(f).signs[0].by {
                    rays.retain(|ray| ray.product.as_constant().is_none());
                }
            }),
            ("a ray that may be negative", &|f| {
                if let Shown::Rays(rays) = &mut order(f).signs[0].by {
                    for ray in rays {
                        ray.product = ray.product.negated();
                    }
                }
            }),
            ("a coefficient that is not strict", &|f| {
                if let Shown::Rays(rays) = &mut order(f).signs[0].by {
                    for ray in rays {
                        ray.coefficient.strict = false;
                    }
                }
            }),
        ],
    );
}

#[test]
fn decimals() {
    fn enclosure(found: &mut Found) -> &mut torse_certificate::enclosure::Enclosure<P> {
        match &mut ground(found).proof {
            Proof::Enclosure(own) => own,
            other => panic!("{other:?}"),
        }
    }
    rejected(
        "states = 'agrees([pi, sqrt(2)], [3.142, 1.4142])'",
        &[
            ("a value", &|f| {
                more(&mut enclosure(f).entries[0].value.above)
            }),
            ("how it agrees", &|f| {
                enclosure(f).entries[0].how = Some(Agreement::CutOff);
            }),
            ("an entry less", &|f| {
                enclosure(f).entries.pop();
            }),
            ("a printed number", &|f| {
                enclosure(f).entries[0].printed.value += integer(1);
            }),
        ],
    );
}

#[test]
fn counterexamples() {
    rejected(
        "assume = ['r == 2*a']\nstates = 'r*x <= a'",
        &[
            ("a point outside of a range", &|f| {
                for value in &mut point(f).at {
                    if value.symbol == Symbol::named("x") {
                        value.value = number(2);
                    }
                }
            }),
            ("a point that violates a hypothesis", &|f| {
                for value in &mut point(f).at {
                    if value.symbol == Symbol::named("r") {
                        more(&mut value.value.above);
                    }
                }
            }),
            ("a point at which the statement is true", &|f| {
                for value in &mut point(f).at {
                    value.value = number(0);
                }
            }),
            ("a side", &|f| {
                if let Failure::Sides { left, .. } = &mut point(f).failure {
                    more(&mut left[0].above);
                }
            }),
            ("two values of one symbol", &|f| {
                let mut again = point(f).at[0].clone();
                more(&mut again.value.above);
                point(f).others.push(again);
            }),
        ],
    );
    rejected(
        "states = 'agrees(pi, 3.15)'",
        &[("a value", &|f| {
            if let Failure::Printed(own) = &mut point(f).failure {
                more(&mut own.entries[0].value.above);
            }
        })],
    );
    rejected(
        "states = 'fails(x^2 == x)'",
        &[("a point at which it holds", &|f| {
            let Proof::Exists(refuted) = proof(f) else {
                panic!();
            };
            for value in &mut refuted.counterexample_mut().at {
                value.value = number(0);
            }
        })],
    );
    rejected(
        "states = 'fails(x*(1 - x) >= 0)'",
        &[
            ("what is denied has no proof", &|f| {
                if let Refuted::Denied { proof, .. } = refuted(f) {
                    **proof = Proof::Conclusion(proof.clone());
                }
            }),
            ("no point of the domain", &|f| {
                for value in &mut point(f).at {
                    value.value = number(2);
                }
            }),
        ],
    );
}

#[test]
fn cases() {
    rejected(
        "states = 'i*(i - 1)*(i - 2) == 0'",
        &[("an instance less", &|f| {
            if let Proof::Instances(own) = proof(f) {
                own.pop();
            } else {
                f.core.hypotheses.clear();
            }
        })],
    );
    rejected(
        "states = 'x >= 1/2 or x <= 1/2'",
        &[
            ("another alternative", &|f| {
                if let Proof::Alternative { place, .. } = proof(f) {
                    *place = 1 - *place;
                }
            }),
            ("an alternative everywhere", &|f| {
                if let Proof::Alternative {
                    where_others_fail, ..
                } = proof(f)
                {
                    *where_others_fail = false;
                }
            }),
            ("an alternative that there is not", &|f| {
                if let Proof::Alternative { place, .. } = proof(f) {
                    *place = 5;
                }
            }),
        ],
    );
    rejected(
        "states = 'a == 2*b implies a^2 == 4*b^2'",
        &[("without the premise", &|f| {
            let Proof::Conclusion(inner) = proof(f) else {
                panic!();
            };
            if let Proof::On(ground) = &mut **inner {
                ground.eliminated.clear();
            }
        })],
    );
    rejected(
        "states = 'x >= 0 and x^2 <= x'",
        &[("both halves exchanged", &|f| {
            if let Proof::Both(first, second) = proof(f) {
                std::mem::swap(first, second);
            }
        })],
    );
}

fn wronskians(found: &mut Found) -> &mut Wronskians {
    match &mut ground(found).proof {
        Proof::Wronskians(own) => own,
        other => panic!("{other:?}"),
    }
}

fn cell(found: &mut Found) -> &mut Cell {
    &mut wronskians(found).degrees[0].front.cells[0]
}

#[test]
fn total_positivity() {
    rejected(
        "states = 'variation_diminishing(G, 3, 4)'",
        &[
            ("a degree less", &|f| {
                wronskians(f).degrees.pop();
            }),
            ("a degree for another", &|f| {
                wronskians(f).degrees[1].degree = 5;
            }),
            ("half of the other end missing", &|f| {
                wronskians(f).degrees[0].back = None;
            }),
            ("an exchange that is none", &|f| {
                let exchange = Exchange {
                    swapped: false,
                    turned: [true, false],
                };
                wronskians(f).exchange = Some(exchange);
            }),
            ("a cell that ends early", &|f| {
                cell(f).until = Rational::from_str("1/4").unwrap();
            }),
            ("a cell that ends late", &|f| {
                cell(f).until = integer(1);
            }),
            ("no cells", &|f| {
                wronskians(f).degrees[0].front.cells.clear();
            }),
            ("too few places", &|f| {
                cell(f).nodes = 6;
            }),
            ("a disc that is no larger than the cell", &|f| {
                cell(f).radius = Rational::from_str("1/4").unwrap();
            }),
            ("a disc that is too large", &|f| {
                cell(f).radius = integer(8);
            }),
            (
                "a determinant that is too large to be multiplied out",
                &|f| {
                    wronskians(f).degrees[1].front.exact.push(4);
                },
            ),
        ],
    );
}
