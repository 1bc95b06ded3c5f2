"""A third judge: is a claim true at random points of its domain, and does the engine say the same?

    cargo run --release -p torse-tests --example composed -- 2000 1 write > target/composed.jsonl
    python3 tests/judges/third.py target/composed.jsonl [seconds]
    python3 tests/judges/third.py reports/verdicts.json [seconds]    the claims of derivations/ instead

Each line has a claim file and what the engine says of it. Points are drawn from the declared sets, degenerate ones among them;
equations are met by solving them for one of their symbols. A claim takes at most so many seconds of work (5), else it is counted as
timed out. Every disagreement is printed with its point.
"""

import collections
import json
import multiprocessing
import random
import signal
import sys
import tomllib
from pathlib import Path

import mpmath
import sympy

import declarations
from language import NotInTheLanguage, names as names_in, parse
from meaning import DRAWN, EQUAL, Names, Undefined, Unknown, exactly, truth, value

POINTS, TRIES = 12, 40
NICE = [sympy.Rational(*q) for q in [(0, 1), (1, 1), (-1, 1), (2, 1), (1, 2), (1, 4), (3, 2), (-1, 2)]]


class Scene:
    """The declarations of a claim file with one claim."""

    def __init__(self, file):
        (claim,) = file["claim"]
        self.symbols = file.get("symbols", {}) | claim.get("symbols", {})
        self.functions = {n: e["function"] for n, e in self.symbols.items() if "function" in e}
        self.families = {n: {"dimension": e["family"], "ranges": e["indices"], "places": len(e["indices"])}
                         for n, e in self.symbols.items() if "family" in e}
        self.definitions = {}
        for head, body in (file.get("define", {}) | claim.get("let", {})).items():
            tree = parse(head)
            parameters = [p[1] for p in tree[2:]] if tree[0] in ("call", "index") else []
            self.definitions[tree[1] if tree[0] == "name" else tree[1][1]] = parameters, parse(body)
        self.bases = {n: {"variables": [e["variable"], *e.get("parameters", [])], "seeds": [parse(s) for s in e["seeds"]],
                          "step": [parse(s) for s in e.get("step", [])],
                          "counters": [e["index"], e["order"]] if "index" in e else None}
                      for n, e in file.get("basis", {}).items()}
        entries = claim.get("assume", []) + claim.get("given", [])
        self.hypotheses = [parse(e if isinstance(e, str) else e["states"]) for e in entries]
        self.statement = parse(claim["states"])
        self.sought = claim.get("exists", [])

    def interval(self, name):
        """Its ends, if they are numbers."""
        entry = self.symbols.get(name, {})
        if "in" not in entry:
            raise Unknown("no interval")
        low, high = declarations.symbol(entry)["real"]
        return tuple(constant(e[1]) for e in (low, high))


def constant(written):
    return sympy.Rational(written[0]) + sympy.Rational(written[1]) * sympy.pi


def end(entry):
    """A finite end, closed or not, or nothing."""
    if entry is None:
        return None
    if isinstance(entry[1], str):
        raise Unknown("an end that is a formula")
    return constant(entry[1]), entry[0]


def inside(scene, name, number):
    entry = scene.symbols[name]
    if not set(entry) <= {"in", "ours", "printed", "printed_in"}:
        return True
    low, high = map(end, declarations.symbol(entry)["real"])
    number = exactly(number)
    over = low is None or number > low[0] or low[1] and abs(number - low[0]) < EQUAL
    under = high is None or number < high[0] or high[1] and abs(number - high[0]) < EQUAL
    return bool(over and under)


def fraction(stream):
    return sympy.Rational(stream.randint(-40, 40), stream.choice([1, 3, 7, 16, 11]))


def real(scene, name, stream, degenerate):
    low, high = map(end, declarations.symbol(scene.symbols[name])["real"])
    for _ in range(40):
        if degenerate and low and low[1] and stream.random() < 0.4:
            drawn = low[0]
        elif low and high:
            drawn = low[0] + (high[0] - low[0]) * sympy.Rational(stream.randint(0, 48), 48)
        elif degenerate:
            drawn = stream.choice(NICE)
        else:
            drawn = fraction(stream)
            drawn = low[0] + abs(drawn) if low else high[0] - abs(drawn) if high else drawn
        if inside(scene, name, drawn):
            return drawn
    raise Unknown("an empty interval")


def smooth(stream, degenerate):
    """The number of a new smooth function."""
    zeros = 0.3 * degenerate
    DRAWN.append([0 if stream.random() < zeros else mpmath.mpf(stream.randint(-6, 6)) / 4 for _ in range(8)])
    return sympy.Integer(len(DRAWN) - 1)


def affine(form, point):
    constant, multiples = form
    return constant + sum(int(point[name]) * k for name, k in multiples.items())


