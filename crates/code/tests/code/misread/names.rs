//! Names of Python: one has a meaning only if one thing in the file gives it one.

use super::are;
use torse_code::CodeVerdict::Equal;

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
fn a_name_that_gets_a_meaning_twice_has_none() {
    are(
        "f.py",
        &[
            (
                "from math import pi\nTWO = 2*pi\npi = 3\ndef f(x):\n    return TWO*x\n",
                "6*x",
                None,
            ),
            (
                "from math import pi as c\nd = c*2\nfrom math import e as c\ndef f(x):\n    return d*x\n",
                "2*exp(1)*x",
                None,
            ),
            (
                "def g(x):\n    return x\nC = g(2)\ndef g(x):\n    return 3*x\ndef f(x):\n    return C*x\n",
                "6*x",
                None,
            ),
            (
                "def g(x):\n    return x\ndef f(x, c=g(2)):\n    return c*x\ndef g(x):\n    return 3*x\n",
                "6*x",
                None,
            ),
            (
                "from math import sqrt\nR = sqrt(4)\ndef sqrt(x):\n    return x\ndef f(x):\n    return R*x\n",
                "4*x",
                None,
            ),
            (
                "C = max(1, 2)\ndef max(a, b):\n    return a\ndef f(x):\n    return C*x\n",
                "x",
                None,
            ),
            (
                "def g(a):\n    return max(a, 2)\nC = g(1)\ndef max(a, b):\n    return a\ndef f(x):\n    return C*x\n",
                "x",
                None,
            ),
            (
                "from mine import *\ndef g(x):\n    return sqrt(x)\nC = g(4)\nfrom math import sqrt\ndef f(x):\n    return C*x\n",
                "2*x",
                None,
            ),
            (
                "c = 2\ndef g(v=(c := 5)):\n    return v\ndef f(x):\n    return c*x\n",
                "2*x",
                None,
            ),
            (
                "c = 2\ng = (lambda v=(c := 5): v)\ndef f(x):\n    return c*x\n",
                "2*x",
                None,
            ),
            (
                "from functools import lru_cache\nc = 2\n@lru_cache(maxsize=(c := 5))\ndef g(v):\n    return v\ndef f(x):\n    return c*g(x)\n",
                "2*x",
                None,
            ),
            (
                "c = 2\nwith open('a') as c:\n    pass\ndef f(x):\n    return c*x\n",
                "2*x",
                None,
            ),
            (
                "c = 2\ntry:\n    pass\nexcept ValueError as c:\n    pass\ndef f(x):\n    return c*x\n",
                "2*x",
                None,
            ),
            ("c = 2\ndel c\ndef f(x):\n    return c*x\n", "2*x", None),
            (
                "class abs:\n    pass\ndef f(x):\n    return abs(x)\n",
                "abs(x)",
                None,
            ),
            (
                "import math\nimport math\nA = 2\nB = A*3\ndef f(x):\n    return B*x + math.pi\n",
                "6*x + pi",
                Some(Equal),
            ),
            (
                "from math import sqrt\nclass K:\n    N = 5\n    def f(self, x):\n        return 3*x\n    def sqrt(self, x):\n        return x\nN = 2\ndef f(x):\n    return N*x + sqrt(4)\n",
                "2*x + 2",
                Some(Equal),
            ),
            (
                "N = 3\ndef f(x):\n    s = sum([x for N in range(2)])\n    return s*N\n",
                "6*x",
                Some(Equal),
            ),
        ],
    );
}

#[test]
fn what_may_change_any_name_makes_none_sure() {
    are(
        "f.py",
        &[
            (
                "import math\nmath.pi = 3\ndef f(x):\n    return math.pi*x\n",
                "pi*x",
                None,
            ),
            (
                "def f(x, c=2):\n    return c*x\nf.__defaults__ = (5,)\n",
                "2*x",
                None,
            ),
            (
                "import builtins\nbuiltins.max = min\ndef f(x):\n    return max(x, 1)\n",
                "max(x, 1)",
                None,
            ),
            (
                "c = 2\nimport sys\nsys.modules[__name__].c = 5\ndef f(x):\n    return c*x\n",
                "2*x",
                None,
            ),
            (
                "import math\ndef g(m):\n    m.pi = 3\ng(math)\ndef f(x):\n    return math.pi*x\n",
                "pi*x",
                None,
            ),
            (
                "c = 2\nvars()['c'] = 5\nvars = 3\ndef f(x):\n    return c*x\n",
                "2*x",
                None,
            ),
            (
                "import numpy as np\nA = np.array([1.0, 4.0])\nnp.sqrt(A, A)\ndef f(x):\n    return A[1]*x\n",
                "4*x",
                None,
            ),
            (
                "import math\nimport matplotlib.pyplot as plt\nplt.rcParams['size'] = 3\nclass K:\n    def __init__(self, c):\n        self.c = c\ndef f(x):\n    return math.pi*x\n",
                "pi*x",
                Some(Equal),
            ),
            (
                "def f(x):\n    exec = 2\n    vars = 3\n    return exec*vars*x\n",
                "6*x",
                Some(Equal),
            ),
        ],
    );
}

#[test]
fn a_name_is_written_in_one_way() {
    are(
        "f.py",
        &[
            (
                "def f(x):\n    φ = 2\n    \u{3d5} = 3\n    return φ*x\n",
                "2*x",
                None,
            ),
            (
                "def f(x):\n    μ = 2\n    \u{b5} = 3\n    return μ*x\n",
                "2*x",
                None,
            ),
            (
                "Ω = 2\n\u{2126} = 3\ndef f(x):\n    return Ω*x\n",
                "2*x",
                None,
            ),
            (
                "def f(x):\n    μ = 2\n    φ = 3\n    return μ*φ*x\n",
                "6*x",
                Some(Equal),
            ),
        ],
    );
}
