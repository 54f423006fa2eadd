# SPDX-License-Identifier: LGPL-2.1-or-later
# %% [markdown]
# # A first run and its picture
#
# Half a cylinder of radius 8 mm is pressed onto a rigid plane with 10 N per mm of its length. The whole
# input is text; what it does not say (here the mesh) the program chooses.

# %%
import math
import pathlib

import matplotlib.pyplot as plt
import signorini

pathlib.Path("roller.prm").write_text("""
subsection Constants
  set Values = R=8, F=10
end
subsection Geometry
  set Shape  = half disc
  set Radius = R
end
subsection Material
  set Young's modulus = 200
  set Poisson's ratio = 0.3
end
subsection Boundary
  set Plates  = flat: 0, -1
  set Contact = arc
end
subsection Load
  set Plate force = flat: F
end
subsection Contact
  set Foundation = plane 0,-R normal 0,1
end
""", encoding="utf-8")
run = signorini.run("roller.prm", **{"Discretization/Target error": 1e-3})
print(run)

# %% [markdown]
# The answer is a dictionary of numbers. Hertz' formulas hold for a small zone in a large body: this one
# differs from them by a quarter of a percent.

# %%
half_width = math.sqrt(4 * 10 * 8 / (math.pi * 200 / (1 - 0.3**2)))
hertz = 2 * 10 / (math.pi * half_width)
peak = run.answer["peak_pressure"]["value"]
print(f"peak {peak:.4f} MPa, by Hertz {hertz:.4f} MPa")
assert run.verdict == "certified"
assert abs(peak / hertz - 1) < 4e-3
assert abs(run.answer["contact_force"]["force"][1] - 10) < 1e-8

# %% [markdown]
# Curves come as arrays: `p_H` is negative in compression, as all normal stresses.

# %%
contact = run.contact()
figure, axes = plt.subplots(figsize=(6, 3))
axes.plot(contact["x"], -contact["p_H"], label="computed")
inside = abs(contact["x"]) < half_width
axes.plot(contact["x"][inside], hertz * (1 - (contact["x"][inside] / half_width)**2)**0.5, "--", label="Hertz")
axes.set(xlim=(-1, 1), xlabel="x (mm)", ylabel="pressure (MPa)")
axes.legend()
figure.savefig("first_run.png", bbox_inches="tight")
