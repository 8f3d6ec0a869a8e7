# SPDX-License-Identifier: MIT
"""Reads what was exported with nothing but Python's standard library: by_hand.py FOLDER FORMAT"""
import array
import csv
import io
import json
import re
import struct
import sys
import xml.etree.ElementTree as ElementTree
import zipfile

from oracle import Oracle

COLUMNS = {"radius": "radii", "state": "states", "group": "groups", "set": "sets", "speed": "speeds",
           "id": "ids"}


def named(rows, names, first_id=0):
    """Columns of a table by the oracle's names."""
    columns = {COLUMNS[name]: [float(row[i]) for row in rows]
               for i, name in enumerate(names) if name in COLUMNS}
    x = names.index("x")
    columns["centres"] = [[float(value) for value in row[x:x + 3]] for row in rows]
    columns["ids"] = [i - first_id for i in columns["ids"]]
    return columns


def read_csv(oracle):
    for k, frame in enumerate(oracle.frames):
        rows = list(csv.reader(oracle.file(f"spheres_{frame['number']:05}.csv").open()))
        oracle.frame("csv", k, named(rows[1:], rows[0]))


def read_xyz(oracle):
    lines = oracle.file("spheres.xyz").read_text().splitlines()
    at = 0
    for k, frame in enumerate(oracle.frames):
        count = int(lines[at])
        names = re.search(r"Properties=(\S+)", lines[at + 1])[1].replace("pos:R:3", "x:R:1:y:R:1:z:R:1")
        oracle.same("time", float(re.search(r"Time=(\S+)", lines[at + 1])[1]), frame["time"])
        rows = [line.split() for line in lines[at + 2:at + 2 + count]]
        oracle.frame("xyz", k, named(rows, names.split(":")[::3]))
        at += 2 + count
    oracle.same("lines", at, len(lines))


def read_dump(oracle):
    lines = oracle.file("spheres.dump").read_text().splitlines()
    at = 0
    for k, frame in enumerate(oracle.frames):
        assert lines[at] == "ITEM: TIME" and lines[at + 2] == "ITEM: TIMESTEP", lines[at]
        oracle.same("time", float(lines[at + 1]), frame["time"])
        oracle.same("number", int(lines[at + 3]), frame["number"])
        count = int(lines[at + 5])
        names = lines[at + 10].split()[2:]
        rows = [line.split() for line in lines[at + 11:at + 11 + count]]
        columns = named(rows, names, first_id=1)
        oracle.frame("dump", k, columns)
        oracle.same("types", [float(row[1]) - 1 for row in rows], columns["states"])
        at += 11 + count
    oracle.same("lines", at, len(lines))


def read_data(oracle):
    lines = oracle.file("spheres.data").read_text().splitlines()
    last = oracle.frames[-1]
    rows = [list(map(float, line.split())) for line in lines[lines.index("Atoms # sphere") + 2:]]
    oracle.same("atoms", int(lines[2].split()[0]), len(last["radii"]))
    oracle.frame("data", -1, {"ids": [row[0] - 1 for row in rows],
                              "states": [row[1] - 1 for row in rows],
                              "radii": [row[2] / 2 for row in rows],
                              "centres": [row[4:7] for row in rows]})


def read_ply(oracle):
    kinds = {"double": "d", "float": "f", "uint": "I", "uchar": "B"}
    for k, frame in enumerate(oracle.frames):
        head, _, body = oracle.file(f"spheres_{frame['number']:05}.ply").read_bytes().partition(
            b"end_header\n")
        fields = re.findall(r"property (\w+) (\w+)", head.decode())
        rows = list(struct.iter_unpack("<" + "".join(kinds[kind] for kind, _ in fields), body))
        oracle.frame("ply", k, named(rows, [name for _, name in fields]))


def poly_data(path):
    """Arrays of a .vtp file by name, and its time."""
    head, _, body = path.read_bytes().partition(b'<AppendedData encoding="raw">\n_')
    tree = ElementTree.fromstring(head + b"</VTKFile>")
    kinds = {"Float64": "d", "Float32": "f", "UInt32": "I", "UInt8": "B", "Int64": "q"}
    arrays = {}
    for node in tree.iter("DataArray"):
        if node.get("format") == "appended":
            at = int(node.get("offset"))
            size, = struct.unpack_from("<Q", body, at)
            arrays[node.get("Name")] = array.array(kinds[node.get("type")], body[at + 8:at + 8 + size])
        else:
            time = float(node.text)
    piece = next(tree.iter("Piece"))
    return arrays, time, int(piece.get("NumberOfPoints"))


