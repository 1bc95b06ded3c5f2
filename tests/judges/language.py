"""A second reader of the formula language, which lets Python's own parser do the work.

Every token is renamed to one of Python: names and numbers by their place in a list, `^` to `**`, and `p implies q` to
`p if _ else q`, which binds as loosely and to the right. What `ast` makes of it is renamed back. So precedence, grouping
and chains are Python's, and nothing here repeats the grammar of the crate that is judged.

A tree is a tuple: ("num", value, decimals), ("name", text), ("call" | "index", head, ...), ("list", ...), ("neg" | "not", x),
("+" | "-" | "*" | "/" | "^" | "and" | "or" | "implies", a, b), ("cmp", first, (relation, side), ...).
"""

import ast
import warnings
from fractions import Fraction

warnings.simplefilter("ignore", SyntaxWarning)

SIGNS = ["==", "!=", "<=", ">=", "<", ">", "+", "-", "*", "/", "^", "(", ")", "[", "]", ","]
DIGITS = "0123456789"


class NotInTheLanguage(Exception):
    """The text is no formula."""


def tokens(text):
    """Pairs of kind and text: "number", "name" or "sign"."""
    found, at = [], 0
    while at < len(text):
        c = text[at]
        end = at + 1
        if c in " \t\r\n":
            at = end
            continue
        if c in DIGITS:
            while end < len(text) and text[end] in DIGITS:
                end += 1
            if text[end:end + 1] == "." and text[end + 1:end + 2] in list(DIGITS):
                end += 1
                while end < len(text) and text[end] in DIGITS:
                    end += 1
            kind = "number"
        elif c.isalpha() or c == "_":
            while end < len(text) and (text[end].isalpha() or text[end] == "_" or text[end] in DIGITS):
                end += 1
            while text[end:end + 1] == "'":
                end += 1
            kind = "name"
        else:
            sign = next((s for s in SIGNS if text.startswith(s, at)), None)
            if sign is None:
                raise NotInTheLanguage(f"the character {c!r}")
            end = at + len(sign)
            kind = "sign"
        found.append((kind, text[at:end]))
        at = end
    return found


def parse(text):
    """The tree of a formula."""
    names, numbers, words = [], [], []
    brackets = []
    before = None
    for kind, word in tokens(text):
        if kind == "number":
            numbers.append(word)
            words.append(str(len(numbers) - 1))
        elif kind == "name":
            if word == "implies":
                words.append("if _ else")
            elif word in ("and", "or", "not"):
                words.append(word)
            else:
                names.append(word)
                words.append(f"n{len(names) - 1}")
        else:
            # Python has tuples, empty lists and commas at the end; the language has none of them.
            if word == "(":
                calls = before is not None and (before[0] == "number" or before[1] in (")", "]") or before[0] == "name"
                                                and before[1] not in ("and", "or", "not", "implies"))
                brackets.append("call" if calls else "group")
            elif word == "[":
                brackets.append("list")
            elif word in (")", "]"):
                if not brackets or before[1] in ("(", "[", ","):
                    raise NotInTheLanguage("nothing in brackets")
                brackets.pop()
            elif word == ",":
                if not brackets or brackets[-1] == "group":
                    raise NotInTheLanguage("a comma outside of a list")
            words.append("**" if word == "^" else word)
        before = (kind, word)
    try:
        tree = ast.parse(" ".join(words), mode="eval").body
    except (SyntaxError, RecursionError, MemoryError) as error:
        raise NotInTheLanguage(str(error)) from error
    return renamed(tree, names, numbers)


BINARY = {ast.Add: "+", ast.Sub: "-", ast.Mult: "*", ast.Div: "/", ast.Pow: "^"}
RELATIONS = {ast.Eq: "==", ast.NotEq: "!=", ast.Lt: "<", ast.LtE: "<=", ast.Gt: ">", ast.GtE: ">="}


def renamed(tree, names, numbers):
    def back(part):
        return renamed(part, names, numbers)

    match tree:
        case ast.Name(id=text):
            return ("name", names[int(text[1:])])
        case ast.Constant(value=place):
            text = numbers[place]
            return ("num", Fraction(text), len(text.split(".")[1]) if "." in text else None)
        case ast.UnaryOp(op=ast.USub(), operand=inner):
            return ("neg", back(inner))
        case ast.UnaryOp(op=ast.Not(), operand=inner):
            return ("not", back(inner))
        case ast.BinOp(left=a, op=sign, right=b) if type(sign) in BINARY:
            return (BINARY[type(sign)], back(a), back(b))
        case ast.BoolOp(op=word, values=parts):
            whole, *rest = [back(part) for part in parts]
            for part in rest:
                whole = ("and" if isinstance(word, ast.And) else "or", whole, part)
            return whole
        case ast.IfExp(test=ast.Name(id="_"), body=premise, orelse=conclusion):
            return ("implies", back(premise), back(conclusion))
        case ast.Compare(left=first, ops=signs, comparators=sides):
            return ("cmp", back(first), *((RELATIONS[type(s)], back(e)) for s, e in zip(signs, sides)))
        case ast.Call(func=head, args=arguments, keywords=[]):
            head = back(head)
            if head[0] not in ("name", "call", "index"):
                raise NotInTheLanguage("what is called is no function")
            return ("call", head, *map(back, arguments))
        case ast.Subscript(value=head, slice=ast.Tuple(elts=indices)):
            return ("index", back(head), *map(back, indices))
        case ast.Subscript(value=head, slice=index):
            return ("index", back(head), back(index))
        case ast.List(elts=items):
            return ("list", *map(back, items))
    raise NotInTheLanguage(ast.dump(tree))


def dump(tree):
    """The tree with all its brackets."""
    match tree:
        case ("num", value, decimals):
            return str(value) + ("" if decimals is None else f"@{decimals}")
        case ("name", text):
            return text
        case ("cmp", first, *rest):
            return "(cmp " + " ".join([dump(first), *(f"{sign} {dump(side)}" for sign, side in rest)]) + ")"
        case (word, *parts):
            return "(" + " ".join([word, *map(dump, parts)]) + ")"


def names(tree):
    """Every name that occurs."""
    if tree[0] == "name":
        return {tree[1]}
    if tree[0] == "num":
        return set()
    if tree[0] == "cmp":
        return names(tree[1]).union(*(names(side) for _, side in tree[2:]))
    return set().union(*map(names, tree[1:]))
