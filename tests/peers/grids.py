"""Times surfaces on grids beside numpy's matrix product, in one interleaved run.

    python3 -m venv venv && venv/bin/pip install numpy
    venv/bin/python tests/peers/grids.py [--rounds N]

Bicubic Bernstein patch, 1000 x 1000 points. The peer forms the same basis tables once and multiplies, `U @ C @ V.T` for
each coordinate, into three planes that it reuses; one thread. The library is timed by `cargo bench -p torse-geometry
--bench limits`, whose line of grids is read. Rounds alternate; the table shows the least time of each, which other work on
the machine disturbs least. Without numpy a notice is printed and nothing is timed.

The values are compared first, on a small grid, with the sum over the control net. Exit code 1 if numpy disagrees with
that, 0 otherwise: times are shown, not judged.
"""

import argparse
import os
import pathlib
import re
import subprocess
import sys
import time

for name in ("OMP_NUM_THREADS", "OPENBLAS_NUM_THREADS", "MKL_NUM_THREADS"):
    os.environ[name] = "1"

ROOT = pathlib.Path(__file__).resolve().parents[2]
SIDE = 1000


def bernstein(t):
    s = 1 - t
    return [s**3, 3 * t * s**2, 3 * t**2 * s, t**3]


def height(i, j):
    return (i * 7 + j * 13) % 5 * 0.3


def library():
    """Nanoseconds for each point, the least of the bench's own rounds, as floats by the name of the line."""
    bench = ["cargo", "bench", "-q", "-p", "torse-geometry", "--bench", "limits"]
    text = subprocess.run(bench, cwd=ROOT, check=True, capture_output=True, text=True).stdout
    lines = re.findall(r"^(grid, \w+|plain stores of 24 bytes) +([0-9.]+)", text, re.M)
    return {name: float(value) for name, value in lines}


def main():
    arguments = argparse.ArgumentParser()
    arguments.add_argument("--rounds", type=int, default=3)
    rounds = arguments.parse_args().rounds
    try:
        import numpy
    except ImportError as error:
        print(f"skipped: {error}")
        return 0
    net = numpy.array([[[i, j, height(i, j)] for j in range(4)] for i in range(4)], dtype=float)

    def table(count):
        return numpy.stack(bernstein(numpy.linspace(0, 1, count)), axis=1)

    small = table(5)
    exact = [[sum(a * b * net[i, j] for i, a in enumerate(u) for j, b in enumerate(v)) for v in small] for u in small]
    points = numpy.stack([small @ net[:, :, axis] @ small.T for axis in range(3)], axis=-1)
    if not numpy.allclose(points, exact, rtol=1e-14, atol=1e-14):
        print("numpy's product disagrees with the sum over the control net")
        return 1

    planes = numpy.empty((3, SIDE, SIDE))
    least = {}
    for _ in range(rounds):
        for name, value in library().items():
            least[name] = min(value, least.get(name, value))
        for _ in range(11):
            start = time.perf_counter()
            rows = table(SIDE)
            for axis in range(3):
                numpy.matmul(rows @ net[:, :, axis], rows.T, out=planes[axis])
            spent = (time.perf_counter() - start) * 1e9 / SIDE**2
            least["numpy, U @ C @ V.T"] = min(spent, least.get("numpy, U @ C @ V.T", spent))
    peer = least["numpy, U @ C @ V.T"]
    print(f"{'':28} {'ns a point':>10} {'numpy is':>10}")
    for name, value in least.items():
        print(f"{name:28} {value:>10.2f} {peer / value:>9.2f}x")
    return 0


if __name__ == "__main__":
    sys.exit(main())
