# SPDX-License-Identifier: LGPL-2.1-or-later
"""The table of the statements of the paper: runs, columns of convergence.csv, and the orders that the paper and doc/paper.md
predict."""
import functools

import numpy as np
import signorini

from tables.common import levels, number, power, solve, table

U, NODES, PATCHES, P, DUAL = "‖u − u_h‖₁", "‖I^h u − u_h‖₁", "‖u − π^{2h}u_h‖₁", "‖p − p_H‖₀", "|||p − p_H|||"
SUP_V, SUP_Q = "sup over V^h", "sup over Q^H, cosine norm"


def ratio(n):
    return "Discretization/Patch ratio", n


def scene(name):
    return "Scene/Name", name


def ring(name, coarsest, finest_level):
    return (scene(name), *levels(coarsest, finest_level).items())


THEOREM_5 = [((), "5/4", "2"), ((ratio(4),), "5/4", "3/2"), ((scene("B1"),), "", "3/2"), ((scene("B1q"),), "", "3/2")]
CURVED = [(ring("E3", 4, 7), "", ""), (ring("E1", 2, 5), "", "")]
# Statement, what it says, quantity, column, file of prm/paper, and for each run its settings and the orders of the paper and of
# doc/paper.md.
ORDERS = [
    ("Lemma 2", "p − R^H p", "‖p − R^H p‖₀", "lemma_2_l2", "lemma_2_3_5", [((), "1", "1")]),
    ("Lemma 2", "p − R^H p", "|||p − R^H p|||, cosine norm", "lemma_2_dual", "lemma_2_3_5", [((), "3/2", "3/2")]),
    ("Lemma 3", "u − I^h u", "‖u − I^h u‖₁", "lemma_3_h1", "lemma_2_3_5", [((), "1", "1")]),
    ("Lemma 3", "on Γ_c", "‖B(u − I^h u)‖_{1/2,Γ_c}, cosine norm", "lemma_3_trace", "lemma_2_3_5", [((), "3/2", "3/2")]),
    ("Theorem 3 (13)", "B1", U, "u_h1", "theorem_3", [((), "1 − ε", "1")]),
    ("Theorem 3 (14)", "B1", P, "p_l2", "theorem_3", [((), "1/2 − ε", "1")]),
    ("Theorem 3 (15)", "B1", DUAL, "p_dual", "theorem_3", [((), "1 − ε", "3/2")]),
    ("Remark 1", "ε = 0 if g, u in W^{1,∞}", U, "u_h1", "remark_1", [((), "1", "1")]),
    ("Remark 1", "ε = 0 if g, u in W^{1,∞}", P, "p_l2", "remark_1", [((), "1/2", "1")]),
    ("Remark 1", "ε = 0 if g, u in W^{1,∞}", DUAL, "p_dual", "remark_1", [((), "1", "3/2")]),
    ("Lemmas 4 and 5", "a(u − I^h u, v) ≤ c h^{3/2} ‖v‖₁", SUP_V, "lemma_5", "lemma_2_3_5",
     [((), "3/2", "2"), ((scene("O1"),), "3/2", "2"), ((scene("V1"),), "3/2", "2")]),
    ("(26)", "[p − R^H p, Bv]", SUP_V, "bound_26", "lemma_2_3_5", [((), "3/2", "2"), ((ratio(4),), "3/2", "3/2")]),
    ("(27)", "[q, B(I^h u − u)]", SUP_Q, "bound_27", "lemma_2_3_5", [((), "3/2", "2")]),
    ("Theorem 5 (24)", "superconvergence", NODES, "u_superclose_h1", "theorem_5", THEOREM_5),
    ("Theorem 5 (25)", "superconvergence", "|||R^H p − p_H|||", "p_superclose_dual", "theorem_5",
     [((), "5/4", "2"), ((ratio(4),), "5/4", "3/2 to 2"), ((scene("B1"),), "", "3/2")]),
    ("(30)", "u − π^{2h}u", "‖u − π^{2h}u‖₁", "bound_30", "lemma_2_3_5", [((), "3/2", "2")]),
    ("Theorem 6 (31)", "interpolated", PATCHES, "u_post_h1", "theorem_6", THEOREM_5),
    ("Theorem 6 (32)", "pressure", DUAL, "p_dual", "theorem_6", [((), "5/4", "3/2"), ((ratio(4),), "5/4", "3/2"),
                                                                  ((scene("B1"),), "", "3/2")]),
    ("Theorem 6 (33)", "pressure", P, "p_l2", "theorem_6", [((), "3/4", "1"), ((ratio(4),), "3/4", "1"), ((scene("B1"),), "", "1")]),
    *(("Remark 2", f"{formula} if p in W^{{1,∞}}", name, column, "remark_2", [((), "3/2", sharp), ((scene("A2"),), "3/2", sharp)])
      for formula, name, column, sharp in (("(24)", NODES, "u_superclose_h1", "2"), ("(31)", PATCHES, "u_post_h1", "2"),
                                           ("(32)", DUAL, "p_dual", "3/2"))),
    *(("Remark 2", f"{formula}, smooth domains", name, column, "remark_2_smooth", [((), paper, sharp), *CURVED])
      for formula, name, column, paper, sharp in (
          ("(24)", NODES, "u_superclose_h1", "3/2", "2"), ("(31)", PATCHES, "u_post_h1", "3/2", "2"),
          ("(32)", DUAL + ", Fourier series", "p_dual_spectral", "3/2", "3/2"), ("(33)", P, "p_l2", "3/4", "1")))]


