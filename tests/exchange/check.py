#!/usr/bin/env python3
"""Independent readers open what torse writes.

    python3 tests/exchange/check.py [--files FOLDER] [--torse PROGRAM]

The files are those of the library (`cargo run -p torse-exchange --example files`) and, for every design of `designs/` and
every format, those that the command writes; what should be found in them comes from the library (`cargo run -p torse-designs
--example expected`). They are made in a temporary folder, or in FOLDER, by the command built here, or by PROGRAM. Each
reader that is not installed is skipped with a notice:

    pip install ezdxf cadquery-ocp trimesh networkx lxml svgpathtools pillow
    npm install gltf-validator        (beside the folder where this is run, or name it in NODE_PATH)

Ends with 1 when a command fails, or when a reader finds something else than the library says.
"""

import argparse
import json
import math
import re
import subprocess
import sys
import tempfile
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
PATTERNS = ("dxf", "svg")
FORMATS = (*PATTERNS, "stl", "obj", "ply", "3mf", "glb", "step", "stp", "iges", "igs")
PICTURES = ("png", "svg", "html")
failures = 0


def check(holds, text):
    global failures
    failures += not holds
    print(("ok      " if holds else "FAILED  ") + text)


def close(found, expected, relative):
    return abs(found - expected) <= relative * abs(expected)


def skipped(reader, why):
    print(f"skipped {reader}: {why}")


def check_dxf(folder, entry):
    try:
        import ezdxf
        from ezdxf import path, units
        from ezdxf.lldxf.encoding import decode_dxf_unicode
    except ImportError as error:
        return skipped("ezdxf", error)
    document = ezdxf.readfile(folder / entry["dxf"])
    audit = document.audit()
    check(not audit.errors and not audit.fixes, f"ezdxf: audit, {len(audit.errors)} errors, {len(audit.fixes)} fixes")
    for error in audit.errors + audit.fixes:
        print("        ", error.message)
    check(document.dxfversion == "AC1015" and document.units == units.MM, "ezdxf: AC1015 in millimetres")
    wanted = {"OUTLINE", "RULINGS", "BEND_UP", "BEND_DOWN", "REGRESSION", "MARKS"}
    check(wanted <= {layer.dxf.name for layer in document.layers}, "ezdxf: the six layers")
    lines = document.modelspace().query('LWPOLYLINE[layer=="OUTLINE"]')
    check(len(lines) == 2 and all(line.closed for line in lines), "ezdxf: a closed outline with a closed hole")
    lengths = [sum(c.length for c in _curves(line)) for line in lines]
    good = close(lengths[0], entry["outline"], 1e-12) and close(lengths[1], entry["hole"], 1e-12)
    check(good, f"ezdxf: lengths {lengths}")
    flat = [(p.x, p.y) for p in path.make_path(lines[0]).flattening(1e-5)]
    area = 0.5 * sum(a[0] * b[1] - b[0] * a[1] for a, b in zip(flat, flat[1:] + flat[:1]))
    # Paths of ezdxf have cubics for arcs.
    check(close(area, entry["area"], 5e-5), f"ezdxf: area {area}")
    bends = [line.get_xdata("TORSE")[1].value for line in document.modelspace() if line.dxf.layer.startswith("BEND")]
    check(bends == entry["bends"], f"ezdxf: bend angles {bends}")
    text = document.modelspace().query("TEXT").first
    content = decode_dxf_unicode(text.plain_text())
    check(content == "Blech <Nr. 1> & größer" and text.dxf.rotation == 90.0, f"ezdxf: text {content!r}")


