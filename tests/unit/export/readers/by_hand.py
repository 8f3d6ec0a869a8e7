# SPDX-License-Identifier: MIT
"""Reads what was exported with nothing but Python's standard library: by_hand.py FOLDER FORMAT

The readers follow the definitions of the formats, and ask for all that these ask for: counts, versions,
types, lengths. Columns are read by the names that the file gives them."""
import array
import ast
import csv
import re
import struct
import sys
import zipfile

from by_hand_gltf import read_glb, read_instanced
from by_hand_vtp import read_vtp
from oracle import COLUMNS, KINDS, Oracle

PLACE = ["x", "y", "z"]


def named(rows, names, first_id=0):
    """Columns of a table by the oracle's names."""
    assert all(len(row) == len(names) for row in rows), f"a row has not {len(names)} values"
    assert len(set(names)) == len(names), names
    columns = {COLUMNS.get(name, name): [float(row[i]) for row in rows]
               for i, name in enumerate(names) if name not in PLACE}
    x = names.index("x")
    assert names[x:x + 3] == PLACE, names
    columns["centres"] = [[float(value) for value in row[x:x + 3]] for row in rows]
    columns["ids"] = [i - first_id for i in columns["ids"]]
    return columns


def required(oracle, names, wanted):
    oracle.equal("columns that are missing", [name for name in wanted if name not in names], [])


def whole(oracle, names, rows):
    """Numbers that count are written without a fraction."""
    for i, name in enumerate(names):
        if KINDS.get(name) in ("I", "B"):
            oracle.equal(name, [row[i] for row in rows if not row[i].isdigit()], [])


def read_csv(oracle):
    oracle.files("csv", [f"spheres_{frame['number']:05}.csv" for frame in oracle.frames])
    for k, frame in enumerate(oracle.frames):
        rows = list(csv.reader(oracle.file(f"spheres_{frame['number']:05}.csv").open()))
        oracle.equal("first column", rows[0][0], "id")
        required(oracle, rows[0], KINDS)
        whole(oracle, rows[0], rows[1:])
        oracle.frame("csv", k, named(rows[1:], rows[0]))


def read_xyz(oracle):
    lines = oracle.file("spheres.xyz").read_text().splitlines()
    at = 0
    for k, frame in enumerate(oracle.frames):
        count = int(lines[at])
        facts = {key: quoted or word for key, quoted, word in
                 re.findall(r'(\w+)=(?:"([^"]*)"|(\S+))', lines[at + 1])}
        oracle.same("time", float(facts["Time"]), frame["time"])
        oracle.same("number", int(facts["frame"]), frame["number"])
        oracle.same("step", int(facts["step"]), frame["step"])
        low, high = frame["box"]
        x, y, z = (b - a for a, b in zip(low, high))
        lattice = [float(word) for word in facts["Lattice"].split()]
        oracle.same("lattice", lattice, [x, 0, 0, 0, y, 0, 0, 0, z], 1e-12)
        oracle.same("origin", [float(word) for word in facts["Origin"].split()], low, 1e-12)
        oracle.equal("periodic", facts["pbc"], "F F F")
        fields = facts["Properties"].split(":")
        names, letters, widths = fields[::3], fields[1::3], list(map(int, fields[2::3]))
        oracle.equal("first fields", (names[:2], letters[:2], widths), (["species", "pos"], ["S", "R"],
                     [1, 3] + [1] * (len(names) - 2)))
        required(oracle, names, ("radius", "id", "state", "group", "set", "speed"))
        for name, letter in zip(names, letters):
            if name in KINDS:
                oracle.equal(f"type of {name}", letter, "R" if KINDS[name] in "df" else "I")
        rows = [line.split(" ") for line in lines[at + 2:at + 2 + count]]
        oracle.equal("species", [row[0] for row in rows if row[0] != "X"], [])
        columns = PLACE + names[2:]
        whole(oracle, columns, [row[1:] for row in rows])
        oracle.frame("xyz", k, named([row[1:] for row in rows], columns))
        at += 2 + count
    oracle.same("lines", at, len(lines))


def bounds(lines):
    """Lower and upper corner from a line an axis."""
    return [list(column) for column in zip(*(map(float, line.split()[:2]) for line in lines))]


def read_dump(oracle):
    lines = oracle.file("spheres.dump").read_text().splitlines()
    at = 0
    for k, frame in enumerate(oracle.frames):
        oracle.equal("items", lines[at:at + 6:2] + lines[at + 6:at + 7],
                     ["ITEM: TIME", "ITEM: TIMESTEP", "ITEM: NUMBER OF ATOMS", "ITEM: BOX BOUNDS ff ff ff"])
        oracle.same("time", float(lines[at + 1]), frame["time"])
        oracle.same("number", int(lines[at + 3]), frame["number"])
        count = int(lines[at + 5])
        oracle.same("box", bounds(lines[at + 7:at + 10]), frame["box"], 1e-12)
        names = lines[at + 10].split()
        oracle.equal("columns", names[:4], ["ITEM:", "ATOMS", "id", "type"])
        names = names[2:]
        required(oracle, names, KINDS)
        rows = [line.split(" ") for line in lines[at + 11:at + 11 + count]]
        whole(oracle, names, rows)
        columns = named(rows, names, first_id=1)
        oracle.same("types", [i - 1 for i in columns.pop("type")], columns["states"])
        oracle.frame("dump", k, columns)
        at += 11 + count
    oracle.same("lines", at, len(lines))


