//! What is written from the tree, construct by construct: the text is compared with what was read and approved.

use std::sync::Arc;
use torse_rocq::proposition::Proposition;
use torse_rocq::tree::sentence;
use torse_syntax::derivation::{LoadError, Source, paper};

const DECLARATIONS: &str = r#"
[symbols]
x = {}
y = {}
t = { in = "[0, 1]" }
mu = { in = "[-1, 1]" }
i = { integer = '0..m' }
m = { integer = '>= 1' }
v = { vector = 3 }
f = { function = 1 }
c = { function = 3 }
P = { family = 1, indices = ['0..m'] }
Q = { family = 2 }
s = { in = "[0, inf)" }
[basis.B]
variable = 'x'
parameters = ['mu']
degree = 1
seeds = ['1 - mu*x', 'mu*x']
step = ['1 - x', 'x']
[basis.U]
variable = 'x'
degree = 0
seeds = ['1']
index = 'q'
order = 'r'
step = ['(q + 1 - x)/r', '(x + r - q)/r']
[basis.V]
variable = 't'
degree = 1
seeds = ['1 - t/y', 't/y']
[define]
w = 'x/y'
'F(t)' = 'w*t^2 + mu'
'G(x)' = 'F(x) + w'
'power(a, n)' = 'a^n'
'len(p)' = 'dot(p, p)'
'curve(x)' = 'sum(i, 0, m, B[i,m](x)*P[i])'
slope = "F'"
"#;

/// What is written of a claim: its definitions, and the statement.
fn written(fields: &str) -> String {
    let text = format!(
        "{DECLARATIONS}\n[[claim]]\nid = 'p/c'\nat = 'Sect. 1'\nkind = 'identity'\nprinted = 'as stated'\n{fields}\n"
    );
    let read = |name: &str| -> Result<Arc<Source>, LoadError> {
        let head = "[paper]\nid = 'p'\ntitle = ''\nauthors = ''\nvenue = ''\nclaims = ['c.toml']\n";
        let text = if name == "paper.toml" {
            head.to_owned()
        } else {
            text.clone()
        };
        Ok(Arc::new(Source::new(name, text)))
    };
    let paper = paper(read).unwrap();
    let claim = paper.claims.first().unwrap();
    let statement = claim.statement.as_ref().unwrap();
    match sentence(claim, &statement.expr, &[]) {
        Ok(proposition) => shown(&proposition),
        Err(gap) => gap.to_string(),
    }
}

fn shown(proposition: &Proposition) -> String {
    let definitions = proposition.definitions.iter();
    let definitions: String = definitions.map(|(_, text)| format!("{text}\n")).collect();
    format!("{definitions}{}", proposition.universal())
}

fn states(statement: &str) -> String {
    written(&format!("states = \"{statement}\""))
}

