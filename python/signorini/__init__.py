# SPDX-License-Identifier: LGPL-2.1-or-later
"""Runs the program signorini and reads its results.

    import signorini
    run = signorini.run("scene.prm", r=4, **{"Load/Body force": "0; -1"})  # a constant, and an entry of the file
    run                                                # shows the level, the answer with units and its error
    run.answer["contact_force"]["force"], run.table["bound_relative"][-1]
    run.contact()["p_H"], run.fields()[2]["von_mises_stress"]
    signorini.read("results/scene")                    # the results of a run that is over
    for point, run in signorini.sweep("scene.prm", "results/sweep", r=[4, 8], **{"Material/Young's modulus": [1, 2]}):
        ...                                            # point is {"r": 4, "Material/Young's modulus": 1}, ...
    signorini.verify("scene.prm", "other.vtu")["upper"]  # the error of the displacement of another program

Numbers have the units of the scene, which may be any consistent ones: lengths in its unit of length, pressures and stresses in
force/length², and in the plane forces per thickness. doc/output.md defines every name, unit and sign. Arrays (tables, contact
sides, fields; the module signorini.arrays) need Python's numpy, everything else Python alone.
"""
from .program import Setting, find_program, run, sweep, verify
from .results import DamagedFile, Refused, Run, read

__all__ = ["DamagedFile", "Refused", "Run", "Setting", "find_program", "read", "run", "sweep", "verify"]
