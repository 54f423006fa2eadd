# SPDX-License-Identifier: LGPL-2.1-or-later
"""Two bodies on graded meshes against an independent program."""
import math

import signorini
from tables.common import FOLDER, NUMBERS, number, power, table

RING = "0,0; arc 0,1 ccw; 1,1; 0.4,1; arc 0,1 cw; 0,0.6"
MIRROR = "0,0; 0,-0.6; arc 0,-1 cw; 0.4,-1; 1,-1; arc 0,-1 ccw"
HOLE = "0,-1.99; 2,-1.99; 2,2.01; 0,2.01; 0,1.02; arc 0,0.01 cw; 0,-1"
PIN = "0,-1; arc 0,0 ccw; 0,1; 0,0.5; arc 0,0 cw; 0,-0.5"


def boxes(a, b):
    return {"Geometry/Lower left": f"a: {a[0]} | b: {b[0]}", "Geometry/Upper right": f"a: {a[1]} | b: {b[1]}"}


def outlines(a, b):
    return {"Geometry/Shape": "a: polygon | b: polygon", "Geometry/Vertices": f"a: {a} | b: {b}"}


def pair(E, contact, gap, rollers, **others):
    return {"Material/Young's modulus": E, "Boundary/Contact": contact, "Contact/Gap": gap, "Boundary/Rollers": rollers,
            **{name.replace("_", "/"): text for name, text in others.items()}}


PUNCH, FLAT = boxes(("0,0", "0.5,0.5"), ("0,-1", "1.5,0")), "a.bottom with b.top"
ON_BLOCK = {"Geometry/Shape": "a: polygon | b: rectangle", "Geometry/Vertices": "a: " + RING,
            "Geometry/Lower left": "b: 0,-1", "Geometry/Upper right": "b: 1.2,0"}
LOWERED = "a.left a.top b.left b.bottom"
# The gap of a ring that is lowered by 0.02, along the mean normal.
ALONG = "-0.02*cos(0.5*atan2(x,1-y))"


def hertz(E):
    return {**outlines(RING, MIRROR), **pair(E, "a.side0 with b.side3", "-0.02", "a.side3 a.side1 b.side0 b.side2")}


def punch(E):
    return {**PUNCH, **pair(E, FLAT, "-0.02", LOWERED)}


def roller(E):
    return {**ON_BLOCK, **pair(E, "a.side0 with b.top", ALONG, "a.side3 a.side1 b.left b.bottom")}


# Scene, vertical force and energy of the other program: elements of degree 12 at most, plane strain, nu = 0.3.
SCENES = {
    "two rollers": (hertz("a: 1 | b: 1"), 1.405116735e-3, 1.346948769e-5),
    "two rollers 1:10": (hertz("a: 1 | b: 10"), 2.554292611e-3, 2.448715904e-5),
    "roller on a block": (roller("a: 1 | b: 1"), 1.951302496e-3, 1.839253299e-5),
    "roller on a block 1:0.1": (roller("a: 1 | b: 0.1"), 4.776735882e-4, 4.410398417e-6),
    "punch": (punch("a: 1 | b: 1"), 8.6309907219e-3, 8.6309907219e-5),
    "punch 1:10": (punch("a: 1 | b: 10"), 1.8983576180e-2, 1.8983576180e-4),
    "punch 1:0.1": (punch("a: 1 | b: 0.1"), 1.37707406e-3, 1.37707406e-5),
    "blocks 1:3": ({**boxes(("0,0", "1,1"), ("0,-1", "1,0")),
                     **pair("a: 1 | b: 3", FLAT, "0", "a.left b.left", Boundary_Clamped="b.bottom",
                            Boundary_Displacement="a.top: 0; -0.02")}, 1.7339031869e-2, 1.7339031869e-4),
    "pin in a plate": ({**outlines(PIN, HOLE),
                        **pair("a: 1 | b: 1", "a.side0 with b.side4", "", "a.side1 a.side3 b.side3 b.side5 b.side2",
                               Boundary_Displacement="a.side2: 0; -0.02")}, 3.331128835e-3, 2.935424348e-5),
    "beam on a block 10:1": ({**boxes(("0,0", "2,0.25"), ("0.6,-1.003", "2.6,-0.003")),
                               **pair("a: 10 | b: 1", FLAT, "", "b.bottom b.right", Boundary_Clamped="a.left",
                                      Boundary_Traction="a.top: 0; -0.001")}, 1.12555595e-3, -4.50369897e-6),
    "receding strip": ({**boxes(("0,0", "2,0.5"), ("0,-1", "3,0")),
                        **pair("a: 1 | b: 1", FLAT, "", "a.left b.left b.bottom",
                               Boundary_Traction="a.top: 0; -0.01*exp(-4*x^2)")}, 4.4311345590e-3, -1.8162172825e-5)}


@table("scene", "step", "unknowns", "sqrt_of_energy_difference", "estimate", "bound", "force_difference")
def graded_pairs():
    for name, (entries, force, energy) in SCENES.items():
        scene = f"{FOLDER.name}/{next(NUMBERS)}.prm"
        with open(scene, "w", encoding="utf-8") as file:
            file.write("subsection Geometry\n  set Bodies = a b\nend\n")
        settings = {"Material/Poisson's ratio": 0.3, "Output/VTU": "none", "Discretization/Target error": 1e-6}
        run = signorini.run(scene, scene[:-4], **{**settings, **{key: text for key, text in entries.items() if text}})
        table_of_run = run.table
        found = abs(run.answer["contact_by_side"][0]["force"][1])
        last = len(table_of_run["level"]) - 1
        for row in range(last + 1):
            difference = math.sqrt(abs(table_of_run["energy"][row] / energy - 1))
            yield (name, number(table_of_run["level"][row]), number(table_of_run["dofs"][row], 7),
                   # The digits of the other program end here.
                   power(difference) if difference > 3e-5 else "", power(table_of_run["estimated_relative"][row]),
                   power(table_of_run["bound_relative"][row]), power(abs(found / force - 1)) if row == last else "")
