"""One table for all peers: what is computed, by whom, and how long it takes."""

import importlib


def notice(text):
    print(f"notice: {text}")


def optional(module, package):
    """The module, or None with a notice of what is missing."""
    try:
        return importlib.import_module(module)
    except ImportError:
        notice(f"{package} is not installed and not timed (pip install {package})")
        return None


def duration(seconds):
    for unit, size in (("s", 1.0), ("ms", 1e-3), ("us", 1e-6)):
        if seconds >= size:
            return f"{seconds / size:.2f} {unit}"
    return f"{seconds * 1e9:.2f} ns"


def show(tasks):
    """Tasks by name, each with seconds by the name of the program; the first program is the one compared with."""
    rows = []
    for task, times in tasks.items():
        base = next(iter(times.values()))
        for program, seconds in times.items():
            rows.append((task, program, duration(seconds), f"{seconds / base:.2f}"))
            task = ""
    head = ("", "least time of all rounds", "each", "ratio")
    wide = [max(len(row[k]) for row in [head, *rows]) for k in range(4)]
    for row in [head, *rows]:
        a, b, c, d = (text.ljust(w) if k < 2 else text.rjust(w) for k, (text, w) in enumerate(zip(row, wide)))
        print(f"{a}  {b}  {c}  {d}")
