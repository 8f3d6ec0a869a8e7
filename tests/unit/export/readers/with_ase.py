# SPDX-License-Identifier: MIT
"""ASE: with_ase.py FOLDER xyz"""
import sys

import ase.io

from oracle import Oracle

run = Oracle(sys.argv[1])
frames = ase.io.read(str(run.file("spheres.xyz")), index=":", format="extxyz")
run.same("frames", len(frames), len(run.frames))
for k, atoms in enumerate(frames):
    run.frame("ASE", k, {"centres": atoms.positions, "radii": atoms.arrays["radius"],
                         "states": atoms.arrays["state"], "groups": atoms.arrays["group"],
                         "sets": atoms.arrays["set"]})
    run.same("time", atoms.info["Time"], run.frames[k]["time"])
run.finish()
