"""What torse says of expressions of SymPy is true of what SymPy means by them."""

import random
from fractions import Fraction

import pytest
import torse

sympy = pytest.importorskip("sympy")


def test_a_symbol_that_may_be_complex_is_no_real_number():
    x, y = sympy.symbols("x y")
    # At x = i the root is 1 on the left and -1 on the right.
    for left, right in ((sympy.sqrt(x**4), x**2), (sympy.Abs(x) ** 2, x**2)):
        with pytest.raises(ValueError, match="complex"):
            torse.equal(left, right)
        assert torse.equal(left, right, where="x in (-inf, inf)")
    with pytest.raises(ValueError, match="complex"):
        torse.decide(sympy.Ne(x**2 + 1, 0))
    with pytest.raises(ValueError, match="complex"):
        torse.decide(sympy.Ge(x**2, 0, evaluate=False))
    with pytest.raises(ValueError, match="complex"):
        torse.equal(x**2 * y, y, where=[sympy.Eq(x**2, 1)])
    # An equation of meromorphic functions that is true on the reals is true.
    assert torse.equal(sympy.sin(2 * x), 2 * sympy.sin(x) * sympy.cos(x))
    assert torse.equal((x + y) ** 3, sympy.expand((x + y) ** 3))
    assert torse.decide(sympy.Eq(sympy.exp(x) ** 2, sympy.exp(2 * x), evaluate=False))
    # A point at which it fails is one, wherever else the symbol may lie.
    assert not torse.equal(sympy.Abs(x), x)


def test_the_smaller_and_the_greater_number_are_those_of_sympy():
    x, y, z = sympy.symbols("x y z", real=True)
    assert torse.equal(sympy.Max(x, y) + sympy.Min(x, y), x + y)
    assert torse.decide(sympy.Ge(sympy.Max(x, y, z), z, evaluate=False))
    assert not torse.equal(sympy.Max(x, y), x)


def test_the_root_of_a_negative_number_is_complex_for_sympy():
    x, y = sympy.symbols("x y", real=True)
    # At x = y = -1 it is i*i = -1 on the left, and 1 on the right.
    found = []
    try:
        found.append(torse.equal(sympy.sqrt(x) * sympy.sqrt(y), sympy.sqrt(x * y)).is_true)
    except ValueError as error:
        assert "roots" in str(error)
    assert True not in found
    p, q = sympy.symbols("p q", positive=True)
    assert torse.equal(sympy.sqrt(x**2 + 1) ** 2 * p, p * (x**2 + 1))
    assert torse.decide(sympy.Eq(sympy.sqrt(p * q), sympy.sqrt(p) * sympy.sqrt(q), evaluate=False))
    assert torse.equal(sympy.sqrt(x), sympy.sqrt(x + 0), where="x >= 0")


def test_sums_and_products_run_backwards_for_sympy():
    k = sympy.Symbol("k", integer=True)
    m, n = sympy.symbols("m n", integer=True, nonnegative=True)
    assert sympy.Sum(1, (k, 3, 0)).doit() == -2
    with pytest.raises(ValueError, match="backwards"):
        torse.equal(sympy.Sum(1, (k, 3, m)), 0, where="m in 0..1")
    with pytest.raises(ValueError, match="backwards"):
        torse.equal(sympy.Product(2, (k, 2, m)), 1, where="m in 0..0")
    assert torse.equal(sympy.Sum(k, (k, 1, n)), n * (n + 1) / 2)
    j = sympy.Symbol("j", integer=True)
    assert torse.equal(sympy.Sum(1, (j, 0, k), (k, 0, n)), (n + 1) * (n + 2) / 2)


def test_a_function_of_somebody_else_is_not_the_sine():
    x = sympy.Symbol("x", real=True)
    with pytest.raises(ValueError, match="sin"):
        torse.equal(sympy.Function("sin")(x) ** 2 + sympy.Function("cos")(x) ** 2, 1)


@pytest.mark.parametrize("name", ["x²", "x'", "_x", "sin", "implies", "x y", "1x", "x;y", ""])
def test_a_name_that_would_be_read_as_something_else_is_refused(name):
    with pytest.raises(ValueError):
        torse.equal(sympy.Symbol(name, real=True) + 1, 1)


