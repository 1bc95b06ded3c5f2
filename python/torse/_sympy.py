"""Expressions of SymPy as texts in the notation of torse. SymPy is imported only where an expression of it comes in.

>>> import sympy
>>> x = sympy.Symbol("x", positive=True)
>>> read = term(sympy.sqrt(x) / 2)
>>> read.text
'(sqrt(x))/(2)'
>>> Setting("", read).text
'x > 0'
>>> expression("Eq(x**2, Rational(1, 4))", read.symbols)
Eq(x**2, 1/4)
"""

import sys
from fractions import Fraction

# Names of the notation: a symbol that is called so would be read as something else.
RESERVED = {
    "pi", "inf", "and", "or", "not", "implies", "in", "exists", "forall", "D", "at", "sum", "product", "integral", "binom",
    "factorial", "sin", "cos", "tan", "exp", "log", "atan", "asin", "acos", "sinh", "cosh", "tanh", "sqrt", "abs", "min", "max", "dot", "cross", "det",
    "transpose", "inverse", "solve", "norm", "agrees", "fails", "coefficients", "identity", "nonnegative", "independent",
    "variation_diminishing",
}


class Read:
    """A formula as a text, and what must be true for its answer to be one about what SymPy means."""

    def __init__(self, text):
        self.text = text
        # The free symbols of SymPy, by name.
        self.symbols = {}
        # Where torse and SymPy agree: pairs of a setting and a statement. Sums and products: at least empty.
        self.ranges = []
        # Roots: of what is not negative, or SymPy goes on with complex numbers.
        self.roots = []
        # The symbols for which an equation on the reals says nothing about complex numbers.
        self.strict = set()

    def add(self, symbol):
        if self.symbols.setdefault(symbol.name, symbol) != symbol:
            raise ValueError(f"two symbols are called {symbol.name}, and assume different things")


def _is_sympy(value):
    sympy = sys.modules.get("sympy")
    return sympy is not None and isinstance(value, sympy.Basic)


def term(value):
    """A term as it is read."""
    if isinstance(value, str):
        return Read(value)
    if isinstance(value, int) and not isinstance(value, bool):
        return Read(str(int(value)))
    if isinstance(value, Fraction):
        return Read(f"{value.numerator}/{value.denominator}")
    if not _is_sympy(value):
        raise TypeError(f"a text or an expression of SymPy is wanted, not {type(value).__name__}")
    return _read(value)


def statement(value):
    """A statement as it is read."""
    if isinstance(value, str):
        return Read(value)
    if _is_sympy(value) and (getattr(value, "is_Relational", False) or getattr(value, "is_Boolean", False)):
        return _read(value)
    # `Eq(a, a)` is already `true` for SymPy: that is what SymPy believes, and nothing is left to be decided.
    raise TypeError("a text or a relation of SymPy is wanted; `torse.equal` takes two terms")


class Setting:
    """The setting of statements that were read. What SymPy assumes of a symbol comes first, unless its name is declared here."""

    def __init__(self, where, *read):
        given = [where] if isinstance(where, str) or _is_sympy(where) else list(where)
        hypotheses = []
        typed = []
        for entry in given:
            if isinstance(entry, str):
                typed.extend(part.strip() for part in entry.split(";") if part.strip())
            else:
                hypotheses.append((entry, statement(entry)))
        self.read = [*read, *(own for _, own in hypotheses)]
        every = Read("")
        for own in self.read:
            for symbol in own.symbols.values():
                every.add(symbol)
        self.symbols = every.symbols
        texts = typed + [own.text for _, own in hypotheses]
        declared = {name.strip() for text in texts for name in _declared(text)}
        own = []
        for name, symbol in sorted(self.symbols.items()):
            if name not in declared:
                own.extend(_assumption(symbol))
        self.text = "; ".join(own + texts)
        # Who speaks of a name in the notation of torse speaks of a real number, and so does an order relation of it alone.
        real = {name for text in typed for name in _names(text)}
        for entry, _ in hypotheses:
            if getattr(entry, "rel_op", "==") not in ("==", "!="):
                real.update(side.name for side in (entry.lhs, entry.rhs) if side.is_Symbol)
        strict = set().union(*(own.strict for own in read), *(own.symbols for _, own in hypotheses))
        self.complex = sorted(name for name in strict - real if not _is_real(self.symbols[name]))

    def check(self, is_true, holds):
        """Refuses an answer that is one about real numbers, and not about what SymPy means."""
        if is_true is None:
            return
        for text, condition in (pair for own in self.read for pair in own.ranges):
            if not holds(condition, "; ".join(part for part in (self.text, text) if part)):
                raise ValueError(
                    f"SymPy continues a sum or product backwards where it has less than no terms; state that {condition} by where=..."
                )
        if not is_true:
            return
        for text, condition in (pair for own in self.read for pair in own.roots):
            if not holds(condition, "; ".join(part for part in (self.text, text) if part)):
                raise ValueError(
                    f"it is true wherever its roots are real; for SymPy they may be complex: state that {condition} by where=..."
                )
        if self.complex:
            name = self.complex[0]
            raise ValueError(
                f"it is true for real numbers; for SymPy {name} may be complex: Symbol({name!r}, real=True), or "
                f"where='{name} in (-inf, inf)'"
            )


