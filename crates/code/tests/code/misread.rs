//! Programs that look as if they computed a formula, and do not: lists and arrays that share memory, names that are changed elsewhere,
//! integers whose division rounds. Each is refused, or found to be different, and its true neighbours are read.

use crate::support::line;
use std::sync::Arc;
use torse_code::CodeVerdict::{self, Equal};
use torse_code::{CodeQuestion, Comparison, compare};
use torse_syntax::derivation::{DerivationError, Paper, Source, paper};

/// The work of a comparison.
const WORK: u64 = 20_000_000;

/// A claim of which both sides are a formula.
fn claim(formula: &str) -> Paper {
    let head = "[paper]\nid = 'look'\ntitle = ''\nauthors = ''\nvenue = ''\nclaims = ['c.toml']\n\
                [symbols]\nx = {}\ny = {}\na = {}\nb = {}\nt = {}\nn = { integer = '>= 0' }\nm = { integer = '>= 1' }\n\
                p = { vector = 3 }\nq = { vector = 3 }\nP = { family = 3, indices = ['0..n'] }\n\
                Q = { family = 3, indices = ['0..3'] }\nW = { family = 1, indices = ['0..3'] }\n";
    let claims = format!(
        "[[claim]]\nid = 'look/1'\nat = ''\nkind = 'identity'\nprinted = ''\nstates = '{formula} == {formula}'\n"
    );
    let read = |name: &str| {
        let text = match name {
            "paper.toml" => head,
            _ => claims.as_str(),
        };
        Ok(Arc::new(Source::new(name, text)))
    };
    paper(read).unwrap()
}

fn compared(file: &str, text: &str, formula: &str) -> Result<Comparison, Box<DerivationError>> {
    let paper = claim(formula);
    let question = CodeQuestion::new(file, text, "f");
    compare(WORK, "look", &paper.claims[0], &question)
}

