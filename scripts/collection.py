#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Makes the collection of doc/collection.md: contact problems on sequences of meshes, FOLDER/PROBLEM/C-LL.mtx and so on, and
checks each: another method finds the same optimum (1e-8), the KKT residual is small, and numbers agree with
doc/measured/collection.csv (packages python3-scipy, python3-numpy). Exit code 1 if something differs.

    python3 scripts/collection.py FOLDER              makes all problems
    python3 scripts/collection.py FOLDER PROBLEM...   or these
    python3 scripts/collection.py FOLDER --write      and writes doc/measured/collection.csv anew

The program is build/release/source/signorini, or SIGNORINI in the environment."""
import csv
import glob
import os
import sys

from solve_dual import is_singular, mmread, numpy, with_friction, without_friction

ROOT = os.path.dirname(os.path.dirname(os.path.realpath(__file__)))
sys.path.insert(0, ROOT + "/python")
import signorini

TABLE = ROOT + "/doc/measured/collection.csv"
# Each problem: a scene of prm, and what differs from it.
PROBLEMS = {
    "parabola": ("block_on_parabola", {"Discretization/Finest level": 6}),
    "fine_patches": ("a1", {"Discretization/Patch ratio": 1, "Discretization/Finest level": 6}),
    "redundant": ("block_on_parabola", {"Discretization/Patches": 20, "Discretization/Finest level": 5}),
    "free_roller": ("roller_on_table", {"Discretization/Strategy": "nested", "Discretization/Coarsest level": 1,
                                        "Discretization/Finest level": 4}),
    "graded": ("questions/strip", {}),
    "two_bodies": ("bodies/block_on_base", {"Discretization/Finest level": 5}),
    "tresca": ("questions/chatter", {}),
    "coulomb": ("friction/hild_block", {"Discretization/Finest level": 6}),
    "sphere": ("space/sphere", {"Discretization/Coarsest level": 2, "Discretization/Finest level": 4}),
    "torsion": ("friction/torsion", {"Discretization/Finest level": 4}),
}
COLUMNS = ("problem", "level", "unknowns", "multipliers", "condition", "presses", "sticks", "slips", "loop", "objective", "energy",
           "energy_lower", "energy_upper")
OPEN, STICKS, SLIPS = 0, 1, 2


class Problem:
    """The dual problem of one level: C, F, s, c and B, K, b, q of the files; n is their length, m the number of patches."""

    def __init__(self, folder, level):
        def read(name, default):
            path = f"{folder}/{name}-{level}.mtx"
            return mmread(path) if os.path.exists(path) else default
        self.C, self.F, self.P = read("C", None), read("F", None).ravel(), read("P", None).ravel()
        self.unknowns, self.n = read("f", None).size, len(self.F)
        self.s, self.c = read("s", numpy.zeros(0)).ravel(), read("c", numpy.zeros(0)).ravel()
        self.m = len(self.s) or self.n
        self.B, self.q = read("B", numpy.zeros((self.n, 0))), read("q", numpy.zeros(0)).ravel()
        self.K, self.b = read("K", numpy.zeros((0, 0))), read("b", numpy.zeros(0)).ravel()
        self.rows = self.n // self.m
        self.condition = numpy.linalg.cond(self.C)

    def opening(self, P, q):
        """W = CP + Bq - F."""
        return self.C @ P + self.B @ q - self.F

    def tangential(self, P):
        """P_t, one column per component in the side."""
        return P[self.m:].reshape(self.rows - 1, self.m).T

    def states(self, P, q):
        """The states that P - W/diag C has, by patch, and its projection onto the admissible set."""
        scale = numpy.tile(numpy.diag(self.C).reshape(self.rows, self.m)[1:].mean(axis=0), self.rows - 1) if self.rows > 1 else []
        a = P - self.opening(P, q) / numpy.concatenate([numpy.diag(self.C)[:self.m], scale])
        states, projected = numpy.where(a[:self.m] < 0, STICKS, OPEN), numpy.minimum(a, 0)
        if self.rows > 1:
            bound, length = self.s + self.c * numpy.maximum(-a[:self.m], 0), numpy.linalg.norm(self.tangential(a), axis=1)
            slips = length >= bound
            states = numpy.where((states != OPEN) & slips, SLIPS, states)
            share = numpy.where(slips, bound / numpy.maximum(length, 1e-300), 1)
            projected[self.m:] = a[self.m:] * numpy.tile(share, self.rows - 1)
        return states, projected

    def residual(self, P, q):
        """|P - projection of (P - W/diag C)|, relative, and what the free motions lack."""
        lacking = self.K @ q - self.B.T @ P - self.b
        return max(numpy.abs(P - self.states(P, q)[1]).max(), numpy.abs(lacking).max(initial=0)) / numpy.abs(P).max()

    def objective(self, P, q):
        """P'CP/2 - F'P, less the work of free motions."""
        return P @ self.C @ P / 2 - self.F @ P + q @ self.B.T @ P - q @ self.K @ q / 2 + self.b @ q

    def solve_on(self, pressing, signs):
        """P and q where these patches press, and P_t = sign (s + c|P_n|) where there is a sign."""
        n, k = self.n, len(self.q)
        M, right = numpy.block([[self.C, self.B], [-self.B.T, self.K]]), numpy.concatenate([self.F, self.b])
        for i in range(self.m):
            if not pressing[i]:
                M[i], right[i] = numpy.eye(n + k)[i], 0
            if self.rows == 2 and signs[i] is not None:
                M[self.m + i], right[self.m + i] = numpy.eye(n + k)[self.m + i], signs[i] * self.s[i]
                M[self.m + i, i] += signs[i] * self.c[i]
        return numpy.split(numpy.linalg.solve(M, right), [n])

    def loop(self):
        """The plain active set loop, begun with open contact, or full contact where that leaves bodies free: P, q and the number
        of solves, or None, None and "cycles" or "singular"."""
        pressing, signs, seen = [len(self.q) > 0] * self.m, [0] * self.m, set()
        while (key := (*pressing, *signs)) not in seen:
            seen.add(key)
            try:
                P, q = self.solve_on(pressing, signs)
            except numpy.linalg.LinAlgError:
                return None, None, "singular"
            a = P - self.opening(P, q) / numpy.diag(self.C)
            pressing = list(a[:self.m] < 0)
            if self.rows == 2:
                bound = self.s + self.c * numpy.maximum(-a[:self.m], 0)
                signs = [numpy.sign(t) if abs(t) >= limit else None for t, limit in zip(a[self.m:], bound)]
            if (*pressing, *signs) == key:
                return P, q, len(seen)
        return None, None, "cycles"

    def again(self, looped):
        """P and q by a method that knows nothing of those of the files."""
        if len(self.q):
            return looped[:2]
        P = with_friction(self.C, self.F, self.s, self.c) if len(self.s) else without_friction(self.C, self.F)
        return P, self.q


def make_rows(name, folder, wrong):
    """Runs a problem; the rows of the table, and in wrong what does not hold."""
    scene, settings = PROBLEMS[name]
    settings = {"Output/Compliance": "true", "Output/VTU": "none", "Output/Inf-sup constant": "false", "Output/Errors": "false",
                "Solver/Tolerated error": 9, **settings}
    table = signorini.run(f"{ROOT}/prm/{scene}.prm", folder, **settings).table
    for path in sorted(glob.glob(f"{folder}/C-*.mtx")):
        level = path[-6:-4]
        row = list(table["level"]).index(int(level))
        problem = Problem(folder, level)
        looped = problem.loop() if problem.rows < 3 else (None, None, "")
        P, q = problem.again(looped)
        residual = problem.residual(problem.P, problem.q)
        unique = not is_singular(problem.C)
        difference = numpy.abs(P - problem.P if unique else problem.C @ (P - problem.P)).max()
        difference /= numpy.abs(problem.P if unique else problem.C @ problem.P).max()
        for what, value in ("KKT residual", residual), ("difference from another method", difference):
            if not value <= 1e-8:
                wrong.append(f"{name} {level}: {what} {value:.1e}, allowed 1e-8")
        states = problem.states(problem.P, problem.q)[0]
        counts = [(states != OPEN).sum(), (states == STICKS).sum() if len(problem.s) else "", (states == SLIPS).sum() if len(problem.s) else ""]
        energies = [table[column][row] if column in table else numpy.nan for column in COLUMNS[-3:]]
        yield [name, int(level), problem.unknowns, problem.n, f"{problem.condition:.3e}", *counts, looped[2],
               f"{problem.objective(problem.P, problem.q):.12e}", *("" if numpy.isnan(e) else f"{e:.12e}" for e in energies)]


def compare(rows, stored, wrong):
    """Counts are equal, the condition and bounds to a hundredth of their digits, optima to 1e-8."""
    for row in rows:
        known = stored.get((row[0], str(row[1])))
        if known is None:
            wrong.append(f"{row[0]} {row[1]}: not in {TABLE}")
            continue
        for column, value, expected in zip(COLUMNS[2:], map(str, row[2:]), known[2:]):
            number = column in ("condition", *COLUMNS[-4:])
            singular = float(known[COLUMNS.index("condition")]) > 1e12
            if number and value and expected:
                tolerance = {"condition": 1e-2, "energy_lower": 1e-3, "energy_upper": 1e-3}.get(column, 1e-8)
                same = abs(float(value) - float(expected)) <= tolerance * abs(float(expected)) or (column == "condition" and singular)
            else:
                same = value == expected or singular
            if not same:
                wrong.append(f"{row[0]} {row[1]}: {column} is {value}, and {expected} in {TABLE}")


def main(arguments):
    names = [a for a in arguments[1:] if a != "--write"] or list(PROBLEMS)
    wrong, rows = [name for name in names if name not in PROBLEMS], []
    if not arguments or arguments[0].startswith("-") or wrong:
        asks = arguments in (["-h"], ["--help"])
        print(f"{__doc__}\nproblems: {', '.join(PROBLEMS)}", file=sys.stdout if asks else sys.stderr)
        return 0 if asks else 2
    for name in names:
        made = list(make_rows(name, f"{arguments[0]}/{name}", wrong))
        rows += made
        print(f"{name}: {len(made)} problems of {made[0][3]} to {made[-1][3]} multipliers", flush=True)
    if "--write" in arguments:
        with open(TABLE, "w", encoding="utf-8", newline="") as file:
            csv.writer(file, lineterminator="\n").writerows([COLUMNS, *rows])
    else:
        with open(TABLE, encoding="utf-8", newline="") as file:
            compare(rows, {(row[0], row[1]): row for row in csv.reader(file)}, wrong)
    for sentence in wrong:
        print(f"collection.py: {sentence}", file=sys.stderr)
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
