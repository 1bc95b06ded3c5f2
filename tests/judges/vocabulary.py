"""Judges truths that were written down before the engine was asked: mpmath at points of the domain.

    python3 tests/judges/vocabulary.py FILE...    each line is `truth | statement | setting`

A statement that is said to be true fails at no point that is drawn and has a meaning at some; one that is said to be false
fails at one; a silent one has a meaning at none. `cargo test -p torse-verdicts --test vocabulary` runs it.
"""

import itertools
import json
import random
import re
import sys
from fractions import Fraction

import mpmath

import language

mpmath.mp.dps = 40
NEAR = mpmath.mpf(10) ** -22
DRAWN = 400
SIMPLE = [Fraction(*q) for q in [(0, 1), (1, 1), (-1, 1), (2, 1), (1, 2), (-2, 1), (3, 1), (3, 2), (1, 3), (-1, 2), (5, 2), (9, 10),
                                 (11, 10), (99, 100), (7, 1), (1, 10)]]


class Undefined(Exception):
    """The term has no value."""


class Point(dict):
    """Numbers by name; functions by name."""

    def moved(self, name, value):
        return Point({**self, name: value})


def integer(value):
    if abs(value - mpmath.nint(value)) > NEAR:
        raise Undefined("an integer")
    return int(mpmath.nint(value))


def divided(a, b):
    if abs(b) < NEAR:
        raise Undefined("a quotient")
    return a / b


def entrywise(f, a, b):
    if isinstance(a, list) and isinstance(b, list):
        return [entrywise(f, x, y) for x, y in zip(a, b, strict=True)]
    if isinstance(a, list):
        return [entrywise(f, x, b) for x in a]
    if isinstance(b, list):
        return [entrywise(f, a, y) for y in b]
    return f(a, b)


def logarithm(x):
    if x <= 0:
        raise Undefined("a logarithm")
    return mpmath.log(x)


def root(x):
    if x < -NEAR:
        raise Undefined("a root")
    return mpmath.sqrt(max(x, 0))


def derivative(body, by, order, point):
    # The Taylor coefficients come from values nearby, which all have to be there.
    value(body, point)
    with mpmath.workdps(90):
        return mpmath.diff(lambda x: value(body, point.moved(by, x)), point[by], order)


def integral(body, by, low, high, point):
    for k in range(41):
        value(body, point.moved(by, low + (high - low) * k / 40))
    return mpmath.quad(lambda x: value(body, point.moved(by, x)), mpmath.linspace(low, high, 5))


def called(name, arguments, point):
    match (name, *arguments):
        case ("D", body, ("name", by)):
            return derivative(body, by, 1, point)
        case ("D", body, ("name", by), order):
            return derivative(body, by, integer(value(order, point)), point)
        case ("at", body, ("name", by), there):
            return value(body, point.moved(by, value(there, point)))
        case ("integral", body, ("name", by), low, high):
            return integral(body, by, value(low, point), value(high, point), point)
        case ("sum" | "product", ("name", index), low, high, body):
            low, high = integer(value(low, point)), integer(value(high, point))
            found = mpmath.mpf(0 if name == "sum" else 1)
            for i in range(low, high + 1):
                there = value(body, point.moved(index, mpmath.mpf(i)))
                found = found + there if name == "sum" else found * there
            return found
        case ("norm", v):
            return root(sum(x * x for x in value(v, point)))
        case ("binom", n, j):
            n, j = value(n, point), integer(value(j, point))
            return mpmath.binomial(n, j) if j >= 0 else mpmath.mpf(0)
    numbers = [value(argument, point) for argument in arguments]
    match (name, *numbers):
        case ("log", x):
            return logarithm(x)
        case ("atan", x):
            return mpmath.atan(x)
        case ("asin" | "acos", x):
            if abs(x) > 1 + NEAR:
                raise Undefined("an arc")
            return getattr(mpmath, name)(max(min(x, 1), -1))
        case ("sqrt", x):
            return root(x)
        case ("abs", x):
            return abs(x)
        case ("tan", x):
            return divided(mpmath.sin(x), mpmath.cos(x))
        case ("sin" | "cos" | "exp" | "sinh" | "cosh" | "tanh", x):
            return getattr(mpmath, name)(x)
        case ("min", *all):
            return min(all)
        case ("max", *all):
            return max(all)
        case ("factorial", n):
            return mpmath.factorial(integer(n))
    if name.rstrip("'") in point:
        function = point[name.rstrip("'")]
        return mpmath.diff(function, numbers[0], name.count("'"))
    raise ValueError(name)


