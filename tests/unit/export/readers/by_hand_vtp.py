# SPDX-License-Identifier: MIT
"""Reads .vtp files and their .pvd by the definition of VTK's XML files, with the standard library."""
import array
import struct
import xml.etree.ElementTree as ElementTree

from oracle import COLUMNS, KINDS

TYPES = {"Float64": "d", "Float32": "f", "UInt32": "I", "UInt8": "B", "Int64": "q", "UInt16": "H", "Int32": "i"}


def poly_data(oracle, path):
    """Arrays of a .vtp file by section and name, and how many points, vertex cells and polygons it has."""
    head, _, body = path.read_bytes().partition(b'<AppendedData encoding="raw">\n_')
    tree = ElementTree.fromstring(head + b"</VTKFile>")
    oracle.equal("file", tree.attrib, {"type": "PolyData", "version": "1.0", "byte_order": "LittleEndian",
                                       "header_type": "UInt64"})
    time, = tree.iter("FieldData")
    oracle.equal("time", {key: time[0].get(key) for key in ("Name", "NumberOfTuples", "format")},
                 {"Name": "TimeValue", "NumberOfTuples": "1", "format": "ascii"})
    piece, = tree.iter("Piece")
    counts = {key: int(value) for key, value in piece.attrib.items()}
    oracle.same("lines and strips", [counts["NumberOfLines"], counts["NumberOfStrips"]], [0, 0])
    arrays, end = {}, 0
    for section in piece:
        for node in section:
            kind, wide = TYPES[node.get("type")], int(node.get("NumberOfComponents"))
            at = int(node.get("offset"))
            oracle.equal("how and where", (node.get("format"), at), ("appended", end))
            size, = struct.unpack_from("<Q", body, at)
            values = array.array(kind, body[at + 8:at + 8 + size])
            end = at + 8 + size
            arrays[section.tag, node.get("Name")] = (kind, wide, values)
        active = section.get("Scalars")
        oracle.equal("active array", active is None or (section.tag, active) in arrays, True)
    oracle.equal("end", body[end:], b"\n</AppendedData>\n</VTKFile>\n")
    return arrays, float(time[0].text), counts


def check(oracle, arrays, key, kind, wide, count):
    """Type, width and length of an array; returns its values."""
    found_kind, found_wide, values = arrays[key]
    oracle.equal(f"type and width of {key}", (found_kind, found_wide, len(values)), (kind, wide, wide * count))
    return values


def read_spheres(oracle, k, name):
    frame = oracle.frames[k]
    arrays, time, counts = poly_data(oracle, oracle.file(name))
    count = len(frame["ids"])
    oracle.same("time", time, frame["time"])
    oracle.same("counts", [counts["NumberOfPoints"], counts["NumberOfVerts"], counts["NumberOfPolys"]],
                [count, count, 0])
    columns = {"centres": check(oracle, arrays, ("Points", "Points"), "d", 3, count)}
    names = [column for section, column in arrays if section == "PointData"]
    oracle.equal("columns that are missing", [column for column in COLUMNS if column not in names], [])
    for column in names:
        kind = KINDS.get(column, arrays["PointData", column][0])
        columns[COLUMNS.get(column, column)] = check(oracle, arrays, ("PointData", column), kind, 1, count)
    oracle.frame("vtp", k, columns)
    oracle.same("vertex cells", check(oracle, arrays, ("Verts", "connectivity"), "q", 1, count), frame["ids"])
    oracle.same("ends of cells", check(oracle, arrays, ("Verts", "offsets"), "q", 1, count),
                [i + 1 for i in frame["ids"]])


def read_mesh(oracle, frame, name, is_new):
    arrays, time, counts = poly_data(oracle, oracle.file(name))
    triangles = len(oracle.triangles)
    oracle.same("counts", [counts["NumberOfPoints"], counts["NumberOfVerts"], counts["NumberOfPolys"]],
                [len(oracle.vertices), 0, triangles])
    if is_new:
        oracle.same("time of the mesh", time, frame["time"])
    oracle.same("vertices", check(oracle, arrays, ("Points", "Points"), "d", 3, len(oracle.vertices)),
                frame["vertices"], 1e-12)
    oracle.same("polygons", check(oracle, arrays, ("CellData", "state"), "B", 1, triangles), frame["polygons"])
    oracle.same("corners", check(oracle, arrays, ("Polys", "connectivity"), "q", 1, 3 * triangles),
                oracle.triangles)
    oracle.same("ends of triangles", check(oracle, arrays, ("Polys", "offsets"), "q", 1, triangles),
                range(3, 3 * triangles + 1, 3))


def read_vtp(oracle):
    tree = ElementTree.parse(oracle.file("run.pvd")).getroot()
    oracle.equal("collection", tree.attrib, {"type": "Collection", "version": "0.1",
                                             "byte_order": "LittleEndian"})
    entries = list(tree.iter("DataSet"))
    oracle.same("entries", len(entries), 2 * len(oracle.frames))
    oracle.files("vtp", {entry.get("file") for entry in entries})
    earlier = ""
    for k, frame in enumerate(oracle.frames):
        balls, mesh = entries[2 * k:2 * k + 2]
        oracle.equal("parts", (balls.get("part"), mesh.get("part")), ("0", "1"))
        oracle.same("times in the .pvd", [float(balls.get("timestep")), float(mesh.get("timestep"))],
                    [frame["time"]] * 2)
        read_spheres(oracle, k, balls.get("file"))
        read_mesh(oracle, frame, mesh.get("file"), mesh.get("file") != earlier)
        earlier = mesh.get("file")
