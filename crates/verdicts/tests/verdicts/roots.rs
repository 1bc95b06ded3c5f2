//! Roots of formulas: `sqrt`, `norm` and `abs` of what contains symbols.

#![allow(
    clippy::unwrap_used,
    clippy::expect_used,
    clippy::panic,
    clippy::indexing_slicing,
    reason = "helpers of tests"
)]

use crate::common;

use torse_syntax::taxonomy::Verdict::{self, Conditional, False, Holds, Undecided};
use torse_verdicts::words;

const SHARED: &str = r#"
[symbols]
x = {}
y = {}
a = { in = "(0, inf)" }
b = { in = "(0, inf)" }
h = {}
t = {}
s = { in = "[0, 1]" }
p = { vector = 3 }
q = { vector = 3 }
c = { function = 3 }

[define]
"helix(u)" = '[a*cos(u), a*sin(u), h*u]'
N = '[cos(t), sin(t), 0]'
"#;

#[track_caller]
fn verdict(lines: &str, wanted: Verdict) {
    let found = common::outcomes("roots", SHARED, &[lines]);
    let found = found.first().expect("one claim");
    assert_eq!(found.contradiction(), None, "{lines}");
    println!(
        "{lines}\n   {:?} replay {:?}\n   conditions {:?} net {:?}\n    {:?}",
        found.verdict(),
        found.replay(),
        found
            .conditions()
            .iter()
            .map(|f| &f.text)
            .collect::<Vec<_>>(),
        found.net().map(|n| (n.netted, n.decided, n.why.clone())),
        found.witness(),
    );
    assert_eq!(
        found.verdict(),
        wanted,
        "{lines}: {:#?}",
        words::steps(found)
    );
}

#[track_caller]
fn states(statement: &str, wanted: Verdict) {
    verdict(&format!("states = \"{statement}\""), wanted);
}

#[test]
fn a_root_of_a_square_is_that_with_its_sign() {
    states("sqrt(a^2) == a", Holds);
    states("sqrt(x^2) == x", False);
    states("sqrt(x^2) == abs(x)", Holds);
    states("abs(-x) == abs(x)", Holds);
    states("abs(x*y) == abs(x)*abs(y)", Holds);
    states("abs(x + y) == abs(x) + abs(y)", False);
    states("sqrt(4*a^2*b^2/(a + b)^2) == 2*a*b/(a + b)", Holds);
    states("sqrt(x)^2 == x", Holds);
    states("sqrt(x^2*y) == x*sqrt(y)", False);
    states("sqrt(a^2*y) == a*sqrt(y)", Holds);
    states("sqrt(a)*sqrt(b) == sqrt(a*b)", Holds);
    states("sqrt(a)/sqrt(b) == sqrt(a/b)", Holds);
    states("sqrt(a + b) == sqrt(a) + sqrt(b)", False);
    states("sqrt(cos(t)^2 + sin(t)^2) == 1", Holds);
    states("sqrt(1 - cos(t)^2) == abs(sin(t))", Holds);
    states("sqrt(1 - cos(t)^2) == sin(t)", False);
    verdict("assume = ['x <= 0']\nstates = 'abs(x) == -x'", Holds);
    states("sqrt(x - x) + sqrt(a)/sqrt(a) == 1", Holds);
    // Roots among the hypotheses.
    verdict("assume = ['sqrt(x) == y']\nstates = 'x == y^2'", Holds);
    verdict("assume = ['sqrt(x) == y']\nstates = 'y >= 0'", Holds);
    verdict("assume = ['sqrt(x) == y']\nstates = 'y > 0'", False);
    verdict(
        "assume = ['x == sqrt(x*y)']\nstates = 'x == y'",
        Conditional,
    );
    verdict("assume = ['abs(x) == 1']\nstates = 'x^2 == 1'", Holds);
    verdict("assume = ['x == 4']\nstates = 'sqrt(x) == 2'", Holds);
    verdict(
        "assume = ['x >= y']\nstates = 'sqrt((x - y)^2) == x - y'",
        Holds,
    );
}

#[test]
fn unit_vectors_have_length_one_where_they_are_defined() {
    states("dot(p/norm(p), p/norm(p)) == 1", Conditional);
    verdict(
        "assume = ['p != [0, 0, 0]']\nstates = 'norm(p/norm(p)) == 1'",
        Holds,
    );
    verdict(
        "assume = ['p != [0, 0, 0]']\nstates = 'norm(p)/norm(p) == 1'",
        Holds,
    );
    states("norm(N) == 1", Holds);
    states("norm(p)^2 == dot(p, p)", Holds);
    states("norm(-2*p) == 2*norm(p)", Holds);
    states("norm(x*p) == abs(x)*norm(p)", Holds);
    states("norm(x*p) == x*norm(p)", False);
    states("norm(p + q) == norm(p) + norm(q)", False);
    states("1/sqrt(x^2 + 1)^2 == 1/(x^2 + 1)", Holds);
}