def npy_arrays(oracle, path):
    """Arrays of an .npz file and their shapes, by the definition of .npy 1.0."""
    kinds = {"<f8": "d", "<f4": "f", "<u4": "I", "<i8": "q", "|u1": "B", "<u2": "H", "<i4": "i"}
    arrays, shapes = {}, {}
    with zipfile.ZipFile(path) as archive:
        assert archive.testzip() is None
        for entry in archive.infolist():
            oracle.equal("file in the archive", (entry.filename[-4:], entry.compress_type), (".npy", 0))
            data = archive.read(entry)
            magic, size = struct.unpack_from("<8sH", data)
            oracle.equal("magic", magic, b"\x93NUMPY\x01\x00")
            oracle.equal("alignment and end of the head", ((10 + size) % 64, data[9 + size:10 + size]), (0, b"\n"))
            head = ast.literal_eval(data[10:10 + size].decode())
            oracle.equal("keys of the head", sorted(head), ["descr", "fortran_order", "shape"])
            oracle.equal("order", head["fortran_order"], False)
            name, kind, count = entry.filename[:-4], kinds[head["descr"]], 1
            for extent in head["shape"]:
                count *= extent
            oracle.same(f"bytes of {name}", len(data) - 10 - size, count * struct.calcsize("<" + kind))
            arrays[name] = array.array(kind, data[10 + size:])
            shapes[name] = head["shape"]
    return arrays, shapes


def read_npz(oracle):
    arrays, shapes = npy_arrays(oracle, oracle.file("run.npz"))
    spheres, frames, last = len(oracle.frames[-1]["ids"]), len(oracle.frames), oracle.frames[-1]
    triangles = len(oracle.triangles)
    known = {"centres": ("d", (frames, spheres, 3)), "states": ("B", (frames, spheres)),
             "speeds": ("f", (frames, spheres)), "contacts": ("I", (frames, spheres)),
             "polygons": ("B", (frames, triangles)),
             "times": ("d", (frames,)), "steps": ("q", (frames,)), "frames": ("q", (frames,)),
             "radii": ("d", (spheres,)), "groups": ("I", (spheres,)), "sets": ("I", (spheres,)),
             "vertices": ("d", (len(oracle.vertices), 3)), "triangles": ("I", (triangles, 3))}
    for name, (kind, shape) in known.items():
        oracle.equal(f"type and shape of {name}", (arrays[name].typecode, shapes[name]), (kind, shape))
    absent = {"states": 255, "speeds": 0, "contacts": 0}
    for name, shape in shapes.items():
        if name not in known:
            oracle.equal(f"shape of {name}", shape in [(frames, spheres), (spheres,)], True)
    for k, frame in enumerate(oracle.frames):
        count, start = len(frame["ids"]), k * spheres
        of_frame = {name: arrays[name][start:start + spheres] for name in arrays
                    if shapes[name] == (frames, spheres)}
        oracle.frame("npz", k, {name: values[:count] for name, values in of_frame.items()})
        for name, value in absent.items():
            oracle.same(f"{name} of spheres not there yet", of_frame[name][count:], [value] * (spheres - count))
        oracle.frame("npz", k, {"centres": arrays["centres"][3 * start:3 * (start + count)]})
        rest = arrays["centres"][3 * (start + count):3 * (start + spheres)]
        oracle.same("not there yet", sum(x != x for x in rest), len(rest))
        oracle.same("polygons", arrays["polygons"][k * triangles:(k + 1) * triangles], frame["polygons"])
    oracle.frame("npz", -1, {name: arrays[name] for name in arrays if shapes[name] == (spheres,)})
    for name, column in (("times", "time"), ("steps", "step"), ("frames", "number")):
        oracle.same(name, arrays[name], [frame[column] for frame in oracle.frames])
    oracle.same("vertices", arrays["vertices"], oracle.vertices)
    oracle.same("triangles", arrays["triangles"], oracle.triangles)


READERS = {"csv": read_csv, "xyz": read_xyz, "lammps-dump": read_dump,
           "vtp": read_vtp, "npz": read_npz, "glb": read_glb,
           "glb-instanced": read_instanced}

if __name__ == "__main__":
    run = Oracle(sys.argv[1])
    READERS[sys.argv[2]](run)
    run.finish()
