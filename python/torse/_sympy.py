"""Expressions of SymPy as texts in the notation of torse. SymPy is imported only where an expression of it comes in."""


def _is_sympy(value):
    return type(value).__module__.partition(".")[0] == "sympy"


def term(value):
    """A term as a text, with what the symbols of SymPy assume."""
    if isinstance(value, str):
        return value, {}
    if isinstance(value, int) and not isinstance(value, bool):
        return str(value), {}
    if not _is_sympy(value):
        raise TypeError(f"a text or an expression of SymPy is wanted, not {type(value).__name__}")
    return _printed(value), _assumed(value)


def statement(value):
    """A statement as a text, with what the symbols of SymPy assume."""
    if isinstance(value, str):
        return value, {}
    if _is_sympy(value) and (getattr(value, "is_Relational", False) or getattr(value, "is_Boolean", False)):
        return _printed(value), _assumed(value)
    # `Eq(a, a)` is already `true` for SymPy: that is what SymPy believes, and nothing is left to be decided.
    raise TypeError("a text or a relation of SymPy is wanted; `torse.equal` takes two terms")


def setting(where, assumed):
    """The setting as a text. What SymPy assumes of a symbol comes first, so that what is said here counts."""
    given = [where] if isinstance(where, str) or _is_sympy(where) else list(where)
    texts = []
    for entry in given:
        if isinstance(entry, str):
            texts.append(entry)
        else:
            text, more = statement(entry)
            texts.append(text)
            assumed = {**more, **assumed}
    said = ";".join(texts)
    declared = {
        name.strip()
        for entry in said.split(";")
        for sign in (" in ", ":")
        if sign in entry and ":=" not in entry
        for name in entry.split(sign)[0].split(",")
    }
    own = [entry for name, entries in sorted(assumed.items()) for entry in entries if name not in declared]
    return "; ".join(own + [text for text in texts if text.strip()])


def _assumed(expression):
    """What the symbols assume: name to entries of a setting."""
    found = {}
    for symbol in sorted(expression.free_symbols, key=str):
        entries = []
        if symbol.is_integer:
            if symbol.is_positive:
                entries.append(f"{symbol.name} in 1..")
            elif symbol.is_nonnegative:
                entries.append(f"{symbol.name} in 0..")
            else:
                entries.append(f"{symbol.name} in ..")
        elif symbol.is_positive:
            entries.append(f"{symbol.name} > 0")
        elif symbol.is_negative:
            entries.append(f"{symbol.name} < 0")
        elif symbol.is_nonnegative:
            entries.append(f"{symbol.name} >= 0")
        elif symbol.is_nonpositive:
            entries.append(f"{symbol.name} <= 0")
        elif symbol.is_nonzero:
            entries.append(f"{symbol.name} != 0")
        if symbol.is_real is False:
            raise ValueError(f"{symbol.name} is no real number")
        found[symbol.name] = entries
    return found


def _printed(expression):
    from sympy import E, S
    from sympy.printing.str import StrPrinter

    names = {
        "sin": "sin", "cos": "cos", "tan": "tan", "exp": "exp", "sinh": "sinh", "cosh": "cosh", "tanh": "tanh",
        "Abs": "abs", "binomial": "binom", "factorial": "factorial",
    }
    signs = {"==": "==", "!=": "!=", "<": "<", "<=": "<=", ">": ">", ">=": ">="}

    class Printer(StrPrinter):
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

        def _print_Float(self, number):
            raise ValueError(f"{number} is no exact number: write it as a fraction")

        def _print_ImaginaryUnit(self, _):
            raise ValueError("there are real numbers only")

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
