//! Comprehensions without brackets, whose values are made when they are asked for.

use super::are;
use torse_code::CodeVerdict::Equal;

#[test]
fn values_that_are_made_later_are_not_read() {
    are(
        "f.py",
        &[
            (
                "def f(x):\n    s = 0\n    for v in (x*i for i in range(3)):\n        s = s + v\n        x = x + 1\n    return s\n",
                "3*x",
                None,
            ),
            (
                "def f(x, y):\n    q = [x, x, x]\n    s = 0\n    for v in (q[i] for i in range(3)):\n        q[2] = y\n        s = s + v\n    return s\n",
                "3*x",
                None,
            ),
            (
                "def f(x):\n    s = 0\n    for j, v in enumerate(x for i in range(3)):\n        s += j*v\n        x = x + 1\n    return s\n",
                "3*x",
                None,
            ),
            (
                "def f(x):\n    s = 0\n    for w, v in zip([1, 2], (x for i in range(2))):\n        s += w*v\n        x = 0\n    return s\n",
                "3*x",
                None,
            ),
            (
                "def f(x):\n    q = [x]\n    s = 0\n    for v in (c for c in q):\n        if len(q) < 3:\n            q.append(x)\n        s = s + v\n    return s\n",
                "x",
                None,
            ),
            (
                "def f(x):\n    s = 1\n    for v in (s*x for j in range(3)):\n        s += v\n    return s\n",
                "1 + 3*x",
                None,
            ),
            (
                "def f(x):\n    q = [1]\n    for v in q:\n        if len(q) < 4:\n            q.append(v)\n    return len(q)*x\n",
                "2*x",
                None,
            ),
            (
                "def f(x):\n    q = [1]\n    for v in list(q):\n        if len(q) < 4:\n            q.append(v)\n    return len(q)*x\n",
                "2*x",
                Some(Equal),
            ),
            (
                "def sum(q):\n    return 7\ndef f(x):\n    return sum(i for i in range(3))*x\n",
                "7*x",
                None,
            ),
            (
                "def f(x):\n    s = 1\n    for v in [s*x for j in range(3)]:\n        s += v\n    return s\n",
                "1 + 3*x",
                Some(Equal),
            ),
            (
                "def f(x):\n    s = 0\n    for v in list(x*i for i in range(3)):\n        s = s + v\n    return s + max(i for i in range(3))\n",
                "3*x + 2",
                Some(Equal),
            ),
        ],
    );
}