def value(tree, point):
    match tree:
        case ("num", number, _):
            return mpmath.mpf(number.numerator) / number.denominator
        case ("name", "pi"):
            return +mpmath.pi
        case ("name", name):
            return point[name]
        case ("list", *items):
            items = items[0] if len(items) == 1 and isinstance(items[0], list) else items
            return [value(item, point) for item in items]
        case ("neg", x):
            return entrywise(lambda a, b: -a, value(x, point), 0)
        case ("+" | "-" | "*" | "/" | "^" as sign, a, b):
            a, b = value(a, point), value(b, point)
            if sign == "^":
                b = integer(b)
                if b < 0 and abs(a) < NEAR:
                    raise Undefined("a power")
                return a ** b
            return entrywise({"+": lambda x, y: x + y, "-": lambda x, y: x - y, "*": lambda x, y: x * y,
                              "/": divided}[sign], a, b)
        case ("call", ("name", name), *arguments):
            arguments = arguments[0] if len(arguments) == 1 and isinstance(arguments[0], list) else arguments
            return called(name, arguments, point)
    raise ValueError(tree)


def compared(relation, a, b):
    if isinstance(a, list):
        same = all(abs(x - y) < NEAR for x, y in zip(a, b, strict=True))
        return same if relation == "==" else not same
    near = abs(a - b) < NEAR * (1 + abs(a))
    return {"==": near, "!=": not near, "<": a < b and not near, "<=": a < b or near, ">": a > b and not near,
            ">=": a > b or near}[relation]


def agrees(number, printed):
    """Rounded or cut off at as many digits as are printed."""
    _, written, decimals = printed
    unit = mpmath.mpf(10) ** -decimals
    written = mpmath.mpf(written.numerator) / written.denominator
    return abs(number - written) <= unit / 2 or written <= number < written + unit


def truth(tree, point, domain):
    match tree:
        case ("cmp", first, *links):
            values = [value(first, point)] + [value(side, point) for _, side in links]
            relations = [relation for relation, _ in links]
            return all(compared(r, a, b) for r, a, b in zip(relations, values, values[1:]))
        case ("not", p):
            return not truth(p, point, domain)
        case ("and", p, q):
            p, q = truth(p, point, domain), truth(q, point, domain)
            return p and q
        case ("or", p, q):
            p, q = truth(p, point, domain), truth(q, point, domain)
            return p or q
        case ("implies", p, q):
            return not truth(p, point, domain) or truth(q, point, domain)
        case ("call", ("name", "fails"), *inner):
            inner = inner[0] if not isinstance(inner[0], list) else inner[0][0]
            return any(said(inner, other, domain) is False for other in domain)
        case ("call", ("name", "agrees"), *arguments):
            arguments = arguments[0] if len(arguments) == 1 else arguments
            return agrees(value(arguments[0], point), arguments[1])
    raise ValueError(tree)


def said(tree, point, domain):
    try:
        return truth(tree, point, domain)
    except Undefined:
        return None


