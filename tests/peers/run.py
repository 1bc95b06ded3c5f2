#!/usr/bin/env python3
"""Times the library beside its peers: one run, one table.

    python3 -m venv venv && venv/bin/pip install numpy scipy splipy geomdl cadquery-ocp python-flint
    venv/bin/python tests/peers/run.py [--rounds N]

Points of curves and surfaces beside numpy, scipy, splipy, geomdl and OpenCASCADE (`points.py`), products of polynomials
beside FLINT (`products.py`). A peer that is not installed is left out with a notice. Values are compared before anything is
timed; rounds alternate between the programs, and the table shows the least time of each, which other work on the machine
disturbs least.

Exit code 1 if a peer computes something else than the library, 0 otherwise: times are shown, not judged.
"""

import argparse
import sys

import points
import products
import table


def main():
    arguments = argparse.ArgumentParser(description="Times the library beside its peers.")
    arguments.add_argument("--rounds", type=int, default=3, help="measurements of each program")
    rounds = arguments.parse_args().rounds
    tasks = {**points.measured(rounds), **products.measured(rounds)}
    table.show(tasks)
    return 0


if __name__ == "__main__":
    sys.exit(main())
