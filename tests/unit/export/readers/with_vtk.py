# SPDX-License-Identifier: MIT
"""VTK's own reader: with_vtk.py FOLDER vtp"""
import sys

from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOXML import vtkXMLPolyDataReader

from oracle import Oracle

run = Oracle(sys.argv[1])
for k, frame in enumerate(run.frames):
    reader = vtkXMLPolyDataReader()
    reader.SetFileName(str(run.file(f"spheres_{frame['number']:05}.vtp")))
    reader.Update()
    data = reader.GetOutput()
    arrays = {name: vtk_to_numpy(data.GetPointData().GetArray(name))
              for name in ("radius", "state", "group", "set", "speed", "id", "contacts")}
    run.same("cells", data.GetNumberOfVerts(), len(frame["radii"]))
    run.frame("VTK", k, {"centres": vtk_to_numpy(data.GetPoints().GetData()), "radii": arrays["radius"],
                         "states": arrays["state"], "groups": arrays["group"], "sets": arrays["set"],
                         "speeds": arrays["speed"], "ids": arrays["id"], "contacts": arrays["contacts"]})
    run.same("time", vtk_to_numpy(data.GetFieldData().GetArray("TimeValue")), [frame["time"]])
run.finish()
