# SPDX-License-Identifier: MIT
"""Compares voxels of shrunk spheres in a cube from -1 to 1 with their closed form, and VTK's with NumPy's."""
import csv
import glob
import json
import struct

summary = json.load(open("volume.json"))
nx, ny, nz = summary["voxels"]


def array(name, letter):
    data = open(name, "rb").read()
    assert data[:8] == b"\x93NUMPY\x01\x00", name
    head = data[10:10 + struct.unpack("<H", data[8:10])[0]].decode()
    assert eval(head) == {"descr": "<" + letter + "4", "fortran_order": False, "shape": (nz, ny, nx)}, head
    return struct.unpack("<%d%s" % (nx * ny * nz, letter), data[10 + len(head):])


distance, label = array("distance.npy", "f"), array("label.npy", "i")
spheres = [[float(row[k]) for k in ("x", "y", "z", "radius")]
           for row in csv.DictReader(open(glob.glob("spheres_*.csv")[0]))]
assert len(spheres) == 20
place = [[summary["origin"][axis] + summary["spacing"] * k for k in range(count)]
         for axis, count in enumerate((nx, ny, nz))]
free = 0
for k in range(nx * ny * nz):
    p = (place[0][k % nx], place[1][k // nx % ny], place[2][k // nx // ny])
    gaps = [sum((a - b) ** 2 for a, b in zip(p, s)) ** 0.5 - 0.99 * s[3] for s in spheres]
    nearest = min(gaps)
    free += nearest >= 0
    exact = min([nearest] + [1 - abs(x) for x in p])
    assert abs(distance[k] - exact) < 1e-6, (p, distance[k], exact)
    assert label[k] == (gaps.index(nearest) + 1 if nearest < 0 else 0), (p, label[k])
assert abs(summary["porosity_of_voxels"] - free / (nx * ny * nz)) < 1e-12

try:
    from vtkmodules.vtkIOXML import vtkXMLImageDataReader
except ImportError:
    print("VTK is not installed")
else:
    reader = vtkXMLImageDataReader()
    reader.SetFileName("bed.vti")
    reader.Update()
    image = reader.GetOutput()
    assert image.GetDimensions() == (nx, ny, nz)
    assert max(abs(a - b) for a, b in zip(image.GetOrigin(), summary["origin"])) < 1e-12
    assert abs(image.GetSpacing()[2] - summary["spacing"]) < 1e-12
    for name, values in (("distance", distance), ("label", label)):
        read = image.GetPointData().GetArray(name)
        assert [read.GetValue(k) for k in range(read.GetNumberOfValues())] == list(values), name
    print("VTK reads the same")