def check_pattern(folder, entry):
    """A sector of an annulus: its apex is where the end rulings meet."""
    try:
        import ezdxf
    except ImportError as error:
        return skipped("ezdxf", error)
    document = ezdxf.readfile(folder / entry["dxf"])
    audit = document.audit()
    space = document.modelspace()
    outline = space.query('LWPOLYLINE[layer=="OUTLINE"]').first
    check(not audit.errors and not audit.fixes and outline.closed, "ezdxf pattern: audit, closed outline")
    length = sum(c.length for c in _curves(outline))
    check(abs(length - entry["outline"]) < 1e-2, f"ezdxf pattern: length {length}, exact {entry['outline']}")
    bends = [line for line in space if line.dxf.layer in ("RULINGS", "BEND_UP", "BEND_DOWN")]
    check(len(bends) == entry["rulings"], f"ezdxf pattern: {len(bends)} rulings")
    (a, b), (c, d) = ([p[:2] for p in bends[i].get_points("xy")] for i in (0, -1))
    u, v, w = (b[0] - a[0], b[1] - a[1]), (d[0] - c[0], d[1] - c[1]), (c[0] - a[0], c[1] - a[1])
    part = (w[0] * v[1] - w[1] * v[0]) / (u[0] * v[1] - u[1] * v[0])
    apex = (a[0] + part * u[0], a[1] + part * u[1])
    farthest = 0.0
    for curve in _curves(outline):
        for point in curve.flattening(1e-5) if curve.dxftype() == "ARC" else ():
            radius = math.hypot(point.x - apex[0], point.y - apex[1])
            farthest = max(farthest, min(abs(radius - exact) for exact in entry["radii"]))
    good = farthest <= entry["error"] + 2e-5
    check(good, f"ezdxf pattern: cut at most {farthest:.3g} mm from the exact circles, stated {entry['error']:.3g} mm")


def check_outline(folder, entry):
    """The pieces of a design: each a closed outline that passes the points of the exact development."""
    try:
        import ezdxf
        from ezdxf import units
    except ImportError as error:
        return skipped("ezdxf", error)
    name = entry["dxf"]
    document = ezdxf.readfile(folder / name)
    audit = document.audit()
    check(not audit.errors and not audit.fixes, f"ezdxf {name}: audit")
    check(document.dxfversion == "AC1015" and document.units == units.MM, f"ezdxf {name}: AC1015 in millimetres")
    wanted = {"OUTLINE", "RULINGS", "BEND_UP", "BEND_DOWN", "REGRESSION", "MARKS"}
    check(wanted <= {layer.dxf.name for layer in document.layers}, f"ezdxf {name}: the six layers")
    space = document.modelspace()
    # The outline of a piece comes before its rulings, its holes after them.
    pieces, bends = [], []
    for line in space.query("LWPOLYLINE"):
        if line.dxf.layer == "OUTLINE":
            pieces.append(line)
            bends.append(0)
        elif line.dxf.layer in ("RULINGS", "BEND_UP", "BEND_DOWN"):
            bends[-1] += 1
    kept = [(line, count) for line, count in zip(pieces, bends) if count]
    check(len(kept) == len(entry["pieces"]), f"ezdxf {name}: {len(kept)} pieces, {len(pieces) - len(kept)} holes")
    for (line, count), piece in zip(kept, entry["pieces"]):
        curves = list(_curves(line))
        length = sum(c.length for c in curves)
        good = line.closed and count == piece["rulings"] and close(length, piece["length"], 1e-9)
        check(good, f"ezdxf {name} {piece['name']}: closed, {count} rulings, length {length:.6f}")
        farthest = max(min(_distance(curve, point) for curve in curves) for point in piece["points"])
        good = farthest <= piece["error"]
        check(good, f"ezdxf {name} {piece['name']}: {farthest:.3g} mm from the exact outline, stated {piece['error']:.3g}")


def _distance(curve, point):
    """The distance of a point from a line or an arc."""
    x, y = point
    if curve.dxftype() == "ARC":
        dx, dy = x - curve.dxf.center.x, y - curve.dxf.center.y
        start, span = curve.dxf.start_angle, (curve.dxf.end_angle - curve.dxf.start_angle) % 360
        if (math.degrees(math.atan2(dy, dx)) - start) % 360 <= span:
            return abs(math.hypot(dx, dy) - curve.dxf.radius)
        return min(math.hypot(x - p.x, y - p.y) for p in (curve.start_point, curve.end_point))
    a, b = curve.dxf.start, curve.dxf.end
    along = (b.x - a.x, b.y - a.y)
    share = ((x - a.x) * along[0] + (y - a.y) * along[1]) / (along[0] ** 2 + along[1] ** 2)
    share = min(max(share, 0), 1)
    return math.hypot(x - a.x - share * along[0], y - a.y - share * along[1])


