//! Lists and arrays that share memory, and lists outside of functions.

use super::are;
use torse_code::CodeVerdict::Equal;

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
fn what_is_copied_costs_as_much_as_it_has_entries() {
    are(
        "f.py",
        &[
            (
                "def f(x):\n    q = [x]\n    for i in range(40):\n        q = q + q\n    return q[0]\n",
                "x",
                None,
            ),
            (
                "def f(x):\n    q = [x]\n    for i in range(24):\n        q = [q, q]\n    return q[0][0]\n",
                "x",
                None,
            ),
            (
                "def f(x):\n    q = []\n    for i in range(800):\n        q.append(x)\n        q[i] = 2*x\n    return q[7] + len(q)\n",
                "2*x + 800",
                Some(Equal),
            ),
            (
                "def f(x):\n    s = 0\n    for i in range(400):\n        s = s + x\n        s -= 1\n    return s\n",
                "400*x - 400",
                Some(Equal),
            ),
        ],
    );
}
