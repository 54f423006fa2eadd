# SPDX-License-Identifier: LGPL-2.1-or-later
"""The Python module: the example of the manual, tables and fields against the files, its wheel and its types; skipped (127)
without numpy.
usage: module.py PROGRAM ROOT"""
import csv
import importlib.util
import json
import os
import re
import subprocess
import sys
import textwrap

program, root = map(os.path.realpath, sys.argv[1:3])
sys.dont_write_bytecode = True
sys.path.insert(0, os.path.join(root, "python"))
try:
    import numpy as np
except ImportError:  # the python3 found first may be another one than Debian's, which has the package
    if os.path.exists("/usr/bin/python3") and sys.executable != "/usr/bin/python3":
        os.execv("/usr/bin/python3", ["/usr/bin/python3", *sys.argv])
    print("SKIP there is no numpy (package python3-numpy)")
    sys.exit(127)
import signorini
import signorini.arrays
import signorini.results

os.environ["SIGNORINI"] = program
failures = 0


def check(name, fact):
    global failures
    failures += not fact
    print(f"{name}: {'ok' if fact else 'FAILED'}")


# The example runs in a folder that has its scene, with fewer levels.
os.mkdir("prm")
with open(os.path.join(root, "prm/pressed_plate.prm"), encoding="utf-8") as scene, open("prm/pressed_plate.prm", "w", encoding="utf-8") as few:
    text, number = re.subn(r"(?m)^  set Finest level .*$", "  set Finest level = 4", scene.read())
    few.write(text)
check("the scene states its levels", number == 1)
with open(os.path.join(root, "doc/manual.md"), encoding="utf-8") as manual:
    example = re.search(r"(?m)^    import signorini\n(    .*\n)+", manual.read()).group()
names = {}
exec(textwrap.dedent(example), names)
check("the last run of the example", names["point"] == {"push": 0.002} and names["run"].verdict == "certified")

run = signorini.read("results/pressed_plate")
with open("results/pressed_plate/answer.json", encoding="utf-8") as file:
    check("the answer is that of the file", run.answer == json.load(file))
with open("results/pressed_plate/convergence.csv", encoding="utf-8") as file:
    last = list(csv.DictReader(file))[-1]
check("the last level", run.level == int(last["level"]) == 5)
check("the last row", all(run.table[name][-1] == float(text) for name, text in last.items() if text))
contact = run.contact()
force = sum(-contact["p_H"] * contact["patch_length"] / [sum(contact["patch"] == n) for n in contact["patch"]])
check("the force is the sum of pressures", abs(force / float(last["contact_force_n"]) - 1) < 1e-12)
points, cells, fields = run.fields()
check("fields at points", len(points) == len(fields["von_mises_stress"]) and cells.max() == len(points) - 1)
check("displacements are vectors", fields["displacement"].shape == points.shape)
check("another level", len(run.contact(level=4)["p_H"]) * 2 == len(contact["p_H"]))

shown = repr(run)
check("a run shows its force and its error", re.search(
    r"certified\n  contact force \(0, 1\.19\d+\), per unit of thickness; error at most \S+ along the normal\n  peak pressure \S+ \(force/length², "
    r"positive in compression\) on bottom, .*\n  the error is .* guaranteed", shown) is not None)
entries = run.parameters
check("it has the entries of its scene", "push=0.004" in entries["Constants/Values"].replace(" ", ""))
check("  and says what forces refer to", [signorini.results.convention({**entries, **change}) for change in (
    {"Geometry/Thickness": "10"}, {"Material/Plane state": "axisymmetric"}, {"Dimension": "3"})] ==
      [", for the thickness 10", ", all around the axis", ""])
points = [(point, repr(low)) for point, low in signorini.sweep(
    "prm/pressed_plate.prm", "results/any", push=(0.002,), **{"Material/Young's modulus": ["1/3"], "Discretization/Finest level": 3})]
check("any entry is swept, expressions too; what has one value is set", len(points) == 1 and
      points[0][0] == {"push": 0.002, "Material/Young's modulus": "1/3"} and "results/any/0.002_1_3, level 3" in points[0][1])
