//! Integers of Python: indices that may be negative, families that begin at one, arrays that cut numbers off.

use super::are;
use torse_code::CodeVerdict::Equal;

#[test]
fn an_index_that_may_be_negative_is_not_read() {
    are(
        "f.py",
        &[
            (
                "def f(W, k):\n    return W[k]\n",
                "W[0]*(1 - k) + W[1]*k",
                None,
            ),
            ("def f(P, n):\n    return P[n - 1]\n", "P[n - 1]", None),
            (
                "def f(P, n):\n    return sum(P[i - 1] for i in range(n + 1))\n",
                "sum(i, 0, n, P[i])",
                None,
            ),
            (
                "def f(P, n):\n    return sum(P[n - i] for i in range(n + 1))\n",
                "sum(i, 0, n, P[n - i])",
                Some(Equal),
            ),
            (
                "def f(p):\n    return p[-1] + p[2]\n",
                "2*p[3]",
                Some(Equal),
            ),
        ],
    );
}

#[test]
fn a_family_that_begins_at_one_is_no_list() {
    are(
        "f.py",
        &[
            (
                "def f(V):\n    return V[1] + sum(V[1:])\n",
                "V[1] + V[2] + V[3]",
                None,
            ),
            (
                "def f(V):\n    return V[1] + sum(V[2:])\n",
                "V[1] + V[2] + V[3]",
                None,
            ),
            ("def f(V):\n    return len(V)\n", "3", None),
            (
                "def f(V):\n    s = 0\n    for v in V:\n        s += v\n    return s\n",
                "V[1] + V[2] + V[3]",
                None,
            ),
            (
                "def f(V):\n    return V[1] + V[2] + V[3]\n",
                "V[1] + V[2] + V[3]",
                Some(Equal),
            ),
        ],
    );
}

#[test]
fn functions_of_scipy_are_zero_for_negative_integers() {
    are(
        "f.py",
        &[
            (
                "from scipy.special import comb\ndef f(k):\n    return comb(k, 2)\n",
                "k*(k - 1)/2",
                None,
            ),
            (
                "from scipy.special import factorial\ndef f(k):\n    return factorial(k)\n",
                "factorial(k)",
                None,
            ),
            (
                "from scipy.special import comb\ndef f(n):\n    return comb(n, 2)\n",
                "n*(n - 1)/2",
                Some(Equal),
            ),
        ],
    );
}

#[test]
fn an_array_of_computed_integers_is_one_of_integers() {
    are(
        "f.py",
        &[
            (
                "import numpy as np\ndef f(x):\n    u = np.array([1, 2])\n    c = np.array([u.dot(u), 1])\n    c[0] = x\n    return c[0]\n",
                "x",
                None,
            ),
            (
                "import numpy as np\ndef f(x):\n    c = np.array([min(2, 2.0), 1])\n    c[0] = x\n    return c[0]\n",
                "x",
                None,
            ),
            (
                "import numpy as np\ndef f(n, x):\n    c = np.array([max(n, 2.0), 1])\n    c[1] = x\n    return c[1]\n",
                "x",
                None,
            ),
            (
                "import numpy as np\ndef f(x):\n    c = np.array([[1, 0], [0.5, 1]])\n    c[0, 0] = x\n    return c[0, 0]\n",
                "x",
                Some(Equal),
            ),
            (
                "import numpy as np\ndef f(x):\n    c = np.array([2, 3])\n    return c[0]**-1*x\n",
                "x/2",
                None,
            ),
            (
                "import numpy as np\ndef f(x):\n    c = np.array([2, 3.0])\n    return c[0]**-1*x\n",
                "x/2",
                Some(Equal),
            ),
        ],
    );
}

#[test]
fn rounding_decides_no_branch() {
    are(
        "f.py",
        &[
            (
                "def f(x):\n    return x if 0.1 + 0.2 == 0.3 else 2*x\n",
                "x",
                None,
            ),
            (
                "def f(x):\n    return x if 0.1*3 <= 0.3 else 2*x\n",
                "x",
                None,
            ),
            (
                "def f(x):\n    return x if 0.5 + 0.25 == 0.75 and 0.1 == 0.1 and 0.1 + 0.2 < 0.4 else 2*x\n",
                "x",
                Some(Equal),
            ),
        ],
    );
}
