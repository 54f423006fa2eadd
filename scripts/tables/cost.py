# SPDX-License-Identifier: LGPL-2.1-or-later
"""Tables of what a run costs, on one core; most are made from the files of scripts/benchmark.py."""
import functools
import os
import re
import subprocess
import sys
from unittest import mock

import numpy as np
import signorini
from signorini.arrays import read_csv

from tables.common import FOLDER, NUMBERS, PROGRAM, ROOT, WITHOUT_ERRORS, committed, levels, measure, number, power, table, target

FINEST, LARGEST_RUNS, REPETITIONS, LINEAR_SOLVERS = 8, (9, 10), 3, "condensed amesos_mumps amesos_klu"
TARGETS = "1e-2 1e-3 1e-4 1e-5 1e-6 1e-7 1e-8"
ONE_THREAD = {"DEAL_II_NUM_THREADS": "1", "OMP_NUM_THREADS": "1", "OPENBLAS_NUM_THREADS": "1"}


@functools.lru_cache(maxsize=None)
def benchmark(*options):
    """Runs scripts/benchmark.py once. Returns a function that reads one of its files, as rows {column: text}."""
    folder = f"{FOLDER.name}/{next(NUMBERS)}"
    done = subprocess.run([sys.executable, f"{ROOT}/scripts/benchmark.py", "--program", PROGRAM, "--output", folder, "--no-pictures",
                           "--repetitions", str(REPETITIONS), *options], capture_output=True, text=True, check=False)
    if done.returncode != 0:
        raise signorini.Refused(done.stderr.strip())
    def rows(name):
        columns = read_csv(f"{folder}/{name}")
        return [dict(zip(columns, row)) for row in zip(*columns.values())]
    return rows


def stages(file):
    return benchmark("--largest", str(FINEST), "--contact-solvers", "active set", "--linear-solvers", LINEAR_SOLVERS,
                     "--scenes", "two_ends no_contact", "--strategies", "nested", "--targets", "")(file)


def targets(file):
    return benchmark("--largest", str(FINEST - 1), "--contact-solvers", "active set", "--linear-solvers", "condensed",
                     "--scenes", "two_ends b1 b3 block b1_kinks", "--targets", TARGETS)(file)


def seconds(row, *names):
    return number(sum(row[f"t_{name}"] for name in names))


@table("scene_solver", "mesh_spaces", "assembly", "factorisation", "compliance", "dual_problem", "recovery", "certificate", "bound",
       "together")
def cost_solvers():
    for scene, name in (("two_ends", "contact"), ("no_contact", "no contact")):
        for row in stages("benchmark.csv"):
            if row["scene"] == scene and row["level"] == FINEST:
                yield (f"{name}, {row['linear_solver']}", seconds(row, "mesh", "setup"),
                       *(seconds(row, stage) for stage in ("assembly", "factor", "compliance", "qp", "recovery", "postprocess",
                                                           "bound", "solution")))


# The stages of a run by functions: a sample belongs to the first stage whose functions are among its calls.
FUNCTIONS = {
    "formulas": "FormulaTree|FormulaParts",
    "bound": "compute_located_bound|LevelErrors<|CellFit|AiryCell|Misfit|Traction|ContactLift", "output": "ResultsWriter|StudyWriter|solution_vtu",
    "pressure correction": "correct_by_finer_patches", "estimate": "estimate_error|contact_part|PatchInterpolation",
    "examination": "StepExamination|missed_contact_cells|energy_distance|indicate|energy_on",
    "answer": "compute_answer|plate_records|von_mises|StressIn3D", "A U, certificate": "nodal_forces|certify|energies_of|internal_forces",
    "pattern of A": "make_matrix", "factor": "CondensedInverse::CondensedInverse|factorise<?",
    "set-up of cycles": "make_multigrid_inverse|StiffnessMultigrid<[23]>::StiffnessMultigrid",
    "entries of A, f": "assemble_linear_system|assemble_right_hand_side|CellStiffness|integrate_loads|begin_system",
    "V-cycles, contact": "solve_contact_by_cycles", "C, dual problem": "make_compliance|solve_dual|ActiveSet|active_set|Compliance",
    "U, U_0": "StiffnessInverse|MatrixInverse", "mesh, plan": "Mesh<[23]>::|_plan\\b|hidden_data",
    "spaces, D, G": "Discretization<|DisplacementSpace<|MultiplierSpace<", "carry over": "carry_over|start_for|transfer_pressure",
    "scan, input": "make_scene|parameters|find_contradiction",
    # Calls of OpenBLAS end in its kernels.
    "rest": "Signorini::|dealii::|gemm|trsm|syrk|potrf", "start": "_dl_|_start|MPI_"}
SAMPLES_PER_SECOND = 199


