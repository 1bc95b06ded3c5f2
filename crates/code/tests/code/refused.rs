//! What is not read, with its place and what would be right.

use crate::support::{line, program, row};
use torse_code::{CodeVerdict, MAX_CODE_BYTES};

/// Compares a function `f` with the curve of degree three.
fn error(file: &str, text: &str) -> String {
    let row = row("f", "bezier/curve.casteljau").fixing(&["m == 3"]);
    match row.compare(file, text) {
        Ok(found) => panic!("{text}\nis read: {found}"),
        Err(error) => line(&error, text),
    }
}

#[test]
fn python_that_is_not_read_is_refused_with_its_place() {
    let bodies = [
        "while x > 0:\n        x = x - 1\n    return x",
        "if x > 0:\n        return P[0]\n    return P[1]",
        "return x^2",
        "return P[0] if x else 1",
        "return P[4]",
        "return P[::2]",
        "return P",
        "return x//2",
        "return 7//2*x",
        "return x**0.3",
        "return x[0]",
        "return scipy.special.binom(3, 1)",
        "return math.gamma(x)",
        "return math.floor(x)",
        "return unknown(x)",
        "return y",
        "return math.sin(x, 1)",
        "return (lambda t: t)(x)",
        "return 'x'",
        "return 1/0",
        "return [1, 2] + x",
        "q = P\n    q[0] = x\n    return q[0]",
        "q = [[0]*2]*2\n    q[0][0] = x\n    return q[1][0]",
        "q = list(P)\n    r = q\n    r[0] = x\n    return q[0]",
        "q = [x]\n    r = [q]\n    r[0][0] = 1\n    return q[0]",
        "print(x)\n    return x",
        "x = yield 1\n    return x",
        "for i in range(x):\n        pass\n    return x",
        "return f(x, P)",
        "pass",
        "a, b = 1, 2, 3\n    return a",
        "return sum(1 for i in range(10**9))",
        "global x\n    return x",
        "return x if x == x else (",
    ];
    let mut messages = String::new();
    for body in bodies {
        let text = format!("import math\nimport scipy\n\ndef f(x, P):\n    {body}\n");
        messages.push_str(&format!("{body}\n  {}\n\n", error("f.py", &text)));
    }
    insta::assert_snapshot!(messages);
}

#[test]
fn rust_that_is_not_read_is_refused_with_its_place() {
    let bodies = [
        "let mut x = x; while x > 0.0 { x -= 1.0; } x",
        "if x > 0.0 { 1.0 } else { 2.0 }",
        "x.floor()",
        "(1 / 2) as f64 * x",
        "x as usize as f64",
        "let v = vec![0.0; 3]; v[0]",
        "P[4]",
        "match 1 { 1 => x, _ => 0.0 }",
        "unknown(x)",
        "self.x",
        "let q = &mut [1.0]; q[0]",
        "x ^ 2",
        "println!(\"{x}\"); x",
        "let c = |t: f64| t; c(x)",
        "loop {}",
        "x.powf(0.3)",
        "return",
        "x +",
    ];
    let mut messages = String::new();
    for body in bodies {
        let text = format!("fn f(x: f64, P: &[f64]) -> f64 {{\n    {body}\n}}\n");
        messages.push_str(&format!("{body}\n  {}\n\n", error("f.rs", &text)));
    }
    insta::assert_snapshot!(messages);
}

#[test]
fn what_a_program_does_not_say_is_asked_for() {
    let simple = |text: &str| error("f.py", text);
    let mut messages = String::new();
    for text in [
        "def g(x):\n    return x\n",
        "def f(t):\n    return t\n",
        "def f(x, *rest):\n    return x\n",
        "from somewhere import anything\n@anything\ndef f(x):\n    return x\n",
        "N = 3\nN = 4\ndef f(x):\n    return N*x\n",
        "def sin(x):\n    return x\ndef f(x):\n    return cos(x)\n",
        "a = a + 1\ndef f(x):\n    return a\n",
    ] {
        messages.push_str(&format!("{text}  {}\n\n", simple(text)));
    }
    messages.push_str(&error("f.cpp", "double f(double x) { return x; }"));
    insta::assert_snapshot!(messages);
}

