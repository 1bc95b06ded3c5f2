//! Symbols of SymPy, which are none of the parameters, and parameters that are one symbol.

use super::are;
use torse_code::CodeVerdict::{Different, Equal};

#[test]
fn two_parameters_are_not_one_symbol() {
    are(
        "f.py",
        &[
            ("def f(x, x_):\n    return x - x_\n", "0", None),
            ("def f(x, y, _x):\n    return x - _x + y\n", "y", None),
            ("def f(x_, y):\n    return x_ - y\n", "x - y", Some(Equal)),
        ],
    );
}

#[test]
fn a_symbol_is_no_parameter_of_a_like_name() {
    are(
        "f.py",
        &[
            (
                "from sympy import symbols, integrate\ndef f(x):\n    x_ = symbols('x_')\n    return integrate(x_**2*x, (x_, 0, 1))\n",
                "1/4",
                Some(Different),
            ),
            (
                "from sympy import symbols, diff\ndef f(x):\n    x_ = symbols('x_')\n    return diff(x*x_**2, x_).subs(x_, 1)\n",
                "3",
                Some(Different),
            ),
            (
                "from sympy import symbols\nu = symbols('x')\ndef f(x):\n    return (u*x).subs(u, 2)\n",
                "4",
                None,
            ),
            (
                "from sympy import symbols, integrate\ndef g(v):\n    x = symbols('x')\n    return integrate(x*v, (x, 0, 1))\ndef f(x):\n    return g(x)\n",
                "1/3",
                None,
            ),
            (
                "from sympy import symbols, integrate\ndef f(x):\n    x_ = symbols('x_')\n    return integrate(x_**2*x, (x_, 0, 1))\n",
                "x/3",
                Some(Equal),
            ),
            (
                "from sympy import symbols, integrate\ndef f(t):\n    x = symbols('x')\n    return integrate(x*t, (x, 0, 1))\n",
                "t/2",
                Some(Equal),
            ),
            (
                "from sympy import symbols, Sum\ndef f(x, n):\n    s = symbols('j')\n    return x*sum(Sum(s*j, (s, 0, 3)).doit() for j in range(n + 1))\n",
                "3*x*n*(n + 1)",
                Some(Equal),
            ),
        ],
    );
}

#[test]
fn what_is_assumed_of_a_symbol_is_not_read() {
    are(
        "f.py",
        &[
            (
                "from sympy import symbols, sqrt\ndef f(x):\n    t = symbols('t', positive=True)\n    return sqrt(t**2).subs(t, x)\n",
                "abs(x)",
                None,
            ),
            (
                "from sympy import symbols, sin, pi\ndef f(x):\n    k = symbols('k', integer=True)\n    return sin(pi*k).subs(k, x) + x\n",
                "sin(pi*x) + x",
                None,
            ),
            (
                "from sympy import symbols\ndef f(x):\n    u = symbols(f'u{1}')\n    return (u*x).subs(u, 2)\n",
                "2*x",
                None,
            ),
            (
                "from sympy import symbols\ndef f(x):\n    u = symbols('u v,')\n    return (u[0]*x).subs(u[0], 2)\n",
                "2*x",
                None,
            ),
            (
                "from sympy import Symbol\ndef f(x):\n    u = Symbol('u v')\n    return (u[0]*x).subs(u[0], 2)\n",
                "2*x",
                None,
            ),
            (
                "from sympy import nsimplify\ndef f(x):\n    return nsimplify(0.33, [], 0.01)*x\n",
                "0.33*x",
                None,
            ),
            (
                "from sympy import symbols\ndef f(x):\n    u = symbols('u', real=True)\n    return (u**2).subs(u, x)\n",
                "x^2",
                Some(Equal),
            ),
        ],
    );
}

#[test]
fn symbols_that_the_claim_does_not_have_are_bound_in_the_code() {
    are(
        "f.py",
        &[
            (
                "from sympy import symbols, diff\nu = symbols('u')\ndef f(x):\n    return diff(u**3, u)\n",
                "3*x^2",
                None,
            ),
            (
                "from sympy import symbols, integrate\nu = symbols('u')\ndef f(x):\n    return integrate(u, (u, 0, u))\n",
                "x^2/2",
                None,
            ),
            (
                "from sympy import symbols, diff\nu = symbols('u')\ndef f(x):\n    return diff(u**3, u).subs(u, x)\n",
                "3*x^2",
                Some(Equal),
            ),
            (
                "from sympy import symbols, integrate\nu = symbols('u')\ndef f(x):\n    return integrate(u**2, (u, 0, x))\n",
                "x^3/3",
                Some(Equal),
            ),
            (
                "import sympy as sp\ns = sp.Symbol('s')\ndef f(x):\n    return sp.integrate(sp.sin(s), (s, 0, x))\n",
                "1 - cos(x)",
                Some(Equal),
            ),
        ],
    );
}