def _curves(line):
    """Lines and arcs of a polyline with lengths."""
    for part in line.virtual_entities():
        if part.dxftype() == "ARC":
            turn = math.radians((part.dxf.end_angle - part.dxf.start_angle) % 360)
            part.length = part.dxf.radius * turn
        else:
            part.length = (part.dxf.end - part.dxf.start).magnitude
        yield part


def check_svg(folder, entry):
    try:
        import svgpathtools
    except ImportError as error:
        return skipped("svgpathtools", error)
    import xml.etree.ElementTree as tree

    root = tree.parse(folder / entry["svg"]).getroot()
    spread = [float(x) for x in root.get("viewBox").split()]
    units = (float(root.get("width").removesuffix("mm")), float(root.get("height").removesuffix("mm")))
    size, margin = entry["size"], 0.02 * max(entry["size"])
    good = all(close(a - 2 * margin, b, 1e-12) and close(a, c, 1e-15) for a, b, c in zip(units, size, spread[2:]))
    check(good, f"svg: {units} mm, one unit a millimetre")
    names = [g.get("id") for g in root if g.tag.endswith("}g")]
    check(names == ["OUTLINE", "RULINGS", "BEND_UP", "BEND_DOWN", "REGRESSION", "MARKS"], f"svg: layers {names}")
    paths, attributes = svgpathtools.svg2paths(str(folder / entry["svg"]))
    lengths = [path.length() for path in paths[:2]]
    good = close(lengths[0], entry["outline"], 1e-9) and close(lengths[1], entry["hole"], 1e-9)
    check(good and all(path.isclosed() for path in paths[:2]), f"svgpathtools: closed, lengths {lengths}")
    bounds = paths[0].bbox()
    good = all(abs(a - b) < 1e-9 for a, b in zip(bounds, (0, 80, -50, 0)))
    check(good, f"svgpathtools: bounds {bounds}")
    # The area method of svgpathtools takes minutes with arcs.
    corners = [paths[0].point(i / 20000) for i in range(20000)]
    area = 0.5 * abs(sum((a.conjugate() * b).imag for a, b in zip(corners, corners[1:] + corners[:1])))
    check(close(area, entry["area"], 1e-5), f"svgpathtools: area {area}")
    bends = [float(a["data-bend"]) for a in attributes if "data-bend" in a]
    check(bends == entry["bends"], f"svg: bend angles {bends}")


