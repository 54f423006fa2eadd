# SPDX-License-Identifier: LGPL-2.1-or-later
"""Tables of orders, of the estimate and of the bound."""
import os
from unittest import mock

import numpy as np

from tables.common import (GRADED, TABLES, WITHOUT_ERRORS, committed, finest, levels, measure, number, power, rows_of_test, table,
                           target)

ONE_LEVEL = {**levels(8, 8), **WITHOUT_ERRORS}
FRICTION = {"T1": "T1 stick, slip, open", "T2": "T2 stick, slip", "T3": "T3 slip", "T4": "T4 stick", "K1": "K1 Coulomb, smooth",
            "TSq": "TSq end of stick at a node", "TS": "TS", "KS": "KS", "KSr": "KSr", "KO": "KO", "KOr": "KOr", "CM": "CM"}


@table("scene", "t_bound", "t_total", "share")
def bound_cost():
    for name, scene, settings in (("a1", "a1", {}), ("b3", "b3", {}),
                                  ("described_a1, Distortion = 0.2", "described_a1", {"Geometry/Distortion": 0.2}),
                                  ("described_a1, E = 2.6 (1 + x)", "described_a1", {"Material/Young's modulus": "2.6*(1+x)"})):
        runs = [measure(scene, {**ONE_LEVEL, **settings}) for _ in range(3)]
        bound, total = (np.median([run[t][-1] for run in runs]) for t in ("t_bound", "t_total"))
        yield name, number(bound), number(total), f"{100 * bound / total:.0f} %"


@table("run", "ratio", "value")
def bound_cost_ratios():
    with mock.patch.dict(os.environ, DEAL_II_NUM_THREADS="1"):
        for name, scene in (("a1", "a1"), ("v1 (E varies: each cell has its own matrix)", "v1"),
                            ("patch_test_distorted", "patch_test_distorted")):
            runs = [measure(scene, ONE_LEVEL) for _ in range(3)]
            yield (f"one thread, 256² cells: {name}", "bound over the rest",
                   number(np.median([run["t_bound"][-1] / (run["t_total"][-1] - run["t_bound"][-1]) for run in runs])))
        for scene in ("b1", "b3", "block_on_parabola", "smooth_contact_two_ends"):
            ratios = [np.divide(*(measure(scene, {**target(1e-6), "Output/Errors": "false", "Output/Bound": bound})["cpu_total"][-1]
                                  for bound in ("automatic", "false"))) for _ in range(3)]
            yield f"graded to 1e-6: {scene}", "CPU with the bound over without", number(np.median(ratios))


@table("scene", "target", "unknowns", "true_error", "bound_over_error")
def bound_graded():
    pairs = [(scene, error) for scene in ("b1", "b3") for error in ("1e-2", "1e-3", "1e-4", "1e-5", "1e-6")]
    pairs += [(scene, "1e-4") for scene in ("a1", "a2", "a3", "b2", "b4", "c1", "c3", "c4", "o1", "v1", "nearly_incompressible")]
    for scene, error in pairs:
        run = measure(scene, target(error))
        bound, true = run["bound_energy"][-1], run["u_energy"][-1]
        yield (scene, error, int(run["dofs"][-1]), number(true * run["bound_relative"][-1] / bound, 2), f"{bound / true:.2f}")


@table("scene", "mesh", "unknowns", "bound_relative", "estimated_relative")
def bound_arcs():
    for scene, mesh, settings in (("benchmarks/hertz_line", "hp", GRADED), ("benchmarks/nafems_cgs1", "hp", GRADED),
                                  ("roller_on_table", "hp", GRADED), ("bracket", "hp", GRADED), ("e1", "level 6", finest(6)),
                                  ("plate_with_hole", "level 4", finest(4)), ("hertz_from_file", "level 4", finest(4)),
                                  ("bracket_from_step", "level 3", finest(3))):
        run = measure(scene, settings)
        yield scene, mesh, int(run["dofs"][-1]), number(run["bound_relative"][-1]), number(run["estimated_relative"][-1])


def friction_run(name, level):
    return measure("friction/t1", {"Scene/Name": name, **finest(level)})


@table("scene", "u_h1", "u_superclose_h1", "u_post_h1", "p_l2", "q_l2", "p_superclose_dual", "sets_per_level")
def friction_orders():
    for name, text in FRICTION.items():
        run = friction_run(name, 7)
        orders = []
        for column in TABLES["friction_orders"][0][1:-1]:
            error = run[column + "_spectral" if column == "p_superclose_dual" else column][-4:]
            orders.append(f"{np.polyfit(np.log(run['h'][-4:]), np.log(error), 1)[0]:.2f}")
        yield text, *orders, " ".join(str(int(n)) for n in run["qp_iterations"][-4:])


@table("scene", "bound_2", "bound_4", "bound_6", "estimate_2", "estimate_4", "estimate_6")
def friction_effectivity():
    for name in FRICTION:
        runs = [friction_run(name, level) for level in (2, 4, 6)]
        yield name, *(f"{run['bound_energy'][-1] / run['u_energy'][-1]:.2f}" for run in runs), \
            *(f"{run['effectivity_energy'][-1]:.2f}" for run in runs)


