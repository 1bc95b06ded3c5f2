//! What a statement rests on is laid out for its reader.

use crate::common;

const FILE: &str = r#"
[symbols]
x = { in = "[0, 1]" }
k = { integer = ">= 2" }
i = { integer = "0..k" }
mu = { in = "[-1, 1)" }
nu = {}
unused = {}
Q = { family = 4, indices = ["0..k"] }
[basis.f]
variable = "z"
parameters = ["mu"]
degree = 1
seeds = ['1 - z*mu', 'z*mu']
step = ['1 - z', 'z']
[define]
deep = 'nu + 1'
c = 'deep*2'
"H(x)" = 'sum(i, 0, k, f[i,k](x)*Q[i])'
other = 'unused'
[display]
mu = '$\mu$'
c = '$c$'
"#;

#[test]
fn symbols_definitions_and_bases_are_listed_once_in_the_order_of_use() {
    let claim = r#"
let = { own = 'c + x' }
given = ["H(0) == [0, 0, 0, own]"]
solve_for = ['Q[0]']
assume = ['own > 0']
states = "Q[0] == [0, 0, 0, own] and own == own"
"#;
    let outcome = common::outcomes("table", FILE, &[claim]).remove(0);
    let table = &outcome.claim.table;
    let sets: Vec<&str> = table.symbols.iter().map(|s| s.set.as_str()).collect();
    assert_eq!(
        sets,
        [
            "Q[0..k], points with 4 coordinates",
            "nu, a real number",
            "x in [0, 1]",
            "k >= 2, an integer",
            "mu in [-1, 1)",
        ]
    );
    let definitions = table.definitions.iter();
    let definitions: Vec<String> = definitions
        .map(|d| format!("{} = {} {}", d.head.text, d.body.text, d.own))
        .collect();
    assert_eq!(
        definitions,
        [
            "own = c + x true",
            "c = deep*2 false",
            "deep = nu + 1 false",
            "H(x) = sum(i, 0, k, f[i,k](x)*Q[i]) false",
        ]
    );
    let basis = &table.bases[0];
    assert_eq!(
        (table.bases.len(), basis.head.text.as_str()),
        (1, "f[i,k](z, mu)")
    );
    let seeds: Vec<&str> = basis.seeds.iter().map(|s| s.text.as_str()).collect();
    assert_eq!(seeds, ["1 - z*mu", "z*mu"]);
    let unknowns: Vec<&str> = table.unknowns.iter().map(|u| u.text.as_str()).collect();
    assert_eq!(unknowns, ["Q[0]"]);
    let displays = |name: &str| {
        let found = table.symbols.iter().find(|s| s.name == name);
        found.unwrap().display.clone()
    };
    assert_eq!(displays("mu").as_deref(), Some("$\\mu$"));
    assert_eq!(displays("x"), None);
    assert_eq!(table.definitions[1].display.as_deref(), Some("$c$"));
}
