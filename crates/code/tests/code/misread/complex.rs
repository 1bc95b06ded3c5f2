//! Roots and logarithms that are complex numbers where formulas have no value.

use super::{WORK, are, claim};
use crate::support::line;
use torse_code::CodeVerdict::Equal;
use torse_code::{CodeQuestion, compare};

#[test]
fn what_may_be_complex_is_not_equal_to_what_has_no_value_there() {
    are(
        "f.py",
        &[
            ("def f(x):\n    return (x**0.5)**2\n", "abs(x)", None),
            ("def f(x):\n    return pow(x, 0.5)**4\n", "x*abs(x)", None),
            ("def f(x):\n    return x**-0.5*x\n", "x^2", None),
            (
                "from sympy import sqrt\ndef f(x):\n    return sqrt(x)**2\n",
                "abs(x)",
                None,
            ),
            (
                "from sympy import sqrt\ndef f(x, y):\n    return sqrt(x)*sqrt(y)*sqrt(x)*sqrt(y)\n",
                "abs(x)*abs(y)",
                None,
            ),
            (
                "from sympy import sin, asin\ndef f(x):\n    return sin(asin(x))\n",
                "max(-1, min(1, x))",
                None,
            ),
            (
                "from sympy import exp, log\ndef f(x):\n    return exp(log(x))\n",
                "abs(x)",
                None,
            ),
            (
                "from sympy import log, symbols, diff\ndef f(x):\n    t = symbols('u')\n    return diff(log(t), t).subs(t, x)*x**2\n",
                "abs(x)",
                None,
            ),
            (
                "def f(x):\n    return (x**2)**0.5 + (1 + x**2)**0.5\n",
                "abs(x) + sqrt(1 + x^2)",
                Some(Equal),
            ),
            (
                "import math\nimport numpy as np\ndef f(x):\n    return math.sqrt(x)**2 + np.log(x)\n",
                "x + log(x)",
                Some(Equal),
            ),
            (
                "from sympy import sqrt, log, exp\ndef f(x):\n    return sqrt(x**2) + log(exp(x))\n",
                "abs(x) + x",
                Some(Equal),
            ),
            (
                "from sympy import exp, log\ndef f(x):\n    assert x >= 0\n    return exp(log(x))\n",
                "x",
                None,
            ),
            (
                "from sympy import exp, log\ndef f(x):\n    assert x > 0\n    return exp(log(x))\n",
                "x",
                Some(Equal),
            ),
        ],
    );
}

#[test]
fn what_makes_a_root_real_is_said_by_a_hypothesis() {
    let text = "def f(x):\n    return (x**0.5)**2\n";
    let paper = claim("x");
    let mut question = CodeQuestion::new("f.py", text, "f");
    let found = compare(WORK, "look", &paper.claims[0], &question);
    let said = line(&found.unwrap_err(), text);
    assert!(said.contains("--where 'x >= 0'"), "{said}");
    question.conditions.push("x >= 0".to_owned());
    let found = compare(WORK, "look", &paper.claims[0], &question).unwrap();
    assert_eq!(found.verdict, Equal, "{found}");
}
