# SPDX-License-Identifier: LGPL-2.1-or-later
"""Reference answers with guaranteed intervals; doc/answers.md describes the scenes."""
import json
import math
import pathlib
import subprocess

import signorini
from tables.common import GRADED, ROOT, FOLDER, table, target

NO_CASES = {"Load cases/Cases": "", "Load cases/Fields": ""}
XI = math.sqrt(0.5)
# The scene, its target, settings, the places of which means are wanted, and what is known by closed forms.
SCENES = [
    ("prm/benchmarks/hertz_line", 1e-5, {}, "0,-7 radius 0.5", {}),
    ("prm/benchmarks/nafems_cgs1", 1e-5, {}, "0,-45 radius 3", {}),
    ("prm/benchmarks/flat_punch", 1e-5, {}, "0,0 box 1,1 | bottom from 0 to 0.5", {"contact force": 5}),
    ("prm/benchmarks/westergaard", 1e-6, {"Discretization/Coarsest level": 2, **NO_CASES}, "0,0 box 0.25,0.25", {}),
    ("prm/block_on_parabola", 1e-6, {}, "top | left | bottom from 0.75 to 1.25 | 0,0.5 radius 0.4", {}),
    ("prm/block_on_two_rollers", 1e-6, {}, "left | bottom | 0,0.5 radius 0.4", {}),
    ("prm/bracket", 1e-3, {}, "side0 | side1 | 5,5 radius 5", {}),
    ("prm/plate_with_hole", 1e-5, {}, "side1 | side3 | 0,0.75 radius 0.2", {}),
    ("prm/pressed_plate", 1e-5, {}, "right | bottom | top", {}),
    ("prm/pressed_by_force", 1e-5, NO_CASES, "0,0 box 1,0.5 | bottom from 0.2 to 0.6", {"contact force": 0.05}),
    ("prm/roller_on_table", 1e-5, {}, "0,1 radius 0.5", {"contact force": 0.01 * math.pi}),
    ("prm/recipes/cam", 1e-4, {}, "0,-26 radius 1", {"contact force": 1000}),
    ("prm/recipes/rubber_pad", 1e-4, {}, "left | top | -5,0 box 5,10", {}),
    ("prm/nearly_incompressible", 1e-5, {"Discretization/Element": "Q1"}, "bottom | 0.5,0.5 radius 0.3",
     {"mean u_x of bottom": 0.2 / math.pi}),
    ("prm/two_contact_sides", 1e-5, {}, "right | 0.5,0.5 radius 0.4", {"mean u_y of right": 1 / 6}),
    ("prm/smooth_contact_two_ends", 1e-5, {}, "bottom | left", {"mean u_y of left": -0.025, "mean u_x of left": 1 / 240}),
    ("prm/described_a1", 1e-6, {}, "right | bottom | top", {"contact force": 0.625, "mean u_x of right": 11 / 120}),
    ("prm/b1", 1e-6, {}, "right | bottom | top", {"contact force": 2 / 3 * XI**1.5}),
    ("prm/e1", 1e-5, {}, "1.5,0 radius 0.4", {"energy J": 0.06 * math.pi}),
    ("prm/friction/t1", 1e-5, {}, "right | bottom", {}),
    ("prm/friction/ts_hp", 1e-5, {}, "right | bottom", {}),
    ("prm/bodies/block_on_base", 1e-4, {}, "block | block.top", {}),
    ("scripts/decks/beam", 1e-5, {}, "right | bottom | left", {}),
]


def interval(value, error):
    """Returns texts of an interval that contains value ± error: both are rounded, the half width upwards."""
    places = max(0, 1 - math.floor(math.log10(error)))
    half = error + 0.5 * 10.**-places
    unit = 10.**(math.floor(math.log10(half)) - 1)
    return f"{value:.{places}f}", f"{math.ceil(half / unit) * unit:.1e}"


