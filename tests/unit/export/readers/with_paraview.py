# SPDX-License-Identifier: MIT
"""ParaView: pvpython with_paraview.py FOLDER vtp"""
import sys

from paraview.simple import PVDReader, ExtractBlock, UpdatePipeline  # noqa: F401
from paraview import servermanager
from vtkmodules.util.numpy_support import vtk_to_numpy

from oracle import Oracle

run = Oracle(sys.argv[1])
reader = PVDReader(FileName=str(run.file("run.pvd")))
run.same("times", list(reader.TimestepValues), [frame["time"] for frame in run.frames])
for k, frame in enumerate(run.frames):
    UpdatePipeline(time=frame["time"], proxy=reader)
    data = servermanager.Fetch(reader)
    balls, mesh = data.GetBlock(0), data.GetBlock(1)
    arrays = {name: vtk_to_numpy(balls.GetPointData().GetArray(name)) for name in ("radius", "state")}
    run.frame("ParaView", k, {"centres": vtk_to_numpy(balls.GetPoints().GetData()),
                              "radii": arrays["radius"], "states": arrays["state"]})
    run.same("polygons", vtk_to_numpy(mesh.GetCellData().GetArray("state")), frame["polygons"])
run.finish()
