# SPDX-License-Identifier: MIT
# %% [markdown]
# # A fixed bed for OpenFOAM
#
# The geometry of flow through a packing takes one command:
# `frostfill fill cube --radius 0.3 --count 12 --motion skip --export openfoam`. This is the same from Python, followed by
# the mesher and a few iterations of the solver. As a program, it writes into the folder that is given:
# `scripts/python examples/openfoam_bed.py bed`. It needs Debian's package openfoam.

# %%
import os
import re
import subprocess
import sys
from pathlib import Path

import frostfill
import numpy as np

folder = Path(sys.argv[1] if len(sys.argv) > 1 and not sys.argv[1].startswith("-") else "bed")

# %% [markdown]
# ## Fill, and write the case
#
# Spheres are shrunk by a hundredth, so that there is a space between those that touch.

# %%
run = frostfill.fill("cube", radius=0.3, count=12, motion="skip", seed=2)
run.export(folder, "openfoam", overwrite=True)
case = folder / "openfoam"
print(f"{len(run.centres)} spheres")

# %% [markdown]
# ## Mesh
#
# `blockMesh` makes the cells around the container, `snappyHexMesh` fits them to its walls and spheres.


# %%
def openfoam(*command):
    environment = {"WM_PROJECT_DIR": "/usr/share/openfoam", **os.environ}
    done = subprocess.run(command, cwd=case, env=environment, capture_output=True, text=True, check=True)
    return done.stdout


openfoam("blockMesh")
openfoam("snappyHexMesh", "-overwrite")
checked = openfoam("checkMesh")
cells = int(re.search(r"cells: +(\d+)", checked)[1])
volume = float(re.search(r"Total volume = ([\d.e+-]+?)\.? ", checked)[1])
print(f"{cells} cells; {'Mesh OK' if 'Mesh OK' in checked else 'checkMesh objects'}")

# %% [markdown]
# ## Porosity
#
# The volume of the cells beside that of the container without the true spheres.

# %%
exact = 1 - len(run.centres) * 4 / 3 * np.pi * 0.3**3 / 8
porosity = volume / 8
print(f"porosity of the cells {porosity:.4f}, of true spheres {exact:.4f}")

# %% [markdown]
# ## Flow
#
# The case is ready for `simpleFoam`. A few iterations show that it starts; for a result, let it converge.

# %%
control = case / "system" / "controlDict"
control.write_text(re.sub(r"endTime \d+;", "endTime 5;", control.read_text()))
flow = openfoam("simpleFoam")
residuals = [float(value) for value in re.findall(r"Solving for Ux, Initial residual = ([\d.e+-]+)", flow)]
print(f"initial residual of the velocity: {residuals[0]:.2g}, after {len(residuals)} iterations {residuals[-1]:.2g}")