def check_model(folder, entry):
    try:
        from OCP.BRepAdaptor import BRepAdaptor_Surface
        from OCP.BRepBuilderAPI import BRepBuilderAPI_MakeVertex
        from OCP.BRepCheck import BRepCheck_Analyzer
        from OCP.BRepExtrema import BRepExtrema_DistShapeShape
        from OCP.gp import gp_Pnt, gp_Vec
        from OCP.IGESControl import IGESControl_Reader
        from OCP.IGESGeom import IGESGeom_RuledSurface
        from OCP.STEPControl import STEPControl_Reader
        from OCP.TopAbs import TopAbs_EDGE, TopAbs_FACE
        from OCP.TopExp import TopExp_Explorer
        from OCP.TopoDS import TopoDS
    except ImportError as error:
        return skipped("cadquery-ocp", error)

    def count(shape, kind):
        found, explorer = [], TopExp_Explorer(shape, kind)
        while explorer.More():
            if not any(explorer.Current().IsSame(other) for other in found):
                found.append(explorer.Current())
            explorer.Next()
        return len(found)

    def area_of(shape):
        """Gauss and Legendre on OCCT's own derivatives: BRepGProp loses all but three digits at a tight bend."""
        to_face = getattr(TopoDS, "Face_s", None) or TopoDS.Face
        total, explorer = 0.0, TopExp_Explorer(shape, TopAbs_FACE)
        point, along, across = gp_Pnt(), gp_Vec(), gp_Vec()
        while explorer.More():
            surface = BRepAdaptor_Surface(to_face(explorer.Current()))
            us = list(_quadrature(surface.FirstUParameter(), surface.LastUParameter(), 48))
            vs = list(_quadrature(surface.FirstVParameter(), surface.LastVParameter(), 2))
            for (u, wide), (v, high) in ((a, b) for a in us for b in vs):
                surface.D1(u, v, point, along, across)
                total += wide * high * along.Crossed(across).Magnitude()
            explorer.Next()
        return total

    for kind, reader in (("step", STEPControl_Reader()), ("iges", IGESControl_Reader())):
        name = entry[kind]
        read = reader.ReadFile(str(folder / name))
        check(str(read).endswith("IFSelect_RetDone"), f"OCCT {name}: {read}")
        if kind == "iges":
            for number in range(1, reader.NbRootsForTransfer() + 1):
                root = reader.RootForTransfer(number)
                if isinstance(root, IGESGeom_RuledSurface):
                    print(f"        ruled surface, form {root.FormNumber()}, developable: {root.IsDevelopable()}")
        reader.TransferRoots()
        shape = reader.OneShape()
        check(BRepCheck_Analyzer(shape).IsValid(), f"OCCT {name}: valid")
        faces, edges = count(shape, TopAbs_FACE), count(shape, TopAbs_EDGE)
        check(faces == entry["faces"], f"OCCT {name}: {faces} faces, {edges} edges")
        # What is approximated has another area.
        measured, within = area_of(shape), entry["area_within"] + 1e-8 * entry["area"]
        good = abs(measured - entry["area"]) <= within
        check(good, f"OCCT {name}: area {measured}, library {entry['area']}, within {within:.3g}")
        # OCCT measures to 1e-7.
        farthest = 0.0
        for point in entry["points"]:
            vertex = BRepBuilderAPI_MakeVertex(gp_Pnt(*point)).Vertex()
            farthest = max(farthest, BRepExtrema_DistShapeShape(vertex, shape).Value())
        good = farthest <= entry["error"] + entry["sewing"] + 1e-7
        check(good, f"OCCT {name}: farthest library point {farthest:.3g} mm, proved {entry['error']:.3g} mm")


def _quadrature(low, high, parts):
    """Places and weights of the rule of Gauss and Legendre with six places on each of equal parts."""
    half = 0.5 * (high - low) / parts
    rule = ((0.2386191860831969, 0.467913934572691), (0.6612093864662645, 0.3607615730481386), (0.9324695142031521, 0.1713244923791704))
    for part in range(parts):
        middle = low + (2 * part + 1) * half
        for place, weight in rule:
            yield middle - half * place, half * weight
            yield middle + half * place, half * weight


def check_mesh(folder, entry):
    try:
        import trimesh
    except ImportError as error:
        return skipped("trimesh", error)
    for name in entry["files"]:
        try:
            mesh = trimesh.load(folder / name, force="mesh")
        except Exception as error:  # a reader of trimesh that is not installed
            skipped(f"trimesh {name}", error)
            continue
        mesh.merge_vertices(merge_norm=True, merge_tex=True)
        scale = 1e-3 if name.endswith("glb") else 1.0
        good = len(mesh.faces) == entry["triangles"] and mesh.is_watertight == entry["watertight"]
        check(good, f"trimesh {name}: {len(mesh.faces)} triangles, watertight {mesh.is_watertight}")
        check(close(mesh.area, entry["area"] * scale**2, 1e-5), f"trimesh {name}: area {mesh.area}")
        if entry["watertight"]:
            check(close(mesh.volume, entry["volume"] * scale**3, 1e-5), f"trimesh {name}: volume {mesh.volume}")
        if name.endswith("glb"):
            # Up in the part is up in glTF, which is y.
            up = mesh.bounds[1][1] - mesh.bounds[0][1]
            flat = trimesh.load(folder / name.replace("glb", "ply"), force="mesh")
            height = flat.bounds[1][2] - flat.bounds[0][2]
            check(close(up, 1e-3 * height, 1e-6), f"trimesh {name}: {up} m high")


