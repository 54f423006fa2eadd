# SPDX-License-Identifier: LGPL-2.1-or-later
"""Round bodies in space: a uniform pressure on plane ends is exact on every mesh, and --check shows their sides.
usage: shapes.py PROGRAM ROOT"""
import csv
import json
import math
import os
import subprocess
import sys
import tempfile

program = os.path.realpath(sys.argv[1])
os.chdir(tempfile.mkdtemp())
failures = 0


def check(name, fact, found=""):
    global failures
    failures += not fact
    print(f"{name}: {'ok' if fact else f'FAILED {found}'}")


def run(name, text, *options):
    """Runs a scene of lines "Subsection/Name = value"."""
    with open(f"{name}.prm", "w", encoding="utf-8") as file:
        file.write("set Dimension = 3\n")
        for line in filter(None, text.splitlines()):
            (section, entry), value = line.split("=", 1)[0].strip().split("/"), line.split("=", 1)[1]
            file.write(f"subsection {section}\n  set {entry} ={value}\nend\n")
    return subprocess.run([program, f"{name}.prm", "--output", name, *options], capture_output=True, text=True, check=False)


# E = 2, nu = 1/4, u_z = -z/10: p = 1/5, u_r = r/40. The upper end is driven, the lower one lies on a plane.
AXES = {"x": ("-0.1*x; 0.025*y; 0.025*z", "left", "right"), "y": ("0.025*x; -0.1*y; 0.025*z", "front", "back"),
        "z": ("0.025*x; 0.025*y; -0.1*z", "bottom", "top")}
AREA = math.pi * (1. - 0.36)
for name, shape, axis, held, area in (("rod", "cylinder", "z", "", math.pi), ("roller", "cylinder", "y", "", math.pi / 4),
                                      ("tube", "tube", "x", "", AREA / 2), ("pipe", "tube", "z", "", AREA / 4)):
    sector = {math.pi: "whole", math.pi / 4: "quarter", AREA / 2: "half", AREA / 4: "quarter"}[area]
    u, low, high = AXES[axis]
    planes = {"rod": "", "roller": "left top", "tube": "top", "pipe": "left front"}[name]
    done = run(name, f"""
Geometry/Shape = {shape}
Geometry/Axis = {axis}
Geometry/Sector = {sector}
{"Geometry/Inner radius = 0.6" if shape == "tube" else ""}
Geometry/Length = 0.8
Material/Young's modulus = 2
Material/Poisson's ratio = 0.25
Boundary/Contact = {low}
Boundary/Displacement = {high}: {u}
{"Boundary/Rollers = " + planes if planes else ""}
Contact/Gap = 0
Exact solution/Displacement = {u}
Exact solution/Displacement gradient = {"; ".join(str({("x", 0): -0.1, ("y", 1): -0.1, ("z", 2): -0.1}.get((axis, i), 0.025) if i == j else 0.) for i in range(3) for j in range(3))}
Discretization/Coarsest level = 1
Discretization/Finest level = 2
""")
    check(f"{name} is solved", done.returncode == 0, done.stderr + done.stdout)
    for file_name, column, exact, rounding in (("convergence.csv", "u_h1", 0., 1e-9), ("contact-02.csv", "p_H", -0.2, 1e-9)):
        with open(f"{name}/{file_name}", encoding="utf-8") as file:
            worst = max(abs(float(row[column]) - exact) for row in csv.DictReader(file))
        check(f"  {column} is exact", worst < rounding, worst)
    with open(f"{name}/answer.json", encoding="utf-8") as file:
        answer = json.load(file)
    # The end is a polygon, smaller by a share of h².
    share = answer["contact_area"] / area
    check("  the area of contact", 0.97 < share <= 1. + 1e-12, share)
    check("  carries the pressure", abs(answer["peak_pressure"]["value"] / 0.2 - 1.) < 1e-8, answer["peak_pressure"])

done = run("ball", """
Geometry/Shape = ball
Geometry/Sector = octant
Boundary/Contact = round
Boundary/Rollers = left front
Boundary/Displacement = top: 0; 0; -0.01
Contact/Foundation = plane 0,0,-1 normal 0,0,1
Discretization/Coarsest level = 1
""", "--check")
check("a ball is shown", done.returncode == 0 and "First mesh: 32 cells, edges of one cell up to " in done.stdout, done.stderr + done.stdout)
with open("ball/scene.json", encoding="utf-8") as file:
    sides = json.load(file)["sides"]
check("  its sides with their roles", [(side["name"], side["role"]) for side in sides] ==
      [("round", "contact"), ("left", "rollers"), ("front", "rollers"), ("top", "displacement")], sides)
check("  and the faces of the first mesh", [len(side["faces"]) for side in sides] == [12, 12, 12, 12], [len(side["faces"]) for side in sides])
check("  on the sphere", all(abs(math.hypot(*x) - 1.) < 1e-12 for face in sides[0]["faces"] for x in face))
sys.exit(failures > 0)