def draw(scene, stream):
    """Values for all symbols, hypotheses aside."""
    degenerate = stream.random() < 0.4
    point, pending = {}, dict(scene.symbols)
    for name, entry in scene.symbols.items():
        if "integer" in entry or "family" in entry:
            continue
        del pending[name]
        if "function" in entry:
            count = entry["function"]
            point[name] = smooth(stream, degenerate) if count in (1, "any") else [smooth(stream, degenerate) for _ in range(count)]
        elif "vector" in entry:
            count = entry["vector"]
            point[name] = fraction(stream) if count == "any" else [fraction(stream) for _ in range(count)]
        else:
            equal = [v for v in point.values() if isinstance(v, sympy.Rational)]
            point[name] = real(scene, name, stream, degenerate)
            if degenerate and equal and stream.random() < 0.3 and inside(scene, name, equal[-1]):
                point[name] = equal[-1]
    for _ in range(len(pending) + 1):
        for name, entry in list(pending.items()):
            try:
                if "integer" in entry:
                    low, high = declarations.integers(entry["integer"])
                    low = affine(low, point) if low else -2
                    point[name] = sympy.Integer(stream.randint(low, max(low, min(low + 3, affine(high, point))) if high else low + 2))
                else:
                    ranges = [declarations.integers(t) for t in entry["indices"]]
                    ranges = [range(affine(a, point), affine(b, point) + 1) for a, b in ranges]
                    keys = [()]
                    for r in ranges:
                        keys = [(*k, n) for k in keys for n in r]
                    count = entry["family"]
                    member = lambda: fraction(stream) if count in (1, "any") else [fraction(stream) for _ in range(count)]
                    point[name] = {key: member() for key in keys}
                del pending[name]
            except KeyError:
                continue
    if pending:
        raise Unknown("a range")
    return point


def equations(tree):
    """Equations that a point may be made to satisfy: those that are joined by `and`."""
    if tree[0] == "and":
        return equations(tree[1]) + equations(tree[2])
    return [tree] if tree[0] == "cmp" and tree[2][0] == "==" else []


def solve(scene, point, tree, stream):
    """The point with a symbol changed so that the equation is true."""
    left, right = tree[1], tree[2][1]
    free = [n for n in sorted(names_in(tree)) if isinstance(point.get(n), sympy.Expr)
            and not {"integer", "function"} & set(scene.symbols[n])]
    stream.shuffle(free)
    for name in free[:3]:
        unknown = sympy.Dummy(name, real=True)
        names = Names(scene, {**point, name: unknown})
        difference = value(left, names) - value(right, names)
        if isinstance(difference, list) or unknown not in difference.free_symbols:
            continue
        try:
            found = sympy.solve(difference, unknown) if difference.is_polynomial(unknown) and sympy.degree(difference, unknown) < 3 \
                else [sympy.nsolve(difference, unknown, fraction(stream), prec=50)]
        except (ValueError, ZeroDivisionError, NotImplementedError, TypeError):
            continue
        stream.shuffle(found)
        for number in found:
            if number.is_real and inside(scene, name, number):
                return {**point, name: number}
    return point


def points(scene, stream):
    """Points that satisfy every hypothesis."""
    for _ in range(TRIES):
        try:
            point = draw(scene, stream)
            wanted = [e for h in scene.hypotheses for e in equations(h)]
            if scene.statement[0] == "implies" and stream.random() < 0.7:
                wanted += equations(scene.statement[1])
            for equation in wanted:
                point = solve(scene, point, equation, stream)
            names = Names(scene, point)
            if all(truth(h, names) for h in scene.hypotheses):
                yield point
        except Undefined:
            continue


def written(scene, point):
    """The point in words; functions by the coefficients of their polynomials."""
    return {n: str(DRAWN[int(v)]) if scene.functions.get(n) == 1 else str(v) for n, v in point.items()}


class TimedOut(BaseException):
    """Not one of the exceptions that a library catches."""


def judged(line, seconds):
    """What this judge says of a claim: counts of points, and those at which it is false."""
    def ring(*_):
        raise TimedOut

    # It rings again, should a library catch the first.
    signal.signal(signal.SIGPROF, ring)
    signal.setitimer(signal.ITIMER_PROF, seconds, 1)
    said = {"true": 0, "undefined": 0, "false": []}
    try:
        file = line["file"]
        scene = Scene(file if isinstance(file, dict) else tomllib.loads(file))
        if scene.sought:
            return said | {"why": "exists"}
        conditions = [parse(text) for text in line.get("conditions", [])]
        correction = parse(line["correction"]) if line.get("correction") else None
        stream = random.Random(line["number"])
        for point in points(scene, stream):
            names = Names(scene, point)
            try:
                found = truth(scene.statement, names)
            except Undefined:
                said["undefined"] += 1
                continue
            if found:
                said["true"] += 1
            else:
                shown = written(scene, point)
                excused = not all(truth(c, names) for c in conditions)
                said["false"].append([shown, excused])
            if correction and not said.get("miscorrected"):
                try:
                    if not truth(correction, names):
                        said["miscorrected"] = written(scene, point)
                except Undefined:
                    pass
            if said["true"] + len(said["false"]) >= POINTS:
                break
    except TimedOut:
        said["why"] = "time"
    except (Unknown, NotInTheLanguage) as error:
        said["why"] = str(error)
    except RecursionError:
        said["why"] = "recursion"
    finally:
        signal.setitimer(signal.ITIMER_PROF, 0)
    return said