def read_vtp(oracle):
    entries = list(ElementTree.parse(oracle.file("run.pvd")).iter("DataSet"))
    for k, frame in enumerate(oracle.frames):
        balls, mesh = entries[2 * k:2 * k + 2]
        oracle.same("times in the .pvd", [float(balls.get("timestep")), float(mesh.get("timestep"))],
                    [frame["time"]] * 2)
        arrays, time, count = poly_data(oracle.file(balls.get("file")))
        oracle.same("time", time, frame["time"])
        oracle.same("points", count, len(frame["radii"]))
        oracle.frame("vtp", k, {"centres": arrays["Points"],
                                **{COLUMNS[name]: arrays[name] for name in COLUMNS}})
        oracle.same("vertex cells", arrays["connectivity"], frame["ids"])
        arrays, _, _ = poly_data(oracle.file(mesh.get("file")))
        oracle.same("polygons", arrays["state"], frame["polygons"])
        oracle.same("corners", arrays["connectivity"], oracle.triangles)


def read_npz(oracle):
    kinds = {"<f8": "d", "<f4": "f", "<u4": "I", "<i8": "q", "|u1": "B"}
    arrays, shapes = {}, {}
    with zipfile.ZipFile(oracle.file("run.npz")) as archive:
        assert archive.testzip() is None
        for name in archive.namelist():
            data = archive.read(name)
            size, = struct.unpack_from("<H", data, 8)
            head = eval(data[10:10 + size])  # a dictionary, by the definition of the format
            assert (10 + size) % 64 == 0
            arrays[name[:-4]] = array.array(kinds[head["descr"]], data[10 + size:])
            shapes[name[:-4]] = head["shape"]
    frames, spheres = shapes["states"]
    oracle.same("shape of centres", shapes["centres"], (len(oracle.frames), spheres, 3))
    for k, frame in enumerate(oracle.frames):
        count = len(frame["radii"])
        start = k * spheres
        oracle.frame("npz", k, {"centres": arrays["centres"][3 * start:3 * (start + count)],
                                "states": arrays["states"][start:start + count],
                                "speeds": arrays["speeds"][start:start + count]})
        rest = arrays["centres"][3 * (start + count):3 * (start + spheres)]
        oracle.same("not there yet", sum(x != x for x in rest), len(rest))
        triangles = len(oracle.triangles)
        oracle.same("polygons", arrays["polygons"][k * triangles:(k + 1) * triangles], frame["polygons"])
    last = oracle.frames[-1]
    for name in ("radii", "groups", "sets"):
        oracle.same(name, arrays[name], last[name])
    oracle.same("times", arrays["times"], [frame["time"] for frame in oracle.frames])
    oracle.same("frames", arrays["frames"], [frame["number"] for frame in oracle.frames])
    oracle.same("vertices", arrays["vertices"], oracle.vertices)
    oracle.same("triangles", arrays["triangles"], oracle.triangles)


class Glb:
    """A binary glTF file with its accessors."""

    def __init__(self, path):
        data = path.read_bytes()
        assert struct.unpack_from("<4sII", data) == (b"glTF", 2, len(data))
        size, = struct.unpack_from("<I", data, 12)
        self.json = json.loads(data[20:20 + size])
        self.buffer = data[28 + size:]

    def values(self, index):
        accessor = self.json["accessors"][index]
        view = self.json["bufferViews"][accessor["bufferView"]]
        wide = {"SCALAR": 1, "VEC3": 3, "VEC4": 4}[accessor["type"]]
        kind = {5126: "f", 5125: "I"}[accessor["componentType"]]
        at = view["byteOffset"] + accessor["byteOffset"]
        assert accessor["byteOffset"] + 4 * wide * accessor["count"] <= view["byteLength"]
        flat = struct.unpack_from(f"<{wide * accessor['count']}{kind}", self.buffer, at)
        return [flat[i:i + wide] for i in range(0, len(flat), wide)] if wide > 1 else list(flat)


