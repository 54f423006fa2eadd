#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""prm/block_on_parabola.prm or prm/described_a1.prm in dolfinx 0.5: plane strain, contact by a penalty.

    /usr/bin/python3 dolfinx_block_and_a1.py block|a1 DEGREE triangle|quadrilateral N PENALTY FILE.pvd

writes FILE.pvd and the VTU file that it names."""
import sys

import numpy as np
import ufl
from dolfinx import fem, io, mesh, nls
from mpi4py import MPI
from petsc4py import PETSc

scene, degree, shape, n, kappa, file = sys.argv[1], int(sys.argv[2]), sys.argv[3], int(sys.argv[4]), float(sys.argv[5]), sys.argv[6]
is_block = scene == "block"
left = -1. if is_block else 0.
body = mesh.create_rectangle(MPI.COMM_WORLD, [[left, 0.], [1., 1.]], [2 * n if is_block else n, n], getattr(mesh.CellType, shape))
V = fem.VectorFunctionSpace(body, ("Lagrange", degree))
u, v = fem.Function(V), ufl.TestFunction(V)
x, y = ufl.SpatialCoordinate(body)
rise, ends = ufl.max_value(1 / np.sqrt(2) - x, 0), ufl.max_value(x - 1 / np.sqrt(2), 0)
if is_block:
    E, nu, gap, load, top = 1., 0.3, x**2 / 4, None, (0., -0.05)
else:
    E, nu, gap, top = 2.5, 0.25, -0.1 * x * (1 - x) + ends**2, (0., 0.)
    load = ufl.as_vector((rise**2 * (60 * y**2 - 20) + 0.2 * x**2 + 0.4 * x * y + 0.2 * y**2 - 0.2 * y - 7 / 15,
                          -60 * rise**3 * y + 20 * rise * (y - y**3) - 0.6 * x**2 - 0.4 * x * y + 0.6 * x + y**2 - 0.2))
    traction = ufl.as_vector((10 * rise**3 * (y**2 - 1 / 3) + 0.2 * x**2 * y - 0.4 * x * y**2 - 0.2 * x * y + 8 * x / 15 - 0.6 * y**3
                              + 0.6 * y, 10 * rise**2 * (y - y**3) - 0.2 * x**2 * y - 0.4 * x * y**2 + y**3 / 15 + 0.2 * y**2 - y / 15))
lam, mu = E * nu / ((1 + nu) * (1 - 2 * nu)), E / (2 * (1 + nu))

fdim = body.topology.dim - 1
sides = [lambda p: np.isclose(p[1], 0), lambda p: np.isclose(p[0], 1), lambda p: np.isclose(p[0], left)]
found = [mesh.locate_entities_boundary(body, fdim, side) for side in sides]
facets, marks = np.concatenate(found), np.concatenate([np.full(len(f), k, np.int32) for k, f in enumerate(found)])
order = np.argsort(facets)
ds = ufl.Measure("ds", body, subdomain_data=mesh.meshtags(body, fdim, facets[order], marks[order]), metadata={"quadrature_degree": 8})
dx = ufl.Measure("dx", body, metadata={"quadrature_degree": 8})
held = fem.locate_dofs_geometrical(V, lambda p: np.isclose(p[1], 1))
conditions = [fem.dirichletbc(np.array(top, dtype=PETSc.ScalarType), held, V)]

eps = ufl.sym(ufl.grad(u))
pressure = kappa * ufl.max_value(-u[1] - gap, 0)
F = ufl.inner(lam * ufl.tr(eps) * ufl.Identity(2) + 2 * mu * eps, ufl.sym(ufl.grad(v))) * dx - pressure * v[1] * ds(0)
if load is not None:
    F += -ufl.inner(load, v) * dx - ufl.inner(traction, v) * ds(1) + ufl.inner(traction, v) * ds(2)
u.x.array[1::2] = -0.05
solver = nls.petsc.NewtonSolver(MPI.COMM_WORLD, fem.petsc.NonlinearProblem(F, u, conditions))
solver.convergence_criterion, solver.atol, solver.rtol, solver.max_it = "incremental", 1e-12, 1e-12, 60
solver.krylov_solver.setType("preonly")
solver.krylov_solver.getPC().setType("lu")
solver.solve(u)
print("contact force", fem.assemble_scalar(fem.form(pressure * ds(0))))

u.name = "displacement"
with io.VTKFile(MPI.COMM_WORLD, file, "w") as out:
    out.write_function(u)