#[test]
fn derivatives_of_roots_divide_by_them() {
    states("D(sqrt(x^2 + 1), x) == x/sqrt(x^2 + 1)", Holds);
    states("D(sqrt(x^2 + 1), x) == 1/sqrt(x^2 + 1)", False);
    states("D(sqrt(x^2 + 1), x, 2) == 1/sqrt(x^2 + 1)^3", Holds);
    states("D(D(sqrt(x^2 + 1), x), x) == 1/sqrt(x^2 + 1)^3", Holds);
    states("D(sqrt(x), x) == 1/(2*sqrt(x))", Conditional);
    states("D(sqrt(a), a) == 1/(2*sqrt(a))", Holds);
    states(
        "D(sqrt(1 + sqrt(1 + x^2)), x) == x/(2*sqrt(1 + x^2)*sqrt(1 + sqrt(1 + x^2)))",
        Holds,
    );
    states("at(D(sqrt(x^2 + 1), x), x, y) == y/sqrt(y^2 + 1)", Holds);
}

#[test]
fn curvature_and_torsion_of_the_helix() {
    states("norm(helix'(t)) == sqrt(a^2 + h^2)", Holds);
    states(
        "norm(cross(helix'(t), helix''(t)))/norm(helix'(t))^3 == a/(a^2 + h^2)",
        Holds,
    );
    states(
        "norm(cross(helix'(t), helix''(t)))/norm(helix'(t))^3 == a/(a^2 + h^2)^2",
        False,
    );
    states(
        "norm(D(helix'(t)/norm(helix'(t)), t))/norm(helix'(t)) == a/(a^2 + h^2)",
        Holds,
    );
    states(
        "dot(c'(t)/norm(c'(t)), D(c'(t)/norm(c'(t)), t)) == 0",
        Conditional,
    );
}

#[test]
fn relations_of_order_with_roots() {
    states("sqrt(x) >= 0", Holds);
    states("norm(p) >= 0", Holds);
    states("sqrt(x^2 + 1) > 0", Holds);
    // The root stays positive where what it is the root of is eliminated.
    verdict(
        "assume = ['y^2*x^2 > x']\nstates = '-(sqrt(x) + y^2*x^2)^2 != x + 2*y^2*x^2*sqrt(x) + y^4*x^4'",
        Holds,
    );
    states("abs(x) < 1", False);
    states("sqrt(s) <= s", False);
    states("sqrt(x^2 + 1) <= 1", False);
    states("norm(p + q) >= norm(p) + norm(q)", False);
}

#[test]
fn differences_are_compared_by_squares() {
    states("sqrt(x^2 + 1) >= 1", Holds);
    states("sqrt(x^2 + 1) > x", Holds);
    states("abs(x) >= x", Holds);
    states("abs(x + y) <= abs(x) + abs(y)", Holds);
    states("sqrt(a*b) <= (a + b)/2", Holds);
    states("sqrt(s) >= s", Holds);
    states("sqrt(1 - s^2) <= 1", Holds);
    states("norm(p + q) <= norm(p) + norm(q)", Holds);
    states("sqrt(a + b) <= sqrt(a) + sqrt(b)", Holds);
    // Almost the same.
    states("sqrt(x^2 + 1) > 1", False);
    states("sqrt(x^2) > x", False);
    states("abs(x + y) >= abs(x) + abs(y)", False);
    states("sqrt(a*b) <= (a + b)/3", False);
    states("sqrt(s) > s", False);
    states("norm(p + q) < norm(p) + norm(q)", False);
    states("sqrt(a + b) >= sqrt(a) + sqrt(b)", False);
}

#[test]
fn what_cannot_be_carried_is_refused_and_never_decided() {
    for lines in [
        "states = 'sum(i, 1, 3, sqrt(x + i)) == 0'",
        "states = 'D(sqrt(x^2 + 1), x, 7) == 0'",
        // Defined nowhere.
        "states = 'sqrt(-1 - x^2) == 5'",
    ] {
        let paper = common::loaded("roots", SHARED, &[lines]).unwrap();
        let found = torse_verdicts::engine::decide_claim("roots", &paper.claims[0]);
        let open = found.map_or(true, |outcome| outcome.verdict() == Undecided);
        assert!(open, "{lines}");
    }
}