def _is_real(symbol):
    return symbol.is_real is True


def _names(text):
    """All that could be a name in a text."""
    return "".join(letter if letter.isalnum() or letter == "_" else " " for letter in text).split()


def _declared(entry):
    """The names that an entry of a setting declares."""
    if ":=" in entry:
        return []
    for sign in (" in ", ":"):
        if sign in entry:
            return entry.split(sign)[0].split(",")
    return []


def _assumption(symbol):
    """What a symbol assumes, as entries of a setting.

    All of it is said, or an error raised: a point at which a statement fails, and that the symbol excludes, would be no
    counterexample.
    """
    name = symbol.name
    if symbol.is_real is False or (symbol.is_extended_real and not symbol.is_real):
        raise ValueError(f"{name} is no real number")
    if symbol.is_integer and not symbol.is_nonnegative:
        raise ValueError(f"the range of the integer {name} is wanted: where='{name} in 0..'")
    for facts, entries in _SAID:
        if all(symbol.assumptions0.get(fact) for fact in facts):
            said = type(symbol)(name, real=True, **dict.fromkeys(facts, True)).assumptions0
            more = sorted((not value, f) for f, value in symbol.assumptions0.items() if said.get(f) != value)
            if more:
                more = [fact if not denied else f"not {fact}" for denied, fact in more]
                raise ValueError(f"of {name} SymPy assumes what is not said here ({', '.join(more)}): declare it by where='{name} in ...'")
            return [entry.format(name) for entry in entries]
    return []


# What SymPy assumes of a symbol and the entries that say it; the first that fits has all of it.
_SAID = [
    (("integer", "positive"), ["{} in 1.."]),
    (("integer", "nonnegative"), ["{} in 0.."]),
    (("positive",), ["{} > 0"]),
    (("negative",), ["{} < 0"]),
    (("nonnegative",), ["{} >= 0"]),
    (("nonpositive",), ["{} <= 0"]),
    (("nonzero",), ["{} != 0"]),
    ((), []),
]


def _needs_reals(part):
    """The free symbols in which an equation of reals is not one of meromorphic functions, whose values on the reals have them all."""
    import sympy

    free = set(part.free_symbols)
    whole = (sympy.sin, sympy.cos, sympy.tan, sympy.cot, sympy.exp, sympy.sinh, sympy.cosh, sympy.tanh)
    if part.is_Atom:
        return set()
    if isinstance(part, (sympy.Eq, sympy.And, sympy.Add, sympy.Mul, *whole)):
        return set().union(*map(_needs_reals, part.args))
    if part.is_Pow and part.base is sympy.E:
        return _needs_reals(part.exp)
    if part.is_Pow and part.exp.is_integer:
        return _needs_reals(part.base) | part.exp.free_symbols
    if isinstance(part, (sympy.Sum, sympy.Product)):
        ends = set().union(*(end.free_symbols for limit in part.limits for end in limit[1:]))
        return (_needs_reals(part.function) | ends) & free
    return free


