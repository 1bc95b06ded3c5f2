//! What is wrong with a file is told all at once, each with its place and what would be right.

use miette::Diagnostic;
use torse_designs::{DesignError, read};

/// The messages with the text that each points at.
fn mistakes(text: &str) -> Vec<(String, String)> {
    let Err(DesignError::Wrong { mistakes }) = read("x.toml", text) else {
        panic!("it is read");
    };
    mistakes
        .iter()
        .map(|mistake| {
            let label = mistake.labels().unwrap().next().unwrap();
            let at = label.offset()..label.offset() + label.len();
            (mistake.to_string(), text[at].to_owned())
        })
        .collect()
}

const PATCH: &str = "
[curves]
a = { bezier = [[0, 0, 0], [1, 2, 0], [3, 0, 0]] }
b = { bezier = [[0, 0, 1], [1, 2, 1], [3, 0, 1]] }
[patches.p]
ruled = [\"a\", \"b\"]
";

fn one(extra: &str) -> (String, String) {
    let mut all = mistakes(&format!("{extra}{PATCH}"));
    assert_eq!(all.len(), 1, "{all:?}");
    all.remove(0)
}

#[test]
fn a_file_without_mistakes_is_read() {
    assert!(read("x.toml", PATCH).is_ok());
}

#[test]
fn each_mistake_points_at_its_text() {
    let cases = [
        (
            "[design]\nunit = \"inch\"\n",
            "`inch` is no unit",
            "\"inch\"",
        ),
        (
            "[design]\ntitel = \"x\"\n",
            "[design] has no entry `titel`",
            "titel",
        ),
        (
            "[sheet]\nthickness = -1\n",
            "-1 is outside (0, infinity)",
            "-1",
        ),
        ("[let]\nr = \"2*q\"\n", "`q` is not declared", "q"),
        (
            "[let]\nr = \"s\"\ns = \"r + 1\"\n",
            "definitions are nested deeper than 64 levels: is one defined through itself?",
            "r",
        ),
        (
            "[points]\nA = [1, 2]\n",
            "2 numbers: 3 are wanted",
            "[1, 2]",
        ),
        (
            "[points]\nA = [1, 2, inf]\n",
            "inf is no finite number",
            "inf",
        ),
        (
            "[points]\nA = [1, 2, \"1/0\"]\n",
            "division by zero: 0 vanishes",
            "1/0",
        ),
        (
            "[points]\nA = [1, 2, \"sqrt(2\"]\n",
            "this `(` is never closed",
            "(",
        ),
        (
            "[planes]\np = { through = [[0, 0, 0], [1, 1, 1], [2, 2, 2]] }\n",
            "this plane has no normal: the points are on a line, or the vector is zero",
            "{ through = [[0, 0, 0], [1, 1, 1], [2, 2, 2]] }",
        ),
        (
            "[tolerances]\ntwist = 100\n",
            "100 is outside (0, 90]",
            "100",
        ),
        (
            "[view]\nrulings = 1e9\n",
            "1000000000 is outside 2, 3, .. 4097",
            "1e9",
        ),
    ];
    for (text, message, at) in cases {
        let (found, place) = one(text);
        assert_eq!((found.as_str(), place.as_str()), (message, at));
    }
}

#[test]
fn all_mistakes_are_told_and_none_twice() {
    let text = "
[let]
wrong = \"2*\"
[points]
A = [\"wrong\", 0, 0]
B = [\"wrong\", 0]
[curves]
c = { bezier = [\"A\", \"C\", [0, 0, 1]] }
d = { bezir = [[0, 0, 0], [1, 1, 1]] }
[patches]
p = { ruled = [\"c\", \"d\"] }
q = { ruled = [\"c\", \"e\"] }
r = { cone = \"c\" }
[chains]
all = { patches = [\"p\", \"s\"], continuity = \"G9\" }
";
    let found = mistakes(text);
    let messages: Vec<&str> = found.iter().map(|(message, _)| message.as_str()).collect();
    assert_eq!(
        messages,
        [
            "expected a number, a name or a bracket, found the end of the formula",
            "2 numbers: 3 are wanted",
            "no point above is called `C`",
            "[curves.d] is made in one of eleven ways",
            "[curves.d] has no entry `bezir`",
            "no curve above is called `e`",
            "a cone lacks its `apex`",
            "no patch above is called `s`",
            "`G9` is no continuity",
        ]
    );
}

#[test]
fn help_says_what_would_be_right() {
    let Err(DesignError::Wrong { mistakes }) = read("x.toml", "[curve.a]\nbezier = []\n") else {
        panic!("it is read");
    };
    let help = mistakes[0].help().unwrap().to_string();
    assert_eq!(help, "did you mean `[curves]`?");
}

#[test]
fn errors_of_toml_itself_are_told_together() {
    let found = mistakes("[a\nb = \n[c]\nd = 1 2\n");
    assert!(found.len() >= 2, "{found:?}");
}

#[test]
fn an_edge_is_not_sewn_to_itself_and_no_pair_of_edges_twice() {
    for (seams, message) in [
        (
            r#"[["p.first", "p.first"]]"#,
            "`p.first` would be sewn to itself",
        ),
        (
            r#"[["p.first", "p.second"], ["p.second", "p.first"]]"#,
            "`p.second` is sewn to `p.first` already",
        ),
    ] {
        let (found, at) = one(&format!("seams = {seams}\n"));
        assert_eq!(found, message);
        assert_eq!(at, "\"p.first\"");
    }
}

#[test]
fn formulas_know_tangents_degrees_exponents_and_units() {
    let thickness = |unit: &str, formula: &str| {
        let text =
            format!("[design]\nunit = \"{unit}\"\n[sheet]\nthickness = \"{formula}\"\n{PATCH}");
        let design = read("x.toml", &text).unwrap_or_else(|e| panic!("{formula}: {e:?}"));
        design.metal.unwrap().sheet.thickness()
    };
    assert_eq!(thickness("mm", "10*tan(pi/8)"), 4.142_135_623_730_95);
    assert_eq!(thickness("mm", "4*sin(radians(30))"), 2.0);
    assert_eq!(thickness("mm", "2*1.5e-1 + 1E0"), 1.3);
    assert_eq!(thickness("mm", "2^0.5"), 2.0_f64.sqrt());
    // A length in another unit, wherever it stands; a bare one is in that of the design.
    assert_eq!(thickness("mm", "0.5 in"), 12.7);
    assert_eq!(thickness("m", "3 mm"), 3.0);
    assert_eq!(thickness("in", "(1 + 1) mm"), 2.0);
    let named = format!(
        "[let]\nt = \"0.1 in\"\n[design]\nunit = \"cm\"\n[sheet]\nthickness = \"2*t\"\n{PATCH}"
    );
    let design = read("x.toml", &named).unwrap();
    assert_eq!(design.metal.unwrap().sheet.thickness(), 5.08);
    let (message, place) = one("[sheet]\nthickness = 1\nk-factor = \"0.4 mm\"\n");
    assert_eq!(
        message,
        "a length with a unit where a number without one is wanted"
    );
    assert_eq!(place, "\"0.4 mm\"");
    let degrees = read("x.toml", &format!("[let]\nr = \"30 deg\"\n{PATCH}"));
    assert!(format!("{:?}", degrees.unwrap_err()).contains("radians(30)"));
    let (message, place) = one("[let]\nr = \"1.5e-3*q\"\n");
    assert_eq!(
        (message.as_str(), place.as_str()),
        ("`q` is not declared", "q")
    );
}