def times_by_stage(scene, settings):
    """Returns processor seconds by stage, from samples that perf takes, and those of the whole process."""
    folder = f"{FOLDER.name}/{next(NUMBERS)}"
    overrides = [text for key, value in settings.items() for text in ("--set", f"{key}={value}")]
    for command, file in ((["perf", "record", "-q", "-F", str(SAMPLES_PER_SECOND), "--call-graph", "dwarf,16384", "-o", f"{folder}.perf",
                            PROGRAM, f"{ROOT}/prm/{scene}.prm", "--output", folder, *overrides], "log"),
                          (["perf", "script", "--no-inline", "-i", f"{folder}.perf", "-F", "ip,sym"], "calls")):
        with open(f"{folder}.{file}", "w", encoding="utf-8") as output:
            if subprocess.run(command, stdout=output, stderr=subprocess.DEVNULL, check=False).returncode != 0:
                raise signorini.Refused(f"{' '.join(command[:2])} failed on {scene}: perf must be installed and allowed to sample.")
    with open(f"{folder}.calls", encoding="utf-8") as calls:
        samples = [sample for sample in calls.read().split("\n\n") if sample.strip()]
    times = dict.fromkeys(FUNCTIONS, 0.)
    for sample in samples:
        times[next((stage for stage, names in FUNCTIONS.items() if re.search(names, sample)), "rest")] += 1. / SAMPLES_PER_SECOND
    return times, len(samples) / SAMPLES_PER_SECOND


@table("run", "together", *FUNCTIONS)
def cost_stages():
    finest, graded = levels(3, 6), {"Discretization/Coarsest level": 2}
    runs = [("sphere, n = 64", "space/sphere", finest), ("D3, n = 64", "space/d3", finest)]
    runs += [(f"{name} to {error}", scene, {**target(error), **graded}) for name, scene in
             (("B3", "b3"), ("B1", "described_b1"), ("two ends", "smooth_contact_two_ends")) for error in ("1e-6", "1e-8")]
    for name, scene, settings in runs:
        with mock.patch.dict(os.environ, ONE_THREAD):
            times, together = times_by_stage(scene, {"Output/VTU": "none", **WITHOUT_ERRORS, **settings})
        yield name, number(together), *(f"{time:.2f}" for time in times.values())


@table("of", "unknowns", "patches", "active_sets", "contact_s", "no_contact_s", "ratio", "us_per_unknown", "peak_memory_GB")
def cost_levels():
    rows = [row for row in stages("benchmark.csv") if row["linear_solver"] == "condensed" and row["level"] > 4]
    contact, none = ([row for row in rows if row["scene"] == scene] for scene in ("two_ends", "no_contact"))
    for row, other in zip(contact, none):
        time, other_time = (r["t_solution"] - r["t_bound"] for r in (row, other))
        yield ("level", int(row["dofs"]), int(row["multipliers"]), int(row["qp_iterations"]), number(time), number(other_time), "",
               number(1e6 * time / row["dofs"]), "")
    settings = {**WITHOUT_ERRORS, "Output/Bound": "false", "Solver/Contact solver": "active set"}
    for level in LARGEST_RUNS:
        pairs = [[measure("smooth_contact_two_ends", {**settings, **levels(4, level), **gap}) for gap in ({}, {"Contact/Gap": 10})]
                 for _ in range(REPETITIONS)]
        time, other_time = (np.median([pair[i]["cpu_total"][-1] for pair in pairs]) for i in (0, 1))
        first = pairs[0][0]
        yield ("run", int(first["dofs"][-1]), "", "", number(time), number(other_time), f"{time / other_time:.2f}",
               number(1e6 * np.median([pair[0]["t_total"][-1] for pair in pairs]) / first["dofs"][-1]),
               number(first["peak_memory_mb"][-1] * 2**20 / 1e9, 2))


@table("unknowns", *LINEAR_SOLVERS.split())
def cost_memory():
    rows = stages("memory.csv")
    for unknowns in sorted({row["dofs"] for row in rows})[1:]:
        found = {row["linear_solver"]: row["bytes_per_dof"] for row in rows if row["dofs"] == unknowns}
        yield int(unknowns), *(f"{found[solver]:.0f}" for solver in LINEAR_SOLVERS.split())


