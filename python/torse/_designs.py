"""Designs from files, texts and arrays; their patterns and meshes as arrays."""

import json
from pathlib import Path

import numpy as np

from . import _torse


def _points(array, name):
    points = np.ascontiguousarray(array, dtype=np.float64)
    if points.ndim != 2 or points.shape[1] != 3 or len(points) < 2:
        raise ValueError(f"{name}: an array of at least two points (n, 3) is wanted, not one of shape {points.shape}")
    if not np.isfinite(points).all():
        raise ValueError(f"{name}: all coordinates must be finite")
    return points.tolist()


class Pattern:
    """The flat pattern of a design, in millimetres."""

    def __init__(self, found):
        self._found = found

    area = property(lambda self: self._found.area, doc="of all pieces")
    pieces = property(lambda self: self._found.pieces, doc="the names of the pieces")

    @property
    def summary(self):
        """What the pattern promises: lengths, areas, errors, bends."""
        return json.loads(self._found.summary_json())

    def outline(self, piece=0, chord=0.01):
        """The outline of a piece as an array of points (n, 2), which misses its arcs by at most `chord`."""
        return self._found.outline(piece, chord)

    def dxf(self, path=None):
        """The pattern as the text of a DXF file; written to `path` if there is one."""
        return _written(self._found.dxf(), path)

    def svg(self, path=None):
        """The pattern as the text of an SVG file; written to `path` if there is one."""
        return _written(self._found.svg(), path)

    def __repr__(self):
        return f"<Pattern of {', '.join(self.pieces)}: {self.area:.6g} mm²>"

    def _repr_svg_(self):
        return self._found.svg()


def _written(text, path):
    if path is not None:
        # The bytes of the command, on every system.
        Path(path).write_bytes(text.encode())
    return text


class Design:
    """Points, curves and patches, in millimetres.

    >>> from torse import Design
    >>> low = np.array([[0, 0, 0], [2, 3, 0], [6, 0, 0]]) * 100
    >>> high = np.array([[0.5, 0, 2], [3, 2, 3], [6, -1, 2]]) * 100
    >>> panel = Design.between(low, high)
    >>> points = panel.evaluate(grid=(16, 4))["points"]
    >>> points.shape[-3:], points.dtype.name
    ((17, 5, 3), 'float64')
    >>> outline = panel.unroll().outline()
    >>> outline.shape[1]
    2
    >>> Design.ruled([[0, 0, 0], [0, 100, 0]], [[100, 0, 0], [100, 100, 80]]).unroll()
    Traceback (most recent call last):
    ...
    torse.TorseError: ...
    >>> Design.between([[0, 0, 0]], high)
    Traceback (most recent call last):
    ...
    ValueError: first: an array of at least two points (n, 3) is wanted, not one of shape (1, 3)
    """

    def __init__(self, found):
        self._found = found

    @classmethod
    def open(cls, path):
        """Reads a design file."""
        return cls(_torse.Design.open(path))

    @classmethod
    def read(cls, text, name="design.toml", files=None):
        """Reads the text of a design; `files` has the bytes of the files that it takes curves from, by their names."""
        return cls(_torse.Design.read(text, name, files))

    @classmethod
    def between(cls, first, second, name="panel"):
        """The developable surface between two curves, each given by the control points of a Bézier curve: arrays (n, 3).

        The design has a patch for every part of it that is developable; where there is none, an error says why.
        """
        return cls.read(_text("connect", first, second, name), f"{name}.toml")

    @classmethod
    def ruled(cls, first, second, name="panel"):
        """The ruled surface between two Bézier curves with these control points: developable only if they are made for it."""
        return cls.read(_text("ruled", first, second, name), f"{name}.toml")

    name = property(lambda self: self._found.name, doc="of the file, without its ending")
    patches = property(lambda self: self._found.names, doc="the names of patches and surfaces")

    def inspect(self, quick=False):
        """Can it be made? A dictionary; `missed` lists what is not as demanded. Quickly means without bounds and proofs."""
        return json.loads(self._found.inspect_json(quick))

    def report(self):
        """The same as a text for people."""
        return self._found.report()

    def unroll(self, allow_strain=0.0, only=None, rulings=None):
        """Its flat pattern. What is not developable is refused, unless no line loses more than `allow_strain` of its length."""
        return Pattern(self._found.unroll(allow_strain, only, rulings))

    def evaluate(self, grid=(32, 8), places=None, patch=None):
        """Points, normals and curvatures: a dictionary of arrays.

        On a grid of so many steps along and across the rulings the arrays of a patch have the shape (m + 1, n + 1, ...); at
        `places`, an array (n, 2) of `u, v` in [0, 1], they have a row for each place. NaN where there is no value.
        """
        if places is not None:
            places = np.ascontiguousarray(places, dtype=np.float64)
            found = self._found.evaluate(patch, None, places.tolist())
            shape = None
        else:
            found = self._found.evaluate(patch, tuple(grid), None)
            shape = (grid[0] + 1, grid[1] + 1)
        names = ("parameters", "points", "normals", "curvatures")
        arrays = dict(zip(names, found))
        if shape is None:
            return arrays
        count = shape[0] * shape[1]
        lead = shape if len(arrays["points"]) == count else (-1, *shape)
        return {name: array.reshape(*lead, array.shape[1]) for name, array in arrays.items()}

    def points(self, grid=(1000, 1000), patch=None):
        """The points of a patch alone, on a grid of so many steps along and across the rulings: an array (m + 1, n + 1, 3).

        A million take milliseconds; the patch must be named where there are several.
        """
        if patch is None:
            if len(self.patches) != 1:
                raise ValueError(f"a patch is wanted, one of {', '.join(self.patches)}")
            patch = self.patches[0]
        along, across = grid
        return self._found.points(patch, (along, across)).reshape(along + 1, across + 1, 3)

    def mesh(self):
        """The design as one mesh: `vertices` (n, 3), `normals` (n, 3), `triangles` (m, 3) of indices."""
        vertices, normals, triangles = self._found.mesh()
        return {"vertices": vertices, "normals": normals, "triangles": triangles}

    def export(self, path):
        """Writes a pattern, a mesh or a CAD model, by the ending of the file; returns the path."""
        path = Path(path)
        path.write_bytes(bytes(self._found.export(path.suffix.lstrip("."))))
        return path

    def __repr__(self):
        return f"<Design {self.name}: {', '.join(self.patches)}>"

    def _repr_svg_(self):
        return self._found.svg()


def _text(kind, first, second, name):
    curves = (("first", _points(first, "first")), ("second", _points(second, "second")))
    lines = [f"[curves.{key}]\nbezier = {json.dumps(points)}\n" for key, points in curves]
    return "".join(lines) + f'[patches.{json.dumps(name)}]\n{kind} = ["first", "second"]\n'