#[test]
fn hostile_programs_end_with_a_message() {
    let long = format!("def f(x):\n    return x{}\n", " ".repeat(MAX_CODE_BYTES));
    assert!(error("f.py", &long).contains("bytes"));
    let brackets = format!(
        "def f(x):\n    return {}x{}\n",
        "(".repeat(5_000),
        ")".repeat(5_000)
    );
    assert!(error("f.py", &brackets).contains("nested"));
    let signs = format!("fn f(x: f64) -> f64 {{ {}x }}", "-".repeat(5_000));
    assert!(error("f.rs", &signs).contains("nested"));
    let doubling = format!(
        "def f(x):\n{}    return x\n",
        "    x = x*x + x\n".repeat(40)
    );
    assert!(error("f.py", &doubling).contains("grows beyond"));
    let loops = format!(
        "def f(x):\n    s = 0\n{}        s = s + 1\n    return s*x\n",
        (0..8)
            .map(|n| format!("{}for i{n} in range(99):\n", " ".repeat(4 + n)))
            .collect::<String>()
    );
    let deepest = loops.replace("        s = s + 1", "             s = s + 1");
    assert!(error("f.py", &deepest).contains("steps"));
}

#[test]
fn names_of_a_function_hide_what_it_imports() {
    // `sum` and `pi` are variables here, and `sin` is a function of the file.
    let text = "from math import *\n\ndef sin(t):\n    return 2*t\n\ndef f(x, P):\n    sum = 0\n    pi = 3\n    for i in range(4):\n        \
                sum += [1, pi, 3, 1][i]*x**i*(1 - x)**(3 - i)*P[i]\n    return sum*sin(1)/2\n";
    let row = row("f", "bezier/curve.casteljau").fixing(&["m == 3"]);
    let found = row.compare("f.py", text).unwrap();
    assert_eq!(found.verdict, CodeVerdict::Equal, "{found}");
    let wrong = text.replace("pi = 3", "pi = 4");
    let found = row.compare("f.py", &wrong).unwrap();
    assert_eq!(found.verdict, CodeVerdict::Different, "{found}");
}

#[test]
fn blocks_of_rust_hide_names_to_their_ends() {
    let text = "fn f(x: f64, p: &[f64]) -> f64 {\n    let t = x;\n    for t in 0..3 { let x = t; }\n    if true { let t = 5.0; }\n    \
                let s = 1.0 - t;\n    s.powi(3) * p[0] + 3.0 * t * s * s * p[1] + 3.0 * t * t * s * p[2] + t.powi(3) * p[3]\n}\n";
    let row = row("f", "bezier/curve.casteljau")
        .fixing(&["m == 3"])
        .mapping(&[("p", "P")]);
    let found = row.compare("f.rs", text).unwrap();
    assert_eq!(found.verdict, CodeVerdict::Equal, "{found}");
}

#[test]
fn both_programs_of_the_tests_are_read_whole() {
    for (file, name) in [("curves.py", "curve"), ("curves.rs", "curve")] {
        let text = program(file);
        let missing = row("missing", "bezier/curve.casteljau")
            .compare(file, &text)
            .unwrap_err();
        assert!(line(&missing, &text).contains(name));
    }
}

#[test]
fn the_lists_of_python_are_read_as_python_has_them() {
    // De Casteljau by parts of lists; a copy is a list of its own.
    let text = "def f(x, P):\n    q = list(P)\n    while_is_no_name = q.copy()\n    while_is_no_name[0] = 7\n    for k in range(3):\n        \
                q = [(1 - x)*a + x*b for a, b in zip(q[:-1], q[1:])]\n    r = []\n    r.append(q[-1])\n    return r[0]\n";
    let row = row("f", "bezier/curve.casteljau").fixing(&["m == 3"]);
    let found = row.compare("f.py", text).unwrap();
    assert_eq!(found.verdict, CodeVerdict::Equal, "{found}");
}
