"""What the scripts beside this file have in common: they compare what they work out with what the derivation files expect."""

import pathlib
import sys
import tomllib

DERIVATIONS = pathlib.Path(__file__).resolve().parents[2] / "derivations"


def compare(folder, checks, files=("*",)):
    """Compares the checks, by the names of the claims without the folder, with the claims of these files, and says what
    differs. Ends the program: with 1 if anything does."""
    expected = {}
    for file in sorted(path for name in files for path in (DERIVATIONS / folder).glob(f"{name}.toml")):
        for claim in tomllib.loads(file.read_text(encoding="utf-8")).get("claim", []):
            expected[claim["id"].removeprefix(f"{folder}/")] = claim["expect"] in ("holds", "conditional")
    differences = [f"{name}: stated on one side only" for name in sorted(expected.keys() ^ checks.keys())]
    for name in sorted(expected.keys() & checks.keys()):
        if bool(checks[name]()) != expected[name]:
            differences.append(f"{name}: expected {expected[name]}")
    print(*differences, f"{len(expected)} claims, {len(differences)} differences", sep="\n")
    sys.exit(min(len(differences), 1))
