"""Judges what a claim is about: declarations of paper, file, claim and reading, merged a second time from the TOML.

    python3 tests/judges/declarations.py derivations < lines    each line is a claim in the effective form of the crate

Written from the rules of derivations/README.md: what stands further in hides what stands further out, be it a symbol, a
function or a definition; within one place definitions come after symbols. `cargo test -p torse-tests --test judges` runs it.
"""

import json
import sys
import tomllib
from fractions import Fraction
from pathlib import Path

from language import NotInTheLanguage, dump, names, parse


def affine(tree):
    """An index form: its constant and its multiples of names."""
    match tree:
        case ("num", value, None):
            return [int(value), {}]
        case ("name", name):
            return [0, {name: 1}]
        case ("neg", a):
            return affine(("-", ("num", Fraction(0), None), a))
        case ("+" | "-" as sign, a, b):
            (c, m), (d, n) = affine(a), affine(b)
            s = 1 if sign == "+" else -1
            sums = {k: m.get(k, 0) + s * n.get(k, 0) for k in {*m, *n}}
            return [c + s * d, {k: v for k, v in sorted(sums.items()) if v}]
        case ("*", a, b):
            (c, m), (d, n) = affine(a), affine(b)
            if m:
                (c, m), (d, n) = (d, n), (c, m)
            assert not m
            return [c * d, {k: c * v for k, v in sorted(n.items()) if c}]
    raise ValueError(tree)


def constant(tree):
    """A number a + b*pi, or nothing."""
    match tree:
        case ("num", value, _):
            return value, Fraction(0)
        case ("name", "pi"):
            return Fraction(0), Fraction(1)
        case ("neg", a):
            a = constant(a)
            return a and (-a[0], -a[1])
        case ("+" | "-" as sign, a, b):
            a, b, s = constant(a), constant(b), 1 if sign == "+" else -1
            return a and b and (a[0] + s * b[0], a[1] + s * b[1])
        case ("*", a, b):
            a, b = constant(a), constant(b)
            if a and b and a[1]:
                a, b = b, a
            return a and b and not a[1] and (a[0] * b[0], a[0] * b[1])
        case ("/", a, b):
            a, b = constant(a), constant(b)
            return a and b and not b[1] and b[0] and (a[0] / b[0], a[1] / b[0])
    return None


def end(text, closed):
    if text.strip() in ("inf", "-inf"):
        return None
    tree = parse(text)
    value = constant(tree)
    return [closed, [str(q) for q in value] if value else dump(tree)]


def integers(text):
    if ".." in text:
        return [affine(parse(part)) for part in text.split("..")]
    return [affine(parse(text.strip().removeprefix(">="))), None] if text.strip() else [None, None]


def symbol(entry):
    dimension = lambda d: None if d == "any" else d
    if "integer" in entry:
        return {"integer": integers(entry["integer"])}
    if "vector" in entry:
        return {"vector": dimension(entry["vector"])}
    if "family" in entry:
        return {"family": dimension(entry["family"]), "indices": [integers(t) for t in entry.get("indices", [])]}
    if "in" not in entry:
        return {"real": [None, None]}
    text = entry["in"].strip()
    low, high = text[1:-1].split(",", 1)
    return {"real": [end(low, text[0] == "["), end(high, text[-1] == "]")]}


def basis(entry):
    counters = [entry["index"], entry["order"]] if "index" in entry else None
    return {"variable": entry["variable"], "parameters": entry.get("parameters", []), "degree": entry["degree"],
            "seeds": [dump(parse(t)) for t in entry["seeds"]], "step": [dump(parse(t)) for t in entry.get("step", [])],
            "counters": counters}


def origin(entry, claim, within="in"):
    if "printed" in entry:
        return ["printed", entry["printed"], entry.get(within, claim)]
    return ["ours", entry["ours"]] if "ours" in entry else None