@table("scene", "steps", "unknowns", "estimate", "true_error", "estimate_over_error")
def friction_graded():
    for name in ("TS", "TSq", "KS", "KSr", "KO", "KOr", "CM", "T1", "K1"):
        run = measure("friction/ts_hp", {"Scene/Name": name})
        unit = run["estimated_energy"] / run["estimated_relative"]
        yield (name, len(unit), int(run["dofs"][-1]), number(run["estimated_relative"][-1], 2),
               number(run["u_energy"][-1] / unit[-1], 2), " ".join(number(x, 2) for x in run["effectivity_energy"][2:]))


@table("h", "H", "u_h1", "u_superclose_h1", "p_l2", "p_dual")
def h_and_H():
    columns = TABLES["h_and_H"][0][2:]
    run = measure("paper/h_fixed_H")
    for row in range(len(run["level"])):
        yield f"1/{2**int(run['level'][row])}", "1/8", *(power(run[column][row], 3) for column in columns)
    for patches in (4, 8, 16, 32, 64):
        run = measure("paper/H_refined", {"Discretization/Patches": patches})
        yield "1/128", f"1/{patches}", *(power(run[column][-1], 3) for column in columns)


@table("scene", "u_h1", "u_post_h1", "u_post4_h1", "u_superclose_h1", "extrapolated")
def interpolation():
    # Extrapolation was tried by another program: as it is.
    extrapolated = {row[0]: row[-1] for row in committed("interpolation")}
    for name, scene in (("A2 (two smooth zones)", "a2"), ("C1 (full contact)", "c1"), ("C4 (two sides)", "c4"), ("A1", "a1"),
                        ("A3 (kink in p)", "a3"), ("B1 (singular)", "b1"), ("B3 (Hertz)", "b3"),
                        ("two ends", "smooth_contact_two_ends")):
        run = measure(scene, finest(7))
        yield name, *(power(run[column][-1], 2) for column in TABLES["interpolation"][0][1:-1]), extrapolated[name]


@table("scene", "H_2h", "H_4h", "8_patches", "H_8h", "H_8h_h1_norm")
def estimate_effectivity():
    for name in ("A1", "A1L", "A2", "A3", "B1", "B1q", "B1t", "B2", "B3", "B4", "C1", "C2", "C3", "C4", "E1", "E2", "E3", "O1", "V1"):
        runs = [measure("a1", {"Scene/Name": name, **levels(5, 5), "Output/Bound": "false", "Output/Inf-sup constant": "false",
                               f"Discretization/{partition}": value})
                for partition, value in (("Patch ratio", 2), ("Patch ratio", 4), ("Patches", 8), ("Patch ratio", 8))]
        yield name, *(number(run["effectivity_energy"][-1]) for run in runs), number(runs[-1]["effectivity"][-1])


@table("scene", "level_1", "level_2", "level_3", "level_4", "level_5")
def bound_effectivity():
    for row in rows_of_test("error_control", "bound/true_error", "bound_effectivity.csv"):
        if any(row[1:]):
            yield *row, *[""] * (6 - len(row))


@table("of", "scene", "level_1", "level_2", "level_3", "level_4", "level_5")
def level_errors():
    for of, file in (("u_h", "distances_of_u.csv"), ("pi2h", "distances_of_patches.csv")):
        for row in rows_of_test("error_control", "bound/true_error", file):
            if any(row[1:]):
                yield of, *row, *[""] * (6 - len(row))


@table("scene", "level", "u_h_percent", "margin_percent", "order", "interpolation_percent", "its_order")
def unknown_orders():
    for scene in ("block_on_parabola", "pressed_plate", "two_contact_sides", "smooth_contact_two_ends", "block_on_two_rollers"):
        run = measure(scene, {**levels(3, 8), **WITHOUT_ERRORS})
        scale = 100 * run["bound_relative"] / run["bound_energy"]
        for i, level in enumerate(run["level"]):
            orders = [number(np.log2(run[name][i - 1] / run[name][i])) if i > 0 else "" for name in ("distance", "post_distance")]
            yield (scene, int(level), number(scale[i] * run["distance"][i]), number(scale[i] * run["margin"][i]), orders[0],
                   number(scale[i] * run["post_distance"][i]), orders[1])


@table("scene", "level", "error_over_u", "bound_relative", "bound_over_error", "energy_over_reference")
def bound_unresolved():
    return rows_of_test("error_control", "bound/unresolved", "bound_unresolved.csv")[1:]


@table("scene", "level", "pressing", "error_over_u", "estimated_relative", "estimate_over_error")
def estimate_few_patches():
    return rows_of_test("error_control", "estimate/few_patches", "estimate_few_patches.csv")[1:]


@table("scene", "steps", "unknowns", "estimate", "true_error")
def graded_errors():
    for name, scene in (("A1 (smooth contact)", "a1"), ("B1 (root at the end)", "b1"), ("B3 (Hertz)", "b3"),
                        ("C4 (two contact sides)", "c4"), ("E2 (ring)", "e2"), ("ν = 0.4999", "nearly_incompressible"),
                        ("block on a parabola (singular corners)", "block_on_parabola")):
        run = measure(scene, {**target(1e-6), "Discretization/Coarsest level": 2})
        norm = run["estimated_energy"][-1] / run["estimated_relative"][-1]
        yield (name, len(run["level"]), int(run["dofs"][-1]), power(run["estimated_relative"][-1]), power(run["u_energy"][-1] / norm))
