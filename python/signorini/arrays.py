# SPDX-License-Identifier: LGPL-2.1-or-later
"""The files of a run as arrays (needs Python's numpy), and a displacement as a file."""
from __future__ import annotations

import base64
import csv
import itertools
import xml.etree.ElementTree as ElementTree
import zlib
from typing import Any, Collection, Iterable, Optional, Sequence

import numpy as np
import numpy.typing as npt

from .results import Path, names_damaged_file

Array = npt.NDArray[Any]
Columns = dict[str, Array]


@names_damaged_file
def read_csv(path: Path) -> Columns:
    """Returns the columns of a table: arrays of numbers, NaN where a field is empty, or of words, such as names of sides."""
    with open(path, encoding="utf-8", newline="") as file:
        rows = list(csv.DictReader(file))
    def column(name: str) -> Array:
        texts = [row[name] for row in rows]
        if name in ("side", "with"):
            return np.array(texts)
        try:
            return np.array([float(text) if text else np.nan for text in texts])
        except ValueError:
            return np.array(texts)
    return {name: column(name) for name in (rows[0] if rows else {})}


def decode(array: ElementTree.Element) -> Array:
    """Returns the numbers of a <DataArray>: blocks that are compressed by zlib, in base 64."""
    kind = {"Float32": "<f4", "Float64": "<f8", "Int32": "<i4", "UInt8": "u1"}[array.attrib["type"]]
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
def read_vtu(path: Path, names: Optional[Collection[str]] = None) -> tuple[Array, Array, dict[str, Array]]:
    """Returns points, cells (corners in a row) and fields at points, all or those that are named; the pieces of all ranks
    together."""
    points: list[Array] = []
    cells: list[Array] = []
    fields: dict[str, list[Array]] = {}
    n = 0
    def part(piece: ElementTree.Element, name: str) -> Array:
        return decode(next(piece.iterfind(name)))
    for piece in ElementTree.parse(path).iter("Piece"):
        n_cells, n_points = int(piece.attrib["NumberOfCells"]), int(piece.attrib["NumberOfPoints"])
        if n_cells == 0:
            continue
        points.append(part(piece, "Points/DataArray").reshape(-1, 3).astype(float))
        cells.append(part(piece, "Cells/DataArray[@Name='connectivity']").reshape(n_cells, -1) + n)
        for array in piece.iterfind("PointData/DataArray"):
            name = array.attrib["Name"]
            if names is not None and name not in names:
                continue
            values = decode(array).astype(float).reshape(n_points, -1)
            fields.setdefault(name, []).append(values[:, 0] if values.shape[1] == 1 else values)
        n += n_points
    return np.concatenate(points), np.concatenate(cells), {k: np.concatenate(v) for k, v in fields.items()}


@names_damaged_file
def read_verified(path: Path) -> tuple[Array, Array, Array, Array, Array]:
    """Returns points (n, 3), corners of cells (m, 4), that of a triangle with its last one twice, v and v - u_h at points (n, 3),
    and the errors of cells (m), of verified.vtu."""
    arrays = {array.attrib["Name"]: decode(array) for array in ElementTree.parse(path).iter("DataArray")}
    starts = np.append(0, arrays["offsets"][:-1])
    last = np.where(np.isin(arrays["types"], (5, 22)), 2, 3)
    corners = arrays["connectivity"][starts[:, None] + np.stack([0 * last, 0 * last + 1, 0 * last + 2, last], axis=1)]
    points, v, difference = (arrays[name].reshape(-1, 3) for name in ("Points", "displacement", "difference"))
    return points, corners, v, difference, arrays["error"]


def write_vtu(path: Path, points: Any, cells: Iterable[Sequence[int]], displacement: Any) -> None:
    """Writes a displacement at points of a plane mesh; cells are rows of 3, 4, 6, 8 or 9 point numbers in VTK's order."""
    kinds = {3: 5, 4: 9, 6: 22, 8: 23, 9: 28}
    rows = [[int(point) for point in cell] for cell in cells]
    if wrong := {len(row) for row in rows} - set(kinds):
        raise ValueError(f"cells: found rows of {min(wrong)} points, allowed: 3, 4, 6, 8, 9")
    def vectors(name: str, values: Any) -> str:
        values = np.asarray(values, dtype=float)
        if values.ndim != 2 or len(values) != len(points) or values.shape[1] not in (2, 3):
            raise ValueError(f"{name}: found the shape {values.shape}, allowed: ({len(points)}, 2) or ({len(points)}, 3)")
        values = np.pad(values, [(0, 0), (0, 3 - values.shape[1])])
        return array(f'type="Float64" NumberOfComponents="3" Name="{name}"', (repr(float(x)) for x in values.ravel()))
    def array(attributes: str, words: Iterable[object]) -> str:
        return f'<DataArray {attributes} format="ascii">\n{" ".join(map(str, words))}\n</DataArray>\n'
    with open(path, "w", encoding="utf-8") as file:
        file.write(f'<VTKFile type="UnstructuredGrid" version="0.1" byte_order="LittleEndian">\n<UnstructuredGrid>\n'
                   f'<Piece NumberOfPoints="{len(points)}" NumberOfCells="{len(rows)}">\n'
                   f'<Points>\n{vectors("points", points)}</Points>\n<Cells>\n'
                   + array('type="Int64" Name="connectivity"', (point for row in rows for point in row))
                   + array('type="Int64" Name="offsets"', itertools.accumulate(map(len, rows)))
                   + array('type="UInt8" Name="types"', (kinds[len(row)] for row in rows))
                   + f'</Cells>\n<PointData>\n{vectors("displacement", displacement)}</PointData>\n'
                   "</Piece>\n</UnstructuredGrid>\n</VTKFile>\n")
