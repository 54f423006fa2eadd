# SPDX-License-Identifier: LGPL-2.1-or-later
# %% [markdown]
# # How wrong is the result of another program?
#
# Here the other program is thirty lines of numpy: bilinear elements and a penalty, for the block that is
# lowered by 0.05 onto a foundation that falls away like x²/4.

# %%
import pathlib

import numpy as np
import signorini

pathlib.Path("block.prm").write_text("""
subsection Geometry
  set Lower left  = -1, 0
  set Upper right = 1, 1
  set Cells       = 2, 1
end
subsection Material
  set Young's modulus = 1
  set Poisson's ratio = 0.3
end
subsection Boundary
  set Displacement = top: 0; -0.05
  set Contact      = bottom
end
subsection Contact
  set Gap = x^2/4
end
""", encoding="utf-8")


def solve_by_penalty(n, penalty):
    """Returns points, cells and the displacement at points of n x 2n squares."""
    x, y = (axis.ravel() for axis in np.meshgrid(np.linspace(-1, 1, 2 * n + 1), np.linspace(0, 1, n + 1)))
    first = [j * (2 * n + 1) + i for j in range(n) for i in range(2 * n)]
    cells = np.array(first)[:, None] + [0, 1, 2 * n + 2, 2 * n + 1]
    lame, shear = 0.3 / (1.3 * 0.4), 1 / 2.6
    hooke = np.array([[lame + 2 * shear, lame, 0], [lame, lame + 2 * shear, 0], [0, 0, shear]])
    square = np.zeros((8, 8))  # the stiffness of a square: the same for all sizes
    for a, b in np.array([[-1, -1], [1, -1], [1, 1], [-1, 1]]) / np.sqrt(3):
        dx, dy = np.array([[b - 1, 1 - b, 1 + b, -1 - b], [a - 1, -1 - a, 1 + a, 1 - a]]) / 4
        strain = np.zeros((3, 8))
        strain[0, 0::2], strain[1, 1::2], strain[2, 0::2], strain[2, 1::2] = dx, dy, dy, dx
        square += strain.T @ hooke @ strain
    stiffness = np.zeros((2 * len(x), 2 * len(x)))
    for cell in cells:
        unknowns = np.stack([2 * cell, 2 * cell + 1], axis=1).ravel()
        stiffness[np.ix_(unknowns, unknowns)] += square
    u = np.zeros(2 * len(x))
    held = np.flatnonzero(y == 1)
    u[2 * held + 1] = -0.05
    free = np.setdiff1d(np.arange(2 * len(x)), np.concatenate([2 * held, 2 * held + 1]))
    bottom = np.flatnonzero(y == 0)
    touching = np.ones(len(bottom), bool)
    for _ in range(20):
        matrix, load = stiffness.copy(), -stiffness @ np.where(np.isin(np.arange(len(u)), free), 0, u)
        springs = 2 * bottom[touching] + 1
        matrix[springs, springs] += penalty / n
        load[springs] -= penalty / n * x[bottom[touching]]**2 / 4
        u[free] = np.linalg.solve(matrix[np.ix_(free, free)], load[free])
        touching = u[2 * bottom + 1] < -x[bottom]**2 / 4
    return np.stack([x, y], axis=1), cells, u.reshape(-1, 2)


# %% [markdown]
# `signorini.verify` takes the points, the cells and the displacement (or a .vtu file) and returns an interval
# that contains the error, whatever made the displacement.

# %%
errors = {}
for n, penalty in ((8, 10), (8, 1000), (16, 1000)):
    found = signorini.verify("block.prm", solve_by_penalty(n, penalty), **{"Discretization/Target error": 1e-3})
    errors[n, penalty] = found["relative"]["value"]
    print(f"{n} x {2 * n} squares, penalty {penalty}: {100 * errors[n, penalty]:.3f} % +- "
          f"{100 * found['relative']['margin']:.1g} %, penetrates by {found['penetration']['value']:.2g}")
    assert found["guaranteed"]

# %% [markdown]
# A soft penalty costs more than the mesh; with a stiff one halving the cells halves the error.

# %%
assert errors[8, 10] > errors[8, 1000]
assert 1.6 < errors[8, 1000] / errors[16, 1000] < 2.4
