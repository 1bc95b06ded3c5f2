"""One statement: decided, explained, shown."""

from . import _html, _sympy, _torse


class Decided:
    """What is true of a statement, and why.

    It is true or false only where that is decided: `bool` raises `UndecidedError` for a statement that is undecided, needs a
    condition, or says nothing.

    >>> import torse
    >>> wrong = torse.decide("(x + 1)*(x - 1) == x^2 + 1")
    >>> wrong
    <misprint: (x + 1)*(x - 1) == x^2 + 1>
    >>> wrong.corrected
    '(x + 1)*(x - 1) == x^2 - 1'
    >>> bool(torse.decide("x/x == 1"))
    Traceback (most recent call last):
    ...
    torse.UndecidedError: the statement is neither true nor false as it stands: conditional
    """

    def __init__(self, found, symbols=()):
        self._found = found
        self._symbols = dict(symbols)

    verdict = property(lambda self: self._found.verdict, doc="`holds`, `conditional`, `misprint`, `false`, `undecided`, `vacuous`")
    is_true = property(lambda self: self._found.is_true, doc="True, False, or None where that is not decided")
    evidence = property(lambda self: self._found.evidence, doc="what the verdict rests on, in a word")
    statement = property(lambda self: self._found.statement, doc="the statement as it was understood")
    corrected = property(lambda self: self._found.corrected, doc="the smallest change that makes it true, proved, or None")
    conditions = property(lambda self: self._found.conditions, doc="under which it is true, where it needs some")
    replayed = property(lambda self: self._found.replayed, doc="whether a checker without search accepts the proof, or None")
    steps = property(lambda self: self._found.steps, doc="the steps of the decision, in words")
    witness = property(
        lambda self: self._found.witness,
        doc="a point at which it fails: {'at': {name: value}, 'left': ..., 'right': ...}, exact values as texts, or None",
    )
    explanation = property(lambda self: self._found.explanation, doc="all of it: groups of (label, text)")

    def json(self):
        """One object of JSON, as a line of `torse decide - --format json`."""
        return self._found.json()

    def to_sympy(self, text=None):
        """The statement as an expression of SymPy, with the symbols that came in; or another text, such as `corrected` or a
        value of `witness`."""
        return to_sympy(self.statement if text is None else text, self._symbols.values())

    def __bool__(self):
        return bool(self._found)

    def __repr__(self):
        return f"<{self.verdict}: {self.statement}>"

    def __str__(self):
        return _html.text(self.explanation)

    def _repr_latex_(self):
        latex = self._found.latex
        return f"$\\displaystyle {latex}$" if latex else None

    def _repr_html_(self):
        formula = self._found.mathml
        shown = f"<p><math display='block'>{formula}</math></p>" if formula else ""
        return shown + _html.table(self.explanation)


def decide(statement, where="", budget=None):
    """Decides one statement about real numbers.

    `statement` is a text in the notation of torse, or a relation of SymPy. `where` declares names and states hypotheses, with
    semicolons or commas between: `"x in [0, 1]; n in 0..; a > 0"`; or it is a list of such texts and relations of SymPy. Names that are
    not declared are real numbers. `budget` bounds the work; what needs more is undecided.

    >>> import torse
    >>> bool(torse.decide("x*(1 - x) <= 1/4", where="x in [0, 1]"))
    True
    >>> torse.decide("x^2 > 0").witness["at"]
    {'x': '0'}
    >>> torse.decide("x + == 1")
    Traceback (most recent call last):
    ...
    torse.TorseError: the statement:1:5: ...
    """
    read = _sympy.statement(statement)
    return _decided(read.text, _sympy.Setting(where, read), budget)


def equal(left, right, where="", budget=None):
    """Decides whether two terms, texts or expressions of SymPy, are equal for all values for which they have a meaning as real numbers.

    What is true for real numbers, and not for all that a symbol of SymPy may be, is refused.

    >>> import torse
    >>> bool(torse.equal("(a + b)^2", "a^2 + 2*a*b + b^2"))
    True
    >>> import sympy
    >>> x = sympy.Symbol("x")
    >>> torse.equal(sympy.sqrt(x**4), x**2)
    Traceback (most recent call last):
    ...
    ValueError: it is true for real numbers; for SymPy x may be complex: Symbol('x', real=True), or where='x in (-inf, inf)'
    """
    left, right = _sympy.term(left), _sympy.term(right)
    return _decided(f"({left.text}) == ({right.text})", _sympy.Setting(where, left, right), budget)


def _decided(text, setting, budget):
    found = Decided(_torse.decide(text, setting.text, budget), setting.symbols)
    setting.check(found.is_true, lambda condition, where: _holds(condition, where, budget))
    return found


def _holds(condition, where, budget):
    try:
        return _torse.decide(condition, where, budget).is_true is True
    except _torse.TorseError:
        return False


def to_sympy(text, symbols=()):
    """A text in the notation of torse as an expression of SymPy: exact, and relations unevaluated.

    Names are real numbers, but for those of `symbols`.

    >>> import torse
    >>> torse.to_sympy("(a + b)^2/3 == a")
    Eq((a + b)**2/3, a)
    """
    return _sympy.expression(_torse.sympy_code(text), {symbol.name: symbol for symbol in symbols})
