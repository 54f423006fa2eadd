# SPDX-License-Identifier: LGPL-2.1-or-later
# %% [markdown]
# # A sweep of two parameters
#
# How does the peak pressure under half a cylinder depend on its radius and on its modulus?

# %%
import pathlib

import matplotlib.pyplot as plt
import numpy as np
import signorini

pathlib.Path("roller.prm").write_text("""
subsection Constants
  set Values = R=8
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
  set Plate force = flat: 10
end
subsection Contact
  set Foundation = plane 0,-R normal 0,1
end
""", encoding="utf-8")

# %% [markdown]
# Lists of values make a sweep: of a constant by its name, of any other entry by section and name. Every
# combination is a run in a folder of its own, and what has one value holds for all of them.

# %%
radii, moduli = [4, 8, 16], [200, 800]
peaks = {}
for point, run in signorini.sweep("roller.prm", "results/roller", R=radii,
                                  **{"Material/Young's modulus": moduli, "Discretization/Target error": 0.02}):
    assert run.verdict == "certified"
    radius, modulus = point["R"], point["Material/Young's modulus"]
    peaks[radius, modulus] = run.answer["peak_pressure"]["value"]
    print(f"R = {radius} mm, E = {modulus} MPa: {peaks[radius, modulus]:.3f} MPa")

# %% [markdown]
# By Hertz the peak is (F E*/(π R))^{1/2}: twice as much for four times the modulus, in a zone that is small.

# %%
def hertz(radius, modulus):
    return np.sqrt(10 * modulus / (1 - 0.3**2) / (np.pi * radius))


figure, axes = plt.subplots(figsize=(6, 3.5))
curve = np.linspace(4, 16)
for modulus in moduli:
    axes.plot(curve, hertz(curve, modulus), label=f"Hertz, E = {modulus} MPa")
    axes.plot(radii, [peaks[radius, modulus] for radius in radii], "ko")
axes.set(xlabel="radius (mm)", ylabel="peak pressure (MPa)")
axes.legend()
figure.savefig("sweep.png", bbox_inches="tight")
assert all(abs(peak / hertz(*point) - 1) < 0.02 for point, peak in peaks.items())
