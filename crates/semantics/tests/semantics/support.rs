//! Claims from a few lines of text.

#[path = "../../../../tests/support/claims.rs"]
mod claims;

use claims::paper_of;
use torse_semantics::tree::{Reading, Values};
use torse_semantics::{
    Judgement, Name, Point, Reals, SampleStatistics, ViolationStatistics, Witness, Work,
    judge_samples,
};
use torse_syntax::derivation::declarations::SymbolKind;
use torse_syntax::derivation::{self, Paper};
use torse_syntax::formula::Expr;

/// Symbols and bases that every claim of the tests may use.
const SHARED: &str = r#"
[symbols]
x = { in = "[0, 1]" }
u = { in = "[0, 1]" }
v = { in = "[0, 1]" }
w = { in = "[0, inf)" }
mu = { in = "[-1, 1]" }
phi = { in = "(0, pi)" }
a = {}
b = {}
c = {}
d = {}
e = {}
f = {}
r = {}
s = {}
y = {}
m = { integer = ">= 1" }
n = { integer = ">= 2" }
i = { integer = "0..m" }
o = { integer = "0..1" }
p = { vector = 3 }
q = { vector = 3 }
g = { vector = "any" }
P = { family = "any", indices = ["0..m"] }
Q = { family = 3, indices = ["0..m", "0..1"] }

[basis.B]
variable = "x"
degree = 0
seeds = ['1']
step = ['1 - x', 'x']

[basis.H]
variable = "x"
degree = 0
seeds = ['1']
step = ['1', 'x']

[basis.T]
variable = "x"
parameters = ["mu"]
degree = 2
seeds = ['(1 - x)^2 + mu*x', '2*x*(1 - x)', 'x^2']
step = ['1 - x', 'x']

[basis.N]
variable = "x"
degree = 0
seeds = ['1']
index = "j"
order = "k"
step = ['(j + 1 - x)/(k - j)', '(x + k - j)/j']

[basis.V]
variable = "x"
degree = 1
seeds = ['1 - a^3*x', 'a^3*x']
step = ['1 - x', 'x']
"#;

/// A paper of one claim with these further fields (TOML) and this statement.
pub fn paper(fields: &str, states: &str) -> Paper {
    let lines = format!("{fields}\nstates = '''{states}'''");
    paper_of("t", SHARED, &[&lines]).unwrap_or_else(|error| panic!("{error:?} in {lines}"))
}

/// A claim, with the names of the declared symbols that occur in its text.
pub struct Claim {
    paper: Paper,
    names: Vec<String>,
}

impl Claim {
    /// The claim as it was read.
    pub fn own(&self) -> &derivation::Claim {
        self.paper.claims.first().expect("one claim")
    }

    pub fn statement(&self) -> &Expr {
        &self.own().statement.as_ref().expect("a statement").expr
    }

    pub fn reading(&self) -> Reading<'_> {
        let names = self.names.iter().map(String::as_str);
        Reading::new(self.own(), self.statement(), names)
    }

    /// A point of the claim.
    pub fn point(&self, numbers: &[(&str, &str)]) -> Point {
        let point = torse_semantics::read(self.own(), numbers.iter().copied());
        point.expect("a point of the claim")
    }

    /// What a point is that is said to refute the statement.
    pub fn check(&self, numbers: &[(&str, &str)]) -> Witness {
        torse_semantics::check_witness(self.own(), self.statement(), numbers.iter().copied())
    }

    /// The statement where a condition fails.
    pub fn judge_violations(&self, condition: &Self) -> ViolationStatistics {
        let (reading, condition) = (self.reading(), condition.statement());
        torse_semantics::judge_violations(&reading, condition, "t/c", 10, 4_000_000)
            .expect("a comparison")
    }
}

/// A claim with these further fields (TOML) and this statement.
pub fn claim(fields: &str, states: &str) -> Claim {
    let paper = paper(fields, states);
    let text = format!("{fields} {states}");
    let words = text.split(|c: char| !c.is_alphanumeric() && c != '_');
    let mut names: Vec<String> = words.map(str::to_owned).collect();
    if names
        .iter()
        .any(|name| ["i", "P", "Q"].contains(&name.as_str()))
    {
        names.push("m".to_owned());
    }
    let declarations = &paper.claims.first().expect("one claim").declarations;
    names.retain(|name| declarations.symbol(name).is_some());
    Claim { paper, names }
}

