# SPDX-License-Identifier: MIT
# %% [markdown]
# # A powder layer with a sieve curve
#
# Powder beds of additive manufacturing are thin layers of grains whose sizes a sieve has measured, by mass. This
# fills a shallow tray with such a powder and compares what lies there with the curve.
# As a program, it writes its files into the folder that is given: `scripts/python examples/powder_layer.py powder`.

# %%
import sys
from pathlib import Path

import frostfill
import numpy as np

folder = Path(sys.argv[1] if len(sys.argv) > 1 and not sys.argv[1].startswith("-") else "powder")
folder.mkdir(parents=True, exist_ok=True)

# %% [markdown]
# ## The curve
#
# Diameters in the unit of the mesh (here millimetres), and the share of the mass that passes the sieve.

# %%
CURVE = """diameter, cumulative mass
0.020, 0
0.030, 18
0.040, 55
0.050, 85
0.060, 100
"""
(folder / "sieve.csv").write_text(CURVE)
sieves, passing = np.loadtxt(folder / "sieve.csv", delimiter=",", skiprows=1).T

# %% [markdown]
# ## The layer
#
# A tray of 0.8 mm x 0.8 mm that is 0.2 mm deep: some five grains.

# %%
WIDE, DEEP = 0.8, 0.2
corners = np.array([[x, y, z] for x in (0, WIDE) for y in (0, DEEP) for z in (0, WIDE)])
faces = np.array([[0, 1, 3], [0, 3, 2], [4, 6, 7], [4, 7, 5], [0, 4, 5], [0, 5, 1],
                  [2, 3, 7], [2, 7, 6], [0, 2, 6], [0, 6, 4], [1, 5, 7], [1, 7, 3]])
run = frostfill.fill(vertices=corners, triangles=faces, sizes=folder / "sieve.csv", units="mm",
                     spheres_until_full=True, motion="descend", seed=3)
print(f"{len(run.radii)} grains from {2 * run.radii.min():.3f} to {2 * run.radii.max():.3f} mm")

# %% [markdown]
# ## What lies there, sieved

# %%
mass = run.radii**3
found = np.array([100 * mass[2 * run.radii <= sieve].sum() / mass.sum() for sieve in sieves])
deviation = np.abs(found - passing).max()
for sieve, asked, lies in zip(sieves, passing, found):
    print(f"{sieve:.3f} mm: {asked:5.1f} % asked, {lies:5.1f} % there")

# %% [markdown]
# ## How dense the layer is, and whether sizes have parted

# %%
analysis = frostfill.analyse(run.centres, run.radii, run.vertices, run.triangles, only=["porosity", "sizes"],
                             bins=10, samples=1 << 17)
fraction = 4 / 3 * np.pi * mass.sum() / (WIDE * WIDE * DEEP)
middle = 1 - analysis.porosity_height["porosity"][3:6].mean()
print(f"the grains take {fraction:.3f} of the tray, {middle:.3f} in the middle of its depth")
