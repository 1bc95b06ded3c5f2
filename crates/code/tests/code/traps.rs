//! Programs in which a reader slips: precedence, lists under two names, scopes, rounding, assertions. What each computes was
//! found by running it at random points, beside the formula.

use crate::support::line;
use std::sync::Arc;
use torse_code::{CodeQuestion, CodeVerdict, Comparison, compare};
use torse_syntax::derivation::{DerivationError, Paper, Source, paper};

/// A claim with this formula on its right side.
fn claim(formula: &str) -> Paper {
    let head = "[paper]\nid = 'trap'\ntitle = ''\nauthors = ''\nvenue = ''\nclaims = ['c.toml']\n\
                [symbols]\nx = {}\ny = {}\na = {}\n";
    let claims = format!(
        "[[claim]]\nid = 'trap/1'\nat = ''\nkind = 'identity'\nprinted = ''\nstates = 'x == {formula}'\n"
    );
    let read = |name: &str| {
        let text = if name == "paper.toml" {
            head
        } else {
            claims.as_str()
        };
        Ok(Arc::new(Source::new(name, text)))
    };
    paper(read).unwrap()
}

fn compared(file: &str, text: &str, formula: &str) -> Result<Comparison, Box<DerivationError>> {
    let paper = claim(formula);
    let question = CodeQuestion::new(file, text, "f");
    compare(50_000_000, "trap", &paper.claims[0], &question)
}

use CodeVerdict::{Different, Equal, EqualWhere, Undecided};

