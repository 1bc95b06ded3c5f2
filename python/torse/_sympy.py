"""Expressions of SymPy as texts in the notation of torse. SymPy is imported only where an expression of it comes in.

>>> import sympy
>>> x = sympy.Symbol("x", positive=True)
>>> term(sympy.sqrt(x) / 2)[0]
'(sqrt(x))/(2)'
>>> setting("", {"x": x})
'x > 0'
"""

import re
import sys

# Names of the notation: a symbol that is called so would be read as something else.
RESERVED = {
    "pi", "inf", "and", "or", "not", "in", "exists", "forall", "D", "at", "sum", "product", "integral", "binom",
    "factorial", "sin", "cos", "tan", "exp", "sinh", "cosh", "tanh", "sqrt", "abs", "dot", "cross", "det", "transpose",
    "inverse", "solve", "norm", "agrees", "fails", "coefficients", "identity", "nonnegative", "independent",
    "variation_diminishing",
}


def _is_sympy(value):
    sympy = sys.modules.get("sympy")
    return sympy is not None and isinstance(value, sympy.Basic)


def term(value):
    """A term as a text, with its symbols of SymPy by name."""
    if isinstance(value, str):
        return value, {}
    if isinstance(value, int) and not isinstance(value, bool):
        return str(value), {}
    if not _is_sympy(value):
        raise TypeError(f"a text or an expression of SymPy is wanted, not {type(value).__name__}")
    return _printed(value), _assumed(value)


def statement(value):
    """A statement as a text, with its symbols of SymPy by name."""
    if isinstance(value, str):
        return value, {}
    if _is_sympy(value) and (getattr(value, "is_Relational", False) or getattr(value, "is_Boolean", False)):
        return _printed(value), _assumed(value)
    # `Eq(a, a)` is already `true` for SymPy: that is what SymPy believes, and nothing is left to be decided.
    raise TypeError("a text or a relation of SymPy is wanted; `torse.equal` takes two terms")


def setting(where, *assumptions):
    """The setting as a text. What SymPy assumes of a symbol comes first, unless the same name is declared here."""
    given = [where] if isinstance(where, str) or _is_sympy(where) else list(where)
    texts, assumptions = [], list(assumptions)
    for entry in given:
        if isinstance(entry, str):
            texts.extend(part.strip() for part in entry.split(";") if part.strip())
        else:
            text, more = statement(entry)
            texts.append(text)
            assumptions.append(more)
    symbols = {}
    for symbol in (symbol for more in assumptions for symbol in more.values()):
        if symbols.setdefault(symbol.name, symbol) != symbol:
            raise ValueError(f"two symbols are called {symbol.name}, and assume different things")
    declared = {name.strip() for text in texts for name in _declared(text)}
    own = []
    for name, symbol in sorted(symbols.items()):
        if name not in declared:
            own.extend(_assumption(symbol))
    return "; ".join(own + texts)


def _declared(entry):
    """The names that an entry of a setting declares."""
    if ":=" in entry:
        return []
    for sign in (" in ", ":"):
        if sign in entry:
            return entry.split(sign)[0].split(",")
    return []


def _assumed(expression):
    """The symbols that are free, by name."""
    found = {}
    for symbol in expression.free_symbols:
        if found.setdefault(symbol.name, symbol) != symbol:
            raise ValueError(f"two symbols are called {symbol.name}, and assume different things")
    return found


def _assumption(symbol):
    """What a symbol assumes, as entries of a setting.

    All of it is said, or an error raised: a point at which a statement fails, and that the symbol excludes, would be no
    counterexample.
    """
    name = symbol.name
    if symbol.is_real is False:
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


def _printed(expression):
    from sympy import E, Rational, S, Symbol, pi
    from sympy.printing.str import StrPrinter

    names = {
        "sin": "sin", "cos": "cos", "tan": "tan", "exp": "exp", "sinh": "sinh", "cosh": "cosh", "tanh": "tanh",
        "Abs": "abs", "binomial": "binom", "factorial": "factorial",
    }
    signs = {"==": "==", "!=": "!=", "<": "<", "<=": "<=", ">": ">", ">=": ">="}

    class Printer(StrPrinter):
        def _print(self, part, **options):
            # Matrices and operators: torse would read numbers, which commute.
            if getattr(part, "is_commutative", True) is False or getattr(part, "is_Matrix", False):
                raise ValueError(f"{part} is no number")
            # Other constants, infinity among them, have names that would be read as those of variables.
            known = isinstance(part, (Symbol, Rational)) or part is pi or part is E
            if getattr(part, "is_Atom", False) and not known:
                raise ValueError(f"torse has no notation for {part}")
            return super()._print(part, **options)

        def _print_Symbol(self, symbol):
            if not re.fullmatch(r"[^\W\d_]\w*", symbol.name) or symbol.name in RESERVED:
                raise ValueError(f"`{symbol.name}` cannot be the name of a variable")
            return symbol.name

        def _bracketed(self, part):
            text = self._print(part)
            return text if part.is_Symbol or (part.is_Integer and part >= 0) else f"({text})"

        def _print_Pow(self, power, rational=False):
            base, exponent = power.base, power.exp
            if base is E or base == E:
                return f"exp({self._print(exponent)})"
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
            name = type(call).__name__
            if name not in names:
                raise ValueError(f"torse has no function `{name}`")
            return f"{names[name]}({', '.join(self._print(part) for part in call.args)})"

        _print_Abs = _print_Function

        def _print_cot(self, call):
            inner = self._print(call.args[0])
            return f"(cos({inner})/sin({inner}))"

        def _print_Sum(self, total):
            return self._folded("sum", total)

        def _print_Product(self, total):
            return self._folded("product", total)

        def _folded(self, name, total):
            text = self._print(total.function)
            for index, low, high in total.limits:
                text = f"{name}({self._print(index)}, {self._print(low)}, {self._print(high)}, {text})"
            return text

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

    return Printer().doprint(expression)