/// What is found of each program; `None` for one that is refused, at a place of its file.
fn are(file: &str, rows: &[(&str, &str, Option<CodeVerdict>)]) {
    let mut wrong = vec![];
    for (text, formula, wanted) in rows {
        let found = compared(file, text, formula);
        let verdict = found.as_ref().ok().map(|found| found.verdict);
        let said = match &found {
            Ok(found) => found.to_string(),
            Err(error) => line(error, text),
        };
        if verdict != *wanted {
            wrong.push(format!("{text}{formula}: {said}"));
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

#[test]
fn a_list_outside_of_functions_is_read_only_if_nothing_changes_it() {
    are(
        "f.py",
        &[
            (
                "W = [0]*4\nfor i in range(4):\n    W[i] = i + 1\ndef f(x):\n    return x + W[3]\n",
                "x",
                None,
            ),
            (
                "C = [1, 2]\nC[0] = 5\ndef f(x):\n    return C[0]*x\n",
                "x",
                None,
            ),
            (
                "L = [1]\nL.append(7)\ndef f(x):\n    return L[0]*x + len(L)\n",
                "x + 1",
                None,
            ),
            (
                "C = [1, 2]\nB = C\nB[0] = 5\ndef f(x):\n    return C[0]*x\n",
                "x",
                None,
            ),
            (
                "C = [1, 2]\ndef g(p):\n    p[0] = 5\ng(C)\ndef f(x):\n    return C[0]*x\n",
                "x",
                None,
            ),
            (
                "C = [1, 2]\ndef g():\n    C[0] = 5\ng()\ndef f(x):\n    return C[0]*x\n",
                "x",
                None,
            ),
            (
                "C = [[1], [2]]\nB = C[0]\nB[0] = 5\ndef f(x):\n    return C[0][0]*x\n",
                "x",
                None,
            ),
            (
                "C = 1\nif True:\n    C = 5\ndef f(x):\n    return C*x\n",
                "x",
                None,
            ),
            (
                "C = 1\ndef g():\n    globals()['C'] = 5\ng()\ndef f(x):\n    return C*x\n",
                "x",
                None,
            ),
            (
                "def f(x):\n    y = C*x\n    C = 3\n    return y\nC = 1\n",
                "x",
                None,
            ),
            ("sin = abs\ndef f(x):\n    return sin(x)\n", "sin(x)", None),
            (
                "C = [1, 3, 3, 1]\nM = [[1, 2], [3, 4]]\ndef g(p, k):\n    return p[k]\ndef f(x):\n    return sum(c*x for c in C) + g(C, 1) + M[1][0]\nprint(len(C), C[0])\n",
                "8*x + 6",
                Some(Equal),
            ),
        ],
    );
}

#[test]
fn a_change_of_a_part_of_a_list_is_seen_under_all_its_names() {
    are(
        "f.py",
        &[
            (
                "def f(x, y):\n    a = [[x], [y]]\n    r = a[0]\n    a[0][0] = 3\n    return r[0]\n",
                "x",
                None,
            ),
            (
                "import numpy as np\ndef f(x, y):\n    a = np.array([[x, 1.0], [y, 1.0]])\n    r = a[0]\n    a[0][0] = 3.0\n    return r[0]\n",
                "x",
                None,
            ),
            (
                "import numpy as np\ndef f(x, y):\n    a = np.array([x, y, 0.0])\n    b = a[0:2]\n    a[0] = 7.0\n    return b[0]\n",
                "x",
                None,
            ),
            (
                "import numpy as np\ndef f(x, y):\n    a = np.array([x, y, 0.0])\n    b = a[0:2]\n    b[0] = 7.0\n    return a[0]\n",
                "x",
                None,
            ),
            (
                "def f(x, y):\n    a = [[x], [y]]\n    b = [a[0], a[0]]\n    a[0][0] = 3\n    return b[1][0]\n",
                "x",
                None,
            ),
            (
                "def g(a):\n    return a[0]\ndef f(x, y):\n    a = [[x], [y]]\n    r = g(a)\n    a[0][0] = 3\n    return r[0]\n",
                "x",
                None,
            ),
            (
                "def f(x, y):\n    r = [x]\n    a = []\n    a.append(r)\n    a[0][0] = 5\n    return r[0]\n",
                "x",
                None,
            ),
            (
                "def f(x, y):\n    a = [x, y]\n    s = 0\n    for i, v in enumerate(a):\n        a[1] = 0\n        s = s + v\n    return s\n",
                "x + y",
                None,
            ),
            (
                "def f(x, y):\n    a = [[x], [y]]\n    s = 0\n    for r in a:\n        a[1][0] = 9\n        s = s + r[0]\n    return s\n",
                "x + y",
                None,
            ),
            (
                "import numpy as np\ndef f(x, y):\n    a = np.array([[x, 0.0], [y, 1.0]])\n    a[0], a[1] = a[1], a[0]\n    return a[1][0]\n",
                "x",
                None,
            ),
            (
                "import numpy as np\ndef f(x, y):\n    a = np.array([[x, 0.0], [y, 1.0]])\n    a[0] = 7.0\n    return a[0]\n",
                "7",
                None,
            ),
            (
                "def f(x, y):\n    z = zip([x], [y])\n    s = sum(u for u, v in z)\n    return s + sum(u for u, v in z)\n",
                "2*x",
                None,
            ),
            (
                "def f(x, s=[1, 2]):\n    s[0] = x\n    return s[0]\n",
                "x",
                None,
            ),
            (
                "from functools import cache\n@cache\ndef g(x):\n    return [x]\ndef f(x):\n    p = g(x)\n    p[0] = 5\n    return g(x)[0]\n",
                "x",
                None,
            ),
            (
                "def f(x, y):\n    a = [[x], [y]]\n    a[0][0] = 3\n    r = a[0]\n    b = [[0, 0] for _ in range(2)]\n    b[1][0] = y\n    return r[0] + b[1][0] + b[0][0]\n",
                "y + 3",
                Some(Equal),
            ),
            (
                "import numpy as np\ndef f(x, y):\n    s = np.array([0.0, 0.0])\n    for v in [np.array([x, y]), np.array([y, x])]:\n        s += v\n    return s[0]\n",
                "x + y",
                Some(Equal),
            ),
            (
                "def f(x, y):\n    rows = []\n    for k in range(2):\n        row = [0, 0]\n        row[k] = x\n        rows.append(row)\n    return rows[0][0] + rows[1][1] + rows[1][0]\n",
                "2*x",
                Some(Equal),
            ),
        ],
    );
}

#[test]
fn an_array_that_was_passed_is_not_changed() {
    are(
        "f.py",
        &[
            (
                "def f(p, q):\n    a = p\n    a += q\n    return p\n",
                "p",
                None,
            ),
            (
                "def g(v, w):\n    v += w\n    return v\ndef f(p, q):\n    s = g(p, q)\n    return p\n",
                "p",
                None,
            ),
            (
                "def f(Q):\n    b = Q[0]\n    b += Q[1]\n    return Q[0]\n",
                "Q[0]",
                None,
            ),
            (
                "def f(p, q, t):\n    d = q\n    d -= p\n    return q + (t - 1)*d\n",
                "p + t*(q - p)",
                None,
            ),
            (
                "def f(p, q):\n    a = p + q\n    b = a\n    b += q\n    return a\n",
                "p + q",
                None,
            ),
            ("def f(p, q):\n    return p*q\n", "p", None),
            (
                "import numpy as np\ndef f(p):\n    return abs(p)\n",
                "p",
                None,
            ),
            (
                "def f(p, q, t):\n    d = q - p\n    d *= t\n    s = 0\n    s += p\n    s += d\n    return s\n",
                "p + t*(q - p)",
                Some(Equal),
            ),
            (
                "def f(x, y):\n    a = x\n    a += y\n    return x + a\n",
                "2*x + y",
                Some(Equal),
            ),
        ],
    );
}

#[test]
fn what_numpy_does_not_copy_is_no_copy() {
    are(
        "f.py",
        &[
            (
                "import numpy as np\ndef f(x, y):\n    a = np.array([x, y, 0.0])\n    b = np.asarray(a)\n    b[0] = 0.0\n    return a\n",
                "[x, y, 0]",
                None,
            ),
            (
                "import numpy as np\ndef f(x, y):\n    a = np.array([x, y, 0.0])\n    b = a.ravel()\n    b[0] = 0.0\n    return a\n",
                "[x, y, 0]",
                None,
            ),
            (
                "import numpy as np\ndef f(x, y):\n    a = np.array([x, y, 0.0])\n    return list(a) + list(a)\n",
                "2*[x, y, 0]",
                None,
            ),
            (
                "import numpy as np\ndef f(x, y):\n    a = np.array([[x, y, 0.0], [y, x, 0.0]])\n    b = list(a)\n    b[0] += np.array([1.0, 1.0, 1.0])\n    return a[0]\n",
                "[x, y, 0]",
                None,
            ),
            (
                "import numpy as np\ndef f(x, y):\n    a = np.array([[x, y, 0.0], [y, x, 0.0]])\n    b = list(a)\n    b[0][0] = 7.0\n    return a[0]\n",
                "[x, y, 0]",
                None,
            ),
            (
                "def f(p, q):\n    return list(p) + list(q)\n",
                "p + q",
                None,
            ),
            (
                "import numpy as np\ndef f(x, y):\n    a = np.array([x, y, 0.0])\n    b = np.array(a)\n    c = a.copy()\n    b[0] = 7.0\n    c[0] = 7.0\n    return a + np.asarray([x, y, 0])\n",
                "2*[x, y, 0]",
                Some(Equal),
            ),
        ],
    );
}

#[test]
fn numpy_sums_over_all_entries_of_an_array() {
    are(
        "f.py",
        &[
            (
                "import numpy as np\ndef f(x, y, a, b):\n    M = np.array([[x, y], [a, b]])\n    return np.sum(M)\n",
                "[x + a, y + b]",
                None,
            ),
            (
                "import numpy as np\ndef f(x, y, a, b):\n    M = np.array([[x, y], [a, b]])\n    return M.sum()\n",
                "[x + a, y + b]",
                None,
            ),
            (
                "import numpy as np\ndef f(P, n):\n    return np.sum(P[i] for i in range(n))\n",
                "sum(i, 0, n - 1, P[i])",
                None,
            ),
            (
                "import numpy as np\ndef f(x, y):\n    return np.maximum(x, y, 3)\n",
                "max(x, max(y, 3))",
                None,
            ),
            (
                "import numpy as np\ndef f(x, y, a, b):\n    return np.dot(np.array([[x, y], [a, b]]), np.array([a, b]))\n",
                "[x*a + y*b, a*a + b*b]",
                None,
            ),
            ("def f(x, y):\n    return sum([[x], [y]])\n", "[x, y]", None),
            (
                "import numpy as np\ndef f(x, y):\n    a = np.array([[x, y], [y, x]])\n    return a[[0, 1]][0]\n",
                "y",
                None,
            ),
            (
                "import numpy as np\ndef f(x, y, a, b):\n    M = np.array([[x, y], [a, b]])\n    return np.sum(M) + M.sum() + sum(M)[0] + max(M[0]) - max(x, y)\n",
                "3*x + 2*y + 3*a + 2*b",
                Some(Equal),
            ),
        ],
    );
}

#[test]
fn one_index_of_a_matrix_of_sympy_counts_all_entries() {
    are(
        "f.py",
        &[
            (
                "import sympy as sp\ndef f(x, y, a, b):\n    M = sp.Matrix([[x, y], [a, b]])\n    return M[1]\n",
                "[a, b]",
                None,
            ),
            (
                "import sympy as sp\ndef f(x, y, a, b):\n    M = sp.Matrix([[x, y], [a, b]])\n    return len(M)*x\n",
                "2*x",
                None,
            ),
            (
                "import sympy as sp\ndef f(x, y, a, b):\n    M = sp.Matrix([[x, y], [a, b]])\n    return sum(M)\n",
                "[x + a, y + b]",
                None,
            ),
            (
                "import sympy as sp\ndef f(x, y):\n    M = sp.Matrix([[x, y]])\n    return M[0]\n",
                "[x, y]",
                None,
            ),
            (
                "import sympy as sp\ndef f(x, y, a, b):\n    M = sp.Matrix([[x, y], [a, b]])\n    N = sp.Matrix([x, y])\n    return M[1, 0] + 2*N[1] + len(N)\n",
                "a + 2*y + 2",
                Some(Equal),
            ),
        ],
    );
}

#[test]
fn a_sum_of_sympy_from_a_greater_end_is_not_read() {
    are(
        "f.py",
        &[
            (
                "import sympy as sp\ndef f():\n    k = sp.symbols('k')\n    return sp.summation(k**2, (k, 3, 1))\n",
                "0",
                None,
            ),
            (
                "import sympy as sp\ndef f(n):\n    k = sp.symbols('k')\n    return sp.Sum(k, (k, 3, n)).doit()\n",
                "sum(k, 3, n, k)",
                None,
            ),
            (
                "import sympy as sp\ndef f(x, y):\n    return sp.diff(x**2*y**3, x, y)\n",
                "6*x*y^2",
                None,
            ),
            (
                "import sympy as sp\ndef f(n):\n    k = sp.symbols('k')\n    return sp.Sum(k, (k, 1, n)).doit()\n",
                "n*(n + 1)/2",
                Some(Equal),
            ),
        ],
    );
}

#[test]
fn names_are_those_that_the_file_imports() {
    are(
        "f.py",
        &[
            (
                "def cache(f):\n    return lambda x: 2*f(x)\n@cache\ndef f(x):\n    return x\n",
                "x",
                None,
            ),
            (
                "from mine import cache\n@cache\ndef f(x):\n    return x\n",
                "x",
                None,
            ),
            (
                "import numpy as np\n@np.vectorize\ndef f(x):\n    return x\n",
                "x",
                None,
            ),
            (
                "from math import *\nfrom mine import *\ndef f(x):\n    return sin(x)\n",
                "sin(x)",
                None,
            ),
            (
                "import numpy as np\nfrom mine import *\ndef f(x):\n    return np.sin(x)\n",
                "sin(x)",
                None,
            ),
            (
                "import numpy as np\ndef f(x, np=3):\n    return np.sin(x)\n",
                "sin(x)",
                None,
            ),
            (
                "from math import sin\ntry:\n    from fast import sin\nexcept ImportError:\n    pass\ndef f(x):\n    return sin(x)\n",
                "sin(x)",
                None,
            ),
            ("def f(x):\n    return x\nf = print\n", "x", None),
            (
                "from sympy import *\nfrom numpy import *\ndef f(x):\n    return diff(x**2, x)\n",
                "2*x",
                None,
            ),
            (
                "from mine import *\nfrom math import sin\nfrom functools import lru_cache\n@lru_cache(maxsize=None)\ndef g(x):\n    return sin(x)\ndef f(x):\n    return g(x)\n",
                "sin(x)",
                Some(Equal),
            ),
            (
                "import numba\nfrom math import *\n@numba.njit\ndef f(x):\n    return sin(x) + max(x, 1) - max(1, x)\n",
                "sin(x)",
                Some(Equal),
            ),
        ],
    );
}

#[test]
fn an_array_of_zeros_is_one_of_floating_point_numbers() {
    are(
        "f.py",
        &[
            (
                "import numpy as np\ndef f(x):\n    v = np.array([1, 2])\n    v[0] = x/2\n    return v[0]\n",
                "x/2",
                None,
            ),
            (
                "import numpy as np\ndef f(x):\n    v = np.array([1, 2])\n    v *= 0.5\n    return x*v[0]\n",
                "x/2",
                None,
            ),
            (
                "import numpy as np\ndef f(x):\n    v = np.zeros(2)\n    v[0] = x/2\n    return v[0] + v[1]\n",
                "x/2",
                Some(Equal),
            ),
        ],
    );
}

#[test]
fn the_types_of_integers_of_rust_are_not_lost() {
    are(
        "f.rs",
        &[
            (
                "fn f(n: i64, m: i64) -> i64 { n.max(m) / 2 }\n",
                "max(n, m)/2",
                None,
            ),
            ("fn f(n: i64) -> i64 { n.abs() / 2 }\n", "abs(n)/2", None),
            ("fn f(n: i64) -> i64 { n.pow(2) / 2 }\n", "n^2/2", None),
            (
                "type Int = Whole;\ntype Whole = i64;\nfn f(a: Int, b: Int) -> Int { a / b }\n",
                "a/b",
                None,
            ),
            (
                "fn f(W: [i64; 2]) -> i64 { W[0] / W[1] }\n",
                "W[0]/W[1]",
                None,
            ),
            (
                "fn f(W: &[usize]) -> usize { W[0] / W[1] }\n",
                "W[0]/W[1]",
                None,
            ),
            (
                "fn f(n: usize) -> usize { (0..n).map(|i| i).sum::<usize>() / 2 }\n",
                "n*(n - 1)/4",
                None,
            ),
            ("fn f<T>(a: T, b: T) -> T { a / b }\n", "a/b", None),
            (
                "fn f(n: i32) -> f64 { (g(n) / 2) as f64 }\nfn g(n: i32) -> i32 { n.max(n) }\n",
                "n/2",
                None,
            ),
            (
                "fn f(n: i32) -> f64 { let n: i64 = n.into(); (n / 2) as f64 }\n",
                "n/2",
                None,
            ),
            (
                "fn f(n: i64, m: i64) -> f64 { n.max(m) as f64 / 2.0 }\n",
                "max(n, m)/2",
                Some(Equal),
            ),
            (
                "type Real = f64;\nfn f(a: Real, W: &[Real; 4]) -> Real { (a + W[0]) / 2.0 * (4 / 2) as f64 }\n",
                "a + W[0]",
                Some(Equal),
            ),
        ],
    );
}

#[test]
fn what_an_attribute_of_rust_may_leave_out_is_not_read() {
    are(
        "f.rs",
        &[
            (
                "fn f(x: f64) -> f64 { let y = x; #[cfg(any())] let y = 3.0; y + 0.0 }\n",
                "x",
                None,
            ),
            (
                "#[cfg(not(any()))]\nfn f(x: f64) -> f64 { x }\n#[cfg(any())]\nfn f(x: f64) -> f64 { 2.0 * x }\n",
                "x",
                None,
            ),
            (
                "fn f(x: f64) -> f64 { x }\nfn f(x: f64) -> f64 { 2.0 * x }\n",
                "2*x",
                None,
            ),
            (
                "#[cfg(any())]\nconst C: f64 = 2.0;\nfn f(x: f64) -> f64 { C * x }\n",
                "2*x",
                None,
            ),
            (
                "#[inline]\n#[must_use]\nfn f(x: f64) -> f64 { #[allow(unused)] let y = 3.0; x }\n",
                "x",
                Some(Equal),
            ),
        ],
    );
}

#[test]
fn a_number_is_converted_only_where_nothing_is_cut_off() {
    are(
        "f.rs",
        &[
            (
                "fn f(x: f64) -> f64 { (-1.0_f64) as usize as f64 + x }\n",
                "x - 1",
                None,
            ),
            (
                "fn f(x: f64) -> f64 { 300 as u8 as f64 + x }\n",
                "x + 300",
                None,
            ),
            (
                "fn f(x: f64) -> f64 { (2.5_f64 as i32) as f64 + x }\n",
                "x + 5/2",
                None,
            ),
            ("fn f(x: f64) -> f64 { x as i64 as f64 }\n", "x", None),
            (
                "type Byte = u8;\nfn f(x: f64) -> f64 { 300 as Byte as f64 + x }\n",
                "x + 300",
                None,
            ),
            (
                "fn f(x: f64, n: i64) -> f64 { 255 as u8 as f64 + x + (n as i32) as f64 }\n",
                "x + n + 255",
                Some(Equal),
            ),
        ],
    );
}

#[test]
fn what_is_wrong_with_the_formula_of_code_is_shown_in_the_code() {
    // The last index is that of no member: in Python it counts from the end.
    let text = "def f(W, n):\n    return sum(W[-i] for i in range(1, n + 1))\n";
    let error = compared("f.py", text, "x").unwrap_err();
    let said = line(&error, text);
    assert!(said.starts_with("1:5 `f`"), "{said}");
    assert!(!said.contains('°'), "{said}");
}

#[test]
fn the_search_for_changes_of_a_sum_ends() {
    let text = "def f(n, x):\n    return sum(i for i in range(n)) + x\n";
    let found = compared("f.py", text, "x").unwrap();
    assert_eq!(found.verdict, CodeVerdict::Different);
}
