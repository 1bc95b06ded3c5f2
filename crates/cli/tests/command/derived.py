"""Runs what `torse derive` has printed: SymPy and Rust have to give the same numbers.

The folder holds pairs NAME.py and NAME.rs; values go in by the order in which both name their symbols.
"""

import pathlib
import re
import subprocess
import sys

from sympy import Rational, Symbol

folder = pathlib.Path(sys.argv[1])
modules, calls, expected = [], [], []
for path in sorted(folder.glob("*.py")):
    text = path.read_text()
    module = {}
    exec(compile(text, str(path), "exec"), module)
    kinds = re.findall(r'symbols\("([^"]*)", (.*)\)', text)
    code = path.with_suffix(".rs").read_text()
    name, numbers, points = re.search(
        r"pub fn (\w+)\((?:(.*), )?points: \[f64; (\d+)\]\)", code
    ).groups()
    count = len(numbers.split(",")) if numbers else 0, int(points)
    names = [(name, "integer" in kind) for listed, kind in kinds for name in listed.split()]
    assert len(names) == sum(count), (path, names, count)
    assert len({name for name, _ in names}) == len(names), f"{path}: a name twice"
    values = {}
    for place, (own, whole) in enumerate(names):
        values[own] = Rational(4 + place) if whole else Rational(2 * place + 3, 7 + place)
    of = {s: values[s.name] for e in module["results"].values() for s in e.free_symbols}
    expected.append([float(e.subs(of)) for e in module["results"].values()])
    given = [f"{float(v)!r}" for v in values.values()]
    modules.append(f"mod p{len(calls)} {{ {code} }}")
    inputs = ", ".join(given[: count[0]] + [f"[{', '.join(given[count[0]:])}]"])
    calls.append(f"println!(\"{{:?}}\", p{len(calls)}::{name}({inputs}));")
program = folder / "program.rs"
program.write_text("\n".join(modules) + "\nfn main() {\n" + "\n".join(calls) + "\n}\n")
binary = folder / "program"
subprocess.run(["rustc", "--edition=2024", "-o", binary, program], check=True)
lines = subprocess.run([binary], check=True, capture_output=True, text=True).stdout.splitlines()
assert len(lines) == len(expected)
for path, line, wanted in zip(sorted(folder.glob("*.py")), lines, expected):
    found = [float(number) for number in line.strip("[]").split(",")]
    assert len(found) == len(wanted), (path, found, wanted)
    for a, b in zip(found, wanted):
        assert abs(a - b) <= 1e-9 * (1 + abs(b)), (path.name, found, wanted)
print(len(lines), "derivations agree")