def intervals_of(answer):
    """Yields the quantities of an answer that have a guaranteed interval."""
    energy = answer["energy"]
    if energy["lower"] is not None:
        yield "energy J", (energy["lower"] + energy["upper"]) / 2, (energy["upper"] - energy["lower"]) / 2 or 1e-15 * abs(energy["lower"])
    if answer["contact_force"]["error"] is not None:
        yield "contact force", math.hypot(*answer["contact_force"]["force"]), answer["contact_force"]["error"]
    for report in answer.get("reports", []):
        for name, mean in report["means"].items():
            if mean["error"] is not None:
                yield f"{name} of {report['place']}", mean["value"], mean["error"]


@table("scene", "quantity", "value", "at_most_off", "closed_form")
def answers():
    for scene, error, settings, places, known in SCENES:
        report = " | ".join(place + " guaranteed" for place in places.split(" | "))
        run = signorini.run(f"{ROOT}/{scene}.prm", f"{FOLDER.name}/{scene.replace('/', '_')}",
                            **{"Output/VTU": "none", "Output/Report": report, **GRADED, **target(error), **settings})
        found = list(intervals_of(run.answer))
        for name in set(known) - {name for name, _, _ in found}:
            if name != "contact force":
                raise signorini.Refused(f"{scene}: found no interval of {name}")
        for name, value, off in found:
            exact = known.get(name)
            if exact is not None and abs(exact - value) > off:
                raise signorini.Refused(f"{scene}: {name} is {exact}, outside of {value} ± {off}")
            # Zeros by symmetry say nothing.
            if abs(value) > off:
                yield scene.rsplit("/", 1)[-1], name, *interval(value, off), "" if exact is None else f"{exact:.12g}"


DOLFINX = "dolfinx 0.5.2", ["/usr/bin/python3", "dolfinx_block_and_a1.py"]
FREEFEM = "FreeFEM 4.11", ["FreeFem++", "-nw", "-v", "0"]
# The scene, the program and its call, the arguments of a deck, the file that it writes, and its elements.
DECKS = [
    ("prm/block_on_parabola", *FREEFEM, "block_on_parabola.edp -n 16 -penalty 1e4 -file {0}/deck.vtu", "P2, 16 x 32 x 2"),
    ("prm/block_on_parabola", *DOLFINX, "block 1 triangle 16 1e4 {0}/deck.pvd", "P1, 16 x 32 x 2"),
    ("prm/block_on_parabola", *DOLFINX, "block 2 quadrilateral 16 1e4 {0}/deck.pvd", "Q2, 16 x 32"),
    ("prm/pressed_plate", *FREEFEM, "pressed_plate.edp -n 16 -penalty 1e8 -file {0}/deck.vtu", "P2, 16 x 32 x 2"),
    ("prm/described_a1", *DOLFINX, "a1 1 triangle 16 1e4 {0}/deck.pvd", "P1, 16 x 16 x 2"),
    ("prm/described_a1", *DOLFINX, "a1 2 quadrilateral 16 1e4 {0}/deck.pvd", "Q2, 16 x 16"),
    ("scripts/decks/beam", "CalculiX 2.20", ["/usr/bin/python3", "calculix_beam.py"], "4 {0}", "CPS8, 4 x 32"),
]


@table("scene", "program", "elements", "error", "margin", "penetration")
def errors_of_programs():
    for number, (scene, program, call, arguments, elements) in enumerate(DECKS):
        folder = f"{FOLDER.name}/deck{number}"
        pathlib.Path(folder).mkdir()
        subprocess.run(call + arguments.format(folder).split(), cwd=f"{ROOT}/scripts/decks", check=True, capture_output=True)
        file, = [name for name in ("deck.vtu", "deck_p0_000000.vtu", "beam.vtu") if (pathlib.Path(folder) / name).exists()]
        signorini.run(f"{ROOT}/{scene}.prm", f"{folder}/results", **{
            "Output/VTU": "none", **GRADED, "Verify/File": f"{folder}/{file}"})
        found = json.loads((pathlib.Path(f"{folder}/results") / "verified.json").read_text(encoding="utf-8"))
        error, margin = found["relative"]["value"], found["relative"]["margin"]
        yield (scene.rsplit("/", 1)[-1], program, elements, f"{100 * error:.4f} %", f"{100 * margin:.1e} %",
               f"{found['penetration']['value']:.1e}")
