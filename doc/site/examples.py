# SPDX-License-Identifier: LGPL-2.1-or-later
"""Examples in Python as pages: percent-format files are run cell by cell, and each cell is followed by what it prints and draws.

As a program (run_cells): examples.py FILE FOLDER runs the cells of FILE in FOLDER and writes cells.json there.
"""
import ast
import contextlib
import hashlib
import io
import json
import os
import pathlib
import re
import shutil
import subprocess
import sys


def cells_of(text):
    """Returns the cells of a file, (is it text?, its lines)."""
    cells = []
    for line in text.splitlines():
        if match := re.match(r"# %%(.*)", line):
            cells.append(("[markdown]" in match[1], []))
        elif cells:
            cells[-1][1].append(re.sub(r"^# ?", "", line) if cells[-1][0] else line)
    return [(is_text, "\n".join(lines).strip("\n")) for is_text, lines in cells]


def run_cells(path, folder):
    """Runs the cells in a folder: the output of each, the last expression as Python prints it, and the pictures it draws."""
    import matplotlib
    matplotlib.use("Agg")
    from matplotlib import pyplot
    os.chdir(folder)
    names, result = {"__name__": "__main__"}, []
    for number, (is_text, text) in enumerate(cells_of(path.read_text(encoding="utf-8"))):
        if is_text:
            continue
        tree = ast.parse(text)
        last = ast.Expression(tree.body.pop().value) if tree.body and isinstance(tree.body[-1], ast.Expr) else None
        with contextlib.redirect_stdout(io.StringIO()) as output:
            exec(compile(tree, str(path), "exec"), names)
            value = eval(compile(last, str(path), "eval"), names) if last else None
            if value is not None and not pyplot.get_fignums():
                print(repr(value))
        pictures = []
        for i in pyplot.get_fignums():
            pictures.append(f"{path.stem}-{number}-{i}.svg")
            pyplot.figure(i).savefig(pictures[-1], bbox_inches="tight", metadata={"Date": None})
        pyplot.close("all")
        result.append({"output": output.getvalue().rstrip(), "pictures": pictures})
    pathlib.Path("cells.json").write_text(json.dumps(result), encoding="utf-8")


def page(path, results):
    """Returns the page of an example that was run."""
    lines, results = [], iter(results)
    for is_text, text in cells_of(path.read_text(encoding="utf-8")):
        if is_text:
            lines += [text, ""]
            continue
        lines += ["```python", text, "```", ""]
        result = next(results)
        if result["output"]:
            lines += ["```text", result["output"], "```", ""]
        lines += [f"![The picture of the lines above]({name})\n" for name in result["pictures"]]
    return "\n".join(lines)


def make_pages(folder, target, program, cache):
    """Makes the pages of all examples in a folder, which are run unless the cache has their results."""
    target.mkdir()
    names = []
    for path in sorted(folder.glob("*.py")):
        key = hashlib.sha256(path.read_bytes() + program.read_bytes()).hexdigest()[:24]
        kept = cache / f"example-{key}"
        if not (kept / "cells.json").exists():
            kept.mkdir(parents=True, exist_ok=True)
            environment = {**os.environ, "SIGNORINI": str(program), "PYTHONDONTWRITEBYTECODE": "1", "PYTHONPATH": os.pathsep.join(
                [str(folder.parent), str(program.parent), os.environ.get("PYTHONPATH", "")])}
            subprocess.run([sys.executable, __file__, path, kept], env=environment, check=True, stdout=subprocess.DEVNULL)
        for picture in kept.glob("*.svg"):
            shutil.copyfile(picture, target / picture.name)
        results = json.loads((kept / "cells.json").read_text(encoding="utf-8"))
        (target / f"{path.stem}.md").write_text(page(path, results), encoding="utf-8")
        names.append(path.stem)
    (target / "index.md").write_text(
        "# Python\n\nExamples that the site's build has run; [the manual](../doc/manual.md#in-python) has the functions.\n\n"
        "```{toctree}\n" + "\n".join(names) + "\n```\n", encoding="utf-8")


if __name__ == "__main__":
    run_cells(pathlib.Path(sys.argv[1]).resolve(), sys.argv[2])