def _read(expression):
    import sympy
    from sympy import Dummy, E, Rational, S, Symbol, pi
    from sympy.printing.str import StrPrinter

    # By their classes: a function that somebody calls `sin` is none of these.
    names = {
        sympy.sin: "sin", sympy.cos: "cos", sympy.tan: "tan", sympy.exp: "exp", sympy.sinh: "sinh", sympy.cosh: "cosh",
        sympy.atan: "atan", sympy.asin: "asin", sympy.acos: "acos", sympy.tanh: "tanh", sympy.Abs: "abs", sympy.binomial: "binom", sympy.factorial: "factorial",
        sympy.Min: "min", sympy.Max: "max",
    }
    signs = {"==": "==", "!=": "!=", "<": "<", "<=": "<=", ">": ">", ">=": ">="}
    read = Read("")
    around = []

    class Printer(StrPrinter):
        def _print(self, part, **options):
            # Matrices and operators: torse would read numbers, which commute.
            if getattr(part, "is_commutative", True) is False or getattr(part, "is_Matrix", False):
                raise ValueError(f"{part} is no number")
            # Other constants, infinity among them, have names that would be read as those of variables.
            known = type(part) in (Symbol, Dummy) or isinstance(part, Rational) or part is pi or part is E
            if getattr(part, "is_Atom", False) and not known:
                raise ValueError(f"torse has no notation for {part}")
            return super()._print(part, **options)

        def _print_Symbol(self, symbol):
            name = symbol.name
            letters = all(c.isalpha() or c in "_0123456789" for c in name)
            if not (name[:1].isalpha() and letters) or name in RESERVED:
                raise ValueError(f"`{name}` cannot be the name of a variable")
            return name

        _print_Dummy = _print_Symbol

        def _bracketed(self, part):
            text = self._print(part)
            return text if part.is_Symbol or (part.is_Integer and part >= 0) else f"({text})"

        def _print_Pow(self, power, rational=False):
            base, exponent = power.base, power.exp
            if base is E or base == E:
                return f"exp({self._print(exponent)})"
            if not exponent.is_integer and not base.is_nonnegative:
                read.roots.append(("; ".join(around), f"{self._print(base)} >= 0"))
            if exponent == S.Half:
                return f"sqrt({self._print(base)})"
            if exponent == -S.Half:
                return f"1/sqrt({self._print(base)})"
            return f"{self._bracketed(base)}^{self._bracketed(exponent)}"

        def _print_Mul(self, product):
            over, under = product.as_numer_denom()
            if under != 1:
                return f"({self._print(over)})/({self._print(under)})"
            factors = product.as_ordered_factors()
            return "*".join(f"({self._print(factor)})" if factor.is_Add or factor.could_extract_minus_sign() or factor.is_Mul else self._print(factor) for factor in factors)

        def _print_Exp1(self, _):
            return "exp(1)"

        def _print_Function(self, call):
            name = names.get(type(call))
            if name is None:
                raise ValueError(f"torse has no function `{type(call).__name__}`")
            return f"{name}({', '.join(self._print(part) for part in call.args)})"

        _print_Abs = _print_Function

        def _print_Max(self, call):
            name, (*others, last) = names[type(call)], [self._print(part) for part in call.args]
            for other in reversed(others):
                last = f"{name}({other}, {last})"
            return last

        _print_Min = _print_Max

        def _print_cot(self, call):
            inner = self._print(call.args[0])
            return f"(cos({inner})/sin({inner}))"

        def _print_Sum(self, total):
            return self._folded("sum", total)

        def _print_Product(self, total):
            return self._folded("product", total)

        def _folded(self, name, total):
            # The last limits are the outermost.
            index, low, high = map(self._print, total.limits[-1])
            read.ranges.append(("; ".join(around), f"({high}) - ({low}) + 1 >= 0"))
            around.append(f"{index} in {low}..{high}")
            inner = total.limits[:-1]
            text = self._print(total.func(total.function, *inner) if inner else total.function)
            around.pop()
            return f"{name}({index}, {low}, {high}, {text})"

        def _print_Integral(self, integral):
            text = self._print(integral.function)
            for limit in integral.limits:
                if len(limit) != 3:
                    raise ValueError("an integral needs both ends")
                variable, low, high = map(self._print, limit)
                text = f"integral({text}, {variable}, {low}, {high})"
            return text

        def _print_Relational(self, relation):
            sign = signs.get(relation.rel_op)
            if sign is None:
                raise ValueError(f"torse has no relation `{relation.rel_op}`")
            return f"{self._print(relation.lhs)} {sign} {self._print(relation.rhs)}"

        def _print_And(self, conjunction):
            return " and ".join(f"({self._print(part)})" for part in conjunction.args)

        def emptyPrinter(self, expression):
            raise ValueError(f"torse has no notation for {type(expression).__name__}")

    read.text = Printer().doprint(expression)
    for symbol in expression.free_symbols:
        read.add(symbol)
    read.strict = {symbol.name for symbol in _needs_reals(expression)}
    return read


def expression(code, symbols):
    """An expression of SymPy from the code that torse writes; names that are not among the symbols are real numbers."""
    import sympy

    def unevaluated(relation):
        return lambda left, right: relation(sympy.sympify(left), sympy.sympify(right), evaluate=False)

    class Names(dict):
        def __missing__(self, name):
            return sympy.Symbol(name, real=True)

    functions = (
        "sin cos tan exp sinh cosh tanh sqrt binomial factorial Abs Min Max Sum Product Integral Matrix diff Rational sympify pi "
        "And Or Not Implies"
    )
    names = {name: getattr(sympy, name) for name in functions.split()}
    relations = {name: unevaluated(getattr(sympy, name)) for name in ("Eq", "Ne", "Lt", "Le", "Gt", "Ge")}
    try:
        return sympy.sympify(eval(code, {"__builtins__": {}}, Names({**symbols, **names, **relations})))
    except (AttributeError, TypeError) as error:
        raise ValueError(f"SymPy has no expression for {code}: {error}") from error
