"""What a formula is worth at a point, and whether a statement is true there, by derivations/SEMANTICS.md.

Derivatives and integrals are SymPy's, numbers are mpmath's with 40 digits. Nothing of the crates is used, and the way is
another one: no power series, no enclosures.
"""

from fractions import Fraction

import mpmath
import sympy

from language import parse

mpmath.mp.dps = 40
EQUAL, DIFFERENT = mpmath.mpf(10) ** -20, mpmath.mpf(10) ** -9
MOST_TERMS = 60


class Undefined(Exception):
    """The term has no value."""


class Unknown(Exception):
    """It has one perhaps, and it is not worked out here."""


class Names:
    """What names stand for: declarations, a point, and what is bound. Local names are not seen by definitions."""

    def __init__(self, scene, point, local=None, moved=None):
        self.scene, self.point, self.local, self.moved = scene, point, local or {}, moved or {}

    def bind(self, name, value):
        if name in self.local:
            return Names(self.scene, self.point, {**self.local, name: value}, self.moved)
        return Names(self.scene, self.point, self.local, {**self.moved, name: value})

    def counting(self, name, value):
        return Names(self.scene, self.point, {**self.local, name: value}, self.moved)

    def inside(self, local):
        return Names(self.scene, self.point, local, self.moved)


def number(value):
    if isinstance(value, list):
        return [number(v) for v in value]
    if isinstance(value, Fraction):
        return sympy.Rational(value.numerator, value.denominator)
    return sympy.sympify(value)


def entrywise(f, *values):
    if any(isinstance(v, list) for v in values):
        # Zero fits every shape.
        lengths = {len(v) for v in values if isinstance(v, list)}
        if len(lengths) > 1 or any(not isinstance(v, list) and v != 0 for v in values):
            raise Undefined("shapes")
        n = lengths.pop()
        rows = [v if isinstance(v, list) else [v] * n for v in values]
        return [entrywise(f, *parts) for parts in zip(*rows)]
    return f(*values)


def scaled(a, b):
    """Products: of a number with anything, of matrices."""
    if not isinstance(a, list):
        return entrywise(lambda v: a * v, b) if isinstance(b, list) else a * b
    if not isinstance(b, list):
        return entrywise(lambda v: v * b, a)
    if not isinstance(a[0], list):
        raise Undefined("shapes")
    product = sympy.Matrix(a) * sympy.Matrix(b)
    return product.tolist() if isinstance(b[0], list) else [row[0] for row in product.tolist()]


def exactly(value):
    """The value of an expression without variables, as a number of 40 digits."""
    value = sympy.sympify(value)
    if value.is_Rational:
        return value
    if value.has(sympy.zoo, sympy.nan, sympy.oo):
        raise Undefined("infinite")
    if value.has(sympy.Integral):
        value = value.replace(sympy.Integral, quadrature)
    found = sympy.N(value, 40, maxn=400)
    if not found.is_number or found.has(sympy.zoo, sympy.nan, sympy.oo):
        raise Undefined("infinite")
    if not found.is_comparable:
        if abs(sympy.im(found)) < EQUAL:
            found = sympy.re(found)
        else:
            raise Undefined("not real")
    return found


def quadrature(body, limits):
    variable, low, high = limits
    free = body.free_symbols - {variable}
    if free or low.free_symbols or high.free_symbols:
        raise Unknown("an integral with variables")
    evaluate = sympy.lambdify(variable, body, [{"Smooth": smooth_number}, "mpmath"])
    found = mpmath.quad(evaluate, [mpmath.mpf(exactly(low)), mpmath.mpf(exactly(high))])
    if mpmath.im(found) != 0:
        raise Undefined("not real")
    return sympy.Float(str(mpmath.re(found)), 40)


def is_zero(value):
    value = sympy.sympify(value)
    if value.is_Rational:
        return value == 0
    if value.free_symbols:
        return False
    return abs(exactly(value)) < EQUAL


def integer(value):
    value = sympy.sympify(value)
    if value.free_symbols:
        raise Undefined("an integer that moves")
    found = exactly(value)
    if abs(found - round(found)) > EQUAL:
        raise Undefined("no integer")
    return int(round(found))


def root(value):
    if not value.free_symbols and exactly(value) < 0 and not is_zero(value):
        raise Undefined("a root of a negative number")
    return sympy.sqrt(value)


