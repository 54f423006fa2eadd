#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Solves the dual problem of a run with 'Output/Compliance = true' once more, with another method, and builds C and F from
A, D, f and G (packages python3-scipy, python3-numpy). Exit code 1 if P differs by more than the tolerance of certificate.json
allows, or C or F by more than its bound of residuals.
usage: solve_dual.py RESULTS LEVEL"""
import json
import os
import sys

try:
    import numpy
    from scipy.io import mmread
    from scipy.linalg import cholesky, solve_triangular
    from scipy.optimize import nnls
    from scipy.sparse.linalg import splu
except ImportError:  # the python3 found first may be another one than Debian's, which has the package
    debian = "/usr/bin/python3"
    if os.path.exists(debian) and sys.executable != debian:
        os.execv(debian, [debian, *sys.argv])
    sys.exit(f"{os.path.basename(sys.argv[0])}: SciPy is missing; install it (the package python3-scipy in Debian).")


def is_singular(C):
    """More patches than nodes carry the same loads by many pressures: then C P and the displacements are unique, P is not."""
    return numpy.linalg.cond(C) > 1e12


def without_friction(C, F):
    """Q = -P >= 0 minimises Q'CQ/2 + Q'F, that is |L'Q + L^-1 F|^2/2 with C = LL'. Where C is singular, C + e takes its place and
    e(Q - Q before) is added to the gradient until that is rounding: proximal points."""
    e = 1e-8 * C.diagonal().mean() if is_singular(C) else 0.
    L, Q, before = cholesky(C + e * numpy.eye(len(C)), lower=True), numpy.zeros(len(C)), None
    while before is None or e * numpy.abs(Q - before).max() > 1e-12 * numpy.abs(C @ Q).max():
        before = Q
        Q, _ = nnls(L.T, -solve_triangular(L, F - e * before, lower=True))
    return -Q


def with_friction(C, F, s, c):
    """Sweeps: each block is the projection of its own minimiser onto P_n <= 0 or |P_t| <= s + c |P_n|."""
    m = len(s)
    P, blocks = numpy.zeros(len(C)), [[k] for k in range(m)] + [list(range(m + k, len(C), m)) for k in range(m)]
    for _ in range(100000):
        before = P.copy()
        for block in blocks:
            new = P[block] - (C[block] @ P - F[block]) / C[block, block].mean()
            k = block[0] - m
            if k < 0:
                P[block] = numpy.minimum(new, 0)
            else:
                bound, length = s[k] + c[k] * abs(P[k]), numpy.linalg.norm(new)
                P[block] = new * min(1, bound / length) if length > 0 else 0
        if numpy.abs(P - before).max() <= 1e-14 * numpy.abs(P).max():
            return P
    sys.exit("solve_dual.py: the sweeps do not end")


def main(results, level):
    def read(name):
        return mmread(f"{results}/{name}-{level:02d}.mtx")

    def exists(name):
        return os.path.exists(f"{results}/{name}-{level:02d}.mtx")

    if not exists("A"):
        sys.exit(f"solve_dual.py: {results} has no matrices of level {level}; a run with --set Output/Compliance=true writes them.")
    A, C, D, F, G, P, f = map(read, "ACDFGPf")
    # Bodies that move freely are where they were found: W = C P + B q - F.
    opening = (F - read("B") @ read("q") if exists("q") else F).ravel()
    again = with_friction(C, opening, read("s").ravel(), read("c").ravel()) if exists("s") else without_friction(C, opening)
    solve = splu(A.tocsc()).solve
    D = D.toarray()
    again = again.reshape(-1, 1)
    pressure = {"C P": (C @ P, C @ again)} if is_singular(C) else {"P": (P, again)}
    differences = {**pressure, "C": (C, D.T @ solve(D)), "F": (F, G - D.T @ solve(f))}
    if exists("q"):
        B, K, b, q = map(read, "BKbq")
        differences["work of free motions"] = (B.T @ P, K @ q - b)
    with open(f"{results}/certificate.json", encoding="utf-8") as file:
        certificate = json.load(file)
    allowed = dict.fromkeys(differences, certificate["residual_bound"])
    # The KKT residual r bounds |P - W/diag C| by r max(|P|, |F/diag C|): P differs by that times the condition of C where it presses.
    presses = numpy.flatnonzero(P)
    unit = numpy.sqrt(C.diagonal()[presses])
    condition = numpy.linalg.cond(C[numpy.ix_(presses, presses)] / numpy.outer(unit, unit)) if len(presses) else 1.0
    scale = max(1.0, numpy.linalg.norm(F.ravel() / C.diagonal()) / numpy.linalg.norm(P)) if len(presses) else 1.0
    if not is_singular(C):
        allowed["P"] = max(1e-8, certificate["tolerance"] * scale * condition)
    wrong = False
    for name, (written, again) in differences.items():
        difference = numpy.abs(written - again).max() / max(numpy.abs(written).max(), 1e-8 * numpy.abs(P).max())
        wrong = wrong or not difference <= allowed[name]
        print(f"{name}: largest relative difference {difference:.1e}, allowed {allowed[name]:.1e}")
    return 1 if wrong else 0


if __name__ == "__main__":
    if len(sys.argv) != 3 or not sys.argv[2].isdigit():
        asks = sys.argv[1:] in (["-h"], ["--help"])
        print(__doc__, file=sys.stdout if asks else sys.stderr)
        sys.exit(0 if asks else 2)
    sys.exit(main(sys.argv[1], int(sys.argv[2])))
