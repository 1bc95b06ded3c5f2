import math
import time

import numpy as np
import pytest
import torse

CONE = """
[curves.rim]
arc = { centre = [0, 0, 0], from = [30, 0, 0], to = [0, 30, 0] }
[patches.cone]
cone = "rim"
apex = [0, 0, 40]
range = [1, 0.5]
"""
# A sector of an annulus of radii 50 and 25.
AREA = math.pi * (30 * 50 - 15 * 25) / 4


def test_a_design_is_measured_and_unrolled(tmp_path):
    design = torse.Design.read(CONE, "cone.toml")
    assert design.inspect()["missed"] == []
    pattern = design.unroll()
    assert pattern.area == pytest.approx(AREA, abs=1e-9)
    outline = pattern.outline(chord=1e-3)
    x, y = outline.T
    shoelace = abs(np.dot(x, np.roll(y, -1)) - np.dot(y, np.roll(x, -1))) / 2
    assert shoelace == pytest.approx(AREA, rel=1e-4)
    text = pattern.dxf(tmp_path / "cone.dxf")
    assert (tmp_path / "cone.dxf").read_bytes() == text.encode()
    assert pattern._repr_svg_().startswith("<")
    step = design.export(tmp_path / "cone.step")
    assert step.read_bytes().startswith(b"ISO-10303-21")


def test_points_and_normals_are_arrays():
    found = torse.Design.read(CONE).evaluate(grid=(8, 4))
    assert found["points"].shape == (9, 5, 3) and found["parameters"].shape == (9, 5, 2)
    points, normals = found["points"], found["normals"]
    radius = np.hypot(points[..., 0], points[..., 1])
    assert np.allclose(radius, 30 * (1 - points[..., 2] / 40))
    assert np.allclose(np.linalg.norm(normals, axis=-1), 1)
    # The larger curvature of a cone is that of its rulings' distance from the axis; the other vanishes.
    assert np.allclose(np.abs(found["curvatures"]).min(axis=-1), 0, atol=1e-9)
    some = torse.Design.read(CONE).evaluate(places=np.array([[0.5, 0.5], [0, 0]]))
    assert some["points"].shape == (2, 3)


def test_a_million_points_cost_what_the_library_takes():
    panel = torse.Design.read(CONE)
    grid = (999, 999)
    panel.points(grid)
    # In turn, so that what else the machine does slows both.
    ours, library = [], []
    for _ in range(15):
        start = time.perf_counter()
        points = panel.points(grid)
        ours.append(time.perf_counter() - start)
        library.append(panel._found.seconds_of_points("cone", grid))
        assert points.shape == (1000, 1000, 3)
    assert min(ours) <= 1.3 * min(library), (min(ours), min(library))


def test_points_are_those_of_an_evaluation():
    panel = torse.Design.read(CONE)
    assert np.array_equal(panel.points((8, 4)), panel.evaluate(grid=(8, 4))["points"])
    with pytest.raises(torse.TorseError, match="none"):
        panel.points((8, 4), patch="none")
    for grid in ((0, 4), (10**5, 10**5)):
        with pytest.raises(torse.TorseError, match="grid"):
            panel.points(grid)


def test_a_mesh_has_the_area_of_the_surface():
    mesh = torse.Design.read(CONE).mesh()
    a, b, c = (mesh["vertices"][mesh["triangles"][:, i]] for i in range(3))
    area = np.linalg.norm(np.cross(b - a, c - a), axis=1).sum() / 2
    assert area == pytest.approx(AREA, rel=1e-2)
    assert mesh["triangles"].dtype == np.uint32


def test_a_panel_of_arrays_is_developable():
    chine = np.array([[0.0, 0, 0], [2, 3, 0], [6, 0, 0]]) * 100
    deck = np.array([[0.5, 0, 2], [3, 2, 3], [6, -1, 2]]) * 100
    panel = torse.Design.between(chine, deck)
    pattern = panel.unroll()
    assert pattern.area > 0 and all(patch["developable"] for patch in panel.inspect(quick=True)["patches"])


def test_what_is_not_developable_is_refused():
    twisted = torse.Design.ruled([[0, 0, 0], [0, 100, 0]], [[100, 0, 0], [100, 100, 80]])
    with pytest.raises(torse.TorseError):
        twisted.unroll()


@pytest.mark.parametrize("points", [[[0, 0, 0]], [[0, 0], [1, 1]], [[0, 0, 0], [1, math.nan, 0]]])
def test_points_that_are_none_are_refused(points):
    with pytest.raises(ValueError):
        torse.Design.between(points, [[0, 0, 1], [1, 0, 1]])


def test_a_mistake_has_its_place():
    with pytest.raises(torse.TorseError) as raised:
        torse.Design.read("[points]\nA = [0, 0]\n", "mine.toml")
    assert (raised.value.file, raised.value.line, raised.value.column) == ("mine.toml", 2, 5)
    # The message has the mistake, and not only their number.
    assert "mine.toml:2:5: " in str(raised.value)


def test_a_table_of_offsets_is_a_file_of_the_design():
    text = '[curves.low]\nimport = "hull.csv#chine"\n[curves.high]\nimport = "hull.csv#sheer"\n[patches.side]\nruled = ["low", "high"]\n'
    table = "x [m],chine y,chine z,sheer y,sheer z\n0,0,0,0,0.5\n1,0.3,0,0.4,0.6\n2,0.2,0.1,0.3,0.7\n"
    assert torse.Design.read(text, files={"hull.csv": table.encode()}).patches
    with pytest.raises(torse.TorseError):
        torse.Design.read(text)