#[test]
fn every_claim_with_roots_of_the_derivations_has_the_verdict_that_it_expects() {
    let folder = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("../../derivations");
    let papers = torse_syntax::derivation::load(&folder).unwrap();
    let (mut count, mut wrong) = (0, vec![]);
    for paper in papers {
        for claim in &paper.claims {
            let text = claim
                .statement
                .as_ref()
                .map(|s| torse_syntax::notation::text(&s.expr));
            let text = text.unwrap_or_default();
            let ours = ["bezier", "trigonometric", "hyperbolic", "torses"];
            let has_root = ["sqrt(", "norm(", "abs("]
                .iter()
                .any(|name| text.contains(name));
            if !has_root || !ours.contains(&paper.head.id.as_str()) {
                continue;
            }
            count += 1;
            let started = std::time::Instant::now();
            let found = torse_verdicts::engine::decide_claim(&paper.head.id, claim).unwrap();
            let replayed = found.replay().map(|r| (r.replayed, r.why.clone()));
            let correction = found.correction().map(|c| &c.statement.text);
            println!(
                "{} {:?} {replayed:?} {correction:?} {:?}",
                found.claim.id,
                found.verdict(),
                started.elapsed()
            );
            if Some(found.verdict()) != claim.entry.expect || found.contradiction().is_some() {
                wrong.push(format!(
                    "{}: {:?} {:?}",
                    found.claim.id,
                    found.verdict(),
                    words::steps(&found)
                ));
            }
        }
    }
    assert!(count >= 20, "{count}");
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

/// A generator of numbers, the same on every run.
struct Dice(u64);

impl Dice {
    fn below(&mut self, n: u64) -> u64 {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        (self.0 >> 11) % n
    }

    fn one_of<'t>(&mut self, all: &[&'t str]) -> &'t str {
        let count = u64::try_from(all.len()).unwrap();
        all[usize::try_from(self.below(count)).unwrap()]
    }

    /// A small polynomial.
    fn formula(&mut self) -> String {
        let symbol = |dice: &mut Self| dice.one_of(&["x", "y", "a", "b", "s", "2", "3"]);
        let (p, q) = (symbol(self), symbol(self));
        let sign = self.one_of(&["+", "-", "*"]);
        match self.below(5) {
            0 => p.to_owned(),
            1 => format!("{p}^2"),
            2 => format!("({p}^2 {sign} {q}^2)"),
            3 => format!("({p}^2 + {q}^2 + 1)"),
            _ => format!("({p} {sign} {q})"),
        }
    }

    fn statement(&mut self) -> String {
        let (p, q) = (self.formula(), self.formula());
        let equal = self.one_of(&["==", "==", "==", "==", "<=", ">=", "!="]);
        let c = self.one_of(&["1", "1", "1", "2", "-1"]);
        let v = self.one_of(&["x", "a", "s"]);
        let left_right = match self.below(12) {
            0 => (format!("sqrt({p}^2*{q})"), format!("{p}*sqrt({q})")),
            1 => (format!("sqrt({p}^2*{q})"), format!("abs({p})*sqrt({q})")),
            2 => (format!("sqrt({p})*sqrt({q})"), format!("sqrt({p}*{q})")),
            3 => (
                format!("D(sqrt({p}), {v})"),
                format!("D({p}, {v})/(2*sqrt({p}))"),
            ),
            4 => (format!("abs({p} + {q})"), format!("abs({p}) + abs({q})")),
            5 => (format!("norm([{p}, {q}])"), format!("sqrt({p}^2 + {q}^2)")),
            6 => (format!("sqrt({p})/sqrt({q})"), format!("sqrt({p}/{q})")),
            7 => (
                format!("(sqrt({p}) + {q})^2"),
                format!("{p} + 2*{q}*sqrt({p}) + {q}^2"),
            ),
            8 => (
                format!("1/(sqrt({p}) - sqrt({q}))"),
                format!("(sqrt({p}) + sqrt({q}))/({p} - {q})"),
            ),
            9 => (
                format!("D(abs({p})/sqrt({q}), {v})"),
                format!("D(abs({p}), {v})/sqrt({q}) - abs({p})*D({q}, {v})/(2*sqrt({q})^3)"),
            ),
            10 => (
                format!("sqrt({p} + sqrt({q}))^2"),
                format!("{p} + sqrt({q})"),
            ),
            _ => (format!("sqrt({p}^2)"), p.clone()),
        };
        let assumed = match self.below(3) {
            0 => format!("assume = ['{p} >= 0']\n"),
            1 => format!("assume = ['{q} > x']\n"),
            _ => String::new(),
        };
        let (left, right) = left_right;
        // Of this kind no correction is sought.
        format!("kind = 'inequality'\n{assumed}states = '{c}*{left} {equal} {right}'")
    }
}

#[test]
fn random_claims_about_roots_contradict_neither_the_semantics_nor_the_checker() {
    let wanted = std::env::var("TORSE_RANDOM")
        .ok()
        .and_then(|n| n.parse().ok());
    let mut dice = Dice(0x5eed_0f07_0075);
    let mut counts: std::collections::BTreeMap<String, usize> = std::collections::BTreeMap::new();
    let mut replayed = 0;
    for _ in 0..wanted.unwrap_or(250) {
        let lines = dice.statement();
        let Ok(paper) = common::loaded("random", SHARED, &[&lines]) else {
            panic!("{lines}");
        };
        let found = torse_verdicts::engine::decide_claim("random", &paper.claims[0]);
        let kind = match found {
            Ok(found) => {
                assert_eq!(
                    found.contradiction(),
                    None,
                    "{lines}: {:?}",
                    words::steps(&found)
                );
                replayed += usize::from(found.replay().is_some_and(|r| r.replayed));
                let netted = found.net().is_some_and(|net| net.netted);
                format!(
                    "{:?}{}",
                    found.verdict(),
                    if netted { " netted" } else { "" }
                )
            }
            Err(fault) => {
                println!("{lines}: {fault}");
                "fault".to_owned()
            }
        };
        *counts.entry(kind).or_default() += 1;
    }
    println!("{counts:?}, {replayed} replayed");
}
