# SPDX-License-Identifier: MIT
# %% [markdown]
# # Porosity across a tube, beside published correlations
#
# Walls order spheres: the porosity swings across half a dozen layers. Reactor design uses correlations of it that
# were fitted to measured beds: those of [Mueller 1992] and of [de Klerk 2003], and for the whole cross section that
# of [Benyahia & O'Neill 2005]. This packs a tube of ten diameters and compares. As a program, it writes its files
# into the folder that is given, and packs a tube of as many diameters as you say behind it:
# `scripts/python examples/tube_porosity.py tube 10`. matplotlib draws the figure where it is installed.

# %%
import importlib.util
import sys
from pathlib import Path

import frostfill
import numpy as np

words = [word for word in sys.argv[1:] if not word.startswith("-")]
folder = Path(words[0] if words else "tube")
folder.mkdir(parents=True, exist_ok=True)

# %% [markdown]
# ## The tube, filled
#
# All spheres settle together, as in a bed that is poured and shaken. If each rests at its first support, the bed
# is loose and less in order: then the mean difference to de Klerk is 0.06, not 0.03.

# %%
RATIO = float(words[1]) if len(words) > 1 else 10  # tube over sphere
SIDES, LENGTH = 128, 15  # facets, diameters of a sphere
radius = 1 / RATIO
height = 2 * radius * LENGTH
turn = 2 * np.pi * np.arange(SIDES) / SIDES
ring = np.stack([np.cos(turn), 0 * turn, np.sin(turn)], 1)
vertices = np.concatenate([[[0, 0, 0], [0, height, 0]], ring, ring + [0, height, 0]])
triangles = []
for k in range(SIDES):
    low, next_low = 2 + k, 2 + (k + 1) % SIDES
    high, next_high = low + SIDES, next_low + SIDES
    triangles += [[0, low, next_low], [1, next_high, high], [low, high, next_high], [low, next_high, next_low]]
run = frostfill.fill(vertices=vertices, triangles=triangles, radius=radius, spheres_until_full=True,
                     motion="descend", rest="joint", friction=0.05, seed=4)
print(f"{len(run.radii)} spheres")

# %% [markdown]
# ## The profile
#
# `z` is the distance from the wall in diameters of a sphere.

# %%
analysis = frostfill.analyse(run.centres, run.radii, run.vertices, run.triangles, only="porosity",
                             bins=100, samples=1 << 19)
rings = analysis.porosity_radial
z = (1 - (rings["from"] + rings["to"]) / 2) / (2 * radius)
found = rings["porosity"]
shares = rings["object_volume"] / rings["object_volume"].sum()

# %% [markdown]
# ## The correlations
#
# De Klerk's has the porosity far from the wall as its parameter, here that of this bed. Mueller's has none, but
# is of beds that are denser there, and for ratios up to 13.

# %%
is_far = z > min(3, 0.3 * RATIO)
bulk = np.average(found[is_far], weights=shares[is_far])
de_klerk = np.where(z <= 0.637, 2.14 * z**2 - 2.53 * z + 1,
                    bulk + 0.29 * np.exp(-0.6 * z) * np.cos(2.3 * np.pi * (z - 0.16)) + 0.15 * np.exp(-0.9 * z))


def bessel(x):
    """J0, by its integral."""
    angles = (np.arange(200) + 0.5) * np.pi / 200
    return np.cos(np.multiply.outer(x, np.sin(angles))).mean(axis=-1)


far = 0.379 + 0.078 / (RATIO - 1.8)
mueller = far + (1 - far) * bessel((8.243 - 12.98 / (RATIO + 3.156)) * z) * np.exp(-(0.304 - 0.724 / RATIO) * z)

# %% [markdown]
# ## The whole cross section
#
# Three diameters from both ends, as they are walls too. The correlation is for ratios of 1.5 to 50, and the beds
# that it was fitted to differ from it by 1.5 % in the mean.

# %%
slabs = analysis.porosity_height
in_the_middle = (slabs["from"] > 6 * radius) & (slabs["to"] < height - 6 * radius)
middle = slabs["porosity"][in_the_middle].mean()
benyahia = 0.390 + 1.740 / (RATIO + 1.140) ** 2
print(f"porosity of the middle {middle:.3f}; Benyahia and O'Neill {benyahia:.3f}")

# %% [markdown]
# ## How far apart they are
#
# The mean difference, each ring counted by its area, and the first minimum, which is half a diameter from the wall.


# %%
def apart(other):
    return np.average(np.abs(found - other), weights=shares)


near = z < 1
first = z[near][found[near].argmin()]
print(f"porosity {np.average(found, weights=shares):.3f}, far from the wall {bulk:.3f} (Mueller: {far:.3f})")
print(f"first minimum {found[near].min():.3f} at {first:.2f} diameters; de Klerk {de_klerk.min():.3f}, "
      f"Mueller {mueller.min():.3f}")
print(f"mean difference: de Klerk {apart(de_klerk):.3f}, Mueller {apart(mueller):.3f}")

# %%
np.savetxt(folder / "tube.txt", np.stack([z, found, de_klerk, mueller], 1), header="z found de_klerk mueller")
if importlib.util.find_spec("matplotlib"):
    import matplotlib
    matplotlib.use("Agg")
    import matplotlib.pyplot as plt

    figure, plot = plt.subplots()
    for values, style, name in ((found, "-", "Frostfill"), (de_klerk, "--", "de Klerk 2003"), (mueller, ":", "Mueller 1992")):
        plot.plot(z, values, style, label=name)
    plot.set(xlabel="distance from the wall [diameters]", ylabel="porosity", ylim=(0, 1))
    plot.legend()
    figure.savefig(folder / "tube.png")
