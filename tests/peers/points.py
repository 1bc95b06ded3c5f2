"""Points of a cubic Bezier curve and of a bicubic Bezier surface beside other libraries, one thread.

The library is timed by `cargo bench -p torse-geometry --bench limits`, whose lines are read. The peers get the same
control points and as many parameters as one call of theirs takes: 10^6 on the curve and 1000 x 1000 on the surface,
fewer where each point is a call of its own. Their points are compared with the sum over the control points first.
"""

import os
import pathlib
import re
import subprocess
import sys
import time

from table import notice, optional

for name in ("OMP_NUM_THREADS", "OPENBLAS_NUM_THREADS", "MKL_NUM_THREADS"):
    os.environ[name] = "1"

ROOT = pathlib.Path(__file__).resolve().parents[2]
CURVE, GRID = "point of a cubic curve", "point of a bicubic grid"
LINES = {"curve, Bernstein": CURVE, "grid, Bernstein": GRID}
KNOTS = [0.0] * 4 + [1.0] * 4


def library():
    """Seconds for each point by task, the least of the bench's own rounds."""
    bench = ["cargo", "bench", "-q", "-p", "torse-geometry", "--bench", "limits"]
    text = subprocess.run(bench, cwd=ROOT, check=True, capture_output=True, text=True).stdout
    found = {task: re.search(rf"^{line} +([0-9.]+)", text, re.M) for line, task in LINES.items()}
    return {task: float(line[1]) * 1e-9 for task, line in found.items()}


def bernstein(numpy, count):
    """The basis at equal steps, one row for each parameter."""
    t = numpy.linspace(0, 1, count)
    s = 1 - t
    return numpy.stack([s**3, 3 * t * s**2, 3 * t**2 * s, t**3], axis=1)


def by_numpy(numpy, curve, net):
    def along(count):
        return bernstein(numpy, count) @ curve

    def grid(count):
        rows = bernstein(numpy, count)
        planes = [rows @ net[:, :, axis] @ rows.T for axis in range(3)]
        return numpy.stack(planes, axis=-1)

    def planes(count):
        # Into three planes that are kept: the fastest that was found.
        rows = bernstein(numpy, count)
        for axis, plane in enumerate(kept.setdefault(count, numpy.empty((3, count, count)))):
            numpy.matmul(rows @ net[:, :, axis], rows.T, out=plane)
        return kept[count].transpose(1, 2, 0)

    kept = {}
    return {
        CURVE: [("numpy, B @ C", along, 10**6)],
        GRID: [("numpy, U @ C @ V.T", planes, 1000), ("numpy, interleaved", grid, 1000)],
    }


def by_scipy(numpy, curve, net):
    if optional("scipy", "scipy") is None:
        return {}
    from scipy.interpolate import BSpline, bisplev

    spline = BSpline(KNOTS, curve, 3)
    surfaces = [[KNOTS, KNOTS, net[:, :, axis].ravel(), 3, 3] for axis in range(3)]

    def grid(count):
        t = numpy.linspace(0, 1, count)
        return numpy.stack([bisplev(t, t, surface) for surface in surfaces], axis=-1)

    return {
        CURVE: [("scipy, BSpline", lambda count: spline(numpy.linspace(0, 1, count)), 10**6)],
        GRID: [("scipy, bisplev", grid, 1000)],
    }


def by_splipy(numpy, curve, net):
    splipy = optional("splipy", "splipy")
    if splipy is None:
        return {}
    basis = splipy.BSplineBasis(order=4)
    line = splipy.Curve(basis, curve)
    surface = splipy.Surface(basis, basis, net.transpose(1, 0, 2).reshape(-1, 3))

    def grid(count):
        t = numpy.linspace(0, 1, count)
        return surface(t, t)

    return {
        CURVE: [("splipy", lambda count: line(numpy.linspace(0, 1, count)), 10**6)],
        GRID: [("splipy", grid, 1000)],
    }


