# SPDX-License-Identifier: LGPL-2.1-or-later
"""Tables of published answers; doc/formulas.md has their theory."""
import math

from tables.common import finest, measure, number, per_cent, power, solve, table, target

CATALAN = 0.915965594177219
# Westergaard's p* of prm/benchmarks/westergaard.prm.
WAVES = math.pi * 0.01 / 0.91


def graded_waves(share):
    settings = {"Discretization/Coarsest level": 2, "Load cases/Cases": "", "Constants/share": share}
    return solve("benchmarks/westergaard", {**target(1e-5), **settings})


class Roller:
    """A roller, its run, and Hertz' numbers with what normals of the body change to first order."""

    def __init__(self, scene, R, E, nu, force, settings=None):
        along_normals = (settings or {}).get("Contact/Direction") == "body"
        self.run = solve(f"benchmarks/{scene}", settings)
        self.half_width = math.sqrt(4 * force * R * (1 - nu**2) / (math.pi * E))
        self.pressure = 2 * force / (math.pi * self.half_width)
        tilt = (1 - 2 * nu) * (1 + nu) / E * self.pressure if along_normals else 0.
        self.slope = self.half_width / R
        self.linear_pressure = (2 * CATALAN - 1 / 3) / math.pi * tilt
        answer = self.run.answer
        zone = answer["contact_zones"][0]
        self.peak, self.half_zone = answer["peak_pressure"]["value"], zone["length"] / 2
        self.uncertainty = (zone["start"]["uncertainty"] + zone["end"]["uncertainty"]) / 2
        self.pressure_difference = self.peak / self.pressure - 1
        self.half_width_difference = self.half_zone / self.half_width - 1

    def rows(self, scene, unit, digits):
        p, a, places = self.pressure_difference, self.half_width_difference, max(0, 1 - math.floor(math.log10(self.uncertainty)))
        yield (scene, "peak pressure" + (unit and ", MPa"), number(self.pressure, digits), f"{number(self.peak, digits)} (hp)",
               per_cent(p), "finite body")
        yield (scene, "half width" + (unit and ", mm"), number(self.half_width, 5),
               f"{self.half_zone:.{places}f} ± {self.uncertainty:.{places}f} (hp)", per_cent(a),
               "finite body and discretisation")


NAFEMS = "nafems_cgs1", 50, 210000, 0.3, 35000


@table("scene", "quantity", "published", "computed", "difference", "consists_of")
def published_answers():
    run = measure("benchmarks/own_weight")
    yield "own_weight", "pressure", 2, number(run["max_pressure"][-1]), f"{power(run['p_l2'][-1], 0)} (L2)", "rounding"
    yield "own_weight", "u_y at nodes", "(y² − 2y)/3 − 1/2", "", f"{power(run['u_superclose_h1'][-1], 0)} (H1)", "rounding"
    for share, name, peak in ((0.25, "1/4", WAVES), (1.5, "3/2", 2.5 * WAVES)):
        scene = f"westergaard, share {name}"
        run = solve("benchmarks/westergaard", {"Constants/share": share, "Load cases/Cases": ""})
        found, order = run.answer["peak_pressure"]["value"], "discretisation, order 2"
        yield scene, "peak pressure", f"{peak:.7f}", f"{found:.7f} (level {run.level})", per_cent(found / peak - 1, 3), order
        answer = graded_waves(share).answer
        found = answer["peak_pressure"]["value"]
        yield scene, "peak pressure", f"{peak:.7f}", f"{found:.8f} (hp)", power(found / peak - 1), "discretisation"
        zone = answer["contact_zones"][0]
        if share < 1:
            yield (scene, "half width", "1/6", f"{zone['length']:.6f} ± {zone['end']['uncertainty']:.6f} (hp)",
                   power(zone["length"] - 1 / 6), "discretisation")
    yield from Roller("hertz_line", 8, 200, 0.3, 10).rows("hertz_line", "", 5)
    yield from Roller("hertz_mesh_file", 1, 1, 0.3, 0.00625).rows("hertz_mesh_file", "", 5)
    yield from Roller(*NAFEMS).rows("nafems_cgs1", "MPa", 5)
    aluminium = "nafems_cgs1", 50, 52500, 0.3, 35000, {"Material/Young's modulus": 52500}
    yield from Roller(*aluminium).rows("nafems_cgs1, E = 52500", "MPa", 5)
    arm, pressure = punch(32)
    yield ("flat_punch", "lever arm of a half", f"{2 / math.pi:.6f}", f"{arm:.6f} (hp, target 1e-4)",
           per_cent(arm * math.pi / 2 - 1, 3), "finite body")
    yield ("flat_punch", "pressure in the middle", f"{10 / math.pi:.4f}", f"{pressure:.4f} (hp, target 1e-4)",
           per_cent(pressure * math.pi / 10 - 1), "finite body, discretisation")


