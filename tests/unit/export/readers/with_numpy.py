# SPDX-License-Identifier: MIT
"""NumPy: with_numpy.py FOLDER npz"""
import sys

import numpy

from oracle import Oracle

run = Oracle(sys.argv[1])
arrays = numpy.load(run.file("run.npz"))
for k, frame in enumerate(run.frames):
    count = len(frame["radii"])
    run.frame("NumPy", k, {"centres": arrays["centres"][k, :count], "states": arrays["states"][k, :count],
                           "radii": arrays["radii"][:count], "polygons": arrays["polygons"][k]})
run.same("triangles", arrays["triangles"], run.triangles)
run.finish()