@table("stage", "done_only_if", "with_s", "without_s")
def skipped_stages():
    two_ends, a1, mumps, none = "smooth_contact_two_ends", "a1", {"Solver/Linear solver": "amesos_mumps"}, {"Contact/Gap": 10}
    beta = {"Output/Inf-sup constant": "false"}
    for stage, condition, names, (scene, settings), (other_scene, other_settings) in (
            ("compliance C, one solve per patch (t_compliance, t_qp, amesos_mumps)",
             "no factor with the contact unknowns last is at hand, and only for patches that can touch", ["compliance", "qp"],
             (two_ends, mumps), (two_ends, {})),
            ("dual problem, recovery of U (t_qp, t_recovery)", "F has a negative entry: some patch would penetrate",
             ["qp", "recovery"], (two_ends, {}), (two_ends, none)),
            ("element matrix for every cell (t_assembly, V1 against A1)",
             "the stiffness varies, or no other cell has the shape; congruent cells share one", ["assembly"], ("v1", {}), (a1, {})),
            ("rules for cells that a kink crosses (t_assembly, two ends without Kinks at x)", "Kinks at x, Kinks at y", ["assembly"],
             (two_ends, {}), (two_ends, {"Discretization/Kinks at x": ""})),
            ("error norms (t_errors, two ends)", "an exact solution is given and Output/Errors", ["errors"],
             (two_ends, {}), (two_ends, {"Output/Errors": "false"})),
            ("guaranteed bound (t_bound, A1)", "Output/Bound: on the finest level by default", ["bound"],
             (a1, {}), (a1, {"Output/Bound": "false"})),
            ("inf-sup constant, factorisation of its own (t_postprocess, A1)",
             "Output/Inf-sup constant; automatic where the exact displacement is known", ["postprocess"],
             (a1, {"Output/Inf-sup constant": "true"}), (a1, {})),
            ("numbers of the lemmas, factorisation of its own (t_errors, A1)", "Output/Lemmas", ["errors"],
             (a1, {"Output/Lemmas": "true"}), (a1, {})),
            ("fields for ParaView (t_output, A1)", "Output/VTU: on the finest level by default", ["output"],
             (a1, {"Output/VTU": "finest"}), (a1, {}))):
        with mock.patch.dict(os.environ, ONE_THREAD):
            runs = [[measure(s, {**levels(FINEST - 1, FINEST - 1), **beta, **overrides})
                     for s, overrides in ((scene, settings), (other_scene, other_settings))] for _ in range(REPETITIONS)]
        times = (np.median([sum(pair[i][f"t_{name}"][-1] for name in names) for pair in runs]) for i in (0, 1))
        # A stage that is left out takes the time of reading a clock.
        yield stage, condition, *(number(time, 2) if time > 1e-4 else "0" for time in times)


@table("program", "cells", "relative_error", "seconds")
def time_to_error_nested():
    size_of_u, elevenths = 0.12796406, {"Geometry/Cells": "11, 11"}  # |u|_1
    for cells, settings in (("88² (Cells = 11, 11, levels 1 to 3)", {**levels(1, 3), **elevenths}),
                            ("256² (levels 4 to 8)", levels(4, 8)),
                            ("704² (Cells = 11, 11, levels 1 to 6)", {**levels(1, 6), **elevenths})):
        scene, settings = "smooth_contact_two_ends", {**settings, "Output/Inf-sup constant": "false", "Output/Bound": "false"}
        with mock.patch.dict(os.environ, ONE_THREAD):
            error = measure(scene, settings)["u_post4_h1"][-1] / size_of_u
            times = [measure(scene, {**settings, "Output/Errors": "false"})["cpu_total"][-1] for _ in range(REPETITIONS)]
        yield "signorini", cells, power(error), number(np.median(times))
    # Other programs: as they are.
    yield from (row for row in committed("time_to_error_nested") if row[0] != "signorini")


@table("cells", *(f"{scene}_{column}" for scene in ("two_ends", "b1", "b3") for column in ("u_h", "pi2h", "s")))
def time_to_error_uniform():
    rows = {(row["scene"], float(row["request"])): row for row in targets("targets_worst.csv") if row["strategy"] == "nested"}
    for level in range(4, FINEST):
        found = [rows[scene, level] for scene in ("two_ends", "b1", "b3")]
        yield f"{2**level}²", *(text for row in found for text in (power(row["error"]), power(row["error_post"]), number(row["cpu"], 2)))


@table("scene", "target", "error", "steps", "N", "sum_N", "degree", "seconds")
def time_to_error_graded():
    rows = [row for row in targets("targets_worst.csv") if row["strategy"] == "hp"]
    for scene, name in (("two_ends", "two_ends"), ("b1", "b1_worst_of_8"), ("b1_kinks", "b1_kinks"), ("b3", "b3"), ("block", "block")):
        for row in rows:
            # Energies show no smaller errors of the block.
            if row["scene"] == scene and (scene != "block" or row["request"] > 5e-7):
                yield (name, power(row["request"], 0), power(row["error"]), int(row["steps"]), int(row["dofs"]), int(row["all_dofs"]),
                       int(row["max_degree"]), f"{row['cpu']:.2f}")