def test_numbers_are_exact():
    x = sympy.Symbol("x", real=True)
    assert torse.equal(Fraction(1, 3), sympy.Rational(1, 3))
    assert torse.equal(x / 3, x * sympy.Rational(1, 3), where="x in [0, 1]")
    for number in (True, 0.5, 1j):
        with pytest.raises(TypeError):
            torse.equal(number, x)


def test_results_come_back_as_expressions_with_the_symbols_that_went_in():
    x = sympy.Symbol("x", positive=True)
    wrong = torse.equal((x + 1) * (x - 1), x**2 + 1)
    assert wrong.to_sympy().free_symbols == {x}
    right = wrong.to_sympy(wrong.corrected)
    assert sympy.simplify(right.lhs - right.rhs) == 0
    at = {name: wrong.to_sympy(value) for name, value in wrong.witness["at"].items()}
    assert at["x"].is_positive and ((x + 1) * (x - 1) - x**2 - 1).subs(x, at["x"]) != 0
    assert torse.to_sympy("x/2 == 1/3", [x]) == sympy.Eq(x / 2, sympy.Rational(1, 3), evaluate=False)
    assert torse.to_sympy("sum(i, 0, 3, i)").doit() == 6
    with pytest.raises(torse.TorseError) as raised:
        torse.to_sympy("x +")
    assert raised.value.column == 4
    with pytest.raises(ValueError, match="no expression"):
        torse.to_sympy("H(x)")


KINDS = [{"positive": True}, {"negative": True}, {"nonnegative": True}, {"real": True}, {"nonzero": True, "real": True}]


def _term(draw, symbols, depth):
    if depth == 0 or draw.random() < 0.2:
        return draw.choice([*symbols, *symbols, sympy.Integer(draw.randint(-2, 3)), sympy.Rational(1, draw.randint(2, 3))])
    a, b = (_term(draw, symbols, depth - 1) for _ in range(2))
    return draw.choice([
        lambda: a + b, lambda: a - b, lambda: a * b, lambda: a / b if b != 0 else a, lambda: a**2, lambda: sympy.Abs(a),
        lambda: sympy.sqrt(a), lambda: sympy.sqrt(a**2), lambda: sympy.sqrt(sympy.expand(a**2)),
    ])()


def _point(draw, symbol):
    value = sympy.Rational(draw.randint(1, 7), draw.randint(1, 4))
    if symbol.is_negative or (not symbol.is_nonnegative and draw.random() < 0.5):
        value = -value
    return value


def _looks_alike(draw, term, symbols):
    """A term that looks the same and need not be: rewritten as if all were positive, as somebody in a hurry does."""
    positive = {symbol: sympy.Symbol(symbol.name, positive=True) for symbol in symbols}
    there = term.xreplace(positive).doit()
    there = draw.choice([sympy.simplify, sympy.expand, sympy.factor, lambda same: sympy.powdenest(same, force=True)])(there)
    return there.xreplace({other: symbol for symbol, other in positive.items()})


@pytest.mark.parametrize("seed", range(60))
def test_nothing_is_equal_that_sympy_refutes_at_a_point(seed):
    draw = random.Random(seed)
    symbols = [sympy.Symbol(name, **draw.choice(KINDS)) for name in "ab"]
    left = right = sympy.Integer(0)
    while left == right:
        left = _term(draw, symbols, 3)
        right = _looks_alike(draw, left, symbols)
    points = [{symbol: _point(draw, symbol) for symbol in symbols} for _ in range(20)]
    try:
        found = torse.equal(left, right, budget=2_000_000)
    except ValueError:
        return
    for point in points:
        values = [sympy.N(side.subs(point), 30) for side in (left, right)]
        if not all(value.is_number and value.is_finite for value in values):
            continue
        near = abs(values[0] - values[1]) < 1e-20 * (1 + abs(values[0]))
        assert near or found.is_true is not True, (left, right, point)
    if found.is_true is False and found.witness:
        at = {symbol: found.to_sympy(found.witness["at"][symbol.name]) for symbol in symbols if symbol.name in found.witness["at"]}
        for symbol, value in at.items():
            facts = (("is_positive", value > 0), ("is_negative", value < 0), ("is_nonnegative", value >= 0), ("is_nonzero", value != 0))
            assert all(bool(is_so) for fact, is_so in facts if getattr(symbol, fact)), (symbol, value)
