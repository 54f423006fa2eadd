# SPDX-License-Identifier: LGPL-2.1-or-later
"""Runs the program signorini and reads its results (package python3-numpy).

    import signorini
    run = signorini.run("prm/pressed_plate.prm", push=0.004)   # constants by name, other entries by overrides={...}
    run = signorini.read("results/pressed_plate")              # or the results of a run that is over
    run                                                        # shows the level, the answer and its error
    run.answer["contact_force"]["force"], run.table["bound_relative"][-1]
    run.contact()["p_H"], run.fields()[2]["von_mises_stress"]
    signorini.verify("prm/pressed_plate.prm", "other.vtu")["upper"]  # the error of another program's displacement
    for point, run in signorini.sweep("prm/pressed_plate.prm", "results/sweep", push=[0.001, 0.002]):
        ...                                                    # point is {"push": 0.001}, then {"push": 0.002}

Names, units and signs are those of doc/output.md.
"""
import base64
import csv
import functools
import itertools
import json
import os
import re
import shutil
import subprocess
import tempfile
import xml.etree.ElementTree as ElementTree
import zlib

import numpy as np


class DamagedFile(Exception):
    """A file of a run that does not hold what it should."""


class Refused(Exception):
    """The sentence with which the program refuses its input, or ends with another error."""


def names_damaged_file(read):
    """Lets a function of a path say which file has numbers, names or bytes that are missing or wrong."""
    @functools.wraps(read)
    def read_or_name(path, *arguments):
        try:
            return read(path, *arguments)
        except OSError:
            raise
        except Exception as error:
            raise DamagedFile(f"{path} is damaged or incomplete ({type(error).__name__})") from error
    return read_or_name


@names_damaged_file
def read_csv(path):
    """Returns the columns of a table: arrays of numbers, NaN where a field is empty, or of words, such as names of sides."""
    with open(path, encoding="utf-8", newline="") as file:
        rows = list(csv.DictReader(file))
    def column(name):
        texts = [row[name] for row in rows]
        if name in ("side", "with"):
            return np.array(texts)
        try:
            return np.array([float(text) if text else np.nan for text in texts])
        except ValueError:
            return np.array(texts)
    return {name: column(name) for name in (rows[0] if rows else {})}