@table("mesh", "level_or_step", "unknowns", "p_l2", "p_dual", "peak_pressure", "half_width")
def westergaard():
    for mesh, run in (("nested", measure("benchmarks/westergaard", {"Load cases/Cases": ""})),
                      ("graded", graded_waves(0.25).table)):
        for row in range(len(run["level"])):
            yield (mesh, int(run["level"][row]), int(run["dofs"][row]), power(run["p_l2"][row]), power(run["p_dual"][row]),
                   f"{run['peak_pressure'][row]:.7f}", f"{run['contact_length'][row]:.5f}")


@table("mesh", "level_or_step", "unknowns", "peak_pressure", "travel", "half_width")
def hertz_line():
    along = {"Contact/Direction": "body"}
    nested = {"Discretization/Strategy": "nested", "Discretization/Target error": 0, **finest(8), **along}
    for mesh, settings, first in (("nested", nested, 5), ("graded", along, 1)):
        run = measure("benchmarks/hertz_line", settings)
        for row in range(len(run["level"])):
            if run["level"][row] >= first:
                yield (mesh, int(run["level"][row]), int(run["dofs"][row]), f"{run['peak_pressure'][row]:.5f}",
                       f"{run['plate_travel'][row]:.7f}", f"{run['contact_length'][row] / 2:.4f}")


@table("direction", "force", "nu", "a_over_R", "peak_over_p0", "linear_theory", "rest", "rest_over_a_over_R_squared")
def roller_theory():
    cases = (40, 0.3), (10, 0.3), (2.5, 0.3), (0.625, 0.3), (10, 0), (10, 0.49)
    for direction in ("foundation", "body"):
        along = {"Contact/Direction": direction}
        rollers = [(force, nu, Roller("hertz_line", 8, 200, nu, force, {
            "Load/Plate force": f"flat: {force}", "Material/Poisson's ratio": nu, **along})) for force, nu in cases]
        for force, nu, roller in [*rollers, ("35000 (NAFEMS)", 0.3, Roller(*NAFEMS, along))]:
            rest = roller.pressure_difference - roller.linear_pressure
            yield (direction, force, nu, f"{roller.slope:.3f}", per_cent(roller.pressure_difference, 3),
                   per_cent(roller.linear_pressure, 3), per_cent(rest, 3), f"{rest / roller.slope**2:.3f}")


def punch(width):
    """Returns the lever arm of half a punch under a block of this half width and height, and the pressure in its middle."""
    run = solve("benchmarks/flat_punch", {**target(1e-4), "Geometry/Upper right": f"{width}, {width}", "Constants/width": width})
    force = run.answer["contact_force"]
    contact = run.contact()
    return force["moment"] / force["force"][1], -contact["p_H"][contact["x"].argmin()]


@table("w_over_a", "lever_arm", "difference", "times_w_over_a_squared", "pressure_in_middle")
def flat_punch():
    for width in (8, 16, 32, 64):
        arm, pressure = punch(width)
        difference = arm - 2 / math.pi
        yield width, f"{arm:.6f}", f"{difference:+.6f}", f"{difference * width**2:.3f}", per_cent(pressure * math.pi / 10 - 1)
