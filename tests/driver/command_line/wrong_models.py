# SPDX-License-Identifier: LGPL-2.1-or-later
"""A block on a parabola, computed with eleven wrong models: --verify says of each that it is wrong, by how much more than the right
one, and where.
usage: wrong_models.py PROGRAM"""
import base64
import json
import os
import re
import struct
import subprocess
import sys
import tempfile
import zlib

program, failures = os.path.realpath(sys.argv[1]), 0
folder = tempfile.TemporaryDirectory()
os.chdir(folder.name)
SCENE = {"Geometry/Lower left": "-1, 0", "Geometry/Cells": "2, 1", "Boundary/Displacement": "top: 0; -0.05",
         "Boundary/Contact": "bottom", "Contact/Gap": "x^2/4"}
MESH = {"Discretization/Coarsest level": 4, "Discretization/Finest level": 4, "Output/Bound": "false",
        "Solver/Tolerated error": 10}
open("block.prm", "w").close()


def check(name, fact, found=""):
    global failures
    failures += not fact
    print(f"{name}: {'ok' if fact else f'FAILED, found {found}'}")


def run(output, entries, *options):
    command = [program, "block.prm", "--output", output, *options]
    for name, value in entries.items():
        command += ["--set", f"{name}={value}"]
    return subprocess.run(command, capture_output=True, text=True, check=False)


def verify(file, *options, **entries):
    """Returns verified.json, and what the screen says."""
    done = run("verified", {**SCENE, **entries}, "--verify", file, *options)
    with open("verified/verified.json", encoding="utf-8") as json_file:
        return json.load(json_file), done


def model(name, changes, shift=0.):
    """Returns the file of the displacement of a wrong model; all of it is moved by a shift along y."""
    entries = {**SCENE, **MESH, **changes}
    done = run(name, {key: value for key, value in entries.items() if value is not None})
    file = f"{name}/solution-04.vtu"
    if not os.path.exists(file):
        sys.exit(f"{name}: {done.stderr}")
    if shift:
        with open(file, encoding="utf-8") as text:
            content = text.read()
        # Arrays are 32 bits, compressed in one block: a header of four numbers, then the data.
        found = re.search(r'Name="displacement"[^>]*>\s*([^<]*?)\s*<', content)
        code = "".join(found.group(1).split())
        values = zlib.decompress(base64.b64decode(code[24:]))
        values = [*struct.unpack(f"<{len(values) // 4}f", values)]
        values[1::3] = [value + shift for value in values[1::3]]
        data = struct.pack(f"<{len(values)}f", *values)
        packed = zlib.compress(data)
        code = base64.b64encode(struct.pack("<4I", 1, len(data), len(data), len(packed))) + base64.b64encode(packed)
        file = f"{name}.vtu"
        with open(file, "w", encoding="utf-8") as text:
            text.write(content[:found.start(1)] + code.decode() + content[found.end(1):])
    return file


def error(certificate):
    return certificate["relative"]["value"]


def side(certificate, name):
    return next(entry for entry in certificate["sides"] if entry["side"] == name)


def force(certificate):
    return certificate["contact_force"][1]


right = model("right", {})
best, screen = verify(right)
check("the right model", 0.08 < error(best) < 0.1 and best["guaranteed"], error(best))
check("  its supports", side(best, "top")["miss"]["value"] < 1e-8)
check("  half of its error is at the ends of contact", abs(abs(best["largest_cell"]["point"][0]) - 0.2) < 0.1)
check("  its force", abs(force(best) / 0.0457896 - 1.) < 0.02, force(best))
check("  and the screen", all(word in screen.stdout for word in (
    "Verified  ", "Error of its displacement", "% of |||u||| (energy norm, guaranteed)", "Contact force", "Penetration",
    "Supports", "Largest error", "Best factor", "no other unit")))