def divided(a, b):
    if is_zero(b):
        raise Undefined("a division by zero")
    return entrywise(lambda v: v / b, a)


def value(tree, names):
    """The value of a term: a SymPy expression, in the variables of derivatives and integrals in progress."""
    match tree:
        case ("num", q, _):
            return number(q)
        case ("name", name):
            return named(name, names)
        case ("neg", a):
            return entrywise(lambda v: -v, value(a, names))
        case ("+", a, b):
            return entrywise(lambda v, w: v + w, value(a, names), value(b, names))
        case ("-", a, b):
            return entrywise(lambda v, w: v - w, value(a, names), value(b, names))
        case ("*", a, b):
            return scaled(value(a, names), value(b, names))
        case ("/", a, b):
            return divided(value(a, names), value(b, names))
        case ("^", a, b):
            base, exponent = value(a, names), integer(value(b, names))
            if exponent < 0 and is_zero(base):
                raise Undefined("a power of zero")
            return base ** exponent if exponent else sympy.Integer(1)
        case ("list", *items):
            return [value(item, names) for item in items]
        case ("call", head, *arguments):
            return called(head, arguments, names)
        case ("index", head, *indices):
            return indexed(head, indices, names)
    raise Unknown(f"{tree[0]} as a term")


def named(name, names):
    for layer in (names.local, names.moved):
        if name in layer:
            return layer[name]
    if name in names.scene.definitions:
        parameters, body = names.scene.definitions[name]
        if not parameters:
            return value(body, names.inside({}))
    if name in names.point:
        return names.point[name]
    if name == "pi":
        return sympy.pi
    raise Unknown(f"the name {name}")


# The smooth functions of the points that were drawn, in their order.
DRAWN = []


def smooth_number(which, order, place):
    """A derivative of c_0 + c_1 t + ... + a exp(b t) at a number."""
    *polynomial, a, b = DRAWN[int(which)]
    order, total = int(order), mpmath.mpf(0)
    for n, c in enumerate(polynomial):
        if n >= order:
            total += c * mpmath.ff(n, order) * mpmath.mpf(place) ** (n - order)
    return total + a * mpmath.mpf(b) ** order * mpmath.exp(b * place)


class Smooth(sympy.Function):
    """Smooth(which, order, place): its derivatives are others of its kind."""

    nargs = 3
    is_real = True

    def fdiff(self, argindex=3):
        which, order, place = self.args
        return Smooth(which, order + 1, place)

    def _eval_evalf(self, prec):
        which, order, place = self.args
        place = sympy.N(place, 50)
        if not place.is_number:
            return None
        with mpmath.workprec(max(prec, 160)):
            return sympy.Float(smooth_number(which, order, place._to_mpmath(mpmath.mp.prec)), precision=mpmath.mp.prec)


def function(name, arguments, names, order=0):
    """A definition or a smooth function at its arguments; the derivative by the first of them."""
    scene = names.scene
    if name in scene.functions:
        which = names.point[name]
        if isinstance(which, list):
            return [Smooth(w, order, arguments[0]) for w in which]
        return Smooth(which, order, arguments[0])
    if name not in scene.definitions:
        raise Unknown(f"the function {name}")
    parameters, body = scene.definitions[name]
    if len(parameters) != len(arguments):
        raise Unknown("arguments")
    local = dict(zip(parameters, arguments))
    if not order:
        return value(body, names.inside(local))
    value(body, names.inside(local))
    variable = sympy.Dummy(parameters[0], real=True)
    moved = value(body, names.inside({**local, parameters[0]: variable}))
    return entrywise(lambda v: derived(v, variable, order, arguments[0]), moved)


def derived(body, variable, order, place):
    found = sympy.diff(body, variable, order).subs(variable, place)
    if found.has(sympy.zoo, sympy.nan):
        raise Undefined("no derivative")
    return found


