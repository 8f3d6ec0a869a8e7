# SPDX-License-Identifier: MIT
"""meshio: with_meshio.py FOLDER ply"""
import sys

import meshio

from oracle import Oracle

run = Oracle(sys.argv[1])
for k, frame in enumerate(run.frames):
    data = meshio.read(run.file(f"spheres_{frame['number']:05}.ply"))
    arrays = data.point_data
    run.frame("meshio", k, {"centres": data.points, "radii": arrays["radius"], "states": arrays["state"],
                            "groups": arrays["group"], "sets": arrays["set"], "speeds": arrays["speed"],
                            "ids": arrays["id"], "contacts": arrays["contacts"]})
run.finish()
