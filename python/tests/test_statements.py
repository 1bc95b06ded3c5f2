import pytest
import torse

sympy = pytest.importorskip("sympy")


def test_a_true_statement_is_true():
    found = torse.decide("sin(x)^2 + cos(x)^2 == 1")
    assert found
    assert found.verdict == "holds" and found.replayed
    assert "sin" in found._repr_latex_() and "<math" in found._repr_html_()


def test_a_false_statement_has_an_exact_counterexample():
    found = torse.decide("(a + b)^2 == a^2 + b^2")
    assert not found
    assert found.witness == {"at": {"a": "1", "b": "1"}, "left": "4", "right": "2"}
    assert torse.equal("a^2 + 2*a*b + b^2", "(a + b)^2")


def test_what_is_not_decided_is_neither_true_nor_false():
    found = torse.decide("(a + b)^9 == (b + a)^9", budget=1)
    assert found.is_true is None
    assert torse.UndecidedError.line is None and torse.UndecidedError.hint is None
    with pytest.raises(torse.UndecidedError, match="undecided"):
        bool(found)
    # It needs a condition that nobody has stated.
    with pytest.raises(torse.UndecidedError, match="conditional"):
        bool(torse.decide("x/x == 1"))
    assert torse.decide("x/x == 1", where="x != 0")


def test_a_mistake_has_its_place():
    for statement, where, place in [
        ("x + == 1", "", ("the statement", 1, 5)),
        ("x == 1", "x in [0, 1]; y > 0 +", ("the setting", 1, 21)),
        ("f(x) == 1", "", ("the statement", 1, 1)),
    ]:
        with pytest.raises(torse.TorseError) as raised:
            torse.decide(statement, where)
        error = raised.value
        assert (error.file, error.line, error.column) == place
        assert str(error).startswith("{}:{}:{}: ".format(*place))


def test_terms_of_sympy_are_compared():
    x, y = sympy.symbols("x y", real=True)
    assert torse.equal((x + y) ** 3, sympy.expand((x + y) ** 3))
    assert not torse.equal((x + y) ** 3, x**3 + y**3)
    assert torse.equal(sympy.sin(2 * x), 2 * sympy.sin(x) * sympy.cos(x))
    assert torse.equal(x / 3 - sympy.Rational(1, 7), (7 * x - 3) / 21)
    assert torse.equal(-((-x) ** 2), -(x**2))
    assert torse.equal(1 / sympy.sqrt(1 + x**2), (1 + x**2) ** sympy.Rational(-1, 2))


def test_what_sympy_assumes_of_a_symbol_is_a_hypothesis():
    x = sympy.symbols("x", positive=True)
    n, k = sympy.symbols("n k", integer=True, nonnegative=True)
    assert torse.equal(sympy.sqrt(x**2), x)
    assert torse.decide(sympy.Gt(x + 1, 1, evaluate=False))
    t = sympy.symbols("t")
    sums = sympy.Sum(sympy.binomial(n, k) * t**k * (1 - t) ** (n - k), (k, 0, n))
    assert torse.equal(sums, 1)
    # What is said beats what is assumed.
    assert not torse.decide("x > 0", where="x in [-1, 1]")


@pytest.mark.parametrize("term", [0.5, None, [1], sympy.Float(0.5), sympy.I, sympy.Function("f")(sympy.Symbol("x"))])
def test_what_has_no_exact_meaning_is_refused(term):
    with pytest.raises((TypeError, ValueError)):
        torse.equal(term, 1)


def test_symbols_that_would_be_read_as_something_else_are_refused():
    x = sympy.Symbol("x")
    for symbol in (sympy.oo, sympy.EulerGamma, sympy.Symbol("pi"), sympy.Symbol("x y"), sympy.zoo):
        with pytest.raises(ValueError):
            torse.equal(symbol + x, x)
    # Two symbols of one name are not one variable.
    with pytest.raises(ValueError, match="two symbols"):
        torse.equal(x, sympy.Symbol("x", positive=True))
    with pytest.raises(ValueError, match="range"):
        torse.equal(sympy.Symbol("n", integer=True), 1)
    assert torse.equal(sympy.pi * x, x * sympy.pi)


@pytest.mark.parametrize("fact", ["even", "odd", "prime"])
def test_an_assumption_that_is_not_said_is_refused_and_not_forgotten(fact):
    n = sympy.Symbol("n", nonnegative=True, **{fact: True})
    # Without it `False` would be told, at an n that the symbol excludes.
    with pytest.raises(ValueError, match=fact):
        torse.equal(2 * n, n)
    assert torse.equal(n + n, 2 * n, where="n in 0..")
    for other in (sympy.Symbol("x", irrational=True), sympy.Symbol("x", zero=True)):
        with pytest.raises(ValueError):
            torse.equal(other + 1, other)


def test_what_does_not_commute_is_no_number():
    a, b = sympy.symbols("a b", commutative=False)
    m, n = sympy.MatrixSymbol("m", 2, 2), sympy.MatrixSymbol("n", 2, 2)
    for left, right in ((a * b, b * a), (m * n, n * m), (sympy.eye(2), 1)):
        with pytest.raises((TypeError, ValueError)):
            torse.equal(left, right)


def test_deep_and_long_statements_end_with_an_answer_or_an_error():
    with pytest.raises(torse.TorseError, match="deep"):
        torse.decide("(" * 20000 + "x" + ")" * 20000 + " == x")
    assert torse.decide(" + ".join(["x"] * 250) + " == 250*x")
    assert torse.decide("x" + "/2" * 200 + " == x/2^200")
