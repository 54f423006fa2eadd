# SPDX-License-Identifier: LGPL-2.1-or-later
"""Makes the wheel and the source archive of the module with Python alone, as pip asks for them (PEP 517). The folder is that of
pyproject.toml."""
from __future__ import annotations

import base64
import hashlib
import pathlib
import tarfile
import tomllib
import zipfile
from typing import Any

FOLDER = pathlib.Path("python")
with open("pyproject.toml", "rb") as project_file:
    PROJECT = tomllib.load(project_file)["project"]
NAME = f"{PROJECT['name']}-{PROJECT['version']}"


def metadata() -> str:
    """Returns the text of METADATA."""
    lines = ["Metadata-Version: 2.1", f"Name: {PROJECT['name']}", f"Version: {PROJECT['version']}",
             f"Summary: {PROJECT['description']}", f"License: {PROJECT['license']['text']}",
             f"Requires-Python: {PROJECT['requires-python']}"]
    for extra, packages in PROJECT["optional-dependencies"].items():
        lines += [f"Provides-Extra: {extra}", *(f"Requires-Dist: {package}; extra == '{extra}'" for package in packages)]
    return "\n".join(lines) + "\n"


def build_wheel(wheel_directory: str, config_settings: Any = None, metadata_directory: Any = None) -> str:
    """Writes the wheel into a folder. Returns its name."""
    files = {str(path.relative_to(FOLDER)): path.read_bytes() for path in sorted(FOLDER.glob("signorini/*"))
             if path.suffix in (".py", ".typed")}
    files[f"{NAME}.dist-info/METADATA"] = metadata().encode()
    files[f"{NAME}.dist-info/WHEEL"] = b"Wheel-Version: 1.0\nGenerator: signorini\nRoot-Is-Purelib: true\nTag: py3-none-any\n"
    record = f"{NAME}.dist-info/RECORD"
    lines = []
    for name, content in files.items():
        digest = base64.urlsafe_b64encode(hashlib.sha256(content).digest()).rstrip(b"=").decode()
        lines.append(f"{name},sha256={digest},{len(content)}\n")
    files[record] = "".join([*lines, f"{record},,\n"]).encode()
    wheel = f"{NAME}-py3-none-any.whl"
    with zipfile.ZipFile(pathlib.Path(wheel_directory) / wheel, "w", zipfile.ZIP_DEFLATED) as archive:
        for name, content in files.items():
            archive.writestr(zipfile.ZipInfo(name), content)
    return wheel


def build_sdist(sdist_directory: str, config_settings: Any = None) -> str:
    """Writes the source archive into a folder. Returns its name."""
    archive = f"{NAME}.tar.gz"
    with tarfile.open(pathlib.Path(sdist_directory) / archive, "w:gz") as tar:
        for path in [pathlib.Path("pyproject.toml"), *sorted(FOLDER.glob("*.py")), *sorted(FOLDER.glob("signorini/*.py")),
                     FOLDER / "signorini/py.typed"]:
            tar.add(path, f"{NAME}/{path}")
    return archive