def called(head, arguments, names):
    if head[0] == "index":
        return basis(head[1][1], head[2], head[3], [value(a, names) for a in arguments], names)
    if head[0] == "call" and head[1] == ("name", "D"):
        return derivative_of_function(head[2:], arguments, names)
    if head[0] != "name":
        raise Unknown("a call")
    name = head[1]
    match (name, *arguments):
        case ("sqrt", a):
            return root(value(a, names))
        case ("abs", a):
            v = value(a, names)
            return root(v * v)
        case ("min" | "max", a, b):
            a, b = value(a, names), value(b, names)
            size = root((a - b) * (a - b))
            return (a + b + size) / 2 if name == "max" else (a + b - size) / 2
        case ("norm", a):
            return root(sum(v * v for v in value(a, names)))
        case ("sin" | "cos" | "exp" | "cosh" | "sinh" | "tanh", a):
            return getattr(sympy, name)(value(a, names))
        case ("log", a):
            v = value(a, names)
            if v.is_number and not v.is_positive:
                raise Undefined("a logarithm")
            return sympy.log(v)
        case ("atan", a):
            return sympy.atan(value(a, names))
        case ("asin" | "acos", a):
            v = value(a, names)
            if v.is_number and (1 - v * v).is_negative:
                raise Undefined("an arc")
            return getattr(sympy, name)(v)
        case ("tan", a):
            v = value(a, names)
            return divided(sympy.sin(v), sympy.cos(v))
        case ("binom", n, j):
            n, j = value(n, names), integer(value(j, names))
            return sympy.ff(n, j) / sympy.factorial(j) if j >= 0 else sympy.Integer(0)
        case ("factorial", n):
            n = integer(value(n, names))
            if n < 0:
                raise Undefined("a factorial")
            return sympy.factorial(n)
        case ("dot", a, b):
            a, b = value(a, names), value(b, names)
            return sum(v * w for v, w in zip(a, b)) if isinstance(a, list) else a * b
        case ("cross", a, b):
            a, b = value(a, names), value(b, names)
            return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
        case ("det", m):
            return sympy.Matrix(value(m, names)).det()
        case ("transpose", m):
            return sympy.Matrix(value(m, names)).T.tolist()
        case ("inverse", m):
            matrix = sympy.Matrix(value(m, names))
            if is_zero(matrix.det()):
                raise Undefined("an inverse")
            return matrix.inv().tolist()
        case ("identity", n):
            return sympy.eye(integer(value(n, names))).tolist()
        case ("D", body, ("name", by)):
            return derivative(body, by, 1, names)
        case ("D", body, ("name", by), order):
            return derivative(body, by, integer(value(order, names)), names)
        case ("at", body, ("name", by), put):
            return value(body, names.bind(by, value(put, names)))
        case ("sum" | "product", ("name", index), low, high, body):
            low, high = integer(value(low, names)), integer(value(high, names))
            if high - low > MOST_TERMS:
                raise Unknown("a long sum")
            terms = [value(body, names.counting(index, sympy.Integer(n))) for n in range(low, high + 1)]
            whole = sympy.Integer(0 if name == "sum" else 1)
            for term in terms:
                whole = entrywise(lambda v, w: v + w, whole, term) if name == "sum" else scaled(whole, term)
            return whole
        case ("integral", body, ("name", by), low, high):
            return integral(body, by, value(low, names), value(high, names), names)
    stem = name.rstrip("'")
    return function(stem, [value(a, names) for a in arguments], names, len(name) - len(stem))


def derivative(body, by, order, names):
    place = named(by, names)
    if order < 0:
        raise Undefined("an order")
    # It has to be defined there; what follows may cancel what has no value.
    value(body, names.bind(by, place))
    if not order:
        return value(body, names.bind(by, place))
    variable = sympy.Dummy(by, real=True)
    return entrywise(lambda v: derived(v, variable, order, place), value(body, names.bind(by, variable)))


def derivative_of_function(inner, arguments, names):
    name, order, by = inner[0][1], 1, None
    if len(inner) > 1:
        by = inner[1][1]
    if len(inner) > 2:
        order = integer(value(inner[2], names))
    arguments = [value(a, names) for a in arguments]
    parameters = names.scene.definitions.get(name, ([None], None))[0]
    if by in (None, parameters[0]):
        return function(name, arguments, names, order)
    raise Unknown("a derivative of a function by another name")


def integral(body, by, low, high, names):
    fixed = not (low.free_symbols or high.free_symbols)
    for n in range(17 if fixed else 1):
        place = low + (high - low) * sympy.Rational(n, 16)
        value(body, names.bind(by, place))
    variable = sympy.Dummy(by, real=True)
    inner = value(body, names.bind(by, variable))
    return entrywise(lambda v: sympy.Integral(v, (variable, low, high)), inner)