class Names:
    """What the names mean, from the outside inwards."""

    def __init__(self, outer=None):
        self.symbols, self.functions, self.definitions, self.bases, self.ranges, self.trees = (
            dict(part) for part in (outer.parts() if outer else [{}] * 6))

    def parts(self):
        return self.symbols, self.functions, self.definitions, self.bases, self.ranges, self.trees

    def forget(self, name):
        outer = self.symbols.get(name)
        for part in (self.symbols, self.functions, self.definitions, self.ranges):
            part.pop(name, None)
        return outer

    def add(self, symbols, bases, definitions, claim=None):
        for name, entry in symbols.items():
            outer = self.forget(name)
            if "function" in entry:
                self.functions[name] = entry["function"]
                continue
            self.symbols[name] = symbol(entry)
            ends = [e[1] for e in self.symbols[name].get("real", []) if e and isinstance(e[1], str)]
            texts = entry["in"].strip()[1:-1].split(",", 1) if ends else []
            self.trees["ends", name] = [t for t in map(parse, (t for t in texts if "inf" not in t)) if not constant(t)]
            if said := origin(entry, claim, "printed_in"):
                self.ranges[name] = {"from": said, "outer": outer}
        for name, entry in bases.items():
            self.bases[name] = basis(entry)
            self.trees["basis", name] = [parse(t) for t in entry["seeds"] + entry.get("step", [])]
        for head, body in definitions.items():
            tree = parse(head)
            kind, name, *parameters = tree if tree[0] in ("call", "index") else (None, tree)
            self.forget(name[1])
            self.trees[name[1]] = parse(body)
            self.definitions[name[1]] = {"parameters": [p[1] for p in parameters], "indexed": kind == "index",
                                         "body": dump(parse(body))}
        return self


class Reach:
    """Which declared symbols a claim is about: those that are free in its formulas, through definitions and bases."""

    def __init__(self, own):
        self.own = own

    def look(self, name, local, moved):
        own, stem = self.own, name.rstrip("'")
        if name in local or name in moved:
            return set()
        for text in (name, stem):
            if text in own.definitions:
                parameters, body = own.definitions[text]["parameters"], own.trees[text]
                return self.free(body, frozenset(parameters), moved)
            if text in own.symbols:
                return {text}
        return set()

    def family(self, name, given, moved):
        entry, trees = self.own.bases[name], self.own.trees["basis", name]
        variables = [entry["variable"], *entry["parameters"]]
        local = frozenset(variables + (entry["counters"] or []))
        found = set().union(*(self.free(tree, local, moved) for tree in trees))
        return found.union(*(self.look(v, frozenset(), moved) for v in variables[given:]))

    def free(self, tree, local, moved):
        def part(inner):
            return self.free(inner, local, moved)

        def under(name, inner):
            return part(inner) if name in local else self.free(inner, local, moved | {name})

        match tree:
            case ("num", *_):
                return set()
            case ("name", name):
                return self.look(name, local, moved)
            case ("cmp", first, *rest):
                return part(first).union(*(part(side) for _, side in rest))
            case ("call", ("name", "sum" | "product"), ("name", index), low, high, body):
                return part(low) | part(high) | self.free(body, local | {index}, moved)
            case ("call", ("name", "integral"), body, ("name", by), low, high):
                return under(by, body) | part(low) | part(high)
            case ("call", ("name", "at"), body, ("name", by), put):
                return under(by, body) | part(put)
            case ("call", ("name", "D"), body, *rest) if not self.is_function(body):
                by = rest[0][1]
                return under(by, body) | self.look(by, local, moved) | set().union(*map(part, rest[1:]))
            case ("call", ("call", ("name", "D"), function, *rest), *arguments):
                return part(function).union(*map(part, [*rest[1:], *arguments]))
            case ("call", ("name", "nonnegative" | "independent" | "variation_diminishing"), ("name", name), *_):
                # About all values of the variables in their declared sets.
                return self.family(name, 0, moved)
            case ("call", ("index", ("name", name), *indices), *arguments) if name in self.own.bases:
                return self.family(name, len(arguments), moved).union(*map(part, indices + arguments))
            case ("index", ("name", name), *indices) if name in self.own.bases:
                return self.family(name, 0, moved).union(*map(part, indices))
            case (_, *parts):
                return set().union(*map(part, parts))

    def is_function(self, tree):
        own, name = self.own, tree[1]
        return tree[0] == "name" and (name in own.functions or own.definitions.get(name, {}).get("parameters"))

    def closed(self, names):
        """With the symbols in whose terms sets and index ranges are declared, and how many ends are formulas."""
        found, pending, ends = set(), set(names), 0
        while pending:
            name = pending.pop()
            found.add(name)
            kind = self.own.symbols[name]
            forms = [f for f in kind.get("integer", []) if f] + [f for pair in kind.get("indices", []) for f in pair]
            for _, multiples in forms:
                pending |= set(multiples) - found
            for tree in self.own.trees.get(("ends", name), []):
                ends += 1
                pending |= self.free(tree, frozenset(), frozenset()) - found
        return sorted(found), ends