VALIDATE = """
const validator = require('gltf-validator');
const bytes = new Uint8Array(require('fs').readFileSync(process.argv[1]));
validator.validateBytes(bytes).then(report => console.log(JSON.stringify(report.issues)));
"""


def check_glb(folder, entry):
    for name in entry["files"]:
        if not name.endswith("glb"):
            continue
        try:
            run = subprocess.run(["node", "-e", VALIDATE, str(folder / name)], capture_output=True, text=True)
        except FileNotFoundError as error:
            return skipped("gltf-validator", error)
        if run.returncode:
            return skipped("gltf-validator", (run.stderr.strip().splitlines() or ["no output"])[-1])
        issues = json.loads(run.stdout)
        counts = [issues[kind] for kind in ("numErrors", "numWarnings", "numInfos", "numHints")]
        check(counts == [0, 0, 0, 0], f"gltf-validator {name}: errors, warnings, infos, hints {counts}")
        for message in issues["messages"][:5]:
            print("        ", message["code"], message["message"])


def check_outline_svg(folder, entry):
    """The same outlines in the other format: its y axis points down."""
    try:
        import svgpathtools
    except ImportError as error:
        return skipped("svgpathtools", error)
    name = entry["svg"]
    paths, attributes = svgpathtools.svg2paths(str(folder / name))
    closed = [path for path in paths if path.isclosed()]
    bends = sum("data-bend" in each for each in attributes)
    wanted = sum(piece["rulings"] for piece in entry["pieces"])
    check(bends == wanted, f"svgpathtools {name}: {bends} rulings with their bends")
    for piece in entry["pieces"]:
        points = [complex(x, -y) for x, y in piece["points"]]

        def farthest(path):
            return max(min(_svg_distance(part, point) for part in path) for point in points)

        distance, path = min(((farthest(path), path) for path in closed), key=lambda pair: pair[0])
        good = close(path.length(), piece["length"], 1e-9) and distance <= piece["error"] + 1e-9
        text = f"length {path.length():.6f}, {distance:.3g} mm from the exact outline, stated {piece['error']:.3g}"
        check(good, f"svgpathtools {name} {piece['name']}: closed, {text}")


def _svg_distance(part, point):
    """The distance of a point from a line or an arc of a circle of svgpathtools."""
    if hasattr(part, "center"):
        angle = math.degrees(math.atan2(point.imag - part.center.imag, point.real - part.center.real))
        along = (angle - part.theta) % 360 if part.delta > 0 else (part.theta - angle) % 360
        if along <= abs(part.delta):
            return abs(abs(point - part.center) - part.radius.real)
        return min(abs(point - part.start), abs(point - part.end))
    way = part.end - part.start
    share = ((point - part.start) * way.conjugate()).real / abs(way) ** 2
    return abs(point - part.start - min(max(share, 0), 1) * way)


def check_pictures(folder, name):
    import xml.etree.ElementTree as tree

    root = tree.parse(folder / f"{name}.picture.svg").getroot()
    check(root.tag.endswith("}svg") and len(list(root.iter())) > 20, f"picture {name}: SVG is XML")
    page = (folder / f"{name}.picture.html").read_text()
    # Addresses that name a language are never fetched.
    fetched = re.search(r"""(src|href|action)=["']?\s*(https?:)?//|url\(["']?(https?:)?//|@import|fetch\(|XMLHttp""", page)
    check(not fetched, f"picture {name}: the page needs no network")
    try:
        from PIL import Image
    except ImportError as error:
        return skipped("pillow", error)
    with Image.open(folder / f"{name}.picture.png") as picture:
        picture.load()
        colours = len(picture.convert("RGB").getcolors(1 << 24))
        check(min(picture.size) >= 400 and colours > 50, f"pillow {name}: {picture.size}, {colours} colours")