def turned(q, p):
    """p turned by the quaternion x, y, z, w."""
    x, y, z, w = q
    uv = (y * p[2] - z * p[1], z * p[0] - x * p[2], x * p[1] - y * p[0])
    uuv = (y * uv[2] - z * uv[1], z * uv[0] - x * uv[2], x * uv[1] - y * uv[0])
    return [p[i] + 2 * (w * uv[i] + uuv[i]) for i in range(3)]


def read_glb(oracle):
    glb = Glb(oracle.file("run.glb"))
    nodes = glb.json["nodes"]
    origin = middle(oracle.vertices)
    start = oracle.frames[0]["time"]
    channels = {}
    for channel in glb.json["animations"][0]["channels"]:
        sampler = glb.json["animations"][0]["samplers"][channel["sampler"]]
        key = channel["target"]["node"], channel["target"]["path"]
        channels[key] = (glb.values(sampler["input"]), glb.values(sampler["output"]),
                         sampler["interpolation"])

    def value(node, path, time):
        if (node, path) not in channels:
            return nodes[node][path]
        times, values, interpolation = channels[node, path]
        index = max((i for i, t in enumerate(times) if t <= time), default=0)
        if interpolation == "LINEAR" and index + 1 < len(times) and time > times[index]:
            share = (time - times[index]) / (times[index + 1] - times[index])
            return [a + share * (b - a) for a, b in zip(values[index], values[index + 1])]
        return list(values[index])

    root = next(i for i, node in enumerate(nodes) if node["name"] == "object")
    for k, frame in enumerate(oracle.frames):
        time = struct.unpack("<f", struct.pack("<f", frame["time"] - start))[0]
        offset, turn = value(root, "translation", time), value(root, "rotation", time)
        count = len(frame["radii"])
        places = [[a + b + c for a, b, c in zip(turned(turn, value(i, "translation", time)), offset, origin)]
                  for i in range(count)]
        oracle.same(f"glb, frame {k}, centres", places, frame["centres"], 3e-6)
        sizes = [value(i, "scale", time)[0] for i in range(len(oracle.frames[-1]["radii"]))]
        wanted = frame["radii"] + [0.0] * (len(sizes) - count)
        oracle.same(f"glb, frame {k}, radii", sizes, wanted, 1e-7)
    meshes = [nodes[i]["mesh"] for i in range(len(oracle.frames[-1]["radii"]))]
    oracle.same("states", meshes, oracle.frames[-1]["states"])


def read_instanced(oracle):
    glb = Glb(oracle.file("packing.glb"))
    assert glb.json["extensionsRequired"] == ["EXT_mesh_gpu_instancing"]
    last = oracle.frames[-1]
    origin = middle(oracle.vertices)
    root = next(node for node in glb.json["nodes"] if node["name"] == "object")
    for node in glb.json["nodes"]:
        if "extensions" not in node:
            continue
        fields = node["extensions"]["EXT_mesh_gpu_instancing"]["attributes"]
        ids = [i for i in last["ids"] if last["states"][i] == node["mesh"]]
        places = [[a + b + c for a, b, c in zip(turned(root["rotation"], p), root["translation"], origin)]
                  for p in glb.values(fields["TRANSLATION"])]
        oracle.same("places", places, [last["centres"][i] for i in ids], 3e-6)
        oracle.same("sizes", glb.values(fields["SCALE"]), [[last["radii"][i]] * 3 for i in ids], 1e-7)
        oracle.compared += len(ids)


def middle(vertices):
    return [(min(v[i] for v in vertices) + max(v[i] for v in vertices)) / 2 for i in range(3)]


READERS = {"csv": read_csv, "xyz": read_xyz, "lammps-dump": read_dump, "lammps-data": read_data,
           "ply": read_ply, "vtp": read_vtp, "npz": read_npz, "glb": read_glb,
           "glb-instanced": read_instanced}

if __name__ == "__main__":
    run = Oracle(sys.argv[1])
    READERS[sys.argv[2]](run)
    run.finish()
