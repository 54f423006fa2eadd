# SPDX-License-Identifier: LGPL-2.1-or-later
"""Runs of the program: one, several, and one that verifies the result of another program."""
from __future__ import annotations

import itertools
import os
import re
import shutil
import subprocess
import tempfile
from typing import Any, Iterable, Iterator, Optional, Union

from .results import Path, Refused, Run

Setting = Union[str, bool, float]
"""The value of a constant or of an entry: a text, as in a parameter file, or a number."""


def find_program() -> str:
    """Returns the program that $SIGNORINI names, that of the installation or build tree of this file, or that on the path."""
    root = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
    candidates = [os.environ.get("SIGNORINI", ""), os.path.join(root, "signorini"), os.path.join(root, "../../bin/signorini"),
              os.path.join(root, "build/release/source/signorini"), shutil.which("signorini") or ""]
    for path in candidates:
        if os.path.isfile(path) and os.access(path, os.X_OK):
            return path
    raise FileNotFoundError("the program signorini: install it, or name it in the environment variable SIGNORINI")


def run(scene: Path, output: Optional[Path] = None, /, **settings: Setting) -> Run:
    """Runs a scene and returns its results, whatever the verdict.

    scene: the parameter file. output: the folder of the results, by default results/NAME. settings: values of constants by
    name, r=4, and of entries by section and name, **{"Discretization/Strategy": "hp"}, in the units of the scene. Raises
    Refused where the program ends without results."""
    folder = os.fspath(output or os.path.join("results", os.path.splitext(os.path.basename(scene))[0]))
    command = [find_program(), os.fspath(scene), "--output", folder]
    for name, value in settings.items():
        command += ["--set", f"{name}={text_of(value)}"]
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    if done.returncode not in (0, 2):
        raise Refused(done.stderr.strip() or f"exit code {done.returncode}")
    return Run(folder)


def verify(scene: Path, field: Union[Path, tuple[Any, Any, Any]], output: Optional[Path] = None, /,
           **settings: Setting) -> dict[str, Any]:
    """Runs a scene, verifies the displacement of another program with it, and returns the content of verified.json.

    field: a file (.vtu), or (points, cells, displacement) of a plane mesh: points (n, 2) and the displacement at them (n, 2) in
    the scene's unit of length, cells as rows of 3, 4, 6, 8 or 9 point numbers in VTK's order. The other arguments, and what is
    raised: as for run()."""
    with tempfile.TemporaryDirectory() as folder:
        if isinstance(field, tuple):
            from .arrays import write_vtu
            path = os.path.join(folder, "field.vtu")
            write_vtu(path, *field)
        else:
            path = os.path.abspath(field)
        settings["Verify/File"] = path
        return run(scene, output, **settings).verified


def sweep(scene: Path, output: Path, /,
          **settings: Union[Setting, Iterable[Setting]]) -> Iterator[tuple[dict[str, Setting], Run]]:
    """Yields ({name: value}, run) for all combinations of values; each run has a folder in output, named by its values.

    settings: as for run(), but a list, tuple, range or array has several values: sweep(scene, output, push=[0.001, 0.002],
    **{"Material/Young's modulus": [1, 2], "Output/Bound": False}) makes four runs. Raises ValueError where none has several
    values or two runs would have one folder, and Refused as run() does."""
    lists: dict[str, list[Setting]] = {}
    fixed: dict[str, Setting] = {}
    for name, values in settings.items():
        if isinstance(values, (str, bool, float, int)) or not hasattr(values, "__iter__"):
            fixed[name] = values  # type: ignore[assignment]  # numbers of numpy among them
        else:
            lists[name] = list(values)
    points = [dict(zip(lists, values)) for values in itertools.product(*lists.values())]
    folders = [folder_of(point.values()) for point in points]
    if not lists or len(set(folders)) < len(folders):
        raise ValueError("sweep: found " + ("no list of values" if not lists else "two runs with one folder") +
                         ", allowed: lists of values that differ in their letters and digits")
    for point, folder in zip(points, folders):
        yield point, run(scene, os.path.join(output, folder), **{**fixed, **point})


def text_of(value: Setting) -> str:
    """Returns a value as a parameter file has it: all digits of a number, true or false."""
    return str(value).lower() if isinstance(value, bool) else repr(float(value)) if isinstance(value, float) else str(value)


def folder_of(values: Iterable[Setting]) -> str:
    """Returns the name of the folder of a run of a sweep, as the program's --sweep names it: values with '_' between them and in
    place of characters that are no letters or digits, and none of .-+=^*()."""
    names = [re.sub(r"[^A-Za-z0-9.+=^*()-]", "_", text_of(value)[:80]) for value in values]
    return "_".join(f"_{name}" if name[:1] in ("", ".", "-") else name for name in names)