@functools.lru_cache(maxsize=None)
def columns_of(file, settings):
    return solve(f"paper/{file}", dict(settings)).table


def command(file, settings):
    return f"prm/paper/{file}.prm" + "".join(f" --set '{name}={value}'" for name, value in settings)


def other_statements():
    run = solve("patch_test")
    for quantity, column in (("u against u_h, H1", "u_h1"), ("p against p_H, L2", "p_l2")):
        yield "Theorem 1", "(3) has one solution, p = σ_n(u)", "prm/patch_test.prm", quantity, power(run.table[column][-1], 0), "", "", ""
    for settings, sharp in (((), "0.845"), ((ratio(3),), "0.8727"), ((ratio(4),), "0.8727")):
        betas = " ".join(f"{beta:.4f}" for beta in columns_of("lemma_1", settings)["inf_sup"])
        yield "Lemma 1 (6)", "β independent of h, H", command("lemma_1", settings), "β, levels 3 to 7", betas, "", "> 0", sharp
    run = columns_of("lemma_1", (ratio(1),))
    yield ("Lemma 1 (6)", "not for H = h", command("lemma_1", (ratio(1),)), "β/h, levels 3 to 7",
           " ".join(number(beta) for beta in run["inf_sup"] / run["h"]), "", "", "2.36")
    yield ("Theorem 2", "(5) has one solution", "tests/driver/study/contact_methods.cc", "U and P by all solvers", "equal to 1e-8", "", "",
           "")
    residuals = solve("a1").certificate["levels"][-1]
    for key in ("stationarity", "duality_gap"):
        yield "(22), (23)", "dual problem, U = A⁻¹(DP + f)", "prm/a1.prm, certificate.json", key, power(abs(residuals[key]), 0), "", "0", "0"
    for omega in (0.02, 0.1, 1, 1.5, 1.95, 1.99):
        settings = (("Solver/Relaxation", omega),)
        yield ("Theorem 4", "converges for 0 < ω < 2", command("theorem_4", settings), "sweeps until the increment is small",
               int(columns_of("theorem_4", settings)["qp_increment_iterations"][-1]), "", "finite", "")
    for omega in (0, 2):
        settings = (("Solver/Relaxation", omega),)
        try:
            columns_of("theorem_4", settings)
            found = "accepted"
        except signorini.Refused:
            found = "refused"
        yield "Theorem 4", "converges for 0 < ω < 2", command("theorem_4", settings), "exit code 1", found, "", "", ""


@table("statement", "says", "run", "quantity", "measured", "last_two_levels", "paper", "sharp")
def paper_orders():
    yield from other_statements()
    for statement, says, quantity, column, file, runs in ORDERS:
        for settings, paper, sharp in runs:
            run = columns_of(file, tuple(settings))
            h, error = np.log(run["h"]), np.log(run[column])
            yield (statement, says, command(file, settings), quantity, f"{np.polyfit(h, error, 1)[0]:.2f}",
                   f"{(error[-1] - error[-2]) / (h[-1] - h[-2]):.2f}", paper, sharp)