def basis(name, index, degree, arguments, names):
    family = names.scene.bases.get(name)
    if family is None:
        raise Unknown(f"the basis {name}")
    index, degree = integer(value(index, names)), integer(value(degree, names))
    for left_out in family["variables"][len(arguments):]:
        arguments.append(named(left_out, names.inside({})))
    row = functions(family, degree, arguments, names)
    return row[index] if 0 <= index <= degree else sympy.Integer(0)


def functions(family, degree, arguments, names):
    """All functions of a degree."""
    local = dict(zip(family["variables"], arguments))
    inside = names.inside(local)
    row = [value(seed, inside) for seed in family["seeds"]]
    if degree < len(row) - 1 or degree > len(row) - 1 and not family["step"]:
        raise Undefined("a degree")
    for k in range(len(row), degree + 1):
        def factor(place, i):
            counters = dict(zip(family["counters"], map(sympy.Integer, (i, k)))) if family["counters"] else {}
            return value(family["step"][place], names.inside({**local, **counters}))
        row = [(factor(0, i) * row[i] if i < k else 0) + (factor(1, i) * row[i - 1] if i else 0) for i in range(k + 1)]
    return row


def indexed(head, indices, names):
    scene = names.scene
    name = head[1] if head[0] == "name" else None
    if name in scene.bases:
        return basis(name, *indices, [], names)
    places = [integer(value(i, names)) for i in indices]
    if name in scene.definitions and scene.definitions[name][0] and name not in names.local:
        parameters, body = scene.definitions[name]
        found = value(body, names.inside(dict(zip(parameters, map(sympy.Integer, places)))))
        places = places[len(parameters):]
    elif name in scene.families:
        count = scene.families[name]["places"]
        member = names.point[name]
        key = tuple(places[:count])
        if key not in member:
            raise Undefined("an index out of its range")
        found, places = member[key], places[count:]
    else:
        found = value(head, names)
    for place in places:
        if not isinstance(found, list) or not 1 <= place <= len(found):
            raise Undefined("an entry")
        found = found[place - 1]
    return found


def truth(tree, names):
    """Whether a statement is true. Every part has to be defined."""
    match tree:
        case ("cmp", first, *rest):
            sides = [value(first, names), *(value(side, names) for _, side in rest)]
            links = [compare(a, relation, b) for a, (relation, _), b in zip(sides, rest, sides[1:])]
            return all(links)
        case ("and", p, q):
            p, q = truth(p, names), truth(q, names)
            return p and q
        case ("or", p, q):
            p, q = truth(p, names), truth(q, names)
            return p or q
        case ("implies", p, q):
            p, q = truth(p, names), truth(q, names)
            return not p or q
        case ("not", p):
            return not truth(p, names)
        case ("call", ("name", "at"), p, ("name", by), put):
            return truth(p, names.bind(by, value(put, names)))
        case ("call", ("name", "nonnegative"), ("name", name)):
            return nonnegative(names.scene.bases[name], names)
    raise Unknown("a statement of another kind")


def nonnegative(family, names):
    arguments = [named(n, names.inside({})) for n in family["variables"][1:]]
    low, high = names.scene.interval(family["variables"][0])
    for n in range(9):
        x = low + (high - low) * sympy.Rational(n, 8)
        for degree in range(len(family["seeds"]) - 1, len(family["seeds"]) + 1):
            if any(exactly(f) < -EQUAL for f in functions(family, degree, [x, *arguments], names)):
                return False
    return True


def compare(a, relation, b):
    if isinstance(a, list) or isinstance(b, list):
        if relation not in ("==", "!="):
            raise Undefined("an order of vectors")
        entries = []
        entrywise(lambda v, w: entries.append(compare(v, "==", w)), a, b)
        return all(entries) == (relation == "==")
    a, b = exactly(a), exactly(b)
    if a.is_Rational and b.is_Rational:
        apart = 0 if a == b else 1
    else:
        apart = abs(a - b) / (1 + abs(a) + abs(b))
    if EQUAL < apart < DIFFERENT:
        raise Unknown("nearly equal")
    equal = apart <= EQUAL
    match relation:
        case "==":
            return equal
        case "!=":
            return not equal
        case "<=":
            return equal or bool(a < b)
        case ">=":
            return equal or bool(a > b)
        case "<":
            return not equal and bool(a < b)
        case ">":
            return not equal and bool(a > b)


def formula(text):
    return parse(text)
