# SPDX-License-Identifier: MIT
"""ParaView: pvpython with_paraview.py FOLDER vtp"""
import sys

from paraview.simple import PVDReader, UpdatePipeline
from paraview import servermanager
from vtkmodules.util.numpy_support import vtk_to_numpy

from oracle import Oracle



def leaves(data):
    """The data sets in nested blocks."""
    if not hasattr(data, "GetNumberOfBlocks"):
        return [data]
    return [leaf for i in range(data.GetNumberOfBlocks()) for leaf in leaves(data.GetBlock(i))]


run = Oracle(sys.argv[1])
reader = PVDReader(FileName=str(run.file("run.pvd")))
run.same("times", list(reader.TimestepValues), [frame["time"] for frame in run.frames])
for k, frame in enumerate(run.frames):
    UpdatePipeline(time=frame["time"], proxy=reader)
    data = servermanager.Fetch(reader)
    balls, mesh = leaves(data)
    arrays = {name: vtk_to_numpy(balls.GetPointData().GetArray(name)) for name in ("radius", "state")}
    run.frame("ParaView", k, {"centres": vtk_to_numpy(balls.GetPoints().GetData()),
                              "radii": arrays["radius"], "states": arrays["state"]})
    run.same("polygons", vtk_to_numpy(mesh.GetCellData().GetArray("state")), frame["polygons"])
run.finish()