/// What is found of each program; `None` for one that is refused.
fn are(file: &str, rows: &[(&str, &str, Option<CodeVerdict>)]) {
    let mut wrong = vec![];
    for (text, formula, wanted) in rows {
        let found = compared(file, text, formula);
        let verdict = found.as_ref().ok().map(|found| found.verdict);
        if verdict != *wanted {
            let found = match &found {
                Ok(found) => found.to_string(),
                Err(error) => line(error, text),
            };
            wrong.push(format!("{text}{formula}: {found}"));
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

#[test]
fn operators_of_python_bind_as_in_python() {
    are(
        "f.py",
        &[
            ("def f(x):\n    return -x**2\n", "x^2", Some(Different)),
            ("def f(x):\n    return -x**2\n", "-x^2", Some(Equal)),
            ("def f(x):\n    return x**2**3\n", "x^8", Some(Equal)),
            ("def f(x):\n    return x**2**3\n", "x^6", Some(Different)),
            (
                "def f(x, y, a):\n    return x/y/a\n",
                "x/(y*a)",
                Some(EqualWhere),
            ),
            (
                "def f(x, y, a):\n    return x/y*a\n",
                "x/(y*a)",
                Some(Different),
            ),
            ("def f(x):\n    return 1/2*x\n", "x/2", Some(Equal)),
            ("def f(x):\n    return 7//2*x\n", "3*x", None),
            ("def f(x):\n    return -7//2*x\n", "-3*x", None),
            ("def f(x):\n    return (-7) % 3*x\n", "-x", Some(Different)),
            ("def f(x):\n    return (7 % -3)*x\n", "-2*x", Some(Equal)),
            (
                "def f(x, y, a):\n    x -= y - a\n    return x\n",
                "x - y - a",
                Some(Different),
            ),
            (
                "def f(x, y, a):\n    x /= y + a\n    return x\n",
                "x/(y + a)",
                Some(EqualWhere),
            ),
            ("def f(x):\n    return (3 ^ 2)*x\n", "9*x", None),
            ("def f(x):\n    return pow(3, 2, 5)*x\n", "9*x", None),
            ("def f(x):\n    return round(2.5)*x\n", "3*x", None),
            (
                "def f(x):\n    return - - x + +x - -x\n",
                "3*x",
                Some(Equal),
            ),
            (
                "import math\ndef f(x):\n    return math.sqrt(x**2)\n",
                "x",
                Some(Different),
            ),
            ("def f(x):\n    return (x**2)**0.5\n", "abs(x)", Some(Equal)),
            (
                "def f(x, y, a):\n    return max(x, y) + min(x, y)\n",
                "x + y",
                Some(Equal),
            ),
            (
                "def f(x, y, a):\n    return max([x, y]) - max(x, y, y)\n",
                "0*x",
                Some(Equal),
            ),
            ("def f(x):\n    return min(2, 3)*x\n", "2*x", Some(Equal)),
            (
                "import math\ndef f(x):\n    return math.tan(math.atan(x))\n",
                "x",
                Some(Equal),
            ),
            (
                "import numpy as np\ndef f(x):\n    return np.arctan(np.tan(x))\n",
                "x",
                Some(Different),
            ),
            (
                "import math\ndef f(x, y, a):\n    return math.atan2(y, x)\n",
                "atan(y/x)",
                None,
            ),
            ("def f(x):\n    return max(x, -x)\n", "x", Some(Different)),
            (
                "import numpy as np\ndef f(x):\n    return np.maximum(x, -x)\n",
                "abs(x)",
                Some(Equal),
            ),
            ("def f(x):\n    return max([])\n", "x", None),
        ],
    );
}

#[test]
fn names_and_lists_of_python_are_those_of_python() {
    let swap = "def f(x, y):\n    x, y = y, x + y\n    x, y = y, x + y\n    return x\n";
    let copy = "def f(x, y):\n    p = [x, y]\n    q = list(p)\n    q[0] = y\n    return p[0]\n";
    let alias = "def f(x, y):\n    p = [x, y]\n    q = p\n    q[0] = y\n    return p[0]\n";
    let grown = "def f(x, y):\n    p = [x]\n    q = p\n    q += [y]\n    return p[-1]\n";
    let rows = "def f(x):\n    m = [[0]*2]*2\n    m[0][0] = x\n    return m[1][0]\n";
    let called = "def g(p):\n    p[0] = 0\n    return p[1]\ndef f(x, y):\n    q = [x, y]\n    g(q)\n    return q[0]\n";
    let inner = "def f(x):\n    i = 7\n    p = [i for i in range(3)]\n    return i*x\n";
    let late = "def g(x):\n    return x\ndef f(x):\n    return g(x)\ndef g(x):\n    return 2*x\n";
    let constant = "n = 2\ndef f(x):\n    return n*x\nn = 5\n";
    are(
        "f.py",
        &[
            (swap, "x + y", Some(Equal)),
            (copy, "x", Some(Equal)),
            (alias, "x", None),
            (grown, "x", None),
            (rows, "0*x", None),
            (called, "x", None),
            (inner, "7*x", Some(Equal)),
            (inner, "2*x", Some(Different)),
            (late, "2*x", None),
            (constant, "2*x", None),
            (
                "def f(x):\n    for i in range(4):\n        pass\n    return i*x\n",
                "3*x",
                Some(Equal),
            ),
            (
                "def f(x):\n    s = 0\n    for i in range(7, 0, -3):\n        s = s*x + i\n    return s\n",
                "7*x^2 + 4*x + 1",
                Some(Equal),
            ),
            (
                "def f(x):\n    s = x\n    for i in range(3):\n        s += x\n    else:\n        s = 10*x\n    return s\n",
                "4*x",
                None,
            ),
            (
                "from math import sin\ndef sin(x):\n    return x\ndef f(x):\n    return sin(x)\n",
                "x",
                None,
            ),
            (
                "def f(x, y):\n    sum = x\n    sum += y\n    return sum\n",
                "x + y",
                Some(Equal),
            ),
            (
                "import numpy as np\ndef f(x, y):\n    p = np.array([x, 1])*2\n    return p[0] + p[1]\n",
                "2*x + 2",
                Some(Equal),
            ),
            (
                "def f(x):\n    p = [x, 1]*2\n    return p[2] + len(p)\n",
                "x + 4",
                Some(Equal),
            ),
            (
                "def f(x):\n    return x\n    return 2*x\n",
                "2*x",
                Some(Different),
            ),
        ],
    );
}

#[test]
fn rust_is_read_as_rust() {
    let body = |body: &str| format!("fn f(x: f64) -> f64 {{ {body} }}\n");
    let rows = [
        ("-x.powi(2)", "-x^2", Some(Equal)),
        ("-2.0_f64.powi(2)*x", "4*x", Some(Different)),
        ("-2.0_f64.powi(2)*x", "-4*x", Some(Equal)),
        ("((1/2) as f64)*x", "x/2", None),
        ("((-7 % 3) as f64)*x", "-x", Some(Equal)),
        ("((-7 % 3) as f64)*x", "2*x", Some(Different)),
        (
            "let s = 0.0; for _ in 0..3 { let s = s + x; let _ = s; } s + x",
            "x",
            Some(Equal),
        ),
        (
            "let p = [x, 1.0]; let mut q = p; q[0] = 5.0; p[0] + q[0]",
            "x + 5",
            Some(Equal),
        ),
        (
            "let mut p = [x, 1.0]; let q = &mut p; q[0] = 5.0; p[0]",
            "x",
            None,
        ),
        (
            "let r = [0.0, 0.0]; let mut m = [r, r]; m[0][0] = x; m[1][0] + m[0][0]",
            "x",
            Some(Equal),
        ),
        ("2.0_f64.mul_add(x, x)", "3*x", Some(Equal)),
        ("x.powi(4).powf(0.5)", "x^2", Some(Equal)),
        ("x.powi(2).powf(0.5)", "x", Some(Different)),
        (
            "let (a, b) = (x, 2.0); let (a, b) = (b, a); a - b",
            "2 - x",
            Some(Equal),
        ),
        (
            "let mut s = 0.0; for i in (1..4).rev() { s = s*x + i as f64; } s",
            "3*x^2 + 2*x + 1",
            Some(Equal),
        ),
        (
            "let mut s = 0.0; for i in 0..3 { s += x.powi(i); } s",
            "1 + x + x^2 + x^3",
            Some(Different),
        ),
        ("let i = 3; 2.0*x + i as f64/2.0", "2*x + 3/2", Some(Equal)),
        ("x - (1.0 - 2.0)", "x - 3", Some(Different)),
        ("((3 ^ 2) as f64)*x", "9*x", None),
        ("-x.abs()", "-abs(x)", Some(Equal)),
        ("x.max(2.0) + x.min(2.0)", "x + 2", Some(Equal)),
        ("f64::min(x, 1.0)", "x", Some(Different)),
        (
            "let mut s = x; s -= x - 1.0; s *= x + 1.0; s",
            "x + 1",
            Some(Equal),
        ),
    ];
    let texts: Vec<String> = rows.iter().map(|(text, ..)| body(text)).collect();
    let rows = texts.iter().zip(&rows);
    let rows: Vec<_> = rows
        .map(|(text, (_, formula, wanted))| (text.as_str(), *formula, *wanted))
        .collect();
    are("f.rs", &rows);
}

#[test]
fn a_function_has_no_value_where_its_assertion_does_not_hold() {
    let python =
        |condition: &str| format!("def f(x):\n    assert {condition}\n    return (x**2)**0.5\n");
    let rust =
        |assertion: &str| format!("fn f(x: f64) -> f64 {{ {assertion}; x.powi(2).sqrt() }}\n");
    for (condition, wanted) in [
        ("x > 0", Some(Equal)),
        ("0 <= x, 'no'", Some(Equal)),
        ("0 < x < 2 and not x > 1", Some(Equal)),
        ("x > -1", Some(Different)),
        ("x > 0 or x < -2", Some(Different)),
        ("x != 0", Some(Different)),
        ("2 > 1", Some(Different)),
        ("1 > 2", None),
        ("isinstance(x, float)", Some(Undecided)),
    ] {
        are("f.py", &[(&python(condition), "x", wanted)]);
    }
    for (assertion, wanted) in [
        ("assert!(x > 0.0)", Some(Equal)),
        ("debug_assert!(x >= 0.0, \"{}\", x)", Some(Undecided)),
        ("assert!(x.abs() > 0.0 && x > 0.0)", Some(Equal)),
        ("assert_eq!(x, 3.0)", Some(Equal)),
        ("assert_ne!(x, 3.0)", Some(Different)),
        ("assert!(x < 1.0)", Some(Different)),
        ("assert!(x.is_finite())", Some(Undecided)),
    ] {
        are("f.rs", &[(&rust(assertion), "x", wanted)]);
    }
    let found = compared("f.py", &python("x > 0"), "x").unwrap();
    assert_eq!(found.asserted, ["x > 0"]);
    assert!(
        found
            .to_string()
            .contains("where  x > 0, as the code asserts"),
        "{found}"
    );
    // The assertion of a function that is called is one of the caller; what is asserted is what the name has by then.
    let called = "def g(t):\n    t = t - 1\n    assert t > 0\n    return (t**2)**0.5\ndef f(x):\n    return g(x) + 1\n";
    let found = compared("f.py", called, "x").unwrap();
    assert_eq!(
        (found.verdict, found.asserted.concat()),
        (Equal, "x - 1 > 0".to_owned())
    );
}
