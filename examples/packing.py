# SPDX-License-Identifier: MIT
# %% [markdown]
# # A packing, measured
#
# Fill a cube with equal spheres and look at the packing with NumPy: how dense it is at a distance from
# a wall, and how far neighbours are apart. Then see what accuracy costs on a mesh of your own.
#
# Each `# %%` begins a cell for editors that know notebooks. As a program, it writes its pictures into
# the folder that is given: `scripts/python examples/packing.py pictures`.

# %%
import shutil
import sys
import time
from pathlib import Path

import frostfill
import matplotlib.pyplot as plt
import numpy as np

folder = Path(sys.argv[1] if len(sys.argv) > 1 and not sys.argv[1].startswith("-") else "pictures")
folder.mkdir(parents=True, exist_ok=True)
BLUE, ORANGE, GREY = "#0072B2", "#E69F00", "#888888"
plt.rcParams.update({"figure.figsize": (6, 3.6), "figure.dpi": 120, "figure.constrained_layout.use": True,
                     "axes.spines.top": False, "axes.spines.right": False})

# %% [markdown]
# ## Fill
#
# A radius alone fills the cube until no sphere fits. The motion "descend" places each sphere where it
# rolls to, without dynamics: it is the fastest.

# %%
run = frostfill.fill("cube", radius=0.0469, motion="descend", seed=1)
centres, radius = run.centres, run.radii[0]
low, high = run.vertices.min(axis=0), run.vertices.max(axis=0)
print(f"{len(centres)} spheres, filled {run.summary['outcome']}")
picture = run.render(size=(560, 420), style="studio", color_by="height", legend=False)
picture.save(folder / "python-packing.png")
picture

# %% [markdown]
# ## How dense it is at a distance from a wall
#
# A plane cuts a sphere in a circle of area pi (r^2 - d^2), with d the distance of the centre from the
# plane. The sum over all spheres, over the area of the plane, is the packing fraction there: exact,
# without a grid. The four upright walls are alike, so take their mean, up to the highest centre.

# %%
UP = 1  # the axis y
top = centres[:, UP].max()


def fraction_in_planes(axis, positions):
    """Packing fraction in planes across an axis."""
    other = 3 - axis - UP
    area = (high[other] - low[other]) * (top - low[UP])
    apart = centres[:, axis] - positions[:, None]
    return np.pi * np.clip(radius**2 - apart**2, 0, None).sum(axis=1) / area


distances = np.linspace(0, 12 * radius, 481)
fraction = np.mean(
    [fraction_in_planes(axis, start) for axis in (0, 2)
     for start in (low[axis] + distances, high[axis] - distances)], axis=0)
inside = fraction[distances > 6 * radius].mean()

figure, axes = plt.subplots()
axes.plot(distances / radius, fraction, color=BLUE)
axes.axhline(inside, color=GREY, linewidth=1, linestyle="--")
axes.annotate(f"{inside:.3f} inside", (12, inside), (0, 4), textcoords="offset points", ha="right",
              color=GREY)
axes.set(xlabel="distance from the wall [radius]", ylabel="packing fraction", xlim=(0, 12), ylim=(0, None),
         title="Spheres lie in layers along a wall")
figure.savefig(folder / "python-walls.png")

# %% [markdown]
# ## How far neighbours are apart
#
# The pair correlation g: how many centres there are at a distance from a centre, over how many there
# would be if they lay anywhere. Only spheres that are further from the walls than the largest distance
# count as the middle one, so that no shell is cut off.

# %%
FURTHEST = 8 * radius
deep = np.all((centres > low + FURTHEST) & (centres < np.minimum(high, top) - FURTHEST), axis=1)
edges = (np.arange(321) + 0.5) * FURTHEST / 320  # contact, at 80, is in the middle of a bin
counts = np.zeros(len(edges) - 1)
for part in np.array_split(centres[deep], max(1, deep.sum() // 100)):
    apart = np.linalg.norm(part[:, None] - centres[None], axis=2)
    counts += np.histogram(apart[apart > 0], edges)[0]
shells = 4 / 3 * np.pi * np.diff(edges**3)
box = np.prod(np.minimum(high, top) - low - 2 * FURTHEST)
correlation = counts / deep.sum() / shells / (deep.sum() / box)
middles = (edges[1:] + edges[:-1]) / 2

figure, axes = plt.subplots()
axes.plot(middles / radius / 2, correlation, color=BLUE)
axes.axhline(1, color=GREY, linewidth=1, linestyle="--")
axes.annotate(f"contact: {correlation.max():.0f}", (1, 3), (6, -10), textcoords="offset points", color=BLUE)
axes.set(xlabel="distance of two centres [diameter]", ylabel="pair correlation g", xlim=(0, 4), ylim=(0, 3),
         title="Neighbours touch, the next ones lie in gaps")
figure.savefig(folder / "python-pairs.png")

# %% [markdown]
# ## What accuracy costs on a mesh of your own
#
# A full object tells its volume: the number of spheres, times the volume of one, over the packing
# fraction, and a layer at the wall. Smaller spheres tell it better and take longer. The volume of the
# mesh itself is known exactly, so the error is known too. Put the name of your own file here.

# %%
MESH = "human"
known = frostfill.inspect(MESH).filled
depth = known.volume / known.area
seconds, errors, expected, numbers = [], [], [], []
for share in (0.3, 0.24, 0.19, 0.15, 0.12, 0.1):
    begin = time.process_time()
    simulation = frostfill.Simulation(MESH, radius=share * depth, motion="descend", threads=1)
    simulation.advance()
    seconds.append(time.process_time() - begin)
    quality = simulation.quality()
    errors.append(abs(quality.volume_estimate / known.volume - 1))
    expected.append(quality.volume_estimate_error / known.volume)
    numbers.append(simulation.sphere_count)

figure, axes = plt.subplots()
axes.loglog(seconds, expected, color=GREY, marker="_", linestyle="--", label="uncertainty it states")
axes.loglog(seconds, errors, color=BLUE, marker="o", label="error")
for where, number in zip(zip(seconds, expected), numbers):
    axes.annotate(f"{number}", where, (0, 5), textcoords="offset points", ha="center", fontsize=8, color=GREY)
axes.set(xlabel="run time [s of one processor]", ylabel="relative error of the volume",
         title=f"The volume of the {MESH}, told by its spheres")
axes.legend(frameon=False)
figure.savefig(folder / "python-error.png")

# %% [markdown]
# ## A turntable
#
# The last state from all sides. The pictures are numbered in a folder; with ffmpeg they become a video.

# %%
video = folder / "turntable.mp4" if shutil.which("ffmpeg") else None
drawn = run.draw(folder / "turntable", video=video, frames="last", turntable=4, frames_fps=12, size=(480, 360),
                 color_by="height", overwrite=True)
print(f"{drawn} pictures" + (f" and {video}" if video else "; ffmpeg would make a video of them"))