def names_of(tree):
    """The names of numbers in a tree, those of binders left out."""
    match tree:
        case ("name", name):
            return {name} - {"pi"}
        case ("call", ("name", "D" | "at" | "integral" as name), *arguments):
            arguments = arguments[0] if len(arguments) == 1 and isinstance(arguments[0], list) else arguments
            inner = set().union(*map(names_of, arguments))
            return inner - {arguments[1][1]} if name == "integral" else inner
        case ("call", ("name", "sum" | "product"), *arguments):
            arguments = arguments[0] if len(arguments) == 1 and isinstance(arguments[0], list) else arguments
            return set().union(*map(names_of, arguments)) - {arguments[0][1]}
        case ("call", ("name", _), *arguments):
            return set().union(*map(names_of, arguments))
        case tuple() | list():
            return set().union(*[names_of(part) for part in tree if isinstance(part, tuple | list)])
    return set()


def settings(text):
    """The hypotheses, and for each declared name the list that its values are drawn from, or its ends."""
    assumed, ranges, functions = [], {}, set()
    for part in filter(None, map(str.strip, text.split(";"))):
        if found := re.fullmatch(r"(\w+)\s*:\s*function 1", part):
            functions.add(found[1])
        elif found := re.fullmatch(r"(\w+) in (-?\d+)\.\.(-?\d*)", part):
            low = int(found[2])
            high = int(found[3]) if found[3] else low + 4
            ranges[found[1]] = [Fraction(n) for n in range(low, high + 1)]
        elif found := re.fullmatch(r"(\w+) in ([\[(])(.*),(.*)([\])])", part):
            name, _, low, high, _ = found.groups()
            for end, sign in [(low.strip(), found[2] == "["), (high.strip(), found[5] == "]")]:
                if "inf" not in end:
                    relation = (">" if end == low.strip() else "<") + ("=" if sign else "")
                    assumed.append(language.parse(f"{name} {relation} {end}"))
        else:
            assumed.append(language.parse(part))
    return assumed, ranges, functions


def solved(tree, names):
    """The name that an equation of the setting gives a value, with that."""
    match tree:
        case ("cmp", ("name", name), ("==", side)) if name in names and name not in names_of(side):
            return name, side
    return None


def points(assumed, ranges, names, functions, stream):
    equations = [found for tree in assumed if (found := solved(tree, names))]
    free = sorted(names - {name for name, _ in equations} - functions)
    grid = itertools.product(*[ranges.get(name, SIMPLE[:7]) for name in free]) if len(free) <= 3 else []
    wide = lambda: Fraction(stream.randint(-900, 900), stream.choice([7, 31, 97, 300, 1000]))
    drawn = ([stream.choice(ranges[name]) if name in ranges else stream.choice([wide(), stream.choice(SIMPLE)])
              for name in free] for _ in range(DRAWN))
    for values in itertools.chain(grid, drawn):
        point = Point({name: mpmath.mpf(q.numerator) / q.denominator for name, q in zip(free, values)})
        for name in functions:
            a, b = stream.randint(-2, 3), stream.randint(1, 3)
            point[name] = lambda x, a=a, b=b: b + a * x + x ** 2 / 3
        try:
            for name, side in equations:
                point[name] = value(side, point)
        except Undefined:
            continue
        if all(said(tree, point, []) for tree in assumed):
            yield point


def complaint(line):
    truth_said, statement, setting = [part.strip() for part in line.split("|")]
    tree = language.parse(statement)
    assumed, ranges, functions = settings(setting)
    names = set().union(names_of(tree), *map(names_of, assumed))
    domain = list(points(assumed, ranges, names, functions, random.Random(1)))
    found = {said(tree, point, domain) for point in domain[:DRAWN + 300]}
    fine = {"true": True in found and False not in found, "false": False in found, "silent": found <= {None}}[truth_said]
    return None if fine else f"{line.strip()}: {found} at {len(domain)} points"


def main():
    counts, wrong = {}, []
    for path in sys.argv[1:]:
        with open(path, encoding="utf-8") as file:
            lines = [line for line in file if line.strip() and not line.startswith("#")]
        for line in lines:
            kind = line.split("|")[0].strip()
            counts[kind] = counts.get(kind, 0) + 1
            if found := complaint(line):
                wrong.append(found)
    print(json.dumps(counts))
    print("\n".join(wrong))
    return len(wrong)


if __name__ == "__main__":
    sys.exit(main() > 0)
