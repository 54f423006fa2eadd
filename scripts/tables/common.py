# SPDX-License-Identifier: LGPL-2.1-or-later
"""What all tables of doc/measured need: runs of the program, tables that tests write, numbers as texts."""
import csv
import functools
import itertools
import os
import subprocess
import tempfile

import signorini

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.realpath(__file__))))
PROGRAM = os.path.abspath(os.environ.get("SIGNORINI", ROOT + "/build/release/source/signorini"))
os.environ["SIGNORINI"] = PROGRAM
TABLES = {}
# The results of runs, as long as this process lives.
FOLDER = tempfile.TemporaryDirectory()
NUMBERS = itertools.count()

GRADED = {"Discretization/Strategy": "hp"}
WITHOUT_ERRORS = {"Output/Errors": "false", "Output/Inf-sup constant": "false"}


def table(*columns):
    """Registers a function that makes the rows of a table."""
    def register(make):
        TABLES[make.__name__] = columns, make
        return make
    return register


def solve(scene, settings=None):
    """Returns the results of prm/SCENE.prm."""
    folder = f"{FOLDER.name}/{next(NUMBERS)}"
    return signorini.run(f"{ROOT}/prm/{scene}.prm", folder, **{"Output/VTU": "none", **(settings or {})})


def measure(scene, settings=None):
    """Returns the columns of convergence.csv of prm/SCENE.prm."""
    return solve(scene, settings).table


@functools.lru_cache(maxsize=None)
def folder_of_test(floor, name):
    """Runs a test with its long tables, once. Returns the folder of the files that it writes."""
    folder = f"{FOLDER.name}/{next(NUMBERS)}"
    os.mkdir(folder)
    done = subprocess.run([f"{os.path.dirname(os.path.dirname(PROGRAM))}/tests/test_{floor}", name, "long"], cwd=folder,
                          capture_output=True, text=True, check=False)
    if done.returncode != 0:
        raise signorini.Refused("\n".join(line for line in done.stdout.splitlines() if not line.endswith(": ok")) + done.stderr)
    return folder


def rows_of_test(floor, name, file):
    """Returns the rows of a file that a test with its long tables writes."""
    with open(f"{folder_of_test(floor, name)}/{file}", encoding="utf-8", newline="") as table_of_test:
        return list(csv.reader(table_of_test))


def committed(name):
    """Returns the rows of a table as it is, without their head."""
    with open(f"{ROOT}/doc/measured/{name}.csv", encoding="utf-8", newline="") as file:
        return list(csv.reader(file))[1:]


def levels(coarsest, finest_level):
    return {"Discretization/Coarsest level": coarsest, "Discretization/Finest level": finest_level}


def finest(level):
    return {"Discretization/Finest level": level}


def target(error):
    return {**GRADED, "Discretization/Target error": error}


def number(x, digits=3):
    text = f"{x:.{digits}g}"
    return f"{float(text):.0f}" if "e+" in text else text


def power(x, digits=1):
    """Returns 1.2e-3 for 0.0012; nothing for what is not known."""
    return "" if x != x else f"{x:.{digits}e}".replace("e-0", "e-").replace("e+0", "e+").replace("e+0", "")


def per_cent(x, digits=2):
    return f"{100 * x:+.{digits}f} %"
