"""Judges the parser: its trees against those of Python's parser, and what it refuses against what Python refuses.

    python3 tests/judges/trees.py texts derivations 1 2000    every text of the folder, and 2000 random ones of the seed 1
    python3 tests/judges/trees.py compare < lines             each line is [text, bracketed tree or null]

`cargo test -p torse-tests --test judges` runs both, with the trees of the crate in between.
"""

import json
import random
import sys
import tomllib
from pathlib import Path

from language import SIGNS, NotInTheLanguage, dump, parse

# Longer chains are grouped by the crate, which its own tests look at.
MOST_OPERANDS = 160


def texts(value):
    """Every string of a TOML value, keys of definitions included."""
    if isinstance(value, str):
        yield value
    elif isinstance(value, list):
        for part in value:
            yield from texts(part)
    elif isinstance(value, dict):
        for key, part in value.items():
            yield key
            yield from texts(part)


def of_folder(folder):
    found = {}
    for file in sorted(Path(folder).rglob("*.toml")):
        for text in texts(tomllib.loads(file.read_text(encoding="utf-8"))):
            found.setdefault(text)
    return list(found)


def formula(stream, depth):
    """A random formula, mostly well formed."""
    if depth == 0 or stream.random() < 0.15:
        return stream.choice(["x", "y", "mu", "F'", "G''", "β", "0", "7", "12.50", "0.1", "pi", "x_1"])
    part = lambda: formula(stream, depth - 1)
    listed = lambda: ", ".join(part() for _ in range(stream.randint(1, 3)))
    form = stream.randrange(16)
    if form < 5:
        return f"{part()} {stream.choice('+-*/^')} {part()}"
    if form < 7:
        return f"{part()} {stream.choice(['and', 'or', 'implies'])} {part()}"
    if form == 7:
        return f"{part()} {stream.choice(['==', '!=', '<', '<=', '>', '>='])} {part()}"
    if form == 8:
        return f"-{part()}"
    if form == 9:
        return f"not {part()}"
    if form == 10:
        return f"[{listed()}]"
    if form == 11:
        return f"{stream.choice(['F', 'sum', 'D(F)', part()])}({listed()})"
    if form == 12:
        return f"{stream.choice(['P', 'B', part()])}[{listed()}]"
    return f"({part()})"


def random_texts(seed, count):
    """Random formulas; in half of them one sign, word or blank is taken out, put in or exchanged."""
    stream = random.Random(seed)
    for _ in range(count):
        text = formula(stream, stream.randint(1, 5))
        if stream.random() < 0.5:
            at = stream.randrange(len(text))
            put = stream.choice(SIGNS + [" ", "'", ".", "=", "!", "not ", " implies ", " and ", "(", ")", "x", "3", "§", ""])
            text = text[:at] + put + text[at + stream.randint(0, 1):]
        yield text


def second_tree(text):
    try:
        return dump(parse(text))
    except NotInTheLanguage:
        return None


def compare(lines):
    counts = {"formulas": 0, "refused": 0, "long": 0}
    wrong = []
    for line in lines:
        text, ours = json.loads(line)
        if any(sum(text.count(sign) for sign in signs) >= MOST_OPERANDS for signs in ("+-", "*/", ["and", "or"])):
            counts["long"] += 1
            continue
        second = second_tree(text)
        counts["refused" if second is None else "formulas"] += 1
        if ours != second:
            wrong.append(f"{text}\n  ours   {ours}\n  second {second}")
    print(json.dumps(counts))
    print("\n".join(wrong[:20]))
    return len(wrong)


if __name__ == "__main__":
    match sys.argv[1:]:
        case ["texts", folder, seed, count]:
            for text in [*of_folder(folder), *random_texts(int(seed), int(count))]:
                print(json.dumps(text))
        case ["compare"]:
            sys.exit(compare(sys.stdin) > 0)
        case _:
            sys.exit(__doc__)
