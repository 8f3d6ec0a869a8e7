# SPDX-License-Identifier: MIT
# %% [markdown]
# # A LIGGGHTS run that starts at rest
#
# Codes for discrete elements pour their particles, and most of the time goes into waiting until these lie
# still. Here the container is filled first, and the simulation begins with a packing that stays where it is.
#
# As a program, it writes its files into the folder that is given:
# `scripts/python examples/liggghts_at_rest.py there`. It needs Debian's package liggghts.

# %%
import subprocess
import sys
from pathlib import Path

import frostfill
import numpy as np

folder = Path(sys.argv[1] if len(sys.argv) > 1 and not sys.argv[1].startswith("-") else "there")

# %% [markdown]
# ## Fill
#
# All spheres are to rest together under the friction that LIGGGHTS will use: each by itself is not enough.

# %%
FRICTION = 0.3
run = frostfill.fill("cube", count=300, spheres_until_full=True, rest="joint", friction=FRICTION, seed=1)
print(f"{len(run.centres)} spheres of radius {run.radii[0]:.4f}, filled {run.summary['outcome']}")

# %% [markdown]
# ## Go on in LIGGGHTS
#
# The export is an input script that runs as it is, the spheres, and the walls as STL. The script takes
# friction, restitution and gravity from the run, and runs for ten times sqrt(r/g).

# %%
files = run.export(folder, "liggghts", overwrite=True)
print(*(file.name for file in files))
subprocess.run(["liggghts", "-in", "liggghts.in", "-log", "none"], cwd=folder, check=True,
               stdout=subprocess.DEVNULL)

# %% [markdown]
# ## How far the spheres have moved
#
# The last state of the dump, judged as any packing: how far each sphere is from where it was put.

# %%
after = frostfill.read_packing(folder / "liggghts.dump")
moved = np.linalg.norm(after.centres - run.centres, axis=1) / run.radii
near = (moved <= 0.02).mean()
quality = frostfill.check(after.centres, after.radii, run.vertices, run.triangles)
print(f"{near:.1%} of the spheres are within 0.02 r, the farthest has moved {moved.max():.2f} r; "
      f"they sink into each other by {quality.max_overlap:.1e} r")