def disagreement(line, said):
    """What the judges do not agree on."""
    verdict, truth_said = line.get("verdict"), line.get("truth", "")
    unexcused = [point for point, excused in said["false"] if not excused]
    if verdict == "holds" and said["false"]:
        return f"the engine says holds, false at {said['false'][0][0]}"
    if verdict == "conditional" and unexcused:
        return f"the engine says true under {line['conditions']}, false at {unexcused[0]}"
    if verdict in ("false", "misprint") and not said["false"] and said["true"] >= POINTS // 2:
        return f"the engine says {verdict}, true at {said['true']} points, none false"
    if said.get("miscorrected"):
        return f"the correction {line['correction']} is false at {said['miscorrected']}"
    if line.get("contradiction"):
        return f"the engine contradicts itself: {line['contradiction']}"
    if truth_said in ("Holds", "Conditional") and said["false"]:
        return f"made true, false at {said['false'][0][0]}"
    if truth_said.startswith("Fails") and not said["false"] and said["true"] >= POINTS:
        return "made false, true at all points"
    return None


def hiding(outer, inner):
    """The sections of a file further in, on those further out: a name means one thing."""
    merged = {key: dict(outer.get(key, {})) for key in ("symbols", "basis", "define")}
    for key, other in (("symbols", "define"), ("basis", None), ("define", "symbols")):
        for head, entry in inner.get(key, {}).items():
            stem = lambda text: text.split("(")[0].split("[")[0].strip()
            for part in ("symbols", "define"):
                if other:
                    merged[part] = {h: e for h, e in merged[part].items() if stem(h) != stem(head)}
            merged[key][head] = entry
    return merged


def shipped(path):
    """The claims of the derivation files with one reading, and their verdicts."""
    verdicts = {claim["id"]: claim for claim in json.loads(path.read_text())["claims"]}
    folder = path.resolve().parent.parent / "derivations"
    for head in sorted(folder.glob("*/paper.toml")):
        paper = tomllib.loads(head.read_text(encoding="utf-8"))
        for name in paper["paper"]["claims"]:
            file = tomllib.loads((head.parent / name).read_text(encoding="utf-8"))
            shared = hiding(hiding({}, paper), file)
            for number, entry in enumerate(file.get("claim", [])):
                said = verdicts.get(entry["id"], {})
                if "states" not in entry or not said:
                    continue
                own = hiding(shared, {"symbols": entry.get("symbols", {}), "define": entry.get("let", {})})
                claim = {key: entry[key] for key in ("assume", "given", "states", "exists") if key in entry}
                yield {"number": number, "form": entry["id"], "file": own | {"claim": [claim]},
                       "verdict": said["verdict"], "contradiction": said["contradiction"], "correction": said["corrected"],
                       "conditions": [said["condition"]] if said["condition"] else []}


def work(task):
    line, seconds = task
    try:
        said = judged(line, seconds)
    except TimedOut:  # It rang once more while the first was on its way.
        said = {"true": 0, "undefined": 0, "false": [], "why": "time"}
    except Exception as error:  # A fault of this judge is counted, not hidden.
        said = {"true": 0, "undefined": 0, "false": [], "why": f"fault {type(error).__name__}: {error}"}
    return line, said


def main(path, seconds=5):
    counts, why = collections.Counter(), collections.Counter()
    path = Path(path)
    if path.suffix == ".json":
        lines = list(shipped(path))
    else:
        lines = map(json.loads, path.read_text(encoding="utf-8").splitlines())
    with multiprocessing.Pool() as pool:
        for line, said in pool.imap(work, ((line, float(seconds)) for line in lines)):
            decided = bool(said["false"]) or said["true"] >= POINTS // 2
            counts["claims"] += 1
            counts["false" if said["false"] else "true" if decided else "timed out" if said.get("why") == "time" else "open"] += 1
            if not decided:
                why[said.get("why", "few points").split(":")[0][:60]] += 1
            if found := disagreement(line, said):
                counts["disagreements"] += 1
                shown = line["file"] if isinstance(line["file"], str) else f"{line['file']['claim']}\n"
                print(f"--- {line['number']} {line.get('form')}: {found}\n{shown}truth: {line.get('truth')}\n"
                      f"engine: {line.get('verdict')} {line.get('said', '')}\n")
    print(json.dumps(counts))
    print(json.dumps(dict(why.most_common(12))))
    return counts["disagreements"]


if __name__ == "__main__":
    if len(sys.argv) < 2:
        sys.exit(__doc__)
    sys.exit(main(*sys.argv[1:]) > 0)