try:
    list(signorini.sweep("prm/pressed_plate.prm", "results/any", push=["1/3", "1_3"]))
    check("two runs in one folder are refused", False)
except ValueError as error:
    check("two runs in one folder are refused", "one folder" in str(error))
step = np.linspace(0., 1., 9)
x, y = (axis.ravel() for axis in np.meshgrid(2. * step, step))
quads = [[9 * j + i, 9 * j + i + 1, 9 * j + i + 10, 9 * j + i + 9] for j in range(8) for i in range(8)]
pushed = np.stack([0. * x, -0.002 * (1. - 0.2 * x)], axis=1)
verified = signorini.verify("prm/pressed_plate.prm", (np.stack([x, y], axis=1), quads, pushed), "results/verified")
check("a displacement from arrays is verified", verified["guaranteed"] and verified["points"] == 81 and
      all(side["miss"]["value"] < 1e-12 for side in verified["sides"] if "miss" in side))
points, corners, v, difference, error = signorini.arrays.read_verified("results/verified/verified.vtu")
check("  its cells are in a file", corners.shape == (64, 4) and abs(v[:, 1] + 0.002 * (1. - 0.2 * points[:, 0])).max() < 1e-12 and
      abs(np.sqrt((error**2).sum()) - verified["sum_of_cells"]) < 1e-12 and abs(difference).max() > 1e-3)
again = signorini.verify("prm/pressed_plate.prm", "results/verified/verified.vtu", "results/again")
check("  a file of it has the same error", abs(again["distance"] - verified["distance"]) < 1e-9 * verified["distance"])
try:
    signorini.verify("prm/pressed_plate.prm", ([[0., 0.]], [[0, 0]], [[0., 0.]]))
    check("rows that are no cells are refused", False)
except ValueError as error:
    check("rows that are no cells are refused", "rows of 2 points" in str(error))
low, high = signorini.read("results/sweep/0.001"), names["run"]
check("a constant changes the answer", low.answer["energy"] != high.answer["energy"])
try:
    signorini.run("prm/pressed_plate.prm", pull=1)
    check("an unknown constant is refused", False)
except signorini.Refused as refused:
    check("an unknown constant is refused in the program's sentence", "found 'pull', allowed: a constant (" in str(refused))
with open("results/pressed_plate/contact-05.csv", "wb") as file:
    file.write(b"side,p_H\n\xff\xfe")
try:
    run.contact()
    check("a damaged file is named", False)
except signorini.DamagedFile as damaged:
    check("a damaged file is named", "contact-05.csv is damaged" in str(damaged))

def python(*arguments, **options):
    """Starts this Python with its working directory at the root. Returns what it prints, None where it fails."""
    done = subprocess.run([sys.executable, *arguments], cwd=root, capture_output=True, text=True, check=False, **options)
    if done.returncode != 0:
        print(done.stdout + done.stderr)
    return done.stdout.strip() if done.returncode == 0 else None


absolute = os.path.abspath("results/sweep/0.001")
READ = f"""import sys; sys.modules['numpy'] = None
import signorini
assert not signorini.__file__.startswith({os.path.join(root, "python")!r})
print(signorini.read({absolute!r}))"""
wheel = python("-B", "-c", f"import sys; sys.path.insert(0, 'python'); import backend; print(backend.build_wheel({os.getcwd()!r}))")
check("its wheel is made", wheel is not None and os.path.exists(wheel))
shown = python("-c", READ, env={**os.environ, "PYTHONPATH": os.path.abspath(wheel)})
check("  and reads a run without numpy", shown == repr(signorini.read(absolute)))
# Packages of Debian that are no part of Python itself.
if importlib.util.find_spec("pip"):
    installed = os.path.abspath("installed")
    check("pip installs it without a network", python("-B", "-m", "pip", "install", "--no-index", "--target", installed, root) is not None and
          python("-c", READ, env={**os.environ, "PYTHONPATH": installed}) == repr(signorini.read(absolute)))
if importlib.util.find_spec("mypy"):
    check("its types agree", python("-m", "mypy", "--cache-dir", os.devnull) is not None)

print(f"{failures} failures")
sys.exit(failures > 0)
