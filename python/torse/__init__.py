"""Formulas and papers decided exactly; developable surfaces and their flat patterns.

>>> import torse
>>> bool(torse.decide("sin(x)^2 + cos(x)^2 == 1"))
True
>>> torse.decide("(a + b)^2 == a^2 + b^2").witness["at"]
{'a': '1', 'b': '1'}
"""

from ._designs import Design, Pattern
from ._statements import Decided, decide, equal, to_sympy
from ._papers import Explanation, Letter, Paper, Verification
from ._torse import TorseError, UndecidedError, __version__

__all__ = [
    "Decided",
    "Design",
    "Explanation",
    "Letter",
    "Paper",
    "Pattern",
    "TorseError",
    "UndecidedError",
    "Verification",
    "__version__",
    "decide",
    "equal",
    "to_sympy",
]
