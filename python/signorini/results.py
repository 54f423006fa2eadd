# SPDX-License-Identifier: LGPL-2.1-or-later
"""The results of a run in its folder."""
from __future__ import annotations

import functools
import json
import os
import re
from typing import TYPE_CHECKING, Any, Callable, Optional, TypeVar, Union

if TYPE_CHECKING:
    from .arrays import Array, Columns

Path = Union[str, "os.PathLike[str]"]
Content = TypeVar("Content")


class DamagedFile(Exception):
    """A file of a run in which names, numbers or bytes are missing or wrong."""


class Refused(Exception):
    """The sentence with which the program refuses its input, or ends with another error."""


def names_damaged_file(read_file: Callable[..., Content]) -> Callable[..., Content]:
    """Lets a function of a path say which file has numbers, names or bytes that are missing or wrong."""
    @functools.wraps(read_file)
    def read_or_name(path: Path, *arguments: Any) -> Content:
        try:
            return read_file(path, *arguments)
        except (OSError, ImportError):
            raise
        except Exception as error:
            raise DamagedFile(f"{path} is damaged or incomplete ({type(error).__name__})") from error
    return read_or_name


@names_damaged_file
def read_json(path: Path) -> dict[str, Any]:
    """Returns the content of a JSON file."""
    with open(path, encoding="utf-8") as file:
        content: dict[str, Any] = json.load(file)
    return content


@names_damaged_file
def read_parameters(path: Path) -> dict[str, str]:
    """Returns the entries of parameters.prm, {"Section/Name": text}."""
    entries, section = {}, ""
    with open(path, encoding="utf-8") as file:
        for line in file:
            if match := re.match(r"\s*subsection\s+(.*\S)", line):
                section = match[1] + "/"
            elif re.match(r"\s*end\s*$", line):
                section = ""
            elif match := re.match(r"\s*set\s+(.*?)\s*=\s*(.*?)\s*$", line):
                entries[section + match[1]] = match[2]
    return entries


class Run:
    """The results of a run in a folder, and on the screen its answer with units and its error.

    folder: where the files are. level: the number of the finest level. verdict: the program's word on the run, "certified",
    "equations certified", ... certificate: the content of certificate.json. Raises FileNotFoundError where the folder has no
    results, DamagedFile where a file is cut or wrong."""

    def __init__(self, folder: Path) -> None:
        self.folder = os.fspath(folder)
        self.certificate = read_json(self.path("certificate.json"))
        self.verdict: str = self.certificate["verdict"]
        if not self.certificate["levels"]:
            raise FileNotFoundError("a level in certificate.json")
        self.level = int(self.certificate["levels"][-1]["level"])

    def __repr__(self) -> str:
        lines = [f"{self.folder}, level {self.level}: {self.verdict}"]
        try:
            lines += answer_lines(self.answer, self.parameters)
        except (OSError, DamagedFile, KeyError):
            lines += ["no answer yet"]
        return "\n  ".join(lines + [self.certificate["accuracy"]] * bool(self.certificate.get("accuracy")))

    def path(self, name: str) -> str:
        """Returns the path of a file in the folder."""
        return os.path.join(self.folder, name)

    @property
    def answer(self) -> dict[str, Any]:
        """The content of answer.json: forces (force, in the plane per thickness or for Geometry/Thickness), pressures and
        stresses (force/length²), zones (length), energy (force × length) of the finest level."""
        return read_json(self.path("answer.json"))

    @property
    def parameters(self) -> dict[str, str]:
        """Every entry of the run with its text, {"Section/Name": text}."""
        return read_parameters(self.path("parameters.prm"))

    @property
    def verified(self) -> dict[str, Any]:
        """The content of verified.json: the error of the displacement of another program; roots of energies, and relative."""
        return read_json(self.path("verified.json"))

    @functools.cached_property
    def table(self) -> Columns:
        """The columns of convergence.csv, one number for each level, coarsest first; NaN where a field is empty."""
        from .arrays import read_csv
        return read_csv(self.path("convergence.csv"))

    @property
    def cases(self) -> Columns:
        """The columns of cases.csv: the load cases, one row each."""
        from .arrays import read_csv
        return read_csv(self.path("cases.csv"))

    def of_level(self, name: str, ending: str, level: Optional[int] = None, case: Optional[int] = None) -> str:
        """Returns the path of a file of a level, the finest unless another is named, or of a load case."""
        number = f"case-{case:06}" if case is not None else f"{self.level if level is None else level:02}"
        return self.path(f"{name}-{number}.{ending}")

    def contact(self, level: Optional[int] = None, case: Optional[int] = None) -> Columns:
        """Returns the columns of contact-LL.csv, of the finest level unless another is named, or of a load case: p_H
        (force/length², negative in compression), the displacement and the gap (length) along the contact sides."""
        from .arrays import read_csv
        return read_csv(self.of_level("contact", "csv", level, case))

    def fields(self, level: Optional[int] = None, case: Optional[int] = None) -> tuple[Array, Array, dict[str, Array]]:
        """Returns points (n, 3) (length), cells (m, corners), and fields at points, {name: (n,) or (n, components)}, of
        solution-LL.vtu: displacement (length), stress (force/length², positive in tension), ..."""
        from .arrays import read_vtu
        return read_vtu(self.of_level("solution", "vtu", level, case))


read = Run


def convention(parameters: dict[str, str]) -> str:
    """Returns what forces refer to: bodies in the plane have a thickness."""
    thickness = float(parameters["Geometry/Thickness"])
    return ("" if parameters["Dimension"] == "3" else
            ", all around the axis" if parameters["Material/Plane state"] == "axisymmetric" else
            ", per unit of thickness" if thickness == 1 else f", for the thickness {thickness:g}")


def answer_lines(answer: dict[str, Any], parameters: dict[str, str]) -> list[str]:
    """Returns the lines of a run's force, its peak and its energy, with what is guaranteed of them."""
    force: list[float] = answer["contact_force"]["force"]
    largest = max(abs(part) for part in force)
    error = answer["contact_force"]["error"]
    lines = ["contact force (" + ", ".join(f"{part if abs(part) > 1e-12 * largest else 0.:.6g}" for part in force) + ")"
             + convention(parameters) + (f"; error at most {error:.2g} along the normal" if error is not None else "")]
    if peak := answer["peak_pressure"]:
        lines += [f"peak pressure {peak['value']:.6g} (force/length², positive in compression) on {peak['side']}, {peak['trend']}"]
    return lines