def decode(array):
    """Returns the numbers of a <DataArray>: blocks that are compressed by zlib, in base 64."""
    kind = {"Float32": "<f4", "Float64": "<f8", "Int32": "<i4", "UInt8": "u1"}[array.get("type")]
    text = "".join((array.text or "").split())
    n_blocks = int(np.frombuffer(base64.b64decode(text[:8])[:4], "<u4")[0])
    end = 4 * ((4 * (3 + n_blocks) + 2) // 3)
    sizes = np.frombuffer(base64.b64decode(text[:end]), "<u4")[3:3 + n_blocks]
    data, blocks, start = base64.b64decode(text[end:]), [], 0
    for size in sizes:
        blocks.append(zlib.decompress(data[start:start + size]))
        start += size
    return np.frombuffer(b"".join(blocks), kind)


@names_damaged_file
def read_vtu(path, names=None):
    """Returns points, cells (corners in a row) and fields at points, all or those that are named; the pieces of all ranks
    together."""
    points, cells, fields, n = [], [], {}, 0
    for piece in ElementTree.parse(path).iter("Piece"):
        n_cells, n_points = int(piece.get("NumberOfCells")), int(piece.get("NumberOfPoints"))
        if n_cells == 0:
            continue
        points.append(decode(piece.find("Points/DataArray")).reshape(-1, 3).astype(float))
        cells.append(decode(piece.find("Cells/DataArray[@Name='connectivity']")).reshape(n_cells, -1) + n)
        for array in piece.iterfind("PointData/DataArray"):
            if names is not None and array.get("Name") not in names:
                continue
            values = decode(array).astype(float).reshape(n_points, -1)
            fields.setdefault(array.get("Name"), []).append(values[:, 0] if values.shape[1] == 1 else values)
        n += n_points
    return np.concatenate(points), np.concatenate(cells), {k: np.concatenate(v) for k, v in fields.items()}


@names_damaged_file
def read_verified(path):
    """Returns points (n, 3), corners of cells (m, 4), that of a triangle with its last one twice, v and v - u_h at points (n, 3),
    and the errors of cells (m), of verified.vtu."""
    arrays = {array.get("Name"): decode(array) for array in ElementTree.parse(path).iter("DataArray")}
    starts = np.append(0, arrays["offsets"][:-1])
    last = np.where(np.isin(arrays["types"], (5, 22)), 2, 3)
    corners = arrays["connectivity"][starts[:, None] + np.stack([0 * last, 0 * last + 1, 0 * last + 2, last], axis=1)]
    points, v, difference = (arrays[name].reshape(-1, 3) for name in ("Points", "displacement", "difference"))
    return points, corners, v, difference, arrays["error"]


def write_vtu(path, points, cells, displacement):
    """Writes a displacement at points of a plane mesh; cells are rows of 3, 4, 6, 8 or 9 point numbers in VTK's order."""
    kinds = {3: 5, 4: 9, 6: 22, 8: 23, 9: 28}
    cells = [[int(point) for point in cell] for cell in cells]
    if wrong := {len(cell) for cell in cells} - set(kinds):
        raise ValueError(f"cells: found rows of {min(wrong)} points, allowed: 3, 4, 6, 8, 9")
    def vectors(name, values):
        values = np.asarray(values, dtype=float)
        if values.ndim != 2 or len(values) != len(points) or values.shape[1] not in (2, 3):
            raise ValueError(f"{name}: found the shape {values.shape}, allowed: ({len(points)}, 2) or ({len(points)}, 3)")
        values = np.pad(values, [(0, 0), (0, 3 - values.shape[1])])
        return array(f'type="Float64" NumberOfComponents="3" Name="{name}"', (repr(float(x)) for x in values.ravel()))
    def array(attributes, words):
        return f'<DataArray {attributes} format="ascii">\n{" ".join(map(str, words))}\n</DataArray>\n'
    with open(path, "w", encoding="utf-8") as file:
        file.write(f'<VTKFile type="UnstructuredGrid" version="0.1" byte_order="LittleEndian">\n<UnstructuredGrid>\n'
                   f'<Piece NumberOfPoints="{len(points)}" NumberOfCells="{len(cells)}">\n'
                   f'<Points>\n{vectors("points", points)}</Points>\n<Cells>\n'
                   + array('type="Int64" Name="connectivity"', (point for cell in cells for point in cell))
                   + array('type="Int64" Name="offsets"', itertools.accumulate(map(len, cells)))
                   + array('type="UInt8" Name="types"', (kinds[len(cell)] for cell in cells))
                   + f'</Cells>\n<PointData>\n{vectors("displacement", displacement)}</PointData>\n'
                   "</Piece>\n</UnstructuredGrid>\n</VTKFile>\n")


@names_damaged_file
def read_json(path):
    """Returns the content of a JSON file."""
    with open(path, encoding="utf-8") as file:
        return json.load(file)


class Run:
    """The results of a run in a folder.

    table: the columns of convergence.csv. level: the finest. certificate: the content of certificate.json. verdict: its word
    on the run. Raises FileNotFoundError where the folder has no results, DamagedFile where a file is cut or wrong."""

    def __init__(self, folder):
        self.folder = folder
        self.table = read_csv(self.path("convergence.csv"))
        if not self.table:
            raise FileNotFoundError("a level in convergence.csv")
        self.level = int(self.table["level"][-1])
        self.certificate = read_json(self.path("certificate.json"))
        self.verdict = self.certificate["verdict"]

    def __repr__(self):
        lines = [f"{self.folder}, level {self.level}: {self.verdict}"]
        try:
            answer = self.answer
            peak = answer["peak_pressure"] or {}
            force = np.array(answer["contact_force"]["force"])
            force = ", ".join(f"{component:.6g}" for component in np.where(abs(force) > 1e-12 * abs(force).max(), force, 0.))
            lines += [f"contact force ({force})" + (f", peak pressure {peak['value']:.6g} on {peak['side']}" if peak else "")]
        except (OSError, DamagedFile, KeyError):
            lines += ["no answer yet"]
        return "\n  ".join(lines + [self.certificate["accuracy"]] * bool(self.certificate.get("accuracy")))

    def path(self, name):
        """Returns the path of a file in the folder."""
        return os.path.join(self.folder, name)

    @property
    def answer(self):
        """The content of answer.json: forces, peaks, zones, energy of the finest level."""
        return read_json(self.path("answer.json"))

    @property
    def cases(self):
        """The columns of cases.csv: the load cases, one row each."""
        return read_csv(self.path("cases.csv"))

    @property
    def verified(self):
        """The content of verified.json: the error of the displacement of another program."""
        return read_json(self.path("verified.json"))

    def of_level(self, name, ending, level=None, case=None):
        """Returns the path of a file of a level, the finest unless another is named, or of a load case."""
        number = f"case-{case:06}" if case is not None else f"{self.level if level is None else level:02}"
        return self.path(f"{name}-{number}.{ending}")

    def contact(self, level=None, case=None):
        """Returns the columns of contact-LL.csv, of the finest level unless another is named, or of a load case."""
        return read_csv(self.of_level("contact", "csv", level, case))

    def fields(self, level=None, case=None):
        """Returns points (n, 3), cells (m, corners) and fields at points, {name: (n,) or (n, components)}, of solution-LL.vtu."""
        return read_vtu(self.of_level("solution", "vtu", level, case))


read = Run


def find_program():
    """Returns the program beside this file, in the bin folder of its prefix, in $SIGNORINI or on the path."""
    here = os.path.dirname(os.path.abspath(__file__))
    places = [os.environ.get("SIGNORINI", ""), os.path.join(here, "signorini"), os.path.join(here, "../../bin/signorini"),
              os.path.join(here, "../build/release/source/signorini"), shutil.which("signorini") or ""]
    for place in places:
        if os.path.isfile(place) and os.access(place, os.X_OK):
            return place
    raise FileNotFoundError("the program signorini: install it, or name it in the environment variable SIGNORINI")


def run(scene, output=None, overrides=None, program=None, **constants):
    """Runs a scene and returns its results, whatever the verdict.

    scene: the parameter file. output: the folder of the results, by default results/NAME. constants: their values by name.
    overrides: the values of other entries, {"Discretization/Strategy": "hp", ...}. Raises Refused where the program ends
    without results."""
    folder = output or os.path.join("results", os.path.splitext(os.path.basename(scene))[0])
    command = [program or find_program(), scene, "--output", folder]
    for name, value in {**constants, **(overrides or {})}.items():
        command += ["--set", f"{name}={text_of(value)}"]
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    if done.returncode not in (0, 2):
        raise Refused(done.stderr.strip() or f"exit code {done.returncode}")
    return Run(folder)


def verify(scene, field, cells=None, displacement=None, output=None, overrides=None, program=None, **constants):
    """Runs a scene, verifies the displacement of another program with it, and returns the content of verified.json.

    field: a file (.vtu), or the points of a plane mesh (n, 2), with cells, rows of 3, 4, 6, 8 or 9 point numbers in VTK's order,
    and the displacement at points (n, 2). The other arguments, and what is raised: as for run()."""
    with tempfile.TemporaryDirectory() as folder:
        path = field
        if cells is not None:
            path = os.path.join(folder, "field.vtu")
            write_vtu(path, field, cells, displacement)
        return run(scene, output, {**(overrides or {}), "Verify/File": os.path.abspath(path)}, program, **constants).verified


def text_of(value):
    """Returns a value as a parameter file has it: all digits of a number, true or false."""
    return str(value).lower() if isinstance(value, bool) else repr(float(value)) if isinstance(value, float) else str(value)


def folder_of(values):
    """Returns the name of the folder of a run of a sweep, as the program's --sweep names it: values with '_' between them and in
    place of characters that are no letters or digits, and none of .-+=^*()."""
    names = [re.sub(r"[^A-Za-z0-9.+=^*()-]", "_", text_of(value)[:80]) for value in values]
    return "_".join(f"_{name}" if name[:1] in ("", ".", "-") else name for name in names)


def sweep(scene, output, overrides=None, program=None, **constants):
    """Yields ({name: value}, run) for all combinations of values; each run has a folder in output, named by its values.

    constants and overrides: as for run(), but a list, tuple, range or array has several values of a constant or of another entry:
    sweep(scene, output, {"Material/Young's modulus": [1, 2], "Output/Bound": False}, push=[0.001, 0.002]). Raises ValueError where
    none has several values or two runs would have one folder, and Refused as run() does."""
    given = {**constants, **(overrides or {})}
    lists = {name: list(values) for name, values in given.items() if not isinstance(values, str) and hasattr(values, "__iter__")}
    points = [dict(zip(lists, values)) for values in itertools.product(*lists.values())]
    folders = [folder_of(point.values()) for point in points]
    if not lists or len(set(folders)) < len(folders):
        raise ValueError("sweep: found " + ("no list of values" if not lists else "two runs with one folder") +
                         ", allowed: lists of values that differ in their letters and digits")
    for point, folder in zip(points, folders):
        yield point, run(scene, os.path.join(output, folder), {**given, **point}, program)
