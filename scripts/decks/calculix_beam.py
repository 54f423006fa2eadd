#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""beam.prm in CalculiX 2.20: CPS8, contact of surfaces with a linear overclosure on a fixed row of elements.

    /usr/bin/python3 calculix_beam.py M FOLDER     writes FOLDER/beam.inp (8 M x M elements), runs ccx, writes FOLDER/beam.vtu"""
import subprocess
import sys

import numpy as np

M, folder = int(sys.argv[1]), sys.argv[2]
nx, ny = 8 * M, M
# The corners and middles of edges of a lattice of half elements.
numbers = {}
for j in range(2 * ny + 1):
    for i in range(2 * nx + 1):
        if i % 2 == 0 or j % 2 == 0:
            numbers[i, j] = len(numbers) + 1
points = {n: (i / (2 * M), j / (2 * M)) for (i, j), n in numbers.items()}
steps = (0, 0), (2, 0), (2, 2), (0, 2), (1, 0), (2, 1), (1, 2), (0, 1)
cells = [[numbers[2 * i + a, 2 * j + b] for a, b in steps] for j in range(ny) for i in range(nx)]

# Nodal loads of the traction, by Gauss' rule on the edges of the top.
loads = np.zeros(len(numbers) + 1)
gauss, weights = np.polynomial.legendre.leggauss(6)
for i in range(nx):
    for s, w in zip(gauss, weights):
        t = -0.1 * np.sin(np.pi * (i + (1 + s) / 2) / M / 8)
        for a, shape in ((0, s * (s - 1) / 2), (1, 1 - s * s), (2, s * (s + 1) / 2)):
            loads[numbers[2 * i + a, 2 * ny]] += w / (2 * M) * t * shape

n_points, n_cells = len(numbers), len(cells)
foundation = [(-1, -0.6), (9, -0.6), (9, -0.1), (-1, -0.1)]
with open(f"{folder}/beam.inp", "w", encoding="ascii") as deck:
    def lines(head, rows):
        deck.write(head + "\n" + "".join(",".join(map(str, row)) + "\n" for row in rows))
    lines("*NODE, NSET=BEAM", ((n, *x, 0) for n, x in points.items()))
    lines("*NODE, NSET=FIXED", ((n_points + 1 + k, *x, 0) for k, x in enumerate(foundation)))
    lines("*ELEMENT, TYPE=CPS8, ELSET=EBEAM", ((k + 1, *cell) for k, cell in enumerate(cells)))
    lines("*ELEMENT, TYPE=CPS4, ELSET=EFIXED", [(n_cells + 1, *range(n_points + 1, n_points + 5))])
    lines("*NSET, NSET=LEFT", ((numbers[0, j],) for j in range(2 * ny + 1)))
    lines("*SURFACE, NAME=LOWER", ((k + 1, "S1") for k in range(nx)))
    lines("*SURFACE, NAME=TOP", [(n_cells + 1, "S3")])
    deck.write("*MATERIAL, NAME=M\n*ELASTIC\n1000.,0.3\n*SOLID SECTION, ELSET=EBEAM, MATERIAL=M\n1.\n"
               "*SOLID SECTION, ELSET=EFIXED, MATERIAL=M\n1.\n*SURFACE INTERACTION, NAME=I\n"
               "*SURFACE BEHAVIOR, PRESSURE-OVERCLOSURE=LINEAR\n1.e5\n"
               "*CONTACT PAIR, INTERACTION=I, TYPE=SURFACE TO SURFACE\nLOWER,TOP\n"
               "*BOUNDARY\nLEFT,1,2\nFIXED,1,2\n*STEP, INC=100\n*STATIC\n0.2,1.\n")
    lines("*CLOAD", ((n, 2, f"{loads[n]:.10e}") for n in range(1, n_points + 1) if loads[n] != 0))
    deck.write("*NODE PRINT, NSET=BEAM\nU\n*END STEP\n")
subprocess.run(["ccx", "beam"], cwd=folder, check=True, stdout=subprocess.DEVNULL)

u = np.zeros((n_points, 3))
with open(f"{folder}/beam.dat", encoding="ascii") as results:
    for line in results:
        words = line.split()
        if len(words) == 4 and words[0].isdigit() and int(words[0]) <= n_points:
            u[int(words[0]) - 1, :2] = float(words[1]), float(words[2])   # the last increment stays


def data(name, kind, rows):
    text = "\n".join(" ".join(map(str, row)) for row in rows)
    return f'<DataArray type="{kind}" Name="{name}" NumberOfComponents="{len(rows[0])}" format="ascii">\n{text}\n</DataArray>\n'


with open(f"{folder}/beam.vtu", "w", encoding="ascii") as file:
    file.write('<VTKFile type="UnstructuredGrid" version="0.1" byte_order="LittleEndian"><UnstructuredGrid>\n'
               f'<Piece NumberOfPoints="{n_points}" NumberOfCells="{n_cells}">\n<Points>\n'
               + data("points", "Float64", [(*x, 0.) for x in points.values()]) + "</Points>\n<Cells>\n"
               + data("connectivity", "Int64", [[n - 1 for n in cell] for cell in cells])
               + data("offsets", "Int64", [[8 * (k + 1)] for k in range(n_cells)])
               + data("types", "UInt8", [[23]] * n_cells) + "</Cells>\n<PointData>\n"
               + data("displacement", "Float64", u) + "</PointData></Piece></UnstructuredGrid></VTKFile>\n")