/// Statements by what they are about.
const STATEMENTS: [(&str, &str); 28] = [
    ("a definition over what it reaches", "F(t) == w*t^2 + mu"),
    ("a definition through another", "G(2) == G(t)"),
    ("a derivative by a parameter", "F'(t) == 2*w*t"),
    (
        "a derivative by a symbol moves definitions",
        "D(F(t), x) == t^2/y",
    ),
    (
        "a function differentiated by a symbol",
        "D(F, x)(x) == x^2/y",
    ),
    ("a derivative of a derivative", "D(D(F(x*y), x), y) == 0"),
    ("a parameter is not the symbol", "D(G(x), x) == 0"),
    ("at a value", "at(w, y, t + 1) == x/(t + 1)"),
    ("a statement at a value", "at(x == y and w == 1, x, y)"),
    (
        "at a value below a derivative by it",
        "at(D(x*y, y), x, y) == y",
    ),
    (
        "an index that is an exponent",
        "power(x, m) == x*power(x, m - 1)",
    ),
    (
        "a vector as an argument",
        "len(v) >= 0 and len([x, y]) == x^2 + y^2",
    ),
    (
        "a basis with the parameters left out",
        "sum(i, 0, m, B[i,m]) == 1",
    ),
    ("a basis at values", "B[0,2](1/2, t) == B[2,2](1/2)"),
    ("a basis that counts", "U[1,2](x) == 1/2"),
    (
        "a sum whose index is a symbol outside",
        "sum(i, 0, i, P[i]) == P[i]",
    ),
    ("a sum in a definition", "curve(t) == curve(0)"),
    ("members and coordinates", "Q[m][1] == Q[m][2]"),
    (
        "a chain and words",
        "0 < x <= y or x == 0 implies not y == 0",
    ),
    (
        "a denial of the point, below a word",
        "x == 1 implies not (x/y < 1 and t >= 0)",
    ),
    (
        "what fails in the domain has its own terms",
        "x == x and fails(x/y == 1)",
    ),
    ("what fails below a word", "x == 1 or fails(x == y)"),
    ("printed decimals", "agrees([x, y], [0.5, -0.25])"),
    ("roots and quotients", "sqrt(x)/tan(y) == abs(x)"),
    (
        "the smaller and the greater number",
        "min(x, y) + max(x, y)/y == D(max(x, 1), x)",
    ),
    ("a smooth function", "f'(x*y) == D(f(x), x) and f(t) > 0"),
    ("a smooth curve", "dot(c'(x), D(c, x, 2)(x)) == 0"),
    ("a definition that is a derivative", "slope(t) == 2*w*t"),
];

#[test]
fn every_construct_is_written_as_it_stands() {
    let texts = STATEMENTS
        .map(|(about, statement)| format!("-- {about}: {statement}\n{}\n", states(statement)));
    insta::assert_snapshot!("constructs", texts.join("\n"));
}

#[test]
fn hypotheses_equations_and_numbers_that_there_are_are_written() {
    let claims = [
        "assume = ['x/y > 0', 'm >= 2']\nstates = 'x*y > 0'",
        "given = ['x*y == t']\nsolve_for = ['x']\nstates = 'coefficients([x + t], [t])[1, 1] == 1/y + 1'",
        "given = ['x + mu == y']\nsolve_for = ['x']\nstates = 'coefficients([x], [y])[1, 1] == 1'",
        "exists = ['s']\nstates = 's^2 == x^2 and 1/s == 1/abs(x)'",
        "states = 'coefficients([3*P[0] - P[1]], [P[1], y]) == [[-1, 0]]'",
    ];
    let texts = claims.map(|claim| format!("-- {claim}\n{}\n", written(claim)));
    insta::assert_snapshot!("claims", texts.join("\n"));
}

#[test]
fn properties_are_about_every_degree() {
    let texts = [
        states("nonnegative(B)"),
        states("independent(B)"),
        states("mu < 0 implies nonnegative(B)"),
        states("at(nonnegative(V), y, mu)"),
        states("integral(x, x, 0, 1) == 1/2"),
    ];
    insta::assert_snapshot!("properties", texts.join("\n\n"));
}

#[test]
fn statements_of_the_folder_have_no_axioms_and_nothing_admitted_or_computed() {
    let proofs = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("../../proofs");
    let mut seen = 0;
    for folder in std::fs::read_dir(proofs).unwrap().flatten() {
        if !folder.path().is_dir() || folder.file_name() == "Torse" {
            continue;
        }
        for file in std::fs::read_dir(folder.path()).unwrap().flatten() {
            let name = file.file_name().into_string().unwrap();
            if name.ends_with("_proofs.v") || name.ends_with("_closed.v") {
                continue;
            }
            let text = std::fs::read_to_string(file.path()).unwrap();
            for word in [
                "vm_compute",
                "native_compute",
                "Axiom",
                "Parameter",
                "admit",
            ] {
                let found = text
                    .lines()
                    .any(|line| line.starts_with(word) || line.contains(&format!("{word}.")));
                assert!(!found, "{name}: {word}");
            }
            seen += 1;
        }
    }
    assert!(seen > 100, "{seen}");
}