def by_geomdl(numpy, curve, net):
    if optional("geomdl", "geomdl") is None:
        return {}
    from geomdl import BSpline

    line = BSpline.Curve()
    line.degree = 3
    line.ctrlpts = curve.tolist()
    line.knotvector = KNOTS
    surface = BSpline.Surface()
    surface.degree_u = surface.degree_v = 3
    surface.set_ctrlpts(net.reshape(-1, 3).tolist(), 4, 4)
    surface.knotvector_u = surface.knotvector_v = KNOTS

    def evaluated(shape):
        def points(count):
            shape.sample_size = count
            shape.evaluate()
            return shape.evalpts

        return points

    return {CURVE: [("geomdl", evaluated(line), 5000)], GRID: [("geomdl", evaluated(surface), 50)]}


def by_opencascade(numpy, curve, net):
    if optional("OCP", "cadquery-ocp") is None:
        return {}
    from OCP.collections import Array1_gp_Pnt, Array2_gp_Pnt
    from OCP.Geom import Geom_BezierCurve, Geom_BezierSurface
    from OCP.gp import gp_Pnt

    poles, mesh = Array1_gp_Pnt(1, 4), Array2_gp_Pnt(1, 4, 1, 4)
    for i in range(4):
        poles.SetValue(i + 1, gp_Pnt(*map(float, curve[i])))
        for j in range(4):
            mesh.SetValue(i + 1, j + 1, gp_Pnt(*map(float, net[i, j])))
    line, surface, point = Geom_BezierCurve(poles), Geom_BezierSurface(mesh), gp_Pnt()

    def along(count):
        points = []
        for t in numpy.linspace(0, 1, count):
            line.D0(t, point)
            points.append((point.X(), point.Y(), point.Z()))
        return points

    def grid(count):
        points = []
        for u in numpy.linspace(0, 1, count):
            for v in numpy.linspace(0, 1, count):
                surface.D0(u, v, point)
                points.append((point.X(), point.Y(), point.Z()))
        return points

    return {CURVE: [("OpenCASCADE, from Python", along, 20000)], GRID: [("OpenCASCADE, from Python", grid, 150)]}


def expected(numpy, task, count, curve, net):
    """The points by the sum over the control points."""
    rows = bernstein(numpy, count)
    if task == CURVE:
        return numpy.einsum("ia,ak->ik", rows, curve)
    return numpy.einsum("ia,jb,abk->ijk", rows, rows, net)


def measured(rounds):
    """Seconds for each point by program, for each task."""
    numpy = optional("numpy", "numpy")
    if numpy is None:
        notice("without numpy no points are timed")
        return {}
    curve = numpy.array([[i, i * 7 % 5, i * 3 % 4] for i in range(4)], dtype=float)
    height = lambda i, j: (i * 7 + j * 13) % 5 * 0.3
    net = numpy.array([[[i, j, height(i, j)] for j in range(4)] for i in range(4)], dtype=float)
    tasks = {CURVE: [], GRID: []}
    for peer in (by_numpy, by_scipy, by_splipy, by_geomdl, by_opencascade):
        for task, programs in peer(numpy, curve, net).items():
            tasks[task] += programs
    for task, programs in tasks.items():
        for name, points, _ in programs:
            wanted = expected(numpy, task, 7, curve, net)
            found = numpy.asarray(points(7)).reshape(wanted.shape)
            if not numpy.allclose(found, wanted, rtol=1e-14, atol=1e-14):
                sys.exit(f"{name}: {task} is somewhere else")
    least = {task: {"torse": float("inf")} for task in tasks}

    def note(task, name, seconds):
        least[task][name] = min(seconds, least[task].get(name, float("inf")))

    for _ in range(rounds):
        for task, seconds in library().items():
            note(task, "torse", seconds)
        for task, programs in tasks.items():
            for name, points, count in programs:
                for _ in range(3):
                    start = time.perf_counter()
                    points(count)
                    spent = time.perf_counter() - start
                    note(task, name, spent / (count if task == CURVE else count**2))
    return least