def hypotheses(entries, claim):
    tables = [{"states": e} if isinstance(e, str) else e for e in entries]
    return [[dump(parse(t["states"])), origin(t, claim)] for t in tables]


def sought(text):
    match parse(text):
        case ("name", name):
            return [name, None]
        case ("cmp", ("name", name), ("==", value)):
            return [name, dump(value)]


def effective(shared, entry, reading):
    """The claim, or one of its readings, with everything that it inherits."""
    more = reading or {}
    merged = {key: {**entry.get(key, {}), **more.get(key, {})} for key in ("symbols", "let")}
    listed = {key: entry.get(key, []) + more.get(key, []) for key in ("given", "assume", "solve_for")}
    states = more.get("states", entry.get("states"))
    own = Names(shared).add(merged["symbols"], {}, merged["let"], entry["id"])
    reach, domain = Reach(own), None
    if states:
        texts = [e if isinstance(e, str) else e["states"] for e in listed["given"] + listed["assume"]]
        trees = [parse(t) for t in [states, *texts, *listed["solve_for"]]]
        names = set().union(*(reach.free(tree, frozenset(), frozenset()) for tree in trees))
        # A number that is sought is the formula that it is said to be.
        for tree in map(parse, entry.get("exists", [])):
            names -= {tree[1]} if tree[0] == "name" else {tree[1][1]}
            names |= reach.free(tree[2][1], frozenset(), frozenset()) if tree[0] == "cmp" else set()
        symbols, ends = reach.closed(names)
        domain = {"symbols": symbols, "hypotheses": len(texts) + ends, "ends": ends}
    return {"domain": domain, "id": entry["id"], "reading": reading and reading["name"],
            "symbols": own.symbols, "ranges": own.ranges, "bases": own.bases, "definitions": own.definitions,
            "given": hypotheses(listed["given"], entry["id"]), "assume": hypotheses(listed["assume"], entry["id"]),
            "solve_for": [dump(parse(t)) for t in listed["solve_for"]],
            "exists": [sought(t) for t in entry.get("exists", [])],
            "states": states and dump(parse(states))}


def of_folder(folder):
    for head in sorted(Path(folder).glob("*/paper.toml")):
        paper = tomllib.loads(head.read_text(encoding="utf-8"))
        sections = lambda file: [file.get(key, {}) for key in ("symbols", "basis", "define")]
        shared = Names().add(*sections(paper))
        for name in paper["paper"]["claims"]:
            file = tomllib.loads((head.parent / name).read_text(encoding="utf-8"))
            own = Names(shared).add(*sections(file))
            for entry in file.get("claim", []):
                for reading in entry.get("readings", [None]):
                    yield effective(own, entry, reading)


def main(folder):
    ours = {(claim["id"], claim["reading"]): claim for claim in map(json.loads, sys.stdin)}
    second = {(claim["id"], claim["reading"]): claim for claim in of_folder(folder)}
    wrong = [f"{key}: only one has it" for key in ours.keys() ^ second.keys()]
    for key in ours.keys() & second.keys():
        for field, value in second[key].items():
            # Without a witness there is no claim about points yet.
            sought = field == "domain" and any(witness is None for _, witness in second[key]["exists"])
            if ours[key][field] != value and not sought:
                wrong.append(f"{key} {field}\n  ours   {ours[key][field]}\n  second {value}")
    print(json.dumps({"claims": len(second)}))
    print("\n".join(sorted(wrong)[:10]))
    return len(wrong)


if __name__ == "__main__":
    sys.exit(main(sys.argv[1]) > 0)