def check_values(folder, name):
    """Of the values that are printed: the same as CSV and as JSON, unit normals."""
    rows = json.loads((folder / f"{name}.values.json").read_text())
    lines = (folder / f"{name}.values.csv").read_text().splitlines()[1:]
    check(len(rows) == len(lines) > 0, f"values {name}: {len(rows)} rows in both forms")
    same = all([float(x) for x in line.split(",")[3:6]] == row["point"] for line, row in zip(lines, rows))
    lengths = [math.hypot(*row["normal"]) for row in rows if row["normal"]]
    check(same and all(abs(length - 1) < 1e-12 for length in lengths), f"values {name}: points agree, normals of length 1")


def written_by_the_command(torse, designs, folder):
    """Every design inspected, unrolled, folded back, exported, evaluated, drawn."""

    def run(*arguments, to=None):
        done = subprocess.run([torse, *map(str, arguments)], capture_output=True, text=True)
        if to:
            to.write_text(done.stdout)
        if done.returncode:
            check(False, f"torse {' '.join(map(str, arguments))}: exit code {done.returncode}\n{done.stderr}")

    for design in designs:
        name, before = design.stem, failures
        file = lambda ending: folder / f"{name}.{ending}"
        run("inspect", design)
        for ending in FORMATS:
            run("export", design, "--to", file(ending))
        for ending in PATTERNS:
            exported = file(ending).read_bytes()
            run("unroll", design, "--to", file(ending), "--for", "fold")
            check(file(ending).read_bytes() == exported, f"torse {name}: unroll and export write the same {ending}")
            run("fold", design, "--pattern", file(ending))
        for one, other in (("step", "stp"), ("igs", "iges")):
            # The file name stands in neither.
            check(file(one).read_bytes() == file(other).read_bytes(), f"torse {name}: {one} and {other} are the same")
        for ending in PICTURES:
            run("draw", design, "--to", file(f"picture.{ending}"))
        for form in ("csv", "json"):
            run("eval", design, "--grid", "8x2", "--format", form, to=file(f"values.{form}"))
        check(failures == before, f"torse {name}: inspect, unroll, fold, export to {len(FORMATS)} formats, draw, eval")


def built():
    """The command, built."""
    build = ["cargo", "build", "-q", "-p", "torse", "--message-format", "json-render-diagnostics"]
    lines = subprocess.run(build, cwd=ROOT, check=True, stdout=subprocess.PIPE, text=True).stdout.splitlines()
    programs = [json.loads(line).get("executable") for line in lines]
    return next(program for program in programs if program and Path(program).stem == "torse")


def check_folder(folder):
    manifest = json.loads((folder / "manifest.json").read_text())
    kinds = {
        "drawings": [check_dxf, check_svg],
        "patterns": [check_pattern],
        "outlines": [check_outline, check_outline_svg],
        "meshes": [check_mesh, check_glb],
        "models": [check_model],
    }
    for kind, checks in kinds.items():
        for entry in manifest.get(kind, []):
            for one in checks:
                one(folder, entry)


def check_all(folder, torse):
    library, commands = folder / "library", folder / "command"
    designs = sorted((ROOT / "designs").glob("*.toml"))
    for kept, arguments in (
        (library, ["torse-exchange", "--example", "files", "--", library]),
        (commands, ["torse-designs", "--example", "expected", "--", "designs", commands]),
    ):
        kept.mkdir(parents=True, exist_ok=True)
        subprocess.run(["cargo", "run", "-q", "-p", *map(str, arguments)], cwd=ROOT, check=True)
    check_folder(library)
    written_by_the_command(torse, designs, commands)
    for design in designs:
        check_pictures(commands, design.stem)
        check_values(commands, design.stem)
    check_folder(commands)


def main():
    arguments = argparse.ArgumentParser(description="Independent readers open what torse writes.")
    arguments.add_argument("--files", type=Path, help="a folder for the files, which are thrown away otherwise")
    arguments.add_argument("--torse", help="the command; built here otherwise")
    given = arguments.parse_args()
    torse = given.torse or built()
    if given.files:
        check_all(given.files.resolve(), torse)
    else:
        with tempfile.TemporaryDirectory() as temporary:
            check_all(Path(temporary).resolve(), torse)
    print(f"{failures} failed")
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
