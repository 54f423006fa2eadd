# SPDX-License-Identifier: LGPL-2.1-or-later
"""Tables of multigrid: what V-cycles cost, and contact by them."""
import os
from unittest import mock

import numpy as np

from tables.common import WITHOUT_ERRORS, levels, measure, number, rows_of_test, table


def rows_of(test, name):
    """Returns the rows of the table NAME.csv of a test, without their head."""
    return rows_of_test("solvers", test, f"{name}.csv")[1:]


@table("product", "instructions", "shared", "integrated", "stored")
def multigrid_kernels():
    return rows_of("stiffness/kernels", "multigrid_kernels")


@table("body", "level", "unknowns", "steps")
def multigrid_steps():
    rows = rows_of("stiffness/v_cycles", "multigrid_steps")
    bodies = list(dict.fromkeys(row[0] for row in rows))
    return sorted(rows, key=lambda row: (bodies.index(row[0]), int(row[1])))


@table("body", "unknowns", "set_up_s", "product_ns_per_cell", "v_cycle_ns_per_unknown", "steps", "solve_s", "bytes_per_unknown")
def multigrid_cost():
    return rows_of("stiffness/cost", "multigrid_cost")


@table("body", "level", "patches", "condition")
def compliance_model():
    return rows_of("contact/equivalence", "compliance_model")


@table("body", "cells_per_side", "linear_solve", "contact", "minres")
def cycles_from_zero():
    return rows_of("contact/cycles", "cycles_from_zero")


@table("body", "cells_per_side", "projected_sor", "sweeps", "active_set", "v_cycles")
def contact_methods():
    return rows_of("contact/cycles", "contact_methods")


@table("scene", "level", "to_1e-8", "to_1e-10")
def cycles_nested():
    for name, scene, coarsest, finest_level in (("D3", "space/d3", 2, 6), ("A1", "a1", 3, 9)):
        runs = [measure(scene, {**levels(coarsest, finest_level), **WITHOUT_ERRORS, "Output/Bound": "false",
                                "Solver/Contact solver": "multigrid", "Solver/Tolerance": tolerance}) for tolerance in (1e-8, 1e-10)]
        for row in range(1, len(runs[0]["level"])):
            yield name, int(runs[0]["level"][row]), *(int(run["qp_iterations"][row]) for run in runs)


@table("run", "factorisation_s", "factorisation_GB", "v_cycles_s", "v_cycles_GB", "contact_solver_s")
def contact_runs():
    def of(scene, level, solver, settings, repetitions):
        """Returns CPU seconds, GB, and seconds of the clock in the contact solver on all levels, medians of whole runs."""
        runs = [measure(scene, {**levels(2, level), **WITHOUT_ERRORS, **settings, "Solver/Contact solver": solver})
                for _ in range(repetitions)]
        return [number(np.median(column), 2) for column in (
            [run["cpu_total"][-1] for run in runs], [run["peak_memory_mb"][-1] * 2**20 / 1e9 for run in runs],
            [np.sum(run["t_qp"]) for run in runs])]
    with mock.patch.dict(os.environ, DEAL_II_NUM_THREADS="1"):
        for level in RUNS_IN_THE_PLANE:
            yield (f"A1, {2**level}²", *of("a1", level, "active set", {}, 3)[:2], *of("a1", level, "multigrid", {}, 3))
        for level in HUGE_RUNS:
            yield f"A1, {2**level}², no bound", "", "", *of("a1", level, "multigrid", {"Output/Bound": "false"}, 1)
        for level in RUNS_IN_SPACE:
            factorisation = of("space/d3", level, "active set", {}, 3)[:2] if level < 6 else ("", "")
            yield f"D3, {2**level}³", *factorisation, *of("space/d3", level, "multigrid", {}, 3)


RUNS_IN_THE_PLANE, HUGE_RUNS, RUNS_IN_SPACE = (6, 7, 8, 9, 10), (12,), (4, 5, 6)