# Name, changes, shift, the largest cell (None: anywhere), and a further fact of the certificate.
MODELS = [
    ("top free in x", {"Boundary/Displacement": None, "Boundary/Rollers": "top", "Contact/Gap": "x^2/4-0.05"}, -0.05, None,
     lambda c: abs(side(c, "top")["miss"]["vector"][0]) > 0.01),
    ("top lowered 5 % more", {"Boundary/Displacement": "top: 0; -0.0525"}, 0., None,
     lambda c: abs(side(c, "top")["miss"]["vector"][1] + 0.0025) < 1e-8 and abs(c["factor"] / best["factor"] - 1 / 1.05) < 0.01),
    ("Poisson's ratio", {"Material/Poisson's ratio": 0.25}, 0., None, lambda c: error(c) > 0.13),
    ("plane stress", {"Material/Plane state": "stress"}, 0., None, lambda c: error(c) > 0.15),
    ("gap times 0.9", {"Contact/Gap": "0.9*x^2/4"}, 0., None,
     lambda c: c["penetration"]["value"] < 0.2 * best["penetration"]["value"] and force(c) > 1.03 * force(best)),
    ("foundation moved", {"Contact/Gap": "(x-0.1)^2/4"}, 0., (0.31, 0.06), lambda c: c["penetration"]["value"] > 0.012),
    ("traction on the right", {"Boundary/Traction": "right: 0.005; 0"}, 0., None, lambda c: error(c) > 0.12),
    ("rollers on the left", {"Boundary/Rollers": "left"}, 0., None, lambda c: error(c) > 0.15)]
for name, changes, shift, place, fact in MODELS:
    certificate, _ = verify(model(name.replace(" ", "_"), changes, shift))
    if name != "gap times 0.9":
        check(name, error(certificate) > 1.1 * error(best), error(certificate))
    point = certificate["largest_cell"]["point"]
    if place:
        check("  where", abs(point[0] - place[0]) + abs(point[1] - place[1]) < 0.1, point)
    check("  what shows it", fact(certificate), certificate)

stiff, _ = verify(model("stiff", {"Material/Young's modulus": 10}))
check("a modulus of ten, which displacements do not show", abs(error(stiff) / error(best) - 1.) < 1e-4, error(stiff))
millimetres, screen = verify(right, **{"Verify/Factor": 1000})
check("millimetres", error(millimetres) > 900. and abs(millimetres["factor"] * 1000. - best["factor"]) < 1e-6, millimetres["factor"])
check("  and the advice", re.search(r"times 0\.000994\d* the field would be within 8\.9\d? %: other units\?", screen.stdout),
      screen.stdout)
metres = run("metres", {**SCENE, "Geometry/Lower left": "-1000, 0", "Geometry/Upper right": "1000, 1000"}, "--verify", right)
check("coordinates in other units", metres.returncode == 1 and "a ratio of 0.001" in metres.stderr, metres.stderr)

# Exit codes, sweeps, and levels that are given.
check("tolerated", verify(right, "--verify-tolerance", "0.1")[1].returncode == 0)
above = verify(right, "--verify-tolerance", "0.05")[1]
check("not tolerated", above.returncode == 2 and "not below the tolerated 5 %" in above.stderr, above.stderr)
nested, screen = verify(right, **{"Discretization/Strategy": "nested", "Discretization/Finest level": 3})
check("on nested levels the same interval", abs(error(nested) - error(best)) < nested["relative"]["margin"] + best["relative"]["margin"],
      error(nested))
swept = run("swept", SCENE, "--verify", right, "--sweep", "Material/Poisson's ratio=0.3, 0.25")
errors = []
for value in ("0.3", "0.25"):
    with open(f"swept/{value}/verified.json", encoding="utf-8") as json_file:
        errors.append(error(json.load(json_file)))
check("a sweep", swept.returncode == 0 and abs(errors[0] - error(best)) < 1e-6 < errors[1] - errors[0], errors)
missing = run("missing", SCENE, "--verify", "nowhere.vtu")
check("no file", missing.returncode == 1 and "nowhere.vtu: this file of a displacement cannot be read." in missing.stderr, missing.stderr)
field = run("field", {**SCENE, "Verify/Field": "U"}, "--verify", right)
check("no field", field.returncode == 1 and "allowed: displacement, " in field.stderr, field.stderr)
sys.exit(1 if failures else 0)