/// What the tree of the statement is at a point: with a memory, and without, which is the same.
pub fn tree_at(claim: &derivation::Claim, point: &Point) -> Judgement {
    let statement = &claim.statement.as_ref().expect("a statement").expr;
    let names: Vec<String> = point
        .values
        .keys()
        .map(|n| n.declared().to_string())
        .collect();
    let reading = Reading::new(claim, statement, names.iter().map(String::as_str));
    let mut last = Judgement::Undecided;
    for bits in [320, 1280] {
        let work = Work::new(4_000_000);
        let reals = Reals::new(bits, &work);
        let values = Values {
            number: &|name: &Name| point.values.get(name).cloned(),
            near: point.near,
            fails: &|_| false,
        };
        last = reading.statement(&reals, values);
        let plain = reading.statement_plainly(&reals, values);
        assert_eq!(last, plain, "with a memory, and without, at {point}");
        if last.decided().is_some() {
            break;
        }
    }
    last
}

/// The judgement at a point.
pub fn at(claim: &Claim, point: &[(&str, &str)]) -> Judgement {
    tree_at(claim.own(), &claim.point(point))
}

/// The judgement of a statement at a point, without hypotheses.
pub fn says(states: &str, point: &[(&str, &str)]) -> Judgement {
    at(&claim("", states), point)
}

/// Whether a statement is true at a point.
#[track_caller]
pub fn holds(states: &str, point: &[(&str, &str)]) {
    assert_eq!(
        says(states, point),
        Judgement::True,
        "{states} at {point:?}"
    );
}

/// Whether a statement is false at a point.
#[track_caller]
pub fn fails(states: &str, point: &[(&str, &str)]) {
    assert_eq!(
        says(states, point),
        Judgement::False,
        "{states} at {point:?}"
    );
}

/// Whether a statement is undefined at a point.
#[track_caller]
pub fn is_undefined(states: &str, point: &[(&str, &str)]) {
    let judgement = says(states, point);
    assert!(
        matches!(judgement, Judgement::Undefined(_)),
        "{states} at {point:?} is {judgement}"
    );
}

/// Points of the domain of a claim.
pub fn netted(claim: &Claim) -> SampleStatistics {
    judge_samples(&claim.reading(), &[], "t/c", 20, 4_000_000)
}

/// A claim that a point of its domain contradicts.
#[track_caller]
pub fn is_caught(fields: &str, states: &str) {
    let tally = netted(&claim(fields, states));
    assert!(tally.failing.is_some(), "{states} with {fields}: {tally:?}");
}

/// A claim that stands at twenty points of its domain, or at the only one.
#[track_caller]
pub fn stands(fields: &str, states: &str) {
    let tally = netted(&claim(fields, states));
    assert!(tally.failing.is_none(), "{states} with {fields}: {tally:?}");
    assert!(tally.enough, "{states} with {fields}: {tally:?}");
}

/// A denial that no point of the domain shows to be true.
#[track_caller]
pub fn is_never_denied(fields: &str, states: &str) {
    let tally = netted(&claim(fields, states));
    assert_eq!(tally.holding, 0, "{states} with {fields}: {tally:?}");
}

/// A claim whose domain has no point that is found.
#[track_caller]
pub fn is_empty(fields: &str, states: &str) {
    let tally = netted(&claim(fields, states));
    assert_eq!(tally.found, 0, "{states} with {fields}: {tally:?}");
}

/// What a statement is at a point, under further fields.
pub fn in_shared(fields: &str, states: &str, point: &[(&str, &str)]) -> Judgement {
    let paper = paper(fields, states);
    let claim = paper.claims.first().expect("one claim");
    tree_at(claim, &numbers_of(claim, point))
}

/// The same under other declarations (TOML).
pub fn in_declarations(declarations: &str, states: &str, point: &[(&str, &str)]) -> Judgement {
    let lines = format!("states = '''{states}'''");
    let paper = paper_of("t", declarations, &[&lines]);
    let paper = paper.unwrap_or_else(|error| panic!("{error:?} in {lines}"));
    let claim = paper.claims.first().expect("one claim");
    tree_at(claim, &numbers_of(claim, point))
}

/// A point from names such as `a`, `p[1]`, `P[0]`, and rational numbers.
fn numbers_of(claim: &derivation::Claim, point: &[(&str, &str)]) -> Point {
    let mut values = std::collections::BTreeMap::new();
    for (name, value) in point {
        let (numerator, denominator) = value.split_once('/').unwrap_or((value, "1"));
        let part = |text: &str| text.parse::<i64>().expect("an integer");
        let number = torse_numbers::rational::ratio(part(numerator), part(denominator));
        let (head, index) = name.split_once('[').unwrap_or((name, ""));
        let declared = std::sync::Arc::from(head);
        let index = || part(index.trim_end_matches(']'));
        let name = match claim.declarations.symbol(head) {
            Some(SymbolKind::Family { .. }) => Name::Member(declared, vec![index()], None),
            Some(SymbolKind::Vector(Some(_))) => {
                Name::Coordinate(declared, u8::try_from(index()).expect("a coordinate"))
            }
            _ => Name::Symbol(declared),
        };
        values.insert(name, number.expect("a rational number").into());
    }
    Point {
        values,
        near: false,
    }
}
