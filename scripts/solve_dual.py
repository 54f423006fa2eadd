#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Solves the dual problem of a run with 'Output/Compliance = true' once more, with another method, and builds C and F from
A, D, f and G (packages python3-scipy, python3-numpy). Exit code 1 if P, C or F differ.
usage: solve_dual.py RESULTS LEVEL"""
import json
import sys

import numpy
from scipy.io import mmread
from scipy.linalg import cholesky, solve_triangular
from scipy.optimize import nnls
from scipy.sparse.linalg import splu

results, level = sys.argv[1], int(sys.argv[2])
with open(f"{results}/answer.json", encoding="utf-8") as file:
    if "friction" in json.load(file):
        sys.exit(f"solve_dual.py: {results} has friction, whose bounds are in no file, allowed: runs without friction.")
A, C, D, F, G, P, f = (mmread(f"{results}/{name}-{level:02d}.mtx") for name in "ACDFGPf")

# Q = -P >= 0 minimises Q'CQ/2 + Q'F, that is |L'Q + L^-1 F|^2/2 with C = LL'.
L = cholesky(C, lower=True)
Q, _ = nnls(L.T, -solve_triangular(L, F, lower=True).ravel())

solve = splu(A.tocsc()).solve
D = D.toarray()
differences = {"P": (P, -Q.reshape(-1, 1)), "C": (C, D.T @ solve(D)), "F": (F, G - D.T @ solve(f))}
worst = 0.0
for name, (written, again) in differences.items():
    difference = numpy.abs(written - again).max() / numpy.abs(written).max()
    worst = max(worst, difference)
    print(f"{name}: largest relative difference {difference:.1e}")
sys.exit(0 if worst <= 1e-8 else 1)
