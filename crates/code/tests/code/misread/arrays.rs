//! Arrays of NumPy, and symbols and matrices of SymPy: they do not behave as lists of numbers.

use super::are;
use torse_code::CodeVerdict::Equal;

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
